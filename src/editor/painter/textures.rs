//! Tiles as textures of the window, with crisp texels. Of a stroke, only the changed part is
//! uploaded to the GPU.

use std::sync::Arc;

use eframe::egui::{ColorImage, Context, TextureHandle, TextureId, TextureOptions};

use crate::document::Tile;

/// Texture of one tile, and the tile that it shows.
#[derive(Default)]
pub(super) struct TileTexture {
    handle: Option<TextureHandle>,
    tile: Option<Arc<Tile>>,
}

impl TileTexture {
    /// Texture of `tile`, brought up to date.
    pub(super) fn of(&mut self, ctx: &Context, name: &str, tile: &Arc<Tile>) -> TextureId {
        let is_it = self.tile.as_ref().is_some_and(|shown| Arc::ptr_eq(shown, tile));
        match &mut self.handle {
            Some(handle) if is_it => handle.id(),
            Some(handle) => {
                match self.tile.as_ref().filter(|before| before.size() == tile.size()) {
                    Some(before) => {
                        if let Some(changed) = tile.difference(before) {
                            let [x, y, ..] = changed.map(|side| side as usize);
                            handle.set_partial([x, y], part(tile, changed), options());
                        }
                    }
                    None => handle.set(image(tile), options()),
                }
                self.tile = Some(tile.clone());
                handle.id()
            }
            None => {
                let handle = ctx.load_texture(name, image(tile), options());
                let id = handle.id();
                (self.handle, self.tile) = (Some(handle), Some(tile.clone()));
                id
            }
        }
    }
}

/// Image of a tile for the window.
pub(super) fn image(tile: &Tile) -> ColorImage {
    ColorImage::from_rgba_unmultiplied(tile.size().map(|side| side as usize), tile.bytes())
}

/// Image of a rectangle of a tile for the window.
fn part(tile: &Tile, [x, y, width, height]: [u32; 4]) -> ColorImage {
    let [x, y, width, height] = [x, y, width, height].map(|side| side as usize);
    let stride = 4 * tile.size()[0] as usize;
    let rows = tile.bytes().chunks_exact(stride).skip(y).take(height);
    let bytes: Vec<u8> = rows.flat_map(|row| &row[4 * x..4 * (x + width)]).copied().collect();
    ColorImage::from_rgba_unmultiplied([width, height], &bytes)
}

/// Texture options without blur between magnified texels.
pub(super) fn options() -> TextureOptions {
    TextureOptions { minification: eframe::egui::TextureFilter::Linear, ..TextureOptions::NEAREST }
}
