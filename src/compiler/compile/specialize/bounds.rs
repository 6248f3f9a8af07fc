//! Keeps shares within 0 and 1: opacities, masks and the alpha of colors, which mix. Beyond 1 a mix
//! goes on past what is mixed in.
//!
//! The bound is a call of the library's in front of a node, and not a part of the node's function,
//! so that it is left out wherever ranges show that it changes nothing, and is computed once on the
//! host where the share is a uniform.

use super::{Argument, Builder, Function, ValueId};
use crate::compile::check::TypedNode;
use crate::compile::intervals::Range;
use crate::library::{Library, Type};

impl Builder<'_> {
    /// Bounds the inputs that the node's file says are shares.
    pub(super) fn bound_inputs(
        &mut self,
        index: usize,
        node: &TypedNode,
        inputs: &mut [Option<ValueId>],
    ) {
        for bound in &node.def.bounds {
            if let Some(value) = inputs[bound.input]
                && self.are_met(node, inputs, &bound.conditions)
            {
                let part = node.def.inputs[bound.input].name.as_str();
                inputs[bound.input] = Some(self.bounded(index, part, value));
            }
        }
    }

    /// A color whose alpha is known to lie in [0, 1] by what a node promises.
    pub(super) fn mark_unit_alpha(&mut self, color: ValueId) {
        let alpha = self.values[color].ranges.as_ref().and_then(|ranges| ranges.get(3)).copied();
        if let (Some(alpha), Some(ranges)) = (alpha, &mut self.values[color].ranges) {
            *ranges = ranges[..3].iter().copied().chain([alpha.within_unit()]).collect();
        }
    }

    /// A share within 0 and 1, or a color with such an alpha; a value of another type as it is.
    pub(super) fn bounded(&mut self, index: usize, part: &str, value: ValueId) -> ValueId {
        let ty = self.values[value].ty.clone();
        let (name, share) = match ty {
            Type::Float => ("unit_share", 0),
            Type::Color | Type::Vec4 => ("with_unit_alpha", 3),
            _ => return value,
        };
        let ranges = self.values[value].ranges.as_ref();
        if ranges.and_then(|ranges| ranges.get(share)).is_some_and(is_share) {
            return value;
        }
        let Some(built_in) = Library::built_in().nodes.values().next() else { return value };
        let function = Function { module: built_in.module.clone(), name: name.into() };
        let arguments = vec![Argument::Value(value)];
        self.call_function(index, function, arguments, ty, Some(part.to_owned()))
    }
}

/// True if every number of the range is a share, from 0 to 1. A bound would change nothing but NaN,
/// of which a bound makes no share either.
fn is_share(range: &Range) -> bool {
    range.is_number_within(0.0, 1.0)
}
