//! Parts of the painting workspace, driven by pointer and keys: symmetry, a pen's pressure, the
//! palette's wheel, the hemisphere, onion skin, a look at another sample, the sheet of all samples;
//! and files that other programs change.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::editor_support::User;
use crate::editor_support::painting::{hcbtf, opened};
use chiaro::document::{Address, Directions, Edit, GraphId, Grid, Hcbtf, Tile, Value};
use chiaro::editor::App;
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers, Pos2, TouchDeviceId, TouchId, TouchPhase, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};

const GRID: Grid = Grid {
    size: [8, 8],
    light: Directions { theta: 3, phi: 4 },
    view: Directions { theta: 3, phi: 4 },
};
const GRAY: [u8; 4] = [90, 90, 90, 255];
const RED: [u8; 4] = [220, 20, 20, 255];

/// A file with samples of one color each.
fn file(folder: &Path, samples: &[([u32; 2], [u32; 2], [u8; 4])]) -> PathBuf {
    let path = folder.join("surface.hcbtf");
    write(&path, samples);
    path
}

fn write(path: &Path, samples: &[([u32; 2], [u32; 2], [u8; 4])]) {
    let mut hcbtf = Hcbtf::new(GRID);
    for (light, view, color) in samples {
        hcbtf
            .painted
            .insert(Address::new(*light, *view), Arc::new(Tile::filled(GRID.size, *color)));
    }
    fs::write(path, chiaro::hcbtf::write(&hcbtf).unwrap()).unwrap();
}

fn at_work(hand: &User) -> Address {
    hand.app().session().painting().unwrap().at()
}

fn first(hand: &User) -> &Tile {
    hcbtf(hand).painted(Address::default()).unwrap()
}

fn texel(hand: &User, x: i32, y: i32) -> Pos2 {
    hand.app().painting().screen([f64::from(x) + 0.5, f64::from(y) + 0.5]).unwrap()
}

fn cell(hand: &User, light: [u32; 2], view: [u32; 2]) -> Pos2 {
    hand.app().painting().cell(Address::new(light, view)).unwrap().center()
}

fn brush(hand: &mut User, size: &str) {
    for (label, text) in [("Size", size), ("Hardness", "100")] {
        let field = hand.place_of(Role::SpinButton, label);
        hand.type_over(field, text);
    }
}

fn changed(tile: &Tile) -> Vec<[i64; 2]> {
    let all = (0..8).flat_map(|y| (0..8).map(move |x| [x, y]));
    all.filter(|[x, y]| tile.texel(*x, *y) != GRAY).collect()
}

fn dot(hand: &mut User, x: i32, y: i32) {
    let at = texel(hand, x, y);
    hand.drag(at, at + vec2(0.5, 0.0));
    hand.settle();
}

const ABOVE: ([u32; 2], [u32; 2], [u8; 4]) = ([0, 0], [0, 0], GRAY);

#[test]
fn symmetry_paints_on_both_sides() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = opened(&file(folder.path(), &[ABOVE]));
    brush(&mut hand, "1");
    hand.press("Symmetry");
    hand.press("Mirror left and right");
    hand.key(Key::Escape);
    assert!(hand.has("Symmetry: on"));
    dot(&mut hand, 1, 2);
    assert_eq!(changed(first(&hand)), [[1, 2], [6, 2]]);
    assert_eq!(hand.steps(), 1);
}

#[test]
fn clicks_that_are_over_within_a_frame_paint_and_fill_and_each_is_a_step() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = opened(&file(folder.path(), &[ABOVE]));
    brush(&mut hand, "1");
    let [one, two, three] = [(1, 2), (5, 6), (2, 6)].map(|(x, y)| texel(&hand, x, y));
    hand.quick_clicks(&[one]);
    hand.settle();
    assert_eq!((changed(first(&hand)), hand.steps()), (vec![[1, 2]], 1));
    hand.quick_clicks(&[two, three]);
    hand.settle();
    assert_eq!((changed(first(&hand)), hand.steps()), (vec![[1, 2], [2, 6], [5, 6]], 3));
    hand.undo();
    assert_eq!(changed(first(&hand)), [[1, 2], [5, 6]]);
    hand.hover(one);
    hand.key(Key::G);
    hand.press("Color #f7db4b");
    hand.quick_clicks(&[texel(&hand, 7, 0)]);
    hand.settle();
    assert_eq!((first(&hand).texel(7, 0), hand.steps()), ([0xf7, 0xdb, 0x4b, 255], 3));
    // A quick press that moves far is a stroke.
    let far = texel(&hand, 4, 2);
    hand.key(Key::B);
    hand.hover(one);
    let button = |pos, pressed| Event::PointerButton {
        pos,
        button: eframe::egui::PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    let events = &mut hand.harness.input_mut().events;
    events.extend([button(one, true), Event::PointerMoved(far), button(far, false)]);
    hand.harness.run_steps(3);
    hand.settle();
    let yellow = [0xf7, 0xdb, 0x4b, 255];
    assert!((1..=4).all(|x| first(&hand).texel(x, 2) == yellow) && hand.steps() == 4);
}

#[test]
fn arrows_lead_off_the_place_straight_above() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = opened(&file(folder.path(), &[ABOVE]));
    let at = texel(&hand, 4, 4);
    hand.hover(at);
    hand.key(Key::ArrowRight);
    assert_eq!(at_work(&hand), Address::new([0, 0], [1, 1]), "a quarter from v toward u");
    hand.key(Key::ArrowUp);
    hand.key_with(Modifiers::SHIFT, Key::ArrowLeft);
    assert_eq!(at_work(&hand), Address::new([1, 3], [0, 0]));
}

#[test]
fn a_pen_that_is_pressed_lightly_paints_less() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = opened(&file(folder.path(), &[ABOVE]));
    brush(&mut hand, "6");
    hand.press("Pen");
    hand.press_a(Role::RadioButton, "Size");
    hand.key(Key::Escape);
    let mut counts = Vec::new();
    for force in [0.2, 0.6, 1.0] {
        let at = texel(&hand, 4, 4);
        let touch = |phase| Event::Touch {
            device_id: TouchDeviceId(1),
            id: TouchId(1),
            phase,
            pos: at,
            force: Some(force),
        };
        // A tablet reports both the pen and the pointer that the pen moves.
        hand.hover(at);
        hand.harness.event(touch(TouchPhase::Start));
        hand.hold(at);
        hand.harness.event(touch(TouchPhase::Move));
        hand.move_to(at + vec2(0.5, 0.0));
        hand.harness.event(touch(TouchPhase::End));
        hand.release(at);
        hand.settle();
        counts.push(changed(first(&hand)).len());
        hand.undo();
        hand.settle();
        assert!(changed(first(&hand)).is_empty());
    }
    assert!(counts[0] > 0 && counts.windows(2).all(|pair| pair[0] < pair[1]), "{counts:?}");
}

#[test]
fn the_wheel_over_the_palette_changes_the_value_and_not_the_hue() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = opened(&file(folder.path(), &[ABOVE]));
    brush(&mut hand, "1");
    hand.press("Color #d93a2f");
    let swatch = hand.place("Color #d93a2f").center();
    hand.wheel(swatch, -200.0);
    dot(&mut hand, 3, 3);
    let [r, g, b, a] = first(&hand).texel(3, 3);
    assert!(a == 255 && (90..0xd9).contains(&r), "darker: {r} {g} {b}");
    // The hue and the saturation are those of #d93a2f.
    let part = |channel: u8, of: u8| f64::from(channel) / f64::from(of);
    assert!(
        (part(g, r) - part(0x3a, 0xd9)).abs() < 0.02
            && (part(b, r) - part(0x2f, 0xd9)).abs() < 0.02,
        "{r} {g} {b}"
    );
}

#[test]
fn light_and_eye_are_dragged_over_the_tile() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = opened(&file(folder.path(), &[ABOVE]));
    hand.tab("Light and eye");
    let dome = hand.place("Light and eye over the tile");
    let (middle, radius) = (dome.center(), dome.width() / 2.0 - 12.0);
    // The sun to the right rim: toward u, at the horizon. The eye was in the middle with the sun
    // and stays there.
    hand.drag(middle, middle + vec2(radius, 0.0));
    hand.settle();
    assert_eq!(at_work(&hand), Address::new([2, 1], [0, 0]));
    // The eye halfway down to the rim: toward -v, on the second ring.
    hand.drag(middle, middle + vec2(0.0, radius / 2.0));
    hand.settle();
    assert_eq!(at_work(&hand), Address::new([2, 1], [1, 2]));
    // A drag beyond the rim ends at the horizon.
    let eye = middle + vec2(0.0, radius / 2.0);
    hand.drag(eye, eye + vec2(0.0, radius * 1.2));
    hand.settle();
    assert_eq!(at_work(&hand), Address::new([2, 1], [2, 2]));
    assert!(
        !hand.app().session().painting().unwrap().is_dirty() && hand.steps() == 0,
        "to look about is no step"
    );
}

/// The color on the screen in the middle of the tile.
fn middle(hand: &mut User) -> [u8; 4] {
    // A place away from the arrows and the brush.
    let at = texel(hand, 6, 6);
    let image = hand.harness.render().unwrap();
    image.get_pixel(at.x as u32, at.y as u32).0
}

fn near(a: [u8; 4], b: [u8; 4]) -> bool {
    a.iter().zip(b).all(|(a, b)| a.abs_diff(b) <= 3)
}

#[test]
fn neighbors_shine_through_and_others_are_looked_at_without_being_left() {
    let folder = tempfile::tempdir().unwrap();
    let blue = [20, 40, 220, 255];
    let samples = [
        ABOVE,
        ([0, 0], [1, 0], GRAY),
        ([0, 0], [1, 1], RED),
        ([0, 0], [1, 3], RED),
        ([2, 2], [0, 0], blue),
    ];
    let path = file(folder.path(), &samples);
    let mut hand = User::drawing_with(|app, _| app.without_dialogs());
    hand.app_mut().open(&path);
    hand.settle();
    let to = cell(&hand, [0, 0], [1, 0]);
    hand.click(to);
    hand.settle();
    hand.press("Arrows");
    assert!(near(middle(&mut hand), GRAY));
    // Half of the onion skin: the red of both sides over the gray.
    let slider = hand.place_of(Role::Slider, "Onion skin");
    hand.click(slider.right_center() - vec2(6.0, 0.0));
    hand.settle();
    let [r, g, ..] = middle(&mut hand);
    assert!(r > 130 && g < 70, "{r} {g}");
    // Along the light the sample has no painted neighbors.
    hand.choose("neighbors by", "Light's way around");
    assert!(near(middle(&mut hand), GRAY));

    // Alt over the map shows another sample while Alt is held.
    let work = at_work(&hand);
    let other = cell(&hand, [2, 2], [0, 0]);
    hand.hover(other);
    hand.harness.event(Event::ModifiersChanged(Modifiers::ALT));
    hand.harness.run_steps(3);
    assert!(near(middle(&mut hand), blue), "{:?}", middle(&mut hand));
    assert_eq!(at_work(&hand), work);
    hand.harness.event(Event::ModifiersChanged(Modifiers::NONE));
    hand.harness.run_steps(3);
    assert!(near(middle(&mut hand), GRAY));
    // V over the tile shows the sample that was at work before.
    hand.click(other);
    hand.settle();
    assert!(near(middle(&mut hand), blue));
    let on_tile = texel(&hand, 2, 2);
    hand.hover(on_tile);
    hand.harness.key_down(Key::V);
    hand.harness.run_steps(3);
    assert!(near(middle(&mut hand), GRAY));
    hand.harness.key_up(Key::V);
    hand.harness.run_steps(3);
    assert!(near(middle(&mut hand), blue));
}

/// The sheet's text about the texel under the pointer.
fn told(hand: &User) -> String {
    let sheet = hand.harness.get_by_label("Sheet of all samples");
    sheet.accesskit_node().value().unwrap_or_default()
}

#[test]
fn the_sheet_tells_what_lies_where_and_leads_there() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = opened(&file(folder.path(), &[ABOVE, ([2, 1], [1, 3], RED)]));
    hand.press("View");
    hand.press_a(Role::CheckBox, "Sheet");
    hand.key(Key::Escape);
    let sample = Address::new([2, 1], [1, 3]);
    let on_sheet = |hand: &User| hand.app().painting().on_sheet(sample, [5, 6]).unwrap();
    // Zooms in until the texel can be hit; the point under the pointer stays there.
    for _ in 0..4 {
        let at = on_sheet(&hand);
        hand.wheel(at, 300.0);
        assert!(on_sheet(&hand).distance(at) < 0.6, "{at:?} went to {:?}", on_sheet(&hand));
    }
    let at = on_sheet(&hand);
    hand.hover(at);
    let lines = "Texel 5, 6: #dc1414, 100%, painted\nLight ring 2, step 1: 90° down, 90° \
                 around\nEye ring 1, step 3: 45° \
                 down, 270° around";
    assert_eq!(told(&hand), lines);
    assert_eq!(at_work(&hand), Address::default());
    hand.click(at);
    hand.settle();
    assert_eq!(at_work(&hand), sample);
    // A drag moves the sheet and leaves the sample at work.
    hand.drag(at, at + vec2(40.0, -30.0));
    hand.settle();
    assert!(on_sheet(&hand).distance(at + vec2(40.0, -30.0)) < 1.0);
    assert_eq!(at_work(&hand), sample);
    hand.press("Fit");
    let [left, right] = [[0, 0], [7, 7]]
        .map(|texel| hand.app().painting().on_sheet(Address::default(), texel).unwrap());
    let canvas = hand.place("Sheet of all samples");
    assert!(canvas.contains(left) && canvas.contains(right), "{left:?} {right:?} in {canvas:?}");
}

#[test]
fn panels_of_a_full_stack_are_within_reach_and_the_one_in_front_is_seen() {
    let folder = tempfile::tempdir().unwrap();
    let mut hand = opened(&file(folder.path(), &[ABOVE]));
    for panel in ["Samples", "Light and eye", "Fill rules"] {
        let tab = hand.place_of(Role::Tab, panel);
        assert!(tab.width() > 50.0 && tab.max.x < 1500.0, "{panel}: {tab:?}");
        let rules = hand.place_of(Role::Tab, "Inspector");
        assert!(
            panel != "Samples" || tab.max.x < rules.min.x,
            "{panel} is within its stack: {tab:?}"
        );
    }
    hand.tab("Keys");
    let keys = hand.place_of(Role::Tab, "Keys");
    assert!(keys.min.x >= 0.0 && keys.max.x < 500.0, "in view: {keys:?}");
    assert!(!hand.has("Map of samples"));
}

fn look_at_files(hand: &mut User) {
    hand.app_mut().look_at_files();
    hand.settle();
}

#[test]
fn a_file_that_another_program_paints_on_is_loaded_again_or_offered() {
    let folder = tempfile::tempdir().unwrap();
    let path = file(folder.path(), &[ABOVE]);
    let mut hand = opened(&path);
    let color = |hand: &User| first(hand).texel(0, 0);
    // Without unsaved work the file's version is loaded, as a step.
    write(&path, &[([0, 0], [0, 0], RED)]);
    look_at_files(&mut hand);
    assert_eq!(color(&hand), RED);
    assert!(hand.app().message().unwrap().contains("changed by another program and loaded again"));
    assert!(!hand.app().session().painting().unwrap().is_dirty() && hand.steps() == 1);
    hand.undo();
    assert_eq!(color(&hand), GRAY, "undo brings the other version back");
    hand.redo();

    // With an unsaved stroke both versions can be chosen, and neither overwrites the other.
    brush(&mut hand, "1");
    hand.press("Color #f7db4b");
    dot(&mut hand, 3, 3);
    let yellow = [0xf7, 0xdb, 0x4b, 255];
    write(&path, &[([0, 0], [0, 0], [1, 2, 3, 255]), ([1, 0], [0, 0], RED)]);
    look_at_files(&mut hand);
    assert!(hand.says("was changed by another program, and painted on by you"));
    assert_eq!(first(&hand).texel(3, 3), yellow);
    hand.key_with(Modifiers::COMMAND, Key::S);
    hand.settle();
    assert_eq!(
        chiaro::hcbtf::load(&chiaro::files::Disk, &path).unwrap().value.painted.len(),
        2,
        "theirs is there still"
    );
    hand.press("Load the file's version");
    assert_eq!((color(&hand), hcbtf(&hand).painted.len()), ([1, 2, 3, 255], 2));
    hand.undo();
    assert_eq!(first(&hand).texel(3, 3), yellow, "and mine comes back by undo");

    write(&path, &[([0, 0], [0, 0], [9, 9, 9, 255])]);
    look_at_files(&mut hand);
    hand.press("Keep mine");
    hand.key_with(Modifiers::COMMAND, Key::S);
    hand.settle();
    assert_eq!(
        chiaro::hcbtf::load(&chiaro::files::Disk, &path)
            .unwrap()
            .value
            .painted(Address::default())
            .unwrap()
            .texel(3, 3),
        yellow
    );
    assert!(!hand.says("painted on by you"));

    // A file that cannot be read changes nothing until it can; a removed file is written again by
    // saving.
    fs::write(&path, b"half of a").unwrap();
    look_at_files(&mut hand);
    assert!(hand.says("cannot be read now") && first(&hand).texel(3, 3) == yellow);
    write(&path, &[ABOVE]);
    look_at_files(&mut hand);
    assert!(!hand.says("cannot be read now") && color(&hand) == GRAY);
    fs::remove_file(&path).unwrap();
    look_at_files(&mut hand);
    assert!(hand.says("was removed or moved"));
    hand.press("Understood");
    assert!(!hand.says("was removed or moved"));
    dot(&mut hand, 5, 5);
    hand.key_with(Modifiers::COMMAND, Key::S);
    hand.settle();
    assert_eq!(
        chiaro::hcbtf::load(&chiaro::files::Disk, &path)
            .unwrap()
            .value
            .painted(Address::default())
            .unwrap()
            .texel(5, 5),
        yellow
    );
}

#[test]
fn what_has_a_file_now_never_goes_back_to_having_none() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.hcbtf");
    let mut hand = User::with(|ctx| App::new(ctx, None).without_dialogs());
    hand.press("Paint");
    hand.press("New painted surface, small (16 x 16, 3 x 6 directions)");
    // Two steps of the look before the painting is saved: another name, and back.
    let id = "painting";
    let named = |name: &str| Edit::SetValue {
        graph: GraphId::Look,
        id: id.into(),
        port: "sheet".into(),
        value: Value::Text(name.to_owned()),
        index: None,
    };
    hand.app_mut().session_mut().apply(named("other.hcbtf"), None).unwrap();
    hand.app_mut().session_mut().apply(named("hcbtf:open"), None).unwrap();
    hand.settle();
    let at = hand.app().painting().screen([8.0, 8.0]).unwrap();
    hand.drag(at, at + vec2(30.0, 0.0));
    hand.settle();
    hand.app_mut().answer_dialog(&path);
    hand.press("Paint");
    hand.press("Save the painted surface");
    assert!(path.is_file());
    assert_eq!(hand.steps(), 3, "to get a file is no step");
    let sheet = |hand: &User| hand.look().graph.nodes[id].values["sheet"].clone();
    let own = Value::Text(path.display().to_string());
    assert_eq!(sheet(&hand), own);
    let mut seen = Vec::new();
    while hand.app().session().steps().undo_label().is_some() {
        hand.undo();
        seen.push(sheet(&hand));
    }
    assert_eq!(seen, [own.clone(), Value::Text("other.hcbtf".to_owned()), own.clone()]);
    while hand.app().session().steps().redo_label().is_some() {
        hand.redo();
    }
    assert_eq!(sheet(&hand), own);
    // A look saved beside the HCBTF names it by a relative path.
    let look = folder.path().join("look.json");
    assert!(hand.app_mut().save_as(&look));
    assert_eq!(sheet(&hand), Value::Text("mine.hcbtf".to_owned()));
    assert!(!fs::read_to_string(&look).unwrap().contains(folder.path().to_str().unwrap()));
    assert!(!hand.app().session().is_look_dirty());
}
