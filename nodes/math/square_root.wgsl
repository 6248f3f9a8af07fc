import chiaro::total;

/// Square root
///
/// The number that gives this one when multiplied with itself. Below 0 it is 0.
///
/// @param value "Value" default=1 : What the root is taken of.
/// @return root "Root" : 0 or more.
fn square_root(value: f32) -> f32 {
    return sqrt(max(bounded(value), 0.0));
}

fn square_root_vec2(value: vec2f) -> vec2f {
    return sqrt(max(bounded_vec2(value), vec2f(0.0)));
}

fn square_root_vec3(value: vec3f) -> vec3f {
    return sqrt(max(bounded_vec3(value), vec3f(0.0)));
}

fn square_root_vec4(value: vec4f) -> vec4f {
    return sqrt(max(bounded_vec4(value), vec4f(0.0)));
}
