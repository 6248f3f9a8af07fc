//! `chiaro import`: a look of another program's graph.

use std::path::{Path, PathBuf};

use serde_json::json;

use super::output::Output;
use super::target::{OutputPath, outputs};
use crate::diag::Diagnostic;
use crate::files::{OutputKind, read_text};
use crate::library::Library;
use chiaro_scene::import::{BLENDER_SCRIPT, GraphFile, anchor_images, import_graph};

const EXAMPLES: &str = "\
Examples:
  chiaro import clay.mtlx                     clay.json, a look
  chiaro import clay.mtlx -o looks/clay.json
  chiaro import --script > blender_nodes.py   the script that writes a material of Blender
  chiaro import \"Clay nodes.json\" -o clay.json

Nodes with a twin here are made of it. A node without one comes as a note with its values, and a \
stand-in value is wired
in its place, so that the look is drawn.";

/// Arguments of `chiaro import`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// A MaterialX document (.mtlx), or the JSON that the script for Blender has written
    #[arg(required_unless_present = "script")]
    graph: Option<PathBuf>,
    /// The look's file; without it one beside the graph, named after it
    #[arg(short, long)]
    output: Option<OutputPath>,
    /// Print the script that writes a material's nodes in Blender
    #[arg(long, conflicts_with_all = ["graph", "output"])]
    script: bool,
    /// Replace a file that is there
    #[arg(long)]
    force: bool,
    /// Print the look's file and the counts of nodes and notes as JSON
    #[arg(long)]
    json: bool,
}

pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let one = |problem: Diagnostic| vec![problem];
    let Some(graph) = arguments.graph.as_deref() else {
        output.result(BLENDER_SCRIPT.trim_end());
        return Ok(());
    };
    let Some(kind) = GraphFile::of(graph) else {
        let message = format!("`{}` is no graph that can be imported", graph.display());
        let problem = Diagnostic::error("bad-argument", message);
        let hint = "name a MaterialX document (.mtlx), or nodes of Blender (.json)";
        return Err(one(problem.hint(hint)));
    };
    let path = arguments.output.as_ref().map_or_else(|| beside(graph), |it| it.as_ref().into());
    let mut outputs = outputs(arguments.force, [graph]);
    outputs.check(&path, OutputKind::DOCUMENT).map_err(one)?;
    let file = graph.display().to_string();
    let text = read_text(graph).map_err(|problem| one(*problem))?;
    let imported = import_graph(&text, &file, kind, Library::built_in())?;
    output.diagnostics(&imported.warnings);
    let mut look = imported.value;
    let folder = |path: &Path| Some(std::path::absolute(path).ok()?.parent()?.to_path_buf());
    if let Some(from) = folder(graph).filter(|from| Some(from) != folder(&path).as_ref()) {
        anchor_images(&mut look, &from);
    }
    outputs.add(&path, OutputKind::DOCUMENT, look.to_text().as_bytes()).map_err(one)?;
    outputs.commit().map_err(one)?;
    let (nodes, notes) = (look.graph.nodes.len(), look.graph.notes.len());
    if arguments.json {
        let file = path.display().to_string();
        output.json(&json!({ "file": file, "nodes": nodes, "notes": notes }));
    } else {
        output.result(&path.display().to_string());
        let told = match notes {
            0 => String::new(),
            1 => ", 1 of them in place of one that has no twin here".to_owned(),
            _ => format!(", {notes} of them in place of those that have no twin here"),
        };
        output.message(&format!("{nodes} nodes{told}"));
    }
    Ok(())
}

/// The look's file beside a graph's: `clay.mtlx` gives `clay.json`, and `clay.json`, which is taken
/// by the graph, `clay-look.json`.
fn beside(graph: &Path) -> PathBuf {
    let look = graph.with_extension("json");
    if look != graph {
        return look;
    }
    let stem = graph.file_stem().unwrap_or_default().to_string_lossy();
    graph.with_file_name(format!("{stem}-look.json"))
}
