//! What keeps a session's work: journals, and what another program did to its file.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::Session;
use crate::diag::Diagnostic;
use crate::document::{Edit, Look};
use crate::files::journal::{About, Recovered, Slot};
use crate::frame::UNSAVED_HCBTF;
use crate::state::document::OnDisk;
use crate::state::document::journal::VIEW;
use crate::state::painting::work::OpenPainting;
use crate::state::paths::absolute;
use crate::state::revision::FilesRevision;

impl Session {
    /// Keeps the journals of unsaved work in a folder from now on. `wake` is called from another
    /// thread when that fails, or works again.
    pub fn keep_in(&mut self, folder: &Path, wake: impl Fn() + Send + Sync + 'static) {
        let wake: Arc<dyn Fn() + Send + Sync> = Arc::new(wake);
        self.journals.folder = Some((folder.to_owned(), wake.clone()));
        self.look.journal.keep_in(folder, move || wake());
        self.keep_stage();
        if let (Some(work), Some((folder, wake))) = (&mut self.painting, &self.journals.folder) {
            work.keep_in(folder, wake.clone(), None);
        }
        if self.is_look_dirty() {
            self.begin_journal(None);
        }
    }

    /// Hands what was done since the last call to the journals; a gesture that goes on may wait for
    /// a moment there.
    pub fn commit(&mut self, goes_on: bool) {
        if self.look.commit(goes_on) {
            self.begin_journal(None);
        }
        self.look.journal.note_view(&self.view.orbit);
        if let Some(stage) = &mut self.stage {
            stage.commit(goes_on);
            stage.note_view(&self.view.orbit);
        }
        if let Some(work) = &mut self.painting {
            work.commit(goes_on);
        }
    }

    /// Waits until the system has all that was handed over; for tests, and before something is put
    /// away.
    pub fn wait_for_journal(&self) {
        self.look.journal.wait();
        if let Some(stage) = &self.stage {
            stage.journal().wait();
        }
        if let Some(work) = &self.painting {
            work.wait_for_journal();
        }
    }

    /// Why unsaved work is not kept, if it should be and is not.
    pub(crate) fn keeping_problem(&self) -> Option<Diagnostic> {
        let of_scene = || self.stage.as_ref().and_then(|stage| stage.journal().problem());
        let of_painting = || self.painting.as_ref().and_then(OpenPainting::keeping_problem);
        self.look.journal.problem().or_else(of_scene).or_else(of_painting)
    }

    /// Whether closing or another document would lose nothing, once all is handed over.
    pub(crate) fn keeps_work(&mut self) -> bool {
        self.commit(false);
        self.look.journal.keeps() && self.stage.as_ref().is_none_or(|stage| stage.journal().keeps())
    }

    /// Begins the journal with the look as it stands.
    pub(super) fn begin_journal(&mut self, slot: Option<Slot>) {
        if !self.look.journal.is_on() {
            return self.look.journal.clear();
        }
        let path = self.path().map(absolute);
        let scene = self.stage.as_ref().and_then(|stage| std::path::absolute(stage.path()?).ok());
        let about = About {
            name: self.name(),
            path: path.as_ref().and_then(|path| path.to_str()).map(str::to_owned),
            is_partial: self.look.is_partial,
            window: serde_json::json!({
                "mesh": self.view.orbit.mesh,
                "scene": scene.as_ref().and_then(|path| path.to_str()),
                "staged": self.stage.is_some(),
            }),
        };
        let source = self.look.path.is_some().then(|| self.look.file.source.text().clone());
        self.look.begin_journal(about, source, slot);
    }

    /// After a save the journal begins anew: with the same past, and nothing unsaved.
    pub(super) fn saved(&mut self) {
        if self.look.saved() {
            self.begin_journal(None);
        }
    }

    /// Lets go of the look's journal before another look comes: it stays if anything in it is not
    /// saved.
    pub(crate) fn leave_journal(&mut self, in_peace: bool) {
        self.commit(false);
        self.note_home();
        // What has no file is needed by a scene that is put aside with it, be it as it was in the
        // beginning.
        let by_scene = self.stage.as_ref().is_some_and(|stage| stage.is_dirty());
        // And by what is painted in it.
        let by_painting = self.is_painting_dirty() && self.shows_painting(Path::new(UNSAVED_HCBTF));
        let is_needed = self.look.path.is_none() && (by_scene || by_painting);
        self.look.leave_journal(is_needed, in_peace);
    }

    /// Closes the journals as a window that is closed does; nothing is kept any more after that.
    pub fn close_journal(&mut self, in_peace: bool) {
        self.leave_journal(in_peace);
        self.look.journal.end();
        self.leave_stage(in_peace);
        self.leave_painting(in_peace);
        self.journals.folder = None;
    }

    /// Takes work back that a journal gave: the document, its file, and all that can be undone and
    /// redone. The journal goes on where it is.
    pub(crate) fn take_back(&mut self, found: Recovered<Look>, slot: Slot) {
        let path = found.about.path.as_ref().map(PathBuf::from);
        self.leave_stage_unless_worn(path.as_deref());
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
        self.recall_times();
        self.look.is_partial = found.about.is_partial;
        self.look.load_problems = found.damage;
        self.begin_journal(Some(slot));
    }

    /// Looks from where the window did that had the work which was taken back last, if `is_wanted`;
    /// else that is forgotten.
    pub(crate) fn look_as_kept(&mut self, is_wanted: bool) {
        if let Some(kept) = self.journals.view.take().filter(|_| is_wanted) {
            self.view.orbit.recall(&kept);
        }
    }

    /// Compares the look's file with what it held when it was read or written last.
    pub(crate) fn on_disk(&self) -> OnDisk {
        self.look.on_disk()
    }

    /// Takes what another program made of the file, as one step that can be undone. View and
    /// selection stay. Returns whether it could be read without an error; else the look stays as it
    /// is, and the problems are told.
    pub(crate) fn reload(&mut self, text: &str) -> bool {
        let file =
            self.look.path.as_ref().map(|path| path.display().to_string()).unwrap_or_default();
        let loaded = Look::read(text, &file);
        self.revisions.problems.advance();
        let has_errors = loaded.has_errors();
        self.look.load_problems = loaded.diagnostics;
        let Some(look) = loaded.value.filter(|_| !has_errors) else { return false };
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

    /// Lets saving write over what another program wrote.
    pub(crate) fn keep_mine(&mut self, theirs: String) {
        self.look.journal.override_with(theirs);
    }

    /// Draws again with files that changed: meshes and images are read anew where their files are
    /// others.
    pub(crate) fn files_changed(&mut self) {
        self.revisions.files.advance();
        self.stage_changed();
    }

    /// How often files that the look uses have changed.
    pub(crate) fn files(&self) -> FilesRevision {
        self.revisions.files
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        // A window that panics is not closed in peace: what it was at may be what broke it.
        self.close_journal(!std::thread::panicking());
    }
}
