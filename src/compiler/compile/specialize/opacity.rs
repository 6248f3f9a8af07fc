//! Opacity of a picture: whether nothing behind it can be seen through it.

use std::collections::HashMap;

use super::{Argument, Builder, ImageUse, Operation, Ranges, ValueId, operands, reachable};
use crate::compile::host::conversion_ranges;
use crate::compile::intervals::{self, Range};
use crate::interp;
use crate::library::Type;

/// Least alpha of an opaque color: weights of opaque paint add up to 1 but for roundings.
const LEAST_ALPHA: f64 = 1.0 - 1e-5;

impl Builder<'_> {
    /// The images that must be opaque for the value to be an opaque color; `None` if it may be
    /// transparent even then.
    pub(super) fn opaque_with(&mut self, color: ValueId) -> Option<Vec<ImageUse>> {
        if self.options.unspecialized {
            return None;
        }
        let reached = reachable(&self.values, std::iter::once(color));
        // Ranges of the values that are known better if the images are opaque.
        let mut known: HashMap<ValueId, Ranges> = HashMap::new();
        let mut images = Vec::new();
        // What a value is made of was made before.
        for id in (0..=color).filter(|id| reached[*id]) {
            if let Some(needed) = self.opaque_paints(id, &known) {
                let any = || intervals::any_like(&interp::Value::vec(&[0.0; 4]));
                let ranges = self.values[id].ranges.clone().unwrap_or_else(any);
                let one = intervals::of_value(&interp::Value::Float(1.0));
                known.insert(id, ranges.iter().take(3).chain(one.iter()).copied().collect());
                images.extend(needed.iter().map(|image| self.images[*image].clone()));
            } else if operands(&self.values[id].operation).any(|part| known.contains_key(&part))
                && let Some(ranges) = self.ranges_with(id, &known)
            {
                known.insert(id, ranges);
            }
        }
        let value = &self.values[color];
        let is_opaque = match value.ty {
            Type::Color | Type::Vec4 | Type::Composite => {
                known.get(&color).or(value.ranges.as_ref())?.get(3).copied().is_some_and(is_one)
            }
            // What has no alpha is shown as an opaque color.
            _ => true,
        };
        is_opaque.then_some(images)
    }

    /// The images that must be opaque for the color of a node to be, if all other colors that it
    /// takes are opaque, and all stops of its ramps; `None` where it may be transparent even then.
    fn opaque_paints(&self, id: ValueId, known: &HashMap<ValueId, Ranges>) -> Option<Vec<usize>> {
        let value = &self.values[id];
        let node = &self.graph.nodes[value.node];
        let Operation::Call { function, arguments } = &value.operation else { return None };
        if !node.def.keeps_opaque || *function.name != *node.variant().function {
            return None;
        }
        let mut images = Vec::new();
        for argument in arguments {
            match argument {
                Argument::Image(index) => images.push(*index),
                Argument::Value(part) => {
                    let part_value = &self.values[*part];
                    let is_opaque = match (&part_value.ty, &part_value.operation) {
                        (Type::Color, _) => {
                            let ranges = known.get(part).or(part_value.ranges.as_ref());
                            ranges?.get(3).copied().is_some_and(is_one)
                        }
                        (Type::Ramp, Operation::Constant(ramp)) => is_opaque_ramp(ramp),
                        (Type::Ramp, _) => false,
                        _ => true,
                    };
                    if !is_opaque {
                        return None;
                    }
                }
                Argument::Sampler(_) => {}
            }
        }
        Some(images)
    }

    /// The ranges of a value from what is known of its parts.
    fn ranges_with(&mut self, id: ValueId, known: &HashMap<ValueId, Ranges>) -> Option<Ranges> {
        let of = |part: &ValueId| known.get(part).or(self.values[*part].ranges.as_ref()).cloned();
        match &self.values[id].operation {
            Operation::Call { function, arguments } => {
                let given = arguments.iter().map(|argument| match argument {
                    Argument::Value(part) => of(part),
                    Argument::Image(_) | Argument::Sampler(_) => Some(Ranges::from([])),
                });
                let given: Vec<Ranges> = given.collect::<Option<_>>()?;
                let function = function.clone();
                self.intervals.call(&function.module, &function.name, &given)
            }
            Operation::Convert { value, .. } => {
                conversion_ranges(&self.values[*value].ty, &self.values[id].ty, &of(value)?)
            }
            _ => None,
        }
    }
}

fn is_one(alpha: Range) -> bool {
    alpha.bounds().is_some_and(|[least, _]| least >= LEAST_ALPHA)
}

/// True if a ramp has stops, all of them opaque.
fn is_opaque_ramp(ramp: &interp::Value) -> bool {
    let interp::Value::Struct(members) = ramp else { return false };
    let [interp::Value::Array(colors), _, interp::Value::U32(count), _] = &members[..] else {
        return false;
    };
    let mut stops = colors.iter().take(*count as usize);
    let is_opaque = |stop: &interp::Value| stop.components().is_some_and(|color| color[3] == 1.0);
    *count > 0 && stops.all(is_opaque)
}
