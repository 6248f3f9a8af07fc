//! Strokes as a picture over the one that is painted on: veils of their goals, hatching where the
//! picture is to stay, and a dashed outline that is visible on any ground.
//!
//! Goals are made from the picture of the fit, whose pixels are large on the screen. So veils are
//! smoothed over these pixels, and outlines are drawn by the distance from the stroke's edge.

use std::f32::consts::PI;
use std::ops::Range;

use eframe::egui::{Color32, ColorImage};

use super::ground::Ground;
use super::target::FINENESS;
use crate::document::Tile;

/// Length of the light and of the dark dashes of an outline, in pixels of the sketch.
const DASH: f32 = 4.0;
/// Distance between the hatching lines over parts that are to stay, in pixels of the sketch.
const HATCH: u32 = 9;
/// Largest difference from the shown color at which a goal counts as keeping it, about the steps of
/// eight bits.
const SAME: f64 = 2.5 / 255.0;
/// Approximate width of an outline, in pixels of the sketch.
const WIDE: f32 = 1.5;

/// Picture of the strokes, as large as their sketch.
pub(super) fn strokes(tile: &Tile, ground: Option<&Ground>, outlines_only: bool) -> ColorImage {
    let mut overlay = StrokeOverlay::of(tile);
    if let Some(ground) = ground.filter(|_| !outlines_only) {
        overlay.lay_veils(tile, ground);
        // Smoothing twice spreads a pixel of the fit over its own width on each side.
        overlay.smooth();
        overlay.smooth();
        overlay.lay_hatching(tile, ground);
    }
    overlay.lay_outlines(tile);
    overlay.into_image()
}

/// Overlay of premultiplied colors, 0 to 1; outside `columns` and `rows` it is clear.
struct StrokeOverlay {
    size: [usize; 2],
    colors: Vec<[f32; 4]>,
    columns: Range<usize>,
    rows: Range<usize>,
}

impl StrokeOverlay {
    /// Clear overlay over all that a sketch covers, with a small margin.
    fn of(tile: &Tile) -> Self {
        let size = tile.size().map(|side| side as usize);
        let (texels, _) = tile.bytes().as_chunks::<4>();
        let (mut low, mut high) = (size, [0; 2]);
        for (index, _) in texels.iter().enumerate().filter(|(_, texel)| texel[3] > 0) {
            for (axis, at) in [index % size[0], index / size[0]].into_iter().enumerate() {
                (low[axis], high[axis]) = (low[axis].min(at), high[axis].max(at + 1));
            }
        }
        let around = 2 * FINENESS as usize;
        let range =
            |axis: usize| low[axis].saturating_sub(around)..(high[axis] + around).min(size[axis]);
        Self { size, colors: vec![[0.0; 4]; size[0] * size[1]], columns: range(0), rows: range(1) }
    }

    /// Every place, with its index.
    fn places(&self) -> impl Iterator<Item = ([usize; 2], usize)> + use<> {
        let (width, columns) = (self.size[0], self.columns.clone());
        self.rows.clone().flat_map(move |y| columns.clone().map(move |x| ([x, y], y * width + x)))
    }

    /// Every place with a goal: the place, its index, the goal's color and its weight.
    fn goals<'a>(
        &self,
        tile: &'a Tile,
    ) -> impl Iterator<Item = ([usize; 2], usize, [f64; 3], f64)> + use<'a> {
        let (texels, _) = tile.bytes().as_chunks::<4>();
        let goal = self
            .places()
            .map(|(at, index)| (at, index, texels[index].map(|byte| f64::from(byte) / 255.0)));
        goal.filter(|(.., [_, _, _, alpha])| *alpha > 0.0)
            .map(|(at, index, [r, g, b, a])| (at, index, [r, g, b], a))
    }

    fn lay_veils(&mut self, tile: &Tile, ground: &Ground) {
        for (at, index, goal, alpha) in self.goals(tile) {
            if !stays(goal, shown(ground, at)) {
                self.colors[index] = veil(shown(ground, at), goal, alpha);
            }
        }
    }

    fn lay_hatching(&mut self, tile: &Tile, ground: &Ground) {
        for (at, index, goal, alpha) in self.goals(tile) {
            if stays(goal, shown(ground, at)) {
                let along = ((at[0] + at[1]) as u32 % HATCH) as f32;
                let line = (1.5 - (along - 2.0).abs()).clamp(0.0, 1.0);
                self.over(index, 1.0, 0.45 * line * alpha as f32);
            }
        }
    }

    fn lay_outlines(&mut self, tile: &Tile) {
        let (texels, _) = tile.bytes().as_chunks::<4>();
        let [width, height] = self.size;
        let share = |x: usize, y: usize| {
            f32::from(texels[y.min(height - 1) * width + x.min(width - 1)][3]) / 255.0
        };
        for ([x, y], index) in self.places() {
            let across = share(x + 1, y) - share(x.saturating_sub(1), y);
            let down = share(x, y + 1) - share(x, y.saturating_sub(1));
            let slope = 0.5 * across.hypot(down);
            if slope < 0.01 {
                continue;
            }
            let distance = (share(x, y) - 0.5).abs() / slope;
            let light = 0.5 + 1.5 * ((x + y) as f32 * PI / DASH).sin();
            self.over(index, light.clamp(0.0, 1.0), 0.85 * (WIDE - distance).clamp(0.0, 1.0));
        }
    }

    /// Lays a gray over a place.
    fn over(&mut self, index: usize, gray: f32, alpha: f32) {
        let below = self.colors[index];
        let new = [gray, gray, gray, 1.0];
        self.colors[index] = std::array::from_fn(|c| new[c] * alpha + below[c] * (1.0 - alpha));
    }

    /// Blurs by means over as many pixels as a pixel of the fit has, along both axes.
    fn smooth(&mut self) {
        let half = FINENESS as usize / 2;
        for axis in [0, 1] {
            let before = self.colors.clone();
            for (at, index) in self.places() {
                let stride = [1, self.size[0]][axis];
                let around =
                    at[axis].saturating_sub(half)..(at[axis] + half + 1).min(self.size[axis]);
                let count = around.len() as f32;
                let first = index - (at[axis] - around.start) * stride;
                let mut sum = [0.0; 4];
                for step in 0..around.len() {
                    let color = before[first + step * stride];
                    (0..4).for_each(|c| sum[c] += color[c]);
                }
                self.colors[index] = sum.map(|x| x / count);
            }
        }
    }

    fn into_image(self) -> ColorImage {
        let byte = |x: f32| (x.clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
        let mut image = ColorImage::filled(self.size, Color32::TRANSPARENT);
        for (_, index) in self.places() {
            let [r, g, b, a] = self.colors[index].map(byte);
            image.pixels[index] = Color32::from_rgba_premultiplied(r, g, b, a);
        }
        image
    }
}

/// Color of the ground under a pixel of the sketch.
fn shown(ground: &Ground, [x, y]: [usize; 2]) -> [f64; 3] {
    let place = |at: usize| (at as f64 + 0.5) / f64::from(FINENESS);
    ground.at(place(x), place(y)).0
}

/// True if a goal keeps the shown color.
fn stays(goal: [f64; 3], shown: [f64; 3]) -> bool {
    goal.iter().zip(shown).all(|(goal, shown)| (goal - shown).abs() < SAME)
}

/// Thinnest veil over the shown color that gives the goal's color, so that the picture's own detail
/// shows through, times the goal's share. Premultiplied.
fn veil(shown: [f64; 3], goal: [f64; 3], share: f64) -> [f32; 4] {
    let cover = shown.iter().zip(goal).map(|(shown, goal)| {
        let room = if goal > *shown { 1.0 - shown } else { *shown };
        ((goal - shown).abs() / room.max(1e-6)).min(1.0)
    });
    let cover = cover.fold(0.0, f64::max).max(1e-6);
    let channel = |c: usize| (goal[c] - shown[c] * (1.0 - cover)).clamp(0.0, cover) * share;
    [channel(0) as f32, channel(1) as f32, channel(2) as f32, (cover * share) as f32]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A block of a light goal is surrounded by others: the screen shows no step from one to the
    /// next.
    #[test]
    fn veils_have_no_blocks_and_a_stroke_has_an_outline() {
        let fine = FINENESS as usize;
        let size = [20 * FINENESS; 2];
        let mut tile = Tile::filled(size, [0; 4]);
        let width = size[0] as usize;
        for (x, y) in
            (0..10 * fine).flat_map(|y| (0..10 * fine).map(move |x| (x + 5 * fine, y + 5 * fine)))
        {
            let is_lighter = (x / fine + y / fine).is_multiple_of(2);
            let value = if is_lighter { 200 } else { 160 };
            tile.bytes_mut()[4 * (y * width + x)..][..4]
                .copy_from_slice(&[value, value, value, 255]);
        }
        let ground = Ground::flat([20; 2], [0.4; 3]);
        let image = strokes(&tile, Some(&ground), false);
        let at = |x: usize, y: usize| image.pixels[y * width + x];
        let middle = 10 * fine;
        let steps =
            (middle - 6..middle + 6).map(|x| at(x, middle).a().abs_diff(at(x + 1, middle).a()));
        assert!(
            steps.max().unwrap() < 12,
            "{:?}",
            (middle - 6..middle + 6).map(|x| at(x, middle).a()).collect::<Vec<_>>()
        );
        assert!(at(5 * fine, middle).a() > 120 && at(5 * fine - 4, middle).a() == 0);
        let outlines = strokes(&tile, Some(&ground), true);
        assert_eq!(outlines.pixels[middle * width + middle], Color32::TRANSPARENT);
        assert!(outlines.pixels[middle * width + 5 * fine].a() > 100);
    }
}
