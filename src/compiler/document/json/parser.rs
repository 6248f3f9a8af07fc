//! JSON parser that reports every mistake and continues behind it, so that an editor can open the
//! rest.
//!
//! The parser keeps its own stack of open lists and objects, so that nesting costs no call stack,
//! and stops at stated bounds.

use std::ops::Range;
use std::sync::Arc;

use chiaro_locale::{text, tr};

use super::scan::unquote;
use super::{Item, JsonKind, Tree};
use crate::diag::{Diagnostic, LineColumn};
use crate::document::problems::{LineIndex, Problems};
use crate::document::source::member_path;

/// Greatest size of a document, in bytes.
pub(in crate::document) const MAX_BYTES: usize = 64 << 20;
/// Greatest depth of nested lists and objects.
pub(in crate::document) const MAX_DEPTH: usize = 64;
/// Greatest number of values in a document, every number counted.
pub(in crate::document) const MAX_VALUES: usize = 8_000_000;
/// Number of syntax errors after which the rest is not read.
const MAX_MISTAKES: usize = 100;

/// Parses a text; its problems go to `problems`.
pub(in crate::document) fn parse(
    text: &Arc<str>,
    lines: &LineIndex,
    problems: &mut Problems,
) -> Tree {
    let mut tree = Tree { text: text.clone(), items: Vec::new(), cut: true };
    if text.len() > MAX_BYTES {
        let mib = text.len().div_ceil(1 << 20);
        let message = tr!(
            "the file is {mib} MiB long; a document has at most {most} MiB",
            most = MAX_BYTES >> 20
        );
        problems.push(
            0,
            Diagnostic::error("too-large", message)
                .hint(tr!("keep big data in files that the document names")),
        );
        return tree;
    }
    let mut parser = Parser {
        text,
        lines,
        problems,
        at: 0,
        items: Vec::new(),
        open: Vec::new(),
        mistakes: 0,
        reading: None,
    };
    let cut = !parser.document();
    tree.items = parser.items;
    tree.cut = cut;
    tree
}

/// List or object whose end is not read yet.
struct OpenContainer {
    item: usize,
    is_object: bool,
    expects: ExpectedToken,
    /// Number of items or members so far.
    count: usize,
}

/// Token that may come next in a list or an object, besides its end.
#[derive(Clone, Copy, PartialEq)]
enum ExpectedToken {
    First,
    Comma,
    /// Item after a comma at this byte.
    AfterComma(usize),
}

pub(super) struct Parser<'t> {
    pub(super) text: &'t str,
    lines: &'t LineIndex,
    problems: &'t mut Problems,
    pub(super) at: usize,
    items: Vec<Item>,
    open: Vec<OpenContainer>,
    mistakes: usize,
    /// Span of the name of the member whose value is being read; empty in lists.
    reading: Option<Range<usize>>,
}

impl<'t> Parser<'t> {
    /// Parses the whole text; false where the end was not reached in good order.
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
        if is_string
            && self.items.iter().all(|item| item.kind == JsonKind::Bad)
            && self.mistakes == 0
        {
            self.problem(
                self.at,
                Diagnostic::error("truncated", tr!("the file ends in the middle of a string")),
            );
        }
        while !self.open.is_empty() {
            if self.mistakes > MAX_MISTAKES {
                let message =
                    tr!("more than {MAX_MISTAKES} mistakes: the rest of the file is not looked at");
                self.problems.push(self.at, Diagnostic::error("too-many-mistakes", message));
            } else if self.items.len() > MAX_VALUES {
                let message = tr!("the document has more than {MAX_VALUES} values");
                self.problems.push(
                    self.at,
                    Diagnostic::error("too-many", message)
                        .hint(tr!("split it into several documents")),
                );
            } else if self.step() {
                continue;
            }
            self.cut_all();
            return false;
        }
        self.space();
        if self.peek().is_some() {
            let problem = Diagnostic::error(
                "syntax",
                tr!("there is more text after the end of the document"),
            );
            self.problems.push(self.at, problem.hint(tr!("remove it; a file holds one document")));
        }
        true
    }

    /// Parses one member, item, comma or end of the innermost open list or object; false where
    /// nothing more can be read.
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
            (Some(b','), ExpectedToken::Comma) => {
                open.expects = ExpectedToken::AfterComma(self.at);
                self.at += 1;
            }
            (Some(b','), _) => {
                self.mistake(self.at, tr!("there is a comma too many"), tr!("remove it"));
                self.at += 1;
            }
            (Some(b':'), ExpectedToken::Comma) if is_name_in_list => return self.name_in_list(),
            (Some(_), ExpectedToken::Comma) if begins_value(next) => {
                open.expects = ExpectedToken::AfterComma(self.at);
                let end = self.text[..self.at].trim_end().len();
                self.mistake(
                    end,
                    tr!("a comma is missing here"),
                    tr!("write `,` between one item and the next"),
                );
            }
            (Some(_), ExpectedToken::Comma) => self.unexpected(),
            (Some(_), _) => return self.item(),
        }
        true
    }

    /// Parses an item of a list, or a member of an object; false where nothing more can be read.
    fn item(&mut self) -> bool {
        let Some(open) = self.open.last_mut() else { return true };
        if !open.is_object {
            open.expects = ExpectedToken::Comma;
            return self.value(0..0);
        }
        let key_start = self.at;
        match self.text.as_bytes()[self.at] {
            b'"' | b'\'' => drop(self.string()),
            c if c.is_ascii_alphanumeric() || c == b'_' || c == b'$' => {
                let word = self.word();
                let hint = tr!("write \"{word}\"");
                self.mistake(key_start, tr!("the names of fields stand in double quotes"), &hint);
            }
            _ => {
                self.unexpected();
                return true;
            }
        }
        self.member(key_start..self.at)
    }

    /// Parses a member after its name; false where nothing more can be read.
    fn member(&mut self, key: Range<usize>) -> bool {
        if let Some(open) = self.open.last_mut() {
            open.expects = ExpectedToken::Comma;
        }
        self.space();
        match self.peek() {
            None => return true,
            Some(b':') => self.at += 1,
            Some(b'=') => {
                self.mistake(self.at, tr!("found `=` after the name of a field"), tr!("write `:`"));
                self.at += 1;
            }
            Some(_) => {
                let name = short(&self.text[key.clone()]);
                self.mistake(
                    self.at,
                    &tr!("{name} has no `:` and no value"),
                    tr!("write `\"name\": value`"),
                );
                if !begins_value(self.peek()) {
                    self.push(JsonKind::Bad, self.at, key);
                    return true;
                }
            }
        }
        self.space();
        if matches!(self.peek(), Some(b',' | b'}' | b']')) {
            let name = short(&self.text[key.clone()]);
            self.mistake(
                self.at,
                &tr!("{name} has no value"),
                tr!("write one, or remove the field"),
            );
            self.push(JsonKind::Bad, self.at, key);
            return true;
        }
        self.value(key)
    }

    /// True if a list's last string is followed by `:`, so that it is the next name of the object
    /// around the list.
    fn is_name_in_list(&self) -> bool {
        let [.., around, list] = &self.open[..] else { return false };
        self.peek() == Some(b':')
            && around.is_object
            && !list.is_object
            && self.items.last().is_some_and(|last| {
                last.kind == JsonKind::Text
                    && self.text[last.end as usize..self.at].trim().is_empty()
            })
    }

    /// Closes a list without a closing bracket, and goes on with the member after it.
    fn name_in_list(&mut self) -> bool {
        let (Some(name), Some(list)) = (self.items.pop(), self.open.pop()) else { return false };
        let key = name.start as usize..name.end as usize;
        let from = self.lines.at(self.text, self.items[list.item].start as usize);
        let message = tr!("the list opened at {place} is not closed", place = line_column(from));
        self.mistake(key.start, &message, tr!("write `]` before this"));
        self.end_item(list.item, key.start, true);
        self.member(key)
    }

    /// Parses a value; false where nesting is too deep to go on.
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
                if closed { JsonKind::Text } else { JsonKind::Bad }
            }
            Some(b'0'..=b'9' | b'-' | b'+' | b'.') => self.number(),
            Some(b'a'..=b'z' | b'A'..=b'Z' | b'_') => self.literal(),
            Some(_) => {
                self.unexpected();
                JsonKind::Bad
            }
            None => JsonKind::Bad,
        };
        self.push(kind, start, key);
        true
    }

    fn open(&mut self, is_object: bool, key: Range<usize>) -> bool {
        if self.open.len() >= MAX_DEPTH {
            let message =
                tr!("lists and objects lie in each other more than {MAX_DEPTH} deep here");
            self.problem(
                self.at,
                Diagnostic::error("too-deep", message)
                    .hint(tr!("no field of a document needs this")),
            );
            return false;
        }
        let item = self.items.len();
        let start = self.at;
        self.at += 1;
        self.push(if is_object { JsonKind::Object } else { JsonKind::List }, start, key);
        self.open.push(OpenContainer { item, is_object, expects: ExpectedToken::First, count: 0 });
        true
    }

    /// Ends a list or an object, and all that were left open in it.
    fn close(&mut self) {
        let is_object = self.text.as_bytes()[self.at] == b'}';
        let Some(depth) = self.open.iter().rposition(|open| open.is_object == is_object) else {
            let found = &self.text[self.at..=self.at];
            self.mistake(
                self.at,
                &tr!("there is a `{found}` that nothing has opened"),
                tr!("remove it"),
            );
            self.at += 1;
            return;
        };
        while self.open.len() > depth {
            let open = self.open.pop().expect("deeper than `depth`");
            let cut = self.open.len() > depth;
            if cut {
                let end = if open.is_object { '}' } else { ']' };
                let what = part_name(open.is_object);
                let from = self.lines.at(self.text, self.items[open.item].start as usize);
                let message =
                    tr!("the {what} opened at {place} is not closed", place = line_column(from));
                self.mistake(self.at, &message, &tr!("write `{end}` before this"));
            } else if let ExpectedToken::AfterComma(comma) = open.expects {
                self.mistake(comma, tr!("there is a comma after the last item"), tr!("remove it"));
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
        let what = part_name(open.is_object);
        let from = self.lines.at(self.text, self.items[open.item].start as usize);
        let message = tr!(
            "the file ends in the middle: the {what} opened at {place} is not closed",
            place = line_column(from)
        );
        let problem = Diagnostic::error("truncated", message);
        self.problem(
            self.at,
            problem.hint(tr!("take the whole file from where it came from, or close what is open")),
        );
    }

    fn push(&mut self, kind: JsonKind, start: usize, key: Range<usize>) {
        self.reading = None;
        let next = self.items.len() as u32 + 1;
        let (start, end) = (start as u32, self.at as u32);
        let (key_start, key_end) = (key.start as u32, key.end as u32);
        self.items.push(Item { kind, cut: false, start, end, next, key_start, key_end });
    }

    pub(super) fn mistake(&mut self, at: usize, message: &str, hint: &str) {
        self.mistakes += 1;
        if self.mistakes <= MAX_MISTAKES {
            self.problem(at, Diagnostic::error("syntax", message).hint(hint));
        }
    }

    /// Reports a problem with the value that is being read, or else with the innermost open list or
    /// object.
    pub(super) fn problem(&mut self, at: usize, problem: Diagnostic) {
        if !self.problems.takes(&problem) {
            self.problems.push(at, problem);
            return; // The problem is only counted.
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

    /// True while a list or an object is open.
    pub(super) fn is_inside(&self) -> bool {
        !self.open.is_empty()
    }

    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }
}

fn begins_value(c: Option<u8>) -> bool {
    c.is_some_and(|c| c.is_ascii_alphanumeric() || b"{[\"'+-._".contains(&c))
}

fn empty() -> Diagnostic {
    Diagnostic::error("empty-file", tr!("the file is empty"))
        .hint(text!("`{}` is the shortest document; `chiaro new` writes a start").tr())
}

fn not_json(text: &str, at: usize) -> Diagnostic {
    let begin: String =
        text[at..].chars().take(12).map(|c| if c.is_control() { ' ' } else { c }).collect();
    let message = tr!("this is not JSON: it begins with `{begin}`", begin = begin.trim_end());
    Diagnostic::error("not-json", message)
        .hint(text!("a document is JSON and begins with `{`").tr())
}

/// Beginning of a text that may be long.
pub(super) fn short(text: &str) -> String {
    let shown: String = text.chars().take(40).collect();
    if shown.len() < text.len() { shown + "…" } else { shown }
}

/// Name of an object or a list in messages.
fn part_name(is_object: bool) -> &'static str {
    if is_object { tr!("part" => "object") } else { tr!("part" => "list") }
}

fn line_column(place: LineColumn) -> String {
    tr!("line {line}, column {column}", line = place.line, column = place.column)
}
