//! A look that moves: an angle and a color over time, and a blend mode that switches at once;
//! scrubbed, played, and drawn at three times by the program without a window.

use chiaro::document::{TimeInterpolation, Value};
use eframe::egui::accesskit::Role;
use eframe::egui::{Rect, pos2};

use super::artist::{JourneyUser, Studio};
use super::picture::Picture;

/// Moves the playhead to the frame nearest to a time, by a click on the ruler.
fn scrub(artist: &mut JourneyUser, seconds: f64) {
    let ruler = artist.place("Playhead");
    let x = |artist: &JourneyUser, flag: &str| artist.place(flag).center().x;
    // The range's flags stand at its ends, whose times the fields show.
    let [start, end] = ["Start of the range", "End of the range"].map(|flag| x(artist, flag));
    let [from, to] = ["Range from", "Range to"].map(|field| seconds_of(artist, field));
    let at = start + ((seconds - from) / (to - from)) as f32 * (end - start);
    artist.click(pos2(at, ruler.top() + 6.0));
    artist.settle();
    let time = artist.app().session().view().time();
    assert!(
        (time - seconds).abs() < 0.05 && (time * 24.0 - (time * 24.0).round()).abs() < 1e-3,
        "{time} for {seconds}"
    );
}

fn seconds_of(artist: &JourneyUser, field: &str) -> f64 {
    use egui_kittest::kittest::{NodeT as _, Queryable as _};
    let field = artist.harness.get_by_role_and_label(Role::SpinButton, field);
    let text = field
        .value()
        .or_else(|| field.accesskit_node().numeric_value().map(|x| x.to_string()))
        .unwrap();
    let frame: f64 = text.parse().unwrap();
    frame / 24.0
}

fn drawn(studio: &Studio, time: f64) -> Picture {
    studio.rendered("moving.json", &["--time", &time.to_string()])
}

#[test]
fn a_look_is_animated_and_drawn_at_three_moments() {
    let studio = Studio::new();
    let mut artist = studio.window();
    artist.press("Layer Diffuse");
    artist.press("View");
    let timeline: Rect = artist.place_of(Role::CheckBox, "Timeline");
    artist.click(timeline.center());
    artist.settle();
    let at = artist.on_canvas(0.5, 0.95);
    artist.hover(at);
    // Three tracks, each begun with the value of now.
    for value in ["Cut-off", "Convex color", "Blending"] {
        artist.press("Key a value");
        artist.press(&format!("Diffuse: {value}"));
    }
    assert_eq!(artist.look().time_keys.len(), 3);
    // Other values at a later time: setting them where the playhead is makes second keys.
    scrub(&mut artist, 2.0);
    let later = artist.app().session().view().time();
    artist.set("Cut-off", "150");
    artist.set_color("Convex color", "#2080ff");
    artist.set_word("Blending", "Multiply");
    let tracks = artist.look().time_keys.clone();
    assert!(
        tracks.iter().all(|track| track.keys.len() == 2 && track.keys[1].time == later),
        "{tracks:?}"
    );
    let [first, second] = &tracks[2].keys[..] else { unreachable!() };
    assert_eq!(
        (&first.value, &second.value),
        (&Value::Text("add".into()), &Value::Text("multiply".into()))
    );
    assert_eq!(first.interpolation, TimeInterpolation::Stepped, "a word has nothing between");
    artist.save_under(&studio.path("moving.json"));

    // At three times the window's picture is the one drawn without a window.
    let mut seen = Vec::new();
    for seconds in [0.0, 1.0, 2.0] {
        scrub(&mut artist, seconds);
        let (time, picture) = (artist.app().session().view().time(), artist.picture());
        let difference = picture.difference_from(&drawn(&studio, time));
        assert_eq!(difference.max, 0, "at {time} s: {difference:?}");
        seen.push(picture);
    }
    seen[0].differs(&seen[1]);
    seen[1].differs(&seen[2]);
    // Just before the second key the blend mode is still the first one; with *multiply* everything
    // but the light would be dark.
    scrub(&mut artist, 2.0 - 1.0 / 24.0);
    let before = artist.picture();
    assert!(
        before.brightness() > seen[2].brightness() + 10.0,
        "{} {}",
        before.brightness(),
        seen[2].brightness()
    );

    // While the timeline plays the playhead goes on by itself, and comes around.
    scrub(&mut artist, 1.0);
    // A playing window never rests, so that nothing may wait for rest.
    let play = artist.place("Play").center();
    artist.click(play);
    let mut times = Vec::new();
    for _ in 0..4 {
        artist.harness.step();
        times.push(artist.app().session().view().time());
    }
    assert!(times.windows(2).all(|pair| pair[1] >= pair[0]) && times[3] > 1.2, "{times:?}");
    let pause = artist.place("Pause").center();
    artist.click(pause);
    artist.settle();
    let stopped = artist.app().session().view().time();
    artist.harness.run_steps(10);
    assert_eq!(artist.app().session().view().time(), stopped);
    assert!(!artist.app().session().is_dirty(), "playing changes nothing");
    scrub(&mut artist, 0.0);
    studio.finish(artist, "moving.json");
}
