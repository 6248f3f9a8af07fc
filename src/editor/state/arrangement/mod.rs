//! Places of nodes that have none: looks that programs write say nothing of the canvas, and all
//! nodes would lie on one another there.
//!
//! A file does not tell a node at the origin from one without a place, as the origin is left out.
//! Two nodes there have none, for nobody puts one node exactly on another, and so has a single one
//! that would cover others. The document that is open has the places from the beginning, so that
//! everything which moves nodes finds them as they are seen; opening is no change, and the file
//! has them once it is saved.

mod layers;

use std::sync::Arc;

use crate::catalog::{Catalog, NodeKind};
use crate::document::{Graph, Look, Node, Note, Wire};
use crate::drawing::{NODE_WIDTH, NOTE_PADDING, TEXT_SIZE, TITLE_HEIGHT, node_height, row_center};
use crate::ids::{NodeId, PortName};
use crate::library::Library;
pub(crate) use layers::{Link, NodeBox, layers};

/// Gap between the nodes that have places and those that are put beside them, in points: frames
/// around both of them fit in.
const BESIDE: f32 = 96.0;
/// Height of a note's line, and width of a letter, in sizes of the text, not to be too small.
const LINE: f32 = 1.5;
const LETTER: f32 = 0.6;

/// Places the nodes of a look that have no place, also those within the look's groups: as
/// *Arrange* lays them out, and beside the nodes that have places. Returns true if there were any.
pub(crate) fn place_nodes(look: &mut Look, library: &Library) -> bool {
    let groups = look.definitions.values().map(|definition| &definition.graph);
    if !std::iter::once(&look.graph).chain(groups).any(may_lack_places) {
        return false;
    }
    let mut catalog = Catalog::new(library);
    catalog.sync(look, library);
    place_nodes_of(look, &catalog)
}

/// Places the nodes of a look as [`place_nodes`] does, by a catalog that knows the look's groups.
pub(crate) fn place_nodes_of(look: &mut Look, catalog: &Catalog) -> bool {
    let mut is_changed = place_in(&mut look.graph, catalog);
    for definition in look.definitions.values_mut() {
        is_changed |= place_in(&mut definition.graph, catalog);
    }
    is_changed
}

/// Places the nodes in groups of a library that have no place.
pub(crate) fn place_in_groups(library: &mut Library) {
    if !library.groups.values().any(|group| may_lack_places(&group.definition.graph)) {
        return;
    }
    let mut catalog = Catalog::new(library);
    catalog.sync(&Look::default(), library);
    for group in library.groups.values_mut() {
        let mut graph = group.definition.graph.clone();
        if place_in(&mut graph, &catalog) {
            Arc::make_mut(group).definition.graph = graph;
        }
    }
}

fn is_at_origin(node: &Node) -> bool {
    node.position == [0.0; 2]
}

/// True if nodes of a graph may have no places: told without their kinds, which take longer.
fn may_lack_places(graph: &Graph) -> bool {
    let near = |node: &&Node| node.position[0].abs() < f64::from(NODE_WIDTH);
    graph.nodes.values().any(is_at_origin) && graph.nodes.values().filter(near).nth(1).is_some()
}

/// Places the nodes of a graph that have no place. Returns true if there were any.
fn place_in(graph: &mut Graph, catalog: &Catalog) -> bool {
    if !may_lack_places(graph) {
        return false;
    }
    let kinds = kinds(graph, catalog);
    let boxes: Vec<NodeBox> = graph
        .nodes
        .values()
        .zip(&kinds)
        .map(|(node, kind)| box_of(node, kind.as_deref()))
        .collect();
    let lacking = lacking(graph, &boxes);
    if lacking.is_empty() {
        return false;
    }
    let own: Vec<NodeBox> = lacking.iter().map(|&index| boxes[index]).collect();
    let mut places = layers(&own, &links(graph, &kinds, &lacking));

    let others = (0..boxes.len()).filter(|index| !lacking.contains(index));
    let others =
        others.map(|index| boxes[index]).chain(graph.notes.values().filter_map(box_of_note));
    if let Some(others) = NodeBox::around(others) {
        let laid = places.iter().zip(&own).map(|(&min, one)| NodeBox { min, ..*one });
        let corner = NodeBox::around(laid).map_or([0.0; 2], |all| all.min);
        let by = [others.min[0] - corner[0], others.max(1) + BESIDE - corner[1]];
        for place in &mut places {
            *place = [0, 1].map(|axis| (place[axis] + by[axis]).round());
        }
    }
    for (index, place) in lacking.into_iter().zip(places) {
        graph.nodes[index].position = place.map(f64::from);
    }
    true
}

/// Kinds of a graph's nodes, in order.
fn kinds(graph: &Graph, catalog: &Catalog) -> Vec<Option<Arc<NodeKind>>> {
    let missing = catalog.missing_in(graph);
    let kind = |(id, node): (&NodeId, &Node)| missing.get(id).or_else(|| catalog.of(node)).cloned();
    graph.nodes.iter().map(kind).collect()
}

/// Box of a node of a kind, where its graph has it.
pub(crate) fn box_of(node: &Node, kind: Option<&NodeKind>) -> NodeBox {
    let rows = kind.map_or(0, |kind| kind.inputs.len() + kind.outputs.len());
    let height = if node.collapsed { TITLE_HEIGHT } else { node_height(rows) };
    // A position may be any finite number.
    let min = node.position.map(|x| (x as f32).clamp(-1e7, 1e7));
    NodeBox { min, size: [NODE_WIDTH, height] }
}

/// Box of a note with a place; its height is a guess, as fonts decide.
fn box_of_note(note: &Note) -> Option<NodeBox> {
    let min = note.position.map(|x| (x as f32).clamp(-1e7, 1e7));
    let width = note.width as f32;
    let letters = ((width - 2.0 * NOTE_PADDING) / (LETTER * TEXT_SIZE)).floor().max(1.0);
    let lines = note.text.lines().map(|line| (line.chars().count() as f32 / letters).ceil());
    let lines: f32 = lines.map(|lines| lines.max(1.0)).sum();
    let size = [width, 2.0 * NOTE_PADDING + LINE * TEXT_SIZE * lines.max(1.0)];
    (note.position != [0.0; 2]).then_some(NodeBox { min, size })
}

/// Nodes that have no place, by index.
fn lacking(graph: &Graph, boxes: &[NodeBox]) -> Vec<usize> {
    let at_origin = graph.nodes.values().enumerate().filter(|(_, node)| is_at_origin(node));
    let found: Vec<usize> = at_origin.map(|(index, _)| index).collect();
    if let [one] = *found {
        let mut others = boxes.iter().enumerate().filter(|(index, _)| *index != one);
        if !others.any(|(_, other)| boxes[one].overlaps(other)) {
            return Vec::new();
        }
    }
    found
}

/// Wires between nodes, by their places in `chosen`.
fn links(graph: &Graph, kinds: &[Option<Arc<NodeKind>>], chosen: &[usize]) -> Vec<Link> {
    let mut own = vec![None; kinds.len()];
    chosen.iter().enumerate().for_each(|(place, &index)| own[index] = Some(place));
    let row = |index: usize, port: &PortName, is_output: bool| {
        let kind = kinds[index].as_deref()?;
        let row = match is_output {
            true => kind.output(port.as_str())?,
            false => kind.outputs.len() + kind.input(port.as_str())?,
        };
        Some(if graph.nodes[index].collapsed { TITLE_HEIGHT / 2.0 } else { row_center(row) })
    };
    let link = |wire: &Wire| {
        let [from, to] =
            [&wire.from, &wire.to].map(|end| graph.nodes.get_index_of(end.node.as_str()));
        let (from, to) = (from?, to?);
        let (from_y, to_y) = (row(from, &wire.from.port, true)?, row(to, &wire.to.port, false)?);
        Some(Link { from: own[from]?, to: own[to]?, from_y, to_y })
    };
    graph.wires.iter().filter_map(link).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::overlapping;

    const PLAIN: &str = r#"{
        "nodes": [{"id": "tint", "kind": "group"}, {"id": "base", "kind": "base"},
            {"id": "over", "kind": "blend"}, {"id": "end", "kind": "output"}],
        "wires": [{"from": "base", "to": "over.below"}, {"from": "over", "to": "end.color"}],
        "definitions": {"group": {"inputs": [{"name": "x"}], "outputs": [{"name": "y"}],
            "nodes": [{"id": "a", "kind": "base"}, {"id": "b", "kind": "blend"}],
            "wires": [{"from": "a", "to": "b.below"}, {"from": "b", "to": "outputs.y"}]}}
    }"#;

    fn read(text: &str) -> Look {
        Look::read(text, "test").value.unwrap()
    }

    fn assert_apart(look: &Look) {
        let mut catalog = Catalog::new(Library::built_in());
        catalog.sync(look, Library::built_in());
        let groups = look.definitions.values().map(|definition| &definition.graph);
        for graph in std::iter::once(&look.graph).chain(groups) {
            let found = overlapping(graph, &catalog);
            assert!(found.is_empty(), "{found:?}");
        }
    }

    #[test]
    fn nodes_without_places_are_laid_out_from_left_to_right() {
        let mut look = read(PLAIN);
        assert!(place_nodes(&mut look, Library::built_in()));
        assert_apart(&look);
        let x = |id: &str| look.graph.nodes[id].position[0];
        assert!(x("base") < x("over") && x("over") < x("end"), "{:?}", look.graph.nodes);
        let inner = &look.definitions["group"].graph.nodes;
        assert!(inner["a"].position[0] < inner["b"].position[0], "{inner:?}");
        // The places are there now, and stay.
        let placed = look.clone();
        place_nodes(&mut look, Library::built_in());
        assert_eq!(look, placed);
    }

    #[test]
    fn places_that_are_there_stay_and_the_rest_is_put_beside() {
        let mut look = read(PLAIN);
        look.graph.nodes["end"].position = [40.0, 30.0];
        look.graph.nodes["tint"].position = [-400.0, 10.0];
        assert!(place_nodes(&mut look, Library::built_in()));
        assert_eq!(look.graph.nodes["end"].position, [40.0, 30.0]);
        assert_eq!(look.graph.nodes["tint"].position, [-400.0, 10.0]);
        assert_apart(&look);
        assert_eq!(look.graph.nodes["base"].position[0], -400.0, "they begin where the others do");
        assert_ne!(look.graph.nodes["base"].position, look.graph.nodes["over"].position);
    }

    #[test]
    fn a_single_node_at_the_origin_has_its_place_there() {
        let text = |x: i32| {
            format!(
                r#"{{"nodes": [{{"id": "base", "kind": "base"}},
                    {{"id": "end", "kind": "output", "at": [{x}, 0]}}]}}"#
            )
        };
        let mut look = read(&text(400));
        assert!(!place_nodes(&mut look, Library::built_in()));
        assert_eq!(look, read(&text(400)));
        let mut look = read(&text(60));
        assert!(place_nodes(&mut look, Library::built_in()), "it would be covered");
        assert_eq!(look.graph.nodes["end"].position, [60.0, 0.0]);
        assert_apart(&look);
    }

    #[test]
    fn groups_of_a_project_are_laid_out_too() {
        let mut library = Library::built_in().clone();
        let shipped = library.groups.clone();
        library.add_groups("nodes/group.json", PLAIN);
        place_in_groups(&mut library);
        let inner = &library.groups["group"].definition.graph.nodes;
        assert!(inner["a"].position[0] < inner["b"].position[0], "{inner:?}");
        for (id, group) in shipped {
            assert!(Arc::ptr_eq(&library.groups[&id], &group), "{id} has places of its own");
        }
    }
}
