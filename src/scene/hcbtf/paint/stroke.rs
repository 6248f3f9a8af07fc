//! A stroke of the brush.
//!
//! Painting and erasing keep two buffers: the tile before the stroke, and the stroke's coverage of
//! each texel. Stamps add to the coverage alone, each by the flow and none beyond the opacity, and
//! the tile is composed anew from both wherever stamps fell. So a stroke that crosses itself is no
//! darker there, and nothing is rounded twice. Coverage is kept in f64, so that the order of
//! mirrored stamps shows in no byte. Stamps of a picture keep their color beside the coverage.
//! Smudging works on the tile itself.

use std::fmt;

use glam::DVec2;

use super::blend::{erased, over};
use super::brush::{Brush, ClampedBrush, Symmetry, Tool};
use super::canvas::{ChangedBlocks, TileExtent};
use super::dab::Dab;
use super::path::Path;
use super::picture::PicturePyramid;
use super::smudge::Smudge;
use super::symmetry::{StrokeCopy, copies};
use crate::document::Tile;

/// A rectangle of texels that changed: `[x, y, width, height]`, inside the tile.
pub type ChangedRect = [u32; 4];

/// Greatest number of texels that are stamped from one position to the next; more stamps than that
/// lie farther apart.
const MOST_TEXELS: f64 = 1_073_741_824.0;
/// Greatest number of stamps from one position to the next, copies counted.
const MOST_STAMPS: f64 = 1_048_576.0;
/// Diameter below which no stamp is laid, in texels.
const SMALLEST: f64 = 1.0 / 256.0;

/// A stroke, from where the pen goes down to where it goes up.
#[derive(Clone)]
pub struct Stroke {
    before: Tile,
    tile: Tile,
    canvas: TileExtent,
    dirty: ChangedBlocks,
    path: Path,
    copies: Vec<StrokeCopy>,
    /// Brush of the stroke; `None` if it can paint nothing.
    brush: Option<ClampedBrush>,
    work: StrokeEffect,
}

/// State of a stroke, by its tool.
#[derive(Clone)]
enum StrokeEffect {
    /// Lays a color, 0 to 255, with at most the alpha `alpha`, where the stroke covers.
    Color {
        color: [f64; 3],
        alpha: f64,
        coverage: Vec<f64>,
    },
    /// Removes alpha where the stroke covers.
    Erase {
        coverage: Vec<f64>,
    },
    /// Lays a picture: `laid` are straight colors, 0 to 255, and their coverage, 0 to 1.
    Picture {
        picture: PicturePyramid,
        laid: Vec<[f32; 4]>,
    },
    Smudge(Smudge),
    Nothing,
}

impl fmt::Debug for Stroke {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Stroke({:?}, {} copies)", self.tile, self.copies.len())
    }
}

impl Stroke {
    /// Begins a stroke over a tile. Where `wraps` the tile repeats, and the stroke goes across its
    /// edges. A brush paints nothing if one of its numbers is not finite, if it is larger than
    /// [`Brush::MAX_SIZE`], or if it has so many texels with all copies that a stamp would take
    /// seconds (2^30, for smudging 2^24).
    pub fn begin(tile: &Tile, brush: &Brush, symmetry: &Symmetry, wraps: bool) -> Self {
        let size = tile.size().map(|side| side as usize);
        let texels = size[0] * size[1];
        let copies = copies(symmetry, tile.size());
        let settled = brush.settled();
        let work = settled.map(|settled| match &brush.tool {
            Tool::Paint => {
                let [red, green, blue, alpha] = brush.color.map(f64::from);
                StrokeEffect::Color {
                    color: [red, green, blue],
                    alpha: alpha / 255.0,
                    coverage: vec![0.0; texels],
                }
            }
            Tool::Erase => StrokeEffect::Erase { coverage: vec![0.0; texels] },
            Tool::Smudge => Smudge::new(tile, settled.size, copies.len())
                .map_or(StrokeEffect::Nothing, StrokeEffect::Smudge),
            Tool::Stamp(picture) => {
                // The smallest size that pressure can make the brush.
                let picture = PicturePyramid::new(picture, settled.size_at(0.0));
                StrokeEffect::Picture { picture, laid: vec![[0.0; 4]; texels] }
            }
        });
        let work = work.filter(|work| {
            let [width, height] = extent(work, settled.map_or(0.0, |settled| settled.size));
            height <= Brush::MAX_SIZE && width * height * copies.len() as f64 <= MOST_TEXELS
        });
        Self {
            before: tile.clone(),
            tile: tile.clone(),
            canvas: TileExtent { size, wraps },
            dirty: ChangedBlocks::new(size),
            path: Path::default(),
            copies,
            brush: settled,
            work: work.unwrap_or(StrokeEffect::Nothing),
        }
    }

    /// Continues the stroke to a position, in texels from the upper left corner, which may lie
    /// outside the tile, with a pressure between 0 and 1. Returns the parts that changed. Positions
    /// and pressures that are not finite, and positions more than 1,048,576 texels away, are
    /// ignored.
    ///
    /// One call lays at most 2^20 stamps of 2^30 texels together; on a longer way they lie farther
    /// apart. Otherwise it does not matter how a way is cut into calls.
    pub fn to(&mut self, at: DVec2, pressure: f64) -> Vec<ChangedRect> {
        let Some(brush) = self.brush else { return Vec::new() };
        let most = self.most_stamps(brush.size);
        let mut path = self.path;
        path.to(
            at,
            pressure,
            most,
            |pressure| brush.step_at(pressure),
            |at, pressure| self.lay(&brush, at, pressure),
        );
        self.path = path;
        let changed = self.dirty.take();
        for rectangle in &changed {
            self.compose(*rectangle);
        }
        changed
    }

    /// The tile with the stroke so far.
    pub fn tile(&self) -> &Tile {
        &self.tile
    }

    /// Ends the stroke and gives the tile.
    pub fn finish(self) -> Tile {
        self.tile
    }

    /// The greatest number of stamps that one call may lay, whatever the length of its way.
    fn most_stamps(&self, size: f64) -> f64 {
        let [width, height] = extent(&self.work, size);
        let copies = self.copies.len() as f64;
        let texels = if self.canvas.wraps {
            width * height
        } else {
            width.min(self.canvas.size[0] as f64) * height.min(self.canvas.size[1] as f64)
        };
        (MOST_TEXELS / (texels * copies)).min(MOST_STAMPS / copies).max(1.0)
    }

    /// Lays a stamp and its copies.
    fn lay(&mut self, brush: &ClampedBrush, at: DVec2, pressure: f64) {
        let (size, opacity) = (brush.size_at(pressure), brush.opacity_at(pressure));
        if size < SMALLEST
            || opacity <= 0.0
            || brush.flow <= 0.0 && !matches!(self.work, StrokeEffect::Smudge(_))
        {
            return;
        }
        // A single texel is chosen once: the copies of a position between two texels would choose
        // otherwise.
        let at = if size <= 1.0 { at.floor() + 0.5 } else { at };
        let Self { work, canvas, dirty, copies, tile, .. } = self;
        match work {
            StrokeEffect::Color { coverage, .. } | StrokeEffect::Erase { coverage } => {
                let places: Vec<DVec2> =
                    copies.iter().map(|copy| canvas.on_tile(copy.place(at))).collect();
                for (index, &place) in places.iter().enumerate() {
                    // On the axis of a mirror, two copies at one position are one stamp.
                    if !places[..index].contains(&place) {
                        cover(
                            coverage,
                            &Dab::new(place, size, brush.hardness),
                            opacity,
                            brush.flow,
                            *canvas,
                            dirty,
                        );
                    }
                }
            }
            StrokeEffect::Picture { picture, laid } => {
                let middle = picture.middle(at, size);
                for copy in copies.iter() {
                    let stamp = picture.laid(copy.place(middle), size, *copy);
                    lay_picture(laid, &stamp, opacity as f32, brush.flow as f32, *canvas, dirty);
                }
            }
            StrokeEffect::Smudge(smudge) => {
                let middle = at.floor() + 0.5;
                for (index, copy) in copies.iter().enumerate() {
                    smudge.lay(
                        (index, copy.place(middle)),
                        (brush, pressure),
                        *canvas,
                        tile,
                        dirty,
                    );
                }
            }
            StrokeEffect::Nothing => {}
        }
    }

    /// Composes a rectangle of the tile anew from the tile before the stroke and the stroke's
    /// buffers.
    fn compose(&mut self, [x, y, width, height]: ChangedRect) {
        let (before, _) = self.before.bytes().as_chunks::<4>();
        let (after, _) = self.tile.bytes_mut().as_chunks_mut::<4>();
        for row in y..y + height {
            let start = row as usize * self.canvas.size[0] + x as usize;
            let range = start..start + width as usize;
            let texels = after[range.clone()].iter_mut().zip(&before[range.clone()]);
            match &self.work {
                StrokeEffect::Color { color, alpha, coverage } => {
                    for ((after, before), cover) in
                        texels.zip(&coverage[range]).filter(|(_, cover)| **cover > 0.0)
                    {
                        *after = over(*before, *color, cover * alpha);
                    }
                }
                StrokeEffect::Erase { coverage } => {
                    for ((after, before), cover) in
                        texels.zip(&coverage[range]).filter(|(_, cover)| **cover > 0.0)
                    {
                        *after = erased(*before, *cover);
                    }
                }
                StrokeEffect::Picture { laid, .. } => {
                    for ((after, before), laid) in
                        texels.zip(&laid[range]).filter(|(_, laid)| laid[3] > 0.0)
                    {
                        let [red, green, blue, alpha] = laid.map(f64::from);
                        *after = over(*before, [red, green, blue], alpha);
                    }
                }
                StrokeEffect::Smudge(_) | StrokeEffect::Nothing => {}
            }
        }
    }
}

/// The greatest number of texels that a stamp meets, along its picture's width and height.
fn extent(work: &StrokeEffect, size: f64) -> [f64; 2] {
    let aspect =
        if let StrokeEffect::Picture { picture, .. } = work { picture.aspect() } else { 1.0 };
    [size + 2.0, size * aspect + 2.0]
}

/// Adds a stamp to the coverage: a share of the difference to the opacity.
fn cover(
    coverage: &mut [f64],
    dab: &Dab,
    opacity: f64,
    flow: f64,
    canvas: TileExtent,
    dirty: &mut ChangedBlocks,
) {
    for down in canvas.spans(1, dab.rows()) {
        canvas.spans(0, dab.columns()).for_each(|across| dirty.mark(across, down));
        for row in 0..down.count {
            let y = down.from + row as i64;
            for across in canvas.spans(0, dab.columns_at(y)) {
                let start = (down.start + row) * canvas.size[0] + across.start;
                for (column, covered) in
                    coverage[start..start + across.count].iter_mut().enumerate()
                {
                    let lacking = opacity - *covered;
                    if lacking > 0.0 {
                        *covered += flow * dab.cover(across.from + column as i64, y) * lacking;
                    }
                }
            }
        }
    }
}

/// Lays a picture over the stroke's earlier stamps.
fn lay_picture(
    laid: &mut [[f32; 4]],
    stamp: &super::picture::PlacedPicture<'_>,
    opacity: f32,
    flow: f32,
    canvas: TileExtent,
    dirty: &mut ChangedBlocks,
) {
    let [columns, rows] = stamp.ranges();
    for down in canvas.spans(1, rows) {
        for across in canvas.spans(0, columns) {
            dirty.mark(across, down);
            for row in 0..down.count {
                let start = (down.start + row) * canvas.size[0] + across.start;
                for (column, texel) in laid[start..start + across.count].iter_mut().enumerate() {
                    let color = stamp.color(across.from + column as i64, down.from + row as i64);
                    lay_texel(texel, color, opacity, flow);
                }
            }
        }
    }
}

/// Lays a color over a texel; `color` is premultiplied, 0 to 1.
fn lay_texel(texel: &mut [f32; 4], color: [f32; 4], opacity: f32, flow: f32) {
    let alpha = color[3];
    let added = alpha * flow;
    if added <= 0.0 {
        return;
    }
    let covered = (texel[3] / opacity).min(1.0);
    let weight = added / (added + covered * (1.0 - added));
    for (channel, value) in texel[..3].iter_mut().zip(color) {
        *channel += (value / alpha * 255.0 - *channel) * weight;
    }
    texel[3] += added * (opacity - texel[3]).max(0.0);
}

/// A tile with a straight stroke, between positions in texels from the upper left corner, at full
/// pressure.
pub fn line(
    tile: &Tile,
    brush: &Brush,
    symmetry: &Symmetry,
    wraps: bool,
    from: DVec2,
    to: DVec2,
) -> Tile {
    let mut stroke = Stroke::begin(tile, brush, symmetry, wraps);
    stroke.to(from, 1.0);
    stroke.to(to, 1.0);
    stroke.finish()
}
