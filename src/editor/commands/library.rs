//! Commands about the library of parts.

use std::path::PathBuf;
use std::sync::Arc;

use crate::document::Wire;
use crate::ids::{NodeId, ObjectId, PortName};
use crate::state::parts::Part;
use crate::state::parts::saving::{PartChoice, PartDraft};

/// Command about the library.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum LibraryCommand {
    /// Shows the form by which a part of the look is saved.
    Offer(PartChoice),
    /// Saves a part to a new file of a folder.
    Save(Box<PartDraft>, PathBuf),
    /// Saves a part over the file of another.
    Replace(Box<PartDraft>, PathBuf),
    /// Gives a saved part another name; its file keeps its own.
    Rename(Arc<Part>, String),
    /// Deletes the file of a saved part: the user has agreed.
    Remove(Arc<Part>),
    /// Opens the folder that a file lies in.
    ShowFile(PathBuf),
    /// Puts a part into the look.
    Place(Arc<Part>, PartSpot),
    /// Adds a folder that others share, or asks for one.
    AddFolder(Option<PathBuf>),
    /// Takes a folder off the list; its files stay.
    RemoveFolder(PathBuf),
}

/// Place where a part is put.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum PartSpot {
    /// Wherever the selection says.
    Selection,
    /// A layer of the look.
    Layer(NodeId),
    /// On top of all layers.
    Top,
    /// A point of the canvas, in points of the graph.
    Canvas([f64; 2]),
    /// A wire of the graph that is open.
    Wire(Wire),
    /// An input of the selected node.
    Input(PortName),
    /// An object of the scene.
    Object(ObjectId),
}
