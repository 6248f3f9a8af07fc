// The nearest edges in each pixel's column, by which the pass after it finds the nearest of all.
import chiaro::line_map;

/// Steps of 1/800 of the picture's height to which edges are looked for.
const STEPS = 16;
/// 1 where edges of all surfaces count, on both sides; 0 where those of a pixel's own do.
const OF_ALL = 0;

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
    let reach = line_reach(curvature.viewport_height, f32(STEPS));
    let own = plane_of(abs(seen.w), seen.z, normal_of(seen));
    return nearest_in_column(pixel, own, i32(reach), OF_ALL == 1);
}
