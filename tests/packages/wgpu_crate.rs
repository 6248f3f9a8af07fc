//! The package `wgpu`: a few exported crates are members of the workspace, so that cargo builds
//! them with the wgpu that is here, and draw what we draw.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use crate::support::{files, root};
use image::RgbaImage;
use serde_json::json;

use crate::blender::Ring;
use crate::pictures::{Difference, SIZE, Trial, name_of, soak_trials};
use crate::table;

#[allow(dead_code, unreachable_pub, reason = "the text is that of an example")]
#[path = "crates/figure1-layers/examples/show/scene.rs"]
mod figure1_layers_scene;
#[allow(dead_code, unreachable_pub, reason = "the text is that of an example")]
#[path = "crates/figure5-directional/examples/show/scene.rs"]
mod figure5_directional_scene;
#[allow(dead_code, unreachable_pub, reason = "the text is that of an example")]
#[path = "crates/long-shadows/examples/show/scene.rs"]
mod long_shadows_scene;
#[allow(unreachable_pub, reason = "the text is that of an example")]
#[path = "wgpu_readme.rs"]
mod readme;
#[allow(dead_code, unreachable_pub, reason = "the text is that of an example")]
#[path = "crates/xtoon-orientation/examples/show/scene.rs"]
mod xtoon_orientation_scene;

/// Looks whose crates are kept, with arguments of the export: all values as uniforms, with passes;
/// keys; an image; shadow maps.
const KEPT: [(&str, &[&str]); 4] = [
    ("looks/figure1-layers", &["--live"]),
    ("looks/figure5-directional", &[]),
    ("images/xtoon-orientation", &[]),
    ("shadows/long-shadows", &[]),
];

/// A trial of a look on the ring.
fn trial(example: &str, ring: &'static str) -> Trial {
    let trial = Trial::of(example).with(Vec::leak(vec!["--mesh", ring])).here();
    // No package traces shadows.
    if example.starts_with("shadows") { trial.in_tier("balanced") } else { trial }
}

/// The ring as a file that stays while the tests run.
fn ring() -> &'static str {
    static FILE: std::sync::OnceLock<(tempfile::TempDir, String)> = std::sync::OnceLock::new();
    let (_, path) = FILE.get_or_init(|| {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("ring.obj");
        fs::write(&file, Ring::new().obj()).expect("a mesh");
        let path = file.display().to_string();
        (folder, path)
    });
    path
}

/// Files of a crate by their paths, but for the picture, which the GPU decides about.
fn contents(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let paths = files::below(folder).into_iter();
    let found = paths.filter(|path| !path.ends_with("expected.png")).map(|path| {
        let bytes = fs::read(&path).expect("a file");
        (path.strip_prefix(folder).expect("it was found there").to_owned(), bytes)
    });
    found.collect()
}

/// Exports are the kept crates, byte for byte.
#[test]
fn crates_are_as_they_are_kept() {
    let is_blessing = env::var("CHIARO_BLESS").is_ok_and(|value| value == "1");
    for (example, arguments) in KEPT {
        let name = name_of(example);
        let kept = root().join("tests/packages/crates").join(name);
        let trial = trial(example, ring());
        let package = trial.package_with("wgpu", arguments);
        let made = contents(&package);
        assert!(made.len() > 15, "{name}: {} files", made.len());
        if is_blessing {
            if kept.is_dir() {
                fs::remove_dir_all(&kept).expect("the old crate goes");
            }
            for (path, bytes) in &made {
                let file = kept.join(path);
                fs::create_dir_all(file.parent().expect("a folder")).expect("a folder");
                fs::write(file, bytes).expect("a file");
            }
            continue;
        }
        let known = contents(&kept);
        let names = |of: &BTreeMap<PathBuf, Vec<u8>>| of.keys().cloned().collect::<Vec<_>>();
        let how = "if this is meant: CHIARO_BLESS=1 cargo test --test packages crates_are";
        assert_eq!(names(&made), names(&known), "{name}: {how}");
        for (path, bytes) in &made {
            assert!(known[path] == *bytes, "{name}/{}: {how}", path.display());
        }
    }
}

/// A device of the GPU that the test's environment names, as `chiaro render` has it.
struct Gpu {
    device: wgpu::Device,
    queue: wgpu::Queue,
}

impl Gpu {
    #[expect(clippy::disallowed_methods, reason = "a test has nothing else to do")]
    fn new() -> Self {
        let (device, queue) = pollster::block_on(async {
            let instance = wgpu::Instance::default();
            let adapter = instance.request_adapter(&Default::default()).await.expect("a GPU");
            let descriptor = wgpu::DeviceDescriptor {
                required_features: adapter.features() & wgpu::Features::TEXTURE_COMPRESSION_BC,
                required_limits: adapter.limits(),
                ..Default::default()
            };
            adapter.request_device(&descriptor).await.expect("a device")
        });
        Self { device, queue }
    }

    fn texture(&self, format: wgpu::TextureFormat) -> wgpu::Texture {
        self.device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size: wgpu::Extent3d { width: SIZE[0], height: SIZE[1], depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        })
    }

    /// The picture of a texture of half floats that are premultiplied, and colors as shown or
    /// linear light.
    fn picture(&self, texture: &wgpu::Texture, is_linear: bool) -> RgbaImage {
        let shown = |x: f32| match x {
            x if !is_linear => x,
            x if x <= 0.003_130_8 => 12.92 * x,
            x => 1.055 * x.powf(1.0 / 2.4) - 0.055,
        };
        let floats = self.floats(texture);
        RgbaImage::from_fn(SIZE[0], SIZE[1], |x, y| {
            let [r, g, b, alpha] = floats[(y * SIZE[0] + x) as usize];
            let straight = |x| if alpha > 0.0 { shown(x / alpha) } else { 0.0 };
            let byte = |x: f32| (255.0 * x.clamp(0.0, 1.0) + 0.5).floor() as u8;
            image::Rgba([byte(straight(r)), byte(straight(g)), byte(straight(b)), byte(alpha)])
        })
    }

    /// Texels of a texture of half floats, rows from the top.
    fn floats(&self, texture: &wgpu::Texture) -> Vec<[f32; 4]> {
        let bytes_per_row = (8 * SIZE[0]).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let buffer = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: u64::from(bytes_per_row * SIZE[1]),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = self.device.create_command_encoder(&Default::default());
        let layout = wgpu::TexelCopyBufferLayout {
            bytes_per_row: Some(bytes_per_row),
            ..Default::default()
        };
        let place = wgpu::TexelCopyBufferInfo { buffer: &buffer, layout };
        encoder.copy_texture_to_buffer(texture.as_image_copy(), place, texture.size());
        self.queue.submit([encoder.finish()]);
        buffer.map_async(wgpu::MapMode::Read, .., |_| ());
        self.device.poll(wgpu::PollType::wait_indefinitely()).expect("the picture is drawn");
        let mapped = buffer.get_mapped_range(..).expect("bytes");
        let texel = |(x, y): (u32, u32)| {
            let at = (y * bytes_per_row + 8 * x) as usize;
            std::array::from_fn(|i| {
                let half = [mapped[at + 2 * i], mapped[at + 2 * i + 1]];
                half::f16::from_le_bytes(half).to_f32()
            })
        };
        let places = (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| (x, y)));
        places.map(texel).collect()
    }
}

const COLOR: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;

/// The picture of a kept crate, with the scene of its example; `set` may change the material.
macro_rules! picture {
    ($gpu:expr, $look:ident, $scene:ident, $new:expr, $set:expr) => {{
        let output =
            $look::Output { encoding: $look::Encoding::Shown, ..$look::Output::new(COLOR) };
        picture!($gpu, $look, $scene, $new, $set, output)
    }};
    ($gpu:expr, $look:ident, $scene:ident, $new:expr, $set:expr, $output:expr) => {{
        let gpu: &Gpu = $gpu;
        let output: $look::Output = $output;
        let mut material: $look::Material = $new(gpu, output).expect("a material");
        let set: fn(&mut $look::Material) = $set;
        set(&mut material);
        let mesh = $scene::mesh(&gpu.device).expect("a mesh");
        let world_from_object = $scene::WORLD_FROM_OBJECT;
        let camera = $scene::camera(f64::from(SIZE[0]) / f64::from(SIZE[1]));
        let camera = if output.is_depth_reversed { camera.reversed() } else { camera };
        let (texture, depth) = (gpu.texture(COLOR), output.depth_buffer(&gpu.device, SIZE));
        let view = |texture: &wgpu::Texture| texture.create_view(&Default::default());
        let target = $look::Target {
            color: &view(&texture),
            resolve: None,
            depth: &view(&depth),
            size: SIZE,
            clear: wgpu::Color::TRANSPARENT,
        };
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        let object = $look::Object { mesh: &mesh, world_from_object };
        material.draw(&gpu.device, &gpu.queue, &mut encoder, &target, &camera, &[object]);
        gpu.queue.submit([encoder.finish()]);
        gpu.picture(&texture, output.encoding == $look::Encoding::Linear)
    }};
}

/// The picture of `figure5-directional`, changed by `set`.
fn figure5(gpu: &Gpu, set: fn(&mut figure5_directional::Material)) -> RgbaImage {
    let new = |gpu: &Gpu, output| figure5_directional::Material::new(&gpu.device, output);
    picture!(gpu, figure5_directional, figure5_directional_scene, new, set)
}

/// The picture of `figure1-layers`, changed by `set`.
fn figure1(gpu: &Gpu, set: fn(&mut figure1_layers::Material)) -> RgbaImage {
    let new = |gpu: &Gpu, output| figure1_layers::Material::new(&gpu.device, output);
    picture!(gpu, figure1_layers, figure1_layers_scene, new, set)
}

/// The picture of `long-shadows`.
fn long_shadows(gpu: &Gpu) -> RgbaImage {
    let new = |gpu: &Gpu, output| long_shadows::Material::new(&gpu.device, output);
    picture!(gpu, long_shadows, long_shadows_scene, new, |_| ())
}

/// The picture of `xtoon-orientation`.
fn xtoon(gpu: &Gpu) -> RgbaImage {
    let new = |gpu: &Gpu, output| xtoon_orientation::Material::new(&gpu.device, &gpu.queue, output);
    picture!(gpu, xtoon_orientation, xtoon_orientation_scene, new, |_| ())
}

#[test]
fn crates_draw_what_we_draw() {
    let gpu = Gpu::new();
    let drawn = [
        ("looks/figure1-layers", figure1(&gpu, |_| ())),
        ("looks/figure5-directional", figure5(&gpu, |_| ())),
        ("images/xtoon-orientation", xtoon(&gpu)),
        ("shadows/long-shadows", long_shadows(&gpu)),
    ];
    let mut measured = BTreeMap::new();
    for (example, picture) in drawn {
        let name = name_of(example);
        let ours = trial(example, ring()).ours();
        let seen = ours.pixels().filter(|pixel| pixel.0[3] > 0).count();
        assert!(seen > 2000, "{name}: {seen} pixels are covered");
        measured.insert(format!("wgpu lavapipe {name}"), Difference::of(&picture, &ours));
    }
    table::check(&measured);
}

/// A parameter and a light that are set through the crate's own types change what they change in
/// our own picture.
#[test]
fn parameters_and_lights_of_crates_change_what_they_change_with_us() {
    let gpu = Gpu::new();
    let before = trial("looks/figure1-layers", ring()).ours();
    let set = figure1(&gpu, |material| {
        material.parameters.base_color = [0.2, 0.5, 0.1, 1.0];
        material.lights.key.direction = [0.7, 0.1, 0.7];
    });
    let changed = Trial::changed("looks/figure1-layers", |look| {
        for node in look["nodes"].as_array_mut().into_iter().flatten() {
            if node["id"] == "base" {
                node["values"]["color"] = json!([0.2, 0.5, 0.1, 1.0]);
            }
        }
        look["lights"]["key"]["direction"] = json!([0.7, 0.1, 0.7]);
    });
    let arguments = Vec::leak(vec!["--mesh", ring()]);
    let ours = changed.with(arguments).here().ours();
    let found = Difference::of(&set, &ours);
    assert!(found.greatest <= 1, "{found:?}");
    assert!(Difference::of(&before, &ours).beyond > 500, "the values are seen");
}

/// Linear light in a target of floats and a depth buffer in which 0 is far make the same picture,
/// with passes before it and with shadow maps.
#[test]
fn targets_of_other_kinds_show_the_same() {
    let gpu = Gpu::new();
    let new = |gpu: &Gpu, output| figure1_layers::Material::new(&gpu.device, output);
    let output =
        figure1_layers::Output { is_depth_reversed: true, ..figure1_layers::Output::new(COLOR) };
    assert_eq!(output.encoding, figure1_layers::Encoding::Linear, "a target of floats");
    let drawn = picture!(&gpu, figure1_layers, figure1_layers_scene, new, |_| (), output);
    let found = Difference::of(&drawn, &figure1(&gpu, |_| ()));
    assert!(found.greatest <= 1, "linear light: {found:?}");

    let new = |gpu: &Gpu, output| long_shadows::Material::new(&gpu.device, output);
    let output = long_shadows::Output {
        encoding: long_shadows::Encoding::Shown,
        is_depth_reversed: true,
        ..long_shadows::Output::new(COLOR)
    };
    let drawn = picture!(&gpu, long_shadows, long_shadows_scene, new, |_| (), output);
    let found = Difference::of(&drawn, &long_shadows(&gpu));
    assert!(found.greatest <= 1, "shadow maps: {found:?}");
}

/// Two pictures of one material in one submission have numbers of their own.
#[test]
fn pictures_of_one_submission_keep_their_numbers() {
    let gpu = Gpu::new();
    let output = figure5_directional::Output {
        encoding: figure5_directional::Encoding::Shown,
        ..figure5_directional::Output::new(COLOR)
    };
    let mut material = figure5_directional::Material::new(&gpu.device, output).expect("a material");
    let mesh = figure5_directional_scene::mesh(&gpu.device).expect("a mesh");
    let world_from_object = figure5_directional_scene::WORLD_FROM_OBJECT;
    let object = figure5_directional::Object { mesh: &mesh, world_from_object };
    let camera = figure5_directional_scene::camera(f64::from(SIZE[0]) / f64::from(SIZE[1]));
    let depth = output.depth_buffer(&gpu.device, SIZE).create_view(&Default::default());
    let textures = [(); 2].map(|()| gpu.texture(COLOR));
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    for (texture, x) in textures.iter().zip([0.7, -0.7]) {
        material.lights.key.direction = [x, 0.1, 0.7];
        let target = figure5_directional::Target {
            color: &texture.create_view(&Default::default()),
            resolve: None,
            depth: &depth,
            size: SIZE,
            clear: wgpu::Color::TRANSPARENT,
        };
        material.draw(&gpu.device, &gpu.queue, &mut encoder, &target, &camera, &[object]);
    }
    gpu.queue.submit([encoder.finish()]);
    let [first, second] = textures.map(|texture| gpu.picture(&texture, false));
    let alone = figure5(&gpu, |material| material.lights.key.direction = [0.7, 0.1, 0.7]);
    assert_eq!(first, alone);
    assert!(Difference::of(first.as_raw(), &second).beyond > 200, "the light is another");
}

/// A mesh says what it lacks before it is drawn, and one of buffers is as good as one of arrays.
#[test]
fn meshes_that_cannot_be_drawn_are_refused() {
    use figure1_layers::{Error, Mesh, MeshBuffers, MeshData};
    let gpu = Gpu::new();
    let (positions, normals) = ([[0.0; 3]; 3], [[0.0, 0.0, 1.0]; 3]);
    let whole = MeshData {
        positions: &positions,
        normals: &normals,
        indices: &[0, 1, 2],
        ..MeshData::default()
    };
    let said = |data: &MeshData<'_>| {
        Mesh::new(&gpu.device, data).err().as_ref().map(Error::to_string).unwrap_or_default()
    };
    assert_eq!(said(&whole), "");
    let normals = said(&MeshData { normals: &normals[..2], ..whole });
    assert!(normals.ends_with("it has 3 positions and 2 normals"), "{normals}");
    let index = said(&MeshData { indices: &[0, 1, 3], ..whole });
    assert!(index.ends_with("index 3 is beyond the last of 3 vertices"), "{index}");
    let none = said(&MeshData { indices: &[0, 1], ..whole });
    assert!(none.ends_with("indices 0..2 of 2 are no triangles of three each"), "{none}");

    let buffer = |size: u64, usage: wgpu::BufferUsages| {
        let descriptor =
            wgpu::BufferDescriptor { label: None, size, usage, mapped_at_creation: false };
        gpu.device.create_buffer(&descriptor)
    };
    let (vertex, index) = (wgpu::BufferUsages::VERTEX, wgpu::BufferUsages::INDEX);
    let buffers = |normals: u64, usage| MeshBuffers {
        positions: buffer(36, vertex),
        normals: buffer(normals, usage),
        vertex_count: 3,
        indices: buffer(64, index),
        index_count: 3,
        parts: Vec::new(),
        middle: [0.0; 3],
        radius: 2.0,
    };
    let said = |buffers| Mesh::from_buffers(buffers).map_err(|error| error.to_string());
    assert_eq!(said(buffers(36, vertex)).expect("a mesh").fit()[0][0], 0.5);
    let small = said(buffers(24, vertex)).expect_err("too small");
    assert!(small.ends_with("3 normals take 36 bytes, and their buffer has 24"), "{small}");
    let other = said(buffers(36, index)).expect_err("made for indices");
    assert!(other.contains("the buffer of normals") && other.contains("VERTEX"), "{other}");
}

/// The README's example is a module of these tests, so that it compiles, and draws.
#[test]
fn the_example_of_the_readme_draws() {
    let readme = root().join("tests/packages/crates/figure1-layers/README.md");
    let text = fs::read_to_string(readme).expect("a README");
    let (_, example) = text.split_once("```rust\n").expect("an example");
    let (example, _) = example.split_once("```").expect("its end");
    let module = root().join("tests/packages/wgpu_readme.rs");
    let made = format!("//! The example in the README of a kept crate.\n\n{example}");
    if env::var("CHIARO_BLESS").is_ok_and(|value| value == "1") {
        fs::write(&module, made).expect("a file");
    } else {
        let how = "if this is meant: CHIARO_BLESS=1 cargo test --test packages readme";
        assert!(made == fs::read_to_string(module).expect("a module"), "{how}");
    }
    let gpu = Gpu::new();
    let texture = gpu.texture(COLOR);
    readme::draw(&gpu.device, &gpu.queue, &texture).expect("a picture");
    let seen = gpu.floats(&texture).iter().filter(|texel| texel[3] > 0.0).count();
    assert!(seen > 2000, "{seen} pixels are covered");
}

/// All example looks: their crates, in a workspace of their own, are built without a warning of
/// Clippy, and their examples draw what we draw.
#[test]
#[ignore = "builds a program for each look; scripts/soak runs it"]
fn soak_crates_of_all_examples_draw_what_we_draw() {
    let folder = root().join("target/wgpu-crates");
    let _there_may_be_none = fs::remove_dir_all(folder.join("looks"));
    let mut trials = Vec::new();
    let fit = |trial: Trial| trial.with(Vec::leak(vec!["--mesh", ring()])).here();
    for (name, trial) in soak_trials("wgpu", fit) {
        let package = trial.package("wgpu");
        let copy = folder.join("looks").join(&name);
        for (path, bytes) in contents(&package) {
            let file = copy.join(path);
            fs::create_dir_all(file.parent().expect("a folder")).expect("a folder");
            fs::write(file, bytes).expect("a file");
        }
        // The picture is ours to compare: one sample, and nothing behind.
        edited(&copy.join("examples/show/main.rs"), "SAMPLES: u32 = 4", "SAMPLES: u32 = 1");
        let is_backdrop = |line: &&str| line.starts_with("pub const BACKDROP");
        let scene = fs::read_to_string(copy.join("examples/show/scene.rs")).expect("a scene");
        let line = scene.lines().find(is_backdrop).expect("a backdrop");
        let none = "pub const BACKDROP: wgpu::Color = wgpu::Color::TRANSPARENT;";
        edited(&copy.join("examples/show/scene.rs"), line, none);
        trials.push((name, trial));
    }
    let is_whole = env::var_os("CHIARO_LOOKS").is_none();
    assert!(!is_whole || trials.len() > 60, "{} looks are carried", trials.len());
    let manifest = "[workspace]\nmembers = [\"looks/*\"]\nresolver = \"3\"\n\n\
                    [profile.dev]\ndebug = false\n";
    fs::write(folder.join("Cargo.toml"), manifest).expect("a manifest");
    fs::write(folder.join(".clippy.toml"), "").expect("no rules of ours");
    let cargo = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO"));
        command.args(arguments).current_dir(&folder).env("CARGO_TARGET_DIR", folder.join("target"));
        let output = command.output().expect("cargo");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.success(), "{arguments:?}: {said}");
    };
    let everything = ["--offline", "--workspace", "--examples"];
    cargo(&[&["clippy"][..], &everything, &["--lib", "--", "-D", "warnings"]].concat());
    cargo(&[&["build"][..], &everything].concat());
    let mut measured = BTreeMap::new();
    for (name, trial) in trials {
        let file = folder.join("looks").join(&name).join("drawn.png");
        let manifest = fs::read_to_string(folder.join("looks").join(&name).join("Cargo.toml"));
        let manifest = manifest.expect("a manifest");
        let example = manifest.lines().find_map(|line| line.strip_prefix("name = \"show-"));
        let example = format!("show-{}", example.expect("an example").trim_end_matches('"'));
        let mut command = Command::new(folder.join("target/debug/examples").join(example));
        command.arg(&file).args(SIZE.map(|side| side.to_string()));
        let output = command.output().expect("the example");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{name}: {said}");
        let drawn = image::open(&file).expect("a picture").to_rgba8();
        measured.insert(format!("wgpu lavapipe {name}"), Difference::of(&drawn, &trial.ours()));
    }
    table::check(&measured);
}

/// Replaces a text of a file.
fn edited(file: &Path, old: &str, new: &str) {
    let text = fs::read_to_string(file).expect("a text");
    assert!(text.contains(old), "{}: {old}", file.display());
    fs::write(file, text.replacen(old, new, 1)).expect("a file");
}
