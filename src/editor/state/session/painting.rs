//! The HCBTF that is being painted beside the look.

use std::path::Path;
use std::sync::Arc;

use chiaro_locale::tr;
use glam::{DQuat, DVec3};

use super::Session;
use crate::diag::Diagnostic;
use crate::document::{Hcbtf, HcbtfEdit, Look};
use crate::files::journal::{JournalSlot, RecoveredWork};
use crate::frame::{SetupLook, UNSAVED_HCBTF};
use crate::state::orbit::{Orbit, PLANE};
use crate::state::painting::home::Home;
use crate::state::painting::work::OpenPainting;
use crate::state::painting::{PaintingUpdate, look};
use crate::state::revision::GestureId;
use crate::state::scene::{folder_of, real, relative};

impl Session {
    /// The HCBTF that is being painted, if there is one.
    pub fn painting(&self) -> Option<&OpenPainting> {
        self.painting.as_ref()
    }

    /// The HCBTF that is being painted, for programs that drive the window.
    pub fn painting_mut(&mut self) -> Option<&mut OpenPainting> {
        self.painting.as_mut()
    }

    /// Paints another HCBTF, or none.
    pub(crate) fn set_painting(&mut self, work: Option<OpenPainting>) {
        self.keep_painting(work, None);
    }

    /// Takes back a painting that a journal gave. The journal goes on in its slot.
    pub(crate) fn take_back_painting(&mut self, found: RecoveredWork<Hcbtf>, slot: JournalSlot) {
        self.keep_painting(Some(OpenPainting::taken_back(found)), Some(slot));
    }

    fn keep_painting(&mut self, work: Option<OpenPainting>, slot: Option<JournalSlot>) {
        self.leave_painting(false);
        self.painting = work;
        if let (Some(work), Some((folder, wake))) = (&mut self.painting, &self.journals.folder) {
            work.keep_in(folder, wake.clone(), slot);
        }
        self.painting_changed();
        self.revisions.problems.advance();
    }

    /// Closes the painting; its journal stays if any change in it is not saved.
    pub(super) fn leave_painting(&mut self, in_peace: bool) {
        if let Some(mut work) = self.painting.take() {
            work.leave_journal(in_peace);
        }
    }

    /// True if putting the painting aside would lose nothing.
    pub(crate) fn keeps_painting(&mut self) -> bool {
        self.painting.as_mut().is_none_or(OpenPainting::keeps_work)
    }

    /// True if the painting has changes that no file holds.
    pub(crate) fn is_painting_dirty(&self) -> bool {
        self.painting.as_ref().is_some_and(OpenPainting::is_dirty)
    }

    /// Notes that the picture may have changed.
    pub(crate) fn painting_changed(&mut self) {
        self.revisions.picture.advance();
    }

    /// Takes the state of the painting in a frame.
    pub(crate) fn update_painting(&mut self, update: PaintingUpdate) {
        self.hides_painting = self.painting.is_some() && !update.is_shown;
        if let Some(work) = &mut self.painting
            && work.set_marked(update.is_marked.then_some(work.at()))
        {
            self.painting_changed();
        }
    }

    /// Applies a change of the painting. Consecutive changes of the same `gesture` are one step.
    ///
    /// # Errors
    /// A diagnostic where the change is impossible, or no HCBTF is open; nothing is changed then.
    pub(crate) fn apply_to_painting(
        &mut self,
        change: HcbtfEdit,
        gesture: Option<GestureId>,
    ) -> Result<(), Box<Diagnostic>> {
        let Some(work) = &mut self.painting else {
            return Err(Box::new(Diagnostic::error(
                "impossible-edit",
                tr!("no painted surface is open"),
            )));
        };
        self.revisions.step.advance();
        let is_changed = work.apply(change, gesture, self.revisions.step)?;
        self.painting_changed();
        if is_changed {
            self.look.end_gesture();
            if let Some(open_scene) = &mut self.open_scene {
                open_scene.end_gesture();
            }
        }
        Ok(())
    }

    /// Saves the painting to a file, which is its own from then on; the look names that file
    /// wherever it named the painting without a file.
    ///
    /// # Errors
    /// A diagnostic with the reason; the old file is then unchanged.
    pub(crate) fn save_painting_as(&mut self, path: &Path) -> Result<(), Box<Diagnostic>> {
        let Some(work) = &mut self.painting else { return Ok(()) };
        let had_no_file = work.path().is_none();
        let before = work.kept_name();
        work.save_as(path)?;
        let now = work.kept_name();
        let file = work.path().map(Path::to_path_buf).filter(|_| had_no_file);
        if let Some(file) = file {
            let name = match &self.look.path {
                Some(look) => relative(&folder_of(look), &file),
                None => file.to_string_lossy().into_owned(),
            };
            let is_named = self.rename_painting(UNSAVED_HCBTF, &name);
            if let Some(home) = self.painting.as_mut().and_then(OpenPainting::home_mut) {
                let name = file.to_string_lossy();
                home.rename_painting(&self.project.catalog, UNSAVED_HCBTF, &name);
            }
            if self.look.path.is_none() && self.look().name == before {
                // A look that only shows the painting has the painting's name; this is no step,
                // since naming a file is none.
                let look = Look { name: now, ..self.look().clone() };
                self.look.history.amend(look, |_| ());
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

    /// Remembers the open look for the way back to the painting, if the look shows it.
    pub(super) fn note_home(&mut self) {
        let document = self.revisions.document;
        let is_known =
            |work: &OpenPainting| work.home().is_some_and(|home| home.document == document);
        if self.painting.as_ref().is_none_or(is_known) || !is_painting_shown(self) {
            return;
        }
        let of_scene = self
            .open_scene
            .as_ref()
            .and_then(|open_scene| open_scene.path().map(Path::to_path_buf));
        let path = of_scene.or_else(|| self.look.path.clone());
        let home =
            Home { document, path, look: self.look().clone(), view: self.view.orbit.clone() };
        if let Some(work) = &mut self.painting {
            work.set_home(home);
        }
    }

    /// Counts a look without a file as saved: whoever loses it loses nothing of their own work.
    pub(crate) fn count_as_saved(&mut self) {
        self.look.history.mark_saved();
        self.saved();
    }

    /// Lets the look show the example again which an untouched copy was made of; the copy is
    /// closed.
    pub(crate) fn give_up_copy(&mut self) {
        let Some(work) = self.painting.as_ref().filter(|work| !work.is_dirty()) else { return };
        let Some(example) = work.example().map(|path| path.to_string_lossy().into_owned()) else {
            return;
        };
        self.rename_painting(UNSAVED_HCBTF, &example);
    }

    /// Renames the painting in the look, now and in all its past: this is no step, since undo would
    /// bring back a name that means nothing any more. Returns true if the look had the old name.
    pub(super) fn rename_painting(&mut self, from: &str, to: &str) -> bool {
        let Some(look) = look::renamed(self.look(), &self.project.catalog, from, to) else {
            return false;
        };
        let is_renamed = look != *self.look();
        self.look.history.amend(look, |edit| look::rename_in(edit, from, to));
        self.revisions.meaning.advance();
        self.changed(true);
        is_renamed
    }

    /// Name of the painting's file in the look, where that is its whole path, and its name relative
    /// to the folder of another file: a saved look names its assets by relative paths.
    pub(super) fn names_of_painting(&self, look: &Path) -> Option<(String, String)> {
        let file = self.painting.as_ref()?.path()?;
        let from = file.to_string_lossy().into_owned();
        let to = relative(&folder_of(look), file);
        (from != to && look::sheets(self.look(), &self.project.catalog).contains(&from))
            .then_some((from, to))
    }

    /// Takes another program's version of the painting's file, as one step that can be undone.
    /// Returns true if the painting changed.
    ///
    /// # Errors
    /// Problems that keep the file from being read; nothing is changed then.
    pub(crate) fn reload_painting(&mut self) -> Result<bool, Vec<Diagnostic>> {
        self.revisions.step.advance();
        let Some(work) = &mut self.painting else { return Ok(false) };
        let is_other = work.reload(&**self.assets.source(), self.revisions.step)?;
        self.revisions.problems.advance();
        if is_other {
            self.painting_changed();
            self.look.end_gesture();
            if let Some(open_scene) = &mut self.open_scene {
                open_scene.end_gesture();
            }
        }
        Ok(is_other)
    }

    /// True if the look shows the HCBTF of a file, an example, or the one that has no file yet.
    pub(crate) fn shows_painting(&self, path: &Path) -> bool {
        let folder = self.look.folder();
        let names = look::sheets(self.look(), &self.project.catalog);
        // Names that are no files are the same from every folder.
        if path == Path::new(UNSAVED_HCBTF) || crate::examples::file(path).is_some() {
            return names.iter().any(|name| Path::new(name) == path);
        }
        names.iter().any(|name| !name.is_empty() && real(&folder.join(name)) == real(path))
    }
}

/// The picture's view with camera and light turned to the sample at work, over a flat square that
/// lies; `None` in a scene, which has its own objects.
pub(crate) fn view_at_sample(session: &Session, work: &OpenPainting) -> Option<Orbit> {
    let mut view = session.view.orbit.clone();
    let (_, light) = session.look().lights.first().filter(|_| session.open_scene().is_none())?;
    if !look::lies_flat(&view) {
        view = Orbit { mesh: PLANE.to_owned(), z_is_up: true, ..Orbit::default() };
    }
    // The square lies in the world with u along x, v along -z and the normal along y.
    let world = |vector: DVec3| DVec3::new(vector.x, vector.z, -vector.y);
    let (grid, at) = (work.grid(), work.at());
    let eye = world(grid.view.vector(at.view));
    view.upright = DQuat::IDENTITY;
    view.pitch = eye.y.clamp(-1.0, 1.0).asin();
    view.yaw = if at.view.theta == 0 { 0.0 } else { eye.x.atan2(eye.z) };
    let shines_from = DVec3::from(light.direction).try_normalize()?;
    view.illumination = DQuat::from_rotation_arc(shines_from, world(grid.light.vector(at.light)));
    Some(view)
}

/// True if the open look, or any look of the open scene, shows the painting.
pub(crate) fn is_painting_shown(session: &Session) -> bool {
    let Some(work) = session.painting() else { return false };
    let path = work.path().unwrap_or(Path::new(UNSAVED_HCBTF));
    let names_it = |look: &Arc<SetupLook>| {
        let names = look::sheets(&look.look, &session.project.catalog);
        names.iter().any(|name| !name.is_empty() && real(&look.folder.join(name)) == real(path))
    };
    session.shows_painting(path)
        || session.open_scene().is_some_and(|open_scene| open_scene.other_looks().any(names_it))
}

/// True if `look`, of the file `path` or of none, shows the painting.
pub(crate) fn is_painting_shown_in(session: &Session, look: &Look, path: Option<&Path>) -> bool {
    let Some(work) = session.painting() else { return false };
    let names = look::sheets(look, &session.project.catalog);
    match work.path() {
        None => path.is_none() && names.iter().any(|name| name == UNSAVED_HCBTF),
        Some(painted) => {
            let folder = path.map(folder_of).unwrap_or_default();
            names.iter().any(|name| !name.is_empty() && real(&folder.join(name)) == real(painted))
        }
    }
}
