//! Directional control (BADF eq. 9) and keys over time, through `eval`.
#![cfg(feature = "gpu")]

mod support;

use std::io::Write as _;
use std::process::{Command, Stdio};

use chiaro::compile::Live;
use chiaro::directions::KeyWeights;
use chiaro::document::{KeyScheme, Scene, Value};
use chiaro::frame::{EvalSample, LightOverride, SetupLook};
use chiaro::library::Library;
use glam::{DMat3, DVec3};
use serde_json::{Value as Json, json};
use support::eval::{draw, eval, look, scene_of, shape};
use support::random::Random;
use support::report::Errors;

const SCHEMES: [(&str, KeyScheme); 3] = [
    ("biharmonic", KeyScheme::Biharmonic),
    ("appendix-b", KeyScheme::AppendixB),
    ("tessellated", KeyScheme::Tessellated),
];

/// A number and a colour with keys at directions.
fn keyed(by: &Json, scheme: &str, keys: &[Json]) -> SetupLook {
    look(&json!({
        "lights": {"key": {"direction": [0, 0, 1]}},
        "nodes": [
            {"id": "number", "kind": "number", "values": {"value": 0.25}},
            {"id": "paint", "kind": "color_value", "values": {"color": [0.1, 0.2, 0.3]}},
            {"id": "light", "kind": "light", "values": {"light": "key"}},
            {"id": "parts", "kind": "light_parts"},
            {"id": "mixed", "kind": "multiply"},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "light", "to": "parts.light"},
            {"from": "paint", "to": "mixed.a"},
            {"from": "parts.intensity", "to": "mixed.b"},
            {"from": "mixed", "to": "output.color"}
        ],
        "direction_keys": [{"name": "Keys", "by": by, "scheme": scheme, "keys": keys}]
    }))
}

fn places(random: &mut Random, count: usize) -> Vec<DVec3> {
    let mut places: Vec<DVec3> = Vec::new();
    while places.len() < count {
        let place = random.direction();
        if places.iter().all(|other| other.angle_between(place) > 0.3) {
            places.push(place);
        }
    }
    places
}

fn toward(direction: DVec3) -> indexmap::IndexMap<chiaro::ids::LightId, LightOverride> {
    [("key".into(), LightOverride { direction: Some(direction), ..LightOverride::default() })].into_iter().collect()
}

/// Numbers and colours between keys of the view (world space) and of a light (screen space).
#[test]
fn keys_hold_their_values_and_blend_by_weight() {
    for (word, scheme) in SCHEMES {
        for by_view in [true, false] {
            let mut random = Random::new(60);
            let places = places(&mut random, 5);
            let numbers: Vec<f64> = (0..5).map(|_| random.between(-2.0, 2.0)).collect();
            let colors: Vec<DVec3> = (0..5).map(|_| DVec3::from_array([(); 3].map(|()| random.unit()))).collect();
            let keys: Vec<Json> = (0..5)
                .map(|k| json!({"direction": places[k].to_array(), "values": {"number.value": numbers[k], "paint.color": colors[k].to_array()}}))
                .collect();
            let by = if by_view { json!("view") } else { json!({"light": "key"}) };
            let look = keyed(&by, word, &keys);
            let directions: Vec<DVec3> = places.iter().copied().chain((0..100).map(|_| random.direction())).collect();
            let samples: Vec<EvalSample> = directions
                .iter()
                .map(|&direction| {
                    let (frame, camera) = (random.rotation(), DMat3::from_quat(random.rotation()));
                    if by_view {
                        EvalSample { view: 3.0 * direction, frame, camera, ..EvalSample::default() }
                    } else {
                        // The key lies in camera axes; the light is told in the illumination frame.
                        let own = frame.inverse() * (camera.transpose() * direction);
                        EvalSample {
                            lights: toward(own),
                            frame,
                            camera,
                            view: random.direction(),
                            ..EvalSample::default()
                        }
                    }
                })
                .collect();
            let (weights, _) = KeyWeights::new(&places, scheme);
            let title = format!("{word} keys by {}", if by_view { "view" } else { "light" });
            let mut at_keys = Errors::new(format!("{title}: at the keys"), 1e-6);
            let mut between = Errors::new(format!("{title}: between them"), 1e-6);
            let got_numbers = eval(&look, "number.value", &samples);
            let got_colors = eval(&look, "paint.color", &samples);
            for (index, direction) in directions.iter().enumerate() {
                let w = weights.weights(*direction);
                assert!(
                    (w.iter().sum::<f64>() - 1.0).abs() < 1e-9 && w.iter().all(|w| (0.0..=1.0).contains(w)),
                    "{w:?}"
                );
                let number: f64 = w.iter().zip(&numbers).map(|(w, x)| w * x).sum();
                let color: DVec3 = w.iter().zip(&colors).map(|(w, c)| *w * *c).sum();
                let got_color = DVec3::from_slice(&got_colors[index][..3]);
                if index < 5 {
                    at_keys.note(got_numbers[index][0], numbers[index], || format!("key {index}"));
                    at_keys.note((got_color - colors[index]).abs().max_element(), 0.0, || format!("key {index}"));
                }
                between.note(got_numbers[index][0], number, || format!("{direction}"));
                between.note((got_color - color).abs().max_element(), 0.0, || format!("{direction}"));
            }
            at_keys.finish();
            between.finish();
        }
    }
}

/// Every key sets offset, fall-off and cut-off in an order of its own; what is blended is in order everywhere.
#[test]
fn blended_profiles_stay_in_order() {
    let mut random = Random::new(61);
    let places = places(&mut random, 4);
    let triples: Vec<[f64; 3]> = (0..4).map(|_| [(); 3].map(|()| random.between(-0.5, 3.5))).collect();
    let keys: Vec<Json> = places
        .iter()
        .zip(&triples)
        .map(|(place, [offset, falloff, cutoff])| {
            json!({"direction": place.to_array(), "values": {"tone.offset": offset, "tone.falloff": falloff, "tone.cutoff": cutoff}})
        })
        .collect();
    let look = look(&json!({
        "lights": {"key": {"direction": [0, 0, 1]}},
        "nodes": [
            {"id": "light", "kind": "light", "values": {"light": "key"}},
            {"id": "angle", "kind": "parametrization"},
            {"id": "tone", "kind": "profile"},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "light", "to": "angle.light"},
            {"from": "angle", "to": "tone.angle"},
            {"from": "tone", "to": "output.color"}
        ],
        "direction_keys": [{"name": "Keys", "by": "view", "keys": keys}]
    }));
    let (weights, _) = KeyWeights::new(&places, KeyScheme::Biharmonic);
    let mut errors = Errors::new("blended profiles", 2e-5);
    let samples: Vec<EvalSample> = (0..600)
        .map(|_| EvalSample {
            view: random.direction(),
            normal: support::badf::held(random.direction()),
            ..EvalSample::default()
        })
        .collect();
    for (value, sample) in eval(&look, "tone.tone", &samples).iter().zip(&samples) {
        let w = weights.weights(sample.view);
        let sanitised: Vec<[f64; 3]> = triples.iter().map(|triple| support::badf::sanitised(*triple)).collect();
        let blended = [0, 1, 2].map(|i| w.iter().zip(&sanitised).map(|(w, triple)| w * triple[i]).sum::<f64>());
        let [tau, f, c] = blended;
        assert!(tau <= f + 1e-12 && f <= c + 1e-12);
        // Narrow profiles multiply the rounding of u.
        if f - tau > 0.05 {
            let u = support::badf::angle(sample.normal, DVec3::Z);
            errors.note(value[0], support::badf::alpha(u, 0.0, blended), || format!("{blended:?} at {u}"));
        }
    }
    errors.finish();
}

#[test]
fn keyed_light_directions_are_unit_sums() {
    let mut random = Random::new(62);
    let places = places(&mut random, 4);
    let targets: Vec<DVec3> = (0..4).map(|_| random.direction() * random.between(0.1, 5.0)).collect();
    let keys: Vec<Json> = places
        .iter()
        .zip(&targets)
        .map(|(place, target)| json!({"direction": place.to_array(), "values": {"lights.key.direction": target.to_array(), "lights.key.intensity": target.length()}}))
        .collect();
    let look = keyed(&json!("view"), "biharmonic", &keys);
    let (weights, _) = KeyWeights::new(&places, KeyScheme::Biharmonic);
    let samples: Vec<EvalSample> = places
        .iter()
        .copied()
        .chain((0..200).map(|_| random.direction()))
        .map(|view| EvalSample { view, ..EvalSample::default() })
        .collect();
    let mut errors = Errors::new("keyed light directions and intensities", 1e-6);
    let directions = eval(&look, "parts.direction", &samples);
    let intensities = eval(&look, "parts.intensity", &samples);
    for (index, sample) in samples.iter().enumerate() {
        let w = weights.weights(sample.view);
        let wanted: DVec3 = w.iter().zip(&targets).map(|(w, target)| *w * target.normalize()).sum();
        for (got, wanted) in directions[index].iter().zip(wanted.normalize().to_array()) {
            errors.note(*got, wanted, || format!("{}", sample.view));
        }
        let intensity: f64 = w.iter().zip(&targets).map(|(w, target)| w * target.length()).sum();
        errors.note(intensities[index][0], intensity, || format!("{}", sample.view));
    }
    errors.finish();
}

fn timed(target: &str, keys: &Json) -> SetupLook {
    look(&json!({
        "lights": {"key": {"direction": [0, 0, 1]}},
        "nodes": [
            {"id": "number", "kind": "number", "values": {"value": 5}},
            {"id": "base", "kind": "base", "values": {"color": [0.25, 0.25, 0.25, 1]}},
            {"id": "blend", "kind": "blend", "values": {"color": [0.5, 0.5, 0.5, 1], "tone": 0.5}},
            {"id": "output", "kind": "output"}
        ],
        "wires": [{"from": "base", "to": "blend.below"}, {"from": "blend", "to": "output.color"}],
        "time_keys": [{"target": target, "keys": keys}]
    }))
}

fn at_times(look: &SetupLook, output: &str, times: &[f64]) -> Vec<f64> {
    let samples: Vec<EvalSample> = times.iter().map(|&time| EvalSample { time, ..EvalSample::default() }).collect();
    eval(look, output, &samples).iter().map(|value| value[0]).collect()
}

#[test]
fn keys_over_time() {
    let times: Vec<f64> = (0..60).map(|i| 0.1 * f64::from(i) - 1.0).collect();
    let ease = |t: f64| t * t * (3.0 - 2.0 * t);
    for (word, between) in
        [("linear", (|t| t) as fn(f64) -> f64), ("smooth", ease as fn(f64) -> f64), ("stepped", |_| 0.0)]
    {
        let key = |time: f64, value: f64| json!({"time": time, "value": value, "interpolation": word});
        let look = timed("number.value", &json!([key(0.0, 1.0), key(2.0, -3.0), key(3.0, 8.0)]));
        let mut errors = Errors::new(format!("keys over time, {word}"), 1e-6);
        for (got, time) in at_times(&look, "number.value", &times).into_iter().zip(&times) {
            let wanted = match *time {
                t if t < 0.0 => 1.0,
                t if t < 2.0 => 1.0 - 4.0 * between(t / 2.0),
                t if t < 3.0 => -3.0 + 11.0 * between(t - 2.0),
                _ => 8.0,
            };
            errors.note(got, wanted, || format!("{time}"));
        }
        errors.finish();
    }
}

#[test]
fn words_step_in_time() {
    let look = timed(
        "blend.mode",
        &json!([{"time": 0, "value": "add"}, {"time": 1, "value": "multiply"}, {"time": 2, "value": "subtract"}]),
    );
    let values = at_times(&look, "", &[-1.0, 0.0, 0.999, 1.0, 1.5, 2.0, 99.0]);
    let wanted = [0.5, 0.5, 0.5, 0.0625, 0.0625, 0.0, 0.0];
    assert!(values.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-6), "{values:?}");
}

/// Exposed values reach the shader whether they are numbers or words, through the binary and in scenes.
#[test]
fn exposed_values_are_heard() {
    let look_json = json!({
        "exposed": [{"name": "amount", "target": "blend.tone"}, {"name": "mode", "target": "blend.mode"}],
        "nodes": [
            {"id": "base", "kind": "base", "values": {"color": [0.25, 0.25, 0.25, 1]}},
            {"id": "blend", "kind": "blend", "values": {"color": [0.5, 0.5, 0.5, 1], "tone": 0.5}},
            {"id": "output", "kind": "output"}
        ],
        "wires": [{"from": "base", "to": "blend.below"}, {"from": "blend", "to": "output.color"}]
    });
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("look.json");
    std::fs::write(&path, look_json.to_string()).expect("written");
    let samples = json!([{}, {"values": {"amount": 1.0}}, {"values": {"amount": 1.0, "mode": "multiply"}}, {"values": {"mode": "subtract"}}]);
    let mut child = Command::new(env!("CARGO_BIN_EXE_chiaro"))
        .args(["eval", path.to_str().expect("a path"), "--at", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::inherit())
        .spawn()
        .expect("chiaro runs");
    child.stdin.take().expect("its input").write_all(samples.to_string().as_bytes()).expect("read");
    let output = child.wait_with_output().expect("it ends");
    let answers: Vec<Json> = serde_json::from_slice(&output.stdout).expect("JSON");
    let reds: Vec<f64> = answers.iter().filter_map(|answer| answer["value"][0].as_f64()).collect();
    assert_eq!(reds.len(), 4, "{answers:?}");
    assert!(reds.iter().zip([0.5, 0.75, 0.125, 0.0]).all(|(a, b)| (a - b).abs() < 1e-6), "{reds:?}");

    let (mesh, matrix) = shape("sphere");
    let mut setup = scene_of(vec![(look(&look_json), mesh, matrix)], Scene::default());
    for (live, amount, wanted) in [(Live::Keyed, 1.0, 0.75), (Live::Keyed, 0.25, 0.375), (Live::All, 0.5, 0.5)] {
        setup.objects[0].values = [("amount".into(), Value::Number(amount))].into_iter().collect();
        let middle = draw(&setup, Library::built_in(), &live, [32, 32], 1).pixel(16, 16);
        assert!((middle[0] - wanted).abs() < 1e-3, "{middle:?} for {wanted}");
    }
}
