//! Times of a document's steps, and its gestures. `session::steps` compares the times of the look,
//! the scene around it, the painting and the sketch, so that undo takes back the last step of any.

use crate::document::DocumentRevision;
use crate::state::revision::{GestureId, GestureNumber, StepTime};

/// Time of each step of a history, by a count that grows. Steps that a journal brought back count
/// as older than all others.
#[derive(Clone, Debug, Default)]
pub(crate) struct Times {
    done: Vec<StepTime>,
    undone: Vec<StepTime>,
}

impl Times {
    /// Notes an edit: `steps` are the counts of done steps and of undone ones after it. An edit
    /// that went on with the last step keeps that step's time.
    pub(crate) fn did(&mut self, (done, undone): (usize, usize), now: StepTime) {
        self.done.resize(done, now);
        self.undone.resize(undone, StepTime::default());
    }

    /// Notes that the last step was taken back.
    pub(crate) fn undid(&mut self) {
        self.undone.extend(self.done.pop());
    }

    /// Notes that a step was repeated, at a new time.
    pub(crate) fn redid(&mut self, now: StepTime) {
        self.undone.pop();
        self.done.push(now);
    }

    /// Adapts to a history with so many steps: unknown steps are the oldest.
    pub(crate) fn fit(&mut self, (done, undone): (usize, usize)) {
        fit(&mut self.done, done);
        fit(&mut self.undone, undone);
    }

    /// Time of the step that undo would take back.
    pub(crate) fn last(&self) -> Option<StepTime> {
        self.done.last().copied()
    }

    /// Time of the step that redo would repeat.
    pub(crate) fn next(&self) -> Option<StepTime> {
        self.undone.last().copied()
    }

    /// Times of all steps: the done ones, the oldest first, then the undone ones, the next to redo
    /// first. The flag is true for undone steps.
    pub(crate) fn all(&self) -> impl Iterator<Item = (bool, StepTime)> {
        let done = self.done.iter().map(|time| (false, *time));
        done.chain(self.undone.iter().rev().map(|time| (true, *time)))
    }
}

fn fit(times: &mut Vec<StepTime>, count: usize) {
    match count.checked_sub(times.len()) {
        Some(missing) => {
            drop(times.splice(0..0, std::iter::repeat_n(StepTime::default(), missing)));
        }
        None => drop(times.drain(..times.len() - count)),
    }
}

/// Gestures of a document: consecutive edits of the same gesture are one step.
#[derive(Default)]
pub(crate) struct Gestures {
    /// Gesture of the last edit, with the revision that the edit led to.
    last: Option<(GestureId, DocumentRevision)>,
    number: GestureNumber,
}

impl Gestures {
    /// Number of the gesture that an edit belongs to: that of the last edit, if the document did
    /// not change since.
    pub(crate) fn number_of(
        &mut self,
        gesture: GestureId,
        revision: DocumentRevision,
    ) -> GestureNumber {
        if self.last != Some((gesture, revision)) {
            self.number.advance();
        }
        self.number
    }

    /// Notes the revision that an edit led to.
    pub(crate) fn did(&mut self, gesture: Option<GestureId>, revision: DocumentRevision) {
        self.last = gesture.map(|gesture| (gesture, revision));
    }

    /// Ends the gesture, so that the next edit begins another.
    pub(crate) fn end(&mut self) {
        self.last = None;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_keep_their_times() {
        let mut times = Times::default();
        times.did((1, 0), StepTime(5));
        times.did((1, 0), StepTime(6));
        times.did((2, 0), StepTime(7));
        assert_eq!(times.last(), Some(StepTime(7)));
        times.undid();
        assert_eq!(
            (times.last(), times.next()),
            (Some(StepTime(5)), Some(StepTime(7))),
            "a gesture's step has the time of its beginning"
        );
        times.redid(StepTime(9));
        assert_eq!(times.all().collect::<Vec<_>>(), [(false, StepTime(5)), (false, StepTime(9))]);
        times.fit((4, 1));
        assert_eq!(times.all().map(|(_, time)| time.0).collect::<Vec<_>>(), [0, 0, 5, 9, 0]);
        times.fit((1, 0));
        assert_eq!(times.all().collect::<Vec<_>>(), [(false, StepTime(9))]);
    }
}
