//! Update of one sample in the texture that shaders look up: a stroke changes a few texels of a
//! tile, and the texture of all tiles may be hundreds of mebibytes.

use super::layers::{LayerOptions, TextureLayer, layers_size};
use super::levels::levels_of;
use crate::document::{Address, Direction, Directions, Grid, Tile};

/// A rectangle of a layer, in texels of the texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Region {
    /// Index of the layer.
    pub layer: u32,
    /// Upper left corner.
    pub at: [u32; 2],
    /// Width and height.
    pub size: [u32; 2],
}

/// Writes a part of a sample's tile (x, y, width and height in its texels) into a texture that
/// [`layers`](super::layers()) made of the same grid with the same options. Returns the regions
/// that may have changed.
pub fn repaint(
    rgba: &mut [u8],
    grid: &Grid,
    options: LayerOptions,
    address: Address,
    (tile, part): (&Tile, [u32; 4]),
) -> Vec<Region> {
    let [width, height, _] = layers_size(grid, options.has_levels);
    let mut regions = Vec::new();
    let bytes = 4 * (width * height) as usize;
    let block = [grid.light.theta, grid.light.phi + 2];
    let levels = if options.has_levels { levels_of(tile) } else { Vec::new() };
    for view in copies(grid.view, address.view) {
        let layer = view.theta * grid.view.phi + view.phi;
        let Some(texels) = rgba.get_mut(layer as usize * bytes..(layer as usize + 1) * bytes)
        else {
            continue;
        };
        let mut place = TextureLayer { grid, width: width as usize, texels };
        for light in copies(grid.light, address.light) {
            place.put_part(tile, part, light, [0, 0]);
            let mut origin = [grid.size[0] * block[0], 0];
            for level in &levels {
                place.put(level, light, origin);
                origin[1] += level.size()[1] * block[1];
            }
        }
        let [x, y, wide, high] = part;
        let of = |at: [u32; 2]| [at[0] * block[0], at[1] * block[1]];
        regions.push(Region { layer, at: of([x, y]), size: of([wide, high]) });
        if let Some(largest) = levels.first() {
            let down = levels.iter().map(|level| level.size()[1]).sum();
            let at = [grid.size[0] * block[0], 0];
            regions.push(Region { layer, at, size: of([largest.size()[0], down]) });
        }
    }
    regions
}

/// All places where a direction is stored: the normal is stored at every step around it.
fn copies(directions: Directions, direction: Direction) -> impl Iterator<Item = Direction> {
    let steps = match direction.canonical() {
        Direction { theta: 0, .. } => 0..directions.phi,
        Direction { phi, .. } => phi..phi + 1,
    };
    steps.map(move |phi| Direction { theta: direction.theta, phi })
}

#[cfg(test)]
mod tests {
    use std::collections::HashMap;
    use std::sync::Arc;

    use super::*;
    use crate::document::Storage;
    use crate::hcbtf::layers;

    #[test]
    fn a_sample_put_anew_is_as_if_all_had_been_laid_out_anew() {
        let grid = Grid {
            size: [6, 5],
            light: Directions { theta: 3, phi: 4 },
            view: Directions { theta: 2, phi: 3 },
        };
        for has_levels in [false, true] {
            let options = LayerOptions { has_levels, is_decoded: false, storage: Storage::Quick };
            let gray = Arc::new(Tile::filled(grid.size, [90, 91, 92, 255]));
            let mut tiles: HashMap<Address, Arc<Tile>> =
                grid.addresses().map(|at| (at, gray.clone())).collect();
            let mut texture = layers(&grid, |at| tiles.get(&at), options);
            for (light, view) in
                [([0, 0], [0, 0]), ([2, 0], [1, 2]), ([2, 3], [0, 0]), ([0, 0], [1, 1])]
            {
                let address = Address::new(light, view);
                let mut tile = (*tiles[&address]).clone();
                let part = [1, 2, 3, 2];
                for (x, y) in (2..4).flat_map(|y| (1..4).map(move |x| (x, y))) {
                    let at = 4 * (y * 6 + x);
                    tile.bytes_mut()[at..at + 4].copy_from_slice(&[
                        x as u8,
                        y as u8,
                        view[0] as u8,
                        200,
                    ]);
                }
                let before = texture.clone();
                let regions = repaint(&mut texture.bytes, &grid, options, address, (&tile, part));
                tiles.insert(address, Arc::new(tile));
                assert_eq!(texture, layers(&grid, |at| tiles.get(&at), options), "{address}");
                let is_told = |index: usize| {
                    let (x, rest) =
                        (index as u32 % texture.size[0], index as u32 / texture.size[0]);
                    let (y, layer) = (rest % texture.size[1], rest / texture.size[1]);
                    let within =
                        |at: u32, from: u32, count: u32| (from..from + count).contains(&at);
                    regions.iter().any(|region| {
                        region.layer == layer
                            && within(x, region.at[0], region.size[0])
                            && within(y, region.at[1], region.size[1])
                    })
                };
                let texels = texture.bytes.chunks(4).zip(before.bytes.chunks(4)).enumerate();
                for (index, _) in texels.filter(|(_, (now, before))| now != before) {
                    assert!(is_told(index), "{address}: texel {index} changed");
                }
            }
        }
    }
}
