//! Walks over folders, so that a test finds its cases instead of listing them.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Every file in `folder` and below, sorted by path; none where `folder` is no folder. Panics where
/// a folder cannot be read.
pub fn below(folder: &Path) -> Vec<PathBuf> {
    let mut found = BTreeSet::new();
    let mut open: Vec<_> = folder.is_dir().then(|| folder.to_path_buf()).into_iter().collect();
    while let Some(next) = open.pop() {
        for entry in
            fs::read_dir(&next).unwrap_or_else(|error| panic!("{}: {error}", next.display()))
        {
            let path = entry.unwrap_or_else(|error| panic!("{}: {error}", next.display())).path();
            if path.is_dir() {
                open.push(path);
            } else {
                found.insert(path);
            }
        }
    }
    found.into_iter().collect()
}
