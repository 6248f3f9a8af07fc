// Paper wash: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2.
// paper-wash.json says what to put there and how to draw.

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
    viewport: vec2f,
    @align(16) key: Light,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    pixel: vec2f,
    anchor: vec3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;

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

/// a / b; 0 where b is 0.
fn divided(a: f32, b: f32) -> f32 {
    if abs(b) < SMALLEST_NORMAL {
        return 0.0;
    }
    return bounded(a / b);
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

/// The stairs floor(x) from 0 to `count` - 1, averaged over a footprint of `w`; x in [0, count],
/// count at least 2.
fn stairs_filtered(x: f32, count: f32, w: f32) -> f32 {
    if w <= 1.0 {
        // At most one edge lies in the footprint: the nearest.
        let edge = clamp(round(x), 1.0, count - 1.0);
        return edge - 1.0 + step_filtered(x, edge, w);
    }
    // Beyond a million stairs to the pixel the average does not change any more, and digits would
    // be lost.
    let half = 0.5 * min(w, 1e3 * count);
    return (stairs_integral(x + half, count) - stairs_integral(x - half, count)) / (2.0 * half);
}

/// A value from 0 to 1 in `count` flat steps (at least 2), the first 0 and the last 1, seen through
/// a footprint of `w`; `softness` is the share of a step that its edge takes.
fn stepped_tone(value: f32, w: f32, count: i32, softness: f32) -> f32 {
    let n = f32(clamp(count, 2, 1024));
    let width = edge_width(n * w, min(softness, 1.0));
    return clamp(stairs_filtered(n * clamp(bounded(value), 0.0, 1.0), n, width) / (n - 1.0), 0.0,
        1.0);
}

/// The integral of the stairs from 0 to x; they are 0 below 0 and `count` - 1 above `count`.
fn stairs_integral(x: f32, count: f32) -> f32 {
    let inside = clamp(x, 0.0, count);
    let stair = min(floor(inside), count - 1.0);
    let beyond = max(x - count, 0.0);
    return stair * (0.5 * (stair - 1.0) + inside - stair) + beyond * (count - 1.0);
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

/// A share (an opacity, a mask) clamped to [0, 1]: beyond, a mix would go past what it mixes.
fn unit_share(share: f32) -> f32 {
    return clamp(share, 0.0, 1.0);
}

/// `color` with its alpha clamped to [0, 1].
fn with_unit_alpha(color: Color) -> Color {
    return vec4f(color.xyz, unit_share(color.w));
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

/// Bands
///
/// Cuts a tone into flat bands of the same width, the first 0 and the last 1: cel shading. The
/// edges are antialiased by their own width on the screen.
fn bands(value: f32, count: i32, softness: f32) -> f32 {
    return stepped_tone(value, footprint_of(value), count, softness);
}

/// Color ramp
///
/// Turns a number into a color along a ramp: a tone into paint. Before the first stop and after
/// the last one the color stays; the edges of a stepped ramp are antialiased.
fn ramp_plain(value: f32, ramp: Ramp) -> Color {
    let w = footprint_of(value);
    return ramp_at(ramp, bounded(value), w);
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

/// Add
///
/// The sum of two numbers, vectors or colors. A color keeps the alpha of A.
fn add(a: f32, b: f32) -> f32 {
    return bounded(a + b);
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

/// Mix
///
/// Goes from A to B by a factor, in numbers, vectors and colors (with their alpha).
fn mix_values(a: f32, b: f32, factor: f32, clamped: bool) -> f32 {
    return mixed(bounded(a), bounded(b), factor_of(factor, clamped));
}

const indigo_to_warm_paper = Ramp(array(vec4f(0.13, 0.14, 0.33, 1.0), vec4f(0.24, 0.36, 0.56, 1.0), vec4f(0.53, 0.66, 0.72, 1.0), vec4f(0.9, 0.8, 0.68, 1.0), vec4f(0.975, 0.95, 0.9, 1.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0), vec4f(0.0)), array(vec4f(0.0, 0.35, 0.62, 0.82), vec4f(1.0, 0.0, 0.0, 0.0), vec4f(0.0), vec4f(0.0)), 5u, 1u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let light_and_shade = reflectance_wrap(look.key, surface.normal, 0.5);
    let paper_that_goes_along = mark_place_object(0.0, surface.anchor, surface.pixel, look.viewport);
    let where_water_stood = paper_grain(0.5, paper_that_goes_along.place, paper_that_goes_along.stretch, 11.0, 0.0, 0.7, 5i, look.viewport);
    let uneven_edge = map_range(where_water_stood.height, 0.0, 1.0, -0.2, 0.2, true);
    let wet = add(light_and_shade, uneven_edge);
    let washes = bands(wet, 4i, 0.22);
    let pigment_in_them = mix_values(washes, wet, 0.35, true);
    let tooth_of_the_paper = paper_grain(pigment_in_them, paper_that_goes_along.place, paper_that_goes_along.stretch, 260.0, 0.2, 0.6, 0i, look.viewport);
    let indigo_to_warm_paper_2 = ramp_plain(tooth_of_the_paper.tone, indigo_to_warm_paper);
    let output_alpha = with_unit_alpha(indigo_to_warm_paper_2);
    let output_2 = output(premultiplied(output_alpha));
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
    surface.pixel = in.clip.xy * view.screen.xy + view.screen.zw;
    surface.anchor = anchor_on_screen((view.camera_from_world * vec4f(object.world_from_object[3].xyz, 1.0)).xyz, view.eye.w, length(vec3f(view.clip_from_world[0].y, view.clip_from_world[1].y, view.clip_from_world[2].y)));
    let shaded = shade(surface);
    return finite_vec4(shaded);
}
