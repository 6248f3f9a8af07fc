//! Scaffold.

use super::Color;
use crate::document::{Address, Grid, Strokes};
use crate::hcbtf::Progress;

/// Ready to give tiles.
pub(in crate::hcbtf) struct Ready {
    grid: Grid,
}

impl Ready {
    pub(super) fn new(_: &Strokes, grid: &Grid, _is_tiling: bool, _: &Progress) -> Option<Self> {
        Some(Self { grid: *grid })
    }

    pub(super) fn tile(&self, _: Address, _: &Progress) -> Option<Vec<Color>> {
        Some(vec![[0.0; 4]; self.grid.texels()])
    }
}
