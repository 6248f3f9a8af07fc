//! The timeline as animators use it: tracks opened into curves, handles, keys over several tracks
//! moved, stretched, copied and deleted, and markers.

use chiaro::document::{
    Edit, Extrapolation, HandlePair, Target, TimeInterpolation, TimeKey, TimeKeys, Value,
};
use eframe::egui::{Key, Modifiers, Pos2, Role, pos2, vec2};

use crate::editor_support::{User, close};

/// A window with two tracks of one look: opacity at 0, 1 and 2 seconds, the cut-off at 0 and 2.
fn keyed() -> User {
    let mut hand = User::new();
    let track = |port: &str, keys: &[(f64, f64)]| {
        let key = |&(time, value): &(f64, f64)| {
            TimeKey::new(time, Value::Number(value), TimeInterpolation::Bezier)
        };
        let target = Target::parse(&format!("diffuse.{port}")).unwrap();
        let keys = TimeKeys { keys: keys.iter().map(key).collect(), ..TimeKeys::new(target) };
        Edit::AddTimeKeys { keys, index: None }
    };
    for edit in [
        track("opacity", &[(0.0, 0.0), (1.0, 0.25), (2.0, 1.0)]),
        track("cutoff", &[(0.0, 1.0), (2.0, 2.0)]),
    ] {
        hand.app_mut().session_mut().apply(edit, None).unwrap();
    }
    hand.settle();
    hand.press("View");
    let timeline = hand.place_of(Role::CheckBox, "Timeline").center();
    hand.click(timeline);
    hand.settle();
    hand
}

fn times(hand: &User, track: usize) -> Vec<f64> {
    hand.look().time_keys[track].keys.iter().map(|key| key.time).collect()
}

fn at(hand: &User, label: &str) -> Pos2 {
    hand.place(label).center()
}

/// Brings the playhead to a time.
fn go(hand: &mut User, seconds: f32) {
    let [start, end] = ["Time key 1 of Diffuse: Cut-off", "Time key 2 of Diffuse: Cut-off"]
        .map(|key| at(hand, key).x);
    let ruler = hand.place("Playhead");
    hand.click(pos2(start + (end - start) * 0.5 * seconds, ruler.top() + 6.0));
    hand.settle();
    let time = hand.app().session().view().time();
    assert!(close(time, f64::from(seconds)), "{time} for {seconds}");
}

#[test]
fn handles_of_an_opened_curve_are_dragged() {
    let mut hand = keyed();
    let before = hand.look().clone();
    hand.press("Open curves of Diffuse: Opacity");
    let key = at(&hand, "Time key 2 of Diffuse: Opacity");
    hand.click(key);
    hand.settle();
    // Steeper after the key, and so before it, too.
    let handle = at(&hand, "Handle after key 2 of Diffuse: Opacity");
    hand.drag(handle, handle + vec2(10.0, -20.0));
    hand.settle();
    let keys = &hand.look().time_keys[0].keys;
    let slope = |handle: &[f64; 2]| handle[1] / handle[0];
    let (incoming, outgoing) = (&keys[1].incoming[0], &keys[1].outgoing[0]);
    assert!(outgoing[0] > 1.0 / 3.0 && slope(outgoing) > 0.5, "{outgoing:?}");
    assert!((slope(incoming) - slope(outgoing)).abs() < 1e-9, "{incoming:?} {outgoing:?}");
    assert_eq!(times(&hand, 0), [0.0, 1.0, 2.0]);
    hand.undo();
    hand.settle();
    assert_eq!(*hand.look(), before, "a drag is one step");
    // Free handles are moved each for itself.
    hand.press("Handles");
    hand.press("Free");
    assert_eq!(hand.look().time_keys[0].keys[1].handles, HandlePair::Free);
    let incoming = hand.look().time_keys[0].keys[1].incoming.clone();
    let handle = at(&hand, "Handle after key 2 of Diffuse: Opacity");
    hand.drag(handle, handle + vec2(10.0, -20.0));
    hand.settle();
    assert_eq!(hand.look().time_keys[0].keys[1].incoming, incoming);
    // A key goes up and to the right, onto a frame.
    let key = at(&hand, "Time key 2 of Diffuse: Opacity");
    hand.drag(key, key + vec2(40.0, -15.0));
    hand.settle();
    let key = &hand.look().time_keys[0].keys[1];
    let Value::Number(value) = key.value else { panic!() };
    assert!(key.time > 1.0 && close(key.time * 24.0, (key.time * 24.0).round()), "{}", key.time);
    assert!(value > 0.3, "{value}");
}

#[test]
fn keys_of_several_tracks_are_moved_and_stretched_together() {
    let mut hand = keyed();
    let before = hand.look().clone();
    // A box around the last keys of both tracks.
    let opacity = at(&hand, "Time key 3 of Diffuse: Opacity");
    let cutoff = at(&hand, "Time key 2 of Diffuse: Cut-off");
    let from = pos2(opacity.x - 30.0, opacity.y.min(cutoff.y) - 13.0);
    hand.drag(from, pos2(cutoff.x + 30.0, opacity.y.max(cutoff.y) + 12.0));
    hand.settle();
    assert!(hand.says("2 keys in 2 tracks"));
    hand.drag(opacity, opacity + vec2(60.0, 0.0));
    hand.settle();
    let moved = times(&hand, 0)[2];
    assert!(moved > 2.0, "{moved}");
    assert_eq!((times(&hand, 0)[1], times(&hand, 1)), (1.0, vec![0.0, moved]));
    hand.undo();
    hand.settle();
    assert_eq!(*hand.look(), before, "both tracks are one step");
    // All keys, twice as slow, to the frame.
    hand.hover(opacity);
    hand.key_with(Modifiers::COMMAND, Key::A);
    let length = hand.place_of(Role::SpinButton, "Length of the keys");
    hand.type_over(length, "96");
    assert_eq!((times(&hand, 0), times(&hand, 1)), (vec![0.0, 2.0, 4.0], vec![0.0, 4.0]));
    hand.undo();
    hand.settle();
    assert_eq!(*hand.look(), before, "it is one step");
    // The edge of the selection, which is the one before, scales about the other end.
    assert!(hand.says("5 keys in 2 tracks"));
    let end = at(&hand, "End of the selection");
    let start = at(&hand, "Start of the selection");
    hand.drag(end, pos2(0.5 * (start.x + end.x), end.y));
    hand.settle();
    assert_eq!(times(&hand, 1)[0], 0.0);
    let half = times(&hand, 1)[1];
    assert!((half - 1.0).abs() < 0.05 && times(&hand, 0)[2] == half, "{half}");
    hand.undo();
    hand.settle();
    assert!(*hand.look() == before && hand.says("5 keys in 2 tracks"));
    hand.redo();
    hand.settle();
    assert!(times(&hand, 1)[1] == half && hand.says("5 keys in 2 tracks"));
    // A key that is dragged over another one takes its place when it stays there.
    hand.undo();
    hand.settle();
    let [second, third] =
        [2, 3].map(|key| at(&hand, &format!("Time key {key} of Diffuse: Opacity")));
    hand.click(second);
    hand.settle();
    hand.drag(second, pos2(third.x + 30.0, second.y));
    hand.settle();
    assert_eq!(times(&hand, 0).len(), 3, "it passes the third");
    assert!(times(&hand, 0)[2] > 2.0 && times(&hand, 0)[1] == 2.0);
    hand.hover(third);
    hand.key(Key::Delete);
    hand.settle();
    assert_eq!(times(&hand, 0), [0.0, 2.0]);
}

#[test]
fn keys_are_copied_to_the_playhead_and_go_on_beyond_their_ends() {
    let mut hand = keyed();
    let first = at(&hand, "Time key 1 of Diffuse: Opacity");
    let second = at(&hand, "Time key 2 of Diffuse: Opacity");
    hand.click(first);
    hand.settle();
    hand.click_with(Modifiers::SHIFT, second);
    hand.settle();
    hand.press("Edit keys");
    hand.press("Copy keys");
    go(&mut hand, 3.0);
    hand.press("Edit keys");
    hand.press("Paste keys");
    assert_eq!(times(&hand, 0), [0.0, 1.0, 2.0, 3.0, 4.0]);
    assert_eq!(times(&hand, 1), [0.0, 2.0], "only their own track");
    hand.undo();
    hand.settle();
    // Keys of one track go into the track of the selected key.
    let other = at(&hand, "Time key 1 of Diffuse: Cut-off");
    hand.click(other);
    hand.settle();
    hand.press("Edit keys");
    hand.press("Paste keys");
    assert_eq!(times(&hand, 1), [0.0, 2.0, 3.0, 4.0]);
    hand.press("Beyond");
    hand.press("After: cycle with offset");
    let track = &hand.look().time_keys[1];
    assert_eq!((track.before, track.after), (Extrapolation::Hold, Extrapolation::CycleOffset));
    hand.press("Interpolation");
    hand.press("Stepped");
    let keys = &hand.look().time_keys[1].keys;
    let stepped = keys.iter().filter(|key| key.interpolation == TimeInterpolation::Stepped);
    assert_eq!(stepped.count(), 2, "the pasted keys are selected");
}

#[test]
fn times_have_names() {
    let mut hand = keyed();
    let before = hand.look().clone();
    go(&mut hand, 1.0);
    hand.press("Add marker");
    let markers = hand.look().markers.clone();
    assert_eq!((markers.len(), markers[0].time, &*markers[0].name), (1, 1.0, "Marker 1"));
    // It is dragged to a frame, and named.
    let marker = at(&hand, "Marker Marker 1");
    hand.drag(marker, marker + vec2(50.0, 0.0));
    hand.settle();
    let time = hand.look().markers[0].time;
    assert!(time > 1.0 && close(time * 24.0, (time * 24.0).round()), "{time}");
    let marker = at(&hand, "Marker Marker 1");
    hand.double_click(marker);
    hand.settle();
    let name = hand.text_field("Name of the marker");
    hand.type_over(name, "door");
    assert_eq!(hand.look().markers[0].name, "door");
    // Keys of the keyboard go from marker to marker, and from key to key.
    go(&mut hand, 0.0);
    let over = at(&hand, "Time key 2 of Diffuse: Opacity");
    hand.hover(over);
    hand.key_with(Modifiers::ALT, Key::CloseBracket);
    assert_eq!(hand.app().session().view().time(), time);
    hand.key(Key::OpenBracket);
    assert_eq!(hand.app().session().view().time(), 1.0);
    hand.key(Key::M);
    hand.settle();
    assert_eq!(hand.look().markers.len(), 2);
    while hand.app().session().steps().undo_label().is_some() {
        hand.undo();
        if *hand.look() == before {
            break;
        }
    }
    assert_eq!(*hand.look(), before);
}

#[test]
fn shift_on_the_ruler_chooses_the_part_that_is_played() {
    let mut hand = keyed();
    go(&mut hand, 0.0);
    let [start, end] = ["Time key 1 of Diffuse: Cut-off", "Time key 2 of Diffuse: Cut-off"]
        .map(|key| at(&hand, key).x);
    let top = hand.place("Playhead").top() + 6.0;
    let x = |seconds: f32| start + (end - start) * 0.5 * seconds;
    assert!(!hand.has("Whole range"));
    hand.drag_with(Modifiers::SHIFT, pos2(x(0.5), top), pos2(x(1.5), top));
    hand.settle();
    assert!(hand.has("Whole range"), "a part is chosen");
    assert_eq!(hand.app().session().view().time(), 0.0, "the playhead stays");
    hand.press("Whole range");
    // Shift counts as at the press: the key may be let go before the first step of the drag.
    let press =
        |at: Pos2, pressed: bool, modifiers: Modifiers| eframe::egui::Event::PointerButton {
            pos: at,
            button: eframe::egui::PointerButton::Primary,
            pressed,
            modifiers,
        };
    let (from, to) = (pos2(x(0.25), top), pos2(x(0.75), top));
    hand.hover(from);
    hand.harness.event(press(from, true, Modifiers::SHIFT));
    hand.harness.run_steps(1);
    hand.move_to(to);
    hand.harness.event(press(to, false, Modifiers::NONE));
    hand.settle();
    assert!(hand.has("Whole range"));
    hand.press("Whole range");
    // Without Shift the playhead is moved.
    hand.drag(pos2(x(0.5), top), pos2(x(1.5), top));
    hand.settle();
    assert!(!hand.has("Whole range") && close(hand.app().session().view().time(), 1.5));
}

/// The head of the playhead is its own where it stands over an end of the range.
#[test]
fn the_playhead_is_dragged_off_an_end_of_the_range() {
    let mut hand = keyed();
    go(&mut hand, 1.0);
    let flag = |hand: &User| at(hand, "Start of the range");
    let (start, ruler) = (flag(&hand), hand.place("Playhead"));
    let middle = at(&hand, "Time key 2 of Diffuse: Opacity").x;
    let time = |hand: &User| hand.app().session().view().time();
    hand.click(pos2(start.x, ruler.top() + 4.0));
    hand.settle();
    assert_eq!(time(&hand), 0.0);
    hand.drag(pos2(start.x, ruler.top() + 13.0), pos2(middle, ruler.top() + 13.0));
    hand.settle();
    assert!(close(time(&hand), 1.0) && flag(&hand) == start, "{}", time(&hand));
    // The flag is dragged where nothing is over it, and below the head.
    hand.drag(start, pos2(start.x + 20.0, start.y));
    hand.settle();
    assert!(close(time(&hand), 1.0) && flag(&hand).x > start.x, "{}", time(&hand));
    hand.click(pos2(flag(&hand).x, ruler.top() + 4.0));
    hand.settle();
    let (before, moved) = (time(&hand), flag(&hand));
    hand.drag(pos2(moved.x, ruler.bottom() - 2.0), pos2(moved.x + 20.0, ruler.bottom() - 2.0));
    hand.settle();
    assert!(time(&hand) == before && flag(&hand).x > moved.x, "{}", time(&hand));
}

/// A key that was dragged has the focus, for its arrows: undo, and the keys of the transport, work
/// all the same.
#[test]
fn undo_and_the_transport_are_heard_while_a_key_has_the_focus() {
    let mut hand = keyed();
    let before = hand.look().clone();
    let key = at(&hand, "Time key 2 of Diffuse: Opacity");
    hand.drag(key, key + vec2(40.0, 0.0));
    hand.settle();
    assert_ne!(*hand.look(), before);
    hand.key_with(Modifiers::COMMAND, Key::Z);
    hand.settle();
    assert_eq!(*hand.look(), before);
    go(&mut hand, 1.0);
    hand.click(key);
    hand.settle();
    // The graph has this key, too.
    hand.key(Key::Home);
    hand.settle();
    assert_eq!(hand.app().session().view().time(), 0.0);
    hand.click(key);
    hand.settle();
    hand.key(Key::Space);
    hand.harness.step();
    assert!(hand.has("Pause"), "it plays");
    hand.key(Key::Space);
    hand.settle();
    assert!(hand.has("Play"));
}
