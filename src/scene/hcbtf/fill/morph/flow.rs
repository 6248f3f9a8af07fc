//! Flow from one painted tile to another, the motion of each texel: block matching from coarse to
//! fine.
//!
//! At each level the patch around a texel is searched for in the other tile near the match of the
//! coarser level. The match of a patch without marks means nothing, so matches are spread by the
//! amount of marks in their patches, and where there are none around, the coarser level stands. In
//! the end a motion that does not bring the tiles nearer to each other is undone.

use glam::Vec2;

use crate::document::Tile;
use crate::progress::Progress;

/// Greatest side of the finest level on which motions are searched for, in texels; larger tiles are
/// made smaller.
const MAX_SIDE: usize = 64;
/// Greatest side of the coarsest level, in texels.
const COARSE: usize = 8;
/// Reach of a patch to each side of its middle, in texels.
const PATCH: i64 = 2;
/// Reach of the search around the match of the coarser level, in texels.
const SEARCH: i64 = 2;
/// Reach over which matches are spread, in texels of each level.
const SPREAD: i64 = 3;
/// Cost of a motion's length, so that among equal matches the shortest is taken.
const SHORTEST: f32 = 1e-5;
/// Squared difference below which texels are alike.
const ALIKE: f32 = 1e-3;

/// A tile at one resolution, in premultiplied colors from 0 to 1.
struct Level {
    size: [i64; 2],
    is_tiling: bool,
    texels: Vec<[f32; 4]>,
}

/// Motion of each place of a tile, in widths and heights of the tile.
pub(in super::super) struct Flow {
    size: [i64; 2],
    is_tiling: bool,
    moves: Vec<Vec2>,
}

/// The index of a place on a level, wrapped around the tile, or clamped to it.
fn wrapped(x: i64, y: i64, size: [i64; 2], is_tiling: bool) -> usize {
    let [width, height] = size;
    let (x, y) = match is_tiling {
        true => (x.rem_euclid(width), y.rem_euclid(height)),
        false => (x.clamp(0, width - 1), y.clamp(0, height - 1)),
    };
    (y * width + x) as usize
}

impl Level {
    fn new(tile: &Tile, is_tiling: bool) -> Self {
        let texel = |texel: &[u8]| {
            let [r, g, b, a] = [0, 1, 2, 3].map(|i| f32::from(texel[i]) / 255.0);
            [r * a, g * a, b * a, a]
        };
        let texels = tile.bytes().chunks_exact(4).map(texel).collect();
        Self { size: tile.size().map(i64::from), is_tiling, texels }
    }

    /// The level at half its size.
    fn halved(&self) -> Self {
        let size = self.size.map(|side| (side + 1) / 2);
        let mean = |x: i64, y: i64| {
            let four = [(0, 0), (1, 0), (0, 1), (1, 1)]
                .map(|(right, down)| self.at(2 * x + right, 2 * y + down));
            std::array::from_fn(|i| four.iter().map(|texel| texel[i]).sum::<f32>() / 4.0)
        };
        let texels = (0..size[1])
            .flat_map(|y| (0..size[0]).map(move |x| (x, y)))
            .map(|(x, y)| mean(x, y))
            .collect();
        Self { size, is_tiling: self.is_tiling, texels }
    }

    fn at(&self, x: i64, y: i64) -> [f32; 4] {
        self.texels[wrapped(x, y, self.size, self.is_tiling)]
    }
}

fn squared(a: [f32; 4], b: [f32; 4]) -> f32 {
    (0..4).map(|i| (a[i] - b[i]).powi(2)).sum()
}

/// The offsets of a patch.
fn patch(reach: i64) -> impl Iterator<Item = (i64, i64)> {
    (-reach..=reach).flat_map(move |y| (-reach..=reach).map(move |x| (x, y)))
}

impl Flow {
    /// The flow from a tile to another of the same size; `None` if the work is stopped.
    pub(in super::super) fn new(
        from: &Tile,
        to: &Tile,
        is_tiling: bool,
        progress: &Progress,
    ) -> Option<Self> {
        let mut levels = vec![[Level::new(from, is_tiling), Level::new(to, is_tiling)]];
        while let Some(last) = levels.last() {
            let longer = last[0].size[0].max(last[0].size[1]) as usize;
            if longer <= COARSE {
                break;
            }
            let half = [last[0].halved(), last[1].halved()];
            if longer > MAX_SIDE {
                levels.clear();
            }
            levels.push(half);
        }
        let mut flow: Option<Self> = None;
        for [from, to] in levels.iter().rev() {
            if progress.is_stopped() {
                return None;
            }
            let before = flow.map_or_else(|| Self::still(from), |coarse: Self| coarse.scaled(from));
            let reach = if before.moves.iter().all(|by| *by == Vec2::ZERO) {
                from.size[0].max(from.size[1]) / 2
            } else {
                SEARCH
            };
            flow = Some(before.refined(from, to, reach.min(COARSE as i64 / 2 + 1)));
        }
        let (flow, [from, to]) = (flow?, levels.first()?);
        Some(flow.kept_where_it_helps(from, to).into_shares())
    }

    fn still(level: &Level) -> Self {
        Self {
            size: level.size,
            is_tiling: level.is_tiling,
            moves: vec![Vec2::ZERO; level.texels.len()],
        }
    }

    /// The flow for a level of another size; moves are in texels of the level here.
    fn scaled(&self, level: &Level) -> Self {
        let by = [0, 1].map(|i| level.size[i] as f32 / self.size[i] as f32);
        let mut scaled = Self::still(level);
        for (index, to) in scaled.moves.iter_mut().enumerate() {
            let (x, y) = (index as i64 % level.size[0], index as i64 / level.size[0]);
            let place = Vec2::new((x as f32 + 0.5) / by[0] - 0.5, (y as f32 + 0.5) / by[1] - 0.5);
            *to = self.between(place) * Vec2::from(by);
        }
        scaled
    }

    /// The motion at a position between places, in places.
    fn between(&self, place: Vec2) -> Vec2 {
        let (low, part) = (place.floor(), place - place.floor());
        let (x, y) = (low.x as i64, low.y as i64);
        let at = |right: i64, down: i64| {
            self.moves[wrapped(x + right, y + down, self.size, self.is_tiling)]
        };
        at(0, 0).lerp(at(1, 0), part.x).lerp(at(0, 1).lerp(at(1, 1), part.x), part.y)
    }

    /// The flow with each patch searched for anew, and the matches spread.
    fn refined(&self, from: &Level, to: &Level, reach: i64) -> Self {
        let mut found = Vec::with_capacity(self.moves.len());
        for (index, before) in self.moves.iter().enumerate() {
            let (x, y) = (index as i64 % self.size[0], index as i64 / self.size[0]);
            let start = before.round();
            let mut best = (f32::INFINITY, Vec2::ZERO);
            for (right, down) in patch(reach) {
                let by = start + Vec2::new(right as f32, down as f32);
                let cost = patch(PATCH).map(|(i, j)| {
                    squared(from.at(x + i, y + j), to.at(x + i + by.x as i64, y + j + by.y as i64))
                });
                let cost = cost.sum::<f32>() + SHORTEST * by.length_squared();
                if cost < best.0 {
                    best = (cost, by);
                }
            }
            let marks = marks(from, x, y);
            found.push((best.1, marks * (-best.0 / (marks + ALIKE)).exp()));
        }
        let most = found.iter().map(|(_, weight)| *weight).fold(0.0, f32::max).max(ALIKE);
        let spread = |index: usize| {
            let (x, y) = (index as i64 % self.size[0], index as i64 / self.size[0]);
            // The match of the coarser level has a little weight everywhere.
            let (mut sum, mut weights) = (0.02 * most * self.moves[index], 0.02 * most);
            for (i, j) in patch(SPREAD) {
                let (by, weight) = found[wrapped(x + i, y + j, self.size, self.is_tiling)];
                let weight = weight / (1.0 + (i * i + j * j) as f32);
                (sum, weights) = (sum + weight * by, weights + weight);
            }
            sum / weights
        };
        Self { moves: (0..found.len()).map(spread).collect(), ..*self }
    }

    /// The flow without motions that do not bring the tiles nearer to each other.
    fn kept_where_it_helps(mut self, from: &Level, to: &Level) -> Self {
        let texel = |index: usize| (index as i64 % self.size[0], index as i64 / self.size[0]);
        let off = |index: usize, by: Vec2| {
            let (x, y) = texel(index);
            squared(from.at(x, y), to.at(x + by.x.round() as i64, y + by.y.round() as i64))
        };
        let differences: Vec<[f32; 2]> = self
            .moves
            .iter()
            .enumerate()
            .map(|(index, by)| [off(index, *by), off(index, Vec2::ZERO)])
            .collect();
        let share = |index: usize| {
            let (x, y) = texel(index);
            let around = patch(2 * SPREAD)
                .map(|(i, j)| differences[wrapped(x + i, y + j, self.size, self.is_tiling)]);
            let [moved, still] =
                around.fold([ALIKE; 2], |sum, by| [sum[0] + by[0], sum[1] + by[1]]);
            (1.5 - moved / still).clamp(0.0, 1.0)
        };
        let shares: Vec<f32> = (0..self.moves.len()).map(share).collect();
        self.moves.iter_mut().zip(shares).for_each(|(by, share)| *by *= share);
        self
    }

    /// The flow with moves as shares of the tile instead of texels.
    fn into_shares(mut self) -> Self {
        let size = Vec2::new(self.size[0] as f32, self.size[1] as f32);
        self.moves.iter_mut().for_each(|by| *by /= size);
        self
    }

    /// The motion at a position, both in widths and heights of the tile from its upper left corner.
    pub(in super::super) fn at(&self, place: Vec2) -> Vec2 {
        let size = Vec2::new(self.size[0] as f32, self.size[1] as f32);
        self.between(place * size - 0.5)
    }
}

/// The amount of marks in a patch: the squared differences of its texels from their mean.
fn marks(level: &Level, x: i64, y: i64) -> f32 {
    let texels = || patch(PATCH).map(|(i, j)| level.at(x + i, y + j));
    let count = ((2 * PATCH + 1) * (2 * PATCH + 1)) as f32;
    let mean =
        texels().fold([0.0; 4], |sum, texel| std::array::from_fn(|i| sum[i] + texel[i] / count));
    texels().map(|texel| squared(texel, mean)).sum()
}
