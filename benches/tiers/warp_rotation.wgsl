import chiaro::angle;

fn nothing(n: vec3f, l: vec3f, s: f32) -> f32 {
    return n.x + s;
}

fn angle_here(n: vec3f) -> Angle {
    return Angle(sqrt(0.5 - 0.5 * n.x), sqrt(0.5 + 0.5 * n.x));
}

fn exact(n: vec3f, l: vec3f, s: f32) -> f32 {
    let u = angle_shifted(angle_here(n), s * 1.5);
    return u.half_sin + 2.0 * u.half_cos;
}

fn rotated(u: Angle, t: vec2f) -> f32 {
    let a = clamp(u.half_sin * t.y - u.half_cos * t.x, 0.0, 1.0);
    let c = clamp(u.half_cos * t.y + u.half_sin * t.x, 0.0, 1.0);
    return a + 2.0 * c;
}

fn hardware_sin_cos(n: vec3f, l: vec3f, s: f32) -> f32 {
    let h = 0.5 * clamp(s * 1.5, -PI, PI);
    return rotated(angle_here(n), vec2f(sin(h), cos(h)));
}

/// Rotation by short polynomials of the quarter turn, without halving (error 1.6e-4).
fn short_polynomials(n: vec3f, l: vec3f, s: f32) -> f32 {
    let h = 0.5 * clamp(s * 1.5, -PI, PI);
    let h2 = h * h;
    let t = vec2f(h * (1.0 + h2 * (-0.166666 + h2 * (0.00831 - h2 * 0.000184))),
        1.0 + h2 * (-0.49999 + h2 * (0.04158 - h2 * 0.0012706)));
    return rotated(angle_here(n), t);
}

/// A rational rotation by the tangent of the quarter angle (no trigonometry at all): tan(h/2) as a
/// polynomial.
fn rational(n: vec3f, l: vec3f, s: f32) -> f32 {
    let h = 0.5 * clamp(s * 1.5, -PI, PI);
    let h2 = h * h;
    let t = h * (0.5 + h2 * (0.0416667 + h2 * (0.0041667 + h2 * 0.00055)));
    let k = 1.0 / (1.0 + t * t);
    return rotated(angle_here(n), vec2f(2.0 * t * k, (1.0 - t * t) * k));
}
