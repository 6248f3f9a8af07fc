//! Files that frames were drawn of, and the first of them that may draw other pictures by now.

use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::path::{Path, PathBuf};

use crate::document::{Document, Graph, Look, Scene, Shot};
use crate::files::{FileMetadata, Files};

/// File that frames were drawn of.
struct DrawnFile {
    path: PathBuf,
    /// State of the file as it was looked at last.
    seen: Option<FileMetadata>,
    content: DrawnContent,
    is_other: bool,
}

/// Content of a file when frames were drawn of it.
enum DrawnContent {
    /// Hash of all that a document says of pictures; `None` where it could not be read.
    Document(Option<u64>),
    /// State of a mesh, an image or another file.
    Other(Option<FileMetadata>),
}

/// Files that frames were drawn of. What is saved anew counts as changed where it says something
/// else of pictures: names, markers and places on the canvas do not.
#[derive(Default)]
pub(crate) struct FrameSources(Vec<DrawnFile>);

impl FrameSources {
    /// Files as they are now.
    pub(crate) fn of(paths: impl IntoIterator<Item = PathBuf>, files: &dyn Files) -> Self {
        let drawn = |path: PathBuf| {
            let seen = files.metadata(&path);
            let content = match is_document(&path) {
                true => DrawnContent::Document(hash_of(&path, files)),
                false => DrawnContent::Other(seen),
            };
            DrawnFile { path, seen, content, is_other: false }
        };
        Self(paths.into_iter().map(drawn).collect())
    }

    /// The first file that says something else of pictures than when frames were drawn of it.
    pub(crate) fn changed(&mut self, files: &dyn Files) -> Option<&Path> {
        for file in &mut self.0 {
            let now = files.metadata(&file.path);
            if file.seen == now {
                continue;
            }
            file.seen = now;
            file.is_other = match file.content {
                DrawnContent::Document(drawn) => hash_of(&file.path, files) != drawn,
                DrawnContent::Other(drawn) => now != drawn,
            };
        }
        self.0.iter().find(|file| file.is_other).map(|file| file.path.as_path())
    }
}

fn is_document(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("json"))
}

/// Hash of all that a document's file says of pictures; `None` where it cannot be read.
fn hash_of(path: &Path, files: &dyn Files) -> Option<u64> {
    let text = match Document::load(files, path) {
        Document::Look(look) => of_look(look.value?),
        Document::Scene(scene) => {
            let Scene { name, about, markers, .. } = Scene::default();
            Scene { name, about, markers, ..scene.value? }.to_text()
        }
        Document::Shot(shot) => {
            let Shot { name, about, markers, chunk, .. } = Shot::default();
            Shot { name, about, markers, chunk, ..shot.value? }.to_text()
        }
    };
    let mut hasher = DefaultHasher::new();
    text.hash(&mut hasher);
    Some(hasher.finish())
}

/// A look without its names, and without the layout of its canvases.
fn of_look(look: Look) -> String {
    let Look { name, about, tags, markers, .. } = Look::default();
    let mut look = Look { name, about, tags, markers, ..look };
    let groups = look.definitions.values_mut().map(|group| &mut group.graph);
    for Graph { nodes, notes, bookmarks, .. } in groups.chain([&mut look.graph]) {
        notes.clear();
        bookmarks.clear();
        for node in nodes.values_mut() {
            node.position = [0.0; 2];
            node.collapsed = false;
        }
    }
    look.to_text()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::Disk;

    const SHOT: &str = r#"{"chiaro": "shot", "scene": "scene.json", "frames": [1, 12],
        "overrides": [{"target": "lights.key.intensity", "value": 2}]}"#;
    const LOOK: &str = r#"{"nodes": [{"id": "base", "kind": "base", "at": [0, 0]},
        {"id": "output", "kind": "output"}],
        "wires": [{"from": "base", "to": "output.color"}]}"#;

    #[test]
    fn frames_are_stale_once_a_file_draws_other_pictures() {
        let folder = tempfile::tempdir().unwrap();
        let [shot, look, mesh] =
            ["shot.json", "look.json", "hero.obj"].map(|name| folder.path().join(name));
        let write = |path: &Path, text: &str| std::fs::write(path, text).unwrap();
        write(&shot, SHOT);
        write(&look, LOOK);
        write(&mesh, "v 0 0 0\n");
        let mut sources = FrameSources::of([&shot, &look, &mesh].map(PathBuf::clone), &Disk);
        let mut changed = || sources.changed(&Disk).map(Path::to_path_buf);
        assert_eq!(changed(), None);
        // A marker, other tasks of a farm and a moved node draw the same.
        let marker = r#""markers": [{"frame": 3, "name": "hit"}], "chunk": 4, "overrides""#;
        write(&shot, &SHOT.replace("\"overrides\"", marker));
        write(&look, &LOOK.replace("[0, 0]", "[240, 80]"));
        assert_eq!(changed(), None);
        write(&shot, &SHOT.replace("\"value\": 2", "\"value\": 2.5"));
        assert_eq!(changed(), Some(shot.clone()));
        assert_eq!(changed(), Some(shot.clone()), "it stays so");
        write(&shot, SHOT);
        assert_eq!(changed(), None, "as it was drawn");
        write(&look, &LOOK.replace("\"at\": [0, 0]", "\"values\": {\"color\": [1, 0, 0]}"));
        assert_eq!(changed(), Some(look.clone()));
        write(&look, LOOK);
        std::fs::remove_file(&mesh).unwrap();
        assert_eq!(changed(), Some(mesh));
    }
}
