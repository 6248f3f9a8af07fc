// How far pixels are from the nearest edges (docs/math.md 14): first within each column, then over
// the columns, which finds the nearest for few reads however far away it is.
//
// A pixel sees the edges of its own surface alone: a line belongs to what lies in front, and what
// lies behind draws none for it. Lines of what is hidden belong to nothing that is seen there:
// every pixel sees them, on both sides.
import chiaro::curvature_map;
import chiaro::edge_code;
import chiaro::lines;

/// Codes of edges at each pixel, as `edges_at` of `edge_map.wgsl` finds them.
@group(0) @binding(2) var edges: texture_2d<f32>;

/// Depth by which a surface may leave its plane, in multiples of what tells neighbors apart.
const LEEWAY = 3.0;

/// True if a texel belongs to the surface of a plane, so many pixels away.
fn is_same_surface(own: Plane, texel: vec4f, offset: vec2f) -> bool {
    let error = abs(texel.z - own.depth - dot(own.rise, offset));
    return object_in(texel.w) == object_in(own.object)
        && error <= LEEWAY * own.tolerance * max(length(offset), 1.0);
}

/// The nearest edge of each kind in a pixel's own column: the coarse code of each, with its row
/// from the pixel; 0 for none, negative for a border of ids. `reach` is how far edges are looked
/// for, in pixels; `of_all` if those of other surfaces count, too.
fn nearest_in_column(pixel: vec2i, own: Plane, reach: i32, of_all: bool) -> vec4f {
    let last = vec2i(textureDimensions(surface)) - 1;
    var nearest = vec4f(FAR);
    var codes = vec4f(0.0);
    for (var row = max(-reach, -pixel.y); row <= min(reach, last.y - pixel.y); row++) {
        let at = pixel + vec2i(0, row);
        let found = textureLoad(edges, at, 0);
        if all(found == vec4f(0.0)) {
            continue;
        }
        if !of_all && !is_same_surface(own, textureLoad(surface, at, 0), vec2f(0.0, f32(row))) {
            continue;
        }
        let fine = abs(found);
        let distances = select(vec4f(FAR),
            middle_distances(edges_of(fine, FINE), vec4f(0.0), vec4f(f32(row)), of_all),
            fine > vec4f(0.0));
        let is_nearer = distances < nearest;
        nearest = select(nearest, distances, is_nearer);
        let coarse = coarse_codes(fine) + ROW * (f32(row) + MOST_ROWS);
        codes = select(codes, select(coarse, -coarse, found < vec4f(0.0)), is_nearer);
    }
    return codes;
}
