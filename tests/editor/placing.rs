//! A light is placed by what it does, by clicks and drags on the picture, and the probe reads there
//! what was asked for.

use std::fs;

use chiaro::document::{Edit, GraphId, Light, LightKind, Value};
use eframe::egui::{Key, Pos2, vec2};
use egui_kittest::kittest::Queryable as _;
use glam::{DQuat, DVec3};

use crate::editor_support::{User, node_center};

/// A window with a new look on a ball, its layer selected.
fn on_ball() -> User {
    let mut hand = User::new();
    hand.app_mut().show_on("shape:sphere");
    hand.click(node_center(&hand, "diffuse"));
    hand.key(Key::Escape);
    hand.settle();
    hand
}

/// A point of the picture, in heights from its middle.
fn at(hand: &User, x: f32, y: f32) -> Pos2 {
    let rect = hand.app().viewport().rect().unwrap();
    rect.center() + vec2(x, -y) * rect.height()
}

fn key(hand: &User) -> Light {
    hand.look().lights["key"].clone()
}

/// Numbers of a node at a point of the picture, as the probe reads them.
fn probed(hand: &mut User, point: Pos2, node: &str) -> Vec<f64> {
    hand.press("Probe pixel");
    hand.click(point);
    hand.settle();
    let wires = hand.app().probe().wires();
    let mut of_node = wires.iter().rev().filter(|wire| wire.node.to_string() == node);
    let numbers = of_node.next().unwrap_or_else(|| panic!("{node}: {wires:?}")).double.clone();
    hand.press("Probe pixel");
    numbers
}

#[test]
fn the_terminator_goes_where_the_model_is_clicked() {
    let mut hand = on_ball();
    let (old, steps) = (key(&hand), hand.app().session().steps().done());
    let place = at(&hand, 0.12, 0.05);
    hand.press("Place light");
    hand.press("Place by its terminator");
    hand.click(place);
    hand.settle();
    assert!(hand.app().placing().hint().starts_with("The terminator of"));
    assert_eq!(hand.app().session().steps().done(), steps + 1, "a click is a step");
    assert_ne!(key(&hand), old);
    let tone = probed(&mut hand, place, "diffuse/tone");
    assert!((tone[0] - 0.5).abs() < 1e-4, "{tone:?}");
    assert!(!hand.app().placing().is_on(), "the probe has the pointer now");
    hand.undo();
    assert_eq!(key(&hand), old);
}

#[test]
fn a_light_follows_a_drag_and_escape_gives_it_back() {
    let mut hand = on_ball();
    let (old, steps) = (key(&hand), hand.app().session().steps().done());
    hand.press("Place light");
    let points = [(0.0, 0.1), (0.05, 0.1), (0.1, 0.12)].map(|(x, y)| at(&hand, x, y));
    hand.hold(points[0]);
    hand.settle();
    let first = key(&hand);
    hand.move_to(points[1]);
    hand.settle();
    assert!(key(&hand) != first && first != old, "it follows");
    assert_eq!(hand.app().session().steps().done(), steps + 1);
    hand.key(Key::Escape);
    assert_eq!((key(&hand), hand.app().session().steps().done()), (old.clone(), steps));
    hand.release(points[1]);
    hand.settle();
    assert_eq!(key(&hand), old, "nothing comes after it");
    assert!(hand.app().placing().is_on());
    hand.drag(points[0], points[2]);
    hand.settle();
    assert_eq!(hand.app().session().steps().done(), steps + 1, "a drag is one step");
    let angle = probed(&mut hand, points[2], "diffuse/angle");
    assert!(2.0 * angle[0].atan2(angle[1]) < 1e-4, "{angle:?}");
    hand.undo();
    assert_eq!(key(&hand), old);
}

#[test]
fn what_cannot_be_says_why_and_changes_nothing() {
    let mut hand = on_ball();
    hand.press("Place light");
    let (old, beside) = (key(&hand), at(&hand, 0.4, -0.4));
    hand.click(beside);
    hand.settle();
    assert!(hand.app().placing().hint().starts_with("Nothing is there"));
    hand.press("Place by its terminator");
    let place = at(&hand, 0.1, 0.1);
    // An ambient profile has no edge.
    for port in ["offset", "falloff", "cutoff"] {
        let value = Value::Number(std::f64::consts::PI);
        let (graph, id) = (GraphId::Look, "diffuse".into());
        let edit = Edit::SetValue { graph, id, port: port.into(), value, index: None };
        hand.app_mut().session_mut().apply(edit, None).unwrap();
    }
    hand.click(place);
    hand.settle();
    let hint = hand.app().placing().hint().to_owned();
    assert!(hint.contains("is ambient"), "{hint}");
    assert_eq!(key(&hand), old);
    hand.key(Key::Escape);
    assert!(!hand.app().placing().is_on());
}

#[test]
fn the_lamp_of_a_scene_goes_where_its_shadow_falls() {
    let folder = tempfile::tempdir().unwrap();
    let look = r#"{"lights": {"key": {"direction": [-0.5, 0.7, 0.6]}},
        "nodes": [{"id": "shadow", "kind": "cast_shadow", "values": {"light": "key"}},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "shadow", "to": "output.color"}]}"#;
    fs::write(folder.path().join("look.json"), look).unwrap();
    let scene = r#"{"chiaro": "scene",
        "lights": {"key": {"type": "point", "space": "world", "position": [0, 4, 1]}},
        "objects": [
            {"id": "ball", "mesh": "shape:sphere", "looks": "look.json",
                "transform": {"translate": [-0.8, 0, 0], "scale": [0.4, 0.4, 0.4]}},
            {"id": "wall", "mesh": "shape:plane", "looks": "look.json",
                "transform": {"translate": [0, 0, -1], "scale": [4, 4, 4]}}],
        "camera": {"eye": [0, 0, 6]}}"#;
    let path = folder.path().join("scene.json");
    fs::write(&path, scene).unwrap();
    let mut hand = User::with(move |ctx| {
        let mut app = chiaro::editor::App::new(ctx, None).without_dialogs();
        app.open(&path);
        app
    });
    hand.settle();
    let lamp =
        |hand: &User| hand.app().session().open_scene().unwrap().scene().lights["key"].clone();
    let old = lamp(&hand);
    hand.press("Place light");
    hand.press("Place by its shadow");
    assert!(hand.app().placing().hint().starts_with("Click what casts the shadow"));
    let (caster, shadow) = (at(&hand, -0.22, 0.0), at(&hand, 0.2, -0.1));
    hand.click(caster);
    hand.settle();
    assert_eq!(lamp(&hand), old);
    assert!(hand.app().placing().hint().contains("where the shadow"));
    hand.click(shadow);
    hand.settle();
    let new = lamp(&hand);
    assert!(new.position != old.position && hand.app().placing().hint().contains("distance"));
    hand.key(Key::Escape);
    assert!(hand.app().placing().hint().starts_with("Click what casts the shadow"));
    let value = probed(&mut hand, shadow, "shadow");
    assert!((value[0] - 1.0).abs() < 1e-4, "{value:?}");
    hand.undo();
    assert_eq!(lamp(&hand), old, "one step");
}

#[test]
fn the_probe_tells_why_a_pixel_is_lit_so() {
    let folder = tempfile::tempdir().unwrap();
    let look = r#"{"lights": {"key": {"direction": [0, 0, 1]}, "rim": {"direction": [1, 0, 0]}},
        "nodes": [{"id": "base", "kind": "base"},
            {"id": "first", "kind": "light_layer", "values": {"light": "key"}},
            {"id": "second", "kind": "light_layer", "values": {"light": "rim"}},
            {"id": "shadow", "kind": "cast_shadow", "values": {"light": "key"}},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "base", "to": "first.below"}, {"from": "first", "to": "second.below"},
            {"from": "shadow", "to": "second.opacity"},
            {"from": "second", "to": "output.color"}]}"#;
    fs::write(folder.path().join("look.json"), look).unwrap();
    let scene = r#"{"chiaro": "scene",
        "lights": {"key": {"space": "world", "direction": [0, 3, 4], "intensity": 0.5,
                "groups": ["set"]},
            "fill": {"type": "point", "space": "world", "position": [0, 0, 3],
                "half_distance": 2}},
        "light_groups": {"set": {"intensity": 0.5}}, "muted": "fill",
        "objects": [{"id": "wall", "mesh": "shape:plane", "looks": "look.json",
            "unlinked": "rim"}],
        "camera": {"eye": [0, 0, 3]}}"#;
    let path = folder.path().join("scene.json");
    fs::write(&path, scene).unwrap();
    let mut hand = User::with(move |ctx| {
        let mut app = chiaro::editor::App::new(ctx, None).without_dialogs();
        app.open(&path);
        app
    });
    hand.settle();
    hand.press("Probe pixel");
    let place = at(&hand, 0.05, 0.05);
    hand.click(place);
    hand.settle();
    let lights = hand.app().probe().lights();
    let ids: Vec<&str> = lights.iter().map(|account| account.light.as_str()).collect();
    assert_eq!(ids[0], "key", "what reaches the pixel comes first: {lights:?}");
    let of = |id: &str| lights.iter().find(|account| account.light.as_str() == id).unwrap();
    // White, half as bright, behind a master of a half; the wall looks to +z.
    let key = of("key");
    assert!(key.reaches && (key.energy - 0.25).abs() < 1e-9, "{key:?}");
    assert!((key.facing - 0.8_f64.acos()).abs() < 1e-6, "{key:?}");
    let tone = key.readings.iter().find(|reading| reading.node.to_string() == "first/tone");
    assert!((tone.unwrap().value - 0.8).abs() < 1e-6, "{key:?}");
    assert!(key.readings.iter().any(|reading| reading.label == "Shadow" && reading.value == 0.0));
    let [rim, fill] = ["rim", "fill"].map(of);
    assert!(!rim.reaches && rim.rule.contains("unlinked"), "{rim:?}");
    assert!(!fill.reaches && fill.rule.contains("muted"), "{fill:?}");
    assert!(rim.readings.is_empty() && fill.energy == 0.0);
    hand.press("Why lit so");
    assert!(hand.says("Light rim does not reach the pixel"), "a row for each");
    assert!(hand.says("Light key reaches the pixel"));
}

/// Place of a point of the world on the screen.
fn on_screen(hand: &User, point: DVec3) -> Pos2 {
    let orbit = hand.app().session().view().orbit();
    let (right, up) = orbit.right_and_up();
    let from_eye = point - (orbit.target + orbit.direction() * orbit.distance);
    let span = 2.0 * -from_eye.dot(orbit.direction()) * (orbit.fov / 2.0).tan();
    at(hand, (from_eye.dot(right) / span) as f32, (from_eye.dot(up) / span) as f32)
}

#[test]
fn a_light_is_looked_through_and_goes_with_the_view() {
    let mut hand = on_ball();
    let (old, before) = (key(&hand), hand.app().session().view().orbit().clone());
    let steps = hand.app().session().steps().done();
    let beside = at(&hand, 0.4, -0.4);
    hand.hover(beside);
    hand.key(Key::O);
    hand.settle();
    assert!(hand.app().viewport().is_looking_through());
    let view = |hand: &User| hand.app().session().view().orbit().direction();
    assert!(view(&hand).distance(DVec3::from(old.direction).normalize()) < 1e-9);
    assert_eq!(hand.app().session().steps().done(), steps, "to look is no edit");
    hand.drag(beside, beside + vec2(-60.0, 30.0));
    hand.settle();
    let moved = DVec3::from(key(&hand).direction);
    assert!(moved.distance(view(&hand)) < 1e-5 && key(&hand) != old, "it goes with the view");
    assert_eq!(hand.app().session().steps().done(), steps + 1);
    hand.undo();
    hand.settle();
    assert_eq!(key(&hand), old);
    assert!(view(&hand).distance(DVec3::from(old.direction).normalize()) < 1e-9, "and back");
    hand.press("Back to the camera");
    let after = hand.app().session().view().orbit();
    assert!(!hand.app().viewport().is_looking_through());
    assert_eq!(
        (after.yaw, after.pitch, after.distance),
        (before.yaw, before.pitch, before.distance)
    );
}

#[test]
fn the_handles_of_a_spot_move_and_aim_it() {
    let mut hand = on_ball();
    let spot = Light {
        kind: LightKind::Spot,
        position: [0.9, 0.75, 0.3],
        aim: [-0.2, -1.0, 0.0],
        outer: 0.4,
        inner: 0.2,
        ..key(&hand)
    };
    let edit = Edit::SetLight { id: "key".into(), light: spot.clone() };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.settle();
    let steps = hand.app().session().steps().done();
    let from = on_screen(&hand, spot.position.into());
    let to = from + vec2(20.0, -40.0);
    hand.drag(from, to);
    hand.settle();
    let place = DVec3::from(key(&hand).position);
    assert!(on_screen(&hand, place).distance(to) < 1.0, "under the pointer");
    assert!((place.z - 0.3).abs() < 1e-3, "at its depth: {place}");
    assert_eq!(hand.app().session().steps().done(), steps + 1);
    // The end of the axis: 0.6 radii of the ball from the lamp.
    let aim = DVec3::from(spot.aim).normalize();
    let (from, wanted) = (place + aim * 0.6, DVec3::new(-0.5, -0.9, 0.0).normalize());
    let [from, to] = [from, place + wanted * 0.6].map(|point| on_screen(&hand, point));
    hand.drag(from, to);
    let found = DVec3::from(key(&hand).aim).normalize();
    assert!(found.angle_between(wanted) < 0.03, "{found}");
    // The rim of the whole cone, to the side of its axis in the picture.
    let rim = |angle: f64| place + DQuat::from_rotation_z(angle) * found * 0.6;
    let [from, to] = [0.4, 0.7].map(|angle| on_screen(&hand, rim(angle)));
    hand.drag(from, to);
    assert!((key(&hand).outer - 0.7).abs() < 0.05, "{}", key(&hand).outer);
    assert_eq!(hand.app().session().steps().done(), steps + 3);
}

#[test]
fn handles_of_lights_have_names_and_go_by_arrow_keys() {
    let mut hand = on_ball();
    let beside = at(&hand, 0.4, -0.4);
    hand.hover(beside);
    hand.settle();
    let (old, steps) = (key(&hand), hand.app().session().steps().done());
    hand.harness.get_by_label("Needle of key").focus();
    hand.harness.run_steps(2);
    hand.key(Key::ArrowRight);
    hand.settle();
    assert_ne!(key(&hand).direction, old.direction);
    assert_eq!(hand.app().session().steps().done(), steps + 1);
    hand.undo();
    assert_eq!(key(&hand), old);
}

#[test]
fn an_aimed_light_moves_around_its_object_by_its_needle() {
    let folder = tempfile::tempdir().unwrap();
    let look = r#"{"lights": {"key": {}},
        "nodes": [{"id": "layer", "kind": "light_layer", "values": {"light": "key"}},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "layer", "to": "output.color"}]}"#;
    fs::write(folder.path().join("look.json"), look).unwrap();
    let scene = r#"{"chiaro": "scene",
        "lights": {"key": {"space": "world", "direction": [1, 0, 0], "position": [2, 1.5, 2],
            "aimed_at": "ball"}},
        "objects": [{"id": "ball", "mesh": "shape:sphere", "looks": "look.json"}],
        "camera": {"eye": [0, 0, 6]}}"#;
    let path = folder.path().join("scene.json");
    fs::write(&path, scene).unwrap();
    let mut hand = User::with(move |ctx| {
        let mut app = chiaro::editor::App::new(ctx, None).without_dialogs();
        app.open(&path);
        app
    });
    hand.settle();
    let lamp =
        |hand: &User| hand.app().session().open_scene().unwrap().scene().lights["key"].clone();
    let old = lamp(&hand);
    let place = DVec3::from(old.position);
    // The needle ends 1.25 radii from the middle of the ball, toward the place.
    let from = on_screen(&hand, place.normalize() * 1.25);
    let wanted = DVec3::new(-0.5, 0.6, 0.62).normalize();
    let to = on_screen(&hand, wanted * 1.25);
    hand.drag(from, to);
    hand.settle();
    let new = lamp(&hand);
    assert_eq!((new.direction, &new.aimed_at), (old.direction, &old.aimed_at));
    let moved = DVec3::from(new.position);
    assert!((moved.length() - place.length()).abs() < 1e-3, "as far as before: {moved}");
    assert!(moved.angle_between(wanted) < 0.03, "{moved}");
    hand.undo();
    assert_eq!(lamp(&hand), old, "one step");
}

/// A window with a filter's node of a kind before the key light, which is selected.
fn with_filter(kind: &str, light: Light) -> User {
    let mut hand = on_ball();
    let edit = Edit::SetLight { id: "key".into(), light };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    let place = hand.empty_place();
    hand.add(kind, place);
    if hand.look().graph.nodes[kind].values.get("light").is_none() {
        let value = Value::Text("key".to_owned());
        let (graph, id) = (GraphId::Look, kind.into());
        let edit = Edit::SetValue { graph, id, port: "light".into(), value, index: None };
        let _ = hand.app_mut().session_mut().apply(edit, None);
    }
    hand.app_mut().session_mut().select(vec![kind.into()]);
    hand.settle();
    hand
}

/// Value of an input of the filter.
fn value_of(hand: &User, kind: &str, port: &str) -> Option<Value> {
    hand.look().graph.nodes[kind].values.get(port).cloned()
}

#[test]
fn filters_are_moved_turned_and_sized_in_the_picture() {
    let spot = Light {
        kind: LightKind::Spot,
        position: [0.6, 0.7, 0.9],
        aim: [-0.5, -0.6, -0.8],
        ..Light::default()
    };
    let number = |value: Option<Value>| match value {
        Some(Value::Number(number)) => number,
        other => panic!("{other:?}"),
    };
    let vector = |value: Option<Value>| match value {
        Some(Value::Vector(numbers)) => DVec3::from_slice(&numbers),
        other => panic!("{other:?}"),
    };
    let middle = |hand: &User, name: &str| hand.place(name).center();
    // What stands in the way: moved, sized, pointed elsewhere, turned; a step each.
    let mut hand = with_filter("blocker", spot.clone());
    let set = |hand: &mut User, port: &str, value: Value| {
        let (graph, id) = (GraphId::Look, "blocker".into());
        let edit = Edit::SetValue { graph, id, port: port.into(), value, index: None };
        hand.app_mut().session_mut().apply(edit, None).unwrap();
        hand.settle();
    };
    set(&mut hand, "center", Value::Vector(vec![0.1, 0.4, 0.5]));
    set(&mut hand, "toward", Value::Vector(vec![0.0, 0.0, 1.0]));
    set(&mut hand, "shape", Value::Text("box".to_owned()));
    let steps = hand.app().session().steps().done();
    let from = middle(&hand, "Center of Blocker");
    let to = from + vec2(30.0, 25.0);
    hand.drag(from, to);
    hand.settle();
    let center = vector(value_of(&hand, "blocker", "center"));
    assert!(on_screen(&hand, center).distance(to) < 1.0 && (center.z - 0.5).abs() < 1e-3);
    let (from, wanted) = (middle(&hand, "Width of Blocker"), center + DVec3::X * 0.5);
    let to = on_screen(&hand, wanted);
    hand.drag(from, to);
    hand.settle();
    let size = vector(value_of(&hand, "blocker", "size"));
    assert!(
        (size.x - 0.5).abs() < 0.01 && close_to(size.y, 0.3) && close_to(size.z, 0.3),
        "{size}"
    );
    let from = middle(&hand, "Spin of Blocker");
    let turned = DQuat::from_rotation_z(0.6) * DVec3::X * 0.7;
    let to = on_screen(&hand, center + turned);
    hand.drag(from, to);
    hand.settle();
    assert!((number(value_of(&hand, "blocker", "spin")) - 0.6).abs() < 0.02);
    assert_eq!(hand.app().session().steps().done(), steps + 3);
    for _ in 0..3 {
        hand.undo();
    }
    assert_eq!(value_of(&hand, "blocker", "size"), None, "as it was");
    // Flaps, a distance, a thrown picture.
    for (kind, handle, port) in [
        ("barn_doors", "Left flap of Barn doors", "left"),
        ("decay", "Start of Decay", "start"),
        ("distance_ramp", "Far from of Distance ramp", "far_from"),
        ("light_place", "Angle of Light place", "angle"),
        ("gobo", "Spin of Gobo", "spin"),
        ("rod", "Height of Rod", "size"),
    ] {
        let mut hand = with_filter(kind, spot.clone());
        let steps = hand.app().session().steps().done();
        let old = value_of(&hand, kind, port);
        let from = middle(&hand, handle);
        hand.drag(from, from + vec2(9.0, -14.0));
        hand.settle();
        let new = value_of(&hand, kind, port);
        assert!(new.is_some() && new != old, "{handle}: {new:?}");
        assert_eq!(hand.app().session().steps().done(), steps + 1, "{handle}");
        hand.undo();
        assert_eq!(value_of(&hand, kind, port), old, "{handle}");
        let focus = hand.harness.get_by_label(handle);
        focus.focus();
        hand.harness.run_steps(2);
        hand.key(Key::ArrowUp);
        hand.key(Key::ArrowLeft);
        hand.settle();
        assert_ne!(value_of(&hand, kind, port), old, "{handle} by keys");
    }
}

fn close_to(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-3
}
