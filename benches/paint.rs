//! Benchmark of painting: a stamp, a stroke, the edit at its end, a flood fill.
//!
//! `cargo bench` prints the times; docs/performance.md holds the figures.

use std::hint::black_box;
use std::sync::Arc;

use chiaro::document::{Patch, Tile};
use chiaro::hcbtf::paint::{Brush, Flood, Stroke, Symmetry, Tool, fill, line};
use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use glam::DVec2;

const SIZE: [u32; 2] = [512, 512];

/// A tile of noise, which does not compress.
fn noise(size: [u32; 2]) -> Tile {
    let mut state = 1_u32;
    let mut next = || {
        state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        (state >> 24) as u8
    };
    let bytes = (0..4 * size[0] * size[1]).map(|_| next()).collect();
    Tile::new(size, bytes).expect("four bytes a texel")
}

fn benchmark(criterion: &mut Criterion) {
    let base = noise(SIZE);
    let mut group = criterion.benchmark_group("stamp-64-on-512");
    let soft = Brush { size: 64.0, hardness: 0.2, flow: 0.4, spacing: 0.25, ..Brush::default() };
    let stamp = Tool::Stamp(Arc::new(noise([64, 64])));
    for (name, tool) in
        [("paint", Tool::Paint), ("erase", Tool::Erase), ("smudge", Tool::Smudge), ("stamp", stamp)]
    {
        let brush = Brush { tool, ..soft.clone() };
        // One step of the spacing draws one stamp.
        let mut stroke = Stroke::begin(&base, &brush, &Symmetry::default(), true);
        let mut x = 0.0;
        stroke.to(DVec2::new(x, 250.0), 1.0);
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                x = if x > 1e5 { 0.0 } else { x + 16.0 };
                stroke.to(DVec2::new(x, 250.0), 1.0)
            });
        });
    }
    group.finish();

    let mut group = criterion.benchmark_group("512");
    group.bench_function("begin", |bencher| {
        bencher.iter_batched(
            || (),
            |()| Stroke::begin(&base, &soft, &Symmetry::default(), true),
            BatchSize::LargeInput,
        );
    });
    let (from, to) = (DVec2::new(40.0, 60.0), DVec2::new(470.0, 430.0));
    for (name, base, brush) in [
        (
            "hard-32-on-flat",
            &Tile::filled(SIZE, [90, 120, 60, 255]),
            &Brush { size: 32.0, ..Brush::default() },
        ),
        ("soft-64-on-noise", &base, &soft),
    ] {
        group.bench_function(format!("{name}/line"), |bencher| {
            bencher.iter(|| line(base, brush, &Symmetry::default(), true, from, to));
        });
        let after = line(base, brush, &Symmetry::default(), true, from, to);
        let patch = Patch::between(base, &after);
        let changed =
            base.bytes().chunks(4).zip(after.bytes().chunks(4)).filter(|(a, b)| a != b).count();
        let bytes = patch.map_or(0, |patch| patch.memory());
        group.bench_function(format!("{name}/edit ({changed} texels, {bytes} bytes)"), |bencher| {
            bencher.iter(|| Patch::between(black_box(base), &after));
        });
    }
    let flood = Flood { tolerance: 1.0, edge: Flood::EDGE, wraps: true };
    group.bench_function("flood", |bencher| {
        bencher.iter(|| fill(black_box(&base), [9, 9], [7; 4], flood));
    });
    group.finish();
}

criterion_group!(benches, benchmark);
criterion_main!(benches);
