//! Progress of many frames, as farms read it from standard output.

use crate::output::Output;

/// Language of the lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum ProgressLines {
    /// Open Job Description: `openjd_progress: 12.5` and `openjd_status: frame 3`.
    Openjd,
}

impl ProgressLines {
    /// Tells that a frame is whole or has failed, the so many-th of all.
    pub(super) fn tell(
        self,
        (frame, is_whole): (i32, bool),
        count: usize,
        all: usize,
        output: &Output,
    ) {
        match self {
            Self::Openjd => {
                let percent = 100.0 * count as f64 / all.max(1) as f64;
                output.result(&format!("openjd_progress: {percent:.1}"));
                let fate = if is_whole { "is whole" } else { "failed" };
                output.result(&format!("openjd_status: frame {frame} {fate}"));
            }
        }
    }
}
