//! Filling of unpainted samples by the rules: computed on a thread of its own, the newest request
//! first. A second thread computes the sample at work, so that it is seen at once however long the
//! others take.

use std::sync::{Arc, Weak};

use crate::diag::Diagnostic;
use crate::document::{Address, Grid, Hcbtf, Tile};
use crate::hcbtf::fill::{fill, refill, sample};
use crate::hcbtf::{Device, FilledSamples, NotFilled};
use crate::progress::Progress;
use crate::state::painting::work::OpenPainting;
use crate::state::revision::PaintingNumber;
use crate::state::worker::Worker;

struct FillRequest {
    hcbtf: Arc<Hcbtf>,
    number: PaintingNumber,
    progress: Progress,
}

struct FillResult {
    /// HCBTF that was filled.
    of: Arc<Hcbtf>,
    number: PaintingNumber,
    filled: Result<Arc<FilledSamples>, NotFilled>,
}

/// Result for one sample, ahead of the rest.
struct SampleResult {
    of: Arc<Hcbtf>,
    address: Address,
    tile: Option<Arc<Tile>>,
}

/// Threads that fill unpainted samples, and their requests.
pub(super) struct FillWorker {
    worker: Worker<FillRequest, FillResult>,
    ahead: Worker<(FillRequest, Address), SampleResult>,
    /// HCBTF of the last request.
    asked: Option<Arc<Hcbtf>>,
    /// HCBTF that was filled last.
    has: Option<Arc<Hcbtf>>,
    /// Sample that was requested last, ahead of the rest, and its HCBTF.
    asked_ahead: Option<(Arc<Hcbtf>, Address)>,
    progress: Progress,
    /// Progress of the sample ahead, which does not count in the progress of the others.
    progress_ahead: Progress,
    /// Reason why nothing could be filled.
    pub(super) problem: Option<Diagnostic>,
}

impl FillWorker {
    /// `wake` is called from another thread when samples are filled.
    pub(super) fn new(wake: impl Fn() + Clone + Send + 'static) -> Self {
        // A stroke changes little of the last result, so that the worker starts from it. The
        // reference is weak: the result lives as long as it is shown.
        let mut before: (Arc<Hcbtf>, Weak<FilledSamples>) =
            (Arc::new(Hcbtf::new(Grid::THESIS)), Weak::new());
        let work = move |request: FillRequest| {
            let filled = match before.1.upgrade() {
                Some(filled) => refill(&request.hcbtf, (&before.0, &filled), &request.progress),
                None => fill(&request.hcbtf, &request.progress),
            };
            let filled = filled.map(Arc::new);
            if let Ok(filled) = &filled {
                before = (request.hcbtf.clone(), Arc::downgrade(filled));
            }
            FillResult { of: request.hcbtf, number: request.number, filled }
        };
        let ahead = |(request, address): (FillRequest, Address)| {
            let tile = sample(&request.hcbtf, address, &request.progress).ok().flatten();
            SampleResult { of: request.hcbtf, address, tile }
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

    /// Takes filled samples, and requests those that are missing, where the device can hold them.
    /// Returns true if there are new ones.
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
            // Other rules make the filling under way useless; one more texel does not.
            let is_other =
                self.asked.as_ref().is_none_or(|asked| asked.rules != work.shown().rules);
            if is_other {
                self.stop();
            }
            self.asked = Some(work.shown().clone());
            self.progress = Progress::new();
            let request = fill_request(work, &self.progress);
            self.worker.request(|_| request);
        }
        self.ask_ahead(work);
        is_new
    }

    fn stop(&self) {
        self.progress.stop();
        self.progress_ahead.stop();
    }

    /// Requests the sample at work, while the others are not done.
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
        let request = (fill_request(work, &self.progress_ahead), at);
        self.ahead.request(|_| request);
    }

    fn take_ahead(&self, work: &mut OpenPainting) -> bool {
        let mut is_new = false;
        for SampleResult { of, address, tile } in self.ahead.answers() {
            // Once the others are there too, the sample is one of them.
            let is_late = self.has.as_ref().is_some_and(|has| Arc::ptr_eq(has, &of));
            if let Some(tile) = tile.filter(|_| Arc::ptr_eq(&of, work.shown()) && !is_late) {
                work.set_ahead(address, tile);
                is_new = true;
            }
        }
        is_new
    }

    /// Samples that the rules filled, if they are those of all that is shown now.
    pub(super) fn of(&self, work: &OpenPainting) -> Option<Arc<FilledSamples>> {
        let is_it = self.has.as_ref().is_some_and(|has| Arc::ptr_eq(has, work.shown()));
        work.filled().filter(|_| is_it).cloned()
    }

    /// Share that is filled, 0 to 1; `None` while nothing is being filled.
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

impl Drop for FillWorker {
    fn drop(&mut self) {
        self.stop();
    }
}

fn fill_request(work: &OpenPainting, progress: &Progress) -> FillRequest {
    FillRequest { hcbtf: work.shown().clone(), number: work.number(), progress: progress.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Directions, HcbtfEdit, History, Rule, Strokes};
    use crate::state::revision::StepTime;

    #[test]
    fn the_sample_at_work_is_there_before_all_others_are() {
        let directions = Directions { theta: 3, phi: 4 };
        let grid = Grid { size: [12, 12], light: directions, view: directions };
        let rules = vec![Rule::Strokes(Box::new(Strokes::preset("Grass")))];
        let mut work =
            OpenPainting::of_history(History::new(Hcbtf { rules, ..Hcbtf::new(grid) }), None);
        let mut filling = FillWorker::new(|| {});
        let at = Address::new([1, 2], [2, 3]);
        work.go_to(at);
        let alone = |work: &OpenPainting| sample(work.hcbtf(), at, &Progress::new()).unwrap();
        assert!(!filling.tick(&mut work, &Device::guaranteed()));
        // The result ahead is only taken, and the others are not, whether they are done or not.
        filling.ahead.wait();
        assert!(filling.take_ahead(&mut work) && work.filled().is_none());
        assert!(work.tile(at).is_some());
        assert_eq!(work.tile(at).cloned(), alone(&work));
        assert_eq!(work.tile(Address::new([0, 0], [1, 0])), None);
        filling.wait();
        assert!(filling.tick(&mut work, &Device::guaranteed()));
        assert_eq!(work.tile(at).cloned(), alone(&work));
        assert_eq!(work.tile(at), work.filled().and_then(|filled| filled.tile(at)));
        // Once all samples are there, moving to another sample requests nothing more.
        work.go_to(Address::default());
        assert!(!filling.tick(&mut work, &Device::guaranteed()) && !filling.is_busy());
        // The effect of another rule is seen at once as well.
        let before = work.tile(Address::default()).cloned();
        let rule = Rule::Strokes(Box::new(Strokes::preset("Pencil")));
        work.apply(HcbtfEdit::SetRule { index: 0, rule }, None, StepTime::default()).unwrap();
        filling.tick(&mut work, &Device::guaranteed());
        filling.ahead.wait();
        assert!(filling.take_ahead(&mut work));
        assert_ne!(work.tile(Address::default()).cloned(), before);
        filling.wait();
    }
}
