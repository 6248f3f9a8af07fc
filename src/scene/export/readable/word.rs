//! Words of program text.

use std::ops::Range;

/// A word: a name or a keyword.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::export) struct Word {
    /// Byte range of the word.
    pub(in crate::export) span: Range<usize>,
    /// True if the word follows a point, as the name of a member does.
    pub(in crate::export) is_member: bool,
}

/// The words of `text`, in order; numbers and line comments are passed over.
pub(in crate::export) fn words(text: &str) -> impl Iterator<Item = Word> {
    let bytes = text.as_bytes();
    let is_in_word = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_';
    let mut at = 0;
    let mut after_point = false;
    std::iter::from_fn(move || {
        while at < bytes.len() {
            let start = at;
            if bytes[at..].starts_with(b"//") {
                at = bytes[at..].iter().position(|&b| b == b'\n').map_or(bytes.len(), |n| at + n);
            } else if bytes[at].is_ascii_digit() {
                while at < bytes.len() && (is_in_word(bytes[at]) || bytes[at] == b'.') {
                    at += 1;
                }
                after_point = false;
            } else if is_in_word(bytes[at]) {
                while at < bytes.len() && is_in_word(bytes[at]) {
                    at += 1;
                }
                let is_member = std::mem::take(&mut after_point);
                return Some(Word { span: start..at, is_member });
            } else {
                after_point = bytes[at] == b'.' || (after_point && bytes[at] == b' ');
                at += 1;
            }
        }
        None
    })
}

/// True if `text` has the word `name` other than as a member.
pub(super) fn has_word(text: &str, name: &str) -> bool {
    words(text).any(|word| !word.is_member && &text[word.span] == name)
}

/// The text with other words in the place of those that `renamed` knows; members stay.
pub(in crate::export) fn replace_words(
    text: &str,
    renamed: impl Fn(&str) -> Option<String>,
) -> String {
    let mut result = String::with_capacity(text.len());
    let mut at = 0;
    for word in words(text).filter(|word| !word.is_member) {
        if let Some(name) = renamed(&text[word.span.clone()]) {
            result.push_str(&text[at..word.span.start]);
            result.push_str(&name);
            at = word.span.end;
        }
    }
    result.push_str(&text[at..]);
    result
}

/// Number in naga's name of a value without a name: 52 of `_e52`.
pub(super) fn baked_index(name: &str) -> Option<usize> {
    let digits = name.strip_prefix("_e")?;
    digits.bytes().all(|byte| byte.is_ascii_digit()).then(|| digits.parse().ok())?
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn members_and_numbers_are_no_names() {
        let text = "a.b = c_1 + 2.0e5 * 0x7fu - _e12.xy; // d\ne";
        let found: Vec<_> =
            words(text).filter(|word| !word.is_member).map(|word| &text[word.span]).collect();
        assert_eq!(found, ["a", "c_1", "_e12", "e"]);
        assert_eq!(
            replace_words(text, |word| (word == "b" || word == "_e12").then(|| "x".to_owned())),
            "a.b = c_1 + 2.0e5 * 0x7fu - x.xy; // d\ne"
        );
        assert_eq!(
            (baked_index("_e12"), baked_index("_ex"), baked_index("_e")),
            (Some(12), None, None)
        );
        assert!(has_word(text, "c_1") && !has_word(text, "c") && !has_word("λ.λ", "λ"));
    }
}
