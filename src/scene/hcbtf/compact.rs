//! The texture of an HCBTF with as little memory as possible without loss: every tile that differs
//! once, with (x, y) innermost, and as indices into a palette where that is smaller.
//!
//! The texture is one long row of words, a texel each, folded into rows of [`SIDE`] and layers of
//! as many rows; the last layer comes first, because a texture's header is in its last layer. Its
//! parts are, one after the other:
//!
//! - two words of the header, which describes the grid, as in every texture (`layers.rs`);
//! - for each sample, view after view, the word where the record of its tile begins;
//! - the records: for each level of a tile, the word where its texels begin and the word where its
//!   palette begins, or 0 for none;
//! - the palettes, a color a word, which many tiles share;
//! - the texels of each level, row after row: a color a word, or four indices.
//!
//! A number is a word's four bytes, the lowest first. Levels that are equal are stored once, too.

use std::collections::HashMap;
use std::sync::Arc;

use indexmap::IndexSet;
use rayon::iter::{IntoParallelRefIterator as _, ParallelIterator as _};

use super::blocks::TexelCoding;
use super::fill::{MAX_SAMPLES, shared};
use super::layers::{HEADER_TEXELS, LayeredTexture, direction, direction_index, paint};
use super::levels::{level_sizes, levels_of};
use crate::document::{Address, Grid, Hcbtf, Tile};

/// Number of words in a row, and of rows in a layer if there are several layers.
/// `shaders/lib/hcbtf.wgsl` contains its logarithm.
pub(super) const SIDE: usize = 2048;
/// Greatest number of colors in a palette, which an index of a byte can distinguish.
const MOST_COLORS: usize = 256;
/// Number of the newest palettes that are tried before a new one is begun.
const TRIED: usize = 8;

/// Layout of a compact texture.
pub(super) struct CompactLayout {
    /// Index of the tile of each sample.
    samples: Vec<u32>,
    /// Index of the piece of each level, by tile.
    levels: Vec<Vec<u32>>,
    pieces: Vec<TileLevel>,
    palettes: Vec<IndexSet<[u8; 4]>>,
}

/// Texels of a level of a tile.
struct TileLevel {
    texels: Arc<Tile>,
    palette: Option<usize>,
}

impl TileLevel {
    fn words(&self) -> usize {
        let texels = self.texels.bytes().len() / 4;
        if self.palette.is_some() { texels.div_ceil(4) } else { texels }
    }
}

/// The width and height of a layer in texels, and the number of layers, computed without making the
/// layers.
pub(super) fn size<'a>(
    grid: &Grid,
    tile: impl Fn(Address) -> Option<&'a Arc<Tile>>,
    has_levels: bool,
) -> [u64; 3] {
    CompactLayout::new(grid, tile, has_levels).size()
}

/// The width and height of a layer, and the number of layers, where no two tiles are alike and none
/// has a palette.
pub(super) fn most(grid: &Grid, has_levels: bool) -> [u64; 3] {
    let count = if has_levels { usize::MAX } else { 1 };
    let texels = level_sizes(grid).take(count).map(|size| u64::from(size[0]) * u64::from(size[1]));
    let tile = texels.fold(0, |words, texels| words + 2 + texels);
    let samples = grid.view.count() as u64 * grid.light.count() as u64;
    folded(
        (HEADER_TEXELS as u64)
            .saturating_add(samples)
            .saturating_add(grid.sample_count().saturating_mul(tile)),
    )
}

/// The width and height of layers, and their number, that hold a number of words.
fn folded(words: u64) -> [u64; 3] {
    let side = SIDE as u64;
    let rows = words.div_ceil(side);
    [words.min(side), rows.min(side), rows.div_ceil(side)]
}

/// The index of each sample's tile among the tiles that differ, view after view; and those tiles. A
/// sample without a tile is transparent black.
pub(super) fn distinct<'a>(
    grid: &Grid,
    tile: impl Fn(Address) -> Option<&'a Arc<Tile>>,
) -> (Vec<u32>, Vec<Arc<Tile>>) {
    let empty = Arc::new(Tile::filled(grid.size, [0; 4]));
    let mut known: HashMap<*const Tile, u32> = HashMap::new();
    let mut tiles: Vec<Arc<Tile>> = Vec::new();
    let mut samples = Vec::with_capacity(grid.view.count() * grid.light.count());
    for view in (0..grid.view.count()).map(|index| direction(index, grid.view.phi)) {
        for light in (0..grid.light.count()).map(|index| direction(index, grid.light.phi)) {
            let tile = tile(Address { view, light }.canonical()).unwrap_or(&empty);
            let next = tiles.len() as u32;
            let index = *known.entry(Arc::as_ptr(tile)).or_insert(next);
            if index == next {
                tiles.push(tile.clone());
            }
            samples.push(index);
        }
    }
    let (tiles, place) = shared(tiles);
    samples.iter_mut().for_each(|sample| *sample = place[*sample as usize]);
    (samples, tiles)
}

impl CompactLayout {
    pub(super) fn new<'a>(
        grid: &Grid,
        tile: impl Fn(Address) -> Option<&'a Arc<Tile>>,
        has_levels: bool,
    ) -> Self {
        let (samples, tiles) = distinct(grid, tile);
        let count = if has_levels { level_sizes(grid).count() } else { 1 };
        let smaller = |tile: &Arc<Tile>| if has_levels { levels_of(tile) } else { Vec::new() };
        let smaller: Vec<Vec<Tile>> = tiles.par_iter().map(smaller).collect();
        let levels_of_one = |(tile, smaller): (Arc<Tile>, Vec<Tile>)| {
            std::iter::once(tile).chain(smaller.into_iter().map(Arc::new))
        };
        let all = tiles.into_iter().zip(smaller).flat_map(levels_of_one);
        let (pieces, place) = shared(all.collect());
        let levels = place.chunks(count).map(<[u32]>::to_vec).collect();
        let mut palettes = Palettes::default();
        let pieces = pieces
            .into_iter()
            .map(|texels| TileLevel { palette: palettes.of(&texels), texels })
            .collect();
        Self { samples, levels, pieces, palettes: palettes.all }
    }

    /// The number of words of the whole texture.
    fn words(&self) -> usize {
        let colors: usize = self.palettes.iter().map(IndexSet::len).sum();
        let texels: usize = self.pieces.iter().map(TileLevel::words).sum();
        HEADER_TEXELS + self.samples.len() + self.records() + colors + texels
    }

    /// The number of words of the records.
    fn records(&self) -> usize {
        2 * self.levels.iter().map(Vec::len).sum::<usize>()
    }

    /// The width and height of a layer in texels, and the number of layers.
    pub(super) fn size(&self) -> [u64; 3] {
        folded(self.words() as u64)
    }

    /// Writes the texture, with the header that describes the grid.
    pub(super) fn write(&self, told: [u8; 8]) -> LayeredTexture {
        let [width, height, count] = self.size();
        let records_at = HEADER_TEXELS + self.samples.len();
        let mut palette_at = Vec::with_capacity(self.palettes.len());
        let mut next = records_at + self.records();
        for palette in &self.palettes {
            palette_at.push(next);
            next += palette.len();
        }
        let mut piece_at = Vec::with_capacity(self.pieces.len());
        for piece in &self.pieces {
            piece_at.push(next);
            next += piece.words();
        }
        let mut record_at = Vec::with_capacity(self.levels.len());
        let mut record = records_at;
        for levels in &self.levels {
            record_at.push(record);
            record += 2 * levels.len();
        }
        let number = |n: usize| (n as u32).to_le_bytes();
        let mut bytes = Vec::with_capacity(4 * (width * height * count) as usize);
        bytes.extend(told);
        bytes.extend(self.samples.iter().flat_map(|tile| number(record_at[*tile as usize])));
        for piece in self.levels.iter().flatten().map(|piece| *piece as usize) {
            let palette = self.pieces[piece].palette.map_or(0, |palette| palette_at[palette]);
            bytes.extend(number(piece_at[piece]).into_iter().chain(number(palette)));
        }
        bytes.extend(self.palettes.iter().flatten().flatten());
        for piece in &self.pieces {
            match piece.palette {
                Some(palette) => {
                    let index = |color: &[u8; 4]| {
                        self.palettes[palette].get_index_of(color).unwrap_or(0) as u8
                    };
                    bytes.extend(colors(&piece.texels).map(index));
                    bytes.resize(bytes.len().next_multiple_of(4), 0);
                }
                None => bytes.extend(piece.texels.bytes()),
            }
        }
        let layer = 4 * (width * height) as usize;
        bytes.resize(layer * count as usize, 0);
        let rgba = match count {
            1 => bytes,
            _ => bytes.chunks_exact(layer).rev().collect::<Vec<_>>().concat(),
        };
        LayeredTexture {
            size: [width as u32, height as u32],
            count: count as u32,
            coding: TexelCoding::Rgba8,
            bytes: rgba,
        }
    }
}

/// Palettes while pieces are added to them.
#[derive(Default)]
struct Palettes {
    all: Vec<IndexSet<[u8; 4]>>,
}

impl Palettes {
    /// The palette for a piece, extended by its colors; `None` if the piece takes less room without
    /// one.
    fn of(&mut self, texels: &Tile) -> Option<usize> {
        let mut own = IndexSet::new();
        for color in colors(texels) {
            own.insert(*color);
            if own.len() > MOST_COLORS {
                return None;
            }
        }
        let first = self.all.len().saturating_sub(TRIED);
        let grown = |at: usize| own.iter().filter(|color| !self.all[at].contains(*color)).count();
        let near = (first..self.all.len()).map(|at| (grown(at), at));
        let near = near.filter(|(grown, at)| self.all[*at].len() + grown <= MOST_COLORS).min();
        let count = texels.bytes().len() / 4;
        let words = |more: usize| count.div_ceil(4) + more;
        if words(near.map_or(own.len(), |(grown, _)| grown)) >= count {
            return None;
        }
        let at = near.map_or(self.all.len(), |(_, at)| at);
        if at == self.all.len() {
            self.all.push(IndexSet::new());
        }
        self.all[at].extend(own);
        Some(at)
    }
}

fn colors(tile: &Tile) -> impl Iterator<Item = &[u8; 4]> {
    tile.bytes().as_chunks().0.iter()
}

/// The HCBTF in a compact texture's words, which begin with the header; `None` if the texture does
/// not hold what its header describes, or if the header describes more samples than allowed.
pub(super) fn read(grid: &Grid, words: &[u8]) -> Option<Hcbtf> {
    let samples = grid.view.count() as u64 * grid.light.count() as u64;
    if samples > MAX_SAMPLES || samples >= words.len() as u64 / 4 {
        return None;
    }
    let word = |index: usize| words.get(4 * index..)?.first_chunk::<4>().copied();
    let number = |index: usize| Some(u32::from_le_bytes(word(index)?) as usize);
    let mut tiles: HashMap<usize, Arc<Tile>> = HashMap::new();
    let mut hcbtf = Hcbtf::new(*grid);
    // Greatest total size of the tiles: that of a texture that stores each tile by itself.
    let mut room = super::MAX_LAYERS_BYTES;
    for address in grid.addresses() {
        let record = number(HEADER_TEXELS + direction_index(grid, address))?;
        if let std::collections::hash_map::Entry::Vacant(entry) = tiles.entry(record) {
            room = room.checked_sub(4 * grid.texels() as u64)?;
            let (texels, palette) = (number(record)?, number(record + 1)?);
            let texel = |index: usize| match palette {
                0 => word(texels + index),
                _ => word(palette + word(texels + index / 4)?[index % 4] as usize),
            };
            // Memory is allocated only for texels that exist.
            texel(grid.texels() - 1)?;
            let rgba: Option<Vec<[u8; 4]>> = (0..grid.texels()).map(texel).collect();
            entry.insert(Arc::new(Tile::new(grid.size, rgba?.into_flattened())?));
        }
        paint(&mut hcbtf, address, &tiles[&record]);
    }
    Some(hcbtf)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Directions, Storage};
    use crate::hcbtf::{LayerOptions, from_layers, ktx2, stored};
    use crate::progress::Progress;

    /// Five large tiles of many colors, one of two colors for all other samples: more than one
    /// layer.
    #[test]
    fn what_is_stored_is_read() {
        let grid = Grid {
            size: [1024, 836],
            light: Directions { theta: 2, phi: 4 },
            view: Directions { theta: 2, phi: 2 },
        };
        let tile = |seed: u32, colors: u32| {
            let texel = |at: u32| {
                (((at ^ seed).wrapping_mul(0x9e37_79b1) % colors) | 0xff00_0000).to_le_bytes()
            };
            Arc::new(
                Tile::new(grid.size, (0..grid.texels() as u32).flat_map(texel).collect()).unwrap(),
            )
        };
        let tiles: Vec<Arc<Tile>> =
            (0..5).map(|seed| tile(seed, 70_000)).chain([tile(9, 2)]).collect();
        let all: HashMap<Address, &Arc<Tile>> = grid
            .addresses()
            .enumerate()
            .map(|(index, address)| (address, &tiles[index.min(5)]))
            .collect();
        let of = |address: Address| all.get(&address).copied();
        let options = LayerOptions { storage: Storage::Compact, ..LayerOptions::default() };
        let made = stored(&grid, of, options, &Progress::new()).unwrap();
        assert_eq!((made.size, made.count), ([2048, 2048], 2));
        let words = 2 + 8 * 4 + 6 * 2 + 2 + 5 * 856_064 + 214_016;
        assert_eq!(folded(words), size(&grid, of, false));
        assert_eq!(made.bytes.len() as u64, 4 * size(&grid, of, false).iter().product::<u64>());
        let back = from_layers(&ktx2::read(&ktx2::write(&made), "a.ktx2").unwrap()).unwrap();
        assert!(grid.addresses().all(|address| back.painted(address) == of(address)));
    }

    /// Tiles of few colors take a quarter, and the words that identify tiles and palettes.
    #[test]
    fn tiles_of_few_colors_share_a_palette() {
        let directions = Directions { theta: 3, phi: 8 };
        let grid = Grid { size: [32, 32], light: directions, view: directions };
        let tiles: Vec<Arc<Tile>> = (0..grid.sample_count() as u32)
            .map(|seed| {
                let texel = |at: u32| {
                    [
                        (at.wrapping_mul(seed + 7) >> 3) as u8 & 0xc0,
                        (at % 40) as u8,
                        seed as u8 & 1,
                        255,
                    ]
                };
                Arc::new(Tile::new(grid.size, (0..1024).flat_map(texel).collect()).unwrap())
            })
            .collect();
        let all: HashMap<Address, &Arc<Tile>> = grid.addresses().zip(&tiles).collect();
        let plan = CompactLayout::new(&grid, |address| all.get(&address).copied(), false);
        assert!(plan.palettes.len() <= 2, "{}", plan.palettes.len());
        let pieces = plan.pieces.len();
        assert!(plan.pieces.iter().all(|piece| piece.palette.is_some()) && pieces > 200);
        assert!(plan.words() <= 2 + 24 * 24 + 2 * pieces + 2 * 256 + pieces * 256);
        assert!(most(&grid, false)[1] * 2048 > 3 * plan.words() as u64);
    }

    #[test]
    fn a_texture_that_lies_is_refused() {
        let directions = Directions { theta: 2, phi: 3 };
        let grid = Grid { size: [4, 3], light: directions, view: directions };
        let tile = Arc::new(Tile::filled(grid.size, [9, 8, 7, 255]));
        let options = LayerOptions { storage: Storage::Compact, ..LayerOptions::default() };
        let made = stored(&grid, |_| Some(&tile), options, &Progress::new()).unwrap();
        assert_eq!(from_layers(&made).unwrap().painted.len() as u64, grid.sample_count());
        // The words where a sample's record begins, and where its texels and its palette begin.
        for word in [2, 2 + 36, 2 + 36 + 1] {
            let mut lying = made.clone();
            lying.bytes[4 * word..4 * word + 4].copy_from_slice(&u32::MAX.to_le_bytes());
            assert!(from_layers(&lying).is_err(), "word {word}");
        }
        let mut short = made;
        short.bytes.truncate(8);
        assert!(from_layers(&short).is_err());
    }
}
