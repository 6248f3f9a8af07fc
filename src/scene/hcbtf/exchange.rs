//! Exchange of HCBTFs with other programs: one import and one export for the command line and the
//! window.

use std::io::Cursor;
use std::path::{Path, PathBuf};

use chiaro_locale::{tr, trn};

use super::blocks::{Loss, loss};
use super::fill::{FilledSamples, NotFilled, SampleChoice};
use super::layers::{LayerOptions, from_layers, stored};
use super::{contact, folder, ktx2, read_bytes, sheet};
use crate::diag::{Diagnostic, WithWarnings};
use crate::document::{Grid, Hcbtf, Storage};
use crate::figures::bytes;
use crate::files::{Disk, FileSet, Files, make_folder, write_atomic};
use crate::progress::Progress;

/// Form of samples in other programs' files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ExchangeFormat {
    /// The thesis's flattened texture, as a PNG.
    Sheet,
    /// A folder of images, one a sample.
    Folder,
    /// One PNG: views across, lights down.
    Contact,
    /// The texture that shaders look up, as a KTX2 file.
    Ktx2,
}

impl ExchangeFormat {
    /// All forms.
    pub const ALL: [Self; 4] = [Self::Folder, Self::Contact, Self::Sheet, Self::Ktx2];

    /// The form that is assumed for a path if none is given: a folder for a folder, a KTX2 file for
    /// a texture, a sheet for anything else.
    pub fn guessed(files: &dyn Files, path: &Path) -> Self {
        let is_folder = files.is_folder(path);
        let is_ktx2 = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("ktx2"));
        match is_ktx2 {
            _ if is_folder => Self::Folder,
            true => Self::Ktx2,
            false => Self::Sheet,
        }
    }
}

/// The grid with as many texels a tile as the pictures at `from` have, with `gap` texels between
/// tiles on a contact sheet. A folder that Chiaro wrote contains its whole grid. Where the size
/// cannot be determined the grid is returned unchanged, and importing reports the error.
pub fn fitted(files: &dyn Files, from: &Path, form: ExchangeFormat, grid: Grid, gap: u32) -> Grid {
    let size_of = |path: &Path| {
        let reader = image::ImageReader::new(Cursor::new(read_bytes(files, path).ok()?));
        let (width, height) = reader.with_guessed_format().ok()?.into_dimensions().ok()?;
        Some([width, height])
    };
    let per =
        |side: u32, count: u64| u32::try_from(u64::from(side) / count.max(1)).unwrap_or(u32::MAX);
    let (light, view) = (grid.light, grid.view);
    if let Some(told) = told_grid(files, from, form) {
        return told;
    }
    let size = match form {
        ExchangeFormat::Folder => folder::first_image(files, from).and_then(|path| size_of(&path)),
        ExchangeFormat::Contact => size_of(from).map(|[width, height]| {
            let side = |side: u32, count| per(side.saturating_add(gap), count).saturating_sub(gap);
            [side(width, view.distinct_count()), side(height, light.distinct_count())]
        }),
        ExchangeFormat::Sheet => size_of(from).map(|[width, height]| {
            let down = u64::from(view.phi) * (u64::from(light.phi) + 2);
            [per(width, u64::from(view.theta) * u64::from(light.theta)), per(height, down)]
        }),
        // A KTX2 file contains its grid.
        ExchangeFormat::Ktx2 => None,
    };
    let fitted = size.map(|size| Grid { size, ..grid });
    fitted.filter(|grid| grid.check().is_ok()).unwrap_or(grid)
}

/// True if the files at `from` contain the grid, the rules and the tiling: a folder that Chiaro
/// wrote.
pub fn tells_all(files: &dyn Files, from: &Path, form: ExchangeFormat) -> bool {
    told_grid(files, from, form).is_some()
}

fn told_grid(files: &dyn Files, from: &Path, form: ExchangeFormat) -> Option<Grid> {
    if form == ExchangeFormat::Folder { folder::told_grid(files, from) } else { None }
}

/// An HCBTF from files of other programs, with warnings about them. `gap` is between the tiles of a
/// contact sheet, in texels. A KTX2 file and a folder that Chiaro wrote contain their grid.
/// `progress` counts samples.
///
/// # Errors
/// All errors that keep the files from being used, and where the work is stopped.
pub fn import(
    files: &dyn Files,
    from: &Path,
    form: ExchangeFormat,
    grid: Grid,
    gap: u32,
    progress: &Progress,
) -> Result<WithWarnings<Hcbtf>, Vec<Diagnostic>> {
    let name = from.display().to_string();
    let bytes = || read_bytes(files, from).map_err(|problem| vec![*problem]);
    match form {
        ExchangeFormat::Folder => folder::load(files, from, grid, progress),
        ExchangeFormat::Sheet => sheet::read(&bytes()?, grid, &name, progress),
        ExchangeFormat::Contact => contact::read(&bytes()?, grid, gap, &name, progress),
        ExchangeFormat::Ktx2 => {
            // All samples of a texture come at once.
            progress.begin(2);
            let texture = ktx2::read(&bytes()?, &name).map_err(|problem| vec![problem])?;
            progress.add(1);
            if progress.is_stopped() {
                return Err(vec![NotFilled::Stopped.into()]);
            }
            let hcbtf = from_layers(&texture).map_err(|problem| vec![problem.in_file(name)])?;
            progress.add(1);
            Ok(hcbtf.into())
        }
    }
}

/// Options of writing samples, where the form leaves a choice.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ExportOptions {
    /// Samples that are written; sheets and textures hold every sample in any case.
    pub which: SampleChoice,
    /// Gap between the tiles of a contact sheet, in texels.
    pub gap: u32,
    /// Storage of a texture.
    pub storage: Storage,
}

/// Writes the filled samples in a form to `path`: a file, or a folder, which is made if there is
/// none. `progress` counts the images of a folder, and the tiles that are compressed. Returns a
/// summary for the user.
///
/// # Errors
/// Where the result would be too large, cannot be written, or the work is stopped.
pub fn export(
    filled: &FilledSamples,
    form: ExchangeFormat,
    options: ExportOptions,
    path: &Path,
    progress: &Progress,
) -> Result<Option<String>, Vec<Diagnostic>> {
    let picture = match form {
        ExchangeFormat::Ktx2 => {
            return export_texture(filled, options.storage, path, progress).map(Some);
        }
        ExchangeFormat::Folder => {
            return export_folder(filled, options.which, path, progress).map(Some);
        }
        ExchangeFormat::Sheet => sheet::export(filled),
        ExchangeFormat::Contact => contact::export(filled, options.gap, options.which),
    };
    let png = picture.and_then(|picture| picture.to_png()).map_err(alone)?;
    write_atomic(path, &png).map_err(alone)?;
    Ok(None)
}

/// The files that an export in this form would replace, or lie beside: the file, or the files of an
/// earlier export in a folder.
pub fn in_the_way(form: ExchangeFormat, path: &Path) -> Vec<PathBuf> {
    match form {
        ExchangeFormat::Folder => folder::exported(&Disk, path),
        _ if Disk.metadata(path).is_some() => vec![path.to_path_buf()],
        _ => Vec::new(),
    }
}

/// The list of one problem.
fn alone(problem: Box<Diagnostic>) -> Vec<Diagnostic> {
    vec![*problem]
}

fn export_texture(
    filled: &FilledSamples,
    storage: Storage,
    path: &Path,
    progress: &Progress,
) -> Result<String, Vec<Diagnostic>> {
    let options = LayerOptions { has_levels: true, is_decoded: false, storage };
    let (grid, tile) = (filled.grid(), |address| filled.tile(address));
    let texture = stored(&grid, tile, options, progress).map_err(|problem| vec![problem])?;
    write_atomic(path, &ktx2::write(&texture)).map_err(alone)?;
    let [width, height] = texture.size;
    let layers = trn!(layers = texture.count, "{layers} layer", "{layers} layers");
    let size = bytes(texture.bytes.len() as u64);
    let mut said = tr!("{width} x {height} texels, {layers}, {size}");
    if storage == Storage::Blocks {
        let Loss { rms, largest } = loss(&grid, tile, &texture);
        said += &tr!("; of 255, the blocks are off by {rms:.2} (rms), {largest:.0} at most");
    }
    Ok(said)
}

/// Writes a folder. All its files appear at once, the listing last, and the files of an earlier
/// export are removed, so that none of those images are taken for images of this export.
fn export_folder(
    filled: &FilledSamples,
    which: SampleChoice,
    path: &Path,
    progress: &Progress,
) -> Result<String, Vec<Diagnostic>> {
    make_folder(path).map_err(|problem| vec![problem.hint(tr!("choose another one"))])?;
    let (name, listing) = folder::listing(filled, which);
    let mut set = FileSet::default();
    progress.begin(filled.grid().sample_count());
    let mut written = 0;
    for image in folder::export(filled, which) {
        if progress.is_stopped() {
            return Err(vec![NotFilled::Stopped.into()]);
        }
        let (name, png) = image.map_err(alone)?;
        set.add(&path.join(name), &png).map_err(alone)?;
        written += 1;
        progress.add(1);
    }
    set.add(&path.join(name), listing.as_bytes()).map_err(alone)?;
    folder::exported(&Disk, path).into_iter().for_each(|old| set.remove(old));
    set.commit().map_err(alone)?;
    Ok(trn!(
        written,
        "{written} image, and {name}, which tells the grid and the rules",
        "{written} images, and {name}, which tells the grid and the rules"
    ))
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::document::{Address, Directions, Tile};
    use crate::hcbtf::fill::fill;

    #[test]
    fn every_form_comes_back_and_tells_the_size_of_its_tiles() {
        let light = Directions { theta: 2, phi: 3 };
        let grid = Grid { size: [5, 3], light, view: Directions { theta: 3, phi: 2 } };
        let mut hcbtf = Hcbtf::new(grid);
        for (index, address) in grid.addresses().enumerate() {
            let tile = Tile::filled(grid.size, [index as u8 + 1, 7, 200 - index as u8, 255]);
            hcbtf.painted.insert(address, Arc::new(tile));
        }
        let filled = fill(&hcbtf, &Progress::new()).unwrap();
        let folder = tempfile::tempdir().unwrap();
        for (form, name) in [
            (ExchangeFormat::Sheet, "a.png"),
            (ExchangeFormat::Contact, "b.png"),
            (ExchangeFormat::Folder, "images"),
            (ExchangeFormat::Ktx2, "c.ktx2"),
        ] {
            let path = folder.path().join(name);
            let gap = if form == ExchangeFormat::Contact { 2 } else { 0 };
            export(
                &filled,
                form,
                ExportOptions { gap, ..ExportOptions::default() },
                &path,
                &Progress::new(),
            )
            .unwrap();
            let unknown = Grid { size: [1, 1], ..grid };
            let found = fitted(&Disk, &path, form, unknown, gap);
            assert_eq!(
                found.size,
                if form == ExchangeFormat::Ktx2 { [1, 1] } else { grid.size },
                "{form:?}"
            );
            let progress = Progress::new();
            let (back, notes) =
                import(&Disk, &path, form, found, gap, &progress).unwrap().into_parts();
            assert_eq!(progress.share(), 1.0, "{form:?}");
            let stopped = Progress::new();
            stopped.stop();
            assert_eq!(
                import(&Disk, &path, form, found, gap, &stopped).unwrap_err()[0].code,
                "stopped",
                "{form:?}"
            );
            assert!(notes.is_empty() && back.painted == hcbtf.painted, "{form:?}");
            assert_eq!(back.painted(Address::default()), hcbtf.painted(Address::default()));
        }
        assert_eq!(
            ExchangeFormat::guessed(&Disk, &folder.path().join("c.KTX2")),
            ExchangeFormat::Ktx2
        );
        assert_eq!(ExchangeFormat::guessed(&Disk, folder.path()), ExchangeFormat::Folder);
        assert_eq!(fitted(&Disk, Path::new("nowhere"), ExchangeFormat::Sheet, grid, 0), grid);
    }
}
