//! A look as a stack of layers: the chain through `below` ports from the Output's color down to a
//! node that is no layer, and the graph edits that edits of the stack stand for.
//!
//! Nodes that change the one color that goes through them, such as *Posterize*, are adjustments:
//! layers without a mode and an opacity, where they lie over layers or over a base.

pub(crate) mod mask;
pub(crate) mod normals;
pub(crate) mod owners;
pub(crate) mod tree;

use std::collections::{HashMap, HashSet};

use indexmap::IndexMap;

use crate::catalog::{Catalog, NodeKind, Port};
use crate::document::{Endpoint, Look, Wire};
use crate::ids::{NodeId, PortName};
use crate::library::Type;

/// Name of the input that makes a node a layer, and of the output that goes on.
pub(crate) const BELOW: &str = "below";
/// Kind of the node that stacks begin with.
const BASE: &str = "base";
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
    /// The node's own input of the stack below.
    input: PortName,
}

impl Layer {
    /// The layer of a node, without reroutes.
    fn of(id: NodeId, outlet: &PortName, input: PortName) -> Self {
        let end = |port: &PortName| Endpoint { node: id.clone(), port: port.clone() };
        Self { outlet: end(outlet), inlet: end(&input), input, id }
    }

    /// True for a node that changes what is below and lays nothing over it.
    pub(crate) fn is_adjustment(&self) -> bool {
        self.input.as_str() != BELOW
    }
}

/// Mark in a stack before adjustments that lie on no layer, as far as it is known.
struct StackMark<'l> {
    count: usize,
    inlet: Endpoint,
    ground: Endpoint,
    seen: Vec<&'l NodeId>,
}

/// A look as a stack of layers.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Stack {
    /// Input that the whole stack feeds; `None` where the look has no Output.
    head: Option<Endpoint>,
    output: Option<NodeId>,
    /// Layers, the uppermost first.
    pub(crate) layers: Vec<Layer>,
    /// Output that the lowest layer lies on: of a node that is no layer of this stack.
    pub(crate) ground: Option<Endpoint>,
    /// True if the ground is a part of another stack, on which the layers lie.
    is_on_other: bool,
}

impl Stack {
    /// The stack of a look, without the layers in its folders.
    pub(crate) fn of(look: &Look, catalog: &Catalog) -> Self {
        let graph = &look.graph;
        let Some((output, _)) = graph.nodes.iter().find(|(_, node)| node.kind == "output") else {
            return Self::default();
        };
        let head = Endpoint::new(output.clone(), "color");
        Self::follow(look, catalog, &feeds(look), head, &mut HashSet::from([output]))
    }

    /// The stack that feeds an input, down to a node that is no layer or that was seen before.
    fn follow<'l>(
        look: &'l Look,
        catalog: &Catalog,
        into: &HashMap<&Endpoint, &'l Wire>,
        mut at: Endpoint,
        seen: &mut HashSet<&'l NodeId>,
    ) -> Self {
        let graph = &look.graph;
        let mut stack = Self { output: Some(at.node.clone()), ..Self::default() };
        let mut mark: Option<StackMark<'l>> = None;
        loop {
            let wire = into.get(&at);
            let found =
                wire.and_then(|wire| Some((*wire, graph.nodes.get_key_value(&wire.from.node)?)));
            let kind = found.and_then(|(_, (_, node))| catalog.of(node));
            if let (Some((wire, (id, node))), Some(kind)) = (found, kind) {
                let is_new = seen.insert(id);
                stack.is_on_other = !is_new;
                let is_on_layer = is_layer(kind, wire);
                if is_on_layer || !is_new || node.kind == BASE {
                    mark = None;
                }
                if kind.is_reroute
                    && is_new
                    && let Some(input) = kind.inputs.first()
                {
                    at = Endpoint { node: id.clone(), port: input.name.clone() };
                    continue;
                }
                let input = match is_on_layer {
                    true => Some(PortName::new(BELOW)),
                    false => adjusted(kind, wire, into).map(|port| port.name.clone()),
                };
                if let Some(input) = input.filter(|_| is_new) {
                    if !is_on_layer {
                        let before = mark.get_or_insert_with(|| StackMark {
                            count: stack.layers.len(),
                            inlet: at.clone(),
                            ground: wire.from.clone(),
                            seen: Vec::new(),
                        });
                        before.seen.push(id);
                    }
                    stack.close(at);
                    let layer = Layer::of(id.clone(), &wire.from.port, input);
                    at = layer.inlet.clone();
                    stack.layers.push(layer);
                    continue;
                }
            }
            let ground = found.map(|(wire, _)| wire.from.clone());
            if let Some(before) = mark {
                for id in &before.seen {
                    seen.remove(id);
                }
                stack.layers.truncate(before.count);
                stack.close(before.inlet);
                stack.ground = Some(before.ground);
            } else {
                stack.close(at);
                stack.ground = ground;
            }
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

    /// Layer of a node.
    pub(crate) fn layer(&self, id: &NodeId) -> Option<&Layer> {
        self.layers.iter().find(|layer| layer.id == *id)
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

/// The wire into each input.
fn feeds(look: &Look) -> HashMap<&Endpoint, &Wire> {
    look.graph.wires.iter().map(|wire| (&wire.to, wire)).collect()
}

/// True if a wire comes from a layer: a node that takes a stack from below and gives it on.
fn is_layer(kind: &NodeKind, wire: &Wire) -> bool {
    let takes = kind.input(BELOW).is_some_and(|index| kind.inputs[index].is_wirable());
    let gives = kind.output(BELOW);
    takes && gives.is_some() && kind.output(wire.from.port.as_str()) == gives
}

/// The input whose color a node changes and gives on: its first color, where no other one is
/// wired.
fn adjusted<'k>(
    kind: &'k NodeKind,
    wire: &Wire,
    into: &HashMap<&Endpoint, &Wire>,
) -> Option<&'k Port> {
    let is_color = |port: &&Port| matches!(port.ty, Type::Color | Type::Composite);
    let outlet = kind.output(wire.from.port.as_str()).map(|index| &kind.outputs[index]);
    outlet.filter(is_color)?;
    let is_wired = |port: &Port| {
        let end = Endpoint { node: wire.from.node.clone(), port: port.name.clone() };
        into.contains_key(&end)
    };
    let mut colors = kind.inputs.iter().filter(is_color);
    let first = colors.next().filter(|port| is_wired(port))?;
    (!colors.any(is_wired)).then_some(first)
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::library::Library;

    pub(super) const LOOK: &str = r#"{"lights": {"key": {}}, "nodes": [
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

    pub(super) fn setup(text: &str) -> (Look, Catalog) {
        let look = Look::read(text, "test").value.unwrap();
        let mut catalog = Catalog::new(Library::built_in());
        catalog.sync(&look, Library::built_in());
        (look, catalog)
    }

    pub(super) fn order(look: &Look, catalog: &Catalog) -> Vec<String> {
        Stack::of(look, catalog).layers.iter().map(|layer| layer.id.to_string()).collect()
    }

    #[test]
    fn the_chain_is_followed_through_reroutes_down_to_the_ground() {
        let (look, catalog) = setup(LOOK);
        assert_eq!(order(&look, &catalog), ["c", "b", "a"]);
        assert_eq!(Stack::of(&look, &catalog).ground, Some(Endpoint::new("base", "")));
    }

    /// Nodes that change a whole stack are layers of it, and those that change a picture are not.
    #[test]
    fn layers_are_found_under_adjustments() {
        let with_wires = |wires: &str| {
            let nodes = r#"[{"id": "steps", "kind": "posterize"}, {"id": "inks", "kind": "palette"},
                {"id": "photo", "kind": "image"}, {"id": "both", "kind": "mix_colors"},"#;
            let text = LOOK.replacen('[', nodes, 1);
            setup(&text.replace(r#"{"from": "c", "to": "output.color"}"#, wires))
        };
        let of = |wires: &[[&str; 2]]| {
            let wire = |[from, to]: &[&str; 2]| format!(r#"{{"from": "{from}", "to": "{to}"}}"#);
            let (look, catalog) = with_wires(&wires.iter().map(wire).collect::<Vec<_>>().join(","));
            (order(&look, &catalog), Stack::of(&look, &catalog))
        };
        let over = [["inks", "output.color"], ["steps", "inks.color"]];
        let (found, stack) = of(&[over[0], over[1], ["c", "steps.color"]]);
        assert_eq!(found, ["inks", "steps", "c", "b", "a"]);
        assert_eq!(stack.ground, Some(Endpoint::new("base", "")));
        assert_eq!(stack.layers.iter().filter(|layer| layer.is_adjustment()).count(), 2);
        let (found, stack) = of(&[over[0], over[1], ["photo", "steps.color"]]);
        assert_eq!((found.len(), stack.ground), (0, Some(Endpoint::new("inks", ""))));
        assert_eq!(stack.head, Some(Endpoint::new("output", "color")));
        let (found, _) = of(&[["both", "output.color"], ["c", "both.a"], ["photo", "both.b"]]);
        assert_eq!(found, [""; 0], "two colors come together");
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
}
