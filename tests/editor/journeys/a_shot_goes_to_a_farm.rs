//! A lighter renders a shot from the window, finds the frames in a flip book, and writes the job by
//! which a farm draws them.

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers};

use super::artist::Studio;

#[test]
fn a_shot_is_rendered_and_sent_to_a_farm() {
    let studio = Studio::new();
    studio.chiaro(&["new", "stage", "--template", "scene"]);
    studio.chiaro(&["new", "sh010", "--over", "stage.json"]);
    let mut artist = studio.window();
    artist.app_mut().answer_dialog(&studio.path("sh010.json"));
    artist.key_with(Modifiers::COMMAND, Key::O);
    artist.settle();

    // Three frames, small, with the layers of the lights: as the terminal would have them.
    artist.palette("Render frames");
    let [from, to] = ["Render from frame", "Render to frame"].map(|it| artist.fields_called(it)[0]);
    artist.type_over(to, "3");
    artist.type_over(from, "1");
    artist.press("by the command");
    let [wide, high] =
        ["Width of frames", "Height of frames"].map(|it| artist.fields_called(it)[0]);
    artist.type_over(wide, "64");
    artist.type_over(high, "36");
    artist.bring(Role::CheckBox, "Layers: Lights");
    artist.press_a(Role::CheckBox, "Layers: Lights");
    artist.bring(Role::Button, "Copy the command that renders");
    artist.press_a(Role::Button, "Copy the command that renders");
    let copied = artist.take_copied().unwrap();
    let told =
        "chiaro render sh010.json -o 'out/sh010/####.exr' --frames 1-3 --size 64x36 --aov lights";
    assert!(copied.ends_with(told), "{copied}");
    artist.bring(Role::Button, "Render 3 frames");
    artist.press("Render 3 frames");
    assert!(artist.has("Frames: 3 of 3 are whole"), "{:?}", artist.app().message());
    assert!(artist.app().message().unwrap().starts_with("3 frames are whole"));
    let first = std::fs::read(studio.path("out/sh010/0001.exr")).unwrap();
    studio.chiaro(&["verify", "out/sh010/####.exr", "--frames", "1-3"]);

    // The job is written by the same choices, and says how it is submitted.
    artist.bring(Role::Button, "Write sh010.sh");
    artist.press_a(Role::Button, "Write sh010.sh");
    let job = studio.read("sh010.sh");
    assert!(job.contains("--aov=lights") && job.contains("sbatch"), "{job}");
    assert!(artist.says("sh sh010.sh"), "the command that submits it");

    // A job of other choices takes the place of what this window wrote, and of no other file.
    let farm = artist.fields_called("Frames a task")[0];
    artist.type_over(farm, "1");
    artist.bring(Role::Button, "Write sh010.sh");
    artist.press_a(Role::Button, "Write sh010.sh");
    let parted = studio.read("sh010.sh");
    assert!(parted != job && parted.contains("chunks=(1 2 3)"), "{parted}");
    std::fs::write(studio.path("sh010.sh"), "mine").unwrap();
    artist.bring(Role::Button, "Write sh010.sh");
    artist.press_a(Role::Button, "Write sh010.sh");
    assert_eq!(studio.read("sh010.sh"), "mine");
    artist.bring(Role::Button, "Replace sh010.sh");
    artist.press_a(Role::Button, "Replace sh010.sh");
    assert_eq!(studio.read("sh010.sh"), parted);
    assert!(!studio.path("sh010.sh.before").exists());

    // What is whole is kept by a terminal, too: the frames are equal.
    let again = studio.chiaro(&[
        "render",
        "sh010.json",
        "-o",
        "out/sh010/####.exr",
        "--frames",
        "1-3",
        "--size",
        "64x36",
        "--aov",
        "lights",
        "--json",
    ]);
    assert_eq!(again.matches("\"kept\"").count(), 3, "{again}");
    assert_eq!(std::fs::read(studio.path("out/sh010/0001.exr")).unwrap(), first);
}
