import chiaro::types;
import chiaro::total;

/// Minimum
///
/// The smaller of two numbers, component by component. A color keeps the alpha of A.
///
/// @param a "A" default=0 : The one.
/// @param b "B" default=0 : The other.
/// @return minimum "Minimum" : The smaller one.
/// @bypass a when a = b : both are the same
/// @bypass a when a <= b : A is never above B
fn minimum(a: f32, b: f32) -> f32 {
    return min(bounded(a), bounded(b));
}

fn minimum_vec2(a: vec2f, b: vec2f) -> vec2f {
    return min(bounded_vec2(a), bounded_vec2(b));
}

fn minimum_vec3(a: vec3f, b: vec3f) -> vec3f {
    return min(bounded_vec3(a), bounded_vec3(b));
}

fn minimum_vec4(a: vec4f, b: vec4f) -> vec4f {
    return min(bounded_vec4(a), bounded_vec4(b));
}

fn minimum_color(a: Color, b: Color) -> Color {
    return vec4f(min(bounded_vec3(a.xyz), bounded_vec3(b.xyz)), bounded(a.w));
}
