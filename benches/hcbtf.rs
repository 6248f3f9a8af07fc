//! Benchmark of HCBTFs: the thesis's two scenes (chapter 11) in each tier and storage, the times of
//! filling and storing an HCBTF, and the memory of grids of growing size.
//!
//! `cargo bench --profile dev --no-default-features --features gpu --bench hcbtf` prints all parts,
//! `-- frames`, `-- baking` or `-- memory` a single one; docs/performance.md holds the figures.
//! After `frames`, a size as `1600x1200` takes the place of 1280x720, and other words choose the
//! frames whose names have all of them: `-- frames city smooth quick`. With `together` each is
//! drawn once more without its depths before its colors.
#![allow(clippy::print_stdout, reason = "it is what a benchmark is for")]

use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use chiaro::accuracy::Variant;
use chiaro::accuracy::cost::alternate;
use chiaro::compile::Live;
use chiaro::document::{
    Address, Camera, Directions, Grid, Hcbtf, HcbtfAngle, Look, Rule, Scene, Storage, Tier, Tile,
    Transform,
};
use chiaro::frame::{
    FramePlan, PlanOptions, Planner, Setup, SetupLook, SetupObject, object_matrix,
};
use chiaro::geometry::shape;
use chiaro::hcbtf::{self, LayerOptions, needs, needs_at_most};
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::render::{Gpu, Renderer};
use chiaro_test_drawing::wait::block_on;
use glam::{DMat4, DVec3};
use serde_json::json;

const SIZE: [u32; 2] = [1280, 720];
const ROUNDS: usize = 5;
/// Word that asks for each frame once more, with depths and colors drawn together.
const TOGETHER: &str = "together";

/// An HCBTF whose samples are all painted, with texels of `colors` different colors.
fn painted(grid: Grid, colors: u32) -> Hcbtf {
    let mut hcbtf = Hcbtf::new(grid);
    for (number, address) in (1_u32..).zip(grid.addresses()) {
        let [light, view] = [grid.light.vector(address.light), grid.view.vector(address.view)];
        let texel = |at: u32| {
            let noise = (at.wrapping_mul(0x9e37_79b1) ^ number.wrapping_mul(0x85eb_ca77))
                .wrapping_mul(0xc2b2_ae35)
                >> 8;
            let tone = noise % colors;
            let [r, g] = [light.x, view.y].map(|x| (128.0 + 60.0 * x) as u32);
            match colors {
                0..=256 => [tone as u8, (tone * 7) as u8, (tone * 31) as u8, 255],
                _ => [(r + tone % 60) as u8, (g + tone / 60 % 60) as u8, (tone / 3600) as u8, 255],
            }
        };
        let bytes = (0..grid.texels() as u32).flat_map(texel).collect();
        hcbtf.painted.insert(address, Arc::new(Tile::new(grid.size, bytes).expect("its size")));
    }
    hcbtf
}

fn look(path: &Path, kind: &str, lookup: &str, storage: Storage, repeats: f64) -> SetupLook {
    let mut values = json!({
        "sheet": path.display().to_string(), "storage": storage.word(), "scale": [repeats, repeats],
    });
    if kind == "hcbtf_lookup" {
        values["lookup"] = lookup.into();
    }
    let json = json!({
        "lights": {"key": {"direction": [0.4, 0.8, 0.5]}},
        "nodes": [
            {"id": "light", "kind": "light", "values": {"light": "key"}},
            {"id": "paint", "kind": kind, "values": values},
            {"id": "output", "kind": "output"}
        ],
        "wires": [{"from": "light", "to": "paint.light"}, {"from": "paint", "to": "output.color"}]
    });
    let loaded = Look::read(&json.to_string(), "bench.json");
    SetupLook {
        look: loaded.value.expect("a look"),
        source: loaded.source.into(),
        folder: PathBuf::new(),
    }
}

fn object(name: &str, matrix: DMat4) -> SetupObject {
    let mesh = Arc::new(shape(name).expect("an own shape"));
    let world_from_object = matrix * object_matrix(&Transform::default(), &mesh);
    SetupObject {
        id: name.into(),
        looks: vec![Some(0); mesh.parts.len()],
        mesh,
        world_from_object,
        values: Default::default(),
        light_link: Default::default(),
        shadow_link: Default::default(),
        layers: Default::default(),
        animation: None,
    }
}

/// The waves with the ball over them, and the city, both so near that they fill the picture's
/// width.
fn scenes() -> [(&'static str, f64, Vec<SetupObject>, DVec3); 2] {
    let lying = DMat4::from_rotation_x(-std::f64::consts::FRAC_PI_2);
    let ball =
        DMat4::from_translation(DVec3::new(0.0, 0.45, 0.0)) * DMat4::from_scale(DVec3::splat(0.3));
    [
        (
            "waves and ball",
            12.0,
            vec![object("waves", lying), object("ball", ball)],
            DVec3::new(0.0, 1.1, 2.1),
        ),
        ("city", 1.0, vec![object("city", DMat4::IDENTITY)], DVec3::new(0.0, 1.0, 1.9)),
    ]
}

/// Processor time that this process has taken so far, all of its threads together, in
/// milliseconds; 0 where nobody tells.
fn processor_time() -> f64 {
    // Ticks of a hundredth of a second, the 14th and 15th number.
    let told = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let after = told.rsplit(')').next().unwrap_or_default();
    let ticks = after.split_whitespace().skip(11).take(2);
    ticks.filter_map(|ticks| ticks.parse::<f64>().ok()).sum::<f64>() * 10.0
}

/// Processor time of a frame, in milliseconds: the mean of `rounds` frames.
fn processor_cost(renderer: &mut Renderer, plan: &FramePlan, rounds: usize) -> f64 {
    let before = processor_time();
    for _ in 0..rounds {
        block_on(renderer.measure(plan)).expect("it draws");
    }
    (processor_time() - before) / rounds as f64
}

fn frames(path: &Path, words: &[String]) {
    let mut renderer = Renderer::new(block_on(Gpu::headless()).expect("a device"));
    let size_of = |word: &String| {
        let (width, height) = word.split_once('x')?;
        Some([width.parse().ok()?, height.parse().ok()?])
    };
    let size = words.iter().find_map(size_of).unwrap_or(SIZE);
    println!(
        "{}, {} x {}; the least and the median of {ROUNDS}, and processor time",
        renderer.gpu().name(),
        size[0],
        size[1]
    );
    let lookups =
        [("hcbtf_lookup", "smooth", 3), ("hcbtf_lookup", "texels", 3), ("hcbtf_nearest", "", 1)];
    for (scene, repeats, objects, eye) in scenes() {
        let mut planner = Planner::default();
        let mut all = Vec::new();
        for ((kind, lookup, tiers), storage) in
            lookups.into_iter().flat_map(|one| Storage::ALL.map(|it| (one, it)))
        {
            let named = [Tier::Exact, Tier::Balanced, Tier::Fast].map(Some).into_iter().take(tiers);
            for tier in named.chain([None]) {
                let told = tier.map_or("by default".to_owned(), |tier| format!("{tier:?}"));
                let name = format!(
                    "{scene}, {kind} {lookup}, {}, {}",
                    storage.word(),
                    told.to_lowercase()
                );
                let is_wanted = |word: &String| {
                    size_of(word).is_some() || word == TOGETHER || name.contains(word.as_str())
                };
                if !words.iter().all(is_wanted) {
                    continue;
                }
                let camera = Camera { eye: eye.to_array(), ..Camera::default() };
                let setup = Setup {
                    scene: Scene { camera, ..Scene::default() },
                    looks: vec![look(path, kind, lookup, storage, repeats)],
                    objects: objects.clone(),
                    ..Setup::default()
                };
                let options = PlanOptions { size, samples: 1, time: 0.0 };
                let mut setup = Variant::Looks(tier.unwrap_or_default()).of(&setup);
                setup.looks.iter_mut().for_each(|worn| worn.look.tier = tier);
                let plan = planner
                    .plan(&setup, Library::built_in(), &Live::Keyed, &options)
                    .expect("it compiles")
                    .value;
                if words.iter().any(|word| word == TOGETHER) {
                    let mut together = plan.clone();
                    together.draws.iter_mut().for_each(|draw| draw.depth_first = false);
                    all.push((format!("{name}, {TOGETHER}"), together));
                }
                all.push((name, plan));
            }
        }
        let plans: Vec<&FramePlan> = all.iter().map(|(_, plan)| plan).collect();
        let series = block_on(alternate(&mut renderer, &plans, ROUNDS, &Progress::new()));
        for ((name, plan), series) in all.iter().zip(series.unwrap_or_else(|_| panic!("{scene}"))) {
            let least = series.frame.iter().copied().fold(f64::MAX, f64::min);
            let rounds = (2e3 / least).clamp(3.0, 40.0) as usize;
            println!(
                "{name}: {least:.1} ms ({:.1}), {:.1} fps; {:.0} ms of processors",
                series.estimate().median,
                1e3 / least,
                processor_cost(&mut renderer, plan, rounds)
            );
        }
    }
}

#[expect(clippy::disallowed_methods, reason = "a benchmark is about time")]
fn seconds<T>(of: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let made = of();
    (made, start.elapsed().as_secs_f64())
}

/// Prints the time until a shader can read an HCBTF: of filling it by rules, and of laying it out.
fn baking(grid: Grid) {
    let all = painted(grid, 100_000);
    let few: Vec<Address> = all.painted.keys().step_by(97).copied().collect();
    let mut sparse = Hcbtf::new(grid);
    sparse.painted.extend(few.into_iter().map(|address| (address, all.painted[&address].clone())));
    for (name, rules) in [
        ("blend", vec![Rule::Blend { sharpness: 1.5 }]),
        (
            "lock the view",
            vec![
                Rule::Lock { angles: vec![HcbtfAngle::ViewTheta, HcbtfAngle::ViewPhi] },
                Rule::Blend { sharpness: 1.5 },
            ],
        ),
    ] {
        let hcbtf = Hcbtf { rules, ..sparse.clone() };
        let (filled, time) =
            seconds(|| hcbtf::fill::fill(&hcbtf, &Progress::new()).expect("it fits"));
        println!(
            "fill, {name}, {} painted: {time:.2} s, {} tiles",
            hcbtf.painted.len(),
            filled.tiles().len()
        );
        for storage in Storage::ALL {
            for has_levels in [false, true] {
                let options = LayerOptions { has_levels, is_decoded: false, storage };
                let of = |address| filled.tile(address);
                let (layers, time) = seconds(|| {
                    hcbtf::stored(&grid, of, options, &Progress::new()).expect("it fits")
                });
                let mib = layers.bytes.len() as f64 / f64::from(1 << 20);
                println!("  {}, levels {has_levels}: {time:.3} s, {mib:.2} MiB", storage.word());
                black_box(layers);
            }
        }
    }
}

fn memory(grids: &[Grid]) {
    let mib = |bytes: u64| bytes as f64 / f64::from(1 << 20);
    for grid in grids {
        let few = painted(*grid, 64);
        let with_palettes = needs(grid, |address| few.painted(address));
        for (most, few) in
            needs_at_most(grid).iter().zip(with_palettes).filter(|(most, _)| most.has_levels)
        {
            println!(
                "{grid:?}: {}, {:.1} MiB in {:?}; of 64 colors {:.1} MiB",
                most.storage.word(),
                mib(most.bytes()),
                most.size,
                mib(few.bytes())
            );
        }
    }
}

fn main() {
    let grid = |side: u32, theta: u32, phi: u32| {
        let directions = Directions { theta, phi };
        Grid { size: [side; 2], light: directions, view: directions }
    };
    let wanted: Vec<String> =
        std::env::args().skip(1).filter(|word| !word.starts_with('-')).collect();
    let is_wanted = |part: &str| wanted.is_empty() || wanted.iter().any(|word| word == part);
    if is_wanted("frames") {
        let words: Vec<String> = wanted.iter().filter(|word| *word != "frames").cloned().collect();
        thesis_scenes(&words);
    }
    if is_wanted("baking") {
        baking(Grid::THESIS);
    }
    if is_wanted("memory") {
        memory(&[grid(8, 3, 6), grid(16, 4, 8), Grid::THESIS, grid(64, 6, 10), grid(64, 9, 16)]);
    }
}

fn thesis_scenes(words: &[String]) {
    let path = std::env::temp_dir().join(format!("chiaro-bench-{}.hcbtf", std::process::id()));
    let bytes = hcbtf::write(&painted(Grid::THESIS, 100_000)).expect("it fits");
    std::fs::write(&path, bytes).expect("a temporary file");
    frames(&path, words);
    let _ = std::fs::remove_file(&path);
}
