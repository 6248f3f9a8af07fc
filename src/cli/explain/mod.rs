//! `chiaro explain`: the frame plan in words, and what became of each look on the way to its shader. Needs no GPU.

mod report;
mod text;

use std::path::PathBuf;

use serde_json::json;

use super::open::{check_nodes_folder, library_for};
use super::output::Output;
use super::scene::check_values;
use crate::compile::Live;
use crate::diag::Diagnostic;
use crate::frame::{Assets, PlanOptions, Planner, open};

const EXAMPLES: &str = "\
Examples:
  chiaro explain look.json                 what is drawn, in which passes, and why
  chiaro explain scene.json --json         the same for a script
  chiaro explain look.json --wgsl > a.wgsl the generated WGSL
  chiaro explain look.json --live          as while it is edited: every value is a uniform";

/// What `chiaro explain` is given.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// A look or a scene
    document: PathBuf,
    /// A mesh or an own shape (shape:knot) in place of the document's
    #[arg(short, long)]
    mesh: Option<String>,
    /// The time in seconds
    #[arg(long, default_value_t = 0.0, allow_negative_numbers = true)]
    time: f64,
    /// A folder of a project's own nodes; `nodes/` beside the document is found without it
    #[arg(long)]
    nodes: Option<PathBuf>,
    /// Explain the shader that is used while the look is edited, in which nothing is folded
    #[arg(long)]
    live: bool,
    /// Print JSON
    #[arg(long, conflicts_with = "wgsl")]
    json: bool,
    /// Print the generated WGSL
    #[arg(long)]
    wgsl: bool,
}

pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    check_nodes_folder(arguments.nodes.as_deref())?;
    let library = library_for(&arguments.document, arguments.nodes.as_deref());
    output.diagnostics(&library.problems);
    let mut assets = Assets::default();
    let (setup, mut warnings) = open(&arguments.document, arguments.mesh.as_deref(), &mut assets)?;
    warnings.extend(check_values(&setup, &arguments.document, &library)?);
    output.diagnostics(&warnings);
    let live = if arguments.live { Live::All } else { Live::Keyed };
    // As `chiaro render` without options.
    let options = PlanOptions { size: [800, 800], samples: 4, time: arguments.time };
    let mut planner = Planner::new(assets);
    let plan = planner.plan(&setup, &library, &live, &options)?;
    output.diagnostics(&planner.warnings);
    let report = report::Report::new(&setup, &plan, &library)?;
    if arguments.wgsl {
        output.result(report.wgsl().trim_end());
    } else if arguments.json {
        output.json(&json!(report));
    } else {
        output.result(&text::tell(&report, &arguments.document.display().to_string()));
    }
    Ok(())
}
