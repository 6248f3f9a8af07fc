//! Place on the surface that a layer is confined to, by the node `nearby`.

use glam::DVec3;

/// Range of a radius, in parts of the radius that a step begins at.
const STRETCH: [f64; 2] = [-0.4, 0.6];
/// Greatest radius of the node, in the object's units.
const MOST_RADIUS: f64 = 10.0;
/// Greatest hardness: from there on an edge shows at its own pixels alone.
const HARDEST: f64 = 0.9;

/// Place around a point of the surface, in the object's own space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LayerPlace {
    pub(super) center: DVec3,
    /// Distance from the center beyond which nothing is left, in the object's units.
    pub(super) radius: f64,
    /// Share of the radius that is full, from 0 to 1.
    pub(super) hardness: f64,
}

impl LayerPlace {
    /// A place; `None` for one that the node has no radius for, as on a mesh in millimeters.
    pub(super) fn new(center: DVec3, radius: f64, hardness: f64) -> Option<Self> {
        let is_there = center.is_finite() && radius > 0.0 && radius <= MOST_RADIUS;
        is_there.then_some(Self { center, radius, hardness })
    }

    /// Number of coordinates: three of the center, the radius and the hardness.
    pub(super) const COUNT: usize = 5;

    /// Weight at a point: 1 around the center, 0 from the radius on, a smooth step between, as
    /// `near_place` has it.
    pub(super) fn weight(&self, position: DVec3) -> f64 {
        let full = self.radius * self.hardness;
        let far = (position.distance(self.center) - full) / (self.radius - full).max(1e-12);
        let far = far.clamp(0.0, 1.0);
        1.0 - far * far * (3.0 - 2.0 * far)
    }

    /// The place moved by `by` along each coordinate: the center and the radius by parts of the
    /// radius.
    pub(super) fn moved(&self, by: &[f64]) -> Self {
        Self {
            center: self.center + self.radius * DVec3::new(by[0], by[1], by[2]),
            radius: (self.radius * (1.0 + by[3].clamp(STRETCH[0], STRETCH[1]))).min(MOST_RADIUS),
            hardness: (self.hardness + by[4]).clamp(0.0, HARDEST),
        }
    }

    /// Room of the place along each coordinate, down and up.
    pub(super) fn room(&self) -> [[f64; 2]; Self::COUNT] {
        let aside = [-0.5, 0.5];
        let wider = STRETCH[1].min(MOST_RADIUS / self.radius - 1.0);
        [aside, aside, aside, [STRETCH[0], wider], [-self.hardness, HARDEST - self.hardness]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_is_full_at_its_center_and_ends_at_its_radius() {
        assert_eq!(LayerPlace::new(DVec3::X, 11.0, 0.2), None);
        let place = LayerPlace::new(DVec3::X, 0.5, 0.2).unwrap();
        let at = |far: f64| place.weight(DVec3::X + DVec3::Y * far);
        assert_eq!([at(0.0), at(0.1), at(0.5), at(7.0)], [1.0, 1.0, 0.0, 0.0]);
        assert!((at(0.3) - 0.5).abs() < 1e-12, "{}", at(0.3));
        let moved = place.moved(&[0.5, 0.0, 0.0, 9.0, 9.0]);
        assert_eq!(moved.center, DVec3::X * 1.25);
        assert!((moved.radius - 0.8).abs() < 1e-12 && moved.hardness == HARDEST);
        for (room, rest) in moved.room().into_iter().zip([0.5, 0.5, 0.5, 0.6, 0.0]) {
            assert!(room[0] < 0.0 && room[1] == rest, "{room:?}");
        }
    }
}
