//! What the rules make of the samples that nobody painted: worked out on a thread of its own, the newest wish first.

use std::sync::Arc;

use super::work::Work;
use crate::diag::Diagnostic;
use crate::document::Hcbtf;
use crate::editor::worker::Worker;
use crate::hcbtf::fill::fill;
use crate::hcbtf::{Filled, NotFilled, Progress};

struct Wish {
    hcbtf: Arc<Hcbtf>,
    number: u64,
    progress: Arc<Progress>,
}

struct Done {
    number: u64,
    filled: Result<Arc<Filled>, NotFilled>,
}

/// Fills what is not painted.
pub(super) struct Filling {
    worker: Worker<Wish, Done>,
    /// What was asked for last.
    asked: Option<Arc<Hcbtf>>,
    progress: Arc<Progress>,
    /// Why nothing could be filled.
    pub(super) problem: Option<Diagnostic>,
}

impl Filling {
    /// `wake` is called from another thread when something is filled.
    pub(super) fn new(wake: impl Fn() + Send + 'static) -> Self {
        let work = |wish: Wish| Done { number: wish.number, filled: fill(&wish.hcbtf, &wish.progress).map(Arc::new) };
        Self { worker: Worker::new("filling", wake, work), asked: None, progress: Arc::default(), problem: None }
    }

    /// Takes what was filled, and asks for what is not yet. Returns whether there is something new.
    pub(super) fn tick(&mut self, work: &mut Work) -> bool {
        let mut is_new = false;
        let number = work.number();
        for done in self.worker.answers().into_iter().filter(|done| done.number == number) {
            match done.filled {
                Ok(filled) => {
                    work.set_filled(filled);
                    (is_new, self.problem) = (true, None);
                }
                Err(NotFilled::Stopped) => {}
                Err(why) => self.problem = Some(why.into()),
            }
        }
        if !work.rules_wait() && !self.asked.as_ref().is_some_and(|asked| Arc::ptr_eq(asked, work.shown())) {
            // Other rules make what is being filled useless; one more texel does not.
            let is_other = self.asked.as_ref().is_none_or(|asked| asked.rules != work.shown().rules);
            if is_other {
                self.progress.stop();
            }
            self.asked = Some(work.shown().clone());
            self.progress = Arc::default();
            let wish = Wish { hcbtf: work.shown().clone(), number: work.number(), progress: self.progress.clone() };
            self.worker.request(|_| wish);
        }
        is_new
    }

    /// The share that is filled, while that goes on.
    pub(super) fn share(&self) -> Option<f64> {
        self.worker.is_busy().then(|| self.progress.share())
    }

    pub(super) fn is_busy(&self) -> bool {
        self.worker.is_busy()
    }

    pub(super) fn wait(&self) {
        self.worker.wait();
    }
}

impl Drop for Filling {
    fn drop(&mut self) {
        self.progress.stop();
    }
}
