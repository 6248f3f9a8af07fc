// Silk: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2.
// silk-ring.json says what to put there and how to draw.

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
    @align(16) low: Light,
    @align(16) key: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    position_object: vec3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;

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
fn bounded_vec3(v: vec3f) -> vec3f {
    return vec3f(bounded(v.x), bounded(v.y), bounded(v.z));
}

/// Mix from a (where t is 0) to b (where t is 1): exact at both ends, and where a is b.
fn mixed(a: f32, b: f32, t: f32) -> f32 {
    let d = bounded(b - a);
    return bounded(select(b - (1.0 - t) * d, a + t * d, t < 0.5));
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

/// Distance that a point moves over one pixel: the longer of its two derivatives, finite. Call it
/// in uniform control flow.
fn footprint_of_vec3(v: vec3f) -> f32 {
    let dx = dpdx(v);
    let dy = dpdy(v);
    return bounded(sqrt(max(dot(dx, dx), dot(dy, dy))));
}

/// Straight RGBA of a premultiplied color. Where nothing covers the pixel the color is kept as it
/// is, so that light added over transparency is not lost.
fn straight(composite: Composite) -> Color {
    if composite.w <= 0.0 {
        return composite;
    }
    return vec4f(composite.xyz / composite.w, composite.w);
}

/// A unit vector at right angles to the unit vector n, smooth but at one pole (Duff et al. 2017).
fn any_orthogonal(n: vec3f) -> vec3f {
    let sign = select(-1.0, 1.0, n.z >= 0.0);
    let a = -1.0 / (sign + n.z);
    return vec3f(1.0 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x);
}

/// Normal
///
/// The surface's normal in world space, toward the side that is seen.
fn normal(normal: vec3f) -> vec3f {
    return normal;
}

fn position_object(position_object: vec3f) -> vec3f {
    return position_object;
}

/// Angle between directions
///
/// The angle that a Profile turns into a tone, between any two directions: a bent half-vector and
/// the normal, a hair's tangent and a light.
fn angle_between_directions(a: vec3f, b: vec3f) -> Angle {
    let z = vec3f(0.0, 0.0, 1.0);
    return angle_between(normalize_or(a, z), normalize_or(b, z));
}

/// A direction with the two axes along which it is bent.
struct DirectionParts {
    /// Unit.
    direction: vec3f,
    x_axis: vec3f,
    y_axis: vec3f,
    /// The direction's cosines with the two axes.
    place: vec2f,
}

/// The direction and its axes, made unit; an axis without a direction does nothing, a direction
/// without one is +z.
fn direction_within(direction: vec3f, x_axis: vec3f, y_axis: vec3f) -> DirectionParts {
    let d = normalize_or(direction, vec3f(0.0, 0.0, 1.0));
    let x = normalize_or(x_axis, vec3f(0.0));
    let y = normalize_or(y_axis, vec3f(0.0));
    return DirectionParts(d, x, y, vec2f(dot(d, x), dot(d, y)));
}

/// The direction moved along its axes by `by`, and unit again; unmoved where nothing is left of it.
fn direction_moved(parts: DirectionParts, by: vec2f) -> vec3f {
    // Farther than a million the direction lies along the axis.
    let step = clamp(by, vec2f(-1e6), vec2f(1e6));
    let moved = parts.direction + step.x * parts.x_axis + step.y * parts.y_axis;
    // The direction of a sum of nearly 0 would be rounding's.
    return select(parts.direction, normalize_or(moved, parts.direction), dot(moved, moved) > 1e-6);
}

/// Unit axes as columns: to the right and upright, both at right angles to `toward`, and `toward`
/// itself; upright lies along `up` as far as that goes.
fn axes_around(toward: vec3f, up: vec3f) -> mat3x3f {
    let z = normalize_or(toward, vec3f(0.0, 0.0, 1.0));
    let y = normalize_or(up, vec3f(0.0, 1.0, 0.0));
    let leaning = cross(y, z);
    let square = dot(leaning, leaning);
    // Where `toward` is nearly along `up` no direction is upright; a fixed one is better than
    // rounding's.
    let aside = select(vec3f(1.0, 0.0, 0.0), vec3f(0.0, 0.0, 1.0), abs(z.x) > 0.7);
    let across = select(cross(aside, z), leaning, square > 1e-8);
    // The part along z that rounding left in `across`, short as that may be, would tilt x.
    let x = normalize_or(across - dot(across, z) * z, vec3f(1.0, 0.0, 0.0));
    return mat3x3f(x, cross(z, x), z);
}

/// Axes around a direction
///
/// Two directions at right angles to a light or a half-vector: the axes along which a highlight is
/// moved, stretched or split so that it keeps its shape on every object, whatever its texture
/// coordinates.
fn axes(direction: vec3f, up: vec3f) -> AxesAround {
    let axes = axes_around(direction, up);
    return AxesAround(axes[0], axes[1]);
}

struct AxesAround {
    /// Unit, to the right as seen against the direction.
    x_axis: vec3f,
    /// Unit, upright.
    y_axis: vec3f,
}

/// Half-vector
///
/// Midway between a light and the eye. A highlight lies where it meets the normal: bend either of
/// them with the nodes beside this one, measure the Angle between directions, and the highlight
/// takes another shape.
fn half_vector(light: Light, view: vec3f) -> vec3f {
    let half = light.direction + view;
    return normalize_or(select(any_orthogonal(view), half, dot(half, half) > 1e-12), view);
}

/// Stretch direction
///
/// Makes a highlight longer along an axis (above 0) or shorter (below 0): streaks of silk, hair and
/// brushed metal.
fn stretch_direction(direction: vec3f, x_axis: vec3f, y_axis: vec3f, x: f32, y: f32) -> vec3f {
    let bent = direction_within(direction, x_axis, y_axis);
    return direction_moved(bent, -min(vec2f(x, y), vec2f(1.0)) * bent.place);
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

fn blend_alpha(below: Composite, color: Color, tone: f32, opacity: f32,
    clamped: bool) -> Composite {
    let a = opacity * color.w;
    let alpha = below.w + tone * a * (1.0 - below.w);
    return blend_finish(below, below.xyz + tone * (color.xyz - below.xyz), alpha, a, clamped);
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

const NOISE_PERLIN: u32 = 1u;
const NOISE_SIMPLEX: u32 = 2u;
const NOISE_WORLEY: u32 = 3u;
const SIMPLEX_SCALE: f32 = 38.4553;
const WORLEY_MEAN: f32 = 0.5205;
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

/// A random number in [0, 1) from the upper 24 bits of a hash, exactly.
fn unit_of_hash(hash: vec3u) -> vec3f {
    return vec3f(hash >> vec3u(8u)) * 5.9604644775390625e-8;
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

/// Value noise: random numbers at lattice points, smooth between them.
fn value_noise(p: vec3f, seed: u32) -> f32 {
    let corner = floor(p);
    let f = fade_quintic(p - corner);
    let cell = vec3i(corner);
    var sum = 0.0;
    for (var i = 0; i < 8; i++) {
        let at = vec3i(i & 1, (i >> 1u) & 1, i >> 2u);
        let weight = select(1.0 - f, f, at == vec3i(1));
        sum += weight.x * weight.y * weight.z * unit_of_hash(lattice_hash(cell + at, seed)).x;
    }
    return sum;
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

/// Gradient noise on a lattice of tetrahedra (Perlin 2001), with fewer visible axes than the
/// cube's.
fn simplex_noise(p: vec3f, seed: u32) -> f32 {
    let corner = floor(p + (p.x + p.y + p.z) / 3.0);
    let d = p - corner + (corner.x + corner.y + corner.z) / 6.0;
    // The tetrahedron's corners follow the order of the components.
    let is_first = vec3<bool>(d.x >= d.y, d.y >= d.z, d.z > d.x);
    let g = select(vec3f(0.0), vec3f(1.0), is_first);
    let l = 1.0 - g;
    let second = min(g, l.zxy);
    let third = max(g, l.zxy);
    let cell = vec3i(corner);
    var sum = simplex_corner(d, lattice_hash(cell, seed));
    sum += simplex_corner(d - second + 1.0 / 6.0, lattice_hash(cell + vec3i(second), seed));
    sum += simplex_corner(d - third + 1.0 / 3.0, lattice_hash(cell + vec3i(third), seed));
    sum += simplex_corner(d - 0.5, lattice_hash(cell + vec3i(1), seed));
    return clamp(0.5 + SIMPLEX_SCALE * sum, 0.0, 1.0);
}

/// Contribution of one corner of a tetrahedron at the offset d from it.
fn simplex_corner(d: vec3f, hash: vec3u) -> f32 {
    let t = max(0.5 - dot(d, d), 0.0);
    return t * t * t * t * gradient_dot(hash, d);
}

/// The distance to the nearest of one random point per cell (Worley 1996), at most 1.
fn worley_noise(p: vec3f, seed: u32) -> f32 {
    let corner = floor(p);
    let d = p - corner;
    let cell = vec3i(corner);
    // Beyond the neighbors every point is at least 1 away.
    var nearest = 1.0;
    for (var i = 0; i < 27; i++) {
        let at = vec3i(i % 3 - 1, (i / 3) % 3 - 1, i / 9 - 1);
        let offset = vec3f(at) + unit_of_hash(lattice_hash(cell + at, seed)) - d;
        nearest = min(nearest, dot(offset, offset));
    }
    return sqrt(nearest);
}

/// One octave of the noise of a kind, `NOISE_VALUE` to `NOISE_WORLEY`.
fn noise_octave(kind: u32, p: vec3f, seed: u32) -> f32 {
    switch kind {
        case NOISE_PERLIN: {
            return perlin_noise(p, seed);
        }
        case NOISE_SIMPLEX: {
            return simplex_noise(p, seed);
        }
        case NOISE_WORLEY: {
            return worley_noise(p, seed);
        }
        default: {
            return value_noise(p, seed);
        }
    }
}

/// Sum of 1 to 8 octaves of noise, each twice as fine as the one before and `roughness` times as
/// strong, weighed so that the sum stays in [0, 1]. An octave finer than the footprint `w` of p
/// fades to its average, so that distance does not make it flicker.
fn fractal_noise(kind: u32, p: vec3f, octaves: i32, roughness: f32, seed: i32, w: f32) -> f32 {
    let mean = select(0.5, WORLEY_MEAN, kind == NOISE_WORLEY);
    let gain = clamp(bounded(roughness), 0.0, 1.0);
    var sum = 0.0;
    var total = 0.0;
    var strength = 1.0;
    var frequency = 1.0;
    for (var i = 0; i < clamp(octaves, 1, 8); i++) {
        let visible = 1.0 - eased(w * frequency, 0.5, 1.0);
        var octave = mean;
        if visible > 0.0 {
            // Octaves are taken from different places, so that their lattices do not meet at the
            // origin. Beyond 2^22 a float has no digits left for what lies between lattice points.
            let place = clamp(p * frequency + f32(i) * vec3f(17.31, 5.17, 11.73), vec3f(-4194304.0),
                vec3f(4194304.0));
            octave = mix(mean, noise_octave(kind, place, bitcast<u32>(seed) + u32(i)), visible);
        }
        sum += strength * octave;
        total += strength;
        strength *= gain;
        frequency *= 2.0;
    }
    return clamp(sum / total, 0.0, 1.0);
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

fn noise_perlin(position: vec3f, scale: f32, octaves: i32, roughness: f32, seed: i32) -> f32 {
    let p = bounded_vec3(position * scale);
    return fractal_noise(NOISE_PERLIN, p, octaves, roughness, seed, footprint_of_vec3(p));
}

const lit_side_shape = ProfileShape(0.9950042, 0.099833414, 1.1883951, 1.7298278, 0.2, 1.0107075, 0.4419037, 0u);
const band_shape = ProfileShape(0.9998875, 0.014999437, 9.541332, 4.980432, 0.03, 0.07759806, 0.03648918, 0u);
const second_band_shape = ProfileShape(1.0, 0.0, 6.6917324, 12.899528, 0.0, 0.07171497, 0.035865854, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let turned_from_the_key = parametrization_diffuse(look.key, surface.normal);
    let lit_side = profile(turned_from_the_key, 0.0, lit_side_shape);
    let body = blend_alpha(vec4f(0.2275, 0.102, 0.2431, 1.0), vec4f(0.4824, 0.1843, 0.3882, 1.0), lit_side, 1.0, true);
    let normal_2 = normal(surface.normal);
    let half = half_vector(look.key, surface.view);
    let upright = axes(half, vec3f(0.0, 1.0, 0.0));
    let band_without_end = stretch_direction(normal_2, upright.x_axis, upright.y_axis, 0.985, 0.0);
    let from_the_band = angle_between_directions(band_without_end, half);
    let place = position_object(surface.position_object);
    let strands = noise_perlin(place, 14.0, 2i, 0.5, 0i);
    let waver = map_range(strands, 0.0, 1.0, -0.05, 0.05, true);
    let band = profile(from_the_band, waver, band_shape);
    let band_on_top = blend_alpha(body, vec4f(0.9529, 0.6627, 0.7059, 1.0), band, 0.95, true);
    let low_half = half_vector(look.low, surface.view);
    let upright_2 = axes(low_half, vec3f(0.0, 1.0, 0.0));
    let second_band = stretch_direction(normal_2, upright_2.x_axis, upright_2.y_axis, 0.985, 0.0);
    let from_the_second = angle_between_directions(second_band, low_half);
    let second_band_2 = profile(from_the_second, waver, second_band_shape);
    let second_band_on_top = blend_add(band_on_top, vec4f(0.3529, 0.2471, 0.549, 1.0), second_band_2, 0.8, true);
    let output_2 = output(second_band_on_top);
    return output_2;
}

struct Vertex {
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
}

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) position_object: vec3f,
    @location(2) normal: vec3f,
}

@vertex
fn vs_main(vertex: Vertex) -> Varyings {
    let world = object.world_from_object * vec4f(vertex.position, 1.0);
    var out: Varyings;
    out.clip = view.clip_from_world * world;
    out.position = world.xyz;
    out.position_object = vertex.position;
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
    surface.position_object = in.position_object;
    let shaded = shade(surface);
    return finite_vec4(shaded);
}
