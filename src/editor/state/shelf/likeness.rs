//! Likeness of looks: they are the same however their canvases are laid out.

use crate::document::{Definition, Graph, Look, Node, Note};

/// True if two looks are the same but for their names, and for places, folded nodes and bookmarks
/// of their canvases.
pub(super) fn are_alike(one: &Look, two: &Look) -> bool {
    let Look {
        name: _,
        about,
        tags,
        color_space,
        tier,
        max_error,
        tuned,
        lights,
        graph,
        definitions,
        exposed,
        aovs,
        direction_keys,
        time_keys,
        markers,
        unknown,
    } = one;
    let words = (about, tags, tuned) == (&two.about, &two.tags, &two.tuned);
    let settings = (color_space, tier, max_error, lights)
        == (&two.color_space, &two.tier, &two.max_error, &two.lights);
    let outside = (exposed, aovs, direction_keys, time_keys, markers, unknown)
        == (
            &two.exposed,
            &two.aovs,
            &two.direction_keys,
            &two.time_keys,
            &two.markers,
            &two.unknown,
        );
    let others = two.definitions.iter();
    let has_same_groups = || {
        definitions.len() == two.definitions.len()
            && definitions
                .iter()
                .zip(others)
                .all(|((id, a), (other, b))| id == other && are_groups_alike(a, b))
    };
    words && settings && outside && are_graphs_alike(graph, &two.graph) && has_same_groups()
}

fn are_groups_alike(one: &Definition, two: &Definition) -> bool {
    let Definition { label, help, inputs, outputs, graph, unknown } = one;
    (label, help, inputs, outputs, unknown)
        == (&two.label, &two.help, &two.inputs, &two.outputs, &two.unknown)
        && are_graphs_alike(graph, &two.graph)
}

fn are_graphs_alike(one: &Graph, two: &Graph) -> bool {
    let Graph { nodes, wires, frames, notes, bookmarks: _ } = one;
    let said = |note: &Note| (note.text.clone(), note.color.clone());
    (wires, frames) == (&two.wires, &two.frames)
        && nodes.len() == two.nodes.len()
        && nodes
            .iter()
            .zip(&two.nodes)
            .all(|((id, a), (other, b))| id == other && are_nodes_alike(a, b))
        && notes.values().map(said).eq(two.notes.values().map(said))
}

fn are_nodes_alike(one: &Node, two: &Node) -> bool {
    let Node {
        kind,
        name,
        position: _,
        values,
        tier,
        for_each,
        links,
        muted,
        collapsed: _,
        unknown,
    } = one;
    (kind, name, values, tier, for_each, links, muted, unknown)
        == (
            &two.kind,
            &two.name,
            &two.values,
            &two.tier,
            &two.for_each,
            &two.links,
            &two.muted,
            &two.unknown,
        )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_folds_and_names_leave_looks_alike_and_values_do_not() {
        let text = r#"{"name": "Day", "nodes": [{"id": "base", "kind": "base"},
          {"id": "rim", "kind": "light_layer", "name": "Rim"}], "notes": {"note": {"text": "!"}}}"#;
        let look = Look::read(text, "test").value.unwrap();
        let with = |change: fn(&mut Look)| {
            let mut other = look.clone();
            change(&mut other);
            (are_alike(&look, &other), look == other)
        };
        assert_eq!(with(|_| ()), (true, true));
        assert_eq!(with(|look| look.name = "Night".to_owned()), (true, false));
        assert_eq!(with(|look| look.graph.nodes["rim"].collapsed = true), (true, false));
        assert_eq!(with(|look| look.graph.nodes["rim"].position = [9.0, 9.0]), (true, false));
        assert_eq!(with(|look| look.graph.notes["note"].position = [9.0, 9.0]), (true, false));
        assert_eq!(with(|look| look.graph.nodes["rim"].muted = true), (false, false));
        assert_eq!(with(|look| look.graph.notes["note"].text = "?".to_owned()), (false, false));
        assert_eq!(with(|look| drop(look.graph.nodes.shift_remove("rim"))), (false, false));
    }
}
