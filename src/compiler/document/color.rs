//! Colors in documents, and conversions between color spaces.

use super::{ColorSpace, Value};

/// Parses `#rrggbb` or `#rrggbbaa`: RGBA with straight alpha from 0 to 1, as shown (sRGB-encoded).
pub fn parse_hex(text: &str) -> Option<[f64; 4]> {
    let digits = text.strip_prefix('#')?;
    if !matches!(digits.len(), 6 | 8) || !digits.bytes().all(|b| b.is_ascii_hexdigit()) {
        return None;
    }
    let mut color = [1.0; 4];
    for (channel, pair) in color.iter_mut().zip(digits.as_bytes().chunks(2)) {
        let pair = std::str::from_utf8(pair).ok()?;
        *channel = f64::from(u8::from_str_radix(pair, 16).ok()?) / 255.0;
    }
    Some(color)
}

/// Linear light of an sRGB-encoded channel (IEC 61966-2-1).
pub fn srgb_to_linear(encoded: f64) -> f64 {
    if encoded <= 0.04045 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
}

/// sRGB-encoded channel of linear light (IEC 61966-2-1).
pub fn linear_to_srgb(linear: f64) -> f64 {
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}

impl Value {
    /// Value as an RGBA color with straight alpha: three or four numbers as they stand, or
    /// `#rrggbb` or `#rrggbbaa` as shown. `None` for any other value. In a linear look,
    /// [`color_in`](Self::color_in) decodes the hexadecimal forms.
    pub fn color(&self) -> Option<[f64; 4]> {
        match self {
            Self::Vector(numbers) => match numbers[..] {
                [r, g, b] => Some([r, g, b, 1.0]),
                [r, g, b, a] => Some([r, g, b, a]),
                _ => None,
            },
            Self::Text(text) => parse_hex(text),
            _ => None,
        }
    }

    /// Value as an RGBA color with straight alpha in a look's color space: numbers are in that
    /// space already, `#rrggbb` is decoded where the space is linear.
    pub fn color_in(&self, space: ColorSpace) -> Option<[f64; 4]> {
        let color = self.color()?;
        let is_encoded = matches!(self, Self::Text(_)) && space == ColorSpace::Linear;
        let [r, g, b, a] = color;
        Some(if is_encoded {
            [srgb_to_linear(r), srgb_to_linear(g), srgb_to_linear(b), a]
        } else {
            color
        })
    }

    /// Value with its `#rrggbb` as numbers in linear light, where the look is linear; else
    /// unchanged.
    #[must_use]
    pub fn in_space(self, space: ColorSpace) -> Self {
        match (&self, space) {
            (Self::Text(_), ColorSpace::Linear) => {
                self.color_in(space).map_or(self, |color| Self::Vector(color.to_vec()))
            }
            _ => self,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hex_colors_are_read() {
        assert_eq!(parse_hex("#ff0080"), Some([1.0, 0.0, 128.0 / 255.0, 1.0]));
        assert_eq!(parse_hex("#00000000"), Some([0.0; 4]));
        for wrong in
            ["", "#", "ff0080", "#ff008", "#ff00800", "#gg0000", "#ffffffffff", "#é1234", "#+1+1+1"]
        {
            assert_eq!(parse_hex(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn hex_colors_are_decoded_in_linear_looks() {
        let gray = Value::Text("#808080".into());
        assert_eq!(gray.color_in(ColorSpace::Display).unwrap()[0], 128.0 / 255.0);
        // 0.21586 is sRGB's 128 in linear light, as tables of the standard give it.
        assert!((gray.color_in(ColorSpace::Linear).unwrap()[0] - 0.21586).abs() < 1e-5);
        assert_eq!(
            Value::Vector(vec![0.5; 3]).color_in(ColorSpace::Linear),
            Some([0.5, 0.5, 0.5, 1.0])
        );
    }
}
