import chiaro::total;

/// Negate
///
/// The number with the other sign.
///
/// @param value "Value" default=0 : What is negated.
/// @return value "Value" : -value.
fn negate(value: f32) -> f32 {
    return bounded(-value);
}

fn negate_vec2(value: vec2f) -> vec2f {
    return bounded_vec2(-value);
}

fn negate_vec3(value: vec3f) -> vec3f {
    return bounded_vec3(-value);
}

fn negate_vec4(value: vec4f) -> vec4f {
    return bounded_vec4(-value);
}
