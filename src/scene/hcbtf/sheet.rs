//! The thesis's flattened texture: all six dimensions in one picture (thesis 10.2 and A.3).
//!
//! With `i` for the light (incident) and `r` for the view (reflected), and Ti, Pi, Tr, Pr the rings
//! and steps of each,
//!
//! ```text
//! X = ix (Tr Ti) + theta_r Ti + theta_i
//! Y = iy (Pr (Pi + 2)) + phi_r (Pi + 2) + phi_i + 1
//! ```
//!
//! The rows at phi_i + 1 = 0 and Pi + 1 are padding, copies of the last and the first step, so that
//! hardware interpolates across the seam. At theta = 0 every step around the normal holds a copy of
//! the one sample there. (Section 10.2 and the heading of figure 23 exchange light and view; the
//! shader of A.3, which ran, uses this order.) iy counts a tile's rows from the top.

use std::sync::Arc;

use chiaro_locale::tr;
use rayon::iter::{IndexedParallelIterator as _, IntoParallelIterator as _, ParallelIterator as _};
use rayon::slice::ParallelSliceMut as _;

use super::fill::{FilledSamples, shared};
use super::picture::{BytePicture, decode, reduced};
use super::report::FileReport;
use super::{MAX_PAINTED_BYTES, folder};
use crate::diag::{Diagnostic, WithWarnings};
use crate::document::{Address, Direction, Grid, Hcbtf, Tile};
use crate::progress::Progress;

/// The width and height of a grid's sheet, in texels; saturated at the greatest number for grids
/// that are too large.
pub fn size(grid: &Grid) -> [u32; 2] {
    let times = |numbers: [u32; 3]| numbers.into_iter().fold(1_u32, u32::saturating_mul);
    [
        times([grid.size[0], grid.view.theta, grid.light.theta]),
        times([grid.size[1], grid.view.phi, grid.light.phi.saturating_add(2)]),
    ]
}

/// The sheet of a filled HCBTF.
///
/// # Errors
/// Where it would take more than [`MAX_PAINTED_BYTES`].
pub fn export(filled: &FilledSamples) -> Result<BytePicture, Box<Diagnostic>> {
    let grid = filled.grid();
    let mut sheet = BytePicture::transparent(size(&grid), "sheet")?;
    let (width, stride) = (4 * grid.size[0] as usize, 4 * sheet.size[0] as usize);
    sheet.rgba.par_chunks_exact_mut(stride).enumerate().for_each(|(y, row)| {
        let place = Row::of(&grid, y);
        // A row of each tile that this row of the sheet interleaves; texels of one ix are adjacent.
        let rows: Vec<&[u8]> = place
            .addresses(&grid)
            .filter_map(|address| {
                filled.tile(address)?.bytes().get(place.iy * width..(place.iy + 1) * width)
            })
            .collect();
        for (ix, texels) in row.chunks_exact_mut(4 * rows.len().max(1)).enumerate() {
            for (texel, row) in texels.chunks_exact_mut(4).zip(&rows) {
                texel.copy_from_slice(&row[4 * ix..4 * ix + 4]);
            }
        }
    });
    Ok(sheet)
}

/// Content of a texel of the sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SheetTexel {
    /// Address of the sample, in canonical form.
    pub address: Address,
    /// Texel of the sample's tile, from its upper left corner.
    pub texel: [u32; 2],
    /// True for a copy: padding, or a step around the normal other than the first.
    pub is_copy: bool,
}

/// The content of a grid's sheet at a place, in texels from its upper left corner; `None` outside.
pub fn held(grid: &Grid, [x, y]: [u32; 2]) -> Option<SheetTexel> {
    let [ix, theta_r, theta_i] = column(grid, x)?;
    let ([iy, phi_r, phi_i], is_padding) = row(grid, y)?;
    let direction = |theta, phi| Direction { theta, phi };
    let written = Address { view: direction(theta_r, phi_r), light: direction(theta_i, phi_i) };
    let address = written.canonical();
    Some(SheetTexel { address, texel: [ix, iy], is_copy: is_padding || address != written })
}

/// The content of a column of the sheet: the texel's column in the tile, the ring of the view, and
/// that of the light.
pub fn column(grid: &Grid, x: u32) -> Option<[u32; 3]> {
    let across = grid.view.theta * grid.light.theta;
    let within = x.checked_rem(across)?;
    (x < size(grid)[0]).then(|| [x / across, within / grid.light.theta, within % grid.light.theta])
}

/// The content of a row of the sheet: the texel's row in the tile, the step of the view, and that
/// of the light; true for padding.
pub fn row(grid: &Grid, y: u32) -> Option<([u32; 3], bool)> {
    let is_inside = y < size(grid)[1];
    is_inside.then(|| {
        let Row { iy, phi_r, phi_i, is_padding } = Row::of(grid, y as usize);
        ([iy as u32, phi_r, phi_i], is_padding)
    })
}

/// Content of a row of the sheet.
struct Row {
    iy: usize,
    phi_r: u32,
    phi_i: u32,
    is_padding: bool,
}

impl Row {
    fn of(grid: &Grid, y: usize) -> Self {
        let (steps, padded) = (grid.light.phi, grid.light.phi + 2);
        let block = (grid.view.phi * padded) as usize;
        let within = (y % block) as u32;
        let step = within % padded;
        Self {
            iy: y / block,
            phi_r: within / padded,
            phi_i: (step + steps - 1) % steps,
            is_padding: step == 0 || step == padded - 1,
        }
    }

    /// The samples whose texels are adjacent in the row, from the left.
    fn addresses(&self, grid: &Grid) -> impl Iterator<Item = Address> + use<> {
        let (lights, phi_i, phi_r) = (grid.light.theta, self.phi_i, self.phi_r);
        (0..grid.view.theta).flat_map(move |theta_r| {
            let view = Direction { theta: theta_r, phi: phi_r };
            (0..lights).map(move |theta_i| Address {
                light: Direction { theta: theta_i, phi: phi_i },
                view,
            })
        })
    }
}

/// The place of the texel (ix, iy) of a sample in the sheet.
pub fn place(grid: &Grid, Address { light, view }: Address, [ix, iy]: [usize; 2]) -> [usize; 2] {
    let padded = grid.light.phi + 2;
    let across = (grid.view.theta * grid.light.theta) as usize;
    let down = (grid.view.phi * padded) as usize;
    let column = (view.theta * grid.light.theta + light.theta) as usize;
    let row = (view.phi * padded + light.phi + 1) as usize;
    [ix * across + column, iy * down + row]
}

/// An HCBTF from a PNG of its sheet; `name` is the file's name in diagnostics.
///
/// # Errors
/// Where the file is no PNG, or not of the size that the grid requires.
pub fn read(
    png: &[u8],
    grid: Grid,
    name: &str,
    progress: &Progress,
) -> Result<WithWarnings<Hcbtf>, Vec<Diagnostic>> {
    let mut report = FileReport::new(name);
    let hcbtf = decode_sheet(png, &grid, &mut report)
        .and_then(|sheet| import_into(&sheet, grid, &mut report, progress));
    report.finish(hcbtf)
}

fn decode_sheet(png: &[u8], grid: &Grid, report: &mut FileReport) -> Option<BytePicture> {
    match grid.check().and_then(|()| decode(png, |found| fits(found, grid))) {
        Ok(decoded) => {
            if decoded.had_16_bits {
                report.add(reduced(tr!("the sheet")));
            }
            Some(decoded.picture)
        }
        Err(why) => {
            let problem = Diagnostic::error("hcbtf-sheet", tr!("the sheet cannot be used: {why}"));
            report.add(
                problem.hint(tr!("name the grid that it was made with (--grid 32x32,6x10,6x10)")),
            );
            None
        }
    }
}

fn fits([width, height]: [u32; 2], grid: &Grid) -> Result<(), String> {
    let [asked_width, asked_height] = size(grid);
    if [width, height] != [asked_width, asked_height] {
        return Err(tr!(
            "it has {width} x {height} texels; the grid asks for {asked_width} x {asked_height}"
        ));
    }
    let bytes = u64::from(width) * u64::from(height) * 4;
    let too_large = || {
        tr!(
            "it takes {mib} MiB; at most {most} MiB can be",
            mib = bytes >> 20,
            most = MAX_PAINTED_BYTES >> 20
        )
    };
    if bytes > MAX_PAINTED_BYTES { Err(too_large()) } else { Ok(()) }
}

/// An HCBTF from its sheet: every sample is painted, except those that are transparent black all
/// over, which are left empty. Copies that differ from their originals are reported, and not taken.
///
/// # Errors
/// Where the sheet does not have the size that the grid requires.
pub fn import(
    sheet: &BytePicture,
    grid: Grid,
    name: &str,
) -> Result<WithWarnings<Hcbtf>, Vec<Diagnostic>> {
    let mut report = FileReport::new(name);
    let hcbtf = match grid.check().and_then(|()| fits(sheet.size, &grid)) {
        Ok(())
            if sheet.rgba.len() as u64
                == u64::from(sheet.size[0]) * u64::from(sheet.size[1]) * 4 =>
        {
            import_into(sheet, grid, &mut report, &Progress::new())
        }
        Ok(()) => None,
        Err(why) => {
            report.add(Diagnostic::error("hcbtf-sheet", tr!("the sheet cannot be used: {why}")));
            None
        }
    };
    report.finish(hcbtf)
}

fn import_into(
    sheet: &BytePicture,
    grid: Grid,
    report: &mut FileReport,
    progress: &Progress,
) -> Option<Hcbtf> {
    progress.begin(grid.sample_count());
    check(sheet, &grid, report);
    let [width, height] = grid.size.map(|side| side as usize);
    let addresses: Vec<Address> = grid.addresses().collect();
    let painted = addresses.into_par_iter().filter_map(|address| {
        if progress.is_stopped() {
            return None;
        }
        progress.add(1);
        let places = (0..height).flat_map(|iy| (0..width).map(move |ix| [ix, iy]));
        let texels = places.flat_map(|texel| {
            let [x, y] = place(&grid, address, texel);
            sheet.texel(x, y)
        });
        let mut rgba = Vec::with_capacity(4 * grid.texels());
        rgba.extend(texels);
        painted(grid.size, rgba).map(|tile| (address, tile))
    });
    let painted = painted.collect();
    if progress.is_stopped() {
        report.stop();
    }
    Some(gathered(grid, painted))
}

/// A tile, or `None` if it is transparent black all over: pictures of many samples have no other
/// way to leave a sample empty.
pub(super) fn painted(size: [u32; 2], rgba: Vec<u8>) -> Option<Arc<Tile>> {
    let is_empty = rgba.iter().all(|byte| *byte == 0);
    if is_empty { None } else { Tile::new(size, rgba).map(Arc::new) }
}

/// An HCBTF of painted samples, with equal tiles stored once.
pub(super) fn gathered(grid: Grid, painted: Vec<(Address, Arc<Tile>)>) -> Hcbtf {
    let (addresses, tiles): (Vec<Address>, Vec<Arc<Tile>>) = painted.into_iter().unzip();
    let (tiles, places) = shared(tiles);
    let painted = addresses
        .into_iter()
        .zip(places)
        .filter_map(|(address, at)| Some((address, tiles.get(at as usize)?.clone())));
    let mut hcbtf = Hcbtf::new(grid);
    hcbtf.painted = painted.collect();
    hcbtf
}

/// Count of texels that differ from the texels that they should be copies of.
#[derive(Clone, Copy, Default)]
struct DifferenceCount {
    count: u64,
    /// Position of the first, by rows: y and x.
    first: Option<[usize; 2]>,
}

impl DifferenceCount {
    fn at(&mut self, x: usize, y: usize) {
        self.count += 1;
        self.first.get_or_insert([y, x]);
    }

    fn and(self, other: Self) -> Self {
        let first = self.first.into_iter().chain(other.first).min();
        Self { count: self.count + other.count, first }
    }
}

/// Compares all copies with their originals: padding rows, lights at the normal, views at the
/// normal.
fn check(sheet: &BytePicture, grid: &Grid, report: &mut FileReport) {
    let [width, height] = sheet.size.map(|side| side as usize);
    let found = (0..height).into_par_iter().map(|y| {
        let row = Row::of(grid, y);
        let mut found = [DifferenceCount::default(); 3];
        let addresses: Vec<Address> = row.addresses(grid).collect();
        for x in 0..width {
            let own = addresses[x % addresses.len()];
            let at = |address: Address| {
                let [x, y] = place(grid, address, [x / addresses.len(), row.iy]);
                sheet.texel(x, y)
            };
            let texel = sheet.texel(x, y);
            if row.is_padding {
                if texel != at(own) {
                    found[0].at(x, y);
                }
                continue;
            }
            // Each texel is compared with the copy at step 0, by its light and by its view
            // separately.
            let light = Address { light: own.light.canonical(), ..own };
            let view = Address { view: own.view.canonical(), ..own };
            for (found, copied) in found[1..].iter_mut().zip([light, view]) {
                if copied != own && texel != at(copied) {
                    found.at(x, y);
                }
            }
        }
        found
    });
    let none = || [DifferenceCount::default(); 3];
    let found = found.reduce(none, |a, b| std::array::from_fn(|i| a[i].and(b[i])));
    let kinds = [
        (
            tr!("texels of padding rows differ from the rows that they copy"),
            tr!("the rows within are taken"),
        ),
        (
            tr!("texels at the normal differ between steps of the light around it"),
            tr!("step 0 is taken"),
        ),
        (
            tr!("texels at the normal differ between steps of the view around it"),
            tr!("step 0 is taken"),
        ),
    ];
    for (DifferenceCount { count, first }, (what, taken)) in found.into_iter().zip(kinds) {
        let Some([y, x]) = first else { continue };
        let row = Row::of(grid, y);
        let address = row
            .addresses(grid)
            .nth(x % (grid.view.theta * grid.light.theta) as usize)
            .unwrap_or_default();
        let message = tr!(
            "{count} {what}, the first at x {x}, y {y} (`{sample}`)",
            sample = folder::file_name(address)
        );
        report.add(
            Diagnostic::warning("hcbtf-copies", message)
                .hint(tr!("{taken}; exporting makes all copies equal")),
        );
    }
}

#[cfg(test)]
mod tests;
