//! Stamping with a picture at any size.

use std::sync::Arc;

use glam::DVec2;

use super::blend::premultiplied;
use super::symmetry::StrokeCopy;
use crate::document::Tile;

/// Least scale of a smaller level, in texels of the tile: levels are halved until one of their
/// texels is at least this large.
const FINEST: f64 = 1.5;

/// A picture with its smaller levels.
#[derive(Clone, Debug)]
pub(super) struct PicturePyramid {
    tile: Arc<Tile>,
    /// Levels half as large, a quarter as large, and so on; premultiplied.
    halves: Vec<Level>,
}

#[derive(Clone, Debug)]
struct Level {
    size: [i64; 2],
    texels: Vec<[f32; 4]>,
}

/// A picture laid on the tile.
#[derive(Clone, Copy, Debug)]
pub(super) struct PlacedPicture<'p> {
    picture: &'p PicturePyramid,
    center: DVec2,
    copy: StrokeCopy,
    /// Distance that the picture reaches from its middle, in the tile's texels.
    pub(super) reach: DVec2,
    /// Number of the picture's texels to one of the tile.
    scale: f64,
    level: usize,
}

impl PicturePyramid {
    /// A picture for brushes of at least `least` texels.
    pub(super) fn new(tile: &Arc<Tile>, least: f64) -> Self {
        let mut picture = Self { tile: tile.clone(), halves: Vec::new() };
        let width = f64::from(tile.size()[0]);
        let mut scale = width / least.max(1.0);
        while scale > FINEST {
            let level = picture.halves.len();
            let size = picture.size(level).map(|side| (side + 1) / 2);
            let texels = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (x, y)));
            let texels = texels.map(|(x, y)| {
                let four = [(0, 0), (1, 0), (0, 1), (1, 1)]
                    .map(|(i, j)| picture.texel(level, 2 * x + i, 2 * y + j));
                std::array::from_fn(|channel| {
                    four.iter().map(|texel| texel[channel]).sum::<f32>() / 4.0
                })
            });
            let texels = texels.collect();
            picture.halves.push(Level { size, texels });
            scale /= 2.0;
        }
        picture
    }

    /// The height over the width.
    pub(super) fn aspect(&self) -> f64 {
        let [width, height] = self.tile.size().map(f64::from);
        height / width
    }

    /// The middle of a stamp at a position: moved to whole texels if the picture is laid texel by
    /// texel.
    pub(super) fn middle(&self, at: DVec2, size: f64) -> DVec2 {
        let half = DVec2::from(self.tile.size().map(f64::from)) / 2.0;
        if size == 2.0 * half.x { (at - half + 0.5).floor() + half } else { at }
    }

    /// The picture laid on the tile, `size` texels wide.
    pub(super) fn laid(&self, center: DVec2, size: f64, copy: StrokeCopy) -> PlacedPicture<'_> {
        let half = DVec2::new(size, size * self.aspect()) / 2.0;
        let mut scale = f64::from(self.tile.size()[0]) / size;
        let turned = copy.turn.x_axis.abs() * half.x + copy.turn.y_axis.abs() * half.y;
        let mut laid =
            PlacedPicture { picture: self, center, copy, reach: turned + 0.5, scale, level: 0 };
        while scale > FINEST && laid.level < self.halves.len() {
            scale /= 2.0;
            laid.level += 1;
        }
        laid
    }

    fn size(&self, level: usize) -> [i64; 2] {
        match level.checked_sub(1) {
            None => self.tile.size().map(i64::from),
            Some(half) => self.halves[half].size,
        }
    }

    /// A premultiplied texel of a level; transparent outside.
    fn texel(&self, level: usize, x: i64, y: i64) -> [f32; 4] {
        let size = self.size(level);
        if !(0..size[0]).contains(&x) || !(0..size[1]).contains(&y) {
            return [0.0; 4];
        }
        match level.checked_sub(1) {
            None => premultiplied(self.tile.texel(x, y)),
            Some(half) => self.halves[half].texels[(y * size[0] + x) as usize],
        }
    }
}

impl PlacedPicture<'_> {
    /// The texels that the picture may meet, along x and along y.
    pub(super) fn ranges(&self) -> [[i64; 2]; 2] {
        let (low, high) = ((self.center - self.reach).floor(), (self.center + self.reach).ceil());
        [[low.x as i64, high.x as i64], [low.y as i64, high.y as i64]]
    }

    /// The color at a texel of the tile, premultiplied, interpolated between the four nearest
    /// texels of the picture.
    pub(super) fn color(&self, column: i64, row: i64) -> [f32; 4] {
        let away = DVec2::new(column as f64, row as f64) + 0.5 - self.center;
        let half = DVec2::from(self.picture.tile.size().map(f64::from)) / 2.0;
        let on_picture = self.copy.turn.transpose() * away * self.scale + half;
        // A level's texels are that many of the picture's wide.
        let at = on_picture / f64::from(1_u32 << self.level) - 0.5;
        let (first, part) = (at.floor(), at - at.floor());
        let (x, y) = (first.x as i64, first.y as i64);
        let mut sum = [0.0; 4];
        for (i, j, weight) in [
            (0, 0, (1.0 - part.x) * (1.0 - part.y)),
            (1, 0, part.x * (1.0 - part.y)),
            (0, 1, (1.0 - part.x) * part.y),
            (1, 1, part.x * part.y),
        ] {
            if weight > 0.0 {
                let texel = self.picture.texel(self.level, x + i, y + j);
                sum = std::array::from_fn(|channel| sum[channel] + texel[channel] * weight as f32);
            }
        }
        sum
    }
}
