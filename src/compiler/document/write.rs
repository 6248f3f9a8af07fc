//! Writing documents in the canonical form: fields in a fixed order, defaults left out, and one
//! node, one wire, one light on each line, so that files compare and merge well.

use super::described::DescribedObject;
use super::json::{JsonLayout, JsonWriter};
use super::shape::ObjectShape;
use super::source::SourceMap;
use super::{HcbtfListing, HcbtfManifest, Look, Scene, Shot, UnknownFields, VERSION};

/// Methods that write a document. They belong to the types themselves, not to a trait, so that a
/// caller can write a document without importing anything.
macro_rules! written {
    ($document:ty) => {
        impl $document {
            /// Document as JSON in the canonical form, with a line end at its end.
            pub fn to_text(&self) -> String {
                self.write(JsonWriter::new())
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

            fn write(&self, mut writer: JsonWriter) -> String {
                document(&mut writer, self, &self.unknown);
                writer.finish()
            }
        }
    };
}

written!(Look);
written!(Scene);
written!(Shot);

/// Methods that write a document to see whether it can be read.
macro_rules! tried {
    ($document:ty) => {
        impl $document {
            /// Document as [`to_text`](Self::to_text) writes it, but with numbers that are not
            /// finite written as NaN, which no reader takes.
            pub(super) fn to_trial_text(&self) -> String {
                self.write(JsonWriter::trial())
            }
        }
    };
}

tried!(Look);
tried!(Scene);
tried!(Shot);

macro_rules! written_whole {
    ($document:ty) => {
        impl $document {
            /// Document as JSON in the canonical form, with a line end at its end.
            pub fn to_text(&self) -> String {
                let mut writer = JsonWriter::new();
                document(&mut writer, self, &self.unknown);
                writer.finish()
            }
        }
    };
}

written_whole!(HcbtfManifest);
written_whole!(HcbtfListing);

/// Writes a document: its type first, then its fields.
fn document<T: DescribedObject>(w: &mut JsonWriter, document: &T, unknown: &UnknownFields) {
    w.shaped(JsonLayout::Lines, T::shape(), Some(unknown), |w| {
        if let Some(schema) = unknown.get("$schema") {
            w.member("$schema", |w| w.json(schema));
        }
        w.member("chiaro", |w| w.string(T::shape().name));
        w.member("version", |w| w.number(f64::from(VERSION)));
        document.write_members(w, Some(unknown));
    });
}

impl JsonWriter {
    /// Writes an object whose unknown members come last.
    pub(super) fn shaped(
        &mut self,
        layout: JsonLayout,
        shape: &'static ObjectShape,
        unknown: Option<&UnknownFields>,
        write: impl FnOnce(&mut Self),
    ) {
        self.object(layout, |w| {
            write(w);
            w.unknown(shape, unknown);
        });
    }
}
