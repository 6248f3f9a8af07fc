//! JSON with a place for every value: a parser that continues after mistakes, and a writer of the
//! canonical form.
//!
//! A parsed text is a flat list of [`Item`]s in document order; each has its span, its key's span
//! and the end of its subtree. Strings and numbers are decoded on demand, so that 100,000 nodes
//! cost a few megabytes.

mod parser;
mod scan;
#[cfg(test)]
mod tests;
mod tokens;
mod writer;

use std::borrow::Cow;
use std::sync::Arc;

use chiaro_locale::tr;
#[cfg(test)]
use parser::MAX_DEPTH;
pub(super) use parser::{MAX_BYTES, parse};
pub(super) use writer::{JsonLayout, JsonWriter};

/// Index of a value in its [`Tree`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct ValueIndex(u32);

impl ValueIndex {
    /// Index of the value in its tree.
    pub(super) fn index(self) -> u32 {
        self.0
    }
}

/// Type of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum JsonKind {
    Null,
    Bool(bool),
    Number,
    Text,
    List,
    Object,
    /// Invalid JSON, which the parser has reported.
    Bad,
}

impl JsonKind {
    /// Name of the type in messages.
    pub(super) fn noun(self) -> &'static str {
        match self {
            Self::Null => "null",
            Self::Bool(true) => "`true`",
            Self::Bool(false) => "`false`",
            Self::Number => tr!("a number"),
            Self::Text => tr!("a string"),
            Self::List => tr!("a list"),
            Self::Object => tr!("an object"),
            Self::Bad => tr!("something that is no JSON"),
        }
    }
}

/// Value of a parsed text; spans are in bytes of the text.
#[derive(Clone, Copy, Debug)]
struct Item {
    kind: JsonKind,
    /// True if the file ended, or another bracket closed, before this list or object did.
    cut: bool,
    start: u32,
    end: u32,
    /// Index of the item after this one's subtree.
    next: u32,
    key_start: u32,
    key_end: u32,
}

/// Parsed text.
#[derive(Clone, Debug)]
pub(super) struct Tree {
    text: Arc<str>,
    items: Vec<Item>,
    /// True if the file ended in the middle, or the parser gave up after too many mistakes.
    pub(super) cut: bool,
}

impl Tree {
    /// Value of the whole document; `None` where the text has no value at all.
    pub(super) fn root(&self) -> Option<ValueIndex> {
        (!self.items.is_empty()).then_some(ValueIndex(0))
    }

    pub(super) fn text(&self) -> &Arc<str> {
        &self.text
    }

    pub(super) fn kind(&self, at: ValueIndex) -> JsonKind {
        self.item(at).kind
    }

    /// Start of the value, in bytes.
    pub(super) fn start(&self, at: ValueIndex) -> usize {
        self.item(at).start as usize
    }

    /// Start of the member's name, or of the value where it has none, in bytes.
    pub(super) fn key_start(&self, at: ValueIndex) -> usize {
        let item = self.item(at);
        if item.key_start == item.key_end { item.start as usize } else { item.key_start as usize }
    }

    /// The text without the item of a list, or the member of an object, and its comma: what follows
    /// stands in its place, and all else is as it was.
    pub(super) fn without(&self, at: ValueIndex) -> String {
        let text = &*self.text;
        let (mut start, mut end) = (self.key_start(at), self.item(at).end as usize);
        let after = text[end..].trim_start();
        let before = text[..start].trim_end();
        if let Some(rest) = after.strip_prefix(',') {
            end = text.len() - rest.trim_start().len();
        } else {
            // The last one goes with the comma before it, if there is one.
            start = before.strip_suffix(',').map_or(before.len(), str::len);
            if !before.ends_with(',') {
                end = text.len() - after.len();
            }
        }
        [&text[..start], &text[end..]].concat()
    }

    /// True if the end of this list or object is missing.
    pub(super) fn is_cut(&self, at: ValueIndex) -> bool {
        self.item(at).cut
    }

    /// Name of a member of an object.
    pub(super) fn key(&self, at: ValueIndex) -> Cow<'_, str> {
        let item = self.item(at);
        scan::unquote(&self.text[item.key_start as usize..item.key_end as usize])
    }

    /// Text of a string; `None` for other types.
    pub(super) fn string(&self, at: ValueIndex) -> Option<Cow<'_, str>> {
        (self.kind(at) == JsonKind::Text).then(|| scan::unquote(self.raw(at)))
    }

    /// Number; `None` for other types. The parser refuses infinite numbers.
    pub(super) fn number(&self, at: ValueIndex) -> Option<f64> {
        (self.kind(at) == JsonKind::Number).then(|| self.raw(at).parse().ok()).flatten()
    }

    /// Items of a list or members of an object, in document order.
    pub(super) fn children(&self, at: ValueIndex) -> impl Iterator<Item = ValueIndex> + '_ {
        let end = self.item(at).next;
        let within = move |child: u32| (child < end).then_some(child);
        std::iter::successors(within(at.0 + 1), move |&child| {
            within(self.items[child as usize].next)
        })
        .map(ValueIndex)
    }

    /// Member of an object by name, if there is one.
    pub(super) fn member(&self, at: ValueIndex, name: &str) -> Option<ValueIndex> {
        (self.kind(at) == JsonKind::Object)
            .then(|| self.children(at).find(|&child| self.key(child) == name))
            .flatten()
    }

    /// Value with all its descendants, as serde_json holds it; invalid JSON becomes null.
    ///
    /// This method is recursive, which is safe: the parser admits no nesting deeper than
    /// [`parser::MAX_DEPTH`].
    pub(super) fn to_json(&self, at: ValueIndex) -> serde_json::Value {
        match self.kind(at) {
            JsonKind::Null | JsonKind::Bad => serde_json::Value::Null,
            JsonKind::Bool(value) => value.into(),
            JsonKind::Number => scan::json_number(self.raw(at)),
            JsonKind::Text => scan::unquote(self.raw(at)).into_owned().into(),
            JsonKind::List => self.children(at).map(|child| self.to_json(child)).collect(),
            JsonKind::Object => serde_json::Value::Object(
                self.children(at)
                    .map(|child| (self.key(child).into_owned(), self.to_json(child)))
                    .collect(),
            ),
        }
    }

    fn raw(&self, at: ValueIndex) -> &str {
        let item = self.item(at);
        &self.text[item.start as usize..item.end as usize]
    }

    fn item(&self, at: ValueIndex) -> &Item {
        &self.items[at.0 as usize]
    }
}
