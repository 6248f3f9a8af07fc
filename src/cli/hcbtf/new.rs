//! `chiaro hcbtf new`: a new file to begin with.

use std::sync::Arc;

use super::{GRID_HELP, GridText, check_free, save, with_ending};
use crate::diag::Diagnostic;
use crate::document::{Address, Grid, Hcbtf, Rule, Tile, read_hex};
use crate::files::Outputs;
use crate::output::Output;
use crate::target::OutputPath;

/// Arguments of `chiaro hcbtf new`.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The name of the file; `.hcbtf` is added where it is missing
    name: OutputPath,
    #[arg(long, help = format!("Texels, lights and views, as 32x32,6x10,6x10 [default: \
                                {GRID_HELP}]"))]
    grid: Option<GridText>,
    /// A color that the sample at the normal is painted with, and that is copied everywhere and
    /// darkened as the light sinks
    #[arg(long, value_name = "#RRGGBB")]
    color: Option<String>,
    /// The tile does not repeat
    #[arg(long)]
    no_tiling: bool,
    /// Replace a file that is there
    #[arg(long)]
    force: bool,
}

pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let path = with_ending(arguments.name.as_ref());
    let color = arguments.color.as_deref().map(color).transpose()?;
    let outputs = Outputs::new(arguments.force);
    check_free(&path, &outputs)?;
    let mut hcbtf = Hcbtf::new(arguments.grid.map_or(Grid::THESIS, |grid| grid.0));
    hcbtf.is_tiling = !arguments.no_tiling;
    if let Some(color) = color {
        let from = Address::default();
        hcbtf.painted.insert(from, Arc::new(Tile::filled(hcbtf.grid.size, color)));
        hcbtf.rules = vec![Rule::Copy { from }, Rule::Lambert { shadow: [0; 3], amount: 1.0 }];
    }
    save(&hcbtf, &path, outputs, output)
}

fn color(text: &str) -> Result<[u8; 4], Vec<Diagnostic>> {
    let wrong = || {
        let problem = Diagnostic::error("bad-argument", format!("--color cannot be `{text}`"));
        vec![problem.hint("write #rrggbb or #rrggbbaa, in quotes")]
    };
    let channels = read_hex(text).ok_or_else(wrong)?;
    Ok(channels.map(|channel| (255.0 * channel).round() as u8))
}
