//! Places and properties of strokes: from the seed alone, so the same in every sample.

use std::f32::consts::TAU;

use glam::{Vec2, Vec3};

use crate::document::{Bundle, Placement, StrokeShape, Strokes};
use crate::hcbtf::noise::mixed;
use crate::progress::Progress;

/// Number of pieces of a stroke that is not a path.
const SEGMENTS: usize = 8;
/// Number of places that are tried for each stroke; the one that is farthest from all others is
/// taken (Mitchell 1991).
const CANDIDATES: u64 = 12;

/// A stroke as it stands before it is turned with the eye.
#[derive(Clone, Debug)]
pub(super) struct ScatteredStroke {
    pub(super) bundle: usize,
    /// Rank of the stroke within its bundle, 0 to 1.
    pub(super) rank: f64,
    /// Place that the stroke turns about.
    pub(super) place: Vec2,
    /// Points from root to tip: along u, along v, over the surface, in widths of the tile.
    pub(super) points: Vec<Vec3>,
    pub(super) half_width: f32,
    /// Color of the root, straight RGB from 0 to 255.
    pub(super) root: Vec3,
    pub(super) tip: Vec3,
}

/// Pseudorandom numbers: each depends only on the seed and on the purpose of the number.
#[derive(Clone, Copy)]
struct SeededNumbers {
    seed: u64,
}

impl SeededNumbers {
    /// The number for a purpose and an index, from 0 to below 1.
    fn roll(self, what: u64, index: u64) -> f32 {
        (mixed(self.seed ^ mixed(what.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ mixed(index))) >> 40)
            as f32
            / 16_777_216.0
    }

    /// The number for a purpose and an index, between two bounds.
    fn between(self, what: u64, index: u64, [from, to]: [f64; 2]) -> f32 {
        from as f32 + (to - from) as f32 * self.roll(what, index)
    }
}

/// All strokes of a tile that is `height` of its widths high; `None` if the work is stopped.
pub(super) fn strokes(
    of: &Strokes,
    height: f32,
    is_tiling: bool,
    progress: &Progress,
) -> Option<Vec<ScatteredStroke>> {
    let mut all = Vec::new();
    for (number, bundle) in of.bundles.iter().enumerate() {
        let dice = SeededNumbers { seed: mixed(u64::from(of.seed) << 8 | number as u64) };
        match &bundle.place {
            Placement::Scatter(count) => {
                let places = scattered(*count as usize, height, is_tiling, dice, progress)?;
                grow(&mut all, number, bundle, &places, dice);
            }
            Placement::Lattice(count) => {
                grow(&mut all, number, bundle, &lattice(*count, height, dice), dice);
            }
            Placement::Paths(paths) => along(&mut all, number, bundle, paths, dice),
        }
    }
    Some(all)
}

/// Places that are evenly scattered; the first few of them, however many, are evenly scattered as
/// well.
fn scattered(
    count: usize,
    height: f32,
    is_tiling: bool,
    dice: SeededNumbers,
    progress: &Progress,
) -> Option<Vec<Vec2>> {
    let mut places: Vec<Vec2> = Vec::with_capacity(count);
    for index in 0..count as u64 {
        if progress.is_stopped() {
            return None;
        }
        let candidate = |number: u64| {
            let at = index * CANDIDATES + number;
            let place = Vec2::new(dice.roll(1, at), height * dice.roll(2, at));
            let squared = |other: &Vec2| {
                let apart = (place - *other).abs();
                let apart =
                    if is_tiling { apart.min(Vec2::new(1.0, height) - apart) } else { apart };
                apart.length_squared()
            };
            (places.iter().map(squared).fold(f32::INFINITY, f32::min), place)
        };
        // Of equal candidates the first is taken, so that rounding does not decide.
        let best = (0..CANDIDATES)
            .map(candidate)
            .reduce(|best, next| if next.0 > best.0 { next } else { best });
        places.extend(best.map(|(_, place)| place));
    }
    Some(places)
}

/// Places on rows that are shifted by half, in a pseudorandom order.
fn lattice(count: u32, height: f32, dice: SeededNumbers) -> Vec<Vec2> {
    let columns = (count as f32 / (2.0 * height)).sqrt().round().max(1.0) as u32;
    let rows = 2 * (columns as f32 * height).round().max(1.0) as u32;
    let place = |row: u32, column: u32| {
        let along = (column as f32 + 0.25 + 0.5 * (row % 2) as f32) / columns as f32;
        Vec2::new(along, height * (row as f32 + 0.5) / rows as f32)
    };
    let all = (0..rows).flat_map(|row| (0..columns).map(move |column| place(row, column)));
    let mut places: Vec<(u32, Vec2)> = all
        .enumerate()
        .map(|(index, place)| ((dice.roll(3, index as u64) * 16_777_216.0) as u32, place))
        .collect();
    places.sort_by_key(|(order, _)| *order);
    places.into_iter().map(|(_, place)| place).collect()
}

/// Appends the strokes of a bundle at these places.
fn grow(
    all: &mut Vec<ScatteredStroke>,
    number: usize,
    bundle: &Bundle,
    places: &[Vec2],
    dice: SeededNumbers,
) {
    for (index, place) in places.iter().enumerate() {
        let rank = (index as f64 + 0.5) / places.len() as f64;
        let points = if bundle.shape == StrokeShape::Dot {
            vec![place.extend(dice.between(11, index as u64, bundle.lift))]
        } else {
            curve(bundle, *place, dice, index as u64)
        };
        all.push(stroke(number, bundle, *place, points, rank, dice, index as u64));
    }
}

/// The points of a stroke that leans, bends and curls.
fn curve(bundle: &Bundle, place: Vec2, dice: SeededNumbers, index: u64) -> Vec<Vec3> {
    let is_flat = bundle.shape == StrokeShape::Ribbon;
    let length = dice.between(4, index, bundle.length);
    let heading =
        bundle.direction as f32 + bundle.spread as f32 * (2.0 * dice.roll(5, index) - 1.0);
    let curl = bundle.curl as f32 * (2.0 * dice.roll(6, index) - 1.0);
    let mut at = place.extend(dice.between(11, index, bundle.lift));
    let mut points = vec![at];
    for segment in 0..SEGMENTS {
        let part = (segment as f32 + 0.5) / SEGMENTS as f32;
        let lean = (bundle.lean + bundle.bend * f64::from(part)) as f32;
        let heading = heading + curl * (part - if is_flat { 0.5 } else { 0.0 });
        let (sin, cos) = lean.sin_cos();
        // A quarter of a turn lies flat, but for rounding.
        let up = if cos.abs() < 1e-6 { 0.0 } else { cos };
        at += Vec3::new(sin * heading.sin(), sin * heading.cos(), up) * (length / SEGMENTS as f32);
        // Strokes do not grow into the ground.
        at.z = at.z.max(0.0);
        points.push(at);
    }
    if is_flat {
        let middle = points[SEGMENTS / 2].truncate() - place;
        points.iter_mut().for_each(|point| *point -= middle.extend(0.0));
    }
    points
}

/// Appends strokes along paths that somebody drew.
fn along(
    all: &mut Vec<ScatteredStroke>,
    number: usize,
    bundle: &Bundle,
    paths: &[Vec<[f64; 3]>],
    dice: SeededNumbers,
) {
    for (index, path) in paths.iter().enumerate().filter(|(_, path)| !path.is_empty()) {
        let rank = (index as f64 + 0.5) / paths.len() as f64;
        let points: Vec<Vec3> =
            path.iter().map(|[u, v, h]| Vec3::new(*u as f32, *v as f32, *h as f32)).collect();
        let middle =
            points.iter().map(|point| point.truncate()).sum::<Vec2>() / points.len() as f32;
        if bundle.shape == StrokeShape::Dot || points.len() == 1 {
            let dots = points.iter().map(|point| vec![*point]);
            dots.for_each(|dot| {
                all.push(stroke(number, bundle, middle, dot, rank, dice, index as u64));
            });
        } else {
            all.push(stroke(number, bundle, middle, points, rank, dice, index as u64));
        }
    }
}

fn stroke(
    number: usize,
    bundle: &Bundle,
    place: Vec2,
    points: Vec<Vec3>,
    rank: f64,
    dice: SeededNumbers,
    index: u64,
) -> ScatteredStroke {
    let rgb = |color: [u8; 3]| Vec3::from(color.map(f32::from));
    let mix = dice.roll(7, index);
    let light = 1.0 + bundle.variation as f32 * (2.0 * dice.roll(8, index) - 1.0);
    let between = |[from, to]: [[u8; 3]; 2]| rgb(from).lerp(rgb(to), mix) * light;
    ScatteredStroke {
        bundle: number,
        rank,
        place,
        points,
        half_width: 0.5 * dice.between(9, index, bundle.width),
        root: between(bundle.root),
        tip: between(bundle.tip),
    }
}

impl ScatteredStroke {
    /// The points as an eye sees them at a step around the normal, after `turns` turns about the
    /// stroke's place.
    pub(super) fn turned(&self, turns: f64) -> Vec<Vec3> {
        let turns = turns.rem_euclid(1.0) as f32;
        if turns == 0.0 {
            return self.points.clone();
        }
        let (sin, cos) = (TAU * turns).sin_cos();
        let turned = |point: &Vec3| {
            let from = point.truncate() - self.place;
            // Turns go from v toward u.
            let by = Vec2::new(from.x * cos + from.y * sin, from.y * cos - from.x * sin);
            (self.place + by).extend(point.z)
        };
        self.points.iter().map(turned).collect()
    }

    /// The greatest height of the stroke.
    pub(super) fn top(&self) -> f32 {
        self.points.iter().map(|point| point.z).fold(0.0, f32::max)
    }
}
