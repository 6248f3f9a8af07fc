//! What is painted leaves for other programs, filled by its rules: on a thread of its own, since it may be thousands of
//! images.

use std::path::PathBuf;
use std::sync::Arc;

use crate::diag::Diagnostic;
use crate::document::{Hcbtf, Storage};
use crate::editor::worker::Worker;
use crate::hcbtf::Progress;
use crate::hcbtf::exchange::{self, Form};
use crate::hcbtf::fill::fill;

/// An HCBTF as it was when it was asked for.
struct Job {
    hcbtf: Arc<Hcbtf>,
    form: Form,
    storage: Storage,
    to: PathBuf,
    progress: Arc<Progress>,
}

/// The thread that does it.
pub(super) struct Exports {
    worker: Worker<Vec<Job>, Vec<String>>,
    progress: Arc<Progress>,
}

impl Exports {
    /// `wake` is called from another thread when something is written.
    pub(super) fn new(wake: impl Fn() + Send + 'static) -> Self {
        let work = |jobs: Vec<Job>| jobs.iter().map(run).collect();
        Self { worker: Worker::new("export painting", wake, work), progress: Arc::default() }
    }

    /// Writes all samples in a form; a texture as it is to be stored.
    pub(super) fn write(&self, hcbtf: Arc<Hcbtf>, form: Form, storage: Storage, to: PathBuf) {
        let job = Job { hcbtf, form, storage, to, progress: self.progress.clone() };
        // Nothing that waits is dropped.
        self.worker.request(|waiting| waiting.unwrap_or_default().into_iter().chain([job]).collect());
    }

    /// What to tell of what was written since the last call.
    pub(super) fn told(&self) -> Option<String> {
        self.worker.answers().into_iter().flatten().last()
    }

    pub(super) fn is_busy(&self) -> bool {
        self.worker.is_busy()
    }

    pub(super) fn wait(&self) {
        self.worker.wait();
    }
}

impl Drop for Exports {
    fn drop(&mut self) {
        self.progress.stop();
    }
}

fn run(job: &Job) -> String {
    let filled = fill(&job.hcbtf, &job.progress).map_err(|why| vec![Diagnostic::from(why)]);
    let manner = exchange::Manner { storage: job.storage, ..exchange::Manner::default() };
    let written = filled.and_then(|filled| exchange::export(&filled, job.form, manner, &job.to, &job.progress));
    match written {
        Ok(more) => {
            let more = more.map(|more| format!(": {more}")).unwrap_or_default();
            format!("Exported {}{more}", job.to.display())
        }
        Err(problems) => {
            let why = problems.first().map(|problem| problem.message.as_str()).unwrap_or_default();
            format!("{} was not exported: {why}", job.to.display())
        }
    }
}
