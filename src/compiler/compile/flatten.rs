//! Inlines groups: a flat list of library nodes, each input bound to an output, a value or its
//! fallback.
//!
//! Nothing recurses over the graph. Scopes (the look's graph and each use of a definition) come
//! from a work list, and an input is resolved by a loop that walks through groups and reroutes,
//! over each of them once: what lies behind an input on the way is remembered.

mod groups;
mod links;
mod regions;
#[cfg(test)]
mod tests;

use std::cell::{Cell, RefCell};
use std::collections::hash_map::Entry;
use std::collections::{BTreeSet, HashMap, HashSet};
use std::sync::Arc;

use chiaro_locale::{text, tr};

use self::groups::{GroupIndex, UsedGroups};
use self::links::FilterNode;
use self::regions::{Region, RegionPlace, without_lights};
pub use self::regions::{RegionCopy, RegionIndex};

use super::titles::own_name;
use crate::diag::Diagnostic;
use crate::document::{Definition, Graph, InterfacePort, Look, Node, Tier, Value, Wire};
use crate::ids::{GROUP_INPUTS, GROUP_OUTPUTS, LightId, NodeId, NodePath, PortName};
use crate::library::{
    CUSTOM_CODE, CUSTOM_KIND, Context, Fallback, GroupPorts, Input, Library, NodeDef, Output,
    Treatment, Type, load_node,
};

/// Greatest number of nodes of a look once its groups are inlined.
pub const MAX_FLAT_NODES: usize = 1_000_000;

/// Number of problems that have suggestions and lists of names; for more, that takes longer than
/// it helps.
const MAX_SUGGESTIONS: usize = 100;
/// Number of kinds that are searched for one that was meant.
const MAX_KINDS: usize = 10_000;
/// Number of ports that are listed.
const MAX_LISTED: usize = 64;
/// The longest name of a node with the names of the groups around it, in bytes.
const MAX_NAME: usize = 256;

/// An index into the parameters of a look.
pub type ParamId = usize;

/// A value that the artist may edit: an unwired input, at the outermost node that holds it.
#[derive(Clone, Debug, PartialEq)]
pub struct Param {
    /// The node.
    pub path: NodePath,
    /// Input of the node.
    pub port: PortName,
    /// The document's value, or the port's default once the look is checked; `None` for a context.
    pub value: Option<Value>,
    /// The value where the document has none, as `value` is resolved.
    pub default: Option<Value>,
}

/// The source that an input is bound to.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum FlatInput {
    /// An output of a node.
    Wire {
        /// The node's index.
        node: usize,
        /// The output's index.
        output: usize,
    },
    /// A value, or the port's fallback where the parameter has none.
    Param(ParamId),
    /// The context that a muted node lets through, since its own input reads it.
    Context(Context),
    /// A value that nobody sets.
    Fixed(Value),
    /// Value that was reported already.
    Broken,
}

/// Origin of a node's tier.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum TierReason {
    /// Name in the document.
    Named,
    /// Choice of the cheapest: nobody can see the difference.
    Unseen,
    /// Stated difference of a cheaper one, which is greater than the look allows.
    Stated,
    /// Difference of a cheaper one that would grow beyond what the look allows on its way to the
    /// picture.
    Grows,
}

/// A library node with its place in the document.
#[derive(Clone, Debug)]
pub(super) struct FlatNode {
    /// Through the groups it lies in.
    pub path: NodePath,
    /// The artist's name, with the names of the groups around the node.
    pub name: String,
    /// The name without those of lights, of a node in a region that runs for each.
    pub shared_name: Option<String>,
    /// True if the artist gave the node a name of its own.
    pub is_named: bool,
    /// The node's definition.
    pub def: Arc<NodeDef>,
    /// Implementation that the document asks for, or that was chosen.
    pub tier: Tier,
    /// Origin of the tier.
    pub reason: TierReason,
    /// In the order of the definition's inputs.
    pub inputs: Vec<FlatInput>,
    /// The region around the node: the outermost group, else the frame; functions are split there.
    pub region: Option<Arc<str>>,
    /// The group around the node, as the artist sees it.
    pub group: Option<Arc<GroupLabel>>,
    /// The place in the innermost region that runs for each light.
    place: Option<RegionPlace>,
    /// Lights that reach the node; `None` for all.
    lights: Option<Arc<BTreeSet<LightId>>>,
}

/// Names of a group around nodes: the outermost of the library's groups, in which nobody sees a
/// node, or else the innermost of the look's own.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GroupLabel {
    /// Name that the artist gave the group's node, with the names of the groups around that.
    pub name: String,
    /// The name without those of lights, of a group in a region that runs for each.
    pub shared_name: String,
    /// Label of the group's kind.
    pub label: String,
    /// True if the group is of the library.
    pub is_of_library: bool,
}

impl FlatNode {
    /// The light that the copy of the region is for; `None` outside of regions.
    pub(super) fn each_light(&self) -> Option<&LightId> {
        self.place.as_ref()?.light.as_ref()
    }

    /// True if a light does not reach the node.
    pub(super) fn is_unlit_by(&self, light: &LightId) -> bool {
        self.lights.as_ref().is_some_and(|lights| !lights.contains(light))
    }

    /// The copy of the innermost region that the node lies in.
    pub(super) fn copy(&self) -> Option<RegionCopy> {
        Some(self.place.as_ref()?.copy)
    }
}

/// A look without groups.
#[derive(Clone, Debug, Default)]
pub(super) struct FlatGraph {
    /// In document order, groups in place.
    pub nodes: Vec<FlatNode>,
    /// Every value, in the order of first use.
    pub params: Vec<Param>,
    /// By path.
    pub by_path: HashMap<NodePath, usize>,
    /// The sources of a group's outputs, by the group's path; the empty port is the first output.
    pub group_outputs: GroupOutputs,
}

/// By the group's path and the output's name, a node and the index of its output.
pub type GroupOutputs = HashMap<NodePath, HashMap<PortName, (usize, usize)>>;

impl FlatGraph {
    /// The node and the index of an output by path and name; the empty name is the first output.
    ///
    /// # Errors
    /// A diagnostic that there is no such node or output, with near names.
    pub(super) fn output(
        &self,
        path: &NodePath,
        port: &PortName,
    ) -> Result<(usize, usize), Diagnostic> {
        if let Some(outputs) = self.group_outputs.get(path) {
            return outputs.get(port).copied().ok_or_else(|| {
                let problem = Diagnostic::error(
                    "unknown-port",
                    tr!("the group `{path}` has no output `{port}`"),
                );
                let known = outputs.keys().map(PortName::as_str).filter(|name| !name.is_empty());
                problem.node(path.clone()).suggest(port.as_str(), known)
            });
        }
        let Some(&node) = self.by_path.get(path) else {
            let nodes = self.nodes.iter().map(|node| &node.path);
            let paths = nodes.chain(self.group_outputs.keys()).map(ToString::to_string);
            let known: BTreeSet<String> = paths.collect();
            let problem = Diagnostic::error("unknown-node", tr!("there is no node `{path}`"));
            return Err(problem.suggest(&path.to_string(), known.iter().map(String::as_str)));
        };
        let def = &self.nodes[node].def;
        let output = def.output(port.as_str()).ok_or_else(|| {
            let problem =
                Diagnostic::error("unknown-port", tr!("the node `{path}` has no output `{port}`"));
            let known = def.outputs.iter().map(|output| output.name.as_str());
            problem.node(path.clone()).suggest(port.as_str(), known)
        })?;
        Ok((node, output))
    }

    /// The node and the index of an output of a node's copy for a light.
    ///
    /// # Errors
    /// As [`output`](Self::output); where there is no such copy, the output of any.
    pub(super) fn output_of_copy(
        &self,
        path: &NodePath,
        port: &PortName,
        light: &LightId,
    ) -> Result<(usize, usize), Diagnostic> {
        let (any, output) = self.output(path, port)?;
        let is_copy = |node: &FlatNode| node.path == *path && node.each_light() == Some(light);
        Ok((self.nodes.iter().position(is_copy).unwrap_or(any), output))
    }
}

enum FlatSlot {
    Flat(usize),
    Group(usize),
    Missing,
}

struct Scope<'a> {
    graph: &'a Graph,
    group: Option<GroupIndex>,
    path: Option<NodePath>,
    name: String,
    /// The name without those of the lights that copies are for.
    shared_name: String,
    region: Option<Arc<str>>,
    /// The group that nodes of the scope show.
    shown: Option<Arc<GroupLabel>>,
    /// The tier of nodes in the scope that name none of their own; `None` for the cheapest of each
    /// within the look's bound.
    tier: Option<Tier>,
    parent: Option<(usize, &'a NodeId)>,
    /// The copy of the innermost region that runs for each light.
    copy: Option<RegionCopy>,
    /// Lights that reach what is in it; `None` for all.
    lights: Option<Arc<BTreeSet<LightId>>>,
    /// The scope whose values are those of this one, where it is a later copy.
    values: Option<usize>,
    slots: HashMap<&'a str, FlatSlot>,
    wires: HashMap<(&'a str, &'a str), &'a Wire>,
}

impl<'a> Scope<'a> {
    /// A scope of a graph that lies in no group.
    fn of(graph: &'a Graph, name: String, tier: Option<Tier>) -> Self {
        Self {
            graph,
            group: None,
            path: None,
            shared_name: name.clone(),
            name,
            region: None,
            shown: None,
            tier,
            parent: None,
            copy: None,
            lights: None,
            values: None,
            slots: HashMap::new(),
            wires: HashMap::new(),
        }
    }
}

struct Flattener<'a> {
    look: &'a Look,
    library: &'a Library,
    /// Nodes that are exact unless a tier is named for them.
    exact: &'a HashSet<NodePath>,
    scopes: Vec<Scope<'a>>,
    /// For each flat node, its scope and document node.
    origins: Vec<(usize, &'a NodeId, &'a Node)>,
    flat: FlatGraph,
    param_ids: HashMap<(usize, &'a str, PortName), ParamId>,
    groups: UsedGroups<'a>,
    regions: Vec<Region>,
    /// Nodes that some lights pass by.
    filters: Vec<FilterNode<'a>>,
    /// Nodes that the light on its way through them passes by, by scope and id.
    passed_by: HashSet<(usize, &'a str)>,
    /// The ports of muted groups, which let their inputs through.
    group_ports: RefCell<HashMap<&'a str, Arc<GroupPorts>>>,
    /// The ends behind inputs that lead on to others: those of reroutes and groups, and whatever
    /// they feed.
    ends: HashMap<InputKey<'a>, WireEnd<'a>>,
    /// The faults of the files of kinds, by kind.
    broken_kinds: HashMap<&'a str, &'a Diagnostic>,
    problems: Vec<Diagnostic>,
    /// The number of problems that have suggestions.
    suggestions: Cell<usize>,
    /// The number of wires that were followed.
    #[cfg(test)]
    followed: Cell<usize>,
}

/// An input by its scope, node and port.
type InputKey<'a> = (usize, &'a str, PortName);

/// The end that lies behind an input.
#[derive(Clone)]
enum WireEnd<'a> {
    /// An output of a node.
    Output {
        /// The node's index.
        node: usize,
        /// The output's index.
        output: usize,
    },
    /// An input that nothing is wired to.
    Open {
        scope: usize,
        id: &'a NodeId,
        port: PortName,
        /// The fallback without a value, where an interface on the way has one.
        fallback: Option<Fallback>,
    },
    /// A zero, as if it were a value of a muted node's output.
    Zero { scope: usize, id: &'a NodeId, port: PortName, zero: Value },
    /// Value that was reported already.
    Broken,
    /// A ring of reroutes or groups.
    Ring,
}

/// Inlines the groups of `look`. Problems are added to `problems`; what can be made out is
/// returned, or nothing where the look would become too large. Nodes of `exact` are exact unless a
/// tier is named for them.
pub(super) fn flatten(
    look: &Look,
    library: &Library,
    exact: &HashSet<NodePath>,
    problems: &mut Vec<Diagnostic>,
) -> Option<FlatGraph> {
    let groups = UsedGroups::of(look, library).map_err(|problem| problems.push(*problem)).ok()?;
    let mut flattener = Flattener::new(look, library, exact, groups);
    flattener.run();
    problems.append(&mut flattener.problems);
    Some(flattener.flat)
}

/// The faults of a project's own files, by the kinds that they would be.
fn broken_kinds(library: &Library) -> HashMap<&str, &Diagnostic> {
    let mut broken = HashMap::new();
    for problem in &library.problems {
        let stem = problem.place.file.as_deref().and_then(|file| file.rsplit(['/', '\\']).next());
        if let Some(kind) = stem.and_then(|stem| stem.split('.').next()) {
            broken.entry(kind).or_insert(problem);
        }
    }
    broken
}

impl<'a> Flattener<'a> {
    fn new(
        look: &'a Look,
        library: &'a Library,
        exact: &'a HashSet<NodePath>,
        groups: UsedGroups<'a>,
    ) -> Self {
        Self {
            look,
            library,
            exact,
            scopes: Vec::new(),
            origins: Vec::new(),
            flat: FlatGraph::default(),
            param_ids: HashMap::new(),
            groups,
            regions: Vec::new(),
            filters: Vec::new(),
            passed_by: HashSet::new(),
            group_ports: RefCell::default(),
            ends: HashMap::new(),
            broken_kinds: broken_kinds(library),
            problems: Vec::new(),
            suggestions: Cell::new(0),
            #[cfg(test)]
            followed: Cell::new(0),
        }
    }

    fn run(&mut self) {
        self.open_scopes();
        self.check_wires();
        self.find_passed_by();
        self.bind_inputs();
        self.bind_group_outputs();
        self.check_regions();
    }

    fn open_scopes(&mut self) {
        let look = Scope::of(&self.look.graph, String::new(), self.look.tier);
        self.push_scope(look);
        let mut next = 0;
        while next < self.scopes.len() {
            self.fill_scope(next);
            next += 1;
        }
    }

    /// True if one more problem may have suggestions; counts that problem.
    fn may_suggest(&self) -> bool {
        self.suggestions.set(self.suggestions.get() + 1);
        self.suggestions.get() <= MAX_SUGGESTIONS
    }

    /// Adds a scope, and returns its index.
    fn push_scope(&mut self, mut scope: Scope<'a>) -> usize {
        scope.wires.reserve(scope.graph.wires.len());
        for wire in &scope.graph.wires {
            // Two wires into one input were reported when the document was read; the first one
            // holds.
            scope.wires.entry((wire.to.node.as_str(), wire.to.port.as_str())).or_insert(wire);
        }
        scope.slots.reserve(scope.graph.nodes.len());
        let index = self.scopes.len();
        if let (Some(copy), Some(path)) = (scope.copy, &scope.path) {
            scope.values = self.note_copy(index, path, copy);
        }
        self.scopes.push(scope);
        index
    }

    fn fill_scope(&mut self, scope: usize) {
        let graph = self.scopes[scope].graph;
        let mut framed: HashMap<&NodeId, Arc<str>> = HashMap::new();
        for (id, frame) in &graph.frames {
            let title: Arc<str> = if frame.title.is_empty() {
                id.as_str().into()
            } else {
                frame.title.as_str().into()
            };
            framed.extend(frame.nodes.iter().map(|node| (node, title.clone())));
        }
        for (id, node) in &graph.nodes {
            let path = self.path_of(scope, id);
            let slot = if let Some(group) = self.groups.get(&node.kind) {
                self.open_group(scope, id, node, group, path, framed.get(id).cloned())
            } else {
                if node.for_each.is_some() {
                    let message = tr!("`for_each` is for groups: this node runs once");
                    let problem = Diagnostic::warning("not-a-group", message).node(path.clone());
                    self.problems
                        .push(problem.hint(tr!("make a group of it (Ctrl+G), and set it there")));
                }
                match self.node_def(node, &path) {
                    Some(def) => {
                        let region =
                            self.scopes[scope].region.clone().or_else(|| framed.get(id).cloned());
                        FlatSlot::Flat(self.push_node(scope, id, node, def, path, region))
                    }
                    None => FlatSlot::Missing,
                }
            };
            self.scopes[scope].slots.insert(id.as_str(), slot);
        }
    }

    fn path_of(&self, scope: usize, id: &NodeId) -> NodePath {
        self.scopes[scope]
            .path
            .as_ref()
            .map_or_else(|| NodePath::root(id.clone()), |path| path.join(id.clone()))
    }

    fn open_group(
        &mut self,
        scope: usize,
        id: &'a NodeId,
        node: &'a Node,
        group: GroupIndex,
        path: NodePath,
        frame: Option<Arc<str>>,
    ) -> FlatSlot {
        let (kind, definition) = (self.groups[group].kind, self.groups[group].definition);
        if self.scopes[scope].group.is_some_and(|outer| self.groups.is_recursive(outer, group)) {
            self.problems.push(
                Diagnostic::error("recursive-group", tr!("the group `{kind}` contains itself"))
                    .node(path)
                    .hint(tr!("remove this node, or make a group of its own for what it holds")),
            );
            return FlatSlot::Missing;
        }
        let label = if definition.label.is_empty() { kind } else { &definition.label };
        let own = own_name(id, &node.name, label);
        let [name, shared_name] = self.names_of(scope, &own);
        let region =
            self.scopes[scope].region.clone().or(frame).unwrap_or_else(|| own.as_str().into());
        let tier = node.tier.or(self.scopes[scope].tier);
        let inputs = &self.groups[group].inputs;
        let is_known = |port: &str| inputs.contains_key(port);
        let unknown = self.unknown_values(node, &path, is_known, || port_names(&definition.inputs));
        self.problems.extend(unknown);
        let lights = self.lights_reaching(scope, node, &path);
        self.note_filter(scope, id, node, &path);
        let around = self.scopes[scope].shown.clone().filter(|around| around.is_of_library);
        let is_of_library = !self.look.definitions.contains_key(kind);
        let label = label.to_owned();
        let shown = |name: &String| {
            let label = || GroupLabel {
                name: name.clone(),
                shared_name: shared_name.clone(),
                label: label.clone(),
                is_of_library,
            };
            around.clone().unwrap_or_else(|| Arc::new(label()))
        };
        let of_group = |name: String, copy: Option<RegionCopy>, path: &NodePath| Scope {
            group: Some(group),
            path: Some(path.clone()),
            region: Some(region.clone()),
            shown: Some(shown(&name)),
            parent: Some((scope, id)),
            copy,
            shared_name: shared_name.clone(),
            lights: lights.clone(),
            ..Scope::of(&definition.graph, name, tier)
        };
        let around = self.scopes[scope].copy;
        let Some(set) = &node.for_each else {
            return FlatSlot::Group(self.push_scope(of_group(name, around, &path)));
        };
        let mut each = self.lights_of(set, &path);
        // Lights that do not reach the group are no rounds of it.
        each.retain(|id| lights.as_ref().is_none_or(|lights| lights.contains(id)));
        let region = self.push_region(around.map(|copy| copy.region), each);
        let first = self.scopes.len();
        for copy in 0..self.copies(region) {
            let copy = RegionCopy { region, copy };
            let light = self.light_of(copy).map(|(id, light)| light.display_name(id));
            let name = light.map_or_else(|| name.clone(), |light| join_names(&name, light));
            self.push_scope(of_group(name, Some(copy), &path));
        }
        FlatSlot::Group(first)
    }

    fn node_def(&mut self, node: &Node, path: &NodePath) -> Option<Arc<NodeDef>> {
        if node.kind == CUSTOM_KIND {
            return self.custom_def(node, path);
        }
        if let Some(def) = self.library.nodes.get(&node.kind) {
            return Some(def.clone());
        }
        let problem = match self.broken_kinds.get(node.kind.as_str()) {
            Some(&problem) => {
                Diagnostic { severity: crate::diag::Severity::Error, ..problem.clone() }
            }
            None => self.unknown_kind(&node.kind),
        };
        self.problems.push(problem.node(path.clone()));
        None
    }

    fn unknown_kind(&self, kind: &str) -> Diagnostic {
        let problem = Diagnostic::error("unknown-kind", tr!("there is no node of kind `{kind}`"));
        if !self.may_suggest() {
            return problem;
        }
        let own = self.look.definitions.keys().map(AsRef::as_ref).take(MAX_KINDS);
        let known = self.library.kinds().chain(own).chain([CUSTOM_KIND]);
        problem.suggest(kind, known).hint(tr!("`chiaro nodes` lists every kind"))
    }

    fn custom_def(&mut self, node: &Node, path: &NodePath) -> Option<Arc<NodeDef>> {
        let code = match node.values.get(CUSTOM_CODE) {
            Some(Value::Text(code)) => code.as_str(),
            _ => {
                let problem = Diagnostic::error("missing-code", tr!("this WGSL node has no code"));
                let hint =
                    text!("give it a function: `fn tint(color: Color) -> Color { return color; }`")
                        .tr();
                self.problems.push(problem.node(path.clone()).port(CUSTOM_CODE.into()).hint(hint));
                return None;
            }
        };
        match load_node(&format!("{path}.wgsl"), code, Some(CUSTOM_KIND)) {
            Ok(def) => Some(Arc::new(def)),
            Err(problems) => {
                let on_node =
                    |problem: Diagnostic| problem.node(path.clone()).port(CUSTOM_CODE.into());
                self.problems.extend(problems.into_iter().map(on_node));
                None
            }
        }
    }

    /// The name of a node of a scope with the names around it, and that which copies share.
    fn names_of(&self, scope: usize, own: &str) -> [String; 2] {
        let scope = &self.scopes[scope];
        [&scope.name, &scope.shared_name].map(|outer| join_names(outer, own))
    }

    fn push_node(
        &mut self,
        scope: usize,
        id: &'a NodeId,
        node: &'a Node,
        def: Arc<NodeDef>,
        path: NodePath,
        region: Option<Arc<str>>,
    ) -> usize {
        let own = own_name(id, &node.name, &def.label);
        let [name, shared] = self.names_of(scope, &own);
        let shared_name = self.scopes[scope].copy.map(|_| shared);
        let code = (node.kind == CUSTOM_KIND).then_some(CUSTOM_CODE);
        let known = || def.visible_inputs().map(|input| input.name.as_str()).chain(code);
        let is_known = |port: &str| known().any(|name| name == port);
        let unknown = self.unknown_values(node, &path, is_known, || known().collect());
        self.problems.extend(unknown);
        let is_custom = code.is_some();
        self.problems.extend(def.notes.iter().cloned().map(|note| {
            // The code of a custom node has no file; that of others is told of once, however many
            // nodes there are.
            if is_custom { note.node(path.clone()).port(CUSTOM_CODE.into()) } else { note }
        }));
        let index = self.flat.nodes.len();
        // Of the copies for many lights the first is what the path names.
        self.flat.by_path.entry(path.clone()).or_insert(index);
        let asked = node.tier.or(self.scopes[scope].tier);
        let (tier, reason) = match asked {
            Some(tier) => (tier, TierReason::Named),
            None if self.exact.contains(&path) => (Tier::Exact, TierReason::Grows),
            None => match def.cheapest_within(self.look.max_error) {
                Tier::Exact => (Tier::Exact, TierReason::Stated),
                cheaper => (cheaper, TierReason::Unseen),
            },
        };
        let inputs = Vec::new();
        let is_named = !node.name.is_empty();
        let place = self.place_of(scope);
        let group = self.scopes[scope].shown.clone();
        let lights = self.lights_reaching(scope, node, &path);
        self.note_filter(scope, id, node, &path);
        self.check_layered(scope, node, &def, &path);
        let flat = FlatNode {
            path,
            name,
            shared_name,
            is_named,
            def,
            tier,
            reason,
            inputs,
            region,
            group,
            place,
            lights,
        };
        self.flat.nodes.push(flat);
        self.origins.push((scope, id, node));
        index
    }

    /// Values of inputs that there are not. The names of those that there are, which may be very
    /// many, are asked for only where they are told.
    fn unknown_values<'n>(
        &self,
        node: &Node,
        path: &NodePath,
        is_known: impl Fn(&str) -> bool,
        known: impl Fn() -> Vec<&'n str>,
    ) -> Vec<Diagnostic> {
        let unknown = node.values.keys().filter(|port| !is_known(port.as_str()));
        unknown.map(|port| self.unknown_input(&node.kind, path, port, &known)).collect()
    }

    fn unknown_input<'n>(
        &self,
        kind: &str,
        path: &NodePath,
        port: &PortName,
        known: impl FnOnce() -> Vec<&'n str>,
    ) -> Diagnostic {
        let message = tr!("a node of kind `{kind}` has no input `{port}`");
        let problem =
            Diagnostic::error("unknown-port", message).node(path.clone()).port(port.clone());
        if !self.may_suggest() {
            return problem;
        }
        let known = known();
        problem
            .suggest(port.as_str(), known.iter().copied())
            .hint(list_of(tr!("its inputs are"), &known))
    }

    /// Wires to and from ports that there are not.
    fn check_wires(&mut self) {
        for scope in 0..self.scopes.len() {
            let graph = self.scopes[scope].graph;
            for wire in &graph.wires {
                let problems = [self.bad_target(scope, wire), self.bad_source(scope, wire)];
                self.problems.extend(problems.into_iter().flatten());
            }
        }
    }

    fn bad_target(&self, scope: usize, wire: &Wire) -> Option<Diagnostic> {
        let (id, port) = (&wire.to.node, &wire.to.port);
        let here = &self.scopes[scope];
        let told = |kind: &str, is_known: bool, known: &dyn Fn() -> Vec<&'a str>| {
            (!is_known).then(|| self.unknown_input(kind, &self.path_of(scope, id), port, known))
        };
        if let (GROUP_OUTPUTS, Some(group)) = (id.as_str(), here.group) {
            let group = &self.groups[group];
            let is_known = group.outputs.contains_key(port.as_str());
            return told(group.kind, is_known, &|| port_names(&group.definition.outputs));
        }
        let kind = here.graph.nodes.get(id).map_or("", |node| node.kind.as_str());
        match here.slots.get(id.as_str())? {
            FlatSlot::Flat(index) => {
                let inputs = || self.flat.nodes[*index].def.visible_inputs();
                let is_known = inputs().any(|input| input.name == *port);
                (!is_known).then(|| {
                    let known = || inputs().map(|input| input.name.as_str()).collect();
                    self.unknown_input(kind, &self.path_of(scope, id), port, known)
                })
            }
            FlatSlot::Group(child) => {
                let group = &self.groups[self.scopes[*child].group?];
                let is_known = group.inputs.contains_key(port.as_str());
                told(kind, is_known, &|| port_names(&group.definition.inputs))
            }
            FlatSlot::Missing => None,
        }
    }

    fn bad_source(&self, scope: usize, wire: &Wire) -> Option<Diagnostic> {
        let (id, port) = (&wire.from.node, &wire.from.port);
        let here = &self.scopes[scope];
        // Without a name the first is meant.
        let is_first = |count: usize| port.as_str().is_empty() && count > 0;
        if let (GROUP_INPUTS, Some(group)) = (id.as_str(), here.group) {
            let group = &self.groups[group];
            let ports = &group.definition.inputs;
            let is_known = group.inputs.contains_key(port.as_str()) || is_first(ports.len());
            return (!is_known).then(|| self.unknown_output(scope, wire, || port_names(ports)));
        }
        match here.slots.get(id.as_str())? {
            FlatSlot::Flat(index) => {
                let outputs = &self.flat.nodes[*index].def.outputs;
                let is_known =
                    outputs.iter().any(|output| output.name == *port) || is_first(outputs.len());
                let known = || outputs.iter().map(|output| output.name.as_str()).collect();
                (!is_known).then(|| self.unknown_output(scope, wire, known))
            }
            FlatSlot::Group(child) => {
                let group = &self.groups[self.scopes[*child].group?];
                let ports = &group.definition.outputs;
                let is_known = group.outputs.contains_key(port.as_str()) || is_first(ports.len());
                (!is_known).then(|| self.unknown_output(scope, wire, || port_names(ports)))
            }
            FlatSlot::Missing => None,
        }
    }

    fn unknown_output<'n>(
        &self,
        scope: usize,
        wire: &Wire,
        known: impl FnOnce() -> Vec<&'n str>,
    ) -> Diagnostic {
        let (id, port) = (&wire.from.node, &wire.from.port);
        let message = tr!("the node `{id}` has no output `{port}`");
        let problem = Diagnostic::error("unknown-port", message)
            .node(self.path_of(scope, id))
            .port(port.clone());
        if !self.may_suggest() {
            return problem;
        }
        let known = known();
        problem
            .suggest(port.as_str(), known.iter().copied())
            .hint(list_of(tr!("its outputs are"), &known))
    }

    fn bind_inputs(&mut self) {
        for index in 0..self.origins.len() {
            let (scope, id, _) = self.origins[index];
            let def = self.flat.nodes[index].def.clone();
            let bound = def.inputs.iter().map(|input| match self.fed(index, input) {
                Some(fed) => fed,
                None => self.resolve(scope, id, &input.name),
            });
            self.flat.nodes[index].inputs = bound.collect();
        }
    }

    /// Finds what stands behind the outputs of groups, so that they can be shown like those of
    /// nodes.
    fn bind_group_outputs(&mut self) {
        for scope in 1..self.scopes.len() {
            let Some(group) = self.scopes[scope].group else { continue };
            let definition = self.groups[group].definition;
            let mut found = HashMap::new();
            for (index, port) in definition.outputs.iter().enumerate() {
                let Some(&wire) =
                    self.scopes[scope].wires.get(&(GROUP_OUTPUTS, port.name.as_str()))
                else {
                    continue;
                };
                if let FlatInput::Wire { node, output } =
                    self.resolve(scope, &wire.to.node, &port.name)
                {
                    found.insert(port.name.clone(), (node, output));
                    if index == 0 {
                        found.insert(PortName::default(), (node, output));
                    }
                }
            }
            if let Some(path) = self.scopes[scope].path.clone() {
                self.flat.group_outputs.insert(path, found);
            }
        }
    }

    /// The source that an input is bound to.
    fn resolve(&mut self, scope: usize, id: &'a NodeId, port: &PortName) -> FlatInput {
        match self.end_of(scope, id, port) {
            WireEnd::Output { node, output } => FlatInput::Wire { node, output },
            WireEnd::Open { scope, id, port, fallback } => {
                self.bind_fallback(scope, id, &port, fallback.as_ref())
            }
            WireEnd::Zero { scope, id, port, zero } => {
                self.bind_value(scope, id, &port, Some(&zero))
            }
            WireEnd::Broken => FlatInput::Broken,
            WireEnd::Ring => {
                let message =
                    tr!("this input is fed by a ring of reroutes or groups, and by no node");
                let problem = Diagnostic::error("cycle", message).node(self.path_of(scope, id));
                self.problems.push(problem.hint(tr!("remove one wire of the ring")));
                FlatInput::Broken
            }
        }
    }

    /// Walks from an input through groups and reroutes to the output or the open input that feeds
    /// it. The inputs on the way are walked through once, whoever comes to them later.
    fn end_of(&mut self, scope: usize, id: &'a NodeId, port: &PortName) -> WireEnd<'a> {
        let mut at = (scope, id, port.clone());
        // Each with what it has where the input behind it is open.
        let mut way: Vec<(InputKey<'a>, Option<Fallback>)> = Vec::new();
        let mut end = loop {
            let (scope, id, port) = at;
            let key = (scope, id.as_str(), port.clone());
            if let Some(known) = self.ends.get(&key) {
                break known.clone();
            }
            let Some(&wire) = self.scopes[scope].wires.get(&(id.as_str(), port.as_str())) else {
                break WireEnd::Open { scope, id, port, fallback: None };
            };
            match self.follow(scope, wire) {
                None => break WireEnd::Broken,
                Some(WireSource::Output { node, output }) => {
                    break WireEnd::Output { node, output };
                }
                Some(WireSource::Nothing { scope, id, port, zero }) => {
                    break WireEnd::Zero { scope, id, port, zero };
                }
                Some(WireSource::Input { scope, id, port, fallback }) => {
                    // Who comes back to it before its end is known goes round in a ring.
                    self.ends.insert(key.clone(), WireEnd::Ring);
                    way.push((key, fallback));
                    at = (scope, id, port);
                }
            }
        };
        for (key, passed) in way.into_iter().rev() {
            if let WireEnd::Open { fallback, .. } = &mut end {
                // The fallback nearest to the open input holds.
                *fallback = fallback.take().or(passed);
            }
            self.ends.insert(key, end.clone());
        }
        end
    }

    /// Real origin of a wire.
    fn follow(&self, scope: usize, wire: &'a Wire) -> Option<WireSource<'a>> {
        #[cfg(test)]
        self.followed.set(self.followed.get() + 1);
        let mut scope = scope;
        let mut from = &wire.from;
        for _ in 0..=self.scopes.len() {
            let here = &self.scopes[scope];
            if let (GROUP_INPUTS, Some(group), Some((parent, id))) =
                (from.node.as_str(), here.group, here.parent)
            {
                let interface = self.groups[group].inputs.get(from.port.as_str());
                let fallback = interface.and_then(|port| port.default.clone()).map(Fallback::Value);
                return Some(WireSource::Input {
                    scope: parent,
                    id,
                    port: from.port.clone(),
                    fallback,
                });
            }
            match here.slots.get(from.node.as_str())? {
                FlatSlot::Missing => return None,
                FlatSlot::Flat(node) => {
                    let def = &self.flat.nodes[*node].def;
                    if def.special == Treatment::Reroute {
                        let (_, id, _) = self.origins[*node];
                        return Some(WireSource::Input {
                            scope,
                            id,
                            port: def.inputs.first()?.name.clone(),
                            fallback: None,
                        });
                    }
                    let output = def.output(from.port.as_str())?;
                    let (_, id, document_node) = self.origins[*node];
                    if let Some(neutral) = self.left_out(scope, id, document_node)
                        && let Some(source) =
                            self.muted(&def.inputs, &def.outputs[output], (scope, id), neutral)
                    {
                        return Some(source);
                    }
                    if def.joins_lights()
                        && let Some(joined) = self.joined(scope, id)
                    {
                        return match joined {
                            Some(node) => Some(WireSource::Output { node, output }),
                            None => Some(WireSource::Nothing {
                                scope,
                                id,
                                port: def.outputs[output].name.clone(),
                                zero: without_lights(&def.inputs, &def.outputs[output])?,
                            }),
                        };
                    }
                    return Some(WireSource::Output { node: *node, output });
                }
                FlatSlot::Group(child) => {
                    let group = &self.groups[self.scopes[*child].group?];
                    let definition = group.definition;
                    let first = definition.outputs.first().map_or("", |port| port.name.as_str());
                    let port =
                        if from.port.as_str().is_empty() { first } else { from.port.as_str() };
                    let (id, node) = here.graph.nodes.get_key_value(from.node.as_str())?;
                    if let Some(neutral) = self.left_out(scope, id, node) {
                        let ports = self.ports_of(group.kind, definition);
                        let output = definition
                            .outputs
                            .iter()
                            .position(|output| output.name.as_str() == port)?;
                        if let Some(source) =
                            self.muted(&ports.inputs, &ports.outputs[output], (scope, id), neutral)
                        {
                            return Some(source);
                        }
                    }
                    let child = self.last_copy(*child);
                    from = &self.scopes[child].wires.get(&(GROUP_OUTPUTS, port))?.from;
                    scope = child;
                }
            }
        }
        None
    }

    fn ports_of(&self, kind: &'a str, definition: &'a Definition) -> Arc<GroupPorts> {
        match self.group_ports.borrow_mut().entry(kind) {
            Entry::Occupied(known) => known.get().clone(),
            Entry::Vacant(entry) => {
                let ports = GroupPorts::of(definition, &self.look.definitions, self.library);
                entry.insert(Arc::new(ports)).clone()
            }
        }
    }

    /// The number that a node gives where it is left out and nothing can be let through: 0 if it is
    /// muted, and 1, which takes nothing away, if it is a filter that the light passes by. `None`
    /// for a node that is there.
    fn left_out(&self, scope: usize, id: &NodeId, node: &Node) -> Option<f64> {
        if node.muted {
            return Some(0.0);
        }
        self.passed_by.contains(&(scope, id.as_str())).then_some(1.0)
    }

    /// The stand-in for an output of a node that is left out: the input of the same name, else the
    /// first that could be its value, else the `neutral` number. Lights and angles have none, so
    /// the node that makes one stays.
    fn muted(
        &self,
        inputs: &[Input],
        output: &Output,
        (scope, id): (usize, &'a NodeId),
        neutral: f64,
    ) -> Option<WireSource<'a>> {
        let Some(mut input) = let_through(inputs, output) else {
            return Some(WireSource::Nothing {
                scope,
                id,
                port: output.name.clone(),
                zero: stand_in_of(&output.ty, neutral)?,
            });
        };
        // An input that is the same as another is followed to it, each at most once.
        for _ in inputs {
            let other = match &input.fallback {
                Fallback::Same(other) if !self.is_set(scope, id, &input.name) => other,
                _ => break,
            };
            input = inputs.iter().find(|input| input.name == *other).unwrap_or(input);
        }
        Some(WireSource::Input {
            scope,
            id,
            port: input.name.clone(),
            fallback: Some(input.fallback.clone()),
        })
    }

    /// True if an input is wired or has a value in the document.
    fn is_set(&self, scope: usize, id: &NodeId, port: &PortName) -> bool {
        let here = &self.scopes[scope];
        here.wires.contains_key(&(id.as_str(), port.as_str()))
            || here.graph.nodes.get(id).is_some_and(|node| node.values.contains_key(port))
    }

    fn bind_fallback(
        &mut self,
        scope: usize,
        id: &'a NodeId,
        port: &PortName,
        fallback: Option<&Fallback>,
    ) -> FlatInput {
        match fallback {
            Some(Fallback::Value(default)) => self.bind_value(scope, id, port, Some(default)),
            Some(Fallback::Context(context)) if !self.is_set(scope, id, port) => {
                FlatInput::Context(*context)
            }
            _ => self.bind_value(scope, id, port, None),
        }
    }

    fn bind_value(
        &mut self,
        scope: usize,
        id: &'a NodeId,
        port: &PortName,
        default: Option<&Value>,
    ) -> FlatInput {
        let graph = self.scopes[scope].graph;
        let node = graph.nodes.get(id);
        let explicit = node.and_then(|node| node.values.get(port));
        let interface = node.and_then(|node| self.groups.get(&node.kind)).and_then(|group| {
            let port = self.groups[group].inputs.get(port.as_str())?;
            port.default.as_ref()
        });
        // No document reaches into a group of the library: what is written there is what holds.
        let group = self.scopes[scope].group.map(|group| self.groups[group].kind);
        let is_of_library = group.is_some_and(|kind| !self.look.definitions.contains_key(kind));
        let written = explicit.filter(|_| is_of_library);
        let default = written.or(interface).or(default);
        let value = explicit.or(default).cloned();
        let param = Param {
            path: self.path_of(scope, id),
            port: port.clone(),
            value,
            default: default.cloned(),
        };
        let next = self.flat.params.len();
        let whose = self.scopes[scope].values.unwrap_or(scope);
        let index = *self.param_ids.entry((whose, id.as_str(), port.clone())).or_insert(next);
        if index == next {
            self.flat.params.push(param);
        } else if self.flat.params[index].value.is_none() {
            // A muted node's own input, which knows its default by its port, is let through to
            // another port.
            self.flat.params[index] = param;
        }
        FlatInput::Param(index)
    }
}

enum WireSource<'a> {
    Output {
        node: usize,
        output: usize,
    },
    Input {
        scope: usize,
        id: &'a NodeId,
        port: PortName,
        /// The fallback while unwired and without a value, where the input that it feeds has
        /// another.
        fallback: Option<Fallback>,
    },
    /// A muted node with nothing to let through gives a zero, as if it were a value of its output.
    Nothing {
        scope: usize,
        id: &'a NodeId,
        port: PortName,
        zero: Value,
    },
}

/// True if a muted node with these ports has a substitute for each of its outputs: an input that is
/// let through, or a zero.
pub fn can_be_muted(inputs: &[Input], outputs: &[Output]) -> bool {
    outputs.iter().all(|output| {
        let_through(inputs, output).is_some() || stand_in_of(&output.ty, 0.0).is_some()
    })
}

/// The input that a muted node lets through to an output.
fn let_through<'i>(inputs: &'i [Input], output: &Output) -> Option<&'i Input> {
    let is_like = |input: &&Input| input.ty == output.ty && !input.hidden;
    let same = inputs.iter().find(|input| input.name == output.name).filter(is_like);
    // A number with a unit is a setting of what the node does, not what it does it to.
    let is_subject = |input: &&Input| is_like(input) && input.unit.is_empty();
    same.or_else(|| inputs.iter().find(is_subject))
}

/// A value of one number that whatever takes the type takes too; as a color it is opaque.
fn stand_in_of(ty: &Type, number: f64) -> Option<Value> {
    Some(match ty {
        Type::Float | Type::Int | Type::Vec2 | Type::Vec3 | Type::Color => Value::Number(number),
        Type::Bool => Value::Bool(number > 0.0),
        Type::Vec4 | Type::Composite => Value::Vector(vec![number; ty.width()?]),
        _ => return None,
    })
}

fn port_names(ports: &[InterfacePort]) -> Vec<&str> {
    ports.iter().map(|port| port.name.as_str()).collect()
}

fn list_of(start: &str, names: &[&str]) -> String {
    if names.is_empty() {
        return tr!("it has none").to_owned();
    }
    let more = names.len().saturating_sub(MAX_LISTED);
    let listed = names[..names.len() - more].join(", ");
    if more > 0 { tr!("{start} {listed} and {more} more") } else { format!("{start} {listed}") }
}

/// Names of nodes deep in groups would take more memory than all else, where each of the groups has
/// a long one.
fn join_names(outer: &str, inner: &str) -> String {
    let mut name = if outer.is_empty() { inner.to_owned() } else { format!("{outer} {inner}") };
    let most = name.floor_char_boundary(MAX_NAME);
    name.truncate(most);
    name
}
