//! A JSON parser that tells every mistake and goes on behind it, so that an editor can open what is left.
//!
//! It keeps its own stack of open lists and objects, so nesting costs no call stack, and it stops at stated bounds.

use std::ops::Range;
use std::sync::Arc;

use super::scan::{escape, is_json_number, unquote};
use super::{Item, Kind, Tree};
use crate::diag::{Diagnostic, LineColumn};
use crate::document::source::{Lines, Problems, member_path};

/// The largest document, in bytes.
pub(in crate::document) const MAX_BYTES: usize = 64 << 20;
/// How many lists and objects may lie in each other.
pub(in crate::document) const MAX_DEPTH: usize = 64;
/// How many values a document may have, every number counted.
pub(in crate::document) const MAX_VALUES: usize = 8_000_000;
/// After this many mistakes of spelling the rest is not looked at.
const MAX_MISTAKES: usize = 100;

/// Parses a text; what is wrong goes to `problems`.
pub(in crate::document) fn parse(text: Arc<str>, lines: &Lines, problems: &mut Problems) -> Tree {
    let mut tree = Tree { text: text.clone(), items: Vec::new(), cut: true };
    if text.len() > MAX_BYTES {
        let mib = text.len().div_ceil(1 << 20);
        let message = format!("the file is {mib} MiB long; a document has at most {} MiB", MAX_BYTES >> 20);
        problems
            .push(0, Diagnostic::error("too-large", message).hint("keep big data in files that the document names"));
        return tree;
    }
    let mut parser =
        Parser { text: &text, lines, problems, at: 0, items: Vec::new(), open: Vec::new(), mistakes: 0, reading: None };
    let cut = !parser.document();
    tree.items = parser.items;
    tree.cut = cut;
    tree
}

/// A list or an object whose end is not seen yet.
struct Open {
    item: usize,
    is_object: bool,
    expects: Expects,
    /// How many items or members it has by now.
    count: usize,
}

/// What may come next in a list or an object, besides its end.
#[derive(Clone, Copy, PartialEq)]
enum Expects {
    First,
    Comma,
    /// There was a comma at this byte.
    AfterComma(usize),
}

struct Parser<'t> {
    text: &'t str,
    lines: &'t Lines,
    problems: &'t mut Problems,
    at: usize,
    items: Vec<Item>,
    open: Vec<Open>,
    mistakes: usize,
    /// The name of the member whose value is being read; empty in lists.
    reading: Option<Range<usize>>,
}

impl<'t> Parser<'t> {
    /// Parses everything; false where the end was not reached in good order.
    fn document(&mut self) -> bool {
        if self.text.starts_with('\u{feff}') {
            self.at = 3;
        }
        self.space();
        if self.peek().is_none() {
            self.problems.push(0, empty());
            return false;
        }
        let begin = &self.text[self.at..];
        if !begin.starts_with(|c: char| c.is_ascii_digit() || "{[\"-".contains(c))
            && !["true", "false", "null"].iter().any(|word| begin.starts_with(word))
        {
            self.problems.push(self.at, not_json(self.text, self.at));
            return false;
        }
        let is_string = self.peek() == Some(b'"');
        self.value(0..0);
        if is_string && self.items.iter().all(|item| item.kind == Kind::Bad) && self.mistakes == 0 {
            self.problem(self.at, Diagnostic::error("truncated", "the file ends in the middle of a string"));
        }
        while !self.open.is_empty() {
            if self.mistakes > MAX_MISTAKES {
                let message = format!("more than {MAX_MISTAKES} mistakes: the rest of the file is not looked at");
                self.problems.push(self.at, Diagnostic::error("too-many-mistakes", message));
            } else if self.items.len() > MAX_VALUES {
                let message = format!("the document has more than {MAX_VALUES} values");
                self.problems
                    .push(self.at, Diagnostic::error("too-many", message).hint("split it into several documents"));
            } else if self.step() {
                continue;
            }
            self.cut_all();
            return false;
        }
        self.space();
        if self.peek().is_some() {
            let problem = Diagnostic::error("syntax", "there is more text after the end of the document");
            self.problems.push(self.at, problem.hint("remove it; a file holds one document"));
        }
        true
    }

    /// One member, item, comma or end of what is open; false where nothing more can be read.
    fn step(&mut self) -> bool {
        self.space();
        let is_name_in_list = self.is_name_in_list();
        let Some(open) = self.open.last_mut() else { return true };
        let next = self.text.as_bytes().get(self.at).copied();
        match (next, open.expects) {
            (None, _) => {
                self.truncated();
                return false;
            }
            (Some(b'}' | b']'), _) => self.close(),
            (Some(b','), Expects::Comma) => {
                open.expects = Expects::AfterComma(self.at);
                self.at += 1;
            }
            (Some(b','), _) => {
                self.mistake(self.at, "there is a comma too many", "remove it");
                self.at += 1;
            }
            (Some(b':'), Expects::Comma) if is_name_in_list => return self.name_in_list(),
            (Some(_), Expects::Comma) if begins_value(next) => {
                open.expects = Expects::AfterComma(self.at);
                let end = self.text[..self.at].trim_end().len();
                self.mistake(end, "a comma is missing here", "write `,` between one item and the next");
            }
            (Some(_), Expects::Comma) => self.unexpected(),
            (Some(_), _) => return self.item(),
        }
        true
    }

    /// An item of a list, or a member of an object; false where nothing more can be read.
    fn item(&mut self) -> bool {
        let Some(open) = self.open.last_mut() else { return true };
        if !open.is_object {
            open.expects = Expects::Comma;
            return self.value(0..0);
        }
        let key_start = self.at;
        match self.text.as_bytes()[self.at] {
            b'"' | b'\'' => drop(self.string()),
            c if c.is_ascii_alphanumeric() || c == b'_' || c == b'$' => {
                let word = self.word();
                let hint = format!("write \"{word}\"");
                self.mistake(key_start, "the names of fields stand in double quotes", &hint);
            }
            _ => {
                self.unexpected();
                return true;
            }
        }
        self.member(key_start..self.at)
    }

    /// What follows the name of a member; false where nothing more can be read.
    fn member(&mut self, key: Range<usize>) -> bool {
        if let Some(open) = self.open.last_mut() {
            open.expects = Expects::Comma;
        }
        self.space();
        match self.peek() {
            None => return true,
            Some(b':') => self.at += 1,
            Some(b'=') => {
                self.mistake(self.at, "found `=` after the name of a field", "write `:`");
                self.at += 1;
            }
            Some(_) => {
                let name = short(&self.text[key.clone()]);
                self.mistake(self.at, &format!("{name} has no `:` and no value"), "write `\"name\": value`");
                if !begins_value(self.peek()) {
                    self.push(Kind::Bad, self.at, key);
                    return true;
                }
            }
        }
        self.space();
        if matches!(self.peek(), Some(b',' | b'}' | b']')) {
            let name = short(&self.text[key.clone()]);
            self.mistake(self.at, &format!("{name} has no value"), "write one, or remove the field");
            self.push(Kind::Bad, self.at, key);
            return true;
        }
        self.value(key)
    }

    /// Whether a list's last string is followed by `:`, so that it is the next name of the object around the list.
    fn is_name_in_list(&self) -> bool {
        let [.., around, list] = &self.open[..] else { return false };
        self.peek() == Some(b':')
            && around.is_object
            && !list.is_object
            && self
                .items
                .last()
                .is_some_and(|last| last.kind == Kind::Text && self.text[last.end as usize..self.at].trim().is_empty())
    }

    /// Closes a list that somebody forgot to close, and goes on with the member after it.
    fn name_in_list(&mut self) -> bool {
        let (Some(name), Some(list)) = (self.items.pop(), self.open.pop()) else { return false };
        let key = name.start as usize..name.end as usize;
        let from = self.lines.at(self.text, self.items[list.item].start as usize);
        let message = format!("the list opened at {} is not closed", line_column(from));
        self.mistake(key.start, &message, "write `]` before this");
        self.end_item(list.item, key.start, true);
        self.member(key)
    }

    /// A value; false where nesting is too deep to go on.
    fn value(&mut self, key: Range<usize>) -> bool {
        let start = self.at;
        if let Some(open) = self.open.last_mut() {
            open.count += 1;
        }
        self.reading = Some(key.clone());
        let kind = match self.peek() {
            Some(open @ (b'{' | b'[')) => return self.open(open == b'{', key),
            Some(b'"' | b'\'') => {
                let closed = self.string();
                if closed { Kind::Text } else { Kind::Bad }
            }
            Some(b'0'..=b'9' | b'-' | b'+' | b'.') => self.number(),
            Some(b'a'..=b'z' | b'A'..=b'Z' | b'_') => self.literal(),
            Some(_) => {
                self.unexpected();
                Kind::Bad
            }
            None => Kind::Bad,
        };
        self.push(kind, start, key);
        true
    }

    fn open(&mut self, is_object: bool, key: Range<usize>) -> bool {
        if self.open.len() >= MAX_DEPTH {
            let message = format!("lists and objects lie in each other more than {MAX_DEPTH} deep here");
            self.problem(self.at, Diagnostic::error("too-deep", message).hint("no field of a document needs this"));
            return false;
        }
        let item = self.items.len();
        let start = self.at;
        self.at += 1;
        self.push(if is_object { Kind::Object } else { Kind::List }, start, key);
        self.open.push(Open { item, is_object, expects: Expects::First, count: 0 });
        true
    }

    /// Ends a list or an object, and whatever was left open in it.
    fn close(&mut self) {
        let is_object = self.text.as_bytes()[self.at] == b'}';
        let Some(depth) = self.open.iter().rposition(|open| open.is_object == is_object) else {
            let found = &self.text[self.at..=self.at];
            self.mistake(self.at, &format!("there is a `{found}` that nothing has opened"), "remove it");
            self.at += 1;
            return;
        };
        while self.open.len() > depth {
            let open = self.open.pop().expect("deeper than `depth`");
            let cut = self.open.len() > depth;
            if cut {
                let (what, end) = if open.is_object { ("object", '}') } else { ("list", ']') };
                let from = self.lines.at(self.text, self.items[open.item].start as usize);
                let message = format!("the {what} opened at {} is not closed", line_column(from));
                self.mistake(self.at, &message, &format!("write `{end}` before this"));
            } else if let Expects::AfterComma(comma) = open.expects {
                self.mistake(comma, "there is a comma after the last item", "remove it");
            }
            self.end_item(open.item, self.at + usize::from(!cut), cut);
        }
        self.at += 1;
    }

    fn end_item(&mut self, item: usize, end: usize, cut: bool) {
        let next = self.items.len() as u32;
        let item = &mut self.items[item];
        item.end = end as u32;
        item.next = next;
        item.cut = cut;
    }

    fn cut_all(&mut self) {
        while let Some(open) = self.open.pop() {
            self.end_item(open.item, self.at, true);
        }
    }

    fn truncated(&mut self) {
        let Some(open) = self.open.last() else { return };
        let what = if open.is_object { "object" } else { "list" };
        let from = self.lines.at(self.text, self.items[open.item].start as usize);
        let message = format!("the file ends in the middle: the {what} opened at {} is not closed", line_column(from));
        let problem = Diagnostic::error("truncated", message);
        self.problem(self.at, problem.hint("take the whole file from where it came from, or close what is open"));
    }

    /// A string, quotes and all; false where its end is missing.
    fn string(&mut self) -> bool {
        let bytes = self.text.as_bytes();
        let start = self.at;
        let quote = bytes[start];
        if quote == b'\'' {
            self.mistake(start, "strings stand in double quotes", "write `\"` where there is `'`");
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
                        "the string is not closed on its line",
                        "write `\"` at its end, `\\n` for a new line",
                    );
                    return false;
                }
                0..0x20 if !has_control => {
                    has_control = true;
                    self.mistake(self.at, "there is a control character in the string", "write a tab as `\\t`");
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
            self.at = self.text.len(); // The file ends in it.
            return;
        }
        match rest.chars().next() {
            None => self.at += 1,
            Some('\n' | '\r') => self.at += 1,
            Some(c) => {
                let message = format!("`\\{c}` is no escape of JSON");
                self.mistake(self.at, &message, "write a backslash itself as `\\\\`; paths may use `/`");
                self.at += if c.is_ascii() && !c.is_ascii_control() { 1 + usize::from(c != '"') } else { 1 };
            }
        }
    }

    fn number(&mut self) -> Kind {
        let start = self.at;
        let end = self.text[start..].find(|c: char| !(c.is_ascii_alphanumeric() || "+-._".contains(c)));
        self.at = end.map_or(self.text.len(), |end| start + end);
        let text = &self.text[start..self.at];
        if self.at == self.text.len() && !self.open.is_empty() {
            return Kind::Bad; // Cut off, so nobody knows its last digits.
        }
        if !is_json_number(text) {
            if is_not_finite(text.trim_start_matches(['+', '-'])) {
                self.not_finite(start, text);
            } else {
                let hint = match text.parse::<f64>() {
                    Ok(number) if number.is_finite() => format!("write {}", super::scan::format_number(number)),
                    _ => "write numbers like 2, -0.5 or 1e-3".to_owned(),
                };
                self.mistake(start, &format!("`{}` is no number of JSON", short(text)), &hint);
            }
            return Kind::Bad;
        }
        if text.parse::<f64>().is_ok_and(f64::is_finite) {
            return Kind::Number;
        }
        self.not_finite(start, text);
        Kind::Bad
    }

    fn not_finite(&mut self, start: usize, text: &str) {
        let message = format!("`{}` is no finite number", short(text));
        self.problem(
            start,
            Diagnostic::error("not-finite", message).hint("write a number that is not beyond all bounds"),
        );
    }

    /// `true`, `false`, `null`, or a word that is none of them.
    fn literal(&mut self) -> Kind {
        let start = self.at;
        let word = self.word();
        let hint = match word {
            "true" => return Kind::Bool(true),
            "false" => return Kind::Bool(false),
            "null" => return Kind::Null,
            _ if self.at == self.text.len() && !self.open.is_empty() => return Kind::Bad, // Cut off.
            "True" | "TRUE" | "yes" | "on" => "write true".to_owned(),
            "False" | "FALSE" | "no" | "off" => "write false".to_owned(),
            "None" | "nil" | "undefined" | "NULL" | "Null" => "leave the field out, or write null".to_owned(),
            _ if is_not_finite(word) => {
                self.not_finite(start, word);
                return Kind::Bad;
            }
            _ => format!("strings stand in double quotes: \"{}\"", short(word)),
        };
        self.mistake(start, &format!("`{}` is no value of JSON", short(word)), &hint);
        Kind::Bad
    }

    /// Letters, digits and what joins them.
    fn word(&mut self) -> &'t str {
        let start = self.at;
        let end = self.text[start..].find(|c: char| !(c.is_alphanumeric() || "_-$.".contains(c)));
        self.at = end.map_or(self.text.len(), |end| start + end);
        &self.text[start..self.at]
    }

    /// Skips what cannot be understood, up to something that can.
    fn unexpected(&mut self) {
        let start = self.at;
        let rest = &self.text[start..];
        let first = rest.chars().next().map_or(0, char::len_utf8);
        let more =
            rest[first..].find(|c: char| c.is_whitespace() || "{}[],\"".contains(c)).unwrap_or(rest.len() - first);
        self.at += first + more;
        let message = format!("did not expect `{}` here", short(&self.text[start..self.at]));
        self.mistake(start, &message, "remove it");
    }

    /// White space; comments too, which are mistakes.
    fn space(&mut self) {
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
            self.mistake(self.at, "JSON has no comments", "remove it, or say it in a `name`, `title` or `help`");
            self.at += length;
        }
    }

    fn push(&mut self, kind: Kind, start: usize, key: Range<usize>) {
        self.reading = None;
        let next = self.items.len() as u32 + 1;
        let (start, end) = (start as u32, self.at as u32);
        let (key_start, key_end) = (key.start as u32, key.end as u32);
        self.items.push(Item { kind, cut: false, start, end, next, key_start, key_end });
    }

    fn mistake(&mut self, at: usize, message: &str, hint: &str) {
        self.mistakes += 1;
        if self.mistakes <= MAX_MISTAKES {
            self.problem(at, Diagnostic::error("syntax", message).hint(hint));
        }
    }

    /// Reports a problem with the value that is being read, or else with what is open.
    fn problem(&mut self, at: usize, problem: Diagnostic) {
        if !self.problems.takes(&problem) {
            self.problems.push(at, problem);
            return; // It is only counted.
        }
        let names = self.open.iter().skip(1).map(|open| {
            let item = &self.items[open.item];
            item.key_start as usize..item.key_end as usize
        });
        let counts = self.open.iter().map(|open| open.count);
        let mut path = String::new();
        for (name, count) in names.chain(self.reading.clone()).zip(counts) {
            path = match self.text.get(name).map(unquote).filter(|name| !name.is_empty()) {
                Some(name) => member_path(&path, &name),
                None => format!("{path}[{}]", count.max(1) - 1),
            };
        }
        self.problems.push(at, if path.is_empty() { problem } else { problem.json_path(path) });
    }

    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }
}

fn begins_value(c: Option<u8>) -> bool {
    c.is_some_and(|c| c.is_ascii_alphanumeric() || b"{[\"'+-._".contains(&c))
}

fn is_not_finite(word: &str) -> bool {
    ["nan", "inf", "infinity"].iter().any(|name| word.eq_ignore_ascii_case(name))
}

fn empty() -> Diagnostic {
    Diagnostic::error("empty-file", "the file is empty")
        .hint("`{}` is the shortest document; `chiaro new` writes a start")
}

fn not_json(text: &str, at: usize) -> Diagnostic {
    let begin: String = text[at..].chars().take(12).map(|c| if c.is_control() { ' ' } else { c }).collect();
    let message = format!("this is not JSON: it begins with `{}`", begin.trim_end());
    Diagnostic::error("not-json", message).hint("a document is JSON and begins with `{`")
}

/// The beginning of a text that may be long.
fn short(text: &str) -> String {
    let shown: String = text.chars().take(40).collect();
    if shown.len() < text.len() { shown + "…" } else { shown }
}

fn line_column(place: LineColumn) -> String {
    format!("line {}, column {}", place.line, place.column)
}
