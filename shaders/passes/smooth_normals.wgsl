// A level of smoothed normals: from neighbors in the level before it, or, for the first one, in
// the surface itself.
import chiaro::smooth_map;

/// The level, from 1 on: its neighbors are 2^LEVEL steps away, each 1/800 of the picture's height.
const LEVEL = 1;

@vertex
fn vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return whole_picture(index);
}

@fragment
fn fs_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    return smoothed_at(vec2i(position.xy), LEVEL);
}
