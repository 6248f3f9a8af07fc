//! What a frame of the canvas costs on the CPU; run by hand: `cargo test --release --test editor_frames -- --ignored --nocapture`.
#![cfg(feature = "editor")]
#![allow(clippy::print_stdout, reason = "it prints a table")]

use std::time::{Duration, Instant};

use chiaro::document::{Endpoint, Graph, Look, Node, Wire};
use chiaro::editor::{Canvas, Session};
use chiaro::library::Library;
use eframe::egui::{self, CentralPanel, Event, RawInput, Rect, pos2, vec2};

/// A grid of nodes, each wired to its left and upper neighbour, one in ten also to a far one.
fn look(count: usize) -> Look {
    let columns = (count as f64).sqrt().ceil() as usize;
    let mut graph = Graph::default();
    let id = |i: usize| format!("n{i}");
    let mut seed = 12345u64;
    for i in 0..count {
        let (column, row) = (i % columns, i / columns);
        let position = [column as f64 * 240.0, row as f64 * 160.0];
        graph.nodes.insert(id(i).as_str().into(), Node { kind: "map_range".into(), position, ..Node::default() });
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        let far = (i % 10 == 0 && i > 0).then(|| (seed >> 33) as usize % i);
        let sources = [(column > 0).then(|| i - 1), (row > 0).then(|| i - columns), far];
        let ports: Vec<_> =
            Library::built_in().nodes["map_range"].visible_inputs().map(|input| input.name.clone()).collect();
        for (port, from) in ports.iter().zip(sources).filter_map(|(port, from)| Some((port, from?))) {
            let from = Endpoint { node: id(from).as_str().into(), port: "".into() };
            graph.wires.push(Wire { from, to: Endpoint { node: id(i).as_str().into(), port: port.clone() } });
        }
    }
    Look { graph, ..Look::default() }
}

#[expect(clippy::disallowed_methods, reason = "it measures time")]
fn measure(count: usize, is_all: bool) -> (Duration, Duration, usize) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("big.json");
    look(count).save(&path, None).unwrap();
    let ctx = egui::Context::default();
    let mut session = Session::new(std::sync::Arc::new(Library::built_in().clone()), || {});
    assert!(session.open(&path));
    let mut canvas = Canvas::default();
    let mut times = Vec::new();
    let mut vertices = 0;
    for frame in 0..68 {
        let shift = vec2(frame as f32 * 3.0, frame as f32 * 2.0);
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(pos2(0.0, 0.0), vec2(1280.0, 800.0))),
            time: Some(f64::from(frame) / 60.0),
            events: vec![Event::PointerMoved(pos2(600.0, 400.0) + shift * 0.1)],
            ..RawInput::default()
        };
        if frame > 0 {
            let (zoom, center) = canvas.zoom_and_center();
            let zoom = if is_all { zoom } else { 0.9 };
            canvas.set_zoom_and_center(zoom, center + vec2(3.0, 2.0) / zoom);
        }
        let start = Instant::now();
        let mut output = ctx.run_ui(input, |ui| {
            CentralPanel::no_frame().show(ui, |ui| canvas.show_alone(ui, &session));
        });
        // Nothing is drawn, so the fonts' image goes nowhere.
        output.textures_delta.clear();
        let shapes = ctx.tessellate(output.shapes, output.pixels_per_point);
        let time = start.elapsed();
        if frame >= 8 {
            times.push(time);
        }
        vertices = shapes
            .iter()
            .map(|s| if let egui::epaint::Primitive::Mesh(m) = &s.primitive { m.vertices.len() } else { 0 })
            .sum();
    }
    times.sort();
    (times[times.len() / 2], times[times.len() * 95 / 100], vertices)
}

#[test]
#[ignore = "prints what a frame costs, and judges nothing"]
fn frames_are_measured() {
    for count in [200, 1_000, 5_000, 20_000] {
        for is_all in [true, false] {
            let (median, p95, vertices) = measure(count, is_all);
            let view = if is_all { "all in view" } else { "close up" };
            println!("{count:>6} nodes, {view:<11}: median {median:>9.2?}, p95 {p95:>9.2?}, {vertices} vertices");
        }
    }
}
