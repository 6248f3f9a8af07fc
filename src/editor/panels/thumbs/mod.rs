//! Thumbnails of looks and layers, drawn on a thread of their own while the window rests: one at a
//! time, each kept by its content, so that undo and the same layer elsewhere cost nothing.

mod scene;
mod stage;

use std::cell::RefCell;
use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use glam::DVec3;

use chiaro_locale::tr;
use eframe::egui::{self, ColorImage, TextureHandle, TextureId, Ui};

use crate::commands::keyboard;
use crate::compile::Live;
use crate::document::Look;
use crate::frame::{
    AssetStore, CullMode, DEFAULT_MESH, Executor, Picture, PlanOptions, Planner, SHAPE_PREFIX,
};
use crate::progress::Progress;
use crate::render::Gpu;
use crate::state::crashes::{CrashLog, CrashStep, DocumentOrigin};
use crate::state::orbit::Orbit;
use crate::state::revision::{DocumentNumber, LookRevision};
use crate::state::session::Session;
use crate::state::snapshot::{CachedPlanner, RenderSnapshot};
use crate::state::worker::{BackgroundJobs, Worker};
pub(crate) use scene::{key_of_scene, key_of_shot};
pub(crate) use stage::ThumbStage;

/// Supersampling factor along each side: highlights are finer than the pixels of a thumbnail.
const FINER: u32 = 2;
/// Largest side of a thumbnail, in pixels.
const MAX_SIDE: u32 = 320;
/// Largest number of thumbnails that are kept; beyond it all are dropped.
const MOST: usize = 400;
/// Time without a change after which the window counts as resting, in seconds.
const REST: f64 = 0.35;
/// Least brightness of the brightest pixel of a lifted thumbnail, 0 to 1; below, the largest factor
/// of lifting.
const LIFTED: f32 = 0.85;
const MOST_LIFT: f32 = 8.0;

/// Framing of a thumbnail.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Shot {
    /// Whole object.
    Whole,
    /// Whole mesh of the picture, from the side that the picture shows.
    Shown,
    /// Middle of the object, from near.
    Near,
    /// Middle of the object from near, brightened until all that the layer adds is visible, as a
    /// layer that adds little is near black.
    Lifted,
}

impl Shot {
    /// Distance from the eye to its target, and the height of the target, in scene units.
    fn distance_and_height(self) -> (f64, f64) {
        match self {
            Self::Whole | Self::Shown => (3.45, -0.04),
            Self::Near | Self::Lifted => (2.0, 0.36),
        }
    }
}

/// Distance from the eye to the middle of an arbitrary mesh, in scene units.
const NEAR_ANY: f64 = 3.3;
/// Largest size of a mesh file that is read once more for thumbnails, in bytes.
const LIGHT: u64 = 4 << 20;

/// Object that thumbnails of layers are drawn on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ThumbObject {
    /// Mesh of the picture.
    Mesh,
    /// Creature, because the mesh of the picture is too large, or cannot be read.
    Heavy,
    /// Creature, because a scene may have a mesh for every object.
    Scene,
}

impl ThumbObject {
    /// Object for the picture that a session shows now.
    pub(crate) fn of(session: &Session) -> Self {
        let mesh = &session.view.orbit.mesh;
        let files = session.assets.source();
        let is_light = || files.metadata(Path::new(mesh)).is_some_and(|file| file.length <= LIGHT);
        match session.open_scene() {
            Some(_) => Self::Scene,
            None if mesh.starts_with(SHAPE_PREFIX) || is_light() => Self::Mesh,
            None => Self::Heavy,
        }
    }

    pub(crate) fn help(self) -> &'static str {
        match self {
            Self::Mesh => tr!("It is on the mesh in the picture."),
            Self::Heavy => {
                tr!("It is on the creature: the mesh in the picture is too heavy for small \
                     pictures.")
            }
            Self::Scene => {
                tr!("It is on the creature: objects of a scene have meshes of their own.")
            }
        }
    }
}

struct ThumbRequest {
    key: u64,
    /// Document that the thumbnail is of.
    origin: DocumentOrigin,
    subject: ThumbSubject,
    side: u32,
    /// Progress by which the drawing is stopped.
    progress: Progress,
}

/// Subject of a thumbnail.
enum ThumbSubject {
    Look(Box<RenderSnapshot>, Shot),
    /// Whole look on a stage of its own.
    Staged(Box<RenderSnapshot>, ThumbStage),
    /// Snapshot as it is seen in its own view, at its time.
    View(Box<RenderSnapshot>),
    /// Scene or shot in a file, and the store of the window's pictures.
    Scene(PathBuf, AssetStore),
}

struct ThumbResult {
    key: u64,
    /// Thumbnail; `None` where it cannot be drawn.
    image: Option<ColorImage>,
    /// True if the drawing was stopped, to be asked for again.
    is_stopped: bool,
}

/// Thumbnails of a window.
pub(crate) struct Thumbs {
    worker: Option<Worker<ThumbRequest, ThumbResult>>,
    pictures: HashMap<u64, Option<TextureHandle>>,
    /// State of the document when it was seen last, and the time since which it has been so, in
    /// seconds.
    seen: (DocumentNumber, LookRevision),
    seen_at: f64,
    rests: bool,
    /// True while the first large picture is being made, which wakes the window, or a dialog is
    /// open, whose end does.
    waits: bool,
    /// Progress of the thumbnail that was requested last.
    progress: RefCell<Progress>,
}

impl Thumbs {
    /// `wake` is called from another thread when a thumbnail is drawn; the drawing is noted in
    /// `crashes`. Without a GPU there are no thumbnails.
    pub(crate) fn new(
        gpu: Option<Gpu>,
        crashes: CrashLog,
        wake: impl Fn() + Send + 'static,
    ) -> Self {
        let start = |gpu: Gpu| {
            let mut thumb_renderer = ThumbRenderer {
                executor: None,
                window: gpu,
                planner: CachedPlanner::new(|assets| {
                    Planner::new(assets).culling(CullMode::Objects)
                }),
            };
            Worker::waiting("thumbs", wake, async move |job: ThumbRequest| {
                let _going = crashes.begin(CrashStep::Draw, || job.origin.clone());
                let image = thumb_renderer.draw(&job).await;
                let is_stopped = image.is_none() && job.progress.is_stopped();
                ThumbResult { key: job.key, image, is_stopped }
            })
        };
        Self {
            worker: gpu.map(start),
            pictures: HashMap::new(),
            seen: Default::default(),
            seen_at: 0.0,
            rests: false,
            waits: false,
            progress: RefCell::default(),
        }
    }

    /// Takes finished thumbnails, and finds out whether the window rests. Call once a frame.
    pub(crate) fn update(&mut self, ui: &Ui, session: &Session) {
        for ThumbResult { key, image, is_stopped } in
            self.worker.as_ref().map(Worker::answers).unwrap_or_default()
        {
            if is_stopped {
                continue;
            }
            if self.pictures.len() >= MOST {
                self.pictures.clear();
            }
            let options = egui::TextureOptions::LINEAR;
            let texture =
                image.map(|image| ui.ctx().load_texture(format!("thumb {key:x}"), image, options));
            self.pictures.insert(key, texture);
        }
        let now = ui.input(|input| input.time);
        // A slow machine has no time for thumbnails while a file is asked for or opened.
        self.waits = session.awaits_first_picture || keyboard::is_dialog_open(ui.ctx());
        if self.waits {
            self.progress.borrow().stop();
        }
        let seen = (session.revisions().document, session.revision());
        let is_held = ui.input(|input| input.pointer.any_down());
        if self.seen != seen || is_held || session.is_compiling() || self.waits {
            self.seen = seen;
            self.seen_at = now;
        }
        self.rests = now - self.seen_at >= REST;
    }

    /// True if thumbnails can be drawn, and the window rests.
    pub(crate) fn rests(&self) -> bool {
        self.rests && self.worker.is_some()
    }

    /// Number of thumbnails.
    pub(crate) fn count(&self) -> usize {
        self.pictures.len()
    }

    /// True if thumbnails can be drawn at all, that is, with a GPU.
    pub(crate) fn can_draw(&self) -> bool {
        self.worker.is_some()
    }

    /// Thumbnail that was drawn before.
    pub(crate) fn known(&self, key: u64) -> Option<TextureId> {
        self.pictures.get(&key)?.as_ref().map(TextureHandle::id)
    }

    /// True if a thumbnail is drawn, or cannot be drawn.
    pub(crate) fn is_done(&self, key: u64) -> bool {
        self.pictures.contains_key(&key)
    }

    /// Requests a repaint for when the window will rest.
    pub(crate) fn look_again(&self, ui: &Ui) {
        if self.worker.is_some() && !self.rests && !self.waits {
            let left = REST - (ui.input(|input| input.time) - self.seen_at);
            ui.ctx().request_repaint_after_secs(left.max(0.02) as f32);
        }
    }

    /// Requests a thumbnail of a look of the document `origin`, `side` pixels wide, if no other is
    /// being drawn; the thread wakes the window when the thumbnail is there.
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
            let orbit = orbit_of(shot, session);
            ThumbSubject::Look(
                Box::new(RenderSnapshot {
                    folder,
                    orbit,
                    scene: None,
                    ..session.snapshot_of(look)
                }),
                shot,
            )
        });
    }

    /// Requests a thumbnail of a whole look on a stage of its own, whatever the window shows.
    pub(crate) fn ask_on(
        &self,
        key: u64,
        origin: impl FnOnce() -> DocumentOrigin,
        (look, folder): (Arc<Look>, PathBuf),
        session: &Session,
        stage: &ThumbStage,
        side: f32,
    ) {
        self.request(key, origin, side, || {
            let (distance, height) = Shot::Whole.distance_and_height();
            let creature =
                Orbit { distance, target: DVec3::new(0.0, height, 0.0), ..Orbit::default() };
            let orbit = match stage.mesh.clone() {
                Some(mesh) if mesh != DEFAULT_MESH => {
                    Orbit { mesh, distance: NEAR_ANY, target: DVec3::ZERO, ..Orbit::default() }
                }
                _ => creature,
            };
            let snapshot =
                RenderSnapshot { folder, orbit, scene: None, ..session.snapshot_of(look) };
            ThumbSubject::Staged(Box::new(snapshot), stage.clone())
        });
    }

    /// Requests a thumbnail of a snapshot in its own view.
    pub(crate) fn ask_in_view(
        &self,
        key: u64,
        origin: impl FnOnce() -> DocumentOrigin,
        snapshot: impl FnOnce() -> RenderSnapshot,
        side: f32,
    ) {
        self.request(key, origin, side, || ThumbSubject::View(Box::new(snapshot())));
    }

    /// Requests a thumbnail of the scene or the shot in a file, as its own camera sees it.
    pub(crate) fn ask_for_scene(&self, key: u64, path: &Path, session: &Session, side: f32) {
        self.request(
            key,
            || DocumentOrigin::of_file(path),
            side,
            || ThumbSubject::Scene(path.to_owned(), session.assets.clone()),
        );
    }

    fn request(
        &self,
        key: u64,
        origin: impl FnOnce() -> DocumentOrigin,
        side: f32,
        subject: impl FnOnce() -> ThumbSubject,
    ) {
        let Some(worker) = self.worker.as_ref().filter(|worker| self.rests && !worker.is_busy())
        else {
            return;
        };
        let side = (side.round() as u32).clamp(8, MAX_SIDE);
        let (origin, subject) = (origin(), subject());
        let progress = Progress::new();
        self.progress.replace(progress.clone());
        worker.request(|_| ThumbRequest { key, origin, subject, side, progress });
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

/// View of a thumbnail, on the mesh of the picture where it may be.
fn orbit_of(shot: Shot, session: &Session) -> Orbit {
    let (distance, height) = shot.distance_and_height();
    let shown = &session.view.orbit;
    let is_on_mesh = shot != Shot::Whole && ThumbObject::of(session) == ThumbObject::Mesh;
    // The creature has a framing of its own, on its face; other meshes are seen from farther away.
    let mut orbit = match is_on_mesh && shown.mesh != DEFAULT_MESH {
        true => Orbit {
            mesh: shown.mesh.clone(),
            z_is_up: shown.z_is_up,
            distance: NEAR_ANY,
            target: DVec3::ZERO,
            ..Orbit::default()
        },
        false => Orbit { distance, target: DVec3::new(0.0, height, 0.0), ..Orbit::default() },
    };
    if is_on_mesh && shown.is_turned_around() {
        orbit.turn_around();
    }
    orbit
}

/// Key of a look's thumbnail: a hash of everything that the picture depends on, without names and
/// places on the canvas.
pub(crate) fn key_of(look: &Look, shot: Shot, side: f32) -> u64 {
    let mut hasher = DefaultHasher::new();
    (shot, side.round() as u32).hash(&mut hasher);
    format!(
        "{:?}",
        (
            look.color_space,
            look.tier,
            look.max_error,
            &look.lights,
            &look.definitions,
            &look.graph.wires
        )
    )
    .hash(&mut hasher);
    for (id, node) in &look.graph.nodes {
        format!("{:?}", (id, &node.kind, &node.values, node.tier, node.muted)).hash(&mut hasher);
    }
    hasher.finish()
}

/// Key of a layer's thumbnail, which is drawn on the mesh that `session` shows.
pub(crate) fn key_on(look: &Look, shot: Shot, side: f32, session: &Session) -> u64 {
    let mut hasher = DefaultHasher::new();
    key_of(look, shot, side).hash(&mut hasher);
    if ThumbObject::of(session) == ThumbObject::Mesh {
        surroundings_key(session).hash(&mut hasher);
    }
    hasher.finish()
}

/// Hash of the mesh in the picture, and of the side that it shows.
pub(crate) fn surroundings_key(session: &Session) -> u64 {
    let mut hasher = DefaultHasher::new();
    (
        &session.view.orbit.mesh,
        session.view.orbit.z_is_up,
        session.view.orbit.is_turned_around(),
        session.open_scene().is_some(),
        session.revisions().files,
    )
        .hash(&mut hasher);
    hasher.finish()
}

/// Drawer of thumbnails, on their thread.
struct ThumbRenderer {
    executor: Option<Box<dyn Executor + Send>>,
    /// GPU of the window, for machines that give no device beside it.
    window: Gpu,
    planner: CachedPlanner,
}

impl ThumbRenderer {
    async fn draw(
        &mut self,
        ThumbRequest { subject, side, progress, .. }: &ThumbRequest,
    ) -> Option<ColorImage> {
        let options = PlanOptions { size: [side * FINER; 2], samples: 4, time: 0.0 };
        let plan = match subject {
            ThumbSubject::Look(snapshot, _) => {
                let planner = self.planner.of(&snapshot.look, &snapshot.library);
                planner.assets.draft();
                let mut setup = snapshot.setup(&mut planner.assets).ok()?.value;
                setup.scene.backdrop = None;
                planner.plan(&setup, &snapshot.library, &Live::Keyed, &options).ok()?.value
            }
            ThumbSubject::Staged(snapshot, stage) => {
                let planner = self.planner.of(&snapshot.look, &snapshot.library);
                planner.assets.draft();
                let mut setup = snapshot.setup(&mut planner.assets).ok()?.value;
                stage.set(&mut setup.scene).ok()?;
                planner.plan(&setup, &snapshot.library, &Live::Keyed, &options).ok()?.value
            }
            ThumbSubject::View(snapshot) => {
                let planner = self.planner.of(&snapshot.look, &snapshot.library);
                let setup = snapshot.setup(&mut planner.assets).ok()?.value;
                let options = PlanOptions { time: snapshot.time, ..options };
                planner.plan(&setup, &snapshot.library, &Live::Keyed, &options).ok()?.value
            }
            ThumbSubject::Scene(path, assets) => scene::plan(path, &options, assets)?,
        };
        progress.check().ok()?;
        // Thumbnails have a device of their own: in the queue of the window's the next frame would
        // wait behind them, and software takes up to a minute for a shader that it first compiles.
        let executor = match &mut self.executor {
            Some(executor) => executor,
            none => {
                let gpu = Gpu::headless().await.unwrap_or_else(|_| self.window.clone());
                none.insert(gpu.executor())
            }
        };
        let picture = executor.picture(&plan, progress).await.ok()?;
        Some(smaller(&picture, matches!(subject, ThumbSubject::Look(_, Shot::Lifted))))
    }
}

/// Picture reduced to the size at which it is shown, and lifted if `lifts` is set.
fn smaller(picture: &Picture, lifts: bool) -> ColorImage {
    let side = picture.size[0] / FINER;
    let pixels = (0..side * side).map(|index| {
        let (x, y) = (index % side * FINER, index / side * FINER);
        // Sums are premultiplied, so that an edge takes no color from transparent pixels.
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
    use crate::library::Library;

    #[test]
    fn layers_and_snapshots_are_seen_as_the_mesh_of_the_picture_is() {
        let mut session = Session::new(Arc::new(Library::built_in().clone()), || {});
        session.view.orbit.mesh = "shape:torus".to_owned();
        let front = surroundings_key(&session);
        for shot in [Shot::Near, Shot::Lifted, Shot::Shown] {
            let orbit = orbit_of(shot, &session);
            assert_eq!((orbit.mesh.as_str(), orbit.is_turned_around()), ("shape:torus", false));
        }
        session.view.orbit.turn_around();
        assert_ne!(surroundings_key(&session), front, "they are drawn anew");
        for shot in [Shot::Near, Shot::Lifted, Shot::Shown] {
            assert!(orbit_of(shot, &session).is_turned_around(), "{shot:?}");
        }
        // A look of the library has nothing to do with the picture.
        assert_eq!(orbit_of(Shot::Whole, &session).mesh, DEFAULT_MESH);
        assert!(!orbit_of(Shot::Whole, &session).is_turned_around());
    }

    #[test]
    fn a_smaller_picture_is_the_mean_and_its_brightest_pixel_is_bright() {
        let mut picture = Picture { size: [4, 4], rgba: vec![[0.0, 0.0, 0.0, 1.0]; 16] };
        // One of the four pixels of the first block is 0.8 red, and one of the last block is
        // transparent.
        picture.rgba[0] = [0.8, 0.0, 0.0, 1.0];
        picture.rgba[15] = [1.0, 1.0, 1.0, 0.0];
        let plain = smaller(&picture, false);
        assert_eq!((plain.size, plain.pixels[0].r(), plain.pixels[3].a()), ([2, 2], 51, 191));
        assert_eq!(smaller(&picture, true).pixels[0].r(), 217, "0.85");
        let black = Picture { size: [4, 4], rgba: vec![[0.0, 0.0, 0.0, 1.0]; 16] };
        assert_eq!(smaller(&black, true).pixels[0].r(), 0);
    }
}
