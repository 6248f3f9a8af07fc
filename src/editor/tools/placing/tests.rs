//! Lights that were placed at a pixel, and what the probe reads there.

use std::path::PathBuf;
use std::sync::Arc;

use glam::DQuat;

use super::super::surface::read_surface;
use super::work::{PlacingAnswer, PlacingRequest, PlacingTask, SurfaceAnswer, WantedMark, place};
use crate::compile::Live;
use crate::document::{Light, Look};
use crate::frame::{AssetStore, PlanOptions, Planner};
use crate::library::Library;
use crate::placing::{Parametrization, terminator_angle};
use crate::progress::Progress;
use crate::reference::{ReferenceOptions, probe_wires};
use crate::state::orbit::Orbit;
use crate::state::snapshot::{CachedPlanner, RenderSnapshot};

const SIZE: [u32; 2] = [120, 90];
/// Angles of the profile, and slope and amount of its warp.
const SHAPE: [f64; 3] = [0.05, 1.2, 1.9];
const WARP: (f64, f64) = (0.3, 0.25);

fn look(kind: &str, space: &str, parametrization: &str) -> Look {
    let [offset, falloff, cutoff] = SHAPE;
    let (slope, amount) = WARP;
    let text = format!(
        r#"{{"lights": {{"key": {{"type": "{kind}", "space": "{space}",
            "direction": [-0.5, 0.7, 0.6], "position": [-1.5, 2.0, 1.8], "aim": [1, -1, -1],
            "outer": 0.7}}}},
        "nodes": [{{"id": "light", "kind": "light", "values": {{"light": "key"}}}},
            {{"id": "angle", "kind": "parametrization", "values": {{"type": "{parametrization}"}}}},
            {{"id": "convexity", "kind": "transition", "values": {{"slope": {slope}}}}},
            {{"id": "warp", "kind": "warp", "values": {{"amount": {amount}}}}},
            {{"id": "tone", "kind": "profile", "values": {{"offset": {offset},
                "falloff": {falloff}, "cutoff": {cutoff}}}}},
            {{"id": "output", "kind": "output"}}],
        "wires": [{{"from": "light", "to": "angle.light"}},
            {{"from": "angle", "to": "tone.angle"}},
            {{"from": "convexity", "to": "warp.convexity"}}, {{"from": "warp", "to": "tone.shift"}},
            {{"from": "tone", "to": "output.color"}}]}}"#
    );
    Look::read(&text, "look.json").value.unwrap()
}

fn snapshot(look: Look, mesh: &str) -> RenderSnapshot {
    let orbit = Orbit {
        yaw: 0.5,
        pitch: 0.3,
        illumination: DQuat::from_rotation_x(0.4) * DQuat::from_rotation_y(0.9),
        mesh: mesh.to_owned(),
        ..Orbit::default()
    };
    RenderSnapshot {
        look: Arc::new(look),
        source: Arc::new(Look::read("{}", "look.json").source),
        folder: PathBuf::new(),
        library: Arc::new(Library::built_in().clone()),
        orbit,
        time: 0.0,
        by_camera: false,
        display: None,
        scene: None,
        painting: None,
        assets: AssetStore::default(),
    }
}

/// Numbers of a node at a pixel, in f64.
fn read(snapshot: &RenderSnapshot, pixel: [u32; 2], node: &str) -> Vec<f64> {
    let mut planner = CachedPlanner::new(Planner::for_truth);
    let planner = planner.of(&snapshot.look, &snapshot.library);
    let setup = snapshot.setup(&mut planner.assets).unwrap().value;
    let options = PlanOptions { size: SIZE, samples: 1, time: 0.0 };
    let plan = planner.plan(&setup, &snapshot.library, &Live::All, &options).unwrap().value;
    let reference = ReferenceOptions::default();
    let wires = probe_wires(&plan, pixel, &reference, &Progress::new()).unwrap().unwrap();
    let mut of_node = wires.iter().rev().filter(|wire| wire.node.to_string() == node);
    of_node.next().unwrap_or_else(|| panic!("{node}: {wires:?}")).double.clone()
}

fn task(light: &Light, wanted: WantedMark) -> PlacingTask {
    PlacingTask::Place(Box::new(light.clone()), wanted)
}

fn ask(
    planner: &mut CachedPlanner,
    snapshot: &RenderSnapshot,
    pixel: [u32; 2],
    task: PlacingTask,
) -> Result<SurfaceAnswer, String> {
    let (snapshot, progress) = (snapshot.clone(), Progress::new());
    let request = PlacingRequest { number: 1, pixel, size: SIZE, snapshot, task, progress };
    let PlacingAnswer { found, .. } = place(planner, &request);
    found
}

/// The snapshot with its light placed.
fn placed(
    planner: &mut CachedPlanner,
    old: &RenderSnapshot,
    pixel: [u32; 2],
    wanted: WantedMark,
) -> RenderSnapshot {
    let light = &old.look.lights["key"];
    let Ok(SurfaceAnswer::Placed(placed)) = ask(planner, old, pixel, task(light, wanted)) else {
        panic!("it can be placed");
    };
    assert_ne!(placed.light, *light);
    let mut look = (*old.look).clone();
    look.lights["key"] = placed.light;
    RenderSnapshot { look: Arc::new(look), ..old.clone() }
}

#[test]
fn the_probe_reads_what_a_light_was_placed_for() {
    let spaces = ["illumination", "world", "camera", "object"];
    let all = [
        ("diffuse", Parametrization::Diffuse),
        ("specular", Parametrization::Specular),
        ("screen_aligned", Parametrization::ScreenAligned),
        ("half_vector", Parametrization::HalfVector),
    ];
    let mut planner = CachedPlanner::new(Planner::for_truth);
    for (index, kind) in ["directional", "point", "spot"].into_iter().enumerate() {
        for (number, (word, parametrization)) in all.into_iter().enumerate() {
            let space = spaces[(index + number) % spaces.len()];
            let pixel = [58 + 4 * number as u32, 33 + 5 * index as u32];
            let old = snapshot(look(kind, space, word), "shape:sphere");
            let middle = WantedMark::Angle { parametrization, angle: 0.0, warp: None };
            let new = placed(&mut planner, &old, pixel, middle);
            let angle = read(&new, pixel, "angle");
            let u = 2.0 * angle[0].atan2(angle[1]);
            assert!(u < 1e-4, "{kind} {word} {space}: {u}");
            let angle = terminator_angle(SHAPE[0], SHAPE[1], SHAPE[2]).unwrap();
            let edge = WantedMark::Angle { parametrization, angle, warp: Some(WARP) };
            let new = placed(&mut planner, &old, pixel, edge);
            let tone = read(&new, pixel, "tone");
            assert!((tone[0] - 0.5).abs() < 1e-4, "{kind} {word} {space}: {tone:?}");
            assert!(read(&new, pixel, "warp")[0].abs() > 0.01, "the warp counts");
        }
    }
}

#[test]
fn beside_the_object_nothing_is_placed() {
    let mut planner = CachedPlanner::new(Planner::for_truth);
    let beside = snapshot(look("directional", "world", "diffuse"), "shape:sphere");
    let light = &beside.look.lights["key"];
    let wanted =
        WantedMark::Angle { parametrization: Parametrization::Diffuse, angle: 0.0, warp: None };
    let told = ask(&mut planner, &beside, [1, 1], task(light, wanted)).err();
    assert_eq!(told.as_deref(), Some("Nothing is there: click on the model"));
    // A warp may leave no light for a place.
    let far = WantedMark::Angle {
        parametrization: Parametrization::Diffuse,
        angle: 3.1,
        warp: Some((5.0, 1.0)),
    };
    let told = ask(&mut planner, &beside, [60, 45], task(light, far)).err();
    assert!(told.unwrap().starts_with("Curvature moves that place"));
}

/// A light that is aimed at an object is placed by the place of that object.
#[test]
fn the_surface_comes_with_the_places_that_lights_are_aimed_at() {
    let mut aimed = look("directional", "world", "diffuse");
    aimed.lights["key"].aimed_at = Some("object".into());
    let snapshot = snapshot(aimed, "shape:sphere");
    let mut planner = CachedPlanner::new(Planner::for_truth);
    let place = ([60, 45], SIZE);
    let read = read_surface(&mut planner, &snapshot, place, false, &Progress::new()).unwrap();
    let frames = read.expect("a surface").frames;
    assert!(frames.aims["object"].length() < 1e-6, "the middle of the sphere: {frames:?}");
}
