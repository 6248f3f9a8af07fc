//! Clipping of triangles at the near and far planes, in clip space.
//!
//! Corners keep their weights on the corners of the whole triangle, so that nothing but positions
//! is ever computed twice. A cut runs from the corner inside to the one outside whichever way the
//! edge is walked: two triangles that share an edge get the same corner on it, bit for bit, and no
//! gap opens between them.

/// A corner of the clipped part of a triangle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct ClippedCorner {
    /// Position in clip space.
    pub(super) clip: [f64; 4],
    /// Weights of the whole triangle's corners, whose sum is 1.
    pub(super) weights: [f64; 3],
}

/// Distance from the middle of the picture at which triangles are clipped, in half widths of the
/// picture: 2^13 of at most 2^14 pixels stay within 2^28 pixels, also if rounding doubles them, and
/// grid coordinates below 2^60 steps.
pub(super) const GUARD: f64 = 8192.0;
/// Least w of a position; positions with a smaller w are at the eye or behind it.
pub(super) const LEAST_W: f64 = 1e-12;
/// Number of planes: near, far, the eye, and four sides far beyond the picture.
const PLANES: u32 = 7;
/// Largest number of corners: three, and one more for each plane.
const MOST: usize = 3 + PLANES as usize;

/// Distance of a finite position inside of a plane, in some measure that is linear in clip space;
/// negative outside.
fn inside(plane: u32, [x, y, z, w]: [f64; 4]) -> f64 {
    match plane {
        0 => z,
        1 => w - z,
        2 => w - LEAST_W,
        3 => GUARD * w + x,
        4 => GUARD * w - x,
        5 => GUARD * w + y,
        _ => GUARD * w - y,
    }
}

/// The planes that a position is outside of, by bit.
pub(super) fn outcode(clip: [f64; 4]) -> u8 {
    (0..PLANES).map(|plane| if inside(plane, clip) >= 0.0 { 0 } else { 1 << plane }).sum()
}

/// The clipped part of a triangle: a convex polygon.
#[derive(Clone, Copy, Debug)]
pub(super) struct ClippedPolygon {
    corners: [ClippedCorner; MOST],
    count: usize,
}

impl ClippedPolygon {
    /// A whole triangle.
    pub(super) fn new(clip: [[f64; 4]; 3]) -> Self {
        let mut polygon = Self { corners: [ClippedCorner::default(); MOST], count: 3 };
        for (i, clip) in clip.into_iter().enumerate() {
            polygon.corners[i].clip = clip;
            polygon.corners[i].weights[i] = 1.0;
        }
        polygon
    }

    /// The polygon's corners in order; none if nothing is left.
    pub(super) fn corners(&self) -> &[ClippedCorner] {
        &self.corners[..self.count]
    }

    fn push(&mut self, corner: ClippedCorner) {
        if let Some(place) = self.corners.get_mut(self.count) {
            *place = corner;
            self.count += 1;
        }
    }

    /// The part inside all planes of `outcodes`, the bits of all corners together.
    pub(super) fn clipped(mut self, outcodes: u8) -> Self {
        for plane in (0..PLANES).filter(|plane| outcodes & (1 << plane) != 0) {
            self = self.clipped_at(plane);
        }
        self
    }

    fn clipped_at(&self, plane: u32) -> Self {
        let mut kept = Self { corners: [ClippedCorner::default(); MOST], count: 0 };
        let corners = self.corners();
        for (i, &here) in corners.iter().enumerate() {
            let next = corners[(i + 1) % corners.len()];
            let (from, to) = (inside(plane, here.clip), inside(plane, next.clip));
            if from >= 0.0 {
                kept.push(here);
            }
            match (from >= 0.0, to >= 0.0) {
                (true, false) => kept.push(between(here, next, from / (from - to))),
                (false, true) => kept.push(between(next, here, to / (to - from))),
                _ => {}
            }
        }
        if kept.count < 3 {
            kept.count = 0;
        }
        kept
    }
}

fn between(a: ClippedCorner, b: ClippedCorner, share: f64) -> ClippedCorner {
    let mix = |a: f64, b: f64| a + share * (b - a);
    ClippedCorner {
        clip: std::array::from_fn(|i| mix(a.clip[i], b.clip[i])),
        weights: std::array::from_fn(|i| mix(a.weights[i], b.weights[i])),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_corner_behind_the_eye_leaves_a_quadrangle() {
        let clip = [[0.0, 0.0, 1.0, 2.0], [1.0, 0.0, 1.0, 2.0], [0.0, 1.0, -2.0, -2.0]];
        let codes = clip.map(outcode);
        assert_eq!((codes[0], codes[1]), (0, 0));
        assert!(codes[2] & 0b101 == 0b101, "{codes:?}");
        let polygon = ClippedPolygon::new(clip).clipped(codes[0] | codes[1] | codes[2]);
        assert_eq!(polygon.corners().len(), 4);
        for corner in polygon.corners() {
            assert!(corner.clip[2] >= -1e-12 && corner.clip[3] > 0.0, "{corner:?}");
            assert!((corner.weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            for (i, exact) in corner.clip.iter().enumerate() {
                let mixed: f64 = (0..3).map(|k| corner.weights[k] * clip[k][i]).sum();
                assert!((mixed - exact).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn both_sides_of_an_edge_are_cut_at_the_same_bits() {
        let (a, b) = ([0.1, 0.7, 0.3, 1.9], [-0.3, 0.2, -0.4, 1.1]);
        let cut = |clip: [[f64; 4]; 3]| {
            let polygon = ClippedPolygon::new(clip).clipped(1);
            let corners: Vec<_> =
                polygon.corners().iter().map(|corner| corner.clip.map(f64::to_bits)).collect();
            corners
        };
        let (one, other) = (cut([a, b, [2.0, 0.0, 0.5, 1.0]]), cut([b, a, [-2.0, 0.0, 0.5, 1.0]]));
        let shared = one.iter().filter(|corner| other.contains(corner)).count();
        assert_eq!(shared, 2, "the corner inside and the cut");
    }
}
