//! Lights in the frame of the object that they light: they go along with it, for it alone.
#![cfg(feature = "gpu")]

use crate::support::eval::{look, renderer, scene_of, shape, told};
use crate::support::wait::block_on;
use chiaro::compile::{Live, Stage};
use chiaro::document::{Camera, LightFrames, LightSpace, LightValues, ObjectFrame, Scene};
use chiaro::frame::{Draw, PlanOptions, Planner, Setup, SetupLook, SetupObject};
use chiaro::library::Library;
use glam::{DMat3, DMat4, DQuat, DVec3};
use serde_json::json;

/// A look lit by a sun, a lamp and a spot in a space.
fn lit(space: &str) -> SetupLook {
    look(&json!({"name": space,
        "lights": {
            "sun": {"direction": [-1, 0.5, 1], "color": [0.9, 0.5, 0.2], "space": space},
            "lamp": {"type": "point", "position": [1.5, 0.5, 1], "half_distance": 1,
                "color": [0.2, 0.5, 0.9], "space": space},
            "spot": {"type": "spot", "position": [0, 2, 1.5], "aim": [0, -2, -1.5], "inner": 0.2,
                "outer": 0.3, "color": [0.5, 0.9, 0.5], "space": space}},
        "definitions": {"lamps": {
            "outputs": [{"name": "color"}],
            "nodes": [
                {"id": "lamp", "kind": "light"}, {"id": "parts", "kind": "light_parts"},
                {"id": "angle", "kind": "parametrization"}, {"id": "tone", "kind": "profile"},
                {"id": "strong", "kind": "multiply"}, {"id": "lit", "kind": "multiply"},
                {"id": "join", "kind": "sum_of_lights"}],
            "wires": [
                {"from": "lamp", "to": "angle.light"}, {"from": "angle", "to": "tone.angle"},
                {"from": "lamp", "to": "parts.light"}, {"from": "parts.color", "to": "strong.a"},
                {"from": "parts.intensity", "to": "strong.b"}, {"from": "strong", "to": "lit.a"},
                {"from": "tone", "to": "lit.b"}, {"from": "lit", "to": "join.value"},
                {"from": "join", "to": "outputs.color"}]}},
        "nodes": [{"id": "each", "kind": "lamps", "for_each": "*"},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "each", "to": "output.color"}]}))
}

/// A picture of an object at a place, with a camera that went along with it.
fn picture(space: &str, placement: DMat4) -> Vec<[f32; 4]> {
    let (mesh, fitted) = shape("creature");
    let seen = |place: DVec3| placement.transform_point3(place).to_array();
    let camera = Camera {
        eye: seen(DVec3::new(0.5, 0.5, 4.0)),
        target: seen(DVec3::ZERO),
        ..Camera::default()
    };
    let scene = Scene { backdrop: None, camera, ..Scene::default() };
    let setup = scene_of(vec![(lit(space), mesh, placement * fitted)], scene);
    let options = PlanOptions { size: [96, 96], samples: 1, time: 0.0 };
    let plan = Planner::default()
        .plan(&setup, Library::built_in(), &Live::Keyed, &options)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)))
        .value;
    block_on(renderer().picture(&plan)).unwrap_or_else(|error| panic!("{error}")).rgba
}

#[test]
fn lights_of_an_object_go_along_with_it() {
    let placement =
        DMat4::from_rotation_translation(DQuat::from_rotation_y(2.0), DVec3::new(3.0, -1.0, 2.0));
    let difference = |space: &str| {
        let [still, moved] = [DMat4::IDENTITY, placement].map(|at| picture(space, at));
        let lit = still.iter().filter(|pixel| pixel[..3].iter().any(|x| *x > 0.2)).count();
        assert!(lit > 800, "{lit} pixels are lit");
        let far =
            |(a, b): (&[f32; 4], &[f32; 4])| a.iter().zip(b).any(|(a, b)| (a - b).abs() > 0.02);
        still.iter().zip(&moved).filter(|pair| far(*pair)).count()
    };
    // At outlines a rounding decides which triangle a pixel sees.
    let of_object = difference("object");
    assert!(of_object < 40, "{of_object} pixels differ");
    assert!(difference("world") > 800);
}

/// The look's uniform on each object, in the order of the scene.
fn uniforms(setup: &Setup) -> Vec<Vec<f64>> {
    let options = PlanOptions { size: [96, 96], samples: 1, time: 0.0 };
    let plan = Planner::default()
        .plan(setup, Library::built_in(), &Live::Keyed, &options)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)))
        .value;
    // Draws stand in the order in which they are drawn.
    let draw_of = |object: &SetupObject| plan.draws.iter().find(|draw| draw.object == object.id);
    let numbers = |draw: &Draw| draw.look_uniforms[&Stage::default()].numbers.clone();
    setup.objects.iter().filter_map(draw_of).map(numbers).collect()
}

/// Objects that wear one look have its lights each for itself, be they the look's or the scene's.
#[test]
fn each_object_has_its_own_lights() {
    let places = [DVec3::new(-1.0, 0.0, 0.0), DVec3::new(1.0, 0.5, -1.0)];
    let pair = |space: &str| {
        let (mesh, fitted) = shape("creature");
        let worn =
            |place: DVec3| (lit(space), mesh.clone(), DMat4::from_translation(place) * fitted);
        let mut setup = scene_of(places.map(worn).into(), Scene::default());
        // Both wear the first look.
        setup.objects[1].looks = setup.objects[0].looks.clone();
        setup.looks.truncate(1);
        setup
    };
    let of_look = uniforms(&pair("object"));
    assert_eq!(of_look.len(), 2);
    assert_ne!(of_look[0], of_look[1]);
    let mut alone = pair("object");
    alone.objects.remove(0);
    assert_eq!(uniforms(&alone), [of_look[1].clone()]);
    let mut of_scene = pair("world");
    assert_eq!(uniforms(&of_scene)[0], uniforms(&of_scene)[1]);
    of_scene.scene.lights = lit("object").look.lights;
    assert_eq!(uniforms(&of_scene), of_look);
}

#[test]
fn the_frame_of_an_object_is_turned_and_not_scaled() {
    let turn = DQuat::from_euler(glam::EulerRot::YXZ, 0.5, -0.75, 0.25);
    let matrix =
        DMat4::from_scale_rotation_translation(DVec3::new(2.0, 0.5, 3.0), turn, DVec3::ONE);
    let center = DVec3::new(4.0, 5.0, 6.0);
    let mut light = lit("object").look.lights["lamp"].clone();
    assert_eq!(light.space, LightSpace::Object);
    light.position = [1.0, 2.0, 3.0];
    let frames = LightFrames { object: ObjectFrame::new(center, matrix), ..Default::default() };
    let found = LightValues::new(&light, &frames);
    let wanted = center + turn * DVec3::new(1.0, 2.0, 3.0);
    assert!((found.position() - wanted).length() < 1e-12, "{} for {wanted}", found.position());
    assert!((found.own_from_world * DMat3::from_quat(turn)).abs_diff_eq(DMat3::IDENTITY, 1e-12));
    // A mirrored object has its lights on the same side; one without size keeps the world's axes.
    let mirrored = ObjectFrame::new(center, DMat4::from_scale(DVec3::new(1.0, 1.0, -1.0)));
    assert!(mirrored.turn.abs_diff_eq(DQuat::IDENTITY, 1e-12));
    assert_eq!(ObjectFrame::new(center, DMat4::from_scale(DVec3::ZERO)).turn, DQuat::IDENTITY);
}
