//! Keys of the lights of scenes: every field, by every driver.
#![cfg(feature = "gpu")]

use crate::support::eval::{look, scene_of, shape, told};
use chiaro::compile::{Live, Stage};
use chiaro::document::{Camera, LightField, LightQuantity, Scene, SceneEdit};
use chiaro::frame::{PlanOptions, Planner, Setup, SetupLook};
use chiaro::ids::LightId;
use chiaro::library::Library;
use glam::{DMat4, DQuat, DVec3};
use serde_json::{Value as Json, json};

/// A look that draws what arrives of a sun and of a spot, of which it keys one.
fn lit(keys: &Json) -> SetupLook {
    let mut written = json!({"name": "lit",
        "lights": {"sun": {"space": "world"}, "spot": {"type": "spot", "space": "world"}},
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
        "nodes": [{"id": "each", "kind": "lamps", "for_each": "sun | spot"},
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "each", "to": "output.color"}]});
    if keys.is_array() {
        written["time_keys"] = keys.clone();
    }
    look(&written)
}

/// The scene that a text says, read without any diagnostic.
fn scene(written: Json) -> Scene {
    let mut written = written;
    written["lights"]["sun"]["space"] = json!("world");
    written["lights"]["spot"]["type"] = json!("spot");
    written["lights"]["spot"]["space"] = json!("world");
    let loaded = Scene::read(&written.to_string(), "scene.json");
    let problems: Vec<String> = loaded.diagnostics.iter().map(ToString::to_string).collect();
    assert!(problems.is_empty(), "{}\n{written}", problems.join("\n"));
    loaded.value.expect("a scene")
}

/// Places of the objects of [`setup`].
const PLACES: [DVec3; 2] = [DVec3::ZERO, DVec3::new(2.0, 0.0, 1.0)];

fn turns() -> [DQuat; 2] {
    [DQuat::IDENTITY, DQuat::from_rotation_y(2.0)]
}

const EYE: DVec3 = DVec3::new(1.0, 0.5, 6.0);

fn setup(scene: Scene, keys: &Json) -> Setup {
    let (mesh, fitted) = shape("sphere");
    let part = |(place, turn)| {
        let placed = DMat4::from_scale_rotation_translation(DVec3::splat(0.5), turn, place);
        (lit(keys), mesh.clone(), placed * fitted)
    };
    let camera = Camera { eye: EYE.to_array(), target: [1.0, 0.0, 0.0], ..Camera::default() };
    let scene = Scene { camera, ..scene };
    let mut setup = scene_of(PLACES.into_iter().zip(turns()).map(part).collect(), scene);
    // Both wear the first look.
    setup.objects[1].looks = setup.objects[0].looks.clone();
    setup.looks.truncate(1);
    setup
}

/// Uniforms of each object at a time.
fn uniforms(setup: &Setup, time: f64) -> Vec<Vec<f64>> {
    let options = PlanOptions { size: [96, 96], samples: 1, time };
    let plan = Planner::default()
        .plan(setup, Library::built_in(), &Live::All, &options)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)))
        .value;
    let of = |id: &str| {
        let draw = plan.draws.iter().find(|draw| draw.object.as_str() == id).expect("a draw");
        draw.look_uniforms[&Stage::default()].numbers.clone()
    };
    vec![of("object_0"), of("object_1")]
}

fn assert_near(found: &[f64], wanted: &[f64], what: &str) {
    assert_eq!(found.len(), wanted.len(), "{what}");
    for (a, b) in found.iter().zip(wanted) {
        assert!((a - b).abs() < 1e-9, "{what}:\n{found:?}\n{wanted:?}");
    }
}

/// Two values of a field that lie apart, and the one that lies in the middle.
fn values(field: LightField) -> [Vec<f64>; 3] {
    let [a, b] = match field.quantity() {
        LightQuantity::Direction => [vec![1.0, 0.0, 0.0], vec![0.0, 0.0, 1.0]],
        LightQuantity::Position | LightQuantity::Color => {
            [vec![0.25, 0.75, 0.5], vec![1.0, 0.5, 0.0]]
        }
        // Of cones the inner one lies in the outer one.
        _ if field == LightField::Outer => [vec![0.5], vec![1.0]],
        _ => [vec![0.125], vec![0.375]],
    };
    let mut middle: Vec<f64> = a.iter().zip(&b).map(|(a, b)| 0.5 * (a + b)).collect();
    if field.quantity() == LightQuantity::Direction {
        middle = DVec3::from_slice(&middle).normalize().to_array().to_vec();
    }
    [a, b, middle]
}

fn written(numbers: &[f64]) -> Json {
    if let [number] = numbers { json!(number) } else { json!(numbers) }
}

/// Scene of a light with a field as it is given.
fn with_field(light: &str, field: LightField, numbers: &[f64]) -> Scene {
    scene(json!({"chiaro": "scene", "lights": {light: {field.name(): written(numbers)}}}))
}

/// A way in which keys are decided, and places of two keys of which an object sees itself half way.
struct DriverCase {
    by: Json,
    /// Name of the field that holds the places.
    at: &'static str,
    places: [Json; 2],
    /// The object for which the two weigh the same.
    object: usize,
}

/// A case for each thing that decides: drivers between two places around the object's own value,
/// directions at the same angle from it.
fn cases() -> Vec<DriverCase> {
    let center = PLACES[1];
    let view = (EYE - center).normalize();
    let front = turns()[1] * DVec3::Z;
    let around = |x: f64| [json!([x - 0.5]), json!([x + 0.5])];
    let driver = |by: Json, x: f64| DriverCase {
        by: json!({"drivers": [by]}),
        at: "at",
        places: around(x),
        object: 1,
    };
    // Two directions at 0.5 on either side of the one that decides.
    let beside = |toward: DVec3| {
        let across = toward.any_orthonormal_vector();
        [-0.5_f64, 0.5].map(|x| json!((toward * x.cos() + across * x.sin()).to_array()))
    };
    let eye_axes = {
        let back = (EYE - DVec3::new(1.0, 0.0, 0.0)).normalize();
        let right = DVec3::Y.cross(back).normalize();
        [right, back.cross(right), back]
    };
    let sun = DVec3::new(0.5, 0.75, 1.0).normalize();
    vec![
        driver(json!("distance"), EYE.distance(center)),
        driver(json!("facing"), front.angle_between(view)),
        driver(json!({"height": "mark"}), sun.y.asin()),
        driver(json!({"near": "object_0"}), PLACES[0].distance(center)),
        DriverCase { by: json!("view"), at: "direction", places: beside(view), object: 1 },
        DriverCase {
            by: json!({"light": "mark"}),
            at: "direction",
            places: beside(DVec3::from_array(eye_axes.map(|axis| axis.dot(sun)))),
            object: 0,
        },
    ]
}

#[test]
fn every_field_of_a_light_is_keyed_by_every_driver() {
    for field in LightField::ALL {
        let light = if field == LightField::Direction { "sun" } else { "spot" };
        let [a, b, middle] = values(field);
        let wanted = uniforms(&setup(with_field(light, field, &middle), &json!(null)), 0.0);
        let target = format!("lights.{light}.{}", field.name());
        for DriverCase { by, at, places: [p, q], object } in cases() {
            let what = format!("{} by {by}", field.name());
            let key = |place: &Json, numbers: &[f64]| {
                let values = json!({&target: written(numbers)});
                json!({at: place, "values": values})
            };
            let keyed = scene(json!({"chiaro": "scene",
                "lights": {light: {}, "mark": {"space": "world", "direction": [0.5, 0.75, 1]}},
                "direction_keys": [{"by": by, "keys": [key(&p, &a), key(&q, &b)]}]}));
            let found = uniforms(&setup(keyed, &json!(null)), 0.0);
            assert_near(&found[object], &wanted[object], &what);
        }
        let keyed = scene(json!({"chiaro": "scene", "lights": {light: {}}, "time_keys": [
            {"target": target, "keys": [
                {"time": 1, "value": written(&a)}, {"time": 3, "value": written(&b)}]}]}));
        let found = uniforms(&setup(keyed, &json!(null)), 2.0);
        for object in 0..2 {
            assert_near(&found[object], &wanted[object], &format!("{} by time", field.name()));
        }
    }
}

/// At its own place a key holds its value; beyond the last key that one's holds.
#[test]
fn keys_hold_where_they_are() {
    let of = |places: [f64; 2]| {
        let keyed = scene(json!({"chiaro": "scene", "lights": {"sun": {}},
            "direction_keys": [{"by": {"drivers": ["distance"]}, "keys": [
                {"at": [places[0]], "values": {"lights.sun.intensity": 0.25}},
                {"at": [places[1]], "values": {"lights.sun.intensity": 0.75}}]}]}));
        uniforms(&setup(keyed, &json!(null)), 0.0)
    };
    let given = |intensity: f64| {
        let given = with_field("sun", LightField::Intensity, &[intensity]);
        uniforms(&setup(given, &json!(null)), 0.0)
    };
    let [here, there] = PLACES.map(|place| EYE.distance(place));
    let found = of([here, there]);
    assert_near(&found[0], &given(0.25)[0], "at the first key");
    assert_near(&found[1], &given(0.75)[1], "at the second key");
    let found = of([here.min(there) - 2.0, here.min(there) - 1.0]);
    assert_near(&found[0], &given(0.75)[0], "beyond the last key");
    // A quarter of the way a smoothstep has 5/32 of it.
    let found = of([here - 1.0, here + 3.0]);
    assert_near(&found[0], &given(0.25 + 0.5 * 5.0 / 32.0)[0], "a quarter of the way");
}

/// The scene owns its lights: its keys stand over those that a look has for lights of the same id.
#[test]
fn keys_of_the_scene_stand_over_those_of_looks() {
    let own = json!([{"target": "lights.sun.intensity", "keys": [{"time": 0, "value": 0.5}]}]);
    let plain = scene(json!({"chiaro": "scene", "lights": {"sun": {"intensity": 0.125}}}));
    let keyed = scene(json!({"chiaro": "scene", "lights": {"sun": {"intensity": 0.125}},
        "time_keys": [{"target": "lights.sun.intensity", "keys": [{"time": 0, "value": 0.25}]}]}));
    let given = |intensity: f64| {
        let given = with_field("sun", LightField::Intensity, &[intensity]);
        uniforms(&setup(given, &json!(null)), 0.0)
    };
    assert_near(&uniforms(&setup(plain, &own), 0.0)[0], &given(0.5)[0], "keys of the look");
    assert_near(&uniforms(&setup(keyed, &own), 0.0)[0], &given(0.25)[0], "keys of the scene");
}

/// A light that is off in the document and keyed to shine is not left out.
#[test]
fn a_light_that_keys_turn_on_is_not_dark() {
    let keyed = scene(json!({"chiaro": "scene", "lights": {"sun": {"intensity": 0}},
        "time_keys": [{"target": "lights.sun.intensity", "keys": [{"time": 0, "value": 1}]}]}));
    let options = PlanOptions { size: [96, 96], samples: 1, time: 0.0 };
    let setup = setup(keyed, &json!(null));
    let plan = Planner::default().plan(&setup, Library::built_in(), &Live::Keyed, &options);
    let plan = plan.unwrap_or_else(|problems| panic!("{}", told(&problems))).value;
    let sun = LightId::from("sun");
    assert!(plan.draws.iter().all(|draw| draw.look.host.lights().any(|id| *id == sun)));
}

#[test]
fn keys_of_a_scene_that_move_no_light_are_told() {
    let problems = |keys: Json| {
        let written = json!({"chiaro": "scene", "lights": {"key": {}}, "time_keys": keys["time"],
            "direction_keys": keys["directions"]});
        let told = Scene::read(&written.to_string(), "").diagnostics;
        told.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
    };
    let timed = |target: &str| {
        problems(json!({"directions": [],
            "time": [{"target": target, "keys": [{"time": 0, "value": 1}]}]}))
    };
    assert!(timed("lights.kez.intensity").contains("did you mean `key`?"));
    assert!(timed("lights.key.intensty").contains("did you mean `intensity`?"));
    let of_node = timed("rim.offset");
    assert!(of_node.contains("error[bad-target]: a scene has no nodes"), "{of_node}");
    let by_wire = problems(json!({"time": [], "directions": [
        {"by": {"drivers": [{"wire": "rim.alpha"}]}, "keys": []}]}));
    assert!(by_wire.contains("error[bad-target]: a scene has no nodes"), "{by_wire}");
}

/// A light goes with its keys, and comes back with them.
#[test]
fn a_light_is_removed_with_its_keys() {
    let key = json!({"at": [1], "values": {"lights.sun.intensity": 1, "lights.spot.outer": 1}});
    let before = scene(json!({"chiaro": "scene", "lights": {"sun": {}, "spot": {}},
        "direction_keys": [
            {"by": {"drivers": ["distance"]}, "keys": [key]},
            {"by": {"light": "sun"}, "keys": []}],
        "time_keys": [{"target": "lights.sun.color",
            "keys": [{"time": 0, "value": [1, 0, 0]}]}]}));
    let mut after = before.clone();
    let undo = after.apply(SceneEdit::RemoveLight { id: "sun".into() }).unwrap();
    assert!(after.check().is_empty(), "{:?}", after.check());
    assert_eq!((after.direction_keys.len(), after.time_keys.len()), (1, 0));
    assert_eq!(after.direction_keys[0].keys[0].values.len(), 1);
    after.apply(undo).unwrap();
    assert_eq!(after, before);
}
