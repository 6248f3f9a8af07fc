//! Meshes and images, read once and kept while their files stay the same.

use std::borrow::Cow;
use std::collections::{BTreeMap, HashMap};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::tr;

use super::store::{AssetStamp, AssetStore, HcbtfKey};
use crate::cache::{CachedValue, EntryReader, EntryWriter, cached};
use crate::diag::{Diagnostic, WithWarnings};
use crate::document::{Address, Directions, Grid, Hcbtf, Tile};
use crate::document::{linear_to_srgb, srgb_to_linear};
use crate::files::{Files, ReadError, SharedFiles};
use crate::geometry::{self, MaterialMap, Mesh, MeshPart, WITHIN};
use crate::hcbtf::{self, FilledSamples, LayerOptions, LayeredTexture, Region, TexelCoding};
use crate::photometry::{Photometry, is_lamp_file};
use crate::progress::Progress;

/// Prefix of an object's mesh that is a built-in shape instead of a file.
pub const SHAPE_PREFIX: &str = "shape:";
/// Prefix of an image that is a map of the mesh's own material, followed by the map's name.
pub const MESH_PREFIX: &str = "mesh:";
/// Name in looks of the HCBTF that is being painted, while that has no file.
pub const UNSAVED_HCBTF: &str = "hcbtf:open";
/// Largest image that is read, in pixels along a side; a GPU may allow less.
pub const MAX_IMAGE_SIDE: u32 = 16_384;
/// Greatest memory that decoding one image may take, in bytes.
const MAX_IMAGE_BYTES: u64 = 1 << 30;

/// A decoded image: straight RGBA, 8 bits a channel, rows from the top, layer after layer.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// Width and height, in pixels.
    pub size: [u32; 2],
    /// Number of layers; 1 for a flat image.
    pub layers: u32,
    /// Coding of the pixels in `bytes`.
    pub coding: TexelCoding,
    /// Pixels, or blocks of pixels, as `coding` says.
    pub bytes: Vec<u8>,
    /// True if the image is known to have no transparent pixel.
    pub is_opaque: bool,
    /// Hash of the content, for caches.
    pub hash: u64,
    /// Difference from the image before, where only a small part changed.
    pub change: Option<Change>,
}

/// Difference between an image and the image before.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// Hash of the image before.
    pub from: u64,
    /// Regions that may have changed.
    pub regions: Vec<Region>,
}

impl Image {
    /// An image of one pixel, standing in for an image that could not be read.
    pub fn single(rgba: [u8; 4]) -> Self {
        Self::flat([1, 1], rgba.to_vec())
    }

    fn flat(size: [u32; 2], rgba: Vec<u8>) -> Self {
        let texture = LayeredTexture { size, count: 1, coding: TexelCoding::Rgba8, bytes: rgba };
        Self { is_opaque: false, ..Self::new(texture) }
    }

    /// The image of an HCBTF's texture, whose header says whether it is opaque.
    fn new(layers: LayeredTexture) -> Self {
        let is_opaque = layers.is_opaque();
        let LayeredTexture { size, count, coding, bytes } = layers;
        let mut hasher = DefaultHasher::new();
        (size, count, coding, &bytes).hash(&mut hasher);
        let hash = hasher.finish();
        Self { size, layers: count, coding, bytes, is_opaque, hash, change: None }
    }

    /// The image multiplied by a linear factor, 0 to 1 a channel; colors are multiplied as light.
    fn multiplied(&self, factor: [f32; 4], is_color: bool) -> Self {
        let byte = |x: f64| (x * 255.0).round().clamp(0.0, 255.0) as u8;
        let tables: [[u8; 256]; 4] = std::array::from_fn(|channel| {
            let factor = f64::from(factor[channel]);
            std::array::from_fn(|value| {
                let value = value as f64 / 255.0;
                match is_color && channel < 3 {
                    true => byte(linear_to_srgb(srgb_to_linear(value) * factor)),
                    false => byte(value * factor),
                }
            })
        });
        let mut rgba = self.rgba().into_owned();
        for pixel in rgba.as_chunks_mut::<4>().0 {
            *pixel = std::array::from_fn(|channel| tables[channel][usize::from(pixel[channel])]);
        }
        Self::flat(self.size, rgba)
    }

    /// The pixels decoded to RGBA, four bytes a pixel.
    pub fn rgba(&self) -> Cow<'_, [u8]> {
        self.coding.rgba(self.size, &self.bytes)
    }
}

impl CachedValue for Image {
    fn write(&self, entry: &mut EntryWriter) {
        entry.words([self.size[0], self.size[1], self.layers].into_iter());
        entry.number(match self.coding {
            TexelCoding::Rgba8 => 0,
            TexelCoding::Bc7 => 1,
        });
        entry.bytes(&self.bytes);
    }

    fn read(entry: &mut EntryReader<'_>) -> Option<Self> {
        let [width, height, count] = <[u32; 3]>::try_from(entry.words()?).ok()?;
        let coding = match entry.number()? {
            0 => TexelCoding::Rgba8,
            1 => TexelCoding::Bc7,
            _ => return None,
        };
        let bytes = entry.bytes()?.to_vec();
        Some(Self::new(LayeredTexture { size: [width, height], count, coding, bytes }))
    }
}

/// An asset that a picture uses.
#[derive(Clone, Debug)]
struct UsedAsset<T> {
    stamp: AssetStamp,
    warned: WithWarnings<Arc<T>>,
    /// Round in which the asset was asked for last.
    round: u64,
}

impl<T> UsedAsset<T> {
    /// The asset, if its file has not changed since it was read, nor the language of its warnings.
    fn at(&mut self, stamp: AssetStamp, round: u64) -> Option<WithWarnings<Arc<T>>> {
        self.round = round;
        self.stamp.is_same(stamp, &self.warned.warnings).then(|| self.warned.clone())
    }
}

/// Number of pictures for which an unused asset is kept.
const MOST_ROUNDS: u64 = 16;

/// Version of an overlay's content: another number means another content.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct OverlayVersion(pub u64);

/// An HCBTF that is being painted, shown in place of its file.
#[derive(Clone, Debug)]
pub struct Overlay {
    /// Path of the HCBTF's file, once there is one; [`UNSAVED_HCBTF`] names the HCBTF also before.
    pub path: Option<PathBuf>,
    /// Version of the content.
    pub version: OverlayVersion,
    /// The HCBTF as painted so far.
    pub hcbtf: Arc<Hcbtf>,
    /// Samples that the rules made of the rest, as far as they are known.
    pub filled: Option<Arc<FilledSamples>>,
}

impl Overlay {
    /// True if a look that names `path` means this HCBTF.
    fn is(&self, path: &Path, files: &dyn Files) -> bool {
        let real = |path: &Path| files.canonical(path);
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

    /// The hash of the image that is baked of this version: the version's number, since an HCBTF is
    /// baked again and again while it is painted on.
    fn hash(&self, options: LayerOptions) -> u64 {
        let mut hasher = DefaultHasher::new();
        ("overlay", self.version, options).hash(&mut hasher);
        hasher.finish()
    }

    /// Brings the image that was baked of the version `before` up to date, if few texels have
    /// changed. Returns false if the image must be baked anew.
    fn rebake(&self, before: &Self, image: &mut Arc<Image>, options: LayerOptions) -> bool {
        let grid = self.hcbtf.grid;
        if grid != before.hcbtf.grid {
            return false;
        }
        let texels = grid.texels() as u64;
        // All smaller levels of a changed sample are written anew.
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
        // A copy is made if somebody still draws with the old image.
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

/// Greatest number of directions of lights, and of views, in a draft.
const DRAFT: Directions = Directions { theta: 3, phi: 4 };

/// Inverse of the share of changed texels above which all are baked anew.
const REBAKED: u64 = 8;

/// Joins regions of a layer that overlap into one around them: all samples of a view lie in the
/// same layer, light by light.
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

/// Key of a multiplied picture: the hash of the picture, the bits of the factor, and whether it is
/// a color.
type MultipliedKey = (u64, [u32; 4], bool);

/// Reader of meshes and images. Each file is read once and kept while pictures use it, shared with
/// all users of the same [`AssetStore`].
#[derive(Clone, Debug, Default)]
pub struct Assets {
    store: AssetStore,
    /// Number of the current picture.
    round: u64,
    overlay: Option<Overlay>,
    /// True if the rules of HCBTFs make samples for few directions only.
    drafts: bool,
    /// Progress of filling HCBTFs, for those who watch it.
    progress: Progress,
    /// Images baked of the overlay, or of an earlier version of it, by their options.
    baked: HashMap<LayerOptions, (Overlay, Arc<Image>)>,
    meshes: HashMap<String, UsedAsset<Mesh>>,
    images: HashMap<PathBuf, UsedAsset<Image>>,
    /// Maps of materials whose pictures are multiplied, with the round in which they were asked for
    /// last.
    multiplied: HashMap<MultipliedKey, (u64, Arc<Image>)>,
    hcbtfs: HashMap<HcbtfKey, UsedAsset<Image>>,
}

impl Assets {
    /// A reader with nothing in use, sharing what it reads with all users of the same store.
    pub fn of(store: &AssetStore) -> Self {
        Self { store: store.clone(), ..Self::default() }
    }

    /// Store that is shared with other readers.
    pub fn store(&self) -> &AssetStore {
        &self.store
    }

    /// Files that meshes, images, HCBTFs and documents are read from.
    pub fn source(&self) -> &SharedFiles {
        self.store.source()
    }

    /// Shares everything that is read from now on with all users of the same store.
    pub fn share(&mut self, store: &AssetStore) {
        if !self.store.is_same(store) {
            self.store = store.clone();
        }
    }

    /// Begins another picture: assets that none of the last few pictures used are dropped.
    pub fn begin_picture(&mut self) {
        self.round += 1;
        let least = self.round.saturating_sub(MOST_ROUNDS);
        self.meshes.retain(|_, used| used.round >= least);
        self.images.retain(|_, used| used.round >= least);
        self.multiplied.retain(|_, (round, _)| *round >= least);
        self.hcbtfs.retain(|_, used| used.round >= least);
    }

    /// The mesh that `name` means, a path relative to `folder` or `shape:` and a built-in shape,
    /// with the warnings of its file.
    ///
    /// # Errors
    /// The reasons why the mesh cannot be used.
    pub fn mesh(
        &mut self,
        folder: &Path,
        name: &str,
    ) -> Result<WithWarnings<Arc<Mesh>>, Vec<Diagnostic>> {
        if let Some(shape) = name.strip_prefix(SHAPE_PREFIX) {
            return Ok(self.shape(shape)?.into());
        }
        let path = folder.join(name);
        let key = path.display().to_string();
        let (stamp, round) = (AssetStamp::now(self.source().metadata(&path)), self.round);
        if let Some(known) = self.meshes.get_mut(&key).and_then(|used| used.at(stamp, round)) {
            return Ok(known);
        }
        let read = || geometry::load(&**self.source(), &path);
        let warned = self.store.mesh(&key, stamp, read)?;
        self.meshes.insert(key, UsedAsset { stamp, warned: warned.clone(), round });
        Ok(warned)
    }

    /// The paths of all files that were read: meshes, images and HCBTFs.
    pub fn files(&self) -> impl Iterator<Item = &Path> {
        let meshes =
            self.meshes.keys().filter(|name| !name.starts_with(SHAPE_PREFIX)).map(Path::new);
        let images = self.images.keys().map(|path| match within(path) {
            Some((file, _)) => file,
            None => path.as_path(),
        });
        meshes.chain(images).chain(self.hcbtfs.keys().map(|key| key.path.as_path()))
    }

    fn shape(&mut self, name: &str) -> Result<Arc<Mesh>, Vec<Diagnostic>> {
        let key = format!("{SHAPE_PREFIX}{name}");
        let (stamp, round) = (AssetStamp::now(None), self.round);
        if let Some(known) = self.meshes.get_mut(&key).and_then(|used| used.at(stamp, round)) {
            return Ok(known.value);
        }
        let shape = || {
            if let Some(mesh) = geometry::shape(name) {
                return Ok(mesh.into());
            }
            let known = geometry::SHAPES.iter().map(|shape| shape.name);
            let names: Vec<&str> = known.clone().collect();
            let problem = Diagnostic::error("unknown-shape", tr!("there is no own shape `{name}`"));
            Err(vec![
                problem
                    .suggest(name, known)
                    .hint(tr!("the shapes are {names}", names = names.join(", "))),
            ])
        };
        let warned = self.store.mesh(&key, stamp, shape)?;
        self.meshes.insert(key, UsedAsset { stamp, warned: warned.clone(), round });
        Ok(warned.value)
    }

    /// The image at `path`, relative to `folder`.
    ///
    /// # Errors
    /// The reason why the image cannot be used; the caller adds what names the image.
    pub fn image(&mut self, folder: &Path, path: &str) -> Result<Arc<Image>, Diagnostic> {
        let path = folder.join(path);
        let file = within(&path).map_or(path.as_path(), |(file, _)| file);
        let (stamp, round) = (AssetStamp::now(self.source().metadata(file)), self.round);
        if let Some(known) = self.images.get_mut(&path).and_then(|used| used.at(stamp, round)) {
            return Ok(known.value);
        }
        let value = self.store.image(&path, stamp, || read_image(&**self.source(), &path))?;
        self.images.insert(path, UsedAsset { stamp, warned: value.clone().into(), round });
        Ok(value)
    }

    /// The map of the material that a part of a mesh has: its picture, multiplied by its factor.
    ///
    /// # Errors
    /// The reason why the picture cannot be read.
    pub fn material_map(
        &mut self,
        mesh: &Mesh,
        part: &MeshPart,
        map: MaterialMap,
    ) -> Result<Arc<Image>, Diagnostic> {
        let Some(source) = part.maps.as_ref().and_then(|maps| maps.get(&map)) else {
            return Ok(Arc::new(Image::single(map.absent())));
        };
        let Some(name) = &source.image else {
            let white = Image::single([255; 4]);
            return Ok(Arc::new(white.multiplied(source.factor, map.is_color())));
        };
        let file = mesh.file.as_deref().unwrap_or(Path::new(""));
        let image = match name.starts_with(WITHIN) {
            true => self.image(Path::new(""), &format!("{}{name}", file.display()))?,
            false => self.image(file.parent().unwrap_or(Path::new("")), name)?,
        };
        if source.factor == [1.0; 4] {
            return Ok(image);
        }
        let key = (image.hash, source.factor.map(f32::to_bits), map.is_color());
        let round = self.round;
        let made = || Arc::new(image.multiplied(source.factor, map.is_color()));
        let (used, image) = self.multiplied.entry(key).or_insert_with(|| (round, made()));
        *used = round;
        Ok(image.clone())
    }

    /// Shows an HCBTF as it is being painted wherever its file is named, from now on; with `None`
    /// files are shown as they are on disk.
    pub fn overlay(&mut self, overlay: Option<Overlay>) {
        if overlay.is_none() {
            self.baked.clear();
        }
        self.overlay = overlay;
    }

    /// Fills unpainted HCBTFs for few lights and views only, from now on: small pictures show no
    /// more, and drawing strokes or reliefs takes less time in proportion.
    pub fn draft(&mut self) {
        self.drafts = true;
    }

    /// Lets `progress` count, and stop, the filling of HCBTFs from now on; each HCBTF begins the
    /// progress anew.
    pub fn watch(&mut self, progress: Progress) {
        self.progress = progress;
    }

    fn overlaid(
        &mut self,
        path: &Path,
        options: LayerOptions,
    ) -> Option<Result<Arc<Image>, Diagnostic>> {
        let files = &**self.store.source();
        let overlay = self.overlay.as_ref().filter(|overlay| overlay.is(path, files))?;
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

    /// The texture of the HCBTF at `path`, relative to `folder`, filled by its rules, with the
    /// warnings of the file.
    ///
    /// # Errors
    /// The reasons why the HCBTF cannot be used; the caller adds what names the HCBTF.
    pub fn hcbtf(
        &mut self,
        folder: &Path,
        path: &str,
        options: LayerOptions,
    ) -> Result<WithWarnings<Arc<Image>>, Vec<Diagnostic>> {
        let path = folder.join(path);
        if let Some(image) = self.overlaid(&path, options) {
            return Ok(image.map_err(|problem| vec![problem])?.into());
        }
        let (stamp, round) = (AssetStamp::now(self.source().metadata(&path)), self.round);
        let key = HcbtfKey { path, options, is_draft: self.drafts };
        if let Some(known) = self.hcbtfs.get_mut(&key).and_then(|used| used.at(stamp, round)) {
            return Ok(known);
        }
        let read = || read_hcbtf(&**self.source(), &key, &self.progress);
        let warned = self.store.hcbtf(&key, stamp, read)?;
        self.hcbtfs.insert(key, UsedAsset { stamp, warned: warned.clone(), round });
        Ok(warned)
    }
}

/// The image of one color that stands in for an HCBTF that is not chosen, or could not be read.
pub(super) fn plain_hcbtf(color: [u8; 4]) -> Image {
    let one = Directions { theta: 1, phi: 1 };
    let grid = Grid { size: [1, 1], light: one, view: one };
    let tile = Arc::new(Tile::filled(grid.size, color));
    Image::new(hcbtf::layers(&grid, |_| Some(&tile), LayerOptions::default()))
}

/// Reads an HCBTF and fills it by its rules.
fn read_hcbtf(
    files: &dyn Files,
    key: &HcbtfKey,
    progress: &Progress,
) -> Result<WithWarnings<Image>, Vec<Diagnostic>> {
    let name = key.path.display().to_string();
    let bytes = hcbtf::read_bytes(files, &key.path).map_err(|problem| vec![*problem])?;
    let (mut hcbtf, notes) = hcbtf::read(&bytes, &name)?.into_parts();
    if key.is_draft && hcbtf.painted.is_empty() {
        hcbtf.grid = drafted(hcbtf.grid);
    }
    // Rules draw the same samples again: a relief takes seconds.
    let sources = (bytes, key.options, key.is_draft);
    let image = cached("hcbtf", &sources, || bake(&hcbtf, key.options, progress))
        .map_err(|problem| vec![problem.in_file(name)])?;
    Ok(WithWarnings::new(image, notes))
}

/// A grid reduced to the few directions of a draft.
fn drafted(grid: Grid) -> Grid {
    let few = |Directions { theta, phi }: Directions| Directions {
        theta: theta.min(DRAFT.theta),
        phi: phi.min(DRAFT.phi),
    };
    Grid { light: few(grid.light), view: few(grid.view), ..grid }
}

/// The texture of an HCBTF, unless the texture would be too large.
fn bake(hcbtf: &Hcbtf, options: LayerOptions, progress: &Progress) -> Result<Image, Diagnostic> {
    let filled = hcbtf::fill::fill(hcbtf, progress)?;
    Ok(Image::new(hcbtf::stored(&hcbtf.grid, |address| filled.tile(address), options, progress)?))
}

/// The bytes of the image file at `path`, relative to `folder`, undecoded; of a photometric file
/// those of its picture.
///
/// # Errors
/// The reason why the file cannot be read.
pub fn image_bytes(files: &dyn Files, folder: &Path, path: &str) -> Result<Vec<u8>, Diagnostic> {
    bytes_of(files, &folder.join(path))
}

/// The mesh's file that a picture lies within, and the picture's number.
fn within(path: &Path) -> Option<(&Path, usize)> {
    let (file, number) = path.to_str()?.rsplit_once(WITHIN)?;
    Some((Path::new(file), number.parse().ok()?))
}

fn bytes_of(files: &dyn Files, path: &Path) -> Result<Vec<u8>, Diagnostic> {
    if let Some((file, number)) = within(path) {
        return geometry::load_image(files, file, number, MAX_IMAGE_BYTES).map_err(|problem| {
            let message =
                tr!("of `{file}`: {message}", file = file.display(), message = problem.message);
            Diagnostic::error("missing-asset", message)
        });
    }
    let bytes = files.read(path, MAX_IMAGE_BYTES).map_err(|error| {
        let name = path.display();
        let message = match error {
            ReadError::TooLarge { .. } => {
                tr!("the image `{name}` is larger than {most} MiB", most = MAX_IMAGE_BYTES >> 20)
            }
            error => tr!("the image `{name}` cannot be read: {error}"),
        };
        Diagnostic::error("missing-asset", message)
    })?;
    if !is_lamp_file(path) {
        return Ok(bytes);
    }
    let picture = Photometry::read(&String::from_utf8_lossy(&bytes)).and_then(|it| it.to_png());
    picture.map_err(|problem| Diagnostic {
        message: tr!("`{file}`, {problem}", file = path.display(), problem = problem.message),
        ..problem
    })
}

fn read_image(files: &dyn Files, path: &Path) -> Result<Image, Diagnostic> {
    let bytes = bytes_of(files, path).map_err(|problem| {
        problem.hint(tr!("paths of images are relative to the look's own file"))
    })?;
    let name = path.display();
    let problem = |message: String| {
        Diagnostic::error("missing-asset", message)
            .hint(tr!("save it as PNG, JPEG, HDR or EXR, at most 16384 pixels wide and high"))
    };
    let mut reader = image::ImageReader::new(Cursor::new(bytes))
        .with_guessed_format()
        .map_err(|error| problem(tr!("the image `{name}` cannot be read: {error}")))?;
    let mut limits = image::Limits::default();
    limits.max_image_width = Some(MAX_IMAGE_SIDE);
    limits.max_image_height = Some(MAX_IMAGE_SIDE);
    limits.max_alloc = Some(MAX_IMAGE_BYTES);
    reader.limits(limits);
    let decoded = reader
        .decode()
        .map_err(|error| problem(tr!("the image `{name}` cannot be decoded: {error}")))?;
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
        let version = OverlayVersion(version);
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
        for (light, gray) in [([0, 0], 40), ([3, 2], 200)] {
            let tile = Tile::filled(grid.size, [gray, gray, gray, 255]);
            hcbtf.painted.insert(Address::new(light, [0, 0]), Arc::new(tile));
        }
        let progress = Progress::new();
        let filled = hcbtf::fill::fill(&hcbtf, &progress).unwrap();
        let mut assets = Assets::default();
        let mut baked = |version: u64, hcbtf: &Hcbtf, filled: &FilledSamples| {
            let (hcbtf, filled) = (Arc::new(hcbtf.clone()), Some(Arc::new(filled.clone())));
            let overlay = Overlay { path: None, version: OverlayVersion(version), hcbtf, filled };
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
        // Two rows of every sample that the rule fills, and the painted sample unchanged.
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
