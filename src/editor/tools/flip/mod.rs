//! Flip book: the frames as they are now against those of another version, kept before an edit,
//! rendered to files, or of another document, which is drawn on the fly. A key shows the other
//! version while it is held, a divider wipes between both, or their difference is shown; each frame
//! that both have is compared, so that the one that is wrong is found.
//!
//! While a flip book is open the present frames are drawn in the size of the other version, and
//! both share the memory.

mod difference;
mod document;
mod show;
mod version;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use chiaro_locale::tr;
use eframe::egui::TextureHandle;

use super::playback::cache::FrameCache;
use super::playback::{Demands, FrameForm, Playback, bytes_of};
use super::{PictureContext, SwitchPlace, ToolRow};
use crate::film::FrameList;
use crate::render::Gpu;
use crate::state::display::PictureDisplay;
use crate::state::revision::{DocumentNumber, RequestNumber};
use crate::state::session::Session;
use crate::state::worker::{BackgroundJobs, Worker};
pub(crate) use difference::{DeltaKind, FrameDelta};
use document::DocumentView;
use version::{
    FlipAnswer, FlipRequest, FlipThread, FoundVersion, FrameFiles, KeyedPicture, OtherPicture,
    OtherVersion, VersionSource,
};

pub(super) const TOOL: ToolRow = ToolRow::new(
    SwitchPlace::Elsewhere,
    |parts| Box::new(FlipBook::new(parts.gpu.as_ref(), parts.wake())),
    |tools| tools.of::<FlipBook>().is_open(),
    // The choice is one with that of the comparison.
    |_, _, _| {},
)
.with_bar(|tools, ui, session| {
    let (flip, playback) = tools.pair::<FlipBook, Playback>();
    flip.bar(ui, session, playback);
})
.with_overlay(|tools, ui, PictureContext { session, rect, pointer, .. }, _| {
    let (flip, playback) = tools.pair::<FlipBook, Playback>();
    flip.over(ui, session, playback, *rect, pointer.is_some());
})
.with_jobs(|tools| tools.of::<FlipBook>());

/// Greatest number of frames that are looked through for one that is to be compared.
const MOST_FRAMES: usize = 50_000;

/// Way to show both versions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FlipView {
    /// One at a time.
    Flicker,
    /// Both, beside a divider.
    Wipe,
    /// Their difference.
    Difference,
}

/// Picture on the screen that was made of two frames.
struct FlipPicture<K> {
    of: K,
    texture: TextureHandle,
}

/// Document whose frames are compared, the outermost one: looks of a scene come and go.
#[derive(PartialEq)]
enum FlipSubject {
    File(Option<PathBuf>),
    Look(DocumentNumber),
}

impl FlipSubject {
    fn of(session: &Session) -> Self {
        match (session.shot(), session.open_scene()) {
            (Some(shot), _) => Self::File(Some(shot.path().to_path_buf())),
            (None, Some(open_scene)) => Self::File(open_scene.path().map(Path::to_path_buf)),
            (None, None) => Self::Look(session.revisions().document),
        }
    }
}

/// Version that waits beside the one that is compared with, and the form of frames like its own.
struct AsideVersion {
    version: OtherVersion,
    form: Option<FrameForm>,
}

/// Flip book against another version.
pub(crate) struct FlipBook {
    worker: Worker<FlipRequest, FlipAnswer>,
    version: Option<OtherVersion>,
    /// Versions that wait while another one is compared with; those that are read or drawn again
    /// hold no frames meanwhile.
    beside: Vec<AsideVersion>,
    /// Number of versions that were kept since the flip book was opened.
    kept: u32,
    /// Document whose frames are compared with it.
    subject: Option<FlipSubject>,
    /// Number of the version: an answer about another one does not count.
    number: RequestNumber,
    /// Files to be opened.
    opens: Option<PathBuf>,
    view: FlipView,
    /// True if the other version is shown, as long as no key is held.
    shows_other: bool,
    /// Position of the divider, as a part of the width.
    split: f32,
    /// Brightness of the difference, in stops.
    stops: i32,
    /// Greatest difference that is none, in steps of 1/255.
    pub(crate) threshold: u8,
    deltas: BTreeMap<i32, FrameDelta>,
    /// True once every frame of the range was compared: after a change they all are again.
    compares_all: bool,
    /// State of the documents and the view that the differences are of.
    basis: RequestNumber,
    other: Option<FlipPicture<KeyedPicture>>,
    difference: Option<FlipPicture<(KeyedPicture, KeyedPicture, i32)>>,
    problem: Option<String>,
    /// Exposure of the picture, in stops.
    pub(crate) exposure: f32,
    /// View that the light of files is shown by.
    display: Option<PictureDisplay>,
}

impl FlipBook {
    fn new(gpu: Option<&Gpu>, wake: impl Fn() + Send + 'static) -> Self {
        let mut thread = FlipThread::new(gpu);
        let run = async move |request| thread.run(request).await;
        Self {
            worker: Worker::waiting("flip book", wake, run),
            version: None,
            beside: Vec::new(),
            kept: 0,
            subject: None,
            number: RequestNumber::default(),
            opens: None,
            view: FlipView::Flicker,
            shows_other: false,
            split: 0.5,
            stops: 3,
            threshold: 2,
            deltas: BTreeMap::new(),
            compares_all: false,
            basis: RequestNumber::default(),
            other: None,
            difference: None,
            problem: None,
            exposure: 0.0,
            display: None,
        }
    }

    /// Shows the light of files and documents by a view, as the frames beside them are; kept frames
    /// stay as they were.
    pub(crate) fn show_by(&mut self, display: Option<&PictureDisplay>) {
        if self.display.as_ref() == display {
            return;
        }
        self.display = display.cloned();
        if let Some(version) = self.version.as_mut().filter(|version| !version.is_kept()) {
            version.frames.clear();
            self.deltas.clear();
            // Answers on their way are of the former view.
            self.number.advance();
        }
    }

    /// True if there is another version, or one is being opened.
    pub(crate) fn is_open(&self) -> bool {
        self.version.is_some() || self.opens.is_some() || self.problem.is_some()
    }

    /// Name of the other version.
    pub(crate) fn name(&self) -> Option<&str> {
        self.version.as_ref().map(|version| version.name.as_str())
    }

    /// Differences of the frames that were compared.
    pub(crate) fn deltas(&self) -> impl Iterator<Item = (i32, DeltaKind)> {
        self.deltas.iter().map(|(frame, delta)| (*frame, delta.kind))
    }

    /// Frames that differ by more than the threshold, with their differences.
    pub(crate) fn wrong(&self) -> impl Iterator<Item = (i32, DeltaKind)> {
        self.deltas().filter(|(_, kind)| kind.greatest() > self.threshold)
    }

    /// Frame with the greatest difference: the first one of several.
    pub(crate) fn greatest(&self) -> Option<i32> {
        let most =
            self.deltas().max_by(|(a, x), (b, y)| x.greatest().cmp(&y.greatest()).then(b.cmp(a)));
        most.filter(|(_, kind)| kind.greatest() > 0).map(|(frame, _)| frame)
    }

    /// Frames of a range that the other version does not have.
    pub(crate) fn lacking(&self, [first, last]: [i32; 2]) -> FrameList {
        let frames = || {
            let version = self.version.as_ref()?;
            let lacks = |frame: &i32| !version.has(*frame);
            Some((first..=last).take(MOST_FRAMES).filter(lacks).collect())
        };
        FrameList::of(frames().unwrap_or_default())
    }

    /// Number of frames of a range that the other version has, and that were not compared yet.
    pub(crate) fn uncompared(&self, [first, last]: [i32; 2]) -> usize {
        let Some(version) = &self.version else { return 0 };
        let is_open = |frame: &i32| {
            let is_done = self.deltas.contains_key(frame) || version.failed.contains_key(frame);
            version.has(*frame) && !is_done
        };
        (first..=last).take(MOST_FRAMES).filter(is_open).count()
    }

    /// Problems of files, with the number of the frame.
    pub(crate) fn failed(&self) -> impl Iterator<Item = (i32, &str)> {
        let failed = self.version.iter().flat_map(|version| &version.failed);
        failed.map(|(frame, problem)| (*frame, problem.message.as_str()))
    }

    /// Names of the versions that wait beside the one that is compared with.
    fn beside(&self) -> impl Iterator<Item = &str> {
        self.beside.iter().map(|aside| aside.version.name.as_str())
    }

    /// Memory of all frames that were kept, in bytes.
    fn kept_bytes(&self) -> usize {
        let beside = self.beside.iter().map(|aside| &aside.version);
        let kept = self.version.iter().chain(beside).filter(|version| version.is_kept());
        kept.map(|version| version.frames.bytes()).sum()
    }

    /// Keeps the frames of the cache as the other version; beside the one that they are compared
    /// with, where there is one.
    pub(crate) fn keep(&mut self, playback: &mut Playback) {
        let (Some(transport), Some(size)) = (playback.transport(), playback.frame_size()) else {
            return;
        };
        let order = transport.order;
        let half = playback.memory_bytes() / 2;
        // Frames that are read or drawn again need room; those that were kept stay.
        let room = match &self.version {
            Some(version) if !version.is_kept() => half / 2,
            _ => half,
        };
        let room = room.saturating_sub(self.kept_bytes());
        let frames = playback.cache().copy_within(room, order);
        if frames.bytes() == 0 {
            let problem = tr!("there is no memory for another version: close the flip book first");
            self.problem = Some(problem.to_owned());
            return;
        }
        self.kept += 1;
        let name = match self.kept {
            1 => tr!("Kept version").to_owned(),
            number => tr!("Kept version {number}"),
        };
        let by_scene = playback.form().is_some_and(|form| form.by_scene);
        let form = Some(FrameForm { size, by_scene });
        let left = half.saturating_sub(self.kept_bytes() + frames.bytes());
        let (source, failed) = (VersionSource::Kept, BTreeMap::new());
        let kept = OtherVersion { name, source, frames, size: Some(size), bytes: 0, failed };
        match &mut self.version {
            None => {
                self.begin(kept);
                playback.share(form);
            }
            Some(version) => {
                if !version.is_kept() {
                    version.frames.set_limit(left, order);
                }
                self.beside.push(AsideVersion { version: kept, form });
            }
        }
    }

    /// Keeps the frames of the cache, and compares with them.
    pub(crate) fn compare_kept(&mut self, playback: &mut Playback) {
        let (is_beside, before) = (self.version.is_some(), self.kept);
        self.keep(playback);
        if is_beside && self.kept > before {
            self.compare_with(self.beside.len() - 1, playback);
        }
    }

    /// Compares with one of the versions beside, and puts the present one there.
    fn compare_with(&mut self, index: usize, playback: &mut Playback) {
        if index >= self.beside.len() {
            return;
        }
        let AsideVersion { mut version, form } = self.beside.remove(index);
        self.put_beside(playback);
        if !version.is_kept() {
            let half = playback.memory_bytes() / 2;
            version.frames = FrameCache::new(half.saturating_sub(self.kept_bytes()));
        }
        self.begin(version);
        playback.share(form);
    }

    /// Puts the version that is compared with beside.
    fn put_beside(&mut self, playback: &Playback) {
        let Some(mut version) = self.version.take() else { return };
        if !version.is_kept() {
            version.frames.clear();
        }
        self.beside.push(AsideVersion { version, form: playback.form() });
    }

    /// Opens rendered frames, by a file of the sequence or its folder, or another document.
    pub(crate) fn open(&mut self, path: PathBuf) {
        self.opens = Some(path);
        self.problem = None;
    }

    /// Closes the flip book.
    pub(crate) fn close(&mut self, playback: &mut Playback) {
        (self.version, self.subject) = (None, None);
        self.beside.clear();
        self.kept = 0;
        self.opens = None;
        self.problem = None;
        self.deltas.clear();
        self.compares_all = false;
        (self.other, self.difference) = (None, None);
        self.number.advance();
        playback.share(None);
    }

    fn begin(&mut self, version: OtherVersion) {
        self.number.advance();
        self.version = Some(version);
        self.deltas.clear();
        self.compares_all = false;
        (self.other, self.difference) = (None, None);
        self.problem = None;
        self.shows_other = false;
    }

    /// Takes what was read and compared, requests the next frame, and returns the frames that the
    /// flip book needs at rest. `size` is the picture's, in pixels.
    pub(crate) fn update(
        &mut self,
        session: &Session,
        playback: &mut Playback,
        size: [u32; 2],
    ) -> Demands {
        for answer in self.worker.answers() {
            self.take(answer, playback, size);
        }
        if self.version.is_some() {
            let subject = FlipSubject::of(session);
            match &self.subject {
                Some(before) if *before != subject => self.close(playback),
                _ => self.subject = Some(subject),
            }
        }
        if let Some(path) = self.opens.take_if(|_| !self.worker.owes()) {
            self.worker.request(|_| FlipRequest::Open(path));
            return Demands::default();
        }
        let Some(transport) = playback.transport().copied() else { return Demands::default() };
        if self.version.is_none() {
            return Demands::default();
        }
        let is_whole = || self.uncompared(transport.order.round.range()) == 0;
        self.compares_all = self.compares_all || !self.deltas.is_empty() && is_whole();
        if self.basis != playback.basis() {
            self.basis = playback.basis();
            self.deltas.clear();
            if self.compares_all {
                playback.fill_again();
            }
        }
        self.look_from(session, playback, transport.fps);
        if !self.worker.owes()
            && let Some(request) = self.next(session, playback)
        {
            self.worker.request(|_| request);
        }
        Demands { frames: vec![transport.order.frame()], covers: true }
    }

    /// Gives up the frames of another document once they would be drawn in another view.
    fn look_from(&mut self, session: &Session, playback: &Playback, fps: f64) {
        let Some(OtherVersion { source, frames, size: Some(size), failed, .. }) = &mut self.version
        else {
            return;
        };
        let VersionSource::Document(_, before) = source else { return };
        let now = DocumentView::of(session, playback, *size, fps);
        if before.as_deref() != Some(&now) {
            *before = Some(Box::new(now));
            *frames = FrameCache::new(frames.limit());
            failed.clear();
            self.deltas.clear();
            self.number.advance();
        }
    }

    fn take(&mut self, answer: FlipAnswer, playback: &mut Playback, size: [u32; 2]) {
        match answer {
            FlipAnswer::Opened(Ok(found)) => {
                // What was kept cannot be had again.
                if self.version.as_ref().is_some_and(OtherVersion::is_kept) {
                    self.put_beside(playback);
                }
                let half = playback.memory_bytes() / 2;
                let frames = FrameCache::new(half.saturating_sub(self.kept_bytes()));
                let failed = BTreeMap::new();
                let (name, source, size) = match found {
                    FoundVersion::Files(FrameFiles { name, paths }) => {
                        (name, VersionSource::Files(paths), None)
                    }
                    FoundVersion::Document(path) => {
                        let name = path.file_name().unwrap_or_default().to_string_lossy();
                        (name.into_owned(), VersionSource::Document(path, None), Some(size))
                    }
                };
                self.begin(OtherVersion { name, source, frames, size, bytes: 0, failed });
                if let Some(size) = size {
                    playback.share(Some(FrameForm { size, by_scene: false }));
                    playback.fill(true);
                }
            }
            FlipAnswer::Opened(Err(problem)) => self.problem = Some(problem),
            FlipAnswer::Frame { version, frame, other, delta } if version == self.number => {
                let Some(version) = &mut self.version else { return };
                match other {
                    Ok((key, image)) => {
                        if version.size.is_none() {
                            let size = image.size.map(|side| side as u32);
                            version.size = Some(size);
                            playback.share(Some(FrameForm { size, by_scene: true }));
                            playback.fill(true);
                        }
                        if let Some(transport) = playback.transport() {
                            let bytes = bytes_of(&image);
                            version.bytes = version.bytes.max(bytes);
                            version.frames.insert(frame, (key, image, bytes), transport.order);
                        }
                    }
                    Err(problem) => {
                        version.failed.insert(frame, *problem);
                    }
                }
                self.deltas.extend(delta.map(|delta| (frame, delta)));
            }
            FlipAnswer::Frame { .. } => {}
        }
    }

    /// Frame that is to be read or compared next: the first one that is shown from now on.
    fn next(&self, session: &Session, playback: &Playback) -> Option<FlipRequest> {
        let (version, transport) = (self.version.as_ref()?, playback.transport()?);
        let order = transport.order;
        order.upcoming().take(MOST_FRAMES).find_map(|frame| {
            if !version.has(frame) || version.failed.contains_key(&frame) {
                return None;
            }
            let cache = playback.cache();
            let ours = cache.key(frame).zip(cache.get(frame).cloned());
            let known = version.frames.key(frame).zip(version.frames.get(frame).cloned());
            let delta = self.deltas.get(&frame);
            let is_compared = match (&ours, &known) {
                (None, _) => true,
                (Some((ours, _)), Some((key, _))) => {
                    delta.is_some_and(|delta| delta.of == [*ours, *key])
                }
                (Some((ours, _)), None) => delta.is_some_and(|delta| delta.of[0] == *ours),
            };
            let is_read = known.is_some() || !version.frames.has_room(frame, version.bytes, order);
            if is_compared && is_read {
                return None;
            }
            let other = match (known, &version.source) {
                (Some(picture), _) => OtherPicture::Known(picture),
                (None, VersionSource::Files(files)) => {
                    OtherPicture::File(files.get(&frame)?.clone(), self.display.clone())
                }
                (None, VersionSource::Document(path, view)) => {
                    let view = view.as_deref()?;
                    let frame =
                        view.frame(path, session, session.exact_time(transport.time(frame)));
                    OtherPicture::Document(Box::new(frame))
                }
                (None, VersionSource::Kept) => return None,
            };
            Some(FlipRequest::Frame { version: self.number, frame, ours, other })
        })
    }
}

impl BackgroundJobs for FlipBook {
    fn is_busy(&self) -> bool {
        self.worker.is_busy()
    }

    fn wait(&self) {
        self.worker.wait();
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::library::Library;

    fn session() -> Session {
        Session::new(Arc::new(Library::built_in().clone()), || {})
    }

    /// Frames that are drawn as rendered ones are, and a flip book against those.
    fn rendered(session: &Session) -> (Playback, FlipBook) {
        let form = Some(FrameForm { size: [2, 2], by_scene: true });
        let playback = Playback::holding(session, &[0, 1, 2], form);
        let mut flip = FlipBook::new(None, || {});
        flip.begin(OtherVersion {
            name: "a.####.png".to_owned(),
            source: VersionSource::Files(BTreeMap::from([(0, PathBuf::from("a.0000.png"))])),
            frames: FrameCache::new(playback.memory_bytes() / 2),
            size: Some([2, 2]),
            bytes: 0,
            failed: BTreeMap::new(),
        });
        (playback, flip)
    }

    #[test]
    fn a_version_is_kept_beside_the_one_that_is_compared_with() {
        let session = session();
        let (mut playback, mut flip) = rendered(&session);
        let form = playback.form();
        flip.keep(&mut playback);
        let told = |flip: &FlipBook| -> (String, Vec<String>) {
            let beside = flip.beside().map(str::to_owned).collect();
            (flip.name().unwrap_or_default().to_owned(), beside)
        };
        let (files, kept) = ("a.####.png".to_owned(), "Kept version".to_owned());
        assert_eq!(told(&flip), (files.clone(), vec![kept.clone()]));
        assert_eq!(playback.form(), form, "it goes on with the scene's camera");
        flip.compare_with(0, &mut playback);
        assert_eq!(told(&flip), (kept.clone(), vec![files.clone()]));
        assert_eq!((playback.form(), flip.lacking([0, 3])), (form, FrameList::of(vec![3])));
        assert_eq!(flip.uncompared([0, 3]), 3, "those that both have are still to be compared");
        // Chosen to be compared with, what is kept stands in front.
        flip.compare_kept(&mut playback);
        assert_eq!(told(&flip), ("Kept version 2".to_owned(), vec![files, kept]));
        assert!(flip.kept_bytes() + playback.cache().bytes() <= playback.memory_bytes());
        flip.close(&mut playback);
        assert!(!flip.is_open() && flip.beside().next().is_none() && playback.form().is_none());
    }

    #[test]
    fn it_ends_with_its_document() {
        let folder = tempfile::tempdir().unwrap();
        let put = |name: &str, text: &str| {
            let path = folder.path().join(name);
            std::fs::write(&path, text).unwrap();
            path
        };
        let scene = r#"{"chiaro": "scene", "objects": [{"id": "ball"}]}"#;
        let [one, other] = ["one.json", "other.json"].map(|name| put(name, scene));
        let shot = put("shot.json", r#"{"chiaro": "shot", "scene": "one.json", "frames": [1, 9]}"#);
        let look = put("look.json", r#"{"chiaro": "look", "nodes": []}"#);
        for [before, after] in [[&one, &other], [&one, &shot], [&shot, &one], [&look, &one]] {
            let mut session = session();
            session.open(before).unwrap();
            let mut playback = Playback::holding(&session, &[0, 1], None);
            let mut flip = FlipBook::new(None, || {});
            flip.keep(&mut playback);
            for _ in 0..2 {
                flip.update(&session, &mut playback, [2, 2]);
                assert!(flip.is_open(), "{}", before.display());
            }
            session.open(after).unwrap();
            flip.update(&session, &mut playback, [2, 2]);
            assert!(!flip.is_open() && playback.form().is_none(), "{}", after.display());
        }
    }
}
