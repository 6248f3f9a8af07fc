//! Documents and texts on the disk: read with a bound, and written so that nobody ever sees half a
//! file.

use std::fs;
use std::path::Path;

use chiaro_compiler::document::{self, Look, Scene, SourceMap};
use chiaro_language::diag::Diagnostic;
use chiaro_locale::tr;

use crate::disk::Disk;
use crate::outputs::FileSet;

/// Reads a text file of at most 64 MiB, or an [example](chiaro_compiler::examples).
///
/// # Errors
/// A diagnostic that names the file where it cannot be read, is too large, or is not UTF-8.
pub fn read_text(path: &Path) -> Result<String, Box<Diagnostic>> {
    document::read_text(&Disk, path)
}

/// Writes a file whole or not at all, with [`FileSet`]: into a temporary file in the same folder,
/// which then takes the old one's name. When this function returns, the disk has the file and its
/// name.
///
/// # Errors
/// A diagnostic that names the file; the old file is then as it was.
pub fn write_atomic(path: &Path, bytes: &[u8]) -> Result<(), Box<Diagnostic>> {
    let mut set = FileSet::default();
    set.add(path, bytes)?;
    set.commit()
}

/// Gives a file a second name, in place of the file of that name if there is one: a hard link, or
/// a copy where the file system has none.
///
/// # Errors
/// A diagnostic that names the file; what had the name is then as it was.
pub fn link(file: &Path, name: &Path) -> Result<(), Box<Diagnostic>> {
    let folder = name.parent().filter(|folder| !folder.as_os_str().is_empty());
    let folder = folder.unwrap_or(Path::new("."));
    let linked = tempfile::tempdir_in(folder).and_then(|made| {
        let beside = made.path().join("link");
        fs::hard_link(file, &beside)?;
        fs::rename(&beside, name)
    });
    if linked.is_ok() {
        return Ok(());
    }
    let bytes = fs::read(file).map_err(|error| {
        let problem = Diagnostic::error("cannot-read", error.to_string());
        Box::new(problem.in_file(file.display().to_string()))
    })?;
    write_atomic(name, &bytes)
}

/// Makes a folder to write files into, with all folders that it lies in, if there is none.
///
/// # Errors
/// A diagnostic that names the folder and says why it cannot be made.
pub fn make_folder(folder: &Path) -> Result<(), Box<Diagnostic>> {
    fs::create_dir_all(folder).map_err(|error| {
        let problem = Diagnostic::error("cannot-write", tr!("the folder cannot be made: {error}"));
        Box::new(problem.in_file(folder.display().to_string()))
    })
}

/// Document that is saved as a text file.
pub trait TextDocument {
    /// Text to save: that of `source`, byte for byte, where the document says the same.
    fn text_like(&self, source: Option<&SourceMap>) -> String;

    /// Saves the document, whole or not at all; unchanged text stays as it is where `source` is the
    /// text that the document was read from.
    ///
    /// # Errors
    /// A diagnostic that says why the file could not be written; the old one is then as it was.
    fn save(&self, path: &Path, source: Option<&SourceMap>) -> Result<(), Box<Diagnostic>> {
        write_atomic(path, self.text_like(source).as_bytes())
    }
}

impl TextDocument for Look {
    fn text_like(&self, source: Option<&SourceMap>) -> String {
        source.map_or_else(|| self.to_text(), |source| self.to_text_like(source))
    }
}

impl TextDocument for Scene {
    fn text_like(&self, source: Option<&SourceMap>) -> String {
        source.map_or_else(|| self.to_text(), |source| self.to_text_like(source))
    }
}

#[cfg(test)]
mod tests {
    use std::fs::{self, Permissions};
    use std::time::Duration;

    use crate::outputs::remove_abandoned;
    use std::fs::File;

    use chiaro_language::diag::LineColumn;

    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect()
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
    fn a_second_name_is_the_same_file_until_one_is_written() {
        let folder = tempfile::tempdir().unwrap();
        let [first, second] = ["a.png", "b.png"].map(|name| folder.path().join(name));
        write_atomic(&first, b"one").unwrap();
        write_atomic(&second, b"old").unwrap();
        link(&first, &second).unwrap();
        assert_eq!(fs::read(&second).unwrap(), b"one");
        write_atomic(&first, b"two").unwrap();
        assert_eq!(fs::read(&second).unwrap(), b"one");
        let mut left = names(folder.path());
        left.sort();
        assert_eq!(left, ["a.png", "b.png"]);
        assert!(link(&folder.path().join("none"), &second).is_err());
        assert_eq!(fs::read(&second).unwrap(), b"one");
    }

    #[test]
    fn a_failed_write_says_so_and_leaves_the_old_file() {
        let folder = tempfile::tempdir().unwrap();
        let missing = folder.path().join("no/such/a.json");
        let problem = write_atomic(&missing, b"x").unwrap_err();
        assert_eq!(problem.code, "cannot-write");
        assert!(problem.hints[0].contains("folder"), "{problem}");
        assert_eq!(problem.place.file, Some(missing.display().to_string()));
        assert!(
            problem.message.contains("no/such`") && !problem.to_string().contains(".chiaro-"),
            "{problem}"
        );

        let path = folder.path().join("a.json");
        write_atomic(&path, b"old").unwrap();
        let mut permissions = fs::metadata(&path).unwrap().permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&path, permissions).unwrap();
        let problem = write_atomic(&path, b"new").unwrap_err();
        assert!(
            problem.message.contains("read-only") && problem.message.contains("as it was"),
            "{problem}"
        );
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

        // A link to a file that does not exist yet leads to the written file afterwards, also
        // through another link.
        let (later, around) = (folder.path().join("later.json"), folder.path().join("around.json"));
        symlink("later.json", folder.path().join("to-later.json")).unwrap();
        symlink("to-later.json", &around).unwrap();
        write_atomic(&around, b"made").unwrap();
        assert_eq!(fs::read(&later).unwrap(), b"made");
        assert!(fs::symlink_metadata(&around).unwrap().is_symlink());
        let circle = folder.path().join("circle.json");
        symlink("circle.json", &circle).unwrap();
        assert!(write_atomic(&circle, b"").is_ok() || circle.is_symlink(), "a circle ends");

        // A new file gets the permissions that any other program's file gets here.
        let (ours, theirs) = (folder.path().join("ours"), folder.path().join("theirs"));
        write_atomic(&ours, b"").unwrap();
        fs::write(&theirs, b"").unwrap();
        let mode = |path| fs::metadata(path).unwrap().permissions().mode();
        assert_eq!(mode(&ours), mode(&theirs));
    }

    /// Effective only where the tests may give files away, which takes an administrator.
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
        let mut held = Vec::new();
        for (name, is_old) in [
            (".chiaro-a.tmp", true),
            (".chiaro-b.tmp", false),
            ("mine.tmp", true),
            ("a.json", true),
        ] {
            let file = File::create(folder.path().join(name)).unwrap();
            if is_old {
                file.set_modified(old).unwrap();
            } else {
                // Lock as held by a program that still writes here.
                file.try_lock().unwrap();
                held.push(file);
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
        assert_eq!(
            (problem.code, problem.place.at),
            ("not-utf8", Some(LineColumn { line: 2, column: 4 }))
        );
        for utf_16 in [b"\xFF\xFE{\0", b"{\0\n\0"] {
            fs::write(&path, utf_16).unwrap();
            assert!(read_text(&path).unwrap_err().message.contains("UTF-16"));
        }
        File::create(&path).unwrap().set_len((64 << 20) + 1).unwrap();
        assert_eq!(read_text(&path).unwrap_err().code, "too-large");
    }
}
