//! A fit from its beginning to what becomes of it: asked for, stopped, previewed, applied or let go.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use super::work::Done;
use super::work::Job;
use super::{ENOUGH, Fitting, LEAST_PAINTED, Painted, What, target};
use crate::diag::Diagnostic;
use crate::document::{Edit, Tile};
use crate::editor::panels::problems::sentence;
use crate::editor::session::Session;
use crate::fit::{FitOptions, Fitted, Keep, Report};
use crate::hcbtf::Progress;

/// Which look something is about: another revision is another look.
pub(super) type Of = (u64, u64, Option<u64>);

/// What was painted when something was asked for.
#[derive(Clone)]
pub(super) struct Strokes(Option<Arc<Tile>>);

impl Strokes {
    pub(super) fn of(session: &Session) -> Self {
        Self(session.sketch().tile().cloned())
    }

    /// Whether that is what is painted now.
    pub(super) fn are(&self, session: &Session) -> bool {
        match (&self.0, session.sketch().tile()) {
            (Some(one), Some(other)) => Arc::ptr_eq(one, other),
            (None, None) => true,
            _ => false,
        }
    }
}

pub(super) struct Running {
    pub(super) of: Of,
    pub(super) strokes: Strokes,
    pub(super) progress: Arc<Progress>,
}

/// What was fitted. Errors are RMS of a channel over what was painted, from 0 to 1.
pub(super) struct Outcome {
    pub(super) what: What,
    pub(super) strokes: Strokes,
    pub(super) edit: Edit,
    pub(super) report: Report,
    pub(super) before: f64,
    pub(super) after: f64,
    /// How far the rest, which was to stay, went off.
    pub(super) rest: f64,
    pub(super) is_applied: bool,
}

impl Fitting {
    /// Begins a fit; tells where that cannot be.
    pub(crate) fn fit(&mut self, what: What, session: &Session) {
        self.told = self.try_fit(what, session).err().map(str::to_owned);
    }

    fn try_fit(&mut self, what: What, session: &Session) -> Result<(), &'static str> {
        if session.sketch().is_empty() {
            return Err("Nothing is painted yet: take Light or Dark and drag on the object");
        }
        if let Some(obstacle) = self.obstacle(session) {
            return Err(obstacle);
        }
        let Some(ground) = self.ground() else { return Err("The picture is still being read: fit in a moment") };
        let painted = match self.wishes() {
            [] => return Err("No stroke lies well inside of an object that wears this look"),
            few if few.len() < LEAST_PAINTED => {
                return Err("Too little is painted to tell anything of lights: paint a larger spot");
            }
            wishes => wishes.to_vec(),
        };
        let target = target::target(&painted, ground, self.how.hold);
        let wake = self.wake.clone();
        let progress = Arc::new(Progress::telling(move |_| wake()));
        let keep = if what == What::ThisLook { self.how.keep } else { Keep::default() };
        let options = FitOptions { time: session.time, keep, starts: self.how.starts, enough: ENOUGH };
        let still = session.still_of(Arc::new(session.look().clone()));
        self.outcome = None;
        let strokes = Strokes::of(session);
        self.running = Some(Running { of: of(session), strokes, progress: progress.clone() });
        self.fitter.request(|_| Job { what, still, target, painted, options, progress });
        Ok(())
    }

    /// Gives up the fit that is going on.
    pub(crate) fn stop(&mut self) {
        if let Some(running) = self.running.take() {
            running.progress.stop();
            self.told = Some("The fit was stopped: the look is as it was".to_owned());
        }
    }

    pub(super) fn take(&mut self, done: Done, session: &mut Session) {
        // What was given up, or is of a look that is gone, is nobody's.
        if !self.running.as_ref().is_some_and(|running| Arc::ptr_eq(&running.progress, &done.progress)) {
            return;
        }
        let running = self.running.take();
        match done.result {
            Err(problems) => self.told = Some(why(&problems)),
            Ok(_) if running.is_some_and(|running| running.of != of(session)) => {
                self.told = Some("The look was changed while it was fitted: fit again".to_owned());
            }
            Ok(fitted) if fitted.look == *done.look => {
                self.told = Some("Nothing was turned: the look is as near to the strokes as it can come".to_owned());
            }
            Ok(fitted) => {
                session.set_preview(Some(Arc::new(fitted.look.clone())));
                let strokes = Strokes::of(session);
                self.outcome = Some(self.outcome_of(done.what, strokes, &done.painted, fitted));
            }
        }
    }

    fn outcome_of(&self, what: What, strokes: Strokes, painted: &[Painted], fitted: Fitted) -> Outcome {
        let Fitted { edit, report, misses, .. } = fitted;
        let after: HashMap<_, _> = misses.iter().map(|missed| (missed.pixel, *missed)).collect();
        let now = |pixel: [u32; 2]| after.get(&pixel).map(|missed| missed.shown);
        // The same pixels, as they were.
        let ground = self.grounds.latest();
        let was = |pixel: [u32; 2]| ground.filter(|_| after.contains_key(&pixel)).map(|it| target::shown(it, pixel));
        let known: HashSet<_> = painted.iter().map(|wish| wish.pixel).collect();
        let rest = misses.iter().filter(|missed| !known.contains(&missed.pixel));
        let (count, sum) = rest.fold((0.0, 0.0), |(count, sum), missed| (count + 1.0, sum + missed.error.powi(2)));
        Outcome {
            what,
            strokes,
            edit,
            report,
            before: target::off(painted, was),
            after: target::off(painted, now),
            rest: if count > 0.0 { f64::sqrt(sum / count) } else { 0.0 },
            is_applied: false,
        }
    }

    /// Takes on what was fitted: the edit, one step.
    pub(crate) fn apply(&mut self, session: &mut Session) -> Option<Edit> {
        let outcome = self.outcome.as_mut().filter(|outcome| !outcome.is_applied)?;
        outcome.is_applied = true;
        session.set_preview(None);
        self.told = None;
        Some(outcome.edit.clone())
    }

    /// Lets go of what was fitted.
    pub(crate) fn discard(&mut self, session: &mut Session) {
        session.set_preview(None);
        self.outcome = self.outcome.take().filter(|outcome| outcome.is_applied);
        self.told = None;
    }
}

/// Which look is open.
pub(super) fn of(session: &Session) -> Of {
    (session.document_number(), session.revision(), session.stage_version())
}

/// Why a fit came to nothing, for who paints.
fn why(problems: &[Diagnostic]) -> String {
    let Some(first) = problems.first() else { return "Nothing could be fitted".to_owned() };
    match first.code {
        "stopped" => "The fit was stopped: the look is as it was".to_owned(),
        "fit-nothing" => {
            "The look has no light, profile or color that may change: allow more, or fit new layers. What is \
                          wired or keyed stays as it is."
                .to_owned()
        }
        "fit-target" => "No stroke lies well inside of an object that wears this look".to_owned(),
        _ => sentence(first),
    }
}
