//! Synthesis of new tiles from a painted one (the thesis's future work, 12): patches of the tile
//! are laid side by side, each where it fits the patches already laid, and cut along the best seam
//! (Efros and Freeman, Image Quilting, 2001).
//!
//! One map of source texels is found for all samples together: the error of a fit is the sum over
//! samples. So a texel of the new tile is the same texel of the old tile in every sample, and keeps
//! its behavior under light and eye. Patches are also laid across the new tile's edges, so the tile
//! repeats. Patches that merely continue their neighbor's source are passed over while there are
//! others, or the result would be the old tile again.

use std::collections::BTreeMap;
use std::sync::Arc;

use chiaro_locale::tr;
use rayon::iter::{IntoParallelIterator as _, IntoParallelRefIterator as _, ParallelIterator as _};

use super::check_painted;
use super::fill::{FilledSamples, fill};
use super::noise::hash;
use crate::diag::Diagnostic;
use crate::document::{Grid, Hcbtf, Rule, Tile};
use crate::progress::Progress;

/// Options of a synthesis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Synthesis {
    /// Size of the new tile, in texels.
    pub size: [u32; 2],
    /// Seed of the choice of patches.
    pub seed: u32,
    /// Side of a patch, in texels; `None` for half of the old tile's shorter side. Large patches
    /// keep large forms whole.
    pub patch: Option<u32>,
}

/// Greatest number of samples by which the fit of patches is judged.
const JUDGES: usize = 16;
/// Greatest number of places of the source that are tried for a patch.
const MOST_TRIED: usize = 4096;
/// Share by which a patch may be worse than the best.
const TOLERANCE: f64 = 0.2;
/// Share of a patch that overlaps its neighbor.
const OVERLAP: f64 = 0.34;
/// Least side of a patch, in texels.
const LEAST_PATCH: u32 = 3;

/// Makes a tile of another size, or another tile of the same size, of all samples of an HCBTF.
/// `progress` counts patches.
///
/// Rules that work on each texel by itself stay; others are baked, and every sample is then
/// painted.
///
/// # Errors
/// Where the work is stopped, where the sizes are not possible, and where the result would be
/// larger than a file may be.
pub fn synthesize(
    hcbtf: &Hcbtf,
    how: &Synthesis,
    progress: &Progress,
) -> Result<Hcbtf, Diagnostic> {
    let filled = fill(hcbtf, progress)?;
    synthesize_filled(hcbtf, &filled, how, progress)
}

/// HCBTF as of [`synthesize`], with the result of the rules in `filled`.
///
/// # Errors
/// As [`synthesize`].
pub fn synthesize_filled(
    hcbtf: &Hcbtf,
    filled: &FilledSamples,
    how: &Synthesis,
    progress: &Progress,
) -> Result<Hcbtf, Diagnostic> {
    let grid = Grid { size: how.size, ..hcbtf.grid };
    grid.check().map_err(|why| Diagnostic::error("hcbtf-grid", why))?;
    let smallest = hcbtf.grid.size.into_iter().chain(how.size).min().unwrap_or_default();
    let patch =
        how.patch.unwrap_or((hcbtf.grid.size[0].min(hcbtf.grid.size[1])) / 2).max(LEAST_PATCH);
    if smallest <= LEAST_PATCH
        || how.patch.is_some_and(|patch| !(LEAST_PATCH..smallest).contains(&patch))
    {
        let message =
            tr!("patches of {patch} texels do not fit tiles whose shorter side is {smallest}");
        let hint = tr!(
            "patches have at least {LEAST_PATCH} texels along a side, and fewer than both tiles"
        );
        return Err(Diagnostic::error("bad-argument", message).hint(hint));
    }
    let keeps_rules = hcbtf.rules.iter().all(is_by_texel);
    check_painted(
        &grid,
        if keeps_rules { hcbtf.painted.len() as u64 } else { grid.sample_count() },
    )?;
    let quilt = Quilt::new(filled, hcbtf.is_tiling, how, patch.min(smallest - 1));
    let stopped = || Diagnostic::from(super::NotFilled::Stopped);
    let map = quilt.laid(progress).ok_or_else(stopped)?;
    let mapped = |tile: &Tile| {
        let texel = |from: &u32| tile.bytes()[4 * *from as usize..4 * *from as usize + 4].to_vec();
        Tile::new(how.size, map.iter().flat_map(texel).collect()).map(Arc::new)
    };
    let painted: BTreeMap<_, _> = match keeps_rules {
        true => hcbtf
            .painted
            .iter()
            .filter_map(|(address, tile)| Some((*address, mapped(tile)?)))
            .collect(),
        false => {
            // Samples that share a tile share the new one.
            let tiles: Vec<_> = filled.tiles().par_iter().map(|tile| mapped(tile)).collect();
            let of = |address| tiles.get(filled.tile_index(address)?)?.clone();
            grid.addresses().filter_map(|address| Some((address, of(address)?))).collect()
        }
    };
    let rules = if keeps_rules { hcbtf.rules.clone() } else { Vec::new() };
    Ok(Hcbtf { painted, rules, ..Hcbtf::new(grid) })
}

/// True if a rule makes each texel only of texels at the same place.
fn is_by_texel(rule: &Rule) -> bool {
    !matches!(rule, Rule::Rotate { .. } | Rule::Strokes(_) | Rule::Relief(_))
}

/// A quilt: the map from the new tile's texels to source texels, while it is made.
struct Quilt {
    source: [usize; 2],
    is_tiling: bool,
    size: [usize; 2],
    patch: usize,
    seed: u32,
    /// Colors of each source texel in the judging samples.
    looks: Vec<u8>,
    /// Size of a texel in `looks`, in bytes.
    stride: usize,
    /// Starts of the patches, along x and y.
    begins: [Vec<usize>; 2],
}

/// Value in the map of texels of the new tile that are not laid yet.
const EMPTY: u32 = u32::MAX;

impl Quilt {
    fn new(filled: &FilledSamples, is_tiling: bool, how: &Synthesis, patch: u32) -> Self {
        let [source, size] =
            [filled.grid().size, how.size].map(|size| size.map(|side| side as usize));
        let all = filled.tiles();
        let judges: Vec<&Arc<Tile>> =
            all.iter().step_by(all.len().div_ceil(JUDGES).max(1)).collect();
        let texels = 0..source[0] * source[1];
        let looks = texels.flat_map(|at| {
            judges.iter().flat_map(move |tile| tile.bytes()[4 * at..4 * at + 4].to_vec())
        });
        let looks = looks.collect();
        let step = ((f64::from(patch) * (1.0 - OVERLAP)) as usize).max(1);
        let begins = size.map(|side| {
            let count = side.div_ceil(step);
            (0..count).map(|index| index * side / count).collect()
        });
        Self {
            source,
            is_tiling,
            size,
            patch: patch as usize,
            seed: how.seed,
            looks,
            stride: 4 * judges.len(),
            begins,
        }
    }

    /// The source texel of each texel of the new tile; `None` if the work is stopped.
    fn laid(&self, progress: &Progress) -> Option<Vec<u32>> {
        let [columns, rows] = &self.begins;
        progress.begin((columns.len() * rows.len()) as u64);
        let mut map = vec![EMPTY; self.size[0] * self.size[1]];
        for (row, y) in rows.iter().enumerate() {
            for (column, x) in columns.iter().enumerate() {
                if progress.is_stopped() {
                    return None;
                }
                let from = self.choose(&map, [*x, *y], (row * columns.len() + column) as u64);
                self.lay(&mut map, [*x, *y], from);
                progress.add(1);
            }
        }
        Some(map)
    }

    /// The index of the new tile's texel at a place of a patch that begins at `at`.
    fn texel(&self, at: [usize; 2], [x, y]: [usize; 2]) -> usize {
        (at[1] + y) % self.size[1] * self.size[0] + (at[0] + x) % self.size[0]
    }

    /// The index of the source texel at a place of a patch that is taken from `from`.
    fn taken(&self, from: [usize; 2], [x, y]: [usize; 2]) -> u32 {
        ((from[1] + y) % self.source[1] * self.source[0] + (from[0] + x) % self.source[0]) as u32
    }

    /// The squared difference of two source texels, summed over all judging samples.
    fn difference(&self, one: u32, other: u32) -> u64 {
        let of = |texel: u32| &self.looks[texel as usize * self.stride..][..self.stride];
        of(one).iter().zip(of(other)).map(|(a, b)| u64::from(a.abs_diff(*b)).pow(2)).sum()
    }

    fn random(&self, patch: u64, salt: u64) -> u64 {
        hash(self.seed, patch as i64, salt as i64)
    }

    /// The place of the source that a patch is taken from.
    fn choose(&self, map: &[u32], at: [usize; 2], number: u64) -> [usize; 2] {
        // A source that does not repeat has no patches across its edges.
        let room =
            self.source.map(|side| if self.is_tiling { side } else { side - self.patch + 1 });
        let places = room[0] * room[1];
        let tried: Vec<usize> = match places <= MOST_TRIED {
            true => (0..places).collect(),
            false => (0..MOST_TRIED as u64)
                .map(|salt| (self.random(number, salt + 1) as usize) % places)
                .collect(),
        };
        let place = |index: usize| [index % room[0], index / room[0]];
        let inside = (0..self.patch).flat_map(|y| (0..self.patch).map(move |x| [x, y]));
        let laid = inside
            .map(|within| (within, map[self.texel(at, within)]))
            .filter(|(_, texel)| *texel != EMPTY);
        let laid: Vec<([usize; 2], u32)> = laid.collect();
        let judged = tried.into_par_iter().map(|index| {
            let from = place(index);
            let mut error = 0;
            let mut goes_on = 0;
            for (within, texel) in &laid {
                let own = self.taken(from, *within);
                goes_on += usize::from(own == *texel);
                error += self.difference(own, *texel);
            }
            // If half of the texels already laid are the very same texels, the patch continues its
            // neighbor's source and brings nothing new.
            (error, 2 * goes_on > laid.len(), from)
        });
        let judged: Vec<(u64, bool, [usize; 2])> = judged.collect();
        let is_new = judged.iter().any(|(_, goes_on, _)| !goes_on);
        let eligible = || judged.iter().filter(|(_, goes_on, _)| !(is_new && *goes_on));
        let least = eligible().map(|(error, ..)| *error).min().unwrap_or_default();
        let bound = (least as f64 * (1.0 + TOLERANCE)) as u64;
        let good: Vec<[usize; 2]> =
            eligible().filter(|(error, ..)| *error <= bound).map(|(.., from)| *from).collect();
        let chosen = self.random(number, 0) as usize % good.len().max(1);
        good.get(chosen).copied().unwrap_or_default()
    }

    /// Lays a patch, cut along the line where it differs least from the texels already laid.
    fn lay(&self, map: &mut [u32], at: [usize; 2], from: [usize; 2]) {
        let patch = self.patch;
        let cost = |within: [usize; 2]| match map[self.texel(at, within)] {
            EMPTY => 0,
            texel => self.difference(self.taken(from, within), texel),
        };
        // `across` has for each row the first column that is new and the end of the new ones;
        // `down` has the rows of each column.
        let across = self.cuts(0, at, |along, over| cost([over, along]));
        let down = self.cuts(1, at, |along, over| cost([along, over]));
        for [x, y] in (0..patch).flat_map(|y| (0..patch).map(move |x| [x, y])) {
            let is_within = |cuts: &[[usize; 2]], along: usize, over: usize| {
                let [first, last] = cuts[along];
                (first..last).contains(&over)
            };
            let texel = self.texel(at, [x, y]);
            if map[texel] == EMPTY || (is_within(&across, y, x) && is_within(&down, x, y)) {
                map[texel] = self.taken(from, [x, y]);
            }
        }
    }

    /// The range of every line along a patch in which the patch is new: cut in the overlap with the
    /// patch before it, and with the first patch where it reaches around the tile.
    fn cuts(
        &self,
        axis: usize,
        at: [usize; 2],
        cost: impl Fn(usize, usize) -> u64,
    ) -> Vec<[usize; 2]> {
        let patch = self.patch;
        let begins = &self.begins[axis];
        let index = begins.iter().position(|begin| *begin == at[axis]).unwrap_or_default();
        let before = match index {
            0 => 0,
            _ => (begins[index - 1] + patch).saturating_sub(at[axis]).min(patch),
        };
        let after =
            (at[axis] + patch).saturating_sub(self.size[axis]).min(patch - before.min(patch));
        let mut cuts = vec![[0, patch]; patch];
        if before > 0 {
            for (cut, over) in cuts.iter_mut().zip(cheapest(patch, before, &cost)) {
                cut[0] = over;
            }
        }
        if after > 0 {
            let begin = patch - after;
            for (cut, over) in
                cuts.iter_mut().zip(cheapest(patch, after, |along, over| cost(along, begin + over)))
            {
                cut[1] = begin + over;
            }
        }
        cuts
    }
}

/// The cheapest line down a strip: for each step along it a place across, next to the one before.
fn cheapest(long: usize, wide: usize, cost: impl Fn(usize, usize) -> u64) -> Vec<usize> {
    let mut sums = vec![vec![0_u64; wide]; long];
    for along in 0..long {
        for over in 0..wide {
            let least = match along {
                0 => 0,
                _ => (over.saturating_sub(1)..(over + 2).min(wide))
                    .map(|near| sums[along - 1][near])
                    .min()
                    .unwrap_or(0),
            };
            sums[along][over] = cost(along, over).saturating_add(least);
        }
    }
    let mut line = vec![0; long];
    let mut near = 0..wide;
    for along in (0..long).rev() {
        line[along] = near.min_by_key(|over| sums[along][*over]).unwrap_or_default();
        near = line[along].saturating_sub(1)..(line[along] + 2).min(wide);
    }
    line
}

#[cfg(test)]
mod tests;
