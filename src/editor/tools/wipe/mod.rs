//! The picture beside another of the same moment: the look in another tier, or the truth in f64. A
//! divider wipes between both; or their difference is shown, magnified.
//!
//! Both are made in the background with one sample a pixel, so that like is held against like, and
//! are dropped once anything changes. A tier is then compared again by itself; the truth, which
//! takes long, only when it is asked for.

mod compare;
mod show;

use std::sync::Arc;

use eframe::egui;
use eframe::egui::{TextureHandle, Ui};

use crate::accuracy::ErrorFigures;
use crate::diag::Diagnostic;
use crate::document::Tier;
use crate::progress::{Progress, Stopped};
use crate::render::Gpu;
use crate::state::session::Session;
use crate::state::still::{Stamp, Still};
use crate::state::worker::{BackgroundJobs, Worker};
use compare::Comparer;

/// A tier is compared again after the hand rests for so many seconds.
const REST: f64 = 0.2;

/// How often a difference may be magnified.
pub(crate) const GAINS: [u32; 3] = [16, 64, 256];

/// What the picture is held against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Against {
    Tier(Tier),
    Truth,
}

impl Against {
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

/// What is compared and when: the same again is known.
#[derive(Clone, Debug, PartialEq)]
struct Moment {
    stamp: Stamp,
    size: [u32; 2],
    against: Against,
}

struct Job {
    moment: Moment,
    still: Still,
    progress: Progress,
}

struct Done {
    moment: Moment,
    result: Result<Compared, Vec<Diagnostic>>,
}

/// Two pictures and how far they are apart.
struct Compared {
    /// As it is, and what that is held against.
    pictures: [egui::ColorImage; 2],
    /// The difference of each channel, red, green and blue; 0 on edges, where coverage may differ.
    difference: Vec<[f32; 3]>,
    figures: ErrorFigures,
}

/// What is on the screen.
struct Shown {
    moment: Moment,
    compared: Compared,
    textures: [TextureHandle; 2],
    /// The difference and how often it is magnified.
    magnified: Option<(u32, TextureHandle)>,
}

/// The comparison and what it found last.
pub struct Wipe {
    worker: Option<Worker<Job, Done>>,
    against: Option<Against>,
    /// `None` while the divider is shown.
    gain: Option<u32>,
    /// Where the divider is, in parts of the width.
    split: f32,
    seen: Option<Moment>,
    seen_at: f64,
    asked: Option<Moment>,
    progress: Progress,
    /// Called from another thread when there is more progress to show.
    wake: Arc<dyn Fn() + Send + Sync>,
    shown: Option<Shown>,
    problems: Vec<Diagnostic>,
}

impl Wipe {
    /// A comparison that is off. `wake` is called from another thread when there is news. Without a
    /// GPU there is none.
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

    /// How far the picture is from what it is held against, if that is known of what is shown now.
    pub fn figures(&self) -> Option<&ErrorFigures> {
        self.current().map(|shown| &shown.compared.figures)
    }

    /// Where the divider is, in parts of the width.
    pub fn split(&self) -> f32 {
        self.split
    }

    fn current(&self) -> Option<&Shown> {
        self.shown.as_ref().filter(|shown| Some(&shown.moment) == self.seen.as_ref())
    }

    fn choose(&mut self, against: Option<Against>) {
        if self.against != against {
            self.stop();
            self.against = against;
            self.shown = None;
            self.problems.clear();
            // Chosen by hand: even the truth is wanted now.
            self.asked = None;
            self.seen = None;
        }
    }

    fn stop(&mut self) {
        self.progress.stop();
    }

    /// Takes what was compared, and asks for what should be.
    pub(crate) fn update(&mut self, ui: &Ui, session: &Session, size: [u32; 2]) {
        let answers = self.worker.as_ref().map(Worker::answers).unwrap_or_default();
        for done in answers {
            if self.asked.as_ref() == Some(&done.moment) {
                self.take(ui, done);
            }
        }
        let Some(against) = self.against else { return };
        let moment = Moment { stamp: session.stamp(), size, against };
        let now = ui.input(|input| input.time);
        let is_first = self.seen.is_none();
        if self.seen.as_ref() != Some(&moment) {
            self.seen = Some(moment.clone());
            self.seen_at = now;
            if against == Against::Truth && !is_first {
                self.stop();
                self.shown = None;
            }
        }
        let is_known = self.asked.as_ref() == Some(&moment);
        if is_known || (against == Against::Truth && !is_first) {
            return;
        }
        let rested = now - self.seen_at;
        if is_first || rested >= REST {
            self.ask(session, moment);
        } else {
            ui.ctx().request_repaint_after_secs((REST - rested).max(0.01) as f32);
        }
    }

    fn ask(&mut self, session: &Session, moment: Moment) {
        self.stop();
        let wake = self.wake.clone();
        self.progress = Progress::observed_by_percent(move |_| wake());
        self.asked = Some(moment.clone());
        let job = Job { moment, still: session.still(), progress: self.progress.clone() };
        if let Some(worker) = &self.worker {
            worker.request(|_| job);
        }
    }

    fn take(&mut self, ui: &Ui, done: Done) {
        self.problems.clear();
        match done.result {
            Ok(compared) => {
                let load = |name: &str, image: &egui::ColorImage| {
                    ui.ctx().load_texture(name, image.clone(), egui::TextureOptions::LINEAR)
                };
                let [left, right] = &compared.pictures;
                let textures = [load("as it is", left), load("against", right)];
                self.shown =
                    Some(Shown { moment: done.moment, compared, textures, magnified: None });
            }
            Err(problems) => {
                self.shown = None;
                self.problems = if Stopped::is_among(&problems) { Vec::new() } else { problems };
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
