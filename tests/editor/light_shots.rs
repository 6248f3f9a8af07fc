//! Pictures of panels and handles about lights, to be looked at as those of `shots`.

use std::path::PathBuf;

use chiaro::document::{Edit, GraphId, Light, LightKind, Node, Value};
use eframe::egui::{Key, Role, Theme, vec2};
use egui_kittest::kittest::Queryable as _;

use crate::editor_support::User;
use crate::shots::{save, window};

/// Opens a panel by the menu of panels.
fn show(hand: &mut User, panel: &str) {
    hand.press("View");
    hand.press_a(Role::CheckBox, panel);
    hand.key(Key::Escape);
    hand.settle();
}

/// The room of the examples, with keys of its lights by time and by direction, and with layers of
/// the figure that have lights of their own.
fn keyed_room(folder: &tempfile::TempDir) -> PathBuf {
    for (from, to) in [("looks/room-guest", "guest"), ("looks/room-walls", "walls")] {
        let path = folder.path().join(format!("{to}.json"));
        std::fs::copy(format!("examples/{from}.json"), path).unwrap();
    }
    let scene = r##"{"chiaro": "scene", "name": "Room", "objects": [
     {"id": "guest", "mesh": "shape:creature", "looks": "guest.json",
      "transform": {"translate": [0.1, 0, 0], "rotate": [0, 0.1305, 0, 0.9914]},
      "layers": [{"node": "lamps", "layered": "{source} - group:room"}]},
     {"id": "floor", "mesh": "shape:plane", "looks": "walls.json", "linked": "* - rim",
      "transform": {"translate": [0, -1, 0], "scale": [4, 4, 4],
       "rotate": [-0.7071, 0, 0, 0.7071]}},
     {"id": "wall", "mesh": "shape:plane", "looks": "walls.json",
      "transform": {"translate": [0, 0.6, -1.7], "scale": [4, 4, 4]}}],
     "lights": {
      "sun": {"name": "Sun in the window", "direction": [0.75, 0.62, 0.55], "space": "world",
       "color": [1, 0.83, 0.55], "groups": ["window"]},
      "fill": {"name": "Blue lamp", "type": "point", "position": [-1.4, 0.6, 1.2],
       "space": "world", "half_distance": 2.2, "color": [0.36, 0.45, 0.85],
       "intensity": 0.9, "groups": ["room"]},
      "rim": {"name": "Rim", "type": "spot", "position": [-1.0, 1.2, -0.6],
       "aim": [0.8, -1.0, 0.6], "space": "world", "inner": 0.5, "outer": 0.8,
       "color": [0.75, 0.5, 0.95], "groups": ["room"]}},
     "light_groups": {"window": {"name": "Window"}, "room": {"name": "Room"}},
     "direction_keys": [
      {"name": "Fill answers the sun", "by": {"light": "sun"}, "keys": [
       {"direction": [0.75, 0.62, 0.55], "values": {"lights.fill.intensity": 0.9}},
       {"direction": [-0.75, 0.62, 0.55], "values": {"lights.fill.intensity": 0.2}}]}],
     "time_keys": [
      {"target": "lights.rim.intensity", "keys": [{"time": 0, "value": 0.2},
       {"time": 1.5, "value": 1.4}, {"time": 3, "value": 0.6}]},
      {"target": "lights.rim.color", "keys": [{"time": 0.5, "value": [0.75, 0.5, 0.95]},
       {"time": 2.5, "value": [1, 0.6, 0.3]}]}],
     "camera": {"eye": [0.3, 0.35, 4.6], "target": [0, 0, 0], "fov": 0.5, "aspect": 1.5},
     "backdrop": "#15121d"}"##;
    let path = folder.path().join("room.json");
    std::fs::write(&path, scene).unwrap();
    path
}

fn room() -> (tempfile::TempDir, User) {
    let folder = tempfile::tempdir().unwrap();
    let path = keyed_room(&folder);
    let mut hand = window();
    hand.harness.set_size(vec2(1500.0, 900.0));
    hand.app_mut().open(&path);
    hand.settle();
    (folder, hand)
}

/// Every step of the tour, before and after it is done.
#[test]
#[ignore = "writes pictures to be looked at"]
fn lights_tour() {
    let mut hand = window();
    hand.harness.set_size(vec2(1500.0, 900.0));
    hand.app_mut().show_start_page();
    hand.settle();
    save(&mut hand, "lights-start");
    hand.press("Light a scene");
    for number in 1..=8 {
        save(&mut hand, &format!("lights-tour-{number}"));
        hand.press("Show me");
        save(&mut hand, &format!("lights-tour-{number}-done"));
        if number == 3 {
            // Over the rim while the button is held, and a camera that stands near.
            let rect = hand.app().viewport().rect().unwrap();
            hand.hover(rect.center());
            let needle = hand.place("Needle of Rim of the scene").center();
            hand.hold(needle);
            hand.move_to(needle + vec2(20.0, -10.0));
            save(&mut hand, "lights-needle-held");
            hand.key(Key::Escape);
            hand.release(needle);
            for _ in 0..5 {
                hand.wheel(rect.center(), 100.0);
            }
            save(&mut hand, "lights-needle-arrow");
            hand.key(Key::R);
        }
        hand.press("Next");
    }
    save(&mut hand, "lights-tour-end");
}

/// Panels about the lights of a scene.
#[test]
#[ignore = "writes pictures to be looked at"]
fn panels_of_lights() {
    let (_folder, mut hand) = room();
    hand.press("Object guest");
    hand.bring(Role::Button, "Add a layer's lights");
    save(&mut hand, "room-objects");
    show(&mut hand, "Light table");
    let solo = hand.place_of(Role::Cell, "Solo of Rim").center();
    hand.click(solo);
    save(&mut hand, "room-light-table");
    show(&mut hand, "Mixer");
    save(&mut hand, "room-mixer");
    hand.undo();
    show(&mut hand, "Timeline");
    save(&mut hand, "room-timeline");
    hand.tab("Keys");
    hand.press("Select key 2");
    save(&mut hand, "room-keys");
    show(&mut hand, "Links");
    hand.press_a(Role::ListItem, "Link light Rim");
    hand.press("Layers of guest");
    save(&mut hand, "room-links");
    hand.press_a(Role::ListItem, "Link layer Lamps");
    save(&mut hand, "room-links-of-a-layer");
    hand.press("Probe pixel");
    let center = hand.app().viewport().rect().unwrap().center();
    hand.click(center + vec2(-20.0, -10.0));
    hand.settle();
    hand.press("Why lit so");
    save(&mut hand, "room-why-lit");
    hand.harness.ctx.set_theme(Theme::Light);
    save(&mut hand, "room-why-lit-light");
}

/// Handles of lights and of every filter in the picture, and a picture through a light.
#[test]
#[ignore = "writes pictures to be looked at"]
fn handles_of_lights() {
    let kinds =
        ["gobo", "rod", "decay", "barn_doors", "distance_ramp", "blocker", "light_place", "spot"];
    for kind in kinds {
        let mut hand = window();
        hand.app_mut().show_on("shape:creature");
        let light = Light {
            kind: LightKind::Spot,
            position: [0.75, 0.8, 0.9],
            aim: [-0.6, -0.6, -0.8],
            range: 3.0,
            half_distance: 1.2,
            color: [1.0, 0.8, 0.5],
            ..Light::default()
        };
        let edit = Edit::SetLight { id: "key".into(), light };
        hand.app_mut().session_mut().apply(edit, None).unwrap();
        if kind == "spot" {
            hand.tab("Lights");
            let row = hand.place("Light key shines");
            hand.click(row.right_center() + vec2(44.0, 0.0));
        } else {
            let mut node =
                Node { kind: kind.to_owned(), position: [40.0, 260.0], ..Node::default() };
            if matches!(kind, "gobo" | "barn_doors" | "decay" | "distance_ramp" | "light_place") {
                node.values.insert("light".into(), Value::Text("key".into()));
            }
            if kind == "blocker" {
                node.values.insert("center".into(), Value::Vector(vec![0.2, 0.3, 0.6]));
            }
            let (graph, id) = (GraphId::Look, kind.into());
            let edit = Edit::AddNode { graph, id, node, index: None };
            hand.app_mut().session_mut().apply(edit, None).unwrap();
            hand.app_mut().session_mut().select(vec![kind.into()]);
        }
        hand.settle();
        let rect = hand.app().viewport().rect().unwrap();
        hand.hover(rect.center() + vec2(-150.0, 150.0));
        save(&mut hand, &format!("handles-{kind}"));
        if kind == "spot" {
            hand.key(Key::O);
            save(&mut hand, "look-through");
        }
    }
}

/// A look with cast shadows at the tier that takes them from maps.
#[test]
#[ignore = "writes pictures to be looked at"]
fn shadow_maps() {
    let mut hand = window();
    hand.app_mut().open(std::path::Path::new("examples/shadows/long-shadows.json"));
    hand.settle();
    hand.choose("Tier", "Balanced");
    save(&mut hand, "shadow-maps");
    let tab = hand.harness.get_by_role_and_label(Role::Tab, "Effects").rect().center();
    hand.click(tab);
    save(&mut hand, "shadow-maps-effects");
}
