//! The HCBTF that is being painted beside the look.

use std::path::Path;

use super::Session;
use crate::diag::Diagnostic;
use crate::document::{Hcbtf, HcbtfEdit, Look};
use crate::files::journal::{Recovered, Slot};
use crate::frame::UNSAVED_HCBTF;
use crate::state::painting::home::Home;
use crate::state::painting::work::OpenPainting;
use crate::state::painting::{PaintingUpdate, look};
use crate::state::scene::{folder_of, real, relative};

impl Session {
    /// The HCBTF that is being painted, where there is one.
    pub fn painting(&self) -> Option<&OpenPainting> {
        self.painting.as_ref()
    }

    /// The same, for programs that drive the window.
    pub fn painting_mut(&mut self) -> Option<&mut OpenPainting> {
        self.painting.as_mut()
    }

    /// Paints another one, or none.
    pub(crate) fn set_painting(&mut self, work: Option<OpenPainting>) {
        self.keep_painting(work, None);
    }

    /// Takes painting back that a journal gave. The journal goes on where it is.
    pub(crate) fn take_back_painting(&mut self, found: Recovered<Hcbtf>, slot: Slot) {
        self.keep_painting(Some(OpenPainting::taken_back(found)), Some(slot));
    }

    fn keep_painting(&mut self, work: Option<OpenPainting>, slot: Option<Slot>) {
        self.leave_painting(false);
        self.painting = work;
        if let (Some(work), Some((folder, wake))) = (&mut self.painting, &self.journals.folder) {
            work.keep_in(folder, wake.clone(), slot);
        }
        self.painting_changed();
        self.revisions.problems.advance();
    }

    /// Lets go of what is painted; its journal stays if anything in it is not saved.
    pub(super) fn leave_painting(&mut self, in_peace: bool) {
        if let Some(mut work) = self.painting.take() {
            work.leave_journal(in_peace);
        }
    }

    /// Whether putting what is painted aside would lose nothing.
    pub(crate) fn keeps_painting(&mut self) -> bool {
        self.painting.as_mut().is_none_or(OpenPainting::keeps_work)
    }

    /// Whether what is painted has changes that no file holds.
    pub(crate) fn is_painting_dirty(&self) -> bool {
        self.painting.as_ref().is_some_and(OpenPainting::is_dirty)
    }

    /// The picture may be another now.
    pub(crate) fn painting_changed(&mut self) {
        self.revisions.picture.advance();
    }

    /// Takes what a frame found out of what is painted.
    pub(crate) fn update_painting(&mut self, update: PaintingUpdate) {
        self.hides_painting = self.painting.is_some() && !update.is_shown;
        if let Some(work) = &mut self.painting
            && work.set_marked(update.is_marked.then_some(work.at()))
        {
            self.painting_changed();
        }
    }

    /// Applies a change of what is painted. With a `hand`, consecutive changes by it are one step.
    ///
    /// # Errors
    /// A diagnostic where the change is impossible, or nothing is open to be painted; nothing is
    /// changed then.
    pub(crate) fn apply_to_painting(
        &mut self,
        change: HcbtfEdit,
        hand: Option<u64>,
    ) -> Result<(), Box<Diagnostic>> {
        let Some(work) = &mut self.painting else {
            return Err(Box::new(Diagnostic::error("impossible-edit", "no HCBTF is open")));
        };
        self.revisions.step += 1;
        let is_changed = work.apply(change, hand, self.revisions.step)?;
        self.painting_changed();
        if is_changed {
            self.look.end_gesture();
            if let Some(stage) = &mut self.stage {
                stage.end_gesture();
            }
        }
        Ok(())
    }

    /// Saves what is painted to a file, which is its own from then on; the look names that where it
    /// named the one that had no file.
    ///
    /// # Errors
    /// A diagnostic that says why not; the old file is then as it was.
    pub(crate) fn save_painting_as(&mut self, path: &Path) -> Result<(), Box<Diagnostic>> {
        let Some(work) = &mut self.painting else { return Ok(()) };
        let had_no_file = work.path().is_none();
        let before = work.name();
        work.save_as(path)?;
        let now = work.name();
        let file = work.path().map(Path::to_path_buf).filter(|_| had_no_file);
        if let Some(file) = file {
            let name = match &self.look.path {
                Some(look) => relative(&folder_of(look), &file),
                None => file.to_string_lossy().into_owned(),
            };
            let is_named = self.rename_painting(UNSAVED_HCBTF, &name);
            self.rename_home(&file.to_string_lossy());
            if self.look.path.is_none() && self.look().name == before {
                self.call_look(now);
            }
            if is_named && self.look.path.is_some() {
                self.look.history.mark_unsaved();
            }
            match self.is_look_dirty() {
                true => self.begin_journal(None),
                false => self.saved(),
            }
        }
        self.painting_changed();
        Ok(())
    }

    /// The same in the look that is gone back to.
    fn rename_home(&mut self, name: &str) {
        let Some(home) = self.painting.as_mut().and_then(OpenPainting::home_mut) else { return };
        for edit in look::rename(&home.look, &self.project.catalog, UNSAVED_HCBTF, name) {
            // What names nothing of this catalog stays as it is.
            let _ = home.look.apply(edit);
        }
    }

    /// Calls the look that only shows what is painted as that is called; no step, as the name of a
    /// file is none.
    fn call_look(&mut self, name: String) {
        let look = Look { name, ..self.look().clone() };
        self.look.history.amend(look, |_| ());
    }

    /// Remembers the open look for the way back to what is painted, if it shows that.
    pub(super) fn note_home(&mut self) {
        let document = self.revisions.document;
        let is_known =
            |work: &OpenPainting| work.home().is_some_and(|home| home.document == document);
        if self.painting.as_ref().is_none_or(is_known) || !look::shows(self) {
            return;
        }
        let of_scene = self.stage.as_ref().and_then(|stage| stage.path().map(Path::to_path_buf));
        let path = of_scene.or_else(|| self.look.path.clone());
        let home =
            Home { document, path, look: self.look().clone(), view: self.view.orbit.clone() };
        if let Some(work) = &mut self.painting {
            work.set_home(home);
        }
    }

    /// Lets a look without a file, as it stands, count as saved: whoever loses it loses nothing
    /// that they did.
    pub(crate) fn count_as_saved(&mut self) {
        self.look.history.mark_saved();
        self.saved();
    }

    /// Lets the look show the example again that an untouched copy was opened of, which is closed.
    pub(crate) fn give_up_copy(&mut self) {
        let Some(work) = self.painting.as_ref().filter(|work| !work.is_dirty()) else { return };
        let Some(example) = work.example().map(|path| path.to_string_lossy().into_owned()) else {
            return;
        };
        self.rename_painting(UNSAVED_HCBTF, &example);
    }

    /// Lets the look name what is painted otherwise, now and in all its past: that is no step,
    /// since undo would bring a name back that means nothing any more. Returns whether the look
    /// named it so.
    fn rename_painting(&mut self, from: &str, to: &str) -> bool {
        let Some(look) = self.look_naming(from, to) else { return false };
        let is_renamed = look != *self.look();
        self.look.history.amend(look, |edit| look::rename_in(edit, from, to));
        self.revisions.meaning.advance();
        self.changed(true);
        is_renamed
    }

    /// The look with another name for what is painted.
    fn look_naming(&self, from: &str, to: &str) -> Option<Look> {
        let mut look = self.look().clone();
        for edit in look::rename(&look, &self.project.catalog, from, to) {
            look.apply(edit).ok()?;
        }
        Some(look)
    }

    /// What the look calls the file of what is painted, where that is its whole path, and what it
    /// is called from the folder of another file: a look that is saved names its assets by the way
    /// to them.
    pub(super) fn names_of_painting(&self, look: &Path) -> Option<(String, String)> {
        let file = self.painting.as_ref()?.path()?;
        let from = file.to_string_lossy().into_owned();
        let to = relative(&folder_of(look), file);
        (from != to && look::sheets(self.look(), &self.project.catalog).contains(&from))
            .then_some((from, to))
    }

    /// The look as it is written to a file, with what is painted named from there.
    pub(super) fn look_for(&self, names: Option<&(String, String)>) -> Look {
        let named = names.and_then(|(from, to)| self.look_naming(from, to));
        named.unwrap_or_else(|| self.look().clone())
    }

    /// Takes on the names that the look was written with.
    pub(super) fn take_names(&mut self, names: Option<(String, String)>) {
        if let Some((from, to)) = names {
            self.rename_painting(&from, &to);
        }
    }

    /// Takes what another program made of the painted file, as one step that can be undone. Returns
    /// whether anything is another now.
    ///
    /// # Errors
    /// What keeps the file from being read; everything stays as it is then.
    pub(crate) fn reload_painting(&mut self) -> Result<bool, Vec<Diagnostic>> {
        self.revisions.step += 1;
        let Some(work) = &mut self.painting else { return Ok(false) };
        let is_other = work.reload(self.revisions.step)?;
        self.revisions.problems.advance();
        if is_other {
            self.painting_changed();
            self.look.end_gesture();
            if let Some(stage) = &mut self.stage {
                stage.end_gesture();
            }
        }
        Ok(is_other)
    }

    /// Whether the look shows the HCBTF of a file, an example, or the one that has no file yet.
    pub(crate) fn shows_painting(&self, path: &Path) -> bool {
        let folder = self.folder();
        let names = look::sheets(self.look(), &self.project.catalog);
        // What is no file is named the same from everywhere.
        if path == Path::new(UNSAVED_HCBTF) || crate::examples::file(path).is_some() {
            return names.iter().any(|name| Path::new(name) == path);
        }
        names.iter().any(|name| !name.is_empty() && real(&folder.join(name)) == real(path))
    }
}
