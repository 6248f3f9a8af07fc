//! Layers in groups that run for each light: such a group draws lights that nothing names.

use std::collections::{BTreeSet, VecDeque};
use std::rc::Rc;

use chiaro_locale::tr;
use indexmap::IndexMap;

use super::place::NodeInGraph;
use super::{SelectedLayer, group, profile};
use crate::document::LightSet;
use crate::fields::lighting::OwnedLight;
use crate::ids::LightId;
use crate::state::session::Session;

/// Largest number of nodes that are looked at.
const MOST_NODES: usize = 20_000;

/// Groups that run for a light, and the layers in them that follow from that light alone.
#[derive(Clone, Debug, Default)]
pub(crate) struct RegionLayers {
    /// Display names of the groups.
    pub(crate) groups: Vec<String>,
    /// Layers, each with the name of its group in its own.
    pub(crate) layers: Vec<SelectedLayer>,
    /// Index of the layer that is selected in the open group.
    pub(crate) selected: Option<usize>,
}

impl RegionLayers {
    /// Groups of the look that run for a light, wherever they lie.
    pub(crate) fn of(session: &Session, light: &LightId) -> Self {
        let mut found = Self::default();
        let Some(owned) = OwnedLight::lighting(session, light) else { return found };
        let only = IndexMap::from([(light.clone(), owned.light.clone())]);
        let runs_for = |set: &LightSet| set.of(&only, &BTreeSet::new()).contains(light);
        // Nodes with the name of the group around them that runs for the light.
        let mut open: VecDeque<(NodeInGraph<'_>, Option<Rc<str>>)> =
            NodeInGraph::of_look(session).map(|node| (node, None)).collect();
        let mut count = open.len();
        while let Some((node, region)) = open.pop_front() {
            let runs = node.node.for_each.as_ref().map(runs_for);
            if node.node.muted || runs == Some(false) {
                continue;
            }
            let is_region = runs == Some(true);
            let region = if is_region { Some(node.name().into()) } else { region };
            if is_region {
                found.groups.push(node.name());
            }
            let layer = region.as_ref().filter(|_| !is_region);
            let layer =
                layer.and_then(|region| Some((region, group(&node).or_else(|| profile(&node))?)));
            if let Some((region, layer)) = layer.filter(|(_, layer)| layer.light == *light) {
                let name = tr!("{layer} in {region}", layer = layer.name);
                found.layers.push(SelectedLayer { name, ..layer });
                continue;
            }
            if count < MOST_NODES {
                let each = is_region.then_some(light);
                let around = Rc::new(node);
                let before = open.len();
                open.extend(around.inside(each).map(|node| (node, region.clone())));
                count += open.len() - before;
            }
        }
        let selected = session.selection.nodes.last();
        let selected = selected.map(|id| session.selection.path_of(id));
        found.selected =
            found.layers.iter().position(|layer| Some(&layer.path) == selected.as_ref());
        found
    }
}
