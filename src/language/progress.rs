//! Progress of long work, and requests to stop it.
//!
//! Workers and watchers hold handles to one [`Progress`]. A worker lays its steps out, counts them,
//! and checks between them whether the work was stopped. A watcher reads the share that is done, or
//! is an observer that is called at every step. A piece of work that lays out steps of its own, as
//! a pass of a picture does, gets a [part](Progress::part) that stands for some steps of the whole:
//! the whole moves with the part, and stopping the whole stops the part.

use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use chiaro_locale::tr;

use crate::diag::Diagnostic;

/// Number of fractions of a step, in which parts are counted: whole numbers, so that the sum over
/// threads is exact in any order.
const FRACTIONS: u64 = 1 << 20;

/// Handle to long work: its progress, and whether it is still wanted. Clones are handles to the
/// same work.
#[derive(Clone, Default)]
pub struct Progress(Arc<ProgressCounters>);

#[derive(Default)]
struct ProgressCounters {
    /// Number of fractions of steps that are done.
    done: AtomicU64,
    /// Number of steps that are laid out.
    total: AtomicU64,
    is_stopped: AtomicBool,
    observer: Option<Observer>,
    share_of: Option<ShareOf>,
}

/// Observer that is called at every step, from the thread that made the step.
type Observer = Box<dyn Fn(&Progress) + Send + Sync>;

/// Share of the whole that a part stands for.
struct ShareOf {
    whole: Progress,
    /// Number of steps of the whole.
    steps: u64,
    /// Number of fractions of those steps that the whole has counted so far.
    counted: AtomicU64,
}

impl fmt::Debug for Progress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [done, total] = self.steps();
        let end = if self.is_stopped() { ", stopped" } else { "" };
        write!(f, "Progress({done} of {total}{end})")
    }
}

impl Progress {
    /// Work of which nothing is done.
    pub fn new() -> Self {
        Self::default()
    }

    /// Work of which nothing is done, with an observer that is called at every step, from whatever
    /// thread made the step. The observer may stop the work.
    pub fn observed(observer: impl Fn(&Self) + Send + Sync + 'static) -> Self {
        Self(Arc::new(ProgressCounters {
            observer: Some(Box::new(observer)),
            ..ProgressCounters::default()
        }))
    }

    /// Work of which nothing is done, with an observer that is called with every other percent that
    /// is reached, from 0 to 100.
    pub fn observed_by_percent(observer: impl Fn(u64) + Send + Sync + 'static) -> Self {
        let last = AtomicU64::new(u64::MAX);
        Self::observed(move |progress| {
            let percent = (100.0 * progress.share()) as u64;
            if last.swap(percent, Ordering::Relaxed) != percent {
                observer(percent);
            }
        })
    }

    /// Work that stands for `steps` steps of this work, with steps of its own.
    #[must_use]
    pub fn part(&self, steps: u64) -> Self {
        let share_of = ShareOf { whole: self.clone(), steps, counted: AtomicU64::new(0) };
        Self(Arc::new(ProgressCounters { share_of: Some(share_of), ..ProgressCounters::default() }))
    }

    /// True if both are handles to the same work.
    pub fn is_same(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }

    /// Stops the work: it ends soon after.
    pub fn stop(&self) {
        self.0.is_stopped.store(true, Ordering::Relaxed);
    }

    /// True if this work was stopped, or the whole that this work is a part of.
    pub fn is_stopped(&self) -> bool {
        let mut work = self;
        loop {
            if work.0.is_stopped.load(Ordering::Relaxed) {
                return true;
            }
            match &work.0.share_of {
                Some(share_of) => work = &share_of.whole,
                None => return false,
            }
        }
    }

    /// Fails once the work was stopped.
    ///
    /// # Errors
    /// [`Interruption`], where the work was stopped.
    pub fn check(&self) -> Result<(), Interruption> {
        if self.is_stopped() { Err(Interruption) } else { Ok(()) }
    }

    /// Number of steps that are done, and of all steps as far as is known: 0 before the work is
    /// laid out.
    pub fn steps(&self) -> [u64; 2] {
        let [done, total] = self.fractions();
        [done / FRACTIONS, total]
    }

    /// Share of the work that is done, from 0 to 1.
    pub fn share(&self) -> f64 {
        let [done, total] = self.fractions();
        if total == 0 { 0.0 } else { (done as f64 / FRACTIONS as f64 / total as f64).min(1.0) }
    }

    /// Number of fractions of steps that are done, and of steps that are laid out.
    fn fractions(&self) -> [u64; 2] {
        [self.0.done.load(Ordering::Relaxed), self.0.total.load(Ordering::Relaxed)]
    }

    /// Lays out `total` steps, of which none is done.
    pub fn begin(&self, total: u64) {
        self.0.done.store(0, Ordering::Relaxed);
        self.0.total.store(total, Ordering::Relaxed);
    }

    /// Lays out more steps than before.
    pub fn expect(&self, steps: u64) {
        self.0.total.fetch_add(steps, Ordering::Relaxed);
    }

    /// Counts steps that were done.
    pub fn add(&self, steps: u64) {
        self.advance(steps.saturating_mul(FRACTIONS));
    }

    /// Counts a step, even one that was not laid out, and fails where the work was stopped.
    ///
    /// # Errors
    /// [`Interruption`], where the work was stopped.
    pub fn step(&self) -> Result<(), Interruption> {
        let done = self.0.done.load(Ordering::Relaxed) / FRACTIONS + 1;
        self.0.total.fetch_max(done, Ordering::Relaxed);
        self.add(1);
        self.check()
    }

    /// Counts the rest of a part, and fails where the work was stopped.
    ///
    /// # Errors
    /// [`Interruption`], where the work was stopped.
    pub fn finish(&self) -> Result<(), Interruption> {
        if let Some(share_of) = &self.0.share_of {
            share_of.reach(share_of.steps.saturating_mul(FRACTIONS));
        }
        self.check()
    }

    fn advance(&self, fractions: u64) {
        self.0.done.fetch_add(fractions, Ordering::Relaxed);
        if let Some(observer) = &self.0.observer {
            observer(self);
        }
        if let Some(share_of) = &self.0.share_of {
            let [done, total] = self.fractions();
            let [done, total, steps] = [done, total, share_of.steps].map(u128::from);
            let reached = done * steps / total.max(1);
            let most = steps * u128::from(FRACTIONS);
            share_of.reach(u64::try_from(reached.min(most)).unwrap_or(u64::MAX));
        }
    }
}

impl ShareOf {
    /// Lets the whole count up to `fractions` fractions of the part's steps, each fraction once,
    /// whatever threads come here, and in whatever order.
    fn reach(&self, fractions: u64) {
        let before = self.counted.fetch_max(fractions, Ordering::Relaxed);
        if fractions > before {
            self.whole.advance(fractions - before);
        }
    }
}

/// Error of work that was stopped before it was done.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}", tr!("it was stopped before it was done"))]
pub struct Interruption;

impl Interruption {
    /// Code of the diagnostic.
    pub const CODE: &'static str = "stopped";

    /// True if the problems say that the work was stopped, and so say nothing of the work's
    /// subject.
    pub fn is_among(problems: &[Diagnostic]) -> bool {
        problems.iter().any(|problem| problem.code == Self::CODE)
    }
}

impl From<Interruption> for Diagnostic {
    fn from(stopped: Interruption) -> Self {
        Self::error(Interruption::CODE, stopped.to_string())
    }
}

impl From<Interruption> for Vec<Diagnostic> {
    fn from(stopped: Interruption) -> Self {
        vec![stopped.into()]
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Mutex;

    use super::*;

    #[test]
    fn steps_are_counted_and_told() {
        let shares = Arc::new(Mutex::new(Vec::new()));
        let told = shares.clone();
        let progress = Progress::observed(move |p| told.lock().unwrap().push(p.share()));
        assert_eq!((progress.steps(), progress.share()), ([0, 0], 0.0));
        progress.begin(4);
        progress.add(1);
        progress.step().unwrap();
        assert_eq!((progress.steps(), progress.share()), ([2, 4], 0.5));
        progress.expect(4);
        progress.add(6);
        assert_eq!((progress.steps(), progress.share()), ([8, 8], 1.0));
        progress.step().unwrap();
        assert_eq!(progress.steps(), [9, 9], "a step that nobody laid out");
        assert_eq!(*shares.lock().unwrap(), [0.25, 0.5, 1.0, 1.0]);
        progress.begin(2);
        assert_eq!(progress.steps(), [0, 2], "begun anew");
        assert_eq!(format!("{progress:?}"), "Progress(0 of 2)");
    }

    #[test]
    fn every_percent_is_told_once() {
        let told = Arc::new(Mutex::new(Vec::new()));
        let percents = told.clone();
        let progress = Progress::observed_by_percent(move |p| percents.lock().unwrap().push(p));
        progress.begin(1000);
        (0..30).for_each(|_| progress.add(1));
        progress.add(970);
        assert_eq!(*told.lock().unwrap(), [0, 1, 2, 3, 100]);
    }

    #[test]
    fn what_watches_stops_what_works() {
        let progress = Progress::observed(|progress| {
            if progress.steps()[0] == 2 {
                progress.stop();
            }
        });
        assert_eq!(progress.step(), Ok(()));
        assert_eq!(progress.step(), Err(Interruption));
        assert_eq!(progress.clone().check(), Err(Interruption));
        let problem = Diagnostic::from(Interruption);
        assert!(Interruption::is_among(&[problem]) && !Interruption::is_among(&[]));
    }

    #[test]
    fn the_whole_moves_with_its_parts() {
        let whole = Progress::new();
        whole.begin(3);
        let part = whole.part(2);
        assert!(!part.is_same(&whole) && part.is_same(&part.clone()));
        part.begin(4);
        part.add(1);
        assert_eq!((whole.share(), whole.steps()), (0.5 / 3.0, [0, 3]));
        part.add(3);
        assert_eq!((whole.share(), whole.steps()), (2.0 / 3.0, [2, 3]));
        part.begin(8);
        part.add(8);
        assert_eq!(whole.steps(), [2, 3], "what began anew counts once");
        let silent = whole.part(1);
        silent.finish().unwrap();
        assert_eq!((whole.share(), whole.steps()), (1.0, [3, 3]));
        let of_part = part.part(1);
        whole.stop();
        assert_eq!(of_part.finish(), Err(Interruption));
        assert!(part.is_stopped() && !Progress::new().is_stopped());
    }

    #[test]
    #[expect(clippy::disallowed_methods, reason = "the test is of what threads share")]
    fn parts_on_threads_add_up() {
        let whole = Progress::new();
        whole.begin(3);
        let parts: Vec<Progress> = (0..3).map(|_| whole.part(1)).collect();
        std::thread::scope(|scope| {
            for part in &parts {
                part.begin(7000);
                for _ in 0..7 {
                    scope.spawn(|| (0..1000).for_each(|_| part.add(1)));
                }
            }
        });
        assert_eq!((whole.share(), whole.steps()), (1.0, [3, 3]));
    }
}
