//! Table of the lights that reach nodes of a look and that nodes filter, each with its rule: for
//! plans, tables and people. What is compiled goes by the same sets.

use std::collections::{BTreeSet, HashSet};

use indexmap::IndexMap;

use crate::document::{Graph, LightRelation, LinkRule, Look, Node, Value};
use crate::ids::{DefinitionId, LightId, NodePath};
use crate::library::{GroupPorts, Library, Type};

/// Number of rows that are told of one look, at most.
const MAX_ROWS: usize = 10_000;

/// A light and a node that is about it, and whether the one reaches the other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NodeReach {
    /// The node, through the groups that it lies in.
    pub node: NodePath,
    /// The light.
    pub light: LightId,
    /// Relation that is told: layered or filtered.
    pub relation: LightRelation,
    /// True if the light reaches the node, or is filtered by it.
    pub reaches: bool,
    /// The rule that decides, in words, with its expression.
    pub words: String,
}

/// Graph whose nodes are told of.
struct ReachedGraph<'a> {
    graph: &'a Graph,
    path: Option<NodePath>,
    /// Lights that reach it.
    around: BTreeSet<LightId>,
    /// Rules that keep other lights away.
    kept_away: IndexMap<LightId, String>,
}

/// Every light of a look with the nodes of its own graph that name it or run for it, and with nodes
/// in groups that have rules of their own.
pub fn node_reach(look: &Look, library: &Library) -> Vec<NodeReach> {
    let ruled = ruled_definitions(look);
    let root = ReachedGraph {
        graph: &look.graph,
        path: None,
        around: look.lights.keys().cloned().collect(),
        kept_away: IndexMap::new(),
    };
    let (mut open, mut found, mut next) = (vec![root], Vec::new(), 0);
    while next < open.len() && found.len() < MAX_ROWS && open.len() < MAX_ROWS {
        let mut inner = Vec::new();
        for (id, node) in &open[next].graph.nodes {
            let here = &open[next];
            let path = match &here.path {
                Some(path) => path.join(id.clone()),
                None => NodePath::root(id.clone()),
            };
            let (around, kept_away) = tell(look, library, here, (&path, node), &mut found);
            if let Some(definition) = look.definitions.get(node.kind.as_str())
                && ruled.contains(node.kind.as_str())
            {
                let graph = &definition.graph;
                inner.push(ReachedGraph { graph, path: Some(path), around, kept_away });
            }
        }
        open.extend(inner);
        next += 1;
    }
    found
}

/// Tells of one node. Lights that reach it, and rules that keep others away, are those of what is
/// in it.
fn tell(
    look: &Look,
    library: &Library,
    here: &ReachedGraph<'_>,
    (path, node): (&NodePath, &Node),
    found: &mut Vec<NodeReach>,
) -> (BTreeSet<LightId>, IndexMap<LightId, String>) {
    let (layered, filtered) = (node.links.layered_link(), node.links.filtered_link());
    let mut kept_away = here.kept_away.clone();
    for (id, rule) in layered.rules_within(&look.lights, &here.around) {
        if rule != LinkRule::Linked {
            let words = || layered.words(LightRelation::Layered, rule);
            kept_away.entry(id).or_insert_with(words);
        }
    }
    let about = lights_about(look, library, node);
    let is_told = here.path.is_none() || !layered.is_all();
    for light in about.iter().filter(|_| is_told) {
        let away = kept_away.get(light);
        let reaching = || layered.words(LightRelation::Layered, LinkRule::Linked);
        found.push(NodeReach {
            node: path.clone(),
            light: light.clone(),
            relation: LightRelation::Layered,
            reaches: away.is_none(),
            words: away.cloned().unwrap_or_else(reaching),
        });
    }
    let around: BTreeSet<LightId> =
        here.around.iter().filter(|id| !kept_away.contains_key(*id)).cloned().collect();
    if !filtered.is_all() {
        let all = look.lights.keys().cloned().collect();
        for (light, rule) in filtered.rules_within(&look.lights, &all) {
            let is_about = about.is_empty() || about.contains(&light);
            if is_about && around.contains(&light) {
                found.push(NodeReach {
                    node: path.clone(),
                    light,
                    relation: LightRelation::Filtered,
                    reaches: rule == LinkRule::Linked,
                    words: filtered.words(LightRelation::Filtered, rule),
                });
            }
        }
    }
    (around, kept_away)
}

/// Lights that a node names, or that it runs for.
fn lights_about(look: &Look, library: &Library, node: &Node) -> BTreeSet<LightId> {
    if let Some(set) = &node.for_each {
        return set.of(&look.lights, &BTreeSet::new());
    }
    let kind = node.kind.as_str();
    let inputs = match (library.group_of(look, kind), library.nodes.get(kind)) {
        (Some(definition), _) => GroupPorts::of(definition, &look.definitions, library).inputs,
        (None, Some(def)) => def.inputs.clone(),
        (None, None) => return BTreeSet::new(),
    };
    let names = inputs.iter().filter(|input| input.ty == Type::LightName);
    // Who names none has the look's first.
    let named = names.filter_map(|input| match node.values.get(&input.name) {
        Some(Value::Text(id)) if !id.is_empty() => look.lights.get_key_value(id.as_str()),
        _ => look.lights.first(),
    });
    named.map(|(id, _)| id.clone()).collect()
}

/// Definitions with a node that has rules of its own, in them or in what they use.
fn ruled_definitions(look: &Look) -> HashSet<&str> {
    let mut ruled: HashSet<&str> = HashSet::new();
    let has_rules = |definition: &DefinitionId, ruled: &HashSet<&str>| {
        let nodes = look.definitions.get(definition).map(|definition| &definition.graph.nodes);
        nodes
            .into_iter()
            .flat_map(IndexMap::values)
            .any(|node| !node.links.is_all() || ruled.contains(node.kind.as_str()))
    };
    // Each round finds those that use what the last one found.
    for _ in 0..look.definitions.len() {
        let before = ruled.len();
        for id in look.definitions.keys() {
            if has_rules(id, &ruled) {
                ruled.insert(id.as_str());
            }
        }
        if ruled.len() == before {
            break;
        }
    }
    ruled
}
