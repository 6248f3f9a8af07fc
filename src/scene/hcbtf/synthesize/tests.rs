//! Synthesized tiles: properties that must hold whatever patches are chosen.

use super::*;
use crate::document::{Address, Directions};
use crate::hcbtf::noise::smooth;

const GRID: Grid = {
    let directions = Directions { theta: 2, phi: 3 };
    Grid { size: [20, 16], light: directions, view: directions }
};

/// Smooth noise, of another brightness in each sample, with the texel's own number in red and green
/// of the first.
fn source() -> Hcbtf {
    let mut hcbtf = Hcbtf::new(GRID);
    for (number, address) in GRID.addresses().enumerate() {
        let texels = (0..GRID.texels()).flat_map(|at| {
            let place = [(at % 20) as f32 / 20.0, (at / 20) as f32 / 16.0];
            let gray = (smooth(7, [4, 3], place) * (255.0 - 10.0 * number as f32)) as u8;
            if number == 0 {
                [(at % 256) as u8, (at / 256) as u8, 0, 255]
            } else {
                [gray, gray, 255 - gray, 255]
            }
        });
        hcbtf.painted.insert(address, Arc::new(Tile::new(GRID.size, texels.collect()).unwrap()));
    }
    hcbtf
}

fn made(hcbtf: &Hcbtf, how: &Synthesis) -> Hcbtf {
    synthesize(hcbtf, how, &Progress::new()).unwrap()
}

const HOW: Synthesis = Synthesis { size: [37, 29], seed: 4, patch: None };

/// The source texel of each texel, as the first sample encodes it.
fn origins(hcbtf: &Hcbtf) -> Vec<usize> {
    let tile = hcbtf.painted(Address::default()).unwrap();
    tile.bytes()
        .chunks_exact(4)
        .map(|texel| usize::from(texel[0]) + 256 * usize::from(texel[1]))
        .collect()
}

#[test]
fn every_sample_is_made_of_the_same_texels() {
    let source = source();
    let made = made(&source, &HOW);
    assert_eq!(made.grid, Grid { size: HOW.size, ..GRID });
    assert_eq!(made.painted.len(), source.painted.len());
    let origins = origins(&made);
    for (address, tile) in &made.painted {
        let own = source.painted(*address).unwrap();
        for (texel, origin) in tile.bytes().chunks_exact(4).zip(&origins) {
            assert_eq!(texel, &own.bytes()[4 * origin..4 * origin + 4], "{address}");
        }
    }
    // The new tile is no copy: some neighbors are not neighbors in the source.
    let is_next = |pair: &[usize]| pair[1] == pair[0] + 1;
    assert!(origins.chunks_exact(37).any(|row| row.windows(2).any(|pair| !is_next(pair))));
}

/// No two neighbors of the new tile differ by more than the source's do, not even across its edges,
/// in the samples that are smooth; and on the mean they differ hardly more.
#[test]
fn seams_are_not_seen() {
    let mut source = source();
    source.painted.remove(&Address::default());
    let steps = |hcbtf: &Hcbtf| {
        let [width, height] = hcbtf.grid.size.map(i64::from);
        let (mut most, mut sum) = (0, 0.0);
        for tile in hcbtf.painted.values() {
            for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
                for next in [tile.texel(x + 1, y), tile.texel(x, y + 1)] {
                    let step = tile.texel(x, y)[0].abs_diff(next[0]);
                    most = most.max(step);
                    sum += f64::from(step);
                }
            }
        }
        (f64::from(most), sum / (hcbtf.grid.texels() * hcbtf.painted.len()) as f64)
    };
    let (most, mean) = steps(&source);
    for seed in 0..4 {
        let (found, found_mean) = steps(&made(&source, &Synthesis { seed, ..HOW }));
        assert!(
            found <= 1.6 * most && found_mean < 1.25 * mean,
            "{seed}: {found} of {most}, {found_mean} of {mean}"
        );
    }
}

#[test]
fn it_is_the_same_on_any_number_of_threads_and_another_by_its_seed() {
    let source = source();
    let on = |threads, seed| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| made(&source, &Synthesis { seed, ..HOW }))
    };
    let first = on(1, 4);
    assert_eq!(first, on(3, 4));
    assert_ne!(origins(&first), origins(&on(2, 5)));
}

#[test]
fn rules_stay_where_they_work_on_texels_alone() {
    let mut source = source();
    source.painted.retain(|address, _| *address == Address::default());
    source.rules = vec![
        Rule::Copy { from: Address::default() },
        Rule::Lambert { shadow: [9; 3], amount: 0.5 },
    ];
    let kept = made(&source, &HOW);
    assert_eq!((kept.painted.len(), &kept.rules), (1, &source.rules));
    source.rules.push(Rule::Rotate { turns: 1.0 });
    let baked = made(&source, &HOW);
    assert_eq!((baked.painted.len() as u64, baked.rules.len()), (GRID.sample_count(), 0));
}

#[test]
fn what_cannot_be_made_is_told() {
    let source = source();
    let told = |how: Synthesis| synthesize(&source, &how, &Progress::new()).unwrap_err().code;
    assert_eq!(told(Synthesis { size: [0, 4], ..HOW }), "hcbtf-grid");
    assert_eq!(told(Synthesis { patch: Some(16), ..HOW }), "bad-argument");
    assert_eq!(told(Synthesis { patch: Some(2), ..HOW }), "bad-argument");
    assert_eq!(told(Synthesis { size: [3, 30], ..HOW }), "bad-argument");
    let many = Directions { theta: 3, phi: 8 };
    let many = Hcbtf {
        rules: vec![Rule::Rotate { turns: 1.0 }],
        ..Hcbtf::new(Grid { light: many, view: many, ..GRID })
    };
    let large = Synthesis { size: [4095, 4095], ..HOW };
    assert_eq!(synthesize(&many, &large, &Progress::new()).unwrap_err().code, "too-large");
    let stopped = Progress::new();
    stopped.stop();
    assert_eq!(synthesize(&source, &HOW, &stopped).unwrap_err().code, "stopped");
}
