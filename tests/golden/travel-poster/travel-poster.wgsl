// Travel poster: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_map 3.
// travel-poster.json says what to put there and how to draw.

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
    @align(16) sky: Light,
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

/// A color along one number, the same outside of its stops as at the nearest one. The layout is one
/// for uniform buffers.
struct Ramp {
    /// Straight RGBA of each stop.
    colors: array<vec4f, 16>,
    /// Places of the stops, in increasing order, four to a vector.
    places: array<vec4f, 4>,
    /// Number of stops that count.
    count: u32,
    /// 0 straight, 1 smooth (monotone cubic, level at both ends), 2 stepped: each color holds
    /// until the next stop.
    interpolation: u32,
}

const LOG2_E: f32 = 1.44269504088896340736;
/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
fn exp2_stable(x: f32) -> f32 {
    let whole = round(x);
    let f = x - whole;
    let twice = 2.0 + f * (1.386294405710424 + f
        * (0.4804529582723118 + f * (0.11100664941567156 + f
        * (0.019236874716471952 + f * (0.0026797749114217808 + f * 0.00030706724124369897)))));
    return twice * bitcast<f32>(u32(i32(whole) + 126) << 23u);
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
fn exp2_stable_2(x: f32) -> f32 {
    let clamped = max(x, -126.0);
    let whole = round(clamped);
    let f = clamped - whole;
    let twice = 2.0 + f * (1.386294405710424 + f
        * (0.4804529582723118 + f * (0.11100664941567156 + f
        * (0.019236874716471952 + f * (0.0026797749114217808 + f * 0.00030706724124369897)))));
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

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
fn angle_turned_2(u: Angle, t: vec2f) -> Angle {
    let s = u.half_sin - 0.0;
    let upper = select(vec2f(s, u.half_cos), vec2f(1.0, 0.0), u.half_cos <= 0.0);
    let turned = select(upper, vec2f(0.0, 1.0), (s <= 0.0) & (s < u.half_cos));
    return Angle(turned.x, turned.y);
}

const SMALLEST_NORMAL: f32 = 1.17549435e-38;
/// base^exponent for every pair. A negative base is raised as in algebra by a whole exponent and
/// keeps its sign with any other, so that (-4)^0.5 is -2. 0 to a negative power is 0, as division
/// by 0 is; 0^0 is 1.
fn powered(base: f32, exponent: f32) -> f32 {
    let magnitude = abs(base);
    let raised = exp2_stable(exponent * log2_stable(max(magnitude, SMALLEST_NORMAL)));
    return select(raised, 0.0, magnitude < SMALLEST_NORMAL);
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return sqrt(dot(d, d));
}

/// The stairs floor(x) from 0 to `count` - 1, averaged over a footprint of `w`; x in [0, count],
/// count at least 2.
fn stairs_filtered(x: f32, count: f32, w: f32) -> f32 {
    if w <= 1.0 {
        let edge = clamp(round(x), 1.0, 6.0);
        return edge - 1.0 + clamp(0.5 + (x - edge) / w, 0.0, 1.0);
    }
    let half = 0.5 * w;
    return (stairs_integral(x + half, count) - stairs_integral_2(x - half, count)) / (2.0 * half);
}

/// The integral of the stairs from 0 to x; they are 0 below 0 and `count` - 1 above `count`.
fn stairs_integral(x: f32, count: f32) -> f32 {
    let inside = min(x, count);
    let stair = min(floor(inside), 6.0);
    let beyond = max(x - count, 0.0);
    return stair * (0.5 * (stair - 1.0) + inside - stair) + beyond * 6.0;
}

/// The integral of the stairs from 0 to x; they are 0 below 0 and `count` - 1 above `count`.
fn stairs_integral_2(x: f32, count: f32) -> f32 {
    let inside = max(x, 0.0);
    let stair = floor(inside);
    return stair * (0.5 * (stair - 1.0) + inside - stair) + 0.0;
}

/// sRGB-coded to linear light (IEC 61966-2-1, the exact curve); a negative number is decoded by its
/// size.
fn linear_of_srgb(coded: f32) -> f32 {
    let size = abs(coded);
    let value = select(exp2_stable(2.4 * log2_stable((size + 0.055) / 1.055)), size / 12.92, size
        <= 0.04045);
    return value;
}

/// sRGB-coded to linear light (IEC 61966-2-1, the exact curve); a negative number is decoded by its
/// size.
fn linear_of_srgb_2(coded: f32) -> f32 {
    let size = abs(coded);
    let value = select(pow((size + 0.055) / 1.055, 2.4), size / 12.92, size <= 0.04045);
    return value;
}

/// Linear light to sRGB-coded (IEC 61966-2-1, the exact curve); a negative number is coded by its
/// size.
fn srgb_of_linear(light: f32) -> f32 {
    let size = abs(light);
    let value = select(1.055 * powered(size, 0.4166666666666667) - 0.055, size * 12.92, size
        <= 0.0031308);
    return select(value, -value, light < 0.0);
}

/// Oklab of a linear sRGB color (Ottosson 2020): lightness, green to red and blue to yellow, in
/// steps that eyes judge as even.
fn oklab_of_linear(rgb: vec3f) -> vec3f {
    let l = powered(abs(dot(rgb, vec3f(0.4122214708, 0.5363325363, 0.0514459929))),
        0.3333333333333333);
    let m = powered(abs(dot(rgb, vec3f(0.2119034982, 0.6806995451, 0.1073969566))),
        0.3333333333333333);
    let s = powered(abs(dot(rgb, vec3f(0.0883024619, 0.2817188376, 0.6299787005))),
        0.3333333333333333);
    return vec3f(0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s, 1.9779984951 * l
        - 2.4285922050 * m + 0.4505937099 * s, 0.0259040371 * l + 0.7827717662 * m - 0.8086757660
        * s);
}

/// Oklab of a linear sRGB color (Ottosson 2020): lightness, green to red and blue to yellow, in
/// steps that eyes judge as even.
fn oklab_of_linear_2(rgb: vec3f) -> vec3f {
    let l = pow(abs(dot(rgb, vec3f(0.4122214708, 0.5363325363, 0.0514459929))), 0.3333333333333333);
    let m = pow(abs(dot(rgb, vec3f(0.2119034982, 0.6806995451, 0.1073969566))), 0.3333333333333333);
    let s = pow(abs(dot(rgb, vec3f(0.0883024619, 0.2817188376, 0.6299787005))), 0.3333333333333333);
    return vec3f(0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s, 1.9779984951 * l
        - 2.4285922050 * m + 0.4505937099 * s, 0.0259040371 * l + 0.7827717662 * m - 0.8086757660
        * s);
}

/// Oklab of a linear sRGB color (Ottosson 2020): lightness, green to red and blue to yellow, in
/// steps that eyes judge as even.
fn oklab_of_linear_3(rgb: vec3f) -> vec3f {
    let l = pow(dot(rgb, vec3f(0.4122214708, 0.5363325363, 0.0514459929)), 0.3333333333333333);
    let m = pow(dot(rgb, vec3f(0.2119034982, 0.6806995451, 0.1073969566)), 0.3333333333333333);
    let s = pow(dot(rgb, vec3f(0.0883024619, 0.2817188376, 0.6299787005)), 0.3333333333333333);
    return vec3f(0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s, 1.9779984951 * l
        - 2.4285922050 * m + 0.4505937099 * s, 0.0259040371 * l + 0.7827717662 * m - 0.8086757660
        * s);
}

/// Linear sRGB of an Oklab color, the inverse of [`oklab_of_linear`].
fn linear_of_oklab(lab: vec3f) -> vec3f {
    let l = lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z;
    let m = lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z;
    let s = lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z;
    let cubes = vec3f(l * l * l, m * m * m, s * s * s);
    return vec3f(dot(cubes, vec3f(4.0767416621, -3.3077115913, 0.2309699292)),
        dot(cubes, vec3f(-1.2684380046, 2.6097574011, -0.3413193965)),
        dot(cubes, vec3f(-0.0041960863, -0.7034186147, 1.7076147010)));
}

/// [`oklab_of_linear`] of an sRGB-coded color.
fn oklab_of_srgb(coded: vec3f) -> vec3f {
    return oklab_of_linear_3(vec3f(pow((coded.x + 0.055) / 1.055, 2.4),
        pow((coded.y + 0.055) / 1.055, 2.4), pow((coded.z + 0.055) / 1.055, 2.4)));
}

/// sRGB-coded color of an Oklab color, the inverse of [`oklab_of_srgb`].
fn srgb_of_oklab(lab: vec3f) -> vec3f {
    let light = linear_of_oklab(lab);
    return vec3f(srgb_of_linear(light.x), srgb_of_linear(light.y), srgb_of_linear(light.z));
}

/// The color of a palette (the stops of a ramp) that is nearest to `rgb` in Oklab, alone or blended
/// there with the colors that are up to `softness` farther. Black for a palette without colors.
fn palette_blend(palette: Ramp, rgb: vec3f, softness: f32) -> vec3f {
    var colors = palette.colors;
    let wanted = oklab_of_linear_2(vec3f(linear_of_srgb_2(rgb.x), linear_of_srgb_2(rgb.y),
        linear_of_srgb_2(rgb.z)));
    var i = 0u;
    var found = vec3f(0.0);
    var nearest = 1e30;
    loop {
        if !(i < 7u) {
            break;
        }
        let lab = oklab_of_srgb(colors[i].xyz);
        let far = min(length(lab - wanted), 1e29);
        found = select(found, colors[i].xyz, far < nearest);
        nearest = min(nearest, far);
        continuing {
            i = i + 1u;
        }
    }
    return found;
}

/// Posterize
///
/// Reduces a color to a few steps, as screen prints and old posters do. By lightness the hue stays
/// and only light and dark are cut, in steps that look even; by channel the hue shifts too, which
/// is the look of early computers.
fn posterize_lightness(color: Color, steps: i32, softness: f32) -> Color {
    let lab = oklab_of_linear(vec3f(linear_of_srgb(color.x), linear_of_srgb(color.y),
        linear_of_srgb(color.z)));
    let stepped = clamp(stairs_filtered(7.0 * clamp(lab.x, 0.0, 1.0), 7.0,
        length(vec2f(7.0 * footprint_of(lab.x), softness))) / 6.0, 0.0, 1.0);
    let kept = select(0.0, stepped / max(lab.x, 1e-4), lab.x > 1e-4);
    return vec4f(clamp(srgb_of_oklab(vec3f(stepped, lab.yz * min(kept, 1.0))), vec3f(0.0),
        vec3f(1.0)), 1.0);
}

/// Convex/concave color
///
/// One color for what bulges, another for what is hollow. Flat surfaces have the mean of both.
fn curvature_color(convexity: f32, convex: Color, concave: Color) -> Color {
    return concave + convexity * (convex - concave);
}

/// Blend
///
/// Lays a color, where the tone is, over what is below: one step of a layered look.
fn blend_add(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool) -> Composite {
    return clamp(vec4f(below.xyz + tone * color.xyz, 1.0), vec4f(0.0), vec4f(1.0));
}

/// Light on a layer
///
/// Gives a layer its light's color and intensity: below 1 the intensity fades the tone, above 1 it
/// brightens the color, so that a light that goes out leaves the layers below as they are.
fn light_apply(light: Light, color: Color, tone: f32) -> LitLayer {
    let split = vec2f(min(light.intensity, 1.0), max(light.intensity, 1.0));
    return LitLayer(vec4f(color.xyz * light.color * split.y, 1.0), tone * split.x);
}

struct LitLayer {
    /// The color under this light.
    color: Color,
    /// The tone under this light.
    tone: f32,
}

fn parametrization_specular_balanced(light: Light, normal: vec3f, view: vec3f) -> Angle {
    let d = 2.0 * dot(normal, view) * normal - view;
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

/// alpha at one angle, without antialiasing; `u` is warped already.
fn profile_point(u: Angle, shape: ProfileShape) -> f32 {
    let s = u.half_sin - u.half_cos * 0.0;
    if s <= 0.0 {
        return 1.0;
    }
    let q = s * shape.scale;
    return profile_power(q, shape.exponent);
}

/// alpha at one angle, without antialiasing; `u` is warped already.
fn profile_point_2(u: Angle, shape: ProfileShape) -> f32 {
    let s = u.half_sin - 0.0;
    if s <= 0.0 {
        return 1.0;
    }
    let q = s * shape.scale;
    return profile_power(q, shape.exponent);
}

/// alpha at one angle, without antialiasing; `u` is warped already.
fn profile_point_3(u: Angle, shape: ProfileShape) -> f32 {
    let s = u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset;
    if s <= 0.0 {
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
    return min(exp2_stable(exponent * log_base), 1.0);
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
    if is_wide | (w <= 0.0) {
        return point;
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
    if is_wide | (w <= 0.0) {
        return point;
    }
    let reach = sin_cos_tiny(0.193649167310370844 * w);
    let before = profile_point_2(angle_turned(u, reach), shape);
    let after = profile_point(angle_turned(u, vec2f(-reach.x, reach.y)), shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

/// alpha averaged over a footprint of `w` radians (docs/math.md 2.4): the hard step where w is 0, a
/// ramp of the gradient's width where the edge is narrower than a pixel, three-point Gauss
/// quadrature where it is narrow, the point value where it is wide.
fn profile_filtered_3(u: Angle, w: f32, shape: ProfileShape) -> f32 {
    let point = profile_point_3(u, shape);
    let is_wide = w < 0.1 * shape.edge_deviation;
    if is_wide | (w <= 0.0) {
        return point;
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
    let warped = angle_turned(angle, sin_cos_tiny(0.5 * shift));
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
    let warped = angle_turned_2(angle, vec2f(0.0, 1.0));
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
    let warped = angle_turned_2(angle, vec2f(0.0, 1.0));
    return profile_filtered_3(warped, angle_footprint(warped), shape);
}

const evening_sun_tone_shape = ProfileShape(1.0, 0.0, 1.0955735, 1.6395584, 0.0, 1.1385497,
    0.5052584, 0u);
const sky_tone_shape = ProfileShape(1.0, 0.0, 1.229384, 1.2860026, 0.0, 1.0836705, 0.44442755, 0u);
const glow_tone_shape = ProfileShape(0.99875027, 0.04997917, 2.425296, 2.5857167, 0.1, 0.4039123,
    0.17722374, 0u);
const seven_inks = Ramp(array(vec4f(0.0863, 0.1333, 0.2471, 1.0),
    vec4f(0.1725, 0.3176, 0.3882, 1.0), vec4f(0.4863, 0.2275, 0.2706, 1.0),
    vec4f(0.7686, 0.3294, 0.2471, 1.0), vec4f(0.8784, 0.5412, 0.298, 1.0),
    vec4f(0.9412, 0.7608, 0.4824, 1.0), vec4f(0.9843, 0.9333, 0.7961, 1.0), vec4f(0.0), vec4f(0.0),
    vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0)),
    array(vec4f(0.0, 0.15, 0.3, 0.45), vec4f(0.6, 0.8, 1.0, 0.0), vec4f(0.0), vec4f(0.0)), 7u, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    // Evening sun (Light layer)
    let evening_sun_convexity = 0.5 + 0.5
        * (1.0 - 2.0 / (1.0 + exp2(2.8853900817779268 * clamp(surface.kappa * 0.12, -20.0, 20.0))));
    let evening_sun_color = curvature_color(evening_sun_convexity, vec4f(0.93, 0.62, 0.36, 1.0),
        vec4f(0.66, 0.24, 0.24, 1.0));
    let evening_sun_angle = Angle(0.5 * length(surface.normal - look.key.direction), 0.5
        * length(surface.normal + look.key.direction));
    let evening_sun_warp = (2.0 * evening_sun_convexity - 1.0) * 0.1;
    let evening_sun_tone = profile(evening_sun_angle, evening_sun_warp, evening_sun_tone_shape);
    let evening_sun_lit = light_apply(look.key, evening_sun_color, evening_sun_tone);
    let evening_sun_blend = blend_add(vec4f(0.07, 0.1, 0.22, 1.0), evening_sun_lit.color,
        evening_sun_lit.tone, 1.0, true);

    // Sky (Light layer)
    let sky_angle = Angle(0.5 * length(surface.normal - look.sky.direction), 0.5
        * length(surface.normal + look.sky.direction));
    let sky_tone = profile_2(sky_angle, 0.0, sky_tone_shape);
    let sky_lit = light_apply(look.sky, vec4f(0.02, 0.24, 0.3, 1.0), sky_tone);
    let sky_blend = blend_add(evening_sun_blend, sky_lit.color, sky_lit.tone, 1.0, true);

    // Glow (Light layer)
    let glow_angle = parametrization_specular_balanced(look.key, surface.normal, surface.view);
    let glow_tone = profile_3(glow_angle, 0.0, glow_tone_shape);
    let glow_lit = light_apply(look.key, vec4f(0.42, 0.38, 0.24, 1.0), glow_tone);
    let glow_blend = blend_add(sky_blend, glow_lit.color, glow_lit.tone, 1.0, true);

    let seven_lightnesses = posterize_lightness(glow_blend, 7i, 0.02);
    let seven_inks_2 = vec4f(palette_blend(seven_inks, seven_lightnesses.xyz, 0.0), 1.0);
    return seven_inks_2;
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

@fragment
fn fs_main(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let facing = normalize_seen(in.normal);
    let normal = select(-facing, facing, is_front);
    let surface = Surface(normal, normalize(view.eye.xyz - view.eye.w * in.position),
        textureLoad(curvature_map, vec2i(in.clip.xy), 0).x);
    return shade(surface);
}
