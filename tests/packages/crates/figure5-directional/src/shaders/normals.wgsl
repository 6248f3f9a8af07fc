// Directional control: made by Chiaro 0.1.0, WGSL.
// Draws normals and depth, for the curvature pass.
// Bindings of group 0: view 0, object 1.
// look.rs says what to put there.

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

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
fn normalize_moderate(v: vec3f, otherwise: vec3f) -> vec3f {
    let square = dot(v, v);
    return select(otherwise, v * inverseSqrt(max(square, 1e-30)), square > 1e-30);
}

/// v at length 1, for vectors that are seldom 0 and no longer than 1e18: normals, and directions
/// toward the eye. One shorter than 1e-15 points along z.
fn normalize_seen(v: vec3f) -> vec3f {
    return normalize_moderate(v, vec3f(0.0, 0.0, 1.0));
}

/// The least n.z that divides: beyond it every rim would saturate to convex.
const LEAST_NZ = 0.2;
/// The slope n.xy / n.z of a normal in camera axes.
fn slope_of(normal: vec3f) -> vec2f {
    return normal.xy / max(normal.z, LEAST_NZ);
}

/// The surface that a pixel shows, in one texel: its slope in xy, its depth in z, and in w the
/// object's number, from 1 on, negative where the normal points away from the viewer. `normal` is
/// unit, in camera axes.
fn surface_texel(normal: vec3f, depth: f32, number: f32) -> vec4f {
    return vec4f(slope_of(normal), depth, select(number, -number, normal.z < 0.0));
}

/// The normal that the curvature pass sees.
fn shade(surface: Surface) -> vec3f {
    return surface.normal;
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
    let facing = normalize_seen(in.normal);
    let toward = normalize(view.eye.xyz - view.eye.w * in.position);
    let is_behind = !is_front && dot(facing, toward) < -0.1;
    let normal = select(facing, -facing, is_behind);
    let surface = Surface(normal);
    let seen = (view.camera_from_world * vec4f(shade(surface), 0.0)).xyz;
    let depth = -(view.camera_from_world * vec4f(in.position, 1.0)).z;
    return surface_texel(seen, depth, object.id + 1.0);
}
