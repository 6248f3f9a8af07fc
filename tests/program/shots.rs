//! Shots: values of a scene and its looks changed for some frames, the nearest document first, and
//! shading held on twos.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use std::sync::Arc;

use chiaro::compile::Live;
use chiaro::diag::Diagnostic;
use chiaro::document::{LightField, Shot};
use chiaro::files::MemoryFiles;
use chiaro::film::PlanHasher;
use chiaro::frame::{AssetStore, Assets, PlanOptions, Planner, Setup, open};
use chiaro::ids::ObjectId;
use chiaro::library::Library;
use serde_json::{Value as Json, json};

const RATE: f64 = 24.0;

/// A look with a base and a layer lit by the light `own`, or by one of the scene.
fn look() -> Json {
    json!({
        "chiaro": "look", "version": 1,
        "lights": {"key": {"direction": [0, 0, 1]}, "own": {"direction": [1, 0, 1]}},
        "nodes": [
            {"id": "base", "kind": "base"},
            {"id": "warm", "kind": "light_layer", "values": {"light": "key", "offset": 0.2}},
            {"id": "rim", "kind": "light_layer", "values": {"light": "own"}},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "base", "to": "warm.below"}, {"from": "warm", "to": "rim.below"},
            {"from": "rim", "to": "output.color"}
        ],
        "exposed": [{"name": "tint", "target": "base.color"}],
        "time_keys": [{"target": "warm.offset", "keys": [
            {"time": 0, "value": 0.1}, {"time": 1, "value": 0.9}
        ]}]
    })
}

fn scene() -> Json {
    json!({
        "chiaro": "scene", "version": 1,
        "objects": [
            {"id": "hero", "mesh": "shape:sphere", "looks": "look.json"},
            {"id": "ball", "mesh": "shape:cube", "looks": "look.json",
                "values": {"tint": "#406080"}, "transform": {"translate": [1.5, 0, 0]}}
        ],
        "lights": {
            "key": {"direction": [0, 1, 1], "color": [1, 1, 1], "groups": ["set"]},
            "fill": {"direction": [1, 0, 1], "intensity": 0.5}
        }
    })
}

/// A shot over a file with overrides.
fn shot(over: &str, fields: Json, overrides: Json) -> Json {
    let mut shot = json!({"chiaro": "shot", "version": 1, "scene": over});
    let Json::Object(fields) = fields else { panic!("fields are those of an object") };
    shot.as_object_mut().unwrap().extend(fields);
    shot["overrides"] = overrides;
    shot
}

fn key(frame: i32, value: impl Into<Json>) -> Json {
    json!({"frame": frame, "value": value.into()})
}

/// The setup of `shot.json` among other files.
fn opened(shots: &[(&str, Json)]) -> Result<(Setup, Vec<Diagnostic>), Vec<Diagnostic>> {
    let mut files = MemoryFiles::default();
    files.add("scene.json", scene().to_string());
    files.add("look.json", look().to_string());
    shots.iter().for_each(|(name, shot)| files.add(*name, shot.to_string()));
    let mut assets = Assets::of(&AssetStore::reading_from(Arc::new(files)));
    open(Path::new("shot.json"), None, &mut assets).map(|setup| setup.into_parts())
}

/// A setup that is opened without a word.
#[track_caller]
fn clean(shots: &[(&str, Json)]) -> Setup {
    let (setup, problems) = opened(shots).unwrap_or_else(|problems| panic!("{problems:?}"));
    assert!(problems.is_empty(), "{problems:?}");
    setup
}

/// Hash of the plan of a frame.
fn plan_of(setup: &Setup, frame: i32) -> String {
    let options = PlanOptions { size: [48, 32], samples: 1, time: f64::from(frame) / RATE };
    let mut planner = Planner::new(Assets::of(&setup.assets));
    let plan = planner.plan(setup, Library::built_in(), &Live::Keyed, &options).unwrap().value;
    PlanHasher::default().hash(&plan)
}

/// Hashes of the plans of frames, as numbers: the same picture has the same number.
fn pictures(setup: &Setup, frames: std::ops::RangeInclusive<i32>) -> Vec<usize> {
    let mut seen: Vec<String> = Vec::new();
    let number = |frame| {
        let hash = plan_of(setup, frame);
        seen.iter().position(|known| *known == hash).unwrap_or_else(|| {
            seen.push(hash);
            seen.len() - 1
        })
    };
    frames.map(number).collect()
}

#[test]
fn the_nearest_shot_wins_and_all_changes_are_told() {
    let sequence = shot(
        "scene.json",
        json!({"rate": 24, "step": 2}),
        json!([
            {"target": "lights.key.color", "value": "#ff0000"},
            {"target": "lights.fill.intensity", "value": 0.25},
            {"target": "light_groups.set.exposure", "value": 1},
            {"target": "objects.hero.layers.rim.layered", "value": "key"},
        ]),
    );
    let camera = json!({"eye": [0, 0, 9], "fov": 0.4});
    let near = shot(
        "sequence.json",
        json!({"frames": [1, 48], "camera": camera}),
        json!([
            {"target": "lights.key.color", "value": [0, 1, 0]},
            {"target": "objects.hero.transform.rotate", "value": [0, 0, 0, 2]},
            {"target": "objects.hero.values.tint", "value": "#102030"},
            {"target": "outlines.width", "value": 2},
            {"look": "look.json", "target": "warm.offset", "value": 0.7},
            {"look": "look.json", "target": "nodes.rim.muted", "value": true},
            {"look": "look.json", "target": "lights.own.direction", "value": [0, 1, 0]},
        ]),
    );
    let setup = clean(&[("sequence.json", sequence), ("shot.json", near)]);
    let scene = &setup.scene;
    assert_eq!(scene.lights["key"].color, [0.0, 1.0, 0.0]);
    assert_eq!(scene.lights["key"].groups[0].as_str(), "set", "the rest of the light stays");
    assert_eq!(scene.lights["fill"].intensity, 0.25);
    assert_eq!(scene.light_groups["set"].exposure, 1.0);
    assert_eq!((scene.camera.eye, scene.camera.fov), ([0.0, 0.0, 9.0], 0.4));
    assert_eq!(scene.outlines.width, 2.0);
    assert_eq!(scene.time.fps, 24.0);
    let hero = &setup.objects[0];
    assert_eq!(hero.layers[0].layered.text(), "key");
    assert!(hero.values.contains_key("tint"));
    let look = &setup.looks[0].look;
    assert_eq!(LightField::Direction.numbers(&look.lights["own"]), [0.0, 1.0, 0.0]);
    assert!(look.graph.nodes["rim"].muted && look.time_keys.is_empty(), "{:?}", look.time_keys);

    let shot = setup.shot.as_ref().unwrap();
    assert_eq!((shot.stack.frames(), shot.stack.step()), ([1, 48], 2));
    let told = |target: &str| -> Vec<(Json, Json, String, bool)> {
        let of = shot.changes.iter().filter(|change| change.target == target);
        of.map(|change| {
            let by = change.by.display().to_string();
            (change.from.clone(), change.to.clone(), by, change.stands)
        })
        .collect()
    };
    assert_eq!(
        told("lights.key.color"),
        [
            (json!([1, 1, 1]), json!("#ff0000"), "sequence.json".to_owned(), false),
            (json!("#ff0000"), json!([0, 1, 0]), "shot.json".to_owned(), true),
        ]
    );
    assert_eq!(told("warm.offset")[0].0, json!(0.1), "the first of the look's own keys");
    assert_eq!(told("light_groups.set.exposure")[0].0, json!(0));
    assert_eq!(told("nodes.rim.muted")[0].0, json!(false));
    assert_eq!(told("camera.fov").len(), 1);
    assert!(told("camera.height").is_empty(), "what the camera leaves as it was is no change");
}

/// Twos of looks and lights, while the camera and objects are on ones: one switch.
#[test]
fn shading_is_on_twos_and_cameras_on_ones() {
    let light =
        json!({"target": "lights.key.direction", "keys": [key(1, [-1, 0, 1]), key(9, [1, 0, 1])]});
    let exposed = json!({"target": "objects.hero.values.tint",
        "keys": [key(1, "#000000"), key(9, "#ffffff")]});
    let camera = json!({"target": "camera.eye", "keys": [key(1, [0, 0, 4]), key(9, [1, 0, 4])]});
    let object = json!({"target": "objects.ball.transform.translate",
        "keys": [key(1, [0, 0, 0]), key(9, [0, 1, 0])]});
    let of = |step: u32, overrides: Json| {
        let fields = json!({"frames": [1, 8], "rate": 24, "step": step});
        clean(&[("shot.json", shot("scene.json", fields, overrides))])
    };
    // The look itself has a key in time, so that nothing else need move.
    assert_eq!(pictures(&of(1, json!([])), 1..=5), [0, 1, 2, 3, 4]);
    for moving in [json!([]), json!([light]), json!([exposed])] {
        assert_eq!(pictures(&of(2, moving.clone()), 1..=6), [0, 0, 1, 1, 2, 2], "{moving}");
        assert_eq!(pictures(&of(3, moving.clone()), 1..=6), [0, 0, 0, 1, 1, 1], "{moving}");
    }
    for moving in [json!([camera]), json!([object])] {
        assert_eq!(pictures(&of(2, moving.clone()), 1..=4), [0, 1, 2, 3], "{moving}");
    }
    // On twos the shading is that of the frame that is held, to the last bit.
    let (ones, twos) = (of(1, json!([light])), of(2, json!([light])));
    assert_eq!(plan_of(&twos, 4), plan_of(&ones, 3));
}

#[test]
fn an_override_is_held_by_itself_and_objects_come_and_go() {
    let overrides = json!([
        {"target": "lights.fill.intensity", "step": 3, "keys": [key(1, 0), key(7, 6)]},
        {"target": "outlines.width", "step": 2, "keys": [key(1, 0), key(5, 4)]},
        {"target": "objects.ball.visible", "keys": [key(1, false), key(3, true)]},
        {"target": "objects.hero.transform.rotate",
            "keys": [key(1, [0, 0, 0, 1]), key(3, [0, -1, 0, 0])]},
    ]);
    let fields = json!({"frames": [1, 8], "rate": 24});
    let setup = clean(&[("shot.json", shot("scene.json", fields, overrides))]);
    let at = |frame: i32| setup.at(f64::from(frame) / RATE).into_owned();
    let widths = [1, 2, 3, 4, 5, 6].map(|frame| at(frame).scene.outlines.width);
    assert_eq!(widths, [0.0, 0.0, 2.0, 2.0, 4.0, 4.0]);
    let track = &setup.scene.time_keys[0];
    let held: Vec<Json> = track.keys.iter().map(|key| json!(key.value)).collect();
    assert_eq!(held, [json!(0.0), json!(3.0), json!(6.0), json!(6.0)]);
    let counts = [1, 2, 3].map(|frame| at(frame).objects.len());
    assert_eq!(counts, [1, 1, 2], "a switch holds until its next key");
    // Halfway between two rotations is half of the turn, as seen in the world.
    let front = at(2).objects[0].world_from_object.transform_vector3(glam::DVec3::Z).normalize();
    assert!((front.x.abs() - 1.0).abs() < 1e-9, "{front}");
    assert!(setup.scene.objects[&ObjectId::new("ball")].visible, "its mesh is read");
}

#[test]
fn what_is_wrong_is_told_with_its_place_and_the_nearest_name() {
    let wrong = |overrides: Json, code: &str, path: &str, words: &str| {
        let shot = shot("scene.json", json!({"frames": [1, 8]}), overrides.clone());
        let problems = match opened(&[("shot.json", shot)]) {
            Ok((_, warnings)) => warnings,
            Err(problems) => problems,
        };
        let found = problems.iter().find(|problem| problem.code == code);
        let found = found.unwrap_or_else(|| panic!("{overrides}: {problems:?}"));
        assert_eq!(found.place.file.as_deref(), Some("shot.json"), "{found}");
        assert_eq!(found.place.json_path.as_deref(), Some(path), "{found}");
        assert!(found.to_string().contains(words), "{found}");
    };
    let target = "overrides[0].target";
    let set = |address: &str, value: Json| json!([{"target": address, "value": value}]);
    wrong(set("lights.kye.color", json!("#fff000")), "unknown-target", target, "`key`");
    wrong(set("lights.own.color", json!("#fff000")), "unknown-target", target, "\"look\"");
    wrong(set("lights.key.colour", json!("#fff000")), "bad-target", target, "`color`");
    wrong(set("objects.heroo.visible", json!(true)), "unknown-target", target, "`hero`");
    wrong(set("camera", json!(1)), "bad-target", target, "camera.");
    wrong(set("camera.fov.x", json!(1)), "bad-target", target, "`camera.fov`");
    wrong(set("version", json!(2)), "bad-target", target, "version");
    wrong(set("objects.hero", json!(2)), "bad-target", target, "transform");
    wrong(set("objects", json!(2)), "bad-target", target, "");
    let value = "overrides[0].value";
    wrong(set("lights.key.intensity", json!(-1)), "out-of-range", value, "from 0");
    wrong(set("lights.key.type", json!("spott")), "unknown-word", value, "`spot`");
    wrong(set("objects.hero.linked", json!("key |")), "bad-light-set", value, "");
    wrong(set("camera.eye", json!([0, 0])), "wrong-count", value, "3 numbers");
    let keyed = |address: &str, keys: Json| json!([{"target": address, "keys": keys}]);
    let second = "overrides[0].keys[1].value";
    wrong(keyed("camera.fov", json!([key(1, 1), key(2, 9)])), "out-of-range", second, "");
    wrong(
        keyed("objects.hero.mesh", json!([key(1, "a.obj")])),
        "bad-target",
        "overrides[0].keys",
        "\"value\"",
    );
    wrong(
        keyed("camera.fov", json!([key(2, 1), key(2, 1)])),
        "not-increasing",
        "overrides[0].keys[1].frame",
        "",
    );
    wrong(json!([{"target": "camera.fov"}]), "missing-field", "overrides[0]", "\"keys\"");
    let of_look = |address: &str, value: Json| {
        let changed = json!({"look": "look.json", "target": address, "value": value});
        json!([changed])
    };
    wrong(of_look("wram.offset", json!(1)), "unknown-node", target, "`warm`");
    wrong(of_look("rim.below", json!(1)), "wired-input", target, "`warm`");
    wrong(of_look("nodes.rim.mutedd", json!(true)), "bad-target", target, "`muted`");
    wrong(of_look("lights.key.color", json!("#ffffff")), "idle-override", target, "the scene has");
    wrong(
        of_look("base.color", json!("#ffffff")),
        "idle-override",
        target,
        "objects.ball.values.tint",
    );
    let look = "overrides[0].look";
    wrong(
        json!([{"look": "lok.json", "target": "a.b", "value": 1}]),
        "missing-asset",
        look,
        "`look.json`",
    );
    let both = json!([{"target": "camera.fov", "value": 1}, {"target": "camera.fov", "value": 1}]);
    wrong(both, "duplicate-id", "overrides[1].target", "twice");
    wrong(set("lights.key.inner", json!(3)), "out-of-range", "overrides", "as the shot changes it");
}

#[test]
fn shots_that_change_one_another_or_nothing_that_is_there_are_refused() {
    let over = |name: &str| shot(name, json!({}), json!([]));
    let refused = |files: &[(&str, Json)], code: &str, words: &str| {
        let problems = opened(files).unwrap_err();
        let last = problems.last().unwrap();
        assert_eq!((last.code, last.place.json_path.as_deref()), (code, Some("scene")), "{last}");
        assert!(last.to_string().contains(words), "{last}");
    };
    let circle =
        [("shot.json", over("a.json")), ("a.json", over("b.json")), ("b.json", over("a.json"))];
    refused(&circle, "cycle", "a.json, b.json");
    refused(&[("shot.json", over("shot.json"))], "cycle", "shot.json");
    refused(&[("shot.json", over("nowhere.json"))], "missing-asset", "nowhere.json");
    refused(&[("shot.json", over("look.json"))], "wrong-document", "a scene");
}

/// The program in a folder with the files of the tests above.
struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        let folder = Self(tempfile::tempdir().unwrap());
        folder.write("scene.json", &scene());
        folder.write("look.json", &look());
        folder
    }

    fn write(&self, name: &str, json: &Json) {
        let text = serde_json::to_string_pretty(json).unwrap();
        fs::write(self.0.path().join(name), text).unwrap();
    }

    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.0.path().join(name)).unwrap()
    }

    fn run(&self, arguments: &[&str]) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_chiaro"));
        command.env("CHIARO_CACHE_DIR", "").current_dir(self.0.path());
        command.args(arguments).output().unwrap()
    }

    #[track_caller]
    fn done(&self, arguments: &[&str]) -> String {
        let output = self.run(arguments);
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{arguments:?}: {said}");
        String::from_utf8(output.stdout).unwrap()
    }
}

#[test]
fn a_shot_draws_its_own_frames_at_its_rate_and_size() {
    let folder = Folder::new();
    let fields = json!({"frames": [1001, 1004], "rate": "24000/1001", "size": [24, 16], "step": 2});
    folder.write(
        "shot.json",
        &shot(
            "scene.json",
            fields,
            json!([
                {"target": "lights.key.intensity", "keys": [key(1001, 0), key(1004, 3)]}
            ]),
        ),
    );
    let draw = |arguments: &[&str]| -> Vec<Json> {
        let fixed = ["render", "shot.json", "--samples", "1", "--json"];
        let lines = folder.done(&[&fixed, arguments].concat());
        lines.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
    };
    let frames = draw(&["-o", "a.####.png"]);
    let told: Vec<_> =
        frames.iter().map(|frame| (frame["frame"].as_i64(), frame["state"].as_str())).collect();
    let state = |frame, state| (Some(frame), Some(state));
    assert_eq!(
        told,
        [state(1001, "drawn"), state(1002, "equal"), state(1003, "drawn"), state(1004, "equal")]
    );
    assert_eq!(frames[0]["time"], json!(1001.0 * 1001.0 / 24_000.0));
    let picture = image::open(folder.0.path().join("a.1003.png")).unwrap();
    assert_eq!((picture.width(), picture.height()), (24, 16));
    // What the command line says stands over the shot.
    let frames = draw(&["-o", "b.####.png", "--frames", "0-1", "--rate", "12", "--size", "8x8"]);
    assert_eq!(frames[1]["time"], json!(1.0 / 12.0));
    let refused = folder.run(&["render", "shot.json", "-o", "c.png", "--rate", "12"]);
    assert_eq!(refused.status.code(), Some(2));
}

#[test]
fn changes_are_told_taken_back_and_checked() {
    let folder = Folder::new();
    folder.write(
        "sequence.json",
        &shot(
            "scene.json",
            json!({"step": 2}),
            json!([
                {"target": "lights.key.color", "value": "#ff0000"}
            ]),
        ),
    );
    let mut near = shot(
        "sequence.json",
        json!({"frames": [1, 24], "later": [1, 2]}),
        json!([
            {"target": "lights.key.color", "value": "#0f0"},
            {"look": "look.json", "target": "warm.offset", "value": 0.5},
            {"target": "lights.fill.intensity", "value": 0.5},
        ]),
    );
    folder.write("shot.json", &near);
    let before =
        [folder.read("scene.json"), folder.read("look.json"), folder.read("sequence.json")];
    let changes: Json =
        serde_json::from_str(&folder.done(&["shot", "shot.json", "--diff", "--json"])).unwrap();
    let told: Vec<_> = changes
        .as_array()
        .unwrap()
        .iter()
        .map(|change| {
            (change["target"].as_str().unwrap(), change["by"].as_str().unwrap(), &change["stands"])
        })
        .collect();
    let (yes, no) = (json!(true), json!(false));
    assert_eq!(
        told,
        [
            ("lights.key.color", "sequence.json", &no),
            ("lights.key.color", "shot.json", &yes),
            ("lights.fill.intensity", "shot.json", &yes),
            ("warm.offset", "shot.json", &yes),
        ]
    );
    let diff = folder.done(&["shot", "shot.json", "--diff"]);
    assert!(diff.contains("#ff0000 -> #00ff00"), "a short color: {diff}");
    let same: Vec<&str> =
        diff.lines().filter(|line| line.ends_with("(the same as below)")).collect();
    assert!(same.len() == 1 && same[0].contains("lights.fill.intensity"), "{diff}");
    assert!(diff.contains("look.json#warm.offset  0.1 -> 0.5"), "{diff}");
    assert!(diff.contains("(changed again)"), "{diff}");
    let summary = folder.done(&["shot", "shot.json"]);
    assert!(summary.contains("frames 1 to 24") && summary.contains("on twos"), "{summary}");
    let explained = folder.done(&["explain", "shot.json"]);
    assert!(explained.contains("Changed by shots"), "{explained}");
    // A value of the wrong type is told where the shot sets it, which only the library knows.
    folder.done(&["check", "shot.json"]);
    near["overrides"][1]["value"] = json!("much");
    folder.write("shot.json", &near);
    let output = folder.run(&["check", "shot.json", "--json"]);
    let problems: Json = serde_json::from_slice(&output.stdout).unwrap();
    let of_value = |problem: &&Json| problem["json_path"] == "overrides[1]";
    let found = problems.as_array().unwrap().iter().find(of_value);
    let found = found.unwrap_or_else(|| panic!("{problems:#}"));
    assert_eq!(found["file"], "shot.json");

    // Keys that are out of order hide nothing else, and looks are suggested as the shot names them.
    let mut wrong = near.clone();
    wrong["overrides"] = json!([
        {"target": "camera.fov", "keys": [{"frame": 9, "value": 0.5}, {"frame": 2, "value": 1}]},
        {"look": "../loook.json", "target": "warm.offset", "value": 0.5},
    ]);
    wrong["scene"] = json!("../scene.json");
    std::fs::create_dir(folder.0.path().join("shots")).unwrap();
    folder.write("shots/wrong.json", &wrong);
    let said = folder.run(&["check", "shots/wrong.json"]);
    let said = String::from_utf8_lossy(&said.stderr).into_owned();
    assert!(said.contains("not-increasing") && said.contains("missing-asset"), "{said}");
    assert!(said.contains("did you mean `../look.json`?"), "{said}");

    folder.done(&["shot", "shot.json", "--reset", "look.json#warm.offset"]);
    let read = Shot::read(&folder.read("shot.json"), "shot.json").value.unwrap();
    assert_eq!(read.overrides.len(), 2);
    assert!(read.unknown.contains_key("later"), "what this version does not know survives");
    // Whoever wrote the file by hand finds it as it was, but for the line.
    let by_hand = "{ \"chiaro\":\"shot\", \"version\":1,\n\t\"overrides\": [\n\
        \t\t{\"target\":\"lights.key.color\",  \"value\":\"#ff0000\"},\n\
        \t\t{\"target\":\"lights.key.intensity\", \"value\":0.50} ],\n\
        \t\"camera\": {\"eye\": [0, 0, 9]},\n  \"scene\": \"scene.json\"}";
    let hand = folder.0.path().join("hand.json");
    std::fs::write(&hand, by_hand).unwrap();
    folder.done(&["shot", "hand.json", "--reset", "lights.key.intensity", "--reset", "camera"]);
    assert_eq!(
        folder.read("hand.json"),
        by_hand
            .replace(",\n\t\t{\"target\":\"lights.key.intensity\", \"value\":0.50}", "")
            .replace("\"camera\": {\"eye\": [0, 0, 9]},\n  ", "")
    );
    let missing = folder.run(&["shot", "shot.json", "--reset", "lights.key.colour"]);
    assert!(String::from_utf8_lossy(&missing.stderr).contains("`lights.key.color`"));
    let after = [folder.read("scene.json"), folder.read("look.json"), folder.read("sequence.json")];
    assert_eq!(before, after, "nothing but the shot is written");
}

/// Values of objects are known to the looks of examples, from wherever these are named.
#[test]
fn scenes_of_examples_are_checked_with_their_looks() {
    let output = Folder::new().run(&["check", "--strict", "example:scenes/lit-room-day.json"]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && said.contains("nothing is wrong"), "{said}");
}

/// Shots, and the scenes and looks that they change, are examples from anywhere.
#[test]
fn shots_of_examples_are_checked_with_their_scenes() {
    for shot in ["evening-010", "evening-020", "nightfall/nightfall-010-graded"] {
        let name = format!("example:shots/{shot}.json");
        let output = Folder::new().run(&["check", "--strict", &name]);
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && said.contains("nothing is wrong"), "{said}");
    }
}

/// The example shots are sound, and so is a new one.
#[test]
fn example_shots_and_templates_are_checked_without_a_word() {
    let folder = Folder::new();
    folder.done(&["new", "sh010", "--template", "shot"]);
    let examples = crate::support::root().join("examples/shots");
    for documents in [Path::new("sh010.json"), &examples] {
        let output = folder.run(&["check", "--strict", &documents.display().to_string()]);
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && said.contains("nothing is wrong"), "{said}");
    }
}

/// A triangle whose file has a camera, 2 units up.
const FILMED: &str = concat!(
    r#"{"asset": {"version": "2.0"}, "scenes": [{"nodes": [0, 1]}], "scene": 0,
    "nodes": [{"mesh": 0}, {"camera": 0, "translation": [0, 2, 3]}],
    "cameras": [{"type": "perspective", "name": "walk",
        "perspective": {"yfov": 0.5, "aspectRatio": 1.5, "znear": 0.1}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
        "min": [0, 0, 0], "max": [1, 1, 0]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36, "uri": "#,
    r#""data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}"#
);

/// A camera of a shot stands in place of the one that the scene takes from a file; a single value
/// of it stands over that of the file.
#[test]
fn a_shot_stands_over_the_camera_of_a_file() {
    let camera = |fields: Json, overrides: Json| {
        let mut scene = scene();
        scene["objects"][0]["mesh"] = json!("hero.gltf");
        scene["file_camera"] = json!({"object": "hero", "name": "walk"});
        let shot = shot("scene.json", fields, overrides).to_string();
        let mut files = MemoryFiles::default();
        let all = [("shot.json", shot), ("scene.json", scene.to_string())];
        let all = all.into_iter().chain([("look.json", look().to_string())]);
        all.for_each(|(name, text)| files.add(name, text));
        files.add("hero.gltf", FILMED);
        let mut assets = Assets::of(&AssetStore::reading_from(Arc::new(files)));
        let setup = open(Path::new("shot.json"), None, &mut assets).unwrap().value;
        setup.posed(0.5).scene.camera
    };
    let of_file = camera(json!({}), json!([]));
    assert!((of_file.fov - 0.5).abs() < 1e-9, "{of_file:?}");
    let own = camera(json!({"camera": {"eye": [0, 0, 7], "fov": 0.3}}), json!([]));
    assert_eq!((own.eye, own.fov), ([0.0, 0.0, 7.0], 0.3));
    let wider = camera(json!({}), json!([{"target": "camera.fov", "value": 0.8}]));
    assert_eq!((wider.fov, wider.eye), (0.8, of_file.eye));
    let keys = json!([{"target": "camera.fov", "keys": [key(0, 0.4), key(24, 0.8)]}]);
    let keyed = camera(json!({"frames": [0, 24], "rate": 24}), keys);
    assert!((keyed.fov - 0.6).abs() < 1e-9 && keyed.eye == of_file.eye, "{keyed:?}");
    let cut = json!([{"target": "file_camera.name", "keys": [
        {"frame": 0, "value": "nobody"}, {"frame": 12, "value": "walk"}
    ]}]);
    let cut = camera(json!({"frames": [0, 24], "rate": 24}), cut);
    assert_eq!(cut.eye, of_file.eye, "a cut from a camera to another one is keyed");
}

/// A shot needs no words for what it says: its scene where it is begun, its frames on a farm, the
/// time of one frame, the size of what is explained.
#[test]
fn a_shot_says_what_commands_need() {
    let folder = Folder::new();
    fs::create_dir(folder.0.path().join("shots")).unwrap();
    folder.done(&["new", "shots/sh010", "--over", "scene.json"]);
    folder.done(&["new", "shots/sh020", "--over", "shots/sh010.json"]);
    let begun: Json = serde_json::from_str(&folder.read("shots/sh010.json")).unwrap();
    assert_eq!((&begun["scene"], &begun["frames"]), (&json!("../scene.json"), &json!([1, 24])));
    let nested: Json = serde_json::from_str(&folder.read("shots/sh020.json")).unwrap();
    assert_eq!((&nested["scene"], nested.get("frames")), (&json!("sh010.json"), None));
    folder.done(&["check", "--strict", "shots/sh010.json", "shots/sh020.json"]);
    let refused = folder.run(&["new", "x", "--over", "look.json"]);
    assert!(String::from_utf8_lossy(&refused.stderr).contains("over a scene or a shot"));

    let fields = json!({"frames": [1, 24], "rate": 24, "size": [24, 16], "step": 2});
    let overrides = json!([{"target": "lights.key.intensity", "keys": [key(1, 0), key(24, 3)]}]);
    folder.write("shot.json", &shot("scene.json", fields, overrides.clone()));
    let farm = |more: &[&str]| {
        let words = ["farm", "shot.json", "-o", "####.exr", "--to", "slurm"];
        let output = folder.run(&[&words[..], more].concat());
        assert!(output.status.success(), "{output:?}");
        let [out, err] = [output.stdout, output.stderr].map(|it| String::from_utf8(it).unwrap());
        (out, err)
    };
    let (job, warned) = farm(&["--chunk", "4"]);
    assert!(job.contains("1-4") && job.contains("21-24") && warned.is_empty(), "{job}\n{warned}");
    let (_, warned) = farm(&["--chunk", "3", "--frames", "1-48"]);
    assert!(warned.contains("1 to 24") && warned.contains("--chunk 4"), "{warned}");
    // A task has as many frames as the shot says, or what lies under it, unless it is asked.
    let fields = json!({"frames": [1, 24], "rate": 24, "size": [24, 16], "step": 2, "chunk": 6});
    folder.write("sequence.json", &shot("scene.json", fields, overrides.clone()));
    let chunks = |job: &str, [first, last]: [&str; 2]| {
        assert!(job.contains(first) && job.contains(last), "{job}");
    };
    let over = |fields: Json| folder.write("shot.json", &shot("sequence.json", fields, json!([])));
    over(json!({}));
    chunks(&farm(&[]).0, ["1-6", "19-24"]);
    over(json!({"chunk": 8}));
    chunks(&farm(&[]).0, ["1-8", "17-24"]);
    chunks(&farm(&["--chunk", "12"]).0, ["1-12", "13-24"]);
    let fields = json!({"frames": [1, 24], "rate": 24, "size": [24, 16], "step": 2});
    folder.write("shot.json", &shot("scene.json", fields, overrides));
    chunks(&farm(&[]).0, ["1-10", "21-24"]);

    let time = |words: &[&str]| -> Json {
        let words = ["render", "shot.json", "-o", "a.png", "--json", "--samples", "1", "--force"]
            .into_iter()
            .chain(words.iter().copied());
        let told = folder.done(&words.collect::<Vec<_>>());
        serde_json::from_str::<Json>(&told).unwrap()["time"].clone()
    };
    assert_eq!(time(&["--frames", "12"]), json!(0.5));
    let explained = |words: &[&str]| folder.done(&[&["explain", "shot.json"], words].concat());
    assert!(explained(&[]).contains("24x16"), "{}", explained(&[]));
    assert!(explained(&["--size", "48x32"]).contains("48x32"));
}
