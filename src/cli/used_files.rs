//! Files that a picture of a document is made of, and their changes while pictures are drawn.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use crate::compile::Live;
use crate::files::{
    Disk, FileMetadata, Files, FoundFiles, OpenFile, ReadError, WalkBounds, shortened,
};
use crate::frame::{AssetStore, Assets, PlanOptions, Planner, open};

use super::open::library_of;

/// Greatest number of files that a message names.
const NAMED: usize = 6;

/// Files of the disk, with those that were read and their states then.
#[derive(Debug, Default)]
pub(super) struct RecordedFiles(Mutex<BTreeMap<PathBuf, ReadStates>>);

/// States of a file when it was read for the first time, and for the last.
#[derive(Clone, Copy, Debug)]
struct ReadStates {
    first: FileMetadata,
    last: FileMetadata,
}

/// A file that is another than it was when it was read first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct ChangedFile {
    pub(super) path: PathBuf,
    pub(super) change: FileChange,
}

/// Change of a file that was read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FileChange {
    /// The file is gone.
    Gone,
    /// The file has another content by now, which nobody has read.
    Unread,
    /// The file has another content by now, and was read again.
    ReadAgain,
}

impl RecordedFiles {
    /// Notes the state of a file that is about to be read: a change while it is read is told, too.
    fn note(&self, path: &Path) {
        let Some(now) = state(path) else { return };
        match self.states().entry(path.to_path_buf()) {
            Entry::Occupied(mut known) => known.get_mut().last = now,
            Entry::Vacant(new) => drop(new.insert(ReadStates { first: now, last: now })),
        }
    }

    fn states(&self) -> MutexGuard<'_, BTreeMap<PathBuf, ReadStates>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Paths of the files that were read, as they were named.
    fn paths(&self) -> Vec<PathBuf> {
        self.states().keys().cloned().collect()
    }

    /// The files that are others by now than when they were read first, by their lengths and the
    /// times of their last changes.
    pub(super) fn changed(&self) -> Vec<ChangedFile> {
        let states = self.states();
        let changed = states.iter().filter_map(|(path, read)| {
            let change = match state(path) {
                None => FileChange::Gone,
                Some(now) if now == read.first => return None,
                Some(now) if now == read.last => FileChange::ReadAgain,
                Some(_) => FileChange::Unread,
            };
            Some(ChangedFile { path: path.clone(), change })
        });
        changed.collect()
    }
}

/// State of a plain file on the disk; examples are in the program, and never change.
fn state(path: &Path) -> Option<FileMetadata> {
    Disk.metadata(path).filter(|_| path.is_file())
}

impl Files for RecordedFiles {
    fn read(&self, path: &Path, most: u64) -> Result<Vec<u8>, ReadError> {
        self.note(path);
        Disk.read(path, most)
    }

    fn open(&self, path: &Path, most: u64) -> Result<Box<dyn OpenFile>, ReadError> {
        self.note(path);
        Disk.open(path, most)
    }

    fn metadata(&self, path: &Path) -> Option<FileMetadata> {
        Disk.metadata(path)
    }

    fn canonical(&self, path: &Path) -> Option<PathBuf> {
        Disk.canonical(path)
    }

    fn walk(
        &self,
        folder: &Path,
        bounds: WalkBounds,
        enters: &dyn Fn(&Path) -> bool,
    ) -> FoundFiles {
        Disk.walk(folder, bounds, enters)
    }
}

/// Absolute paths of the files outside a folder that a picture of a document is made of: documents,
/// meshes, images and HCBTFs, as far as they can be read. Paths are named from that folder.
pub(super) fn outside(folder: &Path, document: &Path) -> Vec<PathBuf> {
    let recorded = Arc::new(RecordedFiles::default());
    let mut assets = Assets::of(&AssetStore::reading_from(recorded.clone()));
    // What is wrong with the document is told by those who draw it.
    if let Ok(setup) = open(document, None, &mut assets) {
        let library = library_of(&*recorded, document, None);
        let options = PlanOptions { size: [16, 16], samples: 1, time: 0.0 };
        // Images are read when a frame is planned.
        let _ = Planner::new(assets).plan(&setup.value, &library, &Live::Keyed, &options);
    }
    let absolute: BTreeSet<PathBuf> =
        recorded.paths().iter().map(|path| shortened(&folder.join(path))).collect();
    absolute.into_iter().filter(|path| !path.starts_with(folder)).collect()
}

/// The names of the first of some files, and the number of the others.
pub(super) fn named<F>(files: &[F], name: impl Fn(&F) -> String) -> String {
    let names: Vec<String> = files.iter().take(NAMED).map(name).collect();
    let left = files.len().saturating_sub(NAMED);
    let more = if left > 0 { format!(" and {left} more") } else { String::new() };
    format!("{}{more}", names.join(", "))
}

/// The innermost folder that holds all of these absolute paths; `None` where that is the root.
pub(super) fn common_folder(paths: &[&Path]) -> Option<PathBuf> {
    let (first, rest) = paths.split_first()?;
    let holds_all = |folder: &&Path| rest.iter().all(|path| path.starts_with(folder));
    let common = first.ancestors().find(holds_all)?;
    common.parent().map(|_| common.to_path_buf())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_that_change_after_they_were_read_are_known() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        let names = ["again", "gone", "same", "unread"];
        let files = RecordedFiles::default();
        for name in names {
            std::fs::write(path(name), "one").unwrap();
            files.read(&path(name), 100).unwrap();
        }
        assert!(files.read(&path("none"), 100).is_err() && files.changed().is_empty());
        std::fs::remove_file(path("gone")).unwrap();
        std::fs::write(path("again"), "others").unwrap();
        std::fs::write(path("unread"), "others").unwrap();
        drop(files.open(&path("again"), 100).unwrap());
        let change = |name: &str, change| ChangedFile { path: path(name), change };
        let expected = [
            change("again", FileChange::ReadAgain),
            change("gone", FileChange::Gone),
            change("unread", FileChange::Unread),
        ];
        assert_eq!(files.changed(), expected);
    }

    #[test]
    fn a_folder_holds_all_that_are_in_it() {
        let common = |paths: &[&str]| {
            let paths: Vec<&Path> = paths.iter().map(Path::new).collect();
            common_folder(&paths).map(|folder| folder.display().to_string())
        };
        assert_eq!(common(&["/p/shots", "/p/looks/a.json"]), Some("/p".to_owned()));
        assert_eq!(common(&["/p/shots", "/q/a.json"]), None);
    }
}
