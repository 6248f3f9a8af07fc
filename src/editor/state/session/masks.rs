//! Masks that are painted on the mesh.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::Session;
use crate::diag::Diagnostic;
use crate::files::write_atomic;
use crate::ids::NodeId;
use crate::state::masks::{MaskPicture, MaskStep, file_of};

impl Session {
    /// File of a layer's painted mask; `None` where the layer has none, or the look no file.
    pub(crate) fn mask_file(&self, layer: &NodeId) -> Option<PathBuf> {
        self.path()?;
        file_of(self.look(), layer).map(|name| self.look.folder().join(name))
    }

    /// Writes what a step made of a mask, and notes the step.
    ///
    /// # Errors
    /// A diagnostic that names the file; nothing is changed then.
    pub(crate) fn paint_mask(&mut self, step: MaskStep) -> Result<(), Box<Diagnostic>> {
        self.write_mask(&step.file, &step.after)?;
        self.revisions.step.advance();
        self.masks.did(step, self.revisions.step);
        self.look.end_gesture();
        if let Some(open_scene) = &mut self.open_scene {
            open_scene.end_gesture();
        }
        Ok(())
    }

    /// Writes a mask, and draws again with it.
    ///
    /// # Errors
    /// A diagnostic that names the file; the old file is then as it was.
    pub(crate) fn write_mask(
        &mut self,
        file: &Path,
        mask: &MaskPicture,
    ) -> Result<(), Box<Diagnostic>> {
        write_atomic(file, &mask.to_png().map_err(Box::new)?)?;
        self.files_changed();
        Ok(())
    }

    /// Writes what undo or redo made of a mask. A mask that cannot be written is told as a problem
    /// of the picture.
    pub(super) fn bring_mask_back(&mut self, found: Option<(PathBuf, Arc<MaskPicture>)>) -> bool {
        let Some((file, mask)) = found else { return false };
        match self.write_mask(&file, &mask) {
            Ok(()) => true,
            Err(problem) => {
                self.picture_problems.push(*problem);
                self.revisions.problems.advance();
                false
            }
        }
    }
}
