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

/// Steps of a whole fit, and those of its first proposal.
const STEPS: [u64; 2] = [10, 2];

pub(super) struct FitRun {
    pub(super) of: FittedState,
    pub(super) strokes: Strokes,
    /// Progress of all of it.
    pub(super) progress: Progress,
    /// Progress of the request that is worked at.
    part: Progress,
    /// Request for the fit that was asked for, while a smaller one makes the first proposal.
    next: Option<FitRequest>,
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
        progress.begin(STEPS[0]);
        let keep = if what == FitGoal::ThisLook { self.how.keep } else { KeptParts::default() };
        let options = FitOptions {
            time: session.view.time,
            keep,
            keep_rest: self.how.keep_rest,
            starts: self.how.starts,
            enough: ENOUGH,
        };
        let snapshot = session.snapshot_of(Arc::new(session.look().clone()));
        let first = first_of(what, self.how.starts);
        let steps = STEPS[0] - first.map_or(0, |_| STEPS[1]);
        let whole = FitRequest { what, snapshot, target, options, progress: progress.part(steps) };
        let (request, next) = match first {
            Some((what, starts)) => {
                let options = FitOptions { starts, ..options };
                let (snapshot, target) = (whole.snapshot.clone(), whole.target.clone());
                let progress = progress.part(STEPS[1]);
                (FitRequest { what, snapshot, target, options, progress }, Some(whole))
            }
            None => (whole, None),
        };
        self.outcome = None;
        let (of, strokes, part) = (of(session), Strokes::of(session), request.progress.clone());
        self.running = Some(FitRun { of, strokes, progress, part, next });
        self.fitter.request(|_| request);
        Ok(())
    }

    /// Stops the fit under way: its best result so far is shown soon after. A second call gives up
    /// that result too.
    pub(crate) fn stop(&mut self) {
        let Some(running) = &self.running else { return };
        if self.awaits() {
            self.give_up();
            self.told = Some(tr!("Stopped: this is the best so far").to_owned());
        } else if running.progress.is_stopped() {
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
        let running = self.running.take_if(|running| running.part.is_same(&done.progress))?;
        if running.of != of(session) {
            self.told = Some(tr!("The look was changed while it was fitted: fit again").to_owned());
            return None;
        }
        let fitted = match done.result {
            Ok(fitted) => fitted,
            Err(_) if self.awaits() => return None,
            Err(problems) => {
                self.told = Some(why(&problems));
                return None;
            }
        };
        let is_stopped = running.progress.is_stopped();
        let goes_on = !is_stopped && self.go_on(running);
        let is_found = fitted.look != *done.look && !gains_nothing(&fitted.report);
        if !is_found && !goes_on && !self.awaits() {
            self.told = Some(self.nothing_found(done.what, &fitted.report));
        }
        // Of two that are equally near the first proposal stays.
        let shown = self.outcome.as_ref().map(|shown| &shown.report);
        if !is_found || !shown.is_none_or(|shown| is_nearer(&fitted.report, shown)) {
            return None;
        }
        let FittedLook { look, edit, report, .. } = fitted;
        self.told = is_stopped.then(|| tr!("Stopped: this is the best so far").to_owned());
        let strokes = Strokes::of(session);
        self.outcome = Some(FitOutcome { what: done.what, strokes, edit, report, applied: None });
        Some(Arc::new(look))
    }

    /// Begins the fit that was asked for, after its first proposal; false if that was all.
    fn go_on(&mut self, mut running: FitRun) -> bool {
        let Some(next) = running.next.take() else { return false };
        running.part = next.progress.clone();
        self.running = Some(running);
        self.fitter.request(|_| next);
        true
    }

    /// Message on a fit that found nothing.
    fn nothing_found(&self, what: FitGoal, report: &FitReport) -> String {
        if what == FitGoal::Local {
            return tr!(
                "No light of its own brings it nearer where you painted: paint larger spots, or \
                 fit the whole look"
            )
            .to_owned();
        }
        let (tried, help) = (told_of(&report.tried), self.advice(what, report));
        tr!("Nothing was turned: {tried} of this look bring it no nearer to the strokes. {help}")
    }

    /// Applies the fit: returns its edit, one step. A search for a nearer one ends.
    pub(crate) fn take_on(&mut self, session: &Session) -> Option<Edit> {
        if self.awaits() {
            self.give_up();
        }
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

    /// Discards the fit, and ends a search for a nearer one.
    pub(crate) fn discard(&mut self) -> Vec<Command> {
        self.give_up();
        self.outcome = self.outcome.take().filter(|outcome| outcome.applied.is_some());
        self.told = None;
        vec![super::preview(None)]
    }
}

/// State of the open look.
pub(super) fn of(session: &Session) -> FittedState {
    (session.revisions().document, session.revision(), session.scene_revision())
}

/// Smaller fit that makes a first proposal within seconds, where the fit that is asked for takes
/// several times as long: its goal, and the number of starting points.
fn first_of(what: FitGoal, starts: usize) -> Option<(FitGoal, usize)> {
    match what {
        FitGoal::ThisLook if starts > 2 => Some((what, 1)),
        FitGoal::Layers(count) if count > 1 => Some((FitGoal::Layers(1), starts)),
        FitGoal::Local | FitGoal::ThisLook | FitGoal::Layers(_) => None,
    }
}

/// True if a result is nearer than the one that is shown, at the strokes or at the rest.
fn is_nearer(found: &FitReport, shown: &FitReport) -> bool {
    let gains = |was: f64, is: f64| was - is >= LEAST_GAIN;
    gains(shown.after, found.after)
        || shown.rest.zip(found.rest).is_some_and(|(was, is)| gains(was, is))
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::KnobCounts;
    use crate::tools::fitting::panel::percent_nearer;

    fn report(after: f64, rest: Option<f64>) -> FitReport {
        FitReport {
            painted: 40,
            compared: 40,
            places: 9,
            turned: 3,
            tried: KnobCounts::default(),
            kept: KnobCounts::default(),
            before: 0.3,
            after,
            rest,
            is_stopped: false,
            changed: Vec::new(),
            worst: Vec::new(),
        }
    }

    #[test]
    fn what_is_no_nearer_leaves_the_first_proposal() {
        let shown = report(0.1, Some(0.05));
        assert!(!is_nearer(&report(0.1, Some(0.05)), &shown));
        assert!(!is_nearer(&report(0.12, Some(0.06)), &shown));
        assert!(is_nearer(&report(0.08, Some(0.05)), &shown));
        assert!(is_nearer(&report(0.1, Some(0.04)), &shown));
        assert!(!is_nearer(&report(0.1, None), &report(0.1, None)));
    }

    #[test]
    fn what_a_fit_reached_is_told_in_percent() {
        assert_eq!(percent_nearer(&report(0.06, None)), Some(80));
        assert_eq!(percent_nearer(&report(0.28, None)), None, "hardly seen");
        assert_eq!(percent_nearer(&FitReport { before: 0.0, ..report(0.0, None) }), Some(100));
    }

    #[test]
    fn what_takes_long_begins_with_a_smaller_fit() {
        assert_eq!(first_of(FitGoal::Local, 10), None);
        assert_eq!(first_of(FitGoal::ThisLook, 10), Some((FitGoal::ThisLook, 1)));
        assert_eq!(first_of(FitGoal::Layers(3), 10), Some((FitGoal::Layers(1), 10)));
        for quick in [(FitGoal::ThisLook, 2), (FitGoal::Layers(1), 10)] {
            assert_eq!(first_of(quick.0, quick.1), None);
        }
    }
}
