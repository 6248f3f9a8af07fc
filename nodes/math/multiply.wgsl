import chiaro::types;
import chiaro::total;

/// Multiply
///
/// The product of two numbers, vectors or colors, component by component: scales, masks and tints.
///
/// @param a "A" default=1 : The one.
/// @param b "B" default=1 : The other.
/// @return product "Product" : A times B.
/// @bypass a when b = 1 : it multiplies by 1
/// @bypass b when a = 1 : it multiplies by 1
/// @bypass a when a = 0 : one of its factors is 0
/// @bypass b when b = 0 : one of its factors is 0
fn multiply(a: f32, b: f32) -> f32 {
    return bounded(a * b);
}

fn multiply_vec2(a: vec2f, b: vec2f) -> vec2f {
    return bounded_vec2(a * b);
}

fn multiply_vec3(a: vec3f, b: vec3f) -> vec3f {
    return bounded_vec3(a * b);
}

fn multiply_vec4(a: vec4f, b: vec4f) -> vec4f {
    return bounded_vec4(a * b);
}

fn multiply_color(a: Color, b: Color) -> Color {
    return bounded_vec4(a * b);
}
