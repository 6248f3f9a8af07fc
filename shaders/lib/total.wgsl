// Arithmetic of the math nodes, with a finite result for every input. NaN becomes 0, an infinite
// or too large result the largest number of its sign, and a number below the smallest normal one
// divides as 0.
import chiaro::numeric;
import chiaro::angle;

const SMALLEST_NORMAL: f32 = 1.17549435e-38;

/// x where it is finite, 0 where it is NaN, the largest number of its sign (3.4028235e38) where it
/// is infinite.
/// @where x is finite : x
fn bounded(x: f32) -> f32 {
    let bits = bitcast<u32>(x);
    let magnitude = bits & 0x7fffffffu;
    let largest = bitcast<f32>((bits & 0x80000000u) | 0x7f7fffffu);
    return select(select(0.0, largest, magnitude == 0x7f800000u), x, magnitude < 0x7f800000u);
}

/// [`bounded`], component by component.
/// @where v is finite : v
fn bounded_vec2(v: vec2f) -> vec2f {
    let bits = bitcast<vec2u>(v);
    let magnitude = bits & vec2u(0x7fffffffu);
    let largest = bitcast<vec2f>((bits & vec2u(0x80000000u)) | vec2u(0x7f7fffffu));
    let numbers = select(vec2f(0.0), largest, magnitude == vec2u(0x7f800000u));
    return select(numbers, v, magnitude < vec2u(0x7f800000u));
}

/// [`bounded`], component by component.
/// @where v is finite : v
fn bounded_vec3(v: vec3f) -> vec3f {
    let bits = bitcast<vec3u>(v);
    let magnitude = bits & vec3u(0x7fffffffu);
    let largest = bitcast<vec3f>((bits & vec3u(0x80000000u)) | vec3u(0x7f7fffffu));
    let numbers = select(vec3f(0.0), largest, magnitude == vec3u(0x7f800000u));
    return select(numbers, v, magnitude < vec3u(0x7f800000u));
}

/// [`bounded`], component by component.
/// @where v is finite : v
fn bounded_vec4(v: vec4f) -> vec4f {
    let bits = bitcast<vec4u>(v);
    let magnitude = bits & vec4u(0x7fffffffu);
    let largest = bitcast<vec4f>((bits & vec4u(0x80000000u)) | vec4u(0x7f7fffffu));
    let numbers = select(vec4f(0.0), largest, magnitude == vec4u(0x7f800000u));
    return select(numbers, v, magnitude < vec4u(0x7f800000u));
}

/// a / b; 0 where b is 0.
fn divided(a: f32, b: f32) -> f32 {
    if abs(b) < SMALLEST_NORMAL {
        return 0.0;
    }
    return bounded(a / b);
}

/// x - y floor(x / y): from 0 up to y, without y, with the sign of y; 0 where y is 0.
fn modulo_floored(x: f32, y: f32) -> f32 {
    let size = abs(y);
    if size < SMALLEST_NORMAL {
        return 0.0;
    }
    let turned = select(-x, x, y > 0.0);
    // Rounding may put the remainder just outside of its range, and far outside where x / y has no
    // digits left.
    let left = bounded(turned - size * floor(bounded(turned / size)));
    let wrapped = select(left, left + size, left < 0.0);
    let inside = select(0.0, wrapped, (wrapped >= 0.0) & (wrapped < size));
    return select(-inside, inside, y > 0.0);
}

/// base^exponent for every pair. A negative base is raised as in algebra by a whole exponent and
/// keeps its sign with any other, so that (-4)^0.5 is -2. 0 to a negative power is 0, as division
/// by 0 is; 0^0 is 1.
/// @where tier is balanced and base >= 0 and base <= 1.1 and exponent >= 1e-3 and exponent <= 500 :
///   pow(base, exponent) ~ 3e-4
/// @where tier is balanced and base >= 0 and base <= 1e4 and exponent >= 1e-3 and exponent <= 8 :
///   pow(base, exponent) ~ 3e-4
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
    let raised = exp2_stable(bounded(e * log2_stable(max(magnitude, SMALLEST_NORMAL))));
    let is_even = floor(e * 0.5) == e * 0.5;
    let signed = select(raised, -raised, (b < 0.0) & !is_even);
    return select(signed, 0.0, magnitude < SMALLEST_NORMAL);
}

/// [`powered`], component by component.
/// @where tier is balanced and base >= 0 and base <= 1.1 and exponent >= 1e-3 and exponent <= 500 :
///   pow(base, vec3f(exponent)) ~ 3e-4
/// @where tier is balanced and base >= 0 and base <= 1e4 and exponent >= 1e-3 and exponent <= 8 :
///   pow(base, vec3f(exponent)) ~ 3e-4
fn powered_vec3(base: vec3f, exponent: f32) -> vec3f {
    return vec3f(powered(base.x, exponent), powered(base.y, exponent), powered(base.z, exponent));
}

/// e^x; 0 far below, the largest number from 88.73 on.
/// @where tier is balanced and |x| <= 80 : exp(x) ~ 3e-5
fn exponential_of(x: f32) -> f32 {
    return exp2_stable(bounded(x * LOG2_E));
}

/// ln(x); 0 and everything below count as 1.2e-38, the smallest normal number, whose logarithm is
/// -87.34.
/// @where tier is balanced and x >= 1e-30 and x <= 1e30 : log(x) ~ 2e-5
fn logarithm_of(x: f32) -> f32 {
    return log_stable(max(bounded(x), SMALLEST_NORMAL));
}

/// Mix from a (where t is 0) to b (where t is 1): exact at both ends, and where a is b.
/// @where a = 0 and b = 1 and |t| <= 1e15 : t
/// @where |a| <= 1e18 and |b| <= 1e18 and |t| <= 1e15 : mix(a, b, t)
fn mixed(a: f32, b: f32, t: f32) -> f32 {
    let d = bounded(b - a);
    return bounded(select(b - (1.0 - t) * d, a + t * d, t < 0.5));
}

/// [`mixed`], component by component.
/// @where |a| <= 1e18 and |b| <= 1e18 and |t| <= 1e15 : mix(a, b, t)
fn mixed_vec2(a: vec2f, b: vec2f, t: f32) -> vec2f {
    let d = bounded_vec2(b - a);
    return bounded_vec2(select(b - (1.0 - t) * d, a + t * d, t < 0.5));
}

/// [`mixed`], component by component.
/// @where |a| <= 1e18 and |b| <= 1e18 and |t| <= 1e15 : mix(a, b, t)
fn mixed_vec3(a: vec3f, b: vec3f, t: f32) -> vec3f {
    let d = bounded_vec3(b - a);
    return bounded_vec3(select(b - (1.0 - t) * d, a + t * d, t < 0.5));
}

/// [`mixed`], component by component.
/// @where |a| <= 1e18 and |b| <= 1e18 and |t| <= 1e15 : mix(a, b, t)
fn mixed_vec4(a: vec4f, b: vec4f, t: f32) -> vec4f {
    let d = bounded_vec4(b - a);
    return bounded_vec4(select(b - (1.0 - t) * d, a + t * d, t < 0.5));
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
/// @where low < high and x is finite and |low| <= 1e30 and |high| <= 1e30 :
///   smoothstep(low, high, x)
fn eased(x: f32, low: f32, high: f32) -> f32 {
    let t = clamp(place_between(bounded(x), bounded(low), bounded(high)), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// A factor as it is, or kept within 0 and 1 when `clamped`.
fn factor_of(x: f32, clamped: bool) -> f32 {
    return select(bounded(x), clamp(bounded(x), 0.0, 1.0), clamped);
}

/// The length of v, also where its square would over- or underflow.
/// @where |v| <= 1e18 : length(v)
fn length_of(v: vec3f) -> f32 {
    let w = bounded_vec3(v);
    let largest = max(max(abs(w.x), abs(w.y)), abs(w.z));
    if largest < SMALLEST_NORMAL {
        return 0.0;
    }
    return bounded(largest * length(w / largest));
}

/// sin(x) for every x, in [-1, 1]; beyond 100,000 rounding leaves nothing of the phase. The form of
/// the balanced tier takes x as off by a rounding or two, which far from 0 is more than its bound.
/// @where tier is balanced and |x| <= 1e7 : sin(x) ~ 5e-5
/// @where |x| <= 1.6 : sine_low(x)
/// @where x >= 0 and x <= 4.17 : cosine_low(x - 1.57079632679489662)
/// @where x >= 1.55 and x <= 4.73 : sine_low((3.140625 - x) + 0.000967653589793238463)
/// @where x >= 2.12 and x <= 7.31 : -cosine_low(x - 4.71238898038468986)
/// @where |x| <= 3000 : sine_near(x)
fn sine_of(x: f32) -> f32 {
    let b = bounded(x);
    let turns = round(b * 0.318309886183790672);
    // Cody and Waite: pi in three parts, so that the reduced angle keeps its digits.
    let coarse = fma(turns, -0.0009670257568359375, fma(turns, -3.140625, b));
    let r = fma(turns, -6.27832957300962643e-7, coarse);
    // Far out, rounding of the turns leaves somewhat more than a quarter turn.
    return sine_turned(clamp(r, -1.6, 1.6), turns);
}

/// [`sine_of`] where two parts of pi are enough.
fn sine_near(x: f32) -> f32 {
    let turns = round(x * 0.318309886183790672);
    let r = fma(turns, -0.000967653589793238463, fma(turns, -3.140625, x));
    return sine_turned(r, turns);
}

/// cos(x) for every x, in [-1, 1]; beyond 100,000 rounding leaves nothing of the phase. The form of
/// the balanced tier is that of [`sine_of`].
/// @where tier is balanced and |x| <= 1e7 : cos(x) ~ 5e-5
/// @where |x| <= 2.6 : cosine_low(x)
/// @where x >= 0 and x <= 3.17 : sine_low((1.5703125 - x) + 0.000483826794896619231)
/// @where x >= 0.55 and x <= 5.74 : -cosine_low(x - 3.14159265358979324)
/// @where |x| <= 3000 : cosine_near(x)
fn cosine_of(x: f32) -> f32 {
    let b = bounded(x);
    let turns = round(b * 0.318309886183790672 - 0.5);
    let middle = turns + 0.5;
    let coarse = fma(middle, -0.0009670257568359375, fma(middle, -3.140625, b));
    let r = fma(middle, -6.27832957300962643e-7, coarse);
    return sine_turned(-clamp(r, -1.6, 1.6), turns);
}

/// [`cosine_of`] where two parts of pi are enough.
fn cosine_near(x: f32) -> f32 {
    let turns = round(x * 0.318309886183790672 - 0.5);
    let middle = turns + 0.5;
    let r = fma(middle, 0.000967653589793238463, fma(middle, 3.140625, -x));
    return sine_turned(r, turns);
}

/// sin(r + pi turns) for |r| <= 1.6 and whole turns.
fn sine_turned(r: f32, turns: f32) -> f32 {
    // Odd turns, of which half is left, turn the sign.
    return sine_low(r) * fma(fract(turns * 0.5), -4.0, 1.0);
}

/// sin(r) for |r| <= 1.6, a quarter turn and some more: a minimax polynomial (absolute error below
/// 6e-9 beside rounding).
fn sine_low(r: f32) -> f32 {
    let y = r * r;
    let high = fma(y, 0.000002593088765934226, -0.00019803417671937495);
    let s = fma(r * y, fma(y, fma(y, high, 0.008332972414791584), -0.16666655242443085), r);
    return clamp(s, -1.0, 1.0);
}

/// cos(r) for |r| <= 2.6: a minimax polynomial (absolute error below 2e-9 beside rounding) that is
/// 1 at 0 and below that elsewhere.
fn cosine_low(r: f32) -> f32 {
    let y = r * r;
    let high = fma(y, fma(y, 1.8474174412475008e-9, -2.7357322096577263e-7),
        0.000024793636839604005);
    return fma(y, fma(y, fma(y, fma(y, high, -0.0013888741377741098), 0.041666656732559204), -0.5),
        1.0);
}

/// sin(x) and cos(x) for every x; beyond 100,000 rounding leaves nothing of the phase, and the
/// result lies in [-1, 1].
/// @where tier is balanced and |x| <= 1000 : vec2f(sin(x), cos(x)) ~ 5e-5
fn sin_cos_of(x: f32) -> vec2f {
    return clamp(sin_cos(bounded(x)), vec2f(-1.0), vec2f(1.0));
}

/// The angle of the point (x, y) from the x axis, in (-pi, pi]; 0 at the origin.
fn angle_of_point(y: f32, x: f32) -> f32 {
    // Coordinates are halved where they are large, so that the sum of both stays finite.
    let p = abs(bounded_vec2(vec2f(x, y)));
    let scaled = select(p, 0.5 * p, max(p.x, p.y) > 1.0);
    let a = atan2_positive(scaled.y, scaled.x);
    let turned = select(a, PI - a, x < 0.0);
    return select(turned, -turned, y < 0.0);
}
