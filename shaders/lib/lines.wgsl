// Lines where forms end, fold and meet (docs/math.md 18), as looks draw them from their distances.
import chiaro::total;

/// Farthest that a line is known from its edge, in pixels: 16 steps of 1/800 of the picture's
/// height, and at most 31 pixels, as far as an offset fits into a texel.
fn line_reach(viewport_height: f32) -> f32 {
    return min(16.0 * max(round(viewport_height / 800.0), 1.0), 31.0);
}

/// A number of pixels that a width says, 0 or more and less than any reach needs.
fn line_pixels(width: f32, pixels: f32) -> f32 {
    return clamp(bounded(width), 0.0, 1e6) * clamp(bounded(pixels), 0.0, 1e6);
}

/// Widths of lines of each kind, in pixels: shares of one width.
fn line_widths(width: f32, shares: vec4f) -> vec4f {
    return min(width, 1e4) * clamp(bounded_vec4(shares), vec4f(0.0), vec4f(100.0));
}

/// Share of a pixel that lines cover which lie on one side of their edges: from the edge, which is
/// `distance` pixels away, inward.
fn inner_line_covers(distance: f32, width: f32) -> f32 {
    return clamp(width + 0.5 - distance, 0.0, min(width, 1.0));
}

/// Share of a pixel that lines cover which lie evenly on both sides of their edges.
fn middle_line_covers(distance: vec3f, width: vec3f) -> vec3f {
    let half = 0.5 * width;
    return clamp(min(distance + 0.5, half) - max(distance - 0.5, -half), vec3f(0.0), vec3f(1.0));
}

/// What lines of each kind cover of a pixel, by how much nearer than the reach their edges are, in
/// pixels (0 where none is), and by their widths in pixels: silhouettes, creases, borders of objects
/// and borders of looks.
fn lines_cover(nearness: vec4f, widths: vec4f, reach: f32) -> vec4f {
    let distance = reach - nearness;
    let covers = vec4f(inner_line_covers(distance.x, widths.x),
        middle_line_covers(distance.yzw, widths.yzw));
    return select(vec4f(0.0), covers, nearness > vec4f(0.0));
}
