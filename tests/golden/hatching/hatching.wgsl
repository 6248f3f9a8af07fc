// Hatching: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2, curvature_tensor_map 3.
// hatching.json says what to put there and how to draw.

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
    @align(16) key: Light,
    @align(16) viewport: vec2f,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
    position_object: vec3f,
    curvature_tensor: vec3f,
    magnification: f32,
    world_from_normal: mat3x3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;
@group(0) @binding(3) var curvature_tensor_map: texture_2d<f32>;

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

/// Tensor fit for use: [`kappa_safe`] of each number.
fn tensor_safe(tensor: vec3f) -> vec3f {
    return vec3f(kappa_safe(tensor.x), kappa_safe(tensor.y), kappa_safe(tensor.z));
}

/// The greatest and the least curvature of a tensor (xx, xy, yy): its eigenvalues.
fn principal_curvatures(tensor: vec3f) -> vec2f {
    let mean = 0.5 * (tensor.x + tensor.z);
    let spread = length(vec2f(0.5 * (tensor.x - tensor.z), tensor.y));
    // The curvature nearer 0 would have no digits left as a difference; the product of both, the
    // determinant, gives it.
    let far = mean + select(-spread, spread, mean >= 0.0);
    let near = divided(tensor.x * tensor.z - tensor.y * tensor.y, far);
    return select(vec2f(near, far), vec2f(far, near), mean >= 0.0);
}

/// Facing ratio
///
/// 1 where the surface faces the eye, 0 at its rim: for rim light, outlines, dusty cloth and candy
/// edges.
fn facing(normal: vec3f, view: vec3f) -> f32 {
    return clamp(dot(normalize_or(normal, vec3f(0.0)), view), 0.0, 1.0);
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

/// Combine tones
///
/// Cuts, joins and crosses shapes of light, as one does with shapes in a drawing program.
fn combine_tones_union(a: f32, b: f32) -> f32 {
    return max(factor_of(a, true), factor_of(b, true));
}

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
fn output(color: Composite) -> Color {
    return finite_vec4(straight(color));
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

/// A random number in [0, 1) from the upper 24 bits of a hash, exactly.
fn unit_of_hash(hash: vec3u) -> vec3f {
    return vec3f(hash >> vec3u(8u)) * 5.9604644775390625e-8;
}

/// The hash of a lattice point.
fn lattice_hash(cell: vec3i, seed: u32) -> vec3u {
    return hash_pcg3d(bitcast<vec3u>(cell) + seed * vec3u(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u));
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

/// Size on screen of a unit of the scene at a depth, in picture heights. `perspective` is 1 or 0;
/// `scale` is what clip space multiplies heights by: at depth 1, or at every depth without
/// perspective.
fn size_on_screen(depth: f32, perspective: f32, scale: f32) -> f32 {
    // Clip space is 2 high.
    return bounded(0.5 * scale / mix(1.0, max(depth, 1e-6), perspective));
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

/// Gradient along the picture of a coordinate that has the gradient `g` in space, on a surface seen
/// from `view`: a way along the picture is drawn out on the surface, at rims up to eight times.
/// Vectors are unit but for g.
fn gradient_on_picture(g: vec3f, normal: vec3f, view: vec3f) -> vec3f {
    let facing = dot(normal, view);
    return g - normal * (dot(g, view) / select(min(facing, -0.125), max(facing, 0.125),
        facing >= 0.0));
}

/// A place on a surface for strokes across an axis of the object.
fn place_across(
    axis: vec3f,
    position: vec3f,
    world_from_normal: mat3x3f,
    normal: vec3f,
    view: vec3f,
    magnification: f32,
    angle: f32,
) -> StretchedPlace {
    let axes = axes_around(axis, vec3f(0.0, 1.0, 0.0));
    let p = bounded_vec3(position);
    let place = vec2f(dot(p, axes[0]), dot(p, axes[2]));
    let along = bounded_vec3(world_from_normal * axes[0]);
    let across = bounded_vec3(world_from_normal * axes[2]);
    return place_on_surface(place, along, across, normal, view, magnification, angle);
}

/// A place on a surface whose coordinates have the gradients `along` and `across` in world space.
fn place_on_surface(
    place: vec2f,
    along: vec3f,
    across: vec3f,
    normal: vec3f,
    view: vec3f,
    magnification: f32,
    angle: f32,
) -> StretchedPlace {
    let n = normalize_or(normal, vec3f(0.0, 0.0, 1.0));
    let v = normalize_or(view, vec3f(0.0, 0.0, 1.0));
    let height = 1.0 / clamp(bounded(magnification), 1e-15, 1e15);
    let x = bounded_vec3(gradient_on_picture(along, n, v) * height);
    let y = bounded_vec3(gradient_on_picture(across, n, v) * height);
    return mark_place_of(bounded_vec2(place), x, y, angle);
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

/// Octave of the marks at a place: log2 of how many times finer than the place's own units they
/// must lie, for a squared stretch; within +-16.
fn octave_of(square: f32) -> f32 {
    return clamp(-0.5 * LOG2_E * log_stable(clamp(square, 1e-30, 1e30)), -16.0, 16.0);
}

/// Style of strokes.
struct Strokes {
    /// Width of a stroke, in spacings.
    width: f32,
    /// Length of a stroke, in spacings; 0 for endless strokes.
    length: f32,
    /// Share of a stroke that its ends take, 0 to 1.
    taper: f32,
    /// Distance that strokes stray, in spacings.
    wobble: f32,
    /// Effect of a darker tone: from more strokes at 0 to wider ones at 1.
    pressure: f32,
    /// Growth of the strokes between others: from all together at 0 to one after the other at 1.
    variation: f32,
    seed: u32,
}

/// A stroke as seen at a place.
struct Stroke {
    /// Turn of the stroke among its neighbors, 0 to 1.
    turn: f32,
    /// Width of the stroke at the place, as a share of its full width.
    profile: f32,
}

/// The stroke of a line at x, in one octave. A line's name is an odd number and the octave that it
/// first lies in.
fn stroke_at(line: vec2i, x: f32, zoom: i32, style: Strokes) -> Stroke {
    let own = unit_of_hash(lattice_hash(vec3i(line, 1 << 20u), style.seed));
    if style.length <= 0.0 {
        return Stroke(own.y, 1.0);
    }
    let along = clamp(x * power_of_two(zoom) / style.length, -1e6, 1e6) + own.x;
    let index = floor(along);
    let chance = unit_of_hash(lattice_hash(vec3i(line, i32(index)), style.seed
        + bitcast<u32>(zoom)));
    let from_end = min(along - index, 1.0 - (along - index));
    let slope = clamp(from_end / max(0.5 * style.taper, 1e-6), 0.0, 1.0);
    return Stroke(chance.x, slope * (2.0 - slope));
}

/// A stroke where an octave fades into the next.
fn stroke_between(line: vec2i, x: f32, level: f32, style: Strokes) -> Stroke {
    let zoom = floor(level);
    let a = stroke_at(line, x, i32(zoom), style);
    let b = stroke_at(line, x, i32(zoom) + 1, style);
    let f = level - zoom;
    return Stroke(mix(a.turn, b.turn, f), mix(a.profile, b.profile, f));
}

/// Distance that strokes stray at a place of an octave, in spacings of the place.
fn stray_at(place: vec2f, zoom: i32, seed: u32) -> f32 {
    // The noise changes slowly along a stroke and differs between neighbors.
    let p = place * power_of_two(zoom);
    return (value_noise(vec3f(0.11 * p.x, 0.45 * p.y, 0.5), seed) - 0.5) * 2.0
        * power_of_two(-zoom);
}

/// Share of a footprint of `w` that a band covers whose middle is t away and which reaches `half`
/// to both sides.
fn band_filtered(t: f32, half: f32, w: f32) -> f32 {
    if w < 1e-30 {
        return select(0.0, 1.0, abs(t) <= half && half > 0.0);
    }
    return clamp((clamp(t + 0.5 * w, -half, half) - clamp(t - 0.5 * w, -half, half)) / w, 0.0, 1.0);
}

/// The ink of one direction of strokes. `place` is along and across, in spacings at `level` 0; `w`
/// is the footprint of the coordinate across. The average ink is `ink` times the width, but for
/// tapers.
fn hatched(place: vec2f, w: f32, level: f32, ink: f32, style: Strokes) -> f32 {
    if !(ink > 0.0) {
        return 0.0;
    }
    let number = powered(ink, 1.0 - style.pressure);
    let width = style.width * powered(ink, style.pressure);
    let zoom = floor(level);
    let stray = mix(stray_at(place, i32(zoom), style.seed),
        stray_at(place, i32(zoom) + 1, style.seed), level - zoom);
    let across = place.y + style.wobble * stray;
    // Every whole number of an octave has its stroke; between them those of the next octave grow.
    let density = clamp(level + LOG2_E * log_stable(max(number, 1e-9)), -40.0, 17.0);
    let octave = floor(density);
    let growth = exp2_stable(density - octave) - 1.0;
    let scale = power_of_two(i32(octave));
    let q = clamp(across * scale, -4194304.0, 4194304.0);
    let half = 0.5 * width * exp2_stable(octave - level);
    let footprint = w * scale;
    let whole = i32(round(q));
    let old = stroke_between(line_of(whole, i32(octave)), place.x, level, style);
    let middle = floor(q);
    let young = stroke_between(vec2i(2 * i32(middle) + 1, i32(octave) + 1), place.x, level, style);
    let late = 0.75 * style.variation;
    let grown = clamp((growth - late * young.turn) / (1.0 - late), 0.0, 1.0);
    let a = band_filtered(q - f32(whole), half * old.profile, footprint);
    let b = band_filtered(q - middle - 0.5, half * grown * young.profile, footprint);
    // Strokes finer than a pixel are their average.
    let mean = min(2.0 * half * (1.0 + growth), 1.0);
    return mix(max(a, b), mean, eased(footprint, 0.75, 1.5));
}

/// The name of a whole place's line in an octave: an odd number and the octave that the line first
/// lies in. The line at 0 lies in all.
fn line_of(whole: i32, octave: i32) -> vec2i {
    let power = select(whole & -whole, 1, whole == 0);
    // log2 of a power of two, by its bits.
    let octaves = i32(bitcast<u32>(f32(power)) >> 23u) - 127;
    return select(vec2i(whole / power, octave - octaves), vec2i(0), whole == 0);
}

/// The ink of strokes in up to four directions, each turned by `cross` radians from the one before:
/// the first take the light tones, and the others come in one after the other.
fn cross_hatched(at: SpacedPlace, ink: f32, layers: i32, cross: f32, style: Strokes) -> f32 {
    let x = dpdx(at.place);
    let y = dpdy(at.place);
    let count = clamp(layers, 1, 4);
    let amount = clamp(bounded(ink), 0.0, 1.0) * f32(count);
    var free = 1.0;
    for (var i = 0; i < 4; i++) {
        if i < count {
            let turn = sin_cos_of(f32(i) * cross);
            let along = vec2f(turn.y, turn.x);
            let across = vec2f(-turn.x, turn.y);
            let w = bounded(length(vec2f(dot(across, x), dot(across, y))));
            let s = at.stretch;
            // A place that hardly changes across the strokes counts as one that is drawn out eight
            // times, as in `area_square`.
            let square = dot(vec3f(across.x * across.x, 2.0 * across.x * across.y,
                across.y * across.y), s);
            let level = octave_of(max(square, (s.x + s.z) / 65.0));
            let place = vec2f(dot(along, at.place), dot(across, at.place));
            var own = style;
            own.seed = style.seed + 101u * u32(i);
            free *= 1.0 - hatched(place, w, level, clamp(amount - f32(i), 0.0, 1.0), own);
        }
    }
    return 1.0 - free;
}

/// Hatching
///
/// Draws a tone by strokes. Their width and spacing belong to the picture, whatever the distance;
/// darker adds whole strokes between those that are there, and then strokes of another direction,
/// so that lighter tones' strokes are always among darker tones'.
fn hatching(
    value: f32,
    place: vec2f,
    stretch: vec3f,
    count: f32,
    width: f32,
    layers: i32,
    cross: f32,
    length: f32,
    taper: f32,
    wobble: f32,
    pressure: f32,
    variation: f32,
    seed: i32,
    viewport: vec2f,
) -> f32 {
    let style = Strokes(
        clamp(bounded(width), 0.0, 1.0),
        clamp(bounded(length), 0.0, 1e4),
        clamp(bounded(taper), 0.0, 1.0),
        clamp(bounded(wobble), 0.0, 100.0),
        clamp(bounded(pressure), 0.0, 1.0),
        clamp(bounded(variation), 0.0, 1.0),
        bitcast<u32>(seed),
    );
    let at = spaced(place, stretch, viewport, count);
    return cross_hatched(at, 1.0 - factor_of(value, true), layers, cross, style);
}

/// Mark place
///
/// Where strokes and dots are anchored, and which way strokes go: on the picture, on the picture
/// but moving along with the object, along texture coordinates, across an axis of the object, or
/// around the light so that they turn with it. Wire both outputs to Hatching, Stippling, Brush
/// strokes or Paper grain, which keep their marks as large on the picture as they are, however far
/// the surface is.
fn mark_place_light(
    light: Light,
    normal: vec3f,
    angle: f32,
    view: vec3f,
    position_object: vec3f,
    world_from_normal: mat3x3f,
    magnification: f32,
) -> MarkPlace {
    let toward = light.direction * world_from_normal;
    let m = place_across(toward, position_object, world_from_normal, normal, view, magnification,
        angle);
    return MarkPlace(m.place, m.stretch);
}

struct MarkPlace {
    /// Along the strokes, and across them.
    place: vec2f,
    /// How fast both change along the picture: products xx, xy and yy, per picture height.
    stretch: vec3f,
}

fn reflectance_wrap(light: Light, normal: vec3f, wrap: f32) -> f32 {
    let w = clamp(bounded(wrap), 0.0, 1.0);
    let cosine = dot(normalize_or(normal, vec3f(0.0, 0.0, 1.0)), light.direction);
    return max((cosine + w) / (1.0 + w), 0.0);
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

/// Smooth step
///
/// Eases from 0 to 1 between two numbers, slowly at both ends. With low above high it eases from 1
/// to 0; where both are the same it is a step.
fn smooth_step_value(value: f32, low: f32, high: f32) -> f32 {
    return eased(value, low, high);
}

/// Trust in curvature on the screen: 0 at the outline, where curvature has no bound and no digits,
/// 1 where the surface is seen well.
fn seen_well(facing: f32) -> f32 {
    return eased(facing, 0.05, 0.3);
}

fn inner_contour_valleys(limit: f32, softness: f32, tensor: vec3f, normal: vec3f,
    view: vec3f) -> f32 {
    let least = principal_curvatures(tensor_safe(tensor)).y;
    return faded_in(-least, limit, softness) * seen_well(dot(normal, view));
}

/// Fade at a limit: 0 below and 1 above, over `softness` of the limit and never less than a pixel.
fn faded_in(x: f32, limit: f32, softness: f32) -> f32 {
    let at = max(bounded(limit), 0.0);
    let width = edge_width(footprint_of(x), min(at, 1e9) * factor_of(softness, true));
    return step_filtered(bounded(x), at, width);
}

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let light_and_shade = reflectance_wrap(look.key, surface.normal, 0.35);
    let tone_to_draw = map_range(light_and_shade, 0.0, 0.85, 0.04, 1.0, true);
    let around_the_light = mark_place_light(look.key, surface.normal, 0.0, surface.view, surface.position_object, surface.world_from_normal, surface.magnification);
    let pen_strokes = hatching(tone_to_draw, around_the_light.place, around_the_light.stretch, 120.0, 0.42, 3i, 0.8, 24.0, 0.6, 0.45, 0.25, 1.0, 4i, look.viewport);
    let facing_2 = facing(surface.normal, surface.view);
    let contour = smooth_step_value(facing_2, 0.34, 0.2);
    let ink = combine_tones_union(pen_strokes, contour);
    let features = inner_contour_valleys(75.0, 0.3, surface.curvature_tensor, surface.normal, surface.view);
    let strokes_and_features = combine_tones_union(ink, features);
    let pen_on_paper = mix_colors_normal(vec4f(0.965, 0.937, 0.875, 1.0), vec4f(0.12, 0.105, 0.16, 1.0), strokes_and_features);
    let output_2 = output(premultiplied(pen_on_paper));
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
    surface.curvature_tensor = textureLoad(curvature_tensor_map, vec2i(in.clip.xy), 0).xyz;
    surface.magnification = size_on_screen(-(view.camera_from_world * vec4f(in.position, 1.0)).z, view.eye.w, length(vec3f(view.clip_from_world[0].y, view.clip_from_world[1].y, view.clip_from_world[2].y)));
    surface.world_from_normal = object.world_from_normal;
    let shaded = shade(surface);
    return finite_vec4(shaded);
}
