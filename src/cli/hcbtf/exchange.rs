//! `chiaro hcbtf import` and `export`: sheets, folders of images, contact sheets.

use std::path::PathBuf;

use clap::ValueEnum;

use super::{GRID_HELP, GridText, check_free, filled, open, telling, with_ending};
use crate::cli::output::Output;
use crate::diag::Diagnostic;
use crate::document::{Grid, Storage, write_atomic};
use crate::hcbtf::{Which, exchange, write};

/// How samples lie in other programs' files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Form {
    /// The thesis's flattened texture, with padding rows and copies at the normal
    Sheet,
    /// A folder of images, one a sample: l2.3_v1.4.png, or numbered in the grid's order
    Folder,
    /// One picture: views across, lights down
    Contact,
    /// The texture that shaders look up, as KTX2, filled, with smaller levels for surfaces that are far away
    Ktx2,
}

impl From<Form> for exchange::Form {
    fn from(form: Form) -> Self {
        match form {
            Form::Sheet => Self::Sheet,
            Form::Folder => Self::Folder,
            Form::Contact => Self::Contact,
            Form::Ktx2 => Self::Ktx2,
        }
    }
}

/// What `chiaro hcbtf import` is given.
#[derive(Debug, clap::Args)]
pub(super) struct ImportArguments {
    /// A PNG, a KTX2 file or a folder
    from: PathBuf,
    /// The .hcbtf file to write
    #[arg(short, long)]
    output: PathBuf,
    /// What it is [default: a folder is a folder, a PNG a sheet, a KTX2 file the texture of shaders]
    #[arg(long = "as", value_enum)]
    form: Option<Form>,
    #[arg(long, help = format!("Texels, lights and views, as 32x32,6x10,6x10 [default: {GRID_HELP}]"))]
    grid: Option<GridText>,
    /// Contact sheets: texels between tiles
    #[arg(long, default_value_t = 0)]
    gap: u32,
    /// The tile does not repeat
    #[arg(long)]
    no_tiling: bool,
    /// Replace a file that is there
    #[arg(long)]
    force: bool,
}

pub(super) fn import(arguments: &ImportArguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let path = with_ending(&arguments.output);
    check_free(&path, arguments.force)?;
    let from = &arguments.from;
    let grid = arguments.grid.map_or(Grid::THESIS, |grid| grid.0);
    let form = arguments.form.map_or_else(|| exchange::Form::guessed(from), exchange::Form::from);
    let made = exchange::import(from, form, grid, arguments.gap, &telling("reading"));
    output.end_progress();
    let (mut hcbtf, notes) = made?;
    output.diagnostics(&notes);
    hcbtf.is_tiling = !arguments.no_tiling;
    let bytes = write(&hcbtf).map_err(|problem| vec![problem.in_file(path.display().to_string())])?;
    write_atomic(&path, &bytes).map_err(|problem| vec![*problem])?;
    output.result(&path.display().to_string());
    output.message(&format!("{} of {} samples are painted", hcbtf.painted.len(), hcbtf.grid.sample_count()));
    Ok(())
}

/// What `chiaro hcbtf export` is given.
#[derive(Debug, clap::Args)]
pub(super) struct ExportArguments {
    /// An .hcbtf file
    file: PathBuf,
    /// What to write
    #[arg(long, value_enum, default_value_t = Form::Sheet)]
    to: Form,
    /// The PNG, the KTX2 file or the folder; a folder is made where there is none
    #[arg(short, long)]
    output: PathBuf,
    /// Contact sheets: texels between tiles
    #[arg(long, default_value_t = 0)]
    gap: u32,
    /// KTX2: with every tile that differs once, and palettes, as small as it can be
    #[arg(long)]
    compact: bool,
    /// KTX2: with every tile that differs once, in compressed blocks of a byte a texel (BC7), which loses a little
    #[arg(long, conflicts_with = "compact")]
    blocks: bool,
    /// Folders and contact sheets: only what is painted, without what the rules fill
    #[arg(long)]
    painted: bool,
}

pub(super) fn export(arguments: &ExportArguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    if arguments.painted && matches!(arguments.to, Form::Sheet | Form::Ktx2) {
        let problem = Diagnostic::error("bad-argument", "--painted goes with --to folder and --to contact");
        return Err(vec![problem.hint("a sheet and a texture hold every sample")]);
    }
    let storage = match (arguments.compact, arguments.blocks) {
        (true, _) => Storage::Compact,
        (_, true) => Storage::Blocks,
        _ => Storage::Quick,
    };
    if storage != Storage::Quick && arguments.to != Form::Ktx2 {
        let message = format!("--{} goes with --to ktx2", storage.word());
        return Err(vec![Diagnostic::error("bad-argument", message)]);
    }
    let hcbtf = open(&arguments.file, output)?;
    let filled = filled(&hcbtf, &arguments.file, output)?;
    let which = if arguments.painted { Which::Painted } else { Which::All };
    let path = &arguments.output;
    let manner = exchange::Manner { which, gap: arguments.gap, storage };
    let told = exchange::export(&filled, arguments.to.into(), manner, path, &telling("writing"));
    if arguments.to == Form::Folder || storage == Storage::Blocks {
        output.end_progress();
    }
    let told = told?;
    output.result(&path.display().to_string());
    told.into_iter().for_each(|told| output.message(&told));
    Ok(())
}
