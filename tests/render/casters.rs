//! Casters of shadows: they exist while a live node asks, and are made anew only where they moved.
#![cfg(feature = "gpu")]

use std::collections::HashMap;
use std::sync::Arc;

use crate::support::eval::{look, renderer, scene_of, shape, told};
use crate::support::wait::block_on;
use chiaro::compile::Live;
use chiaro::document::Scene;
use chiaro::frame::{EffectKind, FramePlan, PlanOptions, Planner, Setup, SetupLook, effects};
use chiaro::library::Library;
use glam::{DMat4, DVec3};
use serde_json::json;

/// A look of which a share is the light's shadow.
fn shaded(share: f64) -> SetupLook {
    look(&json!({"name": "Shaded", "lights": {"key": {"direction": [0.5, 1, 0.5]}},
        "nodes": [{"id": "shadow", "kind": "shadow", "values": {"light": "key"}},
            {"id": "paint", "kind": "color_value"},
            {"id": "mix", "kind": "mix_colors", "values": {"factor": share}},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "paint", "to": "mix.a"}, {"from": "shadow.cast", "to": "mix.b"},
            {"from": "mix", "to": "output.color"}]}))
}

fn pair(share: f64, moved: f64) -> Setup {
    let part = |at: DVec3| {
        let (mesh, fitted) = shape("torus");
        (shaded(share), mesh, DMat4::from_translation(at) * fitted)
    };
    let mut setup = scene_of(
        vec![part(DVec3::ZERO), part(DVec3::new(0.6, 1.0 + moved, 0.6))],
        Scene::default(),
    );
    // Both are one mesh.
    setup.objects[1].mesh = setup.objects[0].mesh.clone();
    setup
}

fn planned(planner: &mut Planner, setup: &Setup) -> FramePlan {
    let options = PlanOptions { size: [64, 64], samples: 1, time: 0.0 };
    planner
        .plan(setup, Library::built_in(), &Live::Keyed, &options)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)))
        .value
}

#[test]
fn casters_exist_while_a_live_node_asks() {
    let mut planner = Planner::default();
    let plan = planned(&mut planner, &pair(0.0, 0.0));
    assert!(plan.casters.is_none(), "the share of the shadow is 0");
    assert!(!plan.draws[0].look.wgsl.contains("casters"));
    let plan = planned(&mut planner, &pair(0.5, 0.0));
    let casters = plan.casters.as_ref().expect("casters");
    assert_eq!(casters.trees().len(), 1, "a mesh has one tree, however often it stands there");
    // What else the node would give is not computed.
    assert!(!plan.draws[0].look.wgsl.contains("fn facet_at"));
    let all = effects(&plan, &HashMap::new());
    let effect = all.iter().find(|effect| effect.kind == EffectKind::Casters).expect("an effect");
    let bytes = casters.size().map(u64::from).iter().product::<u64>() * 16;
    assert_eq!(effect.cost.bytes, bytes);
    assert!(effect.reason.contains("wears Shaded, which sends rays past"), "{}", effect.reason);
}

#[test]
fn casters_are_made_anew_where_objects_move() {
    let mut planner = Planner::default();
    let setup = pair(0.5, 0.0);
    let still = planned(&mut planner, &setup);
    let mut seen = setup.clone();
    seen.scene.camera.eye = [1.0, 1.0, 4.0];
    let turned = planned(&mut planner, &seen);
    let mut elsewhere = setup.clone();
    elsewhere.objects[1].world_from_object = pair(0.5, 0.25).objects[1].world_from_object;
    let moved = planned(&mut planner, &elsewhere);
    let [a, b, c] = [&still, &turned, &moved].map(|plan| plan.casters.clone().expect("casters"));
    assert_eq!(a.hash(), b.hash(), "the camera casts no shadow");
    assert_ne!(a.hash(), c.hash());
    assert!(Arc::ptr_eq(&a.trees()[0], &c.trees()[0]));
    assert_ne!(still.passes[0].input_hash, moved.passes[0].input_hash);
    // The renderer writes what moved, and draws as if it had never seen anything else.
    let mut renderer = renderer();
    let mut picture =
        |plan: &FramePlan| block_on(renderer.picture(plan)).unwrap_or_else(|e| panic!("{e}")).rgba;
    let (first, second, again) = (picture(&still), picture(&moved), picture(&still));
    assert!(first == again, "the picture came back");
    assert!(first != second, "the shadow moved");
    assert!(block_on(renderer.draw(&still)).is_ok_and(|ran| ran.is_empty()));
}

/// An export has no scene to send rays past: it is refused, and the nodes are named.
#[test]
fn an_export_refuses_looks_that_send_rays() {
    let export = |share: f64| {
        let languages = &chiaro::export::LANGUAGES;
        let assets = (std::path::Path::new(""), &mut chiaro::frame::Assets::default());
        chiaro::export::export(&shaded(share).look, Library::built_in(), "a", languages, assets)
    };
    let problems = export(0.5).expect_err("it sends rays");
    let told: Vec<_> = problems
        .iter()
        .map(|problem| (problem.code, problem.place.node.as_ref().map(ToString::to_string)))
        .collect();
    assert_eq!(told[0], ("export-casters", Some("shadow/others".to_owned())), "{problems:?}");
    let cheaper = ["balanced", "balanced", "fast"];
    for (problem, tier) in problems.iter().zip(cheaper) {
        let hint = problem.hints.first().map(String::as_str).unwrap_or_default();
        assert!(hint.contains(&format!("--tier {tier}")), "{problem:?}");
    }
    assert!(export(0.0).is_ok(), "what is not seen sends none");
}
