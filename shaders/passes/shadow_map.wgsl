// What each light sees first.
import chiaro::light_view;

@vertex
fn vs_main(@location(0) position: vec3f) -> SeenByLight {
    return seen_by_light(position);
}

@fragment
fn fs_main(in: SeenByLight) -> @location(0) vec4f {
    return light_texel(in.measure);
}
