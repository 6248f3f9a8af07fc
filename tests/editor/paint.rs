//! Painting an HCBTF in the window: strokes reach the file texel by texel, samples are copied and
//! deleted, rules fill the rest, and the picture shows every change at once.

use crate::editor_support;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::editor_support::User;
use crate::editor_support::home::Home;
use crate::editor_support::painting::{hcbtf, opened};
use chiaro::document::{Address, Directions, Grid, Hcbtf, Rule, Strokes, Tile};
use chiaro::editor::App;
use eframe::egui::{Key, Modifiers, Pos2, Role};
use egui_kittest::kittest::Queryable as _;

const GRID: Grid = Grid {
    size: [8, 8],
    light: Directions { theta: 3, phi: 4 },
    view: Directions { theta: 3, phi: 4 },
};
const GRAY: [u8; 4] = [90, 90, 90, 255];

/// A file with one painted sample, straight above, of one color.
fn file(folder: &Path, rules: Vec<Rule>) -> PathBuf {
    let mut hcbtf = Hcbtf { rules, ..Hcbtf::new(GRID) };
    hcbtf.painted.insert(Address::default(), Arc::new(Tile::filled(GRID.size, GRAY)));
    let path = folder.join("surface.hcbtf");
    fs::write(&path, chiaro::hcbtf::write(&hcbtf).unwrap()).unwrap();
    path
}

fn saved(path: &Path) -> Hcbtf {
    chiaro::hcbtf::load(&chiaro::files::Disk, path).unwrap().value
}

/// The middle of a texel on the screen.
fn texel(hand: &User, x: i32, y: i32) -> Pos2 {
    hand.app().painting().screen([f64::from(x) + 0.5, f64::from(y) + 0.5]).unwrap()
}

fn cell(hand: &User, light: [u32; 2], view: [u32; 2]) -> Pos2 {
    hand.app().painting().cell(Address::new(light, view)).unwrap().center()
}

fn small_hard_brush(hand: &mut User) {
    let size = hand.place_of(Role::SpinButton, "Size");
    hand.type_over(size, "1");
    let hardness = hand.place_of(Role::SpinButton, "Hardness");
    hand.type_over(hardness, "100");
}

/// Texels whose color is not the initial gray.
fn changed(tile: &Tile) -> Vec<[i64; 2]> {
    let all = (0..8).flat_map(|y| (0..8).map(move |x| [x, y]));
    all.filter(|[x, y]| tile.texel(*x, *y) != GRAY).collect()
}

fn go_to(hand: &mut User, light: [u32; 2], view: [u32; 2]) {
    hand.app_mut().session_mut().painting_mut().unwrap().go_to(Address::new(light, view));
    hand.settle();
}

#[test]
fn a_stroke_reaches_the_file_texel_by_texel_and_is_one_step() {
    let folder = tempfile::tempdir().unwrap();
    let path = file(folder.path(), Vec::new());
    let mut hand = opened(&path);
    small_hard_brush(&mut hand);
    hand.press("Color #d93a2f");
    let (from, to) = (texel(&hand, 1, 2), texel(&hand, 5, 2));
    hand.drag(from, to);
    hand.settle();
    hand.key_with(Modifiers::COMMAND, Key::S);
    hand.settle();
    let tile = saved(&path).painted(Address::default()).unwrap().clone();
    assert_eq!(changed(&tile), [[1, 2], [2, 2], [3, 2], [4, 2], [5, 2]]);
    assert_eq!(tile.texel(3, 2), [0xd9, 0x3a, 0x2f, 255]);
    assert_eq!(hand.steps(), 1, "one stroke is one step");
    assert!(!hand.app().session().painting().unwrap().is_dirty());
    hand.undo();
    assert!(changed(hcbtf(&hand).painted(Address::default()).unwrap()).is_empty());
    assert!(hand.app().session().painting().unwrap().is_dirty());
    hand.redo();
    hand.key_with(Modifiers::COMMAND, Key::S);
    hand.settle();
    assert_eq!(saved(&path).painted(Address::default()).unwrap(), &tile);
}

#[test]
fn a_copy_beside_the_tile_is_painted_on_as_the_tile_itself() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = opened(&file(folder.path(), Vec::new()));
    small_hard_brush(&mut hand);
    // A view aslant, and a texel beyond the left edge: on the copy beside the tile.
    go_to(&mut hand, [0, 0], [1, 1]);
    let at = texel(&hand, -1, 3);
    hand.drag(at, at + eframe::egui::vec2(0.5, 0.0));
    hand.settle();
    let tile =
        hcbtf(&hand).painted(Address::new([0, 0], [1, 1])).expect("an empty sample can be painted");
    assert!(tile.texel(7, 3)[3] > 0);
    assert_eq!(tile.bytes().chunks(4).filter(|texel| texel[3] > 0).count(), 1);
}

#[test]
fn tools_have_keys_and_a_line_is_straight() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = opened(&file(folder.path(), Vec::new()));
    small_hard_brush(&mut hand);
    let at = texel(&hand, 4, 4);
    hand.hover(at);
    hand.key(Key::L);
    let ends = [texel(&hand, 0, 7), texel(&hand, 3, 0), texel(&hand, 6, 7)];
    hand.drag_through(&ends);
    hand.settle();
    let line = changed(hcbtf(&hand).painted(Address::default()).unwrap());
    assert!(
        line.iter().all(|[_, y]| *y == 7) && line.len() == 7,
        "from where it began to where it ended: {line:?}"
    );
    hand.hover(at);
    hand.key(Key::G);
    hand.press("Color #f7db4b");
    hand.click(at);
    hand.settle();
    let tile = hcbtf(&hand).painted(Address::default()).unwrap();
    assert_eq!(tile.texel(4, 4), [0xf7, 0xdb, 0x4b, 255], "filled");
    assert_ne!(tile.texel(3, 7), [0xf7, 0xdb, 0x4b, 255], "the line is another color");
    hand.hover(at);
    hand.key(Key::E);
    hand.drag(at, at + eframe::egui::vec2(0.5, 0.0));
    hand.settle();
    assert_eq!(hcbtf(&hand).painted(Address::default()).unwrap().texel(4, 4)[3], 0, "erased");
    assert!(!hand.app().probe().is_on());
    hand.hover(at);
    hand.key(Key::ArrowDown);
    hand.key_with(Modifiers::SHIFT, Key::ArrowDown);
    assert_eq!(hand.app().session().painting().unwrap().at(), Address::new([1, 0], [1, 0]));
}

#[test]
fn samples_are_copied_and_deleted_and_nothing_else_changes() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = opened(&file(folder.path(), Vec::new()));
    let to = cell(&hand, [2, 1], [1, 3]);
    hand.click(to);
    hand.settle();
    let there = Address::new([2, 1], [1, 3]);
    assert_eq!(hand.app().session().painting().unwrap().at(), there);
    // A click with Shift copies the clicked sample to the sample at work, and does not go there.
    let first = cell(&hand, [0, 0], [0, 0]);
    hand.click_with(Modifiers::SHIFT, first);
    hand.settle();
    assert_eq!(hcbtf(&hand).painted(there), hcbtf(&hand).painted(Address::default()));
    assert_eq!(hcbtf(&hand).painted.len(), 2);
    // The camera and the lights of the picture turn to the eye and the light of the sample at work:
    // the eye is 45 degrees high.
    hand.press("Show in the picture");
    let orbit = hand.app().session().view().orbit();
    assert!(editor_support::close(orbit.pitch, std::f64::consts::FRAC_PI_4), "{orbit:?}");
    hand.press("Delete painting");
    assert_eq!(hcbtf(&hand).painted.len(), 1);
    assert!(hcbtf(&hand).painted(there).is_none());
    hand.undo();
    assert_eq!(hcbtf(&hand).painted.len(), 2);
}

#[test]
fn a_rule_fills_the_map_and_a_filled_sample_is_painted_on_as_it_is_shown() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = opened(&file(folder.path(), Vec::new()));
    assert!(hand.has("80 empty"), "9 x 9 but for one");
    hand.press("+ Add a rule");
    hand.press_a(Role::MenuItem, "Copy");
    assert_eq!(hcbtf(&hand).rules, [Rule::Copy { from: Address::default() }]);
    assert!(hand.has("80 filled") && hand.has("0 empty"));
    small_hard_brush(&mut hand);
    go_to(&mut hand, [1, 2], [0, 0]);
    let at = texel(&hand, 6, 6);
    hand.drag(at, at + eframe::egui::vec2(0.5, 0.0));
    hand.settle();
    let tile = hcbtf(&hand).painted(Address::new([1, 2], [0, 0])).unwrap();
    assert_eq!(changed(tile), [[6, 6]], "the rest is what the rule filled");
    assert!(hand.has("79 filled"));
    hand.press("Remove rule 1");
    assert!(hcbtf(&hand).rules.is_empty() && hand.has("79 empty"));
    hand.undo();
    hand.settle();
    assert!(hand.has("79 filled"));
}

#[test]
fn strokes_begin_from_a_preset_and_are_changed_field_by_field() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = opened(&file(folder.path(), Vec::new()));
    hand.press("+ Add a rule");
    hand.press_a(Role::MenuItem, "Strokes");
    hand.settle();
    let strokes = |hand: &User| match &hcbtf(hand).rules[..] {
        [Rule::Strokes(strokes)] => Strokes::clone(strokes),
        other => panic!("{other:?}"),
    };
    assert_eq!(strokes(&hand), Strokes::preset("Grass"));
    assert!(hand.has("80 filled"));
    hand.press("Begin with");
    hand.press_a(Role::MenuItem, "Half-tone dots");
    hand.settle();
    assert_eq!(strokes(&hand), Strokes::preset("Half-tone dots"));
    hand.undo();
    hand.settle();
    assert_eq!(strokes(&hand), Strokes::preset("Grass"));
}

#[test]
fn a_new_one_is_saved_where_one_says_and_the_look_goes_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine");
    let mut hand = User::with(|ctx| App::new(ctx, None).with_path_fields());
    hand.press("Paint");
    hand.press("New painted surface, small (16 x 16, 3 x 6 directions)");
    let at = hand.app().painting().screen([8.0, 8.0]).unwrap();
    hand.drag(at, at + eframe::egui::vec2(30.0, 0.0));
    hand.settle();
    hand.app_mut().answer_dialog(&path.with_extension("hcbtf"));
    hand.key_with(Modifiers::COMMAND, Key::S);
    hand.settle();
    let hcbtf = saved(&path.with_extension("hcbtf"));
    assert_eq!((hcbtf.painted.len(), hcbtf.rules.len()), (1, 1));
    let sheet = hand.look().graph.nodes.values().find_map(|node| {
        node.values
            .iter()
            .find(|(port, _)| port.as_str() == "sheet")
            .map(|(_, value)| value.clone())
    });
    let named = chiaro::document::Value::Text(path.with_extension("hcbtf").display().to_string());
    assert_eq!(sheet, Some(named), "the look shows the file from now on");
    assert!(
        !hand.app().session().is_dirty(),
        "nobody is asked about a look that only shows the painting"
    );
}

#[test]
fn unsaved_strokes_are_seen_in_the_picture() {
    let folder = tempfile::tempdir().unwrap();
    let path = file(folder.path(), vec![Rule::Copy { from: Address::default() }]);
    let mut hand = User::drawing_with(|app, _| app.without_dialogs());
    hand.app_mut().open(&path);
    hand.settle();
    let picture = |hand: &mut User| {
        let rect = hand.app().viewport().rect().unwrap();
        let image = hand.harness.render().unwrap();
        let (x, y) = (rect.center().x as u32 - 60, rect.center().y as u32 - 40);
        image::imageops::crop_imm(&image, x, y, 120, 80).to_image()
    };
    let before = picture(&mut hand);
    hand.press("Color #f7db4b");
    let (from, to) = (texel(&hand, 0, 3), texel(&hand, 7, 4));
    hand.drag(from, to);
    hand.settle();
    let after = picture(&mut hand);
    let is_yellow = |pixel: &image::Rgba<u8>| pixel[0] > 120 && pixel[1] > 100 && pixel[2] < 100;
    assert!(!before.pixels().any(is_yellow), "gray before");
    assert!(
        after.pixels().filter(|pixel| is_yellow(pixel)).count() > 200,
        "the surface shows the stroke"
    );
    assert_eq!(
        saved(&path).painted(Address::default()).unwrap().texel(3, 3),
        GRAY,
        "and the file is as it was"
    );
    hand.undo();
    hand.settle();
    assert!(!picture(&mut hand).pixels().any(is_yellow));
}

#[test]
fn a_window_that_is_closed_loses_no_stroke() {
    let home = Home::new();
    let path = home.file("surface.hcbtf");
    fs::rename(file(path.parent().unwrap(), Vec::new()), &path).unwrap();
    let mut hand = home.window(Some(&path));
    small_hard_brush(&mut hand);
    let (from, to) = (texel(&hand, 1, 2), texel(&hand, 5, 2));
    hand.drag(from, to);
    hand.settle();
    home.wait_until_written();
    let painted = hcbtf(&hand).clone();
    drop(hand);
    let mut hand = home.window(None);
    assert_eq!(hcbtf(&hand), &painted);
    assert!(hand.app().session().painting().unwrap().is_dirty());
    hand.undo();
    assert!(changed(hcbtf(&hand).painted(Address::default()).unwrap()).is_empty());
}

#[test]
fn what_others_did_to_the_file_of_a_recovered_painting_is_noticed() {
    let home = Home::new();
    let path = home.file("surface.hcbtf");
    fs::rename(file(path.parent().unwrap(), Vec::new()), &path).unwrap();
    let stroke = |hand: &mut User, y: i32| {
        small_hard_brush(hand);
        let (from, to) = (texel(hand, 1, y), texel(hand, 5, y));
        hand.drag(from, to);
        hand.settle();
        home.wait_until_written();
    };
    let look_at_files = |hand: &mut User| {
        hand.app_mut().look_at_files();
        hand.settle();
    };
    let conflict = "was changed by another program, and painted on by you";
    let mut hand = home.window(Some(&path));
    stroke(&mut hand, 2);
    let mine = hcbtf(&hand).clone();
    drop(hand);
    // No other program has changed the file: nothing is asked.
    let mut hand = home.window(None);
    look_at_files(&mut hand);
    assert!(hcbtf(&hand) == &mine && !hand.says(conflict));
    drop(hand);
    // Another program paints while no window is open.
    let mut theirs = Hcbtf::new(GRID);
    theirs
        .painted
        .insert(Address::new([1, 0], [0, 0]), Arc::new(Tile::filled(GRID.size, [1, 2, 3, 255])));
    fs::write(&path, chiaro::hcbtf::write(&theirs).unwrap()).unwrap();
    let mut hand = home.window(None);
    look_at_files(&mut hand);
    assert_eq!(hcbtf(&hand), &mine);
    assert!(hand.says(conflict));
    hand.key_with(Modifiers::COMMAND, Key::S);
    hand.settle();
    assert_eq!(saved(&path), theirs, "nothing is written over theirs");
    hand.press("Keep mine");
    home.wait_until_written();
    drop(hand);
    // The conflict was decided, and the decision is remembered.
    let mut hand = home.window(None);
    look_at_files(&mut hand);
    assert!(hcbtf(&hand) == &mine && !hand.says(conflict));
    hand.key_with(Modifiers::COMMAND, Key::S);
    hand.settle();
    assert_eq!(saved(&path), mine);
}

/// Opens an example from the start page.
fn show_example(hand: &mut User, name: &str) {
    hand.app_mut().show_start_page();
    hand.settle();
    let label = format!("Open the look {name}");
    hand.harness.get_by_label(&label).scroll_to_me();
    hand.settle();
    hand.press(&label);
}

/// A look that shows an example HCBTF in two nodes; the example has few samples.
fn look_with_example(folder: &Path) -> PathBuf {
    let path = folder.join("look.json");
    let text = r#"{"chiaro": "look", "lights": {"key": {"direction": [0, 0, 1]}}, "nodes": [
        {"id": "light", "kind": "light", "values": {"light": "key"}},
        {"id": "one", "kind": "hcbtf_lookup", "values": {"sheet": "example:hcbtf/halftone.hcbtf"}},
        {"id": "two", "kind": "hcbtf_lookup", "values": {"sheet": "example:hcbtf/halftone.hcbtf"}},
        {"id": "over", "kind": "blend"},
        {"id": "output", "kind": "output"}],
        "wires": [{"from": "light", "to": "one.light"}, {"from": "light", "to": "two.light"},
        {"from": "one", "to": "over.below"},
        {"from": "two", "to": "over.color"}, {"from": "over", "to": "output.color"}]}"#;
    fs::write(&path, text).unwrap();
    path
}

fn sheets(hand: &User) -> Vec<String> {
    let values = hand.look().graph.nodes.values().flat_map(|node| &node.values);
    let named = values.filter(|(port, _)| port.as_str() == "sheet").map(|(_, value)| match value {
        chiaro::document::Value::Text(name) => name.clone(),
        other => panic!("{other:?}"),
    });
    named.collect()
}

#[test]
fn an_example_is_painted_as_a_copy_that_keeps_its_name_and_is_seen_wherever_the_look_shows_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = look_with_example(folder.path());
    let mut hand = User::with(|ctx| App::new(ctx, None).with_path_fields());
    hand.app_mut().open(&path);
    hand.settle();
    hand.press("View");
    hand.press_a(Role::CheckBox, "Paint");
    hand.key(Key::Escape);
    hand.press("Paint a copy of halftone");
    let work = hand.app().session().painting().unwrap();
    assert!(!work.is_dirty() && work.path().is_none(), "nothing was painted yet");
    assert!(hand.says("halftone (copy of the example)"));
    assert!(hand.app().message().unwrap().contains("saving asks where"));
    // The look's two nodes look up the same sheet.
    assert_eq!(sheets(&hand), ["hcbtf:open", "hcbtf:open"]);
    assert_eq!(hand.steps(), 1);
    hand.key_with(Modifiers::COMMAND, Key::S);
    hand.settle();
    assert!(hand.says("Save the painting"), "the first save asks where");
    hand.key(Key::Enter);
    hand.settle();
    // The suggested name is the example's, beside the look.
    assert!(folder.path().join("halftone.hcbtf").is_file());
    hand.key_with(Modifiers::COMMAND, Key::S);
    hand.settle();
    assert_eq!(sheets(&hand), ["halftone.hcbtf", "halftone.hcbtf"]);
    let text = fs::read_to_string(path).unwrap();
    assert!(text.contains("\"halftone.hcbtf\"") && !text.contains("example:"), "{text}");
}

#[test]
fn the_panels_are_about_the_look_that_is_open() {
    let folder = tempfile::tempdir().unwrap();
    let path = file(folder.path(), Vec::new());
    let mut hand = opened(&path);
    assert!(hand.has("Painting canvas") && hand.has("80 empty"));
    let at = texel(&hand, 4, 4);
    hand.drag(at, at + eframe::egui::vec2(0.5, 0.0));
    hand.settle();
    let painted = hcbtf(&hand).clone();
    assert!(hand.app().session().steps().undo_label().is_some());
    show_example(&mut hand, "Half-tone metal");
    assert!(hand.has("Node canvas"), "the look's own panels are back");
    hand.press("View");
    hand.press_a(Role::CheckBox, "Paint");
    hand.key(Key::Escape);
    assert!(!hand.has("Painting canvas") && hand.says("surface.hcbtf is still open"));
    assert!(
        hand.has("Paint a copy of halftone") && !hand.has("80 empty"),
        "another look's samples are not its own"
    );
    assert_eq!(
        hand.app().session().steps().undo_label(),
        None,
        "nothing is taken back that nobody sees"
    );
    hand.key_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(hcbtf(&hand), &painted);
    hand.press("Back to surface.hcbtf");
    assert!(hand.app().session().steps().undo_label().is_some());
    assert!(hand.has("Painting canvas") && hand.has("80 empty"));
    hand.key_with(Modifiers::COMMAND, Key::N);
    hand.settle();
    hand.tab("Paint");
    assert!(hand.says("The open look shows no painting") && hand.has("Another grid..."));
    hand.press("Paint");
    hand.press("Close the painted surface");
    hand.press("Do not save");
    assert!(hand.has("The open look has no painting."));
}

#[test]
fn a_copy_of_an_example_is_no_change_and_is_gone_back_to_in_the_look_that_it_was_painted_in() {
    let home = Home::new();
    let mut hand = home.window(None);
    show_example(&mut hand, "Half-tone metal");
    hand.app_mut().show_on("shape:torus");
    hand.settle();
    hand.press("Paint");
    hand.press_a(Role::MenuItem, "Paint a copy of halftone");
    assert_eq!(sheets(&hand), ["hcbtf:open"]);
    let session = hand.app().session();
    assert!(
        !session.is_dirty() && !session.painting().unwrap().is_dirty() && !hand.says("changed")
    );
    assert!(hand.says("Half-tone metal, halftone (copy of the example)"), "both are told");
    let at = texel(&hand, 4, 4);
    hand.drag(at, at + eframe::egui::vec2(0.5, 0.0));
    hand.settle();
    let painted = hcbtf(&hand).clone();
    assert!(
        hand.says("Half-tone metal, halftone (copy of the example) changed"),
        "what changed is told"
    );
    let look = hand.look().clone();
    let seen = hand.app().session().view().orbit().clone();
    assert_eq!(seen.mesh, "shape:torus");

    hand.key_with(Modifiers::COMMAND, Key::N);
    hand.settle();
    hand.app_mut().show_on("shape:sphere");
    assert!(!hand.says("Work that was not saved"), "all that was done is open");
    hand.press("Paint");
    assert!(!hand.says("Paint a copy of"), "this look shows none");
    hand.press_a(Role::MenuItem, "Back to halftone (copy of the example)");
    assert_eq!((hand.look(), hcbtf(&hand)), (&look, &painted));
    assert_eq!(hand.app().session().view().orbit().mesh, "shape:torus");
    assert!(hand.has("Painting canvas") && !hand.says("Work that was not saved"));

    // After a crash the painting comes back, with its look.
    hand.app().session().wait_for_journal();
    let later = home.after_a_crash();
    let mut hand = later.window(None);
    assert!(hand.says("halftone (copy of the example), 1 change"));
    hand.press("Restore it");
    assert_eq!((hand.look(), hcbtf(&hand)), (&look, &painted));
    assert!(hand.has("Painting canvas") && !hand.says("Work that was not saved"));
    // The painting also comes back after the window was closed.
    hand.app_mut().session_mut().close_journal(true);
    drop(hand);
    let hand = later.window(None);
    assert_eq!((hand.look(), hcbtf(&hand)), (&look, &painted));
    assert!(hand.has("Painting canvas"));
}

#[test]
fn after_a_crash_a_look_and_what_is_painted_in_it_come_back_whichever_is_asked_for_first() {
    let home = Home::new();
    let folder = home.file("work");
    fs::create_dir_all(&folder).unwrap();
    file(&folder, Vec::new());
    let path = look_with_example(&folder);
    let text =
        fs::read_to_string(&path).unwrap().replace("example:hcbtf/halftone.hcbtf", "surface.hcbtf");
    fs::write(&path, text).unwrap();
    let mut hand = home.window(Some(&path));
    hand.press("Paint");
    hand.press_a(Role::MenuItem, "Paint surface.hcbtf");
    let at = texel(&hand, 4, 4);
    hand.drag(at, at + eframe::egui::vec2(0.5, 0.0));
    hand.settle();
    let edit = chiaro::document::Edit::SetLookName { name: "worked on".to_owned() };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.settle();
    assert!(hand.says("look.json changed, surface.hcbtf changed"));
    hand.app().session().wait_for_journal();
    let (look, painted) = (hand.look().clone(), hcbtf(&hand).clone());

    for first in ["look.json, 1 change", "surface.hcbtf, 1 change"] {
        let later = home.after_a_crash();
        let mut hand = later.window(None);
        assert!(hand.says("Work that was not saved, of 2 documents"), "{first}");
        hand.press("Choose...");
        let row = hand.place_like(first).center().y;
        let restores =
            hand.harness.query_all_by_label("Restore it").map(|node| node.rect().center());
        let restore = restores
            .into_iter()
            .min_by(|a, b| (a.y - row).abs().total_cmp(&(b.y - row).abs()))
            .unwrap();
        hand.click(restore);
        hand.settle();
        if first.starts_with("look") {
            assert!(hand.says("Work that was not saved: surface.hcbtf, 1 change"));
            hand.press("Restore it");
        }
        assert_eq!((hand.look(), hcbtf(&hand)), (&look, &painted), "{first}");
        assert_eq!(hand.app().session().path(), Some(path.as_path()), "{first}");
        assert!(
            hand.says("look.json changed, surface.hcbtf changed") && hand.has("Painting canvas"),
            "{first}"
        );
        assert!(!hand.says("Work that was not saved"), "{first}");
    }
}

#[test]
fn an_untouched_copy_is_closed_without_a_trace() {
    let home = Home::new();
    let mut hand = home.window(None);
    show_example(&mut hand, "Half-tone metal");
    hand.press("Paint");
    hand.press_a(Role::MenuItem, "Paint a copy of halftone");
    hand.press("Paint");
    hand.press("Close the painted surface");
    assert!(!hand.has("Do not save") && hand.app().session().painting().is_none());
    assert_eq!(sheets(&hand), ["example:hcbtf/halftone.hcbtf"]);
    assert!(!hand.says("changed") && hand.has("Node canvas"), "the graph is back");
    hand.press("Paint");
    assert!(hand.has("Paint a copy of halftone"));
}

#[test]
fn what_a_look_of_two_shows_is_chosen_and_the_other_panels_tell_of_it() {
    let folder = tempfile::tempdir().unwrap();
    file(folder.path(), Vec::new());
    let path = look_with_example(folder.path());
    let text = fs::read_to_string(&path).unwrap().replacen(
        "example:hcbtf/halftone.hcbtf",
        "surface.hcbtf",
        1,
    );
    fs::write(&path, text).unwrap();
    let mut hand = opened(&path);
    hand.press("View");
    hand.press_a(Role::CheckBox, "Fill rules");
    hand.key(Key::Escape);
    hand.tab("Fill rules");
    assert!(
        hand.says(
            "The open look shows halftone and surface.hcbtf, which are not open to be painted"
        )
    );
    hand.press("Paint");
    assert!(hand.has("Paint a copy of halftone"));
    hand.press_a(Role::MenuItem, "Paint surface.hcbtf");
    assert_eq!(hand.app().session().path(), Some(path.as_path()), "the look stays");
    assert!(
        hand.has("Painting canvas")
            && hand.says("look.json, surface.hcbtf")
            && !hand.says("changed")
    );
    hand.press("Paint");
    assert!(hand.has("Paint a copy of halftone") && hand.has("Go on painting surface.hcbtf"));
    assert!(!hand.has("Paint surface.hcbtf"));
    hand.tab("Graph");
    hand.press("Paint");
    hand.press_a(Role::MenuItem, "Go on painting surface.hcbtf");
    assert!(
        hand.has("Painting canvas") && hand.app().session().painting().unwrap().path().is_some()
    );
}

#[test]
fn a_look_that_names_what_has_no_file_is_saved_after_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = look_with_example(folder.path());
    let mut hand = User::with(|ctx| App::new(ctx, None).without_dialogs());
    hand.app_mut().open(&path);
    hand.settle();
    hand.press("Paint");
    hand.press_a(Role::MenuItem, "Paint a copy of halftone");
    // Neither document has been changed by hand, and the look names the copy.
    let painting = folder.path().join("mine.hcbtf");
    hand.app_mut().answer_dialog(&painting);
    hand.key_with(Modifiers::COMMAND, Key::S);
    hand.settle();
    assert!(
        painting.is_file() && hand.says("look.json changed, mine.hcbtf"),
        "which of them is not saved is told"
    );
    hand.key_with(Modifiers::COMMAND, Key::S);
    hand.settle();
    assert!(fs::read_to_string(&path).unwrap().contains("\"mine.hcbtf\"") && !hand.says("changed"));
}

#[test]
fn a_sample_is_marked_in_the_picture_of_any_mesh_and_turned_to() {
    let folder = tempfile::tempdir().unwrap();
    let path = file(folder.path(), vec![Rule::Copy { from: Address::default() }]);
    let mut hand = User::drawing_with(|app, _| app.without_dialogs());
    hand.app_mut().open(&path);
    hand.app_mut().show_on("shape:sphere");
    hand.settle();
    let marked = |hand: &mut User| {
        let rect = hand.app().viewport().rect().unwrap();
        let image = hand.harness.render().unwrap();
        let is_marked = |x: u32, y: u32| {
            let [r, g, b, _] = image.get_pixel(x, y).0;
            r > 90 && b > 60 && i32::from(r) - i32::from(g) > 60 && i32::from(b) - i32::from(g) > 30
        };
        let all = (rect.min.y as u32..rect.max.y as u32)
            .flat_map(|y| (rect.min.x as u32..rect.max.x as u32).map(move |x| (x, y)));
        all.filter(|(x, y)| is_marked(*x, *y)).count()
    };
    let mesh = hand.app().session().view().orbit().mesh.clone();
    assert_eq!((mesh.as_str(), marked(&mut hand)), ("shape:sphere", 0));
    go_to(&mut hand, [1, 2], [1, 1]);
    hand.press("Show in the picture");
    assert_eq!(hand.app().session().view().orbit().mesh, "shape:plane");
    assert_eq!(marked(&mut hand), 0);
    hand.press("Where it shows");
    let found = marked(&mut hand);
    assert!(found > 2000, "the square is turned to the sample, and shows the mark: {found}");
    hand.press("Where it shows");
    assert_eq!(marked(&mut hand), 0, "nothing of it is painted");
    hand.press("Back to the mesh");
    assert_eq!(hand.app().session().view().orbit().mesh, mesh);
}

#[test]
fn the_inspector_paints_what_a_node_shows() {
    let folder = tempfile::tempdir().unwrap();
    file(folder.path(), Vec::new());
    let look = folder.path().join("look.json");
    let text = r#"{"chiaro": "look", "lights": {"key": {"direction": [0, 0, 1]}}, "nodes": [
        {"id": "light", "kind": "light", "values": {"light": "key"}},
        {"id": "paint", "kind": "hcbtf_lookup", "values": {"sheet": "surface.hcbtf"}},
        {"id": "output", "kind": "output"}],
        "wires": [{"from": "light", "to": "paint.light"},
        {"from": "paint", "to": "output.color"}]}"#;
    fs::write(&look, text).unwrap();
    let mut hand = opened(&look);
    hand.app_mut().session_mut().select(vec!["paint".into()]);
    hand.settle();
    let buttons: Vec<_> = {
        hand.harness
            .query_all_by_role_and_label(Role::Button, "Paint")
            .map(|node| node.rect())
            .collect()
    };
    let in_inspector = buttons.into_iter().max_by(|a, b| a.min.y.total_cmp(&b.min.y)).unwrap();
    hand.click(in_inspector.center());
    hand.settle();
    assert_eq!(hcbtf(&hand).painted.len(), 1);
    assert_eq!(hand.app().session().path(), Some(look.as_path()), "the look stays");
}
