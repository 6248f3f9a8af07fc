//! The reference in f32 mode against the GPU: the same modules, every operation rounded to f32 as
//! WGSL asks.
//!
//! `cargo test --no-default-features --features gpu --test truth single -- --nocapture` prints by
//! how many steps of f32 each operation differs, and by how much whole looks do. Where WGSL
//! promises correct rounding the two agree bit for bit; else within what WGSL allows. On software
//! Vulkan, where the figures of docs/performance.md were taken, closer bounds hold.
#![cfg(feature = "gpu")]

use crate::support;
use crate::support::wait::block_on;
mod triangles;

use std::path::{Path, PathBuf};

use crate::support::eval::{look, options, renderer, scene_of, shape, told};
use crate::support::random::Random;
use chiaro::compile::Live;
use chiaro::document::{Camera, Look, Scene};
use chiaro::frame::{Assets, EvalSample, PlanOptions, Planner, Setup, SetupLook, eval_batches};
use chiaro::interp::Precision;
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::reference::{self, ImageRounding, Modules, ReferencePicture, SnapGrid};
use chiaro::render::{Picture, Renderer};
use glam::{DVec2, DVec3};
use image::{Rgba, RgbaImage};
use serde_json::json;

/// The largest difference between the GPU and the reference.
#[derive(Clone, Copy, Debug)]
enum ErrorBound {
    /// A number of steps of f32.
    Steps(u64),
    Absolute(f64),
}

/// The range that the operands x, y and z are taken from.
#[derive(Clone, Copy, Debug)]
enum Domain {
    /// Both signs, of magnitudes from 2^-20 to 2^20.
    Wide,
    /// Above 0, of magnitudes from 2^-20 to 2^20.
    Positive,
    Between(f64, f64),
}

impl Domain {
    fn draw(self, random: &mut Random) -> f64 {
        let x = match self {
            Self::Wide => {
                random.between(-20.0, 20.0).exp2() * if random.chance(0.5) { -1.0 } else { 1.0 }
            }
            Self::Positive => random.between(-20.0, 20.0).exp2(),
            Self::Between(low, high) => random.between(low, high),
        };
        f64::from(x as f32)
    }
}

use Domain::{Between, Positive, Wide};
use ErrorBound::{Absolute, Steps};

/// An operation, its WGSL over `p`, its domain, the bound by WGSL, and the bound on software
/// Vulkan.
type Row = (&'static str, &'static str, Domain, ErrorBound, ErrorBound);

/// Operations that WGSL rounds correctly, or does not round. Division and square roots are correct
/// on software Vulkan; WGSL allows 2.5 steps, and for the root the error of 1 / inverseSqrt(x) with
/// 2.
const CORRECT: [Row; 20] = [
    ("a + b", "p.x + p.y", Wide, Steps(0), Steps(0)),
    ("a - b", "p.x - p.y", Wide, Steps(0), Steps(0)),
    ("a * b", "p.x * p.y", Wide, Steps(0), Steps(0)),
    ("a / b", "p.x / p.y", Wide, Steps(3), Steps(0)),
    ("sqrt", "sqrt(p.x)", Positive, Steps(5), Steps(0)),
    // WGSL lets an implementation round a product and a sum together once.
    ("a * b + c, positive", "p.x * p.y + p.z", Positive, Steps(1), Steps(0)),
    ("-a", "-p.x", Wide, Steps(0), Steps(0)),
    ("abs", "abs(p.x)", Wide, Steps(0), Steps(0)),
    ("sign", "sign(p.x)", Wide, Steps(0), Steps(0)),
    ("min", "min(p.x, p.y)", Wide, Steps(0), Steps(0)),
    ("max", "max(p.x, p.y)", Wide, Steps(0), Steps(0)),
    ("clamp", "clamp(p.x, -2.0, 3.0)", Wide, Steps(0), Steps(0)),
    ("select", "select(p.x, p.y, p.z < 0.0)", Wide, Steps(0), Steps(0)),
    ("floor", "floor(p.x)", Wide, Steps(0), Steps(0)),
    ("ceil", "ceil(p.x)", Wide, Steps(0), Steps(0)),
    ("round", "round(p.x)", Wide, Steps(0), Steps(0)),
    ("trunc", "trunc(p.x)", Wide, Steps(0), Steps(0)),
    ("fract", "fract(p.x)", Wide, Steps(0), Steps(0)),
    ("step", "step(p.x, p.y)", Wide, Steps(0), Steps(0)),
    ("i32, f32", "f32(i32(p.x))", Wide, Steps(0), Steps(0)),
];

/// Operations composed of correctly rounded ones, or less accurate.
const INHERITED: [Row; 10] = [
    ("mix", "mix(p.x, p.y, fract(p.z))", Positive, Absolute(0.5), Steps(0)),
    ("dot", "dot(p, p.yzx)", Positive, Steps(4), Steps(0)),
    ("length", "length(p)", Wide, Steps(8), Steps(0)),
    ("distance", "distance(p, p.yzx * 3.0)", Wide, Steps(10), Steps(0)),
    ("normalize", "normalize(p).x", Wide, Steps(10), Steps(0)),
    ("cross", "cross(p, vec3f(1.0, 0.0, 0.0)).z", Wide, Steps(1), Steps(0)),
    ("smoothstep", "smoothstep(0.2, 0.9, p.x)", Between(0.0, 1.0), Absolute(1e-6), Absolute(2e-7)),
    ("inverseSqrt", "inverseSqrt(p.x)", Positive, Steps(3), Steps(2)),
    ("a % b", "p.x % p.y", Between(0.5, 100.0), Absolute(1e-4), Absolute(2e-5)),
    ("reflect", "reflect(p, vec3f(0.0, 1.0, 0.0)).y", Wide, Steps(2), Steps(0)),
];

/// Operations that are accurate to a few steps at best, and that the library therefore avoids where
/// it must be exact.
const APPROXIMATE: [Row; 12] = [
    ("exp2, [-10, 10]", "exp2(p.x)", Between(-10.0, 10.0), Steps(24), Steps(24)),
    ("exp, [-10, 10]", "exp(p.x)", Between(-10.0, 10.0), Steps(24), Steps(40)),
    ("log2, [0.5, 2]", "log2(p.x)", Between(0.5, 2.0), Absolute(4.8e-7), Absolute(4.8e-7)),
    ("log2", "log2(p.x)", Positive, Absolute(2e-6), Absolute(4e-6)),
    ("log, [0.5, 2]", "log(p.x)", Between(0.5, 2.0), Absolute(4.8e-7), Absolute(4.8e-7)),
    ("pow, [0.1, 10]", "pow(p.x, p.y)", Between(0.1, 10.0), Steps(1 << 12), Steps(1 << 12)),
    ("sin, [-pi, pi]", "sin(p.x)", Between(-3.13, 3.13), Absolute(4.9e-4), Absolute(2e-6)),
    ("cos, [-pi, pi]", "cos(p.x)", Between(-3.13, 3.13), Absolute(4.9e-4), Absolute(2e-6)),
    ("tan, [-1.5, 1.5]", "tan(p.x)", Between(-1.5, 1.5), Absolute(0.2), Absolute(1e-3)),
    ("acos", "acos(p.x)", Between(-1.0, 1.0), Absolute(1e-3), Absolute(2e-4)),
    ("atan2", "atan2(p.x, p.y)", Between(-5.0, 5.0), Absolute(1.6e-3), Absolute(1e-4)),
    ("tanh, [-3, 3]", "tanh(p.x)", Between(-3.0, 3.0), Absolute(1e-5), Absolute(1e-5)),
];

/// Number of f32 steps between two numbers; 0 and -0 are the same.
fn steps(a: f32, b: f32) -> u64 {
    let place = |x: f32| {
        let bits = i64::from(x.to_bits() & 0x7fff_ffff);
        if x.is_sign_negative() { -bits } else { bits }
    };
    if a.is_nan() || b.is_nan() { u64::MAX } else { place(a).abs_diff(place(b)) }
}

/// Values of an output of a look on the GPU and on the reference in f32.
fn both(
    look: &SetupLook,
    library: &Library,
    output: &str,
    samples: &[EvalSample],
) -> Vec<[[f32; 4]; 2]> {
    let batches = eval_batches(look, library, samples, &options(output), &mut Assets::default())
        .unwrap_or_else(|problems| panic!("{}", told(&problems)));
    let mut renderer = renderer();
    let pairs = batches.iter().flat_map(|batch| {
        let gpu = block_on(renderer.evaluate(batch))
            .unwrap_or_else(|error| panic!("{error}\n{}", batch.shader.wgsl));
        let reference = reference::evaluate(batch, Precision::F32)
            .unwrap_or_else(|problem| panic!("{problem}"));
        gpu.into_iter()
            .zip(reference)
            .map(|(gpu, reference)| [gpu, reference.map(|x| x as f32)])
            .collect::<Vec<_>>()
    });
    pairs.collect()
}

/// A look that shows an expression over `p`, the position of a sample, and a library with a node
/// for it.
fn probe(expression: &str) -> (SetupLook, Library) {
    let mut library = Library::built_in().clone();
    let node = format!(
        "/// Probe\n///\n/// One operation.\n///\n/// @param p from=position hidden\n/// @return \
         value \"Value\" : What it gives.\n\
         /// @unit\nfn probe(p: vec3f) -> f32 {{\n    return {expression};\n}}\n"
    );
    library.add_file("probe.wgsl", &node);
    assert!(library.problems.is_empty(), "{}", told(&library.problems));
    let look = look(&json!({
        "nodes": [{"id": "probe", "kind": "probe"}, {"id": "output", "kind": "output"}],
        "wires": [{"from": "probe", "to": "output.color"}]
    }));
    (look, library)
}

#[allow(
    clippy::print_stdout,
    reason = "the documentation's table is made of what `--nocapture` shows"
)]
fn operations(rows: &[Row]) {
    let is_software = renderer().gpu().is_software();
    let mut problems = Vec::new();
    for (number, (name, expression, domain, allowed, kept)) in rows.iter().enumerate() {
        let mut random = Random::new(300 + number as u64);
        let samples: Vec<EvalSample> = (0..20_000)
            .map(|_| {
                let position = DVec3::from_array([(); 3].map(|()| domain.draw(&mut random)));
                EvalSample { position, ..EvalSample::default() }
            })
            .collect();
        let (look, library) = probe(expression);
        let (mut most_steps, mut most, mut place) = (0, 0.0_f64, DVec3::ZERO);
        for ([gpu, reference], sample) in
            both(&look, &library, "probe.value", &samples).into_iter().zip(&samples)
        {
            let (gpu, reference) = (gpu[0], reference[0]);
            let apart = steps(gpu, reference);
            if apart > most_steps {
                place = sample.position;
            }
            most_steps = most_steps.max(apart);
            most = most.max((f64::from(gpu) - f64::from(reference)).abs());
        }
        let bound = if is_software { kept } else { allowed };
        println!("| `{name}` | {most_steps} | {most:.1e} | {bound:?} | {allowed:?} |");
        let is_within = match *bound {
            Steps(bound) => most_steps <= bound,
            Absolute(bound) => most <= bound,
        };
        if !is_within {
            problems.push(format!("{name}: {most_steps} steps, {most:e}, {bound:?} at {place}"));
        }
    }
    assert!(problems.is_empty(), "{problems:#?}");
}

#[test]
fn what_wgsl_rounds_correctly_is_equal_bit_for_bit() {
    operations(&CORRECT);
}

#[test]
fn what_is_made_of_it_is_a_few_steps_apart() {
    operations(&INHERITED);
}

#[test]
fn functions_are_as_far_apart_as_wgsl_allows() {
    operations(&APPROXIMATE);
}

/// Looks of many operations in a row agree bit for bit, and so do a texture's texels.
#[test]
fn looks_of_plain_arithmetic_are_equal_bit_for_bit() {
    let chain = "sqrt(abs(p.x * p.y - p.z) + 0.37) / (1.0 + p.z * p.z) - (p.x + p.y) * (p.y - 0.7) \
                 / (abs(p.x) + 0.11)";
    let (look, library) = probe(chain);
    let mut random = Random::new(77);
    let samples: Vec<EvalSample> = (0..50_000)
        .map(|_| {
            let position =
                DVec3::from_array([(); 3].map(|()| f64::from(random.between(-9.0, 9.0) as f32)));
            EvalSample { position, ..EvalSample::default() }
        })
        .collect();
    let most =
        both(&look, &library, "probe.value", &samples).iter().map(|[a, b]| steps(a[0], b[0])).max();
    let is_software = renderer().gpu().is_software();
    assert!(!is_software || most == Some(0), "{most:?}");

    let folder = tempfile::tempdir().expect("a folder");
    let mut texels = Random::new(78);
    let picture = RgbaImage::from_fn(16, 8, |_, _| Rgba([(); 4].map(|()| texels.index(256) as u8)));
    picture.save(folder.path().join("picture.png")).expect("it is written");
    let mut image = support::eval::look(&json!({
        "nodes": [
            {
                "id": "image", "kind": "image",
                "values": {"image": "picture.png", "filter": "nearest"}
            },
            {"id": "output", "kind": "output"}
        ],
        "wires": [{"from": "image", "to": "output.color"}]
    }));
    image.folder = folder.path().to_owned();
    // Coordinates around the middles of texels. WGSL does not promise to the last step how 8 bits
    // become a float.
    let samples: Vec<EvalSample> = (0..20_000)
        .map(|_| {
            let within = |random: &mut Random, count: usize| {
                (random.index(count) as f64 + random.between(0.05, 0.95)) / count as f64
            };
            let uv = DVec2::new(within(&mut random, 16), within(&mut random, 8));
            EvalSample { uv, ..EvalSample::default() }
        })
        .collect();
    for [gpu, reference] in both(&image, Library::built_in(), "image.color", &samples) {
        let apart = gpu.iter().zip(reference).map(|(a, b)| steps(*a, b)).max();
        assert!(apart <= Some(2), "{gpu:?} {reference:?}");
    }
}

// Whole pictures

fn example(name: &str) -> SetupLook {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/looks");
    let loaded = Look::load(&chiaro::files::Disk, &folder.join(format!("{name}.json")));
    SetupLook {
        look: loaded.value.expect("an example"),
        source: loaded.source.into(),
        folder: PathBuf::new(),
    }
}

/// Pictures of a setup on the GPU and on the reference.
fn pictures(setup: &Setup, live: &Live, images: ImageRounding) -> (Picture, ReferencePicture) {
    let size = PlanOptions { size: [160, 120], samples: 1, time: 0.0 };
    let plan = Planner::default()
        .plan(setup, Library::built_in(), live, &size)
        .expect("it is planned")
        .value;
    let modules = Modules::new(&plan, Precision::F32).expect("it compiles");
    // Coverage alone is snapped, as on GPUs: see `triangles`.
    let options = reference::ReferenceOptions {
        snap: SnapGrid::Subpixel(8),
        images,
        ..reference::ReferenceOptions::default()
    };
    let reference =
        reference::execute(&plan, &modules, &options, &Progress::new()).expect("it is drawn");
    let gpu = renderer().gpu().precise();
    let picture = block_on(Renderer::new(gpu).picture(&plan)).expect("it is drawn");
    (picture, reference)
}

/// Smallest distance of compared pixels from another surface or the backdrop: the stencil of
/// curvature reaches 3. In pixels.
const RIM: u32 = 4;

/// Differences of colors inside of the object, sorted.
fn differences(gpu: &Picture, reference: &ReferencePicture) -> Vec<f64> {
    let [width, height] = reference.size;
    let mut found = Vec::new();
    for y in RIM..height - RIM {
        for x in RIM..width - RIM {
            let mut near =
                (y - RIM..=y + RIM).flat_map(|y| (x - RIM..=x + RIM).map(move |x| (x, y)));
            if !near.all(|(x, y)| reference.coverage(x, y).is_inside(1)) {
                continue;
            }
            let pixel = gpu.rgba[(y * width + x) as usize];
            let wanted = reference.straight(x, y);
            found.push((0..4).map(|c| (f64::from(pixel[c]) - wanted[c]).abs()).fold(0.0, f64::max));
        }
    }
    found.sort_by(f64::total_cmp);
    found
}

/// The median, the 99th percentile, and the largest of sorted numbers.
fn spread(sorted: &[f64]) -> [f64; 3] {
    let at = |share: f64| sorted[((sorted.len() - 1) as f64 * share) as usize];
    [at(0.5), at(0.99), at(1.0)]
}

fn ball(look: SetupLook) -> Setup {
    let (mesh, matrix) = shape("sphere");
    scene_of(vec![(look, mesh, matrix)], Scene { camera: Camera::default(), ..Scene::default() })
}

/// Rounding of images on this GPU: none, because the normals that curvature is taken from are
/// 32-bit floats on the GPU too.
fn rounding() -> ImageRounding {
    ImageRounding::None
}

#[test]
#[allow(
    clippy::print_stdout,
    reason = "the documentation's table is made of what `--nocapture` shows"
)]
fn whole_looks_agree_baked_and_live() {
    let is_software = renderer().gpu().is_software();
    for name in [
        "figure1-layers",
        "figure2-diffuse",
        "figure2-specular",
        "figure4-both",
        "figure5-directional",
        "figure6-comics",
        "figure6-minimal",
        "figure7-pastel",
    ] {
        for live in [Live::Keyed, Live::All] {
            let (gpu, reference) = pictures(&ball(example(name)), &live, rounding());
            let found = differences(&gpu, &reference);
            let [middle, high, most] = spread(&found);
            println!(
                "| {name}, {live:?} | {} | {middle:.1e} | {high:.1e} | {most:.1e} |",
                found.len()
            );
            assert!(found.len() > 2000, "{name}: {} pixels", found.len());
            // A step of f32 in a normal may be a step of f16 in an image, and that 1e-4 in
            // curvature: at few pixels.
            let bounds = if is_software { [2e-7, 2e-6, 1e-3] } else { [1e-3, 1e-2, 1e-1] };
            let is_within =
                [middle, high, most].iter().zip(bounds).all(|(got, bound)| *got <= bound);
            assert!(is_within, "{name}, {live:?}: {middle:e}, {high:e}, {most:e}");
        }
    }
}

/// The GPU keeps the normals that curvature is taken from in 32-bit floats; half floats would give
/// far larger differences.
#[test]
#[allow(
    clippy::print_stdout,
    reason = "the documentation's table is made of what `--nocapture` shows"
)]
fn images_rounded_to_halves_are_farther_from_the_gpu() {
    let setup = ball(example("figure4-both"));
    let middle = |images| {
        let (gpu, reference) = pictures(&setup, &Live::Keyed, images);
        spread(&differences(&gpu, &reference))[0]
    };
    let [none, nearest, zero] =
        [ImageRounding::None, ImageRounding::Nearest, ImageRounding::TowardZero].map(middle);
    println!(
        "| figure4-both, images as they are, to nearest, toward zero | {none:.1e} | {nearest:.1e} \
         | {zero:.1e} |"
    );
    assert!(
        none < 0.1 * nearest.min(zero) && nearest.max(zero) < 1e-3,
        "{none:e} {nearest:e} {zero:e}"
    );
}
