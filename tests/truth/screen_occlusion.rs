//! Occlusion as the picture tells it, the fast tier, against integrals in f64 and against rays.
#![cfg(feature = "gpu")]
#![allow(clippy::print_stdout, reason = "figures for those who ask with `--nocapture`")]

use crate::support::eval::{look, renderer, scene_of, shape, told};
use crate::support::wait::block_on;
use chiaro::compile::Live;
use chiaro::document::{Camera, Projection, Scene};
use chiaro::frame::{Executor, FramePlan, PlanOptions, Planner, Setup, SetupLook};
use chiaro::geometry::{Mesh, MeshPart};
use chiaro::library::{Library, PassId};
use chiaro::progress::Progress;
use chiaro::reference::Reference;
use glam::{DMat4, DVec2, DVec3};
use serde_json::json;

/// Width and height of the pictures.
const SIZE: u32 = 160;

/// Height of what the camera sees, in scene units.
const SEEN: f64 = 4.0;

/// A look that shows occlusion in a tier.
fn shown(tier: &str, near: f64, far: f64) -> SetupLook {
    look(&json!({"nodes": [
            {"id": "near", "kind": "occlusion", "tier": tier,
                "values": {"near": near, "far": far}},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "near", "to": "output.color"}]}))
}

fn planned(setup: &Setup) -> FramePlan {
    let options = PlanOptions { size: [SIZE; 2], samples: 1, time: 0.0 };
    let planned = Planner::default().plan(setup, Library::built_in(), &Live::Keyed, &options);
    planned.unwrap_or_else(|problems| panic!("{}", told(&problems))).value
}

/// The first number of each pixel that shows anything.
fn drawn(executor: &mut dyn Executor, setup: &Setup) -> Vec<Option<f64>> {
    let picture = block_on(executor.picture(&planned(setup), &Progress::new()));
    let picture = picture.unwrap_or_else(|error| panic!("{}: {error}", executor.name()));
    picture.rgba.iter().map(|pixel| (pixel[3] > 0.5).then(|| f64::from(pixel[0]))).collect()
}

fn on_gpu(setup: &Setup) -> Vec<Option<f64>> {
    drawn(&mut *renderer(), setup)
}

/// The camera that looks down at a corner by 45 degrees, without perspective.
fn slanted() -> Scene {
    let camera = Camera {
        eye: [0.0, 10.0, 10.0],
        target: [0.0; 3],
        height: SEEN,
        projection: Projection::Orthographic,
        ..Camera::default()
    };
    Scene { backdrop: None, camera, ..Scene::default() }
}

/// The place on the floor that the middle of a pixel shows.
fn on_floor(pixel: usize) -> DVec3 {
    let at = DVec2::new((pixel % SIZE as usize) as f64, (pixel / SIZE as usize) as f64) + 0.5;
    let away = (at - 0.5 * f64::from(SIZE)) * (SEEN / f64::from(SIZE));
    DVec3::new(away.x, 0.0, away.y / std::f64::consts::FRAC_1_SQRT_2)
}

/// A floor from z = 0 on and a wall that stands on its end, long and high.
fn corner() -> Mesh {
    let quad = |from: DVec3, right: DVec3, up: DVec3| {
        let normal = right.cross(up).normalize();
        [from, from + right, from + right + up, from, from + right + up, from + up]
            .map(|at| (at, normal))
    };
    let (right, up, ahead) = (DVec3::X * 80.0, DVec3::Y * 40.0, DVec3::NEG_Z * 40.0);
    let floor = quad(DVec3::new(-40.0, 0.0, 40.0), right, ahead);
    let wall = quad(DVec3::new(-40.0, 0.0, 0.0), right, up);
    let corners = || floor.iter().chain(&wall);
    let indices: Vec<u32> = (0..corners().count() as u32).collect();
    Mesh {
        positions: corners().map(|(at, _)| at.as_vec3().to_array()).collect(),
        normals: corners().map(|(_, normal)| normal.as_vec3().to_array()).collect(),
        tangents: vec![[1.0, 0.0, 0.0, 1.0]; indices.len()],
        uvs: vec![[0.0; 2]; indices.len()],
        parts: vec![MeshPart { indices: 0..indices.len() as u32, ..MeshPart::default() }],
        indices,
        ..Mesh::default()
    }
}

/// The occlusion at a distance from an endless wall: the mean over directions, weighted by the
/// cosine, of what the distance at which they meet the wall counts.
fn beside_wall(distance: f64, near: f64, far: f64) -> f64 {
    const SIDE: usize = 200;
    let counted = |index: usize| {
        let radius = (((index / SIDE) as f64 + 0.5) / SIDE as f64).sqrt();
        let turn = std::f64::consts::TAU * ((index % SIDE) as f64 + 0.5) / SIDE as f64;
        // Toward the wall.
        let toward = radius * turn.cos();
        let length = if toward > 0.0 { distance / toward } else { f64::INFINITY };
        ((far - length) / (far - near)).clamp(0.0, 1.0)
    };
    (0..SIDE * SIDE).map(counted).sum::<f64>() / (SIDE * SIDE) as f64
}

/// Beside a wall that the picture shows, occlusion is that of the integral, at all distances; along
/// the wall it is the same everywhere, without a grain.
#[test]
fn beside_a_wall_the_picture_tells_what_the_integral_does() {
    for (near, far) in [(0.0, 1.0), (0.4, 0.9), (0.0, 0.2), (0.7, 0.7 + 1e-6)] {
        let setup =
            scene_of(vec![(shown("fast", near, far), corner(), DMat4::IDENTITY)], slanted());
        let found = on_gpu(&setup);
        let (mut sum, mut most, mut count, mut grain) = (0.0, 0.0_f64, 0.0, 0.0_f64);
        let middle = SIZE as usize / 2;
        for row in middle + 2..SIZE as usize - 2 {
            let inner = || row * SIZE as usize + 64..row * SIZE as usize + 96;
            let at = on_floor(row * SIZE as usize + 80).z;
            let wanted = beside_wall(at, near, far);
            let values: Vec<f64> = inner().map(|pixel| found[pixel].expect("the floor")).collect();
            let [least, greatest] = values
                .iter()
                .fold([f64::MAX, f64::MIN], |[least, most], x| [least.min(*x), most.max(*x)]);
            grain = grain.max(greatest - least);
            let error = values.iter().map(|x| (x - wanted).abs()).fold(0.0, f64::max);
            (sum, count, most) = (sum + error, count + 1.0, most.max(error));
        }
        let mean = sum / count;
        println!("from {near} to {far}: mean {mean:.4}, most {most:.4}, grain {grain:.4}");
        assert!(mean < 0.02 && most < 0.11, "from {near} to {far}: mean {mean}, most {most}");
        assert!(grain < 0.01, "from {near} to {far}: a grain of {grain}");
    }
}

/// The GPU and the reference draw the same, and rays see about the same, on a body of many folds.
#[test]
fn the_picture_tells_what_rays_see() {
    let (creature, fitted) = shape("creature");
    let setup = |tier: &str| {
        scene_of(
            vec![(shown(tier, 0.0, 0.4), creature.clone(), fitted)],
            Scene { backdrop: None, ..Scene::default() },
        )
    };
    let fast = setup("fast");
    let plan = planned(&fast);
    let passes: Vec<PassId> = plan.passes.iter().map(|pass| pass.id).collect();
    assert_eq!(
        passes,
        ["normals", "near_slices", "near_shares", "draw"].map(PassId::named),
        "{passes:?}"
    );
    assert!(plan.casters.is_none(), "nothing sends rays");
    let gpu = on_gpu(&fast);
    let exact = on_gpu(&setup("exact"));
    let truth = drawn(&mut Reference::default(), &fast);
    let apart = |one: &[Option<f64>], other: &[Option<f64>]| {
        let both = one.iter().zip(other).filter_map(|(one, other)| Some(((*one)?, (*other)?)));
        let mut apart: Vec<f64> = both.map(|(one, other)| (one - other).abs()).collect();
        apart.sort_by(f64::total_cmp);
        apart
    };
    let same = apart(&gpu, &truth);
    let differ = same.iter().filter(|apart| **apart > 0.01).count();
    println!("{differ} of {} pixels differ from the reference", same.len());
    assert!(same.len() > 5000 && differ * 1000 <= same.len(), "{differ} of {}", same.len());
    let off = apart(&gpu, &exact);
    let mean = off.iter().sum::<f64>() / off.len() as f64;
    let near_all = off[off.len() * 19 / 20];
    println!("against rays: mean {mean:.4}, 19 in 20 within {near_all:.4}");
    assert!(mean < 0.05 && near_all < 0.15, "mean {mean}, 19 in 20 within {near_all}");
}
