//! Nodes that name no tier have the cheapest whose difference nobody can see.

use chiaro_compiler::compile::{TierReason, check};
use chiaro_compiler::document::{Look, Tier};
use chiaro_compiler::library::Library;
use chiaro_language::ids::{NodePath, PortName};

use crate::support;

fn look(text: &str) -> Look {
    let read = Look::read(text, "look.json");
    assert!(read.diagnostics.is_empty(), "{:?}", read.diagnostics);
    read.value.unwrap()
}

/// Tier of each node of a look, by its path.
fn tiers(look: &Look) -> Vec<(String, Tier)> {
    let typed = check(look, Library::built_in(), None).expect("it is whole").value;
    typed.nodes.iter().map(|node| (node.path.to_string(), node.tier)).collect()
}

fn tier_of(look: &Look, node: &str) -> Tier {
    let all = tiers(look);
    all.iter().find(|(path, _)| path == node).unwrap_or_else(|| panic!("{node}: {all:?}")).1
}

/// A sine of the texture coordinates, times `factor`, of which the fraction goes into `port` of the
/// Output.
fn fraction_into(port: &str, factor: f64, rest: &str) -> Look {
    let color = match port {
        "color" => "",
        _ => r#", {"from": "u.x", "to": "output.color"}"#,
    };
    look(&format!(
        r#"{{"chiaro": "look", {rest} "nodes": [
            {{"id": "uv", "kind": "uv"}},
            {{"id": "u", "kind": "separate_vector"}},
            {{"id": "turns", "kind": "multiply", "values": {{"b": 12.9}}}},
            {{"id": "wave", "kind": "sine"}},
            {{"id": "large", "kind": "multiply", "values": {{"b": {factor}}}}},
            {{"id": "part", "kind": "fraction"}},
            {{"id": "output", "kind": "output"}}],
            "wires": [{{"from": "uv", "to": "u.vector"}}, {{"from": "u.x", "to": "turns.a"}},
                {{"from": "turns", "to": "wave.angle"}}, {{"from": "wave", "to": "large.a"}},
                {{"from": "large", "to": "part.value"}},
                {{"from": "part", "to": "output.{port}"}}{color}]}}"#
    ))
}

fn fraction_of_sine(factor: f64, rest: &str) -> Look {
    fraction_into("color", factor, rest)
}

#[test]
fn an_error_that_grows_is_not_made() {
    assert_eq!(tier_of(&fraction_of_sine(1.0, ""), "wave"), Tier::Balanced);
    assert_eq!(tier_of(&fraction_of_sine(43_758.545, ""), "wave"), Tier::Exact);
    // Only the node whose error grows.
    assert_eq!(tier_of(&fraction_of_sine(43_758.545, ""), "turns"), Tier::Balanced);
}

#[test]
fn a_bound_and_a_tier_are_kept() {
    for (rest, factor, wanted) in [
        (r#""max_error": 0,"#, 1.0, Tier::Exact),
        (r#""max_error": 1,"#, 43_758.545, Tier::Balanced),
        (r#""tier": "exact","#, 1.0, Tier::Exact),
        (r#""tier": "balanced","#, 43_758.545, Tier::Balanced),
        (r#""tier": "fast","#, 1.0, Tier::Fast),
    ] {
        assert_eq!(tier_of(&fraction_of_sine(factor, rest), "wave"), wanted, "{rest}");
    }
}

#[test]
fn nodes_that_say_they_are_seen_to_differ_stay_exact() {
    let edges = look(
        r#"{"chiaro": "look", "nodes": [{"id": "edge", "kind": "threshold"},
            {"id": "output", "kind": "output"}],
            "wires": [{"from": "edge", "to": "output.color"}]}"#,
    );
    assert_eq!(tier_of(&edges, "edge"), Tier::Exact);
}

/// Looks of plain math: all of their work is cheap.
#[test]
fn plain_looks_are_cheap() {
    let folder = support::root().join("benches/handwritten/looks");
    for name in ["math-gooch", "math-toon", "math-layers", "math-chain"] {
        let path = folder.join(format!("{name}.json"));
        let loaded = Look::load(&support::chiaro_files::Disk, &path);
        let exact: Vec<_> = tiers(&loaded.value.expect("it is whole"))
            .into_iter()
            .filter(|(_, tier)| *tier == Tier::Exact)
            .collect();
        assert!(exact.is_empty(), "{name}: {exact:?}");
    }
}

/// Parts that the Output cuts away belong to the picture, and so do values that a key sets later.
#[test]
fn all_that_a_picture_depends_on_counts() {
    assert_eq!(tier_of(&fraction_into("cutoff", 43_758.545, ""), "wave"), Tier::Exact);
    let keyed = r#""time_keys": [{"target": "large.b",
        "keys": [{"time": 0, "value": 1}, {"time": 1, "value": 43758.545}]}],"#;
    assert_eq!(tier_of(&fraction_of_sine(1.0, keyed), "wave"), Tier::Exact);
    let shown = check(
        &fraction_of_sine(43_758.545, ""),
        Library::built_in(),
        Some(&(NodePath::parse("turns"), PortName::from(""))),
    );
    let nodes = shown.expect("it is whole").value.nodes;
    let wave = nodes.iter().find(|node| node.path.to_string() == "wave").expect("it is there");
    assert_eq!(wave.tier_reason, TierReason::Grows, "a wire that is shown changes no tier");
}

/// Near black a step of linear light is many of a screen's: a look that is black but for the errors
/// of a sine and a cosine, of which twenty times are less than a step.
#[test]
fn linear_light_is_judged_as_it_is_shown() {
    let dark = |space: &str| {
        look(&format!(
            r#"{{"chiaro": "look", "color_space": "{space}", "nodes": [
                {{"id": "uv", "kind": "uv"}},
                {{"id": "u", "kind": "separate_vector"}},
                {{"id": "wave", "kind": "sine"}},
                {{"id": "other", "kind": "cosine"}},
                {{"id": "square", "kind": "multiply"}},
                {{"id": "other_square", "kind": "multiply"}},
                {{"id": "one", "kind": "add"}},
                {{"id": "nothing", "kind": "subtract", "values": {{"b": 1}}}},
                {{"id": "large", "kind": "multiply", "values": {{"b": 20}}}},
                {{"id": "shown", "kind": "add", "values": {{"b": 0.0015}}}},
                {{"id": "output", "kind": "output"}}],
                "wires": [{{"from": "uv", "to": "u.vector"}},
                    {{"from": "u.x", "to": "wave.angle"}}, {{"from": "u.x", "to": "other.angle"}},
                    {{"from": "wave", "to": "square.a"}}, {{"from": "wave", "to": "square.b"}},
                    {{"from": "other", "to": "other_square.a"}},
                    {{"from": "other", "to": "other_square.b"}},
                    {{"from": "square", "to": "one.a"}}, {{"from": "other_square", "to": "one.b"}},
                    {{"from": "one", "to": "nothing.a"}}, {{"from": "nothing", "to": "large.a"}},
                    {{"from": "large", "to": "shown.a"}},
                    {{"from": "shown", "to": "output.color"}}]}}"#
        ))
    };
    assert_eq!(tier_of(&dark("display"), "wave"), Tier::Balanced);
    assert_eq!(tier_of(&dark("linear"), "wave"), Tier::Exact);
}
