//! Scene around the look: opened, begun, edited, saved and left.

use std::path::Path;

use chiaro_locale::tr;

use super::Session;
use crate::diag::Diagnostic;
use crate::document::{DocumentRevision, LoadedDocument, Object, Scene, SceneEdit};
use crate::examples;
use crate::files::journal::{JournalSlot, RecoveredWork};
use crate::ids::ObjectId;
use crate::state::document::journal::VIEW;
use crate::state::paths::absolute;
use crate::state::revision::GestureId;
use crate::state::scene::{LookToOpen, OPEN_LOOK, OpenScene, scene_of};

impl Session {
    /// The scene around the look, if there is one.
    pub fn open_scene(&self) -> Option<&OpenScene> {
        self.open_scene.as_ref()
    }

    pub(crate) fn open_scene_mut(&mut self) -> Option<&mut OpenScene> {
        self.open_scene.as_mut()
    }

    /// Opens a scene around a look that is still to be opened: see
    /// [`look_to_open`](Self::look_to_open).
    pub(super) fn load_scene(
        &mut self,
        path: &Path,
        loaded: LoadedDocument<Scene>,
    ) -> Result<(), Vec<Diagnostic>> {
        self.set_scene(OpenScene::opened(path, loaded)?);
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
        self.start_scene_around(scene, &text, name);
    }

    /// Begins a new scene around a new look of a text, which its objects wear as the open one.
    pub(crate) fn start_scene_around(&mut self, scene: Scene, text: &str, name: &str) {
        self.start_from(text, name);
        self.open_scene = Some(OpenScene::unsaved(scene));
        self.keep_scene();
        self.scene_changed();
        self.reset_view();
        self.view.time = 0.0;
    }

    /// Takes back a scene that a journal gave, in place of the open documents. The journal goes on
    /// in its slot.
    pub(crate) fn take_back_scene(&mut self, found: RecoveredWork<Scene>, slot: JournalSlot) {
        let view = found.about.window.get(VIEW).cloned();
        self.set_scene(OpenScene::taken_back(found));
        self.journals.view = view;
        if let Some(open_scene) = &mut self.open_scene {
            open_scene.begin_journal(Some(slot));
        }
    }

    /// Puts the open documents aside for a scene, around a new look to begin with.
    pub(super) fn set_scene(&mut self, open_scene: OpenScene) {
        self.leave_journal(false);
        self.leave_scene(false);
        self.open_scene = Some(open_scene);
        self.keep_scene();
        self.replace_with_new();
        if let Some(path) =
            self.open_scene.as_ref().and_then(|open_scene| open_scene.path().map(Path::to_path_buf))
        {
            self.use_project(&path);
        }
        self.scene_changed();
        self.reset_view();
        self.view.time = 0.0;
    }

    /// The look that the scene lacks: the one that was open in it, or else one that an object
    /// wears. `None` where the open look is of the scene.
    pub(crate) fn look_to_open(&mut self) -> Option<LookToOpen> {
        let awaits_nodes = self.project.reader.is_awaited();
        let open_scene = self.open_scene.as_mut()?;
        match open_scene.wanted.take() {
            Some(LookToOpen::File(path)) if open_scene.wears(&path) => Some(LookToOpen::File(path)),
            Some(LookToOpen::Unsaved) if open_scene.wears_unsaved() => Some(LookToOpen::Unsaved),
            _ => open_scene.look_to_open(awaits_nodes).map(LookToOpen::File),
        }
    }

    /// Puts a scene around the look, which was alone so far: one object on the mesh that the look
    /// is seen on.
    pub(crate) fn begin_scene(&mut self) {
        if self.open_scene.is_some() {
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
        self.open_scene = Some(OpenScene::unsaved(scene_of(&orbit, look)));
        self.keep_scene();
        self.scene_changed();
        if self.look.path.is_none() {
            self.begin_journal(None);
        }
    }

    /// Puts the scene aside; its journal stays if any change in it is not saved. The look stays
    /// open.
    pub(crate) fn leave_scene(&mut self, in_peace: bool) {
        if let Some(mut open_scene) = self.open_scene.take() {
            open_scene.leave_journal(in_peace);
            // Without a shot over it an example is the beginning of a look that no file holds yet.
            self.look.path = self.look.path.take().filter(|path| examples::file(path).is_none());
            self.keep_solo();
            self.revisions.picture.advance();
            self.revisions.problems.advance();
        }
    }

    /// Puts the scene aside, unless it wears the look of this file, or the one that has none.
    pub(super) fn leave_scene_unless_worn(&mut self, look: Option<&Path>) {
        let is_worn = |open_scene: &OpenScene| {
            look.map_or(open_scene.wears_unsaved(), |look| open_scene.wears(look))
        };
        if !self.open_scene.as_ref().is_some_and(is_worn) {
            self.leave_scene(false);
        }
    }

    pub(super) fn keep_scene(&mut self) {
        if let (Some(open_scene), Some((folder, wake))) =
            (&mut self.open_scene, &self.journals.folder)
        {
            open_scene.keep_in(folder, wake.clone());
        }
    }

    /// Brings the picture's part of the scene up to date.
    pub(super) fn scene_changed(&mut self) {
        self.revisions.picture.advance();
        self.sync_scene();
    }

    /// Brings the scene up to date after an edit of it, or of the shot over it. The picture, which
    /// was that of the revision `before`, stays where the edit is an annotation.
    pub(super) fn scene_was_edited(&mut self, before: Option<DocumentRevision>) {
        if self.open_scene().map(OpenScene::picture_revision) != before {
            self.revisions.picture.advance();
        }
        self.sync_scene();
    }

    pub(super) fn sync_scene(&mut self) {
        if self.shot().is_some() {
            self.resolve_shot();
            self.revisions.problems.advance();
        } else if let Some(open_scene) = &mut self.open_scene {
            open_scene.sync(
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
        self.view.solo.keep(self.look.document(), self.open_scene.as_ref().map(OpenScene::scene));
    }

    /// Applies an edit of the scene. Consecutive edits of the same `gesture` are one step.
    ///
    /// # Errors
    /// A diagnostic where the edit is impossible; nothing is changed then.
    pub fn apply_to_scene(
        &mut self,
        edit: SceneEdit,
        gesture: Option<GestureId>,
    ) -> Result<(), Box<Diagnostic>> {
        if self.shot().is_some() {
            return self.apply_scene_to_shot(edit, gesture);
        }
        let Some(open_scene) = &mut self.open_scene else {
            return Err(Box::new(Diagnostic::error("impossible-edit", tr!("no scene is open"))));
        };
        self.revisions.step.advance();
        let before = Some(open_scene.picture_revision());
        if open_scene.apply(edit, gesture, self.revisions.step)? {
            self.look.end_gesture();
            self.scene_was_edited(before);
        }
        Ok(())
    }

    /// Makes the present view the scene's, in a picture of such an aspect, width over height; of a
    /// shot, its own camera, which the picture follows again. Lights that were turned by hand over
    /// a shot stay so, and the shot's stay as they are.
    ///
    /// # Errors
    /// No scene is open.
    pub(crate) fn keep_view(&mut self, aspect: f64) -> Result<(), Box<Diagnostic>> {
        let before = self.open_scene().map(|open_scene| open_scene.scene().camera);
        let with_lights = self.shot().is_none();
        let edit = self.view.as_scene_edit(&before.unwrap_or_default(), aspect, with_lights);
        self.apply_to_scene(edit, None)?;
        let turned = self.lights_of_shot().map(|_| self.view.orbit.illumination);
        self.show_shot_at_time(true);
        if let Some(turned) = turned {
            self.view.orbit.illumination = turned;
        }
        Ok(())
    }

    /// Saves the scene to a file, which is its own from then on.
    ///
    /// # Errors
    /// A diagnostic with the reason; the old file is then unchanged.
    pub fn save_scene_as(&mut self, path: &Path) -> Result<(), Box<Diagnostic>> {
        if self.shot().is_some() {
            return self.save_shot_as(path);
        }
        let nodes = self.node_folders();
        if let Some(open_scene) = &mut self.open_scene {
            let is_own = open_scene.path() == Some(path);
            open_scene.save_as(path)?;
            if is_own {
                self.sync_scene();
            } else if self.node_folders() == nodes {
                self.scene_changed();
            } else {
                // Another folder is another project.
                self.reload_library();
            }
        }
        Ok(())
    }

    /// Renames the open look in the scene after it was saved to another file; `change` does what
    /// else the objects need that wear it.
    pub(super) fn wear_saved(&mut self, path: &Path, change: &dyn Fn(&mut Object)) {
        let edit = self
            .open_scene
            .as_ref()
            .and_then(|open_scene| open_scene.rename_open(&open_scene.name_of(path), change));
        if let Some(edit) = edit {
            // An object that exists can be changed; where that fails, the scene stays unchanged.
            let _ = self.apply_to_scene(edit, None);
        }
        self.scene_changed();
    }

    /// Selects an object, or none.
    pub fn select_object(&mut self, id: Option<ObjectId>) {
        if let Some(open_scene) = &mut self.open_scene {
            open_scene.select(id.filter(|id| open_scene.scene().objects.contains_key(id)));
        }
    }

    /// Turns camera and lights as the scene has them, or to their defaults without a scene.
    pub(crate) fn reset_view(&mut self) {
        self.view.reset(self.open_scene.as_ref());
        self.show_shot_at_time(true);
    }

    /// Brings an object into view, or all of them; the direction stays. `aspect` is the picture's
    /// width over its height.
    pub(crate) fn frame(&mut self, only: Option<&ObjectId>, aspect: f64) {
        self.view.frame(self.open_scene.as_ref(), only, aspect);
    }

    /// Brings all objects of a scene without a camera into view, once they are found. Returns true
    /// if that turned the camera.
    pub(crate) fn frame_without_camera(&mut self, aspect: f64) -> bool {
        let open_scene = self.open_scene.as_ref().filter(|open_scene| open_scene.shot.is_none());
        self.view.frame_without_camera(open_scene, aspect)
    }

    /// Takes another program's text of the scene's file, as one step. Returns true if it could be
    /// read without an error.
    pub(crate) fn reload_scene(&mut self, text: &str) -> bool {
        if self.shot().is_some() {
            return self.reload_shot(text);
        }
        self.revisions.step.advance();
        let Some(open_scene) = &mut self.open_scene else { return false };
        let is_read = open_scene.reload(text, self.revisions.step);
        self.scene_changed();
        is_read
    }

    /// Forgets the problems of the scene's file, or of the shot's over it: another program has
    /// written what was read before.
    pub(crate) fn scene_is_whole(&mut self) {
        let Some(open_scene) = &mut self.open_scene else { return };
        match &mut open_scene.shot {
            Some(shot) => shot.document.load_problems.clear(),
            None => open_scene.document.load_problems.clear(),
        }
        self.revisions.problems.advance();
    }
}
