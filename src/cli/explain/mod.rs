//! `chiaro explain`: the frame plan in words, and the compilation of each look to its shader. Needs
//! no GPU.

mod report;
mod text;

use std::path::PathBuf;

use serde_json::json;

use super::open::{check_nodes_folder, library_for};
use super::output::Output;
use super::render::{self, Size};
use super::scene::check_values;
use super::tier::{self, TierChoice};
use crate::compile::Live;
use crate::diag::Diagnostic;
#[cfg(feature = "gpu")]
use crate::frame::FramePlan;
use crate::frame::{Assets, PlanOptions, Planner, open};
#[cfg(feature = "gpu")]
use chiaro_render::{Gpu, PassTime, Renderer, set_times};

const EXAMPLES: &str = "\
Examples:
  chiaro explain look.json                 what is drawn, in which passes, and why
  chiaro explain scene.json --json         the same for a script
  chiaro explain look.json --wgsl > a.wgsl the generated WGSL
  chiaro explain look.json --live          as while it is edited: every value is a uniform
  chiaro explain look.json --measure       with what each pass takes on this machine

Costs are counted without a GPU: operations at each fragment in naga's IR (both sides of branches, \
loops once), and
bytes of memory. `chiaro bench` measures nodes.";

/// Arguments of `chiaro explain`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// A look, a scene or a shot
    document: PathBuf,
    /// A mesh or an own shape (shape:knot) in place of the document's
    #[arg(short, long)]
    mesh: Option<String>,
    /// The time in seconds [default: 0; of a shot its first frame's]
    #[arg(long, allow_negative_numbers = true)]
    time: Option<f64>,
    /// Width and height of the picture, in pixels [default: of a shot its own, else as `chiaro
    /// render` draws it]
    #[arg(long, value_name = "WIDTHxHEIGHT")]
    size: Option<Size>,
    /// A folder of a project's own nodes; `nodes/` beside the document is found without it
    #[arg(long)]
    nodes: Option<PathBuf>,
    /// The implementation of every node: exact, balanced, fast, or automatic, the cheapest that
    /// nobody can see; the document's without it
    #[arg(long, value_parser = tier::parse)]
    tier: Option<TierChoice>,
    /// Explain the shader that is used while the look is edited, in which nothing is folded
    #[arg(long)]
    live: bool,
    /// Draw it, and tell what each pass takes (the median of 7)
    #[cfg(feature = "gpu")]
    #[arg(long, conflicts_with = "wgsl")]
    measure: bool,
    /// Print JSON
    #[arg(long, conflicts_with = "wgsl")]
    json: bool,
    /// Print the generated WGSL
    #[arg(long)]
    wgsl: bool,
}

pub(super) async fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    check_nodes_folder(arguments.nodes.as_deref())?;
    let mut library = library_for(&arguments.document, arguments.nodes.as_deref());
    output.diagnostics(&library.problems);
    let mut assets = Assets::default();
    let (mut setup, mut warnings) =
        open(&arguments.document, arguments.mesh.as_deref(), &mut assets)?.into_parts();
    warnings.extend(check_values(&setup, &library)?);
    output.diagnostics(&warnings);
    if let Some(tier) = arguments.tier {
        for worn in &mut setup.looks {
            tier::set_every_tier(&mut worn.look, &mut library, tier);
        }
    }
    let live = if arguments.live { Live::All } else { Live::Keyed };
    // Options of `chiaro render` without arguments.
    let time = arguments.time.unwrap_or_else(|| setup.first_time());
    let size = render::size_of(arguments.size.as_ref(), &setup);
    let options = PlanOptions { size, samples: 4, time };
    let mut planner = Planner::new(assets);
    let (plan, warnings) = planner.plan(&setup, &library, &live, &options)?.into_parts();
    output.diagnostics(&warnings);
    #[cfg_attr(not(feature = "gpu"), expect(unused_mut, reason = "only a GPU adds times"))]
    let mut report = report::ExplainReport::new(&setup, &plan, &library)?;
    #[cfg(feature = "gpu")]
    if arguments.measure {
        measure(&mut report, &plan, output).await.map_err(|problem| vec![problem])?;
    }
    if arguments.wgsl {
        output.result(report.wgsl().trim_end());
    } else if arguments.json {
        output.json(&json!(report));
    } else {
        output.result(&text::tell(&report, &arguments.document.display().to_string()));
    }
    Ok(())
}

#[cfg(feature = "gpu")]
async fn measure(
    report: &mut report::ExplainReport,
    plan: &FramePlan,
    output: &Output,
) -> Result<(), Diagnostic> {
    const ROUNDS: usize = 7;
    let mut renderer = Renderer::new(Gpu::headless().await?);
    // The first picture also compiles pipelines.
    renderer.draw(plan).await?;
    let mut rounds: Vec<Vec<PassTime>> = Vec::new();
    for _ in 0..ROUNDS {
        rounds.push(renderer.measure(plan).await?);
    }
    let medians: Vec<PassTime> = (0..rounds[0].len())
        .map(|pass| {
            let mut times: Vec<&PassTime> =
                rounds.iter().filter_map(|times| times.get(pass)).collect();
            times.sort_by_key(|time| time.duration);
            times[times.len() / 2].clone()
        })
        .collect();
    set_times(&mut report.effects, &medians);
    output.message(&format!("measured on {}", renderer.gpu().name()));
    Ok(())
}
