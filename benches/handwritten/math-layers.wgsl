// Six layers by hand, each of which mixes two colors by tones of all ten lights.

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

struct Light {
    /// Unit vector toward the light, in world space.
    direction: vec3f,
    intensity: f32,
}

struct Lights {
    kick: Light,
    back: Light,
    bounce: Light,
    window: Light,
    lamp: Light,
    ground: Light,
    sky: Light,
    rim: Light,
    fill: Light,
    key: Light,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> lights: Lights;

const BASE = vec3f(0.1, 0.08, 0.14);
const EDGE = vec3f(0.08, 0.05, 0.12);

/// Light that falls on a surface, also from behind, by a power.
fn falling(normal: vec3f, light: Light, exponent: f32) -> f32 {
    return light.intensity * pow(saturate(0.5 + 0.5 * dot(normal, light.direction)), exponent);
}

/// Lays a tinted color, between a dark and a bright one by a tone, over the color below.
fn laid(below: vec3f, tint: vec3f, dark: vec3f, bright: vec3f, tone: f32, opacity: f32) -> vec3f {
    return mix(below, tint * mix(dark, bright, saturate(tone)), opacity);
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
    let key = falling(normal, lights.key, 1.2);
    let fill = falling(normal, lights.fill, 1.6);
    let rim = falling(normal, lights.rim, 2.5);
    let sky = falling(normal, lights.sky, 1.4);
    let ground = falling(normal, lights.ground, 1.8);
    let lamp = falling(normal, lights.lamp, 3.0);
    let window = falling(normal, lights.window, 2.2);
    let bounce = falling(normal, lights.bounce, 1.7);
    let back = falling(normal, lights.back, 2.8);
    let kick = falling(normal, lights.kick, 1.5);
    let tone_1 = 0.57 * smoothstep(0.1, 0.17, key) + 0.05 * smoothstep(0.22, 0.44, fill)
        + 0.1 * smoothstep(0.12, 0.21, rim) + 0.05 * smoothstep(0.28, 0.52, sky)
        + 0.09 * smoothstep(0.26, 0.39, ground) + 0.6 * smoothstep(0.39, 0.45, lamp)
        + 0.04 * smoothstep(0.35, 0.46, window) + 0.08 * smoothstep(0.13, 0.2, bounce)
        + 0.04 * smoothstep(0.18, 0.39, back) + 0.08 * smoothstep(0.14, 0.31, kick);
    let tone_2 = 0.59 * smoothstep(0.23, 0.34, key) + 0.45 * smoothstep(0.33, 0.52, fill)
        + 0.07 * smoothstep(0.16, 0.32, rim) + 0.27 * smoothstep(0.25, 0.48, sky)
        + 0.03 * smoothstep(0.31, 0.42, ground) + 0.04 * smoothstep(0.39, 0.46, lamp)
        + 0.07 * smoothstep(0.21, 0.41, window) + 0.06 * smoothstep(0.13, 0.28, bounce)
        + 0.05 * smoothstep(0.09, 0.27, back) + 0.07 * smoothstep(0.32, 0.48, kick);
    let tone_3 = 0.62 * smoothstep(0.1, 0.29, key) + 0.04 * smoothstep(0.29, 0.54, fill)
        + 0.06 * smoothstep(0.34, 0.45, rim) + 0.06 * smoothstep(0.2, 0.38, sky)
        + 0.06 * smoothstep(0.09, 0.23, ground) + 0.05 * smoothstep(0.13, 0.2, lamp)
        + 0.61 * smoothstep(0.1, 0.3, window) + 0.08 * smoothstep(0.12, 0.22, bounce)
        + 0.05 * smoothstep(0.21, 0.43, back) + 0.06 * smoothstep(0.11, 0.25, kick);
    let tone_4 = 0.04 * smoothstep(0.14, 0.24, key) + 0.47 * smoothstep(0.15, 0.3, fill)
        + 0.45 * smoothstep(0.27, 0.37, rim) + 0.06 * smoothstep(0.08, 0.21, sky)
        + 0.03 * smoothstep(0.2, 0.36, ground) + 0.04 * smoothstep(0.38, 0.57, lamp)
        + 0.03 * smoothstep(0.24, 0.41, window) + 0.06 * smoothstep(0.3, 0.36, bounce)
        + 0.5 * smoothstep(0.37, 0.58, back) + 0.03 * smoothstep(0.36, 0.57, kick);
    let tone_5 = 0.48 * smoothstep(0.08, 0.16, key) + 0.06 * smoothstep(0.11, 0.23, fill)
        + 0.04 * smoothstep(0.09, 0.31, rim) + 0.63 * smoothstep(0.28, 0.36, sky)
        + 0.03 * smoothstep(0.16, 0.28, ground) + 0.04 * smoothstep(0.2, 0.27, lamp)
        + 0.05 * smoothstep(0.35, 0.6, window) + 0.04 * smoothstep(0.23, 0.38, bounce)
        + 0.05 * smoothstep(0.11, 0.18, back) + 0.28 * smoothstep(0.19, 0.29, kick);
    let tone_6 = 0.79 * smoothstep(0.36, 0.55, key) + 0.04 * smoothstep(0.16, 0.28, fill)
        + 0.03 * smoothstep(0.13, 0.33, rim) + 0.1 * smoothstep(0.25, 0.46, sky)
        + 0.07 * smoothstep(0.19, 0.28, ground) + 0.36 * smoothstep(0.34, 0.59, lamp)
        + 0.07 * smoothstep(0.35, 0.56, window) + 0.03 * smoothstep(0.34, 0.54, bounce)
        + 0.07 * smoothstep(0.15, 0.3, back) + 0.11 * smoothstep(0.19, 0.25, kick);
    var color = BASE;
    color = laid(color, vec3f(1.0, 0.92, 0.85), vec3f(0.12, 0.08, 0.3), vec3f(0.98, 0.5, 0.25),
        pow(tone_1, 1.3), 0.95);
    color = laid(color, vec3f(0.95, 0.9, 1.0), vec3f(0.05, 0.25, 0.4), vec3f(0.95, 0.7, 0.3),
        pow(tone_2, 0.8), 0.4);
    color = laid(color, vec3f(1.0, 0.95, 0.9), vec3f(0.35, 0.05, 0.25), vec3f(1.0, 0.75, 0.4),
        pow(tone_3, 1.6), 0.35);
    color = laid(color, vec3f(0.9, 1.0, 0.95), vec3f(0.05, 0.3, 0.3), vec3f(1.0, 0.55, 0.4),
        pow(tone_4, 1.1), 0.3);
    color = laid(color, vec3f(1.0, 0.9, 0.95), vec3f(0.25, 0.1, 0.5), vec3f(1.0, 0.85, 0.6),
        pow(tone_5, 2.0), 0.3);
    color = laid(color, vec3f(1.0, 1.0, 0.95), vec3f(0.2, 0.15, 0.5), vec3f(1.0, 0.97, 0.85),
        pow(tone_6, 2.6), 0.35);
    color = mix(EDGE, color, saturate(dot(normal, toward_eye)));
    return vec4f(saturate(color), 1.0);
}
