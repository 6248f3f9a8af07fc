//! Built patterns: bricks, facades, arches.

use std::f32::consts::PI;

use super::{CellMaterial, linear, part};
use crate::document::relief::Pattern;
use crate::hcbtf::noise::{chance, chances, hash, mix, mix3, ramp, rough};

/// A built pattern, ready to be sampled.
pub(in crate::hcbtf::generate::relief) struct Masonry<'a> {
    pub(super) pattern: &'a Pattern,
    pub(super) seed: u32,
    /// Height of the tile, in tile widths.
    pub(super) aspect: f32,
}

impl Masonry<'_> {
    /// The height and the material at a position on the tile.
    pub(super) fn at(&self, place: [f32; 2]) -> (f32, CellMaterial) {
        match self.pattern {
            Pattern::Bricks { .. } => self.bricks(place),
            Pattern::Facade { .. } => self.facade(place),
            _ => self.arches(place),
        }
    }

    /// The roughness of the surface at a position, from -1 to 1, with `bumps` bumps along the tile.
    fn roughness(&self, bumps: u32, salt: u32, place: [f32; 2]) -> f32 {
        let down = ((bumps as f32 * self.aspect).round() as u32).max(1);
        2.0 * rough(self.seed.wrapping_add(salt), [bumps, down], 3, place) - 1.0
    }

    fn bricks(&self, place: [f32; 2]) -> (f32, CellMaterial) {
        let Pattern::Bricks {
            columns,
            rows,
            shift,
            joint,
            bevel,
            unevenness,
            roughness,
            colors,
            joint_color,
        } = self.pattern
        else {
            return (0.0, CellMaterial::of([0.0; 3]));
        };
        let roughness = *roughness as f32;
        let course = self.aspect / *rows as f32;
        // Edges are not quite straight.
        let stray = roughness * 0.06 * course;
        let bumps = 3 * (*columns).max(*rows);
        let bent = [
            place[0] + stray * self.roughness(bumps, 11, place),
            place[1] + stray / self.aspect * self.roughness(bumps, 12, place),
        ];
        let (row, fy) = part(bent[1], *rows);
        let (column, fx) =
            part(bent[0] + *shift as f32 * (row % 2) as f32 / *columns as f32, *columns);
        let brick = hash(self.seed, column, row);
        let [high, tint, lean] = chances(brick);
        let half_joint = 0.5 * *joint as f32 * course;
        let [from_side, from_bed] = [
            fx.min(1.0 - fx) / *columns as f32 - half_joint,
            fy.min(1.0 - fy) * course - half_joint,
        ];
        let mottling = self.roughness(4 * bumps, 13, place);
        let inside = from_side.min(from_bed);
        if inside <= 0.0 {
            let sand = 0.5 + 0.5 * mottling;
            let color =
                linear(*joint_color).map(|channel| channel * mix(1.0, 0.7 + 0.6 * sand, roughness));
            return (
                0.12 * roughness * sand,
                CellMaterial { gloss: 0.1, ..CellMaterial::of(color) },
            );
        }
        let edge = (*bevel as f32 * 0.5 * course).max(1e-5);
        // Corners are rounded: the farther of the two edges does not count once it is beyond the
        // bevel.
        let short = [from_side, from_bed].map(|from| (1.0 - from / edge).max(0.0));
        let rounded = (1.0 - short[0].hypot(short[1])).max(0.0);
        let top = 1.0 - *unevenness as f32 * (0.45 * high + 0.25 * (lean - 0.5) * (fx - 0.5));
        let height = top * (0.35 + 0.65 * (rounded * (2.0 - rounded)).sqrt())
            + 0.1 * roughness * (mottling - 0.5);
        let shade = mix(1.0, 0.82 + 0.36 * (0.5 + 0.5 * mottling), roughness);
        let color = mix3(linear(colors[0]), linear(colors[1]), tint)
            .map(|channel| (channel * shade).min(1.0));
        (height, CellMaterial { gloss: 0.6, grain: brick as u32, ..CellMaterial::of(color) })
    }

    fn facade(&self, place: [f32; 2]) -> (f32, CellMaterial) {
        let Pattern::Facade {
            columns,
            floors,
            window,
            frame,
            sill,
            roughness,
            wall,
            trim,
            glass,
            lit,
            lit_color: _,
        } = self.pattern
        else {
            return (0.0, CellMaterial::of([0.0; 3]));
        };
        let (floor, fy) = part(place[1], *floors);
        let (bay, fx) = part(place[0], *columns);
        let bay_size = [1.0 / *columns as f32, self.aspect / *floors as f32];
        let own = hash(self.seed, bay, floor);
        let [first, second, third] = chances(own);
        let (rough, sill) = (*roughness as f32, *sill as f32);
        let plaster = self.roughness(6 * (*columns).max(*floors), 21, place);
        let level = 1.0 - 0.35 * sill;
        // Distance from the window's edge inward, in tile widths; the window stands a little above
        // the middle of its bay.
        let [half_width, half_height] =
            [0.5 * window[0] as f32 * bay_size[0], 0.5 * window[1] as f32 * bay_size[1]];
        let (across, down) = ((fx - 0.5) * bay_size[0], (fy - 0.48) * bay_size[1]);
        let inside = (half_width - across.abs()).min(half_height - down.abs());
        let bar = (*frame as f32 * 2.0 * half_width).max(1e-5);
        if inside > 0.0 {
            let is_cross = across.abs() < 0.3 * bar || (down + 0.3 * half_height).abs() < 0.3 * bar;
            if inside < bar || is_cross {
                return (0.3, CellMaterial { gloss: 0.2, ..CellMaterial::of(linear(*trim)) });
            }
            let is_lit = first < *lit as f32;
            // Curtains and reflections make every pane different.
            let curtain = if second < 0.4 && across * (third - 0.5) > 0.0 { 1.5 } else { 1.0 };
            let color =
                linear(*glass).map(|channel| (channel * curtain * (0.75 + 0.5 * third)).min(1.0));
            let glow = if is_lit { 0.55 + 0.45 * second } else { 0.0 };
            return (
                0.0,
                CellMaterial { gloss: 1.0, glow, grain: own as u32, ..CellMaterial::of(color) },
            );
        }
        let sill_size = 0.09 * bay_size[1];
        let below = down - half_height;
        let is_sill =
            (0.0..sill_size).contains(&below) && across.abs() < half_width + 0.8 * sill_size;
        let is_lintel = (-half_height - sill_size..-half_height).contains(&down)
            && across.abs() < half_width + 0.4 * sill_size;
        let is_band = fy > 1.0 - 0.055;
        if sill > 0.0 && (is_sill || is_lintel || is_band) {
            let height = if is_lintel { mix(level, 1.0, 0.5) } else { 1.0 };
            return (
                height,
                CellMaterial {
                    gloss: 0.1,
                    ..CellMaterial::of(linear(*trim).map(|channel| 0.92 * channel))
                },
            );
        }
        let washed = mix(1.0, 0.86 + 0.28 * (0.5 + 0.5 * plaster), rough);
        let color = linear(*wall).map(|channel| (channel * washed).min(1.0));
        (
            level + 0.05 * rough * (plaster - 1.0),
            CellMaterial { gloss: 0.0, ..CellMaterial::of(color) },
        )
    }

    fn arches(&self, place: [f32; 2]) -> (f32, CellMaterial) {
        let Pattern::Arches {
            columns,
            rows,
            opening,
            ring,
            courses,
            roughness,
            wall,
            trim,
            inside,
        } = self.pattern
        else {
            return (0.0, CellMaterial::of([0.0; 3]));
        };
        let (row, fy) = part(place[1], *rows);
        let (column, fx) = part(place[0], *columns);
        let bay = [1.0 / *columns as f32, self.aspect / *rows as f32];
        let radius = 0.5 * opening[0] as f32 * bay[0];
        // The opening stands on the bay's foot; y is counted from there, upward.
        let (x, y) = ((fx - 0.5) * bay[0], (1.0 - fy) * bay[1] - 0.04 * bay[1]);
        let spring = (opening[1] as f32 * bay[1] - radius).max(0.0);
        let from_middle = if y > spring { x.hypot(y - spring) } else { x.abs() };
        let rough = *roughness as f32;
        let pitted = self.roughness(10 * (*columns).max(*rows), 31, place);
        let shade = mix(1.0, 0.84 + 0.32 * (0.5 + 0.5 * pitted), rough);
        let stone = |color: [u8; 3], tint: f32| {
            linear(color).map(|channel| (channel * shade * tint).min(1.0))
        };
        let ring_width = *ring as f32 * radius;
        let groove = 0.012 * bay[0];
        if y < 0.0 {
            // A ledge runs under all openings.
            return (1.0, CellMaterial { gloss: 0.1, ..CellMaterial::of(stone(*trim, 0.95)) });
        }
        // The opening's side is inclined a little, because a vertical side would have no area in
        // the field.
        let side = 0.05 * radius;
        if from_middle > radius - side && from_middle <= radius {
            let height = ramp(0.0, side, from_middle - radius + side);
            return (height, CellMaterial { gloss: 0.1, ..CellMaterial::of(stone(*trim, 0.9)) });
        }
        if from_middle < radius {
            let deep = ramp(0.0, 1.0, y / (spring + radius).max(1e-5));
            return (
                0.0,
                CellMaterial {
                    gloss: 0.0,
                    ..CellMaterial::of(stone(*inside, mix(1.1, 0.7, deep)))
                },
            );
        }
        if from_middle < radius + ring_width {
            // Stones are wedges in the ring around the arch, blocks beside the opening.
            let (index, off) = if y > spring {
                let wedges = 9.0;
                let at = (y - spring).atan2(x) / PI * wedges;
                (at.floor() as i64, (at - at.round()).abs() * PI / wedges * from_middle)
            } else {
                let high = (0.5 * radius).max(1e-5);
                let at = y / high;
                (
                    100 + at.floor() as i64 + if x > 0.0 { 100 } else { 0 },
                    (at - at.round()).abs() * high,
                )
            };
            let [tint, lift, _] = chances(hash(self.seed, index + 1000 * column, row));
            let height =
                if off < groove { 0.86 } else { 1.0 - 0.05 * lift + 0.03 * rough * (pitted - 1.0) };
            return (
                height,
                CellMaterial { gloss: 0.1, ..CellMaterial::of(stone(*trim, 0.85 + 0.25 * tint)) },
            );
        }
        let (course, cy) = part(fy, *courses);
        let blocks = 2 * *columns;
        let (block, cx) = part(place[0] + 0.5 * (course % 2) as f32 / blocks as f32, blocks);
        let high = bay[1] / *courses as f32;
        let off = (cy.min(1.0 - cy) * high).min(cx.min(1.0 - cx) / blocks as f32);
        let tint = chance(self.seed.wrapping_add(7), block, course + 100 * row);
        let height =
            if off < groove { 0.76 } else { 0.86 + 0.03 * tint + 0.05 * rough * (pitted - 1.0) };
        (height, CellMaterial { gloss: 0.1, ..CellMaterial::of(stone(*wall, 0.86 + 0.22 * tint)) })
    }
}
