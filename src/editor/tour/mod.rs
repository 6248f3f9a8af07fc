//! A tour of two minutes that makes a first look from nothing. Each step stands beside the control that it speaks of and
//! goes on when the artist has really done it: steps look at the document, never at clicks. It keeps nobody from anything,
//! and whatever is done on it is the artist's own work, with undo.

mod card;
mod steps;

use eframe::egui::{Popup, Ui};
use glam::DQuat;

use super::command::Command;
use super::session::Session;
use super::shortcuts::Action;
use crate::document::Look;
use card::{Answer, Progress};
use steps::STEPS;

/// What the tour begins with: a base, and a light that nothing is lit by yet.
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

/// A step that is done is left after so many seconds, so that its effect is seen first.
const LINGER: f64 = 0.9;

/// The tour while it goes on.
pub(crate) struct Tour {
    /// Which document it is about: with another one it ends.
    document: u64,
    /// The step that is shown; after the last one, where to go next.
    step: usize,
    /// How things were when each step was first shown.
    seen: Vec<Before>,
    state: State,
}

/// What a step compares with.
struct Before {
    look: Look,
    illumination: DQuat,
}

/// How far the step that is shown has come.
#[derive(Clone, Copy, Debug, PartialEq)]
enum State {
    /// Its panels are to be brought to the front.
    New,
    Waiting,
    /// It was done before it was shown: whoever came back to it goes on by hand.
    DoneBefore,
    /// Done since then, in seconds of the window, and at this revision.
    Done(f64, u64),
}

impl Tour {
    /// A tour of the look that is open, which should be [`NOTHING`].
    pub(crate) fn new(session: &Session) -> Self {
        Self { document: session.document_number(), step: 0, seen: Vec::new(), state: State::New }
    }

    /// Whether it is still about what is open.
    pub(crate) fn is_about(&self, session: &Session) -> bool {
        self.document == session.document_number()
    }

    /// Shows the step; what it asks for, and whether the tour goes on.
    pub(crate) fn show(&mut self, ui: &Ui, session: &Session) -> (Vec<Command>, bool) {
        let mut out = Vec::new();
        let Some(step) = STEPS.get(self.step) else {
            let (next, is_over) = card::last(ui, session);
            out.extend(next);
            return (out, !is_over);
        };
        if self.seen.len() == self.step {
            let illumination = session.view.illumination;
            self.seen.push(Before { look: session.look().clone(), illumination });
        }
        self.look_at_step(ui, session, &mut out);
        let is_done = matches!(self.state, State::Done(..) | State::DoneBefore);
        let progress = Progress { index: self.step, is_done };
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

    /// Finds out whether the step is done, and goes on a moment after it is.
    fn look_at_step(&mut self, ui: &Ui, session: &Session, out: &mut Vec<Command>) {
        let step = &STEPS[self.step];
        let is_done = (step.is_done)(session, &self.seen[self.step]);
        let now = ui.input(|input| input.time);
        let is_held = ui.input(|input| input.pointer.any_down()) || Popup::is_any_open(ui.ctx());
        self.state = match self.state {
            State::New => {
                out.extend(step.panels.iter().map(|panel| Command::ShowPanel(*panel)));
                if is_done { State::DoneBefore } else { State::Waiting }
            }
            State::Waiting if is_done => State::Done(now, session.revision()),
            // Whoever is still at it is not interrupted.
            State::Done(_, at) if is_done && (is_held || at != session.revision()) => {
                State::Done(now, session.revision())
            }
            State::Done(..) | State::DoneBefore if !is_done => State::Waiting,
            same => same,
        };
        if let State::Done(since, _) = self.state {
            let left = LINGER - (now - since);
            if left <= 0.0 && !is_held {
                self.go_to(self.step + 1);
            }
            ui.ctx().request_repaint_after_secs(left.max(0.02) as f32);
        }
    }

    fn go_to(&mut self, step: usize) {
        self.step = step;
        self.state = State::New;
    }
}

/// What the end of the tour leads to.
const NEXT: [(&str, &str, Action); 3] = [
    ("See the examples", "All of them, as pictures: open one and take it apart", Action::Start),
    ("All shortcuts", "What every key does (?)", Action::Shortcuts),
    ("Find a command", "Everything that the window can do, by name (Ctrl+P)", Action::Commands),
];
