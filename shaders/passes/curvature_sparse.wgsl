// Curvature at half the price: from the four neighbors two steps away alone, which is the middle
// of what the exact pass takes in. One step away would be no cheaper, noisier and farther from it.
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
    return mean_curvature(ring_at(center, 2, WEIGHT_2));
}
