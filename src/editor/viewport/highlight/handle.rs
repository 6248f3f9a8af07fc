//! Handles of a highlight, their names, hints and values in words.

use chiaro_locale::tr;

use crate::fields::layer::{SelectedHighlight, Setting};
use crate::values;

/// Handle of a highlight.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum HighlightHandle {
    Middle,
    Ring,
    Stretch,
    /// Handle of a pair that parts the highlight along its first axis.
    Split(Side),
    /// Handle of a pair that parts the highlight along its second axis.
    SplitUp(Side),
    Size,
    Square,
    /// Notch between two rays of the star.
    Star,
    /// Tip of the ray after the first one.
    Rays,
}

/// Side of the middle on which a handle of a pair stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Ahead,
    Behind,
}

impl Side {
    /// Sign of the side along its axis.
    pub(super) fn sign(self) -> f32 {
        match self {
            Self::Ahead => 1.0,
            Self::Behind => -1.0,
        }
    }
}

impl HighlightHandle {
    /// All handles; of a pair the one that names it comes first.
    pub(super) const ALL: [Self; 11] = [
        Self::Middle,
        Self::Stretch,
        Self::Split(Side::Behind),
        Self::Split(Side::Ahead),
        Self::SplitUp(Side::Behind),
        Self::SplitUp(Side::Ahead),
        Self::Size,
        Self::Square,
        Self::Star,
        Self::Rays,
        Self::Ring,
    ];

    /// Name of the handle, as tests find it.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Middle => "Move",
            Self::Ring => "Turn",
            Self::Stretch => "Stretch",
            Self::Split(Side::Behind) => "Split",
            Self::Split(Side::Ahead) => "Split ahead",
            Self::SplitUp(Side::Behind) => "Split up",
            Self::SplitUp(Side::Ahead) => "Split up ahead",
            Self::Size => "Size",
            Self::Square => "Square",
            Self::Star => "Star",
            Self::Rays => "Rays",
        }
    }

    /// True for the handle of a pair that does not name it.
    pub(super) fn is_twin(self) -> bool {
        matches!(self, Self::Split(Side::Ahead) | Self::SplitUp(Side::Ahead))
    }

    /// Name of the handle of a layer, for who cannot see it.
    pub(super) fn label(self, layer: &str) -> String {
        match self {
            Self::Middle => tr!("Move {layer} on the object"),
            Self::Ring => tr!("Turn {layer} on the object"),
            Self::Stretch => tr!("Stretch {layer} on the object"),
            Self::Split(_) => tr!("Split {layer} on the object"),
            Self::SplitUp(_) => tr!("Split {layer} upward on the object"),
            Self::Size => tr!("Size {layer} on the object"),
            Self::Square => tr!("Square {layer} on the object"),
            Self::Star => tr!("Make {layer} a star on the object"),
            Self::Rays => tr!("Count the rays of {layer} on the object"),
        }
    }

    pub(super) fn hint(self) -> &'static str {
        match self {
            Self::Middle => tr!("Drag to move the highlight over the object"),
            Self::Ring => tr!("Drag to turn the highlight · Shift turns it by steps of 15°"),
            Self::Stretch => tr!("Drag outward to stretch the highlight, inward to shorten it"),
            Self::Split(_) => tr!("Drag outward to split the highlight, inward to join it"),
            Self::SplitUp(_) => {
                tr!("Drag outward to split the highlight along its upright axis, inward to join it")
            }
            Self::Size => tr!("Drag outward to make the highlight larger"),
            Self::Square => {
                tr!("Drag outward to draw out the highlight's corners, inward to round them")
            }
            Self::Star => tr!("Drag inward to make the highlight a star, outward to round it"),
            Self::Rays => tr!("Drag around the middle for more or fewer rays"),
        }
    }

    /// Setting of a handle that has one of its own.
    pub(super) fn setting(self, layer: &SelectedHighlight) -> Option<&Setting<f64>> {
        match self {
            Self::Size => None,
            Self::Middle => layer.moved.iter().max_by_key(|setting| setting.is_wired),
            Self::Ring => Some(&layer.turn),
            Self::Stretch => Some(&layer.stretch),
            Self::Split(_) => Some(&layer.split),
            Self::SplitUp(_) => layer.split_up.as_ref(),
            Self::Square => layer.square.as_ref(),
            Self::Star => layer.star.as_ref(),
            Self::Rays => layer.rays.as_ref(),
        }
    }

    /// True for a handle whose value can be set.
    pub(super) fn is_free(self, layer: &SelectedHighlight) -> bool {
        match self {
            Self::Size => layer.edge().is_some(),
            _ => self.setting(layer).is_some_and(|setting| !setting.is_wired),
        }
    }

    /// True for the handle of a shape that the layer does not have: a small one begins it. Move,
    /// turn, size and stretch are of every highlight.
    pub(super) fn is_idle(self, layer: &SelectedHighlight) -> bool {
        let is_of_shape =
            matches!(self, Self::Split(_) | Self::SplitUp(_) | Self::Square | Self::Star);
        let is_zero = |setting: &Setting<f64>| setting.value <= 0.0 && setting.at_key <= 0.0;
        is_of_shape && self.setting(layer).is_some_and(is_zero)
    }

    /// True for a handle that the layer shows: a star alone has rays, and one small handle is
    /// enough to begin a split.
    pub(super) fn is_shown(self, layer: &SelectedHighlight) -> bool {
        let stands = match self {
            Self::Rays => !Self::Star.is_idle(layer),
            _ => !(self.is_twin() && self.is_idle(layer)),
        };
        stands && self.is_free(layer)
    }

    /// Value of the handle in words.
    pub(super) fn value_text(self, layer: &SelectedHighlight) -> String {
        let setting = self.setting(layer);
        let number = setting.map_or(0.0, |setting| setting.value);
        let value = values::number_text(number, 2);
        match self {
            Self::Middle => {
                let [x, y] = layer.moved.each_ref().map(|it| values::number_text(it.value, 2));
                format!("{x}, {y}")
            }
            Self::Ring => format!("{}°", values::number_text(number.to_degrees(), 0)),
            Self::Size => {
                let edge = layer.edge().map_or(0.0, |edge| edge.at.to_degrees());
                format!("{}°", values::number_text(edge, 1))
            }
            Self::Stretch => tr!("Stretch {value}"),
            Self::Split(_) => tr!("Split {value}"),
            Self::SplitUp(_) => tr!("Split up {value}"),
            Self::Square => tr!("Square {value}"),
            Self::Star => tr!("Star {value}"),
            Self::Rays => tr!("Rays {value}", value = values::number_text(number.round(), 0)),
        }
    }
}
