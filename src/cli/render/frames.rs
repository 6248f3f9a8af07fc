//! `chiaro render --frames`: many frames, each in a file of its own.
//!
//! One plans the next frame and one draws, while others write the last frames and read them back:
//! as many as there are cores and memory for. What is whole from a run before is kept, and a frame
//! that would be the same picture as another is not drawn.

mod changes;
mod writers;

use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::time::SystemTime;

use changes::FileWatch;
use serde_json::{Value as Json, json};
use writers::write_all;

use super::format::PictureFormat;
use super::progress::ProgressLines;

use super::{Stage, blended_in, layers_in};
use crate::clock::Clock;
use crate::diag::Diagnostic;
use crate::files::Outputs;
use crate::film::exr::{ExrHeader, FrameStamp};
use crate::film::{
    DisplayView, DrawnLayers, FrameList, FramePattern, FrameRate, LayeredPlan, PlanHasher,
};
use crate::frame::{Executor, PlanOptions, ShadedShare};
use crate::output::{Output, refuse_warnings};
use crate::threads;

/// Frames, and where they go.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sequence<'a> {
    pub(super) frames: &'a FrameList,
    pub(super) rate: FrameRate,
    pub(super) pattern: &'a FramePattern,
    pub(super) format: PictureFormat,
    /// Files of a run before.
    pub(super) earlier: &'a EarlierFrames,
    /// The view by which light is shown; `None` for the curve of sRGB.
    pub(super) view: Option<&'a DisplayView>,
    pub(super) is_strict: bool,
    /// True if each frame is told as a line of JSON.
    pub(super) has_json: bool,
    /// Lines that tell a farm how far the frames are.
    pub(super) progress: Option<ProgressLines>,
}

/// Files of a run before, read once.
#[derive(Debug, Default)]
pub(super) struct EarlierFrames {
    /// The plan of each that is whole, and how it was found.
    whole: HashMap<PathBuf, (String, Option<FileStamp>)>,
    /// Files that are not replaced, such as damaged ones and those of somebody else, with the
    /// reason.
    refused: HashMap<PathBuf, Diagnostic>,
}

/// Length of a file and the time of its last change: another one was written in between.
type FileStamp = (u64, SystemTime);

fn stamp(file: &Path) -> Option<FileStamp> {
    let data = std::fs::metadata(file).ok()?;
    Some((data.len(), data.modified().ok()?))
}

impl EarlierFrames {
    /// Reads the files of frames that are there, and finds those that may not be replaced.
    ///
    /// # Errors
    /// As [`Outputs::check`], of the first file, where none of all may be replaced.
    pub(super) fn read(
        frames: &FrameList,
        pattern: &FramePattern,
        format: PictureFormat,
        outputs: &Outputs,
    ) -> Result<Self, Diagnostic> {
        let mut earlier = Self::default();
        for &frame in frames.frames() {
            let file = pattern.path(frame);
            // Before the file: what comes in between is read again.
            let stamp = stamp(&file);
            let mut plan = None;
            let checked = outputs.check_looking(&file, format.kind(), |bytes| {
                plan = format.plan_of(bytes);
                plan.is_some()
            });
            match checked {
                Ok(()) => earlier.whole.extend(plan.map(|plan| (file, (plan, stamp)))),
                Err(problem) => drop(earlier.refused.insert(file, problem)),
            }
        }
        if earlier.refused.len() < frames.frames().len() {
            return Ok(earlier);
        }
        let mut files = frames.frames().iter().map(|frame| pattern.path(*frame));
        files.find_map(|file| earlier.refused.remove(&file)).map_or(Ok(earlier), Err)
    }

    /// True if the file is whole and of the plan. One that is another since it was read, such as a
    /// frame that another machine has drawn, is read again.
    fn has(&self, file: &Path, plan: &str, format: PictureFormat) -> bool {
        let now = stamp(file);
        match self.whole.get(file) {
            Some((known, then)) if now.is_some() && *then == now => known == plan,
            _ => {
                now.is_some()
                    && std::fs::read(file)
                        .is_ok_and(|bytes| format.plan_of(&bytes).as_deref() == Some(plan))
            }
        }
    }
}

/// Work on a frame: a plan, or the picture that is drawn of it.
struct Frame<T> {
    frame: i32,
    file: PathBuf,
    header: ExrHeader,
    state: FrameState<T>,
    seconds: Seconds,
    /// Share of the picture that was shaded; `None` where that is not counted.
    shaded: Option<ShadedShare>,
}

/// Fate of a frame.
enum FrameState<T> {
    /// The file of a run before is whole, and of the same plan.
    Kept,
    /// Another frame is the same picture.
    Equal { frame: i32, file: PathBuf },
    /// Neither: the plan, or the picture.
    New(T),
    /// The frame cannot be planned, drawn or written.
    Failed(Vec<Diagnostic>),
}

type PlannedFrame = Frame<Box<LayeredPlan>>;
type DrawnFrame = Frame<DrawnLayers>;

/// Time that was spent on a frame, or on all, in seconds.
#[derive(Clone, Copy, Debug, Default)]
struct Seconds {
    planning: f64,
    drawing: f64,
    writing: f64,
}

/// Sums over all frames.
#[derive(Debug, Default)]
struct Summary {
    drawn: usize,
    equal: usize,
    kept: usize,
    /// Frames that failed, and the first reason.
    failed: Vec<i32>,
    reason: String,
    seconds: Seconds,
    /// Drawn frames of which it is counted what was shaded, and the sum of their shares of pixels.
    shaded: (usize, f64),
    /// Number of threads that write.
    writers: usize,
}

/// Number of frames that may fail one after another, with none whole between them, before the
/// others are given up: a full disk or a lost GPU will not have them either.
const MOST_FAILED: usize = 8;

/// Draws frames with what was opened. A frame that fails keeps no other from being drawn.
///
/// # Errors
/// `frames-failed` with the frames that cannot be planned, drawn or written, each of which was told
/// with its own reasons, and `files-changed` with the files that are others by now than those that
/// were read.
pub(super) fn draw(
    sequence: Sequence<'_>,
    stage: Stage,
    outputs: Outputs,
    executor: &mut dyn Executor,
    output: &Output,
) -> Result<(), Vec<Diagnostic>> {
    let clock = Clock::start();
    let (to_draw, planned) = sync_channel(1);
    let (to_write, drawn) = sync_channel(1);
    let name = executor.name();
    executor.keep_pixels();
    // Each part owns its ends of the channels, so that the others end when it does.
    let (watch, summary) = in_parallel(
        move || plan_all(sequence, stage, &to_draw, output),
        move || draw_all(&planned, &to_write, executor, output),
        move || write_all(sequence, &outputs, drawn, output),
    )?;
    output.message(&summary.text(clock.seconds(), &name));
    let problems: Vec<Diagnostic> =
        watch.problem().into_iter().chain(summary.problem(sequence.frames)).collect();
    if problems.is_empty() { Ok(()) } else { Err(problems) }
}

/// Runs the three parts, the second one on this thread. Whichever ends first ends the others, for
/// nobody takes what they make.
#[expect(
    clippy::disallowed_methods,
    reason = "the command line's own threads, as many as there are parts"
)]
fn in_parallel<P: Send, W: Send>(
    plan: impl FnOnce() -> P + Send,
    draw: impl FnOnce(),
    write: impl FnOnce() -> W + Send,
) -> Result<(P, W), Vec<Diagnostic>> {
    let no_thread = |error: std::io::Error| {
        vec![Diagnostic::error("no-thread", format!("the system starts no thread: {error}"))]
    };
    std::thread::scope(|scope| {
        let planner = threads::builder("plan").spawn_scoped(scope, plan).map_err(no_thread)?;
        let writer = threads::builder("write").spawn_scoped(scope, write).map_err(no_thread)?;
        draw();
        let planned = planner.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        let written = writer.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        Ok((planned, written))
    })
}

/// Plans frame after frame, and watches the files that they are of; a frame that cannot be planned
/// is handed on as failed. Ends early where nobody draws any more.
fn plan_all(
    sequence: Sequence<'_>,
    mut stage: Stage,
    to_draw: &SyncSender<PlannedFrame>,
    output: &Output,
) -> FileWatch {
    let mut watch = FileWatch::new(stage.files.clone());
    let mut hasher = PlanHasher::default();
    let mut seen: HashMap<String, (i32, PathBuf)> = HashMap::new();
    let mut told = HashSet::new();
    let blended_in = blended_in(stage.setup.looks.iter().map(|worn| &worn.look));
    for &frame in sequence.frames.frames() {
        watch.look(frame, output);
        let clock = Clock::start();
        let file = sequence.pattern.path(frame);
        let options = PlanOptions { time: sequence.rate.time(frame), ..stage.options.clone() };
        let mut warnings = Vec::new();
        let planned = match sequence.earlier.refused.get(&file) {
            Some(problem) => Err(vec![problem.clone()]),
            None => stage.plan(&options).map(|plan| plan.tell(&mut warnings)),
        };
        let strict =
            |plan| refuse_warnings(sequence.is_strict, &mut warnings).map(|()| Box::new(plan));
        let plan = match planned.and_then(strict) {
            Ok(plan) => plan,
            Err(problems) => {
                let state = FrameState::Failed(problems);
                let (header, seconds) = (ExrHeader::default(), Seconds::default());
                if to_draw
                    .send(Frame { frame, file, header, state, seconds, shaded: None })
                    .is_err()
                {
                    break;
                }
                continue;
            }
        };
        warnings.retain(|warning| told.insert(warning.to_string()));
        output.diagnostics(&warnings);
        let content = hasher.hash_layered(&plan);
        let stamp = FrameStamp { frame, rate: sequence.rate };
        let header = ExrHeader {
            view: Some(plan.picture().view),
            stamp: Some(stamp),
            plan: key(&content, sequence.format, sequence.view, sequence.rate),
            blended_in: blended_in.clone(),
            layers_in: layers_in(&plan, &blended_in),
            attributes: plan.attributes(),
        };
        let state = if sequence.earlier.has(&file, &header.plan, sequence.format) {
            FrameState::Kept
        } else if let Some((frame, file)) = seen.get(&content).cloned() {
            FrameState::Equal { frame, file }
        } else {
            FrameState::New(plan)
        };
        seen.entry(content).or_insert_with(|| (frame, file.clone()));
        let seconds = Seconds { planning: clock.seconds(), ..Seconds::default() };
        if to_draw.send(Frame { frame, file, header, state, seconds, shaded: None }).is_err() {
            break;
        }
    }
    watch
}

/// Key of a file: the plan that it is of, and how it was stored.
pub(super) fn key(
    content: &str,
    format: PictureFormat,
    view: Option<&DisplayView>,
    rate: FrameRate,
) -> String {
    let FrameRate { frames, seconds } = rate;
    match format {
        PictureFormat::Png => match view {
            Some(view) => format!("{content} {}", view.key()),
            None => content.to_owned(),
        },
        PictureFormat::Exr(encoding) => format!(
            "{content} {:?} {:?} {frames}/{seconds}",
            encoding.samples, encoding.compression
        ),
    }
}

/// Draws the frames that are to be drawn, in their order. Ends early where nobody writes any more.
fn draw_all(
    planned: &Receiver<PlannedFrame>,
    to_write: &SyncSender<DrawnFrame>,
    executor: &mut dyn Executor,
    output: &Output,
) {
    let mut told = HashSet::new();
    for Frame { frame, file, header, state, mut seconds, mut shaded } in planned {
        let state = match state {
            FrameState::Kept => FrameState::Kept,
            FrameState::Equal { frame, file } => FrameState::Equal { frame, file },
            FrameState::New(plan) => {
                let clock = Clock::start();
                let mut warnings = executor.warnings(plan.picture());
                warnings.retain(|warning| told.insert(warning.to_string()));
                output.diagnostics(&warnings);
                let picture = output
                    .watch_async("drawing", async |progress| plan.draw(executor, progress).await);
                let picture = crate::wait(picture);
                seconds.drawing = clock.seconds();
                shaded = executor.shaded();
                picture.map_or_else(|problem| FrameState::Failed(vec![problem]), FrameState::New)
            }
            FrameState::Failed(problems) => FrameState::Failed(problems),
        };
        if to_write.send(Frame { frame, file, header, state, seconds, shaded }).is_err() {
            break;
        }
    }
}

impl DrawnFrame {
    /// The frame's fate, in a word.
    fn state(&self) -> &'static str {
        match self.state {
            FrameState::Kept => "kept",
            FrameState::Equal { .. } => "equal",
            FrameState::New(_) => "drawn",
            FrameState::Failed(_) => "failed",
        }
    }

    fn json(&self, rate: FrameRate) -> Json {
        let Seconds { planning, drawing, writing } = self.seconds;
        let mut told = json!({
            "frame": self.frame, "time": rate.time(self.frame),
            "file": self.file.display().to_string(), "state": self.state(),
            "plan": self.header.plan.split(' ').next(),
            "seconds": {"planning": planning, "drawing": drawing, "writing": writing},
        });
        match &self.state {
            FrameState::Equal { frame, .. } => told["to"] = json!(frame),
            FrameState::Failed(problems) => told["problems"] = json!(problems),
            FrameState::Kept | FrameState::New(_) => {}
        }
        if let Some(ShadedShare { objects, of, pixels }) = self.shaded {
            told["shaded"] = json!({"objects": objects, "of": of, "pixels": pixels});
        }
        told
    }

    fn text(&self) -> String {
        let file = self.file.display();
        let Seconds { planning, drawing, writing } = self.seconds;
        match &self.state {
            FrameState::Kept => format!("{file}: whole, and kept"),
            FrameState::Equal { frame, .. } => format!("{file}: as frame {frame}"),
            FrameState::New(_) => format!(
                "{file}: planned in {planning:.3} s, drawn in {drawing:.3} s, written in \
                 {writing:.3} s"
            ),
            FrameState::Failed(_) => format!("{file}: failed"),
        }
    }
}

impl Summary {
    /// Number of frames that are whole.
    fn count(&self) -> usize {
        self.drawn + self.equal + self.kept
    }

    /// Number of frames that are whole or failed.
    fn told(&self) -> usize {
        self.count() + self.failed.len()
    }

    /// The problem that frames failed, on one line; `None` where all are whole.
    fn problem(&self, asked: &FrameList) -> Option<Diagnostic> {
        const NAMED: usize = 12;
        let all = asked.frames().len();
        let (failed, rest) = (self.failed.len(), all.saturating_sub(self.told()));
        if failed == 0 {
            return None;
        }
        let named = FrameList::of(self.failed.iter().take(NAMED).copied().collect());
        let more =
            if failed > NAMED { format!(" and {} more", failed - NAMED) } else { String::new() };
        let given_up = match rest {
            0 => String::new(),
            rest => format!(", and {rest} were not tried after {MOST_FAILED} in a row"),
        };
        let reason = &self.reason;
        let message = format!("{failed} of {all} frames failed{given_up}: {named}{more}; {reason}");
        Some(Diagnostic::error("frames-failed", message))
    }

    fn add(&mut self, frame: &DrawnFrame) {
        *match &frame.state {
            FrameState::Kept => &mut self.kept,
            FrameState::Equal { .. } => &mut self.equal,
            FrameState::New(_) => &mut self.drawn,
            FrameState::Failed(problems) => {
                if let Some(first) = problems.first().filter(|_| self.failed.is_empty()) {
                    let file = first.place.file.as_deref();
                    let file = file.map_or_else(String::new, |file| format!("{file}: "));
                    self.reason = format!("{file}{}", first.message);
                }
                self.failed.push(frame.frame);
                return;
            }
        } += 1;
        if let Some(share) = frame.shaded {
            self.shaded = (self.shaded.0 + 1, self.shaded.1 + share.pixels);
        }
        self.seconds.planning += frame.seconds.planning;
        self.seconds.drawing += frame.seconds.drawing;
        self.seconds.writing += frame.seconds.writing;
    }

    /// The sum of it, and what took the time.
    fn text(&self, seconds: f64, executor: &str) -> String {
        let Self { drawn, equal, kept, failed, writers, .. } = self;
        let Seconds { planning, drawing, writing } = self.seconds;
        let writing = writing / (*writers).max(1) as f64;
        let parts = [("planning", planning), ("drawing", drawing), ("writing", writing)];
        let most = parts.into_iter().max_by(|(_, a), (_, b)| a.total_cmp(b));
        let (bound, longest) = most.unwrap_or_default();
        let frames = self.count();
        let an_hour = 3600.0 * frames as f64 / seconds.max(1e-9);
        let failed = match failed.len() {
            0 => String::new(),
            count => format!(", {count} failed"),
        };
        let shaded = match self.shaded {
            (0, _) => String::new(),
            (frames, pixels) => {
                format!(" ({:.0}% of their pixels)", 100.0 * pixels / frames as f64)
            }
        };
        format!(
            "{frames} frames on {executor}: {drawn} drawn{shaded}, {equal} equal to others, \
             {kept} kept{failed}; {seconds:.1} s, {an_hour:.0} frames an hour, bound by {bound} \
             ({longest:.1} s of it)"
        )
    }
}
