//! The terminator of a light that only groups draw which run for each light.

use chiaro::document::Light;
use eframe::egui::{Pos2, vec2};

use crate::editor_support::User;

/// A look whose group `lamps` runs for each light; `tones` are its nodes beside the lamp and the
/// sum, `joined` the one that is summed. The cut-off of the first comes from the group's input.
fn look(tones: &str, wires: &str, joined: &str) -> String {
    format!(
        r#"{{"lights": {{"key": {{"direction": [-0.5, 0.7, 0.6], "space": "world"}}}},
        "definitions": {{"lamps": {{"label": "Lamps",
            "inputs": [{{"name": "cutoff"}}], "outputs": [{{"name": "color"}}],
            "nodes": [{{"id": "lamp", "kind": "light"}},
                {{"id": "angle", "kind": "parametrization"}}, {tones},
                {{"id": "sum", "kind": "sum_of_lights"}}],
            "wires": [{{"from": "lamp", "to": "angle.light"}}, {wires},
                {{"from": "{joined}", "to": "sum.value"}},
                {{"from": "sum", "to": "outputs.color"}}]}}}},
        "nodes": [{{"id": "each", "kind": "lamps", "for_each": "*", "values": {{"cutoff": 1.7}}}},
            {{"id": "output", "kind": "output"}}],
        "wires": [{{"from": "each", "to": "output.color"}}]}}"#
    )
}

const TONE: &str =
    r#"{"id": "tone", "kind": "profile", "values": {"offset": 0.2, "falloff": 1.1}}"#;
const OF_TONE: &str =
    r#"{"from": "angle", "to": "tone.angle"}, {"from": "inputs.cutoff", "to": "tone.cutoff"}"#;

/// A window with a look on a ball, placing by the terminator.
fn placing(look: &str) -> (tempfile::TempDir, User) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("look.json");
    std::fs::write(&path, look).unwrap();
    let mut hand = User::new();
    hand.app_mut().open(&path);
    hand.app_mut().show_on("shape:sphere");
    hand.settle();
    assert!(hand.errors().is_empty(), "{:?}", hand.errors());
    hand.press("Place light");
    hand.press("Place by its terminator");
    (folder, hand)
}

fn at(hand: &User, x: f32, y: f32) -> Pos2 {
    let rect = hand.app().viewport().rect().unwrap();
    rect.center() + vec2(x, -y) * rect.height()
}

fn key(hand: &User) -> Light {
    hand.look().lights["key"].clone()
}

/// Tone of a node in the group at a point of the picture, as the probe reads it.
fn probed(hand: &mut User, point: Pos2, node: &str) -> f64 {
    hand.press("Probe pixel");
    hand.click(point);
    hand.settle();
    let wires = hand.app().probe().wires();
    let mut of_node = wires.iter().rev().filter(|wire| wire.node.to_string() == node);
    of_node.next().unwrap_or_else(|| panic!("{node}: {wires:?}")).double[0]
}

#[test]
fn the_terminator_of_a_group_that_runs_for_each_light_goes_where_the_model_is_clicked() {
    let (_folder, mut hand) = placing(&look(TONE, OF_TONE, "tone"));
    let (old, steps, place) = (key(&hand), hand.steps(), at(&hand, 0.12, 0.05));
    hand.click(place);
    hand.settle();
    let hint = hand.app().placing().hint().to_owned();
    assert!(hint.starts_with("The terminator of key is there"), "{hint}");
    assert!(hint.contains("in Profile in Lamps"), "{hint}");
    assert_ne!(key(&hand), old);
    assert_eq!(hand.steps(), steps + 1, "a click is a step");
    let tone = probed(&mut hand, place, "each/tone");
    assert!((tone - 0.5).abs() < 1e-4, "{tone}");
}

#[test]
fn of_two_profiles_in_a_group_the_selected_one_is_meant() {
    let tones = format!(
        r#"{TONE}, {{"id": "rim", "kind": "profile", "name": "Rim",
        "values": {{"offset": 0.4, "falloff": 0.5, "cutoff": 0.6}}}},
        {{"id": "both", "kind": "add"}}"#
    );
    let wires = format!(
        r#"{OF_TONE}, {{"from": "angle", "to": "rim.angle"}}, {{"from": "tone", "to": "both.a"}},
        {{"from": "rim", "to": "both.b"}}"#
    );
    let (_folder, mut hand) = placing(&look(&tones, &wires, "both"));
    let (old, place) = (key(&hand), at(&hand, -0.1, 0.1));
    hand.click(place);
    hand.settle();
    let hint = hand.app().placing().hint().to_owned();
    let wanted = "key has 2 terminators: Profile in Lamps, Rim in Lamps. Open the group";
    assert!(hint.starts_with(wanted), "{hint}");
    assert_eq!(hint.matches("terminators").count(), 1, "it is told once: {hint}");
    assert_eq!(key(&hand), old);
    hand.app_mut().session_mut().open_graph(&["each".into()]);
    hand.app_mut().session_mut().select(vec!["rim".into()]);
    hand.settle();
    hand.click(place);
    hand.settle();
    assert_ne!(key(&hand), old);
    let tone = probed(&mut hand, place, "each/rim");
    assert!((tone - 0.5).abs() < 1e-4, "{tone}");
}

#[test]
fn a_group_without_a_profile_says_why_it_has_no_terminator() {
    let tones = r#"{"id": "parts", "kind": "light_parts"}"#;
    let wires = r#"{"from": "lamp", "to": "parts.light"}"#;
    let (_folder, mut hand) = placing(&look(tones, wires, "parts.intensity"));
    let (old, place) = (key(&hand), at(&hand, 0.1, 0.1));
    hand.click(place);
    hand.settle();
    let hint = hand.app().placing().hint().to_owned();
    assert!(hint.starts_with("Lamps draws key, but by no profile"), "{hint}");
    assert!(hint.contains("by its highlight or its shadow"), "{hint}");
    assert_eq!(key(&hand), old);
}
