//! `chiaro eval`: the value of a look, or of any node, at given surface samples.

use std::path::PathBuf;

use serde_json::{Value as Json, json};

use super::open::{check_nodes_folder, library_for, open_look};
use super::output::Output;
use super::tier::TierChoice;
use super::{samples, tier};
use crate::compile::{CompileOptions, check};
use crate::diag::Diagnostic;
use crate::document::{Look, Node, Value};
use crate::frame::{Assets, eval_batches};
use crate::ids::{NodePath, PortName};
use crate::library::{
    CUSTOM_CODE, CUSTOM_KIND, Context, GroupPorts, Library, Output as Port, Type, load_node,
};
use chiaro_render::{Gpu, Renderer};

const HELP: &str = r#"Examples:
  chiaro eval look.json --at samples.json
  chiaro eval look.json --at samples.json --output rim.tone        an output of a node
  chiaro eval look.json --at samples.json --output rim/angle       of a node in a group
  echo '[{"normal": [0, 1, 1]}]' | chiaro eval look.json --at -

SAMPLES.json is a list of objects; every field may be left out:
  normal, tangent, view (surface to eye), position    world space, 3 numbers, unit or not
  mirrored      true where texture coordinates are mirrored
  camera        three rows: right, up, toward the viewer
  uv, time, color (vertex color)
  kappa         a number; also "inf", "-inf", "nan"
CONTEXTS                (the picture of a sample is one pixel high)
  distance      from the eye to the object, in scene units
  front         the object's front, world space, 3 numbers
  near          {"another object's id": its distance}
  frame         the illumination frame's rotation: a 3x3 matrix (rows) or a quaternion [x, y, z, w]
  lights        {"key": {"direction": [..] or "position": [..], "color": [..], "intensity": 1}},
                in the light's own frame; the direction is toward the light
  values        {exposed parameter: number, array or string}

The answer is a list of {"value": [...]} in the same order: straight RGBA for a look, the numbers of
the output's type for a node (an angle in radians; a light's direction and intensity)."#;

/// The help, with a description of each context that a sample may give numbers for.
fn help() -> String {
    let context = |(context, _): (Context, _)| {
        let mut lines = vec![format!("  {:13}", context.word())];
        for word in context.help().split_whitespace() {
            let last = lines.last_mut().filter(|line| line.len() + word.len() < HELP_WIDTH);
            match last {
                Some(line) => *line += &format!(" {word}"),
                None => lines.push(format!("{:16}{word}", "")),
            }
        }
        lines.join("\n") + "\n"
    };
    HELP.replace("CONTEXTS", &samples::own_contexts().map(context).collect::<String>())
}

/// Width of the help, in columns.
const HELP_WIDTH: usize = 100;

/// Arguments of `chiaro eval`.
#[derive(Debug, clap::Args)]
#[command(after_help = help())]
pub(super) struct Arguments {
    /// A look
    look: PathBuf,
    /// The samples: a JSON file, or `-` for standard input
    #[arg(long)]
    at: PathBuf,
    /// The implementation to run in every node: exact, balanced, fast, or automatic, the cheapest
    /// that nobody can see; the document's without it
    #[arg(long, value_parser = tier::parse)]
    tier: Option<TierChoice>,
    /// The output to print in place of the look's own: NODE.PORT, with `/` between groups and nodes
    #[arg(long)]
    output: Option<String>,
    /// A folder of a project's own nodes; `nodes/` beside the look is found without it
    #[arg(long)]
    nodes: Option<PathBuf>,
    /// Fold nothing and remove nothing: what pruning is held against
    #[arg(long)]
    unspecialized: bool,
}

pub(super) async fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    check_nodes_folder(arguments.nodes.as_deref())?;
    let mut library = library_for(&arguments.look, arguments.nodes.as_deref());
    output.diagnostics(&library.problems);
    let mut setup = open_look(&arguments.look, output)?;
    if let Some(tier) = arguments.tier {
        tier::set_every_tier(&mut setup.look, &mut library, tier);
    }
    let samples = samples::read(&arguments.at)?;
    let options = CompileOptions {
        root: arguments.output.as_deref().map(parse_output),
        unspecialized: arguments.unspecialized,
        ..CompileOptions::default()
    };
    // Warnings are told even without a sample to run, and only once for many samples.
    let located = |mut problems: Vec<Diagnostic>| {
        setup.source.locate_all(&mut problems);
        problems
    };
    let (_, warnings) = check(&setup.look, &library, options.root.as_ref())
        .map_err(|mut problems| {
            if let Some(root) = &options.root {
                problems
                    .iter_mut()
                    .for_each(|problem| list_outputs(problem, root, &setup.look, &library));
            }
            located(problems)
        })?
        .into_parts();
    output.diagnostics(&located(warnings));
    let file = samples::name(&arguments.at);
    let batches = eval_batches(&setup, &library, &samples, &options, &mut Assets::default())
        .map_err(|mut problems| {
            let of_sample = |p: &&mut Diagnostic| {
                p.place.json_path.as_ref().is_some_and(|path| path.starts_with('['))
            };
            for problem in problems.iter_mut().filter(of_sample) {
                problem.place.file = Some(file.clone());
            }
            problems
        })?;
    let mut answers = vec![Json::Null; samples.len()];
    if !batches.is_empty() {
        let one = |error: chiaro_render::RenderError| vec![Diagnostic::from(error)];
        let mut renderer = Renderer::new(Gpu::headless().await.map_err(one)?);
        for batch in &batches {
            let values = renderer.evaluate(batch).await.map_err(one)?;
            for (&index, value) in batch.indices.iter().zip(values) {
                answers[index] = json!({ "value": numbers_of(&batch.shader.root_type, value) });
            }
        }
    }
    output.result(&json_lines(&answers));
    Ok(())
}

/// Adds a list of the look's outputs to the problem of an unknown `--output` that resembles no
/// name.
fn list_outputs(
    problem: &mut Diagnostic,
    root: &(NodePath, PortName),
    look: &Look,
    library: &Library,
) {
    const MOST: usize = 20;
    let (path, _) = root;
    let is_of_node = problem.code == "unknown-port" && problem.place.node.as_ref() == Some(path);
    let is_of_root =
        problem.code == "unknown-node" && problem.message.contains(&format!("`{path}`"));
    if !problem.hints.is_empty() || !(is_of_node || is_of_root) {
        return;
    }
    let mut outputs: Vec<String> = Vec::new();
    for (id, node) in &look.graph.nodes {
        let names = output_names(node, look, library);
        outputs.extend(names.iter().map(|name| format!("{id}.{name}")));
    }
    if is_of_node {
        let of_node = format!("{path}.");
        outputs.retain(|output| output.starts_with(&of_node));
        // The node may lie in a group.
        let typed = outputs.is_empty().then(|| check(look, library, None).ok()).flatten();
        let inner =
            typed.iter().flat_map(|typed| &typed.value.nodes).find(|node| node.path == *path);
        outputs.extend(
            inner
                .iter()
                .flat_map(|node| &node.def.outputs)
                .map(|port| format!("{path}.{}", port.name)),
        );
    }
    if outputs.is_empty() {
        return;
    }
    let more = outputs.len().saturating_sub(MOST);
    let told: Vec<String> = outputs.iter().take(MOST).map(|output| format!("`{output}`")).collect();
    let rest = if more > 0 { format!(" and {more} more") } else { String::new() };
    problem.hints.push(format!("the outputs are {}{rest}", told.join(", ")));
}

/// Names of a node's outputs, for nodes of the library, groups, and nodes with code of their own.
fn output_names(node: &Node, look: &Look, library: &Library) -> Vec<String> {
    let ports = |outputs: &[Port]| outputs.iter().map(|output| output.name.to_string()).collect();
    if let Some(def) = library.nodes.get(&node.kind) {
        return ports(&def.outputs);
    }
    if let Some(definition) = library.group_of(look, &node.kind) {
        return ports(&GroupPorts::of(definition, &look.definitions, library).outputs);
    }
    match node.values.get(CUSTOM_CODE) {
        Some(Value::Text(code)) if node.kind == CUSTOM_KIND => {
            load_node("code.wgsl", code, Some(CUSTOM_KIND))
                .map(|def| ports(&def.outputs))
                .unwrap_or_default()
        }
        _ => Vec::new(),
    }
}

/// A JSON list with one answer a line.
fn json_lines(answers: &[Json]) -> String {
    let lines: Vec<String> = answers.iter().map(|answer| format!("  {answer}")).collect();
    if lines.is_empty() { "[]".to_owned() } else { format!("[\n{}\n]", lines.join(",\n")) }
}

/// The first of the four numbers, as many as the type has; an angle in radians.
fn numbers_of(ty: &Type, value: [f32; 4]) -> Vec<Json> {
    // An f32 goes through its shortest decimal, so that the printed number is the computed one,
    // without further digits.
    let number = |x: f32| {
        let shortest: f64 = x.to_string().parse().unwrap_or(f64::from(x));
        if shortest.is_finite() { json!(shortest) } else { json!(x.to_string()) }
    };
    match ty {
        Type::Angle => {
            let [half_sin, half_cos, ..] = value.map(f64::from);
            vec![json!(2.0 * half_sin.atan2(half_cos))]
        }
        Type::Float | Type::Int | Type::Bool => vec![number(value[0])],
        Type::Vec2 => value[..2].iter().map(|x| number(*x)).collect(),
        Type::Vec3 | Type::Mat3 => value[..3].iter().map(|x| number(*x)).collect(),
        _ => value.iter().map(|x| number(*x)).collect(),
    }
}

/// Parses `group/node.port`; the port may be left out for a node's first output.
fn parse_output(text: &str) -> (NodePath, PortName) {
    let (node, port) = text.rsplit_once('.').unwrap_or((text, ""));
    (NodePath::parse(node), PortName::from(port))
}
