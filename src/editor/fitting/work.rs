//! The fit itself, on a thread.

use std::sync::Arc;

use crate::diag::Diagnostic;
use crate::document::Look;
use crate::fit::{FitOptions, FitResult, Target, fit_layers, fit_look};
use crate::frame::Assets;
use crate::progress::Progress;
use crate::still::Still;
use crate::worker::Worker;

/// What is fitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum What {
    /// What the open look has: its nodes and wires stay.
    ThisLook,
    /// Up to so many layers from nothing, in place of the look's nodes.
    Layers(usize),
}

/// A fit that is asked for.
pub(super) struct Job {
    pub(super) what: What,
    pub(super) still: Still,
    pub(super) target: Target,
    pub(super) options: FitOptions,
    pub(super) progress: Progress,
}

/// What became of it.
pub(super) struct Done {
    pub(super) what: What,
    pub(super) look: Arc<Look>,
    pub(super) progress: Progress,
    pub(super) result: Result<FitResult, Vec<Diagnostic>>,
}

/// A thread that fits.
pub(super) fn start(wake: impl Fn() + Send + 'static) -> Worker<Job, Done> {
    let mut assets = Assets::default();
    Worker::new("fit", wake, move |job: Job| {
        let result = fit(&mut assets, &job);
        Done { what: job.what, look: job.still.look, progress: job.progress, result }
    })
}

fn fit(assets: &mut Assets, job: &Job) -> Result<FitResult, Vec<Diagnostic>> {
    let Job { what, still, target, options, progress, .. } = job;
    let setup = still.setup(assets)?.value;
    // The open look is the first.
    match what {
        What::ThisLook => fit_look(&setup, 0, &still.library, target, options, progress),
        What::Layers(count) => {
            fit_layers(&setup, 0, &still.library, target, *count, options, progress)
        }
    }
}
