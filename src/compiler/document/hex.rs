//! Colors in hexadecimal as people write them, with one digit a channel or two.

use std::borrow::Cow;

use super::color::parse_hex;

/// Parses `#rgb`, `#rgba`, `#rrggbb` or `#rrggbbaa`: RGBA with straight alpha from 0 to 1, as shown
/// (sRGB-encoded).
pub fn read_hex(text: &str) -> Option<[f64; 4]> {
    parse_hex(&long_hex(text))
}

/// Color of one digit a channel with two: `#88aaff` for `#8af`, as on web pages. Any other text
/// stays as it is.
pub fn long_hex(text: &str) -> Cow<'_, str> {
    let is_short = |digits: &&str| {
        matches!(digits.len(), 3 | 4) && digits.bytes().all(|digit| digit.is_ascii_hexdigit())
    };
    match text.strip_prefix('#').filter(is_short) {
        Some(digits) => {
            let twice = digits.chars().flat_map(|digit| [digit, digit]);
            Cow::Owned(std::iter::once('#').chain(twice).collect())
        }
        None => Cow::Borrowed(text),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_colors_are_those_with_both_digits() {
        for (short, long) in [("#8af", "#88aaff"), ("#F00", "#FF0000"), ("#1234", "#11223344")] {
            assert_eq!(long_hex(short), long);
            assert_eq!(read_hex(short), parse_hex(long), "{short}");
            assert!(read_hex(short).is_some() && read_hex(long) == parse_hex(long));
        }
        for text in ["#12", "#12345", "8af", "#8ag", "#", "", "#é1", "#1234567"] {
            assert_eq!(long_hex(text), text);
            assert_eq!(read_hex(text), None, "{text}");
        }
    }
}
