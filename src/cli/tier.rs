//! `--tier`: the tier that every node runs in.

use std::sync::Arc;

use crate::document::{Look, Tier};
use crate::library::Library;

/// Parses the word for a tier.
pub(super) fn parse(text: &str) -> Result<Tier, String> {
    match text {
        "exact" => Ok(Tier::Exact),
        "balanced" => Ok(Tier::Balanced),
        "fast" => Ok(Tier::Fast),
        _ => Err("it is exact, balanced or fast".to_owned()),
    }
}

/// Sets the tier of every node, also of nodes that have a tier of their own, and of those inside
/// groups, the library's included.
pub(super) fn set_every_tier(look: &mut Look, library: &mut Library, tier: Tier) {
    look.set_every_tier(tier);
    for group in library.groups.values_mut() {
        if group.definition.graph.nodes.values().any(|node| node.tier.is_some()) {
            Arc::make_mut(group)
                .definition
                .graph
                .nodes
                .values_mut()
                .for_each(|node| node.tier = None);
        }
    }
}
