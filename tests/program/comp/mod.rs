//! Compositors' documents: what they put together is the picture, and its regrade.
//!
//! Nuke is not here: its script is read and computed as its manual says. Blender's is run by
//! Blender as a module of Python, where `scripts/setup blender` has fetched it.

mod nuke;

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

use chiaro::film::exr::{self, ExrContent};
use serde_json::json;

use crate::support::{root, validators::say};
use nuke::NukeScript;

/// Gains of a regrade.
const GAINS: [(&str, [f64; 3]); 2] = [("key", [1.5, 0.9, 0.25]), ("rim", [0.0, 2.0, 1.0])];

/// A folder with a look of two layers over a base, of a light each.
struct Stage(tempfile::TempDir);

impl Stage {
    fn new(space: &str) -> Self {
        let stage = Self(tempfile::tempdir().unwrap());
        let layer = |light: &str, mode: &str, color: [f64; 4]| {
            json!({"id": light, "kind": "light_layer", "values": {
                "light": light, "blend": mode, "convex": color, "concave": color, "falloff": 1.5
            }})
        };
        let key = |time: f64, red: f64| json!({"time": time, "value": [red, 0.1, 0.3, 1.0]});
        let look = json!({
            "chiaro": "look", "version": 1, "name": "Two", "color_space": space,
            "lights": {
                "key": {"direction": [-0.5, 0.6, 0.6]},
                "rim": {"direction": [0.8, 0.2, -0.3]}
            },
            "nodes": [
                {"id": "base", "kind": "base", "values": {"color": [0.2, 0.1, 0.3, 1]}},
                layer("key", "alpha", [0.9, 0.7, 0.5, 0.8]),
                layer("rim", "add", [0.2, 0.5, 0.9, 1.0]),
                {"id": "output", "kind": "output"}
            ],
            "wires": [
                {"from": "base", "to": "key.below"}, {"from": "key.below", "to": "rim.below"},
                {"from": "rim.below", "to": "output.color"}
            ],
            "time_keys": [{"target": "base.color", "keys": [key(0.0, 0.2), key(1.0, 0.9)]}]
        });
        fs::write(stage.path("look.json"), look.to_string()).unwrap();
        stage
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn run(&self, arguments: &[&str]) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_chiaro"));
        command.env("CHIARO_CACHE_DIR", "").current_dir(self.0.path()).args(arguments);
        command.output().unwrap()
    }

    #[track_caller]
    fn done(&self, arguments: &[&str]) -> String {
        let ran = self.run(arguments);
        let said = String::from_utf8_lossy(&ran.stderr).into_owned();
        assert!(ran.status.success(), "{arguments:?}: {said}");
        said
    }

    #[track_caller]
    fn fails(&self, code: i32, arguments: &[&str]) -> String {
        let ran = self.run(arguments);
        let said = String::from_utf8_lossy(&ran.stderr).into_owned();
        assert_eq!(ran.status.code(), Some(code), "{arguments:?}: {said}");
        said
    }

    /// Draws by the reference, which needs no driver.
    #[track_caller]
    fn render(&self, more: &[&str]) {
        let render = ["render", "look.json", "--mesh", "shape:sphere", "--size", "32x24"];
        let smoothly = ["--samples", "4", "--on", "reference"];
        self.done(&[&render[..], &smoothly, more].concat());
    }

    fn read(&self, name: &str) -> ExrContent {
        exr::decode(&fs::read(self.path(name)).unwrap()).unwrap()
    }
}

fn numbers<'c>(content: &'c ExrContent, name: &str) -> &'c [f32] {
    let found = content.channels.iter().find(|(known, _)| known == name);
    &found.unwrap_or_else(|| panic!("no channel {name}")).1
}

fn encoded(light: f64) -> f64 {
    if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 }
}

fn decoded(shown: f64) -> f64 {
    if shown <= 0.04045 { shown / 12.92 } else { ((shown + 0.055) / 1.055).powf(2.4) }
}

/// A regrade of lights, computed from a file alone: red, green, blue and alpha.
fn regraded(content: &ExrContent, is_display: bool, gains: &[(&str, [f64; 3])]) -> [Vec<f64>; 4] {
    let alpha: Vec<f64> = numbers(content, "A").iter().map(|a| f64::from(*a)).collect();
    let color = |place: usize| {
        let name = ["R", "G", "B"][place];
        let of = |layer: &str| numbers(content, &format!("{layer}{name}"));
        let (picture, beauty) = (of(""), of("beauty."));
        let pixel = |at: usize| {
            let (cover, light) = (alpha[at], f64::from(picture[at]));
            let is_seen = is_display && cover > 0.0;
            let into = if is_seen { encoded(light / cover) * cover } else { light };
            let mut sum = into - f64::from(beauty[at]);
            for light in ["key", "rim", "unlit"] {
                let gain = gains.iter().find(|(name, _)| *name == light);
                let gain = gain.map_or(1.0, |(_, gain)| gain[place]);
                sum += gain * f64::from(of(&format!("light_{light}."))[at]);
            }
            if is_seen { decoded(sum / cover) * cover } else { sum }
        };
        (0..picture.len()).map(pixel).collect()
    };
    [color(0), color(1), color(2), alpha]
}

/// Steps of 16 bits by which two pictures differ at most, near 1.
fn steps_apart(made: &[Vec<f64>; 4], wanted: &[Vec<f64>; 4]) -> f64 {
    let pairs = made.iter().zip(wanted).flat_map(|(a, b)| {
        assert_eq!(a.len(), b.len());
        a.iter().zip(b)
    });
    pairs.map(|(a, b)| (a - b).abs() / b.abs().max(1.0)).fold(0.0, f64::max) * 2048.0
}

fn picture_of(content: &ExrContent) -> [Vec<f64>; 4] {
    let of = |name: &str| numbers(content, name).iter().map(|x| f64::from(*x)).collect();
    ["R", "G", "B", "A"].map(of)
}

#[test]
fn a_nuke_script_gives_the_picture_and_its_regrade() {
    // A transparent picture as shown, and one of light over a backdrop.
    for (space, backdrop) in [("display", "none"), ("linear", "#406080")] {
        let stage = Stage::new(space);
        let asked = ["--aov", "lights", "--matte", "objects,looks", "--backdrop", backdrop];
        stage.render(&[&asked[..], &["-o", "a.####.exr", "--frames", "3-4"]].concat());
        let said = stage.done(&["comp", "a.####.exr", "--to", "nuke", "-o", "comp.nk"]);
        assert!(said.contains("key, rim, unlit add up to beauty"), "{said}");
        let text = fs::read_to_string(stage.path("comp.nk")).unwrap();
        let script = NukeScript::parse(&text).unwrap_or_else(|problem| panic!("{problem}: {text}"));
        let read = script.node("Read_picture");
        assert_eq!(
            [read.knob("file"), read.knob("first"), read.knob("last")],
            ["a.####.exr", "3", "4"]
        );
        assert_eq!(script.node("Write_result").knob("file"), "regrade/####.exr");
        let mattes = script.nodes.iter().filter(|node| node.class == "Cryptomatte").count();
        assert_eq!(mattes, 2);
        let content = stage.read("a.0003.exr");
        let made = script.result(&content).unwrap();
        let apart = steps_apart(&made, &picture_of(&content));
        assert!(apart <= 4.0, "{space}: {apart} steps from the picture");
        let mut script = script;
        for (light, [r, g, b]) in GAINS {
            script.set(&format!("gain_{light}"), "value", &format!("{r} {g} {b} 1"));
        }
        let made = script.result(&content).unwrap();
        let apart = steps_apart(&made, &regraded(&content, space == "display", &GAINS));
        assert!(apart <= 0.01, "{space}: {apart} steps from the regrade");
        let changed = steps_apart(&made, &picture_of(&content));
        assert!(changed > 100.0, "{space}: the gains change the picture, by {changed} steps");
    }
}

#[test]
fn a_document_that_would_be_wrong_is_refused() {
    let stage = Stage::new("display");
    stage.render(&["-o", "plain.exr"]);
    let comp = |file: &str, more: &[&str]| {
        let file = file.to_owned();
        stage.fails(1, &[&["comp", file.as_str(), "--to", "nuke"][..], more].concat())
    };
    assert!(comp("plain.exr", &[]).contains("--aov lights"));
    stage.render(&["-o", "lit.exr", "--aov", "lights", "--aov", "layers"]);
    assert!(comp("lit.exr", &["--layers", "light_kye"]).contains("light_key"));
    // A document in place of its frames is a wrong argument.
    let said = stage.fails(2, &["comp", "look.json", "--to", "nuke"]);
    assert!(said.contains("chiaro render look.json"), "{said}");
    let said = stage.fails(2, &["comp", "lit.exr", "--to", "nuke", "-o", "comp.py"]);
    assert!(said.contains("comp.nk"), "{said}");
    assert!(stage.fails(2, &["comp", "lit.exr", "--to", "fusion"]).contains("nuke, blender"));
    fs::write(stage.path("mine.nk"), "mine").unwrap();
    let over = ["comp", "lit.exr", "--to", "nuke", "-o", "mine.nk"];
    assert!(stage.fails(1, &over).contains("there already"));
    stage.done(&[&over[..], &["--force"]].concat());
    // A script that nobody changed is made again, for other layers too.
    let of_others = [&over[..], &["--layers", "layer_Base,layer_key,layer_rim"]].concat();
    stage.done(&of_others);
    let made = fs::read_to_string(stage.path("mine.nk")).unwrap();
    fs::write(stage.path("mine.nk"), made.replacen("gain", "loss", 1)).unwrap();
    assert!(stage.fails(1, &of_others).contains("there already"));
    // Layers by themselves, on standard output.
    let layers = ["comp", "lit.exr", "--to", "nuke", "--layers", "layer_Base,layer_key,layer_rim"];
    let ran = stage.run(&layers);
    let text = String::from_utf8(ran.stdout).unwrap();
    let script = NukeScript::parse(&text).unwrap();
    assert_eq!(script.node("gain_Base").class, "Multiply");
}

#[test]
fn blenders_compositor_gives_the_picture_and_its_regrade() {
    let python = root().join(".tools/bpy/bin/python");
    if !python.is_file() {
        say("SKIPPED: Blender is not here: run scripts/setup blender");
        return;
    }
    let stage = Stage::new("display");
    let asked = ["--aov", "lights", "--matte", "objects", "--depth", "float"];
    stage.render(&[&asked[..], &["-o", "a.####.exr", "--frames", "3-4"]].concat());
    fs::create_dir(stage.path("comp")).unwrap();
    let comp = ["comp", "a.####.exr", "--to", "blender", "-o", "comp/comp.py"];
    stage.done(&comp);
    let blender = |more: &[&str]| {
        let mut command = Command::new(&python);
        command.current_dir(stage.path("")).args(["comp/comp.py", "--", "--render"]).args(more);
        let ran = command.output().unwrap();
        let said = [ran.stdout, ran.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
        (ran.status.success(), said.concat())
    };
    let (is_done, said) = blender(&["--save", "comp.blend"]);
    assert!(is_done && stage.path("comp.blend").is_file(), "{said}");
    let pictures = [3, 4].map(|frame| {
        let content = stage.read(&format!("a.{frame:04}.exr"));
        let made = picture_of(&stage.read(&format!("comp/regrade/{frame:04}.exr")));
        let apart = steps_apart(&made, &picture_of(&content));
        assert!(apart <= 4.0, "frame {frame}: {apart} steps from the picture");
        made
    });
    assert!(steps_apart(&pictures[0], &pictures[1]) > 4.0, "each frame is its own");
    let [key, rim] = GAINS.map(|(light, [r, g, b])| format!("{light}={r},{g},{b}"));
    let (is_done, said) = blender(&["--gain", &key, "--gain", &rim]);
    assert!(is_done, "{said}");
    let content = stage.read("a.0004.exr");
    let made = picture_of(&stage.read("comp/regrade/0004.exr"));
    let apart = steps_apart(&made, &regraded(&content, true, &GAINS));
    assert!(apart <= 1.0, "{apart} steps from the regrade");
    let (is_done, said) = blender(&["--gain", "kye=1"]);
    assert!(!is_done && said.contains("key, rest, rim, unlit"), "{said}");
}
