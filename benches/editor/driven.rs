//! Benchmark in a real window on a display, with input from a simulated hand.

use std::path::Path;

use chiaro::clock::Clock;
use chiaro::editor::{App, options};
use eframe::egui::{self, Pos2, RawInput, ViewportCommand, vec2};

use crate::times::told;
use crate::window::{button, moved};

const FRAMES: u16 = 80;
/// Number of idle frames before a drag begins.
const QUIET: u16 = 30;

/// Function that finds the point of the window to begin a drag at.
type PointFinder = fn(&App) -> Option<Pos2>;

/// Drags, one after the other.
const DRAGS: [(&str, PointFinder); 3] = [
    ("a line on the object", |app| app.viewport().curve("cutoff").first().copied()),
    ("a light", |app| app.viewport().middle()),
    ("the camera", |app| app.viewport().rect().map(|rect| rect.min + vec2(60.0, 60.0))),
];

/// The window, and the progress of the hand.
struct DragBenchmark {
    app: App,
    drag: usize,
    from: Option<Pos2>,
    /// Number of frames since the last step of the hand's plan.
    frame: u16,
    /// Clock since the input of a drag's last frame.
    since_input: Option<Clock>,
    in_time: u16,
    times: Vec<f64>,
}

impl DragBenchmark {
    fn finish(&mut self) {
        let (what, _) = DRAGS[self.drag];
        println!(
            "| {what} | {} of {FRAMES} | {} |",
            self.in_time,
            told(std::mem::take(&mut self.times))
        );
        (self.drag, self.frame, self.in_time, self.from) = (self.drag + 1, 0, 0, None);
    }
}

impl eframe::App for DragBenchmark {
    fn raw_input_hook(&mut self, ctx: &egui::Context, input: &mut RawInput) {
        // The last frame is presented when the next one asks for its input.
        self.times.extend(self.since_input.take().map(|clock| clock.seconds()));
        let Some((_, find)) = DRAGS.get(self.drag) else {
            return ctx.send_viewport_cmd(ViewportCommand::Close);
        };
        self.frame += 1;
        match self.from {
            None => {
                self.frame = if self.app.is_busy() { 0 } else { self.frame };
                self.from = (self.frame > QUIET).then(|| find(&self.app)).flatten();
                if let Some(from) = self.from {
                    input.events.extend([moved(from), button(from, true)]);
                    self.frame = 0;
                }
            }
            Some(from) if self.frame > FRAMES => {
                input.events.push(button(from, false));
                self.finish();
            }
            Some(from) => {
                let turn = f32::from(self.frame) * 0.31;
                input.events.push(moved(from + 40.0 * vec2(turn.cos() - 1.0, 0.5 * turn.sin())));
                self.since_input = Some(Clock::start());
            }
        }
    }

    fn ui(&mut self, ui: &mut egui::Ui, _: &mut eframe::Frame) {
        self.app.show(ui);
        self.in_time += u16::from(self.since_input.is_some() && !self.app.is_drawing());
        ui.ctx().request_repaint();
    }
}

/// Drags in a window of its own, and prints how many pictures were submitted to the GPU before the
/// frame of their edit, and the time from the pointer's move until that frame was presented.
pub(crate) fn run(look: &Path) {
    println!(
        "\nThe same in a window of 1600x960 points on a display, until it is presented; ms, \
         median / p95"
    );
    println!("\n| what is dragged | in the very next frame | from the pointer to the screen |");
    println!("| --- | ---: | ---: |");
    let look = look.to_owned();
    let create = move |context: &eframe::CreationContext<'_>| {
        let mut app =
            App::new(&context.egui_ctx, context.wgpu_render_state.clone()).without_dialogs();
        app.open(&look);
        app.session_mut().select(vec!["diffuse".into()]);
        let (in_time, times) = (0, Vec::new());
        Ok(Box::new(DragBenchmark {
            app,
            drag: 0,
            from: None,
            frame: 0,
            since_input: None,
            in_time,
            times,
        }) as Box<dyn eframe::App>)
    };
    eframe::run_native("chiaro-bench", options(), Box::new(create)).expect("a window");
}
