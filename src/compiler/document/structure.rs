//! Navigation in a look: graphs, nodes in groups, and their places in the JSON.

use super::{Graph, Look, Node, Target, Wire};
use crate::ids::{DefinitionId, NodePath, PortName};

/// Id of a graph of a look.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum GraphId {
    /// The look's own graph.
    #[default]
    Look,
    /// Graph of a group.
    Definition(DefinitionId),
}

impl GraphId {
    /// Prefix of the JSON paths of the graph's nodes, wires and frames.
    fn json_prefix(&self) -> String {
        match self {
            Self::Look => String::new(),
            Self::Definition(id) => format!("definitions.{id}."),
        }
    }
}

/// Node that a [`NodePath`] leads to.
#[derive(Clone, Debug)]
pub struct InnerNode<'l> {
    /// Graph that the node lies in.
    pub graph: GraphId,
    /// Index of the node in the graph.
    pub index: usize,
    /// The node itself.
    pub node: &'l Node,
}

impl Look {
    /// Graph with an id; `None` where there is none.
    pub fn graph_of(&self, graph: &GraphId) -> Option<&Graph> {
        match graph {
            GraphId::Look => Some(&self.graph),
            GraphId::Definition(id) => self.definitions.get(id).map(|definition| &definition.graph),
        }
    }

    /// Graph with an id, for changes; `None` where there is none.
    pub fn graph_of_mut(&mut self, graph: &GraphId) -> Option<&mut Graph> {
        match graph {
            GraphId::Look => Some(&mut self.graph),
            GraphId::Definition(id) => self.definitions.get_mut(id).map(|group| &mut group.graph),
        }
    }

    /// Node that a path leads to through the groups of this document. `None` where a step does not
    /// exist, and inside groups that come from the library.
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

    /// JSON path of a node, e.g. `definitions.rim.nodes[2]`.
    pub fn json_path_of_node(&self, path: &NodePath) -> Option<String> {
        let found = self.find(path)?;
        Some(format!("{}nodes[{}]", found.graph.json_prefix(), found.index))
    }

    /// JSON path of an input's source: its wire, else its value, e.g. `nodes[3].values.offset`
    /// (which the text need not have, as a default may be left out).
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

    /// JSON path of the input or field that a target names.
    pub fn json_path_of_target(&self, target: &Target) -> Option<String> {
        match target {
            Target::Input { node, port } => self.json_path_of_input(node, port),
            Target::Light { light, field } => {
                self.lights.contains_key(light).then(|| format!("lights.{light}.{field}"))
            }
        }
    }
}
