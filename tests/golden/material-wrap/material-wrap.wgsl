// Light that wraps: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2.
// material-wrap.json says what to put there and how to draw.

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

/// ln(x) for normal x > 0: the exponent by bits, the mantissa by the series of atanh (relative
/// error below 1e-7).
fn log_stable(x: f32) -> f32 {
    let bits = bitcast<u32>(x);
    // Mantissa in [sqrt(1/2), sqrt(2)), so that the series argument stays below 0.1716.
    let shift = i32((bits - 0x3f3504f3u) >> 23u);
    let exponent = select(shift, shift - 512, shift >= 256);
    let mantissa = bitcast<f32>(bits - (u32(exponent) << 23u));
    let z = (mantissa - 1.0) / (mantissa + 1.0);
    let z2 = z * z;
    let series = 2.0 * z * (1.0 + z2 * (0.333333333333333333
        + z2 * (0.2 + z2 * (0.142857142857142857 + z2 * 0.111111111111111111))));
    return f32(exponent) * LN_2 + series;
}

/// ln(1 - y) for y in [0, 1): relative accuracy near 0, where 1 - y would round y away.
fn log1p_negative(y: f32) -> f32 {
    if y < 0.25 {
        return log1p_negative_small(y);
    }
    return log_stable(max(1.0 - y, 1.17549435e-38));
}

/// ln(1 - y) for y in [0, 1/4], by the series of atanh.
fn log1p_negative_small(y: f32) -> f32 {
    let z = y / (2.0 - y);
    let z2 = z * z;
    return -2.0 * z * (1.0 + z2 * (0.333333333333333333
        + z2 * (0.2 + z2 * (0.142857142857142857 + z2 * 0.111111111111111111))));
}

const SMALLEST_NORMAL: f32 = 1.17549435e-38;
/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
fn bounded(x: f32) -> f32 {
    let bits = bitcast<u32>(x);
    let magnitude = bits & 0x7fffffffu;
    let largest = bitcast<f32>((bits & 0x80000000u) | 0x7f7fffffu);
    return select(select(0.0, largest, magnitude == 0x7f800000u), x, magnitude < 0x7f800000u);
}

/// base^exponent for every pair. A negative base is raised as in algebra by a whole exponent and
/// keeps its sign with any other, so that (-4)^0.5 is -2. 0 to a negative power is 0, as division
/// by 0 is; 0^0 is 1.
fn powered(base: f32, exponent: f32) -> f32 {
    let b = bounded(base);
    let e = bounded(exponent);
    // The result is exact, because an exponent of 1 lets the compiler leave the node out.
    if e == 1.0 {
        return b;
    }
    if e == 0.0 {
        return 1.0;
    }
    if e == 2.0 {
        return bounded(b * b);
    }
    let magnitude = abs(b);
    if magnitude < SMALLEST_NORMAL {
        return 0.0;
    }
    let raised = exp2_stable(bounded(e * (LOG2_E * log_stable(magnitude))));
    let is_even = floor(e * 0.5) == e * 0.5;
    return select(raised, -raised, b < 0.0 && !is_even);
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

/// A cosine to a power, 0 where it is negative; by the square of its sine where that has more
/// digits.
fn cosine_power(cosine: f32, sine2: f32, exponent: f32) -> f32 {
    if cosine < 0.7 {
        return powered(max(cosine, 0.0), exponent);
    }
    return exp2_stable(0.5 * exponent * LOG2_E * log1p_negative(min(sine2, 0.6)));
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

/// Phong's exponent of a width: as wide as Beckmann's distribution of that width.
fn exponent_of_width(width: f32) -> f32 {
    return max(2.0 / (width * width) - 2.0, 0.0);
}

fn reflectance_wrap(light: Light, normal: vec3f, wrap: f32) -> f32 {
    let w = clamp(bounded(wrap), 0.0, 1.0);
    let cosine = dot(normalize_or(normal, vec3f(0.0, 0.0, 1.0)), light.direction);
    return max((cosine + w) / (1.0 + w), 0.0);
}

fn reflectance_blinn_phong(light: Light, normal: vec3f, view: vec3f, roughness: f32) -> f32 {
    let r = reflection_of(light.direction, normalize_or(normal, vec3f(0.0, 0.0, 1.0)), view);
    let e = exponent_of_width(width_of_roughness(roughness));
    let shine = cosine_power(r.n_h, r.sine2, e);
    return min(0.125 * (e + 8.0) * shine * max(r.n_l, 0.0), 1e6);
}

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let wrap = reflectance_wrap(look.key, surface.normal, 0.7);
    let body = blend_add(vec4f(0.2902, 0.1137, 0.1333, 1.0), vec4f(0.851, 0.4706, 0.3725, 1.0), wrap, 1.0, true);
    let blinn_phong = reflectance_blinn_phong(look.key, surface.normal, surface.view, 0.6);
    let highlight = blend_add(body, vec4f(1.0, 0.8902, 0.8, 1.0), blinn_phong, 0.25, true);
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
