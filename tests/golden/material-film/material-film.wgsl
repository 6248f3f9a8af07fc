// Iridescent film: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2.
// material-film.json says what to put there and how to draw.

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

fn position_object(position_object: vec3f) -> vec3f {
    return position_object;
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

/// Output
///
/// What the look shows: straight RGBA. Whatever a custom node lets through that is no number
/// becomes black here.
fn output(color: Composite) -> Color {
    return finite_vec4(straight(color));
}

/// Cosines between normal (n), light (l), view (v) and half-vector (h), of which all models are
/// made; every cosine is at least a little above 0 where it divides.
struct Reflection {
    n_l: f32,
    n_v: f32,
    n_h: f32,
    v_h: f32,
    /// The square of the sine between the normal and the half-vector: near a highlight's middle a
    /// cosine has no digits left to tell how far it is.
    sine2: f32,
}

/// The directions' cosines; the half-vector is the normal where light and eye are opposite.
fn reflection_of(light: vec3f, normal: vec3f, view: vec3f) -> Reflection {
    let half = half_of(light, normal, view);
    let n_h = clamp(dot(normal, half), 0.0, 1.0);
    let v_h = clamp(dot(view, half), 0.0, 1.0);
    return Reflection(dot(normal, light), dot(normal, view), n_h, v_h, sine_squared(normal, half));
}

/// The square of the sine between two unit vectors.
fn sine_squared(a: vec3f, b: vec3f) -> f32 {
    let across = cross(a, b);
    return min(dot(across, across), 1.0);
}

/// A cosine to a power, 0 where it is negative; by the square of its sine where that has more
/// digits.
fn cosine_power(cosine: f32, sine2: f32, exponent: f32) -> f32 {
    if cosine < 0.7 {
        return powered(max(cosine, 0.0), exponent);
    }
    return exp2_stable(0.5 * exponent * LOG2_E * log1p_negative(min(sine2, 0.6)));
}

/// The half-vector: unit, midway between the light and the eye; the normal where they are opposite.
fn half_of(light: vec3f, normal: vec3f, view: vec3f) -> vec3f {
    let half = light + view;
    return normalize_or(select(normal, half, dot(half, half) > 1e-12), normal);
}

/// The width of a highlight from an artist's roughness: its square, at least 0.001 so that a
/// mirror's is seen.
fn width_of_roughness(roughness: f32) -> f32 {
    let r = clamp(bounded(roughness), 0.0, 1.0);
    return max(r * r, 0.001);
}

/// Fresnel's reflectance by Schlick's approximation (1994), for a cosine.
fn schlick(at_normal: f32, cosine: f32) -> f32 {
    let m = clamp(1.0 - cosine, 0.0, 1.0);
    let m2 = m * m;
    return at_normal + (1.0 - at_normal) * (m2 * m2 * m);
}

/// Phong's exponent of a width: as wide as Beckmann's distribution of that width.
fn exponent_of_width(width: f32) -> f32 {
    return max(2.0 / (width * width) - 2.0, 0.0);
}

/// Share of one wavelength that a thin film reflects: 0 where the waves from both its faces cancel,
/// 1 where they add up. `path` is the difference of both ways, in the wavelength's unit.
fn interference(path: f32, wavelength: f32) -> f32 {
    let half = sin_cos_of(PI * path / wavelength);
    // The wave is turned over at one face only, so a film of no thickness is black.
    return half.x * half.x;
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

/// Fresnel
///
/// More toward the rim, as glass, water and lacquer reflect: Schlick's approximation.
fn fresnel(at_normal: f32, normal: vec3f, view: vec3f) -> f32 {
    let cosine = clamp(dot(normalize_or(normal, vec3f(0.0, 0.0, 1.0)), view), 0.0, 1.0);
    return schlick(factor_of(at_normal, true), cosine);
}

fn reflectance_blinn_phong(light: Light, normal: vec3f, view: vec3f, roughness: f32) -> f32 {
    let r = reflection_of(light.direction, normalize_or(normal, vec3f(0.0, 0.0, 1.0)), view);
    let e = exponent_of_width(width_of_roughness(roughness));
    let shine = cosine_power(r.n_h, r.sine2, e);
    return min(0.125 * (e + 8.0) * shine * max(r.n_l, 0.0), 1e6);
}

/// Thin film
///
/// The colors of soap bubbles, beetles and oil on water: a film that is as thin as light's waves
/// are long reflects some and cancels others, changing with the angle.
fn thin_film(thickness: f32, index: f32, normal: vec3f, view: vec3f) -> Color {
    let cosine = clamp(dot(normalize_or(normal, vec3f(0.0, 0.0, 1.0)), view), 0.0, 1.0);
    let n = clamp(bounded(index), 1.0, 3.0);
    // Snell's law: the cosine within the film, times the index; a film of index 1 does not bend
    // light at all.
    let inside = sqrt((n - 1.0) * (n + 1.0) + cosine * cosine);
    let path = 2.0 * clamp(bounded(thickness), 0.0, 2000.0) * inside;
    return vec4f(interference(path, 650.0), interference(path, 532.0), interference(path, 450.0),
        1.0);
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

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    let place = position_object(surface.position_object);
    let swirl = noise_perlin(place, 1.3, 2i, 0.5, 0i);
    let thickness = map_range(swirl, 0.0, 1.0, 180.0, 420.0, true);
    let film = thin_film(thickness, 1.33, surface.normal, surface.view);
    let glow = fresnel(0.45, surface.normal, surface.view);
    let film_2 = blend_add(vec4f(0.0784, 0.0863, 0.1216, 1.0), film, glow, 1.0, true);
    let highlight = reflectance_blinn_phong(look.key, surface.normal, surface.view, 0.22);
    let highlight_on_top = blend_add(film_2, vec4f(1.0), highlight, 0.2, true);
    let output_2 = output(highlight_on_top);
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
