//! Snapshots of the look, and what the picture is compared with.

use crate::editor_support::User;
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, vec2};
use egui_kittest::kittest::Queryable as _;

fn file(folder: &tempfile::TempDir, name: &str) -> std::path::PathBuf {
    folder.path().join(name)
}

/// Opens the menu of a snapshot, and presses an entry.
#[track_caller]
fn more(hand: &mut User, name: &str, entry: &str) {
    hand.press(&format!("More about {name}"));
    hand.press(entry);
}

fn steps(hand: &User) -> Vec<String> {
    hand.app().session().steps().labels().map(str::to_owned).collect()
}

#[test]
fn a_look_comes_back_from_its_snapshot_in_a_small_window() {
    let folder = tempfile::tempdir().unwrap();
    let path = file(&folder, "toon.json");
    let beside = file(&folder, "toon.snapshots.json");
    let mut hand = User::new();
    hand.harness.set_size(vec2(800.0, 600.0));
    hand.settle();
    let before = hand.look().clone();
    hand.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::T);
    hand.settle();
    assert!(hand.has("Snapshot 1") && hand.says("as the look is now"), "the panel comes forward");
    assert!(!hand.app().session().is_dirty(), "the look is as it was");
    hand.app_mut().save_as(&path);
    hand.settle();
    let kept = std::fs::read_to_string(&beside).unwrap();
    assert!(kept.contains("Snapshot 1") && !hand.look().to_text().contains("Snapshot"));
    // What is done after it is taken back by one step, and that step too.
    hand.add("light", hand.empty_place());
    let after = hand.look().clone();
    assert_ne!(before, after);
    hand.press("Restore Snapshot 1");
    assert_eq!(*hand.look(), before);
    assert_eq!(steps(&hand).last().map(String::as_str), Some("restore Snapshot 1"));
    hand.undo();
    assert_eq!(*hand.look(), after);
    hand.redo();
    assert_eq!(steps(&hand).last().map(String::as_str), Some("restore Snapshot 1"));
    more(&mut hand, "Snapshot 1", "Rename");
    hand.type_text("Night");
    hand.key(Key::Enter);
    hand.settle();
    assert!(hand.has("Night") && std::fs::read_to_string(&beside).unwrap().contains("Night"));
    more(&mut hand, "Night", "Delete");
    assert!(!hand.has("Night") && hand.says("A snapshot keeps"));
    hand.undo();
    hand.settle();
    assert!(hand.has("Night") && std::fs::read_to_string(&beside).unwrap().contains("Night"));
    // Another window has it too, and a new look begins from it.
    let mut other = User::new();
    other.app_mut().open(&path);
    other.app_mut().save_as(&file(&folder, "copy.json"));
    assert!(file(&folder, "copy.snapshots.json").is_file(), "it goes along with the look");
    other.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::T);
    other.settle();
    more(&mut other, "Night", "New look from it");
    assert!(other.app().session().path().is_none() && !other.has("Restore Night"));
    assert_eq!(other.look().name, "New look, Night");
    assert_eq!(other.look().graph, before.graph);
}

/// Opens the list of what the picture is compared with, which tells the present choice.
#[track_caller]
fn list_of(hand: &mut User, present: &str) {
    let lists = hand.harness.get_all_by_role(Role::ComboBox);
    let list = lists.into_iter().find(|node| node.value().as_deref() == Some(present));
    let at = list.expect("the list of what to compare with").rect().center();
    hand.click(at);
}

#[test]
fn the_picture_is_held_against_snapshots_and_files() {
    let folder = tempfile::tempdir().unwrap();
    let path = file(&folder, "toon.json");
    let mut hand = User::drawing_coarsely(|app, _| app);
    hand.app_mut().save_as(&path);
    hand.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::T);
    hand.settle();
    let most = |hand: &User| hand.app().wipe().figures().expect("it is drawn").max;
    hand.press("Compare with Snapshot 1");
    hand.harness.run_steps(4);
    hand.settle();
    assert_eq!(most(&hand), 0.0, "nothing was done since");
    let edit = chiaro::document::Edit::SetValue {
        graph: chiaro::document::GraphId::Look,
        id: "base".into(),
        port: "color".into(),
        value: chiaro::document::Value::Vector(vec![0.9, 0.1, 0.1]),
        index: None,
    };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.settle();
    hand.harness.run_steps(4);
    hand.settle();
    assert!(most(&hand) > 0.5, "it follows the look: {}", most(&hand));
    hand.press("Beside");
    assert!(hand.harness.render().is_ok());
    // The look as its file has it is the snapshot.
    hand.press_a(Role::ComboBox, "Left picture");
    hand.press_a(Role::Button, "Snapshot 1");
    list_of(&mut hand, "Snapshot 1");
    hand.press("As saved");
    hand.harness.run_steps(4);
    hand.settle();
    assert_eq!(most(&hand), 0.0);
    // Files that vanish or are damaged say so.
    let image = file(&folder, "reference.png");
    hand.app_mut().answer_dialog(&image);
    list_of(&mut hand, "As saved");
    hand.press("A look or picture in a file...");
    assert!(hand.says("reference.png") && hand.app().wipe().figures().is_none());
    hand.app_mut().save_picture([64, 32], &image);
    hand.settle();
    hand.harness.run_steps(4);
    hand.settle();
    assert!(hand.app().wipe().problems().is_empty() && hand.app().wipe().figures().is_some());
    std::fs::write(&image, b"\x89PNG and no more").unwrap();
    hand.harness.run_steps(4);
    hand.settle();
    assert!(hand.says("reference.png") && !hand.app().wipe().problems().is_empty());
}

#[test]
fn the_title_begins_with_what_a_save_writes() {
    let folder = tempfile::tempdir().unwrap();
    let path = file(&folder, "toon.json");
    let mut hand = User::new();
    hand.app_mut().save_as(&path);
    assert_eq!(hand.app().title(), "toon.json - Chiaro");
    hand.add("light", hand.empty_place());
    assert_eq!(hand.app().title(), "toon.json* - Chiaro");
    hand.undo();
    // A painting beside the look is written by the next save, the look is not.
    hand.key_with(Modifiers::COMMAND, Key::P);
    hand.type_text("New painted surface, small");
    hand.key(Key::Enter);
    hand.settle();
    let title = hand.app().title();
    assert!(title.starts_with("New painted surface"), "{title}");
}

#[test]
fn a_variation_is_taken_by_a_click_and_another_sheet_lies_around_it() {
    let mut hand = User::new();
    hand.key_with(Modifiers::COMMAND, Key::P);
    hand.type_text("Variations...");
    hand.key(Key::Enter);
    hand.settle();
    hand.choose("Vary", "key: Intensity");
    let before = hand.look().clone();
    hand.press("Take 1.25");
    let taken = hand.look().clone();
    assert_eq!(hand.steps(), 1);
    assert!(taken != before && taken.lights["key"].intensity == 1.25);
    hand.press("Again around this one");
    assert!(hand.has("Take 1.25") && !hand.has("Take 0"), "a finer sheet around it");
    hand.undo();
    assert_eq!(*hand.look(), before);
    hand.choose("Vary", "Mesh");
    hand.press("Take Sphere");
    assert_eq!(hand.app().session().view().orbit().mesh, "shape:sphere");
}
