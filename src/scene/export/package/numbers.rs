//! Numbers of values, as text that shaders of 32 bits read.

use crate::interp::Value;

/// A number with a point, as f32 has it.
#[expect(clippy::cast_possible_truncation, reason = "shaders calculate with f32")]
pub(super) fn number(x: f64) -> String {
    let x = if x.is_nan() { 0.0 } else { x as f32 };
    format!("{:?}", x.clamp(f32::MIN, f32::MAX))
}

/// The numbers of a value in their order; none of arrays and structs.
pub(super) fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Bool(x) => vec![f64::from(u8::from(*x))],
        Value::I32(x) => vec![f64::from(*x)],
        Value::U32(x) => vec![f64::from(*x)],
        Value::Float(x) => vec![*x],
        Value::Vector(scalars) => scalars.iter().map(|scalar| scalar.as_f64()).collect(),
        Value::Matrix { components, .. } => components.clone(),
        Value::Array(_) | Value::Struct(_) => Vec::new(),
    }
}
