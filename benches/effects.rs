//! Benchmark of the savings by leaving out effects that a scene does not need: pictures with an
//! effect against pictures without it.
//!
//! `cargo bench --profile dev --no-default-features --features gpu --bench effects` prints medians
//! of wall-clock times, taken in turns so that a busy machine slows both. docs/performance.md holds
//! the figures. A node that could be left out is kept by exposing the value that makes it useless:
//! the picture is the same, and the compiler can prove nothing about the node.
#![allow(clippy::print_stdout, reason = "it is what a benchmark is for")]

use std::sync::Arc;
use std::time::Instant;

use chiaro::compile::Live;
use chiaro::document::{Camera, Look, Scene};
use chiaro::frame::{
    CullMode, FramePlan, PlanOptions, Planner, Setup, SetupLook, SetupObject, object_matrix,
};
use chiaro::geometry::{Mesh, shape};
use chiaro::library::Library;
use chiaro::render::{Gpu, Renderer};
use chiaro_test_drawing::wait::block_on;
use glam::{DMat4, DVec3};
use serde_json::{Value as Json, json};

const OPTIONS: PlanOptions = PlanOptions { size: [640, 480], samples: 1, time: 0.0 };
const TURNS: usize = 15;

fn look(json: &Json) -> SetupLook {
    let loaded = Look::read(&json.to_string(), "bench.json");
    let problems: Vec<String> = loaded.diagnostics.iter().map(ToString::to_string).collect();
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    SetupLook {
        look: loaded.value.expect("a look"),
        source: loaded.source.into(),
        folder: "".into(),
    }
}

fn object(number: usize, mesh: &Arc<Mesh>, look: usize, matrix: DMat4) -> SetupObject {
    SetupObject {
        id: format!("object_{number}").as_str().into(),
        mesh: mesh.clone(),
        world_from_object: matrix * object_matrix(&chiaro::document::Transform::default(), mesh),
        looks: vec![Some(look); mesh.parts.len()],
        values: chiaro::document::Values::default(),
        light_link: Default::default(),
        shadow_link: Default::default(),
        layers: Default::default(),
        animation: None,
    }
}

fn one(look: SetupLook, mesh: &Arc<Mesh>) -> Setup {
    Setup {
        looks: vec![look],
        objects: vec![object(0, mesh, 0, DMat4::IDENTITY)],
        ..Setup::default()
    }
}

fn plan(planner: &mut Planner, setup: &Setup, live: &Live) -> FramePlan {
    planner
        .plan(setup, Library::built_in(), live, &OPTIONS)
        .unwrap_or_else(|problems| panic!("{problems:?}"))
        .value
}

#[expect(clippy::disallowed_methods, reason = "a benchmark is about time")]
fn milliseconds(of: impl FnOnce()) -> f64 {
    let start = Instant::now();
    of();
    start.elapsed().as_secs_f64() * 1e3
}

fn median(times: &mut [f64]) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// Median times of drawing the plans in turns; pipelines and meshes of the plans are created in a
/// first turn that is not counted.
fn draw(renderer: &mut Renderer, plans: [&FramePlan; 2]) -> [f64; 2] {
    let mut times = [Vec::new(), Vec::new()];
    for turn in 0..=TURNS {
        for (plan, times) in plans.iter().zip(&mut times) {
            let time = milliseconds(|| drop(block_on(renderer.picture(plan)).expect("it draws")));
            if turn > 0 {
                times.push(time);
            }
        }
    }
    times.map(|mut times| median(&mut times))
}

/// A look of some layers under its own name, so that no two looks are alike.
fn layered(name: &str, color: f64) -> SetupLook {
    let layer = |id: &str, kind: &str, offset: f64| {
        json!({
            "id": id, "kind": "light_layer",
            "values": {"light": "key", "type": kind, "offset": offset,
            "falloff": offset + 0.5, "cutoff": offset + 1.0, "convex": [color, 0.4, 0.6, 1],
            "concave": [color, 0.4, 0.6, 1]}})
    };
    look(&json!({"name": name, "lights": {"key": {"direction": [1, 2, 3]}},
        "nodes": [
            {"id": "base", "kind": "base"}, layer("one", "diffuse", 0.0),
            layer("two", "specular", 0.2),
            layer("three", "diffuse", 0.4), {"id": "output", "kind": "output"}],
        "wires": [{"from": "base", "to": "one.below"}, {"from": "one.below", "to": "two.below"},
            {"from": "two.below", "to": "three.below"},
            {"from": "three.below", "to": "output.color"}]}))
}

/// Ten objects before the camera, and `others` far to the side, each with a look of its own.
fn crowd(mesh: &Arc<Mesh>, others: usize) -> Setup {
    let mut setup = Setup {
        scene: Scene { camera: Camera::default(), ..Scene::default() },
        ..Setup::default()
    };
    for number in 0..10 + others {
        let place = match number {
            0..10 => {
                DVec3::new((number % 5) as f64 * 0.6 - 1.2, (number / 5) as f64 * 0.8 - 0.4, 0.0)
            }
            _ => DVec3::new(300.0, number as f64, 0.0),
        };
        setup.looks.push(layered(&format!("look {number}"), 0.01 * number as f64));
        let matrix = DMat4::from_translation(place) * DMat4::from_scale(DVec3::splat(0.3));
        setup.objects.push(object(number, mesh, number, matrix));
    }
    setup
}

fn fifty_looks(renderer: &mut Renderer, mesh: &Arc<Mesh>) {
    println!("50 looks, 40 of them out of sight, beside the 10 alone, in ms");
    let setups = [crowd(mesh, 0), crowd(mesh, 40), crowd(mesh, 40)];
    let culls = [CullMode::All, CullMode::All, CullMode::Nothing];
    let mut cold: [Vec<f64>; 3] = Default::default();
    let mut warm: [Vec<f64>; 3] = Default::default();
    let mut planners: [Planner; 3] = Default::default();
    for turn in 0..TURNS {
        for (index, setup) in setups.iter().enumerate() {
            if turn % 3 == 0 {
                let mut fresh = Planner::default().culling(culls[index]);
                cold[index].push(milliseconds(|| drop(plan(&mut fresh, setup, &Live::Keyed))));
                planners[index] = fresh;
            }
            warm[index]
                .push(milliseconds(|| drop(plan(&mut planners[index], setup, &Live::Keyed))));
        }
    }
    let plans = [0, 1, 2].map(|index| plan(&mut planners[index], &setups[index], &Live::Keyed));
    let [ten, fifty] = draw(renderer, [&plans[0], &plans[1]]);
    let [_, all] = draw(renderer, [&plans[0], &plans[2]]);
    let names = ["10 looks", "50 looks, 40 out of sight", "50 looks, nothing left out"];
    for (index, gpu) in [ten, fifty, all].into_iter().enumerate() {
        let (cold, warm) = (median(&mut cold[index]), median(&mut warm[index]));
        println!(
            "  {:28} first plan {cold:8.2}  next plan {warm:7.3}  picture {gpu:7.2}",
            names[index]
        );
    }
}

type Case = (&'static str, &'static str, Json, Json);

/// A look for each kind of reason: the part that is left out, the value to expose so that it stays,
/// nodes and wires.
fn cases() -> Vec<Case> {
    let facing = json!({"id": "facing", "kind": "facing"});
    let noise =
        |id: &str| json!({"id": id, "kind": "noise", "values": {"octaves": 4, "kind": "perlin"}});
    let wire = |from: &str, to: &str| json!({"from": from, "to": to});
    let to_output = |from: &str| wire(from, "output.color");
    vec![
        (
            "zero weight: a mix of 0 with four octaves of noise",
            "mix.factor",
            json!([
                facing, noise("noise"), {"id": "mix", "kind": "mix_values", "values": {"factor": 0}}
            ]),
            json!([wire("facing", "mix.a"), wire("noise", "mix.b"), to_output("mix")]),
        ),
        (
            "no effect: a power of 1",
            "power.exponent",
            json!([facing, {"id": "power", "kind": "power", "values": {"exponent": 1}}]),
            json!([wire("facing", "power.base"), to_output("power")]),
        ),
        (
            "constant: noise at one place",
            "noise.position",
            json!([
                facing,
                {
                    "id": "noise", "kind": "noise",
                    "values": {"octaves": 4, "position": [0.3, 0.2, 0.1]}
                },
                {"id": "sum", "kind": "add"}
            ]),
            json!([wire("facing", "sum.a"), wire("noise", "sum.b"), to_output("sum")]),
        ),
        (
            "equal to another: the same noise twice",
            "twin.scale",
            json!([
                noise("noise"),
                {
                    "id": "twin", "kind": "noise",
                    "values": {"octaves": 4, "kind": "perlin", "scale": 5}
                },
                {"id": "sum", "kind": "add"}
            ]),
            json!([wire("noise", "sum.a"), wire("twin", "sum.b"), to_output("sum")]),
        ),
        (
            "ranges: a mask that is 1 everywhere before noise",
            "more.b",
            json!([
                facing, noise("noise"), {"id": "more", "kind": "add", "values": {"b": 2}},
                {"id": "mask", "kind": "threshold"}, {"id": "mix", "kind": "mix_values"}
            ]),
            json!([
                wire("facing", "more.a"),
                wire("more", "mask.value"),
                wire("mask", "mix.factor"),
                wire("noise", "mix.a"),
                wire("facing", "mix.b"),
                to_output("mix")
            ]),
        ),
        (
            "ranges: an ambient profile",
            "profile.offset",
            json!([
                facing,
                {"id": "profile", "kind": "profile", "values": {"offset": std::f64::consts::PI}},
                {"id": "all", "kind": "multiply"}
            ]),
            json!([
                wire("facing", "profile.angle"),
                wire("profile", "all.a"),
                wire("facing", "all.b"),
                to_output("all")
            ]),
        ),
        (
            "ranges: a cutoff that cuts nothing",
            "output.cutoff",
            json!([facing]),
            json!([to_output("facing")]),
        ),
        (
            "passes: curvature of slope 0",
            "bent.slope",
            json!([
                facing, {"id": "bent", "kind": "transition", "values": {"slope": 0}},
                {"id": "sum", "kind": "add"}
            ]),
            json!([wire("facing", "sum.a"), wire("bent", "sum.b"), to_output("sum")]),
        ),
    ]
}

fn removals(renderer: &mut Renderer, mesh: &Arc<Mesh>) {
    println!("one thing kept and left out, the same picture, in ms");
    for (what, exposed, nodes, wires) in cases() {
        let mut nodes = nodes.as_array().expect("a list").clone();
        nodes.push(match exposed {
            "output.cutoff" => json!({"id": "output", "kind": "output", "values": {"cutoff": 0.5}}),
            _ => json!({"id": "output", "kind": "output"}),
        });
        let look = look(&json!({
            "nodes": nodes, "wires": wires, "exposed": [{"name": "kept", "target": exposed}]
        }));
        let setup = one(look, mesh);
        let kept = plan(&mut Planner::default(), &setup, &Live::Exposed);
        let left_out = plan(&mut Planner::default(), &setup, &Live::Keyed);
        report(what, draw(renderer, [&kept, &left_out]));
    }
    let lit = |intensity: f64| {
        let mut layered = layered("lit", 0.4);
        layered.look.lights["key"].intensity = intensity;
        one(layered, mesh)
    };
    let setup = lit(0.0);
    let kept = plan(&mut Planner::default().culling(CullMode::Objects), &setup, &Live::Keyed);
    let left_out = plan(&mut Planner::default(), &setup, &Live::Keyed);
    report(
        "light reaches no object: three layers of a light that is out",
        draw(renderer, [&kept, &left_out]),
    );
    let mut setup = crowd(mesh, 0);
    setup
        .objects
        .iter_mut()
        .for_each(|object| object.world_from_object *= DMat4::from_scale(DVec3::ZERO));
    let kept = plan(&mut Planner::default().culling(CullMode::Nothing), &setup, &Live::Keyed);
    let left_out = plan(&mut Planner::default(), &setup, &Live::Keyed);
    report("no surface: ten objects of scale 0", draw(renderer, [&kept, &left_out]));
}

fn report(what: &str, [kept, left_out]: [f64; 2]) {
    println!(
        "  {what:60} kept {kept:7.2}  left out {left_out:7.2}  {:5.1} %",
        100.0 * (kept - left_out) / kept
    );
}

fn main() {
    let gpu = block_on(Gpu::headless()).expect("an adapter; software Vulkan does");
    let mut renderer = Renderer::new(gpu);
    let mesh = Arc::new(shape("creature").expect("a shape"));
    fifty_looks(&mut renderer, &mesh);
    removals(&mut renderer, &mesh);
}
