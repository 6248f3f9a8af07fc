import chiaro::types;
import chiaro::total;

/// Subtract
///
/// What is left of A when B is taken away. A color keeps the alpha of A.
///
/// @param a "A" default=0 : From this.
/// @param b "B" default=0 : This is taken away.
/// @return difference "Difference" : A - B.
/// @bypass a when b = 0 : it takes away 0
fn subtract(a: f32, b: f32) -> f32 {
    return bounded(a - b);
}

fn subtract_vec2(a: vec2f, b: vec2f) -> vec2f {
    return bounded_vec2(a - b);
}

fn subtract_vec3(a: vec3f, b: vec3f) -> vec3f {
    return bounded_vec3(a - b);
}

fn subtract_vec4(a: vec4f, b: vec4f) -> vec4f {
    return bounded_vec4(a - b);
}

fn subtract_color(a: Color, b: Color) -> Color {
    return vec4f(bounded_vec3(a.xyz - b.xyz), bounded(a.w));
}
