//! Benchmark of shadows and occlusion: what each costs a frame in every tier, by rays or by maps.
//!
//! `cargo bench --no-default-features --features gpu --bench shadows` prints a row for each thing
//! that a look may ask, with medians in turns of the look pass, by the GPU's own clock, above those
//! of the look that asks for nothing, and of the passes before it, which draw maps or ask the
//! picture. Maps are drawn only when a light or what casts shadows moved. The scene is a floor with
//! the creature of the examples, a ball, a ring and a vase. A size as `1600x1200` takes the place
//! of 800x600; other words choose rows whose names have them. docs/performance.md holds the
//! figures.
#![allow(clippy::print_stdout, reason = "what it is for")]
#![allow(missing_docs, reason = "a program")]

#[path = "support/look_pass.rs"]
mod look_pass;

use chiaro::compile::Live;
use chiaro::document::{Camera, Scene};
use chiaro::frame::{FramePlan, PlanOptions, Planner, SetupLook};
use chiaro::library::Library;
use chiaro::render::{Gpu, Renderer};
use chiaro_test_drawing::eval::{look, scene_of, shape};
use chiaro_test_drawing::wait::block_on;
use glam::{DMat4, DVec3};
use serde_json::{Value as Json, json};

const ROUNDS: usize = 9;

const TIERS: [&str; 3] = ["exact", "balanced", "fast"];

/// Nodes whose numbers a look multiplies.
struct Request {
    name: String,
    nodes: Vec<Json>,
}

/// A row of each thing that is asked, the first without any of them.
fn rows() -> Vec<Request> {
    let node = |kind: &str, values: Json| json!({"kind": kind, "values": values});
    let row = |name: &str, nodes: Vec<Json>| Request { name: name.to_owned(), nodes };
    let shadow = |kind: &str, size: f64| node(kind, json!({"light": "light_0", "size": size}));
    let many = |count: usize| {
        let cast = |number| node("cast_shadow", json!({"light": format!("light_{number}")}));
        row(&format!("cast, {count} lights"), (0..count).map(cast).collect())
    };
    let blocker = node("shadow_blocker", json!({"light": "light_0"}));
    let all = vec![shadow("cast_shadow", 0.0), shadow("self_shadow", 0.0), blocker.clone()];
    vec![
        row("nothing", Vec::new()),
        row("cast", vec![shadow("cast_shadow", 0.0)]),
        row("self", vec![shadow("self_shadow", 0.0)]),
        row("distance of the blocker", vec![blocker]),
        row("all of one light", all),
        row("cast, of a light with a size", vec![shadow("cast_shadow", 0.05)]),
        row("self, of a light with a size", vec![shadow("self_shadow", 0.05)]),
        row("occlusion, far 0.2", vec![node("occlusion", json!({"far": 0.2}))]),
        row("occlusion, far 2", vec![node("occlusion", json!({"far": 2.0}))]),
        many(2),
        many(4),
        many(8),
    ]
}

/// A look whose color is the product of what is asked.
fn look_of(asked: &Request, tier: &str) -> SetupLook {
    let light = |number: usize| {
        let (sine, cosine) = (0.7 * number as f64 + 0.6).sin_cos();
        (format!("light_{number}"), json!({"direction": [sine, 0.8, cosine], "space": "world"}))
    };
    let lights: serde_json::Map<String, Json> = (0..8).map(light).collect();
    let mut nodes = vec![json!({"id": "output", "kind": "output"})];
    let mut wires = Vec::new();
    let mut last = "facing".to_owned();
    nodes.push(json!({"id": "facing", "kind": "facing"}));
    for (number, node) in asked.nodes.iter().enumerate() {
        let mut node = node.clone();
        node["id"] = format!("asked_{number}").into();
        nodes.push(node);
        let product = format!("product_{number}");
        nodes.push(json!({"id": product, "kind": "multiply"}));
        let blocker = asked.nodes[number]["kind"] == "shadow_blocker";
        let output = if blocker { ".distance" } else { "" };
        wires.push(json!({"from": last, "to": format!("{product}.a")}));
        wires
            .push(json!({"from": format!("asked_{number}{output}"), "to": format!("{product}.b")}));
        last = product;
    }
    wires.push(json!({"from": last, "to": "output.color"}));
    look(&json!({"tier": tier, "lights": lights, "nodes": nodes, "wires": wires}))
}

fn plan(asked: &Request, tier: &str, size: [u32; 2]) -> FramePlan {
    let at = |x: f64, y: f64, z: f64, size: f64| {
        DMat4::from_translation(DVec3::new(x, y, z)) * DMat4::from_scale(DVec3::splat(size))
    };
    let level = DMat4::from_rotation_x(-std::f64::consts::FRAC_PI_2);
    let things = [
        ("plane", at(0.0, -0.8, 0.0, 4.0) * level),
        ("creature", at(0.0, 0.2, 0.0, 1.0)),
        ("sphere", at(-1.6, -0.3, 0.5, 0.5)),
        ("torus", at(1.5, -0.4, 0.6, 0.6)),
        ("vase", at(1.0, 0.0, -1.4, 0.8)),
    ];
    let parts = things.map(|(name, placed)| {
        let (mesh, fitted) = shape(name);
        (look_of(asked, tier), mesh, placed * fitted)
    });
    let camera = Camera { eye: [0.6, 1.2, 5.0], ..Camera::default() };
    let setup = scene_of(parts.into(), Scene { backdrop: None, camera, ..Scene::default() });
    let options = PlanOptions { size, samples: 1, time: 0.0 };
    let plan = Planner::default().plan(&setup, Library::built_in(), &Live::Keyed, &options);
    plan.unwrap_or_else(|problems| panic!("{}", problems[0])).value.forward()
}

fn main() {
    let words: Vec<String> =
        std::env::args().skip(1).filter(|word| !word.starts_with('-')).collect();
    let size_of = |word: &String| {
        let (width, height) = word.split_once('x')?;
        Some([width.parse().ok()?, height.parse().ok()?])
    };
    let size: [u32; 2] = words.iter().find_map(size_of).unwrap_or([800, 600]);
    let names: Vec<&String> = words.iter().filter(|word| size_of(word).is_none()).collect();
    let gpu = block_on(Gpu::headless()).expect("a GPU, a software one for one");
    println!("{}, {}x{}, one sample a pixel; ms", gpu.name(), size[0], size[1]);
    let mut renderer = Renderer::new(gpu);
    let [first, rows @ ..] = &rows()[..] else { return };
    let plans = TIERS.map(|tier| plan(first, tier, size));
    if let Some(casters) = plan(&rows[0], "exact", size).casters {
        let triangles: u32 = casters.trees().iter().map(|tree| tree.triangles).sum();
        println!("{triangles} triangles in {} trees\n", casters.trees().len());
    }
    let nothing = look_pass::look_passes(&mut renderer, &plans, ROUNDS);
    println!("nothing: {:.3}\n", nothing[0].0);
    println!("| what is asked | exact | balanced | fast | maps or passes, balanced | fast |");
    println!("| --- | ---: | ---: | ---: | ---: | ---: |");
    for asked in rows {
        if !names.is_empty() && !names.iter().any(|name| asked.name.contains(name.as_str())) {
            continue;
        }
        let plans = TIERS.map(|tier| plan(asked, tier, size));
        let times = look_pass::look_passes(&mut renderer, &plans, ROUNDS);
        let more: Vec<f64> = times.iter().zip(&nothing).map(|(a, b)| a.0 - b.0).collect();
        println!(
            "| {} | {:.3} | {:.3} | {:.3} | {:.3} | {:.3} |",
            asked.name, more[0], more[1], more[2], times[1].1, times[2].1
        );
    }
}
