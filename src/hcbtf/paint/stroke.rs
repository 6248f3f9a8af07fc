//! A stroke of the brush.

use glam::DVec2;

use super::brush::{Brush, Symmetry};
use crate::document::Tile;

/// Texels that changed: `[x, y, width, height]`, inside the tile.
pub type Changed = [u32; 4];

/// A stroke, from where the pen goes down to where it goes up.
#[derive(Clone, Debug)]
pub struct Stroke {
    tile: Tile,
}

impl Stroke {
    /// Begins a stroke over a tile as it is. Where `wraps` the tile repeats, and the stroke goes across its edges.
    pub fn begin(tile: &Tile, brush: &Brush, symmetry: &Symmetry, wraps: bool) -> Self {
        let _ = (brush, symmetry, wraps);
        Self { tile: tile.clone() }
    }

    /// Goes on to a place, in texels from the upper left corner, which may lie outside the tile. Returns what changed.
    pub fn to(&mut self, at: DVec2, pressure: f64) -> Vec<Changed> {
        let _ = (at, pressure);
        Vec::new()
    }

    /// The tile as it looks now.
    pub fn tile(&self) -> &Tile {
        &self.tile
    }

    /// Ends the stroke.
    pub fn finish(self) -> Tile {
        self.tile
    }
}

/// A tile with a straight stroke.
pub fn line(tile: &Tile, brush: &Brush, symmetry: &Symmetry, wraps: bool, from: DVec2, to: DVec2) -> Tile {
    let mut stroke = Stroke::begin(tile, brush, symmetry, wraps);
    stroke.to(from, 1.0);
    stroke.to(to, 1.0);
    stroke.finish()
}
