//! Brushes of painted light, and the goals that they set for pixels.

use crate::commands::LightBrush;
use crate::document::{linear_to_srgb, srgb_to_linear};

/// Settings of the brush.
#[derive(Clone, Debug)]
pub(super) struct Tools {
    pub(super) kind: LightBrush,
    /// Diameter of the brush, in heights of the picture.
    pub(super) size: f64,
    /// Hardness of the brush, 0 to 1.
    pub(super) hardness: f64,
    /// Change of lightness by a stroke of Light or Dark, as the eye sees it: from black to white is
    /// 1.
    pub(super) amount: f64,
    /// Straight RGB as shown.
    pub(super) color: [f64; 3],
}

/// Range of the brush's diameter, in heights of the picture.
pub(super) const SIZES: std::ops::RangeInclusive<f64> = 0.01..=1.0;

impl Default for Tools {
    fn default() -> Self {
        Self {
            kind: LightBrush::Light,
            size: 0.16,
            hardness: 0.5,
            amount: 0.2,
            color: [0.91, 0.64, 0.3],
        }
    }
}

impl Tools {
    /// Makes the brush larger or smaller.
    pub(super) fn resize(&mut self, is_larger: bool) {
        let factor = if is_larger { 1.2 } else { 1.0 / 1.2 };
        self.size = (self.size * factor).clamp(*SIZES.start(), *SIZES.end());
    }

    /// Radius of the brush, in pixels of a sketch of this height.
    pub(super) fn radius(&self, height: u32) -> f64 {
        (0.5 * self.size * f64::from(height)).max(0.5)
    }

    /// Goal for a pixel that the look shows as `shown` and that is seen, with the strokes so far,
    /// as `seen`; `None` to erase.
    pub(super) fn goal(&self, shown: [f64; 3], seen: [f64; 3]) -> Option<[f64; 3]> {
        match self.kind {
            LightBrush::Light => Some(lighter(seen, self.amount)),
            LightBrush::Dark => Some(lighter(seen, -self.amount)),
            LightBrush::Color => Some(self.color),
            LightBrush::Keep => Some(shown),
            LightBrush::Erase => None,
        }
    }
}

/// Relative luminance of linear RGB (Rec. 709).
fn luminance([r, g, b]: [f64; 3]) -> f64 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// Color as shown under more light, or under less for a negative `by`: the cube root of the
/// luminance, which roughly follows perceived lightness, changes by `by`. The hue stays; a color
/// too bright for its channels goes toward white instead.
pub(super) fn lighter(color: [f64; 3], by: f64) -> [f64; 3] {
    let linear = color.map(|x| srgb_to_linear(x.clamp(0.0, 1.0)));
    let before = luminance(linear);
    let after = (before.cbrt() + by).clamp(0.0, 1.0).powi(3);
    // Black has no hue.
    let scaled = if before > 1e-9 { linear.map(|x| x * after / before) } else { [after; 3] };
    let most = scaled.into_iter().fold(0.0, f64::max);
    let kept = if most > 1.0 { (1.0 - after) / (most - after).max(1e-12) } else { 1.0 };
    scaled.map(|x| linear_to_srgb((after + kept * (x - after)).clamp(0.0, 1.0)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lightness(color: [f64; 3]) -> f64 {
        luminance(color.map(srgb_to_linear)).cbrt()
    }

    #[test]
    fn lighter_is_lighter_by_so_much_and_dark_takes_it_back() {
        for color in
            [[0.5, 0.5, 0.5], [0.3, 0.2, 0.1], [0.16, 0.15, 0.2], [0.8, 0.3, 0.2], [0.1, 0.2, 0.9]]
        {
            let more = lighter(color, 0.2);
            assert!((lightness(more) - lightness(color) - 0.2).abs() < 1e-9, "{color:?}: {more:?}");
            assert!(more.iter().all(|x| (0.0..=1.0).contains(x)));
            let is_unclipped = more.iter().all(|x| *x < 1.0 - 1e-9);
            let back = lighter(more, -0.2);
            assert!(
                !is_unclipped || back.iter().zip(color).all(|(a, b)| (a - b).abs() < 1e-6),
                "{color:?}: {back:?}"
            );
        }
        assert!(
            lighter([0.9; 3], 0.5).iter().all(|x| (x - 1.0).abs() < 1e-9),
            "no lighter than white"
        );
        assert_eq!(lighter([0.1; 3], -1.0), [0.0; 3]);
        let [r, g, b] = lighter([0.0; 3], 0.3);
        assert!(r > 0.1 && r == g && g == b, "black has no hue to keep");
    }
}
