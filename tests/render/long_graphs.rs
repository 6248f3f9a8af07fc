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
    assert!(shader.wgsl.len() > 10 * count, "where did {count} nodes go?");
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

/// Drivers compile in a time that is quadratic in the operations without a branch between them, and
/// by recursion over those that follow from one another; but they bear few loops.
#[test]
fn long_looks_are_handed_over_in_pieces() {
    use chiaro::wgsl::depth_of_entry_points;
    let pieces = |count, options: &CompileOptions| {
        let shader = compile(&look_of(chain(count)), Library::built_in(), options);
        let shader = shader.expect("it compiles").value;
        let loops = shader.wgsl.matches("for (var turn").count();
        (loops, depth_of_entry_points(&shader.valid.module))
    };
    let drawn = CompileOptions::default();
    assert_eq!(pieces(1000, &drawn).0, 0, "short looks stay as a person would write them");
    let (loops, depth) = pieces(20_000, &drawn);
    assert!((5..10).contains(&loops), "{loops}");
    assert!(depth < 20_000 / 4, "{depth}");
    let (loops, depth) = pieces(20_000, &CompileOptions { unspecialized: true, ..drawn });
    assert!(loops == 0 && depth > 20_000, "what no driver sees is left alone: {loops}, {depth}");
}

/// The pieces of a long look are the look: the interpreter, which has no driver, agrees.
#[cfg(feature = "gpu")]
#[test]
fn pieces_of_a_long_look_change_nothing() {
    use chiaro::frame::{Assets, EvalSample, SetupLook, eval_batches};
    use chiaro::interp::Precision;
    const COUNT: usize = 3000;
    let loaded = chain(COUNT);
    let source = loaded.source.clone().into();
    let setup = SetupLook { look: look_of(loaded), source, folder: std::path::PathBuf::new() };
    let samples = [EvalSample { kappa: 2.5, ..EvalSample::default() }];
    let options = support::eval::options(&format!("n{}.sum", COUNT - 1));
    let mut assets = Assets::default();
    let batches = eval_batches(&setup, Library::built_in(), &samples, &options, &mut assets);
    let batches = batches.unwrap_or_else(|problems| panic!("{}", support::eval::told(&problems)));
    let wanted =
        (0..COUNT).map(step).fold(2.5, |x, (kind, b)| if kind == "add" { x + b } else { x * b });
    let found = chiaro::reference::evaluate(&batches[0], Precision::F64).expect("it runs");
    assert!((found[0][0] - wanted).abs() < 1e-9, "{} for {wanted}", found[0][0]);
}

/// Chain of sums, products, sines and absolute values, begun with how much a surface faces the eye.
#[cfg(feature = "gpu")]
fn waves(count: usize) -> chiaro::frame::SetupLook {
    let mut nodes = vec![json!({"id": "start", "kind": "facing"})];
    let mut wires = Vec::new();
    let mut from = "start".to_owned();
    for index in 0..count {
        let id = format!("n{index}");
        let (kind, port) =
            [("add", "a"), ("multiply", "a"), ("sine", "angle"), ("absolute", "value")][index % 4];
        let b = 0.3 + 0.17 * (index % 5) as f64;
        let values = if port == "a" { json!({"b": b}) } else { json!({}) };
        nodes.push(json!({"id": id, "kind": kind, "values": values}));
        wires.push(json!({"from": from, "to": format!("{id}.{port}")}));
        from = id;
    }
    nodes.push(json!({"id": "output", "kind": "output"}));
    wires.push(json!({"from": from, "to": "output.color"}));
    support::eval::look(&json!({"nodes": nodes, "wires": wires}))
}

/// Draws a long chain, holds pixels against the f64 reference, and returns the seconds of drawing.
#[cfg(feature = "gpu")]
fn draws_as_the_reference_does(count: usize) -> f64 {
    use crate::support::wait::block_on;
    use chiaro::clock::Clock;
    use chiaro::compile::Live;
    use chiaro::frame::{Assets, Executor as _, PlanOptions, Planner, default_setup};
    use chiaro::progress::Progress;
    let setup = default_setup(waves(count), "shape:sphere", &mut Assets::default());
    let setup = setup.expect("a sphere").value;
    let options = PlanOptions { size: [24, 24], samples: 1, time: 0.0 };
    let plan = Planner::default().plan(&setup, Library::built_in(), &Live::Keyed, &options);
    let plan = plan.expect("a plan").value;
    let clock = Clock::start();
    let drawn = block_on(support::eval::renderer().picture(&plan)).expect("it is drawn");
    let seconds = clock.seconds();
    let mut reference = chiaro::reference::Reference::default();
    let wanted = block_on(reference.picture(&plan, &Progress::new())).expect("it is drawn");
    let is_inside = |index: usize| {
        let [x, y] = [index % 24, index / 24];
        x.abs_diff(12).pow(2) + y.abs_diff(12).pow(2) < 36
    };
    let (drawn, wanted) = (drawn.to_rgba8(), wanted.to_rgba8());
    let pixels = drawn.chunks(4).zip(wanted.chunks(4)).enumerate();
    for (index, (drawn, wanted)) in pixels.filter(|(index, _)| is_inside(*index)) {
        assert!(drawn.iter().zip(wanted).all(|(a, b)| a.abs_diff(*b) < 3), "{index}");
    }
    seconds
}

/// A driver took 200 s for such a look once, and a thread's stack.
#[cfg(feature = "gpu")]
#[test]
fn five_thousand_nodes_are_drawn() {
    draws_as_the_reference_does(5000);
}

#[cfg(feature = "gpu")]
#[test]
#[ignore = "soak: a driver compiles for a minute"]
fn soak_twenty_thousand_nodes_are_drawn() {
    let seconds = draws_as_the_reference_does(20_000);
    assert!(seconds < 600.0, "{seconds} s");
}

#[test]
fn twenty_thousand_nodes_compile() {
    compiles(20_000);
}

#[test]
fn a_hundred_thousand_nodes_compile() {
    compiles(100_000);
}
