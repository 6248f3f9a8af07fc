//! Covers of `.hcbtf` files, shown before a file is opened: its thumbnail, its grid, and the number
//! of painted samples. No sample is read.

use std::path::Path;

use chiaro_locale::tr;

use super::archive::Archive;
use super::manifest::{self, MAX_MANIFEST_BYTES, NAME, THUMBNAIL};
use super::picture::{BytePicture, MAX_PNG_EXTRAS, decode};
use super::report::FileReport;
use crate::document::Grid;
use crate::files::Files;

/// Greatest size of a file that is read for its cover, in bytes: many covers may be asked for at
/// once.
const MOST_BYTES: u64 = 64 << 20;
/// Greatest side of a thumbnail that is shown, in texels: Chiaro's have 256 at most.
const MOST_SIDE: u32 = 1024;

/// Cover of an `.hcbtf` file.
#[derive(Clone, Debug, PartialEq)]
pub struct Cover {
    /// Grid of the HCBTF.
    pub grid: Grid,
    /// Number of painted samples.
    pub painted: usize,
    /// Thumbnail, if there is one that can be shown.
    pub picture: Option<BytePicture>,
}

/// The cover of the `.hcbtf` file at `path`; `None` if the file is not an `.hcbtf`, is damaged, or
/// is larger than 64 MiB.
pub fn cover(files: &dyn Files, path: &Path) -> Option<Cover> {
    let bytes = files.read(path, MOST_BYTES).ok()?;
    let mut archive = Archive::open(&bytes).ok()?;
    let text = archive.read(NAME, MAX_MANIFEST_BYTES).ok()?;
    let mut report = FileReport::new("");
    let manifest = manifest::parse(&text, &mut report).filter(|_| !report.has_errors())?;
    let most = u64::from(MOST_SIDE) * u64::from(MOST_SIDE) * 4 + MAX_PNG_EXTRAS;
    let png = archive.has(THUMBNAIL).then(|| archive.read(THUMBNAIL, most).ok()).flatten();
    let accept = |size: [u32; 2]| match size.into_iter().all(|side| (1..=MOST_SIDE).contains(&side))
    {
        true => Ok(()),
        false => Err(tr!("it is no thumbnail").to_owned()),
    };
    let picture = png.and_then(|png| decode(&png, accept).ok()).map(|decoded| decoded.picture);
    Some(Cover { grid: manifest.grid, painted: manifest.painted.len(), picture })
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::document::{Address, Directions, Hcbtf, Tile};
    use crate::files::Disk;
    use crate::hcbtf::write;

    #[test]
    fn a_file_shows_its_thumbnail_and_its_size_and_damage_shows_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let directions = Directions { theta: 2, phi: 3 };
        let grid = Grid { size: [6, 3], light: directions, view: directions };
        let mut hcbtf = Hcbtf::new(grid);
        hcbtf
            .painted
            .insert(Address::default(), Arc::new(Tile::filled(grid.size, [9, 80, 200, 255])));
        let bytes = write(&hcbtf).unwrap();
        let path = folder.path().join("a.hcbtf");
        std::fs::write(&path, &bytes).unwrap();
        let found = cover(&Disk, &path).unwrap();
        assert_eq!((found.grid, found.painted), (grid, 1));
        let picture = found.picture.unwrap();
        assert_eq!(picture.size[0], 2 * picture.size[1], "as wide as the tile is for its height");
        assert!(picture.rgba.chunks(4).all(|texel| texel == [9, 80, 200, 255]));
        std::fs::write(&path, &bytes[..bytes.len() / 2]).unwrap();
        assert_eq!(cover(&Disk, &path), None);
        assert_eq!(cover(&Disk, &folder.path().join("none.hcbtf")), None);
        assert!(cover(&Disk, Path::new("example:hcbtf/pencil.hcbtf")).is_some());
    }
}
