import chiaro::angle;

fn nothing(n: vec3f, l: vec3f, s: f32) -> f32 {
    return n.x * 1.5 + l.y;
}

/// Diffuse parametrization of a normalized normal.
fn exact(n: vec3f, l: vec3f, s: f32) -> f32 {
    let u = angle_between(normalize_or(1.5 * n, vec3f(0.0, 0.0, 1.0)), l);
    return u.half_sin + 2.0 * u.half_cos;
}

fn kept_balanced(n: vec3f, l: vec3f, s: f32) -> f32 {
    let u = angle_of_units(normalize_quick(1.5 * n, vec3f(0.0, 0.0, 1.0)), l);
    return u.half_sin + 2.0 * u.half_cos;
}

fn half_dot(n: vec3f, l: vec3f, s: f32) -> f32 {
    let c = 0.5 * dot(normalize_quick(1.5 * n, vec3f(0.0, 0.0, 1.0)), l);
    let u = Angle(sqrt(max(0.5 - c, 0.0)), sqrt(max(0.5 + c, 0.0)));
    return u.half_sin + 2.0 * u.half_cos;
}
