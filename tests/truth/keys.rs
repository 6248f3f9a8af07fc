//! Directional control (BADF eq. 9) and keys over time, through `eval`.
#![cfg(feature = "gpu")]

use crate::support;
use crate::support::wait::block_on;
use std::io::Write as _;
use std::process::{Command, Stdio};

use crate::support::eval::{draw, eval, look, scene_of, shape};
use crate::support::random::Random;
use crate::support::report::Errors;
use chiaro::compile::Live;
use chiaro::directions::KeyWeights;
use chiaro::document::{KeyScheme, Scene, Value};
use chiaro::frame::{EvalSample, LightOverride, SetupLook};
use chiaro::library::Library;
use glam::{DMat3, DVec3};
use serde_json::{Value as Json, json};

const SCHEMES: [(&str, KeyScheme); 3] = [
    ("biharmonic", KeyScheme::Biharmonic),
    ("appendix-b", KeyScheme::AppendixB),
    ("tessellated", KeyScheme::Tessellated),
];

/// A look of a number and a color with keys at directions.
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
    [("key".into(), LightOverride { direction: Some(direction), ..LightOverride::default() })]
        .into_iter()
        .collect()
}

/// Numbers and colors hold their values at keys of the view (world space) and of a light (screen
/// space), and blend between them by weight.
#[test]
fn keys_hold_their_values_and_blend_by_weight() {
    for (word, scheme) in SCHEMES {
        for by_view in [true, false] {
            let mut random = Random::new(60);
            let places = places(&mut random, 5);
            let numbers: Vec<f64> = (0..5).map(|_| random.between(-2.0, 2.0)).collect();
            let colors: Vec<DVec3> =
                (0..5).map(|_| DVec3::from_array([(); 3].map(|()| random.unit()))).collect();
            let keys: Vec<Json> = (0..5)
                .map(|k| {
                    json!({
                        "direction": places[k].to_array(),
                        "values": {"number.value": numbers[k], "paint.color": colors[k].to_array()}
                    })
                })
                .collect();
            let by = if by_view { json!("view") } else { json!({"light": "key"}) };
            let look = keyed(&by, word, &keys);
            let directions: Vec<DVec3> =
                places.iter().copied().chain((0..100).map(|_| random.direction())).collect();
            let samples: Vec<EvalSample> = directions
                .iter()
                .map(|&direction| {
                    let (frame, camera) = (random.rotation(), DMat3::from_quat(random.rotation()));
                    if by_view {
                        EvalSample { view: 3.0 * direction, frame, camera, ..EvalSample::default() }
                    } else {
                        // The key lies in camera axes; the light is set in the illumination frame.
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
            let weights = KeyWeights::new(&places, scheme).value;
            let title = format!("{word} keys by {}", if by_view { "view" } else { "light" });
            let mut at_keys = Errors::new(format!("{title}: at the keys"), 1e-6);
            let mut between = Errors::new(format!("{title}: between them"), 1e-6);
            let got_numbers = eval(&look, "number.value", &samples);
            let got_colors = eval(&look, "paint.color", &samples);
            for (index, direction) in directions.iter().enumerate() {
                let w = weights.weights(*direction);
                assert!(
                    (w.iter().sum::<f64>() - 1.0).abs() < 1e-9
                        && w.iter().all(|w| (0.0..=1.0).contains(w)),
                    "{w:?}"
                );
                let number: f64 = w.iter().zip(&numbers).map(|(w, x)| w * x).sum();
                let color: DVec3 = w.iter().zip(&colors).map(|(w, c)| *w * *c).sum();
                let got_color = DVec3::from_slice(&got_colors[index][..3]);
                if index < 5 {
                    at_keys.note(got_numbers[index][0], numbers[index], || format!("key {index}"));
                    at_keys.note((got_color - colors[index]).abs().max_element(), 0.0, || {
                        format!("key {index}")
                    });
                }
                between.note(got_numbers[index][0], number, || format!("{direction}"));
                between
                    .note((got_color - color).abs().max_element(), 0.0, || format!("{direction}"));
            }
            at_keys.finish();
            between.finish();
        }
    }
}

/// Every key sets offset, fall-off and cut-off in any order; blended, they are in order everywhere.
#[test]
fn blended_profiles_stay_in_order() {
    let mut random = Random::new(61);
    let places = places(&mut random, 4);
    let triples: Vec<[f64; 3]> =
        (0..4).map(|_| [(); 3].map(|()| random.between(-0.5, 3.5))).collect();
    let keys: Vec<Json> = places
        .iter()
        .zip(&triples)
        .map(|(place, [offset, falloff, cutoff])| {
            json!({
                "direction": place.to_array(),
                "values": {"tone.offset": offset, "tone.falloff": falloff, "tone.cutoff": cutoff}
            })
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
    let weights = KeyWeights::new(&places, KeyScheme::Biharmonic).value;
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
        let sanitized: Vec<[f64; 3]> =
            triples.iter().map(|triple| support::badf::sanitized(*triple)).collect();
        let blended = [0, 1, 2]
            .map(|i| w.iter().zip(&sanitized).map(|(w, triple)| w * triple[i]).sum::<f64>());
        let [tau, f, c] = blended;
        assert!(tau <= f + 1e-12 && f <= c + 1e-12);
        // Narrow profiles multiply the rounding of u.
        if f - tau > 0.05 {
            let u = support::badf::angle(sample.normal, DVec3::Z);
            errors.note(value[0], support::badf::alpha(u, 0.0, blended), || {
                format!("{blended:?} at {u}")
            });
        }
    }
    errors.finish();
}

#[test]
fn keyed_light_directions_are_unit_sums() {
    let mut random = Random::new(62);
    let places = places(&mut random, 4);
    let targets: Vec<DVec3> =
        (0..4).map(|_| random.direction() * random.between(0.1, 5.0)).collect();
    let keys: Vec<Json> = places
        .iter()
        .zip(&targets)
        .map(|(place, target)| {
            json!({
                "direction": place.to_array(),
                "values": {
                    "lights.key.direction": target.to_array(),
                    "lights.key.intensity": target.length()
                }
            })
        })
        .collect();
    let look = keyed(&json!("view"), "biharmonic", &keys);
    let weights = KeyWeights::new(&places, KeyScheme::Biharmonic).value;
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
    let samples: Vec<EvalSample> =
        times.iter().map(|&time| EvalSample { time, ..EvalSample::default() }).collect();
    eval(look, output, &samples).iter().map(|value| value[0]).collect()
}

#[test]
fn keys_over_time() {
    let times: Vec<f64> = (0..60).map(|i| 0.1 * f64::from(i) - 1.0).collect();
    let ease = |t: f64| t * t * (3.0 - 2.0 * t);
    for (word, between) in [
        ("linear", (|t| t) as fn(f64) -> f64),
        ("smooth", ease as fn(f64) -> f64),
        ("stepped", |_| 0.0),
        // Automatic handles are flat at ends and turning points, as eased keys are.
        ("bezier", ease),
    ] {
        let key =
            |time: f64, value: f64| json!({"time": time, "value": value, "interpolation": word});
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
        &json!([
            {"time": 0, "value": "add"}, {"time": 1, "value": "multiply"},
            {"time": 2, "value": "subtract"}
        ]),
    );
    let values = at_times(&look, "", &[-1.0, 0.0, 0.999, 1.0, 1.5, 2.0, 99.0]);
    let wanted = [0.5, 0.5, 0.5, 0.0625, 0.0625, 0.0, 0.0];
    assert!(values.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-6), "{values:?}");
}

/// Exposed values reach the shader, be they numbers or words, through the binary and in scenes.
#[test]
fn exposed_values_are_heard() {
    let look_json = json!({
        "exposed": [
            {"name": "amount", "target": "blend.tone"}, {"name": "mode", "target": "blend.mode"}
        ],
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
    let samples = json!([
        {}, {"values": {"amount": 1.0}}, {"values": {"amount": 1.0, "mode": "multiply"}},
        {"values": {"mode": "subtract"}}
    ]);
    let mut child = Command::new(env!("CARGO_BIN_EXE_chiaro"))
        .args(["eval", path.to_str().expect("a path"), "--at", "-"])
        .env("CHIARO_CACHE_DIR", "")
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
    assert!(
        reds.iter().zip([0.5, 0.75, 0.125, 0.0]).all(|(a, b)| (a - b).abs() < 1e-6),
        "{reds:?}"
    );

    let (mesh, matrix) = shape("sphere");
    let mut setup = scene_of(vec![(look(&look_json), mesh, matrix)], Scene::default());
    for (live, amount, wanted) in
        [(Live::Keyed, 1.0, 0.75), (Live::Keyed, 0.25, 0.375), (Live::All, 0.5, 0.5)]
    {
        setup.objects[0].values = [("amount".into(), Value::Number(amount))].into_iter().collect();
        let middle = draw(&setup, Library::built_in(), &live, [32, 32], 1).pixel(16, 16);
        assert!((middle[0] - wanted).abs() < 1e-3, "{middle:?} for {wanted}");
    }
}

/// A look of a number with keys by drivers.
fn driven(drivers: &Json, keys: &[(&[f64], f64)]) -> SetupLook {
    let keys: Vec<Json> =
        keys.iter().map(|(at, x)| json!({"at": at, "values": {"number.value": x}})).collect();
    look(&json!({
        "lights": {"key": {"direction": [0, 0, 1]}},
        "nodes": [
            {"id": "number", "kind": "number", "values": {"value": 0.25}},
            {"id": "output", "kind": "output"}
        ],
        "wires": [{"from": "number", "to": "output.color"}],
        "direction_keys": [{"name": "Keys", "by": {"drivers": drivers}, "keys": keys}]
    }))
}

/// Along one driver values follow a smoothstep from key to key, and hold beyond the last key.
#[test]
fn one_driver_goes_from_key_to_key() {
    let keys: [(&[f64], f64); 4] = [(&[3.0], 2.0), (&[1.0], -1.0), (&[10.0], 0.5), (&[4.0], 8.0)];
    let mut sorted: Vec<(f64, f64)> = keys.iter().map(|(at, value)| (at[0], *value)).collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    let wanted = |x: f64| {
        let next = sorted.partition_point(|key| key.0 <= x);
        let Some(before) = next.checked_sub(1) else { return sorted[0].1 };
        let Some((to, after)) = sorted.get(next) else { return sorted[before].1 };
        let t = (x - sorted[before].0) / (to - sorted[before].0);
        let t = t * t * (3.0 - 2.0 * t);
        (1.0 - t) * sorted[before].1 + t * after
    };
    let distances: Vec<f64> = (0..120).map(|k| 0.1 * f64::from(k)).collect();
    let sample = |&distance: &f64| EvalSample { distance, ..EvalSample::default() };
    let samples: Vec<EvalSample> = distances.iter().map(sample).collect();
    let mut errors = Errors::new("keys by distance", 1e-5);
    for (got, distance) in
        eval(&driven(&json!(["distance"]), &keys), "", &samples).iter().zip(&distances)
    {
        errors.note(got[0], wanted(*distance), || format!("{distance}"));
    }
    errors.finish();
}

/// Each driver has the value that the document defines, and values hold at keys of two and three
/// drivers.
#[test]
fn keys_of_several_drivers_hold_their_values() {
    let mut random = Random::new(66);
    let drivers = json!([{"height": "key"}, "facing", {"near": "friend"}]);
    for axes in 1..=3 {
        let places: Vec<Vec<f64>> = (0..7)
            .map(|_| {
                [random.between(-1.4, 1.4), random.between(0.1, 3.0), random.between(0.5, 9.0)]
                    [..axes]
                    .to_vec()
            })
            .collect();
        let values: Vec<f64> = (0..7).map(|_| random.between(-3.0, 3.0)).collect();
        let keys: Vec<(&[f64], f64)> =
            places.iter().zip(&values).map(|(at, x)| (at.as_slice(), *x)).collect();
        let look = driven(&json!(drivers.as_array().expect("drivers")[..axes]), &keys);
        let samples: Vec<EvalSample> = places
            .iter()
            .map(|place| {
                let (height, facing) = (place[0], place.get(1).copied().unwrap_or(0.0));
                let view = random.direction();
                let aside = view.any_orthonormal_vector();
                EvalSample {
                    lights: toward(DVec3::new(
                        0.6 * height.cos(),
                        height.sin(),
                        -0.8 * height.cos(),
                    )),
                    view,
                    front: 3.0 * (facing.cos() * view + facing.sin() * aside),
                    near: [("friend".into(), place.get(2).copied().unwrap_or(1.0))]
                        .into_iter()
                        .collect(),
                    ..EvalSample::default()
                }
            })
            .collect();
        for (got, value) in eval(&look, "", &samples).iter().zip(&values) {
            assert!(
                (got[0] - value).abs() < 1e-4,
                "{axes} drivers: {} in place of {value}",
                got[0]
            );
        }
    }
}

/// Weights between keys of drivers lie in [0, 1], sum to 1, have no jumps or kinks, and do not
/// depend on the axes' units.
#[test]
fn weights_between_drivers_are_smooth_and_know_no_units() {
    let mut random = Random::new(67);
    for axes in 1..=3 {
        let mut place = || {
            let mut place = [0.0; 3];
            place[..axes].iter_mut().for_each(|x| *x = random.between(-2.0, 2.0));
            DVec3::from_array(place)
        };
        let mut places: Vec<DVec3> = Vec::new();
        while places.len() < 5 {
            let place = place();
            if places.iter().all(|other| other.distance(place) > 0.5) {
                places.push(place);
            }
        }
        let units = DVec3::new(1000.0, 0.02, 7.0);
        let (weights, problems) = KeyWeights::at_places(&places).into_parts();
        assert!(problems.is_empty(), "{problems:?}");
        let scaled =
            KeyWeights::at_places(&places.iter().map(|place| *place * units).collect::<Vec<_>>())
                .value;
        for _ in 0..40 {
            let (from, to) = (2.0 * place(), 2.0 * place());
            let rows: Vec<Vec<f64>> =
                (0..=200).map(|k| weights.weights(from.lerp(to, f64::from(k) / 200.0))).collect();
            for row in &rows {
                assert!(row.iter().all(|w| (-1e-9..=1.0 + 1e-9).contains(w)), "{row:?}");
                assert!((row.iter().sum::<f64>() - 1.0).abs() < 1e-9);
            }
            for (a, b) in rows.iter().zip(&rows[1..]) {
                assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 0.3), "no jumps");
            }
            let at = from.lerp(to, 0.37);
            let other = scaled.weights(at * units);
            assert!(weights.weights(at).iter().zip(&other).all(|(a, b)| (a - b).abs() < 1e-9));
        }
        for (key, place) in places.iter().enumerate() {
            assert!((weights.weights(*place)[key] - 1.0).abs() < 1e-9);
        }
    }
    // Two keys in one place share a weight, a single key has all weight, and a NaN favors no key.
    let (shared, problems) = KeyWeights::at_places(&[DVec3::X, DVec3::X, DVec3::Y]).into_parts();
    assert!(problems.iter().any(|problem| problem.code == "merged-keys"));
    assert_eq!(shared.weights(DVec3::X), [0.5, 0.5, 0.0]);
    assert_eq!(KeyWeights::at_places(&[DVec3::X]).value.weights(DVec3::ZERO), [1.0]);
    assert_eq!(shared.weights(DVec3::NAN), [0.25, 0.25, 0.5]);
}

/// Drivers of a scene are each object's own distance, front and neighbors; an object that does not
/// exist is told of.
#[test]
fn every_object_is_driven_by_its_own_place() {
    let (mesh, matrix) = shape("sphere");
    let moved = |x: f64| glam::DMat4::from_translation(DVec3::new(x, 0.0, 0.0)) * matrix;
    let pictured = |drivers: Json, keys: &[(&[f64], f64)]| {
        let look = || driven(&drivers, keys);
        let scene = Scene { backdrop: None, ..Scene::default() };
        let setup = scene_of(
            vec![(look(), mesh.clone(), moved(-3.0)), (look(), mesh.clone(), moved(3.0))],
            scene,
        );
        let mut planner = chiaro::frame::Planner::default();
        let options = chiaro::frame::PlanOptions { size: [96, 48], samples: 1, time: 0.0 };
        let (plan, warnings) = planner
            .plan(&setup, Library::built_in(), &Live::Keyed, &options)
            .expect("it is planned")
            .into_parts();
        let picture = block_on(support::eval::renderer().picture(&plan)).expect("it is drawn");
        let mut seen: Vec<f32> = picture.rgba.iter().filter(|p| p[3] > 0.5).map(|p| p[0]).collect();
        seen.sort_by(f32::total_cmp);
        seen.dedup_by(|a, b| (*a - *b).abs() < 1e-3);
        (seen, warnings)
    };
    // The objects are 6 apart, and an object is no neighbor of itself.
    let (seen, warnings) =
        pictured(json!([{"near": "object_0"}]), &[(&[6.0], 0.25), (&[7.0], 0.75)]);
    assert_eq!(seen, [0.25, 0.75], "the neighbor, and what is far from any");
    assert!(warnings.iter().any(|problem| problem.code == "unknown-object"), "{warnings:?}");
    let (_, warnings) = pictured(json!([{"near": "nobody"}]), &[(&[6.0], 0.25)]);
    assert!(
        warnings.iter().any(|p| p.message.contains("nobody") && p.hints[0].contains("object_1")),
        "{warnings:?}"
    );
    // Both objects face forward as they were made.
    let (seen, warnings) = pictured(json!(["facing"]), &[(&[0.0], 0.25), (&[3.0], 0.75)]);
    assert!(warnings.is_empty() && seen.len() <= 2, "{seen:?} {warnings:?}");
}

/// Drivers are read and written, and wrong drivers are told of.
#[test]
fn drivers_are_read_written_and_checked() {
    use chiaro::document::Look;
    let text = |by: &str, key: &str| {
        format!(
            r#"{{"chiaro": "look", "version": 1, "lights": {{"key": {{}}}},
                "nodes": [{{"id": "number", "kind": "number"}}],
            "direction_keys": [{{"by": {by}, "keys": [{{{key},
            "values": {{"number.value": 1}}}}]}}]}}"#
        )
    };
    let json = |text: &str| serde_json::from_str::<Json>(text).expect("JSON");
    for (by, key) in [
        (r#"{ "drivers": ["distance"] }"#, r#""at": [2.5]"#),
        (
            r#"{ "drivers": ["facing", { "height": "key" }, { "near": "tree" }] }"#,
            r#""at": [0, -0.5, 3]"#,
        ),
    ] {
        let loaded = Look::read(&text(by, key), "keys.json");
        assert!(loaded.diagnostics.is_empty(), "{:?}", loaded.diagnostics);
        let mut look = loaded.value.expect("a look");
        look.direction_keys[0].name = "Named".to_owned();
        let mut wanted = json(&text(by, key));
        wanted["direction_keys"][0]["name"] = "Named".into();
        assert_eq!(json(&look.to_text()), wanted);
    }
    for (by, key, code) in [
        (r#"{ "drivers": [] }"#, r#""at": []"#, "wrong-count"),
        (
            r#"{ "drivers": ["distance", "facing", { "near": "a" }, { "near": "b" }] }"#,
            r#""at": [1]"#,
            "wrong-count",
        ),
        (r#"{ "drivers": ["speed"] }"#, r#""at": [1]"#, "wrong-type"),
        (r#"{ "drivers": ["distance"] }"#, r#""at": [1, 2]"#, "wrong-count"),
        (r#"{ "drivers": ["distance"] }"#, r#""direction": [1, 0, 0]"#, "missing-field"),
        (r#""view""#, r#""at": [1]"#, "missing-field"),
        (r#"{ "drivers": [{ "height": "sun" }] }"#, r#""at": [1]"#, "unknown-light"),
    ] {
        let loaded = Look::read(&text(by, key), "keys.json");
        assert!(
            loaded.diagnostics.iter().any(|problem| problem.code == code),
            "{by} {key}: {:?}",
            loaded.diagnostics
        );
    }
}
