//! The package `materialx`: MaterialX validates the document and generates shaders of it, which
//! glslang compiles, and its own renderer draws them.

use std::collections::BTreeMap;
use std::io::{BufRead as _, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};

use crate::blender::Ring;
use crate::pictures::{Difference, SIZE, Trial, keep, run_chiaro, soak_trials};
use crate::support::root;
use crate::support::validators::{ShaderStage, Tool, glslang, materialx_folder, say};
use crate::table::{self, Row};
use glam::DVec3;
use image::RgbaImage;
use serde_json::{Value, json};
use tempfile::TempDir;

/// The camera of the pictures, as the script has it.
const CAMERA: &str = "eye=0.8,0.9,3;target=0,0,0;fov=30";

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
    let said = script(package, out.path(), None);
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
    if said["graph"] != 0 {
        let text = std::fs::read_to_string(out.path().join("graph.frag")).expect("a shader");
        glslang(&text, ShaderStage::Fragment, &[]).unwrap_or_else(|it| panic!("graph: {it}"));
    }
    Some((said, fragment))
}

/// Words of the script about a package, whose shaders it writes into a folder, and pictures where
/// it is given a display with a mesh.
fn script(package: &Path, out: &Path, drawing: Option<(&Display, &Path)>) -> Value {
    let mut command = Command::new("python3");
    command.env("PYTHONPATH", materialx_folder());
    command.arg(root().join("tests/packages/materialx.py")).args([package, out]);
    if let Some((display, mesh)) = drawing {
        command.env("DISPLAY", &display.name).arg(mesh).args(SIZE.map(|side| side.to_string()));
    }
    let output = command.output().expect("Python starts");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{}: {said}", package.display());
    serde_json::from_slice(&output.stdout).expect("JSON")
}

/// A display that nobody sees.
struct Display {
    server: Child,
    name: String,
}

impl Display {
    /// A display; `None`, told on standard error, without Xvfb.
    fn start() -> Option<Self> {
        let mut command = Command::new("Xvfb");
        command.args(["-displayfd", "1", "-screen", "0", "640x480x24"]);
        let server = command.stdout(Stdio::piped()).stderr(Stdio::null()).spawn();
        let Ok(mut server) = server else {
            say("Xvfb is not here: MaterialX draws nothing");
            return None;
        };
        let mut line = String::new();
        let output = server.stdout.take().expect("its output");
        BufReader::new(output).read_line(&mut line).expect("the display's number");
        Some(Self { server, name: format!(":{}", line.trim()) })
    }
}

impl Drop for Display {
    fn drop(&mut self) {
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

/// A ring as a file, in the size that looks are made for.
fn mesh() -> (TempDir, String) {
    let mut ring = Ring::new();
    let points: Vec<DVec3> = ring.positions.iter().map(|it| DVec3::from(*it)).collect();
    let low = points.iter().copied().reduce(DVec3::min).expect("points");
    let high = points.iter().copied().reduce(DVec3::max).expect("points");
    let middle = (low + high) / 2.0;
    let reach = points.iter().map(|it| it.distance(middle)).fold(0.0, f64::max);
    ring.positions = points.iter().map(|it| ((*it - middle) / reach).to_array()).collect();
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("ring.obj");
    std::fs::write(&file, ring.obj()).expect("a mesh");
    let file = file.display().to_string();
    (folder, file)
}

/// Difference of a picture from our own over the color of its corner, by the light of both.
fn difference(pixels: &[u8], ours: &RgbaImage) -> Difference {
    let light = |shown: u8| {
        let shown = f64::from(shown) / 255.0;
        if shown <= 0.040_45 { shown / 12.92 } else { ((shown + 0.055) / 1.055).powf(2.4) }
    };
    let shown = |light: f64| {
        let shown = match light <= 0.003_130_8 {
            true => light * 12.92,
            false => 1.055 * light.powf(1.0 / 2.4) - 0.055,
        };
        (shown * 255.0).round()
    };
    let mut expected = ours.clone();
    for pixel in expected.pixels_mut() {
        let opacity = f64::from(pixel[3]) / 255.0;
        for channel in 0..3 {
            let behind = light(pixels[channel]) * (1.0 - opacity);
            #[expect(clippy::cast_possible_truncation, reason = "rounded, within 0 and 255")]
            #[expect(clippy::cast_sign_loss, reason = "rounded, within 0 and 255")]
            let value = shown(light(pixel[channel]) * opacity + behind) as u8;
            pixel[channel] = value;
        }
        pixel[3] = 255;
    }
    let mut pixels = pixels.to_vec();
    pixels.iter_mut().skip(3).step_by(4).for_each(|opacity| *opacity = 255);
    Difference::of(&pixels, &expected)
}

/// The reason why a package has no graph of MaterialX's own nodes.
fn reason_of_no_graph(package: &Path) -> String {
    let text = std::fs::read_to_string(package.join("README.md")).expect("a README");
    let text = text.replace('\n', " ");
    let reason = text.split_once("own nodes, for ").and_then(|(_, rest)| rest.split_once(". "));
    let (reason, _) = reason.expect("a reason");
    reason.to_owned()
}

/// Draws looks with MaterialX, by their GLSL and by their graphs, and compares with the table.
fn compare(trials: &[(String, Trial)]) {
    if !Tool::MaterialX.is_here() {
        Tool::MaterialX.missing().expect("a tool that may be missing");
        return;
    }
    let Some(display) = Display::start() else { return };
    let (_folder, mesh) = mesh();
    let mut rows = BTreeMap::new();
    for (name, trial) in trials {
        let package = trial.package("materialx");
        let out = tempfile::tempdir().expect("a folder");
        let said = script(&package, out.path(), Some((&display, Path::new(&mesh))));
        let ours = trial.ours_with_arguments(&["--mesh", &mesh, "--camera", CAMERA]);
        let drawn = |form: &str| {
            let pixels = std::fs::read(out.path().join(form)).expect("a picture");
            keep(&format!("{name}.{form}"), &pixels, &ours);
            Row::Drawn(difference(&pixels, &ours))
        };
        rows.insert(format!("materialx genglsl {name}"), drawn("code.rgba"));
        if said["graph"] == 0 {
            let reason = Row::Refused(reason_of_no_graph(&package));
            rows.insert(format!("materialx-graph - {name}"), reason);
        } else {
            assert_eq!(said["others"], json!(["genosl", "genmdl", "genmsl"]), "{name}");
            rows.insert(format!("materialx-graph genglsl {name}"), drawn("graph.rgba"));
        }
    }
    table::check_rows(&rows);
}

/// All example looks.
#[test]
#[ignore = "takes minutes; scripts/soak runs it"]
fn soak_materialx_draws_all_examples() {
    for trials in soak_trials("materialx", Trial::here).chunks(8) {
        compare(trials);
    }
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
    let cases = [
        ("clay", "draws passes before the picture"),
        ("stipple", "counts pixels"),
        ("figure2-screen-aligned", "axes of the camera"),
    ];
    for (name, reason) in cases {
        let said = Trial::of(&format!("looks/{name}")).refusal("materialx");
        assert!(said.contains("error[not-in-package]") && said.contains(reason), "{said}");
        assert!(said.contains("help: "), "{said}");
    }
}

/// A look comes back from its graph of MaterialX's own nodes as it was, but for smoothed edges.
#[test]
fn graphs_of_packages_are_imported_again() {
    let trial = Trial::of("looks/material-phong").here();
    let package = trial.package("materialx");
    let imported = package.join("imported.json");
    let document = package.join("material-phong.mtlx");
    run_chiaro(&["import".as_ref(), document.as_ref(), "-o".as_ref(), imported.as_ref()]);
    let back = Trial::of_file(imported).here().ours();
    let found = Difference::of(back.as_raw(), &trial.ours());
    assert!(found.greatest <= 2, "{found:?}");
}
