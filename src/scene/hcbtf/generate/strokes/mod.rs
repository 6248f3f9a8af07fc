//! Strokes that stand on the tile, drawn for every eye and every light: nearer strokes hide those
//! behind, all cast shadows.
//!
//! Strokes are drawn on the tile as the lookup will show it, so a stroke is not drawn as it looks
//! but where it is seen: a point at height h over q is seen from the view v at q - h v_t / v_n,
//! where v_t is the part of v along the surface and v_n that along the normal, and its shadow falls
//! the same way along the light. Looked at from where it was drawn for, the tile then shows the
//! strokes in space. Toward the horizon v_t / v_n is held at four (`seen::MAX_SLOPE`).
//!
//! `scatter` places the strokes once, from the seed alone; `seen` finds those that exist in a light
//! and turns and lights them; `canvas` keeps the frontmost stroke at sixteen places of each texel,
//! whose mean is the texel.

mod canvas;
mod light;
mod scatter;
mod seen;

use std::ops::Range;
use std::sync::{Arc, OnceLock};

use glam::Vec2;

use self::canvas::{StrokeHit, StrokeRaster};
use self::light::{ShadowMap, StrokeLight};
use self::scatter::ScatteredStroke;
use self::seen::{Rays, VisibleStroke, draw, seen, slope};
use super::Color;
use crate::document::{Address, Grid, Strokes};
use crate::progress::Progress;

/// Number of places along a side of a texel.
const CELLS: usize = 4;
/// Greatest number of cells that are drawn at once; a larger tile is drawn some rows at a time.
const MAX_CELLS: usize = 1 << 20;
/// Number of cells of a shadow map along a side of a texel, and the greatest number along the map's
/// longer side.
const SHADOW_CELLS: usize = 2;
const MAX_SHADOW_SIDE: usize = 1024;
/// Greatest size of all shadow maps that are kept, and of the canvases of all views; where they
/// would take more, each is drawn anew. In bytes.
const MAX_KEPT: usize = 64 << 20;
/// Least difference in height by which a higher stroke casts a shadow on a point, in widths of the
/// tile.
const BIAS: f32 = 2e-3;

/// Strokes that are prepared and make tiles.
pub(in crate::hcbtf) struct PreparedStrokes {
    grid: Grid,
    is_tiling: bool,
    strokes: Strokes,
    all: Vec<ScatteredStroke>,
    /// Height of the highest stroke, in widths of the tile.
    tallest: f32,
    /// Shadow map of each light, if they are kept.
    shadows: Vec<OnceLock<Arc<ShadowMap>>>,
    /// Canvas of each view, if it is the same in all lights and kept.
    fronts: Vec<OnceLock<Arc<StrokeRaster>>>,
    /// Offset in a disc where each place of a texel looks for shadows.
    jitter: Vec<Vec2>,
}

impl PreparedStrokes {
    /// Places the strokes; `None` if the work is stopped.
    pub(super) fn new(
        strokes: &Strokes,
        grid: &Grid,
        is_tiling: bool,
        progress: &Progress,
    ) -> Option<Self> {
        // Strokes that fail the check are not drawn.
        let strokes = if strokes.check().is_ok() { strokes.clone() } else { Strokes::default() };
        let height = grid.size[1] as f32 / grid.size[0] as f32;
        let all = scatter::strokes(&strokes, height, is_tiling, progress)?;
        let tallest = all.iter().map(ScatteredStroke::top).fold(0.0, f32::max);
        // Strokes that turn with the eye have other shadows for each view.
        let turns = strokes.bundles.iter().any(|bundle| bundle.turns != 0.0);
        let [wide, high] = shadow_size(grid);
        let lights = grid.light.distinct_count() as usize;
        let is_kept =
            !turns && lights.saturating_mul(wide * high * size_of::<StrokeHit>()) <= MAX_KEPT;
        let shadows = (0..if is_kept { lights } else { 0 }).map(|_| OnceLock::new()).collect();
        let has_tones = strokes.bundles.iter().any(|bundle| bundle.tones.is_some());
        let (views, cells) = (grid.view.distinct_count() as usize, grid.texels() * CELLS * CELLS);
        let fits =
            cells <= MAX_CELLS && views.saturating_mul(cells * size_of::<StrokeHit>()) <= MAX_KEPT;
        let fronts =
            (0..if fits && !has_tones { views } else { 0 }).map(|_| OnceLock::new()).collect();
        let count = (CELLS * CELLS) as f32;
        // Vogel's spiral is even in a disc.
        let spiral = |k: usize| {
            let (sin, cos) = (2.399_963_2 * k as f32).sin_cos();
            Vec2::new(sin, cos) * ((k as f32 + 0.5) / count).sqrt()
        };
        let jitter = (0..CELLS * CELLS).map(spiral).collect();
        Some(Self { grid: *grid, is_tiling, strokes, all, tallest, shadows, fronts, jitter })
    }

    /// The texels of a sample; `None` if the work is stopped.
    pub(super) fn tile(&self, address: Address, progress: &Progress) -> Option<Vec<Color>> {
        let address = address.canonical();
        let rays = Rays {
            view: self.grid.view.vector(address.view).as_vec3(),
            light: self.grid.light.vector(address.light).as_vec3(),
            around: f64::from(address.view.phi) / f64::from(self.grid.view.phi.max(1)),
        };
        let there = seen(&self.strokes, &self.all, rays);
        let shadows = self.shadows(address, rays, progress)?;
        let [width, height] = self.grid.size.map(|side| side as usize);
        let at_once = (MAX_CELLS / (width * CELLS * CELLS)).max(1);
        let light = StrokeLight::new(self, rays, &there, shadows.as_deref());
        let mut texels = Vec::with_capacity(width * height);
        for first in (0..height).step_by(at_once) {
            let rows = first * CELLS..(first + at_once).min(height) * CELLS;
            let canvas = self.front(address, rays, &there, rows.clone(), progress)?;
            for y in rows.step_by(CELLS) {
                if progress.is_stopped() {
                    return None;
                }
                texels.extend((0..width).map(|x| light.texel(&canvas, x, y)));
            }
        }
        Some(texels)
    }

    /// The canvas of some rows as an eye sees it; `None` if the work is stopped.
    fn front(
        &self,
        address: Address,
        rays: Rays,
        there: &[Option<VisibleStroke<'_>>],
        rows: Range<usize>,
        progress: &Progress,
    ) -> Option<Arc<StrokeRaster>> {
        let kept = self.fronts.get(self.grid.view.index(address.view) as usize);
        if let Some(known) = kept.and_then(OnceLock::get) {
            return Some(known.clone());
        }
        let size = self.grid.size.map(|side| side as usize * CELLS);
        let mut canvas = StrokeRaster::new(size, self.is_tiling, rows);
        let strokes = there.iter().flatten();
        draw(
            &mut canvas,
            strokes,
            slope(rays.view),
            size[0] as f32,
            self.height(),
            true,
            progress,
        )?;
        let canvas = Arc::new(canvas);
        if let Some(kept) = kept {
            // Another thread may have been first; its canvas is the same.
            let _ = kept.set(canvas.clone());
        }
        Some(canvas)
    }

    /// The height of the tile, in tile widths.
    fn height(&self) -> f32 {
        self.grid.size[1] as f32 / self.grid.size[0] as f32
    }

    /// The shadow map of a light, if strokes cast shadows; `None` if the work is stopped.
    #[expect(
        clippy::option_option,
        reason = "the outer is whether it was stopped, as everywhere here"
    )]
    fn shadows(
        &self,
        address: Address,
        rays: Rays,
        progress: &Progress,
    ) -> Option<Option<Arc<ShadowMap>>> {
        if self.strokes.shadow.amount <= 0.0 || self.tallest <= BIAS {
            return Some(None);
        }
        let kept = self.shadows.get(self.grid.light.index(address.light) as usize);
        if let Some(known) = kept.and_then(OnceLock::get) {
            return Some(Some(known.clone()));
        }
        let size = shadow_size(&self.grid);
        let mut canvas = StrokeRaster::new(size, self.is_tiling, 0..size[1]);
        let scale = size[0] as f32;
        // Strokes are turned as the light sees them: a thread is as wide from there.
        let from_light = Rays { view: rays.light, ..rays };
        let lit = seen(&self.strokes, &self.all, from_light);
        let casting = lit.iter().flatten().filter(|seen| seen.stroke.top() > BIAS);
        draw(&mut canvas, casting, slope(rays.light), scale, self.height(), false, progress)?;
        let made = Arc::new(ShadowMap { canvas, scale });
        if let Some(kept) = kept {
            let _ = kept.set(made.clone());
        }
        Some(Some(made))
    }
}

fn shadow_size(grid: &Grid) -> [usize; 2] {
    let [width, height] = grid.size.map(|side| side as usize * SHADOW_CELLS);
    let longer = width.max(height).max(MAX_SHADOW_SIDE);
    [width, height].map(|side| (side * MAX_SHADOW_SIDE / longer).max(1))
}

#[cfg(test)]
mod tests;
