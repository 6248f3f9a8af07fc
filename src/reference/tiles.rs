//! Baking of a look to an HCBTF: every texel of every sample is painted with the color that the
//! look shows there, as the reference computes it.
//!
//! A texel is the mean of several samples, premultiplied and in the look's own colors, as the
//! samples of a pixel are averaged when the look is drawn: in linear light if the look is linear,
//! else as shown. Footprints are 0 here and smooth nothing, so hard edges of patterns need enough
//! samples.

use std::sync::Arc;

use chiaro_locale::tr;
use rayon::iter::{IntoParallelRefIterator as _, ParallelIterator as _};

use super::eval::Evaluator;
use crate::diag::Diagnostic;
use crate::document::{Address, ColorSpace, Grid, Hcbtf, Tile, linear_to_srgb};
use crate::frame::{Assets, EvalSample, Evaluable, MAX_TILE_SAMPLES, SetupLook, TileView};
use crate::hcbtf::check_all_painted;
use crate::ids::LightId;
use crate::interp::Precision;
use crate::library::Library;
use crate::progress::Progress;

/// Default number of samples of a texel: as many as a pixel has.
pub const TILE_SAMPLES: u32 = 4;
/// Number of samples that are evaluated at once, which bounds memory and the time to stop.
const AT_ONCE: usize = 4096;

/// Result of baking a look.
#[derive(Clone, Debug, PartialEq)]
pub struct BakedLook {
    /// The HCBTF, all of it painted.
    pub hcbtf: Hcbtf,
    /// Difference between half of the samples and all of them: the RMS over all channels of all
    /// texels, over black and as shown, 1 for the whole range of a channel. `None` if a texel has
    /// one sample.
    pub halves_off: Option<f64>,
}

/// Bakes a look on a flat tile for every sample of a grid, as [`bake_look_sampled`] with
/// [`TILE_SAMPLES`].
///
/// # Errors
/// As [`bake_look_sampled`].
pub fn bake_look(
    setup: &SetupLook,
    library: &Library,
    grid: Grid,
    light: &LightId,
    assets: &Assets,
    progress: &Progress,
) -> Result<Hcbtf, Vec<Diagnostic>> {
    bake_look_sampled(setup, library, grid, light, assets, TILE_SAMPLES, progress)
        .map(|baked| baked.hcbtf)
}

/// Bakes a look on a flat tile for every sample of a grid, its light at the sample's direction, on
/// all cores. A texel is the mean of `samples`, a power of 2 up to [`MAX_TILE_SAMPLES`]. The result
/// is the same on every machine. `assets` holds the files that the look names, best read before
/// ([`tile_assets`](crate::frame::tile_assets)). `progress` counts pieces of a sample's tile, and
/// stops within one.
///
/// # Errors
/// `stopped` if `progress` was stopped, a grid that is too large for a file, and all problems of
/// the look.
pub fn bake_look_sampled(
    setup: &SetupLook,
    library: &Library,
    grid: Grid,
    light: &LightId,
    assets: &Assets,
    samples: u32,
    progress: &Progress,
) -> Result<BakedLook, Vec<Diagnostic>> {
    let one = |problem: Diagnostic| vec![problem];
    grid.check().map_err(|why| one(Diagnostic::error("hcbtf-grid", why)))?;
    check_all_painted(&grid).map_err(one)?;
    if !samples.is_power_of_two() || samples > MAX_TILE_SAMPLES {
        let message = tr!(
            "a texel cannot have {samples} samples: 1, 2, 4 and so on up to {MAX_TILE_SAMPLES}"
        );
        return Err(one(Diagnostic::error("out-of-range", message)));
    }
    let addresses: Vec<Address> = grid.addresses().collect();
    progress.begin((addresses.len() * grid.texels().div_ceil(texels_at_once(samples))) as u64);
    let look = Evaluable::new(setup, library, &mut assets.clone())?;
    let evaluator = Evaluator::new(&look.shader, &look.images).map_err(one)?;
    let is_linear = setup.look.color_space == ColorSpace::Linear;
    let baking = LookBaker { look, evaluator, samples, is_linear, progress };
    let painted = addresses.par_iter().map(|address| {
        let view = TileView::new(setup, &grid, light, *address);
        baking.tile(&view, grid.size).map(|(tile, halves)| (*address, Arc::new(tile), halves))
    });
    let painted: Vec<(Address, Arc<Tile>, f64)> = painted.collect::<Result<_, _>>().map_err(one)?;
    let sum: f64 = painted.iter().map(|(_, _, halves)| halves).sum();
    let count = 4.0 * (painted.len() * grid.texels()) as f64;
    let halves_off = (samples > 1).then(|| (sum / count).sqrt());
    let painted = painted.into_iter().map(|(address, tile, _)| (address, tile)).collect();
    Ok(BakedLook { hcbtf: Hcbtf { painted, ..Hcbtf::new(grid) }, halves_off })
}

fn texels_at_once(samples: u32) -> usize {
    AT_ONCE / samples as usize
}

/// A look that is being baked.
struct LookBaker<'a> {
    look: Evaluable<'a>,
    evaluator: Evaluator,
    samples: u32,
    is_linear: bool,
    progress: &'a Progress,
}

impl LookBaker<'_> {
    /// A sample's tile, and the sum of the squared differences between half of its samples and all
    /// of them.
    fn tile(&self, view: &TileView, size: [u32; 2]) -> Result<(Tile, f64), Diagnostic> {
        let texels = size[0] as usize * size[1] as usize;
        let mut rgba = Vec::with_capacity(4 * texels);
        let mut halves = 0.0;
        for first in (0..texels).step_by(texels_at_once(self.samples)) {
            let piece = first..texels.min(first + texels_at_once(self.samples));
            for values in self.values(view, piece)?.chunks_exact(self.samples as usize) {
                if values.len() > 1 {
                    let [one, other] = halves_of(values).map(|half| self.seen(mean(&half)));
                    halves += one
                        .iter()
                        .zip(other)
                        .map(|(one, other)| ((one - other) / 2.0).powi(2))
                        .sum::<f64>();
                }
                rgba.extend(
                    self.shown(mean(values)).map(|channel| (255.0 * channel).round() as u8),
                );
            }
            self.progress.add(1);
        }
        // The loop has pushed four bytes for every texel.
        let tile = Tile::new(size, rgba)
            .ok_or_else(|| Diagnostic::error("hcbtf-grid", tr!("a tile has no texels")))?;
        Ok((tile, halves))
    }

    /// The look's colors at all samples of some texels, straight, texel by texel.
    fn values(
        &self,
        view: &TileView,
        texels: std::ops::Range<usize>,
    ) -> Result<Vec<[f64; 4]>, Diagnostic> {
        self.progress.check()?;
        let samples = texels.flat_map(|texel| (0..self.samples).map(move |index| (texel, index)));
        let samples: Vec<EvalSample> =
            samples.map(|(texel, index)| view.sample(texel, index, self.samples)).collect();
        let packed = self.look.pack(samples.iter())?;
        self.evaluator.run(&packed, samples.len(), Precision::F64, self.progress)
    }

    /// A color as shown, straight, 0 to 1.
    fn shown(&self, [r, g, b, a]: [f64; 4]) -> [f64; 4] {
        let encoded = |value: f64| if self.is_linear { linear_to_srgb(value) } else { value };
        [encoded(r), encoded(g), encoded(b), a].map(|channel| channel.clamp(0.0, 1.0))
    }

    /// A color as shown over black.
    fn seen(&self, color: [f64; 4]) -> [f64; 4] {
        let [r, g, b, a] = self.shown(color);
        [r * a, g * a, b * a, a]
    }
}

/// A texel's samples in two halves that both spread over all of it: they are split by the parity of
/// the ones in their index, as each bit halves the texel anew, in one direction or the other.
fn halves_of(samples: &[[f64; 4]]) -> [Vec<[f64; 4]>; 2] {
    let half = |odd| {
        let own =
            samples.iter().zip(0_u32..).filter(move |(_, index)| index.count_ones() % 2 == odd);
        own.map(|(sample, _)| *sample).collect()
    };
    [half(0), half(1)]
}

/// The mean of straight colors, weighted by their alpha; equally weighted if all are transparent.
fn mean(colors: &[[f64; 4]]) -> [f64; 4] {
    if let [only] = colors {
        return *only;
    }
    let count = colors.len() as f64;
    let alpha: f64 = colors.iter().map(|color| color[3]).sum();
    let weighted = |weight: &dyn Fn(&[f64; 4]) -> f64, whole: f64| {
        [0, 1, 2].map(|channel| {
            colors.iter().map(|color| weight(color) * color[channel]).sum::<f64>() / whole
        })
    };
    let [r, g, b] =
        if alpha > 0.0 { weighted(&|color| color[3], alpha) } else { weighted(&|_| 1.0, count) };
    [r, g, b, alpha / count]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_transparent_lends_no_color() {
        assert_eq!(mean(&[[0.3, 0.6, 0.9, 0.25]]), [0.3, 0.6, 0.9, 0.25]);
        assert_eq!(mean(&[[1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 0.0]]), [1.0, 0.0, 0.0, 0.5]);
        assert_eq!(mean(&[[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]]), [0.5, 0.5, 0.0, 0.0]);
        assert_eq!(mean(&[[1.0, 0.0, 0.0, 0.75], [0.0, 1.0, 0.0, 0.25]]), [0.75, 0.25, 0.0, 0.5]);
    }
}
