//! Keys by wires of object rate, on the GPU and on the reference, against weights that are solved
//! here in f64.
#![cfg(feature = "gpu")]

use crate::support;
use crate::support::eval::{eval, eval_with, look, options, truth};
use crate::support::random::Random;
use crate::support::report::Errors;
use chiaro::compile::{CompileOptions, HostInputs, Live, check, compile};
use chiaro::diag::Diagnostic;
use chiaro::document::{Driver, Edit, GraphId, History, KeyDirection, Look, Value};
use chiaro::frame::{EvalSample, LightOverride, SetupLook};
use chiaro::ids::NodeId;
use chiaro::interp::{self, Precision};
use chiaro::library::Library;
use glam::DVec3;
use serde_json::{Value as Json, json};

/// A look of a number that is keyed by wires: `a` is exposed, `b` is the time plus 1, `c` the
/// light's direction, `d` the product of a and b.
fn wired(drivers: &Json, keys: &[(Vec<f64>, f64)]) -> Json {
    let keys: Vec<Json> =
        keys.iter().map(|(at, x)| json!({"at": at, "values": {"number.value": x}})).collect();
    json!({
        "lights": {"key": {"direction": [0, 0, 1]}},
        "nodes": [
            {"id": "number", "kind": "number", "values": {"value": 0.25}},
            {"id": "a", "kind": "number", "values": {"value": 0.5}},
            {"id": "time", "kind": "time"},
            {"id": "b", "kind": "add", "values": {"b": 1}},
            {"id": "light", "kind": "light", "values": {"light": "key"}},
            {"id": "parts", "kind": "light_parts"},
            {"id": "c", "kind": "separate_vector"},
            {"id": "d", "kind": "multiply"},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "number", "to": "output.color"},
            {"from": "time", "to": "b.a"},
            {"from": "light", "to": "parts.light"},
            {"from": "parts.direction", "to": "c.vector"},
            {"from": "a", "to": "d.a"},
            {"from": "b", "to": "d.b"}
        ],
        "exposed": [{"name": "amount", "target": "a.value"}],
        "direction_keys": [{"name": "Keys", "by": {"drivers": drivers}, "keys": keys}]
    })
}

fn sample(amount: f64, time: f64, light: DVec3) -> EvalSample {
    let lights =
        [("key".into(), LightOverride { direction: Some(light), ..LightOverride::default() })];
    EvalSample {
        time,
        values: [("amount".into(), Value::Number(amount))].into_iter().collect(),
        lights: lights.into_iter().collect(),
        ..EvalSample::default()
    }
}

/// The value between keys by their smooth weights: the kernel -|x - y| with coefficients that sum
/// to 0, solved by elimination; a smoothstep of each weight; their sum normalized to 1.
fn smooth(keys: &[(Vec<f64>, f64)], at: &[f64]) -> f64 {
    let axes = at.len();
    let span = |axis: usize| {
        let of = || keys.iter().map(move |key| key.0[axis]);
        (of().fold(f64::MAX, f64::min), of().fold(f64::MIN, f64::max))
    };
    let scaled = |place: &[f64]| -> Vec<f64> {
        (0..axes)
            .map(|axis| {
                let (low, high) = span(axis);
                if high > low { (place[axis] - low) / (high - low) } else { 0.0 }
            })
            .collect()
    };
    let places: Vec<Vec<f64>> = keys.iter().map(|key| scaled(&key.0)).collect();
    let kernel =
        |a: &[f64], b: &[f64]| -a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt();
    let n = keys.len();
    // Rows of the linear system: the kernel between keys and a 1, and the sum of the coefficients;
    // with the right-hand sides of all keys.
    let mut rows: Vec<Vec<f64>> = (0..=n)
        .map(|i| {
            let left = (0..=n).map(|j| match (i < n, j < n) {
                (true, true) => kernel(&places[i], &places[j]),
                (false, false) => 0.0,
                _ => 1.0,
            });
            let right = (0..n).map(|key| f64::from(u8::from(i == key)));
            left.chain(right).collect()
        })
        .collect();
    for column in 0..=n {
        let pivot = (column..=n)
            .max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs()))
            .expect("rows");
        rows.swap(column, pivot);
        let row = rows[column].clone();
        for (_, other) in rows.iter_mut().enumerate().filter(|(index, _)| *index != column) {
            let factor = other[column] / row[column];
            other.iter_mut().zip(&row).for_each(|(x, y)| *x -= factor * y);
        }
        let own = rows[column][column];
        rows[column].iter_mut().for_each(|x| *x /= own);
    }
    let place = scaled(at);
    let weights: Vec<f64> = (0..n)
        .map(|key| {
            let raw =
                (0..n).map(|i| rows[i][n + 1 + key] * kernel(&place, &places[i])).sum::<f64>()
                    + rows[n][n + 1 + key];
            let x = raw.clamp(0.0, 1.0);
            x * x * (3.0 - 2.0 * x)
        })
        .collect();
    let total: f64 = weights.iter().sum();
    weights.iter().zip(keys).map(|(weight, key)| weight * key.1).sum::<f64>() / total
}

/// Parameters, the time and lights drive keys in one to three dimensions, on the GPU and on the
/// reference.
#[test]
fn wires_drive_by_the_smooth_weights() {
    let mut random = Random::new(601);
    let drivers = [json!({"wire": "b"}), json!({"wire": "a.value"}), json!({"wire": "c.y"})];
    let (mut gpu, mut reference) =
        (Errors::new("keys by wires", 2e-6), Errors::new("keys by wires, truth", 1e-12));
    for axes in 1..=3 {
        let keys: Vec<(Vec<f64>, f64)> = (0..5)
            .map(|_| {
                let place = [
                    random.between(1.0, 5.0),
                    random.between(-2.0, 2.0),
                    random.between(-1.0, 1.0),
                ];
                (place[..axes].to_vec(), random.between(-1.0, 1.0))
            })
            .collect();
        let look = look(&wired(&json!(drivers[..axes]), &keys));
        let lights: Vec<DVec3> = (0..24).map(|_| random.direction()).collect();
        let given: Vec<[f64; 2]> =
            (0..24).map(|_| [random.between(-3.0, 3.0), random.between(-1.0, 5.0)]).collect();
        let samples: Vec<EvalSample> = given
            .iter()
            .zip(&lights)
            .map(|(given, light)| sample(given[0], given[1], *light))
            .collect();
        let (seen, true_ones) = (eval(&look, "", &samples), truth(&look, "", &samples));
        for (i, ([amount, time], light)) in given.iter().zip(&lights).enumerate() {
            let wanted = smooth(&keys, &[time + 1.0, *amount, light.y][..axes]);
            gpu.note(seen[i][0], wanted, || format!("{axes}: {amount} {time} {light}"));
            reference.note(true_ones[i][0], wanted, || format!("{axes}: {amount} {time} {light}"));
        }
    }
    gpu.finish();
    reference.finish();
}

/// A driving wire may depend on keyed values: by time, and by other keys, whichever of the two sets
/// comes first in the file.
#[test]
fn keys_that_drive_other_keys_come_first() {
    let mut json = wired(&json!([{"wire": "d"}]), &[(vec![0.0], 0.0), (vec![8.0], 1.0)]);
    let by_time = json!({"name": "First", "by": {"drivers": [{"wire": "b"}]}, "keys": [
        {"at": [1], "values": {"a.value": 1}}, {"at": [3], "values": {"a.value": 2}}
    ]});
    json["direction_keys"].as_array_mut().expect("a list").push(by_time);
    json["exposed"] = json!([]);
    let step = |x: f64| {
        let x = x.clamp(0.0, 1.0);
        x * x * (3.0 - 2.0 * x)
    };
    let look = look(&json);
    let typed = check(&look.look, Library::built_in(), None).expect("it is sound").value;
    assert_eq!(typed.key_order, [1, 0]);
    let times: Vec<f64> = (0..40).map(|k| 0.1 * f64::from(k) - 0.5).collect();
    let samples: Vec<EvalSample> =
        times.iter().map(|&time| EvalSample { time, ..EvalSample::default() }).collect();
    let mut errors = Errors::new("keys that drive keys", 1e-6);
    for (got, time) in eval(&look, "", &samples).iter().zip(&times) {
        let a = 1.0 + step(0.5 * time);
        errors.note(got[0], step(a * (time + 1.0) / 8.0), || format!("{time}"));
    }
    errors.finish();
    // A light that is turned by keys drives other keys in its turned state.
    let mut json = wired(&json!([{"wire": "c.y"}]), &[(vec![-1.0], 0.0), (vec![1.0], 1.0)]);
    let turns = json!({"name": "Turn", "by": {"drivers": [{"wire": "time"}]}, "keys": [
        {"at": [0], "values": {"lights.key.direction": [0, -1, 0.001]}},
        {"at": [1], "values": {"lights.key.direction": [0, 1, 0.001]}}
    ]});
    json["direction_keys"].as_array_mut().expect("a list").push(turns);
    let look = support::eval::look(&json);
    let ends = [0.0, 1.0].map(|time| EvalSample { time, ..EvalSample::default() });
    let seen = eval(&look, "", &ends);
    assert!(seen[0][0] < 1e-5 && seen[1][0] > 1.0 - 1e-5, "{seen:?}");
}

/// A wire that cannot drive keys is refused with its node and port, and the place of the wire in
/// the file.
#[test]
fn what_cannot_drive_is_refused() {
    let with = |wire: &str, target: &str, more: &[Json]| -> Vec<Diagnostic> {
        let mut json = wired(&json!([{"wire": wire}]), &[(vec![0.0], 0.0), (vec![1.0], 1.0)]);
        for key in json["direction_keys"][0]["keys"].as_array_mut().expect("keys") {
            key["values"] = json!({target: 1});
        }
        json["nodes"].as_array_mut().expect("nodes").extend([
            json!({"id": "facing", "kind": "facing"}),
            json!({"id": "picture", "kind": "image"}),
            json!({"id": "both", "kind": "light_parts"}),
        ]);
        json["direction_keys"].as_array_mut().expect("sets").extend(more.iter().cloned());
        let loaded = Look::read(&json.to_string(), "test.json");
        let mut problems = loaded.diagnostics;
        if let Some(look) = &loaded.value {
            problems.extend(check(look, Library::built_in(), None).err().unwrap_or_default());
        }
        problems.retain(Diagnostic::is_error);
        problems
    };
    let other = |wire: &str, target: &str| {
        json!({
            "name": "Other", "by": {"drivers": [{"wire": wire}]},
            "keys": [{"at": [0], "values": {target: 1}}]
        })
    };
    for (wire, target, more, code, place) in [
        ("nobody", "number.value", None, "unknown-node", None),
        ("c.w", "number.value", None, "unknown-port", Some("c")),
        ("facing", "number.value", None, "fragment-driver", Some("facing")),
        ("picture", "number.value", None, "fragment-driver", Some("picture")),
        ("light", "number.value", None, "wrong-type", Some("light")),
        ("a", "a.value", None, "key-cycle", Some("a")),
        ("d", "b.b", None, "key-cycle", Some("d")),
        ("c.y", "lights.key.direction", None, "key-cycle", Some("c")),
        ("a", "number.value", Some(other("number", "a.value")), "key-cycle", Some("a")),
        ("a..", "number.value", None, "bad-output", None),
    ] {
        let problems = with(wire, target, more.as_slice());
        let found = problems.iter().find(|problem| problem.code == code);
        let found = found.unwrap_or_else(|| panic!("{wire}: {problems:?}"));
        assert!(!found.hints.is_empty() || code.starts_with("unknown"), "{wire}: {found}");
        let json_path = found.place.json_path.as_deref().unwrap_or_default();
        assert!(json_path.starts_with("direction_keys[0].by"), "{wire}: {json_path}");
        if let Some(place) = place {
            let node = found.place.node.as_ref().map(ToString::to_string);
            assert_eq!(node.as_deref(), Some(place), "{wire}: {found}");
        }
    }
    // A wire that drives keys is part of the look: an error there is an error of the look.
    let mut json = wired(&json!([{"wire": "d"}]), &[(vec![0.0], 0.0)]);
    json["nodes"][7]["values"] = json!({"a": "red"});
    json["wires"].as_array_mut().expect("wires").retain(|wire| wire["to"] != "d.a");
    let broken = Look::read(&json.to_string(), "test.json").value.expect("a look");
    assert!(check(&broken, Library::built_in(), None).is_err());
}

/// Wires with NaN, too large numbers, or values at which several keys lie have documented results.
#[test]
fn hot_wires_have_results() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::create_dir_all(folder.path().join("nodes/own")).expect("a folder");
    let text = "/// Hot\n///\n/// @param x \"X\" default=0 : 1 for infinity, 2 for what is no \
                number.\n\
                /// @return value \"Value\" : That.\n\
                fn hot(x: f32) -> f32 \
                { let big = exp2(x * 1000.0) * x; return select(big, big - big, x > 1.5); }\n";
    std::fs::write(folder.path().join("nodes/own/hot.wgsl"), text).expect("a file");
    let library = Library::built_in().with_project(&chiaro::files::Disk, folder.path());
    assert!(library.problems.is_empty(), "{:?}", library.problems);
    let keys = [(vec![-2.0], 0.125), (vec![0.0], 0.5), (vec![2.0], 0.75), (vec![2.0], 0.875)];
    let mut json = wired(&json!([{"wire": "hot"}]), &keys);
    json["nodes"].as_array_mut().expect("nodes").push(json!({"id": "hot", "kind": "hot"}));
    json["wires"].as_array_mut().expect("wires").push(json!({"from": "a", "to": "hot.x"}));
    let look = look(&json);
    let samples = [0.0, 1.0, -1.0, 2.0, 1e30, f64::NAN].map(|amount| sample(amount, 0.0, DVec3::Z));
    let samples = &samples[..5];
    let seen = eval_with(&look, &library, &options(""), samples);
    // 0 lies at its key; infinity lies beyond the last two keys, which share a weight; -1 gives
    // -2^-1000, which is nearly 0; NaN counts as 0.
    let wanted = [0.5, 0.8125, 0.5, 0.5, 0.5];
    for (got, wanted) in seen.iter().zip(wanted) {
        assert!((got[0] - wanted).abs() < 1e-6, "{seen:?}");
    }
}

/// Drivers follow their nodes through grouping, dissolving, removing and undoing.
#[test]
fn what_drives_follows_its_node() {
    use chiaro::document::grouping::{dissolve, group};
    let keys = [(vec![0.0], 0.0), (vec![8.0], 1.0)];
    let setup = look(&wired(&json!([{"wire": "d"}]), &keys));
    let driver = |look: &Look| match &look.direction_keys[0].by {
        KeyDirection::Drivers(drivers) => match &drivers[0] {
            Driver::Wire(output) => output.to_string(),
            other => panic!("{other:?}"),
        },
        other => panic!("{other:?}"),
    };
    let text = setup.look.to_text();
    assert_eq!(Look::read(&text, "again.json").value.as_ref(), Some(&setup.look), "{text}");
    let samples: Vec<EvalSample> =
        (0..6).map(|k| sample(0.7 * f64::from(k), 0.3, DVec3::Y)).collect();
    let before = truth(&setup, "", &samples);
    let mut history = History::new(setup.look.clone());
    let inside = [NodeId::new("d"), NodeId::new("b")];
    let first = |node: &chiaro::document::Node| {
        Library::built_in().nodes.get(&node.kind).map(|def| def.outputs[0].name.clone())
    };
    let taken = |slug: &str| Library::built_in().kinds().any(|kind| kind == slug);
    let grouped = group(history.document(), &GraphId::Look, &inside, "Product", taken, first)
        .expect("a group");
    history.apply(grouped.edit).expect("it applies");
    assert_eq!(driver(history.document()), "product/d");
    let with = |look: &Look| SetupLook { look: look.clone(), ..look_of(&setup) };
    assert_eq!(truth(&with(history.document()), "", &samples), before);
    let definition = history.document().definitions[&grouped.definition].clone();
    let opened =
        dissolve(history.document(), &GraphId::Look, &grouped.node, &definition).expect("it opens");
    history.apply(opened.edit).expect("it applies");
    assert_eq!(driver(history.document()), "d");
    assert_eq!(truth(&with(history.document()), "", &samples), before);
    history
        .apply(Edit::RemoveNode { graph: GraphId::Look, id: NodeId::new("d") })
        .expect("it applies");
    assert!(history.document().direction_keys.is_empty(), "nothing drives them any more");
    while history.undo().is_some() {}
    assert_eq!(*history.document(), setup.look);
    // An edit cannot name a missing node as a driver.
    let mut wrong = setup.look.direction_keys[0].clone();
    wrong.by = KeyDirection::Drivers(vec![
        serde_json::from_value(json!({"wire": "nobody"})).expect("a driver"),
    ]);
    assert!(history.apply(Edit::SetDirectionKeys { index: 0, keys: wrong }).is_err());
}

fn look_of(setup: &SetupLook) -> SetupLook {
    SetupLook {
        look: setup.look.clone(),
        source: setup.source.clone(),
        folder: setup.folder.clone(),
    }
}

/// Outputs that may drive keys are listed: values, the time, lights from one direction, and results
/// of these; not outputs that depend on the keyed values.
#[test]
fn what_may_drive_is_listed() {
    let json = wired(&json!([{"wire": "d"}]), &[(vec![0.0], 0.0)]);
    let typed = check(&look(&json).look, Library::built_in(), None).expect("it is sound").value;
    let listed = |moved: &[chiaro::document::Target]| -> Vec<String> {
        let [changing, still] = typed.drivable(moved, &[]);
        changing.iter().chain(&still).map(ToString::to_string).collect()
    };
    let all = listed(&[]);
    for wire in ["number.value", "a.value", "time.time", "parts.intensity", "c.x", "c.y", "c.z"] {
        assert!(all.iter().any(|known| known == wire), "{wire}: {all:?}");
    }
    assert!(
        all.iter().all(|known| !known.starts_with("output") && !known.starts_with("light.")),
        "{all:?}"
    );
    let target = chiaro::document::Target::parse("a.value").expect("a target");
    let left = listed(&[target]);
    assert!(
        left.len() == all.len() - 2
            && !left.iter().any(|wire| wire.starts_with("a.") || wire.starts_with("d."))
    );
}

/// An export names the steps that compute a wire; run as by a host, they give the wire's value.
#[test]
fn an_export_carries_the_wires() {
    let setup = look(&wired(
        &json!([{"wire": "d"}, {"wire": "c.y"}]),
        &[(vec![0.0, 0.0], 0.0), (vec![3.0, 1.0], 1.0)],
    ));
    let languages = chiaro::export::languages([chiaro::export::ALL]).expect("languages");
    let library = Library::built_in();
    let made = chiaro::export::export(
        &setup.look,
        library,
        "wired",
        &languages,
        (std::path::Path::new(""), &mut chiaro::frame::Assets::default()),
    );
    let made = made.unwrap_or_else(|problems| panic!("{problems:?}"));
    let text = |name: &str| {
        let file =
            made.value.iter().find(|file| file.name == name).unwrap_or_else(|| panic!("no {name}"));
        String::from_utf8(file.bytes.clone()).expect("text")
    };
    let description: Json = serde_json::from_str(&text("wired.json")).expect("JSON");
    let host = &description["modules"][0]["host"];
    assert_eq!(host["key_order"], json!([0]), "{host}");
    let drivers: Vec<&str> = host["drivers"]
        .as_array()
        .expect("drivers")
        .iter()
        .filter_map(|d| d["wire"].as_str())
        .collect();
    assert_eq!(drivers, ["d", "c.y"]);
    let functions = text(host["functions"].as_str().expect("functions"));
    let valid = chiaro::wgsl::parse(&functions)
        .unwrap_or_else(|error| panic!("{}\n{functions}", error.message));
    let light = DVec3::new(0.36, 0.48, 0.8);
    let steps = host["steps"].as_array().expect("steps");
    let mut values: Vec<interp::Value> = Vec::new();
    for step in steps {
        values.push(match step["op"].as_str().expect("an op") {
            "parameter" => {
                let parameter = &description["parameters"]
                    [step["parameter"].as_u64().expect("an index") as usize];
                let amount = parameter["name"] == "amount";
                interp::Value::Float(if amount {
                    2.5
                } else {
                    step["value"].as_f64().expect("a number")
                })
            }
            "constant" => interp::Value::Float(step["value"].as_f64().expect("a number")),
            "context" => match step["context"].as_str().expect("a name") {
                "time" => interp::Value::Float(0.25),
                "light.direction" => interp::Value::vec(&light.to_array()),
                "light.own_direction" | "light.color" => interp::Value::vec(&[1.0, 1.0, 1.0]),
                _ => interp::Value::Float(1.0),
            },
            "call" => {
                let name = step["function"].as_str().expect("a name");
                let program = interp::Program::compile(
                    &valid.module,
                    name,
                    interp::FunctionOptions::default(),
                )
                .expect("it runs");
                let arguments = step["arguments"].as_array().expect("steps").iter();
                let arguments: Vec<_> = arguments
                    .map(|at| values[at.as_u64().expect("an index") as usize].clone())
                    .collect();
                program.call(&arguments, Precision::F64).expect("it ends")
            }
            _ => {
                let of = &values[step["of"].as_u64().expect("an index") as usize];
                of.parts().expect("a struct")[step["member"].as_u64().expect("an index") as usize]
                    .clone()
            }
        });
    }
    let of = |driver: usize| {
        values[host["drivers"][driver]["step"].as_u64().expect("a step") as usize].as_f64()
    };
    assert_eq!([of(0), of(1)], [Some(2.5 * 1.25), Some(0.48)]);
}

/// A module knows its wires for every kind of live values, and a module that draws normals leaves
/// the wires out.
#[test]
fn every_way_of_compiling_has_the_wires() {
    let setup = look(&wired(&json!([{"wire": "d"}]), &[(vec![0.0], 0.0), (vec![3.0], 1.0)]));
    for live in [Live::Keyed, Live::Exposed, Live::All] {
        for unspecialized in [false, true] {
            let options =
                CompileOptions { live: live.clone(), unspecialized, ..CompileOptions::default() };
            let shader =
                compile(&setup.look, Library::built_in(), &options).expect("it compiles").value;
            let inputs = HostInputs {
                params: &Default::default(),
                lights: &Default::default(),
                camera_from_world: glam::DMat3::IDENTITY,
                viewport: [1.0; 2],
                time: 3.0,
                frame: 0.0,
                object_id: 0.0,
            };
            let value = shader.host.driver(&shader.host.drivers[0], &inputs).expect("it ends");
            assert_eq!(value, 2.0, "{live:?} {unspecialized}");
        }
    }
    let options =
        CompileOptions { stage: chiaro::compile::Stage::Normals, ..CompileOptions::default() };
    assert!(
        compile(&setup.look, Library::built_in(), &options)
            .expect("it compiles")
            .value
            .host
            .drivers
            .is_empty()
    );
}

/// Wires that can change are told from wires that never do: values that a scene or keys set, the
/// time, and lights can change.
#[test]
fn wires_that_never_change_are_told_apart() {
    let json = wired(&json!([{"wire": "d"}]), &[(vec![0.0], 0.0)]);
    let typed = check(&look(&json).look, Library::built_in(), None).expect("it is sound").value;
    let target = |text: &str| chiaro::document::Target::parse(text).expect("a target");
    let told = |set: &[chiaro::document::Target]| {
        typed
            .drivable(&[], set)
            .map(|wires| wires.iter().map(ToString::to_string).collect::<Vec<String>>())
    };
    // With nothing set `number` and `a` never change; the time and the light do, and so do results
    // of these.
    let [changing, still] = told(&[]);
    assert_eq!(still, ["number.value", "a.value"]);
    for wire in ["time.time", "b.sum", "parts.intensity", "c.x", "d.product"] {
        assert!(changing.iter().any(|known| known == wire), "{wire}: {changing:?}");
    }
    let [_, still] = told(&[target("a.value")]);
    assert_eq!(still, ["number.value"], "a scene may set what is exposed");
    let [_, still] = told(&[target("a.value"), target("number.value")]);
    assert!(still.is_empty(), "{still:?}");
}
