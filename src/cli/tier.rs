//! `--tier`: which implementation every node runs.

use std::sync::Arc;

use crate::document::{Look, Tier};
use crate::library::Library;

/// Reads the word.
pub(super) fn parse(text: &str) -> Result<Tier, String> {
    match text {
        "exact" => Ok(Tier::Exact),
        "balanced" => Ok(Tier::Balanced),
        "fast" => Ok(Tier::Fast),
        _ => Err("it is exact, balanced or fast".to_owned()),
    }
}

/// Asks every node for a tier, also those that say their own, and those inside groups, the
/// library's as well.
pub(super) fn run_everywhere(look: &mut Look, library: &mut Library, tier: Tier) {
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
