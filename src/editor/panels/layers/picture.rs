//! Look of a layer's thumbnail: the layer alone, over a ground on which its blending is visible.

use std::collections::{HashMap, HashSet};

use crate::document::{Endpoint, Graph, Look, Node, Value, Wire};
use crate::ids::{NodeId, PortName};

use crate::state::stack::BELOW;
use crate::state::stack::tree::INSIDE;

/// Id of the ground; no slug of a name begins so.
const GROUND: &str = "chiaro-ground";
/// Id of the output node that shows the layer.
const SHOWN: &str = "chiaro-output";

/// Look with nothing but one layer, or, where `mode` is `None`, with the ground of the stack. A
/// layer `is_dark` if it covers in a dark color, such as ink.
pub(super) fn of(look: &Look, id: &NodeId, mode: Option<&str>, is_dark: bool) -> Look {
    let mut shown = Look {
        color_space: look.color_space,
        tier: look.tier,
        max_error: look.max_error,
        lights: look.lights.clone(),
        definitions: look.definitions.clone(),
        graph: upstream(&look.graph, id, mode.is_some()),
        ..Look::default()
    };
    let graph = &mut shown.graph;
    if let Some(node) = graph.nodes.get_mut(id) {
        node.muted = false;
    }
    let mut add = |id: &str, kind: &str, values: &[(&str, Value)]| {
        let values =
            values.iter().map(|(port, value)| (PortName::from(*port), value.clone())).collect();
        graph.nodes.insert(id.into(), Node { kind: kind.to_owned(), values, ..Node::default() });
    };
    add(SHOWN, "output", &[]);
    if let Some(mode) = mode {
        // Blending that darkens is seen on white, blending that brightens on black.
        let ground = match mode {
            "multiply" | "shade" | "subtract" => 1.0,
            "alpha" if is_dark => 0.8,
            "alpha" => 0.35,
            _ => 0.0,
        };
        add(GROUND, "base", &[("color", Value::Vector(vec![ground, ground, ground, 1.0]))]);
        // A pass-through folder's layers lie on what is below it, as the folder does.
        let on_below = look.graph.wires.iter().filter(|wire| {
            graph.nodes.contains_key(&wire.to.node) && is_on_below(&look.graph, id, wire)
        });
        let own = Endpoint::new(id.clone(), BELOW);
        let inlets: HashSet<Endpoint> = on_below.map(|wire| wire.to.clone()).chain([own]).collect();
        let on_ground = inlets.into_iter().map(|to| Wire { from: Endpoint::new(GROUND, ""), to });
        graph.wires.extend(on_ground);
    }
    graph
        .wires
        .push(Wire { from: Endpoint::new(id.clone(), ""), to: Endpoint::new(SHOWN, "color") });
    shown
}

/// Graph of a node with all nodes that feed it; for a layer without those below it.
fn upstream(graph: &Graph, id: &NodeId, is_layer: bool) -> Graph {
    let mut kept: HashSet<&NodeId> = HashSet::from([id]);
    let mut open = vec![id];
    let mut into: HashMap<&NodeId, Vec<&Wire>> = HashMap::new();
    for wire in &graph.wires {
        into.entry(&wire.to.node).or_default().push(wire);
    }
    let is_wanted = |wire: &Wire| !(is_layer && is_on_below(graph, id, wire));
    while let Some(node) = open.pop() {
        for wire in into.get(node).into_iter().flatten().filter(|wire| is_wanted(wire)) {
            if kept.insert(&wire.from.node) {
                open.push(&wire.from.node);
            }
        }
    }
    let nodes = graph.nodes.iter().filter(|(id, _)| kept.contains(id));
    let wires = graph.wires.iter().filter(|wire| kept.contains(&wire.to.node) && is_wanted(wire));
    Graph {
        nodes: nodes.map(|(id, node)| (id.clone(), node.clone())).collect(),
        wires: wires.cloned().collect(),
        ..Graph::default()
    }
}

/// True for a wire into a layer, or into one in a pass-through folder, from what lies below.
fn is_on_below(graph: &Graph, id: &NodeId, wire: &Wire) -> bool {
    let is_of_stack = [BELOW, INSIDE].contains(&wire.to.port.as_str());
    let below = || graph.wire_into(id, &PortName::from(BELOW));
    is_of_stack
        && (wire.to.node == *id && wire.to.port.as_str() == BELOW
            || below().is_some_and(|below| below.from.node == wire.from.node))
}
