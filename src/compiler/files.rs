//! Access to the files that documents and projects name: the compiler knows no disk, and asks
//! [`Files`].
//!
//! The caller of the compiler says where files come from: `chiaro_files::Disk` reads them from the
//! disk, and [`MemoryFiles`] serve tests and programs that have no disk.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Bound;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, SystemTime};
use std::{fmt, io};

use chiaro_locale::tr;

use crate::diag::reason;
use crate::examples;

/// Source of files that somebody names: a disk, or memory.
pub trait Files: fmt::Debug {
    /// Bytes of a plain file of at most `most` bytes, or of an [example](crate::examples).
    ///
    /// # Errors
    /// The reason why the file is not read.
    fn read(&self, path: &Path, most: u64) -> Result<Vec<u8>, ReadError>;

    /// A file as [`Files::read`] takes it, of which the caller reads the parts that it asks for.
    ///
    /// # Errors
    /// The reason why the file is not read.
    fn open(&self, path: &Path, most: u64) -> Result<Box<dyn OpenFile>, ReadError> {
        Ok(Box::new(io::Cursor::new(self.read(path, most)?)))
    }

    /// Kind and state of what lies at a path, links followed; `None` where nothing lies there. An
    /// [example](crate::examples) is a file that never changes.
    fn metadata(&self, path: &Path) -> Option<FileMetadata>;

    /// One path for all the paths that lead to the same file; `None` where nothing lies there.
    fn canonical(&self, path: &Path) -> Option<PathBuf> {
        let own = || self.metadata(path).map(|_| path.to_path_buf());
        examples::canonical(path).or_else(own)
    }

    /// All files in a folder and in those below it that `enters` lets in, within `bounds`. No file
    /// is found twice.
    fn walk(&self, folder: &Path, bounds: WalkBounds, enters: &dyn Fn(&Path) -> bool)
    -> FoundFiles;

    /// True if a path leads to a folder.
    fn is_folder(&self, path: &Path) -> bool {
        self.metadata(path).is_some_and(|found| found.kind == FileKind::Folder)
    }

    /// True if a path leads to a plain file, or names an [example](crate::examples).
    fn has_file(&self, path: &Path) -> bool {
        self.metadata(path).is_some_and(|found| found.kind == FileKind::Plain)
    }
}

/// File of which any part can be read.
pub trait OpenFile: io::Read + io::Seek {}

impl<F: io::Read + io::Seek> OpenFile for F {}

/// Files that several threads read from.
pub type SharedFiles = Arc<dyn Files + Send + Sync>;

/// Bounds of a [walk](Files::walk).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WalkBounds {
    /// Greatest depth of folders below the walked one.
    pub depth: usize,
    /// Greatest number of folder entries that are looked at.
    pub entries: usize,
}

/// Kind of what lies at a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FileKind {
    /// A plain file.
    Plain,
    /// A folder.
    Folder,
    /// A pipe, a socket or a device.
    Special,
}

/// Kind and state of what lies at a path: a file with another content has another time of its last
/// change, or another length.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct FileMetadata {
    /// Kind of what lies there.
    pub kind: FileKind,
    /// Time of the last change.
    pub modified: SystemTime,
    /// Length in bytes.
    pub length: u64,
}

impl FileMetadata {
    /// Metadata of an [example](crate::examples), if `path` names one.
    pub fn of_example(path: &Path) -> Option<Self> {
        let length = examples::file(path)?.len() as u64;
        Some(Self { kind: FileKind::Plain, modified: SystemTime::UNIX_EPOCH, length })
    }
}

/// Reason why a file is not read.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    /// Error of the operating system.
    #[error("{}", reason(.0))]
    Io(#[from] io::Error),
    /// A pipe, a socket or a device.
    #[error("{}", tr!("it is no plain file, but a pipe or a device"))]
    Special,
    /// File with more bytes than the caller takes.
    #[error("{}", too_large(*.most))]
    TooLarge {
        /// Greatest number of bytes that the caller takes.
        most: u64,
    },
}

fn too_large(most: u64) -> String {
    if most >> 20 > 0 {
        tr!("it is larger than {mib} MiB", mib = most >> 20)
    } else {
        tr!("it is larger than {kib} KiB", kib = most >> 10)
    }
}

/// Result of [`Files::walk`].
#[derive(Debug, Default)]
pub struct FoundFiles {
    /// Files, and all other entries that are no folders, folder by folder, sorted by name.
    pub files: Vec<PathBuf>,
    /// The walked folder and the folders in it.
    pub folders: Vec<PathBuf>,
    /// Folders that could not be listed.
    pub unreadable: Vec<(PathBuf, io::Error)>,
    /// True if the walk ended at the bound of its entries with some left.
    pub is_cut: bool,
}

/// Files in memory, by path.
#[derive(Clone, Debug, Default)]
pub struct MemoryFiles {
    files: BTreeMap<PathBuf, MemoryFile>,
    /// Number of files that were ever added.
    added: u64,
}

#[derive(Clone, Debug)]
struct MemoryFile {
    bytes: Vec<u8>,
    /// Number of files that had been added before this one, which is the file's time.
    number: u64,
}

impl MemoryFiles {
    /// Adds a file, in place of any file of the same path.
    pub fn add(&mut self, path: impl Into<PathBuf>, bytes: impl Into<Vec<u8>>) {
        let file = MemoryFile { bytes: bytes.into(), number: self.added };
        self.files.insert(path.into(), file);
        self.added += 1;
    }
}

impl Files for MemoryFiles {
    fn read(&self, path: &Path, most: u64) -> Result<Vec<u8>, ReadError> {
        let own = || self.files.get(path).map(|file| file.bytes.as_slice());
        let bytes = examples::file(path).or_else(own);
        let bytes = bytes.ok_or_else(|| io::Error::from(io::ErrorKind::NotFound))?;
        if bytes.len() as u64 > most { Err(ReadError::TooLarge { most }) } else { Ok(bytes.into()) }
    }

    fn metadata(&self, path: &Path) -> Option<FileMetadata> {
        let own = || {
            let file = self.files.get(path)?;
            let modified = SystemTime::UNIX_EPOCH + Duration::from_secs(file.number);
            let length = file.bytes.len() as u64;
            Some(FileMetadata { kind: FileKind::Plain, modified, length })
        };
        let folder = || {
            let mut below = self.files.range::<Path, _>((Bound::Excluded(path), Bound::Unbounded));
            below.next().filter(|(inner, _)| inner.starts_with(path))?;
            let modified = SystemTime::UNIX_EPOCH;
            Some(FileMetadata { kind: FileKind::Folder, modified, length: 0 })
        };
        FileMetadata::of_example(path).or_else(own).or_else(folder)
    }

    fn walk(
        &self,
        folder: &Path,
        bounds: WalkBounds,
        enters: &dyn Fn(&Path) -> bool,
    ) -> FoundFiles {
        let mut found = FoundFiles::default();
        let mut folders = BTreeSet::from([folder.to_path_buf()]);
        let within =
            self.files.keys().filter_map(|path| Some((path, path.strip_prefix(folder).ok()?)));
        for (number, (path, inner)) in within.enumerate() {
            if number == bounds.entries {
                found.is_cut = true;
                break;
            }
            let parents: Vec<&Path> =
                path.ancestors().skip(1).take(inner.components().count() - 1).collect();
            if parents.len() <= bounds.depth && parents.iter().all(|folder| enters(folder)) {
                folders.extend(parents.into_iter().map(Path::to_path_buf));
                found.files.push(path.clone());
            }
        }
        FoundFiles { folders: folders.into_iter().collect(), ..found }
    }
}

/// True for text in UTF-16, which other programs write where they say "Unicode": recognized by the
/// byte order mark at the beginning, or by every other of the first four bytes being 0.
pub fn is_utf16(bytes: &[u8]) -> bool {
    let is_ascii = |byte: u8| byte.is_ascii_graphic() || byte.is_ascii_whitespace();
    match *bytes {
        [0xFF, 0xFE, ..] | [0xFE, 0xFF, ..] => true,
        [a, 0, b, 0, ..] | [0, a, 0, b, ..] => is_ascii(a) && is_ascii(b),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_in_memory_are_read_and_walked_within_their_bounds() {
        let mut files = MemoryFiles::default();
        for name in ["nodes/a.wgsl", "nodes/b/c.wgsl", "nodes/b/d/e.wgsl", "look.json"] {
            files.add(name, "12345");
        }
        assert_eq!(files.read(Path::new("look.json"), 5).unwrap(), b"12345");
        assert!(matches!(
            files.read(Path::new("look.json"), 4),
            Err(ReadError::TooLarge { most: 4 })
        ));
        assert!(matches!(files.read(Path::new("nodes"), 5), Err(ReadError::Io(_))));
        let bounds = |depth| WalkBounds { depth, entries: 3 };
        let found = files.walk(Path::new("nodes"), bounds(1), &|_| true);
        assert_eq!(found.files, ["nodes/a.wgsl", "nodes/b/c.wgsl"].map(PathBuf::from));
        assert_eq!(found.folders, ["nodes", "nodes/b"].map(PathBuf::from));
        let flat = files.walk(Path::new("nodes"), bounds(8), &|folder| !folder.ends_with("b"));
        assert_eq!(flat.files, ["nodes/a.wgsl"].map(PathBuf::from));
        let cut = files.walk(Path::new("nodes"), WalkBounds { depth: 8, entries: 2 }, &|_| true);
        assert!(cut.is_cut && cut.files.len() == 2 && !found.is_cut);
    }

    #[test]
    fn another_content_is_another_state() {
        let mut files = MemoryFiles::default();
        files.add("a/b", "12345");
        let state = |files: &MemoryFiles| files.metadata(Path::new("a/b"));
        let first = state(&files);
        assert!(files.has_file(Path::new("a/b")) && first == state(&files));
        files.add("a/b", "54321");
        assert!(first.is_some() && state(&files) != first);
        let folder = files.metadata(Path::new("a")).map(|found| found.kind);
        assert_eq!((folder, files.metadata(Path::new("a/c"))), (Some(FileKind::Folder), None));
        assert!(!files.has_file(Path::new("a")));
    }

    #[test]
    fn utf_16_is_known_with_and_without_a_mark() {
        let units = |text: &str| text.encode_utf16().collect::<Vec<_>>();
        for text in ["v 1 2 3", "\u{feff}{ \"a\": 1 }"] {
            assert!(is_utf16(
                &units(text).iter().flat_map(|unit| unit.to_le_bytes()).collect::<Vec<_>>()
            ));
            assert!(is_utf16(
                &units(text).iter().flat_map(|unit| unit.to_be_bytes()).collect::<Vec<_>>()
            ));
            assert!(!is_utf16(text.as_bytes()));
        }
        assert!(!is_utf16(b"") && !is_utf16(&[0; 84]) && !is_utf16(b"glTF\x02\0\0\0"));
    }
}
