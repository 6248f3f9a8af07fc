//! The window in another language: every text of it is looked up, and a chosen language is spoken
//! at once and the next time.
//!
//! The language is the process's, so that each of these tests runs in a process of its own: this
//! program, started anew for that one test.

use std::collections::BTreeSet;
use std::env;
use std::process::Command;

use chiaro::editor::Settings;
use chiaro_locale::Language;
use eframe::egui::epaint::ClippedShape;
use eframe::egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable as _;

use crate::editor_support::User;
use crate::editor_support::home::Home;
use crate::layout::{
    MENUS, ROUNDS, SIZES, collect, crowded, cut_readings, faults, opened, sheet_faults,
};

/// Environment variable of a process that was started for one test.
const ALONE: &str = "CHIARO_TEST_ALONE";

/// True in a process of the test's own; elsewhere runs the test in one, and asks that it passes.
fn is_alone(test: &str) -> bool {
    if env::var_os(ALONE).is_some() {
        return true;
    }
    let program = env::current_exe().expect("the path of this program");
    let name = format!("language::{test}");
    let run = Command::new(program).args([name.as_str(), "--exact"]).env(ALONE, "1").output();
    let run = run.expect("this program starts");
    let said = String::from_utf8_lossy(&run.stdout);
    let wrong = String::from_utf8_lossy(&run.stderr);
    assert!(run.status.success() && said.contains("1 passed"), "{said}\n{wrong}");
    false
}

/// English with marks around all that was looked up and that translators have in their list.
static MARKED: Language = Language::marked(include_str!("../../src/locale/chiaro.pot"));

/// Texts that no catalog has: names that the documents give, files, and targets of values.
const OWN: &[&str] = &[
    ".json",
    "out/shot",
    "By the eye",
    "Nightfall",
    "Rims of all",
    "fill",
    "group:rim",
    "harbor",
    "key light",
    "key_alone",
    "knot",
    "lantern",
    "layer.opacity",
    "lights.sun",
    "rims",
];

/// Words of a text that are not within marks.
fn unmarked(text: &str) -> String {
    let mut depth = 0_usize;
    let mut outside = String::new();
    for letter in text.chars() {
        match letter {
            '«' => depth += 1,
            '»' => depth = depth.saturating_sub(1),
            _ if depth == 0 => outside.push(letter),
            _ => {}
        }
    }
    outside
}

/// True for a text that an English word stands in which was not looked up.
fn is_missed(text: &str) -> bool {
    let outside = unmarked(text);
    let is_own = text.starts_with('#') || OWN.iter().any(|own| text.contains(own));
    let has_word = outside
        .split(|letter: char| !letter.is_alphabetic())
        .any(|word| word.len() > 3 && word.chars().skip(1).all(char::is_lowercase));
    has_word && !is_own
}

fn look(hand: &User, found: &mut BTreeSet<String>, at: &str) {
    for ClippedShape { shape, .. } in &hand.harness.output().shapes {
        let mut texts = Vec::new();
        collect(shape, &mut texts);
        let missed = texts.into_iter().filter(|(_, text)| is_missed(text));
        found.extend(missed.map(|(_, text)| format!("{at}: {text:?}")));
    }
}

#[test]
fn every_text_of_the_window_is_looked_up() {
    if !is_alone("every_text_of_the_window_is_looked_up") {
        return;
    }
    chiaro_locale::speak(Some(&MARKED));
    let home = Home::new();
    let mut hand = opened(&home);
    hand.app_mut().session_mut().select(vec!["layer".into()]);
    hand.harness.set_size([1920.0, 1080.0].into());
    let mut found = BTreeSet::new();
    for panel in ROUNDS.into_iter().flatten() {
        hand.key_with(Modifiers::COMMAND, Key::P);
        // English words find commands in every language.
        hand.type_text(&format!("panel {panel}"));
        hand.key(Key::Enter);
        hand.harness.run_steps(3);
        look(&hand, &mut found, panel);
    }
    for menu in MENUS {
        let marked = format!("«{menu}»");
        let button = hand.harness.get_all_by_label(&marked).next().expect("a menu of the bar");
        let at = button.rect().center();
        hand.click(at);
        hand.harness.run_steps(2);
        look(&hand, &mut found, &format!("menu {menu}"));
        hand.key(Key::Escape);
    }
    assert!(found.is_empty(), "{} texts:\n{}", found.len(), Vec::from_iter(found).join("\n"));
}

fn speak_german() {
    let mut settings = Settings::default();
    settings.language = Some("de".to_owned());
    settings.speak();
    assert_eq!(chiaro_locale::tr("Layers"), "Ebenen");
}

#[test]
fn german_panels_have_room() {
    if !is_alone("german_panels_have_room") {
        return;
    }
    speak_german();
    let home = Home::new();
    let mut hand = opened(&home);
    hand.app_mut().session_mut().select(vec!["layer".into()]);
    let found = faults(&mut hand, &ROUNDS, &SIZES, &[SIZES[0]]);
    assert!(found.is_empty(), "{}\n{}", found.len(), Vec::from_iter(found).join("\n"));
}

#[test]
fn german_buttons_have_room_in_a_small_window_at_twice_the_scale() {
    if !is_alone("german_buttons_have_room_in_a_small_window_at_twice_the_scale") {
        return;
    }
    speak_german();
    let home = Home::new();
    let mut hand = opened(&home);
    let buttons = ["Optionen", "Ebene hinzufügen", "Kopieren"];
    let mut found = crowded(&mut hand, &["Picture", "Layers", "Code"], &buttons);
    found.extend(sheet_faults(&mut hand, "Schließen"));
    // Without a scene the bar has the list of meshes, too.
    let look = home.file("look.json");
    let mut hand = User::with(|ctx| chiaro::editor::App::new(ctx, None).without_dialogs());
    hand.app_mut().open(&look);
    hand.settle();
    found.extend(crowded(&mut hand, &["Picture"], &buttons));
    assert!(found.is_empty(), "{}", Vec::from_iter(found).join("\n"));
}

/// Pyramid without normals, which the import makes and tells of.
const PYRAMID: &str = "v -1 0 -1\nv 1 0 -1\nv 0 0 1\nv 0 2 0\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n";

#[test]
fn notes_of_a_mesh_follow_the_language() {
    if !is_alone("notes_of_a_mesh_follow_the_language") {
        return;
    }
    let home = Home::new();
    let mesh = home.file("pyramid.obj");
    std::fs::write(&mesh, PYRAMID).unwrap();
    let mut hand = User::drawing();
    hand.app_mut().show_on(mesh.to_str().unwrap());
    hand.settle();
    assert!(hand.says("normals were made for 12 corners"));

    let told =
        [("deutsch", "Normalen wurden für 12 Ecken gemacht"), ("english", "normals were made")];
    for (language, told) in told {
        hand.key_with(Modifiers::COMMAND, Key::P);
        hand.type_text(&format!("language: {language}"));
        hand.key(Key::Enter);
        hand.settle();
        let both = ["normals were made", "Normalen wurden"].map(|words| hand.says(words));
        assert!(hand.says(told) && both.iter().filter(|says| **says).count() == 1, "{told}");
    }
}

/// The status bar says nothing of the language before once another is spoken.
#[test]
fn what_was_told_in_another_language_goes() {
    if !is_alone("what_was_told_in_another_language_goes") {
        return;
    }
    let mut hand = User::new();
    hand.press("More of Diffuse");
    hand.press("Copy layer");
    assert!(hand.says("Copied: Diffuse"));
    hand.key_with(Modifiers::COMMAND, Key::P);
    hand.type_text("language: deutsch");
    hand.key(Key::Enter);
    hand.settle();
    assert!(!hand.says("Copied: Diffuse") && hand.app().message().is_none());
}

#[test]
fn german_values_of_wires_lie_within_the_canvas() {
    if !is_alone("german_values_of_wires_lie_within_the_canvas") {
        return;
    }
    speak_german();
    let home = Home::new();
    let mut hand = opened(&home);
    let found = cut_readings(&mut hand);
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn what_is_not_looked_up_is_found() {
    assert!(is_missed("Add layer") && is_missed("«Opacity» of layer"));
    assert!(!is_missed("«Add {layer}»") && !is_missed("«a «b» c»") && !is_missed("12 ms, px, PNG"));
}
