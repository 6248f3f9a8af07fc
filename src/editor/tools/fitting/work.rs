//! The fit itself, on a thread.

use std::sync::Arc;

use crate::commands::FitGoal;
use crate::diag::Diagnostic;
use crate::document::Look;
use crate::fit::{FitOptions, FitTarget, FittedLook, fit_layers, fit_local, fit_look};
use crate::frame::Assets;
use crate::progress::Progress;
use crate::state::snapshot::RenderSnapshot;
use crate::state::worker::Worker;

/// Request for a fit.
pub(super) struct FitRequest {
    pub(super) what: FitGoal,
    pub(super) snapshot: RenderSnapshot,
    pub(super) target: FitTarget,
    pub(super) options: FitOptions,
    pub(super) progress: Progress,
}

/// Result of a fit.
pub(super) struct FitResult {
    pub(super) what: FitGoal,
    pub(super) look: Arc<Look>,
    pub(super) progress: Progress,
    pub(super) result: Result<FittedLook, Vec<Diagnostic>>,
}

/// Starts the thread that fits.
pub(super) fn start(wake: impl Fn() + Send + 'static) -> Worker<FitRequest, FitResult> {
    let mut assets = Assets::default();
    Worker::new("fit", wake, move |job: FitRequest| {
        let result = fit(&mut assets, &job);
        FitResult { what: job.what, look: job.snapshot.look, progress: job.progress, result }
    })
}

fn fit(assets: &mut Assets, job: &FitRequest) -> Result<FittedLook, Vec<Diagnostic>> {
    let FitRequest { what, snapshot, target, options, progress, .. } = job;
    let setup = snapshot.setup(assets)?.value;
    // The open look is the first of the setup.
    match what {
        FitGoal::Local => fit_local(&setup, 0, &snapshot.library, target, options, progress),
        FitGoal::ThisLook => fit_look(&setup, 0, &snapshot.library, target, options, progress),
        FitGoal::Layers(count) => {
            fit_layers(&setup, 0, &snapshot.library, target, *count, options, progress)
        }
    }
}
