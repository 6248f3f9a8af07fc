//! Groups that are made, dissolved and pasted at random: the picture stays the same, and undoing
//! restores the file byte for byte.
#![cfg(feature = "gpu")]

use crate::support::eval::truth;
use crate::support::random::Random;
use crate::support::stacks::idle_stack;
use chiaro::document::grouping::{copy_text, dissolve, group, paste_text};
use chiaro::document::{Definition, Edit, GraphId, History, Look, Node};
use chiaro::frame::{EvalSample, SetupLook};
use chiaro::ids::{DefinitionId, NodeId, PortName};
use chiaro::library::{GroupPorts, Library};
use serde_json::json;

fn definition<'l>(look: &'l Look, kind: &str) -> Option<&'l Definition> {
    let own = look.definitions.get(kind);
    own.or_else(|| Library::built_in().groups.get(kind).map(|group| &group.definition))
}

fn first_output(look: &Look, node: &Node) -> Option<PortName> {
    match definition(look, &node.kind) {
        Some(definition) => GroupPorts::of(definition, &look.definitions, Library::built_in())
            .outputs
            .first()
            .map(|o| o.name.clone()),
        None => Library::built_in()
            .nodes
            .get(&node.kind)?
            .outputs
            .first()
            .map(|output| output.name.clone()),
    }
}

fn samples(seed: u64) -> Vec<EvalSample> {
    let mut random = Random::new(seed);
    let sample = |_| EvalSample {
        normal: random.direction(),
        view: random.direction(),
        kappa: random.between(-3.0, 3.0),
        frame: random.rotation(),
        ..EvalSample::default()
    };
    (0..12).map(sample).collect()
}

fn values(look: &Look, seed: u64) -> Vec<[f64; 4]> {
    let source = Look::read("{}", "none.json").source.into();
    let setup = SetupLook { look: look.clone(), source, folder: Default::default() };
    truth(&setup, "", &samples(seed))
}

/// One of the graphs of a look, at random.
fn any_graph(look: &Look, random: &mut Random) -> GraphId {
    let definitions = look.definitions.keys().cloned().map(GraphId::Definition);
    let graphs: Vec<GraphId> = std::iter::once(GraphId::Look).chain(definitions).collect();
    random.pick(&graphs).clone()
}

fn random_group(look: &Look, random: &mut Random) -> Option<Edit> {
    let graph = any_graph(look, random);
    let nodes = &look.graph_of(&graph)?.nodes;
    let likely = random.between(0.1, 0.9);
    let chosen: Vec<NodeId> = nodes
        .iter()
        .filter(|(_, node)| node.kind != "output" && random.chance(likely))
        .map(|(id, _)| id.clone())
        .collect();
    let taken = |slug: &str| Library::built_in().kinds().any(|kind| kind == slug);
    group(look, &graph, &chosen, "Part", taken, |node| first_output(look, node))
        .map(|grouped| grouped.edit)
}

fn random_dissolve(look: &Look, random: &mut Random) -> Option<Edit> {
    let graph = any_graph(look, random);
    let nodes = &look.graph_of(&graph)?.nodes;
    let once = nodes.iter().filter(|(_, node)| node.for_each.is_none());
    let groups: Vec<(&NodeId, &Definition)> =
        once.filter_map(|(id, node)| Some((id, definition(look, &node.kind)?))).collect();
    if groups.is_empty() {
        return None;
    }
    let (id, definition) = *random.pick(&groups);
    Some(dissolve(look, &graph, id, definition).expect("none is muted or runs for each light").edit)
}

/// Groups and ungroups again and again; the picture does not change, and all steps can be undone.
fn check(look: &Look, seed: u64) {
    let mut random = Random::new(seed);
    let before = values(look, seed);
    let text = look.to_text();
    let mut history = History::new(look.clone());
    let mut texts = vec![text];
    for step in 0..5 {
        let look = history.document();
        let edit = if random.chance(0.5) {
            random_dissolve(look, &mut random)
        } else {
            random_group(look, &mut random)
        };
        let Some(edit) = edit else { continue };
        history.apply(edit).unwrap_or_else(|problem| panic!("seed {seed}: {problem}"));
        let look = history.document();
        let read = Look::read(&look.to_text(), "grouped.json");
        let problems: Vec<String> = read.diagnostics.iter().map(ToString::to_string).collect();
        assert!(problems.is_empty(), "seed {seed}: {problems:?}");
        assert_eq!(values(look, seed), before, "seed {seed}, step {step}\n{}", look.to_text());
        texts.push(look.to_text());
    }
    while let Some(expected) = texts.pop() {
        assert_eq!(history.document().to_text(), expected, "seed {seed}");
        assert_eq!(history.undo().is_some(), !texts.is_empty());
    }
}

#[test]
fn examples_keep_their_picture() {
    for (seed, entry) in std::fs::read_dir("examples/looks").unwrap().enumerate() {
        let path = entry.unwrap().path();
        let look = Look::load(&chiaro::files::Disk, &path).value.unwrap();
        for round in 0..4 {
            check(&look, seed as u64 * 10 + round);
        }
    }
}

#[test]
fn stacks_keep_their_picture() {
    for seed in 0..30 {
        let look = idle_stack(&mut Random::new(seed)).look;
        check(&look, seed);
    }
}

fn keyed() -> Look {
    let json = json!({
        "lights": {"key": {"direction": [1, 2, 3]}},
        "nodes": [
            {"id": "base", "kind": "base"},
            {"id": "layer", "kind": "light_layer", "values": {"light": "key", "offset": 0.4}},
            {"id": "output", "kind": "output"}
        ],
        "wires": [{"from": "base", "to": "layer.below"}, {"from": "layer", "to": "output.color"}],
        "exposed": [{"name": "size", "target": "layer.offset"}],
        "time_keys": [{
            "target": "layer.cutoff", "keys": [{"time": 0, "value": 1.0}, {"time": 1, "value": 2.0}]
        }],
        "direction_keys": [{
            "by": "view", "keys": [{"direction": [0, 0, 1], "values": {"layer.slope": 0.5}}]
        }]
    });
    let loaded = Look::read(&json.to_string(), "keyed.json");
    assert!(loaded.diagnostics.is_empty(), "{:?}", loaded.diagnostics);
    loaded.value.unwrap()
}

#[test]
fn keys_and_exposed_inputs_follow_into_a_group_and_out_of_it() {
    let mut look = keyed();
    let before = look.to_text();
    let nodes = ["base".into(), "layer".into()];
    let grouped =
        group(&look, &GraphId::Look, &nodes, "Both", |_| false, |node| first_output(&look, node))
            .unwrap();
    assert_eq!((grouped.node.as_str(), grouped.definition.as_str()), ("both", "both"));
    let undo = look.apply(grouped.edit).unwrap();
    assert_eq!(look.exposed[0].target.to_string(), "both/layer.offset");
    assert_eq!(look.time_keys[0].target.to_string(), "both/layer.cutoff");
    assert_eq!(
        look.direction_keys[0].keys[0].values.keys().next().unwrap().to_string(),
        "both/layer.slope"
    );
    assert!(look.check().is_empty(), "{:?}", look.check());
    let again = dissolve(&look, &GraphId::Look, &"both".into(), &look.definitions["both"]).unwrap();
    let regroup = look.apply(again.edit).unwrap();
    assert_eq!(look.exposed[0].target.to_string(), "layer.offset");
    assert_eq!(look.time_keys[0].target.to_string(), "layer.cutoff");
    assert!(look.definitions.is_empty(), "nothing uses it any more");
    // Dissolving the library's group moves the layer's own input to a node that was in the group.
    let layer = definition(&look, "light_layer").unwrap();
    let opened = dissolve(&look, &GraphId::Look, &"layer".into(), layer).unwrap();
    let close = look.apply(opened.edit).unwrap();
    assert!(look.check().is_empty(), "{:?}", look.check());
    assert!(look.exposed[0].target.to_string().ends_with(".offset"), "{}", look.exposed[0].target);
    assert_eq!(look.time_keys.len(), 1);
    for edit in [close, regroup, undo] {
        look.apply(edit).unwrap();
    }
    assert_eq!(look.to_text(), before);
}

#[test]
fn a_muted_group_is_not_dissolved() {
    let mut look = keyed();
    look.graph.nodes["layer"].muted = true;
    let layer = definition(&look, "light_layer").unwrap();
    assert!(dissolve(&look, &GraphId::Look, &"layer".into(), layer).is_err());
}

/// Nodes that go through the clipboard come out the same, in another look, too.
#[test]
fn what_is_copied_is_pasted_with_its_groups_and_lights() {
    for seed in 0..12 {
        let mut random = Random::new(seed);
        let mut look = idle_stack(&mut random).look;
        for _ in 0..2 {
            if let Some(edit) = random_group(&look, &mut random) {
                look.apply(edit).unwrap();
            }
        }
        let nodes: Vec<NodeId> = look.graph.nodes.keys().cloned().collect();
        let text = copy_text(&look, &look.graph, &nodes, &[]);
        let mut other = Look::default();
        let before = other.to_text();
        let pasted = paste_text(&other, &GraphId::Look, &text, None).unwrap();
        let undo = other.apply(pasted.edit).unwrap();
        assert_eq!(pasted.nodes.len(), nodes.len());
        assert_eq!(values(&other, seed), values(&look, seed), "seed {seed}");
        // A second paste beside the first pastes no output, and changes nothing of the first.
        let again = paste_text(&other, &GraphId::Look, &text, Some([500.0, 300.0])).unwrap();
        assert_eq!(again.nodes.len(), nodes.len() - 1);
        let undo_again = other.apply(again.edit).unwrap();
        assert!(other.check().is_empty(), "{:?}", other.check());
        assert_eq!(values(&other, seed), values(&look, seed), "seed {seed}");
        other.apply(undo_again).unwrap();
        other.apply(undo).unwrap();
        assert_eq!(other.to_text(), before);
    }
}

#[test]
fn a_group_of_the_same_name_but_other_content_gets_a_new_name() {
    let mut look = keyed();
    let nodes = ["base".into(), "layer".into()];
    let grouped =
        group(&look, &GraphId::Look, &nodes, "Both", |_| false, |node| first_output(&look, node))
            .unwrap();
    look.apply(grouped.edit).unwrap();
    let text = copy_text(&look, &look.graph, &["both".into()], &[]);
    look.definitions["both"].help = "Changed since.".to_owned();
    let pasted = paste_text(&look, &GraphId::Look, &text, None).unwrap();
    look.apply(pasted.edit).unwrap();
    assert_eq!(
        look.definitions.keys().map(DefinitionId::as_str).collect::<Vec<_>>(),
        ["both", "both_2"]
    );
    assert_eq!(look.graph.nodes["both_2"].kind, "both_2");
}

#[test]
fn text_that_is_no_look_is_refused() {
    for text in ["", "hello", "{}", "{\"nodes\": 3}", "[1, 2]", "{\"nodes\": []}"] {
        assert!(paste_text(&Look::default(), &GraphId::Look, text, None).is_err(), "{text}");
    }
}
