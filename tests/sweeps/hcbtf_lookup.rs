//! The HCBTF node on the GPU and in f64 against a lookup written by hand, for every tier and every
//! choice of lookup: at random places, at every sample's own direction, and where directions,
//! frames and texture coordinates are hard (hard-cases.md 24 and 25).
#![cfg(feature = "gpu")]
#![allow(clippy::print_stdout, reason = "figures are worth reading when a bound is missed")]

mod blocks;
mod pictures;
mod places;

use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::support::eval::{eval_with, look, options, truth};
use crate::support::random::Random;
use crate::support::report::Errors;
use chiaro::document::{Address, Direction, Directions, Grid, Hcbtf, Tile};
use chiaro::frame::{EvalSample, LightOverride, SetupLook};
use chiaro::library::Library;
use glam::{DVec2, DVec3};
use serde_json::json;

const BELOW: [f64; 4] = [0.25, 0.5, 0.75, 1.0];
/// Greatest difference of the balanced tier, as its node states; below a step of a screen.
const BALANCED: f64 = 3.7e-3;
/// Choices of the lookup: two of the lookup node, and the node that shows the nearest sample.
const LOOKUPS: [&str; 3] = ["smooth", "texels", "nearest"];

fn grids() -> [(&'static str, Grid); 4] {
    let directions = |theta, phi| Directions { theta, phi };
    [
        ("thesis", Grid { size: [8, 8], ..Grid::THESIS }),
        ("odd", Grid { size: [5, 3], light: directions(3, 7), view: directions(2, 5) }),
        ("one", Grid { size: [1, 1], light: directions(1, 1), view: directions(1, 1) }),
        ("wide", Grid { size: [300, 2], light: directions(2, 1), view: directions(4, 3) }),
    ]
}

/// An HCBTF with every sample painted, each texel in a random color.
fn painted(grid: Grid, is_opaque: bool) -> Hcbtf {
    let mut random = Random::new(7 + grid.texels() as u64);
    let mut tile = || {
        let texel = |random: &mut Random| {
            let [r, g, b, a, ..] = random.bits().to_le_bytes();
            [r, g, b, if is_opaque { 255 } else { a }]
        };
        let bytes = (0..grid.texels()).flat_map(|_| texel(&mut random)).collect();
        Arc::new(Tile::new(grid.size, bytes).unwrap())
    };
    let painted: BTreeMap<Address, Arc<Tile>> =
        grid.addresses().map(|address| (address, tile())).collect();
    Hcbtf { painted, ..Hcbtf::new(grid) }
}

/// Writes an HCBTF into a folder of the build, and gives its path.
fn file(name: &str, hcbtf: &Hcbtf) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("hcbtf_lookup");
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join(format!("{name}.hcbtf"));
    std::fs::write(&path, chiaro::hcbtf::write(hcbtf).unwrap()).unwrap();
    path
}

fn wearing(path: &Path, lookup: &str, tier: &str) -> SetupLook {
    stored_as("quick", path, lookup, tier)
}

fn stored_as(storage: &str, path: &Path, lookup: &str, tier: &str) -> SetupLook {
    let mut values =
        json!({"sheet": path.display().to_string(), "unlit": BELOW, "storage": storage});
    let kind = if lookup == "nearest" { "hcbtf_nearest" } else { "hcbtf_lookup" };
    if lookup != "nearest" {
        values["lookup"] = json!(lookup);
    }
    look(&json!({
        "lights": {"key": {"direction": [0, 0, 1]}},
        "nodes": [
            {"id": "light", "kind": "light", "values": {"light": "key"}},
            {"id": "paint", "kind": kind, "tier": tier, "values": values},
            {"id": "output", "kind": "output"}
        ],
        "wires": [{"from": "light", "to": "paint.light"}, {"from": "paint", "to": "output.color"}]
    }))
}

fn sample(
    normal: DVec3,
    tangent: DVec3,
    is_mirrored: bool,
    light: DVec3,
    view: DVec3,
    uv: DVec2,
) -> EvalSample {
    let light = LightOverride { direction: Some(light), ..LightOverride::default() };
    EvalSample {
        normal,
        tangent: Some(tangent),
        is_mirrored,
        view,
        uv,
        lights: [("key".into(), light)].into_iter().collect(),
        ..EvalSample::default()
    }
}

/// A surface sample in a random frame, with light and view at given angles.
fn at_angles(random: &mut Random, light: [f64; 2], view: [f64; 2], uv: DVec2) -> EvalSample {
    let turn = random.rotation();
    let is_mirrored = random.chance(0.5);
    let side = if is_mirrored { -1.0 } else { 1.0 };
    let vector = |[theta, phi]: [f64; 2]| {
        turn * DVec3::new(theta.sin() * phi.sin(), side * theta.sin() * phi.cos(), theta.cos())
    };
    // The tangent is sheared, and no vector has length 1.
    let lean = random.between(-2.0, 2.0);
    let tangent = turn * DVec3::new(1.0, 0.0, lean) * random.between(0.1, 10.0);
    let normal = turn * DVec3::Z * random.between(0.2, 5.0);
    sample(
        normal,
        tangent,
        is_mirrored,
        vector(light) * random.between(0.3, 3.0),
        vector(view) * 2.0,
        uv,
    )
}

// The lookup once more, by hand.

/// The two angles of a direction in the frame made by Gram and Schmidt's method.
fn angles(sample: &EvalSample, direction: DVec3) -> [f64; 2] {
    let n = sample.normal.normalize();
    let t = sample.tangent.unwrap().normalize();
    let t = (t - n * n.dot(t)).normalize();
    let b = n.cross(t) * if sample.is_mirrored { -1.0 } else { 1.0 };
    let d = direction.normalize();
    let (x, y, z) = (d.dot(t), d.dot(b), d.dot(n));
    [x.hypot(y).atan2(z), x.atan2(y).rem_euclid(TAU)]
}

/// The four HCBTF samples around a direction, with their weights.
fn around(directions: Directions, [theta, phi]: [f64; 2]) -> Vec<(Direction, f64)> {
    let ring = theta.min(FRAC_PI_2) / FRAC_PI_2 * f64::from(directions.theta - 1);
    let step = phi / TAU * f64::from(directions.phi);
    let mut all = Vec::new();
    for (theta, wt) in [(ring.floor(), 1.0 - ring.fract()), (ring.floor() + 1.0, ring.fract())] {
        for (phi, wp) in [(step.floor(), 1.0 - step.fract()), (step.floor() + 1.0, step.fract())] {
            let theta = (theta as u32).min(directions.theta - 1);
            all.push((Direction { theta, phi: phi as u32 % directions.phi }, wt * wp));
        }
    }
    all
}

fn nearest(directions: Directions, [theta, phi]: [f64; 2]) -> Direction {
    let ring = (theta.min(FRAC_PI_2) / FRAC_PI_2 * f64::from(directions.theta - 1)).round();
    let step = (phi / TAU * f64::from(directions.phi)).round();
    Direction { theta: ring as u32, phi: step as u32 % directions.phi }
}

/// Texels of the tile with their weights.
fn texels(grid: &Grid, uv: DVec2, is_smooth: bool) -> Vec<([i64; 2], f64)> {
    let place = DVec2::new(uv.x.rem_euclid(1.0), (-uv.y).rem_euclid(1.0))
        * DVec2::new(f64::from(grid.size[0]), f64::from(grid.size[1]));
    if !is_smooth {
        return vec![([place.x.floor() as i64, place.y.floor() as i64], 1.0)];
    }
    let place = place - 0.5;
    let (low, part) = (place.floor(), place - place.floor());
    let mut all = Vec::new();
    for (dx, wx) in [(0, 1.0 - part.x), (1, part.x)] {
        for (dy, wy) in [(0, 1.0 - part.y), (1, part.y)] {
            all.push(([low.x as i64 + dx, low.y as i64 + dy], wx * wy));
        }
    }
    all
}

fn by_hand(hcbtf: &Hcbtf, sample: &EvalSample, lookup: &str) -> [f64; 4] {
    let light = angles(sample, sample.lights["key"].direction.unwrap());
    let view = angles(sample, sample.view);
    if light[0] > FRAC_PI_2 {
        return BELOW;
    }
    let pick = |directions, angles| match lookup {
        "nearest" => vec![(nearest(directions, angles), 1.0)],
        _ => around(directions, angles),
    };
    let mut sum = [0.0; 4];
    for (light, wl) in pick(hcbtf.grid.light, light) {
        for (view, wv) in pick(hcbtf.grid.view, view) {
            let tile = hcbtf.painted(Address { light, view }).unwrap();
            for ([x, y], wt) in texels(&hcbtf.grid, sample.uv, lookup == "smooth") {
                let [r, g, b, a] = tile.texel(x, y).map(|byte| f64::from(byte) / 255.0);
                let weight = wl * wv * wt;
                for (sum, channel) in sum.iter_mut().zip([r * a, g * a, b * a, a]) {
                    *sum += weight * channel;
                }
            }
        }
    }
    let [r, g, b, a] = sum;
    // The nearest sample is shown unmixed, with its transparent texels.
    if a > 0.0 { [r / a, g / a, b / a, a] } else { [0.0, 0.0, 0.0, 0.0] }
}

/// A texture coordinate clearly inside of a texel, in any repeat of the tile.
fn inside(random: &mut Random, grid: &Grid) -> DVec2 {
    let axis = |random: &mut Random, side: u32| {
        let texel = random.index(side as usize) as f64 + random.between(0.02, 0.98);
        texel / f64::from(side) + random.index(9) as f64 - 4.0
    };
    DVec2::new(axis(random, grid.size[0]), axis(random, grid.size[1]))
}

fn angle_pair(random: &mut Random) -> [f64; 2] {
    [random.between(0.0, FRAC_PI_2 - 0.01), random.between(0.0, TAU)]
}

/// Angles that are clearly nearer to one HCBTF sample than to any other.
fn clear(random: &mut Random, directions: Directions) -> [f64; 2] {
    loop {
        let pair = angle_pair(random);
        let ring = pair[0] / FRAC_PI_2 * f64::from(directions.theta - 1);
        let step = pair[1] / TAU * f64::from(directions.phi);
        if [ring, step].iter().all(|place| (place.fract() - 0.5).abs() > 1e-3) {
            return pair;
        }
    }
}

fn at_random(hcbtf: &Hcbtf, count: usize) -> Vec<EvalSample> {
    let mut random = Random::new(40);
    let grid = &hcbtf.grid;
    let one = |_| {
        let (light, view) = (clear(&mut random, grid.light), clear(&mut random, grid.view));
        let uv = inside(&mut random, grid);
        at_angles(&mut random, light, view, uv)
    };
    (0..count).map(one).collect()
}

/// Compares a color with the one found by hand, both premultiplied: where nearly nothing is
/// painted, the color does not matter.
fn note(errors: &mut Errors, got: [f64; 4], wanted: [f64; 4], place: impl Fn() -> String) {
    for channel in 0..4 {
        let over =
            |color: [f64; 4]| if channel == 3 { color[3] } else { color[channel] * color[3] };
        errors.note(over(got), over(wanted), || format!("{} channel {channel}", place()));
    }
}

/// The look's value at each surface sample on the GPU.
fn seen(path: &Path, lookup: &str, tier: &str, samples: &[EvalSample]) -> Vec<[f64; 4]> {
    eval_with(&wearing(path, lookup, tier), Library::built_in(), &options(""), samples)
}

#[test]
fn the_node_in_f64_is_the_lookup_by_hand() {
    for (name, grid) in grids() {
        let hcbtf = painted(grid, false);
        let path = file(&format!("{name}_truth"), &hcbtf);
        let samples = at_random(&hcbtf, 400);
        for lookup in LOOKUPS {
            let mut errors = Errors::new(format!("{name}, {lookup}, f64"), 1e-7);
            for (got, sample) in
                truth(&wearing(&path, lookup, "exact"), "", &samples).into_iter().zip(&samples)
            {
                note(&mut errors, got, by_hand(&hcbtf, sample, lookup), || format!("{sample:?}"));
            }
            errors.finish();
        }
    }
}

#[test]
fn every_tier_on_the_gpu_is_as_near_as_it_says() {
    for (name, grid) in grids() {
        for is_opaque in [true, false] {
            let hcbtf = painted(grid, is_opaque);
            let path = file(&format!("{name}_{is_opaque}"), &hcbtf);
            let samples = at_random(&hcbtf, 4000);
            for lookup in LOOKUPS {
                // A texture coordinate of 32 bits knows its place in a texel the less exactly the
                // more texels there are.
                let bound = 1e-6 * f64::from(grid.size[0] + grid.size[1]);
                let mut exact =
                    Errors::new(format!("{name}, {lookup}, exact, opaque {is_opaque}"), bound);
                let mut balanced = Errors::new(
                    format!("{name}, {lookup}, balanced, opaque {is_opaque}"),
                    BALANCED + bound,
                );
                let of = |tier| seen(&path, lookup, tier, &samples);
                for (index, (got, near)) in of("exact").into_iter().zip(of("balanced")).enumerate()
                {
                    let wanted = by_hand(&hcbtf, &samples[index], lookup);
                    note(&mut exact, got, wanted, || format!("{:?}", samples[index]));
                    note(&mut balanced, near, wanted, || format!("{:?}", samples[index]));
                }
                exact.finish();
                balanced.finish();
            }
        }
    }
}

/// Every storage shows the painted colors, also where views share layers and where colors are
/// stored in palettes.
#[test]
fn every_storage_looks_the_same() {
    let mut random = Random::new(77);
    let directions = Directions { theta: 3, phi: 5 };
    let grid = Grid { size: [20, 12], light: directions, view: Directions { theta: 4, phi: 6 } };
    // Tiles of few colors, of many colors, and tiles shared by many lights and views.
    let tiles: Vec<Arc<Tile>> = (0..7)
        .map(|kind| {
            let mut texel = || match kind {
                0..4 => [255, 40 * random.index(6) as u8, 30 * kind, 255],
                _ => {
                    [random.index(256) as u8, random.index(256) as u8, random.index(256) as u8, 255]
                }
            };
            Arc::new(
                Tile::new(grid.size, (0..grid.texels()).flat_map(|_| texel()).collect()).unwrap(),
            )
        })
        .collect();
    let alike = |address: Address| {
        tiles
            [((address.view.theta + 2 * (address.view.phi / 3) + address.light.theta) % 7) as usize]
            .clone()
    };
    let painted = grid.addresses().map(|address| (address, alike(address))).collect();
    let hcbtf = Hcbtf { painted, ..Hcbtf::new(grid) };
    let path = file("stored", &hcbtf);
    let samples = at_random(&hcbtf, 1000);
    let near = |one: &[[f64; 4]], other: &[[f64; 4]], bound: f64, what: &str| {
        let mut errors = Errors::new(what.to_owned(), bound);
        for (index, (got, wanted)) in one.iter().zip(other).enumerate() {
            note(&mut errors, *got, *wanted, || format!("{:?}", samples[index]));
        }
        errors.finish();
    };
    for lookup in LOOKUPS {
        let wanted: Vec<[f64; 4]> =
            samples.iter().map(|sample| by_hand(&hcbtf, sample, lookup)).collect();
        for storage in ["quick", "compact"] {
            let on_gpu = |tier: &str| {
                let look = stored_as(storage, &path, lookup, tier);
                eval_with(&look, Library::built_in(), &options(""), &samples)
            };
            near(&on_gpu("exact"), &wanted, 4e-5, &format!("{storage}, {lookup}, exact"));
            near(&on_gpu("balanced"), &wanted, BALANCED, &format!("{storage}, {lookup}, balanced"));
            let few = &samples[..60];
            let in_f64 = truth(&stored_as(storage, &path, lookup, "exact"), "", few);
            near(&in_f64, &wanted[..60], 1e-7, &format!("{storage}, {lookup}, f64"));
            if lookup != "nearest" {
                let quick = seen(&path, lookup, "fast", &samples);
                near(&on_gpu("fast"), &quick, 5e-3, &format!("{storage}, {lookup}, fast"));
            }
        }
    }
}

/// Samples in the second layer of a compact texture are found.
#[test]
fn what_lies_in_a_second_layer_is_found() {
    let one = Directions { theta: 1, phi: 1 };
    let grid = Grid { size: [1024, 840], light: Directions { theta: 5, phi: 1 }, view: one };
    let tile = |address: Address| {
        let texel = |at: u32| {
            [at as u8, (at >> 8) as u8, (at >> 16) as u8 + 40 * address.light.theta as u8, 255]
        };
        Arc::new(Tile::new(grid.size, (0..grid.texels() as u32).flat_map(texel).collect()).unwrap())
    };
    let hcbtf = Hcbtf {
        painted: grid.addresses().map(|address| (address, tile(address))).collect(),
        ..Hcbtf::new(grid)
    };
    let path = file("layers", &hcbtf);
    let samples = at_random(&hcbtf, 200);
    let got = eval_with(
        &stored_as("compact", &path, "nearest", "exact"),
        Library::built_in(),
        &options(""),
        &samples,
    );
    for (got, sample) in got.iter().zip(&samples) {
        // f32 holds a texture coordinate of a few repeats to a thousandth of these texels.
        assert!(
            got.iter().zip(by_hand(&hcbtf, sample, "nearest")).all(|(a, b)| (a - b).abs() < 1e-6),
            "{sample:?}"
        );
    }
}

#[test]
fn at_its_own_directions_a_texel_is_what_was_painted() {
    for (name, grid) in grids() {
        let hcbtf = painted(grid, true);
        let path = file(&format!("{name}_painted"), &hcbtf);
        let mut random = Random::new(11);
        let mut places = Vec::new();
        for address in grid.addresses() {
            let [x, y] = grid.size.map(|side| random.index(side as usize) as u32);
            let uv = DVec2::new(
                (f64::from(x) + 0.5) / f64::from(grid.size[0]),
                -(f64::from(y) + 0.5) / f64::from(grid.size[1]),
            );
            // The horizon itself belongs to the light above it, but rounding may move the light
            // below.
            let mut light = grid.light.angles(address.light);
            light[0] = light[0].min(FRAC_PI_2 - 1e-6);
            let sample = at_angles(&mut random, light, grid.view.angles(address.view), uv);
            places.push((address, [x, y], sample));
        }
        let samples: Vec<EvalSample> = places.iter().map(|(_, _, sample)| sample.clone()).collect();
        for lookup in LOOKUPS {
            let values = seen(&path, lookup, "exact", &samples);
            for ((address, [x, y], _), value) in places.iter().zip(values) {
                let wanted = hcbtf.painted(*address).unwrap().texel(i64::from(*x), i64::from(*y));
                let got = value.map(|channel| (channel * 255.0).round() as u8);
                assert_eq!(got, wanted, "{name}, {lookup}, {address}, texel {x}, {y}");
            }
        }
    }
}

#[test]
fn the_nodes_beside_it_do_what_they_say() {
    let grid = Grid { size: [2, 2], ..Grid::THESIS };
    let hcbtf = painted(grid, true);
    let path = file("beside", &hcbtf);
    let samples = at_random(&hcbtf, 600);
    let of = |kind: &str, values: &serde_json::Value, output: &str| {
        let look = look(&json!({
            "lights": {
                "key": {"direction": [0, 0, 1]}, "fill": {"direction": [0, 1, 0], "intensity": 0.6}
            },
            "nodes": [
                {"id": "light", "kind": "light", "values": {"light": "key"}},
                {"id": "fill", "kind": "light", "values": {"light": "fill"}},
                {"id": "node", "kind": kind, "values": values},
                {"id": "parts", "kind": "light_parts"},
                {"id": "output", "kind": "output"}
            ],
            "wires": match kind {
                "hcbtf_directions" => json!([
                    {"from": "light", "to": "node.light"}, {"from": "node", "to": "output.color"}
                ]),
                "dominant_light" => json!([
                    {"from": "light", "to": "node.a"}, {"from": "fill", "to": "node.b"},
                    {"from": "node", "to": "parts.light"}
                ]),
                _ => json!([
                    {"from": "light", "to": "node.light"}, {"from": "node", "to": "parts.light"}
                ]),
            }
        }));
        eval_with(&look, Library::built_in(), &options(output), &samples)
    };
    let sheet = path.display().to_string();
    let mut errors = Errors::new("HCBTF directions", 1e-4);
    for (show, directions) in [("light", grid.light), ("view", grid.view)] {
        let got = of("hcbtf_directions", &json!({"sheet": sheet, "show": show}), "node.color");
        for (got, sample) in got.iter().zip(&samples) {
            let toward =
                if show == "light" { sample.lights["key"].direction.unwrap() } else { sample.view };
            let near = nearest(directions, angles(sample, toward));
            let hue = f64::from(near.phi) / f64::from(directions.phi) * 6.0;
            let part = f64::from(near.theta) / f64::from(directions.theta - 1);
            for (channel, offset) in [0.0, 4.0, 2.0].into_iter().enumerate() {
                let pure = (((hue + offset) % 6.0 - 3.0).abs() - 1.0).clamp(0.0, 1.0);
                errors
                    .note(got[channel], 1.0 + (pure - 1.0) * part, || format!("{show} {sample:?}"));
            }
        }
    }
    let got = of("hcbtf_directions", &json!({"sheet": sheet, "show": "weights"}), "node.color");
    for (got, sample) in got.iter().zip(&samples) {
        let weights: Vec<f64> =
            around(grid.view, angles(sample, sample.view)).into_iter().map(|(_, w)| w).collect();
        // The lookup by hand lists the two steps of a ring first; the node, the two rings of a
        // step.
        let [a, b, c, d] = [weights[0], weights[2], weights[1], weights[3]];
        for (got, wanted) in got.iter().zip([a + d, b + d, c + d]) {
            errors.note(*got, wanted, || format!("weights {sample:?}"));
        }
    }
    errors.finish();
    let mut errors = Errors::new("dominant light", 1e-6);
    for (got, sample) in of("dominant_light", &json!({}), "parts.direction").iter().zip(&samples) {
        let n = sample.normal.normalize();
        let key = sample.lights["key"].direction.unwrap().normalize();
        let wanted =
            if 0.6 * DVec3::Y.dot(n).max(0.0) > key.dot(n).max(0.0) { DVec3::Y } else { key };
        for (got, wanted) in got.iter().zip(wanted.to_array()) {
            errors.note(*got, wanted, || format!("{sample:?}"));
        }
    }
    errors.finish();
    let mut errors = Errors::new("light by tone", 1e-4);
    for (got, sample) in
        of("light_by_tone", &json!({"tone": 0.3}), "parts.direction").iter().zip(&samples)
    {
        let n = sample.normal.normalize();
        let key = sample.lights["key"].direction.unwrap().normalize();
        let wanted = 0.3 * n + (1.0_f64 - 0.09).sqrt() * (key - n * key.dot(n)).normalize();
        for (got, wanted) in got.iter().zip(wanted.to_array()) {
            errors.note(*got, wanted, || format!("{sample:?}"));
        }
    }
    errors.finish();
}

/// hard-cases.md 24: the pole has one color, and no color jumps where phi begins anew.
#[test]
fn poles_and_seams_are_whole() {
    let hcbtf = painted(Grid { size: [4, 4], ..Grid::THESIS }, true);
    let path = file("seams", &hcbtf);
    let uv = DVec2::new(0.99, 0.01);
    let still = |light: [f64; 2], view: [f64; 2]| {
        let vector = |[theta, phi]: [f64; 2]| {
            DVec3::new(theta.sin() * phi.sin(), theta.sin() * phi.cos(), theta.cos())
        };
        sample(DVec3::Z, DVec3::X, false, vector(light), vector(view), uv)
    };
    let pole: Vec<EvalSample> = (0..64)
        .map(|i| still([0.0, f64::from(i)], [1e-9 * f64::from(i % 3), 2.0 + f64::from(i)]))
        .collect();
    let seam: Vec<EvalSample> = [-1e-7, -0.0, 0.0, 1e-7, TAU - 1e-7, TAU, TAU + 1e-7]
        .into_iter()
        .flat_map(|phi| {
            [
                still([0.7, phi], [0.4, 1.0]),
                still([0.7, 1.0], [0.4, phi]),
                still([0.7, phi], [0.4, phi]),
            ]
        })
        .collect();
    for lookup in LOOKUPS {
        for one in ["exact", "balanced", "fast"] {
            let poles = seen(&path, lookup, one, &pole);
            for value in &poles {
                assert_eq!(
                    value.map(|c| (c * 1000.0).round()),
                    poles[0].map(|c| (c * 1000.0).round()),
                    "{lookup} {one}"
                );
            }
            let seams = seen(&path, lookup, one, &seam);
            for (index, value) in seams.iter().enumerate() {
                for (a, b) in value.iter().zip(&seams[index % 3]) {
                    assert!(
                        (a - b).abs() < 4e-3,
                        "{lookup} {one}: {value:?} beside {:?}",
                        seams[index % 3]
                    );
                }
            }
        }
    }
}

/// hard-cases.md 25: lookups have a finite color with grazing and back-facing views, lights on and
/// below the horizon, odd lengths, and far coordinates.
#[test]
fn hard_places_have_a_color() {
    let hcbtf = painted(Grid { size: [4, 4], ..Grid::THESIS }, true);
    let path = file("hard", &hcbtf);
    let mut samples = Vec::new();
    let up = DVec3::new(0.3, 0.2, 1.0);
    for view in [
        DVec3::new(1.0, 0.0, 0.0),
        DVec3::new(1.0, 0.0, -1e-6),
        DVec3::new(0.5, 0.5, -0.7),
        DVec3::NEG_Z,
        DVec3::new(1e-20, 0.0, 1e-20),
    ] {
        for uv in [-1e-9, 1000.3, 0.0, 1.0, -0.25, 1e9, 1e30] {
            samples.push(sample(DVec3::Z, DVec3::X, false, up, view, DVec2::splat(uv)));
        }
    }
    let lit = samples.len();
    for light in [DVec3::new(1.0, 0.0, -1e-6), DVec3::NEG_Z, DVec3::new(0.0, -1.0, -0.5)] {
        samples.push(sample(DVec3::Z, DVec3::X, false, light, up, DVec2::splat(0.4)));
    }
    for light in [DVec3::X, DVec3::new(1.0, 0.0, -0.0), DVec3::new(1.0, 0.0, 1e-6)] {
        samples.push(sample(DVec3::Z, DVec3::X, false, light, up, DVec2::splat(0.4)));
    }
    // A tangent along the normal gives no frame.
    samples.push(sample(DVec3::Z, DVec3::Z, true, up, up, DVec2::splat(0.4)));
    for lookup in LOOKUPS {
        for (storage, one) in
            [("quick", "exact"), ("quick", "balanced"), ("quick", "fast"), ("compact", "balanced")]
        {
            let look = stored_as(storage, &path, lookup, one);
            let values = eval_with(&look, Library::built_in(), &options(""), &samples);
            for (index, value) in values.iter().enumerate() {
                let is_below = (lit..lit + 3).contains(&index);
                assert_eq!(*value == BELOW, is_below, "{lookup} {one} {index}: {value:?}");
                assert!(
                    value.iter().all(|c| (0.0..=1.0).contains(c)),
                    "{lookup} {one} {index}: {value:?}"
                );
            }
            // A view below the horizon counts as on the horizon.
            assert_eq!(
                values[0].map(|c| (c * 500.0).round()),
                values[7].map(|c| (c * 500.0).round()),
                "{lookup}"
            );
        }
    }
}
