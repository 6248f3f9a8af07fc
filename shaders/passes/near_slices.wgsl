// How much stands near each pixel's surface along the slices of its place in a pattern, which the
// pass after it joins.
import chiaro::horizons;

@vertex
fn vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return whole_picture(index);
}

@fragment
fn fs_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = vec2i(position.xy);
    let texel = textureLoad(surface, pixel, 0);
    if texel.w == 0.0 {
        return vec4f(0.0);
    }
    return packed_shares(shares_at(pixel, texel));
}
