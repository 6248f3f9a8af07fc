//! Target of the fit: the strokes at the size of the fit.

use super::ground::Ground;
use crate::document::Tile;
use crate::fit::{MissedPixel, PixelGoal};

/// Number of pixels of a sketch along each side of a pixel of the fit.
pub(super) const FINENESS: u32 = 3;
/// Least coverage that counts as painted.
const LEAST: f64 = 1.0 / 32.0;

/// Goals of a sketch at the pixels that can be compared. A goal's color is the mean of the strokes
/// that cover its pixel, and its weight is the covered part of the pixel.
pub(super) fn goals(tile: &Tile, ground: &Ground) -> Vec<PixelGoal> {
    let [width, height] = ground.size;
    if tile.size() != ground.size.map(|side| side * FINENESS) {
        return Vec::new();
    }
    let (texels, _) = tile.bytes().as_chunks::<4>();
    let stride = (width * FINENESS) as usize;
    let mut goals = Vec::new();
    for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        if !ground.counts[(y * width + x) as usize] {
            continue;
        }
        let (mut sum, mut alpha) = ([0.0; 3], 0.0);
        for row in 0..FINENESS {
            let first = ((y * FINENESS + row) as usize) * stride + (x * FINENESS) as usize;
            for texel in &texels[first..first + FINENESS as usize] {
                let cover = f64::from(texel[3]) / 255.0;
                (0..3)
                    .for_each(|channel| sum[channel] += cover * f64::from(texel[channel]) / 255.0);
                alpha += cover;
            }
        }
        let weight = alpha / f64::from(FINENESS * FINENESS);
        if weight >= LEAST {
            goals.push(PixelGoal {
                pixel: [x, y],
                color: sum.map(|channel| channel / alpha),
                weight,
                is_rest: false,
            });
        }
    }
    goals
}

/// RMS of a channel, weighted by the goals, 0 to 1.
pub(super) fn off(goals: &[PixelGoal], shown: impl Fn([u32; 2]) -> Option<[f64; 3]>) -> f64 {
    let (mut sum, mut total) = (0.0, 0.0);
    for goal in goals {
        let Some(shown) = shown(goal.pixel) else { continue };
        let squares: f64 =
            shown.iter().zip(goal.color).map(|(shown, wished)| (shown - wished).powi(2)).sum();
        sum += goal.weight * squares / 3.0;
        total += goal.weight;
    }
    if total > 0.0 { (sum / total).sqrt() } else { 0.0 }
}

/// Distance of each goal from the color of the ground.
pub(super) fn misses(goals: &[PixelGoal], ground: &Ground) -> Vec<MissedPixel> {
    let missed = |goal: &PixelGoal| {
        let shown = shown(ground, goal.pixel);
        let error = off(&[PixelGoal { weight: 1.0, ..*goal }], |_| Some(shown));
        MissedPixel { pixel: goal.pixel, wished: goal.color, shown, error }
    };
    goals.iter().map(missed).collect()
}

/// Color of the ground at a pixel.
pub(super) fn shown(ground: &Ground, [x, y]: [u32; 2]) -> [f64; 3] {
    ground.colors.get((y * ground.size[0] + x) as usize).copied().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pixel_wishes_as_much_as_it_is_covered() {
        let mut ground = Ground::flat([40, 30], [0.2; 3]);
        ground.counts[1] = false;
        let mut tile = Tile::filled([120, 90], [0; 4]);
        // The first three pixels are covered fully, but the second does not count; the fourth is
        // covered by a third.
        for (x, y) in (0..3).flat_map(|y| (0..10).map(move |x| (x, y))) {
            tile.bytes_mut()[4 * (y * 120 + x)..][..4].copy_from_slice(&[255, 0, 51, 255]);
        }
        let painted = goals(&tile, &ground);
        let at: Vec<[u32; 2]> = painted.iter().map(|goal| goal.pixel).collect();
        assert_eq!(at, [[0, 0], [2, 0], [3, 0]]);
        let near = |goal: &PixelGoal| {
            goal.color.iter().zip([1.0, 0.0, 0.2]).all(|(a, b)| (a - b).abs() < 1e-12)
        };
        assert!(painted.iter().all(near));
        assert!((painted[2].weight - 1.0 / 3.0).abs() < 1e-12 && painted[0].weight == 1.0);
        // Each of the three pixels is off by 0.8, 0.2 and 0 in its channels.
        let off = off(&painted, |pixel| Some(shown(&ground, pixel)));
        assert!((off - ((0.64 + 0.04) / 3.0_f64).sqrt()).abs() < 1e-12);
        assert_eq!(misses(&painted, &ground).len(), 3);
    }

    #[test]
    fn a_sketch_of_another_size_wishes_nothing() {
        assert!(goals(&Tile::filled([6, 6], [255; 4]), &Ground::flat([3, 3], [0.5; 3])).is_empty());
    }
}
