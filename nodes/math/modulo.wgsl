import chiaro::total;

/// Modulo
///
/// What is left of A after taking B away as often as it goes: repeats a pattern, also below 0. By 0
/// it is 0.
///
/// @param a "A" default=0 : What is repeated.
/// @param b "B" default=1 : The length of one repetition.
/// @return rest "Rest" : From 0 up to B, without B.
fn modulo(a: f32, b: f32) -> f32 {
    return modulo_floored(a, b);
}

fn modulo_vec2(a: vec2f, b: vec2f) -> vec2f {
    return vec2f(modulo_floored(a.x, b.x), modulo_floored(a.y, b.y));
}

fn modulo_vec3(a: vec3f, b: vec3f) -> vec3f {
    return vec3f(modulo_floored(a.x, b.x), modulo_floored(a.y, b.y), modulo_floored(a.z, b.z));
}

fn modulo_vec4(a: vec4f, b: vec4f) -> vec4f {
    return vec4f(
        modulo_floored(a.x, b.x),
        modulo_floored(a.y, b.y),
        modulo_floored(a.z, b.z),
        modulo_floored(a.w, b.w),
    );
}
