//! The HCBTF that is being painted beside the look.

use std::path::Path;

use super::super::painting::{Work, look};
use super::super::stage::real;
use super::Session;
use crate::diag::Diagnostic;
use crate::document::journal::{Recovered, Slot};
use crate::document::{Hcbtf, HcbtfEdit};
use crate::frame::UNSAVED_HCBTF;

impl Session {
    /// The HCBTF that is being painted, where there is one.
    pub fn painting(&self) -> Option<&Work> {
        self.painting.as_ref()
    }

    /// The same, for programs that drive the window.
    pub fn painting_mut(&mut self) -> Option<&mut Work> {
        self.painting.as_mut()
    }

    /// Paints another one, or none.
    pub(crate) fn set_painting(&mut self, work: Option<Work>) {
        self.keep_painting(work, None);
    }

    /// Takes painting back that a journal gave. The journal goes on where it is.
    pub(crate) fn take_back_painting(&mut self, found: Recovered<Hcbtf>, slot: Slot) {
        self.keep_painting(Some(Work::taken_back(found)), Some(slot));
    }

    fn keep_painting(&mut self, work: Option<Work>, slot: Option<Slot>) {
        self.leave_painting(false);
        self.painting = work;
        if let (Some(work), Some((folder, wake))) = (&mut self.painting, &self.keeps) {
            work.keep_in(folder, wake.clone(), slot);
        }
        self.painting_changed();
        self.problems_number += 1;
    }

    /// Lets go of what is painted; its journal stays if anything in it is not saved.
    pub(super) fn leave_painting(&mut self, in_peace: bool) {
        if let Some(mut work) = self.painting.take() {
            work.leave_journal(in_peace);
        }
    }

    /// Whether putting what is painted aside would lose nothing.
    pub(crate) fn keeps_painting(&mut self) -> bool {
        self.painting.as_mut().is_none_or(Work::keeps_work)
    }

    /// Whether what is painted has changes that no file holds.
    pub(crate) fn is_painting_dirty(&self) -> bool {
        self.painting.as_ref().is_some_and(Work::is_dirty)
    }

    /// The picture may be another now.
    pub(crate) fn painting_changed(&mut self) {
        self.picture += 1;
    }

    /// Applies a change of what is painted. With a `hand`, consecutive changes by it are one step.
    ///
    /// # Errors
    /// A diagnostic where the change is impossible, or nothing is open to be painted; nothing is changed then.
    pub(crate) fn apply_to_painting(&mut self, change: HcbtfEdit, hand: Option<u64>) -> Result<(), Box<Diagnostic>> {
        let Some(work) = &mut self.painting else {
            return Err(Box::new(Diagnostic::error("impossible-edit", "no HCBTF is open")));
        };
        self.now += 1;
        let is_changed = work.apply(change, hand, self.now)?;
        self.painting_changed();
        if is_changed {
            self.gestures.end();
            if let Some(stage) = &mut self.stage {
                stage.end_gesture();
            }
        }
        Ok(())
    }

    /// Saves what is painted to a file, which is its own from then on; the look names that where it named the one that
    /// had no file.
    ///
    /// # Errors
    /// A diagnostic that says why not; the old file is then as it was.
    pub(crate) fn save_painting_as(&mut self, path: &Path) -> Result<(), Box<Diagnostic>> {
        let Some(work) = &mut self.painting else { return Ok(()) };
        let had_no_file = work.path().is_none();
        work.save_as(path)?;
        if had_no_file {
            let path = work.path().map(|path| path.to_string_lossy().into_owned()).unwrap_or_default();
            self.name_painting(&path);
        }
        self.painting_changed();
        Ok(())
    }

    /// Lets the look name the file of what is painted, now that there is one. It is no step: undo would bring a name back
    /// that means nothing any more.
    fn name_painting(&mut self, path: &str) {
        let mut look = self.look().clone();
        let edits = look::rename(&look, &self.catalog, UNSAVED_HCBTF, path);
        let is_renamed = !edits.is_empty();
        for edit in edits {
            if look.apply(edit).is_err() {
                return;
            }
        }
        self.history.amend(look, |edit| look::rename_in(edit, UNSAVED_HCBTF, path));
        if is_renamed && self.path.is_some() {
            self.history.mark_unsaved();
        }
        if self.is_look_dirty() {
            self.begin_journal(None);
        } else {
            self.saved();
        }
        self.meaning += 1;
        self.changed(true);
    }

    /// Takes what another program made of the painted file, as one step that can be undone. Returns whether anything is
    /// another now.
    ///
    /// # Errors
    /// What keeps the file from being read; everything stays as it is then.
    pub(crate) fn reload_painting(&mut self) -> Result<bool, Vec<Diagnostic>> {
        self.now += 1;
        let Some(work) = &mut self.painting else { return Ok(false) };
        let is_other = work.reload(self.now)?;
        self.problems_number += 1;
        if is_other {
            self.painting_changed();
            self.gestures.end();
            if let Some(stage) = &mut self.stage {
                stage.end_gesture();
            }
        }
        Ok(is_other)
    }

    /// Whether the look shows the HCBTF of a file.
    pub(crate) fn shows_painting(&self, path: &Path) -> bool {
        let folder = self.folder();
        let names = look::sheets(self.look(), &self.catalog);
        names.iter().any(|name| !name.is_empty() && real(&folder.join(name)) == real(path))
    }
}
