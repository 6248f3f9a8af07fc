//! Writing documents in the canonical form: fields in a fixed order, defaults left out, and one
//! node, one wire, one light on each line, so that files compare and merge well.

use super::described::Described;
use super::json::{Layout, Writer};
use super::shape::Shape;
use super::source::SourceMap;
use super::{Look, Scene, Unknown, VERSION};

/// Methods that write a document. They belong to the types themselves, not to a trait, so that a
/// caller can write a document without importing anything.
macro_rules! written {
    ($document:ty) => {
        impl $document {
            /// Document as JSON in the canonical form, with a line end at its end.
            pub fn to_text(&self) -> String {
                self.write(Writer::new())
            }

            /// Document as [`to_text`](Self::to_text) writes it, but with numbers that are not
            /// finite written as NaN, which no reader takes.
            pub(super) fn to_trial_text(&self) -> String {
                self.write(Writer::trial())
            }

            /// Text that the document was read from, byte for byte, where the document is
            /// unchanged; else the canonical form.
            pub fn to_text_like(&self, source: &SourceMap) -> String {
                let own = self.to_text();
                let read = Self::read(source.text(), source.file()).value;
                if read.is_some_and(|read| read.to_text() == own) {
                    source.text().to_string()
                } else {
                    own
                }
            }

            fn write(&self, mut writer: Writer) -> String {
                document(&mut writer, self, &self.unknown);
                writer.finish()
            }
        }
    };
}

written!(Look);
written!(Scene);

/// Writes a document: its type first, then its fields.
fn document<T: Described>(w: &mut Writer, document: &T, unknown: &Unknown) {
    w.shaped(Layout::Lines, T::shape(), Some(unknown), |w| {
        if let Some(schema) = unknown.get("$schema") {
            w.member("$schema", |w| w.json(schema));
        }
        w.member("chiaro", |w| w.string(T::shape().name));
        w.member("version", |w| w.number(f64::from(VERSION)));
        document.write_members(w, Some(unknown));
    });
}

impl Writer {
    /// Writes an object whose unknown members come last.
    pub(super) fn shaped(
        &mut self,
        layout: Layout,
        shape: &'static Shape,
        unknown: Option<&Unknown>,
        write: impl FnOnce(&mut Self),
    ) {
        self.object(layout, |w| {
            write(w);
            w.unknown(shape, unknown);
        });
    }
}
