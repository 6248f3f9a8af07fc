// Directional control: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_map 3.
// figure5-directional.json says what to put there and how to draw.

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
    highlight_color_convex: vec4f,
    highlight_color_concave: vec4f,
    @align(16) key: Light,
    @align(16) back_light_color_convex: vec4f,
    back_light_color_concave: vec4f,
    back_light_warp_amount: f32,
    @align(16) back: Light,
    @align(16) back_light_tone_shape: ProfileShape,
    @align(16) diffuse_tone_shape: ProfileShape,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    kappa: f32,
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

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
fn exp2_stable_2(x: f32) -> f32 {
    let clamped = max(x, -126.0);
    let whole = round(clamped);
    let f = clamped - whole;
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

/// [`sin_cos_quarter`] for |x| <= pi/4, where the series need no half-angle.
fn sin_cos_eighth(x: f32) -> vec2f {
    let y = x * x;
    let s = x * (1.0 + y * (-0.166666666666666667 + y * (0.00833333333333333333
        + y * (-0.000198412698412698413 + y * 0.00000275573192239858907))));
    let c = 1.0 - y * (0.5 + y * (-0.0416666666666666667 + y * (0.00138888888888888889
        + y * (-0.0000248015873015873016 + y * 2.75573192239858907e-7))));
    return vec2f(s, c);
}

/// [`sin_cos_quarter`] for |x| <= 0.1.
fn sin_cos_tiny(x: f32) -> vec2f {
    let y = x * x;
    let s = x * (1.0 + y * (-0.166666666666666667 + y * 0.00833333333333333333));
    let c = 1.0 - y * (0.5 + y * (-0.0416666666666666667 + y * 0.00138888888888888889));
    return vec2f(s, c);
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

/// Change of u over one pixel, in radians: |grad u|, at most 0.5. With half-angles the gradient
/// needs no inverse trigonometry: |du| = 2 |d(sin u/2, cos u/2)|. Call it in uniform control flow.
fn angle_footprint_2(u: Angle) -> f32 {
    let half = vec2f(u.half_sin, u.half_cos);
    let dx = dpdx(half);
    let dy = dpdy(half);
    let w = 2.0 * sqrt(dot(dx, dx) + dot(dy, dy));
    return min(w, 0.5);
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
fn angle_turned(u: Angle, t: vec2f) -> Angle {
    let s = u.half_sin * t.y - u.half_cos * t.x;
    let c = u.half_cos * t.y + u.half_sin * t.x;
    let upper = select(vec2f(s, c), vec2f(1.0, 0.0), c <= 0.0);
    // Beyond either end the smaller of s and c tells which: a turn by pi may leave the other just
    // below 0.
    let turned = select(upper, vec2f(0.0, 1.0), (s <= 0.0) & (s < c));
    return Angle(turned.x, turned.y);
}

/// Convex/concave color
///
/// One color for what bulges, another for what is hollow. Flat surfaces have the mean of both.
fn curvature_color(convexity: f32, convex: Color, concave: Color) -> Color {
    return concave + convexity * (convex - concave);
}

/// 2 lambda - 1 = tanh(kappa slope), in [-1, 1].
fn curvature_signed(kappa: f32, slope: f32) -> f32 {
    let a = select(clamp(kappa, -10000.0, 1e4), 0.0, (bitcast<u32>(kappa) & 0x7fffffffu)
        > 0x7f800000u) * 0.25;
    let magnitude = min(abs(a), 50.0);
    if magnitude < 0.0625 {
        let a2 = a * a;
        return a * (1.0 - a2 * (0.333333333333333333 - a2 * (0.133333333333333333 - a2
            * 0.0539682539682539683)));
    }
    let z = exp2_stable(-2.8853900817779268 * magnitude);
    let t = (1.0 - z) / (1.0 + z);
    return select(-t, t, a >= 0.0);
}

/// 2 lambda - 1 = tanh(kappa slope), in [-1, 1].
fn curvature_signed_2(kappa: f32, slope: f32) -> f32 {
    let a = select(clamp(kappa, -10000.0, 1e4), 0.0, (bitcast<u32>(kappa) & 0x7fffffffu)
        > 0x7f800000u) * slope;
    let magnitude = min(abs(a), 50.0);
    if magnitude < 0.0625 {
        let a2 = a * a;
        return a * (1.0 - a2 * (0.333333333333333333 - a2 * (0.133333333333333333 - a2
            * 0.0539682539682539683)));
    }
    let z = exp2_stable(-2.8853900817779268 * magnitude);
    let t = (1.0 - z) / (1.0 + z);
    return select(-t, t, a >= 0.0);
}

/// Mix from `below` to `blended` by `opacity`, with `alpha` as its alpha; clamped to [0, 1] if
/// `clamped`. At opacity 0 the result is exactly `below`, whatever that is.
fn blend_finish(below: Composite, blended: vec3f, alpha: f32, opacity: f32, clamped: bool)
    -> Composite {
    if opacity <= 0.0 {
        return below;
    }
    let mixed = vec4f(below.xyz + opacity * (blended - below.xyz), alpha);
    return clamp(mixed, vec4f(0.0), vec4f(1.0));
}

/// A light's intensity as two factors: x dims the layer (at most 1), y brightens the color (at
/// least 1).
fn light_split(intensity: f32) -> vec2f {
    return vec2f(min(intensity, 1.0), max(intensity, 1.0));
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
fn light_apply(light: Light, color: Color, tone: f32) -> LitLayer {
    let split = light_split(light.intensity);
    return LitLayer(vec4f(color.xyz * light.color * split.y, color.w), tone * split.x);
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
fn light_apply_2(light: Light, color: Color, tone: f32) -> LitLayer {
    let split = vec2f(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4f(color.xyz * light.color * split.y, 1.0), split.x);
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
fn light_apply_3(light: Light, color: Color, tone: f32) -> LitLayer {
    let split = vec2f(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4f(color.xyz * light.color * split.y, 1.0), tone * split.x);
}

struct LitLayer {
    /// The color under this light.
    color: Color,
    /// The tone under this light.
    tone: f32,
}

fn parametrization_specular(light: Light, normal: vec3f, view: vec3f) -> Angle {
    let mirrored = 2.0 * dot(normal, view) * normal - view;
    let d = normalize_moderate(mirrored, normal);
    return Angle(0.5 * length(d - light.direction), 0.5 * length(d + light.direction));
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
    if (s <= 0.0) | (shape.kind == PROFILE_AMBIENT) {
        return 1.0;
    }
    if shape.kind == PROFILE_STEP {
        // Inclusive (D4), also where rounding puts u = tau on the far side.
        return select(0.0, 1.0, s <= 4e-7);
    }
    let q = s * shape.scale;
    return profile_power(q, shape.exponent);
}

/// alpha at one angle, without antialiasing; `u` is warped already.
fn profile_point_2(u: Angle, shape: ProfileShape) -> f32 {
    let s = u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset;
    if (s <= 0.0) | false {
        return 1.0;
    }
    if shape.kind == PROFILE_STEP {
        return select(0.0, 1.0, s <= 4e-7);
    }
    let q = s * shape.scale;
    return profile_power(q, shape.exponent);
}

/// alpha at one angle, without antialiasing; `u` is warped already.
fn profile_point_3(u: Angle, shape: ProfileShape) -> f32 {
    let s = u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset;
    if (s <= 0.0) | false {
        return 1.0;
    }
    let q = s * shape.scale;
    return profile_power_2(q, shape.exponent);
}

/// (1 - q^2)^exponent for q >= 0; 0 from q = 1 on.
fn profile_power(q: f32, exponent: f32) -> f32 {
    if q >= 1.0 {
        return 0.0;
    }
    var log_base = 0.0;
    if q < 0.5 {
        log_base = LOG2_E * log1p_negative_small(q * q);
    } else {
        log_base = log2_stable((1.0 - q) * (1.0 + q));
    }
    return clamp(exp2_stable(exponent * log_base), 0.0, 1.0);
}

/// (1 - q^2)^exponent for q >= 0; 0 from q = 1 on.
fn profile_power_2(q: f32, exponent: f32) -> f32 {
    if q >= 1.0 {
        return 0.0;
    }
    var log_base = 0.0;
    if q < 0.5 {
        log_base = LOG2_E * log1p_negative_small(q * q);
    } else {
        log_base = log2_stable((1.0 - q) * (1.0 + q));
    }
    return min(exp2_stable_2(exponent * log_base), 1.0);
}

/// alpha averaged over a footprint of `w` radians (docs/math.md 2.4): the hard step where w is 0, a
/// ramp of the gradient's width where the edge is narrower than a pixel, three-point Gauss
/// quadrature where it is narrow, the point value where it is wide.
fn profile_filtered(u: Angle, w: f32, shape: ProfileShape) -> f32 {
    let point = profile_point(u, shape);
    let is_wide = w < 0.1 * shape.edge_deviation;
    if is_wide | (w <= 0.0) | (shape.kind == PROFILE_AMBIENT) {
        return point;
    }
    if (shape.edge_deviation < 0.145) & (w >= 3.46410161513775459 * shape.edge_deviation) {
        let width = sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
        return clamp(0.5 + (shape.offset + shape.edge_mean - 2.0 * atan2_positive(u.half_sin,
            u.half_cos)) / width, 0.0, 1.0);
    }
    let reach = sin_cos_tiny(0.193649167310370844 * w);
    let before = profile_point(angle_turned(u, reach), shape);
    let after = profile_point(angle_turned(u, vec2f(-reach.x, reach.y)), shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

/// alpha averaged over a footprint of `w` radians (docs/math.md 2.4): the hard step where w is 0, a
/// ramp of the gradient's width where the edge is narrower than a pixel, three-point Gauss
/// quadrature where it is narrow, the point value where it is wide.
fn profile_filtered_2(u: Angle, w: f32, shape: ProfileShape) -> f32 {
    let point = profile_point_2(u, shape);
    let is_wide = w < 0.1 * shape.edge_deviation;
    if is_wide | (w <= 0.0) | false {
        return point;
    }
    if (shape.edge_deviation < 0.145) & (w >= 3.46410161513775459 * shape.edge_deviation) {
        let width = sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
        return clamp(0.5 + (shape.offset + shape.edge_mean - 2.0 * atan2_positive(u.half_sin,
            u.half_cos)) / width, 0.0, 1.0);
    }
    let reach = sin_cos_tiny(0.193649167310370844 * w);
    let before = profile_point_2(angle_turned(u, reach), shape);
    let after = profile_point_2(angle_turned(u, vec2f(-reach.x, reach.y)), shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

/// alpha averaged over a footprint of `w` radians (docs/math.md 2.4): the hard step where w is 0, a
/// ramp of the gradient's width where the edge is narrower than a pixel, three-point Gauss
/// quadrature where it is narrow, the point value where it is wide.
fn profile_filtered_3(u: Angle, w: f32, shape: ProfileShape) -> f32 {
    let point = profile_point_3(u, shape);
    let is_wide = w < 0.1 * shape.edge_deviation;
    if is_wide | (w <= 0.0) | false {
        return point;
    }
    if true & (w >= 3.46410161513775459 * shape.edge_deviation) {
        let width = sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
        return clamp(0.5 + (shape.offset + shape.edge_mean - 2.0 * atan2_positive(u.half_sin,
            u.half_cos)) / width, 0.0, 1.0);
    }
    let reach = sin_cos_tiny(0.193649167310370844 * w);
    let before = profile_point_3(angle_turned(u, reach), shape);
    let after = profile_point_3(angle_turned(u, vec2f(-reach.x, reach.y)), shape);
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
    let warped = angle_turned(angle, sin_cos_eighth(0.5 * shift));
    return profile_filtered(warped, angle_footprint_2(warped), shape);
}

/// Profile
///
/// Turns an angle into a tone: 1 up to the offset, then falling to 0 at the cut-off, steepest at
/// the fall-off. Edges are as sharp as asked and antialiased by their width on the screen.
///
/// Up to an offset of 90 degrees below the fall-off the curve has one inflection, at the fall-off;
/// beyond that the curve is still falling, but it is steepest elsewhere too.
fn profile_2(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_turned(angle, sin_cos_quarter(0.5 * clamp(shift, -3.141592653589793, PI)));
    return profile_filtered_2(warped, angle_footprint(warped), shape);
}

/// Profile
///
/// Turns an angle into a tone: 1 up to the offset, then falling to 0 at the cut-off, steepest at
/// the fall-off. Edges are as sharp as asked and antialiased by their width on the screen.
///
/// Up to an offset of 90 degrees below the fall-off the curve has one inflection, at the fall-off;
/// beyond that the curve is still falling, but it is steepest elsewhere too.
fn profile_3(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_turned(angle, sin_cos_tiny(0.5 * shift));
    return profile_filtered_3(warped, angle_footprint_2(warped), shape);
}

const highlight_tone_shape = ProfileShape(0.9959527, 0.08987855, 11.126125, 3.022525, 0.18, 0.08196669, 0.036355104, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let back_light_convexity = 0.5 + 0.5 * curvature_signed(surface.kappa, 0.25);
    let fill_color = curvature_color(back_light_convexity, vec4f(0.1647, 0.1843, 0.2392, 1.0), vec4f(0.0706, 0.0784, 0.1098, 1.0));
    let fill_lit = light_apply_2(look.key, fill_color, 1.0);
    let fill_blend = clamp(vec4f(vec4f(0.0784, 0.0863, 0.1137, 1.0).xyz + fill_lit.tone * fill_lit.color.xyz, 1.0), vec4f(0.0), vec4f(1.0));
    let diffuse_color = curvature_color(back_light_convexity, vec4f(0.498, 0.6039, 0.3216, 1.0), vec4f(0.2471, 0.4, 0.251, 1.0));
    let diffuse_angle = Angle(0.5 * length(surface.normal - look.key.direction), 0.5 * length(surface.normal + look.key.direction));
    let diffuse_warp = (2.0 * back_light_convexity - 1.0) * 0.3;
    let diffuse_tone = profile(diffuse_angle, diffuse_warp, look.diffuse_tone_shape);
    let diffuse_lit = light_apply_3(look.key, diffuse_color, diffuse_tone);
    let diffuse_blend = clamp(vec4f(fill_blend.xyz + diffuse_lit.tone * diffuse_lit.color.xyz, 1.0), vec4f(0.0), vec4f(1.0));
    let back_light_color = look.back_light_color_concave + back_light_convexity * (look.back_light_color_convex - look.back_light_color_concave);
    let back_light_angle = Angle(0.5 * length(surface.normal - look.back.direction), 0.5 * length(surface.normal + look.back.direction));
    let back_light_warp = (2.0 * back_light_convexity - 1.0) * clamp(look.back_light_warp_amount, -3.141592653589793, 3.14159265358979324);
    let back_light_tone = profile_2(back_light_angle, back_light_warp, look.back_light_tone_shape);
    let back_light_lit = light_apply(look.back, back_light_color, back_light_tone);
    let back_light_blend = blend_finish(diffuse_blend, diffuse_blend.xyz + back_light_lit.tone * back_light_lit.color.xyz, 1.0, back_light_lit.color.w, true);
    let highlight_convexity = 0.5 + 0.5 * curvature_signed_2(surface.kappa, 0.2);
    let highlight_color = look.highlight_color_concave + highlight_convexity * (look.highlight_color_convex - look.highlight_color_concave);
    let highlight_angle = parametrization_specular(look.key, surface.normal, surface.view);
    let highlight_warp = (2.0 * highlight_convexity - 1.0) * 0.05;
    let highlight_tone = profile_3(highlight_angle, highlight_warp, highlight_tone_shape);
    let highlight_lit = light_apply(look.key, highlight_color, highlight_tone);
    let highlight_blend = blend_finish(back_light_blend, back_light_blend.xyz + highlight_lit.tone * highlight_lit.color.xyz, 1.0, highlight_lit.color.w, true);
    let output = highlight_blend;
    return output;
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
    let facing = normalize_seen(in.normal);
    let normal = select(-facing, facing, is_front);
    var surface: Surface;
    surface.normal = normal;
    surface.view = normalize(view.eye.xyz - view.eye.w * in.position);
    surface.kappa = textureLoad(curvature_map, vec2i(in.clip.xy), 0).x;
    let shaded = shade(surface);
    return shaded;
}
