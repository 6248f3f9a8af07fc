// Half-tone comic: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2.
// halftone-comic.json says what to put there and how to draw.

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
    @align(16) key: Light,
    @align(16) viewport: vec2f,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    pixel: vec2f,
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

/// Change of each of a point's coordinates over one pixel, finite. Call it in uniform control flow.
fn footprint_of_vec2(v: vec2f) -> vec2f {
    let dx = dpdx(v);
    let dy = dpdy(v);
    return bounded_vec2(sqrt(dx * dx + dy * dy));
}

/// Mix from the color a to the blended numbers by a factor in [0, 1], with the alpha of a.
fn color_mixed(a: vec4f, blended: vec3f, factor: f32) -> vec4f {
    return vec4f(mixed_vec3(bounded_vec3(a.xyz), bounded_vec3(blended), factor_of(factor, true)),
        bounded(a.w));
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

fn mix_colors_multiply(a: Color, b: Color, factor: f32) -> Color {
    return color_mixed(a, a.xyz * b.xyz, factor);
}

/// Facing ratio
///
/// 1 where the surface faces the eye, 0 at its rim: for rim light, outlines, dusty cloth and candy
/// edges.
fn facing(normal: vec3f, view: vec3f) -> f32 {
    return clamp(dot(normalize_or(normal, vec3f(0.0)), view), 0.0, 1.0);
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

fn parametrization_specular(light: Light, normal: vec3f, view: vec3f) -> Angle {
    let n = normalize_or(normal, vec3f(0.0, 0.0, 1.0));
    let mirrored = 2.0 * dot(n, view) * n - view;
    return angle_between(normalize_or(mirrored, n), light.direction);
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

/// p turned by an angle in radians, from x to y.
fn turned_by(p: vec2f, angle: f32) -> vec2f {
    let turn = sin_cos_of(angle);
    return vec2f(turn.y * p.x - turn.x * p.y, turn.x * p.x + turn.y * p.y);
}

/// A place in pixels, in cells of a half-tone screen that has `lines` lines to the picture's height
/// and is turned by an angle in radians.
fn screen_cells(place: vec2f, viewport: vec2f, lines: f32, angle: f32) -> vec2f {
    // Beyond 2^22 a float has no halves.
    let most = vec2f(4194304.0);
    let upright = bounded_vec2(bounded_vec2(place)
        * (max(bounded(lines), 0.0) / max(viewport.y, 1.0)));
    return clamp(turned_by(clamp(upright, -most, most), angle), -most, most);
}

/// The radius of disks around whole places that together cover `share` of the plane: beyond pi/4
/// they overlap, and at 1 they reach the middle between four.
fn dot_radius(share: f32) -> f32 {
    let t = clamp(share, 0.0, 1.0);
    let quarter = 0.785398163397448310;
    if t <= quarter {
        return sqrt(t * 0.318309886183790672);
    }
    // A disk of radius 1/(2 cos a) leaves its cell between the angles -a and a of each side, and
    // covers (pi - 4 a) / (4 cos^2 a) + tan a of it. Both ends of a are known by series; two steps
    // of Newton join them.
    let s = min((t - quarter) / (1.0 - quarter), 1.0);
    var a = mix(0.52272320087706337 * sqrt(s), quarter - 0.32756818878101679 * sqrt(1.0 - s), s);
    for (var i = 0; i < 2; i++) {
        let turn = sin_cos_quarter(clamp(a, 0.0, quarter));
        let tangent = turn.x / turn.y;
        let square = 1.0 / (turn.y * turn.y);
        let sector = 0.25 * PI - a;
        let slope = 2.0 * sector * square * tangent;
        a = clamp(a - select(0.0, (sector * square + tangent - t) / slope, slope > 1e-3), 0.0,
            quarter);
    }
    return 0.5 / sin_cos_quarter(a).y;
}

/// Share of a footprint of `w` that a disk of radius r covers whose middle is d away. The average
/// over the plane is the disk's own area, however small the disk; without a footprint its edge is
/// inclusive.
fn disk_filtered(d: f32, r: f32, w: f32) -> f32 {
    if w < 1e-30 {
        return select(0.0, 1.0, d <= r && r > 0.0);
    }
    // A ramp as wide as a pixel adds pi w^2/12 to a disk's area. A disk too small to give that back
    // is drawn fainter.
    let square = r * r;
    let least = w * w / 3.0;
    let inner = sqrt(max(square, least) - 0.25 * least);
    return clamp(0.5 + (inner - d) / w, 0.0, 1.0) * min(square / least, 1.0);
}

/// Ink of round dots that cover `share` of the plane.
fn ink_of_dots(cell: vec2f, share: f32, w: f32) -> f32 {
    let width = min(w, 1.0);
    var ink = disk_filtered(length(cell - round(cell)), dot_radius(share), width);
    // The hole between dark dots is a star; where the hole is not much larger than a pixel, a disk
    // of its size stands for it.
    let hole = sqrt(max(1.0 - share, 0.0) * 0.318309886183790672);
    let is_star = eased(width, 0.3 * hole, 0.9 * hole) * eased(share, 0.5, 0.7);
    if is_star > 0.0 {
        ink = mix(ink, 1.0 - disk_filtered(length(cell - floor(cell) - 0.5), hole, width), is_star);
    }
    // Cells as small as a pixel are their average.
    let mean = mix(ink, share, eased(w, 0.4, 1.0));
    return select(mean, share, share <= 0.0 || share >= 1.0);
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

/// Smooth step
///
/// Eases from 0 to 1 between two numbers, slowly at both ends. With low above high it eases from 1
/// to 0; where both are the same it is a step.
fn smooth_step_value(value: f32, low: f32, high: f32) -> f32 {
    return eased(value, low, high);
}

/// Half-tone
///
/// Turns a tone into dark dots, lines or crosses, as print does, whose average is the tone. Screens
/// belong to the picture's height, so that every resolution has the same ones. For print in color
/// take one node for each channel of Separate color; printers turn the screens of cyan (red's) by
/// 15 degrees, of magenta (green's) by 75, of yellow (blue's) by 0 and of black by 45.
fn halftone_dots(value: f32, place: vec2f, lines: f32, angle: f32, viewport: vec2f) -> f32 {
    let cell = screen_cells(place, viewport, lines, angle);
    let w = footprint_of_vec2(cell);
    return 1.0 - ink_of_dots(cell, 1.0 - factor_of(value, true), max(w.x, w.y));
}

const not_in_deep_shade_shape = ProfileShape(0.65243745, 0.75784254, 0.0, 1.0, 1.72, 0.0, 0.0, 1u);
const highlight_shape = ProfileShape(0.9915619, 0.12963414, 0.0, 1.0, 0.26, 0.0, 0.0, 1u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let light_and_shade = reflectance_wrap(look.key, surface.normal, 0.25);
    let red_to_print = map_range(light_and_shade, 0.1, 0.75, 0.15, 1.0, true);
    let red_dots = halftone_dots(red_to_print, surface.pixel, 78.0, 0.2617994, look.viewport);
    let red_on_yellow = mix_colors_normal(vec4f(0.91, 0.3, 0.24, 1.0), vec4f(1.0, 0.87, 0.58, 1.0), red_dots);
    let turned_from_the_light = parametrization_diffuse(look.key, surface.normal);
    let not_in_deep_shade = profile(turned_from_the_light, 0.0, not_in_deep_shade_shape);
    let deep_shade = invert(not_in_deep_shade);
    let how_much_blue = multiply(deep_shade, 0.62);
    let less = invert(how_much_blue);
    let blue_dots = halftone_dots(less, surface.pixel, 78.0, 1.3089969, look.viewport);
    let inked = invert(blue_dots);
    let blue_over_it = mix_colors_multiply(red_on_yellow, vec4f(0.24, 0.3, 0.58, 1.0), inked);
    let mirrored = parametrization_specular(look.key, surface.normal, surface.view);
    let highlight = profile(mirrored, 0.0, highlight_shape);
    let left_free = mix_colors_normal(blue_over_it, vec4f(1.0, 0.99, 0.95, 1.0), highlight);
    let facing_2 = facing(surface.normal, surface.view);
    let contour = smooth_step_value(facing_2, 0.3, 0.22);
    let black_line = mix_colors_normal(left_free, vec4f(0.09, 0.07, 0.13, 1.0), contour);
    let output_2 = output(premultiplied(black_line));
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
    surface.pixel = in.clip.xy * view.screen.xy + view.screen.zw;
    let shaded = shade(surface);
    return finite_vec4(shaded);
}
