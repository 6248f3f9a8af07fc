//! Layers to begin with: what painters and shaders know by name, in the values of the Profile node's own presets where it
//! has them, and else of the BADF paper's looks.

use super::super::super::catalog::Catalog;
use super::super::super::session::Session;
use crate::document::{Edit, Light, Look, Node, Value};
use crate::ids::{LightId, NodeId, make_slug};

/// Which of the look's lights a layer is made for.
#[derive(Clone, Copy, PartialEq)]
enum From {
    /// That of the selected layer, or else the first one in front.
    Front,
    /// The first one behind the object; where there is none, it is added.
    Behind,
}

enum Set {
    Number(f64),
    Word(&'static str),
}

/// A layer to begin with.
pub(super) struct LayerPreset {
    pub(super) label: &'static str,
    pub(super) help: &'static str,
    /// What the layer is called.
    name: &'static str,
    /// A preset of the Profile node.
    profile: Option<&'static str>,
    /// Values that it does not have, or other ones. Colours are written as shown.
    values: &'static [(&'static str, Set)],
    light: From,
}

use Set::{Number, Word};

/// In the order in which a look is built up: from what lies below to what lies on top.
pub(super) static PRESETS: [LayerPreset; 6] = [
    LayerPreset {
        label: "Ambient fill",
        help: "A tint everywhere, so that nothing is black",
        name: "Fill",
        profile: Some("Ambient"),
        values: &[("convex", Word("#2a2733")), ("concave", Word("#14111c")), ("slope", Number(0.25))],
        light: From::Front,
    },
    LayerPreset {
        label: "Lambert diffuse",
        help: "Soft light, falling with the cosine of the angle to it",
        name: "Diffuse",
        profile: Some("Lambert"),
        values: &[("convex", Word("#b58a6a")), ("concave", Word("#7a4a3c"))],
        light: From::Front,
    },
    LayerPreset {
        label: "Cartoon",
        help: "One flat tone with a hard, antialiased edge",
        name: "Cartoon",
        profile: Some("Cartoon"),
        values: &[("convex", Word("#c79a72")), ("concave", Word("#c79a72")), ("blend", Word("alpha"))],
        light: From::Front,
    },
    LayerPreset {
        label: "Shadow, multiplied",
        help: "Darkens what the light does not reach, whatever the colors below",
        name: "Shadow",
        profile: Some("Half-Lambert"),
        values: &[
            ("convex", Word("#ffffff")),
            ("concave", Word("#d8d2e6")),
            ("blend", Word("multiply")),
            ("opacity", Number(0.6)),
        ],
        light: From::Front,
    },
    LayerPreset {
        label: "Phong highlight",
        help: "The light's mirror image, which moves with the eye",
        name: "Highlight",
        profile: Some("Phong specular"),
        values: &[("type", Word("specular")), ("convex", Word("#e8d9b8")), ("concave", Word("#8a5c40"))],
        light: From::Front,
    },
    LayerPreset {
        label: "Rim, back-light",
        help: "A cool edge by a light behind the object, which is added where there is none",
        name: "Back-light",
        profile: None,
        values: &[
            ("offset", Number(0.5)),
            ("falloff", Number(0.95)),
            ("cutoff", Number(1.25)),
            ("convex", Word("#4f86b8")),
            ("concave", Word("#21456e")),
            ("slope", Number(0.2)),
            ("amount", Number(0.15)),
        ],
        light: From::Behind,
    },
];

impl LayerPreset {
    /// A node of this preset: what must be there first, its id, and itself.
    pub(super) fn make(&self, session: &Session, beside: Option<&NodeId>) -> (Vec<Edit>, NodeId, Node) {
        let look = session.look();
        let mut node = Node { kind: "light_layer".to_owned(), name: free_name(look, self.name), ..Node::default() };
        let (light, edits) = match self.light {
            From::Front => front_light(look, beside),
            From::Behind => back_light(look),
        };
        node.values.insert("light".into(), Value::Text(light.to_string()));
        for (port, value) in self.profile.map(|label| profile(&session.catalog, label)).unwrap_or_default() {
            node.values.insert(port, value);
        }
        for (port, value) in self.values {
            let value = match value {
                Number(number) => Value::Number(*number),
                Word(word) => Value::Text((*word).to_owned()),
            };
            node.values.insert((*port).into(), value);
        }
        let id = NodeId::new(make_slug(&node.name, |slug| look.graph.nodes.contains_key(slug)));
        (edits, id, node)
    }
}

/// The values of one of the Profile node's presets.
fn profile(catalog: &Catalog, label: &str) -> Vec<(crate::ids::PortName, Value)> {
    let preset = catalog.get("profile").and_then(|kind| kind.presets.iter().find(|preset| preset.label == label));
    preset
        .map(|preset| preset.values.iter().map(|(port, value)| (port.clone(), value.clone())).collect())
        .unwrap_or_default()
}

/// A name that no layer has yet: `Diffuse`, `Diffuse 2`.
fn free_name(look: &Look, name: &str) -> String {
    let is_taken = |name: &str| look.graph.nodes.values().any(|node| node.name == name);
    let numbered = (2..).map(|number| format!("{name} {number}"));
    std::iter::once(name.to_owned()).chain(numbered).find(|name| !is_taken(name)).unwrap_or_default()
}

fn front_light(look: &Look, beside: Option<&NodeId>) -> (LightId, Vec<Edit>) {
    let named = beside.and_then(|id| look.graph.nodes.get(id)).and_then(|node| match node.values.get("light") {
        Some(Value::Text(id)) => look.lights.get_key_value(id.as_str()),
        _ => None,
    });
    let is_in_front = |(_, light): &(&LightId, &Light)| light.direction[2] > 0.0;
    let found = named.filter(is_in_front).or_else(|| look.lights.iter().find(is_in_front)).or(look.lights.first());
    match found {
        Some((id, _)) => (id.clone(), Vec::new()),
        None => add_light("key", [-0.5, 0.7, 0.6], look),
    }
}

fn back_light(look: &Look) -> (LightId, Vec<Edit>) {
    match look.lights.iter().find(|(_, light)| light.direction[2] < 0.0) {
        Some((id, _)) => (id.clone(), Vec::new()),
        None => add_light("back", [0.85, 0.35, -0.75], look),
    }
}

fn add_light(name: &str, direction: [f64; 3], look: &Look) -> (LightId, Vec<Edit>) {
    let id = LightId::new(make_slug(name, |slug| look.lights.contains_key(slug)));
    let light = Light { direction, ..Light::default() };
    (id.clone(), vec![Edit::AddLight { id, light, index: None }])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::Library;

    /// Every value is one that the layer has: a preset that names what is not there would silently do less.
    #[test]
    fn presets_set_what_a_layer_has() {
        let session = Session::new(std::sync::Arc::new(Library::built_in().clone()), || {});
        let kind = session.catalog.get("light_layer").unwrap();
        for preset in &PRESETS {
            let (edits, id, node) = preset.make(&session, None);
            assert_eq!(edits.is_empty(), preset.light == From::Front, "{id}: a new look has no light behind");
            assert!(preset.profile.is_none() || node.values.contains_key("cutoff"), "{}", preset.label);
            for (port, value) in &node.values {
                let port = &kind.inputs[kind.input(port.as_str()).unwrap()];
                if let (Value::Text(word), false) = (value, port.options.is_empty()) {
                    assert!(port.options.iter().any(|(known, _)| known == word), "{word}");
                }
            }
        }
    }
}
