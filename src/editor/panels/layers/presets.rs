//! Layers to begin with: those that painters and shading artists know by name, with the values of
//! the Profile node's own presets where it has them, and otherwise those of the BADF paper's looks.

use std::sync::{Arc, LazyLock};

use chiaro_locale::{Text, text};
use glam::DVec3;

use crate::catalog::Catalog;
use crate::document::{Edit, Interpolation, Light, Look, Node, Ramp, RampStop, Value};
use crate::ids::{LightId, NodeId, make_slug};
use crate::library::Library;
use crate::state::parts::{Part, shipped_part};
use crate::state::session::Session;

/// Light of the look that a layer is made for.
#[derive(Clone, Copy, PartialEq)]
enum LightChoice {
    /// Light of the selected layer, or else the first one in front.
    Front,
    /// First light behind the object, added where there is none.
    Behind,
    /// No light: lines lie where forms end.
    Nothing,
}

/// Direction to a light in front of the object.
const FRONT: [f64; 3] = [-0.5, 0.7, 0.6];
/// Direction to a light behind the object, in the camera's axes: right, up and to the eye.
const BACK: DVec3 = DVec3::new(0.85, 0.4, -0.5);
/// Range of the cosine of the angle between the eye and a light that gives a rim: a light in front
/// gives none, and the part lit from straight behind is not seen.
const RIM: std::ops::Range<f64> = -0.8..0.0;

/// Kind of the node of most layers.
const LIGHT_LAYER: &str = "light_layer";

enum PresetValue {
    Number(f64),
    Word(&'static str),
    /// Colors from the light to the dark, each with the part of half a turn where it begins.
    Bands(&'static [(f64, [f64; 3])]),
}

/// Layer to begin with.
pub(crate) struct LayerPreset {
    /// Name of the preset, and in English of the new layer.
    pub(crate) name: Text,
    pub(crate) help: Text,
    /// Kind of the layer's node.
    kind: &'static str,
    /// Preset of the Profile node that supplies values.
    profile: Option<&'static str>,
    /// Values that the Profile preset lacks, or that replace its own. Colors are written as shown.
    values: &'static [(&'static str, PresetValue)],
    light: LightChoice,
}

use PresetValue::{Bands, Number, Word};

/// Presets in the order in which a look is built up: from what lies below to what lies on top.
pub(super) static PRESETS: [LayerPreset; 14] = [
    LayerPreset {
        name: text!("layer" => "Fill"),
        help: text!(
            "One color over all that lies below, whatever the light: what is picked is what is seen"
        ),
        kind: "blend",
        profile: None,
        values: &[("color", Word("#8d8a93")), ("mode", Word("alpha"))],
        light: LightChoice::Nothing,
    },
    LayerPreset {
        name: text!("Ambient"),
        help: text!(
            "Ambient light: a faint tint added everywhere, so that nothing is black; hollows have \
             a color of their own"
        ),
        kind: LIGHT_LAYER,
        profile: Some("Ambient"),
        values: &[
            ("convex", Word("#2a2733")),
            ("concave", Word("#14111c")),
            ("slope", Number(0.25)),
        ],
        light: LightChoice::Front,
    },
    LayerPreset {
        name: text!("Diffuse"),
        help: text!("Lambert's soft light, falling with the cosine of the angle to it"),
        kind: LIGHT_LAYER,
        profile: Some("Lambert"),
        values: &[("convex", Word("#b58a6a")), ("concave", Word("#7a4a3c"))],
        light: LightChoice::Front,
    },
    LayerPreset {
        name: text!("Cartoon"),
        help: text!("One flat tone with a hard, antialiased edge"),
        kind: LIGHT_LAYER,
        profile: Some("Cartoon"),
        values: &[
            ("convex", Word("#c79a72")),
            ("concave", Word("#c79a72")),
            ("blend", Word("alpha")),
        ],
        light: LightChoice::Front,
    },
    LayerPreset {
        name: text!("Bands"),
        help: text!(
            "Flat colors from the light to the dark, as many as you like, with one softness; \
             edges are dragged on the object"
        ),
        kind: "band_layer",
        profile: None,
        values: &[(
            "bands",
            Bands(&[
                (0.0, [0.95, 0.78, 0.6]),
                (0.3, [0.76, 0.5, 0.39]),
                (0.475, [0.38, 0.26, 0.43]),
            ]),
        )],
        light: LightChoice::Front,
    },
    LayerPreset {
        name: text!("Shadow"),
        help: text!("Multiplied: darkens what the light does not reach, whatever the colors below"),
        kind: LIGHT_LAYER,
        profile: Some("Half-Lambert"),
        values: &[
            // One color: where the light is, and in hollows there, all stays as it is.
            ("convex", Word("#ffffff")),
            ("blend", Word("multiply")),
            ("opacity", Number(0.6)),
        ],
        light: LightChoice::Front,
    },
    LayerPreset {
        name: text!("Cast shadow"),
        help: text!(
            "Shadows that things throw onto one another and onto themselves, in a color: seen in \
             scenes that have something to throw them"
        ),
        kind: "shadow_layer",
        profile: None,
        values: &[("color", Word("#5c5585"))],
        light: LightChoice::Front,
    },
    LayerPreset {
        name: text!("Half-tone shadow"),
        help: text!(
            "Dots of a print in a color where the light does not reach, growing into the dark; \
             lines or crosses, too"
        ),
        kind: "halftone_layer",
        profile: None,
        values: &[],
        light: LightChoice::Front,
    },
    LayerPreset {
        name: text!("Hatched shadow"),
        help: text!(
            "Strokes of a pen where the light does not reach, which cross in the dark and stay on \
             the surface"
        ),
        kind: "hatching_layer",
        profile: None,
        values: &[],
        light: LightChoice::Front,
    },
    LayerPreset {
        name: text!("Highlight"),
        help: text!("Phong's highlight: the light's mirror image, which moves with the eye"),
        kind: LIGHT_LAYER,
        profile: Some("Phong specular"),
        values: &[
            ("type", Word("specular")),
            ("convex", Word("#e8d9b8")),
            ("concave", Word("#8a5c40")),
        ],
        light: LightChoice::Front,
    },
    LayerPreset {
        name: text!("Cut highlight"),
        help: text!(
            "A highlight with a shape: move, turn, stretch, split and square it on the object, or \
             make it a star. It stands upright on any mesh"
        ),
        kind: "highlight_layer",
        profile: None,
        values: &[
            ("turn", Number(-0.3)),
            ("split", Number(0.16)),
            ("square", Number(0.3)),
            ("offset", Number(0.14)),
            ("falloff", Number(0.14)),
            ("cutoff", Number(0.14)),
            ("color", Word("#fff6e2")),
        ],
        light: LightChoice::Front,
    },
    LayerPreset {
        name: text!("Back-light"),
        help: text!(
            "A rim: a cool edge by a light behind the object as it is seen now, which is added \
             where there is none"
        ),
        kind: LIGHT_LAYER,
        profile: None,
        values: &[
            ("offset", Number(0.6)),
            ("falloff", Number(1.0)),
            ("cutoff", Number(1.3)),
            ("convex", Word("#6fa8dc")),
            ("concave", Word("#2f5f92")),
            ("slope", Number(0.2)),
            ("amount", Number(0.15)),
        ],
        light: LightChoice::Behind,
    },
    LayerPreset {
        name: text!("Ink lines"),
        help: text!("Silhouettes, creases and borders of objects in a color, as wide as you like"),
        kind: "ink_layer",
        profile: None,
        values: &[],
        light: LightChoice::Nothing,
    },
    LayerPreset {
        name: text!("Grade"),
        help: text!(
            "One color over all that lies below, multiplied: a blue night over warm layers. In the \
             modes Hue, Saturation and Color it changes the colors, and leaves light and dark"
        ),
        kind: "blend",
        profile: None,
        values: &[("color", Word("#7c8fd8")), ("mode", Word("multiply"))],
        light: LightChoice::Nothing,
    },
];

impl LayerPreset {
    /// New layer of this preset: the edits that must come first, the node's id, and the node.
    pub(super) fn make(
        &self,
        session: &Session,
        beside: Option<&NodeId>,
    ) -> (Vec<Edit>, NodeId, Node) {
        let look = session.look();
        let mut node = self.node(&session.project.catalog);
        node.name = free_name(look, self.name.english());
        let light = match self.light {
            LightChoice::Front => Some(front_light(look, beside)),
            LightChoice::Behind => Some(back_light(session)),
            LightChoice::Nothing => None,
        };
        let (light, edits) = light.unzip();
        if let Some(light) = light {
            node.values.insert("light".into(), Value::Text(light.to_string()));
        }
        let id = NodeId::new(make_slug(&node.name, |slug| look.graph.nodes.contains_key(slug)));
        (edits.unwrap_or_default(), id, node)
    }

    /// Node of the layer, without a name and a light.
    fn node(&self, catalog: &Catalog) -> Node {
        let mut node = Node { kind: self.kind.to_owned(), ..Node::default() };
        node.values.extend(self.profile.iter().flat_map(|label| profile(catalog, label)));
        for (port, value) in self.values {
            let value = match value {
                Number(number) => Value::Number(*number),
                Word(word) => Value::Text((*word).to_owned()),
                Bands(stops) => Value::Ramp(stepped(stops)),
            };
            node.values.insert((*port).into(), value);
        }
        node
    }

    /// Part of the library that is the layer with the light that it is for.
    fn part(&self, catalog: &mut Catalog) -> Arc<Part> {
        let name = self.name.english();
        let mut node = Node { name: name.to_owned(), ..self.node(catalog) };
        let mut look = Look {
            name: name.to_owned(),
            about: self.help.english().to_owned(),
            ..Look::default()
        };
        let light = match self.light {
            LightChoice::Front => Some(("key", FRONT)),
            LightChoice::Behind => Some(("back", BACK.to_array())),
            LightChoice::Nothing => None,
        };
        if let Some((id, direction)) = light {
            look.lights.insert(id.into(), Light { direction, ..Light::default() });
            node.values.insert("light".into(), Value::Text(id.to_owned()));
        }
        let slug = make_slug(name, |_| false);
        look.graph.nodes.insert(NodeId::new(slug.clone()), node);
        shipped_part(&format!("layer-{slug}"), look, catalog)
    }
}

/// Presets as parts of the library, made once.
pub(crate) fn preset_parts() -> &'static [(&'static LayerPreset, Arc<Part>)] {
    static PARTS: LazyLock<Vec<(&'static LayerPreset, Arc<Part>)>> = LazyLock::new(|| {
        let mut catalog = Catalog::new(Library::built_in());
        PRESETS.iter().map(|preset| (preset, preset.part(&mut catalog))).collect()
    });
    &PARTS
}

/// Ramp of flat colors.
fn stepped(stops: &[(f64, [f64; 3])]) -> Ramp {
    let stops = stops.iter().map(|(at, color)| RampStop { at: *at, color: color.to_vec() });
    Ramp { stops: stops.collect(), interpolation: Interpolation::Stepped }
}

/// Values of one of the Profile node's presets.
fn profile(catalog: &Catalog, label: &str) -> Vec<(crate::ids::PortName, Value)> {
    let preset = catalog
        .get("profile")
        .and_then(|kind| kind.presets.iter().find(|preset| preset.label == label));
    preset
        .map(|preset| {
            preset.values.iter().map(|(port, value)| (port.clone(), value.clone())).collect()
        })
        .unwrap_or_default()
}

/// Name that no layer has yet: `Diffuse`, `Diffuse 2`.
fn free_name(look: &Look, name: &str) -> String {
    let is_taken = |name: &str| look.graph.nodes.values().any(|node| node.name == name);
    let numbered = (2..).map(|number| format!("{name} {number}"));
    std::iter::once(name.to_owned())
        .chain(numbered)
        .find(|name| !is_taken(name))
        .unwrap_or_default()
}

fn front_light(look: &Look, beside: Option<&NodeId>) -> (LightId, Vec<Edit>) {
    let named = beside.and_then(|id| look.graph.nodes.get(id)).and_then(|node| {
        match node.values.get("light") {
            Some(Value::Text(id)) => look.lights.get_key_value(id.as_str()),
            _ => None,
        }
    });
    let is_in_front = |(_, light): &(&LightId, &Light)| light.direction[2] > 0.0;
    let found = named
        .filter(is_in_front)
        .or_else(|| look.lights.iter().find(is_in_front))
        .or(look.lights.first());
    match found {
        Some((id, _)) => (id.clone(), Vec::new()),
        None => add_light("key", FRONT, look),
    }
}

/// Light that gives the present view a rim, wherever the camera and the illumination frame were
/// turned, with the edits that add the light.
fn back_light(session: &Session) -> (LightId, Vec<Edit>) {
    let (look, view) = (session.look(), &session.view.orbit);
    let eye = view.direction();
    let is_there = |(_, light): &(&LightId, &Light)| {
        let world = view.illumination * DVec3::from(light.direction).normalize_or_zero();
        // A key light that was turned behind by hand does not count: turned back, it would take the
        // rim with it.
        light.direction[2] < 0.0 && RIM.contains(&world.dot(eye))
    };
    if let Some((id, _)) = look.lights.iter().find(is_there) {
        return (id.clone(), Vec::new());
    }
    let (right, up) = view.right_and_up();
    let world = right * BACK.x + up * BACK.y + eye * BACK.z;
    // Four decimals are finer than the eye can tell, and keep files readable.
    let direction = view.illumination.inverse() * world;
    add_light("back", direction.to_array().map(|part| (part * 1e4).round() / 1e4), look)
}

fn add_light(name: &str, direction: [f64; 3], look: &Look) -> (LightId, Vec<Edit>) {
    let id = LightId::new(make_slug(name, |slug| look.lights.contains_key(slug)));
    let light = Light { direction, ..Light::default() };
    (id.clone(), vec![Edit::AddLight { id, light, index: None }])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::state::parts::PartKind;

    #[test]
    fn a_back_light_is_behind_what_is_seen_however_lights_and_camera_were_turned() {
        let mut session = Session::new(std::sync::Arc::new(Library::built_in().clone()), || {});
        let (_, edits) = back_light(&session);
        assert!(matches!(
            &edits[..],
            [Edit::AddLight { light, .. }] if light.direction == BACK.to_array()
        ));
        for (camera, lights) in [(0.0, 0.9), (0.7, 0.0), (-0.4, 0.5), (1.0, 1.0)] {
            session.view.orbit.orbit(camera, 0.3 * camera);
            session.view.orbit.turn_lights(lights, 0.5 * lights);
            let (id, edits) = back_light(&session);
            let [Edit::AddLight { light, .. }] = &edits[..] else { panic!("{edits:?}") };
            let world =
                (session.view.orbit.illumination * DVec3::from(light.direction)).normalize();
            assert!(RIM.contains(&world.dot(session.view.orbit.direction())), "{world}");
            session.apply(edits[0].clone(), None).unwrap();
            let is_behind = light.direction[2] < 0.0;
            assert!(!is_behind || back_light(&session) == (id, Vec::new()), "one is enough");
            session.undo();
        }
    }

    /// Every preset is a layer in the library, too, with a picture and the light that it needs.
    #[test]
    fn presets_are_parts_of_the_library() {
        let library = Library::built_in();
        let mut catalog = Catalog::new(library);
        for (preset, part) in preset_parts() {
            let content = part.content.as_ref().unwrap();
            assert_eq!(content.kind, PartKind::Layer, "{}", part.name);
            assert!(part.is_shipped() && content.shown.is_some(), "{}", part.name);
            let lights = usize::from(preset.light != LightChoice::Nothing);
            assert_eq!(content.look.lights.len(), lights, "{}", part.name);
            let shown = content.shown.as_ref().unwrap();
            catalog.sync(shown, library);
            let checked = crate::compile::check(shown, library, None);
            assert!(checked.is_ok(), "{}: {:?}", part.name, checked.err());
        }
    }

    /// Every value of a preset belongs to an input of the layer: a preset with an unknown input
    /// would silently do less.
    #[test]
    fn presets_set_what_a_layer_has() {
        let session = Session::new(std::sync::Arc::new(Library::built_in().clone()), || {});
        for preset in &PRESETS {
            let kind = session.project.catalog.get(preset.kind).unwrap();
            let (edits, id, node) = preset.make(&session, None);
            assert_eq!(
                edits.is_empty(),
                preset.light != LightChoice::Behind,
                "{id}: a new look has no light behind"
            );
            assert!(
                preset.profile.is_none() || node.values.contains_key("cutoff"),
                "{}",
                preset.name.english()
            );
            for (port, value) in &node.values {
                let port = &kind.inputs[kind.input(port.as_str()).unwrap()];
                if let (Value::Text(word), false) = (value, port.options.is_empty()) {
                    assert!(port.options.iter().any(|(known, _)| known == word), "{word}");
                }
            }
        }
    }
}
