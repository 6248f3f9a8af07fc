// Reflectance models of realistic rendering, to stand beside drawn ones. Each gives what a white
// surface under a light of intensity 1 sends to the eye, times pi: the cosine for a matt one.
import chiaro::types;
import chiaro::numeric;
import chiaro::total;
import chiaro::surface;

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

/// Cook and Torrance's model with the GGX distribution and Smith's height-correlated shadowing
/// (Walter et al. 2007, Heitz 2014).
fn ggx(r: Reflection, width: f32, at_normal: f32) -> f32 {
    if (r.n_l <= 0.0) | (r.n_v <= 0.0) {
        return 0.0;
    }
    let a2 = width * width;
    let bottom = max(r.sine2 + a2 * r.n_h * r.n_h, 1e-12);
    let distribution = a2 / (bottom * bottom);
    let toward_light = r.n_v * sqrt(r.n_l * r.n_l * (1.0 - a2) + a2);
    let toward_eye = r.n_l * sqrt(r.n_v * r.n_v * (1.0 - a2) + a2);
    let visibility = 0.5 / max(toward_light + toward_eye, 1e-9);
    return min(distribution * visibility * schlick(at_normal, r.v_h) * r.n_l, 1e6);
}

/// Oren and Nayar's rough matt surface (1994, their qualitative model), for a deviation of slopes
/// in radians.
fn oren_nayar(light: vec3f, normal: vec3f, view: vec3f, sigma: f32) -> f32 {
    let n_l = dot(normal, light);
    let n_v = dot(normal, view);
    if n_l <= 0.0 {
        return 0.0;
    }
    let s2 = sigma * sigma;
    let a = 1.0 - 0.5 * s2 / (s2 + 0.33);
    let b = 0.45 * s2 / (s2 + 0.09);
    // `across` is the cosine of the angle between light and eye around the normal, times the sines
    // of both. The model's sin of the larger angle times tan of the smaller one is both sines over
    // the larger cosine, so that no angle is needed.
    let across = dot(light, view) - n_l * n_v;
    let larger = max(max(n_l, n_v), 1e-3);
    return n_l * (a + b * max(across, 0.0) / larger);
}

/// Ward's anisotropic highlight (1992, in the form of Walter 2005) with a width along each of two
/// axes.
fn ward(light: vec3f, normal: vec3f, view: vec3f, x_axis: vec3f, y_axis: vec3f,
    widths: vec2f) -> f32 {
    let n_l = dot(normal, light);
    let n_v = dot(normal, view);
    if (n_l <= 0.0) | (n_v <= 0.0) {
        return 0.0;
    }
    let half = half_of(light, normal, view);
    let n_h = max(dot(normal, half), 1e-6);
    let slope = vec2f(dot(half, x_axis), dot(half, y_axis)) / (widths * n_h);
    let lobe = exp2_stable(-LOG2_E * min(dot(slope, slope), 200.0));
    return min(n_l * lobe / (4.0 * widths.x * widths.y * sqrt(max(n_l * n_v, 1e-6))), 1e6);
}

/// Share of one wavelength that a thin film reflects: 0 where the waves from both its faces cancel,
/// 1 where they add up. `path` is the difference of both ways, in the wavelength's unit.
fn interference(path: f32, wavelength: f32) -> f32 {
    let half = sin_cos_of(PI * path / wavelength);
    // The wave is turned over at one face only, so a film of no thickness is black.
    return half.x * half.x;
}
