//! Thumbnails of all samples in one texture.

use std::collections::HashMap;
use std::sync::Arc;

use eframe::egui::{
    Color32, ColorImage, Context, Painter, Pos2, Rect, TextureHandle, TextureOptions, pos2,
};

use crate::document::{Address, Tile};
use crate::state::painting::work::OpenPainting;
use crate::state::revision::PaintingRevision;
use crate::widgets::rows::fitted;

/// Side of a thumbnail, in texels.
const SIDE: usize = 16;
/// Number of thumbnails in a row of the texture.
const COLUMNS: usize = 64;
/// Largest number of samples that have thumbnails.
const MOST: usize = COLUMNS * 128;
/// Number of new tiles above which the whole texture is made anew.
const MOST_NEW: usize = 64;

/// Thumbnails of samples, each tile once.
#[derive(Default)]
pub(super) struct Atlas {
    slots: HashMap<*const Tile, usize>,
    /// Tiles that the pointers above lead to, held so that the pointers stay valid. `None` where a
    /// slot is free.
    tiles: Vec<Option<Arc<Tile>>>,
    texture: Option<TextureHandle>,
    revision: PaintingRevision,
}

impl Atlas {
    /// Brings the thumbnails up to date; a stroke under way is shown once it is done.
    pub(super) fn update(&mut self, ctx: &Context, work: &OpenPainting, is_painting: bool) {
        if self.revision == work.revision() || is_painting {
            return;
        }
        self.revision = work.revision();
        let mut shown: HashMap<*const Tile, &Arc<Tile>> = HashMap::new();
        for tile in work.grid().addresses().take(MOST).filter_map(|address| work.tile(address)) {
            shown.insert(Arc::as_ptr(tile), tile);
        }
        self.slots.retain(|tile, slot| {
            let is_shown = shown.remove(tile).is_some();
            if !is_shown {
                self.tiles[*slot] = None;
            }
            is_shown
        });
        let capacity =
            self.texture.as_ref().map_or(0, |texture| texture.size()[1] / SIDE * COLUMNS);
        if shown.len() > MOST_NEW || self.slots.len() + shown.len() > capacity {
            return self.make(ctx, work);
        }
        let mut free = 0;
        for tile in shown.into_values() {
            while self.tiles.get(free).is_some_and(Option::is_some) {
                free += 1;
            }
            self.slots.insert(Arc::as_ptr(tile), free);
            self.tiles.resize(self.tiles.len().max(free + 1), None);
            self.tiles[free] = Some(tile.clone());
            if let Some(texture) = &mut self.texture {
                let at = [free % COLUMNS * SIDE, free / COLUMNS * SIDE];
                texture.set_partial(
                    at,
                    ColorImage::new([SIDE, SIDE], small(tile)),
                    TextureOptions::LINEAR,
                );
            }
        }
    }

    /// Makes all thumbnails anew, in the order in which their tiles first occur.
    fn make(&mut self, ctx: &Context, work: &OpenPainting) {
        self.slots.clear();
        self.tiles.clear();
        for tile in work.grid().addresses().take(MOST).filter_map(|address| work.tile(address)) {
            let next = self.tiles.len();
            let slot = *self.slots.entry(Arc::as_ptr(tile)).or_insert(next);
            if slot == next {
                self.tiles.push(Some(tile.clone()));
            }
        }
        // One row more than needed leaves room for later strokes.
        let rows = self.tiles.len() / COLUMNS + 1;
        let size = [COLUMNS * SIDE, rows * SIDE];
        let mut pixels = vec![Color32::TRANSPARENT; size[0] * size[1]];
        for (slot, tile) in
            self.tiles.iter().enumerate().filter_map(|(slot, tile)| Some((slot, tile.as_ref()?)))
        {
            let from = (slot / COLUMNS) * SIDE * size[0] + (slot % COLUMNS) * SIDE;
            for (y, row) in small(tile).chunks_exact(SIDE).enumerate() {
                pixels[from + y * size[0]..][..SIDE].copy_from_slice(row);
            }
        }
        let image = ColorImage::new(size, pixels);
        match &mut self.texture {
            Some(texture) => texture.set(image, TextureOptions::LINEAR),
            None => self.texture = Some(ctx.load_texture("samples", image, TextureOptions::LINEAR)),
        }
    }

    /// Paints the thumbnail of a sample, in the shape that the tile has. Returns false if the
    /// sample has no thumbnail.
    pub(super) fn paint(
        &self,
        painter: &Painter,
        work: &OpenPainting,
        address: Address,
        rect: Rect,
    ) -> bool {
        let Some(texture) = &self.texture else { return false };
        let Some(slot) = work.tile(address).and_then(|tile| self.slots.get(&Arc::as_ptr(tile)))
        else {
            return false;
        };
        let [width, height] = texture.size().map(|side| side as f32);
        let from = pos2((slot % COLUMNS * SIDE) as f32, (slot / COLUMNS * SIDE) as f32);
        // The rectangle is inset by half a texel, so that neighboring thumbnails do not bleed in.
        let uv = |at: Pos2| pos2(at.x / width, at.y / height);
        let uv = Rect::from_min_max(
            uv(from + eframe::egui::vec2(0.5, 0.5)),
            uv(from + eframe::egui::Vec2::splat(SIDE as f32 - 0.5)),
        );
        painter.image(texture.id(), fitted(rect, work.grid().size), uv, Color32::WHITE);
        true
    }
}

/// Thumbnail of a tile, row by row.
fn small(tile: &Tile) -> Vec<Color32> {
    (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| sampled(tile, x, y))).collect()
}

/// Texel in the middle of the part of a tile that one texel of the thumbnail covers.
fn sampled(tile: &Tile, x: usize, y: usize) -> Color32 {
    let at = |place: usize, side: u32| (place as i64 * 2 + 1) * i64::from(side) / (2 * SIDE as i64);
    let [r, g, b, a] = tile.texel(at(x, tile.size()[0]), at(y, tile.size()[1]));
    Color32::from_rgba_unmultiplied(r, g, b, a)
}
