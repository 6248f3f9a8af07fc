//! Tours of a few minutes: one makes a first look from nothing, one lights a gray scene. Each step
//! stands beside the control that it is about, and reports when the artist has really done it:
//! steps look at the document, never at clicks. Only the artist goes on, by one button, so that
//! there is all the time in the world to play with the newly found control. The tour keeps nobody
//! from anything, and whatever is done on it is the artist's own work, with undo.

mod card;
mod lights;
mod look;

use chiaro_locale::Text;
use eframe::egui::Ui;
use glam::DQuat;

use crate::commands::{Command, PanelId, PlacingCommand, Switch, TourTopic};
use crate::document::{Look, Scene};
use crate::state::revision::DocumentNumber;
use crate::state::session::Session;
use crate::widgets::spots::Spot;
use card::{Answer, TourProgress};

/// Step of a tour.
struct Step {
    title: Text,
    /// Instruction of the step.
    task: Text,
    /// Reason for the step.
    reason: Text,
    /// Panels that are brought to the front for the step.
    panels: &'static [PanelId],
    /// Targets to point at: the first of these that is on the screen.
    spots: fn(&Session) -> Vec<Spot>,
    /// True if the step is done, compared with the state when it was first shown.
    is_done: fn(&Session, &StepStart) -> bool,
    /// Commands that do the step in the artist's place; none where there is nothing to do it to.
    show: fn(&Session) -> Vec<Command>,
}

/// Texts of the card after the last step.
struct TourTexts {
    title: Text,
    /// Account of what was made.
    made: fn(&Session) -> String,
    more: Text,
    next: &'static [Suggestion],
}

/// Next thing to do: label, help and command.
type Suggestion = (Text, Text, Command);

/// A tour, as data.
struct TourRow {
    steps: &'static [Step],
    texts: TourTexts,
    /// Begins the documents of the tour.
    begin: fn(&mut Session),
}

fn row(topic: TourTopic) -> &'static TourRow {
    match topic {
        TourTopic::Look => &look::TOUR,
        TourTopic::Lights => &lights::TOUR,
    }
}

/// Begins the documents of a tour, in place of those that are open.
pub(crate) fn begin(topic: TourTopic, session: &mut Session) {
    (row(topic).begin)(session);
}

/// Tour while it goes on.
pub(crate) struct Tour {
    topic: TourTopic,
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
    scene: Option<Scene>,
    illumination: DQuat,
}

impl Tour {
    /// Begins a tour of the open documents, which should be those of [`begin`].
    pub(crate) fn new(topic: TourTopic, session: &Session) -> Self {
        let document = session.revisions().document;
        Self { topic, document, step: 0, seen: Vec::new(), is_new: true }
    }

    /// True if the tour is about the open document.
    pub(crate) fn is_about(&self, session: &Session) -> bool {
        self.document == session.revisions().document
    }

    /// Shows the step. Returns the commands of the step, and true while the tour goes on.
    pub(crate) fn show(&mut self, ui: &Ui, session: &Session) -> (Vec<Command>, bool) {
        let mut out = Vec::new();
        let TourRow { steps, texts, .. } = row(self.topic);
        let Some(step) = steps.get(self.step) else {
            let (next, is_over) = card::last(ui, session, texts);
            out.extend(next);
            return (out, !is_over);
        };
        if self.seen.len() == self.step {
            let illumination = session.view.orbit.illumination;
            let scene = session.open_scene().map(|open_scene| open_scene.scene().clone());
            self.seen.push(StepStart { look: session.look().clone(), scene, illumination });
        }
        if std::mem::take(&mut self.is_new) {
            out.extend(step.panels.iter().map(|panel| Command::ShowPanel(*panel)));
            // A tool of the step before would take the pointer from what this one is about.
            out.push(Command::Placing(PlacingCommand::Turn(Switch::Off)));
        }
        let is_done = (step.is_done)(session, &self.seen[self.step]);
        let progress = TourProgress { index: self.step, count: steps.len(), is_done };
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
