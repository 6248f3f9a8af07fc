import chiaro::numeric;

fn nothing(n: vec3f, l: vec3f, s: f32) -> f32 {
    return n.x * 1.5 + n.y + n.z;
}

fn exact(n: vec3f, l: vec3f, s: f32) -> f32 {
    let v = normalize_or(1.5 * n, vec3f(0.0, 0.0, 1.0));
    return v.x + 1.5 * v.y + v.z;
}

/// Normalization guarded at the square alone: vectors below 1e-15 or beyond 1e18 have no direction.
fn guarded_square(n: vec3f, l: vec3f, s: f32) -> f32 {
    let w = 1.5 * n;
    let square = dot(w, w);
    let is_usable = square > 1e-30 && square < 3e38;
    let v = select(vec3f(0.0, 0.0, 1.0), w * inverseSqrt(max(square, 1e-30)), is_usable);
    return v.x + 1.5 * v.y + v.z;
}

/// No normalization in the fragment, as if done per vertex.
fn per_vertex(n: vec3f, l: vec3f, s: f32) -> f32 {
    let v = 1.5 * n;
    return v.x + 1.5 * v.y + v.z;
}
