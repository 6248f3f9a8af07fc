//! Construction of an ordinary look of light layers over a base.

use glam::DVec3;

use super::lit::{LayerLight, LightingModel};
use super::stack::FitLayer;
use crate::document::{Endpoint, Graph, Light, Look, Node, Value, Values, Wire};
use crate::ids::{LightId, NodeId};

/// Distance from node to node on the canvas, in points.
pub(super) const APART: f64 = 260.0;

/// A look with the layers `layers`, each with a light of its own; `colors` are those of the base
/// and of the layers from the bottom up.
pub(super) fn layered(name: &str, layers: &[FitLayer], colors: &[[f64; 3]]) -> Look {
    let mut look = Look { name: name.to_owned(), ..Look::default() };
    let color =
        |index: usize| Value::Vector(colors.get(index).copied().unwrap_or_default().to_vec());
    let base = Values::from_iter([("color".into(), color(0))]);
    add(&mut look.graph, "base", "base", "Base", base);
    let mut below = "base".to_owned();
    for (index, layer) in layers.iter().enumerate() {
        let light = format!("light-{}", index + 1);
        let direction = layer.lit.direction.normalize_or(DVec3::Z).to_array();
        look.lights.insert(LightId::new(light.as_str()), Light { direction, ..Light::default() });
        let own = colors.get(index + 1).copied().unwrap_or_default();
        let values = values_of(&layer.lit, &light, own, layer.mode.word());
        let id = format!("layer-{}", index + 1);
        let names = look.graph.nodes.values().map(|node| node.name.as_str());
        let name = name_of(layer.lit.kind, names);
        add(&mut look.graph, &id, "light_layer", &name, values);
        wire(&mut look.graph, &below, "below", &id, "below");
        below = id;
    }
    add(&mut look.graph, "output", "output", "", Values::new());
    wire(&mut look.graph, &below, "below", "output", "color");
    look
}

fn add(graph: &mut Graph, id: &str, kind: &str, name: &str, values: Values) {
    let position = [APART * graph.nodes.len() as f64, 0.0];
    let node =
        Node { kind: kind.to_owned(), name: name.to_owned(), position, values, ..Node::default() };
    graph.nodes.insert(NodeId::new(id), node);
}

fn wire(graph: &mut Graph, from: &str, output: &str, to: &str, input: &str) {
    graph.wires.push(Wire { from: Endpoint::new(from, output), to: Endpoint::new(to, input) });
}

/// Values of a light layer: its light, profile, color and mode.
pub(super) fn values_of(lit: &LayerLight, light: &str, color: [f64; 3], mode: &str) -> Values {
    let word = |word: &str| Value::Text(word.to_owned());
    let [offset, falloff, cutoff] = lit.shape.ends().map(Value::Number);
    let values = [
        ("light", word(light)),
        ("type", word(lit.kind.word())),
        ("offset", offset),
        ("falloff", falloff),
        ("cutoff", cutoff),
        ("convex", Value::Vector(color.to_vec())),
        // The color does not depend on the shape: what was painted says nothing of curvature.
        ("slope", Value::Number(0.0)),
        ("blend", word(mode)),
    ];
    values.into_iter().map(|(port, value)| (port.into(), value)).collect()
}

/// Name of a layer: its kind, numbered if others have that name already.
pub(super) fn name_of<'n>(kind: LightingModel, names: impl Iterator<Item = &'n str>) -> String {
    let word = match kind {
        LightingModel::Diffuse => "Painted light",
        LightingModel::Specular => "Painted highlight",
    };
    let number = 1 + names.filter(|name| name.starts_with(word)).count();
    if number > 1 { format!("{word} {number}") } else { word.to_owned() }
}
