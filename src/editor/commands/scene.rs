//! What panels and the picture ask for of a scene; [`App`](crate::App) does it.

use std::path::PathBuf;

use eframe::egui;

use crate::app::dialogs::Purpose;
use crate::document::SceneEdit;
use crate::ids::ObjectId;

/// Something that is asked for of the scene.
#[derive(Clone, Debug)]
pub(crate) enum Wish {
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
    Ask(Purpose, ObjectId, String),
    /// A file was chosen.
    Chosen(Purpose, PathBuf),
    /// Brings an object into view, or all.
    Frame(Option<ObjectId>),
    /// Lets the scene's camera and lights be as they are turned now.
    KeepView,
    /// Saves to the scene's own file; asks where there is none.
    Save,
    SaveAs,
    /// Puts the scene aside; the look stays open.
    Close,
}
