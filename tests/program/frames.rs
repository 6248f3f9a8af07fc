//! Many frames: each whole, equal ones drawn once, those of a run before kept, as PNG and as EXR.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

use chiaro::film::exr;
use serde_json::{Value as Json, json};

/// A folder with a look whose color steps at every second frame.
struct Shot(tempfile::TempDir);

impl Shot {
    fn new() -> Self {
        let shot = Self(tempfile::tempdir().unwrap());
        let key = |frame: i32, red: f64| {
            let time = f64::from(frame) / 24.0;
            json!({"time": time, "value": [red, 0.4, 0.2, 0.5], "interpolation": "stepped"})
        };
        let look = json!({
            "chiaro": "look", "version": 1,
            "nodes": [{"id": "base", "kind": "base"}, {"id": "output", "kind": "output"}],
            "wires": [{"from": "base", "to": "output.color"}],
            "time_keys": [{"target": "base.color", "keys": [key(0, 0.9), key(2, 0.1), key(4, 0.9)]}]
        });
        fs::write(shot.path("look.json"), look.to_string()).unwrap();
        shot
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn run(&self, arguments: &[&str]) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_chiaro"));
        command.env("CHIARO_CACHE_DIR", "").current_dir(self.0.path());
        command.args(["render", "look.json", "--size", "24x16"]);
        command.args(["--samples", "1", "--backdrop", "none", "--mesh", "shape:sphere"]);
        command.args(arguments).output().unwrap()
    }

    /// Draws frames; the lines that tell of them.
    #[track_caller]
    fn frames(&self, arguments: &[&str]) -> Vec<Json> {
        let output = self.run(&[arguments, &["--json"]].concat());
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{said}");
        let lines = String::from_utf8(output.stdout).unwrap();
        lines.lines().map(|line| serde_json::from_str(line).expect("a line of JSON")).collect()
    }

    fn names(&self) -> BTreeSet<String> {
        let entries = fs::read_dir(self.0.path()).unwrap();
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
    }
}

fn states(frames: &[Json]) -> Vec<&str> {
    frames.iter().map(|frame| frame["state"].as_str().unwrap()).collect()
}

#[test]
fn equal_frames_are_drawn_once_and_whole_ones_kept() {
    let shot = Shot::new();
    let frames = shot.frames(&["-o", "a.####.png", "--frames", "0-5"]);
    assert_eq!(states(&frames), ["drawn", "equal", "drawn", "equal", "equal", "equal"]);
    let to: Vec<_> = frames.iter().map(|frame| frame["to"].as_i64()).collect();
    assert_eq!(to, [None, Some(0), None, Some(2), Some(0), Some(0)]);
    assert_eq!(frames[3]["time"], json!(0.125));
    assert_eq!(frames[3]["file"], json!("a.0003.png"));
    assert_eq!((&frames[0]["plan"], &frames[2]["plan"]), (&frames[5]["plan"], &frames[3]["plan"]));
    assert_ne!(frames[0]["plan"], frames[2]["plan"]);
    let bytes = |name: &str| fs::read(shot.path(name)).unwrap();
    assert_eq!(bytes("a.0000.png"), bytes("a.0005.png"));
    assert_ne!(bytes("a.0000.png"), bytes("a.0002.png"));
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt as _;
        let inode = |name: &str| fs::metadata(shot.path(name)).unwrap().ino();
        assert_eq!(inode("a.0000.png"), inode("a.0004.png"), "one file of two names");
    }
    assert_eq!(shot.names().len(), 7, "nothing else is left: {:?}", shot.names());

    // Again: nothing is drawn. Without one of them, and in another order, that one alone.
    let frames = shot.frames(&["-o", "a.####.png", "--frames", "0-5"]);
    assert_eq!(states(&frames), ["kept"; 6]);
    fs::remove_file(shot.path("a.0002.png")).unwrap();
    let frames = shot.frames(&["-o", "a.####.png", "--frames", "5,2,1"]);
    assert_eq!(states(&frames), ["kept", "drawn", "kept"]);
    // Another camera is another picture.
    let frames = shot.frames(&["-o", "a.####.png", "--frames", "4-5", "--camera", "fov=50"]);
    assert_eq!(states(&frames), ["drawn", "equal"]);
    // Other cuts of the same frames have the same plans, whatever the machine has drawn before.
    let frames = shot.frames(&["-o", "b.#.png", "--frames", "0-4x2"]);
    assert_eq!(states(&frames), ["drawn", "drawn", "equal"]);
}

#[test]
fn frames_of_film_are_premultiplied_light_with_a_stamp() {
    let shot = Shot::new();
    let frames = shot.frames(&["-o", "a.###.exr", "--frames", "0-1", "--rate", "23.976"]);
    assert_eq!(states(&frames), ["drawn", "equal"]);
    shot.frames(&["-o", "a.###.png", "--frames", "0"]);
    let png = image::open(shot.path("a.000.png")).unwrap().to_rgba8();
    let read = |name: &str| exr::decode(&fs::read(shot.path(name)).unwrap()).unwrap();
    let (first, second) = (read("a.000.exr"), read("a.001.exr"));
    assert_eq!(first.size, [24, 16]);
    assert_eq!(first.channels, second.channels);
    let names: Vec<_> = first.channels.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["A", "B", "G", "R"]);
    let channel = |at: usize| &first.channels[at].1;
    let mut covered = 0;
    for (at, pixel) in png.pixels().enumerate() {
        let alpha = f64::from(channel(0)[at]);
        assert!((alpha - f64::from(pixel[3]) / 255.0).abs() <= 0.5 / 255.0 + 1e-3);
        for (shown, at_channel) in [(pixel[0], 3), (pixel[1], 2), (pixel[2], 1)] {
            let light = f64::from(channel(at_channel)[at]) / alpha.max(1e-9);
            let encoded = if light <= 0.003_130_8 {
                12.92 * light
            } else {
                1.055 * light.powf(1.0 / 2.4) - 0.055
            };
            if alpha > 0.0 {
                covered += 1;
                assert!((encoded * 255.0 - f64::from(shown)).abs() <= 0.8, "{encoded} {shown}");
            }
        }
    }
    assert!(covered > 100, "the sphere is seen");
    // The stamp differs, and each file is kept for what it is.
    assert_ne!(
        fs::read(shot.path("a.000.exr")).unwrap(),
        fs::read(shot.path("a.001.exr")).unwrap()
    );
    let again = ["-o", "a.###.exr", "--frames", "0-1", "--rate", "23.976"];
    assert_eq!(states(&shot.frames(&again)), ["kept", "kept"]);
    let float = [&again[..], &["--depth", "float", "--compression", "piz"]].concat();
    assert_eq!(states(&shot.frames(&float)), ["drawn", "equal"]);
}

#[test]
fn wrong_frames_are_told_before_anything_is_drawn() {
    let shot = Shot::new();
    let refused = |arguments: &[&str], code: i32, told: &str| {
        let output = shot.run(arguments);
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{arguments:?}: {said}");
        assert!(said.contains(told), "{arguments:?}: {said}");
    };
    refused(&["-o", "a.png", "--frames", "1-4"], 2, "a.####.png");
    refused(&["-o", "a.####.png"], 2, "--frames 1-48");
    refused(&["-o", "a.####.png", "--frames", "4-1"], 2, "before its first");
    refused(&["-o", "a.####.png", "--frames", "1-4", "--rate", "0"], 2, "24000/1001");
    refused(&["-o", "##/##.png", "--frames", "1-4"], 2, "two places");
    refused(&["-o", "none/##.png", "--frames", "1-4"], 1, "there is no folder");
    refused(&["-o", "a.####.jpg", "--frames", "1-4"], 1, "PNG or EXR");
    fs::write(shot.path("a.0003.exr"), "somebody's").unwrap();
    refused(&["-o", "a.####.exr", "--frames", "3"], 1, "a.0003.exr");
    assert_eq!(shot.names().len(), 2, "{:?}", shot.names());
}

/// A frame whose file is not ours, or damaged, keeps no other from being drawn.
#[test]
fn frames_that_fail_are_told_at_the_end_and_the_others_are_drawn() {
    let shot = Shot::new();
    fs::write(shot.path("a.0002.exr"), "somebody's").unwrap();
    let output = shot.run(&["-o", "a.####.exr", "--frames", "1-4", "--json"]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(1), "{said}");
    let lines = String::from_utf8(output.stdout).unwrap();
    let frames: Vec<Json> =
        lines.lines().map(|line| serde_json::from_str(line).expect("a line of JSON")).collect();
    // Frame 3 is the picture that frame 2 would be, and frame 4 that of frame 1.
    assert_eq!(states(&frames), ["drawn", "failed", "drawn", "equal"], "{said}");
    assert_eq!(frames[1]["problems"][0]["code"], json!("file-exists"));
    let last = said.lines().last().unwrap_or_default();
    assert!(last.contains("1 of 4 frames failed: 2; a.0002.exr: "), "{said}");
    let [reading, compiling] = ["reading look.json ...", "compiling ..."].map(|line| {
        said.lines().position(|told| told == line).unwrap_or_else(|| panic!("{line}: {said}"))
    });
    assert!(reading < compiling, "{said}");
    assert_eq!(fs::read(shot.path("a.0002.exr")).unwrap(), b"somebody's");
    // What is mended is drawn by the same command; the others are kept.
    fs::remove_file(shot.path("a.0002.exr")).unwrap();
    let frames = shot.frames(&["-o", "a.####.exr", "--frames", "1-4"]);
    assert_eq!(states(&frames), ["kept", "drawn", "kept", "kept"]);
}

/// A mesh that moves is another picture in each frame, and the same one where its animation holds
/// or comes around; what stands still beside it is not read again.
#[test]
fn frames_of_an_animated_mesh_are_equal_where_its_poses_are() {
    let shot = Shot::new();
    let sprout = crate::support::root().join("examples/meshes/sprout.glb");
    let scene = |name: &str, animation: Json| {
        let object = json!({"id": "sprout", "mesh": sprout, "looks": "look.json",
            "animation": animation});
        let scene = json!({"chiaro": "scene", "version": 1, "objects": [object],
            "camera": {"eye": [0, 0, 4]}});
        fs::write(shot.path(name), scene.to_string()).unwrap();
        let mut command = Command::new(env!("CARGO_BIN_EXE_chiaro"));
        command.env("CHIARO_CACHE_DIR", "").current_dir(shot.0.path());
        command.args(["render", name, "--size", "24x16", "--samples", "1", "--rate", "1"]);
        command.args(["-o", &format!("{name}.##.png"), "--frames", "0-6x2,7", "--json"]);
        let output = command.output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{said}");
        let lines = String::from_utf8(output.stdout).unwrap();
        let frames: Vec<Json> =
            lines.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
        let same: Vec<_> = frames.iter().map(|frame| frame["to"].as_i64()).collect();
        (same, said.into_owned())
    };
    // The look is of one color by time, the same in all of these frames.
    let look = json!({"chiaro": "look", "version": 1,
        "nodes": [{"id": "noise", "kind": "noise"}, {"id": "output", "kind": "output"}],
        "wires": [{"from": "noise", "to": "output.color"}]});
    fs::write(shot.path("look.json"), look.to_string()).unwrap();
    // The animation takes 4 seconds, and ends as it begins.
    let (same, said) = scene("around.json", json!({"name": "sway"}));
    assert_eq!(same, [None, None, Some(0), Some(2), None], "{said}");
    let (same, _) = scene("once.json", json!({"loops": false}));
    assert!(same[3].is_some() && same[3..] == [same[3]; 2], "{same:?}");
    let (same, _) = scene("held.json", json!({"speed": 0, "offset": 1.25}));
    assert_eq!(same, [None, Some(0), Some(0), Some(0), Some(0)]);
    let (same, said) = scene("none.json", json!({"name": "swim"}));
    assert_eq!(same, [None, Some(0), Some(0), Some(0), Some(0)]);
    assert!(said.contains("no-animation") && said.contains("sway"), "{said}");
}

#[test]
fn a_mesh_file_tells_what_it_plays() {
    let sprout = crate::support::root().join("examples/meshes/sprout.glb");
    let told = |more: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_chiaro"));
        let output = command.arg("mesh").arg(&sprout).args(more).output().unwrap();
        assert!(output.status.success(), "{output:?}");
        String::from_utf8(output.stdout).unwrap()
    };
    let json: Json = serde_json::from_str(&told(&["--json"])).unwrap();
    assert_eq!(json["animations"], json!([{"name": "sway", "seconds": 4.0}]));
    assert_eq!(json["cameras"][0]["name"], "shot");
    assert_eq!((&json["triangles"], &json["has_uvs"]), (&json!(6144), &json!(true)));
    let text = told(&[]);
    assert!(text.contains("animation `sway`: 4.000 s") && text.contains("camera `shot`"), "{text}");
}
