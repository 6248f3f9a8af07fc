//! Tiles as textures of the window: each texel crisp.

use std::sync::Arc;

use eframe::egui::{ColorImage, Context, TextureHandle, TextureId, TextureOptions};

use crate::document::Tile;

/// One tile's texture, and the tile that it shows.
#[derive(Default)]
pub(super) struct Shown {
    handle: Option<TextureHandle>,
    tile: Option<Arc<Tile>>,
}

impl Shown {
    /// The texture, brought up to date.
    pub(super) fn of(&mut self, ctx: &Context, name: &str, tile: &Arc<Tile>) -> TextureId {
        let is_it = self.tile.as_ref().is_some_and(|shown| Arc::ptr_eq(shown, tile));
        match &mut self.handle {
            Some(handle) if is_it => handle.id(),
            Some(handle) => {
                handle.set(image(tile), options());
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

/// A tile as an image of the window.
pub(super) fn image(tile: &Tile) -> ColorImage {
    ColorImage::from_rgba_unmultiplied(tile.size().map(|side| side as usize), tile.bytes())
}

/// No blur between texels.
pub(super) fn options() -> TextureOptions {
    TextureOptions { minification: eframe::egui::TextureFilter::Linear, ..TextureOptions::NEAREST }
}
