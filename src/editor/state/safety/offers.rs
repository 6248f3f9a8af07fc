//! Offers of work that was left behind: by a window that crashed, by one that was closed, or put
//! aside for another document.

use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use chiaro_locale::{tr, trn};

use crate::clock;
use crate::diag::Diagnostic;
use crate::document::{Look, Scene, Shot};
use crate::files::journal::{
    JournalDocument, JournalSlot, RecoveredDocument, RecoveredWork, left_behind, recover_any,
};
use crate::files::read_text;
use crate::state::scene::real;
use crate::state::session::Session;

/// Age from which the journal of a saved look is discarded: nobody wants to undo steps that old.
const FORGOTTEN: Duration = Duration::from_secs(7 * 24 * 60 * 60);

/// Work that can be taken back from a journal.
#[derive(Debug)]
pub(crate) struct Offer {
    slot: JournalSlot,
    /// Display name of the document.
    pub(crate) name: String,
    /// File of the document, if there is one.
    pub(crate) path: Option<PathBuf>,
    /// Number of undo steps that would be lost; `None` where that is unknown.
    pub(crate) steps: Option<usize>,
    /// Time of the last work on the document.
    pub(crate) written: Option<SystemTime>,
    /// True if the window was closed, and did not crash.
    pub(crate) is_closed: bool,
    /// True if the journal is to be thrown away when this window closes.
    pub(crate) is_thrown: bool,
    /// Problems of the journal.
    pub(crate) damage: Vec<Diagnostic>,
    /// True if anything can be taken back.
    pub(crate) is_readable: bool,
    /// True if the file holds the whole document: only the past is worth anything then, to whoever
    /// opens the file again.
    is_saved: bool,
    /// True for a scene, or a shot over one.
    pub(crate) is_scene: bool,
    /// True for an HCBTF that was being painted.
    pub(crate) is_painting: bool,
    /// File of the document that was open with this one: of a look the scene, of a scene the look.
    pub(crate) beside: Option<PathBuf>,
    /// True for a look that was in a scene.
    is_of_scene: bool,
}

/// Summary of a journal, for any kind of document.
struct Outline {
    name: String,
    path: Option<PathBuf>,
    source: Option<String>,
    /// True if the journal says that the document was saved.
    is_saved: bool,
    /// True if the file holds the document, in whatever way that came.
    is_in_file: bool,
    steps: Option<usize>,
    damage: Vec<Diagnostic>,
    is_closed: bool,
    is_scene: bool,
    is_painting: bool,
    beside: Option<PathBuf>,
    is_of_scene: bool,
}

impl Outline {
    fn read(path: &Path) -> Result<Self, Box<Diagnostic>> {
        Ok(match recover_any(path)? {
            RecoveredDocument::Look(found) => {
                let is_in_file = is_in_file(
                    &found,
                    |text| Some(Look::read(text, "").value?.to_text()),
                    Look::to_text,
                );
                let beside = text_of(&found.about.window, "scene");
                Self { is_in_file, beside, ..Self::of(*found) }
            }
            RecoveredDocument::Scene(found) => {
                let is_in_file = is_in_file(
                    &found,
                    |text| Some(Scene::read(text, "").value?.to_text()),
                    Scene::to_text,
                );
                let beside = text_of(&found.about.window, "look");
                Self { is_in_file, beside, is_scene: true, ..Self::of(*found) }
            }
            RecoveredDocument::Shot(found) => {
                let is_in_file = is_in_file(
                    &found,
                    |text| Some(Shot::read(text, "").value?.to_text()),
                    Shot::to_text,
                );
                let beside = text_of(&found.about.window, "look");
                Self { is_in_file, beside, is_scene: true, ..Self::of(*found) }
            }
            RecoveredDocument::Hcbtf(found) => Self { is_painting: true, ..Self::of(*found) },
        })
    }

    fn of<D: JournalDocument>(found: RecoveredWork<D>) -> Self {
        Self {
            name: found.about.name,
            path: found.about.path.map(PathBuf::from),
            source: found.source,
            is_saved: found.history.is_saved(),
            is_in_file: false,
            steps: found.history.unsaved_steps().or(Some(found.history.steps().0)),
            damage: found.damage,
            is_closed: found.is_closed,
            is_scene: false,
            is_painting: false,
            beside: None,
            is_of_scene: found
                .about
                .window
                .get("staged")
                .and_then(serde_json::Value::as_bool)
                .unwrap_or(false),
        }
    }
}

fn text_of(window: &serde_json::Value, key: &str) -> Option<PathBuf> {
    window.get(key).and_then(serde_json::Value::as_str).map(PathBuf::from)
}

impl Offer {
    fn of(slot: JournalSlot) -> Option<Self> {
        let written = slot.written();
        match Outline::read(slot.path()) {
            Ok(found) => {
                let is_saved = found.is_saved || found.is_in_file;
                if is_saved && written.is_none_or(|written| clock::age(written) > FORGOTTEN) {
                    slot.discard();
                    return None;
                }
                Some(Self {
                    slot,
                    name: found.name,
                    path: found.path,
                    steps: found.steps,
                    written,
                    is_closed: found.is_closed,
                    is_thrown: false,
                    damage: found.damage,
                    is_readable: true,
                    is_saved,
                    is_scene: found.is_scene,
                    is_painting: found.is_painting,
                    beside: found.beside,
                    is_of_scene: found.is_of_scene,
                })
            }
            Err(problem) => Some(Self {
                name: tr!("a damaged journal").to_owned(),
                path: None,
                steps: None,
                written,
                is_closed: false,
                is_thrown: false,
                damage: vec![*problem],
                is_readable: false,
                is_saved: false,
                is_scene: false,
                is_painting: false,
                beside: None,
                is_of_scene: false,
                slot,
            }),
        }
    }

    /// Summary of the offer for people.
    pub(crate) fn summary(&self) -> String {
        let steps = self.steps.map(|count| trn!(count, "{count} change", "{count} changes"));
        let ago = self.written.map(|written| ago(clock::age(written)));
        let parts = [Some(self.name.clone()), steps, ago].into_iter().flatten();
        let damaged = match (self.damage.is_empty(), self.is_readable) {
            (true, _) => None,
            (false, true) => Some(tr!("a part of it was damaged and is lost")),
            (false, false) => Some(tr!("nothing in it can be read")),
        };
        let summary = parts.collect::<Vec<_>>().join(", ");
        damaged.map_or(summary.clone(), |damaged| format!("{summary}; {damaged}"))
    }
}

/// True if the file holds the document: the document was saved, and the journal did not come to
/// know. `canonical` is the canonical form of a text.
fn is_in_file<D: JournalDocument>(
    found: &RecoveredWork<D>,
    canonical: impl Fn(&str) -> Option<String>,
    to_text: impl Fn(&D) -> String,
) -> bool {
    let text = found.about.path.as_ref().and_then(|path| read_text(Path::new(path)).ok());
    text.and_then(|text| canonical(&text))
        .is_some_and(|text| text == to_text(found.history.document()))
}

/// Age in words.
fn ago(age: Duration) -> String {
    match age.as_secs() {
        0..60 => tr!("just now").to_owned(),
        seconds @ 60..3600 => {
            trn!(count = seconds / 60, "{count} minute ago", "{count} minutes ago")
        }
        seconds @ 3600..86_400 => {
            trn!(count = seconds / 3600, "{count} hour ago", "{count} hours ago")
        }
        seconds => trn!(count = seconds / 86_400, "{count} day ago", "{count} days ago"),
    }
}

/// Work that was left behind, the newest first.
#[derive(Debug, Default)]
pub(crate) struct Offers {
    all: Vec<Offer>,
}

impl Offers {
    /// Looks for journals that nobody holds.
    pub(crate) fn look(&mut self, folder: &Path) {
        let mut all: Vec<Offer> = left_behind(folder).into_iter().filter_map(Offer::of).collect();
        all.append(&mut self.all);
        self.all = all;
    }

    /// Offers of unsaved work, each with its number.
    pub(crate) fn shown(&self) -> impl Iterator<Item = (usize, &Offer)> {
        self.all.iter().enumerate().filter(|(_, offer)| !offer.is_saved)
    }

    /// The newest look or scene that a window left unsaved when it was closed.
    pub(crate) fn closed(&self) -> Option<usize> {
        let is_it = |offer: &Offer| offer.is_closed && offer.is_readable && !offer.is_painting;
        self.shown().find(|(_, offer)| is_it(offer)).map(|(number, _)| number)
    }

    /// The newest painting that a window left unsaved when it was closed.
    pub(crate) fn closed_painting(&self) -> Option<usize> {
        let is_it = |offer: &Offer| offer.is_closed && offer.is_readable && offer.is_painting;
        self.shown().find(|(_, offer)| is_it(offer)).map(|(number, _)| number)
    }

    /// The work on the look in this file, if the file is still the one which the work was based on:
    /// with `is_saved` the past of a saved look, else unsaved work of a window that was closed, or
    /// with `is_aside` of any window.
    pub(crate) fn of_file(&self, path: &Path, is_saved: bool, is_aside: bool) -> Option<usize> {
        let path = real(path);
        let is_it = |offer: &Offer| {
            let is_free = is_saved || offer.is_closed || is_aside;
            let is_of_it = offer.path.as_deref().map(real).as_ref() == Some(&path);
            let is_of_it = is_of_it && !offer.is_painting;
            is_of_it && offer.is_saved == is_saved && is_free
        };
        let number = self.all.iter().position(is_it)?;
        let found = Outline::read(self.all[number].slot.path()).ok()?;
        let text = read_text(&path).ok()?;
        let is_same = found.source.as_ref() == Some(&text) && (found.is_saved || !is_saved);
        is_same.then_some(number)
    }

    /// The newest work on a look for which `is_it` is true; `is_it` is given the look's file, if
    /// there is one.
    pub(crate) fn of_look(&self, is_it: impl Fn(&Look, Option<&Path>) -> bool) -> Option<usize> {
        self.all.iter().position(|offer| {
            let may_be =
                offer.is_readable && !offer.is_scene && !offer.is_painting && !offer.is_thrown;
            let found = may_be.then(|| recover_any(offer.slot.path()).ok()).flatten();
            let Some(RecoveredDocument::Look(found)) = found else { return false };
            is_it(found.history.document(), offer.path.as_deref())
        })
    }

    /// The offer with a number.
    pub(crate) fn get(&self, number: usize) -> Option<&Offer> {
        self.all.get(number)
    }

    /// The scene that was closed with a look, if it was not saved then.
    pub(crate) fn scene_closed_with(&self, number: usize) -> Option<usize> {
        let look = self.all.get(number).filter(|offer| !offer.is_scene && !offer.is_painting)?;
        let is_it = |offer: &Offer| offer.is_scene && offer.is_closed && offer.beside == look.path;
        self.shown().find(|(_, offer)| is_it(offer)).map(|(number, _)| number)
    }

    /// The look without a file that was put aside with a scene.
    pub(crate) fn unsaved_of_scene(&self) -> Option<usize> {
        let is_look = |offer: &Offer| !offer.is_scene && !offer.is_painting;
        let is_it = |offer: &Offer| {
            is_look(offer) && offer.is_of_scene && offer.path.is_none() && offer.is_readable
        };
        self.all.iter().position(is_it)
    }

    /// Opens an offer in the window, in place of the open look, which the caller has put aside.
    /// Returns the document's name.
    ///
    /// # Errors
    /// The reason why the journal cannot be read; the offer stays then.
    pub(crate) fn take_back(
        &mut self,
        number: usize,
        session: &mut Session,
    ) -> Result<String, Box<Diagnostic>> {
        let Some(offer) = self.all.get(number) else { return Ok(String::new()) };
        let found = recover_any(offer.slot.path())?;
        let offer = self.all.remove(number);
        match found {
            RecoveredDocument::Look(found) => session.take_back(*found, offer.slot),
            RecoveredDocument::Scene(found) => session.take_back_scene(*found, offer.slot),
            RecoveredDocument::Shot(found) => session.take_back_shot(*found, offer.slot)?,
            RecoveredDocument::Hcbtf(found) => session.take_back_painting(*found, offer.slot),
        }
        Ok(offer.name)
    }

    /// Marks an offer to be thrown away, or not.
    pub(crate) fn throw(&mut self, number: usize, is_thrown: bool) {
        if let Some(offer) = self.all.get_mut(number) {
            offer.is_thrown = is_thrown;
        }
    }
}

impl Drop for Offers {
    fn drop(&mut self) {
        for offer in self.all.drain(..).filter(|offer| offer.is_thrown) {
            offer.slot.discard();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ages_are_said_as_people_say_them() {
        let said = |seconds| ago(Duration::from_secs(seconds));
        assert_eq!(said(59), "just now");
        assert_eq!(said(60), "1 minute ago");
        assert_eq!(said(7199), "1 hour ago");
        assert_eq!(said(200_000), "2 days ago");
    }
}
