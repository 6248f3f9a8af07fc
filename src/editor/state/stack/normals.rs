//! Normals of layers: those of the mesh, until a *Smooth normal* node gives calmer ones, by which
//! a shape is read on a rough scan.

use super::STEP;
use crate::catalog::NodeKind;
use crate::document::{Edit, Endpoint, Graph, GraphId, Node, Wire};
use crate::ids::{NodeId, PortName, make_slug};

/// Input of a layer that takes normals.
const NORMAL: &str = "normal";
/// Kind of the node that smooths them.
const SMOOTH: &str = "smooth_normal";
/// Distance of the node from the layer, downward, in points.
const DROP: f64 = 160.0;

/// True for a node that is drawn by the mesh's own normals, and could be by others.
pub(crate) fn are_plain(graph: &Graph, kind: &NodeKind, id: &NodeId) -> bool {
    let takes = kind.input(NORMAL).is_some_and(|index| kind.inputs[index].is_wirable());
    takes && graph.wire_into(id, &PortName::new(NORMAL)).is_none()
}

/// The edit that draws a node of a graph by smoothed normals.
pub(crate) fn smooth(graph: &Graph, of: &GraphId, id: &NodeId) -> Edit {
    let new = NodeId::new(make_slug(SMOOTH, |slug| graph.nodes.contains_key(slug)));
    let [x, y] = graph.nodes.get(id).map_or([0.0; 2], |node| node.position);
    let node = Node { kind: SMOOTH.to_owned(), position: [x - STEP, y + DROP], ..Node::default() };
    let wire = Wire { from: Endpoint::new(new.clone(), ""), to: Endpoint::new(id.clone(), NORMAL) };
    let add = Edit::AddNode { graph: of.clone(), id: new, node, index: None };
    Edit::Group { edits: vec![add, Edit::AddWire { graph: of.clone(), wire, index: None }] }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{LOOK, setup};
    use super::*;
    use crate::library::Library;

    #[test]
    fn a_layer_is_drawn_by_smoothed_normals_once() {
        let (mut look, catalog) = setup(LOOK);
        let kind = |id: &str| catalog.get(&look.graph.nodes[id].kind).unwrap();
        let (layer, blend) = (kind("a"), kind("c"));
        assert!(are_plain(&look.graph, layer, &"a".into()));
        assert!(!are_plain(&look.graph, blend, &"c".into()), "a color has no normals");
        look.apply(smooth(&look.graph, &GraphId::Look, &"a".into())).unwrap();
        assert!(!are_plain(&look.graph, layer, &"a".into()));
        assert!(crate::compile::check(&look, Library::built_in(), None).is_ok());
    }
}
