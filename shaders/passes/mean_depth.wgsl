// The mean depth around a pixel, of whatever is drawn there: a dummy, to count what a pass takes.
import chiaro::curvature_map;

@vertex
fn vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return whole_picture(index);
}

@fragment
fn fs_main(@builtin(position) position: vec4f) -> @location(0) f32 {
    let at = vec2i(position.xy);
    let stride = max(i32(round(curvature.viewport_height / 800.0)), 1);
    var sum = vec2f(0.0);
    for (var y = -2; y <= 2; y++) {
        for (var x = -2; x <= 2; x++) {
            let near = texel(at + stride * vec2i(x, y));
            sum += select(vec2f(0.0), vec2f(near.depth, 1.0), near.object != 0.0);
        }
    }
    return sum.x / max(sum.y, 1.0);
}
