// Edges where a surface ends, folds or meets another, at the pixels beside them.
import chiaro::edge_map;

@vertex
fn vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return whole_picture(index);
}

@fragment
fn fs_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    return edges_at(vec2i(position.xy));
}
