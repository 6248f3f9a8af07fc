// Light where it is wanted: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_tensor_map 3.
// local-control.json says what to put there and how to draw.

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
    camera_from_world: mat3x3f,
    viewport: vec2f,
    @align(16) back: Light,
    @align(16) key: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    position_object: vec3f,
    position_camera: vec3f,
    curvature_tensor: vec3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var curvature_tensor_map: texture_2d<f32>;

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

/// The length of v, also where its square would over- or underflow.
fn length_of(v: vec3f) -> f32 {
    let w = bounded_vec3(v);
    let largest = max(max(abs(w.x), abs(w.y)), abs(w.z));
    if largest < SMALLEST_NORMAL {
        return 0.0;
    }
    return bounded(largest * length(w / largest));
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return bounded(sqrt(dot(d, d)));
}

/// The width of an edge whose own width is `softness`, seen through a footprint of `w`.
fn edge_width(w: f32, softness: f32) -> f32 {
    return length(vec2f(min(w, 1e15), clamp(bounded(softness), 0.0, 1e15)));
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
fn step_filtered(x: f32, edge: f32, w: f32) -> f32 {
    let d = bounded(x - edge);
    if w < 1e-30 {
        return select(0.0, 1.0, d >= 0.0);
    }
    return clamp(0.5 + bounded(d / w), 0.0, 1.0);
}

/// Straight RGBA of a premultiplied color. Where nothing covers the pixel the color is kept as it
/// is, so that light added over transparency is not lost.
fn straight(composite: Composite) -> Color {
    if composite.w <= 0.0 {
        return composite;
    }
    return vec4f(composite.xyz / composite.w, composite.w);
}

/// kappa fit for use: 0 where it is NaN, within +-1e4.
fn kappa_safe(kappa: f32) -> f32 {
    // An infinite curvature keeps its sign; only NaN has none.
    let is_nan = (bitcast<u32>(kappa) & 0x7fffffffu) > 0x7f800000u;
    return select(clamp(kappa, -1e4, 1e4), 0.0, is_nan);
}

/// Tensor fit for use: [`kappa_safe`] of each number.
fn tensor_safe(tensor: vec3f) -> vec3f {
    return vec3f(kappa_safe(tensor.x), kappa_safe(tensor.y), kappa_safe(tensor.z));
}

/// Combine tones
///
/// Cuts, joins and crosses shapes of light, as one does with shapes in a drawing program.
fn combine_tones_union(a: f32, b: f32) -> f32 {
    return max(factor_of(a, true), factor_of(b, true));
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

/// Weight of a place: 1 within the share `hardness` of the radius around the center, 0 from the
/// radius on, smooth between.
fn near_place(position: vec3f, center: vec3f, radius: f32, hardness: f32) -> f32 {
    let far = length_of(bounded_vec3(position) - bounded_vec3(center));
    let reach = max(bounded(radius), 0.0);
    return 1.0 - eased(far, reach * factor_of(hardness, true), reach);
}

/// Local light
///
/// Bends a light and changes its strength around a place on the surface, and leaves it as it is
/// elsewhere: light as an artist wants it to fall, where the real one would not.
fn local_light(
    light: Light,
    bend: vec3f,
    strength: f32,
    center: vec3f,
    radius: f32,
    hardness: f32,
    position: vec3f,
) -> Light {
    let weight = near_place(position, center, radius, hardness);
    let bent = light.direction + weight * clamp(bounded_vec3(bend), vec3f(-1e6), vec3f(1e6));
    // The direction of a sum of nearly 0 would be rounding's.
    let direction = select(light.direction, normalize_or(bent, light.direction),
        dot(bent, bent) > 1e-6 && weight > 0.0);
    let intensity = light.intensity * mixed(1.0, clamp(bounded(strength), 0.0, 1e6), weight);
    return Light(direction, light.own_direction, light.color, min(intensity, 1e30));
}

/// Local tone
///
/// Lightens or darkens a tone around a place on the surface: a highlight where none falls, a shadow
/// that is drawn back from an eye. Before a Profile's edge or before Bands, it moves their borders.
fn local_tone(tone: f32, amount: f32, center: vec3f, radius: f32, hardness: f32,
    position: vec3f) -> f32 {
    let weight = near_place(position, center, radius, hardness);
    return clamp(clamp(bounded(tone), 0.0, 1.0) + weight * clamp(bounded(amount), -1.0, 1.0), 0.0,
        1.0);
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

/// Threshold
///
/// 0 below an edge, 1 from the edge on, antialiased by its own width on the screen: cuts a hard
/// shape out of anything smooth. Where the value does not change on the screen the edge is hard,
/// and the edge itself is 1.
fn threshold(value: f32, edge: f32, softness: f32) -> f32 {
    let w = footprint_of(value);
    return step_filtered(bounded(value), bounded(edge), edge_width(w, softness));
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

/// Share of a pixel that a line covers which is `width` pixels wide and `distance` pixels away.
fn line_covers(distance: f32, width: f32) -> f32 {
    return clamp(width + 0.5 - distance, 0.0, min(width, 1.0));
}

/// Trust in curvature on the screen: 0 at the outline, where curvature has no bound and no digits,
/// 1 where the surface is seen well.
fn seen_well(facing: f32) -> f32 {
    return eased(facing, 0.05, 0.3);
}

/// Inner contour
///
/// Lines within the outline that show the form, as a draftsman sets them: where a contour is
/// about to appear, along the bottom of hollows, or along ridges.
fn inner_contour_suggestive(
    width: f32,
    limit: f32,
    softness: f32,
    tensor: vec3f,
    normal: vec3f,
    view: vec3f,
    camera_from_world: mat3x3f,
    place: vec3f,
    viewport: vec2f,
) -> f32 {
    let n = camera_from_world * normal;
    let h = tensor_safe(tensor);
    let square = dot(n.xy, n.xy);
    // The curvature in the direction in which the surface leaves the line of sight; it is 0 along
    // these lines.
    let radial = (h.x * n.x * n.x + 2.0 * h.y * n.x * n.y + h.z * n.y * n.y) / max(square, 1e-6);
    let change = vec2f(dpdx(radial), dpdy(radial));
    // `up` is 1 where the next row of pixels is farther up in the picture, -1 where it is farther
    // down.
    let v = camera_from_world * view;
    let row = dpdy(place);
    let up = select(-1.0, 1.0, (row - dot(row, v) * v).y >= 0.0);
    let height = clamp(viewport.y, 1.0, 1e5);
    let toward_eye = -(change.x * n.x + up * change.y * n.y) * inverseSqrt(max(square, 1e-6));
    let pixels = 0.5 * clamp(bounded(width), 0.0, 1e4) * height / 1000.0;
    let distance = abs(radial) / max(length(change), 1e-6);
    // Over a twentieth of the picture's height the surface is to become as curved as the limit.
    let strength = faded_in(toward_eye * height * 0.05, limit, softness);
    return line_covers(distance, pixels) * strength * seen_well(dot(normal, view));
}

/// Fade at a limit: 0 below and 1 above, over `softness` of the limit and never less than a pixel.
fn faded_in(x: f32, limit: f32, softness: f32) -> f32 {
    let at = max(bounded(limit), 0.0);
    let width = edge_width(footprint_of(x), min(at, 1e9) * factor_of(softness, true));
    return step_filtered(bounded(x), at, width);
}

/// Outer contour
///
/// The line where the surface turns out of sight, of the same width everywhere: ink around round
/// forms. It is drawn on the surface itself, so edges that are sharp have none.
fn outer_contour(width: f32, normal: vec3f, view: vec3f, viewport: vec2f) -> f32 {
    let facing = clamp(dot(normalize_or(normal, vec3f(0.0)), view), 0.0, 1.0);
    let pixels = clamp(bounded(width), 0.0, 1e4) * clamp(viewport.y, 1.0, 1e5) / 1000.0;
    // Near an outline of anything round n . v goes like the square root of the distance.
    let distance = facing / max(2.0 * footprint_of(facing), 1e-6);
    // A crease changes as fast, but far from the outline.
    let near = 1.0 - eased(facing, 0.45, 0.75);
    return line_covers(distance, pixels) * near;
}

const soft_tone_shape = ProfileShape(1.0, 0.0, 1.0, 0.9999963, 0.0, 1.5707985, 0.68337417, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let turned_to_the_face = local_light(look.key, vec3f(0.9, 0.25, 0.5), 1.0, vec3f(0.12, 0.42, 0.5), 0.5, 0.4, surface.position_object);
    let around_the_belly = local_light(turned_to_the_face, vec3f(0.4, 0.1, 0.35), 1.0, vec3f(-0.05, -0.35, 0.5), 0.4, 0.2, surface.position_object);
    let turned_from_the_light = parametrization_diffuse(around_the_belly, surface.normal);
    let soft_tone = profile(turned_from_the_light, 0.0, soft_tone_shape);
    let shadow_under_the_chin = local_tone(soft_tone, -0.45, vec3f(0.0, 0.02, 0.45), 0.3, 0.1, surface.position_object);
    let glint_on_the_brow = local_tone(shadow_under_the_chin, 0.5, vec3f(-0.2, 0.72, 0.4), 0.17, 0.5, surface.position_object);
    let lit = threshold(glint_on_the_brow, 0.55, 0.0);
    let light = blend_alpha(vec4f(0.36, 0.36, 0.6, 1.0), vec4f(0.96, 0.72, 0.47, 1.0), lit, 1.0, true);
    let brightest = threshold(glint_on_the_brow, 0.97, 0.0);
    let brightest_light = blend_alpha(light, vec4f(1.0, 0.93, 0.76, 1.0), brightest, 1.0, true);
    let rim_2 = rim(look.back, surface.normal, surface.view, 0.3, 0.1, 1.0);
    let rim_s_light = blend_alpha(brightest_light, vec4f(0.72, 0.86, 1.0, 1.0), rim_2, 0.7, true);
    let line = outer_contour(3.0, surface.normal, surface.view, look.viewport);
    let folds = inner_contour_suggestive(2.0, 20.0, 0.3, surface.curvature_tensor, surface.normal, surface.view, look.camera_from_world, surface.position_camera, look.viewport);
    let all_lines = combine_tones_union(line, folds);
    let lines = blend_alpha(rim_s_light, vec4f(0.17, 0.13, 0.28, 1.0), all_lines, 0.85, true);
    let output_2 = output(lines);
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
    surface.position_camera = (view.camera_from_world * vec4f(in.position, 1.0)).xyz;
    surface.curvature_tensor = textureLoad(curvature_tensor_map, vec2i(in.clip.xy), 0).xyz;
    let shaded = shade(surface);
    return finite_vec4(shaded);
}
