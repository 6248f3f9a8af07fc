//! `chiaro fit`: a look from strokes painted on its picture.

use std::path::{Path, PathBuf};

use clap::ValueEnum;
use serde_json::json;

use super::open::{check_nodes_folder, library_for, not_a_look};
use super::output::Output;
use super::render::{adjust_camera, check_png, parse_time, turn_lights};
use super::target::{OutputPath, check_document, outputs};
use crate::diag::Diagnostic;
use crate::document::{Document, Look};
use crate::files::{Disk, OutputKind, Outputs};
use crate::frame::{Assets, DEFAULT_MESH, Setup, SetupLook, default_setup, image_bytes, open};
use chiaro_laboratory::fit::{
    FitOptions, FitReport, FitTarget, FittedLook, KeptParts, fit_layers, fit_local, fit_look,
    picture_of,
};

const EXAMPLES: &str = "\
Examples:
  chiaro fit look.json --target painted.png -o fitted.json
  chiaro fit look.json --target painted.png --keep base,lights -o fitted.json
  chiaro fit look.json --target strokes.png --keep-rest 50 -o fitted.json
  chiaro fit look.json --target strokes.png --local
  chiaro fit --layers 2 --target painted.png --mesh bunny.obj -o new.json
  chiaro fit look.json --target painted.png --camera orbit=30,15 --dry-run --json

The target is painted over the picture that `chiaro render` makes, at the same size, with the same \
mesh and camera. Where it is
transparent nothing is wished; alpha is how much a pixel counts. Lights, profiles and colors are \
turned until the look shows
what was painted; its nodes and wires stay. That is for a file, which mostly wishes for a whole \
picture; --local is for a few strokes, and what the window does first. --keep and --keep-rest are \
Keep and Keep the rest of the window's Paint light. With --layers it gets light layers in their \
place: as many as help, at most so many.
Pixels at the outline of an object are left out, for a smooth picture has mixed them with what is \
behind.";

/// Arguments of `chiaro fit`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// A look; with --layers it may be left out
    #[arg(required_unless_present = "layers")]
    look: Option<PathBuf>,
    /// Painted picture: a PNG, transparent where nothing is wished
    #[arg(short, long)]
    target: PathBuf,
    /// A mesh (OBJ, PLY, STL, glTF, GLB) or an own shape (shape:creature)
    #[arg(short, long)]
    mesh: Option<String>,
    /// Begins from nothing: up to so many light layers over a base, from 1 to 7
    #[arg(long, value_parser = clap::value_parser!(u8).range(1..=7))]
    layers: Option<u8>,
    /// Lays layers over the look, with lights of their own, where it was painted: all else stays
    #[arg(long, conflicts_with_all = ["layers", "keep", "keep_rest", "starts"], requires = "look")]
    local: bool,
    /// Parts of the look that stay as they are, separated by commas
    #[arg(long, value_enum, value_delimiter = ',', conflicts_with = "layers")]
    keep: Vec<KeepArgument>,
    /// Share to which unpainted parts stay as they are, in percent: at 0 only painted ones count
    /// (the window begins with 50)
    #[arg(
        long, value_name = "PERCENT", default_value_t = 0,
        value_parser = clap::value_parser!(u8).range(0..=100)
    )]
    keep_rest: u8,
    /// From how many beginnings a look is turned, its own first, from 1 to 100
    #[arg(
        long, default_value_t = 6, value_parser = clap::value_parser!(u32).range(1..=100),
        conflicts_with = "layers"
    )]
    starts: u32,
    /// Camera of the picture, as `chiaro render` takes it
    #[arg(short, long)]
    camera: Option<String>,
    /// Turn of all lights for the picture, as `chiaro render` turns them
    #[arg(long, allow_hyphen_values = true, value_name = "YAW[,PITCH]")]
    turn_lights: Option<String>,
    /// The time in seconds
    #[arg(long, default_value_t = 0.0, value_parser = parse_time, allow_negative_numbers = true)]
    time: f64,
    /// File for the fitted look, in place of the look itself
    #[arg(short, long, required_unless_present_any = ["look", "dry_run"])]
    output: Option<OutputPath>,
    /// Replace another look that is there, or a picture that Chiaro did not make
    #[arg(long)]
    force: bool,
    /// A PNG of where it misses: black where it does not, over red to white where by a tenth and
    /// more
    #[arg(long)]
    misses: Option<OutputPath>,
    /// Tell what would come of it, and write no look
    #[arg(long)]
    dry_run: bool,
    /// A folder of a project's own nodes; `nodes/` beside the look is found without it
    #[arg(long)]
    nodes: Option<PathBuf>,
    /// Print the report as JSON
    #[arg(long)]
    json: bool,
}

/// Part of a look that `--keep` leaves as it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum KeepArgument {
    /// Directions of lights
    Lights,
    /// Offsets, fall-offs and cut-offs
    Profiles,
    /// All colors
    Colors,
    /// The color of the base
    Base,
}

pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let one = |problem: Diagnostic| vec![problem];
    check_nodes_folder(arguments.nodes.as_deref())?;
    let mut outputs = planned(arguments).map_err(one)?;
    let beside = arguments.look.as_deref().unwrap_or(Path::new(""));
    let library = library_for(beside, arguments.nodes.as_deref());
    output.diagnostics(&library.problems);
    let mut setup = setup(arguments, output)?;
    if let Some(text) = &arguments.camera {
        adjust_camera(&mut setup.scene, text).map_err(one)?;
    }
    if let Some(text) = &arguments.turn_lights {
        turn_lights(&mut setup.scene, text).map_err(one)?;
    }
    let named = arguments.target.display().to_string();
    let bytes = image_bytes(&Disk, Path::new(""), &named).map_err(|problem| {
        one(problem.hint("--target names the painted picture: check its spelling and its folder"))
    })?;
    let target = FitTarget::from_png(&bytes).map_err(|problem| one(problem.in_file(named)))?;
    let keeps = |kept| arguments.keep.contains(&kept);
    let keep = KeptParts {
        lights: keeps(KeepArgument::Lights),
        profiles: keeps(KeepArgument::Profiles),
        colors: keeps(KeepArgument::Colors),
        base: keeps(KeepArgument::Base),
    };
    let options = FitOptions {
        time: arguments.time,
        keep,
        keep_rest: f64::from(arguments.keep_rest) / 100.0,
        starts: arguments.starts as usize,
        ..FitOptions::default()
    };
    let fitted = output.watch("fitting", |progress| match arguments.layers {
        Some(layers) => fit_layers(&setup, 0, &library, &target, layers.into(), &options, progress),
        None if arguments.local => fit_local(&setup, 0, &library, &target, &options, progress),
        None => fit_look(&setup, 0, &library, &target, &options, progress),
    })?;
    output.diagnostics(&fitted.report.warnings(arguments.layers.is_some()));
    if let Some(path) = &arguments.misses {
        let png = picture_of(target.size, &fitted.misses).to_png().map_err(one)?;
        outputs.add(path.as_ref(), OutputKind::PICTURE, &png).map_err(one)?;
    }
    let written =
        (!arguments.dry_run).then(|| add(arguments, &fitted, &mut outputs)).transpose()?;
    outputs.commit().map_err(one)?;
    if arguments.json {
        let file = written.map(|path| path.display().to_string());
        output.json(&json!({ "file": file, "report": fitted.report }));
    } else {
        output.result(&told(&fitted.report));
        if let Some(path) = written {
            output.message(&format!("{}: written", path.display()));
        }
    }
    Ok(())
}

/// The look on its mesh; without a look, a gray one.
fn setup(arguments: &Arguments, output: &Output) -> Result<Setup, Vec<Diagnostic>> {
    let mut assets = Assets::default();
    let mesh = arguments.mesh.as_deref();
    let Some(path) = &arguments.look else {
        let loaded = Look::read(NOTHING, "nothing");
        let Some(mut look) = loaded.value else { return Err(loaded.diagnostics) };
        look.name = "Painted".to_owned();
        let look = SetupLook { look, source: loaded.source.into(), folder: PathBuf::new() };
        let (setup, warnings) =
            default_setup(look, mesh.unwrap_or(DEFAULT_MESH), &mut assets)?.into_parts();
        output.diagnostics(&warnings);
        return Ok(setup);
    };
    if let Document::Scene(scene) = Document::load(&crate::files::Disk, path) {
        return Err(vec![not_a_look(path, scene.value.as_ref())]);
    }
    let (setup, warnings) = open(path, mesh, &mut assets)?.into_parts();
    output.diagnostics(&warnings);
    Ok(setup)
}

/// A look with a base and no layers.
const NOTHING: &str = r##"{"chiaro": "look", "version": 1,
    "nodes": [{"id": "base", "kind": "base", "values": {"color": "#808080"}},
        {"id": "output", "kind": "output"}],
    "wires": [{"from": "base.below", "to": "output.color"}]}"##;

/// The planned outputs, refused if one would replace an input or another document. The look itself
/// is changed, unless `--output` names a file.
fn planned(arguments: &Arguments) -> Result<Outputs, Diagnostic> {
    let read = [
        Some(arguments.target.as_path()),
        arguments.mesh.as_deref().map(Path::new),
        arguments.nodes.as_deref(),
    ];
    let mut outputs = outputs(arguments.force, read.into_iter().flatten());
    arguments.look.iter().for_each(|look| outputs.changes(look));
    if let Some(path) = arguments.misses.as_ref().map(AsRef::as_ref) {
        check_png(path)?;
        outputs.check(path, OutputKind::PICTURE)?;
    }
    check_document(&outputs, arguments.output.as_ref().filter(|_| !arguments.dry_run))?;
    Ok(outputs)
}

fn add(
    arguments: &Arguments,
    fitted: &FittedLook,
    outputs: &mut Outputs,
) -> Result<PathBuf, Vec<Diagnostic>> {
    let output = arguments.output.as_ref().map(|path| path.as_ref().to_path_buf());
    let path = output.or_else(|| arguments.look.clone()).unwrap_or_default();
    let text = match &arguments.look {
        Some(look) => fitted.look.to_text_like(&Look::load(&crate::files::Disk, look).source),
        None => fitted.look.to_text(),
    };
    outputs.add(&path, OutputKind::DOCUMENT, text.as_bytes()).map_err(|problem| vec![problem])?;
    Ok(path)
}

/// The report for people, with errors in steps of an eight-bit channel.
fn told(report: &FitReport) -> String {
    let steps = |error: f64| format!("{:.2}/255", 255.0 * error);
    let mut lines = vec![format!(
        "RMS error {}, before {}, over {} of {} painted pixels",
        steps(report.after),
        steps(report.before),
        report.compared,
        report.painted
    )];
    lines.extend(report.rest.map(|rest| format!("  the rest moved by {}", steps(rest))));
    lines.extend(report.changed.iter().map(|change| {
        let from =
            if change.from.is_empty() { String::new() } else { format!(", was {}", change.from) };
        format!("  {} {}: {}{from}", change.what, change.place, change.to)
    }));
    if report.changed.is_empty() {
        lines.push("  nothing was turned: it is as near as it can be".to_owned());
    }
    for missed in report.worst.iter().take(1) {
        let [x, y] = missed.pixel;
        let hex = |rgb: [f64; 3]| {
            let [r, g, b] = rgb.map(|x| (x.clamp(0.0, 1.0) * 255.0).round() as u8);
            format!("#{r:02x}{g:02x}{b:02x}")
        };
        let (shown, wished) = (hex(missed.shown), hex(missed.wished));
        lines.push(format!("  farthest off: {x},{y} shows {shown}, painted {wished}"));
    }
    lines.join("\n")
}
