//! Work on 5,000 nodes: a look is opened, searched, edited and grouped, and all of it is undone.
//! Times are printed, and judged by nobody.
#![allow(clippy::print_stdout, reason = "times are told")]

use chiaro::clock::Clock;
use chiaro::document::Value;
use eframe::egui::{Key, Modifiers, vec2};
use serde_json::json;

use super::artist::{JourneyUser, Studio};

const COUNT: usize = 5000;
/// Index of a node in the middle of the chain; the nodes before and behind it have names too.
const NEEDLE: usize = 2487;

/// A chain of small sums, laid out in a square: the first value is how much the surface faces the
/// eye, and each node adds a little.
fn look() -> String {
    let columns = 71;
    let sums = COUNT - 2;
    let at = |index: usize| [240 * (index % columns), 160 * (index / columns)];
    let name = |index: usize| match index.wrapping_sub(NEEDLE - 1) {
        0 => "Thread",
        1 => "Needle",
        2 => "Eye",
        _ => "",
    };
    let sum = |index: usize| {
        json!({
            "id": format!("n{index}"), "kind": "add", "at": at(index + 1), "name": name(index),
            "values": {"b": 0.00005}
        })
    };
    let ends = [
        json!({"id": "start", "kind": "facing", "at": at(0)}),
        json!({"id": "output", "kind": "output", "at": at(sums + 1)}),
    ];
    let nodes: Vec<_> = (0..sums).map(sum).chain(ends).collect();
    let wire = |from: String, to: String| json!({"from": from, "to": to});
    let chain = (1..sums).map(|index| wire(format!("n{}", index - 1), format!("n{index}.a")));
    let ends = [
        wire("start".into(), "n0.a".into()),
        wire(format!("n{}", sums - 1), "output.color".into()),
    ];
    let wires: Vec<_> = chain.chain(ends).collect();
    json!({"name": "Many", "nodes": nodes, "wires": wires}).to_string()
}

fn timed<T>(what: &str, work: impl FnOnce() -> T) -> T {
    let clock = Clock::start();
    let result = work();
    println!("{what}: {:.2} s", clock.seconds());
    result
}

/// Median time of a frame while the view moves, in milliseconds.
fn frames(artist: &mut JourneyUser) -> f64 {
    let at = artist.on_canvas(0.5, 0.5);
    artist.hover(at);
    let frame = |step: u8| {
        let clock = Clock::start();
        artist.move_to(at + vec2(f32::from(step % 9) * 4.0, f32::from(step % 5) * 3.0));
        clock.seconds() * 1e3
    };
    let mut times: Vec<f64> = (0..40).map(frame).collect();
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

#[test]
fn five_thousand_nodes_are_worked_on() {
    let studio = Studio::new();
    studio.write("many.json", &look());
    let mut artist = studio.window();
    artist.app_mut().show_on("shape:sphere");
    artist.settle();
    timed("opened, compiled and drawn", || artist.open(&studio.path("many.json")));
    assert_eq!(artist.look().graph.nodes.len(), COUNT);
    assert!(artist.errors().is_empty(), "{:?}", artist.errors());
    println!("a frame with all in view: {:.1} ms", frames(&mut artist));
    let opened = artist.look().clone();
    let first = artist.picture();

    // The node is found by its name and brought into view.
    artist.key_with(Modifiers::COMMAND, Key::F);
    artist.type_text("needle");
    artist.press("Node: Needle");
    assert_eq!(artist.selected(), [format!("n{NEEDLE}")]);
    let at = artist.on_canvas(0.5, 0.9);
    artist.hover(at);
    artist.key(Key::Period);
    artist.settle();
    let needle = artist.place_like("Node Needle");
    assert!(
        artist.place("Node canvas").contains_rect(needle) && needle.width() > 60.0,
        "it is seen: {needle:?}"
    );
    println!("a frame close up: {:.1} ms", frames(&mut artist));

    // A value of one node of 5,000 changes the picture.
    timed("a value is set and seen", || artist.set("B", "0.2"));
    let brighter = artist.picture();
    let gain = brighter.brightness() - first.brightness();
    assert!(gain > 10.0 && gain < 0.21 * 255.0, "{gain}");

    // Three nodes become one group, and the picture stays.
    let middle = artist.on_canvas(0.5, 0.5);
    artist.wheel(middle, -300.0);
    for name in ["Thread", "Eye"] {
        let at = artist.place_like(&format!("Node {name}")).center_top() + vec2(0.0, 4.0);
        artist.click_with(Modifiers::SHIFT, at);
    }
    assert_eq!(artist.selected().len(), 3, "{:?}", artist.selected());
    timed("grouped", || {
        artist.key_with(Modifiers::COMMAND, Key::G);
        artist.settle();
    });
    assert_eq!(artist.look().graph.nodes.len(), COUNT - 2);
    assert!(artist.errors().is_empty(), "{:?}", artist.errors());
    artist.picture().equals(&brighter);

    timed("all is taken back", || artist.undo_all());
    assert_eq!(*artist.look(), opened);
    assert!(!artist.app().session().is_dirty());
    artist.picture().equals(&first);
    // The change is redone, to be saved.
    artist.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    artist.settle();
    let value = &artist.look().graph.nodes[format!("n{NEEDLE}").as_str()].values["b"];
    assert_eq!(*value, Value::Number(0.2));
    timed("saved, opened, drawn and exported", || studio.finish(artist, "many.json"));
}
