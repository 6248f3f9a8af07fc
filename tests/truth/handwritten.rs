//! Handwritten modules, which generated modules are measured against, draw the same pictures:
//! `benches/handwritten.rs` tells the rest.
#![cfg(feature = "gpu")]

use crate::support::eval::renderer;
use crate::support::handwritten::{LOOKS, by_hand, generated, setup};
use crate::support::wait::block_on;
use chiaro::document::Tier;
use chiaro::render::Renderer;

/// 8-bit pictures of both are equal, except for the rounding of a step.
#[test]
#[allow(clippy::print_stdout, reason = "figures for those who ask with `--nocapture`")]
fn handwritten_modules_draw_what_generated_ones_draw() {
    for look in LOOKS {
        let setup = setup(look);
        let plan = generated(&setup, Tier::Exact, [400, 300]);
        let hand = by_hand(&setup, look, &plan);
        let gpu = renderer().gpu().precise();
        let mut renderer = Renderer::new(gpu);
        let mut draw =
            |plan| block_on(renderer.picture(plan)).unwrap_or_else(|error| panic!("{error}"));
        let (wanted, got) = (draw(&plan), draw(&hand));
        let mut worst = (0.0_f32, 0);
        let mut over = 0;
        for (index, (wanted, got)) in wanted.rgba.iter().zip(&got.rgba).enumerate() {
            let error = (0..4).map(|c| (wanted[c] - got[c]).abs()).fold(0.0, f32::max);
            over += usize::from(error > 1.0 / 255.0);
            if error > worst.0 {
                worst = (error, index);
            }
        }
        println!("| {look} | {:.1e} | {over} |", worst.0);
        let place = [worst.1 % 400, worst.1 / 400];
        assert!(worst.0 <= 1.0 / 255.0, "{look}: {} at {place:?}, {over} pixels", worst.0);
    }
}
