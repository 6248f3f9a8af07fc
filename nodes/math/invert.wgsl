import chiaro::types;
import chiaro::total;

/// Invert
///
/// 1 minus the number: light becomes dark, a mask becomes what it left out. A color keeps its
/// alpha.
///
/// @param value "Value" default=0 : What is inverted.
/// @return value "Value" : 1 - value.
/// @unit when value = unit
fn invert(value: f32) -> f32 {
    return bounded(1.0 - value);
}

fn invert_vec2(value: vec2f) -> vec2f {
    return bounded_vec2(1.0 - value);
}

fn invert_vec3(value: vec3f) -> vec3f {
    return bounded_vec3(1.0 - value);
}

fn invert_vec4(value: vec4f) -> vec4f {
    return bounded_vec4(1.0 - value);
}

fn invert_color(value: Color) -> Color {
    return vec4f(bounded_vec3(1.0 - value.xyz), bounded(value.w));
}
