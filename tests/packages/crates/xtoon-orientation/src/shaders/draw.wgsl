// Ink at the turn: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, image_1 3, image_1_sampler 4.
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
@group(0) @binding(3) var image_1: texture_2d<f32>;
@group(0) @binding(4) var image_1_sampler: sampler;

/// Straight RGBA.
alias Color = vec4f;

/// Premultiplied RGBA: the stack of layers below, as blends pass it on.
alias Composite = vec4f;

/// An angle u in [0, pi] by the sine and cosine of its half, so that nothing is lost near 0 and
/// near pi.
struct Angle {
    /// sin(u/2), 0 or more.
    half_sin: f32,
    /// cos(u/2), 0 or more.
    half_cos: f32,
}

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
/// v with 0 for each component that is NaN or infinite.
fn finite_vec4(v: vec4f) -> vec4f {
    let exponent = vec4u(0x7f800000u);
    return select(vec4f(0.0), v, (bitcast<vec4u>(v) & exponent) != exponent);
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
fn exp2_stable(x: f32) -> f32 {
    let clamped = clamp(x, -126.0, 127.999992);
    let whole = round(clamped);
    let f = clamped - whole;
    // Twice the power, so that half of 2^128 is a number. The bits of 2^-127 are those of 0.
    let twice = 2.0 + f * (1.386294405710424 + f * (0.4804529582723118 + f * (0.11100664941567156
        + f * (0.019236874716471952 + f * (0.0026797749114217808 + f * 0.00030706724124369897)))));
    return twice * bitcast<f32>(u32(i32(whole) + 126) << 23u);
}

/// log2(x) for normal x > 0: the exponent by bits, the mantissa by a minimax polynomial in
/// (m - 1) / (m + 1) (relative error below 1e-9 beside rounding).
fn log2_stable(x: f32) -> f32 {
    let bits = bitcast<u32>(x);
    // Mantissa in [sqrt(1/2), sqrt(2)), so that z stays below 0.1716. The sign bit moves down.
    let exponent = bitcast<i32>(bits - 0x3f3504f3u) >> 23u;
    let mantissa = bitcast<f32>(bits - (bitcast<u32>(exponent) << 23u));
    let z = (mantissa - 1.0) / (mantissa + 1.0);
    let z2 = z * z;
    return f32(exponent) + z * (2.8853900797881615 + z2 * (0.9617988482912865
        + z2 * (0.5767143098091317 + z2 * 0.43173790132006157)));
}

/// ln(x) for normal x > 0.
fn log_stable(x: f32) -> f32 {
    return LN_2 * log2_stable(x);
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

/// Change of u over one pixel, in radians: |grad u|, at most 0.5. With half-angles the gradient
/// needs no inverse trigonometry: |du| = 2 |d(sin u/2, cos u/2)|. Call it in uniform control flow.
fn angle_footprint(u: Angle) -> f32 {
    let half = vec2f(u.half_sin, u.half_cos);
    let dx = dpdx(half);
    let dy = dpdy(half);
    let w = 2.0 * sqrt(dot(dx, dx) + dot(dy, dy));
    return min(w, 0.5);
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
fn angle_turned(u: Angle, t: vec2f) -> Angle {
    let s = u.half_sin - 0.0;
    let upper = select(vec2f(s, u.half_cos), vec2f(1.0, 0.0), u.half_cos <= 0.0);
    let turned = select(upper, vec2f(0.0, 1.0), (s <= 0.0) & (s < u.half_cos));
    return Angle(turned.x, turned.y);
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
    let raised = exp2_stable(bounded(e * log2_stable(max(magnitude, SMALLEST_NORMAL))));
    let is_even = floor(e * 0.5) == e * 0.5;
    let signed = select(raised, -raised, (b < 0.0) & !is_even);
    return select(signed, 0.0, magnitude < SMALLEST_NORMAL);
}

/// Premultiplied RGBA of a straight color.
fn premultiplied(color: Color) -> Composite {
    return vec4f(color.xyz * color.w, color.w);
}

/// Straight RGBA of a premultiplied color. Where nothing covers the pixel the color is kept as it
/// is, so that light added over transparency is not lost.
fn straight(composite: Composite) -> Color {
    if composite.w <= 0.0 {
        return composite;
    }
    return vec4f(composite.xyz / composite.w, composite.w);
}

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
fn output(color: Composite) -> Color {
    return finite_vec4(straight(color));
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

/// Constants of a profile, from its offset, fall-off and cut-off; made once, in f64 wherever those
/// are known before the fragment.
struct ProfileShape {
    /// cos(tau/2) and sin(tau/2).
    half_cos_offset: f32,
    half_sin_offset: f32,
    /// 1 / sin(c'/2); 0 for a step at tau and for ambient.
    scale: f32,
    /// gamma of BADF eq. 11.
    exponent: f32,
    /// tau, the step's place, in radians.
    offset: f32,
    /// Mean and standard deviation of the soft edge, measured from tau, in radians.
    edge_mean: f32,
    edge_deviation: f32,
    /// Kind of the profile: 0 soft, 1 a step at tau, 2 ambient, which is 1 everywhere.
    kind: u32,
}

/// alpha of a soft profile where the half-sine from tau is s.
fn profile_soft_quick(s: f32, shape: ProfileShape) -> f32 {
    let q = s * shape.scale;
    return select(pow(max(1.0 - q * q, 0.0), shape.exponent), 1.0, s <= 0.0);
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
fn profile_filtered_quick(u: Angle, w: f32, shape: ProfileShape) -> f32 {
    let place = vec2f(u.half_sin - 0.0, u.half_cos);
    let point = profile_soft_quick(place.x, shape);
    if w < 0.1 * shape.edge_deviation {
        return point;
    }
    let r = 0.193649167310370844 * w;
    let turn = vec2f(r * (1.0 - 0.166666666666666667 * r * r), 1.0 - 0.5 * r * r);
    let before = profile_soft_quick(place.x * turn.y - place.y * turn.x, shape);
    let after = profile_soft_quick(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

fn profile_balanced(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_turned(angle, vec2f(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

const tone_shape = ProfileShape(1.0, 0.0, 1.0378201, 0.99999684, 0.0, 1.4773875, 0.6164097, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    // Parametrization
    let turned_from_the_key = Angle(0.5 * length(surface.normal - look.key.direction), 0.5
        * length(surface.normal + look.key.direction));
    let tone = profile_balanced(turned_from_the_key, 0.0, tone_shape);
    let how_much_detail = min(cosine_power(abs(dot(surface.normal, surface.view)),
        sine_squared(surface.normal, surface.view), 1.0), 1.0);
    // Tone map
    let painted_tones = textureSample(image_1, image_1_sampler, vec2f(tone, 1.0 - how_much_detail));
    return output(premultiplied(painted_tones));
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

/// The look's color: straight RGBA.
fn look_color(in: Varyings, is_front: bool) -> vec4f {
    let facing = normalize_seen(in.normal);
    let normal = select(-facing, facing, is_front);
    let surface = Surface(normal, normalize(view.eye.xyz - view.eye.w * in.position));
    return finite_vec4(shade(surface));
}

/// For targets of colors as shown.
@fragment
fn fs_main(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    return look_color(in, is_front);
}

/// Linear light of a color as shown.
fn linear_of_shown(color: vec3f) -> vec3f {
    let high = pow((color + 0.055) / 1.055, vec3f(2.4));
    return select(high, color / 12.92, color <= vec3f(0.04045));
}

/// For targets of linear light.
@fragment
fn fs_linear(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let shown = look_color(in, is_front);
    return vec4f(linear_of_shown(shown.rgb), shown.a);
}
