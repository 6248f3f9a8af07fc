//! Access to the files that documents and projects name: the compiler knows no disk, and asks
//! [`Files`].
//!
//! The caller of the compiler says where files come from: `chiaro_files::Disk` reads them from the
//! disk, and [`MemoryFiles`] serve tests and programs that have no disk.

use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::path::{Path, PathBuf};

use crate::diag::reason;
use crate::examples;

/// Greatest number of folder entries that one [`walk`](Files::walk) looks at.
pub const MAX_ENTRIES: usize = 20_000;

/// Source of files: a disk, or memory.
pub trait Files {
    /// Bytes of a plain file of at most `most` bytes, or of an [example](crate::examples).
    ///
    /// # Errors
    /// The reason why the file is not read.
    fn read(&self, path: &Path, most: u64) -> Result<Vec<u8>, ReadError>;

    /// All files in a folder and in those below it that `enters` lets in, at most `depth` folders
    /// deep. No file is found twice, and no more than [`MAX_ENTRIES`] entries are looked at.
    fn walk(&self, folder: &Path, depth: usize, enters: &dyn Fn(&Path) -> bool) -> FoundFiles;
}

/// Reason why a file is not read.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    /// Error of the operating system.
    #[error("{}", reason(.0))]
    Io(#[from] io::Error),
    /// A pipe, a socket or a device.
    #[error("it is no plain file, but a pipe or a device")]
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
        format!("it is larger than {} MiB", most >> 20)
    } else {
        format!("it is larger than {} KiB", most >> 10)
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
    /// True if the walk ended at [`MAX_ENTRIES`] with entries left.
    pub is_cut: bool,
}

/// Files in memory, by path.
#[derive(Clone, Debug, Default)]
pub struct MemoryFiles {
    files: BTreeMap<PathBuf, Vec<u8>>,
}

impl MemoryFiles {
    /// Adds a file, in place of any file of the same path.
    pub fn add(&mut self, path: impl Into<PathBuf>, bytes: impl Into<Vec<u8>>) {
        self.files.insert(path.into(), bytes.into());
    }
}

impl Files for MemoryFiles {
    fn read(&self, path: &Path, most: u64) -> Result<Vec<u8>, ReadError> {
        let bytes = examples::file(path).or_else(|| self.files.get(path).map(Vec::as_slice));
        let bytes = bytes.ok_or_else(|| io::Error::from(io::ErrorKind::NotFound))?;
        if bytes.len() as u64 > most { Err(ReadError::TooLarge { most }) } else { Ok(bytes.into()) }
    }

    fn walk(&self, folder: &Path, depth: usize, enters: &dyn Fn(&Path) -> bool) -> FoundFiles {
        let mut folders = BTreeSet::from([folder.to_path_buf()]);
        let mut files = Vec::new();
        for path in self.files.keys().take(MAX_ENTRIES) {
            let Ok(inner) = path.strip_prefix(folder) else { continue };
            let parents: Vec<&Path> =
                path.ancestors().skip(1).take(inner.components().count() - 1).collect();
            if parents.len() <= depth && parents.iter().all(|folder| enters(folder)) {
                folders.extend(parents.into_iter().map(Path::to_path_buf));
                files.push(path.clone());
            }
        }
        let is_cut = self.files.len() > MAX_ENTRIES;
        FoundFiles { files, folders: folders.into_iter().collect(), is_cut, ..Default::default() }
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
        let found = files.walk(Path::new("nodes"), 1, &|_| true);
        assert_eq!(found.files, ["nodes/a.wgsl", "nodes/b/c.wgsl"].map(PathBuf::from));
        assert_eq!(found.folders, ["nodes", "nodes/b"].map(PathBuf::from));
        let flat = files.walk(Path::new("nodes"), 8, &|folder| !folder.ends_with("b"));
        assert_eq!(flat.files, ["nodes/a.wgsl"].map(PathBuf::from));
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
