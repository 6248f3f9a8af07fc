// What each light sees behind the first object: the nearest surface of any other.
import chiaro::light_view;

/// What the lights see first.
@group(0) @binding(2) var first: texture_2d_array<f32>;

@vertex
fn vs_main(@location(0) position: vec3f) -> SeenByLight {
    return seen_by_light(position);
}

@fragment
fn fs_main(in: SeenByLight) -> @location(0) vec4f {
    let texel = light_texel(in.measure);
    if textureLoad(first, vec2i(in.clip.xy), i32(light.layer), 0).y == texel.y {
        discard;
    }
    return texel;
}
