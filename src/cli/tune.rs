//! `chiaro tune`: the cheapest tiers under an error, or the most accurate within a time, written
//! into the look.

use std::path::{Path, PathBuf};

use super::open::{check_nodes_folder, library_for};
use super::output::Output;
use super::render::Size;
use super::target::{OutputPath, check_document, outputs};
use crate::diag::Diagnostic;
use crate::document::{Document, Look};
use crate::files::{OutputKind, Outputs};
use crate::frame::{Assets, PlanOptions, Setup, open};
use chiaro_laboratory::accuracy::report::tier_word;
use chiaro_laboratory::accuracy::tune::{Goal, TuneOptions, TuneReport, is_dominated, tune};
use chiaro_laboratory::accuracy::{Measure, Variant};
use chiaro_render::{Gpu, Renderer};

const EXAMPLES: &str = "\
Examples:
  chiaro tune look.json --max-error 1/255
  chiaro tune look.json --max-error 0.002 --mesh bunny.obj --views 24 -o tuned.json
  chiaro tune look.json --max-time 4 --size 1920x1080
  chiaro tune look.json --max-error 1/255 --dry-run --json

Errors are against the reference in f64, over views, turns of the lights and times that are spread \
evenly; times are GPU
timestamps of this machine. Tiers that are not faster beyond the noise stay exact, and are listed.

What --max-error bounds is --measure: by default p99.9, so that in every view at most one pixel in \
a thousand is farther from
the truth; max bounds every pixel, which the exact tier itself may miss where f32 decides at a \
crease or a silhouette.";

/// Arguments of `chiaro tune`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
#[command(group = clap::ArgGroup::new("goal").required(true).args(["max_error", "max_time"]))]
pub(super) struct Arguments {
    /// A look; its tiers are written back into it
    look: PathBuf,
    /// The largest error of a channel, by the measure, from 0 to 1: a number or a fraction such as
    /// 1/255
    #[arg(long, value_parser = parse_error)]
    max_error: Option<f64>,
    /// The longest time of a frame, in milliseconds
    #[arg(long, value_parser = parse_milliseconds)]
    max_time: Option<f64>,
    /// Error that is meant: p99.9, which one pixel in a thousand of a view may exceed; max, which
    /// none may; or rms
    #[arg(long, default_value = "p99.9")]
    measure: Measure,
    /// The mesh that the look is tuned on; several may be given, and all must be within the error
    #[arg(short, long)]
    mesh: Vec<String>,
    /// Width and height in pixels of the picture whose time counts
    #[arg(short, long, default_value = "512x512")]
    size: Size,
    /// Number of views, turns of the lights and times at which the error is measured, from 1 to
    /// 1000
    #[arg(long, default_value_t = 12, value_parser = clap::value_parser!(u32).range(1..=1000))]
    views: u32,
    /// The side in pixels of the pictures that are compared, from 16 to 4096
    #[arg(long, default_value_t = 160, value_parser = clap::value_parser!(u32).range(16..=4096))]
    error_size: u32,
    /// Number of times that each variant is drawn, from 3 to 10000
    #[arg(
        short, long, default_value_t = 20, value_parser = clap::value_parser!(u32).range(3..=10_000)
    )]
    rounds: u32,
    /// File for the tuned look, in place of the look itself
    #[arg(short, long)]
    output: Option<OutputPath>,
    /// Replace another look that is there
    #[arg(long)]
    force: bool,
    /// Tell what would be chosen, and write nothing
    #[arg(long)]
    dry_run: bool,
    /// A folder of a project's own nodes; `nodes/` beside the document is found without it
    #[arg(long)]
    nodes: Option<PathBuf>,
    /// Print the report as JSON
    #[arg(long)]
    json: bool,
}

fn parse_error(text: &str) -> Result<f64, String> {
    let number = |text: &str| text.trim().parse::<f64>().ok();
    let value = match text.split_once('/') {
        Some((above, below)) => {
            number(above).zip(number(below)).map(|(above, below)| above / below)
        }
        None => number(text),
    };
    value
        .filter(|value| *value > 0.0 && *value <= 1.0)
        .ok_or_else(|| "write it as 0.002 or 1/255, at most 1".to_owned())
}

fn parse_milliseconds(text: &str) -> Result<f64, String> {
    let time = text.parse().ok().filter(|time: &f64| *time > 0.0 && time.is_finite());
    time.ok_or_else(|| "milliseconds, as in 16.7".to_owned())
}

pub(super) async fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let mut outputs = outputs(
        arguments.force,
        arguments.mesh.iter().map(Path::new).chain(arguments.nodes.as_deref()),
    );
    outputs.changes(&arguments.look);
    let written = arguments.output.as_ref().filter(|_| !arguments.dry_run);
    check_document(&outputs, written).map_err(|problem| vec![problem])?;
    check_nodes_folder(arguments.nodes.as_deref())?;
    let library = library_for(&arguments.look, arguments.nodes.as_deref());
    output.diagnostics(&library.problems);
    let setups = setups(arguments, output)?;
    let gpu = Gpu::headless().await.map_err(|error| vec![error.into()])?;
    let mut renderer = Renderer::new(gpu);
    let options = TuneOptions {
        goal: match (arguments.max_error, arguments.max_time) {
            (Some(error), _) => Goal::MaxError(error),
            (None, time) => Goal::MaxTime(time.unwrap_or(f64::INFINITY)),
        },
        measure: arguments.measure,
        plan: PlanOptions { size: arguments.size.0, samples: 1, time: 0.0 },
        error_side: arguments.error_size,
        rounds: arguments.rounds as usize,
        viewpoints: arguments.views as usize,
    };
    let tuned = output
        .watch_async("tuning", async |progress| {
            tune(&setups, &library, &mut renderer, &options, progress).await
        })
        .await?;
    if !arguments.dry_run {
        let target = arguments.output.as_ref().map_or(arguments.look.as_path(), AsRef::as_ref);
        write(arguments, &tuned, target, &mut outputs)?;
        output.message(&format!("{}: written with its tiers and the report", target.display()));
    }
    if arguments.json {
        output.json(&serde_json::json!(tuned));
    } else {
        output.result(&report(&tuned));
    }
    if tuned.is_met {
        return Ok(());
    }
    Err(vec![missed(&tuned, &arguments.mesh)])
}

/// Diagnostic of a goal that was missed, with the reason and what can be done.
fn missed(tuned: &TuneReport, meshes: &[String]) -> Diagnostic {
    let problem = |message: String| Diagnostic::error("goal-missed", message);
    if !tuned.is_exact_beyond() {
        let problem = problem("no choice of tiers reaches what was asked for".to_owned());
        return problem
            .hint("the report says what was reached; allow more, or make the look cheaper");
    }
    let (worst, measure, side) = (&tuned.worst_exact, tuned.measure, tuned.worst_exact.side);
    let [x, y] = worst.pixel;
    let mesh = meshes.get(worst.setup).map(|mesh| format!(" on {mesh}")).unwrap_or_default();
    let message = format!(
        "the exact tier itself is beyond what was asked for: {} is {:.2e}; the worst pixel, off by \
         {:.2e}, is {x},{y} of \
         {side}x{side}{mesh}: {}",
        measure.meaning(),
        measure.of(&tuned.error_exact),
        worst.error,
        worst.viewpoint.told(),
    );
    let figures = &tuned.error_exact;
    let hint = if measure == Measure::Max {
        format!(
            "{} of {} pixels are off by more than 1/255; --measure p99.9 leaves out single pixels, \
             or allow more",
            figures.visible, figures.pixels
        )
    } else {
        "f32 cannot do better: allow more, or soften what is steep there, a fall-off or a slope"
            .to_owned()
    };
    problem(message).hint(hint)
}

/// The setup of the look on each mesh.
fn setups(arguments: &Arguments, output: &Output) -> Result<Vec<Setup>, Vec<Diagnostic>> {
    let mut assets = Assets::default();
    let meshes: Vec<Option<&str>> = match arguments.mesh.as_slice() {
        [] => vec![None],
        some => some.iter().map(|mesh| Some(mesh.as_str())).collect(),
    };
    let mut setups = Vec::new();
    if let Document::Scene(_) = Document::load(&crate::files::Disk, &arguments.look) {
        let problem = Diagnostic::error("bad-argument", "this is a scene; tiers belong to looks");
        return Err(vec![
            problem.in_file(arguments.look.display().to_string()).hint("tune each of its looks"),
        ]);
    }
    for mesh in meshes {
        let (setup, warnings) = open(&arguments.look, mesh, &mut assets)?.into_parts();
        output.diagnostics(&warnings);
        setups.push(setup);
    }
    Ok(setups)
}

/// Writes the look with the chosen tiers, and the report on them.
fn write(
    arguments: &Arguments,
    tuned: &TuneReport,
    target: &Path,
    outputs: &mut Outputs,
) -> Result<(), Vec<Diagnostic>> {
    let loaded = Look::load(&crate::files::Disk, &arguments.look);
    let Some(mut look) = loaded.value else { return Err(loaded.diagnostics) };
    for (node, tier) in tuned.tiers() {
        Variant::set_tier(&mut look, node, tier);
    }
    // Nodes in groups that name no tier, and those that are added later, keep the bound, too.
    if let Goal::MaxError(most) = tuned.goal {
        look.max_error = look.max_error.min(most);
    }
    look.tuned = tuned.summary();
    let text = look.to_text_like(&loaded.source);
    outputs.write(target, OutputKind::DOCUMENT, text.as_bytes()).map_err(|problem| vec![problem])
}

/// The report for people.
fn report(tuned: &TuneReport) -> String {
    let mut lines = vec![tuned.summary()];
    lines.push(format!("  error means {}: {}", tuned.measure.word(), tuned.measure.meaning()));
    let [x, y] = tuned.worst.pixel;
    if tuned.worst.error > 0.0 {
        let (side, viewpoint) = (tuned.worst.side, tuned.worst.viewpoint.told());
        lines.push(format!(
            "  the worst pixel, off by {:.1e}: {x},{y} of {side}x{side}, {viewpoint}",
            tuned.worst.error
        ));
    }
    for (index, candidate) in tuned.candidates.iter().enumerate() {
        let better = tuned.candidates.iter().find(|other| is_dominated(candidate, other));
        let state = match (tuned.chosen.contains(&index), candidate.saves.low > 0.0, better) {
            (true, ..) => "chosen".to_owned(),
            (_, false, _) => "cannot be told apart from exact in time: stays exact".to_owned(),
            (_, _, Some(other)) => {
                let tier = tier_word(other.tier);
                format!("cannot be told apart from {tier} in time, which is nearer to the truth")
            }
            _ => "too far from the truth, or another tier of this node is better".to_owned(),
        };
        lines.push(format!(
            "  {} {}: error {:.1e}, saves {:.3} ms ({:.3} to {:.3}): {state}",
            candidate.node,
            tier_word(candidate.tier),
            candidate.error,
            candidate.saves.median,
            candidate.saves.low,
            candidate.saves.high,
        ));
    }
    if tuned.candidates.is_empty() {
        lines.push("  no node of this look has more than one tier".to_owned());
    }
    lines.join("\n")
}
