import chiaro::total;

/// Fraction
///
/// What a number has after the point, counted upward also below 0: a saw that rises from 0 to 1
/// again and again.
///
/// @param value "Value" default=0 : Any number.
/// @return fraction "Fraction" : From 0 up to 1, without 1.
/// @unit
fn fraction(value: f32) -> f32 {
    return modulo_floored(value, 1.0);
}

fn fraction_vec2(value: vec2f) -> vec2f {
    return vec2f(modulo_floored(value.x, 1.0), modulo_floored(value.y, 1.0));
}

fn fraction_vec3(value: vec3f) -> vec3f {
    return vec3f(modulo_floored(value.x, 1.0), modulo_floored(value.y, 1.0),
        modulo_floored(value.z, 1.0));
}

fn fraction_vec4(value: vec4f) -> vec4f {
    return vec4f(
        modulo_floored(value.x, 1.0),
        modulo_floored(value.y, 1.0),
        modulo_floored(value.z, 1.0),
        modulo_floored(value.w, 1.0),
    );
}
