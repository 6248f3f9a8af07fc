//! Drivers, which decide between the keys of a set: a light's direction, a number of the scene, or
//! a wire of the look.

use glam::DVec3;
use indexmap::IndexMap;

use super::RigInputs;
use crate::compile::{CompiledShader, HostProgram, LightValues, Param};
use crate::document::{Driver, Light, LightKind};
use crate::ids::LightId;

/// Program of the wires that drive keys: that of the look's module, or of a module compiled from an
/// earlier state of the look's values.
#[derive(Clone, Copy, Debug)]
pub struct Wires<'a> {
    /// Host program of the module.
    pub host: &'a HostProgram,
    /// Inputs that the host program reads.
    pub params: &'a [Param],
}

impl<'a> Wires<'a> {
    /// The wires of a module.
    pub fn of(shader: &'a CompiledShader) -> Self {
        Self { host: &shader.host, params: &shader.params }
    }
}

/// Distance at which a missing object counts, in scene units; also the bound of the magnitude of
/// wires.
pub(super) const FAR_AWAY: f64 = 1e6;

/// The value of a driver for an object at a time; 0 for a wire, which is computed by the module
/// that has it.
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

/// The unit direction from the object's center toward a light, in world space.
pub(super) fn toward_light(light: &Light, inputs: &RigInputs<'_>) -> DVec3 {
    let resolved = LightValues::new(light, &inputs.light_frames());
    match light.kind {
        LightKind::Directional => resolved.direction(),
        LightKind::Point | LightKind::Spot => {
            (resolved.position() - inputs.center).try_normalize().unwrap_or(DVec3::Z)
        }
    }
}
