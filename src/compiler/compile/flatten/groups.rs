//! The groups that a look uses, before any is inlined: their ports by name, which of them contain
//! themselves, and how large the look becomes. Each definition is looked at once, however often it
//! is used, so a look whose groups multiply without bound is refused before anything is made of it.

use std::collections::hash_map::Entry;
use std::collections::{BTreeSet, HashMap};

use chiaro_locale::tr;
use indexmap::IndexMap;
use petgraph::graph::{DiGraph, NodeIndex};

use super::MAX_FLAT_NODES;
use crate::diag::Diagnostic;
use crate::document::{Definition, Graph, InterfacePort, Light, Look, Node};
use crate::ids::{LightId, NodeId, NodePath};
use crate::library::Library;

/// The most groups that lie in each other, from the look's own graph on.
const MAX_DEPTH: u64 = 256;
/// The most ids in the paths of all nodes together: nodes times how deep they lie.
const MAX_PATH_IDS: u64 = 8_000_000;

/// The index of a group in [`UsedGroups`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct GroupIndex(usize);

/// A definition that the look uses, of its own or of the library.
pub(super) struct UsedGroup<'a> {
    pub(super) kind: &'a str,
    pub(super) definition: &'a Definition,
    pub(super) inputs: HashMap<&'a str, &'a InterfacePort>,
    pub(super) outputs: HashMap<&'a str, &'a InterfacePort>,
    /// Groups that contain one another have one number.
    ring: Option<usize>,
    extent: Extent,
}

/// The extent of a graph once its groups are inlined.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Extent {
    /// Nodes, with the nodes of groups and all in them.
    nodes: u64,
    /// Ids in the paths of all of them, from this graph on.
    path_ids: u64,
    /// The depth of groups within groups.
    depth: u64,
}

impl Extent {
    /// The extent of a node: of the group that it opens, or of a plain node.
    fn of_node(group: Option<Self>) -> Self {
        let inner = group.unwrap_or_default();
        Self {
            nodes: inner.nodes.saturating_add(1),
            path_ids: inner.path_ids.saturating_add(inner.nodes).saturating_add(1),
            depth: group.map_or(0, |inner| inner.depth.saturating_add(1)),
        }
    }

    /// The extent of so many copies.
    fn times(self, copies: u64) -> Self {
        Self {
            nodes: self.nodes.saturating_mul(copies),
            path_ids: self.path_ids.saturating_mul(copies),
            depth: self.depth,
        }
    }

    fn beside(self, other: Self) -> Self {
        Self {
            nodes: self.nodes.saturating_add(other.nodes),
            path_ids: self.path_ids.saturating_add(other.path_ids),
            depth: self.depth.max(other.depth),
        }
    }

    /// The diagnostic of a graph that is too large.
    fn problem(self) -> Option<Diagnostic> {
        let problem =
            |code, message: String, hint: &str| Some(Diagnostic::error(code, message).hint(hint));
        if self.nodes > MAX_FLAT_NODES as u64 {
            let message = tr!("the look has more than {MAX_FLAT_NODES} nodes");
            return problem(
                "too-many-nodes",
                message,
                tr!("groups within groups multiply: use fewer copies"),
            );
        }
        if self.depth > MAX_DEPTH {
            let message = tr!("groups lie in each other more than {MAX_DEPTH} deep");
            return problem(
                "groups-too-deep",
                message,
                tr!("dissolve groups that hold little but another group"),
            );
        }
        if self.path_ids > MAX_PATH_IDS {
            let message =
                tr!("the look has too many nodes in groups that lie deep in each other").to_owned();
            return problem(
                "too-many-nodes",
                message,
                tr!("dissolve outer groups, or use fewer copies"),
            );
        }
        None
    }
}

/// All groups that a look uses.
pub(super) struct UsedGroups<'a> {
    /// Lights of the look, which groups for each light have a copy for.
    lights: &'a IndexMap<LightId, Light>,
    list: Vec<UsedGroup<'a>>,
    by_kind: HashMap<&'a str, GroupIndex>,
}

impl<'a> UsedGroups<'a> {
    /// Finds the groups of `look`.
    ///
    /// # Errors
    /// Where the look would become too large.
    pub(super) fn of(look: &'a Look, library: &'a Library) -> Result<Self, Box<Diagnostic>> {
        let mut groups = Self { lights: &look.lights, list: Vec::new(), by_kind: HashMap::new() };
        groups.find(look, library, &look.graph);
        let mut next = 0;
        while let Some(group) = groups.list.get(next) {
            let graph = &group.definition.graph;
            groups.find(look, library, graph);
            next += 1;
        }
        groups.measure();
        groups.check(&look.graph)?;
        Ok(groups)
    }

    /// The group that a kind of node stands for.
    pub(super) fn get(&self, kind: &str) -> Option<GroupIndex> {
        self.by_kind.get(kind).copied()
    }

    /// True if a node of the kind `inner` in the group `outer` contains `outer` again.
    pub(super) fn is_recursive(&self, outer: GroupIndex, inner: GroupIndex) -> bool {
        let ring = self[outer].ring;
        ring.is_some() && ring == self[inner].ring
    }

    /// Adds the groups that nodes of a graph stand for.
    fn find(&mut self, look: &'a Look, library: &'a Library, graph: &'a Graph) {
        for node in graph.nodes.values() {
            let kind = node.kind.as_str();
            let Entry::Vacant(entry) = self.by_kind.entry(kind) else { continue };
            let Some(definition) = library.group_of(look, kind) else { continue };
            entry.insert(GroupIndex(self.list.len()));
            let (inputs, outputs) = (by_name(&definition.inputs), by_name(&definition.outputs));
            self.list.push(UsedGroup {
                kind,
                definition,
                inputs,
                outputs,
                ring: None,
                extent: Extent::default(),
            });
        }
    }

    /// The groups that nodes of a graph stand for, once for each node.
    fn uses(&self, graph: &'a Graph) -> impl Iterator<Item = GroupIndex> + '_ {
        graph.nodes.values().filter_map(|node| self.get(&node.kind))
    }

    /// Finds rings and extents: those of the inner groups before those of the groups that use them.
    fn measure(&mut self) {
        let mut graph = DiGraph::<(), (), u32>::with_capacity(self.list.len(), 0);
        for _ in &self.list {
            graph.add_node(());
        }
        for (outer, group) in self.list.iter().enumerate() {
            for GroupIndex(inner) in self.uses(&group.definition.graph) {
                graph.add_edge(NodeIndex::new(outer), NodeIndex::new(inner), ());
            }
        }
        // Components come with what is used before what uses it.
        for (number, component) in petgraph::algo::kosaraju_scc(&graph).iter().enumerate() {
            let first = component[0];
            if component.len() > 1 || graph.contains_edge(first, first) {
                component.iter().for_each(|index| self.list[index.index()].ring = Some(number));
            }
            for index in component.iter().map(|index| index.index()) {
                let nodes = self.list[index].definition.graph.nodes.values();
                let extents = nodes.map(|node| self.extent(Some(GroupIndex(index)), node));
                self.list[index].extent = extents.fold(Extent::default(), Extent::beside);
            }
        }
    }

    /// The extent of a node in the graph of `outer`, or in the look's own.
    fn extent(&self, outer: Option<GroupIndex>, node: &Node) -> Extent {
        let inner = self.get(&node.kind);
        // A group in itself is reported, and not opened.
        let opened =
            inner.filter(|&inner| !outer.is_some_and(|outer| self.is_recursive(outer, inner)));
        let lights = node.for_each.as_ref().map(|set| set.of(self.lights, &BTreeSet::new()).len());
        // A group for no light is opened once all the same.
        let copies = lights.map_or(1, |lights| lights.max(1) as u64);
        Extent::of_node(opened.map(|inner| self[inner].extent)).times(copies)
    }

    /// Tells where the look would become too large, with the node that makes most of it.
    fn check(&self, graph: &Graph) -> Result<(), Box<Diagnostic>> {
        let extents = || graph.nodes.iter().map(|(id, node)| (id, self.extent(None, node)));
        let whole = extents().fold(Extent::default(), |whole, (_, extent)| whole.beside(extent));
        let Some(problem) = whole.problem() else { return Ok(()) };
        let of_node = extents().find(|(_, extent)| extent.problem().is_some());
        let largest = of_node.or_else(|| extents().max_by_key(|(_, extent)| extent.path_ids));
        let at = |(id, _): (&NodeId, Extent)| NodePath::root(id.clone());
        Err(Box::new(match largest.map(at) {
            Some(path) => problem.node(path),
            None => problem,
        }))
    }
}

impl<'a> std::ops::Index<GroupIndex> for UsedGroups<'a> {
    type Output = UsedGroup<'a>;

    fn index(&self, GroupIndex(index): GroupIndex) -> &UsedGroup<'a> {
        &self.list[index]
    }
}

/// Ports by name; of two of one name the first.
fn by_name(ports: &[InterfacePort]) -> HashMap<&str, &InterfacePort> {
    let mut found = HashMap::with_capacity(ports.len());
    for port in ports {
        found.entry(port.name.as_str()).or_insert(port);
    }
    found
}
