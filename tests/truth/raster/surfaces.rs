//! Inputs and outputs of fragments: positions and varyings against rays, derivatives, depth,
//! blending, discards.

use std::sync::atomic::{AtomicUsize, Ordering};

use chiaro::progress::Progress;
use chiaro::reference::{
    LANES, PassTarget, QuadBatch, ReferenceOptions, SnapGrid, Triangles, VaryingInterpolation,
    rasterize, shade_all,
};
use glam::DVec3;

use super::shaders::{BOTH, CLEAR, Plain, at_pixel, draw, draw_all, in_order};
use crate::support::random::Random;

const SIZE: [u32; 2] = [60, 45];
const NEAR: f64 = 0.5;
const FAR: f64 = 40.0;
/// The cotangent of half of a vertical field of view of 60 degrees.
const ZOOM: f64 = 1.732_050_807_568_877;

/// Clip space of a point in front of an eye at the origin that looks along -z.
fn project(point: DVec3) -> [f64; 4] {
    let aspect = f64::from(SIZE[0]) / f64::from(SIZE[1]);
    let depth = FAR / (NEAR - FAR);
    [point.x * ZOOM / aspect, point.y * ZOOM, depth * (point.z + NEAR), -point.z]
}

/// The ray from the eye through a point of the screen, in pixels.
fn ray(x: f64, y: f64) -> DVec3 {
    let [ndc_x, ndc_y] = [2.0 * x / f64::from(SIZE[0]) - 1.0, 1.0 - 2.0 * y / f64::from(SIZE[1])];
    DVec3::new(ndc_x * f64::from(SIZE[0]) / f64::from(SIZE[1]) / ZOOM, ndc_y / ZOOM, -1.0)
}

/// The point where a ray meets the plane of a triangle, and the point's smallest barycentric
/// coordinate, above 0 inside.
fn meet([a, b, c]: [DVec3; 3], ray: DVec3) -> (DVec3, f64) {
    let normal = (b - a).cross(c - a);
    let hit = ray * (normal.dot(a) / normal.dot(ray));
    let part = |b: DVec3, c: DVec3| (b - hit).cross(c - hit).dot(normal) / normal.length_squared();
    (hit, part(b, c).min(part(c, a)).min(part(a, b)))
}

/// A shader that gives position, varyings and 1. The varyings are the point in space.
fn traced(triangle: [DVec3; 3]) -> Plain<'static> {
    let numbers = triangle.iter().map(|point| point.to_array().to_vec()).collect();
    let fragment = |batch: &QuadBatch, lane: usize| {
        let mut numbers: Vec<f64> = (0..4).map(|c| batch.position(c)[lane]).collect();
        numbers.extend((0..3).map(|c| batch.varying(c)[lane]));
        numbers.push(1.0);
        Some(numbers)
    };
    Plain::new(triangle.map(project).to_vec(), fragment)
        .with(VaryingInterpolation::Perspective, numbers)
}

/// Draws a triangle, and compares every pixel with the ray through its middle. Gives the number of
/// covered pixels.
fn hold_against_rays(triangle: [DVec3; 3]) -> usize {
    hold_against_rays_on(SnapGrid::None, triangle)
}

fn hold_against_rays_on(snap: SnapGrid, triangle: [DVec3; 3]) -> usize {
    let shader = traced(triangle);
    let options = ReferenceOptions { snap, ..ReferenceOptions::default() };
    let raster = draw(SIZE, 1, &PassTarget::Numbers(8), &[0, 1, 2], &shader, &options);
    let mut covered = 0;
    for y in 0..SIZE[1] {
        for x in 0..SIZE[0] {
            let [middle_x, middle_y] = [x, y].map(|pixel| f64::from(pixel) + 0.5);
            let (hit, within) = meet(triangle, ray(middle_x, middle_y));
            let distance = -hit.z;
            let depths = (distance - NEAR).min(FAR - distance);
            let pixel = raster.texels.pixel(x, y);
            if within.min(depths).abs() < 1e-6 {
                continue; // On an edge.
            }
            let (is_covered, is_inside) = (pixel[7] == 1.0, within > 0.0 && depths > 0.0);
            // Snapping to a grid moves edges, but no value within them.
            assert!(
                is_covered == is_inside || snap != SnapGrid::None,
                "({x}, {y}): {within}, {depths}"
            );
            if !(is_covered && is_inside) {
                continue;
            }
            covered += 1;
            let [_, _, z, w] = project(hit);
            let wanted = [middle_x, middle_y, z / w, 1.0 / distance, hit.x, hit.y, hit.z];
            for (found, wanted) in pixel.iter().zip(wanted) {
                assert!(
                    (found - wanted).abs() < 1e-7 * (1.0 + wanted.abs()),
                    "({x}, {y}): {pixel:?}, not {wanted}"
                );
            }
        }
    }
    covered
}

#[test]
fn varyings_are_where_rays_meet_the_plane() {
    let mut random = Random::new(11);
    let mut covered = 0;
    for _ in 0..60 {
        let corner = |random: &mut Random| {
            let at = random.between(1.0, 30.0);
            DVec3::new(random.between(-at, at), random.between(-at, at), -at)
        };
        covered +=
            hold_against_rays([corner(&mut random), corner(&mut random), corner(&mut random)]);
    }
    assert!(covered > 10_000, "{covered}");
}

#[test]
fn a_grid_decides_coverage_and_moves_no_plane() {
    let mut random = Random::new(15);
    let mut covered = 0;
    for _ in 0..400 {
        // Triangles of a few pixels, of which a step of the grid would be a hundredth.
        let middle = [(); 2].map(|()| random.between(-4.0, 4.0));
        let corner = |random: &mut Random| {
            let [x, y] = middle.map(|x| x + random.between(-1.0, 1.0));
            DVec3::new(x, y, random.between(-11.0, -9.0))
        };
        let triangle = [corner(&mut random), corner(&mut random), corner(&mut random)];
        covered += hold_against_rays_on(SnapGrid::Subpixel(8), triangle);
    }
    assert!(covered > 1000, "{covered}");
}

/// A sliver that the grid widens or turns around gives no value beyond those of its corners,
/// however steep its own plane is.
#[test]
fn slivers_on_a_grid_give_nothing_beyond_their_corners() {
    let mut random = Random::new(16);
    let mut covered = 0;
    for _ in 0..4000 {
        // A sliver almost through the middle of a pixel, and narrower than a step of the grid.
        let [x, y] = [20.5, 20.5].map(|x| x + random.between(-0.003, 0.003));
        let corners = [[x - 9.0, y - 9.0], [x + 9.0, y + 9.0], [x, y + random.between(0.0, 0.004)]];
        let clip = corners.map(|corner| at_pixel(SIZE, corner, 0.5)).to_vec();
        let shader = Plain::new(clip, |batch, lane| Some(vec![batch.varying(0)[lane], 1.0]))
            .with(VaryingInterpolation::Perspective, vec![vec![0.0], vec![0.0], vec![1.0]]);
        let options =
            ReferenceOptions { snap: SnapGrid::Subpixel(8), ..ReferenceOptions::default() };
        let raster = draw(SIZE, 1, &PassTarget::Numbers(2), &[0, 1, 2], &shader, &options);
        for pixel in raster.texels.values.chunks_exact(2).filter(|pixel| pixel[1] == 1.0) {
            assert!(pixel[0].abs() < 6.0, "{pixel:?} of {corners:?}");
            covered += 1;
        }
    }
    assert!(covered > 100, "{covered}");
}

#[test]
fn what_is_near_or_behind_the_eye_is_cut() {
    let mut random = Random::new(12);
    let mut covered = 0;
    for round in 0..80 {
        // One or two corners lie behind the eye, some beyond the far plane.
        let corner = |random: &mut Random, is_behind: bool| {
            let z =
                if is_behind { random.between(-0.4, 20.0) } else { random.between(-60.0, -2.0) };
            DVec3::new(random.between(-20.0, 20.0), random.between(-20.0, 20.0), z)
        };
        let corners = [0, 1, 2].map(|i| corner(&mut random, i <= round % 2));
        covered += hold_against_rays(corners);
    }
    // A triangle seen almost edge-on, and one with a corner at the eye itself.
    hold_against_rays([
        DVec3::new(-5.0, 0.01, 3.0),
        DVec3::new(5.0, 0.0, 3.0),
        DVec3::new(0.0, -0.01, -30.0),
    ]);
    covered +=
        hold_against_rays([DVec3::ZERO, DVec3::new(4.0, 0.0, -8.0), DVec3::new(0.0, 5.0, -9.0)]);
    assert!(covered > 10_000, "{covered}");
}

#[test]
fn a_floor_under_the_eye_is_cut_without_gaps() {
    let mut random = Random::new(13);
    let (mut points, mut indices) = (Vec::new(), Vec::new());
    for row in 0..=20_u32 {
        for column in 0..=20_u32 {
            let [x, z] = [column, row]
                .map(|step| 60.0 * (f64::from(step) / 10.0 - 1.0) + random.between(-2.0, 2.0));
            points.push(project(DVec3::new(x, -1.0, z)));
            if row < 20 && column < 20 {
                let corner = row * 21 + column;
                indices.extend([corner, corner + 1, corner + 22, corner, corner + 22, corner + 21]);
            }
        }
    }
    for snap in [SnapGrid::None, SnapGrid::Subpixel(8)] {
        // Number of times that each pixel is shaded: all fragments are discarded, so that none
        // hides another.
        let counts: Vec<_> = (0..SIZE[0] * SIZE[1]).map(|_| AtomicUsize::new(0)).collect();
        let shader = Plain::new(points.clone(), |batch, lane| {
            if batch.live() >> lane & 1 == 1 {
                let [x, y] = [0, 1].map(|c| batch.position(c)[lane] as usize);
                counts[y * SIZE[0] as usize + x].fetch_add(1, Ordering::Relaxed);
            }
            None
        });
        draw(
            SIZE,
            1,
            &CLEAR,
            &indices,
            &shader,
            &ReferenceOptions { snap, ..ReferenceOptions::default() },
        );
        for (y, row) in counts.chunks(SIZE[0] as usize).enumerate() {
            for (x, count) in row.iter().enumerate() {
                let hit = ray(x as f64 + 0.5, y as f64 + 0.5);
                // Distance at which the ray meets the plane one unit below the eye.
                let distance = -1.0 / hit.y;
                let wanted = usize::from(hit.y < 0.0 && distance < FAR && distance > NEAR);
                if (distance - FAR).abs() > 2.0 {
                    assert_eq!(count.load(Ordering::Relaxed), wanted, "({x}, {y}), {snap:?}");
                }
            }
        }
    }
}

#[test]
fn helpers_lie_on_the_triangles_plane() {
    let mut random = Random::new(14);
    let seen = AtomicUsize::new(0);
    for _ in 0..40 {
        let triangle = [(); 3].map(|()| {
            let at = random.between(4.0, 9.0);
            DVec3::new(random.between(-at, at), random.between(-at, at), -at)
        });
        let numbers = triangle.iter().map(|point| point.to_array().to_vec()).collect();
        let fragment = |batch: &QuadBatch, lane: usize| {
            for lane in lane & !3..(lane & !3) + 4 {
                let (hit, _) =
                    meet(triangle, ray(batch.position(0)[lane], batch.position(1)[lane]));
                if -hit.z > 1.0 && -hit.z < 30.0 {
                    let found = DVec3::from_array([0, 1, 2].map(|c| batch.varying(c)[lane]));
                    assert!((found - hit).length() < 1e-6 * hit.length(), "{found}, not {hit}");
                    seen.fetch_add(usize::from(batch.live() >> lane & 1 == 0), Ordering::Relaxed);
                }
            }
            Some(vec![0.0; 4])
        };
        let shader = Plain::new(triangle.map(project).to_vec(), fragment)
            .with(VaryingInterpolation::Perspective, numbers);
        draw(SIZE, 4, &CLEAR, &[0, 1, 2], &shader, &ReferenceOptions::default());
    }
    assert!(seen.into_inner() > 1000, "enough of them were helpers");
}

#[test]
fn derivatives_are_gradients() {
    let (gradient, value) = ([0.37, -1.21], 4.5);
    let corners = [[3.3, 2.1], [55.2, 9.7], [20.4, 41.9]];
    let numbers = corners.map(|[x, y]| vec![value + gradient[0] * x + gradient[1] * y]).to_vec();
    let fragment = |batch: &QuadBatch, lane: usize| {
        let quad = lane & !3;
        let number = |lane: usize| batch.varying(0)[quad + lane];
        let derivatives = [
            number(1) - number(0),
            number(3) - number(2),
            number(2) - number(0),
            number(3) - number(1),
        ];
        for (found, wanted) in
            derivatives.into_iter().zip([gradient[0], gradient[0], gradient[1], gradient[1]])
        {
            assert!((found - wanted).abs() < 1e-9, "{found}, not {wanted}");
        }
        Some(vec![1.0; 4])
    };
    let clip = corners.map(|corner| at_pixel(SIZE, corner, 0.5)).to_vec();
    let shader = Plain::new(clip, fragment).with(VaryingInterpolation::Perspective, numbers);
    let raster = draw(SIZE, 4, &CLEAR, &[0, 1, 2], &shader, &ReferenceOptions::default());
    assert!(raster.coverage.iter().filter(|coverage| coverage.samples > 0).count() > 500);
}

#[test]
fn flat_varyings_are_the_first_corners() {
    let clip = [[0.0, 0.0], [0.0, 90.0], [120.0, 0.0]].map(|at| at_pixel(SIZE, at, 0.5)).to_vec();
    for (indices, wanted) in [([0, 1, 2], 7.0), ([1, 2, 0], 8.0), ([2, 1, 0], 9.0)] {
        let fragment = |batch: &QuadBatch, lane: usize| Some(vec![batch.varying(0)[lane]]);
        let numbers = vec![vec![7.0], vec![8.0], vec![9.0]];
        let shader = Plain::new(clip.clone(), fragment).with(VaryingInterpolation::Flat, numbers);
        let raster =
            draw(SIZE, 1, &PassTarget::Numbers(1), &indices, &shader, &ReferenceOptions::default());
        assert_eq!(raster.texels.pixel(10, 20), [wanted]);
    }
}

/// Two triangles over the whole picture, at one depth.
fn sheet(depth: f64) -> Vec<[f64; 4]> {
    [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]]
        .map(|[x, y]| at_pixel(SIZE, [x * f64::from(SIZE[0]), y * f64::from(SIZE[1])], depth))
        .to_vec()
}

#[test]
fn discarded_fragments_leave_no_depth() {
    let is_odd = |batch: &QuadBatch, lane: usize| {
        (batch.position(0)[lane] + batch.position(1)[lane]) % 2.0 == 0.0
    };
    let front = Plain::new(sheet(0.2), move |batch, lane| {
        (!is_odd(batch, lane)).then(|| vec![1.0, 0.0, 0.0, 1.0])
    });
    let back = Plain::new(sheet(0.7), |_, _| Some(vec![0.0, 1.0, 0.0, 1.0]));
    let indices = in_order(6);
    for order in [[&front, &back], [&back, &front]] {
        let draws = order.map(|shader| (&indices[..], shader));
        let raster = draw_all(SIZE, 4, &CLEAR, &draws, &ReferenceOptions::default());
        for y in 0..SIZE[1] {
            for x in 0..SIZE[0] {
                let wanted =
                    if (x + y + 1) % 2 == 0 { [0.0, 1.0, 0.0, 1.0] } else { [1.0, 0.0, 0.0, 1.0] };
                assert_eq!(raster.texels.pixel(x, y), wanted, "({x}, {y})");
            }
        }
    }
}

#[test]
fn straight_colors_are_laid_over_and_samples_averaged() {
    let background = [0.1, 0.2, 0.05, 0.5];
    let colors = [[0.8, 0.4, 0.2, 0.25], [0.3, 0.9, 0.6, 0.5]];
    // The second shape covers the left half, and in column 30 the two samples on the left.
    let half = [[0.0, 0.0], [0.0, 100.0], [30.5, 0.0], [30.5, 0.0], [0.0, 100.0], [30.5, 100.0]];
    let half = half.map(|at| at_pixel(SIZE, at, 0.3)).to_vec();
    let shaders = [(sheet(0.6), colors[0]), (half, colors[1])]
        .map(|(clip, color)| Plain::new(clip, move |_, _| Some(color.to_vec())));
    let indices = in_order(6);
    let draws = [(&indices[..], &shaders[0]), (&indices[..], &shaders[1])];
    let raster =
        draw_all(SIZE, 4, &PassTarget::Picture(background), &draws, &ReferenceOptions::default());
    let over = |below: [f64; 4], [r, g, b, a]: [f64; 4]| {
        let premultiplied = [r * a, g * a, b * a, a];
        [0, 1, 2, 3].map(|i| premultiplied[i] + below[i] * (1.0 - a))
    };
    let one = over(background, colors[0]);
    let both = over(one, colors[1]);
    let mixed = [0, 1, 2, 3].map(|i| 0.5 * (one[i] + both[i]));
    for (x, wanted, draw) in [(10, both, 1), (30, mixed, 0), (50, one, 0)] {
        let pixel = raster.texels.pixel(x, 20);
        assert!(
            pixel.iter().zip(wanted).all(|(found, wanted)| (found - wanted).abs() < 1e-14),
            "{pixel:?}"
        );
        let coverage = raster.coverage[20 * SIZE[0] as usize + x as usize];
        assert_eq!((coverage.draw, coverage.samples), (Some(draw), 4));
        assert_eq!(coverage.is_inside(4), x != 30);
    }
}

#[test]
fn every_pixel_of_an_image_is_shaded_once() {
    let size = [37, 21];
    let count = AtomicUsize::new(0);
    let shader = Plain::new(Vec::new(), |batch, lane| {
        count.fetch_add(batch.live() as usize >> lane & 1, Ordering::Relaxed);
        let at = [0, 1].map(|c| batch.position(c));
        let quad = lane & !3;
        assert!(
            lane < LANES
                && at[0][quad + 1] - at[0][quad] == 1.0
                && at[1][quad + 2] - at[1][quad] == 1.0
        );
        Some(vec![at[0][lane], at[1][lane]])
    });
    for (threads, tile) in [(1, 64), (3, 10), (2, 2)] {
        let options = ReferenceOptions { threads, tile, ..ReferenceOptions::default() };
        let image = shade_all(size, 2, &shader, &options, &Progress::new()).expect("nothing fails");
        for y in 0..size[1] {
            for x in 0..size[0] {
                assert_eq!(image.pixel(x, y), [x, y].map(|pixel| f64::from(pixel) + 0.5));
            }
        }
    }
    assert_eq!(count.load(Ordering::Relaxed), 3 * 37 * 21);
}

#[test]
fn the_work_can_be_stopped_and_tells_how_far_it_is() {
    let progress = Progress::observed(|_| panic!("nothing was finished"));
    let shader = Plain::new(sheet(0.5), |_, _| {
        progress.stop();
        Some(vec![1.0; 4])
    });
    let indices = in_order(6);
    let triangles = [Triangles { indices: &indices, shader: &shader, sides: BOTH }];
    let options =
        ReferenceOptions { threads: 1, snap: SnapGrid::Subpixel(8), ..ReferenceOptions::default() };
    let problem =
        rasterize(SIZE, 1, &CLEAR, &triangles, &options, &progress).expect_err("it was stopped");
    assert_eq!(problem.code, "stopped");
    let shader = Plain::new(sheet(0.5), |_, _| Some(vec![1.0; 4]));
    let triangles = [Triangles { indices: &indices, shader: &shader, sides: BOTH }];
    let progress = Progress::new();
    rasterize(SIZE, 1, &CLEAR, &triangles, &options, &progress).expect("it was not");
    assert_eq!(progress.share(), 1.0);
    let problem =
        rasterize([1 << 15; 2], 4, &CLEAR, &[], &options, &Progress::new()).expect_err("too large");
    assert_eq!(problem.code, "reference-too-large");
    let problem =
        rasterize([8; 2], 2, &CLEAR, &[], &options, &Progress::new()).expect_err("no such samples");
    assert_eq!(problem.code, "reference-samples");
}
