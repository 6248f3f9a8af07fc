//! Library of parts in the window: a layer is saved from one look, found by its tag, and put into
//! another look, which says what was copied; undo takes it out again.

use std::fs;

use eframe::egui::{Key, Rect, Role};
use egui_kittest::kittest::Queryable as _;

use crate::editor_support::home::Home;
use crate::editor_support::{User, node_center};

const FROM: &str = r##"{"name": "From", "lights": {"key": {}, "back": {"name": "Moon"}}, "nodes": [
    {"id": "base", "kind": "base"},
    {"id": "tint", "kind": "color_value", "at": [0, 300]},
    {"id": "rim", "kind": "light_layer", "name": "Rim", "values": {"light": "back"},
      "at": [260, 0]},
    {"id": "output", "kind": "output", "at": [520, 0]}],
  "wires": [{"from": "base", "to": "rim.below"}, {"from": "tint", "to": "rim.convex"},
    {"from": "rim", "to": "output.color"}]}"##;

const TO: &str = r##"{"name": "To", "lights": {"key": {}}, "nodes": [
    {"id": "base", "kind": "base"},
    {"id": "body", "kind": "light_layer", "name": "Body", "values": {"light": "key"},
      "at": [300, 0]},
    {"id": "output", "kind": "output", "at": [600, 0]}],
  "wires": [{"from": "base", "to": "body.below"}, {"from": "body", "to": "output.color"}]}"##;

/// Layers of the look, from the Output down.
fn layers(hand: &User) -> Vec<String> {
    let graph = &hand.look().graph;
    let (mut node, mut port) = ("output".to_owned(), "color");
    let mut found = Vec::new();
    while let Some(wire) = graph.wire_into(&node.as_str().into(), &port.into()) {
        (node, port) = (wire.from.node.to_string(), "below");
        found.push(node.clone());
    }
    found
}

#[test]
fn a_layer_goes_from_one_look_to_another() {
    let home = Home::new();
    let [from, to] = ["from.json", "to.json"].map(|name| home.file(name));
    fs::write(&from, FROM).unwrap();
    fs::write(&to, TO).unwrap();
    let mut hand = home.window(Some(&from));
    hand.settle();
    hand.press("More of Rim");
    hand.press("Save to the library…");
    hand.settle();
    // The name has the focus, and is the layer's own to begin with.
    hand.type_text(" of the moon");
    let tags = hand.place_of(Role::TextInput, "Tags of the part").center();
    hand.click(tags);
    hand.type_text("edge silver");
    hand.press("Save layer");
    hand.settle();
    let told = hand.app().message().unwrap_or_default().to_owned();
    assert!(told.contains("The layer \"Rim of the moon\" is saved as"), "{told}");
    assert!(hand.has("Part Rim of the moon, layer"));

    // In the other look it is found by its tag, and a double click lays it over the layer that is
    // selected.
    hand.app_mut().open(&to);
    hand.settle();
    let body = node_center(&hand, "body");
    hand.click(body);
    let search = hand.place("Search parts").center();
    hand.click(search);
    hand.type_text("silv");
    hand.settle();
    assert!(!hand.has("Part Three-point light, lights"), "others are not found");
    let part = hand.place("Part Rim of the moon, layer").center();
    hand.double_click(part);
    hand.settle();
    assert_eq!(layers(&hand), ["rim", "body", "base"]);
    assert!(
        hand.look().graph.nodes.contains_key("tint") && hand.look().lights.contains_key("back")
    );
    let told = hand.app().message().unwrap_or_default().to_owned();
    assert!(told.contains("copied into this look, over Body · with its own light Moon"), "{told}");
    assert_eq!(hand.selected(), ["rim"]);
    hand.undo();
    assert_eq!(layers(&hand), ["body", "base"], "one step");
    assert!(!hand.look().lights.contains_key("back"));

    // Dropped on a wire it lies where the wire was.
    let (start, end) = (hand.output("base", "below"), hand.input("body", "below"));
    hand.drag(part, Rect::from_two_pos(start, end).center());
    hand.settle();
    assert_eq!(layers(&hand), ["body", "rim", "base"]);
    assert!(hand.app().message().unwrap_or_default().contains("between Base and Body"));

    // A damaged file is there, with the reason, and is put nowhere.
    let folder = home.places().config.join("library");
    fs::write(folder.join("bad.json"), "{").unwrap();
    hand.click(search);
    hand.key_with(eframe::egui::Modifiers::COMMAND, eframe::egui::Key::A);
    hand.type_text("bad");
    hand.press("Refresh");
    hand.settle();
    let bad = hand.place("Part bad, damaged").center();
    let before = hand.look().clone();
    hand.double_click(bad);
    hand.settle();
    let told = hand.app().message().unwrap_or_default().to_owned();
    assert!(told.contains("\"bad\" cannot be read") && *hand.look() == before, "{told}");
    assert!(hand.harness.query_by_label("Part Rim of the moon, layer").is_none());
}

#[test]
fn enter_in_a_field_of_a_new_part_saves_it() {
    let home = Home::new();
    let from = home.file("from.json");
    fs::write(&from, FROM).unwrap();
    let mut hand = home.window(Some(&from));
    hand.settle();
    hand.press("More of Rim");
    hand.press("Save to the library…");
    hand.settle();
    let tags = hand.place_of(Role::TextInput, "Tags of the part").center();
    hand.click(tags);
    hand.type_text("edge silver");
    hand.key(Key::Enter);
    hand.settle();
    let told = hand.app().message().unwrap_or_default().to_owned();
    assert!(told.contains("The layer \"Rim\" is saved as"), "{told}");
    assert!(hand.has("Part Rim, layer"));
}

#[test]
fn a_part_of_the_same_name_is_replaced_or_kept_and_its_menu_renames_and_removes_it() {
    let home = Home::new();
    let from = home.file("from.json");
    fs::write(&from, FROM).unwrap();
    let mut hand = home.window(Some(&from));
    hand.settle();
    let offer = |hand: &mut User| {
        hand.tab("Layers");
        hand.press("More of Rim");
        hand.press("Save to the library…");
        hand.settle();
    };
    let told = |hand: &User| hand.app().message().unwrap_or_default().to_owned();
    let count = || fs::read_dir(home.places().config.join("library")).unwrap().count();
    let asks = |hand: &User| hand.says("There is a part of this name already");
    offer(&mut hand);
    assert!(!asks(&hand));
    hand.press("Save layer");
    assert!(hand.has("Part Rim, layer"));

    // A second one of this name asks first.
    offer(&mut hand);
    assert!(asks(&hand) && !hand.has("Save layer"));
    hand.press("Replace");
    assert!(told(&hand).contains("it replaces what was there"), "{}", told(&hand));
    assert_eq!(count(), 1);
    offer(&mut hand);
    hand.press("Keep both");
    assert_eq!(count(), 2);

    // The menu of the first card changes that one alone.
    let search = hand.place("Search parts").center();
    hand.click(search);
    hand.type_text("rim");
    hand.settle();
    hand.press("More of the part Rim");
    assert!(hand.has("Show the file"));
    hand.press("Rename part");
    hand.type_text("Silver rim");
    hand.key(eframe::egui::Key::Enter);
    hand.settle();
    assert!(told(&hand).contains("\"Rim\" is called \"Silver rim\" now"), "{}", told(&hand));
    assert!(hand.has("Part Silver rim, layer") && hand.has("Part Rim, layer"));
    for (answer, left) in [("Cancel", 2), ("Remove", 1)] {
        hand.press("More of the part Silver rim");
        hand.press("Remove part…");
        assert!(hand.has("Remove \"Silver rim\" from the library?"));
        hand.press_a(Role::Button, answer);
        assert_eq!(count(), left, "{answer}");
    }
    let is_left = !hand.has("Part Silver rim, layer") && hand.has("Part Rim, layer");
    assert!(is_left, "{:?}", hand.names());
}

/// Layers to begin with are parts, and a folder that others share is chosen, away and taken off.
#[test]
fn presets_and_a_shared_folder_are_in_the_library() {
    let home = Home::new();
    let [look, shared] = ["to.json", "team"].map(|name| home.file(name));
    fs::write(&look, TO).unwrap();
    fs::create_dir(&shared).unwrap();
    let part = r#"{"name": "Team rim", "lights": {"key": {}}, "nodes": [
        {"id": "rim", "kind": "light_layer", "values": {"light": "key"}}]}"#;
    fs::write(shared.join("rim.json"), part).unwrap();
    let mut hand = home.window(Some(&look));
    hand.settle();
    hand.tab("Library");
    hand.press("Parts");
    let search = hand.place("Search parts").center();
    hand.click(search);
    hand.type_text("half");
    hand.settle();
    hand.bring(Role::Button, "Part Half-tone shadow, layer");
    let part = hand.place("Part Half-tone shadow, layer").center();
    hand.double_click(part);
    hand.settle();
    assert_eq!(layers(&hand), ["half_tone_shadow", "body", "base"]);
    hand.undo();
    hand.settle();

    hand.click(search);
    hand.key_with(eframe::egui::Modifiers::COMMAND, eframe::egui::Key::A);
    hand.type_text("team");
    hand.settle();
    assert!(!hand.has("Part Half-tone shadow, layer"));
    hand.app_mut().answer_dialog(&shared);
    hand.bring(Role::Button, "Choose a shared folder");
    hand.press("Choose a shared folder");
    hand.settle();
    assert!(hand.has("Part Team rim, layer"));
    fs::remove_dir_all(&shared).unwrap();
    hand.press("Refresh");
    hand.settle();
    assert!(!hand.has("Part Team rim, layer"));
    assert!(hand.says("Not there at the moment"));
    let take_off = format!("Take off {}", shared.display());
    hand.bring(Role::Button, &take_off);
    hand.press(&take_off);
    assert!(!hand.says("Not there at the moment"));
}

const SCENE: &str = r#"{"chiaro": "scene", "objects": [
    {"id": "ring", "mesh": "shape:torus", "transform": {"translate": [-2.5, 0, 0]},
      "looks": "to.json"},
    {"id": "ball", "mesh": "shape:sphere", "looks": "to.json"}],
  "camera": {"eye": [0, 0, 9]}}"#;

/// Types into the search of the parts.
fn search_parts(hand: &mut User, text: &str) {
    let search = hand.place("Search parts").center();
    hand.click(search);
    hand.key_with(eframe::egui::Modifiers::COMMAND, eframe::egui::Key::A);
    hand.type_text(text);
    hand.settle();
}

/// A look that is dropped on an object is worn by that object alone; a profile that is dropped on
/// an input shapes the selected node.
#[test]
fn parts_are_dropped_on_an_object_and_on_an_input() {
    let home = Home::new();
    let [look, scene] = ["to.json", "scene.json"].map(|name| home.file(name));
    fs::write(&look, TO).unwrap();
    fs::write(&scene, SCENE).unwrap();
    let library = home.places().config.join("library");
    fs::create_dir_all(&library).unwrap();
    fs::write(library.join("zebra.json"), TO.replace("\"To\"", "\"Zebra\"")).unwrap();
    let mut hand = home.window(Some(&scene));
    hand.settle();
    hand.tab("Library");
    hand.press("Parts");
    search_parts(&mut hand, "zebra");
    hand.bring(Role::Button, "Part Zebra, look");
    let part = hand.place("Part Zebra, look").center();
    // The ball stands in the middle of the picture.
    let ball = hand.app().viewport().rect().unwrap().center();
    hand.drag(part, ball);
    hand.settle();
    let worn = |hand: &User, id: &str| -> Vec<String> {
        let scene = hand.app().session().open_scene().expect("a scene").scene();
        scene.objects[id].looks.values().cloned().collect()
    };
    let [ring, dressed] = ["ring", "ball"].map(|id| worn(&hand, id));
    assert!(dressed.iter().all(|look| look.ends_with("zebra.json")), "{dressed:?}");
    assert_eq!(ring, ["to.json"], "the other object stays");
    let told = hand.app().message().unwrap_or_default().to_owned();
    assert!(told.contains("ball is linked to"), "{told}");
    hand.undo();
    hand.settle();
    assert_eq!(worn(&hand, "ball"), ["to.json"], "one step");

    hand.app_mut().session_mut().select(vec!["body".into()]);
    hand.settle();
    search_parts(&mut hand, "terminator");
    hand.bring(Role::Button, "Part Soft terminator, profile");
    let part = hand.place("Part Soft terminator, profile").center();
    let find = hand.place("Find a value");
    hand.type_over(find, "Offset");
    let row = hand.place("Keys of Offset").center();
    hand.drag(part, row);
    hand.settle();
    let values = &hand.look().graph.nodes["body"].values;
    let number = |port: &str| match values.get(port) {
        Some(chiaro::document::Value::Number(number)) => *number,
        other => panic!("{port}: {other:?}"),
    };
    assert_eq!(["offset", "falloff", "cutoff"].map(number), [0.35, 1.57, 2.7]);
    let told = hand.app().message().unwrap_or_default().to_owned();
    assert!(told.contains("\"Soft terminator\" is copied into Body"), "{told}");
    hand.undo();
    hand.settle();
    assert!(!hand.look().graph.nodes["body"].values.contains_key("cutoff"), "one step");
}
