//! Curvature in each tier and per vertex: the time of a frame, and the error of a look that shows
//! nothing else.
//!
//! Per vertex, mean curvature is computed once from the mesh (from the normals along the edges of
//! each vertex), passed as a vertex color, interpolated, and converted to picture units by the
//! distance; `slanted` also accounts for the angle at which the surface is seen, for the curvature
//! of a ball.

use std::sync::Arc;

use chiaro::accuracy::Truth;
use chiaro::accuracy::cost::{Series, alternate};
use chiaro::compile::Live;
use chiaro::document::Look;
use chiaro::frame::{Assets, FramePlan, PlanOptions, Planner, Setup, SetupLook, default_setup};
use chiaro::geometry::Mesh;
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::render::{Gpu, Renderer};
use glam::{DMat4, DVec3, Vec3};
use serde_json::{Value as Json, json};

use chiaro_test_drawing::wait::block_on;

const SIZES: [[u32; 2]; 2] = [[256, 256], [800, 600]];
const MESHES: [&str; 3] = ["shape:sphere", "shape:torus", "shape:creature"];
const ROUNDS: usize = 11;
/// Slope of figure 4.
const SLOPE: f64 = 0.3;

/// Mean curvature at each vertex in object space, convex positive, in 1/unit: along each edge the
/// normal turns by (n1 - n0) . (p1 - p0) / |p1 - p0|^2.
fn mean_curvature(mesh: &Mesh) -> Vec<f32> {
    let mut sums = vec![(0.0_f32, 0.0_f32); mesh.positions.len()];
    for corner in mesh.indices.chunks_exact(3) {
        for (from, to) in [(0, 1), (1, 2), (2, 0)] {
            let [a, b] = [corner[from] as usize, corner[to] as usize];
            let along = Vec3::from(mesh.positions[b]) - Vec3::from(mesh.positions[a]);
            let turned = Vec3::from(mesh.normals[b]) - Vec3::from(mesh.normals[a]);
            let curvature = turned.dot(along) / along.length_squared().max(1e-20);
            for end in [a, b] {
                sums[end].0 += curvature;
                sums[end].1 += 1.0;
            }
        }
    }
    sums.into_iter().map(|(sum, count)| sum / count.max(1.0)).collect()
}

fn setup(json: &Json, mesh: &str) -> Setup {
    let loaded = Look::read(&json.to_string(), "bench.json");
    assert!(loaded.diagnostics.is_empty(), "{:?}", loaded.diagnostics);
    let look = SetupLook {
        look: loaded.value.expect("a look"),
        source: loaded.source.into(),
        folder: "".into(),
    };
    default_setup(look, mesh, &mut Assets::default()).expect("a mesh").value
}

/// A look that shows how convex the surface is, by the curvature that `wires` bring to
/// `convexity.kappa`.
fn convexity(mut nodes: Vec<Json>, mut wires: Vec<Json>) -> Json {
    nodes.push(json!({"id": "convexity", "kind": "transition", "values": {"slope": SLOPE}}));
    nodes.push(json!({"id": "output", "kind": "output"}));
    wires.push(json!({"from": "convexity", "to": "output.color"}));
    json!({"nodes": nodes, "wires": wires})
}

fn per_pixel(tier: &str) -> Json {
    let kappa = json!({"id": "kappa", "kind": "kappa", "tier": tier});
    convexity(vec![kappa], vec![json!({"from": "kappa", "to": "convexity.kappa"})])
}

/// Curvature from the red of the vertex color, times the distance and `scale`; if `slanted`, also
/// times (1 + z^2) / (2 z^3).
fn per_vertex(scale: f64, slanted: bool) -> Json {
    let mut nodes = vec![
        json!({"id": "color", "kind": "vertex_color"}),
        json!({"id": "parts", "kind": "separate_color"}),
        json!({"id": "depth", "kind": "depth"}),
        json!({"id": "far", "kind": "multiply", "values": {"b": scale}}),
        json!({"id": "kappa", "kind": "multiply"}),
    ];
    let wire = |from: &str, to: &str| json!({"from": from, "to": to});
    let mut wires = vec![
        wire("color", "parts.color"),
        wire("depth", "far.a"),
        wire("parts.red", "kappa.a"),
        wire("far", "kappa.b"),
    ];
    if slanted {
        nodes.extend([
            json!({"id": "normal", "kind": "camera_normal"}),
            json!({"id": "axes", "kind": "separate_vector"}),
            json!({"id": "z", "kind": "maximum", "values": {"b": 0.2}}),
            json!({"id": "z2", "kind": "multiply"}),
            json!({"id": "above", "kind": "add", "values": {"b": 1.0}}),
            json!({"id": "z3", "kind": "multiply"}),
            json!({"id": "below", "kind": "multiply", "values": {"b": 2.0}}),
            json!({"id": "slant", "kind": "divide"}),
            json!({"id": "seen", "kind": "multiply"}),
        ]);
        wires.extend([
            wire("normal", "axes.vector"),
            wire("axes.z", "z.a"),
            wire("z", "z2.a"),
            wire("z", "z2.b"),
            wire("z2", "above.a"),
            wire("z2", "z3.a"),
            wire("z", "z3.b"),
            wire("z3", "below.a"),
            wire("above", "slant.a"),
            wire("below", "slant.b"),
            wire("kappa", "seen.a"),
            wire("slant", "seen.b"),
        ]);
    }
    wires.push(wire(if slanted { "seen" } else { "kappa" }, "convexity.kappa"));
    convexity(nodes, wires)
}

/// The setup whose mesh holds its curvature in world space as the red of its vertices.
fn with_vertex_curvature(json: &Json, mesh: &str) -> Setup {
    let mut setup = setup(json, mesh);
    for object in &mut setup.objects {
        let scale = length_of(object.world_from_object);
        let mut mesh = Mesh::clone(&object.mesh);
        let curvature = mean_curvature(&mesh);
        mesh.colors =
            curvature.iter().map(|curvature| [curvature / scale as f32, 0.0, 0.0, 1.0]).collect();
        mesh.has_colors = true;
        object.mesh = Arc::new(mesh);
    }
    setup
}

fn length_of(matrix: DMat4) -> f64 {
    matrix.transform_vector3(DVec3::X).length()
}

fn plan(setup: &Setup, options: &PlanOptions) -> FramePlan {
    let planned = Planner::default().plan(setup, Library::built_in(), &Live::Keyed, options);
    planned.unwrap_or_else(|problems| panic!("{problems:?}")).value
}

fn told(series: &Series, exact: &Series) -> String {
    let ratio = series.ratio(exact);
    format!(
        "{:.2} ms | {:.3} ({:.3} to {:.3})",
        series.estimate().median,
        ratio.median,
        ratio.low,
        ratio.high
    )
}

/// Prints a row for each mesh, size and form.
pub(crate) fn run(gpu: Gpu) {
    let mut precise = Renderer::new(gpu.precise());
    let mut renderer = Renderer::new(gpu);
    println!("\n| mesh | size | form | frame | of exact | max error | p99.9 | rms |");
    println!("| --- | --- | --- | ---: | --- | ---: | ---: | ---: |");
    for mesh in MESHES {
        for size in SIZES {
            let options = PlanOptions { size, samples: 1, time: 0.0 };
            let exact = setup(&per_pixel("exact"), mesh);
            let view_height = plan(&exact, &options).view.view_height;
            let forms = [
                ("exact", exact.clone()),
                ("balanced", setup(&per_pixel("balanced"), mesh)),
                ("fast", setup(&per_pixel("fast"), mesh)),
                ("per vertex", with_vertex_curvature(&per_vertex(view_height, false), mesh)),
                (
                    "per vertex, slanted",
                    with_vertex_curvature(&per_vertex(view_height, true), mesh),
                ),
            ];
            let plans: Vec<FramePlan> =
                forms.iter().map(|(_, setup)| plan(setup, &options)).collect();
            let progress = Progress::new();
            let series = block_on(alternate(
                &mut renderer,
                &plans.iter().collect::<Vec<_>>(),
                ROUNDS,
                &progress,
            ));
            let series = series.unwrap_or_else(|stopped| panic!("{stopped:?}"));
            let mut planner = Planner::for_truth(Assets::default());
            let truth = Truth::of(&exact, Library::built_in(), &mut planner, &options, &progress);
            let truth = truth.unwrap_or_else(|stopped| panic!("{stopped:?}"));
            for (((name, _), plan), times) in forms.iter().zip(&plans).zip(&series) {
                let error = block_on(truth.compare(&mut precise, plan))
                    .unwrap_or_else(|stopped| panic!("{stopped:?}"));
                let [width, height] = size;
                let time = told(times, &series[0]);
                println!(
                    "| {mesh} | {width}x{height} | {name} | {time} | {:.1e} | {:.1e} | {:.1e} |",
                    error.max, error.p999, error.rms
                );
            }
        }
    }
}

/// Checks [`mean_curvature`] on a ball, whose curvature is 1 over its radius.
pub(crate) fn check() {
    let setup = setup(&per_pixel("exact"), "shape:sphere");
    let curvature = mean_curvature(&setup.objects[0].mesh);
    let radius = Vec3::from(setup.objects[0].mesh.positions[0]).length();
    assert!(
        curvature.iter().all(|x| (x * radius - 1.0).abs() < 0.02),
        "a ball's curvature is 1 over its radius"
    );
}
