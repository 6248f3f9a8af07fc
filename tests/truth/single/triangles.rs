//! Vertices that a GPU takes coverage from, and vertices that it interpolates between.

use chiaro::compile::Live;
use chiaro::document::{Camera, Scene};
use chiaro::frame::{PlanOptions, Planner, Setup};
use chiaro::geometry::{Mesh, MeshPart};
use chiaro::interp::Precision;
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::reference::{self, Modules, ReferenceOptions, ReferencePicture, SnapGrid};
use chiaro::render::{Picture, Renderer};
use serde_json::json;

use crate::support::eval::{look, renderer, scene};
use crate::support::random::Random;
use crate::support::wait::block_on;

const SIZE: [u32; 2] = [192, 144];

/// A mesh of triangles of a few pixels, each in a cell of its own, tilted and in very different
/// colors.
fn crumbs(random: &mut Random) -> Mesh {
    let mut mesh = Mesh::default();
    for row in 0..18 {
        for column in 0..24 {
            for corner in 0..3 {
                let turn =
                    std::f64::consts::TAU * (f64::from(corner) / 3.0 + random.between(-0.1, 0.1));
                let radius = random.between(0.01, 0.05);
                let [x, y] =
                    [f64::from(column) - 11.5, f64::from(row) - 8.5].map(|step| 0.1 * step);
                let at =
                    [x + radius * turn.cos(), y + radius * turn.sin(), random.between(-0.3, 0.3)];
                mesh.positions.push(at.map(|x| x as f32));
                mesh.normals.push([0.0, 0.0, 1.0]);
                mesh.tangents.push([1.0, 0.0, 0.0, 1.0]);
                mesh.uvs.push([0.0; 2]);
                mesh.colors.push([
                    random.unit() as f32,
                    random.unit() as f32,
                    random.unit() as f32,
                    1.0,
                ]);
            }
        }
    }
    mesh.indices = (0..mesh.positions.len() as u32).collect();
    mesh.parts = vec![MeshPart {
        indices: 0..mesh.indices.len() as u32,
        two_sided: true,
        ..MeshPart::default()
    }];
    (mesh.has_colors, mesh.has_normals) = (true, true);
    mesh
}

fn both(setup: &Setup, snap: SnapGrid) -> (Picture, ReferencePicture) {
    let size = PlanOptions { size: SIZE, samples: 1, time: 0.0 };
    let plan = Planner::default()
        .plan(setup, Library::built_in(), &Live::Keyed, &size)
        .expect("it is planned")
        .value;
    let modules = Modules::new(&plan, Precision::F64).expect("it compiles");
    let options = ReferenceOptions { snap, ..ReferenceOptions::default() };
    let reference =
        reference::execute(&plan, &modules, &options, &Progress::new()).expect("it is drawn");
    let picture =
        block_on(Renderer::new(renderer().gpu().precise()).picture(&plan)).expect("it is drawn");
    (picture, reference)
}

/// Number of pixels that both pictures cover, number that only one covers, and the largest and the
/// mean difference of the former.
fn differences(picture: &Picture, reference: &ReferencePicture) -> (usize, usize, f64, f64) {
    let (mut shared, mut single, mut most, mut sum) = (0, 0, 0.0_f64, 0.0);
    for y in 0..SIZE[1] {
        for x in 0..SIZE[0] {
            let (got, wanted) =
                (picture.rgba[(y * SIZE[0] + x) as usize], reference.straight(x, y));
            if (got[3] > 0.0) != (wanted[3] > 0.0) {
                single += 1;
            } else if got[3] > 0.0 {
                let apart =
                    (0..3).map(|c| (f64::from(got[c]) - wanted[c]).abs()).fold(0.0, f64::max);
                (shared, most, sum) = (shared + 1, most.max(apart), sum + apart);
            }
        }
    }
    (shared, single, most, sum / shared as f64)
}

/// A GPU decides coverage by rounded vertices, and interpolates between the exact ones.
#[test]
#[allow(clippy::print_stdout, reason = "the documentation's figures are what `--nocapture` shows")]
fn coverage_is_rounded_and_planes_are_not() {
    let look = look(&json!({
        "nodes": [{"id": "color", "kind": "vertex_color"}, {"id": "output", "kind": "output"}],
        "wires": [{"from": "color", "to": "output.color"}]
    }));
    let mesh = crumbs(&mut Random::new(90));
    let setup =
        scene(look, mesh, Scene { camera: Camera::default(), backdrop: None, ..Scene::default() });
    let (picture, reference) = both(&setup, SnapGrid::Subpixel(8));
    let (shared, single, most, mean) = differences(&picture, &reference);
    println!("| {shared} | {single} | {most:.1e} | {mean:.1e} |");
    assert!(shared > 2000, "{shared}");
    if renderer().gpu().is_software() {
        // Planes through rounded corners would be off by 1e-2 and 2e-4. The rest is the error of
        // f32, of planes that are steep.
        assert!(single == 0 && most < 2e-4 && mean < 5e-6, "{single} pixels, {most:e}, {mean:e}");
    } else {
        assert!(single < 20 && mean < 1e-3, "{single} pixels, {most:e}, {mean:e}");
    }
}
