//! `User`: a simulated user of the window, with pointer and keyboard.
#![allow(dead_code, reason = "each test file uses its part")]

pub(crate) mod home;
pub(crate) mod painting;
pub(crate) mod shots;
mod verbs;

use std::cell::RefCell;
use std::rc::Rc;
use std::sync::OnceLock;

use chiaro::document::Look;
use chiaro::editor::App;
use chiaro::render::Gpu;
use chiaro_test_drawing::wait::block_on;
use eframe::egui::{
    self, Event, Key, Modifiers, MouseWheelUnit, OutputCommand, PointerButton, Pos2, Rect, Role,
    Vec2, ViewportId, vec2,
};
use egui_kittest::kittest::Queryable as _;
use egui_kittest::wgpu::{WgpuTestRenderer, create_render_state, default_wgpu_setup};
use egui_kittest::{Harness, HarnessBuilder};

/// Size of a window, in points.
pub(crate) const WINDOW: Vec2 = Vec2::new(1500.0, 900.0);

/// A simulated user and the window that the user drives, without display; without GPU unless made
/// by one of the `drawing` functions.
pub(crate) struct User {
    /// The window, and the queue of its input events.
    pub(crate) harness: Harness<'static, Option<App>>,
    /// Text that the window copied last, in whichever frame it did.
    clipboard: Rc<RefCell<Option<String>>>,
}

impl User {
    /// A hand at a window with a new look.
    pub(crate) fn new() -> Self {
        Self::with(|ctx| App::new(ctx, None))
    }

    /// A hand at a window made by `make`.
    pub(crate) fn with(make: impl Fn(&egui::Context) -> App + 'static) -> Self {
        Self::with_builder(Harness::builder(), make)
    }

    /// A hand at a window that draws, on software Vulkan where there is no GPU; 60 frames a second
    /// by the window's own clock.
    pub(crate) fn drawing() -> Self {
        Self::drawing_in(Harness::builder().with_size(WINDOW).with_step_dt(1.0 / 60.0), |app, _| {
            app
        })
    }

    /// A hand at a window that draws, made into `App` as `prepare` leaves it; four frames a second
    /// by the window's own clock.
    pub(crate) fn drawing_with(prepare: impl Fn(App, &egui::Context) -> App + 'static) -> Self {
        Self::drawing_in(Harness::builder().with_size(WINDOW), prepare)
    }

    /// A hand at a window as of [`drawing_with`](Self::drawing_with), where a pixel is two points
    /// wide, so that software has a fourth of the picture to draw: for tests that read no pixels at
    /// points.
    pub(crate) fn drawing_coarsely(prepare: impl Fn(App, &egui::Context) -> App + 'static) -> Self {
        Self::drawing_in(Harness::builder().with_size(WINDOW).with_pixels_per_point(0.5), prepare)
    }

    /// A hand at a window that draws, of this size in points.
    pub(crate) fn drawing_at(
        size: Vec2,
        prepare: impl Fn(App, &egui::Context) -> App + 'static,
    ) -> Self {
        Self::drawing_in(Harness::builder().with_size(size), prepare)
    }

    fn drawing_in(
        builder: HarnessBuilder<Option<App>>,
        prepare: impl Fn(App, &egui::Context) -> App + 'static,
    ) -> Self {
        // Asked once, because the answer takes making a device.
        static HAS_ADAPTER: OnceLock<bool> = OnceLock::new();
        let has_adapter = *HAS_ADAPTER.get_or_init(|| block_on(Gpu::headless()).is_ok());
        assert!(has_adapter, "an adapter is needed; software Vulkan does");
        let state = create_render_state(
            default_wgpu_setup(),
            eframe::egui_wgpu::RendererOptions::PREDICTABLE,
        );
        let builder = builder.renderer(WgpuTestRenderer::from_render_state(state.clone()));
        Self::built(builder, move |ctx| prepare(App::new(ctx, Some(state.clone())), ctx))
    }

    /// A hand at a window built by `builder`, which may bring a renderer.
    pub(crate) fn with_builder(
        builder: HarnessBuilder<Option<App>>,
        make: impl Fn(&egui::Context) -> App + 'static,
    ) -> Self {
        Self::built(builder.with_size(WINDOW), make)
    }

    fn built(
        builder: HarnessBuilder<Option<App>>,
        make: impl Fn(&egui::Context) -> App + 'static,
    ) -> Self {
        let clipboard = Rc::<RefCell<Option<String>>>::default();
        let copied = Rc::clone(&clipboard);
        let show = move |ui: &mut egui::Ui, app: &mut Option<App>| {
            app.get_or_insert_with(|| make(ui.ctx())).show(ui);
            ui.ctx().output(|output| {
                for command in &output.commands {
                    if let OutputCommand::CopyText(text) = command {
                        copied.replace(Some(text.clone()));
                    }
                }
            });
        };
        let builder = builder.with_max_steps(20);
        let mut hand = Self { harness: builder.build_ui_state(show, None), clipboard };
        hand.settle();
        hand
    }

    pub(crate) fn app(&self) -> &App {
        self.harness.state().as_ref().expect("made in the first frame")
    }

    pub(crate) fn app_mut(&mut self) -> &mut App {
        self.harness.state_mut().as_mut().expect("made in the first frame")
    }

    /// Text that was copied last, taken out of the clipboard.
    pub(crate) fn take_copied(&self) -> Option<String> {
        self.clipboard.take()
    }

    pub(crate) fn look(&self) -> &Look {
        self.app().session().look()
    }

    /// Runs frames until everything is compiled and shown.
    pub(crate) fn settle(&mut self) {
        // A thread's result is taken in the frame after the thread ends; so two rounds must be
        // quiet.
        let mut quiet = 0;
        for _ in 0..80 {
            self.harness.run_ok();
            let was_busy = self.app().is_busy();
            self.app().wait();
            let is_quiet = !was_busy && self.repaint_delay() > std::time::Duration::from_secs(60);
            quiet = if is_quiet { quiet + 1 } else { 0 };
            if quiet == 2 {
                return;
            }
        }
    }

    pub(crate) fn repaint_delay(&self) -> std::time::Duration {
        self.harness.output().viewport_output[&ViewportId::ROOT].repaint_delay
    }

    fn event(&mut self, event: Event) {
        self.harness.event(event);
        self.harness.step();
    }

    pub(crate) fn hover(&mut self, at: Pos2) {
        self.event(Event::PointerMoved(at));
        self.harness.step();
    }

    fn button(&mut self, modifiers: Modifiers, pos: Pos2, pressed: bool) {
        self.event(Event::ModifiersChanged(modifiers));
        self.event(Event::PointerButton {
            pos,
            button: PointerButton::Primary,
            pressed,
            modifiers,
        });
    }

    pub(crate) fn click_with(&mut self, modifiers: Modifiers, at: Pos2) {
        self.hover(at);
        self.button(modifiers, at, true);
        self.button(modifiers, at, false);
        self.event(Event::ModifiersChanged(Modifiers::NONE));
        self.harness.run_steps(2);
    }

    pub(crate) fn click(&mut self, at: Pos2) {
        // Enough frames after the last click not to make a double click of both.
        self.harness.run_steps(4);
        self.click_with(Modifiers::NONE, at);
    }

    /// Opens the menu of what lies at a place.
    pub(crate) fn right_click(&mut self, at: Pos2) {
        self.hover(at);
        self.harness.run_steps(4);
        for pressed in [true, false] {
            let (button, modifiers) = (PointerButton::Secondary, Modifiers::NONE);
            self.event(Event::PointerButton { pos: at, button, pressed, modifiers });
            self.harness.step();
        }
        self.harness.run_steps(3);
    }

    pub(crate) fn double_click(&mut self, at: Pos2) {
        self.hover(at);
        self.harness.run_steps(4);
        for _ in 0..2 {
            for pressed in [true, false] {
                let button = PointerButton::Primary;
                self.harness.input_mut().events.push(Event::PointerButton {
                    pos: at,
                    button,
                    pressed,
                    modifiers: Modifiers::NONE,
                });
            }
        }
        self.harness.run_steps(3);
    }

    /// Presses and releases the button at each point, all in one frame, as a quick user does in a
    /// slow window.
    pub(crate) fn quick_clicks(&mut self, points: &[Pos2]) {
        if let Some(first) = points.first() {
            self.hover(*first);
        }
        for &pos in points {
            let (button, modifiers) = (PointerButton::Primary, Modifiers::NONE);
            let events = &mut self.harness.input_mut().events;
            events.push(Event::PointerMoved(pos));
            events.extend([true, false].map(|pressed| Event::PointerButton {
                pos,
                button,
                pressed,
                modifiers,
            }));
        }
        self.harness.run_steps(3);
    }

    /// Presses the button, moves the pointer in steps and releases the button; the pointer stays at
    /// `to`.
    pub(crate) fn drag(&mut self, from: Pos2, to: Pos2) {
        self.drag_with(Modifiers::NONE, from, to);
    }

    pub(crate) fn drag_with(&mut self, modifiers: Modifiers, from: Pos2, to: Pos2) {
        self.drag_along(modifiers, &[from, to]);
    }

    /// Presses the button and holds it.
    pub(crate) fn hold(&mut self, at: Pos2) {
        self.hover(at);
        self.button(Modifiers::NONE, at, true);
    }

    /// Moves the pointer, in one frame.
    pub(crate) fn move_to(&mut self, at: Pos2) {
        self.event(Event::PointerMoved(at));
    }

    /// Releases the button.
    pub(crate) fn release(&mut self, at: Pos2) {
        self.button(Modifiers::NONE, at, false);
    }

    /// Drags through several points.
    pub(crate) fn drag_through(&mut self, points: &[Pos2]) {
        self.drag_along(Modifiers::NONE, points);
    }

    fn drag_along(&mut self, modifiers: Modifiers, points: &[Pos2]) {
        const STEPS: u8 = 6;
        let [first, .., last] = points else { return };
        self.hover(*first);
        self.button(modifiers, *first, true);
        for pair in points.windows(2) {
            for step in 1..=STEPS {
                let t = f32::from(step) / f32::from(STEPS);
                self.event(Event::PointerMoved(pair[0] + (pair[1] - pair[0]) * t));
            }
        }
        self.harness.step();
        self.button(modifiers, *last, false);
        self.event(Event::ModifiersChanged(Modifiers::NONE));
        self.harness.run_steps(2);
    }

    pub(crate) fn wheel(&mut self, at: Pos2, points: f32) {
        self.hover(at);
        let delta: Vec2 = vec2(0.0, points);
        let phase = egui::TouchPhase::Move;
        let (unit, source) = (MouseWheelUnit::Point, egui::MouseWheelSource::Unknown);
        self.event(Event::MouseWheel { unit, delta, phase, source, modifiers: Modifiers::NONE });
        self.harness.run_steps(8);
    }

    pub(crate) fn key(&mut self, key: Key) {
        self.key_with(Modifiers::NONE, key);
    }

    pub(crate) fn key_with(&mut self, modifiers: Modifiers, key: Key) {
        self.harness.key_press_modifiers(modifiers, key);
        self.harness.run_steps(3);
    }

    pub(crate) fn type_text(&mut self, text: &str) {
        self.event(Event::Text(text.to_owned()));
        self.harness.run_steps(2);
    }

    pub(crate) fn undo(&mut self) {
        let at = self.harness.get_by_label("Undo").rect().center();
        self.click(at);
    }

    pub(crate) fn redo(&mut self) {
        let at = self.harness.get_by_label("Redo").rect().center();
        self.click(at);
    }

    /// The slider of an input, including its number field.
    pub(crate) fn slider(&self, label: &str) -> Rect {
        let found = self.harness.get_all_by_label(label);
        let rects = found.map(|node| node.rect()).filter(|rect| rect.min.x > 1100.0);
        rects.max_by(|a, b| a.width().total_cmp(&b.width())).expect("there is one")
    }

    /// The number field beside the slider of an input.
    pub(crate) fn number_field(&self, label: &str) -> Rect {
        let slider = self.slider(label);
        let fields =
            self.harness.get_all_by_role(egui::accesskit::Role::SpinButton).map(|node| node.rect());
        let beside = |rect: &Rect| {
            (rect.center().y - slider.center().y).abs() < 4.0 && rect.min.x >= slider.max.x - 4.0
        };
        fields.into_iter().find(beside).unwrap_or(slider)
    }

    pub(crate) fn output(&self, node: &str, port: &str) -> Pos2 {
        self.app().canvas().socket(node, port, true).expect("there is one")
    }

    pub(crate) fn input(&self, node: &str, port: &str) -> Pos2 {
        self.app().canvas().socket(node, port, false).expect("there is one")
    }

    /// A place of the canvas of a new look with no node on it.
    pub(crate) fn empty_place(&self) -> Pos2 {
        let output = self.app().canvas().node_rect("output").expect("a new look has one");
        output.center_bottom() + vec2(-20.0, 120.0)
    }

    /// Adds a node of a kind by edits, as scripts do.
    pub(crate) fn add(&mut self, kind: &str, at: Pos2) {
        use chiaro::document::{Edit, GraphId, Node, Value};
        let mut node =
            Node { kind: kind.to_owned(), position: [at.x.into(), at.y.into()], ..Node::default() };
        if kind == "light" {
            node.values.insert("light".into(), Value::Text("key".into()));
        }
        let edit = Edit::AddNode { graph: GraphId::Look, id: kind.into(), node, index: None };
        self.app_mut().session_mut().apply(edit, None).expect("a new id");
        self.settle();
    }
}

/// A place of a node's title bar, where a click takes the node and no socket.
pub(crate) fn node_center(hand: &User, id: &str) -> Pos2 {
    hand.app().canvas().node_rect(id).expect("there is one").center_top() + vec2(0.0, 10.0)
}

pub(crate) fn close(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-3
}

/// Clears the text field of this name and types into it.
pub(crate) fn set_text(hand: &mut User, field: &str, text: &str) {
    let at = hand.harness.get_by_role_and_label(Role::TextInput, field).rect().center();
    hand.click(at);
    hand.key_with(Modifiers::COMMAND, Key::A);
    hand.key(Key::Delete);
    hand.type_text(text);
    hand.settle();
}
