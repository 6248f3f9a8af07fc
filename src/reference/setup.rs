//! Triangle setup: from corners in clip space to triangles on the screen's grid, their orientation
//! and culling.

use super::clip::{ClippedCorner, ClippedPolygon, GUARD, LEAST_W, outcode};

/// The picture's size, and the grid within a pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Screen {
    pub(super) size: [u32; 2],
    /// Binary logarithm of the number of grid steps in a pixel.
    pub(super) bits: u32,
}

/// Sides of triangles that are drawn, and the side that is the front.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Sides {
    /// True to draw back faces, too.
    pub both: bool,
    /// True if front faces run clockwise, because a transform mirrors them.
    pub is_mirrored: bool,
}

/// A corner on the screen.
#[derive(Clone, Copy, Debug)]
pub(super) struct ScreenCorner {
    /// Position that decides coverage, in grid steps from the upper left, y down.
    pub(super) at: [i64; 2],
    /// Unrounded position that values are interpolated by, in pixels from the upper left, y down.
    pub(super) place: [f64; 2],
    /// Depth: 0 at the near plane, 1 at the far plane.
    pub(super) depth: f64,
    pub(super) inverse_w: f64,
    /// Weights of the corners of the triangle that this one was cut from.
    pub(super) weights: [f64; 3],
}

/// A triangle on the screen, clockwise as seen by the viewer.
#[derive(Clone, Copy, Debug)]
pub(super) struct Triangle {
    pub(super) corners: [ScreenCorner; 3],
    pub(super) is_front: bool,
}

impl Screen {
    fn place(self, corner: &ClippedCorner) -> ScreenCorner {
        let [x, y, z, w] = corner.clip;
        // Clipping leaves nothing beyond either limit except by rounding, which matters only if w
        // is next to 0.
        let w = w.max(LEAST_W);
        let steps = f64::from(1 << (self.bits / 2)) * f64::from(1 << self.bits.div_ceil(2));
        let pixels = |ndc: f64, side: u32| {
            0.5 * (ndc.clamp(-2.0 * GUARD, 2.0 * GUARD) + 1.0) * f64::from(side)
        };
        let place = [pixels(x / w, self.size[0]), pixels(-y / w, self.size[1])];
        ScreenCorner {
            at: place.map(|pixels| (pixels * steps).round() as i64),
            place,
            depth: z / w,
            inverse_w: 1.0 / w,
            weights: corner.weights,
        }
    }

    /// The triangles to draw for a triangle: none, one, or several if it was clipped.
    pub(super) fn triangles(self, clip: [[f64; 4]; 3], sides: Sides) -> Fan {
        let mut fan = Fan { corners: [None; MOST], count: 0, is_clockwise: false, is_front: false };
        if !clip.iter().flatten().all(|x| x.is_finite()) {
            return fan;
        }
        let codes = clip.map(outcode);
        if codes[0] & codes[1] & codes[2] != 0 {
            return fan;
        }
        let polygon = match codes[0] | codes[1] | codes[2] {
            0 => ClippedPolygon::new(clip),
            outside => ClippedPolygon::new(clip).clipped(outside),
        };
        for (place, corner) in fan.corners.iter_mut().zip(polygon.corners()) {
            *place = Some(self.place(corner));
        }
        fan.count = polygon.corners().len();
        let area: i128 = (2..fan.count)
            .filter_map(|last| fan.at(last))
            .map(|corners| doubled_area(&corners))
            .sum();
        fan.is_clockwise = area > 0;
        fan.is_front = fan.is_clockwise == sides.is_mirrored;
        if area == 0 || !(sides.both || fan.is_front) {
            fan.count = 0;
        }
        fan
    }
}

/// Largest number of corners of a clipped triangle.
const MOST: usize = 10;

/// The triangles around the first corner of a polygon.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fan {
    corners: [Option<ScreenCorner>; MOST],
    count: usize,
    is_clockwise: bool,
    is_front: bool,
}

impl Fan {
    /// The corners of the triangle that ends at corner `last`.
    fn at(&self, last: usize) -> Option<[ScreenCorner; 3]> {
        Some([self.corners[0]?, self.corners[last - 1]?, self.corners[last]?])
    }

    /// All triangles that have an area.
    pub(super) fn triangles(&self) -> impl Iterator<Item = Triangle> {
        let clockwise = move |[a, b, c]: [ScreenCorner; 3]| {
            let corners = if self.is_clockwise { [a, b, c] } else { [a, c, b] };
            // Rounding to the grid may turn a sliver of a polygon around: its neighbors cover the
            // same samples.
            (doubled_area(&corners) > 0).then_some(Triangle { corners, is_front: self.is_front })
        };
        (2..self.count).filter_map(|last| self.at(last)).filter_map(clockwise)
    }

    /// The least and the greatest pixel that the polygon touches, not clipped at the picture's
    /// sides; `None` if nothing is to be drawn.
    pub(super) fn pixels(&self, bits: u32) -> Option<[[i64; 2]; 2]> {
        let mut corners = self.corners[..self.count].iter().flatten().map(|corner| corner.at);
        let first = corners.next()?;
        let [least, most] = corners.fold([first, first], |[least, most], at| {
            [[least[0].min(at[0]), least[1].min(at[1])], [most[0].max(at[0]), most[1].max(at[1])]]
        });
        Some([least, most].map(|at| at.map(|steps| steps >> bits)))
    }
}

/// Twice the area in grid steps; positive for clockwise triangles as seen by the viewer, with y
/// down.
pub(super) fn doubled_area([a, b, c]: &[ScreenCorner; 3]) -> i128 {
    let [bx, by] = [0, 1].map(|i| i128::from(b.at[i] - a.at[i]));
    let [cx, cy] = [0, 1].map(|i| i128::from(c.at[i] - a.at[i]));
    bx * cy - by * cx
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCREEN: Screen = Screen { size: [100, 50], bits: 8 };
    const LEFT_HALF: [[f64; 4]; 3] =
        [[-1.0, 3.0, 0.5, 1.0], [-1.0, -1.0, 0.5, 1.0], [0.0, -1.0, 0.5, 1.0]];

    #[test]
    fn the_viewport_is_that_of_webgpu() {
        let fan = SCREEN.triangles(LEFT_HALF, Sides::default());
        let triangle = fan.triangles().next().expect("counter-clockwise is the front");
        assert!(triangle.is_front);
        let mut at = triangle.corners.map(|corner| corner.at);
        at.sort_unstable();
        assert_eq!(at, [[0, -50 * 256], [0, 50 * 256], [50 * 256, 50 * 256]]);
        assert_eq!(fan.pixels(8), Some([[0, -50], [50, 50]]));
    }

    #[test]
    fn back_faces_are_culled_unless_wanted_or_mirrored() {
        let [a, b, c] = LEFT_HALF;
        let back = [a, c, b];
        let drawn = |both, is_mirrored| {
            SCREEN.triangles(back, Sides { both, is_mirrored }).triangles().next()
        };
        assert!(drawn(false, false).is_none());
        assert!(!drawn(true, false).expect("both sides").is_front);
        assert!(drawn(false, true).expect("mirrored").is_front);
        assert!(
            SCREEN
                .triangles(LEFT_HALF, Sides { both: false, is_mirrored: true })
                .triangles()
                .next()
                .is_none()
        );
    }

    #[test]
    fn nothing_that_is_no_number_is_drawn() {
        for bad in [f64::NAN, f64::INFINITY] {
            let fan = SCREEN
                .triangles([LEFT_HALF[0], LEFT_HALF[1], [bad, 0.0, 0.5, 1.0]], Sides::default());
            assert_eq!(fan.triangles().count(), 0);
        }
    }
}
