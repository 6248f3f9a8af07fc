//! Writes a specialized look as WGSL.
//!
//! The module is: a header, the structs and bindings of the frame around it, the library's
//! declarations that are used, then the look itself as `shade` and, for long looks, functions of
//! bounded length that it calls, and last the entry points. Values known before the fragment stand
//! in the `Look` uniform or as literals.
//!
//! Calls of nodes stand in the order of `Emitter::order_calls`: depth first from the roots, each
//! call after those that it reads. `parts` cuts that order into functions and keeps it.

mod attributes;
mod expression;
mod frame;
mod headings;
mod loops;
mod nesting;
mod parts;
mod surface;

use std::collections::{BTreeMap, HashMap, HashSet};
use std::fmt::Write as _;
use std::ops::Range;
use std::rc::Rc;
use std::sync::Arc;

use super::CompileOptions;
use super::about::single_lights;
use super::check::TypedGraph;
use super::functions::{CallForm, Code, SpecializedFunctions, module_key, write_line};
use super::host::{
    Callee, HostDriver, HostProgram, ProgramStep, UniformMember, conversion_program,
};
use super::intervals::{self, Ranges};
use super::items::{CollectedItems, Items};
use super::names::Names;
use super::removal::{Proof, Removal};
use super::specialize::{
    Argument, Needs, Operation, SpecializedGraph, ValueId, operands, reachable,
};
use crate::diag::Diagnostic;
use crate::document::Tier;
use crate::ids::{LightId, NodePath};
use crate::library::{Context, Library, NodeModule, PassId, Rate, Treatment, Type};
use crate::wgsl::WgslError;

pub(super) use expression::float_literal;

pub use attributes::VertexAttribute;
use chiaro_locale::tr;
pub use frame::SAMPLES_PER_ROW;

/// A binding of the module, in group 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Binding {
    /// Number of the part.
    pub binding: u32,
    /// The variable's name.
    pub name: String,
    /// Contents of the binding.
    pub kind: BindingKind,
}

/// Contents of a binding.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum BindingKind {
    /// The `View` uniform.
    View,
    /// The `Object` uniform.
    Object,
    /// The `Look` uniform.
    Look,
    /// An image, by index into [`Needs::images`].
    Image(ImageBinding),
    /// A hand-painted 6D texture, by index into [`Needs::images`].
    Hcbtf(ImageBinding),
    /// An image's sampler, by index into [`Needs::images`].
    Sampler(ImageBinding),
    /// The first result of a pass: one texel a pixel, or a layer for each light.
    Pass(PassId),
    /// The triangles of all objects that cast shadows.
    Casters,
    /// The samples of an evaluation.
    Samples,
}

/// An index into [`Needs::images`].
pub type ImageBinding = usize;

/// Stretch of the source that came from a node.
#[derive(Clone, Debug, PartialEq)]
struct Span {
    bytes: Range<usize>,
    path: NodePath,
    /// The light that the node's value is about, of modules that are compiled as they are written.
    light: Option<LightId>,
    /// The number of stretches around this one.
    depth: usize,
}

/// Map from the bytes of the source to the nodes that they came from.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SpanMap {
    /// By their starts; those around others before these.
    spans: Vec<Span>,
}

impl SpanMap {
    /// The node that a byte came from.
    pub fn node_at(&self, offset: usize) -> Option<&NodePath> {
        self.node_of(&(offset..offset + 1))
    }

    /// The node that all of these bytes came from: the innermost of those that stand inside one
    /// another.
    pub fn node_of(&self, bytes: &Range<usize>) -> Option<&NodePath> {
        self.innermost(bytes).map(|span| &span.path)
    }

    /// The light that the value of a byte's node is about, where that is one alone. Known in
    /// modules that are compiled as they are written: in others one value may be that of several
    /// lights.
    pub fn light_at(&self, offset: usize) -> Option<&LightId> {
        self.innermost(&(offset..offset + 1))?.light.as_ref()
    }

    fn innermost(&self, bytes: &Range<usize>) -> Option<&Span> {
        let after = self.spans.partition_point(|span| span.bytes.start <= bytes.start);
        for span in self.spans[..after].iter().rev() {
            if span.bytes.start <= bytes.start && bytes.end <= span.bytes.end {
                return Some(span);
            }
            if span.depth == 0 {
                break;
            }
        }
        None
    }

    /// The nodes that any bytes came from, one for each stretch of bytes.
    pub fn nodes(&self) -> impl Iterator<Item = &NodePath> {
        self.spans.iter().map(|span| &span.path)
    }

    /// The bytes that came from a node, or from the nodes inside a group.
    pub fn spans_of<'m>(&'m self, path: &'m NodePath) -> impl Iterator<Item = Range<usize>> + 'm {
        let is_of = move |found: &NodePath| found.ids().starts_with(path.ids());
        self.spans.iter().filter(move |span| is_of(&span.path)).map(|span| span.bytes.clone())
    }
}

/// Module as it was written, before naga has seen it.
#[derive(Debug)]
pub(super) struct EmittedModule {
    pub(super) text: String,
    pub(super) host: HostProgram,
    pub(super) needs: Needs,
    pub(super) bindings: Vec<Binding>,
    pub(super) spans: SpanMap,
    pub(super) root_type: Type,
    pub(super) removed_within: Vec<Removal>,
}

impl EmittedModule {
    /// naga refused what we wrote: a mistake of ours, reported with the node it concerns.
    pub(super) fn refused(&self, error: &WgslError) -> Diagnostic {
        let start = error.span.as_ref().map_or(0, |span| span.start);
        let line = crate::diag::LineColumn::of(&self.text, start).line as usize;
        let source = self.text.lines().nth(line - 1).unwrap_or_default().trim();
        let message = tr!(
            "the generated shader was refused: {message} (in `{source}`)",
            message = error.message
        );
        let problem = Diagnostic::error("internal-invalid-wgsl", message)
            .hint(tr!("this is a mistake in Chiaro: please report the look"));
        match self.spans.node_at(start) {
            Some(path) => problem.node(path.clone()),
            None => problem,
        }
    }
}

/// Writes the module.
pub(super) fn emit(
    graph: &TypedGraph,
    specialized: &SpecializedGraph,
    options: &CompileOptions,
) -> EmittedModule {
    let mut emitter = Emitter::new(graph, specialized, options);
    emitter.plan();
    emitter.write()
}

fn with_part(name: &str, part: Option<&str>) -> String {
    part.map_or_else(|| name.to_owned(), |part| format!("{name} {part}"))
}

/// An expression longer than this makes the line that it stands in too long.
const LONG_EXPRESSION: usize = 70;

/// From this many calls on, a long expression is a function.
const WORTH_A_FUNCTION: usize = 3;

/// Functions that differ by at most this many operations are one.
const ALIKE: u64 = 2;

struct Emitter<'a> {
    graph: &'a TypedGraph,
    special: &'a SpecializedGraph,
    options: &'a CompileOptions,
    /// Calls of fragment rate, and loops, each after what it reads.
    calls: Vec<ValueId>,
    needs: Needs,
    names: Names,
    items: Items,
    functions: SpecializedFunctions,
    /// The form of each call.
    specialized: HashMap<ValueId, CallForm>,
    /// Operations of the functions of each node's calls, and those that forms leave of them.
    shortened: BTreeMap<usize, [u64; 2]>,
    /// WGSL name of each value: a local variable, a constant, or a member of `look`.
    value_names: HashMap<ValueId, String>,
    /// Struct constants: their names.
    constants: Vec<(ValueId, String)>,
    /// By value: true for calls that stand inside the one that reads them.
    nested: Vec<bool>,
    /// By value: the loop in whose body it is made.
    loops_around: Vec<Option<usize>>,
    /// Names of the counters of loops.
    counters: HashMap<usize, String>,
    /// Values that loops read, made once for all lights.
    of_all_lights: HashSet<ValueId>,
    /// Calls whose results are written into variables of their loops at once, with these.
    assigned: HashMap<ValueId, ValueId>,
    host: HostProgram,
    host_steps: HashMap<ValueId, usize>,
    collected: CollectedItems,
    /// Names of the function of the rounds of a barrier's loop, and of their counter.
    barrier_names: Option<[String; 2]>,
    out: String,
    spans: SpanMap,
    /// By node: the light that its value is about, of modules that are written as they are.
    single_lights: Vec<Option<LightId>>,
}

impl<'a> Emitter<'a> {
    fn new(
        graph: &'a TypedGraph,
        special: &'a SpecializedGraph,
        options: &'a CompileOptions,
    ) -> Self {
        Self {
            graph,
            special,
            options,
            calls: Vec::new(),
            needs: Needs {
                images: special.images.clone(),
                is_deformed: options.deformed,
                ..Needs::default()
            },
            names: Names::default(),
            items: Items::default(),
            functions: SpecializedFunctions::default(),
            specialized: HashMap::new(),
            shortened: BTreeMap::new(),
            value_names: HashMap::new(),
            constants: Vec::new(),
            nested: Vec::new(),
            loops_around: loops::loops_around(&special.values),
            counters: HashMap::new(),
            of_all_lights: special.loops.iter().flat_map(|l| l.shared.iter().copied()).collect(),
            assigned: HashMap::new(),
            host: HostProgram::default(),
            host_steps: HashMap::new(),
            collected: CollectedItems::default(),
            barrier_names: None,
            out: String::new(),
            spans: SpanMap::default(),
            single_lights: if options.unspecialized { single_lights(graph) } else { Vec::new() },
        }
    }

    fn roots(&self) -> Vec<ValueId> {
        self.special.shown().collect()
    }

    fn is_host(&self, id: ValueId) -> bool {
        matches!(self.special.values[id].rate, Rate::Frame | Rate::Object)
    }

    /// Orders the calls, finds what the host computes, and names everything.
    fn plan(&mut self) {
        let roots = self.roots();
        self.order_calls(&roots);
        let reached = reachable(&self.special.values, roots.iter().copied());
        self.plan_contexts(&reached);
        self.want_items(&reached);
        let maps = PassId::all().map(|pass| pass.row().map).filter(|map| !map.is_empty());
        for name in frame::RESERVED.iter().copied().chain(maps) {
            self.names.reserve(name);
        }
        let images = (0..self.needs.images.len()).filter(|&image| self.image_is_used(image));
        let images: Vec<String> = images.map(|image| self.image_name(image)).collect();
        for name in images {
            self.names.reserve(&format!("{name}_sampler"));
            self.names.reserve(&name);
        }
        let items = std::mem::take(&mut self.items);
        self.collected = items.collect(&mut self.names, &self.functions);
        self.plan_host(&roots);
        self.name_constants();
        self.plan_assignments();
        for id in self.calls.clone() {
            if self.is_loop(id) || self.assigned.contains_key(&id) {
                continue;
            }
            let name = self.wanted_name(id);
            let name = self.names.give(&name);
            self.value_names.insert(id, name);
        }
        for (call, variable) in &self.assigned {
            if let Some(name) = self.value_names.get(variable).cloned() {
                self.value_names.insert(*call, name);
            }
        }
        self.plan_nesting();
    }

    /// Depth first from the roots, so that what belongs together stands together; with a stack of
    /// its own, because a chain may be 100,000 nodes long.
    fn order_calls(&mut self, roots: &[ValueId]) {
        let mut done = vec![false; self.special.values.len()];
        let mut stack: Vec<(ValueId, bool)> = roots.iter().rev().map(|&id| (id, false)).collect();
        while let Some((id, is_leaving)) = stack.pop() {
            if is_leaving {
                let operation = &self.special.values[id].operation;
                if matches!(operation, Operation::Call { .. } | Operation::Loop { .. }) {
                    self.calls.push(id);
                }
                continue;
            }
            let is_fragment = self.special.values[id].rate > Rate::Object;
            if !is_fragment || std::mem::replace(&mut done[id], true) {
                continue;
            }
            stack.push((id, true));
            stack.extend(
                operands(&self.special.values[id].operation).rev().map(|operand| (operand, false)),
            );
        }
    }

    fn want_items(&mut self, reached: &[bool]) {
        let built_in = Library::built_in().nodes.values().next().map(|def| def.module.clone());
        for id in self.calls.clone() {
            self.specialize_call(id);
        }
        self.share_long_expressions();
        self.share_functions();
        for id in self.calls.clone() {
            self.want_call(id);
        }
        let Some(built_in) = built_in else { return };
        for name in self.frame_functions() {
            self.items.want(&built_in, &name);
        }
        let special = self.special;
        let reached = reached.iter().enumerate().filter(|(_, reached)| **reached);
        for (id, value) in reached.map(|(id, _)| (id, &special.values[id])) {
            if let Operation::Convert { template, value: from } = &value.operation {
                self.specialize_conversion(&built_in, id, template, *from);
            }
            // The types of uniform members and constants.
            let module = &self.graph.nodes[value.node].def.module;
            self.items.want(module, value.ty.wgsl());
        }
    }

    /// Finds the form of a call: its function as it stands, one for its arguments alone, or the
    /// expression that it comes to.
    fn specialize_call(&mut self, id: ValueId) {
        let special = self.special;
        let Operation::Call { function, arguments } = &special.values[id].operation else { return };
        if self.options.unspecialized {
            return;
        }
        let ranges = self.argument_ranges(id);
        let tier = self.graph.nodes[special.values[id].node].tier;
        let mut form = ranges.map_or(CallForm::Original, |ranges| {
            self.functions.specialize(&function.module, &function.name, tier, &ranges)
        });
        if let CallForm::Expression(code, is_changed) = &form {
            let is_repeated = |(index, argument): (usize, &Argument)| {
                code.reads(index) > 1
                    && matches!(argument, Argument::Value(id) if !self.is_short(*id))
            };
            let is_refused =
                code.with_arguments(&self.constant_arguments(arguments)).may_be_refused();
            if is_refused || arguments.iter().enumerate().any(is_repeated) {
                form =
                    self.functions.function_of(&function.module, &function.name, code, *is_changed);
            }
        }
        self.specialized.insert(id, form);
    }

    /// Makes functions of expressions that several calls would repeat in lines that are too long.
    fn share_long_expressions(&mut self) {
        let mut calls: HashMap<(usize, &str, Rc<Code>), Vec<ValueId>> = HashMap::new();
        for &id in &self.calls {
            if let (Operation::Call { function, .. }, Some(CallForm::Expression(code, _))) =
                (&self.special.values[id].operation, self.specialized.get(&id))
                && code.length() > LONG_EXPRESSION
            {
                let key = (module_key(&function.module), &*function.name, code.clone());
                calls.entry(key).or_default().push(id);
            }
        }
        let mut repeated: Vec<Vec<ValueId>> =
            calls.into_values().filter(|calls| calls.len() >= WORTH_A_FUNCTION).collect();
        repeated.sort_unstable();
        for id in repeated.into_iter().flatten() {
            let Operation::Call { function, .. } = &self.special.values[id].operation else {
                continue;
            };
            if let Some(CallForm::Expression(code, is_changed)) = self.specialized.get(&id) {
                let (code, is_changed) = (code.clone(), *is_changed);
                let (module, name) = (&function.module, &function.name);
                let form = self.functions.function_of(module, name, &code, is_changed);
                self.specialized.insert(id, form);
            }
        }
    }

    /// Calls one function where two would differ by an operation or two: by the one that more calls
    /// are made of, where it stays as it is for the arguments of both.
    fn share_functions(&mut self) {
        let mut calls: BTreeMap<usize, Vec<ValueId>> = BTreeMap::new();
        for &id in &self.calls {
            if let Some(CallForm::Made(index)) = self.specialized.get(&id) {
                calls.entry(*index).or_default().push(id);
            }
        }
        let common: Vec<(usize, ValueId, usize)> =
            calls.iter().map(|(&index, ids)| (index, ids[0], ids.len())).collect();
        for &(index, first, count) in &common {
            let Operation::Call { function, .. } = &self.special.values[first].operation else {
                continue;
            };
            let others = common.iter().filter(|(other, call, of_other)| {
                (*of_other, index) > (count, *other)
                    && self.callee(first) == self.callee(*call)
                    && self.functions.is_alike(&function.module, [index, *other], ALIKE)
            });
            let wider = others.map(|&(other, call, _)| (other, call)).collect::<Vec<_>>();
            for id in calls[&index].clone() {
                let found = wider.iter().find(|(other, call)| self.holds_both(*other, id, *call));
                if let Some(&(other, _)) = found {
                    self.specialized.insert(id, CallForm::Made(other));
                }
            }
        }
    }

    /// The function that a call is made of, by its module's address and its name.
    fn callee(&self, id: ValueId) -> Option<(usize, &str)> {
        let Operation::Call { function, .. } = &self.special.values[id].operation else {
            return None;
        };
        Some((module_key(&function.module), &*function.name))
    }

    /// True if what is written for the arguments of both calls is this function.
    fn holds_both(&mut self, made: usize, a: ValueId, b: ValueId) -> bool {
        let special = self.special;
        let Operation::Call { function, .. } = &special.values[a].operation else { return false };
        let tier = |id: ValueId| self.graph.nodes[special.values[id].node].tier;
        let (Some(of_a), Some(of_b)) = (self.argument_ranges(a), self.argument_ranges(b)) else {
            return false;
        };
        let joined: Option<Vec<Ranges>> =
            of_a.iter().zip(&of_b).map(|(a, b)| intervals::join(a, b)).collect();
        let (module, name) = (&function.module, &function.name);
        tier(a) == tier(b)
            && joined.is_some_and(|joined| {
                let form = self.functions.specialize(module, name, tier(a), &joined);
                matches!(form, CallForm::Made(index) if index == made)
            })
    }

    /// The ranges of a call's arguments.
    fn argument_ranges(&self, id: ValueId) -> Option<Vec<Ranges>> {
        let Operation::Call { arguments, .. } = &self.special.values[id].operation else {
            return None;
        };
        let ranges = arguments.iter().map(|argument| match argument {
            Argument::Value(id) => self.special.values[*id].ranges_in_fragments(),
            Argument::Image(_) | Argument::Sampler(_) => Some(Ranges::from([])),
        });
        ranges.collect()
    }

    /// Wants what a call's form names.
    fn want_call(&mut self, id: ValueId) {
        let special = self.special;
        let Operation::Call { function, .. } = &special.values[id].operation else { return };
        let form = self.specialized.get(&id).cloned().unwrap_or(CallForm::Original);
        match &form {
            CallForm::Original => self.items.want_function(function),
            CallForm::Made(index) => self.items.want_made(&function.module, *index),
            CallForm::Expression(code, _) => self.items.want_code(&function.module, code),
        }
        let whole = function.module.operations(&function.name);
        let left = self.functions.operations(&function.module, &function.name, &form);
        let known = self.shortened.entry(special.values[id].node).or_default();
        *known = [known[0] + whole, known[1] + left.min(whole)];
    }

    /// Arguments as parts of an expression, as far as they are constants; others are parameters.
    fn constant_arguments(&self, arguments: &[Argument]) -> Vec<Code> {
        let argument = |(index, argument): (usize, &Argument)| match argument {
            Argument::Value(id) => match &self.special.values[*id].operation {
                Operation::Constant(value) if value.parts().is_none() => {
                    Code::Argument(self.expression(*id).into(), 0)
                }
                _ => Code::Parameter(index),
            },
            _ => Code::Parameter(index),
        };
        arguments.iter().enumerate().map(argument).collect()
    }

    /// Nodes whose functions take shorter forms, with what these leave out.
    fn removed_within(&self) -> Vec<Removal> {
        let shorter = self.shortened.iter().filter(|(_, [whole, left])| left < whole);
        shorter
            .map(|(&node, &[whole, left])| Removal {
                path: self.graph.nodes[node].path.clone(),
                reason: tr!(
                    "{idle} of its {whole} operations change nothing for what it is given, proved \
                     by ranges",
                    idle = whole - left
                ),
                proof: Proof::Ranges,
                still_gives: false,
                operations: whole - left,
            })
            .collect()
    }

    /// Finds the form of a conversion, as of a call.
    fn specialize_conversion(
        &mut self,
        built_in: &Arc<NodeModule>,
        id: ValueId,
        template: &str,
        from: ValueId,
    ) {
        let name = template.strip_suffix("($)");
        let ranges = self.special.values[from].ranges_in_fragments();
        if let (Some(name), Some(ranges), false) = (name, ranges, self.options.unspecialized)
            && built_in.declaration(name).is_some()
            && let CallForm::Expression(code, true) = self.functions.specialize(
                built_in,
                name,
                Tier::Exact,
                std::slice::from_ref(&ranges),
            )
            && (code.reads(0) < 2 || self.is_short(from))
            && !code.names_declarations()
        {
            self.specialized.insert(id, CallForm::Expression(code, true));
            return;
        }
        for name in crate::wgsl::identifiers(template) {
            self.items.want(built_in, &name);
        }
    }

    /// True if a value is read by its name, or by a short literal.
    fn is_short(&self, id: ValueId) -> bool {
        match &self.special.values[id].operation {
            Operation::Constant(value) => value.components().is_some_and(|c| c.len() == 1),
            Operation::Param { .. }
            | Operation::Context(..)
            | Operation::Call { .. }
            | Operation::Loop { .. }
            | Operation::LoopResult { .. }
            | Operation::LoopVariable { .. }
            | Operation::LoopField { .. } => true,
            Operation::Member { value, .. } => self.is_short(*value),
            Operation::Convert { .. } => self.is_host(id),
        }
    }

    fn plan_contexts(&mut self, reached: &[bool]) {
        for (value, _) in self.special.values.iter().zip(reached).filter(|(_, reached)| **reached) {
            if let (Operation::Context(context, _), Rate::Fragment) = (&value.operation, value.rate)
                && !self.needs.contexts.contains(context)
            {
                self.needs.contexts.push(*context);
            }
        }
        self.needs.occluders = (0..reached.len()).any(|id| reached[id] && self.reads_occluders(id));
        self.needs.contexts.sort_unstable();
        let read = std::mem::take(&mut self.needs.contexts).into_iter();
        let (resources, contexts) = read.partition(|context| context.is_resource());
        (self.needs.resources, self.needs.contexts) = (resources, contexts);
        let used: Vec<bool> =
            (0..self.needs.images.len()).map(|image| self.image_is_used(image)).collect();
        if used.iter().any(|used| !used) {
            // Indices stay as they are; an image that nothing reads gets no binding.
            for (image, used) in self.needs.images.iter_mut().zip(used) {
                if !used {
                    image.path.clear();
                }
            }
        }
    }

    /// True for a call of a node that is about no light, and asks what stands about a surface.
    fn reads_occluders(&self, call: ValueId) -> bool {
        let values = &self.special.values;
        let is_casters = |argument: &Argument| match argument {
            Argument::Value(id) => {
                matches!(values[*id].operation, Operation::Context(Context::CASTERS, _))
            }
            _ => false,
        };
        let Operation::Call { arguments, .. } = &values[call].operation else { return false };
        self.graph.nodes[values[call].node].light.is_none() && arguments.iter().any(is_casters)
    }

    fn image_is_used(&self, image: usize) -> bool {
        self.calls.iter().any(|&id| match &self.special.values[id].operation {
            Operation::Call { arguments, .. } => arguments.contains(&Argument::Image(image)),
            _ => false,
        })
    }

    /// Plans the values that fragments read from the host, the drivers of keys, and the steps that
    /// compute both.
    fn plan_host(&mut self, roots: &[ValueId]) {
        let mut frontier: Vec<ValueId> =
            roots.iter().copied().filter(|&id| self.is_host(id)).collect();
        let mut seen = vec![false; self.special.values.len()];
        let mut open: Vec<ValueId> = roots.to_vec();
        while let Some(id) = open.pop() {
            if std::mem::replace(&mut seen[id], true)
                || self.special.values[id].rate <= Rate::Object
            {
                continue;
            }
            for operand in operands(&self.special.values[id].operation) {
                if self.is_host(operand) {
                    frontier.push(operand);
                }
                open.push(operand);
            }
        }
        frontier.sort_unstable();
        frontier.dedup();
        let mut member_names = Names::default();
        for id in frontier {
            let step = self.host_step(id);
            let name = member_names.give(&self.wanted_name(id));
            self.value_names.insert(id, format!("look.{name}"));
            self.host.members.push(UniformMember {
                name,
                ty: self.special.values[id].ty.clone(),
                origin: self.origin(id),
                step,
                offset: 0,
                place: None,
            });
        }
        self.plan_loops(&mut member_names);
        for (driver, &value) in self.graph.drivers.iter().zip(&self.special.drivers) {
            let step = self.host_step(value);
            self.host.drivers.push(HostDriver { wire: driver.wire.clone(), step });
        }
        self.host.key_order.clone_from(&self.graph.key_order);
    }

    /// The node that a value belongs to, and what of it.
    fn origin(&self, id: ValueId) -> String {
        let value = &self.special.values[id];
        let path = &self.graph.nodes[value.node].path;
        value.part.as_ref().map_or_else(|| path.to_string(), |part| format!("{path}.{part}"))
    }

    /// The step that computes a value on the host; operands first, with a stack of its own.
    fn host_step(&mut self, id: ValueId) -> usize {
        let mut stack = vec![(id, false)];
        while let Some((id, is_leaving)) = stack.pop() {
            if self.host_steps.contains_key(&id) {
                continue;
            }
            if !is_leaving {
                stack.push((id, true));
                stack.extend(
                    operands(&self.special.values[id].operation).map(|operand| (operand, false)),
                );
                continue;
            }
            let step = self.step(id);
            self.host.steps.push(step);
            self.host_steps.insert(id, self.host.steps.len() - 1);
        }
        self.host_steps[&id]
    }

    fn step(&self, id: ValueId) -> ProgramStep {
        let value = &self.special.values[id];
        match &value.operation {
            Operation::Constant(constant) => ProgramStep::Constant(constant.clone()),
            Operation::Param { id, value: constant } => {
                ProgramStep::Param { id: *id, ty: value.ty.clone(), value: constant.clone() }
            }
            Operation::Context(context, light) => ProgramStep::Context(*context, light.clone()),
            Operation::Member { value, index, .. } => {
                ProgramStep::Member { value: self.host_steps[value], index: *index }
            }
            Operation::Convert { value: from, .. } => {
                let (from_type, to) = (self.special.values[*from].ty.clone(), value.ty.clone());
                match conversion_program(&from_type, &to) {
                    Some(program) => {
                        let callee = Callee::Conversion { from: from_type, to };
                        ProgramStep::Call {
                            program,
                            callee,
                            arguments: vec![self.host_steps[from]],
                        }
                    }
                    // Between two names of one type.
                    None => ProgramStep::Member { value: self.host_steps[from], index: 0 },
                }
            }
            Operation::Call { function, arguments } => {
                let arguments = arguments.iter().filter_map(|argument| match argument {
                    Argument::Value(value) => Some(self.host_steps[value]),
                    _ => None,
                });
                let arguments = arguments.collect();
                match function.module.program(&function.name) {
                    Ok(program) => ProgramStep::Call {
                        program,
                        callee: Callee::Function(function.clone()),
                        arguments,
                    },
                    // The specializer keeps what the interpreter refuses at fragment rate.
                    Err(_) => ProgramStep::Constant(crate::interp::Value::Float(0.0)),
                }
            }
            // Of fragment rate, as all that loops make.
            Operation::Loop { .. }
            | Operation::LoopResult { .. }
            | Operation::LoopVariable { .. }
            | Operation::LoopField { .. } => {
                ProgramStep::Constant(crate::interp::Value::Float(0.0))
            }
        }
    }

    fn name_constants(&mut self) {
        let mut wanted: Vec<ValueId> = Vec::new();
        for &id in &self.calls {
            for operand in operands(&self.special.values[id].operation) {
                wanted.extend(self.struct_constant(operand));
            }
        }
        wanted.extend(self.roots().into_iter().filter_map(|root| self.struct_constant(root)));
        for id in wanted {
            if !self.value_names.contains_key(&id) {
                let name = self.name_without_light(id);
                let name = self.names.give(&name);
                self.value_names.insert(id, name.clone());
                self.constants.push((id, name));
            }
        }
    }

    fn struct_constant(&self, id: ValueId) -> Option<ValueId> {
        match &self.special.values[id].operation {
            Operation::Constant(value) if value.parts().is_some() => Some(id),
            Operation::Member { value, .. } | Operation::Convert { value, .. } => {
                self.struct_constant(*value)
            }
            _ => None,
        }
    }

    fn wanted_name(&self, id: ValueId) -> String {
        let value = &self.special.values[id];
        let node = &self.graph.nodes[value.node];
        if let Operation::Context(context, light) = &value.operation {
            let word = context.word().replace('.', "_");
            return light
                .as_ref()
                .map_or(word.clone(), |light| word.replacen("light", light.as_str(), 1));
        }
        // Layers share their lights: a light goes by its own name, not by that of the first layer
        // that it lights.
        match &node.light {
            Some(light)
                if node.def.special == Treatment::Light && self.loop_around(id).is_none() =>
            {
                with_part(light.as_str(), value.part.as_deref())
            }
            _ => self.name_without_light(id),
        }
    }

    /// The name of a value's node, and its part.
    fn name_without_light(&self, id: ValueId) -> String {
        let value = &self.special.values[id];
        let node = &self.graph.nodes[value.node];
        let name = match &node.shared_name {
            Some(shared) if self.loop_around(id).is_some() || self.of_all_lights.contains(&id) => {
                shared
            }
            _ => &node.name,
        };
        with_part(name, value.part.as_deref())
    }

    fn write(mut self) -> EmittedModule {
        let body = self.look_functions();
        self.write_header();
        self.write_structs();
        let bindings = self.write_bindings();
        let head = std::mem::take(&mut self.out);
        self.write_constants();
        let constants = std::mem::take(&mut self.out);
        self.write_entry_points();
        let entry_points = std::mem::take(&mut self.out);
        // Conversions and constants that were folded leave types and functions without a user.
        let items = self.collected.text_for(&[&head, &constants, &body.text, &entry_points]);
        let offset = head.len() + items.len() + constants.len();
        self.out = [head, items, constants, body.text, entry_points].concat();
        self.spans.spans = body
            .spans
            .into_iter()
            .map(|span| Span { bytes: span.bytes.start + offset..span.bytes.end + offset, ..span })
            .collect();
        EmittedModule {
            removed_within: self.removed_within(),
            root_type: self.special.values[self.special.root].ty.clone(),
            text: self.out,
            host: self.host,
            needs: self.needs,
            bindings,
            spans: self.spans,
        }
    }

    fn write_header(&mut self) {
        let title = if self.graph.name.is_empty() { "A look" } else { &self.graph.name };
        // A name may hold anything; a comment ends at the line's end.
        let title: String = title.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
        let _ =
            writeln!(self.out, "// {title}: generated by Chiaro {}.", env!("CARGO_PKG_VERSION"));
        let _ = writeln!(self.out, "// {}\n", self.options.stage.row().help);
    }

    fn write_constants(&mut self) {
        for (id, name) in self.constants.clone() {
            let value = &self.special.values[id];
            if let Operation::Constant(constant) = &value.operation {
                let literal = self.literal(constant, &value.ty, value.node);
                write_line(&format!("const {name} = {literal};"), 0, &mut self.out);
            }
        }
        if !self.constants.is_empty() {
            self.out.push('\n');
        }
    }

    fn context_expression(&self, context: Context) -> String {
        if context.is_resource() {
            context.word().to_owned()
        } else {
            format!("surface.{}", context.word())
        }
    }
}
