//! Numbers as GLSL and as MaterialX write them.

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
