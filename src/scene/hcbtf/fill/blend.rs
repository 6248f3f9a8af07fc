//! Blending of painted samples by their distances: the thesis's first idea, which it found too
//! slow.
//!
//! The kernel is Shepard's (1968): a sample at distance d has the weight d^(-2 sharpness), divided
//! by the sum of all. The weight tends to 1 toward a painted sample whatever else is painted, needs
//! no width, and so the kernel works for two samples as for two thousand, however they lie.
//! Distance is on the product of the two spheres: the root of the sum of the squares of the two
//! great-circle angles, of the lights and of the views. At the normal a direction has no step
//! around it, and none is needed.

use super::lock::squared_distance;
use super::plan::PaintedSample;
use crate::document::{Address, Grid};

/// Least weight of samples that are blended, times the number of painted samples: the others
/// together are less than a thousandth of the step between two bytes.
const NEGLIGIBLE: f64 = 1e-6;

/// The painted samples that count at an address, by number, with weights that sum to 1.
pub(super) fn weights(
    address: Address,
    sharpness: f64,
    grid: &Grid,
    painted: &[PaintedSample<'_>],
) -> Vec<(u32, f32)> {
    let (light, view) = (grid.light.vector(address.light), grid.view.vector(address.view));
    // Weights are computed in logarithms: powers of small distances overflow, those of large ones
    // underflow.
    let logs = painted.iter().map(|sample| {
        let squared = squared_distance(light, view, sample).max(f64::MIN_POSITIVE);
        -sharpness * squared.ln()
    });
    let logs: Vec<f64> = logs.collect();
    let largest = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let sum: f64 = logs.iter().map(|log| (log - largest).exp()).sum();
    let least = NEGLIGIBLE / painted.len().max(1) as f64;
    let numbered =
        logs.iter().enumerate().map(|(number, log)| (number as u32, (log - largest).exp() / sum));
    let kept: Vec<(u32, f64)> = numbered.filter(|(_, weight)| *weight >= least).collect();
    let sum: f64 = kept.iter().map(|(_, weight)| weight).sum();
    kept.into_iter().map(|(number, weight)| (number, (weight / sum) as f32)).collect()
}

/// A row of the blend, or a part of one, from a texel on: straight RGBA from 0 to 255, colors
/// weighted by alpha as well.
pub(super) fn row(
    weights: &[(u32, f32)],
    painted: &[PaintedSample<'_>],
    from: usize,
    blended: &mut [[f32; 4]],
) {
    blended.fill([0.0; 4]);
    let wide = blended.len();
    let rows = || {
        let range = 4 * from..4 * (from + wide);
        weights.iter().filter_map(move |(number, weight)| {
            let sample = painted.get(*number as usize)?;
            Some((sample.tile.bytes().get(range.clone())?, *weight, sample.is_opaque))
        })
    };
    // Each sample adds color times alpha, and 255 times alpha.
    for (row, weight, is_opaque) in rows() {
        if is_opaque {
            // Most samples are opaque, and then all bytes are treated alike, many at once: three
            // times as fast.
            let weight = 255.0 * weight;
            let sums = blended.as_flattened_mut().iter_mut();
            sums.zip(row).for_each(|(sum, byte)| *sum += weight * f32::from(*byte));
            continue;
        }
        for (sum, texel) in blended.iter_mut().zip(row.chunks_exact(4)) {
            let alpha = weight * f32::from(texel[3]);
            sum[0] += alpha * f32::from(texel[0]);
            sum[1] += alpha * f32::from(texel[1]);
            sum[2] += alpha * f32::from(texel[2]);
            sum[3] += alpha * 255.0;
        }
    }
    for (x, sum) in blended.iter_mut().enumerate() {
        let alpha = sum[3] / 255.0;
        sum[3] = alpha;
        if alpha > 0.0 {
            (sum[0], sum[1], sum[2]) = (sum[0] / alpha, sum[1] / alpha, sum[2] / alpha);
        } else {
            // The blend is transparent here; the hidden colors are blended all the same, as
            // painting programs keep them.
            for (row, weight, _) in rows() {
                (0..3).for_each(|channel| sum[channel] += weight * f32::from(row[4 * x + channel]));
            }
        }
    }
}
