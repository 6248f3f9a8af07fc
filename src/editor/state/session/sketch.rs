//! What is painted on the picture, and the look that was fitted to it and is only shown.

use std::path::PathBuf;
use std::sync::Arc;

use super::Session;
use crate::document::{Look, Tile};
use crate::state::revision::PreviewRevision;
use crate::state::sketch::{Sketch, Standpoint};

/// Of so many looks that were left strokes are kept.
const MOST_ASIDE: usize = 16;

impl Session {
    /// What is painted on the picture.
    pub fn sketch(&self) -> &Sketch {
        &self.sketchbook.sketch
    }

    /// Whether strokes are seen: only then undo takes them back.
    pub(crate) fn open_sketch(&mut self, is_open: bool) {
        self.sketchbook.sketch.is_open = is_open;
    }

    /// Paints on the picture, as a step; no tile for nothing.
    pub(crate) fn paint_sketch(
        &mut self,
        what: &'static str,
        from: Standpoint,
        tile: Option<Tile>,
    ) {
        self.revisions.step += 1;
        self.sketchbook.sketch.did(what, from, tile, self.revisions.step);
        self.look.end_gesture();
        if let Some(stage) = &mut self.stage {
            stage.end_gesture();
        }
        if let Some(work) = &mut self.painting {
            work.end_gesture();
        }
    }

    /// Puts the strokes aside, with the look that they are of.
    pub(super) fn leave_sketch(&mut self) {
        let left = std::mem::take(&mut self.sketchbook.sketch);
        self.sketchbook.sketch.is_open = left.is_open;
        if !left.is_empty() {
            let of = self.sketched();
            self.sketchbook.aside.retain(|(other, _)| *other != of);
            self.sketchbook.aside.push((of, left.without_past()));
            // The oldest goes: each is a picture of about a megabyte.
            let surplus = self.sketchbook.aside.len().saturating_sub(MOST_ASIDE);
            self.sketchbook.aside.drain(..surplus);
        }
    }

    /// Takes the strokes up again that were put aside when this look was left.
    pub(super) fn find_sketch(&mut self) {
        let of = self.sketched();
        if let Some(index) = self.sketchbook.aside.iter().position(|(other, _)| *other == of) {
            let is_open = self.sketchbook.sketch.is_open;
            self.sketchbook.sketch = self.sketchbook.aside.remove(index).1;
            self.sketchbook.sketch.is_open = is_open;
        }
    }

    /// Whose strokes they are: those of a file, or of a look that goes by this name.
    fn sketched(&self) -> (Option<PathBuf>, String) {
        let name = if self.look.path.is_none() { self.look().name.clone() } else { String::new() };
        (self.look.path.clone(), name)
    }

    /// The look that is shown in place of the open one.
    pub fn preview(&self) -> Option<&Arc<Look>> {
        self.sketchbook.preview.as_ref()
    }

    /// Shows another look in place of the open one, until that is changed; or the open one again.
    /// The document stays as it is.
    pub(crate) fn set_preview(&mut self, look: Option<Arc<Look>>) {
        if look.is_none() && self.sketchbook.preview.is_none() {
            return;
        }
        self.sketchbook.preview = look;
        self.sketchbook.preview_revision.advance();
        self.compilation.shaders.structure_changed();
        self.revisions.picture.advance();
    }

    /// Which look is shown in place of the open one: grows with each, and when it is gone.
    pub(crate) fn preview_revision(&self) -> PreviewRevision {
        self.sketchbook.preview_revision
    }
}
