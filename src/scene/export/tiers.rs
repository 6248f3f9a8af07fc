//! Tiers that an export carries.
//!
//! The exact tier of a node that casts shadows sends rays past the meshes of a scene. An export has
//! no scene, but cheaper tiers of such nodes read maps, which it carries.

use std::collections::BTreeSet;

use chiaro_locale::{tr, tr_in};

use super::options::node_mut;
use crate::compile::{TierReason, TypedInput, TypedNode, TypedSource, check};
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
            let message = tr!(
                "the node `{node}` ({kind}) is exported in its {word} tier: its exact one sends \
                 rays past the meshes of a scene, which an export does not carry",
                node = node.path,
                kind = tr_in("node", &node.def.label)
            );
            told.push(Diagnostic::warning("cheaper-tier", message).node(node.path.clone()));
        }
    }
    told
}

/// True if a node reads what passes before the picture have drawn.
fn reads_passes(node: &TypedNode) -> bool {
    let is_drawn = |input: &TypedInput| match input.source {
        TypedSource::Context(context) => context.pass().is_some(),
        _ => false,
    };
    node.inputs.iter().flatten().any(is_drawn)
}

/// Gives every node that reads passes before the picture the dearest tier in which it reads none,
/// for the package of a label, which draws none, and tells that in one warning. Nodes whose tier
/// somebody has named keep it, and the package refuses the look for them, as it does for nodes that
/// read passes in every tier.
pub(super) fn take_tiers_without_passes(
    look: &mut Look,
    library: &mut Library,
    package: &str,
) -> Vec<Diagnostic> {
    let mut chosen = BTreeSet::new();
    let mut labels = BTreeSet::new();
    for _ in 0..ROUNDS {
        let Ok(checked) = check(look, library, None) else { break };
        let mut is_done = true;
        for node in checked.value.nodes.iter().filter(|node| reads_passes(node)) {
            let is_open = node.tier_reason != TierReason::Named || chosen.contains(&node.path);
            let cheaper = match node.tier {
                Tier::Exact => Tier::Balanced,
                Tier::Balanced => Tier::Fast,
                Tier::Fast => continue,
            };
            let Some(found) = node_mut(look, library, &node.path).filter(|_| is_open) else {
                continue;
            };
            found.tier = Some(cheaper);
            chosen.insert(node.path.clone());
            labels.insert(format!("`{}`", tr_in("node", &node.def.label)));
            is_done = false;
        }
        if is_done {
            break;
        }
    }
    if labels.is_empty() {
        return Vec::new();
    }
    let labels: Vec<String> = labels.into_iter().collect();
    let message = tr!(
        "nodes are exported in a cheaper tier, which reads no passes before the picture: {package} \
         draws none; they are {names}",
        names = labels.join(", ")
    );
    vec![Diagnostic::warning("cheaper-tier", message).hint(tr!("`--to web` draws the passes"))]
}
