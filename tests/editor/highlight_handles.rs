//! Handles that split a highlight, draw out its corners and make it a star, and the place of all of
//! them: on the highlight where it is seen, or at the rim where it is not.

use std::f64::consts::TAU;

use chiaro::document::{DirectionKey, Edit, GraphId, Target, Value};
use eframe::egui::{Key, Pos2, Vec2, vec2};
use egui_kittest::kittest::Queryable as _;

use crate::editor_support::User;
use crate::editor_support::home::Home;
use crate::editor_support::shots;

const LAYER: &str = "cut_highlight";

/// A window with a cut highlight on a ball: turned, split along its first axis, and squared.
fn on_ball() -> User {
    let mut hand = User::new();
    hand.app_mut().show_on("shape:sphere");
    hand.settle();
    hand.press("Add layer");
    hand.press("Add Cut highlight");
    hand.settle();
    assert!(hand.errors().is_empty(), "{:?}", hand.errors());
    hand
}

/// A value of the layer; 0 where it has none of its own.
fn number(hand: &User, port: &str) -> f64 {
    match hand.look().graph.nodes[LAYER].values.get(port) {
        Some(Value::Number(number)) => *number,
        None => 0.0,
        other => panic!("{port} is no number: {other:?}"),
    }
}

fn set(hand: &mut User, port: &str, number: f64) {
    let edit = Edit::SetValue {
        graph: GraphId::Look,
        id: LAYER.into(),
        port: port.into(),
        value: Value::Number(number),
        index: None,
    };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.settle();
}

fn place(hand: &User, handle: &str) -> Option<Pos2> {
    hand.app().viewport().highlight_handle(handle)
}

fn at(hand: &User, handle: &str) -> Pos2 {
    place(hand, handle).unwrap_or_else(|| panic!("there is no {handle}"))
}

/// Drags a handle by so many points away from the middle of the layer, or toward it.
fn pull(hand: &mut User, handle: &str, points: f32) {
    let (from, middle) = (at(hand, handle), at(hand, "Move"));
    hand.drag(from, from + points * (from - middle).normalized());
    hand.settle();
}

/// Pulls a handle in one step of the history, undoes that and does it again; the value before and
/// after.
fn pull_in_one_step(hand: &mut User, handle: &str, port: &str, points: f32) -> [f64; 2] {
    let (steps, before) = (hand.steps(), number(hand, port));
    pull(hand, handle, points);
    let after = number(hand, port);
    assert_eq!(hand.steps(), steps + 1, "{handle}: a drag is one step");
    hand.undo();
    hand.settle();
    assert_eq!(number(hand, port), before, "{handle}");
    hand.redo();
    hand.settle();
    assert_eq!(number(hand, port), after, "{handle}");
    [before, after]
}

#[test]
fn halves_are_moved_apart_and_joined_by_opposed_handles() {
    let mut hand = on_ball();
    let middle = at(&hand, "Move");
    let ways = ["Split", "Split ahead"].map(|handle| at(&hand, handle) - middle);
    assert!((ways[0] + ways[1]).length() < 1.0, "opposed: {ways:?}");
    for handle in ["Split", "Split ahead"] {
        let [before, after] = pull_in_one_step(&mut hand, handle, "split", 20.0);
        assert!(after > before + 0.03 && after < before + 0.5, "{handle}: {after} after {before}");
        let ways = ["Split", "Split ahead"].map(|handle| at(&hand, handle) - middle);
        assert!((ways[0] + ways[1]).length() < 1.0, "both follow: {ways:?}");
    }
    // Joined again, one small handle remains, which begins a split.
    pull(&mut hand, "Split", -300.0);
    assert_eq!(number(&hand, "split"), 0.0);
    assert_eq!(place(&hand, "Split ahead"), None);
    let [_, after] = pull_in_one_step(&mut hand, "Split", "split", 25.0);
    assert!(after > 0.04 && place(&hand, "Split ahead").is_some(), "{after}");
    // The other axis has been joined from the first: with both there are four panes.
    assert_eq!(place(&hand, "Split up ahead"), None);
    let [_, after] = pull_in_one_step(&mut hand, "Split up", "split_up", 25.0);
    assert!(after > 0.04, "{after}");
    let [x, y] = ["Split", "Split up ahead"].map(|handle| at(&hand, handle) - middle);
    assert!(x.normalized().dot(y.normalized()).abs() < 0.3, "along two axes: {x} {y}");
    assert!(hand.errors().is_empty(), "{:?}", hand.errors());
}

#[test]
fn corners_and_rays_are_drawn_out_by_handles() {
    let mut hand = on_ball();
    let [_, square] = pull_in_one_step(&mut hand, "Square", "square", 20.0);
    assert!((0.4..0.8).contains(&square), "{square}");
    pull(&mut hand, "Square", -300.0);
    assert_eq!(number(&hand, "square"), 0.0);
    pull(&mut hand, "Square", 14.0);
    assert!(number(&hand, "square") > 0.15, "begun by a small handle");

    // Rays are of a star alone.
    pull(&mut hand, "Split", -300.0);
    assert_eq!(place(&hand, "Rays"), None);
    let [_, star] = pull_in_one_step(&mut hand, "Star", "star", -12.0);
    assert!((0.2..1.0).contains(&star), "{star}");
    // The second of four rays is a quarter turn from the first, that of eight half as far.
    let arm = at(&hand, "Rays") - at(&hand, "Move");
    let (sin, cos) = (TAU as f32 / 8.0).sin_cos();
    let to = at(&hand, "Move") + vec2(arm.x * cos - arm.y * sin, arm.x * sin + arm.y * cos);
    let (from, steps) = (at(&hand, "Rays"), hand.steps());
    hand.drag(from, to);
    hand.settle();
    let rays = number(&hand, "rays");
    assert!((6.0..=10.0).contains(&rays) && rays == rays.round(), "{rays}");
    assert_eq!(hand.steps(), steps + 1);
    // Rounded off, the star and its rays are gone.
    pull(&mut hand, "Star", 300.0);
    assert_eq!((number(&hand, "star"), place(&hand, "Rays")), (0.0, None));
    assert!(hand.errors().is_empty(), "{:?}", hand.errors());
}

#[test]
fn handles_of_shapes_tell_what_they_do_and_go_by_arrow_keys() {
    let mut hand = on_ball();
    for (handle, hint) in [
        ("Split ahead", "split the highlight"),
        ("Split up", "upright axis"),
        ("Square", "corners"),
        ("Star", "a star"),
    ] {
        hand.hover(at(&hand, handle));
        hand.harness.run_steps(2);
        assert!(hand.says(hint), "{handle}: {:?}", hand.names());
    }
    set(&mut hand, "star", 0.5);
    let old = number(&hand, "rays").max(4.0);
    hand.harness.get_by_label("Count the rays of Cut highlight on the object").focus();
    hand.harness.run_steps(2);
    hand.key(Key::ArrowRight);
    hand.settle();
    assert_eq!(number(&hand, "rays"), old + 1.0, "by one");
    let before = number(&hand, "square");
    hand.harness.get_by_label("Square Cut highlight on the object").focus();
    hand.harness.run_steps(2);
    hand.key(Key::ArrowUp);
    hand.settle();
    assert_ne!(number(&hand, "square"), before);
}

/// A handle whose value is keyed by the view sets the key of this view alone.
#[test]
fn a_shape_that_is_keyed_by_the_view_is_set_in_its_key() {
    let mut hand = on_ball();
    let target = Target::parse("cut_highlight.square").expect("a target");
    hand.key_by_view(&target, 0.2);
    let (own, steps) = (number(&hand, "square"), hand.steps());
    pull(&mut hand, "Square", 30.0);
    let square_of = |key: &DirectionKey| match key.values[&target] {
        Value::Number(square) => square,
        ref other => panic!("{other:?}"),
    };
    let squares: Vec<f64> = hand.look().direction_keys[0].keys.iter().map(square_of).collect();
    assert!(squares[0] > 0.4, "the key in front: {squares:?}");
    assert_eq!((squares[1], number(&hand, "square")), (0.2, own), "the others stay");
    assert_eq!(hand.steps(), steps + 1);
}

/// Over a shot a handle writes a change of the shot; the look stays as it is.
#[test]
fn a_shape_is_changed_by_a_shot() {
    let look = r#"{"chiaro": "look", "lights": {"key": {"direction": [-0.3, 0.4, 0.9]}},
     "nodes": [{"id": "base", "kind": "base"}, {"id": "cut_highlight", "kind": "highlight_layer",
       "values": {"light": "key", "square": 0.3}}, {"id": "output", "kind": "output"}],
     "wires": [{"from": "base", "to": "cut_highlight.below"},
       {"from": "cut_highlight", "to": "output.color"}]}"#;
    let scene = r#"{"chiaro": "scene", "camera": {"eye": [0, 0, 6]},
     "objects": [{"id": "ball", "mesh": "shape:sphere", "looks": "look.json"}]}"#;
    let shot = r#"{"chiaro": "shot", "scene": "scene.json", "frames": [1, 8]}"#;
    let home = Home::new();
    shots::write(&home, &[("look.json", look), ("scene.json", scene), ("shot.json", shot)]);
    let mut hand = home.window(Some(&home.file("shot.json")));
    hand.settle();
    hand.app_mut().session_mut().select(vec![LAYER.into()]);
    hand.settle();
    let steps = hand.steps();
    pull(&mut hand, "Square", 25.0);
    let changes = &shots::shot(&hand).overrides;
    let [change] = changes.as_slice() else { panic!("one change: {changes:?}") };
    assert_eq!(change.target, "cut_highlight.square");
    assert!(matches!(change.value, Some(Value::Number(square)) if square > 0.4), "{change:?}");
    assert_eq!(hand.steps(), steps + 1);
}

#[test]
fn a_highlight_out_of_sight_has_a_handle_that_brings_it_back() {
    let mut hand = on_ball();
    let mut light = hand.look().lights["key"].clone();
    light.direction = [-0.8, 0.5, 0.4];
    let edit = Edit::SetLight { id: "key".into(), light };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    for port in ["split", "square"] {
        set(&mut hand, port, 0.0);
    }
    // As good as a quarter turn from the half-vector, some ways lie behind the ball.
    let is_hidden = |hand: &mut User, turn: i32| {
        let (sin, cos) = (f64::from(turn) * TAU / 8.0).sin_cos();
        set(hand, "across", 50.0 * cos);
        set(hand, "up", 50.0 * sin);
        place(hand, "Turn").is_none()
    };
    let hidden: Vec<i32> = (0..8).filter(|turn| is_hidden(&mut hand, *turn)).collect();
    assert!(!hidden.is_empty() && hidden.len() < 8, "{hidden:?}");
    assert!(is_hidden(&mut hand, hidden[hidden.len() / 2]));
    assert_eq!(place(&hand, "Square"), None, "a highlight that nobody sees has no corners");
    let (picture, stands) = (hand.app().viewport().rect().unwrap(), at(&hand, "Move"));
    let away = (stands - picture.center()).length();
    assert!(picture.contains(stands) && away > 0.25 * picture.height(), "at the rim: {stands}");
    hand.hover(stands);
    hand.harness.run_steps(2);
    assert!(hand.says("out of sight"), "{:?}", hand.names());

    let (to, steps) = (picture.center() + vec2(10.0, 20.0), hand.steps());
    hand.drag(stands, to);
    hand.settle();
    assert!(place(&hand, "Turn").is_some() && at(&hand, "Move").distance(to) < 6.0);
    assert_eq!(hand.steps(), steps + 1);
}

/// The handles keep to the highlight as the camera comes near, and within the picture.
#[test]
fn handles_stand_at_the_edge_of_the_highlight() {
    let mut hand = on_ball();
    let ways = |hand: &User| {
        let middle = at(hand, "Move");
        ["Split ahead", "Stretch", "Size", "Square"].map(|handle| at(hand, handle) - middle)
    };
    let before = ways(&hand).map(Vec2::length);
    set(&mut hand, "cutoff", 0.4);
    set(&mut hand, "falloff", 0.4);
    set(&mut hand, "offset", 0.4);
    let larger = ways(&hand).map(Vec2::length);
    assert!((larger[0] - before[0]).abs() < 1.0, "the halves are as far apart");
    assert!((1..4).all(|handle| larger[handle] > before[handle] + 20.0), "{larger:?} {before:?}");
    let picture = hand.app().viewport().rect().unwrap();
    set(&mut hand, "stretch", 0.95);
    set(&mut hand, "split", 1.0);
    assert!(picture.contains(at(&hand, "Stretch")), "as far out as the picture goes");
}
