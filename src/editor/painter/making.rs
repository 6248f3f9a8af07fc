//! HCBTFs made from other sources, on a thread of their own: from pictures, from a painted tile,
//! from a look. The progress is shown, and the work can be stopped.

use std::path::PathBuf;
use std::sync::Arc;

use chiaro_locale::{tr, trn};
use eframe::egui::{Id, Modal, ProgressBar, RichText, Ui};

use crate::clock::Clock;
use crate::commands::PictureImport;
use crate::diag::{Diagnostic, WithWarnings};
use crate::document::{Address, Grid, Hcbtf, Tile};
use crate::files::write_atomic;
use crate::frame::{AssetStore, Assets, Overlay, SetupLook, tile_assets};
use crate::hcbtf::fill::{fill, sample};
use crate::hcbtf::{FilledSamples, Synthesis, synthesize_filled, write};
use crate::ids::LightId;
use crate::library::Library;
use crate::progress::Progress;
use crate::reference::bake_look;
use crate::state::revision::RequestNumber;
use crate::state::worker::Worker;
use crate::widgets::theme;

/// Interval at which the window is redrawn while an HCBTF is made, in seconds.
const AGAIN: f32 = 0.1;

/// Request to make an HCBTF.
pub(super) enum MakeRequest {
    Import {
        import: PictureImport,
        from: PathBuf,
    },
    /// Synthesis of a tile from patches of another; `filled` are the samples that its rules filled,
    /// where known. The sample `at` is also computed as it will look.
    Synthesize {
        hcbtf: Arc<Hcbtf>,
        filled: Option<Arc<FilledSamples>>,
        how: Synthesis,
        at: Address,
    },
    Bake(Box<Bake>),
}

/// Request to bake a look onto a tile, into a file.
pub(super) struct Bake {
    pub(super) setup: SetupLook,
    pub(super) library: Arc<Library>,
    pub(super) painting: Option<Overlay>,
    /// Assets that all pictures of the window share.
    pub(super) assets: AssetStore,
    pub(super) grid: Grid,
    pub(super) light: LightId,
    pub(super) to: PathBuf,
}

/// New tile, and one sample of it as it will look.
pub(crate) type SynthesizedTile = (Arc<Hcbtf>, Option<Arc<Tile>>);

/// Result of a request.
pub(crate) enum MadePainting {
    Imported {
        from: PathBuf,
        made: Result<WithWarnings<Hcbtf>, Vec<Diagnostic>>,
    },
    /// Synthesized tile.
    Tile {
        made: Result<SynthesizedTile, Diagnostic>,
    },
    /// Baked file, with the number of its samples.
    Baked {
        to: PathBuf,
        made: Result<usize, Vec<Diagnostic>>,
    },
}

/// Progress of the two steps: of preparing the sources, then of making the HCBTF.
type StepProgress = [Progress; 2];

struct Task {
    job: MakeRequest,
    steps: StepProgress,
    number: RequestNumber,
}

/// Work under way.
struct MakeProgress {
    title: String,
    steps: StepProgress,
    /// True if the window waits for the result, behind a dialog.
    is_waited_for: bool,
    since: Clock,
}

/// Thread that makes HCBTFs, and its work under way.
pub(super) struct HcbtfWorker {
    worker: Worker<Task, (RequestNumber, MadePainting)>,
    number: RequestNumber,
    going: Option<MakeProgress>,
}

impl HcbtfWorker {
    /// `wake` is called from another thread when an HCBTF is made.
    pub(super) fn new(wake: impl Fn() + Send + 'static) -> Self {
        let work = |task: Task| (task.number, task.job.done(&task.steps));
        Self {
            worker: Worker::new("making a painted surface", wake, work),
            number: RequestNumber::default(),
            going: None,
        }
    }

    /// Begins a job, in place of the one under way.
    pub(super) fn begin(&mut self, job: MakeRequest) {
        self.stop();
        let number = self.number.advance();
        let steps = StepProgress::default();
        let is_waited_for = !matches!(job, MakeRequest::Synthesize { .. });
        self.going = Some(MakeProgress {
            title: job.title(),
            steps: steps.clone(),
            is_waited_for,
            since: Clock::start(),
        });
        let task = Task { job, steps, number };
        self.worker.request(|_| task);
    }

    /// Gives up the work under way; its result is dropped.
    pub(super) fn stop(&mut self) {
        if let Some(going) = self.going.take() {
            going.steps.iter().for_each(Progress::stop);
        }
    }

    /// Result of the last job, if the job was not given up.
    pub(super) fn made(&mut self) -> Option<MadePainting> {
        let (_, made) =
            self.worker.answers().into_iter().find(|(number, _)| *number == self.number)?;
        self.going.take().map(|_| made)
    }

    /// Share that is done, 0 to 1; `None` while no job is under way.
    pub(super) fn share(&self) -> Option<f64> {
        self.going.as_ref().map(|going| step(&going.steps).1)
    }

    /// Shows the job that the window waits for, in a dialog in front of everything else.
    pub(super) fn show(&mut self, ui: &Ui) {
        let Some(MakeProgress { title, steps, is_waited_for: true, since }) = &self.going else {
            return;
        };
        let (what, share) = step(steps);
        let left = left(share, since.seconds());
        let modal = Modal::new(Id::unique("making")).show(ui.ctx(), |ui| {
            ui.set_width(360.0);
            ui.label(RichText::new(title).heading());
            ui.add_space(6.0);
            bar(ui, share);
            ui.label(RichText::new(format!("{what}{left}")).color(theme::of(ui).dim));
            ui.add_space(8.0);
            ui.button(tr!("Stop"))
                .on_hover_text(tr!("Gives it up: nothing is changed (Esc)"))
                .clicked()
        });
        if modal.inner || modal.should_close() {
            self.stop();
        }
    }

    pub(super) fn is_busy(&self) -> bool {
        self.worker.is_busy()
    }

    pub(super) fn wait(&self) {
        self.worker.wait();
    }
}

impl Drop for HcbtfWorker {
    fn drop(&mut self) {
        self.stop();
    }
}

/// Shows a progress bar, and redraws it soon.
pub(super) fn bar(ui: &mut Ui, share: f64) {
    ui.add(ProgressBar::new(share as f32).show_percentage());
    ui.ctx().request_repaint_after_secs(AGAIN);
}

/// Text on the time that is left, from the share that is done and the seconds since the start;
/// empty at the start, while no estimate is good.
fn left(share: f64, seconds: f64) -> String {
    match share > 0.02 && seconds > 2.0 {
        true => tr!(": about {time} left", time = told_seconds(seconds * (1.0 - share) / share)),
        false => String::new(),
    }
}

/// Duration for people, in one unit.
pub(super) fn told_seconds(seconds: f64) -> String {
    let whole = |of: f64| (seconds / of).round() as usize;
    match seconds {
        _ if seconds < 1.0 => tr!("a second").to_owned(),
        _ if seconds < 99.5 => trn!(n = whole(1.0), "{n} second", "{n} seconds"),
        _ if seconds < 5970.0 => trn!(n = whole(60.0), "{n} minute", "{n} minutes"),
        _ => trn!(n = whole(3600.0), "{n} hour", "{n} hours"),
    }
}

/// Name of the step under way, and the share of it that is done.
fn step([ready, made]: &StepProgress) -> (&'static str, f64) {
    match made.steps() {
        [_, 0] => (tr!("Making ready what it is made of"), ready.share()),
        _ => (tr!("Making it"), made.share()),
    }
}

impl MakeRequest {
    fn title(&self) -> String {
        let name =
            |path: &PathBuf| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        match self {
            Self::Import { from, .. } => tr!("Importing {file}", file = name(from)),
            Self::Synthesize { .. } => tr!("Laying patches").to_owned(),
            Self::Bake(bake) => tr!("Baking {file}", file = name(&bake.to)),
        }
    }

    fn done(self, steps: &StepProgress) -> MadePainting {
        match self {
            Self::Import { import, from } => {
                MadePainting::Imported { made: import.read(&from, &steps[1]), from }
            }
            Self::Synthesize { hcbtf, filled, how, at } => {
                MadePainting::Tile { made: tile(&hcbtf, filled, &how, at, steps) }
            }
            Self::Bake(bake) => MadePainting::Baked { made: bake.done(steps), to: bake.to },
        }
    }
}

fn tile(
    hcbtf: &Hcbtf,
    filled: Option<Arc<FilledSamples>>,
    how: &Synthesis,
    at: Address,
    [ready, made]: &StepProgress,
) -> Result<SynthesizedTile, Diagnostic> {
    let filled = filled.map_or_else(|| fill(hcbtf, ready).map(Arc::new), Ok)?;
    let made = synthesize_filled(hcbtf, &filled, how, made)?;
    let seen = sample(&made, at, ready)?;
    Ok((Arc::new(made), seen))
}

impl Bake {
    fn done(&self, [ready, made]: &StepProgress) -> Result<usize, Vec<Diagnostic>> {
        let Self { setup, library, painting, assets, grid, light, to } = self;
        let mut assets = Assets::of(assets);
        assets.overlay(painting.clone());
        let assets = tile_assets(setup, library, light, assets, ready)?;
        let hcbtf = bake_look(setup, library, *grid, light, &assets, made)?;
        let bytes = write(&hcbtf).map_err(|problem| vec![*problem])?;
        write_atomic(to, &bytes).map_err(|problem| vec![*problem])?;
        Ok(hcbtf.painted.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_told_in_one_unit() {
        let said = [0.2, 1.4, 61.0, 100.0, 3600.0, 7300.0].map(told_seconds);
        assert_eq!(
            said,
            ["a second", "1 second", "61 seconds", "2 minutes", "60 minutes", "2 hours"]
        );
        assert_eq!(left(0.25, 30.0), ": about 90 seconds left");
        assert_eq!(left(0.0, 30.0), "");
    }

    #[test]
    fn what_was_given_up_never_comes_and_the_next_one_does() {
        let mut making = HcbtfWorker::new(|| {});
        let import =
            || MakeRequest::Import { import: PictureImport::default(), from: "nowhere".into() };
        making.begin(import());
        making.wait();
        making.stop();
        assert!(making.made().is_none() && making.share().is_none());
        making.begin(import());
        making.begin(import());
        making.wait();
        assert!(matches!(making.made(), Some(MadePainting::Imported { made: Err(_), .. })));
        assert!(making.made().is_none());
    }
}
