//! Parts of a session, each with one duty.

use std::path::PathBuf;
use std::sync::Arc;

use super::holding::HeldDocument;
use super::nodes::{NodeFiles, ProjectReader};
use super::shading::ShaderCache;
use crate::catalog::Catalog;
use crate::compile::CompiledShader;
use crate::diag::Diagnostic;
use crate::document::{Look, Tier};
use crate::files::SharedFiles;
use crate::ids::NodePath;
use crate::library::Library;
use crate::state::arrangement;
use crate::state::compiling::Compiler;
use crate::state::crashes::{CrashLog, Suspect};
use crate::state::document::OpenDocument;
use crate::state::revision::{
    DocumentNumber, FilesRevision, LookRevision, MeaningRevision, PictureRevision, PreviewRevision,
    ProblemsRevision, StepTime,
};
use crate::state::sketch::Sketch;

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
    pub(crate) fn set_library(&mut self, mut library: Library) {
        arrangement::place_in_groups(&mut library);
        self.library = Arc::new(library);
        self.catalog = Catalog::new(&self.library);
    }

    /// Learns the groups of a look.
    pub(crate) fn sync(&mut self, look: &Look) {
        self.catalog.sync(look, &self.library);
    }
}

/// The compiler's thread, the shaders that it made, and the problems of the look.
pub struct Compilation {
    pub(crate) compiler: Compiler,
    pub(crate) shaders: ShaderCache,
    pub(crate) problems: Vec<Diagnostic>,
    /// Revision of the look that the shaders last showed.
    pub(crate) shown_revision: (DocumentNumber, LookRevision),
}

impl Compilation {
    /// The shader whose text is shown.
    pub fn baked(&self) -> Option<&Arc<CompiledShader>> {
        self.shaders.baked.as_ref()
    }

    /// The shader whose values are uniforms.
    pub fn live(&self) -> Option<&Arc<CompiledShader>> {
        self.shaders.live.as_ref()
    }

    /// Tier that a node runs in, as the compiler last found it; `None` for a node that it has not
    /// seen, and for groups.
    pub fn tier_of(&self, path: &NodePath) -> Option<Tier> {
        let nodes = &self.shaders.typed.as_ref()?.nodes;
        nodes.iter().find(|node| node.path == *path).map(|node| node.tier)
    }

    /// Problems of the look, as last reported by the compiler.
    pub fn problems(&self) -> &[Diagnostic] {
        &self.problems
    }
}

/// Largest number of looks that were left whose sketches are kept.
const MOST_ASIDE: usize = 16;

/// The sketch on the picture, and the look that was fitted to it.
#[derive(Default)]
pub struct Sketchbook {
    pub(crate) sketch: Sketch,
    /// Sketches on looks that were left, the latest last.
    pub(crate) aside: Vec<((Option<PathBuf>, String), Sketch)>,
    /// Look that is shown in place of the open one.
    pub(crate) preview: Option<Arc<Look>>,
    /// Revision of the preview, which grows whenever another look is shown.
    pub(crate) preview_revision: PreviewRevision,
}

impl Sketchbook {
    /// The sketch on the picture.
    pub fn sketch(&self) -> &Sketch {
        &self.sketch
    }

    /// The look that is shown in place of the open one.
    pub fn preview(&self) -> Option<&Arc<Look>> {
        self.preview.as_ref()
    }

    /// Puts the sketch aside, with the look that it is of.
    pub(super) fn put_aside(&mut self, look: &OpenDocument<Look>) {
        let left = std::mem::take(&mut self.sketch);
        self.sketch.is_open = left.is_open;
        if !left.is_empty() {
            let of = sketched(look);
            self.aside.retain(|(other, _)| *other != of);
            self.aside.push((of, left.without_past()));
            // The oldest sketch is dropped: each is a picture of about a megabyte.
            let surplus = self.aside.len().saturating_sub(MOST_ASIDE);
            self.aside.drain(..surplus);
        }
    }

    /// Restores the sketch that was put aside when this look was left.
    pub(super) fn find(&mut self, look: &OpenDocument<Look>) {
        let of = sketched(look);
        if let Some(index) = self.aside.iter().position(|(other, _)| *other == of) {
            let is_open = self.sketch.is_open;
            self.sketch = self.aside.remove(index).1;
            self.sketch.is_open = is_open;
        }
    }
}

/// Key of the look that a sketch is of: its file, or its name without one.
fn sketched(look: &OpenDocument<Look>) -> (Option<PathBuf>, String) {
    let name = if look.path.is_none() { look.document().name.clone() } else { String::new() };
    (look.path.clone(), name)
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
    pub(crate) holding: HeldDocument,
}

impl Journals {
    /// The suspect that the open document is held back for.
    pub(crate) fn held(&self) -> Option<&Suspect> {
        self.holding.suspect.as_ref()
    }

    /// Compiles and draws the document that was held back.
    pub(crate) fn try_again(&self) {
        if let Some(suspect) = self.held() {
            self.crashes.trust(&suspect.document);
        }
    }
}

/// Revisions of parts of the session that others depend on.
#[derive(Default)]
pub(crate) struct Revisions {
    /// Counter that grows with every step done, in the look, in the scene, in the painting or in
    /// the sketch.
    pub(crate) step: StepTime,
    pub(crate) document: DocumentNumber,
    pub(crate) meaning: MeaningRevision,
    pub(crate) picture: PictureRevision,
    pub(crate) files: FilesRevision,
    pub(crate) problems: ProblemsRevision,
}
