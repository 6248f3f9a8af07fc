//! Looks as objects wear them: with the words that objects set, the lights that objects give to
//! single nodes, and the scene's lights in the sets that looks name.

use std::borrow::Cow;
use std::collections::BTreeSet;

use chiaro_locale::tr;

use super::keys::structural_look;
use super::links::located;
use super::setup::{Setup, SetupObject};
use crate::diag::Diagnostic;
use crate::document::{LayerLink, Light, Look, Scene};
use crate::ids::{LightId, NodeId};
use crate::library::Library;

impl Setup {
    /// The look of that number as an object wears it at a time, in seconds.
    pub fn worn(
        &self,
        look: usize,
        object: &SetupObject,
        library: &Library,
        time: f64,
    ) -> Cow<'_, Look> {
        let worn = structural_look(&self.looks[look].look, library, time, &object.values);
        with_lights_of(&self.scene, with_layers(worn, &object.layers))
    }

    /// Warnings of an object's rows for nodes that none of its looks has.
    pub(super) fn layer_warnings(&self, object: &SetupObject) -> Vec<Diagnostic> {
        let index = self.scene.objects.get_index_of(&object.id).unwrap_or_default();
        let worn: BTreeSet<usize> = object.worn_looks().collect();
        let looks = || worn.iter().map(|look| &self.looks[*look].look.graph.nodes);
        let mut found = Vec::new();
        for (row, link) in object.layers.iter().enumerate() {
            if looks().any(|nodes| nodes.contains_key(&link.node)) {
                continue;
            }
            let message = tr!(
                "`layers` of object `{id}` names the node `{node}`, which none of its looks has",
                id = object.id,
                node = link.node
            );
            let known = looks().flat_map(|nodes| nodes.keys().map(NodeId::as_str));
            let problem = Diagnostic::warning("unknown-node", message)
                .suggest(link.node.as_str(), known)
                .hint(tr!(
                    "name a node of a look's own graph: what lies in a group is the group's"
                ));
            found.push(located(self, problem, format!("objects[{index}].layers[{row}].node")));
        }
        found
    }
}

/// A look whose nodes are lit as an object says.
fn with_layers<'l>(look: Cow<'l, Look>, layers: &[LayerLink]) -> Cow<'l, Look> {
    let mut look = look;
    for row in layers.iter().filter(|row| **row != LayerLink::new(row.node.clone())) {
        if look.graph.nodes.contains_key(&row.node)
            && let Some(node) = look.to_mut().graph.nodes.get_mut(&row.node)
        {
            node.links = node.links.under(row);
        }
    }
    look
}

/// A look that names lights by sets, with the scene's lights beside its own, and with the names and
/// groups that its own lights have in the scene.
pub(super) fn with_lights_of<'l>(scene: &Scene, look: Cow<'l, Look>) -> Cow<'l, Look> {
    let differs = |(id, light): (&LightId, &Light)| {
        let own = look.lights.get(id);
        own.is_none_or(|own| own.groups != light.groups || own.name != light.name)
    };
    if !scene.lights.iter().any(differs) || !look.names_light_sets() {
        return look;
    }
    let mut lit = look.into_owned();
    for (id, light) in &scene.lights {
        let own = lit.lights.entry(id.clone()).or_insert_with(|| light.clone());
        own.groups.clone_from(&light.groups);
        own.name.clone_from(&light.name);
    }
    Cow::Owned(lit)
}
