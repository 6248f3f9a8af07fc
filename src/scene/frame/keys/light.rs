//! The fields of a light by name, as keys and files say them.

use std::collections::HashMap;

use indexmap::IndexMap;

use super::blend::numbers_of;
use crate::document::{Light, Target, Value};
use crate::ids::LightId;

/// A field of a light by name; `None` where there is none of that name.
pub fn light_field(light: &Light, field: &str) -> Option<Value> {
    let vector = |v: [f64; 3]| Some(Value::Vector(v.to_vec()));
    match field {
        "direction" => vector(light.direction),
        "position" => vector(light.position),
        "aim" => vector(light.aim),
        "color" => vector(light.color),
        "intensity" => Some(Value::Number(light.intensity)),
        "inner" => Some(Value::Number(light.inner)),
        "outer" => Some(Value::Number(light.outer)),
        "half_distance" => Some(Value::Number(light.half_distance)),
        "range" => Some(Value::Number(light.range)),
        _ => None,
    }
}

pub(super) fn set_lights(lights: &mut IndexMap<LightId, Light>, values: &HashMap<Target, Value>) {
    for (target, value) in values {
        if let Target::Light { light, field } = target
            && let Some(light) = lights.get_mut(light)
        {
            set_light_field(light, field, value);
        }
    }
}

/// Sets a field of a light by name; a value of another shape changes nothing.
pub fn set_light_field(light: &mut Light, field: &str, value: &Value) {
    let numbers = numbers_of(value).unwrap_or_default();
    let vector = || <[f64; 3]>::try_from(numbers.get(..3)?).ok();
    let number = numbers.first().copied();
    let (slot, number) = match field {
        "direction" | "position" | "aim" | "color" => {
            let Some(v) = vector() else { return };
            match field {
                "direction" => light.direction = v,
                "position" => light.position = v,
                "aim" => light.aim = v,
                _ => light.color = v,
            }
            return;
        }
        "intensity" => (&mut light.intensity, number),
        "inner" => (&mut light.inner, number),
        "outer" => (&mut light.outer, number),
        "half_distance" => (&mut light.half_distance, number),
        "range" => (&mut light.range, number),
        _ => return,
    };
    if let Some(number) = number {
        *slot = number;
    }
}
