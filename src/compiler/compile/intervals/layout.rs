//! The layout of naga's types in lists of scalars: every composite is its parts in order.

use naga::{ArraySize, Module, ScalarKind, TypeInner};

use super::range::{Bools, Floats, Ints, Range};

/// Greatest number of scalars of a value.
const MOST_SCALARS: usize = 1024;

/// The number of scalars of a type; `None` for a type that is no plain value.
pub(super) fn scalars_of(module: &Module, inner: &TypeInner) -> Option<usize> {
    let count = match inner {
        TypeInner::Scalar(_) => 1,
        TypeInner::Vector { size, .. } => *size as usize,
        TypeInner::Matrix { columns, rows, .. } => *columns as usize * *rows as usize,
        TypeInner::Array { base, size: ArraySize::Constant(count), .. } => {
            scalars_of(module, &module.types[*base].inner)?.checked_mul(count.get() as usize)?
        }
        TypeInner::Struct { members, .. } => {
            let sizes =
                members.iter().map(|member| scalars_of(module, &module.types[member.ty].inner));
            sizes.sum::<Option<usize>>()?
        }
        _ => return None,
    };
    (count <= MOST_SCALARS).then_some(count)
}

/// Anything of a type.
pub(super) fn tops_of(module: &Module, inner: &TypeInner) -> Option<Vec<Range>> {
    filled(module, inner, &|kind| match kind {
        ScalarKind::Float => Range::Float(Floats::ALL),
        ScalarKind::Sint => Range::Int(Ints::all(true)),
        ScalarKind::Uint => Range::Int(Ints::all(false)),
        _ => Range::Bool(Bools::ALL),
    })
}

/// The zero of a type.
pub(super) fn zeros_of(module: &Module, inner: &TypeInner) -> Option<Vec<Range>> {
    filled(module, inner, &|kind| match kind {
        ScalarKind::Float => Range::Float(Floats::ZERO),
        ScalarKind::Sint | ScalarKind::Uint => Range::Int(Ints::between(0, 0)),
        _ => Range::Bool(Bools::of(false)),
    })
}

fn filled(
    module: &Module,
    inner: &TypeInner,
    of: &dyn Fn(ScalarKind) -> Range,
) -> Option<Vec<Range>> {
    let count = scalars_of(module, inner)?;
    Some(match inner {
        TypeInner::Scalar(scalar)
        | TypeInner::Vector { scalar, .. }
        | TypeInner::Matrix { scalar, .. } => {
            vec![of(scalar.kind); count]
        }
        TypeInner::Array { base, .. } => {
            let one = filled(module, &module.types[*base].inner, of)?;
            one.iter().copied().cycle().take(count).collect()
        }
        TypeInner::Struct { members, .. } => {
            let parts =
                members.iter().map(|member| filled(module, &module.types[member.ty].inner, of));
            parts.collect::<Option<Vec<_>>>()?.concat()
        }
        _ => return None,
    })
}

/// First scalar of the part at `index`, and number of its scalars.
pub(super) fn part_of(module: &Module, inner: &TypeInner, index: usize) -> Option<(usize, usize)> {
    let (count, size) = parts_of(module, inner).unwrap_or((0, 0));
    match inner {
        TypeInner::Struct { members, .. } => {
            let size =
                |member: &naga::StructMember| scalars_of(module, &module.types[member.ty].inner);
            let start = members.get(..index)?.iter().map(size).sum::<Option<usize>>()?;
            Some((start, size(members.get(index)?)?))
        }
        _ => (index < count).then_some((index * size, size)),
    }
}

/// The number of equal parts of a type, and of the scalars in each.
pub(super) fn parts_of(module: &Module, inner: &TypeInner) -> Option<(usize, usize)> {
    match inner {
        TypeInner::Vector { size, .. } => Some((*size as usize, 1)),
        TypeInner::Matrix { columns, rows, .. } => Some((*columns as usize, *rows as usize)),
        TypeInner::Array { base, size: ArraySize::Constant(count), .. } => {
            Some((count.get() as usize, scalars_of(module, &module.types[*base].inner)?))
        }
        _ => None,
    }
}
