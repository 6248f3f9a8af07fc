//! Journal of unsaved painting, as looks and scenes have theirs.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde_json::json;

use super::work::{FileStamp, OpenPainting};
use crate::diag::Diagnostic;
use crate::document::Hcbtf;
use crate::files::journal::{DocumentInfo, JournalSlot, RecoveredWork};

/// Member of a journal for the stamp of the file when it was last read or written.
const FILE: &str = "file";

impl OpenPainting {
    /// The painting that a journal gave; the journal goes on in its slot, once it is kept in a
    /// folder.
    pub(crate) fn taken_back(found: RecoveredWork<Hcbtf>) -> Self {
        let mut work = Self::of_history(found.history, found.about.path.map(PathBuf::from));
        if work.path().is_none() {
            work.set_title(&found.about.name);
        }
        // Changes that others made to the file since are noticed as if the window had stayed open.
        if let Some(stamp) = found.about.window.get(FILE).and_then(FileStamp::of_json) {
            work.document.file = Some(stamp);
        }
        work.document.load_problems = found.damage;
        work
    }

    /// Keeps a journal in a folder from now on, in `slot` if the painting was taken back from
    /// there. `wake` is called from another thread when the journal cannot be written, or can
    /// again.
    pub(crate) fn keep_in(
        &mut self,
        folder: &Path,
        wake: Arc<dyn Fn() + Send + Sync>,
        slot: Option<JournalSlot>,
    ) {
        self.document.journal.keep_in(folder, move || wake());
        if slot.is_some() || self.is_dirty() {
            self.begin_journal(slot);
        }
    }

    /// Hands the edits since the last call to the journal; a gesture that goes on may wait for a
    /// moment there.
    pub(crate) fn commit(&mut self, goes_on: bool) {
        if self.document.commit(goes_on) {
            self.begin_journal(None);
        }
    }

    fn begin_journal(&mut self, slot: Option<JournalSlot>) {
        let about = DocumentInfo {
            name: self.kept_name(),
            path: self.path().and_then(Path::to_str).map(str::to_owned),
            is_partial: false,
            window: self
                .document
                .file
                .and_then(FileStamp::to_json)
                .map_or_else(|| json!({}), |stamp| json!({ FILE: stamp })),
        };
        self.document.begin_journal(about, None, slot);
    }

    /// Tells the journal that another file counts as the one that was read.
    pub(crate) fn note_file(&mut self) {
        if let Some(stamp) = self.document.file.and_then(FileStamp::to_json) {
            self.document.journal.note_window(FILE, stamp);
        }
    }

    /// Begins the journal anew after a save: with the same past, and nothing unsaved.
    pub(crate) fn saved(&mut self) {
        if self.document.saved() {
            self.begin_journal(None);
        }
    }

    /// Closes the journal, whose file stays if any change in it is not saved.
    pub(crate) fn leave_journal(&mut self, in_peace: bool) {
        self.commit(false);
        self.document.leave_journal(false, in_peace);
    }

    /// True if closing the painting would lose no work, once all edits are handed over.
    pub(crate) fn keeps_work(&mut self) -> bool {
        self.commit(false);
        self.document.journal.keeps()
    }

    /// The reason why unsaved work is not kept, if it should be and is not.
    pub(crate) fn keeping_problem(&self) -> Option<Diagnostic> {
        self.document.journal.problem()
    }

    /// Waits until the system has all the edits that were handed over.
    pub(crate) fn wait_for_journal(&self) {
        self.document.journal.wait();
    }
}
