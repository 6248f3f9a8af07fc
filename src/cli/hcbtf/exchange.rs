//! `chiaro hcbtf import` and `export`: sheets, folders of images, contact sheets.

use std::path::{Path, PathBuf};

use clap::ValueEnum;

use super::{GRID_HELP, GridText, check_free, filled, open, save, tell_painted, with_ending};
use crate::diag::Diagnostic;
use crate::document::{Grid, Storage};
use crate::files::{Disk, OutputKind};
use crate::output::Output;
use crate::target::{OutputPath, outputs};
use chiaro_scene::hcbtf::{SampleChoice, exchange};

/// Arrangement of samples in other programs' files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum FormatChoice {
    /// The thesis's flattened texture, with padding rows and copies at the normal
    Sheet,
    /// A folder of images, one a sample: l2.3_v1.4.png, or numbered in the grid's order
    Folder,
    /// One picture: views across, lights down
    Contact,
    /// The texture that shaders look up, as KTX2, filled, with smaller levels for surfaces that are
    /// far away
    Ktx2,
}

impl From<FormatChoice> for exchange::ExchangeFormat {
    fn from(form: FormatChoice) -> Self {
        match form {
            FormatChoice::Sheet => Self::Sheet,
            FormatChoice::Folder => Self::Folder,
            FormatChoice::Contact => Self::Contact,
            FormatChoice::Ktx2 => Self::Ktx2,
        }
    }
}

/// Arguments of `chiaro hcbtf import`.
#[derive(Debug, clap::Args)]
pub(super) struct ImportArguments {
    /// A PNG, a KTX2 file or a folder
    from: PathBuf,
    /// The .hcbtf file to write
    #[arg(short, long)]
    output: OutputPath,
    /// Form of the files [default: a folder is a folder, a PNG a sheet, a KTX2 file the texture of
    /// shaders]
    #[arg(long = "as", value_enum)]
    form: Option<FormatChoice>,
    #[arg(long, help = format!("Texels, lights and views, as 32x32,6x10,6x10 [default: \
                                {GRID_HELP}]"))]
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
    let path = with_ending(arguments.output.as_ref());
    let from = &arguments.from;
    let outputs = outputs(arguments.force, [from]);
    check_free(&path, &outputs)?;
    let form = arguments.form.map_or_else(
        || exchange::ExchangeFormat::guessed(&Disk, from),
        exchange::ExchangeFormat::from,
    );
    let grid = arguments.grid.map(|grid| grid.0);
    // Images of a folder tell their size themselves.
    let fitted = || match form {
        exchange::ExchangeFormat::Folder => {
            exchange::fitted(&Disk, from, form, Grid::THESIS, arguments.gap)
        }
        _ => Grid::THESIS,
    };
    let grid_or_fitted = grid.unwrap_or_else(fitted);
    let (mut hcbtf, notes) = output
        .watch("reading", |progress| {
            exchange::import(&Disk, from, form, grid_or_fitted, arguments.gap, progress)
        })?
        .into_parts();
    output.diagnostics(&notes);
    if grid.is_some_and(|grid| grid != hcbtf.grid) {
        let problem = Diagnostic::error(
            "bad-argument",
            "--grid says another grid than these files themselves",
        );
        return Err(vec![problem.hint("leave --grid out")]);
    }
    hcbtf.is_tiling &= !arguments.no_tiling;
    save(&hcbtf, &path, outputs, output)?;
    tell_painted(&hcbtf, output);
    Ok(())
}

/// Arguments of `chiaro hcbtf export`.
#[derive(Debug, clap::Args)]
pub(super) struct ExportArguments {
    /// An .hcbtf file
    file: PathBuf,
    /// Form to write [default: what the name of the output says: x.png a sheet, x.ktx2 the texture
    /// of shaders, x/ a folder]
    #[arg(long, value_enum)]
    to: Option<FormatChoice>,
    /// The PNG, the KTX2 file or the folder; a folder is made where there is none
    #[arg(short, long)]
    output: OutputPath,
    /// Contact sheets: texels between tiles
    #[arg(long, default_value_t = 0)]
    gap: u32,
    #[arg(long, help = format!("KTX2: {}", Storage::Compact.about()))]
    compact: bool,
    #[arg(long, conflicts_with = "compact", help = format!("KTX2: {}", Storage::Blocks.about()))]
    blocks: bool,
    /// Folders and contact sheets: only what is painted, without what the rules fill
    #[arg(long)]
    painted: bool,
    /// Replace a file that is there, or what a folder holds of an earlier export
    #[arg(long)]
    force: bool,
}

pub(super) fn export(arguments: &ExportArguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let path = arguments.output.as_ref();
    let form = written_form(path, arguments.to).map_err(|problem| vec![problem])?;
    if arguments.painted && matches!(form, FormatChoice::Sheet | FormatChoice::Ktx2) {
        let problem =
            Diagnostic::error("bad-argument", "--painted goes with --to folder and --to contact");
        return Err(vec![problem.hint("a sheet and a texture hold every sample")]);
    }
    let storage = match (arguments.compact, arguments.blocks) {
        (true, _) => Storage::Compact,
        (_, true) => Storage::Blocks,
        _ => Storage::Quick,
    };
    if storage != Storage::Quick && form != FormatChoice::Ktx2 {
        let message = format!("--{} goes with --to ktx2", storage.word());
        return Err(vec![Diagnostic::error("bad-argument", message)]);
    }
    let outputs = outputs(arguments.force, [&arguments.file]);
    for found in exchange::in_the_way(form.into(), path) {
        if let Err(mut problem) = outputs.check(&found, OutputKind::DOCUMENT) {
            if form == FormatChoice::Folder {
                problem.hints = vec![
                    "choose another folder, or replace the export that is in it with --force"
                        .to_owned(),
                ];
            }
            return Err(vec![problem]);
        }
    }
    let hcbtf = open(&arguments.file, output)?;
    let filled = filled(&hcbtf, &arguments.file, output)?;
    let which = if arguments.painted { SampleChoice::Painted } else { SampleChoice::All };
    let options = exchange::ExportOptions { which, gap: arguments.gap, storage };
    let told = output.watch("writing", |progress| {
        exchange::export(&filled, form.into(), options, path, progress)
    })?;
    output.result(&path.display().to_string());
    told.into_iter().for_each(|told| output.message(&told));
    Ok(())
}

/// Form of the file at `path`: the one that was `asked` for, or the one that the name says. Nobody
/// expects a PNG in a file named x.ktx2.
///
/// # Errors
/// A name that says no form, or another form than was asked for.
fn written_form(path: &Path, asked: Option<FormatChoice>) -> Result<FormatChoice, Diagnostic> {
    let is_folder = path.is_dir() || path.as_os_str().to_string_lossy().ends_with(['/', '\\']);
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    let said = match ending.as_deref() {
        _ if is_folder => Some(FormatChoice::Folder),
        Some("png") => Some(FormatChoice::Sheet),
        Some("ktx2") => Some(FormatChoice::Ktx2),
        _ => None,
    };
    let ends = |form: FormatChoice| match form {
        FormatChoice::Sheet | FormatChoice::Contact => "a PNG: its name must end in .png",
        FormatChoice::Ktx2 => "a KTX2 file: its name must end in .ktx2",
        FormatChoice::Folder => "a folder: its name ends in no .png and no .ktx2",
    };
    let wrong = |message: String| {
        Diagnostic::error("bad-argument", format!("-o {}: {message}", path.display()))
    };
    match (asked, said) {
        (Some(FormatChoice::Contact), Some(FormatChoice::Sheet)) => Ok(FormatChoice::Contact),
        (Some(asked), Some(said)) if asked == said => Ok(asked),
        (Some(FormatChoice::Folder), None) => Ok(FormatChoice::Folder),
        (None, Some(said)) => Ok(said),
        (Some(asked), _) => {
            let word = asked
                .to_possible_value()
                .map_or_else(String::new, |value| value.get_name().to_owned());
            Err(wrong(format!("--to {word} writes {}", ends(asked))))
        }
        (None, None) => {
            let problem = wrong("the name does not say what to write".to_owned());
            let hint = "end it in .png for a sheet, .ktx2 for the texture of shaders, / for a \
                        folder; or say it with --to";
            Err(problem.hint(hint))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_what_is_written_and_nothing_else_is() {
        let form = |path: &str, asked| written_form(Path::new(path), asked);
        for (path, asked, written) in [
            ("a.png", None, FormatChoice::Sheet),
            ("a.PNG", Some(FormatChoice::Contact), FormatChoice::Contact),
            ("a.ktx2", None, FormatChoice::Ktx2),
            ("a.ktx2", Some(FormatChoice::Ktx2), FormatChoice::Ktx2),
            ("images/", None, FormatChoice::Folder),
            ("images", Some(FormatChoice::Folder), FormatChoice::Folder),
            ("v1.2", Some(FormatChoice::Folder), FormatChoice::Folder),
            (".", None, FormatChoice::Folder),
        ] {
            assert_eq!(form(path, asked), Ok(written), "{path}");
        }
        for (path, asked) in [
            ("a.ktx2", Some(FormatChoice::Sheet)),
            ("a.png", Some(FormatChoice::Ktx2)),
            ("a.png", Some(FormatChoice::Folder)),
            ("a.jpg", Some(FormatChoice::Sheet)),
            ("a", Some(FormatChoice::Contact)),
            ("a", None),
            ("a.dds", None),
            ("images/", Some(FormatChoice::Sheet)),
        ] {
            let problem = form(path, asked).unwrap_err();
            assert!(
                problem.code == "bad-argument" && problem.message.contains(path),
                "{path}: {problem}"
            );
        }
    }
}
