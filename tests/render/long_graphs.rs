//! Long looks: they compile in pieces, without recursion, to the right value.

use crate::support;
use chiaro::compile::{CompileOptions, Live, Stage, compile};
use chiaro::document::{LoadedDocument, Look};
use chiaro::library::Library;
use serde_json::json;

/// A chain of multiplications and additions, x -> a x + b, begun with the surface's curvature.
fn chain(count: usize) -> LoadedDocument<Look> {
    let mut nodes = vec![json!({"id": "start", "kind": "kappa"})];
    let mut wires = Vec::new();
    let mut from = "start".to_owned();
    for index in 0..count {
        let id = format!("n{index}");
        let (kind, b) = step(index);
        nodes.push(json!({"id": id, "kind": kind, "values": {"b": b}}));
        wires.push(json!({"from": from, "to": format!("{id}.a")}));
        from = id;
    }
    nodes.push(json!({"id": "output", "kind": "output"}));
    wires.push(json!({"from": from, "to": "output.color"}));
    let text = json!({"nodes": nodes, "wires": wires}).to_string();
    let loaded = Look::read(&text, "chain.json");
    let problems: Vec<String> =
        loaded.diagnostics.iter().take(5).map(ToString::to_string).collect();
    assert!(problems.is_empty(), "{problems:?}");
    loaded
}

fn look_of(chain: LoadedDocument<Look>) -> Look {
    chain.value.expect("a look")
}

fn step(index: usize) -> (&'static str, f64) {
    if index.is_multiple_of(2) {
        ("multiply", 0.75)
    } else {
        ("add", 0.125 + 0.001 * (index % 97) as f64)
    }
}

fn lines_of_longest_function(wgsl: &str) -> usize {
    wgsl.split("\nfn ")
        .map(|text| text.lines().take_while(|line| *line != "}").count())
        .max()
        .unwrap_or(0)
}

fn compiles(count: usize) {
    let shader = compile(&look_of(chain(count)), Library::built_in(), &CompileOptions::default())
        .expect("it compiles")
        .value;
    assert!(shader.wgsl.len() > 20 * count, "where did {count} nodes go?");
    let longest = lines_of_longest_function(&shader.wgsl);
    assert!(longest < 100, "a function of {longest} lines");
}

#[test]
fn two_thousand_nodes_compile_for_every_stage_and_liveness() {
    let look = look_of(chain(2000));
    for stage in [Stage::Draw, Stage::Eval] {
        for live in [Live::Keyed, Live::All] {
            compile(
                &look,
                Library::built_in(),
                &CompileOptions { stage, live, ..CompileOptions::default() },
            )
            .expect("it compiles");
        }
    }
    compiles(2000);
}

#[cfg(feature = "gpu")]
#[test]
fn four_thousand_nodes_give_the_closed_form() {
    use chiaro::frame::{EvalSample, SetupLook};
    let loaded = chain(4000);
    let source = loaded.source.clone().into();
    let setup = SetupLook { look: look_of(loaded), source, folder: std::path::PathBuf::new() };
    let starts = [0.0, 1.0, -3.0, 1000.0];
    let samples = starts.map(|kappa| EvalSample { kappa, ..EvalSample::default() });
    for (value, start) in support::eval::eval(&setup, "n3999.sum", &samples).iter().zip(starts) {
        let wanted = (0..4000)
            .map(step)
            .fold(start, |x, (kind, b)| if kind == "add" { x + b } else { x * b });
        assert!((value[0] - wanted).abs() < 1e-6, "{} for {wanted}", value[0]);
    }
    // The start still has an influence half way.
    for (value, start) in support::eval::eval(&setup, "n19.sum", &samples).iter().zip(starts) {
        let wanted =
            (0..20).map(step).fold(start, |x, (kind, b)| if kind == "add" { x + b } else { x * b });
        assert!(
            (value[0] - wanted).abs() < 1e-5 * wanted.abs().max(1.0),
            "{} for {wanted}",
            value[0]
        );
    }
}

/// Values that are read again much later are passed from part to part, through the parts of parts
/// between them.
#[cfg(feature = "gpu")]
#[test]
fn what_is_read_again_much_later_is_handed_on() {
    use chiaro::frame::{EvalSample, SetupLook};
    const COUNT: usize = 6000;
    const LATER: usize = 2900;
    let mut nodes = vec![json!({"id": "start", "kind": "kappa"})];
    let mut wires = Vec::new();
    let mut from = "start".to_owned();
    for index in 0..COUNT {
        let id = format!("n{index}");
        nodes.push(json!({"id": id, "kind": "mix_values", "values": {"b": 0.5, "factor": 0.25}}));
        wires.push(json!({"from": from, "to": format!("{id}.a")}));
        if index >= LATER && index % 13 == 0 {
            wires.push(json!({"from": format!("n{}", index - LATER), "to": format!("{id}.b")}));
        }
        from = id;
    }
    nodes.push(json!({"id": "output", "kind": "output"}));
    wires.push(json!({"from": from, "to": "output.color"}));
    let loaded = Look::read(&json!({"nodes": nodes, "wires": wires}).to_string(), "later.json");
    let source = loaded.source.clone().into();
    let look = loaded.value.expect("a look");
    let options = CompileOptions { live: Live::All, ..CompileOptions::default() };
    let shader = compile(&look, Library::built_in(), &options).expect("it compiles").value;
    assert!(
        lines_of_longest_function(&shader.wgsl) < 150,
        "{}",
        lines_of_longest_function(&shader.wgsl)
    );
    let setup = SetupLook { look, source, folder: std::path::PathBuf::new() };
    let sample = EvalSample { kappa: 7.0, ..EvalSample::default() };
    let mut values: Vec<f64> = Vec::new();
    for index in 0..COUNT {
        let a = values.last().copied().unwrap_or(sample.kappa);
        let b = if index >= LATER && index % 13 == 0 { values[index - LATER] } else { 0.5 };
        values.push(a + 0.25 * (b - a));
    }
    for at in [20, LATER + 13, COUNT - 1] {
        let name = format!("n{at}.value");
        let value = support::eval::eval(&setup, &name, std::slice::from_ref(&sample))[0][0];
        assert!((value - values[at]).abs() < 1e-5, "{value} for {} at {at}", values[at]);
    }
}

#[test]
fn twenty_thousand_nodes_compile() {
    compiles(20_000);
}

#[test]
fn a_hundred_thousand_nodes_compile() {
    compiles(100_000);
}
