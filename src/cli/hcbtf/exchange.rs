//! `chiaro hcbtf import` and `export`: sheets, folders of images, contact sheets.

use std::path::{Path, PathBuf};

use clap::ValueEnum;

use super::{GRID_HELP, GridText, check_free, filled, open, with_ending};
use crate::cli::output::Output;
use crate::diag::Diagnostic;
use crate::document::{Grid, Storage, write_atomic};
use crate::hcbtf::{Filled, LayerOptions, Which, contact, folder, from_layers, ktx2, read_bytes, sheet, stored, write};

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
    let name = from.display().to_string();
    let grid = arguments.grid.map_or(Grid::THESIS, |grid| grid.0);
    let png = || read_bytes(from).map_err(|problem| vec![*problem]);
    let is_ktx2 = from.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("ktx2"));
    let guessed = match is_ktx2 {
        _ if from.is_dir() => Form::Folder,
        true => Form::Ktx2,
        false => Form::Sheet,
    };
    let (mut hcbtf, notes) = match arguments.form.unwrap_or(guessed) {
        Form::Folder => folder::load(from, grid)?,
        Form::Sheet => sheet::read(&png()?, grid, &name)?,
        Form::Contact => contact::read(&png()?, grid, arguments.gap, &name)?,
        Form::Ktx2 => {
            let layers = ktx2::read(&png()?, &name).map_err(|problem| vec![problem])?;
            (from_layers(&layers).map_err(|problem| vec![problem.in_file(name)])?, Vec::new())
        }
    };
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
    /// Folders and contact sheets: only what is painted, without what the rules fill
    #[arg(long)]
    painted: bool,
}

pub(super) fn export(arguments: &ExportArguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let alone = |problem: Box<Diagnostic>| vec![*problem];
    if arguments.painted && matches!(arguments.to, Form::Sheet | Form::Ktx2) {
        let problem = Diagnostic::error("bad-argument", "--painted goes with --to folder and --to contact");
        return Err(vec![problem.hint("a sheet and a texture hold every sample")]);
    }
    if arguments.compact && arguments.to != Form::Ktx2 {
        return Err(vec![Diagnostic::error("bad-argument", "--compact goes with --to ktx2")]);
    }
    let hcbtf = open(&arguments.file, output)?;
    let filled = filled(&hcbtf, &arguments.file)?;
    let which = if arguments.painted { Which::Painted } else { Which::All };
    let path = &arguments.output;
    let picture = match arguments.to {
        Form::Ktx2 => return export_texture(&filled, path, arguments.compact, output),
        Form::Folder => return export_folder(&filled, which, path, output),
        Form::Sheet => sheet::export(&filled),
        Form::Contact => contact::export(&filled, arguments.gap, which),
    };
    let png = picture.and_then(|picture| picture.to_png()).map_err(alone)?;
    write_atomic(path, &png).map_err(alone)?;
    output.result(&path.display().to_string());
    Ok(())
}

fn export_texture(filled: &Filled, path: &Path, is_compact: bool, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let storage = if is_compact { Storage::Compact } else { Storage::Quick };
    let options = LayerOptions { has_levels: true, is_decoded: false, storage };
    let texture = stored(&filled.grid(), |address| filled.tile(address), options).map_err(|problem| vec![problem])?;
    write_atomic(path, &ktx2::write(&texture)).map_err(|problem| vec![*problem])?;
    output.result(&path.display().to_string());
    let [width, height] = texture.size;
    let mib = texture.rgba.len() as f64 / f64::from(1 << 20);
    output.message(&format!("{width} x {height} texels, {} layers, {mib:.2} MiB", texture.count));
    Ok(())
}

fn export_folder(filled: &Filled, which: Which, path: &Path, output: &Output) -> Result<(), Vec<Diagnostic>> {
    if let Err(error) = std::fs::create_dir_all(path) {
        let problem = Diagnostic::error("cannot-write", format!("the folder cannot be made: {error}"));
        return Err(vec![problem.in_file(path.display().to_string()).hint("choose another with -o")]);
    }
    let total = filled.grid().sample_count();
    let mut count = 0;
    for image in folder::export(filled, which) {
        let written = image.and_then(|(name, png)| write_atomic(&path.join(name), &png));
        written.map_err(|problem| vec![*problem])?;
        count += 1;
        output.progress("writing", count, total);
    }
    output.end_progress();
    output.result(&path.display().to_string());
    output.message(&format!("{count} images"));
    Ok(())
}
