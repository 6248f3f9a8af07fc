//! Names of nodes for people.

use crate::document::Look;
use crate::ids::{NodeId, NodePath};
use crate::library::Library;

/// Name of a node: the artist's, or else its id. An id that says something is a better name than
/// the kind's label, of which there may be twenty.
pub(super) fn own_name(id: &NodeId, name: &str, label: &str) -> String {
    if !name.is_empty() {
        return name.to_owned();
    }
    let slug = crate::ids::make_slug(label, |_| false);
    if id.as_str().starts_with(&slug) { label.to_owned() } else { id.as_str().to_owned() }
}

/// An id or a name as people write it: `back_light` becomes `Back light`.
pub(super) fn readable(name: &str) -> String {
    let text = name.replace('_', " ");
    let mut characters = text.chars();
    let first = characters.next().map(char::to_uppercase);
    first.into_iter().flatten().chain(characters).collect()
}

/// Name of a node with those of the groups around it: `Face / Rim`. What there is of the path is
/// named.
pub fn node_title(look: &Look, library: &Library, path: &NodePath) -> String {
    let mut graph = Some(&look.graph);
    let mut titles: Vec<String> = Vec::new();
    for id in path.ids() {
        let Some(node) = graph.and_then(|graph| graph.nodes.get(id)) else { break };
        let kind = node.kind.as_str();
        let group = library.group_of(look, kind);
        let label = match (group, library.nodes.get(kind)) {
            (Some(group), _) if !group.label.is_empty() => group.label.as_str(),
            (None, Some(def)) => def.label.as_str(),
            _ => kind,
        };
        titles.push(readable(&own_name(id, &node.name, label)));
        graph = group.map(|group| &group.graph);
    }
    titles.join(" / ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nodes_are_called_as_people_see_them() {
        let text = r#"{"chiaro": "look", "nodes": [
            {"id": "soft_edge", "kind": "profile"}, {"id": "profile_2", "kind": "profile"},
            {"id": "a", "kind": "profile", "name": "Kante"}, {"id": "face", "kind": "pair"}],
            "definitions": {"pair": {"label": "Pair", "nodes": [
                {"id": "x", "kind": "profile"}]}}}"#;
        let look = Look::read(text, "a.json").value.unwrap();
        let title = |path: &str| node_title(&look, Library::built_in(), &NodePath::parse(path));
        assert_eq!(title("soft_edge"), "Soft edge");
        assert_eq!(title("profile_2"), "Profile");
        assert_eq!(title("a"), "Kante");
        assert_eq!(title("face/x"), "Face / X");
        assert_eq!(title("nobody"), "");
    }
}
