//! Names of files that hold wherever the program is started next.

use std::path::{Path, PathBuf};

/// The whole path of a file that is named from the working folder; as it is where there is no such
/// folder any more.
pub(crate) fn absolute(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
}
