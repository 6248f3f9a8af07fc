//! Pictures of the window, to be looked at: `cargo test --test editor shots -- --ignored` writes
//! them to `target/shots`, or to the folder that `CHIARO_SHOTS` names.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::editor_support::User;
use chiaro::editor::App;
use chiaro::render::device_descriptor;
use eframe::egui::{Key, Role, Theme, vec2};
use eframe::egui_wgpu::WgpuSetup;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use egui_kittest::wgpu::{WgpuTestRenderer, create_render_state, default_wgpu_setup};

pub(crate) fn window() -> User {
    window_of(|app| app)
}

/// A window that draws, made by `make` of a new one.
fn window_of(make: impl Fn(App) -> App + 'static) -> User {
    let mut setup = default_wgpu_setup();
    if let WgpuSetup::CreateNew(setup) = &mut setup {
        setup.device_descriptor = Arc::new(device_descriptor);
    }
    let state = create_render_state(setup, eframe::egui_wgpu::RendererOptions::PREDICTABLE);
    let builder = Harness::builder()
        .with_size(vec2(1600.0, 960.0))
        .renderer(WgpuTestRenderer::from_render_state(state.clone()));
    User::with_builder(builder, move |ctx| make(App::new(ctx, Some(state.clone()))))
}

pub(crate) fn save(hand: &mut User, name: &str) {
    let folder = std::env::var_os("CHIARO_SHOTS")
        .map_or_else(|| PathBuf::from("target/shots"), PathBuf::from);
    std::fs::create_dir_all(&folder).unwrap();
    hand.settle();
    hand.harness.render().unwrap().save(folder.join(format!("{name}.png"))).unwrap();
}

#[test]
#[ignore = "writes pictures to be looked at"]
fn shots() {
    let mut hand = window();
    hand.app_mut().open(Path::new("examples/looks/figure1-layers.json"));
    save(&mut hand, "dark");
    for panel in ["Effects", "Cost and accuracy", "Probe"] {
        let tab = hand.harness.get_by_label(panel).rect().center();
        hand.click(tab);
        save(&mut hand, &panel.to_lowercase().replace(' ', "-"));
    }
    hand.harness.ctx.set_theme(Theme::Light);
    let tab = hand.harness.get_by_label("Code").rect().center();
    hand.click(tab);
    save(&mut hand, "light");
}

/// Arrows toward eye and lights on the waves and on a ball.
#[test]
#[ignore = "writes pictures to be looked at"]
fn arrows() {
    let mut hand = window();
    hand.press("Options");
    hand.press("Arrows toward eye and lights");
    hand.key(Key::Escape);
    for shape in ["waves", "sphere"] {
        hand.app_mut().show_on(&format!("shape:{shape}"));
        hand.settle();
        let at = hand.app().viewport().rect().unwrap().center();
        hand.hover(at);
        save(&mut hand, &format!("arrows-{shape}"));
    }
}

/// The viewport's handles on every mesh of a folder that `CHIARO_MODELS` names, and on own shapes.
#[test]
#[ignore = "writes pictures to be looked at"]
fn viewport_shots() {
    let mut hand = window();
    hand.app_mut().open(Path::new("examples/looks/figure1-layers.json"));
    let folder = std::env::var_os("CHIARO_MODELS").map(PathBuf::from);
    let own = ["shape:sphere".to_owned(), "shape:creature".to_owned()];
    let meshes = ["spot", "stanford-bunny", "nefertiti"];
    let of_folder = folder.iter().flat_map(|folder| {
        meshes.map(|mesh| folder.join(mesh).with_extension("obj").display().to_string())
    });
    let ids: Vec<_> = hand
        .look()
        .graph
        .nodes
        .iter()
        .filter(|(_, node)| node.kind == "light_layer")
        .map(|(id, _)| id.clone())
        .collect();
    for (number, mesh) in own.into_iter().chain(of_folder).enumerate() {
        hand.app_mut().show_on(&mesh);
        let id = ids[number % ids.len()].clone();
        hand.app_mut().session_mut().select(vec![id.clone()]);
        hand.settle();
        let rect = hand.app().viewport().rect().unwrap();
        hand.hover(rect.center() + vec2(30.0, 10.0));
        save(&mut hand, &format!("view-{number}-{id}"));
        if number == 1 {
            click_label(&mut hand, "Options");
            save(&mut hand, "view-options");
            hand.key(Key::Escape);
        }
        if number % 2 == 1 {
            hand.harness.ctx.set_theme(Theme::Light);
        } else {
            hand.harness.ctx.set_theme(Theme::Dark);
        }
    }
}

fn click_label(hand: &mut User, label: &str) {
    let at = hand.harness.get_by_label(label).rect().center();
    hand.click(at);
    hand.settle();
}

/// The panels that tell how true the picture is and what it costs: measured tiers, a wipe against
/// the truth, a wire as isolines, and a wire that is not a number.
#[test]
#[ignore = "writes pictures to be looked at"]
fn shots_of_truth() {
    let mut hand = window();
    hand.app_mut().open(Path::new("examples/looks/figure4-both.json"));
    hand.settle();
    click_label(&mut hand, "Cost and accuracy");
    click_label(&mut hand, "Measure");
    save(&mut hand, "cost-measured");
    let plot = hand.harness.get_by_label("Error against time").rect();
    hand.wheel(plot.center(), -160.0);
    save(&mut hand, "cost-rows");

    let combos = hand.harness.get_all_by_role(Role::ComboBox);
    let list = combos
        .into_iter()
        .find(|node| node.value().as_deref() == Some("Compare"))
        .unwrap()
        .rect()
        .center();
    hand.click(list);
    hand.settle();
    click_label(&mut hand, "Truth (f64)");
    save(&mut hand, "wipe-truth");
    click_label(&mut hand, "×256");
    save(&mut hand, "wipe-difference");

    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("broken.json");
    let broken = r##"{"name": "Broken", "nodes": [
        {"id": "facing", "kind": "facing", "at": [0, 0]},
        {"id": "broken", "kind": "wgsl", "at": [240, 0], "name": "Reciprocal",
         "values": {"code": "fn broken(value: f32) -> f32 { return 1.0 / (value - value); }"}},
        {"id": "mix", "kind": "mix_values", "at": [480, 0], "values": {"a": [0.2, 0.3, 0.5, 1],
        "b": [1, 0.8, 0.4, 1]}},
        {"id": "output", "kind": "output", "at": [720, 0]}],
        "wires": [{"from": "facing", "to": "broken.value"}, {"from": "broken", "to": "mix.factor"},
                  {"from": "mix", "to": "output.color"}]}"##;
    std::fs::write(&path, broken).unwrap();
    hand.app_mut().open(&path);
    hand.settle();
    click_label(&mut hand, "Probe");
    hand.key(eframe::egui::Key::I);
    let middle = hand.app().viewport().rect().unwrap().center();
    hand.click(middle);
    save(&mut hand, "probe-broken");

    let combos = hand.harness.get_all_by_role(Role::ComboBox);
    let list = combos
        .into_iter()
        .find(|node| node.value().as_deref() == Some("Truth (f64)"))
        .unwrap()
        .rect()
        .center();
    hand.click(list);
    hand.settle();
    click_label(&mut hand, "Nothing");
    hand.app_mut().open(Path::new("examples/looks/figure1-layers.json"));
    hand.settle();
    hand.click(middle);
    hand.settle();
    save(&mut hand, "probe-kept");
    let wire = hand.harness.get_by_label("Wire of fill/angle");
    wire.click_secondary();
    hand.settle();
    click_label(&mut hand, "Show Angle as isolines");
    save(&mut hand, "isolines");
}

/// The canvas with everything that it draws, in both themes.
#[test]
#[ignore = "writes pictures to be looked at"]
fn canvas_shots() {
    use chiaro::document::{Edit, GraphId, Node, Note};
    use eframe::egui::{Key, Modifiers};
    let mut hand = window();
    hand.app_mut().open(Path::new("examples/looks/figure1-layers.json"));
    hand.settle();
    let ids: Vec<_> = hand.look().graph.nodes.keys().cloned().collect();
    let graph = || GraphId::Look;
    let add = |id: &str, kind: &str, at: [f64; 2]| {
        let node = Node { kind: kind.to_owned(), position: at, ..Node::default() };
        Edit::AddNode { graph: graph(), id: id.into(), node, index: None }
    };
    let text = "The rim comes last, so that it lies over everything.\n\nTry 60° here.".to_owned();
    let note = Note { text, position: [20.0, 560.0], ..Note::default() };
    let edits = vec![
        add("noise", "map_range", [300.0, 560.0]),
        add("spare", "mix_values", [560.0, 560.0]),
        add("lost", "nothing_such", [820.0, 560.0]),
        Edit::AddNote { graph: graph(), id: "why".into(), note, index: None },
        Edit::SetMuted { graph: graph(), id: ids[2].clone(), muted: true },
        Edit::SetCollapsed { graph: graph(), id: "spare".into(), collapsed: true },
    ];
    hand.app_mut().session_mut().apply(Edit::Group { edits }, None).unwrap();
    hand.app_mut().session_mut().select(ids[1..3].to_vec());
    hand.settle();
    let over = hand.app().canvas().node_rect(ids[1].as_str()).unwrap().center();
    hand.hover(over);
    hand.key_with(Modifiers::COMMAND, Key::J);
    hand.type_text("Both sides");
    hand.key(Key::Enter);
    hand.key(Key::Home);
    save(&mut hand, "canvas");
    hand.key_with(Modifiers::SHIFT, Key::Questionmark);
    save(&mut hand, "shortcuts");
    hand.key(Key::Escape);
    hand.key_with(Modifiers::COMMAND, Key::P);
    save(&mut hand, "commands");
    hand.key(Key::Escape);
    hand.app_mut().session_mut().select(ids[1..3].to_vec());
    hand.settle();
    hand.hover(over);
    hand.key_with(Modifiers::COMMAND, Key::G);
    hand.key_with(Modifiers::COMMAND, Key::Enter);
    save(&mut hand, "group");
    hand.key(Key::U);
    hand.undo();
    hand.app_mut().canvas_mut().set_zoom_and_center(1.2, eframe::egui::pos2(300.0, 200.0));
    hand.harness.ctx.set_theme(Theme::Light);
    save(&mut hand, "canvas-light");
}

fn click(hand: &mut User, label: &str) {
    let at = hand.harness.get_all_by_label(label).next().unwrap().rect().center();
    hand.click(at);
    hand.settle();
}

#[test]
#[ignore = "writes pictures to be looked at"]
fn profile_shots() {
    let mut hand = window();
    hand.app_mut().open(Path::new("examples/looks/figure5-directional.json"));
    hand.settle();
    hand.app_mut().session_mut().select(vec!["diffuse".into()]);
    save(&mut hand, "profile-dark");
    click(&mut hand, "Profile preset Half-Lambert");
    hand.harness.ctx.set_theme(Theme::Light);
    save(&mut hand, "profile-light");
}

#[test]
#[ignore = "writes pictures to be looked at"]
fn keys_shots() {
    let mut hand = window();
    hand.app_mut().open(Path::new("examples/looks/figure5-directional.json"));
    hand.settle();
    hand.app_mut().session_mut().select(vec!["back".into()]);
    click(&mut hand, "Keys");
    save(&mut hand, "keys-dark");
    click(&mut hand, "Select key 2");
    click(&mut hand, "Copy key");
    click(&mut hand, "Go to key");
    hand.harness.ctx.set_theme(Theme::Light);
    save(&mut hand, "keys-light");
}

#[test]
#[ignore = "writes pictures to be looked at"]
fn timeline_shots() {
    use chiaro::document::{Edit, Target, TimeInterpolation, TimeKey, TimeKeys, Value};
    let mut hand = window();
    hand.app_mut().open(Path::new("examples/looks/figure6-comics.json"));
    hand.settle();
    let nodes: Vec<_> =
        hand.look().graph.nodes.iter().filter(|(_, node)| node.kind == "light_layer").collect();
    let id = nodes[0].0.clone();
    let track = |port: &str, keys: Vec<(f64, Value, TimeInterpolation)>| Edit::AddTimeKeys {
        keys: TimeKeys {
            keys: keys
                .into_iter()
                .map(|(time, value, interpolation)| TimeKey::new(time, value, interpolation))
                .collect(),
            ..TimeKeys::new(Target::parse(&format!("{id}.{port}")).unwrap())
        },
        index: None,
    };
    let color = |r, g, b| Value::Vector(vec![r, g, b]);
    let (smooth, stepped, linear) =
        (TimeInterpolation::Bezier, TimeInterpolation::Stepped, TimeInterpolation::Linear);
    for edit in [
        track(
            "cutoff",
            vec![
                (0.0, Value::Number(0.8), smooth),
                (1.5, Value::Number(2.4), smooth),
                (3.0, Value::Number(1.2), linear),
            ],
        ),
        track(
            "convex",
            vec![(0.5, color(0.9, 0.5, 0.2), smooth), (2.5, color(0.3, 0.4, 0.9), smooth)],
        ),
        track(
            "opacity",
            vec![
                (0.25, Value::Number(1.0), stepped),
                (1.0, Value::Number(0.5), stepped),
                (2.0, Value::Number(1.0), linear),
                (3.5, Value::Number(0.2), linear),
            ],
        ),
    ] {
        hand.app_mut().session_mut().apply(edit, None).unwrap();
    }
    hand.app_mut().session_mut().select(vec![id]);
    hand.settle();
    click(&mut hand, "View");
    let at = hand
        .harness
        .get_by_role_and_label(eframe::egui::Role::CheckBox, "Timeline")
        .rect()
        .center();
    hand.click(at);
    hand.settle();
    let at = hand.empty_place();
    hand.click(at);
    hand.settle();
    click(&mut hand, "Next key");
    save(&mut hand, "timeline-dark");
    hand.harness.ctx.set_theme(Theme::Light);
    save(&mut hand, "timeline-light");
}

#[test]
#[ignore = "writes pictures to be looked at"]
fn keyed_shots() {
    use eframe::egui::{Event, Modifiers, PointerButton};
    let mut hand = window();
    hand.app_mut().open(Path::new("examples/looks/figure7-pastel.json"));
    hand.settle();
    let layers: Vec<_> =
        hand.look().graph.nodes.iter().filter(|(_, node)| node.kind == "light_layer").collect();
    let ids: Vec<_> = layers.into_iter().take(2).map(|(id, _)| id.clone()).collect();
    hand.app_mut().session_mut().select(ids);
    hand.settle();
    click(&mut hand, "Keys of Offset");
    click(&mut hand, "Expose");
    click(&mut hand, "Keys of Offset");
    save(&mut hand, "keyed-menu");
    click(&mut hand, "New keys by the view");
    save(&mut hand, "keyed-by-view");
    // A drag beyond the handle's limit.
    click(&mut hand, "Profile");
    click(&mut hand, "Profile preset Phong specular");
    let from = hand.harness.get_by_label("Fall-off of the profile").rect().center();
    hand.hover(from);
    let (button, modifiers) = (PointerButton::Primary, Modifiers::NONE);
    hand.harness.event(Event::PointerButton { pos: from, button, pressed: true, modifiers });
    hand.harness.step();
    for step in 1..=6 {
        hand.harness.event(Event::PointerMoved(from + vec2(50.0 * step as f32, 0.0)));
        hand.harness.step();
    }
    save(&mut hand, "profile-stops");
}

/// The start page in both themes and at other sizes, with recent files; and the tour's steps.
#[test]
#[ignore = "writes pictures to be looked at"]
fn start_shots() {
    let mut hand = window();
    hand.app_mut().show_start_page();
    save(&mut hand, "start-dark");
    let folder = tempfile::tempdir().unwrap();
    let files = ["figure6-comics", "figure7-pastel", "figure5-directional", "gone"].map(|name| {
        let path = folder.path().join(format!("my {name}.json"));
        let _ = std::fs::copy(format!("examples/looks/{name}.json"), &path);
        path
    });
    hand.app_mut()
        .change_settings(|settings| files.iter().rev().for_each(|path| settings.opened(path)));
    hand.harness.ctx.set_theme(Theme::Light);
    save(&mut hand, "start-light");
    hand.harness.ctx.set_theme(Theme::Dark);
    hand.key(Key::ArrowDown);
    save(&mut hand, "start-recent");
    hand.harness.set_size(vec2(760.0, 640.0));
    save(&mut hand, "start-narrow");
    hand.harness.ctx.set_zoom_factor(2.0);
    hand.settle();
    hand.harness.set_size(vec2(750.0, 450.0));
    save(&mut hand, "start-scaled");
    hand.harness.ctx.set_zoom_factor(1.0);
    hand.settle();
    hand.harness.set_size(vec2(1500.0, 900.0));
    hand.settle();
    click_label(&mut hand, "Take the tour");
    for number in 1..=6 {
        save(&mut hand, &format!("tour-{number}"));
        if number == 2 || number == 5 {
            click_label(&mut hand, "Add layer");
            save(&mut hand, &format!("tour-{number}-menu"));
            hand.key(Key::Escape);
            hand.settle();
        }
        click_label(&mut hand, "Show me");
        if number == 5 {
            save(&mut hand, "tour-5-done");
        }
        click_label(&mut hand, "Next");
    }
    save(&mut hand, "tour-7");
    click_label(&mut hand, "Skip");
    save(&mut hand, "tour-end");
    hand.harness.ctx.set_theme(Theme::Light);
    click_label(&mut hand, "End tour");
    hand.harness.set_size(vec2(900.0, 600.0));
    hand.settle();
    click_label(&mut hand, "Help");
    click_label(&mut hand, "Take the tour");
    click_label(&mut hand, "Do not save");
    save(&mut hand, "tour-light-narrow");
}

/// The field that asks for a path where the system shows no dialog.
#[test]
#[ignore = "writes pictures to be looked at"]
fn path_shots() {
    let mut hand = window_of(App::with_path_fields);
    click_label(&mut hand, "Save");
    save(&mut hand, "path-field");
    click_label(&mut hand, "Cancel");
    click_label(&mut hand, "Copy as");
    save(&mut hand, "copy-menu");
    hand.key(Key::Escape);
    hand.settle();
    click_label(&mut hand, "Export");
    save(&mut hand, "export-menu");
    click_label(&mut hand, "Export to GLSL ES 3.00, for WebGL 2...");
    save(&mut hand, "export-path");
}

/// Widgets that newcomers stumble over: the picker, the tab of a layer's values over the picture
/// and the values themselves, a cartoon's profile, and a narrow window's bar.
#[test]
#[ignore = "writes pictures to be looked at"]
fn stumble_shots() {
    let mut hand = window();
    hand.app_mut().open(Path::new("examples/looks/figure1-layers.json"));
    hand.settle();
    click_label(&mut hand, "Layer Diffuse");
    save(&mut hand, "values-tab");
    let tab = hand.place_like("Values of Diffuse").center();
    hand.hover(tab);
    save(&mut hand, "values-open");
    let swatch = hand.swatch("Convex color").center();
    hand.click(swatch);
    save(&mut hand, "picker");
    hand.key(Key::Escape);
    hand.settle();
    click_label(&mut hand, "Options");
    click_label(&mut hand, "Backdrop");
    save(&mut hand, "options");
    hand.key(Key::Escape);
    hand.settle();
    click_label(&mut hand, "Profile");
    click_label(&mut hand, "Profile preset Cartoon");
    save(&mut hand, "profile-cartoon");
    for tab in ["Lights", "Objects"] {
        let at = hand.harness.get_by_role_and_label(Role::Tab, tab).rect().center();
        hand.click(at);
        save(&mut hand, &tab.to_lowercase());
    }
    hand.app_mut().show_on("shape:torus");
    hand.harness.ctx.set_theme(Theme::Light);
    let at = hand.harness.get_by_role_and_label(Role::Tab, "Layers").rect().center();
    hand.click(at);
    hand.harness.run_steps(20);
    save(&mut hand, "thumbs-torus");
    hand.harness.set_size(vec2(760.0, 480.0));
    save(&mut hand, "narrow");
}

/// A scene with its objects listed, one of them selected.
#[test]
#[ignore = "writes pictures to be looked at"]
fn scene_shots() {
    let mut hand = window();
    hand.app_mut().open(Path::new("examples/scenes/cast.json"));
    hand.settle();
    let row = hand.harness.get_by_label("Object comics").rect().center();
    hand.click(row);
    hand.settle();
    let rect = hand.app().viewport().rect().unwrap();
    hand.hover(rect.center() + vec2(0.0, -60.0));
    save(&mut hand, "scene");
    hand.harness.ctx.set_theme(Theme::Light);
    save(&mut hand, "scene-light");
    hand.harness.ctx.set_theme(Theme::Dark);
    let mut hand = window();
    let tab = hand.harness.get_by_role_and_label(Role::Tab, "Objects").rect().center();
    hand.click(tab);
    save(&mut hand, "objects-of-a-look");
    // Meshes of the folder that `CHIARO_MODELS` names, dropped one after the other.
    let Some(folder) = std::env::var_os("CHIARO_MODELS").map(PathBuf::from) else { return };
    hand.app_mut().open(Path::new("examples/looks/figure1-layers.json"));
    for mesh in ["spot.obj", "stanford-bunny.obj"] {
        hand.app_mut().add_mesh(&folder.join(mesh).to_string_lossy());
        hand.settle();
    }
    save(&mut hand, "objects-dropped");
}

/// Nodes found by name, a group that can be shared, a search that hides values, and messages over
/// the picture.
#[test]
#[ignore = "writes pictures to be looked at"]
fn found_and_shared_shots() {
    use eframe::egui::Modifiers;
    let mut hand = window();
    hand.app_mut().open(Path::new("examples/looks/figure1-layers.json"));
    hand.settle();
    hand.key_with(Modifiers::COMMAND, Key::F);
    hand.type_text("f");
    save(&mut hand, "find-nodes");
    hand.key(Key::Escape);
    hand.app_mut().session_mut().select(vec!["diffuse".into(), "specular".into()]);
    hand.settle();
    let search = hand.place("Find a value");
    hand.type_over(search, "color");
    hand.press("Solo Specular");
    hand.choose("View wire", "Tone");
    save(&mut hand, "over-the-picture");
    hand.press("Show the look");
    hand.press("Show all");
    let at = hand.empty_place();
    hand.hover(at);
    hand.key_with(Modifiers::COMMAND, Key::G);
    hand.key_with(Modifiers::COMMAND, Key::Enter);
    save(&mut hand, "share-a-group");
    hand.harness.ctx.set_theme(Theme::Light);
    hand.key_with(Modifiers::SHIFT, Key::Questionmark);
    save(&mut hand, "shortcuts-light");
}

/// Parts of a scene beside its objects: its own lights, values that an object sets, and a picture
/// where it is offered.
#[test]
#[ignore = "writes pictures to be looked at"]
fn shots_of_a_scenes_parts() {
    let home = tempfile::tempdir().unwrap();
    let example =
        |name: &str| std::fs::read_to_string(format!("examples/looks/{name}.json")).unwrap();
    let exposed = r#""exposed": [{"name": "highlight_size", "target": "highlight.cutoff"},
      {"name": "warm_side", "target": "diffuse.convex"}, {"name": "kind", "target": "diffuse.type"},
      {"name": "glow", "target": "highlight.opacity"}], "wires": "#;
    let look = example("figure5-directional").replacen("\"wires\":", exposed, 1);
    std::fs::write(home.path().join("directional.json"), look).unwrap();
    std::fs::write(home.path().join("comics.json"), example("figure6-comics")).unwrap();
    let scene = r##"{"chiaro": "scene", "name": "Two", "objects": [
      {"id": "knot", "mesh": "shape:knot", "transform": {"translate": [-1.1, 0, 0]},
      "looks": "directional.json",
       "values": {"glow": 0.4, "warm_side": "#5fb0e0"}},
      {"id": "creature", "mesh": "shape:creature", "transform": {"translate": [1.1, 0, 0]},
      "looks": "comics.json"}],
      "lights": {"key": {"name": "Evening sun", "direction": [-0.8, 0.4, 0.5],
      "color": [1, 0.8, 0.55]}},
      "camera": {"eye": [0, 0.6, 9]}, "backdrop": [0.09, 0.08, 0.12, 1]}"##;
    std::fs::write(home.path().join("two.json"), scene).unwrap();
    let folder = home.path().to_owned();
    let mut hand = window_of(move |app| {
        let mut app = app.without_dialogs();
        let places =
            chiaro::editor::Places { state: folder.join("state"), config: folder.join("config") };
        app.keep_in(places, &eframe::egui::Context::default());
        app
    });
    hand.app_mut().open(&home.path().join("two.json"));
    hand.settle();
    click_label(&mut hand, "Object knot");
    save(&mut hand, "scene-values");
    hand.tab("Lights");
    save(&mut hand, "scene-lights");
    let row = hand.place("Light Evening sun of the scene shines");
    hand.click(row.left_center() - vec2(14.0, 0.0));
    save(&mut hand, "scene-light-open");
    click_label(&mut hand, "Add scene light");
    save(&mut hand, "scene-light-add");
    hand.key(Key::Escape);
    hand.harness.ctx.set_theme(Theme::Light);
    hand.app_mut().open(Path::new("examples/scenes/cast.json"));
    hand.app_mut().open(Path::new("examples/scenes/figure5-from-behind.json"));
    hand.app_mut().show_start_page();
    for _ in 0..60 {
        hand.harness.run_steps(2);
        hand.settle();
    }
    save(&mut hand, "scene-start");
}

/// A value keyed by a light's height, half-way between two keys, in the inspector and the Keys
/// panel.
#[test]
#[ignore = "writes pictures to be looked at"]
fn keyed_by_a_height_shots() {
    let mut hand = window();
    hand.app_mut().session_mut().select(vec!["diffuse".into()]);
    hand.settle();
    click(&mut hand, "Keys of Cut-off");
    click(&mut hand, "New keys by a distance or height…");
    click(&mut hand, "New keys by: Height of \"key\"");
    click(&mut hand, "Copy key");
    save(&mut hand, "keyed-by-height");
    hand.app_mut().open(Path::new("examples/hcbtf/pencil.json"));
    hand.settle();
    hand.app_mut().session_mut().select(vec!["painting".into()]);
    save(&mut hand, "long-names");
}

/// A document that the last program ended over: its tile on the start page, and the window that it
/// is opened in.
#[test]
#[ignore = "writes pictures to be looked at"]
fn crash_shots() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("chain.json");
    std::fs::copy("examples/looks/figure1-layers.json", &path).unwrap();
    let state = folder.path().join("state");
    std::fs::create_dir_all(state.join("running")).unwrap();
    let document = serde_json::json!({"name": "chain.json", "path": path});
    let line = serde_json::json!({"begin": {"number": 0, "step": "draw", "document": document}});
    std::fs::write(state.join("running/window-gone.running"), line.to_string()).unwrap();
    let places = chiaro::editor::Places { state, config: folder.path().join("config") };
    let (file, other) = (path.clone(), folder.path().join("other.json"));
    std::fs::copy("examples/looks/figure4-both.json", &other).unwrap();
    let mut setup = default_wgpu_setup();
    if let WgpuSetup::CreateNew(setup) = &mut setup {
        setup.device_descriptor = Arc::new(device_descriptor);
    }
    let gpu = create_render_state(setup, eframe::egui_wgpu::RendererOptions::PREDICTABLE);
    let builder = Harness::builder()
        .with_size(vec2(1600.0, 960.0))
        .renderer(WgpuTestRenderer::from_render_state(gpu.clone()));
    let mut hand = User::with_builder(builder, move |ctx| {
        let mut app = App::new(ctx, Some(gpu.clone())).without_dialogs();
        app.keep_in(places.clone(), ctx);
        app.change_settings(|settings| {
            [&other, &file].into_iter().for_each(|path| settings.opened(path));
        });
        app.begin();
        app
    });
    save(&mut hand, "crash-start");
    hand.app_mut().open(&path);
    save(&mut hand, "crash-held");
    hand.tab("Lights");
    hand.press("Try again");
    let light = hand.place("Light key shines").left_center();
    hand.click(light - vec2(14.0, 0.0));
    hand.settle();
    hand.choose("Type", "Spot");
    save(&mut hand, "light-fall-off");
}

/// A light placed by its terminator and by its shadow, and the probe's list of lights.
#[test]
#[ignore = "writes pictures to be looked at"]
fn placing() {
    let mut hand = window();
    hand.app_mut().open(Path::new("examples/looks/figure1-layers.json"));
    hand.settle();
    hand.press("Layer Diffuse");
    hand.press("Place light");
    hand.press("Place by its terminator");
    let center = hand.app().viewport().rect().unwrap().center();
    hand.click(center + vec2(30.0, 20.0));
    save(&mut hand, "placing-terminator");
    hand.press("Place by its shadow");
    hand.click(center + vec2(0.0, -60.0));
    hand.settle();
    hand.hover(center + vec2(40.0, 80.0));
    save(&mut hand, "placing-shadow");
    hand.press("Probe pixel");
    hand.click(center);
    hand.settle();
    hand.press("Why lit so");
    save(&mut hand, "why-lit");
    hand.app_mut().open(Path::new("examples/scenes/lit-room.json"));
    hand.settle();
    let center = hand.app().viewport().rect().unwrap().center();
    hand.click(center);
    save(&mut hand, "why-lit-room");
}
