//! Layers, lights, problems, history and the library, driven by pointer and keys through the names
//! that everybody sees.

use crate::editor_support::{User, node_center};
use chiaro::document::{Endpoint, Look, Value};
use eframe::egui::{Key, Modifiers, Pos2, Role, accesskit::Toggled, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};

/// Names of the listed layers, from the top.
fn rows(hand: &User) -> Vec<String> {
    let found = hand.harness.get_all_by_role(Role::ListItem);
    let mut rows: Vec<(f32, String)> = found
        .map(|node| (node.rect().top(), node.accesskit_node().label().unwrap_or_default()))
        .collect();
    rows.sort_by(|a, b| a.0.total_cmp(&b.0));
    rows.into_iter().map(|(_, name)| name).collect()
}

/// The chain of layers in the graph itself, from the Output downward, which the panel must agree
/// with.
fn chain(look: &Look) -> Vec<String> {
    let mut at = Endpoint::new("output", "color");
    let mut found = Vec::new();
    while let Some(wire) = look.graph.wires.iter().find(|wire| wire.to == at) {
        found.push(wire.from.node.to_string());
        at = Endpoint { node: wire.from.node.clone(), port: "below".into() };
    }
    found
}

fn figure1() -> User {
    let mut hand = User::new();
    hand.app_mut().open(std::path::Path::new("examples/looks/figure1-layers.json"));
    hand.settle();
    hand
}

fn open(hand: &mut User, text: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("look.json");
    std::fs::write(&path, text).unwrap();
    hand.app_mut().open(&path);
    hand.settle();
    folder
}

#[test]
fn the_stack_and_the_graph_are_one_selection() {
    let mut hand = figure1();
    assert_eq!(
        rows(&hand),
        ["Layer Back-light", "Layer Specular", "Layer Diffuse", "Layer Fill", "Base Base"]
    );
    hand.press("Layer Specular");
    assert_eq!(hand.selected(), ["specular"]);
    let at = node_center(&hand, "fill");
    hand.click(at);
    hand.settle();
    assert_eq!(hand.selected(), ["fill"]);
    let row = hand.harness.get_by_label("Layer Fill");
    assert_eq!(
        row.accesskit_node().toggled(),
        Some(Toggled::True),
        "the row shows what the canvas selected"
    );
}

#[test]
fn a_row_that_is_dragged_rewires_the_graph_as_one_step() {
    let mut hand = figure1();
    let before = hand.look().clone();
    let grip = |hand: &User, label: &str| hand.place(label).left_top() + vec2(60.0, 26.0);
    let (from, to) = (grip(&hand, "Layer Back-light"), grip(&hand, "Layer Diffuse"));
    hand.drag(from, to + vec2(0.0, 20.0));
    hand.settle();
    assert_eq!(chain(hand.look()), ["specular", "diffuse", "back", "fill", "base"]);
    assert_eq!(rows(&hand)[2], "Layer Back-light");
    let x = |hand: &User, id: &str| hand.look().graph.nodes[id].position[0];
    assert!(
        x(&hand, "fill") < x(&hand, "back") && x(&hand, "back") < x(&hand, "diffuse"),
        "tidy on the canvas"
    );
    hand.undo();
    hand.settle();
    assert_eq!(*hand.look(), before);
    // The keyboard moves layers too.
    hand.press("Layer Back-light");
    hand.key_with(Modifiers::ALT, Key::ArrowDown);
    hand.settle();
    assert_eq!(chain(hand.look()), ["specular", "back", "diffuse", "fill", "base"]);
    hand.key(Key::ArrowUp);
    hand.settle();
    assert_eq!(hand.selected(), ["specular"], "the row above");
    hand.key_with(Modifiers::COMMAND, Key::Z);
    hand.settle();
    assert_eq!(*hand.look(), before);
    // Keys of the picture work when the pointer is there, though a row had the keyboard.
    let picture = hand.app().viewport().rect().unwrap().center();
    hand.hover(picture);
    hand.key(Key::I);
    assert!(hand.app().probe().is_on());
}

#[test]
fn a_drag_that_is_given_up_changes_nothing() {
    let mut hand = figure1();
    let before = hand.look().clone();
    let from = hand.place("Layer Back-light").left_top() + vec2(60.0, 26.0);
    hand.drag(from, from + vec2(0.0, 12.0));
    hand.settle();
    assert_eq!(*hand.look(), before, "too short a way");
    assert!(!hand.app().session().is_dirty());
}

#[test]
fn a_layer_is_added_over_the_selected_one_with_the_light_it_needs() {
    let mut hand = User::new();
    let before = hand.look().clone();
    hand.press("Layer Diffuse");
    hand.press("Add layer");
    hand.press("Add Back-light");
    assert_eq!(
        chain(hand.look()),
        ["back-light", "diffuse", "base"].map(|id| id.replace('-', "_"))
    );
    assert_eq!(hand.selected(), ["back_light"]);
    let look = hand.look();
    assert_eq!(look.graph.nodes["back_light"].values["light"], Value::Text("back".into()));
    assert!(look.lights["back"].direction[2] < 0.0, "it shines from behind");
    assert!(
        hand.app().session().compilation().problems().is_empty(),
        "{:?}",
        hand.app().session().compilation().problems()
    );
    hand.undo();
    hand.settle();
    assert_eq!(*hand.look(), before, "one step");
    // Every preset compiles unchanged.
    for preset in ["Fill", "Diffuse", "Cartoon", "Shadow", "Highlight"] {
        hand.press("Add layer");
        hand.press(&format!("Add {preset}"));
        assert!(
            rows(&hand).iter().any(|row| row.starts_with(&format!("Layer {preset}"))),
            "it is called as it was chosen"
        );
    }
    assert!(
        hand.app().session().compilation().problems().is_empty(),
        "{:?}",
        hand.app().session().compilation().problems()
    );
    assert_eq!(chain(hand.look()).len(), 7);
}

#[test]
fn an_eye_mutes_a_layer_of_the_look_and_undo_takes_it_back() {
    let mut hand = figure1();
    hand.press("Show Specular");
    assert!(hand.look().graph.nodes["specular"].muted);
    assert!(hand.app().session().is_dirty(), "it is saved with the look");
    hand.undo();
    hand.settle();
    assert!(!hand.look().graph.nodes["specular"].muted);
}

#[test]
fn solo_is_of_the_window_and_nobody_can_forget_it() {
    let mut hand = figure1();
    let full = hand.app().session().compilation().baked().unwrap().wgsl.clone();
    hand.press("Solo Specular");
    assert!(!hand.app().session().is_dirty(), "the document is as it was");
    assert!(hand.says("Solo: Specular"));
    let alone = hand.app().session().compilation().baked().unwrap().wgsl.clone();
    assert!(full.contains("diffuse") && !alone.contains("diffuse") && alone.contains("specular"));
    // An edit during the solo is shown alone, too.
    hand.press("Show Fill");
    assert!(!hand.app().session().compilation().baked().unwrap().wgsl.contains("diffuse"));
    hand.undo();
    hand.settle();
    // Another layer takes the solo over; Ctrl adds a layer to it.
    hand.press("Solo Diffuse");
    assert!(hand.says("Solo: Diffuse ·") && !hand.says("Solo: Specular"));
    let at = hand.place("Solo Specular").center();
    hand.click_with(Modifiers::COMMAND, at);
    hand.settle();
    assert!(hand.says("Solo: Diffuse, Specular"));
    hand.press("Show all");
    assert!(!hand.says("Solo: "));
    assert_eq!(hand.app().session().compilation().baked().unwrap().wgsl, full);
}

#[test]
fn a_layer_is_renamed_duplicated_and_deleted_in_the_list() {
    let mut hand = figure1();
    let before = hand.look().clone();
    let name = hand
        .harness
        .get_all_by_role_and_label(Role::Label, "Specular")
        .next()
        .unwrap()
        .rect()
        .center();
    hand.double_click(name);
    hand.settle();
    hand.type_text("Shine");
    hand.key(Key::Enter);
    hand.settle();
    assert_eq!(hand.look().graph.nodes["specular"].name, "Shine");
    hand.press("Layer Shine");
    hand.key_with(Modifiers::COMMAND, Key::D);
    hand.settle();
    assert_eq!(chain(hand.look()), ["back", "specular_2", "specular", "diffuse", "fill", "base"]);
    hand.press("Layer Diffuse");
    hand.key(Key::Delete);
    hand.settle();
    assert_eq!(chain(hand.look()), ["back", "specular_2", "specular", "fill", "base"]);
    assert!(hand.app().session().compilation().problems().is_empty());
    // A layer is deleted from the menu of its row.
    hand.press("More of Fill");
    hand.press("Delete layer");
    assert_eq!(chain(hand.look()), ["back", "specular_2", "specular", "base"]);
    for _ in 0..4 {
        hand.undo();
    }
    hand.settle();
    assert_eq!(*hand.look(), before);
}

#[test]
fn blending_and_opacity_are_set_in_the_row() {
    let mut hand = figure1();
    let slider = hand
        .harness
        .get_all_by_role_and_label(Role::Slider, "Opacity of Diffuse")
        .next()
        .expect("a slider")
        .rect();
    hand.drag(slider.right_center() - vec2(5.0, 0.0), slider.center());
    hand.settle();
    let Some(Value::Number(opacity)) = hand.look().graph.nodes["diffuse"].values.get("opacity")
    else {
        panic!("{:?}", hand.look().graph.nodes["diffuse"].values)
    };
    assert!((0.4..0.6).contains(opacity), "{opacity}");
    assert_eq!(hand.app().session().steps().labels().count(), 1, "one gesture");
    hand.press("Blending of Diffuse");
    hand.press("Alpha");
    assert_eq!(hand.look().graph.nodes["diffuse"].values["blend"], Value::Text("alpha".into()));
    hand.undo();
    hand.undo();
    hand.settle();
    assert!(!hand.look().graph.nodes["diffuse"].values.contains_key("opacity"));
}

/// Two direction keys over an opacity and an intensity, of which the second is far away.
const KEYED: &str = r#"{"lights": {"key": {"direction": [0, 0, 1]}},
    "nodes": [{"id": "base", "kind": "base"},
    {"id": "diffuse", "kind": "light_layer", "name": "Diffuse", "values": {"light": "key"}},
        {"id": "output", "kind": "output"}],
    "wires": [{"from": "base", "to": "diffuse.below"}, {"from": "diffuse", "to": "output.color"}],
    "direction_keys": [{"by": {"light": "key"}, "keys": [
        {"direction": [0, 0, 1], "values": {"diffuse.opacity": 0.5, "lights.key.intensity": 0.5}},
        {"direction": [0, 0, -1], "values": {"diffuse.opacity": 0.1,
        "lights.key.intensity": 2}}]}]}"#;

#[test]
fn rows_set_keyed_values_at_their_key() {
    let mut hand = User::new();
    let _folder = open(&mut hand, KEYED);
    let own = (hand.look().graph.clone(), hand.look().lights.clone());
    let at_key = |hand: &User, key: usize, target: &str| {
        let target = chiaro::document::Target::parse(target).unwrap();
        match &hand.look().direction_keys[0].keys[key].values[&target] {
            Value::Number(number) => *number,
            other => panic!("{other:?}"),
        }
    };
    let slider = hand.harness.get_all_by_role_and_label(Role::Slider, "Opacity of Diffuse").next();
    let slider = slider.expect("a slider").rect();
    hand.drag(slider.center(), slider.right_center() - vec2(5.0, 0.0));
    hand.settle();
    let opacity = at_key(&hand, 0, "diffuse.opacity");
    assert!(opacity > 0.9, "{opacity}");
    hand.tab("Lights");
    let drag = hand.place("Intensity of key").center();
    hand.drag(drag, drag + vec2(30.0, 0.0));
    hand.settle();
    let intensity = at_key(&hand, 0, "lights.key.intensity");
    assert!(
        (0.6..1.2).contains(&intensity),
        "from the key's 0.5, not from the light's 1: {intensity}"
    );
    assert_eq!(
        (at_key(&hand, 1, "diffuse.opacity"), at_key(&hand, 1, "lights.key.intensity")),
        (0.1, 2.0)
    );
    assert_eq!(
        (hand.look().graph.clone(), hand.look().lights.clone()),
        own,
        "what is said without keys stays"
    );
    assert_eq!(hand.app().session().steps().labels().count(), 2, "one step a gesture");
}

#[test]
fn what_is_no_stack_is_a_branch() {
    let mut hand = User::new();
    let _folder = open(
        &mut hand,
        r#"{"nodes": [{"id": "mix", "kind": "mix_colors"},
            {"id": "output", "kind": "output", "at": [300, 0]}],
            "wires": [{"from": "mix", "to": "output.color"}]}"#,
    );
    assert_eq!(rows(&hand), ["Branch Mix colors"]);
    hand.press("Branch Mix colors");
    assert_eq!(hand.selected(), ["mix"]);
}

#[test]
fn lights_are_muted_in_the_window_and_edited_in_the_look() {
    let mut hand = figure1();
    hand.tab("Lights");
    let drag = hand.place("Intensity of key").center();
    hand.drag(drag, drag + vec2(30.0, 0.0));
    hand.settle();
    assert!(hand.look().lights["key"].intensity > 1.1, "{}", hand.look().lights["key"].intensity);
    assert_eq!(hand.app().session().steps().labels().count(), 1, "one gesture");
    hand.undo();
    hand.settle();
    // The swatch of the row opens the color's picker.
    let own = hand.look().lights["key"].color;
    hand.press_a(Role::ColorWell, "Color of key");
    let square = hand.place_like("Saturation and brightness");
    hand.drag(square.center(), square.right_top() + vec2(-20.0, 20.0));
    hand.key(Key::Escape);
    hand.settle();
    assert_ne!(hand.look().lights["key"].color, own);
    assert_eq!(hand.app().session().steps().undo_label(), Some("Color of key"));
    hand.undo();
    hand.settle();
    hand.press("Light key shines");
    assert!(
        !hand.app().session().view().shines("key") && hand.app().session().view().shines("back")
    );
    assert!(!hand.app().session().is_dirty() && hand.says("Muted: light key"));
    hand.press("Show all");
    hand.press("Solo back");
    assert!(
        !hand.app().session().view().shines("key") && hand.app().session().view().shines("back")
    );
    hand.press("Solo back");
    assert!(hand.app().session().view().shines("key"));
    let before = hand.look().clone();
    hand.press("More of key");
    hand.press("Duplicate light");
    assert_eq!(
        hand.look().lights.keys().map(ToString::to_string).collect::<Vec<_>>(),
        ["key", "key_2", "back"]
    );
    assert!(hand.has("unused"), "nothing names it yet");
    hand.press("More of key_2");
    hand.press("Rename light");
    hand.type_text("Window");
    hand.key(Key::Enter);
    hand.settle();
    assert_eq!(hand.look().lights["key_2"].name, "Window");
    hand.press("More of Window");
    hand.press("Remove light");
    assert_eq!(*hand.look(), before);
    hand.press("Add light");
    hand.press("Spot");
    assert_eq!(hand.look().lights.len(), 3);
    assert_eq!(hand.app().session().steps().labels().count(), 4);
}

/// A look with problems of many kinds.
const BROKEN: &str = r##"{"lights": {"key": {"direction": [-0.5, 0.7, 0.6]}}, "nodes": [
    {"id": "base", "kind": "base", "values": {"colour": [0.2, 0.2, 0.3]}},
    {"id": "diffuse", "kind": "light_layer", "at": [260, 0], "values": {"light": "kay",
    "opacity": 1.8, "blend": "ad"}},
    {"id": "rim", "kind": "ligth_layer", "at": [520, 0]},
    {"id": "tone", "kind": "profile", "at": [300, 300]},
    {"id": "output", "kind": "output", "at": [780, 0]}
  ], "wires": [{"from": "base", "to": "diffuse.below"},
  {"from": "diffuse.stack", "to": "rim.below"},
    {"from": "rim", "to": "output.color"}, {"from": "tone", "to": "rim.opacity"}]}"##;

#[test]
fn every_problem_that_has_a_fix_is_mended_by_a_click() {
    let mut hand = User::new();
    let _folder = open(&mut hand, BROKEN);
    hand.press("Open the list of problems");
    let before = hand.look().clone();
    let fixes = ["Use ", "Make it ", "Wire ", "Add ", "Set ", "Remove "];
    let skipped = ["Add layer", "Wire of"];
    for round in 0.. {
        let problems = hand.app().session().compilation().problems().to_vec();
        if problems.is_empty() {
            break;
        }
        assert!(round < 12, "{problems:?}");
        let buttons = hand.harness.get_all_by_role(Role::Button);
        let names: Vec<(String, Pos2)> = buttons
            .filter_map(|node| Some((node.accesskit_node().label()?, node.rect().center())))
            .collect();
        let is_fix = |name: &str| {
            fixes.iter().any(|fix| name.starts_with(fix))
                && !skipped.iter().any(|other| name.starts_with(other))
        };
        let (_, at) = names
            .iter()
            .find(|(name, at)| is_fix(name) && at.x < 700.0)
            .unwrap_or_else(|| panic!("{problems:?} {names:?}"));
        hand.click(*at);
        hand.settle();
    }
    let look = hand.look();
    assert_eq!(chain(look), ["rim", "diffuse", "base"]);
    let nodes = &look.graph.nodes;
    assert_eq!(nodes["rim"].kind, "light_layer");
    assert_eq!(nodes["diffuse"].values["opacity"], Value::Number(1.0));
    assert_eq!(nodes["diffuse"].values["light"], Value::Text("key".into()));
    assert_eq!(nodes["diffuse"].values["blend"], Value::Text("add".into()));
    assert_eq!(nodes["base"].values["color"], Value::Vector(vec![0.2, 0.2, 0.3]));
    assert!(hand.says("No problems") && !hand.has("Open the list of problems"));
    let steps = hand.app().session().steps().labels().count();
    for _ in 0..steps {
        hand.undo();
    }
    hand.settle();
    assert_eq!(*hand.look(), before, "all of it is undone");
}

#[test]
fn the_history_is_a_list_that_leads_back_and_forth() {
    let mut hand = figure1();
    let before = hand.look().clone();
    hand.press("Show Specular");
    hand.press("Show Fill");
    hand.press("Layer Diffuse");
    hand.key(Key::Delete);
    hand.settle();
    let last = hand.look().clone();
    hand.tab("History");
    assert_eq!(
        rows(&hand),
        ["Step 0: Opened", "Step 1: mute specular", "Step 2: mute fill", "Step 3: remove diffuse"]
    );
    hand.press("Step 1: mute specular");
    let look = hand.look();
    assert!(
        look.graph.nodes["specular"].muted
            && !look.graph.nodes["fill"].muted
            && look.graph.nodes.len() == 6
    );
    assert_eq!(rows(&hand).len(), 4, "what was taken back is still listed");
    hand.press("Step 0: Opened");
    assert_eq!(*hand.look(), before);
    assert!(!hand.app().session().is_dirty());
    hand.press("Step 3: remove diffuse");
    assert_eq!(*hand.look(), last);
    hand.key(Key::ArrowUp);
    hand.settle();
    assert_eq!(hand.app().session().steps().done(), 2);
}

#[test]
fn nodes_come_from_the_library_by_a_click_or_a_drag() {
    let mut hand = User::new();
    hand.tab("Library");
    let search = hand.place("Search nodes").center();
    hand.click(search);
    hand.type_text("profile");
    hand.settle();
    hand.press("Library node Profile");
    assert!(hand.look().graph.nodes.contains_key("profile"));
    assert_eq!(hand.selected(), ["profile"]);
    let (from, to) = (hand.place("Library node Profile").center(), hand.empty_place());
    hand.drag(from, to);
    hand.settle();
    let place = hand.app().canvas().node_rect("profile_2").expect("the dragged one").min;
    assert!(place.distance(to) < 2.0, "{place} {to}");
    hand.undo();
    hand.undo();
    hand.settle();
    assert_eq!(hand.look().graph.nodes.len(), 3);
    assert!(hand.harness.query_by_label("Library node Base").is_none(), "the search goes on");
}

#[test]
fn a_look_of_the_library_opens_as_a_new_one() {
    let mut hand = User::new();
    hand.tab("Library");
    hand.press("Looks");
    let name = hand
        .harness
        .get_all_by_label_contains("Open the look")
        .next()
        .and_then(|node| node.accesskit_node().label())
        .expect("one");
    hand.press(&name);
    assert_eq!(Some(hand.look().name.as_str()), name.strip_prefix("Open the look "));
    assert!(hand.app().session().path().is_none() && !hand.app().session().is_dirty());
}

#[test]
fn small_pictures_are_drawn_at_rest_and_kept_by_what_they_show() {
    let mut hand = User::drawing_with(|app, _| app);
    hand.app_mut().open(std::path::Path::new("examples/looks/figure1-layers.json"));
    let rest = |hand: &mut User| {
        hand.settle();
        hand.settle();
        assert!(
            hand.repaint_delay() > std::time::Duration::from_secs(60),
            "at rest nothing is drawn"
        );
        hand.app().small_pictures()
    };
    let first = rest(&mut hand);
    assert!(first >= 5, "four layers and the base: {first}");
    // Another name, place or order needs no new small picture; another color needs one.
    hand.press("Layer Specular");
    hand.key_with(Modifiers::ALT, Key::ArrowDown);
    assert_eq!(rest(&mut hand), first);
    let graph = chiaro::document::GraphId::Look;
    let value = Value::Vector(vec![0.1, 0.9, 0.3]);
    let edit = chiaro::document::Edit::SetValue {
        graph,
        id: "fill".into(),
        port: "convex".into(),
        value,
        index: None,
    };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    assert_eq!(rest(&mut hand), first + 1);
    hand.undo();
    assert_eq!(rest(&mut hand), first + 1, "the old one is still there");
}

/// A window that begins with the start page does not ask for the picture behind it, and its small
/// pictures do not wait for that picture.
#[test]
fn a_window_that_begins_with_the_start_page_draws_its_pictures() {
    let mut hand = User::drawing_at(vec2(800.0, 600.0), |mut app, _| {
        app.show_start_page();
        app
    });
    for _ in 0..20 {
        hand.settle();
    }
    let drawn = hand.app().small_pictures();
    assert!(drawn >= 3, "{drawn} pictures are drawn");
}

#[test]
fn what_was_opened_before_is_among_the_looks() {
    let mut hand = figure1();
    hand.tab("Library");
    hand.press("Looks");
    let search = hand.place("Search looks").center();
    hand.click(search);
    hand.type_text("layers figure");
    hand.settle();
    hand.press_far("Open the look Layers · Figure 1");
    assert!(hand.app().session().path().is_none(), "the example");
    hand.press_far("Open the look figure1-layers");
    assert!(
        hand.app().session().path().is_some_and(|path| path.ends_with("figure1-layers.json")),
        "the file"
    );
}

#[test]
fn a_layer_is_masked_clipped_and_freed_in_its_menu() {
    let mut hand = figure1();
    let before = hand.look().clone();
    let opacity =
        |hand: &User| hand.look().graph.wire_into(&"specular".into(), &"opacity".into()).cloned();

    // Clipped to the layer below: its tone is the mask, which is selected.
    hand.press("More of Specular");
    hand.press("Clip to the layer below");
    hand.settle();
    let wire = opacity(&hand).expect("a mask");
    assert_eq!(hand.selected(), [wire.from.node.as_str()]);
    let into = hand.look().graph.wire_into(&wire.from.node, &"mask".into()).cloned();
    assert_eq!(into.expect("its source").from, Endpoint::new("diffuse", "tone"));
    assert_eq!(rows(&hand).len(), 5, "a mask is no layer");

    // The row's opacity is the mask's now.
    let slider = hand
        .harness
        .get_all_by_role_and_label(Role::Slider, "Opacity of Specular")
        .next()
        .expect("a slider")
        .rect();
    hand.drag(slider.right_center() - vec2(5.0, 0.0), slider.center());
    hand.settle();
    let mask = &hand.look().graph.nodes[&wire.from.node];
    assert!(matches!(mask.values.get("opacity"), Some(Value::Number(x)) if *x < 0.7), "{mask:?}");

    hand.press("More of Specular");
    hand.press("Invert mask");
    hand.settle();
    let mask = &hand.look().graph.nodes[&wire.from.node];
    assert_eq!(mask.values.get("inverted"), Some(&Value::Bool(true)));

    hand.press("More of Specular");
    hand.press("Unclip");
    hand.settle();
    assert!(opacity(&hand).is_none());
    for _ in 0..4 {
        hand.undo();
    }
    hand.settle();
    assert_eq!(*hand.look(), before);
}

#[test]
fn layers_are_put_into_a_folder_treated_as_one_and_taken_out_again() {
    let mut hand = figure1();
    let before = hand.look().clone();
    let wgsl = |hand: &User| hand.app().session().compilation().baked().unwrap().wgsl.clone();
    let plain = wgsl(&hand);
    let muted = |hand: &User, id: &str| hand.look().graph.nodes[id].muted;
    let row = |hand: &User, label: &str| hand.place(label).left_top() + vec2(60.0, 26.0);

    // Several at once are hidden by one eye and as one step.
    hand.press("Layer Specular");
    let at = row(&hand, "Layer Fill");
    hand.click_with(Modifiers::SHIFT, at);
    hand.settle();
    assert_eq!(hand.selected(), ["fill", "diffuse", "specular"]);
    hand.press("Show Diffuse");
    assert!(["specular", "diffuse", "fill"].iter().all(|id| muted(&hand, id)));
    hand.undo();
    hand.settle();
    assert_eq!(*hand.look(), before);
    let at = row(&hand, "Layer Fill");
    hand.click_with(Modifiers::COMMAND, at);
    hand.settle();
    assert_eq!(hand.selected(), ["diffuse", "specular"]);

    // A folder of two leaves the picture as it is.
    hand.click_with(Modifiers::COMMAND, row(&hand, "Layer Diffuse"));
    hand.click_with(Modifiers::COMMAND, row(&hand, "Layer Diffuse"));
    hand.settle();
    hand.key_with(Modifiers::COMMAND, Key::G);
    hand.settle();
    let listed = ["Layer Back-light", "Layer Folder", "Layer Specular", "Layer Diffuse"];
    assert_eq!(rows(&hand)[..4], listed);
    assert_eq!(chain(hand.look()), ["back", "folder", "fill", "base"]);
    assert!(hand.app().session().compilation().problems().is_empty());
    assert_eq!(wgsl(&hand), plain, "the same shader");

    // It is closed and opened, dragged into, and isolated by a mode.
    hand.press("Close Folder");
    assert_eq!(rows(&hand).len(), 4);
    hand.press("Open Folder");
    let (from, to) = (row(&hand, "Layer Fill"), row(&hand, "Layer Folder"));
    hand.drag(from, to + vec2(0.0, 20.0));
    hand.settle();
    assert_eq!(rows(&hand)[2], "Layer Fill");
    assert_eq!(chain(hand.look()), ["back", "folder", "base"]);
    hand.press("Blending of Folder");
    hand.press("Screen");
    assert_eq!(hand.look().graph.nodes["folder"].kind, "folder");
    assert!(hand.app().session().compilation().problems().is_empty());
    hand.press("Solo Diffuse");
    let alone = wgsl(&hand);
    assert!(alone.contains("diffuse") && !alone.contains("specular"), "solo goes into folders");
    hand.press("Show all");

    hand.press("Layer Folder");
    hand.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::G);
    hand.settle();
    assert_eq!(chain(hand.look()), ["back", "fill", "specular", "diffuse", "base"]);
    for _ in 0..4 {
        hand.undo();
    }
    hand.settle();
    assert_eq!(*hand.look(), before);
}

#[test]
fn a_mask_is_painted_on_the_model_stroke_by_stroke() {
    let mut hand = User::new();
    let folder = open(
        &mut hand,
        &KEYED.split(r#""direction_keys""#).next().map_or_else(String::new, |look| {
            look.trim_end().trim_end_matches(',').to_owned() + "}"
        }),
    );
    let file = folder.path().join("look-mask.png");
    let tones = || image::open(&file).unwrap().into_luma8().into_raw();
    hand.press("More of Diffuse");
    hand.press("Mask by");
    hand.press("Paint on the model");
    hand.settle();
    assert!(tones().iter().all(|tone| *tone == 0), "hidden at first");
    assert!(hand.app().session().compilation().problems().is_empty());
    assert!(hand.says("Mask of Diffuse"));
    let middle = hand.app().viewport().rect().unwrap().center();
    hand.drag(middle - vec2(40.0, 0.0), middle + vec2(40.0, 0.0));
    hand.settle();
    let painted = tones();
    let shown = painted.iter().filter(|tone| **tone == 255).count();
    assert!(0 < shown && shown < painted.len() / 4, "{shown} of {}", painted.len());
    // What is beside the model is nothing to paint.
    let steps = hand.steps();
    let corner = hand.app().viewport().rect().unwrap().right_bottom() - vec2(30.0, 30.0);
    hand.drag(corner, corner - vec2(5.0, 0.0));
    hand.settle();
    assert_eq!(hand.steps(), steps);
    hand.press_a(Role::Button, "Invert");
    hand.settle();
    assert_eq!(tones()[0], 255);
    hand.undo();
    hand.settle();
    assert_eq!(tones(), painted);
    hand.undo();
    hand.settle();
    assert!(tones().iter().all(|tone| *tone == 0), "as before the stroke");
    hand.key(Key::Escape);
    hand.settle();
    assert!(!hand.has("Done"), "painting has ended");
    hand.undo();
    hand.settle();
    assert!(hand.look().graph.wire_into(&"diffuse".into(), &"opacity".into()).is_none());
    assert!(!file.exists(), "the untouched mask goes with its step");
}

/// Each layer's row tells its share of the picture's time, and *Cost and accuracy* lists layers and
/// not the nodes behind them.
#[test]
fn costs_are_told_by_the_layers_of_the_stack() {
    let mut hand = User::drawing_with(|app, _| app);
    hand.app_mut().open(std::path::Path::new("examples/looks/highlight-cut.json"));
    hand.settle();
    for layer in ["Rim's light", "Highlight on top", "Shadow"] {
        assert!(hand.says(&format!("Cost of {layer}: ")), "{layer}");
    }
    hand.tab("Cost and accuracy");
    let links = |name: &str| hand.harness.query_all_by_role_and_label(Role::Link, name).count();
    assert_eq!(links("Highlight on top"), 1);
    assert_eq!(links("Shared by several layers"), 1, "what is in the dark is for two of them");
    for node in ["Lit side", "Bite", "Disc", "Crescent", "Dot", "In the dark"] {
        assert_eq!(links(node), 0, "{node}");
    }
}
