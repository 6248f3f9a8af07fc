//! Opening and saving of scenes, and changes that other programs make to their files.

use std::path::{Path, PathBuf};

use super::OpenScene;
use super::names::folder_of;
use crate::diag::Diagnostic;
use crate::document::{History, LoadedDocument, Scene, SceneEdit, Value};
use crate::examples;
use crate::files::write_atomic;
use crate::frame::SHAPE_PREFIX;
use crate::ids::PortName;
use crate::library::Type;
use crate::state::document::OnDisk;
use crate::state::revision::StepTime;

impl OpenScene {
    /// The scene that was read from a file, with the problems in it; only the problems where it
    /// could not be read at all.
    pub(crate) fn opened(
        path: &Path,
        loaded: LoadedDocument<Scene>,
    ) -> Result<Self, Vec<Diagnostic>> {
        let is_partial = loaded.has_errors();
        let LoadedDocument { value, source, diagnostics } = loaded;
        let Some(scene) = value else { return Err(diagnostics) };
        let mut open_scene =
            Self::with(History::new(scene), source, Some(path.to_owned()), folder_of(path));
        open_scene.document.is_partial = is_partial;
        open_scene.document.load_problems = diagnostics;
        Ok(open_scene)
    }

    /// Saves to a file, which is the scene's own from then on.
    ///
    /// # Errors
    /// A diagnostic with the reason; the old file is then unchanged.
    pub(crate) fn save_as(&mut self, path: &Path) -> Result<(), Box<Diagnostic>> {
        let is_own = self.document.check_saving(path)?;
        let scene = self.scene_in(&folder_of(path))?;
        let text = if is_own { self.document.text_of(&scene) } else { scene.to_text() };
        write_atomic(path, text.as_bytes())?;
        self.document.text_was_written(path, &text);
        if self.document.saved() {
            self.begin_journal(None);
        }
        Ok(())
    }

    /// Compares the scene's file with its text when it was last read or written.
    pub(crate) fn on_disk(&self) -> OnDisk {
        match &self.shot {
            Some(shot) => shot.on_disk(),
            None => self.document.on_disk(),
        }
    }

    /// Takes another program's version of the file, as one step that can be undone. `now` is the
    /// time of the step. Returns true if the file could be read without an error; else the scene is
    /// unchanged, and the problems are reported.
    pub(crate) fn reload(&mut self, text: &str, now: StepTime) -> bool {
        let Some(path) = self.document.path.clone() else { return false };
        let loaded = Scene::read(text, &path.display().to_string());
        let has_errors = loaded.has_errors();
        self.document.load_problems = loaded.diagnostics;
        let Some(scene) = loaded.value.filter(|_| !has_errors) else { return false };
        let here = self.scene_from(scene);
        if here.to_text() != self.scene().to_text()
            && let Err(problem) =
                self.apply(SceneEdit::Replace { scene: Box::new(here) }, None, now)
        {
            self.document.load_problems.push(*problem);
            return false;
        }
        self.document.was_reloaded(loaded.source);
        self.begin_journal(None);
        true
    }

    /// Tells the problems of the files again, in the language that is spoken now.
    pub(crate) fn tell_again(&mut self) {
        self.document.tell_again();
        if let Some(shot) = &mut self.shot {
            shot.document.tell_again();
        }
    }

    /// Lets saving write over another program's text.
    pub(crate) fn keep_mine(&mut self, theirs: String) {
        if let Some(shot) = &mut self.shot {
            return shot.document.journal.override_with(theirs);
        }
        self.document.journal.override_with(theirs);
    }

    /// Files that the scene depends on, without its own: meshes, looks that are not open, and the
    /// images of those.
    pub(crate) fn files(&self) -> Vec<PathBuf> {
        let scene = self.scene();
        let meshes = scene.objects.values().map(|object| object.mesh.as_str());
        let meshes =
            meshes.filter(|mesh| !mesh.starts_with(SHAPE_PREFIX)).map(|mesh| self.base.join(mesh));
        let looks = self.closed.keys().filter(|name| !name.starts_with(examples::PREFIX));
        let looks = looks.map(|name| self.path_of(name));
        let under_shot = self.shot.iter().flat_map(|shot| shot.files_under());
        meshes.chain(looks).chain(self.images()).chain(under_shot).collect()
    }

    /// Images of looks that are not open: those that the looks name, and those that objects set in
    /// their place.
    fn images(&self) -> impl Iterator<Item = PathBuf> {
        let closed = self.closed.iter().filter_map(|(name, look)| Some((name, look.as_ref()?)));
        closed.flat_map(|(name, look)| {
            let wear = self
                .scene()
                .objects
                .values()
                .filter(move |object| object.looks.values().any(|worn| worn == name));
            let images =
                look.parameters.iter().filter(|parameter| parameter.port.ty == Type::Image);
            let names: Vec<&PortName> = images.map(|parameter| &parameter.name).collect();
            let set = wear.flat_map(move |object| {
                names.clone().into_iter().filter_map(|name| object.values.get(name))
            });
            let set = set.filter_map(|value| match value {
                Value::Text(path) if !path.is_empty() => Some(look.look.folder.join(path)),
                _ => None,
            });
            look.images.iter().cloned().chain(set)
        })
    }
}
