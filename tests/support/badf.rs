//! The BADF model in f64, from the paper's formulas and docs/math.md's decisions, with inverse
//! trigonometry and powers: no formula has the form that the shaders use, so that the two can be
//! held against each other.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::paint::painted;
use glam::{DVec3, DVec4};

/// The number that a GPU holds for `x`: rounded to f32.
pub fn f32_of(x: f64) -> f64 {
    f64::from(x as f32)
}

/// A unit vector with its components rounded to f32.
pub fn held(v: DVec3) -> DVec3 {
    v.normalize().to_array().map(f32_of).into()
}

/// The angle between two vectors of any length.
pub fn angle(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}

/// The mirrored view, BADF 3.1: r = 2 (n.v) n - v.
pub fn mirrored(n: DVec3, v: DVec3) -> DVec3 {
    let (n, v) = (n.normalize(), v.normalize());
    2.0 * n.dot(v) * n - v
}

/// Offset, fall-off and cut-off put in order (D2), in radians.
pub fn sanitized([tau, f, c]: [f64; 3]) -> [f64; 3] {
    let tau = tau.clamp(0.0, PI);
    let c = c.clamp(tau, PI);
    [tau, f.clamp(tau, c), c]
}

/// alpha of BADF eq. 5 with eq. 10 and 11 to the letter, offsets absolute (reading B), after a warp
/// (D3).
pub fn alpha_by_the_letter(u: f64, shift: f64, parameters: [f64; 3]) -> f64 {
    limits(u, shift, parameters, |x, f, c| {
        let beta = -c.cos() / (1.0 - c.cos());
        let gamma = (1.0 - c.cos() * f.cos()) / f.sin().powi(2);
        (beta + (1.0 - beta) * x.cos()).max(0.0).powf(gamma)
    })
}

/// alpha without cancellation: cos x - cos c by half-angles, 1 - cos c cos f by squares of
/// half-angles, and the power by ln(1 + y).
pub fn alpha(u: f64, shift: f64, parameters: [f64; 3]) -> f64 {
    limits(u, shift, parameters, |x, f, c| {
        let q = (0.5 * x).sin() / (0.5 * c).sin();
        // 1 - cos c cos f = (1 - cos c) + cos c (1 - cos f). Near pi the same formula takes the
        // angles that are left to pi: a turn by pi changes the sign of both cosines.
        let (c_near, f_near) = if c < FRAC_PI_2 { (c, f) } else { (PI - c, PI - f) };
        let of_c = 2.0 * (0.5 * c_near).sin().powi(2);
        let of_f = 2.0 * (0.5 * f_near).sin().powi(2);
        let gamma = (of_c + c_near.cos() * of_f) / f_near.sin().powi(2);
        if q >= 1.0 { 0.0 } else { (gamma * (-q * q).ln_1p()).exp() }
    })
}

/// The limits of docs/math.md 2.2 around a formula for 0 < f' < c'.
fn limits(u: f64, shift: f64, parameters: [f64; 3], formula: impl Fn(f64, f64, f64) -> f64) -> f64 {
    let [tau, f, c] = sanitized(parameters);
    let x = (u - shift.clamp(-PI, PI)).clamp(0.0, PI) - tau;
    let (f, c) = (f - tau, c - tau);
    if x <= 0.0 || tau >= PI - 1e-5 {
        1.0
    } else if c <= 0.0 || f <= 0.0 {
        0.0
    } else if f == c {
        // gamma = 1, also at the corner f' = c' = pi (D5).
        ((x.cos() - c.cos()) / (1.0 - c.cos())).max(0.0)
    } else {
        formula(x, f, c)
    }
}

/// lambda of BADF eq. 7, with kappa made finite (D6).
pub fn lambda(kappa: f64, slope: f64) -> f64 {
    let kappa = if kappa.is_nan() { 0.0 } else { kappa.clamp(-1e4, 1e4) };
    0.5 + 0.5 * (kappa * slope).tanh()
}

/// The warp T of BADF eq. 8.
pub fn warp(lambda: f64, amount: f64) -> f64 {
    (2.0 * lambda - 1.0) * amount.clamp(-PI, PI)
}

/// The blends of BADF eq. 2 as D8 reads them, and the masked multiply `shade`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mode {
    /// Sum of the backdrop and the layer.
    Add,
    /// Product of the backdrop and the layer.
    Multiply,
    /// Difference: the backdrop less the layer.
    Subtract,
    /// The layer over the backdrop.
    Alpha,
    /// Product of the backdrop and the layer, by the layer's mask.
    Shade,
    /// Mode of paint programs, by its word.
    Painted(&'static str),
}

impl Mode {
    /// Every blend of stacks of light.
    pub const ALL: [Self; 5] =
        [Self::Add, Self::Multiply, Self::Subtract, Self::Alpha, Self::Shade];

    /// Every mode of paint programs that is not among those.
    pub const PAINTED: [Self; 14] = [
        Self::Painted("screen"),
        Self::Painted("overlay"),
        Self::Painted("darken"),
        Self::Painted("lighten"),
        Self::Painted("soft_light"),
        Self::Painted("hard_light"),
        Self::Painted("color_dodge"),
        Self::Painted("color_burn"),
        Self::Painted("difference"),
        Self::Painted("exclusion"),
        Self::Painted("hue"),
        Self::Painted("saturation"),
        Self::Painted("color"),
        Self::Painted("luminosity"),
    ];

    /// The blend's word in documents.
    pub fn word(self) -> &'static str {
        match self {
            Self::Add => "add",
            Self::Multiply => "multiply",
            Self::Subtract => "subtract",
            Self::Alpha => "alpha",
            Self::Shade => "shade",
            Self::Painted(word) => word,
        }
    }
}

/// A straight layer color laid over a premultiplied backdrop. Shares count from 0 to 1: opacity,
/// alpha, and the tone where it is a mask.
pub fn blend(
    mode: Mode,
    below: DVec4,
    color: DVec4,
    rho: f64,
    opacity: f64,
    clamped: bool,
) -> DVec4 {
    let a = color.w.clamp(0.0, 1.0) * opacity.clamp(0.0, 1.0);
    let is_mask = !matches!(mode, Mode::Add | Mode::Multiply | Mode::Subtract);
    let rho = if is_mask { rho.clamp(0.0, 1.0) } else { rho };
    if a <= 0.0 {
        return below;
    }
    let (under, over) = (below.truncate(), color.truncate());
    let full = match mode {
        Mode::Add => under + rho * over,
        Mode::Subtract => under - rho * over,
        Mode::Multiply => under * rho * over,
        Mode::Alpha => under + rho * (over - under),
        Mode::Shade => under * ((1.0 - rho) * DVec3::ONE + rho * over),
        Mode::Painted(word) => {
            // Section 5 with the layer's alpha 1: co = (1 - αb) Cs + αb B(Cb, Cs).
            let mixed = painted(word, straight(below).truncate().to_array(), over.to_array());
            let paint = (1.0 - below.w) * over + below.w * DVec3::from_array(mixed);
            (1.0 - rho) * under + rho * paint
        }
    };
    let alpha = if matches!(mode, Mode::Alpha | Mode::Painted(_)) {
        below.w + rho * a * (1.0 - below.w)
    } else {
        below.w
    };
    let result = (under + a * (full - under)).extend(alpha);
    if clamped { result.clamp(DVec4::ZERO, DVec4::ONE) } else { result }
}

/// Premultiplied color of a straight one.
pub fn premultiplied(c: DVec4) -> DVec4 {
    let share = c.w.clamp(0.0, 1.0);
    (c.truncate() * share).extend(share)
}

/// Straight color of a premultiplied one; light over nothing is kept.
pub fn straight(c: DVec4) -> DVec4 {
    if c.w > 0.0 { (c.truncate() / c.w).extend(c.w) } else { c }
}
