//! HCBTFs that are made of other things, on a thread of their own: of pictures, of a painted tile,
//! of a look. How far that is is told, and it can be stopped.

use std::path::PathBuf;
use std::sync::Arc;

use eframe::egui::{Id, Modal, ProgressBar, RichText, Ui};

use super::counted;
use crate::clock::Clock;
use crate::commands::PictureImport;
use crate::diag::Diagnostic;
use crate::document::{Address, Grid, Hcbtf, Tile};
use crate::files::write_atomic;
use crate::frame::{Assets, Overlay, SetupLook, tile_assets};
use crate::hcbtf::fill::{fill, sample};
use crate::hcbtf::{Filled, Synthesis, synthesize_filled, write};
use crate::ids::LightId;
use crate::library::Library;
use crate::progress::Progress;
use crate::reference::bake_look;
use crate::state::worker::Worker;
use crate::widgets::theme;

/// While something is made the window looks again after so many seconds.
const AGAIN: f32 = 0.1;

/// What is asked for.
pub(super) enum MakeRequest {
    Import {
        import: PictureImport,
        from: PathBuf,
    },
    /// A tile of patches of another; `filled` is what its rules made, where that is known. Also the
    /// sample `at` as it will look.
    Synthesize {
        hcbtf: Arc<Hcbtf>,
        filled: Option<Arc<Filled>>,
        how: Synthesis,
        at: Address,
    },
    Bake(Box<Bake>),
}

/// A look that is baked onto a tile, into a file.
pub(super) struct Bake {
    pub(super) setup: SetupLook,
    pub(super) library: Arc<Library>,
    pub(super) painting: Option<Overlay>,
    pub(super) grid: Grid,
    pub(super) light: LightId,
    pub(super) to: PathBuf,
}

/// A new tile, and one sample of it as it will look.
pub(crate) type SynthesizedTile = (Arc<Hcbtf>, Option<Arc<Tile>>);

/// What came of it.
pub(crate) enum MadePainting {
    Imported {
        from: PathBuf,
        made: Result<(Hcbtf, Vec<Diagnostic>), Vec<Diagnostic>>,
    },
    /// Another tile.
    Tile {
        made: Result<SynthesizedTile, Diagnostic>,
    },
    /// The file has so many samples.
    Baked {
        to: PathBuf,
        made: Result<usize, Vec<Diagnostic>>,
    },
}

/// How far it is: what is made ready, then what is made of it.
type Stages = [Progress; 2];

struct Task {
    job: MakeRequest,
    stages: Stages,
    number: u64,
}

/// What is being made.
struct MakeProgress {
    title: String,
    stages: Stages,
    /// Whether the window waits for it.
    is_waited_for: bool,
    since: Clock,
}

/// The thread, and what it is at.
pub(super) struct Making {
    worker: Worker<Task, (u64, MadePainting)>,
    number: u64,
    going: Option<MakeProgress>,
}

impl Making {
    /// `wake` is called from another thread when something is made.
    pub(super) fn new(wake: impl Fn() + Send + 'static) -> Self {
        let work = |task: Task| (task.number, task.job.done(&task.stages));
        Self { worker: Worker::new("making an HCBTF", wake, work), number: 0, going: None }
    }

    /// Begins, in place of what is being made.
    pub(super) fn begin(&mut self, job: MakeRequest) {
        self.stop();
        self.number += 1;
        let stages = Stages::default();
        let is_waited_for = !matches!(job, MakeRequest::Synthesize { .. });
        self.going = Some(MakeProgress {
            title: job.title(),
            stages: stages.clone(),
            is_waited_for,
            since: Clock::start(),
        });
        let task = Task { job, stages, number: self.number };
        self.worker.request(|_| task);
    }

    /// Gives up what is being made: nothing comes of it.
    pub(super) fn stop(&mut self) {
        if let Some(going) = self.going.take() {
            going.stages.iter().for_each(Progress::stop);
        }
    }

    /// What was made since the last call, if nobody has given it up.
    pub(super) fn made(&mut self) -> Option<MadePainting> {
        let (_, made) =
            self.worker.answers().into_iter().find(|(number, _)| *number == self.number)?;
        self.going.take().map(|_| made)
    }

    /// The share that is done, while something is made.
    pub(super) fn share(&self) -> Option<f64> {
        self.going.as_ref().map(|going| stage(&going.stages).1)
    }

    /// Shows what the window waits for, in front of everything else.
    pub(super) fn show(&mut self, ui: &Ui) {
        let Some(MakeProgress { title, stages, is_waited_for: true, since }) = &self.going else {
            return;
        };
        let (what, share) = stage(stages);
        let left = left(share, since.seconds());
        let modal = Modal::new(Id::unique("making")).show(ui.ctx(), |ui| {
            ui.set_width(360.0);
            ui.label(RichText::new(title).heading());
            ui.add_space(6.0);
            bar(ui, share);
            ui.label(RichText::new(format!("{what}{left}")).color(theme::of(ui).dim));
            ui.add_space(8.0);
            ui.button("Stop").on_hover_text("Gives it up: nothing is changed (Esc)").clicked()
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

impl Drop for Making {
    fn drop(&mut self) {
        self.stop();
    }
}

/// Shows a share, and looks again soon.
pub(super) fn bar(ui: &mut Ui, share: f64) {
    ui.add(ProgressBar::new(share as f32).show_percentage());
    ui.ctx().request_repaint_after_secs(AGAIN);
}

/// What is told of the time that is left, once so much is done after so many seconds.
fn left(share: f64, seconds: f64) -> String {
    match share > 0.02 && seconds > 2.0 {
        true => format!(": about {} left", told_seconds(seconds * (1.0 - share) / share)),
        false => String::new(),
    }
}

/// A time for people, in one unit.
pub(super) fn told_seconds(seconds: f64) -> String {
    match seconds {
        _ if seconds < 1.0 => "a second".to_owned(),
        _ if seconds < 99.5 => counted(seconds.round() as usize, "second"),
        _ if seconds < 5970.0 => counted((seconds / 60.0).round() as usize, "minute"),
        _ => counted((seconds / 3600.0).round() as usize, "hour"),
    }
}

/// What is being done, and the share of it.
fn stage([ready, made]: &Stages) -> (&'static str, f64) {
    match made.steps() {
        [_, 0] => ("Making ready what it is made of", ready.share()),
        _ => ("Making it", made.share()),
    }
}

impl MakeRequest {
    fn title(&self) -> String {
        let name =
            |path: &PathBuf| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        match self {
            Self::Import { from, .. } => format!("Importing {}", name(from)),
            Self::Synthesize { .. } => "Laying patches".to_owned(),
            Self::Bake(bake) => format!("Baking {}", name(&bake.to)),
        }
    }

    fn done(self, stages: &Stages) -> MadePainting {
        match self {
            Self::Import { import, from } => {
                MadePainting::Imported { made: import.read(&from, &stages[1]), from }
            }
            Self::Synthesize { hcbtf, filled, how, at } => {
                MadePainting::Tile { made: tile(&hcbtf, filled, &how, at, stages) }
            }
            Self::Bake(bake) => MadePainting::Baked { made: bake.done(stages), to: bake.to },
        }
    }
}

fn tile(
    hcbtf: &Hcbtf,
    filled: Option<Arc<Filled>>,
    how: &Synthesis,
    at: Address,
    [ready, made]: &Stages,
) -> Result<SynthesizedTile, Diagnostic> {
    let filled = filled.map_or_else(|| fill(hcbtf, ready).map(Arc::new), Ok)?;
    let made = synthesize_filled(hcbtf, &filled, how, made)?;
    let seen = sample(&made, at, ready)?;
    Ok((Arc::new(made), seen))
}

impl Bake {
    fn done(&self, [ready, made]: &Stages) -> Result<usize, Vec<Diagnostic>> {
        let Self { setup, library, painting, grid, light, to } = self;
        let mut assets = Assets::default();
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
        let mut making = Making::new(|| {});
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
