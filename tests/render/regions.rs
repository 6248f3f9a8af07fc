//! Groups that run for each light of a set, and the nodes that join what comes of them.
#![cfg(feature = "gpu")]

use crate::support::eval::{look, renderer, scene_of, shape, told};
use crate::support::wait::block_on;
use chiaro::compile::Live;
use chiaro::document::Scene;
use chiaro::frame::{FramePlan, PlanOptions, Planner, Setup, SetupLook};
use chiaro::library::Library;
use serde_json::{Value as Json, json};

/// Three lights: a directional, a point and a spot light.
fn lights() -> Json {
    json!({
        "key": {"direction": [1, 2, 3], "color": [0.9, 0.5, 0.2], "intensity": 0.8,
            "groups": ["set"]},
        "fill": {"type": "point", "position": [-2, 1, 2], "space": "world", "half_distance": 2,
            "color": [0.2, 0.4, 0.9], "groups": ["set"]},
        "rim": {"type": "spot", "position": [0, 3, -1], "aim": [0, -3, 1.5], "space": "world",
            "inner": 0.2, "outer": 0.6, "color": [0.8, 0.9, 0.7], "name": "Rim light"}})
}

/// A look of a group that runs for each light of `set`: the light's tone and color, joined by a
/// node of a kind, with values of its own.
fn region(set: &str, kind: &str, output: &str, values: &Json) -> SetupLook {
    let mut wires = vec![
        json!({"from": "lamp", "to": "angle.light"}),
        json!({"from": "angle", "to": "tone.angle"}),
        json!({"from": "lamp", "to": "parts.light"}),
        json!({"from": "tone", "to": "scaled.b"}),
        json!({"from": "parts.color", "to": "scaled.a"}),
        json!({"from": "scaled", "to": format!("join.{}", input_of(kind))}),
        json!({"from": format!("join.{output}"), "to": "outputs.color"}),
    ];
    if kind == "mix_of_lights" {
        wires.push(json!({"from": "tone", "to": "join.weight"}));
    } else if kind == "strongest_of_lights" {
        wires.push(json!({"from": "tone", "to": "join.strength"}));
    }
    look(&json!({"name": "region", "lights": lights(),
        "definitions": {"lamps": {
            "outputs": [{"name": "color"}],
            "nodes": [
                {"id": "lamp", "kind": "light"}, {"id": "parts", "kind": "light_parts"},
                {"id": "angle", "kind": "parametrization"}, {"id": "tone", "kind": "profile"},
                {"id": "scaled", "kind": "multiply"},
                {"id": "join", "kind": kind, "values": values}],
            "wires": wires}},
        "nodes": [{"id": "each", "kind": "lamps", "for_each": set},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "each", "to": "output.color"}]}))
}

fn input_of(kind: &str) -> &'static str {
    match kind {
        "sum_of_lights" | "greatest_of_lights" => "value",
        _ => "color",
    }
}

/// The same for one light, by hand, with nothing that joins.
fn alone(id: &str) -> SetupLook {
    look(&json!({"name": "alone", "lights": lights(),
        "nodes": [
            {"id": "lamp", "kind": "light", "values": {"light": id}},
            {"id": "parts", "kind": "light_parts"}, {"id": "angle", "kind": "parametrization"},
            {"id": "tone", "kind": "profile"}, {"id": "scaled", "kind": "multiply"},
            {"id": "output", "kind": "output"}],
        "wires": [
            {"from": "lamp", "to": "angle.light"}, {"from": "angle", "to": "tone.angle"},
            {"from": "lamp", "to": "parts.light"}, {"from": "tone", "to": "scaled.b"},
            {"from": "parts.color", "to": "scaled.a"}, {"from": "scaled", "to": "output.color"}]}))
}

fn setup(look: SetupLook) -> Setup {
    let (mesh, fitted) = shape("sphere");
    scene_of(vec![(look, mesh, fitted)], Scene { backdrop: None, ..Scene::default() })
}

fn plan(setup: &Setup, live: &Live) -> FramePlan {
    let options = PlanOptions { size: [96, 96], samples: 1, time: 0.0 };
    Planner::default()
        .plan(setup, Library::built_in(), live, &options)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)))
        .value
}

fn pixels(look: SetupLook, live: &Live) -> Vec<[f32; 4]> {
    let plan = plan(&setup(look), live);
    block_on(renderer().picture(&plan)).unwrap_or_else(|error| panic!("{error}")).rgba
}

#[test]
fn lights_are_joined_as_their_pictures_are() {
    let ids = ["key", "fill", "rim"];
    let each = ids.map(|id| pixels(alone(id), &Live::Keyed));
    let sum = |colors: [[f32; 4]; 3], channel: usize| {
        colors.iter().map(|color| color[channel]).sum::<f32>()
    };
    let greatest = |colors: [[f32; 4]; 3], channel: usize| {
        colors.iter().map(|color| color[channel]).fold(0.0, f32::max)
    };
    type JoinCase<'a> = (&'a str, &'a str, &'a dyn Fn([[f32; 4]; 3], usize) -> f32);
    let cases: [JoinCase<'_>; 3] = [
        ("sum_of_lights", "sum", &sum),
        ("greatest_of_lights", "greatest", &greatest),
        ("layers_of_lights", "layers", &|colors, channel| colors[2][channel]),
    ];
    for (kind, output, joined) in cases {
        for live in [Live::Keyed, Live::All] {
            let got = pixels(region("*", kind, output, &json!({})), &live);
            let mut shown = 0;
            for (index, got) in got.iter().enumerate() {
                if each[0][index][3] == 0.0 {
                    continue;
                }
                shown += 1;
                let colors = [each[0][index], each[1][index], each[2][index]];
                // The cone ends within the picture: a light that does not arrive is left out.
                if kind == "layers_of_lights" && colors[2][..3] == [0.0; 3] {
                    continue;
                }
                for channel in 0..3 {
                    let wanted = joined(colors, channel);
                    assert!(
                        (got[channel] - wanted).abs() < 2e-3,
                        "{kind} {live:?} {index}: {got:?} for {wanted}"
                    );
                }
            }
            assert!(shown > 3000, "{shown} pixels");
        }
    }
}

/// The messages of all problems of a look.
fn problems(look: &SetupLook) -> Vec<String> {
    match chiaro::compile::check(&look.look, Library::built_in(), None) {
        Ok(checked) => checked.warnings.iter().map(ToString::to_string).collect(),
        Err(problems) => problems.iter().map(ToString::to_string).collect(),
    }
}

#[test]
fn sets_choose_the_lights_and_what_is_dark_costs_nothing() {
    let of = |set: &str| pixels(region(set, "sum_of_lights", "sum", &json!({})), &Live::Keyed);
    let all = of("*");
    assert!(of("group:set | \"Rim light\"") == all);
    assert!(of("group:set") != all && of("key") != of("fill"));
    // No light at all is what the sum begins with.
    assert!(of("").iter().all(|color| color[..3] == [0.0; 3]));
    // A light that is out of a scene's mix is as if it were not in the set.
    let mut muted = setup(region("*", "mix_of_lights", "mix", &json!({})));
    muted.scene.muted = chiaro::document::LightSet::parse("fill").unwrap();
    let without = setup(region("* - fill", "mix_of_lights", "mix", &json!({})));
    let [muted_plan, without_plan] = [&muted, &without].map(|setup| plan(setup, &Live::Keyed));
    assert_eq!(muted_plan.draws[0].look.wgsl, without_plan.draws[0].look.wgsl);
    for live in [Live::Keyed, Live::All] {
        let [muted, without] = [&muted, &without].map(|setup| {
            block_on(renderer().picture(&plan(setup, &live))).unwrap_or_else(|e| panic!("{e}")).rgba
        });
        assert!(muted == without, "{live:?}");
    }
}

#[test]
fn lights_of_the_scene_are_in_the_sets_of_looks() {
    let whole = region("*", "sum_of_lights", "sum", &json!({}));
    let mut parted = setup(whole.clone());
    let rim = parted.looks[0].look.lights.shift_remove("rim").unwrap();
    parted.scene.lights.insert("rim".into(), rim);
    let [parted, whole] = [parted, setup(whole)].map(|setup| plan(&setup, &Live::Keyed));
    let [parted, whole] = [parted, whole].map(|plan| {
        block_on(renderer().picture(&plan)).unwrap_or_else(|error| panic!("{error}")).rgba
    });
    assert!(parted == whole);
}

#[test]
fn what_is_not_joined_is_told() {
    let mut open = region("* | kez", "sum_of_lights", "sum", &json!({}));
    let inner = &mut open.look.definitions.values_mut().next().unwrap().graph;
    let wire = inner.wires.iter_mut().find(|wire| wire.to.node.as_str() == "outputs").unwrap();
    wire.from.node = "scaled".into();
    wire.from.port = Default::default();
    let told = problems(&open).join("\n");
    for words in [
        "error[not-joined]: the output `color` differs from light to light",
        "node `each`, port `color`",
        "warning[unknown-light]: `for_each` names the light `kez`, which there is not",
        "did you mean `key`?",
    ] {
        assert!(told.contains(words), "{words}\n{told}");
    }
    // What is the same for all lights may leave as it is.
    let inner = &mut open.look.definitions.values_mut().next().unwrap().graph;
    let wire = inner.wires.iter_mut().find(|wire| wire.to.node.as_str() == "outputs").unwrap();
    wire.from.node = "base".into();
    inner.nodes.insert(
        "base".into(),
        chiaro::document::Node { kind: "base".to_owned(), ..Default::default() },
    );
    let told = problems(&open).join("\n");
    assert!(!told.contains("not-joined"), "{told}");
}
