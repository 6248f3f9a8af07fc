//! Sketch on the picture, and the look that was fitted to it and is only shown.

use std::path::PathBuf;
use std::sync::Arc;

use super::Session;
use crate::document::{Look, Tile};
use crate::state::revision::PreviewRevision;
use crate::state::sketch::{Sketch, Standpoint};

/// Largest number of looks that were left whose sketches are kept.
const MOST_ASIDE: usize = 16;

impl Session {
    /// The sketch on the picture.
    pub fn sketch(&self) -> &Sketch {
        &self.sketchbook.sketch
    }

    /// Shows or hides the strokes: undo takes them back only while they are seen.
    pub(crate) fn open_sketch(&mut self, is_open: bool) {
        self.sketchbook.sketch.is_open = is_open;
    }

    /// Replaces the sketch, as a step; `None` clears it.
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

    /// Puts the sketch aside, with the look that it is of.
    pub(super) fn leave_sketch(&mut self) {
        let left = std::mem::take(&mut self.sketchbook.sketch);
        self.sketchbook.sketch.is_open = left.is_open;
        if !left.is_empty() {
            let of = self.sketched();
            self.sketchbook.aside.retain(|(other, _)| *other != of);
            self.sketchbook.aside.push((of, left.without_past()));
            // The oldest sketch is dropped: each is a picture of about a megabyte.
            let surplus = self.sketchbook.aside.len().saturating_sub(MOST_ASIDE);
            self.sketchbook.aside.drain(..surplus);
        }
    }

    /// Restores the sketch that was put aside when this look was left.
    pub(super) fn find_sketch(&mut self) {
        let of = self.sketched();
        if let Some(index) = self.sketchbook.aside.iter().position(|(other, _)| *other == of) {
            let is_open = self.sketchbook.sketch.is_open;
            self.sketchbook.sketch = self.sketchbook.aside.remove(index).1;
            self.sketchbook.sketch.is_open = is_open;
        }
    }

    /// Key of the look that a sketch is of: its file, or its name without one.
    fn sketched(&self) -> (Option<PathBuf>, String) {
        let name = if self.look.path.is_none() { self.look().name.clone() } else { String::new() };
        (self.look.path.clone(), name)
    }

    /// The look that is shown in place of the open one.
    pub fn preview(&self) -> Option<&Arc<Look>> {
        self.sketchbook.preview.as_ref()
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

    /// Revision of the preview, which grows with each look shown, and when none is any more.
    pub(crate) fn preview_revision(&self) -> PreviewRevision {
        self.sketchbook.preview_revision
    }
}
