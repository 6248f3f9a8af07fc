//! Scene around the open look. A scene has a past, a file and a journal of its own, as
//! the look has; the looks of objects that do not wear the open one come from their files.

pub(crate) mod carried;
mod file_motion;
mod files;
mod looks;
mod names;
mod objects;
mod snapshot;

use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::tr;
use serde_json::json;

use crate::diag::Diagnostic;
use crate::document::{DocumentRevision, History, Look, Object, Scene, SceneEdit, SourceMap};
use crate::files::Files;
use crate::files::journal::{DocumentInfo, JournalSlot, RecoveredWork};
use crate::frame::SetupLook;
use crate::ids::ObjectId;
use crate::library::Library;
use crate::state::document::journal::DocumentJournal;
use crate::state::document::times::Times;
use crate::state::document::{OpenDocument, TextFile};
use crate::state::orbit::Orbit;
use crate::state::paths::absolute;
use crate::state::reading::Parameter;
use crate::state::revision::{GestureId, PictureRevision, StepTime};
use crate::state::shot::OpenShot;
pub(crate) use file_motion::{CameraInFile, FileMotion, PlayedClip};
use looks::{ClosedLook, Looks};
pub(crate) use names::{folder_of, real, relative};
pub(crate) use objects::{
    ObjectPlace, file_label, from_degrees, mesh_label, scene_of, sphere_of_lights, stood_up,
    to_degrees, turned_around, unit_rotation,
};
pub(crate) use snapshot::SceneSnapshot;

/// Name of the open look in a scene, while that look has no file.
pub(crate) const OPEN_LOOK: &str = "look:open";

/// A scene around the open look.
pub struct OpenScene {
    pub(crate) document: OpenDocument<Scene>,
    /// Folder that the names in the scene are relative to: that of the file it was opened from;
    /// empty where the scene was made here.
    base: PathBuf,
    looks: Looks,
    /// Looks that are not open, by their names; `None` where a file is broken.
    closed: HashMap<String, Option<Arc<ClosedLook>>>,
    snapshot: Arc<SceneSnapshot>,
    selected: Option<ObjectId>,
    /// Positions of the objects, as of the last picture.
    pub(crate) placed: Vec<ObjectPlace>,
    /// File of the open look.
    open_file: Option<PathBuf>,
    /// Times of the steps of looks that were open before, by their files.
    pub(crate) left: HashMap<PathBuf, Times>,
    /// The object and the material that a file is being chosen for.
    pub(crate) asked: Option<(ObjectId, String)>,
    /// The look that was open when this scene was put aside, if it was.
    pub(crate) wanted: Option<LookToOpen>,
    /// The shot over the scene, if one is open: the scene is then what the shot makes of its file.
    pub(crate) shot: Option<Box<OpenShot>>,
}

/// The look to open with a scene that is taken back.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum LookToOpen {
    /// The look in this file.
    File(PathBuf),
    /// A look that has no file yet.
    Unsaved,
}

impl OpenScene {
    fn with(
        history: History<Scene>,
        source: SourceMap,
        path: Option<PathBuf>,
        base: PathBuf,
    ) -> Self {
        Self {
            document: OpenDocument::new(history, path, TextFile::new(source)),
            base,
            looks: Looks::default(),
            closed: HashMap::new(),
            snapshot: Arc::default(),
            selected: None,
            placed: Vec::new(),
            open_file: None,
            left: HashMap::new(),
            asked: None,
            wanted: None,
            shot: None,
        }
    }

    /// A scene that no file holds; its names are absolute paths, which hold wherever it will be
    /// saved.
    pub(crate) fn unsaved(scene: Scene) -> Self {
        Self::with(History::new(scene), Scene::read("{}", "scene").source, None, PathBuf::new())
    }

    /// The scene document.
    pub fn scene(&self) -> &Scene {
        self.document.document()
    }

    /// File of the scene, once there is one.
    pub fn path(&self) -> Option<&Path> {
        self.document.path.as_deref()
    }

    /// Display name of the scene.
    pub(crate) fn name(&self) -> String {
        let file = self.document.path.as_ref().and_then(|path| path.file_name());
        file.map_or_else(|| tr!("New scene").to_owned(), |name| name.to_string_lossy().into_owned())
    }

    /// Name of the document whose changes a save would write: the shot's, where one is open.
    pub(crate) fn name_of_changed(&self) -> String {
        self.shot.as_ref().map_or_else(|| self.name(), |shot| shot.name())
    }

    /// True if there are changes that no file holds, of the scene or of the shot over it.
    pub fn is_dirty(&self) -> bool {
        self.document.is_dirty() || self.shot.as_ref().is_some_and(|shot| shot.document.is_dirty())
    }

    /// The selected object, which is one of the scene.
    pub fn selected(&self) -> Option<(&ObjectId, &Object)> {
        self.scene().objects.get_key_value(self.selected.as_ref()?)
    }

    /// The selected object, or else the first that wears the open look.
    pub(crate) fn selected_or_worn(&self) -> Option<&ObjectId> {
        let worn = || self.scene().objects.iter().find(|(_, object)| self.wears_open(object));
        self.selected().or_else(worn).map(|(id, _)| id)
    }

    pub(crate) fn select(&mut self, id: Option<ObjectId>) {
        self.selected = id;
    }

    pub(crate) fn history(&self) -> &History<Scene> {
        &self.document.history
    }

    /// Gives up unsaved changes: they are no longer asked about.
    pub(crate) fn give_up_changes(&mut self) {
        self.document.history.mark_saved();
        if let Some(shot) = &mut self.shot {
            shot.document.history.mark_saved();
        }
    }

    /// Ends a gesture, so that the next edit is a step of its own.
    pub(crate) fn end_gesture(&mut self) {
        self.document.end_gesture();
        if let Some(shot) = &mut self.shot {
            shot.document.end_gesture();
        }
    }

    /// Applies an edit. Consecutive edits of the same `gesture` are one step. `now` is the time of
    /// the step. Returns true if the scene changed.
    ///
    /// # Errors
    /// A diagnostic where the edit is impossible; nothing is changed then.
    pub(crate) fn apply(
        &mut self,
        edit: SceneEdit,
        gesture: Option<GestureId>,
        now: StepTime,
    ) -> Result<bool, Box<Diagnostic>> {
        self.document.apply(edit, gesture, now)
    }

    /// Revision of the last change that a picture may show, of the scene, or of the shot that makes
    /// it what it is.
    pub(crate) fn picture_revision(&self) -> DocumentRevision {
        match &self.shot {
            Some(shot) => shot.document.history.picture_revision(),
            None => self.document.history.picture_revision(),
        }
    }

    pub(crate) fn undo(&mut self) -> bool {
        self.document.undo()
    }

    pub(crate) fn redo(&mut self, now: StepTime) -> bool {
        self.document.redo(now)
    }

    /// Finds anew the looks that the objects wear; `open` is the file of the open look. `revision`
    /// grows with each change that a picture may show.
    pub(crate) fn sync(
        &mut self,
        open: Option<&Path>,
        library: &Arc<Library>,
        files: &dyn Files,
        revision: PictureRevision,
    ) {
        let scene = self.document.history.document();
        self.selected = self.selected.take().filter(|id| scene.objects.contains_key(id));
        self.open_file = open.map(Path::to_path_buf);
        let open = open.map(real);
        let names =
            scene.objects.values().flat_map(|object| object.looks.values()).map(String::as_str);
        // Each name is looked up once: a crowd may wear a handful of looks.
        let names: HashSet<&str> = names.collect();
        let (mut of_open, mut others) = (Vec::new(), HashMap::new());
        for name in names {
            let path = self.path_of(name);
            if name == OPEN_LOOK || open.as_ref().is_some_and(|open| *open == real(&path)) {
                of_open.push(name.to_owned());
            } else {
                others.insert(name.to_owned(), path);
            }
        }
        self.looks.refresh(others.values(), library, files);
        let find = |(name, path): (String, PathBuf)| Some((name, self.looks.get(&path)?));
        self.closed = others.into_iter().filter_map(find).collect();
        let setup =
            |look: &Option<Arc<ClosedLook>>| look.as_ref().map(|closed| closed.look.clone());
        // The positions of problems in the file are no longer known once the scene is edited.
        let source = &self.document.file.source;
        let source = if self.document.revision() == DocumentRevision::default() {
            source.clone()
        } else {
            Arc::new(Scene::read("{}", source.file()).source)
        };
        let mut snapshot = SceneSnapshot {
            revision,
            shape: revision,
            scene: scene.clone(),
            base: self.base.clone(),
            source,
            open: of_open.into_iter().collect(),
            others: self.closed.iter().map(|(name, look)| (name.clone(), setup(look))).collect(),
            shot: None,
            is_alone: false,
        };
        if snapshot.has_shape_of(&self.snapshot) {
            snapshot.shape = self.snapshot.shape;
        }
        self.snapshot = Arc::new(snapshot);
    }

    /// Brings the scene, and the looks that the objects wear, up to date with the shot over it, as
    /// [`sync`](Self::sync) does without one. Returns the open look under the shot.
    pub(crate) fn resolve(
        &mut self,
        open: Option<&Path>,
        library: &Arc<Library>,
        files: &dyn Files,
        revision: PictureRevision,
    ) -> Option<Look> {
        let mut shot = self.shot.take()?;
        self.document.history.amend(shot.resolve_scene(), |_| {});
        self.sync(open, library, files, revision);
        let snapshot = Arc::make_mut(&mut self.snapshot);
        // Each look once, however many names it has.
        let mut places: HashMap<*const SetupLook, usize> = HashMap::new();
        let mut others: Vec<SetupLook> = Vec::new();
        for look in snapshot.others.values().flatten() {
            places.entry(Arc::as_ptr(look)).or_insert_with(|| {
                others.push((**look).clone());
                others.len() - 1
            });
        }
        let (look, others) = shot.resolve_looks(files, others);
        let others: Vec<Arc<SetupLook>> = others.into_iter().map(Arc::new).collect();
        for look in snapshot.others.values_mut().flatten() {
            if let Some(resolved) = places.get(&Arc::as_ptr(look)).and_then(|at| others.get(*at)) {
                *look = resolved.clone();
            }
        }
        snapshot.shot = Some(shot.resolved().clone());
        self.shot = Some(shot);
        look
    }

    /// Shows the scene as the shot over it has moved it at a time, in seconds; the picture moves it
    /// by itself.
    pub(crate) fn show_at(&mut self, time: f64) {
        let Some(shot) = &mut self.shot else { return };
        shot.shown_at = Some(time);
        let resolved = shot.resolved().clone();
        let scene = resolved.scene_at(shot.scene(), time);
        if *scene != *self.document.history.document() {
            self.document.history.amend(scene.into_owned(), |_| {});
        }
    }

    /// Snapshot of the scene that a thread can take along.
    pub(crate) fn snapshot(&self) -> &Arc<SceneSnapshot> {
        &self.snapshot
    }

    /// Looks of objects that are not open, as far as they can be read.
    pub(crate) fn other_looks(&self) -> impl Iterator<Item = &Arc<SetupLook>> {
        self.snapshot.others.values().flatten()
    }

    /// Parameters that objects may set which wear the look `name`, a look that is not open.
    pub(crate) fn parameters(&self, name: &str) -> &[Parameter] {
        self.closed.get(name).and_then(Option::as_ref).map_or(&[], |closed| &closed.parameters)
    }

    /// True if `name` means the open look.
    pub(crate) fn is_open(&self, name: &str) -> bool {
        self.snapshot.open.contains(name)
    }

    /// True if an object wears the open look, on any material.
    pub(crate) fn wears_open(&self, object: &Object) -> bool {
        object.looks.values().any(|name| self.is_open(name))
    }

    /// The look to open where no object wears the open one: a look that can be read, of an object
    /// that is seen if possible. While the project's nodes are awaited, every look whose file
    /// exists counts: its nodes may be among them.
    pub(crate) fn look_to_open(&self, awaits_nodes: bool) -> Option<PathBuf> {
        let objects = &self.scene().objects;
        if objects.values().any(|object| self.wears_open(object)) {
            return None;
        }
        let visible = objects.values().filter(|object| object.visible);
        let hidden = objects.values().filter(|object| !object.visible);
        let mut names = visible.chain(hidden).flat_map(|object| object.looks.values());
        let others = &self.snapshot.others;
        let name =
            names.find(|name| others.get(*name).is_some_and(|l| awaits_nodes || l.is_some()))?;
        Some(self.path_of(name))
    }

    /// True if an object wears the look in this file.
    pub(crate) fn wears(&self, file: &Path) -> bool {
        let file = real(file);
        let names = self.scene().objects.values().flat_map(|object| object.looks.values());
        names.filter(|name| *name != OPEN_LOOK).any(|name| real(&self.path_of(name)) == file)
    }

    /// True if an object wears a look that has no file.
    pub(crate) fn wears_unsaved(&self) -> bool {
        self.scene()
            .objects
            .values()
            .any(|object| object.looks.values().any(|name| name == OPEN_LOOK))
    }

    /// Problems of the file of the scene and of those of its looks.
    pub(crate) fn problems(&self) -> impl Iterator<Item = &Diagnostic> {
        let of_shot = self.shot.iter().flat_map(|shot| shot.problems());
        self.document.load_problems.iter().chain(self.looks.problems()).chain(of_shot)
    }

    /// Messages of the problems, for people.
    pub fn problem_texts(&self) -> impl Iterator<Item = &str> {
        self.problems().map(|problem| problem.message.as_str())
    }

    /// Keeps the journal of unsaved work in a folder from now on.
    pub(crate) fn keep_in(&mut self, folder: &Path, wake: Arc<dyn Fn() + Send + Sync>) {
        if let Some(shot) = &mut self.shot {
            let wake = wake.clone();
            shot.document.journal.keep_in(folder, move || wake());
        }
        self.document.journal.keep_in(folder, move || wake());
    }

    pub(crate) fn journal(&self) -> &DocumentJournal<Scene> {
        &self.document.journal
    }

    /// Tells the journal the window's view.
    pub(crate) fn note_view(&mut self, view: &Orbit) {
        self.document.journal.note_view(view);
        if let Some(shot) = &mut self.shot {
            shot.document.journal.note_view(view);
        }
    }

    /// Hands the edits since the last call to the journal.
    pub(crate) fn commit(&mut self, goes_on: bool) {
        if self.document.commit(goes_on) {
            self.begin_journal(None);
        }
        if let Some(shot) = &mut self.shot {
            shot.commit(goes_on);
        }
    }

    /// Begins the journal with the present scene.
    pub(crate) fn begin_journal(&mut self, slot: Option<JournalSlot>) {
        let text = |path: PathBuf| path.to_str().map(str::to_owned);
        let base = text(self.base.clone());
        let about = DocumentInfo {
            name: self.name(),
            path: self.document.path.as_deref().and_then(|path| text(absolute(path))),
            is_partial: self.document.is_partial,
            window: json!({
                "base": base,
                "look": self.open_file.as_deref().and_then(|path| text(absolute(path)))
            }),
        };
        let source = self.document.path.is_some().then(|| self.document.file.source.text().clone());
        self.document.begin_journal(about, source, slot);
    }

    /// Closes the journal, whose file stays if any change in it is not saved.
    pub(crate) fn leave_journal(&mut self, in_peace: bool) {
        self.commit(false);
        self.document.leave_journal(false, in_peace);
        if let Some(shot) = &mut self.shot {
            shot.document.leave_journal(false, in_peace);
        }
    }

    /// The scene under a shot.
    pub(crate) fn under(shot: OpenShot) -> Self {
        let stack = shot.stack();
        let (path, scene) = (stack.scene_path.clone(), shot.scene().clone());
        let source = (*stack.scene_source).clone();
        let base = folder_of(&path);
        let mut open_scene = Self::with(History::new(scene), source, Some(path), base);
        open_scene.shot = Some(Box::new(shot));
        open_scene
    }

    /// The scene that a journal gave.
    pub(crate) fn taken_back(found: RecoveredWork<Scene>) -> Self {
        let path = found.about.path.as_ref().map(PathBuf::from);
        let name = found.about.path.as_deref().unwrap_or("scene");
        let source = Scene::read(found.source.as_deref().unwrap_or("{}"), name).source;
        let of_window = |key: &str| {
            found.about.window.get(key).and_then(serde_json::Value::as_str).map(PathBuf::from)
        };
        let base =
            of_window("base").or_else(|| path.as_deref().map(names::folder_of)).unwrap_or_default();
        let wanted = of_window("look").map_or(LookToOpen::Unsaved, LookToOpen::File);
        let mut open_scene = Self::with(found.history, source, path, base);
        open_scene.document.is_partial = found.about.is_partial;
        open_scene.document.load_problems = found.damage;
        open_scene.wanted = Some(wanted);
        open_scene
    }
}
