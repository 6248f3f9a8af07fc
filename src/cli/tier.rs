//! `--tier`: the tier that every node runs in, and what a command tells of the tiers of a look.

use std::sync::Arc;

use crate::compile::check;
use crate::document::{Look, Tier};
use crate::library::Library;

/// Choice of `--tier`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum TierChoice {
    /// Cheapest tier of each node whose difference nobody can see.
    Automatic,
    /// One tier for every node.
    Every(Tier),
}

/// Parses the word for a tier.
pub(super) fn parse(text: &str) -> Result<TierChoice, String> {
    match text {
        "automatic" => Ok(TierChoice::Automatic),
        "exact" => Ok(TierChoice::Every(Tier::Exact)),
        "balanced" => Ok(TierChoice::Every(Tier::Balanced)),
        "fast" => Ok(TierChoice::Every(Tier::Fast)),
        _ => Err("it is automatic, exact, balanced or fast".to_owned()),
    }
}

/// Sentence on the tiers that a look's nodes were given because none is named for them; `None`
/// where every tier is named.
pub(super) fn told(look: &Look, library: &Library) -> Option<String> {
    let nodes = check(look, library, None).ok()?.value.nodes;
    let count =
        |tier: Tier| nodes.iter().filter(|node| node.is_automatic && node.tier == tier).count();
    let (balanced, exact) = (count(Tier::Balanced), count(Tier::Exact));
    if balanced + exact == 0 {
        return None;
    }
    let name = if look.name.is_empty() { "the look" } else { &look.name };
    Some(format!(
        "{name}: the cheapest tiers that nobody can see (at most {:.1e} off): {balanced} nodes \
         balanced, {exact} exact; --tier exact is the truth",
        look.max_error
    ))
}

/// Sets the tier of every node, also of nodes that have a tier of their own, and of those inside
/// groups, the library's included.
pub(super) fn set_every_tier(look: &mut Look, library: &mut Library, choice: TierChoice) {
    match choice {
        TierChoice::Every(tier) => look.set_every_tier(tier),
        TierChoice::Automatic => {
            look.set_every_tier(Tier::Exact);
            look.tier = None;
        }
    }
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
