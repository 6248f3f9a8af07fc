//! State of a fit: settings of the knobs, with coordinates that have room in both directions.

use std::f64::consts::PI;

use glam::DVec3;

/// Least distance of a fall-off from its offset, as a share of the way to the cut-off.
const LEAST_SHARE: f64 = 0.02;
/// Greatest offset: at pi a profile is ambient, and neither its light nor its ends have any effect.
const MAX_OFFSET: f64 = PI - 0.01;

/// Width from 1 to 0 from which a profile counts as soft, in radians.
const BROAD: f64 = 1.0;
/// Range of the fall-off, as a share of the way to the cut-off, in which neither end of a profile
/// is hard.
const EASY: [f64; 2] = [0.3, 0.8];

/// A profile by coordinates that cannot come out of order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ProfileShape {
    /// Angle up to which the profile is 1, in radians.
    pub(super) offset: f64,
    /// Distance from the offset to the cut-off, in radians.
    pub(super) width: f64,
    /// Place of the fall-off between the two: 0 at the offset, 1 at the cut-off.
    pub(super) share: f64,
}

impl ProfileShape {
    /// A profile from an artist's offset, fall-off and cut-off in radians, brought into order as
    /// the Profile node does.
    pub(super) fn new([offset, falloff, cutoff]: [f64; 3]) -> Self {
        let offset = offset.clamp(0.0, PI);
        let width = cutoff.clamp(offset, PI) - offset;
        let share = if width > 0.0 { (falloff - offset) / width } else { 1.0 };
        Self { offset, width, share: share.clamp(LEAST_SHARE, 1.0) }
    }

    /// Offset, fall-off and cut-off, in radians.
    pub(super) fn ends(&self) -> [f64; 3] {
        [self.offset, self.offset + self.share * self.width, self.offset + self.width]
    }

    fn moved(&self, by: &[f64]) -> Self {
        let offset = (self.offset + by[0]).clamp(0.0, MAX_OFFSET);
        let width = (self.width + by[1]).clamp(0.0, PI - offset);
        Self { offset, width, share: (self.share + by[2]).clamp(LEAST_SHARE, 1.0) }
    }

    fn room(&self) -> [[f64; 2]; 3] {
        [
            [-self.offset, MAX_OFFSET - self.offset],
            [-self.width, PI - self.offset - self.width],
            [LEAST_SHARE - self.share, 1.0 - self.share],
        ]
    }

    /// Distance of the profile from broad and soft ones: 0 for these, 1 or more for a spot and for
    /// a hard edge.
    pub(super) fn hardness(&self) -> f64 {
        let narrow = (1.0 - self.width / BROAD).max(0.0);
        // The profile is hard at its offset, or at its cut-off.
        let early = (1.0 - self.share / EASY[0]).max(0.0);
        let late = ((self.share - EASY[1]) / (1.0 - EASY[1])).max(0.0);
        narrow + early + late
    }

    /// The profile with a soft edge, which influences pixels from afar and so shows where the edge
    /// should be: a hard edge influences its own pixels alone.
    pub(super) fn softened(&self, width: f64) -> Self {
        let grown = (width - self.width).max(0.0);
        let offset = (self.offset - 0.5 * grown).max(0.0);
        Self { offset, width: (self.width + grown).min(PI - offset), share: self.share.max(0.6) }
    }
}

/// Setting of one knob.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum KnobSetting {
    /// Unit direction toward a light, in the light's own frame.
    Direction(DVec3),
    /// A profile.
    Profile(ProfileShape),
    /// Straight RGB, in the look's color space.
    Color([f64; 3]),
}

impl KnobSetting {
    /// Number of coordinates of the setting.
    pub(super) fn count(&self) -> usize {
        match self {
            Self::Direction(_) => 2,
            Self::Profile(_) | Self::Color(_) => 3,
        }
    }

    /// The setting moved by `by` along each coordinate, in radians for angles, kept within its
    /// range.
    pub(super) fn moved(&self, by: &[f64]) -> Self {
        match self {
            Self::Direction(direction) => Self::Direction(turned(*direction, [by[0], by[1]])),
            Self::Profile(shape) => Self::Profile(shape.moved(by)),
            Self::Color(color) => {
                Self::Color(std::array::from_fn(|c| (color[c] + by[c]).clamp(0.0, 1.0)))
            }
        }
    }

    /// Room of the setting along each coordinate, down and up.
    pub(super) fn room(&self) -> Vec<[f64; 2]> {
        match self {
            Self::Direction(_) => vec![[-0.5, 0.5]; 2],
            // Longer steps would trust the linear approximation too far.
            Self::Profile(shape) => {
                shape.room().map(|[low, high]| [low.max(-0.5), high.min(0.5)]).to_vec()
            }
            Self::Color(color) => color.map(|x| [-x, 1.0 - x]).to_vec(),
        }
    }
}

/// A direction turned by two angles, in radians, along two directions across it.
pub(super) fn turned(direction: DVec3, by: [f64; 2]) -> DVec3 {
    let across = direction.any_orthonormal_pair();
    let step = across.0 * by[0] + across.1 * by[1];
    let angle = step.length();
    if angle < 1e-300 {
        return direction;
    }
    (direction * angle.cos() + step / angle * angle.sin()).normalize()
}

/// Directions spread evenly over the sphere: a spiral of the golden angle (Vogel 1979).
pub(super) fn even_directions(count: usize) -> Vec<DVec3> {
    let golden = PI * (3.0 - 5_f64.sqrt());
    let direction = |index: usize| {
        let z = 1.0 - (2.0 * index as f64 + 1.0) / count as f64;
        let (sin, cos) = (golden * index as f64).sin_cos();
        let r = (1.0 - z * z).sqrt();
        DVec3::new(r * cos, r * sin, z)
    };
    (0..count).map(direction).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_stay_in_range_and_keep_profiles_in_order() {
        let shape = ProfileShape::new([0.2, 0.5, 0.8]);
        assert!(shape.ends().iter().zip([0.2, 0.5, 0.8]).all(|(is, was)| (is - was).abs() < 1e-12));
        for by in [[-9.0, 0.0, 0.0], [9.0, 9.0, 9.0], [0.0, -9.0, -9.0], [0.1, -0.2, 0.3]] {
            let [offset, falloff, cutoff] = shape.moved(&by).ends();
            assert!(
                0.0 <= offset && offset <= falloff && falloff <= cutoff && cutoff <= PI + 1e-12,
                "{by:?}"
            );
        }
        let color = KnobSetting::Color([0.2, 0.9, 0.0]).moved(&[0.1, 0.5, -0.5]);
        assert_eq!(color, KnobSetting::Color([0.2 + 0.1, 1.0, 0.0]));
    }

    #[test]
    fn spots_and_edges_are_hard_and_a_broad_light_is_soft() {
        let hardness = |ends: [f64; 3]| ProfileShape::new(ends.map(f64::to_radians)).hardness();
        assert_eq!(hardness([0.0, 45.0, 90.0]), 0.0);
        assert_eq!(hardness([20.0, 60.0, 90.0]), 0.0);
        assert!(hardness([10.0, 15.0, 20.0]) > 0.8, "a spot");
        assert!(hardness([20.0, 80.0, 80.0]) > 0.95 && hardness([0.0, 2.0, 90.0]) > 0.9, "edges");
    }

    #[test]
    fn a_direction_turns_by_the_angle_asked_for() {
        for direction in even_directions(20) {
            let step = turned(direction, [0.03, -0.04]);
            assert!(
                (step.angle_between(direction) - 0.05).abs() < 1e-9
                    && (step.length() - 1.0).abs() < 1e-12
            );
        }
    }

    #[test]
    fn even_directions_leave_no_gap() {
        let directions = even_directions(48);
        for probe in even_directions(500) {
            let nearest = directions.iter().map(|d| d.angle_between(probe)).fold(PI, f64::min);
            assert!(nearest < 0.4, "{probe}: {nearest}");
        }
    }
}
