//! The selected highlight layer, as far as it is shaped on the object.

use super::Setting;
use super::place::NodeInGraph;
use crate::document::{Target, Value};
use crate::fields::edge::{ProfileEdge, in_order};
use crate::ids::{LightId, NodePath};
use crate::state::session::Session;

/// Selected layer of a shaped highlight: a group with the inputs of one.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SelectedHighlight {
    pub(crate) node: NodePath,
    pub(crate) name: String,
    pub(crate) light: LightId,
    /// Distances that the highlight is moved, to the right and upward; 1 is an eighth of a turn.
    pub(crate) moved: [Setting<f64>; 2],
    /// Angle that it is turned, in radians, counter-clockwise.
    pub(crate) turn: Setting<f64>,
    /// Part by which it is longer along its first axis.
    pub(crate) stretch: Setting<f64>,
    /// Distance of its halves along the first axis.
    pub(crate) split: Setting<f64>,
    /// Distance of its halves along the second axis; `None` for a group without such an input, as
    /// for those below.
    pub(crate) split_up: Option<Setting<f64>>,
    /// Part by which its corners are drawn out.
    pub(crate) square: Option<Setting<f64>>,
    /// Depth of the notches between its rays.
    pub(crate) star: Option<Setting<f64>>,
    /// Number of rays.
    pub(crate) rays: Option<Setting<f64>>,
    /// Offset, fall-off and cut-off, in radians.
    shape: [Setting<f64>; 3],
}

/// Present shape of a highlight around its middle; angles are in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct HighlightShape {
    /// Angle from the middle at which its tone falls, and the one at which it is 0.
    pub(crate) radius: f64,
    pub(crate) cutoff: f64,
    pub(crate) turn: f64,
    pub(crate) stretch: f64,
    /// Distances of its parts along both axes.
    pub(crate) split: [f64; 2],
    pub(crate) square: f64,
    pub(crate) star: f64,
    pub(crate) rays: f64,
}

impl HighlightShape {
    /// Least part that a stretch or corners leave of a length: more draws it out without end.
    const LEAST_LEFT: f64 = 0.1;

    /// True if the highlight may cover a place `aside` of its middle, as angles to the right and
    /// upward; the gap between its parts counts as covered.
    pub(crate) fn covers(&self, aside: [f64; 2]) -> bool {
        let ((sin, cos), [right, up]) = (self.turn.sin_cos(), aside);
        let along = [cos * right + sin * up, cos * up - sin * right];
        let left = |part: f64| (1.0 - part).max(Self::LEAST_LEFT);
        let radius = self.cutoff / left(self.square);
        let radii = [radius / left(self.stretch), radius];
        let beyond = |axis: usize| {
            let beyond = (along[axis].abs() - self.split[axis].max(0.0)).max(0.0);
            beyond / radii[axis].max(f64::EPSILON)
        };
        beyond(0).hypot(beyond(1)) < 1.0
    }
}

impl SelectedHighlight {
    /// Shape that is drawn now.
    pub(crate) fn drawn_shape(&self) -> HighlightShape {
        let [_, radius, cutoff] = in_order(self.shape.each_ref().map(|setting| setting.value));
        let value = |setting: &Option<Setting<f64>>| setting.as_ref().map_or(0.0, |it| it.value);
        HighlightShape {
            radius,
            cutoff,
            turn: self.turn.value,
            stretch: self.stretch.value,
            split: [self.split.value, value(&self.split_up)],
            square: value(&self.square),
            star: value(&self.star),
            rays: value(&self.rays),
        }
    }

    /// Edge of the highlight, as far from its middle as it is large; `None` where its profile is no
    /// edge, or comes by wires.
    pub(crate) fn edge(&self) -> Option<ProfileEdge> {
        let is_free = self.shape.iter().all(|setting| !setting.is_wired);
        let angles = in_order(self.shape.each_ref().map(|setting| setting.at_key));
        ProfileEdge::of(angles).filter(|_| is_free)
    }

    /// Values of the three angles for an edge.
    pub(crate) fn values_of(&self, edge: ProfileEdge) -> Vec<(Target, Value)> {
        let targets = self.shape.iter().map(|setting| setting.target.clone());
        targets.zip(edge.angles().map(Value::Number)).collect()
    }
}

/// Highlight layer of the node that was selected last, if there is one.
pub(crate) fn selected_highlight(session: &Session) -> Option<SelectedHighlight> {
    if session.graph_view().is_read_only() {
        return None;
    }
    let place = NodeInGraph::of(session, session.selection.nodes.last()?)?;
    Some(SelectedHighlight {
        node: place.path.clone(),
        name: place.name(),
        moved: [place.number("across")?, place.number("up")?],
        turn: place.number("turn")?,
        stretch: place.number("stretch")?,
        split: place.number("split")?,
        split_up: place.number("split_up"),
        square: place.number("square"),
        star: place.number("star"),
        rays: place.number("rays"),
        shape: place.shape()?,
        light: place.light()?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const DISC: HighlightShape = HighlightShape {
        radius: 0.1,
        cutoff: 0.1,
        turn: 0.0,
        stretch: 0.0,
        split: [0.0; 2],
        square: 0.0,
        star: 0.0,
        rays: 4.0,
    };

    #[test]
    fn a_shape_covers_what_its_values_draw_out() {
        assert!(DISC.covers([0.09, 0.0]) && !DISC.covers([0.0, 0.11]) && !DISC.covers([0.08; 2]));
        let stretched = HighlightShape { stretch: 0.5, ..DISC };
        assert!(stretched.covers([0.19, 0.0]) && !stretched.covers([0.0, 0.11]));
        // A quarter turn puts the first axis upright.
        let turned = HighlightShape { turn: std::f64::consts::FRAC_PI_2, ..stretched };
        assert!(turned.covers([0.0, 0.19]) && !turned.covers([0.11, 0.0]));
        let split = HighlightShape { split: [0.3, 0.0], ..DISC };
        assert!(split.covers([0.39, 0.0]) && split.covers([0.0; 2]) && !split.covers([0.3, 0.11]));
        assert!(HighlightShape { square: 0.5, ..DISC }.covers([0.13; 2]), "a corner");
        assert!(HighlightShape { square: 1.0, stretch: 1.0, ..DISC }.covers([9.0, 0.0]));
        assert!(!HighlightShape { cutoff: 0.0, ..DISC }.covers([0.0, 0.01]), "none at all");
    }
}
