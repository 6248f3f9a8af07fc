//! Coverage of samples: areas, points in triangles, the rules of the fill.

use std::f64::consts::PI;

use chiaro::reference::{PassTarget, ReferenceOptions, SnapGrid, VaryingInterpolation};

use super::shaders::{CLEAR, Plain, at_pixel, draw, draw_all, in_order, somewhere};
use crate::support::random::Random;

const SNAPS: [SnapGrid; 2] = [SnapGrid::None, SnapGrid::Subpixel(8)];
/// Samples of a pixel with four samples, from the pixel's upper left corner.
const FOUR: [[f64; 2]; 4] = [[0.375, 0.125], [0.875, 0.375], [0.125, 0.625], [0.625, 0.875]];

fn white(clip: Vec<[f64; 4]>) -> Plain<'static> {
    Plain::new(clip, |_, _| Some(vec![1.0; 4]))
}

fn options(snap: SnapGrid) -> ReferenceOptions {
    ReferenceOptions { snap, ..ReferenceOptions::default() }
}

fn cross(a: [f64; 2], b: [f64; 2], p: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
}

/// Distance of a point from the nearest side of a triangle, above 0 inside.
fn inside(corners: [[f64; 2]; 3], point: [f64; 2]) -> f64 {
    let [a, b, c] = corners;
    let side = cross(a, b, c).signum();
    let distance =
        |a: [f64; 2], b: [f64; 2]| side * cross(a, b, point) / (b[0] - a[0]).hypot(b[1] - a[1]);
    distance(a, b).min(distance(b, c)).min(distance(c, a))
}

#[test]
fn samples_inside_are_covered_and_no_others() {
    let size = [48, 31];
    let mut random = Random::new(1);
    for round in 0..60 {
        let corners = [(); 3].map(|()| somewhere(&mut random, size));
        for (samples, positions) in [(1, &[[0.5, 0.5]][..]), (4, &FOUR)] {
            for snap in SNAPS {
                let shader = white(corners.map(|corner| at_pixel(size, corner, 0.5)).to_vec());
                let raster = draw(size, samples, &CLEAR, &[0, 1, 2], &shader, &options(snap));
                // Largest move of a corner, and of its edges, by snapping.
                let blur = if snap == SnapGrid::None { 1e-9 } else { 1.0 / 256.0 };
                for y in 0..size[1] {
                    for x in 0..size[0] {
                        let distances = positions.iter().map(|at| {
                            inside(corners, [f64::from(x) + at[0], f64::from(y) + at[1]])
                        });
                        let least = distances.clone().filter(|distance| *distance > blur).count();
                        let most = distances.filter(|distance| *distance > -blur).count();
                        let found =
                            usize::from(raster.coverage[(y * size[0] + x) as usize].samples);
                        assert!(
                            (least..=most).contains(&found),
                            "round {round}, {snap:?}: ({x}, {y}) {found}"
                        );
                        let alpha = raster.texels.pixel(x, y)[3];
                        assert!((alpha * f64::from(samples) - found as f64).abs() < 1e-12);
                    }
                }
            }
        }
    }
}

#[test]
fn counted_areas_are_the_areas_of_triangles() {
    let size = [200, 200];
    let mut random = Random::new(2);
    let mut excess = 0.0;
    for _ in 0..40 {
        let corners =
            [(); 3].map(|()| size.map(|side| random.between(0.05, 0.95) * f64::from(side)));
        let shader = white(corners.map(|corner| at_pixel(size, corner, 0.5)).to_vec());
        let raster = draw(size, 4, &CLEAR, &[0, 1, 2], &shader, &ReferenceOptions::default());
        let counted: f64 = raster.texels.values.chunks_exact(4).map(|pixel| pixel[3]).sum();
        let area = 0.5 * cross(corners[0], corners[1], corners[2]).abs();
        let border: f64 = (0..3)
            .map(|i| {
                (corners[i][0] - corners[(i + 1) % 3][0])
                    .hypot(corners[i][1] - corners[(i + 1) % 3][1])
            })
            .sum();
        // A sample stands for a quarter of a pixel, and errors along the border are as good as
        // random.
        assert!((counted - area).abs() < border.sqrt(), "{counted} of {area}");
        excess += counted - area;
    }
    assert!(excess.abs() / 40.0 < 0.5, "no bias: {excess}");
}

/// A mesh of jittered squares over the whole picture and beyond, with some vertices on samples.
fn carpet(size: [u32; 2], cells: usize, random: &mut Random) -> (Vec<[f64; 2]>, Vec<u32>) {
    let mut points = Vec::new();
    for row in 0..=cells {
        for column in 0..=cells {
            let place = |i: usize, step: usize| {
                let share = (step as f64 + random.between(-0.3, 0.3)) / cells as f64;
                (1.4 * share - 0.2) * f64::from(size[i])
            };
            let mut point = [(0, column), (1, row)].map({
                let mut place = place;
                move |(i, step)| place(i, step)
            });
            if random.unit() < 0.3 {
                point = point.map(|x| (x * 2.0).round() / 2.0);
            }
            points.push(point);
        }
    }
    let mut indices = Vec::new();
    for row in 0..cells {
        for column in 0..cells {
            let at = |dx: usize, dy: usize| ((row + dy) * (cells + 1) + column + dx) as u32;
            let [a, b, c, d] = [at(0, 0), at(1, 0), at(0, 1), at(1, 1)];
            let either = random.unit() < 0.5;
            indices.extend(if either { [a, b, d, a, d, c] } else { [a, b, c, b, d, c] });
        }
    }
    (points, indices)
}

#[test]
fn meshes_without_gaps_cover_every_sample_once() {
    let size = [96, 80];
    let mut random = Random::new(3);
    for round in 0..8 {
        let (points, indices) = carpet(size, 4 + 5 * round, &mut random);
        for (samples, snap) in [(1, SNAPS[0]), (1, SNAPS[1]), (4, SNAPS[0]), (4, SNAPS[1])] {
            // Each triangle has corners of its own, nearer than those before, so that no triangle
            // hides another.
            let corners = indices.iter().enumerate().map(|(number, index)| {
                at_pixel(
                    size,
                    points[*index as usize],
                    0.9 - 0.8 * (number / 3) as f64 / indices.len() as f64,
                )
            });
            let faint = 1e-6;
            let shader =
                Plain::new(corners.collect(), move |_, _| Some(vec![0.0, 0.0, 0.0, faint]));
            let raster =
                draw(size, samples, &CLEAR, &in_order(indices.len()), &shader, &options(snap));
            for (pixel, coverage) in raster.texels.values.chunks_exact(4).zip(&raster.coverage) {
                assert_eq!(u32::from(coverage.samples), samples, "a gap");
                assert!((pixel[3] / faint - 1.0).abs() < 1e-9, "twice: {}", pixel[3] / faint);
            }
        }
    }
}

#[test]
fn rectangles_own_their_left_and_top_sides() {
    let size = [16, 12];
    let [left, top, right, bottom] = [3.5, 2.5, 9.5, 7.5];
    let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
    let clip = corners.map(|corner| at_pixel(size, corner, 0.5)).to_vec();
    for snap in SNAPS {
        for indices in
            [[0, 1, 2, 0, 2, 3], [0, 2, 1, 0, 3, 2], [0, 1, 3, 1, 2, 3], [3, 0, 1, 2, 3, 1]]
        {
            let raster = draw(size, 1, &CLEAR, &indices, &white(clip.clone()), &options(snap));
            for y in 0..size[1] {
                for x in 0..size[0] {
                    let wanted = (3..9).contains(&x) && (2..7).contains(&y);
                    assert_eq!(raster.texels.pixel(x, y)[3] == 1.0, wanted, "({x}, {y})");
                }
            }
        }
    }
}

#[test]
fn the_silhouette_of_a_finer_sphere_is_rounder() {
    let size = [400, 400];
    let radius = 180.0;
    let mut errors = Vec::new();
    for segments in [8, 16, 32] {
        let (mut clip, mut indices) = (Vec::new(), Vec::new());
        for ring in 0..=segments {
            let polar = PI * ring as f64 / segments as f64;
            for segment in 0..segments {
                let turn = 2.0 * PI * segment as f64 / segments as f64;
                // The ball is seen along its axis, so that its silhouette is a regular polygon.
                let at = [
                    200.0 + radius * polar.sin() * turn.cos(),
                    200.0 + radius * polar.sin() * turn.sin(),
                ];
                clip.push(at_pixel(size, at, 0.5 - 0.4 * polar.cos()));
                if ring < segments {
                    let next = (segment + 1) % segments;
                    let [a, b] =
                        [ring * segments + segment, ring * segments + next].map(|i| i as u32);
                    let [c, d] = [a, b].map(|i| i + segments as u32);
                    indices.extend([a, b, d, a, d, c]);
                }
            }
        }
        let raster = draw(size, 4, &CLEAR, &indices, &white(clip), &ReferenceOptions::default());
        let counted: f64 = raster.texels.values.chunks_exact(4).map(|pixel| pixel[3]).sum();
        let polygon = 0.5 * segments as f64 * (2.0 * PI / segments as f64).sin() * radius * radius;
        assert!((counted - polygon).abs() < 20.0, "{counted} of {polygon}");
        errors.push(PI * radius * radius - counted);
    }
    // Four times the triangles make a quarter of the error.
    for pair in errors.windows(2) {
        assert!((pair[0] / pair[1] - 4.0).abs() < 0.4, "{errors:?}");
    }
}

/// Triangles at random places, with random depths and colors.
fn clutter(size: [u32; 2], count: usize, alpha: f64, seed: u64) -> Plain<'static> {
    let mut random = Random::new(seed);
    let mut numbers = Vec::new();
    let mut clip = Vec::new();
    for _ in 0..count {
        let [middle, color] = [somewhere(&mut random, size), [random.unit(), random.unit()]];
        for _ in 0..3 {
            let at = middle.map(|x| x + random.between(-12.0, 12.0));
            clip.push(at_pixel(size, at, random.between(0.05, 0.95)));
            numbers.push(vec![color[0], color[1], random.unit(), alpha]);
        }
    }
    Plain::new(clip, |batch, lane| Some((0..4).map(|c| batch.varying(c)[lane]).collect()))
        .with(VaryingInterpolation::Perspective, numbers)
}

#[test]
fn opaque_triangles_may_come_in_any_order() {
    let size = [90, 70];
    let shader = clutter(size, 120, 1.0, 5);
    let forward = in_order(360);
    let backward: Vec<u32> = forward.chunks(3).rev().flatten().copied().collect();
    for samples in [1, 4] {
        let [one, other] = [&forward, &backward].map(|indices| {
            draw(size, samples, &CLEAR, indices, &shader, &ReferenceOptions::default()).texels
        });
        assert_eq!(one, other);
    }
}

#[test]
fn threads_tiles_and_memory_change_nothing() {
    let size = [131, 77];
    let shaders = [clutter(size, 300, 0.6, 6), clutter(size, 5000, 0.3, 7)];
    let indices = [in_order(900), in_order(15_000)];
    let draws = [(&indices[0][..], &shaders[0]), (&indices[1][..], &shaders[1])];
    for samples in [1, 4] {
        let make = |threads, tile, budget| {
            let options = ReferenceOptions {
                threads,
                tile,
                budget,
                snap: SnapGrid::Subpixel(8),
                ..ReferenceOptions::default()
            };
            draw_all(size, samples, &PassTarget::Picture([0.1, 0.2, 0.3, 1.0]), &draws, &options)
        };
        let first = make(1, 64, usize::MAX);
        assert!(first.coverage.iter().any(|coverage| coverage.draw == Some(1)));
        for (threads, tile, budget) in
            [(2, 64, usize::MAX), (3, 33, 1 << 16), (1, 512, 0), (2, 2, usize::MAX), (5, 8, 0)]
        {
            assert!(
                make(threads, tile, budget) == first,
                "{threads} threads, tiles of {tile}, budget {budget}"
            );
        }
    }
}

#[test]
fn counter_clockwise_is_the_front() {
    let size = [8, 8];
    let clip: Vec<_> =
        [[0.0, 0.0], [16.0, 0.0], [0.0, 16.0]].map(|at| at_pixel(size, at, 0.5)).to_vec();
    let front = |batch: &chiaro::reference::QuadBatch, lane: usize| {
        Some(vec![f64::from(batch.front() >> lane & 1 == 1), 0.0, 0.0, 1.0])
    };
    let shader = Plain::new(clip, front);
    // Triangles that are clockwise on the screen are the back of a mesh whose triangles run
    // counter-clockwise.
    for (indices, wanted) in [([0, 1, 2], 0.0), ([0, 2, 1], 1.0)] {
        let raster = draw(size, 1, &CLEAR, &indices, &shader, &ReferenceOptions::default());
        assert_eq!(raster.texels.pixel(3, 3), [wanted, 0.0, 0.0, 1.0]);
    }
}

#[test]
fn no_position_is_too_strange() {
    let size = [40, 30];
    let mut random = Random::new(8);
    for _ in 0..200 {
        let number = |random: &mut Random| {
            let magnitude =
                10_f64.powf(random.between(-20.0, 20.0) * f64::from(u8::from(random.chance(0.5))));
            let strange = [0.0, -0.0, f64::NAN, f64::INFINITY, f64::MIN_POSITIVE, f64::MAX, -1e-12];
            if random.chance(0.1) {
                *random.pick(&strange)
            } else {
                random.between(-1.0, 1.0) * magnitude
            }
        };
        let clip = (0..30).map(|_| [(); 4].map(|()| number(&mut random))).collect();
        let shader = white(clip);
        for snap in SNAPS {
            let raster = draw(size, 4, &CLEAR, &in_order(30), &shader, &options(snap));
            assert!(raster.texels.values.iter().all(|x| (0.0..=1.0).contains(x)));
        }
    }
}
