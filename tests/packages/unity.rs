//! The package `unity`, as far as it goes without Unity: its shader by two compilers of HLSL and
//! its component by Mono, both with stand-ins of our own for what Unity brings along, and the
//! picture that both make together on Unity's matrices.

pub(crate) mod drawing;
mod engine;
pub(crate) mod textures;

use std::path::{Path, PathBuf};

use crate::pictures::{Difference, Trial, examples, soak_trials};
use crate::support::root;
use crate::support::validators::{Tool, say, tools_are_required};
use crate::table;
use drawing::drawn;
use engine::Engine;

/// The stand-ins.
fn stand_ins() -> PathBuf {
    root().join("tests/packages/unity")
}

/// A package as its texts.
struct Package {
    folder: PathBuf,
    shader: String,
    component: PathBuf,
    class: String,
}

impl Package {
    fn of(folder: PathBuf) -> Self {
        let ending = |ending: &str| -> PathBuf {
            let files = std::fs::read_dir(&folder).expect("a package");
            let mut files = files.filter_map(|entry| Some(entry.ok()?.path()));
            let is_it = |path: &PathBuf| path.to_string_lossy().ends_with(ending);
            files.find(is_it).unwrap_or_else(|| panic!("a file `{ending}`"))
        };
        let component = ending("Look.cs");
        let class = component.file_stem().expect("a name").to_string_lossy().into_owned();
        let shader = std::fs::read_to_string(ending(".shader")).expect("a text");
        Self { folder, shader, component, class }
    }

    /// Statements that put into the component's fields what Unity's editor does: files that the
    /// settings of the component's file name by their ids.
    fn references(&self) -> String {
        let files: Vec<PathBuf> = crate::support::files::below(&self.folder);
        let named = |id: &str| {
            let is_it = |path: &&PathBuf| {
                let text = std::fs::read_to_string(path).unwrap_or_default();
                path.to_string_lossy().ends_with(".meta") && text.contains(&format!("guid: {id}\n"))
            };
            let meta = files.iter().find(is_it).unwrap_or_else(|| panic!("a file of id {id}"));
            let path = meta.to_string_lossy().into_owned();
            path.strip_suffix(".meta").expect("a setting").to_owned()
        };
        let settings = format!("{}.meta", self.component.display());
        let settings = std::fs::read_to_string(settings).expect("settings");
        let mut text = String::new();
        for line in settings.lines() {
            // `  - toneAir: {fileID: 2800000, guid: 0123, type: 3}`
            let Some((field, rest)) =
                line.strip_prefix("  - ").and_then(|it| it.split_once(": {fileID: "))
            else {
                continue;
            };
            let (kind, rest) = rest.split_once(", guid: ").expect("an id");
            let path = named(rest.split_once(',').expect("its end").0);
            let name = path.rsplit('/').next().unwrap_or_default();
            text += &match kind {
                "2800000" => format!("look.{field} = new Texture {{ name = {name:?} }};\n"),
                "4900000" => format!(
                    "look.{field} = new TextAsset {{ name = {name:?}, \
                     bytes = File.ReadAllBytes({path:?}) }};\n"
                ),
                _ => {
                    assert!(field == "shader" && path.ends_with(".shader"), "{line}");
                    String::new()
                }
            };
        }
        text
    }

    /// The HLSL of each pass, with the names of its two functions.
    fn passes(&self) -> Vec<(String, [String; 2])> {
        let (_, rest) = self.shader.split_once("HLSLINCLUDE\n").expect("a common part");
        let (common, rest) = rest.split_once("ENDHLSL").expect("its end");
        let name = |text: &str, stage: &str| {
            let (_, rest) = text.split_once(&format!("#pragma {stage} ")).expect("a function");
            rest.lines().next().unwrap_or_default().to_owned()
        };
        let passes = rest.split("HLSLPROGRAM\n").skip(1);
        passes
            .map(|pass| {
                let pass = pass.split("ENDHLSL").next().unwrap_or_default();
                (format!("{common}{pass}"), [name(pass, "vertex"), name(pass, "fragment")])
            })
            .collect()
    }
}

/// Tools are here: both compilers and Mono.
fn has_tools() -> bool {
    for tool in [Tool::Glslang, Tool::Slang] {
        if !tool.is_here() {
            tool.missing().expect("a required tool");
            return false;
        }
    }
    if !Engine::is_here() {
        assert!(!tools_are_required(), "Mono is missing: run scripts/setup");
        say("SKIPPED: Mono is missing; scripts/setup installs it");
        return false;
    }
    true
}

/// Looks are drawn as we draw them: lights of all kinds and many of them, halftone dots that count
/// pixels, an image and a painted surface.
#[test]
fn unity_packages_draw_what_we_draw() {
    if !has_tools() {
        return;
    }
    let trials = examples(&[
        "looks/highlight-moves",
        "looks/halftone-comic",
        "looks/string-of-lamps",
        "images/xtoon-highlight",
        "hcbtf/grass-flat",
    ]);
    compare(&trials);
}

/// All example looks. `CHIARO_BLESS=1` writes their lines.
#[test]
#[ignore = "takes minutes; scripts/soak runs it"]
fn soak_unity_packages_draw_all_examples() {
    if has_tools() {
        let trials = soak_trials("unity", |trial| trial.in_tier("fast"));
        assert!(trials.len() > 60, "{} looks are taken", trials.len());
        compare(&trials);
    }
}

/// Draws packages, and compares what they show with our own pictures and the table.
fn compare(trials: &[(String, Trial)]) {
    let mut measured = std::collections::BTreeMap::new();
    for (name, trial) in trials {
        let package = Package::of(trial.package("unity"));
        let (ours, found) = drawn(trial, &package, "");
        let seen = ours.pixels().filter(|pixel| pixel.0[3] > 0).count();
        assert!(seen > 1000, "{name}: {seen} pixels are covered");
        measured.insert(format!("unity stand-in {name}"), Difference::of(&found, &ours));
    }
    table::check(&measured);
}

/// A field of the component and a light of the scene change what they change in our own picture.
#[test]
fn fields_and_lights_of_unity_change_what_they_change_with_us() {
    if !has_tools() {
        return;
    }
    let trial = Trial::of("looks/highlight-moves");
    let package = Package::of(trial.package("unity"));
    let changed = Trial::changed("looks/highlight-moves", |look| {
        for node in look["nodes"].as_array_mut().into_iter().flatten() {
            if node["id"] == "move" {
                node["values"]["x"] = serde_json::json!(0.3);
            }
        }
        look["lights"]["key"]["direction"] = serde_json::json!([0.6, 0.0, 0.8]);
    });
    // x is mirrored: the light shines along what is (-0.6, 0, -0.8) in the look's space.
    let set = "look.moveX = 0.3f; look.keyLight = new Light { type = LightType.Directional, \
               intensity = 1f, color = new Color(1f, 1f, 1f, 1f), transform = new Transform \
               { forward = new Vector3(0.6f, 0f, -0.8f) } };";
    let (before, _) = drawn(&trial, &package, "");
    let (ours, found) = drawn(&changed, &package, set);
    assert!(Difference::of(&found, &before).beyond > 300, "the values are seen");
    let found = Difference::of(&found, &ours);
    let key = "unity stand-in highlight-moves-set".to_owned();
    table::check(&std::collections::BTreeMap::from([(key, found)]));
}

/// Both compilers take every pass of the shaders.
#[test]
fn both_compilers_take_the_shaders() {
    if !has_tools() {
        return;
    }
    for name in ["figure2-specular", "stipple"] {
        let trial = Trial::of(&format!("looks/{name}"));
        let package = Package::of(trial.package("unity"));
        for (text, functions) in package.passes() {
            for (function, stage) in functions.iter().zip(["vertex", "fragment"]) {
                glslang(&package.folder, &text, function, stage);
                engine::wgsl(&package.folder, &text, function, stage);
            }
        }
    }
}

pub(crate) fn glslang(folder: &Path, text: &str, function: &str, stage: &str) {
    let place = tempfile::tempdir().expect("a folder");
    let file = place.path().join("pass.hlsl");
    std::fs::write(&file, text).expect("a file");
    let include = |folder: &Path| format!("-I{}", folder.display());
    let output = std::process::Command::new("glslangValidator")
        .args(["-D", "-V", "--target-env", "vulkan1.1", "--auto-map-bindings"])
        .args(["--auto-map-locations", "-e", function, "-S", &stage[..4]])
        .args([include(folder), include(&stand_ins())])
        .args(["-o", "out.spv", "pass.hlsl"])
        .current_dir(place.path())
        .output()
        .expect("glslangValidator starts");
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{function}: {said}");
}
