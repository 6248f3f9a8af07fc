//! Flood fill of connected texels.

use super::canvas::TileExtent;
use super::rim;
use crate::document::Tile;

/// Options of a flood fill.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flood {
    /// Greatest difference of any channel from that of the first texel, as a share of its range,
    /// from 0 to 1.
    pub tolerance: f64,
    /// Number of texels by which the fill goes on under soft edges; 0 ends it where the tolerance
    /// does.
    pub edge: u32,
    /// True if the tile's opposite edges are neighbors.
    pub wraps: bool,
}

impl Flood {
    /// Default of `edge`, in texels: hard brushes of any usual size have no wider edges.
    pub const EDGE: u32 = 4;
}

/// The tile with another color in the texels that are like the one at `[x, y]`, and connected to it
/// along sides through such texels.
///
/// Wholly transparent texels are alike whatever their hidden color is. At soft edges a texel is a
/// mix of the old color and of the color beyond: there the new color takes the old one's share. A
/// place outside the tile, or a tolerance that is not a number, fills nothing.
pub fn fill(tile: &Tile, at: [u32; 2], color: [u8; 4], flood: Flood) -> Tile {
    let Flood { tolerance, edge, wraps } = flood;
    let mut filled = tile.clone();
    let [width, height] = tile.size().map(|side| side as usize);
    let [x, y] = at.map(|place| place as usize);
    if x >= width || y >= height || tolerance.is_nan() {
        return filled;
    }
    let (texels, _) = tile.bytes().as_chunks::<4>();
    let first = texels[y * width + x];
    let most = tolerance.max(0.0) * 255.0;
    let is_like = |texel: [u8; 4]| is_like(first, texel, most);
    let canvas = TileExtent { size: [width, height], wraps };
    let (after, _) = filled.bytes_mut().as_chunks_mut::<4>();
    let mut is_done = vec![false; texels.len()];
    let mut seeds = vec![(x, y)];
    while let Some((x, y)) = seeds.pop() {
        let row = y * width;
        let mut take = |x: usize| {
            let index = row + x;
            let is_new = !is_done[index] && is_like(texels[index]);
            if is_new {
                is_done[index] = true;
                after[index] = color;
            }
            is_new
        };
        if !take(x) {
            continue;
        }
        // The run to both sides, first as if the row did not end.
        let (mut left, mut right) = (x as i64, x as i64);
        while (wraps || left > 0) && take(canvas.nearest(0, left - 1)) {
            left -= 1;
        }
        while (wraps || right + 1 < width as i64) && take(canvas.nearest(0, right + 1)) {
            right += 1;
        }
        for other in [y as i64 - 1, y as i64 + 1] {
            if !wraps && !(0..height as i64).contains(&other) {
                continue;
            }
            let other = canvas.nearest(1, other);
            // One seed for each run of the neighboring row.
            let mut was_open = false;
            for x in left..=right {
                let x = canvas.nearest(0, x);
                let index = other * width + x;
                let is_open = !is_done[index] && is_like(texels[index]);
                if is_open && !was_open {
                    seeds.push((x, other));
                }
                was_open = is_open;
            }
        }
    }
    rim::recolor(texels, &rim::FillEdge { first, color, width: edge, canvas }, &is_done, after);
    filled
}

/// True if no channel differs by more than `most`.
fn is_like(first: [u8; 4], texel: [u8; 4], most: f64) -> bool {
    let are_clear = first[3] == 0 && texel[3] == 0;
    are_clear || first.iter().zip(texel).all(|(a, b)| f64::from(a.abs_diff(b)) <= most)
}
