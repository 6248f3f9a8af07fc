//! Smaller levels of a tile, for surfaces that are far away.

use std::collections::HashMap;
use std::sync::Arc;

use rayon::iter::{IntoParallelRefIterator as _, ParallelIterator as _};

use crate::document::{Grid, Tile};

/// The sizes of a tile's levels, the tile itself first and one texel last.
pub(super) fn level_sizes(grid: &Grid) -> impl Iterator<Item = [u32; 2]> {
    std::iter::successors(Some(grid.size), |size| {
        (*size != [1, 1]).then(|| size.map(|side| (side / 2).max(1)))
    })
}

/// The smaller levels of all these tiles, each made once, by the tile's address in memory.
pub(super) fn levels_of_all<'a>(
    tiles: impl Iterator<Item = &'a Arc<Tile>>,
) -> HashMap<*const Tile, Vec<Tile>> {
    let differ: HashMap<*const Tile, &Arc<Tile>> =
        tiles.map(|tile| (Arc::as_ptr(tile), tile)).collect();
    let differ: Vec<&Arc<Tile>> = differ.into_values().collect();
    let made: Vec<Vec<Tile>> = differ.par_iter().map(|tile| levels_of(tile)).collect();
    differ.into_iter().map(Arc::as_ptr).zip(made).collect()
}

/// The smaller levels of a tile, half as large each, down to one texel.
pub(super) fn levels_of(tile: &Tile) -> Vec<Tile> {
    let halved = |tile: &Tile| (tile.size() != [1, 1]).then(|| halved(tile));
    std::iter::successors(halved(tile), halved).collect()
}

/// A tile half as large, each texel the mean of the texels that it covers; transparent texels do
/// not tint.
fn halved(tile: &Tile) -> Tile {
    let [width, height] = tile.size();
    let size = [width, height].map(|side| (side / 2).max(1));
    let mut rgba = Vec::with_capacity(4 * size[0] as usize * size[1] as usize);
    let columns: Vec<Vec<(i64, f64)>> = (0..size[0]).map(|x| covered(x, width, size[0])).collect();
    for y in 0..size[1] {
        let rows = covered(y, height, size[1]);
        for columns in &columns {
            let mut sum = [0.0; 4];
            let mut whole = 0.0;
            for &(row, tall) in &rows {
                for &(column, wide) in columns {
                    let [r, g, b, a] = tile.texel(column, row).map(f64::from);
                    let weight = wide * tall;
                    whole += weight;
                    sum[3] += weight * a;
                    for (sum, channel) in sum.iter_mut().zip([r, g, b]) {
                        *sum += weight * a * channel;
                    }
                }
            }
            let opaque = if sum[3] > 0.0 { sum[3] } else { 1.0 };
            rgba.extend(sum[..3].iter().map(|channel| (channel / opaque).round() as u8));
            rgba.push((sum[3] / whole).round() as u8);
        }
    }
    Tile::new(size, rgba).unwrap_or_else(|| Tile::filled(size, [0; 4]))
}

/// The texels of `many` that the texel `index` of `few` covers, each with the share that is
/// covered.
fn covered(index: u32, many: u32, few: u32) -> Vec<(i64, f64)> {
    let wide = f64::from(many) / f64::from(few);
    let (from, to) = (f64::from(index) * wide, f64::from(index + 1) * wide);
    let texels = from.floor() as i64..to.ceil() as i64;
    texels
        .map(|texel| (texel, (to.min(texel as f64 + 1.0) - from.max(texel as f64)).max(0.0)))
        .filter(|(texel, share)| *share > 0.0 && *texel < i64::from(many))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_transparent_does_not_tint_a_smaller_level() {
        let tile = Tile::new([2, 1], vec![200, 100, 50, 255, 0, 0, 0, 0]).unwrap();
        assert_eq!(halved(&tile).bytes(), [200, 100, 50, 128]);
    }

    #[test]
    fn odd_sides_lose_nothing() {
        let tile = Tile::new([3, 1], vec![90, 0, 0, 255, 30, 0, 0, 255, 0, 0, 0, 255]).unwrap();
        assert_eq!(halved(&tile).bytes(), [40, 0, 0, 255]);
    }
}
