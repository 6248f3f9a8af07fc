// Manga, embossed: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_map 3.
// figure6-manga-embossed.json says what to put there and how to draw.

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
    @align(16) above: Light,
    @align(16) camera_from_world: mat3x3f,
    @align(16) below: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    kappa: f32,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var curvature_map: texture_2d<f32>;

/// Straight RGBA.
alias Color = vec4f;

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

const HALF_PI: f32 = 1.57079632679489661923;
const LOG2_E: f32 = 1.44269504088896340736;
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

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
fn exp2_stable_3(x: f32) -> f32 {
    let whole = round(x);
    let f = x - whole;
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

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
fn light_apply(light: Light, color: Color, tone: f32) -> LitLayer {
    let split = vec2f(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4f(color.xyz * light.color * split.y, 1.0), tone * split.x);
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
fn light_apply_2(light: Light, color: Color, tone: f32) -> LitLayer {
    let split = vec2f(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4f(color.xyz * light.color * split.y, 1.0), split.x);
}

struct LitLayer {
    /// The color under this light.
    color: Color,
    /// The tone under this light.
    tone: f32,
}

fn parametrization_screen_aligned(light: Light, normal: vec3f, camera_from_world: mat3x3f)
    -> Angle {
    let n = camera_from_world * normal;
    let d = normalize_moderate(n, vec3f(0.0, 0.0, 1.0));
    return Angle(0.5 * length(d - light.own_direction), 0.5 * length(d + light.own_direction));
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

/// alpha at one angle, without antialiasing; `u` is warped already.
fn profile_point(u: Angle, shape: ProfileShape) -> f32 {
    let s = u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset;
    if (s <= 0.0) | false {
        return 1.0;
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
    return min(exp2_stable_2(exponent * log_base), 1.0);
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
    return min(exp2_stable_3(exponent * log_base), 1.0);
}

/// alpha averaged over a footprint of `w` radians (docs/math.md 2.4): the hard step where w is 0, a
/// ramp of the gradient's width where the edge is narrower than a pixel, three-point Gauss
/// quadrature where it is narrow, the point value where it is wide.
fn profile_filtered(u: Angle, w: f32, shape: ProfileShape) -> f32 {
    let point = profile_point(u, shape);
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
    if true & (w >= 3.46410161513775459 * shape.edge_deviation) {
        let width = sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
        return clamp(0.5 + (0.5 + shape.edge_mean - 2.0 * atan2_positive(u.half_sin, u.half_cos))
            / width, 0.0, 1.0);
    }
    let reach = sin_cos_tiny(0.193649167310370844 * w);
    let before = profile_point_2(angle_turned(u, reach), shape);
    let after = profile_point_2(angle_turned(u, vec2f(-reach.x, reach.y)), shape);
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
    return profile_filtered(warped, angle_footprint(warped), shape);
}

/// Profile
///
/// Turns an angle into a tone: 1 up to the offset, then falling to 0 at the cut-off, steepest at
/// the fall-off. Edges are as sharp as asked and antialiased by their width on the screen.
///
/// Up to an offset of 90 degrees below the fall-off the curve has one inflection, at the fall-off;
/// beyond that the curve is still falling, but it is steepest elsewhere too.
fn profile_2(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_turned(angle, sin_cos_eighth(0.5 * shift));
    return profile_filtered_2(warped, angle_footprint(warped), shape);
}

const dark_side_tone_shape = ProfileShape(0.9624252, 0.27154693, 5.0334897, 2.4651666, 0.55, 0.19658314, 0.08474467, 0u);
const light_side_tone_shape = ProfileShape(0.9689124, 0.24740396, 5.743557, 2.3650649, 0.5, 0.17491564, 0.07484149, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let light_side_convexity = 0.5 + 0.5 * curvature_signed(surface.kappa, 0.3);
    let dark_side_color = curvature_color(light_side_convexity, vec4f(0.4275, 0.4078, 0.4745, 1.0), vec4f(0.2275, 0.2078, 0.2784, 1.0));
    let dark_side_angle = parametrization_screen_aligned(look.below, surface.normal, look.camera_from_world);
    let light_side_warp = (2.0 * light_side_convexity - 1.0) * 0.35;
    let dark_side_tone = profile(dark_side_angle, light_side_warp, dark_side_tone_shape);
    let dark_side_lit = light_apply(look.below, dark_side_color, dark_side_tone);
    let dark_side_blend = clamp(vec4f(vec4f(0.851, 0.8314, 0.7804, 1.0).xyz * mix(vec3f(1.0), dark_side_lit.color.xyz, dark_side_lit.tone), 1.0), vec4f(0.0), vec4f(1.0));
    let light_side_color = curvature_color(light_side_convexity, vec4f(1.0), vec4f(0.9529, 0.9176, 0.8471, 1.0));
    let light_side_angle = parametrization_screen_aligned(look.above, surface.normal, look.camera_from_world);
    let light_side_tone = profile_2(light_side_angle, light_side_warp, light_side_tone_shape);
    let light_side_lit = light_apply(look.above, light_side_color, light_side_tone);
    let light_side_blend = clamp(vec4f(dark_side_blend.xyz + light_side_lit.tone * (light_side_lit.color.xyz - dark_side_blend.xyz), 1.0), vec4f(0.0), vec4f(1.0));
    let hollows_convexity = 0.5 + 0.5 * curvature_signed(surface.kappa, 0.4);
    let hollows_color = curvature_color(hollows_convexity, vec4f(1.0), vec4f(0.4667, 0.4392, 0.5412, 1.0));
    let hollows_lit = light_apply_2(look.above, hollows_color, 1.0);
    let hollows_blend = clamp(vec4f(light_side_blend.xyz + 0.8 * (light_side_blend.xyz * (hollows_lit.tone * hollows_lit.color.xyz) - light_side_blend.xyz), 1.0), vec4f(0.0), vec4f(1.0));
    let output = hollows_blend;
    return output;
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
    let facing = normalize_seen(in.normal);
    let normal = select(-facing, facing, is_front);
    var surface: Surface;
    surface.normal = normal;
    surface.kappa = textureLoad(curvature_map, vec2i(in.clip.xy), 0).x;
    let shaded = shade(surface);
    return shaded;
}
