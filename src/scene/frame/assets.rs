//! Meshes and images, read once and kept while their files stay the same.

use std::borrow::Cow;
use std::collections::{BTreeMap, HashMap};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::store::{AssetStore, FileStamp, HcbtfKey};
use crate::diag::{Diagnostic, Warned};
use crate::document::{Address, Directions, Grid, Hcbtf, Tile};
use crate::files::{self, ReadError};
use crate::geometry::{self, Mesh};
use crate::hcbtf::{self, Coding, FilledSamples, LayerOptions, Layers, Region};
use crate::progress::Progress;

/// What an object's mesh begins with where it is an own shape.
pub const SHAPE_PREFIX: &str = "shape:";
/// What looks call the HCBTF that is being painted, while that has no file.
pub const UNSAVED_HCBTF: &str = "hcbtf:open";
/// The largest image, in pixels along a side; a GPU may allow less.
pub const MAX_IMAGE_SIDE: u32 = 16_384;
/// The most memory that decoding one image may take, in bytes.
const MAX_IMAGE_BYTES: u64 = 1 << 30;

/// A decoded image: straight RGBA, 8 bits a channel, rows from the top, layer after layer.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// Pixels.
    pub size: [u32; 2],
    /// 1 for a flat image.
    pub layers: u32,
    /// How pixels are put down.
    pub coding: Coding,
    /// Pixels, or blocks of them.
    pub bytes: Vec<u8>,
    /// Of the content, for caches.
    pub hash: u64,
    /// What it was before, where little of it is another now.
    pub change: Option<Change>,
}

/// From one image to the next.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// The hash of the image before.
    pub from: u64,
    /// What may be another now.
    pub regions: Vec<Region>,
}

impl Image {
    /// One pixel, standing in for an image that could not be read.
    pub fn single(rgba: [u8; 4]) -> Self {
        Self::flat([1, 1], rgba.to_vec())
    }

    fn flat(size: [u32; 2], rgba: Vec<u8>) -> Self {
        Self::new(Layers { size, count: 1, coding: Coding::Rgba8, bytes: rgba })
    }

    fn new(layers: Layers) -> Self {
        let Layers { size, count, coding, bytes } = layers;
        let mut hasher = DefaultHasher::new();
        (size, count, coding, &bytes).hash(&mut hasher);
        Self { size, layers: count, coding, bytes, hash: hasher.finish(), change: None }
    }

    /// Four bytes a pixel.
    pub fn rgba(&self) -> Cow<'_, [u8]> {
        self.coding.rgba(self.size, &self.bytes)
    }
}

/// An asset that a picture uses.
#[derive(Clone, Debug)]
struct UsedAsset<T> {
    stamp: FileStamp,
    warned: Warned<Arc<T>>,
    /// The round in which it was asked for last.
    round: u64,
}

impl<T> UsedAsset<T> {
    /// The asset, where its file is as it was.
    fn at(&mut self, stamp: FileStamp, round: u64) -> Option<Warned<Arc<T>>> {
        self.round = round;
        (self.stamp == stamp).then(|| self.warned.clone())
    }
}

/// What none of so many pictures used is dropped.
const MOST_ROUNDS: u64 = 16;

/// An HCBTF as it is being painted, in place of what its file holds.
#[derive(Clone, Debug)]
pub struct Overlay {
    /// Its file, once there is one; [`UNSAVED_HCBTF`] names it also before.
    pub path: Option<PathBuf>,
    /// Another number is another content.
    pub version: u64,
    /// What is painted.
    pub hcbtf: Arc<Hcbtf>,
    /// What the rules made of the rest, as far as that is known.
    pub filled: Option<Arc<FilledSamples>>,
}

impl Overlay {
    /// Whether a look that names `path` means it.
    fn is(&self, path: &Path) -> bool {
        let real = |path: &Path| path.canonicalize().ok();
        let is_it =
            |own: &Path| own == path || real(path).is_some_and(|found| Some(found) == real(own));
        path.ends_with(UNSAVED_HCBTF) || self.path.as_deref().is_some_and(is_it)
    }

    fn tile(&self, address: Address) -> Option<&Arc<Tile>> {
        self.hcbtf.painted(address).or_else(|| self.filled.as_ref()?.tile(address))
    }

    fn bake(&self, options: LayerOptions) -> Result<Image, Diagnostic> {
        let grid = self.hcbtf.grid;
        hcbtf::check_layers(&grid, options.has_levels)?;
        let layers = hcbtf::layers(&grid, |address| self.tile(address), options);
        let hash = self.hash(options);
        Ok(Image { hash, ..Image::new(layers) })
    }

    /// While it is painted on it is baked again and again: its number tells it from the last one.
    fn hash(&self, options: LayerOptions) -> u64 {
        let mut hasher = DefaultHasher::new();
        ("overlay", self.version, options).hash(&mut hasher);
        hasher.finish()
    }

    /// Brings what was baked of the overlay before up to date, where few texels are others now.
    /// Returns whether it did.
    fn rebake(&self, before: &Self, image: &mut Arc<Image>, options: LayerOptions) -> bool {
        let grid = self.hcbtf.grid;
        if grid != before.hcbtf.grid {
            return false;
        }
        let texels = grid.texels() as u64;
        // All smaller levels of a sample are put anew.
        let levels = if options.has_levels { texels.div_ceil(3) } else { 0 };
        let most = grid.sample_count() * (texels + levels) / REBAKED;
        let mut count = 0;
        let empty = Arc::new(Tile::filled(grid.size, [0; 4]));
        let mut changed = Vec::new();
        for address in grid.addresses() {
            let tile = |overlay: &Self| overlay.tile(address).unwrap_or(&empty).clone();
            let (old, new) = (tile(before), tile(self));
            if !Arc::ptr_eq(&old, &new)
                && let Some(part) = new.difference(&old)
            {
                count += u64::from(part[2]) * u64::from(part[3]) + levels;
                changed.push((address, new, part));
            }
            if count > most {
                return false;
            }
        }
        // Whoever still draws with the old one keeps it.
        let image = Arc::make_mut(image);
        let repaint = |(address, tile, part): (Address, Arc<Tile>, [u32; 4])| {
            hcbtf::repaint(&mut image.bytes, &grid, options, address, (&tile, part))
        };
        let regions = together(changed.into_iter().flat_map(repaint));
        image.change = Some(Change { from: image.hash, regions });
        image.hash = self.hash(options);
        true
    }
}

/// Directions of lights, and of views, in a draft, at most.
const DRAFT: Directions = Directions { theta: 3, phi: 4 };

/// Where more than one texel of so many is another, all are baked anew.
const REBAKED: u64 = 8;

/// Regions of a layer that overlap become one around them: all samples of a view lie in the same
/// one, light by light.
fn together(regions: impl Iterator<Item = Region>) -> Vec<Region> {
    let mut layers: BTreeMap<u32, Vec<Region>> = BTreeMap::new();
    for region in regions {
        let known = layers.entry(region.layer).or_default();
        match known.iter_mut().find(|known| overlap(known, &region)) {
            Some(known) => *known = around(known, &region),
            None => known.push(region),
        }
    }
    layers.into_values().flatten().collect()
}

fn overlap(one: &Region, other: &Region) -> bool {
    (0..2).all(|axis| {
        one.at[axis] < other.at[axis] + other.size[axis]
            && other.at[axis] < one.at[axis] + one.size[axis]
    })
}

fn around(one: &Region, other: &Region) -> Region {
    let at = [0, 1].map(|axis| one.at[axis].min(other.at[axis]));
    let end = |axis: usize| (one.at[axis] + one.size[axis]).max(other.at[axis] + other.size[axis]);
    Region { layer: one.layer, at, size: [0, 1].map(|axis| end(axis) - at[axis]) }
}

/// Reads meshes and images, each once, and holds what a picture uses; what is read is shared with
/// all who have the same [`AssetStore`].
#[derive(Clone, Debug, Default)]
pub struct Assets {
    store: AssetStore,
    /// Counts pictures.
    round: u64,
    overlay: Option<Overlay>,
    /// Whether what rules make is made for few directions alone.
    drafts: bool,
    /// Who watches HCBTFs being filled.
    progress: Progress,
    /// What was baked of it, or of what it was before.
    baked: HashMap<LayerOptions, (Overlay, Arc<Image>)>,
    meshes: HashMap<String, UsedAsset<Mesh>>,
    images: HashMap<PathBuf, UsedAsset<Image>>,
    hcbtfs: HashMap<HcbtfKey, UsedAsset<Image>>,
}

impl Assets {
    /// Nothing is used yet; what is read is shared with all who have the same store.
    pub fn of(store: &AssetStore) -> Self {
        Self { store: store.clone(), ..Self::default() }
    }

    /// Shares what is read from now on with all who have the same store.
    pub fn share(&mut self, store: &AssetStore) {
        if !self.store.is_same(store) {
            self.store = store.clone();
        }
    }

    /// Another picture begins: what none of the last few used is dropped.
    pub fn begin_picture(&mut self) {
        self.round += 1;
        let least = self.round.saturating_sub(MOST_ROUNDS);
        self.meshes.retain(|_, used| used.round >= least);
        self.images.retain(|_, used| used.round >= least);
        self.hcbtfs.retain(|_, used| used.round >= least);
    }

    /// The mesh that `name` means, a path relative to `folder` or `shape:` and an own shape, with
    /// what was odd in it.
    ///
    /// # Errors
    /// Why it cannot be used.
    pub fn mesh(
        &mut self,
        folder: &Path,
        name: &str,
    ) -> Result<Warned<Arc<Mesh>>, Vec<Diagnostic>> {
        if let Some(shape) = name.strip_prefix(SHAPE_PREFIX) {
            return Ok(self.shape(shape)?.into());
        }
        let path = folder.join(name);
        let key = path.display().to_string();
        let (stamp, round) = (stamp(&path), self.round);
        if let Some(known) = self.meshes.get_mut(&key).and_then(|used| used.at(stamp, round)) {
            return Ok(known);
        }
        let warned = self.store.mesh(&key, stamp, || geometry::load(&path))?;
        self.meshes.insert(key, UsedAsset { stamp, warned: warned.clone(), round });
        Ok(warned)
    }

    /// Every file that was read: meshes, images and HCBTFs.
    pub fn files(&self) -> impl Iterator<Item = &Path> {
        let meshes =
            self.meshes.keys().filter(|name| !name.starts_with(SHAPE_PREFIX)).map(Path::new);
        let images = self.images.keys().map(PathBuf::as_path);
        meshes.chain(images).chain(self.hcbtfs.keys().map(|key| key.path.as_path()))
    }

    fn shape(&mut self, name: &str) -> Result<Arc<Mesh>, Vec<Diagnostic>> {
        let key = format!("{SHAPE_PREFIX}{name}");
        let round = self.round;
        if let Some(known) = self.meshes.get_mut(&key).and_then(|used| used.at(None, round)) {
            return Ok(known.value);
        }
        let shape = || {
            if let Some(mesh) = geometry::shape(name) {
                return Ok(mesh.into());
            }
            let known = geometry::SHAPES.iter().map(|shape| shape.name);
            let names: Vec<&str> = known.clone().collect();
            let problem =
                Diagnostic::error("unknown-shape", format!("there is no own shape `{name}`"));
            Err(vec![
                problem.suggest(name, known).hint(format!("the shapes are {}", names.join(", "))),
            ])
        };
        let warned = self.store.mesh(&key, None, shape)?;
        self.meshes.insert(key, UsedAsset { stamp: None, warned: warned.clone(), round });
        Ok(warned.value)
    }

    /// The image at `path`, relative to `folder`.
    ///
    /// # Errors
    /// Why it cannot be used; the caller adds who names it.
    pub fn image(&mut self, folder: &Path, path: &str) -> Result<Arc<Image>, Diagnostic> {
        let path = folder.join(path);
        let (stamp, round) = (stamp(&path), self.round);
        if let Some(known) = self.images.get_mut(&path).and_then(|used| used.at(stamp, round)) {
            return Ok(known.value);
        }
        let value = self.store.image(&path, stamp, || read_image(&path))?;
        self.images.insert(path, UsedAsset { stamp, warned: value.clone().into(), round });
        Ok(value)
    }

    /// Shows an HCBTF as it is being painted wherever its file is named, from now on; with `None`
    /// files are as they are.
    pub fn overlay(&mut self, overlay: Option<Overlay>) {
        if overlay.is_none() {
            self.baked.clear();
        }
        self.overlay = overlay;
    }

    /// Fills HCBTFs of which nothing is painted for few lights and views alone, from now on: small
    /// pictures show no more, and drawing strokes or reliefs takes as much less time.
    pub fn draft(&mut self) {
        self.drafts = true;
    }

    /// Lets somebody watch, and stop, the filling of HCBTFs from now on; each begins the progress
    /// anew.
    pub fn watch(&mut self, progress: Progress) {
        self.progress = progress;
    }

    fn overlaid(
        &mut self,
        path: &Path,
        options: LayerOptions,
    ) -> Option<Result<Arc<Image>, Diagnostic>> {
        let overlay = self.overlay.as_ref().filter(|overlay| overlay.is(path))?;
        if let Some((before, image)) = self.baked.get_mut(&options)
            && (before.version == overlay.version || overlay.rebake(before, image, options))
        {
            *before = overlay.clone();
            return Some(Ok(image.clone()));
        }
        let image = overlay.bake(options).map(Arc::new);
        match &image {
            Ok(image) => drop(self.baked.insert(options, (overlay.clone(), image.clone()))),
            Err(_) => drop(self.baked.remove(&options)),
        }
        Some(image)
    }

    /// The texture of the HCBTF at `path`, relative to `folder`, filled by its rules, with what was
    /// odd in the file.
    ///
    /// # Errors
    /// Why it cannot be used; the caller adds who names it.
    pub fn hcbtf(
        &mut self,
        folder: &Path,
        path: &str,
        options: LayerOptions,
    ) -> Result<Warned<Arc<Image>>, Vec<Diagnostic>> {
        let path = folder.join(path);
        if let Some(image) = self.overlaid(&path, options) {
            return Ok(image.map_err(|problem| vec![problem])?.into());
        }
        let (stamp, round) = (stamp(&path), self.round);
        let key = HcbtfKey { path, options, is_draft: self.drafts };
        if let Some(known) = self.hcbtfs.get_mut(&key).and_then(|used| used.at(stamp, round)) {
            return Ok(known);
        }
        let warned = self.store.hcbtf(&key, stamp, || read_hcbtf(&key, &self.progress))?;
        self.hcbtfs.insert(key, UsedAsset { stamp, warned: warned.clone(), round });
        Ok(warned)
    }
}

/// Stands in for an HCBTF that is not chosen, or could not be read.
pub(super) fn plain_hcbtf(color: [u8; 4]) -> Image {
    let one = Directions { theta: 1, phi: 1 };
    let grid = Grid { size: [1, 1], light: one, view: one };
    let tile = Arc::new(Tile::filled(grid.size, color));
    Image::new(hcbtf::layers(&grid, |_| Some(&tile), LayerOptions::default()))
}

/// Reads an HCBTF and fills it by its rules.
fn read_hcbtf(key: &HcbtfKey, progress: &Progress) -> Result<Warned<Image>, Vec<Diagnostic>> {
    let (mut hcbtf, notes) = hcbtf::load(&key.path)?.into_parts();
    if key.is_draft && hcbtf.painted.is_empty() {
        hcbtf.grid = drafted(hcbtf.grid);
    }
    let image = bake(&hcbtf, key.options, progress)
        .map_err(|problem| vec![problem.in_file(key.path.display().to_string())])?;
    Ok(Warned::new(image, notes))
}

/// A grid with few directions.
fn drafted(grid: Grid) -> Grid {
    let few = |Directions { theta, phi }: Directions| Directions {
        theta: theta.min(DRAFT.theta),
        phi: phi.min(DRAFT.phi),
    };
    Grid { light: few(grid.light), view: few(grid.view), ..grid }
}

/// The texture of an HCBTF, if it is not larger than one may be.
fn bake(hcbtf: &Hcbtf, options: LayerOptions, progress: &Progress) -> Result<Image, Diagnostic> {
    let filled = hcbtf::fill::fill(hcbtf, progress)?;
    Ok(Image::new(hcbtf::stored(&hcbtf.grid, |address| filled.tile(address), options, progress)?))
}

fn stamp(path: &Path) -> FileStamp {
    let data = std::fs::metadata(path).ok()?;
    Some((data.modified().ok()?, data.len()))
}

/// The bytes of an image file at `path`, relative to `folder`, as they are.
///
/// # Errors
/// Why they cannot be read.
pub fn image_bytes(folder: &Path, path: &str) -> Result<Vec<u8>, Diagnostic> {
    bytes_of(&folder.join(path))
}

fn bytes_of(path: &Path) -> Result<Vec<u8>, Diagnostic> {
    files::read(path, MAX_IMAGE_BYTES).map_err(|error| {
        let name = path.display();
        let message = match error {
            ReadError::TooLarge { .. } => {
                format!("the image `{name}` is larger than {} MiB", MAX_IMAGE_BYTES >> 20)
            }
            error => format!("the image `{name}` cannot be read: {error}"),
        };
        Diagnostic::error("missing-asset", message)
    })
}

fn read_image(path: &Path) -> Result<Image, Diagnostic> {
    let bytes = bytes_of(path)
        .map_err(|problem| problem.hint("paths of images are relative to the look's own file"))?;
    let name = path.display();
    let problem = |message: String| {
        Diagnostic::error("missing-asset", message)
            .hint("save it as PNG, JPEG, HDR or EXR, at most 16384 pixels wide and high")
    };
    let mut reader = image::ImageReader::new(Cursor::new(bytes))
        .with_guessed_format()
        .map_err(|error| problem(format!("the image `{name}` cannot be read: {error}")))?;
    let mut limits = image::Limits::default();
    limits.max_image_width = Some(MAX_IMAGE_SIDE);
    limits.max_image_height = Some(MAX_IMAGE_SIDE);
    limits.max_alloc = Some(MAX_IMAGE_BYTES);
    reader.limits(limits);
    let decoded = reader
        .decode()
        .map_err(|error| problem(format!("the image `{name}` cannot be decoded: {error}")))?;
    let rgba = decoded.into_rgba8();
    Ok(Image::flat([rgba.width(), rgba.height()], rgba.into_raw()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Rule;

    fn overlay(version: u64, tiles: &[(Address, [u8; 4])]) -> Overlay {
        let directions = Directions { theta: 3, phi: 4 };
        let mut hcbtf = Hcbtf::new(Grid { size: [4, 4], light: directions, view: directions });
        for (address, color) in tiles {
            hcbtf.painted.insert(*address, Arc::new(Tile::filled(hcbtf.grid.size, *color)));
        }
        Overlay { path: None, version, hcbtf: Arc::new(hcbtf), filled: None }
    }

    #[test]
    fn a_stroke_bakes_its_own_sample_alone_and_nobody_sees_a_difference() {
        let [first, second] = [Address::new([0, 0], [0, 0]), Address::new([2, 1], [1, 3])];
        let mut assets = Assets::default();
        let mut baked = |overlay: &Overlay| {
            assets.overlay(Some(overlay.clone()));
            assets
                .hcbtf(Path::new("nowhere"), UNSAVED_HCBTF, LayerOptions::default())
                .unwrap()
                .value
        };
        let one = baked(&overlay(1, &[(first, [9, 9, 9, 255])]));
        assert_eq!(one.change, None);
        let painted = overlay(2, &[(first, [9, 9, 9, 255]), (second, [50, 0, 0, 255])]);
        let two = baked(&painted);
        assert_eq!(two.bytes, painted.bake(LayerOptions::default()).unwrap().bytes);
        let change = two.change.as_ref().unwrap();
        assert_eq!((change.from, change.regions.len()), (one.hash, 1));
        assert!(one.bytes != two.bytes, "who draws with the old one keeps it");
        let erased = overlay(3, &[(second, [50, 0, 0, 255])]);
        assert_eq!(baked(&erased).bytes, erased.bake(LayerOptions::default()).unwrap().bytes);
        let all: Vec<_> =
            erased.hcbtf.grid.addresses().map(|address| (address, [7, 7, 7, 255])).collect();
        assert_eq!(baked(&overlay(4, &all)).change, None, "all of it is baked at once");
    }

    #[test]
    fn a_stroke_that_a_rule_blends_into_all_samples_sends_few_texels() {
        let directions = Directions { theta: 4, phi: 6 };
        let grid = Grid { size: [16, 16], light: directions, view: directions };
        let rules = vec![Rule::Blend { sharpness: 2.0 }];
        let mut hcbtf = Hcbtf { rules, ..Hcbtf::new(grid) };
        for (light, grey) in [([0, 0], 40), ([3, 2], 200)] {
            let tile = Tile::filled(grid.size, [grey, grey, grey, 255]);
            hcbtf.painted.insert(Address::new(light, [0, 0]), Arc::new(tile));
        }
        let progress = Progress::new();
        let filled = hcbtf::fill::fill(&hcbtf, &progress).unwrap();
        let mut assets = Assets::default();
        let mut baked = |version: u64, hcbtf: &Hcbtf, filled: &FilledSamples| {
            let (hcbtf, filled) = (Arc::new(hcbtf.clone()), Some(Arc::new(filled.clone())));
            let overlay = Overlay { path: None, version, hcbtf, filled };
            assets.overlay(Some(overlay.clone()));
            let image = assets
                .hcbtf(Path::new("nowhere"), UNSAVED_HCBTF, LayerOptions::default())
                .unwrap()
                .value;
            assert!(
                image.rgba() == overlay.bake(LayerOptions::default()).unwrap().rgba(),
                "version {version}"
            );
            image
        };
        let first = baked(1, &hcbtf, &filled);
        let mut stroked = hcbtf.clone();
        let tile = Arc::make_mut(stroked.painted.get_mut(&Address::default()).unwrap());
        for at in [5 * 16 + 6, 5 * 16 + 7, 6 * 16 + 6] {
            tile.bytes_mut()[4 * at..4 * at + 3].copy_from_slice(&[250, 20, 20]);
        }
        let again = hcbtf::fill::refill(&stroked, (&hcbtf, &filled), &progress).unwrap();
        // Two rows of every sample that the rule fills, and the painted one as it is.
        let [done, all] = progress.steps();
        assert!(done == all && all <= 2 * grid.sample_count() + 16, "{all}");
        let second = baked(2, &stroked, &again);
        let others =
            grid.addresses().filter(|at| again.tile(*at) != filled.tile(*at)).count() as u64;
        assert!(others > grid.sample_count() / 2, "the rule spreads it: {others}");
        let change = second.change.as_ref().unwrap();
        assert_eq!(change.from, first.hash);
        // A block of 2 x 2 texels of each view's layer: texels of 4 x 8 lights.
        assert_eq!(change.regions.len(), grid.view.count());
        let sent: u32 = change.regions.iter().map(|region| region.size[0] * region.size[1]).sum();
        assert_eq!(sent, 24 * (2 * 4) * (2 * 8));
    }
}
