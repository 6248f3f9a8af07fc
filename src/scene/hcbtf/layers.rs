//! The texture in which shaders look up an HCBTF.
//!
//! Each layer holds one view: every texel of the tile is a small block of its lights, thetas along
//! x, phis along y, with a copy of the last phi above the first and of the first below the last, so
//! that one bilinear tap blends four lights (the inner layout of thesis A.3, with a layer for each
//! view instead of one flat texture, which no GPU could hold for larger tiles). Smaller levels of
//! the tile stand to the right of the tile, each below the one before. The first two texels of one
//! more layer are the header, which describes the grid, so that a shader needs nothing beside the
//! texture. Views that are equal may share a layer; the texels after the header then give the layer
//! of each view. `shaders/lib/hcbtf.wgsl` reads this layout.
//!
//! [`compact`](super::compact) and [`blocks`] are the other layouts, for less memory.

use std::borrow::Cow;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use chiaro_locale::tr;

use super::blocks::{self, TexelCoding};
use super::compact;
use super::fill::MAX_SAMPLES;
use super::levels::{level_sizes, levels_of_all};
use super::share::{shared_size, views, write_shares};
use crate::diag::Diagnostic;
use crate::document::{Address, Direction, Directions, Grid, Hcbtf, Storage, Tile};
use crate::progress::Progress;

/// Options of a texture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct LayerOptions {
    /// True for a texture with smaller levels of the tile, for surfaces that are far away.
    pub has_levels: bool,
    /// True if shaders are to decode blended colors to linear light.
    pub is_decoded: bool,
    /// Storage of the texture.
    pub storage: Storage,
}

/// A texture: straight RGBA, 8 bits a channel, rows from the top, layer after layer.
#[derive(Clone, Debug, PartialEq)]
pub struct LayeredTexture {
    /// Width and height of a layer, in texels.
    pub size: [u32; 2],
    /// Number of layers. One for each view that differs, and one for the header; or as many as the
    /// other storages take.
    pub count: u32,
    /// Coding of the texels.
    pub coding: TexelCoding,
    /// Texels, or blocks of texels.
    pub bytes: Vec<u8>,
}

impl LayeredTexture {
    /// True if the header says that no texel is transparent. Of a texture that is being painted it
    /// says nothing.
    pub fn is_opaque(&self) -> bool {
        let layers = self.count.max(1) as usize;
        let flags = self.bytes.get(self.bytes.len() / layers * (layers - 1)..);
        let flags = flags.and_then(|header| read_header(self.coding, header));
        flags.is_some_and(|header| header[3] & OPAQUE != 0)
    }

    /// The decoded texels, four bytes each.
    pub fn rgba(&self) -> Cow<'_, [u8]> {
        self.coding.rgba(self.size, &self.bytes)
    }
}

/// Greatest memory that a texture may take, in bytes; for one of blocks, decoded, as on devices
/// that do not support blocks.
pub const MAX_LAYERS_BYTES: u64 = 2 << 30;
/// Least width of a layer, because the header of the last layer takes two texels.
const FEWEST: u64 = 2;
/// Number of texels of the header, which describes the grid.
pub(super) const HEADER_TEXELS: usize = 2;
/// Flag of the header: views share layers.
pub(super) const SHARED: u8 = 4;
/// Flag of the header: the storage is compact, or of blocks.
const COMPACT: u8 = 8;
/// Flag of the header: the storage is of blocks.
const BLOCKS: u8 = 16;
/// Flag of the header: no texel is transparent.
const OPAQUE: u8 = 32;

/// The width and height of a layer in texels, and the number of layers, before anything is made.
/// They follow from the grid alone, and may be more than there is memory for, or than a GPU allows.
pub fn layers_size(grid: &Grid, has_levels: bool) -> [u64; 3] {
    let block = [u64::from(grid.light.theta), u64::from(grid.light.phi) + 2];
    let [width, height] = grid.size.map(u64::from);
    let mut size = [width * block[0], height * block[1]];
    if has_levels {
        let smaller = level_sizes(grid).skip(1);
        let (widest, highest) = smaller.fold((0, 0), |(w, h), [x, y]| {
            (w.max(u64::from(x) * block[0]), h + u64::from(y) * block[1])
        });
        size = [size[0] + widest, size[1].max(highest)];
    }
    [size[0].max(FEWEST), size[1], grid.view.count() as u64 + 1]
}

/// The size of the layers, in bytes.
pub fn layers_bytes(grid: &Grid, has_levels: bool) -> u64 {
    layers_size(grid, has_levels).into_iter().fold(4, u64::saturating_mul)
}

/// The size of the layers, checked against the bound, in bytes.
///
/// # Errors
/// `too-large`: the layers would take more than [`MAX_LAYERS_BYTES`].
pub fn check_layers(grid: &Grid, has_levels: bool) -> Result<u64, Diagnostic> {
    check_bytes(layers_bytes(grid, has_levels))
}

fn check_bytes(bytes: u64) -> Result<u64, Diagnostic> {
    if bytes <= MAX_LAYERS_BYTES {
        return Ok(bytes);
    }
    let message = tr!(
        "its texture would take {mib} MiB; it may take {most}",
        mib = bytes >> 20,
        most = MAX_LAYERS_BYTES >> 20
    );
    let hint =
        tr!("divide it into fewer texels, lights or views, or let its nodes store it as `compact`");
    Err(Diagnostic::error("too-large", message).hint(hint))
}

/// The width and height of a layer in texels, and the number of layers, of a texture of [`stored`],
/// computed without making it.
pub fn stored_size<'a>(
    grid: &Grid,
    tile: impl Fn(Address) -> Option<&'a Arc<Tile>>,
    has_levels: bool,
    storage: Storage,
) -> [u64; 3] {
    match storage {
        Storage::Quick => shared_size(grid, &views(grid, tile), has_levels),
        Storage::Compact => compact::size(grid, tile, has_levels),
        Storage::Blocks => blocks::BlockLayout::new(grid, tile, has_levels).size(),
    }
}

/// Makes the texture from the samples' tiles, with equal parts stored once, as far as the storage
/// can; a sample without a tile is transparent black. `progress` counts the tiles that are
/// compressed; the other storages take no time.
///
/// # Errors
/// `too-large`: the texture would take more than [`MAX_LAYERS_BYTES`]. `stopped`: the work was
/// stopped.
pub fn stored<'a>(
    grid: &Grid,
    tile: impl Fn(Address) -> Option<&'a Arc<Tile>>,
    options: LayerOptions,
    progress: &Progress,
) -> Result<LayeredTexture, Diagnostic> {
    let is_opaque = is_opaque(grid, &tile);
    match options.storage {
        Storage::Quick => {
            let views = views(grid, &tile);
            let size = shared_size(grid, &views, options.has_levels);
            check_bytes(size.into_iter().fold(4, u64::saturating_mul))?;
            let mut made = layers_of(grid, &views.differ, tile, options, is_opaque);
            if views.differ.len() < grid.view.count() {
                write_shares(&mut made, &views.layer);
            }
            Ok(made)
        }
        Storage::Compact => {
            let plan = compact::CompactLayout::new(grid, tile, options.has_levels);
            check_bytes(plan.size().into_iter().fold(4, u64::saturating_mul))?;
            Ok(plan.write(header(grid, options, is_opaque)))
        }
        Storage::Blocks => {
            let plan = blocks::BlockLayout::new(grid, tile, options.has_levels);
            check_bytes(plan.size().into_iter().fold(4, u64::saturating_mul))?;
            Ok(plan.write(header(grid, options, is_opaque), progress)?)
        }
    }
}

/// Makes the texture from the samples' tiles, quickly and with a layer for each view, so that a
/// sample is always at the same place: for an HCBTF that is being painted. The caller has checked
/// the size ([`check_layers`]).
pub fn layers<'a>(
    grid: &Grid,
    tile: impl Fn(Address) -> Option<&'a Arc<Tile>>,
    options: LayerOptions,
) -> LayeredTexture {
    let options = LayerOptions { storage: Storage::Quick, ..options };
    // The next stroke may be transparent.
    layers_of(grid, &(0..grid.view.count()).collect::<Vec<_>>(), tile, options, false)
}

fn layers_of<'a>(
    grid: &Grid,
    views: &[usize],
    tile: impl Fn(Address) -> Option<&'a Arc<Tile>>,
    options: LayerOptions,
    is_opaque: bool,
) -> LayeredTexture {
    let [width, height, _] = layers_size(grid, options.has_levels).map(|n| n as usize);
    let count = views.len() + 1;
    let mut rgba = vec![0; 4 * width * height * count];
    let addresses = |view: usize| {
        let view = direction(view, grid.view.phi);
        let lights = (0..grid.light.count()).map(|index| direction(index, grid.light.phi));
        lights.map(move |light| Address { view, light })
    };
    let smaller = match options.has_levels {
        true => levels_of_all(
            views.iter().flat_map(|view| addresses(*view)).filter_map(|at| tile(at.canonical())),
        ),
        false => HashMap::new(),
    };
    let mut layer = TextureLayer { grid, width, texels: &mut [] };
    for (index, texels) in views.iter().zip(rgba.chunks_exact_mut(4 * width * height)) {
        layer.texels = texels;
        for address in addresses(*index) {
            let Some(tile) = tile(address.canonical()) else { continue };
            layer.put(tile, address.light, [0, 0]);
            let mut origin = [grid.size[0] * grid.light.theta, 0];
            for level in smaller.get(&Arc::as_ptr(tile)).into_iter().flatten() {
                layer.put(level, address.light, origin);
                origin[1] += level.size()[1] * (grid.light.phi + 2);
            }
        }
    }
    let told = rgba.len() - 4 * width * height;
    rgba[told..told + 8].copy_from_slice(&header(grid, options, is_opaque));
    LayeredTexture {
        size: [width as u32, height as u32],
        count: count as u32,
        coding: TexelCoding::Rgba8,
        bytes: rgba,
    }
}

/// The HCBTF that a texture was made of: samples that its rules filled count as painted, and a
/// sample that is transparent black all over as empty.
///
/// # Errors
/// `hcbtf-layers`: the header describes no grid, or the texture does not have the size of its grid.
pub fn from_layers(layers: &LayeredTexture) -> Result<Hcbtf, Diagnostic> {
    let wrong = |message: &str| {
        Diagnostic::error("hcbtf-layers", message).hint(tr!("export it anew from an .hcbtf file"))
    };
    let [width, height] = layers.size.map(|side| side as usize);
    let layer = layers.coding.bytes(width as u64 * height as u64) as usize;
    let whole = layer * layers.count as usize;
    if layers.bytes.len() != whole {
        return Err(wrong(tr!("the texture has not the size that it tells")));
    }
    let told =
        whole.checked_sub(layer).and_then(|at| read_header(layers.coding, &layers.bytes[at..]));
    let Some([low_x, low_y, high, flags, light_theta, light_phi, view_theta, view_phi]) = told
    else {
        return Err(wrong(tr!("the texture tells no grid")));
    };
    let [low_x, low_y, high] = [low_x, low_y, high].map(u32::from);
    let directions = |theta: u8, phi: u8| Directions { theta: theta.into(), phi: phi.into() };
    let grid = Grid {
        size: [low_x | (high & 15) << 8, low_y | high >> 4 << 8],
        light: directions(light_theta, light_phi),
        view: directions(view_theta, view_phi),
    };
    let samples = grid.view.count() as u64 * grid.light.count() as u64;
    if grid.check().is_err() || flags & (SHARED | COMPACT) != 0 && samples > MAX_SAMPLES {
        return Err(wrong(tr!("the texture tells a grid that cannot be")));
    }
    if (flags & BLOCKS != 0) != (layers.coding == TexelCoding::Bc7) {
        return Err(wrong(tr!("the texture is not stored as it tells")));
    }
    if layers.coding == TexelCoding::Bc7 {
        let read = blocks::read(&grid, layers, flags & 1 == 1);
        return read.ok_or_else(|| wrong(tr!("the texture does not hold what it tells of")));
    }
    if flags & COMPACT != 0 {
        let texels =
            layers.bytes.chunks_exact(4 * width * height).rev().collect::<Vec<_>>().concat();
        return compact::read(&grid, &texels)
            .ok_or_else(|| wrong(tr!("the texture does not hold what it tells of")));
    }
    let layer_of = |view: usize| match flags & SHARED != 0 {
        true => {
            let told = layers
                .bytes
                .get(whole - 4 * width * height + 4 * (HEADER_TEXELS + view)..)?
                .first_chunk()?;
            Some(u32::from_le_bytes(*told) as usize)
        }
        false => Some(view),
    };
    let of_views: Option<Vec<usize>> = (0..grid.view.count()).map(layer_of).collect();
    let of_views = of_views
        .filter(|layers_of| layers_of.iter().all(|layer| *layer + 1 < layers.count as usize));
    let most = layers_size(&grid, flags & 1 == 1);
    let is_whole = flags & SHARED != 0 || most[2] == u64::from(layers.count);
    let Some(of_views) =
        of_views.filter(|_| is_whole && most[..2] == [width as u64, height as u64])
    else {
        return Err(wrong(tr!("the texture has not the size of the grid that it tells")));
    };
    let mut hcbtf = Hcbtf::new(grid);
    // A tile that views share is made once.
    let mut tiles: HashMap<(usize, Direction), Arc<Tile>> = HashMap::new();
    for address in grid.addresses() {
        let layer =
            of_views[(address.view.theta * grid.view.phi + address.view.phi) as usize] * height;
        let texel = |index: usize| {
            let [x, y] = [index % grid.size[0] as usize, index / grid.size[0] as usize];
            let column = x * grid.light.theta as usize + address.light.theta as usize;
            let row = layer + y * (grid.light.phi as usize + 2) + address.light.phi as usize + 1;
            let at = 4 * (row * width + column);
            &layers.bytes[at..at + 4]
        };
        let make = || {
            let rgba: Vec<u8> = (0..grid.texels()).flat_map(texel).copied().collect();
            Arc::new(Tile::new(grid.size, rgba).unwrap_or_else(|| Tile::filled(grid.size, [0; 4])))
        };
        let tile = tiles.entry((layer, address.light)).or_insert_with(make);
        paint(&mut hcbtf, address, tile);
    }
    Ok(hcbtf)
}

/// Adds a sample as painted, unless the tile is transparent black all over.
pub(super) fn paint(hcbtf: &mut Hcbtf, address: Address, tile: &Arc<Tile>) {
    if tile.bytes().iter().any(|byte| *byte != 0) {
        hcbtf.painted.insert(address, tile.clone());
    }
}

/// The header of two texels: the tile's sides with twelve bits each and the flags; then rings and
/// steps of lights and of views.
fn header(grid: &Grid, options: LayerOptions, is_opaque: bool) -> [u8; 8] {
    let [width, height] = grid.size;
    let compact = match options.storage {
        Storage::Quick => 0,
        Storage::Compact => COMPACT,
        Storage::Blocks => COMPACT | BLOCKS,
    };
    let mut flags = u8::from(options.has_levels) | u8::from(options.is_decoded) << 1 | compact;
    if is_opaque {
        flags |= OPAQUE;
    }
    let high = (width >> 8 & 15) | (height >> 8 & 15) << 4;
    let angles =
        [grid.light.theta, grid.light.phi, grid.view.theta, grid.view.phi].map(|n| n as u8);
    [width as u8, height as u8, high as u8, flags, angles[0], angles[1], angles[2], angles[3]]
}

/// True if every sample has a tile, and no texel of any is transparent. Means of opaque texels are
/// opaque, so that the smaller levels are.
fn is_opaque<'a>(grid: &Grid, tile: impl Fn(Address) -> Option<&'a Arc<Tile>>) -> bool {
    let mut known = HashSet::new();
    grid.addresses().all(|address| {
        tile(address).is_some_and(|tile| {
            let alpha = || tile.bytes().iter().skip(3).step_by(4);
            !known.insert(Arc::as_ptr(tile)) || alpha().all(|alpha| *alpha == u8::MAX)
        })
    })
}

/// The direction with the number `index`, counted ring by ring.
pub(super) fn direction(index: usize, steps: u32) -> Direction {
    let index = index as u32;
    Direction { theta: index / steps.max(1), phi: index % steps.max(1) }
}

/// The index of a sample, counted view after view.
pub(super) fn direction_index(grid: &Grid, address: Address) -> usize {
    let of = |steps: u32, at: Direction| (at.theta * steps + at.phi) as usize;
    of(grid.view.phi, address.view) * grid.light.count() + of(grid.light.phi, address.light)
}

/// The header at the beginning of a layer, in two texels or in two blocks; `None` if the layer is
/// too short.
fn read_header(coding: TexelCoding, layer: &[u8]) -> Option<[u8; 8]> {
    match coding {
        TexelCoding::Rgba8 => layer.first_chunk().copied(),
        TexelCoding::Bc7 => blocks::told(layer),
    }
}

/// A layer while it is filled.
pub(super) struct TextureLayer<'a> {
    pub(super) grid: &'a Grid,
    pub(super) width: usize,
    pub(super) texels: &'a mut [u8],
}

impl TextureLayer<'_> {
    /// Writes each texel of a tile to the place of this light in its block, and to the copies of
    /// that place.
    pub(super) fn put(&mut self, tile: &Tile, light: Direction, origin: [u32; 2]) {
        let [width, height] = tile.size();
        self.put_part(tile, [0, 0, width, height], light, origin);
    }

    /// Writes a part of a tile: x, y, width and height in texels of the tile.
    pub(super) fn put_part(
        &mut self,
        tile: &Tile,
        part: [u32; 4],
        light: Direction,
        origin: [u32; 2],
    ) {
        let [left, top, wide, high] = part;
        let lights = self.grid.light;
        let mut rows = vec![light.phi + 1];
        if light.phi == 0 {
            rows.push(lights.phi + 1);
        }
        if light.phi + 1 == lights.phi {
            rows.push(0);
        }
        for y in top..top + high {
            for row in &rows {
                let row = (origin[1] + y * (lights.phi + 2) + row) as usize;
                for x in left..left + wide {
                    let column = (origin[0] + x * lights.theta + light.theta) as usize;
                    let to = 4 * (row * self.width + column);
                    let from = 4 * (y * tile.size()[0] + x) as usize;
                    self.texels[to..to + 4].copy_from_slice(&tile.bytes()[from..from + 4]);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hashed(address: Address, texel: u32) -> [u8; 4] {
        let mut h = 0x9e37_79b9_u32;
        for n in
            [address.view.theta, address.view.phi, address.light.theta, address.light.phi, texel]
        {
            h = (h ^ n).wrapping_mul(0x85eb_ca6b).rotate_left(13);
        }
        [h as u8, (h >> 8) as u8, (h >> 16) as u8, 255]
    }

    #[test]
    fn every_light_stands_where_its_block_says() {
        let grid = Grid {
            size: [3, 2],
            light: Directions { theta: 3, phi: 4 },
            view: Directions { theta: 2, phi: 5 },
        };
        let tiles: HashMap<Address, Arc<Tile>> = grid
            .addresses()
            .map(|address| {
                let texels = (0..6).flat_map(|texel| hashed(address, texel)).collect();
                (address, Arc::new(Tile::new(grid.size, texels).unwrap()))
            })
            .collect();
        let made = layers(
            &grid,
            |address| tiles.get(&address),
            LayerOptions { has_levels: true, ..LayerOptions::default() },
        );
        assert_eq!(
            [u64::from(made.size[0]), u64::from(made.size[1]), u64::from(made.count)],
            layers_size(&grid, true)
        );
        assert_eq!(made.bytes.len() as u64, layers_bytes(&grid, true));
        let texel = |x: u32, y: u32, layer: u32| {
            let at = 4 * ((layer * made.size[1] + y) * made.size[0] + x) as usize;
            <[u8; 4]>::try_from(&made.bytes[at..at + 4]).unwrap()
        };
        for view in 0..10 {
            for (x, y) in (0..3).flat_map(|x| (0..2).map(move |y| (x, y))) {
                for (theta, row) in (0..3).flat_map(|theta| (0..6).map(move |row| (theta, row))) {
                    let phi = (row + 3) % 4;
                    let address = Address::new([theta, phi], [view / 5, view % 5]);
                    assert_eq!(
                        texel(x * 3 + theta, y * 6 + row, view),
                        hashed(address, y * 3 + x),
                        "{address} at {x}, {y}"
                    );
                }
            }
        }
        assert_eq!([texel(0, 0, 10), texel(1, 0, 10)], [[3, 2, 0, 1], [3, 4, 2, 5]]);
        let back = from_layers(&made).unwrap();
        assert_eq!(back.grid, grid);
        assert!(grid.addresses().all(|address| back.painted(address) == tiles.get(&address)));
        for byte in 0..8 {
            let mut lying = made.clone();
            let at = made.bytes.len() - 4 * (made.size[0] * made.size[1]) as usize + byte;
            lying.bytes[at] ^= 0x15;
            assert!(from_layers(&lying).is_err(), "byte {byte}");
        }
        // The whole tile in one texel is at the top right.
        let mean = (0..6)
            .map(|texel| f64::from(hashed(Address::new([2, 1], [1, 3]), texel)[0]))
            .sum::<f64>()
            / 6.0;
        assert_eq!(texel(9 + 2, 2, 8)[0], mean.round() as u8);
    }

    #[test]
    fn views_that_are_equal_share_a_layer() {
        let grid = Grid {
            size: [4, 4],
            light: Directions { theta: 2, phi: 3 },
            view: Directions { theta: 3, phi: 5 },
        };
        let tiles: Vec<Arc<Tile>> =
            (0..3).map(|n| Arc::new(Tile::filled(grid.size, [n, 2, 3, 255]))).collect();
        // The tile is the same for every phi of the view.
        let of = |address: Address| tiles.get(address.view.theta as usize);
        let made = stored(
            &grid,
            of,
            LayerOptions { has_levels: true, ..LayerOptions::default() },
            &Progress::new(),
        )
        .unwrap();
        assert_eq!(made.count, 4);
        assert_eq!(stored_size(&grid, of, true, Storage::Quick)[2], 4);
        let back = from_layers(&made).unwrap();
        assert!(grid.addresses().all(|address| back.painted(address) == of(address)));
        let told = made.bytes.len() - 4 * (made.size[0] * made.size[1]) as usize;
        let mut lying = made;
        lying.bytes[told + 4 * 2] = 3;
        assert!(from_layers(&lying).is_err(), "the first view's layer is no view's");
        // Where the header's layer has no room for the layers of views, each view has its own
        // layer.
        let small = Grid {
            size: [1, 1],
            light: Directions { theta: 1, phi: 1 },
            view: Directions { theta: 9, phi: 9 },
        };
        let tile = Arc::new(Tile::filled([1, 1], [1; 4]));
        let made =
            stored(&small, |_| Some(&tile), LayerOptions::default(), &Progress::new()).unwrap();
        assert_eq!((made.count, from_layers(&made).unwrap().painted.len()), (82, 73));
    }
}
