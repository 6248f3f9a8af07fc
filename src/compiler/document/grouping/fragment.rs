//! Fragments: parts of a graph as text, in the form of a small look, so that they can be read,
//! mended and mailed as any other look.

use std::collections::{HashMap, HashSet};

use chiaro_locale::tr;
use indexmap::IndexMap;

use crate::diag::Diagnostic;
use crate::document::{Definition, Edit, Endpoint, Graph, GraphId, Look, Value, Wire};
use crate::ids::{DefinitionId, FrameId, NodeId, NoteId, make_slug};

/// Result of pasting a text into a graph.
#[derive(Clone, Debug, PartialEq)]
pub struct PastedFragment {
    /// Edit that adds the fragment.
    pub edit: Edit,
    /// Ids of the new nodes.
    pub nodes: Vec<NodeId>,
    /// Ids of the new notes.
    pub notes: Vec<NoteId>,
}

/// Text of nodes and notes of a graph: with the wires between them, the frames that hold none but
/// them, and the groups and lights that they name.
pub fn copy_text(look: &Look, graph: &Graph, nodes: &[NodeId], notes: &[NoteId]) -> String {
    let chosen: HashSet<&NodeId> = nodes.iter().collect();
    let inside = |end: &Endpoint| chosen.contains(&end.node) && graph.nodes.contains_key(&end.node);
    let mut part = Look::default();
    let of_nodes = graph.nodes.iter().filter(|(id, _)| chosen.contains(id));
    part.graph.nodes = of_nodes.map(|(id, node)| (id.clone(), node.clone())).collect();
    part.graph.wires =
        graph.wires.iter().filter(|wire| inside(&wire.from) && inside(&wire.to)).cloned().collect();
    let is_whole =
        |nodes: &[NodeId]| !nodes.is_empty() && nodes.iter().all(|id| chosen.contains(id));
    let frames = graph.frames.iter().filter(|(_, frame)| is_whole(&frame.nodes));
    part.graph.frames = frames.map(|(id, frame)| (id.clone(), frame.clone())).collect();
    let of_notes = graph.notes.iter().filter(|(id, _)| notes.contains(id));
    part.graph.notes = of_notes.map(|(id, note)| (id.clone(), note.clone())).collect();
    part.color_space = look.color_space;
    part.definitions = definitions(look, &part.graph);
    let graphs = std::iter::once(&part.graph)
        .chain(part.definitions.values().map(|definition| &definition.graph));
    let values =
        graphs.flat_map(|graph| graph.nodes.values()).flat_map(|node| node.values.values());
    let texts: HashSet<&str> = values
        .filter_map(|value| if let Value::Text(text) = value { Some(text.as_str()) } else { None })
        .collect();
    let lights = look.lights.iter().filter(|(id, _)| texts.contains(id.as_str()));
    part.lights = lights.map(|(id, light)| (id.clone(), light.clone())).collect();
    part.to_text()
}

/// Groups of a document that a graph uses, directly or through other groups.
fn definitions(look: &Look, graph: &Graph) -> IndexMap<DefinitionId, Definition> {
    let mut used: HashSet<&str> = HashSet::new();
    let mut open: Vec<&Graph> = vec![graph];
    while let Some(graph) = open.pop() {
        for node in graph.nodes.values() {
            if let Some((id, definition)) = look.definitions.get_key_value(node.kind.as_str())
                && used.insert(id.as_str())
            {
                open.push(&definition.graph);
            }
        }
    }
    let definitions = look.definitions.iter().filter(|(id, _)| used.contains(id.as_str()));
    definitions.map(|(id, definition)| (id.clone(), definition.clone())).collect()
}

/// Adds a fragment that [`copy_text`] wrote, or any other look's nodes, to a graph, with its middle
/// at `at` or, without one, a little off its own position. Groups and lights that the document has
/// already are used; others come along.
///
/// # Errors
/// A diagnostic where the text is no look, or holds nothing to add.
pub fn paste_text(
    look: &Look,
    graph: &GraphId,
    text: &str,
    at: Option<[f64; 2]>,
) -> Result<PastedFragment, Box<Diagnostic>> {
    let nothing = || {
        Box::new(
            Diagnostic::error("nothing-to-paste", tr!("the clipboard holds no nodes"))
                .hint(tr!("copy nodes first, or a look's JSON")),
        )
    };
    let of = look.graph_of(graph).ok_or_else(nothing)?;
    let part =
        if text.trim_start().starts_with('{') { Look::read(text, "clipboard").value } else { None };
    let mut part = part.ok_or_else(nothing)?;
    // A look has one output node, and groups have none.
    let has_output = *graph != GraphId::Look || of.nodes.values().any(|node| node.kind == OUTPUT);
    part.graph.nodes.retain(|_, node| !(has_output && node.kind == OUTPUT));
    if part.graph.nodes.is_empty() && part.graph.notes.is_empty() {
        return Err(nothing());
    }
    let mut edits = Vec::new();
    let kinds = add_definitions(look, &part, &mut edits);
    for (id, light) in part.lights.iter().filter(|(id, _)| !look.lights.contains_key(*id)) {
        edits.push(Edit::AddLight { id: id.clone(), light: light.clone(), index: None });
    }
    let shift = shift(&part.graph, at);
    let adder = FragmentAdder { of, graph, part: &part.graph, shift };
    let ids = adder.nodes(&kinds, &mut edits);
    adder.wires(&ids, &mut edits);
    adder.frames(&ids, &mut edits);
    let notes = adder.notes(&mut edits);
    Ok(PastedFragment { edit: Edit::Group { edits }, nodes: ids.into_values().collect(), notes })
}

/// Kind of the node that is the result of a look.
const OUTPUT: &str = "output";

/// Adds the groups that the document lacks. Returns the kinds that are renamed here.
fn add_definitions(look: &Look, part: &Look, edits: &mut Vec<Edit>) -> HashMap<String, String> {
    let mut kinds = HashMap::new();
    let mut taken: HashSet<String> = look.definitions.keys().map(ToString::to_string).collect();
    taken.extend(part.definitions.keys().map(ToString::to_string));
    for (id, definition) in &part.definitions {
        if look.definitions.get(id).is_some_and(|own| own != definition) {
            let new = make_slug(id.as_str(), |slug| taken.contains(slug));
            taken.insert(new.clone());
            kinds.insert(id.to_string(), new);
        }
    }
    for (id, definition) in inner_first(&part.definitions) {
        if look.definitions.get(id) == Some(definition) {
            continue;
        }
        let mut definition = definition.clone();
        for node in definition.graph.nodes.values_mut() {
            if let Some(new) = kinds.get(&node.kind) {
                node.kind.clone_from(new);
            }
        }
        let id = kinds
            .get(id.as_str())
            .map_or_else(|| id.clone(), |new| DefinitionId::from(new.as_str()));
        edits.push(Edit::AddDefinition { id, definition, index: None });
    }
    kinds
}

/// Groups, each before those that use it, so that undoing, which goes the other way, never removes
/// a group in use.
fn inner_first(all: &IndexMap<DefinitionId, Definition>) -> Vec<(&DefinitionId, &Definition)> {
    let mut rest: Vec<_> = all.iter().collect();
    let mut sorted: Vec<(&DefinitionId, &Definition)> = Vec::with_capacity(rest.len());
    while !rest.is_empty() {
        let open: HashSet<&str> = rest.iter().map(|(id, _)| id.as_str()).collect();
        let is_ready = |definition: &Definition| {
            !definition.graph.nodes.values().any(|node| open.contains(node.kind.as_str()))
        };
        let (ready, others): (Vec<_>, Vec<_>) =
            rest.iter().copied().partition(|(_, definition)| is_ready(definition));
        if ready.is_empty() {
            // The rest is a ring, which the compiler reports.
            sorted.extend(others);
            break;
        }
        sorted.extend(ready);
        rest = others;
    }
    sorted
}

/// Translation of the fragment, in points.
fn shift(part: &Graph, at: Option<[f64; 2]>) -> [f64; 2] {
    /// Distance of a copy from its original, in points.
    const COPY_OFFSET: f64 = 32.0;
    let Some(at) = at else { return [COPY_OFFSET; 2] };
    let nodes = part.nodes.values().map(|node| node.position);
    let places: Vec<[f64; 2]> =
        nodes.chain(part.notes.values().map(|note| note.position)).collect();
    let of = |axis: usize| {
        let along = || places.iter().map(|place| place[axis]);
        let (least, most) = (along().fold(f64::MAX, f64::min), along().fold(f64::MIN, f64::max));
        (at[axis] - (least + most) / 2.0).round()
    };
    [of(0), of(1)]
}

struct FragmentAdder<'a> {
    of: &'a Graph,
    graph: &'a GraphId,
    part: &'a Graph,
    shift: [f64; 2],
}

impl<'a> FragmentAdder<'a> {
    fn shifted(&self, place: [f64; 2]) -> [f64; 2] {
        // Greatest coordinate that a document may hold.
        const FAR: f64 = 1e9;
        [0, 1].map(|axis| (place[axis] + self.shift[axis]).clamp(-FAR, FAR))
    }

    fn nodes(
        &self,
        kinds: &HashMap<String, String>,
        edits: &mut Vec<Edit>,
    ) -> IndexMap<&'a NodeId, NodeId> {
        let mut ids: IndexMap<&NodeId, NodeId> = IndexMap::new();
        let ends = [crate::ids::GROUP_INPUTS, crate::ids::GROUP_OUTPUTS];
        let mut taken: HashSet<NodeId> =
            self.of.nodes.keys().cloned().chain(ends.map(NodeId::from)).collect();
        for (id, node) in &self.part.nodes {
            let base =
                id.as_str().trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches('_');
            let base = if base.is_empty() || !taken.contains(id) { id.as_str() } else { base };
            let new = if taken.contains(id) {
                NodeId::new(make_slug(base, |slug| taken.contains(slug)))
            } else {
                id.clone()
            };
            let mut node = node.clone();
            node.position = self.shifted(node.position);
            if let Some(kind) = kinds.get(&node.kind) {
                node.kind.clone_from(kind);
            }
            edits.push(Edit::AddNode {
                graph: self.graph.clone(),
                id: new.clone(),
                node,
                index: None,
            });
            taken.insert(new.clone());
            ids.insert(id, new);
        }
        ids
    }

    fn wires(&self, ids: &IndexMap<&NodeId, NodeId>, edits: &mut Vec<Edit>) {
        for Wire { from, to } in &self.part.wires {
            let (Some(from_id), Some(to_id)) = (ids.get(&from.node), ids.get(&to.node)) else {
                continue;
            };
            let from = Endpoint { node: from_id.clone(), port: from.port.clone() };
            let to = Endpoint { node: to_id.clone(), port: to.port.clone() };
            edits.push(Edit::AddWire {
                graph: self.graph.clone(),
                wire: Wire { from, to },
                index: None,
            });
        }
    }

    fn frames(&self, ids: &IndexMap<&NodeId, NodeId>, edits: &mut Vec<Edit>) {
        let mut taken: HashSet<String> = self.of.frames.keys().map(ToString::to_string).collect();
        for (id, frame) in &self.part.frames {
            let new = make_slug(id.as_str(), |slug| taken.contains(slug));
            taken.insert(new.clone());
            let mut frame = frame.clone();
            frame.nodes = frame.nodes.iter().filter_map(|id| ids.get(id).cloned()).collect();
            edits.push(Edit::AddFrame {
                graph: self.graph.clone(),
                id: FrameId::from(new),
                frame,
                index: None,
            });
        }
    }

    fn notes(&self, edits: &mut Vec<Edit>) -> Vec<NoteId> {
        let mut taken: HashSet<String> = self.of.notes.keys().map(ToString::to_string).collect();
        let mut ids = Vec::new();
        for (id, note) in &self.part.notes {
            let new = make_slug(id.as_str(), |slug| taken.contains(slug));
            taken.insert(new.clone());
            let mut note = note.clone();
            note.position = self.shifted(note.position);
            let id = NoteId::from(new);
            edits.push(Edit::AddNote {
                graph: self.graph.clone(),
                id: id.clone(),
                note,
                index: None,
            });
            ids.push(id);
        }
        ids
    }
}
