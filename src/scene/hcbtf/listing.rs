//! `hcbtf.json`, the listing beside the images of a folder, with the fields that images cannot
//! hold.
//!
//! The listing has the fields of an `.hcbtf` file's manifest (grid, tiling, rules), and lists the
//! images that rules filled with a digest of each. An image that is not listed, or was painted over
//! since, is painted; the others are left to the rules. So a folder is read back as it was
//! exported, and an image that somebody changed or added in another program as painted.

use indexmap::IndexMap;

use super::fill::{FilledSamples, SampleChoice};
use super::folder::file_name;
use super::manifest;
use super::report::FileReport;
use crate::document::{HcbtfListing, Tile};

/// Name of the listing in the folder.
pub(super) const NAME: &str = "hcbtf.json";
/// Greatest length of a listing that is read, in bytes: the most samples that can be filled need
/// less.
pub(super) const MAX_BYTES: u64 = 64 << 20;

/// Content of a listing.
pub(super) struct Listing(pub(super) HcbtfListing);

impl Listing {
    /// True if an image still is what rules filled it with.
    pub(super) fn is_filled(&self, file: &str, tile: &Tile) -> bool {
        self.0.filled.get(file).is_some_and(|digest| *digest == tile.digest())
    }

    /// True if rules filled an image when it was written, whatever has become of it since.
    pub(super) fn was_filled(&self, file: &str) -> bool {
        self.0.filled.contains_key(file)
    }
}

/// The text of the listing for these samples.
pub(super) fn text(filled: &FilledSamples, which: SampleChoice) -> String {
    let taken = filled.iter().filter(|(_, _, provenance)| {
        which.has(provenance) && !SampleChoice::Painted.has(provenance)
    });
    // Many samples share a tile, so each tile's digest is computed once.
    let digests: Vec<u64> = filled.tiles().iter().map(|tile| tile.digest()).collect();
    let digest_of = |(address, _, _)| {
        let digest = digests.get(filled.tile_index(address)?)?;
        Some((file_name(address), *digest))
    };
    let listing = HcbtfListing {
        grid: filled.grid(),
        is_tiling: filled.is_tiling(),
        rules: filled.rules().to_vec(),
        filled: taken.filter_map(digest_of).collect::<IndexMap<String, u64>>(),
        unknown: filled.unknown().clone(),
    };
    listing.to_text()
}

/// Reads a listing; all errors go to the report.
pub(super) fn parse(text: &[u8], report: &mut FileReport) -> Option<Listing> {
    report.reads(NAME);
    manifest::document(text, HcbtfListing::read, report).map(Listing)
}

#[cfg(test)]
mod tests {
    use std::collections::HashMap;
    use std::sync::Arc;

    use super::*;
    use crate::document::{Address, Directions, Grid, Hcbtf, Rule};
    use crate::hcbtf::fill::fill;
    use crate::hcbtf::folder;
    use crate::progress::Progress;

    fn painted() -> Hcbtf {
        let light = Directions { theta: 2, phi: 3 };
        let mut hcbtf = Hcbtf::new(Grid { size: [2, 2], light, view: light });
        hcbtf.is_tiling = false;
        // The third sample is transparent all over, and painted nevertheless.
        for (light, color) in
            [([0, 0], [200, 10, 10, 255]), ([1, 1], [0, 40, 90, 128]), ([1, 2], [0; 4])]
        {
            hcbtf
                .painted
                .insert(Address::new(light, [1, 2]), Arc::new(Tile::filled([2, 2], color)));
        }
        hcbtf.rules =
            vec![Rule::Blend { sharpness: 2.0 }, Rule::Lambert { shadow: [0; 3], amount: 0.5 }];
        hcbtf
    }

    #[test]
    fn what_was_exported_comes_back_and_what_was_changed_is_painted() {
        let mut hcbtf = painted();
        let later = serde_json::json!({ "0": { "later": 7 } });
        hcbtf.unknown.insert("rules".to_owned(), later);
        let filled = fill(&hcbtf, &Progress::new()).unwrap();
        let (name, text) = folder::listing(&filled, SampleChoice::All);
        let mut files: HashMap<String, Vec<u8>> =
            folder::export(&filled, SampleChoice::All).map(Result::unwrap).collect();
        files.insert(name.to_owned(), text.into_bytes());
        let import = |files: &HashMap<String, Vec<u8>>| {
            let read = |name: &str| Ok(files[name].clone());
            folder::import(
                files.keys().cloned().collect(),
                &read,
                Grid::THESIS,
                "folder",
                &Progress::new(),
            )
        };
        let back = import(&files).unwrap();
        assert_eq!((back.value, back.warnings.len()), (hcbtf.clone(), 1));
        assert_eq!(back.warnings[0].place.json_path.as_deref(), Some("rules[0].later"));
        // An image that another program rewrote, with other colors in its transparent texels, is
        // the same; a visible change of color makes another image.
        let address = Address::new([1, 0], [0, 0]);
        let file = file_name(address);
        let tile = filled.tile(address).unwrap();
        let mut rgba = tile.bytes().to_vec();
        files.insert(file.clone(), super::super::picture::encode([2, 2], &rgba).unwrap());
        assert_eq!(import(&files).unwrap().value, hcbtf);
        rgba[0] ^= 1;
        files.insert(file.clone(), super::super::picture::encode([2, 2], &rgba).unwrap());
        let changed = import(&files).unwrap().value;
        assert_eq!(changed.painted.len(), 4);
        assert_eq!(changed.painted(address).unwrap().bytes(), rgba);
        // A painting that was thrown away is no longer painted.
        files.remove(&file_name(Address::new([0, 0], [1, 2])));
        assert_eq!(import(&files).unwrap().value.painted.len(), 3);
    }

    #[test]
    fn what_lies_is_told() {
        let filled = fill(&painted(), &Progress::new()).unwrap();
        let (_, text) = folder::listing(&filled, SampleChoice::All);
        let told = |text: &str| {
            let mut report = FileReport::new("folder");
            let listing = parse(text.as_bytes(), &mut report);
            (
                listing.is_some(),
                report.finish(Some(())).map_or_else(|all| all, |warned| warned.warnings),
            )
        };
        assert_eq!(told(&text), (true, vec![]));
        for (text, code) in [
            ("{", "truncated"),
            ("[]", "wrong-document"),
            ("{}", "missing-field"),
            (&text.replace("\"version\": 1", "\"version\": 99"), "newer-version"),
            (&text.replace("\"phi\": 3", "\"phi\": 0"), "out-of-range"),
            (&text.replace("\"blend\"", "\"blnd\""), "unknown-word"),
            (&text.replace("\"filled\": {", "\"painted\": [], \"filled\": {"), "unknown-field"),
            (&text.replace("\"hcbtf\"", "\"look\""), "wrong-document"),
        ] {
            let (_, problems) = told(text);
            assert_eq!(problems[0].code, code, "{problems:?}");
            assert!(problems[0].message.contains("`hcbtf.json`"), "{problems:?}");
        }
        let tile = Tile::filled([2, 2], [7, 8, 9, 0]);
        assert_eq!(tile.digest(), Tile::filled([2, 2], [1, 2, 3, 0]).digest(), "nobody sees it");
        assert_ne!(tile.digest(), Tile::filled([2, 2], [7, 8, 9, 1]).digest());
    }
}
