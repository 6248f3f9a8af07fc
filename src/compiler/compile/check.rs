//! Types every node of a look: which function it is, and what its inputs are bound to. Nodes are
//! typed and specialized in an order in which each comes after those that it depends on; the order
//! of calls in the shader is that of `emit`.

use std::collections::{BTreeSet, HashMap, HashSet};
use std::sync::Arc;

use chiaro_locale::{text, tr};
use indexmap::IndexMap;
use petgraph::graph::{DiGraph, NodeIndex};

use super::aov::{AovSource, TypedAov};
use super::drivers::{self, TypedDriver};
use super::flatten::{
    FlatGraph, FlatInput, FlatNode, GroupLabel, GroupOutputs, Param, ParamId, RegionCopy,
    TierReason, flatten,
};
use super::tiers;
use super::value::{describe, expected, typed_value};
use crate::diag::{Diagnostic, Severity, WithWarnings, bounded, has_errors};
use crate::document::{ColorSpace, ExposedValue, Light, LightField, Look, Target, Tier, Value};
use crate::ids::{LightId, NodeId, NodePath, PortName};
use crate::library::{
    ArgumentSource, Context, Conversion, Fallback, Input, Library, NodeDef, NodeFunction,
    Treatment, Type,
};

/// A look in which every value has a type and every problem was reported.
#[derive(Clone, Debug)]
pub struct TypedGraph {
    /// Library nodes.
    pub nodes: Vec<TypedNode>,
    /// Indices of `nodes`, each after all that it depends on.
    pub order: Vec<usize>,
    /// Every value that may be edited.
    pub params: Arc<[Param]>,
    /// The output that is drawn: a node and the index of its output.
    pub root: (usize, usize),
    /// Values beside the picture, a target each; an error where the look does not have one.
    pub aovs: Vec<Result<Option<TypedAov>, Diagnostic>>,
    /// The look's lights.
    pub lights: IndexMap<LightId, Light>,
    /// The parameters that may be set by name.
    pub exposed: Vec<ExposedValue>,
    /// The targets that direction and time keys move.
    pub keyed: Vec<Target>,
    /// The outputs that drive direction keys, each once.
    pub drivers: Vec<TypedDriver>,
    /// The sets of direction keys in the order in which they take effect.
    pub key_order: Vec<usize>,
    /// The sources of groups' outputs, by the groups' paths: a node and the index of its
    /// output.
    pub group_outputs: GroupOutputs,
    /// The color space of the look's colors.
    pub color_space: ColorSpace,
    /// The look's name.
    pub name: String,
}

/// A node with its function chosen.
#[derive(Clone, Debug)]
pub struct TypedNode {
    /// Through the groups it lies in.
    pub path: NodePath,
    /// The artist's name of the node.
    pub name: String,
    /// The name without those of lights, of a node in a region that runs for each.
    pub shared_name: Option<String>,
    /// True if the artist gave the node a name of its own.
    pub is_named: bool,
    /// The node's definition.
    pub def: Arc<NodeDef>,
    /// The tier that the document asks for, or that was chosen.
    pub tier: Tier,
    /// Origin of the tier.
    pub tier_reason: TierReason,
    /// Index of the chosen function among those of the definition.
    pub variant: usize,
    /// In the order of the definition's inputs; `None` for inputs that the function does not take.
    pub inputs: Vec<Option<TypedInput>>,
    /// The words of its choices, by input.
    pub choices: HashMap<usize, String>,
    /// The light that it names.
    pub light: Option<LightId>,
    /// True if that light does not reach the node.
    pub is_unlit: bool,
    /// The outermost group around the node, else the frame; functions are split there.
    pub region: Option<Arc<str>>,
    /// The group around the node, as the artist sees it.
    pub group: Option<Arc<GroupLabel>>,
    /// The copy of the innermost region around the node that runs for each light.
    pub copy: Option<RegionCopy>,
}

/// The source that an input is bound to, and the type that the value is taken as.
#[derive(Clone, Debug)]
pub struct TypedInput {
    /// Origin of the value.
    pub source: TypedSource,
    /// The type that the function takes.
    pub ty: Type,
    /// The conversion from the source to that type.
    pub conversion: Conversion,
}

/// Origin of a value.
#[derive(Clone, Debug, PartialEq)]
pub enum TypedSource {
    /// An output of a node.
    Wire {
        /// The node's index.
        node: usize,
        /// The output's index.
        output: usize,
    },
    /// A value that may be edited, with what it is now.
    Param(ParamId, Value),
    /// The surroundings.
    Context(Context),
    /// A value that nobody sets.
    Fixed(Value),
}

impl TypedNode {
    /// Function of the node.
    pub fn variant(&self) -> &NodeFunction {
        &self.def.variants[self.variant]
    }

    /// Position of a choice's word among its options, by the choice's index.
    pub(super) fn position(&self, choice: usize) -> i32 {
        let word = self.choices.get(&choice);
        let options = &self.def.inputs[choice].options;
        let position = options.iter().position(|(option, _)| Some(option) == word);
        position.unwrap_or_default() as i32
    }

    /// The type of an output.
    pub fn output_type(&self, output: usize) -> Type {
        output_type(&self.def, self.variant, output)
    }
}

fn output_type(def: &NodeDef, variant: usize, output: usize) -> Type {
    let variant = &def.variants[variant];
    if variant.result_is_struct { def.outputs[output].ty.clone() } else { variant.result.clone() }
}

/// Types `look`; `root` shows another output than the look's own. Also returns warnings.
///
/// # Errors
/// Everything that is wrong, if any of it concerns the picture. What is wrong only with nodes that
/// do not reach the root comes with the graph, so that a look stays alive while something is being
/// built beside it.
pub fn check(
    look: &Look,
    library: &Library,
    root: Option<&(NodePath, PortName)>,
) -> Result<WithWarnings<TypedGraph>, Vec<Diagnostic>> {
    check_with(look, library, root, &[])
}

/// [`check`] with values that are written beside the picture, which depends on their nodes too.
///
/// # Errors
/// As [`check`].
pub(super) fn check_with(
    look: &Look,
    library: &Library,
    root: Option<&(NodePath, PortName)>,
    aovs: &[AovSource],
) -> Result<WithWarnings<TypedGraph>, Vec<Diagnostic>> {
    let check_all = |exact: &HashSet<NodePath>| check_all(look, library, (root, aovs), exact);
    let checked = check_all(&HashSet::new()).and_then(|checked| {
        let seen = tiers::seen(&checked.value, look);
        if seen.is_empty() { Ok(checked) } else { check_all(&seen) }
    });
    match checked {
        Ok(warned) => Ok(WithWarnings::new(warned.value, bounded(warned.warnings))),
        Err(problems) => Err(bounded(problems)),
    }
}

/// Check as [`check`] makes it, with as many problems as there are. Nodes of `exact` are exact
/// unless they name a tier.
fn check_all(
    look: &Look,
    library: &Library,
    (root, aovs): (Option<&(NodePath, PortName)>, &[AovSource]),
    exact: &HashSet<NodePath>,
) -> Result<WithWarnings<TypedGraph>, Vec<Diagnostic>> {
    let mut problems = Vec::new();
    let Some(flat) = flatten(look, library, exact, &mut problems) else { return Err(problems) };
    let order = order(&flat, &mut problems);
    let root = find_root(&flat, root, &mut problems);
    let found: Vec<_> = aovs.iter().map(|source| source.find(&flat)).collect();
    let named = look.aovs.iter().map(|aov| flat.output(&aov.from.node, &aov.from.port)).collect();
    let mut wrong_drivers = Vec::new();
    let driving = drivers::find(look, &flat, &mut wrong_drivers);
    // The picture depends on what drives its keys, too.
    let roots = |(node, _)| {
        let beside = found.iter().filter_map(|found| found.as_ref().ok().copied().flatten());
        let driving = driving.iter().map(|(_, node, _)| *node);
        std::iter::once(node).chain(driving).chain(beside.map(|(node, _)| node)).collect()
    };
    let reached =
        root.map_or_else(|| vec![true; flat.nodes.len()], |root| reach(&flat, roots(root)));
    let mut typer = Typer::new(look, &flat);
    let mut nodes: Vec<Option<TypedNode>> = vec![None; flat.nodes.len()];
    for &index in &order {
        let before = typer.problems.len();
        nodes[index] = typer.node(index);
        if !reached[index] {
            typer.problems[before..]
                .iter_mut()
                .for_each(|problem| problem.severity = Severity::Warning);
        }
    }
    problems.append(&mut typer.problems);
    if let Some((node, _)) =
        root.filter(|(node, _)| nodes[*node].is_none() && !has_errors(&problems))
    {
        problems.push(broken_wire(&flat, &reached, node));
    }
    let is_whole = (0..flat.nodes.len()).all(|index| !reached[index] || nodes[index].is_some());
    let stops = concern_picture(&problems, &flat, &reached);
    let Some(root) = root.filter(|_| is_whole && !stops) else { return Err(problems) };
    let order: Vec<usize> =
        order.into_iter().filter(|&index| reached[index] || nodes[index].is_some()).collect();
    let keyed = keyed_targets(look);
    let surroundings = from_surroundings(&flat);
    let typed_inputs: Vec<(ParamId, Value, Option<Value>)> =
        nodes.iter().flatten().flat_map(param_values).collect();
    let mut graph = TypedGraph {
        order: order.iter().copied().filter(|&index| nodes[index].is_some()).collect(),
        // A node that could not be typed reaches nothing; a stand-in keeps the indices.
        nodes: nodes
            .into_iter()
            .zip(&flat.nodes)
            .map(|(node, flat)| node.unwrap_or_else(|| stand_in(flat)))
            .collect(),
        params: with_defaults(flat.params, &typed_inputs).into(),
        root,
        aovs: Vec::new(),
        lights: look.lights.clone(),
        exposed: look.exposed.clone(),
        keyed,
        drivers: Vec::new(),
        key_order: Vec::new(),
        group_outputs: flat.group_outputs,
        color_space: look.color_space,
        name: look.name.clone(),
    };
    let typed = |(source, found): (&AovSource, Result<_, _>)| TypedAov::of(&graph, source, found?);
    graph.aovs = aovs.iter().zip(found).map(typed).collect();
    problems.extend(graph.check_named(look, named));
    let mut wrong_targets = wrong_drivers;
    let (drivers, mut found) = drivers::typed(&graph, look, driving);
    wrong_targets.append(&mut found);
    graph.drivers = drivers;
    let (key_order, mut found) = drivers::order(&graph, look);
    wrong_targets.append(&mut found);
    graph.key_order = key_order;
    check_targets(&graph, look, &surroundings, &mut wrong_targets);
    let stops = has_errors(&wrong_targets);
    problems.append(&mut wrong_targets);
    if stops { Err(problems) } else { Ok(WithWarnings::new(graph, problems)) }
}

/// True if an error concerns a node that the picture depends on, or no node at all. A node of an
/// unknown kind has no outputs; a node that it feeds cannot be typed, which stops the look where
/// that node is seen.
fn concern_picture(problems: &[Diagnostic], flat: &FlatGraph, reached: &[bool]) -> bool {
    let errors = || problems.iter().filter(|problem| problem.is_error());
    if errors().any(|error| error.place.node.is_none()) {
        return true;
    }
    let wrong: HashSet<&[NodeId]> =
        errors().filter_map(|error| Some(error.place.node.as_ref()?.ids())).collect();
    let lengths: BTreeSet<usize> = wrong.iter().map(|path| path.len()).collect();
    // The error of a group concerns what is in it.
    let is_wrong = |path: &[NodeId]| {
        lengths.iter().filter_map(|&length| path.get(..length)).any(|around| wrong.contains(around))
    };
    flat.nodes.iter().zip(reached).any(|(node, reached)| *reached && is_wrong(node.path.ids()))
}

/// The fault that keeps a root from being typed where nothing else was reported: a wire from a node
/// that there is not, which only a look that was not read from a file can have.
fn broken_wire(flat: &FlatGraph, reached: &[bool], root: usize) -> Diagnostic {
    let broken =
        flat.nodes.iter().zip(reached).filter(|(_, reached)| **reached).find_map(|(node, _)| {
            let input = node.inputs.iter().position(|input| *input == FlatInput::Broken)?;
            Some((node.path.clone(), node.def.inputs[input].name.clone()))
        });
    let problem =
        Diagnostic::error("broken-wire", tr!("this input is wired to a node that there is not"));
    match broken {
        Some((path, port)) => problem.node(path).port(port),
        None => problem.node(flat.nodes[root].path.clone()),
    }
    .hint(tr!("remove the wire"))
}

fn stand_in(flat: &FlatNode) -> TypedNode {
    TypedNode {
        tier: flat.tier,
        tier_reason: flat.reason,
        path: flat.path.clone(),
        name: flat.name.clone(),
        shared_name: flat.shared_name.clone(),
        is_named: flat.is_named,
        def: flat.def.clone(),
        variant: 0,
        inputs: Vec::new(),
        choices: HashMap::new(),
        light: None,
        is_unlit: false,
        region: None,
        group: None,
        copy: None,
    }
}

/// The values of a node's inputs, each with its port's own default.
fn param_values(node: &TypedNode) -> impl Iterator<Item = (ParamId, Value, Option<Value>)> + '_ {
    node.inputs.iter().zip(&node.def.inputs).filter_map(|(input, port)| {
        match &input.as_ref()?.source {
            TypedSource::Param(id, value) => {
                let default = if let Fallback::Value(value) = &port.fallback {
                    Some(value.clone())
                } else {
                    None
                };
                Some((*id, value.clone(), default))
            }
            _ => None,
        }
    })
}

/// Parameters with the defaults of their ports, where the document says nothing.
fn with_defaults(mut params: Vec<Param>, values: &[(ParamId, Value, Option<Value>)]) -> Vec<Param> {
    for (id, value, default) in values {
        let param = &mut params[*id];
        param.value.get_or_insert_with(|| value.clone());
        if param.default.is_none() {
            param.default.clone_from(default);
        }
    }
    params
}

fn keyed_targets(look: &Look) -> Vec<Target> {
    let by_direction =
        look.direction_keys.iter().flat_map(|set| &set.keys).flat_map(|key| key.values.keys());
    let mut targets: Vec<Target> =
        by_direction.chain(look.time_keys.iter().map(|track| &track.target)).cloned().collect();
    targets.sort_by_cached_key(ToString::to_string);
    targets.dedup();
    targets
}

/// Every node after what it depends on, but for rings, which are problems; their nodes come in any
/// order, so that what else is wrong with them is told too.
fn order(flat: &FlatGraph, problems: &mut Vec<Diagnostic>) -> Vec<usize> {
    let wires = flat.nodes.iter().map(|node| node.inputs.len()).sum();
    let mut graph = DiGraph::<(), (), u32>::with_capacity(flat.nodes.len(), wires);
    for _ in &flat.nodes {
        graph.add_node(());
    }
    for (index, node) in flat.nodes.iter().enumerate() {
        for input in &node.inputs {
            if let FlatInput::Wire { node: from, .. } = input {
                graph.add_edge(NodeIndex::new(*from), NodeIndex::new(index), ());
            }
        }
    }
    if let Ok(order) = petgraph::algo::toposort(&graph, None) {
        return order.into_iter().map(NodeIndex::index).collect();
    }
    let is_cycle = |component: &[NodeIndex]| {
        component.len() > 1 || graph.contains_edge(component[0], component[0])
    };
    let components = petgraph::algo::kosaraju_scc(&graph);
    problems.extend(
        components
            .iter()
            .filter(|component| is_cycle(component))
            .map(|cycle| cycle_problem(flat, cycle)),
    );
    // Components come with what depends on others first.
    components.iter().rev().flatten().map(|node| node.index()).collect()
}

fn cycle_problem(flat: &FlatGraph, cycle: &[NodeIndex]) -> Diagnostic {
    let mut paths: Vec<_> =
        cycle.iter().map(|index| flat.nodes[index.index()].path.clone()).collect();
    paths.sort();
    let names: Vec<_> = paths.iter().map(|path| format!("`{path}`")).collect();
    Diagnostic::error(
        "cycle",
        tr!("these nodes feed one another in a ring: {names}", names = names.join(", ")),
    )
    .node(paths[0].clone())
    .hint(tr!("remove one wire of the ring"))
}

fn find_root(
    flat: &FlatGraph,
    root: Option<&(NodePath, PortName)>,
    problems: &mut Vec<Diagnostic>,
) -> Option<(usize, usize)> {
    if let Some((path, port)) = root {
        return flat.output(path, port).map_err(|problem| problems.push(problem)).ok();
    }
    let outputs: Vec<_> = flat
        .nodes
        .iter()
        .enumerate()
        .filter(|(_, node)| node.def.special == Treatment::Output)
        .collect();
    match outputs.as_slice() {
        [] => {
            let problem = Diagnostic::error(
                "no-output",
                tr!("the look has no Output node, so it shows nothing"),
            );
            problems.push(problem.hint(tr!("add a node of kind `output` and wire its `color`")));
            None
        }
        [(index, _)] => Some((*index, 0)),
        [_, (_, second), ..] => {
            let problem =
                Diagnostic::error("many-outputs", tr!("the look has more than one Output node"));
            problems.push(
                problem.node(second.path.clone()).hint(tr!("keep one and remove the others")),
            );
            None
        }
    }
}

/// For each node, true if the roots depend on it.
fn reach(flat: &FlatGraph, roots: Vec<usize>) -> Vec<bool> {
    let mut reached = vec![false; flat.nodes.len()];
    let mut open = roots;
    while let Some(index) = open.pop() {
        if std::mem::replace(&mut reached[index], true) {
            continue;
        }
        open.extend(flat.nodes[index].inputs.iter().filter_map(|input| match input {
            FlatInput::Wire { node, .. } => Some(*node),
            _ => None,
        }));
    }
    reached
}

/// The inputs that have no value, because they read their surroundings.
fn from_surroundings(flat: &FlatGraph) -> HashSet<(NodePath, PortName)> {
    let inputs = flat.nodes.iter().flat_map(|node| node.inputs.iter().zip(&node.def.inputs));
    let unset = inputs.filter_map(|(input, port)| match input {
        FlatInput::Param(id) if matches!(port.fallback, Fallback::Context(_)) => {
            Some(&flat.params[*id])
        }
        _ => None,
    });
    unset
        .filter(|param| param.value.is_none())
        .map(|param| (param.path.clone(), param.port.clone()))
        .collect()
}

/// Exposed parameters and keys must name values that there are.
fn check_targets(
    graph: &TypedGraph,
    look: &Look,
    surroundings: &HashSet<(NodePath, PortName)>,
    problems: &mut Vec<Diagnostic>,
) {
    let exposed =
        look.exposed.iter().enumerate().map(|(i, e)| (&e.target, format!("exposed[{i}].target")));
    let timed = look
        .time_keys
        .iter()
        .enumerate()
        .map(|(i, track)| (&track.target, format!("time_keys[{i}].target")));
    let directed = look.direction_keys.iter().enumerate().flat_map(|(i, set)| {
        set.keys.iter().enumerate().flat_map(move |(k, key)| {
            key.values.keys().map(move |target| {
                (target, format!("direction_keys[{i}].keys[{k}].values.{target}"))
            })
        })
    });
    let known: HashSet<_> = graph.params.iter().map(|param| (&param.path, &param.port)).collect();
    for (target, json_path) in exposed.chain(timed).chain(directed) {
        let problem = match target {
            Target::Input { node, port }
                if surroundings.contains(&(node.clone(), port.clone())) =>
            {
                let message = tr!("`{target}` has no value to set: it reads the surroundings");
                let problem = Diagnostic::error("unset-target", message)
                    .node(node.clone())
                    .port(port.clone());
                problem.hint(tr!("give the input a value in the look; that is then its default"))
            }
            Target::Input { node, port } if known.contains(&(node, port)) => continue,
            Target::Light { light, field } => match light_target_problem(look, light, field) {
                None => continue,
                Some(problem) => problem,
            },
            Target::Input { .. } => {
                let names: Vec<_> =
                    graph.params.iter().map(|p| format!("{}.{}", p.path, p.port)).collect();
                Diagnostic::error("unknown-target", tr!("there is no unwired input `{target}`"))
                    .suggest(&target.to_string(), names.iter().map(String::as_str))
                    .hint(tr!("a target is `node.port` of an input that no wire feeds, or \
                           `lights.id.field`"))
            }
        };
        problems.push(problem.json_path(json_path));
    }
}

fn light_target_problem(look: &Look, light: &LightId, field: &str) -> Option<Diagnostic> {
    if !look.lights.contains_key(light) {
        let problem = Diagnostic::error("unknown-light", tr!("there is no light `{light}`"));
        return Some(problem.suggest(light.as_str(), look.lights.keys().map(AsRef::as_ref)));
    }
    LightField::named(field).is_none().then(|| {
        Diagnostic::error("unknown-target", tr!("a light has no field `{field}` that can be set"))
            .suggest(field, LightField::names())
    })
}

/// The type that a vector's numbers say.
fn vector_type(value: &Value) -> Option<Type> {
    let Value::Vector(numbers) = value else { return None };
    Some(match numbers.len() {
        2 => Type::Vec2,
        3 => Type::Vec3,
        _ => Type::Vec4,
    })
}

struct Typer<'a> {
    look: &'a Look,
    flat: &'a FlatGraph,
    /// Inputs that keys move or scenes set: each has a value of its own.
    targets: HashSet<(NodePath, PortName)>,
    /// The chosen functions of the nodes that were typed.
    variants: Vec<Option<usize>>,
    problems: Vec<Diagnostic>,
}

impl<'a> Typer<'a> {
    fn new(look: &'a Look, flat: &'a FlatGraph) -> Self {
        let exposed = look.exposed.iter().map(|exposed| exposed.target.clone());
        let targets = exposed.chain(keyed_targets(look)).filter_map(|target| match target {
            Target::Input { node, port } => Some((node, port)),
            Target::Light { .. } => None,
        });
        Self {
            look,
            flat,
            targets: targets.collect(),
            variants: vec![None; flat.nodes.len()],
            problems: Vec::new(),
        }
    }

    fn problem(&mut self, node: &FlatNode, port: Option<&Input>, problem: Diagnostic) {
        let (path, port) = match port {
            Some(input) => {
                let (path, port) = self.place(node, input);
                (path, Some(port))
            }
            None => (node.path.clone(), None),
        };
        let problem = problem.node(path);
        self.problems.push(match port {
            Some(port) => problem.port(port),
            None => problem,
        });
    }

    /// Place where the artist sets an input: on the node, or on the group around it whose input it
    /// is.
    fn place(&self, node: &FlatNode, input: &Input) -> (NodePath, PortName) {
        let index = node.def.input(input.name.as_str());
        match index.and_then(|index| node.inputs.get(index)) {
            Some(FlatInput::Param(id)) => {
                (self.flat.params[*id].path.clone(), self.flat.params[*id].port.clone())
            }
            _ => (node.path.clone(), input.name.clone()),
        }
    }

    /// The artist's name of an input.
    fn port_name(&self, node: &FlatNode, input: &Input) -> PortName {
        self.place(node, input).1
    }

    fn node(&mut self, index: usize) -> Option<TypedNode> {
        let flat = &self.flat.nodes[index];
        let before = self.problems.len();
        let mut choices = HashMap::new();
        for (i, input) in
            flat.def.inputs.iter().enumerate().filter(|(_, input)| input.ty == Type::Choice)
        {
            if let Some(word) = self.choice(flat, i, input) {
                choices.insert(i, word);
            }
        }
        let light = if flat.def.inputs.iter().any(|input| input.ty == Type::LightName) {
            self.light(flat)
        } else if flat.def.joins_lights() {
            flat.each_light().cloned()
        } else {
            None
        };
        if self.problems[before..].iter().any(Diagnostic::is_error) {
            return None;
        }
        let variant = self.variant(flat, &choices, light.as_ref())?;
        let mut inputs = vec![None; flat.def.inputs.len()];
        // The node that feeds the input may be broken, which was reported there.
        let mut is_whole = true;
        for (i, ty) in taken_inputs(&flat.def, variant) {
            inputs[i] = self.input(flat, i, ty);
            is_whole &= inputs[i].is_some();
        }
        if !is_whole {
            return None;
        }
        self.variants[index] = Some(variant);
        Some(TypedNode {
            path: flat.path.clone(),
            name: flat.name.clone(),
            shared_name: flat.shared_name.clone(),
            is_named: flat.is_named,
            def: flat.def.clone(),
            tier: flat.tier,
            tier_reason: flat.reason,
            variant,
            inputs,
            choices,
            is_unlit: light.as_ref().is_some_and(|light| flat.is_unlit_by(light)),
            light,
            region: flat.region.clone(),
            group: flat.group.clone(),
            copy: flat.copy(),
        })
    }

    fn value_text(&mut self, flat: &FlatNode, index: usize, input: &Input) -> Option<String> {
        let fallback = match &input.fallback {
            Fallback::Value(Value::Text(text)) => text.clone(),
            _ => String::new(),
        };
        match &flat.inputs[index] {
            FlatInput::Broken => None,
            FlatInput::Fixed(Value::Text(text)) => Some(text.clone()),
            FlatInput::Fixed(_) => Some(fallback),
            FlatInput::Wire { .. } | FlatInput::Context(_) => {
                let problem = Diagnostic::error(
                    "not-wirable",
                    tr!("`{name}` takes no wire: {ty}", name = input.name, ty = input.ty.label()),
                );
                self.problem(
                    flat,
                    Some(input),
                    problem.hint(tr!("remove the wire and set the value on the node")),
                );
                None
            }
            FlatInput::Param(param) => match &self.flat.params[*param].value {
                None => Some(fallback),
                Some(Value::Text(text)) => Some(text.clone()),
                Some(other) => {
                    let message = tr!(
                        "expected a text for `{port_name}`, found {found}",
                        port_name = self.port_name(flat, input),
                        found = describe(other)
                    );
                    self.problem(flat, Some(input), Diagnostic::error("wrong-type", message));
                    None
                }
            },
        }
    }

    fn choice(&mut self, flat: &FlatNode, index: usize, input: &Input) -> Option<String> {
        let word = self.value_text(flat, index, input)?;
        let words: Vec<&str> = input.options.iter().map(|option| option.0.as_str()).collect();
        if words.contains(&word.as_str()) {
            return Some(word);
        }
        let problem = Diagnostic::error(
            "unknown-choice",
            tr!("`{port_name}` cannot be `{word}`", port_name = self.port_name(flat, input)),
        )
        .suggest(&word, words.iter().copied())
        .hint(tr!("it is one of {words}", words = words.join(", ")));
        self.problem(flat, Some(input), problem);
        None
    }

    fn light(&mut self, flat: &FlatNode) -> Option<LightId> {
        let index = flat.def.inputs.iter().position(|input| input.ty == Type::LightName)?;
        let input = &flat.def.inputs[index];
        let id = self.value_text(flat, index, input)?;
        let found = if id.is_empty() {
            flat.each_light().or_else(|| self.look.lights.keys().next())
        } else {
            self.look.lights.get_key_value(id.as_str()).map(|l| l.0)
        };
        if let Some(id) = found {
            return Some(id.clone());
        }
        let message = if id.is_empty() {
            tr!("the look has no lights").to_owned()
        } else {
            tr!("there is no light `{id}`")
        };
        let problem = Diagnostic::error("unknown-light", message)
            .suggest(&id, self.look.lights.keys().map(AsRef::as_ref))
            .hint(
                text!(
                    "add it to the look: \"lights\": {\"key\": {\"direction\": [-0.5, 0.7, 0.5]}}"
                )
                .tr(),
            );
        self.problem(flat, Some(input), problem);
        None
    }

    /// The function that fits the node's choices, tier and wires best.
    fn variant(
        &mut self,
        flat: &FlatNode,
        choices: &HashMap<usize, String>,
        light: Option<&LightId>,
    ) -> Option<usize> {
        let def = &flat.def;
        let light_kind = light.map(|id| self.look.lights[id].kind.word());
        let fits = |variant: &NodeFunction| match (&variant.choice, def.special) {
            (Some((_, word)), _) if def.has_light_types() => light_kind == Some(word),
            (Some(_), Treatment::Output) => false,
            (Some((input, word)), _) => choices.get(input) == Some(word),
            (None, _) => true,
        };
        let candidates: Vec<usize> =
            (0..def.variants.len()).filter(|&i| fits(&def.variants[i])).collect();
        // The cheapest tier that is still as accurate as asked.
        let best_tier = candidates
            .iter()
            .map(|&i| def.variants[i].tier)
            .filter(|tier| *tier <= flat.tier)
            .max();
        let tier = best_tier.unwrap_or(Tier::Exact);
        let candidates = candidates.into_iter().filter(|&i| def.variants[i].tier == tier);
        let chosen = candidates.min_by_key(|&i| self.misfit(flat, i));
        if chosen.is_none() {
            let problem = Diagnostic::error(
                "bad-node-file",
                tr!("no function of this node fits its choices"),
            );
            self.problem(flat, None, problem.in_file(def.file.clone()));
        }
        chosen
    }

    /// The misfit of the wired inputs with a function: lossy conversions first, then conversions of
    /// any kind.
    fn misfit(&self, flat: &FlatNode, variant: usize) -> (usize, usize, usize) {
        let (mut impossible, mut lossy, mut converted) = (0, 0, 0);
        for (i, ty) in taken_inputs(&flat.def, variant) {
            let Some(from) = self.source_type(flat, i) else { continue };
            impossible += usize::from(from.convert_to(&ty).is_none());
            lossy += usize::from(!from.converts_without_loss(&ty));
            converted += usize::from(from != ty);
        }
        (impossible, lossy, converted)
    }

    /// The type of what feeds an input; for values, what their numbers say.
    fn source_type(&self, flat: &FlatNode, input: usize) -> Option<Type> {
        match &flat.inputs[input] {
            FlatInput::Wire { node, output } => self.variants[*node]
                .map(|variant| output_type(&self.flat.nodes[*node].def, variant, *output)),
            FlatInput::Param(param) => vector_type(self.flat.params[*param].value.as_ref()?),
            FlatInput::Context(context) => Some(Type::from_wgsl(context.wgsl_type())),
            FlatInput::Fixed(value) => vector_type(value),
            FlatInput::Broken => None,
        }
    }

    fn input(&mut self, flat: &FlatNode, index: usize, ty: Type) -> Option<TypedInput> {
        let input = &flat.def.inputs[index];
        let (source, from) = match &flat.inputs[index] {
            FlatInput::Broken => return None,
            FlatInput::Wire { .. } | FlatInput::Context(_) if ty.is_setting() => {
                let problem = Diagnostic::error(
                    "not-wirable",
                    tr!("`{name}` takes no wire: {ty}", name = input.name, ty = input.ty.label()),
                );
                self.problem(
                    flat,
                    Some(input),
                    problem.hint(tr!("remove the wire and set the value on the node")),
                );
                return None;
            }
            FlatInput::Fixed(value) => (TypedSource::Fixed(value.clone()), ty.clone()),
            FlatInput::Context(context) => {
                let context = context.at_tier(flat.tier, false);
                (TypedSource::Context(context), Type::from_wgsl(context.wgsl_type()))
            }
            FlatInput::Wire { node, output } => {
                // A source that could not be typed was reported there.
                let from = self.source_type(flat, index)?;
                (TypedSource::Wire { node: *node, output: *output }, from)
            }
            FlatInput::Param(param) => match self.same(flat, input, *param) {
                Some(other) => return self.input(flat, other, ty),
                None => self.param(flat, index, *param, &ty)?,
            },
        };
        let Some(conversion) = from.convert_to(&ty) else {
            let message = tr!(
                "`{name}` takes {ty}, and is wired to {from}",
                name = input.name,
                ty = ty.label(),
                from = from.label()
            );
            self.problem(
                flat,
                Some(input),
                Diagnostic::error("wrong-type", message).hint(conversion_hint(&from, &ty)),
            );
            return None;
        };
        Some(TypedInput { source, ty, conversion })
    }

    /// The other input that an unset one is the same as, unless something sets this one.
    fn same(&self, flat: &FlatNode, input: &Input, param: ParamId) -> Option<usize> {
        let param = &self.flat.params[param];
        match &input.fallback {
            Fallback::Same(other) if param.value.is_none() => {
                let is_set = self.targets.contains(&(param.path.clone(), param.port.clone()));
                flat.def.input(other.as_str()).filter(|_| !is_set)
            }
            _ => None,
        }
    }

    /// The value that an input that is the same as `other` begins with, where keys or scenes set it
    /// later.
    fn value_of_other(&self, flat: &FlatNode, other: &PortName, ty: &Type) -> Value {
        let index = flat.def.input(other.as_str());
        let own = index.and_then(|index| match &flat.inputs[index] {
            FlatInput::Param(id) => self.flat.params[*id].value.clone(),
            _ => None,
        });
        let default = index.and_then(|index| match &flat.def.inputs[index].fallback {
            Fallback::Value(value) => Some(value.clone()),
            _ => None,
        });
        let neutral = || Value::Vector(vec![1.0; ty.width().unwrap_or(1)]);
        own.or(default).unwrap_or_else(neutral)
    }

    fn param(
        &mut self,
        flat: &FlatNode,
        index: usize,
        param: ParamId,
        ty: &Type,
    ) -> Option<(TypedSource, Type)> {
        let input = &flat.def.inputs[index];
        let explicit = self.flat.params[param].value.as_ref();
        let value = match (explicit, &input.fallback) {
            // A hex color is as shown, whatever the numbers of the look's other colors mean.
            (Some(value), _) if matches!(ty, Type::Color | Type::Composite) => {
                value.clone().in_space(self.look.color_space)
            }
            (Some(value), _) => value.clone(),
            (None, Fallback::Value(value)) => value.clone(),
            (None, Fallback::Context(context)) => {
                let context = context.at_tier(flat.tier, input.hidden);
                return Some((TypedSource::Context(context), Type::from_wgsl(context.wgsl_type())));
            }
            (None, Fallback::Same(other)) => self.value_of_other(flat, other, ty),
            (None, Fallback::Wire) => {
                let problem = Diagnostic::error(
                    "unwired",
                    tr!("`{port_name}` must be wired", port_name = self.port_name(flat, input)),
                );
                self.problem(
                    flat,
                    Some(input),
                    problem.hint(tr!("wire it to an output of type {ty}", ty = ty.label())),
                );
                return None;
            }
        };
        if ty.is_texture() {
            return match value {
                Value::Text(_) => Some((TypedSource::Param(param, value), ty.clone())),
                other => {
                    let message = tr!(
                        "expected {expected}, found {found}",
                        expected = expected(ty),
                        found = describe(&other)
                    );
                    self.problem(flat, Some(input), Diagnostic::error("wrong-type", message));
                    None
                }
            };
        }
        if let Err(message) = typed_value(&value, ty) {
            // The value that a muted node lets through may be of another type, and becomes this one
            // as its wire would.
            let (path, port) = self.place(flat, input);
            let own = vector_type(&value).filter(|own| own.convert_to(ty).is_some());
            if let Some(own) = own.filter(|_| (&path, &port) != (&flat.path, &input.name)) {
                return Some((TypedSource::Param(param, value), own));
            }
            self.problem(
                flat,
                Some(input),
                Diagnostic::error(
                    "wrong-type",
                    format!("`{}`: {message}", self.port_name(flat, input)),
                ),
            );
            return None;
        }
        if explicit.is_some() {
            self.range(flat, input, &value);
        }
        Some((TypedSource::Param(param, value), ty.clone()))
    }

    /// Values beyond a port's range still have a meaning, because every node is total; they are
    /// worth a word.
    fn range(&mut self, flat: &FlatNode, input: &Input, value: &Value) {
        let numbers = match value {
            Value::Number(x) => std::slice::from_ref(x),
            Value::Vector(v) => v.as_slice(),
            _ => return,
        };
        // Files hold rounded numbers: 3.1416 is meant to be pi.
        let slack = 1e-4;
        let below = input.min.filter(|min| numbers.iter().any(|x| *x < min - slack));
        let above = input.max.filter(|max| numbers.iter().any(|x| *x > max + slack));
        if below.is_none() && above.is_none() {
            return;
        }
        let range = match (input.min, input.max) {
            (Some(min), Some(max)) => tr!("between {min} and {max}"),
            (Some(min), None) => tr!("at least {min}"),
            (None, Some(max)) => tr!("at most {max}"),
            (None, None) => return,
        };
        let message = tr!(
            "`{port_name}` is {value}, outside its range",
            port_name = self.port_name(flat, input),
            value = describe(value)
        );
        let problem = Diagnostic::warning("out-of-range", message).hint(tr!("use a value {range}"));
        self.problem(flat, Some(input), problem);
    }
}

fn conversion_hint(from: &Type, to: &Type) -> &'static str {
    match (from, to) {
        (Type::Light, _) => {
            tr!("a Parametrization turns a light into an angle; Light parts gives its direction \
                 and color")
        }
        (Type::Angle, _) => tr!("a Profile turns an angle into a tone"),
        (_, Type::Light) => tr!("wire a Light node"),
        (_, Type::Angle) => tr!("wire a Parametrization"),
        (Type::Vec2 | Type::Vec3 | Type::Vec4, Type::Float) => {
            tr!("take one number with Separate vector, or its Length")
        }
        _ => tr!("put a node between them that turns the one into the other"),
    }
}

/// The inputs that a function and the node's `prepare` take, with their types.
fn taken_inputs(def: &NodeDef, variant: usize) -> Vec<(usize, Type)> {
    let mut taken = Vec::new();
    for parameter in &def.variants[variant].parameters {
        match parameter {
            ArgumentSource::Input(index, ty) => taken.push((*index, ty.clone())),
            ArgumentSource::Prepared => {
                taken.extend(
                    def.prepare.iter().flat_map(|prepare| prepare.parameters.iter().cloned()),
                );
            }
            ArgumentSource::Sampler(_) | ArgumentSource::Choice(_) => {}
        }
    }
    if def.special == Treatment::Output {
        // The other roots' inputs, for the passes that they feed.
        for root in def.variants.iter().filter(|root| root.choice.is_some()) {
            taken.extend(root.parameters.iter().filter_map(|parameter| match parameter {
                ArgumentSource::Input(index, ty) => Some((*index, ty.clone())),
                _ => None,
            }));
        }
    }
    taken
}
