//! Small pictures of looks and layers, drawn on a thread of their own while the window rests: one
//! at a time, each kept by what it shows, so that undo and the same layer elsewhere cost nothing.

mod scene;

use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use glam::DVec3;

use eframe::egui::{self, ColorImage, TextureHandle, TextureId, Ui};

use crate::compile::Live;
use crate::document::Look;
use crate::frame::{Cull, DEFAULT_MESH, Picture, PlanOptions, Planner, SHAPE_PREFIX};
use crate::render::{Gpu, Renderer, block_on};
use crate::state::orbit::Orbit;
use crate::state::revision::{DocumentNumber, LookRevision};
use crate::state::safety::crashes::{CrashLog, DocumentOrigin, Step};
use crate::state::session::Session;
use crate::state::snapshot::{RenderSnapshot, Reused};
use crate::state::worker::{BackgroundJobs, Worker};
pub(crate) use scene::key_of_scene;

/// Each pixel is the mean of so many by so many: highlights are finer than a small picture's
/// pixels.
const FINER: u32 = 2;
/// The greatest side of a picture, in pixels.
const MAX_SIDE: u32 = 320;
/// As many pictures are kept; then all begin anew.
const MOST: usize = 400;
/// The window rests after so many seconds.
const REST: f64 = 0.35;
/// How bright the brightest pixel of a lifted picture is at least, and how much it is lifted at
/// most.
const LIFTED: f32 = 0.85;
const MOST_LIFT: f32 = 8.0;

/// How a small picture is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Shot {
    /// The whole object.
    Whole,
    /// What is in the middle, from near.
    Near,
    /// The same, brightened until it is plain where anything is, as what adds little is near black.
    Lifted,
}

impl Shot {
    /// From the eye to what it looks at, and how high that is.
    fn distance_and_height(self) -> (f64, f64) {
        match self {
            Self::Whole => (3.45, -0.04),
            Self::Near | Self::Lifted => (2.0, 0.36),
        }
    }
}

/// From the eye to the middle of a mesh that may be anything.
const NEAR_ANY: f64 = 3.3;
/// Files of meshes up to so many bytes are read once more for small pictures.
const LIGHT: u64 = 4 << 20;

/// What small pictures of layers are drawn on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stand {
    /// The mesh that is in the picture.
    Mesh,
    /// The creature, because the mesh in the picture is too heavy, or cannot be read.
    Heavy,
    /// The creature, because a scene may have a mesh for every object.
    Scene,
}

impl Stand {
    /// Of the picture that a session shows now.
    pub(crate) fn of(session: &Session) -> Self {
        let mesh = &session.view.orbit.mesh;
        let is_light = || std::fs::metadata(mesh).is_ok_and(|file| file.len() <= LIGHT);
        match session.stage() {
            Some(_) => Self::Scene,
            None if mesh.starts_with(SHAPE_PREFIX) || is_light() => Self::Mesh,
            None => Self::Heavy,
        }
    }

    pub(crate) fn help(self) -> &'static str {
        match self {
            Self::Mesh => "It is on the mesh in the picture.",
            Self::Heavy => {
                "It is on the creature: the mesh in the picture is too heavy for small pictures."
            }
            Self::Scene => "It is on the creature: objects of a scene have meshes of their own.",
        }
    }
}

struct ThumbRequest {
    key: u64,
    /// The document that it is of.
    origin: DocumentOrigin,
    subject: Subject,
    side: u32,
}

/// What is drawn.
enum Subject {
    Look(Box<RenderSnapshot>, Shot),
    /// The scene in a file.
    Scene(PathBuf),
}

struct ThumbResult {
    key: u64,
    /// `None` where it cannot be drawn.
    image: Option<ColorImage>,
}

/// The small pictures of a window.
pub(crate) struct Thumbs {
    worker: Option<Worker<ThumbRequest, ThumbResult>>,
    pictures: HashMap<u64, Option<TextureHandle>>,
    /// What the window was when it was looked at last, and since when it is so.
    seen: (DocumentNumber, LookRevision),
    seen_at: f64,
    rests: bool,
    /// Whether the first large picture is on its way, which wakes the window.
    waits: bool,
}

impl Thumbs {
    /// `wake` is called from another thread when there is a new one; what goes on is noted in
    /// `crashes`. Without a GPU there are none.
    pub(crate) fn new(
        gpu: Option<Gpu>,
        crashes: CrashLog,
        wake: impl Fn() + Send + 'static,
    ) -> Self {
        let start = |gpu: Gpu| {
            let mut artist = Artist {
                renderer: Renderer::new(gpu),
                planner: Reused::new(|assets| Planner::new(assets).culling(Cull::Objects)),
            };
            Worker::new("thumbs", wake, move |job: ThumbRequest| {
                let _going = crashes.begin(Step::Draw, || job.origin.clone());
                ThumbResult { key: job.key, image: artist.draw(&job) }
            })
        };
        Self {
            worker: gpu.map(start),
            pictures: HashMap::new(),
            seen: Default::default(),
            seen_at: 0.0,
            rests: false,
            waits: false,
        }
    }

    /// Takes what was drawn, and knows whether the window rests. To be called once a frame.
    pub(crate) fn update(&mut self, ui: &Ui, session: &Session) {
        for ThumbResult { key, image } in
            self.worker.as_ref().map(Worker::answers).unwrap_or_default()
        {
            if self.pictures.len() >= MOST {
                self.pictures.clear();
            }
            let options = egui::TextureOptions::LINEAR;
            let texture =
                image.map(|image| ui.ctx().load_texture(format!("thumb {key:x}"), image, options));
            self.pictures.insert(key, texture);
        }
        let now = ui.input(|input| input.time);
        self.waits = session.awaits_first_picture;
        let seen = (session.document_number(), session.revision());
        let is_held = ui.input(|input| input.pointer.any_down());
        if self.seen != seen || is_held || session.is_compiling() || self.waits {
            self.seen = seen;
            self.seen_at = now;
        }
        self.rests = now - self.seen_at >= REST;
    }

    /// Whether there is something to draw with, and time to.
    pub(crate) fn rests(&self) -> bool {
        self.rests && self.worker.is_some()
    }

    /// How many there are.
    pub(crate) fn count(&self) -> usize {
        self.pictures.len()
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
        if self.worker.is_some() && !self.rests && !self.waits {
            let left = REST - (ui.input(|input| input.time) - self.seen_at);
            ui.ctx().request_repaint_after_secs(left.max(0.02) as f32);
        }
    }

    /// Asks for a picture of a look of the document `origin`, `side` pixels wide, if nothing else
    /// is being drawn; the thread wakes the window when it is there.
    pub(crate) fn ask(
        &self,
        key: u64,
        origin: impl FnOnce() -> DocumentOrigin,
        (look, folder): (Arc<Look>, PathBuf),
        session: &Session,
        shot: Shot,
        side: f32,
    ) {
        self.request(key, origin, side, || {
            let (distance, height) = shot.distance_and_height();
            let orbit = match Stand::of(session) {
                // The creature's own face is nearer than any mesh's middle.
                Stand::Mesh if shot != Shot::Whole && session.view.orbit.mesh != DEFAULT_MESH => {
                    Orbit {
                        mesh: session.view.orbit.mesh.clone(),
                        z_is_up: session.view.orbit.z_is_up,
                        distance: NEAR_ANY,
                        target: DVec3::ZERO,
                        ..Orbit::default()
                    }
                }
                _ => Orbit { distance, target: DVec3::new(0.0, height, 0.0), ..Orbit::default() },
            };
            Subject::Look(
                Box::new(RenderSnapshot {
                    folder,
                    orbit,
                    stage: None,
                    ..session.snapshot_of(look)
                }),
                shot,
            )
        });
    }

    /// The same of the scene in a file, as its own camera sees it.
    pub(crate) fn ask_for_scene(&self, key: u64, path: &Path, side: f32) {
        self.request(
            key,
            || DocumentOrigin::of_file(path),
            side,
            || Subject::Scene(path.to_owned()),
        );
    }

    fn request(
        &self,
        key: u64,
        origin: impl FnOnce() -> DocumentOrigin,
        side: f32,
        subject: impl FnOnce() -> Subject,
    ) {
        let Some(worker) = self.worker.as_ref().filter(|worker| self.rests && !worker.is_busy())
        else {
            return;
        };
        let side = (side.round() as u32).clamp(8, MAX_SIDE);
        let (origin, subject) = (origin(), subject());
        worker.request(|_| ThumbRequest { key, origin, subject, side });
    }
}

impl BackgroundJobs for Thumbs {
    fn is_busy(&self) -> bool {
        self.worker.as_ref().is_some_and(Worker::is_busy)
    }

    fn wait(&self) {
        if let Some(worker) = &self.worker {
            worker.wait();
        }
    }
}

/// What tells a picture of a look from another: everything that it is made of, but for names and
/// places on the canvas.
pub(crate) fn key_of(look: &Look, shot: Shot, side: f32) -> u64 {
    let mut hasher = DefaultHasher::new();
    (shot, side.round() as u32).hash(&mut hasher);
    format!(
        "{:?}",
        (look.color_space, look.tier, &look.lights, &look.definitions, &look.graph.wires)
    )
    .hash(&mut hasher);
    for (id, node) in &look.graph.nodes {
        format!("{:?}", (id, &node.kind, &node.values, node.tier, node.muted)).hash(&mut hasher);
    }
    hasher.finish()
}

/// The same of a picture of a layer, which stands on what `session` shows.
pub(crate) fn key_on(look: &Look, shot: Shot, side: f32, session: &Session) -> u64 {
    let mut hasher = DefaultHasher::new();
    key_of(look, shot, side).hash(&mut hasher);
    if Stand::of(session) == Stand::Mesh {
        stage_of(session).hash(&mut hasher);
    }
    hasher.finish()
}

/// Tells one mesh in the picture from another.
pub(crate) fn stage_of(session: &Session) -> u64 {
    let mut hasher = DefaultHasher::new();
    (
        &session.view.orbit.mesh,
        session.view.orbit.z_is_up,
        session.stage().is_some(),
        session.files(),
    )
        .hash(&mut hasher);
    hasher.finish()
}

/// Lives on the thread.
struct Artist {
    renderer: Renderer,
    planner: Reused,
}

impl Artist {
    fn draw(&mut self, ThumbRequest { subject, side, .. }: &ThumbRequest) -> Option<ColorImage> {
        let options = PlanOptions { size: [side * FINER; 2], samples: 4, time: 0.0 };
        let plan = match subject {
            Subject::Look(still, _) => {
                let planner = self.planner.of(&still.look, &still.library);
                planner.assets.draft();
                let (mut setup, _) = still.setup(&mut planner.assets).ok()?;
                setup.scene.backdrop = None;
                planner.plan(&setup, &still.library, &Live::Keyed, &options).ok()?
            }
            Subject::Scene(path) => scene::plan(path, &options)?,
        };
        let picture = block_on(self.renderer.picture(&plan)).ok()?;
        Some(smaller(&picture, matches!(subject, Subject::Look(_, Shot::Lifted))))
    }
}

/// The picture at the size that it is shown at, lifted or as it is.
fn smaller(picture: &Picture, lifts: bool) -> ColorImage {
    let side = picture.size[0] / FINER;
    let pixels = (0..side * side).map(|index| {
        let (x, y) = (index % side * FINER, index / side * FINER);
        // Premultiplied, so that an edge takes no color from what is not there.
        let mut sum = [0.0_f32; 4];
        for (dx, dy) in (0..FINER * FINER).map(|part| (part % FINER, part / FINER)) {
            let [r, g, b, a] = picture.pixel(x + dx, y + dy);
            for (sum, part) in sum.iter_mut().zip([r * a, g * a, b * a, a]) {
                *sum += part.clamp(0.0, 1.0) / (FINER * FINER) as f32;
            }
        }
        sum
    });
    let pixels: Vec<[f32; 4]> = pixels.collect();
    let brightest =
        pixels.iter().flat_map(|pixel| &pixel[..3]).fold(0.0_f32, |most, part| most.max(*part));
    let gain =
        if lifts && brightest > 1e-3 { (LIFTED / brightest).clamp(1.0, MOST_LIFT) } else { 1.0 };
    let byte = |x: f32| (x.clamp(0.0, 1.0) * 255.0).round() as u8;
    let color = |[r, g, b, a]: [f32; 4]| {
        egui::Color32::from_rgba_premultiplied(
            byte(r * gain),
            byte(g * gain),
            byte(b * gain),
            byte(a),
        )
    };
    ColorImage::new([side as usize; 2], pixels.into_iter().map(color).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_smaller_picture_is_the_mean_and_its_brightest_pixel_is_bright() {
        let mut picture = Picture { size: [4, 4], rgba: vec![[0.0, 0.0, 0.0, 1.0]; 16] };
        // One of the four pixels of the first is 0.8 red, and one of the last is not there.
        picture.rgba[0] = [0.8, 0.0, 0.0, 1.0];
        picture.rgba[15] = [1.0, 1.0, 1.0, 0.0];
        let plain = smaller(&picture, false);
        assert_eq!((plain.size, plain.pixels[0].r(), plain.pixels[3].a()), ([2, 2], 51, 191));
        assert_eq!(smaller(&picture, true).pixels[0].r(), 217, "0.85");
        let black = Picture { size: [4, 4], rgba: vec![[0.0, 0.0, 0.0, 1.0]; 16] };
        assert_eq!(smaller(&black, true).pixels[0].r(), 0);
    }
}
