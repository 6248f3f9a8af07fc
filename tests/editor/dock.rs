//! The panels of the window: closed, brought back, moved and remembered.

use crate::editor_support::User;
use crate::editor_support::home::Home;
use chiaro::editor::{App, Orbit};
use eframe::egui::accesskit::Toggled;
use eframe::egui::{Key, Modifiers, Role, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};

fn has_tab(hand: &User, label: &str) -> bool {
    hand.harness.query_by_role_and_label(Role::Tab, label).is_some()
}

fn click_tab(hand: &mut User, label: &str) {
    let at = hand.harness.get_by_role_and_label(Role::Tab, label).rect().center();
    hand.click(at);
    hand.settle();
}

fn in_view_menu(hand: &mut User, label: &str) {
    let at = hand.harness.get_by_label("View").rect().center();
    hand.click(at);
    hand.settle();
    let entry = hand.harness.query_by_role_and_label(Role::CheckBox, label);
    let rect = entry
        .or_else(|| hand.harness.query_by_role_and_label(Role::Button, label))
        .expect("an entry")
        .rect();
    hand.click(rect.center());
    hand.settle();
    // A click elsewhere closes the menu.
    let at = hand.empty_place();
    hand.click(at);
    hand.settle();
}

#[test]
fn a_panel_that_is_closed_comes_back_beside_its_neighbors() {
    let mut hand = User::new();
    for label in [
        "Picture",
        "Graph",
        "Inspector",
        "Code",
        "Effects",
        "Cost and accuracy",
        "Probe",
        "Layers",
        "Lights",
        "Problems",
        "History",
        "Library",
    ] {
        assert!(has_tab(&hand, label), "{label}");
    }
    click_tab(&mut hand, "Effects");
    assert!(hand.harness.query_by_label_contains("no GPU").is_some());
    in_view_menu(&mut hand, "Effects");
    assert!(!has_tab(&hand, "Effects") && has_tab(&hand, "Code"));
    in_view_menu(&mut hand, "Effects");
    let tab = |label| hand.harness.get_by_role_and_label(Role::Tab, label).rect();
    assert_eq!(tab("Effects").top(), tab("Code").top(), "in the same stack");
    // All panels of a stack may be closed, and the last one still comes back.
    for label in ["Effects", "Code", "Problems", "Cost and accuracy", "Probe"] {
        in_view_menu(&mut hand, label);
    }
    assert!(!has_tab(&hand, "Code"));
    in_view_menu(&mut hand, "Probe");
    assert!(has_tab(&hand, "Probe"));
    in_view_menu(&mut hand, "Reset panels");
    assert!(has_tab(&hand, "Code") && has_tab(&hand, "Effects"));
}

#[test]
fn the_arrangement_is_remembered_and_a_damaged_one_changes_nothing() {
    let mut hand = User::new();
    in_view_menu(&mut hand, "Effects");
    click_tab(&mut hand, "Probe");
    let saved = hand.app_mut().changed_arrangement().expect("it changed");
    assert!(hand.app_mut().changed_arrangement().is_none(), "told once");
    let mut other = User::new();
    other.app_mut().arrange(&saved);
    other.settle();
    assert!(!has_tab(&other, "Effects") && has_tab(&other, "Probe"));
    for broken in [
        serde_json::json!(null),
        serde_json::json!({"root": 7}),
        serde_json::json!({"root": 1, "tiles": {"tiles": {}}}),
    ] {
        other.app_mut().arrange(&broken);
        other.settle();
        assert!(
            !has_tab(&other, "Effects") && has_tab(&other, "Probe") && has_tab(&other, "Graph")
        );
    }
}

/// True if a panel's tab is the one in front.
fn is_in_front(hand: &User, label: &str) -> bool {
    hand.harness
        .query_by_role_and_label(Role::Tab, label)
        .is_some_and(|tab| tab.accesskit_node().toggled() == Some(Toggled::True))
}

#[test]
fn panels_that_join_a_row_of_tabs_push_none_of_the_first_out() {
    let mut hand = User::new();
    for panel in ["Snapshots", "Variations", "Wedge", "Render"] {
        view(&mut hand, Role::CheckBox, panel);
    }
    let tab = |label| hand.harness.get_by_role_and_label(Role::Tab, label).rect();
    let row = tab("Layers").top();
    for label in ["Layers", "Lights", "Render"] {
        let seen = tab(label);
        assert!(seen.width() > 40.0 && seen.right() < 1500.0 && seen.top() == row, "{label}");
    }
    assert!(is_in_front(&hand, "Render") && tab("Wedge").width() == 0.0);
    click_tab(&mut hand, "Lights");
    assert!(is_in_front(&hand, "Lights"));
}

fn new_painting(hand: &mut User) {
    hand.press("Paint");
    hand.press("New painted surface, small (16 x 16, 3 x 6 directions)");
    assert!(hand.has("Painting canvas"));
}

fn view(hand: &mut User, role: Role, label: &str) {
    hand.press("View");
    hand.press_a(role, label);
    hand.key(Key::Escape);
    hand.settle();
}

#[test]
fn painting_has_a_layout_of_its_own_and_each_is_kept_as_it_was_left() {
    let home = Home::new();
    let mut hand = home.window(None);
    view(&mut hand, Role::CheckBox, "Effects");
    assert!(!has_tab(&hand, "Effects") && !has_tab(&hand, "Paint") && is_in_front(&hand, "Graph"));
    new_painting(&mut hand);
    assert!(
        is_in_front(&hand, "Paint") && is_in_front(&hand, "Samples") && !has_tab(&hand, "Effects")
    );
    view(&mut hand, Role::CheckBox, "Fill rules");
    view(&mut hand, Role::CheckBox, "Sheet");
    // Another look brings back the graph, without panels of painting.
    hand.key_with(Modifiers::COMMAND, Key::N);
    hand.settle();
    assert!(is_in_front(&hand, "Graph") && !has_tab(&hand, "Effects"));
    assert!(
        ["Paint", "Samples", "Sheet", "Light and eye", "Fill rules"]
            .iter()
            .all(|panel| !has_tab(&hand, panel))
    );
    // The layout is also switched by hand, both ways.
    view(&mut hand, Role::RadioButton, "Layout for painting");
    assert!(has_tab(&hand, "Sheet") && !has_tab(&hand, "Fill rules"));
    view(&mut hand, Role::RadioButton, "Layout for looks");
    assert!(is_in_front(&hand, "Graph") && !has_tab(&hand, "Paint"));
    // The command that goes back to the painting brings its layout.
    view(&mut hand, Role::CheckBox, "Paint");
    hand.press("Back to New painted surface");
    assert!(
        is_in_front(&hand, "Paint") && has_tab(&hand, "Sheet") && !has_tab(&hand, "Fill rules")
    );
    hand.press("Paint");
    hand.press("Close the painted surface");
    assert!(is_in_front(&hand, "Graph"), "the panel that was opened to paint is behind it");
    assert!(!has_tab(&hand, "Sheet") && !has_tab(&hand, "Effects"));
    drop(hand);

    let mut hand = home.window(None);
    assert!(is_in_front(&hand, "Graph") && !has_tab(&hand, "Sheet") && !has_tab(&hand, "Effects"));
    new_painting(&mut hand);
    assert!(has_tab(&hand, "Sheet") && !has_tab(&hand, "Fill rules") && !has_tab(&hand, "Effects"));
    // Each layout is reset by itself.
    view(&mut hand, Role::Button, "Reset panels");
    assert!(
        has_tab(&hand, "Fill rules") && !has_tab(&hand, "Sheet") && is_in_front(&hand, "Paint")
    );
    hand.key_with(Modifiers::COMMAND, Key::N);
    hand.settle();
    assert!(!has_tab(&hand, "Effects"), "the other one stays");
}

#[test]
fn a_painting_that_is_left_gives_the_view_of_before_back() {
    let mut hand = User::with(|ctx| App::new(ctx, None).without_dialogs());
    hand.app_mut().show_on("shape:torus");
    hand.settle();
    let middle = hand.app().viewport().rect().unwrap().center();
    hand.drag(middle, middle + vec2(70.0, -30.0));
    hand.settle();
    let before = hand.app().session().view().orbit().clone();
    new_painting(&mut hand);
    let sheet = hand.app().session().view().orbit().clone();
    assert!(
        sheet.mesh == "shape:plane" && sheet.z_is_up,
        "a painting is seen on a square that lies"
    );
    // A turned sheet is still a sheet; and the second painting's square is no view to come back to
    // either.
    hand.drag(middle, middle + vec2(-40.0, 20.0));
    new_painting(&mut hand);
    hand.key_with(Modifiers::COMMAND, Key::N);
    hand.settle();
    assert_eq!(*hand.app().session().view().orbit(), before);
    // The command that goes back to the painting shows the square again; a new look then has the
    // view of before.
    hand.press("Paint");
    hand.press_a(Role::MenuItem, "Back to New painted surface");
    assert_eq!(hand.app().session().view().orbit().mesh, "shape:plane");
    hand.key_with(Modifiers::COMMAND, Key::N);
    hand.settle();
    assert_eq!(*hand.app().session().view().orbit(), before);
}

#[test]
fn a_mesh_that_was_chosen_while_painting_stays_and_stands_as_it_stood() {
    let mut hand = User::with(|ctx| App::new(ctx, None).without_dialogs());
    new_painting(&mut hand);
    hand.app_mut().show_on("shape:knot");
    hand.key_with(Modifiers::COMMAND, Key::N);
    hand.settle();
    assert_eq!(
        *hand.app().session().view().orbit(),
        Orbit { mesh: "shape:knot".to_owned(), ..Orbit::default() }
    );
}

#[test]
fn after_a_restart_a_painting_gives_the_view_of_the_beginning() {
    let home = Home::new();
    let mut hand = home.window(None);
    new_painting(&mut hand);
    let at = hand.app().painting().screen([8.0, 8.0]).unwrap();
    hand.drag(at, at + vec2(0.5, 0.0));
    hand.settle();
    hand.app_mut().session_mut().close_journal(true);
    drop(hand);
    let mut hand = home.window(None);
    assert!(
        hand.has("Painting canvas") && hand.app().session().view().orbit().mesh == "shape:plane"
    );
    hand.key_with(Modifiers::COMMAND, Key::N);
    hand.settle();
    assert_eq!(*hand.app().session().view().orbit(), Orbit::default());
}

#[test]
fn edits_of_a_look_move_no_panels() {
    let mut hand = User::with(|ctx| App::new(ctx, None).without_dialogs());
    new_painting(&mut hand);
    hand.app_mut().session_mut().select(vec!["painting".into()]);
    let edit = chiaro::document::Edit::SetValue {
        graph: chiaro::document::GraphId::Look,
        id: "painting".into(),
        port: "sheet".into(),
        value: chiaro::document::Value::Text(String::new()),
        index: None,
    };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.settle();
    assert!(
        !hand.has("Painting canvas") && is_in_front(&hand, "Paint") && has_tab(&hand, "Samples")
    );
}

#[test]
fn the_one_layout_of_before_becomes_both_where_painting_had_covered_the_graph() {
    let mut hand = User::new();
    new_painting(&mut hand);
    let saved = hand.app_mut().changed_arrangement().expect("it changed");
    // An older program wrote the layout without a name, with the panels of painting in it.
    let mut other = User::new();
    other.app_mut().arrange(&saved["painting"]);
    other.settle();
    assert!(
        is_in_front(&other, "Graph") && has_tab(&other, "Paint"),
        "nothing that was arranged is taken away"
    );
    new_painting(&mut other);
    assert!(is_in_front(&other, "Paint") && is_in_front(&other, "Samples"));
}

#[test]
fn panels_do_not_mind_how_little_room_they_have() {
    let mut hand = User::new();
    hand.app_mut().session_mut().select(vec!["diffuse".into()]);
    for panel in ["Layers", "Lights", "Objects", "Library", "History"] {
        hand.harness.set_size(vec2(1500.0, 900.0));
        hand.settle();
        hand.press_a(Role::Tab, panel);
        for size in [vec2(120.0, 400.0), vec2(60.0, 60.0), vec2(400.0, 90.0)] {
            hand.harness.set_size(size);
            hand.harness.run_steps(3);
        }
    }
}
