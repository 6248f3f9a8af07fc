//! Canvas of the strokes in front, at many places of the tile: a buffer of heights.
//!
//! All that is seen at a place of the tile lies on one ray, and a point that is nearer on the ray
//! is higher. So the height over the surface is the depth, for the eye as for the light. At equal
//! heights a stroke that is drawn later lies above.

use glam::Vec2;

/// Number for no stroke: the ground.
pub(super) const GROUND: u32 = u32::MAX;

/// The frontmost point at a place.
#[derive(Clone, Copy, Debug)]
pub(super) struct StrokeHit {
    /// Height over the surface; below 0 for the ground, which everything hides.
    pub(super) height: f32,
    /// Number of the stroke, or [`GROUND`].
    pub(super) stroke: u32,
    /// Position along the stroke, in points from its root.
    pub(super) along: f32,
    /// Position across the stroke, from -1 to 1.
    pub(super) across: f32,
}

const NOTHING: StrokeHit = StrokeHit { height: -1.0, stroke: GROUND, along: 0.0, across: 0.0 };

/// A corner of a triangle. Places are in cells from the upper left corner of the tile, and may lie
/// beyond the tile.
#[derive(Clone, Copy, Debug)]
pub(super) struct StrokeCorner {
    pub(super) at: Vec2,
    pub(super) height: f32,
    pub(super) along: f32,
    pub(super) across: f32,
}

/// The grain of paper, which decides the cells that a stroke leaves free.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grain {
    pub(super) amount: f32,
    pub(super) stroke: u32,
}

impl Grain {
    fn takes(self, x: usize, y: usize, across: f32) -> bool {
        if self.amount <= 0.0 {
            return true;
        }
        let noise = |x: usize, y: usize, of: u32| {
            let mut hash =
                (x as u32).wrapping_mul(0x9e37_79b1) ^ (y as u32).wrapping_mul(0x85eb_ca77) ^ of;
            hash = (hash ^ (hash >> 15)).wrapping_mul(0x2c1b_3c6d);
            hash = (hash ^ (hash >> 12)).wrapping_mul(0x297a_2d39);
            (hash ^ (hash >> 15)) as f32 / u32::MAX as f32
        };
        // The paper's own grain is coarser, and the same for all strokes.
        let paper = noise(x / 3, y / 3, 0);
        0.6 * paper + 0.4 * noise(x, y, self.stroke.wrapping_add(1))
            > self.amount * (0.8 + 0.4 * across * across)
    }
}

/// A range of rows of the cells of a tile.
pub(super) struct StrokeRaster {
    /// Number of cells of the whole tile, along x and y.
    size: [usize; 2],
    is_tiling: bool,
    /// Number of the first row; `hits` are all cells from there.
    first: usize,
    hits: Vec<StrokeHit>,
}

impl StrokeRaster {
    /// A canvas for the rows `rows` of a tile of `size` cells.
    pub(super) fn new(size: [usize; 2], is_tiling: bool, rows: std::ops::Range<usize>) -> Self {
        Self { size, is_tiling, first: rows.start, hits: vec![NOTHING; size[0] * rows.len()] }
    }

    /// The frontmost points of a row.
    pub(super) fn row(&self, y: usize) -> &[StrokeHit] {
        let from = (y - self.first) * self.size[0];
        &self.hits[from..from + self.size[0]]
    }

    /// The frontmost point at a place, in cells; beyond the edge of a tile that does not repeat
    /// there is no stroke.
    pub(super) fn at(&self, place: Vec2) -> StrokeHit {
        let [width, height] = self.size.map(|side| side as i64);
        let (x, y) = (place.x.floor() as i64, place.y.floor() as i64);
        let is_inside = (0..width).contains(&x) && (0..height).contains(&y);
        if !(self.is_tiling || is_inside) {
            return NOTHING;
        }
        self.hits[(y.rem_euclid(height) * width + x.rem_euclid(width)) as usize
            - self.first * self.size[0]]
    }

    /// Draws a triangle of a stroke.
    pub(super) fn triangle(&mut self, corners: [StrokeCorner; 3], stroke: u32, grain: Grain) {
        let [a, b, c] = corners;
        let area = (b.at - a.at).perp_dot(c.at - a.at);
        let top = a.at.y.min(b.at.y).min(c.at.y);
        let bottom = a.at.y.max(b.at.y).max(c.at.y);
        if area.abs() < 1e-9 || !area.is_finite() || !(bottom - top).is_finite() {
            return;
        }
        // Each attribute is a plane over the cells.
        let slope = |of: fn(&StrokeCorner) -> f32| {
            let (first, second) = (of(&b) - of(&a), of(&c) - of(&a));
            let (to_b, to_c) = (b.at - a.at, c.at - a.at);
            let dx = (first * to_c.y - second * to_b.y) / area;
            let dy = (second * to_b.x - first * to_c.x) / area;
            (of(&a), Vec2::new(dx, dy))
        };
        let planes = [
            slope(|corner| corner.height),
            slope(|corner| corner.along),
            slope(|corner| corner.across),
        ];
        for y in (top - 0.5).ceil() as i64..(bottom - 0.5).ceil() as i64 {
            let middle = y as f32 + 0.5;
            let (mut left, mut right) = (f32::INFINITY, f32::NEG_INFINITY);
            for (from, to) in [(a.at, b.at), (b.at, c.at), (c.at, a.at)] {
                if (from.y <= middle) != (to.y <= middle) {
                    let x = from.x + (to.x - from.x) * (middle - from.y) / (to.y - from.y);
                    (left, right) = (left.min(x), right.max(x));
                }
            }
            self.span(y, left, right, stroke, grain, |x| {
                let from = Vec2::new(x, middle) - a.at;
                planes.map(|(start, slope)| start + slope.dot(from))
            });
        }
    }

    /// Draws a disc: `along` goes from 0 in its middle to 1 at its rim.
    pub(super) fn disc(&mut self, middle: StrokeCorner, radius: f32, stroke: u32, grain: Grain) {
        let center = middle.at;
        if !(radius > 0.0 && center.is_finite()) {
            return;
        }
        for y in (center.y - radius - 0.5).ceil() as i64..(center.y + radius - 0.5).ceil() as i64 {
            let off = y as f32 + 0.5 - center.y;
            let half = (radius * radius - off * off).max(0.0).sqrt();
            self.span(y, center.x - half, center.x + half, stroke, grain, |x| {
                [middle.height, ((x - center.x).hypot(off) / radius).min(1.0), 0.0]
            });
        }
    }

    /// Draws one row between two places. `values` gives height, along and across.
    fn span(
        &mut self,
        y: i64,
        left: f32,
        right: f32,
        stroke: u32,
        grain: Grain,
        values: impl Fn(f32) -> [f32; 3],
    ) {
        let [width, height] = self.size;
        let row = if self.is_tiling { y.rem_euclid(height as i64) } else { y };
        let rows = self.hits.len() / width;
        let Some(row) = usize::try_from(row).ok().and_then(|row| row.checked_sub(self.first))
        else {
            return;
        };
        if row >= rows || left > right {
            return;
        }
        let (mut from, mut to) = ((left - 0.5).ceil() as i64, (right - 0.5).ceil() as i64);
        if !self.is_tiling {
            (from, to) = (from.max(0), to.min(width as i64));
        }
        let mut column = from.rem_euclid(width as i64) as usize;
        for x in from..to {
            let [height, along, across] = values(x as f32 + 0.5);
            let hit = &mut self.hits[row * width + column];
            if height >= hit.height && grain.takes(column, row + self.first, across) {
                *hit = StrokeHit { height, stroke, along, across };
            }
            column = if column + 1 == width { 0 } else { column + 1 };
        }
    }
}
