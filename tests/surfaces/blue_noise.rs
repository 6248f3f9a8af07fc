//! The tile of blue noise that dither and dots share: made here by void and cluster (Ulichney
//! 1993), and tested to be blue noise. `CHIARO_BLESS=1` writes the tile.

use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::path::Path;

const SIDE: usize = 32;
const CELLS: usize = SIDE * SIDE;

/// The weight that a point adds at each offset from it, on a torus. Whole numbers, so that every
/// machine ranks cells alike.
fn weights() -> Vec<u64> {
    let apart = |d: usize| d.min(SIDE - d) as f64;
    let weight = |index: usize| {
        let square = apart(index % SIDE).powi(2) + apart(index / SIDE).powi(2);
        ((-square / (2.0 * 1.9_f64.powi(2))).exp() * f64::from(1_u32 << 24)).round() as u64
    };
    (0..CELLS).map(weight).collect()
}

struct Pattern {
    weights: Vec<u64>,
    is_set: Vec<bool>,
    felt: Vec<u64>,
}

impl Pattern {
    fn toggle(&mut self, at: usize) {
        self.is_set[at] = !self.is_set[at];
        for index in 0..CELLS {
            let x = (index % SIDE + SIDE - at % SIDE) % SIDE;
            let y = (index / SIDE + SIDE - at / SIDE) % SIDE;
            let weight = self.weights[y * SIDE + x];
            if self.is_set[at] {
                self.felt[index] += weight;
            } else {
                self.felt[index] -= weight;
            }
        }
    }

    /// The point with the greatest sum of weights: the tightest cluster.
    fn cluster(&self) -> usize {
        let points = (0..CELLS).filter(|&at| self.is_set[at]);
        points.max_by_key(|&at| (self.felt[at], CELLS - at)).expect("there are points")
    }

    /// The empty cell with the smallest sum of weights: the largest void.
    fn void(&self) -> usize {
        let free = (0..CELLS).filter(|&at| !self.is_set[at]);
        free.min_by_key(|&at| (self.felt[at], at)).expect("there is room")
    }
}

/// Rank of each cell: the order in which void and cluster fills the cells, from 0.
fn ranks() -> Vec<usize> {
    let mut pattern =
        Pattern { weights: weights(), is_set: vec![false; CELLS], felt: vec![0; CELLS] };
    // Random points, moved out of clusters into voids until a move changes nothing.
    let mut state = 1_u32;
    let first = CELLS / 10;
    while pattern.is_set.iter().filter(|set| **set).count() < first {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let at = (state >> 16) as usize % CELLS;
        if !pattern.is_set[at] {
            pattern.toggle(at);
        }
    }
    loop {
        let from = pattern.cluster();
        pattern.toggle(from);
        let to = pattern.void();
        pattern.toggle(to);
        if from == to {
            break;
        }
    }
    let mut ranks = vec![0; CELLS];
    let start = (pattern.is_set.clone(), pattern.felt.clone());
    for rank in (0..first).rev() {
        let at = pattern.cluster();
        pattern.toggle(at);
        ranks[at] = rank;
    }
    (pattern.is_set, pattern.felt) = start;
    for rank in first..CELLS {
        let at = pattern.void();
        pattern.toggle(at);
        ranks[at] = rank;
    }
    ranks
}

fn source(ranks: &[usize]) -> String {
    let mut text = "\
// Made by tests/surfaces/blue_noise.rs: ranks of 32 by 32 cells by void and cluster (Ulichney
// 1993). The cells below any rank lie evenly, without a pattern and without clumps. A number holds
// the ranks of four cells, 0 to 255 each, the first in the lowest byte.
const BLUE_TILE = array<u32, 256>(
"
    .to_owned();
    for row in ranks.chunks(SIDE / 2) {
        let numbers = row.chunks(4).map(|four| {
            let number =
                four.iter().enumerate().fold(0, |sum, (i, rank)| sum | (rank / 4) << (8 * i));
            format!("0x{number:08x}u")
        });
        let _ = writeln!(text, "    {},", numbers.collect::<Vec<_>>().join(", "));
    }
    text += "\
);

/// Index of the number of the repeating tile that holds a cell's rank.
fn blue_index(cell: vec2i) -> u32 {
    let at = bitcast<vec2u>(cell) & vec2u(31u);
    return 8u * at.y + (at.x >> 2u);
}

/// Threshold of a cell within its number of the tile, between 0 and 1.
fn blue_part(four: u32, cell: vec2i) -> f32 {
    return (f32((four >> (8u * (bitcast<u32>(cell.x) & 3u))) & 0xffu) + 0.5) * 0.00390625;
}

/// Threshold of a cell, between 0 and 1: blue noise. Callers that ask for several keep a copy of
/// the tile of their own, because compilers make one at every call.
fn blue_threshold(cell: vec2i) -> f32 {
    return blue_part(BLUE_TILE[blue_index(cell)], cell);
}
";
    text
}

#[test]
fn the_tile_is_what_void_and_cluster_makes() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("shaders/lib/blue_noise.wgsl");
    let wanted = source(&ranks());
    if std::env::var_os("CHIARO_BLESS").is_some() {
        std::fs::write(&path, &wanted).unwrap();
    }
    assert_eq!(std::fs::read_to_string(&path).unwrap(), wanted, "run with CHIARO_BLESS=1");
}

/// White noise has the same power at every frequency; blue noise has next to none at low
/// frequencies.
#[test]
fn low_frequencies_have_no_power() {
    let ranks = ranks();
    for share in [0.1, 0.3, 0.5, 0.8] {
        let power = |u: usize, v: usize| {
            let (mut re, mut im) = (0.0, 0.0);
            for (at, _) in
                ranks.iter().enumerate().filter(|(_, rank)| (**rank as f64) < share * CELLS as f64)
            {
                let phase = TAU * ((u * (at % SIDE) + v * (at / SIDE)) % SIDE) as f64 / SIDE as f64;
                re += phase.cos();
                im += phase.sin();
            }
            // The power, scaled to be 1 for white noise.
            (re * re + im * im) / (CELLS as f64 * share * (1.0 - share))
        };
        let low: Vec<f64> = (0..=3)
            .flat_map(|u| (0..=3).map(move |v| (u, v)))
            .skip(1)
            .map(|(u, v)| power(u, v))
            .collect();
        let mean = low.iter().sum::<f64>() / low.len() as f64;
        assert!(mean < 0.08, "share {share}: {mean}");
    }
}
