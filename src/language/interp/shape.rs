//! Shapes: types of arguments and results, and the layout of their values in slots.

use std::fmt;

use super::{Precision, Scalar, Value};

/// Type of a scalar.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ScalarKind {
    /// `bool`
    Bool,
    /// `i32`
    I32,
    /// `u32`
    U32,
    /// `f32` (or naga's `f64`)
    Float,
}

impl ScalarKind {
    /// WGSL name of the type.
    pub fn name(self) -> &'static str {
        match self {
            Self::Bool => "bool",
            Self::I32 => "i32",
            Self::U32 => "u32",
            Self::Float => "f32",
        }
    }

    pub(super) fn read(self, bits: u64) -> Scalar {
        match self {
            Self::Bool => Scalar::Bool(bits != 0),
            Self::I32 => Scalar::I32(bits as u32 as i32),
            Self::U32 => Scalar::U32(bits as u32),
            Self::Float => Scalar::Float(f64::from_bits(bits)),
        }
    }
}

/// Shape of a constructible type: the parts that a value of it is made of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Shape {
    /// One scalar.
    Scalar(ScalarKind),
    /// Two to four scalars.
    Vector {
        /// Kind of the scalars.
        kind: ScalarKind,
        /// Number of scalars, 2 to 4.
        size: usize,
    },
    /// A matrix of floats.
    Matrix {
        /// Number of columns, 2 to 4.
        columns: usize,
        /// Number of rows, 2 to 4.
        rows: usize,
    },
    /// An array of a fixed number of elements.
    Array {
        /// Shape of an element.
        element: Box<Shape>,
        /// Number of elements.
        count: usize,
    },
    /// A struct.
    Struct {
        /// Name in the source, or empty.
        name: String,
        /// Name and shape of each member.
        members: Vec<(String, Shape)>,
    },
}

impl fmt::Display for Shape {
    /// Writes the type as in WGSL.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Scalar(kind) => f.write_str(kind.name()),
            Self::Vector { kind, size } => write!(f, "vec{size}<{}>", kind.name()),
            Self::Matrix { columns, rows } => write!(f, "mat{columns}x{rows}<f32>"),
            Self::Array { element, count } => write!(f, "array<{element}, {count}>"),
            Self::Struct { name, .. } => f.write_str(name),
        }
    }
}

impl Shape {
    /// Number of scalars of a value.
    pub(super) fn slots(&self) -> u64 {
        match self {
            Self::Scalar(_) => 1,
            Self::Vector { size, .. } => *size as u64,
            Self::Matrix { columns, rows } => (columns * rows) as u64,
            Self::Array { element, count } => element.slots().saturating_mul(*count as u64),
            Self::Struct { members, .. } => members.iter().map(|(_, shape)| shape.slots()).sum(),
        }
    }

    /// Writes the scalars of `value` to `slots`, and returns the rest of the slots; `None` if the
    /// value has another shape. Recursion is as deep as the type, which the compiler bounds.
    pub(super) fn write<'s>(
        &self,
        value: &Value,
        precision: Precision,
        slots: &'s mut [u64],
    ) -> Option<&'s mut [u64]> {
        match (self, value) {
            (Self::Scalar(kind), value) => {
                write_scalars(*kind, &[value.as_scalar()?], precision, slots)
            }
            (Self::Vector { kind, size }, Value::Vector(scalars)) if scalars.len() == *size => {
                write_scalars(*kind, scalars, precision, slots)
            }
            (Self::Matrix { columns, rows }, Value::Matrix { columns: given, components })
                if given == columns && components.len() == columns * rows =>
            {
                let (own, rest) = slots.split_at_mut_checked(components.len())?;
                for (slot, &x) in own.iter_mut().zip(components) {
                    *slot = float_bits(x, precision);
                }
                Some(rest)
            }
            (Self::Array { element, count }, Value::Array(elements))
                if elements.len() == *count =>
            {
                elements
                    .iter()
                    .try_fold(slots, |slots, value| element.write(value, precision, slots))
            }
            (Self::Struct { members, .. }, Value::Struct(values))
                if values.len() == members.len() =>
            {
                let mut pairs = members.iter().zip(values);
                pairs.try_fold(slots, |slots, ((_, shape), value)| {
                    shape.write(value, precision, slots)
                })
            }
            _ => None,
        }
    }

    /// Value whose scalars are taken from `slots` in turn. There must be enough of them.
    pub(super) fn read(&self, slots: &mut impl Iterator<Item = u64>) -> Value {
        match self {
            Self::Scalar(kind) => kind.read(slots.next().unwrap_or(0)).into(),
            Self::Vector { kind, size } => {
                Value::Vector(slots.take(*size).map(|bits| kind.read(bits)).collect())
            }
            Self::Matrix { columns, rows } => Value::Matrix {
                columns: *columns,
                components: slots.take(columns * rows).map(f64::from_bits).collect(),
            },
            Self::Array { element, count } => {
                Value::Array((0..*count).map(|_| element.read(slots)).collect())
            }
            Self::Struct { members, .. } => {
                Value::Struct(members.iter().map(|(_, shape)| shape.read(slots)).collect())
            }
        }
    }
}

impl ScalarKind {
    /// Bits of a number of this kind: integers are truncated, and any number but 0 is true.
    pub(super) fn bits_of(self, x: f64, precision: Precision) -> u64 {
        match self {
            Self::Bool => u64::from(x != 0.0),
            Self::I32 => u64::from((x as i32).cast_unsigned()),
            Self::U32 => u64::from(x as u32),
            Self::Float => float_bits(x, precision),
        }
    }
}

fn write_scalars<'s>(
    kind: ScalarKind,
    scalars: &[Scalar],
    precision: Precision,
    slots: &'s mut [u64],
) -> Option<&'s mut [u64]> {
    let (own, rest) = slots.split_at_mut_checked(scalars.len())?;
    for (slot, &scalar) in own.iter_mut().zip(scalars) {
        if scalar.kind() != kind {
            return None;
        }
        *slot = match scalar {
            Scalar::Bool(x) => u64::from(x),
            Scalar::I32(x) => u64::from(x as u32),
            Scalar::U32(x) => u64::from(x),
            Scalar::Float(x) => float_bits(x, precision),
        };
    }
    Some(rest)
}

/// Bits of a float that enters a program.
fn float_bits(x: f64, precision: Precision) -> u64 {
    match precision {
        Precision::F64 => x.to_bits(),
        Precision::F32 => f64::from(x as f32).to_bits(),
    }
}
