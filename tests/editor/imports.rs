//! Graphs of other programs, opened in the window.

use std::fs;

use crate::editor_support::User;
use chiaro::editor::App;
use egui_kittest::kittest::Queryable as _;

/// A document with a node that has no twin here.
const GRAPH: &str = r#"<materialx version="1.39">
  <noise3d name="cloud" type="float"/>
  <multiply name="dim" type="color3">
    <input name="in1" type="color3" value="0.8, 0.3, 0.1"/>
    <input name="in2" type="float" nodename="cloud"/>
  </multiply>
  <surface_unlit name="flat" type="surfaceshader">
    <input name="emission_color" type="color3" nodename="dim"/>
  </surface_unlit>
</materialx>"#;

/// A MaterialX document becomes a new look, told in words, which one step takes back; a broken one
/// leaves what is open, and tells why.
#[test]
fn a_document_of_materialx_becomes_a_look() {
    let folder = tempfile::tempdir().expect("a folder");
    let (graph, broken) = (folder.path().join("a.mtlx"), folder.path().join("b.mtlx"));
    fs::write(&graph, GRAPH).expect("a file");
    fs::write(&broken, GRAPH.replace("\"dim\"/>", "\"dam\"/>")).expect("a file");
    let mut hand = User::with(|ctx| App::new(ctx, None));
    hand.settle();
    hand.app_mut().open(&graph);
    hand.settle();
    let told = "1 has no twin here and came as a note with its values";
    assert!(hand.harness.query_all_by_label_contains(told).next().is_some(), "{told}");
    let look = hand.look().clone();
    assert_eq!(look.name, "flat");
    assert!(look.graph.notes.values().any(|note| note.text.contains("noise3d")));
    hand.undo();
    assert_ne!(hand.look().name, "flat", "one step takes the import back");
    hand.redo();
    assert_eq!(*hand.look(), look);
    hand.app_mut().open(&broken);
    hand.settle();
    assert_eq!(*hand.look(), look, "what is open stays");
    let said = "there is no such node";
    assert!(hand.harness.query_all_by_label_contains(said).next().is_some(), "{said}");
}

/// A lamp of a photometric file is chosen for a node, and named as it lies beside the look.
#[test]
fn an_image_is_chosen_by_a_dialog() {
    let folder = tempfile::tempdir().expect("a folder");
    let (look, lamp) = (folder.path().join("look.json"), folder.path().join("lamps/wings.ies"));
    fs::create_dir(folder.path().join("lamps")).expect("a folder");
    fs::write(&lamp, include_str!("../../examples/images/two-wings.ies")).expect("a file");
    let text = r#"{"lights": {"key": {"type": "point"}}, "nodes": [
        {"id": "lamp", "kind": "photometry", "values": {"light": "key"}},
        {"id": "output", "kind": "output", "at": [400, 0]}],
      "wires": [{"from": "lamp.share", "to": "output.color"}]}"#;
    fs::write(&look, text).expect("a file");
    let mut hand = User::with(|ctx| App::new(ctx, None));
    hand.app_mut().open(&look);
    hand.app_mut().session_mut().select(vec!["lamp".into()]);
    hand.settle();
    hand.app_mut().answer_dialog(&lamp);
    hand.press("Choose...");
    let value = hand.look().graph.nodes["lamp"].values["image"].clone();
    assert_eq!(value, chiaro::document::Value::Text("lamps/wings.ies".into()));
    assert!(!hand.says("1 error") && !hand.says("cannot be read"), "the lamp is read");
    hand.undo();
    assert!(!hand.look().graph.nodes["lamp"].values.contains_key("image"));
}
