//! Contact sheets: all samples side by side in one picture, to be looked at or painted on in any
//! program.
//!
//! Views go across and lights go down, each in the order of
//! [`Directions::distinct`](crate::document::Directions::distinct): the normal first and once, then
//! ring by ring. Between tiles there may be a gap, which is transparent and not read.

use chiaro_locale::tr;

use super::MAX_PAINTED_BYTES;
use super::fill::{FilledSamples, SampleChoice};
use super::picture::{BytePicture, decode, reduced};
use super::report::FileReport;
use super::sheet::{gathered, painted};
use crate::diag::{Diagnostic, WithWarnings};
use crate::document::{Address, Grid, Hcbtf};
use crate::progress::Progress;

/// Greatest gap between tiles, in texels.
pub const MAX_GAP: u32 = 256;

/// Width and height of a grid's contact sheet, in texels.
///
/// # Errors
/// Where it would take more than [`MAX_PAINTED_BYTES`], or the gap is wider than [`MAX_GAP`].
pub fn size(grid: &Grid, gap: u32) -> Result<[u32; 2], String> {
    if gap > MAX_GAP {
        return Err(tr!("the gap is {gap} texels; it can be {MAX_GAP} at most"));
    }
    let side = |count: u64, tile: u32| count * u64::from(tile + gap) - u64::from(gap);
    let width = side(grid.view.distinct_count(), grid.size[0]);
    let height = side(grid.light.distinct_count(), grid.size[1]);
    match (
        u32::try_from(width),
        u32::try_from(height),
        width.saturating_mul(height).saturating_mul(4),
    ) {
        (Ok(width), Ok(height), ..=MAX_PAINTED_BYTES) => Ok([width, height]),
        _ => Err(tr!(
            "{width} x {height} texels take more than {most} MiB",
            most = MAX_PAINTED_BYTES >> 20
        )),
    }
}

/// The upper left corner of a sample's tile on the sheet, in texels.
fn place(grid: &Grid, address: Address, gap: u32) -> [usize; 2] {
    let step = |index: u64, tile: u32| index as usize * (tile + gap) as usize;
    [
        step(grid.view.index(address.view), grid.size[0]),
        step(grid.light.index(address.light), grid.size[1]),
    ]
}

/// The contact sheet of a filled HCBTF, with `gap` texels between tiles.
///
/// # Errors
/// As [`size`].
pub fn export(
    filled: &FilledSamples,
    gap: u32,
    which: SampleChoice,
) -> Result<BytePicture, Box<Diagnostic>> {
    let grid = filled.grid();
    let size = size(&grid, gap).map_err(|why| {
        let problem =
            Diagnostic::error("too-large", tr!("the contact sheet cannot be made: {why}"));
        Box::new(problem.hint(tr!("take a coarser grid or a narrower gap")))
    })?;
    let mut picture = BytePicture::transparent(size, tr!("contact sheet"))?;
    for (address, tile, provenance) in filled.iter() {
        if which.has(provenance) {
            picture.paste(place(&grid, address, gap), tile);
        }
    }
    Ok(picture)
}

/// An HCBTF from a PNG of its contact sheet; `name` is the file's name in diagnostics. Tiles that
/// are transparent black all over are left empty. `progress` counts samples.
///
/// # Errors
/// Where the file is no PNG, or not of the size that the grid and the gap require, and where the
/// work is stopped.
pub fn read(
    png: &[u8],
    grid: Grid,
    gap: u32,
    name: &str,
    progress: &Progress,
) -> Result<WithWarnings<Hcbtf>, Vec<Diagnostic>> {
    let mut report = FileReport::new(name);
    let accept = |found: [u32; 2], asked: [u32; 2]| {
        let message = || {
            let ([width, height], [w, h]) = (found, asked);
            tr!("it has {width} x {height} texels; the grid and the gap ask for {w} x {h}")
        };
        if found == asked { Ok(()) } else { Err(message()) }
    };
    let asked = grid.check().and_then(|()| size(&grid, gap));
    let hcbtf = match asked.and_then(|asked| decode(png, |found| accept(found, asked))) {
        Ok(decoded) => {
            if decoded.had_16_bits {
                report.add(reduced(tr!("the contact sheet")));
            }
            let hcbtf = import(&decoded.picture, grid, gap, progress);
            if progress.is_stopped() {
                report.stop();
            }
            Some(hcbtf)
        }
        Err(why) => {
            let problem =
                Diagnostic::error("hcbtf-contact", tr!("the contact sheet cannot be used: {why}"));
            report.add(problem.hint(tr!(
                "name the grid and the gap that it was made with (--grid 32x32,6x10,6x10 --gap 2)"
            )));
            None
        }
    };
    report.finish(hcbtf)
}

fn import(picture: &BytePicture, grid: Grid, gap: u32, progress: &Progress) -> Hcbtf {
    progress.begin(grid.sample_count());
    let tile = |address| {
        progress.add(1);
        let tile = picture.cut(place(&grid, address, gap), grid.size)?;
        Some((address, painted(grid.size, tile.bytes().to_vec())?))
    };
    let wanted = grid.addresses().take_while(|_| !progress.is_stopped());
    gathered(grid, wanted.filter_map(tile).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Directions;
    use crate::hcbtf::fill::fill;
    use crate::progress::Progress;

    #[test]
    fn samples_lie_by_view_and_light_and_come_back() {
        let grid = Grid {
            size: [3, 2],
            light: Directions { theta: 2, phi: 3 },
            view: Directions { theta: 3, phi: 2 },
        };
        let tile = |address: Address| {
            let n = grid.index(address).unwrap() as u8;
            painted(grid.size, (0..24).map(|byte| n.wrapping_mul(7).wrapping_add(byte)).collect())
                .unwrap()
        };
        let mut hcbtf = Hcbtf::new(grid);
        hcbtf.painted =
            grid.addresses().step_by(3).map(|address| (address, tile(address))).collect();
        let progress = Progress::new();
        for gap in [0, 1, 5] {
            let filled = fill(&hcbtf, &progress).unwrap();
            let picture = export(&filled, gap, SampleChoice::All).unwrap();
            // 5 views across, 4 lights down.
            assert_eq!(picture.size, [5 * 3 + 4 * gap, 4 * 2 + 3 * gap]);
            let back =
                read(&picture.to_png().unwrap(), grid, gap, "c.png", &Progress::new()).unwrap();
            assert_eq!(back.value.painted, hcbtf.painted, "gap {gap}");
            assert!(back.warnings.is_empty());
        }
        let filled = fill(&hcbtf, &progress).unwrap();
        let picture = export(&filled, 2, SampleChoice::All).unwrap();
        // The sample of light 1.1 (the third light) and view 0 (the first view), painted or not.
        let address = Address::new([1, 1], [0, 0]);
        let expected = hcbtf.painted(address).map_or([0; 4], |tile| tile.texel(0, 0));
        assert_eq!(picture.texel(0, 2 * (2 + 2)), expected);
        let problems =
            read(&picture.to_png().unwrap(), grid, 1, "c.png", &Progress::new()).unwrap_err();
        assert!(problems[0].to_string().contains("c.png: error[hcbtf-contact]"), "{problems:?}");
        assert!(size(&grid, MAX_GAP + 1).is_err());
    }
}
