//! Opening and saving scenes, and what other programs do to their files.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::Stage;
use super::names::folder_of;
use crate::diag::Diagnostic;
use crate::document::{History, Loaded, Scene, SceneEdit, Value, write_atomic};
use crate::examples;
use crate::frame::SHAPE_PREFIX;
use crate::ids::PortName;
use crate::library::Type;
use crate::state::session::keeping::OnDisk;

impl Stage {
    /// The scene that was read from a file, with what was wrong in it; the problems where it could
    /// not be read at all.
    pub(crate) fn opened(path: &Path, loaded: Loaded<Scene>) -> Result<Self, Vec<Diagnostic>> {
        let is_partial = loaded.has_errors();
        let Loaded { value, source, diagnostics } = loaded;
        let Some(scene) = value else { return Err(diagnostics) };
        let mut stage =
            Self::with(History::new(scene), source, Some(path.to_owned()), folder_of(path));
        stage.is_partial = is_partial;
        stage.load_problems = diagnostics;
        Ok(stage)
    }

    /// Saves to a file, which is the scene's own from then on.
    ///
    /// # Errors
    /// A diagnostic that says why not; the old file is then as it was.
    pub(crate) fn save_as(&mut self, path: &Path) -> Result<(), Box<Diagnostic>> {
        let is_own = self.path.as_deref() == Some(path);
        if is_own && self.is_partial {
            let message =
                "this file holds things that could not be read, and saving over it would lose them";
            return Err(Box::new(
                Diagnostic::error("partly-read", message).hint("save the scene under another name"),
            ));
        }
        if is_own && let OnDisk::Changed(_) = self.on_disk() {
            let message = "another program has changed this scene since it was opened, and nothing \
                           was written over it";
            let hint = "choose above whose version is kept, or save the scene under another name";
            return Err(Box::new(Diagnostic::error("changed-on-disk", message).hint(hint)));
        }
        let scene = self.scene_in(&folder_of(path))?;
        let text = if is_own { self.text(&scene) } else { scene.to_text() };
        write_atomic(path, text.as_bytes())?;
        self.source = Arc::new(Scene::read(&text, &path.display().to_string()).source);
        self.path = Some(path.to_owned());
        self.is_partial = false;
        self.load_problems.clear();
        self.kept.history.mark_saved();
        if self.kept.saved() {
            self.begin_journal(None);
        }
        Ok(())
    }

    /// As the file says it, or said it when it was opened, where that is the same; else the
    /// canonical form.
    fn text(&self, scene: &Scene) -> String {
        let text = scene.to_text_like(&self.source);
        if text == **self.source.text() { text } else { scene.to_text_like(&self.opened) }
    }

    /// Compares the scene's file with what it held when it was read or written last.
    pub(crate) fn on_disk(&self) -> OnDisk {
        self.path
            .as_deref()
            .map_or(OnDisk::Same, |path| self.kept.keeping.on_disk(path, self.source.text()))
    }

    /// Takes what another program made of the file, as one step that can be undone. `now` is when.
    /// Returns whether it could be read without an error; else the scene stays as it is, and the
    /// problems are told.
    pub(crate) fn reload(&mut self, text: &str, now: u64) -> bool {
        let Some(path) = self.path.clone() else { return false };
        let loaded = Scene::read(text, &path.display().to_string());
        let has_errors = loaded.has_errors();
        self.load_problems = loaded.diagnostics;
        let Some(scene) = loaded.value.filter(|_| !has_errors) else { return false };
        let here = self.scene_from(scene);
        if here.to_text() != self.scene().to_text()
            && let Err(problem) =
                self.apply(SceneEdit::Replace { scene: Box::new(here) }, None, now)
        {
            self.load_problems.push(*problem);
            return false;
        }
        self.source = Arc::new(loaded.source);
        self.opened = self.source.clone();
        self.is_partial = false;
        self.kept.history.mark_saved();
        self.begin_journal(None);
        true
    }

    /// Lets saving write over what another program wrote.
    pub(crate) fn keep_mine(&mut self, theirs: String) {
        self.kept.keeping.override_with(theirs);
    }

    /// The files that the scene lives on, but for its own: meshes, looks that are not open, and the
    /// images of those.
    pub(crate) fn files(&self) -> Vec<PathBuf> {
        let scene = self.scene();
        let meshes = scene.objects.values().map(|object| object.mesh.as_str());
        let meshes =
            meshes.filter(|mesh| !mesh.starts_with(SHAPE_PREFIX)).map(|mesh| self.base.join(mesh));
        let looks = self.closed.keys().filter(|name| !name.starts_with(examples::PREFIX));
        let looks = looks.map(|name| self.path_of(name));
        meshes.chain(looks).chain(self.images()).collect()
    }

    /// The images of looks that are not open: those that the looks name, and those that objects set
    /// in their place.
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
