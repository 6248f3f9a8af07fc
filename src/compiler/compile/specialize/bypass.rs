//! The `@bypass` and `@unit` rules of node files: by constants, or by what ranges prove.

use chiaro_locale::{tr, tr_in};

use super::{Builder, ValueId};
use crate::compile::check::TypedNode;
use crate::compile::removal::Proof;
use crate::compile::value::typed_value;
use crate::document::Value;
use crate::library::{Bypass, BypassResult, Condition, Limit, Test};

/// The evidence that a condition holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Evidence {
    /// The values themselves.
    Constants,
    /// Ranges: the values are not known, but their bounds are.
    Ranges,
}

impl Builder<'_> {
    /// The value that stands in a node's place, and why.
    pub(super) fn bypass(
        &mut self,
        index: usize,
        node: &TypedNode,
        inputs: &[Option<ValueId>],
    ) -> Option<(ValueId, String, Proof)> {
        if self.options.unspecialized || node.variant().result_is_struct {
            return None;
        }
        let (bypass, evidence) = node.def.bypasses.iter().find_map(|bypass| {
            let evidence = self.all_hold(node, inputs, &bypass.conditions)?;
            Some((bypass, evidence))
        })?;
        let ty = node.variant().result.clone();
        let value = match bypass.result {
            BypassResult::Input(input) => inputs[input].filter(|&id| self.values[id].ty == ty)?,
            BypassResult::Number(number) => {
                let value = typed_value(&Value::Number(number), &ty).ok()?;
                self.constant(index, ty, value)
            }
        };
        let reason = if bypass.reason.is_empty() {
            tr!("it changes nothing")
        } else {
            tr_in("node", &bypass.reason)
        };
        Some(match evidence {
            Evidence::Constants => (value, reason.to_owned(), proof_of(bypass)),
            Evidence::Ranges => (value, tr!("{reason}, proved by ranges"), Proof::Ranges),
        })
    }

    /// True if a node's result lies in [0, 1] by the node's own rule, `unit_when`.
    pub(super) fn is_unit(&self, node: &TypedNode, inputs: &[Option<ValueId>]) -> bool {
        node.def.unit_when.as_ref().is_some_and(|conditions| self.are_met(node, inputs, conditions))
    }

    /// True if all conditions hold, by evidence of any kind.
    pub(super) fn are_met(
        &self,
        node: &TypedNode,
        inputs: &[Option<ValueId>],
        conditions: &[Condition],
    ) -> bool {
        self.all_hold(node, inputs, conditions).is_some()
    }

    fn all_hold(
        &self,
        node: &TypedNode,
        inputs: &[Option<ValueId>],
        conditions: &[Condition],
    ) -> Option<Evidence> {
        let each = conditions.iter().map(|condition| self.holds(node, inputs, condition));
        each.into_iter().try_fold(Evidence::Constants, |evidence, one| Some(evidence.max(one?)))
    }

    fn holds(
        &self,
        node: &TypedNode,
        inputs: &[Option<ValueId>],
        condition: &Condition,
    ) -> Option<Evidence> {
        if let Test::Word(words) = &condition.test {
            let word = node.choices.get(&condition.input)?;
            return words.contains(word).then_some(Evidence::Constants);
        }
        let id = inputs[condition.input]?;
        let evidence = if self.is_constant(id) { Evidence::Constants } else { Evidence::Ranges };
        let all = |count: usize, low: f64, high: f64| {
            let Some(ranges) = &self.values[id].ranges else { return false };
            let is_within = |range: &crate::compile::intervals::Range| {
                range.bounds().is_some_and(|bounds| low <= bounds[0] && bounds[1] <= high)
            };
            !ranges.is_empty() && ranges.iter().take(count).all(is_within)
        };
        let holds = match &condition.test {
            Test::Is(wanted) => self.is_number(id, *wanted) || all(usize::MAX, *wanted, *wanted),
            Test::Black => all(3, 0.0, 0.0),
            Test::Same(other) if inputs[*other] == Some(id) => return Some(Evidence::Constants),
            Test::Same(_) => false,
            Test::Unit if self.values[id].unit => return Some(Evidence::Constants),
            Test::Unit => all(usize::MAX, 0.0, 1.0),
            Test::AtMost(limit) => {
                all(usize::MAX, f64::NEG_INFINITY, self.limit(inputs, limit, 0)?)
            }
            Test::AtLeast(limit) => all(usize::MAX, self.limit(inputs, limit, 1)?, f64::INFINITY),
            Test::UnitAlpha => {
                let ranges = self.values[id].ranges.as_ref()?;
                ranges.get(3).is_none_or(|range| {
                    range.bounds().is_some_and(|[low, high]| low >= 0.0 && high <= 1.0)
                })
            }
            Test::Word(_) => false,
        };
        holds.then_some(evidence)
    }

    /// The lower (0) or upper (1) bound of all numbers of what a condition is held against.
    fn limit(&self, inputs: &[Option<ValueId>], limit: &Limit, side: usize) -> Option<f64> {
        match limit {
            Limit::Number(number) => Some(*number),
            Limit::Input(input) => {
                let ranges = self.values[inputs[*input]?].ranges.as_ref()?;
                let bounds = ranges.iter().map(|range| range.bounds().map(|bounds| bounds[side]));
                let bounds = bounds.collect::<Option<Vec<_>>>()?;
                let pick: fn(f64, f64) -> f64 = if side == 0 { f64::min } else { f64::max };
                bounds.into_iter().reduce(pick)
            }
        }
    }

    fn is_constant(&self, id: ValueId) -> bool {
        matches!(self.values[id].operation, super::Operation::Constant(_))
    }

    /// A constant as a document writes it, which f32 may not hold.
    fn is_number(&self, id: ValueId, wanted: f64) -> bool {
        match &self.values[id].operation {
            super::Operation::Constant(value) => {
                value.components().is_some_and(|numbers| numbers.iter().all(|x| *x == wanted))
            }
            _ => false,
        }
    }
}

fn proof_of(bypass: &Bypass) -> Proof {
    let any = |is: fn(&Test) -> bool| bypass.conditions.iter().any(|condition| is(&condition.test));
    if any(|test| matches!(test, Test::Same(_))) {
        Proof::Equal
    } else if any(|test| matches!(test, Test::Black) || *test == Test::Is(0.0)) {
        Proof::ZeroWeight
    } else {
        Proof::NoEffect
    }
}
