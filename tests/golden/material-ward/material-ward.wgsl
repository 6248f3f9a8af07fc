// Anisotropic Ward: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2.
// material-ward.json says what to put there and how to draw.

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
    tangent: vec3f,
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

/// True if x is neither NaN nor infinite, told by its exponent bits: a compiler may assume that NaN
/// never happens.
fn is_finite(x: f32) -> bool {
    return (bitcast<u32>(x) & 0x7f800000u) != 0x7f800000u;
}

/// v at length 1, or `otherwise` where v is too short or too long to have a direction, or has a
/// NaN. Scaled by the largest component first, so that neither tiny nor huge vectors under- or
/// overflow.
fn normalize_or(v: vec3f, otherwise: vec3f) -> vec3f {
    let largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if !((largest > 1e-30) & (largest < 1e30)) {
        return otherwise;
    }
    let scaled = v * (1.0 / largest);
    let square = dot(scaled, scaled);
    // max() passes over a NaN.
    if !is_finite(square) {
        return otherwise;
    }
    return scaled * (1.0 / sqrt(square));
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
fn exp2_stable(x: f32) -> f32 {
    let clamped = max(x, -126.0);
    let whole = round(clamped);
    let f = clamped - whole;
    let twice = 2.0 + f * (1.386294405710424 + f
        * (0.4804529582723118 + f * (0.11100664941567156 + f
        * (0.019236874716471952 + f * (0.0026797749114217808 + f * 0.00030706724124369897)))));
    return twice * bitcast<f32>(u32(i32(whole) + 126) << 23u);
}

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
fn normalize_moderate(v: vec3f, otherwise: vec3f) -> vec3f {
    let square = dot(v, v);
    return select(otherwise, v * inverseSqrt(max(square, 1e-30)), square > 1e-30);
}

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
fn normalize_seen_balanced(v: vec3f) -> vec3f {
    return v * inverseSqrt(max(dot(v, v), 1e-30));
}

/// Unit tangent, bitangent and normal as columns: a mesh's tangent and bitangent stood upright on a
/// normal (Gram and Schmidt), with the handedness of the mesh. Where the tangent is missing or lies
/// along the normal, another one takes its place.
fn world_from_tangent(tangent: vec3f, bitangent: vec3f, normal: vec3f) -> mat3x3f {
    let t = tangent * inverseSqrt(max(dot(tangent, tangent), 1e-30));
    let leaning = t - dot(t, normal) * normal;
    let is_usable = dot(leaning, leaning) > 1e-8;
    let rough = normalize_or(select(any_orthogonal(normal), leaning, is_usable),
        vec3f(1.0, 0.0, 0.0));
    let upright = normalize_moderate(rough - dot(rough, normal) * normal, vec3f(1.0, 0.0, 0.0));
    let b = cross(normal, upright);
    return mat3x3f(upright, b, normal);
}

/// A unit vector at right angles to the unit vector n, smooth but at one pole (Duff et al. 2017).
fn any_orthogonal(n: vec3f) -> vec3f {
    let sign = select(-1.0, 1.0, n.z >= 0.0);
    let a = -1.0 / (sign + n.z);
    return vec3f(1.0 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x);
}

/// The half-vector: unit, midway between the light and the eye; the normal where they are opposite.
fn half_of(light: vec3f, normal: vec3f, view: vec3f) -> vec3f {
    let half = light + view;
    return normalize_moderate(select(normal, half, dot(half, half) > 1e-12), normal);
}

/// Ward's anisotropic highlight (1992, in the form of Walter 2005) with a width along each of two
/// axes.
fn ward(light: vec3f, normal: vec3f, view: vec3f, x_axis: vec3f, y_axis: vec3f, widths: vec2f)
    -> f32 {
    let n_l = dot(normal, light);
    let n_v = dot(normal, view);
    if (n_l <= 0.0) | (n_v <= 0.0) {
        return 0.0;
    }
    let half = half_of(light, normal, view);
    let n_h = max(dot(normal, half), 1e-6);
    let slope = vec2f(dot(half, x_axis), dot(half, y_axis)) / (widths * n_h);
    let lobe = exp2_stable(-1.4426950408889634 * min(dot(slope, slope), 200.0));
    return n_l * lobe / (widths.y * sqrt(max(n_l * n_v, 1e-6)));
}

fn reflectance_ward(light: Light, normal: vec3f, view: vec3f, tangent: vec3f, roughness: f32,
    across: f32) -> f32 {
    let frame = world_from_tangent(tangent, vec3f(0.0), normal);
    let widths = vec2f(0.25, across * across);
    return ward(light.direction, frame[2], view, frame[0], frame[1], widths);
}

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    // Reflectance
    let lambert = max(dot(surface.normal, look.key.direction), 0.0);
    // Blend
    let body = vec4f(vec4f(0.098, 0.1059, 0.1333, 1.0).xyz + lambert
        * vec4f(0.3529, 0.3961, 0.4392, 1.0).xyz, 1.0);
    let ward_2 = reflectance_ward(look.key, surface.normal, surface.view, surface.tangent, 0.5,
        0.2);
    // Blend
    let highlight = clamp(vec4f(body.xyz + 0.55
        * (body.xyz + ward_2 * vec4f(0.9569, 0.9412, 0.902, 1.0).xyz - body.xyz), 1.0), vec4f(0.0),
        vec4f(1.0));
    return highlight;
}

struct Vertex {
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) tangent: vec4f,
}

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) tangent: vec4f,
}

@vertex
fn vs_main(vertex: Vertex) -> Varyings {
    let world = object.world_from_object * vec4f(vertex.position, 1.0);
    return Varyings(view.clip_from_world * world, world.xyz, object.world_from_normal
        * vertex.normal, vec4f((object.world_from_object * vec4f(vertex.tangent.xyz, 0.0)).xyz,
        select(vertex.tangent.w, -vertex.tangent.w, determinant(object.world_from_normal) < 0.0)));
}

@fragment
fn fs_main(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let facing = normalize_seen_balanced(in.normal);
    let normal = select(-facing, facing, is_front);
    let surface = Surface(normal, normalize(view.eye.xyz - view.eye.w * in.position),
        normalize_moderate(in.tangent.xyz - normal * dot(normal, in.tangent.xyz), vec3f(0.0)));
    return shade(surface);
}
