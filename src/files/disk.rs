//! Disk access: the one way by which files and folders that somebody else names are read.
//!
//! A document, or a folder that came with it, may name anything: a pipe that never ends, a device
//! that gives zeros for ever, a sparse file of a terabyte, a link to the root of the disk. So a
//! file is read only where it is a plain one, and only up to a bound that the caller knows; a
//! folder is walked through a bounded number of entries, and no folder twice. A path on the command
//! line may also be a pipe (`chiaro check <(jq ...)`).

use std::collections::{HashSet, VecDeque};
use std::fs::{self, File, Metadata};
use std::io::{Cursor, Read as _};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use chiaro_compiler::examples;
use chiaro_compiler::files::{
    FileKind, FileMetadata, Files, FoundFiles, OpenFile, ReadError, WalkBounds,
};

/// The files of the disk.
#[derive(Clone, Copy, Debug, Default)]
pub struct Disk;

impl Files for Disk {
    fn read(&self, path: &Path, most: u64) -> Result<Vec<u8>, ReadError> {
        read(path, most)
    }

    fn open(&self, path: &Path, most: u64) -> Result<Box<dyn OpenFile>, ReadError> {
        // Of examples and pipes no part can be skipped.
        if examples::file(path).is_some() || !fs::metadata(path)?.is_file() {
            return Ok(Box::new(Cursor::new(read(path, most)?)));
        }
        Ok(Box::new(open(path, most)?))
    }

    fn metadata(&self, path: &Path) -> Option<FileMetadata> {
        FileMetadata::of_example(path).or_else(|| Some(metadata(&fs::metadata(path).ok()?)))
    }

    fn canonical(&self, path: &Path) -> Option<PathBuf> {
        examples::canonical(path).or_else(|| path.canonicalize().ok())
    }

    fn walk(
        &self,
        folder: &Path,
        bounds: WalkBounds,
        enters: &dyn Fn(&Path) -> bool,
    ) -> FoundFiles {
        walk(folder, bounds, enters)
    }
}

fn metadata(found: &Metadata) -> FileMetadata {
    let kind = match found.file_type() {
        kind if kind.is_file() => FileKind::Plain,
        kind if kind.is_dir() => FileKind::Folder,
        _ => FileKind::Special,
    };
    // Where a system knows no times, the length alone tells states apart.
    let modified = found.modified().unwrap_or(SystemTime::UNIX_EPOCH);
    FileMetadata { kind, modified, length: found.len() }
}

/// Bytes of a plain file of at most `most` bytes, or of an [example](chiaro_compiler::examples).
///
/// # Errors
/// The reason why the file is not read.
pub fn read(path: &Path, most: u64) -> Result<Vec<u8>, ReadError> {
    if let Some(example) = examples::file(path) {
        return Ok(example.to_vec());
    }
    let file = open(path, most)?;
    let mut bytes = Vec::new();
    // One byte beyond the bound reveals a longer file, whatever length the file claims.
    file.take(most.saturating_add(1)).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most { Err(ReadError::TooLarge { most }) } else { Ok(bytes) }
}

/// Opens a file of at most `most` bytes.
fn open(path: &Path, most: u64) -> Result<File, ReadError> {
    // The first check precedes opening: opening a pipe waits for somebody who writes.
    check(&fs::metadata(path)?, path, most)?;
    let file = File::open(path)?;
    // Another file may have taken the path since the first check.
    check(&file.metadata()?, path, most)?;
    Ok(file)
}

/// Refuses special files and files of more than `most` bytes. A folder passes: reading it fails,
/// and the system says why.
fn check(about: &Metadata, path: &Path, most: u64) -> Result<(), ReadError> {
    let is_special = !about.is_file() && !about.is_dir();
    if is_special && !is_argument(path) {
        return Err(ReadError::Special);
    }
    if about.is_file() && about.len() > most {
        return Err(ReadError::TooLarge { most });
    }
    Ok(())
}

/// True if the command line names this very path.
fn is_argument(path: &Path) -> bool {
    std::env::args_os().skip(1).any(|argument| argument == path.as_os_str())
}

/// All files in a folder and in those below it that `enters` lets in, within `bounds`.
///
/// Links are followed to folders that were not seen and do not hold the walked folder itself, after
/// all folders that are there in person; so nothing is found twice, and no link leads round in a
/// ring.
pub fn walk(folder: &Path, bounds: WalkBounds, enters: &dyn Fn(&Path) -> bool) -> FoundFiles {
    let mut walked = FoundFiles::default();
    let Some(root) = place(folder, &mut walked) else { return walked };
    let mut seen = HashSet::from([root.clone()]);
    let mut open = VecDeque::from([(folder.to_path_buf(), 0)]);
    let mut links: VecDeque<(PathBuf, usize)> = VecDeque::new();
    let mut left = bounds.entries;
    loop {
        // Real folders go before links, so that files are found by their own paths where possible.
        let (folder, at) = if let Some(next) = open.pop_front() {
            next
        } else {
            let Some((link, at)) = links.pop_front() else { break };
            match place(&link, &mut walked) {
                Some(real) if !root.starts_with(&real) && seen.insert(real.clone()) => (link, at),
                _ => continue,
            }
        };
        for (path, is_link) in entries(&folder, &mut left, &mut walked) {
            if !path.is_dir() {
                walked.files.push(path);
            } else if enters(&path) {
                if at >= bounds.depth {
                    continue;
                }
                if is_link {
                    links.push_back((path, at + 1));
                } else if place(&path, &mut walked).is_some_and(|real| seen.insert(real)) {
                    open.push_back((path, at + 1));
                }
            }
        }
        walked.folders.push(folder);
    }
    walked
}

/// Canonical path of a folder; a failure is noted in `walked`.
fn place(folder: &Path, walked: &mut FoundFiles) -> Option<PathBuf> {
    folder
        .canonicalize()
        .map_err(|error| walked.unreadable.push((folder.to_path_buf(), error)))
        .ok()
}

/// Entries of a folder, sorted by name, as long as entries are `left`, each with whether it is a
/// link.
fn entries(folder: &Path, left: &mut usize, walked: &mut FoundFiles) -> Vec<(PathBuf, bool)> {
    let listed = match fs::read_dir(folder) {
        Ok(listed) => listed,
        Err(error) => {
            walked.unreadable.push((folder.to_path_buf(), error));
            return Vec::new();
        }
    };
    let mut found = Vec::new();
    for entry in listed.flatten() {
        if *left == 0 {
            walked.is_cut = true;
            break;
        }
        *left -= 1;
        found.push((entry.path(), entry.file_type().is_ok_and(|kind| kind.is_symlink())));
    }
    found.sort();
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_plain_files_within_the_bound_are_read() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        fs::write(&path, "12345").unwrap();
        assert_eq!(read(&path, 5).unwrap(), b"12345");
        assert!(matches!(read(&path, 4), Err(ReadError::TooLarge { most: 4 })));
        assert!(matches!(read(&folder.path().join("b"), 5), Err(ReadError::Io(_))));
        assert!(matches!(read(folder.path(), 5), Err(ReadError::Io(_))));
        // A sparse file of a terabyte takes no place on the disk.
        File::create(&path).unwrap().set_len(1 << 40).unwrap();
        assert!(matches!(read(&path, 1 << 20), Err(ReadError::TooLarge { .. })));
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn pipes_and_devices_are_not_opened() {
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe");
        assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        for path in [&pipe, Path::new("/dev/zero"), Path::new("/dev/full")] {
            assert!(matches!(read(path, 5), Err(ReadError::Special)), "{path:?}");
        }
    }

    #[cfg(unix)]
    #[test]
    fn links_are_followed_once_and_never_upwards() {
        use std::os::unix::fs::symlink;
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path().join("nodes");
        fs::create_dir_all(root.join("b/c")).unwrap();
        fs::create_dir(folder.path().join("shared")).unwrap();
        for file in ["nodes/z", "nodes/b/y", "nodes/b/c/x", "shared/w"] {
            fs::write(folder.path().join(file), "").unwrap();
        }
        // Links to a folder that is there, to one elsewhere (twice), to the root itself, upwards,
        // to the root of the disk, to nothing.
        for (link, target) in
            [("a", "b"), ("b/up", ".."), ("b/c/top", "/"), ("self", "."), ("none", "nowhere")]
        {
            symlink(target, root.join(link)).unwrap();
        }
        ["d", "e"]
            .iter()
            .for_each(|link| symlink(folder.path().join("shared"), root.join(link)).unwrap());
        let bounds = |depth| WalkBounds { depth, entries: 100 };
        let walked = walk(&root, bounds(8), &|_| true);
        let short = |path: &PathBuf| path.strip_prefix(&root).unwrap().display().to_string();
        assert_eq!(
            walked.files.iter().map(short).collect::<Vec<_>>(),
            ["none", "z", "b/y", "b/c/x", "d/w"]
        );
        assert_eq!(walked.folders.iter().map(short).collect::<Vec<_>>(), ["", "b", "b/c", "d"]);
        assert!(!walked.is_cut && walked.unreadable.is_empty(), "{walked:?}");
        let flat = walk(&root, bounds(0), &|_| true);
        assert_eq!((flat.files.len(), flat.folders.len()), (2, 1), "{flat:?}");
        let without_b = walk(&root, bounds(8), &|path| !path.ends_with("b"));
        assert_eq!(without_b.files.len(), 5, "`a` leads to it: {without_b:?}");
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_strangers_folder_neither_waits_nor_walks_the_disk() {
        use std::os::unix::fs::symlink;

        use chiaro_compiler::library::{Library, node_files};

        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        assert!(
            std::process::Command::new("mkfifo").arg(path("pipe.wgsl")).status().unwrap().success()
        );
        symlink("/dev/zero", path("zero.json")).unwrap();
        symlink("/", path("disk")).unwrap();
        symlink(".", path("ring")).unwrap();
        File::create(path("hole.wgsl")).unwrap().set_len(1 << 40).unwrap();
        assert_eq!(node_files(&Disk, folder.path()).folders, [folder.path()]);
        let library = Library::built_in().with_project(&Disk, folder.path());
        let problems: Vec<_> = library.problems.iter().map(|problem| problem.code).collect();
        assert_eq!(problems, ["unreadable-node"; 3]);
    }
}
