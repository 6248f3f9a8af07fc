// The profile alpha(u) of BADF eq. 5 in the form of docs/math.md 2.3: no inverse trigonometry, no
// cancellation, and an exponent that may grow without bound.
import chiaro::types;
import chiaro::numeric;
import chiaro::angle;

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

/// alpha at one angle, without antialiasing; `u` is warped already.
fn profile_point(u: Angle, shape: ProfileShape) -> f32 {
    let s = u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset;
    if (s <= 0.0) | (shape.kind == PROFILE_AMBIENT) {
        return 1.0;
    }
    if shape.kind == PROFILE_STEP {
        // Inclusive (D4), also where rounding puts u = tau on the far side.
        return select(0.0, 1.0, s <= 4e-7);
    }
    let q = s * shape.scale;
    return profile_power(q, shape.exponent);
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

/// alpha averaged over a footprint of `w` radians (docs/math.md 2.4): the hard step where w is 0, a
/// ramp of the gradient's width where the edge is narrower than a pixel, three-point Gauss
/// quadrature where it is narrow, the point value where it is wide.
fn profile_filtered(u: Angle, w: f32, shape: ProfileShape) -> f32 {
    let point = profile_point(u, shape);
    let is_wide = w < 0.1 * shape.edge_deviation;
    if is_wide | (w <= 0.0) | (shape.kind == PROFILE_AMBIENT) {
        return point;
    }
    // No footprint is above 0.5, so that this branch is not even compiled for an edge that is known
    // to be softer.
    if (shape.edge_deviation < 0.145) & (w >= 3.46410161513775459 * shape.edge_deviation) {
        let width = sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
        return clamp(0.5 + (shape.offset + shape.edge_mean - angle_radians(u)) / width, 0.0, 1.0);
    }
    let reach = sin_cos_quarter(0.193649167310370844 * w);
    let before = profile_point(angle_turned(u, reach), shape);
    let after = profile_point(angle_turned(u, vec2f(-reach.x, reach.y)), shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

/// [`profile_power`] by the hardware's logarithm and exponential, but for a series where the
/// exponent would amplify their errors.
/// @where tier is balanced and |q| <= 1e18 and exponent >= 0.5 and exponent <= 16 :
///   pow(max(1.0 - q * q, 0.0), exponent) ~ 1e-5
fn profile_power_quick(q: f32, exponent: f32) -> f32 {
    let y = min(q * q, 1.0);
    let power = exp2(max(exponent * log2_one_minus(y), -126.0));
    return select(clamp(power, 0.0, 1.0), 0.0, q >= 1.0);
}

/// Sine and cosine of half the angle from tau to u.
fn profile_place(u: Angle, shape: ProfileShape) -> vec2f {
    return vec2f(
        u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset,
    );
}

/// alpha of a soft profile where the half-sine from tau is s.
fn profile_soft_quick(s: f32, shape: ProfileShape) -> f32 {
    return select(profile_power_quick(s * shape.scale, shape.exponent), 1.0, s <= 0.0);
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
fn profile_ramp_quick(s: f32, w: f32, shape: ProfileShape) -> f32 {
    let width = sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
    // 2 asin(s) by its series: the ramp is narrow.
    let from_offset = s * (2.0 + s * s * 0.333333333333333333);
    let ramp = clamp(0.5 + (shape.edge_mean - from_offset) / max(width, 1e-6), 0.0, 1.0);
    return select(ramp, select(0.0, 1.0, s <= 4e-7), w <= 0.0);
}

/// [`profile_filtered`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
fn profile_filtered_quick(u: Angle, w: f32, shape: ProfileShape) -> f32 {
    if shape.kind == PROFILE_AMBIENT {
        return 1.0;
    }
    let place = profile_place(u, shape);
    let is_narrow = (w > 0.0) & (w >= 3.46410161513775459 * shape.edge_deviation);
    if (shape.kind == PROFILE_STEP) | is_narrow {
        return profile_ramp_quick(place.x, w, shape);
    }
    let point = profile_soft_quick(place.x, shape);
    if w < 0.1 * shape.edge_deviation {
        return point;
    }
    // Half of the quadrature's reach is below 0.1.
    let r = 0.193649167310370844 * w;
    let turn = vec2f(r * (1.0 - 0.166666666666666667 * r * r), 1.0 - 0.5 * r * r);
    let before = profile_soft_quick(place.x * turn.y - place.y * turn.x, shape);
    let after = profile_soft_quick(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

/// alpha at u, with a ramp in place of edges that are narrower than a pixel, and no other filter.
/// Call it in uniform control flow.
fn profile_ramped(u: Angle, shape: ProfileShape) -> f32 {
    let s = profile_place(u, shape).x;
    let w = min(finite_or(2.0 * (abs(dpdx(s)) + abs(dpdy(s))), 0.5), 0.5);
    let is_soft = (w <= 0.0) | (w < 3.46410161513775459 * shape.edge_deviation);
    if (shape.kind == PROFILE_SOFT) & is_soft {
        return profile_soft_quick(s, shape);
    }
    return select(profile_ramp_quick(s, w, shape), 1.0, shape.kind == PROFILE_AMBIENT);
}
