//! Benchmark of many lights: 1 to 256 of them in a loop, one after another, and in a loop written
//! by hand for the same picture.
//!
//! `cargo bench --no-default-features --features gpu --bench lights` prints a row for each number
//! of lights and each look: a toon tone of plain nodes, and a soft light layer. Times of the look
//! pass are medians in turns, by the GPU's own clock. Those of our own compiler and of the first
//! picture (with a driver's compilation, where drivers compile what is drawn) were taken once.
//! "Dark" is the look in which all lights but one are out. "Each alone" is the pass of one light,
//! times the number of lights. A size as `1600x1200` takes the place of 800x600; other words
//! choose numbers of lights. docs/performance.md holds the figures.
#![allow(clippy::print_stdout, reason = "what it is for")]
#![allow(missing_docs, reason = "a program")]

#[path = "support/look_pass.rs"]
mod look_pass;

use std::collections::BTreeSet;
use std::sync::Arc;
use std::time::Instant;

use chiaro::compile::{CompileOptions, CompiledShader, Live, Loops, compile};
use chiaro::document::{LightField, LightInput, Scene};
use chiaro::frame::{FramePlan, PlanOptions, Planner, Setup, SetupLook};
use chiaro::library::Library;
use chiaro::render::{Gpu, Renderer};
use chiaro::wgsl;
use chiaro_test_drawing::eval::{look, scene_of, shape};
use chiaro_test_drawing::wait::block_on;
use look_pass::look_passes;
use serde_json::{Value as Json, json};

const COUNTS: [usize; 10] = [1, 2, 4, 8, 10, 16, 32, 64, 128, 256];
const ROUNDS: usize = 15;

/// Nodes of what comes of one light, and WGSL for it by hand: the body of a loop over `i`.
struct Tone {
    name: &'static str,
    nodes: Json,
    wires: Json,
    by_hand: Option<&'static str>,
}

fn tones() -> [Tone; 2] {
    let toon = Tone {
        name: "toon",
        nodes: json!([
            {"id": "normal", "kind": "normal"}, {"id": "cosine", "kind": "dot_product"},
            {"id": "tone", "kind": "smooth_step_value", "values": {"low": 0.3, "high": 0.35}}]),
        wires: json!([
            {"from": "normal", "to": "cosine.a"}, {"from": "parts.direction", "to": "cosine.b"},
            {"from": "cosine", "to": "tone.value"}]),
        by_hand: Some(TOON),
    };
    let soft = Tone {
        name: "soft layer",
        nodes: json!([{"id": "angle", "kind": "parametrization"},
            {"id": "tone", "kind": "profile"}]),
        wires: json!([
            {"from": "lamp", "to": "angle.light"}, {"from": "angle", "to": "tone.angle"}]),
        by_hand: None,
    };
    [toon, soft]
}

/// The body of the loop of the toon look, as one writes it.
const TOON: &str = "\
        let light = look.lights[i];
        let tone = smoothstep(0.3, 0.35, dot(normal, light.direction));
        sum += light.color.rgb * tone;";

/// A look in which a tone of each light is colored by it, and all are added.
fn many(tone: &Tone, count: usize) -> SetupLook {
    let light = |index: usize| {
        let (sine, cosine) = (index as f64 * 0.7).sin_cos();
        let color = [0.5 + 0.4 * sine, 0.5, 0.5 - 0.4 * cosine].map(|x| x / count as f64);
        let light = json!({"direction": [sine, 0.6, cosine], "color": color});
        (format!("light_{index}"), light)
    };
    let lights: serde_json::Map<String, Json> = (0..count).map(light).collect();
    let mut nodes = vec![
        json!({"id": "lamp", "kind": "light"}),
        json!({"id": "parts", "kind": "light_parts"}),
        json!({"id": "scaled", "kind": "multiply"}),
        json!({"id": "join", "kind": "sum_of_lights"}),
    ];
    nodes.extend(tone.nodes.as_array().into_iter().flatten().cloned());
    let mut wires = vec![
        json!({"from": "lamp", "to": "parts.light"}),
        json!({"from": "parts.color", "to": "scaled.a"}),
        json!({"from": "tone", "to": "scaled.b"}),
        json!({"from": "scaled", "to": "join.value"}),
        json!({"from": "join", "to": "outputs.color"}),
    ];
    wires.extend(tone.wires.as_array().into_iter().flatten().cloned());
    look(&json!({"name": format!("{} {count}", tone.name), "lights": lights,
        "definitions": {"lamps": {"outputs": [{"name": "color"}], "nodes": nodes, "wires": wires}},
        "nodes": [{"id": "each", "kind": "lamps", "for_each": "*"},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "each", "to": "output.color"}]}))
}

fn setup(look: SetupLook) -> Setup {
    let (mesh, fitted) = shape("creature");
    scene_of(vec![(look, mesh, fitted)], Scene { backdrop: None, ..Scene::default() })
}

/// A module, with the milliseconds that it took.
fn compiled(look: &SetupLook, loops: Loops, dark: usize) -> (CompiledShader, f64) {
    let lights = look.look.lights.keys().rev().take(dark);
    let intensity = LightInput::Field(LightField::Intensity);
    let dark: BTreeSet<_> = lights.map(|id| (id.clone(), intensity)).collect();
    let options = CompileOptions { display: true, loops, dark, ..CompileOptions::default() };
    let mut shader = None;
    let time = milliseconds(|| {
        shader = compile(&look.look, Library::built_in(), &options).ok();
    });
    (shader.expect("a right look").value, time)
}

/// The module with its `shade` written by hand.
fn by_hand(mut shader: CompiledShader, body: &str, count: usize) -> CompiledShader {
    let text = &shader.wgsl;
    let start = text.find("/// The look at one point").expect("the look's function");
    let end = text.find("\nstruct Vertex").expect("the frame after it");
    let shade = format!(
        "fn shade(surface: Surface) -> vec4f {{\n    let normal = surface.normal;\n    \
         var sum = vec3f(0.0);\n    for (var i = 0u; i < {count}u; i++) {{\n{body}\n    }}\n    \
         return vec4f(sum, 1.0);\n}}\n"
    );
    let text = format!("{}{shade}{}", &text[..start], &text[end..]);
    shader.valid = wgsl::parse(&text).unwrap_or_else(|error| panic!("{}\n{text}", error.message));
    shader.wgsl = text;
    shader
}

fn plan(setup: &Setup, shader: CompiledShader, size: [u32; 2]) -> FramePlan {
    let mut planner = Planner::default();
    planner.provide(&setup.looks[0].look, &Live::Keyed, Arc::new(shader));
    let options = PlanOptions { size, samples: 1, time: 0.0 };
    let plan = planner.plan(setup, Library::built_in(), &Live::Keyed, &options);
    plan.unwrap_or_else(|problems| panic!("{}", problems[0])).value.forward()
}

#[expect(clippy::disallowed_methods, reason = "a benchmark is about time")]
fn milliseconds(of: impl FnOnce()) -> f64 {
    let start = Instant::now();
    of();
    start.elapsed().as_secs_f64() * 1e3
}

fn main() {
    let words: Vec<String> =
        std::env::args().skip(1).filter(|word| !word.starts_with('-')).collect();
    let size_of = |word: &String| {
        let (width, height) = word.split_once('x')?;
        Some([width.parse().ok()?, height.parse().ok()?])
    };
    let size: [u32; 2] = words.iter().find_map(size_of).unwrap_or([800, 600]);
    let asked: Vec<usize> = words.iter().filter_map(|word| word.parse().ok()).collect();
    let gpu = block_on(Gpu::headless()).expect("a GPU, a software one for one");
    println!("{}, {}x{}, one sample a pixel; ms\n", gpu.name(), size[0], size[1]);
    let mut renderer = Renderer::new(gpu);
    println!(
        "| lights | look | loop | by hand | one after another | dark | each alone | own compiler, \
         loop | one after another | first picture, loop | one after another |"
    );
    println!("| ---: | --- | {}", "---: | ".repeat(9).trim_end());
    for tone in tones() {
        for count in COUNTS.into_iter().filter(|count| asked.is_empty() || asked.contains(count)) {
            let own = setup(many(&tone, count));
            let look = &own.looks[0];
            let (looped, loop_time) = compiled(look, Loops::Always, 0);
            let (unrolled, unrolled_time) = compiled(look, Loops::Never, 0);
            let (dark, _) = compiled(look, Loops::ByCost, count - 1);
            let alone = setup(many(&tone, 1));
            let (one, _) = compiled(&alone.looks[0], Loops::Never, 0);
            let hand = tone.by_hand.filter(|_| !looped.loops.is_empty()).map(|body| {
                let (looped, _) = compiled(look, Loops::Always, 0);
                by_hand(looped, body, count)
            });
            let mut plans = vec![
                plan(&own, looped, size),
                plan(&own, unrolled, size),
                plan(&own, dark, size),
                plan(&alone, one, size),
            ];
            plans.extend(hand.map(|hand| plan(&own, hand, size)));
            let first: Vec<f64> = plans
                .iter()
                .map(|plan| {
                    milliseconds(|| drop(block_on(renderer.picture(plan)).expect("it draws")))
                })
                .collect();
            let times = look_passes(&mut renderer, &plans, ROUNDS);
            let times: Vec<f64> = times.into_iter().map(|(look, _)| look).collect();
            let hand = times
                .get(4)
                .map_or("-".to_owned(), |hand| format!("{hand:.2} ({:.2})", times[0] / hand));
            println!(
                "| {count} | {} | {:.2} | {hand} | {:.2} | {:.2} | {:.1} | {loop_time:.1} | \
                 {unrolled_time:.1} | {:.0} | {:.0} |",
                tone.name,
                times[0],
                times[1],
                times[2],
                times[3] * count as f64,
                first[0],
                first[1],
            );
        }
    }
}
