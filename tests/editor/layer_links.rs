//! Layers of objects in the panel of links: what reaches them, by which rule.

use eframe::egui::Role;
use egui_kittest::kittest::{NodeT as _, Queryable as _};

use crate::editor_support::User;
use crate::editor_support::home::Home;

/// Two layers with a light each, and a group that runs for all lights but the rim.
const LOOK: &str = r#"{"chiaro": "look", "name": "Paint",
 "lights": {"key": {"direction": [0, 0, 1]}, "rim": {"direction": [0, 1, -1]}},
 "definitions": {"lamps": {"label": "Lamps", "outputs": [{"name": "color"}],
  "nodes": [{"id": "lamp", "kind": "light"}, {"id": "angle", "kind": "parametrization"},
   {"id": "tone", "kind": "profile"}, {"id": "sum", "kind": "sum_of_lights"}],
  "wires": [{"from": "lamp", "to": "angle.light"}, {"from": "angle", "to": "tone.angle"},
   {"from": "tone", "to": "sum.value"}, {"from": "sum", "to": "outputs.color"}]}},
 "nodes": [{"id": "each", "kind": "lamps", "for_each": "*", "unlayered": "rim"},
  {"id": "layer", "kind": "light_layer", "name": "Edge", "values": {"light": "rim"}},
  {"id": "base", "kind": "base"}, {"id": "output", "kind": "output"}],
 "wires": [{"from": "each", "to": "base.color"}, {"from": "base", "to": "layer.below"},
  {"from": "layer", "to": "output.color"}]}"#;

const SCENE: &str = r#"{"chiaro": "scene", "objects": [
  {"id": "ring", "mesh": "shape:torus", "looks": "look.json",
   "transform": {"translate": [-1.2, 0, 0]}},
  {"id": "ball", "mesh": "shape:sphere", "looks": "look.json",
   "transform": {"translate": [1.2, 0, 0]},
   "layers": [{"node": "layer", "layered": "{source} - rim"}]}],
 "lights": {"rim": {"direction": [0, 1, -1]}}, "camera": {"eye": [0, 0, 9]}}"#;

/// Text beside a row of the panel.
fn rule(hand: &User, row: &str) -> String {
    let label = format!("Link {row}");
    let row = hand.harness.get_by_role_and_label(Role::ListItem, &label);
    row.accesskit_node().value().unwrap_or_default()
}

fn choose(hand: &mut User, row: &str) {
    hand.press_a(Role::ListItem, &format!("Link {row}"));
}

#[test]
fn layers_of_an_object_tell_what_reaches_them_by_which_rule() {
    let home = Home::new();
    std::fs::write(home.file("look.json"), LOOK).unwrap();
    std::fs::write(home.file("scene.json"), SCENE).unwrap();
    let mut hand = home.window(Some(&home.file("scene.json")));
    hand.settle();
    hand.press("View");
    hand.press_a(Role::CheckBox, "Links");
    hand.key(eframe::egui::Key::Escape);
    hand.settle();
    assert!(!hand.has("Link layer Edge"), "objects are folded at first");
    // From a light to layers: the look keeps the rim from its lamps, the ball also from its edge.
    choose(&mut hand, "light rim");
    assert!(
        rule(&hand, "object ring").starts_with("not Lamps · "),
        "{}",
        rule(&hand, "object ring")
    );
    assert!(rule(&hand, "object ball").starts_with("not Lamps, Edge · "));
    hand.press_a(Role::Button, "Layers of ball");
    assert_eq!(rule(&hand, "layer Lamps"), "`unlayered` (`rim`) has it");
    let edge = rule(&hand, "layer Edge");
    assert!(edge.contains("`layered`") && edge.contains("- rim"), "{edge}");
    // From a layer to lights.
    choose(&mut hand, "light rim");
    choose(&mut hand, "layer Edge");
    assert!(hand.has("Lights of Edge of ball"));
    assert_eq!(rule(&hand, "light rim"), edge);
    assert_eq!(rule(&hand, "light key"), "", "the layer is not about it");
    let mark = hand.harness.get_by_role_and_label(Role::CheckBox, "light rim is linked");
    assert!(mark.accesskit_node().is_disabled(), "a layer's sets are changed elsewhere");
    hand.press_a(Role::Button, "Layers of ball");
    assert!(!hand.has("Link layer Edge") && !hand.has("Lights of Edge of ball"));
}
