//! The package `godot` in Godot 4.6: its official web build, in Chromium.
//!
//! Packages lie in folders of a project, as users put them there. What the editor does with images
//! when it imports them is done here: an image of four bytes a pixel, and its place in the
//! `.import` file.

use std::collections::BTreeMap;
use std::path::Path;

use serde_json::{Value, json};

use crate::pictures::{Difference, SIZE, Trial, examples, keep, soak_trials};
use crate::support::chromium::from_base64;
use crate::support::files;
use crate::support::godot::Godot;
use crate::table;

/// Files of a package below a folder of the project, imported.
fn packed(package: &Path, folder: &str) -> Vec<(String, Vec<u8>)> {
    let mut packed = Vec::new();
    for path in files::below(package) {
        let name = path.file_name().expect("a file").to_string_lossy().into_owned();
        let bytes = std::fs::read(&path).expect("a file of a package");
        // The test has a project of its own.
        if name == "project.godot" || name == "expected.png" {
            continue;
        }
        let Some(image) = name.strip_suffix(".import") else {
            packed.push((format!("{folder}/{name}"), bytes));
            continue;
        };
        let text = String::from_utf8(bytes).expect("text");
        let pixels = image::open(package.join(image)).expect("an image").to_rgba8();
        let setting = |name: &str| {
            text.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix('=')?.parse().ok())
        };
        let (ty, ending, imported) = match setting("slices/vertical") {
            Some(layers) => ("CompressedTexture2DArray", "ctexarray", layered(&pixels, layers)),
            None => ("CompressedTexture2D", "ctex", texture(&pixels)),
        };
        assert!(text.contains("mipmaps/generate=false\n"), "{text}");
        let head = format!("type=\"{ty}\"\n");
        assert!(text.contains(&head), "{text}");
        let path = format!("{folder}/{image}.{ending}");
        let text = text.replace(&head, &format!("{head}path=\"res://{path}\"\n"));
        packed.push((format!("{folder}/{name}"), text.into_bytes()));
        packed.push((path, imported));
    }
    packed
}

/// An image as Godot's importer keeps it without compression.
fn texture(pixels: &image::RgbaImage) -> Vec<u8> {
    let (width, height) = pixels.dimensions();
    let mut bytes = b"GST2".to_vec();
    // Version, size, flags, limit of levels, and words for later.
    for word in [1, width, height, 0, 0, 0, 0, 0] {
        bytes.extend(word.to_le_bytes());
    }
    bytes.extend(level([width, height], pixels.as_raw()));
    bytes
}

/// Layers, one below the other in an image, as Godot's importer keeps them without compression.
fn layered(pixels: &image::RgbaImage, layers: u32) -> Vec<u8> {
    let (width, height) = pixels.dimensions();
    assert_eq!(height % layers, 0, "the layers are as high");
    let mut bytes = b"GSTL".to_vec();
    // Version, layers, their type, the form of the data, limit of levels, and words for later.
    for word in [1, layers, 0, 0, 0, 0, 0, 0] {
        bytes.extend(word.to_le_bytes());
    }
    for layer in pixels.as_raw().chunks_exact(pixels.as_raw().len() / layers as usize) {
        bytes.extend(level([width, height / layers], layer));
    }
    bytes
}

/// A level without compression.
fn level([width, height]: [u32; 2], pixels: &[u8]) -> Vec<u8> {
    // The form of the data, size, number of further levels, format RGBA8.
    let mut bytes = 0_u32.to_le_bytes().to_vec();
    bytes.extend((width as u16).to_le_bytes());
    bytes.extend((height as u16).to_le_bytes());
    bytes.extend(0_u32.to_le_bytes());
    bytes.extend(5_u32.to_le_bytes());
    bytes.extend(pixels);
    bytes
}

/// A project with packages, running.
struct Stage {
    godot: Godot,
    stems: Vec<String>,
}

impl Stage {
    /// `None`, told on standard error, where a tool is missing.
    fn new(trials: &[&Trial]) -> Option<Self> {
        let (mut files, mut stems) = (Vec::new(), Vec::new());
        for (place, trial) in trials.iter().enumerate() {
            let package = trial.package("godot");
            let names = files::below(&package);
            let stem = names.iter().find_map(|path| {
                let name = path.file_name()?.to_string_lossy().into_owned();
                Some(name.strip_suffix(".gdshader")?.to_owned())
            });
            stems.push(stem.expect("a shader"));
            files.extend(packed(&package, &format!("look{place}")));
        }
        let godot = Godot::start(&files).expect("Godot starts")?;
        Some(Self { godot, stems })
    }

    /// Pictures of a package's scene, each after a step of GDScript in which `mesh` is the object
    /// that wears the look and `scene` what is around it: straight RGBA, the top row first.
    fn pictures(&mut self, place: usize, steps: &[&str]) -> Vec<Vec<u8>> {
        let ([width, height], stem) = (SIZE, &self.stems[place]);
        let mut script = format!(
            "extends RefCounted\n\n\
             func run(main: Node) -> Array:\n\
             \tvar view := SubViewport.new()\n\
             \tview.size = Vector2i({width}, {height})\n\
             \tview.transparent_bg = true\n\
             \tview.own_world_3d = true\n\
             \tview.render_target_update_mode = SubViewport.UPDATE_ALWAYS\n\
             \tmain.add_child(view)\n\
             \tvar scene: Node = load(\"res://look{place}/{stem}.tscn\").instantiate()\n\
             \tscene.get_node(\"Backdrop\").environment = null\n\
             \tview.add_child(scene)\n\
             \tvar mesh: Node = scene.get_node(\"Mesh\")\n\
             \tvar pictures := []\n"
        );
        for step in steps {
            for line in step.lines().chain([
                "for i: int in 2:",
                "\tawait main.get_tree().process_frame",
                "await RenderingServer.frame_post_draw",
                "var image := view.get_texture().get_image()",
                "image.convert(Image.FORMAT_RGBA8)",
                "pictures.append(Marshalls.raw_to_base64(image.get_data()))",
            ]) {
                let line = line.replace("var image :=", "image =");
                script += &format!("\t{line}\n");
            }
        }
        script = script.replace(
            "\tvar pictures := []\n",
            "\tvar pictures := []\n\tvar image: Image\n\tassert(mesh)\n",
        );
        script += "\tview.queue_free()\n\treturn pictures\n";
        let answer = self.godot.run(&script).unwrap_or_else(|said| panic!("{stem}: {said}"));
        let pictures = answer.as_array().expect("pictures");
        let straight = |picture: &Value| {
            let mut pixels = from_base64(picture.as_str().expect("base64")).expect("bytes");
            for pixel in pixels.chunks_exact_mut(4) {
                let alpha = f64::from(pixel[3]);
                for channel in pixel[..3].iter_mut().filter(|_| alpha > 0.0) {
                    *channel = (f64::from(*channel) * 255.0 / alpha).round().min(255.0) as u8;
                }
            }
            pixels
        };
        pictures.iter().map(straight).collect()
    }
}

/// Compares looks in Godot with our own pictures, and the differences with the table. Returns the
/// running project; `None` where a tool is missing.
fn compare(trials: &[(String, Trial)]) -> Option<Stage> {
    let mut stage = Stage::new(&trials.iter().map(|(_, trial)| trial).collect::<Vec<_>>())?;
    let mut measured = BTreeMap::new();
    for (place, (name, trial)) in trials.iter().enumerate() {
        let ours = trial.ours();
        let seen = ours.pixels().filter(|pixel| pixel.0[3] > 0).count();
        assert!(seen > 2000, "{name}: {seen} pixels are covered");
        let drawn = stage.pictures(place, &["pass"]);
        keep(name, &drawn[0], &ours);
        measured.insert(format!("godot compatibility {name}"), Difference::of(&drawn[0], &ours));
    }
    table::check(&measured);
    Some(stage)
}

/// An example in its cheapest tiers, which need no passes.
fn fast(example: &str) -> Trial {
    Trial::of(example).with(&[]).in_tier("fast")
}

/// A look of each kind is drawn as we draw it: layers with keys, an image, many lights, a painted
/// surface, and one of linear light that is transparent. Properties and lights of another change
/// what they change with us.
#[test]
fn godot_draws_what_we_draw() {
    let mut trials = examples(&["images/xtoon-orientation", "looks/string-of-lamps"]);
    let painted = Trial::of("hcbtf/grass-flat").in_tier("balanced");
    trials.push(("grass-flat".to_owned(), painted));
    trials.push(("figure5-directional".to_owned(), fast("looks/figure5-directional")));
    let linear = Trial::changed("looks/highlight-moves", |look| {
        look["color_space"] = json!("linear");
        look["nodes"][0]["values"]["color"] = json!([0.16, 0.3, 0.55, 0.4]);
    });
    trials.push(("linear-transparent".to_owned(), linear));
    trials.push(("highlight-moves".to_owned(), Trial::of("looks/highlight-moves")));
    // Godot takes seconds to start.
    if let Some(mut stage) = compare(&trials) {
        let place = trials.len() - 1;
        properties_and_lights_change_pictures(&mut stage, place, &trials[place].1);
    }
}

/// All example looks that one pass draws: in their fast tier, but for painted surfaces, whose
/// smooth tier needs no passes either. `CHIARO_BLESS=1` writes their lines.
#[test]
#[ignore = "takes minutes; scripts/soak runs it"]
fn soak_godot_draws_all_examples() {
    let trials = soak_trials("godot", |trial| {
        let trial = trial.in_tier("balanced");
        let is_smooth = trial.is_among("hcbtf") && trial.export("godot", &[]).is_ok();
        if is_smooth { trial } else { trial.in_tier("fast") }
    });
    for trials in trials.chunks(12) {
        let _stage = compare(trials);
    }
}

/// A property of the inspector, and a light of the scene that a light of the look follows, change
/// what they change in our own picture of `highlight-moves`.
fn properties_and_lights_change_pictures(stage: &mut Stage, place: usize, trial: &Trial) {
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
    let drawn = stage.pictures(
        place,
        &[
            "pass",
            "mesh.move_x = 0.3\nmesh.color_of_look = Color(0.6, 0.2, 0.1)",
            "mesh.move_x = 0.0\nmesh.color_of_look = Color(0.16, 0.3, 0.55)\n\
             var sun := DirectionalLight3D.new()\nscene.add_child(sun)\n\
             sun.look_at_from_position(Vector3(0.7, 0.1, 0.7), Vector3.ZERO)\n\
             mesh.key_light = sun",
            // A light that is gone is none, and a script works on a node that is there already.
            "sun.free()",
            "var other := MeshInstance3D.new()\nother.mesh = mesh.mesh\n\
             other.transform = mesh.transform\nscene.add_child(other)\n\
             other.set_script(mesh.get_script())\nmesh.hide()",
        ],
    );
    let (turned, lit) = (turned.ours(), lit.ours());
    assert!(Difference::of(turned.as_raw(), &before).beyond > 500, "the values are seen");
    assert!(Difference::of(lit.as_raw(), &before).beyond > 200, "the light is seen");
    let mut measured = BTreeMap::new();
    for (name, drawn, ours) in [
        ("nothing", &drawn[0], &before),
        ("properties", &drawn[1], &turned),
        ("light", &drawn[2], &lit),
        ("nothing-again", &drawn[3], &before),
        ("other-node", &drawn[4], &before),
    ] {
        let key = format!("godot compatibility highlight-moves-{name}");
        measured.insert(key, Difference::of(drawn, ours));
    }
    assert!(measured.values().all(|found| found.beyond < 250), "{measured:?}");
    table::check(&measured);
}

/// A look with passes before its picture is refused where its tier is named, with what helps, and
/// takes a tier without passes where nobody has named one.
#[test]
fn looks_with_passes_are_refused_with_what_helps() {
    let look = Trial::of("looks/mean-curvature");
    look.package("godot");
    let refusal = look.in_tier("exact").export("godot", &[]).expect_err("a refusal");
    assert!(refusal.contains("several passes (normals, curvature)"), "{refusal}");
    assert!(refusal.contains("--tier fast"), "{refusal}");
}
