enable f16;
import chiaro::curvature;

fn nothing(n: vec3f, l: vec3f, s: f32) -> f32 {
    return n.x + s;
}

/// The rational form of the transition in 32 bits.
fn exact(n: vec3f, l: vec3f, s: f32) -> f32 {
    let a = clamp(n.x * 3.0, -3.6467, 3.6467);
    let a2 = a * a;
    return clamp(a * (945.0 + a2 * (105.0 + a2)) / (945.0 + a2 * (420.0 + a2 * 15.0)), -1.0, 1.0);
}

/// The rational form of the transition in 16 bits.
fn half_precision(n: vec3f, l: vec3f, s: f32) -> f32 {
    let a = f16(clamp(n.x * 3.0, -3.6467, 3.6467));
    let a2 = a * a;
    return f32(clamp(a * (9.45h + a2 * (1.05h + a2 * 0.01h)) / (9.45h + a2 * (4.2h + a2 * 0.15h)),
        -1.0h, 1.0h));
}
