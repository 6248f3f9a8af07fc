//! What decides between the keys of a set: a light's direction, a number of the scene, or a wire of
//! the look.

use glam::DVec3;
use indexmap::IndexMap;

use super::RigInputs;
use crate::compile::{CompiledShader, HostProgram, LightValues, Param};
use crate::document::{Driver, Light, LightKind};
use crate::ids::LightId;

/// What computes the wires that drive keys: the look's module, or one that was made of an earlier
/// state of its values.
#[derive(Clone, Copy, Debug)]
pub struct Wires<'a> {
    /// The module's host program.
    pub host: &'a HostProgram,
    /// The inputs that it reads.
    pub params: &'a [Param],
}

impl<'a> Wires<'a> {
    /// Those of a module.
    pub fn of(shader: &'a CompiledShader) -> Self {
        Self { host: &shader.host, params: &shader.params }
    }
}

/// As far as an object that is not there counts as being, scene units; wires count within so much
/// of 0.
pub(super) const FAR_AWAY: f64 = 1e6;

/// What a driver is at a moment; a wire is computed by the module that has it, and is 0 here.
pub fn driver_value(
    driver: &Driver,
    lights: &IndexMap<LightId, Light>,
    inputs: &RigInputs<'_>,
) -> f64 {
    match driver {
        Driver::Distance => inputs.distance.clamp(0.0, FAR_AWAY),
        Driver::Facing => match (inputs.front.try_normalize(), inputs.view.try_normalize()) {
            (Some(front), Some(view)) => 2.0 * (0.5 * front.distance(view)).clamp(0.0, 1.0).asin(),
            _ => 0.0,
        },
        Driver::Height(id) => lights
            .get(id)
            .map_or(0.0, |light| toward_light(light, inputs).y.clamp(-1.0, 1.0).asin()),
        Driver::Near(id) => {
            inputs.near.get(id).map_or(FAR_AWAY, |distance| distance.clamp(0.0, FAR_AWAY))
        }
        Driver::Wire(_) => 0.0,
    }
}

/// Unit, from the object's centre toward a light, world space.
pub(super) fn toward_light(light: &Light, inputs: &RigInputs<'_>) -> DVec3 {
    let resolved = LightValues::new(light, inputs.illumination, inputs.camera_from_world);
    match light.kind {
        LightKind::Directional => resolved.direction(),
        LightKind::Point | LightKind::Spot => {
            (resolved.position() - inputs.center).try_normalize().unwrap_or(DVec3::Z)
        }
    }
}
