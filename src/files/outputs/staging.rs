//! Files on their way into a folder: each is written under a temporary name beside its place, and
//! all of a set then take their names one after another.
//!
//! # Whose temporary files these are
//! A set has one lock file in each folder, `.chiaro-RANDOM.tmp`, which its program holds locked
//! while it lives; the set's files there are called `.chiaro-RANDOM-NUMBER.tmp`. The system
//! releases the lock when the program ends, however it ends, so a program that can lock such a file
//! knows that the owner is gone, and removes the rest of the set. Process numbers would not tell:
//! they are used again, and differ between containers that share a folder.

use std::collections::{BTreeSet, HashSet};
use std::fs::{self, File, OpenOptions, Permissions, TryLockError};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use chiaro_locale::tr;
use tempfile::NamedTempFile;

use crate::clock;
use crate::diag::Diagnostic;

/// Prefix and suffix of the names of temporary files.
const PREFIX: &str = ".chiaro-";
const SUFFIX: &str = ".tmp";

/// Number of attempts to make a lock file: another program may take a new one for left behind
/// before it is locked.
const TRIES: u32 = 16;

/// Unfinished files of this program.
struct StagedFiles {
    /// Temporary files.
    files: BTreeSet<PathBuf>,
    /// True once the program ends: from then on no file is begun and none takes its name.
    is_ending: bool,
}

/// Unfinished files of this program, which [`remove_unfinished`] removes.
static UNFINISHED: Mutex<StagedFiles> =
    Mutex::new(StagedFiles { files: BTreeSet::new(), is_ending: false });

fn unfinished() -> MutexGuard<'static, StagedFiles> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes unfinished files, for a program that is about to end in the middle of its work (Ctrl-C).
/// A set whose files are just taking their names has taken them all when this function returns.
pub fn remove_unfinished() {
    let mut unfinished = unfinished();
    unfinished.is_ending = true;
    for path in std::mem::take(&mut unfinished.files) {
        // A file that is gone by now is as wanted.
        let _ = fs::remove_file(path);
    }
}

fn ending() -> io::Error {
    io::Error::new(io::ErrorKind::Interrupted, tr!("the program is ending"))
}

/// Files that appear together or not at all, as far as a file system allows: until
/// [`commit`](Self::commit) there are temporary files only, and a set that is dropped before leaves
/// nothing. Between two names that are taken only the end of the machine or of the program by force
/// can come; a file that describes the others is added last, for it appears last.
#[derive(Debug, Default)]
pub struct FileSet {
    folders: Vec<Folder>,
    files: Vec<StagedFile>,
    /// Files that are removed when the set is committed.
    removed: Vec<PathBuf>,
}

/// Folder that files of a set lie in.
#[derive(Debug)]
struct Folder {
    path: PathBuf,
    /// Lock file, locked while this value lives, where the file system has locks.
    lock: NamedTempFile,
    /// Number of files of the set that were begun in the folder.
    count: u32,
}

/// File under its temporary name.
#[derive(Debug)]
struct StagedFile {
    temporary: PathBuf,
    target: PathBuf,
    /// Path that was asked for, for messages.
    named: PathBuf,
}

impl FileSet {
    /// Writes a file under a temporary name in the folder that `path` leads to. The file will take
    /// the old one's permissions and, as far as the system allows, its owner and group. A link
    /// stays a link, and the file that it leads to is replaced, or made where there is none.
    ///
    /// Not kept: other names of the same file (hard links), access lists, and extended attributes.
    ///
    /// # Errors
    /// A diagnostic that names the file.
    pub fn add(&mut self, path: &Path, bytes: &[u8]) -> Result<(), Box<Diagnostic>> {
        self.try_add(path, bytes).map_err(|error| cannot_write(path, &error))
    }

    /// Removes a file when the set is committed, unless the set has one of that name.
    pub fn remove(&mut self, path: PathBuf) {
        self.removed.push(path);
    }

    /// Lets every file take its name, in the order in which they were added. When this returns, the
    /// disk has the files and their names.
    ///
    /// # Errors
    /// A diagnostic that names the file that could not take its name; files of the set that replace
    /// none are then removed again.
    pub fn commit(mut self) -> Result<(), Box<Diagnostic>> {
        for file in &self.files {
            check_place(&file.target).map_err(|error| cannot_write(&file.named, &error))?;
        }
        self.take_names()?;
        for folder in &self.folders {
            // New names are on the disk once the folder is. Not every system can sync a folder, and
            // the files are safe.
            if let Ok(folder) = File::open(&folder.path) {
                let _ = folder.sync_all();
            }
        }
        Ok(())
    }

    fn try_add(&mut self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        let target = follow_links(path);
        let old = check_place(&target)?;
        let folder = match target.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        let known = self.folders.iter().position(|known| known.path == folder);
        let index = match known {
            Some(index) => index,
            None => {
                self.folders.push(Folder::new(folder)?);
                self.folders.len() - 1
            }
        };
        let (temporary, mut file) = self.folders[index].create()?;
        self.files.push(StagedFile { temporary, target, named: path.to_owned() });
        file.write_all(bytes)?;
        if let Some(old) = old {
            keep_owner_and_permissions(&file, &old)?;
        }
        file.sync_all()
    }

    fn take_names(&mut self) -> Result<(), Box<Diagnostic>> {
        let mut unfinished = unfinished();
        // The guard is held until all names are taken, so that a program that ends meanwhile waits.
        if let Some(file) = self.files.first().filter(|_| unfinished.is_ending) {
            return Err(cannot_write(&file.named, &ending()));
        }
        let kept: HashSet<&Path> = self.files.iter().map(|file| file.target.as_path()).collect();
        for path in self.removed.iter().filter(|path| !kept.contains(follow_links(path).as_path()))
        {
            match fs::remove_file(path) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => {
                    return Err(cannot_write(path, &error));
                }
                _ => {}
            }
        }
        let mut made: Vec<&Path> = Vec::new();
        for (count, file) in self.files.iter().enumerate() {
            let is_new = !file.target.exists();
            if let Err(error) = fs::rename(&file.temporary, &file.target) {
                made.iter().for_each(|path| drop(fs::remove_file(path)));
                let problem = cannot_write(&file.named, &error);
                self.files.drain(..count);
                return Err(problem);
            }
            unfinished.files.remove(&file.temporary);
            if is_new {
                made.push(&file.target);
            }
        }
        self.files.clear();
        Ok(())
    }
}

impl Drop for FileSet {
    fn drop(&mut self) {
        let mut unfinished = unfinished();
        for file in &self.files {
            unfinished.files.remove(&file.temporary);
            let _ = fs::remove_file(&file.temporary);
        }
        // The lock goes last: another program takes files without a lock for left behind.
        for folder in &self.folders {
            unfinished.files.remove(folder.lock.path());
        }
    }
}

impl Folder {
    fn new(path: &Path) -> io::Result<Self> {
        remove_abandoned(path);
        for _ in 0..TRIES {
            let mut unfinished = unfinished();
            if unfinished.is_ending {
                return Err(ending());
            }
            let mut builder = tempfile::Builder::new();
            let lock = builder.prefix(PREFIX).suffix(SUFFIX).tempfile_in(path)?;
            match lock.as_file().try_lock() {
                // Another program that looks for abandoned files holds the lock, and is about to
                // remove it.
                Err(TryLockError::WouldBlock) => {}
                Ok(()) if !lock.path().exists() => {}
                // On a file system without locks, age tells which files were left behind.
                Ok(()) | Err(TryLockError::Error(_)) => {
                    unfinished.files.insert(lock.path().to_owned());
                    return Ok(Self { path: path.to_owned(), lock, count: 0 });
                }
            }
        }
        Err(io::Error::other(tr!("temporary files in this folder vanish as soon as they are made")))
    }

    /// Creates a temporary file.
    fn create(&mut self) -> io::Result<(PathBuf, File)> {
        let lock = self.lock.path().to_string_lossy();
        let temporary =
            PathBuf::from(format!("{}-{}{SUFFIX}", lock.trim_end_matches(SUFFIX), self.count));
        self.count += 1;
        let mut unfinished = unfinished();
        if unfinished.is_ending {
            return Err(ending());
        }
        // Permissions as any other program's file would have here: the system's mask takes away
        // from them.
        let file = OpenOptions::new().write(true).create_new(true).open(&temporary)?;
        unfinished.files.insert(temporary.clone());
        Ok((temporary, file))
    }
}

/// Metadata of the file that is to be written over, if there is one. Refuses a folder and a
/// read-only file.
fn check_place(target: &Path) -> io::Result<Option<fs::Metadata>> {
    let Ok(old) = fs::metadata(target) else { return Ok(None) };
    if old.is_dir() {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, tr!("this is a folder")));
    }
    if old.permissions().readonly() {
        return Err(io::Error::new(io::ErrorKind::PermissionDenied, tr!("the file is read-only")));
    }
    Ok(Some(old))
}

fn cannot_write(path: &Path, error: &io::Error) -> Box<Diagnostic> {
    let missing = path.parent().filter(|folder| !folder.as_os_str().is_empty() && !folder.exists());
    let why = missing.map_or_else(
        || reason(error),
        |folder| tr!("there is no folder `{folder}`", folder = folder.display()),
    );
    let hint = match error.kind() {
        io::ErrorKind::NotFound => tr!("make the folder first, or choose another place"),
        io::ErrorKind::PermissionDenied => tr!("you may not write here: choose another place"),
        io::ErrorKind::StorageFull => tr!("the disk is full: make room and save again"),
        io::ErrorKind::ReadOnlyFilesystem => tr!("the disk is read-only: choose another place"),
        _ => tr!("choose another place"),
    };
    let state = if path.exists() { tr!("; the old file is as it was") } else { "" };
    let message = tr!("cannot write the file: {why}{state}");
    Box::new(
        Diagnostic::error("cannot-write", message).in_file(path.display().to_string()).hint(hint),
    )
}

/// Reason why a write failed, without the name of the temporary file, which would tell nobody
/// anything.
fn reason(error: &io::Error) -> String {
    let inner = error.get_ref().and_then(std::error::Error::source);
    inner.map_or_else(|| error.to_string(), ToString::to_string)
}

/// Target of a path's links, so that a link goes on to lead to the file; also where there is no
/// file yet.
fn follow_links(path: &Path) -> PathBuf {
    /// Greatest number of links in a row, as many as Linux follows.
    const MOST: usize = 40;
    if let Ok(target) = fs::canonicalize(path) {
        return target;
    }
    let mut target = path.to_owned();
    for _ in 0..MOST {
        let Ok(next) = fs::read_link(&target) else { break };
        target = target.parent().map_or(next.clone(), |folder| folder.join(next));
    }
    target
}

/// Gives a file the owner, group and permissions of another. Where the group cannot be kept, the
/// file's group gets the permissions of others.
#[cfg(unix)]
fn keep_owner_and_permissions(file: &File, old: &fs::Metadata) -> io::Result<()> {
    use std::os::unix::fs::{MetadataExt, PermissionsExt, fchown};
    let new = file.metadata()?;
    let mut mode = old.mode() & 0o7777;
    if new.uid() != old.uid() {
        // Only an administrator may give files away; who can write a file may still save it.
        let _ = fchown(file, Some(old.uid()), None);
    }
    if new.gid() != old.gid() && fchown(file, None, Some(old.gid())).is_err() {
        mode = mode & 0o707 | (mode & 0o007) << 3;
    }
    file.set_permissions(Permissions::from_mode(mode))
}

#[cfg(not(unix))]
fn keep_owner_and_permissions(file: &File, old: &fs::Metadata) -> io::Result<()> {
    file.set_permissions(old.permissions())
}

/// Removes the temporary files that ended programs left in a folder in the middle of a write.
pub fn remove_abandoned(folder: &Path) {
    let mut sets: BTreeSet<String> = BTreeSet::new();
    let mut files: Vec<(String, PathBuf)> = Vec::new();
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let Some(own) =
            name.to_str().and_then(|name| name.strip_prefix(PREFIX)?.strip_suffix(SUFFIX))
        else {
            continue;
        };
        let set = own.split_once('-').map_or(own, |(set, _)| set);
        sets.insert(set.to_owned());
        if set != own {
            files.push((set.to_owned(), entry.path()));
        }
    }
    for set in sets {
        let lock = folder.join(format!("{PREFIX}{set}{SUFFIX}"));
        let of_set: Vec<&Path> =
            files.iter().filter(|(of, _)| *of == set).map(|(_, path)| path.as_path()).collect();
        let newest = of_set.last().copied().unwrap_or(&lock);
        if_abandoned(&lock, newest, || {
            // A file that cannot be removed does no harm. The lock goes last, while it is held.
            for path in of_set.iter().chain([&lock.as_path()]) {
                let _ = fs::remove_file(path);
            }
        });
    }
}

/// Calls `remove` where the program that owned `lock` has ended, and holds the lock meanwhile,
/// against others that look for abandoned files. `file` is one of the set.
fn if_abandoned(lock: &Path, file: &Path, remove: impl FnOnce()) {
    // Opened for writing, because some file systems lock no other.
    match OpenOptions::new().read(true).write(true).open(lock) {
        Ok(held) => match held.try_lock() {
            Ok(()) => remove(),
            Err(TryLockError::Error(_)) if is_old(file) => remove(),
            Err(_) => {}
        },
        // The lock is gone: a program removes its lock after all else.
        Err(error) if error.kind() == io::ErrorKind::NotFound => remove(),
        Err(_) => {}
    }
}

/// True if a file is so old that no program can be at work on it, where locks tell nothing.
fn is_old(path: &Path) -> bool {
    const OLD: Duration = Duration::from_secs(24 * 60 * 60);
    let modified = fs::metadata(path).and_then(|data| data.modified());
    modified.is_ok_and(|modified| clock::age(modified) > OLD)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn a_set_is_seen_as_a_whole_or_not_at_all() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        fs::write(path("old.txt"), "before").unwrap();
        fs::write(path("stale.txt"), "before").unwrap();
        let stage = || {
            let mut set = FileSet::default();
            for name in ["new.txt", "old.txt", "index.txt"] {
                set.add(&path(name), b"after").unwrap();
            }
            set.remove(path("stale.txt"));
            set.remove(path("old.txt"));
            set
        };
        let set = stage();
        let seen = names(folder.path());
        assert_eq!(
            seen.iter().filter(|name| !name.starts_with(PREFIX)).collect::<Vec<_>>(),
            ["old.txt", "stale.txt"]
        );
        assert_eq!(fs::read_to_string(path("old.txt")).unwrap(), "before");
        drop(set);
        assert_eq!(
            names(folder.path()),
            ["old.txt", "stale.txt"],
            "nothing is left of what was not committed"
        );
        stage().commit().unwrap();
        assert_eq!(names(folder.path()), ["index.txt", "new.txt", "old.txt"]);
        assert_eq!(fs::read_to_string(path("old.txt")).unwrap(), "after");
        assert!(unfinished().files.iter().all(|file| !file.starts_with(folder.path())));
    }

    #[test]
    fn a_set_that_one_place_refuses_changes_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        let mut set = FileSet::default();
        set.add(&path("a.txt"), b"a").unwrap();
        set.add(&path("b.txt"), b"b").unwrap();
        // Another program makes a folder of that name meanwhile.
        fs::create_dir(path("b.txt")).unwrap();
        let problem = set.commit().unwrap_err();
        assert!(problem.code == "cannot-write" && problem.message.contains("folder"), "{problem}");
        assert_eq!(names(folder.path()), ["b.txt"]);
    }

    #[test]
    fn what_a_living_program_writes_stays_and_the_rest_goes() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        let mut living = FileSet::default();
        living.add(&path("living.txt"), b"alive").unwrap();
        let beside: Vec<String> = names(folder.path());
        assert_eq!(beside.len(), 2, "a lock and a file");
        // Files of a program that was killed, and of one that was killed while it ended.
        for name in
            [".chiaro-dead.tmp", ".chiaro-dead-0.tmp", ".chiaro-dead-1.tmp", ".chiaro-gone-7.tmp"]
        {
            fs::write(path(name), "half").unwrap();
        }
        let mut other = FileSet::default();
        other.add(&path("other.txt"), b"other").unwrap();
        let left = names(folder.path());
        assert!(
            !left.iter().any(|name| name.contains("dead") || name.contains("gone")),
            "{left:?}"
        );
        assert!(beside.iter().all(|name| left.contains(name)), "{left:?}");
        other.commit().unwrap();
        living.commit().unwrap();
        assert_eq!(names(folder.path()), ["living.txt", "other.txt"]);
        assert_eq!(fs::read_to_string(path("living.txt")).unwrap(), "alive");
    }

    #[test]
    fn many_writers_of_one_folder_leave_each_other_alone() {
        let folder = tempfile::tempdir().unwrap();
        let write = |number: u32| {
            let mut set = FileSet::default();
            for part in ["a", "b"] {
                set.add(&folder.path().join(format!("{part}{}", number % 20)), part.as_bytes())
                    .unwrap();
            }
            set.commit().unwrap();
        };
        #[expect(clippy::disallowed_methods, reason = "the test is of writers side by side")]
        std::thread::scope(|scope| {
            for first in (0..200).step_by(25) {
                let write = &write;
                scope.spawn(move || (first..first + 25).for_each(write));
            }
        });
        let left = names(folder.path());
        assert_eq!(left.len(), 40, "{left:?}");
        for name in left {
            assert_eq!(fs::read_to_string(folder.path().join(&name)).unwrap(), name[..1]);
        }
    }
}
