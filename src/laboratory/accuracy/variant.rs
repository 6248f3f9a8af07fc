//! Variants: the same setup with one thing changed.

use crate::compile::{Live, can_be_muted};
use crate::diag::Diagnostic;
use crate::document::{Look, Node, Tier};
use crate::frame::{FramePlan, PlanOptions, Planner, Setup};
use crate::ids::NodeId;
use crate::library::{GroupPorts, Library, NodeDef, Treatment};

/// The change that a variant makes to a setup.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub enum Variant {
    /// No change: the setup as it was read.
    #[default]
    Asked,
    /// Every node of every look in this tier.
    Looks(Tier),
    /// No tier named in any look: every node in the cheapest whose difference nobody can see.
    Automatic,
    /// One node of one look in this tier, all else exact.
    Node {
        /// Index of the look in the setup.
        look: usize,
        /// The node.
        node: NodeId,
        /// Tier of the node.
        tier: Tier,
    },
    /// One node of one look left out, all else exact.
    Without {
        /// Index of the look in the setup.
        look: usize,
        /// The node.
        node: NodeId,
    },
}

impl Variant {
    /// `setup` with the change of this variant.
    pub fn of(&self, setup: &Setup) -> Setup {
        let mut setup = setup.clone();
        if *self != Self::Asked {
            let tier = if let Self::Looks(tier) = self { *tier } else { Tier::Exact };
            setup.looks.iter_mut().for_each(|look| look.look.set_every_tier(tier));
        }
        match self {
            Self::Asked | Self::Looks(_) => {}
            Self::Automatic => setup.looks.iter_mut().for_each(|look| look.look.tier = None),
            Self::Node { look, node, tier } => {
                edit(&mut setup, *look, node, |node| node.tier = Some(*tier));
            }
            Self::Without { look, node } => edit(&mut setup, *look, node, |node| node.muted = true),
        }
        setup
    }

    /// Sets the tier of a node in the look's own graph; a tier equal to the look's is removed from
    /// the node, to keep the file short.
    pub fn set_tier(look: &mut Look, node: &NodeId, tier: Tier) {
        let of_look = look.tier;
        if let Some(node) = look.graph.nodes.get_mut(node) {
            node.tier = (of_look != Some(tier)).then_some(tier);
        }
    }

    /// `setup` with one node of one look in this tier, all else as it is.
    #[must_use]
    pub fn of_also(mut setup: Setup, look: usize, node: &NodeId, tier: Tier) -> Setup {
        edit(&mut setup, look, node, |node| node.tier = Some(tier));
        setup
    }
}

/// Changes a node of a look's own graph, if the graph has a node of that id.
fn edit(setup: &mut Setup, look: usize, node: &NodeId, change: impl FnOnce(&mut Node)) {
    if let Some(node) =
        setup.looks.get_mut(look).and_then(|look| look.look.graph.nodes.get_mut(node))
    {
        change(node);
    }
}

/// The tiers that differ for a node, groups included: `exact`, and every cheaper one that the node
/// or a node within its group has a function for, or rules of the functions that it calls.
pub fn tiers_of(look: &Look, library: &Library, kind: &str) -> Vec<Tier> {
    let mut tiers = vec![Tier::Exact];
    let mut open = vec![kind];
    let mut seen = std::collections::HashSet::new();
    while let Some(kind) = open.pop() {
        if !seen.insert(kind) {
            continue;
        }
        let definition = look
            .definitions
            .get(kind)
            .or_else(|| library.groups.get(kind).map(|group| &group.definition));
        match definition {
            Some(definition) => {
                open.extend(definition.graph.nodes.values().map(|node| node.kind.as_str()));
            }
            None => {
                tiers.extend(library.nodes.get(kind).into_iter().flat_map(|def| own_tiers(def)));
            }
        }
    }
    tiers.sort_unstable();
    tiers.dedup();
    tiers
}

fn own_tiers(def: &NodeDef) -> impl Iterator<Item = Tier> {
    let by_rules = (def.form_error() > 0.0).then_some(Tier::Balanced);
    def.tiers().into_iter().chain(by_rules)
}

/// The tiers among `tiers` of a node in which a setup runs other modules than in the node's exact
/// tier; in the others it is the same picture in the same time.
///
/// # Errors
/// Problems of the setup.
pub fn distinct_tiers(
    planner: &mut Planner,
    (setup, library): (&Setup, &Library),
    options: &PlanOptions,
    (look, node): (usize, &NodeId),
    tiers: &[Tier],
) -> Result<Vec<Tier>, Vec<Diagnostic>> {
    let mut modules = |tier: Tier| {
        let setup = Variant::Node { look, node: node.clone(), tier }.of(setup);
        let plan = planner.plan(&setup, library, &Live::Keyed, options)?.value;
        Ok::<_, Vec<Diagnostic>>(modules_of(&plan))
    };
    let exact = modules(Tier::Exact)?;
    let mut distinct = Vec::new();
    for &tier in tiers {
        if tier == Tier::Exact || modules(tier)? != exact {
            distinct.push(tier);
        }
    }
    Ok(distinct)
}

/// Passes and modules of a plan.
fn modules_of(plan: &FramePlan) -> Vec<String> {
    let passes = plan.passes.iter().map(|pass| pass.id.label().to_owned());
    let shaders =
        plan.draws.iter().flat_map(|draw| std::iter::once(&draw.look).chain(draw.before.values()));
    passes.chain(shaders.map(|shader| shader.wgsl.clone())).collect()
}

/// True if a look still makes sense without a node: each of its outputs can pass an input through
/// or be zero.
pub fn can_be_left_out(look: &Look, library: &Library, kind: &str) -> bool {
    let definition = look
        .definitions
        .get(kind)
        .or_else(|| library.groups.get(kind).map(|group| &group.definition));
    let (inputs, outputs) = match (definition, library.nodes.get(kind)) {
        (Some(definition), _) => {
            let ports = GroupPorts::of(definition, &look.definitions, library);
            (ports.inputs, ports.outputs)
        }
        (None, Some(def)) if matches!(def.special, Treatment::None | Treatment::OfLight) => {
            (def.inputs.clone(), def.outputs.clone())
        }
        _ => return false,
    };
    can_be_muted(&inputs, &outputs)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Nodes that a look leaves to the automatic choice are measured, too: else a tuned look would
    /// have tiers that nobody measured.
    #[test]
    fn every_node_that_can_be_cheaper_has_tiers_to_measure() {
        let library = Library::built_in();
        let cheaper = library.nodes.iter().filter(|(_, def)| def.has_cheaper());
        let kinds: Vec<&str> = cheaper.map(|(kind, _)| kind.as_str()).collect();
        assert!(kinds.contains(&"sine") && kinds.contains(&"profile"), "{kinds:?}");
        for kind in kinds {
            assert!(tiers_of(&Look::default(), library, kind).len() > 1, "{kind}");
        }
    }
}
