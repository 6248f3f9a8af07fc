// Gooch by hand: warm where the light falls and cool elsewhere, with a highlight about the
// half-vector.

struct View {
    clip_from_world: mat4x4f,
    camera_from_world: mat4x4f,
    /// Eye and 1; for parallel projection the direction toward the viewer and 0.
    eye: vec4f,
}

struct Object {
    world_from_object: mat4x4f,
    world_from_normal: mat3x3f,
}

struct Lights {
    /// Unit vector toward the light, in world space.
    key: vec3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> lights: Lights;

const COOL = vec3f(0.13, 0.17, 0.42);
const WARM = vec3f(0.86, 0.55, 0.24);
const HIGHLIGHT = vec3f(1.0, 0.97, 0.9);

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
}

@vertex
fn vs_main(@location(0) position: vec3f, @location(1) normal: vec3f) -> Varyings {
    let world = object.world_from_object * vec4f(position, 1.0);
    return Varyings(view.clip_from_world * world, world.xyz, object.world_from_normal * normal);
}

@fragment
fn fs_main(in: Varyings) -> @location(0) vec4f {
    let normal = normalize(in.normal);
    let toward_eye = normalize(view.eye.xyz - view.eye.w * in.position);
    let half_vector = normalize(lights.key + toward_eye);
    let body = mix(COOL, WARM, 0.5 + 0.5 * dot(normal, lights.key));
    let shine = 0.8 * pow(max(dot(normal, half_vector), 0.0), 48.0);
    return vec4f(mix(body, HIGHLIGHT, shine), 1.0);
}
