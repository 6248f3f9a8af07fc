//! Turning of a light or the view to a key, for comparison: only the window's view changes, the
//! document stays as it is.

use glam::{DQuat, DVec3};

use crate::document::{KeyDirection, LightSpace};
use crate::fields::lighting::OwnedKeys;
use crate::state::keying::camera_from_world;
use crate::state::orbit::Orbit;

/// View, or illumination frame, at which `direction` holds; `None` where turning the frame does not
/// move the light.
pub(super) fn to(owned: OwnedKeys<'_>, by: &KeyDirection, direction: DVec3) -> Option<Orbit> {
    let direction = direction.try_normalize()?;
    let mut view = owned.session.view.orbit.clone();
    match by {
        KeyDirection::View => {
            view.yaw = direction.x.atan2(direction.z).rem_euclid(std::f64::consts::TAU);
            let limit = std::f64::consts::FRAC_PI_2 - 0.01;
            view.pitch = direction.y.clamp(-1.0, 1.0).asin().clamp(-limit, limit);
        }
        KeyDirection::Drivers(_) => return None,
        KeyDirection::Light(id) => {
            let light = owned.look().lights.get(id);
            light.filter(|light| light.space == LightSpace::Illumination)?;
            let world_from_camera = camera_from_world(&view).transpose();
            let now = (world_from_camera * owned.keys.direction_of(by)).try_normalize()?;
            let turn = DQuat::from_rotation_arc(now, (world_from_camera * direction).normalize());
            view.illumination = (turn * view.illumination).normalize();
        }
    }
    Some(view)
}
