//! Layers that nodes work for: a node that feeds one layer counts for that layer, with all that
//! feeds the node. What feeds several layers is shared.

use std::collections::{BTreeMap, HashMap};

use super::tree::LayerTree;
use crate::document::Look;
use crate::ids::NodeId;

/// Layer that a node works for.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) enum LayerOwner {
    /// One layer, the ground, the Output, or the node itself where it feeds none of these.
    One(NodeId),
    Several,
}

/// Share of a layer in the counted operations.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LayerShare {
    pub(crate) owner: LayerOwner,
    /// Nodes that the share is of, the most expensive first.
    pub(crate) nodes: Vec<NodeId>,
    /// Part of all operations, 0 to 1.
    pub(crate) share: f64,
}

/// Layers that the nodes of a look work for.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct LayerOwners {
    of: HashMap<NodeId, LayerOwner>,
}

impl LayerOwners {
    /// The owners of a look's nodes; `tree` are the look's layers.
    pub(crate) fn of(look: &Look, tree: &LayerTree) -> Self {
        let mut into: HashMap<&NodeId, Vec<&NodeId>> = HashMap::new();
        for wire in &look.graph.wires {
            into.entry(&wire.to.node).or_default().push(&wire.from.node);
        }
        let one = |id: &NodeId| (id.clone(), LayerOwner::One(id.clone()));
        let members: HashMap<NodeId, LayerOwner> = tree.members().map(one).collect();
        let mut owners = members.clone();
        let mut open: Vec<NodeId> = members.keys().cloned().collect();
        // A node is taken up again only where its owner becomes several, so that rings end.
        while let Some(node) = open.pop() {
            let Some(owner) = owners.get(&node).cloned() else { continue };
            for &source in into.get(&node).into_iter().flatten() {
                let known = owners.get(source);
                let is_told = known == Some(&owner) || known == Some(&LayerOwner::Several);
                if members.contains_key(source) || is_told {
                    continue;
                }
                let new = if known.is_none() { owner.clone() } else { LayerOwner::Several };
                owners.insert(source.clone(), new);
                open.push(source.clone());
            }
        }
        Self { of: owners }
    }

    /// Shares of all owners in the operations that are counted for nodes, the largest first.
    pub(crate) fn shares(&self, operations: &BTreeMap<NodeId, u64>) -> Vec<LayerShare> {
        let all = operations.values().sum::<u64>().max(1) as f64;
        let mut nodes: Vec<(&NodeId, u64)> =
            operations.iter().map(|(id, &count)| (id, count)).collect();
        nodes.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
        let mut places: HashMap<LayerOwner, usize> = HashMap::new();
        let mut shares: Vec<LayerShare> = Vec::new();
        for (id, count) in nodes {
            let itself = || LayerOwner::One(id.clone());
            let owner = self.of.get(id).cloned().unwrap_or_else(itself);
            let place = *places.entry(owner.clone()).or_insert_with(|| {
                shares.push(LayerShare { owner, nodes: Vec::new(), share: 0.0 });
                shares.len() - 1
            });
            shares[place].nodes.push(id.clone());
            shares[place].share += count as f64 / all;
        }
        shares.sort_by(|a, b| b.share.total_cmp(&a.share));
        shares
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::Catalog;
    use crate::library::Library;

    #[test]
    fn nodes_count_for_the_layer_that_they_feed() {
        let look = Look::read(
            r#"{"nodes": [{"id": "ground", "kind": "base"}, {"id": "output", "kind": "output"},
              {"id": "low", "kind": "blend"}, {"id": "high", "kind": "blend"},
              {"id": "disc", "kind": "invert"}, {"id": "bite", "kind": "invert"},
              {"id": "both", "kind": "invert"}, {"id": "deep", "kind": "invert"},
              {"id": "loose", "kind": "invert"}],
            "wires": [{"from": "ground", "to": "low.below"}, {"from": "low", "to": "high.below"},
              {"from": "high", "to": "output.color"}, {"from": "disc", "to": "low.tone"},
              {"from": "bite", "to": "disc.value"}, {"from": "both", "to": "low.opacity"},
              {"from": "both", "to": "high.tone"}, {"from": "deep", "to": "both.value"}]}"#,
            "test",
        );
        let look = look.value.unwrap();
        let mut catalog = Catalog::new(Library::built_in());
        catalog.sync(&look, Library::built_in());
        let owners = LayerOwners::of(&look, &LayerTree::of(&look, &catalog));
        let operations = [
            ("low", 10),
            ("disc", 20),
            ("bite", 30),
            ("high", 5),
            ("both", 15),
            ("deep", 15),
            ("loose", 5),
        ];
        let operations = operations.map(|(id, count)| (id.into(), count)).into();
        let shares = owners.shares(&operations);
        let told: Vec<_> = shares
            .iter()
            .map(|share| (share.owner.clone(), share.nodes.len(), share.share))
            .collect();
        let one = |id: &str| LayerOwner::One(id.into());
        assert_eq!(told[..2], [(one("low"), 3, 0.6), (LayerOwner::Several, 2, 0.3)]);
        assert_eq!(shares[0].nodes[0].as_str(), "bite", "the most expensive is told first");
        assert!(
            told[2..].iter().all(|(owner, ..)| *owner == one("high") || *owner == one("loose"))
        );
    }
}
