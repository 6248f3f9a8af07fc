//! Playback: frames of the timeline's range, drawn ahead, kept within a bound of memory, and shown
//! in place of the picture while the playhead moves.
//!
//! The timeline's clock says where the playhead is; here is decided which frame is drawn next. A
//! frame depends on the documents, the view, the size and its time. Once one of the former changes
//! no frame is kept any more, but pictures are: their key is the hash of the frame's plan, so that
//! frames that are equal, also after an edit that was undone, are drawn once. Names, texts and
//! markers change no picture, and so no frame.

pub(crate) mod cache;
pub(crate) mod drawing;
pub(crate) mod order;
pub(crate) mod paint;
mod rate;

use std::path::PathBuf;
use std::sync::Arc;

use eframe::egui::{ColorImage, TextureHandle, TextureOptions, Ui};

use super::{PictureTools, SwitchPlace, ToolRow};
use crate::diag::Diagnostic;
use crate::state::keying::retime::tidy;
use crate::state::orbit::Orbit;
use crate::state::revision::{DocumentNumber, PictureRevision, RequestNumber};
use crate::state::session::Session;
use crate::state::settings::DEFAULT_FRAME_MEMORY;
use crate::state::worker::{BackgroundJobs, Worker};
use cache::FrameCache;
use drawing::{FrameAnswer, FrameDrawer, FrameRequest};
use order::PlayOrder;
use rate::ShownRate;

pub(super) const TOOL: ToolRow = ToolRow::new(
    SwitchPlace::Elsewhere,
    |parts| {
        let worker = parts.gpu.clone().map(|gpu| {
            let mut drawer = FrameDrawer::new(&gpu);
            Worker::waiting("frames", parts.wake(), async move |request| drawer.run(request).await)
        });
        Box::new(Playback::new(worker))
    },
    |tools| tools.of::<Playback>().is_moving(),
    // The timeline has the buttons.
    |_, _, _| {},
)
.with_jobs(|tools| tools.of::<Playback>());

/// Choices of the memory that frames take, in MiB.
pub(crate) const MEMORIES: [u32; 6] = [128, 256, 512, 1024, 2048, 4096];

const MIB: usize = 1 << 20;

/// Times at which frames are shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum PlayPace {
    /// Each frame at its time; frames that are not ready then are left out.
    #[default]
    RealTime,
    /// Every frame, later than its time where it is not ready.
    EveryFrame,
}

/// The timeline's playhead and range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Transport {
    pub(crate) order: PlayOrder,
    /// Frames a second.
    pub(crate) fps: f64,
    /// Frames that are played a second: the rate times the speed.
    pub(crate) wanted_rate: f64,
    pub(crate) pace: PlayPace,
    pub(crate) is_playing: bool,
    /// True while a hand moves the playhead.
    pub(crate) is_scrubbed: bool,
}

impl Transport {
    /// Time of a frame, in seconds.
    pub(crate) fn time(&self, frame: i32) -> f64 {
        time_of(frame, self.fps)
    }
}

/// Form of frames that are drawn as those of another version.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct FrameForm {
    /// Size, in pixels.
    pub(crate) size: [u32; 2],
    /// True if the frames of a scene are seen from its own camera, and not from the window's.
    pub(crate) by_scene: bool,
}

/// Frames that other tools need.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Demands {
    /// Numbers of frames that are drawn at rest too.
    pub(crate) frames: Vec<i32>,
    /// True if the frame is to be shown in place of the picture at rest too.
    pub(crate) covers: bool,
}

/// Time of a frame, in seconds, rounded to microseconds as times in files are.
pub(crate) fn time_of(frame: i32, fps: f64) -> f64 {
    tidy(f64::from(frame) / fps)
}

/// Frame that begins at a time; `None` for a time between two.
pub(crate) fn frame_at(time: f64, fps: f64) -> Option<i32> {
    let frame = (time * fps).round();
    let is_there = (frame / fps - time).abs() < 2e-6 && frame.abs() < f64::from(i32::MAX);
    is_there.then_some(frame as i32)
}

/// View that frames are seen in.
#[derive(Clone, PartialEq)]
pub(crate) struct FrameView {
    /// View of the window; where frames are seen from a camera, only what that leaves to the
    /// window: the mesh and the backdrop.
    pub(crate) orbit: Orbit,
    /// True if frames are seen from the camera of the scene or of the shot over it, which may move.
    pub(crate) by_camera: bool,
}

/// All that frames depend on beside their time.
#[derive(Clone, PartialEq)]
struct FrameBasis {
    document: DocumentNumber,
    picture: PictureRevision,
    view: FrameView,
    folder: PathBuf,
    size: [u32; 2],
    fps: f64,
}

/// Frame on the screen.
struct ShownFrame {
    frame: i32,
    image: Arc<ColorImage>,
    texture: TextureHandle,
}

/// Frames of the range, kept and drawn ahead.
pub(crate) struct Playback {
    /// Thread that draws; none without a GPU.
    worker: Option<Worker<FrameRequest, FrameAnswer>>,
    cache: FrameCache<ColorImage>,
    transport: Option<Transport>,
    basis: Option<FrameBasis>,
    basis_number: RequestNumber,
    /// True while the frames of the range are drawn although nothing plays.
    is_filling: bool,
    shown: Option<ShownFrame>,
    rate: ShownRate,
    /// Seconds that the last frames took to be drawn, smoothed.
    seconds: f64,
    /// Number of frames that were drawn.
    drawn: u64,
    /// Form of the frames where it is not the picture's.
    form: Option<FrameForm>,
    /// Problems of the last frame.
    problems: Vec<Diagnostic>,
    /// Divisor of the memory, part of which the frames of another version may take.
    others_share: usize,
    /// True if the picture was shown in the last frame of the window: else no frame is drawn.
    is_seen: bool,
}

impl Playback {
    fn new(worker: Option<Worker<FrameRequest, FrameAnswer>>) -> Self {
        Self {
            worker,
            cache: FrameCache::new(DEFAULT_FRAME_MEMORY as usize * MIB),
            transport: None,
            basis: None,
            basis_number: RequestNumber::default(),
            is_filling: false,
            shown: None,
            rate: ShownRate::default(),
            seconds: 0.0,
            drawn: 0,
            form: None,
            problems: Vec::new(),
            others_share: 1,
            is_seen: false,
        }
    }

    /// Frames of a timeline of ten frames, which a test has without drawing them.
    #[cfg(test)]
    pub(super) fn holding(session: &Session, frames: &[i32], form: Option<FrameForm>) -> Self {
        let mut playback = Self::new(None);
        playback.share(form);
        playback.notice_changes(session, [2, 2], 24.0);
        let round = order::Round::new([0, 9], order::LoopMode::Loop);
        let order = PlayOrder { round, step: 0 };
        for &frame in frames {
            let color = eframe::egui::Color32::from_gray(frame as u8);
            let image = Arc::new(ColorImage::filled([2, 2], color));
            playback.cache.insert(frame, (cache::PictureKey(frame as u128), image, 16), order);
        }
        playback.follow(Some(Transport {
            order,
            fps: 24.0,
            wanted_rate: 24.0,
            pace: PlayPace::RealTime,
            is_playing: false,
            is_scrubbed: false,
        }));
        playback
    }

    /// True if frames can be drawn.
    pub(crate) fn can_draw(&self) -> bool {
        self.worker.is_some()
    }

    pub(crate) fn cache(&self) -> &FrameCache<ColorImage> {
        &self.cache
    }

    pub(crate) fn transport(&self) -> Option<&Transport> {
        self.transport.as_ref()
    }

    /// Number that changes with all that frames depend on beside their time.
    pub(crate) fn basis(&self) -> RequestNumber {
        self.basis_number
    }

    pub(crate) fn problems(&self) -> &[Diagnostic] {
        &self.problems
    }

    /// Number of frames that were drawn; equal ones count once.
    pub(crate) fn drawn(&self) -> u64 {
        self.drawn
    }

    /// Frames that were really shown a second, of the last second of playing.
    pub(crate) fn shown_rate(&self, now: f64) -> Option<f64> {
        self.rate.per_second(now)
    }

    /// True if frames are shown in place of the picture, as the playhead moves.
    pub(crate) fn is_moving(&self) -> bool {
        self.transport.is_some_and(|transport| transport.is_playing || transport.is_scrubbed)
    }

    /// True if a frame can be shown, or none will be drawn that is worth waiting for.
    pub(crate) fn is_ready(&self, frame: i32) -> bool {
        !self.is_seen || !self.can_draw() || !self.problems.is_empty() || self.cache.holds(frame)
    }

    /// True while frames are drawn at rest.
    pub(crate) fn is_filling(&self) -> bool {
        self.is_filling
    }

    /// Begins to draw the frames of the range at rest, or stops.
    pub(crate) fn fill(&mut self, is_filling: bool) {
        self.is_filling = is_filling && self.can_draw();
        if self.cache.frames().next().is_none() {
            // Changes are not noticed while there is nothing to give up: this is a beginning.
            self.basis = None;
        }
    }

    /// Goes on to draw the frames of the range at rest after a change that ended that.
    pub(crate) fn fill_again(&mut self) {
        self.is_filling = self.can_draw();
    }

    /// Takes the timeline's playhead of this frame of the window; `None` where there is no
    /// timeline.
    pub(crate) fn follow(&mut self, transport: Option<Transport>) {
        if transport.is_none_or(|transport| !transport.is_playing) {
            self.rate.rest();
        }
        if transport.is_none() {
            self.is_filling = false;
        }
        self.is_seen = false;
        self.transport = transport;
    }

    /// Sets the memory that all frames take, in MiB.
    pub(crate) fn set_memory(&mut self, mib: u32) {
        let limit = (mib.max(1) as usize).saturating_mul(MIB) / self.others_share;
        match self.transport {
            Some(Transport { order, .. }) => self.cache.set_limit(limit, order),
            None => self.cache = FrameCache::new(limit),
        }
    }

    /// Memory that all frames take, in bytes.
    pub(crate) fn memory_bytes(&self) -> usize {
        self.cache.limit() * self.others_share
    }

    /// Memory that all frames take, in MiB.
    pub(crate) fn memory(&self) -> u32 {
        u32::try_from(self.memory_bytes() / MIB).unwrap_or(u32::MAX)
    }

    /// Gives half of the memory to the frames of another version, or takes it back; frames are
    /// drawn as those are.
    pub(crate) fn share(&mut self, drawn_as: Option<FrameForm>) {
        let memory = self.memory();
        self.others_share = if drawn_as.is_some() { 2 } else { 1 };
        self.set_memory(memory);
        if self.form != drawn_as {
            self.form = drawn_as;
            // Frames of another form are no edit: filling goes on.
            self.basis = None;
        }
    }

    /// Form of the frames where it is not the picture's.
    pub(crate) fn form(&self) -> Option<FrameForm> {
        self.form
    }

    /// Drops all frames.
    pub(crate) fn clear(&mut self) {
        self.cache.clear();
        self.is_filling = false;
        self.basis = None;
    }

    /// Takes frames that are drawn, requests the next one, and returns the frame to be shown in
    /// place of the picture, whose size is given in pixels.
    pub(crate) fn update(
        &mut self,
        ui: &Ui,
        session: &Session,
        size: [u32; 2],
        demands: &Demands,
    ) -> Option<&TextureHandle> {
        self.is_seen = true;
        let newest = self.take();
        let transport = self.transport?;
        let is_wanted = self.is_moving() || self.is_filling || !demands.frames.is_empty();
        if !is_wanted && self.cache.frames().next().is_none() {
            self.shown = None;
            return None;
        }
        let size = self.form.map_or(size, |form| form.size);
        self.notice_changes(session, size, transport.fps);
        if is_wanted {
            self.ask(session, size, &transport, &demands.frames);
        }
        let order = transport.order;
        if !self.is_moving() {
            // A playhead between two frames has no frame to be shown.
            let here = frame_at(session.view.time, transport.fps) == Some(order.frame());
            if !(demands.covers && here && self.cache.holds(order.frame())) {
                self.shown = None;
                return None;
            }
        }
        let frame = self.nearest(order).or(newest.filter(|_| transport.is_playing));
        if let Some(frame) = frame {
            self.show(ui, frame, transport.is_playing);
        }
        let is_there = self.cache.holds(order.frame()) || transport.is_playing;
        self.shown.as_ref().filter(|_| is_there).map(|shown| &shown.texture)
    }

    /// Size of the frames, in pixels.
    pub(crate) fn frame_size(&self) -> Option<[u32; 2]> {
        self.basis.as_ref().map(|basis| basis.size)
    }

    /// Takes frames that are drawn; gives the newest.
    fn take(&mut self) -> Option<(i32, Arc<ColorImage>)> {
        let answers = self.worker.as_ref().map(Worker::answers).unwrap_or_default();
        let mut newest = None;
        for FrameAnswer { basis, frame, result, seconds } in answers {
            if let Some(seconds) = seconds {
                self.drawn += 1;
                self.seconds += (seconds - self.seconds) * if self.drawn == 1 { 1.0 } else { 0.3 };
            }
            match result {
                Ok((key, image)) => {
                    self.problems.clear();
                    newest = Some((frame, image.clone()));
                    if let (true, Some(of)) = (basis == self.basis_number, &self.transport) {
                        let bytes = bytes_of(&image);
                        self.cache.insert(frame, (key, image, bytes), of.order);
                    }
                }
                Err(problems) => {
                    // The same frame would fail again.
                    self.is_filling = false;
                    self.problems = problems;
                }
            }
        }
        newest
    }

    /// Gives up all frames once anything that they depend on has changed.
    fn notice_changes(&mut self, session: &Session, size: [u32; 2], fps: f64) {
        let basis = FrameBasis {
            document: session.revisions().document,
            picture: session.revisions().picture,
            view: self.view(session),
            folder: session.look.folder(),
            size,
            fps,
        };
        if self.basis.as_ref() != Some(&basis) {
            let is_first = self.basis.is_none();
            self.basis = Some(basis);
            self.basis_number.advance();
            self.cache.retire();
            self.problems.clear();
            self.is_filling &= is_first;
        }
    }

    /// View that frames are drawn in.
    pub(crate) fn view(&self, session: &Session) -> FrameView {
        let by_scene = self.form.is_some_and(|form| form.by_scene);
        let by_camera = session.follows_shot() || by_scene && session.open_scene().is_some();
        let window = &session.view.orbit;
        let orbit = match by_camera {
            // A camera that moves is the same view.
            true => Orbit {
                mesh: window.mesh.clone(),
                z_is_up: window.z_is_up,
                backdrop: window.backdrop,
                ..Orbit::default()
            },
            false => window.clone(),
        };
        FrameView { orbit, by_camera }
    }

    fn ask(&mut self, session: &Session, size: [u32; 2], transport: &Transport, demands: &[i32]) {
        let Some(worker) = &self.worker else { return };
        // Problems stay until something changes: the same frame is not tried again and again.
        if worker.owes() || session.is_compiling() || !self.problems.is_empty() {
            return;
        }
        if size.contains(&0) {
            return;
        }
        let Some(frame) = self.next(size, transport, demands) else {
            self.is_filling = false;
            return;
        };
        let Some(showing) = session.showing() else { return };
        let mut snapshot = session.snapshot_of(showing.look.clone());
        snapshot.time = session.exact_time(transport.time(frame));
        snapshot.by_camera = self.view(session).by_camera;
        let basis = self.basis_number;
        worker.request(|_| FrameRequest { basis, frame, showing, snapshot, size });
    }

    /// Frame to be drawn next.
    fn next(&self, size: [u32; 2], transport: &Transport, demands: &[i32]) -> Option<i32> {
        let order = transport.order;
        let bytes = size[0] as usize * size[1] as usize * 4;
        let is_missing = |frame: &i32| !self.cache.holds(*frame);
        let room = |frame: &i32| self.cache.has_room(*frame, bytes, order);
        if !transport.is_playing {
            let now = Some(order.frame()).filter(|_| transport.is_scrubbed && self.is_filling);
            let demanded = now.into_iter().chain(demands.iter().copied());
            let next = demanded.filter(is_missing).find(room);
            let fills = || self.cache.next_missing(bytes, order);
            return next.or_else(|| self.is_filling.then(fills).flatten());
        }
        // A frame that takes long is begun so much earlier, that it is shown at its time.
        let ahead = match transport.pace {
            PlayPace::RealTime => (self.seconds * transport.wanted_rate).ceil() as u32,
            PlayPace::EveryFrame => 0,
        };
        let then = PlayOrder { step: order.step.saturating_add(ahead), ..order };
        let next = then.upcoming().find(is_missing)?;
        Some(next).filter(room)
    }

    /// Frame of now, or else the last one that is kept of those just before.
    fn nearest(&self, order: PlayOrder) -> Option<(i32, Arc<ColorImage>)> {
        let length = order.round.length();
        let mut steps = (0..length.min(24)).map(|back| (order.step + length - back) % length);
        steps.find_map(|step| {
            let frame = order.round.frame(step);
            Some((frame, self.cache.get(frame)?.clone()))
        })
    }

    fn show(&mut self, ui: &Ui, (frame, image): (i32, Arc<ColorImage>), is_playing: bool) {
        if is_playing && self.shown.as_ref().is_none_or(|shown| shown.frame != frame) {
            self.rate.shown(ui.input(|input| input.time));
        }
        let options = TextureOptions::LINEAR;
        match &mut self.shown {
            Some(shown) => {
                shown.frame = frame;
                if !Arc::ptr_eq(&shown.image, &image) {
                    shown.texture.set(image.clone(), options);
                    shown.image = image;
                }
            }
            none => {
                let texture = ui.ctx().load_texture("frame", image.clone(), options);
                *none = Some(ShownFrame { frame, image, texture });
            }
        }
    }
}

/// Memory of a picture, in bytes.
pub(crate) fn bytes_of(image: &ColorImage) -> usize {
    image.pixels.len() * size_of::<eframe::egui::Color32>()
}

impl BackgroundJobs for Playback {
    fn is_busy(&self) -> bool {
        self.worker.as_ref().is_some_and(Worker::is_busy)
    }

    fn wait(&self) {
        if let Some(worker) = &self.worker {
            worker.wait();
        }
    }
}

impl PictureTools {
    /// Frames of the timeline's range.
    pub(crate) fn playback(&mut self) -> &mut Playback {
        self.of_mut::<Playback>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Edit, Marker, SceneEdit, Shot, ShotEdit, ShotMarker};
    use crate::library::Library;
    use crate::state::session::shot::tests::put_shot;

    /// Frames that are kept after a session was changed, of one that was kept before.
    fn kept_after(session: &mut Session, change: impl FnOnce(&mut Session)) -> usize {
        let mut playback = Playback::holding(session, &[0], None);
        change(session);
        playback.notice_changes(session, [2, 2], 24.0);
        playback.cache.frames().count()
    }

    #[test]
    fn frames_stay_while_only_names_and_markers_change() {
        let folder = tempfile::tempdir().unwrap();
        let path = put_shot(folder.path(), "[]");
        let new = || Session::new(Arc::new(Library::built_in().clone()), || {});
        let marker = || Marker { time: 1.0, name: "hit".to_owned(), unknown: Default::default() };

        let mut look = new();
        let markers = Edit::SetMarkers { markers: vec![marker()] };
        assert_eq!(kept_after(&mut look, |it| it.apply(markers, None).unwrap()), 1);
        assert_eq!(kept_after(&mut look, |it| assert!(it.undo())), 1);
        assert_eq!(kept_after(&mut look, |it| assert!(it.redo())), 1);
        let darker = Edit::SetMaxError { max_error: 0.5 };
        assert_eq!(kept_after(&mut look, |it| it.apply(darker, None).unwrap()), 0);
        assert_eq!(kept_after(&mut look, |it| assert!(it.undo())), 0);

        let mut scene = new();
        scene.open(&folder.path().join("scene.json")).unwrap();
        let markers = SceneEdit::SetMarkers { markers: vec![marker()] };
        assert_eq!(kept_after(&mut scene, |it| it.apply_to_scene(markers, None).unwrap()), 1);
        assert_eq!(kept_after(&mut scene, |it| assert!(it.undo())), 1);
        let backdrop = SceneEdit::SetBackdrop { color: Some([0.0, 0.0, 0.5, 1.0]) };
        assert_eq!(kept_after(&mut scene, |it| it.apply_to_scene(backdrop, None).unwrap()), 0);

        let mut shot = new();
        shot.open(&path).unwrap();
        let hit = ShotMarker { frame: 6, name: "hit".to_owned(), unknown: Default::default() };
        let named = ShotEdit::Group {
            edits: vec![
                ShotEdit::SetShotMarkers { markers: vec![hit] },
                ShotEdit::SetShotName { name: "sh010".to_owned() },
            ],
        };
        assert_eq!(kept_after(&mut shot, |it| it.apply_to_shot(named, None).unwrap()), 1);
        let shot_of = |session: &Session| -> Shot { session.shot().unwrap().shot().clone() };
        assert_eq!((shot_of(&shot).name.as_str(), shot_of(&shot).markers.len()), ("sh010", 1));
        assert_eq!(kept_after(&mut shot, |it| assert!(it.undo())), 1);
        assert_eq!(kept_after(&mut shot, |it| assert!(it.redo())), 1);
        let step = ShotEdit::SetStep { step: Some(2) };
        assert_eq!(kept_after(&mut shot, |it| it.apply_to_shot(step, None).unwrap()), 0);
        assert_eq!(kept_after(&mut shot, |it| assert!(it.undo())), 0);
        // A file of the same content is no change, of whichever document.
        assert_eq!(kept_after(&mut shot, |it| it.save_shot_as(&path).unwrap()), 1);
        let file = folder.path().join("scene.json");
        assert_eq!(kept_after(&mut scene, |it| it.save_scene_as(&file).unwrap()), 1);
    }

    #[test]
    fn frames_and_times_go_both_ways() {
        for fps in [8.0, 23.976, 24.0, 60.0] {
            for frame in [-7, 0, 1, 13, 100_001] {
                assert_eq!(frame_at(time_of(frame, fps), fps), Some(frame), "{frame} at {fps}");
            }
        }
        assert_eq!(frame_at(0.51, 24.0), None, "between two frames");
    }
}
