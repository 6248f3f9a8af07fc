//! Smudging: colors carried along a stroke.

use glam::DVec2;

use super::blend::{premultiplied, straight};
use super::brush::ClampedBrush;
use super::canvas::{ChangedBlocks, Span, TileExtent};
use super::dab::Dab;
use crate::document::Tile;

/// Greatest number of texels that are carried, over all copies of a stroke.
const MOST: usize = 1 << 24;

/// Colors that the brush and its copies carry, and the tile at the same precision.
#[derive(Clone, Debug)]
pub(super) struct Smudge {
    /// Texels of the tile, premultiplied: bytes would lose a little at every stamp.
    work: Vec<[f32; 4]>,
    /// Colors that each copy carries: a square of premultiplied texels around it; empty before the
    /// first stamp.
    carried: Vec<Vec<[f32; 4]>>,
    /// Side of those squares, in texels; odd.
    side: usize,
}

impl Smudge {
    /// A smudge on a tile; `None` if the brush would carry more than allowed.
    pub(super) fn new(tile: &Tile, size: f64, copies: usize) -> Option<Self> {
        let side = 2 * (size / 2.0).ceil() as usize + 3;
        if side * side * copies > MOST {
            return None;
        }
        let (texels, _) = tile.bytes().as_chunks::<4>();
        let work = texels.iter().map(|texel| premultiplied(*texel)).collect();
        Some(Self { work, carried: vec![Vec::new(); copies], side })
    }

    /// Lays the colors that copy number `copy` carries, and takes up those on the tile. The first
    /// stamp only takes up.
    pub(super) fn lay(
        &mut self,
        (copy, at): (usize, DVec2),
        (brush, pressure): (&ClampedBrush, f64),
        canvas: TileExtent,
        tile: &mut Tile,
        dirty: &mut ChangedBlocks,
    ) {
        let corner = at.floor() - (self.side / 2) as f64;
        let corner = [corner.x as i64, corner.y as i64];
        self.take_up(copy, corner, brush.flow, canvas);
        let dab = Dab::new(at.floor() + 0.5, brush.size_at(pressure), brush.hardness);
        let opacity = brush.opacity_at(pressure);
        let (texels, _) = tile.bytes_mut().as_chunks_mut::<4>();
        let (rows, columns) = (dab.rows(), dab.columns());
        for down in canvas.spans(1, rows) {
            for across in canvas.spans(0, columns) {
                dirty.mark(across, down);
                for row in 0..down.count {
                    self.lay_row(
                        copy,
                        corner,
                        (&dab, opacity),
                        [across, down],
                        row,
                        texels,
                        canvas.size[0],
                    );
                }
            }
        }
    }

    #[allow(clippy::too_many_arguments, reason = "the innermost loop of one caller")]
    fn lay_row(
        &mut self,
        copy: usize,
        corner: [i64; 2],
        (dab, opacity): (&Dab, f64),
        [across, down]: [Span; 2],
        row: usize,
        texels: &mut [[u8; 4]],
        width: usize,
    ) {
        let y = down.from + row as i64;
        let carried_row = (y - corner[1]) as usize * self.side;
        for column in 0..across.count {
            let x = across.from + column as i64;
            let part = (dab.cover(x, y) * opacity) as f32;
            if part > 0.0 {
                let index = (down.start + row) * width + across.start + column;
                let carried = self.carried[copy][carried_row + (x - corner[0]) as usize];
                let work = &mut self.work[index];
                *work = std::array::from_fn(|channel| {
                    work[channel] + (carried[channel] - work[channel]) * part
                });
                texels[index] = straight(*work, texels[index]);
            }
        }
    }

    /// Mixes the colors under the brush into those that it carries. Beyond the edges of a tile that
    /// does not repeat lie its outermost texels.
    fn take_up(&mut self, copy: usize, corner: [i64; 2], kept: f64, canvas: TileExtent) {
        let (side, kept) = (self.side, kept as f32);
        let is_first = self.carried[copy].is_empty();
        if is_first {
            self.carried[copy] = vec![[0.0; 4]; side * side];
        }
        let columns: Vec<usize> =
            (0..side).map(|column| canvas.nearest(0, corner[0] + column as i64)).collect();
        for (row, carried) in self.carried[copy].chunks_exact_mut(side).enumerate() {
            let y = canvas.nearest(1, corner[1] + row as i64) * canvas.size[0];
            for (column, carried) in columns.iter().zip(carried) {
                let under = self.work[y + column];
                *carried = if is_first {
                    under
                } else {
                    std::array::from_fn(|channel| {
                        under[channel] + (carried[channel] - under[channel]) * kept
                    })
                };
            }
        }
    }
}
