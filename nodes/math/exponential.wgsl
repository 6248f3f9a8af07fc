import chiaro::total;

/// Exponential
///
/// e raised to a power: grows ever faster, and fades toward 0 below 0. From 88.7 on it stays at the
/// largest number.
///
/// @param value "Value" default=0 : The power.
/// @return value "Value" : e^value, 0 or more.
fn exponential(value: f32) -> f32 {
    return exponential_of(value);
}

fn exponential_vec2(value: vec2f) -> vec2f {
    return vec2f(exponential_of(value.x), exponential_of(value.y));
}

fn exponential_vec3(value: vec3f) -> vec3f {
    return vec3f(exponential_of(value.x), exponential_of(value.y), exponential_of(value.z));
}

fn exponential_vec4(value: vec4f) -> vec4f {
    return vec4f(exponential_of(value.x), exponential_of(value.y), exponential_of(value.z),
        exponential_of(value.w));
}
