//! Panels about all lights of a scene: the light table, the mixer, and links.

use std::fs;
use std::path::{Path, PathBuf};

use crate::editor_support::home::Home;
use crate::editor_support::{User, close, set_text};
use chiaro::document::{Light, Scene, Value};
use chiaro::editor::App;
use chiaro::frame::{Assets, open};
use eframe::egui::accesskit::Toggled;
use eframe::egui::{Event, Key, Modifiers, Pos2, Role, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use egui_kittest::wgpu::{WgpuTestRenderer, create_render_state, default_wgpu_setup};

/// Three lights of the scene in two groups; the looks have a key light besides.
const LIT: &str = r#"{
 "chiaro": "scene",
 "objects": [
  {"id": "ring", "mesh": "shape:torus", "transform": {"translate": [-1.2, 0, 0]},
  "looks": "looks/figure4-color.json"},
  {"id": "ball", "mesh": "shape:sphere", "transform": {"translate": [1.2, 0, 0]},
  "looks": "looks/figure6-minimal.json", "linked": "* - back"}
 ],
 "lights": {
  "back": {"direction": [0, 1, -1], "intensity": 2, "groups": ["rim", "set"]},
  "fill": {"type": "point", "position": [2, 1, 3], "intensity": 0.5, "groups": ["set"]},
  "edge": {"type": "spot", "intensity": 1, "groups": ["rim"]}
 },
 "camera": {"eye": [0, 0, 9]}
}"#;

/// Writes the scene with its looks into a folder.
fn lit_scene(home: &Home) -> PathBuf {
    let path = home.file("lit.json");
    fs::create_dir(home.file("looks")).unwrap();
    for name in ["figure4-color", "figure6-minimal"] {
        let look = format!("looks/{name}.json");
        fs::copy(format!("examples/{look}"), home.file(&look)).unwrap();
    }
    fs::write(&path, LIT).unwrap();
    path
}

/// A window with the scene, and with a panel opened.
fn lit_window(home: &Home, panel: &str) -> User {
    let mut hand = home.window(Some(&lit_scene(home)));
    show(&mut hand, panel);
    hand
}

/// Opens a panel by the menu of panels.
fn show(hand: &mut User, panel: &str) {
    hand.press("View");
    hand.press_a(Role::CheckBox, panel);
    hand.key(Key::Escape);
    hand.settle();
}

fn scene(hand: &User) -> &Scene {
    hand.app().session().open_scene().expect("one is open").scene()
}

fn light<'h>(hand: &'h User, id: &str) -> &'h Light {
    &scene(hand).lights[id]
}

fn at(hand: &User, cell: &str) -> Pos2 {
    hand.place_of(Role::Cell, cell).center()
}

/// Value of a cell in words, with where it comes from and what is left of it.
fn told(hand: &User, cell: &str) -> String {
    let cell = hand.harness.get_by_role_and_label(Role::Cell, cell);
    cell.accesskit_node().value().unwrap_or_default()
}

/// Types over the selected cells.
fn enter(hand: &mut User, text: &str) {
    hand.type_text(text);
    hand.key(Key::Enter);
    hand.settle();
}

#[test]
fn many_cells_of_lights_are_changed_in_one_step() {
    let home = Home::new();
    let mut hand = lit_window(&home, "Light table");
    let before = hand.steps();
    let from = at(&hand, "Intensity of back");
    hand.click(from);
    let to = at(&hand, "Intensity of edge");
    hand.click_with(Modifiers::SHIFT, to);
    hand.type_text("*9");
    hand.key(Key::Escape);
    hand.settle();
    assert_eq!(hand.steps(), before, "Escape gives up what was typed");
    enter(&mut hand, "*1.5");
    let intensities = |hand: &User| ["back", "fill", "edge"].map(|id| light(hand, id).intensity);
    assert_eq!(intensities(&hand), [3.0, 0.75, 1.5]);
    enter(&mut hand, "+0.25");
    assert_eq!(intensities(&hand), [3.25, 1.0, 1.75]);
    assert_eq!(hand.steps(), before + 2, "each is one step");
    hand.key_with(Modifiers::ALT, Key::ArrowUp);
    hand.key_with(Modifiers::ALT, Key::ArrowUp);
    hand.settle();
    assert!(close(light(&hand, "fill").intensity, 1.2), "nudged twice");
    assert_eq!(hand.steps(), before + 3, "nudges are one step");
    hand.key_with(Modifiers::COMMAND, Key::Z);
    hand.settle();
    hand.key_with(Modifiers::COMMAND, Key::Z);
    hand.settle();
    hand.key_with(Modifiers::COMMAND, Key::Z);
    hand.settle();
    assert_eq!((intensities(&hand), hand.steps()), ([2.0, 0.5, 1.0], before));
    // A cell is copied over others; a text that is no number changes nothing.
    let from = at(&hand, "Intensity of back");
    hand.click(from);
    hand.harness.event(Event::Copy);
    hand.settle();
    assert_eq!(hand.take_copied().as_deref(), Some("2"));
    let to = at(&hand, "Intensity of fill");
    hand.click(to);
    let to = at(&hand, "Intensity of edge");
    hand.click_with(Modifiers::COMMAND, to);
    hand.harness.event(Event::Paste("2".to_owned()));
    hand.settle();
    assert_eq!((intensities(&hand), hand.steps()), ([2.0; 3], before + 1));
    enter(&mut hand, "bright");
    assert!(hand.says("bright"), "what is no number is told");
    assert_eq!((intensities(&hand), hand.steps()), ([2.0; 3], before + 1));
    // Groups are added to all, and drags of the pointer select.
    let (from, to) = (at(&hand, "Groups of back"), at(&hand, "Groups of edge"));
    hand.drag(from, to);
    enter(&mut hand, "+night");
    let all = ["back", "fill", "edge"].map(|id| light(&hand, id).groups.len());
    assert_eq!(all, [3, 2, 2]);
}

#[test]
fn the_light_table_is_filtered_by_sets_and_sorted() {
    let home = Home::new();
    let mut hand = lit_window(&home, "Light table");
    let lights = |hand: &User| -> Vec<String> {
        let all = ["key", "back", "fill", "edge"];
        let mut shown: Vec<(f32, &str)> = all
            .into_iter()
            .filter_map(|id| {
                let cell = format!("Intensity of {id}");
                let found = hand.harness.query_by_role_and_label(Role::Cell, &cell)?;
                Some((found.rect().top(), id))
            })
            .collect();
        shown.sort_by(|a, b| a.0.total_cmp(&b.0));
        shown.into_iter().map(|(_, id)| id.to_owned()).collect()
    };
    assert_eq!(lights(&hand), ["back", "fill", "edge", "key"], "the looks' key light is inherited");
    set_text(&mut hand, "Filter of lights", "group:rim - edge");
    assert_eq!(lights(&hand), ["back"]);
    set_text(&mut hand, "Filter of lights", "group:rim - ");
    assert!(hand.says("a light or a group is missing"), "what is no set yet is told");
    set_text(&mut hand, "Filter of lights", "*");
    let head = hand.place_of(Role::ColumnHeader, "Sort by Intensity").center();
    hand.click(head);
    hand.settle();
    assert_eq!(lights(&hand)[0], "fill");
    hand.click(head);
    hand.settle();
    assert_eq!(lights(&hand)[0], "back");
}

#[test]
fn an_inherited_light_gets_one_of_the_scene_and_gives_it_back() {
    let home = Home::new();
    let mut hand = lit_window(&home, "Light table");
    let key = at(&hand, "Intensity of key");
    hand.click(key);
    assert_eq!(told(&hand, "Intensity of key"), "1, inherited");
    enter(&mut hand, "50%");
    assert_eq!(told(&hand, "Intensity of key"), "0.5");
    assert!(close(light(&hand, "key").intensity, 0.5));
    assert!(close(hand.look().lights["key"].intensity, 1.0), "the look's own is as it was");
    hand.key(Key::Delete);
    hand.settle();
    assert!(close(light(&hand, "key").intensity, 1.0), "as the look has it");
    hand.undo();
    hand.undo();
    assert!(!scene(&hand).lights.contains_key("key"));
    // Switches turn all selected rows, and a solo that is left on is told.
    let solo = at(&hand, "Solo of back");
    hand.click(solo);
    hand.settle();
    assert_eq!(scene(&hand).soloed.text(), "back");
    assert!(hand.says("back shines alone in the scene"));
    hand.press("End solo");
    assert!(scene(&hand).soloed.is_none());
    let off = at(&hand, "Shines of group rim");
    hand.click(off);
    hand.settle();
    assert_eq!(scene(&hand).muted.text(), "group:rim");
    assert_eq!(told(&hand, "Intensity of back"), "2, out");
    let master = at(&hand, "Intensity of group set");
    hand.click(master);
    enter(&mut hand, "0.5");
    assert_eq!(told(&hand, "Intensity of fill"), "0.5, 0.25 by the mix");
}

/// No effect of a light's own value where objects set what their look exposes of it.
#[test]
fn values_that_objects_set_themselves_are_told() {
    let mut hand = User::new();
    hand.app_mut().open(Path::new("examples/scenes/face-map.json"));
    hand.settle();
    let own = scene(&hand).objects.values().filter(|object| object.values.contains_key("light"));
    let count = own.count();
    show(&mut hand, "Light table");
    let text = told(&hand, "Direction of key");
    assert!(count > 20 && text.ends_with(&format!(", set by {count} objects")), "{text}");
    assert!(!told(&hand, "Intensity of key").contains("objects"));
}

#[test]
fn values_of_a_look_are_keyed_from_their_cells() {
    let mut hand = User::new();
    show(&mut hand, "Light table");
    let cell = at(&hand, "Intensity of key");
    hand.click(cell);
    hand.type_text("k");
    hand.settle();
    assert_eq!(hand.look().time_keys.len(), 1);
    assert_eq!(told(&hand, "Intensity of key"), "1, keyed");
    enter(&mut hand, "3");
    let keys = &hand.look().time_keys[0].keys;
    assert_eq!((keys.len(), &keys[0].value), (1, &chiaro::document::Value::Number(3.0)));
    assert!(close(hand.look().lights["key"].intensity, 1.0), "the key has it, not the light");
}

#[test]
fn values_of_a_scenes_lights_are_keyed_from_their_cells() {
    let home = Home::new();
    let mut hand = lit_window(&home, "Light table");
    let before = hand.steps();
    let (from, to) = (at(&hand, "Intensity of back"), at(&hand, "Intensity of fill"));
    hand.drag(from, to);
    hand.type_text("k");
    hand.settle();
    assert_eq!((scene(&hand).time_keys.len(), hand.steps()), (2, before + 1), "one step");
    assert_eq!(told(&hand, "Intensity of back"), "2, keyed");
    assert!(hand.look().time_keys.is_empty(), "they are the scene's");
    // The timeline has them; a value that is set at another time is another key.
    show(&mut hand, "Timeline");
    let key = hand.place("Time key 1 of back of the scene: Intensity").center();
    let ruler = hand.place("Playhead");
    hand.click(Pos2::new(key.x + 0.25 * ruler.width(), ruler.top() + 6.0));
    hand.settle();
    let time = hand.app().session().view().time();
    assert!(time > 0.1, "{time}");
    hand.tab("Light table");
    let cell = at(&hand, "Intensity of back");
    hand.click(cell);
    enter(&mut hand, "4");
    let track = &scene(&hand).time_keys[0];
    let values: Vec<_> = track.keys.iter().map(|key| &key.value).collect();
    assert_eq!(values, [&Value::Number(2.0), &Value::Number(4.0)]);
    assert!(close(light(&hand, "back").intensity, 2.0), "the keys have it, not the light");
    assert_eq!(told(&hand, "Intensity of back"), "4, keyed");
    for _ in 0..2 {
        hand.undo();
    }
    assert!(scene(&hand).time_keys.is_empty());
    // Lights has the diamond, with the same menu: keys by the view.
    hand.tab("Lights");
    let header = hand.harness.query_all_by_label_contains("back").count();
    assert!(header > 0);
}

#[test]
fn columns_of_the_light_table_are_remembered() {
    let home = Home::new();
    let mut hand = lit_window(&home, "Light table");
    let has = |hand: &User, head: &str| {
        hand.harness.query_by_role_and_label(Role::ColumnHeader, head).is_some()
    };
    assert!(has(&hand, "Sort by Groups"));
    hand.press("Columns");
    hand.press_a(Role::CheckBox, "Groups");
    hand.key(Key::Escape);
    hand.settle();
    assert!(!has(&hand, "Sort by Groups"));
    drop(hand);
    let mut hand = home.window(Some(&home.file("lit.json")));
    if hand.harness.query_by_role_and_label(Role::Tab, "Light table").is_some() {
        hand.tab("Light table");
    } else {
        show(&mut hand, "Light table");
    }
    assert!(has(&hand, "Sort by Intensity") && !has(&hand, "Sort by Groups"), "as it was left");
}

#[test]
fn lights_of_single_layers_are_said_for_an_object() {
    let home = Home::new();
    let mut hand = lit_window(&home, "Light table");
    let (id, node) = {
        let nodes = &hand.look().graph.nodes;
        let found = nodes.iter().find(|(_, node)| node.kind == "light_layer");
        let (id, node) = found.expect("the look has a layer");
        let name =
            if node.name.is_empty() { format!("Light layer ({id})") } else { node.name.clone() };
        (id.clone(), name)
    };
    hand.tab("Objects");
    hand.press_a(Role::ListItem, "Object ring");
    hand.harness.get_by_label("Lights of its layers").scroll_to_me();
    hand.settle();
    hand.press("Lights of its layers");
    hand.bring(Role::Button, "Add a layer's lights");
    let before = hand.steps();
    hand.press("Add a layer's lights");
    hand.press(&node);
    assert_eq!(scene(&hand).objects["ring"].layers.len(), 1);
    hand.bring(Role::TextInput, "Not reached by");
    set_text(&mut hand, "Not reached by", "group:rim");
    hand.key(Key::Enter);
    hand.settle();
    let row = &scene(&hand).objects["ring"].layers[0];
    assert_eq!((&row.node, row.unlayered.text()), (&id, "group:rim"));
    assert_eq!(row.layered.text(), "{source}");
    hand.bring(Role::Button, &format!("{node} as the look has it"));
    hand.press(&format!("{node} as the look has it"));
    assert!(scene(&hand).objects["ring"].layers.is_empty());
    while hand.steps() > before {
        hand.undo();
    }
    assert!(scene(&hand).objects["ring"].layers.is_empty());
}

#[test]
fn a_fader_of_the_mixer_is_one_step() {
    let home = Home::new();
    let mut hand = lit_window(&home, "Mixer");
    let before = hand.steps();
    let fader = hand.place_of(Role::Slider, "Fader of group rim");
    hand.drag(fader.center(), fader.center() + vec2(0.0, fader.height() * 0.25));
    hand.settle();
    let dimmed = scene(&hand).light_groups["rim"].intensity;
    assert!((0.05..0.6).contains(&dimmed), "a quarter of the way down is {dimmed}");
    assert_eq!(hand.steps(), before + 1);
    hand.undo();
    assert!(scene(&hand).light_groups.is_empty());
    hand.press("Solo group rim");
    assert!(hand.says("shine alone in the scene"), "a solo that is left on is told");
}

/// A note of a solo comes below: a second click meets what the first one met.
#[test]
fn a_second_click_ends_the_solo_of_the_first() {
    let home = Home::new();
    let mut hand = lit_window(&home, "Light table");
    let solo = at(&hand, "Solo of edge");
    hand.click(solo);
    hand.settle();
    assert_eq!(scene(&hand).soloed.text(), "edge");
    assert!(hand.says("shines alone in the scene"));
    assert_eq!(at(&hand, "Solo of edge"), solo, "nothing moved");
    hand.click(solo);
    hand.settle();
    assert!(scene(&hand).soloed.is_none() && scene(&hand).muted.is_none());
}

/// True if a row's mark says that it is linked to what is selected at the other side.
fn is_linked(hand: &User, row: &str) -> bool {
    let label = format!("{row} is linked");
    let node = hand.harness.get_by_role_and_label(Role::CheckBox, &label);
    node.accesskit_node().toggled() == Some(Toggled::True)
}

#[test]
fn lights_and_objects_are_linked_from_both_sides() {
    let home = Home::new();
    let mut hand = lit_window(&home, "Links");
    hand.press_a(Role::ListItem, "Link light back");
    assert_eq!(["object ring", "object ball"].map(|row| is_linked(&hand, row)), [true, false]);
    let ball = hand.harness.get_by_role_and_label(Role::ListItem, "Link object ball");
    let rule = ball.accesskit_node().value().unwrap_or_default();
    assert_eq!(rule, "`linked` (`* - back`) has it not");
    hand.press_a(Role::CheckBox, "object ball is linked");
    assert_eq!(scene(&hand).objects["ball"].linked.text(), "*");
    // The other way: what lights the ring, and what does not.
    hand.press_a(Role::ListItem, "Link light back");
    hand.press_a(Role::ListItem, "Link object ring");
    hand.press_a(Role::ListItem, "Link group rim");
    hand.press_a(Role::Button, "Unlink");
    assert_eq!(scene(&hand).objects["ring"].linked.text(), "* - group:rim");
    let rows = ["light back", "light edge", "light fill", "group rim"];
    assert_eq!(rows.map(|row| is_linked(&hand, row)), [false, false, true, false]);
    set_text(&mut hand, "Set of lights", "group:set & group:rim");
    hand.press_a(Role::Button, "Append");
    let text = "* - group:rim | (group:set & group:rim)";
    assert_eq!(scene(&hand).objects["ring"].linked.text(), text);
    assert_eq!(rows.map(|row| is_linked(&hand, row)), [true, false, true, false]);
    hand.press_a(Role::Button, "Replace");
    assert_eq!(scene(&hand).objects["ring"].linked.text(), "group:set & group:rim");
    // Shadows are links of their own.
    hand.press("Shadows");
    hand.press_a(Role::CheckBox, "light fill is linked");
    let ring = &scene(&hand).objects["ring"];
    assert_eq!((ring.shadowed.text(), ring.linked.text()), ("* - fill", "group:set & group:rim"));
}

#[test]
fn the_links_that_are_shown_are_those_of_the_command_line() {
    let home = Home::new();
    let mut hand = lit_window(&home, "Links");
    let setup = open(&home.file("lit.json"), None, &mut Assets::default()).unwrap().value;
    let reach = setup.light_reach();
    assert_eq!(reach.len(), 8);
    for object in ["ring", "ball"] {
        hand.press_a(Role::ListItem, &format!("Link object {object}"));
        for found in reach.iter().filter(|found| found.object.as_str() == object) {
            let row = format!("light {}", found.light);
            assert_eq!(is_linked(&hand, &row), found.reaches, "{object}, {row}");
        }
    }
}

#[test]
fn lights_are_linked_to_what_is_under_the_pointer() {
    let home = Home::new();
    let mut hand = lit_window(&home, "Links");
    let middle = hand.app().viewport().rect().unwrap().center();
    let (mut point, mut found) = (middle, false);
    hand.press_a(Role::ListItem, "Link light back");
    // The ball stands right of the middle.
    for step in 1..20 {
        point = middle + vec2(step as f32 * 8.0, 0.0);
        hand.hover(point);
        hand.settle();
        if hand.says("Picture: ball") {
            found = true;
            break;
        }
    }
    assert!(found, "the ball is under the pointer somewhere");
    hand.hover(point);
    hand.key(Key::J);
    hand.settle();
    assert_eq!(scene(&hand).objects["ball"].linked.text(), "*");
    hand.key_with(Modifiers::SHIFT, Key::J);
    hand.settle();
    assert_eq!(scene(&hand).objects["ball"].linked.text(), "* - back");
    hand.undo();
    hand.undo();
    assert_eq!(scene(&hand).objects["ball"].linked.text(), "* - back", "as it was in the file");
}

/// Pictures of the panels, to be looked at: written to `target/shots`, or to the folder that
/// `CHIARO_SHOTS` names.
#[test]
#[ignore = "writes pictures to be looked at"]
fn light_panel_shots() {
    let folder = std::env::var_os("CHIARO_SHOTS")
        .map_or_else(|| PathBuf::from("target/shots"), PathBuf::from);
    fs::create_dir_all(&folder).unwrap();
    for size in [vec2(1500.0, 950.0), vec2(1100.0, 700.0)] {
        let state = create_render_state(
            default_wgpu_setup(),
            eframe::egui_wgpu::RendererOptions::PREDICTABLE,
        );
        let builder = Harness::builder()
            .with_size(size)
            .renderer(WgpuTestRenderer::from_render_state(state.clone()));
        let mut hand = User::with_builder(builder, move |ctx| App::new(ctx, Some(state.clone())));
        hand.harness.set_size(size);
        hand.app_mut().open(Path::new("examples/scenes/lit-room.json"));
        hand.settle();
        let save = |hand: &mut User, name: &str| {
            hand.settle();
            hand.settle();
            let file = folder.join(format!("{name}-{}.png", size.x));
            hand.harness.render().unwrap().save(file).unwrap();
        };
        show(&mut hand, "Light table");
        let from = at(&hand, "Intensity of group Window");
        hand.click(from);
        enter(&mut hand, "0.5");
        assert!(close(scene(&hand).light_groups["window"].intensity, 0.5));
        hand.key(Key::ArrowDown);
        for _ in 0..2 {
            hand.key_with(Modifiers::SHIFT, Key::ArrowDown);
        }
        save(&mut hand, "table");
        hand.type_text("*1.2");
        save(&mut hand, "table-typing");
        hand.key(Key::Escape);
        let mute = at(&hand, "Shines of Rim");
        hand.click(mute);
        for _ in 0..30 {
            hand.harness.step();
        }
        save(&mut hand, "table-help");
        show(&mut hand, "Mixer");
        hand.press_a(Role::CheckBox, "Solo group Room");
        save(&mut hand, "mixer");
        hand.tab("Lights");
        save(&mut hand, "lights");
        show(&mut hand, "Links");
        hand.press("End solo");
        let middle = hand.app().viewport().rect().unwrap().center();
        hand.hover(middle);
        hand.settle();
        hand.press_a(Role::ListItem, "Link object guest");
        hand.press_a(Role::ListItem, "Link group room");
        save(&mut hand, "links");
    }
}
