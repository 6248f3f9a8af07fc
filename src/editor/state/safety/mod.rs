//! Safety of the user's work: unsaved work is kept in a journal and offered again, files changed by
//! other programs are noticed, and settings are saved. Messages appear in a bar below the top one,
//! and nothing asks in the middle of the work.
//!
//! Suspects, the documents that the last program ended over, are known to `state::crashes`. Readers
//! of files ask there (`app::files`, and the cards of `panels::library`), [`Safety::resume`], and
//! `session::holding`, so that a suspect is neither compiled nor drawn.

pub(crate) mod disk;
pub(crate) mod offers;
pub(crate) mod places;
pub(crate) mod unopened;
mod watch;

use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::time::Duration;

use chiaro_locale::tr;

use crate::diag::Diagnostic;
use crate::document::Look;
use crate::frame::SHAPE_PREFIX;
use crate::state::scene::real;
use crate::state::session::Session;
use crate::state::session::painting::is_painting_shown_in;
use crate::state::settings::{Settings, Theme};
use crate::state::shot::OpenShot;
use disk::DiskState;
use offers::Offers;
use places::Places;
use unopened::UnopenedFile;

/// Times at which the window looks for left work once more, in seconds of its clock: a program that
/// was killed may take a while to release its journal.
const LOOKS: [f64; 3] = [2.0, 6.0, 20.0];

/// Protection of a window's work: journals, watched files, offers and settings.
pub(crate) struct Safety {
    places: Option<Places>,
    pub(crate) disk: DiskState,
    pub(crate) offers: Offers,
    pub(crate) settings: Settings,
    /// Theme and scale of the window in the last frame.
    window: Option<(Theme, f32)>,
    /// True if the user has dismissed the note that nothing is kept.
    pub(crate) is_problem_read: bool,
    /// Number of [`LOOKS`] that were made.
    looks: usize,
    /// The last file that could not be opened.
    pub(crate) unopened: Option<UnopenedFile>,
    /// Files of scenes, and of looks within them, that this window has put aside: the work on them
    /// comes back with them.
    aside: HashSet<PathBuf>,
}

impl Safety {
    /// Creates the protection, which notices changed files, and keeps no journals before
    /// [`keep_in`](Self::keep_in).
    /// `wake` is called from another thread when a file may have changed.
    pub(crate) fn new(wake: impl Fn() + Send + 'static) -> Self {
        Self {
            places: None,
            disk: DiskState::new(wake),
            offers: Offers::default(),
            settings: Settings::default(),
            window: None,
            is_problem_read: false,
            looks: 0,
            unopened: None,
            aside: HashSet::new(),
        }
    }

    /// Keeps journals and settings in `places` from now on, and looks for work that was left
    /// behind.
    pub(crate) fn keep_in(
        &mut self,
        places: Places,
        session: &mut Session,
        wake: impl Fn() + Send + Sync + 'static,
    ) {
        session.keep_in(&places.journals(), wake);
        session.journals.crashes.keep_in(&places.running());
        self.settings = Settings::load(&places.settings());
        if let Some(mesh) = &self.settings.mesh
            && (mesh.starts_with(SHAPE_PREFIX) || Path::new(mesh).exists())
        {
            mesh.clone_into(&mut session.view.orbit.mesh);
            session.view.orbit.z_is_up = self.settings.z_is_up;
        }
        self.places = Some(places);
        self.look();
    }

    /// Notes that a file could not be opened, until another file is.
    pub(crate) fn could_not_open(
        &mut self,
        path: &Path,
        problems: &[Diagnostic],
        session: &Session,
    ) {
        self.unopened = Some(UnopenedFile::new(path, problems, session));
    }

    /// Notes that a file is not read, because the last program ended over it, until another file is
    /// opened.
    pub(crate) fn was_interrupted(&mut self, path: &Path, session: &Session) {
        self.unopened = Some(UnopenedFile::interrupted(path, session));
    }

    /// Path of the file that is not read because the last program ended over it; dismisses the
    /// note.
    pub(crate) fn interrupted(&mut self) -> Option<PathBuf> {
        self.unopened.take().and_then(|unopened| unopened.interrupted)
    }

    /// Text of the note: the file that could not be opened, the reason, and its path.
    pub(crate) fn unopened(&self) -> Option<String> {
        self.unopened.as_ref().map(|unopened| format!("{}\n  {}", unopened.text, unopened.help))
    }

    /// Looks for work that nobody holds.
    pub(crate) fn look(&mut self) {
        if let Some(places) = &self.places {
            self.offers.look(&places.journals());
        }
    }

    /// Resumes the work of the last window that was closed, if anything was not saved then. The
    /// work of a window that crashed is not resumed unasked: its document may have caused the
    /// crash. Returns a message.
    pub(crate) fn resume(&mut self, session: &mut Session) -> Option<String> {
        let look = self.resume_look(session);
        let painting =
            self.offers.closed_painting().filter(|number| !self.is_suspect(*number, session));
        let painting = painting.map(|number| self.take_back(number, session));
        look.or(painting)
    }

    /// True if the last program ended over an offer's document, or over the scene around it: only
    /// the user resumes that.
    fn is_suspect(&self, number: usize, session: &Session) -> bool {
        let offer = self.offers.get(number);
        let files = offer.into_iter().flat_map(|offer| offer.path.iter().chain(&offer.beside));
        files.into_iter().any(|path| session.journals.crashes.suspect_in(path).is_some())
    }

    fn resume_look(&mut self, session: &mut Session) -> Option<String> {
        let number = self.offers.closed()?;
        // A look that was closed in a scene comes back by the scene.
        let number = self.offers.scene_closed_with(number).unwrap_or(number);
        if self.is_suspect(number, session) {
            return None;
        }
        let told = self.take_back(number, session);
        session.look_as_kept(true);
        Some(told)
    }

    /// Remembers that the open scene, and the look in it, are about to be put aside.
    pub(crate) fn put_aside(&mut self, session: &Session) {
        let Some(open_scene) = session.open_scene() else { return };
        let shot = session.shot().map(OpenShot::path);
        self.aside
            .extend([open_scene.path(), session.path(), shot].into_iter().flatten().map(real));
    }

    /// Remembers that a file was put aside, and is wanted back with the work on it.
    pub(crate) fn want_back(&mut self, path: &Path) {
        self.aside.insert(real(path));
    }

    /// Takes back a look without a file that was put aside in the state of `look`. Returns true if
    /// there was one.
    pub(crate) fn take_back_look(&mut self, look: &Look, session: &mut Session) -> bool {
        self.look();
        let text = look.to_text();
        let number = self.offers.of_look(|other, path| path.is_none() && other.to_text() == text);
        number.map(|number| self.take_back(number, session)).is_some()
    }

    /// Takes back the look that was left behind and shows the painting. Returns true if there was
    /// one.
    pub(crate) fn take_back_look_of_painting(&mut self, session: &mut Session) -> bool {
        self.look();
        let is_it = |look: &Look, path: Option<&Path>| is_painting_shown_in(session, look, path);
        let number = self.offers.of_look(is_it);
        if let Some(number) = number {
            self.take_back(number, session);
            session.look_as_kept(true);
        }
        number.is_some()
    }

    /// Takes back the look that was put aside with a scene, and that has no file.
    pub(crate) fn take_back_unsaved(&mut self, session: &mut Session) {
        if let Some(number) = self.offers.unsaved_of_scene() {
            self.take_back(number, session);
        }
    }

    /// Opens a file with the past or the unsaved work that a journal has of it, where the file is
    /// the one which that work was based on. Returns a message; `None` where the file itself must
    /// be read.
    pub(crate) fn reopen(&mut self, path: &Path, session: &mut Session) -> Option<String> {
        if session.shot().is_some() && session.open_scene().is_some_and(|scene| scene.wears(path)) {
            // Under a shot a look is as its file has it.
            return None;
        }
        let is_aside = self.aside.contains(&real(path));
        if let Some(number) = self.offers.of_file(path, false, is_aside) {
            let told = self.take_back(number, session);
            // A user who goes from one look of a scene to another keeps the view.
            session.look_as_kept(session.open_scene().is_none());
            return Some(told);
        }
        let number = self.offers.of_file(path, true, is_aside)?;
        self.take_back(number, session);
        session.look_as_kept(session.open_scene().is_none());
        Some(String::new())
    }

    pub(crate) fn take_back(&mut self, number: usize, session: &mut Session) -> String {
        if self.offers.get(number).is_some_and(|offer| offer.is_painting) {
            return self.take_back_painting(number, session);
        }
        if session.is_dirty() && !session.keeps_work() {
            return tr!("Save this look first: its changes cannot be put aside now").to_owned();
        }
        self.open_scene_of(number, session);
        session.leave_journal(false);
        let told = match self.offers.take_back(number, session) {
            Ok(name) => tr!("{name} is as it was, with all its changes"),
            Err(problem) => problem.message,
        };
        self.look();
        told
    }

    /// Takes back a painting. The open look stays: the painting is seen beside it.
    fn take_back_painting(&mut self, number: usize, session: &mut Session) -> String {
        if session.is_painting_dirty() && !session.keeps_painting() {
            return tr!("Save what you paint first: its changes cannot be put aside now")
                .to_owned();
        }
        let told = match self.offers.take_back(number, session) {
            Ok(name) => tr!("{name} is as it was, with all its changes"),
            Err(problem) => problem.message,
        };
        self.look();
        told
    }

    /// Opens the scene that a look was in when it was put aside, unless that scene is open.
    fn open_scene_of(&self, number: usize, session: &mut Session) {
        let Some(offer) = self.offers.get(number).filter(|offer| !offer.is_scene) else { return };
        let is_open = |path: &Path| {
            session
                .open_scene()
                .and_then(|open_scene| open_scene.path())
                .is_some_and(|open| real(open) == real(path))
        };
        if let Some(scene) = offer.beside.clone().filter(|path| path.is_file() && !is_open(path)) {
            // The look comes back without a scene that cannot be read.
            let _ = session.open(&scene);
        }
    }

    /// Remembers that a file was opened or saved.
    pub(crate) fn opened(&mut self, path: &Path) {
        self.change_settings(|settings| settings.opened(path));
    }

    /// Remembers a mesh; `z_is_up` is true if it was stood up.
    pub(crate) fn shown_on(&mut self, mesh: &str, z_is_up: bool) {
        let path = std::path::absolute(mesh).ok().filter(|_| !mesh.starts_with(SHAPE_PREFIX));
        let mesh = path
            .and_then(|path| path.to_str().map(str::to_owned))
            .unwrap_or_else(|| mesh.to_owned());
        self.change_settings(|settings| {
            settings.mesh = Some(mesh);
            settings.z_is_up = z_is_up;
        });
    }

    /// True if settings are remembered from one start to the next.
    pub(crate) fn remembers(&self) -> bool {
        self.places.is_some()
    }

    /// Remembers theme and scale, and a layout of panels, where this window has changed them.
    pub(crate) fn remember(&mut self, now: (Theme, f32), layout: Option<serde_json::Value>) {
        let is_other = self.window.replace(now).is_some_and(|before| before != now);
        if self.remembers() && (is_other || layout.is_some()) {
            self.change_settings(|settings| {
                if is_other {
                    (settings.theme, settings.scale) = now;
                }
                settings.layout = layout.or(settings.layout.take());
            });
        }
    }

    /// Changes the settings, and saves them.
    pub(crate) fn change_settings(&mut self, change: impl FnOnce(&mut Settings)) {
        match self.places.as_ref().map(Places::settings) {
            // A window that cannot save the settings goes on with those it knew: nothing of
            // anybody's work is lost.
            Some(path) => self.settings = Settings::change(&path, &self.settings, change),
            None => change(&mut self.settings),
        }
    }

    /// Drops notes that no longer hold: another file was opened, or work is kept again.
    pub(crate) fn forget_old_notes(&mut self, session: &Session) {
        self.is_problem_read &= session.keeping_problem().is_some();
        self.unopened = self.unopened.take().filter(|unopened| unopened.is_new(session));
    }

    /// Checks files when it is time to, or when the window has the focus again; `now` is in seconds
    /// of the window's clock. Returns a message, and the time until the next call.
    pub(crate) fn tick(
        &mut self,
        now: f64,
        has_come_back: bool,
        session: &mut Session,
    ) -> (Option<String>, Option<Duration>) {
        if LOOKS.get(self.looks).is_some_and(|&time| now >= time) {
            self.looks += 1;
            self.look();
        }
        self.disk.tick(session, now, has_come_back)
    }

    /// Checks files at once. Returns a message.
    pub(crate) fn look_at_files(&mut self, session: &mut Session) -> Option<String> {
        self.disk.check(session)
    }

    /// Folder of the user's own library of parts; `None` where the user has no folders.
    pub(crate) fn library(&self) -> Option<PathBuf> {
        self.places.as_ref().map(Places::library)
    }

    /// Recent files, the newest first, each with true if it still exists.
    pub(crate) fn recent(&self) -> impl Iterator<Item = (&PathBuf, bool)> {
        self.settings.recent.iter().map(|path| (path, path.exists()))
    }
}
