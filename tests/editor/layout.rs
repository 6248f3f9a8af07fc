//! Every panel and menu from 800x600 to 4K, at 100% and 200%: nothing that can be operated lies
//! over anything else or is cut off, and no text ends in the middle of a letter.

use std::collections::BTreeSet;
use std::path::PathBuf;

use chiaro::document::Edit;
use chiaro_locale::{tr, tr_in};
use eframe::egui::accesskit::Toggled;
use eframe::egui::epaint::{ClippedShape, Shape, TextShape};
use eframe::egui::{
    FontFamily, Id, Key, LayerId, Modifiers, Order, Rect, Role, Vec2, WidgetRect, pos2, vec2,
};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use egui_kittest::{Harness, Node};

use crate::editor_support::User;
use crate::editor_support::home::Home;

/// Size of a window in pixels, with the pixels of a point.
type WindowSize = ([f32; 2], f32);

/// Sizes of windows that are looked at.
pub(crate) const SIZES: [WindowSize; 6] = [
    ([800.0, 600.0], 1.0),
    ([1280.0, 720.0], 1.0),
    ([1600.0, 1000.0], 2.0),
    ([1920.0, 1080.0], 1.0),
    ([3840.0, 2160.0], 2.0),
    // As narrow as the first, with all rows of the panels in view.
    ([800.0, 2400.0], 1.0),
];

/// Panels that are looked at together, as the command palette lists them: those of one row lie in
/// stacks of their own.
pub(crate) const ROUNDS: [&[&str]; 10] = [
    &["Timeline", "Render"],
    &["Light table", "Variations"],
    &["Objects", "Code", "Mixer"],
    &["Shot", "Problems", "Links"],
    &["Library", "Effects", "Export"],
    &["Picture", "Graph", "Inspector", "Layers", "Profile"],
    &["Lights", "Keys"],
    &["History", "Cost and accuracy"],
    &["Wedge", "Probe"],
    &["Snapshots", "Paint light"],
];

/// Menus of the bar.
pub(crate) const MENUS: [&str; 5] = ["View", "Paint", "Export", "Copy as", "Help"];

const LOOK: &str = r#"{"chiaro": "look", "name": "Nightfall on the old harbor",
 "lights": {"key": {"name": "Key light of the lantern", "direction": [0, 0, 1]},
            "rim": {"type": "point", "position": [2, 1, 1]}, "fill": {"direction": [1, 0, 0]}},
 "nodes": [{"id": "base", "kind": "base"},
  {"id": "layer", "kind": "light_layer", "name": "Cartoon of the key light",
   "values": {"light": "key", "opacity": 0.5}},
  {"id": "back", "kind": "light_layer", "values": {"light": "rim"}},
  {"id": "output", "kind": "output"}],
 "wires": [{"from": "base", "to": "layer.below"}, {"from": "layer", "to": "back.below"},
           {"from": "back", "to": "output.color"}],
 "aovs": [{"name": "key_alone", "from": "layer"}],
 "time_keys": [{"target": "layer.cutoff", "keys": [{"time": 0, "value": 1},
                                                    {"time": 1, "value": 1.2}]}],
 "direction_keys": [{"name": "By the eye", "by": "view",
   "keys": [{"direction": [0, 0, 1], "values": {"back.opacity": 0.4}}]}]}"#;

const SCENE: &str = r#"{"chiaro": "scene",
 "objects": [{"id": "ball_of_the_harbor", "mesh": "shape:sphere", "looks": "look.json"},
             {"id": "knot", "mesh": "shape:torus", "looks": "look.json"}],
 "lights": {"sun": {"direction": [0, 0.6, 0.8], "intensity": 0.8, "groups": ["rims"]}},
 "light_groups": {"rims": {"name": "Rims of all"}},
 "camera": {"eye": [0, 0, 6]}}"#;

const SHOT: &str = r#"{"chiaro": "shot", "scene": "scene.json", "rate": 24, "frames": [1, 96],
 "overrides": [{"target": "lights.sun.intensity", "value": 0.25},
   {"look": "look.json", "target": "layer.opacity", "value": 0.75}]}"#;

/// Folder into which pictures of all panels are written; none where nobody asks.
fn pictures() -> Option<PathBuf> {
    std::env::var_os("CHIARO_PANEL_PICTURES").map(PathBuf::from)
}

/// A window with a shot, on files of its own.
pub(crate) fn opened(home: &Home) -> User {
    for (name, text) in [("look.json", LOOK), ("scene.json", SCENE), ("shot.json", SHOT)] {
        std::fs::write(home.file(name), text).unwrap();
    }
    let mut hand = match pictures() {
        Some(_) => User::drawing_with(|app, _| app.without_dialogs()),
        None => User::with(|ctx| chiaro::editor::App::new(ctx, None).without_dialogs()),
    };
    hand.app_mut().open(&home.file("shot.json"));
    hand.settle();
    hand
}

fn resize(hand: &mut User, (size, pixels): WindowSize) {
    // A frame with another scale keeps the window's size in pixels, whatever size it is given.
    hand.harness.set_pixels_per_point(pixels);
    hand.harness.step();
    hand.harness.set_size(Vec2::from(size) / pixels);
    hand.harness.run_steps(3);
    let window = hand.harness.ctx.content_rect();
    assert_eq!(window.size(), Vec2::from(size) / pixels);
}

/// Brings a panel to the front by the command palette, which knows English words in every language.
fn show(hand: &mut User, panel: &str) {
    hand.key_with(Modifiers::COMMAND, Key::P);
    hand.type_text(&format!("panel {panel}"));
    let entry = tr("Panel: {panel}").replace("{panel}", tr(panel));
    assert!(hand.has(&entry), "the palette has no {entry}");
    hand.key(Key::Enter);
}

/// Widgets that can be operated, with their names.
///
/// egui keeps names of widgets only while it shows them for debugging, so that a frame is shown so.
fn widgets(hand: &mut User) -> Vec<(WidgetRect, String)> {
    let name_all = |hand: &User, is_on: bool| {
        let ctx = &hand.harness.ctx;
        ctx.all_styles_mut(|style| style.debug.show_interactive_widgets = is_on);
    };
    name_all(hand, true);
    hand.harness.step();
    let found: Vec<(WidgetRect, String)> = hand.harness.ctx.viewport(|viewport| {
        let all = &viewport.prev_pass.widgets;
        let name = |widget: &WidgetRect| {
            let info = all.info(widget.id)?;
            let text = info.label.clone().or_else(|| info.current_text_value.clone());
            Some(format!("{:?} {:?}", info.role, text.unwrap_or_default()))
        };
        let is_operated = |widget: &&WidgetRect| {
            (widget.sense.senses_click() || widget.sense.senses_drag())
                && widget.interact_rect.is_positive()
        };
        let all_widgets = all.layers().flat_map(|(_, widgets)| widgets.iter());
        all_widgets
            .filter(is_operated)
            .filter_map(|widget| Some((*widget, name(widget)?)))
            .collect()
    });
    name_all(hand, false);
    hand.harness.run_steps(2);
    assert!(found.len() > 10, "the window has buttons: {found:?}");
    found
}

/// True for areas that are drawn on, for handles on the object or on a plot, and for bars that
/// appear over what they scroll: other widgets lie over them.
fn is_ground(name: &str) -> bool {
    const ROLES: [&str; 6] = ["Canvas", "Image", "ListItem", "Unknown", "Splitter", "ScrollBar"];
    const HANDLES: [&str; 5] = ["Handle", "of the profile", "Playhead", "of the range", "Key of"];
    // In German, as far as the rounds show them.
    const GERMAN: [&str; 3] = ["des Profils", "Abspielkopf", "des Bereichs"];
    ROLES.iter().any(|role| name.starts_with(role))
        || HANDLES.iter().chain(&GERMAN).any(|handle| name.contains(handle))
}

/// Widgets of which one covers a part of another.
fn overlapping(widgets: &[(WidgetRect, String)], found: &mut BTreeSet<String>, at: &str) {
    let is_in = |a: Rect, b: Rect| b.expand(1.5).contains_rect(a);
    for (index, (a, name)) in widgets.iter().enumerate() {
        for (b, other) in &widgets[index + 1..] {
            let shared = a.interact_rect.intersect(b.interact_rect);
            if a.layer_id != b.layer_id
                || shared.width() < 2.0
                || shared.height() < 2.0
                || is_ground(name)
                || is_ground(other)
                || is_in(a.interact_rect, b.interact_rect)
                || is_in(b.interact_rect, a.interact_rect)
            {
                continue;
            }
            found.insert(format!("{at}: {name} and {other} lie over each other at {shared:?}"));
        }
    }
}

/// Widgets that their panel or the window cuts off at the left or the right, or that a panel
/// without room leaves in half.
fn cut_off(widgets: &[(WidgetRect, String)], found: &mut BTreeSet<String>, at: &str) {
    for (widget, name) in widgets {
        let [whole, seen] = [widget.rect, widget.interact_rect];
        let is_scrolled = ["Cell", "ColumnHeader"].iter().any(|role| name.starts_with(role));
        if whole.width() - seen.width() > 2.0 && !is_ground(name) && !is_scrolled {
            found.insert(format!("{at}: {name} is cut off at its side: {seen:?} of {whole:?}"));
        }
    }
}

/// Panels that scroll to the sides, too; they lie below the graph.
const SCROLLED_ACROSS: [&str; 2] = ["Light table", "Timeline"];

/// Place of the panel that scrolls to the sides, where one is in front.
fn scrolled_across(hand: &User) -> Option<Rect> {
    let tab = |panel: &'static str| hand.harness.query_by_role_and_label(Role::Tab, tr(panel));
    let is_in_front = |tab: &Node<'_>| tab.accesskit_node().toggled() == Some(Toggled::True);
    let front = SCROLLED_ACROSS.iter().filter_map(|panel| tab(panel)).find(is_in_front)?;
    let (left, right) = (tab("Graph")?.rect().left() - 12.0, tab("Inspector")?.rect().left());
    let window = hand.harness.ctx.content_rect();
    let top = front.rect().bottom();
    Some(Rect::from_x_y_ranges(left..=right, top..=window.bottom()))
}

/// Least width of a field of text, in points: a longer text is scrolled in it.
const LEAST_FIELD: f32 = 48.0;

/// True for the text of a field of one line, which is scrolled in it.
fn is_in_field(text: Rect, clip: Rect) -> bool {
    let begins = (0.0..3.0).contains(&(text.left() - clip.left()));
    begins && clip.height() < 20.0 && clip.width() >= LEAST_FIELD
}

/// Texts that end in the middle of a letter at the left or the right, or outside of the window.
fn cut_texts(hand: &User, found: &mut BTreeSet<String>, at: &str) {
    let window = hand.harness.ctx.content_rect();
    let across = scrolled_across(hand);
    for ClippedShape { clip_rect, shape, .. } in &hand.harness.output().shapes {
        let mut texts = Vec::new();
        collect(shape, &mut texts);
        for (rect, text) in texts {
            let clip = clip_rect.intersect(window);
            // Rows of lists are cut where the list ends; that is what the wheel is for.
            let is_seen = across.is_none_or(|panel| !panel.contains(rect.center()))
                && clip.intersect(rect).height() > rect.height() * 0.6
                && clip.intersect(rect).width() > 1.0
                && !is_in_field(rect, clip);
            if is_seen && (rect.left() < clip.left() - 1.5 || rect.right() > clip.right() + 1.5) {
                found.insert(format!("{at}: the text {text:?} is cut off: {rect:?} in {clip:?}"));
            }
        }
    }
}

/// True for code, which is scrolled in both directions.
fn is_code(text: &TextShape) -> bool {
    let first = text.galley.job.sections.first();
    first.is_some_and(|first| first.format.font_id.family == FontFamily::Monospace)
}

/// Texts of a shape, but for code, each with the room that it takes.
pub(crate) fn collect(shape: &Shape, texts: &mut Vec<(Rect, String)>) {
    match shape {
        Shape::Vec(shapes) => shapes.iter().for_each(|shape| collect(shape, texts)),
        Shape::Text(text) if !text.galley.is_empty() && text.angle == 0.0 && !is_code(text) => {
            texts.push((text.visual_bounding_rect(), text.galley.text().to_owned()));
        }
        _ => {}
    }
}

/// Menus and other areas above the window that reach out of it.
fn outside(window: Rect, widgets: &[(WidgetRect, String)], found: &mut BTreeSet<String>, at: &str) {
    let window = window.expand(1.0);
    let above = |layer: &LayerId| matches!(layer.order, Order::Foreground | Order::Middle);
    for (widget, name) in widgets.iter().filter(|(widget, _)| above(&widget.layer_id)) {
        if !window.contains_rect(widget.interact_rect) {
            found.insert(format!("{at}: {name} is outside: {:?}", widget.interact_rect));
        }
    }
}

/// Faults of a window's panels at sizes, and of its menus.
pub(crate) fn faults(
    hand: &mut User,
    rounds: &[&[&str]],
    sizes: &[WindowSize],
    menus_at: &[WindowSize],
) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for round in rounds {
        for panel in *round {
            show(hand, panel);
        }
        for size in sizes {
            resize(hand, *size);
            look_at(hand, &mut found, *size, &round.join(", "));
        }
    }
    for size in menus_at {
        resize(hand, *size);
        for menu in MENUS {
            let button = hand
                .harness
                .get_all_by_label(tr_in("menu", menu))
                .next()
                .expect("a menu of the bar");
            let at = button.rect().center();
            hand.click(at);
            look_at(hand, &mut found, *size, &format!("menu {menu}"));
            hand.key(Key::Escape);
        }
    }
    found
}

fn look_at(hand: &mut User, found: &mut BTreeSet<String>, size: WindowSize, what: &str) {
    let ([width, height], pixels) = size;
    let at = format!("{width}x{height}@{pixels} {what}");
    let widgets = widgets(hand);
    overlapping(&widgets, found, &at);
    cut_off(&widgets, found, &at);
    cut_texts(hand, found, &at);
    outside(hand.harness.ctx.content_rect(), &widgets, found, &at);
    if let Some(folder) = pictures() {
        picture(&mut hand.harness, &folder, &at);
    }
}

fn picture<S>(harness: &mut Harness<'_, S>, folder: &std::path::Path, name: &str) {
    let image = harness.render().unwrap();
    let file = format!("{}.png", name.replace([' ', '@'], "-"));
    image.save(folder.join(file)).unwrap();
}

#[test]
fn every_panel_has_room_at_every_size() {
    let home = Home::new();
    let mut hand = opened(&home);
    hand.app_mut().session_mut().select(vec!["layer".into()]);
    let found = faults(&mut hand, &ROUNDS, &SIZES, &[SIZES[0], SIZES[2]]);
    assert!(found.is_empty(), "{}\n{}", found.len(), Vec::from_iter(found).join("\n"));
}

#[test]
fn the_bar_of_a_narrow_picture_has_room_for_the_list_of_meshes() {
    let home = Home::new();
    std::fs::write(home.file("look.json"), LOOK).unwrap();
    let mut hand = User::with(|ctx| chiaro::editor::App::new(ctx, None).without_dialogs());
    hand.app_mut().open(&home.file("look.json"));
    hand.settle();
    let mut found = BTreeSet::new();
    for width in [800.0, 1000.0, 1200.0, 1400.0, 1800.0] {
        let size = ([width, 700.0], 1.0);
        resize(&mut hand, size);
        look_at(&mut hand, &mut found, size, "a look without a scene");
    }
    assert!(found.is_empty(), "{}", Vec::from_iter(found).join("\n"));
}

#[test]
fn a_long_name_leaves_the_word_changed_in_sight() {
    let home = Home::new();
    let path = home.file("a-look-whose-name-is-longer-than-the-bar-of-the-window.json");
    std::fs::write(&path, LOOK).unwrap();
    let mut hand = User::with(|ctx| chiaro::editor::App::new(ctx, None).without_dialogs());
    hand.app_mut().open(&path);
    hand.settle();
    resize(&mut hand, SIZES[0]);
    assert!(!hand.has("changed"));
    let edit = Edit::SetLookTags { tags: "dusk".to_owned() };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.settle();
    assert!(hand.has("changed"), "{:?}", hand.names());
}

/// Faults of the sheet of shortcuts in windows from 400x300 points on.
pub(crate) fn sheet_faults(hand: &mut User, close: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for (size, pixels) in [SIZES[0], SIZES[1], SIZES[3], ([800.0, 600.0], 2.0)] {
        resize(hand, (size, pixels));
        hand.key(Key::F1);
        hand.harness.run_steps(3);
        let at = format!("{size:?}@{pixels}");
        let window = hand.harness.ctx.content_rect();
        match hand.harness.query_by_role_and_label(Role::Button, close) {
            Some(button) if window.contains_rect(button.rect()) => {}
            button => drop(found.insert(format!("{at}: {:?}", button.map(|it| it.rect())))),
        }
        let area = hand.harness.ctx.memory(|memory| memory.area_rect(Id::unique("sheet")));
        if area.is_none_or(|area| !window.contains_rect(area)) {
            found.insert(format!("{at}: the sheet {area:?} is not within {window:?}"));
        }
        if let Some(button) = hand.harness.query_by_role_and_label(Role::Button, close) {
            let at = button.rect().center();
            hand.click(at);
        }
        if hand.harness.query_by_role_and_label(Role::Button, close).is_some() {
            found.insert(format!("{at}: it stays open"));
        }
    }
    found
}

#[test]
fn the_sheet_of_shortcuts_lies_within_every_window_with_its_button() {
    let home = Home::new();
    let mut hand = opened(&home);
    let found = sheet_faults(&mut hand, "Close");
    assert!(found.is_empty(), "{}", Vec::from_iter(found).join("\n"));
}

/// Buttons of panels that other widgets or texts lie over in a window of 400x300 points.
pub(crate) fn crowded(hand: &mut User, panels: &[&str], buttons: &[&str]) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for panel in panels {
        resize(hand, SIZES[0]);
        show(hand, panel);
        resize(hand, ([800.0, 600.0], 2.0));
        let at = format!("400x300 {panel}");
        let widgets = widgets(hand);
        let mut all = BTreeSet::new();
        overlapping(&widgets, &mut all, &at);
        let is_of = |fault: &String| buttons.iter().any(|button| fault.contains(button));
        found.extend(all.into_iter().filter(is_of));
        let mut texts = Vec::new();
        for ClippedShape { clip_rect, shape, .. } in &hand.harness.output().shapes {
            let mut own = Vec::new();
            collect(shape, &mut own);
            texts.extend(own.into_iter().map(|(rect, text)| (rect.intersect(*clip_rect), text)));
        }
        for (rect, text) in texts.iter().filter(|(_, text)| buttons.contains(&text.as_str())) {
            let lies_over = |(other, words): &&(Rect, String)| {
                let shared = rect.intersect(*other);
                words != text && shared.width() > 2.0 && shared.height() > 2.0
            };
            let over = texts.iter().filter(lies_over);
            found.extend(over.map(|(_, other)| format!("{at}: {other:?} lies over {text:?}")));
        }
    }
    found
}

/// Least size of a panel that was opened, with its row of tabs, in points; and height of one that
/// lies below the graph.
const USABLE: (Vec2, f32) = (vec2(200.0, 180.0), 250.0);

#[test]
fn each_panel_opens_with_room_to_work_in() {
    const BELOW_GRAPH: [&str; 2] = ["Timeline", "Light table"];
    for size in [SIZES[0], SIZES[3]] {
        let home = Home::new();
        let mut hand = opened(&home);
        resize(&mut hand, size);
        let mut found = BTreeSet::new();
        for panel in chiaro::editor::App::panel_names() {
            show(&mut hand, panel);
            hand.harness.run_steps(2);
            let place = hand.app().panel_place(panel);
            let place = place.unwrap_or_else(|| panic!("{panel} is not seen at {size:?}"));
            let least = if BELOW_GRAPH.contains(&panel) { USABLE.1 } else { USABLE.0.y };
            if place.width() < USABLE.0.x || place.height() < least {
                found.insert(format!("{size:?}: {panel} has {:?}", place.size()));
            }
            look_at(&mut hand, &mut found, size, &format!("{panel} alone"));
        }
        assert!(found.is_empty(), "{}\n{}", found.len(), Vec::from_iter(found).join("\n"));
    }
}

#[test]
fn a_panel_that_has_room_keeps_the_layout_as_it_is() {
    let home = Home::new();
    let mut hand = opened(&home);
    resize(&mut hand, SIZES[3]);
    let place = |hand: &User| hand.app().panel_place("Picture").expect("the picture is seen");
    let before = place(&hand);
    for panel in ["Probe", "Code", "Picture"] {
        show(&mut hand, panel);
    }
    hand.harness.run_steps(2);
    assert_eq!(place(&hand), before);
}

#[test]
fn what_has_no_room_in_a_bar_is_in_its_menu() {
    let home = Home::new();
    std::fs::write(home.file("look.json"), LOOK).unwrap();
    let mut hand = User::with(|ctx| chiaro::editor::App::new(ctx, None).without_dialogs());
    hand.app_mut().open(&home.file("look.json"));
    hand.settle();
    const SWITCHES: [&str; 2] = ["Probe pixel", "Place light"];
    resize(&mut hand, SIZES[3]);
    assert!(SWITCHES.iter().all(|switch| hand.has(switch)) && !hand.has("More of this bar"));
    resize(&mut hand, SIZES[0]);
    assert!(!SWITCHES.iter().all(|switch| hand.has(switch)), "the bar is too narrow for all");
    hand.press("More of this bar");
    for switch in SWITCHES {
        assert!(hand.has(switch), "{switch} is lost");
    }
    let mut found = BTreeSet::new();
    look_at(&mut hand, &mut found, SIZES[0], "the menu of the bar");
    assert!(found.is_empty(), "{}", Vec::from_iter(found).join("\n"));
    hand.press("Probe pixel");
    assert!(hand.app().probe().is_on());
    hand.key(Key::Escape);
    // The bar of the timeline leaves room for tracks.
    resize(&mut hand, SIZES[2]);
    show(&mut hand, "Timeline");
    hand.harness.run_steps(2);
    let place = hand.app().panel_place("Timeline").expect("the timeline is seen");
    let playhead = hand.place("Playhead");
    assert!(playhead.bottom() < place.top() + 0.55 * place.height(), "{playhead:?} in {place:?}");
    assert!(!hand.has("Speed"));
    let buttons = hand.harness.get_all_by_label("More of this bar").map(|node| node.rect());
    let button = buttons.max_by(|a, b| a.left().total_cmp(&b.left())).expect("the timeline's");
    hand.click(button.center());
    hand.settle();
    hand.press("Speed");
    hand.press("×2");
    assert!(hand.has("Speed"), "the menu stays open");
}

#[test]
fn the_bar_over_a_group_of_the_library_has_room_in_a_narrow_canvas() {
    let mut hand = User::new();
    resize(&mut hand, SIZES[0]);
    hand.app_mut().session_mut().select(vec!["diffuse".into()]);
    hand.settle();
    let canvas = hand.place("Graph");
    hand.hover(canvas.center() + vec2(0.0, 120.0));
    hand.key_with(Modifiers::COMMAND, Key::Enter);
    hand.settle();
    assert_eq!(hand.app().session().selection().open_groups().len(), 1);
    let mut found = BTreeSet::new();
    look_at(&mut hand, &mut found, SIZES[0], "a group of the library");
    assert!(found.is_empty(), "{}", Vec::from_iter(found).join("\n"));
}

#[test]
fn options_that_are_higher_than_the_window_scroll_to_their_end() {
    let mut hand = User::new();
    resize(&mut hand, ([1280.0, 720.0], 2.0));
    hand.press("Options");
    let last = |hand: &User| hand.place_like("Bake to LitSphere");
    let window = hand.harness.ctx.content_rect();
    assert!(!window.contains_rect(last(&hand)), "more than the window has room for");
    let at = hand.place("Turntable").center();
    for _ in 0..12 {
        hand.wheel(at, -120.0);
    }
    assert!(window.contains_rect(last(&hand)), "{:?}", last(&hand));
}

#[test]
fn a_long_message_is_read_whole_and_copied() {
    let home = Home::new();
    let mut hand = User::with(|ctx| chiaro::editor::App::new(ctx, None).without_dialogs());
    let path = home.file(&format!("{}/look.json", "a-folder-that-is-not-there".repeat(6)));
    resize(&mut hand, SIZES[0]);
    hand.app_mut().save_as(&path);
    hand.settle();
    let message = hand.app().message().expect("it cannot be saved").to_owned();
    let at = hand.place_of(Role::Button, &message).center();
    hand.click(at);
    hand.settle();
    let lowest = |a: &Rect, b: &Rect| a.top().total_cmp(&b.top());
    let buttons = hand.harness.get_all_by_label("Copy").map(|node| node.rect());
    let button = buttons.max_by(lowest).expect("the text is shown with a button");
    let mut found = BTreeSet::new();
    look_at(&mut hand, &mut found, SIZES[0], "the whole message");
    assert!(found.is_empty(), "{}", Vec::from_iter(found).join("\n"));
    hand.click(button.center());
    assert_eq!(hand.take_copied().as_deref(), Some(&*message));
}

#[test]
fn the_status_bar_tells_all_of_a_problem_under_the_pointer() {
    let home = Home::new();
    let broken = LOOK.replace("\"opacity\": 0.5", "\"opacity\": [1, 2, 3]");
    std::fs::write(home.file("look.json"), broken).unwrap();
    let mut hand = User::with(|ctx| chiaro::editor::App::new(ctx, None).without_dialogs());
    hand.app_mut().open(&home.file("look.json"));
    hand.settle();
    resize(&mut hand, SIZES[0]);
    let errors = hand.errors();
    assert!(!errors.is_empty(), "the opacity is no number");
    let status = hand.place("Open the list of problems");
    hand.hover(status.center());
    hand.harness.run_steps(6);
    assert!(hand.says("Lists all problems"), "{:?}", hand.names());
    assert!(hand.says("Opacity\n"), "the node and its port: {:?}", hand.names());
}

/// Room of the canvas, below its tab.
fn canvas(hand: &User) -> Rect {
    let tab = hand.place_of(Role::Tab, tr("Graph"));
    let place = hand.app().panel_place("Graph").expect("the graph is seen");
    Rect::from_min_max(pos2(place.left(), tab.bottom()), place.max)
}

/// Texts of the canvas's readings at a pixel that the canvas cuts off, at two sizes: with a node in
/// the middle of the canvas, and with the node at its corner.
pub(crate) fn cut_readings(hand: &mut User) -> Vec<String> {
    const NODE: &str = "layer";
    let mut found = Vec::new();
    for size in [SIZES[0], SIZES[2]] {
        resize(hand, size);
        hand.settle();
        let picture = hand.app().viewport().rect().expect("the picture is seen");
        hand.hover(picture.center());
        if !hand.app().probe().is_on() {
            hand.key(Key::I);
        }
        hand.click(picture.center());
        hand.settle();
        let room = canvas(hand);
        let (zoom, center) = hand.app().canvas().zoom_and_center();
        let node = hand.app().canvas().node_rect(NODE).expect("the graph has it");
        let node = center + (node.center() - room.center()) / zoom;
        for to_corner in [0.0, 0.95] {
            let center = node + room.size() / 2.0 * to_corner;
            hand.app_mut().canvas_mut().set_zoom_and_center(1.0, center);
            hand.harness.run_steps(2);
            let (canvas, session) = (hand.app().canvas(), hand.app().session());
            let told = canvas.reading_text(session, NODE).expect("it is probed").to_owned();
            let mut seen = 0;
            for ClippedShape { clip_rect, shape, .. } in &hand.harness.output().shapes {
                let Shape::Text(text) = shape else { continue };
                if text.galley.text() != told || !room.expand(2.0).contains_rect(*clip_rect) {
                    continue;
                }
                seen += 1;
                let place = text.visual_bounding_rect();
                if !clip_rect.expand(1.0).contains_rect(place) || text.galley.elided {
                    found.push(format!("{size:?}, {to_corner}: {told:?} at {place:?}"));
                }
            }
            assert!(seen > 0, "{told:?} is on the canvas at {size:?}, {to_corner}");
        }
    }
    found
}

#[test]
fn values_of_wires_lie_within_the_canvas() {
    let home = Home::new();
    let mut hand = opened(&home);
    let found = cut_readings(&mut hand);
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn buttons_that_lie_over_each_other_are_found() {
    let mut hand = User::new();
    let mut widgets = widgets(&mut hand);
    let mut found = BTreeSet::new();
    overlapping(&widgets, &mut found, "as it is");
    assert!(found.is_empty(), "{found:?}");
    let at = |name: &str| widgets.iter().position(|(_, other)| other.contains(name)).unwrap();
    let (new, open) = (at("\"New\""), at("\"Open\""));
    let place = widgets[new].0.interact_rect.translate(Vec2::new(12.0, 0.0));
    widgets[open].0.interact_rect = place;
    overlapping(&widgets, &mut found, "planted");
    assert!(found.iter().any(|told| told.contains("\"New\"") && told.contains("\"Open\"")));
}

#[test]
fn a_menu_that_is_higher_than_the_window_scrolls_to_its_end() {
    let mut hand = User::new();
    resize(&mut hand, ([1600.0, 1000.0], 2.0));
    hand.press("View");
    let scale = |hand: &User| hand.place("Scale 125%");
    let window = hand.harness.ctx.content_rect();
    assert!(!window.contains_rect(scale(&hand)), "more than the window has room for");
    let view = hand.place("Graph").center();
    hand.hover(view);
    for _ in 0..12 {
        hand.wheel(view, -120.0);
    }
    assert!(window.contains_rect(scale(&hand)), "{:?}", scale(&hand));
    hand.press("Scale 125%");
    assert!((hand.harness.ctx.zoom_factor() - 1.25).abs() < 1e-3);
}

#[test]
fn the_scale_is_on_keys_and_in_the_palette() {
    let mut hand = User::new();
    let scale = |hand: &User| (hand.harness.ctx.zoom_factor() * 100.0).round();
    hand.key_with(Modifiers::COMMAND, Key::Plus);
    assert_eq!(scale(&hand), 110.0);
    hand.key_with(Modifiers::COMMAND, Key::Minus);
    hand.key_with(Modifiers::COMMAND, Key::Minus);
    assert_eq!(scale(&hand), 90.0);
    hand.key_with(Modifiers::COMMAND, Key::Num0);
    assert_eq!(scale(&hand), 100.0);
    hand.key_with(Modifiers::COMMAND, Key::P);
    hand.type_text("scale 150");
    hand.key(Key::Enter);
    assert_eq!(scale(&hand), 150.0);
}
