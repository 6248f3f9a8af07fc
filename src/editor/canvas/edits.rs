//! Edits that the canvas proposes, to the graph that is open.

use eframe::egui;
use std::collections::{HashMap, HashSet};

use eframe::egui::{Pos2, Rect};
use indexmap::IndexMap;

use crate::catalog::{CODE_VALUE, CUSTOM_CODE, CUSTOM_KIND, NodeKind};
use crate::document::grouping::{self, OfferedValue};
use crate::document::{Edit, Endpoint, Frame, Light, Node, Note, Value, Wire};
use crate::ids::{
    FrameId, GROUP_INPUTS, GROUP_OUTPUTS, LightId, NodeId, NoteId, PortName, make_slug,
};
use crate::library::{Fallback, Type};
use crate::state::session::Session;

/// Offset of a copy from its original, across and downward, in points of the graph.
const COPY_OFFSET: f64 = 32.0;

/// Largest number of values that a new group has as its own.
const MOST_OFFERED: usize = 32;

/// Removes nodes.
pub(crate) fn delete(session: &Session, nodes: impl Iterator<Item = NodeId>) -> Option<Edit> {
    let graph = session.selection.graph_id();
    let there = nodes.filter(|id| session.graph().nodes.contains_key(id));
    let edits: Vec<Edit> = there.map(|id| Edit::RemoveNode { graph: graph.clone(), id }).collect();
    (!edits.is_empty()).then_some(Edit::Group { edits })
}

/// Adds a node of a kind with its corner at a place of the graph. Returns its id and the edits.
pub(crate) fn add(session: &Session, kind: &NodeKind, at: Pos2) -> (NodeId, Vec<Edit>) {
    let look = session.look();
    let id = NodeId::new(make_slug(&kind.id, |slug| is_taken(session, slug)));
    let position = [f64::from(at.x).round(), f64::from(at.y).round()];
    let mut node = Node { kind: kind.id.clone(), position, ..Node::default() };
    if kind.id == CUSTOM_KIND {
        node.values.insert(CODE_VALUE.into(), Value::Text(CUSTOM_CODE.to_owned()));
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
    edits.push(Edit::AddNode {
        graph: session.selection.graph_id().clone(),
        id: id.clone(),
        node,
        index: None,
    });
    (id, edits)
}

/// True for ids that a new node cannot have.
fn is_taken(session: &Session, slug: &str) -> bool {
    session.graph().nodes.contains_key(slug) || matches!(slug, GROUP_INPUTS | GROUP_OUTPUTS)
}

/// Wires an output to an input, in place of the input's wire so far.
pub(crate) fn connect(session: &Session, from: Endpoint, to: Endpoint) -> Edit {
    Edit::AddWire {
        graph: session.selection.graph_id().clone(),
        wire: Wire { from, to },
        index: None,
    }
}

/// Removes a wire.
pub(crate) fn disconnect(session: &Session, wire: Wire) -> Edit {
    Edit::RemoveWire { graph: session.selection.graph_id().clone(), wire }
}

/// Copies nodes with the wires between them and into them. Returns the new ids and the edit.
pub(crate) fn duplicate(session: &Session, nodes: &[NodeId]) -> (Vec<NodeId>, Edit) {
    let of = session.graph();
    let graph = session.selection.graph_id();
    let mut new_ids: IndexMap<&NodeId, NodeId> = IndexMap::new();
    let mut edits = Vec::new();
    for id in nodes {
        let Some(node) = of.nodes.get(id) else { continue };
        let is_new = |slug: &str| new_ids.values().any(|id| id.as_str() == slug);
        let base = id.as_str().trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches('_');
        let base = if base.is_empty() { id.as_str() } else { base };
        let new = NodeId::new(make_slug(base, |slug| is_taken(session, slug) || is_new(slug)));
        let mut node = node.clone();
        node.position = node.position.map(|x| x + COPY_OFFSET);
        edits.push(Edit::AddNode { graph: graph.clone(), id: new.clone(), node, index: None });
        new_ids.insert(id, new);
    }
    for wire in &of.wires {
        let Some(to) = new_ids.get(&wire.to.node) else { continue };
        let from = new_ids.get(&wire.from.node).unwrap_or(&wire.from.node);
        let from = Endpoint { node: from.clone(), port: wire.from.port.clone() };
        edits.push(connect(
            session,
            from,
            Endpoint { node: to.clone(), port: wire.to.port.clone() },
        ));
    }
    (new_ids.into_values().collect(), Edit::Group { edits })
}

/// Moves nodes by one distance.
pub(crate) fn translate<'a>(
    session: &Session,
    nodes: impl Iterator<Item = &'a NodeId>,
    by: egui::Vec2,
) -> Edit {
    let of = session.graph();
    let moved = nodes.filter_map(|id| {
        let [x, y] = of.nodes.get(id)?.position;
        // Positions are whole points, so that files stay readable.
        Some((id.clone(), [(x + f64::from(by.x)).round(), (y + f64::from(by.y)).round()]))
    });
    Edit::MoveNodes { graph: session.selection.graph_id().clone(), positions: moved.collect() }
}

/// Moves nodes to given places.
pub(crate) fn put(session: &Session, places: impl Iterator<Item = (NodeId, Pos2)>) -> Edit {
    let there = places.filter(|(id, _)| session.graph().nodes.contains_key(id));
    let positions = there.map(|(id, at)| (id, [f64::from(at.x).round(), f64::from(at.y).round()]));
    Edit::MoveNodes { graph: session.selection.graph_id().clone(), positions: positions.collect() }
}

/// Makes a group of nodes. Returns the group's node and the edit.
pub(crate) fn group(session: &Session, nodes: &[NodeId]) -> Option<(NodeId, Edit)> {
    // The look's output stays in the look.
    let nodes: Vec<NodeId> = nodes.iter().filter(|id| !is_output(session, id)).cloned().collect();
    let taken = |slug: &str| session.project.catalog.get(slug).is_some();
    let first = |node: &Node| {
        session.project.catalog.of(node)?.outputs.first().map(|port| port.name.clone())
    };
    let grouped = grouping::group_with_values(
        session.look(),
        session.selection.graph_id(),
        &nodes,
        "Group",
        taken,
        first,
        &changed_values(session, &nodes),
    )?;
    Some((grouped.node, grouped.edit))
}

/// Values of nodes that differ from their defaults: a group of the nodes has them as its own. Only
/// what a wire could bring is offered, as a choice or the name of a light decides what the nodes
/// are. Where several have one label, each is named with its node.
fn changed_values(session: &Session, nodes: &[NodeId]) -> Vec<OfferedValue> {
    let of = session.graph();
    let mut found: Vec<(OfferedValue, &str)> = Vec::new();
    for id in of.nodes.keys().filter(|id| nodes.contains(id)) {
        let Some((node, kind)) = of.nodes.get(id).and_then(|node| {
            let kind: &NodeKind = session.project.catalog.of(node)?;
            Some((node, kind))
        }) else {
            continue;
        };
        for port in &kind.inputs {
            let is_changed = node.values.get(&port.name).is_some_and(
                |value| !matches!(&port.fallback, Fallback::Value(default) if default == value),
            );
            let is_free = of.wire_into(id, &port.name).is_none();
            if is_changed && is_free && port.is_wirable() {
                let (node, port_name) = (id.clone(), port.name.clone());
                found.push((OfferedValue { node, port: port_name, label: None }, &*port.label));
            }
        }
    }
    // A group of so many values is no part with knobs, but a piece of graph that was put away.
    if found.len() > MOST_OFFERED {
        return Vec::new();
    }
    let labels: Vec<&str> = found.iter().map(|(_, label)| *label).collect();
    let is_twice = |label: &str| labels.iter().filter(|known| **known == label).count() > 1;
    let named = found.iter().map(|(offer, label)| {
        let title = || {
            let node = of.nodes.get(&offer.node)?;
            let kind = session.project.catalog.of(node)?;
            Some(if node.name.is_empty() { kind.label.to_string() } else { node.name.clone() })
        };
        let label = is_twice(label).then(title).flatten().map(|title| format!("{title}: {label}"));
        OfferedValue { label, ..offer.clone() }
    });
    named.collect()
}

fn is_output(session: &Session, id: &NodeId) -> bool {
    session.graph().nodes.get(id).is_some_and(|node| node.kind == "output")
}

/// Dissolves groups one after the other. Returns the nodes that take their place and the edit, or
/// the reason why a group cannot be dissolved.
pub(crate) fn ungroup(
    session: &Session,
    nodes: &[NodeId],
) -> Result<Option<(Vec<NodeId>, Edit)>, String> {
    let mut trial = session.look().clone();
    let (mut all, mut edits) = (Vec::new(), Vec::new());
    for id in nodes {
        let Some(node) = session.graph().nodes.get(id) else { continue };
        let Some(definition) = session.look_with_library().definition_of(&node.kind).cloned()
        else {
            continue;
        };
        let dissolved = grouping::dissolve(&trial, session.selection.graph_id(), id, &definition)
            .map_err(|problem| crate::state::problem_text::sentence(&problem))?;
        // The next group is dissolved in the look as this edit leaves it.
        trial.apply(dissolved.edit.clone()).map_err(|problem| problem.message)?;
        all.extend(dissolved.nodes);
        edits.push(dissolved.edit);
    }
    Ok((!edits.is_empty()).then_some((all, Edit::Group { edits })))
}

/// Puts a frame around nodes, and takes them out of the frames that they are in.
pub(crate) fn frame(session: &Session, nodes: &[NodeId]) -> Option<(FrameId, Edit)> {
    let of = session.graph();
    let nodes: Vec<NodeId> =
        nodes.iter().filter(|id| of.nodes.contains_key(*id)).cloned().collect();
    if nodes.is_empty() {
        return None;
    }
    let mut edits = leave_frames(session, &nodes);
    let id = FrameId::new(make_slug("frame", |slug| of.frames.contains_key(slug)));
    let frame = Frame { title: "Frame".to_owned(), color: Vec::new(), nodes };
    edits.push(Edit::AddFrame {
        graph: session.selection.graph_id().clone(),
        id: id.clone(),
        frame,
        index: None,
    });
    Some((id, Edit::Group { edits }))
}

/// Takes nodes out of their frames; a frame that is left without nodes is removed.
pub(crate) fn leave_frames(session: &Session, nodes: &[NodeId]) -> Vec<Edit> {
    let graph = session.selection.graph_id();
    let mut edits = Vec::new();
    for (id, frame) in &session.graph().frames {
        let rest: Vec<NodeId> =
            frame.nodes.iter().filter(|id| !nodes.contains(id)).cloned().collect();
        if rest.len() == frame.nodes.len() {
            continue;
        }
        edits.push(if rest.is_empty() {
            Edit::RemoveFrame { graph: graph.clone(), id: id.clone() }
        } else {
            let frame = Frame { nodes: rest, ..frame.clone() };
            Edit::SetFrame { graph: graph.clone(), id: id.clone(), frame }
        });
    }
    edits
}

/// Puts nodes into a frame; without one, takes them out of their frames.
pub(crate) fn join_frame(session: &Session, nodes: &[NodeId], to: Option<&FrameId>) -> Vec<Edit> {
    let frames = &session.graph().frames;
    let target = to.and_then(|id| Some((id, frames.get(id)?)));
    let moving: Vec<NodeId> = nodes
        .iter()
        .filter(|id| target.is_none_or(|(_, frame)| !frame.nodes.contains(id)))
        .cloned()
        .collect();
    if moving.is_empty() {
        return Vec::new();
    }
    let mut edits = leave_frames(session, &moving);
    if let Some((id, frame)) = target {
        let mut frame = frame.clone();
        frame.nodes.extend(moving);
        edits.push(Edit::SetFrame {
            graph: session.selection.graph_id().clone(),
            id: id.clone(),
            frame,
        });
    }
    edits
}

/// Changes a frame.
pub(crate) fn set_frame(
    session: &Session,
    id: &FrameId,
    change: impl FnOnce(&mut Frame),
) -> Option<Edit> {
    let mut frame = session.graph().frames.get(id)?.clone();
    change(&mut frame);
    Some(Edit::SetFrame { graph: session.selection.graph_id().clone(), id: id.clone(), frame })
}

/// Changes a note.
pub(crate) fn set_note(
    session: &Session,
    id: &NoteId,
    change: impl FnOnce(&mut Note),
) -> Option<Edit> {
    let mut note = session.graph().notes.get(id)?.clone();
    change(&mut note);
    Some(Edit::SetNote { graph: session.selection.graph_id().clone(), id: id.clone(), note })
}

/// Adds a note.
pub(crate) fn note(session: &Session, at: Pos2) -> (NoteId, Edit) {
    let id = NoteId::new(make_slug("note", |slug| session.graph().notes.contains_key(slug)));
    let position = [f64::from(at.x).round(), f64::from(at.y).round()];
    let note = Note { text: "Note".to_owned(), position, ..Note::default() };
    let edit = Edit::AddNote {
        graph: session.selection.graph_id().clone(),
        id: id.clone(),
        note,
        index: None,
    };
    (id, edit)
}

/// Best pair of an output of one kind and an input of another, by index: exact types first, then
/// conversions that lose nothing.
pub(crate) fn best_pair(
    from: &NodeKind,
    to: &NodeKind,
    is_free: impl Fn(usize) -> bool,
) -> Option<(usize, usize)> {
    let mut best: Option<(i32, usize, usize)> = None;
    for (output, out) in from.outputs.iter().enumerate() {
        for (input, port) in to.inputs.iter().enumerate().filter(|(_, port)| port.is_wirable()) {
            if !port.takes(&out.ty) && !from.is_reroute {
                continue;
            }
            let exact = if port.ty == out.ty {
                4
            } else {
                i32::from(out.ty.converts_without_loss(&port.ty)) * 2
            };
            let free = if is_free(input) { 8 } else { 0 };
            // Earlier ports are preferred: a node's main input comes first.
            let score = exact + free - (input as i32 + output as i32).min(3);
            if best.is_none_or(|(known, ..)| score > known) {
                best = Some((score, output, input));
            }
        }
    }
    best.map(|(_, output, input)| (output, input))
}

/// Removes nodes and wires the source of each to its consumers, along the way by which the node
/// would pass its value on if it were muted.
pub(crate) fn dissolve(session: &Session, nodes: &[NodeId]) -> Option<Edit> {
    let of = session.graph();
    let gone: HashSet<&NodeId> = nodes.iter().filter(|id| of.nodes.contains_key(*id)).collect();
    let mut edits = Vec::new();
    for wire in of
        .wires
        .iter()
        .filter(|wire| gone.contains(&wire.from.node) && !gone.contains(&wire.to.node))
    {
        let mut from = wire.from.clone();
        // The source is followed back through all nodes that are removed; the bound ends rings.
        for _ in 0..=gone.len() {
            if !gone.contains(&from.node) {
                break;
            }
            let Some(next) = through(session, &from) else { break };
            from = next;
        }
        if !gone.contains(&from.node) {
            edits.push(connect(session, from, wire.to.clone()));
        }
    }
    edits.extend(delete(session, nodes.iter().cloned()));
    (!gone.is_empty()).then_some(Edit::Group { edits })
}

/// Source of the input that is most like the output `from`.
fn through(session: &Session, from: &Endpoint) -> Option<Endpoint> {
    let of = session.graph();
    let kind = session.project.catalog.of(of.nodes.get(&from.node)?)?;
    let output = &kind.outputs[kind.output(from.port.as_str())?];
    let like = |wire: &&Wire| {
        let input = kind.input(wire.to.port.as_str()).map(|index| &kind.inputs[index]);
        wire.to.node == from.node
            && input.is_some_and(|input| input.ty == output.ty || kind.is_reroute)
    };
    let mut wires: Vec<&Wire> = of.wires.iter().filter(like).collect();
    wires.sort_by_key(|wire| (wire.to.port != output.name, kind.input(wire.to.port.as_str())));
    wires.first().map(|wire| wire.from.clone())
}

/// Changes a node's kind; wires and values that fit stay, matched by name or else in order.
pub(crate) fn swap(session: &Session, id: &NodeId, kind: &NodeKind) -> Option<Edit> {
    let of = session.graph();
    let graph = session.selection.graph_id();
    let node = of.nodes.get(id)?;
    let old = session.project.catalog.of(node);
    let mut edits =
        vec![Edit::SetKind { graph: graph.clone(), id: id.clone(), kind: kind.id.clone() }];
    let mut claimed: HashSet<usize> = HashSet::new();
    let into: Vec<&Wire> = of.wires.iter().filter(|wire| wire.to.node == *id).collect();
    let mut rest = Vec::new();
    for wire in into {
        let ty = type_of(session, &wire.from);
        let fits = |index: usize| ty.as_ref().is_none_or(|ty| kind.inputs[index].takes(ty));
        match kind.input(wire.to.port.as_str()).filter(|&index| fits(index)) {
            Some(index) => drop(claimed.insert(index)),
            None => rest.push((wire, ty)),
        }
    }
    for (wire, ty) in rest {
        edits.push(disconnect(session, wire.clone()));
        let takes = |index: &usize| ty.as_ref().is_some_and(|ty| kind.inputs[*index].takes(ty));
        let free = (0..kind.inputs.len()).filter(|index| !claimed.contains(index)).find(takes);
        if let Some(index) = free {
            claimed.insert(index);
            let to = Endpoint { node: id.clone(), port: kind.inputs[index].name.clone() };
            edits.push(connect(session, wire.from.clone(), to));
        }
    }
    for wire in of.wires.iter().filter(|wire| wire.from.node == *id) {
        let takes =
            |index: &usize| takes(session, &wire.to, &kind.outputs[*index].ty) || kind.is_reroute;
        if wire.from.port.as_str().is_empty() && kind.output("").is_some_and(|index| takes(&index))
        {
            continue;
        }
        if kind.output(wire.from.port.as_str()).is_some_and(|index| takes(&index)) {
            continue;
        }
        edits.push(disconnect(session, wire.clone()));
        if let Some(index) = (0..kind.outputs.len()).find(takes) {
            let from = Endpoint { node: id.clone(), port: kind.outputs[index].name.clone() };
            edits.push(connect(session, from, wire.to.clone()));
        }
    }
    edits.extend(swap_values(session, id, node, old.map(|kind| &**kind), kind));
    Some(Edit::Group { edits })
}

/// Edits of a node's values for its new kind: values without an input of the same name and type are
/// cleared; the code of a custom node and the names of lights get defaults.
fn swap_values(
    session: &Session,
    id: &NodeId,
    node: &Node,
    old: Option<&NodeKind>,
    kind: &NodeKind,
) -> Vec<Edit> {
    let graph = session.selection.graph_id();
    let type_in =
        |kind: &NodeKind, port: &PortName| Some(kind.inputs[kind.input(port.as_str())?].ty.clone());
    let mut edits = Vec::new();
    for port in node.values.keys() {
        let stays = type_in(kind, port)
            .is_some_and(|ty| old.and_then(|old| type_in(old, port)).is_none_or(|old| old == ty));
        if !stays {
            edits.push(Edit::ClearValue {
                graph: graph.clone(),
                id: id.clone(),
                port: port.clone(),
            });
        }
    }
    let mut set = |port: PortName, value: Value| {
        edits.push(Edit::SetValue {
            graph: graph.clone(),
            id: id.clone(),
            port,
            value,
            index: None,
        });
    };
    if kind.id == CUSTOM_KIND && !node.values.contains_key(CODE_VALUE) {
        set(CODE_VALUE.into(), Value::Text(CUSTOM_CODE.to_owned()));
    }
    if let Some(light) = session.look().lights.keys().next() {
        let lights = kind.inputs.iter().filter(|input| input.ty == Type::LightName);
        for input in lights.filter(|input| !node.values.contains_key(&input.name)) {
            set(input.name.clone(), Value::Text(light.to_string()));
        }
    }
    edits
}

/// Type of an output of the graph that is open.
fn type_of(session: &Session, from: &Endpoint) -> Option<Type> {
    let kind = session.project.catalog.of(session.graph().nodes.get(&from.node)?)?;
    (!kind.is_reroute).then(|| Some(kind.outputs[kind.output(from.port.as_str())?].ty.clone()))?
}

/// True if an input of the graph that is open takes a type; an unknown input takes any.
fn takes(session: &Session, to: &Endpoint, ty: &Type) -> bool {
    let kind =
        session.graph().nodes.get(&to.node).and_then(|node| session.project.catalog.of(node));
    let port = kind.and_then(|kind| Some(&kind.inputs[kind.input(to.port.as_str())?]));
    port.is_none_or(|port| port.takes(ty))
}

/// The nodes given and all nodes upstream or downstream of them.
pub(crate) fn stream(session: &Session, nodes: &[NodeId], is_up: bool) -> Vec<NodeId> {
    let mut next: HashMap<&NodeId, Vec<&NodeId>> = HashMap::new();
    for wire in &session.graph().wires {
        let (a, b) = (&wire.from.node, &wire.to.node);
        let (from, to) = if is_up { (b, a) } else { (a, b) };
        next.entry(from).or_default().push(to);
    }
    let mut found: indexmap::IndexSet<&NodeId> = nodes.iter().collect();
    let mut at = 0;
    while let Some(&id) = found.get_index(at) {
        found.extend(next.get(id).into_iter().flatten());
        at += 1;
    }
    found.into_iter().cloned().collect()
}

/// Bounds of all rectangles.
pub(crate) fn around(rects: impl Iterator<Item = Rect>) -> Rect {
    rects.fold(Rect::NOTHING, |all, rect| all.union(rect))
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::document::{ExposedValue, GraphId, Target};
    use crate::library::Library;

    #[test]
    fn a_group_has_the_values_that_were_changed_in_its_nodes() {
        let mut session = Session::new(Arc::new(Library::built_in().clone()), || {});
        let set = |port: &str, number: f64| Edit::SetValue {
            graph: GraphId::Look,
            id: "diffuse".into(),
            port: port.into(),
            value: Value::Number(number),
            index: None,
        };
        let target = Target::parse("diffuse.cutoff").expect("a target");
        let exposed =
            ExposedValue { name: "edge".into(), target: target.clone(), label: String::new() };
        let expose = Edit::AddExposed { exposed, index: None };
        // The offset has its default, which is no change.
        let edits = vec![set("cutoff", 1.2), set("offset", 0.0), expose];
        session.apply(Edit::Group { edits }, None).expect("it has these");
        let before = session.look().to_text();
        let (node, edit) = group(&session, &["diffuse".into()]).expect("a group");
        session.apply(edit, None).expect("one step");
        let look = session.look();
        let definition = &look.definitions["group"];
        let offered: Vec<&str> = definition
            .inputs
            .iter()
            .filter(|port| port.default.is_some())
            .map(|port| port.name.as_str())
            .collect();
        assert_eq!(
            offered,
            ["cutoff", "convex", "concave"],
            "not the light, nor what was not changed"
        );
        assert!(!definition.graph.nodes["diffuse"].values.contains_key("cutoff"));
        let moved = Target::Input { node: crate::ids::NodePath::root(node), port: "cutoff".into() };
        assert_eq!(look.exposed[0].target, moved, "what was exposed follows");
        assert_eq!(session.keys().value_now(&moved), Some(Value::Number(1.2)));
        let (_, back) = ungroup(&session, &["group".into()]).expect("it can").expect("a group");
        session.apply(back, None).expect("the values go back");
        assert_eq!(session.keys().value_now(&target), Some(Value::Number(1.2)));
        session.undo();
        session.undo();
        assert_eq!(session.look().to_text(), before);
    }
}
