//! Saving of the look to a file. Files that the look names are named from its folder: in another
//! folder they are linked by other names, or those that lie with the look are copied along.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use super::Session;
use crate::diag::Diagnostic;
use crate::document::{Edit, Look, Object};
use crate::files::{FileSet, make_folder, shortened};
use crate::ids::PortName;
use crate::state::masks::MaskSteps;
use crate::state::painting::look;
use crate::state::parts::pictures::{
    MovedPictures, PictureRoute, change_path, each_file, each_file_in_edit, is_file,
};
use crate::state::paths::absolute;
use crate::state::pictures::CarriedPicture;
use crate::state::scene::carried::is_free;

/// Way of the files that lie with a document which is saved into another folder: those that lie
/// elsewhere are shared, and are linked in any case.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(crate) enum OwnFiles {
    /// Other names for the same files; nothing is copied.
    #[default]
    Linked,
    /// Copies beside the document.
    Copied,
}

/// The look on its way to another folder.
struct MovedLook {
    look: Look,
    files: MovedPictures,
    /// Folders that files are named from before and after, whole.
    folders: [PathBuf; 2],
    /// Names of files after the way, by those before.
    names: HashMap<String, String>,
    /// Exposed parameters that are files.
    parameters: Vec<PortName>,
}

impl MovedLook {
    fn route(&self) -> PictureRoute<'_> {
        let [from, to] = &self.folders;
        PictureRoute { from, to: Some(to), takes_equal: false }
    }

    /// Names a file as the moved look does; one that only the past names is linked.
    fn rename(&self, path: &mut String) {
        match self.names.get(path) {
            Some(name) => path.clone_from(name),
            None => self.route().relink(path),
        }
    }

    /// Names files that an object of the scene sets in place of the look's own, which are named
    /// from the look's folder, too.
    fn rename_in(&self, object: &mut Object) {
        let mut worn = object.looks.values();
        let first = worn.next();
        if worn.any(|look| Some(look) != first) {
            // Values are for all of the object's looks, and the others stay where they are.
            return;
        }
        for parameter in &self.parameters {
            if let Some(value) = object.values.get_mut(parameter) {
                change_path(value, &mut |path| self.rename(path));
            }
        }
    }
}

impl Session {
    /// Saves to a file, which is the look's own from then on. In another folder its files go on to
    /// be used where they are.
    ///
    /// # Errors
    /// A diagnostic with the reason; the old file is then unchanged.
    pub fn save_as(&mut self, path: &Path) -> Result<(), Box<Diagnostic>> {
        self.save_with(path, OwnFiles::Linked).map(drop)
    }

    /// Saves to a file, as [`save_as`](Self::save_as) does, and tells what became of the files
    /// that the look names.
    ///
    /// # Errors
    /// A diagnostic with the reason; nothing is written then.
    pub(crate) fn save_with(
        &mut self,
        path: &Path,
        own: OwnFiles,
    ) -> Result<MovedPictures, Box<Diagnostic>> {
        if self.shot().is_some() {
            // The look of the window is what the shot makes of its file.
            return self.save_shot_as(path).map(|()| MovedPictures::default());
        }
        let is_own = self.look.check_saving(path)?;
        let moved = if is_own { None } else { self.moved_to(path, own) };
        let look = moved.as_ref().map_or_else(|| self.look(), |moved| &moved.look);
        let names = if is_own { None } else { self.names_of_painting(path) };
        let text = if is_own {
            self.look.text_of(look)
        } else {
            let named = names
                .as_ref()
                .and_then(|(from, to)| look::renamed(look, &self.project.catalog, from, to));
            named.as_ref().unwrap_or(look).to_text()
        };
        let copies = moved.as_ref().map_or(&[][..], |moved| moved.files.copied.as_slice());
        write_with(path, &text, copies)?;
        self.look.text_was_written(path, &text);
        if let Some(moved) = &moved {
            self.move_names(moved);
        }
        if let Some((from, to)) = names {
            self.rename_painting(&from, &to);
        }
        self.look.history.mark_saved();
        self.pictures.settle();
        if !is_own {
            // The masks are the old file's, too: what undo wrote there would change that look.
            self.masks = MaskSteps::default();
        }
        self.revisions.problems.advance();
        if !is_own && self.open_scene.is_some() {
            // While the scene still knows the look by its old name.
            self.wear_saved(path, &|object| {
                if let Some(moved) = &moved {
                    moved.rename_in(object);
                }
            });
        }
        if !is_own {
            // Another folder is another project, with nodes of its own.
            self.reload_library();
        }
        // Under another name the look takes its snapshots along.
        self.shelf.write_beside(path);
        self.saved();
        Ok(moved.map(|moved| moved.files).unwrap_or_default())
    }

    /// Saves the scene to a file, as [`save_scene_as`](Self::save_scene_as) does; in another folder
    /// with or without copies of the files that lie with it, the open look among them. Tells what
    /// became of the files that the scene names.
    ///
    /// # Errors
    /// A diagnostic with the reason; the scene's file is unchanged then.
    pub(crate) fn save_scene_with(
        &mut self,
        path: &Path,
        own: OwnFiles,
    ) -> Result<MovedPictures, Box<Diagnostic>> {
        let library = self.project.library.clone();
        let copies = own == OwnFiles::Copied && self.shot().is_none();
        let of_scene = self.open_scene.as_ref().filter(|_| copies);
        let carried = match of_scene {
            Some(open_scene) => open_scene.carried(path, &library)?,
            None => None,
        };
        let Some(mut carried) = carried else {
            return self.save_scene_as(path).map(|()| MovedPictures::default());
        };
        let look =
            self.look.path.as_deref().filter(|look| of_scene.is_some_and(|it| it.wears(look)));
        let look = look.and_then(|look| carried.place_of(&shortened(&absolute(look))));
        if let Some(look) = &look {
            is_free(look, None)?;
            make_folder(look.parent().unwrap_or(Path::new("")))?;
        }
        carried.write()?;
        let saved = match &look {
            Some(look) => self.save_with(look, OwnFiles::Copied).map(|mut files| {
                let name = look.file_name().unwrap_or_default();
                files.along.push(name.to_string_lossy().into_owned());
                files
            }),
            None => Ok(MovedPictures::default()),
        };
        let saved = saved.and_then(|files| {
            let before = self.open_scene.as_ref().map(|open_scene| open_scene.scene().clone());
            if let Some(open_scene) = &mut self.open_scene {
                open_scene.name_carried(&carried);
            }
            let saved = self.save_scene_as(path);
            if let (Err(_), Some(before), Some(open_scene)) = (&saved, before, &mut self.open_scene)
            {
                open_scene.document.history.amend(before, |_| {});
            }
            saved.map(|()| files)
        });
        match saved {
            Ok(files) => {
                carried.told.along.extend(files.along);
                carried.told.linked.extend(files.linked);
                Ok(carried.told)
            }
            Err(problem) => {
                carried.take_away();
                Err(problem)
            }
        }
    }

    /// The look with its files named from the folder of another file; `None` where the look stays
    /// in its folder, or has none yet.
    fn moved_to(&self, path: &Path, own: OwnFiles) -> Option<MovedLook> {
        let folder = |file: &Path| shortened(&absolute(file.parent().unwrap_or(Path::new(""))));
        let folders = [folder(&absolute(self.look.path.as_deref()?)), folder(&absolute(path))];
        if folders[0] == folders[1] {
            return None;
        }
        let catalog = &self.project.catalog;
        let mut look = self.look().clone();
        let mut before: Vec<String> = Vec::new();
        each_file(&mut look, catalog, &mut |path| before.push(path.clone()));
        let [from, to] = &folders;
        let route = PictureRoute { from, to: Some(to), takes_equal: false };
        let files = match own {
            OwnFiles::Copied => route.rename(&mut look, catalog),
            OwnFiles::Linked => {
                let mut files = MovedPictures::default();
                each_file(&mut look, catalog, &mut |path| {
                    let name = Path::new(&*path).file_name().unwrap_or_default();
                    let name = name.to_string_lossy().into_owned();
                    if !files.linked.contains(&name) {
                        files.linked.push(name);
                    }
                    route.relink(path);
                });
                files
            }
        };
        let mut after: Vec<String> = Vec::new();
        each_file(&mut look, catalog, &mut |path| after.push(path.clone()));
        let names = before.into_iter().zip(after).collect();
        let parameters = look.exposed.iter().filter(|it| is_file(&look, catalog, &it.target));
        let parameters = parameters.map(|it| it.name.clone()).collect();
        Some(MovedLook { look, files, folders, names, parameters })
    }

    /// Names files as the moved look does: now, in all the past, and in the snapshots. This is no
    /// step, since undo would bring back names that mean nothing from the new folder.
    fn move_names(&mut self, moved: &MovedLook) {
        let before = self.look().clone();
        let catalog = &self.project.catalog;
        let is_path = |text: &str| moved.folders[0].join(text).is_file();
        let of_past = |edit: &mut Edit| {
            let rename = &mut |path: &mut String| moved.rename(path);
            each_file_in_edit(edit, (&before, catalog), &is_path, rename);
        };
        self.look.history.amend(moved.look.clone(), of_past);
        self.shelf.amend(|look| each_file(look, catalog, &mut |path| moved.rename(path)));
        self.revisions.meaning.advance();
        self.changed(true);
    }
}

/// Writes a document and copies of its files beside it: all of them, or none.
fn write_with(path: &Path, text: &str, copies: &[CarriedPicture]) -> Result<(), Box<Diagnostic>> {
    let mut set = FileSet::default();
    for copy in copies {
        set.add(&path.with_file_name(&copy.name), &copy.bytes)?;
    }
    set.add(path, text.as_bytes())?;
    set.commit()
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::document::{GraphId, Value};
    use crate::library::Library;

    const LOOK: &str = r#"{"chiaro": "look", "nodes": [
        {"id": "mask", "kind": "image", "values": {"image": "m.png"}},
        {"id": "wood", "kind": "image", "at": [300, 0], "values": {"image": "../shared/wood.png"}},
        {"id": "ball", "kind": "image", "at": [600, 0],
            "values": {"image": "example:images/ball-ridge.png"}},
        {"id": "end", "kind": "output", "at": [900, 0]}]}"#;

    /// Folders `first`, with a look that is open and a mask, `shared`, and `second`.
    fn home() -> (tempfile::TempDir, Session) {
        let home = tempfile::tempdir().unwrap();
        for folder in ["first", "second", "shared"] {
            std::fs::create_dir(home.path().join(folder)).unwrap();
        }
        for (name, text) in
            [("first/look.json", LOOK), ("first/m.png", "mask"), ("shared/wood.png", "wood")]
        {
            std::fs::write(home.path().join(name), text).unwrap();
        }
        let mut session = Session::new(Arc::new(Library::built_in().clone()), || {});
        session.open(&home.path().join("first/look.json")).unwrap();
        (home, session)
    }

    fn images(look: &Look) -> Vec<String> {
        let values = look.graph.nodes.values().filter_map(|node| node.values.get("image"));
        values
            .map(|value| if let Value::Text(path) = value { path.clone() } else { panic!() })
            .collect()
    }

    fn set(session: &mut Session, path: &str) {
        let edit = Edit::SetValue {
            graph: GraphId::Look,
            id: "mask".into(),
            port: "image".into(),
            value: Value::Text(path.to_owned()),
            index: None,
        };
        session.apply(edit, None).unwrap();
    }

    #[test]
    fn a_look_in_another_folder_goes_on_to_use_its_files() {
        let (home, mut session) = home();
        set(&mut session, "../shared/wood.png");
        session.undo();
        let to = home.path().join("second/look.json");
        let files = session.save_with(&to, OwnFiles::Linked).unwrap();
        assert_eq!((files.along.len(), files.linked.len()), (0, 2));
        let linked = ["../first/m.png", "../shared/wood.png", "example:images/ball-ridge.png"];
        assert_eq!(images(session.look()), linked);
        let saved = Look::read(&std::fs::read_to_string(&to).unwrap(), "look").value.unwrap();
        assert_eq!(images(&saved), linked);
        assert!(!session.is_dirty() && !home.path().join("second/m.png").exists());
        // The past is named from the new folder, too.
        session.redo();
        assert_eq!(images(session.look())[0], "../shared/wood.png");
        session.undo();
        assert_eq!(images(session.look()), linked);
        assert!(!session.is_dirty());
    }

    #[test]
    fn files_of_its_own_go_along_if_wanted_and_none_is_written_over() {
        let (home, mut session) = home();
        set(&mut session, "./m.png");
        std::fs::write(home.path().join("second/m.png"), "another").unwrap();
        let to = home.path().join("second/look.json");
        let files = session.save_with(&to, OwnFiles::Copied).unwrap();
        assert_eq!(
            files.told().join(" "),
            "copied beside it: m-2.png linked, not copied: wood.png"
        );
        let copied = ["m-2.png", "../shared/wood.png", "example:images/ball-ridge.png"];
        assert_eq!(images(session.look()), copied);
        let read = |name: &str| std::fs::read_to_string(home.path().join(name)).unwrap();
        assert_eq!([read("second/m.png"), read("second/m-2.png")], ["another", "mask"]);
        // What only the past names is used where it is.
        session.undo();
        assert_eq!(images(session.look())[0], "../first/m.png");
    }

    #[test]
    fn what_cannot_be_written_leaves_nothing() {
        let (home, mut session) = home();
        let to = home.path().join("second/look.json");
        std::fs::create_dir(&to).unwrap();
        session.save_with(&to, OwnFiles::Copied).unwrap_err();
        assert!(!home.path().join("second/m.png").exists(), "no copy stays behind");
        assert_eq!(images(session.look())[0], "m.png");
        assert_eq!(session.path(), Some(&*home.path().join("first/look.json")));
    }

    #[test]
    fn a_look_that_stays_in_its_folder_names_its_files_as_before() {
        let (home, mut session) = home();
        let files = session.save_with(&home.path().join("first/b.json"), OwnFiles::Copied).unwrap();
        assert!(files.told().is_empty());
        assert_eq!(images(session.look())[..2], ["m.png", "../shared/wood.png"]);
    }

    /// A scene in `first` of the look there, of another one in a folder of it, and of a mesh.
    fn scene_at(home: &Path) -> PathBuf {
        std::fs::create_dir(home.join("first/looks")).unwrap();
        let other = LOOK.replace("m.png", "../m.png").replace("../shared", "../../shared");
        std::fs::write(home.join("first/looks/other.json"), other).unwrap();
        std::fs::write(home.join("first/cube.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
            .unwrap();
        let scene = home.join("first/scene.json");
        let text = r#"{"chiaro": "scene", "objects": [
            {"id": "cube", "mesh": "cube.obj", "looks": "look.json"},
            {"id": "ball", "mesh": "shape:sphere", "looks": "looks/other.json"}]}"#;
        std::fs::write(&scene, text).unwrap();
        scene
    }

    #[test]
    fn a_scene_takes_its_own_files_along_if_wanted() {
        let (home, mut session) = home();
        let scene = scene_at(home.path());
        session.open(&scene).unwrap();
        session.open(&home.path().join("first/look.json")).unwrap();
        let to = home.path().join("second/scene.json");
        let files = session.save_scene_with(&to, OwnFiles::Copied).unwrap();
        assert!(files.linked.iter().all(|name| name == "wood.png"), "{:?}", files.linked);
        for name in ["scene.json", "look.json", "looks/other.json", "cube.obj", "m.png"] {
            assert!(home.path().join("second").join(name).is_file(), "{name}");
        }
        assert_eq!(session.path(), Some(&*home.path().join("second/look.json")));
        assert!(!session.is_dirty());
        let read = |name: &str| std::fs::read_to_string(home.path().join(name)).unwrap();
        let saved = read("second/scene.json");
        for name in ["\"cube.obj\"", "\"look.json\"", "\"looks/other.json\""] {
            assert!(saved.contains(name), "{saved}");
        }
        let other = Look::read(&read("second/looks/other.json"), "other").value.unwrap();
        assert_eq!(images(&other)[..2], ["../m.png", "../../shared/wood.png"]);
    }

    #[test]
    fn a_scene_goes_nowhere_where_another_file_has_a_place() {
        let (home, mut session) = home();
        let scene = scene_at(home.path());
        session.open(&scene).unwrap();
        session.open(&home.path().join("first/look.json")).unwrap();
        std::fs::write(home.path().join("second/cube.obj"), "another").unwrap();
        let to = home.path().join("second/scene.json");
        let problem = session.save_scene_with(&to, OwnFiles::Copied).unwrap_err();
        assert!(problem.place.file.is_some_and(|file| file.ends_with("cube.obj")));
        assert!(!to.exists() && !home.path().join("second/looks").exists());
        // Without copies the same files are used.
        session.save_scene_with(&to, OwnFiles::Linked).unwrap();
        assert!(std::fs::read_to_string(&to).unwrap().contains("\"../first/cube.obj\""));
    }
}
