//! History of a document: undo and redo.

use serde::{Deserialize, Serialize};

use super::EditResult;
use crate::diag::Diagnostic;

/// Document that changes by edits.
pub trait Editable {
    /// Edit of the document.
    type Edit: Clone + PartialEq + std::fmt::Debug;

    /// Applies an edit and returns the edit that undoes it. An edit that is known to be good is not
    /// checked.
    ///
    /// # Errors
    /// A diagnostic where the edit is impossible; the document is then as it was.
    fn edit(&mut self, edit: Self::Edit, is_known_good: bool) -> EditResult<Self::Edit>;

    /// Label for undo of an edit that is not applied yet.
    fn label(&self, edit: &Self::Edit) -> String;

    /// True for an edit that changes nothing.
    fn does_nothing(edit: &Self::Edit) -> bool;

    /// True if the older of two inverses also undoes what the newer one would: both set the same
    /// value.
    fn covers(older: &Self::Edit, newer: &Self::Edit) -> bool;

    /// True for an edit that no picture shows, nor its inverse: of names, texts, markers, and
    /// places on the canvas.
    fn is_annotation(_edit: &Self::Edit) -> bool {
        false
    }
}

/// Revision of a document with a past: the number of changes, undos and redos so far.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize,
)]
#[serde(transparent)]
pub struct DocumentRevision(u64);

impl DocumentRevision {
    fn advance(&mut self) {
        self.0 += 1;
    }
}

/// Document with all its past: the one place that changes the document.
#[derive(Clone, Debug)]
pub struct History<D: Editable> {
    document: D,
    done: Vec<Step<D::Edit>>,
    undone: Vec<Step<D::Edit>>,
    revision: DocumentRevision,
    /// Revision of the last change that a picture may show.
    picture: DocumentRevision,
    /// Revision at which the document's state first came about: undo brings the old one back.
    state: DocumentRevision,
    /// State that a file holds.
    saved: DocumentRevision,
}

/// Edits that one undo takes back, or one redo repeats.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Step<E> {
    label: String,
    gesture: Option<u64>,
    /// Edits, in the order in which they are to be applied.
    edits: Vec<E>,
    /// State that the edits lead to.
    state: DocumentRevision,
}

/// Numbers of a history, which a journal keeps beside its steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct HistoryNumbers {
    revision: DocumentRevision,
    state: DocumentRevision,
    saved: DocumentRevision,
}

impl<D: Editable> History<D> {
    /// History of a document as it was read or made, without steps.
    pub fn new(document: D) -> Self {
        Self {
            document,
            done: Vec::new(),
            undone: Vec::new(),
            revision: DocumentRevision::default(),
            picture: DocumentRevision::default(),
            state: DocumentRevision::default(),
            saved: DocumentRevision::default(),
        }
    }

    /// Current document.
    pub fn document(&self) -> &D {
        &self.document
    }

    /// Applies an edit as an undo step of its own.
    ///
    /// # Errors
    /// A diagnostic where the edit is impossible; nothing is changed then.
    pub fn apply(&mut self, edit: D::Edit) -> Result<(), Box<Diagnostic>> {
        self.apply_to_step(edit, None)
    }

    /// Applies an edit of a gesture: consecutive edits of the same gesture, such as all of one
    /// drag, are undone at once.
    ///
    /// # Errors
    /// A diagnostic where the edit is impossible; nothing is changed then.
    pub fn apply_in(&mut self, gesture: u64, edit: D::Edit) -> Result<(), Box<Diagnostic>> {
        self.apply_to_step(edit, Some(gesture))
    }

    fn apply_to_step(
        &mut self,
        edit: D::Edit,
        gesture: Option<u64>,
    ) -> Result<(), Box<Diagnostic>> {
        let label = self.document.label(&edit);
        let repeated = edit.clone();
        let inverse = self.document.edit(edit, false)?;
        // An edit that sets the value that was there is undone at once, and makes no step.
        if D::does_nothing(&inverse) || inverse == repeated {
            // Equal values are not always the same: 0 and -0 are written differently.
            return self.document.edit(inverse, true).map(drop);
        }
        let before = self.state;
        self.advance(D::is_annotation(&inverse));
        self.state = self.revision;
        self.undone.clear();
        match self.done.last_mut() {
            Some(step) if gesture.is_some() && step.gesture == gesture => {
                // A drag sets the same value a hundred times; the first inverse undoes all of them.
                if !step.edits.first().is_some_and(|older| D::covers(older, &inverse)) {
                    step.edits.insert(0, inverse);
                }
            }
            _ => self.done.push(Step { label, gesture, edits: vec![inverse], state: before }),
        }
        Ok(())
    }

    /// Undoes the last step and returns its label; `None` where there is none.
    pub fn undo(&mut self) -> Option<&str> {
        let step = self.done.pop()?;
        let step = self.turn(step);
        self.undone.push(step);
        self.undone.last().map(|step| step.label.as_str())
    }

    /// Redoes the step that was undone last and returns its label; `None` where there is none.
    pub fn redo(&mut self) -> Option<&str> {
        let step = self.undone.pop()?;
        let step = self.turn(step);
        self.done.push(step);
        self.done.last().map(|step| step.label.as_str())
    }

    /// Applies a step and returns the step that undoes it.
    fn turn(&mut self, step: Step<D::Edit>) -> Step<D::Edit> {
        let is_annotation = step.edits.iter().all(D::is_annotation);
        let back = super::all_or_none(&mut self.document, step.edits, true);
        debug_assert!(back.is_ok(), "an inverse applies to what its edit made: {back:?}");
        self.advance(is_annotation);
        let before = std::mem::replace(&mut self.state, step.state);
        // A gesture that was undone is over.
        Step { label: step.label, gesture: None, edits: back.unwrap_or_default(), state: before }
    }

    fn advance(&mut self, is_annotation: bool) {
        self.revision.advance();
        if !is_annotation {
            self.picture = self.revision;
        }
    }

    /// Label of the step that [`undo`](Self::undo) would take back.
    pub fn undo_label(&self) -> Option<&str> {
        self.done.last().map(|step| step.label.as_str())
    }

    /// Label of the step that [`redo`](Self::redo) would repeat.
    pub fn redo_label(&self) -> Option<&str> {
        self.undone.last().map(|step| step.label.as_str())
    }

    /// Labels of all steps, the first one first: those that were done, then those that were undone.
    pub fn labels(&self) -> impl Iterator<Item = &str> {
        self.done.iter().chain(self.undone.iter().rev()).map(|step| step.label.as_str())
    }

    /// Number of steps that are done: so many of [`labels`](Self::labels).
    pub fn place(&self) -> usize {
        self.done.len()
    }

    /// Revision of the document, by which observers notice a change.
    pub fn revision(&self) -> DocumentRevision {
        self.revision
    }

    /// Revision of the last change that a picture may show: annotations do not count.
    pub fn picture_revision(&self) -> DocumentRevision {
        self.picture
    }

    /// Notes that the document is saved as it is now.
    pub fn mark_saved(&mut self) {
        self.saved = self.state;
    }

    /// Notes that no file holds the document, neither as it is nor as it was.
    pub fn mark_unsaved(&mut self) {
        // The next edit's number is larger, so that no state has this one.
        self.revision.advance();
        self.saved = self.revision;
    }

    /// Replaces the document and changes the edits of its past to suit: as when a part that they
    /// all name is renamed. The replacement is no step, and cannot be undone.
    pub fn amend(&mut self, document: D, change: impl FnMut(&mut D::Edit)) {
        self.document = document;
        self.advance(false);
        let steps = self.done.iter_mut().chain(&mut self.undone);
        steps.flat_map(|step| &mut step.edits).for_each(change);
    }

    /// True if the document is as it was saved, or as it was in the beginning.
    pub fn is_saved(&self) -> bool {
        self.saved == self.state
    }

    /// Number of steps between the document as it was saved and as it is, which losing the document
    /// would lose. `None` where no undo or redo leads to the saved state.
    pub fn unsaved_steps(&self) -> Option<usize> {
        if self.is_saved() {
            return Some(0);
        }
        let to_saved =
            |steps: &[Step<D::Edit>]| steps.iter().rev().position(|step| step.state == self.saved);
        to_saved(&self.done).or_else(|| to_saved(&self.undone)).map(|index| index + 1)
    }

    /// Numbers of steps that can be undone and redone.
    pub fn steps(&self) -> (usize, usize) {
        (self.done.len(), self.undone.len())
    }

    /// Steps that can be undone, the newest last.
    pub fn done(&self) -> &[Step<D::Edit>] {
        &self.done
    }

    /// Steps that can be redone, the next one last.
    pub fn undone(&self) -> &[Step<D::Edit>] {
        &self.undone
    }

    /// Numbers that a journal keeps.
    pub fn numbers(&self) -> HistoryNumbers {
        HistoryNumbers { revision: self.revision, state: self.state, saved: self.saved }
    }

    /// History restored from a journal.
    pub fn restored(
        document: D,
        done: Vec<Step<D::Edit>>,
        undone: Vec<Step<D::Edit>>,
        numbers: HistoryNumbers,
    ) -> Self {
        let HistoryNumbers { revision, state, saved } = numbers;
        Self { document, done, undone, revision, picture: revision, state, saved }
    }

    /// Ends the current gesture, if any: the next edit is a step of its own.
    pub fn end_gesture(&mut self) {
        if let Some(step) = self.done.last_mut() {
            step.gesture = None;
        }
    }

    /// Drops steps that do not apply to the document, and the steps beyond them; returns the number
    /// of dropped steps. A history that was made by edits has none; one that was read from a
    /// damaged file may.
    pub fn drop_impossible_steps(&mut self) -> usize
    where
        D: Clone,
    {
        let possible = |steps: &[Step<D::Edit>]| {
            let mut document = self.document.clone();
            let mut applies = |step: &Step<D::Edit>| {
                super::all_or_none(&mut document, step.edits.clone(), true).is_ok()
            };
            steps.iter().rev().take_while(|step| applies(step)).count()
        };
        let (done, undone) = (possible(&self.done), possible(&self.undone));
        let dropped = self.done.len() - done + self.undone.len() - undone;
        self.done.drain(..self.done.len() - done);
        self.undone.drain(..self.undone.len() - undone);
        dropped
    }
}
