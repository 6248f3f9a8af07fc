//! Values that are written beside the picture: outputs of nodes, and contributions of a stack's
//! steps.

use std::collections::{HashMap, HashSet};

use super::{Argument, Builder, Function, ValueId};
use crate::compile::aov::{Passage, Stack, StepId, TypedAovKind};
use crate::compile::parting::{CutRule, LightShares, ShareCut};
use crate::interp;
use crate::library::{Library, Type};

/// Functions of `shaders/lib/blend.wgsl`.
const THROUGH: &str = "let_through";
const ADDED: &str = "added_over";
const HELD: &str = "held_back";
const BOTH: &str = "both_through";
const SUM: &str = "sum_of_both";
const PASSAGE: &str = "blend_passage";
const GREATER: &str = "greater_passage";
const NUMBER_CHANNELS: &str = "channels_of_number";
const COLOR_CHANNELS: &str = "channels_of_color";
const SHARE_OF_PART: &str = "share_of_part";
const SHARE_OF_WINNER: &str = "share_of_winner";
const SHARE_OF_BELOW: &str = "share_of_below";
const SHARE_OF_WEIGHT: &str = "share_of_weight";
const SHARE_OF_MIXED: &str = "share_of_mixed";
const SHARE_OF_LIGHT: &str = "share_of_light";
const REST_OF_SHARE: &str = "rest_of_share";

/// Passages in the order of the numbers that `blend_passage` knows.
const PASSAGES: [&str; 5] = ["left", "multiply", "alpha", "shade", "screen"];

/// Modes of *Blend* that hide some of what is below, with the passage that hides as much; the
/// others let all of it through that is left.
const BLENDED: [(&str, &str); 8] = [
    ("multiply", "multiply"),
    ("alpha", "alpha"),
    ("shade", "shade"),
    ("screen", "screen"),
    ("hue", "alpha"),
    ("saturation", "alpha"),
    ("color", "alpha"),
    ("luminosity", "alpha"),
];

/// Modes of *Mix colors* that hide some of what is below, with the passage that hides as much; the
/// others let all of it through that is left.
const MIXED: [(&str, &str); 6] = [
    ("normal", "alpha"),
    ("multiply", "multiply"),
    ("hue", "alpha"),
    ("saturation", "alpha"),
    ("color", "alpha"),
    ("luminosity", "alpha"),
];

impl Builder<'_> {
    /// The values beside the picture, each with its number.
    pub(super) fn aovs(&mut self) -> Vec<(usize, ValueId)> {
        let graph = self.graph;
        let is_of_stack = |kind: &TypedAovKind| !matches!(kind, TypedAovKind::Output(..));
        let mut aovs = graph.aovs.iter().filter_map(|aov| aov.as_ref().ok()?.as_ref());
        let stack = aovs.any(|aov| is_of_stack(&aov.kind)).then(|| graph.stack());
        let mut contributions = stack.as_ref().map(|stack| self.contributions(stack));
        if let (Some(stack), Some(known)) = (&stack, &mut contributions) {
            self.light_shares(stack, known);
        }
        let mut found = Vec::new();
        for (number, aov) in graph.aovs.iter().enumerate() {
            let Ok(Some(aov)) = aov else { continue };
            let value = match &aov.kind {
                TypedAovKind::Output(node, output) => self.outputs[*node].get(*output).copied(),
                TypedAovKind::Stack => {
                    let top = stack.as_ref().and_then(|stack| stack.top);
                    top.and_then(|(node, output)| {
                        let value = *self.outputs[node].get(output)?;
                        Some(self.premultiplied(node, value))
                    })
                }
                TypedAovKind::Steps(steps) => {
                    let known = contributions.as_ref();
                    let mut sum = None;
                    for step in steps {
                        let Some(&value) = known.and_then(|known| known.get(step)) else {
                            continue;
                        };
                        let node = self.values[value].node;
                        sum = Some(match sum {
                            None => value,
                            Some(sum) => self.of_library(node, SUM, &[sum, value], Type::Vec3),
                        });
                    }
                    sum
                }
            };
            found.extend(value.map(|value| (number, value)));
        }
        found
    }

    /// A value as premultiplied color.
    fn premultiplied(&mut self, node: usize, value: ValueId) -> ValueId {
        match self.values[value].ty {
            Type::Color | Type::Vec4 => {
                // A sum of colors may have more alpha than there is, as the Output bounds it.
                let value = self.bounded(node, "alpha", value);
                self.convert(node, value, "premultiplied($)", &Type::Composite)
            }
            _ => value,
        }
    }

    /// Contribution of each step of a stack to its top, as `vec3f`. Steps that add nothing are left
    /// out.
    fn contributions(&mut self, stack: &Stack) -> HashMap<StepId, ValueId> {
        let graph = self.graph;
        let mut found = HashMap::with_capacity(stack.steps.len() + 1);
        // The share of what a step adds that all steps above let through; `None` for all of it.
        let mut through: Option<ValueId> = None;
        let mut lowest = None;
        for &(index, below) in &stack.steps {
            let node = &graph.nodes[index];
            let inputs = self.inputs(index, node);
            let (Some(under), Some(&over)) = (inputs[below], self.outputs[index].first()) else {
                continue;
            };
            let [under, over] = [under, over].map(|value| self.premultiplied(index, value));
            lowest = Some((index, under));
            // A step that was bypassed.
            if under == over {
                continue;
            }
            let Some(asked) = self.passage(index, &inputs, [under, over]) else { continue };
            let own = self.of_library(index, THROUGH, &[under, over, asked], Type::Vec3);
            let added = self.of_library(index, ADDED, &[under, over, own], Type::Vec3);
            let (seen, next) = match through {
                None => (added, own),
                Some(through) => (
                    self.of_library(index, BOTH, &[added, through], Type::Vec3),
                    self.of_library(index, BOTH, &[own, through], Type::Vec3),
                ),
            };
            found.insert(graph.step_id(index), seen);
            through = Some(next);
        }
        let bottom = stack.bottom.and_then(|(index, output)| {
            let value = *self.outputs[index].get(output)?;
            Some((graph.step_id(index), index, value))
        });
        let own = lowest.map(|(index, value)| {
            (StepId { is_below: true, ..graph.step_id(index) }, index, value)
        });
        if let Some((id, index, value)) = bottom.or(own) {
            let value = self.premultiplied(index, value);
            let ones = self.constant(index, Type::Vec3, interp::Value::vec(&[1.0; 3]));
            let through = through.unwrap_or(ones);
            found.insert(id, self.of_library(index, HELD, &[value, through], Type::Vec3));
        }
        found
    }

    /// Parts the contributions of steps among lights, where parts of them are written.
    fn light_shares(&mut self, stack: &Stack, known: &mut HashMap<StepId, ValueId>) {
        let graph = self.graph;
        let mut wanted = HashSet::new();
        for aov in graph.aovs.iter().filter_map(|aov| aov.as_ref().ok()?.as_ref()) {
            let TypedAovKind::Steps(steps) = &aov.kind else { continue };
            let parted = steps.iter().filter(|step| step.share.is_some());
            wanted.extend(parted.map(|step| StepId { share: None, ..step.clone() }));
        }
        if wanted.is_empty() {
            return;
        }
        let lights = graph.lights_by_node();
        let steps = stack.steps.iter().map(|&(index, below)| (index, Some(below)));
        let bottom = stack.bottom.map(|source| (source.0, None));
        for (index, below) in steps.chain(bottom) {
            let id = graph.step_id(index);
            let Some(&seen) = known.get(&id).filter(|_| wanted.contains(&id)) else { continue };
            let parting = match (below, stack.bottom) {
                (Some(below), _) => graph.part_step(&lights, index, below),
                (None, Some(source)) => graph.part_output(&lights, source),
                (None, None) => continue,
            };
            let shares = self.shares(index, &parting);
            for (lights, ends) in parting.by_lights() {
                let mut sum: Option<ValueId> = None;
                for end in ends.iter().filter_map(|end| shares.get(*end).copied()) {
                    sum = Some(match sum {
                        None => end,
                        Some(sum) => self.of_library(index, SUM, &[sum, end], Type::Vec3),
                    });
                }
                if let Some(share) = sum {
                    let part = self.of_library(index, BOTH, &[seen, share], Type::Vec3);
                    known.insert(StepId { share: Some(lights), ..id.clone() }, part);
                }
            }
        }
    }

    /// The value of each share of a step, as `vec3f`.
    fn shares(&mut self, index: usize, parting: &LightShares) -> Vec<ValueId> {
        let ones = interp::Value::vec(&[1.0; 3]);
        let mut shares = vec![self.constant(index, Type::Vec3, ones)];
        for cut in &parting.cuts {
            let share = shares[cut.share];
            let none = interp::Value::vec(&[0.0; 3]);
            let first = match self.first_of_cut(cut, share) {
                Some(first) => first,
                None => self.constant(cut.node, Type::Vec3, none),
            };
            let rest = self.of_library(cut.node, REST_OF_SHARE, &[share, first], Type::Vec3);
            shares.extend([first, rest]);
        }
        shares
    }

    /// The first part of a share that a node cuts.
    fn first_of_cut(&mut self, cut: &ShareCut, share: ValueId) -> Option<ValueId> {
        let (graph, at) = (self.graph, cut.node);
        let node = &graph.nodes[at];
        let inputs = self.inputs(at, node);
        let first = inputs[cut.first]?;
        let whole = *self.outputs[at].get(cut.output)?;
        let input = |name: &str| inputs[graph.input(at, name)?];
        let output = |name: &str| node.def.output(name);
        let (function, arguments) = match cut.rule {
            CutRule::Sum => {
                let [first, whole] = [self.channels(at, first)?, self.channels(at, whole)?];
                (SHARE_OF_PART, vec![share, first, whole])
            }
            CutRule::Greatest => {
                let [first, whole] = [self.channels(at, first)?, self.channels(at, whole)?];
                (SHARE_OF_WINNER, vec![share, first, whole])
            }
            CutRule::Over => (SHARE_OF_BELOW, vec![share, first, input("color")?, whole]),
            CutRule::Mean(before, weights) => {
                let weights = *self.outputs[at].get(output(weights)?)?;
                let before = input(before)?;
                let [first, whole] = [self.channels(at, first)?, self.channels(at, whole)?];
                (SHARE_OF_WEIGHT, vec![share, first, before, weights, whole])
            }
            CutRule::Factor(factor) => {
                let factor = input(factor)?;
                let [first, whole] = [self.channels(at, first)?, self.channels(at, whole)?];
                (SHARE_OF_MIXED, vec![share, first, factor, whole])
            }
            CutRule::Winner(before, after) => {
                let after = *self.outputs[at].get(output(after)?)?;
                let [before, after] = [input(before)?, after];
                let [before, after] = [self.channels(at, before)?, self.channels(at, after)?];
                (SHARE_OF_WINNER, vec![share, before, after])
            }
            CutRule::Either => (SHARE_OF_LIGHT, vec![share, first, whole]),
        };
        Some(self.of_library(at, function, &arguments, Type::Vec3))
    }

    /// The channels of a number or a color, as `vec3f`.
    fn channels(&mut self, node: usize, value: ValueId) -> Option<ValueId> {
        let function = match self.values[value].ty {
            Type::Float => NUMBER_CHANNELS,
            Type::Color | Type::Composite | Type::Vec4 => COLOR_CHANNELS,
            Type::Vec3 => return Some(value),
            _ => return None,
        };
        Some(self.of_library(node, function, &[value], Type::Vec3))
    }

    /// The share of what is below that a step's rule lets through, as `vec3f`.
    fn passage(
        &mut self,
        index: usize,
        inputs: &[Option<ValueId>],
        [under, over]: [ValueId; 2],
    ) -> Option<ValueId> {
        let node = &self.graph.nodes[index];
        let word = node.variant().choice.as_ref().map(|(_, word)| word.as_str());
        let of = |name: &str| {
            let place = node.def.inputs.iter().position(|input| input.name.as_str() == name);
            place.and_then(|place| inputs[place])
        };
        let one = self.constant(index, Type::Float, interp::Value::Float(1.0));
        let ones = self.constant(index, Type::Vec3, interp::Value::vec(&[1.0; 3]));
        let (passage, color, tone, opacity) = match Passage::of(node) {
            Some(Passage::Blend) => {
                let known = BLENDED.iter().find(|(mode, _)| Some(*mode) == word);
                let Some((_, passage)) = known else { return Some(ones) };
                (*passage, of("color")?, of("tone"), of("opacity"))
            }
            Some(Passage::Alpha) => ("alpha", of("color")?, None, None),
            Some(Passage::Mix) => {
                let known = MIXED.iter().find(|(mode, _)| Some(*mode) == word);
                let Some((_, passage)) = known else { return Some(ones) };
                let plain = self.constant(index, Type::Color, interp::Value::vec(&[1.0; 4]));
                let color = if *passage == "multiply" { of("b")? } else { plain };
                (*passage, color, None, of("factor"))
            }
            Some(Passage::Greater) => {
                return Some(self.of_library(index, GREATER, &[under, over], Type::Vec3));
            }
            Some(Passage::All) | None => return Some(ones),
        };
        let number = PASSAGES.iter().position(|known| *known == passage).unwrap_or_default();
        let number = self.constant(index, Type::Int, interp::Value::I32(number as i32));
        let arguments = [number, color, tone.unwrap_or(one), opacity.unwrap_or(one)];
        Some(self.of_library(index, PASSAGE, &arguments, Type::Vec3))
    }

    /// A call of a function of the library.
    fn of_library(
        &mut self,
        node: usize,
        function: &str,
        arguments: &[ValueId],
        ty: Type,
    ) -> ValueId {
        let shipped = Library::built_in().nodes.values().next().map(|def| def.module.clone());
        let module = shipped.unwrap_or_else(|| self.graph.nodes[node].def.module.clone());
        let arguments = arguments.iter().map(|&id| Argument::Value(id)).collect();
        let part = Some("contribution".to_owned());
        self.call_function(node, Function { module, name: function.into() }, arguments, ty, part)
    }
}
