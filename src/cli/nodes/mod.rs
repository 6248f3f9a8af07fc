//! `chiaro nodes`: the library as a table, one node's documentation, or all of it as docs/nodes.md.

mod entry;
mod json;
mod markdown;
mod text;

use std::path::PathBuf;

use super::output::Output;
use crate::diag::Diagnostic;
use crate::library::Library;
use entry::Entry;

const EXAMPLES: &str = "\
Examples:
  chiaro nodes                      every node, with its inputs and outputs
  chiaro nodes profile              everything about one
  chiaro nodes light_layer --json   the same for a script
  chiaro nodes --nodes my/nodes     with a project's own nodes
  chiaro nodes --markdown           docs/nodes.md";

/// What `chiaro nodes` is given.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// The node to tell all about
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
}

pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let library = match &arguments.nodes {
        Some(folder) => Library::built_in().with_project(folder),
        None => Library::built_in().clone(),
    };
    let entries = entry::entries(&library);
    if arguments.markdown {
        output.result(markdown::document(&entries).trim_end());
    } else if let Some(kind) = &arguments.kind {
        let entry = entries.iter().find(|entry| entry.kind == *kind).ok_or_else(|| vec![unknown(kind, &entries)])?;
        let whole = if arguments.json { json::pretty(&json::entry(entry)) } else { text::whole(entry) };
        output.result(&whole);
    } else if arguments.json {
        output.result(&json::pretty(&entries.iter().map(json::entry).collect()));
    } else {
        output.result(&text::table(&entries));
    }
    output.diagnostics(&library.problems);
    Ok(())
}

/// Near names, of kinds and of what people read for them.
fn unknown(kind: &str, entries: &[Entry]) -> Diagnostic {
    let by_label = entries.iter().filter(|entry| entry.label.to_lowercase().contains(&kind.to_lowercase()));
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
    let problem =
        if names.is_empty() { problem } else { problem.hint(format!("did you mean {}?", names.join(" or "))) };
    problem.hint("`chiaro nodes` lists every kind")
}
