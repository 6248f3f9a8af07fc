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

    /// The picture of a texture of half floats that are premultiplied and as shown.
    fn picture(&self, texture: &wgpu::Texture) -> RgbaImage {
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
        RgbaImage::from_fn(SIZE[0], SIZE[1], |x, y| {
            let at = (y * bytes_per_row + 8 * x) as usize;
            let channel = |i: usize| {
                let half = [mapped[at + 2 * i], mapped[at + 2 * i + 1]];
                half::f16::from_le_bytes(half).to_f32()
            };
            let alpha = channel(3);
            let straight = |i| if alpha > 0.0 { channel(i) / alpha } else { 0.0 };
            let byte = |x: f32| (255.0 * x.clamp(0.0, 1.0) + 0.5).floor() as u8;
            image::Rgba([byte(straight(0)), byte(straight(1)), byte(straight(2)), byte(alpha)])
        })
    }
}

const COLOR: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;
const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// The picture of a kept crate, with the scene of its example; `set` may change the material.
macro_rules! picture {
    ($gpu:expr, $look:ident, $scene:ident, $new:expr, $set:expr) => {{
        let gpu: &Gpu = $gpu;
        let output = $look::Output { color: COLOR, depth: DEPTH, samples: 1 };
        let mut material: $look::Material = $new(gpu, output).expect("a material");
        let set: fn(&mut $look::Material) = $set;
        set(&mut material);
        let mesh = $scene::mesh(&gpu.device).expect("a mesh");
        let world_from_object = $scene::WORLD_FROM_OBJECT;
        let camera = $scene::camera(f64::from(SIZE[0]) / f64::from(SIZE[1]));
        let (texture, depth) = (gpu.texture(COLOR), gpu.texture(DEPTH));
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
        material.draw(&gpu.device, &mut encoder, &target, &camera, &[object]);
        gpu.queue.submit([encoder.finish()]);
        gpu.picture(&texture)
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
    assert!(trials.len() > 60, "{} looks are carried", trials.len());
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
