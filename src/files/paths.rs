//! Paths in documents: from their folder, so that both can be moved together.

use std::path::{Component, Path, PathBuf};

use chiaro_compiler::examples;

/// A path without the folders that it leaves again, by its letters alone: no link is followed. An
/// example has one path.
pub fn shortened(path: &Path) -> PathBuf {
    if let Some(example) = examples::canonical(path) {
        return example;
    }
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
/// from one drive to another, and where the file is an example.
pub fn relative(folder: &Path, file: &Path) -> String {
    if let Some(example) = examples::canonical(file) {
        return example.to_string_lossy().into_owned();
    }
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
            ("shots/example:shots/../scenes/cast.json", "example:scenes/cast.json"),
        ] {
            assert_eq!(shortened(Path::new(long)), Path::new(short), "{long}");
        }
        let cast = Path::new("/a/example:scenes/cast.json");
        assert_eq!(relative(Path::new("/a/b"), cast), "example:scenes/cast.json");
    }
}
