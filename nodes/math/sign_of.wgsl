import chiaro::total;

/// Sign
///
/// Which side of 0 a number is on: -1 below, 0 at 0, 1 above.
///
/// @param value "Value" default=0 : Any number.
/// @return sign "Sign" : -1, 0 or 1.
fn sign_of(value: f32) -> f32 {
    return sign(bounded(value));
}

fn sign_of_vec2(value: vec2f) -> vec2f {
    return sign(bounded_vec2(value));
}

fn sign_of_vec3(value: vec3f) -> vec3f {
    return sign(bounded_vec3(value));
}

fn sign_of_vec4(value: vec4f) -> vec4f {
    return sign(bounded_vec4(value));
}
