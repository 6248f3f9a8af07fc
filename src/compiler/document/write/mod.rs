//! Writing documents in the canonical form: fields in a fixed order, defaults left out, and one
//! node, one wire, one light on each line, so that files compare and merge well.

mod look;
mod scene;
mod value;

use std::path::Path;

use super::json::{Layout, Writer};
use super::shape::Shape;
use super::source::SourceMap;
use super::{Look, Scene, Unknown, VERSION, store};
use crate::diag::Diagnostic;

/// What every document can be written by. Methods of the types themselves, and no trait's, so that
/// whoever has a document can save it without importing anything.
macro_rules! written {
    ($document:ty, $write:path) => {
        impl $document {
            /// The document as JSON in the canonical form, with a line end at its end.
            pub fn to_text(&self) -> String {
                self.write(Writer::new())
            }

            /// As [`to_text`](Self::to_text), but numbers that are none are written as such, which
            /// no reader takes.
            pub(super) fn to_trial_text(&self) -> String {
                self.write(Writer::trial())
            }

            /// The text that the document was read from, byte for byte, where that says the same;
            /// else the canonical form.
            pub fn to_text_like(&self, source: &SourceMap) -> String {
                let own = self.to_text();
                let read = Self::read(source.text(), source.file()).value;
                if read.is_some_and(|read| read.to_text() == own) {
                    source.text().to_string()
                } else {
                    own
                }
            }

            /// Saves the document, whole or not at all; unchanged text stays as it is where
            /// `source` is what the document was read from.
            ///
            /// # Errors
            /// A diagnostic that says why the file could not be written; the old one is then as it
            /// was.
            pub fn save(
                &self,
                path: &Path,
                source: Option<&SourceMap>,
            ) -> Result<(), Box<Diagnostic>> {
                let text =
                    source.map_or_else(|| self.to_text(), |source| self.to_text_like(source));
                store::write_atomic(path, text.as_bytes())
            }

            fn write(&self, mut writer: Writer) -> String {
                $write(&mut writer, self);
                writer.finish()
            }
        }
    };
}

written!(Look, look::look);
written!(Scene, scene::scene);

/// What both documents begin with.
fn top(w: &mut Writer, chiaro: &str, unknown: &Unknown) {
    if let Some(schema) = unknown.get("$schema") {
        w.member("$schema", |w| w.json(schema));
    }
    w.member("chiaro", |w| w.string(chiaro));
    w.member("version", |w| w.number(f64::from(VERSION)));
}

/// The unknown fields of a part of a field; see [`Unknown`].
fn part<'u>(unknown: Option<&'u Unknown>, field: &str, part: Option<&str>) -> Option<&'u Unknown> {
    let of_field = unknown?.get(field)?.as_object()?;
    match part {
        Some(part) => of_field.get(part)?.as_object(),
        None => Some(of_field),
    }
}

impl Writer {
    /// A member that is not written where it is empty.
    fn text_unless_empty(&mut self, name: &str, text: &str) {
        if !text.is_empty() {
            self.member(name, |w| w.string(text));
        }
    }

    /// A member that is not written where it has its default.
    fn number_unless(&mut self, name: &str, number: f64, default: f64) {
        if !same(&[number], &[default]) {
            self.member(name, |w| w.number(number));
        }
    }

    /// A member that is not written where it has its default.
    fn numbers_unless(&mut self, name: &str, numbers: &[f64], default: &[f64]) {
        if !same(numbers, default) {
            self.member(name, |w| w.numbers(numbers));
        }
    }

    /// A member that is not written where it has its default.
    fn word_unless<T: super::word::Word>(&mut self, name: &str, choice: T, default: T) {
        if choice != default {
            self.member(name, |w| w.string(choice.word()));
        }
    }

    /// A member that is not written where it is unset.
    fn word_if<T: super::word::Word>(&mut self, name: &str, choice: Option<T>) {
        if let Some(choice) = choice {
            self.member(name, |w| w.string(choice.word()));
        }
    }

    /// An object whose unknown members come last.
    fn shaped(
        &mut self,
        layout: Layout,
        shape: &Shape,
        unknown: Option<&Unknown>,
        write: impl FnOnce(&mut Self),
    ) {
        self.object(layout, |w| {
            write(w);
            w.unknown(shape, unknown);
        });
    }

    /// A list member with one item on each line, not written where it is empty.
    fn lines<'a, T: 'a>(
        &mut self,
        name: &str,
        items: &'a [T],
        write: impl FnMut(&mut Self, &'a T),
    ) {
        if !items.is_empty() {
            self.member(name, |w| w.list(Layout::Lines, items, write));
        }
    }
}

/// Whether numbers are the same to the last bit, the sign of 0 included: it is written too.
fn same(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits())
}
