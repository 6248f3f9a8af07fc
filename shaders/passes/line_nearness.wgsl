// How much nearer than the reach of lines the nearest edges are, in pixels: silhouettes, creases,
// borders of objects, and borders of materials or, negative, of ids; 0 where none is near.
import chiaro::line_map;

/// Steps of 1/800 of the picture's height to which edges are looked for.
const STEPS = 16;
/// 1 where edges of all surfaces count, on both sides; 0 where those of a pixel's own do.
const OF_ALL = 0;

/// The nearest edges in each pixel's column, as [`nearest_in_column`] finds them.
@group(0) @binding(3) var columns: texture_2d<f32>;

@vertex
fn vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return whole_picture(index);
}

@fragment
fn fs_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = vec2i(position.xy);
    let seen = seen_pixel(pixel).texel;
    if OF_ALL == 0 && seen.w == 0.0 {
        return vec4f(0.0);
    }
    return nearness_at(pixel, plane_of(abs(seen.w), seen.z, normal_of(seen)));
}

fn nearness_at(pixel: vec2i, own: Plane) -> vec4f {
    let last = vec2i(textureDimensions(surface)) - 1;
    let reach = i32(line_reach(curvature.viewport_height, f32(STEPS)));
    var nearest = vec4f(FAR);
    // Columns and rows of the nearest edges, from the pixel.
    var across = vec4f(0.0);
    var down = vec4f(0.0);
    for (var column = max(-reach, -pixel.x); column <= min(reach, last.x - pixel.x); column++) {
        let at = pixel + vec2i(column, 0);
        let found = textureLoad(columns, at, 0);
        if all(found == vec4f(0.0)) {
            continue;
        }
        // A pixel that only touches its object shows none.
        if OF_ALL == 0 && column != 0
            && !is_same_surface(own, textureLoad(surface, at, 0), vec2f(f32(column), 0.0)) {
            continue;
        }
        let coarse = abs(found);
        let rows = floor(coarse / ROW);
        let lines = edges_of(coarse - ROW * rows, COARSE);
        let places = rows - MOST_ROWS;
        let distances = select(vec4f(FAR),
            middle_distances(lines, vec4f(f32(column)), places, OF_ALL == 1), coarse > vec4f(0.0));
        let is_nearer = distances < nearest;
        nearest = select(nearest, distances, is_nearer);
        across = select(across, vec4f(f32(column)), is_nearer);
        down = select(down, places, is_nearer);
    }
    if all(nearest >= vec4f(FAR)) {
        return vec4f(0.0);
    }
    // The edge itself tells the distance in full.
    let x = pixel.x + vec4i(across);
    let y = pixel.y + vec4i(down);
    let codes = vec4f(
        textureLoad(edges, vec2i(x.x, y.x), 0).x,
        textureLoad(edges, vec2i(x.y, y.y), 0).y,
        textureLoad(edges, vec2i(x.z, y.z), 0).z,
        textureLoad(edges, vec2i(x.w, y.w), 0).w,
    );
    let distances = edge_distances(edges_of(abs(codes), FINE), across, down, OF_ALL == 1);
    let nearness = clamp(f32(reach) - distances, vec4f(0.0), vec4f(f32(reach)));
    let near = select(vec4f(0.0), nearness, nearest < vec4f(FAR));
    return select(near, -near, codes < vec4f(0.0));
}
