//! Baking: makes the tile of a recipe.

use std::sync::Arc;

use super::blend;
use super::plan::{FillPlan, Recipe, TileSource};
use super::turn::{Color, TurnedTile};
use crate::document::Tile;
use crate::progress::Progress;

/// The tile of a recipe; `None` if the work is stopped.
pub(super) fn tile(plan: &FillPlan<'_>, recipe: &Recipe, progress: &Progress) -> Option<Arc<Tile>> {
    if progress.is_stopped() {
        return None;
    }
    let size = plan.grid.size;
    let rows = Rows { size, recipe, progress };
    let at_once = |tile| {
        progress.add(u64::from(size[1]));
        Some(tile)
    };
    match recipe.source {
        TileSource::Empty => at_once(Arc::new(Tile::filled(size, [0; 4]))),
        TileSource::Uniform(color) => {
            let mapped = Mapping::new(recipe).of(color.map(f32::from));
            at_once(Arc::new(Tile::filled(size, mapped)))
        }
        TileSource::Painted(number) => {
            let painted = plan.painted.get(number as usize)?.tile;
            match (recipe.turn.get() == 0.0, recipe.is_recolored()) {
                (true, false) => at_once(painted.clone()),
                (true, true) => rows.of_bytes(painted),
                (false, _) => rows.turned(plan.is_tiling, |x, y| {
                    let at = 4 * (y * size[0] as usize + x);
                    std::array::from_fn(|channel| f32::from(painted.bytes()[at + channel]))
                }),
            }
        }
        TileSource::Blend { address, sharpness } => {
            let weights = blend::weights(address, sharpness.get(), &plan.grid, &plan.painted);
            let width = size[0] as usize;
            let blend =
                |y: usize, row: &mut [Color]| blend::row(&weights, &plan.painted, y * width, row);
            if recipe.turn.get() == 0.0 {
                return rows.each(|y, row| blend(y, row));
            }
            // The blend itself is turned, before it is rounded.
            let mut blended = vec![[0.0; 4]; plan.grid.texels()];
            for (y, row) in blended.chunks_exact_mut(width).enumerate() {
                if progress.is_stopped() {
                    return None;
                }
                blend(y, row);
            }
            rows.turned(plan.is_tiling, |x, y| blended[y * width + x])
        }
        TileSource::Morph { address, sharpness } => {
            let morph = plan.flows.morph(
                address,
                sharpness.get(),
                &plan.grid,
                plan.is_tiling,
                &plan.painted,
            );
            match recipe.turn.get() == 0.0 {
                true => rows.each(|y, row| {
                    row.iter_mut().enumerate().for_each(|(x, color)| *color = morph.at(x, y));
                }),
                false => rows.turned(plan.is_tiling, |x, y| morph.at(x, y)),
            }
        }
        TileSource::Generated { rule, address } => {
            let drawn = plan.generators.get(rule as usize)?.as_ref()?.tile(address, progress)?;
            let width = size[0] as usize;
            match recipe.turn.get() == 0.0 {
                true => rows.each(|y, row| row.copy_from_slice(&drawn[y * width..(y + 1) * width])),
                false => rows.turned(plan.is_tiling, |x, y| drawn[y * width + x]),
            }
        }
    }
}

/// Change of straight colors from 0 to 255: a factor and an offset for each channel.
pub(super) struct Mapping {
    factors: Color,
    offsets: Color,
}

impl Mapping {
    pub(super) fn new(recipe: &Recipe) -> Self {
        let [r, g, b] = recipe.maps.map(|map| map.map(|number| number.get() as f32));
        Self { factors: [r[0], g[0], b[0], 1.0], offsets: [r[1], g[1], b[1], 0.0] }
    }

    /// The changed color as bytes, rounded to the nearest.
    pub(super) fn of(&self, color: Color) -> [u8; 4] {
        // The conversion from float to byte saturates.
        std::array::from_fn(|i| (color[i] * self.factors[i] + self.offsets[i] + 0.5) as u8)
    }
}

/// The changed value of every byte, for red, green and blue.
fn tables(recipe: &Recipe) -> [[u8; 256]; 3] {
    recipe.maps.map(|map| {
        let [factor, offset] = map.map(|number| number.get());
        std::array::from_fn::<u8, 256, _>(|byte| (byte as f64 * factor + offset + 0.5) as u8)
    })
}

/// Recolors some texels of a painting.
pub(super) fn recolor(recipe: &Recipe, texels: &mut [u8]) {
    let maps = recipe.maps.map(|map| map.map(|number| number.get()));
    for texel in texels.chunks_exact_mut(4) {
        for (channel, [factor, offset]) in texel.iter_mut().zip(maps) {
            *channel = (f64::from(*channel) * factor + offset + 0.5) as u8;
        }
    }
}

/// Maker of a tile, row by row.
struct Rows<'a> {
    size: [u32; 2],
    recipe: &'a Recipe,
    progress: &'a Progress,
}

impl Rows<'_> {
    /// The tile of the colors that `row` writes.
    fn each(&self, mut row: impl FnMut(usize, &mut [Color])) -> Option<Arc<Tile>> {
        let [width, height] = self.size.map(|side| side as usize);
        let mapping = Mapping::new(self.recipe);
        let mut colors = vec![[0.0; 4]; width];
        let mut rgba = Vec::with_capacity(4 * width * height);
        for y in 0..height {
            if self.progress.is_stopped() {
                return None;
            }
            row(y, &mut colors);
            rgba.extend(colors.iter().flat_map(|color| mapping.of(*color)));
            self.progress.add(1);
        }
        Tile::new(self.size, rgba).map(Arc::new)
    }

    fn turned(&self, is_tiling: bool, texel: impl Fn(usize, usize) -> Color) -> Option<Arc<Tile>> {
        let turned = TurnedTile::new(self.size, is_tiling, self.recipe.turn.get(), texel);
        self.each(|y, row| {
            row.iter_mut().enumerate().for_each(|(x, color)| *color = turned.at(x, y));
        })
    }

    /// The recolored bytes of a tile: a table for each channel suffices.
    fn of_bytes(&self, tile: &Tile) -> Option<Arc<Tile>> {
        let tables = tables(self.recipe);
        let mut rgba = tile.bytes().to_vec();
        for row in rgba.chunks_exact_mut(4 * self.size[0] as usize) {
            if self.progress.is_stopped() {
                return None;
            }
            for texel in row.chunks_exact_mut(4) {
                (0..3)
                    .for_each(|channel| texel[channel] = tables[channel][texel[channel] as usize]);
            }
            self.progress.add(1);
        }
        Tile::new(self.size, rgba).map(Arc::new)
    }
}
