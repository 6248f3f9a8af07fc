//! Small pictures of all samples in one texture.

use std::collections::HashMap;
use std::sync::Arc;

use eframe::egui::{Color32, ColorImage, Context, Painter, Pos2, Rect, TextureHandle, TextureOptions, pos2};

use super::work::Work;
use crate::document::{Address, Tile};

/// The side of a small picture, in texels.
const SIDE: usize = 16;
/// Small pictures in a row of the texture.
const COLUMNS: usize = 64;
/// More samples than these have none.
const MOST: usize = COLUMNS * 128;

/// Small pictures, each tile once.
#[derive(Default)]
pub(super) struct Atlas {
    slots: HashMap<*const Tile, usize>,
    /// What the pointers above lead to, for as long as they are known.
    tiles: Vec<Arc<Tile>>,
    texture: Option<TextureHandle>,
    version: u64,
}

impl Atlas {
    /// Brings the pictures up to date. Work in progress is shown once it is done.
    pub(super) fn update(&mut self, ctx: &Context, work: &Work, is_painting: bool) {
        if self.version == work.version() || is_painting {
            return;
        }
        self.version = work.version();
        self.slots.clear();
        self.tiles.clear();
        for tile in work.grid().addresses().take(MOST).filter_map(|address| work.tile(address)) {
            let next = self.tiles.len();
            let slot = *self.slots.entry(Arc::as_ptr(tile)).or_insert(next);
            if slot == next {
                self.tiles.push(tile.clone());
            }
        }
        if self.tiles.is_empty() {
            return;
        }
        let rows = self.tiles.len().div_ceil(COLUMNS);
        let size = [COLUMNS * SIDE, rows * SIDE];
        let mut pixels = vec![Color32::TRANSPARENT; size[0] * size[1]];
        for (slot, tile) in self.tiles.iter().enumerate() {
            let from = (slot / COLUMNS) * SIDE * size[0] + (slot % COLUMNS) * SIDE;
            for y in 0..SIDE {
                for x in 0..SIDE {
                    pixels[from + y * size[0] + x] = sampled(tile, x, y);
                }
            }
        }
        let image = ColorImage::new(size, pixels);
        match &mut self.texture {
            Some(texture) => texture.set(image, TextureOptions::LINEAR),
            None => self.texture = Some(ctx.load_texture("samples", image, TextureOptions::LINEAR)),
        }
    }

    /// Paints the small picture of a sample, if there is one.
    pub(super) fn paint(&self, painter: &Painter, work: &Work, address: Address, rect: Rect) -> bool {
        let Some(texture) = &self.texture else { return false };
        let Some(slot) = work.tile(address).and_then(|tile| self.slots.get(&Arc::as_ptr(tile))) else { return false };
        let [width, height] = texture.size().map(|side| side as f32);
        let from = pos2((slot % COLUMNS * SIDE) as f32, (slot / COLUMNS * SIDE) as f32);
        // Half a texel inside, so that neighbours do not shine in.
        let uv = |at: Pos2| pos2(at.x / width, at.y / height);
        let uv = Rect::from_min_max(
            uv(from + eframe::egui::vec2(0.5, 0.5)),
            uv(from + eframe::egui::Vec2::splat(SIDE as f32 - 0.5)),
        );
        painter.image(texture.id(), rect, uv, Color32::WHITE);
        true
    }
}

/// The texel in the middle of a part of a tile.
fn sampled(tile: &Tile, x: usize, y: usize) -> Color32 {
    let at = |place: usize, side: u32| (place as i64 * 2 + 1) * i64::from(side) / (2 * SIDE as i64);
    let [r, g, b, a] = tile.texel(at(x, tile.size()[0]), at(y, tile.size()[1]));
    Color32::from_rgba_unmultiplied(r, g, b, a)
}
