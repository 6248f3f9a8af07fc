//! The height field: a grid of cells finer than the texels, with a height at every corner and a
//! color in every cell.
//!
//! Between corners the surface goes on bilinearly, so a step is a steep cell, seen, lit and shaded
//! as any other. Texels are divided into several cells each so that the mean color in them is
//! smooth at edges. Eye rays and light are followed from grid line to grid line: where a line is
//! crossed the surface's height is exact.

use rayon::iter::{IntoParallelIterator as _, ParallelIterator as _};

use super::pattern::{CellMaterial, PatternSampler};
use crate::document::Relief;
use crate::progress::Progress;

/// Number of cells along a side of the tile that is aimed at.
const AIM: u32 = 128;
/// Greatest number of cells along a texel's side.
const MOST_CELLS: u32 = 4;
/// Greatest side of tiles whose texels are divided into two cells at least, in texels.
const SMALL_SIDE: u32 = 160;

/// A height field that repeats with the tile. Lengths are in cells, x to the right, y down, z out
/// of the tile.
pub(super) struct HeightField {
    /// Number of cells along x and y.
    pub(super) size: [usize; 2],
    /// Number of cells along a texel's side.
    pub(super) per_texel: usize,
    /// Heights at the upper left corners of the cells.
    heights: Vec<f32>,
    /// Slopes along x and y in the middles of the cells.
    pub(super) slopes: Vec<[f32; 2]>,
    /// Materials of the cells.
    pub(super) materials: Vec<CellMaterial>,
    /// Height of the highest corner.
    pub(super) top: f32,
    /// Difference between the highest and the lowest corner.
    pub(super) range: f32,
}

/// A point where a ray crosses a line of the grid.
#[derive(Clone, Copy)]
pub(super) struct Crossing {
    /// Distance from the ray's beginning, along the tile.
    pub(super) distance: f32,
    /// Height of the surface there.
    pub(super) height: f32,
    /// Cell that the ray passed through to get there.
    pub(super) cell: usize,
}

impl HeightField {
    /// The field of a relief; `None` if the work is stopped.
    pub(super) fn new(
        relief: &Relief,
        tile: [u32; 2],
        sampler: &PatternSampler<'_>,
        progress: &Progress,
    ) -> Option<Self> {
        let side = tile[0].max(tile[1]);
        let per_texel =
            AIM.div_ceil(side).clamp(if side <= SMALL_SIDE { 2 } else { 1 }, MOST_CELLS);
        let size = tile.map(|side| (side * per_texel) as usize);
        let [width, height] = size;
        let scale = relief.depth as f32 * width as f32;
        let place = |x: f32, y: f32| [x / width as f32, y / height as f32];
        let row = |y: usize| -> Option<Vec<(f32, CellMaterial)>> {
            let cell = |x: usize| {
                let (corner, middle) =
                    (place(x as f32, y as f32), place(x as f32 + 0.5, y as f32 + 0.5));
                (sampler.height(corner) * scale, sampler.material(middle))
            };
            if progress.is_stopped() {
                return None;
            }
            let row = (0..width).map(cell).collect();
            // Several rows of cells are one row of texels.
            if (y as u32).is_multiple_of(per_texel) {
                progress.add(super::FIELD_TILES);
            }
            Some(row)
        };
        let rows: Vec<Vec<(f32, CellMaterial)>> =
            (0..height).into_par_iter().map(row).collect::<Option<_>>()?;
        let (heights, materials) = rows.into_iter().flatten().unzip();
        Some(Self::of(size, per_texel as usize, heights, materials))
    }

    /// The field with these heights at the corners, row by row.
    pub(super) fn of(
        size: [usize; 2],
        per_texel: usize,
        heights: Vec<f32>,
        materials: Vec<CellMaterial>,
    ) -> Self {
        let top = heights.iter().copied().fold(0.0_f32, f32::max);
        let lowest = heights.iter().copied().fold(top, f32::min);
        let mut field = Self {
            size,
            per_texel,
            heights,
            slopes: Vec::new(),
            materials,
            top,
            range: (top - lowest).max(0.0),
        };
        field.slopes = (0..size[0] * size[1]).map(|cell| field.slope(cell)).collect();
        field
    }

    fn corners(&self, cell: usize) -> [f32; 4] {
        let [width, height] = self.size;
        let (x, y) = (cell % width, cell / width);
        let (right, below) = ((x + 1) % width, (y + 1) % height);
        [(x, y), (right, y), (x, below), (right, below)].map(|(x, y)| self.heights[y * width + x])
    }

    fn slope(&self, cell: usize) -> [f32; 2] {
        let [a, b, c, d] = self.corners(cell);
        [0.5 * (b + d - a - c), 0.5 * (c + d - a - b)]
    }

    /// The point in the middle of a cell, on the surface.
    pub(super) fn middle(&self, cell: usize) -> [f32; 3] {
        let width = self.size[0];
        let height = 0.25 * self.corners(cell).iter().sum::<f32>();
        [(cell % width) as f32 + 0.5, (cell / width) as f32 + 0.5, height]
    }

    /// The difference in height between the highest and the lowest corner of a cell.
    pub(super) fn steepness(&self, cell: usize) -> f32 {
        let corners = self.corners(cell);
        corners.iter().copied().fold(f32::MIN, f32::max)
            - corners.iter().copied().fold(f32::MAX, f32::min)
    }

    /// The unit normal in the middle of a cell.
    pub(super) fn normal(&self, cell: usize) -> [f32; 3] {
        let [x, y] = self.slopes[cell];
        let length = (x * x + y * y + 1.0).sqrt();
        [-x / length, -y / length, 1.0 / length]
    }

    /// The cell at a position.
    pub(super) fn cell(&self, x: f32, y: f32) -> usize {
        let [width, height] = self.size;
        let wrapped = |at: f32, side: usize| (at.floor() as i64).rem_euclid(side as i64) as usize;
        wrapped(y, height) * width + wrapped(x, width)
    }

    /// The height of the surface at a position.
    pub(super) fn height(&self, x: f32, y: f32) -> f32 {
        let [a, b, c, d] = self.corners(self.cell(x, y));
        let (fx, fy) = (x - x.floor(), y - y.floor());
        let (above, below) = (a + (b - a) * fx, c + (d - c) * fx);
        above + (below - above) * fy
    }

    /// Follows a line along the tile from a position in a direction of length 1, and passes every
    /// crossing with a line of the grid to `visit`, until that returns false, or beyond `most`.
    pub(super) fn follow(
        &self,
        from: [f32; 2],
        direction: [f32; 2],
        most: f32,
        mut visit: impl FnMut(Crossing) -> bool,
    ) {
        let [width, height] = self.size;
        let (mut x, mut y) = (from[0].floor() as i64, from[1].floor() as i64);
        let first = |at: f32, along: f32| match along {
            _ if along > 0.0 => (at.floor() + 1.0 - at) / along,
            _ if along < 0.0 => (at - at.floor()) / -along,
            _ => f32::INFINITY,
        };
        let [dx, dy] = direction;
        let (mut to_x, mut to_y) = (first(from[0], dx), first(from[1], dy));
        let (step_x, step_y) = (1.0 / dx.abs(), 1.0 / dy.abs());
        let wrapped = |at: i64, side: usize| at.rem_euclid(side as i64) as usize;
        loop {
            let distance = to_x.min(to_y);
            if distance > most || !distance.is_finite() {
                return;
            }
            let (column, row) = (wrapped(x, width), wrapped(y, height));
            let cell = row * width + column;
            let at = if to_x <= to_y {
                let line = if dx > 0.0 { (column + 1) % width } else { column };
                let f = (from[1] + distance * dy - y as f32).clamp(0.0, 1.0);
                let below = (row + 1) % height;
                (x, to_x) = (x + if dx > 0.0 { 1 } else { -1 }, to_x + step_x);
                (self.heights[row * width + line], self.heights[below * width + line], f)
            } else {
                let line = if dy > 0.0 { (row + 1) % height } else { row };
                let f = (from[0] + distance * dx - x as f32).clamp(0.0, 1.0);
                let right = (column + 1) % width;
                (y, to_y) = (y + if dy > 0.0 { 1 } else { -1 }, to_y + step_y);
                (self.heights[line * width + column], self.heights[line * width + right], f)
            };
            let height = at.0 + (at.1 - at.0) * at.2;
            if distance > 0.0 && !visit(Crossing { distance, height, cell }) {
                return;
            }
        }
    }

    /// The slope of the horizon above a point in a direction of length 1: the greatest slope to the
    /// surface there, and not less than `least`. The search ends where the surface could not rise
    /// above `enough`.
    pub(super) fn horizon(
        &self,
        from: [f32; 3],
        direction: [f32; 2],
        least: f32,
        enough: f32,
    ) -> f32 {
        let mut slope = least;
        let above = self.top - from[2];
        self.follow([from[0], from[1]], direction, self.farthest(), |crossing| {
            slope = slope.max((crossing.height - from[2]) / crossing.distance);
            slope < enough.max(least) && above > slope * crossing.distance
        });
        slope
    }

    /// Greatest distance that rays are followed: twice around the tile.
    pub(super) fn farthest(&self) -> f32 {
        2.0 * (self.size[0] + self.size[1]) as f32
    }
}
