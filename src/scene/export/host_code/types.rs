//! Types of naga as host code knows them.

use naga::{ArraySize, Handle, Module, Scalar, ScalarKind, Type, TypeInner};

use super::dialect::{Kind, ValueType};

/// The type; `None` for one that host code has no values of.
pub(super) fn value_type(module: &Module, inner: &TypeInner) -> Option<ValueType> {
    Some(match *inner {
        TypeInner::Scalar(scalar) => ValueType::Scalar(kind(scalar)?),
        TypeInner::Vector { size, scalar } => ValueType::Vector(size as usize, kind(scalar)?),
        TypeInner::Matrix { columns, rows, .. } => {
            ValueType::Matrix(columns as usize, rows as usize)
        }
        TypeInner::Array { base, size: ArraySize::Constant(count), .. } => {
            ValueType::Array(count.get() as usize, Box::new(of(module, base)?))
        }
        TypeInner::Pointer { base, .. } => of(module, base)?,
        TypeInner::ValuePointer { size: Some(size), scalar, .. } => {
            ValueType::Vector(size as usize, kind(scalar)?)
        }
        TypeInner::ValuePointer { size: None, scalar, .. } => ValueType::Scalar(kind(scalar)?),
        _ => return None,
    })
}

/// The type of that handle.
pub(super) fn of(module: &Module, ty: Handle<Type>) -> Option<ValueType> {
    match &module.types[ty] {
        Type { name: Some(name), inner: TypeInner::Struct { .. } } => {
            Some(ValueType::Struct(name.clone()))
        }
        Type { inner, .. } => value_type(module, inner),
    }
}

/// The members of a struct: names and types.
pub(super) fn members(module: &Module, ty: Handle<Type>) -> Option<Vec<(String, ValueType)>> {
    let TypeInner::Struct { members, .. } = &module.types[ty].inner else { return None };
    members.iter().map(|member| Some((member.name.clone()?, of(module, member.ty)?))).collect()
}

pub(super) fn kind(scalar: Scalar) -> Option<Kind> {
    Some(match scalar.kind {
        ScalarKind::Float | ScalarKind::AbstractFloat => Kind::Float,
        ScalarKind::Sint | ScalarKind::AbstractInt => Kind::Signed,
        ScalarKind::Uint => Kind::Unsigned,
        ScalarKind::Bool => Kind::Bool,
    })
}
