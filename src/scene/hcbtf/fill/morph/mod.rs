//! Moving of strokes between painted samples, where a blend would fade one in while the other goes
//! (thesis 12).
//!
//! Each of the two or three nearest samples is moved along its [`Flow`]s to where its content is
//! between all of them, by their weights, and they are blended there. Where no part of one sample
//! resembles a part of the other there is no motion, and the result is the blend.

mod flow;

use std::collections::{BTreeSet, HashMap};

use glam::Vec2;
use rayon::iter::{IntoParallelIterator as _, ParallelIterator as _};

use self::flow::Flow;
use super::blend;
use super::plan::PaintedSample;
use crate::document::{Address, Grid, Tile};
use crate::hcbtf::generate::Color;
use crate::progress::Progress;

/// Greatest number of samples that are moved toward each other.
const NEAREST: usize = 3;
/// Greatest number of pairs of samples with a flow, which bounds the memory; further pairs are
/// blended without being moved.
const MAX_PAIRS: usize = 8192;
/// Number of iterations in the search for the place that moves to a given one.
const ROUNDS: usize = 12;

/// The nearest painted samples by number, with weights that sum to 1.
fn nearest(
    address: Address,
    sharpness: f64,
    grid: &Grid,
    painted: &[PaintedSample<'_>],
) -> Vec<(u32, f32)> {
    let mut weights = blend::weights(address, sharpness, grid, painted);
    // Of equal weights the first sample comes first, so that the order is always the same.
    weights.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
    weights.truncate(NEAREST);
    let sum: f32 = weights.iter().map(|(_, weight)| weight).sum();
    weights.iter_mut().for_each(|(_, weight)| *weight /= sum);
    weights
}

/// Flows between pairs of painted samples, by their numbers.
#[derive(Default)]
pub(super) struct Flows {
    known: HashMap<[u32; 2], Flow>,
}

impl Flows {
    /// Time that the flow of a pair takes, in tiles.
    pub(super) const TILES_AHEAD: u64 = 8;

    /// The pairs that these samples need, each sample an address and a sharpness; `None` if the
    /// work is stopped.
    pub(super) fn pairs(
        samples: impl Iterator<Item = (Address, f64)>,
        grid: &Grid,
        painted: &[PaintedSample<'_>],
        progress: &Progress,
    ) -> Option<BTreeSet<[u32; 2]>> {
        let mut pairs = BTreeSet::new();
        for (address, sharpness) in samples {
            if progress.is_stopped() {
                return None;
            }
            let near = nearest(address, sharpness, grid, painted);
            let all = near.iter().flat_map(|a| near.iter().map(move |b| [a.0, b.0]));
            pairs.extend(all.filter(|[a, b]| a != b));
            if pairs.len() >= MAX_PAIRS {
                break;
            }
        }
        Some(pairs)
    }

    /// Computes the flows of all these pairs; `None` if the work is stopped.
    pub(super) fn new(
        pairs: BTreeSet<[u32; 2]>,
        is_tiling: bool,
        painted: &[PaintedSample<'_>],
        progress: &Progress,
    ) -> Option<Self> {
        let flow = |pair: [u32; 2]| {
            let [from, to] = pair.map(|number| painted.get(number as usize));
            let found = Flow::new(from?.tile, to?.tile, is_tiling, progress)?;
            progress.add(Self::TILES_AHEAD * u64::from(from?.tile.size()[1]));
            Some((pair, found))
        };
        let pairs: Vec<[u32; 2]> = pairs.into_iter().collect();
        Some(Self { known: pairs.into_par_iter().map(flow).collect::<Option<_>>()? })
    }

    /// The morph of a sample.
    pub(super) fn morph<'a>(
        &'a self,
        address: Address,
        sharpness: f64,
        grid: &Grid,
        is_tiling: bool,
        painted: &'a [PaintedSample<'a>],
    ) -> Morph<'a> {
        let near = nearest(address, sharpness, grid, painted);
        let source = |&(number, weight): &(u32, f32)| {
            let tile = painted.get(number as usize)?.tile;
            let others = near
                .iter()
                .filter_map(|(other, weight)| Some((self.known.get(&[number, *other])?, *weight)));
            Some(MorphSource { tile, weight, flows: others.collect() })
        };
        Morph { is_tiling, sources: near.iter().filter_map(source).collect() }
    }
}

/// A painted sample and its flows to the others, with their weights.
struct MorphSource<'a> {
    tile: &'a Tile,
    weight: f32,
    flows: Vec<(&'a Flow, f32)>,
}

/// Maker of a sample's texels.
pub(super) struct Morph<'a> {
    is_tiling: bool,
    sources: Vec<MorphSource<'a>>,
}

impl Morph<'_> {
    /// The color at a texel: straight RGBA from 0 to 255.
    pub(super) fn at(&self, x: usize, y: usize) -> Color {
        let mut sum = [0.0; 4];
        // Colors for transparent texels.
        let mut hidden = [0.0; 3];
        for source in &self.sources {
            let [r, g, b, a] = source.at(x, y, self.is_tiling);
            let straight = if a > 0.0 { [r / a, g / a, b / a] } else { [0.0; 3] };
            (0..3).for_each(|i| hidden[i] += source.weight * straight[i]);
            for (sum, channel) in sum.iter_mut().zip([r, g, b, a]) {
                *sum += channel * source.weight;
            }
        }
        let [r, g, b, a] = sum;
        if a > 0.0 { [r / a, g / a, b / a, a] } else { [hidden[0], hidden[1], hidden[2], 0.0] }
    }
}

impl MorphSource<'_> {
    /// The color that moves to a texel: straight times alpha, and alpha from 0 to 255.
    fn at(&self, x: usize, y: usize, is_tiling: bool) -> [f32; 4] {
        let size = Vec2::from(self.tile.size().map(|side| side as f32));
        let to = Vec2::new(x as f32 + 0.5, y as f32 + 0.5) / size;
        let moved = |place: Vec2| {
            self.flows.iter().map(|(flow, weight)| flow.at(place) * *weight).sum::<Vec2>()
        };
        let mut place = to;
        for _ in 0..ROUNDS {
            place = to - moved(place);
        }
        let place = place * size - 0.5;
        // A motion of whole texels gives the texels themselves.
        let near = place.round();
        let place = if (place - near).abs().max_element() < 1e-3 { near } else { place };
        let (low, part) = (place.floor(), place - place.floor());
        let texel = |right: i64, down: i64| {
            let [width, height] = self.tile.size().map(i64::from);
            let (x, y) = (low.x as i64 + right, low.y as i64 + down);
            let (x, y) =
                if is_tiling { (x, y) } else { (x.clamp(0, width - 1), y.clamp(0, height - 1)) };
            let [r, g, b, a] = self.tile.texel(x, y).map(f32::from);
            [r * a, g * a, b * a, a]
        };
        let [a, b, c, d] = [texel(0, 0), texel(1, 0), texel(0, 1), texel(1, 1)];
        std::array::from_fn(|i| {
            let (top, bottom) = (a[i] + (b[i] - a[i]) * part.x, c[i] + (d[i] - c[i]) * part.x);
            top + (bottom - top) * part.y
        })
    }
}

#[cfg(test)]
mod tests;
