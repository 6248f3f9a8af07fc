//! A look as a painted HCBTF: every texel of every sample is what the look shows there, as the reference works it out.

use std::sync::Arc;

use rayon::iter::{IntoParallelRefIterator as _, ParallelIterator as _};

use super::evaluate;
use crate::diag::Diagnostic;
use crate::document::{Direction, Grid, Hcbtf};
use crate::frame::{Assets, SetupLook, tile_batches, tiles_of};
use crate::hcbtf::{NotFilled, Progress, check_all_painted};
use crate::ids::LightId;
use crate::interp::Precision;
use crate::library::Library;

/// Paints every sample of a grid with what a look shows on a flat tile, its light at the sample's direction, on all cores.
/// The result is the same on every machine. `assets` has what the look names, best read before
/// ([`tile_assets`](crate::frame::tile_assets)). `progress` counts views.
///
/// # Errors
/// Where it is stopped, where the grid is too large for a file, and everything that is wrong with the look.
pub fn bake_look(
    setup: &SetupLook,
    library: &Library,
    grid: Grid,
    light: &LightId,
    assets: &Assets,
    progress: &Progress,
) -> Result<Hcbtf, Vec<Diagnostic>> {
    let one = |problem: Diagnostic| vec![problem];
    grid.check().map_err(|why| one(Diagnostic::error("hcbtf-grid", why)))?;
    check_all_painted(&grid).map_err(one)?;
    let views: Vec<Direction> = grid.view.distinct().collect();
    progress.begin(views.len() as u64);
    let painted = views.par_iter().map(|view| {
        if progress.is_stopped() {
            return Err(one(NotFilled::Stopped.into()));
        }
        let batches = tile_batches(setup, library, &grid, light, *view, &mut assets.clone())?;
        let mut values = vec![[0.0; 4]; batches.iter().map(|batch| batch.indices.len()).sum()];
        for batch in &batches {
            for (index, value) in batch.indices.iter().zip(evaluate(batch, Precision::F64).map_err(one)?) {
                values[*index] = value;
            }
        }
        progress.add(1);
        Ok(tiles_of(setup, &grid, *view, &values))
    });
    let painted: Vec<Vec<_>> = painted.collect::<Result<_, _>>()?;
    let painted = painted.into_iter().flatten().map(|(address, tile)| (address, Arc::new(tile))).collect();
    Ok(Hcbtf { painted, ..Hcbtf::new(grid) })
}
