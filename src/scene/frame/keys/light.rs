//! Fields of a light by name, as keys and files name them.

use std::collections::HashMap;

use indexmap::IndexMap;

use super::blend::numbers_of;
use crate::document::{Light, LightField, Target, Value};
use crate::ids::LightId;

/// The value of the light's field `field`; `None` where there is none of that name.
pub fn light_field(light: &Light, field: &str) -> Option<Value> {
    LightField::named(field).map(|field| field.get(light))
}

/// Writes those of some values that are fields of lights into the lights.
pub(in crate::frame) fn set_lights(
    lights: &mut IndexMap<LightId, Light>,
    values: &HashMap<Target, Value>,
) {
    for (target, value) in values {
        if let Target::Light { light, field } = target
            && let Some(light) = lights.get_mut(light)
        {
            set_light_field(light, field, value);
        }
    }
}

/// Sets the light's field `field`; a value of another shape changes nothing.
pub fn set_light_field(light: &mut Light, field: &str, value: &Value) {
    if let (Some(field), Some(numbers)) = (LightField::named(field), numbers_of(value)) {
        field.set(light, &numbers);
    }
}
