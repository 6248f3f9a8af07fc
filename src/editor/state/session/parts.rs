//! The parts of a session, each with one duty.

use std::path::PathBuf;
use std::sync::Arc;

use indexmap::IndexSet;

use super::holding::Holding;
use super::place::OpenGroups;
use super::project::ProjectReader;
use super::shading::ShaderCache;
use crate::catalog::Catalog;
use crate::diag::Diagnostic;
use crate::document::Look;
use crate::ids::NodeId;
use crate::library::Library;
use crate::state::compiling::Compiler;
use crate::state::orbit::Orbit;
use crate::state::revision::{
    DocumentNumber, FilesRevision, LookRevision, MeaningRevision, PictureRevision, PreviewRevision,
    ProblemsRevision, SoloRevision,
};
use crate::state::safety::crashes::CrashLog;
use crate::state::sketch::Sketch;
use crate::state::solo::Solo;
use crate::state::wire::ShownWire;

/// From where the picture is seen, when, and what of the look it shows.
#[derive(Default)]
pub(crate) struct ViewState {
    pub(crate) orbit: Orbit,
    /// The moment that is shown, in seconds.
    pub(crate) time: f64,
    /// What is shown in place of the look's own output.
    pub(crate) wire: Option<ShownWire>,
    /// What is shown alone or left out for now.
    pub(crate) solo: Solo,
    /// Grows whenever another solo needs another shader.
    pub(crate) solo_revision: SoloRevision,
}

/// What is selected, and which graph is open.
#[derive(Default)]
pub(crate) struct Selection {
    /// Nodes of the graph that is open, the first one selected last.
    pub(crate) nodes: IndexSet<NodeId>,
    /// The direction key that values are set at: its set and its place there.
    pub(crate) key: Option<(usize, usize)>,
    pub(crate) groups: OpenGroups,
}

/// The nodes that the look can have: those that Chiaro ships, and those of the look's folder.
pub(crate) struct Project {
    pub(crate) library: Arc<Library>,
    pub(crate) catalog: Catalog,
    /// What is wrong with the project's own node files.
    pub(crate) problems: Vec<Diagnostic>,
    /// The thread that reads the project's own nodes.
    pub(super) reader: ProjectReader,
}

impl Project {
    /// `wake` is called from another thread when nodes were read.
    pub(crate) fn new(library: Arc<Library>, wake: impl Fn() + Send + 'static) -> Self {
        let reader = ProjectReader::new(wake);
        Self { catalog: Catalog::new(&library), library, problems: Vec::new(), reader }
    }

    /// Takes other nodes. What is wrong with their files is still to be placed.
    pub(crate) fn set_library(&mut self, library: Library) {
        self.library = Arc::new(library);
        self.catalog = Catalog::new(&self.library);
    }

    /// Learns the groups of a look.
    pub(crate) fn sync(&mut self, look: &Look) {
        self.catalog.sync(look, &self.library);
    }
}

/// The compiler's thread, the shaders that it made, and what is wrong with the look.
pub(crate) struct Compilation {
    pub(crate) compiler: Compiler,
    pub(crate) shaders: ShaderCache,
    pub(crate) problems: Vec<Diagnostic>,
    /// The look that the shaders were told last.
    pub(crate) shown_revision: (DocumentNumber, LookRevision),
}

/// What is painted on the picture, and the look that was fitted to it.
#[derive(Default)]
pub(crate) struct Sketchbook {
    pub(crate) sketch: Sketch,
    /// What was painted on looks that were left, the latest last.
    pub(crate) aside: Vec<((Option<PathBuf>, String), Sketch)>,
    /// A look that is shown in place of the open one.
    pub(crate) preview: Option<Arc<Look>>,
    /// Grows whenever that is another.
    pub(crate) preview_revision: PreviewRevision,
}

/// A folder, and who is told when writing there fails or works again.
pub(crate) type JournalFolder = (PathBuf, Arc<dyn Fn() + Send + Sync>);

/// What keeps work from being lost, and a window from breaking over the same document again.
pub(crate) struct Journals {
    /// Where journals are kept.
    pub(crate) folder: Option<JournalFolder>,
    /// The view of the work that was taken back last, until somebody wants it.
    pub(crate) view: Option<serde_json::Value>,
    /// What goes on with documents, for the next window to know if this one ends over it.
    pub(crate) crashes: CrashLog,
    pub(crate) holding: Holding,
}

/// How often things changed that others depend on.
#[derive(Default)]
pub(crate) struct Revisions {
    /// Grows with every step that is done, in the look, in the scene, in the painting or on the
    /// picture.
    pub(crate) step: u64,
    pub(crate) document: DocumentNumber,
    pub(crate) meaning: MeaningRevision,
    pub(crate) picture: PictureRevision,
    pub(crate) files: FilesRevision,
    pub(crate) problems: ProblemsRevision,
}
