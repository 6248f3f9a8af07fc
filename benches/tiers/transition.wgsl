import chiaro::curvature;

fn nothing(n: vec3f, l: vec3f, s: f32) -> f32 {
    return n.x + s;
}

fn exact(n: vec3f, l: vec3f, s: f32) -> f32 {
    return curvature_signed(n.x * 60.0, 0.05 + s * 0.01);
}

fn finite_argument(n: vec3f, s: f32) -> f32 {
    return kappa_safe(n.x * 60.0) * clamp(finite_or(0.05 + s * 0.01, 0.0), -1e30, 1e30);
}

fn hardware_tanh(n: vec3f, l: vec3f, s: f32) -> f32 {
    return tanh(clamp(finite_argument(n, s), -20.0, 20.0));
}

fn hardware_exp2(n: vec3f, l: vec3f, s: f32) -> f32 {
    let a = clamp(finite_argument(n, s), -20.0, 20.0);
    return 1.0 - 2.0 / (1.0 + exp2(2.8853901 * a));
}

/// Transition by a continued fraction to a^5 over a^4 (error 6e-4), clamped.
fn rational_5(n: vec3f, l: vec3f, s: f32) -> f32 {
    let a = clamp(finite_argument(n, s), -3.6467, 3.6467);
    let a2 = a * a;
    return clamp(a * (945.0 + a2 * (105.0 + a2)) / (945.0 + a2 * (420.0 + a2 * 15.0)), -1.0, 1.0);
}

/// Transition by a continued fraction to a^7 over a^6 (error 1e-4), clamped.
fn rational_7(n: vec3f, l: vec3f, s: f32) -> f32 {
    let a = clamp(finite_argument(n, s), -4.97, 4.97);
    let a2 = a * a;
    let above = a * (135135.0 + a2 * (17325.0 + a2 * (378.0 + a2)));
    return clamp(above / (135135.0 + a2 * (62370.0 + a2 * (3150.0 + a2 * 28.0))), -1.0, 1.0);
}

/// The exact form without its series near 0.
fn without_series(n: vec3f, l: vec3f, s: f32) -> f32 {
    let a = finite_argument(n, s);
    let z = exp2_stable(-2.0 * LOG2_E * min(abs(a), 50.0));
    let t = (1.0 - z) / (1.0 + z);
    return select(-t, t, a >= 0.0);
}

fn kept_balanced(n: vec3f, l: vec3f, s: f32) -> f32 {
    return curvature_signed_balanced(n.x * 60.0, 0.05 + s * 0.01);
}

fn kept_fast(n: vec3f, l: vec3f, s: f32) -> f32 {
    return curvature_signed_fast(n.x * 60.0, 0.05 + s * 0.01);
}
