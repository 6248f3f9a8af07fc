import chiaro::total;

/// Sine
///
/// A wave that starts at 0 and rises; it repeats after a full turn.
///
/// @param angle "Angle" unit=rad default=0 : Any angle.
/// @return sine "Sine" : From -1 to 1.
fn sine(angle: f32) -> f32 {
    return sine_of(angle);
}

fn sine_vec2(angle: vec2f) -> vec2f {
    return vec2f(sine_of(angle.x), sine_of(angle.y));
}

fn sine_vec3(angle: vec3f) -> vec3f {
    return vec3f(sine_of(angle.x), sine_of(angle.y), sine_of(angle.z));
}

fn sine_vec4(angle: vec4f) -> vec4f {
    return vec4f(sine_of(angle.x), sine_of(angle.y), sine_of(angle.z),
        sine_of(angle.w));
}
