//! Benchmark of frames: every example look in the paper's own setting, growth of the cost, and
//! distance of looks from the machine's limits.
//!
//! `cargo bench --profile dev --no-default-features --features gpu --bench frames` prints GPU times
//! (timestamps if the device has them) as medians with their 95% confidence interval, measured in
//! turns. docs/performance.md holds the figures. With arguments after `--` only the named parts
//! run: `looks`, `coverage`, `deferred`, `layers`, `lights`, `pixels`, `objects`, `batches`. A size
//! as `3840x2160` takes the place of the paper's, and other words choose the looks whose names have
//! one of them: `-- looks figure 3840x2160`.
#![allow(clippy::print_stdout, reason = "it is what a benchmark is for")]
#![allow(missing_docs, reason = "a program")]
#![allow(clippy::disallowed_methods, reason = "it asks the clock")]

#[path = "frames/batches.rs"]
mod batches;

use std::path::Path;

use chiaro::accuracy::Variant;
use chiaro::accuracy::cost::{Series, alternate};
use chiaro::accuracy::size::Sizes;
use chiaro::compile::Live;
use chiaro::document::{Look, Tier};
use chiaro::export::spirv_words;
use chiaro::frame::{
    self, Assets, FramePlan, PixelArea, PlanOptions, Planner, ScreenModule, Setup, SetupLook,
    default_setup, open,
};
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::reference::{self, Modules, execute};
use chiaro::render::{Gpu, Renderer};
use chiaro::wgsl;
use chiaro_test_drawing::spirv;
use chiaro_test_drawing::wait::block_on;
use glam::{DMat4, DVec3};
use serde_json::{Value as Json, json};

/// Picture size of the BADF paper, in pixels.
const PAPER: [u32; 2] = [1600, 1200];
const TIERS: [Tier; 3] = [Tier::Exact, Tier::Balanced, Tier::Fast];
/// Parts of the benchmark, by the words that ask for them.
const PARTS: [&str; 8] =
    ["looks", "coverage", "deferred", "layers", "lights", "pixels", "objects", "batches"];

fn plan(setup: &Setup, size: [u32; 2]) -> FramePlan {
    let options = PlanOptions { size, samples: 1, time: 0.0 };
    let planned = Planner::default().plan(setup, Library::built_in(), &Live::Keyed, &options);
    planned.unwrap_or_else(|problems| panic!("{problems:?}")).value
}

fn measure(renderer: &mut Renderer, plans: &[FramePlan], rounds: usize) -> Vec<Series> {
    block_on(alternate(renderer, &plans.iter().collect::<Vec<_>>(), rounds, &Progress::new()))
        .expect("it draws")
}

fn worn(json: &Json, mesh: &str) -> Setup {
    let loaded = Look::read(&json.to_string(), "bench.json");
    assert!(loaded.diagnostics.is_empty(), "{:?}", loaded.diagnostics);
    let look = SetupLook {
        look: loaded.value.expect("a look"),
        source: loaded.source.into(),
        folder: "".into(),
    };
    default_setup(look, mesh, &mut Assets::default()).expect("a mesh").value
}

/// JSON of a look with layers over a base, each with a light of its own from one of `lights`.
fn layers(count: usize, lights: usize, kind: &str) -> Json {
    let mut nodes =
        vec![json!({"id": "base", "kind": "base", "values": {"color": [0.1, 0.1, 0.15]}})];
    let mut wires = Vec::new();
    let mut below = "base".to_owned();
    let mut all = serde_json::Map::new();
    for light in 0..lights {
        let turn = light as f64 * 2.4;
        let place = json!([2.0 * turn.sin(), 1.0, 2.0 * turn.cos()]);
        all.insert(
            format!("l{light}"),
            json!({"type": kind, "direction": place, "position": place}),
        );
    }
    for index in 0..count {
        let id = format!("layer{index}");
        let share = index as f64 / count as f64;
        nodes.push(json!({
            "id": id, "kind": "light_layer", "values": {"light": format!("l{}", index % lights),
            "offset": 0.1 + 0.2 * share, "falloff": 0.5 + 0.3 * share, "cutoff": 1.2 + 0.5 * share,
            "convex": [0.2, 0.3 * share, 0.1], "blend": "add"}}));
        wires.push(json!({"from": below, "to": format!("{id}.below")}));
        below = id;
    }
    nodes.push(json!({"id": "output", "kind": "output"}));
    wires.push(json!({"from": below, "to": "output.color"}));
    json!({"lights": all, "nodes": nodes, "wires": wires})
}

fn told(series: &Series) -> String {
    let time = series.estimate();
    let digits = if time.median < 1.0 { 3 } else { 1 };
    format!("{:.digits$} ({:.digits$} to {:.digits$})", time.median, time.low, time.high)
}

/// Time that one instruction takes in one fragment of a shader that does nothing but arithmetic, in
/// nanoseconds: a long chain of products and sums over all pixels of a quad.
fn instruction_price(renderer: &mut Renderer) -> f64 {
    let chain = |count: usize| {
        let mut nodes = vec![json!({"id": "start", "kind": "facing"})];
        let mut wires = Vec::new();
        let mut from = "start".to_owned();
        for index in 0..count {
            let id = format!("n{index}");
            let (kind, b) = if index % 2 == 0 { ("multiply", 0.75) } else { ("add", 0.125) };
            nodes.push(json!({"id": id, "kind": kind, "values": {"b": b}}));
            wires.push(json!({"from": from, "to": format!("{id}.a")}));
            from = id;
        }
        nodes.push(json!({"id": "output", "kind": "output"}));
        wires.push(json!({"from": from, "to": "output.color"}));
        plan(&worn(&json!({"nodes": nodes, "wires": wires}), "shape:sphere"), [800, 800])
    };
    let plans = [chain(20), chain(420)];
    let series = measure(renderer, &plans, 9);
    let more = instructions_of(&plans[1]) - instructions_of(&plans[0]);
    series[1].over(&series[0]).median * 1e6 / (more * covered(&plans[0]))
}

/// Number of pixels of a plan that show an object.
fn covered(plan: &FramePlan) -> f64 {
    let modules = Modules::new(plan, chiaro::interp::Precision::F32).expect("it runs");
    let picture =
        execute(plan, &modules, &reference::ReferenceOptions::default(), &Progress::new())
            .expect("it draws");
    picture.coverage.iter().filter(|pixel| pixel.draw.is_some()).count() as f64
}

/// Bandwidth of the adapter while it does nothing else, by reading and writing a large buffer, in
/// bytes a second.
fn bandwidth(renderer: &Renderer) -> f64 {
    const BYTES: u64 = 256 << 20;
    let gpu = renderer.gpu();
    let buffer = |usage| {
        let label = Some("bandwidth");
        gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label,
            size: BYTES,
            usage,
            mapped_at_creation: false,
        })
    };
    let (from, to) = (buffer(wgpu::BufferUsages::COPY_SRC), buffer(wgpu::BufferUsages::COPY_DST));
    let mut times: Vec<f64> = (0..15).map(|_| copy_time(gpu, &from, &to, BYTES)).collect();
    times.sort_by(f64::total_cmp);
    // The fastest copy shows the machine's limit; the others were disturbed.
    2.0 * BYTES as f64 / times[0]
}

/// Time of a copy between two buffers, in seconds.
fn copy_time(gpu: &Gpu, from: &wgpu::Buffer, to: &wgpu::Buffer, bytes: u64) -> f64 {
    let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    encoder.copy_buffer_to_buffer(from, 0, to, 0, bytes);
    let commands = encoder.finish();
    let start = std::time::Instant::now();
    gpu.queue.submit([commands]);
    gpu.device.poll(wgpu::PollType::wait_indefinitely()).expect("a device that answers");
    start.elapsed().as_secs_f64()
}

/// Number of instructions of a module after `spirv-opt -O`, or as naga writes them if that is not
/// installed.
fn instructions(valid: &wgsl::ValidModule) -> f64 {
    let words = spirv_words(valid).expect("SPIR-V can express it");
    spirv::function_instructions(spirv::optimized(&words).as_ref().unwrap_or(&words)) as f64
}

/// Number of instructions that a plan's passes run for a pixel that shows an object, as estimated
/// by the first draw.
fn instructions_of(plan: &FramePlan) -> f64 {
    let of = |pass: &frame::Pass| match pass.id.stage() {
        Some(stage) => {
            plan.draws[0].module(stage).map_or(0.0, |shader| instructions(&shader.valid))
        }
        None => {
            let module = ScreenModule::of(pass.id).expect("a pass that is shipped");
            instructions(&module.expect("a pass over the picture").valid)
        }
    };
    plan.passes.iter().map(of).sum()
}

/// Least times that the machine takes for a frame: for its instructions, and for the bytes that it
/// must move, in milliseconds.
fn limits(plan: &FramePlan, fragments: f64, price: f64, bandwidth: f64) -> [f64; 2] {
    [
        price * 1e-6 * instructions_of(plan) * fragments,
        1e3 * Sizes::of(plan).traffic as f64 / bandwidth,
    ]
}

fn looks(renderer: &mut Renderer, size: [u32; 2], words: &[String]) {
    let price = instruction_price(renderer);
    let bandwidth = bandwidth(renderer);
    let [width, height] = size;
    println!("\nExample looks on the creature at {width}x{height}, one sample a pixel, ms a frame");
    println!(
        "(the machine: {price:.4} ns an instruction and fragment in a chain of products and sums, \
         {:.2} GB/s in copies)",
        bandwidth * 1e-9
    );
    let beside = "instructions alone, ms (times as long) | bytes alone, ms (times as long)";
    println!(
        "\n| look | exact | by default | balanced | fast | exact: {beside} | fast: {beside} |"
    );
    println!("| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |");
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/looks");
    let mut files: Vec<_> =
        std::fs::read_dir(folder).expect("examples").flatten().map(|entry| entry.path()).collect();
    files.retain(|path| path.extension().is_some_and(|extension| extension == "json"));
    files.sort();
    files.retain(|path| {
        let name = path.to_string_lossy();
        words.is_empty() || words.iter().any(|word| name.contains(word.as_str()))
    });
    for file in files {
        let setup = open(&file, None, &mut Assets::default())
            .unwrap_or_else(|problems| panic!("{problems:?}"))
            .value;
        let mut plans = TIERS.map(|tier| plan(&Variant::Looks(tier).of(&setup), size)).to_vec();
        plans.push(plan(&automatic(&setup), size));
        let series = measure(renderer, &plans, 7);
        // A picture of a quarter of the size covers a sixteenth of the pixels.
        let fragments = 16.0 * covered(&plan(&setup, size.map(|side| side / 4)));
        let name = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let [exact, balanced, fast, default] = [0, 1, 2, 3].map(|tier| told(&series[tier]));
        let far = |tier: usize| {
            let time = series[tier].estimate().median;
            let ends = limits(&plans[tier], fragments, price, bandwidth);
            ends.map(|limit| format!("{limit:.3} ({:.1}x)", time / limit)).join(" | ")
        };
        println!(
            "| {name} | {exact} | {default} | {balanced} | {fast} | {} | {} |",
            far(0),
            far(2)
        );
    }
}

/// A setup in which no look names a tier.
fn automatic(setup: &Setup) -> Setup {
    let mut setup = Variant::Looks(Tier::Exact).of(setup);
    setup.looks.iter_mut().for_each(|worn| worn.look.tier = None);
    setup
}

/// Frames whose passes over the picture run everywhere, beside frames whose passes run where
/// objects may be seen.
fn coverage(renderer: &mut Renderer, size: [u32; 2]) {
    let [width, height] = size;
    println!(
        "\nPasses over the whole picture, and where objects may be seen, {width}x{height}, ms a \
         frame"
    );
    println!("\n| look, exact | everywhere | where objects may be seen | share |");
    println!("| --- | ---: | ---: | ---: |");
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/looks");
    for name in ["figure1-layers", "figure4-both", "figure6-comics"] {
        let file = folder.join(format!("{name}.json"));
        let setup = open(&file, None, &mut Assets::default())
            .unwrap_or_else(|problems| panic!("{problems:?}"))
            .value;
        let near = plan(&Variant::Looks(Tier::Exact).of(&setup), size);
        let everywhere = FramePlan { covered: PixelArea::whole(size), ..near.clone() };
        let series = measure(renderer, &[everywhere, near], 15);
        let share = series[1].ratio(&series[0]).median;
        println!("| {name} | {} | {} | {share:.2} |", told(&series[0]), told(&series[1]));
    }
}

/// Frames whose looks are drawn triangle by triangle, beside frames whose looks are drawn over the
/// picture, and the difference of their pictures.
fn deferred(renderer: &mut Renderer, size: [u32; 2], words: &[String]) {
    let [width, height] = size;
    println!(
        "\nLooks drawn triangle by triangle, and over the picture, {width}x{height}, ms a frame"
    );
    println!(
        "\n| look | tier | by triangles | over the picture | share | beyond 1/255, % of pixels | \
         most, of 255 |"
    );
    println!("| --- | --- | ---: | ---: | ---: | ---: | ---: |");
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/looks");
    let names: Vec<&str> = match words {
        [] => vec!["figure1-layers", "figure4-both", "figure6-comics"],
        words => words.iter().map(String::as_str).collect(),
    };
    for name in names {
        let file = folder.join(format!("{name}.json"));
        let setup = open(&file, None, &mut Assets::default())
            .unwrap_or_else(|problems| panic!("{problems:?}"))
            .value;
        let setups =
            [("exact", Variant::Looks(Tier::Exact).of(&setup)), ("default", automatic(&setup))];
        for (tier, setup) in setups {
            let over = plan(&setup, size);
            if let Err(why) = &over.deferral {
                println!("| {name} | {tier} | | {why} | | | |");
                continue;
            }
            let plans = [over.forward(), over];
            let series = measure(renderer, &plans, 15);
            let share = series[1].ratio(&series[0]).median;
            let [one, other] = [&plans[0], &plans[1]]
                .map(|plan| block_on(renderer.picture(plan)).expect("it draws"));
            let differences: Vec<f32> = one
                .rgba
                .iter()
                .zip(&other.rgba)
                .filter(|(one, other)| one[3] > 0.0 || other[3] > 0.0)
                .map(|(one, other)| {
                    let channels = one.iter().zip(other);
                    channels.map(|(one, other)| 255.0 * (one - other).abs()).fold(0.0, f32::max)
                })
                .collect();
            let beyond = differences.iter().filter(|difference| **difference > 1.0).count();
            println!(
                "| {name} | {tier} | {} | {} | {share:.2} | {:.3} | {:.2} |",
                told(&series[0]),
                told(&series[1]),
                100.0 * beyond as f64 / differences.len().max(1) as f64,
                differences.iter().copied().fold(0.0, f32::max)
            );
        }
    }
}

fn growth(renderer: &mut Renderer, what: &str, plans: &[(String, FramePlan)]) {
    println!("\n{what}, ms a frame");
    let (names, plans): (Vec<_>, Vec<_>) = plans.iter().cloned().unzip();
    for (name, series) in names.iter().zip(measure(renderer, &plans, 7)) {
        println!("{name:>12} {}", told(&series));
    }
}

fn main() {
    let mut renderer = Renderer::new(block_on(Gpu::headless()).expect("an adapter"));
    let software = if renderer.gpu().is_software() { ", in software" } else { "" };
    println!("{}{software}", renderer.gpu().name());
    let asked: Vec<String> =
        std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let (parts, words): (Vec<String>, Vec<String>) =
        asked.into_iter().partition(|word| PARTS.contains(&word.as_str()));
    let size_of = |word: &String| {
        let (width, height) = word.split_once('x')?;
        Some([width.parse().ok()?, height.parse().ok()?])
    };
    let size = words.iter().find_map(size_of).unwrap_or(PAPER);
    let words: Vec<String> = words.into_iter().filter(|word| size_of(word).is_none()).collect();
    let wants = |part: &str| parts.is_empty() || parts.iter().any(|asked| asked == part);
    if wants("looks") {
        looks(&mut renderer, size, &words);
    }
    if wants("coverage") {
        coverage(&mut renderer, size);
    }
    if wants("deferred") {
        deferred(&mut renderer, size, &words);
    }
    if wants("batches") {
        batches::run(&mut renderer, size, 11);
    }
    let size = [640, 480];
    let sphere = "shape:sphere";
    if wants("layers") {
        let of = |n: usize| {
            (format!("{n} layers"), plan(&worn(&layers(n, 1, "directional"), sphere), size))
        };
        growth(
            &mut renderer,
            "Layers of one directional light, 640x480",
            &[1, 4, 16, 64, 256].map(of),
        );
    }
    if wants("lights") {
        let of =
            |n: usize| (format!("{n} lights"), plan(&worn(&layers(16, n, "point"), sphere), size));
        growth(
            &mut renderer,
            "16 layers of so many point lights, 640x480",
            &[1, 2, 4, 8, 16].map(of),
        );
    }
    if wants("pixels") {
        let setup = worn(&layers(4, 1, "directional"), sphere);
        let of = |side: u32| (format!("{side}x{side}"), plan(&setup, [side; 2]));
        growth(&mut renderer, "4 layers at so many pixels", &[100, 200, 400, 800, 1600].map(of));
    }
    if wants("objects") {
        let one = worn(&layers(4, 1, "directional"), sphere);
        let of = |count: usize| {
            let mut setup = one.clone();
            let side = (count as f64).sqrt().ceil();
            setup.objects = (0..count)
                .map(|index| {
                    let place = DVec3::new(
                        (index as f64 % side) + 0.5,
                        (index as f64 / side).floor() + 0.5,
                        0.0,
                    ) / side;
                    let matrix = DMat4::from_translation(2.0 * place - DVec3::new(1.0, 1.0, 0.0))
                        * DMat4::from_scale(DVec3::splat(1.0 / side));
                    let mut object = one.objects[0].clone();
                    object.id = format!("object{index}").as_str().into();
                    object.world_from_object = matrix * object.world_from_object;
                    object
                })
                .collect();
            (format!("{count} objects"), plan(&setup, size))
        };
        growth(
            &mut renderer,
            "So many spheres of 4 layers that fill the same part of the picture, 640x480",
            &[1, 4, 16, 64].map(of),
        );
    }
}
