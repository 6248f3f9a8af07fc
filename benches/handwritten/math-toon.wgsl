// Toon by hand: two lights in three smooth bands each, a colored shadow, a rim that follows the key
// light and a hard highlight.

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

/// Lights: unit vectors toward them, in world space, their colors and their intensities.
struct Lights {
    fill_direction: vec3f,
    fill_intensity: f32,
    /// Color of the fill light times the color of the surface that bounces it.
    fill_color: vec4f,
    key_direction: vec3f,
    key_color: vec4f,
    key_intensity: f32,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> lights: Lights;

const SHADOW = vec3f(0.2, 0.12, 0.34);
const SURFACE = vec3f(0.93, 0.55, 0.33);
const RIM = vec3f(1.0, 0.88, 0.66);
const HIGHLIGHT = vec3f(1.0, 1.0, 0.97);

/// Sum of three smooth bands, by their weights; `low` and `high` are where each begins and ends.
fn bands(cosine: f32, low: vec3f, high: vec3f, weights: vec3f) -> f32 {
    return dot(smoothstep(low, high, vec3f(cosine)), weights);
}

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
    let key_cosine = dot(normal, lights.key_direction);
    let fill_cosine = dot(normal, lights.fill_direction);
    let key = lights.key_intensity * bands(key_cosine, vec3f(-0.04, 0.42, 0.82),
        vec3f(0.04, 0.48, 0.86), vec3f(0.5, 0.3, 0.2));
    let fill = lights.fill_intensity * bands(fill_cosine, vec3f(0.05, 0.5, 0.84),
        vec3f(0.15, 0.58, 0.9), vec3f(0.4, 0.35, 0.25));
    var color = mix(SHADOW, SURFACE, key) * lights.key_color.rgb;
    color += fill * lights.fill_color.rgb * (1.0 - color);
    let edge = pow(1.0 - saturate(dot(normal, toward_eye)), 2.5);
    let toward_key = saturate(key_cosine + 0.2);
    color = mix(color, RIM, toward_key * smoothstep(0.3, 0.4, edge));
    let half_vector = normalize(lights.key_direction + toward_eye);
    let shine = pow(max(dot(normal, half_vector), 0.0), 50.0);
    color = mix(color, HIGHLIGHT, smoothstep(0.45, 0.55, shine));
    return vec4f(saturate(color), 1.0);
}
