import chiaro::total;

/// Smooth step
///
/// Eases from 0 to 1 between two numbers, slowly at both ends. With low above high it eases from 1
/// to 0; where both are the same it is a step.
///
/// @param value "Value" default=0 : What eases.
/// @param low "Low" default=0 : 0 up to here.
/// @param high "High" default=1 : 1 from here on.
/// @return value "Value" : From 0 to 1.
/// @unit
fn smooth_step_value(value: f32, low: f32, high: f32) -> f32 {
    return eased(value, low, high);
}

fn smooth_step_value_vec2(value: vec2f, low: f32, high: f32) -> vec2f {
    return vec2f(eased(value.x, low, high), eased(value.y, low, high));
}

fn smooth_step_value_vec3(value: vec3f, low: f32, high: f32) -> vec3f {
    return vec3f(eased(value.x, low, high), eased(value.y, low, high), eased(value.z, low, high));
}

fn smooth_step_value_vec4(value: vec4f, low: f32, high: f32) -> vec4f {
    return vec4f(
        eased(value.x, low, high),
        eased(value.y, low, high),
        eased(value.z, low, high),
        eased(value.w, low, high),
    );
}
