//! Commands about frames, farms' jobs and wedges, which the program makes beside the window.

use std::path::PathBuf;

use crate::state::runs::Variation;

/// Command about film.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum FilmCommand {
    /// Renders the frames that the panel *Render* asks for.
    Render,
    /// Asks the program to stop rendering; frames that are whole stay.
    StopFrames,
    /// Writes the job of a farm.
    WriteJob,
    /// Brings the choices of a farm's job into view.
    ShowFarm,
    /// Sets the folder of the frames; asks for one where there is none.
    ChooseFolder(Option<PathBuf>),
    /// Opens a file or a folder in the system's own program.
    OpenPath(PathBuf),
    /// Adds a value to those that the next wedge tries.
    Vary(Variation),
    /// Draws the wedge.
    DrawWedge,
    /// Asks the program to stop drawing the wedge.
    StopWedge,
    /// Shows the sheet of the panel *Wedge* in place of the graph, or the graph again.
    EnlargeWedge(bool),
    /// Shows the wedge that was drawn.
    ShowWedge(PathBuf),
}
