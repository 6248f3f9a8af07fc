//! The selected highlight layer, as far as it is shaped on the object.

use super::Setting;
use super::place::NodeInGraph;
use crate::document::{Target, Value};
use crate::fields::edge::{ProfileEdge, in_order};
use crate::ids::LightId;
use crate::state::session::Session;

/// Selected layer of a shaped highlight: a group with the inputs of one.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SelectedHighlight {
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
    /// Offset, fall-off and cut-off, in radians.
    shape: [Setting<f64>; 3],
}

impl SelectedHighlight {
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
        name: place.name(),
        moved: [place.number("across")?, place.number("up")?],
        turn: place.number("turn")?,
        stretch: place.number("stretch")?,
        split: place.number("split")?,
        shape: place.shape()?,
        light: place.light()?,
    })
}
