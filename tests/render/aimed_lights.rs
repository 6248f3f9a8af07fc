//! Lights that are aimed at objects: they shine from where they are at the middle of the object,
//! wherever either goes.
#![cfg(feature = "gpu")]

use crate::support::eval::{look, scene_of, shape, told};
use chiaro::compile::{Live, Stage};
use chiaro::document::{Light, Scene, Transform};
use chiaro::frame::{FramePlan, PlanOptions, Planner, Setup, SetupLook};
use chiaro::library::Library;
use glam::{DMat4, DQuat, DVec3};
use serde_json::{Value as Json, json};

/// A look that draws what arrives of a light.
fn lit(name: &str, light: &Json) -> SetupLook {
    look(&json!({"name": name, "lights": {"key": light},
        "nodes": [
            {"id": "lamp", "kind": "light"}, {"id": "parts", "kind": "light_parts"},
            {"id": "angle", "kind": "parametrization"}, {"id": "tone", "kind": "profile"},
            {"id": "strong", "kind": "multiply"}, {"id": "lit", "kind": "multiply"},
            {"id": "output", "kind": "output"}],
        "wires": [
            {"from": "lamp", "to": "angle.light"}, {"from": "angle", "to": "tone.angle"},
            {"from": "lamp", "to": "parts.light"}, {"from": "parts.color", "to": "strong.a"},
            {"from": "parts.intensity", "to": "strong.b"}, {"from": "strong", "to": "lit.a"},
            {"from": "tone", "to": "lit.b"}, {"from": "lit", "to": "output.color"}]}))
}

/// Two objects at these places, turned, each in a look of its own.
fn pair(light: &Json, places: [DVec3; 2]) -> Setup {
    let (mesh, fitted) = shape("torus");
    let turn = DQuat::from_rotation_x(0.75);
    let part = |(name, place)| {
        let placed = DMat4::from_scale_rotation_translation(DVec3::splat(0.5), turn, place);
        (lit(name, light), mesh.clone(), placed * fitted)
    };
    scene_of(["first", "second"].into_iter().zip(places).map(part).collect(), Scene::default())
}

fn plan(setup: &Setup) -> FramePlan {
    let options = PlanOptions { size: [96, 96], samples: 1, time: 0.0 };
    Planner::default()
        .plan(setup, Library::built_in(), &Live::Keyed, &options)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)))
        .value
}

/// Uniforms of the look on both objects.
fn uniforms(setup: &Setup) -> Vec<f64> {
    let plan = plan(setup);
    let mut numbers = Vec::new();
    for object in &setup.objects {
        let draw = plan.draws.iter().find(|draw| draw.object == object.id).expect("a draw");
        numbers.extend(&draw.look_uniforms[&Stage::default()].numbers);
    }
    numbers
}

fn assert_near(found: &[f64], wanted: &[f64]) {
    assert!(found.len() == wanted.len() && found.len() >= 3, "{found:?}\n{wanted:?}");
    for (a, b) in found.iter().zip(wanted) {
        assert!((a - b).abs() < 1e-12, "{found:?}\n{wanted:?}");
    }
}

#[test]
fn a_light_follows_the_object_that_it_is_aimed_at() {
    let from = DVec3::new(-2.0, 3.0, 1.0);
    for at in [DVec3::new(1.0, 0.5, -0.5), DVec3::new(-0.75, -1.0, 0.25)] {
        let places = [DVec3::ZERO, at];
        let toward = (at - from) / (at - from).length();
        let given = |light: Json| uniforms(&pair(&light, places));
        let sun = json!({"position": from.to_array(), "direction": [0, 1, 0], "space": "world",
            "aimed_at": "object_1"});
        let by_hand = json!({"direction": (-toward).to_array(), "space": "world"});
        assert_near(&given(sun), &given(by_hand));
        let spot = |aim: Json, more: Json| {
            let mut light = json!({"type": "spot", "position": from.to_array(), "aim": aim,
                "outer": 1.5, "space": "world"});
            light.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
            light
        };
        let aimed = spot(json!([0, 0, 1]), json!({"aimed_at": "object_1"}));
        assert_near(&given(aimed), &given(spot(json!(toward.to_array()), json!({}))));
    }
}

/// The place that a light shines from is in the light's own space; the object's is not.
#[test]
fn a_light_that_goes_along_is_aimed_from_where_it_is() {
    let places = [DVec3::new(-0.5, 0.0, 0.0), DVec3::new(0.75, 0.25, 0.0)];
    let aimed = json!({"position": [0, 2, 0], "space": "object", "aimed_at": "object_1"});
    let found = uniforms(&pair(&aimed, places));
    let turn = DQuat::from_rotation_x(0.75);
    let directions = places.map(|place| {
        let from = place + turn * DVec3::new(0.0, 2.0, 0.0);
        (from - places[1]).normalize()
    });
    // The first numbers are the direction in world space.
    for (numbers, toward) in found.chunks(found.len() / 2).zip(directions) {
        assert_near(&numbers[..3], &toward.to_array());
    }
}

/// A cone that is aimed elsewhere leaves dark what lies outside of it, and nothing else.
#[test]
fn cones_are_proved_dark_by_where_they_are_aimed() {
    let places = [DVec3::new(-1.2, 0.0, 0.0), DVec3::new(1.2, 0.0, 0.0)];
    let narrow = |id: &str| {
        json!({"type": "spot", "position": [0, 3, 0], "aim": [0, 1, 0], "inner": 0.05,
            "outer": 0.1, "space": "world", "aimed_at": id})
    };
    for (id, other) in [("object_0", "second"), ("object_1", "first")] {
        let plan = plan(&pair(&narrow(id), places));
        let dark = plan.dropped.iter().filter(|one| one.why.contains("outside of its cone"));
        let looks: Vec<_> = dark.filter_map(|one| one.look.as_deref()).collect();
        assert_eq!(looks, [other], "{id}");
    }
}

#[test]
fn an_object_that_is_hidden_may_be_aimed_at_and_a_missing_one_is_told_of() {
    let places = [DVec3::ZERO, DVec3::X];
    let mut setup = pair(&json!({"direction": [0, 0, 1], "space": "world"}), places);
    let light = |id: &str| Light {
        position: [1.0, 4.0, 0.0],
        space: chiaro::document::LightSpace::World,
        aimed_at: Some(id.into()),
        direction: [1.0, 0.0, 0.0],
        ..Light::default()
    };
    let transform = Transform { translate: [1.0, 1.0, 0.0], ..Transform::default() };
    let mark = chiaro::document::Object { visible: false, transform, ..Default::default() };
    setup.scene.objects.insert("mark".into(), mark);
    let with = |setup: &mut Setup, id: &str| {
        setup.scene.lights.insert("key".into(), light(id));
        uniforms(setup)
    };
    let by_hand = |direction: Json| {
        uniforms(&pair(&json!({"direction": direction, "space": "world"}), places))
    };
    assert_near(&with(&mut setup, "mark"), &by_hand(json!([0, 1, 0])));
    assert!(setup.light_warnings().is_empty());
    assert_near(&with(&mut setup, "marc"), &by_hand(json!([1, 0, 0])));
    let told: Vec<String> = setup.light_warnings().iter().map(ToString::to_string).collect();
    let message = "the light `key` is aimed at the object `marc`, which there is not";
    assert!(told.len() == 1 && told[0].contains(message), "{told:?}");
    assert!(told[0].contains("did you mean `mark`?"), "{told:?}");
}
