//! Paths in documents: from their folder, so that both can be moved together.

use std::path::Path;

/// Relative path from a folder to a file, both absolute; the file itself where there is none, as
/// from one drive to another.
pub fn relative(folder: &Path, file: &Path) -> String {
    let (from, to): (Vec<_>, Vec<_>) = (folder.components().collect(), file.components().collect());
    let shared = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
    // Not even the root is shared, or nothing else is.
    if shared < 2 && from.len() > 1 {
        return file.to_string_lossy().into_owned();
    }
    let up = from[shared..].iter().map(|_| "..".to_owned());
    let down = to[shared..].iter().map(|part| part.as_os_str().to_string_lossy().into_owned());
    up.chain(down).collect::<Vec<_>>().join("/")
}
