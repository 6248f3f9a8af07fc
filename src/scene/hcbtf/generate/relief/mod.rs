//! A relief of the tile: a height field as every eye sees it under every light.
//!
//! A `field` of cells finer than the texels is made of the pattern once, and `transport` finds what
//! every cell sees of the sky and of the others. Then what an eye sees (`seen`) depends on the view
//! alone, and what a light does (`lit`) on the light alone: each is worked out when it is first
//! asked for and kept, and a sample puts the two together (`shade`). Light is linear; what a sample
//! shows is in display colors, as all paint is.
//!
//! Each of them is worked out on one thread, so that no thread waits for itself; samples go over
//! all cores.

mod field;
mod lit;

mod pattern;
mod seen;
mod shade;
#[cfg(test)]
mod tests;
mod transport;

use std::collections::BTreeSet;
use std::sync::OnceLock;

use self::field::Field;
use self::lit::Lit;
use self::pattern::Sampler;
use self::seen::VisibleSurface;
use self::transport::Transport;
use super::Color;
use crate::document::{Address, Direction, Directions, Grid, Hcbtf, Relief};
use crate::hcbtf::noise;
use crate::progress::Progress;

/// How long what is made ahead of the tiles takes, in tiles: as measured for the examples, within a
/// factor of three.
pub(super) const FIELD_TILES: u64 = 12;
pub(super) const TRANSPORT_TILES: u64 = 30;
const SEEN_TILES: u64 = 1;
const LIT_TILES: u64 = 3;

/// What is made ahead of the tiles of these samples takes as long as so many tiles.
pub(super) fn tiles_ahead(samples: &[Address]) -> u64 {
    let views: BTreeSet<Direction> =
        samples.iter().map(|address| address.view.canonical()).collect();
    let lights: BTreeSet<Direction> =
        samples.iter().map(|address| address.light.canonical()).collect();
    FIELD_TILES
        + TRANSPORT_TILES
        + SEEN_TILES * views.len() as u64
        + LIT_TILES * lights.len() as u64
}

/// Ready to give tiles.
pub(in crate::hcbtf) struct Ready {
    relief: Relief,
    grid: Grid,
    field: Field,
    transport: Transport,
    /// By the view's place in the grid; `None` in it where it was stopped.
    seen: Vec<OnceLock<Option<VisibleSurface>>>,
    /// By the light's.
    lit: Vec<OnceLock<Option<Lit>>>,
}

impl Ready {
    /// `None` where it is stopped, and where a painted sample is missing.
    pub(super) fn new(relief: &Relief, hcbtf: &Hcbtf, progress: &Progress) -> Option<Self> {
        let sampler = Sampler::new(relief, hcbtf)?;
        let field = Field::new(relief, hcbtf.grid.size, &sampler, progress)?;
        Self::of(relief.clone(), hcbtf.grid, field, progress)
    }

    fn of(relief: Relief, grid: Grid, field: Field, progress: &Progress) -> Option<Self> {
        let transport = Transport::new(&field, progress)?;
        let slots = |directions: Directions| 0..directions.distinct_count();
        let seen = slots(grid.view).map(|_| OnceLock::new()).collect();
        let lit = slots(grid.light).map(|_| OnceLock::new()).collect();
        Some(Self { relief, grid, field, transport, seen, lit })
    }

    /// The texels of a sample; `None` where it is stopped.
    pub(super) fn tile(&self, address: Address, progress: &Progress) -> Option<Vec<Color>> {
        let (view, light) =
            (toward(self.grid.view, address.view), toward(self.grid.light, address.light));
        let of = |directions: Directions, direction: Direction| {
            usize::try_from(directions.index(direction)).ok()
        };
        let seen = self.seen.get(of(self.grid.view, address.view)?)?;
        let rows = u64::from(self.grid.size[1]);
        let seen = seen.get_or_init(|| {
            let seen = VisibleSurface::new(&self.relief, &self.field, view, progress);
            progress.add(SEEN_TILES * rows);
            seen
        });
        let lit = self.lit.get(of(self.grid.light, address.light)?)?;
        let lit = lit.get_or_init(|| {
            let lit = Lit::new(&self.relief, &self.field, &self.transport, light, progress);
            progress.add(LIT_TILES * rows);
            lit
        });
        let (seen, lit) = (seen.as_ref()?, lit.as_ref()?);
        shade::tile(self, seen, lit, view, progress)
    }
}

/// A direction along x, along y (down), and out of the tile.
fn toward(directions: Directions, direction: Direction) -> [f32; 3] {
    let vector = directions.vector(direction);
    [vector.x as f32, -vector.y as f32, vector.z as f32]
}
