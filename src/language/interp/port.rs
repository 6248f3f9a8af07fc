//! Ports: inputs and outputs of a stage, one vector at a time.

use super::ScalarKind;
use super::instruction::Slot;

/// Scalar or vector that [`Lanes`](super::Lanes) take or give: an argument or result, or a member
/// of one.
#[derive(Clone, Debug, PartialEq)]
pub struct LanePort {
    /// Name of the port: `in.position`, `color`. An unnamed result is empty.
    pub name: String,
    /// Binding given by the attribute: a builtin, or a location with its interpolation.
    pub binding: Option<naga::Binding>,
    /// Kind of the scalars.
    pub kind: ScalarKind,
    /// Number of scalars, 1 to 4.
    pub size: usize,
    /// First slot of the port.
    pub(super) slot: Slot,
}

impl LanePort {
    /// Location of the port, if it has one.
    pub fn location(&self) -> Option<u32> {
        if let Some(naga::Binding::Location { location, .. }) = self.binding {
            Some(location)
        } else {
            None
        }
    }

    /// Builtin of the port, if it is one.
    pub fn builtin(&self) -> Option<naga::BuiltIn> {
        if let Some(naga::Binding::BuiltIn(builtin)) = self.binding { Some(builtin) } else { None }
    }

    pub(super) fn slot_of(&self, component: usize) -> Slot {
        assert!(component < self.size, "`{}` has no component {component}", self.name);
        self.slot + component as Slot
    }
}
