//! Tiers that an export carries.
//!
//! The exact tier of a node that casts shadows sends rays past the meshes of a scene. An export has
//! no scene, but cheaper tiers of such nodes read maps, which it carries.

use super::options::node_mut;
use crate::compile::{TypedNode, check};
use crate::diag::Diagnostic;
use crate::document::{Look, Tier};
use crate::library::{Library, Type};

/// Most rounds of choosing: another tier of one node may leave others a different one.
const ROUNDS: usize = 4;

/// True if a node sends rays in a tier.
pub(super) fn sends_rays(node: &TypedNode, tier: Tier) -> bool {
    node.def.takes(&Type::Casters, tier)
}

/// The dearest tier of a node that an export carries, and the tier's name; `None` where it carries
/// none.
pub(super) fn carried(node: &TypedNode) -> Option<(&'static str, Tier)> {
    let tiers = [("exact", Tier::Exact), ("balanced", Tier::Balanced), ("fast", Tier::Fast)];
    tiers.into_iter().find(|(_, tier)| !sends_rays(node, *tier))
}

/// Gives every node of a tier that no export carries the nearest one that it does, and tells each:
/// a warning that names the node. A look that has errors stays as it is, and so do nodes without
/// such a tier; exporting reports both.
pub(super) fn take_carried_tiers(look: &mut Look, library: &mut Library) -> Vec<Diagnostic> {
    let mut told = Vec::new();
    for _ in 0..ROUNDS {
        let Ok(checked) = check(look, library, None) else { break };
        let nodes = checked.value.nodes;
        let refused = nodes.iter().filter(|node| sends_rays(node, node.tier));
        let chosen: Vec<_> = refused.filter_map(|node| Some((node, carried(node)?))).collect();
        if chosen.is_empty() {
            break;
        }
        for (node, (word, tier)) in chosen {
            let Some(found) = node_mut(look, library, &node.path) else { return told };
            found.tier = Some(tier);
            let message = format!(
                "the node `{}` ({}) is exported in its {word} tier: its exact one sends rays past \
                 the meshes of a scene, which an export does not carry",
                node.path, node.def.label
            );
            told.push(Diagnostic::warning("cheaper-tier", message).node(node.path.clone()));
        }
    }
    told
}
