//! Interpolation from the corners of a triangle to a point on it, or, for the helpers of a quad, on
//! its plane.

use super::setup::Triangle;

/// Weights of a triangle's corners, which are linear on the screen.
///
/// All weights are computed from the first corner, never from the corner of a tile, so that a
/// pixel's values depend on the triangle alone.
#[derive(Clone, Copy, Debug)]
pub(super) struct TrianglePlane {
    /// Position of the first corner, in pixels.
    origin: [f64; 2],
    /// Increments, for a pixel to the right and one down, of the weights of the second and third
    /// corner.
    second: [f64; 2],
    third: [f64; 2],
    depth: [f64; 3],
    inverse_w: [f64; 3],
    /// Weights of the corners of the whole triangle that this one was cut from.
    weights: [[f64; 3]; 3],
}

/// A point on a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct TrianglePoint {
    /// `z` of `@builtin(position)`.
    pub(super) depth: f64,
    /// `w` of `@builtin(position)`.
    pub(super) inverse_w: f64,
    /// Weights of the second and third corner of the whole triangle, perspective-correct.
    shares: [f64; 2],
}

impl TrianglePlane {
    /// The surface of `triangle`, whose coverage is decided on a grid of 2 to `bits` steps a pixel.
    pub(super) fn new(triangle: &Triangle, bits: u32) -> Self {
        let [a, b, c] = triangle.corners;
        let (places, area) = places(triangle, bits);
        let from_first = |i: usize| [0, 1].map(|axis| places[i][axis] - places[0][axis]);
        let (b_at, c_at) = (from_first(1), from_first(2));
        Self {
            origin: places[0],
            second: [c_at[1] / area, -c_at[0] / area],
            third: [-b_at[1] / area, b_at[0] / area],
            depth: [a.depth, b.depth - a.depth, c.depth - a.depth],
            inverse_w: [a.inverse_w, b.inverse_w, c.inverse_w],
            weights: [a.weights, b.weights, c.weights],
        }
    }

    fn screen_weights(&self, x: f64, y: f64) -> [f64; 2] {
        let (x, y) = (x - self.origin[0], y - self.origin[1]);
        [self.second, self.third].map(|[along_x, along_y]| along_x * x + along_y * y)
    }

    /// The depth at a point of the screen, in pixels from the upper left.
    pub(super) fn depth(&self, x: f64, y: f64) -> f64 {
        let [second, third] = self.screen_weights(x, y);
        let [first, to_second, to_third] = self.depth;
        // Outside of its edges a triangle may rise through a plane that it was cut at; GPUs clamp,
        // too.
        (first + second * to_second + third * to_third).clamp(0.0, 1.0)
    }

    /// The point of the surface at a point of the screen, in pixels from the upper left.
    pub(super) fn point(&self, x: f64, y: f64) -> TrianglePoint {
        let [second, third] = self.screen_weights(x, y);
        let over_w = [
            (1.0 - second - third) * self.inverse_w[0],
            second * self.inverse_w[1],
            third * self.inverse_w[2],
        ];
        let inverse_w = over_w[0] + over_w[1] + over_w[2];
        let share = |corner: usize| {
            (0..3).map(|i| over_w[i] * self.weights[i][corner]).sum::<f64>() / inverse_w
        };
        TrianglePoint { depth: self.depth(x, y), inverse_w, shares: [share(1), share(2)] }
    }
}

/// Positions of the corners for interpolation, in pixels, and twice the area between them.
///
/// Positions are the unrounded ones, unless the grid makes the triangle more than twice or less
/// than half as large: for a sliver that the grid widens or turns around, planes through the
/// unrounded corners can be arbitrarily steep, and those through the rounded ones are not.
fn places(triangle: &Triangle, bits: u32) -> ([[f64; 2]; 3], f64) {
    let pixel = 1.0 / (f64::from(1 << (bits / 2)) * f64::from(1 << bits.div_ceil(2)));
    let rounded = super::setup::doubled_area(&triangle.corners) as f64 * pixel * pixel;
    let true_places = triangle.corners.map(|corner| corner.place);
    let [a, b, c] = true_places;
    let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (0.5 * rounded..=2.0 * rounded).contains(&area) {
        (true_places, area)
    } else {
        (triangle.corners.map(|corner| corner.at.map(|steps| steps as f64 * pixel)), rounded)
    }
}

impl TrianglePoint {
    /// The interpolated value of a number that is `corners` at the corners.
    pub(super) fn mix(&self, [first, second, third]: [f64; 3]) -> f64 {
        // Differences keep a number that is the same at all corners exactly.
        first + self.shares[0] * (second - first) + self.shares[1] * (third - first)
    }
}
