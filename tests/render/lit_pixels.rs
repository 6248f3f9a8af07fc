//! Accounts of the lights at a pixel: what arrives by formulas of its own, keys, and groups that
//! run for each light.
#![cfg(feature = "gpu")]

use std::collections::BTreeMap;

use crate::support::eval::{look, scene_of, shape, told};
use chiaro::compile::Live;
use chiaro::document::{Camera, LightSet, Scene};
use chiaro::frame::{Assets, FramePlan, PlanOptions, Planner, Setup, SetupLook};
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::reference::{
    LightAccount, ProbedSurface, ReferenceOptions, light_accounts, probe_surface, probe_wires,
    surface_setup,
};
use glam::{DMat4, DVec3};
use serde_json::{Value as Json, json};

const SIZE: [u32; 2] = [48; 2];
const PIXEL: [u32; 2] = [30, 21];

/// A look that joins the tones of lights of a set.
fn for_each(lights: &Json, set: &str) -> SetupLook {
    look(&json!({"lights": lights,
        "definitions": {"lamps": {
            "outputs": [{"name": "color"}],
            "nodes": [
                {"id": "lamp", "kind": "light"}, {"id": "angle", "kind": "parametrization"},
                {"id": "tone", "kind": "profile"}, {"id": "join", "kind": "sum_of_lights"}],
            "wires": [
                {"from": "lamp", "to": "angle.light"}, {"from": "angle", "to": "tone.angle"},
                {"from": "tone", "to": "join.value"}, {"from": "join", "to": "outputs.color"}]}},
        "nodes": [{"id": "each", "kind": "lamps", "for_each": set},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "each", "to": "output.color"}]}))
}

/// A wall that looks toward +z, a little to the right of the origin, seen from the front.
fn wall(look: SetupLook, scene: &Json) -> Setup {
    let loaded = Scene::read(&scene.to_string(), "scene.json");
    let problems: Vec<String> = loaded.diagnostics.iter().map(ToString::to_string).collect();
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    let scene = loaded.value.expect("a scene");
    let camera = Camera { eye: [0.0, 0.0, 3.0], ..Camera::default() };
    let (mesh, fitted) = shape("plane");
    let placed = DMat4::from_translation(DVec3::new(0.25, 0.0, 0.0)) * fitted;
    scene_of(vec![(look, mesh, placed)], Scene { camera, ..scene })
}

fn planned(planner: &mut Planner, setup: &Setup, time: f64) -> FramePlan {
    let options = PlanOptions { size: SIZE, samples: 1, time };
    let planned = planner.plan(setup, Library::built_in(), &Live::All, &options);
    planned.unwrap_or_else(|problems| panic!("{}", told(&problems))).value
}

/// Accounts of the lights at [`PIXEL`] at a time, by their ids, and the surface there.
fn accounts(setup: &Setup, time: f64) -> (BTreeMap<String, LightAccount>, ProbedSurface) {
    let mut planner = Planner::for_probes(Assets::default());
    let plan = planned(&mut planner, setup, time);
    let surfaces = planned(&mut planner, &surface_setup(setup, false), time);
    let surface = probe_surface(&surfaces, PIXEL, &Progress::new()).unwrap().expect("a surface");
    let options = ReferenceOptions::default();
    let wires = probe_wires(&plan, PIXEL, &options, &Progress::new()).unwrap().expect("wires");
    let library = Library::built_in();
    let found = light_accounts(setup, library, (&plan, time), &wires, &surface).unwrap();
    (found.into_iter().map(|one| (one.light.to_string(), one)).collect(), surface)
}

fn luminance([r, g, b]: [f64; 3]) -> f64 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// The formulas of docs/math.md 13, written anew.
#[test]
fn what_arrives_follows_the_distance_and_the_cone() {
    let color = [0.9, 0.4, 0.2];
    let (place, aim) = (DVec3::new(0.7, 0.5, 1.3), DVec3::new(-0.2, -0.3, -1.0));
    let (half, range, inner, outer) = (0.8_f64, 2.5_f64, 0.05_f64, 0.25_f64);
    let lamp = |kind: &str| {
        json!({"type": kind, "space": "world", "position": place.to_array(),
            "aim": aim.to_array(), "color": color, "intensity": 1.5, "half_distance": half,
            "range": range, "inner": inner, "outer": outer})
    };
    let lights = json!({"lamp": lamp("point"), "spot": lamp("spot"),
        "sun": {"space": "world", "direction": [0, 3, 4], "color": color}});
    let (found, surface) = accounts(&wall(for_each(&lights, "*"), &json!({})), 0.0);
    let toward = place - surface.point.position;
    let distance = toward.length();
    let faded = 1.0 / (1.0 + (distance / half).powi(2));
    let end = (1.0 - (distance / range).powi(4)).powi(2);
    let cosine = (-toward / distance).dot(aim.normalize());
    let along = (cosine - outer.cos()) / (inner.cos() - outer.cos());
    assert!(along > 0.2 && along < 0.9, "the pixel lies between the cones: {along}");
    let cone = along * along * (3.0 - 2.0 * along);
    let wanted = 1.5 * luminance(color) * faded * end;
    for (id, energy) in [("lamp", wanted), ("spot", wanted * cone), ("sun", luminance(color))] {
        let account = &found[id];
        assert!((account.energy - energy).abs() < 1e-9, "{id}: {account:?} for {energy}");
    }
    for id in ["lamp", "spot"] {
        assert!((found[id].distance.unwrap() - distance).abs() < 1e-9);
        assert!((found[id].facing - (toward.z / distance).acos()).abs() < 1e-6);
    }
    assert!((found["sun"].facing - 0.8_f64.acos()).abs() < 1e-6);
}

/// A group that runs for each light has a tone of each, and what joins them is nobody's.
#[test]
fn groups_that_run_for_each_light_are_told_apart() {
    // So many that the compiler makes a loop of them.
    let mut lights = serde_json::Map::new();
    for number in 0..40 {
        let (sine, cosine) = (0.3 * f64::from(number)).sin_cos();
        let place = [2.0 * sine, 1.5 * cosine, 1.0 + 0.02 * f64::from(number)];
        let light = match number {
            ..4 => json!({"direction": place, "space": "world"}),
            _ => json!({"type": "point", "position": place, "space": "world"}),
        };
        lights.insert(format!("light_{number}"), light);
    }
    let setup = wall(for_each(&Json::Object(lights.clone()), "* - light_7"), &json!({}));
    let loops = |mut planner: Planner| planned(&mut planner, &setup, 0.0).draws[0].look.loops.len();
    assert!(loops(Planner::for_truth(Assets::default())) > 0, "a loop without a probe");
    assert_eq!(loops(Planner::for_probes(Assets::default())), 0);
    let (found, _) = accounts(&setup, 0.0);
    assert_eq!(found.len(), 40);
    for number in [0, 1, 20, 39] {
        let id = format!("light_{number}");
        let of_each = &found[&id].readings;
        assert_eq!(of_each.len(), 1, "{id}: {of_each:?}");
        assert_eq!(of_each[0].node.to_string(), "each/tone");
        // The same layer that names this light alone.
        let alone = look(&json!({"lights": {&id: lights[&id]},
            "nodes": [{"id": "lamp", "kind": "light"}, {"id": "angle", "kind": "parametrization"},
                {"id": "tone", "kind": "profile"}, {"id": "output", "kind": "output"}],
            "wires": [{"from": "lamp", "to": "angle.light"}, {"from": "angle", "to": "tone.angle"},
                {"from": "tone", "to": "output.color"}]}));
        let (alone, _) = accounts(&wall(alone, &json!({})), 0.0);
        let wanted = alone[&id].readings[0].value;
        assert!(wanted > 0.0 && (of_each[0].value - wanted).abs() < 1e-9, "{id}: {of_each:?}");
    }
    assert!(found["light_7"].readings.is_empty() && found["light_7"].reaches);
}

/// A light that reaches the object, and not all of its nodes, says so.
#[test]
fn nodes_that_a_light_does_not_reach_are_told_with_their_rule() {
    let sun = json!({"space": "world", "direction": [0, 0, 1]});
    let mut worn = for_each(&json!({"key": sun, "rim": sun}), "*");
    worn.look.graph.nodes["each"].links.unlayered = LightSet::parse("rim").unwrap();
    let (found, _) = accounts(&wall(worn, &json!({})), 0.0);
    assert!(found["rim"].reaches && found["rim"].readings.is_empty());
    let wanted = format!("not each: `unlayered` (`rim`) has it; {}", found["key"].rule);
    assert_eq!(found["rim"].rule, wanted);
}

/// Keys of looks and of scenes, by time and by the object, move what arrives as they move what is
/// drawn, for lights that looks have, and for those that the scene alone has.
#[test]
fn keyed_lights_are_told_as_they_are_at_the_moment() {
    let mut worn = for_each(&json!({"key": {"space": "world", "direction": [0, 0, 1]}}), "key");
    let timed = look(&json!({"lights": {"key": {}}, "nodes": [{"id": "output", "kind": "output"}],
        "time_keys": [{"target": "lights.key.intensity",
            "keys": [{"time": 0, "value": 0.5}, {"time": 2, "value": 1.5}]}]}));
    worn.look.time_keys = timed.look.time_keys;
    // The eye is half way between the keys.
    let from_eye = DVec3::new(0.25, 0.0, -3.0).length();
    let scene = json!({"chiaro": "scene",
        "lights": {"rim": {"space": "world", "direction": [0, 0, 1]}, "spare": {}},
        "light_groups": {},
        "time_keys": [{"target": "lights.spare.direction",
            "keys": [{"time": 0, "value": [0, 0, 1]}, {"time": 2, "value": [0, 1, 0]}]}],
        "direction_keys": [{"by": {"drivers": ["distance"]}, "keys": [
            {"at": [from_eye - 1.0], "values": {"lights.rim.intensity": 0}},
            {"at": [from_eye + 1.0], "values": {"lights.rim.intensity": 8}}]}]});
    let setup = wall(worn, &scene);
    for time in [0.0, 1.0] {
        let (found, _) = accounts(&setup, time);
        let key = &found["key"];
        assert!((key.energy - (0.5 + 0.5 * time)).abs() < 1e-9, "{time}: {key:?}");
        let rim = &found["rim"];
        assert!((rim.energy - 4.0).abs() < 1e-9, "{time}: {rim:?}");
        let turned = 0.5 * time * std::f64::consts::FRAC_PI_2;
        assert!((found["spare"].facing - turned).abs() < 1e-6, "{time}: {:?}", found["spare"]);
    }
}
