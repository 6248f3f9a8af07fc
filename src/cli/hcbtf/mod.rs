//! `chiaro hcbtf`: hand-painted 6D textures as files.

mod exchange;
mod info;
mod make;
mod new;
mod rules;

use std::path::{Path, PathBuf};
use std::str::FromStr;

use clap::Subcommand;

use super::output::Output;
use crate::diag::Diagnostic;
use crate::document::{Directions, Grid, Hcbtf};
use crate::files::{Disk, OutputKind, Outputs};
use chiaro_scene::hcbtf::{FilledSamples, fill::fill, load, write};

const EXAMPLES: &str = "\
Examples:
  chiaro hcbtf new grass --color '#3a5a2a'
  chiaro hcbtf info grass.hcbtf
  chiaro hcbtf import sheet.png -o grass.hcbtf
  chiaro hcbtf import painted/ -o grass.hcbtf --grid 64x64,6x12,6x12
  chiaro hcbtf import all.png --as contact --gap 2 -o grass.hcbtf
  chiaro hcbtf rules grass.hcbtf > rules.json
  chiaro hcbtf rules grass.hcbtf --set rules.json
  chiaro hcbtf synthesize grass.hcbtf -o meadow.hcbtf --size 64x64 --seed 3
  chiaro hcbtf bake looks/rim.json -o rim.hcbtf --grid 32x32,6x10,6x10 --samples 16
  chiaro hcbtf export grass.hcbtf -o sheet.png
  chiaro hcbtf export grass.hcbtf -o painted/ --painted
  chiaro hcbtf export grass.hcbtf -o grass.ktx2 --compact

A sheet is the thesis's flattened texture. A folder holds images named like l2.3_v1.4.png (light \
at ring 2, step 3; view at
ring 1, step 4), or numbered; one that was exported tells its grid, its rules and what is painted \
in hcbtf.json. A contact
sheet has views across and lights down. docs/format.md tells all about them.";

const GRID_HELP: &str = "the thesis's, 32x32,6x10,6x10";

/// Arguments of `chiaro hcbtf`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Tell what a file holds: grid, painted samples, what each rule fills, memory
    Info(info::Arguments),
    /// Make an .hcbtf file of a sheet, a folder of images, or a contact sheet
    Import(exchange::ImportArguments),
    /// Write a sheet, a folder of images, a contact sheet, or the texture of shaders
    Export(exchange::ExportArguments),
    /// Make another tile, or a larger one, of patches of a painted one
    Synthesize(make::SynthesizeArguments),
    /// Paint an .hcbtf file with what a look shows on a flat tile
    Bake(make::BakeArguments),
    /// Write an .hcbtf file to begin with
    New(new::Arguments),
    /// Show the rules of a file as JSON, or set them
    Rules(rules::Arguments),
}

pub(super) async fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    match &arguments.command {
        Command::Info(arguments) => info::run(arguments, output).await,
        Command::Import(arguments) => exchange::import(arguments, output),
        Command::Export(arguments) => exchange::export(arguments, output),
        Command::Synthesize(arguments) => make::synthesized(arguments, output),
        Command::Bake(arguments) => make::baked(arguments, output),
        Command::New(arguments) => new::run(arguments, output),
        Command::Rules(arguments) => rules::run(arguments, output),
    }
}

/// Reads a file and prints its warnings.
fn open(path: &Path, output: &Output) -> Result<Hcbtf, Vec<Diagnostic>> {
    let (hcbtf, notes) = load(&Disk, path)?.into_parts();
    output.diagnostics(&notes);
    Ok(hcbtf)
}

/// Runs the rules, and shows their progress.
fn filled(hcbtf: &Hcbtf, path: &Path, output: &Output) -> Result<FilledSamples, Vec<Diagnostic>> {
    let filled = output.watch("filling", |progress| fill(hcbtf, progress));
    filled.map_err(|why| vec![Diagnostic::from(why).in_file(path.display().to_string())])
}

/// Refuses to replace a file without `--force`, and always to replace an input.
fn check_free(path: &Path, outputs: &Outputs) -> Result<(), Vec<Diagnostic>> {
    outputs.check(path, OutputKind::DOCUMENT).map_err(|problem| vec![problem])
}

/// Writes a document, and prints a message about it.
fn save(
    hcbtf: &Hcbtf,
    path: &Path,
    mut outputs: Outputs,
    output: &Output,
) -> Result<(), Vec<Diagnostic>> {
    let bytes =
        write(hcbtf).map_err(|problem| vec![problem.in_file(path.display().to_string())])?;
    outputs.write(path, OutputKind::DOCUMENT, &bytes).map_err(|problem| vec![problem])?;
    output.result(&path.display().to_string());
    Ok(())
}

/// Prints the number of painted samples of a document.
fn tell_painted(hcbtf: &Hcbtf, output: &Output) {
    output.message(&format!(
        "{} of {} samples are painted",
        hcbtf.painted.len(),
        hcbtf.grid.sample_count()
    ));
}

/// A grid as the command line writes it: texels, lights and views.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct GridText(Grid);

impl FromStr for GridText {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let pair = |part: &str| {
            let (first, second) = part.trim().split_once(['x', 'X'])?;
            Some([first.trim().parse().ok()?, second.trim().parse().ok()?])
        };
        let pairs: Option<Vec<[u32; 2]>> = text.split(',').map(pair).collect();
        let Some([size, light, view]) =
            pairs.and_then(|pairs| <[[u32; 2]; 3]>::try_from(pairs).ok())
        else {
            return Err("write texels, lights and views, each as AxB: 32x32,6x10,6x10".to_owned());
        };
        let directions = |[theta, phi]: [u32; 2]| Directions { theta, phi };
        let grid = Grid { size, light: directions(light), view: directions(view) };
        grid.check().map(|()| Self(grid))
    }
}

/// The path with `.hcbtf` at its end.
fn with_ending(path: &Path) -> PathBuf {
    let has_ending = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("hcbtf"));
    if has_ending {
        return path.to_path_buf();
    }
    let mut name = path.as_os_str().to_owned();
    name.push(".hcbtf");
    PathBuf::from(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grids_are_read_or_told_how() {
        assert_eq!("32x32,6x10,6x10".parse(), Ok(GridText(Grid::THESIS)));
        assert_eq!(" 8x4, 2x3 ,1X1".parse::<GridText>().unwrap().0.size, [8, 4]);
        for wrong in [
            "",
            "32x32",
            "32x32,6x10",
            "32x32,6x10,6x10,1x1",
            "32,6x10,6x10",
            "0x1,1x1,1x1",
            "1x1,1x1,256x1",
        ] {
            assert!(wrong.parse::<GridText>().is_err(), "{wrong}");
        }
        assert_eq!(with_ending(Path::new("a/b.1")), Path::new("a/b.1.hcbtf"));
        assert_eq!(with_ending(Path::new("a.HCBTF")), Path::new("a.HCBTF"));
    }
}
