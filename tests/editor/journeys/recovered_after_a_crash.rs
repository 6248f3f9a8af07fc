//! A program dies in the middle of a drag. The next window offers the work, which is complete to
//! the last move of the drag, with its history; it is saved as if nothing had happened.

use chiaro::document::Value;
use eframe::egui::{Key, Modifiers, vec2};

use super::artist::{JourneyUser, Studio};
use crate::editor_support::User;
use crate::editor_support::home::Home;

/// A window with this user's folders, as the program opens it.
fn window(home: &Home) -> JourneyUser {
    let places = home.places();
    JourneyUser::at(User::drawing_with(move |app, ctx| {
        let mut app = app.without_dialogs();
        app.keep_in(places.clone(), ctx);
        app.resume();
        app
    }))
}

#[test]
fn work_is_complete_to_the_last_gesture() {
    let studio = Studio::new();
    let home = Home::new();
    let mut artist = window(&home);
    let first = artist.look().clone();
    artist.press("Layer Diffuse");
    artist.press("Add layer");
    artist.press("Add Back-light");
    artist.set_color("Convex color", "#40c0ff");
    artist.show_all();
    let at = artist.on_canvas(0.2, 0.9);
    artist.add_node(at, "noise");
    artist.show_all();
    artist.wire("Output Value of Noise", "Input Opacity of Back-light");
    artist.key_with(Modifiers::COMMAND, Key::Z);
    artist.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    artist.settle();
    // A drag that never ends: the button is still pressed when the program dies.
    artist.press("Layer Diffuse");
    artist.press("Show all values");
    let slider = artist.slider("Offset");
    artist.hold(slider.left_center() + vec2(4.0, 0.0));
    for step in 1..=5 {
        artist.move_to(slider.left_center() + vec2(4.0 + 0.08 * slider.width() * step as f32, 0.0));
    }
    // Moves of a tenth of a second are written together; then the program dies, the button still
    // pressed.
    artist.harness.run_steps(2);
    artist.app().session().wait_for_journal();
    home.wait_until_written();
    let (last, steps) = (artist.look().clone(), artist.steps());
    let offset = &last.graph.nodes["diffuse"].values["offset"];
    assert!(matches!(offset, Value::Number(x) if *x > 0.2), "the drag set it: {offset:?}");

    let later = home.after_a_crash();
    drop(artist);
    let mut artist = window(&later);
    assert_eq!(*artist.look(), first, "it is only offered: the work may be what broke the window");
    assert!(artist.says("Work that was not saved"));
    artist.press("Restore it");
    assert_eq!(*artist.look(), last, "nothing is lost");
    assert_eq!(artist.steps(), steps);
    assert!(artist.app().session().is_dirty() && !artist.says("Work that was not saved"));
    let taken = artist.picture();
    // The history is undone completely, and redone.
    artist.undo_all();
    assert_eq!(*artist.look(), first);
    artist.picture().differs(&taken);
    for _ in 0..steps {
        artist.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    }
    artist.settle();
    assert_eq!(*artist.look(), last);
    artist.picture().equals(&taken);
    studio.finish(artist, "saved.json");
    drop(window(&later));
    assert_eq!(later.journals(), 0, "what is saved needs no journal");
}
