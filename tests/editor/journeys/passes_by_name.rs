//! Outputs of a look are named as passes on the canvas: by the menu of a socket and of a node, with
//! names that cannot be refused while they are typed, renamed, given up and undone; a film then
//! asks for them by these names.

use eframe::egui::{Event, Key, Modifiers, PointerButton, Pos2};

use super::artist::{JourneyUser, Studio};

fn right_click(artist: &mut JourneyUser, pos: Pos2) {
    artist.hover(pos);
    artist.harness.run_steps(4);
    for pressed in [true, false] {
        let (button, modifiers) = (PointerButton::Secondary, Modifiers::NONE);
        artist.harness.event(Event::PointerButton { pos, button, pressed, modifiers });
        artist.harness.step();
    }
    artist.harness.run_steps(3);
}

/// Types into the field on the canvas, over the text that is selected there.
fn type_name(artist: &mut JourneyUser, name: &str) {
    artist.key_with(Modifiers::COMMAND, Key::A);
    artist.type_text(name);
    artist.key(Key::Enter);
    artist.settle();
}

fn names(artist: &JourneyUser) -> Vec<String> {
    artist.look().aovs.iter().map(|aov| format!("{} = {}", aov.name, aov.from)).collect()
}

#[test]
fn outputs_are_named_as_passes_and_rendered_by_their_names() {
    let studio = Studio::new();
    let mut artist = studio.window();
    artist.show_all();
    let before = artist.picture();

    // By the menu of an output; the suggestion is made of the node's name and the output's.
    let socket = artist.place("Output Stack of Diffuse").center();
    right_click(&mut artist, socket);
    artist.press("Name as a pass (AOV)...");
    artist.key(Key::Enter);
    artist.settle();
    assert_eq!(names(&artist), ["diffuse_stack = diffuse.below"]);
    assert!(artist.has("Output Stack of Diffuse, pass diffuse_stack"), "its tag tells it");

    // Another output, by the command palette; names that cannot be are told, and kept to be mended.
    artist.press("Layer Diffuse");
    let base = artist.app().canvas().node_rect("base").unwrap().center_top();
    artist.click(base + eframe::egui::vec2(0.0, 8.0));
    artist.key_with(Modifiers::COMMAND, Key::P);
    artist.type_text("name an output");
    artist.key(Key::Enter);
    artist.settle();
    for (wrong, why) in [
        ("2 rims", "is no name for a pass"),
        ("lights", "is the name of other layers"),
        ("diffuse_stack", "is another pass already: Diffuse: Stack"),
    ] {
        type_name(&mut artist, wrong);
        assert!(artist.says(why), "{wrong}: {:?}", artist.app().message());
        assert!(artist.app().message().is_some_and(|told| told.contains(why)));
        assert_eq!(names(&artist).len(), 1);
    }
    type_name(&mut artist, "paper");
    assert_eq!(names(&artist), ["diffuse_stack = diffuse.below", "paper = base.below"]);

    // Renamed by the menu of the node, given up in the panel Export, and both undone.
    let socket = artist.place_like("Output Stack of Base").center();
    right_click(&mut artist, socket);
    artist.press("Rename the pass \"paper\"...");
    type_name(&mut artist, "ground");
    assert_eq!(names(&artist)[1], "ground = base.below");
    artist.undo();
    assert_eq!(names(&artist)[1], "paper = base.below");
    artist.key_with(Modifiers::COMMAND, Key::P);
    artist.type_text("panel export");
    artist.key(Key::Enter);
    artist.settle();
    artist.bring(eframe::egui::Role::Button, "Remove the pass diffuse_stack");
    artist.press("Remove the pass diffuse_stack");
    assert_eq!(names(&artist), ["paper = base.below"]);
    artist.undo();
    assert_eq!(names(&artist).len(), 2);

    // The palette finds them, and shows the node of one.
    artist.key_with(Modifiers::COMMAND, Key::P);
    artist.type_text("pass diffuse_stack");
    artist.key(Key::Enter);
    artist.settle();
    assert_eq!(artist.selected(), ["diffuse"]);

    // Names change no picture, and are those by which a film asks.
    artist.picture().equals(&before);
    studio.finish(artist, "named.json");
    let size = ["--size", "32x24"];
    let still = ["render", "named.json", "-o", "still.exr", "--aov", "named"];
    studio.chiaro(&[&still[..], &size].concat());
    let still = std::fs::read(studio.path("still.exr")).unwrap();
    let still = chiaro::film::StoredFrame::read(&still).unwrap();
    let names = still.names();
    assert!(names.contains(&"paper.R") && names.contains(&"diffuse_stack.R"), "{names:?}");
}
