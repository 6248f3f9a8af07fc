//! The package `unity`, as far as it goes without Unity: its shader by two compilers of HLSL and
//! its component by Mono, both with stand-ins of our own for what Unity brings along, and the
//! picture that both make together on Unity's matrices.

pub(crate) mod drawing;
mod engine;
pub(crate) mod textures;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::pictures::{Difference, Trial, examples, keep, soak_trials};
use crate::support::root;
use crate::support::validators::{Tool, say, tools_are_required};
use crate::table;
use drawing::{drawn, drawn_fresh, drawn_from_below, in_one_tier};
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
    fn of(package: &Path) -> Self {
        let folder = package.join("Runtime");
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

/// Looks are drawn as we draw them: halftone dots that count pixels, an image and a painted
/// surface.
#[test]
fn unity_packages_draw_what_we_draw() {
    if !has_tools() {
        return;
    }
    let places = ["looks/halftone-comic", "images/xtoon-highlight", "hcbtf/grass-flat"];
    let trials = examples(&places).into_iter().map(|(name, trial)| (name, in_one_tier(trial)));
    compare(&trials.collect::<Vec<_>>());
}

/// A look that counts pixels counts them from the same corner whatever end a target's rows begin
/// at.
#[test]
fn rows_of_unity_may_begin_at_the_bottom() {
    if !has_tools() {
        return;
    }
    let trial = in_one_tier(Trial::of("looks/halftone-comic"));
    let package = Package::of(&trial.package("unity"));
    let (ours, found) = drawn_from_below(&trial, &package);
    keep("halftone-comic-from-below", &found, &ours);
    let key = "unity stand-in halftone-comic-from-below".to_owned();
    table::check(&BTreeMap::from([(key, Difference::of(&found, &ours))]));
}

/// All example looks. `CHIARO_BLESS=1` writes their lines.
#[test]
#[ignore = "takes minutes; scripts/soak runs it"]
fn soak_unity_packages_draw_all_examples() {
    if has_tools() {
        let trials = soak_trials("unity", in_one_tier);
        let is_whole = std::env::var_os("CHIARO_LOOKS").is_none();
        assert!(!is_whole || trials.len() > 60, "{} looks are taken", trials.len());
        compare(&trials);
    }
}

/// Draws packages, and compares what they show with our own pictures and the table.
fn compare(trials: &[(String, Trial)]) {
    let mut measured = BTreeMap::new();
    for (name, trial) in trials {
        let package = Package::of(&trial.package("unity"));
        let (ours, found) = drawn(trial, &package, "");
        keep(name, &found, &ours);
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
    let trial = in_one_tier(Trial::of("looks/highlight-moves"));
    let package = Package::of(&trial.package("unity"));
    let changed = in_one_tier(Trial::changed("looks/highlight-moves", |look| {
        for node in look["nodes"].as_array_mut().into_iter().flatten() {
            if node["id"] == "move" {
                node["values"]["x"] = serde_json::json!(0.3);
            }
        }
        look["lights"]["key"]["direction"] = serde_json::json!([0.6, 0.0, 0.8]);
    }));
    // x is mirrored: the light shines along what is (-0.6, 0, -0.8) in the look's space.
    let set = "look.moveX = 0.3f; look.keyLight = new Light { type = LightType.Directional, \
               intensity = 1f, color = new Color(1f, 1f, 1f, 1f), transform = new Transform \
               { forward = new Vector3(0.6f, 0f, -0.8f) } };";
    let (before, _) = drawn(&trial, &package, "");
    let fresh = drawn_fresh(&trial, &package);
    assert!(Difference::of(&fresh, &before).greatest <= 1, "a material has the look's numbers");
    let (ours, found) = drawn(&changed, &package, set);
    assert!(Difference::of(&found, &before).beyond > 300, "the values are seen");
    let found = Difference::of(&found, &ours);
    let key = "unity stand-in highlight-moves-set".to_owned();
    table::check(&BTreeMap::from([(key, found)]));
}

/// The sample's scene names files of the package by ids that they have, and things of its own that
/// are there; its mesh has its fronts outside.
#[test]
fn the_sample_of_unity_is_whole() {
    let trial = Trial::of("images/xtoon-highlight");
    let place = trial.package("unity");
    let read = |path: PathBuf| {
        let name = path.strip_prefix(&place).expect("a file of the package");
        (name.to_string_lossy().into_owned(), std::fs::read(&path).expect("a file"))
    };
    let folder: BTreeMap<String, Vec<u8>> =
        crate::support::files::below(&place).into_iter().map(read).collect();
    let ids: BTreeMap<String, &str> = folder
        .iter()
        .filter_map(|(name, bytes)| {
            let file = name.strip_suffix(".meta")?;
            let text = std::str::from_utf8(bytes).expect("text");
            let id = text.lines().find_map(|line| line.strip_prefix("guid: ")).expect("an id");
            assert!(place.join(file).exists(), "{file} is there");
            Some((id.to_owned(), file))
        })
        .collect();
    let files = folder.keys().filter(|name| !name.ends_with(".meta")).count();
    // The folder of what runs has one, too.
    assert_eq!(ids.len(), files + 1, "every file has an id of its own");
    let text = |ending: &str| {
        let found = folder.iter().find(|(name, _)| name.ends_with(ending));
        let (_, bytes) = found.unwrap_or_else(|| panic!("a file {ending}"));
        String::from_utf8(bytes.clone()).expect("text")
    };
    let (scene, component) = (text(".unity"), text("Look.cs"));
    let own: Vec<&str> = scene
        .lines()
        .filter_map(|line| line.strip_prefix("--- !u!")?.split_once('&'))
        .map(|it| it.1)
        .collect();
    let mut named = Vec::new();
    for line in scene.lines() {
        let Some((field, rest)) = line.split_once("{fileID: ") else { continue };
        let (id, rest) = rest.split_once([',', '}']).expect("an end");
        let Some(guid) = rest.trim().strip_prefix("guid: ") else {
            assert!(id == "0" || own.contains(&id), "{line}");
            continue;
        };
        let file = ids.get(&guid[..32]).unwrap_or_else(|| panic!("{line}"));
        let ending = match id {
            "4300000" => ".mesh.asset",
            "4800000" => ".shader",
            "2800000" => ".png",
            "11500000" => "Look.cs",
            _ => panic!("{line}"),
        };
        assert!(file.ends_with(ending), "{line} is {file}");
        let field = field.trim().trim_end_matches(':');
        let is_field = field.starts_with("m_") || component.contains(&format!(" {field};"));
        assert!(is_field, "{line}");
        named.push(ending);
    }
    assert_eq!(named, [".mesh.asset", "Look.cs", ".shader", ".png"]);
    assert!(component.contains("public Light keyLight;") && scene.contains("  keyLight: {"));
    check_mesh(&text(".mesh.asset"));
}

/// A mesh of Unity's: numbers of bytes fit, normals point to where triangles have their fronts,
/// which are clockwise in a left-handed space.
fn check_mesh(text: &str) {
    let value = |name: &str| {
        let mut lines = text.lines().filter_map(|line| line.trim().strip_prefix(name));
        lines.next().unwrap_or_else(|| panic!("{name}")).trim().to_owned()
    };
    let bytes = |name: &str| -> Vec<u8> {
        let digits = value(name);
        let pair = |at: usize| u8::from_str_radix(&digits[at..at + 2], 16).expect("digits");
        (0..digits.len()).step_by(2).map(pair).collect()
    };
    let count: usize = value("m_VertexCount:").parse().expect("a number");
    let dimensions = text.lines().filter_map(|line| line.trim().strip_prefix("dimension: "));
    let dimensions: Vec<usize> = dimensions.map(|it| it.parse().expect("a number")).collect();
    assert_eq!((dimensions.len(), &dimensions[..2], dimensions[4]), (14, &[3, 3][..], 2));
    let stride = dimensions.iter().sum::<usize>();
    let numbers: Vec<f32> = bytes("_typelessdata:")
        .chunks_exact(4)
        .map(|it| f32::from_le_bytes(it.try_into().expect("four bytes")))
        .collect();
    assert_eq!(numbers.len(), count * stride);
    assert_eq!(value("m_DataSize:"), (4 * numbers.len()).to_string());
    let vector = |vertex: usize, at: usize| {
        glam::Vec3::from_slice(&numbers[vertex * stride + at..vertex * stride + at + 3])
    };
    assert_eq!(value("m_IndexFormat:"), "0");
    let indices: Vec<usize> = bytes("m_IndexBuffer:")
        .chunks_exact(2)
        .map(|it| usize::from(u16::from_le_bytes(it.try_into().expect("two bytes"))))
        .collect();
    assert_eq!(value("indexCount:"), indices.len().to_string());
    let is_front = |corners: &&[usize]| {
        let [a, b, c] = [0, 1, 2].map(|at| vector(corners[at], 0));
        (b - a).cross(c - a).dot(vector(corners[0], 3)) > 0.0
    };
    let (fronts, all) = (indices.chunks_exact(3).filter(is_front).count(), indices.len() / 3);
    assert!(fronts * 100 > all * 98, "{fronts} of {all} triangles");
}

/// Both compilers take every pass of the shaders.
#[test]
fn both_compilers_take_the_shaders() {
    if !has_tools() {
        return;
    }
    for name in ["figure2-specular", "stipple"] {
        let trial = Trial::of(&format!("looks/{name}"));
        let package = Package::of(&trial.package("unity"));
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
