//! The brush: strokes, lines, floods and picked colors on one tile.
//!
//! Every function takes a [`Tile`] and gives one; this module knows of no windows, documents or
//! time, and equal calls give equal bytes on every machine's floating point of IEEE 754. Lengths
//! are in texels, x to the right and y downward, the middle of the first texel at (0.5, 0.5).

mod blend;
mod brush;
mod canvas;
mod dab;
mod flood;
mod path;
mod picture;
mod rim;
mod smudge;
mod stroke;
mod symmetry;
#[cfg(test)]
mod tests;

use crate::document::Tile;

pub use brush::{Brush, Pressure, Symmetry, Tool};
pub use flood::{Flood, fill};
pub use stroke::{ChangedRect, Stroke, line};

/// The color of the texel at `[x, y]`, straight RGBA; beyond the tile that of the nearest texel.
pub fn pick(tile: &Tile, at: [u32; 2]) -> [u8; 4] {
    let [width, height] = tile.size();
    tile.texel(i64::from(at[0].min(width - 1)), i64::from(at[1].min(height - 1)))
}
