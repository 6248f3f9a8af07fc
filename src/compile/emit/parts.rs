//! The look itself as functions of bounded length.
//!
//! naga's front end is quadratic in a function's length and people are not much better, so a long look becomes several
//! functions, split where the artist's groups and frames are. What one part needs of another goes through parameters
//! and results.

use std::collections::{HashMap, HashSet};
use std::fmt::Write as _;
use std::ops::Range;

use super::Emitter;
use crate::compile::Stage;
use crate::compile::specialize::{Operation, ValueId, operands};
use crate::ids::NodePath;
use crate::library::{Rate, Type};

/// A look of at most this many calls is one function.
const SHORT: usize = 60;
/// The most calls in a part.
const LONGEST: usize = 50;
/// From this many calls on, a part ends where a group or frame does.
const WORTH_A_PART: usize = 8;
/// A part that would need more values from outside ends sooner; WGSL allows 255 parameters.
const MOST_PARAMETERS: usize = 64;

/// The functions' text, with spans relative to its start.
#[derive(Debug, Default)]
pub(super) struct Body {
    pub(super) text: String,
    pub(super) spans: Vec<(Range<usize>, NodePath)>,
}

struct Part {
    name: String,
    calls: Range<usize>,
    inputs: Vec<ValueId>,
    outputs: Vec<ValueId>,
}

impl Emitter<'_> {
    pub(super) fn look_functions(&mut self) -> Body {
        let mut body = Body::default();
        let parts = if self.calls.len() <= SHORT { Vec::new() } else { self.parts() };
        let mut renamed: HashMap<ValueId, String> = HashMap::new();
        for part in &parts {
            self.write_part(part, &mut body);
            // Seen from `shade`, a part's values go by the variable that holds its result.
            let variable = self.names.give(&format!("{}_result", part.name));
            for &output in &part.outputs {
                let local = self.value_names.get(&output).cloned().unwrap_or_default();
                let text = if part.outputs.len() == 1 { variable.clone() } else { format!("{variable}.{local}") };
                renamed.insert(output, text);
            }
        }
        let locals = self.value_names.clone();
        if !parts.is_empty() {
            for &id in &self.calls {
                self.value_names.remove(&id);
            }
            self.value_names.extend(renamed.iter().map(|(id, name)| (*id, name.clone())));
        }
        self.write_shade(&parts, &mut body);
        self.value_names = locals;
        body
    }

    fn write_shade(&mut self, parts: &[Part], body: &mut Body) {
        let parameters = if self.has_surface() { "surface: Surface" } else { "" };
        let comment = match self.options.stage {
            Stage::Normals | Stage::DetailNormals => "/// The normal that the curvature pass sees.",
            Stage::Draw | Stage::Eval => "/// The look at one point of the surface.",
        };
        let root = self.special.root;
        let root_type = self.type_name(&self.special.values[root].ty, self.special.values[root].node);
        let with_cutoff = self.special.cutoff.is_some();
        let result = if with_cutoff { "Shaded".to_owned() } else { root_type.clone() };
        if with_cutoff {
            let color_type = self.special.color.map_or(Type::Color, |color| self.special.values[color].ty.clone());
            let _ = writeln!(
                body.text,
                "struct Shaded {{\n    value: {root_type},\n    color: {},\n    cutoff: f32,\n}}\n",
                color_type.wgsl()
            );
        }
        let _ = writeln!(body.text, "{comment}\nfn shade({parameters}) -> {result} {{");
        if parts.is_empty() {
            for index in 0..self.calls.len() {
                self.write_call(self.calls[index], body);
            }
        }
        for part in parts {
            let arguments = self.arguments(part);
            let first = part.outputs.first().and_then(|id| self.value_names.get(id)).cloned().unwrap_or_default();
            let variable = first.split('.').next().unwrap_or_default();
            let _ = writeln!(body.text, "    let {variable} = {}({});", part.name, arguments.join(", "));
        }
        let value = self.expression(root);
        if let (Some(cutoff), Some(color)) = (self.special.cutoff, self.special.color) {
            let _ = writeln!(
                body.text,
                "    return Shaded({value}, {}, {});",
                self.expression(color),
                self.expression(cutoff)
            );
        } else {
            let _ = writeln!(body.text, "    return {value};");
        }
        body.text.push_str("}\n");
    }

    pub(super) fn has_surface(&self) -> bool {
        !self.needs.contexts.is_empty()
    }

    fn arguments(&self, part: &Part) -> Vec<String> {
        let surface = self.part_uses_surface(part).then(|| "surface".to_owned());
        surface.into_iter().chain(part.inputs.iter().map(|&input| self.expression(input))).collect()
    }

    fn part_uses_surface(&self, part: &Part) -> bool {
        self.calls[part.calls.clone()].iter().any(|&call| {
            let mut open: Vec<ValueId> = operands(&self.special.values[call].operation).collect();
            while let Some(id) = open.pop() {
                let value = &self.special.values[id];
                match &value.operation {
                    Operation::Context(..) if value.rate == Rate::Fragment => return true,
                    Operation::Member { value, .. } | Operation::Convert { value, .. } => open.push(*value),
                    _ => {}
                }
            }
            false
        })
    }

    fn write_call(&self, id: ValueId, body: &mut Body) {
        let name = self.value_names.get(&id).map_or("", String::as_str);
        let path = self.graph.nodes[self.special.values[id].node].path.clone();
        body.text.push_str("    ");
        let start = body.text.len();
        let _ = write!(body.text, "let {name} = {};", self.call(id));
        body.spans.push((start..body.text.len(), path));
        body.text.push('\n');
    }

    fn write_part(&mut self, part: &Part, body: &mut Body) {
        let result = match part.outputs.as_slice() {
            [one] => self.value_type(*one),
            _ => {
                let name = self.names.give(&format!("{}_values", part.name));
                let _ = writeln!(body.text, "struct {name} {{");
                for &output in &part.outputs {
                    let member = self.value_names.get(&output).cloned().unwrap_or_default();
                    let _ = writeln!(body.text, "    {member}: {},", self.value_type(output));
                }
                body.text.push_str("}\n\n");
                name
            }
        };
        let mut parameters = Vec::new();
        if self.part_uses_surface(part) {
            parameters.push("surface: Surface".to_owned());
        }
        for &input in &part.inputs {
            let name = self.value_names.get(&input).cloned().unwrap_or_default();
            parameters.push(format!("{name}: {}", self.value_type(input)));
        }
        let _ = writeln!(body.text, "fn {}({}) -> {result} {{", part.name, parameters.join(", "));
        for index in part.calls.clone() {
            self.write_call(self.calls[index], body);
        }
        let values: Vec<String> = part.outputs.iter().map(|&output| self.expression(output)).collect();
        let value =
            if let [one] = values.as_slice() { one.clone() } else { format!("{result}({})", values.join(", ")) };
        let _ = writeln!(body.text, "    return {value};\n}}\n");
    }

    fn value_type(&self, id: ValueId) -> String {
        self.type_name(&self.special.values[id].ty, self.special.values[id].node)
    }

    /// Cuts the calls into parts, then finds what each needs and gives.
    fn parts(&mut self) -> Vec<Part> {
        let ranges = self.part_ranges();
        let mut part_of: HashMap<ValueId, usize> = HashMap::new();
        for (index, range) in ranges.iter().enumerate() {
            part_of.extend(self.calls[range.clone()].iter().map(|&id| (id, index)));
        }
        let mut inputs: Vec<Vec<ValueId>> = vec![Vec::new(); ranges.len()];
        let mut is_output: HashSet<ValueId> =
            self.roots().into_iter().flat_map(|root| self.call_operands(root, true)).collect();
        for (index, range) in ranges.iter().enumerate() {
            let mut seen = HashSet::new();
            for &call in &self.calls[range.clone()] {
                for operand in self.call_operands(call, false) {
                    if part_of.get(&operand) != Some(&index) && seen.insert(operand) {
                        inputs[index].push(operand);
                        is_output.insert(operand);
                    }
                }
            }
        }
        let mut parts = Vec::new();
        for (range, inputs) in ranges.into_iter().zip(inputs) {
            let outputs = self.calls[range.clone()].iter().copied().filter(|id| is_output.contains(id)).collect();
            let wanted = self.part_name(&range);
            parts.push(Part { name: self.names.give(&wanted), calls: range, inputs, outputs });
        }
        parts
    }

    /// The calls that a value reads, through members and conversions; the value itself, if it is one and `or_itself`.
    fn call_operands(&self, id: ValueId, or_itself: bool) -> Vec<ValueId> {
        let is_call = |id: ValueId| {
            let value = &self.special.values[id];
            value.rate > Rate::Object && matches!(value.operation, Operation::Call { .. })
        };
        if or_itself && is_call(id) {
            return vec![id];
        }
        let mut found = Vec::new();
        let mut open: Vec<ValueId> = operands(&self.special.values[id].operation).collect();
        while let Some(id) = open.pop() {
            if is_call(id) {
                found.push(id);
            } else if self.special.values[id].rate > Rate::Object {
                open.extend(operands(&self.special.values[id].operation));
            }
        }
        found
    }

    fn region(&self, call: ValueId) -> Option<&str> {
        self.graph.nodes[self.special.values[call].node].region.as_deref()
    }

    fn part_ranges(&self) -> Vec<Range<usize>> {
        let mut ranges = Vec::new();
        let mut start = 0;
        let mut inside: HashSet<ValueId> = HashSet::new();
        let mut outside: HashSet<ValueId> = HashSet::new();
        for index in 0..self.calls.len() {
            let call = self.calls[index];
            let length = index - start;
            let leaves_region = index > start && self.region(call) != self.region(self.calls[index - 1]);
            let is_full = length >= LONGEST || outside.len() >= MOST_PARAMETERS;
            if length > 0 && (is_full || (leaves_region && length >= WORTH_A_PART)) {
                ranges.push(start..index);
                start = index;
                inside.clear();
                outside.clear();
            }
            outside.extend(self.call_operands(call, false).into_iter().filter(|operand| !inside.contains(operand)));
            inside.insert(call);
        }
        if start < self.calls.len() {
            ranges.push(start..self.calls.len());
        }
        ranges
    }

    fn part_name(&self, range: &Range<usize>) -> String {
        let first = self.region(self.calls[range.start]);
        let is_one_region = self.calls[range.clone()].iter().all(|&call| self.region(call) == first);
        match first {
            Some(region) if is_one_region => region.to_owned(),
            _ => "part".to_owned(),
        }
    }
}
