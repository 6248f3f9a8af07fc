//! Quick painted surfaces: depths that are drawn before looks, of which the picture stays the same,
//! and modules that have taps by default.
#![cfg(feature = "gpu")]

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::support::eval::{look, renderer, scene_of, shape, told};
use crate::support::wait::block_on;
use chiaro::compile::Live;
use chiaro::document::{Camera, Directions, Grid, Hcbtf, Scene, Tier, Tile};
use chiaro::frame::{FramePlan, PlanOptions, Planner, Setup};
use chiaro::library::Library;
use glam::{DMat4, DVec3};
use serde_json::json;

const SIZE: [u32; 2] = [96, 72];

/// Writes an HCBTF of noise into a folder of the build. The last sample of one that is not opaque
/// has a hole.
pub(crate) fn file(name: &str, is_opaque: bool) -> PathBuf {
    let directions = Directions { theta: 3, phi: 4 };
    let grid = Grid { size: [6, 4], light: directions, view: directions };
    let mut hcbtf = Hcbtf::new(grid);
    let addresses: Vec<_> = grid.addresses().collect();
    for (number, address) in (0_u32..).zip(&addresses) {
        let has_hole = !is_opaque && number as usize + 1 == addresses.len();
        let texel = |at: u32| {
            let [r, g, b, _] = (at + 24 * number).wrapping_mul(0x9e37_79b1).to_le_bytes();
            [r, g, b, if has_hole && at == 7 { 90 } else { 255 }]
        };
        let bytes = (0..24).flat_map(texel).collect();
        hcbtf.painted.insert(*address, Arc::new(Tile::new(grid.size, bytes).expect("its size")));
    }
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("depth_first");
    std::fs::create_dir_all(&folder).expect("a folder");
    let path = folder.join(format!("{name}.hcbtf"));
    std::fs::write(&path, chiaro::hcbtf::write(&hcbtf).expect("it fits")).expect("a file");
    path
}

/// A painted torus before painted waves; `alpha` is that of the color below the horizon.
pub(crate) fn setup(path: &Path, storage: &str, alpha: f64) -> Setup {
    let worn = || {
        look(&json!({
            "lights": {"key": {"direction": [0.4, 0.8, 0.5]}},
            "nodes": [
                {"id": "light", "kind": "light", "values": {"light": "key"}},
                {
                    "id": "paint", "kind": "hcbtf_lookup", "values": {
                        "sheet": path.display().to_string(), "storage": storage, "scale": [3, 3],
                        "unlit": [0.1, 0.1, 0.3, alpha]
                    }
                },
                {"id": "dimmed", "kind": "mix_colors", "values": {
                    "mode": "multiply", "b": [0.9, 0.8, 0.7, 1], "factor": 1
                }},
                {"id": "output", "kind": "output"}
            ],
            "wires": [
                {"from": "light", "to": "paint.light"}, {"from": "paint", "to": "dimmed.a"},
                {"from": "dimmed", "to": "output.color"}
            ]
        }))
    };
    let placed = |name: &str, matrix: DMat4| {
        let (mesh, own) = shape(name);
        (worn(), mesh, matrix * own)
    };
    let lying = DMat4::from_rotation_x(-std::f64::consts::FRAC_PI_2);
    let before =
        DMat4::from_translation(DVec3::new(0.1, 0.4, 0.3)) * DMat4::from_scale(DVec3::splat(0.5));
    let camera = Camera { eye: [0.0, 1.1, 2.1], ..Camera::default() };
    scene_of(
        vec![placed("waves", lying), placed("torus", before)],
        Scene { camera, ..Scene::default() },
    )
}

fn plan(setup: &Setup, samples: u32) -> FramePlan {
    let options = PlanOptions { size: SIZE, samples, time: 0.0 };
    Planner::default()
        .plan(setup, Library::built_in(), &Live::Keyed, &options)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)))
        .value
}

fn pixels(plan: &FramePlan) -> Vec<[f32; 4]> {
    block_on(renderer().picture(plan)).unwrap_or_else(|error| panic!("{error}")).rgba
}

#[test]
fn depths_that_come_first_change_no_pixel() {
    for storage in ["quick", "compact", "blocks"] {
        let path = file(&format!("opaque_{storage}"), true);
        for samples in [1, 4] {
            let first = plan(&setup(&path, storage, 1.0), samples);
            assert!(first.draws.iter().all(|draw| draw.depth_first), "{storage}");
            // The renderer makes the position invariant by these words.
            let position = "    @builtin(position) clip: vec4f,\n";
            assert!(first.draws.iter().all(|draw| draw.look.wgsl.contains(position)));
            let mut together = first.clone();
            together.draws.iter_mut().for_each(|draw| draw.depth_first = false);
            let [first, together] = [pixels(&first), pixels(&together)];
            let is_seen = |pixel: &&[f32; 4]| pixel[3] > 0.0;
            assert!(first.iter().filter(is_seen).count() > 1000);
            // Alpha is 1 but for a rounding, by which what is hidden shone through.
            let differ =
                |(a, b): (&[f32; 4], &[f32; 4])| a.iter().zip(b).any(|(a, b)| (a - b).abs() > 1e-3);
            let count = first.iter().zip(&together).filter(|pair| differ(*pair)).count();
            assert_eq!(count, 0, "{storage}, {samples} samples a pixel");
        }
    }
}

/// A step of a screen is more than the balanced tier may be off, so that nobody needs to ask for
/// its taps.
#[test]
fn a_module_has_taps_by_default() {
    let path = file("modules", true);
    for storage in ["quick", "compact", "blocks"] {
        let mut setup = setup(&path, storage, 1.0);
        let wgsl = |setup: &Setup| plan(setup, 1).draws[0].look.wgsl.clone();
        setup.looks.iter_mut().for_each(|worn| worn.look.tier = None);
        let default = wgsl(&setup);
        assert!(default.contains("textureSampleLevel"), "{storage}:\n{default}");
        setup.looks.iter_mut().for_each(|worn| worn.look.tier = Some(Tier::Exact));
        let exact = wgsl(&setup);
        assert!(!exact.contains("textureSampleLevel"), "{storage}:\n{exact}");
    }
}

#[test]
fn what_may_be_seen_through_asks_for_no_depth() {
    let (opaque, hole) = (file("opaque", true), file("hole", false));
    for (path, alpha, is_first) in
        [(&opaque, 1.0, true), (&opaque, 0.5, false), (&hole, 1.0, false)]
    {
        for storage in ["quick", "compact", "blocks"] {
            let plan = plan(&setup(path, storage, alpha), 1);
            assert!(
                plan.draws.iter().all(|draw| draw.depth_first == is_first),
                "{storage}, {}, {alpha}",
                path.display()
            );
        }
    }
    // A look that is quick to draw is drawn at once.
    let (mesh, matrix) = shape("sphere");
    let plain = look(&json!({"nodes": [
        {"id": "base", "kind": "base", "values": {"color": [0.2, 0.5, 0.9]}},
        {"id": "output", "kind": "output"}
    ], "wires": [{"from": "base", "to": "output.color"}]}));
    let plan = plan(&scene_of(vec![(plain, mesh, matrix)], Scene::default()), 1);
    assert!(plan.draws.iter().all(|draw| !draw.depth_first));
    assert_eq!(plan.draws[0].look.opaque_with.as_deref(), Some(&[][..]), "it is opaque");
}

#[test]
fn ramps_of_opaque_stops_are_opaque() {
    let looks = |alpha: f64, space: &str| {
        let stop = |at: f64, alpha: f64| json!({"at": at, "color": [0.9, at, 0.1, alpha]});
        let ramp = json!({"stops": [stop(0.0, 1.0), stop(0.5, alpha), stop(1.0, 1.0)]});
        look(&json!({"nodes": [
            {"id": "facing", "kind": "facing"},
            {"id": "paint", "kind": "ramp", "values": {"space": space, "ramp": ramp}},
            {"id": "output", "kind": "output"}
        ], "wires": [
            {"from": "facing", "to": "paint.value"},
            {"from": "paint", "to": "output.color"}
        ]}))
    };
    let (mesh, matrix) = shape("sphere");
    for space in ["plain", "oklab", "light", "hue", "hsv"] {
        for (alpha, is_opaque) in [(1.0, true), (0.999, false)] {
            let look = looks(alpha, space);
            let plan = plan(&scene_of(vec![(look, mesh.clone(), matrix)], Scene::default()), 1);
            let found = plan.draws[0].look.opaque_with.as_deref();
            assert_eq!(found, is_opaque.then_some(&[][..]), "{space} {alpha}");
        }
    }
}
