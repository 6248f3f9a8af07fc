//! Commands about the scene around the look.

use std::path::PathBuf;

use eframe::egui;

use super::{FilePurpose, ShotCommand};
use crate::document::SceneEdit;
use crate::ids::ObjectId;
use crate::state::scene::ObjectPlace;

/// Command about the scene.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum SceneCommand {
    /// Edits the scene, as an undo step of its own.
    Edit(SceneEdit),
    /// Edits the scene for as long as the same widget is held: one undo step in all.
    EditHeld(egui::Id, SceneEdit),
    /// Edits the scene, and selects this object.
    Make(ObjectId, SceneEdit),
    /// Selects an object and opens the look that it wears on a material, or on the first.
    Pick(ObjectId, Option<String>),
    /// Deselects the object.
    Unselect,
    /// Adds an object on a mesh: `shape:` and a name, or a path; asks for a file where there is
    /// none.
    Add(Option<String>),
    /// Asks for a file: a mesh for an object, or a look for one of its materials.
    Ask(FilePurpose, ObjectId, String),
    /// Takes the file that was chosen.
    Chosen(FilePurpose, PathBuf),
    /// Brings an object into view, or all.
    Frame(Option<ObjectId>),
    /// Notes the positions of objects, as of the last picture.
    Locate(Vec<ObjectPlace>),
    /// Sets the scene's camera and lights to the present view.
    KeepView,
    /// Saves to the scene's own file; asks for one where there is none.
    Save,
    /// Asks for a file, and saves to it; where no scene is open, one of the picture's mesh, camera
    /// and lights.
    SaveAs,
    /// Asks for a file, and saves to it with copies of the files that lie with the scene.
    SaveWithFiles,
    /// Puts the scene aside; the look stays open.
    Close,
    /// Command about the shot over the scene.
    Shot(ShotCommand),
}
