//! Loops over lights: their variables, the array of what differs from light to light, their text.
//!
//! A loop stands among the calls of the look as one block: the calls of its body lie inside it, and
//! others read its variables once it has run.

use std::collections::HashMap;
use std::fmt::Write as _;

use indexmap::IndexMap;

use super::Emitter;
use super::headings::Statement;
use super::parts::Body;
use crate::compile::functions::write_line;
use crate::compile::host::{ArrayPlace, UniformMember};
use crate::compile::names::Names;
use crate::compile::specialize::{LightLoop, LoopVariable, Operation, ValueId, operands};
use crate::ids::LightId;
use crate::library::Type;

/// Width of a field, by how many numbers of a row it takes.
#[derive(Clone, Copy, PartialEq, Eq)]
enum FieldWidth {
    Struct,
    Four,
    Three,
    Two,
    One,
}

impl FieldWidth {
    fn of(ty: &Type) -> Self {
        match ty {
            ty if is_struct(ty) => Self::Struct,
            Type::Float | Type::Int | Type::Bool => Self::One,
            Type::Vec2 => Self::Two,
            Type::Vec3 => Self::Three,
            _ => Self::Four,
        }
    }
}

/// A loop among the blocks of a function.
#[derive(Clone, Debug)]
pub(super) struct LoopBlock {
    pub(super) value: ValueId,
    index: usize,
    /// Calls of its body that have a line of their own.
    pub(super) calls: Vec<ValueId>,
    /// Values that hold what its variables are at its end.
    pub(super) results: Vec<ValueId>,
}

/// By value: the loop in whose body it is made.
pub(super) fn loops_around(
    values: &[crate::compile::specialize::ComputedValue],
) -> Vec<Option<usize>> {
    let mut around: Vec<Option<usize>> = Vec::with_capacity(values.len());
    for value in values {
        around.push(match &value.operation {
            Operation::LoopVariable { index } | Operation::LoopField { index, .. } => Some(*index),
            Operation::Loop { .. } | Operation::LoopResult { .. } => None,
            // Operands of all others are made before them.
            other => operands(other).find_map(|id| around.get(id).copied().flatten()),
        });
    }
    around
}

impl Emitter<'_> {
    /// The loop in whose body a value is made.
    pub(super) fn loop_around(&self, id: ValueId) -> Option<usize> {
        self.loops_around.get(id).copied().flatten()
    }

    pub(super) fn is_loop(&self, id: ValueId) -> bool {
        matches!(self.special.values[id].operation, Operation::Loop { .. })
    }

    /// Names variables, and the fields of arrays, which become members of the uniform with a step
    /// of the host for each light. Loops over the same lights share their array.
    pub(super) fn plan_loops(&mut self, members: &mut Names) {
        let special = self.special;
        let mut by_lights: Vec<(&[LightId], Vec<usize>)> = Vec::new();
        for id in self.calls.clone() {
            let Operation::Loop { index, .. } = special.values[id].operation else { continue };
            let light_loop = &special.loops[index];
            let counter = self.names.give("each");
            self.counters.insert(index, counter);
            for variable in &light_loop.variables {
                let name = self.wanted_name(variable.before);
                let name = self.names.give(&name);
                self.value_names.insert(variable.before, name);
            }
            match by_lights.iter_mut().find(|(lights, _)| *lights == light_loop.lights) {
                Some((_, loops)) => loops.push(index),
                None => by_lights.push((&light_loop.lights, vec![index])),
            }
        }
        for (_, loops) in by_lights {
            self.plan_array(&loops, members);
        }
        for (id, value) in special.values.iter().enumerate() {
            if let Operation::LoopResult { value, variable } = value.operation
                && let Operation::Loop { index, .. } = special.values[value].operation
            {
                let before = special.loops[index].variables[variable].before;
                if let Some(name) = self.value_names.get(&before).cloned() {
                    self.value_names.insert(id, name);
                }
            }
        }
    }

    /// Makes the array of what these loops read of their lights.
    fn plan_array(&mut self, loops: &[usize], members: &mut Names) {
        let special = self.special;
        // By the values of all rounds: those that read them, each in its loop.
        let mut readers: IndexMap<&[ValueId], Vec<(usize, ValueId)>> = IndexMap::new();
        for (id, value) in special.values.iter().enumerate() {
            if let Operation::LoopField { index, field } = value.operation
                && loops.contains(&index)
            {
                let rounds = special.loops[index].fields[field].as_slice();
                readers.entry(rounds).or_default().push((index, id));
            }
        }
        if readers.is_empty() {
            return;
        }
        let array = members.give("lights");
        let element = self.names.give_exact("EachLight");
        let mut names = Names::default();
        let fields: Vec<(&[ValueId], String)> = self
            .packed(&readers.keys().copied().collect::<Vec<_>>())
            .into_iter()
            .map(|rounds| (rounds, names.give(&self.field_name(rounds[0]))))
            .collect();
        for (rounds, name) in &fields {
            for &(index, id) in readers.get(rounds).into_iter().flatten() {
                let counter = self.counters.get(&index).map_or("", String::as_str);
                let text = format!("look.{array}[{counter}].{name}");
                self.value_names.insert(id, text);
            }
        }
        let count = special.loops[loops[0]].lights.len();
        for index in 0..count {
            for (rounds, field) in &fields {
                let value = rounds[index];
                let step = self.host_step(value);
                self.host.members.push(UniformMember {
                    name: format!("{array}[{index}].{field}"),
                    ty: special.values[value].ty.clone(),
                    origin: self.origin(value),
                    step,
                    offset: 0,
                    place: Some(ArrayPlace {
                        array: array.clone(),
                        element: element.clone(),
                        index,
                        count,
                        field: field.clone(),
                    }),
                });
            }
        }
    }

    /// Name of what differs from light to light: the light's own property, or the node's part.
    fn field_name(&self, id: ValueId) -> String {
        let value = &self.special.values[id];
        let node = &self.graph.nodes[value.node];
        match (&value.operation, &value.part) {
            (Operation::Context(context, Some(_)), _) => {
                let word = context.word();
                word.rsplit('.').next().unwrap_or(word).to_owned()
            }
            (_, Some(part)) => part.clone(),
            _ => node.def.kind.to_string(),
        }
    }

    /// Fields in an order in which little is lost between them: what is wide first, and numbers
    /// behind vectors of three.
    fn packed<'f>(&self, fields: &[&'f [ValueId]]) -> Vec<&'f [ValueId]> {
        let of_width = |wanted: FieldWidth| {
            let is_of = move |field: &&&'f [ValueId]| {
                FieldWidth::of(&self.special.values[field[0]].ty) == wanted
            };
            fields.iter().filter(is_of).copied().collect::<Vec<_>>()
        };
        let mut packed = of_width(FieldWidth::Struct);
        packed.extend(of_width(FieldWidth::Four));
        let mut numbers = of_width(FieldWidth::One).into_iter();
        for three in of_width(FieldWidth::Three) {
            packed.push(three);
            packed.extend(numbers.next());
        }
        packed.extend(of_width(FieldWidth::Two));
        packed.extend(numbers);
        packed
    }

    /// Finds the calls whose results may be written into variables at once: nobody else in the
    /// round reads what these were before.
    pub(super) fn plan_assignments(&mut self) {
        let special = self.special;
        let mut readers: HashMap<ValueId, Vec<ValueId>> = HashMap::new();
        for &call in self.calls.iter().filter(|&&call| self.loop_around(call).is_some()) {
            for operand in operands(&special.values[call].operation) {
                let variable = self.behind(operand);
                if matches!(special.values[variable].operation, Operation::LoopVariable { .. }) {
                    readers.entry(variable).or_default().push(call);
                }
            }
        }
        for LightLoop { variables, .. } in &special.loops {
            for &LoopVariable { before, after, .. } in variables {
                let is_call = matches!(special.values[after].operation, Operation::Call { .. })
                    && self.loop_around(after).is_some();
                let is_read_elsewhere =
                    readers.get(&before).is_some_and(|calls| calls.iter().any(|&c| c != after));
                let is_shared = variables.iter().filter(|other| other.after == after).count() > 1;
                // What the variables of others become may be a value that this one was.
                let is_passed_on = variables.iter().any(|other| self.behind(other.after) == before);
                if is_call && !is_read_elsewhere && !is_shared && !is_passed_on {
                    self.assigned.insert(after, before);
                }
            }
        }
    }

    /// The value that a value is a member or a conversion of, or itself.
    fn behind(&self, mut id: ValueId) -> ValueId {
        while let Operation::Member { value, .. } | Operation::Convert { value, .. } =
            self.special.values[id].operation
        {
            id = value;
        }
        id
    }

    /// A loop as a block, with the calls of its body that do not stand inside others.
    pub(super) fn loop_block(&self, value: ValueId) -> Option<LoopBlock> {
        let Operation::Loop { index, .. } = self.special.values[value].operation else {
            return None;
        };
        let is_own = |call: &&ValueId| self.loop_around(**call) == Some(index);
        let calls = self.calls.iter().filter(is_own).filter(|&&call| !self.is_nested(call));
        let is_result = |id: &ValueId| {
            let operation = &self.special.values[*id].operation;
            matches!(operation, Operation::LoopResult { value: of, .. } if *of == value)
        };
        Some(LoopBlock {
            value,
            index,
            calls: calls.copied().collect(),
            results: (0..self.special.values.len()).filter(is_result).collect(),
        })
    }

    /// The values of other blocks that a loop reads.
    pub(super) fn loop_needs(&self, block: &LoopBlock) -> Vec<ValueId> {
        let calls = block.calls.iter().chain([&block.value]);
        let mut needs: Vec<ValueId> = calls
            .flat_map(|&call| self.call_operands(call, false))
            .filter(|&id| self.loop_around(id).is_none())
            .collect();
        needs.sort_unstable();
        needs.dedup();
        needs
    }

    pub(super) fn write_loop(&mut self, block: &LoopBlock, body: &mut Body) {
        let light_loop = &self.special.loops[block.index];
        let counter = self.counters.get(&block.index).map_or("", String::as_str);
        for variable in &light_loop.variables {
            let first = self.expression(variable.first);
            let name = self.value_names.get(&variable.before).map_or("", String::as_str);
            self.write_value(variable.before, &format!("var {name} = {first};"), 1, body);
        }
        let comment = comment_of(&light_loop.lights);
        let _ = writeln!(
            body.text,
            "    // {comment}\n    for (var {counter} = 0u; {counter} < {}u; {counter}++) {{",
            light_loop.lights.len()
        );
        let statements: Vec<_> = block.calls.iter().map(|&call| Statement::Value(call)).collect();
        for (&call, heading) in block.calls.iter().zip(&self.headings(&statements)) {
            let text = self.call(call).0;
            let line = match self.assigned.get(&call) {
                Some(variable) => {
                    format!("{} = {text};", self.value_names.get(variable).map_or("", |n| n))
                }
                None => {
                    format!("let {} = {text};", self.value_names.get(&call).map_or("", |n| n))
                }
            };
            self.write_heading(heading, (call, &line), 2, body);
            self.write_value(call, &line, 2, body);
        }
        for variable in &light_loop.variables {
            if self.assigned.get(&variable.after) != Some(&variable.before)
                && variable.after != variable.before
            {
                let name = self.value_names.get(&variable.before).map_or("", String::as_str);
                write_line(
                    &format!("{name} = {};", self.expression(variable.after)),
                    2,
                    &mut body.text,
                );
            }
        }
        body.text.push_str("    }\n");
    }

    /// Writes the structs of what differs from light to light.
    pub(super) fn write_element_structs(&mut self) {
        let mut text = String::new();
        let members = &self.host.members;
        let mut last: Option<&str> = None;
        let mut after_struct = false;
        for member in members {
            let Some(place) = member.place.as_ref().filter(|place| place.index == 0) else {
                continue;
            };
            let is_first = last != Some(place.element.as_str());
            if is_first {
                if last.is_some() {
                    text.push_str("}\n\n");
                }
                let _ = writeln!(
                    text,
                    "/// What differs from light to light.\nstruct {} {{",
                    place.element
                );
                after_struct = false;
            }
            last = Some(&place.element);
            // Elements of arrays in uniform buffers stand on 16 bytes.
            let is_struct = is_struct(&member.ty);
            let align = if is_first || is_struct || after_struct { "@align(16) " } else { "" };
            let line = self.member_line(member, &place.field);
            let _ = writeln!(text, "    {align}{line}");
            after_struct = is_struct;
        }
        if last.is_some() {
            text.push_str("}\n\n");
        }
        self.out.push_str(&text);
    }

    /// True if a fragment reads its surface for a block.
    pub(super) fn loop_reads_surface(&self, block: &LoopBlock) -> bool {
        block.calls.iter().chain([&block.value]).any(|&call| self.reads_surface(call))
    }
}

/// True for types that uniform buffers want on 16 bytes, and what follows them.
pub(super) fn is_struct(ty: &Type) -> bool {
    matches!(ty, Type::Prepared(_) | Type::Angle | Type::Light | Type::Curve | Type::Ramp)
}

/// Most lights that a comment names.
const MOST_NAMED: usize = 6;

fn comment_of(lights: &[LightId]) -> String {
    let named: Vec<&str> = lights.iter().take(MOST_NAMED).map(LightId::as_str).collect();
    let more = match lights.len().saturating_sub(MOST_NAMED) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    format!("For each light: {}{more}.", named.join(", "))
}
