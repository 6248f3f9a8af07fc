// Normals smoothed further: from those that the pass before it made, four steps away.
import chiaro::smooth_map;

@vertex
fn vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return whole_picture(index);
}

@fragment
fn fs_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    return smoothed_at(vec2i(position.xy), 4);
}
