//! Lights that are gone through in a loop: the same picture as with the code of each light, and no
//! work that does not depend on the light within.

#![cfg(feature = "gpu")]

use crate::support::eval::{eval_with, look};
use crate::support::examples::samples;
use chiaro::compile::{CompileOptions, CompiledShader, Live, Loops, compile};
use chiaro::diag::Diagnostic;
use chiaro::document::{LightField, LightInput, Tier};
use chiaro::frame::{Assets, SetupLook, eval_batches};
use chiaro::ids::LightId;
use chiaro::interp::Precision;
use chiaro::library::Library;
use chiaro::reference;
use serde_json::{Value as Json, json};

fn told(problems: &[Diagnostic]) -> String {
    problems.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
}

/// Six directional lights, five point lights and one spot light, in this order.
fn lights() -> Json {
    let mut lights = serde_json::Map::new();
    for index in 0..12 {
        let (sine, cosine) = (f64::from(index) * 0.7).sin_cos();
        let color = json!([0.5 + 0.4 * sine, 0.5, 0.5 - 0.4 * cosine]);
        let light = match index {
            0..6 => json!({"direction": [sine, 0.6, cosine], "color": color, "intensity": 0.3,
                "groups": ["sky"]}),
            6..11 => json!({"type": "point", "position": [2.0 * sine, 1.0, 2.0 * cosine],
                "space": "world", "half_distance": 2, "color": color, "groups": ["lamps"]}),
            _ => json!({"type": "spot", "position": [0, 3, -1], "aim": [0, -3, 1.5],
                "space": "world", "inner": 0.2, "outer": 0.6, "color": color}),
        };
        lights.insert(format!("light_{index}"), light);
    }
    Json::Object(lights)
}

/// A group that runs for each light: its tone, seen through values of the group, joined by a node.
fn group(kind: &str, input: &str, output: &str) -> Json {
    let mut wires = vec![
        json!({"from": "lamp", "to": "angle.light"}),
        json!({"from": "angle", "to": "tone.angle"}),
        json!({"from": "lamp", "to": "parts.light"}),
        json!({"from": "inputs.strength", "to": "waved.b"}),
        json!({"from": "height", "to": "waved.a"}),
        json!({"from": "tone", "to": "dimmed.a"}),
        json!({"from": "waved", "to": "dimmed.b"}),
        json!({"from": "dimmed", "to": "scaled.b"}),
        json!({"from": "parts.color", "to": "scaled.a"}),
        json!({"from": "scaled", "to": format!("join.{input}")}),
        json!({"from": format!("join.{output}"), "to": "outputs.color"}),
    ];
    if kind == "mix_of_lights" {
        wires.push(json!({"from": "tone", "to": "join.weight"}));
    } else if kind == "strongest_of_lights" {
        wires.push(json!({"from": "tone", "to": "join.strength"}));
    }
    json!({"inputs": [{"name": "strength", "default": 0.5}], "outputs": [{"name": "color"}],
        "nodes": [
            {"id": "lamp", "kind": "light"}, {"id": "parts", "kind": "light_parts"},
            {"id": "angle", "kind": "parametrization"}, {"id": "tone", "kind": "profile"},
            {"id": "height", "kind": "facing"}, {"id": "waved", "kind": "multiply"},
            {"id": "dimmed", "kind": "multiply"},
            {"id": "scaled", "kind": "multiply"}, {"id": "join", "kind": kind}],
        "wires": wires})
}

/// A kind of node that joins, with its input and output.
type Join = (&'static str, &'static str, &'static str);

/// Kinds of nodes that join.
const JOINS: [Join; 6] = [
    ("sum_of_lights", "value", "sum"),
    ("greatest_of_lights", "value", "greatest"),
    ("layers_of_lights", "color", "layers"),
    ("mix_of_lights", "color", "mix"),
    ("first_of_lights", "color", "color"),
    ("strongest_of_lights", "color", "color"),
];

/// A look of groups that run for lights, each with a join; added up.
fn joined(joins: &[Join], sets: &[&str], more_wires: &[Json]) -> SetupLook {
    let mut definitions = serde_json::Map::new();
    let mut nodes = vec![json!({"id": "output", "kind": "output"})];
    let mut wires = more_wires.to_vec();
    let mut last = String::new();
    for (index, (kind, input, output)) in joins.iter().enumerate() {
        let [each, sum] = ["each", "sum"].map(|name| format!("{name}_{index}"));
        let definition = format!("of_{kind}");
        nodes.push(json!({"id": each, "kind": definition, "for_each": sets[index % sets.len()]}));
        definitions.insert(definition, group(kind, input, output));
        if last.is_empty() {
            last = each;
        } else {
            nodes.push(json!({"id": sum, "kind": "add"}));
            wires.push(json!({"from": last, "to": format!("{sum}.a")}));
            wires.push(json!({"from": each, "to": format!("{sum}.b")}));
            last = sum;
        }
    }
    wires.push(json!({"from": last, "to": "output.color"}));
    look(&json!({"name": "joined", "lights": lights(), "definitions": definitions,
        "nodes": nodes, "wires": wires}))
}

fn options(loops: Loops) -> CompileOptions {
    CompileOptions { loops, ..CompileOptions::default() }
}

fn shader(look: &SetupLook, options: &CompileOptions) -> CompiledShader {
    compile(&look.look, Library::built_in(), options)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)))
        .value
}

fn values(look: &SetupLook, options: &CompileOptions, precision: Precision) -> Vec<[f64; 4]> {
    let samples = samples(5, 200);
    let library = Library::built_in();
    let batches = eval_batches(look, library, &samples, options, &mut Assets::default())
        .unwrap_or_else(|problems| panic!("{}", told(&problems)));
    let mut values = vec![[f64::NAN; 4]; samples.len()];
    for batch in batches {
        let found =
            reference::evaluate(&batch, precision).unwrap_or_else(|problem| panic!("{problem}"));
        batch.indices.iter().zip(found).for_each(|(&index, value)| values[index] = value);
    }
    values
}

/// The greatest difference between values, and that of what lies within each other's reach.
fn difference(a: &[[f64; 4]], b: &[[f64; 4]]) -> f64 {
    assert_eq!(a.len(), b.len());
    let pairs = a.iter().flatten().zip(b.iter().flatten());
    pairs.fold(0.0, |most, (a, b)| {
        assert!(a.is_finite() && b.is_finite());
        f64::max(most, (a - b).abs())
    })
}

/// Looks with one join, with all that there are over the same lights, over three sets, and with one
/// that needs what another gives.
fn looks() -> Vec<(String, SetupLook)> {
    let mut looks: Vec<(String, SetupLook)> =
        JOINS.iter().map(|join| (join.0.to_owned(), joined(&[*join], &["*"], &[]))).collect();
    looks.push(("all joins".to_owned(), joined(&JOINS, &["*"], &[])));
    let sets = ["group:sky", "group:lamps", "group:sky | light_11"];
    looks.push(("three sets".to_owned(), joined(&JOINS[..3], &sets, &[])));
    let wire = json!({"from": "each_0", "to": "each_1.strength"});
    looks.push(("one after another".to_owned(), joined(&JOINS[..3], &["*"], &[wire])));
    looks
}

#[test]
fn loops_compute_what_the_code_of_each_light_does() {
    for (name, look) in looks() {
        for live in [Live::Keyed, Live::All] {
            let of = |loops, unspecialized| CompileOptions {
                loops,
                unspecialized,
                live: live.clone(),
                ..CompileOptions::default()
            };
            let looped = shader(&look, &of(Loops::Always, false));
            assert!(!looped.loops.is_empty(), "{name} {live:?}\n{}", looped.wgsl);
            assert!(shader(&look, &of(Loops::Never, false)).loops.is_empty());
            // As written, both round alike, step by step.
            let ways = [Loops::Always, Loops::Never];
            let [a, b] = ways.map(|loops| values(&look, &of(loops, true), Precision::F32));
            assert_eq!(a, b, "{name} {live:?}");
            for (precision, bound) in [(Precision::F64, 1e-12), (Precision::F32, 2e-5)] {
                let [a, b] = ways.map(|loops| values(&look, &of(loops, false), precision));
                let found = difference(&a, &b);
                assert!(found <= bound, "{name} {live:?} {precision:?}: {found:e}");
            }
        }
    }
}

#[test]
fn loops_draw_what_the_code_of_each_light_does() {
    let samples = samples(5, 200);
    for (joins, tier) in [(&JOINS[..3], Tier::Exact), (&JOINS[3..], Tier::Balanced)] {
        let mut look = joined(joins, &["group:sky", "*"], &[]);
        look.look.tier = Some(tier);
        let [a, b] = [Loops::Always, Loops::Never]
            .map(|loops| eval_with(&look, Library::built_in(), &options(loops), &samples));
        let found = difference(&a, &b);
        assert!(found <= 1.0 / 255.0, "{tier:?}: {found:e}");
    }
}

#[test]
fn loops_are_taken_where_they_are_worth_it() {
    let loops = |lights: usize| {
        let group = json!({"outputs": [{"name": "color"}],
            "nodes": [
                {"id": "lamp", "kind": "light"}, {"id": "seen", "kind": "facing"},
                {"id": "parts", "kind": "light_parts"},
                {"id": "lit", "kind": "multiply"}, {"id": "join", "kind": "sum_of_lights"}],
            "wires": [
                {"from": "lamp", "to": "parts.light"}, {"from": "parts.color", "to": "lit.a"},
                {"from": "seen", "to": "lit.b"}, {"from": "lit", "to": "join.value"},
                {"from": "join", "to": "outputs.color"}]});
        let lights: serde_json::Map<String, Json> = (0..lights)
            .map(|index| (format!("light_{index}"), json!({"direction": [index, 1, 1]})))
            .collect();
        let look = look(&json!({"name": "many", "lights": lights, "definitions": {"lamps": group},
            "nodes": [{"id": "each", "kind": "lamps", "for_each": "*"},
                {"id": "output", "kind": "output"}],
            "wires": [{"from": "each", "to": "output.color"}]}));
        shader(&look, &CompileOptions::default()).loops
    };
    assert_eq!(loops(8), []);
    let found = loops(40);
    assert_eq!((found.len(), found[0].lights.len()), (1, 40));
    let nodes: Vec<String> = found[0].nodes.iter().map(ToString::to_string).collect();
    assert_eq!(nodes, ["each/join"]);
    assert_eq!(found[0].lights[7].as_str(), "light_7");
}

/// Lights that reach nothing are no rounds.
#[test]
fn lights_that_are_out_are_left_out_of_loops() {
    let look = joined(&JOINS[..1], &["group:sky"], &[]);
    let intensity = LightInput::Field(LightField::Intensity);
    let out = ["light_1", "light_4"].map(|id| (LightId::from(id), intensity));
    let options = CompileOptions { dark: out.into(), ..options(Loops::Always) };
    let shader = shader(&look, &options);
    let lights: Vec<&str> = shader.loops[0].lights.iter().map(LightId::as_str).collect();
    assert_eq!(lights, ["light_0", "light_2", "light_3", "light_5"]);
    assert!(shader.host.lights().all(|light| !["light_1", "light_4"].contains(&light.as_str())));
}

/// Two loops over the same lights read one array; what does not depend on a light stands outside.
#[test]
fn loops_share_their_lights_and_leave_the_rest_outside() {
    let wire = json!({"from": "each_0", "to": "each_1.strength"});
    let look = joined(&JOINS[..2], &["group:sky"], &[wire]);
    let shader = shader(&look, &options(Loops::Always));
    assert_eq!(shader.loops.len(), 2);
    assert_eq!(shader.wgsl.matches("array<EachLight, 6>").count(), 1, "{}", shader.wgsl);
    let shade = shader.wgsl.split("fn shade(").nth(1).unwrap();
    let (before, first) = shade.split_once("for (").unwrap();
    assert!(before.contains("dot(surface.normal, surface.view)"), "{before}");
    assert!(!first.contains("surface.view"), "{first}");
}
