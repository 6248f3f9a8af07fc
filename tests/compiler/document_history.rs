//! Undo and redo as users meet them.

use chiaro_compiler::document::{Edit, Endpoint, GraphId, History, Look, Value, Wire};

fn history() -> History<Look> {
    let text = r#"{
        "lights": { "key": {}, "fill": {} },
        "nodes": [{ "kind": "base" }, { "id": "g", "kind": "group" },
        { "id": "rim", "kind": "layer" }, { "kind": "output" }],
        "wires": [{ "from": "base", "to": "rim.below" }, { "from": "rim", "to": "output.color" }],
        "frames": { "f": { "title": "warm", "nodes": ["rim", "base"] } },
        "definitions": { "group": { "nodes": [{ "kind": "inner" }], "inputs": [{ "name": "x" }] } },
        "exposed": [{ "name": "a", "target": "base.color" },
        { "name": "b", "target": "rim.offset" }, { "name": "c", "target": "g/inner.x" }],
        "direction_keys": [{ "by": { "light": "key" }, "keys": [{ "direction": [0, 0, 1],
        "values": { "rim.offset": 1, "base.color": 2 } }] }],
        "time_keys": [{ "target": "lights.fill.color" }, { "target": "rim.offset" }]
    }"#;
    let loaded = Look::read(text, "");
    assert!(loaded.diagnostics.is_empty(), "{:?}", loaded.diagnostics);
    History::new(loaded.value.unwrap())
}

fn set(value: f64) -> Edit {
    let (graph, id, port) = (GraphId::Look, "rim".into(), "offset".into());
    Edit::SetValue { graph, id, port, value: Value::Number(value), index: None }
}

fn offset(history: &History<Look>) -> Option<&Value> {
    history.document().graph.nodes["rim"].values.get("offset")
}

#[test]
fn a_drag_is_one_step() {
    let mut history = history();
    history.apply(set(0.5)).unwrap();
    for i in 0..100 {
        history.apply_in(7, set(f64::from(i))).unwrap();
    }
    history.apply_in(8, set(-1.0)).unwrap();
    assert_eq!(history.undo(), Some("change rim.offset"));
    assert_eq!(offset(&history), Some(&Value::Number(99.0)));
    history.undo();
    assert_eq!(offset(&history), Some(&Value::Number(0.5)));
    history.redo();
    assert_eq!(offset(&history), Some(&Value::Number(99.0)));
    // The undo ended the gesture: another edit of it is a step of its own.
    history.apply_in(7, set(3.0)).unwrap();
    assert!(history.redo().is_none(), "a new edit ends what could be redone");
    history.undo();
    assert_eq!(offset(&history), Some(&Value::Number(99.0)));
    history.undo();
    history.undo();
    assert_eq!(offset(&history), None);
    assert!(history.undo().is_none());
}

#[test]
fn a_gesture_of_different_edits_is_undone_in_order() {
    let mut history = history();
    let before = history.document().to_text();
    let node = chiaro_compiler::document::Node { kind: "layer".to_owned(), ..Default::default() };
    history
        .apply_in(1, Edit::AddNode { graph: GraphId::Look, id: "new".into(), node, index: Some(1) })
        .unwrap();
    let wire = Wire { from: Endpoint::new("new", ""), to: Endpoint::new("rim", "below") };
    history.apply_in(1, Edit::AddWire { graph: GraphId::Look, wire, index: None }).unwrap();
    assert_eq!(
        history.document().graph.wires[0].from.node.as_str(),
        "new",
        "it took the old wire's place"
    );
    let after = history.document().to_text();
    assert_eq!(history.undo(), Some("add new"));
    assert_eq!(history.document().to_text(), before);
    history.redo();
    assert_eq!(history.document().to_text(), after);
}

#[test]
fn removing_a_node_takes_all_that_names_it_and_undo_brings_it_back() {
    let mut history = history();
    let before = history.document().to_text();
    history.apply(Edit::RemoveNode { graph: GraphId::Look, id: "rim".into() }).unwrap();
    let look = history.document();
    assert!(look.graph.wires.is_empty());
    assert_eq!(look.graph.frames["f"].nodes, ["base".into()]);
    assert_eq!(look.exposed.len(), 2);
    assert_eq!(look.time_keys.len(), 1);
    assert_eq!(look.direction_keys[0].keys[0].values.len(), 1);
    assert_eq!(history.undo(), Some("remove rim"));
    assert_eq!(history.document().to_text(), before);

    // First a node in a group, then the group's node itself.
    for (graph, id) in [(GraphId::Definition("group".into()), "inner"), (GraphId::Look, "g")] {
        history.apply(Edit::RemoveNode { graph, id: id.into() }).unwrap();
        assert_eq!(history.document().exposed.len(), 2);
        history.undo();
        assert_eq!(history.document().to_text(), before);
    }
    history
        .apply(Edit::SetKind { graph: GraphId::Look, id: "g".into(), kind: "layer".to_owned() })
        .unwrap();
    assert_eq!(history.document().exposed.len(), 2);
    history.undo();
    history.apply(Edit::RemoveLight { id: "key".into() }).unwrap();
    assert!(history.document().direction_keys.is_empty());
    history.undo();
    history.apply(Edit::RemoveLight { id: "fill".into() }).unwrap();
    assert_eq!(history.document().time_keys.len(), 1);
    history.undo();
    assert_eq!(history.document().to_text(), before);
}

#[test]
fn impossible_edits_are_refused() {
    let mut history = history();
    let before = history.document().clone();
    let (look, group) = (GraphId::Look, GraphId::Definition("group".into()));
    let node = || chiaro_compiler::document::Node { kind: "x".to_owned(), ..Default::default() };
    let light =
        |intensity: f64| chiaro_compiler::document::Light { intensity, ..Default::default() };
    let wire = |from: &str, to: &str| Edit::AddWire {
        graph: GraphId::Look,
        wire: Wire { from: Endpoint::parse(from), to: Endpoint::parse(to) },
        index: None,
    };
    let cases: Vec<(Edit, &str)> = vec![
        (
            Edit::AddNode { graph: look.clone(), id: "rim".into(), node: node(), index: None },
            "already",
        ),
        (
            Edit::AddNode {
                graph: look.clone(),
                id: "two words".into(),
                node: node(),
                index: None,
            },
            "no id",
        ),
        (
            Edit::AddNode { graph: group.clone(), id: "inputs".into(), node: node(), index: None },
            "own inputs",
        ),
        (
            Edit::AddNode { graph: look.clone(), id: "new".into(), node: node(), index: Some(9) },
            "no place 9",
        ),
        (
            Edit::AddNode {
                graph: GraphId::Definition("no".into()),
                id: "new".into(),
                node: node(),
                index: None,
            },
            "group `no`",
        ),
        (Edit::RemoveNode { graph: look.clone(), id: "no".into() }, "no node `no`"),
        (Edit::SetName { graph: group, id: "rim".into(), name: String::new() }, "no node `rim`"),
        (set(f64::NAN), "no finite number"),
        (set(1e300), "out of range"),
        (wire("no", "rim.a"), "no node `no`"),
        (wire("base", "rim"), "no id"),
        (Edit::AddLight { id: "key".into(), light: light(1.0), index: None }, "already"),
        (Edit::SetLight { id: "key".into(), light: light(-1.0) }, "out of range"),
        (Edit::SetLight { id: "no".into(), light: light(1.0) }, "no light `no`"),
        (Edit::RemoveDefinition { id: "group".into() }, "`g` is of the group"),
        (Edit::RemoveExposed { index: 3 }, "no number 3"),
    ];
    for (edit, message) in cases {
        let problem = history.apply(edit.clone()).expect_err("impossible");
        assert!(problem.message.contains(message), "{edit:?}: {problem}");
        assert_eq!(history.document(), &before);
    }
    assert!(history.undo_label().is_none() && history.is_saved());
}

#[test]
fn a_broken_document_can_be_mended_and_broken_again() {
    let text = r#"{ "nodes": [{ "kind": "a" }], "wires": [{ "from": "a", "to": "a.x" },
        { "from": "gone", "to": "a.x" }],
        "exposed": [{ "name": "e", "target": "gone.x" }] }"#;
    let look = Look::read(text, "").value.unwrap();
    let mut history = History::new(look.clone());
    let wire = Wire { from: Endpoint::new("a", "y"), to: Endpoint::new("a", "x") };
    history.apply(Edit::AddWire { graph: GraphId::Look, wire, index: None }).unwrap();
    history.apply(Edit::RemoveExposed { index: 0 }).unwrap();
    assert!(history.document().check().is_empty());
    history.undo();
    history.undo();
    assert_eq!(history.document(), &look);
}

#[test]
fn saved_states_are_known() {
    let mut history = history();
    assert!(history.is_saved());
    history.apply(set(1.0)).unwrap();
    assert!(!history.is_saved());
    history.mark_saved();
    history.apply(set(1.0)).unwrap();
    assert!(history.is_saved(), "setting what is there changes nothing");
    history.undo();
    assert!(!history.is_saved());
    history.redo();
    assert!(history.is_saved());
    history.undo();
    history.apply(set(2.0)).unwrap();
    assert!(!history.is_saved());
    assert_eq!(history.undo_label(), Some("change rim.offset"));
}
