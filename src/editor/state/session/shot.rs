//! Shot over the scene: opened, shown at the present time, and edited in place of the look and the
//! scene under it.

use std::path::Path;
use std::sync::Arc;

use chiaro_locale::{tr, trn};
use glam::DVec3;
use serde_json::Value as Json;

use super::Session;
use crate::diag::Diagnostic;
use crate::document::{
    BlendKind, ColorSpace, DocumentRevision, Edit, LoadedDocument, Look, Override, SceneEdit, Shot,
    ShotEdit, Target, Value, keyed_target,
};
use crate::files::journal::{JournalSlot, RecoveredWork};
use crate::film::{color_space, color_text, value_before};
use crate::frame::{Assets, ResolvedShot, SetupLook, ValueChange};
use crate::ids::{NodeId, NodePath};
use crate::state::arrangement;
use crate::state::document::journal::VIEW;
use crate::state::keying::Owner;
use crate::state::reading::{LookWithLibrary, light_name};
use crate::state::revision::GestureId;
use crate::state::scene::{FileMotion, LookToOpen, OpenScene, real};
use crate::state::shot::{
    ChangedKind, ChangedOwner, LookUnderShot, OpenShot, ShotAddress, ShotWriter,
};
use crate::values;

/// Greatest distance from a frame at which the playhead is on it, in frames: fields round times to
/// milliseconds.
const NEAR_FRAME: f64 = 0.05;
/// Greatest number of keys that are told one by one.
const MOST_KEYS_TOLD: usize = 3;

impl Session {
    /// The shot over the scene, if one is open.
    pub fn shot(&self) -> Option<&OpenShot> {
        self.open_scene()?.shot.as_deref()
    }

    pub(crate) fn shot_mut(&mut self) -> Option<&mut OpenShot> {
        self.open_scene_mut()?.shot.as_deref_mut()
    }

    /// Opens a shot, around a look that is still to be opened.
    pub(super) fn load_shot(
        &mut self,
        path: &Path,
        loaded: LoadedDocument<Shot>,
    ) -> Result<(), Vec<Diagnostic>> {
        let shot = OpenShot::opened(&**self.assets.source(), path, loaded)?;
        self.set_scene(OpenScene::under(shot));
        self.show_first_frame();
        Ok(())
    }

    /// Begins a shot over the open scene, or with `is_over_shot` over the open shot where that has
    /// a file, as their files have them. The open look is opened again, under the shot.
    ///
    /// # Errors
    /// Problems that keep what would lie under the shot from being read; all stays open then.
    pub(crate) fn begin_shot(&mut self, is_over_shot: bool) -> Result<(), Vec<Diagnostic>> {
        let of_shot = self.shot().filter(|shot| is_over_shot && shot.has_file());
        let of_shot = of_shot.map(OpenShot::path);
        let beneath = of_shot.or_else(|| self.open_scene()?.path()).map(Path::to_path_buf);
        let Some(beneath) = beneath else {
            let message = tr!("a shot lies over the file of a scene, and there is none yet");
            return Err(vec![Diagnostic::error("impossible-edit", message)]);
        };
        let from = self.shot().filter(|shot| shot.has_file());
        let near = from.and_then(|shot| shot.path().parent()).map(Path::to_path_buf);
        let mut shot = OpenShot::begun(&**self.assets.source(), &beneath)?;
        shot.near = near;
        let look = self.path().map(|path| LookToOpen::File(path.to_path_buf()));
        self.set_scene(OpenScene::under(shot));
        if let Some(open_scene) = &mut self.open_scene {
            open_scene.wanted = look;
        }
        self.show_first_frame();
        Ok(())
    }

    /// Takes back a shot that a journal gave, in place of the open documents. The journal goes on
    /// in its slot.
    ///
    /// # Errors
    /// A problem that keeps what the shot changes from being read; the open documents stay then.
    pub(crate) fn take_back_shot(
        &mut self,
        found: RecoveredWork<Shot>,
        slot: JournalSlot,
    ) -> Result<(), Box<Diagnostic>> {
        let view = found.about.window.get(VIEW).cloned();
        let shot = OpenShot::taken_back(&**self.assets.source(), found).map_err(|problems| {
            let first = problems.into_iter().find(Diagnostic::is_error);
            Box::new(
                first.unwrap_or_else(|| Diagnostic::error("cannot-read", tr!("nothing is there"))),
            )
        })?;
        self.set_scene(OpenScene::under(shot));
        self.show_first_frame();
        self.journals.view = view;
        if let Some(shot) = self.shot_mut() {
            shot.begin_journal(Some(slot));
        }
        Ok(())
    }

    fn show_first_frame(&mut self) {
        let Some(shot) = self.shot() else { return };
        self.view.time = shot.rate().time(shot.stack().frames()[0]);
        self.show_shot_at_time(true);
    }

    /// Takes the look that was opened under the shot, as its file has it.
    pub(super) fn look_was_opened(&mut self, look: &Look) {
        let (source, folder) = (self.look.file.source.clone(), self.look.folder());
        let has_file = self.look.path.is_some();
        if let Some(shot) = self.shot_mut() {
            let look = look.clone();
            shot.look = has_file.then_some(LookUnderShot { look, source, folder });
        }
    }

    /// Moves the playhead, in seconds.
    pub fn set_time(&mut self, time: f64) {
        self.view.time = self.exact_time(time);
        self.show_shot_at_time(false);
    }

    /// A time as the open shot's frames have it, in seconds: the timeline and its fields round
    /// times.
    pub(crate) fn exact_time(&self, time: f64) -> f64 {
        let Some(shot) = self.shot() else { return time };
        let rate = shot.rate();
        let frame = (time * rate.per_second()).round();
        let is_near = (time * rate.per_second() - frame).abs() < NEAR_FRAME;
        if is_near { rate.time_within(frame) } else { time }
    }

    /// Brings scene and looks up to date with the shot over them.
    pub(super) fn resolve_shot(&mut self) {
        let Some(open_scene) = &mut self.open_scene else { return };
        let files = self.assets.source().clone();
        let path = self.look.path.as_deref();
        let revision = self.revisions.picture;
        let look = open_scene.resolve(path, &self.project.library, &*files, revision);
        let look = look.map(|mut look| {
            arrangement::place_nodes_of(&mut look, &self.project.catalog);
            look
        });
        if let Some(look) = look.filter(|look| look != self.look.document()) {
            self.look.history.amend(look, |_| {});
        }
        self.show_shot_at_time(false);
    }

    /// Shows the scene as the shot has moved it at the present time, and where the view follows the
    /// shot's camera, from there. `follows` lets the view follow from now on.
    pub(crate) fn show_shot_at_time(&mut self, follows: bool) {
        let time = self.view.time;
        let Some(shot) = self.shot() else { return };
        if shot.shown_at == Some(time) && !follows {
            return;
        }
        // Lights that were turned by hand stay so, whatever the camera does.
        let turned = shot.lights_turned_from(&self.view.orbit, time).filter(|_| !follows);
        let turned = turned.map(|_| self.view.orbit.illumination);
        let follows = follows || shot.is_camera_followed(&self.view.orbit);
        let of_file = follows.then(|| self.camera_of_file(time)).flatten();
        let Some(open_scene) = &mut self.open_scene else { return };
        open_scene.show_at(time);
        let Some(shot) = open_scene.shot.as_deref_mut() else { return };
        match follows {
            true => shot.look_from_camera(&mut self.view.orbit, time, of_file),
            false if turned.is_none() => shot.put_lights(&mut self.view.orbit, time),
            false => {}
        }
        if let Some(turned) = turned {
            self.view.orbit.illumination = turned;
        }
    }

    /// The turn of the lights that the shot has now, where the window shows another one.
    pub(crate) fn lights_of_shot(&self) -> Option<glam::DQuat> {
        self.shot()?.lights_turned_from(&self.view.orbit, self.view.time)
    }

    /// The camera that a mesh's file brings, where the scene asks for it and the mesh is read.
    fn camera_of_file(&self, time: f64) -> Option<crate::document::Camera> {
        self.open_scene()?.shot.as_ref()?.scene().file_camera.as_ref()?;
        Some(self.file_motion()?.camera_at(time))
    }

    /// The motion that meshes' files bring, once the meshes are read.
    pub(crate) fn file_motion(&self) -> Option<FileMotion> {
        if self.open_scene()?.placed.is_empty() {
            return None;
        }
        let mut snapshot = self.snapshot();
        snapshot.by_camera = true;
        let setup = snapshot.setup(&mut Assets::of(&self.assets)).ok()?.value;
        Some(FileMotion::of(setup))
    }

    /// Makes keys of the shot of the camera that a mesh's file moves, as one step: the picture of
    /// every frame is as before, and the path is edited in the shot from now on. The lens stays the
    /// file's.
    ///
    /// # Errors
    /// No camera of a file is seen, or the shot has too many frames.
    pub(crate) fn key_camera_of_file(&mut self) -> Result<(), Box<Diagnostic>> {
        let impossible = |message: String| Box::new(Diagnostic::error("impossible-edit", message));
        let motion = self.file_motion().filter(|motion| motion.camera.is_some());
        let (Some(motion), Some(shot)) = (motion, self.shot()) else {
            let message = tr!("the shot sees no camera of a file that moves");
            return Err(impossible(message.to_owned()));
        };
        let edit = shot.keyed_camera(|time| motion.camera_at(time)).ok_or_else(|| {
            let message = tr!("a camera of so many frames is not keyed: shorten the shot first");
            impossible(message.to_owned())
        })?;
        self.apply_to_shot(edit, None)
    }

    /// True if the picture is seen from the shot's camera.
    pub(crate) fn follows_shot(&self) -> bool {
        self.shot().is_some_and(|shot| shot.is_followed(&self.view.orbit))
    }

    /// Applies an edit of the look as overrides of the shot over it.
    pub(super) fn apply_look_to_shot(
        &mut self,
        edit: Edit,
        gesture: Option<GestureId>,
    ) -> Result<(), Box<Diagnostic>> {
        let is_structural = self.compilation.shaders.is_structural(&edit, self.look_with_library());
        self.compilation.shaders.touch(&edit);
        let mut after = self.look().clone();
        after.apply(edit)?;
        let file = self.path().map(Path::to_path_buf).unwrap_or_default();
        let refused = |problem: Diagnostic| Box::new(refusal(problem, &file));
        let open = self.selection.open_groups();
        let differences = self.look().differences_in(&after, open).map_err(refused)?;
        let Some(shot) = self.shot() else { return Ok(()) };
        let Some(look) = shot.open_look() else {
            let message = tr!("the look has no file yet, by which a shot could name it");
            return Err(Box::new(Diagnostic::error("not-of-a-shot", message)));
        };
        let present =
            crate::state::reading::LookWithLibrary { look: &after, ..self.look_with_library() };
        let value_of = |target: &str| present.own_value(&Target::parse(target)?);
        let mut writer = ShotWriter::new(shot, Some(look), self.view.time);
        writer.write(differences, &value_of).map_err(refused)?;
        let Some(edit) = writer.finish() else { return Ok(()) };
        self.apply_to_shot_document(edit, gesture, is_structural)
    }

    /// Applies an edit of the scene as overrides of the shot over it.
    pub(super) fn apply_scene_to_shot(
        &mut self,
        edit: SceneEdit,
        gesture: Option<GestureId>,
    ) -> Result<(), Box<Diagnostic>> {
        let Some((open_scene, shot)) = self.open_scene().zip(self.shot()) else { return Ok(()) };
        let before = open_scene.scene();
        let mut after = before.clone();
        after.apply(edit)?;
        let file = open_scene.path().map(Path::to_path_buf).unwrap_or_default();
        let refused = |problem: Diagnostic| Box::new(refusal(problem, &file));
        let mut differences = before.differences(&after).map_err(refused)?;
        let mut writer = ShotWriter::new(shot, None, self.view.time);
        if differences.iter().any(|it| it.target.starts_with("time.")) {
            writer.set_time(before.time, after.time);
            differences.retain(|it| !it.target.starts_with("time."));
        }
        if differences.iter().any(|it| it.target.starts_with("camera."))
            && writer.set_camera(&after)
        {
            differences.retain(|it| !it.target.starts_with("camera."));
        }
        let value_of = |target: &str| {
            let place = after.value_at(target).ok()?;
            serde_json::from_value::<Value>(place.value).ok()
        };
        writer.write(differences, &value_of).map_err(refused)?;
        let Some(edit) = writer.finish() else { return Ok(()) };
        self.apply_to_shot_document(edit, gesture, false)
    }

    /// Applies an edit of the shot. Consecutive edits of the same `gesture` are one step.
    ///
    /// # Errors
    /// A diagnostic where the edit is impossible; nothing is changed then.
    pub fn apply_to_shot(
        &mut self,
        edit: ShotEdit,
        gesture: Option<GestureId>,
    ) -> Result<(), Box<Diagnostic>> {
        self.apply_to_shot_document(edit, gesture, true)
    }

    fn apply_to_shot_document(
        &mut self,
        edit: ShotEdit,
        gesture: Option<GestureId>,
        is_structural: bool,
    ) -> Result<(), Box<Diagnostic>> {
        let now = self.revisions.step.next();
        let Some(shot) = self.shot_mut() else {
            return Err(Box::new(Diagnostic::error("impossible-edit", tr!("no shot is open"))));
        };
        let before = Some(shot.document.history.picture_revision());
        if shot.document.apply(edit, gesture, now)? {
            self.revisions.step.advance();
            if let Some(work) = &mut self.painting {
                work.end_gesture();
            }
            self.shot_was_edited(before, is_structural);
        }
        Ok(())
    }

    /// Brings everything up to date after the shot changed.
    fn shot_changed(&mut self, is_structural: bool) {
        self.shot_was_edited(None, is_structural);
    }

    /// Brings everything up to date after an edit of the shot. The picture, which was that of the
    /// revision `before`, stays where the edit is an annotation.
    pub(super) fn shot_was_edited(
        &mut self,
        before: Option<DocumentRevision>,
        is_structural: bool,
    ) {
        let look = self.look().clone();
        self.scene_was_edited(before);
        if *self.look() != look {
            self.revisions.meaning.advance();
            self.changed(is_structural);
        }
    }

    /// Takes the shot's own change of a value back, as a step.
    ///
    /// # Errors
    /// The shot does not change the value by itself.
    pub(crate) fn reset_in_shot(&mut self, at: &ShotAddress) -> Result<(), Box<Diagnostic>> {
        let Some(shot) = self.shot() else { return Ok(()) };
        let mut writer = ShotWriter::new(shot, at.look.clone(), self.view.time);
        writer.take_back(&at.target);
        let Some(edit) = writer.finish() else {
            let message =
                tr!("{shot} does not change `{value}`", shot = shot.name(), value = at.text());
            return Err(Box::new(Diagnostic::error("impossible-edit", message)));
        };
        self.apply_to_shot(edit, None)
    }

    /// Takes all changes of the shot back, as a step.
    ///
    /// # Errors
    /// No shot is open.
    pub(crate) fn reset_all_in_shot(&mut self) -> Result<(), Box<Diagnostic>> {
        let shot = self.shot().map(OpenShot::shot);
        let overrides = shot.map(|shot| shot.overrides.as_slice()).unwrap_or_default();
        let back = |it: &Override| ShotEdit::take_back(it.look.clone(), it.target.clone());
        let mut edits: Vec<ShotEdit> = overrides.iter().map(back).collect();
        if shot.is_some_and(|shot| shot.camera.is_some()) {
            edits.push(ShotEdit::SetShotCamera { camera: None });
        }
        self.apply_to_shot(ShotEdit::Group { edits }, None)
    }

    /// Keys all values that the shot itself changes at the present frame, as one step: those of the
    /// scene and of the open look.
    ///
    /// # Errors
    /// No shot is open.
    pub(crate) fn key_all_in_shot(&mut self) -> Result<(), Box<Diagnostic>> {
        self.refresh_keys();
        let mut edits = Vec::new();
        if let Some(shot) = self.shot() {
            let open = shot.open_look();
            let own = shot.resolved().changes.iter().filter(|it| it.stands && it.by == shot.path());
            for at in own.map(ShotAddress::of).filter(ShotAddress::can_move) {
                let is_seen = at.look.is_none() || at.look == open;
                let Some(value) = self.value_in_shot(&at).filter(|_| is_seen) else { continue };
                let mut writer = ShotWriter::new(shot, at.look.clone(), self.view.time);
                writer.add_key(&at.target, value, self.blend_at(&at));
                edits.extend(writer.finish());
            }
        }
        self.apply_to_shot(ShotEdit::Group { edits }, None)
    }

    /// Keys a value at the present frame, with its present value: the first key, or one more, which
    /// leaves the curve as it is.
    ///
    /// # Errors
    /// The value has none that could be keyed.
    pub(crate) fn key_in_shot(&mut self, at: &ShotAddress) -> Result<(), Box<Diagnostic>> {
        self.refresh_keys();
        let Some(value) = self.value_in_shot(at) else {
            let message = tr!("`{value}` has no value to key", value = at.text());
            return Err(Box::new(Diagnostic::error("impossible-edit", message)));
        };
        let Some(shot) = self.shot() else { return Ok(()) };
        let mut writer = ShotWriter::new(shot, at.look.clone(), self.view.time);
        writer.add_key(&at.target, value, self.blend_at(at));
        match writer.finish() {
            Some(edit) => self.apply_to_shot(edit, None),
            None => Ok(()),
        }
    }

    /// The present value at an address, as keys give it since they were last refreshed; of a look
    /// that is not open, what the shot sets.
    pub(super) fn value_in_shot(&self, at: &ShotAddress) -> Option<Value> {
        let shot = self.shot()?;
        match &at.look {
            None => {
                let of_keys = || {
                    let target = keyed_target(&at.target)?;
                    self.keys().of_scene()?.values().values.get(&target).cloned()
                };
                let own = || {
                    let place = self.open_scene()?.scene().value_at(&at.target).ok()?;
                    serde_json::from_value(place.value).ok()
                };
                // Keys of lights lie over their own values, which the scene has beneath.
                of_keys().or_else(own)
            }
            Some(_) if at.look == shot.open_look() => {
                let target = keyed_target(&at.target)?;
                self.keys().value_now(&target)
            }
            Some(_) => shot.own(at)?.value.clone(),
        }
    }

    /// The way in which a value goes from key to key.
    fn blend_at(&self, at: &ShotAddress) -> BlendKind {
        let place = match at.look {
            None => self.open_scene().and_then(|it| it.scene().value_at(&at.target).ok()),
            Some(_) => self.look().value_at(&at.target).ok(),
        };
        place.map_or(BlendKind::Numbers, |place| place.blend)
    }

    /// The change that a shot makes of a value of the open look or of the scene, by its target.
    pub(crate) fn change_by_shot(&self, owner: Owner, target: &str) -> Option<&ValueChange> {
        let shot = self.shot()?;
        let look = match owner {
            Owner::Look => Some(shot.open_look()?),
            Owner::Scene => None,
        };
        shot.resolved().change_of(look.as_deref(), target)
    }

    /// A look by its path as changes tell it; for values of the scene the open look, whose colors
    /// the fields of lights have.
    fn look_at(&self, look: Option<&str>) -> &Look {
        let closed = look.zip(self.open_scene()).and_then(|(path, open_scene)| {
            let is_it = |look: &&Arc<SetupLook>| {
                ResolvedShot::name_of_look(Path::new(look.source.file())) == path
            };
            open_scene.other_looks().find(is_it).map(|look| &look.look)
        });
        closed.unwrap_or(self.look())
    }

    /// A look of the scene that the open shot's file names.
    fn look_of_shot(&self, name: &str) -> Option<&Look> {
        let shot = self.shot()?;
        let file = shot.file_of_look(name);
        let is_it = |path: &str| real(Path::new(path)) == file;
        if shot.open_look().is_some_and(|open| is_it(&open)) {
            return Some(self.look());
        }
        let mut closed = self.open_scene()?.other_looks();
        closed.find(|look| is_it(look.source.file())).map(|look| &look.look)
    }

    /// Things that the shot changes nothing of yet, to which its changes of a lost thing can be
    /// moved, each with its display name: objects, or lights or nodes that have all the values.
    pub(crate) fn places_of_lost(&self, owner: ChangedOwner<'_>) -> Vec<(String, String)> {
        let Some(shot) = self.shot() else { return Vec::new() };
        let look = owner.look.and_then(|look| self.look_of_shot(look));
        if look.is_none() && owner.look.is_some() {
            return Vec::new();
        }
        let lights = look.map_or(&shot.scene().lights, |look| &look.lights);
        let base = look.map(|look| LookWithLibrary { look, ..self.look_with_library() });
        let all: Vec<(String, String)> = match (owner.kind, base) {
            (ChangedKind::Object, _) => {
                let ids = shot.scene().objects.keys();
                ids.map(|id| (id.to_string(), id.to_string())).collect()
            }
            (ChangedKind::Light, _) => {
                let named = lights.iter().map(|(id, light)| (id, light_name(id, light)));
                named.map(|(id, name)| (id.to_string(), name.to_owned())).collect()
            }
            (ChangedKind::Node, Some(base)) => {
                let ids = base.look.graph.nodes.keys();
                let title = |id: &NodeId| base.title_of_path(&NodePath::root(id.clone()));
                ids.map(|id| (id.to_string(), title(id))).collect()
            }
            (ChangedKind::Node, None) => Vec::new(),
        };
        let has = |id: &str, change: &Override| {
            let Some(target) = owner.moved(&change.target, id) else { return false };
            match base {
                None => shot.scene().value_at(&target).is_ok(),
                Some(base) => {
                    let is_known = Target::parse(&target).map(|it| base.port_at(&it).is_some());
                    base.look.value_at(&target).is_ok() && is_known.unwrap_or(true)
                }
            }
        };
        let fits = |(id, _): &(String, String)| {
            let is_free = shot.changes_of(ChangedOwner { id, ..owner }).next().is_none();
            let is_object = owner.kind == ChangedKind::Object;
            is_free && (is_object || shot.changes_of(owner).all(|change| has(id, change)))
        };
        all.into_iter().filter(fits).collect()
    }

    /// Saves the shot to a file, which is its own from then on.
    ///
    /// # Errors
    /// A diagnostic with the reason; the old file is then unchanged.
    pub fn save_shot_as(&mut self, path: &Path) -> Result<(), Box<Diagnostic>> {
        if let Some(shot) = self.shot_mut() {
            let is_own = shot.path() == path;
            shot.save_as(path)?;
            // A file with the same name and content is the same picture, and frames of it stay.
            if is_own {
                self.sync_scene();
            } else {
                self.scene_changed();
            }
        }
        Ok(())
    }

    /// Takes another program's text of the shot's file, as one step. Returns true if it could be
    /// read without an error.
    pub(crate) fn reload_shot(&mut self, text: &str) -> bool {
        self.revisions.step.advance();
        let now = self.revisions.step;
        let files = self.assets.source().clone();
        let Some(shot) = self.shot_mut() else { return false };
        let is_read = shot.reload(text, now);
        if is_read {
            shot.read_again(&*files);
        }
        self.shot_changed(true);
        is_read
    }

    /// Reads anew what lies under the shot.
    pub(super) fn read_under_shot(&mut self) {
        let files = self.assets.source().clone();
        if let Some(shot) = self.shot_mut() {
            shot.read_again(&*files);
            let source = shot.look.as_ref().map(|look| look.source.clone());
            let known = self.look.file.source.text();
            if let Some(source) = source.filter(|source| source.text() != known) {
                self.look.was_reloaded((*source).clone());
            }
            self.shot_changed(true);
        }
    }
}

/// A problem of an edit that no shot can say, with the file that has what was edited.
fn refusal(problem: Diagnostic, file: &Path) -> Diagnostic {
    if problem.code != "not-of-a-shot" {
        return problem;
    }
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let message = tr!("{problem}: open {name} to change that", problem = problem.message);
    Diagnostic { message, ..problem }.in_file(file.display().to_string())
}

/// Form in which a value is told, as fields have it.
#[derive(Clone, Copy, Debug, PartialEq)]
enum ToldForm {
    Plain,
    Color(ColorSpace),
    /// Angle, which files have in radians.
    Degrees,
    /// Rotation, which files have as a quaternion.
    Turn,
}

impl ToldForm {
    /// Form of a changed value that is no color.
    fn of(session: &Session, change: &ValueChange, look: &Look) -> Self {
        let target = change.target.as_str();
        if target == "illumination" || target.ends_with(".transform.rotate") {
            return Self::Turn;
        }
        let base = LookWithLibrary { look, ..session.look_with_library() };
        let port = Target::parse(target).and_then(|target| base.port_at(&target));
        match port {
            Some(port) if port.unit == "rad" => Self::Degrees,
            _ => Self::Plain,
        }
    }
}

/// The value before a change and the one after it, in words: colors as fields have them, keys with
/// their frames.
pub(crate) fn change_text(session: &Session, change: &ValueChange) -> (String, String) {
    let look = session.look_at(change.look.as_deref());
    let form = match color_space(change, look.color_space) {
        Some(space) => ToldForm::Color(space),
        None => ToldForm::of(session, change, look),
    };
    let told = |json: &Json| keys_text(json, form).unwrap_or_else(|| formed_text(json, form));
    let from = match value_before(change, look, &session.project.library) {
        Json::Null => tr!("default").to_owned(),
        from => told(&from),
    };
    (from, told(&change.to))
}

/// Keys in words, all of them where they are few; `None` for what are no keys.
fn keys_text(json: &Json, form: ToldForm) -> Option<String> {
    let keys = json.as_array().filter(|keys| keys.first().is_some_and(Json::is_object))?;
    let key = |key: &Json| {
        let value = formed_text(key.get("value")?, form);
        Some(tr!("{value} at {frame}", frame = json_text(key.get("frame")?)))
    };
    let count = trn!(count = keys.len(), "{count} key", "{count} keys");
    Some(match keys.as_slice() {
        keys if keys.len() <= MOST_KEYS_TOLD => {
            keys.iter().map(key).collect::<Option<Vec<String>>>()?.join(", ")
        }
        [first, .., last] => {
            tr!("{count}: {first} to {last}", first = key(first)?, last = key(last)?)
        }
        _ => count,
    })
}

/// A value of a file in words, as fields have it.
fn formed_text(json: &Json, form: ToldForm) -> String {
    let items = json.as_array();
    let formed = match form {
        ToldForm::Plain => None,
        ToldForm::Color(space) => items.and_then(|items| color_text(items, space)),
        ToldForm::Degrees => {
            json.as_f64().map(|angle| format!("{}°", values::number_text(angle.to_degrees(), 1)))
        }
        ToldForm::Turn => items.and_then(|items| turn_text(items.as_slice())),
    };
    formed.unwrap_or_else(|| json_text(json))
}

/// A rotation in words; `None` for what is no quaternion.
fn turn_text(items: &[Json]) -> Option<String> {
    let numbers: Vec<f64> = items.iter().map(Json::as_f64).collect::<Option<_>>()?;
    let [x, y, z, w] = numbers[..] else { return None };
    // A quaternion and its opposite are the same rotation, whose shorter way is told.
    let angle = 2.0 * DVec3::new(x, y, z).length().atan2(w.abs());
    let angle = values::number_text(angle.to_degrees(), 1);
    Some(if angle == "0" { tr!("not turned").to_owned() } else { tr!("turned by {angle}°") })
}

/// A value of a file in words.
pub(crate) fn json_text(json: &Json) -> String {
    match json {
        Json::Number(number) => number.as_f64().map_or_else(
            || number.to_string(),
            |number| format!("{}", (number * 1e4).round() / 1e4),
        ),
        Json::String(text) => text.clone(),
        Json::Bool(true) => tr!("on").to_owned(),
        Json::Bool(false) => tr!("off").to_owned(),
        Json::Array(items) if items.first().is_some_and(Json::is_object) => {
            trn!(count = items.len(), "{count} entry", "{count} entries")
        }
        Json::Array(items) => items.iter().map(json_text).collect::<Vec<_>>().join(", "),
        Json::Null => tr!("nothing").to_owned(),
        Json::Object(_) => tr!("a curve").to_owned(),
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use std::path::PathBuf;

    use super::*;
    use crate::document::{ShotKey, TimeKey};
    use crate::frame::Track;
    use crate::library::Library;
    use crate::state::shot::shots_that_change;

    const LOOK: &str = r#"{"chiaro": "look", "nodes": [{"id": "base", "kind": "base"},
        {"id": "layer", "kind": "light_layer"}, {"id": "output", "kind": "output"}],
        "wires": [{"from": "base", "to": "layer.below"},
            {"from": "layer", "to": "output.color"}]}"#;

    /// Puts a scene of one ball, and a shot of twelve frames over it with these overrides, into a
    /// folder; returns the path of the shot.
    pub(crate) fn put_shot(folder: &Path, overrides: &str) -> PathBuf {
        let shot = format!(
            r#"{{"chiaro": "shot", "scene": "scene.json", "frames": [1, 12], "rate": 24,
                "overrides": {overrides}}}"#
        );
        let scene = r#"{"chiaro": "scene", "objects": [{"id": "ball"}]}"#;
        std::fs::write(folder.join("scene.json"), scene).unwrap();
        let path = folder.join("shot.json");
        std::fs::write(&path, shot).unwrap();
        path
    }

    /// Numbers of the open shot's own keys of a value at frames, at places half a frame apart.
    fn curve(session: &Session, at: &ShotAddress) -> Vec<f64> {
        let own = session.shot().unwrap().own(at).unwrap();
        let keys: Vec<TimeKey> = own.keys.iter().map(ShotKey::timed).collect();
        let track = Track { keys: &keys, ends: own.ends(), turns: false };
        let number = |value: Option<Value>| match value {
            Some(Value::Number(x)) => x,
            other => panic!("{other:?}"),
        };
        (0..=30).map(|i| number(track.at(0.5 * f64::from(i)))).collect()
    }

    #[test]
    fn a_key_that_is_added_bends_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let shot = put_shot(
            folder.path(),
            r#"[{"target": "camera.height", "keys": [
                {"frame": 1, "value": 1, "interpolation": "bezier"},
                {"frame": 6, "value": 2, "interpolation": "bezier"},
                {"frame": 12, "value": 6, "interpolation": "bezier"}]}]"#,
        );
        let mut session = Session::new(Arc::new(Library::built_in().clone()), || {});
        session.open(&shot).unwrap();
        let at = ShotAddress { look: None, target: "camera.height".to_owned() };
        let before = curve(&session, &at);
        for frame in [9, 3, 12, 14] {
            session.view.time = session.shot().unwrap().rate().time(frame);
            session.show_shot_at_time(false);
            session.key_in_shot(&at).unwrap();
            let after = curve(&session, &at);
            let off = before.iter().zip(&after).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off < 1e-9, "{off} by a key at {frame}");
        }
        let frames: Vec<f64> =
            session.shot().unwrap().own(&at).unwrap().keys.iter().map(|key| key.frame).collect();
        assert_eq!(frames, [1.0, 3.0, 6.0, 9.0, 12.0, 14.0]);
    }

    /// A session of a shot that keys the intensity of a light, in a folder of its own.
    pub(in super::super) fn opened(folder: &Path) -> Session {
        let files = [
            (
                "look.json",
                r#"{"chiaro": "look", "nodes": [{"id": "base", "kind": "base"},
                {"id": "output", "kind": "output"}],
                "wires": [{"from": "base", "to": "output.color"}]}"#,
            ),
            (
                "scene.json",
                r#"{"chiaro": "scene", "objects": [{"id": "ball", "mesh": "shape:sphere",
                "looks": "look.json"}], "lights": {"sun": {"direction": [0, 0, 1]}}}"#,
            ),
            (
                "shot.json",
                r#"{"chiaro": "shot", "scene": "scene.json", "frames": [1, 24], "overrides": [
                {"target": "lights.sun.intensity", "keys": [{"frame": 1, "value": 1},
                {"frame": 24, "value": 2}]}]}"#,
            ),
        ];
        for (name, text) in files {
            std::fs::write(folder.join(name), text).unwrap();
        }
        let mut session = Session::new(Arc::new(Library::built_in().clone()), || {});
        session.open(&folder.join("shot.json")).unwrap();
        session.open(&folder.join("look.json")).unwrap();
        session
    }

    #[test]
    fn a_value_of_a_keyed_light_is_that_of_the_moment() {
        let folder = tempfile::tempdir().unwrap();
        let mut session = opened(folder.path());
        let value = |session: &mut Session, target: &str| {
            session.refresh_keys();
            let at = ShotAddress { look: None, target: target.to_owned() };
            session.value_in_shot(&at)
        };
        let mut intensity = |frame: i32| {
            let time = session.shot().unwrap().rate().time(frame);
            session.set_time(time);
            match value(&mut session, "lights.sun.intensity") {
                Some(Value::Number(intensity)) => intensity,
                other => panic!("{other:?}"),
            }
        };
        assert_eq!([1, 24].map(&mut intensity), [1.0, 2.0]);
        assert!((intensity(12) - (1.0 + 11.0 / 23.0)).abs() < 1e-9);
        // Without keys it is the light's own.
        let direction = value(&mut session, "lights.sun.direction");
        assert_eq!(direction, Some(Value::Vector(vec![0.0, 0.0, 1.0])));
    }

    #[test]
    fn lights_that_a_hand_turned_are_the_windows_until_they_are_kept() {
        let folder = tempfile::tempdir().unwrap();
        let mut session = opened(folder.path());
        let targets = |session: &Session| -> Vec<String> {
            let changes = &session.shot().unwrap().shot().overrides;
            changes.iter().map(|change| change.target.clone()).collect()
        };
        assert!(session.follows_shot() && session.lights_of_shot().is_none());
        let of_shot = session.view.orbit.illumination;
        session.view.orbit.illumination = glam::DQuat::from_rotation_y(0.5) * of_shot;
        let turned = session.view.orbit.illumination;
        assert_eq!(session.lights_of_shot(), Some(of_shot));
        // The camera follows on, and the lights stay where the hand has put them.
        session.set_time(0.5);
        assert_eq!((session.view.orbit.illumination, session.follows_shot()), (turned, false));
        session.view.orbit.orbit(0.3, 0.1);
        session.keep_view(1.5).unwrap();
        let kept = targets(&session);
        assert!(kept.contains(&"camera.eye".to_owned()), "{kept:?}");
        assert!(!kept.contains(&"illumination".to_owned()), "{kept:?}");
        assert_eq!(session.lights_of_shot(), Some(of_shot), "and are still told");
        let eye = session.open_scene().unwrap().scene().camera.eye;
        assert!(eye.iter().all(|x| x.to_string().len() <= 9), "{eye:?} is read by people");
        let rotation = turned.to_array();
        session.apply_to_scene(SceneEdit::SetIllumination { rotation }, None).unwrap();
        assert!(targets(&session).contains(&"illumination".to_owned()));
        assert!(session.lights_of_shot().is_none());
        session.undo();
        assert!(session.lights_of_shot().is_none(), "one step back");
    }

    #[test]
    fn lights_of_the_world_do_not_turn_by_hand() {
        let folder = tempfile::tempdir().unwrap();
        let put = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
        let opened = |of_look: &str, of_scene: &str| {
            let light = |space: &str| format!(r#"{{"lights": {{"sun": {{"space": "{space}"}}}}, "#);
            put("look.json", &LOOK.replacen('{', &light(of_look), 1));
            let object = r#""objects": [{"id": "ball", "looks": "look.json"}]}"#;
            put("scene.json", &(light(of_scene) + r#""chiaro": "scene", "# + object));
            let mut session = Session::new(Arc::new(Library::built_in().clone()), || {});
            session.open(&folder.path().join("scene.json")).unwrap();
            if let Some(LookToOpen::File(path)) = session.look_to_open() {
                session.open(&path).unwrap();
            }
            session
        };
        assert!(opened("illumination", "illumination").keys().has_turning_lights());
        // The scene's light stands in place of the look's.
        assert!(!opened("illumination", "world").keys().has_turning_lights());
        let mut session = opened("world", "world");
        assert!(!session.keys().has_turning_lights());
        session.leave_scene(true);
        assert!(!session.keys().has_turning_lights());
        let new = Session::new(Arc::new(Library::built_in().clone()), || {});
        assert!(new.keys().has_turning_lights());
    }

    #[test]
    fn a_file_under_a_shot_is_wrong_until_it_is_whole_again() {
        let folder = tempfile::tempdir().unwrap();
        let mut session = opened(folder.path());
        let errors =
            |session: &Session| session.all_problems().filter(|found| found.is_error()).count();
        assert_eq!(errors(&session), 0);
        let scene = folder.path().join("scene.json");
        let whole = std::fs::read_to_string(&scene).unwrap();
        std::fs::write(&scene, "{\"chiaro\": \"scene\", objects").unwrap();
        session.files_changed();
        let found = errors(&session);
        assert!(found > 0);
        let edit = ShotEdit::SetStep { step: Some(2) };
        session.apply_to_shot(edit, None).unwrap();
        assert_eq!(errors(&session), found, "after an edit");
        session.save_as(&folder.path().join("shot.json")).unwrap();
        assert_eq!(errors(&session), found, "after a save of the shot");
        std::fs::write(&scene, whole).unwrap();
        session.files_changed();
        assert_eq!(errors(&session), 0);
    }

    #[test]
    fn all_that_a_shot_changes_is_keyed_and_reset_at_once() {
        let folder = tempfile::tempdir().unwrap();
        let shot = put_shot(
            folder.path(),
            r#"[{"target": "camera.height", "value": 3},
                {"target": "objects.ball.mesh", "value": "shape:cube"},
                {"target": "camera.fov", "keys": [{"frame": 4, "value": 0.5}]}]"#,
        );
        let mut session = Session::new(Arc::new(Library::built_in().clone()), || {});
        assert_eq!(session.key_all_in_shot().unwrap_err().code, "impossible-edit");
        session.open(&shot).unwrap();
        let before = session.shot().unwrap().shot().clone();
        session.key_all_in_shot().unwrap();
        let keys: Vec<Vec<f64>> = session
            .shot()
            .unwrap()
            .shot()
            .overrides
            .iter()
            .map(|change| change.keys.iter().map(|key| key.frame).collect())
            .collect();
        assert_eq!(keys, [vec![1.0], vec![], vec![1.0, 4.0]], "a mesh has no keys");
        session.reset_all_in_shot().unwrap();
        assert!(session.shot().unwrap().shot().overrides.is_empty());
        session.undo();
        session.undo();
        assert_eq!(*session.shot().unwrap().shot(), before, "each is one step");
    }

    #[test]
    fn keys_are_told_with_their_frames() {
        let told = |keys: &str| keys_text(&serde_json::from_str(keys).unwrap(), ToldForm::Plain);
        let two = r#"[{"frame": 1, "value": 0.5}, {"frame": 24, "value": 2}]"#;
        assert_eq!(told(two).unwrap(), "0.5 at 1, 2 at 24");
        let four = r#"[{"frame": 1, "value": 0.5}, {"frame": 8, "value": 2},
            {"frame": 9, "value": 1}, {"frame": 24, "value": 0}]"#;
        assert_eq!(told(four).unwrap(), "4 keys: 0.5 at 1 to 0 at 24");
        assert_eq!(told("[1, 2]"), None);
        assert_eq!(told("[]"), None);
    }

    #[test]
    fn colors_are_told_as_fields_have_them() {
        let json = |text: &str| serde_json::from_str(text).unwrap();
        let told = |text: &str, form| formed_text(&json(text), form);
        let color = ToldForm::Color(ColorSpace::Display);
        assert_eq!(told("[1, 0.5, 0]", color), "#ff8000");
        assert_eq!(told("[1, 0.5, 0]", ToldForm::Plain), "1, 0.5, 0");
        assert_eq!(told("[9, 0.5, 0]", color), "9, 0.5, 0", "no screen's");
        assert_eq!(told("1.3207", ToldForm::Degrees), "75.7°");
        assert_eq!(told("[0, 0, 0, 1]", ToldForm::Turn), "not turned");
        let turned = ["[0, 0.258819, 0, 0.965926]", "[0, -0.258819, 0, -0.965926]"];
        assert_eq!(turned.map(|text| told(text, ToldForm::Turn)), ["turned by 30°"; 2]);
    }

    #[test]
    fn changes_of_lights_and_nodes_that_were_renamed_move_with_their_keys() {
        let folder = tempfile::tempdir().unwrap();
        let put = |name: &str, text: &str| {
            let path = folder.path().join(name);
            std::fs::write(&path, text).unwrap();
            path
        };
        put("look.json", LOOK);
        put(
            "scene.json",
            r#"{"chiaro": "scene", "objects": [
            {"id": "ball", "mesh": "shape:sphere", "looks": "look.json"}],
            "lights": {"kicker": {"name": "Kicker"}, "sun": {}}}"#,
        );
        let path = put(
            "sh010.json",
            r#"{"chiaro": "shot", "scene": "scene.json", "frames": [1, 9], "overrides": [
            {"target": "lights.rim.intensity", "keys": [
                {"frame": 1, "value": 0.5}, {"frame": 9, "value": 2}]},
            {"target": "lights.sun.intensity", "value": 2},
            {"look": "look.json", "target": "old_layer.opacity", "value": 0.75}]}"#,
        );
        let mut session = Session::new(Arc::new(Library::built_in().clone()), || {});
        session.open(&path).unwrap();
        session.open(&folder.path().join("look.json")).unwrap();
        let places = |session: &Session| -> Vec<Vec<(String, String)>> {
            let lost = session.shot().unwrap().lost_changes();
            lost.iter().map(|it| session.places_of_lost(it.owner().unwrap())).collect()
        };
        let of_both = places(&session);
        let named = |[id, name]: [&str; 2]| (id.to_owned(), name.to_owned());
        assert_eq!(of_both[0], [named(["kicker", "Kicker"])], "the sun has a change of its own");
        let ids: Vec<&str> = of_both[1].iter().map(|(id, _)| id.as_str()).collect();
        assert_eq!(ids, ["layer"], "what has an opacity");
        for (owner, to) in [(0, "kicker"), (0, "layer")] {
            let shot = session.shot().unwrap();
            let edit = shot.moved(shot.lost_changes()[owner].owner().unwrap(), to);
            session.apply_to_shot(edit, None).unwrap();
        }
        let shot = session.shot().unwrap();
        assert!(shot.lost_changes().is_empty());
        let [light, _, layer] = &shot.shot().overrides[..] else { panic!() };
        assert_eq!((light.target.as_str(), light.keys.len()), ("lights.kicker.intensity", 2));
        assert_eq!(layer.target, "layer.opacity");
    }

    #[test]
    fn changes_of_an_object_that_was_renamed_are_listed_and_moved() {
        let folder = tempfile::tempdir().unwrap();
        let put = |name: &str, text: &str| {
            let path = folder.path().join(name);
            std::fs::write(&path, text).unwrap();
            path
        };
        let scene =
            put("duo.json", r#"{"chiaro": "scene", "objects": [{"id": "cow"}, {"id": "ball"}]}"#);
        put(
            "other.json",
            r#"{"chiaro": "shot", "scene": "duo.json", "overrides": [
            {"target": "objects.ball.visible", "value": false}]}"#,
        );
        let path = put(
            "sh010.json",
            r#"{"chiaro": "shot", "scene": "duo.json", "frames": [1, 9],
            "overrides": [{"target": "objects.figure.visible", "value": false},
            {"target": "objects.ball.transform.scale", "value": 2},
            {"target": "objects.figure.transform.translate", "keys": [
                {"frame": 1, "value": [0, 0, 0]}, {"frame": 9, "value": [1, 0, 0]}]}]}"#,
        );
        let mut session = Session::new(Arc::new(Library::built_in().clone()), || {});
        session.open(&path).unwrap();
        let shot = session.shot().unwrap();
        let lost = shot.lost_changes();
        let told: Vec<_> = lost
            .iter()
            .map(|it| (it.change.target.as_str(), it.owner().map(|owner| owner.id)))
            .collect();
        let figure = Some("figure");
        assert_eq!(
            told,
            [("objects.figure.visible", figure), ("objects.figure.transform.translate", figure)]
        );
        assert!(lost[0].why.contains("figure"), "{}", lost[0].why);
        let owner = lost[0].owner().unwrap();
        let places: Vec<String> =
            session.places_of_lost(owner).into_iter().map(|(id, _)| id).collect();
        assert_eq!(places, ["cow"], "the ball has changes of its own");
        let before = shot.shot().clone();
        let edit = shot.moved(owner, "cow");
        session.apply_to_shot(edit, None).unwrap();
        let shot = session.shot().unwrap();
        let targets: Vec<&str> =
            shot.shot().overrides.iter().map(|it| it.target.as_str()).collect();
        assert_eq!(
            targets,
            [
                "objects.cow.visible",
                "objects.ball.transform.scale",
                "objects.cow.transform.translate"
            ]
        );
        assert!(shot.lost_changes().is_empty());
        session.undo();
        assert_eq!(*session.shot().unwrap().shot(), before, "one step");
        let edit = session.shot().unwrap().lost_changes()[0].taken_back();
        session.apply_to_shot(edit, None).unwrap();
        assert_eq!(session.shot().unwrap().lost_changes().len(), 1);
        let files = session.assets.source().clone();
        assert_eq!(shots_that_change(&*files, &scene, "figure"), [path]);
        assert!(shots_that_change(&*files, &scene, "cow").is_empty());
    }
}
