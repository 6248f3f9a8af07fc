// Curvature by direction: its own number along, across and between the axes of the picture, from
// twelve neighbors.
import chiaro::tensor_map;

@vertex
fn vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return whole_picture(index);
}

@fragment
fn fs_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let center = center_at(vec2i(position.xy));
    if center.plane.object == 0.0 {
        return vec4f(0.0);
    }
    return vec4f(curvature_tensor(rings_at(center)), 1.0);
}
