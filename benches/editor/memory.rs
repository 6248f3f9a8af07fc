//! Memory of the window, with each look in a process of its own, and after many edits, which must
//! not make it grow.

use std::process::Command;

use chiaro::document::{Edit, GraphId, Value};

use crate::looks::{saved, sizes};
use crate::window::Window;

/// Argument that makes this program measure one look and print the result.
pub(crate) const CHILD: &str = "memory-of";
const EDITS: usize = 1_000;

/// Resident memory of this process, in MiB; `None` if the system does not tell.
fn resident() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    Some(line.trim().strip_suffix("kB")?.trim().parse::<f64>().ok()? / 1024.0)
}

/// Sets a thousand values one after the other, each in a frame of its own; then undoes and redoes
/// them all.
fn edit(window: &mut Window, id: &str) {
    for index in 0..EDITS {
        let value = Value::Number(index as f64 / EDITS as f64);
        let edit = Edit::SetValue {
            graph: GraphId::Look,
            id: id.into(),
            port: "to_high".into(),
            value,
            index: None,
        };
        window.app.session_mut().apply(edit, None).expect("the node has this input");
        window.frame(Vec::new());
    }
    while window.app.session_mut().undo() {}
    while window.app.session_mut().redo() {}
    window.settle();
}

/// Measures one look, in a process that did nothing else.
pub(crate) fn child(nodes: usize) {
    let tell = || resident().map_or_else(|| "?".to_owned(), |mib| format!("{mib:.0}"));
    let mut window = Window::new();
    let empty = tell();
    let (_folder, path) = saved(nodes);
    window.open(&path);
    window.settle();
    let opened = tell();
    let id = format!("n{}", nodes / 2);
    let edited = [(); 3].map(|()| {
        edit(&mut window, &id);
        tell()
    });
    println!("| {nodes} | {empty} | {opened} | {} |", edited.join(" | "));
}

pub(crate) fn run() {
    println!(
        "\nResident memory of a window without GPU, MiB; an edit is a value, and all are undone \
         and redone at the end"
    );
    println!(
        "\n| nodes | new look | opened | after {EDITS} edits | {} | {} |",
        2 * EDITS,
        3 * EDITS
    );
    println!("| ---: | ---: | ---: | ---: | ---: | ---: |");
    for nodes in sizes() {
        let program = std::env::current_exe().expect("this program");
        let output =
            Command::new(program).args([CHILD, &nodes.to_string()]).output().expect("it starts");
        print!("{}", String::from_utf8_lossy(&output.stdout));
    }
}
