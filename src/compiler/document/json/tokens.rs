//! Tokens that the parser reads without regard to open lists and objects: strings, numbers, words,
//! white space, and unexpected text.

use chiaro_locale::tr;

use super::JsonKind;
use super::parser::{Parser, short};
use super::scan::{escape, format_number, is_json_number};
use crate::diag::Diagnostic;

impl<'t> Parser<'t> {
    /// Reads a string with its quotes; false where its end is missing.
    pub(super) fn string(&mut self) -> bool {
        let bytes = self.text.as_bytes();
        let start = self.at;
        let quote = bytes[start];
        if quote == b'\'' {
            self.mistake(
                start,
                tr!("strings stand in double quotes"),
                tr!("write `\"` where there is `'`"),
            );
        }
        self.at += 1;
        let mut has_control = false;
        while let Some(&c) = bytes.get(self.at) {
            match c {
                b'\\' => match escape(&self.text[self.at..]) {
                    Some((_, length)) => self.at += length,
                    None => self.bad_escape(),
                },
                b'\n' | b'\r' => {
                    self.mistake(
                        start,
                        tr!("the string is not closed on its line"),
                        tr!("write `\"` at its end, `\\n` for a new line"),
                    );
                    return false;
                }
                0..0x20 if !has_control => {
                    has_control = true;
                    self.mistake(
                        self.at,
                        tr!("there is a control character in the string"),
                        tr!("write a tab as `\\t`"),
                    );
                    self.at += 1;
                }
                _ if c == quote => {
                    self.at += 1;
                    return true;
                }
                _ => self.at += 1,
            }
        }
        false
    }

    fn bad_escape(&mut self) {
        let rest = &self.text[self.at + 1..];
        if rest.len() < "uD83D\\uDE00".len() && !rest.contains(['"', '\'', '\n']) {
            self.at = self.text.len(); // The file ends in the escape.
            return;
        }
        match rest.chars().next() {
            None => self.at += 1,
            Some('\n' | '\r') => self.at += 1,
            Some(c) => {
                let message = tr!("`\\{c}` is no escape of JSON");
                self.mistake(
                    self.at,
                    &message,
                    tr!("write a backslash itself as `\\\\`; paths may use `/`"),
                );
                self.at += if c.is_ascii() && !c.is_ascii_control() {
                    1 + usize::from(c != '"')
                } else {
                    1
                };
            }
        }
    }

    pub(super) fn number(&mut self) -> JsonKind {
        let start = self.at;
        let end =
            self.text[start..].find(|c: char| !(c.is_ascii_alphanumeric() || "+-._".contains(c)));
        self.at = end.map_or(self.text.len(), |end| start + end);
        let text = &self.text[start..self.at];
        if self.at == self.text.len() && self.is_inside() {
            return JsonKind::Bad; // The number is cut off.
        }
        if !is_json_number(text) {
            if is_not_finite(text.trim_start_matches(['+', '-'])) {
                self.not_finite(start, text);
            } else {
                let hint = match text.parse::<f64>() {
                    Ok(number) if number.is_finite() => {
                        tr!("write {number}", number = format_number(number))
                    }
                    _ => tr!("write numbers like 2, -0.5 or 1e-3").to_owned(),
                };
                self.mistake(
                    start,
                    &tr!("`{text}` is no number of JSON", text = short(text)),
                    &hint,
                );
            }
            return JsonKind::Bad;
        }
        if text.parse::<f64>().is_ok_and(f64::is_finite) {
            return JsonKind::Number;
        }
        self.not_finite(start, text);
        JsonKind::Bad
    }

    fn not_finite(&mut self, start: usize, text: &str) {
        let message = tr!("`{text}` is no finite number", text = short(text));
        self.problem(
            start,
            Diagnostic::error("not-finite", message)
                .hint(tr!("write a number that is not beyond all bounds")),
        );
    }

    /// Reads `true`, `false`, `null`, or any other word, which is a mistake.
    pub(super) fn literal(&mut self) -> JsonKind {
        let start = self.at;
        let word = self.word();
        let hint = match word {
            "true" => return JsonKind::Bool(true),
            "false" => return JsonKind::Bool(false),
            "null" => return JsonKind::Null,
            _ if self.at == self.text.len() && self.is_inside() => return JsonKind::Bad, // Cut off.
            "True" | "TRUE" | "yes" | "on" => tr!("write true").to_owned(),
            "False" | "FALSE" | "no" | "off" => tr!("write false").to_owned(),
            "None" | "nil" | "undefined" | "NULL" | "Null" => {
                tr!("leave the field out, or write null").to_owned()
            }
            _ if is_not_finite(word) => {
                self.not_finite(start, word);
                return JsonKind::Bad;
            }
            _ => tr!("strings stand in double quotes: \"{word}\"", word = short(word)),
        };
        self.mistake(start, &tr!("`{word}` is no value of JSON", word = short(word)), &hint);
        JsonKind::Bad
    }

    /// Reads a word: letters, digits and `_-$.`.
    pub(super) fn word(&mut self) -> &'t str {
        let start = self.at;
        let end = self.text[start..].find(|c: char| !(c.is_alphanumeric() || "_-$.".contains(c)));
        self.at = end.map_or(self.text.len(), |end| start + end);
        &self.text[start..self.at]
    }

    /// Skips text that cannot be understood, up to a token that can.
    pub(super) fn unexpected(&mut self) {
        let start = self.at;
        let rest = &self.text[start..];
        let first = rest.chars().next().map_or(0, char::len_utf8);
        let more = rest[first..]
            .find(|c: char| c.is_whitespace() || "{}[],\"".contains(c))
            .unwrap_or(rest.len() - first);
        self.at += first + more;
        let message =
            tr!("did not expect `{found}` here", found = short(&self.text[start..self.at]));
        self.mistake(start, &message, tr!("remove it"));
    }

    /// Skips white space; comments too, which are mistakes.
    pub(super) fn space(&mut self) {
        loop {
            let rest = &self.text[self.at..];
            self.at += rest.len() - rest.trim_start_matches([' ', '\t', '\n', '\r']).len();
            let rest = &self.text[self.at..];
            let length = if rest.starts_with("//") {
                rest.find('\n').unwrap_or(rest.len())
            } else if rest.starts_with("/*") {
                rest.find("*/").map_or(rest.len(), |end| end + 2)
            } else {
                return;
            };
            self.mistake(
                self.at,
                tr!("JSON has no comments"),
                tr!("remove it, or say it in a `name`, `title` or `help`"),
            );
            self.at += length;
        }
    }
}

fn is_not_finite(word: &str) -> bool {
    ["nan", "inf", "infinity"].iter().any(|name| word.eq_ignore_ascii_case(name))
}
