import chiaro::types;
import chiaro::total;

/// Clamp
///
/// Keeps a number between two others. Where low is above high, everything is high. A color's alpha
/// is kept within 0 and 1.
///
/// @param value "Value" default=0 : What is kept in.
/// @param low "Low" default=0 : Nothing is below this.
/// @param high "High" default=1 : Nothing is above this.
/// @return value "Value" : From low to high.
/// @bypass value when value = unit and low = 0 and high = 1 : its value lies between 0 and 1
///   already
/// @bypass value when value >= low and value <= high and value = unit_alpha : its value never
///   leaves its range
/// @unit when low = 0 and high = 1
fn clamp_range(value: f32, low: f32, high: f32) -> f32 {
    return min(max(bounded(value), bounded(low)), bounded(high));
}

fn clamp_range_vec2(value: vec2f, low: f32, high: f32) -> vec2f {
    return min(max(bounded_vec2(value), vec2f(bounded(low))), vec2f(bounded(high)));
}

fn clamp_range_vec3(value: vec3f, low: f32, high: f32) -> vec3f {
    return min(max(bounded_vec3(value), vec3f(bounded(low))), vec3f(bounded(high)));
}

fn clamp_range_vec4(value: vec4f, low: f32, high: f32) -> vec4f {
    return min(max(bounded_vec4(value), vec4f(bounded(low))), vec4f(bounded(high)));
}

fn clamp_range_color(value: Color, low: f32, high: f32) -> Color {
    let rgb = min(max(bounded_vec3(value.xyz), vec3f(bounded(low))), vec3f(bounded(high)));
    return vec4f(rgb, factor_of(value.w, true));
}
