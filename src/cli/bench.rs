//! `chiaro bench`: cost and error of a look, whole and node by node.

use std::path::{Path, PathBuf};

use super::open::{check_nodes_folder, library_for};
use super::output::Output;
use super::render::{Size, parse_samples, parse_time};
use super::target::{OutputPath, outputs, reads_all};
use crate::diag::Diagnostic;
use crate::files::{OutputKind, Outputs};
use crate::frame::{Assets, PlanOptions, open};
use chiaro_laboratory::accuracy::error::VISIBLE;
use chiaro_laboratory::accuracy::{
    BenchOptions, BenchReport, Measure, MeasuredNodes, MeasurementSubject, bench, plot,
};
use chiaro_render::{Gpu, Renderer};

const EXAMPLES: &str = "\
Examples:
  chiaro bench look.json
  chiaro bench look.json --mesh bunny.obj --size 1600x1200 --rounds 60
  chiaro bench look.json --no-truth --every-node
  chiaro bench look.json --plot look.svg --json > look-bench.json

Times are GPU timestamps where the adapter has them, of variants that are drawn in turns: medians \
with 95% confidence
intervals. A node's time is what it adds to the look. Errors are against the reference's picture \
in f64.";

/// Arguments of `chiaro bench`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// A look or a scene
    document: PathBuf,
    /// A mesh or an own shape (shape:creature) in place of the document's
    #[arg(short, long)]
    mesh: Option<String>,
    /// Width and height in pixels
    #[arg(short, long, default_value = "512x512")]
    size: Size,
    /// Samples a pixel, 1 or 4, while time is measured; errors are measured with one
    #[arg(long, default_value_t = 1, value_parser = parse_samples)]
    samples: u32,
    /// Number of times that each variant is drawn, from 3 to 10000
    #[arg(
        short, long, default_value_t = 30, value_parser = clap::value_parser!(u32).range(3..=10_000)
    )]
    rounds: u32,
    /// The time in seconds
    #[arg(long, default_value_t = 0.0, value_parser = parse_time, allow_negative_numbers = true)]
    time: f64,
    /// Measure nodes that have one tier only, too
    #[arg(long)]
    every_node: bool,
    /// Do not compare with the reference, which takes seconds
    #[arg(long)]
    no_truth: bool,
    /// Error that the verdict and the plot are about: max (of any pixel), p99.9 (one pixel in a
    /// thousand exceeds it) or rms
    #[arg(long, default_value = "p99.9")]
    measure: Measure,
    /// An SVG to write: error against time, with the front that nothing beats
    #[arg(short, long)]
    plot: Option<OutputPath>,
    /// A folder of a project's own nodes; `nodes/` beside the document is found without it
    #[arg(long)]
    nodes: Option<PathBuf>,
    /// Replace an SVG that Chiaro did not draw
    #[arg(long)]
    force: bool,
    /// Print the report as JSON
    #[arg(long)]
    json: bool,
}

pub(super) async fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    check_nodes_folder(arguments.nodes.as_deref())?;
    let read = [
        Some(arguments.document.as_path()),
        arguments.mesh.as_deref().map(Path::new),
        arguments.nodes.as_deref(),
    ];
    let mut outputs = outputs(arguments.force, read.into_iter().flatten());
    if let Some(path) = &arguments.plot {
        outputs.check(path.as_ref(), OutputKind::DRAWING).map_err(|problem| vec![problem])?;
    }
    let library = library_for(&arguments.document, arguments.nodes.as_deref());
    output.diagnostics(&library.problems);
    let mut assets = Assets::default();
    let (setup, warnings) =
        open(&arguments.document, arguments.mesh.as_deref(), &mut assets)?.into_parts();
    reads_all(&mut outputs, &setup, &assets);
    output.diagnostics(&warnings);
    let gpu = Gpu::headless().await.map_err(|error| vec![error.into()])?;
    let mut renderer = Renderer::new(gpu);
    let options = BenchOptions {
        plan: PlanOptions {
            size: arguments.size.0,
            samples: arguments.samples,
            time: arguments.time,
        },
        rounds: arguments.rounds as usize,
        nodes: if arguments.every_node { MeasuredNodes::Every } else { MeasuredNodes::Tiered },
        truth: !arguments.no_truth,
    };
    let report = output
        .watch_async("measuring", async |progress| {
            bench(&setup, &library, &mut renderer, &options, progress).await
        })
        .await?;
    if let Some(path) = &arguments.plot {
        let title = setup.looks.first().map_or("", |look| look.look.name.as_str());
        write_plot(path.as_ref(), &report, title, arguments.measure, &mut outputs)
            .map_err(|problem| vec![problem])?;
        output.message(&format!("{}: error against time", path.as_ref().display()));
    }
    if arguments.json {
        output.json(&serde_json::json!(report));
    } else {
        let verdict = report.verdict(arguments.measure, VISIBLE);
        output.result(&[report.table(), verdict].join(if arguments.no_truth { "" } else { "\n" }));
    }
    Ok(())
}

fn write_plot(
    path: &Path,
    report: &BenchReport,
    title: &str,
    measure: Measure,
    outputs: &mut Outputs,
) -> Result<(), Diagnostic> {
    let svg = plot::svg(report, |subject| *subject == MeasurementSubject::Whole, title, measure);
    outputs.write(path, OutputKind::DRAWING, svg.as_bytes())
}
