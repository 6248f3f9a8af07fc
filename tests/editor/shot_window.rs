//! Shots as people make them in the window: begun over a scene or a look, with markers, a frame
//! around the picture, values of one use of a group, and the cells of a wedge's sheet.

use std::path::{Path, PathBuf};

use chiaro::document::{Camera, Edit, GraphId, SceneEdit, Shot, ShotEdit, Value};
use chiaro::editor::App;
use chiaro::frame::{Assets, open};
use eframe::egui::accesskit::Toggled;
use eframe::egui::{Event, Key, Modifiers, Role, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};

use crate::editor_support::User;
use crate::editor_support::home::Home;
use crate::editor_support::shots::{LOOK, save, scene, shot, write};

const SCENE: &str = r#"{"chiaro": "scene",
 "objects": [{"id": "ball", "mesh": "shape:sphere", "looks": "look.json"}],
 "markers": [{"time": 1, "name": "door"}],
 "lights": {"sun": {"direction": [0, 0.6, 0.8], "intensity": 0.8}},
 "camera": {"eye": [0, 0, 6]}}"#;

const SHOT: &str = r#"{"chiaro": "shot", "scene": "scene.json", "frames": [0, 48], "rate": 24,
 "size": [1920, 1080], "markers": [{"frame": 12, "name": "turn"}]}"#;

const FILES: [(&str, &str); 3] = [("look.json", LOOK), ("scene.json", SCENE), ("shot.json", SHOT)];

fn opened(home: &Home, file: &str) -> User {
    write(home, &FILES);
    let mut hand = home.window(Some(&home.file(file)));
    hand.settle();
    hand
}

fn intensity(hand: &User) -> f64 {
    scene(hand).lights["sun"].intensity
}

fn set_intensity(hand: &mut User, intensity: f64) {
    let mut light = scene(hand).lights["sun"].clone();
    light.intensity = intensity;
    let edit = SceneEdit::SetLight { id: "sun".into(), light };
    hand.app_mut().session_mut().apply_to_scene(edit, None).unwrap();
    hand.settle();
}

fn command(hand: &mut User, words: &str) {
    hand.key_with(Modifiers::COMMAND, Key::P);
    hand.type_text(words);
    hand.key(Key::Enter);
    hand.settle();
}

/// Shows the timeline by its entry of *View*.
fn show_timeline(hand: &mut User) {
    hand.press("View");
    hand.press_a(Role::CheckBox, "Timeline");
    let nothing = hand.empty_place();
    hand.click(nothing);
}

fn read(path: &PathBuf) -> String {
    std::fs::read_to_string(path).unwrap()
}

#[test]
fn markers_are_the_shots_and_those_under_it_are_seen() {
    let home = Home::new();
    let mut hand = opened(&home, "shot.json");
    show_timeline(&mut hand);
    // Those of the files lead there, and are not moved.
    let door = hand.place_of(Role::Link, "Marker door of the scene scene.json").center();
    hand.click(door);
    hand.settle();
    assert_eq!(hand.app().session().view().time(), 1.0);
    hand.drag(door, door + vec2(60.0, 0.0));
    hand.settle();
    assert_eq!((scene(&hand).markers[0].time, hand.steps()), (1.0, 0));
    assert!(hand.has("Marker glint of the look look.json"));
    // The shot's own is dragged to a frame, and another is added at the playhead.
    let turn = hand.place_of(Role::Slider, "Marker turn").center();
    hand.drag(turn, turn + vec2(40.0, 0.0));
    hand.settle();
    let frame = shot(&hand).markers[0].frame;
    assert!(frame > 12 && hand.steps() == 1, "{frame}");
    hand.press("Add marker");
    let named = |hand: &User| -> Vec<(i32, String)> {
        shot(hand).markers.iter().map(|marker| (marker.frame, marker.name.clone())).collect()
    };
    let both = vec![(frame, "turn".to_owned()), (24, "Marker 1".to_owned())];
    assert_eq!(named(&hand), both);
    hand.undo();
    assert_eq!(named(&hand), both[..1]);
    hand.redo();
    save(&mut hand);
    assert_eq!(Shot::read(&read(&home.file("shot.json")), "").value.unwrap().markers.len(), 2);
    assert_eq!(read(&home.file("scene.json")), SCENE);
    assert_eq!(read(&home.file("look.json")), LOOK);
}

/// A frame of the window takes longer than a key of a quick user, while a large picture is drawn.
#[test]
fn width_and_height_are_typed_faster_than_frames_are_drawn() {
    let home = Home::new();
    let mut hand = opened(&home, "shot.json");
    hand.tab("Shot");
    hand.bring(Role::SpinButton, "Width");
    let width = hand.place_of(Role::SpinButton, "Width").center();
    hand.click(width);
    let text = |text: &str| Event::Text(text.to_owned());
    let key = |key| Event::Key {
        key,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers: Modifiers::NONE,
    };
    let all = [text("6"), text("40"), key(Key::Tab), text("360"), key(Key::Enter)];
    hand.harness.input_mut().events.extend(all);
    hand.settle();
    assert_eq!(shot(&hand).size, Some([640, 360]));
    hand.click(width);
    hand.type_text("99999");
    hand.key(Key::Enter);
    assert_eq!(shot(&hand).size, Some([32_768, 360]));
    assert_eq!(hand.app().message(), Some("At most 32768"));
}

#[test]
fn the_tasks_of_a_farm_are_the_shots_and_the_farm_is_the_users() {
    let home = Home::new();
    let mut hand = opened(&home, "shot.json");
    command(&mut hand, "Send to a farm");
    hand.bring(Role::SpinButton, "Frames a task");
    let field = hand.fields_called("Frames a task")[0];
    hand.type_over(field, "6");
    hand.bring(Role::RadioButton, "Farm openjd");
    hand.press_a(Role::RadioButton, "Farm openjd");
    assert_eq!((shot(&hand).chunk, hand.steps()), (Some(6), 1));
    assert!(hand.says("--to openjd --chunk 6"), "{:?}", hand.names());
    hand.undo();
    hand.settle();
    assert!(hand.says("--to openjd --chunk 10"), "{:?}", hand.names());
    hand.redo();
    save(&mut hand);
    assert_eq!(Shot::read(&read(&home.file("shot.json")), "").value.unwrap().chunk, Some(6));
    drop(hand);
    // Both are there again, and another shot has tasks of its own.
    let mut hand = home.window(Some(&home.file("shot.json")));
    hand.settle();
    command(&mut hand, "Send to a farm");
    assert!(hand.says("--to openjd --chunk 6"), "{:?}", hand.names());
    drop(hand);
    write(&home, &[("other.json", SHOT)]);
    let mut hand = home.window(Some(&home.file("other.json")));
    hand.settle();
    command(&mut hand, "Send to a farm");
    assert!(hand.says("--to openjd --chunk 10"), "{:?}", hand.names());
}

#[test]
fn a_shot_is_begun_over_the_open_scene() {
    let home = Home::new();
    let mut hand = opened(&home, "scene.json");
    command(&mut hand, "New shot");
    assert_eq!((shot(&hand).frames, shot(&hand).size), (Some([1, 48]), Some([1920, 1080])));
    assert!(hand.says("A new shot over scene.json, in no file yet"), "the panel tells of it");
    assert_eq!(hand.app().session().path(), Some(home.file("look.json").as_path()));
    assert!(!hand.app().session().is_dirty());
    // What is changed is the shot's.
    set_intensity(&mut hand, 2.0);
    assert_eq!(shot(&hand).overrides[0].target, "lights.sun.intensity");
    assert!(hand.has("Reset lights.sun.intensity"));
    // It comes back after a crash, still without a file.
    hand.app().session().wait_for_journal();
    let later = home.after_a_crash();
    let mut again = later.window(None);
    again.settle();
    again.press("Restore it");
    assert_eq!(intensity(&again), 2.0);
    assert!(!again.app().session().shot().unwrap().has_file());
    drop(again);
    // A save asks for the file.
    let folder = home.file("shots");
    std::fs::create_dir(&folder).unwrap();
    hand.app_mut().answer_dialog(&folder.join("sh010.json"));
    save(&mut hand);
    assert!(!hand.app().session().is_dirty(), "{:?}", hand.app().message());
    let written = Shot::read(&read(&folder.join("sh010.json")), "").value.unwrap();
    assert_eq!((written.scene.as_str(), written.overrides.len()), ("../scene.json", 1));
    assert_eq!(read(&home.file("scene.json")), SCENE);
    // A shot over that one has what it says, and changes nothing of it.
    command(&mut hand, "New shot over this shot");
    assert_eq!((shot(&hand).scene.as_str(), shot(&hand).frames), ("sh010.json", None));
    assert_eq!((intensity(&hand), hand.app().session().shot().unwrap().has_file()), (2.0, false));
}

/// Frames that the timeline plays, as its fields tell.
fn range(hand: &User) -> [f64; 2] {
    ["Range from", "Range to"].map(|label| {
        let field = hand.harness.get_by_role_and_label(Role::SpinButton, label);
        let number = || Some(field.accesskit_node().numeric_value()?.to_string());
        field.value().or_else(number).unwrap().parse().unwrap()
    })
}

#[test]
fn restored_work_brings_the_frames_that_are_played() {
    let home = Home::new();
    let mut hand = opened(&home, "shot.json");
    set_intensity(&mut hand, 2.0);
    hand.app().session().wait_for_journal();
    let later = home.after_a_crash();
    write(&later, &FILES);
    write(&later, &[("short.json", &SHOT.replace("[0, 48]", "[1, 12]"))]);
    let mut again = later.window(Some(&later.file("short.json")));
    again.settle();
    again.press("View");
    again.press_a(Role::CheckBox, "Timeline");
    again.key(Key::Escape);
    again.settle();
    assert_eq!(range(&again), [1.0, 12.0]);
    again.press("Restore it");
    assert_eq!((intensity(&again), range(&again)), (2.0, [0.0, 48.0]));
}

#[test]
fn work_of_a_closed_window_brings_the_frames_that_are_played() {
    let home = Home::new();
    let mut hand = opened(&home, "shot.json");
    set_intensity(&mut hand, 2.0);
    hand.app().session().wait_for_journal();
    hand.app_mut().session_mut().close_journal(true);
    drop(hand);
    // The file is named in another way than its journal does, as from its own folder.
    std::fs::create_dir(home.file("other")).unwrap();
    let mut again = home.window(Some(&home.file("other/../shot.json")));
    again.settle();
    again.press("View");
    again.press_a(Role::CheckBox, "Timeline");
    again.key(Key::Escape);
    again.settle();
    assert_eq!((intensity(&again), range(&again)), (2.0, [0.0, 48.0]));
}

#[test]
fn a_new_shot_is_saved_under_its_own_name() {
    let home = Home::new();
    write(&home, &FILES);
    let (places, scene) = (home.places(), home.file("scene.json"));
    let mut hand = User::with(move |ctx| {
        let mut app = App::new(ctx, None).with_path_fields();
        app.keep_in(places.clone(), ctx);
        app.open(&scene);
        app
    });
    hand.settle();
    command(&mut hand, "New shot");
    let offered = |hand: &mut User| -> PathBuf {
        save(hand);
        let field = hand.harness.get_by_role_and_label(Role::TextInput, "Path");
        let path = field.value().unwrap().into();
        hand.key(Key::Escape);
        hand.settle();
        path
    };
    assert_eq!(offered(&mut hand), home.file("shot-2.json"), "a shot.json is there");
    let named = ShotEdit::SetShotName { name: "SH 010".to_owned() };
    hand.app_mut().session_mut().apply_to_shot(named, None).unwrap();
    hand.settle();
    assert_eq!(offered(&mut hand), home.file("sh-010.json"));
}

#[test]
fn a_shot_of_a_look_alone_saves_a_scene_first() {
    let home = Home::new();
    let mut hand = opened(&home, "look.json");
    command(&mut hand, "New shot");
    assert!(hand.app().session().shot().is_none() && hand.says("Save the scene first"));
    hand.press("Cancel");
    save(&mut hand);
    assert!(hand.app().session().shot().is_none(), "given up is given up");
    command(&mut hand, "New shot");
    hand.app_mut().answer_dialog(&home.file("stage.json"));
    hand.key(Key::Enter);
    hand.settle();
    assert_eq!(shot(&hand).scene, "stage.json", "{:?}", hand.app().message());
    assert_eq!(hand.app().session().path(), Some(home.file("look.json").as_path()));
    // A scene with changes is saved first, too.
    hand.app_mut().open(&home.file("scene.json"));
    hand.settle();
    set_intensity(&mut hand, 0.5);
    command(&mut hand, "New shot");
    assert!(hand.says("Save scene.json first"));
    hand.key(Key::Enter);
    hand.settle();
    assert_eq!((shot(&hand).scene.as_str(), intensity(&hand)), ("scene.json", 0.5));
}

#[test]
fn the_frame_of_the_shot_has_its_form() {
    let home = Home::new();
    let mut hand = opened(&home, "shot.json");
    let picture = |hand: &User| hand.app().viewport().rect().unwrap();
    let framed = picture(&hand);
    assert!(
        framed.width() < 1.5 * framed.height() || (framed.aspect_ratio() - 16.0 / 9.0).abs() < 0.01
    );
    hand.press("Options");
    hand.press_a(Role::CheckBox, "Frame of the shot");
    hand.key(Key::Escape);
    hand.settle();
    let whole = picture(&hand);
    assert!(whole.height() > framed.height() && whole.width() == framed.width());
    assert!((framed.aspect_ratio() - 16.0 / 9.0).abs() < 0.01, "{framed:?} in {whole:?}");
}

#[test]
fn a_value_of_one_use_of_a_group_is_changed() {
    let home = Home::new();
    let grouped = r#"{"chiaro": "look", "lights": {"key": {"direction": [0, 0, 1]}},
     "nodes": [{"id": "base", "kind": "base"}, {"id": "one", "kind": "twice"},
      {"id": "two", "kind": "twice"}, {"id": "output", "kind": "output"}],
     "wires": [{"from": "base", "to": "one.below"}, {"from": "one", "to": "two.below"},
      {"from": "two", "to": "output.color"}],
     "definitions": {"twice": {"inputs": [{"name": "below"}],
      "outputs": [{"name": "below"}],
      "nodes": [{"id": "lit", "kind": "light_layer", "values": {"light": "key", "opacity": 0.5}}],
      "wires": [{"from": "inputs.below", "to": "lit.below"}, {"from": "lit", "to": "outputs.below"}]
     }}}"#;
    let mut hand = opened(&home, "shot.json");
    std::fs::write(home.file("look.json"), grouped).unwrap();
    hand.app_mut().open(&home.file("shot.json"));
    hand.settle();
    let errors = hand.errors();
    assert!(errors.is_empty(), "{errors:?}");
    let set = |value: f64| Edit::SetValue {
        graph: GraphId::Definition("twice".into()),
        id: "lit".into(),
        port: "opacity".into(),
        value: Value::Number(value),
        index: None,
    };
    // From outside nobody knows which one is meant.
    let problem = hand.app_mut().session_mut().apply(set(0.25), None).unwrap_err();
    assert!(problem.message.contains("`one`, `two`") && problem.message.contains("open the node"));
    let session = hand.app_mut().session_mut();
    session.open_graph(&["two".into()]);
    session.apply(set(0.25), None).unwrap();
    session.apply(set(0.75), None).unwrap();
    hand.settle();
    let told: Vec<(&str, Option<&Value>)> =
        shot(&hand).overrides.iter().map(|it| (it.target.as_str(), it.value.as_ref())).collect();
    assert_eq!(told, [("two/lit.opacity", Some(&Value::Number(0.75)))]);
    // The row of the open copy is set as any other: it stays a value.
    session_time(&mut hand, 1.0);
    let keys = hand.look().time_keys[0].clone();
    let mut keys = keys;
    keys.keys[0].value = Value::Number(0.125);
    let edit = Edit::SetTimeKeys { index: 0, keys };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.settle();
    assert_eq!(shot(&hand).overrides[0].value, Some(Value::Number(0.125)));
    assert!(shot(&hand).overrides[0].keys.is_empty());
}

fn session_time(hand: &mut User, time: f64) {
    hand.app_mut().session_mut().set_time(time);
    hand.settle();
}

#[test]
fn a_cell_is_taken_from_the_picture_of_its_sheet() {
    let home = Home::new();
    let mut hand = opened(&home, "scene.json");
    let mut sheet = image::RgbImage::new(220, 80);
    for x in 120..200 {
        (20..60).for_each(|y| sheet.put_pixel(x, y, image::Rgb([255, 0, 0])));
    }
    sheet.save(home.file("wedge.png")).unwrap();
    let cells = r##"{"chiaro": "wedge", "document": "scene.json", "cells": [
        {"picture": "wedge/001.png", "place": [20, 20, 80, 40], "values": {"sun.intensity": 1.5}},
        {"picture": "wedge/002.png", "place": [120, 20, 80, 40],
         "values": {"sun.intensity": 3, "layer.opacity": 0.25}}]}"##;
    std::fs::write(home.file("wedge.json"), cells).unwrap();
    hand.app_mut().open(&home.file("wedge.png"));
    hand.settle();
    let name = "Cell 2: layer.opacity = 0.25, sun.intensity = 3";
    let name =
        if hand.has(name) { name } else { "Cell 2: sun.intensity = 3, layer.opacity = 0.25" };
    let [first, second] = [hand.place("Cell 1: sun.intensity = 1.5"), hand.place(name)];
    assert!(first.right() < second.left() && (first.height() - second.height()).abs() < 0.1);
    assert!(!hand.has("Node canvas"), "the sheet is shown in place of the graph");
    let opacity = |hand: &User| hand.look().graph.nodes["layer"].values["opacity"].clone();
    let before = (intensity(&hand), opacity(&hand));
    hand.click(second.center());
    hand.settle();
    assert_eq!((intensity(&hand), opacity(&hand)), (3.0, Value::Number(0.25)));
    assert!(hand.says("Set: "), "the status line tells what was set");
    // Look and scene were changed at once, and are at once as before.
    assert_eq!(hand.steps(), 1);
    assert_eq!(hand.app().session().steps().labels().count(), 1);
    hand.undo();
    assert_eq!((intensity(&hand), opacity(&hand)), before);
    assert_eq!(hand.steps(), 0);
    hand.redo();
    assert_eq!((intensity(&hand), opacity(&hand)), (3.0, Value::Number(0.25)));
    assert_eq!(hand.steps(), 1);
    hand.undo();
    assert_eq!((intensity(&hand), opacity(&hand)), before);
    hand.key(Key::Escape);
    hand.settle();
    assert!(hand.has("Node canvas"));
    assert!(hand.place(name).width() < second.width(), "small, in the panel");
    // Without its picture, the list is there.
    std::fs::remove_file(home.file("wedge.png")).unwrap();
    hand.app_mut().open(&home.file("wedge.json"));
    hand.settle();
    assert!(hand.says("wedge.png, the sheet, is not there") && !hand.has(name));
    let row = hand.place_like("1  sun.intensity = 1.5").center();
    hand.click(row);
    hand.settle();
    assert_eq!(intensity(&hand), 1.5);
}

/// The shot's cameras of some frames, as they are drawn from its file.
fn cameras(home: &Home) -> Vec<Camera> {
    let setup = open(&home.file("shot.json"), None, &mut Assets::default()).unwrap().value;
    (0..=48).step_by(3).map(|frame| setup.seen_camera(f64::from(frame) / 24.0)).collect()
}

#[test]
fn the_camera_of_a_file_has_a_track_and_becomes_keys_of_the_shot() {
    const SWAYING: &str = r#"{"chiaro": "scene",
     "objects": [{"id": "sprout", "mesh": "sprout.glb", "animation": {"name": "sway"},
      "transform": {"fit": false}, "looks": "look.json"}],
     "camera": {"eye": [0, 2.15, 7], "target": [0, 1.3, 0]},
     "file_camera": {"object": "sprout", "name": "shot"}}"#;
    let home = Home::new();
    write(&home, &[("look.json", LOOK), ("scene.json", SWAYING), ("shot.json", SHOT)]);
    let mesh = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/meshes/sprout.glb");
    std::fs::copy(mesh, home.file("sprout.glb")).unwrap();
    let before = cameras(&home);
    assert_ne!(before[0].eye, before[8].eye, "the file moves it");
    let mut hand = home.window(Some(&home.file("shot.json")));
    hand.settle();
    show_timeline(&mut hand);
    hand.settle();
    assert!(hand.has("Track in sprout.glb: camera shot"));
    assert!(hand.has("Track in sprout.glb: clip sway of sprout"));
    hand.press("Make keys of it");
    let named = |hand: &User| -> Vec<(String, usize)> {
        shot(hand).overrides.iter().map(|it| (it.target.clone(), it.keys.len())).collect()
    };
    let [(eye, eyes), (target, targets), (up, ups)] = named(&hand).try_into().unwrap();
    assert_eq!([&*eye, &*target, &*up], ["camera.eye", "camera.target", "camera.up"]);
    assert!((2..25).contains(&eyes) && targets <= eyes, "{eyes} and {targets} of 49 frames");
    assert_eq!(ups, 0, "it does not lean");
    assert!(hand.has("Keys of the shot stand over it") && hand.steps() == 1);
    assert!(hand.has("Frame key 1 of Camera: Eye"));
    // Pictures are drawn from where they were.
    save(&mut hand);
    for (was, is) in before.iter().zip(cameras(&home)) {
        let off = |a: [f64; 3], b: [f64; 3]| (0..3).map(|at| (a[at] - b[at]).abs()).sum::<f64>();
        assert!(off(was.eye, is.eye) < 0.02 && off(was.target, is.target) < 0.02, "{is:?}");
        assert_eq!((was.fov, was.aspect), (is.fov, is.aspect), "the lens is the file's");
    }
    hand.undo();
    hand.settle();
    assert!(named(&hand).is_empty() && hand.has("Make keys of it"));
}

#[test]
fn the_timeline_of_a_shot_counts_frames() {
    let home = Home::new();
    let mut hand = opened(&home, "shot.json");
    show_timeline(&mut hand);
    assert!(!hand.has("Frame rate"), "the shot has a rate of its own");
    let frame = hand.fields_called("Frame at the playhead")[0];
    hand.type_over(frame, "36");
    hand.settle();
    assert_eq!(hand.app().session().view().time(), 1.5);
    // What is keyed stands in the first row, beside the frames.
    let [play, key] = ["Play", "Key a value"].map(|name| hand.place(name).center().y);
    assert!((play - key).abs() < 4.0, "{play} and {key}");
}

#[test]
fn what_a_shot_says_over_its_sequence_is_reset() {
    const NEAR: &str = r#"{"chiaro": "shot", "scene": "shot.json", "step": 2,
     "overrides": [{"target": "backdrop", "value": [1, 0, 0, 1]},
      {"target": "camera.fov", "keys": [{"frame": 0, "value": 0.5}, {"frame": 8, "value": 1}]}]}"#;
    let home = Home::new();
    write(&home, &FILES);
    write(&home, &[("near.json", NEAR)]);
    let mut hand = home.window(Some(&home.file("near.json")));
    hand.settle();
    hand.tab("Shot");
    assert!(hand.says("set to #ff0000"), "a color is told as fields have it");
    assert!(hand.says("keyed to 0.5 at 0, 1 at 8"), "and keys with their frames");
    hand.press("Changed by the shot: Shading on");
    hand.press("Reset to the sequence's");
    assert_eq!((shot(&hand).step, hand.steps()), (None, 1));
    assert!(!hand.has("Changed by the shot: Shading on"));
}

#[test]
fn a_light_of_the_scene_is_varied_by_a_click() {
    let home = Home::new();
    let mut hand = opened(&home, "scene.json");
    command(&mut hand, "Variations...");
    hand.choose("Vary", "sun: Intensity");
    hand.press("Take 0.4");
    hand.settle();
    assert_eq!(intensity(&hand), 0.4);
    hand.undo();
    assert_eq!(intensity(&hand), 0.8, "one step");
}

#[test]
fn outputs_of_nodes_are_picked_as_layers_of_frames() {
    let home = Home::new();
    let mut hand = opened(&home, "scene.json");
    command(&mut hand, "Render frames");
    let pick = |hand: &mut User, search: &str, entry: &str| {
        hand.bring(Role::Button, "Add an output");
        hand.press_a(Role::Button, "Add an output");
        let field = hand.place_of(Role::TextInput, "Find an output");
        hand.click(field.center());
        hand.type_text(search);
        hand.settle();
        hand.press_a(Role::Button, entry);
    };
    let copied = |hand: &mut User| {
        hand.bring(Role::Button, "Copy the command that renders");
        hand.press_a(Role::Button, "Copy the command that renders");
        hand.take_copied().unwrap()
    };
    pick(&mut hand, "tone", "Light layer: Tone");
    let told = copied(&mut hand);
    assert!(told.ends_with("--aov layer_tone=layer.tone"), "{told}");
    hand.bring(Role::Button, "Take layer.tone away");
    hand.press_a(Role::Button, "Take layer.tone away");
    assert!(!copied(&mut hand).contains("--aov"));
    // What is not there is told with what is near.
    pick(&mut hand, "layr.tone", "layer.tone");
    assert!(copied(&mut hand).ends_with("--aov layer_tone=layer.tone"));
}

#[test]
fn a_kept_view_moves_the_eye_alone_and_an_object_is_keyed_from_the_list() {
    let home = Home::new();
    let mut hand = opened(&home, "shot.json");
    let targets = |hand: &User| -> Vec<String> {
        shot(hand).overrides.iter().map(|it| it.target.clone()).collect()
    };
    hand.tab("Shot");
    let corner = hand.place_of(Role::Canvas, "Picture").left_top() + vec2(30.0, 120.0);
    hand.drag(corner, corner + vec2(60.0, 0.0));
    hand.settle();
    let follows = |hand: &User| {
        let look = hand.harness.get_by_label("Look through the shot's camera");
        look.accesskit_node().is_disabled()
    };
    assert!(!follows(&hand), "the view was turned");
    hand.press("Keep this view");
    assert!(follows(&hand), "the picture is the shot's camera's again");
    let kept = targets(&hand);
    assert!(kept.contains(&"camera.eye".to_owned()), "{kept:?}");
    let lens = ["camera.fov", "camera.aspect", "camera.height"];
    assert!(kept.iter().all(|target| !lens.contains(&target.as_str())), "{kept:?}");
    hand.undo();
    hand.settle();
    assert!(targets(&hand).is_empty(), "one step");
    hand.app_mut().session_mut().select_object(Some("ball".into()));
    show_timeline(&mut hand);
    hand.settle();
    hand.press("Key a value");
    hand.bring(Role::Button, "ball: Place");
    hand.press("ball: Place");
    let told = hand.app().message().map(str::to_owned);
    assert_eq!(targets(&hand), ["objects.ball.transform.translate"], "{told:?}");
    assert_eq!(shot(&hand).overrides[0].keys.len(), 1);
}

#[test]
fn what_is_typed_over_a_list_of_values_searches_the_list() {
    let home = Home::new();
    let mut hand = opened(&home, "shot.json");
    show_timeline(&mut hand);
    let canvas = hand.empty_place();
    hand.press("Key a value");
    // The pointer stays over the canvas, whose single keys are m and i, too.
    hand.hover(canvas);
    hand.type_text("intensi");
    hand.key(Key::M);
    hand.settle();
    assert!(hand.has("sun of the scene: Intensity"), "{:?}", hand.names());
    assert!(!hand.has("sun of the scene: Color"), "{:?}", hand.names());
    assert_eq!(hand.steps(), 0, "nothing was muted");
    hand.key(Key::Enter);
    hand.settle();
    let targets: Vec<String> =
        shot(&hand).overrides.iter().map(|change| change.target.clone()).collect();
    assert_eq!(targets, ["lights.sun.intensity"]);
}

#[test]
fn lights_of_a_look_that_the_scene_replaces_are_not_offered() {
    let home = Home::new();
    let own = r#""lights": {"sun": {"direction": [0, 0, 1]}, "#;
    let look = LOOK.replacen(r#""lights": {"#, own, 1);
    write(&home, &[("look.json", &look), ("scene.json", SCENE), ("shot.json", SHOT)]);
    let mut hand = home.window(Some(&home.file("shot.json")));
    hand.settle();
    show_timeline(&mut hand);
    hand.press("Key a value");
    hand.type_text("direction");
    hand.settle();
    assert!(hand.has("sun of the scene: Direction"), "{:?}", hand.names());
    assert!(hand.has("key: Direction"), "{:?}", hand.names());
    assert!(!hand.has("sun: Direction"), "{:?}", hand.names());
    let [scene, look] =
        ["sun of the scene: Direction", "key: Direction"].map(|name| hand.place(name).center().y);
    assert!(scene < look);
}

#[test]
fn the_timeline_has_the_frames_and_the_rate_of_the_shot_after_undo_too() {
    let home = Home::new();
    let mut hand = opened(&home, "shot.json");
    show_timeline(&mut hand);
    hand.settle();
    assert_eq!(range(&hand), [0.0, 48.0]);
    hand.app_mut().session_mut().set_time(0.5);
    for edit in [
        ShotEdit::SetFrames { frames: Some([0, 12]) },
        ShotEdit::SetRate { rate: Some("24000/1001".parse().unwrap()) },
    ] {
        hand.app_mut().session_mut().apply_to_shot(edit, None).unwrap();
        hand.settle();
    }
    assert_eq!(range(&hand), [0.0, 12.0]);
    let frame = |hand: &User| hand.app().session().view().time() * 24000.0 / 1001.0;
    assert!((frame(&hand) - 12.0).abs() < 1e-4, "{}", frame(&hand));
    hand.undo();
    hand.undo();
    hand.settle();
    assert_eq!(range(&hand), [0.0, 48.0]);
    assert_eq!(hand.app().session().view().time(), 0.5, "frame 12 again");
    hand.redo();
    hand.settle();
    assert_eq!(range(&hand), [0.0, 12.0]);
}

/// Number of a field, as it is told.
fn number(hand: &User, label: &str) -> f64 {
    let field = hand.harness.get_by_role_and_label(Role::SpinButton, label);
    let number = || Some(field.accesskit_node().numeric_value()?.to_string());
    let text = field.value().or_else(number).unwrap();
    text.trim_matches(|sign: char| !sign.is_ascii_digit() && sign != '-').parse().unwrap()
}

#[test]
fn another_name_of_a_varied_value_brings_ends_of_its_own() {
    let home = Home::new();
    let mut hand = opened(&home, "shot.json");
    command(&mut hand, "Wedge: try values side by side...");
    hand.press("Add a value");
    hand.type_text("sun intensity");
    hand.key(Key::Enter);
    hand.settle();
    let end = hand.fields_called("sun.intensity to")[0];
    hand.type_over(end, "7");
    assert_eq!(number(&hand, "sun.intensity to"), 7.0);
    let name = hand.text_field("Value 1");
    hand.type_over(name, "layer.opacity");
    hand.settle();
    assert_eq!(number(&hand, "layer.opacity to"), 0.75, "around one half");
}

#[test]
fn an_end_of_the_frames_leaves_the_other_where_it_is() {
    let home = Home::new();
    let mut hand = opened(&home, "shot.json");
    let last = hand.fields_called("Last frame")[0];
    for (typed, frames) in [("-5", [0, 0]), ("24", [0, 24])] {
        hand.type_over(last, typed);
        hand.settle();
        assert_eq!(shot(&hand).frames, Some(frames));
    }
    let first = hand.fields_called("First frame")[0];
    hand.type_over(first, "90");
    hand.settle();
    assert_eq!(shot(&hand).frames, Some([24, 24]));
}

#[test]
fn the_view_menu_opens_the_panels_for_film() {
    let home = Home::new();
    let mut hand = opened(&home, "shot.json");
    hand.press("View");
    hand.press("Panels for film");
    hand.settle();
    hand.press("View");
    for panel in ["Timeline", "Shot", "Render"] {
        let of_panel = hand.harness.get_by_role_and_label(Role::CheckBox, panel);
        assert_eq!(of_panel.accesskit_node().toggled(), Some(Toggled::True), "{panel}");
    }
}
