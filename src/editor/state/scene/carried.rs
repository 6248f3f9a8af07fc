//! Copies of the files that lie with a scene, for a scene that is saved into another folder: its
//! meshes, the looks that are not open, and what those name. There they lie as they lie in the
//! scene's folder, so that their names hold; what lies elsewhere is shared, and is linked.

use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};

use chiaro_locale::tr;

use super::names::{folder_of, relative, rename};
use super::{OPEN_LOOK, OpenScene};
use crate::catalog::Catalog;
use crate::diag::Diagnostic;
use crate::document::Look;
use crate::examples;
use crate::files::{Disk, FileSet, Files as _, make_folder, shortened};
use crate::frame::SHAPE_PREFIX;
use crate::library::Library;
use crate::state::parts::pictures::{MovedPictures, PictureRoute, each_file};

/// Largest size of all files that are copied with a scene, in bytes; others are linked.
const MOST_BYTES: u64 = 512 << 20;

/// Files of a scene on their way to another folder.
pub(crate) struct CarriedFiles {
    from: PathBuf,
    to: PathBuf,
    /// Files to write, with their contents.
    copies: BTreeMap<PathBuf, Vec<u8>>,
    /// Places of the scene's own files in the new folder, by those before.
    places: HashMap<PathBuf, PathBuf>,
    /// Bytes that may still be copied.
    left: u64,
    pub(crate) told: MovedPictures,
}

impl CarriedFiles {
    /// Place of a file in the new folder; `None` for a file that lies elsewhere than with the
    /// scene.
    pub(crate) fn place_of(&self, file: &Path) -> Option<PathBuf> {
        Some(self.to.join(file.strip_prefix(&self.from).ok()?))
    }

    /// Takes a file along as it is. Returns true if it goes along.
    fn take(&mut self, file: &Path) -> Result<bool, Box<Diagnostic>> {
        if self.places.contains_key(file) {
            return Ok(true);
        }
        let bytes = self.place_of(file).and_then(|_| Disk.read(file, self.left).ok());
        match bytes {
            Some(bytes) => self.put(file, bytes).map(|()| true),
            None => {
                let name = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
                if !self.told.linked.contains(&name) {
                    self.told.linked.push(name);
                }
                Ok(false)
            }
        }
    }

    /// Puts a file into the new folder, where no other file may have its place.
    fn put(&mut self, file: &Path, bytes: Vec<u8>) -> Result<(), Box<Diagnostic>> {
        let Some(place) = self.place_of(file) else { return Ok(()) };
        self.left = self.left.saturating_sub(bytes.len() as u64);
        if is_free(&place, Some(&bytes))? {
            self.copies.insert(place.clone(), bytes);
        }
        let name = place.strip_prefix(&self.to).unwrap_or(&place);
        self.told.along.push(name.to_string_lossy().into_owned());
        self.places.insert(file.to_owned(), place);
        Ok(())
    }

    /// Takes a mesh along, and the files that a glTF has beside it.
    fn take_mesh(&mut self, file: &Path) -> Result<(), Box<Diagnostic>> {
        let is_known = self.places.contains_key(file);
        if !self.take(file)? || is_known {
            return Ok(());
        }
        let is_text = file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("gltf"));
        let copy = self.places.get(file).and_then(|place| self.copies.get(place));
        let Some(bytes) = copy.filter(|_| is_text) else { return Ok(()) };
        let json: serde_json::Value = serde_json::from_slice(bytes).unwrap_or_default();
        let parts = ["buffers", "images"].into_iter().filter_map(|part| json[part].as_array());
        let names = parts.flatten().filter_map(|part| part["uri"].as_str());
        for name in names.filter(|name| !name.starts_with("data:")) {
            self.take(&shortened(&file.with_file_name(name)))?;
        }
        Ok(())
    }

    /// Takes a look along, and the files that it names; those that stay are named from there.
    fn take_look(&mut self, file: &Path, library: &Library) -> Result<(), Box<Diagnostic>> {
        if self.places.contains_key(file) {
            return Ok(());
        }
        let (Some(place), Ok(text)) = (self.place_of(file), crate::files::read_text(file)) else {
            return self.take(file).map(drop);
        };
        let Some(mut look) = Look::read(&text, &file.display().to_string()).value else {
            return self.take(file).map(drop);
        };
        let mut catalog = Catalog::new(library);
        catalog.sync(&look, library);
        let [from, to] = [folder_of(file), folder_of(&place)];
        let mut names = Vec::new();
        each_file(&mut look, &catalog, &mut |name| names.push(name.clone()));
        let mut linked = Vec::new();
        for name in names {
            if !self.take(&shortened(&from.join(&name)))? {
                linked.push(name);
            }
        }
        let route = PictureRoute { from: &from, to: Some(&to), takes_equal: false };
        each_file(&mut look, &catalog, &mut |name| {
            if linked.contains(name) {
                route.relink(name);
            }
        });
        let text = if linked.is_empty() { text } else { look.to_text() };
        self.put(file, text.into_bytes())
    }

    /// Writes the copies: all of them, or none.
    ///
    /// # Errors
    /// A diagnostic that names the file which cannot be written.
    pub(crate) fn write(&self) -> Result<(), Box<Diagnostic>> {
        let mut set = FileSet::default();
        for (place, bytes) in &self.copies {
            make_folder(&folder_of(place))?;
            set.add(place, bytes)?;
        }
        set.commit()
    }

    /// Takes the copies away again, as the scene that they are for is not written.
    pub(crate) fn take_away(&self) {
        for place in self.copies.keys() {
            // The copy of a file that is still there is missed by nobody.
            let _ = std::fs::remove_file(place);
        }
    }
}

/// True if a file can be written to a place; false where the same file is there already.
///
/// # Errors
/// A diagnostic where another file is there.
pub(crate) fn is_free(place: &Path, bytes: Option<&[u8]>) -> Result<bool, Box<Diagnostic>> {
    if Disk.metadata(place).is_none() {
        return Ok(true);
    }
    let most = bytes.map_or(0, <[u8]>::len) as u64;
    if bytes.is_some_and(|bytes| Disk.read(place, most).is_ok_and(|there| there == bytes)) {
        return Ok(false);
    }
    let message =
        tr!("another file of this name is there already, and nothing was written over it");
    let problem = Diagnostic::error("already-there", message).in_file(place.display().to_string());
    Err(Box::new(problem.hint(tr!("save into a folder that has no such file"))))
}

impl OpenScene {
    /// Files that go along to the folder of another file: all but the open look, and what that
    /// names. `None` where the scene stays in its folder, or has none yet. Nothing is written.
    ///
    /// # Errors
    /// A diagnostic that names a file in whose place another one lies.
    pub(crate) fn carried(
        &self,
        path: &Path,
        library: &Library,
    ) -> Result<Option<CarriedFiles>, Box<Diagnostic>> {
        let Some(own) = self.document.path.as_deref() else { return Ok(None) };
        let (from, to) = (folder_of(own), folder_of(path));
        if from == to {
            return Ok(None);
        }
        let mut carried = CarriedFiles {
            from,
            to,
            copies: BTreeMap::new(),
            places: HashMap::new(),
            left: MOST_BYTES,
            told: MovedPictures::default(),
        };
        for object in self.scene().objects.values() {
            let mesh = self.path_of(&object.mesh);
            if !object.mesh.starts_with(SHAPE_PREFIX) && examples::file(&mesh).is_none() {
                carried.take_mesh(&mesh)?;
            }
            for name in object.looks.values() {
                let look = self.path_of(name);
                let is_here = name == OPEN_LOOK || self.is_open(name);
                if !is_here && examples::file(&look).is_none() {
                    carried.take_look(&look, library)?;
                }
            }
        }
        Ok(Some(carried))
    }

    /// Names the copies in place of the files that went along. This is no step: undo of an earlier
    /// one leads to the files as they lay.
    pub(crate) fn name_carried(&mut self, carried: &CarriedFiles) {
        let mut scene = self.scene().clone();
        rename(&mut scene, &|name| match carried.places.get(&self.path_of(name)) {
            Some(place) => relative(&self.base, place),
            None => name.to_owned(),
        });
        self.document.history.amend(scene, |_| {});
    }
}
