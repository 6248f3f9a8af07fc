//! Layouts: the number of slots of each type, and its parts.

use chiaro_locale::tr;
use naga::{ArraySize, Handle, Module, Scalar, ScalarKind as Kind, Type, TypeInner, UniqueArena};

use super::assembler::MAX_SLOTS;
use crate::diag::Diagnostic;
use crate::interp::{ScalarKind, Shape};

/// Greatest nesting of types.
const MAX_DEPTH: u32 = 64;

/// Reason why a type cannot be used.
#[derive(Clone, Copy, Debug)]
pub(super) enum LayoutProblem {
    /// Type, here named, of which the interpreter has no values.
    Unsupported(&'static str),
    /// Type with too many scalars, or nested too deeply.
    TooBig,
}

impl LayoutProblem {
    /// Diagnostic of the problem; `subject` names the value that has the type.
    pub(super) fn diagnose(self, subject: &str) -> Diagnostic {
        match self {
            Self::Unsupported(what) => {
                let message = tr!("{subject} is {what}, which the interpreter cannot hold");
                Diagnostic::error("interp-unsupported", message).hint(tr!(
                    "it knows bool, i32, u32, f32, and vectors, matrices, arrays and structs \
                           of them"
                ))
            }
            Self::TooBig => Diagnostic::error(
                "interp-too-big",
                tr!(
                    "the type of {subject} is larger than {MAX_SLOTS} scalars or nested more than \
                     {MAX_DEPTH} deep"
                ),
            ),
        }
    }
}

#[derive(Clone, Copy)]
struct Extent {
    slots: u32,
    depth: u32,
}

/// Extents of all types of a module.
pub(super) struct Layouts(Vec<Result<Extent, LayoutProblem>>);

impl Layouts {
    /// Measures all types; naga orders them so that each comes after its parts.
    pub(super) fn of(module: &Module) -> Self {
        let mut layouts = Self(Vec::with_capacity(module.types.len()));
        for (_, ty) in module.types.iter() {
            let extent = layouts.extent(&ty.inner);
            layouts.0.push(extent);
        }
        layouts
    }

    /// Number of slots that a value takes.
    pub(super) fn slots(&self, inner: &TypeInner) -> Result<u32, LayoutProblem> {
        Ok(self.extent(inner)?.slots)
    }

    fn extent(&self, inner: &TypeInner) -> Result<Extent, LayoutProblem> {
        let known = |ty: Handle<Type>| {
            self.0.get(ty.index()).copied().unwrap_or(Err(LayoutProblem::Unsupported("recursive")))
        };
        let (slots, depth) = match inner {
            TypeInner::Scalar(scalar) => scalar_kind(*scalar).map(|_| (1, 0))?,
            TypeInner::Vector { size, scalar } => {
                scalar_kind(*scalar).map(|_| (*size as u64, 0))?
            }
            TypeInner::Matrix { columns, rows, scalar } => {
                scalar_kind(*scalar).map(|_| (*columns as u64 * *rows as u64, 0))?
            }
            // A pointer holds the number of its target slot.
            TypeInner::Pointer { .. } | TypeInner::ValuePointer { .. } => (1, 0),
            // The slot holds the number of the resource.
            TypeInner::Image { .. } | TypeInner::Sampler { .. } => (1, 0),
            TypeInner::Array { base, size, .. } => {
                let element = known(*base)?;
                (u64::from(element.slots) * u64::from(array_count(*size)?), element.depth + 1)
            }
            TypeInner::Struct { members, .. } => {
                let (mut slots, mut depth) = (0, 0);
                for member in members {
                    let extent = known(member.ty)?;
                    slots += u64::from(extent.slots);
                    depth = depth.max(extent.depth + 1);
                }
                (slots, depth)
            }
            other => return Err(LayoutProblem::Unsupported(type_name(other))),
        };
        let fits = slots <= u64::from(MAX_SLOTS) && depth <= MAX_DEPTH;
        if fits { Ok(Extent { slots: slots as u32, depth }) } else { Err(LayoutProblem::TooBig) }
    }

    /// Shape of a type. Recursion is as deep as the type, which has been bounded.
    pub(super) fn shape(&self, module: &Module, ty: Handle<Type>) -> Result<Shape, LayoutProblem> {
        let Type { name, inner } = &module.types[ty];
        self.slots(inner)?;
        Ok(match inner {
            TypeInner::Scalar(scalar) => Shape::Scalar(scalar_kind(*scalar)?),
            TypeInner::Vector { size, scalar } => {
                Shape::Vector { kind: scalar_kind(*scalar)?, size: *size as usize }
            }
            TypeInner::Matrix { columns, rows, .. } => {
                Shape::Matrix { columns: *columns as usize, rows: *rows as usize }
            }
            TypeInner::Array { base, size, .. } => Shape::Array {
                element: Box::new(self.shape(module, *base)?),
                count: array_count(*size)? as usize,
            },
            TypeInner::Struct { members, .. } => {
                let members = members
                    .iter()
                    .map(|member| {
                        Ok((
                            member.name.clone().unwrap_or_default(),
                            self.shape(module, member.ty)?,
                        ))
                    })
                    .collect::<Result<_, _>>()?;
                Shape::Struct { name: name.clone().unwrap_or_default(), members }
            }
            other => return Err(LayoutProblem::Unsupported(type_name(other))),
        })
    }

    /// Offset of part `index` of a composite.
    pub(super) fn offset(
        &self,
        types: &UniqueArena<Type>,
        inner: &TypeInner,
        index: u32,
    ) -> Result<u32, LayoutProblem> {
        let TypeInner::Struct { members, .. } = inner else {
            return Ok(self.part(types, inner, index)?.0);
        };
        members[..(index as usize).min(members.len())]
            .iter()
            .try_fold(0, |offset, member| Ok(offset + self.slots(&types[member.ty].inner)?))
    }

    /// Offset and number of slots of part `index` of a composite: a component, column, element or
    /// member.
    pub(super) fn part(
        &self,
        types: &UniqueArena<Type>,
        inner: &TypeInner,
        index: u32,
    ) -> Result<(u32, u32), LayoutProblem> {
        if let TypeInner::Struct { members, .. } = inner {
            let offset = self.offset(types, inner, index)?;
            let member = members
                .get(index as usize)
                .ok_or_else(|| LayoutProblem::Unsupported(tr!("a struct without that member")))?;
            return Ok((offset, self.slots(&types[member.ty].inner)?));
        }
        let (count, stride) = self.elements(types, inner)?;
        if index < count {
            Ok((index * stride, stride))
        } else {
            Err(LayoutProblem::Unsupported(tr!("shorter than its index")))
        }
    }

    /// Number of equal parts of a composite, and number of slots of each.
    pub(super) fn elements(
        &self,
        types: &UniqueArena<Type>,
        inner: &TypeInner,
    ) -> Result<(u32, u32), LayoutProblem> {
        Ok(match inner {
            TypeInner::Vector { size, .. } | TypeInner::ValuePointer { size: Some(size), .. } => {
                (*size as u32, 1)
            }
            TypeInner::Matrix { columns, rows, .. } => (*columns as u32, *rows as u32),
            // Code that indexes an array of any length compares with its length first.
            TypeInner::Array { base, size: ArraySize::Dynamic, .. } => {
                (u32::MAX, self.slots(&types[*base].inner)?)
            }
            TypeInner::Array { base, size, .. } => {
                (array_count(*size)?, self.slots(&types[*base].inner)?)
            }
            other => return Err(LayoutProblem::Unsupported(type_name(other))),
        })
    }
}

/// Kind of a scalar in the interpreter.
pub(super) fn scalar_kind(scalar: Scalar) -> Result<ScalarKind, LayoutProblem> {
    match (scalar.kind, scalar.width) {
        (Kind::Bool, _) => Ok(ScalarKind::Bool),
        (Kind::Sint, 4) | (Kind::AbstractInt, _) => Ok(ScalarKind::I32),
        (Kind::Uint, 4) => Ok(ScalarKind::U32),
        (Kind::Float, _) | (Kind::AbstractFloat, _) => Ok(ScalarKind::Float),
        (Kind::Sint | Kind::Uint, _) => {
            Err(LayoutProblem::Unsupported(tr!("an integer not of 32 bits")))
        }
    }
}

fn array_count(size: ArraySize) -> Result<u32, LayoutProblem> {
    match size {
        ArraySize::Constant(count) => Ok(count.get()),
        ArraySize::Pending(_) => {
            Err(LayoutProblem::Unsupported(tr!("an array whose size is an override")))
        }
        ArraySize::Dynamic => Err(LayoutProblem::Unsupported(tr!("an array without a fixed size"))),
    }
}

fn type_name(inner: &TypeInner) -> &'static str {
    match inner {
        TypeInner::Scalar(_) => tr!("a scalar"),
        TypeInner::Vector { .. } => tr!("a vector"),
        TypeInner::Matrix { .. } => tr!("a matrix"),
        TypeInner::Array { .. } => tr!("an array"),
        TypeInner::Struct { .. } => tr!("a struct"),
        TypeInner::Pointer { .. } | TypeInner::ValuePointer { .. } => tr!("a pointer"),
        TypeInner::Atomic(_) => tr!("an atomic"),
        TypeInner::Image { .. } => tr!("a texture"),
        TypeInner::Sampler { .. } => tr!("a sampler"),
        TypeInner::AccelerationStructure { .. } => tr!("an acceleration structure"),
        TypeInner::RayQuery { .. } => tr!("a ray query"),
        TypeInner::BindingArray { .. } => tr!("a binding array"),
        TypeInner::CooperativeMatrix { .. } => tr!("a cooperative matrix"),
    }
}
