import chiaro::antialias;

fn nothing(n: vec3f, l: vec3f, s: f32) -> f32 {
    return n.x + s;
}

fn exact(n: vec3f, l: vec3f, s: f32) -> f32 {
    let w = footprint_of(n.x);
    return step_filtered(bounded(n.x), bounded(0.3 * s), edge_width(w, 0.0));
}

/// Threshold with the sum of both derivatives in place of the gradient's length.
fn width_by_sum(n: vec3f, l: vec3f, s: f32) -> f32 {
    let w = abs(dpdx(n.x)) + abs(dpdy(n.x));
    return clamp(0.5 + (n.x - 0.3 * s) / max(w, 1e-30), 0.0, 1.0);
}

fn width_by_sum_total(n: vec3f, l: vec3f, s: f32) -> f32 {
    let w = bounded(abs(dpdx(n.x)) + abs(dpdy(n.x)));
    return step_filtered(bounded(n.x), bounded(0.3 * s), max(w, 0.0));
}

fn hard(n: vec3f, l: vec3f, s: f32) -> f32 {
    return select(0.0, 1.0, n.x >= 0.3 * s);
}

fn kept_balanced(n: vec3f, l: vec3f, s: f32) -> f32 {
    let x = bounded(n.x);
    return step_quick(x, bounded(0.3 * s), edge_width(footprint_by_sum(x), 0.0));
}

fn kept_fast(n: vec3f, l: vec3f, s: f32) -> f32 {
    return step_quick(bounded(n.x), bounded(0.3 * s), edge_width(0.0, 0.0));
}
