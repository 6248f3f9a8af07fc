//! The journal of a document that is open, and what is not handed to it yet.

use std::path::Path;

use crate::diag::Diagnostic;
use crate::files::journal::{Journaled, Op};
use crate::state::orbit::Orbit;
use crate::state::safety::keeper::{JournalStart, JournalWriter};

/// What a journal calls where the window looks from.
pub(crate) const VIEW: &str = "view";

/// A document's journal, and what is not sent to it yet.
pub(crate) struct DocumentJournal<D: Journaled> {
    writer: Option<JournalWriter<D>>,
    ops: Vec<Op<D::Edit>>,
    /// The view that the journal was told last.
    view: Option<Orbit>,
    /// What the file holds by another program's hand and may be written over.
    overridden: Option<String>,
}

impl<D: Journaled> Default for DocumentJournal<D> {
    fn default() -> Self {
        Self { writer: None, ops: Vec::new(), view: None, overridden: None }
    }
}

impl<D> DocumentJournal<D>
where
    D: Journaled + Send + 'static,
    D::Edit: Send,
{
    /// Keeps journals in a folder from now on. `wake` is called from another thread when that
    /// fails, or works again.
    pub(crate) fn keep_in(&mut self, folder: &Path, wake: impl Fn() + Send + 'static) {
        self.writer = Some(JournalWriter::new(folder.to_owned(), wake));
    }

    /// Notes what was done, if anything is kept.
    pub(crate) fn note(&mut self, op: Option<Op<D::Edit>>) {
        if self.writer.is_some() {
            self.ops.extend(op);
        }
    }

    /// Whether edits are noted, so that one must be kept before it is applied.
    pub(crate) fn is_on(&self) -> bool {
        self.writer.is_some()
    }

    /// Whether the document as it stands is wanted rather than what was done.
    pub(crate) fn wants_to_begin(&self, is_dirty: bool) -> bool {
        let is_wanted = |writer: &JournalWriter<D>| {
            writer.wants_to_begin() && (writer.has_begun && is_dirty || !self.ops.is_empty())
        };
        self.writer.as_ref().is_some_and(is_wanted)
    }

    /// Hands what was done since the last call to the journal; a gesture that goes on may wait for
    /// a moment there.
    pub(crate) fn add(&mut self, goes_on: bool) {
        if let Some(writer) = &mut self.writer {
            writer.add(std::mem::take(&mut self.ops), goes_on);
        }
    }

    /// Tells the journal what else the window wants back from now on, if it has begun.
    pub(crate) fn note_window(&mut self, name: &str, value: serde_json::Value) {
        if let Some(writer) = self.writer.as_mut().filter(|writer| writer.has_begun) {
            writer.note_window([(name.to_owned(), value)].into_iter().collect());
        }
    }

    /// Tells the journal where the window looks from, if that is somewhere else now.
    pub(crate) fn note_view(&mut self, view: &Orbit) {
        if let Some(writer) = self.writer.as_mut().filter(|_| self.view.as_ref() != Some(view)) {
            self.view = Some(view.clone());
            writer.note_window([(VIEW.to_owned(), view.to_json())].into_iter().collect());
        }
    }

    /// Begins the journal with a document as it stands, all that was done included.
    pub(crate) fn begin(&mut self, start: JournalStart<D>) {
        self.ops.clear();
        if let Some(writer) = &mut self.writer {
            writer.begin(start);
        }
    }

    /// Forgets what was done: there is nothing that is worth a journal.
    pub(crate) fn clear(&mut self) {
        self.ops.clear();
    }

    /// Lets go of the journal: it stays if anything in it is needed.
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

    /// Nothing is kept any more.
    pub(crate) fn end(&mut self) {
        self.writer = None;
    }

    /// Waits until the system has all that was handed over.
    pub(crate) fn wait(&self) {
        if let Some(writer) = &self.writer {
            writer.wait();
        }
    }

    /// Why unsaved work is not kept, if it should be and is not.
    pub(crate) fn problem(&self) -> Option<Diagnostic> {
        self.writer.as_ref().and_then(JournalWriter::problem)
    }

    /// Whether everything that was handed over is kept.
    pub(crate) fn keeps(&self) -> bool {
        self.wait();
        self.writer.as_ref().is_some_and(|writer| writer.problem().is_none())
    }

    /// Whether saving may write over this text, which another program wrote.
    pub(crate) fn overrides(&self, theirs: &str) -> bool {
        self.overridden.as_deref() == Some(theirs)
    }

    /// Lets saving write over what another program wrote.
    pub(crate) fn override_with(&mut self, theirs: String) {
        self.overridden = Some(theirs);
    }

    /// After a save nothing of another program's is written over any more.
    pub(crate) fn forget_overridden(&mut self) {
        self.overridden = None;
    }
}
