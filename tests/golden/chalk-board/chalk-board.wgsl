// Chalk: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_map 3.
// chalk-board.json says what to put there and how to draw.

struct View {
    clip_from_world: mat4x4f,
    camera_from_world: mat4x4f,
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    eye: vec4f,
    /// Pixels from the picture's upper left corner are the fragment's coordinates times xy plus zw.
    screen: vec4f,
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
    @align(16) back: Light,
    @align(16) viewport: vec2f,
    @align(16) key: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    kappa: f32,
    pixel: vec2f,
    anchor: vec3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var curvature_map: texture_2d<f32>;

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

const PI: f32 = 3.14159265358979323846;
const HALF_PI: f32 = 1.57079632679489661923;
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

/// ln(1 - y) for y in [0, 1/4], by the series of atanh.
fn log1p_negative_small(y: f32) -> f32 {
    let z = y / (2.0 - y);
    let z2 = z * z;
    return -2.0 * z * (1.0 + z2 * (0.333333333333333333
        + z2 * (0.2 + z2 * (0.142857142857142857 + z2 * 0.111111111111111111))));
}

/// sin(x) and cos(x) for |x| <= pi/2: polynomials (absolute error below 2e-7), because WGSL allows
/// 4.9e-4.
fn sin_cos_quarter(x: f32) -> vec2f {
    // x is halved to |h| <= pi/4, where short series suffice, and the result doubled. The series
    // are long enough for f64 to see sines by 1e-11, and end where they err downward: a profile
    // whose cut-off is pi is 0 there, in f64 too.
    let h = 0.5 * x;
    let h2 = h * h;
    let s = h * (1.0 + h2 * (-0.166666666666666667
        + h2 * (0.00833333333333333333 + h2 * (-0.000198412698412698413
        + h2 * (0.00000275573192239858907 + h2 * -2.50521083854417188e-8)))));
    let one_minus_c = h2 * (0.5 + h2 * (-0.0416666666666666667
        + h2 * (0.00138888888888888889 + h2 * (-0.0000248015873015873016
        + h2 * (2.75573192239858907e-7 + h2 * -2.08767569878680990e-9)))));
    let c = 1.0 - one_minus_c;
    return vec2f(2.0 * s * c, 1.0 - 2.0 * s * s);
}

/// sin(x) and cos(x) for any finite x with |x| < 1e5; [`sin_cos_quarter`] after reduction to a
/// quarter turn.
fn sin_cos(x: f32) -> vec2f {
    let turns = round(x * 0.318309886183790672);
    // Cody and Waite: pi in three parts, so that the reduced angle keeps its digits.
    let r = ((x - turns * 3.140625) - turns * 0.0009670257568359375)
        - turns * 6.27832957300962643e-7;
    let sign = 1.0 - 2.0 * abs(turns - 2.0 * trunc(turns * 0.5));
    return sign * sin_cos_quarter(clamp(r, -HALF_PI, HALF_PI));
}

/// The angle between the unit vectors d and l, from the chords |d - l| and |d + l|.
fn angle_between(d: vec3f, l: vec3f) -> Angle {
    let p = length(d - l);
    let s = length(d + l);
    let k = 1.0 / sqrt(max(p * p + s * s, 1e-30));
    return Angle(p * k, s * k);
}

/// The angle u in radians.
fn angle_radians(u: Angle) -> f32 {
    return 2.0 * atan2_positive(u.half_sin, u.half_cos);
}

/// atan2(y, x) for y, x >= 0, not both 0: a series on [0, tan(pi/8)], because WGSL allows 4096 ULP.
fn atan2_positive(y: f32, x: f32) -> f32 {
    let small = min(y, x);
    let large = max(y, x);
    if large <= 0.0 {
        return 0.0;
    }
    let t = small / large;
    // atan t = pi/4 + atan((t - 1) / (t + 1)) brings everything to |r| <= 0.4143.
    let is_wide = t > 0.41421356;
    let r = select(t, (small - large) / (small + large), is_wide);
    let r2 = r * r;
    let series = r * (1.0 + r2 * (-0.333333333333333333
        + r2 * (0.2 + r2 * (-0.142857142857142857
        + r2 * (0.111111111111111111 + r2 * (-0.0909090909090909091
        + r2 * (0.0769230769230769231 + r2 * (-0.0666666666666666667
            + r2 * 0.0588235294117647059))))))));
    let a = select(series, series + 0.785398163397448310, is_wide);
    return select(a, HALF_PI - a, y > x);
}

/// u - shift, clamped to [0, pi], for |shift| <= pi (BADF eq. 8 and docs/math.md D3).
fn angle_shifted(u: Angle, shift: f32) -> Angle {
    return angle_turned(u, sin_cos_quarter(0.5 * clamp(shift, -PI, PI)));
}

/// Change of u over one pixel, in radians: |grad u|, at most 0.5. With half-angles the gradient
/// needs no inverse trigonometry: |du| = 2 |d(sin u/2, cos u/2)|. Call it in uniform control flow.
fn angle_footprint(u: Angle) -> f32 {
    let half = vec2f(u.half_sin, u.half_cos);
    let dx = dpdx(half);
    let dy = dpdy(half);
    let w = 2.0 * sqrt(dot(dx, dx) + dot(dy, dy));
    // An infinite or NaN derivative at a silhouette gives the widest footprint.
    return min(finite_or(w, 0.5), 0.5);
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
fn angle_turned(u: Angle, t: vec2f) -> Angle {
    let s = u.half_sin * t.y - u.half_cos * t.x;
    let c = u.half_cos * t.y + u.half_sin * t.x;
    let upper = select(vec2f(s, c), vec2f(1.0, 0.0), c <= 0.0);
    // Beyond either end the smaller of s and c tells which: a turn by pi may leave the other just
    // below 0.
    let turned = select(upper, vec2f(0.0, 1.0), s <= 0.0 && s < c);
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

/// [`bounded`], component by component.
fn bounded_vec2(v: vec2f) -> vec2f {
    return vec2f(bounded(v.x), bounded(v.y));
}

/// [`bounded`], component by component.
fn bounded_vec3(v: vec3f) -> vec3f {
    return vec3f(bounded(v.x), bounded(v.y), bounded(v.z));
}

/// [`bounded`], component by component.
fn bounded_vec4(v: vec4f) -> vec4f {
    return vec4f(bounded(v.x), bounded(v.y), bounded(v.z), bounded(v.w));
}

/// Mix from a (where t is 0) to b (where t is 1): exact at both ends, and where a is b.
fn mixed(a: f32, b: f32, t: f32) -> f32 {
    let d = bounded(b - a);
    return bounded(select(b - (1.0 - t) * d, a + t * d, t < 0.5));
}

/// [`mixed`], component by component.
fn mixed_vec3(a: vec3f, b: vec3f, t: f32) -> vec3f {
    return vec3f(mixed(a.x, b.x, t), mixed(a.y, b.y, t), mixed(a.z, b.z, t));
}

/// [`mixed`], component by component.
fn mixed_vec4(a: vec4f, b: vec4f, t: f32) -> vec4f {
    return vec4f(mixed_vec3(a.xyz, b.xyz, t), mixed(a.w, b.w, t));
}

/// Place of x between low (0) and high (1), not clamped. Where low and high are the same: 0 below,
/// 1 from there on.
fn place_between(x: f32, low: f32, high: f32) -> f32 {
    let span = high - low;
    if abs(span) < SMALLEST_NORMAL {
        return select(0.0, 1.0, x >= high);
    }
    return bounded((x - low) / bounded(span));
}

/// x moved from one range to another, kept within the new one when `clamped`; an empty first range
/// makes a step.
fn remapped(x: f32, from_low: f32, from_high: f32, to_low: f32, to_high: f32,
    clamped: bool) -> f32 {
    let place = place_between(bounded(x), bounded(from_low), bounded(from_high));
    return mixed(bounded(to_low), bounded(to_high), select(place, clamp(place, 0.0, 1.0), clamped));
}

/// Smooth step: 0 up to low and 1 from high on, t^2 (3 - 2t) between; falling where low is above
/// high, a step where they are equal.
fn eased(x: f32, low: f32, high: f32) -> f32 {
    let t = clamp(place_between(bounded(x), bounded(low), bounded(high)), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// A factor as it is, or kept within 0 and 1 when `clamped`.
fn factor_of(x: f32, clamped: bool) -> f32 {
    return select(bounded(x), clamp(bounded(x), 0.0, 1.0), clamped);
}

/// sin(x) and cos(x) for every x; beyond 100,000 rounding leaves nothing of the phase, and the
/// result lies in [-1, 1].
fn sin_cos_of(x: f32) -> vec2f {
    return clamp(sin_cos(bounded(x)), vec2f(-1.0), vec2f(1.0));
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

/// Mix colors
///
/// Lays one color on another as paint programs do. For a stack of shading layers take Blend, which
/// knows tones and transparency.
fn mix_colors_normal(a: Color, b: Color, factor: f32) -> Color {
    return mixed_vec4(bounded_vec4(a), bounded_vec4(b), factor_of(factor, true));
}

/// kappa fit for use: 0 where it is NaN, within +-1e4.
fn kappa_safe(kappa: f32) -> f32 {
    // An infinite curvature keeps its sign; only NaN has none.
    let is_nan = (bitcast<u32>(kappa) & 0x7fffffffu) > 0x7f800000u;
    return select(clamp(kappa, -1e4, 1e4), 0.0, is_nan);
}

/// 2 lambda - 1 = tanh(kappa slope), in [-1, 1].
fn curvature_signed(kappa: f32, slope: f32) -> f32 {
    let a = kappa_safe(kappa) * clamp(finite_or(slope, 0.0), -1e30, 1e30);
    let magnitude = min(abs(a), 50.0);
    if magnitude < 0.0625 {
        // 1 - z cancels for small a; the series does not.
        let a2 = a * a;
        return a * (1.0 - a2 * (0.333333333333333333
            - a2 * (0.133333333333333333 - a2 * 0.0539682539682539683)));
    }
    let z = exp2_stable(-2.0 * LOG2_E * magnitude);
    let t = (1.0 - z) / (1.0 + z);
    return select(-t, t, a >= 0.0);
}

/// Curvature transition
///
/// From concave (0) over flat (0.5) to convex (1), as softly or sharply as you choose. (The BADF
/// paper writes it lambda = 0.5 + 0.5 tanh(slope * kappa), with kappa for the curvature.)
fn transition(kappa: f32, slope: f32) -> f32 {
    return 0.5 + 0.5 * curvature_signed(kappa, slope);
}

/// Curvature
///
/// How much the surface bulges (above 0) or is hollow (below 0), as it is seen. It is measured
/// against the picture's height, so that detail comes forward as the camera does.
fn kappa_surface(kappa: f32) -> f32 {
    return kappa_safe(kappa);
}

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
fn output(color: Composite) -> Color {
    return finite_vec4(straight(color));
}

/// Parametrization
///
/// The angle u between a light and a direction of the surface; it decides how shading moves.
/// Diffuse stays on the surface, Specular moves with the eye, Half-vector is Blinn's highlight,
/// Screen-aligned ignores the illumination frame and the camera: the light is read in the picture's
/// own axes.
fn parametrization_diffuse(light: Light, normal: vec3f) -> Angle {
    return angle_between(normalize_or(normal, vec3f(0.0, 0.0, 1.0)), light.direction);
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

const PROFILE_STEP: u32 = 1u;
const PROFILE_AMBIENT: u32 = 2u;
/// alpha at one angle, without antialiasing; `u` is warped already.
fn profile_point(u: Angle, shape: ProfileShape) -> f32 {
    let s = u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset;
    if s <= 0.0 || shape.kind == PROFILE_AMBIENT {
        return 1.0;
    }
    if shape.kind == PROFILE_STEP {
        // Inclusive (D4), also where rounding puts u = tau on the far side.
        return select(0.0, 1.0, s <= 4e-7);
    }
    let q = s * shape.scale;
    return profile_power(q, shape.exponent);
}

/// (1 - q^2)^exponent for q >= 0; 0 from q = 1 on.
fn profile_power(q: f32, exponent: f32) -> f32 {
    if q >= 1.0 {
        return 0.0;
    }
    var log_base = 0.0;
    if q < 0.5 {
        log_base = log1p_negative_small(q * q);
    } else {
        log_base = log_stable((1.0 - q) * (1.0 + q));
    }
    return clamp(exp2_stable(exponent * LOG2_E * log_base), 0.0, 1.0);
}

/// alpha averaged over a footprint of `w` radians (docs/math.md 2.4): the hard step where w is 0, a
/// ramp of the gradient's width where the edge is narrower than a pixel, three-point Gauss
/// quadrature where it is narrow, the point value where it is wide.
fn profile_filtered(u: Angle, w: f32, shape: ProfileShape) -> f32 {
    let point = profile_point(u, shape);
    if w <= 0.0 || shape.kind == PROFILE_AMBIENT {
        return point;
    }
    // No footprint is above 0.5, so that this branch is not even compiled for an edge that is known
    // to be softer.
    if shape.edge_deviation < 0.145 && w >= 3.46410161513775459 * shape.edge_deviation {
        let width = sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
        return clamp(0.5 + (shape.offset + shape.edge_mean - angle_radians(u)) / width, 0.0, 1.0);
    }
    if w < 0.1 * shape.edge_deviation {
        return point;
    }
    let reach = sin_cos_quarter(0.193649167310370844 * w);
    let before = profile_point(angle_turned(u, reach), shape);
    let after = profile_point(angle_turned(u, vec2f(-reach.x, reach.y)), shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

/// Profile
///
/// Turns an angle into a tone: 1 up to the offset, then falling to 0 at the cut-off, steepest at
/// the fall-off. Edges are as sharp as asked and antialiased by their width on the screen.
///
/// Up to an offset of 90 degrees below the fall-off the curve has one inflection, at the fall-off;
/// beyond that the curve is still falling, but it is steepest elsewhere too.
fn profile(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_shifted(angle, shift);
    return profile_filtered(warped, angle_footprint(warped), shape);
}

/// Three random 32-bit numbers for every triple of them (PCG3D: Jarzynski and Olano 2020). Its
/// upper bits are the best.
fn hash_pcg3d(seed: vec3u) -> vec3u {
    var v = seed * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> vec3u(16u);
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

/// The hash of a lattice point.
fn lattice_hash(cell: vec3i, seed: u32) -> vec3u {
    return hash_pcg3d(bitcast<vec3u>(cell) + seed * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u));
}

/// The dot product of d with one of the twelve directions to a cube's edges, by a hash (Perlin
/// 2002).
fn gradient_dot(hash: vec3u, d: vec3f) -> f32 {
    let axis = (hash.x >> 8u) % 3u;
    let a = select(d.x, d.y, axis == 0u);
    let b = select(d.z, d.y, axis == 2u);
    return select(-a, a, (hash.y >> 31u) == 0u) + select(-b, b, (hash.z >> 31u) == 0u);
}

/// t^3 (6 t^2 - 15 t + 10): smooth to the second derivative.
fn fade_quintic(t: vec3f) -> vec3f {
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

/// Improved gradient noise (Perlin 2002), 1/2 on the lattice.
fn perlin_noise(p: vec3f, seed: u32) -> f32 {
    let corner = floor(p);
    let d = p - corner;
    let f = fade_quintic(d);
    let cell = vec3i(corner);
    var sum = 0.0;
    for (var i = 0; i < 8; i++) {
        let at = vec3i(i & 1, (i >> 1u) & 1, i >> 2u);
        let weight = select(1.0 - f, f, at == vec3i(1));
        sum += weight.x * weight.y * weight.z * gradient_dot(lattice_hash(cell + at, seed), d
            - vec3f(at));
    }
    // The twelve gradients reach 1.0364 at most.
    return clamp(0.5 + 0.48244 * sum, 0.0, 1.0);
}

/// Size on screen of a unit of the scene at a depth, in picture heights. `perspective` is 1 or 0;
/// `scale` is what clip space multiplies heights by: at depth 1, or at every depth without
/// perspective.
fn size_on_screen(depth: f32, perspective: f32, scale: f32) -> f32 {
    // Clip space is 2 high.
    return bounded(0.5 * scale / mix(1.0, max(depth, 1e-6), perspective));
}

/// Place on screen of a point in camera axes, from the picture's middle, x to the right and y down,
/// and in z the size there of a unit of the scene; in picture heights.
fn anchor_on_screen(origin: vec3f, perspective: f32, scale: f32) -> vec3f {
    let size = size_on_screen(-origin.z, perspective, scale);
    return bounded_vec3(vec3f(origin.x * size, -origin.y * size, size));
}

/// A pixel's place from the picture's middle, x to the right and y up, in picture heights.
fn place_in_picture(pixel: vec2f, viewport: vec2f) -> vec2f {
    let from_middle = bounded_vec2(pixel) - 0.5 * viewport;
    return vec2f(from_middle.x, -from_middle.y) / max(viewport.y, 1.0);
}

/// A place for marks.
struct StretchedPlace {
    /// Coordinates along the strokes and across them.
    place: vec2f,
    /// Rates at which both coordinates change along the picture: products xx, xy and yy, per
    /// picture height.
    stretch: vec3f,
}

/// A place whose coordinates change along the picture by the gradients `along` and `across`, turned
/// by an angle in radians.
fn mark_place_of(place: vec2f, along: vec3f, across: vec3f, angle: f32) -> StretchedPlace {
    let turn = sin_cos_of(angle);
    let x = bounded_vec3(turn.y * along + turn.x * across);
    let y = bounded_vec3(turn.y * across - turn.x * along);
    let at = bounded_vec2(place);
    let turned = vec2f(turn.y * at.x + turn.x * at.y, turn.y * at.y - turn.x * at.x);
    let most = vec3f(1e15);
    let stretch = clamp(vec3f(dot(x, x), dot(x, y), dot(y, y)), -most, most);
    return StretchedPlace(bounded_vec2(turned), stretch);
}

/// A place in spacings of marks, with its stretch.
struct SpacedPlace {
    place: vec2f,
    stretch: vec3f,
}

/// The place in spacings, `count` of them to the picture's height where it is not stretched. A
/// place without a stretch is one in pixels.
fn spaced(place: vec2f, stretch: vec3f, viewport: vec2f, count: f32) -> SpacedPlace {
    let number = clamp(bounded(count), 0.0, 1e5);
    let is_pixel = !(stretch.x + stretch.z > 0.0);
    let scale = select(number, number / max(viewport.y, 1.0), is_pixel);
    // Beyond 2^22 a float has nothing left between whole numbers.
    let p = clamp(bounded_vec2(bounded_vec2(place) * scale), vec2f(-4194304.0), vec2f(4194304.0));
    let s = clamp(bounded_vec3(stretch), vec3f(-1e15), vec3f(1e15));
    return SpacedPlace(p, select(s, vec3f(1.0, 0.0, 1.0), is_pixel));
}

/// Square of the rate at which a place's area grows with the picture's. A place that is drawn out
/// more than eight times counts as drawn out by eight: where a surface stands edge-on to the
/// place's plane the area does not grow at all, and marks along that line would be infinitely fine.
fn area_square(stretch: vec3f) -> f32 {
    let sum = stretch.x + stretch.z;
    return max(stretch.x * stretch.z - stretch.y * stretch.y, sum * sum / 66.0);
}

/// Octave of the marks at a place: log2 of how many times finer than the place's own units they
/// must lie, for a squared stretch; within +-16.
fn octave_of(square: f32) -> f32 {
    return clamp(-0.5 * LOG2_E * log_stable(clamp(square, 1e-30, 1e30)), -16.0, 16.0);
}

fn mark_place_object(angle: f32, anchor: vec3f, pixel: vec2f, viewport: vec2f) -> MarkPlace {
    let size = clamp(bounded(anchor.z), 1e-6, 1e6);
    let place = bounded_vec2(place_in_picture(pixel, viewport) - vec2f(anchor.x, -anchor.y)) / size;
    let m = mark_place_of(place, vec3f(1.0 / size, 0.0, 0.0), vec3f(0.0, 1.0 / size, 0.0), angle);
    return MarkPlace(m.place, m.stretch);
}

struct MarkPlace {
    /// Along the strokes, and across them.
    place: vec2f,
    /// How fast both change along the picture: products xx, xy and yy, per picture height.
    stretch: vec3f,
}

/// Ink that the tooth of paper takes: more on its heights and less in its hollows, most so at
/// middle tones, and none of no ink (Kalnins et al. 2002). `height` is from 0 to 1, `tooth` from 0
/// (smooth paper) to 1.
fn caught_ink(ink: f32, height: f32, tooth: f32) -> f32 {
    let amount = clamp(bounded(ink), 0.0, 1.0);
    let rough = clamp(bounded(tooth), 0.0, 1.0);
    return clamp(amount + 8.0 * rough * (height - 0.5) * amount * (1.0 - amount), 0.0, 1.0);
}

/// The height of paper, from 0 to 1 and 1/2 on average. Where an octave fades into the next, both
/// octaves are seen.
fn paper_height(at: SpacedPlace, fiber: f32, seed: u32) -> f32 {
    let x = dpdx(at.place);
    let y = dpdy(at.place);
    let w = bounded(sqrt(max(dot(x, x), dot(y, y))));
    let level = octave_of(sqrt(area_square(at.stretch)));
    let zoom = floor(level);
    let f = level - zoom;
    let fine = clamp(bounded(fiber), 0.0, 1.0);
    var height = paper_octave(at.place, i32(zoom), w, fine, seed);
    if f > 0.0 {
        // Two octaves in one are flatter than each: the contrast that they lose is given back.
        let both = mix(height, paper_octave(at.place, i32(zoom) + 1, w, fine, seed), f);
        height = clamp(0.5 + (both - 0.5) / sqrt(f * f + (1.0 - f) * (1.0 - f)), 0.0, 1.0);
    }
    return height;
}

/// The height of paper in one octave; paper finer than a pixel is flat.
fn paper_octave(place: vec2f, zoom: i32, w: f32, fiber: f32, seed: u32) -> f32 {
    let scale = power_of_two(zoom);
    let p = clamp(place * scale, vec2f(-4194304.0), vec2f(4194304.0));
    let own = seed + 7u * bitcast<u32>(zoom);
    let grain = perlin_noise(vec3f(p, 0.5), own) - 0.5;
    // The felt that the sheet was pressed on: finer, turned, and long in no direction.
    let q = clamp(2.7 * vec2f(0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y), vec2f(-4194304.0),
        vec2f(4194304.0));
    let felt = perlin_noise(vec3f(q, 0.5), own + 1u) - 0.5;
    let coarse_seen = 1.0 - eased(w * scale, 0.5, 1.0);
    let felt_seen = 1.0 - eased(2.7 * w * scale, 0.5, 1.0);
    return clamp(0.5 + 1.4 * (coarse_seen * grain + fiber * felt_seen * felt), 0.0, 1.0);
}

/// Paper grain
///
/// The tooth of paper: heights catch more ink than hollows, most at middle tones, as chalk,
/// charcoal and a dry wash do. It lies on the picture; with Mark place's Object it moves along with
/// an object and does not swim through it.
fn paper_grain(
    value: f32,
    place: vec2f,
    stretch: vec3f,
    count: f32,
    tooth: f32,
    fiber: f32,
    seed: i32,
    viewport: vec2f,
) -> PaperGrain {
    let height = paper_height(spaced(place, stretch, viewport, count), fiber, bitcast<u32>(seed));
    return PaperGrain(1.0 - caught_ink(1.0 - factor_of(value, true), height, tooth), height);
}

struct PaperGrain {
    /// The tone as the paper shows it.
    tone: f32,
    /// The paper's own height, from 0 to 1: for a bump map, or to tint the paper.
    height: f32,
}

fn reflectance_wrap(light: Light, normal: vec3f, wrap: f32) -> f32 {
    let w = clamp(bounded(wrap), 0.0, 1.0);
    let cosine = dot(normalize_or(normal, vec3f(0.0, 0.0, 1.0)), light.direction);
    return max((cosine + w) / (1.0 + w), 0.0);
}

/// Invert
///
/// 1 minus the number: light becomes dark, a mask becomes what it left out. A color keeps its
/// alpha.
fn invert(value: f32) -> f32 {
    return bounded(1.0 - value);
}

/// Map range
///
/// Moves numbers from one range to another: depth to fog, curvature to a mask. Where the first
/// range is empty, all that is below it becomes the new low and the rest the new high. A color
/// keeps its alpha, within 0 and 1 while clamped.
fn map_range(value: f32, from_low: f32, from_high: f32, to_low: f32, to_high: f32,
    clamped: bool) -> f32 {
    return remapped(value, from_low, from_high, to_low, to_high, clamped);
}

/// Multiply
///
/// The product of two numbers, vectors or colors, component by component: scales, masks and tints.
fn multiply(a: f32, b: f32) -> f32 {
    return bounded(a * b);
}

const orange_chalk_shape = ProfileShape(0.9689124, 0.24740396, 2.425296, 2.1444545, 0.5, 0.43399706, 0.1847509, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let shade_2 = reflectance_wrap(look.key, surface.normal, 0.15);
    let tone = map_range(shade_2, 0.0, 0.9, 0.0, 1.0, true);
    let rubbed = map_range(tone, 0.0, 0.6, 0.05, 0.5, true);
    let r_bare = invert(rubbed);
    let board = mark_place_object(0.0, surface.anchor, surface.pixel, look.viewport);
    let r_grain = paper_grain(r_bare, board.place, board.stretch, 120.0, 0.6, 0.5, 5i, look.viewport);
    let r_on = invert(r_grain.tone);
    let blue_gray = mix_colors_normal(vec4f(0.1216, 0.1647, 0.1686, 1.0), vec4f(0.4275, 0.5098, 0.5647, 1.0), r_on);
    let turn = parametrization_diffuse(look.back, surface.normal);
    let orange_chalk = profile(turn, 0.0, orange_chalk_shape);
    let o_bare = invert(orange_chalk);
    let o_grain = paper_grain(o_bare, board.place, board.stretch, 220.0, 0.8, 0.5, 9i, look.viewport);
    let o_on = invert(o_grain.tone);
    let orange = mix_colors_normal(blue_gray, vec4f(0.9412, 0.6353, 0.3608, 1.0), o_on);
    let curvature = kappa_surface(surface.kappa);
    let hollow_to_bulge = transition(curvature, 0.16);
    let bare_in_hollows = map_range(hollow_to_bulge, 0.15, 0.5, 0.1, 1.0, true);
    let white_chalk = multiply(tone, bare_in_hollows);
    let w_bare = invert(white_chalk);
    let w_grain = paper_grain(w_bare, board.place, board.stretch, 260.0, 0.62, 0.5, 3i, look.viewport);
    let w_on = invert(w_grain.tone);
    let white = mix_colors_normal(orange, vec4f(0.9686, 0.9529, 0.9098, 1.0), w_on);
    let output_2 = output(premultiplied(white));
    return output_2;
}

struct Vertex {
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
}

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) normal: vec3f,
}

@vertex
fn vs_main(vertex: Vertex) -> Varyings {
    let world = object.world_from_object * vec4f(vertex.position, 1.0);
    var out: Varyings;
    out.clip = view.clip_from_world * world;
    out.normal = object.world_from_normal * vertex.normal;
    return out;
}

@fragment
fn fs_main(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let facing = normalize_or(in.normal, vec3f(0.0, 0.0, 1.0));
    let normal = select(-facing, facing, is_front);
    var surface: Surface;
    surface.normal = normal;
    surface.kappa = textureLoad(curvature_map, vec2i(in.clip.xy), 0).x;
    surface.pixel = in.clip.xy * view.screen.xy + view.screen.zw;
    surface.anchor = anchor_on_screen((view.camera_from_world * vec4f(object.world_from_object[3].xyz, 1.0)).xyz, view.eye.w, length(vec3f(view.clip_from_world[0].y, view.clip_from_world[1].y, view.clip_from_world[2].y)));
    let shaded = shade(surface);
    return finite_vec4(shaded);
}
