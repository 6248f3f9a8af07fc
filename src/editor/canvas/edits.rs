//! The edits that the canvas proposes.

use eframe::egui;
use std::collections::HashMap;

use eframe::egui::Pos2;
use indexmap::IndexMap;

use super::super::catalog::{CODE, CUSTOM_CODE, CUSTOM_KIND, Kind};
use crate::document::{Edit, Endpoint, GraphId, Light, Look, Node, Value, Wire};
use crate::ids::{LightId, NodeId, make_slug};
use crate::library::Type;

/// How far a copy lies from what it was made of.
const COPY_OFFSET: f64 = 32.0;

/// Removes nodes.
pub(crate) fn delete(nodes: impl Iterator<Item = NodeId>) -> Option<Edit> {
    let edits: Vec<Edit> = nodes.map(|id| Edit::RemoveNode { graph: GraphId::Look, id }).collect();
    (!edits.is_empty()).then_some(Edit::Group { edits })
}

/// Adds a node of a kind with its corner at a place of the graph. Returns its id and the edits.
pub(crate) fn add(look: &Look, kind: &Kind, at: Pos2) -> (NodeId, Vec<Edit>) {
    let id = NodeId::new(make_slug(&kind.id, |slug| is_taken(look, slug)));
    let position = [f64::from(at.x).round(), f64::from(at.y).round()];
    let mut node = Node { kind: kind.id.clone(), position, ..Node::default() };
    if kind.id == CUSTOM_KIND {
        node.values.insert(CODE.into(), Value::Text(CUSTOM_CODE.to_owned()));
    }
    let mut edits = Vec::new();
    for input in kind.inputs.iter().filter(|input| input.ty == Type::LightName) {
        let light = look.lights.keys().next().cloned().unwrap_or_else(|| {
            let id = LightId::from("key");
            if edits.is_empty() {
                let light = Light { direction: [-0.5, 0.7, 0.6], ..Light::default() };
                edits.push(Edit::AddLight { id: id.clone(), light, index: None });
            }
            id
        });
        node.values.insert(input.name.clone(), Value::Text(light.to_string()));
    }
    edits.push(Edit::AddNode { graph: GraphId::Look, id: id.clone(), node, index: None });
    (id, edits)
}

/// Ids that a new node cannot have.
fn is_taken(look: &Look, slug: &str) -> bool {
    look.graph.nodes.contains_key(slug)
}

/// Wires an output to an input, in place of what fed it.
pub(crate) fn connect(from: Endpoint, to: Endpoint) -> Edit {
    Edit::AddWire { graph: GraphId::Look, wire: Wire { from, to }, index: None }
}

/// Copies nodes with the wires between them and into them. Returns the new ids and the edit.
pub(crate) fn duplicate(look: &Look, nodes: &[NodeId]) -> (Vec<NodeId>, Edit) {
    let mut new_ids: IndexMap<&NodeId, NodeId> = IndexMap::new();
    let mut edits = Vec::new();
    for id in nodes {
        let Some(node) = look.graph.nodes.get(id) else { continue };
        let is_new = |slug: &str| new_ids.values().any(|id| id.as_str() == slug);
        let base = id.as_str().trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches('_');
        let base = if base.is_empty() { id.as_str() } else { base };
        let new = NodeId::new(make_slug(base, |slug| is_taken(look, slug) || is_new(slug)));
        let mut node = node.clone();
        node.position = node.position.map(|x| x + COPY_OFFSET);
        edits.push(Edit::AddNode { graph: GraphId::Look, id: new.clone(), node, index: None });
        new_ids.insert(id, new);
    }
    for wire in &look.graph.wires {
        let Some(to) = new_ids.get(&wire.to.node) else { continue };
        let from = new_ids.get(&wire.from.node).unwrap_or(&wire.from.node);
        let from = Endpoint { node: from.clone(), port: wire.from.port.clone() };
        edits.push(connect(from, Endpoint { node: to.clone(), port: wire.to.port.clone() }));
    }
    (new_ids.into_values().collect(), Edit::Group { edits })
}

/// Moves nodes by the same way.
pub(crate) fn translate<'a>(look: &Look, nodes: impl Iterator<Item = &'a NodeId>, by: egui::Vec2) -> Edit {
    let places: HashMap<&NodeId, [f64; 2]> = look.graph.nodes.iter().map(|(id, node)| (id, node.position)).collect();
    let moved = nodes.filter_map(|id| {
        let [x, y] = *places.get(id)?;
        // Whole points, so that files stay readable.
        Some((id.clone(), [(x + f64::from(by.x)).round(), (y + f64::from(by.y)).round()]))
    });
    Edit::MoveNodes { graph: GraphId::Look, positions: moved.collect() }
}
