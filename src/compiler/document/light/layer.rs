//! Links of nodes: which lights reach a node, and which pass through it, as the look says and as a
//! scene says over it.

use super::LightLink;
use crate::document::described::described;
use crate::document::set::LightSet;
use crate::document::shape::FieldKind;
use crate::ids::NodeId;

described! {
    /// Lights that reach a node, and lights that pass through it.
    #[derive(Eq, Hash)]
    #[serde(default)]
    pub struct NodeLinks("node links", Line) {
        /// Lights that reach the node, of a group every node in it; `{source}` are those that reach
        /// the group around it.
        #[serde(skip_serializing_if = "LightSet::is_all")]
        layered: LightSet = LightSet::all(), FieldKind::LightSet;
        /// Lights that do not reach it all the same; `{source}` are those of `layered`.
        #[serde(skip_serializing_if = "LightSet::is_none")]
        unlayered: LightSet = LightSet::none(), FieldKind::LightSet;
        /// Lights that the node filters; others pass as if it were not there.
        #[serde(skip_serializing_if = "LightSet::is_all")]
        filtered: LightSet = LightSet::all(), FieldKind::LightSet;
        /// Lights that it does not filter all the same; `{source}` are those of `filtered`.
        #[serde(skip_serializing_if = "LightSet::is_none")]
        unfiltered: LightSet = LightSet::none(), FieldKind::LightSet;
    }
}

described! {
    /// Lights of a node of the looks that an object wears, over what the looks say.
    #[derive(Eq, Hash)]
    pub struct LayerLink("layer link", Line, by node) {
        /// Id of a node in the look's own graph.
        node: NodeId, FieldKind::Slug, required;
        /// Lights that reach the node; `{source}` are those that reach it by the look.
        layered: LightSet = LightSet::source(), FieldKind::LightSet;
        /// Lights that do not reach it all the same; `{source}` are those of `layered`.
        unlayered: LightSet = LightSet::none(), FieldKind::LightSet;
        /// Lights that the node filters; `{source}` are those that it filters by the look.
        filtered: LightSet = LightSet::source(), FieldKind::LightSet;
        /// Lights that it does not filter all the same; `{source}` are those of `filtered`.
        unfiltered: LightSet = LightSet::none(), FieldKind::LightSet;
    }
}

impl LayerLink {
    /// A row for a node that leaves everything as the look says.
    pub fn new(node: NodeId) -> Self {
        Self {
            node,
            layered: LightSet::source(),
            unlayered: LightSet::none(),
            filtered: LightSet::source(),
            unfiltered: LightSet::none(),
        }
    }
}

impl NodeLinks {
    /// True if all lights reach the node, and all pass through it.
    pub fn is_all(&self) -> bool {
        self.layered_link().is_all() && self.filtered_link().is_all()
    }

    /// Link of the lights that reach the node.
    pub fn layered_link(&self) -> LightLink {
        LightLink { linked: self.layered.clone(), unlinked: self.unlayered.clone() }
    }

    /// Link of the lights that the node filters.
    pub fn filtered_link(&self) -> LightLink {
        LightLink { linked: self.filtered.clone(), unlinked: self.unfiltered.clone() }
    }

    /// The links under what a scene says of the node.
    #[must_use]
    pub fn under(&self, row: &LayerLink) -> Self {
        let own = |set: &LightSet, without: &LightSet| set.minus(&without.with_source(set));
        Self {
            layered: row.layered.with_source(&own(&self.layered, &self.unlayered)),
            unlayered: row.unlayered.clone(),
            filtered: row.filtered.with_source(&own(&self.filtered, &self.unfiltered)),
            unfiltered: row.unfiltered.clone(),
        }
    }
}
