//! Every widget that can be operated has a name that a screen reader tells, in every panel, the
//! menus and the start page.

use std::path::Path;
use std::sync::Arc;

use crate::editor_support::User;
use chiaro::document::{Address, Directions, Grid, Hcbtf, HcbtfAngle, Rule, Strokes, Tile};
use eframe::egui::{Key, Modifiers, Role};
use egui_kittest::kittest::{NodeT as _, Queryable as _};

/// Roles of widgets that can be operated.
const ROLES: [Role; 11] = [
    Role::Button,
    Role::CheckBox,
    Role::RadioButton,
    Role::Slider,
    Role::SpinButton,
    Role::ComboBox,
    Role::TextInput,
    Role::MultilineTextInput,
    Role::ColorWell,
    Role::Tab,
    Role::Link,
];

/// True if a name has a letter; names of signs alone say nothing when they are read aloud.
fn is_word(name: &str) -> bool {
    name.chars().any(char::is_alphabetic)
}

fn nameless(hand: &User, what: &str, found: &mut Vec<String>) {
    for role in ROLES {
        for node in hand.harness.query_all_by_role(role) {
            let node = node.accesskit_node();
            let name = node.label().unwrap_or_default();
            // A button that shows a number or a color may be named by the value that it shows.
            let says = is_word(&name)
                || role == Role::Button && node.value().is_some_and(|value| is_word(&value));
            if !says {
                found.push(format!(
                    "{what}: a {role:?} called {name:?} with {:?} at {:?}",
                    node.value(),
                    node.raw_bounds()
                ));
            }
        }
    }
}

fn opened(hand: &mut User, example: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(example);
    hand.app_mut().open(&path);
    hand.settle();
}

/// Names of all panels, as the *View* menu lists them.
fn panels(hand: &mut User) -> Vec<String> {
    let boxes = |hand: &User| -> Vec<String> {
        let boxes = hand.harness.query_all_by_role(Role::CheckBox);
        boxes.filter_map(|node| node.accesskit_node().label()).collect()
    };
    let before = boxes(hand);
    hand.press("View");
    let panels = boxes(hand).into_iter().filter(|name| !before.contains(name)).collect();
    hand.key(Key::Escape);
    hand.settle();
    panels
}

/// Opens the painting workspace with a rule of each kind and checks its panels.
fn painting(hand: &mut User, found: &mut Vec<String>) {
    let from = Address::default();
    let angles = vec![HcbtfAngle::ViewPhi, HcbtfAngle::LightPhi];
    let rules = vec![
        Rule::Copy { from },
        Rule::Lock { angles },
        Rule::Blend { sharpness: 2.0 },
        Rule::Mirror { color: [255; 4], width: 0.5 },
        Rule::Specular { from, width: 0.5 },
        Rule::Color { color: [9; 4] },
        Rule::Lambert { shadow: [0; 3], amount: 1.0 },
        Rule::Rotate { turns: 1.0 },
        Rule::Recolor { angle: HcbtfAngle::LightTheta, from: [255; 3], to: [9; 3] },
        Rule::Morph { sharpness: 2.0 },
        Rule::Strokes(Box::new(Strokes::preset("Pencil"))),
        Rule::Relief(Box::default()),
    ];
    let three = Directions { theta: 2, phi: 3 };
    let mut hcbtf = Hcbtf { rules, ..Hcbtf::new(Grid { size: [4, 4], light: three, view: three }) };
    hcbtf.painted.insert(from, Arc::new(Tile::filled([4, 4], [90, 90, 90, 255])));
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("all.hcbtf");
    std::fs::write(&path, chiaro::hcbtf::write(&hcbtf).unwrap()).unwrap();
    hand.app_mut().open(&path);
    hand.settle();
    nameless(hand, "the painting workspace", found);
    for menu in ["Paint", "+ Add a rule", "Begin with", "Symmetry", "Pen"] {
        hand.press_a(Role::Button, menu);
        nameless(hand, menu, found);
        hand.key(Key::Escape);
        hand.settle();
    }
}

#[test]
fn everything_that_can_be_operated_has_a_name() {
    let mut found = Vec::new();
    let mut hand = User::drawing_with(|app, _| app.without_dialogs());
    hand.app_mut().show_on("shape:sphere");
    opened(&mut hand, "examples/looks/figure5-directional.json");
    let panels = panels(&mut hand);
    assert!(panels.len() > 10, "{panels:?}");
    for menu in ["View", "Recent", "Options", "Export", "Copy as", "Help"] {
        hand.press(menu);
        nameless(&hand, &format!("the menu {menu}"), &mut found);
        hand.key(Key::Escape);
        hand.settle();
    }
    for selected in [vec![], vec!["diffuse"], vec!["diffuse", "highlight"]] {
        hand.app_mut().session_mut().select(selected.iter().map(|id| (*id).into()).collect());
        hand.settle();
        for panel in &panels {
            if hand.harness.query_by_role_and_label(Role::Tab, panel).is_none() {
                hand.press("View");
                hand.press_a(Role::CheckBox, panel);
                hand.key(Key::Escape);
                hand.settle();
            }
            hand.tab(panel);
            nameless(&hand, &format!("{panel} with {selected:?}"), &mut found);
        }
    }
    hand.key_with(Modifiers::COMMAND, Key::P);
    hand.settle();
    nameless(&hand, "the command palette", &mut found);
    hand.key(Key::Escape);
    hand.key(Key::F1);
    hand.settle();
    nameless(&hand, "the sheet of keys", &mut found);
    hand.key(Key::Escape);
    opened(&mut hand, "examples/scenes/cast.json");
    hand.tab("Objects");
    nameless(&hand, "a scene", &mut found);
    painting(&mut hand, &mut found);
    hand.app_mut().show_start_page();
    hand.settle();
    nameless(&hand, "the start page", &mut found);
    assert!(found.is_empty(), "{}", found.join("\n"));
}
