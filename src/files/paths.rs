//! Paths in documents: from their folder, so that both can be moved together.

use std::path::{Component, Path, PathBuf};

/// A path without the folders that it leaves again, by its letters alone: no link is followed.
pub fn shortened(path: &Path) -> PathBuf {
    let mut short = PathBuf::new();
    for part in path.components() {
        match (part, short.components().next_back()) {
            (Component::CurDir, _) => {}
            (Component::ParentDir, Some(Component::Normal(_))) => drop(short.pop()),
            _ => short.push(part),
        }
    }
    short
}

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_that_are_left_again_go() {
        for (long, short) in [
            ("shots/../looks/./a.json", "looks/a.json"),
            ("../../a.json", "../../a.json"),
            ("/p/q/../../../a", "/../a"),
            ("", ""),
        ] {
            assert_eq!(shortened(Path::new(long)), Path::new(short), "{long}");
        }
    }
}
