//! Film from the window: frames, jobs of farms and wedges. They are made by the program's own
//! command line, in a process beside the window, so that the result is the one of a terminal, and
//! nothing that fails there takes the window down.

mod command_line;
mod frames;
mod outputs;
mod progress;
mod run;
mod sources;
mod variation;

pub(crate) use command_line::CommandLine;
pub(crate) use frames::{
    CONTRIBUTIONS, FarmChoices, FilmDocument, FrameChoices, LayerOption, MATTES, SampleDepth,
};
pub(crate) use outputs::{OfferedOutput, PickedOutput, matching_outputs, nearest_outputs};
pub(crate) use progress::{FrameFate, FrameProgress};
pub(crate) use run::{ProgramRun, RunEnd, RunLine};
pub(crate) use sources::FrameSources;
pub(crate) use variation::{ValueSpread, Variation, push_color};
