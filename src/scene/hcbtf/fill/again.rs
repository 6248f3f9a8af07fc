//! Refilling of an HCBTF that was filled before, after a stroke has changed a few texels: the work
//! is proportional to the changed texels.
//!
//! With the same grid, the same rules and the same samples painted, every sample has the same
//! recipe as before. Then a tile that is made texel by texel of paintings differs only where one of
//! these paintings does, and only if the painting contributes to the tile; a tile that comes out
//! unchanged stays the same tile, by pointer. So code that shows tiles finds the changes by
//! comparing pointers.

use std::collections::{BTreeSet, HashMap};
use std::sync::Arc;

use rayon::iter::{IntoParallelIterator as _, ParallelIterator as _};

use super::bake::{self, Mapping};
use super::plan::{FillPlan, Recipe, TileSource};
use super::{FilledSamples, NotFilled, blend, fill};
use crate::document::{Hcbtf, Rule, Tile};
use crate::progress::Progress;

/// Greatest number of changed paintings with which tiles are refilled; with more, everything is
/// filled anew.
const MOST_CHANGED: usize = 4;

/// A part of a tile: x, y, width and height in texels.
type TileRegion = [u32; 4];

/// Runs the rules for every sample, as [`fill`] does, with the help of the result `before` of an
/// earlier state of the HCBTF: equal tiles are not made again. Tiles that have become equal may
/// stay two.
///
/// `progress` counts rows of texels that are made, even rows of a few texels.
///
/// # Errors
/// As [`fill`].
pub fn refill(
    hcbtf: &Hcbtf,
    before: (&Hcbtf, &FilledSamples),
    progress: &Progress,
) -> Result<FilledSamples, NotFilled> {
    let (old, filled) = before;
    let changed =
        changed(hcbtf, old).filter(|_| filled.grid == hcbtf.grid && old.grid == hcbtf.grid);
    let Some(changed) = changed else { return fill(hcbtf, progress) };
    let plan = FillPlan::new(hcbtf, progress).ok_or(NotFilled::Stopped)?;
    // Samples of one recipe had one tile before, so any of them gives the recipe's old tile.
    let mut old_tiles = vec![0; plan.recipes.len()];
    for ([recipe, _], [tile, _]) in plan.samples.iter().zip(&filled.samples) {
        old_tiles[*recipe as usize] = *tile;
    }
    let again = Refill { plan: &plan, filled, changed: &changed, progress };
    let wanted: Vec<(usize, TileRegion)> = (0..plan.recipes.len())
        .into_par_iter()
        .filter_map(|recipe| Some((recipe, again.part(&plan.recipes[recipe])?)))
        .collect();
    progress.begin(wanted.iter().map(|(_, [.., rows])| u64::from(*rows)).sum());
    let made = wanted.into_par_iter().map(|(recipe, part)| {
        let tile = again.tile(&plan.recipes[recipe], old_tiles[recipe], part);
        tile.map(|tile| (recipe, tile)).ok_or(NotFilled::Stopped)
    });
    let made: HashMap<usize, RefilledTile> = made.collect::<Result<_, _>>()?;
    Ok(together(&plan, filled, &old_tiles, made))
}

/// Result of refilling a recipe.
enum RefilledTile {
    /// The tile from before.
    AsBefore,
    /// A new tile.
    Other(Arc<Tile>),
    /// The tile from before, with these texels in a part of it.
    Patched(TileRegion, Vec<u8>),
}

/// The paintings that changed, by number, each with its changed part; `None` if anything else has
/// changed, or too many of them.
fn changed(now: &Hcbtf, old: &Hcbtf) -> Option<HashMap<u32, TileRegion>> {
    let is_alike = now.grid == old.grid && now.is_tiling == old.is_tiling && now.rules == old.rules;
    if !is_alike || !now.painted.keys().eq(old.painted.keys()) {
        return None;
    }
    let mut changed = HashMap::new();
    let mut named = BTreeSet::new();
    let fits = |tile: &Tile, address| now.grid.contains(address) && tile.size() == now.grid.size;
    // Numbers are those of the plan: of the samples that fit the grid.
    let mut number = 0;
    for ((address, tile), before) in now.painted.iter().zip(old.painted.values()) {
        if fits(tile, *address) != fits(before, *address) {
            return None;
        }
        if !fits(tile, *address) {
            continue;
        }
        if !Arc::ptr_eq(tile, before)
            && let Some(part) = tile.difference(before)
        {
            // Opaque paint is blended in another way, which may round differently.
            if is_opaque(tile) != is_opaque(before) || changed.len() == MOST_CHANGED {
                return None;
            }
            changed.insert(number, part);
            named.insert(address.canonical());
        }
        number += 1;
    }
    // Morphs and reliefs may spread a change of a few texels anywhere.
    let is_local = |rule: &Rule| match rule {
        Rule::Morph { .. } => false,
        Rule::Relief(relief) => !relief.painted().any(|from| named.contains(&from.canonical())),
        _ => true,
    };
    (changed.is_empty() || now.rules.iter().all(is_local)).then_some(changed)
}

fn is_opaque(tile: &Tile) -> bool {
    tile.bytes().iter().skip(3).step_by(4).all(|alpha| *alpha == 255)
}

/// Inputs of refilling tiles.
struct Refill<'a> {
    plan: &'a FillPlan<'a>,
    filled: &'a FilledSamples,
    changed: &'a HashMap<u32, TileRegion>,
    progress: &'a Progress,
}

impl Refill<'_> {
    /// The part of a recipe's tile that may have changed.
    fn part(&self, recipe: &Recipe) -> Option<TileRegion> {
        let part = match recipe.source {
            TileSource::Painted(number) => self.changed.get(&number).copied(),
            TileSource::Blend { .. } => {
                let weights = self.weights(recipe);
                weights
                    .iter()
                    .filter_map(|(number, _)| self.changed.get(number).copied())
                    .reduce(around)
            }
            TileSource::Empty
            | TileSource::Uniform(_)
            | TileSource::Morph { .. }
            | TileSource::Generated { .. } => None,
        };
        let whole = |_| [0, 0, self.plan.grid.size[0], self.plan.grid.size[1]];
        if is_whole(recipe) { part.map(whole) } else { part }
    }

    fn weights(&self, recipe: &Recipe) -> Vec<(u32, f32)> {
        match recipe.source {
            TileSource::Blend { address, sharpness } => {
                blend::weights(address, sharpness.get(), &self.plan.grid, &self.plan.painted)
            }
            _ => Vec::new(),
        }
    }

    /// The tile of a recipe; `None` if the work is stopped.
    fn tile(&self, recipe: &Recipe, old: u32, part: TileRegion) -> Option<RefilledTile> {
        if self.progress.is_stopped() {
            return None;
        }
        let old = self.filled.tiles.get(old as usize)?;
        if is_whole(recipe) {
            return bake::tile(self.plan, recipe, self.progress).map(RefilledTile::Other);
        }
        let [left, top, wide, high] = part.map(|side| side as usize);
        let width = self.plan.grid.size[0] as usize;
        let weights = self.weights(recipe);
        let mapping = Mapping::new(recipe);
        let mut colors = vec![[0.0; 4]; wide];
        let mut texels = Vec::with_capacity(4 * wide * high);
        let mut is_other = false;
        for y in top..top + high {
            let from = y * width + left;
            let begin = texels.len();
            match recipe.source {
                TileSource::Painted(number) => {
                    let painted = self
                        .plan
                        .painted
                        .get(number as usize)?
                        .tile
                        .bytes()
                        .get(4 * from..4 * (from + wide))?;
                    texels.extend_from_slice(painted);
                    bake::recolor(recipe, &mut texels[begin..]);
                }
                _ => {
                    blend::row(&weights, &self.plan.painted, from, &mut colors);
                    texels.extend(colors.iter().flat_map(|color| mapping.of(*color)));
                }
            }
            is_other |= old.bytes().get(4 * from..4 * (from + wide))? != &texels[begin..];
            self.progress.add(1);
        }
        Some(if is_other { RefilledTile::Patched(part, texels) } else { RefilledTile::AsBefore })
    }
}

/// True if a tile is made as a whole: turned content is resampled from places all over the tile,
/// and a painted tile is there already.
fn is_whole(recipe: &Recipe) -> bool {
    recipe.turn.get() != 0.0
        || matches!(recipe.source, TileSource::Painted(_)) && !recipe.is_recolored()
}

/// The smallest part that contains both.
fn around(one: TileRegion, other: TileRegion) -> TileRegion {
    let [x, y] = [0, 1].map(|axis| one[axis].min(other[axis]));
    let [right, bottom] =
        [0, 1].map(|axis| (one[axis] + one[axis + 2]).max(other[axis] + other[axis + 2]));
    [x, y, right - x, bottom - y]
}

/// All tiles; equal patches of the same tile are made once.
fn together(
    plan: &FillPlan<'_>,
    filled: &FilledSamples,
    old_tiles: &[u32],
    mut made: HashMap<usize, RefilledTile>,
) -> FilledSamples {
    let mut patched: HashMap<(u32, TileRegion, Vec<u8>), Arc<Tile>> = HashMap::new();
    let mut known: HashMap<*const Tile, u32> = HashMap::new();
    let mut tiles: Vec<Arc<Tile>> = Vec::new();
    let mut place = Vec::with_capacity(plan.recipes.len());
    for (recipe, old) in old_tiles.iter().enumerate() {
        let before = &filled.tiles[*old as usize];
        let tile = match made.remove(&recipe) {
            None | Some(RefilledTile::AsBefore) => before.clone(),
            Some(RefilledTile::Other(tile)) => tile,
            Some(RefilledTile::Patched(part, texels)) => {
                let patch = |(_, part, texels): &(u32, TileRegion, Vec<u8>)| {
                    Arc::new(with(before, *part, texels))
                };
                let key = (*old, part, texels);
                let tile = patched.get(&key).cloned().unwrap_or_else(|| patch(&key));
                patched.entry(key).or_insert(tile).clone()
            }
        };
        let next = tiles.len() as u32;
        let index = *known.entry(Arc::as_ptr(&tile)).or_insert(next);
        if index == next {
            tiles.push(tile);
        }
        place.push(index);
    }
    let sample = |[recipe, provenance]: &[u32; 2]| [place[*recipe as usize], *provenance];
    let samples = plan.samples.iter().map(sample).collect();
    // The rules equal those from before, or the tiles from before could not be used.
    FilledSamples {
        grid: filled.grid,
        is_tiling: filled.is_tiling,
        rules: filled.rules.clone(),
        unknown: filled.unknown.clone(),
        tiles,
        provenances: plan.provenances.clone(),
        samples,
    }
}

/// A tile with other texels in a part of it.
fn with(tile: &Tile, [left, top, wide, _]: TileRegion, texels: &[u8]) -> Tile {
    let mut tile = tile.clone();
    let stride = 4 * tile.size()[0] as usize;
    let (left, wide) = (4 * left as usize, 4 * wide as usize);
    for (row, new) in
        tile.bytes_mut().chunks_exact_mut(stride).skip(top as usize).zip(texels.chunks_exact(wide))
    {
        row[left..left + wide].copy_from_slice(new);
    }
    tile
}
