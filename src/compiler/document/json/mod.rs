//! JSON with a place for every value: a parser that goes on after mistakes, and a writer of the
//! canonical form.
//!
//! A parsed text is a flat list of [`Item`]s in document order; each knows its span, its key's span
//! and where its subtree ends. Strings and numbers stay in the text until somebody asks, so 100,000
//! nodes cost a few megabytes.

mod parser;
mod scan;
#[cfg(test)]
mod tests;
mod tokens;
mod writer;

use std::borrow::Cow;
use std::sync::Arc;

#[cfg(test)]
use parser::MAX_DEPTH;
pub(super) use parser::{MAX_BYTES, parse};
pub(super) use writer::{Layout, Writer};

/// The index of a value in its [`Tree`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct At(u32);

impl At {
    /// Of the value in its tree.
    pub(super) fn index(self) -> u32 {
        self.0
    }
}

/// What a value is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Null,
    Bool(bool),
    Number,
    Text,
    List,
    Object,
    /// Something that is no JSON; the parser has said so.
    Bad,
}

impl Kind {
    /// As it is called in messages.
    pub(super) fn noun(self) -> &'static str {
        match self {
            Self::Null => "null",
            Self::Bool(true) => "`true`",
            Self::Bool(false) => "`false`",
            Self::Number => "a number",
            Self::Text => "a string",
            Self::List => "a list",
            Self::Object => "an object",
            Self::Bad => "something that is no JSON",
        }
    }
}

/// One value; spans are bytes of the text.
#[derive(Clone, Copy, Debug)]
struct Item {
    kind: Kind,
    /// Whether the file ended, or something else closed, before this list or object did.
    cut: bool,
    start: u32,
    end: u32,
    /// The item after this one's subtree.
    next: u32,
    key_start: u32,
    key_end: u32,
}

/// A parsed text.
#[derive(Clone, Debug)]
pub(super) struct Tree {
    text: Arc<str>,
    items: Vec<Item>,
    /// Whether the file ended in the middle, or so much was wrong that the parser gave up.
    pub(super) cut: bool,
}

impl Tree {
    /// The whole document; `None` where the text has no value at all.
    pub(super) fn root(&self) -> Option<At> {
        (!self.items.is_empty()).then_some(At(0))
    }

    pub(super) fn text(&self) -> &Arc<str> {
        &self.text
    }

    pub(super) fn kind(&self, at: At) -> Kind {
        self.item(at).kind
    }

    /// Where the value begins, in bytes.
    pub(super) fn start(&self, at: At) -> usize {
        self.item(at).start as usize
    }

    /// Where the member's name begins, or the value where it has none.
    pub(super) fn key_start(&self, at: At) -> usize {
        let item = self.item(at);
        if item.key_start == item.key_end { item.start as usize } else { item.key_start as usize }
    }

    /// Whether the end of this list or object is missing.
    pub(super) fn is_cut(&self, at: At) -> bool {
        self.item(at).cut
    }

    /// The name of a member of an object.
    pub(super) fn key(&self, at: At) -> Cow<'_, str> {
        let item = self.item(at);
        scan::unquote(&self.text[item.key_start as usize..item.key_end as usize])
    }

    /// The text of a string.
    pub(super) fn string(&self, at: At) -> Option<Cow<'_, str>> {
        (self.kind(at) == Kind::Text).then(|| scan::unquote(self.raw(at)))
    }

    /// A number; the parser lets no infinite one through.
    pub(super) fn number(&self, at: At) -> Option<f64> {
        (self.kind(at) == Kind::Number).then(|| self.raw(at).parse().ok()).flatten()
    }

    /// The items of a list or the members of an object, in document order.
    pub(super) fn children(&self, at: At) -> impl Iterator<Item = At> + '_ {
        let end = self.item(at).next;
        let within = move |child: u32| (child < end).then_some(child);
        std::iter::successors(within(at.0 + 1), move |&child| {
            within(self.items[child as usize].next)
        })
        .map(At)
    }

    /// The member of that name, if there is one.
    pub(super) fn member(&self, at: At, name: &str) -> Option<At> {
        (self.kind(at) == Kind::Object)
            .then(|| self.children(at).find(|&child| self.key(child) == name))
            .flatten()
    }

    /// The value with everything in it, as serde_json holds it; what is no JSON becomes null.
    ///
    /// Recursive, which is safe: the parser lets nothing through that is nested deeper than
    /// [`parser::MAX_DEPTH`].
    pub(super) fn to_json(&self, at: At) -> serde_json::Value {
        match self.kind(at) {
            Kind::Null | Kind::Bad => serde_json::Value::Null,
            Kind::Bool(value) => value.into(),
            Kind::Number => scan::json_number(self.raw(at)),
            Kind::Text => scan::unquote(self.raw(at)).into_owned().into(),
            Kind::List => self.children(at).map(|child| self.to_json(child)).collect(),
            Kind::Object => serde_json::Value::Object(
                self.children(at)
                    .map(|child| (self.key(child).into_owned(), self.to_json(child)))
                    .collect(),
            ),
        }
    }

    fn raw(&self, at: At) -> &str {
        let item = self.item(at);
        &self.text[item.start as usize..item.end as usize]
    }

    fn item(&self, at: At) -> &Item {
        &self.items[at.0 as usize]
    }
}
