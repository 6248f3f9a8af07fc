//! Commands about the view of OpenColorIO that the picture is shown by.

use std::path::PathBuf;

use crate::state::display::DisplayChoice;

/// Command about the view that the picture is shown by.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum DisplayCommand {
    /// Shows the picture by a view, or by the curve of sRGB.
    Show(Option<DisplayChoice>),
    /// Shows the picture by the first view of a configuration; asks for its file where there is
    /// none.
    Open(Option<PathBuf>),
}
