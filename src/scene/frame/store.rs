//! Store of files that were read, shared by all pictures made of them.
//!
//! A window has a dozen planners on as many threads, which show the same meshes, images and HCBTFs.
//! Each planner holds what its own pictures use, in its [`Assets`](super::Assets); the store knows
//! where all of these values are, and holds none itself: values that no picture uses any more are
//! gone. A request for a file that another thread is just reading waits for that thread.

use std::collections::HashMap;
use std::hash::Hash;
use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError, Weak};

use super::assets::Image;
use crate::diag::{Diagnostic, WithWarnings};
use crate::files::{Disk, FileMetadata, SharedFiles};
use crate::geometry::Mesh;
use crate::hcbtf::LayerOptions;

/// State of an asset when it was read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct AssetStamp {
    /// State of the file. `None` where there is none.
    file: Option<FileMetadata>,
    /// Tag of the language that the warnings are told in.
    language: &'static str,
}

impl AssetStamp {
    /// Stamp of an asset that is read now, of a file in this state.
    pub(super) fn now(file: Option<FileMetadata>) -> Self {
        Self { file, language: chiaro_locale::spoken_tag() }
    }

    /// True if an asset that was read then is what would be read now: warnings are made in words,
    /// so that in another language the file is read again where there are any.
    pub(super) fn is_same(self, now: Self, warnings: &[Diagnostic]) -> bool {
        self.file == now.file && (warnings.is_empty() || self.language == now.language)
    }
}

/// Meshes, images and HCBTFs that some picture holds, and the files that they are read from. Clones
/// are handles to the same store.
#[derive(Clone, Debug, Default)]
pub struct AssetStore(Arc<Shelves>);

#[derive(Debug)]
struct Shelves {
    files: SharedFiles,
    meshes: Shelf<String, Mesh>,
    images: Shelf<PathBuf, Image>,
    hcbtfs: Shelf<HcbtfKey, Image>,
    reads: AtomicU64,
}

/// Key of an HCBTF's texture: everything that it depends on beside the file's content.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct HcbtfKey {
    pub(super) path: PathBuf,
    pub(super) options: LayerOptions,
    /// True if the rules make samples for few directions only.
    pub(super) is_draft: bool,
}

impl Default for Shelves {
    fn default() -> Self {
        Self {
            files: Arc::new(Disk),
            meshes: Shelf::default(),
            images: Shelf::default(),
            hcbtfs: Shelf::default(),
            reads: AtomicU64::new(0),
        }
    }
}

impl AssetStore {
    /// An empty store of files of the disk.
    pub fn new() -> Self {
        Self::default()
    }

    /// An empty store of `files`.
    pub fn reading_from(files: SharedFiles) -> Self {
        Self(Arc::new(Shelves { files, ..Shelves::default() }))
    }

    /// Files that meshes, images, HCBTFs and documents of the store are read from.
    pub fn source(&self) -> &SharedFiles {
        &self.0.files
    }

    /// True if both are handles to the same store.
    pub fn is_same(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }

    /// Number of times that a file was read, or a built-in shape made, since the store was made.
    pub fn reads(&self) -> u64 {
        self.0.reads.load(Ordering::Relaxed)
    }

    /// Number of meshes, images and HCBTFs that some picture holds.
    pub fn len(&self) -> usize {
        self.0.meshes.len() + self.0.images.len() + self.0.hcbtfs.len()
    }

    /// True if no picture holds anything.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    pub(super) fn mesh(
        &self,
        key: &str,
        stamp: AssetStamp,
        read: impl FnOnce() -> Result<WithWarnings<Mesh>, Vec<Diagnostic>>,
    ) -> Result<WithWarnings<Arc<Mesh>>, Vec<Diagnostic>> {
        self.0.meshes.get(&key.to_owned(), stamp, || self.counted(read))
    }

    pub(super) fn image(
        &self,
        path: &PathBuf,
        stamp: AssetStamp,
        read: impl FnOnce() -> Result<Image, Diagnostic>,
    ) -> Result<Arc<Image>, Diagnostic> {
        let read = || self.counted(read).map(WithWarnings::from);
        self.0.images.get(path, stamp, read).map(|warned| warned.value)
    }

    pub(super) fn hcbtf(
        &self,
        key: &HcbtfKey,
        stamp: AssetStamp,
        read: impl FnOnce() -> Result<WithWarnings<Image>, Vec<Diagnostic>>,
    ) -> Result<WithWarnings<Arc<Image>>, Vec<Diagnostic>> {
        self.0.hcbtfs.get(key, stamp, || self.counted(read))
    }

    fn counted<T>(&self, read: impl FnOnce() -> T) -> T {
        self.0.reads.fetch_add(1, Ordering::Relaxed);
        read()
    }
}

/// Values of one kind by their names.
#[derive(Debug)]
struct Shelf<K, T>(Mutex<HashMap<K, StoreSlot<T>>>);

/// A value, or `None` until it has been read. The reading thread holds the lock.
type StoreSlot<T> = Arc<Mutex<Option<StoreEntry<T>>>>;

#[derive(Debug)]
struct StoreEntry<T> {
    stamp: AssetStamp,
    value: Weak<T>,
    warnings: Vec<Diagnostic>,
}

impl<K, T> Default for Shelf<K, T> {
    fn default() -> Self {
        Self(Mutex::new(HashMap::new()))
    }
}

impl<K: Clone + Eq + Hash, T> Shelf<K, T> {
    /// The value of a file as it is now; calls `read` where nobody holds the value.
    fn get<E>(
        &self,
        key: &K,
        stamp: AssetStamp,
        read: impl FnOnce() -> Result<WithWarnings<T>, E>,
    ) -> Result<WithWarnings<Arc<T>>, E> {
        let slot = self.slot(key);
        let mut entry = slot.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) =
            entry.as_ref().filter(|known| known.stamp.is_same(stamp, &known.warnings))
            && let Some(value) = known.value.upgrade()
        {
            return Ok(WithWarnings::new(value, known.warnings.clone()));
        }
        let warned = read()?.map(Arc::new);
        let value = Arc::downgrade(&warned.value);
        *entry = Some(StoreEntry { stamp, value, warnings: warned.warnings.clone() });
        Ok(warned)
    }

    fn slot(&self, key: &K) -> StoreSlot<T> {
        let mut slots = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        // Every look-up drops the slots that nobody holds, so that the map does not grow.
        slots.retain(|_, slot| is_held(slot));
        slots.entry(key.clone()).or_default().clone()
    }

    fn len(&self) -> usize {
        let slots = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        slots.values().filter(|slot| is_held(slot)).count()
    }
}

/// True if somebody holds the value of a slot, is about to read it, or has just asked for it.
fn is_held<T>(slot: &StoreSlot<T>) -> bool {
    let is_alive = |entry: &Option<StoreEntry<T>>| {
        entry.as_ref().is_some_and(|entry| entry.value.strong_count() > 0)
    };
    Arc::strong_count(slot) > 1 || slot.try_lock().map_or(true, |entry| is_alive(&entry))
}

#[cfg(test)]
mod tests {
    use std::time::SystemTime;

    use super::*;
    use crate::files::FileKind;

    fn get(
        shelf: &Shelf<&'static str, u32>,
        stamp: AssetStamp,
        value: u32,
    ) -> WithWarnings<Arc<u32>> {
        let note = Diagnostic::note("odd", "it is odd");
        shelf.get::<()>(&"a", stamp, || Ok(WithWarnings::new(value, vec![note]))).unwrap()
    }

    const NO_FILE: AssetStamp = AssetStamp { file: None, language: "en" };

    #[test]
    fn a_value_is_read_once_while_somebody_holds_it() {
        let shelf = Shelf::default();
        let first = get(&shelf, NO_FILE, 1);
        let second = get(&shelf, NO_FILE, 2);
        assert!(Arc::ptr_eq(&first.value, &second.value) && second.warnings.len() == 1);
        // Another file lies there now.
        let (kind, modified) = (FileKind::Plain, SystemTime::UNIX_EPOCH);
        let file = Some(FileMetadata { kind, modified, length: 3 });
        let changed = get(&shelf, AssetStamp { file, ..NO_FILE }, 3);
        assert_eq!((*changed.value, *first.value, shelf.len()), (3, 1, 1));
        drop((first, second, changed));
        assert_eq!(shelf.len(), 0, "nobody holds it any more");
        assert_eq!(*get(&shelf, NO_FILE, 4).value, 4);
        // Reading is tried again after a failure.
        assert_eq!(shelf.get(&"b", NO_FILE, || Err("no")).unwrap_err(), "no");
        assert_eq!(*shelf.get::<()>(&"b", NO_FILE, || Ok(5.into())).unwrap().value, 5);
    }

    #[test]
    fn what_is_told_is_read_again_in_another_language() {
        let german = AssetStamp { language: "de", ..NO_FILE };
        let shelf = Shelf::default();
        let told = get(&shelf, NO_FILE, 1);
        assert_eq!([*told.value, *get(&shelf, german, 2).value], [1, 2]);
        // Without a word there is nothing to translate.
        let silent =
            |stamp, value: u32| shelf.get::<()>(&"b", stamp, || Ok(value.into())).unwrap().value;
        let first = silent(NO_FILE, 3);
        assert!(Arc::ptr_eq(&first, &silent(german, 4)));
    }

    #[test]
    #[expect(clippy::disallowed_methods, reason = "the test is of what threads share")]
    fn who_comes_while_it_is_read_waits() {
        let shelf: Shelf<&'static str, u32> = Shelf::default();
        let reads = AtomicU64::new(0);
        let values: Vec<Arc<u32>> = std::thread::scope(|scope| {
            let read = || {
                let read = || -> Result<WithWarnings<u32>, ()> {
                    Ok((reads.fetch_add(1, Ordering::Relaxed) as u32).into())
                };
                shelf.get(&"a", NO_FILE, read).unwrap().value
            };
            // All values are held until the last one has come.
            let threads: Vec<_> = (0..8).map(|_| scope.spawn(read)).collect();
            threads.into_iter().map(|thread| thread.join().unwrap()).collect()
        });
        assert!(values.iter().all(|value| Arc::ptr_eq(value, &values[0])));
        assert_eq!(reads.into_inner(), 1);
    }
}
