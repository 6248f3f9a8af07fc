//! A newcomer's first minutes: the start page, the tour from nothing to a saved look, typed paths
//! where the system shows no dialog, and copies to the clipboard. Every widget is found by the name
//! that a screen reader tells.

use std::fs;
use std::path::{Path, PathBuf};

use crate::editor_support::User;
use chiaro::document::{Look, Value};
use chiaro::editor::{App, Places};
use eframe::egui::{Event, Key, Modifiers, Pos2, Rect, Role, Theme, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};

/// Temporary folders of one user: for the program's state and configuration, and for the user's
/// files.
struct Home(tempfile::TempDir);

impl Home {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn file(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// A window with this user's folders, opened as the program opens it, but without dialogs of
    /// the system.
    fn window(&self, file: Option<&Path>) -> User {
        let places = Places { state: self.file("state"), config: self.file("config") };
        let file = file.map(Path::to_path_buf);
        User::with(move |ctx| {
            let mut app = App::new(ctx, None).with_path_fields();
            app.keep_in(places.clone(), ctx);
            match &file {
                Some(file) => app.open(file),
                None => app.begin(),
            }
            app
        })
    }
}

fn has(hand: &User, label: &str) -> bool {
    hand.harness.query_all_by_label(label).next().is_some()
}

fn says(hand: &User, text: &str) -> bool {
    hand.harness.query_all_by_label_contains(text).next().is_some()
}

fn press(hand: &mut User, label: &str) {
    let node = hand.harness.query_all_by_label(label).next();
    let at = node.unwrap_or_else(|| panic!("no {label}")).rect().center();
    hand.click(at);
    hand.settle();
}

/// Chooses a command by its name, as Ctrl+P offers it.
fn command(hand: &mut User, words: &str) {
    hand.key_with(Modifiers::COMMAND, Key::P);
    hand.type_text(words);
    hand.key(Key::Enter);
    hand.settle();
}

fn focused(hand: &User) -> Option<String> {
    let nodes = hand.harness.query_all_by(|node| node.is_focused());
    nodes.filter_map(|node| node.accesskit_node().label()).next()
}

/// Text of the clipboard after the keys that copy the shader.
fn copied_by_keys(hand: &mut User) -> Option<String> {
    let modifiers = Modifiers::COMMAND | Modifiers::SHIFT;
    hand.harness.event(Event::Key {
        key: Key::W,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers,
    });
    hand.harness.step();
    hand.take_copied()
}

fn compiles(hand: &User) -> bool {
    let session = hand.app().session();
    session.compilation().problems().is_empty() && session.compilation().baked().is_some()
}

fn layers(look: &Look) -> usize {
    look.graph.nodes.values().filter(|node| node.kind == "light_layer").count()
}

#[test]
fn the_start_page_has_every_example_and_leaves_when_one_is_opened() {
    let home = Home::new();
    let mut hand = home.window(None);
    assert!(hand.app().shows_start_page());
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let files = |name: &str| {
        let files = fs::read_dir(folder.join(name)).unwrap().map(|entry| entry.unwrap().path());
        files
            .filter(|path| path.extension().is_some_and(|ending| ending == "json"))
            .collect::<Vec<_>>()
    };
    let mut count = 0;
    for path in [files("looks"), files("shadows"), files("images"), files("hcbtf")].concat() {
        let name = Look::load(&chiaro::files::Disk, &path).value.unwrap().name;
        let is_figure = path.file_stem().unwrap().to_string_lossy().starts_with("figure");
        let figure = if is_figure { " · Figure" } else { "" };
        assert!(says(&hand, &format!("Open the look {name}{figure}")), "{name}");
        count += 1;
    }
    let cards =
        hand.harness.get_all_by_role(Role::Button).filter_map(|node| node.accesskit_node().label());
    assert_eq!(
        cards.filter(|label| label.starts_with("Open the look ")).count(),
        count,
        "and nothing is there twice"
    );
    let scenes =
        hand.harness.get_all_by_role(Role::Button).filter_map(|node| node.accesskit_node().label());
    assert_eq!(
        scenes.filter(|label| label.starts_with("Open the scene ")).count(),
        files("scenes").len()
    );
    assert!(!has(&hand, "Recent files") && !says(&hand, "is gone"));
    // Nothing is clicked first: what is typed is searched for.
    hand.type_text("anime face");
    hand.settle();
    assert!(!has(&hand, "Open the look Stipple"), "only what has all words");
    press(&mut hand, "Open the look Anime face");
    assert!(!hand.app().shows_start_page());
    assert_eq!((hand.look().name.as_str(), hand.app().session().path()), ("Anime face", None));
    assert!(has(&hand, "Picture") && compiles(&hand));
}

#[test]
fn a_file_that_cannot_be_opened_is_told_above_the_start_page() {
    let home = Home::new();
    fs::write(home.file("odd.json"), "\n  not JSON at all").unwrap();
    let missing = "could not be opened: there is no such file";
    for (name, why, help) in [
        ("nope.txt", missing, "check the spelling"),
        ("nope.hcbtf", missing, "check the spelling"),
        ("odd.json", "(line 2, column", "odd.json"),
    ] {
        let mut hand = home.window(None);
        let told = hand.app_mut().begin_with(&home.file(name)).unwrap();
        hand.settle();
        assert!(told.contains(why) && told.contains(help), "a terminal is told the same: {told}");
        assert!(
            hand.app().shows_start_page() && says(&hand, &format!("{name} could not be opened")),
            "{name}"
        );
        assert!(
            says(&hand, why) && says(&hand, help) && says(&hand, home.file(name).to_str().unwrap()),
            "{name}"
        );
        assert!(!says(&hand, "os error"), "{name}");
        // The problem is told once: the open look has no problem, and the status bar does not
        // repeat it.
        assert!(
            hand.app().message().is_none()
                && hand.app().session().compilation().problems().is_empty(),
            "{name}"
        );
        assert!(!says(&hand, "1 error"), "{name}");
        press(&mut hand, "Understood");
        assert!(!says(&hand, "could not be opened") && hand.app().shows_start_page(), "{name}");
        // The message goes away when another document is opened, too.
        hand.app_mut().open(&home.file(name));
        hand.settle();
        assert!(says(&hand, "could not be opened"), "{name}");
        hand.press_a(Role::Button, "New look");
        assert!(!says(&hand, "could not be opened"), "{name}");
    }
}

#[test]
fn what_was_open_is_offered_and_what_is_gone_is_forgotten() {
    let home = Home::new();
    let [rim, lost, odd, stage] =
        ["rim.json", "lost.json", "odd.json", "stage.json"].map(|name| home.file(name));
    fs::write(
        &stage,
        r#"{"chiaro": "scene", "objects": [{"mesh": "shape:sphere", "looks": "rim.json"}]}"#,
    )
    .unwrap();
    fs::write(&rim, r#"{"name": "Rim", "nodes": [{"kind": "base"}, {"kind": "output"}]}"#).unwrap();
    fs::write(&odd, "not JSON at all").unwrap();
    let mut hand = home.window(None);
    hand.app_mut().change_settings(|settings| {
        [&odd, &lost, &rim, &stage].into_iter().for_each(|path| settings.opened(path));
    });
    hand.settle();
    assert!(
        has(&hand, "Open the look rim")
            && has(&hand, "Open the look odd")
            && has(&hand, "lost is gone")
    );
    assert!(has(&hand, "Open the scene stage"));
    // The tile of the file that is gone has a place of its own.
    let rect = |label: &str| hand.harness.get_by_label(label).rect();
    let others = ["Open the look rim", "Open the scene stage", "Open the look odd"].map(rect);
    assert!(others.iter().all(|other| !other.intersects(rect("lost is gone").shrink(1.0))));
    press(&mut hand, "Forget lost");
    assert!(!has(&hand, "lost is gone") && !hand.app().settings().recent.contains(&lost));
    assert!(hand.app().shows_start_page(), "forgetting opens nothing");
    press(&mut hand, "Open the look odd");
    assert!(hand.app().shows_start_page(), "what cannot be read is told, and nothing is lost");
    assert!(hand.says("odd.json could not be opened") && hand.app().message().is_none());
    press(&mut hand, "Open the look rim");
    assert!(!hand.app().shows_start_page());
    assert_eq!(hand.app().session().path(), Some(rim.as_path()));

    // The page lies over the open document, which is unchanged when the page is closed.
    command(&mut hand, "start page");
    assert!(hand.app().shows_start_page());
    fs::remove_file(&rim).unwrap();
    // The message bar above tells of the missing file too, and moves the page when it appears.
    hand.app_mut().look_at_files();
    hand.settle();
    assert!(has(&hand, "rim is gone"), "files are looked for while the page is seen");
    press(&mut hand, "Close the start page");
    assert!(!hand.app().shows_start_page());
    assert_eq!(hand.look().name, "Rim");
}

#[test]
fn paintings_that_were_open_show_themselves_and_examples_are_no_files() {
    use chiaro::document::{Address, Directions, Grid, Hcbtf, Tile};
    let home = Home::new();
    let directions = Directions { theta: 2, phi: 3 };
    let mut hcbtf = Hcbtf::new(Grid { size: [16, 8], light: directions, view: directions });
    let tile = Tile::filled(hcbtf.grid.size, [200, 90, 40, 255]);
    hcbtf.painted.insert(Address::default(), std::sync::Arc::new(tile));
    let path = home.file("surface.hcbtf");
    fs::write(&path, chiaro::hcbtf::write(&hcbtf).unwrap()).unwrap();
    let mut hand = home.window(Some(&path));
    hand.app_mut().open(Path::new("example:hcbtf/pencil.hcbtf"));
    hand.settle();
    hand.app_mut().show_start_page();
    hand.settle();
    assert!(has(&hand, "Open the painting surface") && says(&hand, "paintings that were open"));
    assert!(
        !says(&hand, "cannot be read") && !says(&hand, "is gone"),
        "an example is opened among the examples"
    );
    assert_eq!(hand.app().settings().recent, [path]);
    let at = hand.harness.get_by_label("Open the painting surface").rect().center();
    hand.hover(at);
    hand.harness.run_steps(8);
    assert!(says(&hand, "16 x 8 texels, 4 lights x 4 views, 1 of 16 samples painted"));
    press(&mut hand, "Open the painting surface");
    assert!(!hand.app().shows_start_page());
}

/// Goes to the first tile by keys, wherever the focus is.
fn to_first_tile(hand: &mut User) {
    for _ in 0..16 {
        match focused(hand).as_deref() {
            Some("Take the tour") => return,
            None => hand.key(Key::ArrowDown),
            Some(_) => hand.key_with(Modifiers::SHIFT, Key::Tab),
        }
    }
    panic!("the first tile is not reached");
}

#[test]
fn the_keyboard_reaches_everything() {
    let home = Home::new();
    let mut hand = home.window(None);
    assert_eq!(focused(&hand).as_deref(), Some("Find an example"));
    to_first_tile(&mut hand);
    hand.key(Key::Tab);
    assert_eq!(focused(&hand).as_deref(), Some("New look"));
    let mut seen = Vec::new();
    let is_example = |label: &String| label.starts_with("Open the look");
    for _ in 0..40 {
        hand.key(Key::Tab);
        seen.extend(focused(&hand));
        if seen.iter().filter(|label| is_example(label)).count() == 11 {
            break;
        }
    }
    assert!(seen.iter().any(|label| label == "Open a file"), "{seen:?}");
    assert!(seen.iter().any(|label| label == "Ink and print"), "subjects too: {seen:?}");
    let first = seen.iter().position(is_example).unwrap();
    assert_eq!(seen[first], "Open the look Anime face", "what sells comes first: {seen:?}");
    hand.key(Key::Escape);
    hand.key(Key::Escape);
    assert!(!hand.app().shows_start_page());
    hand.key_with(Modifiers::ALT, Key::Home);
    assert!(hand.app().shows_start_page());
    to_first_tile(&mut hand);
    for _ in 0..first + 2 {
        hand.key(Key::Tab);
    }
    hand.key(Key::Enter);
    hand.settle();
    assert_eq!(hand.look().name, "Anime face");
}

#[test]
fn only_a_window_without_anything_to_go_on_with_begins_at_the_start_page() {
    let home = Home::new();
    let path = home.file("a.json");
    fs::write(&path, r#"{"name": "A", "nodes": [{"kind": "base"}, {"kind": "output"}]}"#).unwrap();
    assert!(!home.window(Some(&path)).app().shows_start_page());
    let mut hand = home.window(None);
    assert!(hand.app().shows_start_page());
    hand.key_with(Modifiers::COMMAND, Key::N);
    hand.settle();
    assert!(!hand.app().shows_start_page(), "a new look is made");
    press(&mut hand, "Layer Diffuse");
    press(&mut hand, "Solo Diffuse");
    press(&mut hand, "Show Diffuse");
    assert!(hand.app().session().is_dirty());
    hand.app_mut().session_mut().close_journal(true);
    drop(hand);
    let hand = home.window(None);
    assert!(
        !hand.app().shows_start_page() && hand.app().session().is_dirty(),
        "unsaved work is gone on with"
    );
}

#[test]
fn the_start_page_holds_in_narrow_windows_at_any_scale_in_both_themes() {
    let home = Home::new();
    let mut hand = home.window(None);
    for (width, height) in [(1600.0, 960.0), (760.0, 480.0), (380.0, 240.0)] {
        hand.harness.set_size(vec2(width, height));
        for theme in [Theme::Dark, Theme::Light] {
            hand.harness.ctx.set_theme(theme);
            hand.settle();
            for label in ["Take the tour", "New look", "Open a file", "Close the start page"] {
                let rect = hand.harness.get_by_role_and_label(Role::Button, label).rect();
                assert!(
                    rect.left() >= 0.0 && rect.right() <= width + 0.5,
                    "{label} at {rect} of {width}"
                );
            }
            let card = hand.harness.get_by_label("Open the look Anime face").rect();
            assert!(card.right() <= width + 0.5 && card.width() > 100.0, "{card} of {width}");
        }
    }
}

/// Title of the tour's card, which names the step.
fn step(hand: &User) -> String {
    let nodes = hand.harness.query_all_by_label_contains(" of 7");
    nodes
        .filter_map(|node| node.accesskit_node().value().or(node.accesskit_node().label()))
        .next()
        .unwrap_or_default()
}

#[track_caller]
fn is_at(hand: &User, title: &str) {
    assert!(step(hand).starts_with(title), "at {:?}, not at {title}", step(hand));
}

/// Asserts that a step that is done says so and stays, for artists who would rather play on, until
/// the artist goes on.
#[track_caller]
fn goes_on(hand: &mut User, title: &str) {
    is_at(hand, title);
    hand.harness.run_steps(40);
    hand.settle();
    is_at(hand, title);
    assert!(!has(hand, "Skip"), "{title} is done");
    press(hand, "Next");
}

/// Rectangle of the tour's card.
fn card(hand: &User) -> Rect {
    let parts =
        ["End tour", "Back", "Show me"].map(|label| hand.harness.get_by_label(label).rect());
    parts.into_iter().reduce(Rect::union).unwrap()
}

fn on_tour(home: &Home) -> User {
    let mut hand = home.window(None);
    press(&mut hand, "Take the tour");
    assert!(hand.app().is_on_tour() && !hand.app().shows_start_page());
    assert_eq!(layers(hand.look()), 0, "from nothing");
    is_at(&hand, "The base");
    hand
}

#[test]
fn the_tour_goes_on_by_what_an_artist_does() {
    let home = Home::new();
    let mut hand = on_tour(&home);
    let nothing = hand.look().clone();

    // A click alone does not complete the step: the color must change.
    press(&mut hand, "Base Base");
    is_at(&hand, "The base");
    let field = hand
        .harness
        .get_all_by_role_and_label(Role::TextInput, "Color")
        .next()
        .unwrap()
        .rect()
        .center();
    hand.click(field);
    hand.key_with(Modifiers::COMMAND, Key::A);
    hand.type_text("#301d3c");
    hand.key(Key::Enter);
    hand.settle();
    assert_ne!(
        hand.look().graph.nodes["base"].values["color"],
        nothing.graph.nodes["base"].values["color"]
    );

    goes_on(&mut hand, "The base");
    is_at(&hand, "A first layer of light");
    press(&mut hand, "Add layer");
    is_at(&hand, "A first layer of light");
    press(&mut hand, "Add Diffuse");
    assert_eq!(layers(hand.look()), 1);

    goes_on(&mut hand, "A first layer of light");
    is_at(&hand, "Its profile");
    let cutoff = hand.harness.get_by_label("Cut-off of the profile").rect().center();
    hand.drag(cutoff, cutoff + vec2(30.0, 0.0));
    hand.settle();

    goes_on(&mut hand, "Its profile");
    is_at(&hand, "Turn the light");
    let before = hand.app().session().view().orbit().illumination;
    let picture = hand.app().viewport().rect().unwrap();
    // A drag beside the object turns the camera, which does not complete the step.
    hand.drag(picture.left_top() + vec2(6.0, 6.0), picture.left_top() + vec2(40.0, 20.0));
    hand.settle();
    is_at(&hand, "Turn the light");
    hand.drag(picture.center() + vec2(20.0, 34.0), picture.center() + vec2(80.0, 60.0));
    hand.settle();
    assert!(hand.app().session().view().orbit().illumination.angle_between(before) > 0.05);

    goes_on(&mut hand, "Turn the light");
    is_at(&hand, "A rim from behind");
    press(&mut hand, "Add layer");
    press(&mut hand, "Add Back-light");
    assert_eq!((layers(hand.look()), hand.look().lights.len()), (2, 2));

    goes_on(&mut hand, "A rim from behind");
    is_at(&hand, "How layers meet");
    let opacity = hand
        .harness
        .get_by_role_and_label(Role::SpinButton, "Opacity of Back-light")
        .rect()
        .center();
    hand.drag(opacity, opacity - vec2(40.0, 0.0));
    hand.settle();

    goes_on(&mut hand, "How layers meet");
    is_at(&hand, "Keep it");
    let path = home.file("first.json");
    hand.key_with(Modifiers::COMMAND, Key::S);
    hand.settle();
    type_path(&mut hand, &path);
    assert_eq!(hand.app().session().path(), Some(path.as_path()));

    goes_on(&mut hand, "Keep it");
    assert!(has(&hand, "This is your look") && compiles(&hand));
    let saved = Look::load(&chiaro::files::Disk, &path);
    assert!(
        !saved.has_errors() && saved.value.as_ref() == Some(hand.look()) && *hand.look() != nothing
    );
    press(&mut hand, "See the examples");
    assert!(!hand.app().is_on_tour() && hand.app().shows_start_page());
    assert!(has(&hand, "Open the look first"), "what was saved is offered");
}

/// Types a path into the field that the window asks for paths with.
fn type_path(hand: &mut User, path: &Path) {
    let field = hand.harness.get_by_role_and_label(Role::TextInput, "Path").rect().center();
    hand.click(field);
    hand.key_with(Modifiers::COMMAND, Key::A);
    hand.type_text(path.to_str().unwrap());
    hand.key(Key::Enter);
    hand.settle();
}

#[test]
fn the_tour_shows_every_step_and_ends_in_a_look() {
    let home = Home::new();
    let mut hand = on_tour(&home);
    let nothing = hand.look().clone();
    for title in [
        "The base",
        "A first layer of light",
        "Its profile",
        "Turn the light",
        "A rim from behind",
        "How layers meet",
    ] {
        is_at(&hand, title);
        press(&mut hand, "Show me");
        goes_on(&mut hand, title);
    }
    is_at(&hand, "Keep it");
    assert_eq!(layers(hand.look()), 2);
    assert!(*hand.look() != nothing && compiles(&hand));
    press(&mut hand, "Show me");
    type_path(&mut hand, &home.file("shown"));
    assert!(home.file("shown.json").is_file(), "an ending is added");
    goes_on(&mut hand, "Keep it");
    assert!(has(&hand, "This is your look"));
    let shown = hand.look().clone();
    press(&mut hand, "End tour");
    assert!(!hand.app().is_on_tour());
    assert_eq!(*hand.look(), shown, "ending leaves the look as it is");

    // Changes by *Show me* are steps like others.
    for _ in 0..5 {
        assert!(hand.app().session().steps().undo_label().is_some());
        hand.undo();
    }
    assert_eq!(*hand.look(), nothing);
}

#[test]
fn the_card_covers_nothing_that_a_step_speaks_of() {
    for size in [vec2(1500.0, 900.0), vec2(1920.0, 1080.0)] {
        let home = Home::new();
        let mut hand = on_tour(&home);
        hand.harness.set_size(size);
        hand.settle();
        for title in [
            "The base",
            "A first layer of light",
            "Its profile",
            "Turn the light",
            "A rim from behind",
        ] {
            is_at(&hand, title);
            let card = card(&hand);
            let picture = hand.app().viewport().rect().unwrap();
            assert!(!card.intersects(picture), "{title}: {card} over the picture at {picture}");
            let button = hand.harness.get_by_label("Add layer").rect();
            let row = hand.harness.get_by_label("Base Base").rect();
            assert!(
                !card.intersects(button) && !card.intersects(row),
                "{title}: {card} over the layers"
            );
            if title.starts_with("A ") {
                press(&mut hand, "Add layer");
                for choice in ["Add Fill", "Add Diffuse", "Add Back-light"] {
                    let choice = hand.harness.get_by_label(choice).rect();
                    assert!(!card.intersects(choice), "{title}: {card} over the menu at {choice}");
                }
                hand.key(Key::Escape);
                hand.settle();
            }
            press(&mut hand, "Show me");
            press(&mut hand, "Next");
        }
    }
}

/// Place of the picture where a drag turns the lights: on the object, and clear of the lines and
/// handles there. The window tells it by its hint, once it knows the surface as it is seen now.
fn clear_place(hand: &mut User) -> Pos2 {
    let center = hand.app().viewport().rect().unwrap().center();
    let mut below = (0..8_u8).map(|step| center + vec2(0.0, 8.0 * f32::from(step)));
    let clear = below.find(|&at| {
        hand.hover(at);
        hand.settle();
        says(hand, "Drag to turn all lights")
    });
    clear.expect("the object is there, and is not all lines")
}

#[test]
fn the_rim_of_the_tour_is_seen_however_the_lights_were_turned() {
    let home = Home::new();
    let mut hand = on_tour(&home);
    for _ in 0..2 {
        press(&mut hand, "Show me");
        press(&mut hand, "Next");
    }
    press(&mut hand, "Skip");
    is_at(&hand, "Turn the light");
    // The lights turn half around: a light from behind the object now comes from before it.
    let look = hand.look().clone();
    let direction = hand.app().session().view().orbit().direction();
    for _ in 0..3 {
        let from = clear_place(&mut hand);
        hand.drag(from, from + vec2(120.0, 0.0));
    }
    hand.settle();
    let orbit = hand.app().session().view().orbit();
    assert!(*hand.look() == look && orbit.direction() == direction, "the lights alone are turned");
    let turned = orbit.illumination;
    assert!(turned.angle_between(glam::DQuat::IDENTITY) > 1.0);
    goes_on(&mut hand, "Turn the light");
    press(&mut hand, "Show me");
    let light = glam::DVec3::from(hand.look().lights["back"].direction).normalize();
    let to_eye = (turned * light).dot(hand.app().session().view().orbit().direction());
    assert!(
        (-0.8..0.0).contains(&to_eye),
        "behind what is seen, and not so far that its rim is not: {to_eye}"
    );
}

#[test]
fn the_tour_of_lights_shows_every_step_and_ends_in_a_lit_scene() {
    let home = Home::new();
    let mut hand = home.window(None);
    press(&mut hand, "Light a scene");
    assert!(hand.app().is_on_tour() && !hand.app().shows_start_page());
    let scene = |hand: &User| hand.app().session().open_scene().unwrap().scene().clone();
    assert_eq!((scene(&hand).objects.len(), scene(&hand).lights.len()), (3, 0));
    assert!(hand.app().session().compilation().problems().is_empty(), "the look is whole");
    for step in 1..=8 {
        assert!(hand.says(&format!("{step} of 8")));
        assert!(has(&hand, "Skip"), "step {step} is not done yet");
        press(&mut hand, "Show me");
        assert!(!has(&hand, "Skip"), "step {step} is done");
        if step == 2 {
            press(&mut hand, "Place light");
            assert!(hand.app().placing().is_on());
        }
        press(&mut hand, "Next");
        assert!(!hand.app().placing().is_on(), "the pointer is free for step {}", step + 1);
    }
    assert!(hand.says("3 lights of the scene"));
    let lit = scene(&hand);
    assert_eq!(lit.lights.len(), 3);
    assert!(lit.light_groups["rim"].intensity < 1.0);
    assert_eq!(lit.objects["ball"].linked.text(), "* - eye");
    press(&mut hand, "End tour");
    assert!(!hand.app().is_on_tour() && scene(&hand) == lit);
}

#[test]
fn the_tour_can_be_left_gone_back_in_and_undone() {
    let home = Home::new();
    let mut hand = on_tour(&home);
    press(&mut hand, "Show me");
    goes_on(&mut hand, "The base");
    is_at(&hand, "A first layer of light");
    press(&mut hand, "Back");
    is_at(&hand, "The base");
    assert!(has(&hand, "Next"), "it is done already, and stays until the artist goes on");
    hand.undo();
    hand.settle();
    assert!(has(&hand, "Skip") && !has(&hand, "Next"), "what is undone is not done");
    press(&mut hand, "Skip");
    is_at(&hand, "A first layer of light");
    press(&mut hand, "Skip");
    is_at(&hand, "Its profile");
    let shows = hand.harness.get_by_role_and_label(Role::Button, "Show me");
    assert!(shows.accesskit_node().is_disabled(), "there is no layer to shape");
    let before = hand.look().clone();
    press(&mut hand, "End tour");
    assert!(!hand.app().is_on_tour() && *hand.look() == before);

    // Opening another look ends the tour too, and the menu starts the tour again.
    press(&mut hand, "Help");
    press(&mut hand, "Take the tour");
    assert!(hand.app().is_on_tour());
    hand.key_with(Modifiers::COMMAND, Key::N);
    hand.settle();
    assert!(!hand.app().is_on_tour());
}

#[test]
fn paths_are_asked_for_in_the_window_where_there_is_no_dialog() {
    let home = Home::new();
    let path = home.file("a.json");
    fs::write(&path, r#"{"name": "A", "nodes": [{"kind": "base"}, {"kind": "output"}]}"#).unwrap();
    let mut hand = home.window(None);
    press(&mut hand, "Open a file");
    assert!(says(&hand, "shows no file dialog"));
    type_path(&mut hand, &home.file("nowhere.json"));
    assert!(says(&hand, "There is no such file") && hand.app().shows_start_page());
    type_path(&mut hand, home.0.path());
    assert!(has(&hand, "a.json"), "a folder is gone into, and shows what it has");
    press(&mut hand, "a.json");
    press(&mut hand, "Open this");
    assert_eq!(hand.app().session().path(), Some(path.as_path()));

    // Saving under the name of another file says so first.
    fs::write(home.file("b.json"), "mine").unwrap();
    press(&mut hand, "Save as");
    let field = hand.harness.get_by_role_and_label(Role::TextInput, "Path").rect().center();
    hand.click(field);
    hand.key_with(Modifiers::COMMAND, Key::A);
    hand.type_text(home.file("b.json").to_str().unwrap());
    hand.settle();
    assert!(says(&hand, "it would be replaced"));
    hand.key(Key::Escape);
    hand.settle();
    if has(&hand, "Cancel") {
        press(&mut hand, "Cancel");
    }
    assert_eq!(fs::read_to_string(home.file("b.json")).unwrap(), "mine");

    // The field for a path can always be opened by its key.
    hand.key_with(Modifiers::COMMAND | Modifiers::SHIFT, Key::O);
    hand.settle();
    assert!(!says(&hand, "shows no file dialog") && says(&hand, "a sheet of a wedge"));
    // A double click on a file of the list opens it.
    let other = home.file("c.json");
    fs::copy(&path, &other).unwrap();
    type_path(&mut hand, home.0.path());
    let row = hand.harness.get_by_role_and_label(Role::Button, "c.json").rect().center();
    hand.double_click(row);
    hand.settle();
    assert_eq!(hand.app().session().path(), Some(other.as_path()));
}

#[test]
fn what_is_typed_right_after_its_key_goes_to_the_palette() {
    let mut hand = User::new();
    hand.app_mut().session_mut().select(vec!["diffuse".into()]);
    hand.settle();
    let look = hand.look().clone();
    let key = |key, modifiers| Event::Key {
        key,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers,
    };
    // A slow window gets the first letters with the key itself and before the palette is there.
    let first = [key(Key::P, Modifiers::COMMAND), key(Key::X, Modifiers::NONE)];
    hand.harness.input_mut().events.extend(first);
    hand.harness.input_mut().events.push(Event::Text("x".to_owned()));
    hand.harness.run_steps(1);
    hand.harness.input_mut().events.push(key(Key::X, Modifiers::NONE));
    hand.harness.input_mut().events.push(Event::Text("y".to_owned()));
    hand.harness.run_steps(1);
    hand.type_text("z");
    hand.settle();
    let query = "Find a command or a node";
    let field = hand.harness.get_by_role_and_label(Role::SearchInput, query);
    assert_eq!(field.value().as_deref(), Some("xyz"));
    assert_eq!(hand.look().graph.nodes, look.graph.nodes, "nothing of it reached the graph");
}

/// The field stays where a file cannot be written, with the whole reason.
#[test]
fn a_path_that_cannot_be_written_is_asked_for_again() {
    let home = Home::new();
    let [kept, other] = ["kept.json", "other.json"].map(|name| home.file(name));
    std::fs::write(&kept, "{}").unwrap();
    let set_read_only = |is_so: bool| {
        let mut permissions = std::fs::metadata(&kept).unwrap().permissions();
        permissions.set_readonly(is_so);
        std::fs::set_permissions(&kept, permissions).unwrap();
    };
    set_read_only(true);
    let mut hand = User::with(|ctx| App::new(ctx, None).with_path_fields());
    hand.settle();
    press(&mut hand, "Save as");
    let type_path = |hand: &mut User, path: &Path| {
        let field = hand.harness.get_by_role_and_label(Role::TextInput, "Path").rect();
        hand.type_over(field, path.to_str().unwrap());
    };
    let width = hand.text_field("Path").width();
    type_path(&mut hand, &kept);
    let told = format!("Not saved: {}", kept.display());
    for part in [&*told, "the file is read-only", "choose another place"] {
        assert!(says(&hand, part), "{part}");
    }
    assert_eq!(hand.text_field("Path").width(), width, "a long reason takes several lines");
    assert_eq!(std::fs::read_to_string(&kept).unwrap(), "{}");
    // What was told is about that path alone.
    type_path(&mut hand, &other);
    assert!(other.is_file() && !says(&hand, "Not saved"), "it is saved elsewhere");
    assert_eq!(hand.app().session().path(), Some(&*other));
    set_read_only(false);
}

#[test]
fn a_path_that_leads_nowhere_is_typed_again_at_once() {
    let home = Home::new();
    let path = opened_once(&home);
    let mut hand = User::with(|ctx| App::new(ctx, None).with_path_fields());
    hand.settle();
    press(&mut hand, "Open");
    let field = hand.harness.get_by_role_and_label(Role::TextInput, "Path").rect();
    hand.type_over(field, home.file("nowhere.json").to_str().unwrap());
    assert!(says(&hand, "There is no such file"));
    hand.key_with(Modifiers::COMMAND, Key::A);
    hand.type_text(path.to_str().unwrap());
    hand.key(Key::Enter);
    hand.settle();
    assert_eq!(hand.app().session().path(), Some(&*path));
}

#[test]
fn keys_typed_in_a_dialog_are_the_dialogs_alone() {
    let home = Home::new();
    let path = home.file("toonsnx.json");
    let mut hand = User::with(|ctx| App::new(ctx, None).with_path_fields());
    hand.app_mut().session_mut().select(vec!["diffuse".into()]);
    hand.settle();
    let look = hand.look().clone();
    press(&mut hand, "Save as");
    let field = hand.harness.get_by_role_and_label(Role::TextInput, "Path").rect().center();
    hand.click(field);
    hand.key_with(Modifiers::COMMAND, Key::A);
    // A quick user in a slow window: all input in one frame, letters as keys and as text.
    let key = |key| Event::Key {
        key,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers: Modifiers::NONE,
    };
    let events = &mut hand.harness.input_mut().events;
    events.push(Event::Text(path.to_str().unwrap().to_owned()));
    events.extend([Key::N, Key::X, Key::Enter, Key::Delete].map(key));
    hand.settle();
    assert!(path.is_file() && !has(&hand, "Save here"), "it is saved");
    assert_eq!(hand.look().graph.nodes, look.graph.nodes, "nothing of it reached the graph");
    // Keys typed after that are the graph's again.
    hand.key(Key::X);
    assert!(!hand.look().graph.nodes.contains_key("diffuse"));
}

/// Leaves the notes of a program that ended in a step on a file.
fn leave_interrupted(home: &Home, step: &str, path: &Path) {
    let document = serde_json::json!({"name": path.file_name().unwrap().to_str(), "path": path});
    let line = serde_json::json!({"begin": {"number": 0, "step": step, "document": document}});
    let folder = home.file("state/running");
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("window-gone.running"), format!("{line}\n")).unwrap();
}

/// A look of the user's that was open once.
fn opened_once(home: &Home) -> PathBuf {
    let path = home.file("a.json");
    let nodes = r#"[{"kind": "base"}, {"kind": "output"}]"#;
    let wires = r#"[{"from": "base", "to": "output.color"}]"#;
    fs::write(&path, format!(r#"{{"name": "A", "nodes": {nodes}, "wires": {wires}}}"#)).unwrap();
    drop(home.window(Some(&path)));
    path
}

#[test]
fn what_the_last_program_ended_over_is_drawn_by_hand_alone() {
    let home = Home::new();
    let path = opened_once(&home);
    for step in ["draw", "compile"] {
        leave_interrupted(&home, step, &path);
        // Opening the start page alone changes nothing.
        drop(home.window(None));
        let mut hand = home.window(None);
        assert!(hand.app().shows_start_page());
        press(&mut hand, "Open the look a, which was not drawn");
        assert_eq!(hand.app().session().path(), Some(path.as_path()));
        assert!(
            hand.app().session().compilation().baked().is_none()
                && hand.app().session().compilation().live().is_none()
        );
        assert!(says(&hand, "a.json is open without being drawn: Chiaro ended while"));
        press(&mut hand, "Try again");
        assert!(
            hand.app().session().compilation().baked().is_some()
                && !says(&hand, "without being drawn")
        );
        drop(hand);
        let hand = home.window(None);
        assert!(has(&hand, "Open the look a"), "it was drawn, and is as any other");
    }
}

#[test]
fn what_is_held_back_can_be_mended() {
    let home = Home::new();
    let path = opened_once(&home);
    leave_interrupted(&home, "draw", &path);
    let mut hand = home.window(Some(&path));
    assert!(says(&hand, "a.json is open without being drawn"));
    // Another document is drawn meanwhile, and the held-back one is still held back after it.
    hand.key_with(Modifiers::COMMAND, Key::N);
    hand.settle();
    assert!(compiles(&hand) && !says(&hand, "without being drawn"));
    hand.app_mut().open(&path);
    hand.settle();
    assert!(hand.app().session().compilation().baked().is_none());
    let removed = hand.app_mut().session_mut().apply(
        chiaro::document::Edit::RemoveNode {
            graph: chiaro::document::GraphId::Look,
            id: "base".into(),
        },
        None,
    );
    assert!(removed.is_ok(), "it can be mended while it is not drawn");
    hand.settle();
    assert!(hand.app().session().compilation().baked().is_none());
}

#[test]
fn what_the_last_program_ended_over_while_reading_is_not_read() {
    let home = Home::new();
    let path = opened_once(&home);
    leave_interrupted(&home, "read", &path);
    let mut hand = home.window(None);
    press(&mut hand, "Open the look a, which was not read");
    assert!(says(&hand, "a.json was not opened: Chiaro ended while reading it the last time"));
    assert!(hand.app().session().path().is_none());
    press(&mut hand, "Try again");
    assert_eq!(hand.app().session().path(), Some(path.as_path()));
    assert!(hand.app().session().compilation().baked().is_some() && !says(&hand, "was not opened"));
}

#[test]
fn work_on_what_the_last_program_ended_over_is_not_gone_on_with_by_itself() {
    let home = Home::new();
    let path = opened_once(&home);
    let mut hand = home.window(Some(&path));
    hand.add("add", eframe::egui::pos2(40.0, 320.0));
    hand.settle();
    hand.app().session().wait_for_journal();
    drop(hand);
    leave_interrupted(&home, "draw", &path);
    let mut hand = home.window(None);
    assert!(hand.app().shows_start_page() && hand.app().session().path().is_none());
    press(&mut hand, "Restore it");
    assert_eq!(
        (hand.app().session().path(), hand.look().graph.nodes.len()),
        (Some(path.as_path()), 3)
    );
    assert!(says(&hand, "a.json is open without being drawn"));
}

/// Variable that names the folder of a window to be killed; the test starts this program again with
/// it set.
const KILLED: &str = "CHIARO_KILLED_WINDOW";

/// Opens a look that takes long to compile, in a window that is killed.
#[test]
fn killed_window() {
    let Some(folder) = std::env::var_os(KILLED).map(PathBuf::from) else { return };
    let places = Places { state: folder.join("state"), config: folder.join("config") };
    User::with(move |ctx| {
        let mut app = App::new(ctx, None).with_path_fields();
        app.keep_in(places.clone(), ctx);
        app.open(&folder.join("chain.json"));
        app
    });
}

/// A look with a chain of `length` additions.
fn chain(length: usize) -> String {
    let node = |index: usize| {
        serde_json::json!({
            "id": format!("n{index}"), "kind": "add", "values": {"b": 0.001}
        })
    };
    let mut nodes: Vec<_> = (0..length).map(node).collect();
    let wire = |index: usize| {
        serde_json::json!({
            "from": format!("n{}", index - 1), "to": format!("n{index}.a")
        })
    };
    let mut wires: Vec<_> = (1..length).map(wire).collect();
    nodes.push(serde_json::json!({"id": "output", "kind": "output"}));
    wires.push(serde_json::json!({"from": format!("n{}", length - 1), "to": "output.color"}));
    serde_json::json!({"nodes": nodes, "wires": wires}).to_string()
}

#[test]
fn a_window_that_is_killed_while_it_compiles_is_remembered_by_the_next_one() {
    let home = Home::new();
    let path = home.file("chain.json");
    fs::write(&path, chain(4000)).unwrap();
    let mut child = std::process::Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "start::killed_window", "--test-threads=1"])
        .env(KILLED, home.0.path())
        .stdout(std::process::Stdio::null())
        .spawn()
        .unwrap();
    let compiles = || {
        let files = fs::read_dir(home.file("state/running")).into_iter().flatten().flatten();
        let texts = files.filter_map(|file| fs::read_to_string(file.path()).ok());
        texts
            .flat_map(|text| text.lines().map(str::to_owned).collect::<Vec<_>>())
            .any(|line| line.contains("chain.json") && line.contains("\"compile\""))
    };
    while !compiles() {
        assert!(child.try_wait().unwrap().is_none(), "it works until it is killed");
        std::thread::yield_now();
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let hand = home.window(None);
    assert!(hand.app().shows_start_page());
    assert!(has(&hand, "Open the look chain, which was not drawn"), "it was opened last");
}

#[test]
fn the_shader_is_copied_as_wgsl() {
    let mut hand = User::new();
    let wgsl = copied_by_keys(&mut hand).expect("the shader is in the clipboard");
    assert_eq!(Some(&wgsl), hand.app().session().compilation().baked().map(|shader| &shader.wgsl));
    assert!(hand.app().message().unwrap().contains("WGSL"));
    press(&mut hand, "Copy as");
    for label in [
        "Copy the picture as an image",
        "Copy the shader as WGSL",
        "nodes as text",
        "as GLSL ES 3.00",
        "HLSL",
    ] {
        assert!(says(&hand, label), "{label}");
    }
    hand.key(Key::Escape);
    // A look that does not compile has no shader to copy, and the window says why.
    let edit = chiaro::document::Edit::SetKind {
        graph: chiaro::document::GraphId::Look,
        id: "diffuse".into(),
        kind: "nothing_such".to_owned(),
    };
    hand.app_mut().session_mut().apply(edit, None).unwrap();
    hand.settle();
    let is_none = hand.app().session().compilation().baked().is_none();
    assert_eq!(copied_by_keys(&mut hand).is_none(), is_none);
    assert!(matches!(hand.look().graph.nodes["base"].values["color"], Value::Vector(_)));
}

/// Opens a card of the start page by the keyboard, because it may lie below the visible part.
fn open_card(hand: &mut User, label: &str) {
    let card = hand
        .harness
        .get_all_by_role(Role::Button)
        .find(|node| node.accesskit_node().label().as_deref() == Some(label));
    card.unwrap_or_else(|| panic!("there is no {label}")).focus();
    hand.settle();
    hand.key(Key::Enter);
    hand.settle();
}

#[test]
fn an_example_of_an_hcbtf_brings_its_file_along_wherever_it_is_saved() {
    let home = Home::new();
    let mut hand = home.window(None);
    let metal = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/hcbtf/halftone.json");
    let name = Look::load(&chiaro::files::Disk, &metal).value.unwrap().name;
    open_card(&mut hand, &format!("Open the look {name}"));
    assert_eq!((hand.look().name.as_str(), hand.app().session().path()), (name.as_str(), None));
    assert!(compiles(&hand), "{:?}", hand.app().session().compilation().problems());
    let saved = home.file("mine.json");
    assert!(hand.app_mut().save_as(&saved));
    let (setup, problems) =
        chiaro::frame::open(&saved, None, &mut chiaro::frame::Assets::default())
            .unwrap()
            .into_parts();
    assert!(problems.is_empty() && setup.looks.len() == 1);
    let mut assets = chiaro::frame::Assets::default();
    assets.draft();
    let options = chiaro::hcbtf::LayerOptions::default();
    let named = chiaro::frame::SetupLook::clone(&setup.looks[0]);
    let image = assets.hcbtf(&named.folder, "example:hcbtf/halftone.hcbtf", options).unwrap().value;
    // A draft has 1 + 2 x 4 views that differ at most, and a layer that holds the grid.
    assert!((2..=10).contains(&image.layers), "{}", image.layers);
}

#[test]
fn an_example_scene_opens_as_a_new_one_of_ones_own() {
    let home = Home::new();
    let mut hand = home.window(None);
    open_card(&mut hand, "Open the scene Painted surfaces");
    assert!(!hand.app().shows_start_page());
    let open_scene = hand.app().session().open_scene().expect("a scene");
    assert_eq!(
        (open_scene.scene().objects.len(), open_scene.path(), hand.app().session().path()),
        (10, None, None)
    );
    let wrong: Vec<String> = open_scene.problem_texts().map(str::to_owned).collect();
    assert!(
        wrong.is_empty() && compiles(&hand),
        "{wrong:?} {:?}",
        hand.app().session().compilation().problems()
    );
    // The scene is saved with the names of the examples that it wears, which are found again.
    let (look, scene) = (home.file("arch.json"), home.file("scene.json"));
    assert!(hand.app_mut().save_as(&look));
    hand.app_mut().session_mut().save_scene_as(&scene).unwrap();
    let text = fs::read_to_string(&scene).unwrap();
    assert!(
        text.contains("\"arch.json\"") && text.contains("\"example:hcbtf/grass.json\""),
        "{text}"
    );
    let setup =
        chiaro::frame::open(&scene, None, &mut chiaro::frame::Assets::default()).unwrap().value;
    assert_eq!((setup.objects.len(), setup.looks.len()), (10, 10));
}

#[test]
fn an_example_shot_opens_as_a_new_one_of_ones_own() {
    let home = Home::new();
    let mut hand = home.window(None);
    open_card(&mut hand, "Open the shot Evening 020: the guest");
    assert!(!hand.app().shows_start_page());
    let shot = hand.app().session().shot().expect("a shot");
    assert!(!shot.has_file() && !hand.app().session().is_dirty());
    assert!(shot.resolved().changes.iter().any(|change| change.look.is_some()), "of its look, too");
    assert_eq!(hand.look().name, "Guest, with shadows", "a look of the scene is open under it");
    let open_scene = hand.app().session().open_scene().unwrap();
    let wrong: Vec<String> = open_scene.problem_texts().map(str::to_owned).collect();
    assert!(
        wrong.is_empty() && compiles(&hand),
        "{wrong:?} {:?}",
        hand.app().session().compilation().problems()
    );
    // The shot is saved with the names of the examples that it changes, which are found again.
    let file = home.file("guest.json");
    hand.app_mut().session_mut().save_shot_as(&file).unwrap();
    let text = fs::read_to_string(&file).unwrap();
    for name in ["\"example:shots/evening.json\"", "\"example:shadows/lit-guest.json\""] {
        assert!(text.contains(name), "{text}");
    }
    let setup =
        chiaro::frame::open(&file, None, &mut chiaro::frame::Assets::default()).unwrap().value;
    assert!(setup.shot.is_some() && !setup.objects.is_empty());
    // As a recent file it has a card.
    hand.app_mut().open(&file);
    hand.settle();
    hand.key_with(Modifiers::ALT, Key::Home);
    hand.settle();
    assert!(hand.harness.query_by_role_and_label(Role::Button, "Open the shot guest").is_some());
}

#[test]
fn an_example_shot_opens_by_its_name() {
    let home = Home::new();
    let name = Path::new("example:shots/nightfall/nightfall-010.json");
    let hand = home.window(Some(name));
    assert!(hand.app().session().shot().is_some_and(|shot| !shot.has_file()));
    assert!(hand.app().session().open_scene().unwrap().scene().objects.len() == 4);
}
