import chiaro::curve;

fn nothing(n: vec3f, l: vec3f, s: f32) -> f32 {
    return n.x + s;
}

fn curve_here() -> Curve {
    var points: array<vec4f, 16>;
    let zero = f32(repeats.y);
    for (var i = 0; i < 5; i++) {
        points[i] = vec4f(f32(i) * 0.25 + zero, f32(i * i) * 0.06 + zero, 1.0, 0.0);
    }
    return Curve(points, 5u + repeats.y, 1u + repeats.y);
}

fn exact(n: vec3f, l: vec3f, s: f32) -> f32 {
    let w = footprint_of(n.x);
    return curve_at(curve_here(), bounded(n.x), w);
}

/// Curve without antialiasing of its steps.
fn not_filtered(n: vec3f, l: vec3f, s: f32) -> f32 {
    return curve_at(curve_here(), bounded(n.x), 0.0);
}
