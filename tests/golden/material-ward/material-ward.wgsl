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
    tangent: vec3f,
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

const LN_2: f32 = 0.693147180559945309417;
const LOG2_E: f32 = 1.44269504088896340736;
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

/// 2^x: a polynomial of degree 7 on [-1/2, 1/2] (relative error below 1e-7), scaled by powers of
/// two. 0 below -149, the largest finite number above 128.
fn exp2_stable(x: f32) -> f32 {
    let clamped = clamp(x, -150.0, 127.999992);
    let whole = round(clamped);
    let f = (clamped - whole) * LN_2;
    let p = 1.0 + f * (1.0 + f * (0.5 + f * (0.166666666666666667
        + f * (0.0416666666666666667 + f * (0.00833333333333333333
        + f * (0.00138888888888888889 + f * 0.000198412698412698413))))));
    // The power is applied in two steps, because 2^-150 is no normal number.
    let half_whole = i32(whole) / 2;
    return p * power_of_two(half_whole) * power_of_two(i32(whole) - half_whole);
}

/// 2^n for n in [-126, 127], by its bits.
fn power_of_two(n: i32) -> f32 {
    return bitcast<f32>(u32(n + 127) << 23u);
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

/// Unit tangent, bitangent and normal as columns: a mesh's tangent and bitangent stood upright on a
/// normal (Gram and Schmidt), with the handedness of the mesh. Where the tangent is missing or lies
/// along the normal, another one takes its place.
fn world_from_tangent(tangent: vec3f, bitangent: vec3f, normal: vec3f) -> mat3x3f {
    let n = normalize_or(normal, vec3f(0.0, 0.0, 1.0));
    let t = normalize_or(tangent, vec3f(0.0));
    let leaning = t - dot(t, n) * n;
    // Below this length the tangent's part across the normal has no direction but rounding's.
    let is_usable = dot(leaning, leaning) > 1e-8;
    let rough = normalize_or(select(any_orthogonal(n), leaning, is_usable), vec3f(1.0, 0.0, 0.0));
    // Orthogonal once more: where tangent and normal are close, the part that is left of the
    // tangent still leans along the normal.
    let upright = normalize_or(rough - dot(rough, n) * n, vec3f(1.0, 0.0, 0.0));
    let b = cross(n, upright);
    return mat3x3f(upright, select(b, -b, dot(b, bitangent) < 0.0), n);
}

/// A unit vector at right angles to the unit vector n, smooth but at one pole (Duff et al. 2017).
fn any_orthogonal(n: vec3f) -> vec3f {
    let sign = select(-1.0, 1.0, n.z >= 0.0);
    let a = -1.0 / (sign + n.z);
    return vec3f(1.0 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x);
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

/// Ward's anisotropic highlight (1992, in the form of Walter 2005) with a width along each of two
/// axes.
fn ward(light: vec3f, normal: vec3f, view: vec3f, x_axis: vec3f, y_axis: vec3f,
    widths: vec2f) -> f32 {
    let n_l = dot(normal, light);
    let n_v = dot(normal, view);
    if n_l <= 0.0 || n_v <= 0.0 {
        return 0.0;
    }
    let half = half_of(light, normal, view);
    let n_h = max(dot(normal, half), 1e-6);
    let slope = vec2f(dot(half, x_axis), dot(half, y_axis)) / (widths * n_h);
    let lobe = exp2_stable(-LOG2_E * min(dot(slope, slope), 200.0));
    return min(n_l * lobe / (4.0 * widths.x * widths.y * sqrt(max(n_l * n_v, 1e-6))), 1e6);
}

/// Reflectance
///
/// How strongly a realistic surface shines toward the eye: to be laid beside drawn shading, for
/// contrast, or as a layer's tone.
fn reflectance_lambert(light: Light, normal: vec3f) -> f32 {
    return max(dot(normalize_or(normal, vec3f(0.0, 0.0, 1.0)), light.direction), 0.0);
}

fn reflectance_ward(light: Light, normal: vec3f, view: vec3f, tangent: vec3f, roughness: f32,
    across: f32) -> f32 {
    let frame = world_from_tangent(tangent, vec3f(0.0), normal);
    // Below a roughness of a twentieth the lobe is narrower than a pixel.
    let widths = max(vec2f(width_of_roughness(roughness), width_of_roughness(across)),
        vec2f(0.0025));
    return ward(light.direction, frame[2], view, frame[0], frame[1], widths);
}

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let lambert = reflectance_lambert(look.key, surface.normal);
    let body = blend_add(vec4f(0.098, 0.1059, 0.1333, 1.0), vec4f(0.3529, 0.3961, 0.4392, 1.0), lambert, 1.0, true);
    let ward_2 = reflectance_ward(look.key, surface.normal, surface.view, surface.tangent, 0.5, 0.2);
    let highlight = blend_add(body, vec4f(0.9569, 0.9412, 0.902, 1.0), ward_2, 0.55, true);
    let output_2 = output(highlight);
    return output_2;
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
    var out: Varyings;
    out.clip = view.clip_from_world * world;
    out.position = world.xyz;
    out.normal = object.world_from_normal * vertex.normal;
    out.tangent = vec4f((object.world_from_object * vec4f(vertex.tangent.xyz, 0.0)).xyz, select(vertex.tangent.w, -vertex.tangent.w, determinant(object.world_from_normal) < 0.0));
    return out;
}

@fragment
fn fs_main(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let facing = normalize_or(in.normal, vec3f(0.0, 0.0, 1.0));
    let normal = select(-facing, facing, is_front);
    var surface: Surface;
    surface.normal = normal;
    surface.view = normalize_or(view.eye.xyz - view.eye.w * in.position, normalize_or(view.eye.xyz, vec3f(0.0, 0.0, 1.0)));
    surface.tangent = normalize_or(in.tangent.xyz - normal * dot(normal, in.tangent.xyz), in.tangent.xyz);
    let shaded = shade(surface);
    return finite_vec4(shaded);
}
