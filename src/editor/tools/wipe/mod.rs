//! Comparison of the picture with another of the same moment: the look in another tier, or the
//! truth in f64. A divider wipes between both; or their difference is shown, magnified.
//!
//! Both pictures are made in the background with one sample a pixel, so that they can be compared,
//! and are dropped once anything changes. A tier is then compared again by itself; the truth, which
//! takes long, only on request.

mod compare;
pub(crate) mod divider;
mod show;

use std::sync::Arc;

use eframe::egui;
use eframe::egui::{TextureHandle, Ui};

use crate::accuracy::ErrorFigures;
use crate::diag::Diagnostic;
use crate::document::Tier;
use crate::progress::{Interruption, Progress};
use crate::render::Gpu;
use crate::state::session::Session;
use crate::state::snapshot::{RenderSnapshot, Stamp};
use crate::state::worker::{BackgroundJobs, Worker};
use crate::tools::fitting::FitTool;
use crate::tools::probe::picture_size;
use crate::tools::{PictureContext, SwitchPlace, ToolRow};
use compare::Comparer;

pub(super) const TOOL: ToolRow = ToolRow::new(
    SwitchPlace::Bar,
    |parts| Box::new(Wipe::new(parts.gpu.clone(), parts.wake())),
    |tools| tools.of::<Wipe>().against.is_some(),
    |tools, ui, out| {
        // Pictures beside the viewport's would be in the way of strokes.
        if !tools.of::<FitTool>().is_on() {
            show::choice(tools, ui, out);
        }
    },
)
.with_bar(|tools, ui, session| tools.of_mut::<Wipe>().bar(ui, session))
.with_overlay(|tools, ui, PictureContext { session, rect, .. }, _| {
    let wipe = tools.of_mut::<Wipe>();
    wipe.update(ui, session, picture_size(*rect, ui.pixels_per_point()));
    wipe.over(ui, *rect);
})
.with_jobs(|tools| tools.of::<Wipe>());

/// Time of rest after which a tier is compared again, in seconds.
const REST: f64 = 0.2;

/// Factors by which a difference may be magnified.
pub(crate) const GAINS: [u32; 3] = [16, 64, 256];

/// Picture that the viewport's is compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ComparisonTarget {
    Tier(Tier),
    Truth,
}

impl ComparisonTarget {
    pub(crate) const ALL: [Self; 4] =
        [Self::Truth, Self::Tier(Tier::Exact), Self::Tier(Tier::Balanced), Self::Tier(Tier::Fast)];

    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Truth => "Truth (f64)",
            Self::Tier(Tier::Exact) => "Exact",
            Self::Tier(Tier::Balanced) => "Balanced",
            Self::Tier(Tier::Fast) => "Fast",
        }
    }
}

/// Inputs of a comparison: for the same inputs the known result is used.
#[derive(Clone, Debug, PartialEq)]
struct ComparisonInputs {
    stamp: Stamp,
    size: [u32; 2],
    against: ComparisonTarget,
}

struct ComparisonRequest {
    moment: ComparisonInputs,
    snapshot: RenderSnapshot,
    progress: Progress,
}

struct ComparisonResult {
    moment: ComparisonInputs,
    result: Result<PictureComparison, Vec<Diagnostic>>,
}

/// Two pictures and their difference.
struct PictureComparison {
    /// The look's picture, and the one that it is compared with.
    pictures: [egui::ColorImage; 2],
    /// Difference of each channel, red, green and blue; 0 on edges, where coverage may differ.
    difference: Vec<[f32; 3]>,
    figures: ErrorFigures,
}

/// Comparison on the screen.
struct ComparisonView {
    moment: ComparisonInputs,
    compared: PictureComparison,
    textures: [TextureHandle; 2],
    /// Texture of the difference, with the factor that it is magnified by.
    magnified: Option<(u32, TextureHandle)>,
}

/// Comparison of pictures, with the last result.
pub struct Wipe {
    worker: Option<Worker<ComparisonRequest, ComparisonResult>>,
    against: Option<ComparisonTarget>,
    /// Factor that the difference is magnified by; `None` while the divider is shown.
    gain: Option<u32>,
    /// Position of the divider, as a part of the width.
    split: f32,
    seen: Option<ComparisonInputs>,
    seen_at: f64,
    asked: Option<ComparisonInputs>,
    progress: Progress,
    /// Called from another thread when there is more progress to show.
    wake: Arc<dyn Fn() + Send + Sync>,
    shown: Option<ComparisonView>,
    problems: Vec<Diagnostic>,
}

impl Wipe {
    /// Creates a comparison that is off. `wake` is called from another thread when there is a
    /// result or progress. Without a GPU nothing can be compared.
    pub(crate) fn new(gpu: Option<Gpu>, wake: impl Fn() + Clone + Send + Sync + 'static) -> Self {
        let start = |gpu: Gpu| {
            let mut comparer = Comparer::new(gpu);
            Worker::waiting("compare", wake.clone(), async move |job| comparer.run(job).await)
        };
        Self {
            worker: gpu.map(start),
            against: None,
            gain: None,
            split: 0.5,
            seen: None,
            seen_at: 0.0,
            asked: None,
            progress: Progress::new(),
            wake: Arc::new(wake),
            shown: None,
            problems: Vec::new(),
        }
    }

    /// Error figures of the comparison, if known for what is shown now.
    pub fn figures(&self) -> Option<&ErrorFigures> {
        self.current().map(|shown| &shown.compared.figures)
    }

    /// Position of the divider, as a part of the width.
    pub fn split(&self) -> f32 {
        self.split
    }

    fn current(&self) -> Option<&ComparisonView> {
        self.shown.as_ref().filter(|shown| Some(&shown.moment) == self.seen.as_ref())
    }

    fn choose(&mut self, against: Option<ComparisonTarget>) {
        if self.against != against {
            self.stop();
            self.against = against;
            self.shown = None;
            self.problems.clear();
            // On a choice by hand even the truth is computed at once.
            self.asked = None;
            self.seen = None;
        }
    }

    fn stop(&mut self) {
        self.progress.stop();
    }

    /// Takes a result, and requests the comparison that is due.
    pub(crate) fn update(&mut self, ui: &Ui, session: &Session, size: [u32; 2]) {
        let answers = self.worker.as_ref().map(Worker::answers).unwrap_or_default();
        for done in answers {
            if self.asked.as_ref() == Some(&done.moment) {
                self.take(ui, done);
            }
        }
        let Some(against) = self.against else { return };
        let moment = ComparisonInputs { stamp: session.stamp(), size, against };
        let now = ui.input(|input| input.time);
        let is_first = self.seen.is_none();
        if self.seen.as_ref() != Some(&moment) {
            self.seen = Some(moment.clone());
            self.seen_at = now;
            if against == ComparisonTarget::Truth && !is_first {
                self.stop();
                self.shown = None;
            }
        }
        let is_known = self.asked.as_ref() == Some(&moment);
        if is_known || (against == ComparisonTarget::Truth && !is_first) {
            return;
        }
        let rested = now - self.seen_at;
        if is_first || rested >= REST {
            self.ask(session, moment);
        } else {
            ui.ctx().request_repaint_after_secs((REST - rested).max(0.01) as f32);
        }
    }

    fn ask(&mut self, session: &Session, moment: ComparisonInputs) {
        self.stop();
        let wake = self.wake.clone();
        self.progress = Progress::observed_by_percent(move |_| wake());
        self.asked = Some(moment.clone());
        let job = ComparisonRequest {
            moment,
            snapshot: session.snapshot(),
            progress: self.progress.clone(),
        };
        if let Some(worker) = &self.worker {
            worker.request(|_| job);
        }
    }

    fn take(&mut self, ui: &Ui, done: ComparisonResult) {
        self.problems.clear();
        match done.result {
            Ok(compared) => {
                let load = |name: &str, image: &egui::ColorImage| {
                    ui.ctx().load_texture(name, image.clone(), egui::TextureOptions::LINEAR)
                };
                let [left, right] = &compared.pictures;
                let textures = [load("as it is", left), load("against", right)];
                self.shown = Some(ComparisonView {
                    moment: done.moment,
                    compared,
                    textures,
                    magnified: None,
                });
            }
            Err(problems) => {
                self.shown = None;
                self.problems =
                    if Interruption::is_among(&problems) { Vec::new() } else { problems };
            }
        }
    }
}

impl BackgroundJobs for Wipe {
    fn is_busy(&self) -> bool {
        self.worker.as_ref().is_some_and(Worker::is_busy)
    }

    fn wait(&self) {
        if let Some(worker) = &self.worker {
            worker.wait();
        }
    }
}

impl Drop for Wipe {
    fn drop(&mut self) {
        self.stop();
    }
}
