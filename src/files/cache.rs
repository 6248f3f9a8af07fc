//! Cache on the disk: results of long work that are the same every time, kept from one start of the
//! program to the next.
//!
//! The program opens the cache of its user when it starts; libraries and tests have none. A cache
//! never fails: what is not there, or damaged, is computed anew, and what cannot be written is not
//! kept. It is bounded, and its oldest entries go first. The folder may be removed at any time.

use std::env::var_os;
use std::ffi::OsString;
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher as _};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::time::SystemTime;

use crate::disk;
use crate::write::{make_folder, write_atomic};

/// Environment variable that names the folder of the cache; set to nothing, there is no cache.
const VARIABLE: &str = "CHIARO_CACHE_DIR";
/// First bytes of an entry, with the version of its form.
const MAGIC: &[u8; 16] = b"chiaro cache 1\r\n";
/// Length of what precedes an entry's content: the first bytes, and a checksum.
const HEADER: usize = MAGIC.len() + size_of::<u64>();
/// Extension of the names of entries.
const EXTENSION: &str = "entry";
/// Greatest length of an entry, in bytes.
const MOST_ENTRY_BYTES: u64 = 128 << 20;
/// Greatest length of all entries together, in bytes.
const MOST_BYTES: u64 = 512 << 20;

/// Cache of the program; `None` inside where its user has no folder for one.
static OPENED: OnceLock<Option<DiskCache>> = OnceLock::new();

/// Opens the cache of the user, for a program that starts.
pub fn open_for_user() {
    OPENED.get_or_init(|| folder(|name| var_os(name)).map(DiskCache::at));
}

/// Cache of the program, if it has opened one.
pub fn opened() -> Option<&'static DiskCache> {
    OPENED.get()?.as_ref()
}

/// Folder of the user's cache: that of the system (XDG on Linux), or the one that [`VARIABLE`]
/// names.
fn folder(variable: impl Fn(&str) -> Option<OsString>) -> Option<PathBuf> {
    if let Some(named) = variable(VARIABLE) {
        return (!named.is_empty()).then(|| named.into());
    }
    let folder = |name: &str| variable(name).map(PathBuf::from).filter(|path| path.is_absolute());
    let home = |below: &str| folder("HOME").map(|home| home.join(below));
    if cfg!(target_os = "windows") {
        folder("LOCALAPPDATA").map(|folder| folder.join("chiaro").join("cache"))
    } else if cfg!(target_os = "macos") {
        home("Library/Caches/chiaro")
    } else {
        let system = folder("XDG_CACHE_HOME").or_else(|| home(".cache"));
        system.map(|folder| folder.join("chiaro"))
    }
}

/// Name of an entry: a hash of everything that its content is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CacheKey([u64; 2]);

impl CacheKey {
    /// Key of what is made of `sources`.
    pub fn of(sources: &impl Hash) -> Self {
        Self([0_u64, 1].map(|half| {
            let mut hasher = DefaultHasher::new();
            half.hash(&mut hasher);
            sources.hash(&mut hasher);
            hasher.finish()
        }))
    }
}

/// Cache in a folder of the disk.
#[derive(Clone, Debug)]
pub struct DiskCache {
    folder: PathBuf,
    /// Greatest length of all entries together, in bytes.
    most: u64,
}

impl DiskCache {
    /// Cache in a folder, which is made when something is first kept.
    pub fn at(folder: impl Into<PathBuf>) -> Self {
        Self { folder: folder.into(), most: MOST_BYTES }
    }

    /// Content of an entry as `read` takes it; `None` where there is none, or a damaged one.
    pub fn find<T>(&self, key: CacheKey, read: impl FnOnce(&[u8]) -> Option<T>) -> Option<T> {
        let bytes = disk::read(&self.path(key), MOST_ENTRY_BYTES).ok()?;
        let (first, content) = bytes.split_at_checked(HEADER)?;
        if first == header(content) { read(content) } else { None }
    }

    /// Keeps the content of an entry, as far as the disk and the bounds let it.
    pub fn keep(&self, key: CacheKey, content: &[u8]) {
        let entry = [&header(content)[..], content].concat();
        if entry.len() as u64 > MOST_ENTRY_BYTES.min(self.most) {
            return;
        }
        // Without the entry the next start takes as long as this one.
        if make_folder(&self.folder).is_ok() && write_atomic(&self.path(key), &entry).is_ok() {
            self.trim();
        }
    }

    fn path(&self, CacheKey([a, b]): CacheKey) -> PathBuf {
        self.folder.join(format!("{a:016x}{b:016x}.{EXTENSION}"))
    }

    /// Removes the oldest entries until the others are within the bound.
    fn trim(&self) {
        let mut entries: Vec<(SystemTime, u64, PathBuf)> = fs::read_dir(&self.folder)
            .into_iter()
            .flatten()
            .flatten()
            .filter_map(|entry| about(&entry.path()))
            .collect();
        entries.sort();
        let mut length: u64 = entries.iter().map(|(_, length, _)| length).sum();
        for (_, of_entry, path) in entries {
            if length <= self.most {
                return;
            }
            if fs::remove_file(path).is_ok() {
                length -= of_entry;
            }
        }
    }
}

/// First bytes of an entry with this content.
fn header(content: &[u8]) -> [u8; HEADER] {
    let mut hasher = DefaultHasher::new();
    hasher.write(content);
    let mut header = [0; HEADER];
    header[..MAGIC.len()].copy_from_slice(MAGIC);
    header[MAGIC.len()..].copy_from_slice(&hasher.finish().to_le_bytes());
    header
}

/// Time and length of an entry, with its path; `None` for any other file.
fn about(path: &Path) -> Option<(SystemTime, u64, PathBuf)> {
    if path.extension().is_none_or(|extension| extension != EXTENSION) {
        return None;
    }
    let found = fs::metadata(path).ok().filter(fs::Metadata::is_file)?;
    Some((found.modified().ok()?, found.len(), path.to_owned()))
}

#[cfg(test)]
mod tests {
    use std::fs::File;
    use std::time::Duration;

    use super::*;

    /// Content of an entry as bytes.
    fn found(cache: &DiskCache, key: CacheKey) -> Option<Vec<u8>> {
        cache.find(key, |content| Some(content.to_vec()))
    }

    #[test]
    fn an_entry_is_found_again_unless_it_is_damaged() {
        let folder = tempfile::tempdir().unwrap();
        let cache = DiskCache::at(folder.path().join("not/yet"));
        let (key, other) = (CacheKey::of(&("a", 1)), CacheKey::of(&("a", 2)));
        assert_eq!((found(&cache, key), found(&cache, other)), (None, None));
        cache.keep(key, b"content");
        cache.keep(other, b"");
        assert_eq!(found(&cache, key).unwrap(), b"content");
        assert_eq!(found(&cache, other).unwrap(), b"");
        assert_eq!(cache.find(key, |_| None::<()>), None, "the reader has the last word");
        let whole = fs::read(cache.path(key)).unwrap();
        for at in 0..whole.len() {
            let mut damaged = whole.clone();
            damaged[at] ^= 1;
            fs::write(cache.path(key), &damaged).unwrap();
            assert_eq!(found(&cache, key), None, "byte {at}");
            fs::write(cache.path(key), &whole[..at]).unwrap();
            assert_eq!(found(&cache, key), None, "{at} bytes");
        }
        cache.keep(key, b"anew");
        assert_eq!(found(&cache, key).unwrap(), b"anew");
    }

    #[test]
    fn the_oldest_entries_go_first() {
        let folder = tempfile::tempdir().unwrap();
        let length = HEADER as u64 + 100;
        let cache = DiskCache { folder: folder.path().to_path_buf(), most: 3 * length };
        let keys = [0, 1, 2, 3, 4].map(|number| CacheKey::of(&number));
        fs::write(folder.path().join("somebody's.txt"), [0_u8; 1000]).unwrap();
        for (age, key) in keys.iter().enumerate() {
            cache.keep(*key, &[7; 100]);
            let file = File::options().write(true).open(cache.path(*key)).unwrap();
            let modified = SystemTime::UNIX_EPOCH + Duration::from_secs(age as u64);
            file.set_modified(modified).unwrap();
        }
        let kept = keys.map(|key| found(&cache, key).is_some());
        assert_eq!(kept, [false, false, true, true, true]);
        assert!(folder.path().join("somebody's.txt").is_file());
        cache.keep(keys[0], &[7; 1000]);
        assert_eq!(found(&cache, keys[0]), None, "no room for it");
        assert!(found(&cache, keys[4]).is_some());
    }

    #[test]
    fn a_folder_that_cannot_be_written_is_no_error() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        fs::write(&file, "").unwrap();
        let (cache, key) = (DiskCache::at(&file), CacheKey::of(&1));
        cache.keep(key, b"content");
        assert_eq!(found(&cache, key), None);
        assert_eq!(fs::read(&file).unwrap(), b"");
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn the_folder_is_that_of_the_system_unless_named() {
        let from = |pairs: &[(&str, &str)]| {
            folder(|name| {
                pairs.iter().find(|(key, _)| *key == name).map(|(_, value)| OsString::from(value))
            })
        };
        assert_eq!(from(&[]), None);
        let system = from(&[("HOME", "/home/a"), ("XDG_CACHE_HOME", "not/absolute")]);
        assert_eq!(system, Some("/home/a/.cache/chiaro".into()));
        let named = [("HOME", "/home/a"), ("XDG_CACHE_HOME", "/c")];
        assert_eq!(from(&named), Some("/c/chiaro".into()));
        assert_eq!(from(&[named[0], (VARIABLE, "own")]), Some("own".into()));
        assert_eq!(from(&[named[0], (VARIABLE, "")]), None);
    }
}
