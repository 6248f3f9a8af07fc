//! Extent of a tile that ends or repeats, and the record of its changed parts.

use glam::DVec2;

use super::stroke::ChangedRect;

/// Side of the squares by which changed texels are recorded, in texels.
const BLOCK: usize = 32;

/// A part of a row or a column without a seam.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Span {
    /// First texel on the tile.
    pub(super) start: usize,
    /// First texel on the plane of all copies of the tile.
    pub(super) from: i64,
    pub(super) count: usize,
}

/// The extent of a tile.
#[derive(Clone, Copy, Debug)]
pub(super) struct TileExtent {
    pub(super) size: [usize; 2],
    pub(super) wraps: bool,
}

impl TileExtent {
    /// The parts of `from..to` that lie on the tile, along an axis.
    pub(super) fn spans(self, axis: usize, [from, to]: [i64; 2]) -> impl Iterator<Item = Span> {
        let side = self.size[axis] as i64;
        let (mut at, end) = if self.wraps { (from, to) } else { (from.max(0), to.min(side)) };
        std::iter::from_fn(move || {
            let start = at.rem_euclid(side);
            let count = (side - start).min(end - at);
            let span = Span { start: start as usize, from: at, count: count.max(0) as usize };
            at += count;
            (count > 0).then_some(span)
        })
    }

    /// The position on the tile itself, where the tile repeats.
    pub(super) fn on_tile(self, at: DVec2) -> DVec2 {
        let size = DVec2::new(self.size[0] as f64, self.size[1] as f64);
        if self.wraps { at.rem_euclid(size) } else { at }
    }

    /// The texel of the tile for a texel of the plane; for a tile that does not repeat the nearest.
    pub(super) fn nearest(self, axis: usize, at: i64) -> usize {
        let side = self.size[axis] as i64;
        (if self.wraps { at.rem_euclid(side) } else { at.clamp(0, side - 1) }) as usize
    }
}

/// Record of the blocks that changed since the last call of `take`.
#[derive(Clone, Debug)]
pub(super) struct ChangedBlocks {
    size: [usize; 2],
    /// Number of blocks along x and along y.
    count: [usize; 2],
    blocks: Vec<bool>,
    is_any: bool,
}

impl ChangedBlocks {
    pub(super) fn new(size: [usize; 2]) -> Self {
        let count = size.map(|side| side.div_ceil(BLOCK));
        Self { size, count, blocks: vec![false; count[0] * count[1]], is_any: false }
    }

    /// Records that a rectangle may have changed.
    pub(super) fn mark(&mut self, across: Span, down: Span) {
        let blocks = |span: Span| span.start / BLOCK..(span.start + span.count).div_ceil(BLOCK);
        for row in blocks(down) {
            let row = row * self.count[0];
            self.blocks[row..][blocks(across)].fill(true);
        }
        self.is_any = true;
    }

    /// The rectangles that changed, without overlaps. Clears the record.
    pub(super) fn take(&mut self) -> Vec<ChangedRect> {
        let mut changed: Vec<ChangedRect> = Vec::new();
        if !std::mem::take(&mut self.is_any) {
            return changed;
        }
        let [columns, _] = self.count;
        for (row, blocks) in self.blocks.chunks_exact_mut(columns).enumerate() {
            let mut column = 0;
            while column < columns {
                let length = blocks[column..].iter().take_while(|is_dirty| **is_dirty).count();
                if length > 0 {
                    let end = ((column + length) * BLOCK).min(self.size[0]);
                    let bottom = ((row + 1) * BLOCK).min(self.size[1]);
                    let [x, y] = [column * BLOCK, row * BLOCK];
                    let run = [x, y, end - x, bottom - y].map(|texels| texels as u32);
                    // Under a run of the same extent the run extends that rectangle.
                    let is_under = |above: &&mut ChangedRect| {
                        above[0] == run[0] && above[2] == run[2] && above[1] + above[3] == run[1]
                    };
                    match changed.iter_mut().rev().find(is_under) {
                        Some(above) => above[3] += run[3],
                        None => changed.push(run),
                    }
                }
                column += length + 1;
            }
            blocks.fill(false);
        }
        changed
    }
}
