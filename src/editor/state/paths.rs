//! File names that hold wherever the program is started next.

use std::path::{Component, Path, PathBuf};

/// Absolute path of a file that is named from the working folder; `path` itself where that folder
/// no longer exists.
pub(crate) fn absolute(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
}

/// The path without the folders that `..` leaves again, as far as names tell.
pub(crate) fn tidy(path: &Path) -> PathBuf {
    let mut tidy = PathBuf::new();
    for part in path.components() {
        let is_left = matches!(tidy.components().next_back(), Some(Component::Normal(_)));
        match part {
            Component::CurDir => {}
            Component::ParentDir if is_left => drop(tidy.pop()),
            part => tidy.push(part),
        }
    }
    tidy
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_that_are_left_again_are_not_told() {
        let told = |path: &str| tidy(Path::new(path)).to_string_lossy().into_owned();
        assert_eq!(told("/film/shots/../scenes/./room.json"), "/film/scenes/room.json");
        assert_eq!(told("../looks/a.json"), "../looks/a.json");
        assert_eq!(told("shots/../../a.json"), "../a.json");
    }
}
