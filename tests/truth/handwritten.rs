//! Handwritten modules, which generated modules are measured against, draw the same pictures:
//! `benches/handwritten.rs` tells the rest.
#![cfg(feature = "gpu")]

use std::collections::BTreeSet;

use crate::support::eval::renderer;
use crate::support::handwritten::{LOOKS, by_hand, generated, setup};
use crate::support::wait::block_on;
use crate::support::{files, root};
use chiaro::document::Tier;
use chiaro::render::Renderer;

/// 8-bit pictures of both are equal, except for the rounding of a step.
#[test]
#[allow(clippy::print_stdout, reason = "figures for those who ask with `--nocapture`")]
fn handwritten_modules_draw_what_generated_ones_draw() {
    for look in LOOKS {
        let setup = setup(look);
        let plan = generated(&setup, Some(Tier::Exact), [400, 300]);
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
        let name = look.name;
        println!("| {name} | {:.1e} | {over} |", worst.0);
        let place = [worst.1 % 400, worst.1 / 400];
        assert!(worst.0 <= 1.0 / 255.0, "{name}: {} at {place:?}, {over} pixels", worst.0);
    }
}

/// Every module in the folder is one of a listed look, and every measured look has its module.
#[test]
fn every_handwritten_module_is_compared() {
    let stems = |extension: &str| -> BTreeSet<String> {
        let found = files::below(&root().join("benches/handwritten")).into_iter();
        found
            .filter(|path| path.extension().is_some_and(|kind| kind == extension))
            .map(|path| path.file_stem().unwrap_or_default().to_string_lossy().into_owned())
            .collect()
    };
    let listed: BTreeSet<String> = LOOKS.iter().map(|look| look.name.to_owned()).collect();
    assert_eq!(stems("wgsl"), listed);
    assert!(stems("json").is_subset(&listed), "{:?}", stems("json"));
}
