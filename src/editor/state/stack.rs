//! A look as a stack of layers: the chain through `below` ports from the Output's color down to a
//! node that is no layer, and the graph edits that edits of the stack stand for.

pub(crate) mod mask;

use std::collections::{HashMap, HashSet};

use indexmap::IndexMap;

use crate::catalog::{Catalog, NodeKind};
use crate::document::{Edit, Endpoint, GraphId, Look, Node, Wire};
use crate::ids::{NodeId, make_slug};

/// Name of the input that makes a node a layer, and of the output that goes on.
pub(crate) const BELOW: &str = "below";
/// Distance from one layer to the next on the canvas, in points.
const STEP: f64 = 260.0;

/// Layer of a stack.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Layer {
    /// Node of the layer.
    pub(crate) id: NodeId,
    /// Output of the node that goes on upward.
    outlet: Endpoint,
    /// Input that takes the stack below: the node's own, or that of a reroute before it.
    inlet: Endpoint,
}

/// A look as a stack of layers.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Stack {
    /// Input that the whole stack feeds; `None` where the look has no Output.
    head: Option<Endpoint>,
    output: Option<NodeId>,
    /// Layers, the uppermost first.
    pub(crate) layers: Vec<Layer>,
    /// Output that the lowest layer lies on: of a node that is no layer.
    pub(crate) ground: Option<Endpoint>,
}

impl Stack {
    /// The stack of a look.
    pub(crate) fn of(look: &Look, catalog: &Catalog) -> Self {
        let graph = &look.graph;
        let Some((output, _)) = graph.nodes.iter().find(|(_, node)| node.kind == "output") else {
            return Self::default();
        };
        let into: HashMap<&Endpoint, &Wire> =
            graph.wires.iter().map(|wire| (&wire.to, wire)).collect();
        let mut stack = Self { output: Some(output.clone()), ..Self::default() };
        let mut at = Endpoint::new(output.clone(), "color");
        let mut seen = HashSet::from([output]);
        loop {
            let wire = into.get(&at);
            let found =
                wire.and_then(|wire| Some((*wire, graph.nodes.get_key_value(&wire.from.node)?)));
            let kind = found.and_then(|(_, (_, node))| catalog.of(node));
            if let (Some((wire, (id, _))), Some(kind)) = (found, kind) {
                let is_new = seen.insert(id);
                if kind.is_reroute
                    && is_new
                    && let Some(input) = kind.inputs.first()
                {
                    at = Endpoint { node: id.clone(), port: input.name.clone() };
                    continue;
                }
                if is_new && is_layer(kind, wire) {
                    stack.close(at);
                    at = Endpoint::new(id.clone(), BELOW);
                    stack.layers.push(Layer {
                        id: id.clone(),
                        outlet: wire.from.clone(),
                        inlet: at.clone(),
                    });
                    continue;
                }
            }
            stack.close(at);
            stack.ground = found.map(|(wire, _)| wire.from.clone());
            return stack;
        }
    }

    /// Notes the input that takes the next source from below.
    fn close(&mut self, inlet: Endpoint) {
        match self.layers.last_mut() {
            Some(layer) => layer.inlet = inlet,
            None => self.head = Some(inlet),
        }
    }

    /// Index of a node among the layers.
    pub(crate) fn index_of(&self, id: &NodeId) -> Option<usize> {
        self.layers.iter().position(|layer| layer.id == *id)
    }

    /// True if there is an Output that a stack can feed.
    pub(crate) fn has_output(&self) -> bool {
        self.head.is_some()
    }

    /// The lowest input of the stack, which nothing feeds where there is no ground.
    pub(crate) fn lowest_inlet(&self) -> Option<&Endpoint> {
        self.layers.last().map(|layer| &layer.inlet).or(self.head.as_ref())
    }

    /// Moves a layer to another index among the others, and nodes so that they lie in the new
    /// order.
    pub(crate) fn reorder(&self, look: &Look, from: usize, to: usize) -> Option<Edit> {
        if from == to || from >= self.layers.len() || to >= self.layers.len() {
            return None;
        }
        let mut order = self.layers.clone();
        let layer = order.remove(from);
        order.insert(to, layer);
        let mut positions = IndexMap::new();
        for (new, old) in order.iter().zip(&self.layers).filter(|(new, old)| new.id != old.id) {
            let place =
                |id: &NodeId| look.graph.nodes.get(id).map_or([0.0; 2], |node| node.position);
            let (from, to) = (place(&new.id), place(&old.id));
            self.carry(look, &new.id, [to[0] - from[0], to[1] - from[1]], &mut positions);
        }
        // The layer itself comes first: undo names the step by it.
        let own = positions
            .shift_remove(&self.layers[from].id)
            .map(|place| (self.layers[from].id.clone(), place));
        let mut edits = vec![
            Edit::MoveNodes { graph: GraphId::Look, positions: own.into_iter().collect() },
            Edit::MoveNodes { graph: GraphId::Look, positions },
        ];
        edits.extend(self.rewire(look, &order));
        Some(Edit::Group { edits })
    }

    /// Takes layers out of the stack.
    pub(crate) fn remove(&self, look: &Look, ids: &[NodeId]) -> Edit {
        let order: Vec<Layer> =
            self.layers.iter().filter(|layer| !ids.contains(&layer.id)).cloned().collect();
        let removed = self.layers.iter().filter(|layer| ids.contains(&layer.id));
        let mut edits: Vec<Edit> = removed
            .map(|layer| Edit::RemoveNode { graph: GraphId::Look, id: layer.id.clone() })
            .collect();
        edits.extend(self.rewire(look, &order));
        Edit::Group { edits }
    }

    /// Inserts a new node as the layer number `at`, and makes room for it. Sets the node's
    /// position.
    pub(crate) fn insert(&self, look: &Look, at: usize, id: &NodeId, mut node: Node) -> Vec<Edit> {
        let at = at.min(self.layers.len());
        let place = |id: &NodeId| look.graph.nodes.get(id).map(|node| node.position);
        let under = self
            .layers
            .get(at)
            .map(|layer| &layer.id)
            .or(self.ground.as_ref().map(|ground| &ground.node));
        let over = at.checked_sub(1).map(|above| &self.layers[above].id).or(self.output.as_ref());
        let over_place = over.and_then(place).unwrap_or_default();
        node.position = under
            .and_then(place)
            .map_or([over_place[0] - STEP, over_place[1]], |[x, y]| [x + STEP, y]);
        let mut positions = IndexMap::new();
        let lack = node.position[0] + STEP - over_place[0];
        if lack > 0.0 {
            let above = self.layers[..at].iter().map(|layer| &layer.id).chain(&self.output);
            above.for_each(|id| self.carry(look, id, [lack, 0.0], &mut positions));
        }
        let mut order = self.layers.clone();
        let inlet = Endpoint::new(id.clone(), BELOW);
        order.insert(at, Layer { id: id.clone(), outlet: Endpoint::new(id.clone(), BELOW), inlet });
        let mut edits =
            vec![Edit::AddNode { graph: GraphId::Look, id: id.clone(), node, index: None }];
        if !positions.is_empty() {
            edits.push(Edit::MoveNodes { graph: GraphId::Look, positions });
        }
        edits.extend(self.rewire(look, &order));
        edits
    }

    /// Puts a copy of a layer over it, fed by the same wires. Returns the copy's id.
    pub(crate) fn duplicate(&self, look: &Look, index: usize) -> Option<(NodeId, Edit)> {
        let layer = self.layers.get(index)?;
        let node = look.graph.nodes.get(&layer.id)?.clone();
        let base =
            layer.id.as_str().trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches('_');
        let base = if base.is_empty() { layer.id.as_str() } else { base };
        let id = NodeId::new(make_slug(base, |slug| look.graph.nodes.contains_key(slug)));
        let mut edits = self.insert(look, index, &id, node);
        let into = look
            .graph
            .wires
            .iter()
            .filter(|wire| wire.to.node == layer.id && wire.to.port.as_str() != BELOW);
        edits.extend(into.map(|wire| {
            let to = Endpoint { node: id.clone(), port: wire.to.port.clone() };
            Edit::AddWire {
                graph: GraphId::Look,
                wire: Wire { from: wire.from.clone(), to },
                index: None,
            }
        }));
        Some((id, Edit::Group { edits }))
    }

    /// The edits that wire layers in a new order, each with the reroutes below it.
    fn rewire(&self, look: &Look, order: &[Layer]) -> Vec<Edit> {
        let into: HashMap<&Endpoint, &Wire> =
            look.graph.wires.iter().map(|wire| (&wire.to, wire)).collect();
        let inlets = self.head.iter().chain(order.iter().map(|layer| &layer.inlet));
        let sources = order.iter().map(|layer| Some(&layer.outlet)).chain([self.ground.as_ref()]);
        let mut edits = Vec::new();
        for (to, from) in inlets.zip(sources) {
            let old = into.get(to).copied();
            match from {
                Some(from) if old.is_none_or(|old| old.from != *from) => {
                    let wire = Wire { from: from.clone(), to: to.clone() };
                    edits.push(Edit::AddWire { graph: GraphId::Look, wire, index: None });
                }
                // The wire of a removed layer goes with its node.
                None if old
                    .is_some_and(|old| order.iter().any(|layer| layer.outlet == old.from)) =>
                {
                    edits.extend(
                        old.map(|wire| Edit::RemoveWire {
                            graph: GraphId::Look,
                            wire: wire.clone(),
                        }),
                    );
                }
                _ => {}
            }
        }
        edits
    }

    /// Moves a node and the nodes that feed nothing else.
    fn carry(
        &self,
        look: &Look,
        id: &NodeId,
        by: [f64; 2],
        positions: &mut IndexMap<NodeId, [f64; 2]>,
    ) {
        for id in self.with_own(look, id) {
            if let Some(node) = look.graph.nodes.get(&id) {
                positions.insert(id, [node.position[0] + by[0], node.position[1] + by[1]]);
            }
        }
    }

    /// A node and the nodes that feed it and nothing else, the other layers aside.
    fn with_own(&self, look: &Look, id: &NodeId) -> Vec<NodeId> {
        let chain: HashSet<&NodeId> = self
            .layers
            .iter()
            .map(|layer| &layer.id)
            .chain(self.ground.iter().map(|ground| &ground.node))
            .collect();
        let mut own = vec![id.clone()];
        let mut next = 0;
        while next < own.len() {
            let sources = look
                .graph
                .wires
                .iter()
                .filter(|wire| wire.to.node == own[next])
                .map(|wire| &wire.from.node);
            let mut found = Vec::new();
            for source in sources.filter(|source| !chain.contains(source)) {
                let mut users = look.graph.wires.iter().filter(|wire| wire.from.node == *source);
                if !own.contains(source)
                    && !found.contains(source)
                    && users.all(|wire| own.contains(&wire.to.node))
                {
                    found.push(source.clone());
                }
            }
            own.extend(found);
            next += 1;
        }
        own
    }
}

/// True if a wire comes from a layer: a node that takes a stack from below and gives it on.
fn is_layer(kind: &NodeKind, wire: &Wire) -> bool {
    let takes = kind.input(BELOW).is_some_and(|index| kind.inputs[index].is_wirable());
    let gives = kind.output(BELOW);
    takes && gives.is_some() && kind.output(wire.from.port.as_str()) == gives
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::Library;

    const LOOK: &str = r#"{"lights": {"key": {}}, "nodes": [
        {"id": "base", "kind": "base"},
        {"id": "a", "kind": "light_layer", "at": [260, 0]},
        {"id": "dot", "kind": "reroute", "at": [400, 0]},
        {"id": "tint", "kind": "color_value", "at": [300, 300]},
        {"id": "b", "kind": "light_layer", "at": [520, 40]},
        {"id": "c", "kind": "blend", "at": [780, 0]},
        {"id": "output", "kind": "output", "at": [1040, 0]}
      ], "wires": [{"from": "base", "to": "a.below"}, {"from": "a.below", "to": "dot.value"},
      {"from": "dot", "to": "b.below"},
        {"from": "tint", "to": "b.convex"}, {"from": "b", "to": "c.below"},
        {"from": "c", "to": "output.color"}]}"#;

    fn setup(text: &str) -> (Look, Catalog) {
        let look = Look::read(text, "test").value.unwrap();
        let mut catalog = Catalog::new(Library::built_in());
        catalog.sync(&look, Library::built_in());
        (look, catalog)
    }

    fn order(look: &Look, catalog: &Catalog) -> Vec<String> {
        Stack::of(look, catalog).layers.iter().map(|layer| layer.id.to_string()).collect()
    }

    #[test]
    fn the_chain_is_followed_through_reroutes_down_to_the_ground() {
        let (look, catalog) = setup(LOOK);
        assert_eq!(order(&look, &catalog), ["c", "b", "a"]);
        assert_eq!(Stack::of(&look, &catalog).ground, Some(Endpoint::new("base", "")));
    }

    #[test]
    fn a_ring_ends_and_a_look_without_output_has_no_stack() {
        let ring =
            LOOK.replace(r#""from": "base", "to": "a.below""#, r#""from": "c", "to": "a.below""#);
        let (look, catalog) = setup(&ring);
        assert_eq!(order(&look, &catalog), ["c", "b", "a"]);
        let (look, catalog) = setup("{}");
        assert!(!Stack::of(&look, &catalog).has_output());
    }

    /// Every move of every layer gives the order of a list after the same move, keeps the same
    /// positions in use, and is undone.
    #[test]
    fn every_move_is_that_of_a_list() {
        for from in 0..3 {
            for to in 0..3 {
                let (mut look, catalog) = setup(LOOK);
                let stack = Stack::of(&look, &catalog);
                let mut expected = order(&look, &catalog);
                let places = |look: &Look| {
                    let of = |id: &&str| look.graph.nodes[*id].position.map(|x| x as i64);
                    let mut places: Vec<_> = ["a", "b", "c"].iter().map(of).collect();
                    places.sort_unstable();
                    places
                };
                let (before, old_places) = (look.clone(), places(&look));
                let Some(edit) = stack.reorder(&look, from, to) else {
                    assert_eq!(from, to);
                    continue;
                };
                let inverse = look.apply(edit).unwrap();
                let moved = expected.remove(from);
                expected.insert(to, moved);
                assert_eq!(order(&look, &catalog), expected, "{from} to {to}");
                assert_eq!(places(&look), old_places);
                let offset = |look: &Look| {
                    look.graph.nodes["tint"].position[0] - look.graph.nodes["b"].position[0]
                };
                assert_eq!(offset(&look), offset(&before), "what feeds a layer alone goes with it");
                look.apply(inverse).unwrap();
                assert_eq!(look, before);
            }
        }
    }

    #[test]
    fn layers_are_put_in_and_taken_out_anywhere() {
        for at in 0..4 {
            let (mut look, catalog) = setup(LOOK);
            let stack = Stack::of(&look, &catalog);
            let node = Node { kind: "light_layer".to_owned(), ..Node::default() };
            let edits = stack.insert(&look, at, &"new".into(), node);
            look.apply(Edit::Group { edits }).unwrap();
            let mut expected = vec!["c", "b", "a"];
            expected.insert(at, "new");
            assert_eq!(order(&look, &catalog), expected);
            let stack = Stack::of(&look, &catalog);
            let xs: Vec<f64> =
                stack.layers.iter().map(|layer| look.graph.nodes[&layer.id].position[0]).collect();
            assert!(xs.windows(2).all(|pair| pair[0] - pair[1] >= STEP), "room for each: {xs:?}");
            look.apply(stack.remove(&look, &["new".into(), "b".into()])).unwrap();
            assert_eq!(order(&look, &catalog), ["c", "a"]);
            assert!(Stack::of(&look, &catalog).ground.is_some());
        }
    }

    #[test]
    fn a_copy_lies_over_its_original_and_is_fed_by_the_same() {
        let (mut look, catalog) = setup(LOOK);
        let stack = Stack::of(&look, &catalog);
        let (id, edit) = stack.duplicate(&look, 1).unwrap();
        look.apply(edit).unwrap();
        assert_eq!(order(&look, &catalog), ["c", id.as_str(), "b", "a"]);
        assert!(look.graph.wire_into(&id, &"convex".into()).is_some());
    }
}
