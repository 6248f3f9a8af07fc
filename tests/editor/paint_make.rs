//! HCBTFs are begun, divided otherwise, and made from pictures, looks and other HCBTFs in the
//! window; the memory that they take is told before.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::editor_support::User;
use crate::editor_support::painting::{hcbtf, opened};
use chiaro::document::{Address, Directions, Grid, Hcbtf, Rule, Tile};
use chiaro::editor::App;
use chiaro::hcbtf::{self, Device};
use chiaro::progress::Progress;
use eframe::egui::{Key, Role};
use egui_kittest::kittest::{NodeT as _, Queryable as _};

const FEW: Directions = Directions { theta: 2, phi: 3 };
const GRID: Grid = Grid { size: [8, 8], light: FEW, view: FEW };

/// A file with two painted samples of one color each, and a rule that blends them.
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

fn new_window() -> User {
    User::with(|ctx| App::new(ctx, None).without_dialogs())
}

fn type_into(hand: &mut User, field: &str, text: &str) {
    let field = hand.place_of(Role::SpinButton, field);
    hand.type_over(field, text);
}

#[test]
fn what_a_grid_takes_is_told_before_it_is_made_and_what_cannot_be_held_is_refused() {
    let mut hand = new_window();
    hand.press("Paint");
    hand.press("New painted surface of any grid...");
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
    assert!(
        hand.says("what WebGPU guarantees: textures of up to 8192 texels a side and 256 layers")
    );
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
    // The memory of the filled samples is told beside the rules: a texel is a block of 2 x 5
    // lights, in 6 + 1 layers.
    hand.tab("Fill rules");
    assert!(hand.says("17.5 KiB on the GPU"));
    let memory = hand.place_like("Memory:").center();
    hand.click(memory);
    hand.settle();
    assert!(hand.says("Compact with levels") && hand.says("While it is painted it is quick"));
    hand.press("Grid...");
    assert!(hand.says("All painted samples stay"));
    type_into(&mut hand, "Lights: steps", "2");
    assert!(hand.says(
        "1 of 2 painted samples would be lost: they are at rings and steps that there are no more"
    ));
    hand.press("Divide it, and lose 1 painted sample");
    assert_eq!((hcbtf(&hand).grid.light.phi, hcbtf(&hand).painted.len()), (2, 1));
    let told = hand.app().message().unwrap();
    assert!(told.contains("1 painted sample went") && told.contains("Undo"), "{told}");
    hand.undo();
    assert_eq!(hcbtf(&hand), &before);
}

/// Every sample of an HCBTF, painted or filled by rules.
fn all(hcbtf: &Hcbtf) -> hcbtf::FilledSamples {
    hcbtf::fill::fill(hcbtf, &Progress::new()).unwrap()
}

fn open_menu(hand: &mut User, item: &str) {
    hand.press("Paint");
    hand.press(item);
}

/// A file with a painted tile on which every texel has another color.
fn numbered(folder: &Path) -> PathBuf {
    let grid = Grid { size: [16, 16], ..GRID };
    let mut hcbtf =
        Hcbtf { rules: vec![Rule::Lambert { shadow: [0; 3], amount: 0.5 }], ..Hcbtf::new(grid) };
    hcbtf.rules.insert(0, Rule::Copy { from: Address::default() });
    let texels = (0..256_u32).flat_map(|at| [at as u8, 255 - at as u8, (at / 16 * 16) as u8, 255]);
    hcbtf
        .painted
        .insert(Address::default(), Arc::new(Tile::new(grid.size, texels.collect()).unwrap()));
    save(folder, "numbered", &hcbtf)
}

#[test]
fn a_new_tile_is_seen_before_it_is_begun_and_the_painted_one_stays() {
    let folder = tempfile::tempdir().unwrap();
    let path = numbered(folder.path());
    let mut hand = opened(&path);
    let source = hcbtf(&hand).clone();
    open_menu(&mut hand, "New tile from this painting...");
    type_into(&mut hand, "Texels across", "24");
    type_into(&mut hand, "Seed", "7");
    // 16 samples, of which one is painted and the rules that work texel by texel stay.
    assert!(hand.says("1 of 16 samples are painted"));
    hand.press("Begin it as a new painting");
    let how = hcbtf::Synthesis { size: [24, 16], seed: 7, patch: None };
    let expected = hcbtf::synthesize(&source, &how, &Progress::new()).unwrap();
    assert_eq!(hcbtf(&hand), &expected, "as `chiaro hcbtf synthesize` makes it");
    let work = hand.app().session().painting().unwrap();
    assert!(work.is_dirty() && work.path().is_none(), "no file holds it");
    assert_eq!(hcbtf::load(&chiaro::files::Disk, &path).unwrap().value, source);
    // Every texel is one of the source, in all samples the same one.
    let (old, new) = (all(&source), all(&expected));
    let texel = |filled: &hcbtf::FilledSamples, address, at: usize| {
        <[u8; 4]>::try_from(&filled.tile(address).unwrap().bytes()[4 * at..4 * at + 4]).unwrap()
    };
    for at in 0..24 * 16 {
        let from = usize::from(texel(&new, Address::default(), at)[0]);
        for address in source.grid.addresses() {
            assert_eq!(texel(&new, address, at), texel(&old, address, from));
        }
    }
}

#[test]
fn patches_that_do_not_fit_are_told_of_and_laying_is_stopped() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = opened(&numbered(folder.path()));
    let source = hcbtf(&hand).clone();
    open_menu(&mut hand, "New tile from this painting...");
    type_into(&mut hand, "Texels across", "3");
    assert!(hand.says("do not fit tiles whose shorter side is 3"));
    hand.press("Begin it as a new painting");
    assert_eq!(hcbtf(&hand), &source, "the button does nothing");
    // A tile so large that laying its patches is not done before the test stops it.
    let field = hand.place_of(Role::SpinButton, "Texels across").center();
    hand.click(field);
    hand.key_with(eframe::egui::Modifiers::COMMAND, eframe::egui::Key::A);
    hand.type_text("4000");
    hand.key(eframe::egui::Key::Enter);
    hand.harness.run_steps(3);
    let stop = hand.place("Stop").center();
    hand.click(stop);
    hand.settle();
    assert!(hand.says("Stopped: change something to lay it anew"));
    hand.press("Cancel");
    assert_eq!(hcbtf(&hand), &source);
}

/// The file of a look whose light can be seen.
fn look(folder: &Path) -> PathBuf {
    let path = folder.join("look.json");
    let text = r#"{"chiaro": "look", "lights": {"key": {"direction": [0, 0, 1]},
        "low": {"direction": [1, 0, 0.2]}}, "nodes": [
        {"id": "base", "kind": "base", "values": {"color": [0.1, 0.1, 0.2]}},
        {"id": "layer", "kind": "light_layer", "values": {"light": "key", "convex": [1, 0.5, 0.2]}},
        {"id": "output", "kind": "output"}],
        "wires": [{"from": "base", "to": "layer.below"},
        {"from": "layer", "to": "output.color"}]}"#;
    fs::write(&path, text).unwrap();
    path
}

fn ask_for_small_grid(hand: &mut User) {
    for (field, text) in [
        ("Texels across", "4"),
        ("Texels down", "4"),
        ("Lights: rings", "2"),
        ("Lights: steps", "3"),
        ("Views: rings", "1"),
        ("Views: steps", "1"),
    ] {
        type_into(hand, field, text);
    }
}

#[test]
fn the_open_look_is_baked_into_a_file_as_the_command_line_bakes_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = look(folder.path());
    let mut hand = opened(&path);
    open_menu(&mut hand, "Bake this look onto a tile...");
    ask_for_small_grid(&mut hand);
    let to = folder.path().join("baked.hcbtf");
    hand.app_mut().answer_dialog(&to);
    hand.press("Bake to...");
    let grid = Grid { size: [4, 4], light: FEW, view: Directions { theta: 1, phi: 1 } };
    let setup =
        chiaro::frame::open(&path, None, &mut chiaro::frame::Assets::default()).unwrap().value;
    let setup = &setup.looks[0];
    let light = chiaro::frame::moving_light(setup, None).unwrap();
    let (library, assets) =
        (chiaro::library::Library::built_in(), chiaro::frame::Assets::default());
    let progress = Progress::new();
    let expected =
        chiaro::reference::bake_look(setup, library, grid, &light, &assets, &progress).unwrap();
    assert_eq!(hcbtf::load(&chiaro::files::Disk, &to).unwrap().value, expected);
    assert_eq!(hcbtf(&hand), &expected, "and it is open");
    let tones: std::collections::BTreeSet<u8> =
        expected.painted.values().map(|tile| tile.bytes()[0]).collect();
    assert!(tones.len() > 1, "the light is seen: {tones:?}");
    assert!(hand.app().message().unwrap().contains("4 samples"), "{:?}", hand.app().message());
}

#[test]
fn a_texture_leaves_as_it_is_to_be_stored_and_its_size_is_told_before() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = opened(&file(folder.path()));
    let filled = all(hcbtf(&hand));
    for (storage, name, code) in
        [("Quick", "quick", 0_u8), ("Compact", "compact", 8), ("Blocks", "blocks", 24)]
    {
        open_menu(&mut hand, "Export the painted surface as a KTX2 texture...");
        assert!(
            hand.says("the fewest reads")
                && hand.says("less memory, more reads")
                && hand.says("BC7")
        );
        let needs = hcbtf::needs(&filled.grid(), |address| filled.tile(address));
        let need =
            needs.iter().find(|need| need.has_levels && need.storage.word() == name).unwrap();
        assert!(hand.says(&chiaro::figures::bytes(need.bytes())), "{name}: {}", need.bytes());
        hand.press_a(Role::RadioButton, storage);
        let to = folder.path().join(format!("{name}.ktx2"));
        hand.app_mut().answer_dialog(&to);
        // Enter presses the button; the storage chosen before has lost the focus.
        match name {
            "quick" => hand.press("Export to..."),
            _ => hand.key(Key::Enter),
        }
        hand.settle();
        let texture = hcbtf::ktx2::read(&fs::read(&to).unwrap(), "texture").unwrap();
        assert_eq!(texture.bytes.len() as u64, need.bytes(), "{name} takes what was told");
        if code < 24 {
            assert_eq!(hcbtf::from_layers(&texture).unwrap().grid, GRID, "{name}");
        }
    }
    open_menu(&mut hand, "Export the painted surface as a KTX2 texture...");
    assert!(hand.says("nearly, not exactly"), "blocks are not the same samples");
    hand.key(Key::Escape);
    hand.settle();
    assert!(!hand.says("the fewest reads"), "Escape leaves it");
}

#[test]
fn what_will_be_baked_is_seen_and_counted_before() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = opened(&look(folder.path()));
    open_menu(&mut hand, "Bake this look onto a tile...");
    ask_for_small_grid(&mut hand);
    hand.settle();
    assert!(hand.says("4 samples will be painted, in about"));
    assert!(hand.has("Lit from straight above") && hand.has("Lit from halfway down"));
    hand.press("Cancel");
    // A look that cannot be baked tells so before the bake.
    let broken = folder.path().join("broken.json");
    let text = r#"{"chiaro": "look", "lights": {"key": {"direction": [0, 0, 1]}}, "nodes": [
        {"id": "picture", "kind": "image", "values": {"image": "nowhere.png"}},
        {"id": "output", "kind": "output"}],
        "wires": [{"from": "picture", "to": "output.color"}]}"#;
    fs::write(&broken, text).unwrap();
    hand.app_mut().open(&broken);
    hand.settle();
    open_menu(&mut hand, "Bake this look onto a tile...");
    hand.settle();
    assert!(!hand.says("will be painted, in about"));
}

#[test]
fn what_is_about_a_painting_cannot_be_chosen_without_one() {
    let mut hand = new_window();
    hand.press("Paint");
    for item in [
        "Save the painted surface",
        "Divide the painted surface otherwise...",
        "New tile from this painting...",
    ] {
        let node = hand.harness.get_by_role_and_label(Role::MenuItem, item);
        assert!(node.accesskit_node().is_disabled(), "{item}");
    }
    let node = hand
        .harness
        .get_by_role_and_label(Role::MenuItem, "Import painted pictures as a painted surface...");
    assert!(!node.accesskit_node().is_disabled());
    let at = hand.place("Save the painted surface").center();
    hand.hover(at);
    hand.harness.run_steps(8);
    assert!(hand.says("Nothing is open to be painted"));
}

#[test]
fn a_tile_that_is_no_square_keeps_its_shape_in_its_own_look() {
    let folder = tempfile::tempdir().unwrap();
    let hcbtf = Hcbtf::new(Grid { size: [8, 4], ..GRID });
    let hand = opened(&save(folder.path(), "long", &hcbtf));
    let scale = &hand.look().graph.nodes["painting"].values["scale"];
    // The texture repeats twice along u and four times along v: 16 texels each.
    assert_eq!(scale, &chiaro::document::Value::Vector(vec![2.0, 4.0]));
}

#[test]
fn baking_is_stopped_and_a_look_without_a_light_is_told_of() {
    let folder = tempfile::tempdir().unwrap();
    let path = look(folder.path());
    let mut hand = opened(&path);
    open_menu(&mut hand, "Bake this look onto a tile...");
    let to = folder.path().join("baked.hcbtf");
    hand.app_mut().answer_dialog(&to);
    let bake = hand.place("Bake to...").center();
    hand.click(bake);
    hand.harness.run_steps(3);
    assert!(hand.says("Baking baked.hcbtf"));
    let stop = hand.place("Stop").center();
    hand.click(stop);
    hand.settle();
    assert!(!to.exists() && !hand.says("Baking baked.hcbtf"));
    let dark = folder.path().join("dark.json");
    let text = r#"{"chiaro": "look", "nodes": [{"id": "base", "kind": "base"},
        {"id": "output", "kind": "output"}],
        "wires": [{"from": "base", "to": "output.color"}]}"#;
    fs::write(&dark, text).unwrap();
    hand.app_mut().open(&dark);
    hand.settle();
    open_menu(&mut hand, "Bake this look onto a tile...");
    assert!(hand.says("no directional light that could go around"));
}

#[test]
fn pictures_are_imported_beside_the_window() {
    let folder = tempfile::tempdir().unwrap();
    let images = folder.path().join("images");
    let source = hcbtf::load(&chiaro::files::Disk, &numbered(folder.path())).unwrap().value;
    let form = hcbtf::exchange::ExchangeFormat::Folder;
    let options = hcbtf::exchange::ExportOptions::default();
    hcbtf::exchange::export(&all(&source), form, options, &images, &Progress::new()).unwrap();
    let mut hand = new_window();
    let ask = |hand: &mut User| {
        open_menu(hand, "Import painted pictures as a painted surface...");
        for (field, text) in [
            ("Lights: rings", "2"),
            ("Lights: steps", "3"),
            ("Views: rings", "2"),
            ("Views: steps", "3"),
        ] {
            type_into(hand, field, text);
        }
        hand.app_mut().answer_dialog(&images);
    };
    ask(&mut hand);
    hand.press("Choose them...");
    // The exported folder holds which sample was painted, and the rules that fill the rest.
    assert!(*hcbtf(&hand) == source);
    assert!(hand.app().message().unwrap().starts_with("1 of 16 samples are painted"));
}
