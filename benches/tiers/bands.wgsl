import chiaro::antialias;

fn nothing(n: vec3f, l: vec3f, s: f32) -> f32 {
    return n.x + s;
}

fn exact(n: vec3f, l: vec3f, s: f32) -> f32 {
    let w = footprint_of(n.x);
    let count = 4.0 + f32(repeats.y);
    let x = count * clamp(bounded(n.x), 0.0, 1.0);
    return clamp(stairs_filtered(x, count, edge_width(count * w, 0.0)) / (count - 1.0), 0.0, 1.0);
}

/// Bands with one edge at a time, whose width is the sum of both derivatives.
fn width_by_sum(n: vec3f, l: vec3f, s: f32) -> f32 {
    let count = 4.0 + f32(repeats.y);
    let x = count * clamp(bounded(n.x), 0.0, 1.0);
    let w = min(abs(dpdx(x)) + abs(dpdy(x)), 1.0);
    let edge = clamp(round(x), 1.0, count - 1.0);
    let step = select(clamp(0.5 + (x - edge) / max(w, 1e-30), 0.0, 1.0),
        select(0.0, 1.0, x >= edge), w < 1e-30);
    return (edge - 1.0 + step) / (count - 1.0);
}

fn hard(n: vec3f, l: vec3f, s: f32) -> f32 {
    let count = 4.0 + f32(repeats.y);
    return min(floor(count * clamp(bounded(n.x), 0.0, 1.0)), count - 1.0) / (count - 1.0);
}

fn kept_balanced(n: vec3f, l: vec3f, s: f32) -> f32 {
    let count = 4.0 + f32(repeats.y);
    let tone = clamp(bounded(n.x), 0.0, 1.0);
    return stairs_quick(count * tone, count,
        edge_width(count * footprint_by_sum(tone), 0.0)) / (count - 1.0);
}

fn kept_fast(n: vec3f, l: vec3f, s: f32) -> f32 {
    let count = 4.0 + f32(repeats.y);
    return stairs_quick(count * clamp(bounded(n.x), 0.0, 1.0), count,
        edge_width(0.0, 0.0)) / (count - 1.0);
}
