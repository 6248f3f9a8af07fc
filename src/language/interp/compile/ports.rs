//! Ports of a function: its input and output vectors, with their attributes.

use naga::{Binding, Function, Handle, Module, Type, TypeInner};

use crate::interp::instruction::Slot;
use crate::interp::{LanePort, ProgramParameter, Shape};

/// Ports of the arguments.
pub(super) fn inputs(
    module: &Module,
    function: &Function,
    parameters: &[ProgramParameter],
) -> Vec<LanePort> {
    let mut ports = Vec::new();
    for (argument, parameter) in function.arguments.iter().zip(parameters) {
        let ProgramParameter { name, shape, slot } = parameter;
        add(&mut ports, module, argument.ty, argument.binding.as_ref(), name, shape, *slot);
    }
    ports
}

/// Ports of the result.
pub(super) fn outputs(
    module: &Module,
    function: &Function,
    shape: &Shape,
    slot: Slot,
) -> Vec<LanePort> {
    let mut ports = Vec::new();
    if let Some(result) = &function.result {
        add(&mut ports, module, result.ty, result.binding.as_ref(), "", shape, slot);
    }
    ports
}

fn add(
    ports: &mut Vec<LanePort>,
    module: &Module,
    ty: Handle<Type>,
    binding: Option<&Binding>,
    name: &str,
    shape: &Shape,
    slot: Slot,
) {
    let TypeInner::Struct { members: attributes, .. } = &module.types[ty].inner else {
        ports.extend(port(name.to_owned(), binding, shape, slot));
        return;
    };
    let Shape::Struct { members, .. } = shape else { return };
    let mut slot = slot;
    for (attributes, (member, shape)) in attributes.iter().zip(members) {
        let separator = if name.is_empty() { "" } else { "." };
        ports.extend(port(
            format!("{name}{separator}{member}"),
            attributes.binding.as_ref(),
            shape,
            slot,
        ));
        slot += shape.slots() as Slot;
    }
}

fn port(name: String, binding: Option<&Binding>, shape: &Shape, slot: Slot) -> Option<LanePort> {
    let (kind, size) = match shape {
        Shape::Scalar(kind) => (*kind, 1),
        Shape::Vector { kind, size } => (*kind, *size),
        _ => return None,
    };
    Some(LanePort { name, binding: binding.cloned(), kind, size, slot })
}
