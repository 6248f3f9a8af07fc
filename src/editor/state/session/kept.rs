//! A document that is kept: with its past, when its steps were done, the gestures that they come
//! of, and the journal that loses none of it. The look, the scene around it and what is painted are
//! one each.

use super::keeping::Keeping;
use super::times::{Gestures, Times};
use crate::diag::Diagnostic;
use crate::document::History;
use crate::document::journal::{About, Journaled, Op, Slot};
use crate::state::safety::keeper::Standing;

/// A document with all that is kept of it.
pub(crate) struct Kept<D: Journaled> {
    pub(crate) history: History<D>,
    pub(crate) times: Times,
    gestures: Gestures,
    pub(crate) keeping: Keeping<D>,
}

impl<D> Kept<D>
where
    D: Journaled + Send + 'static,
    D::Edit: Send,
{
    /// A document with its past. When the steps of that were done nobody knows: they are older than
    /// all others.
    pub(crate) fn new(history: History<D>) -> Self {
        let mut times = Times::default();
        times.fit(history.steps());
        Self { history, times, gestures: Gestures::default(), keeping: Keeping::default() }
    }

    /// Applies an edit. With a `hand`, consecutive edits by it are one step. `now` is when. Returns
    /// whether anything is another now.
    ///
    /// # Errors
    /// A diagnostic where the edit is impossible; nothing is changed then.
    pub(crate) fn apply(
        &mut self,
        edit: D::Edit,
        hand: Option<u64>,
        now: u64,
    ) -> Result<bool, Box<Diagnostic>> {
        let before = self.history.revision();
        let kept = self.keeping.is_on().then(|| edit.clone());
        let gesture = hand.map(|hand| self.gestures.of(hand, before));
        match gesture {
            Some(gesture) => self.history.apply_in(gesture, edit)?,
            None => self.history.apply(edit)?,
        }
        self.gestures.did(hand, self.history.revision());
        let is_changed = self.history.revision() != before;
        if is_changed {
            self.times.did(self.history.steps(), now);
            self.keeping.note(kept.map(|edit| Op::Edit { gesture, edit }));
        }
        Ok(is_changed)
    }

    /// Takes the last step back, if there is one.
    pub(crate) fn undo(&mut self) -> bool {
        let did = self.history.undo().is_some();
        if did {
            self.times.undid();
            self.keeping.note(Some(Op::Undo));
        }
        did
    }

    /// Repeats the step that was taken back last, if there is one. `now` is when.
    pub(crate) fn redo(&mut self, now: u64) -> bool {
        let did = self.history.redo().is_some();
        if did {
            self.times.redid(now);
            self.keeping.note(Some(Op::Redo));
        }
        did
    }

    /// Breaks a gesture, so that whatever comes next is a step of its own.
    pub(crate) fn end_gesture(&mut self) {
        self.gestures.end();
    }

    /// Hands what was done to the journal; a gesture that goes on may wait for a moment there.
    /// Returns whether the journal is to begin anew instead, with the document as it stands.
    #[must_use]
    pub(crate) fn commit(&mut self, goes_on: bool) -> bool {
        let begins = self.keeping.wants_to_begin(!self.history.is_saved());
        if !begins {
            self.keeping.add(goes_on);
        }
        begins
    }

    /// Begins the journal with the document as it stands.
    pub(crate) fn begin_journal(
        &mut self,
        about: About,
        source: Option<std::sync::Arc<str>>,
        slot: Option<Slot>,
    ) {
        self.keeping.begin(Standing { about, source, history: self.history.clone(), slot });
    }

    /// After a save: returns whether the journal is to begin anew, with the same past and nothing
    /// unsaved. Without a past there is nothing that is worth one.
    #[must_use]
    pub(crate) fn saved(&mut self) -> bool {
        self.keeping.forget_overridden();
        let begins = self.keeping.is_on() && self.history.steps() != (0, 0);
        if !begins {
            self.keeping.clear();
        }
        begins
    }

    /// Lets go of the journal: it stays if anything in it is not saved, or is needed all the same.
    pub(crate) fn leave_journal(&mut self, is_needed: bool, in_peace: bool) {
        self.keeping.leave(!self.history.is_saved() || is_needed, in_peace);
    }
}
