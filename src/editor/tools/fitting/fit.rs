//! Course of a fit: request, stop, preview, applying and discarding.

use std::sync::Arc;

use chiaro_locale::{Text, text, tr};

use super::panel::told_of;
use super::work::FitRequest;
use super::work::FitResult;
use super::{ENOUGH, FitTool, LEAST_PAINTED};
use crate::commands::{Command, FitGoal};
use crate::diag::Diagnostic;
use crate::document::{Edit, Look, Tile};
use crate::fit::{FitOptions, FitReport, FitTarget, FittedLook, KeptParts};
use crate::progress::Progress;
use crate::state::problem_text::sentence;
use crate::state::revision::{DocumentNumber, LookRevision, PictureRevision};
use crate::state::session::Session;

/// State of the look and the scene that a fit belongs to: another revision is another state.
pub(super) type FittedState = (DocumentNumber, LookRevision, Option<PictureRevision>);

/// Strokes at the time of a request.
#[derive(Clone)]
pub(super) struct Strokes(Option<Arc<Tile>>);

impl Strokes {
    pub(super) fn of(session: &Session) -> Self {
        Self(session.sketchbook.sketch().tile().cloned())
    }

    /// True if the strokes are the present ones.
    pub(super) fn are(&self, session: &Session) -> bool {
        match (&self.0, session.sketchbook.sketch().tile()) {
            (Some(one), Some(other)) => Arc::ptr_eq(one, other),
            (None, None) => true,
            _ => false,
        }
    }
}

/// Least gain that counts, as RMS of a channel: a smaller one is neither visible nor shown in any
/// figure.
const LEAST_GAIN: f64 = 0.05 / 255.0;
/// Message on a fit that was stopped before it gained anything.
const STOPPED: Text = text!("The fit was stopped before it came nearer: the look is as it was");

pub(super) struct FitRun {
    pub(super) of: FittedState,
    pub(super) strokes: Strokes,
    pub(super) progress: Progress,
}

/// Result of a fit.
pub(super) struct FitOutcome {
    pub(super) what: FitGoal,
    pub(super) strokes: Strokes,
    pub(super) edit: Edit,
    pub(super) report: FitReport,
    /// State of the look that the edit was applied to, once it is: the result is shown for that
    /// state only.
    pub(super) applied: Option<FittedState>,
}

impl FitTool {
    /// Begins a fit, or sets a message where a fit is not possible.
    pub(crate) fn fit(&mut self, what: FitGoal, session: &Session) {
        self.told = self.try_fit(what, session).err().map(str::to_owned);
    }

    fn try_fit(&mut self, what: FitGoal, session: &Session) -> Result<(), &'static str> {
        if session.sketchbook.sketch().is_empty() {
            return Err(tr!("Nothing is painted yet: take Light or Dark and drag on the object"));
        }
        if let Some(obstacle) = self.obstacle(session) {
            return Err(obstacle);
        }
        let Some(ground) = self.ground() else {
            return Err(tr!("The picture is still being read: fit in a moment"));
        };
        let painted = match self.goals() {
            [] => return Err(tr!("No stroke lies well inside of an object that wears this look")),
            few if few.len() < LEAST_PAINTED => {
                return Err(tr!(
                    "Too little is painted to tell anything of lights: paint a larger spot"
                ));
            }
            goals => goals.to_vec(),
        };
        let target = FitTarget { size: ground.size, goals: painted };
        let wake = self.wake.clone();
        let progress = Progress::observed(move |_| wake());
        let keep = if what == FitGoal::ThisLook { self.how.keep } else { KeptParts::default() };
        let options = FitOptions {
            time: session.view.time,
            keep,
            keep_rest: self.how.keep_rest,
            starts: self.how.starts,
            enough: ENOUGH,
        };
        let snapshot = session.snapshot_of(Arc::new(session.look().clone()));
        self.outcome = None;
        let strokes = Strokes::of(session);
        self.running = Some(FitRun { of: of(session), strokes, progress: progress.clone() });
        self.fitter.request(|_| FitRequest { what, snapshot, target, options, progress });
        Ok(())
    }

    /// Stops the fit under way: its best result so far is shown soon after. A second call gives up
    /// that result too.
    pub(crate) fn stop(&mut self) {
        let Some(running) = &self.running else { return };
        if running.progress.is_stopped() {
            self.give_up();
            self.told = Some(STOPPED.tr().to_owned());
        } else {
            running.progress.stop();
            self.told = Some(tr!("Stopping").to_owned());
        }
    }

    /// Gives up the fit under way, with its result.
    pub(super) fn give_up(&mut self) {
        if let Some(running) = self.running.take() {
            running.progress.stop();
        }
    }

    /// Takes a finished fit. Returns the look to show in place of the open one, if any.
    pub(super) fn take(&mut self, done: FitResult, session: &Session) -> Option<Arc<Look>> {
        // A result that was given up, or that is of another look, is dropped.
        if !self.running.as_ref().is_some_and(|running| running.progress.is_same(&done.progress)) {
            return None;
        }
        let running = self.running.take();
        match done.result {
            Err(problems) => self.told = Some(why(&problems)),
            Ok(_) if running.is_some_and(|running| running.of != of(session)) => {
                self.told =
                    Some(tr!("The look was changed while it was fitted: fit again").to_owned());
            }
            Ok(fitted)
                if done.what == FitGoal::Local
                    && (fitted.look == *done.look || gains_nothing(&fitted.report)) =>
            {
                self.told = Some(
                    tr!("No light of its own brings it nearer where you painted: paint larger \
                         spots, or fit the whole look")
                    .to_owned(),
                );
            }
            Ok(fitted) if fitted.look == *done.look || gains_nothing(&fitted.report) => {
                let tried = told_of(&fitted.report.tried);
                let help = self.advice(done.what, &fitted.report);
                self.told = Some(tr!(
                    "Nothing was turned: {tried} of this look bring it no nearer to the strokes. \
                     {help}"
                ));
            }
            Ok(FittedLook { look, edit, report, .. }) => {
                self.told =
                    report.is_stopped.then(|| tr!("Stopped: this is the best so far").to_owned());
                let strokes = Strokes::of(session);
                self.outcome =
                    Some(FitOutcome { what: done.what, strokes, edit, report, applied: None });
                return Some(Arc::new(look));
            }
        }
        None
    }

    /// Applies the fit: returns its edit, one step.
    pub(crate) fn take_on(&mut self, session: &Session) -> Option<Edit> {
        let outcome = self.outcome.as_mut().filter(|outcome| outcome.applied.is_none())?;
        outcome.applied = Some(of(session));
        self.told = None;
        Some(outcome.edit.clone())
    }

    /// Notes that the edit was applied: from now on the result belongs to the look as it is.
    pub(crate) fn is_taken_on(&mut self, session: &Session) {
        if let Some(applied) = self.outcome.as_mut().and_then(|outcome| outcome.applied.as_mut()) {
            *applied = of(session);
        }
    }

    /// Discards the fit.
    pub(crate) fn discard(&mut self) -> Vec<Command> {
        self.outcome = self.outcome.take().filter(|outcome| outcome.applied.is_some());
        self.told = None;
        vec![super::preview(None)]
    }
}

/// State of the open look.
pub(super) fn of(session: &Session) -> FittedState {
    (session.revisions().document, session.revision(), session.scene_revision())
}

/// True if a complete search gained less than anybody sees.
fn gains_nothing(report: &FitReport) -> bool {
    !report.is_stopped && report.before - report.after < LEAST_GAIN
}

/// Reason why a fit failed, for the user.
fn why(problems: &[Diagnostic]) -> String {
    let Some(first) = problems.first() else { return tr!("Nothing could be fitted").to_owned() };
    match first.code {
        "stopped" => STOPPED.tr().to_owned(),
        "fit-nothing" => {
            tr!("The look has no light, profile or color that may change: keep less, or fit new \
                 layers. What is wired or keyed stays as it is.")
            .to_owned()
        }
        "fit-output" => {
            tr!("Nothing is wired into the look's Output: wire a color into it, over which light \
                 is painted")
            .to_owned()
        }
        "fit-target" => {
            tr!("No stroke lies well inside of an object that wears this look").to_owned()
        }
        _ => sentence(first),
    }
}
