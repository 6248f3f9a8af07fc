// Exaggerated shape: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, smooth_normal_1_map 3, smooth_normal_2_map 4, smooth_normal_3_map 5, smooth_normal_4_map 6.
// shape-exaggerated.json says what to put there and how to draw.

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
    viewport: vec2f,
    @align(16) key: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    smooth_normal_1: vec3f,
    smooth_normal_2: vec3f,
    smooth_normal_3: vec3f,
    smooth_normal_4: vec3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var smooth_normal_1_map: texture_2d<f32>;
@group(0) @binding(4) var smooth_normal_2_map: texture_2d<f32>;
@group(0) @binding(5) var smooth_normal_3_map: texture_2d<f32>;
@group(0) @binding(6) var smooth_normal_4_map: texture_2d<f32>;

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

/// [`bounded`], component by component.
fn bounded_vec4(v: vec4f) -> vec4f {
    return vec4f(bounded(v.x), bounded(v.y), bounded(v.z), bounded(v.w));
}

/// a / b; 0 where b is 0.
fn divided(a: f32, b: f32) -> f32 {
    if abs(b) < SMALLEST_NORMAL {
        return 0.0;
    }
    return bounded(a / b);
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

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return bounded(sqrt(dot(d, d)));
}

/// Step at an edge: 0 below it and 1 from it on, averaged over a footprint of `w`.
fn step_filtered(x: f32, edge: f32, w: f32) -> f32 {
    let d = bounded(x - edge);
    if w < 1e-30 {
        return select(0.0, 1.0, d >= 0.0);
    }
    return clamp(0.5 + bounded(d / w), 0.0, 1.0);
}

/// sRGB-coded to linear light (IEC 61966-2-1, the exact curve); a negative number is decoded by its
/// size.
fn linear_of_srgb(coded: f32) -> f32 {
    let size = abs(bounded(coded));
    let value = select(powered((size + 0.055) / 1.055, 2.4), size / 12.92, size <= 0.04045);
    return select(value, -value, coded < 0.0);
}

/// Linear light to sRGB-coded (IEC 61966-2-1, the exact curve); a negative number is coded by its
/// size.
fn srgb_of_linear(light: f32) -> f32 {
    let size = abs(bounded(light));
    let value = select(1.055 * powered(size, 1.0 / 2.4) - 0.055, size * 12.92, size <= 0.0031308);
    return bounded(select(value, -value, light < 0.0));
}

/// The cube root, with the sign of x.
fn cube_root(x: f32) -> f32 {
    let root = powered(abs(x), 1.0 / 3.0);
    return select(root, -root, x < 0.0);
}

/// Oklab of a linear sRGB color (Ottosson 2020): lightness, green to red and blue to yellow, in
/// steps that eyes judge as even.
fn oklab_of_linear(rgb: vec3f) -> vec3f {
    let c = clamp(bounded_vec3(rgb), vec3f(-1e9), vec3f(1e9));
    let l = cube_root(dot(c, vec3f(0.4122214708, 0.5363325363, 0.0514459929)));
    let m = cube_root(dot(c, vec3f(0.2119034982, 0.6806995451, 0.1073969566)));
    let s = cube_root(dot(c, vec3f(0.0883024619, 0.2817188376, 0.6299787005)));
    return vec3f(
        0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
        1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
        0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s,
    );
}

/// Linear sRGB of an Oklab color, the inverse of [`oklab_of_linear`].
fn linear_of_oklab(lab: vec3f) -> vec3f {
    let c = clamp(bounded_vec3(lab), vec3f(-1e6), vec3f(1e6));
    let l = c.x + 0.3963377774 * c.y + 0.2158037573 * c.z;
    let m = c.x - 0.1055613458 * c.y - 0.0638541728 * c.z;
    let s = c.x - 0.0894841775 * c.y - 1.2914855480 * c.z;
    let cubes = vec3f(l * l * l, m * m * m, s * s * s);
    return vec3f(
        dot(cubes, vec3f(4.0767416621, -3.3077115913, 0.2309699292)),
        dot(cubes, vec3f(-1.2684380046, 2.6097574011, -0.3413193965)),
        dot(cubes, vec3f(-0.0041960863, -0.7034186147, 1.7076147010)),
    );
}

/// [`oklab_of_linear`] of an sRGB-coded color.
fn oklab_of_srgb(coded: vec3f) -> vec3f {
    return oklab_of_linear(vec3f(linear_of_srgb(coded.x), linear_of_srgb(coded.y),
        linear_of_srgb(coded.z)));
}

/// sRGB-coded color of an Oklab color, the inverse of [`oklab_of_srgb`].
fn srgb_of_oklab(lab: vec3f) -> vec3f {
    let light = linear_of_oklab(lab);
    return vec3f(srgb_of_linear(light.x), srgb_of_linear(light.y), srgb_of_linear(light.z));
}

/// Mix of two sRGB-coded colors in Oklab, even to the eye; t from 0 to 1.
fn mixed_in_oklab(a: vec4f, b: vec4f, t: f32) -> vec4f {
    let lab = mixed_vec3(oklab_of_srgb(a.xyz), oklab_of_srgb(b.xyz), t);
    return ends_kept(a, b, t, srgb_of_oklab(lab));
}

/// The mixed color with its alpha; exactly a and b at the ends, which going to another space and
/// back would round.
fn ends_kept(a: vec4f, b: vec4f, t: f32, rgb: vec3f) -> vec4f {
    let mixed_color = vec4f(bounded_vec3(rgb), mixed(a.w, b.w, t));
    return select(select(mixed_color, bounded_vec4(b), t >= 1.0), bounded_vec4(a), t <= 0.0);
}

const INTERPOLATION_SMOOTH: u32 = 1u;
const INTERPOLATION_STEPPED: u32 = 2u;
/// The cubic from a to b that leaves with the slope `from_a` and arrives with `to_b`, per unit of
/// t.
fn hermite(a: vec4f, b: vec4f, from_a: vec4f, to_b: vec4f, t: f32) -> vec4f {
    let d = b - a;
    return a + t * (from_a + t * (3.0 * d - 2.0 * from_a - to_b + t * (from_a + to_b - 2.0 * d)));
}

/// The ramp's color at x; the steps of a stepped ramp are averaged over a footprint of `w`.
/// Transparent black for a ramp without stops.
fn ramp_at(ramp: Ramp, x: f32, w: f32) -> Color {
    let count = min(ramp.count, 16u);
    if count == 0u {
        return vec4f(0.0);
    }
    var colors = ramp.colors;
    var places = ramp.places;
    if ramp.interpolation == INTERPOLATION_STEPPED {
        var color = colors[0];
        for (var i = 1u; i < count; i++) {
            color += (colors[i] - colors[i - 1u]) * step_filtered(x, places[i / 4u][i % 4u], w);
        }
        return bounded_vec4(color);
    }
    var at = 0u;
    for (var i = 1u; i < count; i++) {
        at = select(at, i, places[i / 4u][i % 4u] <= x);
    }
    let place = places[at / 4u][at % 4u];
    if at + 1u >= count || x <= place {
        return bounded_vec4(colors[at]);
    }
    let after = at + 1u;
    let span = places[after / 4u][after % 4u] - place;
    let t = clamp(divided(x - place, span), 0.0, 1.0);
    if ramp.interpolation != INTERPOLATION_SMOOTH {
        return mixed_vec4(colors[at], colors[after], t);
    }
    // Slopes are 0 at the first and the last stop, because the ramp is flat outside of them.
    var from_a = vec4f(0.0);
    var to_b = vec4f(0.0);
    if at > 0u {
        let before = places[(at - 1u) / 4u][(at - 1u) % 4u];
        from_a = ramp_slope(colors[at] - colors[at - 1u], place - before, colors[after]
            - colors[at], span);
    }
    if after + 1u < count {
        let next = places[(after + 1u) / 4u][(after + 1u) % 4u] - (place + span);
        to_b = ramp_slope(colors[after] - colors[at], span, colors[after + 1u] - colors[after],
            next);
    }
    return bounded_vec4(hermite(colors[at], colors[after], span * from_a, span * to_b, t));
}

/// The slope at a stop that keeps a cubic between its neighbors' values (Fritsch and Butland
/// 1984): the weighted harmonic mean of the slopes before and after, 0 where these differ in sign.
fn ramp_slope(rise_before: vec4f, span_before: f32, rise_after: vec4f, span_after: f32) -> vec4f {
    return vec4f(
        harmonic_slope(divided(rise_before.x, span_before), span_before,
            divided(rise_after.x, span_after), span_after),
        harmonic_slope(divided(rise_before.y, span_before), span_before,
            divided(rise_after.y, span_after), span_after),
        harmonic_slope(divided(rise_before.z, span_before), span_before,
            divided(rise_after.z, span_after), span_after),
        harmonic_slope(divided(rise_before.w, span_before), span_before,
            divided(rise_after.w, span_after), span_after),
    );
}

/// [`ramp_slope`] of one component.
fn harmonic_slope(before: f32, span_before: f32, after: f32, span_after: f32) -> f32 {
    if before * after <= 0.0 {
        return 0.0;
    }
    let weight_before = 2.0 * span_after + span_before;
    let weight_after = span_after + 2.0 * span_before;
    return divided(weight_before + weight_after, weight_before / before + weight_after / after);
}

/// Place on a ramp: the colors before and after it, and the way between them.
struct RampPlace {
    before: vec4f,
    after: vec4f,
    /// Way from `before` to `after`, 0 to 1; smooth ramps are level at each stop.
    t: f32,
}

/// The place of x on a ramp that is not stepped. Transparent black for a ramp without stops.
fn ramp_place(ramp: Ramp, x: f32) -> RampPlace {
    let count = min(ramp.count, 16u);
    if count == 0u {
        return RampPlace(vec4f(0.0), vec4f(0.0), 0.0);
    }
    var colors = ramp.colors;
    var places = ramp.places;
    var at = 0u;
    for (var i = 1u; i < count; i++) {
        at = select(at, i, places[i / 4u][i % 4u] <= x);
    }
    let after = min(at + 1u, count - 1u);
    let place = places[at / 4u][at % 4u];
    let t = clamp(divided(x - place, places[after / 4u][after % 4u] - place), 0.0, 1.0);
    return RampPlace(colors[at], colors[after],
        select(t, eased(t, 0.0, 1.0), ramp.interpolation == INTERPOLATION_SMOOTH));
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

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
fn output(color: Composite) -> Color {
    return finite_vec4(straight(color));
}

fn ramp_oklab(value: f32, ramp: Ramp) -> Color {
    let w = footprint_of(value);
    if ramp.interpolation == INTERPOLATION_STEPPED {
        return ramp_at(ramp, bounded(value), w);
    }
    let place = ramp_place(ramp, bounded(value));
    return mixed_in_oklab(place.before, place.after, place.t);
}

/// Shading of the detail that a finer normal has beyond a coarser one: -1 where the finer turns
/// from the light, 1 where it turns toward the light. The light is laid at the coarser normal's
/// horizon, so that detail is lit as well as can be, however the light falls.
fn detail_lit(finer: vec3f, coarser: vec3f, light: vec3f, contrast: f32) -> f32 {
    let across = light - dot(light, coarser) * coarser;
    // Straight under the light there is no direction along the surface, and detail fades.
    let toward = across / max(length(across), 0.05);
    return clamp(contrast * dot(finer, toward), -1.0, 1.0);
}

/// Share of a pixel that a line covers which is `width` pixels wide and `distance` pixels away.
fn line_covers(distance: f32, width: f32) -> f32 {
    return clamp(width + 0.5 - distance, 0.0, min(width, 1.0));
}

fn exaggerated_four(
    light: Light,
    normal: vec3f,
    contrast: f32,
    detail: f32,
    smooth_1: vec3f,
    smooth_2: vec3f,
    smooth_3: vec3f,
    smooth_4: vec3f,
) -> f32 {
    let a = clamp(bounded(contrast), 0.0, 50.0);
    let r = exp2_stable(-clamp(bounded(detail), -8.0, 8.0));
    let n = normalize_or(normal, vec3f(0.0, 0.0, 1.0));
    let n1 = normalize_or(smooth_1, n);
    let n2 = normalize_or(smooth_2, n1);
    let n3 = normalize_or(smooth_3, n2);
    let n4 = normalize_or(smooth_4, n3);
    let l = light.direction;
    let coarse = detail_lit(n2, n3, l, a) + r * (detail_lit(n3, n4, l, a) + r * dot(n4, l));
    let sum = detail_lit(n, n1, l, a) + r * (detail_lit(n1, n2, l, a) + r * coarse);
    return clamp(0.5 + 0.5 * sum / (1.0 + r * (1.0 + r * (1.0 + r * (1.0 + r)))), 0.0, 1.0);
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

const from_dusk_to_sun = Ramp(array(vec4f(0.1373, 0.1647, 0.302, 1.0), vec4f(0.4196, 0.3725, 0.5255, 1.0), vec4f(0.7882, 0.5804, 0.4353, 1.0), vec4f(0.9412, 0.8039, 0.5725, 1.0), vec4f(1.0, 0.9843, 0.902, 1.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0)), array(vec4f(0.05, 0.35, 0.55, 0.75), vec4f(0.98, 0.0, 0.0, 0.0), vec4f(0.0), vec4f(0.0)), 5u, 0u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let every_scale_of_detail = exaggerated_four(look.key, surface.normal, 7.0, 0.1, surface.smooth_normal_1, surface.smooth_normal_2, surface.smooth_normal_3, surface.smooth_normal_4);
    let from_dusk_to_sun_2 = ramp_oklab(every_scale_of_detail, from_dusk_to_sun);
    let ink = outer_contour(3.0, surface.normal, surface.view, look.viewport);
    let inked = mix_colors_normal(from_dusk_to_sun_2, vec4f(0.098, 0.1059, 0.2, 1.0), ink);
    let output_2 = output(premultiplied(inked));
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
    surface.smooth_normal_1 = (vec4f(textureLoad(smooth_normal_1_map, vec2i(in.clip.xy), 0).xyz, 0.0) * view.camera_from_world).xyz;
    surface.smooth_normal_2 = (vec4f(textureLoad(smooth_normal_2_map, vec2i(in.clip.xy), 0).xyz, 0.0) * view.camera_from_world).xyz;
    surface.smooth_normal_3 = (vec4f(textureLoad(smooth_normal_3_map, vec2i(in.clip.xy), 0).xyz, 0.0) * view.camera_from_world).xyz;
    surface.smooth_normal_4 = (vec4f(textureLoad(smooth_normal_4_map, vec2i(in.clip.xy), 0).xyz, 0.0) * view.camera_from_world).xyz;
    let shaded = shade(surface);
    return finite_vec4(shaded);
}
