//! What is asked for of painted light: brushes, fits, what comes of them.

use std::sync::Arc;

use super::Switch;
use crate::document::{Look, Tile};
use crate::state::sketch::Standpoint;

/// Something that is asked for of painted light; [`App`](crate::App) does it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FitCommand {
    /// Begins to paint on the picture, or ends that.
    Turn(Switch),
    /// Gives up what is going on, the nearest thing first, and at last the painting.
    Leave,
    /// Fits to what is painted.
    Fit(FitGoal),
    /// Gives up the fit that is going on.
    Stop,
    /// Takes on what was fitted.
    Apply,
    /// Lets go of what was fitted.
    Discard,
    /// Takes all strokes away.
    Clear,
    /// Looks from where the strokes were painted.
    Back,
    /// Takes a brush in hand.
    TakeBrush(LightBrush),
    ResizeBrush {
        is_larger: bool,
    },
}

/// A brush of painted light: what its strokes ask for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum LightBrush {
    /// Lighter than it is seen.
    Light,
    /// Darker than it is seen.
    Dark,
    /// A color.
    Color,
    /// As the look shows it.
    Keep,
    /// Nothing any more.
    Erase,
}

impl LightBrush {
    /// All, in the order of the bar.
    pub(crate) const ALL: [Self; 5] =
        [Self::Light, Self::Dark, Self::Color, Self::Keep, Self::Erase];

    /// What people call it.
    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Light => "Light",
            Self::Dark => "Dark",
            Self::Color => "Color",
            Self::Keep => "Keep",
            Self::Erase => "Erase",
        }
    }

    /// What it does, with its key.
    pub(crate) fn help(self) -> &'static str {
        match self {
            Self::Light => "Here it should be lighter, as if more light fell on it (B)",
            Self::Dark => "Here it should be darker (D)",
            Self::Color => {
                "Here it should have this color (C). Ctrl-click takes a color from the picture"
            }
            Self::Keep => "Here it should stay as it is (K)",
            Self::Erase => "Takes strokes away (E)",
        }
    }

    /// What undo calls a stroke of it.
    pub(crate) fn step(self) -> &'static str {
        match self {
            Self::Light => "paint light",
            Self::Dark => "paint dark",
            Self::Color => "paint a color",
            Self::Keep => "paint what stays",
            Self::Erase => "erase strokes",
        }
    }
}

/// What is fitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FitGoal {
    /// What the open look has: its nodes and wires stay.
    ThisLook,
    /// Up to so many layers from nothing, in place of the look's nodes.
    Layers(usize),
}

/// Something that is asked for of the strokes of light, and of the look that was fitted to them.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum SketchCommand {
    /// Lets the strokes be seen, so that undo takes them back; or not.
    Open(bool),
    /// Paints on the picture, as a step; no tile for nothing.
    Paint { label: &'static str, from: Standpoint, tile: Option<Tile> },
    /// Shows another look in place of the open one, or the open one again.
    Preview(Option<Arc<Look>>),
}
