//! Inverse of a profile (docs/math.md 2).

use std::f64::consts::{LN_2, PI};

/// Offset from which a profile is ambient, in radians before pi.
const AMBIENT: f64 = 1e-5;

/// Angle at which a profile's tone has fallen to one half, or the edge of a hard one; in radians,
/// before any warp. `None` for an ambient profile, which never falls. Offset, fall-off and cut-off
/// are in radians, in any order.
pub fn terminator_angle(offset: f64, falloff: f64, cutoff: f64) -> Option<f64> {
    let number = |x: f64| if x.is_finite() { x } else { 0.0 };
    let offset = number(offset).clamp(0.0, PI);
    let cutoff = number(cutoff).clamp(offset, PI);
    let falloff = number(falloff).clamp(offset, cutoff);
    if offset >= PI - AMBIENT {
        return None;
    }
    let (c, f) = (cutoff - offset, falloff - offset);
    let (half_c, half_f) = ((0.5 * c).sin(), (0.5 * f).sin());
    if half_c <= 0.0 || half_f < 1e-9 {
        return Some(offset);
    }
    let exponent = if c - f <= 0.0 {
        1.0
    } else {
        let [sum, difference] = [0.5 * (c + f), 0.5 * (c - f)].map(f64::sin);
        (sum * sum + difference * difference) / f.sin().powi(2)
    };
    // (1 - q^2)^exponent = 1/2; the plain root of the power would lose a narrow profile's q.
    let q = (-(-LN_2 / exponent).exp_m1()).sqrt();
    Some(offset + 2.0 * (q * half_c).min(1.0).asin())
}
