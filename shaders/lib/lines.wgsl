// Lines where forms end, fold and meet (docs/math.md 14), as looks draw them from their distances.
import chiaro::slope;
import chiaro::total;

/// Steps of 1/800 of the picture's height that lines reach from their edges.
const LINE_STEPS = 16.0;
/// The same in the fast tier.
const FEW_LINE_STEPS = 8.0;

/// What is no nearer than this many pixels is not near at all: less is rounding.
const LEAST_NEARNESS: f32 = 1e-6;

/// Farthest that a line is known from its edge, in pixels: so many steps of 1/800 of the picture's
/// height, and at most 31 pixels, as far as an offset fits into a texel.
fn line_reach(viewport_height: f32, steps: f32) -> f32 {
    return min(steps * max(round(viewport_height / 800.0), 1.0), 31.0);
}

/// The nearness of edges as a fragment's own surface has it. The edges are those of what the middle
/// of the pixel shows: `middle` is its depth, and its object's number from 1 on. With several
/// samples a pixel, surfaces that miss the middle are drawn, too. One that lies in front ends in
/// the pixel, so that its silhouette is there; one that lies behind has no line.
fn own_nearness(nearness: vec4f, middle: vec2f, depth: f32, object: f32, pixels: f32,
    reach: f32) -> vec4f {
    let is_same_object = middle.y == object_number(object);
    let behind = (depth - middle.x) * pixels;
    // Slivers of the same surface are seen on the planes of their own triangles. Bounds are none of
    // the round numbers that depths of things put together by hand have.
    let is_own = abs(middle.y) < 0.5 || (is_same_object && abs(behind) <= 8.0625);
    let is_in_front = behind < select(-2.0625, -8.0625, is_same_object);
    let other = vec4f(select(0.0, reach, is_in_front), 0.0, nearness.z, 0.0);
    return select(other, nearness, is_own);
}

/// A number of pixels that a width says, 0 or more and less than any reach needs.
fn line_pixels(width: f32, pixels: f32) -> f32 {
    return clamp(bounded(width), 0.0, 1e6) * clamp(bounded(pixels), 0.0, 1e6);
}

/// Widths of lines of each kind, in pixels.
struct LineWidths {
    /// Of silhouettes, creases, borders of objects and borders of materials.
    kinds: vec4f,
    /// Of borders of ids.
    ids: f32,
}

/// Widths of lines of each kind: shares of one width, `ids` that of borders of ids.
fn line_widths(width: f32, shares: vec4f, ids: f32) -> LineWidths {
    let widths = min(width, 1e4) * clamp(bounded_vec4(shares), vec4f(0.0), vec4f(100.0));
    let id_width = min(width, 1e4) * clamp(bounded(ids), 0.0, 100.0);
    // What no pixel can show is no line.
    return LineWidths(select(vec4f(0.0), widths, widths > vec4f(1e-6)),
        select(0.0, id_width, id_width > 1e-6));
}

/// Widths of the four lines that are near: a negative nearness in the place of materials is that of
/// a border of ids.
fn widths_near(nearness: vec4f, widths: LineWidths) -> vec4f {
    return vec4f(widths.kinds.xyz, select(widths.kinds.w, widths.ids, nearness.w < 0.0));
}

/// Share of a pixel that lines cover which lie on one side of their edges: from the edge, which is
/// `distance` pixels away, inward.
fn inner_line_covers(distance: f32, width: f32) -> f32 {
    return clamp(width + 0.5 - distance, 0.0, min(width, 1.0));
}

/// Share of a pixel that lines cover which lie evenly on both sides of their edges.
fn middle_line_covers(distance: vec4f, width: vec4f) -> vec4f {
    let half = 0.5 * width;
    return clamp(min(distance + 0.5, half) - max(distance - 0.5, -half), vec4f(0.0), vec4f(1.0));
}

/// What a line of any kind covers of a pixel, by how much nearer than the reach the edges of each
/// kind are: all lie evenly on both sides.
fn any_line_covers(nearness: vec4f, widths: LineWidths, reach: f32) -> f32 {
    let near = clamp(bounded_vec4(nearness), vec4f(-reach), vec4f(reach));
    let own = select(vec4f(0.0), widths_near(near, widths), abs(near) > vec4f(LEAST_NEARNESS));
    let covers = middle_line_covers(reach - abs(near), own);
    return max(max(covers.x, covers.y), max(covers.z, covers.w));
}

/// What lines of each kind cover of a pixel, by how much nearer than the reach their edges are, in
/// pixels (0 where none is), and by their widths in pixels: silhouettes, creases, borders of
/// objects and borders of materials or ids.
fn lines_cover(nearness: vec4f, widths: vec4f, reach: f32) -> vec4f {
    let distance = reach - nearness;
    let covers = vec4f(inner_line_covers(distance.x, widths.x),
        middle_line_covers(distance, widths).yzw);
    return select(vec4f(0.0), covers, nearness > vec4f(LEAST_NEARNESS));
}
