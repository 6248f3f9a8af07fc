//! Places of journals: one folder, and in it a journal and a lock file for each open document. The
//! lock belongs to the operating system and ends with the program that holds it, however that ends;
//! so a journal without a holder was left behind.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// Extension of journals.
const JOURNAL: &str = "journal";
/// Extension of lock files.
const LOCK: &str = "lock";
/// Suffix of unfinished files, which may be removed once they are old.
pub(super) const UNFINISHED: &str = ".tmp";
/// Age from which a file counts as old: no program takes so long between making a lock and writing
/// the journal, or to write a journal.
const ABANDONED_AGE: Duration = Duration::from_secs(24 * 60 * 60);

/// Place for one journal, held by this program. Dropping the slot releases the lock and leaves the
/// journal where it is.
#[derive(Debug)]
pub struct JournalSlot {
    /// Path of the journal, which need not exist yet.
    path: PathBuf,
    /// Lock file, locked where the file system has locks.
    _lock: File,
}

impl JournalSlot {
    /// New place in a folder, which is made where it is missing, for this user only.
    ///
    /// # Errors
    /// The folder cannot be made or written.
    pub fn new(folder: &Path) -> io::Result<Self> {
        make_folder(folder)?;
        let lock = tempfile::Builder::new()
            .prefix("work-")
            .suffix(".lock")
            .rand_bytes(10)
            .tempfile_in(folder)?;
        let (lock, path) = lock.keep().map_err(|error| error.error)?;
        // Another window that tests the lock lets go at once, so this does not wait long. Without
        // locks on the file system, the slot goes unlocked.
        let _ = lock.lock();
        Ok(Self { path: path.with_extension(JOURNAL), _lock: lock })
    }

    /// Path of the journal.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Folder of the journal.
    pub(super) fn folder(&self) -> &Path {
        self.path.parent().unwrap_or(Path::new("."))
    }

    /// Time of the last write to the journal; `None` where there is no journal.
    pub fn written(&self) -> Option<SystemTime> {
        fs::metadata(&self.path).ok()?.modified().ok()
    }

    /// Removes the journal.
    pub fn discard(self) {
        // A journal that is gone already is as it should be; one that cannot be removed is offered
        // once more.
        let _ = fs::remove_file(&self.path);
    }
}

impl Drop for JournalSlot {
    fn drop(&mut self) {
        if !self.path.exists() {
            let _ = fs::remove_file(self.path.with_extension(LOCK));
        }
    }
}

/// Journals in a folder that nobody holds, the newest first; they are held from then on. Removes
/// old unfinished files.
pub fn left_behind(folder: &Path) -> Vec<JournalSlot> {
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let mut slots = Vec::new();
    for path in entries.flatten().map(|entry| entry.path()) {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        if ending == JOURNAL {
            slots.extend(take(path));
        } else if UNFINISHED.ends_with(ending) && !ending.is_empty() && is_old(&path)
            || ending == LOCK && is_old(&path) && !path.with_extension(JOURNAL).exists()
        {
            let _ = fs::remove_file(path);
        }
    }
    slots.sort_by_key(|slot: &JournalSlot| std::cmp::Reverse(slot.written()));
    slots
}

/// Takes hold of the journal, unless another program holds it.
fn take(path: PathBuf) -> Option<JournalSlot> {
    let lock = OpenOptions::new()
        .write(true)
        .create(true)
        .truncate(false)
        .open(path.with_extension(LOCK))
        .ok()?;
    match lock.try_lock() {
        Err(TryLockError::WouldBlock) => return None,
        // On a file system without locks, work that is offered twice is better than work that is
        // lost.
        Ok(()) | Err(TryLockError::Error(_)) => {}
    }
    // The journal may have been discarded between listing and locking.
    path.exists().then_some(JournalSlot { path, _lock: lock })
}

fn is_old(path: &Path) -> bool {
    let modified = fs::metadata(path).and_then(|data| data.modified());
    modified.is_ok_and(|modified| crate::clock::age(modified) > ABANDONED_AGE)
}

fn make_folder(folder: &Path) -> io::Result<()> {
    let mut builder = fs::DirBuilder::new();
    builder.recursive(true);
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
    builder.create(folder)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_held_is_not_left_behind() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path().join("made/here");
        let slot = JournalSlot::new(&folder).unwrap();
        fs::write(slot.path(), "x").unwrap();
        assert!(left_behind(&folder).is_empty(), "somebody works on it");
        let path = slot.path().to_owned();
        drop(slot);
        let mut found = left_behind(&folder);
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].path(), path);
        assert!(left_behind(&folder).is_empty(), "it is held again");
        found.remove(0).discard();
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 0, "and nothing stays of it");
    }

    #[test]
    fn an_empty_slot_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        drop(JournalSlot::new(folder.path()).unwrap());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
        assert!(left_behind(&folder.path().join("missing")).is_empty());
    }
}
