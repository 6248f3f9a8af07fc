//! What is asked for of the picture: the view on it and what leaves the window.

use crate::state::orbit::Orbit;

/// A picture that leaves the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PictureExport {
    /// The picture as it is, in so many pixels.
    Picture([u32; 2]),
    /// The look on a ball, so many pixels wide.
    LitSphere(u32),
}

/// Something that is asked for of the view on the object, or of what is shown over it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum ViewCommand {
    /// Looks from elsewhere, or under lights that are turned otherwise.
    TurnTo(Box<Orbit>),
    /// Turns camera and lights back.
    Reset,
    /// Brings the object into view; of a scene the selected one.
    FrameObject,
    /// Brings all objects into view.
    FrameAll,
    /// From perspective to parallel, and back.
    SwitchProjection,
    /// Starts or stops the turntable.
    ToggleTurntable,
    /// Shows or hides handles on the object.
    ToggleHandles,
}
