//! Benchmark of generated modules against WGSL that an expert writes by hand for the same picture
//! (`tests/truth/handwritten.rs` checks that the pictures are the same).
//!
//! `cargo bench --no-default-features --features gpu --bench handwritten` prints a row for each
//! look of `benches/handwritten/` and each tier, with ratios of the generated module to the
//! handwritten one: SPIR-V instructions in functions, both stages (as naga writes them, and after
//! `spirv-opt -O` if that is installed), all instructions of the fragment stage's own module after
//! `spirv-opt -O`, time of the look pass (the GPU's own clock, in turns, median with its 95%
//! interval) and lines (without comments). After `--`, words choose the looks whose names have one
//! of them, a size as `1600x1200` takes the place of 800x600, and `--counts` leaves out the times,
//! and with them the GPU: `-- math --counts`.
#![allow(clippy::print_stdout, reason = "what it is for")]
#![allow(missing_docs, reason = "a program")]

use chiaro::accuracy::TimeEstimate;
use chiaro::accuracy::cost::{Series, alternate};
use chiaro::document::Tier;
use chiaro::export::{fragment_spirv_words, spirv_words};
use chiaro::frame::{CompiledShader, FramePlan, PassId};
use chiaro::progress::Progress;
use chiaro::render::{Gpu, Renderer};
use chiaro_test_drawing::handwritten::{self, HandwrittenLook};
use chiaro_test_drawing::spirv::{function_instructions, module_instructions, optimized};
use chiaro_test_drawing::wait::block_on;

const ROUNDS: usize = 41;
const TIERS: [Option<Tier>; 4] = [None, Some(Tier::Exact), Some(Tier::Balanced), Some(Tier::Fast)];

/// Counted sizes of a module.
struct ModuleCounts {
    /// Instructions in functions, both stages, as naga writes them.
    naga: usize,
    /// Instructions in functions, both stages, after `spirv-opt -O`.
    optimized: Option<usize>,
    /// All instructions of the fragment stage's own module after `spirv-opt -O`.
    fragment: Option<usize>,
    /// Lines that hold more than a comment.
    lines: usize,
}

impl ModuleCounts {
    fn of(shader: &CompiledShader) -> Self {
        let words = spirv_words(&shader.valid).expect("SPIR-V can express it");
        let fragment = fragment_spirv_words(&shader.valid).expect("it has a fragment stage");
        let is_code = |line: &&str| !line.trim().is_empty() && !line.trim_start().starts_with("//");
        Self {
            naga: function_instructions(&words),
            optimized: optimized(&words).map(|words| function_instructions(&words)),
            fragment: optimized(&fragment).map(|words| module_instructions(&words)),
            lines: shader.wgsl.lines().filter(is_code).count(),
        }
    }

    /// Cells of a table that hold each count of the generated module beside that of the handwritten
    /// one.
    fn ratios(&self, hand: &Self) -> [String; 4] {
        let cell = |own: Option<usize>, hand: Option<usize>| match (own, hand) {
            (Some(own), Some(hand)) => format!("{own} / {hand} = {:.2}", own as f64 / hand as f64),
            _ => "?".to_owned(),
        };
        [
            cell(Some(self.naga), Some(hand.naga)),
            cell(self.optimized, hand.optimized),
            cell(self.fragment, hand.fragment),
            cell(Some(self.lines), Some(hand.lines)),
        ]
    }
}

/// Times of the look pass alone.
fn look_pass(series: &Series) -> &[f64] {
    series.passes.iter().find(|(pass, _)| *pass == PassId::LOOK).map_or(&[], |(_, times)| times)
}

/// Cells of a table that hold the time of the look pass with the generated module, as a part of
/// that with the handwritten one, and the latter in ms; dashes where no time was taken.
fn time_cells(times: Option<(&[f64], &[f64])>) -> [String; 2] {
    let Some((own, hand)) = times else { return ["-"; 2].map(str::to_owned) };
    let ratios: Vec<f64> = own.iter().zip(hand).map(|(own, hand)| own / hand).collect();
    let TimeEstimate { median, low, high } = TimeEstimate::of(&ratios);
    let hand = TimeEstimate::of(hand).median;
    [format!("{median:.2} ({low:.2} to {high:.2})"), format!("{hand:.2} ms")]
}

/// Prints the rows of a look; without times where there is no renderer.
fn report(look: HandwrittenLook, size: [u32; 2], renderer: Option<&mut Renderer>) {
    let setup = handwritten::setup(look);
    let mut plans: Vec<FramePlan> =
        TIERS.iter().map(|tier| handwritten::generated(&setup, *tier, size)).collect();
    let by_hand = handwritten::by_hand(&setup, look, &plans[0]);
    plans.push(by_hand);
    let series = renderer.map(|renderer| {
        let plans: Vec<&FramePlan> = plans.iter().collect();
        let series = block_on(alternate(renderer, &plans, ROUNDS, &Progress::new()));
        series.unwrap_or_else(|_| panic!("{} was stopped", look.name))
    });
    let hand = ModuleCounts::of(&plans[TIERS.len()].draws[0].look);
    for (index, tier) in TIERS.iter().enumerate() {
        let counts = ModuleCounts::of(&plans[index].draws[0].look);
        let [naga, optimized, fragment, lines] = counts.ratios(&hand);
        let times = series
            .as_ref()
            .map(|series| (look_pass(&series[index]), look_pass(&series[TIERS.len()])));
        let [pass, by_hand] = time_cells(times);
        println!(
            "| {} | {} | {naga} | {optimized} | {fragment} | {pass} | {by_hand} | {lines} |",
            look.name,
            tier.map_or("by default".to_owned(), |tier| format!("{tier:?}").to_lowercase()),
        );
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&String> = arguments.iter().filter(|word| !word.starts_with('-')).collect();
    let size_of = |word: &&String| {
        let (width, height) = word.split_once('x')?;
        Some([width.parse().ok()?, height.parse().ok()?])
    };
    let size: [u32; 2] = words.iter().find_map(size_of).unwrap_or([800, 600]);
    let words: Vec<&String> = words.into_iter().filter(|word| size_of(word).is_none()).collect();
    let is_asked = |look: &HandwrittenLook| {
        words.is_empty() || words.iter().any(|word| look.name.contains(word.as_str()))
    };
    let are_timed = !arguments.iter().any(|argument| argument == "--counts");
    let mut renderer = are_timed.then(|| {
        let gpu = block_on(Gpu::headless()).expect("a GPU, a software one for one");
        println!("{}, {}x{}, one sample a pixel\n", gpu.name(), size[0], size[1]);
        Renderer::new(gpu)
    });
    println!(
        "| look | tier | instructions: naga | spirv-opt -O | fragment's module, spirv-opt -O | \
         look pass | by hand | lines |"
    );
    println!("| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |");
    for look in handwritten::LOOKS.into_iter().filter(is_asked) {
        report(look, size, renderer.as_mut());
    }
}
