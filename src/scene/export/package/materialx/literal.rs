//! Numbers as GLSL and as MaterialX write them.

pub(super) use super::super::numbers::{number, numbers};
use crate::interp::Value;

/// A list of numbers.
pub(super) fn list(numbers: &[f64]) -> String {
    numbers.iter().map(|x| number(*x)).collect::<Vec<_>>().join(", ")
}

/// A value of a type in GLSL.
pub(super) fn glsl(ty: &str, value: &Value) -> String {
    match value {
        Value::Bool(x) => x.to_string(),
        Value::I32(x) => x.to_string(),
        Value::U32(x) => format!("{x}u"),
        Value::Float(x) => number(*x),
        _ => vector(ty, &numbers(value)),
    }
}

/// A vector or a matrix of a type in GLSL.
pub(super) fn vector(ty: &str, numbers: &[f64]) -> String {
    format!("{ty}({})", list(numbers))
}

/// A value of an input in MaterialX.
pub(super) fn materialx(value: &Value) -> String {
    match value {
        Value::Bool(x) => x.to_string(),
        Value::I32(x) => x.to_string(),
        _ => list(&numbers(value)),
    }
}
