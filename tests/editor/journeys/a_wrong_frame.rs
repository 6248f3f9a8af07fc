//! A sequence came back from a farm, and one of its frames is wrong: it is found by a flip book of
//! the rendered frames against those of the window.

use eframe::egui::Key;
use eframe::egui::accesskit::Role;
use egui_kittest::kittest::Queryable as _;

use super::artist::{JourneyUser, Studio};

/// The frame that is wrong, and the number of frames.
const WRONG: u32 = 5;
const COUNT: u32 = 9;

fn render(studio: &Studio, frames: &str) {
    let arguments = ["render", "moving.json", "-o", "out/####.exr", "--size", "160x120"];
    studio.chiaro(&[&arguments[..], &["--frames", frames]].concat());
}

/// Opens the rendered frames in the flip book, by one of them.
fn compare(studio: &Studio, artist: &mut JourneyUser, list: &str) {
    artist.app_mut().answer_dialog(&studio.path("out/0003.exr"));
    let lists = artist.harness.query_all_by_role(Role::ComboBox);
    let found = lists.into_iter().find(|node| node.value().as_deref() == Some(list));
    let at = found.expect("the list of what to compare with").rect().center();
    artist.click(at);
    artist.press("Rendered frames...");
    artist.settle();
}

#[test]
fn the_frame_that_is_wrong_is_found_by_a_flip_book() {
    let studio = Studio::new();
    let mut artist = studio.window();
    artist.press("Layer Diffuse");
    artist.press("View");
    artist.press_a(Role::CheckBox, "Timeline");
    let at = artist.on_canvas(0.5, 0.95);
    artist.hover(at);
    artist.press("Key a value");
    artist.press("Diffuse: Cut-off");
    let end = artist.fields_called("Range to")[0];
    artist.type_over(end, "8");
    for _ in 1..COUNT {
        artist.press("Next frame");
    }
    artist.set("Cut-off", "150");
    artist.save_under(&studio.path("moving.json"));

    // Somebody's machine drew one frame of an older file: the frame of another moment.
    std::fs::create_dir(studio.path("out")).unwrap();
    render(&studio, &format!("0-{}", COUNT - 1));
    let frame = |at: u32| studio.path(&format!("out/{at:04}.exr"));
    std::fs::copy(frame(0), frame(WRONG)).unwrap();

    compare(&studio, &mut artist, "Compare");
    assert!(artist.says(&format!("{COUNT} of {COUNT} kept")), "they are drawn to be compared");
    assert!(artist.says("1 differ"), "and all but one are equal");
    artist.press("Greatest difference");
    let time = artist.app().session().view().time();
    assert_eq!((time * 24.0).round() as u32, WRONG);
    assert!(artist.says(&format!("frame {WRONG} differs by")), "the window says where and how far");
    // The list names the frame as well.
    artist.press("1 differ");
    assert!(artist.says(&format!("Frame {WRONG} differs by")));
    artist.key(Key::Escape);
    artist.settle();

    // Drawn again the frame is as all others are.
    std::fs::remove_file(frame(WRONG)).unwrap();
    render(&studio, &WRONG.to_string());
    compare(&studio, &mut artist, "out/####.exr");
    assert!(artist.says("0 differ"), "half floats round to a step of 1/255 at most");
    // Half a file is told by its name, and the others are compared.
    std::fs::write(frame(2), b"half a file").unwrap();
    compare(&studio, &mut artist, "out/####.exr");
    artist.press("0 differ");
    assert!(artist.says("0002.exr"), "the file is named");
    artist.key(Key::Escape);
    artist.press("Close flip book");
    assert!(!artist.app().session().is_dirty(), "comparing changes nothing");
}
