//! What is asked for of the scene around the look.

use std::path::PathBuf;

use eframe::egui;

use super::FilePurpose;
use crate::document::SceneEdit;
use crate::ids::ObjectId;
use crate::state::scene::ObjectPlace;

/// Something that is asked for of the scene.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum SceneCommand {
    /// A change as an undo step of its own.
    Edit(SceneEdit),
    /// A change that goes on for as long as the same widget is held: one undo step in all.
    EditHeld(egui::Id, SceneEdit),
    /// A change after which this object is selected.
    Make(ObjectId, SceneEdit),
    /// Selects an object and opens the look that it wears on a material, or on the first.
    Pick(ObjectId, Option<String>),
    /// Selects nothing.
    Unselect,
    /// Adds an object on a mesh: `shape:` and a name, or a path; asks for a file where there is
    /// none.
    Add(Option<String>),
    /// Asks for a file: a mesh for an object, or a look for one of its materials.
    Ask(FilePurpose, ObjectId, String),
    /// A file was chosen.
    Chosen(FilePurpose, PathBuf),
    /// Brings an object into view, or all.
    Frame(Option<ObjectId>),
    /// Tells where objects are, as of the last picture.
    Locate(Vec<ObjectPlace>),
    /// Lets the scene's camera and lights be as they are turned now.
    KeepView,
    /// Saves to the scene's own file; asks where there is none.
    Save,
    SaveAs,
    /// Puts the scene aside; the look stays open.
    Close,
}
