//! Commands about painted light: brushes, fits, and their results.

use std::sync::Arc;

use chiaro_locale::tr;

use super::Switch;
use crate::document::{Look, Tile};
use crate::state::sketch::Standpoint;

/// Command about painted light; [`App`](crate::App) carries it out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FitCommand {
    /// Begins or ends painting on the picture.
    Turn(Switch),
    /// Gives up one activity, the nearest first: the stroke, the running fit, the fitted look, and
    /// at last painting on the picture.
    Leave,
    /// Fits the look to the strokes.
    Fit(FitGoal),
    /// Stops the fit that goes on.
    Stop,
    /// Takes on the fitted look.
    Apply,
    /// Drops the fitted look.
    Discard,
    /// Removes all strokes.
    Clear,
    /// Returns to the view that the strokes were painted in.
    Back,
    /// Takes a brush in hand.
    TakeBrush(LightBrush),
    ResizeBrush {
        is_larger: bool,
    },
}

/// Brush of painted light: the goal that its strokes set.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum LightBrush {
    /// Lighter than shown.
    Light,
    /// Darker than shown.
    Dark,
    /// A color.
    Color,
    /// The color that the look shows.
    Keep,
    /// Removes the goal.
    Erase,
}

impl LightBrush {
    /// All brushes, in the order of the bar.
    pub(crate) const ALL: [Self; 5] =
        [Self::Light, Self::Dark, Self::Color, Self::Keep, Self::Erase];

    /// Display name of the brush.
    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Light => tr!("brush" => "Light"),
            Self::Dark => tr!("brush" => "Dark"),
            Self::Color => tr!("brush" => "Color"),
            Self::Keep => tr!("brush" => "Keep"),
            Self::Erase => tr!("brush" => "Erase"),
        }
    }

    /// Explanation of the brush, with its key.
    pub(crate) fn help(self) -> &'static str {
        match self {
            Self::Light => tr!("Here it should be lighter, as if more light fell on it (B)"),
            Self::Dark => tr!("Here it should be darker (D)"),
            Self::Color => {
                tr!("Here it should have this color (C). Ctrl-click takes a color from the picture")
            }
            Self::Keep => tr!("Here it should stay as it is (K)"),
            Self::Erase => tr!("Takes strokes away (E)"),
        }
    }

    /// Name of a stroke in undo.
    pub(crate) fn step(self) -> &'static str {
        match self {
            Self::Light => tr!("paint light"),
            Self::Dark => tr!("paint dark"),
            Self::Color => tr!("paint a color"),
            Self::Keep => tr!("paint what stays"),
            Self::Erase => tr!("erase strokes"),
        }
    }
}

/// Goal of a fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FitGoal {
    /// New layers over the open look, where it was painted: nothing else changes.
    Local,
    /// The open look's own values: its nodes and wires stay.
    ThisLook,
    /// New layers, up to so many, in place of the look's nodes.
    Layers(usize),
}

/// Command about the strokes of light, and about the look that was fitted to them.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum SketchCommand {
    /// Shows or hides the strokes: undo takes them back only while they are seen.
    Open(bool),
    /// Replaces the painted strokes, as a step; a `tile` of `None` clears them.
    Paint { label: &'static str, from: Box<Standpoint>, tile: Option<Tile> },
    /// Shows another look in place of the open one, or the open one again.
    Preview(Option<Arc<Look>>),
}
