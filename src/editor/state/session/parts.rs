//! Parts of a session, each with one duty.

use std::path::PathBuf;
use std::sync::Arc;

use indexmap::IndexSet;

use super::holding::Holding;
use super::nodes::{NodeFiles, ProjectReader};
use super::place::OpenGroups;
use super::shading::ShaderCache;
use crate::catalog::Catalog;
use crate::diag::Diagnostic;
use crate::document::Look;
use crate::files::SharedFiles;
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

/// View and moment of the picture, and the shown part of the look.
#[derive(Default)]
pub(crate) struct ViewState {
    pub(crate) orbit: Orbit,
    /// The moment in the picture, in seconds.
    pub(crate) time: f64,
    /// Wire that is shown in place of the look's own output.
    pub(crate) wire: Option<ShownWire>,
    /// Layers and lights that are shown alone or left out for now.
    pub(crate) solo: Solo,
    /// Revision of the solo, which grows whenever another solo needs another shader.
    pub(crate) solo_revision: SoloRevision,
}

/// The selection, and the open graph.
#[derive(Default)]
pub(crate) struct Selection {
    /// Selected nodes of the open graph, the first one selected last.
    pub(crate) nodes: IndexSet<NodeId>,
    /// The direction key that values are set at: the index of its set, and its index there.
    pub(crate) key: Option<(usize, usize)>,
    pub(crate) groups: OpenGroups,
}

/// The nodes that the look can have: those that Chiaro ships, and those of the look's folder.
pub(crate) struct Project {
    pub(crate) library: Arc<Library>,
    pub(crate) catalog: Catalog,
    /// Problems of the project's own node files.
    pub(crate) problems: Vec<Diagnostic>,
    /// Files of the project's own nodes as they were read.
    pub(crate) files: Arc<NodeFiles>,
    /// True if the nodes were read again because their files had changed, until somebody is told.
    pub(crate) has_changed: bool,
    /// Reader of the project's own nodes, on a thread.
    pub(super) reader: ProjectReader,
}

impl Project {
    /// Creates the project. `wake` is called from another thread when nodes were read.
    pub(crate) fn new(
        library: Arc<Library>,
        files: SharedFiles,
        wake: impl Fn() + Send + 'static,
    ) -> Self {
        Self {
            catalog: Catalog::new(&library),
            library,
            problems: Vec::new(),
            files: Arc::default(),
            has_changed: false,
            reader: ProjectReader::new(files, wake),
        }
    }

    /// Leaves the project: its nodes are no longer waited for.
    pub(super) fn leave(&mut self) {
        self.reader.forget();
        self.files = Arc::default();
    }

    /// Takes other nodes. The problems of their files are still to be placed.
    pub(crate) fn set_library(&mut self, library: Library) {
        self.library = Arc::new(library);
        self.catalog = Catalog::new(&self.library);
    }

    /// Learns the groups of a look.
    pub(crate) fn sync(&mut self, look: &Look) {
        self.catalog.sync(look, &self.library);
    }
}

/// The compiler's thread, the shaders that it made, and the problems of the look.
pub(crate) struct Compilation {
    pub(crate) compiler: Compiler,
    pub(crate) shaders: ShaderCache,
    pub(crate) problems: Vec<Diagnostic>,
    /// Revision of the look that the shaders last showed.
    pub(crate) shown_revision: (DocumentNumber, LookRevision),
}

/// The sketch on the picture, and the look that was fitted to it.
#[derive(Default)]
pub(crate) struct Sketchbook {
    pub(crate) sketch: Sketch,
    /// Sketches on looks that were left, the latest last.
    pub(crate) aside: Vec<((Option<PathBuf>, String), Sketch)>,
    /// Look that is shown in place of the open one.
    pub(crate) preview: Option<Arc<Look>>,
    /// Revision of the preview, which grows whenever another look is shown.
    pub(crate) preview_revision: PreviewRevision,
}

/// A folder of journals, and a function to call when writing there fails or works again.
pub(crate) type JournalFolder = (PathBuf, Arc<dyn Fn() + Send + Sync>);

/// Parts that keep work from being lost, and a window from breaking over the same document again.
pub(crate) struct Journals {
    /// Folder of the journals.
    pub(crate) folder: Option<JournalFolder>,
    /// Saved view of the work that was last taken back, until somebody wants it.
    pub(crate) view: Option<serde_json::Value>,
    /// Log of steps under way, for the next window to know if this one ends over a document.
    pub(crate) crashes: CrashLog,
    pub(crate) holding: Holding,
}

/// Revisions of parts of the session that others depend on.
#[derive(Default)]
pub(crate) struct Revisions {
    /// Counter that grows with every step done, in the look, in the scene, in the painting or in
    /// the sketch.
    pub(crate) step: u64,
    pub(crate) document: DocumentNumber,
    pub(crate) meaning: MeaningRevision,
    pub(crate) picture: PictureRevision,
    pub(crate) files: FilesRevision,
    pub(crate) problems: ProblemsRevision,
}
