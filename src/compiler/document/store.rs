//! Reading files with a bound, and writing them so that nobody ever sees half of one.

use std::collections::BTreeSet;
use std::fs::{self, File, Permissions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use super::json::MAX_BYTES;
use crate::clock;
use crate::diag::{Diagnostic, LineColumn};
use crate::files::{self, ReadError};

/// What the names of temporary files begin and end with.
const PREFIX: &str = ".chiaro-";
const SUFFIX: &str = ".tmp";

/// Files that are being written at this moment, under their temporary names.
static UNFINISHED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// Reads a text file of at most 64 MiB, or an [example](crate::examples).
///
/// # Errors
/// A diagnostic that names the file where it cannot be read, is too large, or is not UTF-8.
pub fn read_text(path: &Path) -> Result<String, Box<Diagnostic>> {
    if let Some(text) = crate::examples::text(path) {
        return Ok(text);
    }
    let name = path.display().to_string();
    let fail = |code, message: String, hint: &str| {
        let problem = Diagnostic::error(code, message).in_file(name.clone());
        Box::new(if hint.is_empty() { problem } else { problem.hint(hint) })
    };
    let cannot = |error: io::Error| {
        let hint = match error.kind() {
            io::ErrorKind::NotFound => "check the spelling, and the folder that the path starts from",
            io::ErrorKind::PermissionDenied => "you may not read this file: change its permissions",
            io::ErrorKind::IsADirectory => "this is a folder: name a file in it",
            _ => "",
        };
        fail("cannot-read", format!("cannot read the file: {}", crate::diag::reason(&error)), hint)
    };
    let bytes = files::read(path, MAX_BYTES as u64).map_err(|error| match error {
        ReadError::Io(error) => cannot(error),
        ReadError::Special => {
            let message = format!("cannot read the file: {error}");
            fail("cannot-read", message, "name a plain file")
        }
        ReadError::TooLarge { .. } => {
            let message = format!("the file is larger than {} MiB, the bound for documents", MAX_BYTES >> 20);
            fail("too-large", message, "keep big data in files that the document names")
        }
    })?;
    if is_painting(path, &bytes) {
        let message = "this is a painting (an HCBTF), and no text".to_owned();
        let mut problem = fail(
            "wrong-document",
            message,
            "`chiaro edit` opens it to be painted on, and `chiaro hcbtf` tells what it holds, \
             fills, exports and imports it",
        );
        problem.hints.push(
            "a look shows it by a node of the kind `hcbtf_lookup`, whose value `sheet` names it: `example:hcbtf/brick.json` is one"
                .to_owned(),
        );
        return Err(problem);
    }
    if files::is_utf16(&bytes) {
        return Err(fail("not-utf8", "the file is UTF-16".into(), "save it as UTF-8"));
    }
    String::from_utf8(bytes).map_err(|error| {
        let bytes = error.as_bytes();
        let valid = error.utf8_error().valid_up_to();
        let before = String::from_utf8_lossy(&bytes[..valid]);
        let message = "the file is not UTF-8 text from here on".into();
        let mut problem = fail("not-utf8", message, "a document is JSON in UTF-8; is this another kind of file?");
        problem.place.at = Some(LineColumn::of(&before, valid));
        problem
    })
}

/// Whether bytes are those of an `.hcbtf` file, or of another zip that is called so.
fn is_painting(path: &Path, bytes: &[u8]) -> bool {
    let is_called_so = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("hcbtf"));
    // Our own have the manifest first.
    bytes.starts_with(b"PK") && (is_called_so || bytes.get(30..43) == Some(b"manifest.json"))
}

/// Writes a file whole or not at all: into a temporary file in the same folder, which then takes the old one's name,
/// permissions and, as far as the system lets us, owner and group. A link stays a link, and the file it leads to is
/// replaced, or made where there is none. When this returns, the disk has the file and its name.
///
/// Not kept: other names of the same file (hard links), access lists, and extended attributes.
///
/// # Errors
/// A diagnostic that names the file; the old file is then as it was.
pub fn write_atomic(path: &Path, bytes: &[u8]) -> Result<(), Box<Diagnostic>> {
    try_write(path, bytes).map_err(|error| {
        let missing = path.parent().filter(|folder| !folder.as_os_str().is_empty() && !folder.exists());
        let why = missing.map_or_else(|| reason(&error), |folder| format!("there is no folder `{}`", folder.display()));
        let hint = match error.kind() {
            io::ErrorKind::NotFound => "make the folder first, or choose another place",
            io::ErrorKind::PermissionDenied => "you may not write here: choose another place",
            io::ErrorKind::StorageFull => "the disk is full: make room and save again",
            io::ErrorKind::ReadOnlyFilesystem => "the disk is read-only: choose another place",
            _ => "choose another place",
        };
        let state = if path.exists() { "; the old file is as it was" } else { "" };
        let message = format!("cannot write the file: {why}{state}");
        Box::new(Diagnostic::error("cannot-write", message).in_file(path.display().to_string()).hint(hint))
    })
}

/// Removes files that are half written, for a program that is about to end in the middle of its work (Ctrl-C).
pub fn remove_unfinished() {
    let mut unfinished = UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner);
    for path in std::mem::take(&mut *unfinished) {
        // It may be gone by now, which is what is wanted.
        let _ = fs::remove_file(path);
    }
}

/// Why a write failed, without the name of the temporary file, which would tell nobody anything.
fn reason(error: &io::Error) -> String {
    let inner = error.get_ref().and_then(std::error::Error::source);
    inner.map_or_else(|| error.to_string(), ToString::to_string)
}

fn try_write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let target = follow_links(path);
    let old = fs::metadata(&target).ok();
    if let Some(old) = &old {
        if old.is_dir() {
            return Err(io::Error::new(io::ErrorKind::IsADirectory, "this is a folder"));
        }
        if old.permissions().readonly() {
            return Err(io::Error::new(io::ErrorKind::PermissionDenied, "the file is read-only"));
        }
    }
    let folder = match target.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(PREFIX).suffix(SUFFIX);
    if let Some(permissions) = new_file_permissions() {
        builder.permissions(permissions);
    }
    let mut file = builder.tempfile_in(folder)?;
    let _guard = Unfinished::new(file.path());
    file.write_all(bytes)?;
    if let Some(old) = old {
        keep_owner_and_permissions(file.as_file(), &old)?;
    }
    file.as_file().sync_all()?;
    file.persist(&target).map_err(|error| error.error)?;
    // The new name is on the disk once the folder is. Not every system can do this, and the file itself is safe.
    if let Ok(folder) = File::open(folder) {
        let _ = folder.sync_all();
    }
    Ok(())
}

/// Where a path leads, so that a link goes on to lead to the file; also where there is no file yet.
fn follow_links(path: &Path) -> PathBuf {
    /// As many as Linux follows.
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

/// Gives a file the owner, group and permissions of another. A group that cannot be kept gets no more than everybody has.
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

/// Removes what programs that were killed in the middle of a write have left in a folder, once it is a day old.
pub fn remove_abandoned(folder: &Path) {
    const OLD: Duration = Duration::from_secs(24 * 60 * 60);
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let is_ours = name.to_str().is_some_and(|name| name.starts_with(PREFIX) && name.ends_with(SUFFIX));
        let modified = || entry.metadata().and_then(|data| data.modified()).ok();
        if is_ours && modified().is_some_and(|modified| clock::age(modified) > OLD) {
            // What cannot be removed does no harm.
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// What a new file is created with; the system's mask takes away from it.
fn new_file_permissions() -> Option<Permissions> {
    #[cfg(unix)]
    return Some(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    #[cfg(not(unix))]
    None
}

/// A file in [`UNFINISHED`] for as long as this lives.
struct Unfinished(PathBuf);

impl Unfinished {
    fn new(path: &Path) -> Self {
        UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner).insert(path.to_owned());
        Self(path.to_owned())
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner).remove(&self.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
    }

    #[test]
    fn a_file_is_written_whole_and_nothing_else_is_left() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.json");
        write_atomic(&path, b"one").unwrap();
        write_atomic(&path, b"two").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"two");
        assert_eq!(names(folder.path()), ["a.json"]);
    }

    #[test]
    fn a_failed_write_says_so_and_leaves_the_old_file() {
        let folder = tempfile::tempdir().unwrap();
        let missing = folder.path().join("no/such/a.json");
        let problem = write_atomic(&missing, b"x").unwrap_err();
        assert_eq!(problem.code, "cannot-write");
        assert!(problem.hints[0].contains("folder"), "{problem}");
        assert_eq!(problem.place.file, Some(missing.display().to_string()));
        assert!(problem.message.contains("no/such`") && !problem.to_string().contains(".chiaro-"), "{problem}");

        let path = folder.path().join("a.json");
        write_atomic(&path, b"old").unwrap();
        let mut permissions = fs::metadata(&path).unwrap().permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&path, permissions).unwrap();
        let problem = write_atomic(&path, b"new").unwrap_err();
        assert!(problem.message.contains("read-only") && problem.message.contains("as it was"), "{problem}");
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(names(folder.path()), ["a.json"]);
        assert_eq!(write_atomic(folder.path(), b"x").unwrap_err().code, "cannot-write");
    }

    #[cfg(unix)]
    #[test]
    fn permissions_and_links_are_kept() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let folder = tempfile::tempdir().unwrap();
        let (path, link) = (folder.path().join("a.json"), folder.path().join("link.json"));
        fs::write(&path, "old").unwrap();
        fs::set_permissions(&path, Permissions::from_mode(0o640)).unwrap();
        symlink(&path, &link).unwrap();
        write_atomic(&link, b"new").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o777, 0o640);

        // A link that leads nowhere yet goes on to lead where it leads, also through another link.
        let (later, around) = (folder.path().join("later.json"), folder.path().join("around.json"));
        symlink("later.json", folder.path().join("to-later.json")).unwrap();
        symlink("to-later.json", &around).unwrap();
        write_atomic(&around, b"made").unwrap();
        assert_eq!(fs::read(&later).unwrap(), b"made");
        assert!(fs::symlink_metadata(&around).unwrap().is_symlink());
        let circle = folder.path().join("circle.json");
        symlink("circle.json", &circle).unwrap();
        assert!(write_atomic(&circle, b"").is_ok() || circle.is_symlink(), "a circle ends");

        // A new file is as any other program would make it here.
        let (ours, theirs) = (folder.path().join("ours"), folder.path().join("theirs"));
        write_atomic(&ours, b"").unwrap();
        fs::write(&theirs, b"").unwrap();
        let mode = |path| fs::metadata(path).unwrap().permissions().mode();
        assert_eq!(mode(&ours), mode(&theirs));
    }

    /// Where the tests may give files away, which takes an administrator.
    #[cfg(unix)]
    #[test]
    fn owner_and_group_are_kept() {
        use std::os::unix::fs::{MetadataExt, PermissionsExt, chown};
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.json");
        fs::write(&path, "old").unwrap();
        fs::set_permissions(&path, Permissions::from_mode(0o664)).unwrap();
        if chown(&path, Some(12_345), Some(23_456)).is_ok() {
            write_atomic(&path, b"new").unwrap();
            let data = fs::metadata(&path).unwrap();
            assert_eq!((data.uid(), data.gid(), data.mode() & 0o777), (12_345, 23_456, 0o664));
        }
    }

    #[test]
    fn what_was_abandoned_is_removed_once_it_is_old() {
        let folder = tempfile::tempdir().unwrap();
        let old = std::time::SystemTime::UNIX_EPOCH + Duration::from_secs(1_000_000_000);
        for (name, is_old) in [(".chiaro-a.tmp", true), (".chiaro-b.tmp", false), ("mine.tmp", true), ("a.json", true)]
        {
            let file = File::create(folder.path().join(name)).unwrap();
            if is_old {
                file.set_modified(old).unwrap();
            }
        }
        remove_abandoned(folder.path());
        let mut left = names(folder.path());
        left.sort();
        assert_eq!(left, [".chiaro-b.tmp", "a.json", "mine.tmp"]);
    }

    #[test]
    fn files_that_cannot_be_read_are_told() {
        let folder = tempfile::tempdir().unwrap();
        assert_eq!(read_text(&folder.path().join("missing")).unwrap_err().code, "cannot-read");
        assert_eq!(read_text(folder.path()).unwrap_err().code, "cannot-read");
        let path = folder.path().join("binary");
        fs::write(&path, b"{\n  \xC3\xA9\xFF").unwrap();
        let problem = read_text(&path).unwrap_err();
        assert_eq!((problem.code, problem.place.at), ("not-utf8", Some(LineColumn { line: 2, column: 4 })));
        for utf_16 in [b"\xFF\xFE{\0", b"{\0\n\0"] {
            fs::write(&path, utf_16).unwrap();
            assert!(read_text(&path).unwrap_err().message.contains("UTF-16"));
        }
        File::create(&path).unwrap().set_len(MAX_BYTES as u64 + 1).unwrap();
        assert_eq!(read_text(&path).unwrap_err().code, "too-large");
    }
}
