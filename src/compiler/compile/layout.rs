//! The layout of values in buffers, read from naga's own layout of the generated types.

use crate::interp::{Scalar, Value};

/// Places of the numbers of a value.
#[derive(Clone, Debug)]
pub enum ValueLayout {
    /// A single number.
    Scalar,
    /// Two to four numbers in a row.
    Vector,
    /// Columns, `stride` bytes apart.
    Matrix {
        /// Numbers in a column.
        rows: u32,
        /// Bytes from column to column.
        stride: u32,
    },
    /// Elements, `stride` bytes apart.
    Array {
        /// Bytes from element to element.
        stride: u32,
        /// Each of them.
        element: Box<ValueLayout>,
    },
    /// Members, each at its byte.
    Struct(StructLayout),
}

/// The members of a struct.
#[derive(Clone, Debug, Default)]
pub struct StructLayout {
    /// Name, first byte and layout.
    pub members: Vec<(String, u32, ValueLayout)>,
    /// In bytes.
    pub size: u32,
}

impl StructLayout {
    /// The layout of a module's struct by name.
    pub fn of(module: &naga::Module, name: &str) -> Option<Self> {
        let (handle, _) = module.types.iter().find(|(_, ty)| ty.name.as_deref() == Some(name))?;
        match layout(module, handle) {
            ValueLayout::Struct(layout) => Some(layout),
            _ => None,
        }
    }

    /// A member's first byte and layout.
    pub fn member(&self, name: &str) -> Option<(u32, &ValueLayout)> {
        self.members.iter().find(|member| member.0 == name).map(|member| (member.1, &member.2))
    }
}

fn layout(module: &naga::Module, ty: naga::Handle<naga::Type>) -> ValueLayout {
    match &module.types[ty].inner {
        naga::TypeInner::Vector { .. } => ValueLayout::Vector,
        naga::TypeInner::Matrix { rows, .. } => {
            let rows = *rows as u32;
            ValueLayout::Matrix { rows, stride: if rows == 2 { 8 } else { 16 } }
        }
        naga::TypeInner::Array { base, stride, .. } => {
            ValueLayout::Array { stride: *stride, element: Box::new(layout(module, *base)) }
        }
        naga::TypeInner::Struct { members, span } => {
            let member = |m: &naga::StructMember| {
                (m.name.clone().unwrap_or_default(), m.offset, layout(module, m.ty))
            };
            ValueLayout::Struct(StructLayout {
                members: members.iter().map(member).collect(),
                size: *span,
            })
        }
        _ => ValueLayout::Scalar,
    }
}

impl ValueLayout {
    /// Writes `value` at byte `at`. Numbers become the nearest finite f32, and NaN becomes 0: a
    /// project's own node may give either.
    pub fn write(&self, value: &Value, at: usize, bytes: &mut [u8]) {
        match (self, value) {
            (Self::Scalar, value) => {
                if let Some(scalar) = value.as_scalar() {
                    write_scalar(scalar, at, bytes);
                }
            }
            (Self::Vector, Value::Vector(scalars)) => {
                for (i, scalar) in scalars.iter().enumerate() {
                    write_scalar(*scalar, at + 4 * i, bytes);
                }
            }
            (Self::Matrix { rows, stride }, Value::Matrix { components, .. }) => {
                for (i, component) in components.iter().enumerate() {
                    let (column, row) = (i / *rows as usize, i % *rows as usize);
                    write_scalar(
                        Scalar::Float(*component),
                        at + column * *stride as usize + 4 * row,
                        bytes,
                    );
                }
            }
            (Self::Array { stride, element }, Value::Array(parts)) => {
                for (i, part) in parts.iter().enumerate() {
                    element.write(part, at + i * *stride as usize, bytes);
                }
            }
            (Self::Struct(layout), Value::Struct(parts)) => {
                for ((_, offset, member), part) in layout.members.iter().zip(parts) {
                    member.write(part, at + *offset as usize, bytes);
                }
            }
            // The layout comes from the type that the value was made for.
            _ => {}
        }
    }
}

fn write_scalar(scalar: Scalar, at: usize, bytes: &mut [u8]) {
    let word = match scalar {
        Scalar::Bool(b) => u32::from(b).to_le_bytes(),
        Scalar::I32(i) => i.to_le_bytes(),
        Scalar::U32(u) => u.to_le_bytes(),
        Scalar::Float(x) => finite_f32(x).to_le_bytes(),
    };
    if let Some(place) = bytes.get_mut(at..at + 4) {
        place.copy_from_slice(&word);
    }
}

fn finite_f32(x: f64) -> f32 {
    if x.is_nan() { 0.0 } else { (x as f32).clamp(f32::MIN, f32::MAX) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::push_numbers;

    /// Numbers that fragments read from a uniform are finite, in f32 and in the reference's f64.
    #[test]
    fn uniforms_hold_finite_numbers_alone() {
        let value = Value::vec(&[f64::NAN, f64::INFINITY, -1e300, 0.25]);
        let mut bytes = [0_u8; 16];
        ValueLayout::Vector.write(&value, 0, &mut bytes);
        let singles: Vec<f32> =
            bytes.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect();
        assert_eq!(singles, [0.0, f32::MAX, f32::MIN, 0.25]);
        let mut numbers = Vec::new();
        push_numbers(&value, &mut numbers);
        assert_eq!(numbers, [0.0, f64::from(f32::MAX), f64::from(f32::MIN), 0.25]);
    }
}
