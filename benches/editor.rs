//! Benchmark of the window's responsiveness: frames of the canvas, opening, latency from an edit to
//! its picture, strokes, startup, memory.
//!
//! `cargo bench --profile dev --bench editor` prints tables; docs/performance.md holds the figures.
//! With arguments after `--` only the named parts run: `canvas`, `latency`, `painting`, `startup`,
//! `memory`, `mesh`; with numbers, looks of that many nodes, or meshes of that many MiB.
#![allow(clippy::print_stdout, reason = "it is what a benchmark is for")]
#![allow(missing_docs, reason = "a program")]
#![allow(clippy::disallowed_methods, reason = "it starts programs and reads what they say")]

use std::path::{Path, PathBuf};

#[path = "editor/canvas.rs"]
mod canvas;
#[path = "editor/driven.rs"]
mod driven;
#[path = "../tests/editor/editor_support/mod.rs"]
mod editor_support;
#[path = "editor/latency.rs"]
mod latency;
#[path = "editor/looks.rs"]
mod looks;
#[path = "editor/memory.rs"]
mod memory;
#[path = "editor/mesh.rs"]
mod mesh;
#[path = "editor/painting.rs"]
mod painting;
#[path = "editor/startup.rs"]
mod startup;
#[path = "editor/times.rs"]
mod times;
#[path = "editor/window.rs"]
mod window;

/// True if a window can be opened.
fn has_display() -> bool {
    ["DISPLAY", "WAYLAND_DISPLAY"].iter().any(|name| std::env::var_os(name).is_some())
}

/// Path of an example look.
fn example(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/looks").join(name).with_extension("json")
}

fn main() {
    let asked: Vec<String> =
        std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    if let [part, nodes] = asked.as_slice()
        && part == memory::CHILD
    {
        return memory::child(nodes.parse().expect("a number of nodes"));
    }
    if let [part, mebibytes] = asked.as_slice()
        && part == mesh::CHILD
    {
        return mesh::child(mebibytes.parse().expect("a number of MiB"));
    }
    let parts: [(&str, fn()); 6] = [
        ("canvas", canvas::run),
        ("latency", latency::run),
        ("painting", painting::run),
        ("startup", startup::run),
        ("memory", memory::run),
        ("mesh", mesh::run),
    ];
    let is_asked = |name: &str| asked.iter().any(|part| part == name);
    let wants_all = !parts.iter().any(|(name, _)| is_asked(name));
    for (name, run) in parts {
        if wants_all || is_asked(name) {
            run();
        }
    }
}
