//! Finding one's way through a look: graphs, nodes in groups, and where they are in the JSON.

use super::{Graph, Look, Node, Target, Wire};
use crate::ids::{DefinitionId, NodePath, PortName};

/// A graph of a look.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum GraphId {
    /// The look's own.
    #[default]
    Look,
    /// That of a group.
    Definition(DefinitionId),
}

impl GraphId {
    /// What the JSON paths of its nodes, wires and frames begin with.
    fn json_prefix(&self) -> String {
        match self {
            Self::Look => String::new(),
            Self::Definition(id) => format!("definitions.{id}."),
        }
    }
}

/// Where a [`NodePath`] leads.
#[derive(Clone, Debug)]
pub struct InnerNode<'l> {
    /// The graph that the node lies in.
    pub graph: GraphId,
    /// Its index there.
    pub index: usize,
    /// The node.
    pub node: &'l Node,
}

impl Look {
    /// A graph, if there is one of that name.
    pub fn graph_of(&self, graph: &GraphId) -> Option<&Graph> {
        match graph {
            GraphId::Look => Some(&self.graph),
            GraphId::Definition(id) => self.definitions.get(id).map(|definition| &definition.graph),
        }
    }

    /// Follows a path through the groups of this document. `None` where a step does not exist, and
    /// inside groups that come from the library.
    pub fn find(&self, path: &NodePath) -> Option<InnerNode<'_>> {
        let mut graph = GraphId::Look;
        let (last, groups) = path.ids().split_last()?;
        for group in groups {
            let definition =
                DefinitionId::from(self.graph_of(&graph)?.nodes.get(group)?.kind.as_str());
            graph = GraphId::Definition(definition);
        }
        let (index, _, node) = self.graph_of(&graph)?.nodes.get_full(last)?;
        Some(InnerNode { graph, index, node })
    }

    /// The JSON path of a node, e.g. `definitions.rim.nodes[2]`.
    pub fn json_path_of_node(&self, path: &NodePath) -> Option<String> {
        let found = self.find(path)?;
        Some(format!("{}nodes[{}]", found.graph.json_prefix(), found.index))
    }

    /// The JSON path of what feeds an input: its wire, else its value, e.g.
    /// `nodes[3].values.offset` (which the text need not have, as a default may be left out).
    pub fn json_path_of_input(&self, path: &NodePath, port: &PortName) -> Option<String> {
        let found = self.find(path)?;
        let prefix = found.graph.json_prefix();
        let id = path.last()?;
        let is_it = |wire: &Wire| wire.to.node == *id && wire.to.port == *port;
        let wire = self.graph_of(&found.graph)?.wires.iter().position(is_it);
        Some(match wire {
            Some(index) => format!("{prefix}wires[{index}]"),
            None => format!("{prefix}nodes[{}].values.{port}", found.index),
        })
    }

    /// The JSON path of what a target names.
    pub fn json_path_of_target(&self, target: &Target) -> Option<String> {
        match target {
            Target::Input { node, port } => self.json_path_of_input(node, port),
            Target::Light { light, field } => {
                self.lights.contains_key(light).then(|| format!("lights.{light}.{field}"))
            }
        }
    }
}
