//! `chiaro verify`: frames are read again, and compared with those of another run.

use std::path::{Path, PathBuf};

use rayon::prelude::*;
use serde_json::{Value as Json, json};

use super::frame_files::{FrameFile, found, pattern_of};
use super::output::Output;
use super::render::PresentFrames;
use crate::diag::Diagnostic;
use crate::film::{
    Contributions, FrameDifference, FrameList, FramePattern, MatteKind, StoredFrame,
};

const EXAMPLES: &str = "\
Examples:
  chiaro verify 'out/####.exr'
  chiaro verify 'out/####.exr' --frames 1-240 --json
  chiaro verify 'out/####.exr' --frames 1-240 --of shot.json --depth=float
  chiaro verify 'out/####.exr' --against 'before/####.exr' --within 1/255

Each frame is whole where its file is as Chiaro wrote it, by the checksum in it. All frames are of
one size and have the same channels. Exit codes: 0 where all are whole (and equal), 1 where not,
2 for wrong arguments; the last line says which frames are at fault.

--of plans each frame as `chiaro render` would now, and draws nothing: a frame that render would
draw again is of another state of the document. What follows it, up to the end, are the document
and the options that the frames were drawn with. Where layers or the depth of the frames show that
the options are others, and the document is the same, those to add are told.

Beside another run the channels that both have are compared. A layer that one run has alone is
named, and is a difference, unless --shared leaves such layers out.";

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
    /// Compare the channels that both runs have, and let layers that one has alone be no fault
    #[arg(long, requires = "against")]
    shared: bool,
    /// Print a line of JSON for each frame
    #[arg(long)]
    json: bool,
    /// The document that frames must be of as it is now, and options of `chiaro render` that they
    /// were drawn with; stands last
    #[arg(
        long,
        value_names = ["DOCUMENT", "OPTION"],
        num_args = 1..,
        allow_hyphen_values = true
    )]
    of: Vec<String>,
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
    /// The frame of the other run is another one, has other layers, or cannot be compared.
    Different(String),
    /// The frame is whole, and of another state of the document, as the reason names it.
    Stale(String),
    /// The frame is whole, and of the document as it is now, drawn with more options.
    OtherOptions(String),
}

impl Verdict {
    fn word(&self) -> &'static str {
        match self {
            Self::Whole => "whole",
            Self::Missing => "missing",
            Self::Broken(_) => "broken",
            Self::Odd(_) => "odd",
            Self::Different(_) => "different",
            Self::Stale(_) => "stale",
            Self::OtherOptions(_) => "other-options",
        }
    }

    /// True of a frame that says what the others are to be like.
    fn is_sound(&self) -> bool {
        matches!(self, Self::Whole | Self::Different(_) | Self::Stale(_) | Self::OtherOptions(_))
    }

    fn reason(&self) -> &str {
        match self {
            Self::Whole => "",
            Self::Missing => "there is no file",
            Self::Broken(reason)
            | Self::Odd(reason)
            | Self::Different(reason)
            | Self::Stale(reason)
            | Self::OtherOptions(reason) => reason,
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
    comparison: Comparison,
}

/// Frame beside that of another run.
#[derive(Default)]
struct Comparison {
    /// Difference of the channels that both have.
    difference: Option<FrameDifference>,
    /// Layers that one of the two has alone, in words.
    alone: Option<String>,
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
    let mut present = match arguments.of.as_slice() {
        [] => None,
        words => Some(DocumentFrames::open(words, &arguments.files)?),
    };
    let mut first: Option<StoredFrame> = None;
    let mut faults: Vec<(&'static str, Vec<i32>)> = Vec::new();
    let mut greatest = 0.0_f64;
    let mut alone: Option<String> = None;
    // Every core reads files; what is found is told in the order of the frames.
    let read = |frame: &i32| check(&pattern, against.as_ref(), *frame, arguments);
    let found = frames.chunks(FRAMES_AT_ONCE).flat_map(|some| {
        let found: Vec<Finding> = some.par_iter().map(read).collect();
        some.iter().copied().zip(found)
    });
    for (frame, found) in found {
        let mut found = found.beside(first.as_ref());
        if let Some(present) = &mut present {
            found = found.beside_present(frame, present)?;
        }
        let Finding { verdict, stored, comparison } = &found;
        let Comparison { difference, alone: of_one } = comparison;
        greatest = difference.as_ref().map_or(greatest, |found| greatest.max(found.greatest));
        alone = alone.or_else(|| of_one.clone());
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
        if first.is_none() && verdict.is_sound() {
            first.clone_from(stored);
        }
    }
    let count = frames.len();
    if !faults.is_empty() {
        let told = faults.into_iter().map(|(word, list)| {
            let plural = if list.len() == 1 { "frame" } else { "frames" };
            let state = match (word, arguments.of.first()) {
                ("stale", Some(document)) => format!("of another state of {document}"),
                ("other-options", Some(document)) => {
                    format!("of {document} as it is now, with more options")
                }
                _ => word.to_owned(),
            };
            format!("{} {plural} {state}: {}", list.len(), FrameList::of(list))
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
    let as_now = arguments.of.first().map(|document| format!(", and of {document} as it is now"));
    let as_now = as_now.unwrap_or_default();
    let of_shared = alone.map(|alone| format!(" in what both have: {alone}")).unwrap_or_default();
    output.message(&format!(
        "{}: {count} frames, all whole{as_now}{compared}{of_shared}",
        arguments.files.display()
    ));
    Ok(())
}

/// Reads a frame, and compares it with that of another run.
fn check(
    pattern: &FramePattern,
    against: Option<&FramePattern>,
    frame: i32,
    arguments: &Arguments,
) -> Finding {
    let alone = |verdict| Finding { verdict, stored: None, comparison: Comparison::default() };
    let of = |pattern: &FramePattern| FrameFile { frame: Some(frame), path: pattern.path(frame) };
    let file = of(pattern);
    if !file.path.exists() {
        return alone(Verdict::Missing);
    }
    let stored = match file.read() {
        Ok(stored) => stored,
        Err(problem) => return alone(Verdict::Broken(problem.message)),
    };
    let nothing = Comparison::default;
    let (verdict, comparison) = if !stored.is_sealed {
        (Verdict::Broken("the file is not as Chiaro wrote it".to_owned()), nothing())
    } else {
        match against.map(|other| of(other).read()) {
            None => (Verdict::Whole, nothing()),
            Some(Err(problem)) => {
                let message = format!("the other run's cannot be read: {}", problem.message);
                (Verdict::Different(message), nothing())
            }
            Some(Ok(other)) => compared(&stored, &other, arguments.within, arguments.shared),
        }
    };
    Finding { verdict, stored: Some(stored.without_numbers()), comparison }
}

/// Verdict about a frame beside that of another run, with their comparison. Layers that one of the
/// two has alone are a difference, unless only what both have counts, `is_shared`.
fn compared(
    stored: &StoredFrame,
    other: &StoredFrame,
    within: f64,
    is_shared: bool,
) -> (Verdict, Comparison) {
    let difference = match stored.difference(other) {
        Ok(difference) => difference,
        Err(reason) => return (Verdict::Different(reason), Comparison::default()),
    };
    let alone = [
        stored.layers_beyond(other).map(|layers| format!("only this run has {layers}")),
        other.layers_beyond(stored).map(|layers| format!("only the other run has {layers}")),
    ];
    let alone: Vec<String> = alone.into_iter().flatten().collect();
    let alone = Some(alone.join("; ")).filter(|alone| !alone.is_empty());
    let of_numbers = difference.as_ref().filter(|found| found.greatest > within).map(|found| {
        let FrameDifference { greatest, channel, pixel: [x, y], pixels } = found;
        format!("{pixels} pixels are others, by {greatest} at most ({channel} at {x}, {y})")
    });
    let faults = match (of_numbers, alone.clone().filter(|_| !is_shared)) {
        (None, Some(alone)) => {
            let is_equal = difference.is_none();
            let shared = if is_equal { "equal" } else { "within the bound" };
            Some(format!("{alone}; what both have is {shared}"))
        }
        (Some(numbers), Some(alone)) => Some(format!("{numbers}; {alone}")),
        (numbers, None) => numbers,
    };
    let verdict = faults.map_or(Verdict::Whole, Verdict::Different);
    (verdict, Comparison { difference, alone })
}

impl Finding {
    /// The finding, where the frame's size and channels are to be those of the first one.
    fn beside(self, first: Option<&StoredFrame>) -> Self {
        let is_sound = self.verdict.is_sound();
        let (Some(stored), Some(first)) = (self.stored.as_ref().filter(|_| is_sound), first) else {
            return self;
        };
        if first.size == stored.size && first.names() == stored.names() {
            return self;
        }
        let size = |[width, height]: [u32; 2]| format!("{width}x{height}");
        let of_size = (first.size != stored.size).then(|| {
            format!("it is {}, and the first frame {}", size(stored.size), size(first.size))
        });
        let more = stored.layers_beyond(first);
        let more = more.map(|layers| format!("it has {layers}, and the first frame has not"));
        let fewer = first.layers_beyond(stored);
        let fewer = fewer.map(|layers| format!("it lacks {layers} of the first frame"));
        let told: Vec<String> = [of_size, more, fewer].into_iter().flatten().collect();
        let verdict = Verdict::Odd(told.join("; "));
        Self { verdict, comparison: Comparison::default(), ..self }
    }

    /// The finding, where a whole frame is to be as the document that is named is now.
    fn beside_present(
        self,
        frame: i32,
        present: &mut DocumentFrames<'_>,
    ) -> Result<Self, Vec<Diagnostic>> {
        let (Verdict::Whole, Some(stored)) = (&self.verdict, &self.stored) else {
            return Ok(self);
        };
        let verdict = present.verdict(frame, stored)?;
        Ok(Self { verdict, ..self })
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
        if let Some(alone) = &self.comparison.alone {
            told["alone"] = json!(alone);
        }
        let difference = &self.comparison.difference;
        if let Some(FrameDifference { greatest, channel, pixel, pixels }) = difference {
            // JSON has no number that is infinite.
            told["difference"] = json!({
                "greatest": greatest, "channel": channel, "pixel": pixel, "pixels": pixels
            });
        }
        told
    }
}

/// Frames of a document as it is now, by the options that are named for it and by more of them.
struct DocumentFrames<'a> {
    /// The document, and the options.
    words: &'a [String],
    target: &'a Path,
    named: PresentFrames,
    /// Options that the frames were drawn with besides, once they were sought.
    added: Option<Option<(String, PresentFrames)>>,
}

impl<'a> DocumentFrames<'a> {
    /// Opens the document, as [`PresentFrames::open`].
    fn open(words: &'a [String], target: &'a Path) -> Result<Self, Vec<Diagnostic>> {
        Ok(Self { words, target, named: PresentFrames::open(words, target)?, added: None })
    }

    /// Verdict on a whole frame.
    fn verdict(&mut self, frame: i32, stored: &StoredFrame) -> Result<Verdict, Vec<Diagnostic>> {
        let plan = stored.plan.as_deref().unwrap_or_default();
        if self.named.is(frame, plan)? {
            return Ok(Verdict::Whole);
        }
        let added = self.added.take().unwrap_or_else(|| self.added_to(frame, stored));
        let document = &self.words[0];
        if let Some((options, present)) = self.added.insert(added)
            && present.is(frame, plan)?
        {
            return Ok(Verdict::OtherOptions(format!(
                "it is of {document} as it is now, drawn with more options: add {options} after \
                 {document}"
            )));
        }
        Ok(Verdict::Stale(format!("it is of another state of {document}")))
    }

    /// Options that a frame was drawn with besides those that are named, as its layers and the
    /// usual depths suggest; `None` where no such options draw it from the document.
    fn added_to(&self, frame: i32, stored: &StoredFrame) -> Option<(String, PresentFrames)> {
        let plan = stored.plan.as_deref()?;
        for options in suggested(&stored.names()) {
            let words = [self.words, &options].concat();
            // Options that the document knows nothing of are not those.
            let Ok(mut present) = PresentFrames::open(&words, self.target) else { continue };
            if present.is(frame, plan).unwrap_or(false) {
                return Some((options.join(" "), present));
            }
        }
        None
    }
}

/// Lists of options that may have drawn a frame with these channels.
fn suggested(channels: &[&str]) -> Vec<Vec<String>> {
    let mut layers: Vec<&str> =
        channels.iter().filter_map(|name| name.rsplit_once('.')).map(|(layer, _)| layer).collect();
    layers.dedup();
    let has = |kind: MatteKind| layers.iter().any(|layer| layer.starts_with(kind.name()));
    let mattes: Vec<&str> =
        MatteKind::all().filter(|(_, kind)| has(*kind)).map(|(word, _)| word).collect();
    let matte = (!mattes.is_empty()).then(|| format!("--matte={}", mattes.join(",")));
    layers.retain(|layer| !MatteKind::all().any(|(_, kind)| layer.starts_with(kind.name())));
    let aov = |word: String| Some(format!("--aov={word}"));
    let slices = Contributions::all().map(|(word, _)| word.to_owned());
    let aovs: Vec<Option<String>> = match layers.is_empty() {
        true => vec![None],
        false => slices.chain([layers.join(",")]).map(aov).collect(),
    };
    let depths = [None, Some("--depth=float".to_owned())];
    let all = depths.iter().flat_map(|depth| {
        let with = |aov: &Option<String>| [aov.clone(), matte.clone(), depth.clone()];
        aovs.iter().map(with).collect::<Vec<_>>()
    });
    let lists = all.map(|options| options.into_iter().flatten().collect::<Vec<String>>());
    lists.filter(|options| !options.is_empty()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::exr::{ExrEncoding, ExrHeader, ExrLayer, encode};

    /// A frame of one pixel with these layers, whose numbers are all the same.
    fn frame(layers: &[(&str, f32)]) -> StoredFrame {
        let layer = |(name, number): &(&str, f32)| ExrLayer {
            name: (*name).to_owned(),
            channels: ["R", "G", "B", "A"].map(|of| (of.to_owned(), vec![*number])).to_vec(),
            samples: None,
        };
        let layers: Vec<ExrLayer> = layers.iter().map(layer).collect();
        let bytes = encode([1, 1], &layers, &ExrHeader::default(), ExrEncoding::default());
        StoredFrame::read(&bytes.unwrap()).unwrap()
    }

    #[test]
    fn a_layer_that_one_run_has_alone_is_a_difference_unless_left_out() {
        let (before, after) =
            (frame(&[("", 0.5)]), frame(&[("", 0.5), ("light_key", 1.0), ("spec", 0.0)]));
        let (verdict, comparison) = compared(&after, &before, 0.0, false);
        let told = "only this run has light_key, spec (8 channels); what both have is equal";
        assert_eq!((verdict.word(), verdict.reason()), ("different", told));
        assert!(comparison.difference.is_none());
        let (verdict, _) = compared(&before, &after, 0.0, false);
        assert!(verdict.reason().starts_with("only the other run has"), "{}", verdict.reason());
        let (verdict, comparison) = compared(&after, &before, 0.0, true);
        assert_eq!(verdict.word(), "whole");
        assert_eq!(
            comparison.alone.as_deref(),
            Some("only this run has light_key, spec (8 channels)")
        );
        // What both have is compared all the same.
        let darker = frame(&[("", 0.25)]);
        let (verdict, _) = compared(&after, &darker, 0.0, true);
        assert_eq!(verdict.word(), "different");
        assert_eq!(compared(&after, &darker, 0.5, true).0.word(), "whole");
    }

    #[test]
    fn an_odd_frame_is_told_from_the_first_in_few_words() {
        let first = frame(&[("", 0.5), ("spec", 1.0)]);
        let stored = Some(frame(&[("", 0.5)]));
        let finding =
            Finding { verdict: Verdict::Whole, stored, comparison: Comparison::default() };
        let told = finding.beside(Some(&first)).verdict;
        assert_eq!(told.reason(), "it lacks spec (4 channels) of the first frame");
    }

    #[test]
    fn layers_of_a_frame_suggest_what_it_was_drawn_with() {
        let told = |channels: &[&str]| -> Vec<String> {
            suggested(channels).iter().map(|options| options.join(" ")).collect()
        };
        assert_eq!(told(&["A", "B", "G", "R"]), ["--depth=float"]);
        let by_light = told(&["R", "light_key.R", "light_key.G", "CryptoObject00.R"]);
        assert!(by_light.contains(&"--aov=lights --matte=objects".to_owned()), "{by_light:?}");
        assert!(told(&["R", "depth.V"]).contains(&"--aov=depth --depth=float".to_owned()));
    }
}
