//! Global variables that a program uses, and their places.

use std::collections::HashMap;

use chiaro_locale::tr;
use naga::{
    AddressSpace, ArraySize, Expression, Function, GlobalVariable, Handle, ImageClass, Module,
    StorageAccess,
};
use naga::{ImageDimension, ScalarKind as Kind, Type, TypeInner};

use super::Outcome;
use super::assembler::Assembler;
use super::expressions::{MemoryPlace, Operand};
use super::layout::{LayoutProblem, Layouts};
use crate::diag::Diagnostic;
use crate::interp::instruction::Slot;
use crate::interp::resources::{Resource, ResourceKind, Texel};
use crate::interp::{Shape, TextureDimension};

/// Place of a global variable.
#[derive(Clone, Copy)]
enum GlobalPlace {
    /// First slot of the variable.
    Private(Slot),
    /// Number of the buffer among the resources.
    Buffer(u32),
    /// Number of the texture or sampler among the resources.
    Handle(u32),
}

/// Global variables of a program.
#[derive(Default)]
pub(super) struct Globals {
    homes: HashMap<Handle<GlobalVariable>, GlobalPlace>,
    pub(super) resources: Vec<Resource>,
    /// Private variables in order, with the first slot of each.
    pub(super) private: Vec<(Handle<GlobalVariable>, Slot)>,
}

impl Globals {
    /// Finds a place for each variable that the functions use.
    pub(super) fn of<'f>(
        module: &Module,
        layouts: &Layouts,
        assembler: &mut Assembler,
        functions: impl Iterator<Item = &'f Function>,
    ) -> Outcome<Self> {
        let mut used: Vec<Handle<GlobalVariable>> = Vec::new();
        for function in functions {
            used.extend(function.expressions.iter().filter_map(
                |(_, expression)| match expression {
                    Expression::GlobalVariable(handle) => Some(*handle),
                    _ => None,
                },
            ));
        }
        used.sort_unstable();
        used.dedup();
        let mut globals = Self::default();
        for handle in used {
            globals.add(module, layouts, assembler, handle).map_err(|problem| {
                let name = module.global_variables[handle].name.as_deref().unwrap_or("");
                let mut error = problem.diagnose(&tr!("the global variable `{name}`"));
                error.place.wgsl = module.global_variables.get_span(handle).to_range();
                Box::new(error)
            })?;
        }
        Ok(globals)
    }

    fn add(
        &mut self,
        module: &Module,
        layouts: &Layouts,
        assembler: &mut Assembler,
        handle: Handle<GlobalVariable>,
    ) -> Result<(), LayoutProblem> {
        let variable = &module.global_variables[handle];
        let home = match variable.space {
            AddressSpace::Private => {
                let count = layouts.slots(&module.types[variable.ty].inner)?;
                let slot = assembler.reserve(count).map_err(|_| LayoutProblem::TooBig)?;
                self.private.push((handle, slot));
                GlobalPlace::Private(slot)
            }
            AddressSpace::Uniform | AddressSpace::Storage { .. } => {
                if matches!(
                    variable.space,
                    AddressSpace::Storage { access } if access.contains(StorageAccess::STORE)
                ) {
                    return Err(LayoutProblem::Unsupported(tr!(
                        "a storage buffer that can be written"
                    )));
                }
                GlobalPlace::Buffer(self.resource(variable, buffer(module, layouts, variable.ty)?)?)
            }
            AddressSpace::Handle => GlobalPlace::Handle(
                self.resource(variable, opaque(&module.types[variable.ty].inner)?)?,
            ),
            AddressSpace::WorkGroup => {
                return Err(LayoutProblem::Unsupported(tr!("workgroup memory")));
            }
            _ => return Err(LayoutProblem::Unsupported(tr!("in an address space of its own"))),
        };
        self.homes.insert(handle, home);
        Ok(())
    }

    fn resource(
        &mut self,
        variable: &GlobalVariable,
        kind: ResourceKind,
    ) -> Result<u32, LayoutProblem> {
        let binding = variable
            .binding
            .ok_or_else(|| LayoutProblem::Unsupported(tr!("a resource without a binding")))?;
        let name = variable.name.clone().unwrap_or_default();
        self.resources.push(Resource {
            group: binding.group,
            binding: binding.binding,
            name,
            kind,
        });
        Ok(self.resources.len() as u32 - 1)
    }

    /// Compiled form of an expression that names the variable; `None` if the program may not use
    /// the variable.
    pub(super) fn operand(
        &self,
        handle: Handle<GlobalVariable>,
        assembler: &mut Assembler,
    ) -> Outcome<Option<Operand>> {
        Ok(Some(match self.homes.get(&handle) {
            Some(GlobalPlace::Private(slot)) => Operand::Place(MemoryPlace::fixed(*slot)),
            Some(GlobalPlace::Buffer(number)) => {
                Operand::Place(MemoryPlace { buffer: Some(*number), ..MemoryPlace::fixed(0) })
            }
            Some(GlobalPlace::Handle(number)) => {
                let slot = assembler.constant(u64::from(*number))?;
                Operand::Value([slot].into())
            }
            None => return Ok(None),
        }))
    }
}

/// Resource kind of a buffer of a type.
fn buffer(
    module: &Module,
    layouts: &Layouts,
    ty: Handle<Type>,
) -> Result<ResourceKind, LayoutProblem> {
    let members = match &module.types[ty].inner {
        TypeInner::Array { base, size: ArraySize::Dynamic, .. } => {
            return Ok(ResourceKind::Unsized {
                head: None,
                element: layouts.shape(module, *base)?,
            });
        }
        TypeInner::Struct { members, .. } => members.as_slice(),
        _ => &[],
    };
    if let Some((last, before)) = members.split_last()
        && let TypeInner::Array { base, size: ArraySize::Dynamic, .. } = module.types[last.ty].inner
    {
        let head: Result<Vec<(String, Shape)>, LayoutProblem> = before
            .iter()
            .map(|member| {
                Ok((member.name.clone().unwrap_or_default(), layouts.shape(module, member.ty)?))
            })
            .collect();
        return Ok(ResourceKind::Unsized {
            head: Some(head?),
            element: layouts.shape(module, base)?,
        });
    }
    Ok(ResourceKind::Buffer(layouts.shape(module, ty)?))
}

/// Resource kind of a texture or sampler variable.
fn opaque(inner: &TypeInner) -> Result<ResourceKind, LayoutProblem> {
    match *inner {
        TypeInner::Image { dim, arrayed, class } => Ok(ResourceKind::Texture {
            dimension: dimension(dim),
            is_arrayed: arrayed,
            texel: texel(class)?,
        }),
        TypeInner::Sampler { comparison } => {
            Ok(ResourceKind::Sampler { is_comparison: comparison })
        }
        TypeInner::BindingArray { .. } => {
            Err(LayoutProblem::Unsupported(tr!("an array of bindings")))
        }
        TypeInner::AccelerationStructure { .. } => {
            Err(LayoutProblem::Unsupported(tr!("an acceleration structure")))
        }
        _ => Err(LayoutProblem::Unsupported(tr!(
            "an opaque type that is neither texture nor sampler"
        ))),
    }
}

fn dimension(dim: ImageDimension) -> TextureDimension {
    match dim {
        ImageDimension::D1 => TextureDimension::D1,
        ImageDimension::D2 => TextureDimension::D2,
        ImageDimension::D3 => TextureDimension::D3,
        ImageDimension::Cube => TextureDimension::Cube,
    }
}

/// Type that the texels of a class of textures are read as.
pub(super) fn texel(class: ImageClass) -> Result<Texel, LayoutProblem> {
    match class {
        ImageClass::Sampled { multi: true, .. } | ImageClass::Depth { multi: true } => {
            Err(LayoutProblem::Unsupported(tr!("a multisampled texture")))
        }
        ImageClass::Sampled { kind: Kind::Sint, .. } => Ok(Texel::I32),
        ImageClass::Sampled { kind: Kind::Uint, .. } => Ok(Texel::U32),
        ImageClass::Sampled { .. } => Ok(Texel::Float),
        ImageClass::Depth { .. } => Ok(Texel::Depth),
        ImageClass::External => Err(LayoutProblem::Unsupported(tr!("an external texture"))),
        ImageClass::Storage { .. } => Err(LayoutProblem::Unsupported(tr!("a storage texture"))),
    }
}

/// Error of a function that uses a global variable and is no stage.
#[cold]
pub(super) fn no_stage(mut error: Box<Diagnostic>) -> Box<Diagnostic> {
    error.hints.push(tr!("`Options::stage` lets it use what a stage of a pipeline has").to_owned());
    error
}
