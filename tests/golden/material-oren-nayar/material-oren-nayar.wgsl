// Oren-Nayar: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2.
// material-oren-nayar.json says what to put there and how to draw.

struct View {
    clip_from_world: mat4x4f,
    camera_from_world: mat4x4f,
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    eye: vec4f,
}

struct Object {
    world_from_object: mat4x4f,
    /// The inverse transpose, for normals.
    world_from_normal: mat3x3f,
    id: f32,
}

/// What is known before the fragment.
struct Look {
    @align(16) key: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;

/// A light as it arrives at a point of the surface.
struct Light {
    /// Unit, toward the light, in world space.
    direction: vec3f,
    /// Unit, toward the light, in the light's own frame.
    own_direction: vec3f,
    /// Straight RGB.
    color: vec3f,
    /// The light's intensity with its distance and cone attenuation; 0 or more.
    intensity: f32,
}

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
fn normalize_seen_balanced(v: vec3f) -> vec3f {
    return v * inverseSqrt(max(dot(v, v), 1e-30));
}

/// Oren and Nayar's rough matt surface (1994, their qualitative model), for a deviation of slopes
/// in radians.
fn oren_nayar(light: vec3f, normal: vec3f, view: vec3f, sigma: f32) -> f32 {
    let n_l = dot(normal, light);
    let n_v = dot(normal, view);
    if n_l <= 0.0 {
        return 0.0;
    }
    let s2 = sigma * sigma;
    let a = 1.0 - 0.5 * s2 / (s2 + 0.33);
    let b = 0.45 * s2 / (s2 + 0.09);
    // `across` is the cosine of the angle between light and eye around the normal, times the sines
    // of both. The model's sin of the larger angle times tan of the smaller one is both sines over
    // the larger cosine, so that no angle is needed.
    let across = dot(light, view) - n_l * n_v;
    let larger = max(max(n_l, n_v), 1e-3);
    return n_l * (a + b * max(across, 0.0) / larger);
}

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    // Reflectance
    let oren_nayar_2 = oren_nayar(look.key.direction, surface.normal, surface.view, 0.9);
    // Blend
    let body = min(vec4f(vec4f(0.1725, 0.1647, 0.2, 1.0).xyz + oren_nayar_2
        * vec4f(0.851, 0.7961, 0.698, 1.0).xyz, 1.0), vec4f(1.0));
    return body;
}

struct Vertex {
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
}

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
}

@vertex
fn vs_main(vertex: Vertex) -> Varyings {
    let world = object.world_from_object * vec4f(vertex.position, 1.0);
    return Varyings(view.clip_from_world * world, world.xyz, object.world_from_normal
        * vertex.normal);
}

@fragment
fn fs_main(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let facing = normalize_seen_balanced(in.normal);
    let normal = select(-facing, facing, is_front);
    let surface = Surface(normal, normalize(view.eye.xyz - view.eye.w * in.position));
    return shade(surface);
}
