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
use crate::pictures::{Difference, SIZE, Trial, name_of};
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

/// Crates of a look with keys, one with an image, one with all values set live, and one of texture
/// coordinates, are Rust as rustfmt has it, and their shaders are WGSL.
#[test]
fn crates_are_rust_and_wgsl() {
    let looks: [(&str, &[&str]); 4] = [
        ("looks/mood", &[]),
        ("images/xtoon-orientation", &[]),
        ("looks/halftone-comic", &["--live"]),
        ("looks/figure3-curves", &[]),
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
        for file in ["src/lib.rs", "examples/show.rs"] {
            let mut command = Command::new("rustfmt");
            command.args(["--edition", "2024", "--check"]).arg(package.join(file));
            let output = command.output().expect("rustfmt");
            let said = String::from_utf8_lossy(&output.stdout);
            let problem = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success(), "{example}: {said}{problem}");
        }
    }
}

/// A look that the crate cannot draw is refused with the reason.
#[test]
fn looks_with_passes_are_refused() {
    let refused = Trial::of("looks/figure1-layers").here().export("bevy", &[]);
    let problem = refused.expect_err("curvature is drawn in passes");
    assert!(problem.contains("not-in-package"), "{problem}");
    assert!(problem.contains("curvature") && problem.contains("--to wgpu"), "{problem}");
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

/// Looks that Bevy draws.
const DRAWN: [&str; 12] = [
    "images/xtoon-distance",
    "images/xtoon-orientation",
    "looks/figure2-diffuse",
    "looks/figure2-specular",
    "looks/figure3-curves",
    "looks/figure3-profile",
    "looks/halftone-comic",
    "looks/highlight-moves",
    "looks/lantern",
    "looks/mood",
    "looks/stained-glass",
    "looks/string-of-lamps",
];

/// A dozen looks through Bevy's own renderer, with its camera and mesh.
#[test]
fn bevy_draws_what_we_draw() {
    let Some(folder) = built() else { return };
    let stage = tempfile::tempdir().expect("a folder");
    let ring = stage.path().join("ring.obj");
    fs::write(&ring, Ring::new().obj()).expect("a mesh");
    let ring: &'static str = Box::leak(ring.display().to_string().into_boxed_str());
    let mut trials = Vec::new();
    let (mut dependencies, mut calls) = (String::new(), String::new());
    for example in DRAWN {
        let name = name_of(example);
        let trial = Trial::of(example).with(Vec::leak(vec!["--mesh", ring])).here();
        let package = trial.package("bevy");
        let module = format!("{}_bevy_0_19", name.replace('-', "_"));
        dependencies += &format!("{module} = {{ path = {package:?} }}\n");
        let class: String =
            name.split('-').map(|word| word[..1].to_uppercase() + &word[1..]).collect();
        let construct = if example.starts_with("images") { "new(assets)" } else { "default()" };
        calls += &format!(
            "        \"{name}\" => draw::<{module}::{class}Material>(\n            \
             {module}::{class}Plugin, |assets| {{ let _ = assets; \
             {module}::{class}Material::{construct} }},\n        ),\n"
        );
        trials.push((name, trial));
    }
    // A parameter and a light that are set through the crate's own types.
    let set = Trial::changed("looks/highlight-moves", |look| {
        for node in look["nodes"].as_array_mut().into_iter().flatten() {
            if node["id"] == "move" {
                node["values"]["x"] = json!(0.3);
            }
        }
        look["lights"]["key"]["direction"] = json!([0.7, 0.1, 0.7]);
    });
    trials.push(("highlight-moves-set", set.with(Vec::leak(vec!["--mesh", ring])).here()));
    calls += "        \"highlight-moves-set\" => draw(\n            \
              highlight_moves_bevy_0_19::HighlightMovesPlugin,\n            |_| {\n                \
              let mut material = highlight_moves_bevy_0_19::HighlightMovesMaterial::default();\n\
              material.parameters.move_x = 0.3;\n\
              material.lights.key.direction = [0.7, 0.1, 0.7];\n\
              material\n            },\n        ),\n";
    build(&folder, stage.path(), &dependencies, &calls);
    let program = folder.join("target/debug/show-in-bevy");
    let mut measured = BTreeMap::new();
    for (name, trial) in trials {
        let file = stage.path().join(format!("{name}.rgba"));
        let mut command = Command::new(&program);
        let [width, height] = SIZE.map(|side| side.to_string());
        command.args([name, ring, &width, &height]).arg(&file);
        let output = command.output().expect("the program");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{name}: {said}");
        let pixels = fs::read(&file).expect("pixels");
        let ours = trial.ours();
        measured.insert(format!("bevy lavapipe {name}"), Difference::of(&pixels, &ours));
    }
    table::check(&measured);
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
