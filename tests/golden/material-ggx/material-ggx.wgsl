// Cook-Torrance, GGX: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2.
// material-ggx.json says what to put there and how to draw.

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
    /// The alpha cutoff of the material, 0 for none.
    cutoff: f32,
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

/// Straight RGBA.
alias Color = vec4f;

/// Premultiplied RGBA: the stack of layers below, as blends pass it on.
alias Composite = vec4f;

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

/// x, or `otherwise` where x is NaN or infinite.
fn finite_or(x: f32, otherwise: f32) -> f32 {
    return select(otherwise, x, is_finite(x));
}

/// v with 0 for each component that is NaN or infinite.
fn finite_vec3(v: vec3f) -> vec3f {
    return vec3f(finite_or(v.x, 0.0), finite_or(v.y, 0.0), finite_or(v.z, 0.0));
}

/// v with 0 for each component that is NaN or infinite.
fn finite_vec4(v: vec4f) -> vec4f {
    return vec4f(finite_vec3(v.xyz), finite_or(v.w, 0.0));
}

/// v at length 1, or `otherwise` where v is too short or too long to have a direction, or has a
/// NaN. Scaled by the largest component first, so that neither tiny nor huge vectors under- or
/// overflow.
fn normalize_or(v: vec3f, otherwise: vec3f) -> vec3f {
    let largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if !(largest > 1e-30 && largest < 1e30) {
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

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
fn bounded(x: f32) -> f32 {
    let bits = bitcast<u32>(x);
    let magnitude = bits & 0x7fffffffu;
    let largest = bitcast<f32>((bits & 0x80000000u) | 0x7f7fffffu);
    return select(select(0.0, largest, magnitude == 0x7f800000u), x, magnitude < 0x7f800000u);
}

/// Straight RGBA of a premultiplied color. Where nothing covers the pixel the color is kept as it
/// is, so that light added over transparency is not lost.
fn straight(composite: Composite) -> Color {
    if composite.w <= 0.0 {
        return composite;
    }
    return vec4f(composite.xyz / composite.w, composite.w);
}

/// Mix from `below` to `blended` by `opacity`, with `alpha` as its alpha; clamped to [0, 1] if
/// `clamped`. At opacity 0 the result is exactly `below`, whatever that is.
fn blend_finish(below: Composite, blended: vec3f, alpha: f32, opacity: f32,
    clamped: bool) -> Composite {
    if opacity <= 0.0 {
        return below;
    }
    let mixed = vec4f(below.xyz + opacity * (blended - below.xyz), alpha);
    return select(mixed, clamp(mixed, vec4f(0.0), vec4f(1.0)), clamped);
}

/// Blend
///
/// Lays a color, where the tone is, over what is below: one step of a layered look.
fn blend_add(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool) -> Composite {
    return blend_finish(below, below.xyz + tone * color.xyz, below.w, opacity * color.w, clamped);
}

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
fn output(color: Composite) -> Color {
    return finite_vec4(straight(color));
}

/// Cosines between normal (n), light (l), view (v) and half-vector (h), of which all models are
/// made; every cosine is at least a little above 0 where it divides.
struct Reflection {
    n_l: f32,
    n_v: f32,
    n_h: f32,
    v_h: f32,
    /// The square of the sine between the normal and the half-vector: near a highlight's middle a
    /// cosine has no digits left to tell how far it is.
    sine2: f32,
}

/// The directions' cosines; the half-vector is the normal where light and eye are opposite.
fn reflection_of(light: vec3f, normal: vec3f, view: vec3f) -> Reflection {
    let half = half_of(light, normal, view);
    let n_h = clamp(dot(normal, half), 0.0, 1.0);
    let v_h = clamp(dot(view, half), 0.0, 1.0);
    return Reflection(dot(normal, light), dot(normal, view), n_h, v_h, sine_squared(normal, half));
}

/// The square of the sine between two unit vectors.
fn sine_squared(a: vec3f, b: vec3f) -> f32 {
    let across = cross(a, b);
    return min(dot(across, across), 1.0);
}

/// The half-vector: unit, midway between the light and the eye; the normal where they are opposite.
fn half_of(light: vec3f, normal: vec3f, view: vec3f) -> vec3f {
    let half = light + view;
    return normalize_or(select(normal, half, dot(half, half) > 1e-12), normal);
}

/// The width of a highlight from an artist's roughness: its square, at least 0.001 so that a
/// mirror's is seen.
fn width_of_roughness(roughness: f32) -> f32 {
    let r = clamp(bounded(roughness), 0.0, 1.0);
    return max(r * r, 0.001);
}

/// Fresnel's reflectance by Schlick's approximation (1994), for a cosine.
fn schlick(at_normal: f32, cosine: f32) -> f32 {
    let m = clamp(1.0 - cosine, 0.0, 1.0);
    let m2 = m * m;
    return at_normal + (1.0 - at_normal) * (m2 * m2 * m);
}

/// Cook and Torrance's model with the GGX distribution and Smith's height-correlated shadowing
/// (Walter et al. 2007, Heitz 2014).
fn ggx(r: Reflection, width: f32, at_normal: f32) -> f32 {
    if r.n_l <= 0.0 || r.n_v <= 0.0 {
        return 0.0;
    }
    let a2 = width * width;
    let bottom = max(r.sine2 + a2 * r.n_h * r.n_h, 1e-12);
    let distribution = a2 / (bottom * bottom);
    let toward_light = r.n_v * sqrt(r.n_l * r.n_l * (1.0 - a2) + a2);
    let toward_eye = r.n_l * sqrt(r.n_v * r.n_v * (1.0 - a2) + a2);
    let visibility = 0.5 / max(toward_light + toward_eye, 1e-9);
    return min(distribution * visibility * schlick(at_normal, r.v_h) * r.n_l, 1e6);
}

/// Reflectance
///
/// How strongly a realistic surface shines toward the eye: to be laid beside drawn shading, for
/// contrast, or as a layer's tone.
fn reflectance_lambert(light: Light, normal: vec3f) -> f32 {
    return max(dot(normalize_or(normal, vec3f(0.0, 0.0, 1.0)), light.direction), 0.0);
}

fn reflectance_ggx(light: Light, normal: vec3f, view: vec3f, roughness: f32,
    at_normal: f32) -> f32 {
    let r = reflection_of(light.direction, normalize_or(normal, vec3f(0.0, 0.0, 1.0)), view);
    return ggx(r, width_of_roughness(roughness), clamp(bounded(at_normal), 0.0, 1.0));
}

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let lambert = reflectance_lambert(look.key, surface.normal);
    let body = blend_add(vec4f(0.0784, 0.0863, 0.1098, 1.0), vec4f(0.2353, 0.2667, 0.3137, 1.0), lambert, 1.0, true);
    let ggx_2 = reflectance_ggx(look.key, surface.normal, surface.view, 0.42, 0.85);
    let highlight = blend_add(body, vec4f(0.9098, 0.9333, 0.9647, 1.0), ggx_2, 0.5, true);
    let output_2 = output(highlight);
    return output_2;
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
    var out: Varyings;
    out.clip = view.clip_from_world * world;
    out.position = world.xyz;
    out.normal = object.world_from_normal * vertex.normal;
    return out;
}

@fragment
fn fs_main(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let facing = normalize_or(in.normal, vec3f(0.0, 0.0, 1.0));
    let normal = select(-facing, facing, is_front);
    var surface: Surface;
    surface.normal = normal;
    surface.view = normalize_or(view.eye.xyz - view.eye.w * in.position, normalize_or(view.eye.xyz, vec3f(0.0, 0.0, 1.0)));
    let shaded = shade(surface);
    return finite_vec4(shaded);
}
