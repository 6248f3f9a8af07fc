//! One open look: the document and its past, the file, what is selected, and the shaders made of
//! it.

mod holding;
pub(crate) mod keeping;
pub(crate) mod kept;
mod painting;
mod place;
mod project;
mod shading;
mod sharing;
mod sketch;
mod stage;
pub(crate) mod times;

use std::borrow::Cow;
use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use indexmap::IndexSet;

use crate::catalog::Catalog;
use crate::diag::Diagnostic;
use crate::document::{
    DirectionKeys, Document, Edit, GraphId, History, Light, Look, SourceMap, Target, Value,
    write_atomic,
};
use crate::ids::{LightId, NodeId};
use crate::library::{Fallback, Library};
use crate::state::compiling::{self, Compiler};
use crate::state::orbit::Orbit;
use crate::state::painting::work::Work;
use crate::state::safety::crashes::CrashLog;
use crate::state::sketch::Sketch;
use crate::state::solo::Solo;
use crate::state::stage::Stage;
use crate::state::wire::ShownWire;
use keeping::OnDisk;
use kept::Kept;
pub(crate) use shading::Showing;
use shading::Shown;

/// One open look.
pub struct Session {
    kept: Kept<Look>,
    /// The scene around the look, where there is one.
    stage: Option<Stage>,
    /// The HCBTF that is being painted, where there is one.
    painting: Option<Work>,
    /// Whether another look is open that does not show it: undo takes nothing back that nobody
    /// sees.
    pub(crate) hides_painting: bool,
    /// What is painted on the picture.
    sketch: Sketch,
    /// What was painted on looks that were left, the latest last.
    sketches: Vec<((Option<PathBuf>, String), Sketch)>,
    /// A look that is shown in place of the open one, and how often that changed.
    preview: Option<Arc<Look>>,
    preview_number: u64,
    /// Grows with every step that is done, in the look, in the scene, in the painting or on the
    /// picture.
    now: u64,
    source: Arc<SourceMap>,
    /// As it was opened: what says the same again after a save is written as it was.
    opened: Arc<SourceMap>,
    path: Option<PathBuf>,
    /// Whether the file holds more than could be read, so that saving over it would lose that.
    is_partial: bool,
    pub(crate) library: Arc<Library>,
    pub(crate) catalog: Catalog,
    /// Nodes of the graph that is open, the first one selected last.
    pub(crate) selection: IndexSet<NodeId>,
    pub(crate) view: Orbit,
    /// The moment that is shown, in seconds.
    pub(crate) time: f64,
    /// The direction key that values are set at: its set and its place there.
    pub(crate) key: Option<(usize, usize)>,
    pub(crate) keyed: crate::state::keying::Keyed,
    /// What reading the file told.
    pub(crate) load_problems: Vec<Diagnostic>,
    /// What is wrong with the project's own node files.
    library_problems: Vec<Diagnostic>,
    compiler: Compiler,
    /// Meshes and images that all pictures of the window share.
    pub(crate) assets: crate::frame::AssetStore,
    /// What goes on with documents, for the next window to know if this one ends over it.
    pub(crate) crashes: CrashLog,
    holding: holding::Holding,
    shaders: Shown,
    problems: Vec<Diagnostic>,
    /// What keeps the picture from being drawn, or was odd about it.
    picture_problems: Vec<Diagnostic>,
    problems_number: u64,
    document_number: u64,
    picture: u64,
    good_revision: (u64, u64),
    /// What is shown in place of the look's own output.
    wire: Option<ShownWire>,
    /// What is shown alone or left out for now.
    solo: Solo,
    /// Grows whenever another solo needs another shader.
    solo_number: u64,
    /// Grows with every change of what nodes give, and not while they are only moved about.
    meaning: u64,
    /// How often files that the look uses have changed.
    files: u64,
    /// Whether the first picture is on its way: small ones wait for it.
    pub(crate) awaits_first_picture: bool,
    /// The view of the work that was taken back last, until somebody wants it.
    kept_view: Option<serde_json::Value>,
    /// Where journals are kept, and who is told when that fails.
    keeps: Option<(PathBuf, Arc<dyn Fn() + Send + Sync>)>,
    place: place::OpenGroups,
}

impl Session {
    /// An empty look, with what every look needs. `wake` is called from another thread when there
    /// is something new.
    pub fn new(library: Arc<Library>, wake: impl Fn() + Send + 'static) -> Self {
        let catalog = Catalog::new(&library);
        let source = Arc::new(Look::read(NEW_LOOK, "new look").source);
        let crashes = CrashLog::default();
        let mut session = Self {
            kept: Kept::new(History::new(Look::default())),
            stage: None,
            painting: None,
            sketch: Sketch::default(),
            sketches: Vec::new(),
            preview: None,
            preview_number: 0,
            hides_painting: false,
            now: 0,
            opened: source.clone(),
            source,
            path: None,
            is_partial: false,
            library,
            catalog,
            selection: IndexSet::new(),
            view: Orbit::default(),
            time: 0.0,
            key: None,
            keyed: Default::default(),
            load_problems: Vec::new(),
            library_problems: Vec::new(),
            compiler: compiling::start(wake, crashes.clone()),
            assets: crate::frame::AssetStore::new(),
            crashes,
            holding: holding::Holding::default(),
            shaders: Shown::default(),
            problems: Vec::new(),
            picture_problems: Vec::new(),
            problems_number: 0,
            document_number: 0,
            picture: 0,
            good_revision: (0, 0),
            wire: None,
            solo: Solo::default(),
            solo_number: 0,
            meaning: 0,
            files: 0,
            awaits_first_picture: false,
            kept_view: None,
            keeps: None,
            place: Default::default(),
        };
        session.start_new();
        session
    }

    /// Begins a new look: a base, one light layer and an output, wired. A scene that is open is put
    /// aside.
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
        self.is_partial = false;
        self.load_problems.clear();
    }

    /// Begins a new look with what a text says, as one that no file holds.
    pub(crate) fn start_from(&mut self, text: &str, name: &str) {
        self.leave_journal(false);
        self.leave_project();
        self.leave_stage(false);
        let loaded = Look::read(text, name);
        self.replace(loaded.value.unwrap_or_default(), loaded.source, None);
        self.is_partial = false;
        self.load_problems = loaded.diagnostics;
    }

    /// Opens a look, within the scene if one is open that wears it, or a scene.
    ///
    /// # Errors
    /// What keeps the file from being read at all; what was open stays then.
    pub fn open(&mut self, path: &Path) -> Result<(), Vec<Diagnostic>> {
        let loaded = match Document::load(path) {
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
        self.is_partial = is_partial;
        self.load_problems = diagnostics;
        self.problems_number += 1;
        Ok(())
    }

    /// Saves to a file, which is the look's own from then on.
    ///
    /// # Errors
    /// A diagnostic that says why not; the old file is then as it was.
    pub fn save_as(&mut self, path: &Path) -> Result<(), Box<Diagnostic>> {
        let is_own = self.path.as_deref() == Some(path);
        if is_own && self.is_partial {
            let message =
                "this file holds things that could not be read, and saving over it would lose them";
            return Err(Box::new(
                Diagnostic::error("partly-read", message).hint("save under another name"),
            ));
        }
        if is_own && let OnDisk::Changed(_) = self.on_disk() {
            let message = "another program has changed this file since it was opened, and nothing \
                           was written over it";
            let hint = "choose above whose version is kept, or save under another name";
            return Err(Box::new(Diagnostic::error("changed-on-disk", message).hint(hint)));
        }
        let names = if is_own { None } else { self.names_of_painting(path) };
        let text = if is_own { self.text() } else { self.look_for(names.as_ref()).to_text() };
        write_atomic(path, text.as_bytes())?;
        self.source = Arc::new(Look::read(&text, &path.display().to_string()).source);
        self.path = Some(path.to_owned());
        self.take_names(names);
        self.kept.history.mark_saved();
        self.is_partial = false;
        self.load_problems.clear();
        self.problems_number += 1;
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

    /// As the file says it, or said it when it was opened, where that is the same; else the
    /// canonical form.
    fn text(&self) -> String {
        let text = self.look().to_text_like(&self.source);
        if text == **self.source.text() { text } else { self.look().to_text_like(&self.opened) }
    }

    fn replace(&mut self, look: Look, source: SourceMap, path: Option<PathBuf>) {
        self.document_number += 1;
        self.set_preview(None);
        self.leave_sketch();
        self.remember_times();
        self.kept.history = History::new(look);
        self.source = Arc::new(source);
        self.opened = self.source.clone();
        self.path = path;
        self.find_sketch();
        self.selection.clear();
        // A scene has the camera, and goes on.
        if self.stage.is_none() {
            self.view = Orbit {
                mesh: self.view.mesh.clone(),
                z_is_up: self.view.z_is_up,
                ..Orbit::default()
            };
            self.time = 0.0;
        }
        self.key = None;
        self.problems.clear();
        self.problems_number += 1;
        self.shaders = Shown::default();
        self.wire = None;
        self.solo.keep_for_scene(self.stage.as_ref().map(Stage::scene));
        self.picture += 1;
        self.catalog.sync(self.kept.history.document(), &self.library);
        self.place_library_problems();
        self.reset_place();
        self.stage_changed();
    }

    /// The look as it is.
    pub fn look(&self) -> &Look {
        self.kept.history.document()
    }

    /// The file, once there is one.
    pub fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// What people call the look: as its file, or else as itself. One that is called as what is
    /// painted is told from that.
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

    /// Whether there are changes that no file holds, of the look or of the scene around it.
    pub fn is_dirty(&self) -> bool {
        self.is_look_dirty() || self.stage.as_ref().is_some_and(Stage::is_dirty)
    }

    /// Whether there are changes of the look that no file holds.
    pub fn is_look_dirty(&self) -> bool {
        !self.kept.history.is_saved()
    }

    /// Which document is open, as revisions of each begin anew.
    pub(crate) fn document_number(&self) -> u64 {
        self.document_number
    }

    /// Grows with every change.
    pub fn revision(&self) -> u64 {
        self.kept.history.revision()
    }

    /// Grows with every change of what nodes give; it stays while they are only moved about.
    pub(crate) fn meaning(&self) -> u64 {
        self.meaning
    }

    /// Nodes that are selected.
    pub fn selected(&self) -> impl Iterator<Item = &NodeId> {
        self.selection.iter()
    }

    /// Selects nodes and no others.
    pub fn select(&mut self, ids: Vec<NodeId>) {
        self.selection = ids.into_iter().filter(|id| self.is_here(id)).collect();
    }

    /// Lets unsaved changes of the look or of the scene go: they are no longer asked about.
    pub(crate) fn give_up_changes(&mut self, of_look: bool, of_scene: bool) {
        if of_look {
            self.kept.history.mark_saved();
        }
        if let Some(stage) = self.stage.as_mut().filter(|_| of_scene) {
            stage.give_up_changes();
        }
    }

    /// Where the camera and the lights are turned to.
    pub fn orbit(&self) -> &Orbit {
        &self.view
    }

    /// The moment that is shown, in seconds.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// The wire that is shown in place of the picture.
    pub(crate) fn wire(&self) -> Option<&ShownWire> {
        self.wire.as_ref()
    }

    /// Shows a wire in place of the picture, or the picture again.
    pub(crate) fn show_wire(&mut self, wire: Option<ShownWire>) {
        if self.wire != wire {
            self.wire = wire;
            self.shaders.requested_structure = None;
        }
    }

    /// The lights that are neither muted nor left out by a solo, as they are now.
    pub(crate) fn shining(&self) -> impl Iterator<Item = (&LightId, &Light)> {
        let lights = self.look().lights.iter().filter(|(id, _)| !self.solo.is_dark(id));
        lights.map(|(id, light)| (id, self.light(id).unwrap_or(light)))
    }

    /// What is shown alone or left out for now.
    pub(crate) fn solo(&self) -> &Solo {
        &self.solo
    }

    /// Shows other things alone, or leaves other things out. The document stays as it is.
    pub(crate) fn set_solo(&mut self, solo: Solo) {
        if self.solo == solo {
            return;
        }
        if self.solo.is_structural(&solo, self.look()) {
            self.solo_number += 1;
            self.shaders.requested_structure = None;
        }
        self.solo = solo;
        self.picture += 1;
    }

    /// Whether a light shines, as far as the window is asked: it is neither muted nor is another
    /// one shown alone.
    pub fn shines(&self, light: &str) -> bool {
        !self.solo.is_dark(&light.into())
    }

    /// The look as it is shown: what is soloed alone, and without what is muted; or the preview of
    /// another.
    pub(crate) fn shown_look(&self) -> Cow<'_, Look> {
        match &self.preview {
            Some(preview) => Cow::Borrowed(preview),
            None => self.solo.of(self.look(), &self.catalog),
        }
    }

    /// What a node of the look's own graph is called.
    pub(crate) fn title(&self, id: &NodeId) -> String {
        let node = self.look().graph.nodes.get(id);
        match (node, node.and_then(|node| self.catalog.of(node))) {
            (Some(node), _) if !node.name.is_empty() => node.name.clone(),
            (_, Some(kind)) => kind.label.to_string(),
            _ => id.to_string(),
        }
    }

    /// What is wrong with the look, as the compiler last told.
    pub fn problems(&self) -> &[Diagnostic] {
        &self.problems
    }

    pub(crate) fn problems_number(&self) -> u64 {
        self.problems_number
    }

    /// Applies an edit. With a `hand` (a widget and its press), consecutive edits by it are one
    /// step.
    ///
    /// # Errors
    /// A diagnostic where the edit is impossible; nothing is changed then.
    pub fn apply(&mut self, edit: Edit, hand: Option<u64>) -> Result<(), Box<Diagnostic>> {
        let is_structural = self.is_structural(&edit);
        let means = !is_layout(&edit);
        self.shaders.touch(&edit);
        if self.kept.apply(edit, hand, self.now + 1)? {
            self.step_done();
            self.meaning += u64::from(means);
            self.changed(is_structural);
        }
        Ok(())
    }

    fn undo_look(&mut self) -> bool {
        let did = self.kept.undo();
        if did {
            self.meaning += 1;
            self.changed(true);
        }
        did
    }

    fn redo_look(&mut self) -> bool {
        let did = self.kept.redo(self.now + 1);
        if did {
            self.now += 1;
            self.meaning += 1;
            self.changed(true);
        }
        did
    }

    fn changed(&mut self, is_structural: bool) {
        self.set_preview(None);
        if is_structural {
            self.shaders.structure = self.kept.history.revision();
            self.catalog.sync(self.kept.history.document(), &self.library);
        }
        self.check_place();
        let mut selection = std::mem::take(&mut self.selection);
        selection.retain(|id| self.is_here(id));
        self.selection = selection;
        self.keep_solo();
        let nodes = &self.kept.history.document().graph.nodes;
        self.wire = self
            .wire
            .take()
            .filter(|wire| wire.node.outermost().is_some_and(|id| nodes.contains_key(id)));
        self.picture += 1;
    }

    /// Whether a live shader cannot show an edit by its uniforms.
    fn is_structural(&self, edit: &Edit) -> bool {
        match edit {
            Edit::Group { edits } => edits.iter().any(|edit| self.is_structural(edit)),
            edit if is_layout(edit) => false,
            // A long look's uniforms are told by paths, and a group's node lies at many of them.
            Edit::SetValue { graph: GraphId::Definition(_), .. } if self.shaders.is_long() => true,
            // Where the same is keyed, all of it is in uniforms; words are not.
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
                let Some((node, kind)) = node.and_then(|node| Some((node, self.catalog.of(node)?)))
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
        &self.source
    }

    /// Everything wrong with the file and the look.
    pub(crate) fn all_problems(&self) -> impl Iterator<Item = &Diagnostic> {
        let scene = self.stage.iter().flat_map(Stage::problems);
        let files = self.load_problems.iter().chain(scene).chain(&self.library_problems);
        files.chain(&self.problems).chain(&self.picture_problems)
    }

    /// Takes what the renderer tells.
    pub(crate) fn set_picture_problems(&mut self, problems: &[Diagnostic]) {
        if self.picture_problems != problems {
            self.picture_problems = problems.to_vec();
            self.problems_number += 1;
        }
    }
}

/// Whether an edit changes only how the graph lies on the canvas and what is written there.
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

/// What a new look begins with.
const NEW_LOOK: &str = r##"{
  "name": "New look",
  "lights": {"key": {"direction": [-0.5, 0.7, 0.6]}},
  "nodes": [
    {"id": "base", "kind": "base", "at": [0, 0], "values": {"color": [0.16, 0.15, 0.2]}},
    {"id": "diffuse", "kind": "light_layer", "at": [260, 0], "name": "Diffuse", "values": {"light": "key", "convex": [0.85, 0.72, 0.6], "concave": [0.7, 0.45, 0.42]}},
    {"id": "output", "kind": "output", "at": [520, 0]}
  ],
  "wires": [
    {"from": "base", "to": "diffuse.below"},
    {"from": "diffuse", "to": "output.color"}
  ]
}"##;
