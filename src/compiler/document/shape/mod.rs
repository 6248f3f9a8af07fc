//! Shapes of documents: the fields that [`described!`](super::described) gives to the reader, the
//! JSON Schemas and docs/format.md.

mod schema;
mod tables;

use chiaro_locale::tr;
pub use schema::{hcbtf_schema, look_schema, scene_schema, shot_schema};
pub use tables::field_tables;
pub(super) use tables::kind_words;

/// Shape of an object of a document.
pub(super) struct ObjectShape {
    /// Name of the object in messages and the schema, e.g. `light`.
    pub(super) name: &'static str,
    /// Description of the object, in a phrase.
    pub(super) help: &'static str,
    /// Rows, in the order in which they are written.
    pub(super) rows: &'static [ShapeRow],
}

/// Shape of a choice between objects, by a word in one of their fields.
pub(super) struct ChoiceShape {
    /// Name of the choice in messages, e.g. `rule`.
    pub(super) name: &'static str,
    /// Field that holds the word.
    pub(super) tag: &'static str,
    /// Description of the choice, in a phrase.
    pub(super) help: &'static str,
    /// Words, each with its meaning.
    pub(super) words: &'static [(&'static str, &'static str)],
    /// Shapes of the objects, in the order of the words.
    pub(super) objects: &'static [fn() -> &'static ObjectShape],
}

/// Row of a [`ObjectShape`].
pub(super) enum ShapeRow {
    /// Single field.
    Field(ShapeField),
    /// Fields of another object, which lie among those of this one.
    Flat(fn() -> &'static ObjectShape),
}

/// Field of a [`ObjectShape`].
pub(super) struct ShapeField {
    pub(super) name: &'static str,
    pub(super) kind: FieldKind,
    pub(super) default: FieldDefault,
    /// Description of the field, with unit and space.
    pub(super) help: &'static str,
}

/// Default of a field that is left out.
pub(super) enum FieldDefault {
    /// No default: the field may not be left out.
    Required,
    /// Default as JSON.
    Json(fn() -> String),
    /// Default described in words.
    Words(&'static str),
}

/// Kind of values that a field takes.
pub(super) enum FieldKind {
    /// `true` or `false`.
    Bool,
    /// Number within bounds.
    Number(NumberBounds),
    /// List of numbers within bounds: its least and greatest length.
    Numbers(usize, usize, NumberBounds),
    /// Direction: three numbers that are not all 0.
    Direction,
    /// Color: RGB, or RGB with an optional alpha, or `#rrggbb`.
    Color { alpha: bool },
    /// Backdrop: RGBA, `#rrggbb` or null.
    Backdrop,
    /// Rotation: a quaternion, a matrix, or an axis and an angle.
    Rotation,
    /// Any text of at most this many bytes.
    Text(usize),
    /// Id.
    Slug,
    /// Set of lights: an expression over ids, names and groups.
    LightSet,
    /// Set of objects: an expression over ids.
    ObjectSet,
    /// Choice of words, each with its meaning.
    Word(&'static [(&'static str, &'static str)]),
    /// Output `node.port`; the port may be left out.
    Output,
    /// Output `path/to/node.port`; the port may be left out.
    OutputInGroups,
    /// Input `node.port`.
    Input,
    /// Target `path/to/node.port` or `lights.light.field`.
    Target,
    /// Direction that decides between keys: `"view"` or `{"light": id}`, or drivers.
    KeyDirection,
    /// Frames per second: a whole number, or a fraction as a text.
    Rate,
    /// Value of an input.
    Value,
    /// Looks: a path, or an object of paths by material.
    Looks,
    /// Object with a shape.
    Object(fn() -> &'static ObjectShape),
    /// One of several objects, by a word in it.
    Choice(fn() -> &'static ChoiceShape),
    /// List of exactly two items.
    Pair(&'static FieldKind),
    /// List of at most this many items.
    List(&'static FieldKind, usize),
    /// Object of at most this many members, by id.
    Map(&'static FieldKind, usize),
    /// Object of values by target.
    TargetValues,
}

/// Bounds of a number.
#[derive(Clone, Copy)]
pub(super) struct NumberBounds {
    pub(super) min: f64,
    pub(super) max: f64,
    /// True if `min` itself is excluded.
    pub(super) above: bool,
    /// True for whole numbers only.
    pub(super) whole: bool,
}

impl NumberBounds {
    /// Bounds from `min` to `max`, both included.
    pub(super) const fn new(min: f64, max: f64) -> Self {
        Self { min, max, above: false, whole: false }
    }

    /// Bounds from `min`, excluded, up to `max`.
    pub(super) const fn above(min: f64, max: f64) -> Self {
        Self { min, max, above: true, whole: false }
    }

    /// Bounds of whole numbers from `min` to `max`.
    pub(super) const fn whole(min: f64, max: f64) -> Self {
        Self { min, max, above: false, whole: true }
    }

    /// True if a number lies within the bounds.
    pub(super) fn hold(&self, number: f64) -> bool {
        let least = if self.above { number > self.min } else { number >= self.min };
        least && number <= self.max && (!self.whole || number.fract() == 0.0)
    }

    /// Bounds in words: `a number from 0 to 1000000`, or the only number within them.
    pub(super) fn describe(&self) -> String {
        if self.min == self.max {
            return number_name(self.min);
        }
        let (min, max) = (number_name(self.min), number_name(self.max));
        match (self.whole, self.above) {
            (true, true) => tr!("a whole number above {min} to {max}"),
            (true, false) => tr!("a whole number from {min} to {max}"),
            (false, true) => tr!("a number above {min} to {max}"),
            (false, false) => tr!("a number from {min} to {max}"),
        }
    }
}

/// Text of a number, or its name where it has one.
pub(super) fn number_name(number: f64) -> String {
    use std::f64::consts::{PI, TAU};
    // Bounds of angles may be rounded up.
    let is_about = |angle: f64| (angle..=angle + 3e-5).contains(&number.abs());
    let sign = if number < 0.0 { "-" } else { "" };
    if is_about(PI) {
        format!("{sign}pi")
    } else if is_about(TAU) {
        format!("{sign}2 pi")
    } else if number == f64::from(f32::MAX) {
        "3.4e38".to_owned()
    } else if number == -f64::from(f32::MAX) {
        "-3.4e38".to_owned()
    } else {
        format!("{number}")
    }
}

/// Bounds of lengths, colors and positions: a number beyond is a mistake.
pub(super) const FAR: NumberBounds = NumberBounds::new(-1e6, 1e6);
/// Bounds of lengths and factors that are not negative.
pub(super) const POSITIVE: NumberBounds = NumberBounds::new(0.0, 1e6);
/// Bounds of a shader's 32-bit numbers.
pub(super) const F32: NumberBounds = NumberBounds::new(-(f32::MAX as f64), f32::MAX as f64);
/// Versions of the format that are read.
pub(super) const FORMAT: NumberBounds = NumberBounds::whole(1.0, super::VERSION as f64);
/// Greatest length of a path, in bytes.
pub(super) const MAX_PATH: usize = 4096;
/// Greatest length of a line of text, in bytes.
pub(super) const LINE: usize = 1000;
/// Greatest length of a longer text (help, WGSL source), in bytes.
pub(super) const LONG: usize = 1 << 20;
/// Greatest number of nodes of one graph.
pub(super) const MAX_NODES: usize = 200_000;
/// Greatest number of wires of one graph.
pub(super) const MAX_WIRES: usize = 1_000_000;
/// Greatest count of numbers in one value.
pub(super) const MAX_NUMBERS: usize = 16;

impl FieldKind {
    /// True for a color that may have an alpha.
    pub(super) fn has_alpha(&self) -> bool {
        matches!(self, Self::Color { alpha: true })
    }
}

impl ObjectShape {
    /// Fields, in the order in which they are written.
    pub(super) fn fields(&'static self) -> impl Iterator<Item = &'static ShapeField> + Clone {
        // Flat objects have fields only, so one level suffices.
        let rows = self.rows.iter().flat_map(|row| match row {
            ShapeRow::Field(_) => std::slice::from_ref(row),
            ShapeRow::Flat(shape) => shape().rows,
        });
        rows.filter_map(|row| if let ShapeRow::Field(field) = row { Some(field) } else { None })
    }

    /// Field with a name, and its index.
    pub(super) fn field(&'static self, name: &str) -> Option<(usize, &'static ShapeField)> {
        self.fields().enumerate().find(|(_, field)| field.name == name)
    }
}
