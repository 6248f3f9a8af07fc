// Arithmetic that gives a documented, finite result for every input.
//
// WGSL promises little of exp2, log2, sin, cos and division; where an angle or a profile must be
// exact, the functions here use sums and products alone, which every implementation rounds
// correctly.

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
/// @where x is finite : x
fn finite_or(x: f32, otherwise: f32) -> f32 {
    return select(otherwise, x, is_finite(x));
}

/// v with 0 for each component that is NaN or infinite.
/// @where v is finite : v
fn finite_vec3(v: vec3f) -> vec3f {
    let exponent = vec3u(0x7f800000u);
    return select(vec3f(0.0), v, (bitcast<vec3u>(v) & exponent) != exponent);
}

/// v with 0 for each component that is NaN or infinite.
/// @where v is finite : v
fn finite_vec4(v: vec4f) -> vec4f {
    let exponent = vec4u(0x7f800000u);
    return select(vec4f(0.0), v, (bitcast<vec4u>(v) & exponent) != exponent);
}

/// v at length 1, or `otherwise` where v is too short or too long to have a direction, or has a
/// NaN. Scaled by the largest component first, so that neither tiny nor huge vectors under- or
/// overflow.
/// @where v is unit : v
/// @where tier is balanced and |v| <= 1e18 and otherwise = 0 :
///   v * inverseSqrt(max(dot(v, v), 1e-30)) ~ 1e-6
/// @where |v| <= 1e18 : normalize_moderate(v, otherwise)
fn normalize_or(v: vec3f, otherwise: vec3f) -> vec3f {
    let largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if !((largest > 1e-30) & (largest < 1e30)) {
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

/// 2^n for n in [-126, 127], by its bits.
fn power_of_two(n: i32) -> f32 {
    return bitcast<f32>(u32(n + 127) << 23u);
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

/// ln(x) for normal x > 0.
fn log_stable(x: f32) -> f32 {
    return LN_2 * log2_stable(x);
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
/// @where |x| <= 0.1 : sin_cos_tiny(x)
/// @where |x| <= 0.785 : sin_cos_eighth(x)
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

/// [`normalize_or`] for a third of its price: a vector shorter than 1e-15 or longer than 1e18
/// counts as having no direction.
/// @where v is unit : v
/// @where tier is balanced and |v| <= 1e18 and otherwise = 0 :
///   v * inverseSqrt(max(dot(v, v), 1e-30)) ~ 1e-6
fn normalize_quick(v: vec3f, otherwise: vec3f) -> vec3f {
    let square = dot(v, v);
    // Comparisons are false for NaN; what `select` leaves out never reaches the result.
    let is_usable = (square > 1e-30) & (square < 1e36);
    return select(otherwise, v * inverseSqrt(select(1.0, square, is_usable)), is_usable);
}

/// [`normalize_or`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
/// @where v is unit : v
/// @where tier is balanced and otherwise = 0 : v * inverseSqrt(max(dot(v, v), 1e-30)) ~ 1e-6
fn normalize_moderate(v: vec3f, otherwise: vec3f) -> vec3f {
    let square = dot(v, v);
    return select(otherwise, v * inverseSqrt(max(square, 1e-30)), square > 1e-30);
}

/// v at length 1, for vectors that are seldom 0 and no longer than 1e18: normals, and directions
/// toward the eye. One shorter than 1e-15 points along z.
fn normalize_seen(v: vec3f) -> vec3f {
    return normalize_moderate(v, vec3f(0.0, 0.0, 1.0));
}

/// [`normalize_seen`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
fn normalize_seen_balanced(v: vec3f) -> vec3f {
    return v * inverseSqrt(max(dot(v, v), 1e-30));
}

/// sin(x) and cos(x) for |x| <= pi/2 by shorter polynomials (absolute error 4.2e-8 and 5.6e-9
/// beside rounding), exact at 0.
fn sin_cos_quick(x: f32) -> vec2f {
    let y = x * x;
    let s = x * (1.0 + y * (-0.16666666 + y * (0.0083332425
        + y * (-0.0001982274 + y * 2.6347564e-6))));
    let c = 1.0 + y * (-0.5 + y * (0.04166666 + y
        * (-0.0013888652 + y * (2.4774579e-5 - y * 2.6297516e-7))));
    return vec2f(s, c);
}

/// [`sin_cos_quick`] shorter still (absolute error 4.8e-6 and 2.2e-7).
fn sin_cos_short(x: f32) -> vec2f {
    let y = x * x;
    let s = x * (1.0 + y * (-0.16666542 + y * (0.008324197 - y * 0.00018846673)));
    let c = 1.0 + y * (-0.49999991 + y * (0.04166567 + y * (-0.0013868611 + y * 2.3476086e-5)));
    return vec2f(s, c);
}

/// log2(1 - y) for y in [0, 1): a series near 0, where 1 - y would round y away, else the
/// hardware's; -100 at 1.
fn log2_one_minus(y: f32) -> f32 {
    let series = -y * LOG2_E * (1.0 + y * (0.5
        + y * (0.333333333333333333 + y * (0.25 + y * 0.2))));
    return select(log2(max(1.0 - y, 7.8886091e-31)), series, y < 0.0625);
}
