//! Code of custom nodes and of a project's node files: code beyond a bound, or that cannot run in a
//! look, is refused with its place before anything overflows, and every loop ends alike wherever it
//! runs.

use std::path::Path;

use crate::support;
use crate::support::wait::block_on;
use chiaro::compile::{CompileOptions, CompiledShader, compile};
use chiaro::diag::{Diagnostic, Severity, WithWarnings};
use chiaro::document::Look;
use chiaro::export::{LANGUAGES, export};
use chiaro::frame::{Assets, MAX_DEPTH, too_deep};
use chiaro::library::Library;
use serde_json::{Value as Json, json};

fn look_json(code: &str) -> Json {
    json!({
        "nodes": [
            {"id": "start", "kind": "kappa"},
            {"id": "own", "kind": "wgsl", "values": {"code": code}},
            {"id": "output", "kind": "output"},
        ],
        "wires": [{"from": "start", "to": "own.x"}, {"from": "own", "to": "output.color"}],
    })
}

fn read(json: &Json) -> Look {
    let loaded = Look::read(&json.to_string(), "own.json");
    assert!(loaded.diagnostics.is_empty(), "{:?}", loaded.diagnostics);
    loaded.value.expect("a look")
}

fn compiled(code: &str) -> Result<WithWarnings<CompiledShader>, Vec<Diagnostic>> {
    compile(&read(&look_json(code)), Library::built_in(), &CompileOptions::default())
}

/// The only problem of the code, in a look and in a node file.
fn refused(code: &str) -> Diagnostic {
    let mut library = Library::default();
    library.add_file("nodes/own/f.wgsl", code);
    let in_file = &library.problems[0];
    assert_eq!(library.nodes.len(), 0, "a node file that is refused adds no node");
    assert!(in_file.place.file.is_some() && in_file.place.at.is_some(), "{in_file}");
    let mut problems = compiled(code).expect_err("it is refused");
    assert_eq!(problems.len(), 1, "{problems:?}");
    let problem = problems.remove(0);
    let node = problem.place.node.as_ref().map(ToString::to_string);
    assert_eq!((node.as_deref(), problem.code), (Some("own"), in_file.code));
    assert!(problem.is_error() && problem.message.contains("line 2, column"), "{problem}");
    problem
}

fn body(body: &str) -> String {
    format!("// Ours.\nfn f(x: f32) -> f32 {{ {body} }}")
}

#[test]
fn what_would_overflow_a_stack_is_told_with_its_bound() {
    // Tests run on 2 MiB of stack, the least that our threads have.
    for expression in [
        vec!["x"; 20_000].join("+"),
        "- ".repeat(20_000) + "x",
        format!("x{}", ".x".repeat(20_000)),
    ] {
        let problem = refused(&body(&format!("return {expression};")));
        assert_eq!(problem.code, "code-bound");
        assert!(problem.message.contains("1000 operators"), "{problem}");
    }
    let chain = "else if (x > 0.5) { y = 1.0; }".repeat(1900);
    let problem = refused(&body(&format!("var y = x; if (x > 0.0) {{ }} {chain} return y;")));
    assert!(problem.message.contains("256 `else` and `case`"), "{problem}");
}

#[test]
fn what_takes_long_is_told_before_the_work() {
    let problem = refused(&body(&format!("var y = x; {} return y;", "y *= 1.1; ".repeat(12_000))));
    assert!(
        problem.code == "code-bound" && problem.message.contains("2000 statements"),
        "{problem}"
    );
    let cases: String =
        (0..1900).map(|case| format!("case {case}: {{ return {case}.5; }} ")).collect();
    let problem = refused(&body(&format!("switch i32(x) {{ {cases} default: {{ return x; }} }}")));
    assert!(problem.message.contains("256 `else` and `case`"), "{problem}");
    let twice = |i: usize| {
        format!(" fn g{}(x: f32) -> f32 {{ return g{i}(x * 1.1) + g{i}(x + 0.1); }}", i + 1)
    };
    let doubling: String = (0..70).map(twice).collect();
    let problem = refused(&body(&format!(
        "return g70(x); }} fn g0(x: f32) -> f32 {{ return sin(x); }} {doubling} fn last() {{"
    )));
    assert!(
        problem.code == "code-not-allowed" && problem.message.contains("operations"),
        "{problem}"
    );
}

/// Cases that no look can run are in `tests/cases/node`.
#[test]
fn small_arrays_and_private_variables_are_allowed() {
    let allowed = "const T = array<f32, 4>(0.0, 1.0, 2.0, 3.0); var<private> p: f32;\n\
                   fn f(x: f32) -> f32 \
                   { var a: array<f32, 16>; a[u32(x)] = T[u32(x) % 4u]; p = a[3]; return p; }";
    assert!(compiled(allowed).expect("it compiles").warnings.is_empty());
}

const UNSEEN: &str = "fn f(x: f32) -> f32 \
                      {\n    var y = 0.0;\n    while (y < x) {\n        y += 1.0;\n    }\n    \
                      return y;\n}";

#[test]
fn a_loop_without_an_end_to_be_seen_is_counted_in_the_shader_and_in_every_export() {
    let (shader, warnings) = compiled(UNSEEN).expect("it compiles").into_parts();
    assert!(
        shader.wgsl.contains("        if rounds == 4096u { break; } rounds += 1u;\n"),
        "{}",
        shader.wgsl
    );
    let [note] = warnings.as_slice() else { panic!("{warnings:?}") };
    assert_eq!((note.severity, note.code), (Severity::Note, "counted-loop"));
    assert!(
        note.message.starts_with("line 3, column 5 of the code: ") && note.place.node.is_some(),
        "{note}"
    );
    let exported = export(
        &read(&look_json(UNSEEN)),
        Library::built_in(),
        "own",
        &LANGUAGES,
        (Path::new(""), &mut Assets::default()),
    );
    let files = exported.expect("it is exported").value;
    let texts: Vec<_> = files.iter().filter(|file| !file.name.ends_with(".json")).collect();
    assert!(texts.len() >= LANGUAGES.len());
    // SPIR-V is no text, and files of vertices and normals do not contain the node.
    let is_of_node = |name: &str| {
        !["spv", "vert", "normals", "curvature"].iter().any(|part| name.contains(part))
    };
    for file in texts.iter().filter(|file| is_of_node(&file.name)) {
        assert!(
            String::from_utf8_lossy(&file.bytes).contains("4096u"),
            "{} has no counter",
            file.name
        );
    }
    let seen = UNSEEN.replace("while (y < x)", "for (var i = 0; i < 64; i++)").replace("1.0", "x");
    let (shader, warnings) = compiled(&seen).expect("it compiles").into_parts();
    assert!(warnings.is_empty() && shader.wgsl.contains(&seen), "{}", shader.wgsl);
}

#[test]
fn a_project_s_loops_are_noted_once_and_have_the_same_end() {
    let mut library = Library::built_in().clone();
    library.add_file("nodes/own/f.wgsl", UNSEEN);
    assert!(library.problems.is_empty(), "{:?}", library.problems);
    let mut json = look_json("");
    json["nodes"][1] = json!({"id": "own", "kind": "f"});
    let (shader, warnings) = compile(&read(&json), &library, &CompileOptions::default())
        .expect("it compiles")
        .into_parts();
    assert!(shader.wgsl.contains("rounds == 4096u"), "{}", shader.wgsl);
    assert_eq!(
        warnings[0].to_string().lines().next(),
        Some(
            "nodes/own/f.wgsl:3:5: note[counted-loop]: the end of this loop cannot be seen: it \
             ends after 4096 rounds at the latest"
        )
    );
}

/// A known value is folded by the interpreter, to the same number.
#[test]
fn the_interpreter_ends_where_the_shader_does() {
    let endless =
        "fn f() -> f32 { var y = 0.0; loop { y += 1.0; if (y < 0.0) { break; } } return y; }";
    let mut json = look_json(endless);
    json["wires"] = json!([{"from": "own", "to": "output.color"}]);
    let shader = compile(&read(&json), Library::built_in(), &CompileOptions::default())
        .expect("it compiles")
        .value;
    assert!(!shader.wgsl.contains("rounds") && shader.wgsl.contains("4096.0"), "{}", shader.wgsl);
}

#[cfg(feature = "gpu")]
#[test]
fn the_gpu_and_the_reference_end_alike() {
    use chiaro::frame::{Assets, EvalSample, eval_batches};
    use chiaro::interp::Precision;
    let look = support::eval::look(&look_json(UNSEEN));
    let samples = [10.0, 4095.0, 4096.0, 4097.0, 1e9]
        .map(|kappa| EvalSample { kappa, ..EvalSample::default() });
    let expected = [10.0, 4095.0, 4096.0, 4096.0, 4096.0];
    let gpu: Vec<f64> =
        support::eval::eval(&look, "own.value", &samples).iter().map(|value| value[0]).collect();
    assert_eq!(gpu, expected);
    let options = support::eval::options("own.value");
    let batches =
        eval_batches(&look, Library::built_in(), &samples, &options, &mut Assets::default());
    let batches = batches.unwrap_or_else(|problems| panic!("{}", support::eval::told(&problems)));
    for precision in [Precision::F32, Precision::F64] {
        let reference = chiaro::reference::evaluate(&batches[0], precision).expect("it runs");
        assert_eq!(reference.iter().map(|value| value[0]).collect::<Vec<_>>(), expected);
    }
}

/// Nested loops, through calls, would take hours.
#[test]
fn loops_in_loops_are_bounded() {
    let code = "// Ours.\nfn f(x: f32) -> f32 \
                { var y = x; while (y < 9.0) { y += g(y); } return y; }\n\
                fn g(x: f32) -> f32 { var y = x; while (y > 0.5) { y *= 0.9; } return y; }";
    let problem = refused(code);
    assert!(
        problem.code == "code-bound" && problem.message.contains("16781312 rounds"),
        "{problem}"
    );
}

/// A chain of sines, which drivers follow by recursion, behind as many nodes with loops.
fn sines(count: usize, loops: usize) -> Json {
    let code = "fn f(angle: f32) -> f32 { var y = angle; while (y > 9.0) { y *= 0.5; } return y; }";
    let node = |i: usize| match i < loops {
        true => json!({"id": format!("n{i}"), "kind": "wgsl", "values": {"code": code}}),
        false => json!({"id": format!("n{i}"), "kind": "sine"}),
    };
    let mut nodes: Vec<Json> = (0..count).map(node).collect();
    nodes.extend([
        json!({"id": "start", "kind": "kappa"}),
        json!({"id": "output", "kind": "output"}),
    ]);
    let from = |i: usize| if i == 0 { "start".to_owned() } else { format!("n{}", i - 1) };
    let mut wires: Vec<Json> =
        (0..count).map(|i| json!({"from": from(i), "to": format!("n{i}.angle")})).collect();
    wires.push(json!({"from": from(count), "to": "output.color"}));
    json!({"nodes": nodes, "wires": wires})
}

#[test]
fn what_a_driver_would_recurse_over_is_told() {
    let depth = |count, loops| {
        let look = read(&sines(count, loops));
        let shader = compile(&look, Library::built_in(), &CompileOptions::default());
        too_deep(&shader.expect("it compiles").value)
    };
    assert_eq!(depth(1000, 0), None);
    assert_eq!(depth(20_000, 0), None, "it is handed over in pieces");
    // Drivers take few loops, and so many leave none for the pieces.
    let told = depth(30_000, 10).expect("it is too deep");
    assert!(told.contains(&MAX_DEPTH.to_string()), "{told}");
}

/// Mesa takes 3 MiB of stack for 20,000 differences and absolute values in a row; tests have 2 MiB,
/// the least that our threads have.
#[cfg(feature = "gpu")]
#[test]
fn what_a_driver_recurses_over_has_the_stack_for_it() {
    const NODES: usize = 10;
    let steps: String = (0..1000).map(|i| format!("let y{} = abs(y{i} - k); ", i + 1)).collect();
    let code = format!("fn f(x: f32, k: f32) -> f32 {{ let y0 = x; {steps} return y1000; }}");
    let node = |i: usize| json!({"id": format!("n{i}"), "kind": "wgsl", "values": {"code": code}});
    let mut nodes: Vec<Json> = (0..NODES).map(node).collect();
    nodes.extend([
        json!({"id": "start", "kind": "kappa"}),
        json!({"id": "output", "kind": "output"}),
    ]);
    let from = |i: usize| if i == 0 { "start".to_owned() } else { format!("n{}", i - 1) };
    let mut wires: Vec<Json> =
        (0..NODES).map(|i| json!({"from": from(i), "to": format!("n{i}.x")})).collect();
    wires.extend((0..NODES).map(|i| json!({"from": "start", "to": format!("n{i}.k")})));
    wires.push(json!({"from": from(NODES), "to": "output.color"}));
    let look = support::eval::look(&json!({"nodes": nodes, "wires": wires}));
    let samples =
        [chiaro::frame::EvalSample { kappa: 0.5, ..chiaro::frame::EvalSample::default() }];
    // 0.5 becomes 0 and 0 becomes 0.5, an even number of times.
    assert_eq!(support::eval::eval(&look, "n9.value", &samples)[0][0], 0.5);
}

#[cfg(feature = "gpu")]
#[test]
fn what_is_too_deep_is_not_handed_to_the_driver() {
    use chiaro::frame::{Assets, EvalSample, eval_batches};
    let look = support::eval::look(&sines(30_000, 10));
    let (samples, options) = ([EvalSample::default()], support::eval::options("n29999.sine"));
    let batches =
        eval_batches(&look, Library::built_in(), &samples, &options, &mut Assets::default());
    let batches = batches.unwrap_or_else(|problems| panic!("{}", support::eval::told(&problems)));
    let error =
        block_on(support::eval::renderer().evaluate(&batches[0])).expect_err("it is refused");
    assert_eq!(Diagnostic::from(error).code, "deep-shader");
}
