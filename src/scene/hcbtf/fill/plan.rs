//! Planning: makes recipes of rules, each with the start of a sample and the changes of its colors.

use std::collections::HashMap;
use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use glam::DVec3;
use indexmap::{IndexMap, IndexSet};
use rayon::iter::{IntoParallelIterator as _, ParallelIterator as _};

use super::Provenance;
use super::lock::{Lock, angle};
use super::morph::Flows;
use crate::document::{
    Address, Direction, Directions, Grid, Hcbtf, HcbtfAngle as Angle, Rule, Tile,
};
use crate::hcbtf::generate::Generator;
use crate::progress::Progress;

/// Greatest angle between directions that count as the same, in radians: angles of one grid differ
/// by far more, and those that ought to be equal by rounding alone.
pub(super) const SAME_ANGLE: f64 = 1e-9;

/// A painted sample with the vectors that distances need.
pub(super) struct PaintedSample<'a> {
    pub(super) address: Address,
    pub(super) light: DVec3,
    pub(super) view: DVec3,
    pub(super) tile: &'a Arc<Tile>,
    /// True if all texels are opaque.
    pub(super) is_opaque: bool,
}

/// Start of a tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum TileSource {
    /// Transparent black.
    Empty,
    /// A painted sample, by its number in the plan.
    Painted(u32),
    /// All painted samples, weighted by their distance from the address.
    Blend { address: Address, sharpness: Bits },
    /// The nearest painted samples, moved toward each other.
    Morph { address: Address, sharpness: Bits },
    /// A single color, straight RGBA.
    Uniform([u8; 4]),
    /// The drawing of a rule's generator.
    Generated { rule: u32, address: Address },
}

/// A finite number that can be hashed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Bits(u64);

impl Bits {
    fn new(value: f64) -> Self {
        // Adding zero makes negative zero positive, so that both have the same bits.
        Self((value + 0.0).to_bits())
    }

    pub(super) fn get(self) -> f64 {
        f64::from_bits(self.0)
    }
}

/// Change of a channel, a byte as a number from 0 to 255: factor, then offset.
pub(super) type ChannelMap = [Bits; 2];

/// Recipe of a tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Recipe {
    pub(super) source: TileSource,
    /// Turn of the content, in turns in [0, 1), from v toward u.
    pub(super) turn: Bits,
    /// Changes of red, green and blue.
    pub(super) maps: [ChannelMap; 3],
}

impl Recipe {
    fn of(source: TileSource) -> Self {
        Self { source, turn: Bits::new(0.0), maps: [[Bits::new(1.0), Bits::new(0.0)]; 3] }
    }

    pub(super) fn is_recolored(&self) -> bool {
        self.maps.iter().any(|[factor, offset]| factor.get() != 1.0 || offset.get() != 0.0)
    }

    /// Multiplies each channel by its factor and adds its offset, after all changes so far.
    fn then(&mut self, factor: [f64; 3], offset: [f64; 3]) {
        for ((map, factor), offset) in self.maps.iter_mut().zip(factor).zip(offset) {
            let [before, added] = map.map(Bits::get);
            *map = [Bits::new(before * factor), Bits::new(added * factor + offset)];
        }
    }
}

/// All recipes, and the recipe of each sample.
pub(super) struct FillPlan<'a> {
    pub(super) grid: Grid,
    pub(super) is_tiling: bool,
    pub(super) painted: Vec<PaintedSample<'a>>,
    pub(super) recipes: Vec<Recipe>,
    pub(super) provenances: Vec<Provenance>,
    /// Generator of each rule, where one is needed and prepared.
    pub(super) generators: Vec<Option<Generator>>,
    /// Flows between painted samples, where they are needed and prepared.
    pub(super) flows: Flows,
    /// Recipe and provenance of each sample, by index; in the grid's order if all samples are
    /// planned.
    pub(super) samples: Vec<[u32; 2]>,
}

impl<'a> FillPlan<'a> {
    /// Walks the rules for every sample; `None` if the work is stopped.
    pub(super) fn new(hcbtf: &'a Hcbtf, progress: &Progress) -> Option<Self> {
        Self::of(hcbtf, hcbtf.grid.addresses().collect(), progress)
    }

    /// Walks the rules for some samples only, by canonical address.
    pub(super) fn of(
        hcbtf: &'a Hcbtf,
        addresses: Vec<Address>,
        progress: &Progress,
    ) -> Option<Self> {
        let planner = FillPlanner::new(hcbtf);
        let walk = |address| (!progress.is_stopped()).then(|| planner.sample(address));
        let walked: Vec<(Recipe, Provenance)> =
            addresses.into_par_iter().map(walk).collect::<Option<_>>()?;
        let mut recipes: IndexMap<Recipe, ()> = IndexMap::new();
        let mut provenances: IndexSet<Provenance> = IndexSet::new();
        let samples = walked.into_iter().map(|(recipe, provenance)| {
            let recipe = recipes.insert_full(recipe, ()).0;
            [recipe as u32, provenances.insert_full(provenance).0 as u32]
        });
        let samples = samples.collect();
        Some(Self {
            grid: hcbtf.grid,
            is_tiling: hcbtf.is_tiling,
            painted: planner.painted,
            recipes: recipes.into_keys().collect(),
            provenances: provenances.into_iter().collect(),
            generators: Vec::new(),
            flows: Flows::default(),
            samples,
        })
    }

    /// Prepares the generators and flows that recipes need, once the time for these and for all
    /// tiles is known; `None` if the work is stopped.
    pub(super) fn prepare(&mut self, hcbtf: &Hcbtf, progress: &Progress) -> Option<()> {
        let rules = &hcbtf.rules;
        let mut generated: Vec<Vec<Address>> = vec![Vec::new(); rules.len()];
        for recipe in &self.recipes {
            if let TileSource::Generated { rule, address } = recipe.source {
                generated[rule as usize].push(address);
            }
        }
        let morphed = self.recipes.iter().filter_map(|recipe| match recipe.source {
            TileSource::Morph { address, sharpness } => Some((address, sharpness.get())),
            _ => None,
        });
        let pairs = Flows::pairs(morphed, &self.grid, &self.painted, progress)?;
        let rows = u64::from(self.grid.size[1]);
        let ahead = rules
            .iter()
            .zip(&generated)
            .map(|(rule, addresses)| Generator::tiles_ahead(rule, addresses));
        let ahead = ahead.fold(Flows::TILES_AHEAD * pairs.len() as u64, u64::saturating_add);
        progress.begin((self.recipes.len() as u64).saturating_add(ahead).saturating_mul(rows));
        for (rule, addresses) in rules.iter().zip(generated) {
            let ready = (!addresses.is_empty()).then(|| Generator::new(rule, hcbtf, progress));
            if ready.as_ref().is_some_and(Option::is_none) {
                return None;
            }
            self.generators.push(ready.flatten());
        }
        self.flows = Flows::new(pairs, self.is_tiling, &self.painted, progress)?;
        Some(())
    }
}

/// Inputs of walking the rules.
struct FillPlanner<'a> {
    grid: Grid,
    rules: &'a [Rule],
    painted: Vec<PaintedSample<'a>>,
    numbers: HashMap<Address, u32>,
    /// Look-up of each rule that is a [`Rule::Lock`].
    locks: Vec<Option<Lock>>,
}

impl<'a> FillPlanner<'a> {
    fn new(hcbtf: &'a Hcbtf) -> Self {
        let grid = hcbtf.grid;
        let fits = |(address, tile): &(&Address, &Arc<Tile>)| {
            grid.contains(**address) && tile.size() == grid.size
        };
        let painted = hcbtf.painted.iter().filter(fits).map(|(address, tile)| {
            let (light, view) = (grid.light.vector(address.light), grid.view.vector(address.view));
            let is_opaque = tile.bytes().iter().skip(3).step_by(4).all(|alpha| *alpha == 255);
            PaintedSample { address: address.canonical(), light, view, tile, is_opaque }
        });
        let painted: Vec<PaintedSample<'_>> = painted.collect();
        let numbers = painted
            .iter()
            .enumerate()
            .map(|(number, sample)| (sample.address, number as u32))
            .collect();
        let lock = |rule: &Rule| match rule {
            Rule::Lock { angles } => Some(Lock::new(angles, &painted)),
            _ => None,
        };
        let locks = hcbtf.rules.iter().map(lock).collect();
        Self { grid, rules: &hcbtf.rules, painted, numbers, locks }
    }

    fn sample(&self, address: Address) -> (Recipe, Provenance) {
        if let Some(number) = self.numbers.get(&address) {
            return (Recipe::of(TileSource::Painted(*number)), Provenance::Painted);
        }
        let mut filled: Option<(Recipe, usize, Vec<usize>)> = None;
        for (number, rule) in self.rules.iter().enumerate() {
            match &mut filled {
                None => {
                    let source = self.source(rule, number, address);
                    filled = source.map(|source| (Recipe::of(source), number, Vec::new()));
                }
                Some((recipe, _, changed_by)) => {
                    let before = *recipe;
                    change(rule, recipe, address, &self.grid);
                    if *recipe != before {
                        changed_by.push(number);
                    }
                }
            }
        }
        match filled {
            Some((recipe, by, changed_by)) => (recipe, Provenance::Filled { by, changed_by }),
            None => (Recipe::of(TileSource::Empty), Provenance::Empty),
        }
    }

    /// The start of a tile that a rule fills; `None` if the rule does not fill the sample.
    fn source(&self, rule: &Rule, number: usize, address: Address) -> Option<TileSource> {
        let painted =
            |from: &Address| self.numbers.get(&from.canonical()).copied().map(TileSource::Painted);
        match rule {
            Rule::Copy { from } => painted(from),
            Rule::Lock { .. } => {
                let lock = self.locks.get(number)?.as_ref()?;
                lock.nearest(address, &self.grid, &self.painted).map(TileSource::Painted)
            }
            Rule::Blend { .. } | Rule::Morph { .. } if self.painted.is_empty() => None,
            Rule::Blend { sharpness } => {
                let sharpness = Bits::new(finite(*sharpness).clamp(0.0, Rule::MAX_SHARPNESS));
                Some(TileSource::Blend { address, sharpness })
            }
            Rule::Morph { sharpness } => {
                let sharpness = Bits::new(finite(*sharpness).clamp(0.0, Rule::MAX_SHARPNESS));
                Some(TileSource::Morph { address, sharpness })
            }
            Rule::Mirror { color: [r, g, b, a], width } => {
                let off = self.off_mirrored(address);
                let fade = || 0.5 + 0.5 * (PI * off / width).cos();
                (off < *width).then(|| {
                    TileSource::Uniform([*r, *g, *b, (f64::from(*a) * fade()).round() as u8])
                })
            }
            Rule::Specular { from, width } => {
                if self.off_mirrored(address) <= width + SAME_ANGLE {
                    painted(from)
                } else {
                    None
                }
            }
            Rule::Color { color } => Some(TileSource::Uniform(*color)),
            Rule::Strokes(_) => Some(TileSource::Generated { rule: number as u32, address }),
            Rule::Relief(relief) => {
                let is_painted = relief.painted().all(|from| painted(&from).is_some());
                is_painted.then_some(TileSource::Generated { rule: number as u32, address })
            }
            Rule::Lambert { .. } | Rule::Rotate { .. } | Rule::Recolor { .. } => None,
        }
    }

    /// The angle between the light and the mirrored direction of the view, in radians.
    fn off_mirrored(&self, address: Address) -> f64 {
        let view = self.grid.view.vector(address.view);
        angle(self.grid.light.vector(address.light), DVec3::new(-view.x, -view.y, view.z))
    }
}

/// Adds the change that a rule makes to a sample's recipe.
fn change(rule: &Rule, recipe: &mut Recipe, address: Address, grid: &Grid) {
    match rule {
        Rule::Lambert { shadow, amount } => {
            let [theta, _] = grid.light.angles(address.light);
            let kept = 1.0 - finite(*amount).clamp(0.0, 1.0) * (1.0 - theta.cos().max(0.0));
            recipe.then([kept; 3], shadow.map(|channel| f64::from(channel) * (1.0 - kept)));
        }
        // A single color has nothing that could be turned, and at the normal the angle is 0.
        Rule::Rotate { turns }
            if address.view.theta > 0 && !matches!(recipe.source, TileSource::Uniform(_)) =>
        {
            let share = f64::from(address.view.phi) / f64::from(grid.view.phi.max(1));
            recipe.turn = Bits::new(snapped(recipe.turn.get() + finite(*turns) * share));
        }
        Rule::Recolor { angle, from, to } => {
            let at = along(*angle, address, grid);
            let channel =
                |i: usize| (f64::from(from[i]) * (1.0 - at) + f64::from(to[i]) * at) / 255.0;
            recipe.then([channel(0), channel(1), channel(2)], [0.0; 3]);
        }
        _ => {}
    }
}

fn finite(value: f64) -> f64 {
    if value.is_finite() { value } else { 0.0 }
}

/// Turns in [0, 1); a quarter with a rounding error becomes an exact one.
fn snapped(turns: f64) -> f64 {
    let turns = turns.rem_euclid(1.0);
    let quarters = (4.0 * turns).round();
    if (4.0 * turns - quarters).abs() < SAME_ANGLE { (quarters / 4.0) % 1.0 } else { turns }
}

/// The position of a sample along an angle, from 0 to 1: from the normal to the horizon, or from
/// phi 0 half a turn around, and back. At the normal every step around it is equally right, so the
/// position is in the middle.
fn along(angle: Angle, address: Address, grid: &Grid) -> f64 {
    let from_normal =
        |directions: Directions, direction: Direction| directions.angles(direction)[0] / FRAC_PI_2;
    let around = |directions: Directions, direction: Direction| match direction.theta {
        0 => 0.5,
        _ => 1.0 - (1.0 - directions.angles(direction)[1] / PI).abs(),
    };
    match angle {
        Angle::LightTheta => from_normal(grid.light, address.light),
        Angle::LightPhi => around(grid.light, address.light),
        Angle::ViewTheta => from_normal(grid.view, address.view),
        Angle::ViewPhi => around(grid.view, address.view),
    }
}
