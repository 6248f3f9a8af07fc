// Places and sizes in the picture, and patterns laid over the picture itself: half-tones and
// dither. The unit is the picture's height, so that a picture of any resolution has the same dots.
import chiaro::numeric;
import chiaro::total;
import chiaro::antialias;
import chiaro::noise;

/// Greatest place and size on screen, in picture heights: beyond, it says no more.
const MOST_ON_SCREEN: f32 = 1e15;

/// Size on screen of a unit of the scene at a depth, in picture heights, at most 1e15.
/// `perspective` is 1 or 0; `scale` is what clip space multiplies heights by: at depth 1, or at
/// every depth without perspective.
fn size_on_screen(depth: f32, perspective: f32, scale: f32) -> f32 {
    // Clip space is 2 high.
    return min(0.5 * scale / mix(1.0, max(depth, 1e-6), perspective), MOST_ON_SCREEN);
}

/// Place on screen of a point in camera axes, from the picture's middle, x to the right and y down,
/// and in z the size there of a unit of the scene; in picture heights, within +-1e15.
fn anchor_on_screen(origin: vec3f, perspective: f32, scale: f32) -> vec3f {
    let size = size_on_screen(-origin.z, perspective, scale);
    return clamp(vec3f(origin.x * size, -origin.y * size, size), vec3f(-MOST_ON_SCREEN),
        vec3f(MOST_ON_SCREEN));
}

/// A pixel's place from the picture's middle, x to the right and y up, in picture heights.
fn place_in_picture(pixel: vec2f, viewport: vec2f) -> vec2f {
    let from_middle = bounded_vec2(pixel) - 0.5 * viewport;
    return vec2f(from_middle.x, -from_middle.y) / max(viewport.y, 1.0);
}

/// p turned by an angle in radians, from x to y.
fn turned_by(p: vec2f, angle: f32) -> vec2f {
    let turn = sin_cos_of(angle);
    return vec2f(turn.y * p.x - turn.x * p.y, turn.x * p.x + turn.y * p.y);
}

/// A place in pixels, in cells of a half-tone screen that has `lines` lines to the picture's height
/// and is turned by an angle in radians.
fn screen_cells(place: vec2f, viewport: vec2f, lines: f32, angle: f32) -> vec2f {
    // Beyond 2^22 a float has no halves.
    let most = vec2f(4194304.0);
    let upright = bounded_vec2(bounded_vec2(place)
        * (max(bounded(lines), 0.0) / max(viewport.y, 1.0)));
    return clamp(turned_by(clamp(upright, -most, most), angle), -most, most);
}

/// Lines that cover `share` of all, from 0 to 1: 1 within half a `share` of every whole number, 0
/// elsewhere, averaged over a footprint of `w`. Without a footprint the edges are inclusive.
fn lines_filtered(x: f32, share: f32, w: f32) -> f32 {
    let t = x - round(x);
    if w < 1e-30 {
        return select(0.0, 1.0, (abs(t) <= 0.5 * share) & (share > 0.0));
    }
    // Beyond a thousand lines to the pixel the average does not change any more.
    let half = 0.5 * min(w, 1e3);
    return clamp((lines_integral(t + half, share) - lines_integral(t - half, share)) / (2.0 * half),
        0.0, 1.0);
}

/// The integral of lines from 0 to x.
fn lines_integral(x: f32, share: f32) -> f32 {
    let whole = round(x);
    return whole * share + clamp(x - whole, -0.5 * share, 0.5 * share);
}

/// The radius of disks around whole places that together cover `share` of the plane: beyond pi/4
/// they overlap, and at 1 they reach the middle between four.
fn dot_radius(share: f32) -> f32 {
    let t = clamp(share, 0.0, 1.0);
    let quarter = 0.785398163397448310;
    if t <= quarter {
        return sqrt(t * 0.318309886183790672);
    }
    // A disk of radius 1/(2 cos a) leaves its cell between the angles -a and a of each side, and
    // covers (pi - 4 a) / (4 cos^2 a) + tan a of it. Both ends of a are known by series; two steps
    // of Newton join them.
    let s = min((t - quarter) / (1.0 - quarter), 1.0);
    var a = mix(0.52272320087706337 * sqrt(s), quarter - 0.32756818878101679 * sqrt(1.0 - s), s);
    for (var i = 0; i < 2; i++) {
        let turn = sin_cos_quarter(clamp(a, 0.0, quarter));
        let tangent = turn.x / turn.y;
        let square = 1.0 / (turn.y * turn.y);
        let sector = 0.25 * PI - a;
        let slope = 2.0 * sector * square * tangent;
        a = clamp(a - select(0.0, (sector * square + tangent - t) / slope, slope > 1e-3), 0.0,
            quarter);
    }
    return 0.5 / sin_cos_quarter(a).y;
}

/// Share of a footprint of `w` that a disk of radius r covers whose middle is d away. The average
/// over the plane is the disk's own area, however small the disk; without a footprint its edge is
/// inclusive.
fn disk_filtered(d: f32, r: f32, w: f32) -> f32 {
    if w < 1e-30 {
        return select(0.0, 1.0, (d <= r) & (r > 0.0));
    }
    // A ramp as wide as a pixel adds pi w^2/12 to a disk's area. A disk too small to give that back
    // is drawn fainter.
    let square = r * r;
    let least = w * w / 3.0;
    let inner = sqrt(max(square, least) - 0.25 * least);
    return clamp(0.5 + (inner - d) / w, 0.0, 1.0) * min(square / least, 1.0);
}

/// Ink of round dots that cover `share` of the plane.
fn ink_of_dots(cell: vec2f, share: f32, w: f32) -> f32 {
    let width = min(w, 1.0);
    var ink = disk_filtered(length(cell - round(cell)), dot_radius(share), width);
    // The hole between dark dots is a star; where the hole is not much larger than a pixel, a disk
    // of its size stands for it.
    let hole = sqrt(max(1.0 - share, 0.0) * 0.318309886183790672);
    let is_star = eased(width, 0.3 * hole, 0.9 * hole) * eased(share, 0.5, 0.7);
    if is_star > 0.0 {
        ink = mix(ink, 1.0 - disk_filtered(length(cell - floor(cell) - 0.5), hole, width), is_star);
    }
    // Cells as small as a pixel are their average.
    let mean = mix(ink, share, eased(w, 0.4, 1.0));
    return select(mean, share, (share <= 0.0) | (share >= 1.0));
}

/// Ink of lines in both directions that cover `share` of the plane together.
fn ink_of_crosses(cell: vec2f, share: f32, w: vec2f) -> f32 {
    // Two families leave (1 - a)^2 of the plane free.
    let each = share / (1.0 + sqrt(max(1.0 - share, 0.0)));
    let free = (1.0 - lines_filtered(cell.x, each, w.x))
        * (1.0 - lines_filtered(cell.y, each, w.y));
    return 1.0 - free;
}

/// Index of the square of `size` that a place is in.
fn dither_cell(place: vec2f, size: f32) -> vec2i {
    let least = max(bounded(size), 1e-3);
    return vec2i(floor(clamp(bounded_vec2(place) / least, vec2f(-4194304.0), vec2f(4194304.0))));
}

/// The threshold of a square in Bayer's matrix of 2^order by 2^order, between 0 and 1.
fn bayer_threshold(cell: vec2i, order: u32) -> f32 {
    let at = bitcast<vec2u>(cell);
    var rank = 0u;
    for (var i = 0u; i < order; i++) {
        let bit = (at >> vec2u(i)) & vec2u(1u);
        rank = 4u * rank + 2u * (bit.x ^ bit.y) + bit.y;
    }
    return (f32(rank) + 0.5) * power_of_two(-2 * i32(order));
}

/// A random threshold in [0, 1), the same for the same square.
fn random_threshold(cell: vec2i) -> f32 {
    return unit_of_hash(lattice_hash(vec3i(cell, 0), 77u)).x;
}

/// A tone as one of `levels` flat tones from 0 to 1. Within `spread` of the way from one level to
/// the next the threshold decides between them; at a spread of 1 the average is the tone.
fn dithered(tone: f32, levels: i32, spread: f32, threshold: f32) -> f32 {
    let steps = f32(clamp(levels, 2, 256) - 1);
    let x = clamp(bounded(tone), 0.0, 1.0) * steps;
    let low = min(floor(x), steps - 1.0);
    let soft = clamp(bounded(spread), 0.0, 1.0);
    let is_upper = x - low - 0.5 >= (threshold - 0.5) * soft;
    return (low + select(0.0, 1.0, is_upper)) / steps;
}
