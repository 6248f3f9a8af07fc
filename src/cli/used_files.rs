//! Files that a picture of a document is made of.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use crate::compile::Live;
use crate::files::{
    Disk, FileMetadata, Files, FoundFiles, OpenFile, ReadError, WalkBounds, shortened,
};
use crate::frame::{AssetStore, Assets, PlanOptions, Planner, open};

use super::open::library_for;

/// Files of the disk, with the paths of those that were read.
#[derive(Debug, Default)]
struct RecordedFiles(Mutex<BTreeSet<PathBuf>>);

impl RecordedFiles {
    fn note(&self, path: &Path) {
        // Examples are in the program.
        if path.is_file() {
            self.0.lock().unwrap_or_else(PoisonError::into_inner).insert(path.to_path_buf());
        }
    }
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
        let library = library_for(document, None);
        let options = PlanOptions { size: [16, 16], samples: 1, time: 0.0 };
        // Images are read when a frame is planned.
        let _ = Planner::new(assets).plan(&setup.value, &library, &Live::Keyed, &options);
    }
    let read = recorded.0.lock().unwrap_or_else(PoisonError::into_inner);
    let absolute: BTreeSet<PathBuf> =
        read.iter().map(|path| shortened(&folder.join(path))).collect();
    absolute.into_iter().filter(|path| !path.starts_with(folder)).collect()
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
    fn a_folder_holds_all_that_are_in_it() {
        let common = |paths: &[&str]| {
            let paths: Vec<&Path> = paths.iter().map(Path::new).collect();
            common_folder(&paths).map(|folder| folder.display().to_string())
        };
        assert_eq!(common(&["/p/shots", "/p/looks/a.json"]), Some("/p".to_owned()));
        assert_eq!(common(&["/p/shots", "/q/a.json"]), None);
    }
}
