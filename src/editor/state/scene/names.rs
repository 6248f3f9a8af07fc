//! Names of files in a scene: paths relative to its folder, with `/` as separator on every system.

use std::path::{Component, Path, PathBuf};

use chiaro_locale::tr;

use super::{OPEN_LOOK, OpenScene};
use crate::diag::Diagnostic;
use crate::document::Scene;
use crate::examples;
use crate::frame::SHAPE_PREFIX;

pub(crate) use crate::files::relative;

/// A path without `.` and `..`, as far as they can be removed without asking the file system.
pub(crate) fn clean(path: &Path) -> PathBuf {
    let mut cleaned = PathBuf::new();
    for component in path.components() {
        match component {
            Component::CurDir => {}
            Component::ParentDir
                if matches!(cleaned.components().next_back(), Some(Component::Normal(_))) =>
            {
                cleaned.pop();
            }
            other => cleaned.push(other),
        }
    }
    cleaned
}

/// Canonical path of a file, the same whatever the file is called.
pub(crate) fn real(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| absolute(path))
}

fn absolute(path: &Path) -> PathBuf {
    if let Some(example) = examples::canonical(path) {
        return example;
    }
    clean(&crate::state::paths::absolute(path))
}

/// The folder of a file.
pub(crate) fn folder_of(file: &Path) -> PathBuf {
    absolute(file).parent().map(Path::to_path_buf).unwrap_or_default()
}

/// Renames every file of a scene, except looks that are no files and examples.
pub(super) fn rename(scene: &mut Scene, name: &dyn Fn(&str) -> String) {
    for object in scene.objects.values_mut() {
        if !object.mesh.starts_with(SHAPE_PREFIX) {
            object.mesh = name(&object.mesh);
        }
        let is_file =
            |look: &&mut String| **look != OPEN_LOOK && !look.starts_with(examples::PREFIX);
        object.looks.values_mut().filter(is_file).for_each(|look| *look = name(look));
    }
}

impl OpenScene {
    /// The file that a name of the scene means.
    pub(crate) fn path_of(&self, name: &str) -> PathBuf {
        let path = self.base.join(name);
        if let Some(example) = examples::canonical(&path) {
            return example;
        }
        let cleaned = clean(&path);
        // A link to a folder makes `..` lead elsewhere than it reads.
        if real(&cleaned) == real(&path) { cleaned } else { path }
    }

    /// Name of a file in the scene.
    pub(crate) fn name_of(&self, file: &Path) -> String {
        match self.base.as_os_str().is_empty() {
            false => relative(&self.base, &absolute(file)),
            true => absolute(file).to_string_lossy().into_owned(),
        }
    }

    /// The scene with names relative to a folder.
    ///
    /// # Errors
    /// An object wears a look that has no file.
    pub(super) fn scene_in(&self, folder: &Path) -> Result<Scene, Box<Diagnostic>> {
        let mut scene = self.scene().clone();
        if folder != self.base {
            rename(&mut scene, &|name| relative(folder, &absolute(&self.base.join(name))));
        }
        let unsaved = scene.objects.values_mut().flat_map(|object| object.looks.values_mut());
        for name in unsaved.filter(|name| *name == OPEN_LOOK) {
            let Some(open) = &self.open_file else {
                let message = tr!(
                    "the open look has no file yet, and a scene names its looks by their files"
                );
                return Err(Box::new(
                    Diagnostic::error("unsaved-look", message).hint(tr!("save the look first")),
                ));
            };
            *name = relative(folder, &absolute(open));
        }
        Ok(scene)
    }

    /// A scene that was read from the scene's own file, with its names made relative to `base`.
    pub(super) fn scene_from(&self, mut scene: Scene) -> Scene {
        let folder = self.document.path.as_deref().map(folder_of).unwrap_or_default();
        if folder != self.base {
            rename(&mut scene, &|name| self.name_of(&folder.join(name)));
        }
        scene
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_read_as_they_lead() {
        for (path, wanted) in [
            ("a/../b/./c", "b/c"),
            ("../a", "../a"),
            ("/a/b/../../c", "/c"),
            ("../../a/..", "../.."),
        ] {
            assert_eq!(clean(Path::new(path)), Path::new(wanted), "{path}");
        }
    }

    #[test]
    #[cfg(unix)]
    fn a_file_is_called_by_the_way_to_it() {
        let name = |folder: &str, file: &str| relative(Path::new(folder), Path::new(file));
        assert_eq!(name("/p/scenes", "/p/looks/a.json"), "../looks/a.json");
        assert_eq!(name("/p/scenes", "/p/scenes/a.json"), "a.json");
        assert_eq!(name("/p", "/p/scenes/deep/a.json"), "scenes/deep/a.json");
        assert_eq!(name("/p/q", "/elsewhere/a.json"), "/elsewhere/a.json");
    }
}
