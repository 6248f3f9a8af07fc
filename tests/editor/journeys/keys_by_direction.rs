//! A back-light that changes as the camera walks around: keyed at two directions of the view, with
//! another color and another intensity at each.

use eframe::egui::accesskit::Role;
use eframe::egui::vec2;
use egui_kittest::kittest::{NodeT as _, Queryable as _};

use super::artist::{JourneyUser, Studio};
use super::picture::Picture;

/// Weights of two keys, as a screen reader tells them.
fn weights(artist: &JourneyUser) -> [f64; 2] {
    [1, 2].map(|key| {
        let name = format!("Direction key {key}");
        let handle = artist.harness.get_by_label(&name);
        handle.accesskit_node().numeric_value().expect("a handle tells its weight")
    })
}

/// Walks around the object by a drag beside it, in points.
fn walk(artist: &mut JourneyUser, points: f32) {
    let from = artist.app().viewport().rect().unwrap().left_top() + vec2(14.0, 40.0);
    // In one move: the first few points of a slow drag do not count as a drag yet.
    artist.hold(from);
    artist.move_to(from + vec2(points, 0.0));
    artist.release(from + vec2(points, 0.0));
    artist.settle();
}

/// The picture from the current view with this color and intensity in place of the keys: written
/// into the look's file, and drawn by the program without a window.
fn without_keys(studio: &Studio, artist: &JourneyUser, color: [f64; 3], intensity: f64) -> Picture {
    let mut look: serde_json::Value = serde_json::from_str(&studio.read("keyed.json")).unwrap();
    assert!(look.as_object_mut().unwrap().remove("direction_keys").is_some());
    look["lights"]["back"]["intensity"] = intensity.into();
    let nodes = look["nodes"].as_array_mut().unwrap();
    let layer = nodes.iter_mut().find(|node| node["id"] == "back_light").unwrap();
    layer["values"]["convex"] = color.to_vec().into();
    studio.write("still.json", &look.to_string());
    let orbit = artist.app().session().view().orbit();
    let camera = format!("orbit={:.9},{:.9}", orbit.yaw.to_degrees(), orbit.pitch.to_degrees());
    studio.rendered("still.json", &["--camera", &camera])
}

#[test]
fn a_back_light_changes_with_the_view() {
    let studio = Studio::new();
    let mut artist = studio.window();
    artist.press("Layer Diffuse");
    artist.press("Add layer");
    artist.press("Add Back-light");
    artist.tab("Keys");
    artist.press("Add direction keys");
    artist.press("By the view");
    artist.press("Add value");
    artist.press("Back-light: Convex color");
    artist.press("Add value");
    artist.press("back: Intensity");
    artist.press("Select key 1");
    artist.set_color("Convex color", "#3060ff");

    // Another view, and another light there.
    walk(&mut artist, 150.0);
    let there = artist.app().session().view().orbit().clone();
    artist.press("Add key here");
    artist.set_color("Convex color", "#ff4020");
    let field = artist.place_of(Role::SpinButton, "back: Intensity at key 2");
    artist.type_over(field, "1.8");
    let keys = &artist.look().direction_keys[0].keys;
    assert_eq!(keys.len(), 2, "{keys:?}");
    artist.save_under(&studio.path("keyed.json"));

    // At a key the picture shows the key's values.
    let blue = [0x30, 0x60, 0xff].map(|byte| (f64::from(byte) / 255.0 * 1e4_f64).round() / 1e4);
    let red = [0xff, 0x40, 0x20].map(|byte| (f64::from(byte) / 255.0 * 1e4_f64).round() / 1e4);
    assert_eq!(
        weights(&artist).map(|weight| (weight * 1e3).round()),
        [0.0, 1000.0],
        "the view is at key 2"
    );
    let seen = artist.picture();
    let difference = seen.difference_from(&without_keys(&studio, &artist, red, 1.8));
    assert!(difference.max <= 2, "at key 2: {difference:?}");
    artist.press("Select key 1");
    artist.press("Go to key");
    assert_eq!(
        weights(&artist).map(|weight| (weight * 1e3).round()),
        [1000.0, 0.0],
        "the view is at key 1"
    );
    let difference = artist.picture().difference_from(&without_keys(&studio, &artist, blue, 1.0));
    assert!(difference.max <= 2, "at key 1: {difference:?}");
    assert!(
        artist.picture().difference_from(&without_keys(&studio, &artist, red, 1.8)).max > 20,
        "and no other key's"
    );

    // Between the keys the weights change smoothly and add up to 1, and the picture is that of the
    // weighted values.
    let mut last = weights(&artist);
    let mut steepest: f64 = 0.0;
    for step in 0..10 {
        walk(&mut artist, 15.0);
        let now = weights(&artist);
        assert!((now[0] + now[1] - 1.0).abs() < 1e-6, "{now:?}");
        assert!(
            now[0] <= last[0] + 1e-3,
            "on the way from key 1 to key 2 it counts less and less: {last:?} {now:?}"
        );
        steepest = steepest.max(last[0] - now[0]);
        last = now;
        if step == 4 {
            assert!(now[0] > 0.2 && now[0] < 0.8, "{now:?}");
            let mixed = [0, 1, 2].map(|k| now[0] * blue[k] + now[1] * red[k]);
            let difference = artist.picture().difference_from(&without_keys(
                &studio,
                &artist,
                mixed,
                now[0] + 1.8 * now[1],
            ));
            assert!(difference.max <= 2, "half way: {difference:?}");
        }
    }
    assert!(steepest < 0.3, "no step jumps: {steepest}");
    assert!(
        (artist.app().session().view().orbit().yaw - there.yaw).abs() < 1e-4 && last[1] > 0.999,
        "it came to key 2"
    );
    assert!(!artist.app().session().is_dirty(), "walking around changes nothing of the look");
    studio.finish(artist, "keyed.json");
}
