//! Random looks: valid ones compile for every stage and liveness and show finite pixels; broken
//! ones are reported with a place, and never panic.
#![cfg(feature = "gpu")]

use crate::support;
use crate::support::eval::{draw, eval_with, options, scene_of, shape};
use crate::support::random::Random;
use chiaro::compile::{CompileOptions, Live, Stage, compile};
use chiaro::diag::{Diagnostic, has_errors};
use chiaro::document::{Document, Look, Scene};
use chiaro::frame::{EvalSample, SetupLook};
use chiaro::ids::PortName;
use chiaro::library::{ArgumentSource, Fallback, Input, Library, NodeDef, Treatment, Type};
use glam::{DMat3, DVec2};
use proptest::prelude::{ProptestConfig, any};
use proptest::test_runner::{TestCaseError, TestRunner};
use serde_json::{Map, Value as Json, json};

/// An output that a later node may take.
struct Source {
    endpoint: String,
    ty: Type,
}

/// A graph that grows: every wire goes from an earlier node to a later one, so that there is no
/// cycle.
struct RandomGraph {
    nodes: Vec<Json>,
    wires: Vec<Json>,
    sources: Vec<Source>,
}

fn number(random: &mut Random) -> f64 {
    match random.index(8) {
        0 => 0.0,
        1 => 1.0,
        2 => -1.0,
        3 => random.between(-1e6, 1e6),
        4 => 1e-30,
        _ => random.between(-4.0, 4.0),
    }
}

/// A value that an input takes.
fn value_for(input: &Input, random: &mut Random) -> Option<Json> {
    if !input.options.is_empty() {
        return Some(json!(random.pick(&input.options).0));
    }
    let within = |x: f64| x.clamp(input.min.unwrap_or(f64::MIN), input.max.unwrap_or(f64::MAX));
    let mut x = || within(number(random));
    Some(match input.ty {
        Type::Float => json!(x()),
        Type::Int => json!(x().round().clamp(-1e6, 1e6)),
        Type::Bool => json!(random.chance(0.5)),
        Type::Vec2 => json!([x(), x()]),
        Type::Vec3 => json!([x(), x(), x()]),
        Type::Color | Type::Composite => {
            json!([random.unit(), random.unit(), random.unit(), random.unit()])
        }
        Type::LightName => json!(*random.pick(&["key", "lamp", "torch"])),
        Type::Curve => {
            json!({
                "points": [[0, x()], [0.5, x()], [1, x()]],
                "interpolation": *random.pick(&["linear", "smooth", "stepped"])
            })
        }
        Type::Ramp => {
            json!({
                "stops": [{"at": 0, "color": [1, 0, 0]}, {"at": 1, "color": "#00ff7f80"}],
                "interpolation": *random.pick(&["linear", "smooth", "stepped"])
            })
        }
        _ => return None,
    })
}

/// True if a function for a wider type takes this number as that type.
fn is_widened(def: &NodeDef, port: &PortName) -> bool {
    let is_wide = |parameter: &ArgumentSource| {
        let ArgumentSource::Input(index, ty) = parameter else { return false };
        def.inputs[*index].name == *port && *ty != Type::Float
    };
    def.variants.iter().any(|variant| variant.parameters.iter().any(is_wide))
}

impl RandomGraph {
    fn new() -> Self {
        Self { nodes: Vec::new(), wires: Vec::new(), sources: Vec::new() }
    }

    fn source_for(&self, ty: &Type, random: &mut Random) -> Option<&Source> {
        let fitting: Vec<&Source> =
            self.sources.iter().filter(|source| source.ty.convert_to(ty).is_some()).collect();
        (!fitting.is_empty()).then(|| *random.pick(&fitting))
    }

    /// Adds a node of a kind, wired at random and wherever a wire is needed; returns `false` if
    /// nothing in the graph can feed it.
    fn add(&mut self, def: &NodeDef, random: &mut Random) -> bool {
        let id = format!("n{}", self.nodes.len());
        let (mut values, mut wires) = (Map::new(), Vec::new());
        let is_wide = def.variants.iter().any(|variant| variant.width.is_some());
        let mut fed: Vec<Type> = Vec::new();
        for input in def.visible_inputs() {
            let must = input.fallback == Fallback::Wire;
            let is_wired =
                must || (input.options.is_empty() && !input.ty.is_setting() && random.chance(0.5));
            // A node of any width takes any width, but the same on all inputs.
            let widens = input.ty == Type::Float && is_widened(def, &input.name);
            let first_of_width = widens && fed.is_empty();
            let ty = if def.special == Treatment::Reroute || (first_of_width && random.chance(0.5))
            {
                random.pick(&[Type::Float, Type::Vec3, Type::Color]).clone()
            } else {
                input.ty.clone()
            };
            match self.source_for(&ty, random).filter(|_| is_wired) {
                Some(source) => {
                    wires.push(
                        json!({"from": source.endpoint, "to": format!("{id}.{}", input.name)}),
                    );
                    if widens || def.special == Treatment::Reroute {
                        fed.push(source.ty.clone());
                    }
                }
                None if must => return false,
                None if input.ty == Type::LightName || random.chance(0.6) => {
                    if let Some(value) = value_for(input, random) {
                        values.insert(input.name.to_string(), value);
                    }
                }
                None => {}
            }
        }
        // The output of a node of any width has the width of its inputs; if those are mixed,
        // nothing takes the output here.
        fed.dedup();
        let has_variant =
            |ty: &Type| def.variants.iter().any(|variant| variant.width.as_ref() == Some(ty));
        for output in &def.outputs {
            let is_open = output.ty == Type::Float && is_wide || def.special == Treatment::Reroute;
            let ty = match fed.as_slice() {
                _ if !is_open => output.ty.clone(),
                [ty] if def.special == Treatment::Reroute || has_variant(ty) => ty.clone(),
                [] | [Type::Float | Type::Angle | Type::Int | Type::Bool] => Type::Float,
                _ => continue,
            };
            self.sources.push(Source { endpoint: format!("{id}.{}", output.name), ty });
        }
        self.nodes.push(json!({"id": id, "kind": def.kind, "values": values}));
        self.wires.extend(wires);
        true
    }

    fn add_layer(&mut self, random: &mut Random) {
        let Some(below) =
            self.source_for(&Type::Composite, random).map(|source| source.endpoint.clone())
        else {
            return;
        };
        let id = format!("n{}", self.nodes.len());
        let mut x = || random.between(-0.5, 3.6);
        let values = json!({
            "light": "key", "offset": x(), "falloff": x(), "cutoff": x(), "slope": x(),
            "amount": x()
        });
        self.nodes.push(json!({"id": id, "kind": "light_layer", "values": values}));
        self.wires.push(json!({"from": below, "to": format!("{id}.below")}));
        for (output, ty) in [("below", Type::Composite), ("tone", Type::Float)] {
            self.sources.push(Source { endpoint: format!("{id}.{output}"), ty });
        }
    }

    fn grow(&mut self, count: usize, random: &mut Random) {
        let library = Library::built_in();
        let defs: Vec<_> =
            library.nodes.values().filter(|def| def.special != Treatment::Output).collect();
        // The graph begins with a source of each type.
        for kind in ["base", "light", "parametrization", "facing", "vertex_color", "uv"] {
            self.add(&library.nodes[kind], random);
        }
        while self.nodes.len() < count {
            if random.chance(0.1) {
                self.add_layer(random);
            } else {
                let def = *random.pick(&defs);
                self.add(def, random);
            }
        }
    }
}

/// A look of `count` nodes or so, some of them in a group that is used twice.
fn random_look(seed: u64, count: usize) -> Json {
    let random = &mut Random::new(seed);
    let mut inner = RandomGraph::new();
    inner.grow(8 + random.index(6), random);
    let color = inner
        .source_for(&Type::Color, random)
        .map_or("n0".to_owned(), |source| source.endpoint.clone());
    let mut inner_wires = inner.wires;
    inner_wires.push(json!({"from": "inputs.amount", "to": "scale.b"}));
    inner_wires.push(json!({"from": color, "to": "scale.a"}));
    inner_wires.push(json!({"from": "scale", "to": "outputs.color"}));
    inner.nodes.push(json!({"id": "scale", "kind": "multiply"}));

    let mut outer = RandomGraph::new();
    outer.grow(count, random);
    for index in 0..random.index(3) {
        let id = format!("group_{index}");
        outer.nodes.push(json!({"id": id, "kind": "tint", "values": {"amount": random.unit()}}));
        outer.sources.push(Source { endpoint: format!("{id}.color"), ty: Type::Color });
    }
    let last =
        outer.sources.iter().rev().find(|source| source.ty.convert_to(&Type::Composite).is_some());
    let shown = last.map_or("n0".to_owned(), |source| source.endpoint.clone());
    // The look has an unfinished part that nothing needs: a light where a number belongs, and the
    // node after that.
    outer.nodes.push(json!({"id": "loose", "kind": "sine"}));
    outer.nodes.push(json!({"id": "end", "kind": "arctangent"}));
    outer.wires.push(json!({"from": "n1.light", "to": "loose.angle"}));
    outer.wires.push(json!({"from": "loose", "to": "end.y"}));
    outer.nodes.push(json!({"id": "output", "kind": "output"}));
    outer.wires.push(json!({"from": shown, "to": "output.color"}));
    json!({
        "name": format!("Look {seed}"),
        "color_space": *random.pick(&["display", "linear"]),
        "lights": {
            "key": {"direction": [number(random), number(random), 1.5]},
            "lamp": {
                "type": "point", "position": [0, 2, 1], "half_distance": random.between(0.0, 3.0),
                "range": random.between(0.0, 9.0)
            },
            "torch": {
                "type": "spot", "position": [1, 1, 2], "aim": [-1, -1, -2], "inner": 0.2,
                "outer": 0.5, "space": "camera"
            }
        },
        "definitions": {"tint": {
            "inputs": [{"name": "amount"}], "outputs": [{"name": "color"}],
            "nodes": inner.nodes, "wires": inner_wires
        }},
        "nodes": outer.nodes,
        "wires": outer.wires
    })
}

fn samples(seed: u64) -> Vec<EvalSample> {
    let mut random = Random::new(seed);
    (0..64)
        .map(|_| EvalSample {
            normal: random.direction(),
            view: random.direction(),
            position: random.direction() * random.between(0.0, 3.0),
            camera: DMat3::from_quat(random.rotation()),
            frame: random.rotation(),
            uv: DVec2::new(random.between(-2.0, 2.0), random.unit()),
            kappa: *random.pick(&[0.0, 1.0, -1e30, f64::INFINITY, f64::NAN]),
            vertex_color: [(); 4].map(|()| random.unit()),
            ..EvalSample::default()
        })
        .collect()
}

fn fail(what: impl std::fmt::Display, look: &Json) -> TestCaseError {
    TestCaseError::fail(format!("{what}\n{look}"))
}

/// Reads a look, compiles it in every way, evaluates and draws it.
fn check_valid(seed: u64, with_gpu: bool) -> Result<(), TestCaseError> {
    let json = random_look(seed, 10 + (seed % 50) as usize);
    let loaded = Look::read(&json.to_string(), "random.json");
    if has_errors(&loaded.diagnostics) {
        return Err(fail(support::eval::told(&loaded.diagnostics), &json));
    }
    let look = loaded.value.ok_or_else(|| fail("no look", &json))?;
    let library = Library::built_in();
    for stage in [Stage::Draw, Stage::Normals, Stage::DetailNormals, Stage::Eval] {
        for live in [Live::Keyed, Live::Exposed, Live::All] {
            for unspecialized in [false, true] {
                let options = CompileOptions {
                    stage,
                    live: live.clone(),
                    unspecialized,
                    ..CompileOptions::default()
                };
                // naga validates the module in `compile`.
                compile(&look, library, &options).map_err(|problems| {
                    fail(format!("{options:?}: {}", support::eval::told(&problems)), &json)
                })?;
            }
        }
    }
    if !with_gpu {
        return Ok(());
    }
    let setup = SetupLook { look, source: loaded.source.into(), folder: std::path::PathBuf::new() };
    let values = eval_with(&setup, library, &options(""), &samples(seed));
    if let Some(value) = values.iter().find(|value| value.iter().any(|x| !x.is_finite())) {
        return Err(fail(format!("the value {value:?}"), &json));
    }
    let (mesh, matrix) = shape("torus");
    let scene = scene_of(vec![(setup, mesh, matrix)], Scene::default());
    let live = if seed.is_multiple_of(2) { Live::Keyed } else { Live::All };
    let picture =
        draw(&scene, library, &live, [24, 24], if seed.is_multiple_of(3) { 4 } else { 1 });
    if let Some(pixel) = picture.rgba.iter().find(|pixel| pixel.iter().any(|x| !x.is_finite())) {
        return Err(fail(format!("the pixel {pixel:?}"), &json));
    }
    Ok(())
}

fn run(cases: u32, check: impl Fn(u64) -> Result<(), TestCaseError>) {
    let config = ProptestConfig {
        cases,
        failure_persistence: None,
        max_shrink_iters: 0,
        ..ProptestConfig::default()
    };
    let mut runner = TestRunner::new_with_rng(
        config,
        proptest::test_runner::TestRng::deterministic_rng(Default::default()),
    );
    if let Err(failure) = runner.run(&any::<u64>(), check) {
        panic!("{failure}");
    }
}

#[test]
fn random_looks_compile() {
    run(90, |seed| check_valid(seed, false));
}

#[test]
fn random_looks_show_finite_pixels() {
    run(30, |seed| check_valid(seed, true));
}

#[test]
#[ignore = "minutes long; scripts/soak runs it"]
fn random_looks_soak() {
    run(3000, |seed| check_valid(seed, seed % 4 == 0));
}

/// Breaks a look in one way. Returns the place that a diagnostic of it must have: in the graph or
/// in the file, or empty if the look may still be whole.
fn break_it(look: &mut Json, random: &mut Random) -> &'static str {
    let nodes = look["nodes"].as_array().map_or(0, Vec::len);
    let wires = look["wires"].as_array().map_or(0, Vec::len);
    let (node, wire) = (random.index(nodes), random.index(wires));
    match random.index(12) {
        0 => {
            look["nodes"].as_array_mut().expect("a list").remove(node);
            "perhaps"
        }
        1 => {
            look["wires"][wire]["to"] = json!("n0.no_such_port");
            "must"
        }
        2 => {
            look["wires"][wire]["from"] = json!("nobody.out");
            "must"
        }
        3 => {
            look["nodes"][node]["kind"] = json!("no_such_kind");
            "must"
        }
        4 => {
            // A cycle of two nodes.
            let list = look["nodes"].as_array_mut().expect("a list");
            list.push(json!({"id": "ring_a", "kind": "add"}));
            list.push(json!({"id": "ring_b", "kind": "add"}));
            let wires = look["wires"].as_array_mut().expect("a list");
            wires.push(json!({"from": "ring_a", "to": "ring_b.a"}));
            wires.push(json!({"from": "ring_b", "to": "ring_a.a"}));
            wires.retain(|wire| wire["to"] != json!("output.color"));
            wires.push(json!({"from": "ring_a", "to": "output.color"}));
            "must"
        }
        5 => {
            // A light wired to a number.
            look["nodes"]
                .as_array_mut()
                .expect("a list")
                .push(json!({"id": "wrong", "kind": "sine"}));
            let wires = look["wires"].as_array_mut().expect("a list");
            wires.push(json!({"from": "n1", "to": "wrong.angle"}));
            wires.retain(|wire| wire["to"] != json!("output.color"));
            wires.push(json!({"from": "wrong", "to": "output.color"}));
            "must"
        }
        6 => {
            let twice = look["wires"][wire].clone();
            look["wires"].as_array_mut().expect("a list").push(twice);
            "must"
        }
        7 => {
            look["nodes"][node]["values"] = json!({"no_such_input": 3});
            "must"
        }
        8 => {
            let copy = look["nodes"][node].clone();
            look["nodes"].as_array_mut().expect("a list").push(copy);
            "must"
        }
        9 => {
            look["version"] = json!(999);
            "must"
        }
        10 => {
            look["lights"]["key"]["direction"] = random
                .pick(&[json!([0, 0]), json!("up"), json!([true, 0, 0]), json!(null)])
                .clone();
            "must"
        }
        _ => {
            look["definitions"]["tint"]["nodes"]
                .as_array_mut()
                .expect("a list")
                .push(json!({"id": "again", "kind": "tint"}));
            look["nodes"]
                .as_array_mut()
                .expect("a list")
                .push(json!({"id": "group_9", "kind": "tint"}));
            "must"
        }
    }
}

/// True if a reader of the problem finds its place.
fn is_placed(problem: &Diagnostic) -> bool {
    let place = &problem.place;
    place.node.is_some() || place.port.is_some() || place.json_path.is_some() || place.at.is_some()
}

fn problems_of(text: &str) -> Vec<Diagnostic> {
    let loaded = Look::read(text, "broken.json");
    let mut problems = loaded.diagnostics;
    if let Some(look) = loaded.value {
        match compile(&look, Library::built_in(), &CompileOptions::default()) {
            Ok(shader) => problems.extend(shader.warnings),
            Err(found) => problems.extend(found),
        }
    }
    problems
}

fn check_broken(seed: u64) -> Result<(), TestCaseError> {
    let mut json = random_look(seed, 12 + (seed % 20) as usize);
    let mut random = Random::new(!seed);
    let how = break_it(&mut json, &mut random);
    let problems = problems_of(&json.to_string());
    if how == "must" && !has_errors(&problems) {
        return Err(fail("it is broken, and nobody says so", &json));
    }
    if let Some(problem) =
        problems.iter().find(|problem| !is_placed(problem) && problem.code != "no-output")
    {
        return Err(fail(format!("a problem without a place: {problem}"), &json));
    }
    // The text is cut short or garbled.
    let text = json.to_string();
    let cut: String = text.chars().take(random.index(text.len())).collect();
    let problems = problems_of(&cut);
    if !has_errors(&problems) || !problems.iter().any(is_placed) {
        return Err(fail(
            format!("cut short without a place: {}", support::eval::told(&problems)),
            &json!(cut),
        ));
    }
    let mut bytes = text.into_bytes();
    for _ in 0..1 + random.index(4) {
        let at = random.index(bytes.len());
        bytes[at] = *random.pick(b"{}[]\",:0x\\ \n");
    }
    let garbled = String::from_utf8_lossy(&bytes);
    problems_of(&garbled);
    let _ = Document::read(&garbled, "broken.json");
    Ok(())
}

#[test]
fn broken_looks_are_told_about() {
    run(1000, check_broken);
}

#[test]
#[ignore = "minutes long; scripts/soak runs it"]
fn broken_looks_soak() {
    run(30_000, check_broken);
}
