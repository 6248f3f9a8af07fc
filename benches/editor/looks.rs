//! Large looks for benchmarks.

use std::path::PathBuf;

use chiaro::document::{Endpoint, Look, Node, Wire};
use chiaro::files::TextDocument as _;
use chiaro::library::Library;

/// Numbers of nodes to measure: those among the arguments, else the usual ones.
pub(crate) fn sizes() -> Vec<usize> {
    let asked: Vec<usize> = std::env::args().filter_map(|argument| argument.parse().ok()).collect();
    if asked.is_empty() { vec![200, 1_000, 5_000, 20_000] } else { asked }
}

/// Kind of most nodes.
const KIND: &str = "map_range";

/// A grid of nodes, each wired to its left and upper neighbor, one in ten also to a much earlier
/// node. The first node is the facing ratio of the surface and the last is the output, so that
/// nothing can be folded away.
pub(crate) fn grid(count: usize) -> Look {
    let columns = (count as f64).sqrt().ceil() as usize;
    let mut look = Look { name: format!("{count} nodes"), ..Look::default() };
    let ports: Vec<_> =
        Library::built_in().nodes[KIND].visible_inputs().map(|input| input.name.clone()).collect();
    let id = |i: usize| format!("n{i}");
    let wire = |from: usize, to: usize, port: &str| Wire {
        from: Endpoint::new(id(from), ""),
        to: Endpoint::new(id(to), port),
    };
    let mut seed = 12345_u64;
    for i in 0..count {
        let (column, row) = (i % columns, i / columns);
        let position = [column as f64 * 240.0, row as f64 * 160.0];
        let is_last = i + 1 == count;
        let kind = if i == 0 {
            "facing"
        } else if is_last {
            "output"
        } else {
            KIND
        };
        look.graph.nodes.insert(
            id(i).as_str().into(),
            Node { kind: kind.to_owned(), position, ..Node::default() },
        );
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        if i == 0 {
            continue;
        }
        if is_last {
            look.graph.wires.push(wire(i - 1, i, "color"));
            continue;
        }
        let far = i.is_multiple_of(10).then(|| (seed >> 33) as usize % i);
        let sources = [(column > 0).then(|| i - 1), (row > 0).then(|| i - columns), far];
        for (port, from) in ports.iter().zip(sources).filter_map(|(port, from)| Some((port, from?)))
        {
            look.graph.wires.push(wire(from, i, port.as_str()));
        }
    }
    look
}

/// A folder that contains the file of a grid.
pub(crate) fn saved(count: usize) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a folder for the look");
    let path = folder.path().join("grid.json");
    grid(count).save(&path, None).expect("a place for the look");
    (folder, path)
}
