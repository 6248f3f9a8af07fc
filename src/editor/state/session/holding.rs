//! Holding back of a document over which the last program ended: the document is neither compiled
//! nor drawn until the user asks for it.

use std::path::PathBuf;

use chiaro_locale::tr;

use super::Session;
use crate::diag::Diagnostic;
use crate::state::crashes::{CrashStep, DocumentOrigin, Suspect};
use crate::state::revision::{DocumentNumber, SuspectsRevision};
use crate::state::scene::OpenScene;

/// State of the holding back.
#[derive(Default)]
pub(crate) struct HeldDocument {
    /// Document, its scene, and revision of the suspects, for which `suspect` was found.
    looked_for: Option<(DocumentNumber, Option<PathBuf>, SuspectsRevision)>,
    pub(super) suspect: Option<Suspect>,
}

impl Session {
    /// Name and file of the document in the picture: the scene, where there is one, else the look.
    pub(crate) fn shown_file(&self) -> (String, Option<PathBuf>) {
        let (name, path) = match &self.open_scene {
            Some(open_scene) => (open_scene.name(), open_scene.path()),
            None => (self.name(), self.path()),
        };
        (name, path.map(PathBuf::from))
    }

    /// Identity of the document in the picture.
    pub(crate) fn shown_origin(&self) -> DocumentOrigin {
        let (name, path) = self.shown_file();
        DocumentOrigin::new(&name, path.as_deref(), self.look())
    }

    /// Holds the open document back, if the last program ended over it.
    pub(super) fn hold_suspect(&mut self) {
        let open_scene = self.open_scene.as_ref().and_then(OpenScene::path).map(PathBuf::from);
        let now =
            Some((self.revisions.document, open_scene, self.journals.crashes.suspects_revision()));
        if self.journals.holding.looked_for == now {
            return;
        }
        self.journals.holding.looked_for = now;
        let suspect = self.journals.crashes.is_any().then(|| {
            let of_look = {
                let origin = DocumentOrigin::new(&self.name(), self.path(), self.look());
                self.journals.crashes.suspect(&origin)
            };
            of_look.or_else(|| self.journals.crashes.suspect(&self.shown_origin()))
        });
        let suspect = suspect.flatten();
        if suspect == self.journals.holding.suspect && suspect.is_none() {
            return;
        }
        self.compilation.problems = suspect.iter().map(problem).collect();
        self.revisions.problems.advance();
        self.journals.holding.suspect = suspect;
    }
}

fn problem(suspect: &Suspect) -> Diagnostic {
    let Suspect { document, step, .. } = suspect;
    let name = &document.name;
    let message = match step {
        CrashStep::Read => tr!(
            "Chiaro ended while reading {name} the last time, so it is open without being drawn"
        ),
        CrashStep::Compile => tr!(
            "Chiaro ended while compiling {name} the last time, so it is open without being drawn"
        ),
        CrashStep::Draw => tr!(
            "Chiaro ended while drawing {name} the last time, so it is open without being drawn"
        ),
    };
    let hint = tr!("press Try again above to draw it, or change it first and save it");
    Diagnostic::error("not-drawn", message).hint(hint)
}
