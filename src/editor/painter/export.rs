//! Export of the painted samples, filled by their rules, to other programs: on a thread of its own,
//! since there may be thousands of images.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::tr;

use crate::diag::Diagnostic;
use crate::document::{Hcbtf, Storage};
use crate::hcbtf::exchange::{self, ExchangeFormat};
use crate::hcbtf::fill::fill;
use crate::progress::Progress;
use crate::state::worker::Worker;

/// Request to export an HCBTF in its state at the time.
struct ExportRequest {
    hcbtf: Arc<Hcbtf>,
    form: ExchangeFormat,
    storage: Storage,
    to: PathBuf,
    progress: Progress,
}

/// Thread that exports.
pub(super) struct Exports {
    worker: Worker<Vec<ExportRequest>, Vec<String>>,
    progress: Progress,
}

impl Exports {
    /// `wake` is called from another thread when an export is written.
    pub(super) fn new(wake: impl Fn() + Send + 'static) -> Self {
        let work = |jobs: Vec<ExportRequest>| jobs.iter().map(run).collect();
        Self { worker: Worker::new("export painting", wake, work), progress: Progress::new() }
    }

    /// Writes all samples in a form; `storage` applies to a texture.
    pub(super) fn write(
        &self,
        hcbtf: Arc<Hcbtf>,
        form: ExchangeFormat,
        storage: Storage,
        to: PathBuf,
    ) {
        let job = ExportRequest { hcbtf, form, storage, to, progress: self.progress.clone() };
        // Requests that wait are kept, none is dropped.
        self.worker
            .request(|waiting| waiting.unwrap_or_default().into_iter().chain([job]).collect());
    }

    /// Message about the exports that were written since the last call.
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

fn run(job: &ExportRequest) -> String {
    let to = free(job.form, &job.to);
    let filled = fill(&job.hcbtf, &job.progress).map_err(|why| vec![Diagnostic::from(why)]);
    let options =
        exchange::ExportOptions { storage: job.storage, ..exchange::ExportOptions::default() };
    let written =
        filled.and_then(|filled| exchange::export(&filled, job.form, options, &to, &job.progress));
    match written {
        Ok(more) => {
            let file = to.display();
            match more {
                Some(more) => tr!("Exported {file}: {more}"),
                None => tr!("Exported {file}"),
            }
        }
        Err(problems) => {
            let why = problems.first().map(|problem| problem.message.as_str()).unwrap_or_default();
            tr!("{file} was not exported: {why}", file = to.display())
        }
    }
}

/// Place for an export. Images of an earlier export in the folder may have been painted on since,
/// so that the next export goes into a subfolder. Overwriting a file was confirmed in the file
/// dialog.
fn free(form: ExchangeFormat, to: &Path) -> PathBuf {
    if form != ExchangeFormat::Folder || exchange::in_the_way(form, to).is_empty() {
        return to.to_owned();
    }
    let mut within = (2..1000).map(|number| to.join(format!("export-{number}")));
    within.find(|folder| !folder.exists()).unwrap_or_else(|| to.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Address;
    use crate::hcbtf::folder::file_name;

    #[test]
    fn what_was_exported_before_stays() {
        let to = tempfile::tempdir().unwrap();
        let image = file_name(Address::default());
        assert_eq!(free(ExchangeFormat::Folder, to.path()), to.path());
        std::fs::write(to.path().join(&image), "painted on since").unwrap();
        let next = free(ExchangeFormat::Folder, to.path());
        assert_eq!(next, to.path().join("export-2"));
        std::fs::create_dir(&next).unwrap();
        assert_eq!(free(ExchangeFormat::Folder, to.path()), to.path().join("export-3"));
        // The file dialog confirms the overwriting of files.
        assert_eq!(free(ExchangeFormat::Sheet, &to.path().join(&image)), to.path().join(&image));
    }
}
