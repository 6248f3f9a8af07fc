//! Objects of a scene are moved, turned and scaled by handles in the picture; a scene without a
//! camera opens with all of it in view, and a mesh that seems to lie is stood up when asked.

use std::path::Path;

use chiaro::document::Transform;
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, vec2};
use egui_kittest::kittest::Queryable as _;

use crate::editor_support::User;

/// Two balls, of which the second stands outside of the picture; no camera.
const SCENE: &str = r#"{"chiaro": "scene", "objects": [
    {"id": "ball", "mesh": "shape:sphere", "looks": "look.json"},
    {"id": "far", "mesh": "shape:sphere", "looks": "look.json",
     "transform": {"translate": [9, 0, 0]}}]}"#;
const LOOK: &str = r#"{"nodes": [{"id": "base", "kind": "base"}, {"id": "output",
    "kind": "output"}], "wires": [{"from": "base", "to": "output.color"}]}"#;

/// A look of which nothing has handles, in a window without a GPU.
fn opened(folder: &Path, name: &str) -> User {
    let mut hand = User::with(|ctx| chiaro::editor::App::new(ctx, None).without_dialogs());
    hand.app_mut().open(&folder.join(name));
    hand.settle();
    assert!(hand.errors().is_empty(), "{:?}", hand.errors());
    hand
}

fn transform(hand: &User, id: &str) -> Transform {
    hand.app().session().open_scene().expect("one is open").scene().objects[id].transform
}

#[test]
fn an_object_is_moved_turned_and_scaled_in_the_picture() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("look.json"), LOOK).unwrap();
    std::fs::write(folder.path().join("scene.json"), SCENE).unwrap();
    let mut hand = opened(folder.path(), "scene.json");
    let target = hand.app().session().view().orbit().target;
    assert!((target.x - 4.5).abs() < 0.01, "all of it is in view: {target}");
    assert!(hand.app().message().is_some_and(|text| text.contains("no camera")));

    hand.app_mut().session_mut().select_object(Some("ball".into()));
    hand.settle();
    let over = hand.app().viewport().rect().unwrap().center();
    hand.hover(over);
    hand.key(Key::W);
    let steps = hand.app().session().steps().done();
    let at = hand.place("Move ball along y").center();
    hand.drag(at, at + vec2(0.0, -40.0));
    let moved = transform(&hand, "ball");
    assert!(moved.translate[1] > 0.2 && moved.translate[0] == 0.0, "{moved:?}");
    assert_eq!(hand.app().session().steps().done(), steps + 1, "a drag is one step");
    hand.undo();
    assert_eq!(transform(&hand, "ball"), Transform::default());

    // Arrow keys move what was clicked last.
    let at = hand.place("Move ball along x").center();
    hand.click(at);
    hand.key(Key::ArrowRight);
    assert!(transform(&hand, "ball").translate[0] > 0.01);
    hand.undo();

    hand.hover(over);
    hand.key(Key::Q);
    assert!(!hand.has("Move ball along x"), "one part at a time");
    let at = hand.place("Turn ball around its z axis").center();
    hand.drag(at, at + vec2(-30.0, -30.0));
    let turned = transform(&hand, "ball");
    assert!(turned.rotate[2].abs() > 0.1 && turned.rotate[0].abs() < 1e-6, "{turned:?}");
    hand.undo();

    hand.press_a(Role::Tab, "Objects");
    hand.press_a(Role::Button, "Scale");
    let at = hand.place("Scale ball").center();
    hand.drag(at, at + vec2(20.0, -20.0));
    let [x, y, z] = transform(&hand, "ball").scale;
    assert!(x > 1.1 && x == y && y == z, "{x} {y} {z}");
}

#[test]
fn a_mesh_that_seems_to_lie_is_stood_up_when_asked() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("look.json"), LOOK).unwrap();
    let corners = "v -1 -1 -2\nv 1 -1 -2\nv 0 1 -2\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    let mesh = folder.path().join("bust.obj");
    std::fs::write(&mesh, corners).unwrap();
    let mut hand = opened(folder.path(), "look.json");
    hand.app_mut().show_on(mesh.to_str().unwrap());
    hand.settle();
    assert!(hand.says("seems to lie on its back"));
    hand.press("Stand up");
    hand.settle();
    assert!(hand.app().session().view().orbit().z_is_up);
    assert!(!hand.says("seems to lie on its back"));
    assert!(hand.harness.query_by_label("Leave it").is_none());
}
