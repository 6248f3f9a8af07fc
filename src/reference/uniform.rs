//! Conversion of numbers to values of the shapes that shaders read.

use crate::interp::{Scalar, ScalarKind, Shape, Value};

/// A value of `shape` from its scalars in order, matrices by columns; missing scalars are 0.
pub(super) fn value(shape: &Shape, numbers: &mut impl Iterator<Item = f64>) -> Value {
    match shape {
        Shape::Scalar(kind) => scalar(*kind, numbers).into(),
        Shape::Vector { kind, size } => {
            Value::Vector((0..*size).map(|_| scalar(*kind, numbers)).collect())
        }
        Shape::Matrix { columns, rows } => {
            let components =
                (0..columns * rows).map(|_| numbers.next().unwrap_or_default()).collect();
            Value::Matrix { columns: *columns, components }
        }
        Shape::Array { element, count } => {
            Value::Array((0..*count).map(|_| value(element, numbers)).collect())
        }
        Shape::Struct { members, .. } => {
            Value::Struct(members.iter().map(|(_, member)| value(member, numbers)).collect())
        }
    }
}

fn scalar(kind: ScalarKind, numbers: &mut impl Iterator<Item = f64>) -> Scalar {
    let number = numbers.next().unwrap_or_default();
    match kind {
        ScalarKind::Bool => Scalar::Bool(number != 0.0),
        ScalarKind::I32 => Scalar::I32(number as i32),
        ScalarKind::U32 => Scalar::U32(number as u32),
        ScalarKind::Float => Scalar::Float(number),
    }
}
