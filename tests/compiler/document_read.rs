//! Reading documents: every mistake is told, with its place and what to write instead.

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

/// The problems as people see them.
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

/// Reads a look and holds its problems to `code path @what stands there | hints`.
#[track_caller]
fn told(text: &str, expected: &[&str]) {
    held(&Look::read(text, "a.json").diagnostics, expected, text);
}

#[track_caller]
fn scene_told(text: &str, expected: &[&str]) {
    held(&Scene::read(text, "a.json").diagnostics, expected, text);
}

#[track_caller]
fn held(found: &[Diagnostic], expected: &[&str], text: &str) {
    let line = |d: &Diagnostic| {
        assert_eq!(d.place.file.as_deref(), Some("a.json"), "{d}");
        let at = d.place.at.expect("a place");
        let rest =
            text.lines().nth(at.line as usize - 1).unwrap().chars().skip(at.column as usize - 1);
        let there: String = rest.take(10).collect();
        format!(
            "{} {} @{there} | {}",
            d.code,
            d.place.json_path.as_deref().unwrap_or_default(),
            d.hints.join("; ")
        )
    };
    let found: Vec<String> = found.iter().map(line).collect();
    assert_eq!(found, expected, "\n{text}");
}

#[test]
fn wrong_values_are_told() {
    told(r#"{ "name": 3 }"#, &["wrong-type name @3 } | "]);
    told(r#"{ "name": null }"#, &["wrong-type name @null } | leave the field out for its default"]);
    told(r#"{ "nodes": {} }"#, &["wrong-type nodes @{} } | "]);
    told(r#"{ "version": "1" }"#, &["wrong-type version @\"1\" } | write 1 without quotes"]);
    told(r#"{ "version": 0 }"#, &["out-of-range version @0 } | write 1"]);
    told(
        r#"{ "color_space": "linaer" }"#,
        &["unknown-word color_space @\"linaer\" } | did you mean `linear`?"],
    );
    told(
        r#"{ "lights": { "key": { "direction": [0, 0, 0] } } }"#,
        &["zero-vector lights.key.direction @[0, 0, 0]  | write any other length, e.g. [0, 0, 1]"],
    );
    told(
        r#"{ "lights": { "key": { "intensity": -1, "inner": 2 } } }"#,
        &[
            "out-of-range lights.key.intensity @-1, \"inner | write a number from 0 to 1000000",
            "out-of-range lights.key.inner @2 } } } | the full cone lies inside the whole one",
        ],
    );
    told(
        r#"{ "lights": { "key": { "outer": 3.2 } } }"#,
        &["out-of-range lights.key.outer @3.2 } } } | write a number above 0 to pi"],
    );
    told(
        r##"{ "lights": { "key": { "color": "#ff00ff00" } } }"##,
        &["bad-color lights.key.color @\"#ff00ff00 | write \"#rrggbb\", or the numbers [r, g, b]"],
    );
    told(
        r#"{ "lights": { "key": { "position": [1, 2] } } }"#,
        &["wrong-count lights.key.position @[1, 2] } } | "],
    );
}

#[test]
fn numbers_that_are_none_are_told() {
    let node = |value: &str| {
        format!(r#"{{ "nodes": [{{ "kind": "x", "values": {{ "v": {value} }} }}] }}"#)
    };
    let hint = "write a number that is not beyond all bounds";
    for value in ["NaN", "Infinity", "-Infinity", "1e999", "-1e400", "inf"] {
        let there: String = format!("{value} }} }}] }}").chars().take(10).collect();
        told(&node(value), &[&format!("not-finite nodes[0].values.v @{there} | {hint}")]);
    }
    told(
        &node("1e39"),
        &["out-of-range nodes[0].values.v @1e39 } }]  | write a number from -3.4e38 to 3.4e38"],
    );
    told(
        &node("[1, \"2\", null]"),
        &[
            "wrong-type nodes[0].values.v[1] @\"2\", null] | write 2 without quotes",
            "wrong-type nodes[0].values.v[2] @null] } }] | ",
        ],
    );
    told(&node("[]"), &["wrong-count nodes[0].values.v @[] } }] } | "]);
    told(
        &node("null"),
        &["wrong-type nodes[0].values.v @null } }]  | leave the value out for the input's default"],
    );
    told(
        &node(r#"{ "points": [[0, 0], [0, 1]] }"#),
        &["not-increasing nodes[0].values.v @{ \"points\" | sort them, and remove doubles"],
    );
    told(
        &node(r#"{ "stops": [] }"#),
        &["wrong-count nodes[0].values.v @{ \"stops\": | write at least one"],
    );
    let many = "[0, 0], ".repeat(17);
    let found =
        Look::read(&node(&format!("{{ \"points\": [{}] }}", many.trim_end_matches(", "))), "")
            .diagnostics;
    assert!(found.iter().any(|d| d.code == "too-many"), "{found:?}");
}

#[test]
fn ids_are_held() {
    told(
        r#"{ "nodes": [{ "id": "Rim light", "kind": "x" }] }"#,
        &["bad-id nodes[0].id @\"Rim light | write `rim_light`"],
    );
    told(r#"{ "lights": { "": {} } }"#, &["bad-id lights[\"\"] @\"\": {} } } | write `n`"]);
    told(
        r#"{ "nodes": [{ "id": "a", "kind": "x" }, { "id": "a", "kind": "y" }] }"#,
        &["duplicate-id nodes[1] @{ \"id\": \"a | write \"id\": \"a_2\""],
    );
    told(
        r#"{ "nodes": [{ "kind": "x" }, { "kind": "x" }, { "id": "x", "kind": "y" }] }"#,
        &[
            "duplicate-id nodes[0] @{ \"kind\":  | write \"id\": \"x_2\"",
            "duplicate-id nodes[1] @{ \"kind\":  | write \"id\": \"x_2\"",
        ],
    );
    told(
        r#"{ "lights": { "a": {}, "a": {} } }"#,
        &["duplicate-key lights.a @\"a\": {} }  | remove one"],
    );
    told(r#"{ "name": "a", "name": "b" }"#, &["duplicate-key name @\"name\": \"b | remove one"]);
    told(
        r#"{ "nodes": [{}] }"#,
        &["missing-field nodes[0] @{}] } | kind: A node of the library, or the id of a \
             definition."],
    );
    told(
        r#"{ "definitions": { "g": { "nodes": [{ "id": "inputs", "kind": "x" }] } } }"#,
        &["reserved-id definitions.g.nodes[0].id @\"inputs\",  | "],
    );
    scene_told(
        r#"{ "objects": [{ "id": "a" }, { "id": "a" }, { "mesh": "shape:a" }] }"#,
        &["duplicate-id objects[1] @{ \"id\": \"a | write \"id\": \"a_2\""],
    );
}

#[test]
fn unknown_fields_are_warned_about_and_kept() {
    let text = r#"{ "nmae": [1, 2.50], "lights": { "key": { "colour": "red", "x": null } },
        "wires": [{ "from": "a", "to": "a.b", "bend": 2 }], "nodes": [{ "kind": "a", "values": { "r": { "points": [[0, 0]], "y": 1 } } }] }"#;
    told(
        text,
        &[
            "unknown-field nmae @\"nmae\": [1 | did you mean `name`?",
            "unknown-field lights.key.colour @\"colour\":  | did you mean `color`?",
            "unknown-field lights.key.x @\"x\": null  | ",
            "unknown-field wires[0].bend @\"bend\": 2  | ",
            "unknown-field nodes[0].values.r.y @\"y\": 1 } } | ",
        ],
    );
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
    told(schema, &[]);
    assert!(
        Look::read(schema, "")
            .value
            .unwrap()
            .to_text()
            .contains(r#""$schema": "look.schema.json""#)
    );
}

#[test]
fn wires_are_held_to_the_nodes() {
    let look = |wires: &str| {
        format!(
            r#"{{ "nodes": [{{ "kind": "base" }}, {{ "kind": "rim" }}],
"wires": [{wires}] }}"#
        )
    };
    told(
        &look(r#"{ "from": "bass", "to": "rim.below" }"#),
        &["unknown-node wires[0].from @\"bass\", \"t | did you mean `base`?"],
    );
    told(
        &look(r#"{ "from": "base", "to": "rim.below" }, { "from": "rim.a", "to": "rim.below" }"#),
        &["two-wires wires[1] @{ \"from\":  | remove one of them"],
    );
    let two = Look::read(
        &look(r#"{ "from": "base", "to": "rim.below" }, { "from": "rim.a", "to": "rim.below" }"#),
        "",
    );
    assert!(
        two.diagnostics[0].message.contains("from `base` and from `rim.a`"),
        "{}",
        two.diagnostics[0]
    );
    told(
        &look(
            r#"{ "from": "base" }, { "from": "base", "to": "" }, { "from": "base", "to": null }, { "from": "base", "to": "rim" }"#,
        ),
        &[
            "missing-field wires[0] @{ \"from\":  | to: The input, `node.port`.",
            "wire-to-nothing wires[1].to @\"\" }, { \"f | write \"node.input\"",
            "wire-to-nothing wires[2].to @null }, {  | write \"node.input\"",
            "wire-to-nothing wires[3].to @\"rim\" }] } | write \"node.input\"",
        ],
    );
    told(
        &look(r#"{ "from": "a b", "to": "rim.a.b" }"#),
        &[
            "bad-wire wires[0].from @\"a b\", \"to | write \"node.output\", or \"node\"",
            "bad-wire wires[0].to @\"rim.a.b\"  | write \"node.input\"",
        ],
    );
    told(
        r#"{ "definitions": { "g": { "wires": [{ "from": "outputs.a", "to": "outputs.b" }] } } }"#,
        &["wire-direction definitions.g.wires[0].from @\"outputs.a | exchange the ends of the \
             wire"],
    );
    // In the look's own graph the names are free.
    told(
        &look(r#"{ "from": "inputs", "to": "rim.a" }"#),
        &["unknown-node wires[0].from @\"inputs\",  | "],
    );
}

#[test]
fn keys_and_parameters_are_held_to_what_there_is() {
    let look = |rest: &str| {
        format!(
            r#"{{ "lights": {{ "key": {{}} }}, "nodes": [{{ "kind": "rim" }}, {{ "id": "g", "kind": "group" }}, {{ "kind": "other" }}],
"definitions": {{ "group": {{ "nodes": [{{ "kind": "inner" }}] }} }},
{rest} }}"#
        )
    };
    let good = r#""exposed": [{ "name": "a", "target": "rim.offset" }, { "name": "b", "target": "g/inner.x" },
        { "name": "c", "target": "other/deep.x" }, { "name": "d", "target": "lights.key.color" }]"#;
    told(&look(good), &[]);
    told(
        &look(
            r#""exposed": [{ "name": "a", "target": "rimm.offset" }, { "name": "a", "target": "g/iner.x" }]"#,
        ),
        &[
            "unknown-node exposed[0].target @\"rimm.offs | did you mean `rim`?",
            "duplicate-id exposed[1].name @\"a\", \"targ | give it another name",
            "unknown-node exposed[1].target @\"g/iner.x\" | did you mean `inner`?",
        ],
    );
    told(
        &look(
            r#""exposed": [{ "name": "a", "target": "rim" }, { "name": "b", "target": "lights.key.colour" }]"#,
        ),
        &[
            "bad-target exposed[0].target @\"rim\" }, { | write `node.input`, `group/node.input` \
             or `lights.light.field`",
            "bad-target exposed[1].target @\"lights.ke | did you mean `color`?",
        ],
    );
    let keys = r#""direction_keys": [{ "by": { "light": "kei" }, "keys": [{ "direction": [0, 0, 1], "values": { "rim.a": 1, "lights.fill.color": 2 } }] }]"#;
    told(
        &look(keys),
        &[
            "unknown-light direction_keys[0].by @{ \"light\": | did you mean `key`?",
            "unknown-light direction_keys[0].keys[0].values[\"lights.fill.color\"] @2 } }] }]  | ",
        ],
    );
    told(
        &look(r#""direction_keys": [{ "by": "veiw" }]"#),
        &["wrong-type direction_keys[0].by @\"veiw\" }]  | write \"view\", {\"light\": \"the \
             light's id\"}, or {\"drivers\": [\"distance\"]}"],
    );
    told(
        &look(
            r#""time_keys": [{ "target": "rim.a", "keys": [{ "time": 1, "value": 1 }, { "time": 0, "value": 2 }] }]"#,
        ),
        &["not-increasing time_keys[0].keys[1].time @0, \"value\" | sort the keys, and remove \
             doubles"],
    );
    told(
        &look(r#""frames": { "f": { "nodes": ["rim", "rimm"] } }"#),
        &["unknown-node frames.f.nodes[1] @\"rimm\"] }  | did you mean `rim`?"],
    );
}

#[test]
fn scenes_are_held_too() {
    scene_told(
        r#"{ "illumination": [0, 0, 0, 0] }"#,
        &["bad-rotation illumination @[0, 0, 0,  | write a quaternion [x, y, z, w], a 3x3 matrix \
             as three rows, or {\"axis\": [x, y, z], \"angle\": radians}"],
    );
    let bad = |text: &str, code: &str| {
        let found = Scene::read(text, "").diagnostics;
        assert_eq!(found.iter().map(|d| d.code).collect::<Vec<_>>(), [code], "{text}");
    };
    bad(r#"{ "illumination": [[1, 0, 0], [0, 1, 0], [0, 0, -1]] }"#, "bad-rotation");
    bad(r#"{ "illumination": [[2, 0, 0], [0, 1, 0], [0, 0, 1]] }"#, "bad-rotation");
    bad(r#"{ "illumination": [[1, 0, 0], [0, 1, 0]] }"#, "wrong-count");
    bad(r#"{ "illumination": "none" }"#, "bad-rotation");
    bad(r#"{ "objects": [{ "transform": { "scale": [1, 0, 1] } }] }"#, "out-of-range");
    bad(r#"{ "camera": { "eye": [0, 0, 0] } }"#, "bad-camera");
    bad(r#"{ "camera": { "up": [0, 0, 3] } }"#, "bad-camera");
    bad(r#"{ "time": { "start": 2, "end": 1 } }"#, "out-of-range");
    bad(r#"{ "backdrop": "blue" }"#, "bad-color");

    let text = r##"{ "illumination": { "axis": [0, 2, 0], "angle": 3.141592653589793 }, "backdrop": "#ff000080",
        "objects": [{ "mesh": "meshes/Big Rock.v2.obj", "looks": { "*": "a.json", "skin 2": "b.json" } }, { "looks": "c.json" }] }"##;
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
fn whole_files_are_refused_with_a_reason() {
    let codes = |text: &str| {
        let loaded = Look::read(text, "a.json");
        (loaded.value.is_some(), loaded.diagnostics.iter().map(|d| d.code).collect::<Vec<_>>())
    };
    assert_eq!(codes(""), (false, vec!["empty-file"]));
    assert_eq!(codes(" \n"), (false, vec!["empty-file"]));
    assert_eq!(codes("glTF\u{2}\0"), (false, vec!["not-json"]));
    assert_eq!(codes("<?xml"), (false, vec!["not-json"]));
    assert_eq!(codes("[]"), (false, vec!["wrong-document"]));
    assert_eq!(codes("3"), (false, vec!["wrong-document"]));
    assert_eq!(codes(r#"{ "chiaro": "scene" }"#), (false, vec!["wrong-document"]));
    assert_eq!(codes(r#"{ "objects": [] }"#), (false, vec!["wrong-document"]));
    assert_eq!(
        codes(r#"{ "asset": { "version": "2.0" }, "meshes": [], "nodes": [] }"#),
        (false, vec!["wrong-document"])
    );
    assert_eq!(codes(r#"{ "chiaro": "lok" }"#), (true, vec!["unknown-word"]));
    assert_eq!(codes(r#"{ "version": 2, "nodes": 3 }"#), (false, vec!["newer-version"]));
    assert_eq!(codes(r#"{ "nodes": [{ "kind": "a" }"#), (true, vec!["truncated"]));
    assert_eq!(codes("{}"), (true, vec![]));
    let newer = &Look::read(r#"{ "version": 2 }"#, "").diagnostics[0];
    assert!(
        newer.message.contains("version 2; this Chiaro reads up to 1")
            && newer.hints[0].contains("update")
    );
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
    // By node and port; what the text does not have is at the node.
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
    // By a path of the value, whose lists lack the broken items of the text.
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
    // A node that does not exist still has its file.
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
