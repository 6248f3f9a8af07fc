import chiaro::angle;

fn nothing(n: vec3f, l: vec3f, s: f32) -> f32 {
    return n.x + l.y;
}

fn exact(n: vec3f, l: vec3f, s: f32) -> f32 {
    let u = angle_between(n, l);
    return u.half_sin + 2.0 * u.half_cos;
}

/// Angle by halved chords, for vectors that are known to be unit.
fn unit_chords(n: vec3f, l: vec3f, s: f32) -> f32 {
    let u = Angle(0.5 * length(n - l), 0.5 * length(n + l));
    return u.half_sin + 2.0 * u.half_cos;
}

/// Angle by half-angle formulas of the dot product.
fn half_dot(n: vec3f, l: vec3f, s: f32) -> f32 {
    let c = 0.5 * dot(n, l);
    let u = Angle(sqrt(max(0.5 - c, 0.0)), sqrt(max(0.5 + c, 0.0)));
    return u.half_sin + 2.0 * u.half_cos;
}

/// Angle by one chord; the other half by Pythagoras.
fn one_chord(n: vec3f, l: vec3f, s: f32) -> f32 {
    let d = n - l;
    let square = min(0.25 * dot(d, d), 1.0);
    let u = Angle(sqrt(square), sqrt(1.0 - square));
    return u.half_sin + 2.0 * u.half_cos;
}

fn hardware_acos(n: vec3f, l: vec3f, s: f32) -> f32 {
    let h = 0.5 * acos(clamp(dot(n, l), -1.0, 1.0));
    return sin(h) + 2.0 * cos(h);
}

/// Angle by the arc cosine of Abramowitz and Stegun 4.4.45, and the hardware's sine and cosine.
fn polynomial_acos(n: vec3f, l: vec3f, s: f32) -> f32 {
    let c = clamp(dot(n, l), -1.0, 1.0);
    let a = abs(c);
    let p = sqrt(1.0 - a) * (1.5707288 + a * (-0.2121144 + a * (0.0742610 - a * 0.0187293)));
    let h = 0.5 * select(p, 3.14159265 - p, c < 0.0);
    return sin(h) + 2.0 * cos(h);
}
