//! The `.hcbtf` file: a zip with [`manifest`], a PNG for each painted sample, and a thumbnail.
//!
//! The file holds only the painted samples and the rules; samples that the rules fill are derived
//! again, so a file stays small and a rule can be changed years later.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::path::Path;
use std::sync::Arc;

use chiaro_locale::tr;
use rayon::iter::{IntoParallelIterator as _, ParallelIterator as _};

use super::archive::{Archive, ArchiveWriter};
use super::manifest::{self, MAX_MANIFEST_BYTES, NAME, SAMPLES, THUMBNAIL, sample_name};
use super::picture::{MAX_PNG_EXTRAS, decode, encode, reduced};
use super::report::FileReport;
use super::{MAX_FILE_BYTES, MAX_PAINTED, MAX_PAINTED_BYTES, MAX_RULES};
use crate::diag::{Diagnostic, WithWarnings};
use crate::document::{Address, Hcbtf, HcbtfManifest, PaintedSample, Rule, Tile};
use crate::files::{Files, ReadError};

/// Longer side of a thumbnail, in texels.
const THUMBNAIL_SIDE: u32 = 256;

/// Reads the `.hcbtf` file at `path`.
///
/// # Errors
/// As [`read`], and where the file cannot be read.
pub fn load(files: &dyn Files, path: &Path) -> Result<WithWarnings<Hcbtf>, Vec<Diagnostic>> {
    let bytes = read_bytes(files, path).map_err(|problem| vec![*problem])?;
    read(&bytes, &path.display().to_string())
}

/// The bytes of a file of at most [`MAX_FILE_BYTES`]: an HCBTF, a sheet, or a sample; or those of
/// an [example](chiaro_compiler::examples).
///
/// # Errors
/// The reason why the file cannot be read, with its name.
pub fn read_bytes(files: &dyn Files, path: &Path) -> Result<Vec<u8>, Box<Diagnostic>> {
    let fail = |code, message: String, hint: &str| {
        Box::new(Diagnostic::error(code, message).in_file(path.display().to_string()).hint(hint))
    };
    files.read(path, MAX_FILE_BYTES).map_err(|error| match error {
        ReadError::TooLarge { .. } => {
            let message = tr!("the file is larger than {most} MiB", most = MAX_FILE_BYTES >> 20);
            fail(
                "too-large",
                message,
                tr!("take a coarser grid, or fill by rules what is painted now"),
            )
        }
        error => {
            let hint = if files.metadata(path).is_some() {
                tr!("name a file that you may read")
            } else {
                tr!("check the spelling and the folder")
            };
            fail("cannot-read", tr!("cannot read the file: {error}"), hint)
        }
    })
}

/// Reads an `.hcbtf` file, with warnings about its oddities. `name` is the file's name in
/// diagnostics.
///
/// # Errors
/// All errors that keep the file from being used, up to a bound: no part of the file is taken then,
/// since saving it would lose the rest.
pub fn read(bytes: &[u8], name: &str) -> Result<WithWarnings<Hcbtf>, Vec<Diagnostic>> {
    let mut report = FileReport::new(name);
    let hcbtf = read_into(bytes, &mut report);
    report.finish(hcbtf)
}

fn read_into(bytes: &[u8], report: &mut FileReport) -> Option<Hcbtf> {
    if bytes.len() as u64 > MAX_FILE_BYTES {
        report.add(Diagnostic::error(
            "too-large",
            tr!("the file is larger than {most} MiB", most = MAX_FILE_BYTES >> 20),
        ));
        return None;
    }
    let mut archive = told(Archive::open(bytes), report)?;
    if !archive.has(NAME) {
        let problem = Diagnostic::error(
            "hcbtf-manifest",
            tr!("the zip file holds no `{NAME}`, so it is no painted surface (HCBTF)"),
        );
        report.add(problem.hint(tr!("`{NAME}` lies at the top of the zip, not in a folder of it")));
        return None;
    }
    let text = told(archive.read(NAME, MAX_MANIFEST_BYTES), report)?;
    let HcbtfManifest { grid, is_tiling, rules, painted, unknown } =
        manifest::parse(&text, report)?;
    let needed = painted.len() as u64 * grid.texels() as u64 * 4;
    if needed > MAX_PAINTED_BYTES {
        report.add(too_much(needed));
        return None;
    }
    told_of_strays(&archive, &painted, report);
    let painted = samples(&mut archive, painted, grid.size, report);
    let hcbtf = Hcbtf { grid, is_tiling, painted, rules, unknown };
    if !report.has_errors() {
        idle_rules(&hcbtf, report);
    }
    Some(hcbtf)
}

fn told<T>(result: Result<T, Diagnostic>, report: &mut FileReport) -> Option<T> {
    result.map_err(|problem| report.add(problem)).ok()
}

fn too_much(bytes: u64) -> Diagnostic {
    let (bytes, most) = (bytes >> 20, MAX_PAINTED_BYTES >> 20);
    let message = tr!("the painted samples take {bytes} MiB; at most {most} MiB can be");
    Diagnostic::error("too-large", message)
        .hint(tr!("take a coarser grid, or fill by rules what is painted now"))
}

/// Warns of PNGs that the manifest does not name: somebody put them there and expects to see them.
fn told_of_strays(archive: &Archive<'_>, painted: &[PaintedSample], report: &mut FileReport) {
    if archive.has_duplicates() {
        let message = tr!("the zip file has two entries of one name; the last is taken");
        report.add(Diagnostic::warning("hcbtf-archive", message).hint(tr!("remove one of them")));
    }
    let named: HashSet<&str> = painted.iter().map(|listed| listed.file.as_str()).collect();
    let is_stray = |name: &String| {
        name.starts_with(SAMPLES) && !name.ends_with('/') && !named.contains(name.as_str())
    };
    for name in archive.names().filter(is_stray) {
        let message =
            tr!("`{name}` is not listed in `{NAME}`; it is not used, and saving loses it");
        let hint = tr!("add it to `painted`, or import it with `chiaro hcbtf import`");
        report.add(Diagnostic::warning("hcbtf-stray", message).hint(hint));
    }
}

/// Reads all painted samples, as many as can be read.
fn samples(
    archive: &mut Archive<'_>,
    painted: Vec<PaintedSample>,
    size: [u32; 2],
    report: &mut FileReport,
) -> BTreeMap<Address, Arc<Tile>> {
    let mut tiles: HashMap<String, Option<Arc<Tile>>> = HashMap::new();
    let mut samples: BTreeMap<Address, (Arc<Tile>, String)> = BTreeMap::new();
    for sample in painted {
        let address = sample.address();
        let file = sample.file;
        if let Some((_, other)) = samples.get(&address) {
            let message = tr!("`{other}` and `{file}` are both the sample at {address}");
            let hint =
                tr!("at the normal there is one sample, whatever the step around it: remove one \
                        from `painted`");
            report.add(Diagnostic::error("duplicate-sample", message).hint(hint));
            continue;
        }
        // A file may be named twice; it is unpacked, and reported on, once.
        let tile =
            tiles.entry(file.clone()).or_insert_with(|| tile_of(archive, &file, size, report));
        if let Some(tile) = tile {
            samples.insert(address, (tile.clone(), file));
        }
    }
    samples.into_iter().map(|(address, (tile, _))| (address, tile)).collect()
}

fn tile_of(
    archive: &mut Archive<'_>,
    file: &str,
    size: [u32; 2],
    report: &mut FileReport,
) -> Option<Arc<Tile>> {
    let most = u64::from(size[0]) * u64::from(size[1]) * 8 + MAX_PNG_EXTRAS;
    let png = told(archive.read(file, most), report)?;
    let tile = tile(&png, size, &format!("`{file}`"), report);
    tile.map(Arc::new)
}

/// The texels of a sample from its PNG; `what` is the name of the sample in reports.
pub(super) fn tile(
    png: &[u8],
    size: [u32; 2],
    what: &str,
    report: &mut FileReport,
) -> Option<Tile> {
    let accept = |[width, height]: [u32; 2]| {
        let message = || {
            tr!(
                "it has {width} x {height} texels; the grid's tiles have {grid_width} x \
                 {grid_height}",
                grid_width = size[0],
                grid_height = size[1]
            )
        };
        if [width, height] == size { Ok(()) } else { Err(message()) }
    };
    match decode(png, accept) {
        Ok(decoded) => {
            if decoded.had_16_bits {
                report.add(reduced(what));
            }
            Tile::new(decoded.picture.size, decoded.picture.rgba)
        }
        Err(why) => {
            let problem = Diagnostic::error("hcbtf-sample", tr!("{what} cannot be used: {why}"));
            report.add(problem.hint(tr!("export the sample again as a PNG of the tile's size")));
            None
        }
    }
}

/// Warns of rules that copy a sample that is not painted.
pub(super) fn idle_rules(hcbtf: &Hcbtf, report: &mut FileReport) {
    for (index, rule) in hcbtf.rules.iter().enumerate() {
        let needed = match rule {
            Rule::Copy { from } | Rule::Specular { from, .. } => vec![*from],
            Rule::Relief(relief) => relief.painted().collect(),
            _ => Vec::new(),
        };
        if let Some(from) = needed.into_iter().find(|from| hcbtf.painted(*from).is_none()) {
            let message = tr!(
                "this rule takes the sample at {from}, which is not painted, so it fills nothing"
            );
            let problem = Diagnostic::warning("hcbtf-idle-rule", message)
                .json_path(format!("rules[{index}]"));
            report.add(problem.hint(tr!("paint the sample, or let the rule take another")));
        }
    }
}

/// The bytes of the file: equal for equal HCBTFs, on every machine.
///
/// # Errors
/// The reasons why the file could not be read again, such as a tile of another size or more than
/// the bounds of this module.
pub fn write(hcbtf: &Hcbtf) -> Result<Vec<u8>, Box<Diagnostic>> {
    check(hcbtf)?;
    let cannot = |why: String| {
        let message = tr!("the painted surface (HCBTF) cannot be packed: {why}");
        Box::new(Diagnostic::error("cannot-write", message))
    };
    let text = manifest::text(hcbtf);
    let painted: Vec<(&Address, &Arc<Tile>)> = hcbtf.painted.iter().collect();
    let pngs = painted
        .into_par_iter()
        .map(|(address, tile)| Ok((sample_name(*address), encode(tile.size(), tile.bytes())?)));
    let pngs: Vec<(String, Vec<u8>)> = pngs.collect::<Result<_, String>>().map_err(cannot)?;
    let thumbnail = thumbnail(hcbtf)
        .map(|tile| encode(tile.size(), tile.bytes()))
        .transpose()
        .map_err(cannot)?;
    pack(&text, thumbnail.as_deref(), &pngs).map_err(|error| cannot(error.to_string()))
}

fn pack(
    text: &str,
    thumbnail: Option<&[u8]>,
    pngs: &[(String, Vec<u8>)],
) -> Result<Vec<u8>, zip::result::ZipError> {
    let mut writer = ArchiveWriter::new();
    writer.text(NAME, text)?;
    if let Some(png) = thumbnail {
        writer.packed(THUMBNAIL, png)?;
    }
    for (name, png) in pngs {
        writer.packed(name, png)?;
    }
    writer.finish()
}

/// Checks that the file could be read again.
fn check(hcbtf: &Hcbtf) -> Result<(), Box<Diagnostic>> {
    let fail = |code, message: String| Err(Box::new(Diagnostic::error(code, message)));
    hcbtf.grid.check().or_else(|why| fail("hcbtf-grid", why))?;
    for (name, count, most) in
        [("samples", hcbtf.painted.len(), MAX_PAINTED), ("rules", hcbtf.rules.len(), MAX_RULES)]
    {
        if count > most {
            return fail("too-many", tr!("there are {count} {name}; a file holds at most {most}"));
        }
    }
    for (index, rule) in hcbtf.rules.iter().enumerate() {
        rule.check(&hcbtf.grid).or_else(|why| {
            fail("hcbtf-rule", tr!("rule {index}, {rule}: {why}", rule = rule.word()))
        })?;
    }
    for (address, tile) in &hcbtf.painted {
        if !hcbtf.grid.contains(*address) || address.canonical() != *address {
            return fail("out-of-range", tr!("there is no sample at {address} in the grid"));
        }
        if tile.size() != hcbtf.grid.size {
            let ([width, height], [w, h]) = (tile.size(), hcbtf.grid.size);
            return fail(
                "hcbtf-sample",
                tr!("the sample at {address} is {width} x {height}, the grid's tiles {w} x {h}"),
            );
        }
    }
    let bytes = hcbtf.painted.len() as u64 * hcbtf.grid.texels() as u64 * 4;
    if bytes > MAX_PAINTED_BYTES { Err(Box::new(too_much(bytes))) } else { Ok(()) }
}

/// The painted sample that is viewed and lit most nearly along the normal, made smaller where it is
/// large.
fn thumbnail(hcbtf: &Hcbtf) -> Option<Tile> {
    let nearest = |address: &Address| (address.view.theta + address.light.theta, *address);
    let tile =
        hcbtf.painted.iter().min_by_key(|(address, _)| nearest(address)).map(|(_, tile)| tile)?;
    let longer = tile.size()[0].max(tile.size()[1]);
    let factor = longer.div_ceil(THUMBNAIL_SIDE).max(1);
    Some(shrunk(tile, factor))
}

/// The tile made smaller: means of `factor` x `factor` texels, weighted by alpha.
fn shrunk(tile: &Tile, factor: u32) -> Tile {
    let [width, height] = tile.size();
    let size = [width.div_ceil(factor), height.div_ceil(factor)];
    let mut rgba = Vec::with_capacity(4 * size[0] as usize * size[1] as usize);
    for (y, x) in (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (y, x))) {
        let (mut sums, mut count) = ([0_u64; 4], 0);
        for row in y * factor..((y + 1) * factor).min(height) {
            for column in x * factor..((x + 1) * factor).min(width) {
                let [r, g, b, a] = tile.texel(i64::from(column), i64::from(row)).map(u64::from);
                count += 1;
                sums = [sums[0] + r * a, sums[1] + g * a, sums[2] + b * a, sums[3] + a];
            }
        }
        let [r, g, b, a] = sums;
        let mean = |sum: u64| ((sum + a / 2) / a.max(1)) as u8;
        rgba.extend([mean(r), mean(g), mean(b), ((a + count / 2) / count.max(1)) as u8]);
    }
    Tile::new(size, rgba).unwrap_or_else(|| Tile::filled(size, [0; 4]))
}
