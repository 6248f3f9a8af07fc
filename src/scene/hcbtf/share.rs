//! Sharing of layers between views that look alike.

use std::collections::HashMap;
use std::sync::Arc;

use super::layers::{HEADER_TEXELS, LayeredTexture, SHARED, direction, layers_size};
use crate::document::{Address, Grid, Tile};

/// Views that differ, and the index among them for each view.
pub(super) struct Views {
    /// First view of each group of equal views.
    pub(super) differ: Vec<usize>,
    /// Index into `differ` of each view.
    pub(super) layer: Vec<u32>,
}

/// Finds the views whose samples have the same tiles. If the header's layer has no room for the
/// index of each view, which happens where a layer has hardly a texel, all views count as
/// different.
pub(super) fn views<'a>(grid: &Grid, tile: impl Fn(Address) -> Option<&'a Arc<Tile>>) -> Views {
    let count = grid.view.count();
    let [width, height, _] = layers_size(grid, false);
    if width * height < HEADER_TEXELS as u64 + count as u64 {
        return Views { differ: (0..count).collect(), layer: (0..count as u32).collect() };
    }
    let mut known: HashMap<Vec<Option<*const Tile>>, u32> = HashMap::new();
    let mut views = Views { differ: Vec::new(), layer: Vec::with_capacity(count) };
    for index in 0..count {
        let view = direction(index, grid.view.phi);
        let lights = (0..grid.light.count()).map(|index| direction(index, grid.light.phi));
        let tiles = lights
            .map(|light| tile(Address { view, light }.canonical()).map(Arc::as_ptr))
            .collect();
        let next = known.len() as u32;
        let layer = *known.entry(tiles).or_insert(next);
        if layer == next {
            views.differ.push(index);
        }
        views.layer.push(layer);
    }
    views
}

/// The width and height of a layer in texels, and the number of layers, where views share.
pub(super) fn shared_size(grid: &Grid, views: &Views, has_levels: bool) -> [u64; 3] {
    let [width, height, _] = layers_size(grid, has_levels);
    [width, height, views.differ.len() as u64 + 1]
}

/// Writes the layer of each view, and the flag that the layers of views are written.
pub(super) fn write_shares(layers: &mut LayeredTexture, layer_of: &[u32]) {
    let told = 4 * (layers.size[0] * layers.size[1]) as usize * (layers.count as usize - 1);
    layers.bytes[told + 3] |= SHARED;
    for (texel, layer) in layers.bytes[told..].chunks_exact_mut(4).skip(HEADER_TEXELS).zip(layer_of)
    {
        texel.copy_from_slice(&layer.to_le_bytes());
    }
}
