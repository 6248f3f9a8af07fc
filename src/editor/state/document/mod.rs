//! An open document: with its past, the times of its steps, the gestures that they come from, the
//! journal that loses none of it, and its file. The look, the scene around it and the painting are
//! documents of this kind.

pub(crate) mod journal;
mod journal_writer;
mod text;
pub(crate) mod times;

use std::path::{Path, PathBuf};

use chiaro_locale::{Text, text, tr};

use crate::diag::Diagnostic;
use crate::document::{DocumentRevision, History};
use crate::files::journal::{DocumentInfo, JournalDocument, JournalSlot, Op};
use crate::state::document::journal_writer::JournalStart;
use crate::state::revision::{GestureId, StepTime};
use journal::DocumentJournal;
pub(crate) use text::TextFile;
use times::{Gestures, Times};

/// Code of the problem that another program changed a file since it was read.
pub(crate) const CHANGED_ON_DISK: &str = "changed-on-disk";

/// An open document.
pub(crate) struct OpenDocument<D: FileDocument> {
    pub(crate) history: History<D>,
    pub(crate) times: Times,
    gestures: Gestures,
    pub(crate) journal: DocumentJournal<D>,
    /// File of the document, once there is one.
    pub(crate) path: Option<PathBuf>,
    /// State of the file when it was last read or written.
    pub(crate) file: D::FileState,
    /// True if parts of the file could not be read, so that saving over it would lose them.
    pub(crate) is_partial: bool,
    /// Problems found when the file was read.
    pub(crate) load_problems: Vec<Diagnostic>,
}

/// Texts on a file that is not written over.
pub(crate) struct FileRefusals {
    is_changed: Text,
    choose: Text,
    save_elsewhere: Text,
}

impl FileRefusals {
    /// Of a file whose document needs no word.
    pub(crate) const OF_FILE: Self = Self {
        is_changed: text!(
            "another program has changed this file since it was opened, and nothing was written \
             over it"
        ),
        choose: text!("choose above whose version is kept, or save under another name"),
        save_elsewhere: text!("save under another name"),
    };
    /// Of a scene.
    const OF_SCENE: Self = Self {
        is_changed: text!(
            "another program has changed this scene since it was opened, and nothing was written \
             over it"
        ),
        choose: text!("choose above whose version is kept, or save the scene under another name"),
        save_elsewhere: text!("save the scene under another name"),
    };
    /// Of a shot.
    const OF_SHOT: Self = Self {
        is_changed: text!(
            "another program has changed this shot since it was opened, and nothing was written \
             over it"
        ),
        choose: text!("choose above whose version is kept, or save the shot under another name"),
        save_elsewhere: text!("save the shot under another name"),
    };
}

/// A document that files hold.
pub(crate) trait FileDocument: JournalDocument {
    /// Remembered state of the file.
    type FileState;
    /// Content of a file that another program wrote.
    type Change;
    /// Texts on a file that is not written over.
    const REFUSALS: FileRefusals;

    /// Compares the file of a document with its state when it was last read or written.
    fn on_disk(document: &OpenDocument<Self>, path: &Path) -> OnDisk<Self::Change>;
}

/// Result of comparing a file with its state when it was last read or written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum OnDisk<T = String> {
    Same,
    /// No file, or none yet.
    Gone,
    /// A file that another program wrote.
    Changed(T),
    /// A file that cannot be read at this moment.
    Unreadable,
}

impl<D> OpenDocument<D>
where
    D: FileDocument + Send + 'static,
    D::Edit: Send,
{
    /// A document with its past. The times of past steps are unknown: they count as older than all
    /// others.
    pub(crate) fn new(history: History<D>, path: Option<PathBuf>, file: D::FileState) -> Self {
        let mut times = Times::default();
        times.fit(history.steps());
        Self {
            history,
            times,
            gestures: Gestures::default(),
            journal: DocumentJournal::default(),
            path,
            file,
            is_partial: false,
            load_problems: Vec::new(),
        }
    }

    /// The document of the latest step.
    pub(crate) fn document(&self) -> &D {
        self.history.document()
    }

    /// Revision of the document, which grows with every change.
    pub(crate) fn revision(&self) -> DocumentRevision {
        self.history.revision()
    }

    /// Folder that names in the document are relative to.
    pub(crate) fn folder(&self) -> PathBuf {
        self.path.as_deref().and_then(Path::parent).map(Path::to_path_buf).unwrap_or_default()
    }

    /// True if there are changes that no file holds.
    pub(crate) fn is_dirty(&self) -> bool {
        !self.history.is_saved()
    }

    /// Compares the file with its state when it was last read or written.
    pub(crate) fn on_disk(&self) -> OnDisk<D::Change> {
        self.path.as_deref().map_or(OnDisk::Same, |path| D::on_disk(self, path))
    }

    /// Returns true if saving to a file writes over the document's own file.
    ///
    /// # Errors
    /// A diagnostic with the reason why nothing may be written there.
    pub(crate) fn check_saving(&self, path: &Path) -> Result<bool, Box<Diagnostic>> {
        if self.path.as_deref() != Some(path) {
            return Ok(false);
        }
        if self.is_partial {
            let message = tr!(
                "this file holds things that could not be read, and saving over it would lose them"
            );
            let hint = D::REFUSALS.save_elsewhere.tr();
            return Err(Box::new(Diagnostic::error("partly-read", message).hint(hint)));
        }
        if let OnDisk::Changed(_) = self.on_disk() {
            let (message, hint) = (D::REFUSALS.is_changed.tr(), D::REFUSALS.choose.tr());
            return Err(Box::new(Diagnostic::error(CHANGED_ON_DISK, message).hint(hint)));
        }
        Ok(true)
    }

    /// Takes a file that holds the whole document from now on.
    pub(crate) fn was_written(&mut self, path: PathBuf, file: D::FileState) {
        self.path = Some(path);
        self.file = file;
        self.is_partial = false;
        self.load_problems.clear();
        self.history.mark_saved();
    }

    /// Applies an edit. Consecutive edits of the same `gesture` are one step. `now` is the time of
    /// the step. Returns true if the document changed.
    ///
    /// # Errors
    /// A diagnostic where the edit is impossible; nothing is changed then.
    pub(crate) fn apply(
        &mut self,
        edit: D::Edit,
        gesture: Option<GestureId>,
        now: StepTime,
    ) -> Result<bool, Box<Diagnostic>> {
        let before = self.revision();
        let kept = self.journal.is_on().then(|| edit.clone());
        let number = gesture.map(|gesture| self.gestures.number_of(gesture, before).0);
        match number {
            Some(number) => self.history.apply_in(number, edit)?,
            None => self.history.apply(edit)?,
        }
        self.gestures.did(gesture, self.revision());
        let is_changed = self.revision() != before;
        if is_changed {
            self.times.did(self.history.steps(), now);
            self.journal.note(kept.map(|edit| Op::Edit { gesture: number, edit }));
        }
        Ok(is_changed)
    }

    /// Takes back the last step, if there is one.
    pub(crate) fn undo(&mut self) -> bool {
        let did = self.history.undo().is_some();
        if did {
            self.times.undid();
            self.journal.note(Some(Op::Undo));
        }
        did
    }

    /// Repeats the step that was last taken back, if there is one. `now` is the time of the step.
    pub(crate) fn redo(&mut self, now: StepTime) -> bool {
        let did = self.history.redo().is_some();
        if did {
            self.times.redid(now);
            self.journal.note(Some(Op::Redo));
        }
        did
    }

    /// Ends a gesture, so that the next edit is a step of its own.
    pub(crate) fn end_gesture(&mut self) {
        self.gestures.end();
    }

    /// Hands the operations since the last call to the journal; a gesture that goes on may wait for
    /// a moment there. Returns true if the journal is to begin anew instead, with the whole
    /// document.
    #[must_use]
    pub(crate) fn commit(&mut self, goes_on: bool) -> bool {
        let begins = self.journal.wants_to_begin(!self.history.is_saved());
        if !begins {
            self.journal.add(goes_on);
        }
        begins
    }

    /// Begins the journal with the whole document.
    pub(crate) fn begin_journal(
        &mut self,
        about: DocumentInfo,
        source: Option<std::sync::Arc<str>>,
        slot: Option<JournalSlot>,
    ) {
        self.journal.begin(JournalStart { about, source, history: self.history.clone(), slot });
    }

    /// Notes a save. Returns true if the journal is to begin anew, with the same past and nothing
    /// unsaved. A document without a past is not worth a journal.
    #[must_use]
    pub(crate) fn saved(&mut self) -> bool {
        self.journal.forget_overridden();
        let begins = self.journal.is_on() && self.history.steps() != (0, 0);
        if !begins {
            self.journal.clear();
        }
        begins
    }

    /// Closes the journal, whose file stays if any change in it is not saved, or if `is_needed`.
    pub(crate) fn leave_journal(&mut self, is_needed: bool, in_peace: bool) {
        self.journal.leave(!self.history.is_saved() || is_needed, in_peace);
    }
}
