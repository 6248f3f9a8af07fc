import chiaro::total;

/// Absolute
///
/// The number without its sign.
///
/// @param value "Value" default=0 : Any number.
/// @return value "Value" : 0 or more.
fn absolute(value: f32) -> f32 {
    return bounded(abs(value));
}

fn absolute_vec2(value: vec2f) -> vec2f {
    return bounded_vec2(abs(value));
}

fn absolute_vec3(value: vec3f) -> vec3f {
    return bounded_vec3(abs(value));
}

fn absolute_vec4(value: vec4f) -> vec4f {
    return bounded_vec4(abs(value));
}
