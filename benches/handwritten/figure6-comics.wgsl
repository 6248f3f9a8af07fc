// Figure 6, comics, by hand: flat areas with sharp edges, laid over each other.

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
    rim: Light,
    fill: Light,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> lights: Lights;
@group(0) @binding(3) var curvature_map: texture_2d<f32>;

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

/// Hard profile: 1 up to the offset, whose half has this cosine and sine, 0 beyond, with an edge
/// one pixel wide.
fn cel(half: vec2f, shift: f32, offset: vec2f) -> f32 {
    let angle = shifted(half, shift);
    let s = angle.x * offset.x - angle.y * offset.y;
    // 2 asin(s) by its series; s is small at the edge.
    return saturate(0.5 - s * (2.0 + s * s / 3.0) / max(footprint(angle), 1e-6));
}

/// Lays a layer over the color below, between its colors for hollow and for convex places.
fn laid(below: vec3f, convex: vec3f, concave: vec3f, bulge: f32, tone: f32, light: Light) -> vec3f {
    let color = mix(concave, convex, 0.5 + 0.5 * bulge) * light.color * max(light.intensity, 1.0);
    return saturate(mix(below, color, tone * min(light.intensity, 1.0)));
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
    let kappa = textureLoad(curvature_map, vec2i(in.clip.xy), 0).x;
    let wide = bulge(kappa, 0.35);
    let medium = bulge(kappa, 0.3);
    let slight = bulge(kappa, 0.25);
    let normal = normalize(in.normal);
    let toward_eye = normalize(view.eye.xyz - view.eye.w * in.position);
    let mirrored = 2.0 * dot(normal, toward_eye) * normal - toward_eye;
    let to_key = half_angle(normal, lights.key.direction);
    let to_fill = half_angle(normal, lights.fill.direction);
    let to_rim = half_angle(normal, lights.rim.direction);
    let gleam = half_angle(mirrored, lights.key.direction);
    // Offsets 1.12, 0.72, 0.52, 0.84 and 0.24.
    let key = cel(to_key, 0.45 * wide, vec2f(0.8472551, 0.5311862));
    let bounce = cel(to_fill, 0.35 * medium, vec2f(0.9358968, 0.35227424));
    let light = cel(to_key, 0.3 * medium, vec2f(0.96638995, 0.25708055));
    let rim = cel(to_rim, 0.2 * slight, vec2f(0.9130889, 0.40776044));
    let highlight = cel(gleam, 0.1 * slight, vec2f(0.99280864, 0.119712204));
    var color = vec3f(0.8863, 0.6275, 0.4353);
    color = laid(color, vec3f(0.7059, 0.3412, 0.2902), vec3f(0.2941, 0.1098, 0.2), wide, 1.0,
        lights.key);
    color = laid(color, vec3f(0.9529, 0.6902, 0.4392), vec3f(0.7686, 0.3451, 0.2902), wide, key,
        lights.key);
    color = laid(color, vec3f(0.8157, 0.4863, 0.3686), vec3f(0.549, 0.2275, 0.298), medium, bounce,
        lights.fill);
    color = laid(color, vec3f(1.0, 0.851, 0.6275), vec3f(0.9412, 0.6431, 0.4078), medium, light,
        lights.key);
    color = laid(color, vec3f(1.0, 0.9569, 0.8627), vec3f(0.949, 0.6588, 0.4196), slight, rim,
        lights.rim);
    color = laid(color, vec3f(1.0, 0.9804, 0.9412), vec3f(1.0, 0.8863, 0.7216), slight, highlight,
        lights.key);
    return vec4f(color, 1.0);
}
