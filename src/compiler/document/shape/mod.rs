//! What fields a document has, as [`described!`](super::described) tells the reader, the JSON Schemas
//! and docs/format.md.

mod schema;
mod tables;

pub use schema::{look_schema, scene_schema};
pub use tables::field_tables;

/// An object of a document.
pub(super) struct Shape {
    /// As messages and the schema call it, e.g. `light`.
    pub(super) name: &'static str,
    /// What it is, in a phrase.
    pub(super) help: &'static str,
    /// In the order in which they are written.
    pub(super) rows: &'static [Row],
}

/// A row of a [`Shape`].
pub(super) enum Row {
    /// A field.
    Field(Field),
    /// The fields of another object, which lie among those of this one.
    Flat(fn() -> &'static Shape),
}

/// A field of a [`Shape`].
pub(super) struct Field {
    pub(super) name: &'static str,
    pub(super) kind: Kind,
    pub(super) default: Default,
    /// What it is, with unit and space.
    pub(super) help: &'static str,
}

/// What holds where a field is left out.
pub(super) enum Default {
    /// It may not be left out.
    Required,
    /// This JSON.
    Json(fn() -> String),
    /// Told in words.
    Words(&'static str),
}

/// What a field takes.
pub(super) enum Kind {
    /// `true` or `false`.
    Bool,
    /// A number.
    Number(Bounds),
    /// As many numbers as this, from the first to the last count.
    Numbers(usize, usize, Bounds),
    /// Three numbers that are not all 0.
    Direction,
    /// RGB, or RGB with an optional alpha, or `#rrggbb`.
    Color { alpha: bool },
    /// RGBA, `#rrggbb` or null.
    Backdrop,
    /// A quaternion, a matrix, or an axis and an angle.
    Rotation,
    /// Any text of at most so many bytes.
    Text(usize),
    /// An id.
    Slug,
    /// One of some words, each with what it means.
    Word(&'static [(&'static str, &'static str)]),
    /// `node.port`; the port may be left out.
    Output,
    /// `node.port`.
    Input,
    /// `path/to/node.port` or `lights.light.field`.
    Target,
    /// `"view"` or `{"light": id}`.
    KeyDirection,
    /// The value of an input.
    Value,
    /// A path, or an object of paths by material.
    Looks,
    /// An object.
    Object(fn() -> &'static Shape),
    /// A list of at most so many.
    List(&'static Kind, usize),
    /// An object of at most so many, by id.
    Map(&'static Kind, usize),
    /// An object of values by target.
    TargetValues,
}

/// Between which numbers one lies.
#[derive(Clone, Copy)]
pub(super) struct Bounds {
    pub(super) min: f64,
    pub(super) max: f64,
    /// Whether `min` itself is left out.
    pub(super) above: bool,
    /// Whether it is a whole number.
    pub(super) whole: bool,
}

impl Bounds {
    /// From `min` to `max`, both included.
    pub(super) const fn new(min: f64, max: f64) -> Self {
        Self { min, max, above: false, whole: false }
    }

    /// Beyond `min` up to `max`.
    pub(super) const fn above(min: f64, max: f64) -> Self {
        Self { min, max, above: true, whole: false }
    }

    /// Whole numbers from `min` to `max`.
    pub(super) const fn whole(min: f64, max: f64) -> Self {
        Self { min, max, above: false, whole: true }
    }

    /// Whether a number keeps them.
    pub(super) fn hold(&self, number: f64) -> bool {
        let least = if self.above { number > self.min } else { number >= self.min };
        least && number <= self.max && (!self.whole || number.fract() == 0.0)
    }

    /// In words: `a number from 0 to 1000000`, or the only number there is.
    pub(super) fn say(&self) -> String {
        if self.min == self.max {
            return say_number(self.min);
        }
        let whole = if self.whole { "whole " } else { "" };
        let from = if self.above { "above" } else { "from" };
        format!("a {whole}number {from} {} to {}", say_number(self.min), say_number(self.max))
    }
}

/// A number, or its name where it has one.
pub(super) fn say_number(number: f64) -> String {
    if number == std::f64::consts::PI {
        "pi".to_owned()
    } else if number == f64::from(f32::MAX) {
        "3.4e38".to_owned()
    } else if number == -f64::from(f32::MAX) {
        "-3.4e38".to_owned()
    } else {
        format!("{number}")
    }
}

/// Lengths, colors and places: whatever is beyond is a mistake.
pub(super) const FAR: Bounds = Bounds::new(-1e6, 1e6);
/// Lengths and factors.
pub(super) const POSITIVE: Bounds = Bounds::new(0.0, 1e6);
/// What a shader's 32-bit numbers hold.
pub(super) const F32: Bounds = Bounds::new(-(f32::MAX as f64), f32::MAX as f64);
/// The versions of the format that are read.
pub(super) const FORMAT: Bounds = Bounds::whole(1.0, super::VERSION as f64);
/// A path, in bytes.
pub(super) const MAX_PATH: usize = 4096;
/// A line of text.
pub(super) const LINE: usize = 1000;
/// A longer text: help, WGSL source.
pub(super) const LONG: usize = 1 << 20;
/// Nodes of one graph.
pub(super) const MAX_NODES: usize = 200_000;
/// Wires of one graph.
pub(super) const MAX_WIRES: usize = 1_000_000;
/// The numbers of one value.
pub(super) const MAX_NUMBERS: usize = 16;

impl Kind {
    /// Whether a color may have an alpha.
    pub(super) fn has_alpha(&self) -> bool {
        matches!(self, Self::Color { alpha: true })
    }
}

impl Shape {
    /// The fields, in the order in which they are written.
    pub(super) fn fields(&'static self) -> impl Iterator<Item = &'static Field> + Clone {
        // Rows of flat objects are all fields.
        let rows = self.rows.iter().flat_map(|row| match row {
            Row::Field(_) => std::slice::from_ref(row),
            Row::Flat(shape) => shape().rows,
        });
        rows.filter_map(|row| if let Row::Field(field) = row { Some(field) } else { None })
    }

    /// The field of that name and its index.
    pub(super) fn field(&'static self, name: &str) -> Option<(usize, &'static Field)> {
        self.fields().enumerate().find(|(_, field)| field.name == name)
    }
}
