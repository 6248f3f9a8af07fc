//! Keys of a shot in the window: set where they are meant, held on twos, seen at the frames of
//! `render`, and kept as pictures while its camera moves.

use chiaro::compile::Live;
use chiaro::document::{Camera, FrameRate, SceneEdit, Value};
use chiaro::film::PlanHasher;
use chiaro::frame::{Assets, PlanOptions, Planner, open};
use chiaro::library::Library;
use eframe::egui::{Pos2, Role, pos2};
use egui_kittest::kittest::Queryable as _;

use crate::editor_support::User;
use crate::editor_support::home::Home;
use crate::editor_support::shots::{self, LOOK, shot};

const SCENE: &str = r#"{"chiaro": "scene",
 "objects": [{"id": "ball", "mesh": "shape:sphere", "looks": "look.json"}],
 "lights": {"key": {"direction": [0, 0.6, 0.8]}, "rim": {"direction": [0, 1, -1]}},
 "camera": {"eye": [0, 0.8, 6]}}"#;

const KEY: &str = r#"{"target": "lights.key.intensity", "keys": [{"frame": 1, "value": 1}]}"#;

const RIM: &str = r#"{"target": "lights.rim.intensity", "step": 2, "keys": [
  {"frame": 1, "value": 0.2}, {"frame": 8, "value": 2}, {"frame": 16, "value": 0.8}]}"#;

const EYE: &str = r#"{"target": "camera.eye", "keys": [
  {"frame": 1, "value": [-1.2, 0.8, 6], "interpolation": "smooth"},
  {"frame": 16, "value": [1.2, 1.2, 5.4]}]}"#;

fn write(home: &Home, rate: &str, frames: [i32; 2], overrides: &[&str]) {
    let overrides = overrides.join(", ");
    let shot = format!(
        r#"{{"chiaro": "shot", "scene": "scene.json", "frames": {frames:?}, "rate": {rate},
        "size": [320, 180], "overrides": [{overrides}]}}"#
    );
    let files = [("look.json", LOOK), ("scene.json", SCENE), ("shot.json", &shot)];
    shots::write(home, &files);
}

/// A window with the shot and its timeline.
fn opened(home: &Home, overrides: &[&str]) -> User {
    write(home, "24", [1, 16], overrides);
    let mut hand = home.window(Some(&home.file("shot.json")));
    hand.settle();
    show_timeline(&mut hand);
    hand.tab("Lights");
    hand
}

fn show_timeline(hand: &mut User) {
    hand.press("View");
    hand.press_a(Role::CheckBox, "Timeline");
    let nothing = hand.empty_place();
    hand.click(nothing);
    hand.settle();
}

/// The keys of a value that the shot changes.
fn keys(hand: &User, target: &str) -> Vec<(f64, f64)> {
    let found = shot(hand).overrides.iter().find(|change| change.target == target).unwrap();
    assert_eq!(found.value, None, "{target} stays keyed");
    let number = |value: &Value| if let Value::Number(x) = value { *x } else { f64::NAN };
    found.keys.iter().map(|key| (key.frame, number(&key.value))).collect()
}

/// Brings the playhead to a frame, by the ruler.
fn go(hand: &mut User, frame: i32) {
    let flag = |hand: &User, name: &str| hand.place(name).center().x;
    let [start, end] = ["Start of the range", "End of the range"].map(|name| flag(hand, name));
    let x = start + (frame - 1) as f32 / 15.0 * (end - start);
    let at = pos2(x, hand.place("Playhead").top() + 8.0);
    hand.click(at);
    hand.settle();
    assert_eq!(hand.app().session().view().time(), FrameRate::FILM.time(frame), "exactly");
}

/// Types an intensity into the row of a light.
fn type_intensity(hand: &mut User, light: &str, text: &str) {
    let row = hand.place_like(&format!("Light {light} of the scene"));
    let fields = hand.harness.get_all_by_role(Role::SpinButton).map(|node| node.rect());
    let field = fields
        .into_iter()
        .find(|rect| (rect.center().y - row.center().y).abs() < 8.0 && rect.min.x > row.min.x);
    hand.type_over(field.expect("a field of its intensity"), text);
}

#[test]
fn a_typed_value_is_a_key_at_every_frame() {
    let home = Home::new();
    let mut hand = opened(&home, &[KEY, EYE]);
    let target = "lights.key.intensity";
    let mut expected = vec![(1.0, 1.0)];
    // Half-typed digits are the value without the shot, nothing, and the key's own.
    for (frame, text) in [(16, "0.4"), (8, "1.6"), (8, "1"), (5, "0.6"), (8, "0.6"), (11, "1.25")] {
        go(&mut hand, frame);
        type_intensity(&mut hand, "key", text);
        let at = f64::from(frame);
        expected.retain(|(frame, _)| *frame != at);
        expected.push((at, text.parse().unwrap()));
        expected.sort_by(|a, b| a.0.total_cmp(&b.0));
        assert_eq!(keys(&hand, target), expected, "{text} at {frame}");
    }
    // Each is one step, and none is half of a number.
    assert_eq!(hand.steps(), 6);
    hand.undo();
    assert!(keys(&hand, target).iter().all(|(frame, _)| *frame != 11.0));
    hand.undo();
    let at_8 = keys(&hand, target).into_iter().find(|(frame, _)| *frame == 8.0);
    assert_eq!(at_8, Some((8.0, 1.0)));
}

#[test]
fn a_value_on_twos_keeps_the_keys_that_people_set() {
    let home = Home::new();
    let mut hand = opened(&home, &[RIM]);
    let target = "lights.rim.intensity";
    let own = [(1.0, 0.2), (8.0, 2.0), (16.0, 0.8)];
    let label = |key: usize| format!("Time key {key} of rim of the scene: Intensity");
    assert!(hand.has(&label(3)) && !hand.has(&label(4)), "the keys are shown, and not the holds");
    go(&mut hand, 8);
    type_intensity(&mut hand, "rim", "1.5");
    assert_eq!(keys(&hand, target), [own[0], (8.0, 1.5), own[2]]);
    go(&mut hand, 12);
    type_intensity(&mut hand, "rim", "2.25");
    assert_eq!(keys(&hand, target), [own[0], (8.0, 1.5), (12.0, 2.25), own[2]]);
    let change = &shot(&hand).overrides[0];
    assert_eq!(change.step, 2);
    let kinds: Vec<_> = change.keys.iter().map(|key| key.interpolation).collect();
    assert!(kinds.iter().all(|kind| *kind == kinds[0]), "as its neighbors: {kinds:?}");
    // The picture holds the frame before, and the field says so.
    let bulb = hand.place("Light rim of the scene shines");
    hand.click(pos2(bulb.left() - 12.0, bulb.center().y));
    hand.settle();
    assert!(hand.says("Frame 12: sets key 3 of 4; the picture holds frame 11"));
    go(&mut hand, 13);
    assert!(hand.says("Frame 13: adds a 5th key"));
    assert!(!hand.says("the picture holds"));
}

#[test]
fn frames_are_those_of_render_whatever_rounds_their_times() {
    let home = Home::new();
    for rate in ["24", "\"23.976\"", "25", "30"] {
        let of_look = r#"{"look": "look.json", "target": "layer.opacity", "step": 3, "keys": [
            {"frame": 1, "value": 0}, {"frame": 240, "value": 1}]}"#;
        write(&home, rate, [1, 240], &[RIM, EYE, of_look]);
        let mut hand = home.window(Some(&home.file("shot.json")));
        let setup = open(&home.file("shot.json"), None, &mut Assets::default()).unwrap().value;
        let mut planner = Planner::new(Assets::of(&setup.assets));
        let mut hash = |time: f64| {
            let options = PlanOptions { size: [16, 9], samples: 1, time };
            let plan = planner.plan(&setup, Library::built_in(), &Live::Keyed, &options);
            PlanHasher::default().hash(&plan.unwrap().value)
        };
        let exact: FrameRate = rate.trim_matches('"').parse().unwrap();
        for frame in 1..=240 {
            let time = exact.time(frame);
            let rounded = (time * 1e6).round() / 1e6;
            hand.app_mut().session_mut().set_time(rounded);
            assert_eq!(hand.app().session().view().time(), time, "{frame} at {rate}");
            // The first frames and some later ones: plans take their time.
            if frame <= 16 || frame % 24 < 3 {
                assert_eq!(hash(rounded), hash(time), "{frame} at {rate}");
            }
        }
    }
}

#[test]
fn frames_stay_while_the_shots_camera_moves() {
    let home = Home::new();
    write(&home, "24", [1, 16], &[EYE, RIM]);
    let mut hand = User::drawing();
    hand.app_mut().open(&home.file("shot.json"));
    hand.settle();
    show_timeline(&mut hand);
    hand.press("Cache range");
    hand.settle();
    assert_eq!(hand.app().frames()[0], 16);
    for frame in [2, 5, 8] {
        go(&mut hand, frame);
        assert!(hand.says("16 of 16 kept"), "at {frame}: {:?}", hand.app().frames());
    }
    hand.press("Next frame");
    assert!(hand.says("16 of 16 kept"), "{:?}", hand.app().frames());
    // Once a hand turns the view, that is another picture.
    let middle: Pos2 = hand.app().viewport().rect().unwrap().center();
    hand.drag(middle + eframe::egui::vec2(200.0, 90.0), middle);
    hand.settle();
    hand.press("Next frame");
    assert!(!hand.says("16 of 16 kept"));
}

#[test]
fn a_value_of_a_keyed_light_is_a_key_whoever_sets_it() {
    let home = Home::new();
    let mut hand = opened(&home, &[KEY, EYE]);
    go(&mut hand, 8);
    let scene = hand.app().session().open_scene().unwrap().scene();
    let mut light = scene.lights["key"].clone();
    light.intensity = 3.0;
    let camera = Camera { eye: [1.0, 1.0, 5.0], ..scene.camera };
    let session = hand.app_mut().session_mut();
    session.apply_to_scene(SceneEdit::SetLight { id: "key".into(), light }, None).unwrap();
    session.apply_to_scene(SceneEdit::SetCamera { camera }, None).unwrap();
    assert_eq!(keys(&hand, "lights.key.intensity"), [(1.0, 1.0), (8.0, 3.0)]);
    let eye = shot(&hand).overrides.iter().find(|it| it.target == "camera.eye").unwrap();
    assert_eq!(eye.keys.len(), 3);
}
