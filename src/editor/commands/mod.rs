//! All commands of the window, as one tree. Panels, tools, keys, menus and the command palette
//! return [`Command`]s and change nothing themselves: [`App`](crate::App) applies them, in one
//! place.
//!
//! `table` has a row for each command that people ask for by its name, with its label, its help and
//! its keys; menus, the palette and the sheet of shortcuts list that table.

mod display;
mod file_purpose;
mod film;
mod fit;
mod graph;
pub(crate) mod keyboard;
mod library;
mod masking;
mod painting;
mod panel_id;
mod picture;
mod placing;
mod recovery;
mod scale;
mod scene;
mod shot;
mod snapshot;
pub(crate) mod table;
mod timeline;
mod tour;

use std::collections::BTreeMap;
use std::path::PathBuf;

use eframe::egui;

use crate::document::{Edit, Target};
use crate::ids::{DefinitionId, LightId, NodeId, NodePath};
use crate::state::keying::KeyPlace;
use crate::state::session::saving::OwnFiles;
use crate::state::solo::Solo;
use crate::state::wedge::{CellScope, WedgeCell};
use crate::state::wire::ShownWire;
pub(crate) use display::DisplayCommand;
pub(crate) use file_purpose::{FilePurpose, IMAGES, MESHES, PAINTING, is_image};
pub(crate) use film::FilmCommand;
pub(crate) use fit::{FitCommand, FitGoal, LightBrush, SketchCommand};
pub(crate) use graph::{GraphCommand, Heading};
pub(crate) use library::{LibraryCommand, PartSpot};
pub(crate) use masking::MaskCommand;
pub(crate) use painting::{GridPreset, PaintCommand, PaintTool, PictureImport};
pub(crate) use panel_id::PanelId;
pub(crate) use picture::{PictureExport, ViewCommand};
pub(crate) use placing::{LightMark, PlacingCommand};
pub(crate) use recovery::RecoveryCommand;
pub(crate) use scale::ScaleCommand;
pub(crate) use scene::SceneCommand;
pub(crate) use shot::ShotCommand;
pub(crate) use snapshot::SnapshotCommand;
pub(crate) use timeline::TimelineCommand;
pub(crate) use tour::TourTopic;

/// Command to the window.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Command {
    /// Edits the look, as an undo step of its own.
    Edit(Edit),
    /// Edits the look for as long as the same widget is held: one undo step in all.
    EditHeld(egui::Id, Edit),
    /// Selects these nodes and no others.
    Select(Vec<NodeId>),
    /// Selects a node and brings it into view.
    Reveal(NodeId),
    /// Selects a node in whichever group it lies, opens that group, and brings the node into view.
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
    /// Takes a file off the list of recent files.
    Forget(PathBuf),
    /// Shows the start page in place of the panels, or the panels again.
    ShowStart(bool),
    /// Begins a tour, on documents of its own.
    StartTour(TourTopic),
    /// Opens the command palette, or closes it.
    OpenPalette,
    /// Opens the sheet of shortcuts, or closes it.
    OpenShortcuts,
    /// Saves to the look's own file; asks for one where there is none.
    Save,
    SaveAs,
    /// Asks for a file, and saves to it with copies of the files that lie with the look.
    SaveWithFiles,
    /// Saves to this file; in another folder, with or without copies of the look's own files.
    SaveTo(PathBuf, OwnFiles),
    /// Shows the look on the mesh of this file, or on the built-in shape that `shape:` names; asks
    /// for a file where there is none.
    ShowOn(Option<PathBuf>),
    /// Sets whether the mesh's z axis points up, and not y.
    StandUp(bool),
    /// Turns the probe on or off.
    Probe(Switch),
    /// Lets go of the probed pixel, or else leaves the probe.
    LeaveProbe,
    /// Shows a wire in place of the picture, or the picture again.
    ShowWire(Option<ShownWire>),
    /// Takes the notes about the open documents as read: the status line no longer shows them.
    ReadNotes,
    /// Shows a message in the status line.
    Tell(String),
    /// Writes a picture to a file; asks for one where there is none.
    Export(PictureExport, Option<PathBuf>),
    /// Writes the picture in its size on the screen; asks for the file.
    ExportPicture,
    /// Writes the look as shaders of a language, or of all, into a folder; asks for one where there
    /// is none.
    ExportLook(&'static str, Option<PathBuf>),
    /// Copies the picture to the clipboard.
    CopyPicture,
    /// Copies the shader to the clipboard.
    CopyWgsl,
    /// Copies the shader in a language to the clipboard: the one of its files with this ending.
    CopyShader(&'static str, &'static str),
    /// Shows an image with the picture; asks for one where there is none.
    ShowReference(Option<PathBuf>),
    /// Asks for the image of an input.
    AskImage(Target),
    /// Takes an image for the input that it was asked for.
    TakeImage(PathBuf),
    /// Command about the view of OpenColorIO that the picture is shown by.
    Display(DisplayCommand),
    /// Shows layers or lights alone, or leaves lights out; the document is unchanged.
    Solo(Solo),
    /// Remembers columns of the light table that are shown or hidden by hand, by their words.
    KeepLightColumns(BTreeMap<String, bool>),
    /// Compares the frames of the timeline with rendered ones, of this file's sequence or of this
    /// folder, or with another document; asks for one where there is none.
    CompareFrames(Option<PathBuf>),
    /// Remembers the memory that frames of playback take, in MiB.
    KeepFrameMemory(u32),
    /// Remembers the farm, by its word, that jobs are for.
    KeepFarm(&'static str),
    /// Chooses the light that handles, placing and looking through are of.
    ChooseLight(LightId),
    /// Links the lights that are selected in the links' pane to the object under the pointer, or
    /// with `false` unlinks them.
    LinkPointed(bool),
    /// Scales the window.
    Scale(ScaleCommand),
    /// Speaks the language of this tag from now on, or the system's.
    Speak(Option<&'static str>),
    /// Brings a panel to the front.
    ShowPanel(PanelId),
    /// Takes steps back, or repeats them, until so many are done.
    GoTo(usize),
    /// Adds a node of a kind at a point of the screen, or in the middle of the canvas.
    AddNode {
        kind: String,
        at: Option<egui::Pos2>,
    },
    /// Puts a group of the look's own where all looks of the project have it.
    ShareGroup(DefinitionId),
    /// Begins a new look from an example of the library, by its index.
    OpenExample(usize),
    /// Copies text to the clipboard.
    Copy(String),
    /// Selects the direction key at which values are set from now on; `None` for the key that
    /// weighs most.
    SelectKey(Option<KeyPlace>),
    /// Moves the playhead, in seconds.
    SetTime(f64),
    /// Command to the timeline.
    Timeline(TimelineCommand),
    /// Takes the values of a wedge's cell, in a shot for these frames.
    TakeCell(WedgeCell, CellScope),
    /// Command about the view of the object.
    View(ViewCommand),
    /// Command about the graph on the canvas.
    Graph(GraphCommand),
    /// Command about the library of parts.
    Library(LibraryCommand),
    /// Command about the scene around the look.
    Scene(SceneCommand),
    /// Command about the snapshots of the look.
    Snapshot(SnapshotCommand),
    /// Command about the HCBTF that is being painted.
    Paint(PaintCommand),
    /// Command about frames, farms' jobs and wedges.
    Film(FilmCommand),
    /// Command about painting light on the picture.
    Fit(FitCommand),
    /// Command about placing a light by what it does.
    Placing(PlacingCommand),
    /// Command about a mask that is painted on the mesh.
    Mask(MaskCommand),
    /// Command about the strokes of light, and about the look that was fitted to them.
    Sketch(SketchCommand),
    /// Command of the bar of unsaved work and changed files.
    Recovery(RecoveryCommand),
}

impl Command {
    /// True if the command changes only the view or a stroke: the result is drawn in the same
    /// frame.
    pub(crate) fn is_drawn_at_once(&self) -> bool {
        matches!(
            self,
            Self::View(ViewCommand::TurnTo(_))
                | Self::Scene(SceneCommand::Locate(_))
                | Self::Paint(PaintCommand::ShowStroke(_))
                | Self::Sketch(SketchCommand::Paint { .. })
        )
    }
}

/// Switch of a tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Switch {
    On,
    Off,
    /// On where the tool is off, and off where it is on.
    Toggle,
}

impl Switch {
    /// True if the tool is on afterwards.
    pub(crate) fn turned(self, is_on: bool) -> bool {
        match self {
            Self::On => true,
            Self::Off => false,
            Self::Toggle => !is_on,
        }
    }
}

impl From<bool> for Switch {
    fn from(is_on: bool) -> Self {
        if is_on { Self::On } else { Self::Off }
    }
}
