//! Places of imported nodes on the canvas: columns by the way to the output.

use std::collections::{HashMap, VecDeque};

use crate::document::Graph;
use crate::ids::NodeId;
use crate::library::Library;

/// Width of a column, in points.
const COLUMN: f64 = 250.0;

/// Gap below a node, in points.
const GAP: f64 = 28.0;

/// Height of a node without ports, and of a port's row, in points.
const HEIGHTS: [f64; 2] = [44.0, 24.0];

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
            node.position = [-(column as f64) * COLUMN, y];
            let ports = library
                .nodes
                .get(&node.kind)
                .map_or(4, |def| def.visible_inputs().count() + def.outputs.len());
            y += HEIGHTS[0] + HEIGHTS[1] * ports as f64 + GAP;
        }
    }
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
