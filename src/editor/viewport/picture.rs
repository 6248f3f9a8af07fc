//! Picture in the viewport: planned and drawn on a thread of its own, on the window's device, so
//! that neither a slow GPU nor a shader being built holds up the pointer. The newest request wins;
//! the last picture stays until it is drawn.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{Arc, Weak};
use std::time::Duration;

use chiaro_locale::tr;
use eframe::egui::{Rect, TextureId, vec2};
use eframe::egui_wgpu::RenderState;

use super::stopwatch::{Stopwatch, TimedWork};
use crate::clock::Clock;
use crate::compile::{CompiledShader, Live};
use crate::diag::{Diagnostic, Severity, WithWarnings, has_errors};
use crate::frame::{Effect, FramePlan, effects};
use crate::ids::NodeId;
use crate::library::Library;
use crate::milestones;
use crate::render::{Gpu, Renderer, set_times};
use crate::state::crashes::{CrashLog, CrashMark, CrashStep, DocumentOrigin};
use crate::state::display::PictureDisplay;
use crate::state::orbit::Orbit;
use crate::state::picture_cost::PictureCost;
use crate::state::revision::{DocumentNumber, PictureRevision, RequestNumber};
use crate::state::session::{DrawableLook, Session};
use crate::state::snapshot::RenderSnapshot;
use crate::state::worker::Worker;
use crate::tools::picture_plan::PicturePlanner;

/// Subject of a picture: another document or another mesh is another subject.
#[derive(Clone, PartialEq)]
struct PictureSubject {
    document: DocumentNumber,
    mesh: String,
}

impl PictureSubject {
    fn of(session: &Session) -> Self {
        // A scene has meshes of its own.
        let mesh = if session.open_scene().is_some() {
            String::new()
        } else {
            session.view.orbit.mesh.clone()
        };
        Self { document: session.revisions().document, mesh }
    }
}

/// Part that is missing for the first picture of the open document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MissingPicture {
    /// Compiled look.
    Shader,
    /// Drawing of the picture.
    Picture,
    /// Fix of the problems: nothing is under way.
    Mended,
}

/// Request for a picture.
struct PictureRequest {
    subject: PictureSubject,
    showing: DrawableLook,
    snapshot: RenderSnapshot,
    size: [u32; 2],
    /// Size of the picture's place in the window, before it was made coarser, in pixels.
    room: [u32; 2],
    /// True if the picture's effects are to be reported.
    tells_effects: bool,
    /// Name and file of the document, where it is drawn for the first time.
    first_of: Option<(String, Option<PathBuf>)>,
}

/// Inputs of the last request: for the same inputs no new picture is needed.
#[derive(PartialEq)]
struct PictureInputs {
    picture: PictureRevision,
    orbit: Orbit,
    time: f64,
    size: [u32; 2],
    folder: PathBuf,
    tells_effects: bool,
}

/// Drawn picture; without a texture where it could not be drawn.
struct DrawnPicture {
    subject: PictureSubject,
    room: [u32; 2],
    texture: Option<wgpu::TextureView>,
    /// Resources that were made for the picture, and need not be made for the next one.
    ready: Option<PreparedAssets>,
    problems: Vec<Diagnostic>,
    effects: Option<Vec<Effect>>,
    /// Cost of the picture, with the work that is being timed.
    cost: Option<(PictureCost, TimedWork)>,
    /// Lives until the GPU has done the picture's work, where that work was the first of its kind.
    unfinished: Option<Weak<CrashMark>>,
}

/// Resources that take long to make: a shader's pipelines, and a mesh on the GPU.
#[derive(Clone)]
struct PreparedAssets {
    shader: Arc<CompiledShader>,
    library: Arc<Library>,
    mesh: String,
}

impl PreparedAssets {
    fn of(showing: &DrawableLook, snapshot: &RenderSnapshot) -> Self {
        Self {
            shader: showing.shader.clone(),
            library: snapshot.library.clone(),
            mesh: snapshot.orbit.mesh.clone(),
        }
    }

    fn is(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.shader, &other.shader)
            && Arc::ptr_eq(&self.library, &other.library)
            && self.mesh == other.mesh
    }
}

/// Longest time that a frame waits until the picture of its own edit is handed to the GPU. With
/// everything ready that takes a few milliseconds; a software GPU draws on the same cores, and
/// takes its time.
const HURRY: Duration = Duration::from_millis(60);
/// Number of frames with late pictures after which waiting is given up for a while.
const MOST_LATE: u32 = 4;
/// Duration above which frames are too slow for dragging, in seconds.
const SLOW: f32 = 1.0 / 25.0;
/// Duration below which frames leave room for a finer picture, in seconds.
const QUICK: f32 = 1.0 / 100.0;
/// Number of slow frames in a row that make the picture coarser.
const PATIENCE: u32 = 2;
/// Number of quick frames in a row that make the picture finer.
const TRUST: u32 = 20;
/// Factor between pixels of the screen and of the coarsest picture, along each side.
const COARSEST: u32 = 4;

/// Coarseness of the picture during drags, so that it keeps up with the pointer.
#[derive(Debug)]
struct Pace {
    /// Present coarseness; 1 at rest.
    coarseness: u32,
    /// Coarseness at the end of the last drag; the next one begins with it.
    last: u32,
    slow: u32,
    quick: u32,
    /// True if the last frame requested a picture: only then does its duration tell anything.
    has_requested: bool,
}

impl Default for Pace {
    fn default() -> Self {
        Self { coarseness: 1, last: 1, slow: 0, quick: 0, has_requested: false }
    }
}

impl Pace {
    fn tell(&mut self, is_at_work: bool, dt: f32) {
        if !is_at_work {
            *self = Self { last: self.last, ..Self::default() };
            return;
        }
        if self.has_requested {
            self.slow = if dt > SLOW { self.slow + 1 } else { 0 };
            self.quick = if dt < QUICK { self.quick + 1 } else { 0 };
        }
        if self.slow >= PATIENCE {
            self.last = (self.last * 2).min(COARSEST);
            self.slow = 0;
        } else if self.quick >= TRUST {
            self.last = (self.last / 2).max(1);
            self.quick = 0;
        }
        self.coarseness = self.last;
    }
}

/// Picture of the viewport.
pub(crate) struct ViewportPicture {
    state: RenderState,
    gpu: Gpu,
    worker: Worker<PictureRequest, DrawnPicture>,
    stopwatch: Stopwatch,
    /// Cost of the last picture, and its number.
    cost: (RequestNumber, PictureCost),
    texture: Option<TextureId>,
    /// Subject of the picture that is shown.
    shown: Option<PictureSubject>,
    /// Size of the place that the shown picture was drawn for, in pixels.
    shown_room: [u32; 2],
    wanted: Option<PictureInputs>,
    pace: Pace,
    /// Resources that the last picture was drawn with.
    ready: Option<PreparedAssets>,
    /// True if all that is requested needs only to be drawn: nothing is to be built, and no mesh to
    /// be read.
    is_quick: bool,
    /// Longest time that a frame waits for the picture of its own edit.
    pub(crate) patience: Duration,
    /// Number of frames in a row that went without the picture of their own edit.
    late: u32,
    /// Size that was requested last, before it was made coarser, in pixels.
    size: [u32; 2],
    /// Lives while the GPU does work of a kind that it never did before: compilers of drivers may
    /// be running as well.
    unfinished: Weak<CrashMark>,
    /// Number of the picture that was requested last.
    pub(crate) requested: RequestNumber,
    /// Problems that keep the picture from being drawn, or warnings about it.
    pub(crate) problems: Vec<Diagnostic>,
    /// True if the cost of the picture is to be reported.
    pub(crate) tells_effects: bool,
    /// Effects of the last picture of a look at rest, where they were requested.
    pub(crate) effects: Arc<Vec<Effect>>,
    /// True while a frame from the cache is shown in its place: no picture is requested.
    pub(crate) is_covered: bool,
}

impl ViewportPicture {
    /// Creates a picture on the window's device. `wake` is called from another thread when there is
    /// a new one; the drawing is noted in `crashes`.
    pub(crate) fn new(
        state: RenderState,
        crashes: CrashLog,
        wake: impl Fn() + Clone + Send + 'static,
    ) -> Self {
        let gpu = Gpu::new(state.device.clone(), state.queue.clone(), state.adapter.get_info());
        let renderer = Renderer::new(gpu.clone());
        let planner = PicturePlanner::default();
        let mut picture_renderer = PictureRenderer { renderer, planner, crashes, counted: None };
        let stopwatch = Stopwatch::new(state.device.clone(), wake.clone());
        let worker = Worker::waiting("picture", wake, async move |request| {
            picture_renderer.draw(&request).await
        });
        Self {
            state,
            gpu,
            worker,
            stopwatch,
            cost: Default::default(),
            texture: None,
            shown: None,
            shown_room: [0; 2],
            wanted: None,
            pace: Pace::default(),
            ready: None,
            is_quick: true,
            patience: HURRY,
            late: 0,
            size: [0; 2],
            unfinished: Weak::new(),
            requested: RequestNumber::default(),
            problems: Vec::new(),
            tells_effects: false,
            effects: Arc::default(),
            is_covered: false,
        }
    }

    /// The window's device.
    pub(crate) fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// Requests a picture of `size` pixels if anything changed, and returns the newest. During a
    /// drag (`is_at_work`) the picture may be coarser, if frames come too slowly otherwise; `dt` is
    /// the duration of the last frame, in seconds.
    pub(crate) fn update(
        &mut self,
        session: &Session,
        size: [u32; 2],
        is_at_work: bool,
        dt: f32,
    ) -> Option<TextureId> {
        self.take();
        self.size = size;
        self.pace.tell(is_at_work, dt);
        self.pace.has_requested = self.ask(session);
        self.texture
    }

    /// Requests the picture of an edit of this very frame, and waits until it is handed to the GPU,
    /// if it needs only to be drawn. The GPU works in order, so that this frame shows the picture
    /// already: the picture need not be finished, only be handed over before the frame is.
    pub(crate) fn hurry(&mut self, session: &Session) {
        self.pace.has_requested |= self.ask(session);
        if !self.worker.is_busy() {
            return;
        }
        if self.is_quick && (self.late < MOST_LATE || self.late.is_multiple_of(MOST_LATE * 8)) {
            self.worker.wait_at_most(self.patience);
            self.late = if self.worker.is_busy() { self.late.saturating_add(1) } else { 0 };
        }
        self.take();
    }

    fn take(&mut self) {
        for drawn in self.worker.answers() {
            if let Some(view) = drawn.texture {
                self.show(&view);
                self.shown = Some(drawn.subject);
                self.shown_room = drawn.room;
            }
            self.ready = drawn.ready.or(self.ready.take());
            self.problems = drawn.problems;
            self.unfinished = drawn.unfinished.unwrap_or_else(|| self.unfinished.clone());
            if let Some(effects) = drawn.effects {
                self.effects = Arc::new(effects);
            }
            if let Some((cost, work)) = drawn.cost {
                // The time of the picture before stands until the new one is known.
                let milliseconds = self.cost.1.milliseconds;
                let number = self.cost.0.advance();
                self.cost.1 = PictureCost { milliseconds, ..cost };
                self.stopwatch.time(number, work);
            }
        }
        for (number, seconds) in self.stopwatch.times() {
            if number == self.cost.0 {
                self.cost.1.milliseconds = Some(1e3 * seconds);
            }
        }
    }

    fn ask(&mut self, session: &Session) -> bool {
        if self.is_covered {
            return false;
        }
        let size = self
            .size
            .map(|side| if side > 0 { side.div_ceil(self.pace.coarseness).max(1) } else { 0 });
        let wanted = Some(PictureInputs {
            picture: session.revisions().picture,
            orbit: session.view.orbit.clone(),
            time: session.view.time,
            size,
            folder: session.look.folder(),
            tells_effects: self.tells_effects,
        });
        if self.wanted != wanted
            && size.iter().all(|&side| side > 0)
            && let Some(showing) = session.showing()
        {
            self.wanted = wanted;
            self.requested.advance();
            let snapshot = session.snapshot_of(showing.look.clone());
            let wanted = PreparedAssets::of(&showing, &snapshot);
            let is_ready = self.ready.as_ref().is_some_and(|ready| ready.is(&wanted));
            self.is_quick = is_ready && (self.is_quick || !self.worker.is_busy());
            let first_of = (!is_ready).then(|| session.shown_file());
            let subject = PictureSubject::of(session);
            let (room, tells_effects) = (self.size, self.tells_effects);
            self.worker.request(|_| PictureRequest {
                subject,
                showing,
                snapshot,
                size,
                room,
                tells_effects,
                first_of,
            });
            return true;
        }
        false
    }

    /// Place of the shown picture in its room in the window, which it may reach out of.
    pub(crate) fn place(&self, room: Rect) -> Rect {
        match self.shown_room == self.size {
            true => room,
            false => as_high_as(room, self.shown_room),
        }
    }

    /// Factor between pixels of the screen and of the picture, along each side; 1 at rest.
    pub(crate) fn coarseness(&self) -> u32 {
        self.pace.coarseness
    }

    /// True while a picture is being made.
    pub(crate) fn is_busy(&self) -> bool {
        self.worker.is_busy()
    }

    /// True while the GPU does work of a kind that it never did before; polls without waiting.
    pub(crate) fn is_unfinished(&self) -> bool {
        if self.unfinished.strong_count() > 0 {
            // A lost device calls back as well.
            let _ = self.state.device.poll(wgpu::PollType::Poll);
        }
        self.unfinished.strong_count() > 0
    }

    /// True if there is a picture.
    pub(crate) fn is_there(&self) -> bool {
        self.texture.is_some()
    }

    /// Part that is missing for the first picture of the open document, while the picture shows
    /// another subject.
    pub(crate) fn awaited(&self, session: &Session) -> Option<MissingPicture> {
        let subject = PictureSubject::of(session);
        let shown = self.shown.as_ref().filter(|shown| **shown != subject && self.is_there())?;
        if session.is_compiling() {
            return Some(MissingPicture::Shader);
        }
        // A picture that is drawn and not taken yet counts as awaited too: a sign that goes and
        // comes again would flicker.
        if self.worker.owes() {
            return Some(MissingPicture::Picture);
        }
        // On a mesh that cannot be read the last good picture stays.
        let is_broken = shown.document != subject.document;
        let is_broken = is_broken
            && (!self.problems.is_empty() || has_errors(session.compilation().problems()));
        is_broken.then_some(MissingPicture::Mended)
    }

    /// Cost of the picture that was drawn last.
    pub(crate) fn cost(&self) -> &PictureCost {
        &self.cost.1
    }

    /// Waits for the picture.
    pub(crate) fn wait(&self) {
        self.worker.wait();
        self.stopwatch.wait();
        if self.unfinished.strong_count() > 0 {
            let _ = self.state.device.poll(wgpu::PollType::wait_indefinitely());
        }
    }

    fn show(&mut self, view: &wgpu::TextureView) {
        let filter = wgpu::FilterMode::Linear;
        let mut renderer = self.state.renderer.write();
        match self.texture {
            Some(id) => {
                renderer.update_egui_texture_from_wgpu_texture(
                    &self.state.device,
                    view,
                    filter,
                    id,
                );
            }
            None => {
                self.texture =
                    Some(renderer.register_native_texture(&self.state.device, view, filter));
            }
        }
    }
}

/// Effects of a picture, where they were requested, and its cost with the work that is timed.
type DrawnReport = (Option<Vec<Effect>>, (PictureCost, TimedWork));

/// State of the thread that draws.
struct PictureRenderer {
    renderer: Renderer,
    planner: PicturePlanner,
    crashes: CrashLog,
    /// Operations of the shader that was drawn last.
    counted: Option<CountedShader>,
}

/// Operations of a shader's nodes; they are counted once, however often the shader is drawn.
struct CountedShader {
    shader: Arc<CompiledShader>,
    /// Number of the picture's passes, which nodes may be a part of.
    passes: usize,
    operations: Arc<BTreeMap<NodeId, u64>>,
}

impl PictureRenderer {
    /// Counts the operations of a picture's nodes.
    fn operations(
        &mut self,
        shader: &Arc<CompiledShader>,
        plan: &FramePlan,
    ) -> Arc<BTreeMap<NodeId, u64>> {
        let passes = plan.passes.len();
        let is_it = |of: &CountedShader| Arc::ptr_eq(&of.shader, shader) && of.passes == passes;
        let counted = self.counted.take().filter(is_it).unwrap_or_else(|| CountedShader {
            shader: shader.clone(),
            passes,
            operations: Arc::new(PictureCost::counted(&effects(plan, self.renderer.done()))),
        });
        self.counted.insert(counted).operations.clone()
    }

    async fn draw(&mut self, request: &PictureRequest) -> DrawnPicture {
        let (subject, room) = (request.subject.clone(), request.room);
        let going = request.first_of.as_ref().map(|(name, path)| {
            let origin = || DocumentOrigin::new(name, path.as_deref(), &request.showing.look);
            self.crashes.begin(CrashStep::Draw, origin)
        });
        let drawn = self.try_draw(request).await;
        let unfinished = going.map(|going| self.hand_to_gpu(going));
        match drawn {
            Ok(WithWarnings { value: (effects, cost), warnings: problems }) => {
                let ready = Some(PreparedAssets::of(&request.showing, &request.snapshot));
                DrawnPicture {
                    subject,
                    room,
                    texture: self.renderer.shown_view(),
                    ready,
                    problems,
                    effects,
                    cost: Some(cost),
                    unfinished,
                }
            }
            Err(problems) => DrawnPicture {
                subject,
                room,
                texture: None,
                ready: None,
                problems,
                effects: None,
                cost: None,
                unfinished,
            },
        }
    }

    /// Keeps a mark until the GPU has done all work that was handed to it. Some drivers compile
    /// only then.
    fn hand_to_gpu(&self, going: CrashMark) -> Weak<CrashMark> {
        let going = Arc::new(going);
        let unfinished = Arc::downgrade(&going);
        self.renderer.gpu().queue.on_submitted_work_done(move || drop(going));
        unfinished
    }

    /// Draws, and reports the effects where they are requested and the look is at rest: while a
    /// look is edited nothing is left out, as that would only flicker.
    async fn try_draw(
        &mut self,
        request: &PictureRequest,
    ) -> Result<WithWarnings<DrawnReport>, Vec<Diagnostic>> {
        let showing = &request.showing;
        let planned = self.planner.plan(showing, &request.snapshot, request.size)?;
        let (plan, mut warnings) = planned.into_parts();
        warnings.extend(self.renderer.gpu().warnings(&plan));
        let is_told = request.tells_effects && showing.live == Live::Keyed;
        let display = request.snapshot.display.as_ref();
        let shown_by = self.renderer.show_by(display.map(PictureDisplay::module)).await;
        warnings.extend(shown_by.err().map(|error| not_shown(error.into())));
        let done = self.renderer.done();
        let mut cost = PictureCost::of(&plan, |id, hash| done.get(&id) == Some(&hash));
        let mut effects = is_told.then(|| effects(&plan, done));
        let clock = Clock::start();
        self.renderer.draw(&plan).await.map_err(|error| vec![error.into()])?;
        let work = TimedWork::since(clock, self.renderer.gpu());
        // The GPU is at work already.
        cost.operations = self.operations(&showing.shader, &plan);
        if milestones::is_enabled() {
            self.renderer
                .gpu()
                .queue
                .on_submitted_work_done(|| milestones::reached("first picture"));
        }
        if let Some(effects) = &mut effects {
            // The whole picture is drawn once more with timestamps: the drawing before may have
            // been partial, or the first of its kind.
            let times = self.renderer.measure(&plan).await.map_err(|error| vec![error.into()])?;
            set_times(effects, &times);
        }
        Ok(WithWarnings::new((effects, (cost, work)), warnings))
    }
}

/// Place of a picture of another shape, in pixels, until the picture of the room's shape is there:
/// in the room's middle, not stretched, and as high, since all pictures of a camera see as much in
/// height. So nothing moves when the new picture comes.
fn as_high_as(room: Rect, [width, height]: [u32; 2]) -> Rect {
    let aspect = width.max(1) as f32 / height.max(1) as f32;
    Rect::from_center_size(room.center(), vec2(room.height() * aspect, room.height()))
}

/// Problem of a view that the picture is not shown by: it is shown by the curve of sRGB.
fn not_shown(mut problem: Diagnostic) -> Diagnostic {
    problem.severity = Severity::Warning;
    problem.message =
        tr!("the picture is shown by sRGB, not by its view: {why}", why = problem.message);
    problem
}

#[cfg(test)]
mod tests {
    use eframe::egui::pos2;

    use super::*;

    #[test]
    fn a_picture_of_another_shape_keeps_its_own() {
        let room = Rect::from_min_size(pos2(10.0, 20.0), vec2(300.0, 200.0));
        let at = |size| as_high_as(room, size);
        let narrow = at([400, 800]);
        assert_eq!((narrow.center(), narrow.size()), (room.center(), vec2(100.0, 200.0)));
        assert_eq!(at([1000, 500]).size(), vec2(400.0, 200.0), "cut off at its sides");
        assert_eq!(at([450, 300]), room, "of another scale alone it fills the room");
        assert!(at([0, 0]).is_finite());
    }

    #[test]
    fn a_slow_picture_is_coarser_while_a_hand_is_at_work() {
        let mut pace = Pace::default();
        let mut frames = |is_at_work: bool, dt: f32, count: u32| {
            for _ in 0..count {
                pace.tell(is_at_work, dt);
                pace.has_requested = true;
            }
            pace.coarseness
        };
        assert_eq!(frames(true, 0.016, 10), 1);
        assert_eq!(frames(true, 0.1, 2), 2);
        assert_eq!(frames(true, 0.1, 9), 4, "and no coarser");
        assert_eq!(frames(false, 0.1, 1), 1, "at rest it is whole");
        assert_eq!(frames(true, 0.016, 1), 4, "the next hand begins where the last one ended");
        assert_eq!(frames(true, 0.005, TRUST), 2);
        // A drag that rests in between has no long frame.
        pace.has_requested = false;
        pace.tell(true, 3.0);
        assert_eq!(pace.slow, 0);
    }
}
