// Edges of what lies behind the first surface, at the pixels beside them. Where a surface comes out
// from behind another it does not end, though nothing of it lies behind any more.
import chiaro::edge_map;

/// The first surface at each pixel.
@group(0) @binding(2) var front: texture_2d<f32>;

@vertex
fn vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return whole_picture(index);
}

@fragment
fn fs_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = vec2i(position.xy);
    let codes = edges_at(pixel);
    let is_end = codes.x > 0.0 && !comes_out(pixel, edges_of(codes, FINE));
    return vec4f(select(0.0, codes.x, is_end), codes.yzw);
}

/// True if a surface goes on in front, beyond its silhouette behind.
fn comes_out(pixel: vec2i, edges: EdgeLines) -> bool {
    let outward = vec2f(edges.x.x, edges.y.x);
    let is_level = abs(outward.x) >= abs(outward.y);
    let step = vec2i(select(vec2f(0.0, sign(outward.y)), vec2f(sign(outward.x), 0.0), is_level));
    let last = vec2i(textureDimensions(surface)) - 1;
    let own = facet_at(pixel);
    let texel = textureLoad(front, clamp(pixel + step, vec2i(0), last), 0);
    let error = abs(texel.z - own.depth - dot(own.gentle_rise, vec2f(step)));
    let tolerance = 2.0 * (pixel_size_at(own.depth) + length(own.gentle_rise));
    return object_in(texel.w) == object_in(own.number) && error <= tolerance;
}
