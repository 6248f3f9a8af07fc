//! Steps of all open documents, in one order: undo takes back the last of them.
//!
//! The session alone stamps steps: a method that does, repeats or reloads something takes the next
//! number of `Revisions::step` and hands it to the document, whose `Times` keep it. Undo stamps
//! nothing. The steps themselves are in the documents' histories, and in the sketch.

use std::collections::BTreeMap;

use super::Session;
use crate::document::Look;
use crate::state::document::OpenDocument;
use crate::state::document::times::Times;
use crate::state::masks::MaskSteps;
use crate::state::painting::work::OpenPainting;
use crate::state::revision::StepTime;
use crate::state::scene::{OpenScene, real};
use crate::state::shelf::SnapshotShelf;
use crate::state::shot::OpenShot;
use crate::state::sketch::Sketch;

/// Document that a step belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum DocumentKind {
    Look,
    Scene,
    Shot,
    Painting,
    Sketch,
    Mask,
    Shelf,
}

/// Steps of the look, and of the other documents whose steps undo takes back.
#[derive(Clone, Copy)]
pub struct Steps<'a> {
    pub(super) look: &'a OpenDocument<Look>,
    pub(super) scene: Option<&'a OpenScene>,
    /// The shot over the scene, which is edited in place of look and scene.
    pub(super) shot: Option<&'a OpenShot>,
    /// The painting, where the open look shows it.
    pub(super) painting: Option<&'a OpenPainting>,
    /// The sketch, where it is shown.
    pub(super) sketch: Option<&'a Sketch>,
    /// The strokes on masks of the look.
    pub(super) masks: &'a MaskSteps,
    /// Snapshots of the look.
    pub(super) shelf: &'a SnapshotShelf,
    /// Labels of steps of the look that their edits do not tell.
    pub(super) named: &'a BTreeMap<StepTime, String>,
}

impl<'a> Steps<'a> {
    /// The document whose step undo would take back.
    pub(super) fn last(self) -> DocumentKind {
        let of_look = self.look.history.undo_label().and(self.look.times.last());
        let of_scene = self.scene.and_then(|scene| scene.document.times.last());
        let of_painting = self.painting.and_then(|work| work.document.times.last());
        let of_sketch = self.sketch.and_then(|sketch| sketch.times.last());
        let of_shot = self.shot.and_then(|shot| shot.document.times.last());
        let of_masks = self.masks.times.last();
        let of_shelf = self.shelf.times.last();
        let others = of_look.max(of_scene).max(of_painting).max(of_sketch).max(of_shot);
        if of_masks.is_some() && of_masks > others.max(of_shelf) {
            return DocumentKind::Mask;
        }
        if of_shelf.is_some() && of_shelf > others {
            return DocumentKind::Shelf;
        }
        if of_shot.is_some() && of_shot >= of_sketch.max(of_painting) {
            return DocumentKind::Shot;
        }
        // Among steps that journals brought back, the look's come first.
        if of_sketch.is_some() && of_sketch > of_look.max(of_scene).max(of_painting) {
            DocumentKind::Sketch
        } else if of_painting.is_some() && of_painting > of_look.max(of_scene) {
            DocumentKind::Painting
        } else if of_scene.is_some() && of_scene > of_look {
            DocumentKind::Scene
        } else {
            DocumentKind::Look
        }
    }

    /// The document whose step redo would repeat.
    pub(super) fn next(self) -> DocumentKind {
        let of_scene = self.scene.and_then(|scene| scene.document.times.next());
        let of_look = self.look.history.redo_label().and(self.look.times.next());
        let of_painting = self.painting.and_then(|work| work.document.times.next());
        let of_sketch = self.sketch.and_then(|sketch| sketch.times.next());
        let all = [
            (of_look, DocumentKind::Look),
            (of_scene, DocumentKind::Scene),
            (self.shot.and_then(|shot| shot.document.times.next()), DocumentKind::Shot),
            (of_painting, DocumentKind::Painting),
            (of_sketch, DocumentKind::Sketch),
            (self.masks.times.next(), DocumentKind::Mask),
            (self.shelf.times.next(), DocumentKind::Shelf),
        ];
        let there = all.into_iter().filter_map(|(time, of)| Some((time?, of)));
        there.min_by_key(|(time, _)| *time).map_or(DocumentKind::Look, |(_, of)| of)
    }

    /// Time of the last step, where that is one of look and scene alike.
    fn joint_last(self) -> Option<StepTime> {
        let of_scene = self.scene?.document.times.last();
        joint(self.look.times.last(), of_scene)
    }

    /// Time of the next step to redo, where that is one of look and scene alike.
    fn joint_next(self) -> Option<StepTime> {
        let of_scene = self.scene?.document.times.next();
        joint(self.look.times.next(), of_scene)
    }

    /// Label of the step that undo would take back.
    pub fn undo_label(self) -> Option<&'a str> {
        match self.last() {
            DocumentKind::Look => {
                let named = self.look.times.last().and_then(|time| self.named.get(&time));
                named.map(String::as_str).or_else(|| self.look.history.undo_label())
            }
            DocumentKind::Scene => self.scene?.history().undo_label(),
            DocumentKind::Shot => self.shot?.document.history.undo_label(),
            DocumentKind::Painting => self.painting?.history().undo_label(),
            DocumentKind::Sketch => self.sketch?.undo_label(),
            DocumentKind::Mask => self.masks.undo_label(),
            DocumentKind::Shelf => self.shelf.undo_label(),
        }
    }

    /// Label of the step that redo would repeat.
    pub fn redo_label(self) -> Option<&'a str> {
        match self.next() {
            DocumentKind::Look => {
                let named = self.look.times.next().and_then(|time| self.named.get(&time));
                named.map(String::as_str).or_else(|| self.look.history.redo_label())
            }
            DocumentKind::Scene => self.scene?.history().redo_label(),
            DocumentKind::Shot => self.shot?.document.history.redo_label(),
            DocumentKind::Painting => self.painting?.history().redo_label(),
            DocumentKind::Sketch => self.sketch?.redo_label(),
            DocumentKind::Mask => self.masks.redo_label(),
            DocumentKind::Shelf => self.shelf.redo_label(),
        }
    }

    /// Labels of all steps, the first one first.
    pub fn labels(self) -> impl Iterator<Item = &'a str> {
        let named = |(time, label): ((bool, StepTime), &'a str)| {
            (time, self.named.get(&time.1).map_or(label, String::as_str))
        };
        let of_look = self.look.times.all().zip(self.look.history.labels());
        let mut steps: Vec<((bool, StepTime), &str)> = of_look.map(named).collect();
        if let Some(scene) = self.scene {
            // Steps of the same time are from journals: the scene's are older.
            let of_scene = scene.document.times.all().zip(scene.history().labels());
            steps.splice(0..0, of_scene);
        }
        if let Some(shot) = self.shot {
            steps.splice(0..0, shot.document.times.all().zip(shot.document.history.labels()));
        }
        if let Some(work) = self.painting {
            steps.splice(0..0, work.document.times.all().zip(work.history().labels()));
        }
        if let Some(sketch) = self.sketch {
            let labels = sketch.labels().map(|label| -> &str { label });
            steps.extend(sketch.times.all().zip(labels));
        }
        let of_masks = self.masks.labels().map(|label| -> &str { label });
        steps.extend(self.masks.times.all().zip(of_masks));
        steps.extend(self.shelf.times.all().zip(self.shelf.labels()));
        steps.sort_by_key(|(time, _)| *time);
        // What look and scene did at once is one step.
        steps.dedup_by(|(time, _), (before, _)| time == before && is_known(time.1));
        steps.into_iter().map(|(_, label)| label)
    }

    /// Number of steps that are done.
    pub fn done(self) -> usize {
        let of_scene = self.scene.map_or(0, |scene| scene.history().place());
        let of_painting = self.painting.map_or(0, |work| work.history().place());
        let of_sketch = self.sketch.map_or(0, Sketch::place);
        let of_shot = self.shot.map_or(0, |shot| shot.document.history.place());
        let of_masks = self.masks.place();
        let all = self.look.history.place() + of_scene + of_shot + of_painting + of_sketch;
        all + of_masks + self.shelf.place() - self.joint()
    }

    /// Number of done steps that are of look and scene alike.
    fn joint(self) -> usize {
        let Some(scene) = self.scene else { return 0 };
        let done = |times: &Times| -> Vec<StepTime> {
            let done = times.all().filter(|(is_undone, _)| !is_undone).map(|(_, time)| time);
            done.filter(|time| is_known(*time)).collect()
        };
        let (of_look, of_scene) = (done(&self.look.times), done(&scene.document.times));
        // Times grow from step to step.
        of_scene.iter().filter(|time| of_look.binary_search(time).is_ok()).count()
    }
}

/// True for steps of this window: those from journals have no time of their own.
fn is_known(time: StepTime) -> bool {
    time != StepTime::default()
}

/// The time that two documents' steps have both.
fn joint(one: Option<StepTime>, two: Option<StepTime>) -> Option<StepTime> {
    one.filter(|time| two == Some(*time) && is_known(*time))
}

/// The other one of look and scene.
fn other_of(of: DocumentKind) -> Option<DocumentKind> {
    match of {
        DocumentKind::Look => Some(DocumentKind::Scene),
        DocumentKind::Scene => Some(DocumentKind::Look),
        DocumentKind::Shot
        | DocumentKind::Painting
        | DocumentKind::Sketch
        | DocumentKind::Mask
        | DocumentKind::Shelf => None,
    }
}

/// Common order of undo for the look, the scene, the painting and the sketch on the picture.
impl Session {
    /// Notes that a step of the look was done: its time is taken, and gestures of the scene and the
    /// painting end.
    pub(super) fn step_done(&mut self) {
        self.revisions.step.advance();
        if let Some(open_scene) = &mut self.open_scene {
            open_scene.end_gesture();
        }
        if let Some(work) = &mut self.painting {
            work.end_gesture();
        }
    }

    /// Remembers the times of the look's steps, before another look comes.
    pub(super) fn remember_times(&mut self) {
        let times = std::mem::take(&mut self.look.times);
        if let (Some(open_scene), Some(path)) = (&mut self.open_scene, &self.look.path) {
            open_scene.left.insert(real(path), times);
        }
    }

    /// Restores the remembered times of the steps of a look that a journal brought back.
    pub(super) fn recall_times(&mut self) {
        if let (Some(open_scene), Some(path)) = (&mut self.open_scene, &self.look.path) {
            self.look.times = open_scene.left.remove(&real(path)).unwrap_or_default();
        }
        self.look.times.fit(self.look.history.steps());
    }

    /// Steps of all open documents, in the order in which they were done.
    pub fn steps(&self) -> Steps<'_> {
        Steps {
            look: &self.look,
            scene: self.open_scene.as_ref(),
            shot: self.shot(),
            painting: self.painting.as_ref().filter(|_| !self.hides_painting),
            sketch: Some(&self.sketchbook.sketch).filter(|sketch| sketch.is_open),
            masks: &self.masks,
            shelf: &self.shelf,
            named: &self.named_steps,
        }
    }

    /// Takes back the last step, of whichever document; of look and scene, where it is of both.
    pub fn undo(&mut self) -> bool {
        let steps = self.steps();
        let (of, is_joint) = (steps.last(), steps.joint_last().is_some());
        let did = self.undo_in(of);
        if let Some(other) = other_of(of).filter(|_| is_joint) {
            self.undo_in(other);
        }
        did
    }

    fn undo_in(&mut self, of: DocumentKind) -> bool {
        let before = self.open_scene().map(OpenScene::picture_revision);
        match (of, &mut self.open_scene, &mut self.painting) {
            (DocumentKind::Scene, Some(open_scene), _) => {
                let did = open_scene.undo();
                self.scene_was_edited(before);
                did
            }
            (DocumentKind::Shot, ..) => {
                let did = self.shot_mut().is_some_and(|shot| shot.document.undo());
                self.shot_was_edited(before, true);
                did
            }
            (DocumentKind::Painting, _, Some(work)) => {
                let did = work.undo();
                self.painting_changed();
                did
            }
            (DocumentKind::Sketch, ..) => self.sketchbook.sketch.undo(),
            (DocumentKind::Mask, ..) => {
                let found = self.masks.undo();
                self.bring_mask_back(found)
            }
            (DocumentKind::Shelf, ..) => {
                let did = self.shelf.undo();
                self.bring_pictures_along();
                self.keep_shelf();
                did
            }
            _ => self.undo_look(),
        }
    }

    /// Repeats the step that was last taken back.
    pub fn redo(&mut self) -> bool {
        let steps = self.steps();
        let (of, is_joint) = (steps.next(), steps.joint_next().is_some());
        let now = self.revisions.step.advance();
        let did = self.redo_in(of, now);
        if let Some(other) = other_of(of).filter(|_| is_joint) {
            self.redo_in(other, now);
        }
        did
    }

    fn redo_in(&mut self, of: DocumentKind, now: StepTime) -> bool {
        let before = self.open_scene().map(OpenScene::picture_revision);
        match (of, &mut self.open_scene, &mut self.painting) {
            (DocumentKind::Scene, Some(open_scene), _) => {
                let did = open_scene.redo(now);
                self.scene_was_edited(before);
                did
            }
            (DocumentKind::Shot, ..) => {
                let did = self.shot_mut().is_some_and(|shot| shot.document.redo(now));
                self.shot_was_edited(before, true);
                did
            }
            (DocumentKind::Painting, _, Some(work)) => {
                let did = work.redo(now);
                self.painting_changed();
                did
            }
            (DocumentKind::Sketch, ..) => self.sketchbook.sketch.redo(now),
            (DocumentKind::Mask, ..) => {
                let found = self.masks.redo(now);
                self.bring_mask_back(found)
            }
            (DocumentKind::Shelf, ..) => {
                let did = self.shelf.redo(now);
                self.bring_pictures_along();
                self.keep_shelf();
                did
            }
            _ => self.redo_look(now),
        }
    }

    /// Takes steps back or repeats them until `place` of them are done.
    pub fn go_to(&mut self, place: usize) {
        while self.steps().done() > place && self.undo() {}
        while self.steps().done() < place && self.redo() {}
    }
}
