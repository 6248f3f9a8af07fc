//! File names that hold wherever the program is started next.

use std::path::{Path, PathBuf};

/// Absolute path of a file that is named from the working folder; `path` itself where that folder
/// no longer exists.
pub(crate) fn absolute(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
}
