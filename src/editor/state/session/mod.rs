//! Session of one open look: the document and its past, the file, the selection, and the compiled
//! shaders.

mod holding;
mod keeping;
mod painting;
mod parts;
mod place;
mod project;
mod scene;
mod shading;
mod sharing;
mod sketch;

use std::borrow::Cow;
use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::diag::Diagnostic;
use crate::document::{
    DirectionKeys, Document, Edit, GraphId, History, Light, Look, SourceMap, Target, Value,
};
use crate::files::write_atomic;
use crate::frame::AssetStore;
use crate::ids::{LightId, NodeId};
use crate::library::{Fallback, Library};
use crate::state::compiling::{self};
use crate::state::document::{OpenDocument, TextFile};
use crate::state::keying::KeyEvaluation;
use crate::state::orbit::Orbit;
use crate::state::painting::work::OpenPainting;
use crate::state::revision::{DocumentNumber, LookRevision, MeaningRevision, ProblemsRevision};
use crate::state::safety::crashes::CrashLog;
use crate::state::scene::OpenScene;
use crate::state::solo::Solo;
use crate::state::wire::ShownWire;
use parts::{Compilation, Journals, Project, Revisions, Selection, Sketchbook, ViewState};
pub(crate) use shading::DrawableLook;
use shading::ShaderCache;

/// Session of one open look.
pub struct Session {
    pub(crate) look: OpenDocument<Look>,
    /// The scene around the look, if there is one.
    stage: Option<OpenScene>,
    /// The HCBTF that is being painted, if there is one.
    painting: Option<OpenPainting>,
    /// True if the open look does not show the painting: undo takes back nothing that is not seen.
    pub(crate) hides_painting: bool,
    sketchbook: Sketchbook,
    pub(crate) project: Project,
    pub(crate) selection: Selection,
    pub(crate) view: ViewState,
    pub(crate) keyed: KeyEvaluation,
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
        let wake = Arc::new(wake);
        let nodes_are_read = wake.clone();
        let file = TextFile::new(Look::read(NEW_LOOK, "new look").source);
        let crashes = CrashLog::default();
        let mut session = Self {
            look: OpenDocument::new(History::new(Look::default()), None, file),
            stage: None,
            painting: None,
            hides_painting: false,
            sketchbook: Sketchbook::default(),
            project: Project::new(library, move || nodes_are_read()),
            selection: Selection::default(),
            view: ViewState::default(),
            keyed: KeyEvaluation::default(),
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
                holding: holding::Holding::default(),
            },
            assets: AssetStore::new(),
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
        self.leave_stage(false);
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
        self.leave_stage(false);
        let loaded = Look::read(text, name);
        self.replace(loaded.value.unwrap_or_default(), loaded.source, None);
        self.look.is_partial = false;
        self.look.load_problems = loaded.diagnostics;
    }

    /// Opens a scene, or a look, which stays within the open scene if an object there wears it.
    ///
    /// # Errors
    /// Problems that keep the file from being read at all; the open documents stay then.
    pub fn open(&mut self, path: &Path) -> Result<(), Vec<Diagnostic>> {
        let loaded = match Document::load(&crate::files::Disk, path) {
            Document::Look(loaded) => loaded,
            Document::Scene(loaded) => return self.open_scene(path, loaded),
        };
        let is_partial = loaded.has_errors();
        let diagnostics = loaded.diagnostics;
        let Some(look) = loaded.value else { return Err(diagnostics) };
        self.leave_journal(false);
        self.leave_stage_unless_worn(Some(path));
        self.use_project(path);
        self.replace(look, loaded.source, Some(path.to_owned()));
        self.look.is_partial = is_partial;
        self.look.load_problems = diagnostics;
        self.revisions.problems.advance();
        Ok(())
    }

    /// Saves to a file, which is the look's own from then on.
    ///
    /// # Errors
    /// A diagnostic with the reason; the old file is then unchanged.
    pub fn save_as(&mut self, path: &Path) -> Result<(), Box<Diagnostic>> {
        let is_own = self.look.check_saving(path)?;
        let names = if is_own { None } else { self.names_of_painting(path) };
        let text = if is_own {
            self.look.text_of(self.look())
        } else {
            self.look_for(names.as_ref()).to_text()
        };
        write_atomic(path, text.as_bytes())?;
        self.look.text_was_written(path, &text);
        self.take_names(names);
        self.look.history.mark_saved();
        self.revisions.problems.advance();
        if !is_own {
            // Another folder is another project, with nodes of its own.
            self.reload_library();
        }
        if !is_own && self.stage.is_some() {
            self.wear_saved(path);
        }
        self.saved();
        Ok(())
    }

    fn replace(&mut self, look: Look, source: SourceMap, path: Option<PathBuf>) {
        self.revisions.document.advance();
        self.set_preview(None);
        self.leave_sketch();
        self.remember_times();
        self.look.history = History::new(look);
        self.look.file = TextFile::new(source);
        self.look.path = path;
        self.find_sketch();
        self.selection.nodes.clear();
        // A scene has the camera, which stays.
        if self.stage.is_none() {
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
        self.view.solo.keep_for_scene(self.stage.as_ref().map(OpenScene::scene));
        self.revisions.picture.advance();
        self.project.sync(self.look.document());
        self.place_library_problems();
        self.reset_place();
        self.stage_changed();
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
        let look = &self.look().name;
        match self.path().and_then(Path::file_name) {
            Some(name) => name.to_string_lossy().into_owned(),
            None if look.is_empty() => "New look".to_owned(),
            None if self.painting.as_ref().is_some_and(|work| work.name() == *look) => {
                format!("Look of {look}")
            }
            None => look.clone(),
        }
    }

    /// True if there are changes that no file holds, of the look or of the scene around it.
    pub fn is_dirty(&self) -> bool {
        self.is_look_dirty() || self.stage.as_ref().is_some_and(OpenScene::is_dirty)
    }

    /// True if there are changes of the look that no file holds.
    pub fn is_look_dirty(&self) -> bool {
        self.look.is_dirty()
    }

    /// Number of the open document; revisions of each document begin anew.
    pub(crate) fn document_number(&self) -> DocumentNumber {
        self.revisions.document
    }

    /// Revision of the look, which grows with every change.
    pub fn revision(&self) -> LookRevision {
        LookRevision(self.look.history.revision())
    }

    /// Revision of the look's meaning, which grows with every change of the nodes' values, and
    /// stays while nodes are only moved about.
    pub(crate) fn meaning(&self) -> MeaningRevision {
        self.revisions.meaning
    }

    /// Selected nodes.
    pub fn selected(&self) -> impl Iterator<Item = &NodeId> {
        self.selection.nodes.iter()
    }

    /// Selects nodes, and deselects all others.
    pub fn select(&mut self, ids: Vec<NodeId>) {
        self.selection.nodes = ids.into_iter().filter(|id| self.is_here(id)).collect();
    }

    /// Gives up unsaved changes of the look or of the scene: they are no longer asked about.
    pub(crate) fn give_up_changes(&mut self, of_look: bool, of_scene: bool) {
        if of_look {
            self.look.history.mark_saved();
        }
        if let Some(stage) = self.stage.as_mut().filter(|_| of_scene) {
            stage.give_up_changes();
        }
    }

    /// View of the camera, with the turn of the lights.
    pub fn orbit(&self) -> &Orbit {
        &self.view.orbit
    }

    /// The moment in the picture, in seconds.
    pub fn time(&self) -> f64 {
        self.view.time
    }

    /// The wire that is shown in place of the picture.
    pub(crate) fn wire(&self) -> Option<&ShownWire> {
        self.view.wire.as_ref()
    }

    /// Shows a wire in place of the picture, or the picture again.
    pub(crate) fn show_wire(&mut self, wire: Option<ShownWire>) {
        if self.view.wire != wire {
            self.view.wire = wire;
            self.compilation.shaders.requested_structure = None;
        }
    }

    /// The lights that are neither muted nor left out by a solo, with their present values.
    pub(crate) fn shining(&self) -> impl Iterator<Item = (&LightId, &Light)> {
        let lights = self.look().lights.iter().filter(|(id, _)| !self.view.solo.is_dark(id));
        lights.map(|(id, light)| (id, self.light(id).unwrap_or(light)))
    }

    /// The present solo and mute.
    pub(crate) fn solo(&self) -> &Solo {
        &self.view.solo
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

    /// True if a light is neither muted nor left out by a solo.
    pub fn shines(&self, light: &str) -> bool {
        !self.view.solo.is_dark(&light.into())
    }

    /// The look as shown: with soloed layers alone, and without muted lights; or the preview of
    /// another look.
    pub(crate) fn shown_look(&self) -> Cow<'_, Look> {
        match &self.sketchbook.preview {
            Some(preview) => Cow::Borrowed(preview),
            None => self.view.solo.of(self.look(), &self.project.catalog),
        }
    }

    /// Display name of a node of the look's own graph.
    pub(crate) fn title(&self, id: &NodeId) -> String {
        let node = self.look().graph.nodes.get(id);
        match (node, node.and_then(|node| self.project.catalog.of(node))) {
            (Some(node), _) if !node.name.is_empty() => node.name.clone(),
            (_, Some(kind)) => kind.label.to_string(),
            _ => id.to_string(),
        }
    }

    /// Problems of the look, as last reported by the compiler.
    pub fn problems(&self) -> &[Diagnostic] {
        &self.compilation.problems
    }

    pub(crate) fn problems_revision(&self) -> ProblemsRevision {
        self.revisions.problems
    }

    /// Applies an edit. Consecutive edits by the same `hand` (a widget and its press) are one step.
    ///
    /// # Errors
    /// A diagnostic where the edit is impossible; nothing is changed then.
    pub fn apply(&mut self, edit: Edit, hand: Option<u64>) -> Result<(), Box<Diagnostic>> {
        let is_structural = self.is_structural(&edit);
        let means = !is_layout(&edit);
        self.compilation.shaders.touch(&edit);
        if self.look.apply(edit, hand, self.revisions.step + 1)? {
            self.step_done();
            if means {
                self.revisions.meaning.advance();
            }
            self.changed(is_structural);
        }
        Ok(())
    }

    fn undo_look(&mut self) -> bool {
        let did = self.look.undo();
        if did {
            self.revisions.meaning.advance();
            self.changed(true);
        }
        did
    }

    fn redo_look(&mut self) -> bool {
        let did = self.look.redo(self.revisions.step + 1);
        if did {
            self.revisions.step += 1;
            self.revisions.meaning.advance();
            self.changed(true);
        }
        did
    }

    fn changed(&mut self, is_structural: bool) {
        self.set_preview(None);
        if is_structural {
            self.compilation.shaders.structure = self.look.history.revision();
            self.project.sync(self.look.document());
        }
        self.check_place();
        let mut selection = std::mem::take(&mut self.selection.nodes);
        selection.retain(|id| self.is_here(id));
        self.selection.nodes = selection;
        self.keep_solo();
        let nodes = &self.look.document().graph.nodes;
        self.view.wire = self
            .view
            .wire
            .take()
            .filter(|wire| wire.node.outermost().is_some_and(|id| nodes.contains_key(id)));
        self.revisions.picture.advance();
    }

    /// True if an edit cannot be shown by the live shader's uniforms.
    fn is_structural(&self, edit: &Edit) -> bool {
        match edit {
            Edit::Group { edits } => edits.iter().any(|edit| self.is_structural(edit)),
            edit if is_layout(edit) => false,
            // Uniforms of a long look are identified by paths, and a group's node lies at many of
            // them.
            Edit::SetValue { graph: GraphId::Definition(_), .. }
                if self.compilation.shaders.is_long() =>
            {
                true
            }
            // Keys of the same targets have all their values in uniforms, except words.
            Edit::SetDirectionKeys { index, keys } => {
                let targets = |keys: &DirectionKeys| -> HashSet<Target> {
                    keys.keys.iter().flat_map(|key| key.values.keys()).cloned().collect()
                };
                let wires =
                    |keys: &DirectionKeys| keys.by.outputs().cloned().collect::<HashSet<_>>();
                let is_other = |old: &DirectionKeys| {
                    targets(old) != targets(keys) || wires(old) != wires(keys)
                };
                self.look().direction_keys.get(*index).is_none_or(is_other)
            }
            Edit::SetTimeKeys { index, keys } => {
                let is_word = keys.keys.iter().any(|key| matches!(&key.value, Value::Text(_)));
                is_word
                    || self.look().time_keys.get(*index).is_none_or(|old| old.target != keys.target)
            }
            Edit::SetLight { id, light } => self
                .look()
                .lights
                .get(id)
                .is_none_or(|old| (old.kind, &old.name) != (light.kind, &light.name)),
            Edit::SetValue { graph, id, port, .. } => {
                let node = self.look().graph_of(graph).and_then(|graph| graph.nodes.get(id));
                let Some((node, kind)) =
                    node.and_then(|node| Some((node, self.project.catalog.of(node)?)))
                else {
                    return true;
                };
                let Some(port) = kind.input(port.as_str()).map(|index| &kind.inputs[index]) else {
                    return true;
                };
                let had_one = node.values.contains_key(&port.name)
                    || matches!(port.fallback, Fallback::Value(_));
                port.ty.is_setting() || !had_one
            }
            _ => true,
        }
    }

    /// The text that the look was read from.
    pub(crate) fn source(&self) -> &Arc<SourceMap> {
        &self.look.file.source
    }

    /// Problems of the files, the look and the picture.
    pub(crate) fn all_problems(&self) -> impl Iterator<Item = &Diagnostic> {
        let scene = self.stage.iter().flat_map(OpenScene::problems);
        let files = self.look.load_problems.iter().chain(scene).chain(&self.project.problems);
        files.chain(&self.compilation.problems).chain(&self.picture_problems)
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

/// True if an edit changes only the layout of the graph on the canvas, notes, or descriptions.
fn is_layout(edit: &Edit) -> bool {
    match edit {
        Edit::Group { edits } => edits.iter().all(is_layout),
        Edit::MoveNodes { .. }
        | Edit::SetCollapsed { .. }
        | Edit::AddNote { .. }
        | Edit::SetNote { .. }
        | Edit::RemoveNote { .. }
        | Edit::SetBookmarks { .. }
        | Edit::SetLookName { .. }
        | Edit::SetLookAbout { .. } => true,
        _ => false,
    }
}

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
