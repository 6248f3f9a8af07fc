//! `chiaro accuracy`: the errors of every node and every example look, and their worst inputs.

use std::path::PathBuf;

use super::output::Output;
use super::target::{OutputPath, outputs};
use crate::diag::Diagnostic;
use crate::files::Disk;
use crate::library::Library;
use chiaro_sweeps::{
    AccuracyReport, Effort, LookEffort, StabilityEffort, Survey, SurveyPart, looks_in, search,
    survey,
};

const EXAMPLES: &str = "\
Examples:
  chiaro accuracy -o docs/accuracy.md
  chiaro accuracy --nodes profile parametrization
  chiaro accuracy --quick --json > accuracy.json

The truth is the exact tier in f64, fed with what the GPU holds. Exit code 1 where a bound is \
broken.";

/// Arguments of `chiaro accuracy`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// The document to write; its plots go into a folder of its name beside it
    #[arg(short, long)]
    output: Option<OutputPath>,
    /// Only these kinds of nodes, and no looks
    #[arg(short, long, num_args = 1..)]
    nodes: Vec<String>,
    /// Only this part: the nodes, the pictures of looks, or what flickers in them
    #[arg(long, value_enum, conflicts_with = "nodes")]
    only: Option<Part>,
    /// The folder of looks to draw
    #[arg(long, default_value = "examples/looks")]
    looks: PathBuf,
    /// Fewer samples, views and frames, and no search for worse inputs
    #[arg(short, long)]
    quick: bool,
    /// Each look at 4096 pixels too, where the rows in the middle are compared: twenty seconds a
    /// look, and up to ten gigabytes of memory
    #[arg(long)]
    large: bool,
    /// A folder to write the worst inputs into, which a test then holds
    #[arg(long)]
    worst: Option<OutputPath>,
    /// Replace files that Chiaro did not write
    #[arg(long)]
    force: bool,
    /// Print the report as JSON
    #[arg(long)]
    json: bool,
}

/// Part of the report.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Part {
    Nodes,
    Looks,
    Stability,
}

pub(super) async fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let library = Library::built_in();
    check_nodes(&arguments.nodes, library)?;
    let mut outputs = outputs(arguments.force, [&arguments.looks]);
    let one = |problem| vec![problem];
    if let Some(path) = &arguments.output {
        AccuracyReport::check(path.as_ref(), &outputs).map_err(one)?;
    }
    if let Some(folder) = &arguments.worst {
        search::check(folder.as_ref(), library, &outputs).map_err(one)?;
    }
    let quick = arguments.quick;
    let part = arguments.only.map(|part| match part {
        Part::Nodes => SurveyPart::Nodes,
        Part::Looks => SurveyPart::Looks,
        Part::Stability => SurveyPart::Stability,
    });
    let wanted = Survey {
        parts: part.map_or(SurveyPart::ALL.to_vec(), |part| vec![part]),
        nodes: arguments.nodes.clone(),
        effort: if quick { Effort::QUICK } else { Effort::FULL },
        looks: if arguments.nodes.is_empty() {
            looks_in(&Disk, &arguments.looks)?
        } else {
            Vec::new()
        },
        look_effort: if quick { LookEffort::quick() } else { LookEffort::full() },
        large: arguments.large.then(LookEffort::large),
        stability: StabilityEffort { frames: if quick { 6 } else { 60 }, side: 160 },
    };
    let report = output
        .watch_async("measuring", async |progress| {
            survey(&wanted, library, progress, &|worker| crate::wait(worker)).await
        })
        .await;
    let report = report.map_err(Vec::<Diagnostic>::from)?;
    let command = command_of(arguments);
    if let Some(path) = &arguments.output {
        let path = path.as_ref();
        report.write(path, &command, &mut outputs)?;
        output.message(&format!(
            "{}: {} cases, {} looks",
            path.display(),
            report.nodes.len(),
            report.looks.len()
        ));
    }
    if let Some(folder) = &arguments.worst {
        let folder = folder.as_ref();
        search::write(folder, &report.worst, &mut outputs)?;
        output.message(&format!("{}: {} worst inputs", folder.display(), report.worst.len()));
    }
    if arguments.json {
        output.json(&serde_json::json!(report));
    } else if arguments.output.is_none() {
        output.result(&report.markdown(&command, "accuracy"));
    }
    let broken = report.broken();
    if broken.is_empty() {
        return Ok(());
    }
    Err(broken.into_iter().map(|words| Diagnostic::error("beyond-bound", words)).collect())
}

/// The command that produces the same document again.
fn command_of(arguments: &Arguments) -> String {
    let mut command = "chiaro accuracy".to_owned();
    if arguments.quick {
        command += " --quick";
    }
    if let Some(part) = arguments.only.and_then(|part| clap::ValueEnum::to_possible_value(&part)) {
        command += &format!(" --only {}", part.get_name());
    }
    if arguments.large {
        command += " --large";
    }
    if !arguments.nodes.is_empty() {
        command += &format!(" --nodes {}", arguments.nodes.join(" "));
    }
    if let Some(path) = &arguments.output {
        command += &format!(" -o {}", path.as_ref().display());
    }
    command
}

fn check_nodes(kinds: &[String], library: &Library) -> Result<(), Vec<Diagnostic>> {
    let unknown = |kind: &String| {
        Diagnostic::error("bad-argument", format!("there is no node of kind `{kind}`"))
            .suggest(kind.as_str(), library.nodes.keys().map(String::as_str))
    };
    let problems: Vec<Diagnostic> =
        kinds.iter().filter(|kind| !library.nodes.contains_key(*kind)).map(unknown).collect();
    if problems.is_empty() { Ok(()) } else { Err(problems) }
}
