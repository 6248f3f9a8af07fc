//! Strings and numbers in the syntax of JSON.

use std::borrow::Cow;

/// Text of a string literal, without its quotes; mistakes become U+FFFD. A bare word is taken as it
/// is.
pub(super) fn unquote(raw: &str) -> Cow<'_, str> {
    let Some(quote) = raw.chars().next().filter(|c| matches!(c, '"' | '\'')) else {
        return Cow::Borrowed(raw);
    };
    let inner = &raw[1..];
    let inner = inner.strip_suffix(quote).unwrap_or(inner);
    if !inner.contains('\\') {
        return Cow::Borrowed(inner);
    }
    let mut text = String::with_capacity(inner.len());
    let mut rest = inner;
    while let Some(backslash) = rest.find('\\') {
        text.push_str(&rest[..backslash]);
        let (c, length) = escape(&rest[backslash..]).unwrap_or((char::REPLACEMENT_CHARACTER, 1));
        text.push(c);
        rest = &rest[backslash + length..];
    }
    text.push_str(rest);
    Cow::Owned(text)
}

/// Character that an escape at the beginning of `text` stands for, and the escape's length in
/// bytes.
pub(super) fn escape(text: &str) -> Option<(char, usize)> {
    let c = match text.as_bytes().get(1)? {
        b'"' => '"',
        b'\\' => '\\',
        b'/' => '/',
        b'b' => '\u{8}',
        b'f' => '\u{c}',
        b'n' => '\n',
        b'r' => '\r',
        b't' => '\t',
        b'u' => return unicode_escape(text),
        _ => return None,
    };
    Some((c, 2))
}

/// Reads `\uXXXX`, or two of them that make a surrogate pair.
fn unicode_escape(text: &str) -> Option<(char, usize)> {
    let unit = |text: &str| {
        let digits = text.strip_prefix("\\u")?.get(..4)?;
        digits
            .bytes()
            .all(|b| b.is_ascii_hexdigit())
            .then(|| u32::from_str_radix(digits, 16).ok())
            .flatten()
    };
    let first = unit(text)?;
    if let Some(c) = char::from_u32(first) {
        return Some((c, 6));
    }
    let second = unit(text.get(6..)?)?;
    let is_pair = (0xD800..0xDC00).contains(&first) && (0xDC00..0xE000).contains(&second);
    let code = 0x10000 + ((first & 0x3FF) << 10) + (second & 0x3FF);
    is_pair.then(|| char::from_u32(code).map(|c| (c, 12))).flatten()
}

/// True for a number in the syntax of JSON: no leading `+`, `.` or `0`, digits on both sides of a
/// point.
pub(super) fn is_json_number(text: &str) -> bool {
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    let text = text.strip_prefix('-').unwrap_or(text);
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, Some(exponent)),
        None => (text, None),
    };
    let (whole, fraction) = match mantissa.split_once('.') {
        Some((whole, fraction)) => (whole, Some(fraction)),
        None => (mantissa, None),
    };
    digits(whole)
        && (whole.len() == 1 || !whole.starts_with('0'))
        && fraction.is_none_or(digits)
        && exponent
            .is_none_or(|exponent| digits(exponent.strip_prefix(['+', '-']).unwrap_or(exponent)))
}

/// Number as serde_json holds it: whole numbers of up to 64 bits stay whole.
pub(super) fn json_number(raw: &str) -> serde_json::Value {
    if raw != "-0" {
        if let Ok(whole) = raw.parse::<u64>() {
            return whole.into();
        }
        if let Ok(whole) = raw.parse::<i64>() {
            return whole.into();
        }
    }
    raw.parse::<f64>().unwrap_or(0.0).into()
}

/// Shortest text that reads back as the same number: `1`, `0.35`, `1e-7`.
pub(super) fn format_number(number: f64) -> String {
    let magnitude = number.abs();
    if magnitude == 0.0 || (1e-5..1e16).contains(&magnitude) {
        format!("{number}")
    } else {
        format!("{number:e}")
    }
}
