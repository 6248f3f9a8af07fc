//! Commands about the picture: its view, and its exports.

use crate::state::comparison::ComparedPicture;
use crate::state::orbit::Orbit;
use crate::state::variations::VariedSubject;
use crate::state::view::TransformPart;

/// Picture to export.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PictureExport {
    /// The picture as it is, of this size in pixels.
    Picture([u32; 2]),
    /// The look on a ball, of this width in pixels.
    LitSphere(u32),
}

/// Command about the view of the object, or about what is shown over it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum ViewCommand {
    /// Turns to another view, or turns the lights.
    TurnTo(Box<Orbit>),
    /// Turns camera and lights back.
    Reset,
    /// Turns an object that faces away by half; without a scene, camera and lights around it.
    TurnAround,
    /// Brings the object into view; of a scene the selected one.
    FrameObject,
    /// Brings all objects into view.
    FrameAll,
    /// Switches between perspective and parallel projection.
    SwitchProjection,
    /// Starts or stops the turntable.
    ToggleTurntable,
    /// Shows or hides handles on the object.
    ToggleHandles,
    /// Shows handles of a part of the selected object's transform, or hides them.
    ToggleTransform(TransformPart),
    /// Looks through the selected light, or from the camera again.
    LookThrough,
    /// Compares the picture with another, or asks for a file with one.
    Compare(Option<ComparedPicture>),
    /// Shows a sheet of variations.
    Vary(VariedSubject),
}
