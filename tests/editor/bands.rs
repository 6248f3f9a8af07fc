//! Bands, edges and shaped highlights: made in the list of layers, shaped on the object.

use std::f64::consts::PI;

use eframe::egui::{Pos2, vec2};

use crate::editor_support::User;
use chiaro::document::{DirectionKey, Ramp, Target, Value};

fn ramp(hand: &User, node: &str) -> Ramp {
    match hand.look().graph.nodes[node].values.get("bands") {
        Some(Value::Ramp(ramp)) => ramp.clone(),
        other => panic!("no bands: {other:?}"),
    }
}

fn number(hand: &User, node: &str, port: &str) -> f64 {
    match hand.look().graph.nodes[node].values.get(port) {
        Some(Value::Number(number)) => *number,
        other => panic!("{port} is no number: {other:?}"),
    }
}

/// Point of a line that is nearest to the middle of the picture.
fn grip(hand: &User, line: &str) -> Pos2 {
    let center = hand.app().viewport().rect().expect("a picture").center();
    let points = hand.app().viewport().curve(line).into_iter();
    points.min_by(|a, b| a.distance(center).total_cmp(&b.distance(center))).expect("a line")
}

#[test]
fn bands_edges_and_a_highlight_are_shaped_on_the_object() {
    let mut hand = User::new();
    hand.app_mut().show_on("shape:sphere");
    hand.settle();
    hand.press("Add layer");
    hand.press("Add Bands");
    hand.settle();
    assert!(hand.errors().is_empty(), "{:?}", hand.errors());
    assert_eq!(ramp(&hand, "bands").stops.len(), 3);

    // Both edges are lines on the object; one is dragged, in one step.
    let from = grip(&hand, "0");
    hand.drag(from, from + vec2(14.0, 14.0));
    hand.settle();
    let edge = ramp(&hand, "bands").stops[1].at;
    assert!((edge - 0.3).abs() > 0.01 && (0.1..0.475).contains(&edge), "{edge}");
    assert!(grip(&hand, "0").distance(from) > 4.0, "the line went along");
    hand.undo();
    assert_eq!(ramp(&hand, "bands").stops[1].at, 0.3, "one step");

    // The list has them too: a band more, and an edge on the bar of the layer's row.
    hand.press("Split band 1");
    assert_eq!(ramp(&hand, "bands").stops.len(), 4);
    let bar = hand.place("Edge 3 of the bands of Bands").center();
    hand.drag(bar, bar + vec2(12.0, 0.0));
    hand.settle();
    assert!(ramp(&hand, "bands").stops[3].at > 0.5, "{:?}", ramp(&hand, "bands"));
    let search = hand.place("Find a value");
    hand.type_over(search, "Bands");
    let softness = hand.number_field("Softness");
    hand.type_over(softness, "6");
    let soft = ramp(&hand, "bands");
    assert_eq!(soft.stops.len(), 6, "two stops for each edge");
    assert!(((soft.stops[1].at - soft.stops[0].at) * PI - 6_f64.to_radians()).abs() < 1e-4);

    // A cartoon's edge is one value, and its three angles are behind it.
    hand.press("Add layer");
    hand.press("Add Cartoon");
    hand.settle();
    let search = hand.place("Find a value");
    hand.type_over(search, "edge");
    for (label, degrees) in [("Edge", "60"), ("Softness", "10")] {
        let field = hand.number_field(label);
        hand.type_over(field, degrees);
    }
    for (port, degrees) in [("offset", 55.0_f64), ("falloff", 60.0), ("cutoff", 65.0)] {
        let is = number(&hand, "cartoon", port).to_degrees();
        assert!((is - degrees).abs() < 1e-6, "{port}: {is}");
    }
    let from = grip(&hand, "falloff");
    hand.drag(from, from + vec2(12.0, 12.0));
    hand.settle();
    let angles = ["offset", "falloff", "cutoff"].map(|port| number(&hand, "cartoon", port));
    assert!((angles[1].to_degrees() - 60.0).abs() > 1.0, "{angles:?}");
    assert!((angles[2] - angles[0] - 10_f64.to_radians()).abs() < 1e-6, "as soft as before");

    // A highlight is moved, turned and stretched by its handles.
    hand.press("Add layer");
    hand.press("Add Cut highlight");
    hand.settle();
    assert!(hand.errors().is_empty(), "{:?}", hand.errors());
    let at = |hand: &User, label| hand.app().viewport().highlight_handle(label).expect(label);
    let middle = at(&hand, "Move");
    hand.drag(middle, middle + vec2(30.0, -12.0));
    hand.settle();
    assert!(number(&hand, "cut_highlight", "across") > 0.05, "to the right");
    assert!(number(&hand, "cut_highlight", "up") > 0.01, "and up");
    assert!(at(&hand, "Move").distance(middle + vec2(30.0, -12.0)) < 6.0, "it is at the pointer");
    let (turn, before) = (at(&hand, "Turn"), number(&hand, "cut_highlight", "turn"));
    let arm = turn - at(&hand, "Move");
    hand.drag(turn, at(&hand, "Move") + vec2(arm.y, -arm.x));
    hand.settle();
    let turned = number(&hand, "cut_highlight", "turn") - before;
    assert!((turned - 0.5 * PI).abs() < 0.3, "a quarter turn to the left: {turned}");
    let (stretch, center) = (at(&hand, "Stretch"), at(&hand, "Move"));
    hand.drag(stretch, stretch + (stretch - center));
    hand.settle();
    assert!(number(&hand, "cut_highlight", "stretch") > 0.2);
    let size = at(&hand, "Size");
    let way = (size - at(&hand, "Move")).normalized();
    hand.drag(size, size + 80.0 * way);
    hand.settle();
    let radii = ["offset", "falloff", "cutoff"].map(|port| number(&hand, "cut_highlight", port));
    assert!(radii[0] > 0.3 && radii[0] == radii[2], "larger, and hard: {radii:?}");
    let (split, center) = (at(&hand, "Split"), at(&hand, "Move"));
    let before = number(&hand, "cut_highlight", "split");
    hand.drag(split, split + 1.5 * (split - center));
    hand.settle();
    let apart = number(&hand, "cut_highlight", "split");
    assert!(apart > before + 0.2, "{apart} after {before}");

    // Square and star have values beside their handles, as all have.
    for (label, port, value) in [("Square", "square", "0.6"), ("Star", "star", "0.25")] {
        hand.set(label, value);
        assert_eq!(number(&hand, "cut_highlight", port).to_string(), value);
    }
    assert!(hand.errors().is_empty(), "{:?}", hand.errors());
    is_keyed_by_view(&mut hand);
}

/// A handle of a highlight that is keyed by the view sets the key of this view alone.
fn is_keyed_by_view(hand: &mut User) {
    let target = Target::parse("cut_highlight.turn").expect("a target");
    let own = number(hand, "cut_highlight", "turn");
    hand.key_by_view(&target, 0.0);
    let at = |hand: &User, label| hand.app().viewport().highlight_handle(label).expect(label);
    let (turn, middle) = (at(hand, "Turn"), at(hand, "Move"));
    let arm = turn - middle;
    hand.drag(turn, middle + vec2(arm.y, -arm.x));
    hand.settle();
    let turn_of = |key: &DirectionKey| match key.values[&target] {
        Value::Number(turn) => turn,
        ref other => panic!("{other:?}"),
    };
    let turns: Vec<f64> = hand.look().direction_keys[0].keys.iter().map(turn_of).collect();
    assert!((turns[0] - 0.5 * PI).abs() < 0.3, "the key in front: {turns:?}");
    assert_eq!((turns[1], number(hand, "cut_highlight", "turn")), (0.0, own), "the others stay");
}
