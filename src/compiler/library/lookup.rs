//! Groups and nodes of a look by kinds and paths, through the groups of the library too.
//!
//! [`Look::find`] finds nodes that have a place in the document. What draws a look, names its parts
//! or changes them for one use alone also goes into groups that the document does not have.

use super::load::Library;
use crate::document::{Definition, Graph, GraphId, Look, Node};
use crate::ids::{DefinitionId, NodeId, NodePath, make_slug};

impl Library {
    /// Group of a kind of node: the look's own before the library's.
    pub fn group_of<'l>(&'l self, look: &'l Look, kind: &str) -> Option<&'l Definition> {
        let own = look.definitions.get(kind);
        own.or_else(|| self.groups.get(kind).map(|group| &group.definition))
    }

    /// Node at the end of a path through groups, with the graph that it lies in. The ids of the
    /// path go from the outermost group to the node.
    pub fn node_of<'l>(&'l self, look: &'l Look, path: &[NodeId]) -> Option<(&'l Graph, &'l Node)> {
        let (last, groups) = path.split_last()?;
        let inner =
            |graph: &'l Graph, id| Some(&self.group_of(look, &graph.nodes.get(id)?.kind)?.graph);
        let graph = groups.iter().try_fold(&look.graph, inner)?;
        Some((graph, graph.nodes.get(last)?))
    }

    /// Node at the end of a path, for changes of this use of the groups around it alone: groups
    /// that have other uses, and those of the library, get definitions of their own in the look.
    /// Where there is no such node, the look stays as it is.
    pub fn node_of_one_use<'l>(&self, look: &'l mut Look, path: &NodePath) -> Option<&'l mut Node> {
        self.node_of(look, path.ids())?;
        let (last, groups) = path.ids().split_last()?;
        let mut graph = GraphId::Look;
        for id in groups {
            let kind = look.graph_of(&graph)?.nodes.get(id)?.kind.clone();
            if self.is_used_once(look, &kind) {
                graph = GraphId::Definition(DefinitionId::from(kind.as_str()));
                continue;
            }
            let definition = self.group_of(look, &kind)?.clone();
            // A definition stands before a kind of the library that has its name.
            let is_taken = |slug: &str| {
                let is_own = look.definitions.contains_key(slug);
                is_own || self.groups.contains_key(slug) || self.nodes.contains_key(slug)
            };
            let alone = make_slug(&format!("{kind}_alone"), is_taken);
            look.graph_of_mut(&graph)?.nodes.get_mut(id)?.kind.clone_from(&alone);
            let alone = DefinitionId::from(alone.as_str());
            look.definitions.insert(alone.clone(), definition);
            graph = GraphId::Definition(alone);
        }
        look.graph_of_mut(&graph)?.nodes.get_mut(last)
    }

    /// True for a group of the look's own that one node stands for, in a graph that is itself used
    /// once. One that has the name of a group of the library may have uses within others of these.
    fn is_used_once(&self, look: &Look, kind: &str) -> bool {
        let own = look.definitions.values().map(|definition| &definition.graph);
        let nodes = std::iter::once(&look.graph).chain(own).flat_map(|graph| graph.nodes.values());
        look.definitions.contains_key(kind)
            && !self.groups.contains_key(kind)
            && nodes.filter(|node| node.kind == kind).take(2).count() == 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Value;

    /// A look whose group `half` has two uses and holds a group of the library.
    fn look() -> Look {
        let text = r#"{"nodes": [{"id": "one", "kind": "half"}, {"id": "two", "kind": "half"},
            {"id": "rim", "kind": "light_layer"}, {"id": "output", "kind": "output"}],
            "definitions": {"half": {"nodes": [{"id": "lit", "kind": "light_layer"}]}}}"#;
        Look::read(text, "").value.expect("a look")
    }

    /// Path to the node of a layer that has the blend mode.
    fn blend_of(layer: &str) -> NodePath {
        let group = &Library::built_in().groups["light_layer"].definition;
        let is_blend = |(_, node): &(&NodeId, &Node)| node.kind == "blend";
        let (id, _) = group.graph.nodes.iter().find(is_blend).expect("a blend");
        NodePath::parse(layer).join(id.clone())
    }

    #[test]
    fn paths_lead_into_groups_of_the_look_and_of_the_library() {
        let (look, library) = (look(), Library::built_in());
        let kind = |path: &NodePath| Some(library.node_of(&look, path.ids())?.1.kind.as_str());
        assert_eq!(kind(&NodePath::parse("one/lit")), Some("light_layer"));
        assert_eq!(kind(&blend_of("one/lit")), Some("blend"));
        assert_eq!(kind(&NodePath::parse("one/lit/nothing")), None);
        assert_eq!(kind(&NodePath::parse("output/lit")), None, "no group");
        let (graph, _) = library.node_of(&look, NodePath::parse("two/lit").ids()).unwrap();
        assert_eq!(*graph, look.definitions["half"].graph);
    }

    #[test]
    fn a_use_of_groups_within_groups_is_changed_alone() {
        let (before, library) = (look(), Library::built_in());
        let mut look = before.clone();
        for (port, word) in [("mode", "add"), ("clamp", "on")] {
            let node = library.node_of_one_use(&mut look, &blend_of("one/lit")).unwrap();
            node.values.insert(port.into(), Value::Text(word.to_owned()));
        }
        assert_eq!(look.definitions.len(), 3, "a copy of each group, for both values");
        let values = |path: &str| {
            let (_, node) = library.node_of(&look, blend_of(path).ids()).unwrap();
            node.values.clone()
        };
        assert_eq!(values("one/lit")["mode"], Value::Text("add".to_owned()));
        assert_eq!(values("one/lit")["clamp"], Value::Text("on".to_owned()));
        assert_eq!(values("two/lit"), values("rim"), "others are the library's");
        assert_ne!(values("two/lit"), values("one/lit"));
        // The other use is the only one of its group now.
        library.node_of_one_use(&mut look, &NodePath::parse("two/lit")).unwrap();
        assert_eq!(look.definitions.len(), 3);
    }

    #[test]
    fn copies_take_no_name_of_the_library_and_nothing_is_copied_for_what_is_not_there() {
        let before = look();
        let mut library = Library::built_in().clone();
        let other = r#"{"definitions": {"light_layer_alone": {"nodes": []}}}"#;
        library.add_groups("nodes/layer/other.json", other);
        let mut look = before.clone();
        assert!(library.node_of_one_use(&mut look, &NodePath::parse("rim/nothing")).is_none());
        assert_eq!(look, before);
        library.node_of_one_use(&mut look, &blend_of("rim")).unwrap();
        assert_ne!(look.graph.nodes["rim"].kind, "light_layer_alone");
        assert!(look.definitions.contains_key(look.graph.nodes["rim"].kind.as_str()));
    }
}
