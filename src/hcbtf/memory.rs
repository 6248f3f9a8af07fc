//! What the texture of an HCBTF takes, before it is made, and whether a device can hold it.

use std::sync::Arc;

use super::blocks::{self, Coding};
use super::compact;
use super::layers::{MAX_LAYERS_BYTES, layers_size, stored_size};
use crate::document::{Address, Grid, Storage, Tile};

/// How large a device's textures may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Texels along a side.
    pub side: u64,
    /// Layers of an array.
    pub layers: u64,
    /// Whether there are textures of compressed blocks; elsewhere they are decoded.
    pub has_blocks: bool,
}

impl Limits {
    /// What every device has that WebGPU runs on.
    pub const GUARANTEED: Self = Self { side: 8192, layers: 256, has_blocks: false };
}

/// What one storage takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Need {
    /// Which.
    pub storage: Storage,
    /// Whether smaller levels of the tile are in it, as smooth lookups read them.
    pub has_levels: bool,
    /// Texels of a layer, and layers.
    pub size: [u64; 3],
}

impl Need {
    /// In bytes, where a device has what it asks for.
    pub fn bytes(&self) -> u64 {
        let coding = if self.storage == Storage::Blocks { Coding::Bc7 } else { Coding::Rgba8 };
        coding.bytes(self.texels())
    }

    /// In bytes on a device of these limits.
    pub fn bytes_on(&self, limits: Limits) -> u64 {
        if limits.has_blocks { self.bytes() } else { Coding::Rgba8.bytes(self.texels()) }
    }

    fn texels(&self) -> u64 {
        self.size.into_iter().fold(1, u64::saturating_mul)
    }

    /// Whether a device of these limits can hold it, and Chiaro makes one so large.
    pub fn fits(&self, limits: Limits) -> bool {
        let [width, height, layers] = self.size;
        let bytes = Coding::Rgba8.bytes(self.texels());
        width.max(height) <= limits.side && layers <= limits.layers && bytes <= MAX_LAYERS_BYTES
    }
}

/// What each storage takes, with and without smaller levels, for these tiles.
pub fn needs<'a>(grid: &Grid, tile: impl Fn(Address) -> Option<&'a Arc<Tile>>) -> Vec<Need> {
    each(|storage, has_levels| stored_size(grid, &tile, has_levels, storage))
}

/// What each takes at most, whatever is painted: no two tiles alike, and each of many colours.
pub fn needs_at_most(grid: &Grid) -> Vec<Need> {
    each(|storage, has_levels| match storage {
        Storage::Quick => layers_size(grid, has_levels),
        Storage::Compact => compact::most(grid, has_levels),
        Storage::Blocks => blocks::most(grid, has_levels),
    })
}

fn each(size: impl Fn(Storage, bool) -> [u64; 3]) -> Vec<Need> {
    let all = Storage::ALL.into_iter().flat_map(|storage| [false, true].map(|has_levels| (storage, has_levels)));
    all.map(|(storage, has_levels)| Need { storage, has_levels, size: size(storage, has_levels) }).collect()
}
