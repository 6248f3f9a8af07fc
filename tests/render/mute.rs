//! Muted nodes: they pass their input through.
#![cfg(feature = "gpu")]

use crate::support::eval::{eval, look};
use chiaro::compile::{CompileOptions, compile};
use chiaro::document::Look;
use chiaro::frame::EvalSample;
use chiaro::library::Library;
use serde_json::{Value as Json, json};

fn stack() -> Json {
    json!({
        "lights": {"key": {"direction": [0, 0, 1]}},
        "nodes": [
            {"id": "base", "kind": "base", "values": {"color": [0.1, 0.2, 0.3]}},
            {
                "id": "first", "kind": "light_layer",
                "values": {"light": "key", "convex": [0.5, 0.5, 0.5], "blend": "alpha", "offset": 4}
            },
            {
                "id": "second", "kind": "light_layer",
                "values": {"light": "key", "convex": [0.9, 0.1, 0.1], "blend": "add", "offset": 4}
            },
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
    assert!(
        got.iter().zip(wanted).all(|(got, wanted)| (got - wanted).abs() < 1e-6),
        "{got:?} for {wanted:?}"
    );
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

/// A muted node passes on the default of an unwired port, wherever the node stands in the file: a
/// value, or a context.
#[test]
fn a_muted_node_lets_through_what_its_unwired_port_has() {
    let shown = |kind: &str, is_first: bool| {
        let mut nodes = vec![
            json!({"id": "light", "kind": "light", "values": {"light": "key"}}),
            json!({"id": "node", "kind": kind, "muted": true}),
            json!({"id": "output", "kind": "output"}),
        ];
        if !is_first {
            nodes.reverse();
        }
        let mut wires = vec![json!({"from": "node", "to": "output.color"})];
        if kind == "hcbtf_lookup" {
            wires.push(json!({"from": "light", "to": "node.light"}));
        }
        let look = look(
            &json!({"lights": {"key": {"direction": [0, 0, 1]}}, "nodes": nodes, "wires": wires}),
        );
        let sample =
            EvalSample { normal: glam::DVec3::new(0.6, 0.0, 0.8), ..EvalSample::default() };
        eval(&look, "", &[sample])[0]
    };
    for is_first in [true, false] {
        close(shown("hcbtf_lookup", is_first), [0.0; 3]);
        close(shown("mix_colors", is_first), [0.0; 3]);
        close(shown("bump_map", is_first), [0.6, 0.0, 0.8]);
    }
}

/// Each kind is muted alone, with nothing but the lights that it needs.
#[test]
fn every_kind_that_needs_no_stack_can_be_muted_alone() {
    use chiaro::library::{Fallback, Type};
    let mut count = 0;
    for (kind, def) in &Library::built_in().nodes {
        let must = |ty: &Type| *ty == Type::Light;
        let wired: Vec<_> =
            def.inputs.iter().filter(|input| input.fallback == Fallback::Wire).collect();
        let gives_color =
            def.outputs.first().is_some_and(|output| output.ty.convert_to(&Type::Color).is_some());
        if !gives_color || kind == "output" || wired.iter().any(|input| !must(&input.ty)) {
            continue;
        }
        let mut wires = vec![json!({"from": "node", "to": "output.color"})];
        wires.extend(
            wired
                .iter()
                .map(|input| json!({"from": "light", "to": format!("node.{}", input.name)})),
        );
        let look = look(&json!({
            "lights": {"key": {"direction": [0, 0, 1]}},
            "nodes": [
                {"id": "light", "kind": "light", "values": {"light": "key"}},
                {"id": "node", "kind": kind, "muted": true},
                {"id": "output", "kind": "output"}
            ],
            "wires": wires
        }));
        if let Err(problems) = compile(&look.look, Library::built_in(), &CompileOptions::default())
        {
            panic!("{kind} muted: {problems:?}");
        }
        count += 1;
    }
    assert!(count > 60, "{count}");
}

/// Every kind of node may be muted in any look without harm: it compiles as well as before.
#[test]
fn every_node_of_every_example_can_be_muted() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/looks");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let Some(original) = (path.extension().is_some_and(|e| e == "json"))
            .then(|| Look::load(&chiaro::files::Disk, &path))
        else {
            continue;
        };
        let original = original.value.unwrap();
        for id in original.graph.nodes.keys() {
            let mut look = original.clone();
            look.graph.nodes[id].muted = true;
            if let Err(problems) = compile(&look, Library::built_in(), &CompileOptions::default()) {
                panic!("{} with {id} muted: {problems:?}", path.display());
            }
            count += 1;
        }
    }
    assert!(count > 50);
}
