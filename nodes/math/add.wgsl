import chiaro::types;
import chiaro::total;

/// Add
///
/// The sum of two numbers, vectors or colors. A color keeps the alpha of A.
///
/// @param a "A" default=0 : The one.
/// @param b "B" default=0 : The other.
/// @return sum "Sum" : A + B.
/// @bypass a when b = 0 : it adds 0
fn add(a: f32, b: f32) -> f32 {
    return bounded(a + b);
}

fn add_vec2(a: vec2f, b: vec2f) -> vec2f {
    return bounded_vec2(a + b);
}

fn add_vec3(a: vec3f, b: vec3f) -> vec3f {
    return bounded_vec3(a + b);
}

fn add_vec4(a: vec4f, b: vec4f) -> vec4f {
    return bounded_vec4(a + b);
}

fn add_color(a: Color, b: Color) -> Color {
    return vec4f(bounded_vec3(a.xyz + b.xyz), bounded(a.w));
}
