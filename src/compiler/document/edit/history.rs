//! Undo and redo.

use serde::{Deserialize, Serialize};

use super::Applied;
use crate::diag::Diagnostic;

/// A document that changes by edits.
pub trait Editable {
    /// A change of it.
    type Edit: Clone + PartialEq + std::fmt::Debug;

    /// Applies an edit and returns the one that takes it back. What is known to be good is not
    /// checked.
    ///
    /// # Errors
    /// A diagnostic where the edit is impossible; the document is then as it was.
    fn edit(&mut self, edit: Self::Edit, is_known_good: bool) -> Applied<Self::Edit>;

    /// What undo calls an edit.
    fn label(edit: &Self::Edit) -> String;

    /// Whether an edit changes nothing.
    fn does_nothing(edit: &Self::Edit) -> bool;

    /// Whether the older of two inverses also takes back what the newer one would: both set the
    /// same thing.
    fn covers(older: &Self::Edit, newer: &Self::Edit) -> bool;
}

/// A document and all its past: the one place that changes it.
#[derive(Clone, Debug)]
pub struct History<D: Editable> {
    document: D,
    done: Vec<Step<D::Edit>>,
    undone: Vec<Step<D::Edit>>,
    /// Grows with every change, undo and redo.
    revision: u64,
    /// The number of the document's state: undo brings the old one back.
    state: u64,
    saved: u64,
}

/// What one undo takes back, or one redo repeats.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Step<E> {
    label: String,
    gesture: Option<u64>,
    /// To be applied in this order.
    edits: Vec<E>,
    /// The state that the edits lead to.
    state: u64,
}

/// The numbers of a history, which a journal keeps beside its steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct HistoryNumbers {
    revision: u64,
    state: u64,
    saved: u64,
}

impl<D: Editable> History<D> {
    /// Begins with a document as it was read or made.
    pub fn new(document: D) -> Self {
        Self { document, done: Vec::new(), undone: Vec::new(), revision: 0, state: 0, saved: 0 }
    }

    /// The document as it is now.
    pub fn document(&self) -> &D {
        &self.document
    }

    /// The document, without its past.
    pub fn into_document(self) -> D {
        self.document
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
        let label = D::label(&edit);
        let repeated = edit.clone();
        let inverse = self.document.edit(edit, false)?;
        // What sets the value that was there is taken back by itself.
        if D::does_nothing(&inverse) || inverse == repeated {
            // Equal is not always the same: 0 and -0 are written differently.
            return self.document.edit(inverse, true).map(drop);
        }
        let before = self.state;
        self.revision += 1;
        self.state = self.revision;
        self.undone.clear();
        match self.done.last_mut() {
            Some(step) if gesture.is_some() && step.gesture == gesture => {
                // A drag sets the same value a hundred times; the first inverse takes all of them
                // back.
                if !step.edits.first().is_some_and(|older| D::covers(older, &inverse)) {
                    step.edits.insert(0, inverse);
                }
            }
            _ => self.done.push(Step { label, gesture, edits: vec![inverse], state: before }),
        }
        Ok(())
    }

    /// Takes the last step back and returns its label; `None` where there is none.
    pub fn undo(&mut self) -> Option<&str> {
        let step = self.done.pop()?;
        let step = self.turn(step);
        self.undone.push(step);
        self.undone.last().map(|step| step.label.as_str())
    }

    /// Repeats the last step taken back and returns its label; `None` where there is none.
    pub fn redo(&mut self) -> Option<&str> {
        let step = self.undone.pop()?;
        let step = self.turn(step);
        self.done.push(step);
        self.done.last().map(|step| step.label.as_str())
    }

    /// Applies a step and returns the one that takes it back.
    fn turn(&mut self, step: Step<D::Edit>) -> Step<D::Edit> {
        let back = super::all_or_none(&mut self.document, step.edits, true);
        debug_assert!(back.is_ok(), "an inverse applies to what its edit made: {back:?}");
        self.revision += 1;
        let before = std::mem::replace(&mut self.state, step.state);
        // A gesture that was undone is over.
        Step { label: step.label, gesture: None, edits: back.unwrap_or_default(), state: before }
    }

    /// What [`undo`](Self::undo) would take back.
    pub fn undo_label(&self) -> Option<&str> {
        self.done.last().map(|step| step.label.as_str())
    }

    /// What [`redo`](Self::redo) would repeat.
    pub fn redo_label(&self) -> Option<&str> {
        self.undone.last().map(|step| step.label.as_str())
    }

    /// What undo calls every step, the first one first: those that were done, then those that were
    /// taken back.
    pub fn labels(&self) -> impl Iterator<Item = &str> {
        self.done.iter().chain(self.undone.iter().rev()).map(|step| step.label.as_str())
    }

    /// How many steps are done: so many of [`labels`](Self::labels).
    pub fn place(&self) -> usize {
        self.done.len()
    }

    /// Grows with every change, so that others see that there is something new.
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// Notes that the document is saved as it is now.
    pub fn mark_saved(&mut self) {
        self.saved = self.state;
    }

    /// Notes that no file holds the document, neither as it is nor as it was.
    pub fn mark_unsaved(&mut self) {
        // A number that no state has: the next edit's is larger.
        self.revision += 1;
        self.saved = self.revision;
    }

    /// Puts another document in place of this one, and changes what is known of its past to suit:
    /// as when what all of them speak of gets another name. It is no step, and nothing takes it
    /// back.
    pub fn amend(&mut self, document: D, change: impl FnMut(&mut D::Edit)) {
        self.document = document;
        self.revision += 1;
        let steps = self.done.iter_mut().chain(&mut self.undone);
        steps.flat_map(|step| &mut step.edits).for_each(change);
    }

    /// Whether the document is as it was saved, or as it was in the beginning.
    pub fn is_saved(&self) -> bool {
        self.saved == self.state
    }

    /// How many steps lie between the document as it was saved and as it is: what losing it would
    /// lose. `None` where no undo or redo leads to the saved state.
    pub fn unsaved_steps(&self) -> Option<usize> {
        if self.is_saved() {
            return Some(0);
        }
        let to_saved =
            |steps: &[Step<D::Edit>]| steps.iter().rev().position(|step| step.state == self.saved);
        to_saved(&self.done).or_else(|| to_saved(&self.undone)).map(|index| index + 1)
    }

    /// How many steps can be taken back and repeated.
    pub fn steps(&self) -> (usize, usize) {
        (self.done.len(), self.undone.len())
    }

    /// What can be taken back, the newest last.
    pub fn done(&self) -> &[Step<D::Edit>] {
        &self.done
    }

    /// What can be repeated, the next one last.
    pub fn undone(&self) -> &[Step<D::Edit>] {
        &self.undone
    }

    /// The numbers that a journal keeps.
    pub fn numbers(&self) -> HistoryNumbers {
        HistoryNumbers { revision: self.revision, state: self.state, saved: self.saved }
    }

    /// A history as a journal has it.
    pub fn restored(
        document: D,
        done: Vec<Step<D::Edit>>,
        undone: Vec<Step<D::Edit>>,
        numbers: HistoryNumbers,
    ) -> Self {
        let HistoryNumbers { revision, state, saved } = numbers;
        Self { document, done, undone, revision, state, saved }
    }

    /// Ends the gesture that may be going on: whatever comes next is a step of its own.
    pub fn end_gesture(&mut self) {
        if let Some(step) = self.done.last_mut() {
            step.gesture = None;
        }
    }

    /// Lets go of steps that do not apply to the document, and of what lies beyond them; says how
    /// many. A history that was made by edits has none; one that was read from a damaged file may.
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
