//! What keeps a session's work: journals, and what another program did to its file.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::Session;
use crate::diag::Diagnostic;
use crate::document::journal::{About, Journaled, Op, Recovered, Slot};
use crate::document::{Edit, Look, read_text};
use crate::frame::UNSAVED_HCBTF;
use crate::library::Library;
use crate::state::orbit::Orbit;
use crate::state::painting::work::Work;
use crate::state::paths::absolute;
use crate::state::safety::keeper::{Keeper, Standing};

/// What a journal calls where the window looks from.
pub(super) const VIEW: &str = "view";

/// A document's journal, and what is not sent to it yet.
pub(crate) struct Keeping<D: Journaled> {
    keeper: Option<Keeper<D>>,
    ops: Vec<Op<D::Edit>>,
    /// The view that the journal was told last.
    view: Option<Orbit>,
    /// What the file holds by another program's hand and may be written over.
    overridden: Option<String>,
}

/// How the file is compared with what was read from it or written to it last.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum OnDisk {
    Same,
    /// There is no file, or none yet.
    Gone,
    /// Another text.
    Changed(String),
    /// It cannot be read at this moment.
    Unreadable,
}

impl<D: Journaled> Default for Keeping<D> {
    fn default() -> Self {
        Self { keeper: None, ops: Vec::new(), view: None, overridden: None }
    }
}

impl<D> Keeping<D>
where
    D: Journaled + Send + 'static,
    D::Edit: Send,
{
    /// Keeps journals in a folder from now on. `wake` is called from another thread when that
    /// fails, or works again.
    pub(crate) fn keep_in(&mut self, folder: &Path, wake: impl Fn() + Send + 'static) {
        self.keeper = Some(Keeper::new(folder.to_owned(), wake));
    }

    /// Notes what was done, if anything is kept.
    pub(crate) fn note(&mut self, op: Option<Op<D::Edit>>) {
        if self.keeper.is_some() {
            self.ops.extend(op);
        }
    }

    /// Whether edits are noted, so that one must be kept before it is applied.
    pub(crate) fn is_on(&self) -> bool {
        self.keeper.is_some()
    }

    /// Whether the document as it stands is wanted rather than what was done.
    pub(crate) fn wants_to_begin(&self, is_dirty: bool) -> bool {
        let is_wanted = |keeper: &Keeper<D>| {
            keeper.wants_to_begin() && (keeper.has_begun && is_dirty || !self.ops.is_empty())
        };
        self.keeper.as_ref().is_some_and(is_wanted)
    }

    /// Hands what was done since the last call to the journal; a gesture that goes on may wait for
    /// a moment there.
    pub(crate) fn add(&mut self, goes_on: bool) {
        if let Some(keeper) = &mut self.keeper {
            keeper.add(std::mem::take(&mut self.ops), goes_on);
        }
    }

    /// Tells the journal what else the window wants back from now on, if it has begun.
    pub(crate) fn note_window(&mut self, name: &str, value: serde_json::Value) {
        if let Some(keeper) = self.keeper.as_mut().filter(|keeper| keeper.has_begun) {
            keeper.note_window([(name.to_owned(), value)].into_iter().collect());
        }
    }

    /// Tells the journal where the window looks from, if that is somewhere else now.
    pub(crate) fn note_view(&mut self, view: &Orbit) {
        if let Some(keeper) = self.keeper.as_mut().filter(|_| self.view.as_ref() != Some(view)) {
            self.view = Some(view.clone());
            keeper.note_window([(VIEW.to_owned(), view.to_json())].into_iter().collect());
        }
    }

    /// Begins the journal with a document as it stands, all that was done included.
    pub(crate) fn begin(&mut self, standing: Standing<D>) {
        self.ops.clear();
        if let Some(keeper) = &mut self.keeper {
            keeper.begin(standing);
        }
    }

    /// Forgets what was done: there is nothing that is worth a journal.
    pub(crate) fn clear(&mut self) {
        self.ops.clear();
    }

    /// Lets go of the journal: it stays if anything in it is needed.
    pub(crate) fn leave(&mut self, is_needed: bool, in_peace: bool) {
        self.overridden = None;
        if let Some(keeper) = &mut self.keeper {
            match is_needed {
                true => keeper.leave(in_peace),
                false => keeper.discard(),
            }
            keeper.wait();
        }
    }

    /// Nothing is kept any more.
    pub(crate) fn end(&mut self) {
        self.keeper = None;
    }

    /// Waits until the system has all that was handed over.
    pub(crate) fn wait(&self) {
        if let Some(keeper) = &self.keeper {
            keeper.wait();
        }
    }

    /// Why unsaved work is not kept, if it should be and is not.
    pub(crate) fn problem(&self) -> Option<Diagnostic> {
        self.keeper.as_ref().and_then(Keeper::problem)
    }

    /// Whether everything that was handed over is kept.
    pub(crate) fn keeps(&self) -> bool {
        self.wait();
        self.keeper.as_ref().is_some_and(|keeper| keeper.problem().is_none())
    }

    /// Compares a file with the text that it held when it was read or written last.
    pub(crate) fn on_disk(&self, path: &Path, text: &str) -> OnDisk {
        match read_text(path) {
            Ok(found) if found == text => OnDisk::Same,
            Ok(found) if self.overridden.as_ref() == Some(&found) => OnDisk::Same,
            Ok(found) => OnDisk::Changed(found),
            Err(_) if !path.exists() => OnDisk::Gone,
            Err(_) => OnDisk::Unreadable,
        }
    }

    /// Lets saving write over what another program wrote.
    pub(crate) fn override_with(&mut self, theirs: String) {
        self.overridden = Some(theirs);
    }

    /// After a save nothing of another program's is written over any more.
    pub(crate) fn forget_overridden(&mut self) {
        self.overridden = None;
    }
}

impl Session {
    /// Keeps the journals of unsaved work in a folder from now on. `wake` is called from another
    /// thread when that fails, or works again.
    pub fn keep_in(&mut self, folder: &Path, wake: impl Fn() + Send + Sync + 'static) {
        let wake: Arc<dyn Fn() + Send + Sync> = Arc::new(wake);
        self.keeps = Some((folder.to_owned(), wake.clone()));
        self.kept.keeping.keep_in(folder, move || wake());
        self.keep_stage();
        if let (Some(work), Some((folder, wake))) = (&mut self.painting, &self.keeps) {
            work.keep_in(folder, wake.clone(), None);
        }
        if self.is_look_dirty() {
            self.begin_journal(None);
        }
    }

    /// Hands what was done since the last call to the journals; a gesture that goes on may wait for
    /// a moment there.
    pub fn commit(&mut self, goes_on: bool) {
        if self.kept.commit(goes_on) {
            self.begin_journal(None);
        }
        self.kept.keeping.note_view(&self.view);
        if let Some(stage) = &mut self.stage {
            stage.commit(goes_on);
            stage.note_view(&self.view);
        }
        if let Some(work) = &mut self.painting {
            work.commit(goes_on);
        }
    }

    /// Waits until the system has all that was handed over; for tests, and before something is put
    /// away.
    pub fn wait_for_journal(&self) {
        self.kept.keeping.wait();
        if let Some(stage) = &self.stage {
            stage.keeping().wait();
        }
        if let Some(work) = &self.painting {
            work.wait_for_journal();
        }
    }

    /// Why unsaved work is not kept, if it should be and is not.
    pub(crate) fn keeping_problem(&self) -> Option<Diagnostic> {
        let of_scene = || self.stage.as_ref().and_then(|stage| stage.keeping().problem());
        let of_painting = || self.painting.as_ref().and_then(Work::keeping_problem);
        self.kept.keeping.problem().or_else(of_scene).or_else(of_painting)
    }

    /// Whether closing or another document would lose nothing, once all is handed over.
    pub(crate) fn keeps_work(&mut self) -> bool {
        self.commit(false);
        self.kept.keeping.keeps() && self.stage.as_ref().is_none_or(|stage| stage.keeping().keeps())
    }

    /// Begins the journal with the look as it stands.
    pub(super) fn begin_journal(&mut self, slot: Option<Slot>) {
        if !self.kept.keeping.is_on() {
            return self.kept.keeping.clear();
        }
        let path = self.path().map(absolute);
        let scene = self.stage.as_ref().and_then(|stage| std::path::absolute(stage.path()?).ok());
        let about = About {
            name: self.name(),
            path: path.as_ref().and_then(|path| path.to_str()).map(str::to_owned),
            is_partial: self.is_partial,
            window: serde_json::json!({
                "mesh": self.view.mesh,
                "scene": scene.as_ref().and_then(|path| path.to_str()),
                "staged": self.stage.is_some(),
            }),
        };
        let source = self.path.is_some().then(|| self.source.text().clone());
        self.kept.begin_journal(about, source, slot);
    }

    /// After a save the journal begins anew: with the same past, and nothing unsaved.
    pub(super) fn saved(&mut self) {
        if self.kept.saved() {
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
        let is_needed = self.path.is_none() && (by_scene || by_painting);
        self.kept.leave_journal(is_needed, in_peace);
    }

    /// Closes the journals as a window that is closed does; nothing is kept any more after that.
    pub fn close_journal(&mut self, in_peace: bool) {
        self.leave_journal(in_peace);
        self.kept.keeping.end();
        self.leave_stage(in_peace);
        self.leave_painting(in_peace);
        self.keeps = None;
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
            None => self.use_library(Library::built_in().clone()),
        }
        self.kept_view = found.about.window.get(VIEW).cloned();
        if let Some(mesh) = found.about.window.get("mesh").and_then(serde_json::Value::as_str) {
            self.view.show_on(mesh);
        }
        self.replace(found.history.document().clone(), source, path);
        self.kept.history = found.history;
        self.recall_times();
        self.is_partial = found.about.is_partial;
        self.load_problems = found.damage;
        self.begin_journal(Some(slot));
    }

    /// Looks from where the window did that had the work which was taken back last, if `is_wanted`;
    /// else that is forgotten.
    pub(crate) fn look_as_kept(&mut self, is_wanted: bool) {
        if let Some(kept) = self.kept_view.take().filter(|_| is_wanted) {
            self.view.recall(&kept);
        }
    }

    /// Compares the look's file with what it held when it was read or written last.
    pub(crate) fn on_disk(&self) -> OnDisk {
        self.path
            .as_deref()
            .map_or(OnDisk::Same, |path| self.kept.keeping.on_disk(path, self.source.text()))
    }

    /// Takes what another program made of the file, as one step that can be undone. View and
    /// selection stay. Returns whether it could be read without an error; else the look stays as it
    /// is, and the problems are told.
    pub(crate) fn reload(&mut self, text: &str) -> bool {
        let file = self.path.as_ref().map(|path| path.display().to_string()).unwrap_or_default();
        let loaded = Look::read(text, &file);
        self.problems_number += 1;
        let has_errors = loaded.has_errors();
        self.load_problems = loaded.diagnostics;
        let Some(look) = loaded.value.filter(|_| !has_errors) else { return false };
        if look.to_text() != self.look().to_text()
            && let Err(problem) = self.apply(Edit::Replace { look: Box::new(look) }, None)
        {
            self.load_problems.push(*problem);
            return false;
        }
        self.source = Arc::new(loaded.source);
        self.opened = self.source.clone();
        self.is_partial = false;
        self.kept.history.mark_saved();
        self.saved();
        true
    }

    /// Lets saving write over what another program wrote.
    pub(crate) fn keep_mine(&mut self, theirs: String) {
        self.kept.keeping.override_with(theirs);
    }

    /// Draws again with files that changed: meshes and images are read anew where their files are
    /// others.
    pub(crate) fn files_changed(&mut self) {
        self.files += 1;
        self.stage_changed();
    }

    /// How often files that the look uses have changed.
    pub(crate) fn files(&self) -> u64 {
        self.files
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        // A window that panics is not closed in peace: what it was at may be what broke it.
        self.close_journal(!std::thread::panicking());
    }
}
