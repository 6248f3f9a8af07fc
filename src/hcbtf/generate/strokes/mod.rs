//! Strokes that stand on the tile, drawn for every eye and every light: nearer ones hide those behind, all cast shadows.
//!
//! What is drawn lies on the tile as the lookup will show it, so a stroke is not drawn as it looks but where it is seen: a point
//! at height h over q is seen from the view v at q - h v_t / v_n, where v_t is what v has along the surface and v_n along the
//! normal, and its shadow falls the same way along the light. Looked at from where it was drawn for, the tile then shows the
//! strokes in space. Toward the horizon v_t / v_n is held at four (`seen::MAX_SLOPE`).
//!
//! `scatter` places the strokes once, from the seed alone; `seen` finds those that are there in a light and turns and lights
//! them; `canvas` keeps what is in front at sixteen places of each texel, whose mean is the texel.

mod canvas;
mod scatter;
mod seen;

use std::sync::{Arc, OnceLock};

use glam::{Vec2, Vec3};

use self::canvas::{Canvas, GROUND, Hit};
use self::scatter::Stroke;
use self::seen::{Rays, Seen, draw, seen, slope};
use super::Color;
use crate::document::{Address, Grid, Strokes};
use crate::hcbtf::Progress;

/// Places along a side of a texel.
const CELLS: usize = 4;
/// At most so many cells are drawn at once; a larger tile is drawn some rows at a time.
const MAX_CELLS: usize = 1 << 20;
/// Cells of a map of shadows along a side of a texel, and along its longer side at most.
const SHADOW_CELLS: usize = 2;
const MAX_SHADOW_SIDE: usize = 1024;
/// All maps of shadows that are kept, in bytes; where they would take more each is drawn anew.
const MAX_KEPT: usize = 64 << 20;
/// A point is in the shadow of what is higher by more than this, in widths of the tile.
const BIAS: f32 = 2e-3;

/// Ready to give tiles.
pub(in crate::hcbtf) struct Ready {
    grid: Grid,
    is_tiling: bool,
    strokes: Strokes,
    all: Vec<Stroke>,
    /// How high the highest reaches, in widths of the tile.
    tallest: f32,
    /// A map for each light, where they are kept.
    shadows: Vec<OnceLock<Arc<Shadows>>>,
    /// For each place of a texel, where in a round it looks for shadows.
    jitter: Vec<Vec2>,
}

/// What stands highest between the light and each place of the tile.
struct Shadows {
    canvas: Canvas,
    /// Cells to a width of the tile.
    scale: f32,
}

impl Ready {
    /// Places the strokes; `None` where it is stopped.
    pub(super) fn new(strokes: &Strokes, grid: &Grid, is_tiling: bool, progress: &Progress) -> Option<Self> {
        // What was not checked is not drawn.
        let strokes = if strokes.check().is_ok() { strokes.clone() } else { Strokes::default() };
        let height = grid.size[1] as f32 / grid.size[0] as f32;
        let all = scatter::strokes(&strokes, height, is_tiling, progress)?;
        let tallest = all.iter().map(Stroke::top).fold(0.0, f32::max);
        // Strokes that turn with the eye have other shadows for each view.
        let turns = strokes.bundles.iter().any(|bundle| bundle.turns != 0.0);
        let [wide, high] = shadow_size(grid);
        let lights = grid.light.distinct_count() as usize;
        let is_kept = !turns && lights.saturating_mul(wide * high * size_of::<Hit>()) <= MAX_KEPT;
        let shadows = (0..if is_kept { lights } else { 0 }).map(|_| OnceLock::new()).collect();
        let count = (CELLS * CELLS) as f32;
        // Vogel's spiral: even in a round.
        let spiral = |k: usize| {
            let (sin, cos) = (2.399_963_2 * k as f32).sin_cos();
            Vec2::new(sin, cos) * ((k as f32 + 0.5) / count).sqrt()
        };
        let jitter = (0..CELLS * CELLS).map(spiral).collect();
        Some(Self { grid: *grid, is_tiling, strokes, all, tallest, shadows, jitter })
    }

    /// The texels of a sample; `None` where it is stopped.
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
        let size = [width * CELLS, height * CELLS];
        let at_once = (MAX_CELLS / (size[0] * CELLS)).max(1);
        let light = Light { of: self, rays, there: &there, shadows: shadows.as_deref() };
        let mut texels = Vec::with_capacity(width * height);
        for first in (0..height).step_by(at_once) {
            let rows = first * CELLS..(first + at_once).min(height) * CELLS;
            let mut canvas = Canvas::new(size, self.is_tiling, rows.clone());
            let scale = size[0] as f32;
            let strokes = there.iter().flatten();
            draw(&mut canvas, strokes, slope(rays.view), scale, self.height(), true, progress)?;
            for y in rows.step_by(CELLS) {
                if progress.is_stopped() {
                    return None;
                }
                texels.extend((0..width).map(|x| light.texel(&canvas, x, y)));
            }
        }
        Some(texels)
    }

    /// The height of the tile in its widths.
    fn height(&self) -> f32 {
        self.grid.size[1] as f32 / self.grid.size[0] as f32
    }

    /// The shadows in a light, where there are any; `None` where it is stopped.
    #[expect(clippy::option_option, reason = "the outer is whether it was stopped, as everywhere here")]
    fn shadows(&self, address: Address, rays: Rays, progress: &Progress) -> Option<Option<Arc<Shadows>>> {
        if self.strokes.shadow.amount <= 0.0 || self.tallest <= BIAS {
            return Some(None);
        }
        let kept = self.shadows.get(self.grid.light.index(address.light) as usize);
        if let Some(known) = kept.and_then(OnceLock::get) {
            return Some(Some(known.clone()));
        }
        let size = shadow_size(&self.grid);
        let mut canvas = Canvas::new(size, self.is_tiling, 0..size[1]);
        let scale = size[0] as f32;
        // As the light sees them: a thread is as wide from there.
        let from_light = Rays { view: rays.light, ..rays };
        let lit = seen(&self.strokes, &self.all, from_light);
        let casting = lit.iter().flatten().filter(|seen| seen.stroke.top() > BIAS);
        draw(&mut canvas, casting, slope(rays.light), scale, self.height(), false, progress)?;
        let made = Arc::new(Shadows { canvas, scale });
        if let Some(kept) = kept {
            // Another thread may have been first; its map is the same.
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

/// How what is seen is lit.
struct Light<'a> {
    of: &'a Ready,
    rays: Rays,
    there: &'a [Option<Seen<'a>>],
    shadows: Option<&'a Shadows>,
}

impl Light<'_> {
    /// The mean over the places of a texel; `y` is its first row of cells.
    fn texel(&self, canvas: &Canvas, x: usize, y: usize) -> Color {
        let mut sum = [0.0; 4];
        for down in 0..CELLS {
            let row = canvas.row(y + down);
            for across in 0..CELLS {
                let cell = [x * CELLS + across, y + down];
                let (color, alpha) = self.color(&row[cell[0]], cell, self.of.jitter[down * CELLS + across]);
                sum = [sum[0] + color.x * alpha, sum[1] + color.y * alpha, sum[2] + color.z * alpha, sum[3] + alpha];
            }
        }
        let count = (CELLS * CELLS) as f32;
        if sum[3] > 0.0 {
            [sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3], sum[3] / count]
        } else {
            let [r, g, b, _] = self.of.strokes.ground.color.map(f32::from);
            [r, g, b, 0.0]
        }
    }

    /// What is seen at a cell, lit: straight RGB from 0 to 255, and alpha.
    fn color(&self, hit: &Hit, cell: [usize; 2], jitter: Vec2) -> (Vec3, f32) {
        let reach = 1.0 - self.of.strokes.shadow.amount as f32 * self.shadow(hit, cell, jitter);
        let seen = (hit.stroke != GROUND).then(|| self.there.get(hit.stroke as usize)?.as_ref()).flatten();
        let (color, alpha) = match seen {
            None => {
                let ground = &self.of.strokes.ground;
                let [r, g, b, alpha] = ground.color.map(f32::from);
                let light = ground.ambient as f32 + ground.diffuse as f32 * self.rays.light.z.max(0.0) * reach;
                (Vec3::new(r, g, b) * light, alpha)
            }
            Some(seen) => {
                let node = seen.node(hit.along);
                let round = (1.0 - hit.across * hit.across).max(0.0).sqrt();
                let is_flat = node.aside == 0.0;
                let toward = if is_flat { node.facing } else { round * node.facing + hit.across * node.aside };
                let bundle = seen.bundle;
                let shone = bundle.diffuse as f32 * toward.max(0.0) + bundle.translucent as f32 * (-toward).max(0.0);
                let highlight = Vec3::from(bundle.highlight.color.map(f32::from));
                let highlight = highlight * (bundle.highlight.amount as f32 * node.shine * reach);
                (seen.color(hit.along) * (bundle.ambient as f32 + shone * reach) + highlight, 255.0)
            }
        };
        (color.clamp(Vec3::ZERO, Vec3::splat(255.0)), alpha)
    }

    /// 1 where something stands between the light and what is seen at a cell, else 0.
    fn shadow(&self, hit: &Hit, cell: [usize; 2], jitter: Vec2) -> f32 {
        let Some(shadows) = self.shadows else { return 0.0 };
        let height = hit.height.max(0.0);
        let cells = self.of.grid.size[0] as f32 * CELLS as f32;
        // Where it is seen, where it stands, and where the light through it meets the ground.
        let on_tile = Vec2::new(cell[0] as f32 + 0.5, cell[1] as f32 + 0.5) / cells;
        let seen_at = Vec2::new(on_tile.x, self.of.height() - on_tile.y);
        let ground = seen_at + height * (slope(self.rays.view) - slope(self.rays.light));
        let blur = self.of.strokes.shadow.softness as f32 * (self.of.tallest - height).max(0.0);
        let ground = ground + jitter * blur;
        let above = shadows.canvas.at(Vec2::new(ground.x, self.of.height() - ground.y) * shadows.scale);
        f32::from(u8::from(above.stroke != hit.stroke && above.height > height + BIAS))
    }
}

#[cfg(test)]
mod tests;
