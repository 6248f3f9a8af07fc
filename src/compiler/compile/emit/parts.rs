//! The look itself as functions of bounded length.
//!
//! naga's front end is quadratic in a function's length and people are not much better, so a long
//! look becomes several functions, split where the artist's groups and frames are; where there are
//! many of those, they are gathered into longer ones in turn. What one part needs of another goes
//! through parameters and results.
//!
//! Drivers put the functions together again, and take a time that is quadratic in the number of
//! operations without a branch between them, and a stack that is as deep as operations follow from
//! one another. So a few parts of a long look are *barriers*: they are called in a loop whose only
//! round no compiler knows.

use std::collections::{HashMap, HashSet};
use std::fmt::Write as _;
use std::ops::Range;

use super::headings::{Heading, Statement};
use super::loops::LoopBlock;
use super::{Emitter, Span};
use crate::compile::functions::{LINE, write_line};
use crate::compile::specialize::{NamedOutput, Operation, ValueId, operands};
use crate::ids::{LightId, NodePath};
use crate::library::Rate;

/// A function of at most this many blocks is left whole.
const SHORT: usize = 60;
/// The most blocks in a part.
const LONGEST: usize = 50;
/// From this many calls on, a part ends where a group or frame does.
const WORTH_A_PART: usize = 8;
/// A part that takes or gives more values than this ends sooner; WGSL allows 255 parameters and
/// 1023 members.
const MOST_VALUES: usize = 64;

/// Number of operations of a piece of a long look: from two pieces on it has barriers between them.
///
/// Measured on software Vulkan (Mesa 22.3, LLVM 15): a chain of 5,000 sums, products, sines and
/// absolute values is compiled in 3.6 s as one piece and in 1.8 s as six, one of 10,000 in 11.3 s
/// and in 3.8 s.
const STRETCH: u64 = 2_500;
/// The most loops of a look with barriers, those of its nodes included. More are worse than none:
/// software Vulkan counts the rounds of all loops together, and what LLVM finds out about that
/// count grows exponentially with the number of loops: ten take no time, and with twenty a chain of
/// 5,000 was not compiled in a minute and a half.
const MOST_LOOPS: u64 = 9;

/// The functions' text, with spans relative to its start.
#[derive(Debug, Default)]
pub(super) struct Body {
    pub(super) text: String,
    pub(super) spans: Vec<Span>,
    /// Types of the results of barriers, by the names of their functions.
    barriers: HashMap<String, String>,
}

impl Body {
    /// Begins a stretch of text that comes from a node.
    pub(super) fn add_span(
        &mut self,
        start: usize,
        (path, light): (NodePath, Option<LightId>),
        depth: usize,
    ) {
        self.spans.push(Span { bytes: start..start, path, light, depth });
    }

    /// Ends a stretch where the text ends now.
    pub(super) fn end_span(&mut self, index: usize) {
        if let Some(span) = self.spans.get_mut(index) {
            span.bytes.end = self.text.len();
        }
    }

    /// Breaks the last line where it is too long; it has the stretches from this one on.
    pub(super) fn break_line(&mut self, first_span: usize) {
        let start = self.text.rfind('\n').map_or(0, |at| at + 1);
        if self.text.len() - start <= LINE {
            return;
        }
        let line = self.text.split_off(start);
        let text = line.trim_start();
        let mut broken = String::new();
        write_line(text, (line.len() - text.len()) / 4, &mut broken);
        let broken = broken.trim_end();
        // A blank of the line became the end of one, and the next one's indentation.
        let mut moved = Vec::with_capacity(line.len() + 1);
        let mut to = 0;
        for byte in line.bytes() {
            moved.push(start + to);
            to += 1;
            if byte == b' ' && broken.as_bytes().get(to - 1) == Some(&b'\n') {
                to += broken[to..].len() - broken[to..].trim_start().len();
            }
        }
        moved.push(start + to);
        self.text.push_str(broken);
        for span in &mut self.spans[first_span..] {
            let place = |at: usize| moved.get(at - start).copied().unwrap_or(at);
            span.bytes = place(span.bytes.start)..place(span.bytes.end);
        }
    }
}

/// One `let` of a function, or a loop.
enum Block {
    Call(ValueId),
    Part(ShaderFunction),
    Loop(LoopBlock),
}

/// A function of its own.
struct ShaderFunction {
    name: String,
    /// Name of the variable that holds the function's result in its caller.
    variable: String,
    blocks: Vec<Block>,
    inputs: Vec<ValueId>,
    outputs: Vec<ValueId>,
    reads_surface: bool,
    /// True if the function is called in a loop whose only round no compiler knows.
    is_barrier: bool,
}

impl Emitter<'_> {
    pub(super) fn look_functions(&mut self) -> Body {
        let mut body = Body::default();
        let blocks = self.blocks();
        if self.barrier_names.is_some() {
            self.write_turns(&mut body);
        }
        for block in &blocks {
            if let Block::Part(part) = block {
                self.write_part(part, &mut body);
            }
        }
        self.write_shade(&blocks, &mut body);
        body
    }

    fn write_shade(&mut self, blocks: &[Block], body: &mut Body) {
        let parameters = if self.has_surface() { "surface: Surface" } else { "" };
        let comment = self.options.stage.row().shade;
        let root = self.special.root;
        let root_type =
            self.type_name(&self.special.values[root].ty, self.special.values[root].node);
        let is_alone = self.special.beside.is_empty();
        let result = if is_alone { root_type.clone() } else { "Shaded".to_owned() };
        if !is_alone {
            let _ = writeln!(body.text, "struct Shaded {{\n    value: {root_type},");
            for NamedOutput { name, value } in &self.special.beside {
                let ty = self.value_type(*value);
                let _ = writeln!(body.text, "    {name}: {ty},");
            }
            body.text.push_str("}\n\n");
        }
        let _ = writeln!(body.text, "/// {comment}\nfn shade({parameters}) -> {result} {{");
        let inherited = self.write_blocks(blocks, body);
        let value = self.expression(root);
        if is_alone {
            let statement = format!("return {value};");
            if self.is_nested(root) {
                let mut statements = statements(blocks);
                statements.push(Statement::Value(root));
                let heading = self.headings(&statements).pop().unwrap_or_default();
                self.write_heading(&heading, (root, &statement), 1, body);
            }
            self.write_value(root, &statement, 1, body);
        } else {
            let beside = self.special.beside.iter().map(|output| self.expression(output.value));
            let all: Vec<String> = std::iter::once(value).chain(beside).collect();
            let _ = writeln!(body.text, "    return Shaded({});", all.join(", "));
        }
        body.text.push_str("}\n");
        self.value_names.extend(inherited);
    }

    pub(super) fn has_surface(&self) -> bool {
        !self.needs.contexts.is_empty()
    }

    pub(super) fn reads_surface(&self, call: ValueId) -> bool {
        let mut open: Vec<ValueId> = operands(&self.special.values[call].operation).collect();
        while let Some(id) = open.pop() {
            let value = &self.special.values[id];
            match &value.operation {
                Operation::Context(context, _)
                    if value.rate == Rate::Fragment && !context.is_resource() =>
                {
                    return true;
                }
                Operation::Member { value, .. } | Operation::Convert { value, .. } => {
                    open.push(*value);
                }
                Operation::Call { .. } if self.is_nested(id) => {
                    open.extend(operands(&value.operation));
                }
                _ => {}
            }
        }
        false
    }

    /// Writes one `let` a block, and from then on calls the results of parts as this function does.
    /// Gives back what the values were called before, to be restored after the function's end.
    fn write_blocks(&mut self, blocks: &[Block], body: &mut Body) -> HashMap<ValueId, String> {
        let mut before = HashMap::new();
        let headings = self.headings(&statements(blocks));
        for (block, heading) in blocks.iter().zip(&headings) {
            let part = match block {
                Block::Call(call) => {
                    self.write_call(*call, heading, body);
                    continue;
                }
                Block::Loop(block) => {
                    heading.write_gap(body);
                    self.write_loop(block, body);
                    continue;
                }
                Block::Part(part) => part,
            };
            heading.write_gap(body);
            let surface = part.reads_surface.then(|| "surface".to_owned());
            let arguments: Vec<String> = surface
                .into_iter()
                .chain(part.inputs.iter().map(|&input| self.expression(input)))
                .collect();
            let call = format!("{}({})", part.name, arguments.join(", "));
            let variable = &part.variable;
            match (body.barriers.get(&part.name), &self.barrier_names) {
                (Some(result), Some([turns, turn])) => {
                    let _ = writeln!(
                        body.text,
                        "    var {variable}: {result};\n    \
                         for (var {turn} = 0u; {turn} < {turns}(); {turn}++) {{"
                    );
                    write_line(&format!("{variable} = {call};"), 2, &mut body.text);
                    body.text.push_str("    }\n");
                }
                _ => write_line(&format!("let {variable} = {call};"), 1, &mut body.text),
            }
            for &output in &part.outputs {
                let member = self.value_names.get(&output).cloned().unwrap_or_default();
                let text = if part.outputs.len() == 1 {
                    part.variable.clone()
                } else {
                    format!("{}.{member}", part.variable)
                };
                self.value_names.insert(output, text);
                before.insert(output, member);
            }
        }
        before
    }

    fn write_call(&self, id: ValueId, heading: &Heading, body: &mut Body) {
        let name = self.value_names.get(&id).map_or("", String::as_str);
        let statement = format!("let {name} = {};", self.call(id).0);
        self.write_heading(heading, (id, &statement), 1, body);
        self.write_value(id, &statement, 1, body);
    }

    /// Writes a part after the parts that it calls; their depth is the logarithm of the look's
    /// length.
    fn write_part(&mut self, part: &ShaderFunction, body: &mut Body) {
        for block in &part.blocks {
            if let Block::Part(inner) = block {
                self.write_part(inner, body);
            }
        }
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
        if part.is_barrier {
            body.barriers.insert(part.name.clone(), result.clone());
        }
        let mut parameters = Vec::new();
        if part.reads_surface {
            parameters.push("surface: Surface".to_owned());
        }
        for &input in &part.inputs {
            let name = self.value_names.get(&input).cloned().unwrap_or_default();
            parameters.push(format!("{name}: {}", self.value_type(input)));
        }
        let parameters = parameters.join(", ");
        write_line(&format!("fn {}({parameters}) -> {result} {{", part.name), 0, &mut body.text);
        let inherited = self.write_blocks(&part.blocks, body);
        let values: Vec<String> =
            part.outputs.iter().map(|&output| self.expression(output)).collect();
        let value = if let [one] = values.as_slice() {
            one.clone()
        } else {
            format!("{result}({})", values.join(", "))
        };
        write_line(&format!("return {value};"), 1, &mut body.text);
        body.text.push_str("}\n\n");
        self.value_names.extend(inherited);
    }

    fn value_type(&self, id: ValueId) -> String {
        self.type_name(&self.special.values[id].ty, self.special.values[id].node)
    }

    /// Blocks of `shade`: the look's calls, gathered into parts until the blocks are few.
    fn blocks(&mut self) -> Vec<Block> {
        let is_outside = |call: &&ValueId| self.loop_around(**call).is_none();
        let calls = self.calls.iter().filter(|&&call| !self.is_nested(call)).filter(is_outside);
        let block = |&call: &ValueId| match self.loop_block(call) {
            Some(block) => Block::Loop(block),
            None => Block::Call(call),
        };
        let mut blocks: Vec<Block> = calls.map(block).collect();
        let count = blocks.len();
        while blocks.len() > SHORT {
            let before = blocks.len();
            let is_first = before == count;
            blocks = self.gathered(blocks);
            if is_first {
                self.place_barriers(&mut blocks);
            }
            if blocks.len() == before {
                break; // Each needs so much from outside that nothing is won by one more level.
            }
        }
        blocks
    }

    /// Makes parts of a long look barriers, at equal distances; none where nodes have loops enough.
    fn place_barriers(&mut self, parts: &mut [Block]) {
        if self.options.unspecialized {
            return; // Drivers never see it.
        }
        let operations: u64 = self.shortened.values().map(|[_, left]| left).sum();
        let loops: u64 = self.calls.iter().map(|&call| self.loops(call)).sum();
        let wanted = (operations.max(self.calls.len() as u64) / STRETCH)
            .saturating_sub(1)
            .min(MOST_LOOPS.saturating_sub(loops));
        let wanted = usize::try_from(wanted).unwrap_or_default();
        let count = parts.len();
        for index in (1..=wanted).map(|barrier| barrier * count / (wanted + 1)) {
            if let Block::Part(part) = &mut parts[index] {
                part.is_barrier = true;
                self.barrier_names
                    .get_or_insert_with(|| ["turns", "turn"].map(|name| self.names.give(name)));
            }
        }
    }

    /// Number of loops of the function that a call calls.
    fn loops(&self, call: ValueId) -> u64 {
        match &self.special.values[call].operation {
            Operation::Call { function, .. } => function.module.loops(&function.name),
            Operation::Loop { .. } => 1,
            _ => 0,
        }
    }

    /// Writes the function that gives the number of rounds of the loops of barriers: 1, from a
    /// value that only the host knows. Two rounds would have the same result.
    fn write_turns(&self, body: &mut Body) {
        let Some([turns, _]) = &self.barrier_names else { return };
        // A view's eye has 0 or 1 there, and an array at least one element.
        let never = match self.options.stage.draws_meshes() {
            true => "view.eye.w > 1.5",
            false => "arrayLength(&samples) == 0u",
        };
        let _ = writeln!(
            body.text,
            "/// Rounds of the loops that keep a driver from compiling a long look in one piece: \
             always 1.\nfn {turns}() -> u32 {{\n    return select(1u, 2u, {never});\n}}\n"
        );
    }

    /// One level of parts over these blocks.
    fn gathered(&mut self, blocks: Vec<Block>) -> Vec<Block> {
        let last_use = self.last_uses(&blocks);
        let ranges = self.part_ranges(&blocks, &last_use);
        let mut blocks = blocks.into_iter();
        let mut gathered = Vec::with_capacity(ranges.len());
        for range in ranges {
            let mut inner: Vec<Block> = blocks.by_ref().take(range.len()).collect();
            if let [Block::Part(_)] = inner.as_slice() {
                gathered.append(&mut inner);
                continue;
            }
            let mut given: HashSet<ValueId> = HashSet::new();
            let mut seen = HashSet::new();
            let (mut inputs, mut outputs) = (Vec::new(), Vec::new());
            for block in &inner {
                inputs.extend(
                    self.needs(block)
                        .into_iter()
                        .filter(|need| !given.contains(need) && seen.insert(*need)),
                );
                given.extend(gives(block));
                outputs.extend(
                    gives(block).iter().filter(|value| is_used_from(&last_use, **value, range.end)),
                );
            }
            let reads_surface = inner.iter().any(|block| match block {
                Block::Call(call) => self.reads_surface(*call),
                Block::Part(part) => part.reads_surface,
                Block::Loop(block) => self.loop_reads_surface(block),
            });
            let wanted = self.part_name(&inner);
            let name = self.names.give(&wanted);
            gathered.push(Block::Part(ShaderFunction {
                variable: String::new(),
                name,
                blocks: inner,
                inputs,
                outputs,
                reads_surface,
                is_barrier: false,
            }));
        }
        for block in &mut gathered {
            if let Block::Part(part) = block
                && part.variable.is_empty()
            {
                part.variable = self.names.give(&format!("{}_result", part.name));
            }
        }
        gathered
    }

    /// The last block that reads each value; the end for what the look itself gives.
    fn last_uses(&self, blocks: &[Block]) -> HashMap<ValueId, usize> {
        let mut last_use = HashMap::new();
        for (index, block) in blocks.iter().enumerate() {
            last_use.extend(self.needs(block).into_iter().map(|value| (value, index)));
        }
        let roots = self.roots().into_iter().flat_map(|root| self.call_operands(root, true));
        last_use.extend(roots.map(|value| (value, blocks.len())));
        last_use
    }

    /// The values of other blocks that a block reads.
    fn needs(&self, block: &Block) -> Vec<ValueId> {
        match block {
            Block::Call(call) => self.call_operands(*call, false),
            Block::Part(part) => part.inputs.clone(),
            Block::Loop(block) => self.loop_needs(block),
        }
    }

    /// The calls and results of loops that a value reads, through members, conversions and calls
    /// that stand inside; the value itself, if it is one and `or_itself`.
    pub(super) fn call_operands(&self, id: ValueId, or_itself: bool) -> Vec<ValueId> {
        let is_call = |id: ValueId| {
            let value = &self.special.values[id];
            let is_fragment = value.rate > Rate::Object && !self.is_nested(id);
            let is_named =
                matches!(value.operation, Operation::Call { .. } | Operation::LoopResult { .. });
            is_fragment && is_named
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

    /// Beginnings and ends of parts: none too long, none that exchanges too many values, and where
    /// groups do.
    fn part_ranges(
        &self,
        blocks: &[Block],
        last_use: &HashMap<ValueId, usize>,
    ) -> Vec<Range<usize>> {
        let mut ranges = Vec::new();
        let mut start = 0;
        let mut inside: HashSet<ValueId> = HashSet::new();
        let mut outside: HashSet<ValueId> = HashSet::new();
        for (index, block) in blocks.iter().enumerate() {
            let length = index - start;
            let leaves_region =
                index > start && self.region(block) != self.region(&blocks[index - 1]);
            let given =
                inside.iter().filter(|value| is_used_from(last_use, **value, index)).count();
            let is_full = length >= LONGEST || outside.len() >= MOST_VALUES || given >= MOST_VALUES;
            if length > 0 && (is_full || (leaves_region && length >= WORTH_A_PART)) {
                ranges.push(start..index);
                start = index;
                inside.clear();
                outside.clear();
            }
            outside.extend(self.needs(block).into_iter().filter(|value| !inside.contains(value)));
            inside.extend(gives(block));
        }
        if start < blocks.len() {
            ranges.push(start..blocks.len());
        }
        ranges
    }

    /// The group or frame that a call came from; parts of parts have none.
    fn region(&self, block: &Block) -> Option<&str> {
        match block {
            Block::Call(call) => {
                self.graph.nodes[self.special.values[*call].node].region.as_deref()
            }
            Block::Loop(block) => {
                self.graph.nodes[self.special.values[block.value].node].region.as_deref()
            }
            Block::Part(_) => None,
        }
    }

    fn part_name(&self, blocks: &[Block]) -> String {
        let first = blocks.first().and_then(|block| self.region(block));
        let is_one_region = blocks.iter().all(|block| self.region(block) == first);
        match first {
            Some(region) if is_one_region => region.to_owned(),
            _ => "part".to_owned(),
        }
    }
}

fn statements(blocks: &[Block]) -> Vec<Statement> {
    let statement = |block: &Block| match block {
        Block::Call(call) => Statement::Value(*call),
        Block::Part(_) => Statement::Part,
        Block::Loop(_) => Statement::Loop,
    };
    blocks.iter().map(statement).collect()
}

fn gives(block: &Block) -> &[ValueId] {
    match block {
        Block::Call(call) => std::slice::from_ref(call),
        Block::Part(part) => &part.outputs,
        Block::Loop(block) => &block.results,
    }
}

fn is_used_from(last_use: &HashMap<ValueId, usize>, value: ValueId, block: usize) -> bool {
    last_use.get(&value).is_some_and(|&last| last >= block)
}
