//! Journals of a session, and changes of its file by other programs.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::saving::OwnFiles;
use super::shelf::IN_JOURNAL;
use super::{NEW_NAME, Session};
use crate::diag::Diagnostic;
use crate::document::{Edit, Look};
use crate::files::journal::{DocumentInfo, JournalSlot, RecoveredWork};
use crate::frame::{SHAPE_PREFIX, UNSAVED_HCBTF};
use crate::state::arrangement;
use crate::state::document::journal::VIEW;
use crate::state::painting::work::OpenPainting;
use crate::state::parts::pictures::MovedPictures;
use crate::state::paths::absolute;
use crate::state::reading::spoken;
use crate::state::scene::OpenScene;
use crate::state::shot::OpenShot;

impl Session {
    /// Keeps the journals of unsaved work in a folder from now on. `wake` is called from another
    /// thread when a journal cannot be written, or can again.
    pub fn keep_in(&mut self, folder: &Path, wake: impl Fn() + Send + Sync + 'static) {
        let wake: Arc<dyn Fn() + Send + Sync> = Arc::new(wake);
        self.journals.folder = Some((folder.to_owned(), wake.clone()));
        self.look.journal.keep_in(folder, move || wake());
        self.keep_scene();
        if let (Some(work), Some((folder, wake))) = (&mut self.painting, &self.journals.folder) {
            work.keep_in(folder, wake.clone(), None);
        }
        if self.is_look_dirty() {
            self.begin_journal(None);
        }
    }

    /// Hands the operations since the last call to the journals; a gesture that goes on may wait
    /// for a moment there.
    pub fn commit(&mut self, goes_on: bool) {
        if self.look.commit(goes_on) {
            self.begin_journal(None);
        }
        self.look.journal.note_view(&self.view.orbit);
        if let Some(open_scene) = &mut self.open_scene {
            open_scene.commit(goes_on);
            open_scene.note_view(&self.view.orbit);
        }
        if let Some(work) = &mut self.painting {
            work.commit(goes_on);
        }
    }

    /// Waits until the system has all the operations that were handed over; for tests, and before a
    /// document is put away.
    pub fn wait_for_journal(&self) {
        self.look.journal.wait();
        if let Some(open_scene) = &self.open_scene {
            open_scene.journal().wait();
        }
        if let Some(shot) = self.shot() {
            shot.document.journal.wait();
        }
        if let Some(work) = &self.painting {
            work.wait_for_journal();
        }
    }

    /// The reason why unsaved work is not kept, if it should be and is not.
    pub(crate) fn keeping_problem(&self) -> Option<Diagnostic> {
        let of_scene =
            || self.open_scene.as_ref().and_then(|open_scene| open_scene.journal().problem());
        let of_painting = || self.painting.as_ref().and_then(OpenPainting::keeping_problem);
        let of_shot = || self.shot().and_then(|shot| shot.document.journal.problem());
        self.look.journal.problem().or_else(of_scene).or_else(of_shot).or_else(of_painting)
    }

    /// True if closing the window or opening another document would lose nothing, once all
    /// operations are handed over.
    pub(crate) fn keeps_work(&mut self) -> bool {
        self.commit(false);
        self.look.journal.keeps()
            && self.open_scene.as_ref().is_none_or(|open_scene| open_scene.journal().keeps())
            && self.shot().is_none_or(|shot| shot.document.journal.keeps())
    }

    /// Begins the journal with the whole look.
    pub(super) fn begin_journal(&mut self, slot: Option<JournalSlot>) {
        if !self.look.journal.is_on() {
            return self.look.journal.clear();
        }
        let path = self.path().map(absolute);
        let scene = self
            .open_scene
            .as_ref()
            .and_then(|open_scene| std::path::absolute(open_scene.path()?).ok());
        let about = DocumentInfo {
            name: self.name(),
            path: path.as_ref().and_then(|path| path.to_str()).map(str::to_owned),
            is_partial: self.look.is_partial,
            window: serde_json::json!({
                "mesh": self.view.orbit.mesh,
                "scene": scene.as_ref().and_then(|path| path.to_str()),
                "staged": self.open_scene.is_some(),
                IN_JOURNAL: self.shelf_for_journal(),
            }),
        };
        let source = self.look.path.is_some().then(|| self.look.file.source.text().clone());
        self.look.begin_journal(about, source, slot);
    }

    /// Begins the journal anew after a save: with the same past, and nothing unsaved.
    pub(super) fn saved(&mut self) {
        if self.look.saved() {
            self.begin_journal(None);
        }
    }

    /// Closes the look's journal before another look comes; its file stays if any change in it is
    /// not saved.
    pub(crate) fn leave_journal(&mut self, in_peace: bool) {
        self.commit(false);
        self.note_home();
        // A scene that is put aside needs a look without a file, even an unchanged one.
        let by_scene = self.open_scene.as_ref().is_some_and(|open_scene| open_scene.is_dirty());
        // A painting that such a look shows needs the look, too.
        let by_painting = self.is_painting_dirty() && self.shows_painting(Path::new(UNSAVED_HCBTF));
        let by_shelf = !self.shelf().is_empty();
        let is_needed = self.look.path.is_none() && (by_scene || by_painting || by_shelf);
        self.look.leave_journal(is_needed, in_peace);
    }

    /// Closes the journals as a closing window does; nothing is kept after that.
    pub fn close_journal(&mut self, in_peace: bool) {
        self.leave_journal(in_peace);
        self.look.journal.end();
        self.leave_scene(in_peace);
        self.leave_painting(in_peace);
        self.journals.folder = None;
    }

    /// Takes back work that a journal gave: the document, its file, and all steps that can be
    /// undone and redone. The journal goes on in its slot.
    pub(crate) fn take_back(&mut self, found: RecoveredWork<Look>, slot: JournalSlot) {
        let path = found.about.path.as_ref().map(PathBuf::from);
        self.leave_scene_unless_worn(path.as_deref());
        let name = found.about.path.as_deref().unwrap_or("new look");
        let source = Look::read(found.source.as_deref().unwrap_or("{}"), name).source;
        match &path {
            Some(path) => self.use_project(path),
            None => self.leave_all_projects(),
        }
        self.journals.view = found.about.window.get(VIEW).cloned();
        if let Some(mesh) = found.about.window.get("mesh").and_then(serde_json::Value::as_str) {
            self.view.orbit.show_on(mesh);
        }
        self.replace(found.history.document().clone(), source, path);
        self.look.history = found.history;
        // Work that an older program kept may have no places.
        self.place_nodes();
        self.take_back_shelf(&found.about.window);
        self.recall_times();
        self.look.is_partial = found.about.is_partial;
        self.look.load_problems = found.damage;
        self.begin_journal(Some(slot));
    }

    /// Restores the view that came with the work which was last taken back, if `is_wanted`; else
    /// forgets that view.
    pub(crate) fn look_as_kept(&mut self, is_wanted: bool) {
        if let Some(kept) = self.journals.view.take().filter(|_| is_wanted) {
            self.view.orbit.recall(&kept);
        }
    }

    /// Takes another program's version of the file, as one step that can be undone. View and
    /// selection stay. Returns true if the file could be read without an error; else the look is
    /// unchanged, and the problems are reported.
    pub(crate) fn reload(&mut self, text: &str) -> bool {
        if self.shot().is_some() {
            self.files_changed();
            return true;
        }
        let file =
            self.look.path.as_ref().map(|path| path.display().to_string()).unwrap_or_default();
        let loaded = Look::read(text, &file);
        self.revisions.problems.advance();
        let has_errors = loaded.has_errors();
        self.look.load_problems = loaded.diagnostics;
        let Some(mut look) = loaded.value.filter(|_| !has_errors) else { return false };
        arrangement::place_nodes(&mut look, &self.project.library);
        if look.to_text() != self.look().to_text()
            && let Err(problem) = self.apply(Edit::Replace { look: Box::new(look) }, None)
        {
            self.look.load_problems.push(*problem);
            return false;
        }
        self.look.was_reloaded(loaded.source);
        self.saved();
        true
    }

    /// Saves to a file, as [`save_with`](Self::save_with) does. A look that has no file, and that
    /// nobody has named, takes the name of the file in words once it is written. No step is made:
    /// undo takes back what was done by hand.
    ///
    /// # Errors
    /// As [`save_with`](Self::save_with); the look keeps its name then.
    pub(crate) fn save_named(
        &mut self,
        path: &Path,
        own: OwnFiles,
    ) -> Result<MovedPictures, Box<Diagnostic>> {
        let is_unnamed = ["", NEW_NAME.english()].contains(&self.look().name.as_str());
        let stem = path.file_stem().filter(|_| is_unnamed && self.path().is_none());
        let before = stem.map(|stem| {
            let before = self.look().name.clone();
            self.call_look(spoken(&stem.to_string_lossy().replace('-', " ")));
            before
        });
        let saved = self.save_with(path, own);
        if let Some(before) = before.filter(|_| saved.is_err()) {
            self.call_look(before);
        }
        saved
    }

    fn call_look(&mut self, name: String) {
        self.look.history.amend(Look { name, ..self.look().clone() }, |_| ());
        self.changed(false);
    }

    /// Files that the open documents name: meshes, images, and looks that are not open.
    pub(crate) fn named_files(&self) -> Vec<PathBuf> {
        let folder = self.look.folder();
        let shaders = self.compilation.baked().into_iter();
        let images = shaders.flat_map(|shader| &shader.named_images);
        let images = images.map(|image| folder.join(&image.path));
        let mesh = &self.view.orbit.mesh;
        let mesh = (!mesh.starts_with(SHAPE_PREFIX)).then(|| PathBuf::from(mesh));
        let of_scene = self.open_scene().map(OpenScene::files).unwrap_or_default();
        images.chain(mesh).chain(of_scene).collect()
    }

    /// All files that the picture is drawn of: those of the open documents, and those they name.
    pub(crate) fn drawn_files(&self) -> Vec<PathBuf> {
        let shot = self.shot().map(OpenShot::path);
        let scene = self.open_scene().and_then(OpenScene::path);
        let own = [shot, scene, self.path()].into_iter().flatten().map(Path::to_path_buf);
        let all = own.chain(self.named_files()).map(|path| absolute(&path));
        all.collect::<BTreeSet<PathBuf>>().into_iter().collect()
    }

    /// Draws again with files that changed: meshes and images are read anew where their files have
    /// changed.
    pub(crate) fn files_changed(&mut self) {
        self.revisions.files.advance();
        if self.shot().is_some() {
            self.read_under_shot();
        }
        self.scene_changed();
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        // A window that panics is not closed in peace: its document may have caused the panic.
        self.close_journal(!std::thread::panicking());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::Library;

    #[test]
    fn a_look_is_called_after_the_file_that_is_written_alone() {
        let mut session = Session::new(Arc::new(Library::built_in().clone()), || {});
        let folder = tempfile::tempdir().unwrap();
        let nowhere = folder.path().join("none/night-fall.json");
        session.save_named(&nowhere, OwnFiles::Linked).unwrap_err();
        assert_eq!(session.look().name, NEW_NAME.english(), "nothing was written");
        let file = folder.path().join("warm-rim.json");
        session.save_named(&file, OwnFiles::Linked).unwrap();
        assert_eq!(session.look().name, "Warm rim");
        assert!(std::fs::read_to_string(&file).unwrap().contains("\"Warm rim\""));
        session.save_named(&folder.path().join("cold-rim.json"), OwnFiles::Linked).unwrap();
        assert_eq!(session.look().name, "Warm rim", "it has a name");
    }
}
