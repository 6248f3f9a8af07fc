//! A window without display, GPU and accessibility: a frame is the work of egui, including
//! tessellation.

use std::path::Path;

use chiaro::editor::App;
use eframe::egui::{self, Event, Modifiers, PointerButton, Pos2, RawInput, Rect, pos2, vec2};

use crate::times::timed;

/// Size of the window, in points.
pub(crate) const SIZE: egui::Vec2 = vec2(1500.0, 900.0);

/// An egui context that is given frames one by one.
pub(crate) struct Frames {
    ctx: egui::Context,
    /// Time of the context, in seconds.
    time: f64,
}

impl Frames {
    pub(crate) fn new() -> Self {
        Self { ctx: egui::Context::default(), time: 0.0 }
    }

    pub(crate) fn ctx(&self) -> &egui::Context {
        &self.ctx
    }

    /// Advances the context's time.
    pub(crate) fn rest(&mut self, seconds: f64) {
        self.time += seconds;
    }

    /// Runs a frame. Returns the time it takes, all of it on this thread, in seconds.
    pub(crate) fn frame(&mut self, events: Vec<Event>, mut show: impl FnMut(&mut egui::Ui)) -> f64 {
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(pos2(0.0, 0.0), SIZE)),
            time: Some(self.time),
            events,
            ..RawInput::default()
        };
        self.time += 1.0 / 60.0;
        let (seconds, ()) = timed(|| {
            let mut output = self.ctx.run_ui(input, &mut show);
            // Nothing is drawn, so the fonts' image is not needed.
            output.textures_delta.clear();
            drop(self.ctx.tessellate(output.shapes, output.pixels_per_point));
        });
        seconds
    }
}

/// The whole window.
pub(crate) struct Window {
    frames: Frames,
    pub(crate) app: App,
}

impl Window {
    pub(crate) fn new() -> Self {
        let frames = Frames::new();
        let app = App::new(frames.ctx(), None).without_dialogs();
        let mut window = Self { frames, app };
        window.settle();
        window
    }

    /// Runs a frame of the window. Returns the time it takes, in seconds.
    pub(crate) fn frame(&mut self, events: Vec<Event>) -> f64 {
        let app = &mut self.app;
        self.frames.frame(events, |ui| app.show(ui))
    }

    /// Opens a look. Returns the times until the first frame shows it, and until its shaders are
    /// validated, too, in seconds.
    pub(crate) fn open(&mut self, path: &Path) -> [f64; 2] {
        let (opening, ()) = timed(|| self.app.open(path));
        let shown = opening + self.frame(Vec::new());
        let (compiling, ()) = timed(|| self.app.session().wait());
        [shown, shown + compiling + self.frame(Vec::new())]
    }

    /// Runs frames until the window is idle.
    pub(crate) fn settle(&mut self) {
        for _ in 0..20 {
            // A second of the window's time passes, after which a look is at rest.
            for _ in 0..4 {
                self.frames.rest(0.25);
                self.frame(Vec::new());
            }
            if !self.app.is_busy() {
                break;
            }
            self.app.wait();
        }
    }
}

/// Event of the pointer's move to a point.
pub(crate) fn moved(at: Pos2) -> Event {
    Event::PointerMoved(at)
}

/// Event of the first button's press or release.
pub(crate) fn button(pos: Pos2, pressed: bool) -> Event {
    Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    }
}
