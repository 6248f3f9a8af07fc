//! From nodes to values: folds what is known, merges what is equal, removes what cannot change the
//! picture.
//!
//! Every value knows its rate. Constants are folded by the interpreter in f64; values of frame and
//! object rate become steps of a host program, whose results the fragment reads from uniforms; the
//! rest is emitted as WGSL. A value is made once: asking for the same operation on the same values
//! again gives the same value.

mod bounds;
mod bypass;
mod contributions;
mod loops;
mod opacity;

use std::borrow::Cow;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use chiaro_locale::tr;
use rustc_hash::FxHashMap;

use self::loops::{JoinedNodes, joined_copy};
pub(super) use self::loops::{LightLoop, LoopVariable};
use super::check::{TypedGraph, TypedInput, TypedNode, TypedSource};
use super::flatten::ParamId;
use super::host::{conversion_program, conversion_ranges};
use super::intervals::{self, Ranges};
use super::removal::{Proof, Removal};
use super::value::typed_value;
use super::{CompileOptions, Live};
use crate::diag::Diagnostic;
use crate::document::{ColorSpace, LightField, LightInput, Storage, Target, Value};
use crate::ids::{LightId, NodePath, PortName};
use crate::interp;
use crate::library::{
    ArgumentSource, Context, Conversion, LightFeed, NodeModule, Output, PassId, Rate, StageValue,
    Treatment, Type,
};

/// An index into [`SpecializedGraph::values`].
pub(super) type ValueId = usize;

/// A function of a node file.
#[derive(Clone, Debug)]
pub(super) struct Function {
    pub(super) module: Arc<NodeModule>,
    pub(super) name: Arc<str>,
}

/// An argument of a call.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Argument {
    Value(ValueId),
    Image(usize),
    Sampler(usize),
}

/// The operation that makes a value.
#[derive(Clone, Debug)]
pub(super) enum Operation {
    Constant(interp::Value),
    Param {
        id: ParamId,
        value: interp::Value,
    },
    Context(Context, Option<LightId>),
    Call {
        function: Function,
        arguments: Vec<Argument>,
    },
    Member {
        value: ValueId,
        index: usize,
        name: PortName,
    },
    Convert {
        template: &'static str,
        value: ValueId,
    },
    /// Runs a body once for each light, by index into [`SpecializedGraph::loops`]; reads what its
    /// variables are before and what a round makes of them.
    Loop {
        index: usize,
        arguments: Vec<Argument>,
    },
    /// A variable of a loop once that has run.
    LoopResult {
        value: ValueId,
        variable: usize,
    },
    /// A variable of a loop in its body.
    LoopVariable {
        index: usize,
    },
    /// In a loop's body, what the uniform holds for the round's light.
    LoopField {
        index: usize,
        field: usize,
    },
}

/// A value of the graph: an operation with its type, rate and origin.
#[derive(Clone, Debug)]
pub(super) struct ComputedValue {
    pub(super) operation: Operation,
    pub(super) ty: Type,
    pub(super) rate: Rate,
    /// The node that asked for it first.
    pub(super) node: usize,
    /// The part of that node which the value is, where not the node's result: a port, or `shape`.
    pub(super) part: Option<String>,
    /// True if all numbers of the value are known to lie in [0, 1].
    pub(super) unit: bool,
    /// The range of each scalar; `None` where ranges are not followed.
    pub(super) ranges: Option<Ranges>,
}

impl ComputedValue {
    /// Ranges of the value where a fragment reads it: what comes from a uniform is finite, because
    /// the host writes nothing else ([`push_numbers`](super::host::push_numbers)).
    pub(super) fn ranges_in_fragments(&self) -> Option<Ranges> {
        let ranges = self.ranges.clone()?;
        let is_uniform =
            self.rate != Rate::Fragment && !matches!(self.operation, Operation::Constant(_));
        Some(if is_uniform { intervals::finite(&ranges) } else { ranges })
    }
}

/// The kind of texture that a file becomes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ImageShape {
    /// A picture: `texture_2d<f32>`.
    #[default]
    Flat,
    /// A hand-painted 6D texture: `texture_2d_array<f32>`.
    Hcbtf {
        /// True if smaller levels of the texture's tile are read.
        has_levels: bool,
        /// The storage within the texture, which the texture itself states.
        storage: Storage,
    },
}

impl ImageShape {
    /// Type in WGSL.
    pub fn wgsl(self) -> &'static str {
        match self {
            Self::Flat => "texture_2d<f32>",
            Self::Hcbtf { .. } => "texture_2d_array<f32>",
        }
    }
}

/// An image that a node reads, with how it is sampled.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct ImageUse {
    /// The path, as in the document.
    pub path: String,
    /// The kind of texture that the file becomes.
    pub shape: ImageShape,
    /// The choices of the node that begin with `wrap`, `filter` and `encoding`.
    pub wrap: String,
    /// `linear` or `nearest`.
    pub filter: String,
    /// `color` or `data`.
    pub encoding: String,
    /// True if the image's numbers are decoded to linear light when they are read: colors, in a
    /// look in linear light.
    pub is_decoded: bool,
    /// The first node that reads it.
    pub node: NodePath,
}

/// The contexts and images that a module asks of meshes and passes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Needs {
    /// The surroundings that its fragments read.
    pub contexts: Vec<Context>,
    /// The images that it reads.
    pub images: Vec<ImageUse>,
    /// The scene's resources that it reads.
    pub resources: Vec<Context>,
    /// True if it asks casters what stands about a surface, whatever the light.
    pub occluders: bool,
    /// True if meshes are deformed, and tell where their surface was before.
    pub is_deformed: bool,
}

impl Needs {
    /// True if any fragment reads `context`.
    pub fn context(&self, context: Context) -> bool {
        self.contexts.contains(&context) || self.resources.contains(&context)
    }

    /// True if it reads the triangles of all objects that cast shadows.
    pub fn casters(&self) -> bool {
        self.context(Context::CASTERS)
    }

    /// True if it reads what lights see of the scene.
    pub fn shadow_maps(&self) -> bool {
        self.resources.iter().any(|resource| resource.pass().is_some())
    }

    /// The passes whose results it reads.
    pub fn passes(&self) -> impl Iterator<Item = PassId> {
        self.contexts.iter().chain(&self.resources).filter_map(|context| context.pass())
    }
}

/// An output of a look that its module computes beside the root, by its name: `color` and `cutoff`
/// where fragments are cut away, `id` where edges tell ids apart, and `aov_1` and on where values
/// are written beside the picture.
#[derive(Clone, Debug)]
pub(super) struct NamedOutput {
    pub(super) name: Cow<'static, str>,
    pub(super) value: ValueId,
}

/// Name of a value beside the picture, by its number from 0 on.
pub(super) fn aov_name(number: usize) -> String {
    format!("aov_{}", number + 1)
}

/// A look as values, ready to be written down.
#[derive(Clone, Debug)]
pub(super) struct SpecializedGraph {
    pub(super) values: Vec<ComputedValue>,
    pub(super) root: ValueId,
    /// Outputs of the look that are shown beside the root.
    pub(super) beside: Vec<NamedOutput>,
    pub(super) images: Vec<ImageUse>,
    /// The images that must be opaque for the picture to be; `None` if it may be transparent even
    /// then.
    pub(super) opaque_with: Option<Vec<ImageUse>>,
    /// The value of each of the graph's drivers, as a number.
    pub(super) drivers: Vec<ValueId>,
    pub(super) loops: Vec<LightLoop>,
    pub(super) removed: Vec<Removal>,
}

impl SpecializedGraph {
    /// The value of an output beside the root.
    pub(super) fn named(&self, name: &str) -> Option<ValueId> {
        self.beside.iter().find(|output| output.name == name).map(|output| output.value)
    }

    /// The alpha below which a fragment is not drawn, if any can be.
    pub(super) fn cutoff(&self) -> Option<ValueId> {
        self.named("cutoff")
    }

    /// All values that the module shows: the root, and the outputs beside it.
    pub(super) fn shown(&self) -> impl Iterator<Item = ValueId> {
        std::iter::once(self.root).chain(self.beside.iter().map(|output| output.value))
    }

    /// True if what the root shows has an alpha of 1, by its type or by its range.
    pub(super) fn is_opaque(&self) -> bool {
        let root = &self.values[self.root];
        let alpha = || root.ranges.as_ref()?.get(3).copied();
        match root.ty {
            Type::Color | Type::Vec4 | Type::Composite => {
                matches!(alpha(), Some(intervals::Range::Float(x)) if x.is_within(1.0, 1.0))
            }
            // Numbers, vectors and angles are shown as colors without transparency.
            Type::Float | Type::Int | Type::Bool | Type::Vec2 | Type::Vec3 | Type::Angle => true,
            _ => false,
        }
    }
}

/// Turns a checked look into values.
///
/// # Errors
/// A node that runs without end when it is folded.
pub(super) fn specialize(
    graph: &TypedGraph,
    options: &CompileOptions,
) -> Result<SpecializedGraph, Vec<Diagnostic>> {
    let mut builder = Builder::new(graph, options);
    for &index in &graph.order {
        builder.node(index);
    }
    if !builder.problems.is_empty() {
        return Err(builder.problems);
    }
    Ok(builder.finish())
}

#[derive(PartialEq, Eq, Hash)]
enum OperationKey {
    Constant(Type, Vec<u64>),
    Param(ParamId, Type),
    Context(Context, Option<LightId>),
    Call(usize, Arc<str>, Vec<Argument>),
    Member(ValueId, usize),
    Convert(&'static str, Type, ValueId),
}

struct Builder<'a> {
    graph: &'a TypedGraph,
    options: &'a CompileOptions,
    live: HashSet<ParamId>,
    values: Vec<ComputedValue>,
    known: FxHashMap<OperationKey, ValueId>,
    /// The outputs of each node; empty until it was built.
    outputs: Vec<Vec<ValueId>>,
    /// The values of the Output node's other roots.
    extra_roots: HashMap<String, ValueId>,
    images: Vec<ImageUse>,
    removed: Vec<Removal>,
    /// Nodes of which a result is known by ranges alone.
    proved: HashSet<usize>,
    joined: JoinedNodes,
    intervals: intervals::Calls,
    problems: Vec<Diagnostic>,
}

impl<'a> Builder<'a> {
    fn new(graph: &'a TypedGraph, options: &'a CompileOptions) -> Self {
        Self {
            graph,
            options,
            live: live_params(graph, &options.live),
            values: Vec::with_capacity(graph.nodes.len() * 2),
            known: FxHashMap::default(),
            outputs: vec![Vec::new(); graph.nodes.len()],
            extra_roots: HashMap::new(),
            images: Vec::new(),
            removed: Vec::new(),
            proved: HashSet::new(),
            joined: JoinedNodes::new(),
            intervals: intervals::Calls::default(),
            problems: Vec::new(),
        }
    }

    fn node(&mut self, index: usize) {
        let graph = self.graph;
        let node = &graph.nodes[index];
        let inputs = self.inputs(index, node);
        if let Some(outputs) = self.before_dark(node, &inputs) {
            self.outputs[index] = outputs;
            return;
        }
        if let Some((value, reason, proof)) = self.bypass(index, node, &inputs) {
            self.outputs[index] = vec![value];
            self.remove(node, reason, proof);
            return;
        }
        let variant = node.variant();
        let result = self.call(
            index,
            node,
            &variant.function,
            &variant.parameters,
            variant.result.clone(),
            &inputs,
        );
        if self.is_unit(node, &inputs) {
            self.mark_unit(result);
        }
        if node.def.has_unit_alpha {
            self.mark_unit_alpha(result);
        }
        self.mark_dark(node, result);
        self.outputs[index] = if variant.result_is_struct {
            node.def
                .outputs
                .iter()
                .enumerate()
                .scan(Some(0), |at, (i, output)| {
                    let start = *at;
                    *at = start.and_then(|start| Some(start + intervals::scalars_in(&output.ty)?));
                    Some(self.member(index, result, (i, start), &output.name, &output.ty))
                })
                .collect()
        } else {
            vec![result]
        };
        if let Some((copy, joined)) = joined_copy(node, &inputs, &self.outputs[index]) {
            self.joined.entry((copy.region, node.path.clone())).or_default().push(joined);
        }
        if node.def.special == Treatment::Output {
            self.output_roots(index, node, &inputs);
        }
    }

    /// The values of a node's inputs, within the bounds that it sets them.
    fn inputs(&mut self, index: usize, node: &TypedNode) -> Vec<Option<ValueId>> {
        let mut inputs: Vec<Option<ValueId>> = node
            .inputs
            .iter()
            .map(|input| input.as_ref().and_then(|input| self.input(index, node, input)))
            .collect();
        self.bound_inputs(index, node, &mut inputs);
        inputs
    }

    fn output_roots(&mut self, index: usize, node: &TypedNode, inputs: &[Option<ValueId>]) {
        for root in &node.def.variants {
            if let Some((_, word)) = &root.choice {
                let value = self.call(
                    index,
                    node,
                    &root.function,
                    &root.parameters,
                    root.result.clone(),
                    inputs,
                );
                self.extra_roots.insert(word.clone(), value);
            }
        }
    }

    fn input(&mut self, index: usize, node: &TypedNode, input: &TypedInput) -> Option<ValueId> {
        let value = match &input.source {
            TypedSource::Wire { node, output } => *self.outputs[*node].get(*output)?,
            TypedSource::Context(context) => {
                let light = context.light_input().and_then(|_| node.light.clone());
                self.context(index, *context, light)
            }
            TypedSource::Param(_, _) if input.ty.is_texture() => return None,
            TypedSource::Fixed(value) => {
                self.constant(index, input.ty.clone(), typed_value(value, &input.ty).ok()?)
            }
            TypedSource::Param(id, value) => self.param(index, *id, value, &input.ty),
        };
        Some(match input.conversion {
            Conversion::None => value,
            Conversion::Template(template) => {
                let has_alpha = matches!(self.values[value].ty, Type::Color | Type::Vec4);
                let value = if has_alpha && input.ty == Type::Composite {
                    self.bounded(index, "alpha", value)
                } else {
                    value
                };
                self.convert(index, value, template, &input.ty)
            }
        })
    }

    fn context(&mut self, index: usize, context: Context, light: Option<LightId>) -> ValueId {
        let ty = Type::from_wgsl(context.wgsl_type());
        if let Some(input) = context.light_input()
            && let Some(numbers) = self.numbers_in_the_dark(index, input, light.as_ref())
        {
            let value = match numbers.as_slice() {
                [number] => interp::Value::Float(*number),
                numbers => interp::Value::vec(numbers),
            };
            return self.constant(index, ty, value);
        }
        let made = self.values.len();
        let key = OperationKey::Context(context, light.clone());
        let id = self.value(key, index, ty, context.rate(), Operation::Context(context, light));
        if id == made {
            self.values[id].ranges = Some(intervals::context_ranges(context));
        }
        id
    }

    /// Numbers of an input from a light that does not reach the node, or whoever wears the look;
    /// `None` for what no darkness tells.
    fn numbers_in_the_dark(
        &self,
        index: usize,
        input: LightInput,
        light: Option<&LightId>,
    ) -> Option<Vec<f64>> {
        let is_dark =
            light.is_some_and(|light| self.options.dark.contains(&(light.clone(), input)));
        let is_unlit = is_dark || self.graph.nodes[index].is_unlit;
        let width = || Type::from_wgsl(input.wgsl_type()).width().unwrap_or(1);
        match input.unlit() {
            Some(numbers) => is_unlit.then(|| numbers.to_vec()),
            None => is_dark.then(|| vec![0.0; width()]),
        }
    }

    /// Numbers that are known to lie in [0, 1] by what a node promises.
    fn mark_unit(&mut self, id: ValueId) {
        self.values[id].unit = true;
        if let Some(ranges) = &self.values[id].ranges {
            self.values[id].ranges = Some(ranges.iter().map(|range| range.within_unit()).collect());
        }
    }

    /// A light that reaches nothing arrives with no intensity, wherever its surface is.
    fn mark_dark(&mut self, node: &TypedNode, result: ValueId) {
        let (Treatment::Light, Some(light)) = (node.def.special, &node.light) else { return };
        // The last number of whatever tells of a light is what arrives of its intensity.
        if self.is_dark(node, light)
            && let Some(ranges) = &self.values[result].ranges
        {
            let mut ranges = ranges.to_vec();
            if let Some(intensity) = ranges.last_mut() {
                *intensity = intervals::Range::ZERO;
            }
            self.values[result].ranges = Some(ranges.into());
        }
    }

    /// True if nothing of a light arrives at a node.
    fn is_dark(&self, node: &TypedNode, light: &LightId) -> bool {
        let intensity = LightInput::Field(LightField::Intensity);
        node.is_unlit || self.options.dark.contains(&(light.clone(), intensity))
    }

    /// The outputs of a node that joins lights as the lights before have left them, where its own
    /// light reaches nothing.
    fn before_dark(&self, node: &TypedNode, inputs: &[Option<ValueId>]) -> Option<Vec<ValueId>> {
        let light = node.light.as_ref().filter(|_| node.def.joins_lights())?;
        if !self.is_dark(node, light) {
            return None;
        }
        node.def.outputs.iter().map(|output| before(node, output, inputs)).collect()
    }

    /// The only value, to the bit, that ranges leave to a value of this type.
    fn only_value(&self, ranges: Option<&Ranges>, ty: &Type) -> Option<interp::Value> {
        if self.options.unspecialized { None } else { intervals::exactly(ranges?, ty) }
    }

    fn call_ranges(
        &mut self,
        node: &TypedNode,
        (module, function): (&NodeModule, &str),
        arguments: &[Argument],
        rate: Rate,
    ) -> Option<Ranges> {
        if self.options.unspecialized {
            return None;
        }
        let light = node.light.as_ref();
        let is_dark = light.is_some_and(|light| self.is_dark(node, light));
        let mut given = Vec::with_capacity(arguments.len());
        for (place, argument) in arguments.iter().enumerate() {
            let ranges = match argument {
                Argument::Value(id) if rate == Rate::Fragment => {
                    self.values[*id].ranges_in_fragments()
                }
                Argument::Value(id) => self.values[*id].ranges.clone(),
                // Images and samplers have no numbers.
                Argument::Image(_) | Argument::Sampler(_) => Some(Ranges::from([])),
            };
            // What comes of a light that does not arrive seldom hangs on the rest, so that it is
            // followed although an argument may be anything.
            let any = || intervals::any_argument(module, function, place).filter(|_| is_dark);
            given.push(ranges.or_else(any)?);
        }
        self.intervals.call(module, function, &given)
    }

    fn param(&mut self, index: usize, id: ParamId, value: &Value, ty: &Type) -> ValueId {
        // The checker converted it once already, so it cannot fail here; 0 keeps the type if it
        // did.
        let value = typed_value(value, ty).unwrap_or(interp::Value::Float(0.0));
        if !self.live.contains(&id) {
            return self.constant(index, ty.clone(), value);
        }
        let part = self.graph.params[id].port.to_string();
        let made = self.values.len();
        // Whoever edits it may set it to anything.
        let ranges = intervals::any_like(&value);
        let id = self.value(
            OperationKey::Param(id, ty.clone()),
            index,
            ty.clone(),
            Rate::Object,
            Operation::Param { id, value },
        );
        if id == made {
            self.values[id].part = Some(part);
            self.values[id].ranges = Some(ranges);
        }
        id
    }

    fn constant(&mut self, index: usize, ty: Type, value: interp::Value) -> ValueId {
        let mut bits = Vec::new();
        push_bits(&value, &mut bits);
        let unit = value
            .components()
            .is_some_and(|numbers| numbers.iter().all(|x| (0.0..=1.0).contains(x)));
        let ranges = intervals::of_value(&value);
        let id = self.value(
            OperationKey::Constant(ty.clone(), bits),
            index,
            ty,
            Rate::Constant,
            Operation::Constant(value),
        );
        self.values[id].unit = unit;
        self.values[id].ranges = Some(ranges);
        id
    }

    /// A member by its index, with where its scalars begin among the struct's, if that is known.
    fn member(
        &mut self,
        index: usize,
        value: ValueId,
        (member, start): (usize, Option<usize>),
        name: &PortName,
        ty: &Type,
    ) -> ValueId {
        if let Operation::Constant(interp::Value::Struct(parts)) = &self.values[value].operation {
            let part = parts[member].clone();
            return self.constant(index, ty.clone(), part);
        }
        let ranges = self.values[value].ranges.as_ref().zip(start).and_then(|(ranges, start)| {
            let part = ranges.get(start..start + intervals::scalars_in(ty)?)?;
            Some(Ranges::from(part))
        });
        if let Some(known) = self.only_value(ranges.as_ref(), ty) {
            self.proved.insert(index);
            return self.constant(index, ty.clone(), known);
        }
        let rate = self.values[value].rate;
        let operation = Operation::Member { value, index: member, name: name.clone() };
        let made = self.values.len();
        let id =
            self.value(OperationKey::Member(value, member), index, ty.clone(), rate, operation);
        if id == made {
            self.values[id].part = Some(name.to_string());
            self.values[id].ranges = ranges;
        }
        id
    }

    fn convert(
        &mut self,
        index: usize,
        value: ValueId,
        template: &'static str,
        ty: &Type,
    ) -> ValueId {
        let from = self.values[value].ty.clone();
        if let (Operation::Constant(constant), false) =
            (&self.values[value].operation, self.options.unspecialized)
        {
            let program = conversion_program(&from, ty);
            let converted = program.and_then(|program| {
                program.call(std::slice::from_ref(constant), interp::Precision::F64).ok()
            });
            if let Some(converted) = converted.filter(is_finite) {
                return self.constant(index, ty.clone(), converted);
            }
        }
        let ranges = self.values[value]
            .ranges
            .as_ref()
            .and_then(|ranges| conversion_ranges(&from, ty, ranges));
        if let Some(known) = self.only_value(ranges.as_ref(), ty) {
            return self.constant(index, ty.clone(), known);
        }
        let (rate, unit) = (self.values[value].rate, self.values[value].unit);
        let rate = if self.options.unspecialized { Rate::Fragment } else { rate };
        let key = OperationKey::Convert(template, ty.clone(), value);
        let made = self.values.len();
        let id = self.value(key, index, ty.clone(), rate, Operation::Convert { template, value });
        if id == made {
            self.values[id].ranges = ranges;
        }
        // Widening and the two ways of alpha keep numbers within [0, 1].
        if unit && ty.width().is_some() {
            self.mark_unit(id);
        }
        id
    }

    fn call(
        &mut self,
        index: usize,
        node: &TypedNode,
        function: &str,
        parameters: &[ArgumentSource],
        ty: Type,
        inputs: &[Option<ValueId>],
    ) -> ValueId {
        let mut arguments = Vec::with_capacity(parameters.len());
        let mut prepared = None;
        for parameter in parameters {
            let argument = match parameter {
                ArgumentSource::Input(input, ty) if ty.is_texture() => {
                    Some(Argument::Image(self.image(node, *input, ty)))
                }
                ArgumentSource::Sampler(input) => {
                    Some(Argument::Sampler(self.image(node, *input, &node.def.inputs[*input].ty)))
                }
                ArgumentSource::Input(input, _) => inputs[*input].map(Argument::Value),
                ArgumentSource::Choice(input) => {
                    let position = interp::Value::I32(node.position(*input));
                    Some(Argument::Value(self.constant(index, Type::Int, position)))
                }
                ArgumentSource::Prepared => {
                    prepared = prepared.or_else(|| self.prepared(index, node, inputs));
                    prepared.map(Argument::Value)
                }
            };
            // Only a node that was reported lacks an argument, and then nothing is emitted.
            arguments.extend(argument);
        }
        let function = Function { module: node.def.module.clone(), name: function.into() };
        self.call_function(index, function, arguments, ty, None)
    }

    fn prepared(
        &mut self,
        index: usize,
        node: &TypedNode,
        inputs: &[Option<ValueId>],
    ) -> Option<ValueId> {
        let prepare = node.def.prepare.as_ref()?;
        let arguments = prepare
            .parameters
            .iter()
            .filter_map(|(input, _)| inputs[*input].map(Argument::Value))
            .collect();
        let part = Some("shape".to_owned());
        let function =
            Function { module: node.def.module.clone(), name: prepare.function.as_str().into() };
        Some(self.call_function(index, function, arguments, prepare.result.clone(), part))
    }

    fn call_function(
        &mut self,
        index: usize,
        function: Function,
        arguments: Vec<Argument>,
        ty: Type,
        part: Option<String>,
    ) -> ValueId {
        let graph = self.graph;
        let node = &graph.nodes[index];
        let Function { module, name } = function;
        let mut rate = self.call_rate(&module, &name, &arguments);
        if rate == Rate::Constant && !self.options.unspecialized {
            match self.fold(&module, &name, &arguments) {
                Ok(Some(value)) => {
                    let made = self.values.len();
                    let id = self.constant(index, ty, value);
                    if id == made {
                        self.values[id].part = part;
                    }
                    return id;
                }
                Ok(None) => rate = Rate::Fragment,
                Err(problem) => self.problems.push(problem.node(node.path.clone())),
            }
        }
        if self.options.unspecialized {
            rate = Rate::Fragment;
        }
        let ranges = self.call_ranges(node, (&module, &name), &arguments, rate);
        if let Some(known) = self.only_value(ranges.as_ref(), &ty) {
            self.proved.insert(index);
            return self.constant(index, ty, known);
        }
        let key =
            OperationKey::Call(Arc::as_ptr(&module) as usize, name.clone(), arguments.clone());
        let operation = Operation::Call { function: Function { module, name }, arguments };
        let made = self.values.len();
        let id = self.value(key, index, ty, rate, operation);
        if id == made {
            self.values[id].part = part;
            self.values[id].ranges = ranges;
        } else if self.values[id].node != index && part.is_none() {
            let other = &self.graph.nodes[self.values[id].node].path;
            let reason = tr!("it is the same as `{other}`");
            self.remove(node, reason, Proof::Equal);
        }
        id
    }

    fn call_rate(&self, module: &NodeModule, function: &str, arguments: &[Argument]) -> Rate {
        let mut rate = Rate::Constant;
        for argument in arguments {
            rate = rate.max(match argument {
                Argument::Value(value) => self.values[*value].rate,
                Argument::Image(_) | Argument::Sampler(_) => Rate::Fragment,
            });
        }
        // A function that the interpreter cannot run must run in the fragment.
        if rate < Rate::Fragment && module.program(function).is_err() {
            Rate::Fragment
        } else {
            rate
        }
    }

    /// The value of a call whose arguments are known; `None` where it is not finite and so cannot
    /// be written down.
    fn fold(
        &self,
        module: &NodeModule,
        function: &str,
        arguments: &[Argument],
    ) -> Result<Option<interp::Value>, Diagnostic> {
        let mut values = Vec::with_capacity(arguments.len());
        for argument in arguments {
            let Argument::Value(id) = argument else { return Ok(None) };
            let Operation::Constant(value) = &self.values[*id].operation else { return Ok(None) };
            values.push(value.clone());
        }
        let value = module.program(function)?.call(&values, interp::Precision::F64)?;
        Ok(Some(value).filter(is_finite))
    }

    fn image(&mut self, node: &TypedNode, input: usize, ty: &Type) -> usize {
        let path = match node.inputs[input].as_ref().map(|input| &input.source) {
            Some(TypedSource::Param(_, Value::Text(path))) => path.clone(),
            _ => String::new(),
        };
        let setting = |name: &str, default: &str| {
            let choice = node.def.input(name).and_then(|index| node.choices.get(&index));
            choice.map_or_else(|| default.to_owned(), Clone::clone)
        };
        let image = ImageUse {
            path,
            shape: match ty {
                Type::Hcbtf => ImageShape::Hcbtf {
                    has_levels: setting("lookup", "") == "smooth",
                    storage: Storage::of(&setting("storage", "")).unwrap_or_default(),
                },
                _ => ImageShape::Flat,
            },
            // An HCBTF is never sampled beyond its edges. What runs on a CPU has a shortcut of
            // eight bits for clamped samplers, and filters mirrored ones in floats.
            wrap: setting("wrap", if *ty == Type::Hcbtf { "mirror" } else { "clamp" }),
            filter: setting("filter", "linear"),
            is_decoded: self.graph.color_space == ColorSpace::Linear
                && setting("encoding", "color") == "color",
            encoding: setting("encoding", "color"),
            node: node.path.clone(),
        };
        let same = |other: &ImageUse| {
            (&other.path, &other.shape, &other.wrap, &other.filter, &other.encoding)
                == (&image.path, &image.shape, &image.wrap, &image.filter, &image.encoding)
        };
        self.images.iter().position(same).unwrap_or_else(|| {
            self.images.push(image);
            self.images.len() - 1
        })
    }

    fn value(
        &mut self,
        key: OperationKey,
        node: usize,
        ty: Type,
        rate: Rate,
        operation: Operation,
    ) -> ValueId {
        let made = self.values.len();
        // Merging is a part of pruning; only what is no work of its own is shared without it.
        let is_work = matches!(operation, Operation::Call { .. } | Operation::Convert { .. });
        if !(self.options.unspecialized && is_work) {
            let id = *self.known.entry(key).or_insert(made);
            if id != made {
                return id;
            }
        }
        self.values.push(ComputedValue {
            operation,
            ty,
            rate,
            node,
            part: None,
            unit: false,
            ranges: None,
        });
        made
    }

    fn finish(mut self) -> SpecializedGraph {
        let (node, output) = self.graph.root;
        let is_own_root = self.graph.nodes[node].def.special == Treatment::Output;
        let stage = self.options.stage;
        let root = match stage.row().value {
            StageValue::Context(context) => {
                let operation = Operation::Context(context, None);
                let ty = Type::from_wgsl(context.wgsl_type());
                let key = OperationKey::Context(context, None);
                Some(self.value(key, node, ty, Rate::Fragment, operation))
            }
            StageValue::Input(name) => self.extra_roots.get(name).copied(),
            StageValue::Output => None,
        };
        let color = self.outputs[node][output];
        let root = root.unwrap_or(color);
        let aovs = if stage.is_picture() { self.aovs() } else { Vec::new() };
        let aovs = aovs
            .into_iter()
            .map(|(number, value)| NamedOutput { name: aov_name(number).into(), value });
        let zero = |value: &ComputedValue| {
            let Operation::Constant(constant) = &value.operation else { return false };
            constant.as_f64() <= Some(0.0)
        };
        let cutout = self.options.cutout;
        let cutoff =
            self.extra_roots.get("cutoff").copied().filter(|&id| cutout || !zero(&self.values[id]));
        let cutoff = cutoff.filter(|_| is_own_root && stage.draws_meshes());
        let cutoff = cutoff.filter(|&id| cutout || !self.never_cuts(color, id));
        let is_picture = stage.draws_meshes() && matches!(stage.row().value, StageValue::Output);
        let root = if self.options.mattes && cutoff.is_none() && !cutout {
            self.without_color(root)
        } else {
            root
        };
        let opaque_with =
            if is_picture && cutoff.is_none() && !cutout { self.opaque_with(root) } else { None };
        let drivers = self.drivers();
        let id = self.extra_roots.get("id").copied().filter(|&id| !zero(&self.values[id]));
        let id = id.filter(|_| is_own_root && stage.row().tells_parts);
        let beside = [("color", cutoff.and(Some(color))), ("cutoff", cutoff), ("id", id)];
        let beside: Vec<NamedOutput> = beside
            .into_iter()
            .filter_map(|(name, value)| Some(NamedOutput { name: name.into(), value: value? }))
            .chain(aovs)
            .collect();
        let mut roots = vec![Some(root)];
        roots.extend(beside.iter().map(|output| Some(output.value)));
        roots.extend(drivers.iter().map(|&driver| Some(driver)));
        self.explain_unused(&roots);
        let specialized = SpecializedGraph {
            values: self.values,
            root,
            beside,
            images: self.images,
            opaque_with,
            drivers,
            loops: Vec::new(),
            removed: self.removed,
        };
        specialized.with_loops(self.joined, self.options.loops)
    }

    /// The root of a module that draws mattes: nothing where the picture is opaque everywhere.
    fn without_color(&mut self, root: ValueId) -> ValueId {
        let alpha = self.values[root].ranges.as_ref().and_then(|ranges| ranges.get(3)).copied();
        let is_opaque = matches!(alpha, Some(intervals::Range::Float(x)) if x.is_within(1.0, 1.0));
        if !is_opaque && matches!(self.values[root].ty, Type::Color | Type::Vec4 | Type::Composite)
        {
            return root;
        }
        self.constant(self.graph.root.0, Type::Float, interp::Value::Float(1.0))
    }

    /// The values that drive keys, as numbers. Modules that draw normals leave keys to the look's
    /// own.
    fn drivers(&mut self) -> Vec<ValueId> {
        if self.options.stage.draws_normals() {
            return Vec::new();
        }
        let graph = self.graph;
        let mut values = Vec::with_capacity(graph.drivers.len());
        for driver in &graph.drivers {
            let value = self.outputs[driver.node][driver.output];
            values.push(match driver.conversion {
                Conversion::None => value,
                Conversion::Template(template) => {
                    self.convert(driver.node, value, template, &Type::Float)
                }
            });
        }
        values
    }

    /// True if ranges prove that the look's alpha is at least its cutoff wherever the look is
    /// drawn; the removed cutoff is then reported.
    fn never_cuts(&mut self, color: ValueId, cutoff: ValueId) -> bool {
        let bounds =
            |id: ValueId, scalar: usize| self.values[id].ranges.as_ref()?.get(scalar)?.bounds();
        let (Some([least, _]), Some([_, most])) = (bounds(color, 3), bounds(cutoff, 0)) else {
            return false;
        };
        if self.options.unspecialized || least < most {
            return false;
        }
        let reason = tr!(
            "its alpha cutoff cuts nothing, proved by ranges: alpha is {least} or more everywhere"
        );
        // Removing the Output saves its comparison alone.
        let path = self.graph.nodes[self.graph.root.0].path.clone();
        let proof = Proof::Ranges;
        self.removed.push(Removal { path, reason, proof, still_gives: true, operations: 1 });
        true
    }

    /// Adds a reason for every node of which nothing is left.
    fn explain_unused(&mut self, roots: &[Option<ValueId>]) {
        let reached = reachable(&self.values, roots.iter().flatten().copied());
        let explained: HashSet<NodePath> =
            self.removed.iter().map(|removal| removal.path.clone()).collect();
        let mut seen: HashSet<usize> = HashSet::new();
        for (id, value) in self.values.iter().enumerate() {
            // A node whose value is known runs no code.
            if reached[id] && !matches!(value.operation, Operation::Constant(_)) {
                seen.insert(value.node);
            }
        }
        for &index in &self.graph.order {
            let node = &self.graph.nodes[index];
            let outputs = &self.outputs[index];
            let is_constant =
                |&id: &ValueId| matches!(self.values[id].operation, Operation::Constant(_));
            let is_known = !outputs.is_empty() && outputs.iter().all(is_constant);
            // Surroundings are values of the first node that asks for them, whether or not it runs.
            let runs = seen.contains(&index) && !is_known;
            if runs || explained.contains(&node.path) || index == self.graph.root.0 {
                continue;
            }
            let (reason, proof) = if is_known {
                let dark = node.light.as_ref().filter(|light| self.is_dark(node, light));
                if let Some(light) = dark {
                    (tr!("nothing of the light `{light}` arrives"), Proof::NoLight)
                } else if self.proved.contains(&index) {
                    (self.proved_reason(outputs[0]), Proof::Ranges)
                } else {
                    (tr!("its value is known before drawing").to_owned(), Proof::Constant)
                }
            } else {
                (tr!("nothing that reaches the output uses it").to_owned(), Proof::Unreachable)
            };
            self.remove(node, reason, proof).still_gives = is_known;
        }
    }

    fn remove(&mut self, node: &TypedNode, reason: String, proof: Proof) -> &mut Removal {
        let operations = node.def.module.operations(&node.variant().function);
        let (path, place) = (node.path.clone(), self.removed.len());
        self.removed.push(Removal { path, reason, proof, still_gives: false, operations });
        &mut self.removed[place]
    }
}

impl Builder<'_> {
    fn proved_reason(&self, output: ValueId) -> String {
        match &self.values[output].operation {
            Operation::Constant(value) if value.parts().is_none() => {
                tr!("it is {value} everywhere, proved by ranges")
            }
            _ => tr!("it is the same everywhere, proved by ranges").to_owned(),
        }
    }
}

/// The value that the lights before have left of an output, of a node that joins lights.
fn before(node: &TypedNode, output: &Output, inputs: &[Option<ValueId>]) -> Option<ValueId> {
    let feed = Some(LightFeed::Before(output.name.clone()));
    inputs[node.def.inputs.iter().position(|input| input.light_feed == feed)?]
}

/// For each value, true if the roots depend on it.
pub(super) fn reachable(
    values: &[ComputedValue],
    roots: impl Iterator<Item = ValueId>,
) -> Vec<bool> {
    let mut reached = vec![false; values.len()];
    let mut open: Vec<ValueId> = roots.collect();
    while let Some(id) = open.pop() {
        if !std::mem::replace(&mut reached[id], true) {
            open.extend(operands(&values[id].operation));
        }
    }
    reached
}

/// The values that an operation reads.
pub(super) fn operands(operation: &Operation) -> impl DoubleEndedIterator<Item = ValueId> + '_ {
    let (single, arguments): (Option<ValueId>, &[Argument]) = match operation {
        Operation::Constant(_)
        | Operation::Param { .. }
        | Operation::Context(..)
        | Operation::LoopVariable { .. }
        | Operation::LoopField { .. } => (None, &[]),
        Operation::Call { arguments, .. } | Operation::Loop { arguments, .. } => (None, arguments),
        Operation::Member { value, .. }
        | Operation::Convert { value, .. }
        | Operation::LoopResult { value, .. } => (Some(*value), &[]),
    };
    let of_arguments = arguments.iter().filter_map(|argument| match argument {
        Argument::Value(id) => Some(*id),
        _ => None,
    });
    single.into_iter().chain(of_arguments)
}

fn live_params(graph: &TypedGraph, live: &Live) -> HashSet<ParamId> {
    let by_place: HashMap<_, _> = graph
        .params
        .iter()
        .enumerate()
        .map(|(id, param)| ((&param.path, &param.port), id))
        .collect();
    let of_target = |target: &Target| match target {
        Target::Input { node, port } => by_place.get(&(node, port)).copied(),
        Target::Light { .. } => None,
    };
    let mut ids: HashSet<ParamId> = graph.keyed.iter().filter_map(of_target).collect();
    if *live != Live::Keyed {
        ids.extend(graph.exposed.iter().filter_map(|exposed| of_target(&exposed.target)));
    }
    match live {
        Live::Keyed | Live::Exposed => {}
        Live::Touched(touched) => {
            ids.extend(touched.iter().filter_map(|(path, port)| by_place.get(&(path, port))));
        }
        Live::All => ids.extend(0..graph.params.len()),
    }
    ids
}

fn is_finite(value: &interp::Value) -> bool {
    match (value.components(), value.parts()) {
        (Some(numbers), _) => {
            numbers.iter().all(|x| x.is_finite() && x.abs() <= f64::from(f32::MAX))
        }
        (None, Some(parts)) => parts.iter().all(is_finite),
        (None, None) => true,
    }
}

fn push_bits(value: &interp::Value, bits: &mut Vec<u64>) {
    match value.parts() {
        Some(parts) => parts.iter().for_each(|part| push_bits(part, bits)),
        None => bits.extend(value.components().unwrap_or_default().iter().map(|x| x.to_bits())),
    }
}
