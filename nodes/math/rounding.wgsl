import chiaro::total;

/// Rounding
///
/// Makes a number whole.
///
/// @choice mode "Mode" default=nearest nearest="Nearest" floor="Down" ceiling="Up" : Which one;
///   halfway, Nearest takes the even one.
/// @param value "Value" default=0 : Any number.
/// @return value "Value" : A whole number.
fn rounding_nearest(value: f32) -> f32 {
    return round(bounded(value));
}

fn rounding_nearest_vec2(value: vec2f) -> vec2f {
    return round(bounded_vec2(value));
}

fn rounding_nearest_vec3(value: vec3f) -> vec3f {
    return round(bounded_vec3(value));
}

fn rounding_nearest_vec4(value: vec4f) -> vec4f {
    return round(bounded_vec4(value));
}

fn rounding_floor(value: f32) -> f32 {
    return floor(bounded(value));
}

fn rounding_floor_vec2(value: vec2f) -> vec2f {
    return floor(bounded_vec2(value));
}

fn rounding_floor_vec3(value: vec3f) -> vec3f {
    return floor(bounded_vec3(value));
}

fn rounding_floor_vec4(value: vec4f) -> vec4f {
    return floor(bounded_vec4(value));
}

fn rounding_ceiling(value: f32) -> f32 {
    return ceil(bounded(value));
}

fn rounding_ceiling_vec2(value: vec2f) -> vec2f {
    return ceil(bounded_vec2(value));
}

fn rounding_ceiling_vec3(value: vec3f) -> vec3f {
    return ceil(bounded_vec3(value));
}

fn rounding_ceiling_vec4(value: vec4f) -> vec4f {
    return ceil(bounded_vec4(value));
}
