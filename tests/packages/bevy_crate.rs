//! The package `bevy`. Building Bevy takes ten minutes, so that here the shader is read by naga,
//! in the place of Bevy's preprocessor, and the crate's text by rustfmt. Crates are drawn by Bevy
//! where `scripts/setup bevy` was run.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::support::root;
use chiaro::wgsl;
use serde_json::json;

use crate::blender::Ring;
use crate::pictures::{Difference, SIZE, Trial, keep, name_of, soak_trials};
use crate::table;

/// Bevy's side of the shader, as the look's shader asks for it.
const BEVY: &str = "
struct BevyView {
    clip_from_world: mat4x4f,
    view_from_world: mat4x4f,
    world_from_view: mat4x4f,
    clip_from_view: mat4x4f,
    world_position: vec3f,
}
@group(0) @binding(0) var<uniform> bevy_view: BevyView;
@group(2) @binding(0) var<storage> bevy_meshes: array<mat4x4f>;
fn bevy_world_from_local(instance: u32) -> mat4x4f {
    return bevy_meshes[instance];
}
";

/// A shader as it is after Bevy's preprocessor.
fn preprocessed(shader: &str) -> String {
    shader
        .replace("#import bevy_pbr::{mesh_functions, mesh_view_bindings}\n", BEVY)
        .replace("mesh_view_bindings::view", "bevy_view")
        .replace("mesh_functions::get_world_from_local", "bevy_world_from_local")
        .replace("#{MATERIAL_BIND_GROUP}", "3")
}

/// Text of a crate as rustfmt has it.
fn assert_formatted(package: &Path, files: &[&str]) {
    for file in files {
        let mut command = Command::new("rustfmt");
        command.args(["--edition", "2024", "--check"]).arg(package.join(file));
        let output = command.output().expect("rustfmt");
        let said = String::from_utf8_lossy(&output.stdout);
        let problem = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{}: {said}{problem}", package.display());
    }
}

/// Crates of a look with keys, one with an image, one with all values set live, one with passes
/// before the picture, one with shadow maps, and one of a painted surface are Rust as rustfmt has
/// it, and their shaders are WGSL.
#[test]
fn crates_are_rust_and_wgsl() {
    let looks: [(&str, &[&str]); 6] = [
        ("looks/mood", &[]),
        ("images/xtoon-orientation", &[]),
        ("looks/halftone-comic", &["--live"]),
        ("looks/figure1-layers", &[]),
        ("shadows/long-shadows", &["--tier", "balanced"]),
        ("hcbtf/grass-flat", &[]),
    ];
    for (example, arguments) in looks {
        let trial = Trial::of(example).here();
        let package = trial.package_with("bevy", arguments);
        let shader = fs::read_to_string(package.join("src/shaders/draw.wgsl")).expect("a shader");
        let shader = preprocessed(&shader);
        assert!(!shader.contains('#'), "{example}: no word of the preprocessor is left\n{shader}");
        let read = wgsl::parse(&shader).unwrap_or_else(|error| panic!("{example}: {error}"));
        let entries: Vec<&str> =
            read.module.entry_points.iter().map(|entry| entry.name.as_str()).collect();
        assert_eq!(entries, ["vertex", "fragment"], "{example}");
        assert_formatted(&package, &["src/lib.rs", "examples/show.rs"]);
    }
}

/// A look that the crate cannot draw is refused with the reason.
#[test]
fn looks_that_other_objects_drive_are_refused() {
    let problem = Trial::of("looks/near-lantern").here().refusal("bevy");
    assert!(problem.contains("not-in-package"), "{problem}");
    assert!(problem.contains("other objects") && problem.contains("--to wgpu"), "{problem}");
}

/// The folder in which `scripts/setup bevy` has built Bevy; `None`, said aloud, where there is
/// none.
#[expect(clippy::print_stderr, reason = "a skipped check is to be seen in the test's output")]
fn built() -> Option<PathBuf> {
    let folder = root().join(".tools/bevy");
    if folder.join("Cargo.lock").is_file() {
        return Some(folder);
    }
    eprintln!("SKIPPED: Bevy is not here: run scripts/setup bevy");
    None
}

/// Looks that Bevy draws: of each kind one.
const DRAWN: [&str; 14] = [
    "hcbtf/grass-flat",
    "images/xtoon-orientation",
    "looks/figure1-layers",
    "looks/figure3-curves",
    "looks/figure5-directional",
    "looks/figure6-comics",
    "looks/highlight-moves",
    "looks/ink-outlines",
    "looks/mood",
    "looks/oil-portrait",
    "looks/stained-glass",
    "looks/string-of-lamps",
    "looks/technical-cutaway",
    "shadows/lit-walls",
];

/// Crates and the program that draws them.
#[derive(Default)]
struct Stage {
    dependencies: String,
    profiles: String,
    calls: String,
    trials: Vec<(String, Trial)>,
}

impl Stage {
    /// Adds a look by its trial.
    fn add(&mut self, name: &str, trial: Trial) {
        let package = trial.package("bevy");
        let manifest = fs::read_to_string(package.join("Cargo.toml")).expect("a manifest");
        let module = manifest.lines().find_map(|line| line.strip_prefix("name = "));
        let module = module.expect("a name").trim_matches('"');
        let text = fs::read_to_string(package.join("src/material.rs")).expect("a material");
        let class = text.lines().find_map(|line| line.strip_prefix("impl Material for "));
        let class = class.expect("a material").trim_end_matches(" {");
        // The look itself may be called a material.
        let plugin = format!("{}Plugin", class.strip_suffix("Material").unwrap_or(class));
        let construct = if text.contains("fn new(") { "new(assets)" } else { "default()" };
        self.dependencies += &format!("{module} = {{ path = {package:?} }}\n");
        // Translated host work is not what takes time.
        self.profiles += &format!("[profile.dev.package.{module}]\nopt-level = 0\n");
        self.calls += &format!(
            "        \"{name}\" => draw::<{module}::{class}>({module}::{plugin}, |assets| {{ \
             let _ = assets; {module}::{class}::{construct} }}),\n"
        );
        self.trials.push((name.to_owned(), trial));
    }

    /// Builds the program, draws all looks, and compares with the table. What Bevy said of those
    /// that it did not draw comes back.
    #[must_use]
    fn play(self, folder: &Path, ring: &str) -> String {
        let stage = tempfile::tempdir().expect("a folder");
        build(folder, stage.path(), &(self.dependencies + &self.profiles), &self.calls);
        let program = folder.join("target/debug/show-in-bevy");
        let mut measured = BTreeMap::new();
        // A look that is not drawn keeps no other from the table.
        let mut failures = String::new();
        for (name, trial) in self.trials {
            let file = stage.path().join(format!("{name}.rgba"));
            let mut command = Command::new(&program);
            let [width, height] = SIZE.map(|side| side.to_string());
            command.args([&name, ring, &width, &height]).arg(&file);
            let output = command.output().expect("the program");
            let said = String::from_utf8_lossy(&output.stderr);
            if !output.status.success() {
                failures += &format!("{name}: {said}\n");
                continue;
            }
            let pixels = straight(fs::read(&file).expect("pixels"));
            let ours = trial.ours();
            keep(&name, &pixels, &ours);
            measured.insert(format!("bevy lavapipe {name}"), Difference::of(&pixels, &ours));
        }
        table::check(&measured);
        failures
    }
}

/// Pixels without their alpha multiplied in, which Bevy does in linear light: over what is
/// transparent it leaves them so.
fn straight(mut pixels: Vec<u8>) -> Vec<u8> {
    let decode = |shown: f64| match shown {
        x if x <= 0.04045 => x / 12.92,
        x => ((x + 0.055) / 1.055).powf(2.4),
    };
    let encode = |light: f64| match light {
        x if x <= 0.003_130_8 => 12.92 * x,
        x => 1.055 * x.powf(1.0 / 2.4) - 0.055,
    };
    for [color @ .., alpha] in pixels.as_chunks_mut::<4>().0 {
        if (1..255).contains(alpha) {
            let whole = f64::from(*alpha) / 255.0;
            for channel in color {
                let light = decode(f64::from(*channel) / 255.0) / whole;
                *channel = (255.0 * encode(light.min(1.0)) + 0.5).floor() as u8;
            }
        }
    }
    pixels
}

/// The ring as a file of its own.
fn ring(folder: &Path) -> &'static str {
    let ring = folder.join("ring.obj");
    fs::write(&ring, Ring::new().obj()).expect("a mesh");
    Box::leak(ring.display().to_string().into_boxed_str())
}

/// Looks of each kind through Bevy's own renderer, with its camera and mesh.
#[test]
fn bevy_draws_what_we_draw() {
    let Some(folder) = built() else { return };
    let place = tempfile::tempdir().expect("a folder");
    let ring = ring(place.path());
    let on_ring = |trial: Trial| trial.with(Vec::leak(vec!["--mesh", ring])).here();
    let mut stage = Stage::default();
    for example in DRAWN {
        let trial = on_ring(Trial::of(example));
        let is_shadowed = example.starts_with("shadows");
        stage.add(name_of(example), if is_shadowed { trial.in_tier("balanced") } else { trial });
    }
    let linear = Trial::changed("looks/figure2-diffuse", |look| {
        look["color_space"] = json!("linear");
    });
    stage.add("linear", on_ring(linear));
    // A parameter and a light that are set through the crate's own types.
    let set = Trial::changed("looks/highlight-moves", |look| {
        for node in look["nodes"].as_array_mut().into_iter().flatten() {
            if node["id"] == "move" {
                node["values"]["x"] = json!(0.3);
            }
        }
        look["lights"]["key"]["direction"] = json!([0.7, 0.1, 0.7]);
    });
    stage.trials.push(("highlight-moves-set".to_owned(), on_ring(set)));
    stage.calls += "        \"highlight-moves-set\" => draw(\n            \
                    highlight_moves_bevy_0_19::HighlightMovesPlugin,\n            |_| {\n\
                    let mut material =\n\
                    highlight_moves_bevy_0_19::HighlightMovesMaterial::default();\n\
                    material.parameters.move_x = 0.3;\n\
                    material.lights.key.direction = [0.7, 0.1, 0.7];\n\
                    material\n            },\n        ),\n";
    assert_eq!(stage.play(&folder, ring), "", "looks that are not drawn");
}

/// Looks that Bevy draws in one program.
const PROGRAM: usize = 24;

/// All example looks: those that Bevy draws, and the reasons for the others.
#[test]
#[ignore = "builds a crate for each look; scripts/soak runs it"]
fn soak_bevy_draws_all_examples() {
    let place = tempfile::tempdir().expect("a folder");
    let ring = ring(place.path());
    let trials = soak_trials("bevy", |trial| trial.with(Vec::leak(vec!["--mesh", ring])).here());
    let Some(folder) = built() else { return };
    let mut trials = trials.into_iter().peekable();
    let mut failures = String::new();
    while trials.peek().is_some() {
        let mut stage = Stage::default();
        for (name, trial) in trials.by_ref().take(PROGRAM) {
            stage.add(&name, trial);
        }
        failures += &stage.play(&folder, ring);
    }
    assert_eq!(failures, "", "looks that are not drawn");
}

/// Builds the program that draws looks in Bevy.
fn build(folder: &Path, stage: &Path, dependencies: &str, calls: &str) {
    let program = include_str!("bevy.rs.in").replace("// CALLS\n", calls);
    fs::create_dir_all(stage.join("src")).expect("a folder");
    fs::write(stage.join("src/main.rs"), program).expect("a program");
    let manifest = fs::read_to_string(folder.join("Cargo.toml")).expect("a manifest");
    fs::write(stage.join("Cargo.toml"), manifest + dependencies).expect("a manifest");
    fs::copy(folder.join("Cargo.lock"), stage.join("Cargo.lock")).expect("a lock");
    let mut command = Command::new(env!("CARGO"));
    command.args(["build", "--offline"]).current_dir(stage);
    command.env("CARGO_TARGET_DIR", folder.join("target"));
    let output = command.output().expect("cargo");
    let said = String::from_utf8_lossy(&output.stderr);
    let from = said.len().saturating_sub(6000);
    assert!(output.status.success(), "{}", said.get(from..).unwrap_or(&said));
}
