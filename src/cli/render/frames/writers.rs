//! Writers: threads that encode drawn frames, write them and read them back, and tell each in its
//! order when it is whole.
//!
//! Deflate and checksums take longer than a graphics card needs to draw, so there are as many
//! writers as cores, and as many frames at once as memory is set aside for.

use std::collections::{BTreeMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

use super::{DrawnFrame, Frame, FrameState, Sequence, Summary};
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
    /// Files that were written, or could not be.
    done: HashSet<PathBuf>,
    /// Bytes that are taken by the frames being written.
    bytes: usize,
    /// True from the first frame on that could not be written.
    has_failed: bool,
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

/// A frame that is whole, or why it is not.
type WrittenFrame = (usize, Result<DrawnFrame, Diagnostic>);

/// Writes frames, reads them back, and tells each, in their order, when it is whole.
pub(super) fn write_all(
    sequence: Sequence<'_>,
    outputs: &Outputs,
    drawn: Receiver<DrawnFrame>,
    output: &Output,
) -> Result<Summary, Vec<Diagnostic>> {
    let writers = threads::cores().saturating_sub(1).clamp(1, MOST_WRITERS);
    let mut summary = Summary { writers, ..Summary::default() };
    let told = |frame: &DrawnFrame| {
        summary.add(frame);
        if sequence.has_json {
            output.result(&frame.json(sequence.rate).to_string());
        } else {
            output.message(&frame.text());
        }
        if let Some(lines) = sequence.progress {
            let all = sequence.frames.frames().len();
            lines.tell(frame.frame, summary.count(), all, output);
        }
    };
    write_by(writers, (sequence.format, sequence.view), outputs, drawn, told)
        .map_err(|problem| vec![problem])?;
    Ok(summary)
}

/// Writes frames by so many threads, and tells each, in their order, when it is whole.
///
/// # Errors
/// Of the first frame, in the order, that could not be written; those before it were told.
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
) -> Result<(), Diagnostic> {
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
        tell_all(told, tell)
    })
}

/// Tells frames in their order.
///
/// # Errors
/// Of the first frame, in the order, that could not be written.
fn tell_all(
    told: Receiver<WrittenFrame>,
    mut tell: impl FnMut(&DrawnFrame),
) -> Result<(), Diagnostic> {
    let mut early = BTreeMap::new();
    let mut next = 0;
    let mut problem: Option<(usize, Diagnostic)> = None;
    for (place, written) in told {
        match written {
            Ok(frame) => drop(early.insert(place, frame)),
            Err(found) => {
                if problem.as_ref().is_none_or(|(known, _)| place < *known) {
                    problem = Some((place, found));
                }
            }
        }
        while let Some(frame) = early.remove(&next) {
            next += 1;
            tell(&frame);
        }
    }
    problem.map_or(Ok(()), |(_, problem)| Err(problem))
}

/// Room of a frame that is being written; given back whatever becomes of it, so that nobody waits
/// for ever.
struct Seat<'a> {
    desk: &'a Desk,
    file: PathBuf,
    bytes: usize,
    is_whole: bool,
}

impl Drop for Seat<'_> {
    fn drop(&mut self) {
        let mut progress = self.desk.progress();
        progress.bytes -= self.bytes;
        progress.has_failed |= !self.is_whole;
        progress.done.insert(std::mem::take(&mut self.file));
        drop(progress);
        self.desk.changed.notify_all();
    }
}

impl Desk {
    /// Writes frame after frame, until there are none or one could not be written.
    fn write_frames(&self, form: Form<'_>, mut outputs: Outputs, tell: &Sender<WrittenFrame>) {
        while let Some((place, mut frame, bytes)) = self.take() {
            let mut seat = Seat { desk: self, file: frame.file.clone(), bytes, is_whole: false };
            let clock = Clock::start();
            let written = self.write(form, &mut outputs, &frame);
            frame.seconds.writing = clock.seconds();
            seat.is_whole = written.is_ok();
            drop(seat);
            // The picture is not needed any more, and may be large.
            if let FrameState::New(picture) = &mut frame.state {
                *picture = crate::film::DrawnLayers::default();
            }
            if tell.send((place, written.map(|()| frame))).is_err() {
                break;
            }
        }
    }

    /// The next frame, with its place in the order and the bytes that it takes, when there is room
    /// for it; `None` after the last one.
    fn take(&self) -> Option<(usize, DrawnFrame, usize)> {
        // Held while waiting for room: one frame waits, and no more are taken.
        let mut waiting = self.drawn.lock().unwrap_or_else(PoisonError::into_inner);
        if self.progress().has_failed {
            return None;
        }
        let frame = waiting.drawn.recv().ok()?;
        let bytes = match &frame.state {
            FrameState::New(drawn) => COPIES.saturating_mul(drawn.bytes()),
            FrameState::Kept | FrameState::Equal { .. } => 0,
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
            FrameState::Kept => return Ok(()),
            FrameState::New(picture) => {
                outputs.write(file, format.kind(), &format.encode(picture, header, view)?)?;
            }
            FrameState::Equal { file: first, .. } => {
                self.wait_for(first);
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

    /// Waits until a frame that was taken before is written, or could not be.
    fn wait_for(&self, file: &Path) {
        let is_open = |progress: &mut Progress| !progress.done.contains(file);
        drop(self.changed.wait_while(self.progress(), is_open));
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
    ) -> (Vec<i32>, Result<(), Diagnostic>) {
        let (to_write, drawn) = sync_channel(1);
        let mut told = Vec::new();
        let result = std::thread::scope(|scope| {
            scope.spawn(move || {
                // Until nobody takes them.
                frames.into_iter().all(|frame| to_write.send(frame).is_ok())
            });
            write_by(5, (format, None), outputs, drawn, |frame| told.push(frame.frame))
        });
        (told, result)
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
            let (told, result) = written((0..40).map(of).collect(), format, &Outputs::new(false));
            result.unwrap();
            assert_eq!(told, Vec::from_iter(0..40));
            for number in 0..40 {
                let bytes = read(&folder.path().join(format!("{number:04}.exr"))).unwrap();
                let first = number - number % 3;
                assert_eq!(format.plan_of(&bytes), Some(format!("plan {first}")), "{number}");
            }
        }
    }

    #[test]
    fn a_frame_that_cannot_be_written_ends_the_others_and_is_told() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("0007.exr"), "an artist's own").unwrap();
        let frames = (0..40).map(|number| frame(folder.path(), number, drawn(number)));
        let format = PictureFormat::Exr(ExrEncoding::default());
        let (told, result) = written(frames.collect(), format, &Outputs::new(false));
        let problem = result.unwrap_err();
        assert!(problem.code == "file-exists" && problem.to_string().contains("0007"), "{problem}");
        assert_eq!(told, Vec::from_iter(0..7), "no frame after it is told");
        let whole = std::fs::read_dir(folder.path()).unwrap().count();
        assert!(whole < 40, "drawing ended: {whole}");
    }
}
