//! Coverage of samples by triangles: the top-left rule, in integers.
//!
//! Every edge is a function that is linear on the grid, at least 0 inside. The functions of edges
//! that are neither left nor top ones are reduced by 1, so that points exactly on such an edge are
//! outside. Coordinates are below 2^60 steps, so that all values fit 128 bits, and nothing is ever
//! rounded.

use super::setup::Triangle;

/// Positions of a pixel's samples, from its upper left corner, in sixteenths of a pixel.
pub(super) fn sample_positions(samples: u32) -> &'static [[i64; 2]] {
    // The standard positions of Direct3D and Vulkan.
    if samples == 4 { &[[6, 2], [14, 6], [2, 10], [10, 14]] } else { &[[8, 8]] }
}

/// The bit of a sample in a quad's coverage.
pub(super) fn bit(lane: usize, sample: usize) -> u16 {
    1 << (4 * lane + sample)
}

/// A rectangle of pixels; the end is exclusive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Pixels {
    pub(super) begin: [u32; 2],
    pub(super) end: [u32; 2],
}

impl Pixels {
    /// The intersection with the rectangle from pixel `least` to pixel `most`; `None` if empty.
    pub(super) fn and(self, least: [i64; 2], most: [i64; 2]) -> Option<Self> {
        let begin = [0, 1].map(|i| least[i].clamp(self.begin[i].into(), self.end[i].into()) as u32);
        let end =
            [0, 1].map(|i| (most[i] + 1).clamp(self.begin[i].into(), self.end[i].into()) as u32);
        (begin[0] < end[0] && begin[1] < end[1]).then_some(Self { begin, end })
    }
}

/// Function of an edge: `x` and `y` are its increments from pixel to pixel.
#[derive(Clone, Copy, Debug, Default)]
struct EdgeFunction {
    x: i128,
    y: i128,
    /// Value at the upper left corner of pixel (0, 0).
    origin: i128,
    /// Increments for each sample of each lane of a quad.
    offsets: [i128; 16],
    /// The least and the greatest of the offsets.
    least: i128,
    most: i128,
}

/// The three edges of a triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edges {
    edges: [EdgeFunction; 3],
    /// Bits of all samples of a quad.
    full: u16,
    samples: usize,
}

impl Edges {
    /// The edges of `triangle`, on a grid of 2 to `bits` steps a pixel.
    pub(super) fn new(triangle: &Triangle, bits: u32, samples: u32) -> Self {
        let positions = sample_positions(samples);
        let mut full = 0;
        for lane in 0..4 {
            (0..positions.len()).for_each(|sample| full |= bit(lane, sample));
        }
        let [a, b, c] = triangle.corners.map(|corner| corner.at);
        let edges =
            [[a, b], [b, c], [c, a]].map(|[from, to]| EdgeFunction::new(from, to, bits, positions));
        Self { edges, full, samples: positions.len() }
    }

    /// Calls `visit` with the upper left pixel and the coverage of each quad that has any, row by
    /// row.
    ///
    /// # Errors
    /// Errors of `visit`.
    pub(super) fn quads<E>(
        &self,
        pixels: Pixels,
        mut visit: impl FnMut(u32, u32, u16) -> Result<(), E>,
    ) -> Result<(), E> {
        let [left, top] = pixels.begin.map(|begin| begin & !1);
        for y in (top..pixels.end[1]).step_by(2) {
            let mut values = self
                .edges
                .map(|edge| edge.origin + edge.x * i128::from(left) + edge.y * i128::from(y));
            let mut was_inside = false;
            for x in (left..pixels.end[0]).step_by(2) {
                match self.coverage(&values) & inside(x, y, pixels, self.samples) {
                    0 if was_inside && self.is_outside(&values) => break,
                    0 => {}
                    covered => {
                        was_inside = true;
                        visit(x, y, covered)?;
                    }
                }
                for (value, edge) in values.iter_mut().zip(&self.edges) {
                    *value += 2 * edge.x;
                }
            }
        }
        Ok(())
    }

    /// True if no sample of a quad is inside, by one edge alone.
    fn is_outside(&self, values: &[i128; 3]) -> bool {
        self.edges.iter().zip(values).any(|(edge, value)| value + edge.most < 0)
    }

    fn coverage(&self, values: &[i128; 3]) -> u16 {
        if self.is_outside(values) {
            return 0;
        }
        let mut covered = self.full;
        for (edge, value) in self.edges.iter().zip(values) {
            if value + edge.least >= 0 {
                continue;
            }
            for lane in 0..4 {
                for sample in 0..self.samples {
                    if value + edge.offsets[4 * lane + sample] < 0 {
                        covered &= !bit(lane, sample);
                    }
                }
            }
        }
        covered
    }
}

/// The samples of those pixels of a quad that lie in the rectangle.
fn inside(x: u32, y: u32, pixels: Pixels, samples: usize) -> u16 {
    if x >= pixels.begin[0]
        && y >= pixels.begin[1]
        && x + 2 <= pixels.end[0]
        && y + 2 <= pixels.end[1]
    {
        return u16::MAX;
    }
    let mut mask = 0;
    for lane in 0..4u32 {
        let at = [x + lane % 2, y + lane / 2];
        if (0..2).all(|i| (pixels.begin[i]..pixels.end[i]).contains(&at[i])) {
            (0..samples).for_each(|sample| mask |= bit(lane as usize, sample));
        }
    }
    mask
}

impl EdgeFunction {
    fn new(from: [i64; 2], to: [i64; 2], bits: u32, positions: &[[i64; 2]]) -> Self {
        let (dx, dy) = (i128::from(to[0] - from[0]), i128::from(to[1] - from[1]));
        // y points down: the inside of a clockwise triangle is below a top edge, which runs to the
        // right, and to the right of a left edge, which runs up.
        let is_top_left = dy < 0 || (dy == 0 && dx > 0);
        let at_zero = dy * i128::from(from[0]) - dx * i128::from(from[1]);
        let mut edge = Self {
            x: -dy << bits,
            y: dx << bits,
            origin: at_zero - i128::from(!is_top_left),
            ..Self::default()
        };
        for (sample, [x, y]) in positions.iter().enumerate() {
            let sixteenth = 1 << (bits - 4);
            let offset = dx * i128::from(y * sixteenth) - dy * i128::from(x * sixteenth);
            for lane in 0..4 {
                let pixel =
                    if lane % 2 == 1 { edge.x } else { 0 } + if lane / 2 == 1 { edge.y } else { 0 };
                edge.offsets[4 * lane + sample] = pixel + offset;
            }
        }
        let used = || (0..16).filter(|i| i % 4 < positions.len()).map(|i| edge.offsets[i]);
        (edge.least, edge.most) = (used().min().unwrap_or(0), used().max().unwrap_or(0));
        edge
    }
}
