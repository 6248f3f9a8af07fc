//! The selection: nodes of the open graph, the direction key that is edited, and the groups that
//! were opened on the way to the open graph.

use indexmap::IndexSet;

use crate::document::{Definition, Edit, Graph, GraphId, OutputPort, Target};
use crate::ids::{DefinitionId, GROUP_INPUTS, GROUP_OUTPUTS, LightId, NodeId, NodePath, PortName};
use crate::state::keying::KeyPlace;
use crate::state::reading::LookWithLibrary;
use crate::state::revision::GraphNumber;

/// The selection, and the open graph.
#[derive(Default)]
pub struct Selection {
    /// Selected nodes of the open graph, the first one selected last.
    pub(crate) nodes: IndexSet<NodeId>,
    /// Light that was chosen in a list or by a handle since nodes were last selected.
    pub(crate) light: Option<LightId>,
    /// The direction key that values are set at.
    pub(crate) key: Option<KeyPlace>,
    /// Nodes of groups that lead to the open graph, outermost first.
    groups: Vec<NodeId>,
    /// The graph that the last of the groups leads to.
    graph: GraphId,
    /// Number of the open graph, which grows whenever another graph is opened.
    number: GraphNumber,
}

impl Selection {
    /// Selected nodes.
    pub fn nodes(&self) -> impl Iterator<Item = &NodeId> {
        self.nodes.iter()
    }

    /// Id of the open graph.
    pub fn graph_id(&self) -> &GraphId {
        &self.graph
    }

    /// Nodes of groups that lead to the open graph, outermost first.
    pub fn open_groups(&self) -> &[NodeId] {
        &self.groups
    }

    /// Number of the open graph, which grows whenever another graph is opened.
    pub(crate) fn graph_number(&self) -> GraphNumber {
        self.number
    }

    /// Path of a node of the open graph, from the look's own graph on.
    pub(crate) fn path_of(&self, id: &NodeId) -> NodePath {
        let mut ids = self.groups.iter().chain([id]);
        let first = NodePath::root(ids.next().unwrap_or(id).clone());
        ids.fold(first, |path, id| path.join(id.clone()))
    }

    /// Target of an input of a node of the open graph.
    pub(crate) fn target(&self, node: &NodeId, port: &PortName) -> Target {
        Target::Input { node: self.path_of(node), port: port.clone() }
    }

    /// Opens a graph that groups lead to. Returns true if another graph was open.
    pub(crate) fn open(&mut self, (graph, groups): (GraphId, Vec<NodeId>)) -> bool {
        if (&graph, &groups) == (&self.graph, &self.groups) {
            return false;
        }
        let was = std::mem::replace(&mut self.groups, groups);
        self.graph = graph;
        self.number.advance();
        // The group that was left is selected, so that it is easy to find.
        let left = was.get(self.groups.len()).filter(|_| was.starts_with(&self.groups)).cloned();
        self.nodes = left.into_iter().collect();
        true
    }

    /// Goes back to the own graph of another look.
    pub(crate) fn leave_groups(&mut self) {
        self.groups.clear();
        self.graph = GraphId::Look;
        self.number.advance();
    }
}

/// The open graph: the look's own, or that of a group, the library's groups included.
#[derive(Clone, Copy)]
pub struct OpenGraph<'a> {
    pub(crate) look: LookWithLibrary<'a>,
    pub(crate) selection: &'a Selection,
}

impl<'a> OpenGraph<'a> {
    /// The graph.
    pub(crate) fn graph(self) -> &'a Graph {
        self.definition().map_or(&self.look.look.graph, |definition| &definition.graph)
    }

    /// The open group; `None` in the look's own graph.
    pub(crate) fn definition(self) -> Option<&'a Definition> {
        match &self.selection.graph {
            GraphId::Look => None,
            GraphId::Definition(id) => self.look.definition_of(id.as_str()),
        }
    }

    /// True if the open graph is of the library, and so cannot be changed.
    pub fn is_read_only(self) -> bool {
        let GraphId::Definition(id) = &self.selection.graph else { return false };
        !self.look.look.definitions.contains_key(id)
    }

    /// Nodes of the open graph whose outputs, or those of nodes in them, drive keys.
    pub(crate) fn driving_nodes(self) -> Vec<NodeId> {
        let groups = self.selection.open_groups();
        let here = |wire: &OutputPort| wire.node.ids().strip_prefix(groups)?.first().cloned();
        let keys = self.look.look.direction_keys.iter();
        keys.flat_map(|keys| keys.by.outputs()).filter_map(here).collect()
    }

    /// The graph that these nodes of groups lead to, as far as they exist, and those nodes.
    pub(crate) fn along(self, path: &[NodeId]) -> (GraphId, Vec<NodeId>) {
        let (mut graph, mut groups) = (GraphId::Look, Vec::new());
        for id in path {
            let Some(next) = self.within(&graph, id) else { break };
            graph = next;
            groups.push(id.clone());
        }
        (graph, groups)
    }

    /// The graph that a node of a group opens.
    fn within(self, graph: &GraphId, id: &NodeId) -> Option<GraphId> {
        let graph = match graph {
            GraphId::Look => &self.look.look.graph,
            GraphId::Definition(id) => &self.look.definition_of(id.as_str())?.graph,
        };
        let kind = graph.nodes.get(id)?.kind.as_str();
        self.look.definition_of(kind).map(|_| GraphId::Definition(DefinitionId::from(kind)))
    }

    /// True if there is such a node in the open graph; a group's ends count.
    pub(crate) fn has_node(self, id: &NodeId) -> bool {
        let is_end = matches!(id.as_str(), GROUP_INPUTS | GROUP_OUTPUTS)
            && self.selection.graph != GraphId::Look;
        is_end || self.graph().nodes.contains_key(id)
    }

    /// The node of a path that lies in the open graph: where this graph, or another use of its
    /// group, lies on the way.
    pub(crate) fn step_of(self, path: &NodePath) -> Option<&NodeId> {
        let mut graph = GraphId::Look;
        for id in path.ids() {
            if graph == self.selection.graph {
                return Some(id);
            }
            graph = self.within(&graph, id)?;
        }
        None
    }

    /// The edit that makes the library's open group the look's own, so that it can be changed: for
    /// every node of the group in the look.
    pub(crate) fn own_group(self) -> Option<Edit> {
        let GraphId::Definition(id) = &self.selection.graph else { return None };
        let definition = self.definition().filter(|_| self.is_read_only())?.clone();
        Some(Edit::AddDefinition { id: id.clone(), definition, index: None })
    }
}
