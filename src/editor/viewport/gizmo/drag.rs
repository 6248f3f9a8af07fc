//! Handles of an object, and the transform that a drag of one gives.

use chiaro_locale::tr;
use glam::{DQuat, DVec3};

use crate::document::Transform;
use crate::state::scene::unit_rotation;
use crate::viewport::place::{PictureRay, nearest_along, on_plane};

/// Least factor of a scale: at 0 an object vanishes.
const LEAST_SCALE: f64 = 1e-3;
/// Steps of a drag that snaps: of places and scales, and of turns, in radians.
const STEP: f64 = 0.1;
const STEP_ANGLE: f64 = std::f64::consts::PI / 12.0;
/// Least cosine between a ray and the axis of a ring whose plane the ray may be cut with.
const LEAST_FACING: f64 = 0.1;

pub(super) const AXES: [DVec3; 3] = [DVec3::X, DVec3::Y, DVec3::Z];
pub(super) const NAMES: [&str; 3] = ["x", "y", "z"];

/// Handle of an object; axes are 0 to 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum GizmoHandle {
    /// Moves along an axis of the world.
    Move(usize),
    /// Moves across the picture, at the object's depth.
    MoveAcross,
    /// Turns around an axis of the object.
    Turn(usize),
    /// Scales along an axis of the object.
    Scale(usize),
    /// Scales along all axes.
    ScaleAll,
}

/// Directions of the picture: to the right, up, and toward the eye; unit.
#[derive(Clone, Copy, Debug)]
pub(super) struct PictureAxes {
    pub(super) right: DVec3,
    pub(super) up: DVec3,
    pub(super) backward: DVec3,
}

/// Direction in the world of an axis of a turned object.
pub(super) fn own_axis(transform: &Transform, axis: usize) -> DVec3 {
    unit_rotation(transform.rotate) * AXES[axis % 3]
}

impl GizmoHandle {
    /// Name for who cannot see it, and for the pointer's hint.
    pub(super) fn label(self, object: &str) -> String {
        match self {
            Self::Move(axis) => tr!("Move {object} along {axis}", axis = NAMES[axis]),
            Self::MoveAcross => tr!("Move {object} across the picture"),
            Self::Turn(axis) => tr!("Turn {object} around its {axis} axis", axis = NAMES[axis]),
            Self::Scale(axis) => tr!("Scale {object} along its {axis} axis", axis = NAMES[axis]),
            Self::ScaleAll => tr!("Scale {object}"),
        }
    }

    /// Place in the world, `length` from the object's place.
    pub(super) fn place(self, transform: &Transform, axes: &PictureAxes, length: f64) -> DVec3 {
        let away = match self {
            Self::Move(axis) => AXES[axis],
            Self::MoveAcross => DVec3::ZERO,
            Self::Turn(axis) => own_axis(transform, axis + 1),
            Self::Scale(axis) => own_axis(transform, axis),
            Self::ScaleAll => (axes.right + axes.up).normalize(),
        };
        DVec3::from(transform.translate) + away * length
    }

    /// Value for who cannot see it: a coordinate, a number of degrees or a factor.
    pub(super) fn value(self, transform: &Transform) -> f64 {
        match self {
            Self::Move(axis) => transform.translate[axis],
            Self::MoveAcross => transform.translate[0],
            Self::Turn(axis) => crate::state::scene::to_degrees(transform.rotate)[axis],
            Self::Scale(axis) => transform.scale[axis],
            Self::ScaleAll => transform.scale[0],
        }
    }

    /// The transform when the handle, which was at `from` with the transform `start`, is dragged to
    /// where a ray of the picture goes, in steps where it snaps. `None` where that says nothing.
    pub(super) fn dragged(
        self,
        (start, from): (&Transform, DVec3),
        ray: PictureRay,
        axes: &PictureAxes,
        snaps: bool,
    ) -> Option<Transform> {
        let center = DVec3::from(start.translate);
        let mut new = *start;
        match self {
            Self::Move(axis) => {
                let along = nearest_along(center, AXES[axis], ray)?;
                let moved = along - (from - center).dot(AXES[axis]);
                new.translate[axis] = stepped(center[axis] + moved, snaps);
            }
            Self::MoveAcross => {
                let moved = center + on_plane(from, axes.backward, ray)? - from;
                new.translate = moved.to_array().map(|x| stepped(x, snaps));
            }
            Self::Turn(axis) => {
                let around = own_axis(start, axis);
                let faces = ray.direction.dot(around).abs() > LEAST_FACING;
                // Seen from the side, the plane of a ring is no place to point at.
                let to = on_plane(from, if faces { around } else { axes.backward }, ray)?;
                let flat = |at: DVec3| (at - center).reject_from_normalized(around);
                let (a, b) = (flat(from).try_normalize()?, flat(to).try_normalize()?);
                let angle = around.dot(a.cross(b)).atan2(a.dot(b));
                let angle = if snaps { (angle / STEP_ANGLE).round() * STEP_ANGLE } else { angle };
                let turn = DQuat::from_axis_angle(around, angle);
                new.rotate = (turn * unit_rotation(start.rotate)).normalize().to_array();
            }
            Self::Scale(axis) => {
                let own = own_axis(start, axis);
                let before = (from - center).dot(own);
                let factor = nearest_along(center, own, ray)? / before;
                new.scale[axis] = scaled(start.scale[axis], factor, snaps)?;
            }
            Self::ScaleAll => {
                let to = on_plane(from, axes.backward, ray)?;
                let factor = to.distance(center) / from.distance(center);
                for scale in &mut new.scale {
                    *scale = scaled(*scale, factor, snaps)?;
                }
            }
        }
        Some(new)
    }
}

fn stepped(x: f64, snaps: bool) -> f64 {
    let step = if snaps { STEP } else { 1e-4 };
    // Adding 0 hides the sign of -0.
    ((x / step).round() * step * 1e4).round() / 1e4 + 0.0
}

/// A scale by a factor, with its sign and not 0; `None` for a factor that is no number.
fn scaled(scale: f64, factor: f64, snaps: bool) -> Option<f64> {
    if !factor.is_finite() {
        return None;
    }
    let size = scale.abs() * factor.max(0.0);
    let least = if snaps { STEP } else { LEAST_SCALE };
    Some(stepped(size, snaps).max(least).copysign(scale))
}

#[cfg(test)]
mod tests {
    use super::*;

    const EYE: DVec3 = DVec3::new(1.0, 2.0, 10.0);

    fn axes() -> PictureAxes {
        let backward = EYE.normalize();
        let right = DVec3::Y.cross(backward).normalize();
        PictureAxes { right, up: backward.cross(right), backward }
    }

    fn through(point: DVec3) -> PictureRay {
        PictureRay { origin: EYE, direction: (point - EYE).normalize() }
    }

    fn start() -> Transform {
        let rotate = DQuat::from_axis_angle(DVec3::new(1.0, 2.0, 0.5).normalize(), 0.7).to_array();
        Transform { translate: [0.5, -0.25, 1.0], rotate, scale: [1.0, 2.0, -0.5], fit: true }
    }

    fn dragged(handle: GizmoHandle, to: impl Fn(DVec3) -> DVec3, snaps: bool) -> Transform {
        let (start, axes) = (start(), axes());
        let from = handle.place(&start, &axes, 0.8);
        handle.dragged((&start, from), through(to(from)), &axes, snaps).unwrap()
    }

    #[test]
    fn an_object_follows_its_handles() {
        for (axis, along) in AXES.into_iter().enumerate() {
            let new = dragged(GizmoHandle::Move(axis), |at| at + along * 0.3, false);
            let mut wanted = start();
            wanted.translate[axis] += 0.3;
            assert!(close(new.translate, wanted.translate) && new.rotate == wanted.rotate);
        }
        let by = axes().right * 0.5 - axes().up * 0.2;
        let new = dragged(GizmoHandle::MoveAcross, |at| at + by, false);
        let wanted = DVec3::from(start().translate) + by;
        assert!(close(new.translate, wanted.to_array()), "{new:?}");
    }

    #[test]
    fn a_turn_is_around_the_objects_own_axis() {
        let center = DVec3::from(start().translate);
        for axis in 0..3 {
            for angle in [0.4, -1.2, 2.5] {
                let around = own_axis(&start(), axis);
                let turn = DQuat::from_axis_angle(around, angle);
                let handle = GizmoHandle::Turn(axis);
                let new = dragged(handle, |at| center + turn * (at - center), false);
                let wanted = turn * unit_rotation(start().rotate);
                assert!(unit_rotation(new.rotate).angle_between(wanted) < 1e-6, "{axis} {angle}");
                assert!(own_axis(&new, axis).distance(around) < 1e-9);
                let snapped = dragged(handle, |at| center + turn * (at - center), true);
                let angle = unit_rotation(snapped.rotate)
                    .angle_between(unit_rotation(start().rotate))
                    .to_degrees();
                assert!((angle / 15.0 - (angle / 15.0).round()).abs() < 1e-6, "{angle}");
            }
        }
    }

    #[test]
    fn scales_keep_their_signs_and_are_never_0() {
        let center = DVec3::from(start().translate);
        for axis in 0..3 {
            let handle = GizmoHandle::Scale(axis);
            let new = dragged(handle, |at| center + (at - center) * 1.5, false);
            let mut wanted = start().scale;
            wanted[axis] *= 1.5;
            assert!(close(new.scale, wanted), "{new:?}");
            let new = dragged(handle, |at| center - (at - center), false);
            assert_eq!(new.scale[axis], LEAST_SCALE.copysign(start().scale[axis]));
        }
        let new = dragged(GizmoHandle::ScaleAll, |at| center + (at - center) * 0.5, false);
        assert!(close(new.scale, [0.5, 1.0, -0.25]), "{new:?}");
        let new = dragged(GizmoHandle::ScaleAll, |at| center + (at - center) * 0.52, true);
        assert!(close(new.scale, [0.5, 1.0, -0.3]), "{new:?}");
    }

    fn close(a: [f64; 3], b: [f64; 3]) -> bool {
        DVec3::from(a).distance(b.into()) < 2e-4
    }
}
