//! Calls that stand inside the one call that reads them, as a person would write them.
//!
//! A value gets a line and a name of its own where the artist named its node, where several read
//! it, or where the line would become too long.

use super::Emitter;
use super::parts::Body;
use crate::compile::functions::{CallForm, Code, LINE, level};
use crate::compile::specialize::{Argument, Operation, ValueId};
use crate::ids::{LightId, NodePath};
use crate::library::Rate;

/// Marks around a call within another, in text that is still to be written: where it begins, where
/// the number of its value ends, and where it ends. None of them is a character of WGSL.
const BEGIN: char = '\u{1}';
const TEXT: char = '\u{2}';
const END: char = '\u{3}';

impl Emitter<'_> {
    /// Finds the calls that stand inside others.
    pub(super) fn plan_nesting(&mut self) {
        if self.options.unspecialized {
            return;
        }
        let count = self.special.values.len();
        let mut reads = vec![0_usize; count];
        for &call in &self.calls {
            // What a loop's variables become has lines of its own.
            let count = if self.is_loop(call) { 2 } else { 1 };
            self.call_operands(call, false).into_iter().for_each(|id| reads[id] += count);
        }
        for root in self.roots() {
            // What the look itself gives is no part of a call.
            self.call_operands(root, true).into_iter().for_each(|id| reads[id] += 2);
        }
        self.nested = vec![false; count];
        // Lengths of the calls' expressions, and what a bracket around each would add.
        let mut lengths = vec![0_usize; count];
        for call in self.calls.clone() {
            let name = self.value_names.get(&call).map_or(0, String::len);
            let mut length = self.call(call).0.len();
            let mut inner: Vec<(usize, ValueId)> = self
                .nestable(call)
                .into_iter()
                .filter(|&inner| reads[inner] == 1)
                .map(|inner| {
                    let name = self.value_names.get(&inner).map_or(0, String::len);
                    ((lengths[inner] + "()".len()).saturating_sub(name), inner)
                })
                .collect();
            inner.sort_unstable();
            let room = LINE.saturating_sub("    let  = ;".len() + name);
            for (longer, inner) in inner {
                if length + longer <= room {
                    length += longer;
                    self.nested[inner] = true;
                }
            }
            lengths[call] = length;
        }
        let root = self.special.root;
        let is_returned = reads[root] == 2 && self.special.beside.is_empty();
        if is_returned && lengths[root] > 0 && lengths[root] + "    return ;".len() <= LINE {
            self.nested[root] = self.can_stand_inside(root);
        }
    }

    /// The calls that could stand inside a call: those that it reads once, by one argument.
    fn nestable(&self, call: ValueId) -> Vec<ValueId> {
        let Operation::Call { arguments, .. } = &self.special.values[call].operation else {
            return Vec::new();
        };
        let reads = |index: usize| match self.specialized.get(&call) {
            Some(CallForm::Expression(code, _)) => code.reads(index),
            _ => 1,
        };
        let region = |id: ValueId| &self.graph.nodes[self.special.values[id].node].region;
        let found = arguments.iter().enumerate().filter_map(|(index, argument)| {
            let Argument::Value(id) = argument else { return None };
            let inner = self.call_behind(*id).filter(|_| reads(index) == 1)?;
            let is_near =
                region(inner) == region(call) && self.loop_around(inner) == self.loop_around(call);
            (is_near && self.can_stand_inside(inner)).then_some(inner)
        });
        found.collect()
    }

    /// The call that a value is, or that it is a conversion of.
    fn call_behind(&self, mut id: ValueId) -> Option<ValueId> {
        loop {
            let value = &self.special.values[id];
            match &value.operation {
                _ if value.rate <= Rate::Object => return None,
                Operation::Call { .. } => return Some(id),
                Operation::Convert { template, value } => {
                    let reads_once = match self.specialized.get(&id) {
                        Some(CallForm::Expression(code, _)) => code.reads(0) == 1,
                        _ => is_argument(template),
                    };
                    if !reads_once {
                        return None;
                    }
                    id = *value;
                }
                _ => return None,
            }
        }
    }

    /// True for what nobody named, and what is no constant expression by itself: WGSL would refuse
    /// some of those inside others.
    fn can_stand_inside(&self, call: ValueId) -> bool {
        let value = &self.special.values[call];
        let Operation::Call { arguments, .. } = &value.operation else { return false };
        let changes =
            |id: ValueId| !matches!(self.special.values[id].operation, Operation::Constant(_));
        let is_read = |index: usize| match self.specialized.get(&call) {
            Some(CallForm::Expression(code, _)) => code.reads(index) > 0,
            _ => true,
        };
        // A name is that of what the node gives, not of what it takes to make that.
        !(self.graph.nodes[value.node].is_named && value.part.is_none())
            && arguments.iter().enumerate().any(|(index, argument)| {
                matches!(argument, Argument::Value(id) if changes(*id)) && is_read(index)
            })
    }

    /// True for a call that stands inside the one that reads it.
    pub(super) fn is_nested(&self, id: ValueId) -> bool {
        self.nested.get(id).copied().unwrap_or_default()
    }

    /// A call that stands inside another, with marks around it.
    pub(super) fn nested(&self, id: ValueId) -> Code {
        let (text, mut least) = self.call(id);
        if text.starts_with('-') {
            // Another minus sign may stand before it.
            least = level::SUM;
        }
        Code::Argument(format!("{BEGIN}{id}{TEXT}{text}{END}").into(), least)
    }

    /// Writes a statement that comes from a node, and says which of its bytes came from which.
    pub(super) fn write_value(&self, id: ValueId, marked: &str, depth: usize, body: &mut Body) {
        body.text.push_str(&"    ".repeat(depth));
        let own = body.spans.len();
        body.add_span(body.text.len(), self.origin_of(id), 0);
        let mut open = vec![own];
        let mut number: Option<ValueId> = None;
        for character in marked.chars() {
            match (character, &mut number) {
                (BEGIN, _) => number = Some(0),
                (TEXT, inner) => {
                    if let Some(inner) = inner.take() {
                        open.push(body.spans.len());
                        let depth = open.len() - 1;
                        body.add_span(body.text.len(), self.origin_of(inner), depth);
                    }
                }
                (END, _) => {
                    if let Some(span) = open.pop() {
                        body.end_span(span);
                    }
                }
                (digit, Some(number)) => {
                    *number = *number * 10 + digit.to_digit(10).unwrap_or_default() as usize;
                }
                (character, None) => body.text.push(character),
            }
        }
        body.end_span(own);
        body.break_line(own);
        body.text.push('\n');
    }

    /// The node of a value, and the light that it is about.
    fn origin_of(&self, id: ValueId) -> (NodePath, Option<LightId>) {
        let node = self.special.values[id].node;
        (self.graph.nodes[node].path.clone(), self.single_lights.get(node).cloned().flatten())
    }
}

/// True for a conversion that takes its value as an argument, once.
fn is_argument(template: &str) -> bool {
    let Some((before, after)) = template.split_once('$') else { return false };
    let begins = before.ends_with('(') || before.ends_with(", ");
    begins && after.starts_with([')', ',']) && !after.contains('$')
}
