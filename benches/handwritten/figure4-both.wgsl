// Figure 4 by hand: a soft diffuse layer whose color and extent follow curvature, over a fill.

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
    @align(16) direction: vec3f,
    own_direction: vec3f,
    color: vec3f,
    intensity: f32,
}

struct Lights {
    key: Light,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> lights: Lights;
@group(0) @binding(3) var curvature_map: texture_2d<f32>;

const BASE = vec3f(0.1373, 0.0941, 0.1255);
const FILL_CONVEX = vec3f(0.2275, 0.1569, 0.1882);
const FILL_CONCAVE = vec3f(0.0863, 0.0431, 0.0667);
const DIFFUSE_CONVEX = vec3f(0.7255, 0.5137, 0.3529);
const DIFFUSE_CONCAVE = vec3f(0.3608, 0.1216, 0.1725);
const SLOPE = 0.3;
const AMOUNT = 0.75;

/// Profile of offset 0.25, fall-off 1.2 and cut-off 1.6: cosine and sine of half the offset, 1 /
/// sin((cut-off - offset) / 2), gamma, and the footprint from which on one point is not enough.
const OFFSET = vec2f(0.9921977, 0.12467473);
const SCALE = 1.6002629;
const EXPONENT = 1.3188459;
const WIDE = 0.0315;

/// Sine and cosine of half the angle between two unit vectors.
fn half_angle(a: vec3f, b: vec3f) -> vec2f {
    return 0.5 * vec2f(length(a - b), length(a + b));
}

/// The angle less `shift`, kept within [0, pi].
fn shifted(half: vec2f, shift: f32) -> vec2f {
    let s = sin(0.5 * shift);
    let c = cos(0.5 * shift);
    let turned = vec2f(half.x * c - half.y * s, half.y * c + half.x * s);
    return select(select(turned, vec2f(1.0, 0.0), turned.y <= 0.0), vec2f(0.0, 1.0),
        turned.x <= 0.0);
}

/// Footprint of an angle: radians per pixel, at most 0.5.
fn footprint(half: vec2f) -> f32 {
    return min(2.0 * length(vec4f(dpdx(half), dpdy(half))), 0.5);
}

/// Convexity by tanh, positive for convex and negative for hollow places, from -1 to 1.
fn bulge(kappa: f32, slope: f32) -> f32 {
    return tanh(clamp(kappa * slope, -10.0, 10.0));
}

/// Profile at an angle beyond the offset; `s` is the sine of half the angle between the two.
fn falling(s: f32) -> f32 {
    let q = clamp(s * SCALE, 0.0, 1.0);
    return pow(1.0 - q * q, EXPONENT);
}

/// Mean of the profile over a pixel, from three points if the footprint is wide.
fn tone(half: vec2f, w: f32) -> f32 {
    let place = vec2f(half.x * OFFSET.x - half.y * OFFSET.y, half.y * OFFSET.x + half.x * OFFSET.y);
    if w < WIDE {
        return falling(place.x);
    }
    let reach = 0.193649167 * w;
    let before = falling(place.x * cos(reach) - place.y * sin(reach));
    let after = falling(place.x * cos(reach) + place.y * sin(reach));
    return (5.0 * before + 8.0 * falling(place.x) + 5.0 * after) / 18.0;
}

/// Tone under a light, which fades with it.
fn dimmed(tone: f32, light: Light) -> f32 {
    return tone * min(light.intensity, 1.0);
}

/// Color under a light, which brightens it.
fn lit(color: vec3f, light: Light) -> vec3f {
    return color * light.color * max(light.intensity, 1.0);
}

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) normal: vec3f,
}

@vertex
fn vs_main(@location(0) position: vec3f, @location(1) normal: vec3f) -> Varyings {
    let world = object.world_from_object * vec4f(position, 1.0);
    return Varyings(view.clip_from_world * world, object.world_from_normal * normal);
}

@fragment
fn fs_main(in: Varyings) -> @location(0) vec4f {
    let kappa = textureLoad(curvature_map, vec2i(in.clip.xy), 0).x;
    let bulge = bulge(kappa, SLOPE);
    let convexity = 0.5 + 0.5 * bulge;
    let angle = shifted(half_angle(normalize(in.normal), lights.key.direction), AMOUNT * bulge);
    let tone = tone(angle, footprint(angle));
    let fill = lit(mix(FILL_CONCAVE, FILL_CONVEX, convexity), lights.key);
    let diffuse = lit(mix(DIFFUSE_CONCAVE, DIFFUSE_CONVEX, convexity), lights.key);
    let filled = saturate(BASE + dimmed(1.0, lights.key) * fill);
    return vec4f(saturate(filled + dimmed(tone, lights.key) * diffuse), 1.0);
}
