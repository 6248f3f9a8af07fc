//! Work is counted, in wires followed, and never timed.

use super::*;

/// The look of a JSON text, read with whatever is odd in it.
fn look(text: &str) -> Look {
    Look::read(text, "test.json").value.unwrap()
}

/// Groups `g0`, `g1` ... each with the nodes named in `ids` of the next group, in a row from input
/// to output; the last only passes on what it is given. The look has one `g0`.
fn nested(depth: usize, ids: &[&str]) -> String {
    let mut definitions = Vec::new();
    for level in 0..depth {
        let inner = format!("g{}", level + 1);
        let nodes: Vec<String> =
            ids.iter().map(|id| format!(r#"{{"id": "{id}", "kind": "{inner}"}}"#)).collect();
        let mut from = "inputs.a".to_owned();
        let mut wires = Vec::new();
        for id in ids {
            wires.push(format!(r#"{{"from": "{from}", "to": "{id}.a"}}"#));
            from = (*id).to_owned();
        }
        wires.push(format!(r#"{{"from": "{from}", "to": "outputs.o"}}"#));
        definitions.push(group(level, &nodes.join(","), &wires.join(",")));
    }
    definitions.push(group(depth, "", r#"{"from": "inputs.a", "to": "outputs.o"}"#));
    format!(
        r#"{{"definitions": {{{}}}, "nodes": [{{"id": "top", "kind": "g0"}}, {{"kind": "output"}}],
            "wires": [{{"from": "top", "to": "output.color"}}]}}"#,
        definitions.join(",")
    )
}

fn group(level: usize, nodes: &str, wires: &str) -> String {
    format!(
        r#""g{level}": {{"inputs": [{{"name": "a"}}], "outputs": [{{"name": "o"}}],
            "nodes": [{nodes}], "wires": [{wires}]}}"#
    )
}

/// The flattened graph, with the number of wires that were followed for it.
fn flattened(look: &Look) -> (FlatGraph, usize, Vec<Diagnostic>) {
    let mut problems = Vec::new();
    let groups = UsedGroups::of(look, Library::built_in()).unwrap();
    let exact = HashSet::new();
    let mut flattener = Flattener::new(look, Library::built_in(), &exact, groups);
    flattener.run();
    problems.append(&mut flattener.problems);
    (flattener.flat, flattener.followed.get(), problems)
}

fn refused(text: &str) -> Diagnostic {
    let mut problems = Vec::new();
    assert!(flatten(&look(text), Library::built_in(), &HashSet::new(), &mut problems).is_none());
    assert_eq!(problems.len(), 1, "{problems:?}");
    problems.remove(0)
}

#[test]
fn groups_that_multiply_are_refused_before_any_is_opened() {
    let problem = refused(&nested(40, &["x", "y"]));
    assert_eq!(
        (problem.code, problem.place.node),
        ("too-many-nodes", Some(NodePath::parse("top")))
    );
    // 2 to the power of 200 overflows every count.
    assert_eq!(refused(&nested(200, &["x", "y"])).code, "too-many-nodes");
    let problem = refused(&nested(2000, &["x"]));
    assert_eq!(
        (problem.code, problem.place.node),
        ("groups-too-deep", Some(NodePath::parse("top")))
    );
    assert_eq!(flattened(&look(&nested(200, &["x"]))).2, []);
}

/// Copies for lights multiply as groups do.
#[test]
fn groups_for_each_light_that_multiply_are_refused_before_any_is_opened() {
    let lights: Vec<String> = (0..100).map(|light| format!(r#""l{light}": {{}}"#)).collect();
    let each = nested(4, &["x"]).replace(r#""id": "x","#, r#""id": "x", "for_each": "*","#);
    let text = each.replacen('{', &format!(r#"{{"lights": {{{}}}, "#, lights.join(",")), 1);
    assert_eq!(refused(&text).code, "too-many-nodes");
}

#[test]
fn many_nodes_deep_in_groups_are_refused_for_what_their_paths_take() {
    let leaves: Vec<String> =
        (0..50_000).map(|i| format!(r#"{{"id": "n{i}", "kind": "reroute"}}"#)).collect();
    let text = nested(200, &["x"]).replace(
        r#""g200": {"inputs": [{"name": "a"}], "outputs": [{"name": "o"}],
            "nodes": []"#,
        &format!(
            r#""g200": {{"inputs": [{{"name": "a"}}], "outputs": [{{"name": "o"}}], "nodes": [{}]"#,
            leaves.join(",")
        ),
    );
    let problem = refused(&text);
    assert_eq!(problem.code, "too-many-nodes");
    assert!(problem.message.contains("deep"), "{problem}");
}

#[test]
fn what_lies_behind_an_input_is_walked_to_once() {
    // 4096 groups in a row, twelve deep; each passes on what the one before gives.
    let doubling = nested(12, &["x", "y"]);
    let (flat, followed, problems) = flattened(&look(&doubling));
    assert_eq!(problems, []);
    let wires = 8192 + 4 * 4096;
    assert!(followed <= wires, "{followed} of {wires}");
    let output = flat.by_path[&NodePath::parse("output")];
    assert!(
        matches!(flat.nodes[output].inputs[0], FlatInput::Param(_)),
        "the open input of the first group"
    );
    // A row of reroutes, and as many nodes that all hang on its end.
    let reroutes = (0..3000).map(|i| format!(r#"{{"id": "r{i}", "kind": "reroute"}}"#));
    let sines = (0..3000).map(|i| format!(r#"{{"id": "s{i}", "kind": "sine"}}"#));
    let row = (1..3000).map(|i| format!(r#"{{"from": "r{}", "to": "r{i}.value"}}"#, i - 1));
    let hanging = (0..3000).map(|i| format!(r#"{{"from": "r2999", "to": "s{i}.angle"}}"#));
    let text = format!(
        r#"{{"nodes": [{}], "wires": [{}]}}"#,
        reroutes.chain(sines).collect::<Vec<_>>().join(","),
        row.chain(hanging).collect::<Vec<_>>().join(",")
    );
    let (flat, followed, problems) = flattened(&look(&text));
    assert_eq!(problems, []);
    assert!(followed <= 6000, "{followed}");
    let first = &flat.nodes[flat.by_path[&NodePath::parse("r0")]].inputs[0];
    assert!(
        (0..3000)
            .all(|i| &flat.nodes[flat.by_path[&NodePath::parse(&format!("s{i}"))]].inputs[0]
                == first)
    );
}

#[test]
fn a_ring_is_gone_round_once_and_told_at_everything_that_it_feeds() {
    let sines: Vec<String> =
        (0..500).map(|i| format!(r#"{{"id": "s{i}", "kind": "sine"}}"#)).collect();
    let wires: Vec<String> =
        (0..500).map(|i| format!(r#"{{"from": "a", "to": "s{i}.angle"}}"#)).collect();
    let text = format!(
        r#"{{"nodes": [{{"id": "a", "kind": "reroute"}}, {{"id": "b", "kind": "reroute"}}, {}],
            "wires": [{{"from": "a", "to": "b.value"}}, {{"from": "b", "to": "a.value"}}, {}]}}"#,
        sines.join(","),
        wires.join(",")
    );
    let (_, followed, problems) = flattened(&look(&text));
    assert_eq!(problems.iter().filter(|problem| problem.code == "cycle").count(), 502);
    assert!(followed <= 502, "{followed}");
}

#[test]
fn groups_that_all_contain_one_another_are_told_and_not_opened() {
    let all: Vec<String> =
        (0..12).map(|i| format!(r#"{{"id": "n{i}", "kind": "g{i}"}}"#)).collect();
    let definitions: Vec<String> = (0..12).map(|level| group(level, &all.join(","), "")).collect();
    let text =
        format!(r#"{{"definitions": {{{}}}, "nodes": [{{"kind": "g3"}}]}}"#, definitions.join(","));
    let (flat, _, problems) = flattened(&look(&text));
    // One group is opened, and each of the twelve in it would lead back to it.
    assert_eq!(problems.iter().filter(|problem| problem.code == "recursive-group").count(), 12);
    assert!(flat.nodes.is_empty());
}

#[test]
fn names_in_groups_stay_short() {
    let long = "lantern ".repeat(1000);
    let text =
        nested(30, &["x"]).replace(r#""id": "x""#, &format!(r#""id": "x", "name": "{long}""#));
    let text = text.replace(
        r#""nodes": [], "wires": [{"from": "inputs.a", "to": "outputs.o"}]"#,
        r#""nodes": [{"kind": "sine"}], "wires": []"#,
    );
    let (flat, _, _) = flattened(&look(&text));
    assert!(flat.nodes.len() == 2 && flat.nodes.iter().all(|node| node.name.len() <= MAX_NAME));
}

#[test]
fn of_very_many_problems_some_have_suggestions() {
    let nodes: Vec<String> =
        (0..3000).map(|i| format!(r#"{{"id": "n{i}", "kind": "addx{i}"}}"#)).collect();
    let (_, _, problems) = flattened(&look(&format!(r#"{{"nodes": [{}]}}"#, nodes.join(","))));
    assert_eq!(problems.len(), 3000);
    assert_eq!(
        problems.iter().filter(|problem| !problem.hints.is_empty()).count(),
        MAX_SUGGESTIONS
    );
}

/// A document has no values for what lies within a group of the library, so that what is written
/// there stands in for them, also where the document is read anew for a live module.
#[test]
fn what_a_group_of_the_library_holds_is_its_own_default() {
    let mut written = Vec::new();
    for kind in Library::built_in().groups.keys() {
        let look = look(&format!(r#"{{"nodes": [{{"id": "own", "kind": "{kind}"}}]}}"#));
        let (flat, _, _) = flattened(&look);
        let group = NodePath::parse("own");
        for param in flat.params.iter().filter(|param| param.path != group) {
            let place = format!("{kind}: {}.{}", param.path, param.port);
            assert_eq!(param.default, param.value, "{place}");
            written.extend(param.value.is_some().then_some(place));
        }
    }
    assert!(written.contains(&"band_layer: own/place.from_high".to_owned()), "{written:?}");
}
