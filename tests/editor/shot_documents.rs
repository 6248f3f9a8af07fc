//! Shots in the window: opened as they are drawn, edited without a word in the files under them,
//! undone, saved, keyed and recovered.

use std::path::PathBuf;

use chiaro::diag::Diagnostic;
use chiaro::document::{Camera, Edit, GraphId, Look, SceneEdit, ShotEdit, Value};
use chiaro::frame::{Assets, Setup, ValueChange, open};
use eframe::egui::{Key, Modifiers, Role};

use crate::editor_support::User;
use crate::editor_support::home::Home;
use crate::editor_support::shots::{LOOK, save, scene, shot, write};

const SCENE: &str = r#"{"chiaro": "scene",
 "objects": [{"id": "ball", "mesh": "shape:sphere", "looks": "look.json"}],
 "lights": {"sun": {"direction": [0, 0.6, 0.8], "intensity": 0.8},
            "back": {"direction": [0, 1, -1]}},
 "camera": {"eye": [0, 0, 6]}}"#;

const SEQUENCE: &str = r#"{"chiaro": "shot", "scene": "scene.json", "rate": 24, "step": 2,
 "overrides": [{"target": "lights.back.intensity", "value": 0.25}]}"#;

/// With a field that this Chiaro does not know, and in an order and a form of its own.
const SHOT: &str = r#"{"chiaro": "shot", "scene": "sequence.json", "made_by": "hand",
 "frames": [1, 25],
 "overrides": [
   {"target": "camera.eye", "keys": [{"frame": 1, "value": [0, 0, 6]},
                                     {"frame": 25, "value": [0, 0, 12]}]},
   {"look": "look.json", "target": "layer.opacity", "value": 0.75}]}
"#;

const FILES: [(&str, &str); 4] =
    [("look.json", LOOK), ("scene.json", SCENE), ("sequence.json", SEQUENCE), ("shot.json", SHOT)];

fn shot_file(home: &Home) -> PathBuf {
    write(home, &FILES);
    home.file("shot.json")
}

fn opened(home: &Home) -> User {
    let mut hand = home.window(Some(&shot_file(home)));
    hand.settle();
    hand
}

fn opacity(look: &Look) -> Option<&Value> {
    look.graph.nodes["layer"].values.get("opacity")
}

/// Files under the shot are as they were, byte for byte.
fn assert_assets_stay(home: &Home) {
    for (name, text) in &FILES[..3] {
        assert_eq!(std::fs::read_to_string(home.file(name)).unwrap(), *text, "{name}");
    }
}

/// The changes that stand, as `chiaro shot --diff` tells them.
fn changes(home: &Home) -> Vec<ValueChange> {
    let setup = resolved(home);
    let shot = setup.shot.expect("a shot");
    shot.changes.iter().filter(|change| change.stands).cloned().collect()
}

fn resolved(home: &Home) -> Setup {
    open(&home.file("shot.json"), None, &mut Assets::default()).unwrap().value
}

fn edit(hand: &mut User, edit: SceneEdit) -> Result<(), Box<Diagnostic>> {
    let done = hand.app_mut().session_mut().apply_to_scene(edit, None);
    hand.settle();
    done
}

fn brighter(hand: &User, id: &str, intensity: f64) -> SceneEdit {
    let mut light = scene(hand).lights[id].clone();
    light.intensity = intensity;
    SceneEdit::SetLight { id: id.into(), light }
}

fn at(hand: &mut User, frame: f64) {
    hand.app_mut().session_mut().set_time(frame / 24.0);
    hand.settle();
}

#[test]
fn a_shot_opens_as_it_is_drawn() {
    let home = Home::new();
    let mut hand = opened(&home);
    let setup = resolved(&home);
    assert_eq!(opacity(hand.look()), Some(&Value::Number(0.75)), "the look under the shot");
    assert_eq!(scene(&hand).lights["back"].intensity, 0.25, "the sequence's light");
    assert!((hand.app().session().view().time() - 1.0 / 24.0).abs() < 1e-9, "its first frame");
    for frame in [1.0, 7.0, 25.0] {
        at(&mut hand, frame);
        let drawn = setup.posed(frame / 24.0).scene.camera;
        assert_eq!(scene(&hand).camera.eye, drawn.eye);
        let seen = hand.app().session().view().orbit().camera();
        assert!((seen.eye[2] - drawn.eye[2]).abs() < 1e-9, "{frame}: {:?}", seen.eye);
    }
    assert!(!hand.app().session().is_dirty());
    let errors = hand.errors();
    assert!(errors.is_empty(), "{errors:?}");
    // Nothing is written by opening, looking and saving.
    save(&mut hand);
    assert_eq!(std::fs::read_to_string(home.file("shot.json")).unwrap(), SHOT);
    assert_assets_stay(&home);
}

#[test]
fn a_light_is_changed_in_the_shot_undone_saved_and_reset() {
    let home = Home::new();
    let mut hand = opened(&home);
    let brighter_sun = brighter(&hand, "sun", 2.5);
    edit(&mut hand, brighter_sun).unwrap();
    assert_eq!(scene(&hand).lights["sun"].intensity, 2.5);
    assert_eq!(shot(&hand).overrides.len(), 3);
    assert!(hand.app().session().is_dirty() && !hand.app().session().is_look_dirty());
    hand.undo();
    assert_eq!((scene(&hand).lights["sun"].intensity, shot(&hand).overrides.len()), (0.8, 2));
    assert!(!hand.app().session().is_dirty());
    hand.redo();
    save(&mut hand);
    assert!(!hand.app().session().is_dirty());
    assert_assets_stay(&home);
    let told = changes(&home);
    let sun = told.iter().find(|change| change.target == "lights.sun.intensity").unwrap();
    assert_eq!((sun.from.as_f64(), sun.to.as_f64()), (Some(0.8), Some(2.5)));
    let text = std::fs::read_to_string(home.file("shot.json")).unwrap();
    assert!(text.contains("\"made_by\": \"hand\""), "{text}");

    // The panel has it, with what it was, and takes it back.
    hand.tab("Shot");
    assert!(hand.has("Reset lights.sun.intensity"));
    assert!(!hand.has("Reset lights.back.intensity"), "that is the sequence's to take back");
    hand.bring(Role::Button, "Reset lights.sun.intensity");
    hand.press_a(Role::Button, "Reset lights.sun.intensity");
    assert_eq!(scene(&hand).lights["sun"].intensity, 0.8);
    // A value that is set to what it is without the shot is no override.
    let dimmer = brighter(&hand, "back", 0.5);
    edit(&mut hand, dimmer).unwrap();
    assert_eq!(shot(&hand).overrides.len(), 3, "over the sequence's");
    let as_before = brighter(&hand, "back", 0.25);
    edit(&mut hand, as_before).unwrap();
    assert_eq!(shot(&hand).overrides.len(), 2);
}

#[test]
fn a_value_of_a_node_is_changed_in_the_shot_alone() {
    let home = Home::new();
    let mut hand = opened(&home);
    let set = |value: f64| Edit::SetValue {
        graph: GraphId::Look,
        id: "layer".into(),
        port: "opacity".into(),
        value: Value::Number(value),
        index: None,
    };
    let session = hand.app_mut().session_mut();
    session.apply(set(0.125), None).unwrap();
    let mute = Edit::SetMuted { graph: GraphId::Look, id: "layer".into(), muted: true };
    session.apply(mute, None).unwrap();
    hand.settle();
    assert_eq!(opacity(hand.look()), Some(&Value::Number(0.125)));
    assert!(hand.look().graph.nodes["layer"].muted);
    // As the look's file has it: the override goes.
    hand.app_mut().session_mut().apply(set(0.5), None).unwrap();
    let targets: Vec<&str> =
        shot(&hand).overrides.iter().map(|change| change.target.as_str()).collect();
    assert_eq!(targets, ["camera.eye", "nodes.layer.muted"]);
    save(&mut hand);
    assert_assets_stay(&home);
    assert!(resolved(&home).looks[0].look.graph.nodes["layer"].muted);
}

/// Brings a panel to the front by the command palette.
fn front(hand: &mut User, panel: &str) {
    hand.key_with(Modifiers::COMMAND, Key::P);
    hand.type_text(&format!("panel {panel}"));
    hand.press(&format!("Panel: {panel}"));
}

#[test]
fn what_a_shot_changes_is_marked_on_nodes_layers_lights_and_objects_and_reset_there() {
    let home = Home::new();
    let mut hand = opened(&home);
    let mut object = scene(&hand).objects["ball"].clone();
    object.transform.translate = [0.5, 0.0, 0.0];
    edit(&mut hand, SceneEdit::SetObject { id: "ball".into(), object: Box::new(object) }).unwrap();
    let brighter_sun = brighter(&hand, "sun", 2.5);
    edit(&mut hand, brighter_sun).unwrap();

    front(&mut hand, "Objects");
    assert!(hand.has("Object ball, changed by the shot"));
    front(&mut hand, "Lights");
    hand.press("More of sun of the scene");
    hand.press("Intensity, changed by the shot");
    hand.press("Reset to the scene's");
    assert_eq!(scene(&hand).lights["sun"].intensity, 0.8);
    hand.key(Key::Escape);
    hand.settle();

    // On the canvas, and in the list of layers, whose menus have the way back.
    assert!(hand.says("changed by the shot"), "the node is marked");
    front(&mut hand, "Layers");
    let layer = hand.place_like("Layer Light layer, changed by the shot");
    assert!(layer.is_positive());
    hand.press("More of Light layer");
    hand.press("Opacity, changed by the shot");
    hand.press("Reset to the look's");
    assert_eq!(opacity(hand.look()), Some(&Value::Number(0.5)), "as the look's file has it");
    assert!(hand.has("Layer Light layer"));
    hand.undo();
    assert_eq!(opacity(hand.look()), Some(&Value::Number(0.75)));
    assert_assets_stay(&home);
}

#[test]
fn what_no_shot_says_is_refused_with_the_file_that_has_it() {
    let home = Home::new();
    let mut hand = opened(&home);
    let remove = Edit::RemoveNode { graph: GraphId::Look, id: "layer".into() };
    let problem = hand.app_mut().session_mut().apply(remove, None).unwrap_err();
    assert!(problem.message.contains("open look.json"), "{}", problem.message);
    let remove = SceneEdit::RemoveLight { id: "sun".into() };
    let problem = edit(&mut hand, remove).unwrap_err();
    assert!(problem.message.contains("open scene.json"), "{}", problem.message);
    assert!(hand.look().graph.nodes.contains_key("layer") && scene(&hand).lights.len() == 2);
    assert_eq!(hand.steps(), 0);
    assert_eq!(shot(&hand).overrides.len(), 2);
}

#[test]
fn a_camera_is_keyed_at_the_frame_and_frames_and_step_are_set() {
    let home = Home::new();
    let mut hand = opened(&home);
    at(&mut hand, 13.0);
    assert_eq!(scene(&hand).camera.eye, [0.0, 0.0, 9.0], "between its keys");
    let camera = Camera { eye: [1.0, 0.0, 9.0], fov: 0.75, ..scene(&hand).camera };
    edit(&mut hand, SceneEdit::SetCamera { camera }).unwrap();
    let eye = &shot(&hand).overrides[0];
    let frames: Vec<f64> = eye.keys.iter().map(|key| key.frame).collect();
    assert_eq!(frames, [1.0, 13.0, 25.0]);
    let fov = shot(&hand).overrides.iter().find(|change| change.target == "camera.fov").unwrap();
    assert_eq!(fov.value, Some(Value::Number(0.75)), "what is not keyed is set");
    hand.undo();
    assert_eq!(shot(&hand).overrides[0].keys.len(), 2, "one step");
    // A light is keyed in the panel, and set at another frame.
    let brighter_sun = brighter(&hand, "sun", 2.0);
    edit(&mut hand, brighter_sun).unwrap();
    hand.tab("Shot");
    hand.bring(Role::Button, "Key lights.sun.intensity");
    hand.press_a(Role::Button, "Key lights.sun.intensity");
    assert_eq!(shot(&hand).overrides[2].keys.len(), 1);
    // Frames and step are the shot's.
    let session = hand.app_mut().session_mut();
    session.apply_to_shot(ShotEdit::SetFrames { frames: Some([1, 48]) }, None).unwrap();
    hand.settle();
    assert_eq!(scene(&hand).time.end, 2.0);
    hand.bring(Role::RadioButton, "Shading on ones");
    hand.press_a(Role::RadioButton, "Shading on ones");
    assert_eq!(shot(&hand).step, Some(1));
    save(&mut hand);
    assert_assets_stay(&home);
    assert_eq!(resolved(&home).shot.unwrap().stack.frames(), [1, 48]);
}

#[test]
fn a_shot_comes_back_after_a_crash_and_follows_its_files() {
    let home = Home::new();
    let mut hand = opened(&home);
    let brighter_sun = brighter(&hand, "sun", 3.0);
    edit(&mut hand, brighter_sun).unwrap();
    hand.app().session().wait_for_journal();
    let later = home.after_a_crash();
    let mut again = later.window(None);
    again.settle();
    again.press("Restore it");
    assert_eq!(scene(&again).lights["sun"].intensity, 3.0);
    assert_eq!(opacity(again.look()), Some(&Value::Number(0.75)));
    again.undo();
    assert_eq!(scene(&again).lights["sun"].intensity, 0.8);
    drop(again);

    // Another program changes the sequence: the shot is seen over it, its changes stay.
    let other = SEQUENCE.replace("0.25", "0.125");
    std::fs::write(home.file("sequence.json"), other).unwrap();
    hand.app_mut().look_at_files();
    hand.settle();
    assert_eq!(scene(&hand).lights["back"].intensity, 0.125);
    assert_eq!(scene(&hand).lights["sun"].intensity, 3.0);
    std::fs::write(home.file("look.json"), LOOK.replace("[0, 0, 1]", "[1, 0, 0]")).unwrap();
    hand.app_mut().look_at_files();
    hand.settle();
    assert_eq!(hand.look().lights["key"].direction, [1.0, 0.0, 0.0]);
    assert_eq!(opacity(hand.look()), Some(&Value::Number(0.75)));
}

#[test]
fn a_cell_of_a_wedge_is_taken_as_one_step() {
    let home = Home::new();
    let mut hand = opened(&home);
    let sheet = home.file("wedge.json");
    let cells = r##"{"chiaro": "wedge", "document": "shot.json", "cells": [
        {"picture": "wedge/001.png", "values": {"sun.intensity": 1.5}},
        {"picture": "wedge/002.png", "frame": 3,
         "values": {"sun.color": "#ff0000", "layer.opacity": 0.25}}]}"##;
    std::fs::write(&sheet, cells).unwrap();
    hand.app_mut().open(&sheet);
    hand.settle();
    assert!(hand.app().session().shot().is_some(), "the shot stays");
    let cell = hand.place_like("#ff0000");
    hand.click(cell.center());
    hand.settle();
    assert_eq!(scene(&hand).lights["sun"].color, [1.0, 0.0, 0.0]);
    assert_eq!(opacity(hand.look()), Some(&Value::Number(0.25)));
    assert_eq!((hand.steps(), shot(&hand).overrides.len()), (1, 3));
    hand.undo();
    assert_eq!(opacity(hand.look()), Some(&Value::Number(0.75)));
    assert_eq!(shot(&hand).overrides.len(), 2);
}

#[test]
fn an_edge_that_the_shot_changes_is_named_and_reset_as_one() {
    let home = Home::new();
    let mut hand = opened(&home);
    for (port, value) in [("offset", 1.0), ("falloff", 1.2), ("cutoff", 1.4)] {
        let edit = Edit::SetValue {
            graph: GraphId::Look,
            id: "layer".into(),
            port: port.into(),
            value: Value::Number(value),
            index: None,
        };
        hand.app_mut().session_mut().apply(edit, None).unwrap();
    }
    hand.app_mut().session_mut().select(vec!["layer".into()]);
    hand.settle();
    let (changed, steps) = (shot(&hand).overrides.len(), hand.steps());
    assert_eq!(changed, 5);
    front(&mut hand, "Shot");
    // Long names are shortened at their ends, so that the angle comes first.
    let told = hand.names().join("\n");
    for angle in ["Fall-off", "Cut-off"] {
        assert!(told.contains(&format!("Light layer: {angle} (edge")), "{told}");
    }
    assert!(told.contains("set to 80.2°"), "in degrees, as fields have it: {told}");
    front(&mut hand, "Inspector");
    hand.bring(Role::Button, "Keys of Edge");
    hand.press("Keys of Edge");
    hand.press("Reset to the look's");
    assert_eq!((shot(&hand).overrides.len(), hand.steps()), (2, steps + 1), "all in one step");
}
