//! Holding back of a document over which the last program ended: the document is neither compiled
//! nor drawn until the user asks for it.

use std::path::PathBuf;

use super::Session;
use crate::diag::Diagnostic;
use crate::state::revision::DocumentNumber;
use crate::state::safety::crashes::{DocumentOrigin, Suspect};
use crate::state::scene::OpenScene;

/// State of the holding back.
#[derive(Default)]
pub(crate) struct Holding {
    /// Document, its scene, and number of changes of the suspects, for which `suspect` was found.
    looked_for: Option<(DocumentNumber, Option<PathBuf>, u64)>,
    suspect: Option<Suspect>,
}

impl Session {
    /// Identity of the open look.
    fn look_origin(&self) -> DocumentOrigin {
        DocumentOrigin::new(&self.name(), self.path(), self.look())
    }

    /// Name and file of the document in the picture: the scene, where there is one, else the look.
    pub(crate) fn shown_file(&self) -> (String, Option<PathBuf>) {
        let (name, path) = match &self.stage {
            Some(stage) => (stage.name(), stage.path()),
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
        let stage = self.stage.as_ref().and_then(OpenScene::path).map(PathBuf::from);
        let now = Some((self.revisions.document, stage, self.journals.crashes.changes()));
        if self.journals.holding.looked_for == now {
            return;
        }
        self.journals.holding.looked_for = now;
        let suspect = self.journals.crashes.is_any().then(|| {
            let of_look = self.journals.crashes.suspect(&self.look_origin());
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

    /// The suspect that the open document is held back for.
    pub(crate) fn held(&self) -> Option<&Suspect> {
        self.journals.holding.suspect.as_ref()
    }

    /// Compiles and draws the document that was held back.
    pub(crate) fn try_again(&mut self) {
        if let Some(suspect) = self.journals.holding.suspect.clone() {
            self.journals.crashes.trust(&suspect.document);
        }
    }
}

fn problem(suspect: &Suspect) -> Diagnostic {
    let Suspect { document, step, .. } = suspect;
    let message = format!(
        "Chiaro ended while {} {} the last time, so it is open without being drawn",
        step.doing(),
        document.name
    );
    let hint = "press Try again above to draw it, or change it first and save it";
    Diagnostic::error("not-drawn", message).hint(hint)
}
