//! A lighter keys a shot: begun over a scene in the window, a layer darkened from the first frame
//! to the last, saved, and drawn by the program without a window.

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, pos2};

use super::artist::Studio;

#[test]
fn a_shot_is_begun_keyed_saved_and_drawn() {
    let studio = Studio::new();
    studio.chiaro(&["new", "stage", "--template", "scene"]);
    let before = [studio.read("stage.json"), studio.read("stage-look.json")];
    let mut artist = studio.window();
    artist.app_mut().answer_dialog(&studio.path("stage.json"));
    artist.key_with(Modifiers::COMMAND, Key::O);
    artist.settle();
    artist.key_with(Modifiers::COMMAND, Key::P);
    artist.type_text("New shot");
    artist.key(Key::Enter);
    artist.settle();
    assert!(artist.says("in no file yet"), "{:?}", artist.app().message());

    // Dark at first, and bright at the last frame: the second value is a key beside the first.
    artist.press("Node Warm body in the sun");
    artist.set("Opacity", "0.125");
    artist.tab("Shot");
    artist.bring(Role::Button, "Key stage-look: warm_body.opacity");
    artist.press_a(Role::Button, "Key stage-look: warm_body.opacity");
    artist.press("View");
    artist.press_a(Role::CheckBox, "Timeline");
    let (end, ruler) = (artist.place("End of the range"), artist.place("Playhead"));
    artist.click(pos2(end.center().x, ruler.top() + 6.0));
    artist.settle();
    assert_eq!((artist.app().session().view().time() * 24.0).round() as u32, 48);
    artist.set("Opacity", "1");
    let shot = artist.app().session().shot().expect("one is open").shot();
    let frames: Vec<f64> = shot.overrides[0].keys.iter().map(|key| key.frame).collect();
    assert_eq!(frames, [1.0, 48.0]);

    artist.app_mut().answer_dialog(&studio.path("sh010.json"));
    artist.key_with(Modifiers::COMMAND, Key::S);
    artist.settle();
    assert!(!artist.app().session().is_dirty(), "{:?}", artist.app().message());
    assert_eq!([studio.read("stage.json"), studio.read("stage-look.json")], before);
    let told = studio.chiaro(&["shot", "sh010.json", "--diff"]);
    assert!(told.contains("warm_body.opacity"), "{told}");
    std::fs::create_dir(studio.path("out")).unwrap();
    let render = ["render", "sh010.json", "-o", "out/####.png", "--size", "96x54"];
    studio.chiaro(&[&render[..], &["--frames", "1,48"]].concat());
    let light = |name: &str| -> u64 {
        let picture = image::open(studio.path(name)).unwrap().to_rgb8();
        picture.pixels().map(|pixel| u64::from(pixel[0])).sum()
    };
    assert_ne!(light("out/0001.png"), light("out/0048.png"));
}
