//! Benchmark of generated modules against WGSL that an expert writes by hand for the same picture
//! (`tests/truth/handwritten.rs` checks that the pictures are the same).
//!
//! `cargo bench --no-default-features --features gpu --bench handwritten` prints a row for each
//! look of `benches/handwritten/` and each tier, with ratios of the generated module to the
//! handwritten one: SPIR-V instructions (in functions, both stages; as naga writes them, and after
//! `spirv-opt -O` if that is installed), time of the look pass (the GPU's own clock, in turns,
//! median with its 95% interval) and lines (without comments).
#![allow(clippy::print_stdout, reason = "what it is for")]
#![allow(missing_docs, reason = "a program")]
#![allow(clippy::disallowed_methods, reason = "it asks another program to optimize")]

#[path = "support/spirv.rs"]
mod spirv;
use chiaro::accuracy::TimeEstimate;
use chiaro::accuracy::cost::{Series, alternate};
use chiaro::document::Tier;
use chiaro::export::spirv_words;
use chiaro::frame::{CompiledShader, FramePlan, PassId};
use chiaro::progress::Progress;
use chiaro::render::{Gpu, Renderer};
use chiaro_test_drawing::handwritten;
use chiaro_test_drawing::wait::block_on;
use spirv::{instructions, optimized};

const SIZE: [u32; 2] = [800, 600];
const ROUNDS: usize = 41;

/// Instructions of a module as naga writes it, and as `spirv-opt -O` leaves it.
fn sizes(shader: &CompiledShader) -> [Option<usize>; 2] {
    let words = spirv_words(&shader.valid).expect("SPIR-V can express it");
    [Some(instructions(&words)), optimized(&words).map(|words| instructions(&words))]
}

/// Number of lines that hold more than a comment.
fn lines(shader: &CompiledShader) -> usize {
    let is_code = |line: &&str| !line.trim().is_empty() && !line.trim_start().starts_with("//");
    shader.wgsl.lines().filter(is_code).count()
}

/// Times of the look pass alone.
fn look_pass(series: &Series) -> &[f64] {
    series.passes.iter().find(|(pass, _)| *pass == PassId::LOOK).map_or(&[], |(_, times)| times)
}

fn main() {
    let gpu = block_on(Gpu::headless()).expect("a GPU, a software one for one");
    println!("{}, {}x{}, one sample a pixel\n", gpu.name(), SIZE[0], SIZE[1]);
    println!("| look | tier | instructions: naga | spirv-opt -O | look pass | by hand | lines |");
    println!("| --- | --- | ---: | ---: | ---: | ---: | ---: |");
    let mut renderer = Renderer::new(gpu);
    let tiers = [Tier::Exact, Tier::Balanced, Tier::Fast];
    for look in handwritten::LOOKS {
        let setup = handwritten::setup(look);
        let generated: Vec<FramePlan> =
            tiers.iter().map(|tier| handwritten::generated(&setup, *tier, SIZE)).collect();
        let hand = handwritten::by_hand(&setup, look, &generated[0]);
        let plans: Vec<&FramePlan> = generated.iter().chain([&hand]).collect();
        let series = block_on(alternate(&mut renderer, &plans, ROUNDS, &Progress::new()));
        let series = series.unwrap_or_else(|_| panic!("{} was stopped", look.name));
        let by_hand =
            (look_pass(&series[3]), sizes(&hand.draws[0].look), lines(&hand.draws[0].look));
        for ((tier, plan), series) in tiers.iter().zip(&generated).zip(&series) {
            let shader = &plan.draws[0].look;
            let pairs: Vec<f64> =
                look_pass(series).iter().zip(by_hand.0).map(|(a, b)| a / b).collect();
            let time = TimeEstimate::of(&pairs);
            let ratios =
                sizes(shader).into_iter().zip(by_hand.1).map(|(own, hand)| match (own, hand) {
                    (Some(own), Some(hand)) => {
                        format!("{own} / {hand} = {:.2}", own as f64 / hand as f64)
                    }
                    _ => "?".to_owned(),
                });
            let [naga, optimized] = ratios.collect::<Vec<_>>().try_into().expect("two");
            let (own, hand) = (lines(shader), by_hand.2);
            println!(
                "| {} | {tier:?} | {naga} | {optimized} | {:.2} ({:.2} to {:.2}) | {:.2} ms | \
                 {own} / {hand} = {:.2} |",
                look.name,
                time.median,
                time.low,
                time.high,
                TimeEstimate::of(by_hand.0).median,
                own as f64 / hand as f64
            );
        }
    }
}
