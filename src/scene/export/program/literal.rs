//! Values as literals of WGSL.

use crate::interp::{Scalar, Value};
use crate::library::Type;

/// A number of f64 that WGSL reads as f32 and the translator at its full width.
pub(in crate::export) fn number(x: f64) -> String {
    let most = f64::from(f32::MAX);
    let x = if x.is_nan() { 0.0 } else { x.clamp(-most, most) };
    // The least numbers of f64 are no numbers of f32.
    let x = if x.abs() < 1e-37 { 0.0 } else { x };
    if x == most || x == -most {
        return format!("{}3.4028234e38", if x < 0.0 { "-" } else { "" });
    }
    format!("{x:?}")
}

/// A value of numbers; `None` for an array or a struct.
pub(in crate::export) fn literal(value: &Value) -> Option<String> {
    let list = |numbers: &[f64]| numbers.iter().map(|x| number(*x)).collect::<Vec<_>>().join(", ");
    Some(match value {
        Value::Bool(x) => x.to_string(),
        Value::I32(x) => format!("i32({x})"),
        Value::U32(x) => format!("{x}u"),
        Value::Float(x) => number(*x),
        Value::Vector(scalars) => {
            let is_float = scalars.iter().all(|scalar| matches!(scalar, Scalar::Float(_)));
            if !is_float {
                return None;
            }
            let numbers: Vec<f64> = scalars.iter().map(|scalar| scalar.as_f64()).collect();
            format!("vec{}f({})", numbers.len(), list(&numbers))
        }
        Value::Matrix { columns, components } => {
            let rows = components.len() / columns.max(&1);
            let column = |column: &[f64]| format!("vec{rows}f({})", list(column));
            let written: Vec<String> = components.chunks(rows.max(1)).map(column).collect();
            format!("mat{columns}x{rows}f({})", written.join(", "))
        }
        Value::Array(_) | Value::Struct(_) => return None,
    })
}

/// A vector of three numbers.
pub(in crate::export) fn vec3(v: [f64; 3]) -> String {
    format!("vec3f({}, {}, {})", number(v[0]), number(v[1]), number(v[2]))
}

/// True for types that settings hold: numbers, and what is made of them alone.
pub(super) fn is_numeric(ty: &Type) -> bool {
    ty.width().is_some() || *ty == Type::Mat3
}
