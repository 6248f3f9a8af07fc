//! A relief of the tile: a height field as every eye sees it under every light.
//!
//! A `field` of cells finer than the texels is made of the pattern once, and `transport` computes
//! the shares of the sky and of the other cells that every cell sees. Then the surface that an eye
//! sees (`seen`) depends on the view alone, and the light on the field (`lit`) on the light alone:
//! each is computed when it is first asked for and kept, and a sample combines the two (`shade`).
//! Light is linear; the colors of a sample are display colors, as all paint is.
//!
//! Each of these results is computed on one thread, so that no thread waits for itself; samples go
//! over all cores.

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

use self::field::HeightField;
use self::lit::FieldLight;
use self::pattern::PatternSampler;
use self::seen::VisibleSurface;
use self::transport::Transport;
use super::Color;
use crate::document::{Address, Direction, Directions, Grid, Hcbtf, Relief};
use crate::hcbtf::noise;
use crate::progress::Progress;

/// Time that the preparations take, in tiles, for progress: as measured for the examples, within a
/// factor of three.
pub(super) const FIELD_TILES: u64 = 12;
pub(super) const TRANSPORT_TILES: u64 = 30;
const SEEN_TILES: u64 = 1;
const LIT_TILES: u64 = 3;

/// The time that the preparations for these samples take, in tiles.
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

/// A relief that is prepared and makes tiles.
pub(in crate::hcbtf) struct PreparedRelief {
    relief: Relief,
    grid: Grid,
    field: HeightField,
    transport: Transport,
    /// Surface that each view sees, by the view's index in the grid; `None` within a cell if the
    /// work was stopped.
    seen: Vec<OnceLock<Option<VisibleSurface>>>,
    /// Light of each direction, by the light's index in the grid.
    lit: Vec<OnceLock<Option<FieldLight>>>,
}

impl PreparedRelief {
    /// Prepares a relief; `None` if the work is stopped, and if a painted sample is missing.
    pub(super) fn new(relief: &Relief, hcbtf: &Hcbtf, progress: &Progress) -> Option<Self> {
        let sampler = PatternSampler::new(relief, hcbtf)?;
        let field = HeightField::new(relief, hcbtf.grid.size, &sampler, progress)?;
        Self::of(relief.clone(), hcbtf.grid, field, progress)
    }

    fn of(relief: Relief, grid: Grid, field: HeightField, progress: &Progress) -> Option<Self> {
        let transport = Transport::new(&field, progress)?;
        let slots = |directions: Directions| 0..directions.distinct_count();
        let seen = slots(grid.view).map(|_| OnceLock::new()).collect();
        let lit = slots(grid.light).map(|_| OnceLock::new()).collect();
        Some(Self { relief, grid, field, transport, seen, lit })
    }

    /// The texels of a sample; `None` if the work is stopped.
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
            let lit = FieldLight::new(&self.relief, &self.field, &self.transport, light, progress);
            progress.add(LIT_TILES * rows);
            lit
        });
        let (seen, lit) = (seen.as_ref()?, lit.as_ref()?);
        shade::tile(self, seen, lit, view, progress)
    }
}

/// The vector of a direction, along x, along y (down), and out of the tile.
fn toward(directions: Directions, direction: Direction) -> [f32; 3] {
    let vector = directions.vector(direction);
    [vector.x as f32, -vector.y as f32, vector.z as f32]
}
