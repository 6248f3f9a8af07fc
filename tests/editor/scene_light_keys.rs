//! Direction keys of a scene's lights in the panel of keys: found, selected, changed, deleted.

use std::path::PathBuf;

use chiaro::document::{DirectionKeys, KeyDirection, Scene, Target, Value};
use eframe::egui::Role;
use egui_kittest::kittest::Queryable as _;

use crate::editor_support::User;
use crate::editor_support::home::Home;

const LOOK: &str = r#"{"chiaro": "look", "lights": {"key": {"direction": [0, 0, 1]}},
 "nodes": [{"id": "base", "kind": "base"},
  {"id": "layer", "kind": "light_layer", "values": {"light": "key"}},
  {"id": "output", "kind": "output"}],
 "wires": [{"from": "base", "to": "layer.below"}, {"from": "layer", "to": "output.color"}],
 "direction_keys": [{"name": "Of the look", "by": "view", "keys": [
  {"direction": [0, 0, 1], "values": {"layer.opacity": 0.5}}]}]}"#;

const SCENE: &str = r#"{"chiaro": "scene",
 "objects": [{"id": "ball", "mesh": "shape:sphere", "looks": "look.json"}],
 "lights": {"sun": {"direction": [0, 0.6, 0.8]}, "back": {"direction": [0, 1, -1]}},
 "direction_keys": [{"name": "Back answers", "by": {"light": "sun"}, "keys": [
  {"direction": [0, 0.6, 0.8], "values": {"lights.back.intensity": 1}},
  {"direction": [0, 0.6, -0.8], "values": {"lights.back.intensity": 0.25}}]}],
 "camera": {"eye": [0, 0, 6]}}"#;

fn scene_file(home: &Home) -> PathBuf {
    std::fs::write(home.file("look.json"), LOOK).unwrap();
    let path = home.file("scene.json");
    std::fs::write(&path, SCENE).unwrap();
    path
}

fn scene(hand: &User) -> &Scene {
    hand.app().session().open_scene().expect("one is open").scene()
}

fn keys(hand: &User) -> &DirectionKeys {
    &scene(hand).direction_keys[0]
}

/// Intensity of the back light at a key of the scene.
fn intensity(hand: &User, key: usize) -> f64 {
    let target = Target::parse("lights.back.intensity").unwrap();
    match keys(hand).keys[key].values.get(&target) {
        Some(Value::Number(number)) => *number,
        other => panic!("{other:?}"),
    }
}

#[test]
fn keys_of_a_scenes_light_are_found_changed_and_deleted() {
    let home = Home::new();
    let mut hand = home.window(Some(&scene_file(&home)));
    hand.settle();
    hand.tab("Keys");
    assert!(!hand.has("Of the scene"), "the look's set comes first");
    hand.choose("Set of keys", "Back answers · of the scene");
    assert!(hand.has("Of the scene"));
    let before = (keys(&hand).clone(), hand.steps());
    // A key is selected, and its value is typed into its cell.
    hand.press("Select key 2");
    let cell = hand.harness.get_by_label("back: Intensity at key 2").rect();
    hand.type_over(cell, "3");
    assert_eq!([intensity(&hand, 0), intensity(&hand, 1)], [1.0, 3.0]);
    assert_eq!(hand.steps(), before.1 + 1, "one step of the scene");
    assert!(!hand.app().session().is_look_dirty(), "the look stays as it was");
    // It is copied, and the copy goes; the key itself goes too, and comes back.
    hand.press("Copy key");
    assert_eq!(keys(&hand).keys.len(), 3);
    hand.press("Delete key");
    assert_eq!(keys(&hand).keys.len(), 2);
    hand.press("Select key 2");
    hand.press("Delete key");
    assert_eq!((keys(&hand).keys.len(), intensity(&hand, 0)), (1, 1.0));
    hand.undo();
    assert_eq!(intensity(&hand, 1), 3.0);
    // Another direction decides, and the set is taken away.
    hand.choose("What decides between the keys", "By the view");
    assert_eq!(keys(&hand).by, KeyDirection::View);
    hand.press("Remove set");
    assert!(scene(&hand).direction_keys.is_empty());
    assert!(!hand.has("Of the scene"), "the look's set is shown again");
    assert_eq!(hand.look().direction_keys.len(), 1);
    for _ in 0..5 {
        hand.undo();
    }
    assert_eq!((keys(&hand), hand.steps()), (&before.0, before.1), "as it was");
}

#[test]
fn a_key_of_a_scenes_light_is_the_one_at_which_lights_are_set() {
    let home = Home::new();
    let mut hand = home.window(Some(&scene_file(&home)));
    hand.settle();
    hand.tab("Keys");
    hand.choose("Set of keys", "Back answers · of the scene");
    // The first key weighs all: the second takes values only where it is selected.
    hand.press("Select key 2");
    hand.tab("Lights");
    let row = hand.place_like("Light back of the scene");
    let field = hand.harness.get_all_by_role(Role::SpinButton).map(|node| node.rect());
    let field = field
        .into_iter()
        .find(|rect| (rect.center().y - row.center().y).abs() < 8.0 && rect.min.x > row.min.x);
    hand.type_over(field.expect("a field of its intensity"), "2");
    assert_eq!([intensity(&hand, 0), intensity(&hand, 1)], [1.0, 2.0]);
}
