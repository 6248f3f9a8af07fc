//! HCBTFs are begun, divided otherwise, and made of other things in the window: what that takes in memory is told first.
#![cfg(feature = "editor")]

mod editor_support;

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro::document::{Address, Directions, Grid, Hcbtf, Rule, Tile};
use chiaro::editor::App;
use chiaro::hcbtf::{self, Device};
use editor_support::Hand;
use editor_support::painting::{hcbtf, opened};
use eframe::egui::Role;

const FEW: Directions = Directions { theta: 2, phi: 3 };
const GRID: Grid = Grid { size: [8, 8], light: FEW, view: FEW };

/// A file with two painted samples of one colour each, blended.
fn file(folder: &Path) -> PathBuf {
    let mut hcbtf = Hcbtf { rules: vec![Rule::Blend { sharpness: 2.0 }], ..Hcbtf::new(GRID) };
    for (light, color) in [([0, 0], [90, 90, 90, 255]), ([1, 2], [200, 40, 30, 255])] {
        hcbtf.painted.insert(Address::new(light, [0, 0]), Arc::new(Tile::filled(GRID.size, color)));
    }
    save(folder, "surface", &hcbtf)
}

fn save(folder: &Path, name: &str, hcbtf: &Hcbtf) -> PathBuf {
    let path = folder.join(format!("{name}.hcbtf"));
    fs::write(&path, hcbtf::write(hcbtf).unwrap()).unwrap();
    path
}

fn new_window() -> Hand {
    Hand::with(|ctx| App::new(ctx, None).without_dialogs())
}

fn type_into(hand: &mut Hand, field: &str, text: &str) {
    let field = hand.place_of(Role::SpinButton, field);
    hand.type_over(field, text);
}

#[test]
fn what_a_grid_takes_is_told_before_it_is_made_and_what_cannot_be_held_is_refused() {
    let mut hand = new_window();
    hand.press("Paint");
    hand.press("New HCBTF of any grid...");
    for (field, text) in [
        ("Texels across", "64"),
        ("Texels down", "64"),
        ("Lights: rings", "4"),
        ("Lights: steps", "3"),
        ("Views: rings", "4"),
        ("Views: steps", "3"),
    ] {
        type_into(&mut hand, field, text);
    }
    // 10 x 10 samples of 64 x 64 texels; a texel is a block of 4 x 5 lights in 12 + 1 layers.
    assert!(hand.says("1.57 MiB") && hand.says("4.06 MiB on the GPU"));
    assert!(hand.says("what WebGPU guarantees: textures of up to 8192 texels a side and 256 layers"));
    type_into(&mut hand, "Views: steps", "64");
    assert!(hand.says("257 layers for 256 views") && hand.says("rings times steps may be 255"));
    hand.press("Make it");
    assert!(hand.app().session().painting().is_none(), "the button does nothing");
    type_into(&mut hand, "Views: steps", "63");
    hand.press("Make it");
    assert_eq!(hcbtf(&hand).grid.view, Directions { theta: 4, phi: 63 });
}

#[test]
fn a_file_that_the_device_cannot_hold_is_not_opened_and_says_why() {
    let folder = tempfile::tempdir().unwrap();
    let views = Directions { theta: 16, phi: 16 };
    let path = save(folder.path(), "wide", &Hcbtf::new(Grid { view: views, ..GRID }));
    assert!(Device::guaranteed().check_painted(&Grid { view: views, ..GRID }).is_err());
    let hand = opened(&path);
    assert!(hand.app().session().painting().is_none());
    let told = hand.app().message().unwrap();
    assert!(told.contains("257 layers") && told.contains("take fewer views"), "{told}");
}

#[test]
fn another_grid_is_a_step_that_tells_what_stays() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = opened(&file(folder.path()));
    let before = hcbtf(&hand).clone();
    // What the rules take is told beside them: a texel is a block of 2 x 5 lights, in 6 + 1 layers.
    hand.tab("Fill rules");
    assert!(hand.says("17.5 KiB on the GPU"));
    let memory = hand.place_like("Memory:").center();
    hand.click(memory);
    hand.settle();
    assert!(hand.says("Compact with levels") && hand.says("While it is painted it is quick"));
    hand.press("Grid...");
    assert!(hand.says("All painted samples stay"));
    type_into(&mut hand, "Lights: steps", "2");
    assert!(hand.says("1 of 2 painted samples stay"));
    hand.press("Divide it");
    assert_eq!((hcbtf(&hand).grid.light.phi, hcbtf(&hand).painted.len()), (2, 1));
    hand.undo();
    assert_eq!(hcbtf(&hand), &before);
}
