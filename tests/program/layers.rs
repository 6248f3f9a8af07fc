//! Layers beside the picture: outputs of nodes, contributions that add up, mattes.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use chiaro::compile::{AovSource, CompileOptions, compile};
use chiaro::document::Look;
use chiaro::film::exr::{self, ExrContent, SampleType};
use chiaro::library::Library;
use serde_json::{Value as Json, json};

use crate::support::{root, validators::film_judge};

/// A folder in which pictures are rendered.
struct RenderFolder(tempfile::TempDir);

impl RenderFolder {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// A look of two layers over a base, of a light each, and a scene in which two objects wear it.
    fn with_scene() -> Self {
        let folder = Self::new();
        let layer = |light: &str, mode: &str, color: [f64; 4]| {
            json!({"id": light, "kind": "light_layer", "name": light.to_uppercase(), "values": {
                "light": light, "blend": mode, "convex": color, "concave": color, "falloff": 1.5
            }})
        };
        let look = json!({
            "chiaro": "look", "version": 1, "name": "Two",
            "lights": {
                "key": {"direction": [-0.5, 0.6, 0.6], "groups": ["front"]},
                "rim": {"direction": [0.8, 0.2, -0.3], "groups": ["back"]}
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
            ]
        });
        let object = |id: &str, x: f64| {
            json!({"id": id, "mesh": "shape:sphere", "looks": {"*": "look.json"},
                "transform": {"translate": [x, 0.0, 0.0]}})
        };
        let scene = json!({
            "chiaro": "scene", "version": 1, "objects": [object("left", -0.7), object("right", 0.7)]
        });
        fs::write(folder.path("look.json"), look.to_string()).unwrap();
        fs::write(folder.path("scene.json"), scene.to_string()).unwrap();
        folder
    }

    fn run(&self, document: &Path, arguments: &[&str]) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_chiaro"));
        command.env("CHIARO_CACHE_DIR", "").current_dir(self.0.path()).arg("render").arg(document);
        for default in [["--backdrop", "none"], ["--size", "48x40"]] {
            if !arguments.contains(&default[0]) {
                command.args(default);
            }
        }
        command.args(arguments).output().unwrap()
    }

    /// Renders a picture with layers.
    #[track_caller]
    fn layers(&self, document: &Path, arguments: &[&str]) -> FileLayers {
        let output = self.run(document, &[arguments, &["-o", "out.exr", "--force"]].concat());
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{}: {said}", document.display());
        let content = exr::decode(&fs::read(self.path("out.exr")).unwrap()).unwrap();
        assert!(content.is_sealed);
        FileLayers(content)
    }
}

/// Layers of a file.
struct FileLayers(ExrContent);

impl FileLayers {
    #[track_caller]
    fn channel(&self, name: &str) -> &[f32] {
        let found = self.0.channels.iter().find(|(channel, _)| channel == name);
        &found.unwrap_or_else(|| panic!("no channel {name} in {:?}", self.names())).1
    }

    fn names(&self) -> Vec<&str> {
        self.0.channels.iter().map(|(name, _)| name.as_str()).collect()
    }

    /// Channels of layers whose names begin so.
    fn beginning(&self, with: &str, channel: &str) -> Vec<&[f32]> {
        let wanted =
            self.0.channels.iter().filter(|(name, _)| {
                name.starts_with(with) && name.ends_with(&format!(".{channel}"))
            });
        wanted.map(|(_, numbers)| numbers.as_slice()).collect()
    }

    /// The greatest difference between the sum of some layers and the whole, in halves' steps for
    /// each layer; all of them are 0 or more.
    #[track_caller]
    fn worst_sum(&self, parts: &str, whole: &str) -> f64 {
        let mut worst = 0.0_f64;
        for channel in ["R", "G", "B"] {
            let parts = self.beginning(parts, channel);
            assert!(!parts.is_empty());
            let whole = self.channel(&format!("{whole}.{channel}"));
            for (pixel, whole) in whole.iter().enumerate() {
                let sum: f64 = parts.iter().map(|part| f64::from(part[pixel])).sum();
                assert!(parts.iter().all(|part| part[pixel] >= 0.0), "a contribution is negative");
                let step = 2.0_f64.powi(-11) * f64::from(whole.abs().max(0.25));
                worst =
                    worst.max((sum - f64::from(*whole)).abs() / step / (parts.len() + 1) as f64);
            }
        }
        worst
    }
}

fn example(name: &str) -> PathBuf {
    root().join("examples/looks").join(name)
}

#[test]
fn contributions_of_layers_and_lights_are_the_picture() {
    let folder = RenderFolder::with_scene();
    let asked = ["--aov", "layers", "--aov", "lights-by-layer", "--naming", "nuke"];
    let drawn = folder.layers(&folder.path("scene.json"), &asked);
    let names: Vec<_> = drawn.names().into_iter().filter(|name| name.ends_with(".R")).collect();
    let expected = [
        "beauty.R",
        "layer_Base.R",
        "layer_KEY.R",
        "layer_RIM.R",
        "light_key_KEY.R",
        "light_rim_RIM.R",
        "light_unlit_Base.R",
    ];
    assert_eq!(names, expected);
    assert!(drawn.worst_sum("layer_", "beauty") <= 1.0);
    assert!(drawn.worst_sum("light_", "beauty") <= 1.0);
    // What is display-referred is written as the look blends it: the picture itself is light.
    let (shown, alpha) = (drawn.channel("beauty.R"), drawn.channel("A"));
    for (pixel, light) in drawn.channel("R").iter().enumerate().filter(|(at, _)| alpha[*at] > 0.9) {
        let straight = f64::from(shown[pixel] / alpha[pixel]);
        let decoded = ((straight + 0.055) / 1.055).powf(2.4) * f64::from(alpha[pixel]);
        assert!((decoded - f64::from(*light)).abs() < 4e-3, "{decoded} {light}");
    }
    // A light that is out adds nothing, and the others what they did.
    let arnold = ["--aov", "groups", "--naming", "arnold"];
    let groups = folder.layers(&folder.path("scene.json"), &arnold);
    assert!(groups.worst_sum("RGBA_", "RGBA") <= 1.0);
    assert_eq!(groups.beginning("RGBA_", "R").len(), 3, "{:?}", groups.names());
}

#[test]
fn groups_of_lights_are_told_apart_within_each_layer() {
    let folder = RenderFolder::with_scene();
    let path = folder.path("look.json");
    let mut look: Json = serde_json::from_slice(&fs::read(&path).unwrap()).unwrap();
    // A second layer of the back, by a lamp of its own.
    look["lights"]["kick"] = json!({"direction": [-0.8, -0.2, 0.1], "groups": ["back"]});
    let values = json!({"light": "kick", "blend": "alpha", "convex": [0.4, 0.1, 0.1, 0.6]});
    let kick = json!({"id": "kick", "kind": "light_layer", "name": "KICK", "values": values});
    look["nodes"].as_array_mut().unwrap().push(kick);
    look["wires"][2]["to"] = json!("kick.below");
    let last = json!({"from": "kick.below", "to": "output.color"});
    look["wires"].as_array_mut().unwrap().push(last);
    fs::write(&path, look.to_string()).unwrap();
    let asked = ["--on", "reference", "--size", "24x20", "--aov", "groups-by-layer"];
    let drawn = folder.layers(&folder.path("scene.json"), &asked);
    let names: Vec<_> = drawn.names().into_iter().filter(|name| name.ends_with(".R")).collect();
    let expected = [
        "beauty.R",
        "group_back_KICK.R",
        "group_back_RIM.R",
        "group_front_KEY.R",
        "group_unlit_Base.R",
    ];
    assert_eq!(names, expected);
    for layer in &expected[1..] {
        assert!(drawn.channel(layer).iter().any(|red| *red > 0.02), "{layer} shows something");
    }
    assert!(drawn.worst_sum("group_", "beauty") <= 1.0);
    // What a group adds within its layers is what it adds.
    let groups =
        folder.layers(&folder.path("scene.json"), &[&asked[..], &["--aov", "groups"]].concat());
    assert!(groups.worst_sum("group_back_", "group_back") <= 1.0);
    let listed = folder.run(&folder.path("scene.json"), &["--list-aovs"]);
    let listed = String::from_utf8(listed.stdout).unwrap();
    let row = listed.lines().find(|line| line.starts_with("  --aov groups-by-layer  "));
    assert!(row.is_some_and(|row| row.contains("group_back_KICK")), "{listed}");
}

#[test]
fn contributions_of_examples_add_up() {
    // Clamps, modes of both kinds of blends, lights in a group that runs for each, a limit.
    for look in ["figure6-comics", "lights-summed", "hatching", "room-walls"] {
        let folder = RenderFolder::new();
        // A sphere, which takes no time to make.
        let asked = ["--aov", "layers", "--mesh", "shape:sphere"];
        let drawn = folder.layers(&example(&format!("{look}.json")), &asked);
        let worst = drawn.worst_sum("layer_", "beauty");
        assert!(worst <= 1.0, "{look}: {worst} half-steps a layer");
    }
}

/// All looks, both spaces, by our reader and by OpenImageIO: minutes. By the reference, which
/// compiles nothing (software for a GPU takes up to minutes for a module with all of its layers),
/// and small, for what adds up in one pixel does so in all of its kind.
#[cfg(unix)]
#[test]
#[ignore = "a soak: every look in both spaces"]
fn soak_contributions_of_all_looks_add_up() {
    let small = ["--on", "reference", "--mesh", "shape:torus", "--size", "16x12"];
    let asked = [&ALL_LAYERS[..], &small].concat();
    let folder = RenderFolder::new();
    let (mut greatest, mut files) = (BTreeMap::new(), Vec::new());
    for kind in ["looks", "shadows"] {
        let beside = folder.path(kind);
        fs::create_dir_all(&beside).unwrap();
        for other in ["hcbtf", "images"] {
            let link = folder.path(other);
            if !link.exists() {
                std::os::unix::fs::symlink(root().join("examples").join(other), link).unwrap();
            }
        }
        for entry in fs::read_dir(root().join("examples").join(kind)).unwrap() {
            let path = entry.unwrap().path();
            for space in ["display", "linear"] {
                let mut look: Json = serde_json::from_slice(&fs::read(&path).unwrap()).unwrap();
                look["color_space"] = json!(space);
                let own = beside.join(path.file_name().unwrap());
                fs::write(&own, look.to_string()).unwrap();
                let drawn = folder.layers(&own, &asked);
                let is_parted = drawn.names().contains(&"beauty.R");
                let whole = if is_parted { "beauty" } else { "beauty_stack" };
                let parts = ["layer_", "light_", "group_"];
                let worst = parts.map(|parts| drawn.worst_sum(parts, whole));
                greatest.insert((path.clone(), space), worst.into_iter().fold(0.0, f64::max));
                let file = own.with_extension(format!("{space}.exr"));
                fs::rename(folder.path("out.exr"), &file).unwrap();
                files.push(file);
            }
        }
    }
    assert!(greatest.len() > 160, "{} pictures", greatest.len());
    assert!(greatest.values().all(|worst| *worst <= 1.0), "{greatest:#?}");
    for (found, file) in judged(&files).into_iter().flatten().zip(&files) {
        assert_adds_up(&found, file);
    }
}

#[test]
fn an_output_of_a_node_is_a_layer_on_every_executor() {
    let folder = RenderFolder::with_scene();
    let asked = ["--aov", "tone=key.tone", "--aov", "lit=key/lit.color", "--samples", "1"];
    let drawn = folder.layers(&folder.path("scene.json"), &asked);
    let exact = [&asked[..], &["--on", "reference"]].concat();
    let exact = folder.layers(&folder.path("scene.json"), &exact);
    assert_eq!(drawn.names(), exact.names());
    let alpha = drawn.channel("A");
    let mut seen = 0;
    for name in ["tone.V", "lit.R", "lit.G", "lit.B"] {
        let same = alpha.iter().zip(exact.channel("A")).enumerate().filter(|(_, (a, b))| a == b);
        for (pixel, _) in same {
            let (found, truth) = (drawn.channel(name)[pixel], exact.channel(name)[pixel]);
            assert!((found - truth).abs() < 5e-3, "{name} {pixel}: {found} {truth}");
            seen += usize::from(truth > 0.1);
        }
    }
    assert!(seen > 100, "the layers show something");
    // More layers than one draw writes are drawn by further ones, and are the same.
    let many: Vec<String> = (0..20).map(|number| format!("tone{number}=key.tone")).collect();
    let many: Vec<&str> = many.iter().flat_map(|layer| ["--aov", layer]).collect();
    let many =
        folder.layers(&folder.path("scene.json"), &[&many[..], &["--samples", "1"]].concat());
    for number in 0..20 {
        assert_eq!(many.channel(&format!("tone{number}.V")), drawn.channel("tone.V"));
    }
    assert_eq!(many.channel("R"), drawn.channel("R"));
}

#[test]
fn wrong_layers_are_told_before_anything_is_drawn() {
    let folder = RenderFolder::with_scene();
    let refused = |arguments: &[&str], told: &str| {
        let output = folder.run(Path::new("scene.json"), arguments);
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(!output.status.success() && said.contains(told), "{arguments:?}: {said}");
    };
    refused(&["-o", "a.exr", "--aov", "tone=keyy.tone"], "did you mean `key`");
    refused(&["-o", "a.exr", "--aov", "keyy.tone"], "did you mean `key`");
    refused(&["-o", "a.exr", "--aov", "keyy.tone"], "--aov tone=key.tone");
    refused(&["-o", "a.exr", "--aov", "tone=keyy.tone"], "look.json: error[unknown-node]");
    refused(&["-o", "a.exr", "--aov", "key.tone"], "--aov tone=key.tone");
    refused(&["-o", "a.exr", "--aov", "tone=key.tonne"], "did you mean `tone`");
    refused(&["-o", "a.exr", "--aov", "tone=Tow:key.tone"], "did you mean `Two`");
    refused(&["-o", "a.exr", "--aov", "key.tone"], "NAME=NODE.OUTPUT");
    refused(&["-o", "a.exr", "--aov", "a.b=key.tone"], "no name that compositors take");
    refused(&["-o", "a.exr", "--aov", "a=key.tone", "--aov", "a=rim.tone"], "two layers");
    refused(&["-o", "a.png", "--aov", "tone=key.tone"], "a.exr");
    refused(&["-o", "a.exr", "--matte", "lamps"], "objects, looks, materials, lights");
    let listed = folder.run(Path::new("scene.json"), &["--list-aovs"]);
    let listed = String::from_utf8(listed.stdout).unwrap();
    assert!(listed.lines().any(|line| line.starts_with("  Two:key.tone  ")), "{listed}");
    let lights = listed.lines().find(|line| line.starts_with("  --aov lights  ")).unwrap();
    assert!(lights.contains("beauty, ") && lights.contains("light_"), "{lights}");
    let headings = listed.lines().filter(|line| !line.starts_with("  ") && !line.is_empty());
    assert_eq!(headings.count(), 2, "contributions and wires: {listed}");
}

#[test]
fn mattes_cover_what_the_picture_covers_and_frames_are_kept() {
    let folder = RenderFolder::with_scene();
    let asked = ["--matte", "objects,looks,materials"];
    let drawn = folder.layers(&folder.path("scene.json"), &asked);
    let alpha = drawn.channel("A");
    let mut partly = 0;
    for matte in ["CryptoObject", "CryptoLook", "CryptoMaterial"] {
        let coverage = [
            drawn.channel(&format!("{matte}00.G")),
            drawn.channel(&format!("{matte}00.A")),
            drawn.channel(&format!("{matte}01.G")),
            drawn.channel(&format!("{matte}01.A")),
        ];
        for (pixel, alpha) in alpha.iter().enumerate() {
            let sum: f32 = coverage.iter().map(|rank| rank[pixel]).sum();
            assert_eq!(sum, *alpha, "{matte} {pixel}");
            partly += usize::from(sum > 0.0 && sum < 1.0);
        }
    }
    assert!(partly > 50, "edges are smooth");
    let is_float = |(name, samples): (&&str, &SampleType)| {
        !name.starts_with("CryptoObject0") || *samples == SampleType::Float
    };
    assert!(drawn.names().iter().zip(&drawn.0.samples).all(is_float));

    let frames = ["-o", "a.#.exr", "--frames", "1-2", "--json", "--samples", "1"];
    let states = |layers: &[&str]| {
        let output = folder.run(Path::new("scene.json"), &[&frames[..], layers].concat());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let lines = String::from_utf8(output.stdout).unwrap();
        let state = |line: &str| serde_json::from_str::<Json>(line).unwrap()["state"].clone();
        lines.lines().map(state).collect::<Vec<_>>()
    };
    let layers = [&asked[..], &["--aov", "tone=key.tone"]].concat();
    assert_eq!(states(&layers), ["drawn", "equal"]);
    let first = fs::read(folder.path("a.1.exr")).unwrap();
    assert_eq!(states(&layers), ["kept", "kept"]);
    assert_eq!(states(&asked), ["drawn", "equal"]);
    fs::remove_file(folder.path("a.1.exr")).unwrap();
    assert_eq!(states(&layers), ["drawn", "equal"]);
    assert_eq!(fs::read(folder.path("a.1.exr")).unwrap(), first, "equal runs are equal files");
}

#[test]
fn the_matte_of_lights_tells_the_strongest() {
    let folder = RenderFolder::with_scene();
    let asked = ["--matte", "lights", "--aov", "lights", "--samples", "1"];
    let drawn = folder.layers(&folder.path("scene.json"), &asked);
    let strength = |light: &str, pixel: usize| {
        let of = |channel| f64::from(drawn.channel(&format!("light_{light}.{channel}"))[pixel]);
        0.2126 * of("R") + 0.7152 * of("G") + 0.0722 * of("B")
    };
    let lights = ["key", "rim", "unlit"];
    let mut ids = BTreeMap::new();
    for pixel in (0..drawn.channel("A").len()).filter(|pixel| drawn.channel("A")[*pixel] == 1.0) {
        let strengths = lights.map(|light| strength(light, pixel));
        let all: f64 = strengths.iter().sum();
        let greatest = strengths.iter().copied().fold(0.0, f64::max);
        let (id, share) = (drawn.channel("CryptoLight00.R"), drawn.channel("CryptoLight00.G"));
        assert!((f64::from(share[pixel]) - greatest / all).abs() < 2e-3);
        // Where one is stronger by far, the id is its own.
        let strongest = strengths.iter().position(|x| *x == greatest).unwrap();
        if greatest > 0.6 * all {
            let known = *ids.entry(strongest).or_insert(id[pixel].to_bits());
            assert_eq!(known, id[pixel].to_bits(), "{}", lights[strongest]);
        }
    }
    assert!(ids.len() > 1, "several lights are the strongest somewhere");
    // Layers that nobody asked for are not written.
    let alone = folder.layers(&folder.path("scene.json"), &["--matte", "lights"]);
    assert!(alone.names().iter().all(|name| !name.contains("key")), "{:?}", alone.names());
}

/// Findings of others in files, by `tests/film/judge.py`. `None` without them.
fn judged(files: &[PathBuf]) -> Option<Vec<Json>> {
    let mut python = film_judge()?;
    let output = python.arg(root().join("tests/film/judge.py")).args(files).output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    let found: Vec<Json> = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(found.len(), files.len());
    Some(found)
}

/// Checks what others found in a file: all kinds of contributions add up to the picture, and mattes
/// cover what it covers.
#[track_caller]
fn assert_adds_up(found: &Json, file: &Path) {
    let sums = found["sums"].as_object().unwrap();
    assert_eq!(sums.len(), 3, "{}: {found}", file.display());
    for sum in sums.values() {
        let is_within = sum["steps"].as_f64().unwrap() <= 1.0;
        assert!(is_within && sum["least"].as_f64().unwrap() >= 0.0, "{}: {found}", file.display());
    }
    assert_eq!(found["mattes"].as_object().unwrap().len(), 4, "{}: {found}", file.display());
    // What is seen through is in a matte wholly or not at all.
    let is_seen_through = file.to_string_lossy().contains("technical-cutaway");
    let off = found["coverage"].as_f64().unwrap();
    assert!(is_seen_through || off < 1e-6, "{}: {found}", file.display());
}

/// Contributions of all kinds and all mattes.
const ALL_LAYERS: [&str; 8] = [
    "--aov",
    "layers",
    "--aov",
    "lights",
    "--aov",
    "groups",
    "--matte",
    "objects,looks,materials,lights",
];

#[test]
fn others_read_the_layers_and_decode_the_mattes() {
    if film_judge().is_none() {
        return;
    }
    let folder = RenderFolder::with_scene();
    folder.layers(&folder.path("scene.json"), &ALL_LAYERS);
    fs::rename(folder.path("out.exr"), folder.path("scene.exr")).unwrap();
    let mut files = vec![folder.path("scene.exr")];
    let small = ["--on", "reference", "--mesh", "shape:torus", "--size", "16x12"];
    for look in ["figure6-comics", "hatching", "film-print"] {
        let look = example(&format!("{look}.json"));
        folder.layers(&look, &[&ALL_LAYERS[..], &small].concat());
        let file = folder.path(&format!("{}.exr", files.len()));
        fs::rename(folder.path("out.exr"), &file).unwrap();
        files.push(file);
    }
    let found = judged(&files).unwrap();
    for (found, file) in found.iter().zip(&files) {
        assert_adds_up(found, file);
    }
    let mattes = json!({
        "CryptoObject": ["left", "right"], "CryptoLook": ["Two"], "CryptoMaterial": ["default"],
        "CryptoLight": ["key", "rim", "unlit"]
    });
    assert_eq!(found[0]["mattes"], mattes);
    assert_eq!(found[0]["sums"]["layer_"]["layers"], 3);
}

/// A look of two lamps, key and rim, of which `group` makes one color; `wire` leads from there.
fn lamps_look(join: &str, nodes: &[Json], wires: &[Json]) -> Json {
    let of_light =
        |id: &str, kind: &str, values: Json| json!({"id": id, "kind": kind, "values": values});
    let wire = |from: &str, to: &str| json!({"from": from, "to": to});
    let output = if join == "sum_of_lights" { "sum" } else { "greatest" };
    let own = [
        json!({"id": "lamps", "kind": "each_lamp", "for_each": "*"}),
        json!({"id": "output", "kind": "output"}),
    ];
    json!({
        "chiaro": "look", "version": 1, "name": "Lamps",
        "lights": {
            "key": {"direction": [-0.5, 0.6, 0.6], "color": [1.0, 0.8, 0.5], "intensity": 0.6},
            "rim": {"direction": [0.6, 0.3, 0.6], "color": [0.3, 0.6, 1.0], "intensity": 0.4}
        },
        "definitions": {"each_lamp": {
            "outputs": [{"name": "color"}],
            "nodes": [
                of_light("lamp", "light", json!({})),
                of_light("angle", "parametrization", json!({})),
                of_light("tone", "profile", json!({})),
                of_light("parts", "light_parts", json!({})),
                of_light("strength", "multiply", json!({})),
                of_light("lit", "multiply", json!({})),
                of_light("join", join, json!({}))
            ],
            "wires": [
                wire("lamp", "angle.light"), wire("angle", "tone.angle"),
                wire("lamp", "parts.light"), wire("parts.color", "strength.a"),
                wire("parts.intensity", "strength.b"), wire("strength", "lit.a"),
                wire("tone", "lit.b"), wire("lit", "join.value"),
                wire(&format!("join.{output}"), "outputs.color")
            ]
        }},
        "nodes": own.iter().chain(nodes).collect::<Vec<_>>(),
        "wires": wires
    })
}

/// A layer of lamps that is multiplied, added to and limited.
fn plain_lamps(join: &str) -> Json {
    let nodes = [
        json!({"id": "paint", "kind": "multiply", "values": {"b": [0.9, 0.7, 0.5, 1.0]}}),
        json!({"id": "night", "kind": "add", "values": {"b": [0.02, 0.03, 0.06, 1.0]}}),
        json!({"id": "limit", "kind": "limit_color"}),
    ];
    let wires = [
        json!({"from": "lamps.color", "to": "paint.a"}),
        json!({"from": "paint", "to": "night.a"}),
        json!({"from": "night", "to": "limit.color"}),
        json!({"from": "limit", "to": "output.color"}),
    ];
    lamps_look(join, &nodes, &wires)
}

#[test]
fn lights_of_one_sum_are_told_apart() {
    let folder = RenderFolder::new();
    let path = folder.path("lamps.json");
    let mut look = plain_lamps("sum_of_lights");
    fs::write(&path, look.to_string()).unwrap();
    let asked = ["--aov", "lights", "--mesh", "shape:sphere", "--samples", "1"];
    let drawn = folder.layers(&path, &asked);
    let names: Vec<_> = drawn.names().into_iter().filter(|name| name.ends_with(".R")).collect();
    assert_eq!(names, ["beauty.R", "light_key.R", "light_rim.R", "light_unlit.R"]);
    assert!(drawn.worst_sum("light_", "beauty") <= 1.0);
    let exact = folder.layers(&path, &[&asked[..], &["--on", "reference"]].concat());
    assert!(exact.worst_sum("light_", "beauty") <= 1.0);
    // What a light adds is what goes when it goes out.
    look["lights"]["rim"]["intensity"] = json!(0.0);
    fs::write(&path, look.to_string()).unwrap();
    let without = folder.layers(&path, &asked);
    let mut seen = 0;
    for channel in ["R", "G", "B"] {
        let of = |layer: &str| drawn.channel(&format!("{layer}.{channel}"));
        let alone = without.channel(&format!("beauty.{channel}"));
        let truth = exact.channel(&format!("light_rim.{channel}"));
        for pixel in 0..alone.len() {
            let rest = of("beauty")[pixel] - of("light_rim")[pixel];
            assert!((rest - alone[pixel]).abs() < 2e-3, "{channel} {pixel}");
            if exact.channel("A")[pixel] == drawn.channel("A")[pixel] {
                assert!((truth[pixel] - of("light_rim")[pixel]).abs() < 2e-3, "{channel} {pixel}");
            }
            seen += usize::from(of("light_rim")[pixel] > 0.05);
        }
    }
    assert!(seen > 100, "the rim is seen");
}

#[test]
fn the_greatest_light_has_all_of_what_it_wins() {
    let folder = RenderFolder::new();
    let path = folder.path("lamps.json");
    fs::write(&path, plain_lamps("greatest_of_lights").to_string()).unwrap();
    let asked = ["--aov", "lights", "--mesh", "shape:sphere", "--samples", "1"];
    let drawn = folder.layers(&path, &asked);
    assert!(drawn.worst_sum("light_", "beauty") <= 1.0);
    let mut won = [0, 0];
    for channel in ["R", "G", "B"] {
        let [key, rim] =
            ["key", "rim"].map(|light| drawn.channel(&format!("light_{light}.{channel}")));
        for (key, rim) in key.iter().zip(rim) {
            assert!(key.min(*rim) == 0.0, "one has all: {key} {rim}");
            won[0] += usize::from(*key > 0.0);
            won[1] += usize::from(*rim > 0.0);
        }
    }
    assert!(won[0] > 100 && won[1] > 100, "{won:?}");
}

/// A look in which a node bends the sum of two lights' tones.
fn bent_look(kind: &str, values: &Json) -> Json {
    let light = |id: &str| {
        [
            json!({"id": format!("{id}_lamp"), "kind": "light", "values": {"light": id}}),
            json!({"id": format!("{id}_angle"), "kind": "parametrization"}),
            json!({"id": format!("{id}_tone"), "kind": "profile"}),
        ]
    };
    let leads = |id: &str, to: &str| {
        [
            json!({"from": format!("{id}_lamp"), "to": format!("{id}_angle.light")}),
            json!({"from": format!("{id}_angle"), "to": format!("{id}_tone.angle")}),
            json!({"from": format!("{id}_tone"), "to": to}),
        ]
    };
    let own = [
        json!({"id": "both", "kind": "add"}),
        json!({"id": "cut", "kind": kind, "values": values}),
        json!({"id": "ground", "kind": "base", "values": {"color": [0.0, 0.0, 0.0, 1.0]}}),
        json!({"id": "stack", "kind": "blend", "values": {"color": [1.0, 1.0, 1.0, 1.0]}}),
        json!({"id": "output", "kind": "output"}),
    ];
    let wires = [
        json!({"from": "both", "to": "cut.value"}),
        json!({"from": "cut", "to": "stack.tone"}),
        json!({"from": "ground", "to": "stack.below"}),
        json!({"from": "stack", "to": "output.color"}),
    ];
    json!({
        "chiaro": "look", "version": 1, "name": "Bent",
        "lights": {
            "key": {"direction": [-0.5, 0.6, 0.6]}, "rim": {"direction": [0.8, 0.2, 0.4]}
        },
        "nodes": light("key").iter().chain(&light("rim")).chain(&own).collect::<Vec<_>>(),
        "wires": leads("key", "both.a").iter().chain(&leads("rim", "both.b")).chain(&wires)
            .collect::<Vec<_>>()
    })
}

/// A table of a column a channel, by linear interpolation.
struct Cube {
    last: f64,
    rows: Vec<Vec<f64>>,
}

impl Cube {
    fn read(path: &Path) -> Self {
        let text = fs::read_to_string(path).unwrap();
        let numbers = |line: &str| -> Vec<f64> {
            line.split_whitespace().filter_map(|word| word.parse().ok()).collect()
        };
        let last =
            text.lines().find(|line| line.starts_with("DOMAIN_MAX")).map(numbers).unwrap()[0];
        let is_row = |line: &&str| line.starts_with(|c: char| c.is_ascii_digit() || c == '-');
        Self { last, rows: text.lines().filter(is_row).map(numbers).collect() }
    }

    fn at(&self, value: f64, channel: usize) -> f64 {
        let place = (value / self.last).clamp(0.0, 1.0) * (self.rows.len() - 1) as f64;
        let below = (place as usize).min(self.rows.len() - 2);
        let share = place - below as f64;
        self.rows[below][channel] * (1.0 - share) + self.rows[below + 1][channel] * share
    }
}

#[test]
fn what_bends_a_sum_is_refused_and_given_as_a_table() {
    let folder = RenderFolder::new();
    let path = folder.path("bent.json");
    let asked = ["--aov", "lights", "--mesh", "shape:sphere", "--samples", "1", "--depth", "float"];
    for (kind, values) in [
        ("smooth_step_value", json!({"low": 0.2, "high": 1.6})),
        ("threshold", json!({"edge": 0.7, "softness": 0.3})),
    ] {
        fs::write(&path, bent_look(kind, &values).to_string()).unwrap();
        let told = folder.run(&path, &[&asked[..], &["-o", "out.exr", "--force"]].concat());
        let told = String::from_utf8_lossy(&told.stderr).into_owned();
        assert!(
            told.contains("`cut` of `Bent` bends") && told.contains("before_cut.cube"),
            "{told}"
        );
        let drawn = folder.layers(&path, &asked);
        let cube = Cube::read(&folder.path("out.before_cut.cube"));
        let (value, layer) = (drawn.channel("before_cut.V"), drawn.channel("light_mixed.R"));
        // The width of a pixel comes to the softness of an edge, which no table knows.
        let width = if kind == "threshold" { 0.1 } else { 0.0 };
        let (mut seen, mut worst) = (0, 0.0_f64);
        for (pixel, value) in value.iter().enumerate() {
            let (value, layer) = (f64::from(*value), f64::from(layer[pixel]));
            let (least, most) = (cube.at(value - width, 0), cube.at(value + width, 0));
            worst = worst.max(least - layer).max(layer - most);
            let found = cube.at(value, 0);
            seen += usize::from(found > 0.1 && found < 0.9);
        }
        assert!(seen > 50 && worst < 2.0_f64.powi(-10), "{kind}: {seen} seen, {worst} off");
        let header = fs::read(folder.path("out.exr")).unwrap();
        let name = b"out.before_cut.cube";
        assert!(header.windows(name.len()).any(|bytes| bytes == name), "the header names it");
    }
    // The greater of two lights can be parted, also behind a clamp: the winner has all.
    let mut each = bent_look("clamp_range", &json!({}));
    let nodes = each["nodes"].as_array_mut().unwrap();
    let both = nodes.iter_mut().find(|node| node["id"] == "both").unwrap();
    both["kind"] = json!("maximum");
    fs::write(&path, each.to_string()).unwrap();
    let drawn = folder.layers(&path, &asked);
    assert!(!drawn.names().iter().any(|name| name.contains("mixed")), "{:?}", drawn.names());
}

#[test]
fn what_follows_a_stack_is_given_as_a_table() {
    let folder = RenderFolder::new();
    let asked = ["--aov", "layers", "--mesh", "shape:sphere", "--samples", "1"];
    let asked =
        [&asked[..], &["--depth", "float", "--on", "reference", "--size", "24x20"]].concat();
    let said = |look: &Path| {
        let told = folder.run(look, &[&asked[..], &["-o", "out.exr", "--force"]].concat());
        String::from_utf8(told.stderr).unwrap()
    };
    let film = example("film-print.json");
    let told = said(&film);
    assert!(told.contains("`print` changes") && told.contains("beauty_stack.cube"), "{told}");
    let drawn = folder.layers(&film, &asked);
    let cube = Cube::read(&folder.path("out.beauty_stack.cube"));
    let encoded = |light: f64| match light <= 0.003_130_8 {
        true => 12.92 * light,
        false => 1.055 * light.powf(1.0 / 2.4) - 0.055,
    };
    let mut seen = 0;
    for (channel, name) in ["R", "G", "B"].into_iter().enumerate() {
        let (stack, light) = (drawn.channel(&format!("beauty_stack.{name}")), drawn.channel(name));
        let covered = drawn.channel("A").iter().enumerate().filter(|(_, alpha)| **alpha == 1.0);
        for (pixel, _) in covered {
            let shown = encoded(f64::from(light[pixel]));
            let found = cube.at(f64::from(stack[pixel]), channel);
            assert!((found - shown).abs() < 1e-3, "{name} {pixel}: {found} {shown}");
            seen += usize::from((shown - f64::from(stack[pixel])).abs() > 0.02);
        }
    }
    assert!(seen > 100, "the print is seen: {seen}");
    // What mixes channels is no table of them.
    let mut look: Json = serde_json::from_slice(&fs::read(&film).unwrap()).unwrap();
    let nodes = look["nodes"].as_array_mut().unwrap();
    let print = nodes.iter_mut().find(|node| node["id"] == "print").unwrap();
    *print = json!({"id": "print", "kind": "hsv_adjust", "values": {"saturation": 0.4}});
    fs::write(folder.path("gray.json"), look.to_string()).unwrap();
    let told = said(&folder.path("gray.json"));
    assert!(told.contains("each of its channels depends on all three"), "{told}");
}

#[test]
fn several_values_before_a_node_are_layers() {
    let folder = RenderFolder::new();
    let look = example("highlight-cut.json");
    let asked = ["--aov", "lights", "--mesh", "shape:sphere", "--on", "reference"];
    let asked = [&asked[..], &["--size", "24x20"]].concat();
    let told = folder.run(&look, &[&asked[..], &["-o", "out.exr", "--force"]].concat());
    let told = String::from_utf8(told.stderr).unwrap();
    assert!(told.contains("`before_rim_dark_a`, `before_rim_dark_b`"), "{told}");
    let drawn = folder.layers(&look, &asked);
    assert!(drawn.names().contains(&"light_mixed.R"), "{:?}", drawn.names());
    for input in ["before_rim_dark_a.V", "before_rim_dark_b.V"] {
        let tones = drawn.channel(input);
        assert!(tones.iter().any(|tone| *tone > 0.4) && tones.contains(&0.0), "{input}");
    }
    assert!(drawn.worst_sum("light_", "beauty") <= 1.0);
}

#[test]
fn names_of_a_look_and_shadows_are_layers() {
    let folder = RenderFolder::with_scene();
    let path = folder.path("look.json");
    let mut look: Json = serde_json::from_slice(&fs::read(&path).unwrap()).unwrap();
    look["aovs"] =
        json!([{"name": "rim_mask", "from": "rim.tone"}, {"name": "soil", "from": "base"}]);
    fs::write(&path, look.to_string()).unwrap();
    let scene = folder.path("scene.json");
    let asked = ["--aov", "named", "--aov", "same=rim.tone", "--samples", "1"];
    let drawn = folder.layers(&scene, &asked);
    assert_eq!(drawn.channel("rim_mask.V"), drawn.channel("same.V"));
    assert!(drawn.names().contains(&"soil.R"), "{:?}", drawn.names());
    let one = folder.layers(&scene, &["--aov", "rim_mask", "--samples", "1"]);
    assert_eq!(one.channel("rim_mask.V"), drawn.channel("rim_mask.V"));
    let listed = folder.run(&scene, &["--list-aovs"]);
    let listed = String::from_utf8(listed.stdout).unwrap();
    let named = listed.lines().find(|line| line.starts_with("  --aov named  "));
    assert!(named.is_some_and(|line| line.contains("rim_mask")), "{listed}");
    let wrong = folder.run(&scene, &["-o", "a.exr", "--aov", "rim_masc"]);
    assert!(String::from_utf8_lossy(&wrong.stderr).contains("did you mean `rim_mask`"));

    let street = root().join("examples/scenes/comic-street.json");
    let drawn = folder.layers(&street, &["--aov", "shadows", "--samples", "1"]);
    let shadows: Vec<&str> =
        drawn.names().into_iter().filter(|name| name.ends_with(".V")).collect();
    assert!(shadows.iter().all(|name| name.starts_with("shadow_")), "{shadows:?}");
    assert!(shadows.len() > 1 && shadows.iter().any(|name| name.ends_with("_self.V")));
    for name in shadows {
        let numbers = drawn.channel(name);
        assert!(numbers.iter().all(|x| (-1e-3..=1.001).contains(x)), "{name}");
        assert!(numbers.iter().any(|x| *x > 0.5), "{name} is seen");
    }
}

#[test]
fn floats_are_nearer_the_truth_than_halves() {
    let folder = RenderFolder::with_scene();
    let scene = folder.path("scene.json");
    let asked = ["--aov", "lit=key/lit.color", "--aov", "layers", "--samples", "1", "--depth"];
    let worst = |drawn: &FileLayers, truth: &FileLayers| {
        let mut worst = 0.0_f32;
        for name in ["lit.R", "lit.G", "beauty.R", "layer_RIM.B"] {
            let same = drawn.channel("A").iter().zip(truth.channel("A")).enumerate();
            for (pixel, _) in same.filter(|(_, (a, b))| a == b) {
                worst = worst.max((drawn.channel(name)[pixel] - truth.channel(name)[pixel]).abs());
            }
        }
        worst
    };
    let with =
        |depth: &str, more: &[&str]| folder.layers(&scene, &[&asked[..], &[depth], more].concat());
    let truth = with("float", &["--on", "reference"]);
    let (half, float) = (with("half", &[]), with("float", &[]));
    let (half, float) = (worst(&half, &truth), worst(&float, &truth));
    assert!(float < 0.1 * half && half < 1e-3, "half {half}, float {float}");
    // Several samples are averaged in 32 bits, too: the sum of layers is nearer than halves are.
    let drawn = folder.layers(&scene, &["--aov", "layers", "--depth", "float"]);
    assert!(drawn.worst_sum("layer_", "beauty") < 0.01);
}

#[test]
fn layers_of_what_is_transparent_and_cut_out_are_the_picture() {
    let folder = RenderFolder::with_scene();
    let path = folder.path("look.json");
    let plain: Json = serde_json::from_slice(&fs::read(&path).unwrap()).unwrap();
    let mut glass = plain.clone();
    glass["nodes"][0]["values"]["color"] = json!([0.2, 0.1, 0.3, 0.4]);
    fs::write(folder.path("glass.json"), glass.to_string()).unwrap();
    // Half of it is cut away by its own tone.
    let mut cut = glass.clone();
    cut["nodes"][3]["values"] = json!({"cutoff": 0.55});
    fs::write(folder.path("cut.json"), cut.to_string()).unwrap();
    let object = |id: &str, look: &str, at: [f64; 3]| {
        json!({"id": id, "mesh": "shape:sphere", "looks": {"*": look},
            "transform": {"translate": at}})
    };
    let scene = json!({
        "chiaro": "scene", "version": 1,
        "outlines": {"width": 20.0},
        "objects": [
            object("behind", "look.json", [0.0, 0.0, -1.0]),
            object("before", "glass.json", [-0.5, 0.0, 0.6]),
            object("holes", "cut.json", [0.7, 0.0, 0.6])
        ]
    });
    fs::write(folder.path("scene.json"), scene.to_string()).unwrap();
    let asked =
        ["--aov", "layers", "--aov", "seen=base.below", "--samples", "1", "--depth", "float"];
    let without = |value: &Json| {
        let mut scene = value.clone();
        scene.as_object_mut().unwrap().remove("outlines");
        scene
    };
    for (with_ink, on) in [(false, "gpu"), (true, "gpu"), (false, "reference")] {
        let now = if with_ink { scene.clone() } else { without(&scene) };
        fs::write(folder.path("now.json"), now.to_string()).unwrap();
        let asked = [&asked[..], &["--on", on]].concat();
        let drawn = folder.layers(&folder.path("now.json"), &asked);
        assert!(drawn.worst_sum("layer_", "beauty") <= 0.1, "{on}");
        let alpha = drawn.channel("A");
        let partly = alpha.iter().filter(|a| **a > 0.0 && **a < 1.0).count();
        assert!(partly > 50, "{on}: {partly} pixels are seen through");
        if with_ink {
            continue;
        }
        for channel in ["R", "G", "B"] {
            let shown = drawn.channel(&format!("beauty.{channel}"));
            for (pixel, light) in drawn.channel(channel).iter().enumerate() {
                let alpha = f64::from(alpha[pixel]);
                let straight = if alpha > 0.0 { f64::from(shown[pixel]) / alpha } else { 0.0 };
                let decoded = match straight <= 0.04045 {
                    true => straight / 12.92,
                    false => ((straight + 0.055) / 1.055).powf(2.4),
                };
                let off = (decoded * alpha - f64::from(*light)).abs();
                assert!(off < 1e-4, "{on} {channel} {pixel}: {decoded} * {alpha}, {light}");
            }
        }
    }
    // A backdrop is behind the picture, and in no layer.
    let drawn = folder.layers(&folder.path("now.json"), &asked);
    let backed = [&asked[..], &["--backdrop", "#804020"]].concat();
    let backed = folder.layers(&folder.path("now.json"), &backed);
    assert_eq!(drawn.channel("beauty.R"), backed.channel("beauty.R"));
    assert!(backed.channel("A").iter().all(|alpha| *alpha == 1.0));
}

#[test]
fn layers_that_nobody_asks_for_cost_nothing() {
    let folder = RenderFolder::with_scene();
    let path = folder.path("look.json");
    let wgsl = |path: &Path, aovs: Vec<AovSource>| {
        let look = Look::read(&fs::read_to_string(path).unwrap(), "look.json").value.unwrap();
        let options = CompileOptions { aovs, ..CompileOptions::default() };
        compile(&look, Library::built_in(), &options).unwrap().value.wgsl.to_string()
    };
    let plain = wgsl(&path, Vec::new());
    let mut look: Json = serde_json::from_slice(&fs::read(&path).unwrap()).unwrap();
    look["aovs"] = json!([{"name": "rim_mask", "from": "rim.tone"}]);
    fs::write(&path, look.to_string()).unwrap();
    assert_eq!(wgsl(&path, Vec::new()), plain);
    assert_ne!(wgsl(&path, vec![AovSource::Stack]), plain);
}
