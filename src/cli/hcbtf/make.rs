//! `chiaro hcbtf synthesize` and `bake`: new tiles from a painted one, and a look baked to an
//! HCBTF.

use std::path::PathBuf;

use super::super::open::{check_nodes_folder, library_for, open_look};
use super::super::render::Size;
use super::{GRID_HELP, GridText, check_free, open, save, tell_painted, with_ending};
use crate::diag::Diagnostic;
use crate::document::Grid;
use crate::frame::{Assets, MAX_TILE_SAMPLES, moving_light, tile_assets};
use crate::output::Output;
use crate::reference::{BakedLook, TILE_SAMPLES, bake_look_sampled};
use crate::target::{OutputPath, outputs};
use chiaro_scene::hcbtf::{Synthesis, synthesize};

/// Arguments of `chiaro hcbtf synthesize`.
#[derive(Debug, clap::Args)]
pub(super) struct SynthesizeArguments {
    /// An .hcbtf file
    file: PathBuf,
    /// The .hcbtf file to write
    #[arg(short, long)]
    output: OutputPath,
    /// Width and height of the new tile in texels [default: as the old one]
    #[arg(long)]
    size: Option<Size>,
    /// Another number lays other patches
    #[arg(long, default_value_t = 1)]
    seed: u32,
    /// Texels along a patch's side: large ones keep large forms whole [default: half of the old
    /// tile's]
    #[arg(long)]
    patch: Option<u32>,
    /// Replace a file that is there
    #[arg(long)]
    force: bool,
}

pub(super) fn synthesized(
    arguments: &SynthesizeArguments,
    output: &Output,
) -> Result<(), Vec<Diagnostic>> {
    let path = with_ending(arguments.output.as_ref());
    let outputs = outputs(arguments.force, [&arguments.file]);
    check_free(&path, &outputs)?;
    let hcbtf = open(&arguments.file, output)?;
    let size = arguments.size.map_or(hcbtf.grid.size, |size| size.0);
    let how = Synthesis { size, seed: arguments.seed, patch: arguments.patch };
    let named = arguments.file.display().to_string();
    let made = output.watch("laying", |progress| synthesize(&hcbtf, &how, progress));
    let made = made.map_err(|problem| vec![problem.in_file(named)])?;
    save(&made, &path, outputs, output)?;
    tell_painted(&made, output);
    Ok(())
}

/// Arguments of `chiaro hcbtf bake`.
#[derive(Debug, clap::Args)]
pub(super) struct BakeArguments {
    /// A look
    look: PathBuf,
    /// The .hcbtf file to write
    #[arg(short, long)]
    output: OutputPath,
    #[arg(long, help = format!("Texels, lights and views, as 32x32,6x10,6x10 [default: \
                                {GRID_HELP}]"))]
    grid: Option<GridText>,
    /// The light that goes around the tile [default: the first directional one]; the others stay
    #[arg(long)]
    light: Option<String>,
    /// Samples of a texel: 1, 2, 4, 8, 16, 32 or 64; more for finer edges, and as many times as
    /// slow
    #[arg(long, default_value_t = TILE_SAMPLES, value_parser = parse_samples)]
    samples: u32,
    /// A folder of a project's own nodes; `nodes/` beside the look is found without it
    #[arg(long)]
    nodes: Option<PathBuf>,
    /// Replace a file that is there
    #[arg(long)]
    force: bool,
}

pub(super) fn baked(arguments: &BakeArguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let path = with_ending(arguments.output.as_ref());
    let outputs = outputs(
        arguments.force,
        [Some(&arguments.look), arguments.nodes.as_ref()].into_iter().flatten(),
    );
    check_free(&path, &outputs)?;
    check_nodes_folder(arguments.nodes.as_deref())?;
    let library = library_for(&arguments.look, arguments.nodes.as_deref());
    output.diagnostics(&library.problems);
    let setup = open_look(&arguments.look, output)?;
    let named = arguments.look.display().to_string();
    let light = moving_light(&setup, arguments.light.as_deref())
        .map_err(|problem| vec![problem.in_file(named)])?;
    let grid = arguments.grid.map_or(Grid::THESIS, |grid| grid.0);
    let assets = output.watch("filling what it shows", |progress| {
        tile_assets(&setup, &library, &light, Assets::default(), progress)
    })?;
    let BakedLook { hcbtf, halves_off } = output.watch("baking", |progress| {
        bake_look_sampled(&setup, &library, grid, &light, &assets, arguments.samples, progress)
    })?;
    save(&hcbtf, &path, outputs, output)?;
    tell_painted(&hcbtf, output);
    if let Some(off) = halves_off {
        let (samples, off) = (arguments.samples, 255.0 * off);
        output.message(&format!(
            "{samples} samples a texel; half of them would be off by {off:.2} of 255 (rms)"
        ));
    }
    Ok(())
}

fn parse_samples(text: &str) -> Result<u32, String> {
    let wrong = || format!("it is a power of 2 from 1 to {MAX_TILE_SAMPLES}");
    let is_good = |samples: &u32| samples.is_power_of_two() && *samples <= MAX_TILE_SAMPLES;
    text.parse().ok().filter(is_good).ok_or_else(wrong)
}
