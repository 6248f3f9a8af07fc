//! Reader of a project's own nodes, off the window's thread: the folder may be a stranger's, full
//! of files, on a disk that is slow.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::Arc;

use crate::files::{FileMetadata, Files, SharedFiles, remove_abandoned};
use crate::library::{Library, node_files};
use crate::state::revision::RequestNumber;
use crate::state::worker::Worker;

/// Files of a project's nodes as they were read, and the folders that they lie in.
#[derive(Debug, Default, PartialEq, Eq)]
pub(crate) struct NodeFiles {
    files: BTreeMap<PathBuf, Option<FileMetadata>>,
    /// Folders with nodes, and those below them that are looked at.
    pub(crate) folders: BTreeSet<PathBuf>,
}

impl NodeFiles {
    fn below(files: &dyn Files, roots: &[PathBuf]) -> Self {
        let mut nodes = Self::default();
        for found in roots.iter().map(|root| node_files(files, root)) {
            let with_state = |path: PathBuf| (path.clone(), files.metadata(&path));
            nodes.files.extend(found.files.into_iter().map(with_state));
            nodes.folders.extend(found.folders);
        }
        nodes
    }
}

/// Work for the reader.
#[derive(Default)]
struct ProjectRequest {
    /// Folders in which programs that ended may have left temporary files.
    swept: BTreeSet<PathBuf>,
    nodes: Option<NodesRequest>,
}

/// Folders of nodes to read.
struct NodesRequest {
    /// Folders of nodes, whether they exist or not.
    folders: Vec<PathBuf>,
    /// Number of the project.
    number: RequestNumber,
    /// True if a node whose file is broken stays as it was.
    keeps_broken: bool,
    /// True if nodes are read only where their files have changed since they were read.
    only_changed: bool,
}

/// Library of the nodes in a project's folders, beside those that Chiaro ships.
pub(super) struct NodesAnswer {
    number: RequestNumber,
    /// `None` where only folders have come or gone.
    pub(super) library: Option<Library>,
    pub(super) files: Arc<NodeFiles>,
    /// True if a node whose file is broken stays as it was.
    pub(super) keeps_broken: bool,
    /// True if the files were found changed.
    pub(super) is_change: bool,
}

/// Reader of a project's own nodes, on a thread.
pub(super) struct ProjectReader {
    worker: Worker<ProjectRequest, Option<NodesAnswer>>,
    /// Number of the project; answers about another project are ignored.
    number: RequestNumber,
    /// True while the project's nodes are being read, or are read and not taken yet.
    is_awaited: bool,
}

impl ProjectReader {
    /// Starts the thread. `wake` is called from another thread when nodes were read.
    pub(super) fn new(files: SharedFiles, wake: impl Fn() + Send + 'static) -> Self {
        let mut known = (RequestNumber::default(), Arc::default());
        let work = move |request: ProjectRequest| {
            request.swept.iter().for_each(|folder| remove_abandoned(folder));
            read(&*files, &mut known, request.nodes?)
        };
        Self {
            worker: Worker::new("nodes", wake, work),
            number: RequestNumber::default(),
            is_awaited: false,
        }
    }

    /// Removes temporary files that ended programs left in a folder.
    pub(super) fn sweep(&self, folder: PathBuf) {
        self.worker.request(|waiting| {
            let mut request = waiting.unwrap_or_default();
            request.swept.insert(folder);
            request
        });
    }

    /// Reads the nodes of another project, or of the same one whatever its files are.
    pub(super) fn read(&mut self, folders: Vec<PathBuf>, keeps_broken: bool) {
        self.forget();
        self.is_awaited = true;
        self.ask(folders, keeps_broken, false);
    }

    /// Reads the nodes again if their files have changed.
    pub(super) fn check(&self, folders: Vec<PathBuf>) {
        self.ask(folders, true, true);
    }

    fn ask(&self, folders: Vec<PathBuf>, keeps_broken: bool, only_changed: bool) {
        let number = self.number;
        self.worker.request(|waiting| {
            let ProjectRequest { swept, nodes } = waiting.unwrap_or_default();
            // A request that still waits is replaced; only its wishes to read all nodes, and not to
            // keep broken ones, last.
            let is_all = |nodes: &NodesRequest| !nodes.only_changed && nodes.number == number;
            let nodes = NodesRequest {
                folders,
                number,
                keeps_broken: keeps_broken && nodes.as_ref().is_none_or(|nodes| nodes.keeps_broken),
                only_changed: only_changed && !nodes.as_ref().is_some_and(is_all),
            };
            ProjectRequest { swept, nodes: Some(nodes) }
        });
    }

    /// Ignores answers to requests under way: the project is left.
    pub(super) fn forget(&mut self) {
        self.number.advance();
        self.is_awaited = false;
    }

    /// Nodes of the project that were read since the last call, oldest first.
    pub(super) fn answers(&mut self) -> Vec<NodesAnswer> {
        let answers = self.worker.answers().into_iter().flatten();
        let answers: Vec<_> = answers.filter(|answer| answer.number == self.number).collect();
        self.is_awaited &= answers.is_empty();
        answers
    }

    /// True while the project's nodes are being read, or are read and not taken yet.
    pub(super) fn is_awaited(&self) -> bool {
        self.is_awaited
    }

    /// Waits until no nodes are being read.
    pub(super) fn wait(&self) {
        self.worker.wait();
    }
}

/// Reads the nodes of a request; `known` is the number of the project that was read last, and its
/// files. `None` where nothing has changed.
fn read(
    files: &dyn Files,
    known: &mut (RequestNumber, Arc<NodeFiles>),
    request: NodesRequest,
) -> Option<NodesAnswer> {
    let NodesRequest { mut folders, number, keeps_broken, only_changed } = request;
    if known.0 != number {
        *known = (number, Arc::default());
    }
    folders.retain(|path| files.is_folder(path));
    // The state is taken before reading: a change in between is noticed the next time.
    let found = NodeFiles::below(files, &folders);
    if only_changed && found == *known.1 {
        return None;
    }
    let is_same = only_changed && found.files == known.1.files;
    let add = |library: Library, folder: &PathBuf| library.with_project(files, folder);
    let library = (!is_same).then(|| folders.iter().fold(Library::built_in().clone(), add));
    let found = Arc::new(found);
    known.1 = found.clone();
    Some(NodesAnswer { number, library, files: found, keeps_broken, is_change: only_changed })
}
