//! The window, driven by pointer and keys: each action of the first editor, without display and
//! GPU.

use crate::editor_support::{User, close, node_center};
use chiaro::compile::Live;
use chiaro::document::{Edit, Endpoint, GraphId, Value};
use chiaro::ids::NodeId;
use eframe::egui::{Key, Modifiers, pos2, vec2};
use egui_kittest::kittest::Queryable as _;
use serde_json::json;

fn wire_into(hand: &User, node: &str, port: &str) -> Option<Endpoint> {
    let graph = &hand.look().graph;
    graph.wire_into(&NodeId::from(node), &port.into()).map(|wire| wire.from.clone())
}

fn number(hand: &User, node: &str, port: &str) -> Option<f64> {
    match hand.look().graph.nodes[node].values.get(port) {
        Some(Value::Number(number)) => Some(*number),
        _ => None,
    }
}

#[test]
fn a_new_look_compiles() {
    let hand = User::new();
    assert!(hand.app().session().compilation().baked().unwrap().wgsl.contains("fn "));
    assert!(
        hand.app().session().compilation().problems().is_empty(),
        "{:?}",
        hand.app().session().compilation().problems()
    );
    assert!(!hand.app().session().is_dirty());
}

#[test]
fn a_node_is_added_by_search() {
    let mut hand = User::new();
    let empty = hand.empty_place();
    hand.double_click(empty);
    hand.type_text("profile");
    hand.key(Key::Enter);
    let graph = &hand.look().graph;
    assert_eq!(graph.nodes["profile"].kind, "profile");
    let selected: Vec<String> =
        hand.app().session().selection().nodes().map(ToString::to_string).collect();
    assert_eq!(selected, ["profile"]);
    assert!(hand.app().session().is_dirty());
    // The new node lies where the pointer was.
    assert!(hand.app().canvas().node_rect("profile").unwrap().expand(2.0).contains(empty));
}

#[test]
fn tab_opens_the_search_and_escape_closes_it() {
    let mut hand = User::new();
    let empty = hand.empty_place();
    hand.hover(empty);
    hand.key(Key::Tab);
    assert!(hand.harness.query_by_label("Add Absolute").is_some());
    hand.key(Key::ArrowDown);
    hand.key(Key::Escape);
    assert!(hand.harness.query_by_label("Add Absolute").is_none());
    assert_eq!(hand.look().graph.nodes.len(), 3);
}

#[test]
fn an_entry_of_the_search_is_clicked() {
    let mut hand = User::new();
    let empty = hand.empty_place();
    hand.double_click(empty);
    hand.type_text("mirrored");
    let at = hand.harness.get_by_label("Add Mirrored view").rect().center();
    hand.click(at);
    assert!(hand.look().graph.nodes.contains_key("mirrored_view"));
}

#[test]
fn a_wire_is_drawn_from_output_to_input_and_back() {
    let mut hand = User::new();
    // A wire from the base straight to the output, past the layer.
    hand.drag(hand.output("base", "below"), hand.input("output", "color"));
    assert_eq!(wire_into(&hand, "output", "color").unwrap().node.as_str(), "base");
    // A drag from an input back to an output.
    hand.undo();
    assert_eq!(wire_into(&hand, "output", "color").unwrap().node.as_str(), "diffuse");
    hand.drag(hand.input("diffuse", "kappa"), hand.output("diffuse", "tone"));
    assert_eq!(wire_into(&hand, "diffuse", "kappa"), None, "a node is not wired to itself");
}

#[test]
fn a_wire_that_does_not_fit_is_refused() {
    let mut hand = User::new();
    hand.add("light", pos2(40.0, 320.0));
    hand.drag(hand.output("light", "light"), hand.input("output", "cutoff"));
    assert_eq!(wire_into(&hand, "output", "cutoff"), None);
}

#[test]
fn a_wire_is_picked_up_and_dropped() {
    let mut hand = User::new();
    let nothing = hand.empty_place();
    hand.drag(hand.input("output", "color"), nothing);
    assert_eq!(wire_into(&hand, "output", "color"), None);
    assert!(
        hand.harness.query_by_label("Add Profile").is_none(),
        "no search for a wire that was picked up"
    );
    hand.undo();
    assert!(wire_into(&hand, "output", "color").is_some());
}

#[test]
fn a_wire_dropped_on_nothing_adds_what_fits() {
    let mut hand = User::new();
    let nothing = hand.empty_place();
    hand.add("light", pos2(40.0, 320.0));
    hand.drag(hand.output("light", "light"), nothing);
    assert!(hand.harness.query_by_label("Add Parametrization").is_some());
    assert!(hand.harness.query_by_label("Add Bands").is_none(), "bands take no light");
    hand.key(Key::Escape);
    hand.drag(hand.output("diffuse", "tone"), nothing);
    hand.type_text("invert");
    hand.key(Key::Enter);
    assert_eq!(wire_into(&hand, "invert", "value"), Some(Endpoint::new("diffuse", "tone")));
    // The node and its wire are one step.
    hand.undo();
    assert!(!hand.look().graph.nodes.contains_key("invert"));
}

#[test]
fn values_are_edited_and_a_drag_is_one_step() {
    let mut hand = User::new();
    hand.click(node_center(&hand, "diffuse"));
    let slider = hand.slider("Offset");
    hand.drag(slider.left_center() + vec2(4.0, 0.0), slider.center());
    let offset = number(&hand, "diffuse", "offset").expect("it has a value now");
    assert!(offset > 0.5 && offset < 2.6, "radians: {offset}");
    assert!(hand.app().session().steps().undo_label().unwrap().contains("offset"));
    hand.undo();
    assert_eq!(number(&hand, "diffuse", "offset"), None, "the whole drag is taken back at once");
    assert!(!hand.app().session().is_dirty());
    hand.redo();
    assert_eq!(number(&hand, "diffuse", "offset"), Some(offset));
}

#[test]
fn an_angle_is_typed_in_degrees() {
    let mut hand = User::new();
    hand.click(node_center(&hand, "diffuse"));
    let number_field = hand.number_field("Cut-off");
    hand.click(number_field.center());
    hand.key_with(Modifiers::COMMAND, Key::A);
    hand.type_text("120");
    hand.key(Key::Enter);
    let cutoff = number(&hand, "diffuse", "cutoff").expect("it has a value now");
    assert!(close(cutoff, 2.0 * std::f64::consts::PI / 3.0), "{cutoff}");
}

#[test]
fn a_number_that_is_still_being_typed_is_saved_with_the_look() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("look.json");
    let mut hand = User::new();
    hand.click(node_center(&hand, "diffuse"));
    let field = hand.number_field("Cut-off");
    hand.click(field.center());
    hand.key_with(Modifiers::COMMAND, Key::A);
    hand.type_text("120");
    hand.app_mut().answer_dialog(&path);
    hand.key_with(Modifiers::COMMAND, Key::S);
    hand.settle();
    let cutoff = number(&hand, "diffuse", "cutoff").expect("it has a value now");
    assert!(close(cutoff, 2.0 * std::f64::consts::PI / 3.0), "{cutoff}");
    assert!(!hand.app().session().is_dirty() && path.is_file());
}

#[test]
fn a_value_edit_compiles_no_live_shader() {
    let mut hand = User::new();
    let before = hand.app().session().compilation().live().unwrap().clone();
    hand.click(node_center(&hand, "diffuse"));
    let slider = hand.slider("Offset");
    hand.drag(slider.left_center() + vec2(4.0, 0.0), slider.center());
    assert!(std::sync::Arc::ptr_eq(&before, hand.app().session().compilation().live().unwrap()));
    // Another wire compiles a live shader.
    hand.drag(hand.output("base", "below"), hand.input("output", "color"));
    hand.settle();
    assert!(!std::sync::Arc::ptr_eq(&before, hand.app().session().compilation().live().unwrap()));
}

/// In a look with more than 16 KiB of values a value becomes a uniform when it is touched, at the
/// price of one compile.
#[test]
fn a_touched_value_of_a_long_look_becomes_live() {
    let count = 6000;
    let nodes = (0..count)
        .map(|index| json!({"id": format!("n{index}"), "kind": "add", "values": {"b": 0.001}}));
    let ends = [json!({"id": "start", "kind": "kappa"}), json!({"id": "output", "kind": "output"})];
    let nodes: Vec<_> = nodes.chain(ends).collect();
    let from = |index: usize| format!("n{index}");
    let wires =
        (1..count).map(|index| json!({"from": from(index - 1), "to": format!("n{index}.a")}));
    let ends = [("start".to_owned(), "n0.a"), (from(count - 1), "output.color")];
    let wires: Vec<_> =
        wires.chain(ends.map(|(from, to)| json!({"from": from, "to": to}))).collect();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("long.json");
    std::fs::write(&path, json!({"nodes": nodes, "wires": wires}).to_string()).unwrap();
    let mut hand = User::new();
    hand.app_mut().open(&path);
    hand.settle();
    let live_values = |hand: &User| match &hand.app().session().compilation().live().unwrap().live {
        Live::Touched(values) => {
            values.iter().map(|(node, port)| format!("{node}.{port}")).collect::<Vec<_>>()
        }
        other => panic!("{other:?} in a look past the bound"),
    };
    assert!(live_values(&hand).is_empty());
    let touch = |hand: &mut User, id: &str, number: f64| {
        let (graph, value) = (GraphId::Look, Value::Number(number));
        let edit = Edit::SetValue { graph, id: id.into(), port: "b".into(), value, index: None };
        hand.app_mut().session_mut().apply(edit, None).unwrap();
        hand.settle();
    };
    touch(&mut hand, "n7", 0.25);
    assert_eq!(live_values(&hand), ["n7.b"]);
    // A live value then changes without a compile.
    let before = hand.app().session().compilation().live().unwrap().clone();
    touch(&mut hand, "n7", 0.5);
    assert!(std::sync::Arc::ptr_eq(&before, hand.app().session().compilation().live().unwrap()));
    touch(&mut hand, "n8", 0.5);
    assert_eq!(live_values(&hand).len(), 2);
}

#[test]
fn a_choice_is_chosen() {
    let mut hand = User::new();
    hand.click(node_center(&hand, "diffuse"));
    let at = hand
        .harness
        .get_by_role_and_label(eframe::egui::accesskit::Role::ComboBox, "Shading type")
        .rect()
        .center();
    hand.click(at);
    let at = hand.harness.get_by_label("Specular").rect().center();
    hand.click(at);
    assert_eq!(hand.look().graph.nodes["diffuse"].values["type"], Value::Text("specular".into()));
}

#[test]
fn nodes_are_deleted_and_come_back() {
    let mut hand = User::new();
    let before = hand.look().clone();
    hand.click(node_center(&hand, "diffuse"));
    hand.key(Key::Delete);
    assert_eq!((hand.look().graph.nodes.len(), hand.look().graph.wires.len()), (2, 0));
    hand.undo();
    assert_eq!(*hand.look(), before);
    hand.redo();
    assert_eq!(hand.look().graph.nodes.len(), 2);
}

#[test]
fn keys_undo_and_redo() {
    let mut hand = User::new();
    hand.click(node_center(&hand, "base"));
    hand.key(Key::X);
    assert_eq!(hand.look().graph.nodes.len(), 2);
    hand.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(hand.look().graph.nodes.len(), 3);
    hand.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    assert_eq!(hand.look().graph.nodes.len(), 2);
}

#[test]
fn nodes_are_selected_by_click_shift_and_box() {
    let mut hand = User::new();
    let selected = |hand: &User| {
        hand.app().session().selection().nodes().map(ToString::to_string).collect::<Vec<_>>()
    };
    hand.click(node_center(&hand, "base"));
    assert_eq!(selected(&hand), ["base"]);
    hand.click_with(Modifiers::SHIFT, node_center(&hand, "output"));
    assert_eq!(selected(&hand), ["base", "output"]);
    let nothing = hand.empty_place();
    hand.click(nothing);
    assert!(selected(&hand).is_empty());
    let base = hand.app().canvas().node_rect("base").unwrap();
    let diffuse = hand.app().canvas().node_rect("diffuse").unwrap();
    hand.drag(base.left_top() - vec2(20.0, 20.0), diffuse.left_top() + vec2(30.0, 60.0));
    assert_eq!(selected(&hand), ["base", "diffuse"]);
    hand.key_with(Modifiers::COMMAND, Key::A);
    assert_eq!(selected(&hand).len(), 3);
}

#[test]
fn nodes_are_moved_in_one_step() {
    let mut hand = User::new();
    let before = hand.look().graph.nodes["base"].position;
    let from = hand.app().canvas().node_rect("base").unwrap().center_top() + vec2(0.0, 8.0);
    hand.drag(from, from + vec2(-40.0, 30.0));
    let (zoom, _) = hand.app().canvas().zoom_and_center();
    let after = hand.look().graph.nodes["base"].position;
    assert!((after[0] - before[0] + 40.0 / f64::from(zoom)).abs() < 2.0, "{before:?} {after:?}");
    hand.undo();
    assert_eq!(hand.look().graph.nodes["base"].position, before);
}

#[test]
fn a_copy_has_the_wires_of_its_original() {
    let mut hand = User::new();
    hand.click(node_center(&hand, "diffuse"));
    hand.key_with(Modifiers::COMMAND, Key::D);
    assert_eq!(wire_into(&hand, "diffuse_2", "below").unwrap().node.as_str(), "base");
    let selected: Vec<String> =
        hand.app().session().selection().nodes().map(ToString::to_string).collect();
    assert_eq!(selected, ["diffuse_2"]);
}

#[test]
fn a_look_is_saved_and_opened() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.json");
    let mut hand = User::new();
    hand.add("profile", pos2(0.0, 300.0));
    let steps = hand.app().session().steps().labels().count();
    assert!(hand.app_mut().save_as(&path));
    assert!(!hand.app().session().is_dirty());
    // Nobody had named it; to name it after its file is no step.
    assert_eq!(hand.look().name, "Mine");
    assert_eq!(hand.app().session().steps().labels().count(), steps);
    let saved = hand.look().clone();

    // The key saves to the look's file.
    hand.click(node_center(&hand, "base"));
    hand.key(Key::Delete);
    assert!(hand.app().session().is_dirty());
    hand.key_with(Modifiers::COMMAND, Key::S);
    assert!(!hand.app().session().is_dirty());

    let mut other = User::new();
    other.app_mut().open(&path);
    other.settle();
    assert_eq!(other.look().graph.nodes.len(), saved.graph.nodes.len() - 1);
    assert_eq!(other.app().session().path(), Some(path.as_path()));
    // Unchanged text is written back byte for byte.
    let text = std::fs::read(&path).unwrap();
    other.app_mut().save_as(&path);
    assert_eq!(std::fs::read(&path).unwrap(), text);
    other.app_mut().save_as(&folder.path().join("night.json"));
    assert_eq!(other.look().name, "Mine", "a name stays");
}

#[test]
fn a_file_that_cannot_be_read_leaves_the_look_and_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("broken.json");
    std::fs::write(&path, "{ \"nodes\": 12").unwrap();
    let mut hand = User::new();
    let before = hand.look().graph.nodes.len();
    hand.app_mut().open(&folder.path().join("missing.json"));
    hand.settle();
    assert_eq!(hand.look().graph.nodes.len(), before);
    hand.app_mut().open(&path);
    hand.settle();
    assert!(
        hand.app().session().path().is_none() || !hand.app_mut().save_as(&path),
        "what is not understood is kept"
    );
}

#[test]
fn changes_are_not_thrown_away_unasked() {
    let mut hand = User::new();
    hand.click(node_center(&hand, "base"));
    hand.key(Key::Delete);
    hand.key_with(Modifiers::COMMAND, Key::N);
    assert_eq!(hand.look().graph.nodes.len(), 2, "it asks first");
    let at = hand.harness.get_by_label("Cancel").rect().center();
    hand.click(at);
    assert_eq!(hand.look().graph.nodes.len(), 2);
    hand.key_with(Modifiers::COMMAND, Key::N);
    let at = hand.harness.get_by_label("Do not save").rect().center();
    hand.click(at);
    assert_eq!(hand.look().graph.nodes.len(), 3);
}

#[test]
fn an_error_shows_on_its_node_and_goes() {
    let mut hand = User::new();
    let good = hand.app().session().compilation().baked().unwrap().clone();
    let nothing = hand.empty_place();
    // Without a wire the output shows nothing, which is an error of the output node.
    hand.drag(hand.input("output", "color"), nothing);
    hand.settle();
    assert!(
        hand.app().canvas().has_error("output"),
        "{:?}",
        hand.app().session().compilation().problems()
    );
    assert!(
        std::sync::Arc::ptr_eq(&good, hand.app().session().compilation().baked().unwrap()),
        "the last good one stays"
    );
    hand.undo();
    hand.settle();
    assert!(!hand.app().canvas().has_error("output"));
    assert!(hand.app().session().compilation().problems().is_empty());
}

#[test]
fn a_click_on_a_problem_selects_its_node() {
    let mut hand = User::new();
    let nothing = hand.empty_place();
    hand.drag(hand.input("output", "color"), nothing);
    hand.settle();
    let at = hand.harness.get_by_label("Open the list of problems").rect().center();
    hand.click(at);
    hand.settle();
    let at = hand
        .harness
        .get_by_role_and_label(eframe::egui::accesskit::Role::Link, "Output: Color")
        .rect()
        .center();
    hand.click(at);
    let selected: Vec<String> =
        hand.app().session().selection().nodes().map(ToString::to_string).collect();
    assert_eq!(selected, ["output"]);
}

#[test]
fn the_camera_orbits_beside_the_object_and_lights_turn_on_it() {
    let mut hand = User::new();
    let rect = hand.app().viewport().rect().unwrap();
    let before = hand.app().session().view().orbit().clone();
    let corner = rect.left_top() + vec2(12.0, 12.0);
    hand.drag(corner, corner + vec2(60.0, 20.0));
    let orbited = hand.app().session().view().orbit().clone();
    assert!(orbited.yaw != before.yaw && orbited.pitch > before.pitch);
    assert_eq!(orbited.illumination, before.illumination);

    hand.drag(rect.center(), rect.center() + vec2(50.0, 0.0));
    let turned = hand.app().session().view().orbit().clone();
    assert_ne!(turned.illumination, orbited.illumination);
    assert_eq!((turned.yaw, turned.pitch), (orbited.yaw, orbited.pitch));
    assert!(!hand.app().session().is_dirty(), "neither belongs to the look");

    hand.hover(rect.center());
    hand.key(Key::R);
    assert_eq!(*hand.app().session().view().orbit(), before);
}

#[test]
fn the_wheel_zooms_about_the_pointer() {
    let mut hand = User::new();
    let at = hand.output("base", "below");
    let (zoom, _) = hand.app().canvas().zoom_and_center();
    hand.wheel(at, -120.0);
    let (after, _) = hand.app().canvas().zoom_and_center();
    assert!(after < zoom);
    assert!(hand.output("base", "below").distance(at) < 1.0);
    hand.key(Key::F);
}

/// Values of every kind, with numbers that no slider's step would give and some beyond their range.
const MIXED: &str = r##"{"lights": {
    "key": {"direction": [-0.5, 0.7, 0.6], "intensity": 7.12345},
    "spot": {"type": "spot", "inner": 0.3512345, "outer": 0.5123456}
  }, "nodes": [
    {"id": "light", "kind": "light", "values": {"light": "spot"}},
    {"id": "angle", "kind": "parametrization", "at": [240, 0],
    "values": {"normal": [0.123456, 0.5, 1]}},
    {"id": "tone", "kind": "profile", "at": [480, 0], "values": {"offset": 0.123456789,
    "cutoff": 1.23456789}},
    {"id": "bands", "kind": "bands", "at": [720, 0], "values": {"count": 5, "softness": 0.333333}},
    {"id": "curve", "kind": "curve", "at": [0, 200], "values": {"curve": {"points": [[0, 0.12345],
    [0.4, 0.7], [2, 1]]}}},
    {"id": "ramp", "kind": "ramp", "at": [960, 0], "values": {"ramp": {"stops": [{"at": 0.12345,
    "color": [0.1, 0.12345, 0.3]}]}}},
    {"id": "mine", "kind": "wgsl", "at": [0, 400],
    "values": {"code": "fn mine(a: f32) -> f32 { return a; }"}},
    {"id": "layer", "kind": "light_layer", "at": [240, 300], "values": {"light": "key",
    "convex": "#336699", "opacity": 0.123456}},
    {"id": "base", "kind": "base", "at": [480, 300],
    "values": {"color": [1.5, 0.123456, 0.3, 0.55555]}},
    {"id": "output", "kind": "output", "at": [1200, 0]}
  ], "wires": [
    {"from": "light", "to": "angle.light"}, {"from": "angle", "to": "tone.angle"},
    {"from": "tone", "to": "bands.value"},
    {"from": "bands", "to": "ramp.value"}, {"from": "ramp", "to": "output.color"},
    {"from": "base", "to": "layer.below"}
  ]}"##;

#[test]
fn looking_changes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mixed.json");
    std::fs::write(&path, MIXED).unwrap();
    let mut hand = User::new();
    hand.app_mut().open(&path);
    hand.settle();
    assert!(
        hand.app().session().compilation().problems().iter().all(|problem| !problem.is_error()),
        "{:?}",
        hand.app().session().compilation().problems()
    );
    let ids: Vec<NodeId> = hand.look().graph.nodes.keys().cloned().collect();
    for id in ids {
        hand.app_mut().session_mut().select(vec![id.clone()]);
        hand.settle();
        assert_eq!(hand.app().session().steps().undo_label(), None, "showing {id} changed it");
    }
    hand.app_mut().save_as(&path);
    assert_eq!(std::fs::read_to_string(&path).unwrap(), MIXED);
}

#[test]
fn a_window_at_rest_asks_for_no_frame() {
    let mut hand = User::new();
    hand.settle();
    hand.harness.run_steps(12);
    hand.settle();
    assert_eq!(hand.repaint_delay(), std::time::Duration::MAX);
}
