// A highlight, moved: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2.
// highlight-moves.json says what to put there and how to draw.

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
    @align(16) back: Light,
    @align(16) key: Light,
    @align(16) turn_angle: f32,
    move_x: f32,
    move_y: f32,
    stretch_x: f32,
    stretch_y: f32,
    split_x: f32,
    split_y: f32,
    square_amount: f32,
    body: vec4f,
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

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return bounded(sqrt(dot(d, d)));
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

/// Shift direction
///
/// Moves a half-vector, and with it the highlight, along two axes; the same moves a light. A normal
/// that is moved takes the highlight the other way.
fn shift_direction(direction: vec3f, x_axis: vec3f, y_axis: vec3f, x: f32, y: f32) -> vec3f {
    return direction_moved(direction_within(direction, x_axis, y_axis), vec2f(x, y));
}

/// Split direction
///
/// Cuts a highlight in two along an axis and moves the halves apart, or in four along both: window
/// panes in an eye.
fn split_direction(direction: vec3f, x_axis: vec3f, y_axis: vec3f, x: f32, y: f32) -> vec3f {
    let bent = direction_within(direction, x_axis, y_axis);
    let side = select(vec2f(-1.0), vec2f(1.0), bent.place >= vec2f(0.0));
    return direction_moved(bent, -max(vec2f(x, y), vec2f(0.0)) * side);
}

/// Square direction
///
/// Gives a highlight corners: from round to a square whose sides lie along the axes.
fn square_direction(direction: vec3f, x_axis: vec3f, y_axis: vec3f, amount: f32,
    sharpness: f32) -> vec3f {
    let bent = direction_within(direction, x_axis, y_axis);
    // `corner` is 0 along either axis and 1 midway between them.
    let square = dot(bent.place, bent.place);
    // The distance from midway decides, since a high sharpness multiplies that.
    let apart = abs(bent.place.x) - abs(bent.place.y);
    let aside = clamp(apart * apart / max(square, 1e-20), 0.0, 1.0);
    let sharp = clamp(bounded(sharpness), 1.0, 1024.0);
    let corner = select(0.0, exp2_stable(sharp * LOG2_E * log1p_negative(aside)), square > 1e-20
        && aside < 1.0);
    return direction_moved(bent, -clamp(amount, 0.0, 1.0) * corner * bent.place);
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

fn blend_shade(below: Composite, color: Color, tone: f32, opacity: f32,
    clamped: bool) -> Composite {
    return blend_finish(below, below.xyz * mix(vec3f(1.0), color.xyz, tone), below.w,
        opacity * color.w, clamped);
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

/// Rim light
///
/// A line of light along the silhouette, on the side of a light: what lifts a figure off its
/// background.
fn rim(light: Light, normal: vec3f, view: vec3f, width: f32, softness: f32, follow: f32) -> f32 {
    let n = normalize_or(normal, vec3f(0.0, 0.0, 1.0));
    let facing = clamp(dot(n, view), 0.0, 1.0);
    let reach = factor_of(width, true);
    // The edge is as wide as softness wants, but never narrower than a pixel.
    let edge = max(reach * factor_of(softness, true), min(footprint_of(facing), 1.0));
    // Where the normal is nearly straight at the eye a cosine has no digits left, and the vectors'
    // difference has them.
    let aside = n - view;
    let further = select(reach - facing, 0.5 * dot(aside, aside) - (1.0 - reach), facing > 0.5);
    let within = further / max(edge, 1e-6) + select(0.5, 0.0, softness > 0.0);
    let inside = select(clamp(within, 0.0, 1.0), 0.0, reach <= 0.0);
    // `across` is the light's direction across the eye's: from the far side of the object (-1) to
    // the near one (1).
    let across = light.direction - dot(light.direction, view) * view;
    // Only the normal's part across the eye's direction counts, too: where the light is nearly
    // behind, rounding leaves a little of that direction in `across`.
    let side = dot(n - dot(n, view) * view, normalize_or(across, vec3f(0.0)));
    return inside * mixed(1.0, eased(side, 0.0, 0.5), factor_of(follow, true));
}

/// Invert
///
/// 1 minus the number: light becomes dark, a mask becomes what it left out. A color keeps its
/// alpha.
fn invert(value: f32) -> f32 {
    return bounded(1.0 - value);
}

/// Rotate vector
///
/// Turns a vector about an axis, counter-clockwise as the axis points at you.
fn rotate_vector(vector: vec3f, axis: vec3f, angle: f32) -> vec3f {
    let v = bounded_vec3(vector);
    let k = normalize_or(axis, vec3f(0.0));
    let half = sin_cos_of(0.5 * bounded(angle));
    let aside = cross(k, v);
    // By the half-angle, so that a small turn does not cancel.
    return bounded_vec3(v + 2.0 * half.x * (half.y * aside + half.x * cross(k, aside)));
}

const lit_side_shape = ProfileShape(0.8109631, 0.58509725, 4.0419726, 5.9230337, 1.25, 0.17004733, 0.08138281, 0u);
const highlight_shape = ProfileShape(0.9939561, 0.1097783, 0.0, 1.0, 0.22, 0.0, 0.0, 1u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let turned_from_the_key = parametrization_diffuse(look.key, surface.normal);
    let lit_side = profile(turned_from_the_key, 0.0, lit_side_shape);
    let in_the_dark = invert(lit_side);
    let shadow = blend_shade(look.body, vec4f(0.45, 0.36, 0.62, 1.0), in_the_dark, 1.0, true);
    let normal_2 = normal(surface.normal);
    let half = half_vector(look.key, surface.view);
    let turn = rotate_vector(vec3f(0.0, 1.0, 0.0), half, look.turn_angle);
    let axes_of_the_highlight = axes(half, turn);
    let move_2 = shift_direction(normal_2, axes_of_the_highlight.x_axis, axes_of_the_highlight.y_axis, look.move_x, look.move_y);
    let stretch = stretch_direction(move_2, axes_of_the_highlight.x_axis, axes_of_the_highlight.y_axis, look.stretch_x, look.stretch_y);
    let split = split_direction(stretch, axes_of_the_highlight.x_axis, axes_of_the_highlight.y_axis, look.split_x, look.split_y);
    let square = square_direction(split, axes_of_the_highlight.x_axis, axes_of_the_highlight.y_axis, look.square_amount, 4.0);
    let from_the_highlight = angle_between_directions(square, half);
    let highlight = profile(from_the_highlight, 0.0, highlight_shape);
    let highlight_on_top = blend_alpha(shadow, vec4f(1.0, 0.98, 0.92, 1.0), highlight, 0.96, true);
    let rim_2 = rim(look.back, surface.normal, surface.view, 0.3, 0.2, 1.0);
    let rim_s_light = blend_add(highlight_on_top, vec4f(0.55, 0.75, 1.0, 1.0), rim_2, 0.5, true);
    let output_2 = output(rim_s_light);
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
