//! Layers of objects: nodes of their looks that lights reach or are filtered by, each with the rule
//! that decides for each light.

use std::collections::HashMap;

use chiaro_locale::tr;
use indexmap::IndexMap;

use super::matrix::LinkState;
use crate::document::{LightRelation, Look};
use crate::frame::{LayerReach, Setup};
use crate::ids::{LightId, NodePath, ObjectId};
use crate::library::Library;

/// Node of a look that an object wears, and what is told of it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct LayerRow {
    /// Name of the look.
    look: String,
    node: NodePath,
    /// True for lights that it filters, false for lights that reach it.
    pub(super) is_filter: bool,
}

impl LayerRow {
    /// The layer, called by its name, and a light in the relation, or not, as a sentence.
    pub(super) fn sentence(
        &self,
        is_so: bool,
        [name, light]: [&str; 2],
        object: &ObjectId,
    ) -> String {
        match (self.is_filter, is_so) {
            (false, true) => tr!("{name} of {object} is reached by {light}"),
            (false, false) => tr!("{name} of {object} is not reached by {light}"),
            (true, true) => tr!("{name} of {object} filters {light}"),
            (true, false) => tr!("{name} of {object} lets pass {light}"),
        }
    }
}

/// Relation of each light that a layer is about to it.
#[derive(Debug, Default)]
pub(super) struct LayerStates {
    /// Display name of the node.
    pub(super) name: String,
    pub(super) states: IndexMap<LightId, LinkState>,
}

/// Layers by object, in the order of the looks' nodes.
pub(super) type ObjectLayers = HashMap<ObjectId, IndexMap<LayerRow, LayerStates>>;

/// Layers of all objects of a setup, at a time in seconds.
pub(super) fn layers_of(setup: &Setup, library: &Library, time: f64) -> ObjectLayers {
    let mut found = ObjectLayers::new();
    for LayerReach { object, look, reach } in setup.layer_reach(library, time) {
        let is_filter = reach.relation == LightRelation::Filtered;
        let row = LayerRow { look, node: reach.node, is_filter };
        let of_object = found.entry(object).or_default();
        let name = || {
            let worn = setup.looks.iter().find(|worn| worn.look.name == row.look);
            worn.map_or_else(|| row.node.to_string(), |worn| name_of(&worn.look, &row.node))
        };
        if !of_object.contains_key(&row) {
            let states = LayerStates { name: name(), ..LayerStates::default() };
            of_object.insert(row.clone(), states);
        }
        let state = LinkState { is_so: reach.reaches, rule: reach.words };
        if let Some(layer) = of_object.get_mut(&row) {
            layer.states.insert(reach.light, state);
        }
    }
    found
}

/// Display name of a node through the groups that it lies in: names, labels of the look's own
/// groups, or ids.
fn name_of(look: &Look, path: &NodePath) -> String {
    let (mut graph, mut parts) = (Some(&look.graph), Vec::new());
    for id in path.ids() {
        let node = graph.and_then(|graph| graph.nodes.get(id));
        let definition = node.and_then(|node| look.definitions.get(node.kind.as_str()));
        let name = node.map(|node| node.name.as_str()).filter(|name| !name.is_empty());
        let label = definition.map(|definition| definition.label.as_str());
        let label = label.filter(|label| !label.is_empty());
        parts.push(name.or(label).unwrap_or(id.as_str()));
        graph = definition.map(|definition| &definition.graph);
    }
    parts.join(" / ")
}
