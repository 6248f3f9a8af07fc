//! `chiaro sheet`: frames side by side, with their numbers.

use super::frame_files::ShownFrames;
use super::output::Output;
use super::render::check_png;
use crate::diag::Diagnostic;
use crate::files::OutputKind;
use crate::film::sheet::{self, SheetCell, SheetLabel, columns_for};

const EXAMPLES: &str = "\
Examples:
  chiaro sheet 'out/####.exr' -o sheet.png
  chiaro sheet 'out/####.exr' -o sheet.png --frames 1-240x10 --width 480
  chiaro sheet before.png after.png -o compare.png --columns 2";

/// Arguments of `chiaro sheet`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    #[command(flatten)]
    shown: ShownFrames,
    /// Greatest number of pictures: of more frames some are shown, evenly
    #[arg(long, default_value_t = 60, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    cells: u32,
    /// Width of a picture, in pixels
    #[arg(long, default_value_t = 320, value_parser = clap::value_parser!(u32).range(16..=8192))]
    width: u32,
    /// Number of pictures in a row
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=1000))]
    columns: Option<u32>,
    /// Words above the pictures
    #[arg(long, default_value = "")]
    title: String,
}

pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let one = |problem: Diagnostic| vec![problem];
    let target = arguments.shown.target();
    check_png(target).map_err(one)?;
    let (found, mut outputs) = arguments.shown.found(OutputKind::PICTURE).map_err(one)?;
    let view = arguments.shown.view().map_err(one)?;
    let shown = evenly(found.len(), arguments.cells as usize);
    let cells = output.watch("reading", |progress| {
        progress.begin(shown.len() as u64);
        let cell = |(at, index): (usize, &usize)| {
            progress.add(u64::from(at > 0));
            let file = &found[*index];
            let picture = arguments.shown.picture(file, arguments.width, view.as_ref())?;
            Ok(SheetCell { picture, labels: vec![SheetLabel::Text(file.label())] })
        };
        shown.iter().enumerate().map(cell).collect::<Result<Vec<_>, Diagnostic>>()
    });
    let cells = cells.map_err(one)?;
    let size = cells.first().map_or([1, 1], |cell| cell.picture.size);
    let columns = arguments.columns.map_or_else(|| columns_for(cells.len(), size), |n| n as usize);
    let picture = sheet::draw(&arguments.title, &cells, columns).map_err(one)?;
    let bytes = picture.to_png().map_err(one)?;
    outputs.write(target, OutputKind::PICTURE, &bytes).map_err(one)?;
    let [width, height] = picture.size;
    let of = if cells.len() < found.len() { format!(" of {}", found.len()) } else { String::new() };
    let target = target.display();
    output.message(&format!("{target}: {width}x{height}, {}{of} frames", cells.len()));
    Ok(())
}

/// At most so many places of a list, with its first and its last one.
fn evenly(length: usize, most: usize) -> Vec<usize> {
    if length <= most {
        return (0..length).collect();
    }
    if most <= 1 {
        return vec![0];
    }
    (0..most).map(|at| at * (length - 1) / (most - 1)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn some_frames_stand_for_many() {
        assert_eq!(evenly(3, 60), [0, 1, 2]);
        assert_eq!(evenly(240, 4), [0, 79, 159, 239]);
        assert_eq!((evenly(9, 1), evenly(0, 4)), (vec![0], vec![]));
    }
}
