//! Keys under which a look's modules are kept: a hash of everything that the modules depend on.

use std::collections::BTreeSet;
use std::hash::{DefaultHasher, Hash, Hasher};

use crate::compile::{AovSource, Live};
use crate::document::{Graph, LightInput, Look, Value};
use crate::ids::LightId;

/// Surface that a look's module is compiled for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(super) struct SurfaceVariant {
    /// True if a part of the object is cut out by alpha.
    pub(super) cutout: bool,
    /// True if the mesh is deformed.
    pub(super) deformed: bool,
}

/// The hash of everything that a look's module depends on.
pub(super) fn look_key(
    look: &Look,
    live: &Live,
    surface: SurfaceVariant,
    dark: &BTreeSet<(LightId, LightInput)>,
) -> u64 {
    variant_key(content_key(look, live), surface, dark)
}

/// The hash of a look's content, as far as modules depend on it: the whole look, or, while
/// everything is live, the parts that are not uniforms.
pub(super) fn content_key(look: &Look, live: &Live) -> u64 {
    let mut hasher = DefaultHasher::new();
    if *live == Live::All {
        (look.color_space, look.tier, look.max_error.to_bits()).hash(&mut hasher);
        hash_graph(&look.graph, &mut hasher);
        for (id, definition) in &look.definitions {
            (id, format!("{:?}{:?}", definition.inputs, definition.outputs)).hash(&mut hasher);
            hash_graph(&definition.graph, &mut hasher);
        }
        for (id, light) in &look.lights {
            (id, light.kind, &light.name, &light.groups).hash(&mut hasher);
        }
        look.exposed.iter().for_each(|exposed| (&exposed.name, &exposed.target).hash(&mut hasher));
        for keys in &look.direction_keys {
            format!("{keys:?}").hash(&mut hasher);
        }
        look.time_keys.iter().for_each(|track| format!("{track:?}").hash(&mut hasher));
    } else {
        look.to_text().hash(&mut hasher);
        format!("{live:?}").hash(&mut hasher);
    }
    hasher.finish()
}

/// The hash of a look's content together with what its wearers add to it.
pub(super) fn variant_key(
    content: u64,
    surface: SurfaceVariant,
    dark: &BTreeSet<(LightId, LightInput)>,
) -> u64 {
    let mut hasher = DefaultHasher::new();
    (content, surface, dark).hash(&mut hasher);
    hasher.finish()
}

/// The key of a variant together with what is drawn of it beside the picture, or in its place.
pub(super) fn drawing_key(variant: u64, aovs: &[AovSource], mattes: bool) -> u64 {
    if aovs.is_empty() && !mattes {
        return variant;
    }
    let mut hasher = DefaultHasher::new();
    (variant, aovs, mattes).hash(&mut hasher);
    hasher.finish()
}

fn hash_graph(graph: &Graph, hasher: &mut DefaultHasher) {
    for (id, node) in &graph.nodes {
        (id, &node.kind, &node.name, node.tier, node.muted).hash(hasher);
        (&node.for_each, &node.links).hash(hasher);
        for (port, value) in &node.values {
            // Words decide what is compiled; texts that are hex colors are values.
            if let (Value::Text(text), None) = (value, value.color()) {
                (port, text).hash(hasher);
            }
        }
    }
    graph.wires.hash(hasher);
    graph.frames.iter().for_each(|(id, frame)| (id, &frame.title, &frame.nodes).hash(hasher));
}
