//! Commands about the shot over the scene.

use eframe::egui;

use crate::document::ShotEdit;
use crate::state::shot::ShotAddress;

/// Command about the open shot.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum ShotCommand {
    /// Begins a new shot over the open scene, or the scene under the open shot; over a look alone,
    /// puts a scene around it first.
    New,
    /// Begins a new shot over the open shot, which has all changes of that beneath its own.
    NewOver,
    /// Edits the shot, as an undo step of its own.
    Edit(ShotEdit),
    /// Edits the shot for as long as the same widget is held: one undo step in all.
    EditHeld(egui::Id, ShotEdit),
    /// Takes the shot's own change of a value back.
    Reset(ShotAddress),
    /// Keys a value at the present frame.
    Key(ShotAddress),
    /// Keys all values that the shot changes at the present frame.
    KeyAll,
    /// Takes all changes of the shot back.
    ResetAll,
    /// Makes keys of the shot of the camera that a mesh's file moves.
    KeyCameraOfFile,
    /// Brings a value that the shot changes into view: its object, its light or its node.
    Show(ShotAddress),
}
