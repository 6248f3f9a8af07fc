//! Lights that nodes of a look are about: those that they name, and those that come by their wires.

use std::collections::BTreeSet;

use super::LightReading;
use crate::document::{Definition, Graph, Look, Node, Value};
use crate::ids::{GROUP_INPUTS, GROUP_OUTPUTS, LightId, NodeId, NodePath, PortName};
use crate::library::{Library, NodeDef, Type};
use crate::probe::WireValue;

/// Largest number of wires that are followed from one node: longer chains tell of no light.
const MOST_WIRES: usize = 64;

/// A look with the library that its nodes are of.
pub(super) struct LightNames<'a> {
    pub(super) look: &'a Look,
    pub(super) library: &'a Library,
}

/// Input of a node inside groups.
struct PlacedInput<'p> {
    groups: &'p [NodeId],
    node: &'p NodeId,
    port: &'p PortName,
}

impl<'a> LightNames<'a> {
    /// Values of single numbers that nodes computed about a light alone.
    pub(super) fn readings(&self, light: &LightId, wires: &[WireValue]) -> Vec<LightReading> {
        let mut readings: Vec<LightReading> = Vec::new();
        for wire in wires {
            let [value] = wire.double[..] else { continue };
            let Some((label, lights)) = self.about(&wire.node) else { continue };
            if lights.len() == 1 && lights.contains(light) {
                let reading = LightReading { node: wire.node.clone(), label, value };
                // A function that is called again has the same values.
                if !readings.contains(&reading) {
                    readings.push(reading);
                }
            }
        }
        readings
    }

    /// Label of a node's output, and the lights that the node is about; `None` for nodes that are
    /// about none, or that run once for each of a set.
    fn about(&self, path: &NodePath) -> Option<(String, BTreeSet<LightId>)> {
        let (id, groups) = path.ids().split_last()?;
        let (_, node) = self.node(groups, id)?;
        let def = self.library.nodes.get(node.kind.as_str())?;
        let output = def.outputs.first()?;
        let lights = self.lights_of(groups, id, def, MOST_WIRES)?;
        Some((output.label.clone(), lights)).filter(|(_, lights)| !lights.is_empty())
    }

    /// Lights that the inputs of a node name or bring.
    fn lights_of(
        &self,
        groups: &[NodeId],
        id: &NodeId,
        def: &NodeDef,
        left: usize,
    ) -> Option<BTreeSet<LightId>> {
        let mut lights = BTreeSet::new();
        for input in &def.inputs {
            let place = PlacedInput { groups, node: id, port: &input.name };
            match input.ty {
                Type::LightName => lights.extend([self.named(&place)?]),
                Type::Light | Type::Angle => lights.append(&mut self.brought(&place, left)?),
                _ => {}
            }
        }
        Some(lights)
    }

    /// Light that an input names, through the inputs of the groups around it.
    fn named(&self, PlacedInput { groups, node, port }: &PlacedInput<'_>) -> Option<LightId> {
        let (graph, own) = self.node(groups, node)?;
        if let Some(wire) = graph.wire_into(node, port) {
            let (group, outer) = groups.split_last()?;
            let is_led_in = wire.from.node.as_str() == GROUP_INPUTS;
            let inner = PlacedInput { groups: outer, node: group, port: &wire.from.port };
            return is_led_in.then(|| self.named(&inner)).flatten();
        }
        match own.values.get(*port) {
            Some(Value::Text(id)) if !id.is_empty() => Some(LightId::new(id.as_str())),
            _ => self.look.lights.first().map(|(id, _)| id.clone()),
        }
    }

    /// Lights that come by the wire of an input.
    fn brought(
        &self,
        PlacedInput { groups, node, port }: &PlacedInput<'_>,
        left: usize,
    ) -> Option<BTreeSet<LightId>> {
        let left = left.checked_sub(1)?;
        let (graph, _) = self.node(groups, node)?;
        let Some(wire) = graph.wire_into(node, port) else { return Some(BTreeSet::new()) };
        self.source(groups, graph, &wire.from.node, &wire.from.port, left)
    }

    /// Lights of the node that a wire comes from.
    fn source(
        &self,
        groups: &[NodeId],
        graph: &Graph,
        from: &NodeId,
        port: &PortName,
        left: usize,
    ) -> Option<BTreeSet<LightId>> {
        if from.as_str() == GROUP_INPUTS {
            let (group, outer) = groups.split_last()?;
            return self.brought(&PlacedInput { groups: outer, node: group, port }, left);
        }
        let node = graph.nodes.get(from)?;
        if let Some(def) = self.library.nodes.get(node.kind.as_str()) {
            return self.lights_of(groups, from, def, left);
        }
        let definition = self.definition(node).filter(|_| node.for_each.is_none())?;
        let inner: Vec<NodeId> = groups.iter().chain([from]).cloned().collect();
        let wire = definition.graph.wire_into(&NodeId::from(GROUP_OUTPUTS), port)?;
        let left = left.checked_sub(1)?;
        self.source(&inner, &definition.graph, &wire.from.node, &wire.from.port, left)
    }

    /// The node at the end of a path, and its graph. `None` inside groups that run once for each
    /// light of a set: which light a value is of cannot be told there.
    fn node(&self, groups: &[NodeId], id: &NodeId) -> Option<(&'a Graph, &'a Node)> {
        let mut graph = &self.look.graph;
        for group in groups {
            let node = graph.nodes.get(group).filter(|node| node.for_each.is_none())?;
            graph = &self.definition(node)?.graph;
        }
        Some((graph, graph.nodes.get(id)?))
    }

    fn definition(&self, node: &Node) -> Option<&'a Definition> {
        let of_library = || self.library.groups.get(node.kind.as_str()).map(|it| &it.definition);
        self.look.definitions.get(node.kind.as_str()).or_else(of_library)
    }
}
