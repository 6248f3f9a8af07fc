import chiaro::types;
import chiaro::total;

/// Mix
///
/// Goes from A to B by a factor, in numbers, vectors and colors (with their alpha).
///
/// @param a "A" default=0 : Where the factor is 0.
/// @param b "B" default=1 : Where the factor is 1.
/// @param factor "Factor" default=0.5 min=0 max=1 : How much of B.
/// @param clamped "Clamp" default=true : Keeps the factor between 0 and 1; without, it goes on
///   beyond A and B.
/// @return value "Value" : Between A and B.
/// @bypass a when factor = 0 : its factor is 0
/// @bypass b when factor = 1 : its factor is 1
/// @bypass a when a = b : A and B are the same
/// @bypass a when factor <= 0 and clamped = 1 : its factor is never above 0
/// @bypass b when factor >= 1 and clamped = 1 : its factor is never below 1
fn mix_values(a: f32, b: f32, factor: f32, clamped: bool) -> f32 {
    return mixed(bounded(a), bounded(b), factor_of(factor, clamped));
}

fn mix_values_vec2(a: vec2f, b: vec2f, factor: f32, clamped: bool) -> vec2f {
    return mixed_vec2(bounded_vec2(a), bounded_vec2(b), factor_of(factor, clamped));
}

fn mix_values_vec3(a: vec3f, b: vec3f, factor: f32, clamped: bool) -> vec3f {
    return mixed_vec3(bounded_vec3(a), bounded_vec3(b), factor_of(factor, clamped));
}

fn mix_values_vec4(a: vec4f, b: vec4f, factor: f32, clamped: bool) -> vec4f {
    return mixed_vec4(bounded_vec4(a), bounded_vec4(b), factor_of(factor, clamped));
}

fn mix_values_color(a: Color, b: Color, factor: f32, clamped: bool) -> Color {
    return mixed_vec4(bounded_vec4(a), bounded_vec4(b), factor_of(factor, clamped));
}
