import chiaro::total;

/// Cosine
///
/// A wave that starts at 1 and falls; it repeats after a full turn.
///
/// @param angle "Angle" unit=rad default=0 : Any angle.
/// @return cosine "Cosine" : From -1 to 1.
fn cosine(angle: f32) -> f32 {
    return sin_cos_of(angle).y;
}

fn cosine_vec2(angle: vec2f) -> vec2f {
    return vec2f(sin_cos_of(angle.x).y, sin_cos_of(angle.y).y);
}

fn cosine_vec3(angle: vec3f) -> vec3f {
    return vec3f(sin_cos_of(angle.x).y, sin_cos_of(angle.y).y, sin_cos_of(angle.z).y);
}

fn cosine_vec4(angle: vec4f) -> vec4f {
    return vec4f(sin_cos_of(angle.x).y, sin_cos_of(angle.y).y, sin_cos_of(angle.z).y,
        sin_cos_of(angle.w).y);
}
