//! Comparison of two pictures of the same moment: the look as it is or a snapshot of it, beside the
//! look in another tier, the truth in f64, a snapshot, the look in a file, or an image. A divider
//! wipes between both; they flicker, stand side by side, lie over each other; or their difference
//! is shown, magnified.
//!
//! Both pictures are made in the background with one sample a pixel, so that they can be compared,
//! and are dropped once anything changes. They are then made again by themselves, but for the
//! truth, which takes long, and is made only on request.

mod compare;
pub(crate) mod divider;
mod image;
mod show;

use std::sync::Arc;

use eframe::egui;
use eframe::egui::{Rect, TextureHandle, Ui};

use crate::accuracy::ErrorFigures;
use crate::diag::Diagnostic;
use crate::files::FileMetadata;
use crate::progress::{Interruption, Progress};
use crate::render::Gpu;
use crate::state::comparison::ComparedPicture;
use crate::state::session::Session;
use crate::state::snapshot::Stamp;
use crate::state::worker::{BackgroundJobs, Worker};
use crate::tools::fitting::FitTool;
use crate::tools::probe::picture_size;
use crate::tools::{PictureContext, SwitchPlace, ToolRow};
use compare::{Comparer, PictureSource};

pub(super) const TOOL: ToolRow = ToolRow::new(
    SwitchPlace::BarEnd,
    |parts| Box::new(Wipe::new(parts.gpu.clone(), parts.wake())),
    |tools| tools.of::<Wipe>().against.is_some(),
    |tools, ui, out| {
        // Pictures beside the viewport's would be in the way of strokes.
        let is_free = !tools.of::<FitTool>().is_on();
        ui.add_enabled_ui(is_free, |ui| show::choice(tools, ui, out));
    },
)
.with_bar(|tools, ui, session| tools.of_mut::<Wipe>().bar(ui, session))
.with_overlay(|tools, ui, PictureContext { session, rect, response, .. }, _| {
    let wipe = tools.of_mut::<Wipe>();
    // Where bars leave the picture no room there is nothing to compare, and no texture of it.
    let size = picture_size(*rect, ui.pixels_per_point());
    if size.contains(&0) {
        return;
    }
    wipe.update(ui, session, size);
    wipe.over(ui, *rect, response.contains_pointer());
})
.with_jobs(|tools| tools.of::<Wipe>());

/// Time of rest after which pictures are compared again, in seconds.
const REST: f64 = 0.2;

/// Factors by which a difference may be magnified.
pub(crate) const GAINS: [u32; 3] = [16, 64, 256];

/// Display of the two pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ComparisonMode {
    /// Both, on the sides of a divider.
    Wipe,
    /// One at a time.
    Flicker,
    /// Both, each whole.
    Beside,
    /// The right one over the left one, with an opacity.
    Over,
    /// Difference, magnified by a factor.
    Difference(u32),
}

/// Inputs of a comparison: for the same inputs the known result is used.
#[derive(Clone, Debug, PartialEq)]
struct ComparisonInputs {
    stamp: Stamp,
    size: [u32; 2],
    /// The left picture and the right one.
    pair: [ComparedPicture; 2],
    /// State of the files that they are of.
    files: [Option<FileMetadata>; 2],
}

impl ComparisonInputs {
    /// True if the comparison takes long, so that it is only made on request.
    fn is_slow(&self) -> bool {
        self.pair[1] == ComparedPicture::Truth
    }
}

struct ComparisonRequest {
    moment: ComparisonInputs,
    /// The left picture and the right one.
    sources: [PictureSource; 2],
    progress: Progress,
}

struct ComparisonResult {
    moment: ComparisonInputs,
    result: Result<PictureComparison, Vec<Diagnostic>>,
}

/// Two pictures and their difference.
struct PictureComparison {
    /// The left picture, and the one that it is compared with.
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
    /// Names of both pictures.
    names: [String; 2],
}

/// Comparison of pictures, with the last result.
pub struct Wipe {
    worker: Option<Worker<ComparisonRequest, ComparisonResult>>,
    /// The left picture: the look as it is, or a snapshot.
    left: ComparedPicture,
    against: Option<ComparedPicture>,
    mode: ComparisonMode,
    /// Position of the divider, as a part of the width.
    split: f32,
    /// Opacity of the right picture over the left one, 0 to 1.
    opacity: f32,
    /// True if the flicker changes by itself.
    flickers: bool,
    /// True if the right picture is shown while nothing flickers by itself and no key is held.
    shows_right: bool,
    seen: Option<ComparisonInputs>,
    seen_at: f64,
    asked: Option<ComparisonInputs>,
    progress: Progress,
    /// Called from another thread when there is more progress to show.
    wake: Arc<dyn Fn() + Send + Sync>,
    shown: Option<ComparisonView>,
    /// Name of the picture that is compared with, as it was told last.
    name: String,
    /// Snapshots that may be chosen, with their names.
    snapshots: Vec<(ComparedPicture, String)>,
    has_file: bool,
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
            left: ComparedPicture::Present,
            against: None,
            mode: ComparisonMode::Wipe,
            split: 0.5,
            opacity: 0.5,
            flickers: true,
            shows_right: false,
            seen: None,
            seen_at: 0.0,
            asked: None,
            progress: Progress::new(),
            wake: Arc::new(wake),
            shown: None,
            name: String::new(),
            snapshots: Vec::new(),
            has_file: false,
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

    /// Problems of the last comparison.
    pub fn problems(&self) -> &[Diagnostic] {
        &self.problems
    }

    fn current(&self) -> Option<&ComparisonView> {
        self.shown.as_ref().filter(|shown| Some(&shown.moment) == self.seen.as_ref())
    }

    /// True while two pictures stand side by side, neither where the picture is otherwise.
    pub(crate) fn is_beside(&self) -> bool {
        self.against.is_some() && self.mode == ComparisonMode::Beside
    }

    /// Part of the picture's place where the left picture is: left of the divider while there is
    /// one, else all of it.
    pub(crate) fn left_side(&self, rect: Rect) -> Rect {
        let has_divider = self.against.is_some() && self.mode == ComparisonMode::Wipe;
        let is_divided = has_divider && self.shown.is_some();
        if is_divided { divider::halves(rect, self.split)[0] } else { rect }
    }

    /// Compares the look as it is with another picture, or nothing.
    pub(crate) fn choose(&mut self, against: Option<ComparedPicture>) {
        if self.against != against {
            if against.is_none() {
                self.left = ComparedPicture::Present;
            }
            self.against = against;
            self.begin();
        }
    }

    /// Compares another left picture.
    fn choose_left(&mut self, left: ComparedPicture) {
        if self.left != left {
            self.left = left;
            self.begin();
        }
    }

    fn begin(&mut self) {
        self.stop();
        self.shown = None;
        self.problems.clear();
        // On a choice by hand even the truth is computed at once.
        self.asked = None;
        self.seen = None;
    }

    fn stop(&mut self) {
        self.progress.stop();
    }

    /// Takes a result, and requests the comparison that is due.
    pub(crate) fn update(&mut self, ui: &Ui, session: &Session, size: [u32; 2]) {
        let answers = self.worker.as_ref().map(Worker::answers).unwrap_or_default();
        for done in answers {
            if self.asked.as_ref() == Some(&done.moment) {
                self.take(ui, session, done);
            }
        }
        let all = session.shelf().all().rev();
        let choices =
            all.map(|snapshot| (ComparedPicture::Snapshot(snapshot.id), snapshot.name.clone()));
        self.snapshots = choices.collect();
        self.has_file = session.path().is_some();
        // A snapshot that was deleted, or is of another look, is compared no longer.
        let is_gone = |picture: &ComparedPicture| match picture {
            ComparedPicture::Snapshot(id) => session.shelf().of(*id).is_none(),
            _ => false,
        };
        if self.against.as_ref().is_some_and(is_gone) || is_gone(&self.left) {
            self.choose(None);
        }
        let Some(against) = self.against.clone() else { return };
        self.name = against.label(session.shelf());
        // A snapshot that has another name has it in the picture at once.
        if let Some(shown) = &mut self.shown {
            shown.names = shown.moment.pair.each_ref().map(|side| side.label(session.shelf()));
        }
        let pair = [self.left.clone(), against];
        let files = pair.each_ref().map(|picture| {
            picture.file(session.path()).and_then(|path| session.assets.source().metadata(path))
        });
        let moment = ComparisonInputs { stamp: session.stamp(), size, pair, files };
        let now = ui.input(|input| input.time);
        let is_first = self.seen.is_none();
        let is_slow = moment.is_slow();
        if self.seen.as_ref() != Some(&moment) {
            self.seen = Some(moment.clone());
            self.seen_at = now;
            if is_slow && !is_first {
                self.stop();
                self.shown = None;
            }
        }
        let is_known = self.asked.as_ref() == Some(&moment);
        if is_known || (is_slow && !is_first) {
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
        let sources = moment.pair.each_ref().map(|picture| PictureSource::of(picture, session));
        let job = ComparisonRequest { moment, sources, progress: self.progress.clone() };
        if let Some(worker) = &self.worker {
            worker.request(|_| job);
        }
    }

    fn take(&mut self, ui: &Ui, session: &Session, done: ComparisonResult) {
        self.problems.clear();
        match done.result {
            Ok(compared) => {
                let load = |name: &str, image: &egui::ColorImage| {
                    ui.ctx().load_texture(name, image.clone(), egui::TextureOptions::LINEAR)
                };
                let [left, right] = &compared.pictures;
                let textures = [load("as it is", left), load("against", right)];
                let pair = done.moment.pair.each_ref();
                let names = pair.map(|picture| picture.label(session.shelf()));
                self.shown = Some(ComparisonView {
                    moment: done.moment,
                    compared,
                    textures,
                    magnified: None,
                    names,
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
