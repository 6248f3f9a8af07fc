// Shading profile: made by Chiaro 0.1.0, WGSL.
// What turns parameters and lights into the `Look` uniform of the module `draw`,
// called before drawing by the steps of `host` in the JSON file. Run it or port it.

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

/// sin(x/2) and cos(x/2) for x in [0, pi], given `left`, which is pi - x: both keep their relative
/// accuracy at both ends, because the smaller angle is halved and its cosine is the other's sine.
fn sin_cos_half(x: f32, left: f32) -> vec2f {
    let half = sin_cos_quarter(0.5 * min(x, left));
    return select(half.yx, half, x <= left);
}

/// pi - x for x up to pi, with the digits of pi that an f32 does not hold; 0 where x is the f32
/// next to pi.
fn left_to_pi(x: f32) -> f32 {
    // pi in two parts. The first is an f32, so that f64 reads the same one; the maximum keeps
    // compilers from making one constant of both.
    let coarse = max(3.1415927410125732421875 - x, 0.0);
    return max(coarse - 8.742278012618954e-8, 0.0);
}

/// Light
///
/// A light of the look, as it arrives at the surface. Its data (type, direction, color) is kept
/// with the look's lights; turning the illumination frame turns every light in it.
fn light_directional(direction: vec3f, own_direction: vec3f, color: vec3f,
    intensity: f32) -> Light {
    return Light(direction, own_direction, color, intensity);
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

const PROFILE_SOFT: u32 = 0u;
const PROFILE_STEP: u32 = 1u;
const PROFILE_AMBIENT: u32 = 2u;
/// Sanitises offset, fall-off and cut-off (D2) and makes the shape (BADF eq. 10, 11; docs/math.md
/// 2.1 to 2.3). An offset within 1e-5 of pi is ambient: pi has no exact f32, and people write
/// 3.14159.
fn profile_shape(offset: f32, falloff: f32, cutoff: f32) -> ProfileShape {
    let tau = clamp(offset, 0.0, PI);
    let zero_at = clamp(cutoff, tau, PI);
    let steep_at = clamp(falloff, tau, zero_at);
    let c = zero_at - tau;
    let f = steep_at - tau;
    let half_tau = sin_cos_quarter(0.5 * tau);
    var shape = ProfileShape(half_tau.y, half_tau.x, 0.0, 1.0, tau, 0.0, 0.0, PROFILE_STEP);
    if tau >= PI - 1e-5 {
        shape.kind = PROFILE_AMBIENT;
        return shape;
    }
    let sin_c = sin_cos_quarter(0.5 * c).x;
    let sin_f = sin_cos_quarter(0.5 * f).x;
    if (sin_c <= 0.0) | (sin_f < 1e-9) {
        return shape;
    }
    shape.kind = PROFILE_SOFT;
    shape.scale = 1.0 / sin_c;
    // The differences to pi are taken from the angles as they came: c and f have lost those digits.
    shape.exponent = profile_exponent(f, c, left_to_pi(steep_at) + tau, left_to_pi(zero_at) + tau);
    return profile_edge(shape, c);
}

/// gamma(f, c) of BADF eq. 11 by half-angles: 1 exactly at f = c, also at the corner f = c = pi
/// (D5). `f_left` and `c_left` are pi - f and pi - c, with digits of their own where they are
/// small.
fn profile_exponent(f: f32, c: f32, f_left: f32, c_left: f32) -> f32 {
    let half_c = sin_cos_half(c, c_left);
    let half_f = sin_cos_half(f, f_left);
    // c - f, from the two of them that are small.
    let apart = select(f_left - c_left, c - f, c < HALF_PI);
    if apart <= 0.0 {
        return 1.0;
    }
    // sin((c + f) / 2) by the addition theorem: (c + f) / 2 may exceed a quarter turn.
    let sum = half_c.x * half_f.y + half_c.y * half_f.x;
    let difference = sin_cos_quarter(0.5 * apart).x;
    let sin_f = 2.0 * half_f.x * half_f.y;
    return (sum * sum + difference * difference) / (sin_f * sin_f);
}

/// `shape` with its edge: mean and standard deviation of -eta' over [0, c], by the trapezoid rule
/// on eta, which tell how wide the soft edge looks.
fn profile_edge(shape: ProfileShape, c: f32) -> ProfileShape {
    let steps = 64;
    let h = c / f32(steps);
    var area = 0.5;
    var moment = 0.0;
    for (var i = 1; i < steps; i++) {
        let x = f32(i) * h;
        let q = min(sin_cos_quarter(0.5 * x).x * shape.scale, 1.0);
        let eta = profile_power(q, shape.exponent);
        area += eta;
        moment += x * eta;
    }
    var result = shape;
    // By integration by parts the mean of -eta' is the area under eta, and the mean square twice
    // the area under x eta.
    result.edge_mean = area * h;
    result.edge_deviation = sqrt(max(2.0 * moment * h - area * area * h * h, 0.0));
    return result;
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

fn profile_prepare(offset: f32, falloff: f32, cutoff: f32) -> ProfileShape {
    return profile_shape(offset, falloff, cutoff);
}
