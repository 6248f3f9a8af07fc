//! Edits of nodes, wires and frames.

use chiaro_locale::tr;
use indexmap::IndexMap;

use super::parts::{insert, remove_named};
use super::{Edit, EditResult, group, impossible, missing, nothing};
use crate::diag::Diagnostic;
use crate::document::{
    Bookmark, DirectionKeys, Frame, Graph, GraphId, Look, NamedAov, Node, Note, Target, Value, Wire,
};
use crate::ids::{DefinitionId, FrameId, NodeId, NodePath, NoteId, PortName};

fn graph_mut<'l>(look: &'l mut Look, graph: &GraphId) -> Result<&'l mut Graph, Box<Diagnostic>> {
    look.graph_of_mut(graph).ok_or_else(|| match graph {
        GraphId::Definition(id) => missing(tr!("part" => "group"), id),
        GraphId::Look => impossible(tr!("there is no graph")),
    })
}

pub(super) fn node_mut<'l>(
    look: &'l mut Look,
    graph: &GraphId,
    id: &NodeId,
) -> Result<&'l mut Node, Box<Diagnostic>> {
    graph_mut(look, graph)?.nodes.get_mut(id).ok_or_else(|| missing(tr!("part" => "node"), id))
}

pub(super) fn add_node(
    look: &mut Look,
    graph: GraphId,
    id: NodeId,
    node: Node,
    index: Option<usize>,
) -> EditResult<Edit> {
    insert(&mut graph_mut(look, &graph)?.nodes, tr!("part" => "node"), id.clone(), node, index)?;
    Ok(Edit::RemoveNode { graph, id })
}

pub(super) fn remove_node(look: &mut Look, graph: GraphId, id: NodeId) -> EditResult<Edit> {
    let of = graph_mut(look, &graph)?;
    if !of.nodes.contains_key(&id) {
        return Err(missing(tr!("part" => "node"), id));
    }
    let names_it = |wire: &&Wire| wire.from.node == id || wire.to.node == id;
    let remove_wire = |wire: &Wire| Edit::RemoveWire { graph: graph.clone(), wire: wire.clone() };
    let mut edits: Vec<Edit> = of.wires.iter().filter(names_it).map(remove_wire).collect();
    for (frame_id, frame) in of.frames.iter().filter(|(_, frame)| frame.nodes.contains(&id)) {
        let mut frame = frame.clone();
        frame.nodes.retain(|node| *node != id);
        edits.push(Edit::SetFrame { graph: graph.clone(), id: frame_id.clone(), frame });
    }
    edits.extend(drop_targets(look, |look, target| leads_through(look, target, &graph, &id)));
    edits.extend(drop_outputs(look, |path| {
        steps(look, path).any(|(of, step)| of == graph && step == id)
    }));
    if edits.is_empty() {
        let (index, node) =
            remove_named(&mut graph_mut(look, &graph)?.nodes, tr!("part" => "node"), &id)?;
        return Ok(Edit::AddNode { graph, id, node, index: Some(index) });
    }
    edits.push(Edit::RemoveNode { graph, id });
    group(look, edits, true)
}

/// Edits that remove the exposed parameters and keys of these targets.
pub(super) fn drop_targets(look: &Look, drops: impl Fn(&Look, &Target) -> bool) -> Vec<Edit> {
    let mut edits = Vec::new();
    for (index, keys) in
        look.time_keys.iter().enumerate().rev().filter(|(_, keys)| drops(look, &keys.target))
    {
        let _ = keys;
        edits.push(Edit::RemoveTimeKeys { index });
    }
    for (index, keys) in look.direction_keys.iter().enumerate() {
        let dropped = |target: &Target| drops(look, target);
        if keys.keys.iter().any(|key| key.values.keys().any(dropped)) {
            let mut keys = keys.clone();
            for key in &mut keys.keys {
                key.values.retain(|target, _| !drops(look, target));
            }
            edits.push(Edit::SetDirectionKeys { index, keys });
        }
    }
    for (index, _) in
        look.exposed.iter().enumerate().rev().filter(|(_, exposed)| drops(look, &exposed.target))
    {
        edits.push(Edit::RemoveExposed { index });
    }
    edits
}

/// Edits that remove direction keys which an output of these nodes drives, and the names of their
/// outputs.
fn drop_outputs(look: &Look, drops: impl Fn(&NodePath) -> bool) -> Vec<Edit> {
    let is_driven = |keys: &DirectionKeys| keys.by.outputs().any(|output| drops(&output.node));
    let driven = look.direction_keys.iter().enumerate().rev().filter(|(_, keys)| is_driven(keys));
    let mut edits: Vec<Edit> =
        driven.map(|(index, _)| Edit::RemoveDirectionKeys { index }).collect();
    let kept = |aov: &&NamedAov| !drops(&aov.from.node);
    let aovs: Vec<NamedAov> = look.aovs.iter().filter(kept).cloned().collect();
    if aovs.len() < look.aovs.len() {
        edits.push(Edit::SetAovs { aovs });
    }
    edits
}

/// True if a target is an input of this node or lies in the group that the node is.
fn leads_through(look: &Look, target: &Target, graph: &GraphId, id: &NodeId) -> bool {
    let Target::Input { node, .. } = target else { return false };
    steps(look, node).any(|(of, step)| of == *graph && step == *id)
}

/// True if a path leads into the group that this node is.
fn leads_into(look: &Look, path: &NodePath, graph: &GraphId, id: &NodeId) -> bool {
    let mut steps = steps(look, path);
    steps.any(|(of, step)| of == *graph && step == *id) && steps.next().is_some()
}

/// Nodes along a path, each with the graph it lies in, as far as this document holds them.
fn steps<'l>(look: &'l Look, path: &'l NodePath) -> impl Iterator<Item = (GraphId, NodeId)> + 'l {
    let mut graph = Some(GraphId::Look);
    path.ids().iter().map_while(move |id| {
        let of = graph.take()?;
        let node = look.graph_of(&of).and_then(|graph| graph.nodes.get(id));
        graph = node.map(|node| GraphId::Definition(DefinitionId::from(node.kind.as_str())));
        Some((of, id.clone()))
    })
}

pub(super) fn set_kind(
    look: &mut Look,
    graph: GraphId,
    id: NodeId,
    kind: String,
) -> EditResult<Edit> {
    let old = std::mem::replace(&mut node_mut(look, &graph, &id)?.kind, kind.clone());
    let leads_nowhere = |look: &Look, node: &NodePath| {
        let is_own = look.definitions.contains_key(kind.as_str());
        leads_into(look, node, &graph, &id) && (!is_own || look.find(node).is_none())
    };
    let broken = |look: &Look, target: &Target| {
        let Target::Input { node, .. } = target else { return false };
        leads_nowhere(look, node)
    };
    let mut edits = drop_targets(look, broken);
    edits.extend(drop_outputs(look, |path| leads_nowhere(look, path)));
    if edits.is_empty() {
        return Ok(Edit::SetKind { graph, id, kind: old });
    }
    // Targets are removed first, so that undoing restores them last, when the inputs they name
    // exist again.
    node_mut(look, &graph, &id)?.kind = old;
    let mut edits = edits;
    edits.push(Edit::SetKind { graph, id, kind });
    group(look, edits, true)
}

pub(super) fn move_nodes(
    look: &mut Look,
    graph: GraphId,
    positions: IndexMap<NodeId, [f64; 2]>,
) -> EditResult<Edit> {
    let of = graph_mut(look, &graph)?;
    if let Some(id) = positions.keys().find(|&id| !of.nodes.contains_key(id)) {
        return Err(missing(tr!("part" => "node"), id));
    }
    let mut old = IndexMap::with_capacity(positions.len());
    for (id, position) in positions {
        if let Some(node) = of.nodes.get_mut(&id) {
            old.insert(id, std::mem::replace(&mut node.position, position));
        }
    }
    Ok(if old.is_empty() { nothing() } else { Edit::MoveNodes { graph, positions: old } })
}

pub(super) fn set_value(
    look: &mut Look,
    graph: GraphId,
    id: NodeId,
    port: PortName,
    value: Value,
    index: Option<usize>,
) -> EditResult<Edit> {
    let values = &mut node_mut(look, &graph, &id)?.values;
    if let Some(old) = values.get_mut(&port) {
        if *old == value {
            return Ok(nothing());
        }
        let value = std::mem::replace(old, value);
        return Ok(Edit::SetValue { graph, id, port, value, index: None });
    }
    insert(values, tr!("part" => "value"), port.clone(), value, index)?;
    Ok(Edit::ClearValue { graph, id, port })
}

pub(super) fn clear_value(
    look: &mut Look,
    graph: GraphId,
    id: NodeId,
    port: PortName,
) -> EditResult<Edit> {
    let values = &mut node_mut(look, &graph, &id)?.values;
    if !values.contains_key(&port) {
        return Ok(nothing());
    }
    let (index, value) = remove_named(values, tr!("part" => "value"), &port)?;
    Ok(Edit::SetValue { graph, id, port, value, index: Some(index) })
}

pub(super) fn add_wire(
    look: &mut Look,
    graph: GraphId,
    wire: Wire,
    index: Option<usize>,
) -> EditResult<Edit> {
    let wires = &mut graph_mut(look, &graph)?.wires;
    let feeds = |other: &Wire| other.to == wire.to;
    let old: Vec<Wire> = wires.iter().filter(|other| feeds(other)).cloned().collect();
    if index.is_some() || old.is_empty() {
        let index = index.unwrap_or(wires.len());
        if index > wires.len() {
            return Err(impossible(tr!(
                "there is no place {index} among {count} wires",
                count = wires.len()
            )));
        }
        wires.insert(index, wire.clone());
        return Ok(Edit::RemoveWire { graph, wire });
    }
    if old == [wire.clone()] {
        return Ok(nothing());
    }
    let index = wires.iter().position(feeds);
    let remove = |wire| Edit::RemoveWire { graph: graph.clone(), wire };
    let mut edits: Vec<Edit> = old.into_iter().map(remove).collect();
    edits.push(Edit::AddWire { graph, wire, index });
    group(look, edits, true)
}

pub(super) fn remove_wire(look: &mut Look, graph: GraphId, wire: &Wire) -> EditResult<Edit> {
    let wires = &mut graph_mut(look, &graph)?.wires;
    let index = wires.iter().position(|other| other == wire);
    let index = index.ok_or_else(|| {
        impossible(tr!("there is no wire from `{from}` to `{to}`", from = wire.from, to = wire.to))
    })?;
    let wire = wires.remove(index);
    Ok(Edit::AddWire { graph, wire, index: Some(index) })
}

pub(super) fn add_frame(
    look: &mut Look,
    graph: GraphId,
    id: FrameId,
    frame: Frame,
    index: Option<usize>,
) -> EditResult<Edit> {
    insert(&mut graph_mut(look, &graph)?.frames, tr!("part" => "frame"), id.clone(), frame, index)?;
    Ok(Edit::RemoveFrame { graph, id })
}

pub(super) fn set_frame(
    look: &mut Look,
    graph: GraphId,
    id: FrameId,
    frame: Frame,
) -> EditResult<Edit> {
    let old = graph_mut(look, &graph)?
        .frames
        .get_mut(&id)
        .ok_or_else(|| missing(tr!("part" => "frame"), &id))?;
    let frame = std::mem::replace(old, frame);
    Ok(Edit::SetFrame { graph, id, frame })
}

pub(super) fn remove_frame(look: &mut Look, graph: GraphId, id: FrameId) -> EditResult<Edit> {
    let (index, frame) =
        remove_named(&mut graph_mut(look, &graph)?.frames, tr!("part" => "frame"), &id)?;
    Ok(Edit::AddFrame { graph, id, frame, index: Some(index) })
}

pub(super) fn add_note(
    look: &mut Look,
    graph: GraphId,
    id: NoteId,
    note: Note,
    index: Option<usize>,
) -> EditResult<Edit> {
    insert(&mut graph_mut(look, &graph)?.notes, tr!("part" => "note"), id.clone(), note, index)?;
    Ok(Edit::RemoveNote { graph, id })
}

pub(super) fn set_note(
    look: &mut Look,
    graph: GraphId,
    id: NoteId,
    note: Note,
) -> EditResult<Edit> {
    let old = graph_mut(look, &graph)?
        .notes
        .get_mut(&id)
        .ok_or_else(|| missing(tr!("part" => "note"), &id))?;
    let note = std::mem::replace(old, note);
    Ok(Edit::SetNote { graph, id, note })
}

pub(super) fn remove_note(look: &mut Look, graph: GraphId, id: NoteId) -> EditResult<Edit> {
    let (index, note) =
        remove_named(&mut graph_mut(look, &graph)?.notes, tr!("part" => "note"), &id)?;
    Ok(Edit::AddNote { graph, id, note, index: Some(index) })
}

pub(super) fn set_bookmarks(
    look: &mut Look,
    graph: GraphId,
    bookmarks: Vec<Bookmark>,
) -> EditResult<Edit> {
    let bookmarks = std::mem::replace(&mut graph_mut(look, &graph)?.bookmarks, bookmarks);
    Ok(Edit::SetBookmarks { graph, bookmarks })
}
