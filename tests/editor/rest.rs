//! A window at rest wakes neither itself nor the GPU, whatever the window shows.

use std::path::Path;
use std::time::Duration;

use crate::editor_support::User;
use eframe::egui::Role;
use egui_kittest::kittest::{NodeT as _, Queryable as _};

/// Names of the check boxes.
fn boxes(hand: &User) -> Vec<String> {
    let boxes = hand.harness.get_all_by_role(Role::CheckBox);
    boxes.filter_map(|node| node.accesskit_node().label()).collect()
}

fn open_view_menu(hand: &mut User) {
    let menu = hand.harness.get_by_label("View").rect().center();
    hand.click(menu);
    hand.settle();
}

fn close_menu(hand: &mut User) {
    let nothing = hand.empty_place();
    hand.click(nothing);
    hand.settle();
}

/// Names of all panels, as the *View* menu lists them.
fn panels(hand: &mut User) -> Vec<String> {
    let others = boxes(hand);
    open_view_menu(hand);
    let panels = boxes(hand).into_iter().filter(|name| !others.contains(name)).collect();
    close_menu(hand);
    panels
}

/// Asserts that none of many frames asks for another frame or a picture.
fn assert_at_rest(hand: &mut User, what: &str) {
    hand.harness.remove_cursor();
    hand.settle();
    // A thread may ask for one more frame after its answer was taken.
    for _ in 0..50 {
        if hand.repaint_delay() == Duration::MAX {
            break;
        }
        hand.settle();
    }
    let pictures = (hand.app().pictures(), hand.app().small_pictures());
    for _ in 0..20 {
        hand.harness.step();
        let causes = hand.harness.ctx.repaint_causes();
        assert_eq!(hand.repaint_delay(), Duration::MAX, "{what}: {causes:?}");
        assert!(!hand.app().is_busy(), "{what}: something is being made");
    }
    assert_eq!(
        (hand.app().pictures(), hand.app().small_pictures()),
        pictures,
        "{what}: pictures are drawn"
    );
}

/// Shows a panel, which may lie behind another one or be closed.
fn show(hand: &mut User, panel: &str) {
    if hand.harness.query_by_role_and_label(Role::Tab, panel).is_none() {
        open_view_menu(hand);
        let entry = hand.harness.get_by_role_and_label(Role::CheckBox, panel).rect().center();
        hand.click(entry);
        close_menu(hand);
    }
    let tab = hand.harness.get_by_role_and_label(Role::Tab, panel).rect().center();
    hand.click(tab);
    hand.settle();
}

#[test]
fn a_window_at_rest_wakes_nothing_whichever_panel_is_shown() {
    let mut hand = User::drawing();
    hand.app_mut().show_on("shape:sphere");
    assert_at_rest(&mut hand, "a new look");
    hand.app_mut().open(
        &Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/looks/figure5-directional.json"),
    );
    hand.app_mut().show_on("shape:sphere");
    assert_at_rest(&mut hand, "a look that was opened");
    let panels = panels(&mut hand);
    assert!(panels.len() > 10, "{panels:?}");
    for panel in panels {
        show(&mut hand, &panel);
        assert_at_rest(&mut hand, &panel);
    }
    // With a selected node the inspector, the profile and the handles on the object have content.
    hand.app_mut().session_mut().select(vec!["output".into()]);
    assert_at_rest(&mut hand, "a selected node");
    // The window rests again after a drag.
    let center = hand.app().viewport().rect().expect("the picture is shown").center();
    hand.drag(center, center + eframe::egui::vec2(30.0, 0.0));
    assert_at_rest(&mut hand, "after a drag");
}
