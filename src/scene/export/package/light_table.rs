//! The table of a look's lights and of the nodes that each of them drives, for READMEs.

use std::collections::BTreeSet;

use indexmap::{IndexMap, IndexSet};

use super::super::description::{Description, LightDescription};
use super::parameter_table::cell;
use crate::compile::{TypedGraph, TypedNode, TypedSource};
use crate::ids::LightId;
use crate::library::Type;

/// Beginning of the table.
const HEAD: &str =
    "\nLights of the look, and what each drives:\n\n| light | drives |\n| --- | --- |\n";

/// The lights that the picture reads as a table of Markdown: a line each, with the nodes by the
/// artist's names. Empty for a look without lights.
pub(super) fn light_table(description: &Description, graph: &TypedGraph) -> String {
    if description.lights.is_empty() {
        return String::new();
    }
    let driven = driven_nodes(graph);
    let row = |light: &LightDescription| {
        let names = driven.get(&light.id).into_iter().flatten();
        let names: Vec<String> = names.map(|name| cell(name)).collect();
        let names = if names.is_empty() { "keys alone".to_owned() } else { names.join(", ") };
        format!("| {} | {names} |\n", name_of(light))
    };
    HEAD.to_owned() + &description.lights.iter().map(row).collect::<String>()
}

/// Id of a light, after its label where that says more.
fn name_of(LightDescription { id, label, .. }: &LightDescription) -> String {
    let says_more = !label.is_empty() && !label.eq_ignore_ascii_case(id.as_str());
    if says_more { format!("{}, `{id}`", cell(label)) } else { format!("`{id}`") }
}

/// Names of the nodes behind a picture that a light drives, each once, in the order in which they
/// are computed. Nodes that only hand a light or its angle on are left out: what takes that is
/// driven.
fn driven_nodes(graph: &TypedGraph) -> IndexMap<LightId, IndexSet<String>> {
    let behind = nodes_behind_picture(graph);
    let mut handed_on: Vec<BTreeSet<LightId>> = vec![BTreeSet::new(); graph.nodes.len()];
    let mut driven: IndexMap<LightId, IndexSet<String>> = IndexMap::new();
    for &index in graph.order.iter().filter(|index| behind.contains(*index)) {
        let node = &graph.nodes[index];
        let named = node.light.iter().filter(|_| !node.is_unlit).cloned();
        let taken = sources(node).filter(|(_, ty)| is_about_light(ty));
        let taken = taken.flat_map(|(source, _)| handed_on[source].iter().cloned());
        let lights: BTreeSet<LightId> = named.chain(taken).collect();
        if node.def.outputs.iter().any(|output| is_about_light(&output.ty)) {
            handed_on[index] = lights;
            continue;
        }
        for light in lights {
            driven.entry(light).or_default().insert(name_of_node(node));
        }
    }
    driven
}

/// Names of the nodes behind a picture that take values of these types, each once.
pub(super) fn nodes_that_take(graph: &TypedGraph, types: &[Type]) -> IndexSet<String> {
    let behind = nodes_behind_picture(graph);
    let nodes = graph.order.iter().filter(|index| behind.contains(*index));
    let nodes = nodes.map(|&index| &graph.nodes[index]);
    let takers =
        nodes.filter(|node| node.inputs.iter().flatten().any(|input| types.contains(&input.ty)));
    takers.map(name_of_node).collect()
}

/// Indices of the nodes that the picture is computed from.
fn nodes_behind_picture(graph: &TypedGraph) -> BTreeSet<usize> {
    let mut behind = BTreeSet::from([graph.root.0]);
    for &index in graph.order.iter().rev() {
        if behind.contains(&index) {
            behind.extend(sources(&graph.nodes[index]).map(|(source, _)| source));
        }
    }
    behind
}

/// Nodes that a node takes values of, with the types of the values.
fn sources(node: &TypedNode) -> impl Iterator<Item = (usize, &Type)> {
    node.inputs.iter().flatten().filter_map(|input| match input.source {
        TypedSource::Wire { node, .. } => Some((node, &input.ty)),
        _ => None,
    })
}

/// True for a light, and for the angle to one.
fn is_about_light(ty: &Type) -> bool {
    matches!(ty, Type::Light | Type::Angle)
}

/// Name of a node, or of the group around it, without those of lights.
fn name_of_node(node: &TypedNode) -> String {
    match &node.group {
        Some(group) => group.shared_name.clone(),
        None => node.shared_name.clone().unwrap_or_else(|| node.name.clone()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::check;
    use crate::document::Look;
    use crate::library::Library;

    #[test]
    fn a_light_drives_the_layers_that_name_it_and_those_that_take_its_angle() {
        let text = r#"{"chiaro": "look",
            "lights": {"key": {"direction": [0, 0, 1]}, "rim": {"direction": [1, 0, 0]}},
            "nodes": [
                {"id": "base", "kind": "base"},
                {"id": "a", "name": "Body", "kind": "light_layer", "values": {"light": "key"}},
                {"id": "b", "name": "Edge", "kind": "light_layer", "values": {"light": "rim"}},
                {"id": "c", "name": "Unused", "kind": "light_layer", "values": {"light": "key"}},
                {"id": "output", "kind": "output"}],
            "wires": [{"from": "base.below", "to": "a.below"},
                {"from": "a.below", "to": "b.below"}, {"from": "b.below", "to": "output.color"}]}"#;
        let look = Look::read(text, "look.json").value.expect("a look");
        let (typed, _) = check(&look, Library::built_in(), None).expect("typed").into_parts();
        let driven = driven_nodes(&typed);
        let of = |light: &str| driven[light].iter().map(String::as_str).collect::<Vec<_>>();
        assert_eq!([of("key"), of("rim")], [["Body"], ["Edge"]]);
    }
}
