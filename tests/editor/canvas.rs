//! The canvas, driven by pointer and keys: groups, frames, notes and every gesture, each one undo
//! step.

use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::editor_support::{User, node_center, set_text};
use chiaro::document::{Edit, Endpoint, GraphId, Look, Node, Value};
use chiaro::ids::NodeId;
use eframe::egui::{Event, Key, Modifiers, PointerButton, Pos2, accesskit, pos2, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use serde_json::json;

const CTRL: Modifiers = Modifiers::COMMAND;
const CTRL_SHIFT: Modifiers = Modifiers { shift: true, ..Modifiers::COMMAND };

fn open(json: &serde_json::Value) -> User {
    // The file is not deleted: the window tells of a deleted file, and the message takes room.
    static NUMBER: AtomicUsize = AtomicUsize::new(0);
    let number = NUMBER.fetch_add(1, Ordering::Relaxed);
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("canvas-{number}.json"));
    std::fs::write(&path, json.to_string()).unwrap();
    let mut hand = User::new();
    hand.app_mut().open(&path);
    hand.settle();
    hand
}

/// A window with two numbers, their sum, half of the sum, and an output.
fn sums() -> User {
    sums_with(&json!({"b": 0.5}))
}

/// The sum of two numbers, and what `values` make of it.
fn sums_with(values: &serde_json::Value) -> User {
    open(&json!({"nodes": [
        {"id": "a", "kind": "invert", "at": [0, 0], "values": {"value": 0.25}},
        {"id": "b", "kind": "invert", "at": [0, 160], "values": {"value": 0.5}},
        {"id": "sum", "kind": "add", "at": [260, 60]},
        {"id": "half", "kind": "multiply", "at": [520, 60], "values": values},
        {"id": "output", "kind": "output", "at": [780, 60]}
    ], "wires": [
        {"from": "a", "to": "sum.a"}, {"from": "b", "to": "sum.b"},
        {"from": "sum", "to": "half.a"}, {"from": "half", "to": "output.color"}
    ]}))
}

fn select(hand: &mut User, ids: &[&str]) {
    let ids = ids.iter().map(|id| NodeId::from(*id)).collect();
    hand.app_mut().session_mut().select(ids);
    hand.settle();
    let over = hand
        .app()
        .canvas()
        .node_rect("output")
        .or_else(|| hand.app().canvas().node_rect("outputs"))
        .unwrap();
    hand.hover(over.center_bottom() + vec2(0.0, 60.0));
}

fn selected(hand: &User) -> Vec<String> {
    hand.app().session().selection().nodes().map(ToString::to_string).collect()
}

fn wire_into(hand: &User, node: &str, port: &str) -> Option<String> {
    hand.app()
        .session()
        .graph()
        .wire_into(&NodeId::from(node), &port.into())
        .map(|wire| wire.from.to_string())
}

fn errors(hand: &User) -> Vec<String> {
    let problems = hand.app().session().compilation().problems().iter();
    problems.filter(|problem| problem.is_error()).map(ToString::to_string).collect()
}

/// Undoes all steps and asserts that the look is the file's again, byte for byte.
fn undoes_to(hand: &mut User, text: &str) {
    while hand.app_mut().session_mut().undo() {}
    assert_eq!(hand.look().to_text(), text);
}

fn drag_with(hand: &mut User, button: PointerButton, modifiers: Modifiers, path: &[Pos2]) {
    hand.hover(path[0]);
    hand.harness.event(Event::ModifiersChanged(modifiers));
    hand.harness.event(Event::PointerButton { pos: path[0], button, pressed: true, modifiers });
    hand.harness.step();
    for pair in path.windows(2) {
        for step in 1..=4 {
            hand.harness
                .event(Event::PointerMoved(pair[0] + (pair[1] - pair[0]) * (step as f32 / 4.0)));
            hand.harness.step();
        }
    }
    hand.harness.step();
    let pos = path[path.len() - 1];
    hand.harness.event(Event::PointerButton { pos, button, pressed: false, modifiers });
    hand.harness.step();
    hand.harness.event(Event::ModifiersChanged(Modifiers::NONE));
    hand.harness.run_steps(3);
}

#[test]
fn a_group_is_made_opened_edited_and_dissolved() {
    let mut hand = sums_with(&json!({}));
    let before = hand.look().to_text();
    select(&mut hand, &["sum", "half"]);
    hand.key_with(CTRL, Key::G);
    hand.settle();
    assert_eq!(selected(&hand), ["group"]);
    assert_eq!(hand.look().graph.nodes.len(), 4);
    assert_eq!(wire_into(&hand, "group", "a").unwrap(), "a");
    assert!(errors(&hand).is_empty(), "{:?}", errors(&hand));
    assert!(
        hand.harness.query_by_label_contains("Node Group").is_some(),
        "it has a name for screen readers"
    );

    // A double click on the group's title opens the group.
    hand.double_click(node_center(&hand, "group"));
    hand.settle();
    assert_eq!(hand.app().session().selection().open_groups(), ["group".into()]);
    assert!(
        hand.app().canvas().node_rect("sum").is_some()
            && hand.app().canvas().node_rect("a").is_none()
    );
    assert!(hand.app().canvas().node_rect("inputs").is_some(), "the group's ends are there");
    // An edit inside of the group is an edit of the definition.
    select(&mut hand, &["half"]);
    hand.key(Key::M);
    assert!(hand.look().definitions["group"].graph.nodes["half"].muted);
    hand.undo();
    // A wire dropped on an end makes a port.
    let end = hand.app().canvas().node_rect("inputs").unwrap().center_bottom() - vec2(0.0, 3.0);
    let b = hand.input("half", "b");
    hand.drag(b, end);
    assert_eq!(wire_into(&hand, "half", "b").unwrap(), "inputs.b_2");
    assert_eq!(hand.look().definitions["group"].inputs.len(), 3);
    hand.undo();
    assert_eq!(hand.look().definitions["group"].inputs.len(), 2);
    // The breadcrumbs lead back to the look.
    let at = hand.harness.get_by_label("Go to Look").rect().center();
    hand.click(at);
    assert!(hand.app().session().selection().open_groups().is_empty());
    assert_eq!(selected(&hand), ["group"], "where one came from is selected");

    hand.hover(node_center(&hand, "group"));
    hand.key_with(CTRL_SHIFT, Key::G);
    hand.settle();
    assert_eq!(selected(&hand), ["sum", "half"]);
    assert!(hand.look().definitions.is_empty());
    assert_eq!(wire_into(&hand, "output", "color").unwrap(), "half.product");
    assert!(errors(&hand).is_empty(), "{:?}", errors(&hand));
    undoes_to(&mut hand, &before);
}

#[test]
fn a_new_group_has_the_changed_values_as_its_own() {
    let inputs = |values: &serde_json::Value| {
        let mut hand = sums_with(values);
        select(&mut hand, &["sum", "half"]);
        hand.key_with(CTRL, Key::G);
        hand.settle();
        assert!(errors(&hand).is_empty(), "{:?}", errors(&hand));
        hand.look().definitions["group"].inputs.len()
    };
    let [plain, changed] = [json!({}), json!({"b": 0.25})].map(|values| inputs(&values));
    assert_eq!(changed, plain + 1, "the factor is set where the group is used");
}

#[test]
fn a_group_opens_by_key_and_undo_leaves_one_that_is_gone() {
    let mut hand = sums();
    select(&mut hand, &["sum"]);
    hand.key_with(CTRL, Key::G);
    hand.key_with(CTRL, Key::Enter);
    assert_eq!(hand.app().session().selection().open_groups().len(), 1);
    hand.key(Key::U);
    assert!(hand.app().session().selection().open_groups().is_empty());
    hand.key_with(CTRL, Key::Enter);
    assert_eq!(hand.app().session().selection().open_groups().len(), 1);
    hand.undo();
    assert!(hand.app().session().selection().open_groups().is_empty(), "the group is no more");
    assert!(hand.app().canvas().node_rect("a").is_some());
}

#[test]
fn a_group_of_the_library_is_looked_at_and_made_ones_own() {
    let mut hand = User::new();
    let before = hand.look().to_text();
    hand.double_click(node_center(&hand, "diffuse"));
    hand.settle();
    assert!(hand.app().session().graph_view().is_read_only());
    let inner = hand.app().session().graph().nodes.keys().next().unwrap().clone();
    hand.click(node_center(&hand, inner.as_str()));
    hand.key(Key::Delete);
    assert!(!hand.app().session().is_dirty(), "the library stays as it is");
    let at =
        hand.harness.get_all_by_label("Make it the look's own").next().unwrap().rect().center();
    hand.click(at);
    hand.settle();
    assert!(!hand.app().session().graph_view().is_read_only());
    assert!(hand.look().definitions.contains_key("light_layer"));
    hand.click(node_center(&hand, inner.as_str()));
    hand.key(Key::Delete);
    assert!(!hand.app().session().graph().nodes.contains_key(&inner));
    // After the undo the layer is the library's again.
    undoes_to(&mut hand, &before);
    hand.settle();
    assert!(hand.app().session().graph_view().is_read_only());
    assert!(errors(&hand).is_empty(), "{:?}", errors(&hand));
}

#[test]
fn the_ports_of_a_group_are_renamed_moved_and_removed() {
    let mut hand = sums();
    select(&mut hand, &["sum"]);
    hand.key_with(CTRL, Key::G);
    hand.key_with(CTRL, Key::Enter);
    hand.app_mut().session_mut().select(Vec::new());
    hand.settle();
    let at = hand.harness.get_by_label("Move down input a").rect().center();
    hand.click(at);
    let names = |hand: &User| {
        hand.look().definitions["group"]
            .inputs
            .iter()
            .map(|port| port.name.to_string())
            .collect::<Vec<_>>()
    };
    assert_eq!(names(&hand), ["b", "a"]);
    let at = hand.harness.get_by_label("Label of input a").rect().center();
    hand.click(at);
    hand.type_text("First");
    assert_eq!(hand.look().definitions["group"].inputs[1].label.as_deref(), Some("First"));
    let at = hand.harness.get_by_label("Remove input b").rect().center();
    hand.click(at);
    assert_eq!(names(&hand), ["a"]);
    assert_eq!(wire_into(&hand, "sum", "b"), None);
}

#[test]
fn a_frame_is_made_titled_moved_and_removed() {
    let mut hand = sums();
    let before = hand.look().to_text();
    select(&mut hand, &["a", "b"]);
    hand.key_with(CTRL, Key::J);
    hand.type_text("Numbers");
    hand.key(Key::Enter);
    let frame = hand.look().graph.frames["frame"].clone();
    assert_eq!(frame.title, "Numbers");
    assert_eq!(frame.nodes, ["a".into(), "b".into()]);
    assert!(hand.harness.query_by_label("Frame Numbers").is_some());
    // A drag of the frame's title moves both nodes, in one step.
    let place = hand.look().graph.nodes["b"].position;
    let title = hand.app().canvas().frame_title("frame").unwrap().center();
    hand.drag(title, title + vec2(-60.0, 90.0));
    assert_ne!(hand.look().graph.nodes["b"].position, place);
    assert_eq!(hand.look().graph.frames["frame"].nodes.len(), 2);
    hand.undo();
    assert_eq!(hand.look().graph.nodes["b"].position, place);
    // A node is dropped into the frame, and dragged out again.
    let half = node_center(&hand, "half");
    let inside = hand.app().canvas().node_rect("b").unwrap().center_top() + vec2(-20.0, 30.0);
    hand.drag(half, inside);
    assert_eq!(hand.look().graph.frames["frame"].nodes.len(), 3);
    let half = node_center(&hand, "half");
    hand.drag(half, half + vec2(60.0, 300.0));
    assert_eq!(hand.look().graph.frames["frame"].nodes.len(), 2);
    // The frame is selected by its title and deleted; its nodes stay.
    let title = hand.app().canvas().frame_title("frame").unwrap().center();
    hand.click(title);
    hand.key(Key::Delete);
    assert!(hand.look().graph.frames.is_empty());
    assert_eq!(hand.look().graph.nodes.len(), 5);
    undoes_to(&mut hand, &before);
}

#[test]
fn a_frame_gets_a_color_from_its_menu() {
    let mut hand = sums();
    select(&mut hand, &["a", "b"]);
    hand.key_with(CTRL, Key::J);
    hand.key(Key::Escape);
    let title = hand.app().canvas().frame_title("frame").unwrap().center();
    hand.right_click(title);
    let at = hand.harness.get_by_label("Color Teal").rect().center();
    hand.click(at);
    assert_eq!(hand.look().graph.frames["frame"].color.len(), 3);
}

#[test]
fn a_note_is_written_moved_and_removed() {
    let mut hand = sums();
    let nothing = hand.app().canvas().node_rect("b").unwrap().left_bottom() + vec2(10.0, 60.0);
    hand.hover(nothing);
    hand.key(Key::N);
    hand.type_text("Why half?");
    hand.key_with(CTRL, Key::Enter);
    assert_eq!(hand.look().graph.notes["note"].text, "Why half?");
    assert!(hand.harness.query_by_label("Note Why half?").is_some());
    let place = hand.look().graph.notes["note"].position;
    let at = hand.app().canvas().note_rect("note").unwrap().center();
    hand.drag(at, at + vec2(30.0, 40.0));
    assert_ne!(hand.look().graph.notes["note"].position, place);
    let rect = hand.app().canvas().note_rect("note").unwrap();
    hand.drag(rect.right_center() - vec2(2.0, 0.0), rect.right_center() + vec2(60.0, 0.0));
    assert!(hand.look().graph.notes["note"].width > 240.0, "{:?}", hand.look().graph.notes);
    let at = hand.app().canvas().note_rect("note").unwrap().center();
    hand.click(at);
    hand.key(Key::Delete);
    assert!(hand.look().graph.notes.is_empty());
}

#[test]
fn nodes_are_renamed_collapsed_and_muted() {
    let mut hand = sums();
    select(&mut hand, &["sum"]);
    hand.key(Key::F2);
    hand.type_text("Together");
    hand.key(Key::Enter);
    assert_eq!(hand.look().graph.nodes["sum"].name, "Together");
    let tall = hand.app().canvas().node_rect("sum").unwrap().height();
    hand.key(Key::H);
    assert!(hand.look().graph.nodes["sum"].collapsed);
    assert!(hand.app().canvas().node_rect("sum").unwrap().height() < tall * 0.5);
    hand.key(Key::M);
    assert!(hand.look().graph.nodes["sum"].muted);
    assert!(hand.harness.query_by_label_contains("Node Together, selected, muted").is_some());
    // A double click on the title begins renaming too; Escape leaves the name as it was.
    hand.double_click(node_center(&hand, "half"));
    hand.type_text("No");
    hand.key(Key::Escape);
    assert_eq!(hand.look().graph.nodes["half"].name, "");
}

#[test]
fn bookmarks_bring_a_view_back() {
    let mut hand = sums();
    let nothing = hand.empty_place();
    hand.hover(nothing);
    hand.app_mut().canvas_mut().set_zoom_and_center(1.5, pos2(260.0, 60.0));
    hand.key_with(CTRL, Key::Num3);
    assert_eq!(hand.look().graph.bookmarks.len(), 1);
    hand.key(Key::Home);
    assert_ne!(hand.app().canvas().zoom_and_center().0, 1.5);
    hand.key(Key::Num3);
    assert_eq!(hand.app().canvas().zoom_and_center(), (1.5, pos2(260.0, 60.0)));
}

#[test]
fn a_node_is_dropped_on_a_wire() {
    let mut hand = sums();
    hand.add("clamp_range", pos2(300.0, 340.0));
    let (from, to) = (hand.output("half", "product"), hand.input("output", "color"));
    let rect = hand.app().canvas().node_rect("clamp_range").unwrap();
    // The node is dropped with its middle on the wire's middle.
    let grab = node_center(&hand, "clamp_range");
    hand.drag(grab, from + (to - from) / 2.0 + (grab - rect.center()));
    assert_eq!(wire_into(&hand, "clamp_range", "value").unwrap(), "half.product");
    assert!(wire_into(&hand, "output", "color").unwrap().starts_with("clamp_range"));
    hand.undo();
    assert_eq!(wire_into(&hand, "output", "color").unwrap(), "half");
}

#[test]
fn a_node_is_swapped_in_place() {
    let mut hand = sums();
    select(&mut hand, &["half"]);
    hand.key(Key::S);
    hand.type_text("divide");
    hand.key(Key::Enter);
    let half = &hand.look().graph.nodes["half"];
    assert_eq!(half.kind, "divide");
    assert_eq!(half.values.get("b"), Some(&Value::Number(0.5)));
    assert_eq!(wire_into(&hand, "half", "a").unwrap(), "sum");
    assert_eq!(wire_into(&hand, "output", "color").unwrap(), "half");
    // Ports of the new kind have other names: the wire goes to the first port that takes it.
    hand.key(Key::S);
    hand.type_text("invert");
    hand.key(Key::Enter);
    assert_eq!(wire_into(&hand, "half", "value").unwrap(), "sum");
    assert!(hand.look().graph.nodes["half"].values.is_empty(), "it knows no b");
    hand.settle();
    assert!(errors(&hand).is_empty(), "{:?}", errors(&hand));
}

#[test]
fn a_reroute_is_put_into_a_wire_by_a_double_click() {
    let mut hand = sums();
    let (from, to) = (hand.output("half", "product"), hand.input("output", "color"));
    hand.double_click(from + (to - from) / 2.0);
    assert_eq!(hand.look().graph.nodes["reroute"].kind, "reroute");
    assert_eq!(wire_into(&hand, "reroute", "value").unwrap(), "half.product");
    assert!(wire_into(&hand, "output", "color").unwrap().starts_with("reroute"));
    hand.settle();
    assert!(errors(&hand).is_empty(), "{:?}", errors(&hand));
}

#[test]
fn wires_are_cut_with_a_stroke() {
    let mut hand = sums();
    let x = (hand.output("a", "value").x + hand.input("sum", "a").x) / 2.0;
    let (top, bottom) = (hand.output("a", "value").y - 60.0, hand.output("b", "value").y + 60.0);
    drag_with(&mut hand, PointerButton::Secondary, CTRL, &[pos2(x, top), pos2(x, bottom)]);
    assert_eq!((wire_into(&hand, "sum", "a"), wire_into(&hand, "sum", "b")), (None, None));
    assert!(wire_into(&hand, "half", "a").is_some());
    hand.undo();
    assert_eq!(hand.look().graph.wires.len(), 4);
}

#[test]
fn nodes_are_wired_by_key_and_by_coming_near() {
    let mut hand = sums();
    hand.add("clamp_range", pos2(300.0, 200.0));
    select(&mut hand, &["sum", "clamp_range"]);
    hand.key(Key::F);
    assert_eq!(wire_into(&hand, "clamp_range", "value").unwrap(), "sum.sum");
    hand.undo();
    assert_eq!(wire_into(&hand, "clamp_range", "value"), None);
    select(&mut hand, &["clamp_range"]);
    let grab = node_center(&hand, "clamp_range");
    let corner = hand.app().canvas().node_rect("clamp_range").unwrap().min;
    let b = hand.app().canvas().node_rect("b").unwrap();
    let to = grab + (b.left_bottom() + vec2(25.0, 15.0) - corner);
    drag_with(&mut hand, PointerButton::Primary, Modifiers::ALT, &[grab, to]);
    assert_eq!(wire_into(&hand, "clamp_range", "value").unwrap(), "b.value");
}

#[test]
fn a_lasso_selects_what_is_inside() {
    let mut hand = sums();
    let rect = |hand: &User, id: &str| hand.app().canvas().node_rect(id).unwrap();
    let (a, b) = (rect(&hand, "a"), rect(&hand, "b"));
    let path = [
        a.left_top() - vec2(20.0, 20.0),
        a.right_top() + vec2(16.0, -20.0),
        b.right_bottom() + vec2(16.0, 30.0),
        b.left_bottom() + vec2(-20.0, 30.0),
    ];
    drag_with(&mut hand, PointerButton::Primary, Modifiers::ALT, &path);
    assert_eq!(selected(&hand), ["a", "b"]);
}

#[test]
fn the_selection_grows_up_and_downstream() {
    let mut hand = sums();
    select(&mut hand, &["sum"]);
    hand.key(Key::OpenBracket);
    let mut found = selected(&hand);
    found.sort();
    assert_eq!(found, ["a", "b", "sum"]);
    select(&mut hand, &["sum"]);
    hand.key(Key::CloseBracket);
    assert_eq!(selected(&hand), ["sum", "half", "output"]);
    hand.key_with(CTRL, Key::I);
    assert_eq!(selected(&hand), ["a", "b"]);
    // Arrow keys go from node to node.
    select(&mut hand, &["a"]);
    hand.key_with(CTRL, Key::ArrowDown);
    assert_eq!(selected(&hand), ["b"]);
    hand.key_with(CTRL, Key::ArrowRight);
    assert_eq!(selected(&hand), ["sum"]);
}

#[test]
fn nodes_are_copied_as_text_and_pasted_into_another_window() {
    let mut hand = sums();
    let before = hand.look().to_text();
    select(&mut hand, &["sum", "half"]);
    hand.harness.event(Event::Copy);
    hand.harness.step();
    let text = hand.take_copied().unwrap_or_default();
    let part = Look::read(&text, "copied").value.expect("a look");
    assert_eq!((part.graph.nodes.len(), part.graph.wires.len()), (2, 1));

    let mut other = User::new();
    let nothing = other.empty_place();
    other.hover(nothing);
    other.harness.event(Event::Paste(text.clone()));
    other.harness.run_steps(3);
    assert_eq!(selected(&other), ["sum", "half"]);
    assert_eq!(wire_into(&other, "half", "a").unwrap(), "sum");

    // Pasted into their own look the nodes get new names; cutting removes them.
    let nothing = hand.empty_place();
    hand.hover(nothing);
    hand.harness.event(Event::Paste(text));
    hand.harness.run_steps(3);
    assert_eq!(selected(&hand), ["sum_2", "half_2"]);
    hand.harness.event(Event::Cut);
    hand.harness.run_steps(3);
    assert_eq!(hand.look().to_text(), before);
    hand.harness.event(Event::Paste("no look".to_owned()));
    hand.harness.run_steps(3);
    assert!(hand.harness.query_by_label_contains("the clipboard holds no nodes").is_some());
    undoes_to(&mut hand, &before);
}

#[test]
fn nodes_are_deleted_with_the_wires_kept_through() {
    let mut hand = sums();
    select(&mut hand, &["half"]);
    hand.key_with(Modifiers::SHIFT, Key::Delete);
    assert_eq!(wire_into(&hand, "output", "color").unwrap(), "sum");
}

#[test]
fn nodes_are_aligned_spaced_and_tidied_up() {
    let mut hand = sums();
    let place = |hand: &User, id: &str| hand.look().graph.nodes[id].position;
    select(&mut hand, &["a", "sum", "half"]);
    hand.key_with(Modifiers::SHIFT, Key::ArrowUp);
    assert_eq!(place(&hand, "sum")[1], 0.0);
    hand.undo();
    select(&mut hand, &["a", "b", "output"]);
    hand.key_with(Modifiers::SHIFT, Key::H);
    assert_ne!(place(&hand, "b")[0], 0.0);
    hand.undo();
    select(&mut hand, &[]);
    hand.key(Key::L);
    for (left, right) in [("a", "sum"), ("b", "sum"), ("sum", "half"), ("half", "output")] {
        assert!(place(&hand, left)[0] + 184.0 < place(&hand, right)[0]);
    }
    assert_ne!(place(&hand, "a")[1], place(&hand, "b")[1]);
    hand.undo();
    assert!(!hand.app().session().is_dirty());
}

/// Keys with several meanings do what they do at the place under the pointer: L tidies up over the
/// graph, and paints light over the picture.
#[test]
fn a_key_does_what_it_does_under_the_pointer() {
    let mut hand = sums();
    let nothing = hand.empty_place();
    hand.click(nothing);
    let before = hand.look().clone();
    hand.key(Key::L);
    hand.settle();
    assert!(!hand.app().fitting().is_on(), "no light is painted");
    assert_ne!(*hand.look(), before, "the nodes have moved");
    hand.undo();
    assert_eq!(*hand.look(), before);
    // Nodes that are selected are for the keys of the graph, and the picture is for its own.
    select(&mut hand, &["sum"]);
    let picture = hand.app().panel_place("Picture").expect("it is seen").center();
    hand.hover(picture);
    hand.key(Key::H);
    assert!(!hand.look().graph.nodes["sum"].collapsed);
    hand.hover(nothing);
    hand.key(Key::H);
    assert!(hand.look().graph.nodes["sum"].collapsed);
}

/// Tidying up far nodes, and pasting, leave what they did in view.
#[test]
fn what_is_tidied_or_pasted_is_in_view() {
    let mut hand = sums();
    let nothing = hand.empty_place();
    hand.hover(nothing);
    let in_view = |hand: &User, id: &str| {
        let graph = hand.app().panel_place("Graph").expect("it is seen");
        graph.contains_rect(hand.app().canvas().node_rect(id).expect("it is there"))
    };
    hand.app_mut().canvas_mut().set_zoom_and_center(1.0, pos2(5000.0, 5000.0));
    hand.settle();
    assert!(!in_view(&hand, "sum"));
    hand.key(Key::L);
    hand.settle();
    assert!(["sum", "half", "output"].iter().all(|id| in_view(&hand, id)));

    // A layer is pasted while the canvas shows none of the stack.
    let mut hand = User::new();
    hand.press("Layer Diffuse");
    hand.app_mut().canvas_mut().set_zoom_and_center(1.0, pos2(5000.0, 5000.0));
    hand.settle();
    let zoom = hand.app().canvas().zoom_and_center().0;
    let text = r#"{"nodes": [{"id": "pasted_rim", "kind": "light_layer", "at": [10, 10]}]}"#;
    hand.harness.event(Event::Paste(text.to_owned()));
    hand.settle();
    assert!(hand.look().graph.nodes.contains_key("pasted_rim"), "{:?}", hand.app().message());
    assert!(in_view(&hand, "pasted_rim"));
    assert_eq!(hand.app().canvas().zoom_and_center().0, zoom, "there is room for it");
}

#[test]
fn edges_snap_to_those_of_neighbors() {
    let mut hand = sums();
    let (zoom, _) = hand.app().canvas().zoom_and_center();
    let grab = node_center(&hand, "b");
    // Three points off its neighbor's edge the node snaps; with Ctrl it does not.
    hand.drag(grab, grab + vec2(3.0, 40.0));
    assert_eq!(hand.look().graph.nodes["b"].position[0], 0.0);
    let grab = node_center(&hand, "b");
    drag_with(&mut hand, PointerButton::Primary, Modifiers::NONE, &[grab, grab + vec2(0.0, -40.0)]);
    let grab = node_center(&hand, "b");
    drag_with(&mut hand, PointerButton::Primary, CTRL, &[grab, grab + vec2(8.0, 0.0)]);
    assert!((hand.look().graph.nodes["b"].position[0] - 8.0 / f64::from(zoom)).abs() < 2.0);
}

#[test]
fn what_adds_nothing_is_dimmed_and_told() {
    let mut hand = User::new();
    assert_eq!(hand.app().canvas().idle_word("diffuse"), None);
    hand.add("clamp_range", pos2(0.0, 300.0));
    assert_eq!(hand.app().canvas().idle_word("clamp_range"), Some("unused"));
    let set = |value| {
        let (graph, port) = (GraphId::Look, "opacity".into());
        Edit::SetValue {
            graph,
            id: "diffuse".into(),
            port,
            value: Value::Number(value),
            index: None,
        }
    };
    hand.app_mut().session_mut().apply(set(0.0), None).unwrap();
    for _ in 0..8 {
        hand.harness.run_steps(12);
        hand.settle();
    }
    assert_eq!(hand.app().canvas().idle_word("diffuse"), Some("no effect"));
    assert!(hand.harness.query_by_label_contains("Node Diffuse, no effect").is_some());
}

#[test]
fn a_problem_on_a_node_has_a_fix() {
    let mut hand = open(&json!({"nodes": [
        {"id": "base", "kind": "bass", "at": [0, 0]},
        {"id": "output", "kind": "output", "at": [300, 0]}
    ], "wires": [{"from": "base", "to": "output.color"}]}));
    assert!(hand.app().canvas().has_error("base"));
    let at = node_center(&hand, "base");
    hand.right_click(at);
    let at = hand.harness.get_by_label("Fix: Make it Base").rect().center();
    hand.click(at);
    hand.settle();
    assert_eq!(hand.look().graph.nodes["base"].kind, "base");
    assert!(errors(&hand).is_empty(), "{:?}", errors(&hand));
}

#[test]
fn a_problem_in_a_group_leads_into_it() {
    let mut hand =
        open(&json!({"definitions": {"g": {"outputs": [{"name": "value"}], "graph": {}, "nodes": [
        {"id": "bad", "kind": "nothing_such"}], "wires": [{"from": "bad", "to": "outputs.value"}]}},
        "nodes": [{"id": "group", "kind": "g"}, {"id": "output", "kind": "output", "at": [300, 0]}],
        "wires": [{"from": "group", "to": "output.color"}]}));
    assert!(hand.app().canvas().has_error("group"));
    let at = hand.harness.get_by_label("Open the list of problems").rect().center();
    hand.click(at);
    hand.settle();
    let is_link =
        |node: &egui_kittest::Node<'_>| node.accesskit_node().role() == accesskit::Role::Link;
    let at = {
        let mut found = hand.harness.get_all_by_label_contains(" / bad");
        found.find(is_link).expect("a link to the node").rect().center()
    };
    hand.click(at);
    hand.settle();
    assert_eq!(hand.app().session().selection().open_groups(), ["group".into()]);
    assert_eq!(selected(&hand), ["bad"]);
    assert!(hand.app().canvas().has_error("bad"));
}

#[test]
fn the_sheet_lists_keys_and_the_palette_runs_commands() {
    let mut hand = sums();
    hand.key_with(Modifiers::SHIFT, Key::Questionmark);
    assert!(hand.harness.query_by_label("Make a group").is_some());
    hand.key(Key::Escape);
    assert!(hand.harness.query_by_label("Make a group").is_none());
    select(&mut hand, &["sum", "half"]);
    hand.key_with(CTRL, Key::P);
    hand.type_text("make a gr");
    hand.key(Key::Enter);
    hand.harness.run_steps(3);
    assert!(hand.look().graph.nodes.contains_key("group"));
    hand.key_with(CTRL, Key::P);
    let at = hand.harness.get_by_label("Command: Undo").rect().center();
    hand.click(at);
    hand.harness.run_steps(3);
    assert!(
        !hand.look().graph.nodes.contains_key("group"),
        "{:?}",
        hand.app().session().steps().undo_label()
    );
}

#[test]
fn the_menu_of_a_node_says_what_can_be_done() {
    let mut hand = sums();
    let at = node_center(&hand, "sum");
    hand.right_click(at);
    assert_eq!(selected(&hand), ["sum"]);
    let at =
        hand.harness.get_by_role_and_label(accesskit::Role::Button, "Make a group").rect().center();
    hand.click(at);
    assert!(hand.look().graph.nodes.contains_key("group"));
}

#[test]
fn the_map_shows_where_one_is_and_leads_elsewhere() {
    let mut hand = sums();
    assert!(hand.harness.query_by_label("Map of the graph").is_none(), "everything is in view");
    hand.app_mut().canvas_mut().set_zoom_and_center(2.0, pos2(0.0, 0.0));
    hand.settle();
    let map = hand.harness.get_by_label("Map of the graph").rect();
    hand.drag(map.center(), map.center() + vec2(30.0, 0.0));
    assert!(hand.app().canvas().zoom_and_center().1.x > 100.0);
    hand.key_with(Modifiers::SHIFT, Key::M);
    assert!(hand.harness.query_by_label("Map of the graph").is_none());
}

/// Edits of a script inside an open group are seen on the canvas at once.
#[test]
fn a_script_may_edit_inside_a_group() {
    let mut hand = sums();
    select(&mut hand, &["sum"]);
    hand.key_with(CTRL, Key::G);
    hand.key_with(CTRL, Key::Enter);
    let graph = hand.app().session().selection().graph_id().clone();
    let node = Node { kind: "clamp_range".to_owned(), position: [260.0, 300.0], ..Node::default() };
    let add = Edit::AddNode { graph, id: "clamp_range".into(), node, index: None };
    hand.app_mut().session_mut().apply(add, None).unwrap();
    hand.settle();
    hand.drag(hand.output("sum", "sum"), hand.input("clamp_range", "value"));
    assert_eq!(
        wire_into(&hand, "clamp_range", "value"),
        Some(Endpoint::new("sum", "sum").to_string())
    );
}

/// Nodes show their results: 1 - 0.25 and 1 - 0.5 are 0.75 and 0.5; their sum and its half are
/// worked out by hand.
#[test]
fn nodes_tell_what_they_give() {
    let mut hand = sums();
    hand.app_mut().canvas_mut().set_zoom_and_center(0.6, pos2(420.0, 120.0));
    for _ in 0..8 {
        hand.harness.run_steps(6);
        hand.settle();
    }
    let value =
        |id: &str| hand.app().canvas().value_text(hand.app().session(), id).map(str::to_owned);
    assert_eq!(value("a").as_deref(), Some("0.75"));
    assert_eq!(value("sum").as_deref(), Some("1.25"));
    assert_eq!(value("half").as_deref(), Some("0.625"));
    let mut hand = User::new();
    for _ in 0..8 {
        hand.harness.run_steps(6);
        hand.settle();
    }
    assert!(hand.app().canvas().has_ball(hand.app().session(), "diffuse"));
}

/// A key shows what each node costs in the tier that it has, and in the others.
#[test]
fn costs_of_nodes_are_shown_on_request() {
    let mut hand = open(&json!({"nodes": [
        {"id": "facing", "kind": "facing", "at": [0, 0]},
        {"id": "power", "kind": "power", "at": [260, 0], "values": {"exponent": 3.3}},
        {"id": "output", "kind": "output", "at": [520, 0]}
    ], "wires": [
        {"from": "facing", "to": "power.base"}, {"from": "power", "to": "output.color"}
    ]}));
    assert_eq!(hand.app().canvas().cost_text("power"), None);
    hand.hover(hand.app().canvas().node_rect("output").unwrap().center_bottom() + vec2(0.0, 60.0));
    hand.key_with(Modifiers::SHIFT, Key::C);
    hand.settle();
    let text = hand.app().canvas().cost_text("power").expect("it runs at each fragment");
    let (own, exact) = text.split_once(" ops").expect("it is counted first");
    let (own, exact): (u64, u64) = (
        own.parse().unwrap(),
        exact.split_once("exact ").expect("exact costs more").1.parse().unwrap(),
    );
    assert!(own < exact && own > 0, "{text}");
    // An edit is counted anew.
    let (graph, id, port) = (GraphId::Look, "power".into(), "exponent".into());
    let set = Edit::SetValue { graph, id, port, value: Value::Number(2.0), index: None };
    hand.app_mut().session_mut().apply(set, None).unwrap();
    hand.settle();
    assert_ne!(hand.app().canvas().cost_text("power"), Some(text));
}

#[test]
fn a_group_runs_for_each_light_of_a_set_that_is_typed() {
    let mut hand = open(&json!({
        "lights": {"key": {"groups": ["set"]}, "fill": {"direction": [-1, 0, 1]}},
        "definitions": {"lamps": {"label": "Lamps", "outputs": [{"name": "color"}],
            "nodes": [{"id": "of", "kind": "light_details"},
                {"id": "sum", "kind": "sum_of_lights"}],
            "wires": [{"from": "of.color", "to": "sum.value"},
                {"from": "sum", "to": "outputs.color"}]}},
        "nodes": [{"id": "lamps", "kind": "lamps"},
            {"id": "output", "kind": "output", "at": [300, 0]}],
        "wires": [{"from": "lamps", "to": "output.color"}]}));
    let set = |hand: &User| {
        let set = hand.look().graph.nodes["lamps"].for_each.clone();
        set.map(|set| set.text().to_owned())
    };
    select(&mut hand, &["lamps"]);
    set_text(&mut hand, "For each light", "group:set");
    assert_eq!(set(&hand).as_deref(), Some("group:set"));
    assert!(errors(&hand).is_empty(), "{:?}", errors(&hand));
    assert!(hand.harness.query_by_label_contains("each of group:set").is_some());
    hand.type_text(" |");
    hand.settle();
    assert_eq!(set(&hand).as_deref(), Some("group:set"), "what is no set waits");
    set_text(&mut hand, "For each light", "");
    assert_eq!(set(&hand), None);
    hand.key(Key::Enter);
    hand.settle();
    hand.undo();
    assert_eq!(set(&hand).as_deref(), Some("group:set"));
}

#[test]
fn lights_that_reach_a_layer_and_pass_by_a_filter_are_typed() {
    let mut hand = open(&json!({
        "lights": {"key": {"groups": ["set"]}, "rim": {"direction": [-1, 0, -1]}},
        "nodes": [{"id": "skin", "kind": "light_layer", "values": {"light": "rim"}},
            {"id": "lamp", "kind": "light", "at": [0, 300]},
            {"id": "glass", "kind": "light_filter", "at": [200, 300]},
            {"id": "inside", "kind": "light_in_set", "at": [0, 600]},
            {"id": "output", "kind": "output", "at": [300, 0]}],
        "wires": [{"from": "skin", "to": "output.color"}, {"from": "lamp", "to": "glass.light"}]}));
    let set = |hand: &mut User, node: &str, field: &str, text: &str| {
        select(hand, &[node]);
        hand.bring(accesskit::Role::TextInput, field);
        set_text(hand, field, text);
        hand.key(Key::Enter);
        hand.settle();
    };
    set(&mut hand, "skin", "Reached by", "* - group:set");
    set(&mut hand, "skin", "Not reached by", "rim");
    set(&mut hand, "glass", "Filters lights", "key");
    set(&mut hand, "inside", "Lights", "group:set");
    let links = |hand: &User, node: &str| hand.look().graph.nodes[node].links.clone();
    let skin = links(&hand, "skin");
    assert_eq!((skin.layered.text(), skin.unlayered.text()), ("* - group:set", "rim"));
    assert_eq!(links(&hand, "glass").filtered.text(), "key");
    let value = hand.look().graph.nodes["inside"].values.get("lights").cloned();
    assert_eq!(value, Some(Value::Text("group:set".to_owned())));
    for _ in 0..4 {
        hand.undo();
    }
    assert!(links(&hand, "skin").is_all() && links(&hand, "glass").is_all());
}
