//! `chiaro wedge`: one picture for each combination of values, on a sheet with labels.

mod inputs;
mod target;
mod values;

use std::path::{Path, PathBuf};

use serde_json::{Value as Json, json};

use self::target::VariedTarget;
use self::values::Variation;
use super::format::PictureFormat;
use super::{ExecutorChoice, Stage, check_png, executor};
use crate::diag::Diagnostic;
use crate::document::Value;
use crate::files::{self, OutputKind};
use crate::film::sheet::{self, SheetCell, SheetLabel, columns_for, scaled};
use crate::frame::{Executor, PlanOptions, PlanStyle};
use crate::output::Output;
use crate::target::{outputs, reads_all};

const EXAMPLES: &str = "\
Examples:
  chiaro wedge look.json --vary key.intensity=0.5..2/4 -o out/wedge.png
  chiaro wedge scene.json --vary key.intensity=0.5..2/4 --vary rim.color=#8af,#fa8 -o out/wedge.png
  chiaro wedge look.json --vary lit.offset=0..1.2/5 --frames 1,24 -o out/wedge.png --size 480x270

Something that varies is a field of a light (key.intensity), an input of a node (lit.offset), in a
group by the nodes that lead to it (cheek/rim.offset: this use of the group alone), an exposed
parameter (width), or that of one object (hero.width), the master of a group of lights
(light_groups.dusk.exposure) or a field of the camera (camera.fov). It stands over what a shot says,
keyed or not. Its values are a list, 0.5,1,2, or so many from one to another, 0.5..2/4; colors as
#8af or #88aaff.
Every combination is a cell. The sheet's pictures lie in a folder of its name, and their values in a
JSON beside it.";

/// Greatest number of cells without more being asked for.
const MAX_CELLS: usize = 480;

/// Values of cells, beside their sheet.
const VALUES: OutputKind<'static> =
    OutputKind { name: "the values of a wedge", is_own: &is_wedge, has_seal: false };

/// Arguments of `chiaro wedge`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
#[group(skip)]
pub(crate) struct Arguments {
    #[command(flatten)]
    render: super::Arguments,
    /// Variation, a name and its values: key.intensity=0.5..2/4, rim.color=#8af,#fa8; the
    /// first one varies slowest
    #[arg(long, required = true, value_parser = values::parse, allow_hyphen_values = true)]
    vary: Vec<Variation>,
    /// Greatest number of cells
    #[arg(long, default_value_t = MAX_CELLS)]
    cells: usize,
    /// Width of a picture on the sheet, in pixels
    #[arg(long, default_value_t = 320, value_parser = clap::value_parser!(u32).range(16..=8192))]
    width: u32,
    /// Number of pictures in a row [default: the values of what varies last]
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=1000))]
    columns: Option<u32>,
}

/// A combination of values, at a frame.
struct Cell<'a> {
    values: Vec<(&'a str, &'a Value)>,
    frame: Option<i32>,
    file: PathBuf,
}

impl Cell<'_> {
    fn labels(&self) -> Vec<SheetLabel> {
        let varied = self.values.iter();
        let varied = varied
            .map(|(target, value)| SheetLabel::Value((*target).to_owned(), values::text(value)));
        let frame = self.frame.map(|frame| SheetLabel::Text(format!("frame {frame}")));
        varied.chain(frame).collect()
    }

    fn json(&self, folder: &Path) -> Json {
        let file = self.file.strip_prefix(folder).unwrap_or(&self.file);
        let values = self.values.iter().map(|(target, value)| ((*target).to_owned(), json!(value)));
        let values: serde_json::Map<String, Json> = values.collect();
        let mut told = json!({"picture": file.display().to_string(), "values": values});
        if let Some(frame) = self.frame {
            told["frame"] = json!(frame);
        }
        told
    }
}

pub(crate) async fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let one = |problem: Diagnostic| vec![problem];
    let render = &arguments.render;
    crate::open::check_nodes_folder(render.nodes.as_deref())?;
    if render.list_views {
        return render.view.list(output, render.json).map_err(one);
    }
    let Some(target) = &render.output else {
        let problem = Diagnostic::error("bad-argument", "a wedge draws, and lists nothing");
        return Err(vec![problem.hint("ask `chiaro render --list-aovs` for the list")]);
    };
    let target = target.as_ref();
    check_png(target).map_err(one)?;
    super::layers::check(render, PictureFormat::Png, target).map_err(one)?;
    let view = render.view.open().map_err(one)?;
    let folder = target.with_extension("");
    let cells = cells(arguments, &folder).map_err(one)?;
    let read = [
        Some(render.document.as_path()),
        render.mesh.as_deref().map(Path::new),
        render.nodes.as_deref(),
    ];
    let mut outputs = outputs(render.force, read.into_iter().flatten());
    let json_file = target.with_extension("json");
    let check = |outputs: &files::Outputs| {
        outputs.check(target, OutputKind::PICTURE)?;
        outputs.check(&json_file, VALUES)?;
        cells.iter().try_for_each(|cell| outputs.check(&cell.file, OutputKind::PICTURE))
    };
    check(&outputs).map_err(one)?;
    let mut warnings = Vec::new();
    let mut stage = render.open(&mut warnings)?;
    let targets = arguments.vary.iter().map(|varied| {
        VariedTarget::find(&varied.target, &stage.setup, &stage.library)
            .and_then(|target| target.check_all(&varied.values, &stage.setup).map(|()| target))
    });
    let targets: Vec<VariedTarget> = targets
        .collect::<Result<_, Diagnostic>>()
        .map_err(|problem| vec![problem.in_file(render.document.display().to_string())])?;
    reads_all(&mut outputs, &stage.setup, &stage.planner.assets);
    check(&outputs).map_err(one)?;
    warnings.extend(super::warning_of_view(&stage.setup, view.as_ref()));
    warnings.extend(targets.iter().filter_map(|target| target.note(&stage.setup)));
    super::tell_before_series(render.strict, warnings, output)?;
    let mut executor = executor(render.on, output).await.map_err(one)?;
    files::make_folder(&folder).map_err(|problem| vec![*problem])?;
    let mut drawn = Vec::with_capacity(cells.len());
    for (at, cell) in cells.iter().enumerate() {
        let picture = draw(arguments, &mut stage, &targets, cell, executor.as_mut()).await?;
        let picture = match &view {
            Some(view) => view.show(&picture),
            None => picture,
        };
        let bytes = picture.to_png().map_err(one)?;
        outputs.write(&cell.file, OutputKind::PICTURE, &bytes).map_err(one)?;
        let labels = cell.labels();
        let told: Vec<String> = labels.iter().map(ToString::to_string).collect();
        output.message(&format!("{} of {}: {}", at + 1, cells.len(), told.join(", ")));
        drawn.push(SheetCell { picture: over(&picture, arguments.width), labels });
    }
    let size = drawn.first().map_or([1, 1], |cell| cell.picture.size);
    let columns = columns(arguments, drawn.len(), size);
    let title = render.document.file_stem().unwrap_or_default().to_string_lossy();
    let (sheet, places) = sheet::draw_with_places(&title, &drawn, columns).map_err(one)?;
    let parent = target.parent().unwrap_or(Path::new(""));
    let told = cells.iter().zip(&places).map(|(cell, place)| {
        let mut told = cell.json(parent);
        told["place"] = json!(place);
        told
    });
    let told = json!({
        "chiaro": "wedge", "document": render.document.display().to_string(),
        "cells": told.collect::<Vec<_>>(),
    });
    let told = format!("{told:#}\n");
    outputs.add(target, OutputKind::PICTURE, &sheet.to_png().map_err(one)?).map_err(one)?;
    outputs.add(&json_file, VALUES, told.as_bytes()).map_err(one)?;
    outputs.commit().map_err(one)?;
    let [width, height] = sheet.size;
    let (target, count) = (target.display(), cells.len());
    output.message(&format!("{target}: {width}x{height}, {count} cells, on {}", executor.name()));
    Ok(())
}

/// Every combination of values and frames.
fn cells<'a>(arguments: &'a Arguments, folder: &Path) -> Result<Vec<Cell<'a>>, Diagnostic> {
    let frames: Vec<Option<i32>> = match &arguments.render.frames {
        Some(list) => list.frames().iter().copied().map(Some).collect(),
        None => vec![None],
    };
    let lengths = arguments.vary.iter().map(|varied| varied.values.len()).chain([frames.len()]);
    let count = lengths.clone().try_fold(1_usize, usize::checked_mul);
    let count = count.filter(|count| *count <= arguments.cells).ok_or_else(|| {
        let factors: Vec<String> = lengths.map(|length| length.to_string()).collect();
        let factors = factors.join(" x ");
        let message = format!("{factors} are more than {} cells", arguments.cells);
        Diagnostic::error("bad-argument", message)
            .hint("vary less at once, or raise the number: --cells 2000")
    })?;
    for (at, varied) in arguments.vary.iter().enumerate() {
        if arguments.vary[..at].iter().any(|other| other.target == varied.target) {
            let message = format!("`{}` is varied twice", varied.target);
            return Err(Diagnostic::error("bad-argument", message)
                .hint("write all of its values in one --vary"));
        }
    }
    let digits = count.to_string().len().max(3);
    let cell = |number: usize| {
        // The last thing that varies, and then the frame, changes from cell to cell.
        let frame = frames[number % frames.len()];
        let mut rest = number / frames.len();
        let mut values: Vec<(&str, &Value)> = Vec::with_capacity(arguments.vary.len());
        for varied in arguments.vary.iter().rev() {
            values.push((&varied.target, &varied.values[rest % varied.values.len()]));
            rest /= varied.values.len();
        }
        values.reverse();
        let file = folder.join(format!("{:0digits$}.png", number + 1));
        Cell { values, frame, file }
    };
    Ok((0..count).map(cell).collect())
}

/// The columns of a sheet: the values of what varies last, where they make rows of a usual width.
fn columns(arguments: &Arguments, cells: usize, size: [u32; 2]) -> usize {
    let frames = arguments.render.frames.as_ref().map_or(1, |list| list.frames().len());
    let last = arguments.vary.last().map_or(1, |varied| varied.values.len());
    let natural = match (frames, arguments.vary.len()) {
        (2.., _) => frames,
        (_, 2..) => last,
        _ => 0,
    };
    match arguments.columns {
        Some(columns) => columns as usize,
        None if (2..=12).contains(&natural) => natural,
        None => columns_for(cells, size),
    }
}

async fn draw(
    arguments: &Arguments,
    stage: &mut Stage,
    targets: &[VariedTarget],
    cell: &Cell<'_>,
    executor: &mut dyn Executor,
) -> Result<crate::frame::Picture, Vec<Diagnostic>> {
    let mut setup = stage.setup.clone();
    for (target, (_, value)) in targets.iter().zip(&cell.values) {
        target.set(&mut setup, &stage.library, value);
    }
    let rate = arguments.render.rate_of(&stage.setup);
    let time = cell.frame.map_or(stage.options.time, |frame| rate.time(frame));
    let options = PlanOptions { time, ..stage.options.clone() };
    // One planner serves all cells: it compiles again what a value is folded into, and nothing
    // else. A look as it is written, with all values live, is known to a planner by its graph
    // alone, and keeps the values of the lights with which it was first seen: there each cell has
    // a planner of its own.
    let plan = if arguments.render.on == Some(ExecutorChoice::Reference) {
        let mut planner = PlanStyle::AsWritten.planner(stage.planner.assets.clone());
        planner.plan(&setup, &stage.library, &stage.live, &options)?
    } else {
        stage.planner.plan(&setup, &stage.library, &stage.live, &options)?
    };
    let plan = plan.tell(&mut Vec::new());
    let progress = crate::progress::Progress::default();
    executor.picture(&plan, &progress).await.map_err(|problem| vec![problem])
}

/// A picture for a sheet: opaque, over the color of an empty scene, and small.
fn over(picture: &crate::frame::Picture, width: u32) -> crate::frame::Picture {
    let behind = crate::document::Scene::default().backdrop.unwrap_or([0.0, 0.0, 0.0, 1.0]);
    let pixel = |[r, g, b, a]: &[f32; 4]| {
        let over = |x: f32, behind: f64| x * a + behind as f32 * (1.0 - a);
        [over(*r, behind[0]), over(*g, behind[1]), over(*b, behind[2]), 1.0]
    };
    let rgba = picture.rgba.iter().map(pixel).collect();
    scaled(&crate::frame::Picture { size: picture.size, rgba }, width)
}

fn is_wedge(bytes: &[u8]) -> bool {
    let json: Option<Json> = serde_json::from_slice(bytes).ok();
    json.is_some_and(|json| json["chiaro"] == "wedge")
}
