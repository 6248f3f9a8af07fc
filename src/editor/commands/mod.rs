//! What panels ask for. They change nothing themselves: [`App`](crate::App) applies commands, in
//! one place.

pub(crate) mod scene;
pub(crate) mod shortcuts;

use eframe::egui;
use std::path::PathBuf;

use crate::app::dock::Panel;
use crate::commands::shortcuts::Action;
use crate::document::Edit;
use crate::ids::{DefinitionId, NodeId, NodePath};
use crate::painter as painting;
use crate::state::orbit::Orbit;
use crate::state::safety::Wish;
use crate::state::solo::Solo;
use crate::state::stage;
use crate::state::wire::ShownWire;
use crate::tools::fitting;
use crate::viewport::Export;

/// Something that a panel asks for.
#[derive(Clone, Debug)]
pub(crate) enum Command {
    /// A change of the look as an undo step of its own.
    Edit(Edit),
    /// A change that goes on for as long as the same widget is held: one undo step in all.
    EditHeld(egui::Id, Edit),
    /// Selects these nodes and no others.
    Select(Vec<NodeId>),
    /// Selects a node and brings it into view.
    Reveal(NodeId),
    /// Selects a node in whichever group it lies, opens that, and brings it into view.
    Show(NodePath),
    /// Opens the graph that these nodes of groups lead to; none for the look's own.
    OpenGraph(Vec<NodeId>),
    Undo,
    Redo,
    New,
    /// Opens a file; asks for one where there is none.
    Open(Option<PathBuf>),
    /// Asks for a path to open in the window itself.
    OpenPath,
    /// Takes a file off the list of those that were open.
    Forget(PathBuf),
    /// Shows the start page in place of the panels, or the panels again.
    ShowStart(bool),
    /// Begins the tour, on a look of its own.
    StartTour,
    /// Saves to the look's own file; asks where there is none.
    Save,
    SaveAs,
    /// Saves to this file.
    SaveTo(PathBuf),
    /// Shows the look on the mesh of this file, or on the own shape that `shape:` names; asks for a
    /// file where there is none.
    ShowOn(Option<PathBuf>),
    /// Whether the mesh's z axis points up, and not y.
    StandUp(bool),
    /// Turns the probe on or off.
    Probe(bool),
    /// Lets go of the probed pixel, or else leaves the probe.
    LeaveProbe,
    /// Shows a wire in place of the picture, or the picture again.
    ShowWire(Option<ShownWire>),
    /// Tells something in the status line.
    Tell(String),
    /// Does what a key, a menu or the command palette asks for.
    Act(Action),
    /// Writes a picture to a file; asks for one where there is none.
    Export(Export, Option<PathBuf>),
    /// Writes the look as shaders of a language, or of all, into a folder; asks for one where there
    /// is none.
    ExportLook(&'static str, Option<PathBuf>),
    /// Copies the picture to the clipboard.
    CopyPicture,
    /// Copies the shader to the clipboard.
    CopyWgsl,
    /// Shows an image with the picture; asks for one where there is none.
    ShowReference(Option<PathBuf>),
    /// Shows layers or lights alone, or leaves lights out; the document stays as it is.
    Solo(Solo),
    /// Brings a panel to the front.
    ShowPanel(Panel),
    /// Takes steps back, or repeats them, until so many are done.
    GoTo(usize),
    /// Adds a node of a kind at a place of the screen, or in the middle of the canvas.
    AddNode {
        kind: String,
        at: Option<egui::Pos2>,
    },
    /// Puts a group of the look's own where all looks of the project have it.
    ShareGroup(DefinitionId),
    /// Begins a new look with an example of the library, by its number.
    OpenExample(usize),
    /// Copies text to the clipboard.
    Copy(String),
    /// Sets values at this direction key from now on: a set and a key of it; at none, at the one
    /// that weighs most.
    SelectKey(Option<(usize, usize)>),
    /// Moves the playhead, in seconds.
    SetTime(f64),
    /// Looks from elsewhere, or under lights that are turned otherwise.
    TurnTo(Box<Orbit>),
    /// What is asked for of the scene around the look.
    Stage(stage::Wish),
    /// What is asked for of the HCBTF that is being painted.
    Paint(painting::Wish),
    /// What is asked for of painting light on the picture.
    Fit(fitting::Wish),
    /// What the bar of unsaved work and changed files asks for.
    Safety(Wish),
}
