//! A folder of images, one a sample.
//!
//! The name of a file gives its sample: `l2.3_v1.4.png` is seen with the light at ring 2, step 3,
//! and the view at ring 1, step 4. Or files are numbered (`brick-0001.png`), in the order of
//! [`Grid::addresses`]: the views one after the other, and for each all lights. Numbers begin at 0
//! if one of them is 0, and at 1 otherwise.
//!
//! Folders that Chiaro wrote have `hcbtf.json` beside the images, which contains the grid and the
//! other fields; for other folders the user must give the grid.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::{tr, trn};

use super::file::{idle_rules, read_bytes, tile};
use super::fill::{FilledSamples, MAX_SAMPLES, SampleChoice};
use super::listing::{self, Listing};
use super::picture::encode;
use super::report::FileReport;
use super::sheet::gathered;
use super::{MAX_PAINTED, MAX_PAINTED_BYTES};
use crate::diag::{Diagnostic, WithWarnings};
use crate::document::{Address, Direction, Directions, Grid, Hcbtf, Tile};
use crate::files::{Files, WalkBounds};
use crate::progress::Progress;

/// The name of the file of a sample's image.
pub fn file_name(Address { light, view }: Address) -> String {
    format!("l{light}_v{view}.png")
}

/// The address in a file's name, whether or not a grid contains it.
pub fn parse_name(name: &str) -> Option<Address> {
    let (light, view) = stem(name)?.strip_prefix('l')?.split_once("_v")?;
    let direction = |text: &str| {
        let (theta, phi) = text.split_once('.')?;
        let number =
            |text: &str| if text.starts_with('+') { None } else { text.parse::<u32>().ok() };
        Some(Direction { theta: number(theta)?, phi: number(phi)? })
    };
    Some(Address { light: direction(light)?, view: direction(view)? })
}

/// A PNG's name without its ending.
fn stem(name: &str) -> Option<&str> {
    let (stem, ending) = name.rsplit_once('.')?;
    ending.eq_ignore_ascii_case("png").then_some(stem)
}

/// The number at the end of a PNG's name.
fn number(name: &str) -> Option<u64> {
    let stem = stem(name)?;
    let digits = stem.trim_end_matches(|c: char| c.is_ascii_digit()).len();
    stem.get(digits..)?.parse().ok()
}

/// Bounds of looking at a folder: entries for all samples that rules fill, and as many others.
const BOUNDS: WalkBounds = WalkBounds { depth: 0, entries: 2 * MAX_SAMPLES as usize };

/// Reads a folder; files other than PNGs and `hcbtf.json`, and folders in it, are ignored. The grid
/// in an `hcbtf.json` takes precedence over `grid`.
///
/// # Errors
/// As [`import`], and where the folder cannot be read.
pub fn load(
    files: &dyn Files,
    folder: &Path,
    grid: Grid,
    progress: &Progress,
) -> Result<WithWarnings<Hcbtf>, Vec<Diagnostic>> {
    let name = folder.display().to_string();
    let found = files.walk(folder, BOUNDS, &|_| false);
    if let Some((_, error)) = found.unreadable.first() {
        let problem = Diagnostic::error("cannot-read", tr!("the folder cannot be read: {error}"));
        let hint = tr!("check the spelling, and whether you may read it");
        return Err(vec![problem.in_file(name).hint(hint)]);
    }
    if found.is_cut {
        let message = tr!("the folder holds more than {entries} entries", entries = BOUNDS.entries);
        let problem = Diagnostic::error("too-large", message);
        return Err(vec![
            problem.in_file(name).hint(tr!("name a folder that holds the images alone")),
        ]);
    }
    let plain = found.files.iter().filter(|path| files.has_file(path));
    let names = plain.filter_map(|path| Some(path.file_name()?.to_str()?.to_owned())).collect();
    import(
        names,
        &|file| read_bytes(files, &folder.join(file)).map_err(|problem| problem.message),
        grid,
        &name,
        progress,
    )
}

/// The grid in the `hcbtf.json` of a folder, if there is one.
pub(super) fn told_grid(files: &dyn Files, folder: &Path) -> Option<Grid> {
    let bytes = read_bytes(files, &folder.join(listing::NAME)).ok()?;
    listed(&bytes, &mut FileReport::new("")).map(|listing| listing.0.grid)
}

/// The content of an `hcbtf.json`.
fn listed(bytes: &[u8], report: &mut FileReport) -> Option<Listing> {
    if bytes.len() as u64 > listing::MAX_BYTES {
        let message = tr!(
            "`{name}` is larger than {most} MiB",
            name = listing::NAME,
            most = listing::MAX_BYTES >> 20
        );
        report.add(Diagnostic::error("too-large", message).hint(tr!("export the folder again")));
        return None;
    }
    listing::parse(bytes, report)
}

/// An HCBTF from images, whose bytes `read` gives by name; `folder` is the name of all of them
/// together in diagnostics. `progress` counts images.
///
/// # Errors
/// All errors that keep the images from being used, up to a bound, and where the work is stopped.
pub fn import(
    names: Vec<String>,
    read: &dyn Fn(&str) -> Result<Vec<u8>, String>,
    grid: Grid,
    folder: &str,
    progress: &Progress,
) -> Result<WithWarnings<Hcbtf>, Vec<Diagnostic>> {
    let mut report = FileReport::new(folder);
    let hcbtf = import_into(names, read, grid, &mut report, progress);
    report.finish(hcbtf)
}

fn import_into(
    mut names: Vec<String>,
    read: &dyn Fn(&str) -> Result<Vec<u8>, String>,
    grid: Grid,
    report: &mut FileReport,
    progress: &Progress,
) -> Option<Hcbtf> {
    if let Err(why) = grid.check() {
        report.add(Diagnostic::error("hcbtf-grid", why));
        return None;
    }
    let listing = match names.iter().find(|name| *name == listing::NAME) {
        Some(name) => Some(listed(&told(read(name), name, report)?, report)?),
        None => None,
    };
    let grid = listing.as_ref().map_or(grid, |listing| listing.0.grid);
    names.retain(|name| stem(name).is_some());
    names.sort();
    let placed = placed(&names, &grid, report)?;
    let is_painted = |name: &str| listing.as_ref().is_none_or(|listing| !listing.was_filled(name));
    check_count(placed.values().filter(|name| is_painted(name)).count(), &grid, report)?;
    let other_grid = listing.is_none().then(|| other_grid(&placed, &grid)).flatten();
    progress.begin(placed.len() as u64);
    let mut painted: Vec<(Address, Arc<Tile>)> = Vec::new();
    for (address, name) in placed.into_iter().take_while(|_| !progress.is_stopped()) {
        progress.add(1);
        let Some(png) = told(read(name), name, report) else { continue };
        let Some(tile) = tile(&png, grid.size, &format!("`{name}`"), report) else { continue };
        if listing.as_ref().is_some_and(|listing| listing.is_filled(name, &tile)) {
            continue;
        }
        painted.push((address, Arc::new(tile)));
        // Of the images that rules filled, any number may have been painted since the export.
        check_count(painted.len(), &grid, report)?;
    }
    if progress.is_stopped() {
        report.stop();
    }
    let mut hcbtf = gathered(grid, painted);
    if let Some(Listing(listing)) = listing {
        (hcbtf.is_tiling, hcbtf.rules) = (listing.is_tiling, listing.rules);
        hcbtf.unknown = listing.unknown;
    }
    if !report.has_errors() {
        other_grid.into_iter().for_each(|problem| report.add(problem));
        idle_rules(&hcbtf, report);
    }
    Some(hcbtf)
}

fn told(read: Result<Vec<u8>, String>, name: &str, report: &mut FileReport) -> Option<Vec<u8>> {
    let told = |why| {
        let problem = Diagnostic::error("cannot-read", tr!("`{name}` cannot be read: {why}"));
        report.add(problem.hint(tr!("name a folder whose files you may read")));
    };
    read.map_err(told).ok()
}

/// Refuses more painted samples than a file can hold.
fn check_count(painted: usize, grid: &Grid, report: &mut FileReport) -> Option<()> {
    let needed = painted as u64 * grid.texels() as u64 * 4;
    if painted <= MAX_PAINTED && needed <= MAX_PAINTED_BYTES {
        return Some(());
    }
    let message = tr!("{painted} images take {mib} MiB", mib = needed >> 20);
    let hint =
        tr!("at most {MAX_PAINTED} images and {most} MiB can be", most = MAX_PAINTED_BYTES >> 20);
    report.add(Diagnostic::error("too-large", message).hint(hint));
    None
}

/// The warning about images that seem to be of another grid: numbered ones whose number differs
/// from that of its samples, and named ones that are all samples of a smaller grid.
fn other_grid(placed: &BTreeMap<Address, &str>, grid: &Grid) -> Option<Diagnostic> {
    let found = placed.len() as u64;
    let told = |grid: &Grid| {
        let directions = |of: Directions| format!("{}x{}", of.theta, of.phi);
        format!(
            "{}x{},{},{}",
            grid.size[0],
            grid.size[1],
            directions(grid.light),
            directions(grid.view)
        )
    };
    let problem = |message: String, grid: &str| {
        let hint =
            tr!("name the grid that they were made with, on the command line as `--grid {grid}`");
        Some(Diagnostic::warning("hcbtf-other-grid", message).hint(hint))
    };
    if !placed.values().any(|name| parse_name(name).is_some()) {
        let samples = grid.sample_count();
        let images = trn!(found, "{found} numbered image", "{found} numbered images");
        let message =
            tr!("there are {images}, and the grid {grid} has {samples} samples", grid = told(grid));
        return if found == samples { None } else { problem(message, &told(&Grid::THESIS)) };
    }
    let spanned = |of: fn(&Address) -> Direction| {
        let most = |angle: fn(Direction) -> u32| {
            placed.keys().map(|address| angle(of(address))).max().unwrap_or(0) + 1
        };
        Directions {
            theta: most(|direction| direction.theta),
            phi: most(|direction| direction.phi),
        }
    };
    let smaller = Grid {
        light: spanned(|address| address.light),
        view: spanned(|address| address.view),
        ..*grid
    };
    // A few images that happen to be all samples of a tiny grid are no hint.
    let is_whole = |of: Directions| of.theta == 1 || of.phi >= 3;
    let is_smaller = smaller.sample_count() < grid.sample_count()
        && smaller.sample_count() == found
        && found > 1;
    if !is_smaller || !is_whole(smaller.light) || !is_whole(smaller.view) {
        return None;
    }
    let message = tr!(
        "the images are all {found} samples of the grid {smaller}, and they are taken for some of \
         {grid}",
        smaller = told(&smaller),
        grid = told(grid)
    );
    problem(message, &told(&smaller))
}

/// The file of each sample.
fn placed<'a>(
    names: &'a [String],
    grid: &Grid,
    report: &mut FileReport,
) -> Option<BTreeMap<Address, &'a str>> {
    let hint = tr!("name images like `l2.3_v1.4.png`, or number them");
    let named: Vec<(&str, Option<Address>)> =
        names.iter().map(|name| (name.as_str(), parse_name(name))).collect();
    let found: Vec<(&str, Option<Address>)> = if named.iter().any(|(_, address)| address.is_some())
    {
        named
    } else {
        let numbers: Vec<Option<u64>> = names.iter().map(|name| number(name)).collect();
        let first = u64::from(!numbers.contains(&Some(0)));
        let counts = usize::try_from(grid.sample_count()).unwrap_or(usize::MAX);
        // Only as many addresses as there are numbers: a grid can have billions of samples.
        let largest = numbers
            .iter()
            .flatten()
            .max()
            .map_or(0, |largest| (largest.saturating_add(1) - first).min(counts as u64));
        let addresses: Vec<Address> =
            grid.addresses().take((largest as usize).min(MAX_PAINTED)).collect();
        let address = |number: &u64| addresses.get(usize::try_from(number - first).ok()?).copied();
        let outside =
            Address { light: Direction { theta: u32::MAX, phi: 0 }, ..Address::default() };
        let numbered = numbers
            .iter()
            .map(|number| number.as_ref().map(|number| address(number).unwrap_or(outside)));
        names.iter().map(String::as_str).zip(numbered).collect()
    };
    let mut placed: BTreeMap<Address, &str> = BTreeMap::new();
    for (name, address) in found {
        let Some(address) = address else {
            let message = tr!("`{name}` does not say which sample it is; it is not used");
            report.add(Diagnostic::warning("hcbtf-stray", message).hint(hint));
            continue;
        };
        if !grid.contains(address) {
            let message = tr!(
                "`{name}` is outside the grid, which has {count} samples",
                count = grid.sample_count()
            );
            report.add(
                Diagnostic::error("out-of-range", message)
                    .hint(tr!("name the grid that the images were made with")),
            );
        } else if let Some(other) = placed.insert(address.canonical(), name) {
            let message = tr!(
                "`{other}` and `{name}` are both the sample at {address}",
                address = address.canonical()
            );
            let hint =
                tr!("at the normal there is one sample, whatever the step around it: remove one");
            report.add(Diagnostic::error("duplicate-sample", message).hint(hint));
        }
    }
    if placed.is_empty() && !report.has_errors() {
        report.add(
            Diagnostic::error("hcbtf-folder", tr!("there is no sample in this folder")).hint(hint),
        );
    }
    Some(placed)
}

/// The name and the text of the file that holds the fields that the images of [`export`] cannot.
pub fn listing(filled: &FilledSamples, which: SampleChoice) -> (&'static str, String) {
    (listing::NAME, listing::text(filled, which))
}

/// The paths of an earlier export's files in a folder: its `hcbtf.json`, and images that are named
/// as samples.
pub(super) fn exported(files: &dyn Files, folder: &Path) -> Vec<PathBuf> {
    let is_ours = |name: &str| name == listing::NAME || parse_name(name).is_some();
    let is_ours = |path: &PathBuf| {
        path.file_name().and_then(|name| name.to_str()).is_some_and(is_ours) && files.has_file(path)
    };
    files.walk(folder, BOUNDS, &|_| false).files.into_iter().filter(is_ours).collect()
}

/// The first PNG of a folder by name.
pub(super) fn first_image(files: &dyn Files, folder: &Path) -> Option<PathBuf> {
    let is_png =
        |path: &PathBuf| path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png"));
    files.walk(folder, BOUNDS, &|_| false).files.into_iter().find(is_png)
}

/// The name and the PNG of each sample, made one at a time.
pub fn export(
    filled: &FilledSamples,
    which: SampleChoice,
) -> impl Iterator<Item = Result<(String, Vec<u8>), Box<Diagnostic>>> {
    let taken = filled.iter().filter(move |(_, _, provenance)| which.has(provenance));
    taken.map(|(address, tile, _)| {
        let png = encode(tile.size(), tile.bytes());
        let cannot = |why| {
            Box::new(Diagnostic::error("cannot-write", tr!("the sample at {address}: {why}")))
        };
        Ok((file_name(address), png.map_err(cannot)?))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Directions;
    use crate::hcbtf::fill::fill;
    use crate::progress::Progress;

    fn grid() -> Grid {
        Grid {
            size: [2, 2],
            light: Directions { theta: 2, phi: 3 },
            view: Directions { theta: 2, phi: 2 },
        }
    }

    fn png(byte: u8) -> Vec<u8> {
        encode([2, 2], &[byte; 16]).unwrap()
    }

    fn read(names: &[&str]) -> Result<WithWarnings<Hcbtf>, Vec<Diagnostic>> {
        let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
        import(names, &|name| Ok(png(name.len() as u8)), grid(), "folder", &Progress::new())
    }

    #[test]
    fn names_say_addresses() {
        let address = Address::new([2, 3], [1, 4]);
        assert_eq!(file_name(address), "l2.3_v1.4.png");
        assert_eq!(parse_name("l2.3_v1.4.PNG"), Some(address));
        for odd in [
            "l2.3_v1.4",
            "l2.3_v1.png",
            "l2.3.4_v1.4.png",
            "l-2.3_v1.4.png",
            "l+2.3_v1.4.png",
            "x.png",
            "",
        ] {
            assert_eq!(parse_name(odd), None, "{odd}");
        }
        assert_eq!(number("brick-0012.png"), Some(12));
        assert_eq!(number("brick.png"), None);
        assert_eq!(number("99999999999999999999999.png"), None);
    }

    #[test]
    fn a_folder_comes_back_as_it_was() {
        let names: Vec<String> = grid().addresses().map(file_name).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).step_by(2).collect();
        let (hcbtf, notes) = read(&names).unwrap().into_parts();
        assert!(notes.is_empty() && hcbtf.painted.len() == 6, "{notes:?}");
        let filled = fill(&hcbtf, &Progress::new()).unwrap();
        let written: Vec<(String, Vec<u8>)> =
            export(&filled, SampleChoice::All).map(Result::unwrap).collect();
        assert_eq!(written.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(), names);
        let images: std::collections::HashMap<String, Vec<u8>> = written.into_iter().collect();
        let all = images.keys().cloned().collect();
        let back =
            import(all, &|name| Ok(images[name].clone()), grid(), "folder", &Progress::new())
                .unwrap();
        assert_eq!(back.value, hcbtf);
    }

    #[test]
    fn numbers_follow_the_grid_from_0_or_1() {
        let addresses: Vec<Address> = grid().addresses().collect();
        let numbers =
            |names: &[&str]| read(names).unwrap().value.painted.keys().copied().collect::<Vec<_>>();
        assert_eq!(
            numbers(&["b1.png", "b02.png", "b12.png"]),
            [addresses[0], addresses[1], addresses[11]]
        );
        assert_eq!(numbers(&["0.png", "11.png"]), [addresses[0], addresses[11]]);
        let told = |names: &[&str]| read(names).unwrap_err()[0].to_string();
        assert!(told(&["0.png", "12.png"]).contains("out-of-range"));
        assert!(told(&["18446744073709551615.png"]).contains("out-of-range"));
        assert!(told(&["1.png", "01.png"]).contains("duplicate-sample"));
        assert!(told(&["l0.1_v0.0.png", "l0.0_v0.1.png"]).contains("duplicate-sample"));
        assert!(told(&["l9.1_v0.0.png"]).contains("out-of-range"));
        assert!(told(&["x.jpg"]).contains("no sample"));
        let (hcbtf, notes) =
            read(&["l1.1_v0.0.png", "sketch.png", "notes.txt"]).unwrap().into_parts();
        assert!(hcbtf.painted.len() == 1 && notes[0].code == "hcbtf-stray" && notes.len() == 1);
    }

    #[test]
    fn images_of_another_size_are_told() {
        let names = vec!["1.png".to_owned(), "2.png".to_owned()];
        let wrong =
            import(names, &|_| encode([3, 2], &[0; 24]), grid(), "folder", &Progress::new())
                .unwrap_err();
        assert_eq!(wrong.len(), 2);
        assert!(
            wrong[1].message.contains("`2.png` cannot be used: it has 3 x 2 texels"),
            "{wrong:?}"
        );
        let unread = import(
            vec!["1.png".to_owned()],
            &|_| Err("gone".to_owned()),
            grid(),
            "folder",
            &Progress::new(),
        )
        .unwrap_err();
        assert!(unread[0].message.contains("`1.png` cannot be read: gone"));
    }
}
