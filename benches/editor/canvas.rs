//! Times of large looks: frames of the canvas, opening, and validation of an edit.

use std::sync::Arc;

use chiaro::document::{Edit, GraphId};
use chiaro::editor::{Canvas, Session};
use chiaro::library::Library;
use eframe::egui::{CentralPanel, Event, Pos2, pos2, vec2};

use crate::looks::{saved, sizes};
use crate::times::{timed, told};
use crate::window::{Frames, SIZE, Window, button, moved};

/// Number of frames at the start that are not counted.
const WARM_UP: usize = 8;
const FRAMES: usize = 120;

/// Motion of a hand on the canvas.
#[derive(Clone, Copy)]
enum Motion {
    /// The view moves, with all nodes in view.
    PanFar,
    /// The view moves, with some thirty nodes in view.
    PanNear,
    /// The view zooms from all nodes to a few and back.
    Zoom,
    /// A selection box is drawn over all nodes.
    Box,
    /// The pointer moves over nodes and wires, all in view.
    Hover,
}

impl Motion {
    const ALL: [(Self, &'static str); 5] = [
        (Self::PanFar, "pan, all in view"),
        (Self::PanNear, "pan, close up"),
        (Self::Zoom, "zoom"),
        (Self::Box, "box select"),
        (Self::Hover, "hover"),
    ];

    /// Moves the view, and returns the hand's events in a frame.
    fn step(self, canvas: &mut Canvas, (fit, center): (f32, Pos2), frame: usize) -> Vec<Event> {
        const NEAR: f32 = 0.9;
        let share = frame as f32 / FRAMES as f32;
        let drift = vec2(3.0, 2.0) * frame as f32;
        let start = pos2(4.0, 4.0);
        match self {
            Self::PanFar => canvas.set_zoom_and_center(fit, center + drift / fit),
            Self::PanNear => canvas.set_zoom_and_center(NEAR, center + drift / NEAR),
            Self::Zoom => {
                let nearness = 1.0 - (2.0 * share - 1.0).abs();
                canvas.set_zoom_and_center(fit * (NEAR / fit).powf(nearness), center);
            }
            Self::Box if frame == 0 => return vec![moved(start), button(start, true)],
            Self::Box | Self::Hover => return vec![moved(start + (SIZE - vec2(8.0, 8.0)) * share)],
        }
        vec![moved(pos2(600.0, 400.0) + drift * 0.1)]
    }
}

/// Times of frames of the canvas alone, in seconds.
fn canvas_frames(path: &std::path::Path, motion: Motion) -> Vec<f64> {
    let mut session = Session::new(Arc::new(Library::built_in().clone()), || {});
    session.open(path).expect("the example opens");
    let mut canvas = Canvas::default();
    let mut frames = Frames::new();
    let mut frame = |canvas: &mut Canvas, events| {
        frames.frame(events, |ui| {
            CentralPanel::no_frame().show(ui, |ui| canvas.show_alone(ui, &session));
        })
    };
    for _ in 0..WARM_UP {
        frame(&mut canvas, Vec::new());
    }
    let view = canvas.zoom_and_center();
    let step = |index| {
        let events = motion.step(&mut canvas, view, index);
        frame(&mut canvas, events)
    };
    (0..FRAMES).map(step).collect()
}

/// Times of frames of the whole window, of which the canvas is a part, while the view moves, in
/// seconds.
fn window_frames(window: &mut Window) -> Vec<f64> {
    let view = window.app.canvas().zoom_and_center();
    let step = |index| {
        let events = Motion::PanFar.step(window.app.canvas_mut(), view, index);
        window.frame(events)
    };
    (0..FRAMES).map(step).collect()
}

/// Times of many edits that remove a wire and put it back: of the frame that applies the edit, of
/// the frame after, and of all frames until naga has validated both shaders, in seconds.
fn structural_edits(window: &mut Window) -> [Vec<f64>; 3] {
    let mut times = [const { Vec::new() }; 3];
    let wires = &window.app.session().look().graph.wires;
    let wire = wires[wires.len() / 2].clone();
    for _ in 0..10 {
        let graph = || GraphId::Look;
        let remove = Edit::RemoveWire { graph: graph(), wire: wire.clone() };
        let add = Edit::AddWire { graph: graph(), wire: wire.clone(), index: None };
        for edit in [remove, add] {
            let (applied, result) = timed(|| window.app.session_mut().apply(edit, None));
            result.expect("the wire is there, then it is not");
            let frame = applied + window.frame(Vec::new());
            let (compiled, ()) = timed(|| window.app.session().wait());
            let after = window.frame(Vec::new());
            for (times, time) in times.iter_mut().zip([frame, after, frame + compiled]) {
                times.push(time);
            }
        }
    }
    times
}

pub(crate) fn run() {
    println!("\nFrames of the canvas on one core (egui and tessellation), ms, median / p95");
    let motions = Motion::ALL.map(|(_, name)| name).join(" | ");
    println!("\n| nodes | {motions} | whole window, pan |");
    println!("| ---: |{}", " ---: |".repeat(Motion::ALL.len() + 1));
    let mut opened = Vec::new();
    for count in sizes() {
        let (_folder, path) = saved(count);
        let cells = Motion::ALL.map(|(motion, _)| told(canvas_frames(&path, motion))).join(" | ");
        let mut window = Window::new();
        let [shown, compiled] = window.open(&path);
        window.settle();
        println!("| {count} | {cells} | {} |", told(window_frames(&mut window)));
        let [applied, after, validated] = structural_edits(&mut window).map(told);
        opened.push(format!(
            "| {count} | {:.0} | {:.0} | {applied} | {after} | {validated} |",
            shown * 1e3,
            compiled * 1e3
        ));
    }
    println!(
        "\nOpening, and an edit of the structure (a wire goes, or comes back), ms; of edits \
         median / p95"
    );
    println!(
        "\n| nodes | open to first frame | to its shaders | edit: its frame | the frame after | \
         until validated |"
    );
    println!("| ---: | ---: | ---: | ---: | ---: | ---: |");
    opened.iter().for_each(|row| println!("{row}"));
}
