//! Scene around the look, and one order of undo for both, the painting and the sketch.

use std::path::Path;

use super::Session;
use crate::diag::Diagnostic;
use crate::document::{Light, Loaded, Scene, SceneEdit};
use crate::examples;
use crate::files::journal::{Recovered, Slot};
use crate::ids::{LightId, ObjectId};
use crate::state::document::journal::VIEW;
use crate::state::painting::work::OpenPainting;
use crate::state::paths::absolute;
use crate::state::scene::{LookToOpen, OPEN_LOOK, OpenScene, real, scene_of};

/// Document that a step belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum DocumentKind {
    Look,
    Scene,
    Painting,
    Sketch,
}

impl Session {
    /// The scene around the look, if there is one.
    pub fn stage(&self) -> Option<&OpenScene> {
        self.stage.as_ref()
    }

    pub(crate) fn stage_mut(&mut self) -> Option<&mut OpenScene> {
        self.stage.as_mut()
    }

    /// The light of an id in the picture of the look: a scene's light stands in place of the
    /// look's, and the look's keys move either.
    pub(crate) fn light(&self, id: &LightId) -> Option<&Light> {
        let own = self.look().lights.get(id)?;
        Some(self.keyed_now().lights.get(id).or_else(|| self.light_of_scene(id)).unwrap_or(own))
    }

    /// The scene's light that stands in place of the look's.
    pub(crate) fn light_of_scene(&self, id: &LightId) -> Option<&Light> {
        self.stage.as_ref()?.scene().lights.get(id)
    }

    /// Opens a scene around a look that is still to be opened: see
    /// [`look_to_open`](Self::look_to_open).
    pub(super) fn open_scene(
        &mut self,
        path: &Path,
        loaded: Loaded<Scene>,
    ) -> Result<(), Vec<Diagnostic>> {
        self.set_stage(OpenScene::opened(path, loaded)?);
        Ok(())
    }

    /// Begins a new scene from an example's, around a new look made from one that an object wears.
    pub(crate) fn start_scene(&mut self, mut scene: Scene, name: &str) {
        let worn = || scene.objects.values().flat_map(|object| object.looks.values());
        let Some((first, text)) =
            worn().find_map(|look| Some((look.clone(), examples::text(Path::new(look))?)))
        else {
            return;
        };
        let wear = scene.objects.values_mut().flat_map(|object| object.looks.values_mut());
        wear.filter(|look| **look == first).for_each(|look| OPEN_LOOK.clone_into(look));
        self.start_from(&text, name);
        self.stage = Some(OpenScene::unsaved(scene));
        self.keep_stage();
        self.stage_changed();
        self.reset_view();
        self.view.time = 0.0;
    }

    /// Takes back a scene that a journal gave, in place of the open documents. The journal goes on
    /// in its slot.
    pub(crate) fn take_back_scene(&mut self, found: Recovered<Scene>, slot: Slot) {
        let view = found.about.window.get(VIEW).cloned();
        self.set_stage(OpenScene::taken_back(found));
        self.journals.view = view;
        if let Some(stage) = &mut self.stage {
            stage.begin_journal(Some(slot));
        }
    }

    /// Puts the open documents aside for a scene, around a new look to begin with.
    fn set_stage(&mut self, stage: OpenScene) {
        self.leave_journal(false);
        self.leave_stage(false);
        self.stage = Some(stage);
        self.keep_stage();
        self.replace_with_new();
        if let Some(path) =
            self.stage.as_ref().and_then(|stage| stage.path().map(Path::to_path_buf))
        {
            self.use_project(&path);
        }
        self.stage_changed();
        self.reset_view();
        self.view.time = 0.0;
    }

    /// The look that the scene lacks: the one that was open in it, or else one that an object
    /// wears. `None` where the open look is of the scene.
    pub(crate) fn look_to_open(&mut self) -> Option<LookToOpen> {
        let stage = self.stage.as_mut()?;
        match stage.wanted.take() {
            Some(LookToOpen::File(path)) if stage.wears(&path) => Some(LookToOpen::File(path)),
            Some(LookToOpen::Unsaved) if stage.wears_unsaved() => Some(LookToOpen::Unsaved),
            _ => stage.look_to_open().map(LookToOpen::File),
        }
    }

    /// Puts a scene around the look, which was alone so far: one object on the mesh that the look
    /// is seen on.
    pub(crate) fn begin_stage(&mut self) {
        if self.stage.is_some() {
            return;
        }
        let look = match self.path() {
            Some(path) => absolute(path).to_string_lossy().into_owned(),
            None => OPEN_LOOK.to_owned(),
        };
        let mut orbit = self.view.orbit.clone();
        // The scene may be saved elsewhere than the working folder, so the mesh needs a whole path.
        if !orbit.mesh.starts_with(crate::frame::SHAPE_PREFIX)
            && let Ok(path) = std::path::absolute(&orbit.mesh)
        {
            orbit.mesh = path.to_string_lossy().into_owned();
        }
        self.stage = Some(OpenScene::unsaved(scene_of(&orbit, look)));
        self.keep_stage();
        self.stage_changed();
        if self.look.path.is_none() {
            self.begin_journal(None);
        }
    }

    /// Puts the scene aside; its journal stays if any change in it is not saved. The look stays
    /// open.
    pub(crate) fn leave_stage(&mut self, in_peace: bool) {
        if let Some(mut stage) = self.stage.take() {
            stage.leave_journal(in_peace);
            self.keep_solo();
            self.revisions.picture.advance();
            self.revisions.problems.advance();
        }
    }

    /// Puts the scene aside, unless it wears the look of this file, or the one that has none.
    pub(super) fn leave_stage_unless_worn(&mut self, look: Option<&Path>) {
        let is_worn =
            |stage: &OpenScene| look.map_or(stage.wears_unsaved(), |look| stage.wears(look));
        if !self.stage.as_ref().is_some_and(is_worn) {
            self.leave_stage(false);
        }
    }

    pub(super) fn keep_stage(&mut self) {
        if let (Some(stage), Some((folder, wake))) = (&mut self.stage, &self.journals.folder) {
            stage.keep_in(folder, wake.clone());
        }
    }

    /// Brings the picture's part of the scene up to date.
    pub(super) fn stage_changed(&mut self) {
        self.revisions.picture.advance();
        if let Some(stage) = &mut self.stage {
            stage.sync(
                self.look.path.as_deref(),
                &self.project.library,
                &**self.assets.source(),
                self.revisions.picture,
            );
            self.revisions.problems.advance();
        }
        self.keep_solo();
    }

    /// Forgets solos of layers and lights that no longer exist.
    pub(super) fn keep_solo(&mut self) {
        self.view.solo.keep(self.look.document(), self.stage.as_ref().map(OpenScene::scene));
    }

    /// Applies an edit of the scene. Consecutive edits by the same `hand` are one step.
    ///
    /// # Errors
    /// A diagnostic where the edit is impossible; nothing is changed then.
    pub fn apply_to_scene(
        &mut self,
        edit: SceneEdit,
        hand: Option<u64>,
    ) -> Result<(), Box<Diagnostic>> {
        let Some(stage) = &mut self.stage else {
            return Err(Box::new(Diagnostic::error("impossible-edit", "no scene is open")));
        };
        self.revisions.step += 1;
        if stage.apply(edit, hand, self.revisions.step)? {
            self.look.end_gesture();
            self.stage_changed();
        }
        Ok(())
    }

    /// Saves the scene to a file, which is its own from then on.
    ///
    /// # Errors
    /// A diagnostic with the reason; the old file is then unchanged.
    pub fn save_scene_as(&mut self, path: &Path) -> Result<(), Box<Diagnostic>> {
        let nodes = self.node_folders();
        if let Some(stage) = &mut self.stage {
            stage.save_as(path)?;
            if self.node_folders() == nodes {
                self.stage_changed();
            } else {
                // Another folder is another project.
                self.reload_library();
            }
        }
        Ok(())
    }

    /// Renames the open look in the scene after it was saved to another file.
    pub(super) fn wear_saved(&mut self, path: &Path) {
        let edit = self.stage.as_ref().and_then(|stage| stage.rename_open(&stage.name_of(path)));
        if let Some(edit) = edit {
            // An object that exists can be changed; where that fails, the scene stays unchanged.
            let _ = self.apply_to_scene(edit, None);
        }
        self.stage_changed();
    }

    /// Selects an object, or none.
    pub fn select_object(&mut self, id: Option<ObjectId>) {
        if let Some(stage) = &mut self.stage {
            stage.select(id.filter(|id| stage.scene().objects.contains_key(id)));
        }
    }

    /// Turns camera and lights as the scene has them, or to their defaults without a scene.
    pub(crate) fn reset_view(&mut self) {
        let Some(stage) = &self.stage else { return self.view.orbit.reset() };
        let scene = stage.scene();
        self.view.orbit.look_from(&scene.camera);
        let illumination = glam::DQuat::from_array(scene.illumination);
        self.view.orbit.illumination = if illumination.length_squared() > 1e-18 {
            illumination.normalize()
        } else {
            glam::DQuat::IDENTITY
        };
        self.view.orbit.backdrop = None;
    }

    /// The edit that sets the scene's camera, lights and backdrop to the present view.
    pub(crate) fn view_as_edit(&self) -> SceneEdit {
        let camera = SceneEdit::SetCamera { camera: self.view.orbit.camera() };
        let mut edits = vec![
            camera,
            SceneEdit::SetIllumination { rotation: self.view.orbit.illumination.to_array() },
        ];
        edits.extend(
            self.view.orbit.backdrop.map(|color| SceneEdit::SetBackdrop { color: Some(color) }),
        );
        SceneEdit::Group { edits }
    }

    /// Brings an object into view, or all of them; the direction stays. `aspect` is the picture's
    /// width over its height.
    pub(crate) fn frame(&mut self, only: Option<&ObjectId>, aspect: f64) {
        match self.stage.as_ref().map(|stage| stage.sphere(only)) {
            None => self.view.orbit.frame_object(),
            Some(Some((center, radius))) => self.view.orbit.frame(center, radius, aspect),
            Some(None) => {}
        }
    }

    /// The sphere that needles of lights stand on: around the selected object, or else the first,
    /// that wears the open look.
    pub(crate) fn ball(&self) -> (glam::DVec3, f64) {
        let unit = (glam::DVec3::ZERO, 1.0);
        let Some(stage) = &self.stage else { return unit };
        let selected = stage.selected().filter(|(_, object)| stage.wears_open(object));
        let objects = stage.scene().objects.iter().filter(|(_, object)| object.visible);
        let worn =
            selected.or_else(|| objects.into_iter().find(|(_, object)| stage.wears_open(object)));
        worn.and_then(|(id, _)| stage.sphere(Some(id))).unwrap_or(unit)
    }

    /// Takes another program's text of the scene's file, as one step. Returns true if it could be
    /// read without an error.
    pub(crate) fn reload_scene(&mut self, text: &str) -> bool {
        self.revisions.step += 1;
        let Some(stage) = &mut self.stage else { return false };
        let is_read = stage.reload(text, self.revisions.step);
        self.stage_changed();
        is_read
    }
}

/// Common order of undo for the look, the scene, the painting and the sketch on the picture.
impl Session {
    /// Notes that a step of the look was done.
    pub(super) fn step_done(&mut self) {
        self.revisions.step += 1;
        if let Some(stage) = &mut self.stage {
            stage.end_gesture();
        }
        if let Some(work) = &mut self.painting {
            work.end_gesture();
        }
    }

    /// Remembers the times of the look's steps, before another look comes.
    pub(super) fn remember_times(&mut self) {
        let times = std::mem::take(&mut self.look.times);
        if let (Some(stage), Some(path)) = (&mut self.stage, &self.look.path) {
            stage.left.insert(real(path), times);
        }
    }

    /// Restores the remembered times of the steps of a look that a journal brought back.
    pub(super) fn recall_times(&mut self) {
        if let (Some(stage), Some(path)) = (&mut self.stage, &self.look.path) {
            self.look.times = stage.left.remove(&real(path)).unwrap_or_default();
        }
        self.look.times.fit(self.look.history.steps());
    }

    /// The painting, where the open look shows it.
    fn seen_painting(&self) -> Option<&OpenPainting> {
        self.painting().filter(|_| !self.hides_painting)
    }

    /// The document whose step undo would take back.
    fn last(&self) -> DocumentKind {
        let of_look = self.look.history.undo_label().and(self.look.times.last());
        let of_scene = self.stage.as_ref().and_then(|stage| stage.document.times.last());
        let of_painting = self.seen_painting().and_then(|work| work.document.times.last());
        let of_sketch =
            self.sketchbook.sketch.is_open.then(|| self.sketchbook.sketch.times.last()).flatten();
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
    fn next(&self) -> DocumentKind {
        let of_scene = self.stage.as_ref().and_then(|stage| stage.document.times.next());
        let of_look = self.look.history.redo_label().and(self.look.times.next());
        let of_painting = self.seen_painting().and_then(|work| work.document.times.next());
        let of_sketch =
            self.sketchbook.sketch.is_open.then(|| self.sketchbook.sketch.times.next()).flatten();
        let of_sketch = (of_sketch, DocumentKind::Sketch);
        let all = [
            (of_look, DocumentKind::Look),
            (of_scene, DocumentKind::Scene),
            (of_painting, DocumentKind::Painting),
            of_sketch,
        ];
        let there = all.into_iter().filter_map(|(time, of)| Some((time?, of)));
        there.min_by_key(|(time, _)| *time).map_or(DocumentKind::Look, |(_, of)| of)
    }

    /// Label of the step that undo would take back.
    pub fn undo_label(&self) -> Option<&str> {
        match (self.last(), &self.stage, &self.painting) {
            (DocumentKind::Scene, Some(stage), _) => stage.history().undo_label(),
            (DocumentKind::Painting, _, Some(work)) => work.history().undo_label(),
            (DocumentKind::Sketch, ..) => self.sketchbook.sketch.undo_label(),
            _ => self.look.history.undo_label(),
        }
    }

    /// Label of the step that redo would repeat.
    pub fn redo_label(&self) -> Option<&str> {
        match (self.next(), &self.stage, &self.painting) {
            (DocumentKind::Scene, Some(stage), _) => stage.history().redo_label(),
            (DocumentKind::Painting, _, Some(work)) => work.history().redo_label(),
            (DocumentKind::Sketch, ..) => self.sketchbook.sketch.redo_label(),
            _ => self.look.history.redo_label(),
        }
    }

    /// Takes back the last step, of whichever document.
    pub fn undo(&mut self) -> bool {
        let of = self.last();
        match (of, &mut self.stage, &mut self.painting) {
            (DocumentKind::Scene, Some(stage), _) => {
                let did = stage.undo();
                self.stage_changed();
                did
            }
            (DocumentKind::Painting, _, Some(work)) => {
                let did = work.undo();
                self.painting_changed();
                did
            }
            (DocumentKind::Sketch, ..) => self.sketchbook.sketch.undo(),
            _ => self.undo_look(),
        }
    }

    /// Repeats the step that was last taken back.
    pub fn redo(&mut self) -> bool {
        let of = self.next();
        match (of, &mut self.stage, &mut self.painting) {
            (DocumentKind::Scene, Some(stage), _) => {
                self.revisions.step += 1;
                let did = stage.redo(self.revisions.step);
                self.stage_changed();
                did
            }
            (DocumentKind::Painting, _, Some(work)) => {
                self.revisions.step += 1;
                let did = work.redo(self.revisions.step);
                self.painting_changed();
                did
            }
            (DocumentKind::Sketch, ..) => {
                self.revisions.step += 1;
                self.sketchbook.sketch.redo(self.revisions.step)
            }
            _ => self.redo_look(),
        }
    }

    /// Labels of all steps, the first one first.
    pub fn steps(&self) -> impl Iterator<Item = &str> {
        let mut steps: Vec<((bool, u64), &str)> =
            self.look.times.all().zip(self.look.history.labels()).collect();
        if let Some(stage) = &self.stage {
            // Steps of the same time are from journals: the scene's are older.
            let of_scene = stage.document.times.all().zip(stage.history().labels());
            steps.splice(0..0, of_scene);
        }
        if let Some(work) = self.seen_painting() {
            steps.splice(0..0, work.document.times.all().zip(work.history().labels()));
        }
        if self.sketchbook.sketch.is_open {
            steps.extend(
                self.sketchbook
                    .sketch
                    .times
                    .all()
                    .zip(self.sketchbook.sketch.labels().map(|label| -> &str { label })),
            );
        }
        steps.sort_by_key(|(time, _)| *time);
        steps.into_iter().map(|(_, label)| label)
    }

    /// Number of steps that are done.
    pub fn place(&self) -> usize {
        let of_scene = self.stage.as_ref().map_or(0, |stage| stage.history().place());
        let of_painting = self.seen_painting().map_or(0, |work| work.history().place());
        let of_sketch =
            if self.sketchbook.sketch.is_open { self.sketchbook.sketch.place() } else { 0 };
        self.look.history.place() + of_scene + of_painting + of_sketch
    }

    /// Takes steps back or repeats them until `place` of them are done.
    pub fn go_to(&mut self, place: usize) {
        while self.place() > place && self.undo() {}
        while self.place() < place && self.redo() {}
    }
}
