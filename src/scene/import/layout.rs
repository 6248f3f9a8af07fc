//! Places of imported nodes on the canvas: columns by the way to the output, notes above their
//! nodes.

use std::collections::{HashMap, VecDeque};

use crate::document::{Graph, Note};
use crate::ids::{NodeId, NoteId};
use crate::library::Library;

/// Width of a column, in points.
const COLUMN: f64 = 250.0;

/// Gap below a node, in points.
const GAP: f64 = 28.0;

/// Height of a node without ports, and of a port's row, in points.
const HEIGHTS: [f64; 2] = [44.0, 24.0];

/// Height of a note without text, and of a line of text, in points.
const NOTE_HEIGHTS: [f64; 2] = [20.0, 15.0];

/// Width of a letter in a note, in points, not to be too small.
const LETTER: f64 = 7.0;

/// Places all nodes: each in a column left of all that it feeds, and in a column by their
/// `heights`.
pub(super) fn place(graph: &mut Graph, heights: &HashMap<NodeId, f64>, library: &Library) {
    let columns = columns(graph);
    let mut rows: HashMap<usize, Vec<NodeId>> = HashMap::new();
    for id in graph.nodes.keys() {
        rows.entry(columns.get(id).copied().unwrap_or_default()).or_default().push(id.clone());
    }
    let height_of = |id: &NodeId| heights.get(id).copied().unwrap_or_default();
    for (column, mut ids) in rows {
        ids.sort_by(|a, b| height_of(a).total_cmp(&height_of(b)));
        let mut y = 0.0;
        for id in ids {
            let Some(node) = graph.nodes.get_mut(&id) else { continue };
            let x = -(column as f64) * COLUMN;
            if let Some(note) = graph.notes.get_mut(&NoteId::new(id.as_str())) {
                note.position = [x, y];
                y += note_height(note) + GAP / 2.0;
            }
            node.position = [x, y];
            let ports = library
                .nodes
                .get(&node.kind)
                .map_or(4, |def| def.visible_inputs().count() + def.outputs.len());
            y += HEIGHTS[0] + HEIGHTS[1] * ports as f64 + GAP;
        }
    }
}

/// Height of a note whose long lines are broken, in points.
fn note_height(note: &Note) -> f64 {
    let letters = (note.width / LETTER).floor().max(1.0);
    let lines = note.text.lines().map(|line| (line.chars().count() as f64 / letters).ceil());
    NOTE_HEIGHTS[0] + NOTE_HEIGHTS[1] * lines.map(|lines| lines.max(1.0)).sum::<f64>()
}

/// Number of the column of each node, from 0 for those that feed nothing.
fn columns(graph: &Graph) -> HashMap<NodeId, usize> {
    let mut feeds: HashMap<&NodeId, usize> = HashMap::new();
    let mut sources: HashMap<&NodeId, Vec<&NodeId>> = HashMap::new();
    for wire in &graph.wires {
        *feeds.entry(&wire.from.node).or_default() += 1;
        sources.entry(&wire.to.node).or_default().push(&wire.from.node);
    }
    let is_last = |id: &&NodeId| !feeds.contains_key(id);
    let mut columns: HashMap<NodeId, usize> =
        graph.nodes.keys().filter(is_last).map(|id| (id.clone(), 0)).collect();
    let mut open: VecDeque<&NodeId> = graph.nodes.keys().filter(is_last).collect();
    while let Some(id) = open.pop_front() {
        let next = columns.get(id).copied().unwrap_or_default() + 1;
        for source in sources.get(id).into_iter().flatten() {
            let column = columns.entry((*source).clone()).or_default();
            *column = next.max(*column);
            if let Some(left) = feeds.get_mut(source) {
                *left -= 1;
                if *left == 0 {
                    open.push_back(source);
                }
            }
        }
    }
    columns
}
