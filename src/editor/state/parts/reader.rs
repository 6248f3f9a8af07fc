//! Reader of the library's folders, off the window's thread: they may be others', full of files, on
//! a disk that is slow. Files that have not changed are not read again.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::tr;

use super::Part;
use crate::catalog::Catalog;
use crate::document::{Document, Look};
use crate::files::{FileKind, FileMetadata, Files, SharedFiles, WalkBounds};
use crate::library::Library;
use crate::state::problem_text::sentence;
use crate::state::worker::{BackgroundJobs, Worker};

/// Bounds of the walk through a folder.
const BOUNDS: WalkBounds = WalkBounds { depth: 4, entries: 4000 };
/// Greatest number of parts of a folder.
const MOST_PARTS: usize = 1000;
/// Greatest length of a part's file, in bytes.
const MOST_BYTES: u64 = 4 << 20;
/// Greatest length of all files of a folder that are read, in bytes.
const MOST_OF_ALL: u64 = 64 << 20;

/// Parts of one folder.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct FoundParts {
    pub(crate) folder: PathBuf,
    /// Parts by name.
    pub(crate) parts: Vec<Arc<Part>>,
    /// False for a folder that is not there, such as one on a server that cannot be reached.
    pub(crate) is_there: bool,
    /// Reason why parts may lack; `None` where all are there.
    pub(crate) lacking: Option<String>,
    /// True where no file can be made in the folder.
    pub(crate) is_read_only: bool,
}

/// Parts that were read before, by file, with the state of the file.
type KnownParts = HashMap<PathBuf, (Option<FileMetadata>, Arc<Part>)>;

/// Reader of folders of parts, on a thread.
pub(crate) struct PartsReader {
    worker: Worker<Vec<PathBuf>, Vec<FoundParts>>,
}

impl PartsReader {
    /// Starts the thread. `wake` is called from another thread when folders were read.
    pub(crate) fn new(files: SharedFiles, wake: impl Fn() + Send + 'static) -> Self {
        let mut known = KnownParts::new();
        let read = move |folders: Vec<PathBuf>| {
            let mut now = KnownParts::new();
            let found =
                folders.iter().map(|folder| found_in(&*files, folder, &known, &mut now)).collect();
            known = now;
            found
        };
        Self { worker: Worker::new("parts", wake, read) }
    }

    /// Reads folders, in place of any that still wait.
    pub(crate) fn read(&self, folders: Vec<PathBuf>) {
        self.worker.request(|_| folders);
    }

    /// Folders as they were read last, since the last call.
    pub(crate) fn answer(&self) -> Option<Vec<FoundParts>> {
        self.worker.answers().pop()
    }
}

impl BackgroundJobs for PartsReader {
    fn is_busy(&self) -> bool {
        self.worker.is_busy()
    }

    fn wait(&self) {
        self.worker.wait();
    }
}

/// Parts of a folder. Those of `known` whose files have not changed are taken from there; all are
/// noted in `now`.
fn found_in(
    files: &dyn Files,
    folder: &Path,
    known: &KnownParts,
    now: &mut KnownParts,
) -> FoundParts {
    let mut found = FoundParts { folder: folder.to_path_buf(), ..FoundParts::default() };
    if files.metadata(folder).is_none() {
        return found;
    }
    found.is_there = true;
    // Permissions do not tell everything: a trial does. The file has no name on Linux, and is gone
    // at once elsewhere.
    found.is_read_only = tempfile::tempfile_in(folder).is_err();
    let walked = files.walk(folder, BOUNDS, &|inner| inner == folder || !is_hidden(inner));
    if walked.is_cut {
        found.lacking = Some(tr!(
            "It has more than {count} entries; others are left out",
            count = BOUNDS.entries
        ));
    } else if let Some((inner, error)) = walked.unreadable.first() {
        let (path, why) = (inner.display(), error.kind());
        found.lacking = Some(tr!("{path} cannot be read: {why}"));
    }
    let library = Library::built_in();
    let mut catalog = Catalog::new(library);
    let mut bytes = 0;
    let is_part = |path: &PathBuf| {
        path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("json"))
            && !is_hidden(path)
    };
    for path in walked.files.into_iter().filter(is_part) {
        let state = files.metadata(&path);
        bytes += state.map_or(0, |state| state.length.min(MOST_BYTES));
        if found.parts.len() == MOST_PARTS || bytes > MOST_OF_ALL {
            found.lacking = Some(tr!(
                "It has more than {MOST_PARTS} files, or more than {size} MiB; others are left out",
                size = MOST_OF_ALL >> 20
            ));
            break;
        }
        let part = match known.get(&path) {
            Some((before, part)) if *before == state => part.clone(),
            _ => Arc::new(read(files, &path, state, &mut catalog)),
        };
        now.insert(path, (state, part.clone()));
        found.parts.push(part);
    }
    found.parts.sort_by_cached_key(|part| part.name.to_lowercase());
    found
}

/// Part of a file; one that cannot be read has the reason in place of its content.
fn read(
    files: &dyn Files,
    path: &Path,
    state: Option<FileMetadata>,
    catalog: &mut Catalog,
) -> Part {
    let broken = |why: String| Part {
        path: path.to_path_buf(),
        name: path.file_stem().unwrap_or_default().to_string_lossy().into_owned(),
        tags: String::new(),
        about: String::new(),
        content: Err(why),
    };
    match state {
        Some(state) if state.kind != FileKind::Plain => {
            return broken(tr!("It is no plain file").to_owned());
        }
        Some(state) if state.length > MOST_BYTES => {
            return broken(tr!(
                "It is larger than {size} MiB, which no part of a look is; Open reads it",
                size = MOST_BYTES >> 20
            ));
        }
        _ => {}
    }
    match Document::load(files, path) {
        Document::Look(loaded) => match loaded.value {
            Some(look) => of_look(path, look, catalog),
            None => {
                let first = loaded.diagnostics.iter().find(|problem| problem.is_error());
                broken(first.map_or_else(|| tr!("It cannot be read").to_owned(), sentence))
            }
        },
        Document::Scene(_) => broken(tr!("It is a scene: Open shows it").to_owned()),
        Document::Shot(_) => broken(tr!("It is a shot: Open shows it").to_owned()),
    }
}

/// Part of a look, in a catalog that takes the look's own groups.
pub(super) fn of_look(path: &Path, look: Look, catalog: &mut Catalog) -> Part {
    catalog.sync(&look, Library::built_in());
    Part::of(path.to_path_buf(), look, catalog)
}

fn is_hidden(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name.to_string_lossy().starts_with('.'))
}
