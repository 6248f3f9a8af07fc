//! Snapshots of the open look: taken, restored, and kept beside its file or in its journal.

use std::path::Path;

use chiaro_locale::tr;

use super::{NEW_NAME, Session};
use crate::clock;
use crate::diag::Diagnostic;
use crate::document::{Edit, Look};
use crate::import::anchor_images;
use crate::state::shelf::{SnapshotId, SnapshotShelf};

/// Name of the snapshots among what a journal keeps for the window.
pub(super) const IN_JOURNAL: &str = "snapshots";

impl Session {
    /// Snapshots of the open look.
    pub(crate) fn shelf(&self) -> &SnapshotShelf {
        &self.shelf
    }

    /// Takes a snapshot of the look as it is. Gives its name.
    ///
    /// # Errors
    /// A diagnostic where there is no room for one more.
    pub(crate) fn take_snapshot(&mut self) -> Result<String, Box<Diagnostic>> {
        let taken = clock::age(std::time::SystemTime::UNIX_EPOCH).as_secs();
        let now = self.revisions.step.next();
        let name = self.shelf.take(self.look.document(), taken, now)?.name.clone();
        self.shelf_step_done();
        Ok(name)
    }

    /// Gives a snapshot another name.
    ///
    /// # Errors
    /// A diagnostic where there is no such snapshot.
    pub(crate) fn rename_snapshot(
        &mut self,
        id: SnapshotId,
        name: &str,
    ) -> Result<(), Box<Diagnostic>> {
        let now = self.revisions.step.next();
        self.shelf.rename(id, name, now)?;
        self.shelf_step_done();
        Ok(())
    }

    /// Deletes a snapshot.
    ///
    /// # Errors
    /// A diagnostic where there is no such snapshot.
    pub(crate) fn delete_snapshot(&mut self, id: SnapshotId) -> Result<(), Box<Diagnostic>> {
        let now = self.revisions.step.next();
        self.shelf.delete(id, now)?;
        self.shelf_step_done();
        Ok(())
    }

    /// Makes the look what it was in a snapshot, as one step.
    ///
    /// # Errors
    /// A diagnostic where there is no such snapshot, or where a shot is open, which changes values
    /// alone.
    pub(crate) fn restore_snapshot(&mut self, id: SnapshotId) -> Result<(), Box<Diagnostic>> {
        let gone = || Diagnostic::error("no-snapshot", tr!("that snapshot is not there any more"));
        let snapshot = self.shelf.of(id).ok_or_else(|| Box::new(gone()))?;
        let label = tr!("restore {snapshot}", snapshot = snapshot.name);
        let look = Box::new((*snapshot.look).clone());
        if *look == *self.look() {
            return Ok(());
        }
        self.apply(Edit::Replace { look }, None)?;
        if let Some(time) = self.look.times.last() {
            self.named_steps.insert(time, label);
        }
        Ok(())
    }

    /// Text of a new look with what a snapshot holds, and its name; images have whole paths, as a
    /// new look has no folder.
    pub(crate) fn copy_of_snapshot(&self, id: SnapshotId) -> Option<(String, String)> {
        let snapshot = self.shelf.of(id)?;
        let mut look: Look = (*snapshot.look).clone();
        if let Some(folder) = self
            .path()
            .and_then(|path| std::path::absolute(path).ok()?.parent().map(Path::to_owned))
        {
            anchor_images(&mut look, &folder);
        }
        let of =
            if look.name.is_empty() { self.name_or(NEW_NAME.english()) } else { look.name.clone() };
        look.name = format!("{of}, {}", snapshot.name);
        Some((look.to_text(), look.name))
    }

    fn shelf_step_done(&mut self) {
        self.revisions.step.advance();
        self.look.end_gesture();
        if let Some(open_scene) = &mut self.open_scene {
            open_scene.end_gesture();
        }
        if let Some(work) = &mut self.painting {
            work.end_gesture();
        }
        self.keep_shelf();
    }

    /// Writes the snapshots beside the look, or hands them to its journal before there is a file.
    pub(super) fn keep_shelf(&mut self) {
        match self.look.path.clone() {
            Some(path) => self.shelf.write_beside(&path),
            None => self.begin_journal(None),
        }
    }

    /// Opens the snapshots of the look that has come.
    pub(super) fn open_shelf(&mut self) {
        self.shelf = SnapshotShelf::beside(self.look.path.as_deref(), &self.shelf);
    }

    /// Takes the snapshots of a look without a file from what its journal kept.
    pub(super) fn take_back_shelf(&mut self, window: &serde_json::Value) {
        if let Some(kept) = window.get(IN_JOURNAL).filter(|_| self.look.path.is_none()) {
            self.shelf = SnapshotShelf::from_json(kept, &self.shelf);
        }
    }

    /// Snapshots for the journal of a look without a file.
    pub(super) fn shelf_for_journal(&self) -> Option<serde_json::Value> {
        (self.look.path.is_none() && !self.shelf.is_empty()).then(|| self.shelf.to_json())
    }
}
