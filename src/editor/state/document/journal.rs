//! Journal of an open document, and the edits that are not handed to it yet.

use std::path::Path;

use crate::diag::Diagnostic;
use crate::files::journal::{JournalDocument, Op};
use crate::state::document::journal_writer::{JournalStart, JournalWriter};
use crate::state::orbit::Orbit;

/// Member of a journal for the window's view.
pub(crate) const VIEW: &str = "view";

/// Journal of a document, and the edits that are not sent to it yet.
pub(crate) struct DocumentJournal<D: JournalDocument> {
    writer: Option<JournalWriter<D>>,
    ops: Vec<Op<D::Edit>>,
    /// View that the journal was last told.
    view: Option<Orbit>,
    /// Text of the file by another program's hand that may be written over.
    overridden: Option<String>,
}

impl<D: JournalDocument> Default for DocumentJournal<D> {
    fn default() -> Self {
        Self { writer: None, ops: Vec::new(), view: None, overridden: None }
    }
}

impl<D> DocumentJournal<D>
where
    D: JournalDocument + Send + 'static,
    D::Edit: Send,
{
    /// Keeps journals in a folder from now on. `wake` is called from another thread when the
    /// journal cannot be written, or can again.
    pub(crate) fn keep_in(&mut self, folder: &Path, wake: impl Fn() + Send + 'static) {
        self.writer = Some(JournalWriter::new(folder.to_owned(), wake));
    }

    /// Notes an operation, if a journal is kept.
    pub(crate) fn note(&mut self, op: Option<Op<D::Edit>>) {
        if self.writer.is_some() {
            self.ops.extend(op);
        }
    }

    /// True if operations are noted, so that an edit must be cloned before it is applied.
    pub(crate) fn is_on(&self) -> bool {
        self.writer.is_some()
    }

    /// True if the journal wants the whole document rather than the noted operations.
    pub(crate) fn wants_to_begin(&self, is_dirty: bool) -> bool {
        let is_wanted = |writer: &JournalWriter<D>| {
            writer.wants_to_begin() && (writer.has_begun && is_dirty || !self.ops.is_empty())
        };
        self.writer.as_ref().is_some_and(is_wanted)
    }

    /// Hands the operations since the last call to the journal; a gesture that goes on may wait for
    /// a moment there.
    pub(crate) fn add(&mut self, goes_on: bool) {
        if let Some(writer) = &mut self.writer {
            writer.add(std::mem::take(&mut self.ops), goes_on);
        }
    }

    /// Tells the journal, if it has begun, another value that the window wants back.
    pub(crate) fn note_window(&mut self, name: &str, value: serde_json::Value) {
        if let Some(writer) = self.writer.as_mut().filter(|writer| writer.has_begun) {
            writer.note_window([(name.to_owned(), value)].into_iter().collect());
        }
    }

    /// Tells the journal the window's view, if it changed.
    pub(crate) fn note_view(&mut self, view: &Orbit) {
        if let Some(writer) = self.writer.as_mut().filter(|_| self.view.as_ref() != Some(view)) {
            self.view = Some(view.clone());
            writer.note_window([(VIEW.to_owned(), view.to_json())].into_iter().collect());
        }
    }

    /// Begins the journal with a whole document, which includes all noted operations.
    pub(crate) fn begin(&mut self, start: JournalStart<D>) {
        self.ops.clear();
        if let Some(writer) = &mut self.writer {
            writer.begin(start);
        }
    }

    /// Forgets the noted operations: nothing is worth a journal.
    pub(crate) fn clear(&mut self) {
        self.ops.clear();
    }

    /// Closes the journal, whose file stays if it is needed.
    pub(crate) fn leave(&mut self, is_needed: bool, in_peace: bool) {
        self.overridden = None;
        if let Some(writer) = &mut self.writer {
            match is_needed {
                true => writer.leave(in_peace),
                false => writer.discard(),
            }
            writer.wait();
        }
    }

    /// Stops keeping a journal.
    pub(crate) fn end(&mut self) {
        self.writer = None;
    }

    /// Waits until the system has all the operations that were handed over.
    pub(crate) fn wait(&self) {
        if let Some(writer) = &self.writer {
            writer.wait();
        }
    }

    /// The reason why unsaved work is not kept, if it should be and is not.
    pub(crate) fn problem(&self) -> Option<Diagnostic> {
        self.writer.as_ref().and_then(JournalWriter::problem)
    }

    /// True if every operation that was handed over is kept.
    pub(crate) fn keeps(&self) -> bool {
        self.wait();
        self.writer.as_ref().is_some_and(|writer| writer.problem().is_none())
    }

    /// True if saving may write over `theirs`, the text of another program.
    pub(crate) fn overrides(&self, theirs: &str) -> bool {
        self.overridden.as_deref() == Some(theirs)
    }

    /// Lets saving write over the text of another program.
    pub(crate) fn override_with(&mut self, theirs: String) {
        self.overridden = Some(theirs);
    }

    /// Forgets, after a save, the other program's text that could be written over.
    pub(crate) fn forget_overridden(&mut self) {
        self.overridden = None;
    }
}
