//! Tour of two minutes that makes a first look from nothing. Each step stands beside the control
//! that it is about, and reports when the artist has really done it: steps look at the document,
//! never at clicks. Only the artist goes on, by one button, so that there is all the time in the
//! world to play with the newly found control. The tour keeps nobody from anything, and whatever is
//! done on it is the artist's own work, with undo.

mod card;
mod steps;

use eframe::egui::Ui;
use glam::DQuat;

use crate::commands::Command;
use crate::document::Look;
use crate::state::revision::DocumentNumber;
use crate::state::session::Session;
use card::{Answer, TourProgress};
use steps::STEPS;

/// Text of the look that the tour begins with: a base, and a light that nothing is lit by yet.
pub(crate) const NOTHING: &str = r##"{
  "chiaro": "look",
  "version": 1,
  "name": "First look",
  "lights": {"key": {"direction": [-0.5, 0.7, 0.6]}},
  "nodes": [
    {"id": "base", "kind": "base", "at": [0, 0], "values": {"color": [0.5, 0.5, 0.5]}},
    {"id": "output", "kind": "output", "at": [520, 0]}
  ],
  "wires": [{"from": "base", "to": "output.color"}]
}"##;

/// Tour while it goes on.
pub(crate) struct Tour {
    /// Number of the document that the tour is about: with another document the tour ends.
    document: DocumentNumber,
    /// Index of the shown step; after the last one, suggestions are shown.
    step: usize,
    /// State of the session when each step was first shown.
    seen: Vec<StepStart>,
    /// True if the panels of the step are still to be brought to the front.
    is_new: bool,
}

/// State of the session that a step compares with.
struct StepStart {
    look: Look,
    illumination: DQuat,
}

impl Tour {
    /// Begins a tour of the open look, which should be [`NOTHING`].
    pub(crate) fn new(session: &Session) -> Self {
        Self { document: session.revisions().document, step: 0, seen: Vec::new(), is_new: true }
    }

    /// True if the tour is about the open document.
    pub(crate) fn is_about(&self, session: &Session) -> bool {
        self.document == session.revisions().document
    }

    /// Shows the step. Returns the commands of the step, and true while the tour goes on.
    pub(crate) fn show(&mut self, ui: &Ui, session: &Session) -> (Vec<Command>, bool) {
        let mut out = Vec::new();
        let Some(step) = STEPS.get(self.step) else {
            let (next, is_over) = card::last(ui, session);
            out.extend(next);
            return (out, !is_over);
        };
        if self.seen.len() == self.step {
            let illumination = session.view.orbit.illumination;
            self.seen.push(StepStart { look: session.look().clone(), illumination });
        }
        if std::mem::take(&mut self.is_new) {
            out.extend(step.panels.iter().map(|panel| Command::ShowPanel(*panel)));
        }
        let is_done = (step.is_done)(session, &self.seen[self.step]);
        let progress = TourProgress { index: self.step, is_done };
        let help = (step.show)(session);
        match card::show(ui, session, step, progress, !help.is_empty()) {
            Some(Answer::Show) => out.extend(help),
            Some(Answer::Back) => self.go_to(self.step.saturating_sub(1)),
            Some(Answer::Next) => self.go_to(self.step + 1),
            Some(Answer::End) => return (out, false),
            None => {}
        }
        (out, true)
    }

    fn go_to(&mut self, step: usize) {
        self.step = step;
        self.is_new = true;
    }
}

/// Suggestions at the end of the tour.
static NEXT: [(&str, &str, Command); 3] = [
    (
        "See the examples",
        "All of them, as pictures: open one and take it apart",
        Command::ShowStart(true),
    ),
    ("All shortcuts", "What every key does (?)", Command::OpenShortcuts),
    ("Find a command", "Everything that the window can do, by name (Ctrl+P)", Command::OpenPalette),
];
