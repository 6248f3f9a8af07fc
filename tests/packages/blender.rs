//! The package `blender` in Blender, without a window: Python's package `bpy`, which
//! `scripts/setup blender` fetches into `.tools/bpy`.
//!
//! Blender's OpenGL is Mesa's in software, and so is the Vulkan that our own pictures are drawn
//! with here: another rasterizer takes other derivatives within four pixels, and other pixels at
//! edges. Cycles traces one ray through the middle of each pixel.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use image::RgbaImage;
use serde_json::{Value, json};

use crate::pictures::{Difference, SIZE, Trial, name_of, over_black, soak_trials};
use crate::support::root;
use crate::table::{self, Row};

/// Arguments of our own pictures, but for the mesh: the camera that Blender is given.
const CAMERA: &str = "eye=0.9,0.8,2.6;target=0,0.02,0;fov=38";

/// The Python that has Blender; `None`, said aloud, where it was not fetched.
#[expect(clippy::print_stderr, reason = "a skipped check is to be seen in the test's output")]
fn python() -> Option<PathBuf> {
    let python = root().join(".tools/bpy/bin/python");
    if python.is_file() {
        return Some(python);
    }
    eprintln!("SKIPPED: Blender is not here: run scripts/setup blender");
    None
}

/// The add-on of a package, which is not the file that makes an extension of the folder.
fn addon_of(package: &Path) -> PathBuf {
    let files = std::fs::read_dir(package).expect("a package");
    let files = files.filter_map(|entry| Some(entry.ok()?.path()));
    let is_addon = |path: &PathBuf| {
        path.extension().is_some_and(|it| it == "py") && !path.ends_with("__init__.py")
    };
    let addons: Vec<PathBuf> = files.filter(is_addon).collect();
    let [addon] = &addons[..] else { panic!("one add-on: {addons:?}") };
    addon.clone()
}

/// A lying torus with a wave around it, away from the middle of its space and of no unit size.
pub(crate) struct Ring {
    pub(crate) positions: Vec<[f64; 3]>,
    pub(crate) normals: Vec<[f64; 3]>,
    uvs: Vec<[f64; 2]>,
    pub(crate) triangles: Vec<[usize; 3]>,
}

impl Ring {
    pub(crate) fn new() -> Self {
        let (around, across) = (48, 24);
        let mut ring = Self { positions: vec![], normals: vec![], uvs: vec![], triangles: vec![] };
        let place = |u: f64, v: f64| {
            let wave = 1.0 + 0.2 * (3.0 * u).sin();
            let radius = 1.6 + 0.7 * wave * v.cos();
            [3.0 + radius * u.cos(), 0.9 * wave * v.sin() - 2.0, 0.5 + radius * u.sin()]
        };
        for i in 0..=around {
            for j in 0..=across {
                let (s, t) = (f64::from(i) / f64::from(around), f64::from(j) / f64::from(across));
                let (u, v) = (TAU * s, TAU * t);
                let step = 1e-5;
                let difference =
                    |a: [f64; 3], b: [f64; 3]| glam::DVec3::from(a) - glam::DVec3::from(b);
                let along = difference(place(u + step, v), place(u - step, v));
                let up = difference(place(u, v + step), place(u, v - step));
                ring.positions.push(place(u, v));
                ring.normals.push(up.cross(along).normalize().to_array());
                ring.uvs.push([s, t]);
            }
        }
        let row = across as usize + 1;
        for i in 0..around as usize {
            for j in 0..across as usize {
                let [a, b] = [i * row + j, (i + 1) * row + j];
                ring.triangles.push([a, a + 1, b]);
                ring.triangles.push([b, a + 1, b + 1]);
            }
        }
        ring
    }

    pub(crate) fn obj(&self) -> String {
        let mut text = String::new();
        for [x, y, z] in &self.positions {
            let _infallible = writeln!(text, "v {x} {y} {z}");
        }
        for [x, y, z] in &self.normals {
            let _infallible = writeln!(text, "vn {x} {y} {z}");
        }
        for [u, v] in &self.uvs {
            let _infallible = writeln!(text, "vt {u} {v}");
        }
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|corner| corner + 1);
            let _infallible = writeln!(text, "f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}");
        }
        text
    }
}

/// A place for the mesh and Blender's pictures.
struct Stage {
    folder: tempfile::TempDir,
    python: PathBuf,
    ring: Ring,
    /// Arguments of our own pictures; a test's few words are never freed.
    arguments: &'static [&'static str],
}

impl Stage {
    fn new(python: PathBuf) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let ring = Ring::new();
        let mesh = folder.path().join("ring.obj");
        std::fs::write(&mesh, ring.obj()).expect("a mesh");
        let mesh: &'static str = Box::leak(mesh.display().to_string().into_boxed_str());
        let arguments = Vec::leak(vec!["--mesh", mesh, "--camera", CAMERA]);
        Self { folder, python, ring, arguments }
    }

    /// Pictures of a package, each with what `tests/packages/blender.py` takes.
    fn pictures(&self, package: &Path, mut asked: Vec<Value>) -> Vec<Vec<u8>> {
        let files: Vec<PathBuf> =
            (0..asked.len()).map(|index| self.folder.path().join(format!("{index}"))).collect();
        for (picture, file) in asked.iter_mut().zip(&files) {
            picture["file"] = json!(file);
        }
        let addon = addon_of(package);
        let case = json!({
            "addon": addon,
            "positions": self.ring.positions, "normals": self.ring.normals,
            "uvs": self.ring.uvs, "triangles": self.ring.triangles,
            "camera": {"eye": [0.9, 0.8, 2.6], "target": [0.0, 0.02, 0.0],
                       "fov": 38.0_f64.to_radians()},
            "size": SIZE, "pictures": asked,
        });
        let file = self.folder.path().join("case.json");
        std::fs::write(&file, case.to_string()).expect("a case");
        let script = root().join("tests/packages/blender.py");
        let output = Command::new(&self.python).arg(script).arg(&file).output().expect("Python");
        let said = String::from_utf8_lossy(&output.stderr);
        let from = said.len().saturating_sub(3000);
        assert!(output.status.success(), "{}", said.get(from..).unwrap_or(&said));
        files.iter().map(|file| std::fs::read(file).expect("a picture")).collect()
    }
}

/// A look of each kind is drawn as we draw it: layers with curvature, keys, an image, passes, a
/// painted surface, shadow maps.
#[test]
fn add_ons_show_what_we_show() {
    let Some(python) = python() else { return };
    let stage = Stage::new(python);
    let examples = [
        "looks/figure1-layers",
        "looks/figure5-directional",
        "looks/ink-outlines",
        "images/xtoon-orientation",
        "hcbtf/pencil",
        "shadows/comic-street",
    ];
    let mut trials: Vec<(&str, Trial)> =
        examples.iter().map(|example| (name_of(example), Trial::of(example))).collect();
    let linear = Trial::changed("looks/highlight-moves", |look| {
        look["color_space"] = json!("linear");
        look["nodes"][0]["values"]["color"] = json!([0.16, 0.3, 0.55, 0.4]);
    });
    trials.push(("linear-transparent", linear));
    let mut measured = BTreeMap::new();
    for (name, trial) in trials {
        // The exact tier of cast shadows sends rays, which an export does not carry.
        let tier: &'static [&'static str] =
            if name == "comic-street" { &["--tier", "balanced"] } else { &[] };
        let trial = trial.with(tier).here();
        let package = trial.package("blender");
        let trial = trial.with(Vec::leak([stage.arguments, tier].concat()));
        let ours = trial.ours();
        let seen = ours.pixels().filter(|pixel| pixel.0[3] > 0).count();
        assert!(seen > 2000, "{name}: {seen} pixels are covered");
        let drawn = stage.pictures(&package, vec![json!({})]);
        measured.insert(format!("blender gpu {name}"), Difference::of(&drawn[0], &ours));
    }
    table::check(&measured);
}

/// A parameter that is set in Blender's panel, or given to `render`, and a sun that a light of the
/// look follows change what they change in our own picture. Edges of triangles and of the highlight
/// alone differ; what is changed are many more pixels.
#[test]
fn parameters_and_suns_change_what_they_change_with_us() {
    let Some(python) = python() else { return };
    let stage = Stage::new(python);
    let trial = Trial::of("looks/highlight-moves").here();
    let package = trial.package("blender");
    let trial = trial.with(stage.arguments);
    let before = trial.ours();
    let turned = Trial::changed("looks/highlight-moves", |look| {
        for node in look["nodes"].as_array_mut().into_iter().flatten() {
            if node["id"] == "move" {
                node["values"]["x"] = json!(0.3);
            }
        }
        look["nodes"][0]["values"]["color"] = json!([0.6, 0.2, 0.1, 1.0]);
    });
    let lit = Trial::changed("looks/highlight-moves", |look| {
        look["lights"]["key"]["direction"] = json!([0.7, 0.1, 0.7]);
    });
    let values = json!({"move_x": 0.3, "color": [0.6, 0.2, 0.1, 1.0]});
    let drawn = stage.pictures(
        &package,
        vec![
            json!({"parameters": values}),
            json!({"parameters": values, "by_properties": true}),
            json!({"suns": {"key": [0.7, 0.1, 0.7]}}),
            json!({}),
            json!({"shown": true}),
        ],
    );
    let turned = turned.here().with(stage.arguments).ours();
    let lit = lit.here().with(stage.arguments).ours();
    assert!(Difference::of(turned.as_raw(), &before).beyond > 500, "the values are seen");
    assert!(Difference::of(lit.as_raw(), &before).beyond > 200, "the light is seen");
    let mut measured = BTreeMap::new();
    for (name, drawn, ours) in [
        ("parameters", &drawn[0], &turned),
        ("properties", &drawn[1], &turned),
        ("sun", &drawn[2], &lit),
        ("nothing", &drawn[3], &before),
        ("shown", &drawn[4], &before),
    ] {
        measured.insert(format!("blender gpu highlight-moves-{name}"), Difference::of(drawn, ours));
    }
    assert!(measured.values().all(|found| found.beyond < 50), "{measured:?}");
    table::check(&measured);
}

/// An add-on is used as people do, and refuses what they may get wrong with words that help.
#[test]
fn scenes_of_people_are_drawn() {
    let Some(python) = python() else { return };
    let trial = Trial::of("looks/highlight-moves");
    let addon = addon_of(&trial.package("blender"));
    let folder = tempfile::tempdir().expect("a folder");
    let script = root().join("tests/packages/blender_scenes.py");
    let mut command = Command::new(&python);
    command.arg(script).arg(addon).args(["move_x", "key"]).arg(folder.path());
    let output = command.output().expect("Python");
    let said = String::from_utf8_lossy(&output.stderr);
    let from = said.len().saturating_sub(3000);
    assert!(output.status.success(), "{}", said.get(from..).unwrap_or(&said));
}

/// Cycles shows a look by its shader as we draw it, follows parameters and a sun. Edges alone
/// differ: Cycles smooths them by its samples, of which there is one.
#[test]
fn cycles_shows_what_we_show() {
    let Some(python) = python() else { return };
    let stage = Stage::new(python);
    let exported = Trial::of("looks/highlight-moves").here();
    let package = exported.package("blender");
    let before = Trial::of("looks/highlight-moves").here().with(stage.arguments).ours();
    let turned = Trial::changed("looks/highlight-moves", |look| {
        look["nodes"][0]["values"]["color"] = json!([0.6, 0.2, 0.1, 1.0]);
        look["lights"]["key"]["direction"] = json!([0.7, 0.1, 0.7]);
    });
    let turned = turned.here().with(stage.arguments).ours();
    let values = json!({"color": [0.6, 0.2, 0.1, 1.0]});
    let suns = json!({"key": [0.7, 0.1, 0.7]});
    let drawn = stage.pictures(
        &package,
        vec![json!({"cycles": true}), json!({"cycles": true, "parameters": values, "suns": suns})],
    );
    let mut measured = BTreeMap::new();
    for (name, drawn, ours) in [("nothing", &drawn[0], &before), ("turned", &drawn[1], &turned)] {
        let found = Difference::of(drawn, ours);
        measured.insert(format!("blender-cycles cpu highlight-moves-{name}"), found);
    }
    assert!(measured.values().all(|found| found.beyond < 400), "{measured:?}");
    table::check(&measured);
}

/// All example looks in the viewport's player. Rows are written look by look.
#[test]
#[ignore = "draws all example looks in Blender"]
fn soak_blender_draws_all_examples() {
    let Some(python) = python() else { return };
    let stage = Stage::new(python);
    for (name, trial) in soak_trials("blender", Trial::here) {
        let drawn = stage.pictures(&trial.package("blender"), vec![json!({})]);
        let ours = trial.ours_with_arguments(stage.arguments);
        let found = Difference::of(&drawn[0], &ours);
        table::check(&BTreeMap::from([(format!("blender gpu {name}"), found)]));
    }
}

/// All example looks in Cycles, or why the add-on has no shader for it. Cycles is not told how
/// normals change across a pixel, so that edges are smoothed by samples alone: 256 of its own
/// beside 64 of ours, over black, for edges that are hardly there have any color.
#[test]
#[ignore = "draws all example looks in Cycles"]
fn soak_cycles_draws_all_examples() {
    let Some(python) = python() else { return };
    let stage = Stage::new(python);
    for (name, trial) in soak_trials("blender", Trial::here) {
        let package = trial.package("blender");
        let row = match reason_of_no_shader(&package) {
            Some(reason) => (format!("blender-cycles - {name}"), Row::Refused(reason)),
            None => {
                let asked = json!({"cycles": true, "samples": 256});
                let drawn = stage.pictures(&package, vec![asked]);
                let ours = trial.ours_averaged(8, stage.arguments);
                let found = Difference::of(&over_black(&drawn[0]), &over_black_image(&ours));
                (format!("blender-cycles cpu {name}"), Row::Drawn(found))
            }
        };
        table::check_rows(&BTreeMap::from([row]));
    }
}

/// Looks whose every value is a parameter are drawn by Cycles too, and a look that has no shader
/// for it names the node to blame.
#[test]
#[ignore = "exports looks again"]
fn soak_cycles_draws_live_looks() {
    let Some(python) = python() else { return };
    let stage = Stage::new(python);
    let mut measured = BTreeMap::new();
    for name in ["highlight-moves", "material-ggx", "lights-apart"] {
        let trial = Trial::of(&format!("looks/{name}")).here().live();
        let drawn = stage.pictures(&trial.package("blender"), vec![json!({"cycles": true})]);
        let found = Difference::of(&drawn[0], &trial.ours_with_arguments(stage.arguments));
        measured.insert(format!("blender-cycles cpu {name}-live"), found);
    }
    table::check(&measured);
    let refused = Trial::of("images/painted-strokes");
    let readme = refused.package("blender").join("README.md");
    let readme = std::fs::read_to_string(readme).expect("a README");
    for word in ["for Cycles here: the look reads an image", "; the node `", "` reads it: "] {
        assert!(readme.contains(word), "{word}: {readme}");
    }
}

/// [`over_black`] of a picture.
fn over_black_image(picture: &RgbaImage) -> RgbaImage {
    let [width, height] = SIZE;
    RgbaImage::from_raw(width, height, over_black(picture)).expect("a picture of the same size")
}

/// The reason why a package has no shader for Cycles, without what helps.
fn reason_of_no_shader(package: &Path) -> Option<String> {
    let addon = std::fs::read_to_string(addon_of(package)).expect("an add-on");
    let line = addon.lines().find_map(|line| line.strip_prefix("NOT_IN_CYCLES = "));
    let told: String = serde_json::from_str(line.expect("a reason")).expect("a text");
    let reason = told.split("; ").next().unwrap_or_default();
    (!reason.is_empty()).then(|| reason.to_owned())
}
