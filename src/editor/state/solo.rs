//! Solo and mute: layers and lights that are shown alone or left out for now. Solo belongs to the
//! window and not to the document: it is neither saved nor exported nor undone, and a bar over the
//! picture says so for as long as it lasts.

use std::borrow::Cow;
use std::sync::Arc;

use chiaro_locale::{Text, text};
use indexmap::IndexSet;

use super::stack::tree::LayerTree;
use crate::catalog::Catalog;
use crate::document::{Look, Scene, Target};
use crate::ids::{LightId, NodeId};
use crate::state::scene::SceneSnapshot;

/// Explanation for people who use solo or mute.
pub(crate) const OF_THE_WINDOW: Text = text!(
    "Only this window shows it so, in the picture and in the code: what is saved and exported has \
     every layer and light"
);

/// Soloed layers and lights, and muted lights.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Solo {
    /// Layers shown alone, over the ground; none for all.
    pub(crate) layers: IndexSet<NodeId>,
    /// Lights that shine alone; none for all.
    pub(crate) lights: IndexSet<LightId>,
    /// Lights that do not shine.
    pub(crate) muted: IndexSet<LightId>,
}

impl Solo {
    /// True if everything is shown.
    pub(crate) fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// True if a light is out: muted, or another one is shown alone.
    pub(crate) fn is_dark(&self, light: &LightId) -> bool {
        self.muted.contains(light) || !self.lights.is_empty() && !self.lights.contains(light)
    }

    /// The look as shown, with dark lights out and only the soloed layers.
    pub(crate) fn of<'l>(&self, look: &'l Look, catalog: &Catalog) -> Cow<'l, Look> {
        let mut shown = self.alone(look, catalog);
        self.put_out(&mut shown);
        shown
    }

    /// The look with all its layers, without the lights that are dark.
    pub(crate) fn lit(&self, look: &Arc<Look>) -> Arc<Look> {
        let mut lit = Cow::Borrowed(&**look);
        self.put_out(&mut lit);
        match lit {
            Cow::Borrowed(_) => look.clone(),
            Cow::Owned(lit) => Arc::new(lit),
        }
    }

    /// The look with only the soloed layers shown; all its layers where none of them is soloed.
    pub(crate) fn alone<'l>(&self, look: &'l Look, catalog: &Catalog) -> Cow<'l, Look> {
        let mut shown = Cow::Borrowed(look);
        if !self.layers.is_empty() {
            let tree = LayerTree::of(look, catalog);
            if self.layers.iter().any(|id| tree.contains(id)) {
                let nodes = &mut shown.to_mut().graph.nodes;
                for (id, muted) in tree.muted_alone(&|id| self.layers.contains(id)) {
                    if let Some(node) = nodes.get_mut(&id) {
                        node.muted = muted;
                    }
                }
            }
        }
        shown
    }

    /// Puts out the dark lights.
    fn put_out(&self, look: &mut Cow<'_, Look>) {
        let dark: Vec<LightId> =
            look.lights.keys().filter(|id| self.is_dark(id)).cloned().collect();
        if dark.is_empty() {
            return;
        }
        let look = look.to_mut();
        // Keys of the intensity would light it again.
        let is_dark = |target: &Target| {
            let Target::Light { light, field } = target else { return false };
            field == "intensity" && dark.contains(light)
        };
        look.time_keys.retain(|keys| !is_dark(&keys.target));
        let keys = look.direction_keys.iter_mut().flat_map(|keys| &mut keys.keys);
        keys.for_each(|key| key.values.retain(|target, _| !is_dark(target)));
        for id in &dark {
            look.lights[id].intensity = 0.0;
        }
    }

    /// True if changing to `other` needs another shader than the present one, and not only other
    /// values.
    pub(crate) fn is_structural(&self, other: &Self, look: &Look) -> bool {
        let timed = look.time_keys.iter().map(|keys| &keys.target);
        let keyed = look
            .direction_keys
            .iter()
            .flat_map(|keys| keys.keys.iter().flat_map(|key| key.values.keys()));
        self.layers != other.layers
            || timed.chain(keyed).any(|target| matches!(target, Target::Light { .. }))
    }

    /// The scene around the look, with its dark lights put out. Where one of the scene's lights is
    /// shown alone, the own lights of its other looks are out too, except where keys of those looks
    /// light them again.
    pub(crate) fn lit_scene(&self, snapshot: &Arc<SceneSnapshot>) -> Arc<SceneSnapshot> {
        let of_scene = &snapshot.scene.lights;
        let is_any_alone = self.lights.iter().any(|id| of_scene.contains_key(id));
        if !is_any_alone && !of_scene.keys().any(|id| self.is_dark(id)) {
            return snapshot.clone();
        }
        let mut lit = SceneSnapshot::clone(snapshot);
        if is_any_alone {
            for (id, light) in snapshot.other_looks().flat_map(|look| &look.look.lights) {
                if self.is_dark(id) {
                    lit.scene.lights.entry(id.clone()).or_insert_with(|| light.clone());
                }
            }
        }
        let dark = lit.scene.lights.iter_mut().filter(|(id, _)| self.is_dark(id));
        dark.for_each(|(_, light)| light.intensity = 0.0);
        Arc::new(lit)
    }

    /// Forgets layers and lights that no longer exist, in the look or in the scene around it.
    pub(crate) fn keep(&mut self, look: &Look, scene: Option<&Scene>) {
        let is_light = |id: &LightId| {
            look.lights.contains_key(id) || scene.is_some_and(|scene| scene.lights.contains_key(id))
        };
        self.layers.retain(|id| look.graph.nodes.contains_key(id));
        self.lights.retain(is_light);
        self.muted.retain(is_light);
    }

    /// Keeps only what holds for another look in the same scene: solo and mute of the scene's
    /// lights.
    pub(crate) fn keep_for_scene(&mut self, scene: Option<&Scene>) {
        self.layers.clear();
        self.keep(&Look::default(), scene);
    }

    /// The solo with a layer shown alone, or no longer; with `adds`, beside those that are.
    pub(crate) fn toggle_layer(&self, id: &NodeId, adds: bool) -> Self {
        Self { layers: toggled(&self.layers, id, adds), ..self.clone() }
    }

    /// The solo with these layers shown alone, or no longer, where they are that already.
    pub(crate) fn toggle_layers(&self, ids: Vec<NodeId>) -> Self {
        let ids: IndexSet<NodeId> = ids.into_iter().collect();
        let layers = if ids == self.layers { IndexSet::new() } else { ids };
        Self { layers, ..self.clone() }
    }

    /// The solo with a light shown alone, or no longer; with `adds`, beside those that are.
    pub(crate) fn toggle_light(&self, id: &LightId, adds: bool) -> Self {
        Self { lights: toggled(&self.lights, id, adds), ..self.clone() }
    }

    /// The solo with a light muted, or no longer.
    pub(crate) fn toggle_mute(&self, id: &LightId) -> Self {
        Self { muted: toggled(&self.muted, id, true), ..self.clone() }
    }
}

fn toggled<T: Clone + Eq + std::hash::Hash>(
    set: &IndexSet<T>,
    item: &T,
    adds: bool,
) -> IndexSet<T> {
    let mut new = if adds { set.clone() } else { IndexSet::new() };
    if !set.contains(item) {
        new.insert(item.clone());
    } else if adds {
        new.shift_remove(item);
    }
    new
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::Library;

    const LOOK: &str = r#"{"lights": {"key": {"intensity": 2}, "back": {}},
      "nodes": [{"id": "base", "kind": "base"}, {"id": "a", "kind": "light_layer"},
        {"id": "b", "kind": "light_layer", "muted": true}, {"id": "output", "kind": "output"}],
      "wires": [{"from": "base", "to": "a.below"}, {"from": "a", "to": "b.below"},
      {"from": "b", "to": "output.color"}],
      "time_keys": [{"target": "lights.key.intensity", "keys": [{"time": 0, "value": 1}]},
        {"target": "lights.key.color", "keys": [{"time": 0, "value": [1, 0, 0]}]}]}"#;

    fn setup() -> (Look, Catalog) {
        let loaded = Look::read(LOOK, "test");
        assert!(!loaded.has_errors(), "{:?}", loaded.diagnostics);
        (loaded.value.unwrap_or_default(), Catalog::new(Library::built_in()))
    }

    #[test]
    fn a_soloed_layer_is_shown_even_where_the_look_mutes_it() {
        let (look, catalog) = setup();
        let solo = Solo::default().toggle_layer(&"b".into(), false);
        let shown = solo.of(&look, &catalog);
        assert!(shown.graph.nodes["a"].muted && !shown.graph.nodes["b"].muted);
        assert!(
            matches!(Solo::default().of(&look, &catalog), Cow::Borrowed(_)),
            "nothing is copied for nothing"
        );
        // A soloed node that is no longer a layer of the stack leaves all layers as they are.
        let solo = Solo::default().toggle_layer(&"base".into(), false);
        assert_eq!(*solo.of(&look, &catalog), look);
    }

    #[test]
    fn a_muted_light_is_dark_whatever_its_keys_say() {
        let (look, catalog) = setup();
        let solo = Solo::default().toggle_mute(&"key".into());
        let shown = solo.of(&look, &catalog);
        assert_eq!((shown.lights["key"].intensity, shown.lights["back"].intensity), (0.0, 1.0));
        assert_eq!(shown.time_keys.len(), 1, "only its intensity is no longer keyed");
        assert!(
            solo.is_structural(&Solo::default(), &look),
            "a keyed light needs another shader's rig"
        );
    }

    #[test]
    fn solo_and_mute_go_together() {
        let [key, back] = ["key", "back"].map(LightId::from);
        let solo = Solo::default().toggle_light(&key, false);
        assert!(!solo.is_dark(&key) && solo.is_dark(&back));
        assert!(!solo.toggle_light(&back, true).is_dark(&back), "both");
        assert!(solo.toggle_light(&back, false).is_dark(&key), "the other one alone");
        assert!(solo.toggle_mute(&key).is_dark(&key), "muted is dark, also when alone");
        assert!(solo.toggle_light(&key, false).is_empty());
    }
}
