//! Files of shots that tests write, and the open shot and scene.

use chiaro::document::{Scene, Shot};
use eframe::egui::{Key, Modifiers};

use super::User;
use super::home::Home;

/// A look of one layer, with a marker.
pub(crate) const LOOK: &str = r#"{"chiaro": "look", "lights": {"key": {"direction": [0, 0, 1]}},
 "markers": [{"time": 0.25, "name": "glint"}],
 "nodes": [{"id": "base", "kind": "base"},
  {"id": "layer", "kind": "light_layer", "values": {"light": "key", "opacity": 0.5}},
  {"id": "output", "kind": "output"}],
 "wires": [{"from": "base", "to": "layer.below"}, {"from": "layer", "to": "output.color"}]}"#;

/// Writes files by their names.
pub(crate) fn write(home: &Home, files: &[(&str, &str)]) {
    for (name, text) in files {
        std::fs::write(home.file(name), text).unwrap();
    }
}

/// The open shot.
pub(crate) fn shot(hand: &User) -> &Shot {
    hand.app().session().shot().expect("one is open").shot()
}

/// The open scene, with what the shot changes.
pub(crate) fn scene(hand: &User) -> &Scene {
    hand.app().session().open_scene().expect("one is open").scene()
}

pub(crate) fn save(hand: &mut User) {
    hand.key_with(Modifiers::COMMAND, Key::S);
    hand.settle();
}
