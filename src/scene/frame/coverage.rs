//! Rectangle of the picture in which objects can be seen.

use glam::{DMat4, DVec4};

use super::camera::View;
use crate::geometry::Bounds;

/// Rectangle of pixels of a picture, from `begin` up to `end`, which is excluded; y points down.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PixelArea {
    /// Left and top.
    pub begin: [u32; 2],
    /// Right and bottom.
    pub end: [u32; 2],
}

impl PixelArea {
    /// Area of nothing.
    pub const EMPTY: Self = Self { begin: [0; 2], end: [0; 2] };

    /// Area of a whole picture of `size` pixels.
    pub fn whole(size: [u32; 2]) -> Self {
        Self { begin: [0; 2], end: size }
    }

    /// Width and height, in pixels.
    pub fn size(&self) -> [u32; 2] {
        [0, 1].map(|axis| self.end[axis].saturating_sub(self.begin[axis]))
    }

    /// Number of pixels.
    pub fn count(&self) -> u64 {
        self.size().into_iter().map(u64::from).product()
    }

    /// True if the area has no pixels.
    pub fn is_empty(&self) -> bool {
        self.size().contains(&0)
    }

    /// True if a pixel lies within.
    pub fn contains(&self, pixel: [u32; 2]) -> bool {
        (0..2).all(|axis| (self.begin[axis]..self.end[axis]).contains(&pixel[axis]))
    }

    /// True if some pixel lies within both.
    pub fn meets(&self, other: &Self) -> bool {
        (0..2).all(|axis| {
            let begin = self.begin[axis].max(other.begin[axis]);
            begin < self.end[axis].min(other.end[axis])
        })
    }

    /// Least area that has both.
    #[must_use]
    pub fn joined(self, other: Self) -> Self {
        match (self.is_empty(), other.is_empty()) {
            (true, _) => other,
            (_, true) => self,
            _ => Self {
                begin: [0, 1].map(|axis| self.begin[axis].min(other.begin[axis])),
                end: [0, 1].map(|axis| self.end[axis].max(other.end[axis])),
            },
        }
    }

    /// Area with `by` pixels more on every side, within a picture of `size` pixels. Nothing stays
    /// nothing.
    #[must_use]
    pub fn widened(self, by: u32, size: [u32; 2]) -> Self {
        if self.is_empty() {
            return self;
        }
        Self {
            begin: self.begin.map(|least| least.saturating_sub(by)),
            end: [0, 1].map(|axis| self.end[axis].saturating_add(by).min(size[axis])),
        }
    }

    /// Least area that has this one and begins and ends between blocks of `side` by `side` pixels,
    /// within a picture of `size` pixels.
    #[must_use]
    pub fn in_blocks(self, side: u32, size: [u32; 2]) -> Self {
        Self {
            begin: self.begin.map(|least| least / side * side),
            end: [0, 1].map(|axis| self.end[axis].next_multiple_of(side).min(size[axis])),
        }
    }

    /// Pixels of a picture of `size` pixels that what lies in a box may cover: the whole picture
    /// where the box reaches the plane of the eye.
    pub(super) fn of_box(
        world_from_object: DMat4,
        bounds: &Bounds,
        view: &View,
        size: [u32; 2],
    ) -> Self {
        let corners = clip_corners(world_from_object, bounds, view);
        if corners.iter().any(|corner| !corner.is_finite() || !is_in_front(*corner)) {
            return Self::whole(size);
        }
        let sides = [0, 1].map(|axis| {
            let pixels = f64::from(size[axis]);
            let place = |corner: &DVec4| {
                let clip = if axis == 0 { corner.x } else { -corner.y };
                (0.5 + 0.5 * clip / corner.w) * pixels
            };
            let places = corners.iter().map(place);
            let [least, most] = places
                .fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], at| [a.min(at), b.max(at)]);
            // The margin allows for the shader's f32.
            let margin = 1.0 + 1e-4 * pixels;
            let within = |at: f64| at.clamp(0.0, pixels) as u32;
            [within((least - margin).floor()), within((most + margin).ceil())]
        });
        Self { begin: sides.map(|[least, _]| least), end: sides.map(|[_, most]| most) }
    }
}

/// True for a corner so far in front of the eye that its place in the picture is told well.
fn is_in_front(corner: DVec4) -> bool {
    corner.w > 1e-3 * corner.truncate().length()
}

/// Corners of a box in clip space.
pub(super) fn clip_corners(world_from_object: DMat4, bounds: &Bounds, view: &View) -> [DVec4; 8] {
    let clip_from_object = view.clip_from_world * world_from_object;
    bounds.corners().map(|corner| clip_from_object * corner.extend(1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn areas_join_and_widen_within_the_picture() {
        let area = PixelArea { begin: [3, 4], end: [6, 5] };
        assert_eq!((area.size(), area.is_empty()), ([3, 1], false));
        assert!(area.contains([5, 4]) && !area.contains([6, 4]) && !area.contains([5, 5]));
        assert_eq!(PixelArea::EMPTY.joined(area), area);
        assert_eq!(area.joined(PixelArea::EMPTY), area);
        assert!(area.meets(&PixelArea { begin: [5, 0], end: [9, 5] }));
        assert!(!area.meets(&PixelArea { begin: [6, 0], end: [9, 5] }));
        assert!(!area.meets(&PixelArea::EMPTY));
        let other = PixelArea { begin: [0, 7], end: [1, 9] };
        assert_eq!(area.joined(other), PixelArea { begin: [0, 4], end: [6, 9] });
        assert_eq!(area.in_blocks(4, [7, 7]), PixelArea { begin: [0, 4], end: [7, 7] });
        assert_eq!(area.widened(4, [8, 8]), PixelArea { begin: [0, 0], end: [8, 8] });
        assert_eq!(PixelArea::EMPTY.widened(4, [8, 8]), PixelArea::EMPTY);
        assert_eq!(area.widened(u32::MAX, [9, 9]), PixelArea::whole([9, 9]));
    }
}
