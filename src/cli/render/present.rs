//! Plans that frames would be drawn by now, beside which the files of an earlier run are held.

use std::path::Path;

use clap::{Args as _, FromArgMatches as _};

use super::format::PictureFormat;
use super::frames::key;
use super::{Arguments, Stage, other_ending};
use crate::diag::Diagnostic;
use crate::film::{DisplayView, FrameRate, PlanHasher};
use crate::frame::PlanOptions;

/// Numbers of layers that one draw of some adapter writes: a plan is parted by it, and who checks
/// frames needs no adapter.
const LAYERS_OF_ADAPTERS: std::ops::RangeInclusive<usize> = 1..=8;

/// Frames as `chiaro render` would plan them now.
pub(in super::super) struct PresentFrames {
    stage: Stage,
    hasher: PlanHasher,
    rate: FrameRate,
    format: PictureFormat,
    view: Option<DisplayView>,
    /// Numbers of layers of a draw, the one that was found last first.
    most_layers: Vec<usize>,
}

impl Arguments {
    /// The arguments of `chiaro render`, read from words; the last output counts.
    ///
    /// # Errors
    /// `bad-argument` with the parser's own text.
    pub(in super::super) fn of_words(words: &[String]) -> Result<Self, Vec<Diagnostic>> {
        let command = Self::augment_args(clap::Command::new("render")).args_override_self(true);
        let words = std::iter::once("render").chain(words.iter().map(String::as_str));
        let read = command.try_get_matches_from(words);
        let read = read.and_then(|matches| Self::from_arg_matches(&matches));
        read.map_err(|error| vec![Diagnostic::error("bad-argument", error.to_string())])
    }
}

impl PresentFrames {
    /// Opens the document and the options that `words` name, as for frames in files of `target`.
    ///
    /// # Errors
    /// `bad-argument` for words that are none of `chiaro render`, and what keeps the document from
    /// being opened.
    pub(in super::super) fn open(words: &[String], target: &Path) -> Result<Self, Vec<Diagnostic>> {
        let output = format!("--output={}", target.display());
        let words: Vec<String> = words.iter().cloned().chain([output]).collect();
        let arguments = Arguments::of_words(&words)?;
        let format = PictureFormat::of(target, arguments.encoding());
        let format = format.ok_or_else(|| vec![other_ending(target, "PNG or EXR")])?;
        let view = arguments.view_of(format).map_err(|problem| vec![problem])?;
        // Warnings are told where frames are drawn.
        let stage = arguments.open(&mut Vec::new())?;
        let rate = arguments.rate_of(&stage.setup);
        let has_layers = !stage.asked.is_empty();
        let many = || LAYERS_OF_ADAPTERS.chain([usize::MAX]).collect();
        let most_layers = if has_layers { many() } else { vec![0] };
        Ok(Self { stage, hasher: PlanHasher::default(), rate, format, view, most_layers })
    }

    /// True if a file with this plan in its header is what the frame would be now.
    ///
    /// # Errors
    /// What keeps the frame from being planned.
    pub(in super::super) fn is(&mut self, frame: i32, plan: &str) -> Result<bool, Vec<Diagnostic>> {
        let time = self.rate.time(frame);
        let options = PlanOptions { time, ..self.stage.options.clone() };
        for at in 0..self.most_layers.len() {
            self.stage.most_layers = self.most_layers[at];
            let planned = self.stage.plan(&options)?.tell(&mut Vec::new());
            let content = self.hasher.hash_layered(&planned);
            if key(&content, self.format, self.view.as_ref(), self.rate) == plan {
                self.most_layers.swap(0, at);
                return Ok(true);
            }
        }
        Ok(false)
    }
}
