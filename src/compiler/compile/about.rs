//! Lights that the values of nodes are about: those that nodes name, and those that come to them by
//! wires of lights and of angles to lights.

use super::check::{TypedGraph, TypedNode, TypedSource};
use crate::ids::LightId;
use crate::library::Type;

/// Number of lights that a value is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum LightsAbout<'a> {
    None,
    One(&'a LightId),
    Several,
}

impl LightsAbout<'_> {
    fn joined(self, other: Self) -> Self {
        match (self, other) {
            (one, Self::None) | (Self::None, one) => one,
            (one, other) if one == other => one,
            _ => Self::Several,
        }
    }
}

/// The light that each node's value is about, where that is one alone. Copies of a node in a region
/// that runs for each light are about a light each; what joins lights is about several.
pub(super) fn single_lights(graph: &TypedGraph) -> Vec<Option<LightId>> {
    let mut about = vec![LightsAbout::None; graph.nodes.len()];
    for &index in &graph.order {
        let node = &graph.nodes[index];
        about[index] = if node.def.joins_lights() {
            LightsAbout::Several
        } else {
            let named = node.light.as_ref().map_or(LightsAbout::None, LightsAbout::One);
            sources(node).fold(named, |all, source| all.joined(about[source]))
        };
    }
    let single = |about: &LightsAbout<'_>| match about {
        LightsAbout::One(light) => Some((*light).clone()),
        LightsAbout::None | LightsAbout::Several => None,
    };
    about.iter().map(single).collect()
}

/// The nodes whose lights, or angles to lights, a node takes.
fn sources(node: &TypedNode) -> impl Iterator<Item = usize> + '_ {
    node.inputs.iter().flatten().filter_map(|input| match input.source {
        TypedSource::Wire { node, .. } if matches!(input.ty, Type::Light | Type::Angle) => {
            Some(node)
        }
        _ => None,
    })
}
