//! Natural patterns: stones, ripples.

use std::f32::consts::TAU;

use super::{CellMaterial, linear};
use crate::document::relief::Pattern;
use crate::hcbtf::noise::{chances, hash, mix, mix3, ramp, rough};

/// A pattern without straight lines, ready to be sampled.
pub(in crate::hcbtf::generate::relief) struct Nature<'a> {
    pub(super) pattern: &'a Pattern,
    pub(super) seed: u32,
    /// Height of the tile, in tile widths.
    pub(super) aspect: f32,
}

/// The stone at a position.
struct Stone {
    /// Height of the dome: 1 in the stone's middle, 0 at its edge and beyond.
    dome: f32,
    own: u64,
}

impl Nature<'_> {
    /// The height and the material at a position on the tile.
    pub(super) fn at(&self, place: [f32; 2]) -> (f32, CellMaterial) {
        match self.pattern {
            Pattern::Stones { .. } => self.stones(place),
            _ => self.ripples(place),
        }
    }

    fn down(&self, across: u32) -> u32 {
        ((across as f32 * self.aspect).round() as u32).max(1)
    }

    /// The stone at a position, of stones scattered one to each of `count` parts along the tile, of
    /// which the share `share` exists.
    fn stone(&self, salt: u32, count: u32, share: f32, place: [f32; 2]) -> Stone {
        let cells = [count, self.down(count)];
        let at = [place[0] * cells[0] as f32, place[1] * cells[1] as f32];
        let middle = at.map(|part| part.floor() as i64);
        let (mut nearest, mut second, mut own) = (f32::INFINITY, f32::INFINITY, 0);
        for (dx, dy) in (-2..=2).flat_map(|dy| (-2..=2).map(move |dx| (dx, dy))) {
            let (x, y) = (middle[0] + dx, middle[1] + dy);
            let [wide, high] = cells.map(i64::from);
            let stone = hash(self.seed.wrapping_add(salt), x.rem_euclid(wide), y.rem_euclid(high));
            let [right, down, there] = chances(stone);
            if there >= share {
                continue;
            }
            let off = [x as f32 + 0.15 + 0.7 * right - at[0], y as f32 + 0.15 + 0.7 * down - at[1]];
            let distance = off[0].hypot(off[1]);
            if distance < nearest {
                (second, nearest, own) = (nearest, distance, stone);
            } else {
                second = second.min(distance);
            }
        }
        // A stone ends half way to its neighbor, and nowhere is it larger than its own part.
        let [size, ..] = chances(own.rotate_left(17));
        let radius = 0.42 + 0.24 * size;
        let to_edge = (0.5 * (second - nearest)).min(radius - nearest);
        Stone { dome: (to_edge / radius).clamp(0.0, 1.0), own }
    }

    fn stones(&self, place: [f32; 2]) -> (f32, CellMaterial) {
        let Pattern::Stones { count, share, grit, roundness, colors, binder } = self.pattern else {
            return (0.0, CellMaterial::of([0.0; 3]));
        };
        let fine = 4 * *count;
        let grain = rough(self.seed.wrapping_add(41), [fine, self.down(fine)], 2, place);
        let large = self.stone(42, *count, *share as f32, place);
        let small = self.stone(43, fine.div_ceil(2), *grit as f32, place);
        let raised = |stone: &Stone, most: f32| {
            let flat = ramp(0.0, 0.12, stone.dome);
            let round = (stone.dome * (2.0 - stone.dome)).max(0.0).sqrt();
            let [lower, ..] = chances(stone.own.rotate_left(31));
            most * (1.0 - 0.4 * lower) * mix(flat, round, *roundness as f32)
        };
        let (first, second) = (raised(&large, 0.92), raised(&small, 0.5));
        let base = 0.1 * grain;
        let (height, stone) = if first >= second { (first, &large) } else { (second, &small) };
        if height <= 0.06 {
            let color = linear(*binder).map(|channel| channel * (0.75 + 0.5 * grain));
            return (
                base,
                CellMaterial {
                    gloss: 0.15,
                    grain: (64.0 * grain) as u32,
                    ..CellMaterial::of(color)
                },
            );
        }
        let [tint, light, _] = chances(stone.own.rotate_left(7));
        let color = mix3(linear(colors[0]), linear(colors[1]), tint);
        let color =
            color.map(|channel| (channel * (0.8 + 0.3 * light + 0.25 * (grain - 0.5))).min(1.0));
        (
            base + height * (0.9 + 0.08 * grain),
            CellMaterial { grain: stone.own as u32, ..CellMaterial::of(color) },
        )
    }

    fn ripples(&self, place: [f32; 2]) -> (f32, CellMaterial) {
        let Pattern::Ripples { count, bend, roughness, colors } = self.pattern else {
            return (0.0, CellMaterial::of([0.0; 3]));
        };
        let hills = rough(self.seed.wrapping_add(51), [3, self.down(3)], 3, place);
        let fine = rough(self.seed.wrapping_add(52), [24, self.down(24)], 2, place);
        let wave = match count {
            0 => hills,
            _ => {
                let phase = *count as f32 * place[1] + 2.0 * *bend as f32 * (hills - 0.5);
                // Ripples are steeper on one side, as the wind leaves them.
                let phase = phase + 0.08 * (TAU * phase).sin();
                0.5 + 0.5 * (TAU * phase).sin()
            }
        };
        let height = wave * (1.0 - 0.25 * *roughness as f32) + 0.25 * *roughness as f32 * fine;
        let color = mix3(linear(colors[0]), linear(colors[1]), height);
        (height, CellMaterial { grain: (4096.0 * fine) as u32, ..CellMaterial::of(color) })
    }
}
