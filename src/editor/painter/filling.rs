//! What the rules make of the samples that nobody painted: worked out on a thread of its own, the
//! newest wish first. The sample at work is worked out beside the others, so that it is seen at
//! once however long they take.

use std::sync::{Arc, Weak};

use crate::diag::Diagnostic;
use crate::document::{Address, Grid, Hcbtf, Tile};
use crate::hcbtf::fill::{fill, refill, sample};
use crate::hcbtf::{Device, Filled, NotFilled};
use crate::progress::Progress;
use crate::state::painting::work::OpenPainting;
use crate::state::worker::Worker;

struct FillRequest {
    hcbtf: Arc<Hcbtf>,
    number: u64,
    progress: Progress,
}

struct FillResult {
    /// What it was asked for.
    of: Arc<Hcbtf>,
    number: u64,
    filled: Result<Arc<Filled>, NotFilled>,
}

/// One sample, ahead of the rest.
struct SampleResult {
    of: Arc<Hcbtf>,
    address: Address,
    tile: Option<Arc<Tile>>,
}

/// Fills what is not painted.
pub(super) struct Filling {
    worker: Worker<FillRequest, FillResult>,
    ahead: Worker<(FillRequest, Address), SampleResult>,
    /// What was asked for last.
    asked: Option<Arc<Hcbtf>>,
    /// What was filled last.
    has: Option<Arc<Hcbtf>>,
    /// Which sample was asked for last, ahead of the rest, and of what.
    asked_ahead: Option<(Arc<Hcbtf>, Address)>,
    progress: Progress,
    /// Of the one sample, which is no part of how far the others are.
    progress_ahead: Progress,
    /// Why nothing could be filled.
    pub(super) problem: Option<Diagnostic>,
}

impl Filling {
    /// `wake` is called from another thread when something is filled.
    pub(super) fn new(wake: impl Fn() + Clone + Send + 'static) -> Self {
        // A stroke changes little of what was filled before, which whoever shows it keeps.
        let mut before: (Arc<Hcbtf>, Weak<Filled>) =
            (Arc::new(Hcbtf::new(Grid::THESIS)), Weak::new());
        let work = move |wish: FillRequest| {
            let filled = match before.1.upgrade() {
                Some(filled) => refill(&wish.hcbtf, (&before.0, &filled), &wish.progress),
                None => fill(&wish.hcbtf, &wish.progress),
            };
            let filled = filled.map(Arc::new);
            if let Ok(filled) = &filled {
                before = (wish.hcbtf.clone(), Arc::downgrade(filled));
            }
            FillResult { of: wish.hcbtf, number: wish.number, filled }
        };
        let ahead = |(wish, address): (FillRequest, Address)| {
            let tile = sample(&wish.hcbtf, address, &wish.progress).ok().flatten();
            SampleResult { of: wish.hcbtf, address, tile }
        };
        Self {
            worker: Worker::new("filling", wake.clone(), work),
            ahead: Worker::new("filling one", wake, ahead),
            asked: None,
            has: None,
            asked_ahead: None,
            progress: Progress::new(),
            progress_ahead: Progress::new(),
            problem: None,
        }
    }

    /// Takes what was filled, and asks for what is not yet, where the device can hold it. Returns
    /// whether there is something new.
    pub(super) fn tick(&mut self, work: &mut OpenPainting, device: &Device) -> bool {
        let mut is_new = self.take_ahead(work);
        let number = work.number();
        for done in self.worker.answers().into_iter().filter(|done| done.number == number) {
            match done.filled {
                Ok(filled) => {
                    work.set_filled(filled);
                    self.has = Some(done.of);
                    (is_new, self.problem) = (true, None);
                }
                Err(NotFilled::Stopped) => {}
                Err(why) => self.problem = Some(why.into()),
            }
        }
        if let Err(problem) = device.check_painted(work.grid()) {
            self.stop();
            self.problem = Some(problem);
            return is_new;
        }
        if !work.rules_wait()
            && !self.asked.as_ref().is_some_and(|asked| Arc::ptr_eq(asked, work.shown()))
        {
            // Other rules make what is being filled useless; one more texel does not.
            let is_other =
                self.asked.as_ref().is_none_or(|asked| asked.rules != work.shown().rules);
            if is_other {
                self.stop();
            }
            self.asked = Some(work.shown().clone());
            self.progress = Progress::new();
            let wish = wish(work, &self.progress);
            self.worker.request(|_| wish);
        }
        self.ask_ahead(work);
        is_new
    }

    fn stop(&self) {
        self.progress.stop();
        self.progress_ahead.stop();
    }

    /// Asks for the sample at work, while the others are not done.
    fn ask_ahead(&mut self, work: &OpenPainting) {
        let (shown, at) = (work.shown(), work.at());
        let is_asked =
            |(of, address): &(Arc<Hcbtf>, Address)| Arc::ptr_eq(of, shown) && *address == at;
        let is_done = self.has.as_ref().is_some_and(|has| Arc::ptr_eq(has, shown));
        if is_done || shown.painted(at).is_some() || self.asked_ahead.as_ref().is_some_and(is_asked)
        {
            return;
        }
        self.asked_ahead = Some((shown.clone(), at));
        self.progress_ahead = Progress::new();
        let wish = (wish(work, &self.progress_ahead), at);
        self.ahead.request(|_| wish);
    }

    fn take_ahead(&self, work: &mut OpenPainting) -> bool {
        let mut is_new = false;
        for SampleResult { of, address, tile } in self.ahead.answers() {
            // Once the others are there too it is one of them.
            let is_late = self.has.as_ref().is_some_and(|has| Arc::ptr_eq(has, &of));
            if let Some(tile) = tile.filter(|_| Arc::ptr_eq(&of, work.shown()) && !is_late) {
                work.set_ahead(address, tile);
                is_new = true;
            }
        }
        is_new
    }

    /// What the rules have made of all that is shown now, if they have.
    pub(super) fn of(&self, work: &OpenPainting) -> Option<Arc<Filled>> {
        let is_it = self.has.as_ref().is_some_and(|has| Arc::ptr_eq(has, work.shown()));
        work.filled().filter(|_| is_it).cloned()
    }

    /// The share that is filled, while that goes on.
    pub(super) fn share(&self) -> Option<f64> {
        self.worker.is_busy().then(|| self.progress.share())
    }

    pub(super) fn is_busy(&self) -> bool {
        self.worker.is_busy() || self.ahead.is_busy()
    }

    pub(super) fn wait(&self) {
        self.ahead.wait();
        self.worker.wait();
    }
}

impl Drop for Filling {
    fn drop(&mut self) {
        self.stop();
    }
}

fn wish(work: &OpenPainting, progress: &Progress) -> FillRequest {
    FillRequest { hcbtf: work.shown().clone(), number: work.number(), progress: progress.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Directions, HcbtfEdit, History, Rule, Strokes};

    #[test]
    fn the_sample_at_work_is_there_before_all_others_are() {
        let directions = Directions { theta: 3, phi: 4 };
        let grid = Grid { size: [12, 12], light: directions, view: directions };
        let rules = vec![Rule::Strokes(Box::new(Strokes::preset("Grass")))];
        let mut work =
            OpenPainting::of_history(History::new(Hcbtf { rules, ..Hcbtf::new(grid) }), None);
        let mut filling = Filling::new(|| {});
        let at = Address::new([1, 2], [2, 3]);
        work.go_to(at);
        let alone = |work: &OpenPainting| sample(work.hcbtf(), at, &Progress::new()).unwrap();
        assert!(!filling.tick(&mut work, &Device::guaranteed()));
        // All that is taken is the one, whether the others are done or not.
        filling.ahead.wait();
        assert!(filling.take_ahead(&mut work) && work.filled().is_none());
        assert!(work.tile(at).is_some());
        assert_eq!(work.tile(at).cloned(), alone(&work));
        assert_eq!(work.tile(Address::new([0, 0], [1, 0])), None);
        filling.wait();
        assert!(filling.tick(&mut work, &Device::guaranteed()));
        assert_eq!(work.tile(at).cloned(), alone(&work));
        assert_eq!(work.tile(at), work.filled().and_then(|filled| filled.tile(at)));
        // Once all are there no more is asked for, wherever one goes.
        work.go_to(Address::default());
        assert!(!filling.tick(&mut work, &Device::guaranteed()) && !filling.is_busy());
        // Another rule is seen at once as well.
        let before = work.tile(Address::default()).cloned();
        let rule = Rule::Strokes(Box::new(Strokes::preset("Pencil")));
        work.apply(HcbtfEdit::SetRule { index: 0, rule }, None, 0).unwrap();
        filling.tick(&mut work, &Device::guaranteed());
        filling.ahead.wait();
        assert!(filling.take_ahead(&mut work));
        assert_ne!(work.tile(Address::default()).cloned(), before);
        filling.wait();
    }
}
