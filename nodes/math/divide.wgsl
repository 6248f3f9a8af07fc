import chiaro::types;
import chiaro::total;

/// Divide
///
/// A divided by B, component by component. Dividing by 0 gives 0. A color keeps the alpha of A.
///
/// @param a "A" default=1 : This is divided.
/// @param b "B" default=1 : By this.
/// @return quotient "Quotient" : A / B; 0 where B is 0.
/// @bypass a when b = 1 : it divides by 1
/// @bypass a when a = 0 : what it divides is 0
fn divide(a: f32, b: f32) -> f32 {
    return divided(a, b);
}

fn divide_vec2(a: vec2f, b: vec2f) -> vec2f {
    return vec2f(divided(a.x, b.x), divided(a.y, b.y));
}

fn divide_vec3(a: vec3f, b: vec3f) -> vec3f {
    return vec3f(divided(a.x, b.x), divided(a.y, b.y), divided(a.z, b.z));
}

fn divide_vec4(a: vec4f, b: vec4f) -> vec4f {
    return vec4f(divided(a.x, b.x), divided(a.y, b.y), divided(a.z, b.z), divided(a.w, b.w));
}

fn divide_color(a: Color, b: Color) -> Color {
    return vec4f(divided(a.x, b.x), divided(a.y, b.y), divided(a.z, b.z), bounded(a.w));
}
