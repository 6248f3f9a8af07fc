//! Half-tones, dither, paper and marks on the GPU against f64: every dot and every stroke is found
//! by a search through all candidates, and means equal the tone.
#![cfg(feature = "gpu")]

use crate::support;
use crate::support::wait::block_on;
use std::f64::consts::{PI, TAU};

use crate::support::badf::{f32_of, held};
use crate::support::eval::{eval_with, look, options, renderer, told};
use crate::support::held::{SampleInputs, library, numeric, run_at, words};
use crate::support::noise::{lattice, noise, unit3};
use crate::support::random::Random;
use crate::support::report::Errors;
use chiaro::compile::Live;
use chiaro::frame::{Assets, EvalSample, LightOverride, PlanOptions, Planner, open};
use chiaro::library::{Context, Library, Type};
use glam::{DMat2, DVec2, DVec3};
use serde_json::{Value as Json, json};

fn unit(x: f64) -> f64 {
    x.clamp(0.0, 1.0)
}

fn v2(v: &[f64]) -> DVec2 {
    DVec2::from_slice(v)
}

// Half-tones

/// Share of a cell that lies within a disk around its middle, by halving the cell's quarter into
/// strips.
fn covered_by_disk(radius: f64) -> f64 {
    const STRIPS: usize = 4000;
    let strip = |i: usize| {
        let x = (i as f64 + 0.5) / STRIPS as f64 * 0.5;
        (radius * radius - x * x).max(0.0).sqrt().min(0.5)
    };
    4.0 * (0..STRIPS).map(strip).sum::<f64>() * 0.5 / STRIPS as f64
}

fn halftone(shape: &str, i: SampleInputs<'_>) -> Vec<f64> {
    let share = 1.0 - unit(i[0][0]);
    let cell = DVec2::from_angle(i[3][0]).rotate(v2(&i[1]) * i[2][0].max(0.0));
    let near = cell - cell.round();
    let ink = match shape {
        // A dot covers the points with less than the share of the cell nearer to its middle.
        "dots" => covered_by_disk(near.length()) <= share,
        "lines" => 2.0 * near.y.abs() <= share,
        _ => {
            let each = 1.0 - (1.0 - share).sqrt();
            2.0 * near.x.abs() <= each || 2.0 * near.y.abs() <= each
        }
    };
    vec![if ink && share > 0.0 { 0.0 } else { 1.0 }]
}

// Dither

/// The tile as the shader has it; tests/surfaces/blue_noise.rs tests that it is made by void and
/// cluster.
fn blue_tile() -> Vec<f64> {
    let text = include_str!("../../shaders/lib/blue_noise.wgsl");
    let numbers =
        text.split("0x").skip(1).filter_map(|rest| u32::from_str_radix(rest.get(..8)?, 16).ok());
    numbers
        .take(256)
        .flat_map(|n| n.to_le_bytes().map(|turn| (f64::from(turn) + 0.5) / 256.0))
        .collect()
}

fn blue(cell: [i64; 2], tile: &[f64]) -> f64 {
    tile[(cell[1].rem_euclid(32) * 32 + cell[0].rem_euclid(32)) as usize]
}

/// Bayer's matrix by its recursion, rows from the top.
fn bayer(side: usize) -> Vec<Vec<f64>> {
    if side == 1 {
        return vec![vec![0.0]];
    }
    let half = bayer(side / 2);
    let n = side / 2;
    let at = |x: usize, y: usize| 4.0 * half[y % n][x % n] + [[0.0, 2.0], [3.0, 1.0]][y / n][x / n];
    (0..side).map(|y| (0..side).map(|x| at(x, y)).collect()).collect()
}

fn dither(pattern: &str, i: SampleInputs<'_>, tile: &[f64]) -> Vec<f64> {
    let cell = (v2(&i[1]) / i[4][0].max(1e-3)).floor().to_array().map(|x| x as i64);
    let threshold = match pattern {
        "blue" => blue(cell, tile),
        "white" => unit3(lattice([cell[0], cell[1], 0], 77)).x,
        _ => {
            let side: usize =
                pattern.rsplit('_').next().and_then(|n| n.parse().ok()).expect("a size");
            let [x, y] = cell.map(|c| c.rem_euclid(side as i64) as usize);
            (bayer(side)[y][x] + 0.5) / (side * side) as f64
        }
    };
    let steps = i[2][0].trunc().clamp(2.0, 256.0) - 1.0;
    let x = unit(i[0][0]) * steps;
    // Half-way between two tones both are equally likely.
    let low = x.floor().min(steps - 1.0);
    let upper = (x - low) - 0.5 >= (threshold - 0.5) * unit(i[3][0]);
    vec![(low + f64::from(u8::from(upper))) / steps]
}

// Marks

/// A place in units of spacings, with its stretch.
fn spaced(place: &[f64], stretch: &[f64], count: f64) -> (DVec2, [f64; 3]) {
    // The picture of a sample is one pixel high.
    let is_pixel = stretch[0] + stretch[2] <= 0.0;
    (
        v2(place) * count.max(0.0),
        if is_pixel { [1.0, 0.0, 1.0] } else { [stretch[0], stretch[1], stretch[2]] },
    )
}

struct Stroke {
    turn: f64,
    profile: f64,
}

/// The stroke on the line at (odd number) / 2^octave, at the place `x` along the line.
fn stroke(line: [i64; 2], x: f64, level: f64, [length, taper]: [f64; 2], seed: u32) -> Stroke {
    let own = unit3(lattice([line[0], line[1], 1 << 20], seed));
    let of = |zoom: i32| {
        if length <= 0.0 {
            return (own.y, 1.0);
        }
        let along = x * 2_f64.powi(zoom) / length + own.x;
        let chance = unit3(lattice(
            [line[0], line[1], along.floor() as i64],
            seed.wrapping_add(zoom as u32),
        ));
        let end = (along - along.floor()).min(along.ceil() - along);
        let slope = unit(end / (0.5 * taper).max(1e-6));
        (chance.x, 1.0 - (1.0 - slope).powi(2))
    };
    let zoom = level.floor();
    let (a, b, f) = (of(zoom as i32), of(zoom as i32 + 1), level - zoom);
    Stroke { turn: a.0 + f * (b.0 - a.0), profile: a.1 + f * (b.1 - a.1) }
}

/// 1 where there is ink: a search through every drawn line of every octave near the place.
fn hatching(i: SampleInputs<'_>) -> Vec<f64> {
    let number = |k: usize| i[k][0];
    let ink = 1.0 - unit(number(0));
    let (p, stretch) = spaced(&i[1], &i[2], number(3));
    let width = unit(number(4));
    let layers = number(5).trunc().clamp(1.0, 4.0);
    let (pressure, variation) = (unit(number(10)), unit(number(11)));
    for layer in 0..layers as u32 {
        let seed = (number(12).trunc() as i32 as u32).wrapping_add(101 * layer);
        let amount = unit(ink * layers - f64::from(layer));
        if amount <= 0.0 {
            continue;
        }
        let along = DVec2::from_angle(f64::from(layer) * number(6));
        let across = along.perp();
        let square = across.x * across.x * stretch[0]
            + 2.0 * across.x * across.y * stretch[1]
            + across.y * across.y * stretch[2];
        // Strokes become no finer where the place is stretched more than eight times.
        let square = square.max((stretch[0] + stretch[2]) / 65.0);
        let level = (-0.5 * square.max(1e-30).log2()).clamp(-16.0, 16.0);
        let (x, mut y) = (along.dot(p), across.dot(p));
        let stray = |zoom: i32| {
            let scale = 2_f64.powi(zoom);
            let at = DVec3::new(0.11 * x * scale, 0.45 * y * scale, 0.5);
            (2.0 * noise("value", at, seed) - 1.0) / scale
        };
        let zoom = level.floor();
        y += number(9).clamp(0.0, 100.0)
            * ((1.0 - level + zoom) * stray(zoom as i32) + (level - zoom) * stray(zoom as i32 + 1));
        let density = level + (1.0 - pressure) * amount.log2();
        let whole = density.floor() as i32;
        let growth = 2_f64.powf(density - density.floor()) - 1.0;
        let fine = 2_f64.powi(whole + 1);
        let middle = (y * fine).round() as i64;
        for k in middle - 3..=middle + 3 {
            let power = if k == 0 { 1 } else { 1 << k.trailing_zeros() };
            let octave = i64::from(whole + 1) - i64::from(k.trailing_zeros());
            let line = if k == 0 { [0, 0] } else { [k / power, octave] };
            let Stroke { turn, profile } =
                stroke(line, x, level, [number(7), unit(number(8))], seed);
            let late = 0.75 * variation;
            let grown = if k % 2 == 0 { 1.0 } else { unit((growth - late * turn) / (1.0 - late)) };
            let half = 0.5 * width * amount.powf(pressure) * 2_f64.powf(-level) * grown * profile;
            if half > 0.0 && (y - k as f64 / fine).abs() <= half {
                return vec![1.0];
            }
        }
    }
    vec![0.0]
}

fn seed_of(x: f64) -> u32 {
    x.trunc() as i32 as u32
}

/// Length in the picture of an offset of a place, through the inverse of the stretch's matrix.
fn picture_length(offset: DVec2, s: [f64; 3]) -> f64 {
    let m = DMat2::from_cols(DVec2::new(s[0], s[1]), DVec2::new(s[1], s[2]));
    (offset.dot(m.inverse() * offset).max(0.0) * m.determinant() / area_square(s)).sqrt()
}

/// Square of the area that a stretch makes of a unit area, by its two principal stretches; a ratio
/// of more than eight counts as eight.
fn area_square(s: [f64; 3]) -> f64 {
    let spread = (0.5 * (s[0] - s[2])).hypot(s[1]);
    let [most, least] = [1.0, -1.0].map(|sign| 0.5 * (s[0] + s[2]) + sign * spread);
    (most * least).max((most + least).powi(2) / 66.0)
}

/// The coarser of two octaves, and the share of the dots drawn of each.
fn octaves(stretch: [f64; 3]) -> (f64, [f64; 2]) {
    let area = area_square(stretch);
    let level = (-0.25 * area.max(1e-60).log2()).clamp(-16.0, 16.0);
    let f = level - level.floor();
    // The coarser octave has as many cells in the picture as an octave of exactly the size would
    // have.
    let cells = 4_f64.powf(-f);
    (level.floor(), [1.0 - f, (1.0 - (1.0 - f) * cells) / (4.0 * cells)])
}

fn stippling(i: SampleInputs<'_>, tile: &[f64]) -> Vec<f64> {
    let (p, stretch) = spaced(&i[1], &i[2], i[3][0]);
    let (size, scatter, seed) = (i[4][0].clamp(0.0, 1.4), unit(i[5][0]), seed_of(i[6][0]));
    let (zoom, shares) = octaves(stretch);
    for (octave, share) in [zoom as i32, zoom as i32 + 1].into_iter().zip(shares) {
        let scale = 2_f64.powi(octave);
        let q = p * scale;
        let corner = q.floor();
        for k in 0..9 {
            let cell = corner + DVec2::new(f64::from(k % 3 - 1), f64::from(k / 3 - 1));
            let [x, y] = cell.to_array().map(|c| c as i64);
            let chance = unit3(lattice([x, y, i64::from(octave)], seed));
            let offset = q - (cell + 0.5 + scatter * (DVec2::new(chance.x, chance.y) - 0.5));
            let turn =
                blue([x + i64::from(seed & 31), y + 7 * i64::from(octave)], tile) * 31.0 / 32.0;
            let radius = 0.5 * size * unit(((1.0 - unit(i[0][0])) * share - turn) * 32.0).sqrt();
            let is_cut = offset.length() > 1.0 - 0.5 * scatter;
            if radius > 0.0
                && picture_length(offset, stretch.map(|s| s * scale * scale)) <= radius
                && !is_cut
            {
                return vec![1.0];
            }
        }
    }
    vec![0.0]
}

fn paper_grain(i: SampleInputs<'_>) -> Vec<f64> {
    let (p, stretch) = spaced(&i[1], &i[2], i[3][0]);
    let area = area_square(stretch);
    let level = (-0.25 * area.max(1e-60).log2()).clamp(-16.0, 16.0);
    let sheet = |zoom: i32| {
        let q = p * 2_f64.powi(zoom);
        let seed = seed_of(i[6][0]).wrapping_add(7_u32.wrapping_mul(zoom as u32));
        let felt = 2.7 * DVec2::new(0.8, 0.6).rotate(q);
        let at = |q: DVec2, seed: u32| noise("perlin", DVec3::new(q.x, q.y, 0.5), seed) - 0.5;
        unit(0.5 + 1.4 * (at(q, seed) + unit(i[5][0]) * at(felt, seed.wrapping_add(1))))
    };
    let f = level - level.floor();
    let both = (1.0 - f) * sheet(level.floor() as i32) + f * sheet(level.floor() as i32 + 1);
    let height = unit(0.5 + (both - 0.5) / f.hypot(1.0 - f));
    let ink = 1.0 - unit(i[0][0]);
    vec![1.0 - unit(ink + unit(i[4][0]) * (2.0 * height - 1.0) * 4.0 * ink * (1.0 - ink)), height]
}

const PIXEL: Context = Context::named("pixel");
const ANCHOR: Context = Context::named("anchor");
const MAGNIFICATION: Context = Context::named("magnification");

/// A place and how its coordinates change along the picture: by stepping aside in the picture and
/// going on along the line of sight to the surface.
fn mark_place(follow: &str, i: SampleInputs<'_>, at: &EvalSample) -> Vec<f64> {
    let (n, v) = (at.normal.normalize(), at.view.normalize());
    let turned = |place: DVec2, angle: f64| DVec2::from_angle(-angle).rotate(place);
    let size = 1.0 / at.contexts[&MAGNIFICATION][0];
    let aside = v.any_orthonormal_vector();
    let steps = [aside, v.cross(aside)];
    let answer = |place: DVec2, changes: [DVec2; 2]| {
        let [a, b] = changes;
        vec![place.x, place.y, a.x * a.x + b.x * b.x, a.x * a.y + b.x * b.y, a.y * a.y + b.y * b.y]
    };
    let on_surface = |coordinates: &dyn Fn(DVec3) -> DVec2, normal: DVec3| {
        let reach = 1e-3;
        let here = coordinates(DVec3::ZERO);
        let changes = steps.map(|step| {
            let beside = step * reach;
            let hit = beside - v * (beside.dot(normal) / v.dot(normal));
            (coordinates(hit) - here) / reach * size
        });
        (here, changes)
    };
    let across_axis = |axis: DVec3, normal: DVec3, angle: f64| {
        let z = axis.normalize();
        let x = DVec3::Y.cross(z).normalize();
        let (_, changes) = on_surface(&|p| turned(DVec2::new(p.dot(x), p.dot(z)), angle), normal);
        let here = DVec2::new(at.position.dot(x), at.position.dot(z));
        answer(turned(here, angle), changes)
    };
    match follow {
        "light" => across_axis(
            at.lights[0].direction.expect("a direction"),
            DVec3::from_slice(&i[3]).normalize(),
            i[4][0],
        ),
        "axis" => {
            across_axis(DVec3::from_slice(&i[0]), DVec3::from_slice(&i[3]).normalize(), i[4][0])
        }
        "uv" => {
            let tangent = at.tangent.expect("a tangent");
            let t = (tangent - n * n.dot(tangent)).normalize();
            let b = n.cross(t);
            let normal = DVec3::from_slice(&i[3]).normalize();
            let (_, changes) =
                on_surface(&|p| turned(DVec2::new(p.dot(t), p.dot(b)), i[4][0]), normal);
            answer(turned(v2(&i[1]) * i[2][0].clamp(1e-3, 1e3), i[4][0]), changes)
        }
        _ => {
            let anchor = DVec3::from_slice(&at.contexts[&ANCHOR]);
            let (origin, scale) = if follow == "object" {
                (DVec2::new(anchor.x, -anchor.y), 1.0 / anchor.z)
            } else {
                (DVec2::ZERO, 1.0)
            };
            let pixel = v2(&at.contexts[&PIXEL]);
            let place = (DVec2::new(pixel.x - 0.5, 0.5 - pixel.y) - origin) * scale;
            answer(turned(place, i[4][0]), [DVec2::X * scale, DVec2::Y * scale])
        }
    }
}

fn truth(
    kind: &str,
    word: &str,
    i: SampleInputs<'_>,
    at: &EvalSample,
    tile: &[f64],
) -> Option<Vec<f64>> {
    Some(match kind {
        "screen_place" => {
            let [x, y] = v2(&at.contexts[&PIXEL]).to_array();
            vec![x, y, x - 0.5, 0.5 - y, x, 1.0 - y]
        }
        "halftone" => halftone(word, i),
        "dither" => dither(word, i, tile),
        "hatching" => hatching(i),
        "stippling" => stippling(i, tile),
        "paper_grain" => paper_grain(i),
        "mark_place" => mark_place(word, i, at),
        _ => return None,
    })
}

/// Random numbers in the range of an input.
fn random_value(kind: &str, name: &str, ty: &Type, random: &mut Random) -> Vec<f64> {
    let between =
        |low: f64, high: f64, random: &mut Random| vec![f32_of(random.between(low, high))];
    match (kind, name) {
        (_, "stretch") => {
            // A symmetric matrix that stretches both ways.
            let (a, b) = (random.between(0.3, 4.0), random.between(0.3, 4.0));
            let turn = DVec2::from_angle(random.between(0.0, TAU));
            let s = DMat2::from_cols(turn * a, turn.perp() * b);
            let m = s * s.transpose();
            if random.chance(0.3) {
                vec![0.0; 3]
            } else {
                vec![f32_of(m.x_axis.x), f32_of(m.x_axis.y), f32_of(m.y_axis.y)]
            }
        }
        (_, "axis" | "normal") => {
            held(random.direction()).to_array().map(|x| f32_of(1.5 * x)).to_vec()
        }
        ("dither", "place") => (0..2).map(|_| f32_of(random.between(-70.0, 70.0))).collect(),
        (_, "levels") => vec![2.0 + random.index(6) as f64],
        ("dither", "size") => between(1.0, 4.0, random),
        (_, "lines" | "count") => between(3.0, 60.0, random),
        (_, "layers") => vec![1.0 + random.index(4) as f64],
        (_, "length") => {
            if random.chance(0.2) {
                vec![0.0]
            } else {
                between(2.0, 30.0, random)
            }
        }
        (_, "seed") => vec![random.index(1000) as f64 - 300.0],
        (_, "angle" | "cross") => between(-3.0, 3.0, random),
        ("stippling", "size") => between(0.3, 1.4, random),
        (_, "unit") => between(0.1, 8.0, random),
        (_, "wobble") => between(0.0, 2.0, random),
        _ if *ty == Type::Vec2 => (0..2).map(|_| f32_of(random.between(-1.0, 1.0))).collect(),
        _ => between(-0.1, 1.1, random),
    }
}

fn sample(random: &mut Random) -> EvalSample {
    let normal = held(random.direction());
    // A direction toward the viewer, away from grazing views.
    let view = loop {
        let view = held(random.direction());
        if view.dot(normal) > 0.2 {
            break view;
        }
    };
    let light =
        LightOverride { direction: Some(held(random.direction())), ..LightOverride::default() };
    EvalSample {
        normal,
        view,
        tangent: Some(held(random.direction())),
        position: held(random.direction()),
        contexts: [
            (PIXEL, vec![f32_of(random.unit()), f32_of(random.unit())]),
            (
                ANCHOR,
                vec![
                    f32_of(random.unit()),
                    f32_of(random.unit()),
                    f32_of(random.between(0.1, 2.0)),
                ],
            ),
            (MAGNIFICATION, vec![f32_of(random.between(0.05, 2.0))]),
        ]
        .into(),
        lights: [("key".into(), light)].into_iter().collect(),
        ..EvalSample::default()
    }
}

#[test]
fn every_mark_is_where_it_must_be() {
    let (library, tile) = (library(), blue_tile());
    assert_eq!(tile.len(), 1024);
    for def in Library::built_in()
        .nodes
        .values()
        .filter(|def| matches!(def.category.as_str(), "screen" | "marks"))
    {
        for (port, word) in words(def) {
            let choice: &[(&str, &str)] = if word.is_empty() { &[] } else { &[(&port, &word)] };
            let types: Vec<Type> = numeric(def).iter().map(|input| input.ty.clone()).collect();
            let mut random = Random::new(600);
            let (mut rows, mut places) = (Vec::new(), Vec::new());
            for _ in 0..1000 {
                let at = sample(&mut random);
                let value = |(input, ty): (&&chiaro::library::Input, &Type)| {
                    if input.name.as_str() == "normal" {
                        return (1.5 * at.normal).to_array().map(f32_of).to_vec();
                    }
                    random_value(&def.kind, input.name.as_str(), ty, &mut random)
                };
                rows.push(numeric(def).iter().zip(&types).map(value).collect::<Vec<_>>());
                places.push(at);
            }
            if truth(&def.kind, &word, &rows[0], &places[0], &tile).is_none() {
                continue;
            }
            let mut errors = Errors::new(format!("{} {word}", def.kind), 2e-5);
            let mut left_out = 0;
            for ((got, row), at) in
                run_at(def, choice, &types, &rows, &places, &library).iter().zip(&rows).zip(&places)
            {
                assert!(
                    got.iter().all(|x| x.is_finite()),
                    "{} {word}: {got:?} of {row:?}",
                    def.kind
                );
                let wanted = truth(&def.kind, &word, row, at, &tile).expect("one");
                assert_eq!(got.len(), wanted.len(), "{} {word}", def.kind);
                // Where the last digit of an input decides, both sides are right.
                let is_near = [3e-6, -3e-6].into_iter().any(|by| {
                    let moved: Vec<Vec<f64>> = row
                        .iter()
                        .map(|v| {
                            v.iter()
                                .map(|x| if x.fract() == 0.0 { *x } else { x * (1.0 + by) })
                                .collect()
                        })
                        .collect();
                    let other = truth(&def.kind, &word, &moved, at, &tile).expect("one");
                    wanted.iter().zip(&other).any(|(a, b)| (a - b).abs() > 0.1)
                });
                if is_near {
                    left_out += 1;
                    continue;
                }
                for (got, wanted) in got.iter().zip(&wanted) {
                    let scale = wanted.abs().max(1.0);
                    errors.note(got / scale, wanted / scale, || format!("{row:?}"));
                }
            }
            assert!(
                left_out < 30,
                "{} {word}: {left_out} samples are too near to an edge",
                def.kind
            );
            errors.finish();
        }
    }
}

/// Inputs by name; the others are 0.
type Set<'a> = Vec<(&'a str, Vec<f64>)>;

/// First output of a node at many places for each set of values, without a footprint.
fn over(kind: &str, choice: &[(&str, &str)], places: &[DVec2], sets: &[Set<'_>]) -> Vec<Vec<f64>> {
    let def = &Library::built_in().nodes[kind];
    let types: Vec<Type> = numeric(def).iter().map(|input| input.ty.clone()).collect();
    let row = |place: &DVec2, set: &Set<'_>| {
        let value = |input: &&chiaro::library::Input| {
            if input.name.as_str() == "place" {
                return place.to_array().map(f32_of).to_vec();
            }
            let set = set.iter().find(|(name, _)| *name == input.name.as_str());
            set.map_or_else(
                || vec![0.0; support::held::width(&input.ty)],
                |(_, numbers)| numbers.clone(),
            )
        };
        numeric(def).iter().map(value).collect::<Vec<_>>()
    };
    let rows: Vec<_> =
        sets.iter().flat_map(|set| places.iter().map(move |place| row(place, set))).collect();
    let at = vec![EvalSample::default(); rows.len()];
    let got: Vec<f64> = run_at(def, choice, &types, &rows, &at, &library())
        .iter()
        .map(|values| values[0])
        .collect();
    got.chunks(places.len()).map(<[f64]>::to_vec).collect()
}

fn set<'a>(values: &[(&'a str, &[f64])]) -> Set<'a> {
    values.iter().map(|(name, numbers)| (*name, numbers.to_vec())).collect()
}

/// A set with one more value, which comes first.
fn with<'a>(base: &Set<'a>, name: &'a str, value: f64) -> Set<'a> {
    [vec![(name, vec![value])], base.clone()].concat()
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Places that lie evenly and on no lattice (Roberts's R2 sequence).
fn evenly(count: usize, scale: f64) -> Vec<DVec2> {
    (1..=count)
        .map(|k| {
            scale
                * DVec2::new(
                    (k as f64 * 0.754_877_666_246_69).fract(),
                    (k as f64 * 0.569_840_290_998_05).fract(),
                )
        })
        .collect()
}

#[test]
fn halftones_have_the_tones_mean() {
    let places = evenly(2000, 1.0);
    let mut errors = Errors::new("halftone: mean over cells against the tone", 5e-3);
    let tones = [0.0, 0.03, 0.2, 0.25, 0.5, 0.7, 0.95, 1.0];
    for shape in ["dots", "lines", "crosses"] {
        let base = set(&[("lines", &[20.0])]);
        let got = over(
            "halftone",
            &[("shape", shape)],
            &places,
            &tones.map(|tone| with(&base, "value", tone)),
        );
        for (got, tone) in got.iter().zip(tones) {
            errors.note(mean(got), tone, || format!("{shape} {tone}"));
        }
    }
    errors.finish();
}

#[test]
fn dithers_have_the_tones_mean() {
    let places: Vec<DVec2> =
        (0..1024).map(|k| DVec2::new(f64::from(k % 32) + 0.5, f64::from(k / 32) + 0.5)).collect();
    let base = set(&[("levels", &[3.0]), ("size", &[1.0]), ("spread", &[1.0])]);
    let tones = [0.0, 0.1, 0.37, 0.5, 0.81, 1.0];
    for (pattern, bound) in
        [("blue", 2e-3), ("bayer_8", 8e-3), ("bayer_4", 0.032), ("bayer_2", 0.13), ("white", 0.05)]
    {
        let mut errors =
            Errors::new(format!("dither {pattern}: mean over a tile against the tone"), bound);
        let got = over(
            "dither",
            &[("pattern", pattern)],
            &places,
            &tones.map(|tone| with(&base, "value", tone)),
        );
        for (got, tone) in got.iter().zip(tones) {
            errors.note(mean(got), tone, || format!("{tone}"));
        }
        errors.finish();
    }
    // Without a spread bands are flat; with a small one only their edges are sprinkled.
    let base = set(&[("value", &[0.36]), ("levels", &[2.0]), ("size", &[1.0])]);
    let got = over(
        "dither",
        &[("pattern", "blue")],
        &places,
        &[0.0, 0.2, 0.9].map(|s| with(&base, "spread", s)),
    );
    assert_eq!([0, 1, 2].map(|k| got[k].iter().any(|x| *x > 0.5)), [false, false, true]);
}

#[test]
fn lighter_marks_are_among_darker_ones() {
    let strokes = set(&[
        ("stretch", &[1.7, 0.3, 0.9]),
        ("count", &[30.0]),
        ("width", &[0.7]),
        ("layers", &[2.0]),
        ("cross", &[1.0]),
        ("length", &[9.0]),
        ("taper", &[0.6]),
        ("wobble", &[0.8]),
        ("pressure", &[0.3]),
        ("variation", &[1.0]),
    ]);
    let dots = set(&[
        ("stretch", &[1.7, 0.3, 0.9]),
        ("count", &[30.0]),
        ("size", &[0.9]),
        ("scatter", &[0.8]),
    ]);
    let tones = [1.0, 0.9, 0.77, 0.6, 0.5, 0.41, 0.25, 0.1, 0.0];
    for (kind, base) in [("hatching", strokes), ("stippling", dots)] {
        let inked =
            over(kind, &[], &evenly(1200, 1.0), &tones.map(|tone| with(&base, "value", tone)));
        assert!(inked[0].iter().all(|ink| *ink == 0.0), "{kind}: paper is bare");
        for (pair, tone) in inked.windows(2).zip(&tones[1..]) {
            let lost =
                pair[0].iter().zip(&pair[1]).filter(|(lighter, darker)| lighter > darker).count();
            assert_eq!(lost, 0, "{kind} at {tone}: ink is lost where it gets darker");
            assert!(mean(&pair[1]) > mean(&pair[0]), "{kind} at {tone}: no ink is added");
        }
    }
}

/// Ink follows the tone at every distance.
#[test]
fn ink_is_as_much_at_every_distance() {
    let mut strokes = Errors::new("hatching: ink against darkness times width", 0.015);
    let mut dots = Errors::new("stippling: ink against darkness times a dot's area", 0.02);
    let mut cases = Vec::new();
    for zoom in [0.4, 0.71, 1.0, 1.3, 2.6] {
        cases.extend([0.15, 0.5, 0.8].map(|tone| (zoom, tone)));
    }
    let with_case = |base: &[(&'static str, &[f64])]| -> Vec<Set<'static>> {
        let one = |&(zoom, tone): &(f64, f64)| {
            let stretch = ("stretch", vec![zoom * zoom, 0.0, zoom * zoom]);
            [with(&set(base), "value", tone), vec![stretch]].concat()
        };
        cases.iter().map(one).collect()
    };
    // Three units of the picture hold many strokes.
    let places = evenly(2000, 3.0);
    let lines = with_case(&[("count", &[40.0]), ("width", &[0.8]), ("layers", &[1.0])]);
    for (got, (zoom, tone)) in over("hatching", &[], &places, &lines).iter().zip(&cases) {
        strokes.note(mean(got), 0.8 * (1.0 - tone), || format!("{zoom} {tone}"));
    }
    let points = with_case(&[("count", &[40.0]), ("size", &[0.5]), ("scatter", &[0.4])]);
    for (got, (zoom, tone)) in over("stippling", &[], &places, &points).iter().zip(&cases) {
        dots.note(mean(got), PI * 0.25 * 0.25 * (1.0 - tone), || format!("{zoom} {tone}"));
    }
    strokes.finish();
    dots.finish();
}

/// Octaves go over into one another without a jump: just before and just after, ink is the same
/// except at edges.
#[test]
fn octaves_go_over_without_a_jump() {
    let base = set(&[
        ("value", &[0.4]),
        ("count", &[30.0]),
        ("width", &[0.6]),
        ("layers", &[2.0]),
        ("cross", &[1.0]),
        ("length", &[12.0]),
        ("taper", &[0.5]),
        ("wobble", &[1.0]),
        ("variation", &[1.0]),
        ("size", &[0.7]),
        ("scatter", &[0.8]),
        ("tooth", &[1.0]),
        ("fiber", &[0.5]),
    ]);
    for kind in ["hatching", "stippling", "paper_grain"] {
        let sides = [-1e-4, 1e-4].map(|by| {
            let square = 4.0 * (1.0 + by);
            [base.clone(), vec![("stretch", vec![square, 0.0, square])]].concat()
        });
        let got = over(kind, &[], &evenly(1500, 1.0), &sides);
        let changed = got[0].iter().zip(&got[1]).filter(|(a, b)| (**a - **b).abs() > 0.02).count();
        assert!(changed < 8, "{kind}: {changed} of {} places change", got[0].len());
    }
}

/// Paper keeps 0 as 0 and full ink as full ink; on average it changes nothing.
#[test]
fn paper_keeps_both_ends() {
    let base = set(&[("count", &[40.0]), ("fiber", &[0.5]), ("tooth", &[0.5])]);
    let got = over(
        "paper_grain",
        &[],
        &evenly(1200, 1.0),
        &[0.0, 1.0, 0.5, 0.1, 0.9].map(|t| with(&base, "value", t)),
    );
    assert!(got[0].iter().all(|tone| *tone == 0.0) && got[1].iter().all(|tone| *tone == 1.0));
    let spread = |tones: &[f64]| {
        let middle = mean(tones);
        (tones.iter().map(|x| (x - middle).powi(2)).sum::<f64>() / tones.len() as f64).sqrt()
    };
    assert!(
        spread(&got[2]) > 1.5 * spread(&got[3]) && spread(&got[2]) > 1.5 * spread(&got[4]),
        "most at middle tones"
    );
    assert!((mean(&got[2]) - 0.5).abs() < 0.01);
}

// In pictures

const SIDE: u32 = 96;

/// Place and color of each pixel of a square of 2 by 2 units at `middle`, seen straight on.
fn picture(
    nodes: &Json,
    wires: &Json,
    middle: [f64; 3],
    perspective: bool,
) -> Vec<(DVec2, [f32; 4])> {
    let folder = tempfile::tempdir().expect("a folder");
    let write =
        |name: &str, text: String| std::fs::write(folder.path().join(name), text).expect("written");
    write(
        "square.obj",
        "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\n".to_owned(),
    );
    let mut all = vec![json!({"id": "output", "kind": "output"})];
    all.extend(nodes.as_array().expect("a list").iter().cloned());
    write(
        "look.json",
        json!({"chiaro": "look", "version": 1, "nodes": all, "wires": wires}).to_string(),
    );
    let projection = if perspective { "perspective" } else { "orthographic" };
    let scene = json!({
        "chiaro": "scene", "version": 1, "backdrop": [0, 0, 0, 0],
        "objects": [{"id": "square", "mesh": "square.obj", "looks": "look.json",
            "transform": {"fit": false, "translate": middle}}],
        "camera": {
            "projection": projection, "height": 2, "fov": 0.7, "eye": [0, 0, 4], "target": [0, 0, 0]
        }
    });
    write("scene.json", scene.to_string());
    let mut assets = Assets::default();
    let setup = open(&folder.path().join("scene.json"), None, &mut assets)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)))
        .value;
    let options = PlanOptions { size: [SIDE; 2], samples: 1, time: 0.0 };
    let plan = Planner::new(assets)
        .plan(&setup, Library::built_in(), &Live::Keyed, &options)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)))
        .value;
    let picture = block_on(renderer().picture(&plan)).unwrap_or_else(|error| panic!("{error}"));
    let all = (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y)));
    let seen =
        all.map(|(x, y)| (DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5), picture.pixel(x, y)));
    seen.filter(|(_, pixel)| pixel[3] > 0.5).collect()
}

#[test]
fn pixels_count_from_the_upper_left_corner() {
    let wires = json!([{"from": "at.uv", "to": "output.color"}]);
    let nodes = json!([{"id": "at", "kind": "screen_place"}]);
    let mut errors = Errors::new("screen_place: in a picture", 1e-3);
    let pixels = picture(&nodes, &wires, [0.0; 3], false);
    assert!(pixels.len() > 9000);
    for (at, [u, v, ..]) in pixels {
        errors.note(f64::from(u), at.x / f64::from(SIDE), || format!("{at}"));
        errors.note(f64::from(v), 1.0 - at.y / f64::from(SIDE), || format!("{at}"));
    }
    errors.finish();
}

/// An anchored place stays on its object: at the distance of the object's middle it is the object's
/// own position.
#[test]
fn anchored_places_go_along() {
    let nodes = json!([
        {"id": "at", "kind": "mark_place", "values": {"follow": "object"}},
        {"id": "own", "kind": "position", "values": {"space": "object"}},
        {"id": "off", "kind": "vector_distance"}
    ]);
    let wires = json!([
        {"from": "at.place", "to": "off.a"}, {"from": "own.position", "to": "off.b"},
        {"from": "off.distance", "to": "output.color"}
    ]);
    for (middle, perspective) in [
        ([0.0; 3], false),
        ([0.3, -0.5, 0.4], false),
        ([0.0; 3], true),
        ([0.25, 0.5, 0.9], true),
        ([-0.7, 0.2, -3.0], true),
    ] {
        let mut errors = Errors::new(format!("mark_place object at {middle:?}"), 1e-3);
        for (at, [off, ..]) in picture(&nodes, &wires, middle, perspective) {
            errors.note(f64::from(off), 0.0, || format!("{at}"));
        }
        errors.finish();
    }
}

/// Antialiased dots, lines and crosses are on average as light as their tone, down to cells of less
/// than two pixels.
#[test]
fn antialiased_halftones_have_the_tones_mean() {
    let mut errors = Errors::new("halftone: mean of pixels against the tone", 0.012);
    for shape in ["dots", "lines", "crosses"] {
        for (lines, tone) in
            [(31.0, 0.1), (31.0, 0.6), (17.0, 0.25), (17.0, 0.9), (9.0, 0.45), (60.0, 0.3)]
        {
            let nodes = json!([{"id": "dots", "kind": "halftone", "values":
                {"shape": shape, "value": tone, "lines": lines, "angle": 0.4}}]);
            let wires = json!([{"from": "dots.tone", "to": "output.color"}]);
            let pixels = picture(&nodes, &wires, [0.0; 3], false);
            let mean =
                pixels.iter().map(|(_, p)| f64::from(p[0])).sum::<f64>() / pixels.len() as f64;
            errors.note(mean, tone, || format!("{shape}, {lines} lines"));
        }
    }
    errors.finish();
}

/// Lightness and coverage of a stroke by a stiff brush.
fn bristles(laid: DVec2, seed: u32) -> [f64; 2] {
    let step = |x: f64, low: f64, high: f64| {
        let t = unit((x - low) / (high - low));
        t * t * (3.0 - 2.0 * t)
    };
    let (along, across) = (laid.x, 2.0 * laid.y - 1.0);
    let row = 11.0 * laid.y;
    let t = step(row - row.floor(), 0.0, 1.0);
    let of = |row: i64| unit3(lattice([row, 0, 0], seed));
    let chance = of(row.floor() as i64).lerp(of(row.floor() as i64 + 1), t);
    let own = unit3(lattice([0, 1, 0], seed));
    let start = 0.03 + 0.12 * chance.x + 0.09 * across.powi(2);
    let end = 0.97 - (0.1 + 0.25 * own.y) * chance.y - 0.12 * across.powi(2);
    let is_there = step(along, start, start + 0.05) * (1.0 - step(along, end - 0.1, end));
    let side = 1.0 - step(across.abs(), 0.78, 0.95);
    let dry = step(along + 0.55 * chance.z, 0.85, 1.25);
    let shade = 0.72 + 0.16 * own.z + 0.16 * (0.5 + 1.3 * (chance.z - 0.5)) - 0.05 * along;
    [unit(shade), is_there * side * (1.0 - 0.9 * dry)]
}

/// Strokes of bristles are those that a search through all cells finds, laid over one another in
/// one order.
#[test]
fn bristles_lie_in_their_cells() {
    let (aspect, size, scatter, turn, count, seed) = (3.0, 1.6, 0.6, 0.5, 12.0, 3_u32);
    let look = look(&json!({
        "nodes": [
            {"id": "tone", "kind": "number"},
            {"id": "uv", "kind": "uv"},
            {"id": "node", "kind": "brush_strokes", "values": {
                "mask": "bristles", "aspect": aspect, "size": size, "scatter": scatter,
                "turn": turn, "count": count,
                "seed": seed
            }},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "tone", "to": "node.value"}, {"from": "uv.uv", "to": "node.place"},
            {"from": "node.color", "to": "output.color"}
        ],
        "exposed": [{"name": "tone", "target": "tone.value"}]
    }));
    let tile = blue_tile();
    let mut random = Random::new(611);
    let mut samples = Vec::new();
    for k in 0..900 {
        let uv = DVec2::new(f32_of(random.between(-3.0, 3.0)), f32_of(random.between(-3.0, 3.0)));
        let tone = chiaro::document::Value::Number([0.0, 0.45, 0.8][k % 3]);
        samples.push(EvalSample {
            uv,
            values: [("tone".into(), tone)].into_iter().collect(),
            ..EvalSample::default()
        });
    }
    let inks = eval_with(&look, Library::built_in(), &options("node.ink"), &samples);
    let colors = eval_with(&look, Library::built_in(), &options("node.color"), &samples);
    let (mut errors, mut shades) =
        (Errors::new("bristles: ink", 2e-4), Errors::new("bristles: shade", 2e-4));
    let mut covered = [0.0; 3];
    for (k, ((ink, color), at)) in inks.iter().zip(&colors).zip(&samples).enumerate() {
        let p = at.uv * count / DVec2::new(aspect, 1.0);
        let wanted_ink = 1.0 - [0.0, 0.45, 0.8][k % 3];
        // Cells lie over one another by their places within three by three cells, rows first.
        let mut cells: Vec<[i64; 2]> = (0..9)
            .map(|i| [p.x.floor() as i64 + i % 3 - 1, p.y.floor() as i64 + i / 3 - 1])
            .collect();
        cells.sort_by_key(|[x, y]| (y.rem_euclid(3), x.rem_euclid(3)));
        let mut paint = [0.0; 2];
        for [x, y] in cells {
            let chance = unit3(lattice([x, y, 0], seed));
            let middle = DVec2::new(x as f64, y as f64)
                + 0.5
                + scatter * (DVec2::new(chance.x, chance.y) - 0.5);
            let offset = p - middle;
            let far = offset.abs().max_element() / (1.0 - 0.5 * scatter);
            let way = if unit3(lattice([x, y, 0], seed + 1)).x < 0.5 { 1.0 } else { -1.0 };
            let turned =
                DVec2::from_angle(turn * (0.5 - chance.z)).rotate(offset * DVec2::new(aspect, 1.0));
            let laid = 0.5 + turned * DVec2::new(way, -1.0) / (DVec2::new(aspect, 1.0) * size);
            let inside = unit(64.0 * laid.min(1.0 - laid).min_element());
            let drawn = unit(
                (wanted_ink - blue([x + i64::from(seed & 31), y], &tile) * 31.0 / 32.0) * 32.0,
            );
            let fade = unit((far - 0.85) / 0.15);
            let share = drawn * inside * (1.0 - fade * fade * (3.0 - 2.0 * fade));
            if share > 0.0 {
                let [shade, covers] = bristles(laid, lattice([x, y, 0], seed + 2)[0]);
                let cover = share * covers;
                paint =
                    [shade * cover + paint[0] * (1.0 - cover), cover + paint[1] * (1.0 - cover)];
            }
        }
        errors.note(ink[0], paint[1], || format!("{}", at.uv));
        if paint[1] > 0.05 {
            shades.note(color[0], paint[0] / paint[1], || format!("{}", at.uv));
        }
        covered[k % 3] += ink[0] / 300.0;
    }
    errors.finish();
    shades.finish();
    assert!(
        covered[0] > 0.8 && covered[0] > covered[1] && covered[1] > covered[2] && covered[2] > 0.05,
        "{covered:?}"
    );
}

/// Strokes of one color lie where a search through all cells finds one, and nowhere else.
#[test]
fn brush_strokes_lie_in_their_cells() {
    let folder = tempfile::tempdir().expect("a folder");
    image::RgbaImage::from_pixel(8, 8, image::Rgba([255, 0, 128, 255]))
        .save(folder.path().join("stroke.png"))
        .expect("written");
    let (aspect, size, scatter, turn, count, seed) = (3.0, 1.2, 0.5, 0.25, 12.0, 5_u32);
    let mut look = look(&json!({
        "nodes": [
            {"id": "tone", "kind": "number"},
            {"id": "uv", "kind": "uv"},
            {"id": "node", "kind": "brush_strokes", "values": {
                "image": "stroke.png", "encoding": "data", "filter": "nearest", "aspect": aspect,
                "size": size,
                "scatter": scatter, "turn": turn, "count": count, "seed": seed
            }},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "tone", "to": "node.value"}, {"from": "uv.uv", "to": "node.place"},
            {"from": "node.color", "to": "output.color"}
        ],
        "exposed": [{"name": "tone", "target": "tone.value"}]
    }));
    look.folder = folder.path().to_path_buf();
    let tile = blue_tile();
    let mut random = Random::new(610);
    let mut samples = Vec::new();
    for k in 0..900 {
        let uv = DVec2::new(f32_of(random.between(-3.0, 3.0)), f32_of(random.between(-3.0, 3.0)));
        let tone = chiaro::document::Value::Number([0.0, 0.45, 0.8][k % 3]);
        let values = [("tone".into(), tone)].into_iter().collect();
        samples.push(EvalSample { uv, values, ..EvalSample::default() });
    }
    let got = eval_with(&look, Library::built_in(), &options("node.ink"), &samples);
    let colors = eval_with(&look, Library::built_in(), &options("node.color"), &samples);
    let mut errors = Errors::new("brush_strokes: ink", 1e-4);
    let mut covered = [0.0; 3];
    for (k, ((got, color), at)) in got.iter().zip(&colors).zip(&samples).enumerate() {
        let p = at.uv * count / DVec2::new(aspect, 1.0);
        let ink = 1.0 - [0.0, 0.45, 0.8][k % 3];
        let mut free = 1.0;
        for index in 0..25 {
            let cell = p.floor() + DVec2::new(f64::from(index % 5 - 2), f64::from(index / 5 - 2));
            let [x, y] = cell.to_array().map(|c| c as i64);
            let chance = unit3(lattice([x, y, 0], seed));
            let offset = p - (cell + 0.5 + scatter * (DVec2::new(chance.x, chance.y) - 0.5));
            let far = offset.abs().max_element() / (1.0 - 0.5 * scatter);
            let laid =
                DVec2::from_angle(turn * (0.5 - chance.z)).rotate(offset * DVec2::new(aspect, 1.0));
            let part = (laid / (DVec2::new(aspect, 1.0) * size)).abs().max_element();
            let drawn =
                unit((ink - blue([x + i64::from(seed & 31), y], &tile) * 31.0 / 32.0) * 32.0);
            let fade = unit((far - 0.85) / 0.15);
            let share = drawn * (1.0 - fade * fade * (3.0 - 2.0 * fade));
            free *= 1.0 - share * unit(64.0 * (0.5 - part));
        }
        errors.note(got[0], 1.0 - free, || format!("{}", at.uv));
        covered[k % 3] += got[0] / 300.0;
        if got[0] > 0.01 {
            assert!((color[0] - 1.0).abs() < 1e-3 && color[1].abs() < 1e-3, "{color:?}");
        }
    }
    errors.finish();
    assert!(
        covered[0] > 0.9 && covered[0] > covered[1] && covered[1] > covered[2] && covered[2] > 0.1,
        "{covered:?}"
    );
}
