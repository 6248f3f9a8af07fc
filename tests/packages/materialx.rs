//! The package `materialx`: MaterialX validates the document and generates shaders of it, which
//! glslang compiles.

use std::path::Path;
use std::process::Command;

use crate::pictures::Trial;
use crate::support::root;
use crate::support::validators::{ShaderStage, Tool, glslang, materialx_folder};
use serde_json::{Value, json};

/// Endings of generated files, with what glslang is told of them.
const GENERATED: [(&str, &[&str]); 3] = [("genglsl", &[]), ("genessl", &[]), ("genvk", &["-V"])];

/// Contents of a package as MaterialX reads it, and the text of a generated fragment shader. `None`
/// without MaterialX, or a Python that it is built for.
fn read(package: &Path) -> Option<(Value, String)> {
    if !Tool::MaterialX.is_here() {
        Tool::MaterialX.missing().expect("a tool that may be missing");
        return None;
    }
    let out = tempfile::tempdir().expect("a folder");
    let output = Command::new("python3")
        .env("PYTHONPATH", materialx_folder())
        .arg(root().join("tests/packages/materialx.py"))
        .args([package, out.path()])
        .output()
        .expect("Python starts");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{}: {said}", package.display());
    let mut fragment = String::new();
    for (target, flags) in GENERATED {
        for (ending, stage) in [("vert", ShaderStage::Vertex), ("frag", ShaderStage::Fragment)] {
            let file = out.path().join(format!("{target}.{ending}"));
            let text = std::fs::read_to_string(file).expect("a generated shader");
            glslang(&text, stage, flags).unwrap_or_else(|problem| panic!("{target}: {problem}"));
            if (target, ending) == ("genglsl", "frag") {
                fragment = text;
            }
        }
    }
    Some((serde_json::from_slice(&output.stdout).expect("JSON"), fragment))
}

/// Parameters arrive as inputs with what the artist says of them; lights and the eye are used.
#[test]
fn materialx_reads_parameters_and_generates_shaders() {
    let trial = Trial::of("looks/highlight-moves");
    let Some((found, fragment)) = read(&trial.package("materialx")) else { return };
    assert_eq!(found["version"], "1.39.5");
    assert_eq!(found["assigned"], json!([found["material"]]));
    let inputs = found["inputs"].as_object().expect("inputs");
    let document = std::fs::read_to_string(root().join("examples/looks/highlight-moves.json"));
    let look: Value = serde_json::from_str(&document.expect("an example")).expect("JSON");
    let exposed = look["exposed"].as_array().expect("parameters");
    assert_eq!(inputs.len(), exposed.len());
    for parameter in exposed {
        let input = &inputs[parameter["name"].as_str().expect("a name")];
        assert_eq!(input["uiname"], parameter["label"]);
    }
    assert_eq!(inputs["color"]["type"], "color4");
    assert_eq!(inputs["color"]["value"], "0.16, 0.3, 0.55, 1.0");
    let square = &inputs["square"];
    assert_eq!([&square["uimin"], &square["uimax"]], ["0.0", "1.0"]);
    // The place of the eye is the uniform's, the light the look's own.
    assert!(fragment.contains("eye_out = u_viewPosition;"), "{fragment}");
    assert!(fragment.contains("vec3(-0.45, 0.62, 0.65), // direction"), "{fragment}");
}

/// Lamps, and lights that differ.
#[test]
fn materialx_takes_lights_of_all_kinds() {
    for name in ["string-of-lamps", "lights-apart"] {
        read(&Trial::of(&format!("looks/{name}")).package("materialx"));
    }
}

/// A look that a node cannot draw is refused, with what helps.
#[test]
fn materialx_refuses_what_a_node_cannot_draw() {
    let cases = [("clay", "draws passes before the picture"), ("stipple", "counts pixels")];
    for (name, reason) in cases {
        let said = Trial::of(&format!("looks/{name}")).refusal("materialx");
        assert!(said.contains("error[not-in-package]") && said.contains(reason), "{said}");
        assert!(said.contains("help: "), "{said}");
    }
}
