// Curvature in every detail: from the neighbors one, two and three steps away, by a derivative of
// a Gaussian.
import chiaro::curvature_map;

@vertex
fn vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return whole_picture(index);
}

@fragment
fn fs_main(@builtin(position) position: vec4f) -> @location(0) f32 {
    let center = center_at(vec2i(position.xy));
    if center.plane.object == 0.0 {
        return 0.0;
    }
    return mean_curvature(rings_at(center));
}
