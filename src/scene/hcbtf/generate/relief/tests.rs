//! Reliefs compared with properties that are known without drawing them.

use std::f32::consts::FRAC_PI_2;
use std::sync::Arc;

use super::field::HeightField;
use super::lit::FieldLight;
use super::pattern::{CellMaterial, PatternSampler};
use super::seen::{FARTHEST_VIEW, VisibleSurface};
use super::transport::Transport;
use super::*;
use crate::document::relief::{Channel, Finish, Illumination, Pattern};
use crate::document::{Rule, Tile, read_rules};
use crate::hcbtf::NotFilled;
use crate::hcbtf::fill::fill;

const WHITE: [f32; 3] = [1.0; 3];

/// A field of given heights and one color.
fn field(size: [usize; 2], color: [f32; 3], height: impl Fn(usize, usize) -> f32) -> HeightField {
    let heights = (0..size[0] * size[1]).map(|at| height(at % size[0], at / size[0])).collect();
    HeightField::of(size, 1, heights, vec![CellMaterial::of(color); size[0] * size[1]])
}

/// A pseudorandom number from 0 to 1.
fn chance(x: usize, y: usize) -> f32 {
    noise::chance(5, x as i64, y as i64)
}

/// Light of the sun alone, white, with hard shadows and without bounces.
fn sun() -> Illumination {
    Illumination {
        sun: [255; 3],
        low_sun: [255; 3],
        sun_amount: 1.0,
        sky_amount: 0.0,
        softness: 0.0,
        bounces: 0,
        ..Illumination::default()
    }
}

/// Light of a white sky alone.
fn sky(bounces: u32) -> Illumination {
    let white = [255; 3];
    Illumination {
        sun_amount: 0.0,
        sky: white,
        low_sky: white,
        sky_amount: 1.0,
        bounces,
        ..Illumination::default()
    }
}

fn lit(light: Illumination, field: &HeightField, toward: [f32; 3]) -> FieldLight {
    let relief = Relief { light, ..Relief::default() };
    let transport = Transport::new(field, &Progress::new()).unwrap();
    FieldLight::new(&relief, field, &transport, toward, &Progress::new()).unwrap()
}

/// A step's shadow is as long as the step is high, times the tangent of the light's angle from the
/// normal.
#[test]
fn a_steps_shadow_has_its_length() {
    let (edge, high) = (40, 6.0_f32);
    for theta in [20.0_f32, 45.0, 60.0, 70.0] {
        let (sin, cos) = theta.to_radians().sin_cos();
        let length = high * theta.to_radians().tan();
        // Walls along x and along y, from either side.
        for (axis, side) in [(0, 1.0), (1, 1.0), (0, -1.0), (1, -1.0)] {
            let along = |x: usize, y: usize| if axis == 0 { x } else { y };
            let is_high = |at: usize| {
                if side > 0.0 { (edge..60).contains(&at) } else { (20..=edge).contains(&at) }
            };
            let size = if axis == 0 { [80, 3] } else { [3, 80] };
            let step = field(size, WHITE, |x, y| if is_high(along(x, y)) { high } else { 0.0 });
            let toward = if axis == 0 { [side * sin, 0.0, cos] } else { [0.0, side * sin, cos] };
            let lit = lit(sun(), &step, toward);
            for cell in 0..size[0] * size[1] {
                let middle = step.middle(cell)[axis];
                let before = side * (edge as f32 - middle);
                // The wall itself is one cell wide.
                if before > 1.0 && before < 30.0 && (before - length).abs() > 1e-3 {
                    let expected = if before > length { 1.0 } else { 0.0 };
                    assert_eq!(
                        lit.visible[cell], expected,
                        "{theta}, axis {axis}, {before} of {length}"
                    );
                }
            }
        }
    }
}

/// Each cell sees the point of a raised plane that lies toward the eye from the cell, at a distance
/// of the plane's height above the pivot times the tangent of the eye's angle from the normal.
#[test]
fn a_raised_plane_is_seen_where_it_ought_to_be() {
    let high = 5.0;
    let plane = field([24, 24], WHITE, |_, _| high);
    for (theta, around) in [(0.0_f32, 0.0_f32), (0.3, 0.0), (0.7, 1.0), (1.1, 4.0), (1.5, 2.0)] {
        for pivot in [0.0, 0.25, 1.0] {
            let relief = Relief { pivot, ..Relief::default() };
            let toward = [theta.sin() * around.sin(), theta.sin() * around.cos(), theta.cos()];
            let seen = VisibleSurface::new(&relief, &plane, toward, &Progress::new()).unwrap();
            let moved = (1.0 - pivot as f32) * high * theta.min(FARTHEST_VIEW).tan();
            for (at, hit) in seen.hits.iter().enumerate() {
                let start = [(at % 24) as f32 + 0.5, (at / 24) as f32 + 0.5];
                let expected =
                    [start[0] + moved * around.sin(), start[1] + moved * around.cos(), high];
                for (found, expected) in hit.place.iter().zip(expected) {
                    assert!(
                        (found - expected).abs() < 2e-3,
                        "{theta} {around} {pivot}: {:?}, {expected}",
                        hit.place
                    );
                }
            }
        }
    }
}

/// The horizon in a direction is the greatest slope to any place along that direction, however it
/// is searched for, and rises with the field.
#[test]
fn the_horizon_is_the_steepest_slope_and_rises_with_the_field() {
    let size = [19, 23];
    // Ridges are straight between grid lines, so that the crossings give exact slopes.
    let ridge = |x: usize| 4.0 * chance(x, 0);
    let low = field(size, WHITE, |x, _| ridge(x));
    let high = field(size, WHITE, |x, _| ridge(x) + if chance(x, 1) > 0.7 { 2.0 } else { 0.0 });
    for cell in (0..size[0] * size[1]).step_by(29) {
        let [x, y, z] = low.middle(cell);
        for turn in 0..12 {
            let turn = 0.3 + turn as f32;
            let direction = [turn.sin(), turn.cos()];
            let found = low.horizon([x, y, z + 0.5], direction, -10.0, f32::INFINITY);
            // The reference goes by steps of a hundredth of a cell.
            let steepest = (1..8400).map(|step| {
                let far = step as f32 * 0.01;
                (low.height(x + far * direction[0], y + far * direction[1]) - z - 0.5) / far
            });
            let steepest = steepest.fold(-10.0_f32, f32::max);
            let is_near = (found - steepest).abs() < 0.01 + 0.05 * steepest.abs();
            assert!(is_near || (found < 0.0 && steepest < 0.0), "{found} {steepest}");
            assert!(high.horizon([x, y, z + 0.5], direction, -10.0, f32::INFINITY) >= found);
        }
    }
}

/// No light is lost or gained: a white relief under a white sky is white, whatever its form.
#[test]
fn a_white_furnace_stays_white() {
    let size = [24, 20];
    let forms: [fn(usize, usize) -> f32; 3] = [
        |x, y| 6.0 * chance(x, y),
        |x, y| if (5..15).contains(&x) && (4..12).contains(&y) { 0.0 } else { 7.0 },
        |x, _| 3.0 + 3.0 * (x as f32 / 24.0 * std::f32::consts::TAU * 2.0).sin(),
    ];
    for form in forms {
        let white = field(size, WHITE, form);
        let transport = Transport::new(&white, &Progress::new()).unwrap();
        let ones = vec![WHITE; size[0] * size[1]];
        for cell in 0..size[0] * size[1] {
            let [whole, ..] =
                transport.gathered(cell, &ones).map(|seen| seen + transport.sky[cell]);
            assert!((whole - 1.0).abs() < 1e-4 && transport.sky[cell] >= 0.0, "{whole}");
        }
        let mut before = vec![0.0; size[0] * size[1]];
        for bounces in [0, 1, 2, 8, 64] {
            let lit = lit(sky(bounces), &white, [0.0, 0.0, 1.0]);
            for (ambient, before) in lit.ambient.iter().zip(&mut before) {
                assert!(
                    ambient[0] >= *before - 1e-5 && ambient[0] <= 1.0 + 1e-4,
                    "{bounces}: {}",
                    ambient[0]
                );
                *before = ambient[0];
            }
        }
        assert!(before.iter().all(|ambient| (ambient - 1.0).abs() < 0.02), "{before:?}");
        // With a color that absorbs some of the light, every place gets less than under the sky
        // alone.
        let gray = field(size, [0.5; 3], form);
        assert!(
            lit(sky(64), &gray, [0.0, 0.0, 1.0])
                .ambient
                .iter()
                .all(|ambient| ambient[0] <= 1.0 + 1e-4)
        );
    }
}

/// At the foot of a long wall the sky fills the view factor that a wall leaves: (1 + cos of its
/// elevation) / 2.
#[test]
fn a_wall_hides_its_part_of_the_sky() {
    let (high, wide) = (8.0_f32, 120);
    let wall = field([wide, 4], WHITE, |x, _| if x < 4 { high } else { 0.0 });
    let transport = Transport::new(&wall, &Progress::new()).unwrap();
    for x in [5, 8, 12, 20, 40] {
        let near = high.atan2(x as f32 + 0.5 - 3.0);
        let far = high.atan2(wide as f32 - x as f32 - 0.5);
        let expected = 0.5 * (near.cos() + far.cos());
        assert!((transport.sky[x] - expected).abs() < 0.02, "{x}: {} {expected}", transport.sky[x]);
    }
}

fn painted(grid: Grid, seed: u32) -> Hcbtf {
    let mut hcbtf = Hcbtf::new(grid);
    let rgba = (0..4 * grid.texels()).map(|at| match at % 4 {
        3 => 255,
        _ => (255.0 * noise::chance(seed, at as i64, 0)) as u8,
    });
    hcbtf.painted.insert(
        Address::new([0, 0], [0, 0]),
        Arc::new(Tile::new(grid.size, rgba.collect()).unwrap()),
    );
    hcbtf
}

const GRID: Grid = {
    let directions = Directions { theta: 3, phi: 4 };
    Grid { size: [8, 6], light: directions, view: directions }
};

/// The relief of the painted sample at the normal.
fn of_painting() -> Relief {
    let from = Address::default();
    let pattern = Pattern::Painted {
        heights: from,
        channel: Channel::Luminance,
        is_inverted: false,
        colors: from,
    };
    Relief { pattern, depth: 0.2, ..Relief::default() }
}

/// A flat relief is Lambert's law: each texel's linear color times the cosine of the light.
#[test]
fn a_flat_relief_is_lamberts_law() {
    let mut hcbtf = painted(GRID, 3);
    hcbtf.rules =
        vec![Rule::Relief(Box::new(Relief { depth: 0.0, light: sun(), ..of_painting() }))];
    let filled = fill(&hcbtf, &Progress::new()).unwrap();
    let source = hcbtf.painted(Address::default()).unwrap();
    for (address, tile, _) in filled.iter().filter(|(address, ..)| *address != Address::default()) {
        let cosine = GRID.light.angles(address.light)[0].cos().max(0.0);
        for (found, texel) in tile.bytes().chunks_exact(4).zip(source.bytes().chunks_exact(4)) {
            for (found, own) in found[..3].iter().zip(texel) {
                let linear = crate::document::srgb_to_linear(f64::from(*own) / 255.0) * cosine;
                let shown = if linear <= 0.003_130_8 {
                    12.92 * linear
                } else {
                    1.055 * linear.powf(1.0 / 2.4) - 0.055
                };
                assert!(
                    (f64::from(*found) - 255.0 * shown).abs() < 0.51,
                    "{address}: {found}, {}",
                    255.0 * shown
                );
            }
            assert_eq!(found[3], 255);
        }
    }
}

/// Moving the painting around the tile moves the drawn relief, across all edges.
#[test]
fn reliefs_go_on_across_the_tiles_edges() {
    let hcbtf = painted(GRID, 9);
    let mut moved = hcbtf.clone();
    let source = hcbtf.painted(Address::default()).unwrap();
    let shifted = |tile: &Tile| {
        let texels = (0..6).flat_map(|y| (0..8).map(move |x| (x, y)));
        Tile::new([8, 6], texels.flat_map(|(x, y)| tile.texel(x - 3, y - 2)).collect()).unwrap()
    };
    moved.painted.insert(Address::default(), Arc::new(shifted(source)));
    let tile = |hcbtf: &Hcbtf, address| {
        let ready = PreparedRelief::new(&of_painting(), hcbtf, &Progress::new()).unwrap();
        let color = ready.tile(address, &Progress::new()).unwrap();
        Tile::new([8, 6], color.iter().flatten().map(|channel| channel.round() as u8).collect())
            .unwrap()
    };
    for address in
        [Address::new([1, 1], [1, 2]), Address::new([1, 3], [2, 0]), Address::new([0, 0], [1, 3])]
    {
        let (expected, found) = (shifted(&tile(&hcbtf, address)), tile(&moved, address));
        let off = expected.bytes().iter().zip(found.bytes()).map(|(a, b)| a.abs_diff(*b)).max();
        assert!(off <= Some(1), "{address}: {off:?}");
    }
}

fn patterns() -> Vec<Pattern> {
    let gray = [128; 3];
    vec![
        Pattern::default(),
        Pattern::Stones {
            count: 5,
            share: 0.7,
            grit: 0.5,
            roundness: 0.5,
            colors: [gray, [200; 3]],
            binder: [40; 3],
        },
        Pattern::Facade {
            columns: 3,
            floors: 2,
            window: [0.5, 0.6],
            frame: 0.1,
            sill: 0.5,
            roughness: 0.5,
            wall: gray,
            trim: [200; 3],
            glass: [60; 3],
            lit: 0.5,
            lit_color: [255, 220, 150],
        },
        Pattern::Arches {
            columns: 2,
            rows: 1,
            opening: [0.5, 0.7],
            ring: 0.3,
            courses: 6,
            roughness: 0.5,
            wall: gray,
            trim: [200; 3],
            inside: [40; 3],
        },
        Pattern::Ripples { count: 4, bend: 1.0, roughness: 0.5, colors: [gray, [200; 3]] },
        Pattern::Ripples { count: 0, bend: 0.0, roughness: 1.0, colors: [gray, [200; 3]] },
    ]
}

/// Patterns are the same at both edges of the tile, and every height is from 0 to 1.
#[test]
fn patterns_repeat_without_a_seam() {
    let hcbtf = Hcbtf::new(GRID);
    for pattern in patterns() {
        let relief = Relief { pattern, ..Relief::default() };
        let sampler = PatternSampler::new(&relief, &hcbtf).unwrap();
        for step in 0..40 {
            let at = (step as f32 + 0.3) / 40.0;
            for (one, other) in [([0.0, at], [1.0, at]), ([at, 0.0], [at, 1.0])] {
                let heights = [one, other].map(|place| sampler.height(place));
                assert!(
                    (heights[0] - heights[1]).abs() < 1e-3,
                    "{:?} {one:?}: {heights:?}",
                    relief.pattern
                );
                let [a, b] = [one, other].map(|place| sampler.material(place).color);
                assert!((0..3).all(|i| (a[i] - b[i]).abs() < 1e-3), "{:?} {one:?}", relief.pattern);
            }
            assert!((0.0..=1.0).contains(&sampler.height([at, at * 0.7])));
        }
    }
}

fn finished() -> Finish {
    Finish { bands: 4, ink: 0.8, hatch: 0.5, wobble: 0.01, grain: 0.2, ..Finish::default() }
}

/// Rules of every pattern, with every feature on.
fn rules() -> Vec<Relief> {
    let relief = |pattern| Relief { pattern, depth: 0.15, finish: finished(), ..Relief::default() };
    patterns().into_iter().map(relief).chain([of_painting()]).collect()
}

/// The bytes are the same on any number of threads, and whatever sample is asked for first.
#[test]
fn a_relief_is_the_same_however_it_is_made() {
    for relief in [rules().swap_remove(2), of_painting()] {
        let mut hcbtf = painted(GRID, 1);
        hcbtf.rules = vec![Rule::Relief(Box::new(relief.clone()))];
        let on = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| fill(&hcbtf, &Progress::new()).unwrap())
        };
        let first = on(1);
        assert_eq!(first, on(3));
        let ready = PreparedRelief::new(&relief, &hcbtf, &Progress::new()).unwrap();
        let address = Address::new([2, 3], [2, 1]);
        let alone = ready.tile(address, &Progress::new()).unwrap();
        let bytes: Vec<u8> = alone.iter().flatten().map(|channel| (channel + 0.5) as u8).collect();
        assert_eq!(first.tile(address).unwrap().bytes(), bytes);
    }
}

#[test]
fn a_relief_can_be_stopped_and_needs_its_paintings() {
    let mut hcbtf = painted(GRID, 1);
    hcbtf.rules = vec![Rule::Relief(Box::new(of_painting()))];
    let stopped = Progress::new();
    stopped.stop();
    assert_eq!(fill(&hcbtf, &stopped), Err(NotFilled::Stopped));
    assert!(PreparedRelief::new(&of_painting(), &hcbtf, &stopped).is_none());
    let ready = PreparedRelief::new(&of_painting(), &hcbtf, &Progress::new()).unwrap();
    assert!(ready.tile(Address::default(), &stopped).is_none());
    // A relief without its painted sample fills nothing, and later rules fill the samples.
    hcbtf.painted.clear();
    hcbtf.rules.push(Rule::Color { color: [9, 8, 7, 255] });
    let filled = fill(&hcbtf, &Progress::new()).unwrap();
    assert!(filled.tiles().iter().all(|tile| tile.texel(0, 0) == [9, 8, 7, 255]));
}

/// Every number has bounds, and a grid that is too fine is reported.
#[test]
fn numbers_out_of_bounds_are_told() {
    let wrong = |mend: fn(&mut Relief), word: &str| {
        let mut relief = Relief::default();
        mend(&mut relief);
        let told = relief.check(&GRID).unwrap_err();
        assert!(told.contains(word), "{told}");
    };
    wrong(|relief| relief.depth = -0.1, "depth");
    wrong(|relief| relief.pivot = f64::NAN, "pivot");
    wrong(|relief| relief.light.sun_amount = f64::INFINITY, "sun_amount");
    wrong(|relief| relief.light.bounces = 65, "bounces");
    wrong(|relief| relief.glint.sharpness = 0.0, "sharpness");
    wrong(|relief| relief.finish.hatch_lines = 0, "hatch_lines");
    wrong(|relief| relief.finish.wobble = 0.2, "wobble");
    wrong(
        |relief| {
            relief.pattern =
                Pattern::Ripples { count: 65, bend: 0.0, roughness: 0.0, colors: [[0; 3]; 2] }
        },
        "count",
    );
    let far = Address::new([5, 0], [0, 0]);
    let mut relief = of_painting();
    relief.pattern = Pattern::Painted {
        heights: far,
        channel: Channel::Alpha,
        is_inverted: true,
        colors: Address::default(),
    };
    assert!(relief.check(&GRID).unwrap_err().contains("outside the grid"));
    let fine = Grid { size: [1024, 512], ..GRID };
    assert!(Relief::default().check(&fine).unwrap_err().contains("1024"));
    let many = Directions { theta: 40, phi: 40 };
    assert!(
        Relief::default()
            .check(&Grid { size: [256, 256], light: many, view: many })
            .unwrap_err()
            .contains("MiB")
    );
    for relief in rules() {
        assert_eq!(relief.check(&GRID), Ok(()));
        let text = serde_json::to_string(&Rule::Relief(Box::new(relief.clone()))).unwrap();
        assert_eq!(
            serde_json::from_str::<Rule>(&text).unwrap(),
            Rule::Relief(Box::new(relief)),
            "{text}"
        );
    }
    let read = read_rules(r#"[{ "rule": "relief", "dept": 1 }]"#, &GRID, "rules.json");
    let told: Vec<String> = read.diagnostics.iter().map(ToString::to_string).collect();
    assert!(told.len() == 1 && told[0].contains("`dept`"), "{told:?}");
    assert!(told[0].contains("did you mean `depth`"), "{told:?}");
}

/// The sun warms as it sinks; a tile that stands upright counts from its own horizontal.
#[test]
fn the_sun_sinks_with_the_tile() {
    let flat = field([4, 4], WHITE, |_, _| 0.0);
    let light = Illumination { sun: [255, 255, 255], low_sun: [255, 0, 0], ..sun() };
    let upright = Illumination { is_upright: true, ..light.clone() };
    let toward = |theta: f32| [0.0, -theta.sin(), theta.cos()];
    let green = |light: &Illumination, theta: f32| lit(light.clone(), &flat, toward(theta)).sun[1];
    assert_eq!((green(&light, 0.0), green(&light, FRAC_PI_2)), (1.0, 0.0));
    assert_eq!((green(&upright, 0.0), green(&upright, FRAC_PI_2)), (0.0, 1.0));
}

#[test]
fn how_far_it_is_goes_from_nothing_to_all_while_it_is_prepared_too() {
    let directions = Directions { theta: 2, phi: 3 };
    let grid = Grid { size: [8, 5], light: directions, view: directions };
    let rules = vec![Rule::Relief(Box::default())];
    let hcbtf = Hcbtf { rules, ..Hcbtf::new(grid) };
    let told: std::sync::Arc<std::sync::Mutex<Vec<[u64; 2]>>> = Arc::default();
    let listener = told.clone();
    let progress = Progress::observed(move |progress| {
        listener.lock().unwrap().push(progress.steps());
    });
    fill(&hcbtf, &progress).unwrap();
    let [done, total] = progress.steps();
    // The grid has 4 x 4 samples, 4 views and 4 lights.
    assert_eq!(total, 5 * (16 + FIELD_TILES + TRANSPORT_TILES + 4 * (SEEN_TILES + LIT_TILES)));
    assert_eq!(done, total);
    let steps = told.lock().unwrap();
    assert!(steps.iter().all(|[_, of]| *of == total), "it is laid out once");
    // The field and its light transport come first, row by row.
    let ready = 5 * (FIELD_TILES + TRANSPORT_TILES);
    assert_eq!(steps.iter().filter(|[done, _]| *done <= ready).count(), 10);
}
