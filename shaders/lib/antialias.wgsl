// Edges and stripes averaged over a pixel (docs/math.md 2.4). Every footprint is the length of the
// screen-space gradient, taken before any branch; where it is 0, as on a swatch or at a single
// sample, edges are hard and inclusive.
import chiaro::numeric;
import chiaro::total;

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return bounded(sqrt(dot(d, d)));
}

/// Change of each of a point's coordinates over one pixel, finite. Call it in uniform control flow.
fn footprint_of_vec2(v: vec2f) -> vec2f {
    let dx = dpdx(v);
    let dy = dpdy(v);
    return bounded_vec2(sqrt(dx * dx + dy * dy));
}

/// Distance that a point moves over one pixel: the longer of its two derivatives, finite. Call it
/// in uniform control flow.
fn footprint_of_vec3(v: vec3f) -> f32 {
    let dx = dpdx(v);
    let dy = dpdy(v);
    return bounded(sqrt(max(dot(dx, dx), dot(dy, dy))));
}

/// The width of an edge whose own width is `softness`, seen through a footprint of `w`.
fn edge_width(w: f32, softness: f32) -> f32 {
    return length(vec2f(min(w, 1e15), clamp(bounded(softness), 0.0, 1e15)));
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
fn step_filtered(x: f32, edge: f32, w: f32) -> f32 {
    let d = bounded(x - edge);
    if w < 1e-30 {
        return select(0.0, 1.0, d >= 0.0);
    }
    return clamp(0.5 + bounded(d / w), 0.0, 1.0);
}

/// The stairs floor(x) from 0 to `count` - 1, averaged over a footprint of `w`; x in [0, count],
/// count at least 2.
fn stairs_filtered(x: f32, count: f32, w: f32) -> f32 {
    if w <= 1.0 {
        // At most one edge lies in the footprint: the nearest.
        let edge = clamp(round(x), 1.0, count - 1.0);
        return edge - 1.0 + step_filtered(x, edge, w);
    }
    // Beyond a million stairs to the pixel the average does not change any more, and digits would
    // be lost.
    let half = 0.5 * min(w, 1e3 * count);
    return (stairs_integral(x + half, count) - stairs_integral(x - half, count)) / (2.0 * half);
}

/// A value from 0 to 1 in `count` flat steps (at least 2), the first 0 and the last 1, seen through
/// a footprint of `w`; `softness` is the share of a step that its edge takes.
fn stepped_tone(value: f32, w: f32, count: i32, softness: f32) -> f32 {
    let n = f32(clamp(count, 2, 1024));
    let width = edge_width(n * w, min(softness, 1.0));
    return clamp(stairs_filtered(n * clamp(bounded(value), 0.0, 1.0), n, width) / (n - 1.0), 0.0,
        1.0);
}

/// The integral of the stairs from 0 to x; they are 0 below 0 and `count` - 1 above `count`.
fn stairs_integral(x: f32, count: f32) -> f32 {
    let inside = clamp(x, 0.0, count);
    let stair = min(floor(inside), count - 1.0);
    let beyond = max(x - count, 0.0);
    return stair * (0.5 * (stair - 1.0) + inside - stair) + beyond * (count - 1.0);
}

/// A square wave of period 2, +1 on [0, 1) and -1 on [1, 2), averaged over a footprint of `w`.
fn square_wave_filtered(x: f32, w: f32) -> f32 {
    // Beyond 2^22 a float has no halves.
    let place = clamp(bounded(x), -4194304.0, 4194304.0);
    if w <= 1.0 {
        let edge = round(place);
        let rising = select(-1.0, 1.0, floor(edge * 0.5) == edge * 0.5);
        return rising * (2.0 * step_filtered(place, edge, w) - 1.0);
    }
    let width = min(w, 4194304.0);
    let turn = place - 2.0 * floor(place * 0.5);
    return (triangle_wave(turn + 0.5 * width) - triangle_wave(turn - 0.5 * width)) / width;
}

/// A chessboard of unit squares, 1 on the square at the origin and 0 on its neighbors, averaged
/// over a footprint.
fn checker_filtered(p: vec2f, w: vec2f) -> f32 {
    return 0.5 + 0.5 * square_wave_filtered(p.x, w.x) * square_wave_filtered(p.y, w.y);
}

/// The integral of the square wave: 0 at even numbers, 1 at odd ones, straight between.
fn triangle_wave(x: f32) -> f32 {
    let turn = x - 2.0 * floor(x * 0.5);
    return 1.0 - abs(turn - 1.0);
}

/// Change of a finite x over one pixel, by the sum of both derivatives: too wide on diagonals by up
/// to the square root of 2. Call it in uniform control flow.
fn footprint_by_sum(x: f32) -> f32 {
    return min(abs(dpdx(x)) + abs(dpdy(x)), 1e30);
}

/// [`step_filtered`] for finite numbers and a finite footprint.
fn step_quick(x: f32, edge: f32, w: f32) -> f32 {
    let d = x - edge;
    return select(clamp(0.5 + d / max(w, 1e-30), 0.0, 1.0), select(0.0, 1.0, d >= 0.0), w < 1e-30);
}

/// [`stairs_filtered`] for footprints of at most one stair; wider footprints count as one stair.
fn stairs_quick(x: f32, count: f32, w: f32) -> f32 {
    let edge = clamp(round(x), 1.0, count - 1.0);
    return edge - 1.0 + step_quick(x, edge, min(w, 1.0));
}
