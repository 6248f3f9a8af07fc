//! Values that a module writes beside the picture: outputs of nodes, and what parts of a look's
//! stack of layers add to the picture.
//!
//! A [`Stack`] is the chain of nodes through their `below`, from the Output down. Each step lets a
//! share of what is below it through, and adds something of its own; what it adds, times what all
//! steps above let through, is its contribution. No contribution is negative, and all together are
//! the stack.

use std::collections::BTreeSet;
use std::collections::HashSet;

use chiaro_locale::tr;

use super::check::{TypedGraph, TypedNode, TypedSource, check};
use super::flatten::FlatGraph;
use super::parting::{BentSum, LightShares};
use super::transfer::Transfer;
use crate::diag::{Diagnostic, Severity};
use crate::document::{Look, NamedAov, Target, Value};
use crate::ids::{LightId, NodePath, PortName};
use crate::library::{Library, LightFeed, Treatment, Type};

/// Source of a value that is written beside the picture.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum AovSource {
    /// Nothing: the value is 0 wherever the look is seen.
    Nothing,
    /// An output of a node, by its path and name.
    Wire(NodePath, PortName),
    /// An output of a node's copy for a light, in a group that runs for each.
    Copy(NodePath, PortName, LightId),
    /// The sum of the contributions of these steps of the look's stack.
    Steps(BTreeSet<StepId>),
    /// The stack itself, premultiplied, as it is before anything that follows it.
    Stack,
}

/// Step of a stack: a node, or one of its copies for each light.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct StepId {
    /// The node.
    pub path: NodePath,
    /// The light of the copy.
    pub light: Option<LightId>,
    /// True for what lies below the lowest step, where that is a value of the step itself.
    pub is_below: bool,
    /// Lights of the part of the step that is meant: one, none, or those that cannot be parted;
    /// `None` for the whole step.
    pub share: Option<BTreeSet<LightId>>,
}

/// A shadow that a look asks for: what of a light is kept from a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct ShadowOutput {
    /// The light.
    pub light: LightId,
    /// Word for what casts it; empty for other objects.
    pub caster: &'static str,
    /// The shadow, from 0 to 1.
    pub source: AovSource,
}

/// Kinds of nodes that give shadows, each with a word for what casts them.
const SHADOWS: [(&str, &str); 2] = [("cast_shadow", ""), ("self_shadow", "self")];

/// An output of a node that can be written beside the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct WireOutput {
    /// The node.
    pub path: NodePath,
    /// Name of the node for people.
    pub name: String,
    /// The output.
    pub port: PortName,
    /// Type of its value.
    pub ty: Type,
}

/// Step of a stack, for whoever asks for contributions.
#[derive(Clone, Debug, PartialEq)]
pub struct StackPart {
    /// The step.
    pub id: StepId,
    /// Name of the layer for people.
    pub name: String,
    /// The lights that the step's own color depends on.
    pub lights: BTreeSet<LightId>,
    /// Parts of a step of several lights, each of one, of none, or of those that cannot be parted.
    /// Together they are the step.
    pub shares: Vec<StepId>,
}

/// Sum of lights that cannot be parted, for a node bends it.
#[derive(Clone, Debug)]
pub struct BentLights {
    /// The node that bends it.
    pub node: NodePath,
    /// Name of the node for people.
    pub name: String,
    /// The value that goes into the node, where there is one of which all comes.
    pub value: Option<AovSource>,
    /// The lit values that go into the node, by its inputs, where there are several.
    pub inputs: Vec<(PortName, AovSource)>,
    /// The table from that value to what the layer is made of, where it depends on nothing else.
    pub transfer: Result<Transfer, String>,
}

/// A look's stack of layers, for whoever asks for contributions.
#[derive(Clone, Debug, Default)]
pub struct StackParts {
    /// The steps, from the top; the last one is what lies below all layers.
    pub parts: Vec<StackPart>,
    /// Nodes between the stack and the Output, from the Output on: their results cannot be parted.
    pub after: Vec<NodePath>,
    /// The table from the stack to the picture, where nodes are between them.
    pub grade: Option<Result<Transfer, String>>,
    /// Sums of lights within the steps that cannot be parted.
    pub bent: Vec<BentLights>,
}

/// Value that is written for a source.
#[derive(Clone, Debug)]
pub struct TypedAov {
    pub(super) kind: TypedAovKind,
    /// Type of the value.
    pub ty: Type,
}

/// Kind of what is written.
#[derive(Clone, Debug)]
pub(super) enum TypedAovKind {
    /// An output of a node, by their indices.
    Output(usize, usize),
    /// The sum of contributions.
    Steps(BTreeSet<StepId>),
    /// The whole stack.
    Stack,
}

/// Chain of nodes through what is below each.
#[derive(Clone, Debug, Default)]
pub(super) struct Stack {
    /// Steps from the top: a node and the input that takes what is below.
    pub(super) steps: Vec<(usize, usize)>,
    /// The output that lies below all steps; `None` where a value does.
    pub(super) bottom: Option<(usize, usize)>,
    /// The output of the highest step.
    pub(super) top: Option<(usize, usize)>,
    /// Nodes between the Output and the stack, from the Output on, each with the input that the
    /// stack comes in by.
    after: Vec<(usize, usize)>,
}

/// The rule by which a step lets a share of what is below through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Passage {
    /// Share of a mode of *Blend*.
    Blend,
    /// All of it.
    All,
    /// Share that a color's alpha leaves.
    Alpha,
    /// All or nothing: the greater one is seen.
    Greater,
    /// Share of a mode of *Mix colors*.
    Mix,
}

/// Row of a kind of steps.
struct PassageRow {
    kind: &'static str,
    passage: Passage,
    /// The input that takes what is below; empty for that of the lights before.
    below: &'static str,
}

/// Kind of folders whose layers lie on the stack below.
const PASS_THROUGH: &str = "pass_through";

const PASSAGES: [PassageRow; 7] = [
    PassageRow { kind: "blend", passage: Passage::Blend, below: "below" },
    // With a share of its layers, a pass-through folder is a step; shown as they are, they are.
    PassageRow { kind: PASS_THROUGH, passage: Passage::All, below: "below" },
    PassageRow { kind: "mix_colors", passage: Passage::Mix, below: "a" },
    // A limit that keeps hues dims everything alike.
    PassageRow { kind: "limit_color", passage: Passage::All, below: "color" },
    PassageRow { kind: "sum_of_lights", passage: Passage::All, below: "" },
    PassageRow { kind: "layers_of_lights", passage: Passage::Alpha, below: "" },
    PassageRow { kind: "greatest_of_lights", passage: Passage::Greater, below: "" },
];

impl Passage {
    /// The rule of a kind of nodes; `None` for nodes that are no steps.
    pub(super) fn of(node: &TypedNode) -> Option<Self> {
        PassageRow::of(node).map(|row| row.passage)
    }
}

/// True for a node that is a step of a stack.
pub(super) fn is_step(node: &TypedNode) -> bool {
    PassageRow::of(node).is_some()
}

impl PassageRow {
    fn of(node: &TypedNode) -> Option<&'static Self> {
        PASSAGES.iter().find(|row| row.kind == node.def.kind)
    }
}

impl AovSource {
    /// The output that it is about, in a look without groups; `None` for nothing, and for what the
    /// picture depends on anyway.
    ///
    /// # Errors
    /// That there is no such output, with near names.
    pub(super) fn find(&self, flat: &FlatGraph) -> Result<Option<(usize, usize)>, Diagnostic> {
        match self {
            Self::Wire(path, port) => flat.output(path, port).map(Some),
            Self::Copy(path, port, light) => flat.output_of_copy(path, port, light).map(Some),
            Self::Nothing | Self::Steps(_) | Self::Stack => Ok(None),
        }
    }
}

impl TypedAov {
    /// True for parts of the picture, which are premultiplied by its alpha.
    pub(super) fn is_part_of_picture(&self) -> bool {
        matches!(self.kind, TypedAovKind::Steps(_) | TypedAovKind::Stack)
    }

    /// Value that is written for a source that [was found](AovSource::find).
    ///
    /// # Errors
    /// That values of a type cannot be written.
    pub(super) fn of(
        graph: &TypedGraph,
        source: &AovSource,
        found: Option<(usize, usize)>,
    ) -> Result<Option<Self>, Diagnostic> {
        match (source, found) {
            (AovSource::Steps(steps), _) => {
                let kind = TypedAovKind::Steps(steps.clone());
                Ok(Some(Self { kind, ty: Type::Composite }))
            }
            (AovSource::Stack, _) => {
                Ok(Some(Self { kind: TypedAovKind::Stack, ty: Type::Composite }))
            }
            (AovSource::Wire(..) | AovSource::Copy(..), Some((node, output))) => {
                let ty = graph.output_type(node, output);
                if can_be_aov(&ty) {
                    return Ok(Some(Self { kind: TypedAovKind::Output(node, output), ty }));
                }
                Err(cannot_be_written(&ty).node(graph.nodes[node].path.clone()))
            }
            (AovSource::Nothing | AovSource::Wire(..) | AovSource::Copy(..), _) => Ok(None),
        }
    }
}

fn cannot_be_written(ty: &Type) -> Diagnostic {
    let message = tr!("values of type {ty} cannot be written as a pass", ty = ty.label());
    let hint = tr!("numbers, vectors, colors, angles and lights can: see --list-aovs");
    Diagnostic::error("aov-type", message).hint(hint)
}

/// True for types whose values can be a pass: at most three numbers and a coverage.
pub fn can_be_aov(ty: &Type) -> bool {
    matches!(
        ty,
        Type::Float
            | Type::Int
            | Type::Bool
            | Type::Vec2
            | Type::Vec3
            | Type::Vec4
            | Type::Color
            | Type::Composite
            | Type::Angle
            | Type::Light
    )
}

impl TypedGraph {
    pub(super) fn output_type(&self, node: usize, output: usize) -> Type {
        let node = &self.nodes[node];
        let variant = node.variant();
        match node.def.outputs.get(output) {
            Some(output) if variant.result_is_struct => output.ty.clone(),
            _ => variant.result.clone(),
        }
    }

    /// The node that is drawn, if it is an Output.
    fn output_node(&self) -> Option<usize> {
        let is_output = |node: &TypedNode| node.def.special == Treatment::Output;
        Some(self.root.0).filter(|&root| is_output(&self.nodes[root]))
    }

    /// The stack that the Output shows.
    pub(super) fn stack(&self) -> Stack {
        let mut stack = Stack::default();
        let first =
            self.output_node().and_then(|output| self.wire(output, self.input(output, "color")?));
        let mut open = first;
        let mut seen = HashSet::new();
        while let Some((index, output)) = open {
            // Wires of a checked look make no ring; a broken one ends here.
            if !seen.insert(index) {
                break;
            }
            if let Some(inside) = self.passed_through(index) {
                open = Some(inside);
                continue;
            }
            let Some(below) = self.below(index) else {
                // Before the first step, what takes one color is a node after the stack.
                match self.one_color(index).filter(|_| stack.steps.is_empty()) {
                    Some((input, next)) => {
                        stack.after.push((index, input));
                        open = Some(next);
                        continue;
                    }
                    None => {
                        stack.bottom = Some((index, output));
                        break;
                    }
                }
            };
            stack.top.get_or_insert((index, output));
            stack.steps.push((index, below));
            open = self.wire(index, below);
        }
        if stack.steps.is_empty() {
            // Without steps, the whole picture is one contribution.
            stack.after.clear();
            stack.bottom = first;
            stack.top = first;
        }
        stack
    }

    /// The uppermost layer in a folder that shows its layers as they are: one through which the
    /// stack goes on. `None` for all other nodes.
    fn passed_through(&self, index: usize) -> Option<(usize, usize)> {
        let node = Some(&self.nodes[index]).filter(|node| node.def.kind == PASS_THROUGH)?;
        let TypedSource::Param(id, Value::Number(opacity)) =
            node.inputs.get(self.input(index, "opacity")?)?.as_ref()?.source
        else {
            return None;
        };
        let param = self.params.get(id)?;
        let is_exposed = self.exposed.iter().any(|exposed| match &exposed.target {
            Target::Input { node, port } => (node, port) == (&param.path, &param.port),
            Target::Light { .. } => false,
        });
        let is_still = !is_exposed && !self.is_keyed(&param.path, &param.port);
        self.wire(index, self.input(index, "inside")?).filter(|_| is_still && opacity >= 1.0)
    }

    /// The input of a step that takes what is below; `None` for what is no step.
    fn below(&self, index: usize) -> Option<usize> {
        let node = &self.nodes[index];
        let name = PassageRow::of(node)?.below;
        let is_below = |place: &usize| {
            let input = &node.def.inputs[*place];
            let ty = node.inputs.get(*place).and_then(|input| Some(&input.as_ref()?.ty));
            let is_before = matches!(input.light_feed, Some(LightFeed::Before(_)));
            let is_color = matches!(ty, Some(Type::Color | Type::Composite));
            is_color && if name.is_empty() { is_before } else { input.name.as_str() == name }
        };
        (0..node.def.inputs.len()).find(is_below)
    }

    pub(super) fn input(&self, index: usize, name: &str) -> Option<usize> {
        self.nodes[index].def.inputs.iter().position(|input| input.name.as_str() == name)
    }

    /// The output that an input is wired to.
    pub(super) fn wire(&self, index: usize, input: usize) -> Option<(usize, usize)> {
        match self.nodes[index].inputs.get(input)?.as_ref()?.source {
            TypedSource::Wire { node, output } => Some((node, output)),
            _ => None,
        }
    }

    /// The only input of a node that takes a wired color, with the output that it comes from.
    fn one_color(&self, index: usize) -> Option<(usize, (usize, usize))> {
        let node = &self.nodes[index];
        let mut colors = (0..node.inputs.len()).filter_map(|input| {
            let ty = &node.inputs[input].as_ref()?.ty;
            let is_color = matches!(ty, Type::Color | Type::Composite);
            Some((input, self.wire(index, input).filter(|_| is_color)?))
        });
        let first = colors.next()?;
        colors.next().is_none().then_some(first)
    }

    pub(super) fn step_id(&self, index: usize) -> StepId {
        let node = &self.nodes[index];
        let light = node.light.clone().filter(|_| node.def.joins_lights());
        StepId { path: node.path.clone(), light, is_below: false, share: None }
    }

    /// The lights that a step's inputs depend on, but for what is below.
    fn lights_of(&self, index: usize, below: Option<usize>) -> BTreeSet<LightId> {
        let mut lights = BTreeSet::new();
        let mut seen = HashSet::from([index]);
        let sources = |index: usize, but: Option<usize>| {
            let inputs = 0..self.nodes[index].inputs.len();
            let wires = inputs.filter(move |input| Some(*input) != but);
            wires.filter_map(move |input| Some(self.wire(index, input)?.0))
        };
        lights.extend(self.step_id(index).light);
        let mut open: Vec<usize> = sources(index, below).collect();
        if below.is_none() {
            open.push(index);
            seen.clear();
        }
        while let Some(index) = open.pop() {
            if seen.insert(index) {
                let node = &self.nodes[index];
                lights.extend(node.light.clone().filter(|_| !node.is_unlit));
                open.extend(sources(index, None));
            }
        }
        lights
    }

    /// Name of a node for people: that of the library's group that it is a part of, else its own.
    fn layer_name(&self, index: usize) -> String {
        let node = &self.nodes[index];
        match &node.group {
            Some(group) if group.is_of_library => group.name.clone(),
            _ => node.name.clone(),
        }
    }

    /// The outputs of groups that can be written beside the picture, by their paths and names.
    fn group_wires(&self) -> Vec<WireOutput> {
        let outputs = self.group_outputs.iter().flat_map(|(path, outputs)| {
            outputs.iter().map(move |(port, source)| (path, port, *source))
        });
        let wire = |(path, port, (node, output)): (&NodePath, &PortName, (usize, usize))| {
            let ty = self.output_type(node, output);
            let name = self.nodes[node].group.as_ref().map(|group| group.name.clone());
            let name = name.unwrap_or_else(|| path.to_string());
            let is_named = !port.as_str().is_empty() && can_be_aov(&ty);
            is_named.then(|| WireOutput { path: path.clone(), name, port: port.clone(), ty })
        };
        let mut wires: Vec<WireOutput> = outputs.filter_map(wire).collect();
        wires.sort_by(|a, b| (&a.path, &a.port).cmp(&(&b.path, &b.port)));
        wires
    }

    /// The stack with the names and lights of its steps.
    pub fn stack_parts(&self) -> StackParts {
        let stack = self.stack();
        let known = self.lights_by_node();
        let mut bent = Vec::new();
        let mut shares =
            |id: &StepId, lights: &BTreeSet<LightId>, part: &dyn Fn() -> LightShares| {
                if lights.len() < 2 {
                    return Vec::new();
                }
                let parting = part();
                bent.extend(parting.bent.iter().map(|sum| self.bent_lights(sum)));
                let share = |(lights, _)| StepId { share: Some(lights), ..id.clone() };
                parting.by_lights().into_iter().map(share).collect()
            };
        let mut parts = Vec::with_capacity(stack.steps.len() + 1);
        for &(index, below) in &stack.steps {
            let (id, lights) = (self.step_id(index), self.lights_of(index, Some(below)));
            let shares = shares(&id, &lights, &|| self.part_step(&known, index, below));
            parts.push(StackPart { id, name: self.layer_name(index), lights, shares });
        }
        match (stack.bottom, stack.steps.last()) {
            (Some(source @ (index, _)), _) => {
                let (id, lights) = (self.step_id(index), self.lights_of(index, None));
                let shares = shares(&id, &lights, &|| self.part_output(&known, source));
                parts.push(StackPart { id, name: self.layer_name(index), lights, shares });
            }
            (None, Some(&(index, _))) => parts.push(StackPart {
                id: StepId { is_below: true, ..self.step_id(index) },
                name: format!("below {}", self.layer_name(index)),
                lights: BTreeSet::new(),
                shares: Vec::new(),
            }),
            (None, None) => {}
        }
        let nodes = stack.after.iter().map(|&(index, _)| &self.nodes[index]);
        let nodes = nodes.filter(|node| node.def.special != Treatment::Reroute);
        let after: Vec<NodePath> = nodes.map(|node| node.path.clone()).collect();
        let grade = (!after.is_empty()).then(|| Transfer::new(self, &stack.after));
        StackParts { parts, after, grade, bent }
    }

    fn bent_lights(&self, sum: &BentSum) -> BentLights {
        let node = &self.nodes[sum.node];
        let value = sum.value.and_then(|source| self.source_of(source));
        let unknown = || tr!("more than one way leads from it to the layer").to_owned();
        let transfer = sum.chain.as_ref().ok_or_else(unknown);
        let input_of = |input: usize, source| {
            Some((node.def.inputs.get(input)?.name.clone(), self.source_of(source)?))
        };
        BentLights {
            node: node.path.clone(),
            name: self.layer_name(sum.node),
            value,
            inputs: sum
                .inputs
                .iter()
                .filter_map(|&(input, source)| input_of(input, source))
                .collect(),
            transfer: transfer.and_then(|chain| Transfer::new(self, chain)),
        }
    }

    /// The source that names an output, if its values can be written.
    fn source_of(&self, (index, output): (usize, usize)) -> Option<AovSource> {
        let node = &self.nodes[index];
        let (path, port) = (node.path.clone(), node.def.outputs.get(output)?.name.clone());
        let source = match node.light.clone().filter(|_| node.copy.is_some()) {
            Some(light) => AovSource::Copy(path, port, light),
            None => AovSource::Wire(path, port),
        };
        can_be_aov(&self.output_type(index, output)).then_some(source)
    }
}

impl TypedGraph {
    /// The shadows that the picture depends on, in the order of the document. Of those that are
    /// computed in the same way of one light the first stands for all.
    pub fn shadow_outputs(&self) -> Vec<ShadowOutput> {
        let mut seen = HashSet::new();
        let mut open = vec![self.root.0];
        while let Some(index) = open.pop() {
            if seen.insert(index) {
                let inputs = 0..self.nodes[index].inputs.len();
                open.extend(inputs.filter_map(|input| Some(self.wire(index, input)?.0)));
            }
        }
        let mut known = HashSet::new();
        let mut found = Vec::new();
        for (index, node) in self.nodes.iter().enumerate().filter(|(at, _)| seen.contains(at)) {
            let row = SHADOWS.iter().find(|(kind, _)| *kind == node.def.kind);
            let light = node.light.clone().filter(|_| !node.is_unlit);
            let (Some((kind, caster)), Some(light)) = (row, light) else { continue };
            let values = node.inputs.iter().map(|input| match &input.as_ref()?.source {
                TypedSource::Param(_, value) => Some(format!("{value:?}")),
                source => Some(format!("{source:?}")),
            });
            let made_of: Vec<Option<String>> = values.collect();
            let is_new = known.insert((kind, light.clone(), node.tier, made_of));
            if let Some(source) = self.source_of((index, 0)).filter(|_| is_new) {
                found.push(ShadowOutput { light, caster, source });
            }
        }
        found
    }

    /// Warnings of the look's named outputs that name nothing, or nothing that can be written.
    pub(super) fn check_named(
        &self,
        look: &Look,
        found: Vec<Result<(usize, usize), Diagnostic>>,
    ) -> Vec<Diagnostic> {
        let problem = |(aov, found): (&NamedAov, Result<(usize, usize), Diagnostic>)| match found {
            Err(problem) => Some(problem),
            Ok((index, output)) => {
                let node = &self.nodes[index];
                // A node that was not typed has problems of its own.
                let is_typed = node.inputs.len() == node.def.inputs.len();
                let ty = is_typed.then(|| self.output_type(index, output))?;
                (!can_be_aov(&ty)).then(|| cannot_be_written(&ty).node(aov.from.node.clone()))
            }
        };
        let problems = look.aovs.iter().zip(found).map(problem).enumerate();
        let located = problems.filter_map(|(index, problem)| {
            let problem = problem?.json_path(format!("aovs[{index}].from"));
            Some(Diagnostic { severity: Severity::Warning, ..problem })
        });
        located.collect()
    }

    /// True if keys move an input.
    pub(super) fn is_keyed(&self, path: &NodePath, port: &PortName) -> bool {
        let is_it = |target: &Target| match target {
            Target::Input { node, port: of } => node == path && of == port,
            Target::Light { .. } => false,
        };
        self.keyed.iter().any(is_it)
    }
}

/// The outputs of a look's groups and nodes that can be written beside the picture: groups by their
/// paths, then nodes in the order of the document.
///
/// # Errors
/// Everything that is wrong with the look.
pub fn wire_outputs(look: &Look, library: &Library) -> Result<Vec<WireOutput>, Vec<Diagnostic>> {
    let graph = check(look, library, None)?.value;
    let mut found = graph.group_wires();
    let mut seen: HashSet<(NodePath, PortName)> =
        found.iter().map(|wire| (wire.path.clone(), wire.port.clone())).collect();
    for (index, node) in graph.nodes.iter().enumerate() {
        // A node that could not be typed has no inputs, and Output shows the picture itself.
        if node.def.special == Treatment::Output || node.inputs.len() != node.def.inputs.len() {
            continue;
        }
        for (output, port) in node.def.outputs.iter().enumerate() {
            let ty = graph.output_type(index, output);
            if can_be_aov(&ty) && seen.insert((node.path.clone(), port.name.clone())) {
                let (path, name) = (node.path.clone(), node.name.clone());
                found.push(WireOutput { path, name, port: port.name.clone(), ty });
            }
        }
    }
    Ok(found)
}
