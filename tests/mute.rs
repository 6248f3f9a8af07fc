//! A muted node lets through what comes in.
#![cfg(feature = "gpu")]

mod support;

use chiaro::compile::{Options, compile};
use chiaro::document::Look;
use chiaro::frame::EvalSample;
use chiaro::library::Library;
use serde_json::{Value as Json, json};
use support::eval::{eval, look};

fn stack() -> Json {
    json!({
        "lights": {"key": {"direction": [0, 0, 1]}},
        "nodes": [
            {"id": "base", "kind": "base", "values": {"color": [0.1, 0.2, 0.3]}},
            {"id": "first", "kind": "light_layer", "values": {"light": "key", "convex": [0.5, 0.5, 0.5], "blend": "alpha", "offset": 4}},
            {"id": "second", "kind": "light_layer", "values": {"light": "key", "convex": [0.9, 0.1, 0.1], "blend": "add", "offset": 4}},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "base", "to": "first.below"}, {"from": "first", "to": "second.below"},
            {"from": "second", "to": "output.color"}
        ]
    })
}

fn color(json: &Json) -> [f64; 4] {
    eval(&look(json), "", &[EvalSample::default()])[0]
}

fn close(got: [f64; 4], wanted: [f64; 3]) {
    assert!(got.iter().zip(wanted).all(|(got, wanted)| (got - wanted).abs() < 1e-6), "{got:?} for {wanted:?}");
}

#[test]
fn a_muted_layer_is_as_if_it_were_not_there() {
    let mut look = stack();
    close(color(&look), [1.0, 0.6, 0.6]);
    look["nodes"][2]["muted"] = json!(true);
    close(color(&look), [0.5, 0.5, 0.5]);
    look["nodes"][1]["muted"] = json!(true);
    close(color(&look), [0.1, 0.2, 0.3]);
    look["nodes"][2]["muted"] = json!(false);
    close(color(&look), [1.0, 0.3, 0.4]);
}

#[test]
fn a_muted_node_gives_its_subject_wired_or_not() {
    let math = |muted: bool, wires: Json| {
        json!({
            "nodes": [
                {"id": "one", "kind": "number", "values": {"value": 0.25}},
                {"id": "sum", "kind": "add", "muted": muted, "values": {"a": 0.75, "b": 0.125}},
                {"id": "output", "kind": "output"}
            ],
            "wires": wires
        })
    };
    let unwired = json!([{"from": "sum", "to": "output.color"}]);
    close(color(&math(false, unwired.clone())), [0.875; 3]);
    close(color(&math(true, unwired)), [0.75; 3]);
    let wired = json!([{"from": "one", "to": "sum.a"}, {"from": "sum", "to": "output.color"}]);
    close(color(&math(true, wired)), [0.25; 3]);
}

#[test]
fn what_has_nothing_to_let_through_gives_zero() {
    let look = json!({
        "lights": {"key": {"direction": [0, 0, 1]}},
        "nodes": [
            {"id": "light", "kind": "light", "values": {"light": "key"}},
            {"id": "angle", "kind": "parametrization"},
            {"id": "tone", "kind": "profile", "muted": true, "values": {"offset": 4}},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "light", "to": "angle.light"}, {"from": "angle", "to": "tone.angle"},
            {"from": "tone", "to": "output.color"}
        ]
    });
    close(color(&look), [0.0; 3]);
}

/// Every kind of node may be muted in any look without harm: it compiles as well as before.
#[test]
fn every_node_of_every_example_can_be_muted() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/looks");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let Some(original) = (path.extension().is_some_and(|e| e == "json")).then(|| Look::load(&path)) else {
            continue;
        };
        let original = original.value.unwrap();
        for id in original.graph.nodes.keys() {
            let mut look = original.clone();
            look.graph.nodes[id].muted = true;
            if let Err(problems) = compile(&look, Library::built_in(), &Options::default()) {
                panic!("{} with {id} muted: {problems:?}", path.display());
            }
            count += 1;
        }
    }
    assert!(count > 50);
}
