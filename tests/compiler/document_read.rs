//! Documents are read: their values, the texts that are kept, and the places that are found again.
//! Diagnostics of mistakes stand in `tests/cases`.

use chiaro_compiler::document::{Document, GraphId, Look, Scene, Target, Value};
use chiaro_language::diag::{Diagnostic, has_errors};
use chiaro_language::ids::NodePath;

const LOOK: &str = r##"{
  "name": "Dawn",
  "lights": { "key": { "direction": [0.5, 0.5, 1] } },
  "nodes": [
    { "id": "paper", "kind": "base", "values": { "color": "#f4e8d0" } },
    { "id": "rim", "kind": "light_layer", "values": { "light": "key", "offset": 1.2 } },
    { "kind": "output" }
  ],
  "wires": [
    { "from": "paper", "to": "rim.below" },
    { "from": "rim.color", "to": "output.color" }
  ],
  "exposed": [{ "name": "offset", "target": "rim.offset" }]
}
"##;

/// Text of problems as users see it.
fn shown(problems: &[Diagnostic]) -> String {
    problems.iter().map(|problem| format!("{problem}\n")).collect()
}

#[test]
fn a_short_look_is_read_without_complaint() {
    let loaded = Look::read(LOOK, "dawn.json");
    assert_eq!(shown(&loaded.diagnostics), "");
    let look = loaded.value.unwrap();
    assert_eq!(look.graph.nodes.len(), 3);
    assert_eq!(look.graph.nodes["paper"].values["color"].color().unwrap()[3], 1.0);
    assert_eq!(look.graph.nodes["rim"].values["offset"], Value::Number(1.2));
    assert_eq!(look.graph.nodes["output"].kind, "output");
    assert_eq!(look.graph.wires[0].from.port.as_str(), "");
    assert_eq!(look.to_text_like(&loaded.source), LOOK);
}

#[test]
fn the_canonical_form_has_one_thing_on_each_line() {
    let text = Look::read(LOOK, "").value.unwrap().to_text();
    let expected = r##"{
  "chiaro": "look",
  "version": 1,
  "name": "Dawn",
  "lights": {
    "key": { "direction": [0.5, 0.5, 1] }
  },
  "nodes": [
    { "id": "paper", "kind": "base", "values": { "color": "#f4e8d0" } },
    { "id": "rim", "kind": "light_layer", "values": { "light": "key", "offset": 1.2 } },
    { "id": "output", "kind": "output" }
  ],
  "wires": [
    { "from": "paper", "to": "rim.below" },
    { "from": "rim.color", "to": "output.color" }
  ],
  "exposed": [
    { "name": "offset", "target": "rim.offset" }
  ]
}
"##;
    assert_eq!(text, expected);
    assert_eq!(Look::default().to_text(), "{\n  \"chiaro\": \"look\",\n  \"version\": 1\n}\n");
    assert_eq!(Scene::default().to_text(), "{\n  \"chiaro\": \"scene\",\n  \"version\": 1\n}\n");
}

#[test]
fn unknown_fields_are_kept() {
    let text = r#"{ "nmae": [1, 2.50], "lights": { "key": { "colour": "red", "x": null } },
        "wires": [{ "from": "a", "to": "a.b", "bend": 2 }], "nodes": [{ "kind": "a",
        "values": { "r": { "points": [[0, 0]], "y": 1 } } }] }"#;
    let mut look = Look::read(text, "").value.unwrap();
    look.name = "changed".to_owned();
    let written = look.to_text();
    for kept in [
        r#""nmae": [1, 2.5]"#,
        r#""key": { "colour": "red", "x": null }"#,
        r#""to": "a.b", "bend": 2 }"#,
        r#"{ "points": [[0, 0]], "y": 1 }"#,
    ] {
        assert!(written.contains(kept), "{kept}\n{written}");
    }
    let schema = r#"{ "$schema": "look.schema.json" }"#;
    assert!(
        Look::read(schema, "")
            .value
            .unwrap()
            .to_text()
            .contains(r#""$schema": "look.schema.json""#)
    );
}

#[test]
fn short_forms_of_a_scene_are_read() {
    let text = r##"{ "illumination": { "axis": [0, 2, 0], "angle": 3.141592653589793 },
        "backdrop": "#ff000080",
        "objects": [{ "mesh": "meshes/Big Rock.v2.obj", "looks": { "*": "a.json",
        "skin 2": "b.json" } }, { "looks": "c.json" }] }"##;
    let scene = Scene::read(text, "").value.unwrap();
    let expected = [0.0, 1.0, 0.0, 0.0];
    assert!(
        scene.illumination.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-15),
        "{:?}",
        scene.illumination
    );
    assert_eq!(scene.backdrop, Some([1.0, 0.0, 0.0, 128.0 / 255.0]));
    assert_eq!(scene.objects["big_rock"].looks["skin 2"], "b.json");
    assert_eq!(scene.objects["sphere"].looks["*"], "c.json");
    let half_turn = Scene::read(r#"{ "illumination": [[-1, 0, 0], [0, 1, 0], [0, 0, -1]] }"#, "")
        .value
        .unwrap();
    assert_eq!(half_turn.illumination, expected);
}

#[test]
fn a_document_is_known_by_what_it_holds() {
    assert!(Scene::read(r#"{ "nodes": [] }"#, "").value.is_none());
    assert!(matches!(Document::read(r#"{ "objects": [] }"#, ""), Document::Scene(_)));
    assert!(matches!(Document::read("{}", ""), Document::Look(_)));
}

#[test]
fn problems_are_counted_beyond_a_bound() {
    let wrong = r#"{ "id": 1, "kind": "x" }, "#.repeat(3000);
    let found =
        Look::read(&format!("{{ \"nodes\": [{}] }}", wrong.trim_end_matches(", ")), "").diagnostics;
    assert_eq!(found.len(), 1001);
    assert!(found[1000].message.contains("2000 more"), "{}", found[1000]);
    let many = r#"{ "id": "a", "kind": "x" }, "#.repeat(200_001);
    let found =
        Look::read(&format!("{{ \"nodes\": [{}] }}", many.trim_end_matches(", ")), "").diagnostics;
    assert_eq!(found[0].code, "too-many");
}

/// A chain of 100,000 nodes, as issue 2 asks, is read and written.
#[test]
fn large_looks_are_read() {
    let count = 100_000;
    let mut look = Look::default();
    for i in 0..count {
        let node = chiaro_compiler::document::Node {
            kind: "maths_add".to_owned(),
            position: [i as f64 * 160.0, 0.5],
            values: [("b".into(), Value::Number(i as f64 / 7.0))].into(),
            ..Default::default()
        };
        look.graph.nodes.insert(format!("add_{i}").into(), node);
    }
    for i in 1..count {
        let (from, to) = (format!("add_{}", i - 1), format!("add_{i}"));
        let to = chiaro_compiler::document::Endpoint::new(to, "a");
        look.graph.wires.push(chiaro_compiler::document::Wire {
            from: chiaro_compiler::document::Endpoint::new(from, ""),
            to,
        });
    }
    let text = look.to_text();
    let loaded = Look::read(&text, "chain.json");
    assert_eq!(shown(&loaded.diagnostics), "");
    assert_eq!(loaded.value.as_ref(), Some(&look));
    let mut problem =
        Diagnostic::error("unknown-kind", "").node(NodePath::parse("add_99999")).port("b".into());
    loaded.source.locate(&mut problem);
    assert_eq!(problem.place.json_path.as_deref(), Some("nodes[99999].values.b"));
}

#[test]
fn places_are_found_for_others() {
    let text = r#"{
  "nodes": [
    { "id": 3, "kind": "broken" },
    { "id": "g", "kind": "group" },
    { "id": "rim", "kind": "light_layer", "values": { "offset": 1 } }
  ],
  "wires": [
    { "from": "nothing here" },
    { "from": "g", "to": "rim.below" }
  ],
  "definitions": { "group": { "nodes": [{ "id": "inner", "kind": "x", "values": { "a": 1 } }] } }
}"#;
    let loaded = Look::read(text, "a.json");
    assert!(has_errors(&loaded.diagnostics));
    let look = loaded.value.unwrap();
    let place = |mut problem: Diagnostic| {
        loaded.source.locate(&mut problem);
        let at = problem.place.at.unwrap();
        assert_eq!(problem.place.file.as_deref(), Some("a.json"));
        format!("{}:{} {}", at.line, at.column, problem.place.json_path.unwrap())
    };
    let problem = || Diagnostic::error("x", "");
    // Places by node and port; a port that the text does not have is placed at its node.
    assert_eq!(
        place(problem().node(NodePath::parse("rim")).port("offset".into())),
        "5:65 nodes[2].values.offset"
    );
    assert_eq!(
        place(problem().node(NodePath::parse("rim")).port("fall_off".into())),
        "5:5 nodes[2]"
    );
    assert_eq!(
        place(problem().node(NodePath::parse("g/inner"))),
        "11:41 definitions.group.nodes[0]"
    );
    assert_eq!(
        place(problem().node(NodePath::parse("g/inner")).port("a".into())),
        "11:88 definitions.group.nodes[0].values.a"
    );
    // Places by a path of the value, whose lists lack the text's broken items.
    let rim = look.json_path_of_node(&NodePath::parse("rim")).unwrap();
    assert_eq!(rim, "nodes[1]");
    assert_eq!(place(problem().json_path(rim)), "5:5 nodes[2]");
    let wire = look.json_path_of_input(&NodePath::parse("rim"), &"below".into()).unwrap();
    assert_eq!(wire, "wires[0]");
    assert_eq!(place(problem().json_path(wire)), "9:5 wires[1]");
    let value = look.json_path_of_input(&NodePath::parse("g/inner"), &"b".into()).unwrap();
    assert_eq!(value, "definitions.group.nodes[0].values.b");
    assert_eq!(place(problem().json_path(value)), "11:81 definitions.group.nodes[0].values.b");
    assert_eq!(look.json_path_of_target(&Target::parse("lights.key.color").unwrap()), None);
    assert_eq!(
        look.find(&NodePath::parse("g/inner")).unwrap().graph,
        GraphId::Definition("group".into())
    );
    assert!(
        look.find(&NodePath::parse("g/nothing")).is_none()
            && look.find(&NodePath::default()).is_none()
    );
    // A problem of a node that does not exist still names the file.
    let mut lost = problem().node(NodePath::parse("no/such"));
    loaded.source.locate(&mut lost);
    assert_eq!(lost.place.file.as_deref(), Some("a.json"));
    assert_eq!(loaded.source.place_of("definitions.group.nodes[0].kind").unwrap().line, 11);
}

#[test]
fn documents_are_saved_and_loaded() {
    use crate::support::chiaro_files::TextDocument as _;

    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("dawn.json");
    std::fs::write(&path, LOOK).unwrap();
    let loaded = Look::load(&crate::support::chiaro_files::Disk, &path);
    let mut look = loaded.value.clone().unwrap();
    look.save(&path, Some(&loaded.source)).unwrap();
    assert_eq!(std::fs::read_to_string(&path).unwrap(), LOOK);
    look.name = "Dusk".to_owned();
    look.save(&path, Some(&loaded.source)).unwrap();
    assert_eq!(std::fs::read_to_string(&path).unwrap(), look.to_text());
    let missing =
        Scene::load(&crate::support::chiaro_files::Disk, &folder.path().join("missing.json"));
    assert_eq!((missing.value, missing.diagnostics[0].code), (None, "cannot-read"));
    assert!(missing.diagnostics[0].to_string().contains("missing.json"));
}
