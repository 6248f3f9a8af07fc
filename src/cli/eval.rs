//! `chiaro eval`: a look's value, or any node's, at given surface samples.

use std::path::{Path, PathBuf};

use glam::{DMat3, DQuat, DVec2, DVec3};
use serde::Deserialize;
use serde_json::{Value as Json, json};

use super::output::Output;
use super::render::library_for;
use crate::compile::Options;
use crate::diag::{Diagnostic, LineColumn, has_errors};
use crate::document::{Look, Tier, Value, read_text};
use crate::frame::{Assets, EvalSample, LightOverride, SetupLook, eval_batches};
use crate::ids::{NodePath, PortName};
use crate::library::Type;
use crate::render::{Gpu, Renderer, block_on};

const HELP: &str = r#"Examples:
  chiaro eval look.json --at samples.json
  chiaro eval look.json --at samples.json --output rim/tone.tone

SAMPLES.json is a list of objects; every field may be left out:
  normal, tangent, view (surface to eye), position    world space, 3 numbers, unit or not
  camera        three rows: right, up, toward the viewer
  uv, kappa, time, color (vertex colour)
  frame         the illumination frame's rotation: a 3x3 matrix (rows) or a quaternion [x, y, z, w]
  lights        {"key": {"direction": [..] or "position": [..], "color": [..], "intensity": 1}},
                in the light's own frame; the direction is toward the light
  values        {exposed parameter: number, array or string}

The answer is a list of {"value": [...]} in the same order: straight RGBA for a look, the numbers of
the output's type for a node (an angle in radians; a light's direction and intensity)."#;

/// What `chiaro eval` is given.
#[derive(Debug, clap::Args)]
#[command(after_help = HELP)]
pub(super) struct Arguments {
    /// A look
    look: PathBuf,
    /// The samples: a JSON file, or `-` for standard input
    #[arg(long)]
    at: PathBuf,
    /// The implementation to run in every node: exact, balanced or fast
    #[arg(long, value_parser = parse_tier)]
    tier: Option<Tier>,
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

fn parse_tier(text: &str) -> Result<Tier, String> {
    match text {
        "exact" => Ok(Tier::Exact),
        "balanced" => Ok(Tier::Balanced),
        "fast" => Ok(Tier::Fast),
        _ => Err("it is exact, balanced or fast".to_owned()),
    }
}

pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let library = library_for(&arguments.look, arguments.nodes.as_deref());
    output.diagnostics(&library.problems);
    let loaded = Look::load(&arguments.look);
    let Some(mut look) = loaded.value.clone().filter(|_| !has_errors(&loaded.diagnostics)) else {
        return Err(loaded.diagnostics);
    };
    output.diagnostics(&loaded.diagnostics);
    if let Some(tier) = arguments.tier {
        set_tier(&mut look, tier);
    }
    let folder = arguments.look.parent().map(Path::to_path_buf).unwrap_or_default();
    let setup = SetupLook { look, source: loaded.source.into(), folder };
    let samples = read_samples(&arguments.at)?;
    let options = Options {
        root: arguments.output.as_deref().map(parse_output),
        unspecialized: arguments.unspecialized,
        ..Options::default()
    };
    let file = arguments.at.display().to_string();
    let batches =
        eval_batches(&setup, &library, &samples, &options, &mut Assets::default()).map_err(|mut problems| {
            for problem in
                problems.iter_mut().filter(|p| p.place.json_path.as_ref().is_some_and(|path| path.starts_with('[')))
            {
                problem.place.file = Some(file.clone());
            }
            problems
        })?;
    let one = |error: crate::render::RenderError| vec![Diagnostic::from(error)];
    let mut renderer = Renderer::new(block_on(Gpu::headless()).map_err(one)?);
    let mut answers = vec![Json::Null; samples.len()];
    for batch in &batches {
        let values = block_on(renderer.evaluate(batch)).map_err(one)?;
        for (&index, value) in batch.indices.iter().zip(values) {
            answers[index] = json!({ "value": numbers_of(&batch.shader.root_type, value) });
        }
    }
    output.result(&json_lines(&answers));
    Ok(())
}

/// A list with one answer a line.
fn json_lines(answers: &[Json]) -> String {
    let lines: Vec<String> = answers.iter().map(|answer| format!("  {answer}")).collect();
    if lines.is_empty() { "[]".to_owned() } else { format!("[\n{}\n]", lines.join(",\n")) }
}

/// As many of the four numbers as the type has; an angle in radians.
fn numbers_of(ty: &Type, value: [f32; 4]) -> Vec<Json> {
    // An f32 goes through its shortest decimal, so that what is printed is what was computed and no more.
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

fn set_tier(look: &mut Look, tier: Tier) {
    let definitions = look.definitions.values_mut().map(|definition| &mut definition.graph);
    for graph in std::iter::once(&mut look.graph).chain(definitions) {
        graph.nodes.values_mut().for_each(|node| node.tier = tier);
    }
}

/// `group/node.port`; the port may be left out for a node's first output.
fn parse_output(text: &str) -> (NodePath, PortName) {
    let (node, port) = text.rsplit_once('.').unwrap_or((text, ""));
    (NodePath::parse(node), PortName::from(port))
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct SampleFile {
    normal: Option<[f64; 3]>,
    tangent: Option<[f64; 3]>,
    view: Option<[f64; 3]>,
    position: Option<[f64; 3]>,
    camera: Option<[[f64; 3]; 3]>,
    uv: Option<[f64; 2]>,
    kappa: Option<Number>,
    color: Option<Vec<f64>>,
    time: Option<f64>,
    frame: Option<Rotation>,
    lights: indexmap::IndexMap<String, LightFile>,
    values: indexmap::IndexMap<PortName, Value>,
}

/// A number, or what JSON has no number for.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
enum Number {
    Finite(f64),
    Word(String),
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct LightFile {
    direction: Option<[f64; 3]>,
    position: Option<[f64; 3]>,
    color: Option<[f64; 3]>,
    intensity: Option<f64>,
}

#[derive(Debug, Deserialize)]
#[serde(untagged)]
enum Rotation {
    Matrix([[f64; 3]; 3]),
    Quaternion([f64; 4]),
}

fn read_samples(path: &Path) -> Result<Vec<EvalSample>, Vec<Diagnostic>> {
    let (name, text) = if path == Path::new("-") {
        let text = std::io::read_to_string(std::io::stdin().lock());
        let problem = |error: std::io::Error| {
            vec![Diagnostic::error("unreadable", format!("standard input cannot be read: {error}"))]
        };
        ("standard input".to_owned(), text.map_err(problem)?)
    } else {
        (path.display().to_string(), read_text(path).map_err(|problem| vec![*problem])?)
    };
    let items: Vec<Json> = serde_json::from_str(&text).map_err(|error| {
        let at = LineColumn { line: error.line().max(1) as u32, column: error.column().max(1) as u32 };
        let problem = Diagnostic::error("bad-samples", format!("this is no list of samples: {error}"))
            .in_file(name.clone())
            .at(at);
        vec![problem.hint(r#"write [{"normal": [0, 0, 1]}, ...]"#)]
    })?;
    let mut samples = Vec::with_capacity(items.len());
    let mut problems = Vec::new();
    for (index, item) in items.into_iter().enumerate() {
        let sample = serde_json::from_value::<SampleFile>(item).map_err(|error| error.to_string()).and_then(sample);
        match sample {
            Ok(sample) => samples.push(sample),
            Err(message) => problems.push(
                Diagnostic::error("bad-sample", message)
                    .in_file(name.clone())
                    .json_path(format!("[{index}]"))
                    .hint("`chiaro eval --help` lists the fields"),
            ),
        }
    }
    if problems.is_empty() { Ok(samples) } else { Err(problems) }
}

fn sample(file: SampleFile) -> Result<EvalSample, String> {
    let mut sample = EvalSample { values: file.values, ..EvalSample::default() };
    let vector = |v: Option<[f64; 3]>, otherwise: DVec3| v.map_or(otherwise, DVec3::from);
    sample.normal = vector(file.normal, sample.normal);
    sample.tangent = file.tangent.map(DVec3::from);
    sample.view = vector(file.view, sample.view);
    sample.position = vector(file.position, sample.position);
    if let Some(rows) = file.camera {
        sample.camera = DMat3::from_cols_array_2d(&rows).transpose();
    }
    sample.uv = file.uv.map_or(sample.uv, DVec2::from);
    sample.kappa = match file.kappa {
        None => 0.0,
        Some(Number::Finite(x)) => x,
        Some(Number::Word(word)) => word.parse().map_err(|_| format!("`kappa` cannot be `{word}`"))?,
    };
    if let Some(color) = file.color {
        sample.vertex_color = match color.as_slice() {
            [r, g, b] => [*r, *g, *b, 1.0],
            [r, g, b, a] => [*r, *g, *b, *a],
            other => return Err(format!("`color` has {} numbers; write 3 or 4", other.len())),
        };
    }
    sample.time = file.time.unwrap_or(0.0);
    sample.frame = match file.frame {
        None => DQuat::IDENTITY,
        Some(Rotation::Quaternion(q)) => {
            let q = DQuat::from_array(q);
            if q.length_squared() < 1e-18 {
                return Err("`frame` is a quaternion of length 0".to_owned());
            }
            q.normalize()
        }
        Some(Rotation::Matrix(rows)) => {
            let matrix = DMat3::from_cols_array_2d(&rows).transpose();
            if ((matrix * matrix.transpose()) - DMat3::IDENTITY).to_cols_array().iter().any(|x| x.abs() > 1e-3)
                || matrix.determinant() < 0.0
            {
                return Err("`frame` is no rotation: its rows must be of length 1 and at right angles".to_owned());
            }
            DQuat::from_mat3(&matrix).normalize()
        }
    };
    for (id, light) in file.lights {
        sample.lights.insert(
            id.into(),
            LightOverride {
                direction: light.direction.map(DVec3::from),
                position: light.position.map(DVec3::from),
                color: light.color.map(DVec3::from),
                intensity: light.intensity,
            },
        );
    }
    Ok(sample)
}
