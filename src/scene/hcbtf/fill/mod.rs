//! Fills that do not destroy: an ordered list of rules derives every sample that is not painted.
//!
//! A fill has three steps. The `plan` walks the rules for every sample and makes a recipe: the
//! painted sample, blend or color that it begins with, the angle by which it is turned, and the
//! change of its colors. All changes of color are affine in each channel, and turning commutes with
//! them, so a recipe has one turn and one map however many rules contributed, and a tile is
//! resampled once and rounded once (thesis figure 37 shows the loss of repeated turning). Equal
//! recipes are one recipe; `bake` makes a tile of each, on all cores; tiles that came out equal are
//! shared.
//!
//! Every tile depends on its recipe alone, so the result is the same on any number of threads.

mod again;
mod bake;
mod blend;
mod lock;
mod morph;
mod plan;
mod turn;

use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::sync::Arc;

use chiaro_locale::tr;
use rayon::iter::{IntoParallelRefIterator as _, ParallelIterator as _};
use thiserror::Error;

pub use self::again::refill;
use self::plan::FillPlan;
use crate::diag::Diagnostic;
use crate::document::{Address, Grid, Hcbtf, Rule, Tile, UnknownFields};
use crate::progress::Progress;

/// Greatest number of samples of a grid that is filled.
pub const MAX_SAMPLES: u64 = 1 << 20;
/// Greatest memory that a filled grid may take, in bytes.
pub const MAX_FILLED_BYTES: u64 = 4 << 30;

/// Origin of a sample.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Provenance {
    /// The sample was painted; no rule touches it.
    Painted,
    /// A rule filled the sample.
    Filled {
        /// Index of the rule, counted from 0.
        by: usize,
        /// Indices of the later rules that changed the sample, in order; rules that leave it
        /// unchanged are not among them.
        changed_by: Vec<usize>,
    },
    /// No rule fills the sample: it is transparent black.
    Empty,
}

/// Choice of the samples that are given to other programs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SampleChoice {
    /// Every sample, with what the rules fill.
    #[default]
    All,
    /// Painted samples only.
    Painted,
}

impl SampleChoice {
    /// True if the choice includes a sample of this provenance.
    pub fn has(self, provenance: &Provenance) -> bool {
        match self {
            Self::All => *provenance != Provenance::Empty,
            Self::Painted => *provenance == Provenance::Painted,
        }
    }
}

/// Estimate of the cost of filling.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FillEstimate {
    /// Number of samples of the grid.
    pub samples: u64,
    /// Number of different tiles among the samples, as far as known before they are made; painted
    /// ones are counted.
    pub tiles: u64,
    /// Greatest memory that the result takes, in bytes.
    pub bytes: u64,
}

/// Reason why nothing was filled.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum NotFilled {
    /// The grid is not valid.
    #[error("{why}")]
    BadGrid {
        /// Error of [`Grid::check`].
        why: String,
    },
    /// The work was stopped.
    #[error("{}", tr!("it was stopped before it was done"))]
    Stopped,
    /// The grid has more than [`MAX_SAMPLES`] samples.
    #[error("{}", tr!("the grid has {samples} samples; at most {MAX_SAMPLES} can be filled"))]
    TooMany {
        /// Number of samples of the grid.
        samples: u64,
    },
    /// The result would take more than [`MAX_FILLED_BYTES`].
    #[error(
        "{}",
        tr!(
            "the filled samples would take {mib} MiB; at most {most} MiB can be",
            mib = bytes >> 20,
            most = MAX_FILLED_BYTES >> 20
        )
    )]
    TooLarge {
        /// Memory that the result would take, in bytes.
        bytes: u64,
    },
}

impl From<NotFilled> for Diagnostic {
    fn from(why: NotFilled) -> Self {
        match why {
            NotFilled::Stopped => Self::error("stopped", why.to_string()),
            NotFilled::BadGrid { why } => Self::error("hcbtf-grid", why),
            _ => Self::error("too-large", why.to_string()).hint(tr!("take a coarser grid")),
        }
    }
}

/// A tile for every sample of a grid.
#[derive(Clone, Debug, PartialEq)]
pub struct FilledSamples {
    grid: Grid,
    is_tiling: bool,
    rules: Arc<[Rule]>,
    /// Fields of the HCBTF that this version does not know.
    unknown: Arc<UnknownFields>,
    tiles: Vec<Arc<Tile>>,
    provenances: Vec<Provenance>,
    /// Tile and provenance of each sample, by index, in the order of [`Grid::addresses`].
    samples: Vec<[u32; 2]>,
}

impl FilledSamples {
    /// Fields of the HCBTF that this version does not know.
    pub fn unknown(&self) -> &UnknownFields {
        &self.unknown
    }

    /// The grid that is filled.
    pub fn grid(&self) -> Grid {
        self.grid
    }

    /// True if the tile repeats.
    pub fn is_tiling(&self) -> bool {
        self.is_tiling
    }

    /// The rules that filled the samples.
    pub fn rules(&self) -> &[Rule] {
        &self.rules
    }

    /// The tile of a sample; `None` outside the grid. Samples that are equal have the same tile, by
    /// pointer.
    pub fn tile(&self, address: Address) -> Option<&Arc<Tile>> {
        self.tiles.get(self.tile_index(address)?)
    }

    /// The index of a sample's tile in [`Self::tiles`].
    pub fn tile_index(&self, address: Address) -> Option<usize> {
        Some(self.sample(address)?[0] as usize)
    }

    /// The provenance of a sample; `None` outside the grid.
    pub fn provenance(&self, address: Address) -> Option<&Provenance> {
        self.provenances.get(self.sample(address)?[1] as usize)
    }

    /// The tiles that differ.
    pub fn tiles(&self) -> &[Arc<Tile>] {
        &self.tiles
    }

    /// The memory that the samples take, in bytes: each tile once, painted ones too, which are
    /// shared with the HCBTF.
    pub fn bytes(&self) -> u64 {
        bytes(self.grid, self.tiles.len() as u64)
    }

    /// All samples with their tiles and provenances, in the order of [`Grid::addresses`].
    pub fn iter(&self) -> impl Iterator<Item = (Address, &Arc<Tile>, &Provenance)> {
        self.grid.addresses().zip(&self.samples).filter_map(|(address, [tile, provenance])| {
            Some((
                address,
                self.tiles.get(*tile as usize)?,
                self.provenances.get(*provenance as usize)?,
            ))
        })
    }

    fn sample(&self, address: Address) -> Option<[u32; 2]> {
        self.samples.get(usize::try_from(self.grid.index(address)?).ok()?).copied()
    }
}

/// The memory of a filled grid with this many different tiles.
fn bytes(grid: Grid, tiles: u64) -> u64 {
    let tile = 4 * grid.texels() as u64 + size_of::<Tile>() as u64 + size_of::<Arc<Tile>>() as u64;
    tiles
        .saturating_mul(tile)
        .saturating_add(grid.sample_count().saturating_mul(size_of::<[u32; 2]>() as u64))
}

/// The greatest memory that a filled grid takes, with no two samples alike, in bytes.
pub fn filled_at_most(grid: &Grid) -> u64 {
    bytes(*grid, grid.sample_count())
}

/// The cost of [`fill`], computed without filling.
///
/// # Errors
/// As [`fill`], except for being stopped.
pub fn estimate(hcbtf: &Hcbtf) -> Result<FillEstimate, NotFilled> {
    laid_out(hcbtf, &Progress::new()).map(|(_, estimate)| estimate)
}

fn laid_out<'a>(
    hcbtf: &'a Hcbtf,
    progress: &Progress,
) -> Result<(FillPlan<'a>, FillEstimate), NotFilled> {
    hcbtf.grid.check().map_err(|why| NotFilled::BadGrid { why })?;
    let samples = hcbtf.grid.sample_count();
    if samples > MAX_SAMPLES {
        return Err(NotFilled::TooMany { samples });
    }
    let plan = FillPlan::new(hcbtf, progress).ok_or(NotFilled::Stopped)?;
    let tiles = plan.recipes.len() as u64;
    let estimate = FillEstimate { samples, tiles, bytes: bytes(hcbtf.grid, tiles) };
    if estimate.bytes > MAX_FILLED_BYTES {
        return Err(NotFilled::TooLarge { bytes: estimate.bytes });
    }
    Ok((plan, estimate))
}

/// Runs the rules for every sample. Painted samples always win; samples outside the grid and
/// painted tiles of another size than the grid's are left out.
///
/// `progress` counts rows of texels, and the preparations of generators as the number of rows that
/// would take as long.
///
/// # Errors
/// Where the work is stopped, and where the grid is too large or not valid.
pub fn fill(hcbtf: &Hcbtf, progress: &Progress) -> Result<FilledSamples, NotFilled> {
    let (mut plan, _) = laid_out(hcbtf, progress)?;
    plan.prepare(hcbtf, progress).ok_or(NotFilled::Stopped)?;
    let baked = plan
        .recipes
        .par_iter()
        .map(|recipe| bake::tile(&plan, recipe, progress).ok_or(NotFilled::Stopped));
    let baked: Vec<Arc<Tile>> = baked.collect::<Result<_, _>>()?;
    let (tiles, place) = shared(baked);
    let mut samples = plan.samples;
    for [tile, _] in &mut samples {
        *tile = place[*tile as usize];
    }
    Ok(FilledSamples {
        grid: hcbtf.grid,
        is_tiling: hcbtf.is_tiling,
        rules: hcbtf.rules.as_slice().into(),
        unknown: hcbtf.unknown.clone().into(),
        tiles,
        provenances: plan.provenances,
        samples,
    })
}

/// Runs the rules for one sample alone: the same result as that of [`fill`], in the time of one
/// tile, to show the sample before all others are done; `None` outside the grid.
///
/// # Errors
/// As [`fill`].
pub fn sample(
    hcbtf: &Hcbtf,
    address: Address,
    progress: &Progress,
) -> Result<Option<Arc<Tile>>, NotFilled> {
    hcbtf.grid.check().map_err(|why| NotFilled::BadGrid { why })?;
    if !hcbtf.grid.contains(address) {
        return Ok(None);
    }
    let mut plan =
        FillPlan::of(hcbtf, vec![address.canonical()], progress).ok_or(NotFilled::Stopped)?;
    plan.prepare(hcbtf, progress).ok_or(NotFilled::Stopped)?;
    let tile = plan
        .recipes
        .first()
        .map(|recipe| bake::tile(&plan, recipe, progress).ok_or(NotFilled::Stopped));
    tile.transpose()
}

/// The tiles with equal ones joined into the first of them, and the index of each tile's
/// replacement.
pub(super) fn shared(all: Vec<Arc<Tile>>) -> (Vec<Arc<Tile>>, Vec<u32>) {
    let hash = |tile: &Arc<Tile>| {
        let mut hasher = DefaultHasher::new();
        tile.hash(&mut hasher);
        hasher.finish()
    };
    let hashes: Vec<u64> = all.par_iter().map(hash).collect();
    let mut known: HashMap<u64, Vec<u32>> = HashMap::new();
    let mut tiles: Vec<Arc<Tile>> = Vec::new();
    let mut place = Vec::with_capacity(all.len());
    for (tile, hash) in all.into_iter().zip(hashes) {
        let alike = known.entry(hash).or_default();
        let same = alike.iter().copied().find(|at| tiles[*at as usize] == tile);
        place.push(same.unwrap_or_else(|| {
            let at = tiles.len() as u32;
            alike.push(at);
            tiles.push(tile);
            at
        }));
    }
    (tiles, place)
}

#[cfg(test)]
mod tests;
