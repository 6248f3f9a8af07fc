//! Dissolving of groups: a group's node is replaced by the nodes in the group.

use std::collections::HashMap;

use chiaro_locale::tr;

use super::targets::{follow, path_of, step_in};
use crate::diag::Diagnostic;
use crate::document::{
    Definition, Edit, Endpoint, Graph, GraphId, Look, Node, OutputPort, Target, Value, Wire,
};
use crate::ids::{
    DefinitionId, FrameId, GROUP_INPUTS, GROUP_OUTPUTS, NodeId, NoteId, PortName, make_slug,
};

/// Result of dissolving a group.
#[derive(Clone, Debug, PartialEq)]
pub struct DissolvedGroup {
    /// Edit that dissolves the group.
    pub edit: Edit,
    /// Nodes that take the place of the group's node.
    pub nodes: Vec<NodeId>,
}

/// Replaces a node by the nodes of its `definition` (of the document or of the library). Values,
/// keys and exposed parameters follow. A definition of the document that no node uses any more is
/// removed too.
///
/// # Errors
/// A diagnostic where there is no such node, or where it is muted, runs for each light or has
/// lights of its own: it then gives another result than the nodes in it.
pub fn dissolve(
    look: &Look,
    graph: &GraphId,
    id: &NodeId,
    definition: &Definition,
) -> Result<DissolvedGroup, Box<Diagnostic>> {
    let impossible = |message: String| Box::new(Diagnostic::error("impossible-edit", message));
    let of =
        look.graph_of(graph).ok_or_else(|| impossible(tr!("there is no such graph").to_owned()))?;
    let node = of.nodes.get(id).ok_or_else(|| impossible(tr!("there is no node `{id}`")))?;
    if node.muted {
        let problem = impossible(tr!("the group `{id}` is muted, so it is not what is in it"));
        return Err(Box::new(problem.hint(tr!("unmute it first"))));
    }
    if node.for_each.is_some() {
        let problem = impossible(tr!(
            "the group `{id}` runs for each light, so it is not what is in it once"
        ));
        return Err(Box::new(problem.hint(tr!("clear *For each light* first"))));
    }
    if !node.links.is_all() {
        let problem = impossible(tr!(
            "the group `{id}` has lights of its own, so it is not what is in it under all lights"
        ));
        let hint = tr!("clear *Reached by*, *Filters lights* and their exceptions first");
        return Err(Box::new(problem.hint(hint)));
    }
    let opened = GroupContents { of, graph, id, node, definition, ids: new_ids(of, definition) };
    let mut edits = opened.nodes();
    edits.extend(follow(
        look,
        |path, port| opened.target(look, path, port),
        |output| opened.output(look, output),
    ));
    edits.extend(opened.wires());
    edits.extend(opened.frames());
    edits.push(Edit::RemoveNode { graph: graph.clone(), id: id.clone() });
    edits.extend(unused(look, graph, id, node));
    let nodes = opened.ids.values().cloned().collect();
    Ok(DissolvedGroup { edit: Edit::Group { edits }, nodes })
}

type Ids<'l> = indexmap::IndexMap<&'l NodeId, NodeId>;

/// Ids that inner nodes get outside: their own where those are free.
fn new_ids<'l>(of: &Graph, definition: &'l Definition) -> Ids<'l> {
    let mut ids = Ids::new();
    let mut taken: std::collections::HashSet<NodeId> = of.nodes.keys().cloned().collect();
    for id in definition.graph.nodes.keys() {
        let new = NodeId::new(make_slug(id.as_str(), |slug| taken.contains(slug)));
        let new = if taken.contains(id) || matches!(id.as_str(), GROUP_INPUTS | GROUP_OUTPUTS) {
            new
        } else {
            id.clone()
        };
        taken.insert(new.clone());
        ids.insert(id, new);
    }
    ids
}

/// Group's node together with its definition.
struct GroupContents<'l> {
    of: &'l Graph,
    graph: &'l GraphId,
    id: &'l NodeId,
    node: &'l Node,
    definition: &'l Definition,
    ids: Ids<'l>,
}

impl GroupContents<'_> {
    /// Value of an interface input while nothing feeds it.
    fn value(&self, port: &PortName) -> Option<&Value> {
        let default =
            || self.definition.inputs.iter().find(|known| known.name == *port)?.default.as_ref();
        self.node.values.get(port).or_else(default)
    }

    /// Output outside the group that feeds an interface input.
    fn source(&self, port: &PortName) -> Option<&Endpoint> {
        self.of.wire_into(self.id, port).map(|wire| &wire.from)
    }

    fn nodes(&self) -> Vec<Edit> {
        let shift = self.shift();
        let inner = &self.definition.graph;
        let mut fed: HashMap<&NodeId, Vec<(&PortName, &PortName)>> = HashMap::new();
        for wire in inner.wires.iter().filter(|wire| wire.from.node.as_str() == GROUP_INPUTS) {
            fed.entry(&wire.to.node).or_default().push((&wire.to.port, &wire.from.port));
        }
        let add = |(id, node): (&NodeId, &Node)| {
            let mut node = node.clone();
            node.position = [node.position[0] + shift[0], node.position[1] + shift[1]];
            node.tier = node.tier.or(self.node.tier);
            for (port, from) in fed.get(id).into_iter().flatten() {
                match self.value(from) {
                    Some(value) if self.source(from).is_none() => {
                        drop(node.values.insert((*port).clone(), value.clone()));
                    }
                    _ => drop(node.values.shift_remove(*port)),
                }
            }
            Edit::AddNode { graph: self.graph.clone(), id: self.ids[id].clone(), node, index: None }
        };
        inner.nodes.iter().map(add).collect()
    }

    /// Translation from the group's own positions to positions around its node.
    fn shift(&self) -> [f64; 2] {
        let nodes = &self.definition.graph.nodes;
        let of = |axis: usize| {
            let places = || nodes.values().map(|node| node.position[axis]);
            let (least, most) =
                (places().fold(f64::MAX, f64::min), places().fold(f64::MIN, f64::max));
            if nodes.is_empty() {
                0.0
            } else {
                (self.node.position[axis] - (least + most) / 2.0).round()
            }
        };
        [of(0), of(1)]
    }

    /// Outer equivalent of an inner wire's start; for interface inputs, the output that feeds them.
    fn outside(&self, from: &Endpoint) -> Option<Endpoint> {
        if from.node.as_str() == GROUP_INPUTS {
            return self.source(&from.port).cloned();
        }
        Some(Endpoint { node: self.ids.get(&from.node)?.clone(), port: from.port.clone() })
    }

    fn wires(&self) -> Vec<Edit> {
        let add = |from, to| Edit::AddWire {
            graph: self.graph.clone(),
            wire: Wire { from, to },
            index: None,
        };
        let inner = &self.definition.graph.wires;
        let mut edits = Vec::new();
        for wire in inner.iter().filter(|wire| wire.to.node.as_str() != GROUP_OUTPUTS) {
            let Some(to) = self.ids.get(&wire.to.node) else { continue };
            let to = Endpoint { node: to.clone(), port: wire.to.port.clone() };
            edits.extend(self.outside(&wire.from).map(|from| add(from, to)));
        }
        let first =
            self.definition.outputs.first().map(|port| port.name.clone()).unwrap_or_default();
        for wire in self.of.wires.iter().filter(|wire| wire.from.node == *self.id) {
            let port = if wire.from.port.as_str().is_empty() { &first } else { &wire.from.port };
            let is_it =
                |inner: &&Wire| inner.to.node.as_str() == GROUP_OUTPUTS && inner.to.port == *port;
            let Some(inner) = inner.iter().find(is_it) else { continue };
            match self.outside(&inner.from) {
                Some(from) => edits.push(add(from, wire.to.clone())),
                // A value of the interface becomes the value of the input behind it.
                None => edits.extend(self.value(&inner.from.port).map(|value| Edit::SetValue {
                    graph: self.graph.clone(),
                    id: wire.to.node.clone(),
                    port: wire.to.port.clone(),
                    value: value.clone(),
                    index: None,
                })),
            }
        }
        edits
    }

    /// Targets outside that replace a target in the group, or on the group's own inputs.
    fn target(
        &self,
        look: &Look,
        path: &crate::ids::NodePath,
        port: &PortName,
    ) -> Option<Vec<Target>> {
        let step = step_in(look, path, self.graph).filter(|&step| path.ids()[step] == *self.id)?;
        let ids = path.ids();
        if let Some(inner) = ids.get(step + 1) {
            let mut outer = ids[..step].to_vec();
            outer.push(self.ids.get(inner)?.clone());
            outer.extend_from_slice(&ids[step + 2..]);
            return Some(vec![Target::Input { node: path_of(&outer)?, port: port.clone() }]);
        }
        let is_it =
            |wire: &&Wire| wire.from.node.as_str() == GROUP_INPUTS && wire.from.port == *port;
        let target = |wire: &Wire| {
            let mut outer = ids[..step].to_vec();
            outer.push(self.ids.get(&wire.to.node)?.clone());
            Some(Target::Input { node: path_of(&outer)?, port: wire.to.port.clone() })
        };
        Some(self.definition.graph.wires.iter().filter(is_it).filter_map(target).collect())
    }

    /// Output outside that replaces an output in the group, or one of the group's own.
    fn output(&self, look: &Look, output: &OutputPort) -> Option<OutputPort> {
        let ids = output.node.ids();
        let step = step_in(look, &output.node, self.graph).filter(|&step| ids[step] == *self.id)?;
        let outside = |node: NodeId, rest: &[NodeId], port: &PortName| {
            let mut outer = ids[..step].to_vec();
            outer.push(node);
            outer.extend_from_slice(rest);
            Some(OutputPort { node: path_of(&outer)?, port: port.clone() })
        };
        if let Some(inner) = ids.get(step + 1) {
            return outside(self.ids.get(inner)?.clone(), &ids[step + 2..], &output.port);
        }
        let first = self.definition.outputs.first().map(|port| &port.name);
        let port = if output.port.as_str().is_empty() { first? } else { &output.port };
        let from = &self.definition.graph.wire_into(&NodeId::new(GROUP_OUTPUTS), port)?.from;
        let end = self.outside(from)?;
        outside(end.node, &[], &end.port)
    }

    /// Edits of the frames and notes of the group, and of the frame that the group lies in.
    fn frames(&self) -> Vec<Edit> {
        let mut edits = Vec::new();
        let inner = &self.definition.graph;
        let outside = |nodes: &[NodeId]| {
            nodes.iter().filter_map(|id| self.ids.get(id).cloned()).collect::<Vec<_>>()
        };
        let mut framed = Vec::new();
        let mut taken: Vec<String> = self.of.frames.keys().map(ToString::to_string).collect();
        for (id, frame) in &inner.frames {
            let slug = make_slug(id.as_str(), |slug| taken.iter().any(|known| known == slug));
            let mut frame = frame.clone();
            frame.nodes = outside(&frame.nodes);
            framed.extend(frame.nodes.iter().cloned());
            edits.push(Edit::AddFrame {
                graph: self.graph.clone(),
                id: FrameId::new(slug.as_str()),
                frame,
                index: None,
            });
            taken.push(slug);
        }
        for (id, frame) in self.of.frames.iter().filter(|(_, frame)| frame.nodes.contains(self.id))
        {
            let mut frame = frame.clone();
            frame.nodes.extend(self.ids.values().filter(|id| !framed.contains(id)).cloned());
            edits.push(Edit::SetFrame { graph: self.graph.clone(), id: id.clone(), frame });
        }
        let shift = self.shift();
        let mut taken: Vec<String> = self.of.notes.keys().map(ToString::to_string).collect();
        for (id, note) in &inner.notes {
            let slug = make_slug(id.as_str(), |slug| taken.iter().any(|known| known == slug));
            let mut note = note.clone();
            note.position = [note.position[0] + shift[0], note.position[1] + shift[1]];
            edits.push(Edit::AddNote {
                graph: self.graph.clone(),
                id: NoteId::new(slug.as_str()),
                note,
                index: None,
            });
            taken.push(slug);
        }
        edits
    }
}

/// Edit that removes the definition of a removed node, where that node was the last to use it.
fn unused(look: &Look, graph: &GraphId, id: &NodeId, node: &Node) -> Option<Edit> {
    let own = DefinitionId::from(node.kind.as_str());
    look.definitions.get(&own)?;
    let definitions = look.definitions.iter().filter(|(id, _)| **id != own);
    let definitions =
        definitions.map(|(id, definition)| (GraphId::Definition(id.clone()), &definition.graph));
    let mut graphs = std::iter::once((GraphId::Look, &look.graph)).chain(definitions);
    let is_used = graphs.any(|(of_id, of)| {
        of.nodes
            .iter()
            .any(|(other, of_other)| of_other.kind == node.kind && (other, &of_id) != (id, graph))
    });
    (!is_used).then_some(Edit::RemoveDefinition { id: own })
}
