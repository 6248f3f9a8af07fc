// Functions of the library that read the bits of floats, in forms without them: OSL has no bits of
// floats.

/// True if x is neither NaN nor infinite.
fn is_finite(x: f32) -> bool {
    return abs(x) <= 3.4028234e38;
}

/// v with 0 for each component that is NaN or infinite.
fn finite_vec3(v: vec3f) -> vec3f {
    return select(vec3f(0.0), v, abs(v) <= vec3f(3.4028234e38));
}

/// v with 0 for each component that is NaN or infinite.
fn finite_vec4(v: vec4f) -> vec4f {
    return select(vec4f(0.0), v, abs(v) <= vec4f(3.4028234e38));
}

/// x where it is finite, 0 where it is NaN, the largest number of its sign where it is infinite.
fn bounded(x: f32) -> f32 {
    return select(0.0, clamp(x, -3.4028234e38, 3.4028234e38), x == x);
}

/// [`bounded`], component by component.
fn bounded_vec2(v: vec2f) -> vec2f {
    return select(vec2f(0.0), clamp(v, vec2f(-3.4028234e38), vec2f(3.4028234e38)), v == v);
}

/// [`bounded`], component by component.
fn bounded_vec3(v: vec3f) -> vec3f {
    return select(vec3f(0.0), clamp(v, vec3f(-3.4028234e38), vec3f(3.4028234e38)), v == v);
}

/// [`bounded`], component by component.
fn bounded_vec4(v: vec4f) -> vec4f {
    return select(vec4f(0.0), clamp(v, vec4f(-3.4028234e38), vec4f(3.4028234e38)), v == v);
}

/// 2^x. 0 below -125.5, the largest finite number above 128.
fn exp2_stable(x: f32) -> f32 {
    return exp2(clamp(x, -126.0, 127.999992));
}

/// 2^n.
fn power_of_two(n: i32) -> f32 {
    return exp2(f32(n));
}

/// log2(x) for normal x > 0.
fn log2_stable(x: f32) -> f32 {
    return log2(x);
}

/// The name of a whole place's line in an octave: an odd number and the octave that the line first
/// lies in. The line at 0 lies in all.
fn line_of(whole: i32, octave: i32) -> vec2i {
    let power = select(whole & -whole, 1, whole == 0);
    let octaves = i32(round(log2(f32(power))));
    return select(vec2i(whole / power, octave - octaves), vec2i(0), whole == 0);
}
