//! Sketch on the picture, and the look that was fitted to it and is only shown.

use std::sync::Arc;

use super::Session;
use crate::document::{Look, Tile};
use crate::state::sketch::Standpoint;

impl Session {
    /// Replaces the sketch, as a step; `None` clears it.
    pub(crate) fn paint_sketch(
        &mut self,
        what: &'static str,
        from: Standpoint,
        tile: Option<Tile>,
    ) {
        self.revisions.step.advance();
        self.sketchbook.sketch.did(what, from, tile, self.revisions.step);
        self.look.end_gesture();
        if let Some(open_scene) = &mut self.open_scene {
            open_scene.end_gesture();
        }
        if let Some(work) = &mut self.painting {
            work.end_gesture();
        }
    }

    /// Shows another look in place of the open one, until the latter is changed; `None` shows the
    /// open one again. The document is unchanged.
    pub(crate) fn set_preview(&mut self, look: Option<Arc<Look>>) {
        if look.is_none() && self.sketchbook.preview.is_none() {
            return;
        }
        self.sketchbook.preview = look;
        self.sketchbook.preview_revision.advance();
        self.compilation.shaders.structure_changed();
        self.revisions.picture.advance();
    }
}
