//! Codecs of rows that are read and written in a way of their own.

use super::{Codec, DescribedObject, FieldType};
use crate::document::json::JsonWriter;
use crate::document::read::reader::{Fields, Reader};
use crate::document::word::WordChoice as _;
use crate::document::{ColorSpace, Tier, UnknownFields};

/// Codec of the value's type ([`FieldType`]).
pub(in crate::document) struct PlainCodec;

impl<T: FieldType> Codec<T> for PlainCodec {
    fn read(r: &mut Reader<'_>, fields: &mut Fields, name: &'static str) -> Option<T> {
        let mut extras = UnknownFields::new();
        let value = r.field(fields, name, |r, at, kind| T::read(r, at, kind, &mut extras));
        // A value that could not be read is not written either, and nor are the unknown fields
        // beside it.
        if value.is_some() {
            fields.shadow(name, extras);
        }
        value
    }

    fn write(w: &mut JsonWriter, value: &T, unknown: Option<&UnknownFields>) {
        value.write(w, unknown);
    }

    fn is_left_out(value: &T, default: &T, unknown: Option<&UnknownFields>) -> bool {
        value.is_left_out(default, unknown)
    }
}

/// Codec of an object whose fields lie among those of the object around it.
pub(in crate::document) struct FlatCodec;

impl<T: DescribedObject> Codec<T> for FlatCodec {
    fn read(r: &mut Reader<'_>, fields: &mut Fields, _name: &'static str) -> Option<T> {
        T::from_fields(r, fields)
    }

    fn write(w: &mut JsonWriter, value: &T, unknown: Option<&UnknownFields>) {
        value.write_members(w, unknown);
    }

    fn is_left_out(value: &T, default: &T, _unknown: Option<&UnknownFields>) -> bool {
        value.has_same_rows(default)
    }

    fn member(
        w: &mut JsonWriter,
        _name: &str,
        value: &T,
        _default: Option<&T>,
        unknown: Option<&UnknownFields>,
    ) {
        value.write_members(w, unknown);
    }
}

/// Codec of the document's color space, which decides how the colors after it are read.
pub(in crate::document) struct DocumentSpace;

impl Codec<ColorSpace> for DocumentSpace {
    fn read(r: &mut Reader<'_>, fields: &mut Fields, name: &'static str) -> Option<ColorSpace> {
        r.color_space = PlainCodec::read(r, fields, name).unwrap_or_default();
        Some(r.color_space)
    }

    fn write(w: &mut JsonWriter, value: &ColorSpace, unknown: Option<&UnknownFields>) {
        value.write(w, unknown);
    }

    fn is_left_out(
        value: &ColorSpace,
        default: &ColorSpace,
        _unknown: Option<&UnknownFields>,
    ) -> bool {
        value == default
    }
}

/// Words for the tier of a look: a tier, or none.
pub(in crate::document) const AUTOMATIC_OR_TIER: &[(&str, &str)] = &[
    ("automatic", "for each node exact or balanced, the cheaper whose difference nobody can see"),
    Tier::WORDS[0],
    Tier::WORDS[1],
    Tier::WORDS[2],
];

/// Codec of the tier of a look, where none is `automatic`.
pub(in crate::document) struct AutomaticTier;

impl Codec<Option<Tier>> for AutomaticTier {
    fn read(r: &mut Reader<'_>, fields: &mut Fields, name: &'static str) -> Option<Option<Tier>> {
        let word = r.field(fields, name, |r, at, _| r.word_at(at, AUTOMATIC_OR_TIER));
        word.map(|word| Tier::from_word(&word))
    }

    fn write(w: &mut JsonWriter, value: &Option<Tier>, _unknown: Option<&UnknownFields>) {
        w.string(value.map_or(AUTOMATIC_OR_TIER[0].0, Tier::word));
    }

    fn is_left_out(
        value: &Option<Tier>,
        default: &Option<Tier>,
        _unknown: Option<&UnknownFields>,
    ) -> bool {
        value == default
    }
}

/// Codec of a color of the look, with alpha or without, as its kind says.
pub(in crate::document) struct ColorCodec;

impl Codec<Vec<f64>> for ColorCodec {
    fn read(r: &mut Reader<'_>, fields: &mut Fields, name: &'static str) -> Option<Vec<f64>> {
        r.field(fields, name, |r, at, kind| r.color_at(at, kind.has_alpha()))
    }

    fn write(w: &mut JsonWriter, value: &Vec<f64>, _unknown: Option<&UnknownFields>) {
        w.numbers(value);
    }

    fn is_left_out(value: &Vec<f64>, default: &Vec<f64>, _unknown: Option<&UnknownFields>) -> bool {
        super::parts::same(value, default)
    }
}

/// Codec of a color of the canvas. Such a color is part of the editor and not of the picture, so
/// its numbers are always as shown.
pub(in crate::document) struct CanvasColor;

impl Codec<Vec<f64>> for CanvasColor {
    fn read(r: &mut Reader<'_>, fields: &mut Fields, name: &'static str) -> Option<Vec<f64>> {
        let space = std::mem::take(&mut r.color_space);
        let color = ColorCodec::read(r, fields, name);
        r.color_space = space;
        color
    }

    fn write(w: &mut JsonWriter, value: &Vec<f64>, unknown: Option<&UnknownFields>) {
        ColorCodec::write(w, value, unknown);
    }

    fn is_left_out(value: &Vec<f64>, default: &Vec<f64>, unknown: Option<&UnknownFields>) -> bool {
        ColorCodec::is_left_out(value, default, unknown)
    }
}
