//! The curve of sRGB (IEC 61966-2-1), mirrored for negative numbers.

/// Linear light of an sRGB value.
pub fn to_linear(c: f64) -> f64 {
    let x = c.abs();
    c.signum() * if x <= 0.04045 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) }
}

/// sRGB value of linear light.
pub fn to_srgb(c: f64) -> f64 {
    let x = c.abs();
    c.signum() * if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 }
}
