//! Small pictures of looks and layers, drawn on a thread of their own while the window rests: one at a time, each kept by
//! what it shows, so that undo and the same layer elsewhere cost nothing.

use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::PathBuf;
use std::sync::Arc;

use eframe::egui::{self, ColorImage, TextureHandle, TextureId, Ui};

use super::super::orbit::Orbit;
use super::super::session::Session;
use super::super::still::{Reused, Still};
use super::super::worker::Worker;
use crate::compile::Live;
use crate::document::Look;
use crate::frame::{Cull, PlanOptions, Planner};
use crate::render::{Gpu, Renderer, block_on};

/// The side of a picture, in pixels: enough for a row at twice the usual scale.
const SIDE: u32 = 112;
/// As many pictures are kept; then all begin anew.
const MOST: usize = 400;
/// The window rests after so many seconds.
const REST: f64 = 0.35;
/// From the eye to the middle of the mesh: nearer than the viewport's, as there is less room.
const DISTANCE: f64 = 3.1;

struct Job {
    key: u64,
    still: Still,
}

struct Done {
    key: u64,
    /// `None` where it cannot be drawn.
    image: Option<ColorImage>,
}

/// The small pictures of a window.
pub(crate) struct Thumbs {
    worker: Option<Worker<Job, Done>>,
    pictures: HashMap<u64, Option<TextureHandle>>,
    /// What the window was when it was looked at last, and since when it is so.
    seen: (u64, u64),
    seen_at: f64,
    rests: bool,
}

impl Thumbs {
    /// `wake` is called from another thread when there is a new one. Without a GPU there are none.
    pub(crate) fn new(gpu: Option<Gpu>, wake: impl Fn() + Send + 'static) -> Self {
        let start = |gpu: Gpu| {
            let mut artist = Artist {
                renderer: Renderer::new(gpu),
                planner: Reused::new(|assets| Planner::new(assets).culling(Cull::Objects)),
            };
            Worker::new("thumbs", wake, move |job: Job| Done { key: job.key, image: artist.draw(&job.still) })
        };
        Self { worker: gpu.map(start), pictures: HashMap::new(), seen: (0, 0), seen_at: 0.0, rests: false }
    }

    pub(crate) fn is_busy(&self) -> bool {
        self.worker.as_ref().is_some_and(Worker::is_busy)
    }

    pub(crate) fn wait(&self) {
        if let Some(worker) = &self.worker {
            worker.wait();
        }
    }

    /// Takes what was drawn, and knows whether the window rests. To be called once a frame.
    pub(crate) fn update(&mut self, ui: &Ui, session: &Session) {
        for Done { key, image } in self.worker.as_ref().map(Worker::answers).unwrap_or_default() {
            if self.pictures.len() >= MOST {
                self.pictures.clear();
            }
            let options = egui::TextureOptions::LINEAR;
            let texture = image.map(|image| ui.ctx().load_texture(format!("thumb {key:x}"), image, options));
            self.pictures.insert(key, texture);
        }
        let now = ui.input(|input| input.time);
        let seen = (session.document_number(), session.revision());
        let is_held = ui.input(|input| input.pointer.any_down());
        if self.seen != seen || is_held || session.is_compiling() {
            self.seen = seen;
            self.seen_at = now;
        }
        self.rests = now - self.seen_at >= REST;
    }

    /// Whether there is something to draw with, and time to.
    pub(crate) fn rests(&self) -> bool {
        self.rests && self.worker.is_some()
    }

    /// Whether there is something to draw with.
    pub(crate) fn can_draw(&self) -> bool {
        self.worker.is_some()
    }

    /// A picture that was drawn before.
    pub(crate) fn known(&self, key: u64) -> Option<TextureId> {
        self.pictures.get(&key)?.as_ref().map(TextureHandle::id)
    }

    /// Whether this picture is there, or never will be.
    pub(crate) fn is_done(&self, key: u64) -> bool {
        self.pictures.contains_key(&key)
    }

    /// Looks again once the window rests.
    pub(crate) fn look_again(&self, ui: &Ui) {
        if self.worker.is_some() && !self.rests {
            let left = REST - (ui.input(|input| input.time) - self.seen_at);
            ui.ctx().request_repaint_after_secs(left.max(0.02) as f32);
        }
    }

    /// Asks for a picture of a look if nothing else is being drawn; the thread wakes the window when it is there.
    pub(crate) fn ask(&self, key: u64, look: Arc<Look>, folder: PathBuf, session: &Session) {
        let Some(worker) = self.worker.as_ref().filter(|worker| self.rests && !worker.is_busy()) else { return };
        let orbit = Orbit { distance: DISTANCE, ..Orbit::default() };
        let still = Still { folder, orbit, ..session.still_of(look) };
        worker.request(|_| Job { key, still });
    }
}

/// What tells a picture of a look from another: everything that it is made of, but for names and places on the canvas.
pub(crate) fn key_of(look: &Look) -> u64 {
    let mut hasher = DefaultHasher::new();
    format!("{:?}", (look.color_space, look.tier, &look.lights, &look.definitions, &look.graph.wires))
        .hash(&mut hasher);
    for (id, node) in &look.graph.nodes {
        format!("{:?}", (id, &node.kind, &node.values, node.tier, node.muted)).hash(&mut hasher);
    }
    hasher.finish()
}

/// Lives on the thread.
struct Artist {
    renderer: Renderer,
    planner: Reused,
}

impl Artist {
    fn draw(&mut self, still: &Still) -> Option<ColorImage> {
        let planner = self.planner.of(&still.look);
        let (setup, _) = still.setup(&mut planner.assets).ok()?;
        let options = PlanOptions { size: [SIDE; 2], samples: 4, time: 0.0 };
        let plan = planner.plan(&setup, &still.library, &Live::Keyed, &options).ok()?;
        let picture = block_on(self.renderer.picture(&plan)).ok()?;
        Some(ColorImage::from_rgba_unmultiplied(picture.size.map(|side| side as usize), &picture.to_rgba8()))
    }
}
