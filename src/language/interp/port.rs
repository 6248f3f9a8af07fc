//! What goes into and comes out of a stage, one vector at a time.

use super::ScalarKind;
use super::instruction::Slot;

/// A scalar or vector that [`Lanes`](super::Lanes) are given or give: an argument or result, or a
/// member of one.
#[derive(Clone, Debug, PartialEq)]
pub struct Port {
    /// Its name: `in.position`, `color`. An unnamed result is empty.
    pub name: String,
    /// What its attribute says: a builtin, or a location with its interpolation.
    pub binding: Option<naga::Binding>,
    /// The kind of its scalars.
    pub kind: ScalarKind,
    /// The number of its scalars, 1 to 4.
    pub size: usize,
    /// The first of its slots.
    pub(super) slot: Slot,
}

impl Port {
    /// Its location, if it has one.
    pub fn location(&self) -> Option<u32> {
        if let Some(naga::Binding::Location { location, .. }) = self.binding {
            Some(location)
        } else {
            None
        }
    }

    /// Its builtin, if it is one.
    pub fn builtin(&self) -> Option<naga::BuiltIn> {
        if let Some(naga::Binding::BuiltIn(builtin)) = self.binding { Some(builtin) } else { None }
    }

    pub(super) fn slot_of(&self, component: usize) -> Slot {
        assert!(component < self.size, "`{}` has no component {component}", self.name);
        self.slot + component as Slot
    }
}
