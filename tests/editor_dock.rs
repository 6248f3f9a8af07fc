//! The panels of the window: closed, brought back, moved and remembered.
#![cfg(feature = "editor")]

mod editor_support;

use editor_support::Hand;
use eframe::egui::{Role, vec2};
use egui_kittest::kittest::Queryable as _;

fn has_tab(hand: &Hand, label: &str) -> bool {
    hand.harness.query_by_role_and_label(Role::Tab, label).is_some()
}

fn click_tab(hand: &mut Hand, label: &str) {
    let at = hand.harness.get_by_role_and_label(Role::Tab, label).rect().center();
    hand.click(at);
    hand.settle();
}

fn in_view_menu(hand: &mut Hand, label: &str) {
    let at = hand.harness.get_by_label("View").rect().center();
    hand.click(at);
    hand.settle();
    let entry = hand.harness.query_by_role_and_label(Role::CheckBox, label);
    let rect = entry.or_else(|| hand.harness.query_by_role_and_label(Role::Button, label)).expect("an entry").rect();
    hand.click(rect.center());
    hand.settle();
    // A click elsewhere closes the menu.
    let at = hand.empty_place();
    hand.click(at);
    hand.settle();
}

#[test]
fn a_panel_that_is_closed_comes_back_beside_its_neighbours() {
    let mut hand = Hand::new();
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
    // All of a stack may go, and the last one comes back all the same.
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
    let mut hand = Hand::new();
    in_view_menu(&mut hand, "Effects");
    click_tab(&mut hand, "Probe");
    let saved = hand.app_mut().changed_arrangement().expect("it changed");
    assert!(hand.app_mut().changed_arrangement().is_none(), "told once");
    let mut other = Hand::new();
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
        assert!(!has_tab(&other, "Effects") && has_tab(&other, "Probe") && has_tab(&other, "Graph"));
    }
}

#[test]
fn panels_do_not_mind_how_little_room_they_have() {
    let mut hand = Hand::new();
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
