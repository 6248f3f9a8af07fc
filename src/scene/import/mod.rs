//! Graphs of other programs as looks: MaterialX documents and Blender's shader nodes.
//!
//! A reader (`materialx`, `blender`) makes a `ForeignGraph` of a file: nodes with values
//! and links, groups unrolled. `build` makes a look of that graph: each node by its row in a
//! table of `twins`, a recipe of our own nodes. A node without a row becomes a note with its
//! values, and what was wired to the node gets a stand-in value, so that the look compiles.

mod blender;
mod blender_twins;
mod build;
mod foreign;
mod layout;
mod materialx;
mod materialx_twins;
mod recipe;
mod twins;

use std::path::Path;

use chiaro_locale::tr;

use crate::diag::{Diagnostic, WithWarnings};
use crate::document::{Look, Value};
use crate::library::Library;

/// Most bytes of an imported file.
pub const MAX_BYTES: usize = 16 << 20;

/// Most nodes of an imported graph, with those of every use of a group.
const MAX_FOREIGN_NODES: usize = 10_000;

/// Most inputs of a node.
const MAX_PORTS: usize = 1000;

/// Kind of an imported file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GraphFile {
    /// MaterialX document, in XML.
    MaterialX,
    /// Shader nodes of Blender, in the JSON that `blender_nodes.py` writes.
    Blender,
}

impl GraphFile {
    /// Kind of a file by its name; `None` for names that no imported file has.
    pub fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        match ending.as_str() {
            "mtlx" => Some(Self::MaterialX),
            "json" => Some(Self::Blender),
            _ => None,
        }
    }

    /// True for a text that the script for Blender has written, which begins with the version.
    pub fn is_blender(text: &str) -> bool {
        let start = text.trim_start().strip_prefix('{').map(str::trim_start);
        start.is_some_and(|start| start.starts_with("\"blender\""))
    }
}

/// Text of the script that writes a material of Blender for the import.
pub const BLENDER_SCRIPT: &str = include_str!("blender_nodes.py");

/// Makes a look of the `text` of a file called `file`. Notes and warnings tell what came as a note
/// on the canvas, and what has no counterpart.
///
/// # Errors
/// Text that is no graph of its kind, links that lead nowhere or in a circle, and what is beyond
/// the bounds of looks, with the place in the file.
pub fn import_graph(
    text: &str,
    file: &str,
    kind: GraphFile,
    library: &Library,
) -> Result<WithWarnings<Look>, Vec<Diagnostic>> {
    let in_file = |problem: Diagnostic| vec![problem.in_file(file)];
    if text.len() > MAX_BYTES {
        let message =
            tr!("the file has {bytes} bytes, and at most {MAX_BYTES} are read", bytes = text.len());
        let hint = tr!("export the one material that is wanted to a file of its own");
        return Err(in_file(Diagnostic::error("too-large", message).hint(hint)));
    }
    let (graph, twins) = match kind {
        GraphFile::MaterialX => (materialx::read(text), materialx_twins::TWINS),
        GraphFile::Blender => (blender::read(text), blender_twins::TWINS),
    };
    let graph = graph.map_err(|problem| in_file(*problem))?;
    let built = build::look(&graph, twins, library).map_err(|problem| in_file(*problem))?;
    let (mut look, warnings) = built.into_parts();
    if look.name.is_empty() {
        let stem = Path::new(file).file_stem();
        look.name = stem.map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    }
    let warnings: Vec<_> = warnings.into_iter().map(|problem| problem.in_file(file)).collect();
    Ok(WithWarnings::new(look, crate::diag::bounded(warnings)))
}

/// Names images by whole paths, which the file names from its own `folder` on.
pub fn anchor_images(look: &mut Look, folder: &Path) {
    let images = look.graph.nodes.values_mut().filter(|node| node.kind == "image");
    for value in images.filter_map(|node| node.values.get_mut("image")) {
        if let Value::Text(path) = value
            && !path.is_empty()
            && !path.starts_with("example:")
        {
            *path = folder.join(&*path).display().to_string();
        }
    }
}

#[cfg(test)]
mod tests;
