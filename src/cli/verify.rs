//! `chiaro verify`: frames are read again, and compared with those of another run.

use std::path::PathBuf;

use rayon::prelude::*;
use serde_json::{Value as Json, json};

use super::frame_files::{FrameFile, found, pattern_of};
use super::output::Output;
use crate::diag::Diagnostic;
use crate::film::{FrameDifference, FrameList, FramePattern, StoredFrame};

const EXAMPLES: &str = "\
Examples:
  chiaro verify 'out/####.exr'
  chiaro verify 'out/####.exr' --frames 1-240 --json
  chiaro verify 'out/####.exr' --against 'before/####.exr' --within 1/255

Each frame is whole where its file is as Chiaro wrote it, by the checksum in it. All frames are of
one size and have the same channels. Exit codes: 0 where all are whole (and equal), 1 where not,
2 for wrong arguments; the last line says which frames are at fault.";

/// Arguments of `chiaro verify`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// The frames' files; `####` stands for the number
    files: PathBuf,
    /// The frames that must be there [default: from the first to the last that is]
    #[arg(long, allow_hyphen_values = true)]
    frames: Option<FrameList>,
    /// Frames of another run to compare with, number by number
    #[arg(long)]
    against: Option<PathBuf>,
    /// Greatest difference of a number that is no fault: 0, 0.001, 1/255
    #[arg(long, default_value = "0", value_parser = parse_bound, requires = "against")]
    within: f64,
    /// Print a line of JSON for each frame
    #[arg(long)]
    json: bool,
}

fn parse_bound(text: &str) -> Result<f64, String> {
    let number =
        |text: &str| text.trim().parse::<f64>().ok().filter(|x| x.is_finite() && *x >= 0.0);
    let bound = match text.split_once('/') {
        Some((above, below)) => number(above).zip(number(below)).map(|(a, b)| a / b),
        None => number(text),
    };
    let bound = bound.filter(|bound| bound.is_finite());
    bound.ok_or_else(|| "write a number such as 0.001 or 1/255".to_owned())
}

/// Finding about a frame.
enum Verdict {
    Whole,
    Missing,
    /// The file is none, or not as Chiaro wrote it.
    Broken(String),
    /// The size or the channels are others than the first frame's.
    Odd(String),
    /// The frame of the other run is another one, or cannot be compared.
    Different(String),
}

impl Verdict {
    fn word(&self) -> &'static str {
        match self {
            Self::Whole => "whole",
            Self::Missing => "missing",
            Self::Broken(_) => "broken",
            Self::Odd(_) => "odd",
            Self::Different(_) => "different",
        }
    }

    fn reason(&self) -> &str {
        match self {
            Self::Whole => "",
            Self::Missing => "there is no file",
            Self::Broken(reason) | Self::Odd(reason) | Self::Different(reason) => reason,
        }
    }
}

/// Number of frames that are read side by side: each takes what its pixels take, twice where it is
/// compared.
const FRAMES_AT_ONCE: usize = 32;

/// A frame that was read again; `stored` is without its numbers.
struct Finding {
    verdict: Verdict,
    stored: Option<StoredFrame>,
    difference: Option<FrameDifference>,
}

pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let one = |problem: Diagnostic| vec![problem];
    let pattern = pattern_of(&arguments.files).map_err(one)?;
    let against = arguments.against.as_deref().map(pattern_of).transpose().map_err(one)?;
    let frames = match &arguments.frames {
        Some(list) => list.frames().to_vec(),
        None => {
            let found = found(&pattern).map_err(one)?;
            let (first, last) = (found[0], found[found.len() - 1]);
            (first..=last).collect()
        }
    };
    let mut first: Option<StoredFrame> = None;
    let mut faults: Vec<(&'static str, Vec<i32>)> = Vec::new();
    let mut greatest = 0.0_f64;
    // Every core reads files; what is found is told in the order of the frames.
    let read = |frame: &i32| check(&pattern, against.as_ref(), *frame, arguments.within);
    let found = frames.chunks(FRAMES_AT_ONCE).flat_map(|some| {
        let found: Vec<Finding> = some.par_iter().map(read).collect();
        some.iter().copied().zip(found)
    });
    for (frame, found) in found {
        let found = found.beside(first.as_ref());
        let Finding { verdict, stored, difference } = &found;
        greatest = difference.as_ref().map_or(greatest, |found| greatest.max(found.greatest));
        let file = pattern.path(frame);
        if arguments.json {
            output.result(&found.json(frame, &file.display().to_string()).to_string());
        } else if !matches!(verdict, Verdict::Whole) {
            output.message(&format!("{}: {}", file.display(), verdict.reason()));
        }
        if !matches!(verdict, Verdict::Whole) {
            match faults.iter_mut().find(|(word, _)| *word == verdict.word()) {
                Some((_, list)) => list.push(frame),
                None => faults.push((verdict.word(), vec![frame])),
            }
        }
        // The first frame says what all are to be.
        if first.is_none() && matches!(verdict, Verdict::Whole | Verdict::Different(_)) {
            first.clone_from(stored);
        }
    }
    let count = frames.len();
    if !faults.is_empty() {
        let told = faults.into_iter().map(|(word, list)| {
            let plural = if list.len() == 1 { "frame" } else { "frames" };
            format!("{} {plural} {word}: {}", list.len(), FrameList::of(list))
        });
        let told: Vec<String> = told.collect();
        let message = format!("of {count} frames, {}", told.join("; "));
        return Err(one(Diagnostic::error("frames-at-fault", message)
            .in_file(arguments.files.display().to_string())));
    }
    let compared = match (&against, greatest) {
        (None, _) => String::new(),
        (Some(_), 0.0) => ", and equal to the other run's to the bit".to_owned(),
        (Some(_), greatest) => format!(", and within {greatest} of the other run's"),
    };
    output.message(&format!("{}: {count} frames, all whole{compared}", arguments.files.display()));
    Ok(())
}

/// Reads a frame, and compares it with that of another run.
fn check(
    pattern: &FramePattern,
    against: Option<&FramePattern>,
    frame: i32,
    within: f64,
) -> Finding {
    let alone = |verdict| Finding { verdict, stored: None, difference: None };
    let of = |pattern: &FramePattern| FrameFile { frame: Some(frame), path: pattern.path(frame) };
    let file = of(pattern);
    if !file.path.exists() {
        return alone(Verdict::Missing);
    }
    let stored = match file.read() {
        Ok(stored) => stored,
        Err(problem) => return alone(Verdict::Broken(problem.message)),
    };
    let (verdict, difference) = if !stored.is_sealed {
        (Verdict::Broken("the file is not as Chiaro wrote it".to_owned()), None)
    } else {
        match against.map(|other| of(other).read()) {
            None => (Verdict::Whole, None),
            Some(Err(problem)) => {
                let message = format!("the other run's cannot be read: {}", problem.message);
                (Verdict::Different(message), None)
            }
            Some(Ok(other)) => compared(&stored, &other, within),
        }
    };
    Finding { verdict, stored: Some(stored.without_numbers()), difference }
}

/// Verdict about a frame beside that of another run, with their difference.
fn compared(
    stored: &StoredFrame,
    other: &StoredFrame,
    within: f64,
) -> (Verdict, Option<FrameDifference>) {
    let difference = match stored.difference(other) {
        Ok(difference) => difference,
        Err(reason) => return (Verdict::Different(reason), None),
    };
    let verdict = match difference.as_ref().filter(|found| found.greatest > within) {
        None => Verdict::Whole,
        Some(FrameDifference { greatest, channel, pixel: [x, y], pixels }) => Verdict::Different(
            format!("{pixels} pixels are others, by {greatest} at most ({channel} at {x}, {y})"),
        ),
    };
    (verdict, difference)
}

impl Finding {
    /// The finding, where the frame's size and channels are to be those of the first one.
    fn beside(self, first: Option<&StoredFrame>) -> Self {
        let is_sound = matches!(self.verdict, Verdict::Whole | Verdict::Different(_));
        let (Some(stored), Some(first)) = (self.stored.as_ref().filter(|_| is_sound), first) else {
            return self;
        };
        if first.size == stored.size && first.names() == stored.names() {
            return self;
        }
        let [width, height] = stored.size;
        let names = stored.names().join(", ");
        let verdict = Verdict::Odd(format!(
            "it is {width}x{height} with the channels {names}, unlike the first frame"
        ));
        Self { verdict, difference: None, ..self }
    }

    fn json(&self, frame: i32, file: &str) -> Json {
        let mut told = json!({"frame": frame, "file": file, "state": self.verdict.word()});
        if !self.verdict.reason().is_empty() {
            told["reason"] = json!(self.verdict.reason());
        }
        if let Some(stored) = &self.stored {
            told["size"] = json!(stored.size);
            told["channels"] = json!(stored.names());
            told["plan"] = json!(stored.plan.as_deref().and_then(|plan| plan.split(' ').next()));
        }
        if let Some(FrameDifference { greatest, channel, pixel, pixels }) = &self.difference {
            // JSON has no number that is infinite.
            told["difference"] = json!({
                "greatest": greatest, "channel": channel, "pixel": pixel, "pixels": pixels
            });
        }
        told
    }
}
