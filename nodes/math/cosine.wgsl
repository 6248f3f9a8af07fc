import chiaro::total;

/// Cosine
///
/// A wave that starts at 1 and falls; it repeats after a full turn.
///
/// @param angle "Angle" unit=rad default=0 : Any angle.
/// @return cosine "Cosine" : From -1 to 1.
fn cosine(angle: f32) -> f32 {
    return cosine_of(angle);
}

fn cosine_vec2(angle: vec2f) -> vec2f {
    return vec2f(cosine_of(angle.x), cosine_of(angle.y));
}

fn cosine_vec3(angle: vec3f) -> vec3f {
    return vec3f(cosine_of(angle.x), cosine_of(angle.y), cosine_of(angle.z));
}

fn cosine_vec4(angle: vec4f) -> vec4f {
    return vec4f(cosine_of(angle.x), cosine_of(angle.y), cosine_of(angle.z),
        cosine_of(angle.w));
}
