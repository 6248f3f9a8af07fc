//! Making of groups from nodes of a graph.

use std::collections::{HashMap, HashSet};

use super::targets::{follow, path_of, step_in};
use crate::document::{
    Definition, Edit, Endpoint, Frame, Graph, GraphId, InterfacePort, Look, Node, OutputPort,
    Target, Wire,
};
use crate::ids::{
    DefinitionId, FrameId, GROUP_INPUTS, GROUP_OUTPUTS, NodeId, NodePath, PortName, make_slug,
};

/// Result of making a group.
#[derive(Clone, Debug, PartialEq)]
pub struct NewGroup {
    /// Edit that makes the group.
    pub edit: Edit,
    /// Id of the new node, in place of the grouped nodes.
    pub node: NodeId,
    /// Id of the group's definition.
    pub definition: DefinitionId,
}

/// Value of a node that a new group has as its own.
#[derive(Clone, Debug, PartialEq)]
pub struct OfferedValue {
    /// Node that has the value.
    pub node: NodeId,
    /// Input that has the value.
    pub port: PortName,
    /// Text beside the group's input; `None` for that of the node's.
    pub label: Option<String>,
}

/// Makes a group of nodes of a graph. Every outer output that feeds them becomes an input of the
/// group, every output of theirs that is used outside becomes an output; values, positions, frames,
/// keys and exposed parameters follow.
///
/// `taken` tells whether a kind exists already; `first_output` names a node's first output, for
/// wires that name no port. `None` where none of `nodes` exists.
pub fn group(
    look: &Look,
    graph: &GraphId,
    nodes: &[NodeId],
    label: &str,
    taken: impl Fn(&str) -> bool,
    first_output: impl Fn(&Node) -> Option<PortName>,
) -> Option<NewGroup> {
    group_with_values(look, graph, nodes, label, taken, first_output, &[])
}

/// [`group`] with values of its own: each of `offered` becomes an input of the group, whose default
/// it is, and its keys and exposed parameters follow it there.
pub fn group_with_values(
    look: &Look,
    graph: &GraphId,
    nodes: &[NodeId],
    label: &str,
    taken: impl Fn(&str) -> bool,
    first_output: impl Fn(&Node) -> Option<PortName>,
    offered: &[OfferedValue],
) -> Option<NewGroup> {
    let of = look.graph_of(graph)?;
    let moved: HashSet<&NodeId> = nodes.iter().filter(|&id| of.nodes.contains_key(id)).collect();
    if moved.is_empty() {
        return None;
    }
    let named = if label.is_empty() { "group" } else { label };
    let is_taken = |slug: &str| look.definitions.contains_key(slug) || taken(slug);
    let definition_id = DefinitionId::new(make_slug(named, is_taken));
    let node_id =
        NodeId::new(make_slug(named, |slug| of.nodes.contains_key(slug) || is_group_end(slug)));

    let mut parts = Parts::default();
    let mut outer = Vec::new();
    for wire in &of.wires {
        let from = with_port(of, &wire.from, &first_output);
        match (moved.contains(&wire.from.node), moved.contains(&wire.to.node)) {
            (true, true) => parts.graph.wires.push(wire.clone()),
            (false, true) => {
                let port = parts.input(&from, &wire.to);
                let inner = Endpoint::new(GROUP_INPUTS, port.clone());
                parts.graph.wires.push(Wire { from: inner, to: wire.to.clone() });
                let to = Endpoint { node: node_id.clone(), port };
                let into = Wire { from: wire.from.clone(), to };
                if !outer.contains(&into) {
                    outer.push(into);
                }
            }
            (true, false) => {
                let port = parts.output(&from);
                outer.push(Wire {
                    from: Endpoint { node: node_id.clone(), port },
                    to: wire.to.clone(),
                });
            }
            (false, false) => {}
        }
    }
    let inside = of.nodes.iter().filter(|(id, _)| moved.contains(id));
    parts.graph.nodes = inside.map(|(id, node)| (id.clone(), node.clone())).collect();
    let given = parts.take(offered, &moved);
    let position = middle(&parts.graph);
    let frames = frames(of, &moved, &node_id, graph, &mut parts.graph);

    let definition = Definition {
        label: label.to_owned(),
        inputs: parts.inputs,
        outputs: parts.outputs,
        graph: parts.graph,
        ..Definition::default()
    };
    let node = Node { kind: definition_id.to_string(), position, ..Node::default() };
    let mut edits = vec![
        Edit::AddDefinition { id: definition_id.clone(), definition, index: None },
        Edit::AddNode { graph: graph.clone(), id: node_id.clone(), node, index: None },
    ];
    let inside = |path: &NodePath| {
        let step = step_in(look, path, graph).filter(|&step| moved.contains(&path.ids()[step]))?;
        let mut ids = path.ids().to_vec();
        ids.insert(step, node_id.clone());
        path_of(&ids)
    };
    edits.extend(follow(
        look,
        |path, port| {
            let inner = inside(path)?;
            // The value of a node that moved itself, not of one in a group that moved.
            let (last, around) = inner.ids().split_last()?;
            let outer = given.get(&(last, port)).filter(|_| around.last() == Some(&node_id));
            Some(vec![match outer {
                Some(name) => Target::Input { node: path_of(around)?, port: name.clone() },
                None => Target::Input { node: inner.clone(), port: port.clone() },
            }])
        },
        |output| Some(OutputPort { node: inside(&output.node)?, port: output.port.clone() }),
    ));
    edits.extend(frames);
    // Nodes are removed in the order of the document, so that undoing puts each back where it was.
    let removed = of.nodes.keys().filter(|id| moved.contains(id));
    edits.extend(removed.map(|id| Edit::RemoveNode { graph: graph.clone(), id: id.clone() }));
    edits.extend(outer.into_iter().map(|wire| Edit::AddWire {
        graph: graph.clone(),
        wire,
        index: None,
    }));
    Some(NewGroup { edit: Edit::Group { edits }, node: node_id, definition: definition_id })
}

fn is_group_end(id: &str) -> bool {
    matches!(id, GROUP_INPUTS | GROUP_OUTPUTS)
}

/// Start of a wire, with the name of its port.
fn with_port(
    of: &Graph,
    from: &Endpoint,
    first_output: &impl Fn(&Node) -> Option<PortName>,
) -> Endpoint {
    if !from.port.as_str().is_empty() {
        return from.clone();
    }
    let port = of.nodes.get(&from.node).and_then(first_output).unwrap_or_default();
    Endpoint { node: from.node.clone(), port }
}

/// Parts of a group that is being made.
#[derive(Default)]
struct Parts {
    graph: Graph,
    inputs: Vec<InterfacePort>,
    outputs: Vec<InterfacePort>,
    /// Ports of the interface by the output that feeds them; true for outputs of the group.
    ports: HashMap<(bool, Endpoint), PortName>,
}

impl Parts {
    /// Interface input that this outer output feeds.
    fn input(&mut self, from: &Endpoint, to: &Endpoint) -> PortName {
        let key = (false, from.clone());
        if let Some(known) = self.ports.get(&key) {
            return known.clone();
        }
        let name = free_name(&self.inputs, &to.port, &to.node);
        self.inputs.push(InterfacePort { name: name.clone(), ..InterfacePort::default() });
        self.ports.insert(key, name.clone());
        name
    }

    /// Takes offered values out of the nodes that moved. Returns the interface input of each.
    fn take<'a>(
        &mut self,
        offered: &'a [OfferedValue],
        moved: &HashSet<&NodeId>,
    ) -> HashMap<(&'a NodeId, &'a PortName), PortName> {
        let mut given = HashMap::new();
        for offer in offered.iter().filter(|offer| moved.contains(&offer.node)) {
            if self.graph.wire_into(&offer.node, &offer.port).is_some() {
                continue;
            }
            let node = self.graph.nodes.get_mut(&offer.node);
            let Some(value) = node.and_then(|node| node.values.shift_remove(&offer.port)) else {
                continue;
            };
            let name = free_name(&self.inputs, &offer.port, &offer.node);
            self.inputs.push(InterfacePort {
                name: name.clone(),
                label: offer.label.clone(),
                default: Some(value),
                ..InterfacePort::default()
            });
            let from = Endpoint::new(GROUP_INPUTS, name.clone());
            let to = Endpoint { node: offer.node.clone(), port: offer.port.clone() };
            self.graph.wires.push(Wire { from, to });
            given.insert((&offer.node, &offer.port), name);
        }
        given
    }

    /// Interface output that this inner output becomes.
    fn output(&mut self, from: &Endpoint) -> PortName {
        let key = (true, from.clone());
        if let Some(known) = self.ports.get(&key) {
            return known.clone();
        }
        let name = free_name(&self.outputs, &from.port, &from.node);
        self.outputs.push(InterfacePort { name: name.clone(), ..InterfacePort::default() });
        self.ports.insert(key, name.clone());
        let to = Endpoint::new(GROUP_OUTPUTS, name.clone());
        self.graph.wires.push(Wire { from: from.clone(), to });
        name
    }
}

/// Name for a new port: the port's own, or else with that of its node.
fn free_name(ports: &[InterfacePort], port: &PortName, node: &NodeId) -> PortName {
    let is_taken = |slug: &str| ports.iter().any(|known| known.name.as_str() == slug);
    let own = if port.as_str().is_empty() { "value" } else { port.as_str() };
    if !is_taken(own) {
        return PortName::new(make_slug(own, |_| false));
    }
    PortName::new(make_slug(&format!("{node}_{own}"), is_taken))
}

/// Middle of the nodes' positions, in whole points.
fn middle(graph: &Graph) -> [f64; 2] {
    let of = |axis: usize| {
        let places = || graph.nodes.values().map(|node| node.position[axis]);
        let (least, most) = (places().fold(f64::MAX, f64::min), places().fold(f64::MIN, f64::max));
        ((least + most) / 2.0).round()
    };
    [of(0), of(1)]
}

/// Edits of frames. Frames whose nodes all move go along; moved nodes leave other frames, and the
/// group takes their place where one frame held all of them.
fn frames(
    of: &Graph,
    moved: &HashSet<&NodeId>,
    node: &NodeId,
    graph: &GraphId,
    inner: &mut Graph,
) -> Vec<Edit> {
    let mut edits = Vec::new();
    let mut around: Vec<(&FrameId, &Frame)> = Vec::new();
    for (id, frame) in &of.frames {
        let count = frame.nodes.iter().filter(|node| moved.contains(node)).count();
        if count > 0 && count == frame.nodes.len() && count < moved.len() {
            inner.frames.insert(id.clone(), frame.clone());
            edits.push(Edit::RemoveFrame { graph: graph.clone(), id: id.clone() });
        } else if count > 0 {
            around.push((id, frame));
        }
    }
    if let [(id, frame)] = around.as_slice()
        && moved.iter().all(|id| frame.nodes.contains(id))
    {
        let mut frame = (*frame).clone();
        frame.nodes.push(node.clone());
        edits.push(Edit::SetFrame { graph: graph.clone(), id: (*id).clone(), frame });
    }
    edits
}
