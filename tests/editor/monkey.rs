//! A monkey at the window: random gestures, the same in every run of a seed. Nothing panics, the
//! document can always be read back, undo leads back to the file as it was, and redo to the last
//! change.
//!
//! `MONKEY_GESTURES` is the number of gestures of each seed (default 1,250); `scripts/soak` makes a
//! million.

use std::path::Path;

use crate::editor_support::User;
use crate::support::random::Random;
use chiaro::document::{Look, Scene};
use chiaro::editor::App;
use eframe::egui::{
    Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, PointerButton, Pos2, Rect, TouchPhase,
    pos2, vec2,
};
use egui_kittest::kittest::Queryable as _;

const WINDOW: [f32; 2] = [1500.0, 900.0];
/// Number of gestures between two checks of the document.
const ROUND: usize = 250;

struct Monkey {
    random: Random,
    hand: User,
    done: usize,
}

impl Monkey {
    fn new(seed: u64) -> Self {
        let hand = User::with_builder(egui_kittest::Harness::builder(), |ctx| {
            App::new(ctx, None).without_dialogs()
        });
        Self { random: Random::new(seed), hand, done: 0 }
    }

    fn event(&mut self, event: Event) {
        self.hand.harness.input_mut().events.push(event);
    }

    fn step(&mut self) {
        self.hand.harness.step();
    }

    /// A random point of the window, more often on the canvas and near its nodes.
    fn place(&mut self) -> Pos2 {
        let anywhere = pos2(
            self.random.between(0.0, f64::from(WINDOW[0])) as f32,
            self.random.between(0.0, f64::from(WINDOW[1])) as f32,
        );
        if self.random.chance(0.4) {
            return anywhere;
        }
        let ids: Vec<String> =
            self.hand.look().graph.nodes.keys().map(ToString::to_string).collect();
        if ids.is_empty() {
            return anywhere;
        }
        let rect = self
            .hand
            .app()
            .canvas()
            .node_rect(self.random.pick::<String>(&ids))
            .unwrap_or(Rect::NOTHING);
        if !rect.is_finite() {
            return anywhere;
        }
        let [x, y] = [(); 2].map(|()| self.random.between(-0.05, 1.05) as f32);
        let at = rect.min + vec2(x * rect.width(), y * rect.height());
        pos2(at.x.clamp(0.0, WINDOW[0]), at.y.clamp(0.0, WINDOW[1]))
    }

    fn modifiers(&mut self) -> Modifiers {
        let choices = [
            Modifiers::SHIFT,
            Modifiers::COMMAND,
            Modifiers::ALT,
            Modifiers::COMMAND | Modifiers::SHIFT,
        ];
        if self.random.chance(0.75) { Modifiers::NONE } else { *self.random.pick(&choices) }
    }

    fn button(&mut self) -> PointerButton {
        let others = [PointerButton::Secondary, PointerButton::Middle];
        if self.random.chance(0.85) { PointerButton::Primary } else { *self.random.pick(&others) }
    }

    fn press(&mut self, pos: Pos2, button: PointerButton, pressed: bool, modifiers: Modifiers) {
        self.event(Event::PointerButton { pos, button, pressed, modifiers });
    }

    fn click(&mut self) {
        let (at, button, modifiers) = (self.place(), self.button(), self.modifiers());
        self.event(Event::PointerMoved(at));
        self.step();
        let times = if self.random.chance(0.15) { 2 } else { 1 };
        for _ in 0..times {
            self.press(at, button, true, modifiers);
            self.press(at, button, false, modifiers);
        }
        self.step();
    }

    fn drag(&mut self) {
        let (from, to, button, modifiers) =
            (self.place(), self.place(), self.button(), self.modifiers());
        self.event(Event::PointerMoved(from));
        self.step();
        self.press(from, button, true, modifiers);
        self.step();
        for share in [0.5, 1.0] {
            self.event(Event::PointerMoved(from + (to - from) * share));
            self.step();
        }
        if self.random.chance(0.05) {
            self.key(Key::Escape, Modifiers::NONE);
        }
        self.press(to, button, false, modifiers);
        self.step();
    }

    fn wheel(&mut self) {
        let at = self.place();
        self.event(Event::PointerMoved(at));
        let delta = vec2(0.0, self.random.between(-120.0, 120.0) as f32);
        let modifiers = self.modifiers();
        self.event(Event::MouseWheel {
            unit: MouseWheelUnit::Point,
            delta,
            phase: TouchPhase::Move,
            source: MouseWheelSource::Unknown,
            modifiers,
        });
        self.step();
    }

    fn key(&mut self, key: Key, modifiers: Modifiers) {
        for pressed in [true, false] {
            self.event(Event::Key { key, physical_key: None, pressed, repeat: false, modifiers });
        }
        self.step();
    }

    fn any_key(&mut self) {
        let plain = [
            Key::Delete,
            Key::Escape,
            Key::Enter,
            Key::Tab,
            Key::F,
            Key::I,
            Key::R,
            Key::M,
            Key::H,
            Key::G,
            Key::ArrowLeft,
            Key::ArrowRight,
            Key::ArrowUp,
            Key::ArrowDown,
            Key::Backspace,
            Key::Space,
            Key::Home,
            Key::X,
            Key::S,
        ];
        let held = [
            Key::Z,
            Key::Y,
            Key::D,
            Key::C,
            Key::V,
            Key::A,
            Key::X,
            Key::G,
            Key::J,
            Key::P,
            Key::Z,
            Key::Z,
            Key::Enter,
        ];
        let (key, modifiers) = if self.random.chance(0.6) {
            (*self.random.pick(&plain), Modifiers::NONE)
        } else {
            let shift = if self.random.chance(0.3) { Modifiers::SHIFT } else { Modifiers::NONE };
            (*self.random.pick(&held), Modifiers::COMMAND | shift)
        };
        self.key(key, modifiers);
    }

    fn text(&mut self) {
        let words = [
            "noise", "mix", "1.5", "-", "1e9", "0", "#ff8800", "light", "äé", "..", "\"", "layer",
            "nan", "a b",
        ];
        let word = (*self.random.pick(&words)).to_owned();
        let event = if self.random.chance(0.2) { Event::Paste(word) } else { Event::Text(word) };
        self.event(event);
        self.step();
        if self.random.chance(0.7) {
            self.key(Key::Enter, Modifiers::NONE);
        }
    }

    fn gesture(&mut self) {
        match self.random.index(20) {
            0..8 => self.click(),
            8..14 => self.drag(),
            14 | 15 => self.wheel(),
            16..19 => self.any_key(),
            _ => self.text(),
        }
        self.done += 1;
    }

    /// Text of the look, which is checked to be read back as the same look.
    fn check(&mut self) -> String {
        self.hand.app().wait();
        self.step();
        let look = self.hand.look();
        let text = look.to_text();
        let loaded = Look::read(&text, "monkey");
        assert!(!loaded.has_errors(), "after {} gestures: {:?}", self.done, loaded.diagnostics);
        assert!(
            loaded.value.as_ref() == Some(look),
            "after {} gestures the file says something else",
            self.done
        );
        text
    }

    /// Text of the scene, which is checked to be read back as the same scene; empty where none is
    /// open.
    fn check_scene(&self) -> String {
        let Some(open_scene) = self.hand.app().session().open_scene() else { return String::new() };
        let text = open_scene.scene().to_text();
        let loaded = Scene::read(&text, "monkey");
        assert!(!loaded.has_errors(), "after {} gestures: {:?}", self.done, loaded.diagnostics);
        assert!(
            loaded.value.as_ref() == Some(open_scene.scene()),
            "after {} gestures the scene says something else",
            self.done
        );
        text
    }

    /// Undoes and redoes all steps. Returns the text of the look before its first step.
    fn there_and_back(&mut self) -> String {
        // The monkey may have stopped after an undo.
        while self.hand.app_mut().session_mut().redo() {}
        let last = self.check();
        let session = self.hand.app_mut().session_mut();
        while session.undo() {}
        let first = self.check();
        let session = self.hand.app_mut().session_mut();
        while session.redo() {}
        assert_eq!(self.check(), last, "redo leads to the last change");
        first
    }
}

fn gestures() -> usize {
    std::env::var("MONKEY_GESTURES").ok().and_then(|text| text.parse().ok()).unwrap_or(1_250)
}

/// A window at the first step of the tour.
fn on_tour() -> User {
    let mut hand = User::with(|ctx| {
        let mut app = App::new(ctx, None).without_dialogs();
        app.show_start_page();
        app
    });
    let at = hand.harness.get_by_label("Take the tour").rect().center();
    hand.click(at);
    hand.settle();
    assert!(hand.app().is_on_tour());
    hand
}

fn let_loose(seed: u64, file: Option<&str>, gestures: usize) {
    let_loose_in(Monkey::new(seed), file, gestures);
}

fn let_loose_in(mut monkey: Monkey, file: Option<&str>, gestures: usize) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("look.json");
    let fresh = monkey.hand.look().to_text();
    if let Some(file) = file {
        std::fs::copy(Path::new(env!("CARGO_MANIFEST_DIR")).join(file), &path).unwrap();
        monkey.hand.app_mut().open(&path);
        monkey.hand.settle();
    }
    let opened = monkey.hand.look().to_text();
    // The window's library opens examples, too, and its Help menu the tour.
    let examples =
        std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/looks")).unwrap();
    let examples = examples.map(|entry| {
        Look::load(&chiaro::files::Disk, &entry.unwrap().path()).value.unwrap().to_text()
    });
    let mut beginnings: Vec<String> = examples
        .chain([fresh, opened, User::new().look().to_text(), on_tour().look().to_text()])
        .collect();
    let mut saved = std::fs::read_to_string(&path).unwrap_or_default();
    while monkey.done < gestures {
        for _ in 0..ROUND {
            monkey.gesture();
            // The monkey may open the file again that it saved, from among the recent files: the
            // look's history then begins with that text.
            let now = std::fs::read_to_string(&path).unwrap_or_default();
            if now != saved {
                beginnings.push(
                    Look::read(&now, "monkey").value.expect("what was saved is read").to_text(),
                );
                saved = now;
            }
        }
        monkey.check();
        if monkey.done.is_multiple_of(10 * ROUND) {
            let first = monkey.there_and_back();
            assert!(beginnings.contains(&first), "undo leads to the first file: {first}");
        }
    }
    // The saved file is the opened one, byte for byte, also where the monkey saved in between.
    if let Some(file) = file.filter(|_| monkey.hand.app().session().path() == Some(&path)) {
        let original = std::fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join(file)).unwrap();
        while monkey.hand.app_mut().session_mut().undo() {}
        assert!(monkey.hand.app_mut().save_as(&path));
        assert!(std::fs::read(&path).unwrap() == original, "the file as it was");
    }
}

#[test]
fn a_monkey_breaks_no_new_look() {
    let_loose(1, None, gestures());
}

#[test]
fn a_monkey_breaks_no_layers() {
    let_loose(2, Some("examples/looks/figure1-layers.json"), gestures());
}

#[test]
fn a_monkey_breaks_no_keys() {
    let_loose(3, Some("examples/looks/figure5-directional.json"), gestures());
}

#[test]
fn a_monkey_breaks_no_comics() {
    let_loose(4, Some("examples/looks/figure6-comics.json"), gestures());
}

#[test]
fn a_monkey_breaks_no_tour() {
    let monkey = Monkey { random: Random::new(6), hand: on_tour(), done: 0 };
    let_loose_in(monkey, None, gestures());
}

#[test]
fn a_monkey_breaks_no_scene() {
    let mut monkey = Monkey::new(5);
    let folder = tempfile::tempdir().unwrap();
    for part in ["looks", "images", "scenes"] {
        std::fs::create_dir(folder.path().join(part)).unwrap();
        let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples").join(part);
        for file in std::fs::read_dir(examples).unwrap().flatten() {
            std::fs::copy(file.path(), folder.path().join(part).join(file.file_name())).unwrap();
        }
    }
    while monkey.done < gestures() {
        if monkey.hand.app().session().open_scene().is_none() {
            monkey.hand.app_mut().open(&folder.path().join("scenes/cast.json"));
        }
        for _ in 0..ROUND {
            monkey.gesture();
        }
        monkey.check();
        monkey.check_scene();
        let session = monkey.hand.app_mut().session_mut();
        while session.redo() {}
        let last = monkey.check_scene();
        monkey.there_and_back();
        assert_eq!(monkey.check_scene(), last, "redo leads to the last change");
    }
}

/// Makes an eighth of a million gestures for each seed. Windows wait for work of the thread pool,
/// so a window must not run on a thread of that pool: each part is a test on a thread of its own.
fn soak(seeds: std::ops::Range<u64>) {
    let looks = ["figure1-layers", "figure5-directional", "figure6-comics", "figure7-pastel"];
    for seed in seeds {
        let file = format!("examples/looks/{}.json", looks[seed as usize % looks.len()]);
        let_loose(seed, Some(&file), 1_000_000 / 8);
    }
}

#[test]
#[ignore = "half a million gestures take a quarter of an hour"]
fn soak_monkey_first_half() {
    soak(100..104);
}

#[test]
#[ignore = "half a million gestures take a quarter of an hour"]
fn soak_monkey_second_half() {
    soak(104..108);
}
