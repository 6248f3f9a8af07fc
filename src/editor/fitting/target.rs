//! What is asked of the fit: the strokes at the size that is fitted at, and the rest as it is.

use std::collections::HashMap;

use super::ground::Ground;
use crate::document::Tile;
use crate::fit::{Missed, Target, Wish};

/// A sketch has so many pixels along each side of one that is fitted.
pub(super) const FINENESS: u32 = 3;
/// What is covered by less than this was hardly painted.
const LEAST: f64 = 1.0 / 32.0;
/// As many pixels tell of what was not painted.
const MOST_REST: usize = 768;

/// The wishes of a sketch at the pixels that can be compared. Colours are means of what covers a pixel, and the weight is
/// how much of it is covered.
pub(super) fn wishes(tile: &Tile, ground: &Ground) -> Vec<Wish> {
    let [width, height] = ground.size;
    if tile.size() != ground.size.map(|side| side * FINENESS) {
        return Vec::new();
    }
    let (texels, _) = tile.bytes().as_chunks::<4>();
    let stride = (width * FINENESS) as usize;
    let mut wishes = Vec::new();
    for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        if !ground.counts[(y * width + x) as usize] {
            continue;
        }
        let (mut sum, mut alpha) = ([0.0; 3], 0.0);
        for row in 0..FINENESS {
            let first = ((y * FINENESS + row) as usize) * stride + (x * FINENESS) as usize;
            for texel in &texels[first..first + FINENESS as usize] {
                let cover = f64::from(texel[3]) / 255.0;
                (0..3).for_each(|channel| sum[channel] += cover * f64::from(texel[channel]) / 255.0);
                alpha += cover;
            }
        }
        let weight = alpha / f64::from(FINENESS * FINENESS);
        if weight >= LEAST {
            wishes.push(Wish { pixel: [x, y], color: sum.map(|channel| channel / alpha), weight });
        }
    }
    wishes
}

/// The whole target: what is painted, and of the rest some pixels that are to stay as they are. These count `hold` times
/// as much, all together, as all that is painted; 0 lets them go.
pub(super) fn target(painted: &[Wish], ground: &Ground, hold: f64) -> Target {
    let mut wishes = painted.to_vec();
    let known: HashMap<[u32; 2], f64> = painted.iter().map(|wish| (wish.pixel, wish.weight)).collect();
    let [width, _] = ground.size;
    let pixel = |index: usize| [index as u32 % width, index as u32 / width];
    let is_free = |index: &usize| ground.counts[*index] && !known.contains_key(&pixel(*index));
    let free: Vec<usize> = (0..ground.counts.len()).filter(is_free).collect();
    let step = free.len().div_ceil(MOST_REST).max(1);
    let rest: Vec<usize> = free.into_iter().step_by(step).collect();
    let weight = hold * known.values().sum::<f64>() / rest.len().max(1) as f64;
    if weight > 0.0 {
        wishes.extend(rest.into_iter().map(|index| Wish { pixel: pixel(index), color: ground.colors[index], weight }));
    }
    Target { size: ground.size, wishes }
}

/// The RMS of a channel, weighted as painted, from 0 to 1.
pub(super) fn off(wishes: &[Wish], shown: impl Fn([u32; 2]) -> Option<[f64; 3]>) -> f64 {
    let (mut sum, mut total) = (0.0, 0.0);
    for wish in wishes {
        let Some(shown) = shown(wish.pixel) else { continue };
        let squares: f64 = shown.iter().zip(wish.color).map(|(shown, wished)| (shown - wished).powi(2)).sum();
        sum += wish.weight * squares / 3.0;
        total += wish.weight;
    }
    if total > 0.0 { (sum / total).sqrt() } else { 0.0 }
}

/// How far each wish is from what the ground shows.
pub(super) fn misses(wishes: &[Wish], ground: &Ground) -> Vec<Missed> {
    let missed = |wish: &Wish| {
        let shown = shown(ground, wish.pixel);
        let error = off(&[Wish { weight: 1.0, ..*wish }], |_| Some(shown));
        Missed { pixel: wish.pixel, wished: wish.color, shown, error }
    };
    wishes.iter().map(missed).collect()
}

/// What the ground shows at a pixel.
pub(super) fn shown(ground: &Ground, [x, y]: [u32; 2]) -> [f64; 3] {
    ground.colors.get((y * ground.size[0] + x) as usize).copied().unwrap_or_default()
}
