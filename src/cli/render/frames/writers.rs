//! Writers: threads that encode drawn frames, write them and read them back, and tell each in its
//! order when it is whole.
//!
//! Deflate and checksums take longer than a graphics card needs to draw, so there are as many
//! writers as cores, and as many frames at once as memory is set aside for.

use std::collections::hash_map::Entry;
use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

use super::{DrawnFrame, Frame, FrameState, MOST_FAILED, Sequence, Summary};
use crate::clock::Clock;
use crate::diag::Diagnostic;
use crate::files::{self, Outputs};
use crate::film::DisplayView;
use crate::output::Output;
use crate::render::format::PictureFormat;
use crate::threads;

/// Greatest number of writers.
const MOST_WRITERS: usize = 16;

/// Bytes of drawn frames that are written at once; a frame by itself may be larger.
const MOST_BYTES: usize = 1 << 30;

/// Multiple of a frame's own bytes that it takes while it is encoded and read back: channels of
/// their own, the same as they are stored, and the file.
const COPIES: usize = 3;

/// Form of the files: their format, and the view by which light is shown.
type Form<'a> = (PictureFormat, Option<&'a DisplayView>);

/// State that writers share.
#[derive(Debug, Default)]
struct Progress {
    /// Files that are done, and true for those that are whole.
    done: HashMap<PathBuf, bool>,
    /// Bytes that are taken by the frames being written.
    bytes: usize,
    /// True where no more frames are taken: too many failed, or a writer came to grief.
    is_over: bool,
}

/// Frames that are still to be written, and how far the writers are.
struct Desk {
    drawn: Mutex<FrameQueue>,
    progress: Mutex<Progress>,
    changed: Condvar,
}

/// Frames as they are drawn, each with its place in the order.
struct FrameQueue {
    drawn: Receiver<DrawnFrame>,
    next: usize,
}

/// A frame that is whole, or failed, with its place in the order.
type WrittenFrame = (usize, DrawnFrame);

/// Writes frames, reads them back, and tells each, in their order, when it is whole or has failed.
pub(super) fn write_all(
    sequence: Sequence<'_>,
    outputs: &Outputs,
    drawn: Receiver<DrawnFrame>,
    output: &Output,
) -> Summary {
    let writers = threads::cores().saturating_sub(1).clamp(1, MOST_WRITERS);
    let mut summary = Summary { writers, ..Summary::default() };
    // Many frames fail for one reason, which is told once.
    let mut reasons: HashMap<String, i32> = HashMap::new();
    let told = |frame: &DrawnFrame| {
        summary.add(frame);
        if sequence.has_json {
            output.result(&frame.json(sequence.rate).to_string());
        }
        match &frame.state {
            FrameState::Failed(problems) => tell_failed(frame, problems, &mut reasons, output),
            _ if sequence.has_json => {}
            _ => output.message(&frame.text()),
        }
        if let Some(lines) = sequence.progress {
            let all = sequence.frames.frames().len();
            let is_whole = !matches!(frame.state, FrameState::Failed(_));
            lines.tell((frame.frame, is_whole), summary.told(), all, output);
        }
    };
    write_by(writers, (sequence.format, sequence.view), outputs, drawn, told);
    summary
}

/// Tells why a frame failed; of reasons that were told before, the frame that they were of.
fn tell_failed(
    failed: &DrawnFrame,
    problems: &[Diagnostic],
    reasons: &mut HashMap<String, i32>,
    output: &Output,
) {
    let Frame { frame, .. } = failed;
    let text = failed.text();
    let all: Vec<String> = problems.iter().map(ToString::to_string).collect();
    match reasons.entry(all.join("\n")) {
        Entry::Occupied(known) => output.message(&format!("{text}, as frame {}", known.get())),
        Entry::Vacant(new) => {
            output.message(&text);
            output.diagnostics(problems);
            new.insert(*frame);
        }
    }
}

/// True for a problem of a file that is there already, and of no other.
fn is_of_file(problem: &Diagnostic) -> bool {
    ["file-exists", "would-overwrite"].contains(&problem.code)
}

/// Writes frames by so many threads, and tells each, in their order, when it is whole or has
/// failed.
#[expect(
    clippy::disallowed_methods,
    reason = "the command line's own threads: they wait for pictures, as rayon's must not"
)]
fn write_by(
    writers: usize,
    form: Form<'_>,
    outputs: &Outputs,
    drawn: Receiver<DrawnFrame>,
    tell: impl FnMut(&DrawnFrame),
) {
    let desk = Desk {
        drawn: Mutex::new(FrameQueue { drawn, next: 0 }),
        progress: Mutex::default(),
        changed: Condvar::new(),
    };
    let (to_tell, told) = channel();
    std::thread::scope(|scope| {
        let mut started = 0;
        for _ in 0..writers {
            let (desk, outputs, to_tell) = (&desk, outputs.another(), to_tell.clone());
            let work = move || desk.write_frames(form, outputs, &to_tell);
            started += usize::from(threads::builder("write").spawn_scoped(scope, work).is_ok());
        }
        if started == 0 {
            // This thread is one that the system did start.
            desk.write_frames(form, outputs.another(), &to_tell);
        }
        drop(to_tell);
        desk.tell_all(told, tell);
    });
}

/// Room of a frame that is being written; given back whatever becomes of it, so that nobody waits
/// for ever.
struct Seat<'a> {
    desk: &'a Desk,
    file: PathBuf,
    bytes: usize,
    /// True once the writer is back from its work, with a whole file or without.
    is_done: bool,
    is_whole: bool,
}

impl Drop for Seat<'_> {
    fn drop(&mut self) {
        let mut progress = self.desk.progress();
        progress.bytes -= self.bytes;
        progress.is_over |= !self.is_done;
        progress.done.insert(std::mem::take(&mut self.file), self.is_whole);
        drop(progress);
        self.desk.changed.notify_all();
    }
}

impl Desk {
    /// Tells frames in their order. Where too many fail one after another, no more are taken.
    fn tell_all(&self, told: Receiver<WrittenFrame>, mut tell: impl FnMut(&DrawnFrame)) {
        let mut early = BTreeMap::new();
        let (mut next, mut in_a_row) = (0, 0);
        for (place, frame) in told {
            early.insert(place, frame);
            while let Some(frame) = early.remove(&next) {
                next += 1;
                in_a_row = match &frame.state {
                    // Somebody's files say nothing about the frames after them.
                    FrameState::Failed(problems) if problems.iter().any(is_of_file) => in_a_row,
                    FrameState::Failed(_) => in_a_row + 1,
                    _ => 0,
                };
                if in_a_row >= MOST_FAILED {
                    self.progress().is_over = true;
                }
                tell(&frame);
            }
        }
    }

    /// Writes frame after frame, until there are none or they are given up.
    fn write_frames(&self, form: Form<'_>, mut outputs: Outputs, tell: &Sender<WrittenFrame>) {
        while let Some((place, mut frame, bytes)) = self.take() {
            let file = frame.file.clone();
            let mut seat = Seat { desk: self, file, bytes, is_done: false, is_whole: false };
            let clock = Clock::start();
            let written = self.write(form, &mut outputs, &frame);
            frame.seconds.writing = clock.seconds();
            seat.is_done = true;
            seat.is_whole = written.is_ok() && !matches!(frame.state, FrameState::Failed(_));
            drop(seat);
            match (written, &mut frame.state) {
                (Err(problem), state) => *state = FrameState::Failed(vec![problem]),
                // The picture is not needed any more, and may be large.
                (Ok(()), FrameState::New(picture)) => {
                    *picture = crate::film::DrawnLayers::default();
                }
                (Ok(()), _) => {}
            }
            if tell.send((place, frame)).is_err() {
                break;
            }
        }
    }

    /// The next frame, with its place in the order and the bytes that it takes, when there is room
    /// for it; `None` after the last one.
    fn take(&self) -> Option<(usize, DrawnFrame, usize)> {
        // Held while waiting for room: one frame waits, and no more are taken.
        let mut waiting = self.drawn.lock().unwrap_or_else(PoisonError::into_inner);
        if self.progress().is_over {
            return None;
        }
        let frame = waiting.drawn.recv().ok()?;
        let bytes = match &frame.state {
            FrameState::New(drawn) => COPIES.saturating_mul(drawn.bytes()),
            FrameState::Kept | FrameState::Equal { .. } | FrameState::Failed(_) => 0,
        };
        let is_full = |progress: &mut Progress| {
            progress.bytes > 0 && progress.bytes.saturating_add(bytes) > MOST_BYTES
        };
        let progress = self.changed.wait_while(self.progress(), is_full);
        let mut progress = progress.unwrap_or_else(PoisonError::into_inner);
        progress.bytes = progress.bytes.saturating_add(bytes);
        let place = waiting.next;
        waiting.next += 1;
        Some((place, frame, bytes))
    }

    fn progress(&self) -> MutexGuard<'_, Progress> {
        self.progress.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Writes the file of a frame, whole or not at all, and reads it back.
    fn write(
        &self,
        (format, view): Form<'_>,
        outputs: &mut Outputs,
        frame: &DrawnFrame,
    ) -> Result<(), Diagnostic> {
        let Frame { file, header, .. } = frame;
        match &frame.state {
            FrameState::Kept | FrameState::Failed(_) => return Ok(()),
            FrameState::New(picture) => {
                outputs.write(file, format.kind(), &format.encode(picture, header, view)?)?;
            }
            FrameState::Equal { frame: number, file: first } => {
                if !self.wait_for(first) {
                    let message =
                        format!("this is the same picture as frame {number}, which failed");
                    let problem = Diagnostic::error("not-whole", message);
                    return Err(problem.in_file(file.display().to_string()));
                }
                match format {
                    PictureFormat::Png => {
                        outputs.check(file, format.kind())?;
                        files::link(first, file).map_err(|problem| *problem)?;
                    }
                    // The number and the time of a frame stand in its file.
                    PictureFormat::Exr(encoding) => {
                        let bytes = crate::film::exr::stamped(&read(first)?, header, encoding)?;
                        outputs.write(file, format.kind(), &bytes)?;
                    }
                }
            }
        }
        if format.plan_of(&read(file)?).as_ref() == Some(&header.plan) {
            return Ok(());
        }
        let message = "the frame was written and read back as another";
        Err(Diagnostic::error("not-whole", message)
            .in_file(file.display().to_string())
            .hint("the disk may be full or failing; the same command goes on with this frame"))
    }

    /// Waits until a frame that was taken before is done; true if its file is whole.
    fn wait_for(&self, file: &Path) -> bool {
        let is_open = |progress: &mut Progress| !progress.done.contains_key(file);
        let progress = self.changed.wait_while(self.progress(), is_open);
        let progress = progress.unwrap_or_else(PoisonError::into_inner);
        progress.done.get(file).is_some_and(|is_whole| *is_whole)
    }
}

fn read(file: &Path) -> Result<Vec<u8>, Diagnostic> {
    std::fs::read(file).map_err(|error| {
        Diagnostic::error("cannot-read", error.to_string()).in_file(file.display().to_string())
    })
}

#[cfg(test)]
mod tests {
    use std::sync::mpsc::sync_channel;

    use super::super::Seconds;
    use super::*;
    use crate::film::DrawnLayers;
    use crate::film::exr::{ExrEncoding, ExrHeader};
    use crate::frame::Picture;

    fn frame(folder: &Path, number: i32, state: FrameState<DrawnLayers>) -> DrawnFrame {
        let plan = match &state {
            FrameState::Equal { frame, .. } => *frame,
            _ => number,
        };
        Frame {
            frame: number,
            file: folder.join(format!("{number:04}.exr")),
            header: ExrHeader { plan: format!("plan {plan}"), ..ExrHeader::default() },
            state,
            seconds: Seconds::default(),
            shaded: None,
        }
    }

    fn drawn(number: i32) -> FrameState<DrawnLayers> {
        let rgba = vec![[number as f32 / 64.0, 0.5, 0.25, 1.0]; 24 * 16];
        let picture = Picture { size: [24, 16], rgba };
        FrameState::New(DrawnLayers { picture, ..DrawnLayers::default() })
    }

    /// Sends frames as drawing does, until nobody takes them.
    #[expect(clippy::disallowed_methods, reason = "a thread that plays the part of drawing")]
    fn written(
        frames: Vec<DrawnFrame>,
        format: PictureFormat,
        outputs: &Outputs,
    ) -> (Vec<i32>, Vec<i32>) {
        let (to_write, drawn) = sync_channel(1);
        let (mut whole, mut failed) = (Vec::new(), Vec::new());
        std::thread::scope(|scope| {
            scope.spawn(move || {
                // Until nobody takes them.
                frames.into_iter().all(|frame| to_write.send(frame).is_ok())
            });
            write_by(5, (format, None), outputs, drawn, |frame| match &frame.state {
                FrameState::Failed(_) => failed.push(frame.frame),
                _ => whole.push(frame.frame),
            });
        });
        (whole, failed)
    }

    #[test]
    fn many_writers_tell_frames_in_their_order_and_equal_ones_wait_for_theirs() {
        for format in [PictureFormat::Exr(ExrEncoding::default()), PictureFormat::Png] {
            let folder = tempfile::tempdir().unwrap();
            let of = |number: i32| {
                let first = number - number % 3;
                let file = folder.path().join(format!("{first:04}.exr"));
                let equal = FrameState::Equal { frame: first, file };
                frame(folder.path(), number, if number == first { drawn(first) } else { equal })
            };
            let (whole, failed) = written((0..40).map(of).collect(), format, &Outputs::new(false));
            assert!(failed.is_empty(), "{failed:?}");
            assert_eq!(whole, Vec::from_iter(0..40));
            for number in 0..40 {
                let bytes = read(&folder.path().join(format!("{number:04}.exr"))).unwrap();
                let first = number - number % 3;
                assert_eq!(format.plan_of(&bytes), Some(format!("plan {first}")), "{number}");
            }
        }
    }

    #[test]
    fn a_frame_that_cannot_be_written_is_told_and_the_others_are_whole() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("0007.exr"), "an artist's own").unwrap();
        let of = |number: i32| {
            let file = folder.path().join("0007.exr");
            let equal = FrameState::Equal { frame: 7, file };
            frame(folder.path(), number, if number == 9 { equal } else { drawn(number) })
        };
        let format = PictureFormat::Exr(ExrEncoding::default());
        let (whole, failed) = written((0..40).map(of).collect(), format, &Outputs::new(false));
        assert_eq!(failed, [7, 9], "the frame, and the one that is the same picture");
        assert_eq!(whole.len(), 38);
        let kept = std::fs::read(folder.path().join("0007.exr")).unwrap();
        assert_eq!(kept, b"an artist's own");
    }

    #[test]
    fn frames_that_fail_one_after_another_end_the_others() {
        let folder = tempfile::tempdir().unwrap();
        let of = |number: i32| {
            let lost = FrameState::Failed(vec![Diagnostic::error("lost", "the GPU is gone")]);
            frame(folder.path(), number, if number < 4 { drawn(number) } else { lost })
        };
        let format = PictureFormat::Exr(ExrEncoding::default());
        let (whole, failed) = written((0..900).map(of).collect(), format, &Outputs::new(false));
        assert_eq!(whole, [0, 1, 2, 3]);
        assert!((MOST_FAILED..900).contains(&failed.len()), "{}", failed.len());
    }
}
