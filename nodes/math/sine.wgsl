import chiaro::total;

/// Sine
///
/// A wave that starts at 0 and rises; it repeats after a full turn.
///
/// @param angle "Angle" unit=rad default=0 : Any angle.
/// @return sine "Sine" : From -1 to 1.
fn sine(angle: f32) -> f32 {
    return sin_cos_of(angle).x;
}

fn sine_vec2(angle: vec2f) -> vec2f {
    return vec2f(sin_cos_of(angle.x).x, sin_cos_of(angle.y).x);
}

fn sine_vec3(angle: vec3f) -> vec3f {
    return vec3f(sin_cos_of(angle.x).x, sin_cos_of(angle.y).x, sin_cos_of(angle.z).x);
}

fn sine_vec4(angle: vec4f) -> vec4f {
    return vec4f(sin_cos_of(angle.x).x, sin_cos_of(angle.y).x, sin_cos_of(angle.z).x,
        sin_cos_of(angle.w).x);
}
