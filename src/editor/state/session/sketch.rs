//! What is painted on the picture, and the look that was fitted to it and is only shown.

use std::path::PathBuf;
use std::sync::Arc;

use super::Session;
use crate::document::{Look, Tile};
use crate::state::sketch::{Sketch, Standpoint};

/// Of so many looks that were left strokes are kept.
const MOST_ASIDE: usize = 16;

impl Session {
    /// What is painted on the picture.
    pub fn sketch(&self) -> &Sketch {
        &self.sketch
    }

    /// Whether strokes are seen: only then undo takes them back.
    pub(crate) fn open_sketch(&mut self, is_open: bool) {
        self.sketch.is_open = is_open;
    }

    /// Paints on the picture, as a step; no tile for nothing.
    pub(crate) fn paint_sketch(
        &mut self,
        what: &'static str,
        from: Standpoint,
        tile: Option<Tile>,
    ) {
        self.now += 1;
        self.sketch.did(what, from, tile, self.now);
        self.kept.end_gesture();
        if let Some(stage) = &mut self.stage {
            stage.end_gesture();
        }
        if let Some(work) = &mut self.painting {
            work.end_gesture();
        }
    }

    /// Puts the strokes aside, with the look that they are of.
    pub(super) fn leave_sketch(&mut self) {
        let left = std::mem::take(&mut self.sketch);
        self.sketch.is_open = left.is_open;
        if !left.is_empty() {
            let of = self.sketched();
            self.sketches.retain(|(other, _)| *other != of);
            self.sketches.push((of, left.without_past()));
            // The oldest goes: each is a picture of about a megabyte.
            let surplus = self.sketches.len().saturating_sub(MOST_ASIDE);
            self.sketches.drain(..surplus);
        }
    }

    /// Takes the strokes up again that were put aside when this look was left.
    pub(super) fn find_sketch(&mut self) {
        let of = self.sketched();
        if let Some(index) = self.sketches.iter().position(|(other, _)| *other == of) {
            let is_open = self.sketch.is_open;
            self.sketch = self.sketches.remove(index).1;
            self.sketch.is_open = is_open;
        }
    }

    /// Whose strokes they are: those of a file, or of a look that goes by this name.
    fn sketched(&self) -> (Option<PathBuf>, String) {
        let name = if self.path.is_none() { self.look().name.clone() } else { String::new() };
        (self.path.clone(), name)
    }

    /// The look that is shown in place of the open one.
    pub fn preview(&self) -> Option<&Arc<Look>> {
        self.preview.as_ref()
    }

    /// Shows another look in place of the open one, until that is changed; or the open one again.
    /// The document stays as it is.
    pub(crate) fn set_preview(&mut self, look: Option<Arc<Look>>) {
        if look.is_none() && self.preview.is_none() {
            return;
        }
        self.preview = look;
        self.preview_number += 1;
        self.shaders.structure_changed();
        self.picture += 1;
    }

    /// Which look is shown in place of the open one: grows with each, and when it is gone.
    pub(crate) fn preview_number(&self) -> u64 {
        self.preview_number
    }
}
