//! Commands about placing a light by what it does.

use chiaro_locale::{Text, text, tr};

use super::Switch;

/// Mark that a light leaves on a surface, and that it is placed by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum LightMark {
    /// The place where the light is mirrored.
    Highlight,
    /// The shadow of a caster.
    Shadow,
    /// The edge of what the light lights.
    Terminator,
}

impl LightMark {
    /// All marks, in the order of the bar.
    pub(crate) const ALL: [Self; 3] = [Self::Highlight, Self::Shadow, Self::Terminator];

    /// Display name of the mark.
    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Highlight => tr!("Highlight"),
            Self::Shadow => tr!("Shadow"),
            Self::Terminator => tr!("Terminator"),
        }
    }

    /// Explanation of placing by the mark.
    pub(crate) fn help(self) -> Text {
        match self {
            Self::Highlight => {
                text!(
                    "Click on the model: the light goes where its highlight is there. Of a light \
                     whose layers mirror nothing it is the bright middle"
                )
            }
            Self::Shadow => {
                text!(
                    "Click what casts the shadow, then the place where it falls: the light goes on \
                     the line through both"
                )
            }
            Self::Terminator => {
                text!(
                    "Click on the model: the light goes where its layer's tone has fallen to a \
                     half there, or where its hard edge is"
                )
            }
        }
    }
}

/// Command about placing a light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PlacingCommand {
    /// Begins or ends placing, by the mark of the last time.
    Turn(Switch),
    /// Begins to place by a mark, or ends it where that mark is in use.
    By(LightMark),
    /// Gives up one activity, the nearest first: the drag, the chosen caster, and at last placing.
    Leave,
}
