//! `--tier`: the tier that every node runs in, and what a command tells of the tiers of a look.

use std::sync::Arc;

use crate::compile::{TierReason, check};
use crate::document::{Look, MAX_ERROR, Tier};
use crate::library::Library;
use chiaro_scene::export::description::TierCounts;

/// Choice of `--tier`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum TierChoice {
    /// Cheapest tier of each node whose difference nobody can see.
    Automatic,
    /// One tier for every node.
    Every(Tier),
}

/// Word for a tier.
pub(super) fn word(tier: Tier) -> &'static str {
    match tier {
        Tier::Exact => "exact",
        Tier::Balanced => "balanced",
        Tier::Fast => "fast",
    }
}

/// Parses the word for a tier.
pub(super) fn parse(text: &str) -> Result<TierChoice, String> {
    match text {
        "automatic" | "auto" => Ok(TierChoice::Automatic),
        "exact" => Ok(TierChoice::Every(Tier::Exact)),
        "balanced" => Ok(TierChoice::Every(Tier::Balanced)),
        "fast" => Ok(TierChoice::Every(Tier::Fast)),
        _ => Err("it is automatic (or auto), exact, balanced or fast".to_owned()),
    }
}

/// Numbers of a look's nodes in each tier, as descriptions of exports have them; `None` for a look
/// that cannot be compiled.
pub(super) fn counts(look: &Look, library: &Library) -> Option<TierCounts> {
    let typed = check(look, library, None).ok()?.value;
    Some(TierCounts::of(look, &typed))
}

/// Sentence on the tiers that a look's nodes were given because none is named for them; `None`
/// where every tier is named.
pub(super) fn told(look: &Look, library: &Library) -> Option<String> {
    told_of_all(std::iter::once(look), library)
}

/// Sentence on the tiers that the nodes of looks were given because none is named for them, all
/// looks together; `None` where every tier is named.
pub(super) fn told_of_all<'l>(
    looks: impl Iterator<Item = &'l Look>,
    library: &Library,
) -> Option<String> {
    let mut chosen: Vec<(&Look, Vec<Tier>)> = Vec::new();
    for look in looks {
        let Ok(typed) = check(look, library, None) else { continue };
        let mut nodes = typed.value.nodes;
        nodes.retain(|node| node.def.has_cheaper());
        if nodes.iter().any(|node| node.tier_reason != TierReason::Named) {
            chosen.push((look, nodes.iter().map(|node| node.tier).collect()));
        }
    }
    let name = match chosen.as_slice() {
        [] => return None,
        [(look, _)] if look.name.is_empty() => "the look".to_owned(),
        [(look, _)] => look.name.clone(),
        several => format!("{} looks", several.len()),
    };
    let tiers = || chosen.iter().flat_map(|(_, tiers)| tiers);
    let count = |tier: Tier| tiers().filter(|it| **it == tier).count();
    let counts = [Tier::Balanced, Tier::Exact, Tier::Fast]
        .into_iter()
        .filter(|tier| count(*tier) > 0)
        .map(|tier| format!("{} {}", count(tier), word(tier)));
    let counts: Vec<String> = counts.collect();
    // The greatest bound is true of all.
    let most = chosen.iter().map(|(look, _)| look.max_error).fold(0.0, f64::max);
    let bound = bound_text(most);
    Some(format!("{name}: {bound}; nodes: {}; --tier names one", counts.join(", ")))
}

/// Sentence on how the tiers were chosen of nodes for which none is named.
pub(super) fn bound_text(max_error: f64) -> String {
    if max_error <= 0.0 {
        return "automatic tiers that differ by nothing (max_error is 0): exact".to_owned();
    }
    let unseen = if max_error <= MAX_ERROR { ", which nobody can see" } else { "" };
    let size = if (max_error - MAX_ERROR).abs() < 1e-9 {
        "1/255, a step of a screen".to_owned()
    } else {
        format!("{max_error}")
    };
    format!("automatic tiers, estimated to differ from exact by at most {size}{unseen}")
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
