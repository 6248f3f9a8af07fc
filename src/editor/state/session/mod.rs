//! Session of one open look: the document and its past, the file, the selection, and the compiled
//! shaders.

mod holding;
mod importing;
mod keeping;
mod masks;
mod nodes;
pub(crate) mod painting;
mod parts;
mod project;
pub(crate) mod saving;
mod scene;
mod shading;
mod sharing;
mod shelf;
pub(crate) mod shot;
mod sketch;
mod snapshots;
mod steps;
mod wedge;

use std::borrow::Cow;
use std::collections::{BTreeMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::{Text, text, tr};
use glam::DQuat;

use crate::diag::{Diagnostic, Severity};
use crate::document::{Document, DocumentRevision, Edit, Graph, History, Look, SourceMap};
use crate::examples;
use crate::files::{Disk, SharedFiles};
use crate::frame::AssetStore;
use crate::ids::{LightId, NodeId};
use crate::library::Library;
use crate::state::arrangement;
use crate::state::compiling::{self};
use crate::state::crashes::CrashLog;
use crate::state::display::PictureDisplay;
use crate::state::document::{OpenDocument, TextFile};
use crate::state::keying::{KeyEvaluation, KeyPlace, KeyedLook, Owner};
use crate::state::masks::MaskSteps;
use crate::state::orbit::Orbit;
use crate::state::painting::work::OpenPainting;
use crate::state::pictures::OwnPictures;
use crate::state::reading::LookWithLibrary;
use crate::state::revision::{GestureId, LookRevision, StepTime};
use crate::state::scene::OpenScene;
use crate::state::selection::{OpenGraph, Selection};
use crate::state::shelf::SnapshotShelf;
use crate::state::solo::Solo;
use crate::state::view::ViewState;
use crate::state::wire::ShownWire;
pub(crate) use nodes::NodeFiles;
use parts::{Compilation, Journals, Project, Revisions, Sketchbook};
pub(crate) use shading::DrawableLook;
use shading::ShaderCache;

/// Session of one open look.
pub struct Session {
    pub(crate) look: OpenDocument<Look>,
    /// The scene around the look, if there is one.
    open_scene: Option<OpenScene>,
    /// The HCBTF that is being painted, if there is one.
    painting: Option<OpenPainting>,
    /// True if the open look does not show the painting: undo takes back nothing that is not seen.
    pub(crate) hides_painting: bool,
    pub(crate) sketchbook: Sketchbook,
    /// Steps of masks that are painted on the mesh.
    pub(crate) masks: MaskSteps,
    /// Pictures that were written beside looks.
    pub(crate) pictures: OwnPictures,
    /// Snapshots of the look.
    shelf: SnapshotShelf,
    /// Notes about the open documents that were read.
    read_notes: HashSet<String>,
    /// Labels of steps of the look that their edits do not tell.
    named_steps: BTreeMap<StepTime, String>,
    pub(crate) project: Project,
    pub(crate) selection: Selection,
    pub(crate) view: ViewState,
    key_evaluation: KeyEvaluation,
    compilation: Compilation,
    pub(crate) journals: Journals,
    /// Meshes and images that all pictures of the window share.
    pub(crate) assets: AssetStore,
    /// Problems that keep the picture from being drawn, and warnings about it.
    picture_problems: Vec<Diagnostic>,
    revisions: Revisions,
    /// True while the first picture is on its way: small pictures wait for it.
    pub(crate) awaits_first_picture: bool,
}

impl Session {
    /// Creates a session with a new look. `wake` is called from another thread when nodes were read
    /// or shaders compiled.
    pub fn new(library: Arc<Library>, wake: impl Fn() + Send + Sync + 'static) -> Self {
        Self::reading_from(Arc::new(Disk), library, wake)
    }

    /// Creates a session with a new look, as [`new`](Self::new) does. What documents name is read
    /// from `files`.
    pub fn reading_from(
        files: SharedFiles,
        library: Arc<Library>,
        wake: impl Fn() + Send + Sync + 'static,
    ) -> Self {
        let wake = Arc::new(wake);
        let nodes_are_read = wake.clone();
        let file = TextFile::new(Look::read(NEW_LOOK, "new look").source);
        let crashes = CrashLog::default();
        let mut session = Self {
            look: OpenDocument::new(History::new(Look::default()), None, file),
            open_scene: None,
            painting: None,
            hides_painting: false,
            sketchbook: Sketchbook::default(),
            masks: MaskSteps::default(),
            pictures: OwnPictures::default(),
            shelf: SnapshotShelf::default(),
            read_notes: HashSet::new(),
            named_steps: BTreeMap::new(),
            project: Project::new(library, files.clone(), move || nodes_are_read()),
            selection: Selection::default(),
            view: ViewState::default(),
            key_evaluation: KeyEvaluation::default(),
            compilation: Compilation {
                compiler: compiling::start(move || wake(), crashes.clone()),
                shaders: ShaderCache::default(),
                problems: Vec::new(),
                shown_revision: Default::default(),
            },
            journals: Journals {
                folder: None,
                view: None,
                crashes,
                holding: holding::HeldDocument::default(),
            },
            assets: AssetStore::reading_from(files),
            picture_problems: Vec::new(),
            revisions: Revisions::default(),
            awaits_first_picture: false,
        };
        session.start_new();
        session
    }

    /// Begins a new look: a base, one light layer and an output, wired. An open scene is put aside.
    pub fn start_new(&mut self) {
        self.leave_journal(false);
        self.leave_project();
        self.leave_scene(false);
        self.replace_with_new();
    }

    fn replace_with_new(&mut self) {
        self.leave_journal(false);
        let loaded = Look::read(NEW_LOOK, "new look");
        self.replace(loaded.value.unwrap_or_default(), loaded.source, None);
        self.look.is_partial = false;
        self.look.load_problems.clear();
    }

    /// Begins a new look from a text, without a file.
    pub(crate) fn start_from(&mut self, text: &str, name: &str) {
        self.leave_journal(false);
        self.leave_project();
        self.leave_scene(false);
        let loaded = Look::read(text, name);
        self.replace(loaded.value.unwrap_or_default(), loaded.source, None);
        self.look.is_partial = false;
        self.look.load_problems = loaded.diagnostics;
    }

    /// Opens a scene, a shot of one, or a look, which stays within the open scene if an object
    /// there wears it.
    ///
    /// # Errors
    /// Problems that keep the file from being read at all; the open documents stay then.
    pub fn open(&mut self, path: &Path) -> Result<(), Vec<Diagnostic>> {
        let loaded = match Document::load(&**self.assets.source(), path) {
            Document::Look(loaded) => loaded,
            Document::Scene(loaded) => return self.load_scene(path, loaded),
            Document::Shot(loaded) => return self.load_shot(path, loaded),
        };
        let is_partial = loaded.has_errors();
        let diagnostics = loaded.diagnostics;
        let Some(look) = loaded.value else { return Err(diagnostics) };
        self.leave_journal(false);
        let view = self.open_scene.is_none().then(|| self.view.orbit.clone());
        self.leave_scene_unless_worn(Some(path));
        self.use_project(path);
        // An example alone is the beginning of a look that no file holds yet.
        let is_example = self.open_scene.is_none() && examples::file(path).is_some();
        self.replace(look, loaded.source, (!is_example).then(|| path.to_owned()));
        // The same picture goes on with another look on the mesh: camera and backdrop are the
        // window's. The lights are as the look was made for.
        if let Some(view) = view {
            self.view.orbit = Orbit { illumination: DQuat::IDENTITY, ..view };
        }
        self.look.is_partial = is_partial;
        self.look.load_problems = diagnostics;
        self.revisions.problems.advance();
        Ok(())
    }

    fn replace(&mut self, mut look: Look, source: SourceMap, path: Option<PathBuf>) {
        self.revisions.document.advance();
        self.set_preview(None);
        self.sketchbook.put_aside(&self.look);
        self.masks = MaskSteps::default();
        self.pictures.settle();
        self.remember_times();
        self.look.file = TextFile::new(source);
        self.look.path = path;
        self.look_was_opened(&look);
        arrangement::place_nodes(&mut look, &self.project.library);
        self.look.history = History::new(look);
        self.sketchbook.find(&self.look);
        self.open_shelf();
        self.named_steps.clear();
        self.read_notes.clear();
        self.selection.nodes.clear();
        self.selection.light = None;
        // A scene has the camera, which stays.
        if self.open_scene.is_none() {
            self.view.orbit = Orbit {
                mesh: self.view.orbit.mesh.clone(),
                z_is_up: self.view.orbit.z_is_up,
                ..Orbit::default()
            };
            self.view.time = 0.0;
        }
        self.selection.key = None;
        self.compilation.problems.clear();
        self.revisions.problems.advance();
        self.compilation.shaders = ShaderCache::default();
        self.view.wire = None;
        self.view.solo.keep_for_scene(self.open_scene.as_ref().map(OpenScene::scene));
        self.revisions.picture.advance();
        self.project.sync(self.look.document());
        self.place_library_problems();
        self.selection.leave_groups();
        self.scene_changed();
    }

    /// View of the picture.
    pub fn view(&self) -> &ViewState {
        &self.view
    }

    /// The selection, and the way to the open graph.
    pub fn selection(&self) -> &Selection {
        &self.selection
    }

    /// The sketch on the picture, and the look that was fitted to it.
    pub fn sketchbook(&self) -> &Sketchbook {
        &self.sketchbook
    }

    /// Shaders of the look, and its problems.
    pub fn compilation(&self) -> &Compilation {
        &self.compilation
    }

    /// Revisions of parts of the session.
    pub(crate) fn revisions(&self) -> &Revisions {
        &self.revisions
    }

    /// The look with the kinds of its nodes.
    pub(crate) fn look_with_library(&self) -> LookWithLibrary<'_> {
        let (catalog, library) = (&self.project.catalog, &self.project.library);
        LookWithLibrary { look: self.look(), catalog, library }
    }

    /// The look with the values of its keys in view.
    pub fn keys(&self) -> KeyedLook<'_> {
        KeyedLook {
            owner: Owner::Look,
            base: self.look_with_library(),
            evaluation: &self.key_evaluation,
            view: &self.view,
            selected_key: self.selection.key,
            scene: self.open_scene.as_ref(),
            typed: self.compilation.shaders.typed.as_deref(),
            shader: self.compilation.shaders.current(self.revision()),
        }
    }

    /// Computes the values of keys, where anything changed since.
    pub(crate) fn refresh_keys(&mut self) {
        self.show_shot_at_time(false);
        let shaders = &self.compilation.shaders;
        let shader = |sets_values| shaders.of_wires(sets_values, self.revision());
        let Some(evaluation) = self.keys().evaluated(self.stamp(), shader) else { return };
        self.key_evaluation = evaluation;
        let of_look = &self.look.document().direction_keys;
        let of_scene = self.open_scene.as_ref().map(|open_scene| open_scene.scene());
        let is_there = |at: &KeyPlace| {
            let sets = match at.owner {
                Owner::Look => of_look.as_slice(),
                Owner::Scene => of_scene.map_or(&[][..], |scene| &scene.direction_keys),
            };
            sets.get(at.set).is_some_and(|keys| at.key < keys.keys.len())
        };
        self.selection.key = self.selection.key.filter(is_there);
    }

    /// Follows the heaviest key of each set, slowly; no other key while a value is held.
    pub(crate) fn follow_keys(&mut self, is_held: bool) {
        let of_look = self.keys().followed(is_held);
        let of_scene = self.keys().of_scene().map(|keys| keys.followed(is_held));
        self.key_evaluation.follow(of_look, of_scene);
    }

    /// The open graph.
    pub fn graph(&self) -> &Graph {
        self.graph_view().graph()
    }

    /// The open graph, and its place in the look.
    pub fn graph_view(&self) -> OpenGraph<'_> {
        OpenGraph { look: self.look_with_library(), selection: &self.selection }
    }

    /// Opens the graph that these nodes of groups lead to, as far as they exist.
    pub fn open_graph(&mut self, path: &[NodeId]) {
        let place = self.graph_view().along(path);
        if self.selection.open(place) {
            self.revisions.problems.advance();
        }
    }

    /// The look document.
    pub fn look(&self) -> &Look {
        self.look.document()
    }

    /// File of the look, once there is one.
    pub fn path(&self) -> Option<&Path> {
        self.look.path.as_deref()
    }

    /// Display name of the look: its file's name, or else its own. A look of the same name as the
    /// painting is told from it.
    pub(crate) fn name(&self) -> String {
        self.name_or(NEW_NAME.tr())
    }

    /// The name, or this one of a look that has none.
    fn name_or(&self, unnamed: &str) -> String {
        let look = &self.look().name;
        match self.path().and_then(Path::file_name) {
            Some(name) => name.to_string_lossy().into_owned(),
            None if look.is_empty() || look == NEW_NAME.english() => unnamed.to_owned(),
            None if self.painting.as_ref().is_some_and(|work| work.kept_name() == *look) => {
                tr!("Look of {look}")
            }
            None => look.clone(),
        }
    }

    /// True if there are changes that no file holds, of the look or of the scene around it.
    pub fn is_dirty(&self) -> bool {
        self.is_look_dirty() || self.open_scene.as_ref().is_some_and(OpenScene::is_dirty)
    }

    /// True if there are changes of the look that no file holds.
    pub fn is_look_dirty(&self) -> bool {
        self.look.is_dirty()
    }

    /// Revision of the look, which grows with every change.
    pub fn revision(&self) -> LookRevision {
        LookRevision(self.look.history.revision())
    }

    /// Selects nodes, and deselects all others.
    pub fn select(&mut self, ids: Vec<NodeId>) {
        let graph = self.graph_view();
        self.selection.nodes = ids.into_iter().filter(|id| graph.has_node(id)).collect();
        if !self.selection.nodes.is_empty() {
            // The light of the selected layer or node is meant from now on.
            self.selection.light = None;
        }
    }

    /// Chooses the light that handles, placing and looking through are of.
    pub(crate) fn choose_light(&mut self, id: LightId) {
        self.selection.light = Some(id);
    }

    /// Gives up unsaved changes of the look or of the scene: they are no longer asked about.
    pub(crate) fn give_up_changes(&mut self, of_look: bool, of_scene: bool) {
        if of_look {
            self.look.history.mark_saved();
        }
        if let Some(open_scene) = self.open_scene.as_mut().filter(|_| of_scene) {
            open_scene.give_up_changes();
        }
    }

    /// Shows a wire in place of the picture, or the picture again.
    pub(crate) fn show_wire(&mut self, wire: Option<ShownWire>) {
        if self.view.wire != wire {
            self.view.wire = wire;
            self.compilation.shaders.requested_structure = None;
        }
    }

    /// Sets solo and mute. The document is unchanged.
    pub(crate) fn set_solo(&mut self, solo: Solo) {
        if self.view.solo == solo {
            return;
        }
        if self.view.solo.is_structural(&solo, self.look()) {
            self.view.solo_revision.advance();
            self.compilation.shaders.requested_structure = None;
        }
        self.view.solo = solo;
        self.revisions.picture.advance();
    }

    /// Shows the picture by a view, or by the curve of sRGB. The document is unchanged.
    pub(crate) fn show_by(&mut self, display: Option<PictureDisplay>) {
        if self.view.display != display {
            self.view.display = display;
            self.revisions.picture.advance();
        }
    }

    /// The look as shown: with soloed layers alone, and without muted lights; or the preview of
    /// another look.
    pub(crate) fn shown_look(&self) -> Cow<'_, Look> {
        match &self.sketchbook.preview {
            Some(preview) => Cow::Borrowed(preview),
            None => self.view.solo.of(self.look(), &self.project.catalog),
        }
    }

    /// Applies an edit. Consecutive edits of the same `gesture` (a widget and its press)
    /// are one step.
    ///
    /// # Errors
    /// A diagnostic where the edit is impossible; nothing is changed then.
    pub fn apply(&mut self, edit: Edit, gesture: Option<GestureId>) -> Result<(), Box<Diagnostic>> {
        self.apply_at(edit, gesture, self.revisions.step.next())
    }

    /// Applies an edit at a time, which may be that of a step of the scene: undo takes both back at
    /// once.
    pub(super) fn apply_at(
        &mut self,
        mut edit: Edit,
        gesture: Option<GestureId>,
        time: StepTime,
    ) -> Result<(), Box<Diagnostic>> {
        if let Edit::Replace { look } = &mut edit {
            arrangement::place_nodes(look, &self.project.library);
        }
        if self.shot().is_some() {
            return self.apply_look_to_shot(edit, gesture);
        }
        let is_structural = self.compilation.shaders.is_structural(&edit, self.look_with_library());
        let before = self.look.history.picture_revision();
        self.compilation.shaders.touch(&edit);
        if self.look.apply(edit, gesture, time)? {
            self.step_done();
            self.was_edited(before, is_structural);
        }
        Ok(())
    }

    fn undo_look(&mut self) -> bool {
        let before = self.look.history.picture_revision();
        let did = self.look.undo();
        if did {
            self.bring_pictures_along();
            self.was_edited(before, true);
        }
        did
    }

    fn redo_look(&mut self, now: StepTime) -> bool {
        let next = self.look.times.next();
        let before = self.look.history.picture_revision();
        let did = self.look.redo(now);
        if did {
            if let Some(label) = next.and_then(|time| self.named_steps.remove(&time)) {
                self.named_steps.insert(now, label);
            }
            self.bring_pictures_along();
            self.was_edited(before, true);
        }
        did
    }

    /// Brings everything up to date after an edit of the look. Meaning and picture, which were
    /// those of the revision `before`, stay where the edit is an annotation.
    fn was_edited(&mut self, before: DocumentRevision, is_structural: bool) {
        let is_seen = self.look.history.picture_revision() != before;
        if is_seen {
            self.revisions.meaning.advance();
            self.revisions.picture.advance();
        }
        self.sync_look(is_structural && is_seen);
    }

    fn changed(&mut self, is_structural: bool) {
        self.revisions.picture.advance();
        self.sync_look(is_structural);
    }

    fn sync_look(&mut self, is_structural: bool) {
        self.set_preview(None);
        if is_structural {
            self.compilation.shaders.structure = self.revision();
            self.project.sync(self.look.document());
        }
        let path = self.selection.open_groups().to_vec();
        self.open_graph(&path);
        let mut selected = std::mem::take(&mut self.selection.nodes);
        selected.retain(|id| self.graph_view().has_node(id));
        self.selection.nodes = selected;
        self.keep_solo();
        let nodes = &self.look.document().graph.nodes;
        self.view.wire = self
            .view
            .wire
            .take()
            .filter(|wire| wire.node.outermost().is_some_and(|id| nodes.contains_key(id)));
    }

    /// Problems of the files, the look and the picture.
    pub(crate) fn all_problems(&self) -> impl Iterator<Item = &Diagnostic> {
        let scene = self.open_scene.iter().flat_map(OpenScene::problems);
        let files = self.look.load_problems.iter().chain(scene).chain(&self.project.problems);
        files.chain(&self.compilation.problems).chain(&self.picture_problems)
    }

    /// Problems but for notes that were read.
    pub(crate) fn unread_problems(&self) -> impl Iterator<Item = &Diagnostic> {
        self.all_problems().filter(|problem| {
            problem.severity != Severity::Note || !self.read_notes.contains(&problem.message)
        })
    }

    /// True if there are notes that nobody has read.
    pub(crate) fn has_unread_notes(&self) -> bool {
        self.unread_problems().any(|problem| problem.severity == Severity::Note)
    }

    /// Takes all notes as read.
    pub(crate) fn read_notes(&mut self) {
        let notes = self.unread_problems().filter(|problem| problem.severity == Severity::Note);
        let notes: Vec<String> = notes.map(|problem| problem.message.clone()).collect();
        self.read_notes.extend(notes);
    }

    /// Number of times that a mesh, an image or an HCBTF was read, or a built-in shape made, for
    /// any picture of the window.
    pub fn asset_reads(&self) -> u64 {
        self.assets.reads()
    }

    /// Takes the problems that the renderer reports.
    pub(crate) fn set_picture_problems(&mut self, problems: &[Diagnostic]) {
        if self.picture_problems != problems {
            self.picture_problems = problems.to_vec();
            self.revisions.problems.advance();
        }
    }
}

/// Name of a new look, until somebody gives another.
const NEW_NAME: Text = text!("New look");

/// Text of a new look.
const NEW_LOOK: &str = r##"{
  "name": "New look",
  "lights": {"key": {"direction": [-0.5, 0.7, 0.6]}},
  "nodes": [
    {"id": "base", "kind": "base", "at": [0, 0], "values": {"color": [0.16, 0.15, 0.2]}},
    {"id": "diffuse", "kind": "light_layer", "at": [260, 0], "name": "Diffuse",
    "values": {"light": "key", "convex": [0.85, 0.72, 0.6], "concave": [0.7, 0.45, 0.42]}},
    {"id": "output", "kind": "output", "at": [520, 0]}
  ],
  "wires": [
    {"from": "base", "to": "diffuse.below"},
    {"from": "diffuse", "to": "output.color"}
  ]
}"##;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Projection;

    #[test]
    fn the_windows_view_goes_on_with_another_look() {
        let folder = tempfile::tempdir().unwrap();
        let file = |name: &str, text: &str| {
            let path = folder.path().join(name);
            std::fs::write(&path, text).unwrap();
            path
        };
        let [one, other] = ["one.json", "other.json"].map(|name| file(name, NEW_LOOK));
        let scene = file(
            "scene.json",
            r#"{"chiaro": "scene", "objects": [
                {"id": "ball", "mesh": "shape:sphere", "looks": "one.json"}],
                "camera": {"eye": [5, 0, 0]}}"#,
        );
        let mut session = Session::new(Arc::new(Library::built_in().clone()), || {});
        session.open(&one).unwrap();
        let orbit = &mut session.view.orbit;
        orbit.yaw += std::f64::consts::PI;
        orbit.projection = Projection::Orthographic;
        orbit.backdrop = Some([1.0, 0.0, 0.0, 1.0]);
        orbit.illumination = DQuat::from_rotation_y(0.5);
        let turned = orbit.clone();
        session.open(&other).unwrap();
        let kept = Orbit { illumination: DQuat::IDENTITY, ..turned };
        assert_eq!(session.view.orbit, kept, "the lights are as the look was made for");

        // Another picture has another view.
        session.open(&scene).unwrap();
        session.open(&one).unwrap();
        assert!(session.open_scene().is_some());
        session.open(&other).unwrap();
        assert!(session.open_scene().is_none());
        assert_eq!((session.view.orbit.yaw, session.view.orbit.backdrop), (0.0, None));
    }
}
