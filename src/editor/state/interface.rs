//! Interface of a group: its label, its inputs and its outputs.

use crate::document::{Definition, Edit};
use crate::ids::{DefinitionId, PortName, make_slug};

/// The edit that changes a group's interface.
pub(crate) fn set(
    id: &DefinitionId,
    definition: &Definition,
    change: impl FnOnce(&mut Definition),
) -> Edit {
    let mut changed = Definition { graph: Default::default(), ..definition.clone() };
    change(&mut changed);
    let Definition { label, help, inputs, outputs, .. } = changed;
    Edit::SetInterface { id: id.clone(), label, help, inputs, outputs }
}

/// A name, like `wished`, that no port on the same side of the group has.
pub(crate) fn free_port(definition: &Definition, is_output: bool, wished: &str) -> PortName {
    let ports = if is_output { &definition.outputs } else { &definition.inputs };
    PortName::new(make_slug(wished, |slug| ports.iter().any(|port| port.name.as_str() == slug)))
}
