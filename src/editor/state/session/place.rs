//! The open graph of the look: its own, or that of a group, the library's groups included.

use super::Session;
use crate::document::{Definition, Edit, Graph, GraphId, OutputPort};
use crate::ids::{DefinitionId, GROUP_INPUTS, GROUP_OUTPUTS, NodeId, NodePath};
use crate::state::revision::GraphNumber;

/// Groups that were opened, one in the other.
#[derive(Default)]
pub(crate) struct OpenGroups {
    /// Nodes of groups that lead to the open graph, outermost first.
    path: Vec<NodeId>,
    /// The graph that the last of the nodes leads to.
    graph: GraphId,
    /// Number of the open graph, which grows whenever another graph is opened.
    number: GraphNumber,
}

impl Session {
    /// Id of the open graph.
    pub fn graph_id(&self) -> &GraphId {
        &self.selection.groups.graph
    }

    /// The open graph.
    pub fn graph(&self) -> &Graph {
        self.definition().map_or(&self.look().graph, |definition| &definition.graph)
    }

    /// The open group; `None` in the look's own graph.
    pub(crate) fn definition(&self) -> Option<&Definition> {
        match &self.selection.groups.graph {
            GraphId::Look => None,
            GraphId::Definition(id) => self.definition_of(id.as_str()),
        }
    }

    /// The group of a kind, the look's own before the library's.
    pub(crate) fn definition_of(&self, kind: &str) -> Option<&Definition> {
        self.reading().definition_of(kind)
    }

    /// True if the open graph is of the library, and so cannot be changed.
    pub fn is_read_only(&self) -> bool {
        let GraphId::Definition(id) = &self.selection.groups.graph else { return false };
        !self.look().definitions.contains_key(id)
    }

    /// Nodes of groups that lead to the open graph, outermost first.
    pub fn open_groups(&self) -> &[NodeId] {
        &self.selection.groups.path
    }

    /// Nodes of the open graph whose outputs, or those of nodes in them, drive keys.
    pub(crate) fn driving_nodes(&self) -> Vec<NodeId> {
        let here =
            |wire: &OutputPort| wire.node.ids().strip_prefix(self.open_groups())?.first().cloned();
        self.look()
            .direction_keys
            .iter()
            .flat_map(|keys| keys.by.outputs())
            .filter_map(here)
            .collect()
    }

    /// Number of the open graph, which grows whenever another graph is opened.
    pub(crate) fn graph_number(&self) -> GraphNumber {
        self.selection.groups.number
    }

    /// Path of a node of the open graph, from the look's own graph on.
    pub(crate) fn path_of(&self, id: &NodeId) -> NodePath {
        let mut ids = self.selection.groups.path.iter().chain([id]);
        let first = NodePath::root(ids.next().unwrap_or(id).clone());
        ids.fold(first, |path, id| path.join(id.clone()))
    }

    /// Opens the graph that these nodes of groups lead to, as far as they exist.
    pub fn open_graph(&mut self, path: &[NodeId]) {
        let (mut graph, mut known) = (GraphId::Look, Vec::new());
        for id in path {
            let Some(next) = self.graph_within(&graph, id) else { break };
            graph = next;
            known.push(id.clone());
        }
        if (&graph, &known) == (&self.selection.groups.graph, &self.selection.groups.path) {
            return;
        }
        let was = std::mem::replace(&mut self.selection.groups.path, known);
        self.selection.groups.graph = graph;
        self.selection.groups.number.advance();
        // The group that was left is selected, so that it is easy to find.
        let left = was
            .get(self.selection.groups.path.len())
            .filter(|_| was.starts_with(&self.selection.groups.path))
            .cloned();
        self.selection.nodes = left.into_iter().collect();
        self.revisions.problems.advance();
    }

    /// The graph that a node of a group opens.
    fn graph_within(&self, graph: &GraphId, id: &NodeId) -> Option<GraphId> {
        let graph = match graph {
            GraphId::Look => &self.look().graph,
            GraphId::Definition(id) => &self.definition_of(id.as_str())?.graph,
        };
        let kind = graph.nodes.get(id)?.kind.as_str();
        self.definition_of(kind).map(|_| GraphId::Definition(DefinitionId::from(kind)))
    }

    /// True if there is such a node in the open graph; a group's ends count.
    pub(super) fn is_here(&self, id: &NodeId) -> bool {
        let is_end = matches!(id.as_str(), GROUP_INPUTS | GROUP_OUTPUTS)
            && self.selection.groups.graph != GraphId::Look;
        is_end || self.graph().nodes.contains_key(id)
    }

    /// Leaves groups that no longer exist.
    pub(super) fn check_place(&mut self) {
        let path = self.selection.groups.path.clone();
        self.open_graph(&path);
    }

    /// Goes back to the look's own graph, of another look.
    pub(super) fn reset_place(&mut self) {
        self.selection.groups =
            OpenGroups { number: self.selection.groups.number, ..OpenGroups::default() };
        self.selection.groups.number.advance();
    }

    /// The node of a path that lies in the open graph: where this graph, or another use of its
    /// group, lies on the way.
    pub(crate) fn step_here<'p>(&self, path: &'p NodePath) -> Option<&'p NodeId> {
        let mut graph = GraphId::Look;
        for id in path.ids() {
            if graph == self.selection.groups.graph {
                return Some(id);
            }
            graph = self.graph_within(&graph, id)?;
        }
        None
    }

    /// The edit that makes the library's open group the look's own, so that it can be changed: for
    /// every node of the group in the look.
    pub(crate) fn own_group(&self) -> Option<Edit> {
        let GraphId::Definition(id) = &self.selection.groups.graph else { return None };
        let definition = self.definition().filter(|_| self.is_read_only())?.clone();
        Some(Edit::AddDefinition { id: id.clone(), definition, index: None })
    }
}
