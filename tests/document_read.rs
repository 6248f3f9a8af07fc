//! Reading documents: every mistake is told, with its place and what to write instead.

use chiaro::diag::Diagnostic;
use chiaro::document::{Document, Look, Scene, Value};

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

fn look_problems(text: &str) -> Vec<Diagnostic> {
    Look::read(text, "a.json").diagnostics
}

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
    assert_eq!(look.graph.wires[0].from.port.as_str(), "");
    assert_eq!(look.to_text_like(&loaded.source), LOOK);
}

#[test]
fn debug() {
    println!("{}", Look::read(LOOK, "a").value.unwrap().to_text());
    let text = r##"{ "chiaro": "look", "version": 1.5, "nmae": 3, "color_space": "linaer",
      "lights": {"key light": {}, "key": {"direction": [0,0,0], "intensity": -1, "color": "#12", "inner": 2}, "key": {}},
      "nodes": [ {"id": "a b", "kind": "x"}, {"id": "a", "kind": 3, "values": {"x": 1e999, "y": null, "z": [1, "2"], "w": NaN}},
         {"id": "a", "kind": "x",}, {"id": "basee" "kind": 'y'} ],
      "wires": [{"from": "a", "to": "b.c"}, {"to": "a.c"}, {"from": "a.x", "to": "a"}, {"from": "base", "to": "a.c"}, {"from": "a", "to": "a.c"},
      "exposed": [{"name": "offset", "target": "rim.offset"}],
      "direction_keys": [{"by": {"light": "kei"}, "keys": [{"direction": [0,1]}]}]
    }"##;
    println!("{}", shown(&look_problems(text)));
    println!("{}", shown(&look_problems(&LOOK[..300])));
    println!("{}", shown(&look_problems("")));
    println!("{}", shown(&look_problems("\u{feff}hello")));
    println!("{}", shown(&look_problems(r#"{"objects": []}"#)));
    println!("{}", shown(&look_problems(r#"{"version": 3}"#)));
    println!("{}", shown(Document::read(r#"{"objects": [{"mesh": "shape:sphere", "transform": {"rotate": [0,0,0,0]}, "looks": {"a": 3}}], "camera": {"eye": [0,0,0]}}"#, "s.json").diagnostics()));
    assert!(Scene::read("{}", "").value.is_some());
}
