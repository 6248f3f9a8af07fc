//! The texture of an HCBTF in compressed blocks (BC7): one byte a texel, with a small loss, for
//! devices that support such blocks.
//!
//! The texture is one long row of blocks of four by four texels, folded into rows of [`SIDE`] and
//! layers of as many rows; the last layer comes first, because a texture's header is in its last
//! layer. Its parts are, one after the other:
//!
//! - two blocks of the header, which describes the grid, in their first texel each;
//! - for each sample, view after view, the number of the block where its tile begins, in the first
//!   texel;
//! - the tiles that differ, for each its levels, the largest first, each row after row of blocks.
//!   (x, y) is innermost: a block has texels of one tile only, and texels beyond the tile's edge
//!   repeat the last texel before it.
//!
//! A number is a texel's four bytes, the lowest first. Decoding BC7 is the same to the bit
//! everywhere, and a block of one color can have any color: so numbers and flat paint are read back
//! unchanged.

use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::Arc;

use block_compression::decode::decode_block_bc7;
use block_compression::encode::compress_rgba8;
use block_compression::{BC7Settings, CompressionVariant};
use rayon::iter::{
    IndexedParallelIterator as _, IntoParallelRefIterator as _, ParallelIterator as _,
};
use rayon::slice::ParallelSliceMut as _;

use super::compact::distinct;
use super::fill::{MAX_SAMPLES, NotFilled};
use super::layers::{HEADER_TEXELS, LayeredTexture, direction_index, paint};
use super::levels::{level_sizes, levels_of};
use crate::document::{Address, Grid, Hcbtf, Tile};
use crate::progress::Progress;

/// Number of blocks in a row, and of rows in a layer if there are several layers.
/// `shaders/lib/hcbtf.wgsl` contains its logarithm.
const SIDE: usize = 512;
/// Edge of a block, in texels.
const EDGE: usize = 4;
/// Size of a block, in bytes.
const BLOCK: usize = 16;
/// Size of a block's texels when decoded, in bytes.
const TEXELS: usize = 4 * EDGE * EDGE;

/// Coding of texels in a texture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum TexelCoding {
    /// Four bytes a texel.
    #[default]
    Rgba8,
    /// Sixteen bytes for a block of four by four texels.
    Bc7,
}

impl TexelCoding {
    /// The size of `texels` texels of a texture whose sides are whole blocks, in bytes.
    pub fn bytes(self, texels: u64) -> u64 {
        match self {
            Self::Rgba8 => texels.saturating_mul(4),
            Self::Bc7 => texels,
        }
    }

    /// The decoded texels, four bytes each, of layers of a size in texels, layer after layer.
    pub fn rgba(self, size: [u32; 2], bytes: &[u8]) -> Cow<'_, [u8]> {
        match self {
            Self::Rgba8 => Cow::Borrowed(bytes),
            Self::Bc7 => Cow::Owned(decoded(size, bytes)),
        }
    }
}

/// Layout of a texture in blocks.
pub(super) struct BlockLayout {
    /// Index of the tile of each sample.
    samples: Vec<u32>,
    tiles: Vec<Arc<Tile>>,
    /// Size of each level, in texels.
    sizes: Vec<[u32; 2]>,
}

/// The number of blocks of an image.
fn blocks_of([width, height]: [u32; 2]) -> usize {
    width.div_ceil(EDGE as u32) as usize * height.div_ceil(EDGE as u32) as usize
}

/// The sizes of the levels that are stored.
fn sizes(grid: &Grid, has_levels: bool) -> Vec<[u32; 2]> {
    level_sizes(grid).take(if has_levels { usize::MAX } else { 1 }).collect()
}

/// The width and height of a layer in texels, and the number of layers, where no two tiles are
/// alike.
pub(super) fn most(grid: &Grid, has_levels: bool) -> [u64; 3] {
    let tile: usize = sizes(grid, has_levels).into_iter().map(blocks_of).sum();
    let samples = grid.view.count() as u64 * grid.light.count() as u64;
    let tiles = grid.sample_count().saturating_mul(tile as u64);
    folded((HEADER_TEXELS as u64).saturating_add(samples).saturating_add(tiles))
}

/// The width and height of layers in texels, and the number of layers, that hold a number of
/// blocks.
fn folded(blocks: u64) -> [u64; 3] {
    let (side, edge) = (SIDE as u64, EDGE as u64);
    let rows = blocks.div_ceil(side);
    [edge * blocks.min(side), edge * rows.min(side), rows.div_ceil(side)]
}

impl BlockLayout {
    pub(super) fn new<'a>(
        grid: &Grid,
        tile: impl Fn(Address) -> Option<&'a Arc<Tile>>,
        has_levels: bool,
    ) -> Self {
        let (samples, tiles) = distinct(grid, tile);
        Self { samples, tiles, sizes: sizes(grid, has_levels) }
    }

    fn blocks_of_tile(&self) -> usize {
        self.sizes.iter().copied().map(blocks_of).sum()
    }

    /// The width and height of a layer in texels, and the number of layers.
    pub(super) fn size(&self) -> [u64; 3] {
        folded(
            (HEADER_TEXELS + self.samples.len() + self.tiles.len() * self.blocks_of_tile()) as u64,
        )
    }

    /// Writes the texture, with the header that describes the grid. `progress` counts tiles.
    pub(super) fn write(
        &self,
        told: [u8; 8],
        progress: &Progress,
    ) -> Result<LayeredTexture, NotFilled> {
        progress.begin(self.tiles.len() as u64);
        let encoded = |tile: &Arc<Tile>| {
            if progress.is_stopped() {
                return Err(NotFilled::Stopped);
            }
            let smaller = if self.sizes.len() > 1 { levels_of(tile) } else { Vec::new() };
            let blocks: Vec<u8> =
                std::iter::once(&**tile).chain(&smaller).flat_map(encoded).collect();
            progress.add(1);
            Ok(blocks)
        };
        let tiles: Vec<Vec<u8>> = self.tiles.par_iter().map(encoded).collect::<Result<_, _>>()?;
        let [width, height, count] = self.size();
        let layer = (width * height) as usize;
        let mut bytes = Vec::with_capacity(layer * count as usize);
        let (first, tile) = (HEADER_TEXELS + self.samples.len(), self.blocks_of_tile());
        bytes.extend(told.as_chunks().0.iter().flat_map(|told| of_one_color(*told)));
        let number = |sample: &u32| ((first + *sample as usize * tile) as u32).to_le_bytes();
        bytes.extend(self.samples.iter().flat_map(|sample| of_one_color(number(sample))));
        bytes.extend(tiles.iter().flatten());
        bytes.resize(layer * count as usize, 0);
        let bytes = match count {
            1 => bytes,
            _ => bytes.chunks_exact(layer).rev().collect::<Vec<_>>().concat(),
        };
        Ok(LayeredTexture {
            size: [width as u32, height as u32],
            count: count as u32,
            coding: TexelCoding::Bc7,
            bytes,
        })
    }
}

/// The blocks of a tile, row after row.
fn encoded(tile: &Tile) -> Vec<u8> {
    let [width, height] = tile.size();
    let mut out = Vec::with_capacity(BLOCK * blocks_of(tile.size()));
    for top in (0..height).step_by(EDGE) {
        for left in (0..width).step_by(EDGE) {
            let mut texels = [0; TEXELS];
            for (index, texel) in (0u32..).zip(texels.as_chunks_mut().0) {
                let [x, y] = [left + index % EDGE as u32, top + index / EDGE as u32];
                *texel = tile.texel(x.min(width - 1).into(), y.min(height - 1).into());
            }
            out.extend(block(&texels));
        }
    }
    out
}

/// The block of four by four texels, compressed.
fn block(texels: &[u8; TEXELS]) -> [u8; BLOCK] {
    let colors: &[[u8; 4]] = texels.as_chunks().0;
    if colors.iter().all(|color| *color == colors[0]) {
        return of_one_color(colors[0]);
    }
    let is_opaque = colors.iter().all(|color| color[3] == u8::MAX);
    // The slower settings take four times as long, and their error is a tenth less.
    let settings =
        if is_opaque { BC7Settings::opaque_very_fast() } else { BC7Settings::alpha_fast() };
    let mut out = [0; BLOCK];
    let edge = EDGE as u32;
    compress_rgba8(CompressionVariant::BC7(settings), texels, &mut out, edge, edge, 4 * edge);
    if is_opaque { opaque(out) } else { out }
}

/// The block of opaque paint, made opaque: the encoder may round alpha to 254 in mode 6, where all
/// channels of an end have the same last bit. Colors are off by 1 at most for that.
fn opaque(block: [u8; BLOCK]) -> [u8; BLOCK] {
    const ENDS_OF_ALPHA: u128 = 0x3fff << 49;
    const LAST_BITS: u128 = 3 << 63;
    match block[0] & 0x7f {
        0x40 => (u128::from_le_bytes(block) | ENDS_OF_ALPHA | LAST_BITS).to_le_bytes(),
        _ => block,
    }
}

/// A block whose sixteen texels have one color, any color: mode 5, with every texel a third of the
/// way between two ends of seven bits, which exist for each of the 256 values; alpha has eight
/// bits.
fn of_one_color(color: [u8; 4]) -> [u8; BLOCK] {
    let mut bits: u128 = 1 << 5;
    let mut at = 8;
    for channel in &color[..3] {
        for end in ends(*channel) {
            bits |= u128::from(end) << at;
            at += 7;
        }
    }
    for _ in 0..2 {
        bits |= u128::from(color[3]) << at;
        at += 8;
    }
    // The index of the first texel has one bit, those of the others two: every index is 1.
    bits |= 1 << at;
    at += 1;
    for _ in 1..EDGE * EDGE {
        bits |= 1 << at;
        at += 2;
    }
    bits.to_le_bytes()
}

/// Two numbers of seven bits such that the second of the four steps between them is the number of
/// eight bits.
fn ends(wanted: u8) -> [u8; 2] {
    let near = wanted / 2;
    let whole = |end: u8| u32::from(end << 1 | end >> 6);
    let around = || (near.saturating_sub(1)..=near.saturating_add(1)).filter(|end| *end < 128);
    let pairs = around().flat_map(|low| around().map(move |high| [low, high]));
    let is_right = |[low, high]: &[u8; 2]| {
        (43 * whole(*low) + 21 * whole(*high) + 32) >> 6 == u32::from(wanted)
    };
    pairs.into_iter().find(is_right).unwrap_or([near, near])
}

/// The header in the first two blocks of a layer.
pub(super) fn told(layer: &[u8]) -> Option<[u8; 8]> {
    let mut told = [0; 8];
    for (index, told) in told.as_chunks_mut::<4>().0.iter_mut().enumerate() {
        let mut texels = [0; TEXELS];
        decode_block_bc7(
            layer.get(BLOCK * index..)?.first_chunk::<BLOCK>()?,
            &mut texels,
            4 * EDGE,
        );
        *told = *texels.first_chunk()?;
    }
    Some(told)
}

/// The decoded texels of blocks, four bytes each, rows from the top, layer after layer.
fn decoded(size: [u32; 2], bytes: &[u8]) -> Vec<u8> {
    let stride = 4 * size[0] as usize;
    let across = size[0] as usize / EDGE;
    let mut rgba = vec![0; 4 * bytes.len()];
    if across > 0 {
        let rows = rgba.par_chunks_exact_mut(EDGE * stride).enumerate();
        rows.for_each(|(row, texels)| {
            for (index, block) in
                bytes[BLOCK * across * row..][..BLOCK * across].chunks_exact(BLOCK).enumerate()
            {
                decode_block_bc7(block, &mut texels[4 * EDGE * index..], stride);
            }
        });
    }
    rgba
}

/// The HCBTF in such a texture, as it is after the loss; `None` if the texture does not hold what
/// its header describes.
pub(super) fn read(grid: &Grid, layers: &LayeredTexture, has_levels: bool) -> Option<Hcbtf> {
    let samples = grid.view.count() as u64 * grid.light.count() as u64;
    let count = layers.bytes.len() / BLOCK;
    if layers.coding != TexelCoding::Bc7 || samples > MAX_SAMPLES || samples >= count as u64 {
        return None;
    }
    let of_layer = count / layers.count.max(1) as usize;
    let texels = |index: usize| {
        let layer = (layers.count as usize).checked_sub(index.checked_div(of_layer)? + 1)?;
        let block =
            layers.bytes.get(BLOCK * (layer * of_layer + index % of_layer)..)?.get(..BLOCK)?;
        let mut texels = [0; TEXELS];
        decode_block_bc7(block, &mut texels, 4 * EDGE);
        Some(texels)
    };
    let number = |index: usize| Some(u32::from_le_bytes(*texels(index)?.first_chunk()?) as usize);
    let of_tile: usize = sizes(grid, has_levels).into_iter().map(blocks_of).sum();
    let mut tiles: HashMap<usize, Arc<Tile>> = HashMap::new();
    let mut hcbtf = Hcbtf::new(*grid);
    // Greatest total size of the tiles: that of a texture that stores each tile by itself.
    let mut room = super::MAX_LAYERS_BYTES;
    for address in grid.addresses() {
        let at = number(HEADER_TEXELS + direction_index(grid, address))?;
        if let std::collections::hash_map::Entry::Vacant(entry) = tiles.entry(at) {
            room = room.checked_sub(4 * grid.texels() as u64)?;
            // Memory is allocated only for blocks that exist.
            (at.checked_add(of_tile)? <= count).then_some(())?;
            let [width, height] = grid.size.map(|side| side as usize);
            let across = width.div_ceil(EDGE);
            let mut rgba = vec![0; 4 * grid.texels()];
            for (index, block) in (at..at + blocks_of(grid.size)).enumerate() {
                let texels = texels(block)?;
                let [left, top] = [index % across * EDGE, index / across * EDGE];
                for (row, texels) in texels.chunks_exact(4 * EDGE).enumerate().take(height - top) {
                    let wide = 4 * EDGE.min(width - left);
                    rgba[4 * ((top + row) * width + left)..][..wide]
                        .copy_from_slice(&texels[..wide]);
                }
            }
            entry.insert(Arc::new(Tile::new(grid.size, rgba)?));
        }
        paint(&mut hcbtf, address, &tiles[&at]);
    }
    Some(hcbtf)
}

/// Difference of texels from the painted ones, in 255ths, as seen over black: transparent texels
/// have no color.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Loss {
    /// Root mean square over all channels of all tiles that differ.
    pub rms: f64,
    /// Largest difference of any channel.
    pub largest: f64,
}

/// The loss of a texture against the tiles that it was made of; none if the texture has no blocks.
/// Smaller levels are not compared.
pub fn loss<'a>(
    grid: &Grid,
    tile: impl Fn(Address) -> Option<&'a Arc<Tile>>,
    layers: &LayeredTexture,
) -> Loss {
    let Some(shown) =
        (layers.coding == TexelCoding::Bc7).then(|| super::from_layers(layers).ok()).flatten()
    else {
        return Loss::default();
    };
    let pairs: HashMap<*const Tile, (&Tile, Option<&Arc<Tile>>)> = grid
        .addresses()
        .filter_map(|address| {
            tile(address).map(|tile| (Arc::as_ptr(tile), (&**tile, shown.painted(address))))
        })
        .collect();
    let mut sum = 0.0;
    let mut count = 0;
    let mut loss = Loss::default();
    let over_black = |[r, g, b, a]: [u8; 4]| {
        let alpha = f64::from(a) / 255.0;
        [alpha * f64::from(r), alpha * f64::from(g), alpha * f64::from(b), f64::from(a)]
    };
    for (painted, shown) in pairs.into_values() {
        for (index, painted) in painted.bytes().as_chunks().0.iter().enumerate() {
            let shown = shown
                .and_then(|shown| shown.bytes().as_chunks().0.get(index))
                .copied()
                .unwrap_or_default();
            for (painted, shown) in over_black(*painted).into_iter().zip(over_black(shown)) {
                let off = (painted - shown).abs();
                sum += off * off;
                count += 1;
                loss.largest = loss.largest.max(off);
            }
        }
    }
    Loss { rms: (sum / f64::from(count.max(1))).sqrt(), ..loss }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Directions, Storage};
    use crate::hcbtf::{LayerOptions, from_layers, ktx2, stored};

    fn grid(size: [u32; 2]) -> Grid {
        Grid { size, light: Directions { theta: 2, phi: 3 }, view: Directions { theta: 3, phi: 4 } }
    }

    const OPTIONS: LayerOptions =
        LayerOptions { has_levels: true, is_decoded: false, storage: Storage::Blocks };

    #[test]
    fn a_block_of_one_color_has_any_color() {
        for value in 0..=u8::MAX {
            let color = [value, value.rotate_left(3), !value, value.wrapping_mul(77)];
            let mut texels = [0; TEXELS];
            decode_block_bc7(&of_one_color(color), &mut texels, 4 * EDGE);
            assert_eq!(texels.as_chunks().0, [color; 16], "{value}");
        }
    }

    /// Any colors, in whichever mode they are encoded.
    #[test]
    fn opaque_paint_stays_opaque() {
        let mut random = 7_u64;
        for spread in [2, 5, 12, 40, 120, 255] {
            for _ in 0..300 {
                let mut texels = [u8::MAX; TEXELS];
                for (index, byte) in
                    texels.iter_mut().enumerate().filter(|(index, _)| index % 4 < 3)
                {
                    random =
                        random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(index as u64);
                    *byte = ((random >> 33) % spread) as u8;
                }
                let mut shown = [0; TEXELS];
                decode_block_bc7(&block(&texels), &mut shown, 4 * EDGE);
                assert!(shown.chunks(4).all(|texel| texel[3] == u8::MAX), "{texels:?} {shown:?}");
            }
        }
    }

    /// Smooth paint, whose blocks are nearly exact; of odd sizes and of sizes that are whole
    /// blocks.
    #[test]
    fn what_is_stored_is_nearly_read() {
        for size in [[8, 8], [5, 3], [1, 1], [13, 6]] {
            let grid = grid(size);
            let tile = |seed: u32| {
                let texel = |at: u32| {
                    let [x, y] = [at % size[0], at / size[0]];
                    [
                        (90 + 7 * x + seed) as u8,
                        (200 - 9 * y) as u8,
                        (40 + 4 * x + 5 * y) as u8,
                        255,
                    ]
                };
                Arc::new(
                    Tile::new(size, (0..grid.texels() as u32).flat_map(texel).collect()).unwrap(),
                )
            };
            let tiles: Vec<Arc<Tile>> = (0..5).map(tile).collect();
            let of =
                |address: Address| tiles.get((address.view.phi + address.light.theta) as usize);
            let made = stored(&grid, of, OPTIONS, &Progress::new()).unwrap();
            assert_eq!(
                made.bytes.len() as u64,
                BlockLayout::new(&grid, of, true).size().iter().product::<u64>()
            );
            let back = from_layers(&ktx2::read(&ktx2::write(&made), "a.ktx2").unwrap()).unwrap();
            let mut largest = 0;
            for address in grid.addresses() {
                let (painted, shown) = (of(address).unwrap(), back.painted(address).unwrap());
                let off = painted
                    .bytes()
                    .iter()
                    .zip(shown.bytes())
                    .map(|(a, b)| a.abs_diff(*b))
                    .max()
                    .unwrap();
                assert!(off <= 6, "{size:?} {address}: {off:?}");
                largest = largest.max(off);
                assert!(
                    shown.bytes().chunks(4).all(|texel| texel[3] == 255),
                    "{size:?} {address}: it stays opaque"
                );
            }
            let loss = loss(&grid, of, &made);
            assert_eq!(loss.largest, f64::from(largest));
            assert!(loss.rms <= loss.largest, "{loss:?}");
        }
    }

    #[test]
    fn a_texture_that_lies_is_refused() {
        let grid = grid([9, 5]);
        let tile = Arc::new(Tile::filled(grid.size, [9, 8, 7, 255]));
        let made = stored(&grid, |_| Some(&tile), OPTIONS, &Progress::new()).unwrap();
        let back = from_layers(&made).unwrap();
        assert_eq!(back.painted.len() as u64, grid.sample_count());
        assert!(back.painted.values().all(|shown| *shown == tile), "flat paint is as it was");
        // The word where a sample's tile begins.
        let mut lying = made.clone();
        lying.bytes[BLOCK * HEADER_TEXELS..][..BLOCK].copy_from_slice(&of_one_color([0xff; 4]));
        assert!(from_layers(&lying).is_err());
        let mut short = made.clone();
        short.bytes.truncate(32);
        assert!(from_layers(&short).is_err());
        // Any bytes are read or refused.
        let mut random = 1_u64;
        for _ in 0..200 {
            let mut other = made.clone();
            for byte in &mut other.bytes[2 * BLOCK..] {
                random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                *byte = (random >> 56) as u8;
            }
            let _ = from_layers(&other);
        }
    }

    #[test]
    fn encoding_is_counted_and_can_be_stopped() {
        let grid = grid([6, 6]);
        let tiles =
            [Arc::new(Tile::filled(grid.size, [1; 4])), Arc::new(Tile::filled(grid.size, [2; 4]))];
        let of = |address: Address| tiles.get(usize::from(address.view.theta > 0));
        let progress = Progress::new();
        stored(&grid, of, OPTIONS, &progress).unwrap();
        assert_eq!(progress.steps(), [2, 2]);
        progress.stop();
        assert_eq!(stored(&grid, of, OPTIONS, &progress).unwrap_err().code, "stopped");
    }
}
