//! `chiaro nodes`: the library as a table, one node's documentation, or the whole documentation as
//! docs/nodes.md.

mod entry;
mod json;
mod markdown;
mod text;

use std::path::PathBuf;

use super::output::Output;
#[cfg(feature = "gpu")]
use super::target::{OutputPath, outputs};
use crate::diag::Diagnostic;
use crate::library::Library;
#[cfg(feature = "gpu")]
use chiaro_laboratory::gallery::nodes::{check_nodes, write_nodes};
#[cfg(feature = "gpu")]
use chiaro_render::Gpu;
use entry::NodeEntry;

const EXAMPLES: &str = "\
Examples:
  chiaro nodes                      every node, with its inputs and outputs
  chiaro nodes profile              everything about one
  chiaro nodes 'light layer'        the same by what the window calls it
  chiaro nodes light_layer --json   the same for a script
  chiaro nodes --nodes my/nodes     with a project's own nodes
  chiaro nodes --markdown           docs/nodes.md
  chiaro nodes --pictures docs/nodes/   the pictures in it";

/// Arguments of `chiaro nodes`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// The node to tell all about: its kind, with a choice after a dot or without, or its name in
    /// the window
    kind: Option<String>,
    /// A folder of a project's own nodes
    #[arg(long)]
    nodes: Option<PathBuf>,
    /// Print JSON
    #[arg(long, conflicts_with = "markdown")]
    json: bool,
    /// Print the whole documentation as Markdown
    #[arg(long, conflicts_with = "kind")]
    markdown: bool,
    /// Draw every node into a folder: the node itself as SVG, and what it gives on a sphere as PNG
    #[cfg(feature = "gpu")]
    #[arg(long, value_name = "FOLDER", conflicts_with_all = ["kind", "json", "markdown"])]
    pictures: Option<OutputPath>,
    /// With --pictures: replace files that Chiaro did not draw
    #[cfg(feature = "gpu")]
    #[arg(long, requires = "pictures")]
    force: bool,
}

pub(super) async fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let library = match &arguments.nodes {
        Some(folder) => Library::built_in().with_project(&crate::files::Disk, folder),
        None => Library::built_in().clone(),
    };
    #[cfg(feature = "gpu")]
    if let Some(folder) = &arguments.pictures {
        return draw(&library, folder.as_ref(), arguments, output).await;
    }
    let entries = entry::entries(&library);
    if arguments.markdown {
        output.result(markdown::document(&entries).trim_end());
    } else if let Some(kind) = &arguments.kind {
        let entry = find(kind, &entries).map_err(|problem| vec![problem])?;
        let whole =
            if arguments.json { json::pretty(&json::entry(entry)) } else { text::whole(entry) };
        output.result(&whole);
    } else if arguments.json {
        output.result(&json::pretty(&entries.iter().map(json::entry).collect()));
    } else {
        output.result(&text::table(&entries));
    }
    output.diagnostics(&library.problems);
    Ok(())
}

#[cfg(feature = "gpu")]
async fn draw(
    library: &Library,
    folder: &std::path::Path,
    arguments: &Arguments,
    output: &Output,
) -> Result<(), Vec<Diagnostic>> {
    let mut outputs = outputs(arguments.force, &arguments.nodes);
    check_nodes(library, folder, &outputs).map_err(|problem| vec![problem])?;
    let gpu = Gpu::headless().await.map_err(|error| vec![error.into()])?;
    output
        .watch_async("drawing", async |progress| {
            write_nodes(library, folder, &gpu, &mut outputs, progress).await
        })
        .await?;
    output.message(&format!("{}: pictures of every node", folder.display()));
    output.diagnostics(&library.problems);
    Ok(())
}

/// The node of a kind, of a kind with choices (`blend.multiply`), or of a label.
///
/// # Errors
/// An unknown name, with near names as a hint; an unknown choice, with the node's choices as a
/// hint.
fn find<'e>(name: &str, entries: &'e [NodeEntry]) -> Result<&'e NodeEntry, Diagnostic> {
    let mut words = name.split('.');
    let kind = words.next().unwrap_or_default();
    let by_label =
        || entries.iter().find(|entry| entry.label.to_lowercase() == name.to_lowercase());
    let entry = entries.iter().find(|entry| entry.kind == kind).or_else(by_label);
    let entry = entry.ok_or_else(|| unknown(name, entries))?;
    match words.find(|choice| entry.kind == kind && !entry.offers(choice)) {
        Some(choice) => Err(no_choice(entry, choice)),
        None => Ok(entry),
    }
}

fn no_choice(entry: &NodeEntry, choice: &str) -> Diagnostic {
    let problem =
        Diagnostic::error("unknown-choice", format!("`{}` has no choice `{choice}`", entry.kind));
    let words: Vec<String> = entry.choices().map(|word| format!("`{word}`")).collect();
    if words.is_empty() {
        return problem.hint(format!("it has none at all: `chiaro nodes {}`", entry.kind));
    }
    problem.hint(format!("there are {}", words.join(", ")))
}

/// Error of an unknown kind, with near names of kinds and of labels.
fn unknown(kind: &str, entries: &[NodeEntry]) -> Diagnostic {
    if kind.starts_with("by.") {
        let problem =
            Diagnostic::error("unknown-kind", format!("`{kind}` is no node but what keys follow"));
        return problem.hint(
            "any value may have keys; docs/format.md tells how they are written, \
                   under \"Direction keys\"",
        );
    }
    let by_label =
        entries.iter().filter(|entry| entry.label.to_lowercase().contains(&kind.to_lowercase()));
    let problem = Diagnostic::error("unknown-kind", format!("there is no node of kind `{kind}`"));
    let mut near = crate::diag::nearest(kind, entries.iter().map(|entry| entry.kind.as_str()));
    near.extend(by_label.map(|entry| entry.kind.as_str()).take(3));
    let mut unique: Vec<&str> = Vec::new();
    near.retain(|name| {
        let is_new = !unique.contains(name);
        unique.push(name);
        is_new
    });
    let names: Vec<_> = near.iter().map(|name| format!("`{name}`")).collect();
    let problem = if names.is_empty() {
        problem
    } else {
        problem.hint(format!("did you mean {}?", names.join(" or ")))
    };
    problem.hint("`chiaro nodes` lists every kind")
}
