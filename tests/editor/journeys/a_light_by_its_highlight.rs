//! A journey on a real mesh, where there is one: a light is moved by its highlight, a line of the
//! layer is dragged, a color is scrubbed, a layer goes to another place, each as one step; Escape
//! gives a drag up. The saved picture is the one that the program without a window draws.
//!
//! `CHIARO_MODELS` names a folder with `spot.obj` in it; else an own shape stands in.

use std::path::PathBuf;

use chiaro::document::Value;
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Pos2, Rect, vec2};
use egui_kittest::kittest::Queryable as _;

use super::artist::{JourneyUser, Studio};
use super::picture::Picture;

fn mesh() -> Option<PathBuf> {
    let folder = std::env::var_os("CHIARO_MODELS").map(PathBuf::from)?;
    Some(folder.join("spot.obj")).filter(|path| path.is_file())
}

/// The point of an angle's line that is nearest to the middle of the picture.
fn on_line(artist: &JourneyUser, port: &str) -> Pos2 {
    let center = artist.app().viewport().rect().unwrap().center();
    let points = artist.app().viewport().curve(port).into_iter();
    points
        .min_by(|a, b| a.distance(center).total_cmp(&b.distance(center)))
        .expect("the line is seen")
}

/// Makes a gesture and asserts that it is one step.
#[track_caller]
fn one_step(artist: &mut JourneyUser, gesture: impl FnOnce(&mut JourneyUser)) {
    let before = artist.steps();
    gesture(artist);
    artist.settle();
    assert_eq!(artist.steps(), before + 1, "{:?}", artist.app().session().steps().undo_label());
}

#[test]
fn a_look_is_made_with_the_hand_on_the_object() {
    let studio = Studio::new();
    let mut artist = studio.window();
    let list = artist.place_of(Role::ComboBox, "On").center();
    artist.click(list);
    match mesh() {
        Some(mesh) => {
            artist.app_mut().answer_dialog(&mesh);
            artist.press("From a file...");
        }
        None => artist.press("Knot"),
    }
    let fresh = artist.picture();
    artist.press("Layer Diffuse");
    artist.press("Add layer");
    artist.press("Add Highlight");

    // A drag of the highlight takes the highlight to the pointer, and its light with it.
    let direction = artist.look().lights["key"].direction;
    let center = artist.app().viewport().rect().unwrap().center();
    one_step(&mut artist, |artist| {
        let middle = artist.app().viewport().middle().unwrap_or(center);
        artist.drag_with(eframe::egui::Modifiers::SHIFT, middle, center + vec2(12.0, 8.0));
    });
    assert_ne!(artist.look().lights["key"].direction, direction);

    // A drag given up by Escape changes nothing, and leaves no step to undo.
    let (look, steps) = (artist.look().clone(), artist.steps());
    let from = artist.app().viewport().middle().expect("the highlight is seen");
    artist.hold(from);
    artist.move_to(from + vec2(-20.0, 10.0));
    artist.move_to(from + vec2(-30.0, 20.0));
    assert_ne!(*artist.look(), look, "it follows");
    artist.key(Key::Escape);
    assert_eq!((artist.look(), artist.steps()), (&look, steps));
    artist.move_to(from + vec2(-40.0, 20.0));
    artist.release(from + vec2(-40.0, 20.0));
    artist.settle();
    assert_eq!(*artist.look(), look, "the hand holds nothing any more");

    // A drag of the diffuse layer's cut-off line, inward over the object.
    artist.press("Layer Diffuse");
    let from = on_line(&artist, "cutoff");
    let toward = artist.app().viewport().middle().unwrap_or(center);
    one_step(&mut artist, |artist| artist.drag(from, from + (toward - from) * 0.3));
    let cutoff = &artist.look().graph.nodes["diffuse"].values["cutoff"];
    assert!(matches!(cutoff, Value::Number(x) if *x < 1.55), "{cutoff:?}");

    // A color is scrubbed in its picker.
    let color = artist.look().graph.nodes["diffuse"].values["convex"].clone();
    let swatch = artist.swatch("Convex color");
    let fields = |artist: &JourneyUser| -> Vec<Rect> {
        artist.harness.get_all_by_role(Role::SpinButton).map(|node| node.rect()).collect()
    };
    let known = fields(&artist);
    artist.click(swatch.center());
    artist.settle();
    let red = fields(&artist)
        .into_iter()
        .find(|field| !known.contains(field))
        .expect("the picker has number fields");
    one_step(&mut artist, |artist| artist.drag(red.center(), red.center() - vec2(60.0, 0.0)));
    artist.key(Key::Escape);
    assert_ne!(artist.look().graph.nodes["diffuse"].values["convex"], color);

    // The highlight goes below the diffuse layer.
    one_step(&mut artist, |artist| {
        let grip =
            |artist: &JourneyUser, label: &str| artist.place(label).left_top() + vec2(60.0, 26.0);
        let (from, to) = (grip(artist, "Layer Highlight"), grip(artist, "Layer Diffuse"));
        artist.drag(from, to + vec2(0.0, 22.0));
    });
    assert!(artist.place("Layer Highlight").min.y > artist.place("Layer Diffuse").min.y);
    assert!(artist.errors().is_empty(), "{:?}", artist.errors());
    artist.picture().differs(&fresh);

    // Saved by the menu in its size on the screen, the picture is the one that the program without
    // a window draws.
    artist.save_under(&studio.path("hand.json"));
    artist.look_from_the_front();
    let size = artist.app().viewport().rect().unwrap().size();
    let path = studio.path("window.png");
    artist.app_mut().answer_dialog(&path);
    artist.press("Options");
    artist.press("Save picture 1×");
    assert!(artist.says("Saved"), "{:?}", artist.app().message());
    let size = (size * artist.harness.ctx.pixels_per_point()).round();
    let size = format!("{}x{}", size.x, size.y);
    let mesh = artist.app().session().view().orbit().mesh.clone();
    studio.chiaro(&["render", "hand.json", "-o", "alone.png", "--mesh", &mesh, "--size", &size]);
    Picture::read(&path).equals(&Picture::read(&studio.path("alone.png")));
    studio.finish(artist, "hand.json");
}
