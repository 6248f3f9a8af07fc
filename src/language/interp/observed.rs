//! Observed values: values that a program names (`let`), readable after a run. Each keeps its
//! slots, because none are shared.

use std::ops::Range;

use super::instruction::Slot;
use super::{Lanes, Program, ScalarKind, Shape};

/// Named value of a function of a program.
///
/// A function that is called several times keeps the values of its last call.
#[derive(Clone, Debug, PartialEq)]
pub struct ObservedValue {
    /// Name in the source.
    pub name: String,
    /// Name of the function that holds the value.
    pub function: String,
    /// Expression that the value names, in bytes of the source.
    pub span: Range<usize>,
    /// Slots and kinds of the value's scalars, in order.
    pub(super) slots: Vec<(Slot, ScalarKind)>,
}

impl ObservedValue {
    /// Number of scalars of the value.
    pub fn len(&self) -> usize {
        self.slots.len()
    }

    /// True for a value without scalars.
    pub fn is_empty(&self) -> bool {
        self.slots.is_empty()
    }
}

impl Program {
    /// All named values; none unless the program was compiled with
    /// [`FunctionOptions::observe`](super::FunctionOptions::observe).
    pub fn observed(&self) -> &[ObservedValue] {
        &self.observed
    }
}

impl Lanes<'_> {
    /// Scalars of a named value in one lane of the last run; bools are 0 or 1.
    ///
    /// # Panics
    /// There is no such lane.
    pub fn observe(&self, value: &ObservedValue, lane: usize) -> Vec<f64> {
        value
            .slots
            .iter()
            .map(|&(slot, kind)| kind.read(self.memory.bits(slot, lane)).as_f64())
            .collect()
    }
}

/// Appends the kinds of all scalars of a shape, in order.
pub(super) fn kinds(shape: &Shape, kinds_so_far: &mut Vec<ScalarKind>) {
    match shape {
        Shape::Scalar(kind) => kinds_so_far.push(*kind),
        Shape::Vector { kind, size } => kinds_so_far.extend(std::iter::repeat_n(*kind, *size)),
        Shape::Matrix { columns, rows } => {
            kinds_so_far.extend(std::iter::repeat_n(ScalarKind::Float, columns * rows));
        }
        Shape::Array { element, count } => (0..*count).for_each(|_| kinds(element, kinds_so_far)),
        Shape::Struct { members, .. } => {
            members.iter().for_each(|(_, member)| kinds(member, kinds_so_far));
        }
    }
}
