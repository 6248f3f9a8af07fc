//! Surfaces of revolution about the y axis: sphere, torus, vase.

use std::f64::consts::{PI, TAU};

use glam::DVec2;

use super::curve::Tube;
use crate::geometry::mesh::DEFAULT_MATERIAL;
use crate::geometry::soup::{Corner, TriangleSoup};

/// Number of steps in a full turn.
const SEGMENTS: usize = 160;

/// A ring of the surface: a point of the profile.
#[derive(Clone, Copy)]
struct Ring {
    /// Distance from the axis, and height.
    at: DVec2,
    /// Normal of the profile, outwards, of unit length.
    normal: DVec2,
    v: f64,
}

/// Turns a profile about the axis. The profile runs from below upwards with the outside to its
/// right; a ring on the axis is one point.
fn revolve(profile: &[Ring], closed: bool, segments: usize) -> TriangleSoup {
    let mut soup = TriangleSoup::default();
    let material = soup.material(DEFAULT_MATERIAL);
    let rings = if closed { profile.len() - 1 } else { profile.len() };
    for ring in &profile[..rings] {
        for i in 0..segments {
            let (sin, cos) = (i as f64 / segments as f64 * TAU - PI).sin_cos();
            let around = |p: DVec2| [p.x * sin, p.y, p.x * cos].map(|c| c as f32);
            soup.points.push(around(ring.at));
            soup.normals.push(around(ring.normal));
        }
    }
    for (j, pair) in profile.windows(2).enumerate() {
        for i in 0..segments {
            let corner = |soup: &mut TriangleSoup, di: usize, dj: usize| {
                let point = (((j + dj) % rings) * segments + (i + di) % segments) as u32;
                // A triangle at a point on the axis has the u of its middle there.
                let on_axis = pair[dj].at.x == 0.0;
                let u = (i as f64 + if on_axis { 0.5 } else { di as f64 }) / segments as f64;
                soup.uvs.push([u as f32, pair[dj].v as f32]);
                Corner { point, normal: point, uv: soup.uvs.len() as u32 - 1 }
            };
            let [a, b, c, d] =
                [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(di, dj)| corner(&mut soup, di, dj));
            if pair[0].at.x > 0.0 {
                soup.triangles.push([a, b, c]);
            }
            if pair[1].at.x > 0.0 {
                soup.triangles.push([a, c, d]);
            }
        }
    }
    soup.wear(material);
    soup
}

/// The points of a circle's arc in `steps` steps, with angles counted from the outward horizontal
/// upwards.
fn arc(
    center: DVec2,
    radius: f64,
    from: f64,
    to: f64,
    steps: usize,
) -> impl Iterator<Item = (DVec2, DVec2)> {
    (0..=steps).map(move |i| {
        let normal = DVec2::from_angle(from + (to - from) * i as f64 / steps as f64);
        (center + normal * radius, normal)
    })
}

/// The sphere, of radius 1, with exactly one point at each pole.
pub(super) fn sphere() -> TriangleSoup {
    ball_of(SEGMENTS / 2, SEGMENTS)
}

/// A sphere of 400 triangles, as the thesis's test scene has it.
pub(super) fn ball() -> TriangleSoup {
    ball_of(11, 20)
}

fn ball_of(steps: usize, segments: usize) -> TriangleSoup {
    let mut profile: Vec<Ring> = arc(DVec2::ZERO, 1.0, -PI / 2.0, PI / 2.0, steps)
        .enumerate()
        .map(|(i, (at, normal))| Ring { at, normal, v: i as f64 / steps as f64 })
        .collect();
    for (i, y) in [(0, -1.0), (steps, 1.0)] {
        (profile[i].at, profile[i].normal) = (DVec2::new(0.0, y), DVec2::new(0.0, y));
    }
    revolve(&profile, false, segments)
}

/// The torus, of radii 0.7 and 0.3, standing up, so that one sees through it from the front.
pub(super) fn torus() -> TriangleSoup {
    let steps = 80;
    let profile: Vec<Ring> = arc(DVec2::new(0.7, 0.0), 0.3, -PI, PI, steps)
        .enumerate()
        .map(|(i, (at, normal))| Ring { at, normal, v: i as f64 / steps as f64 })
        .collect();
    let mut soup = revolve(&profile, true, SEGMENTS);
    for p in soup.points.iter_mut().chain(&mut soup.normals) {
        let [x, y, z] = *p;
        *p = [x, -z, y];
    }
    soup
}

/// The vase: an amphora without handles, with foot, belly, neck and lip, then the same wall from
/// inside.
pub(super) fn vase() -> TriangleSoup {
    // Distances from the axis at heights, between which the profile bends smoothly.
    let outside = [
        (0.0, -1.0),
        (0.14, -1.0),
        (0.27, -0.995),
        (0.32, -0.96),
        (0.285, -0.90),
        (0.30, -0.82),
        (0.40, -0.66),
        (0.52, -0.46),
        (0.60, -0.24),
        (0.625, 0.0),
        (0.585, 0.22),
        (0.49, 0.42),
        (0.365, 0.57),
        (0.275, 0.69),
        (0.245, 0.81),
        (0.27, 0.91),
        (0.33, 0.97),
        (0.352, 0.992),
        (0.338, 1.004),
    ];
    let inside = [
        (0.30, 0.972),
        (0.235, 0.905),
        (0.205, 0.80),
        (0.235, 0.67),
        (0.325, 0.54),
        (0.445, 0.39),
        (0.535, 0.20),
        (0.57, 0.0),
        (0.545, -0.22),
        (0.46, -0.43),
        (0.33, -0.61),
        (0.16, -0.73),
        (0.0, -0.76),
    ];
    let points: Vec<DVec2> = outside.into_iter().chain(inside).map(DVec2::from).collect();
    let curve = spline(&points, 5);
    let lengths: Vec<f64> = curve
        .iter()
        .zip(curve.iter().skip(1))
        .scan(0.0, |sum, (a, b)| {
            *sum += a.0.distance(b.0);
            Some(*sum)
        })
        .collect();
    let total = lengths.last().copied().unwrap_or(1.0);
    let profile: Vec<Ring> = curve
        .iter()
        .enumerate()
        .map(|(i, &(at, tangent))| {
            let v = if i == 0 { 0.0 } else { lengths[i - 1] / total };
            // The outside lies to the right of the way up; on the axis the surface is level.
            let normal = DVec2::new(tangent.y, -tangent.x).normalize();
            let normal = if at.x == 0.0 { DVec2::new(0.0, normal.y.signum()) } else { normal };
            Ring { at, normal, v }
        })
        .collect();
    revolve(&profile, false, SEGMENTS)
}

/// Points and tangents of the natural cubic spline, `steps` to a span. The ends lie on the axis,
/// and the surface is level there, because the curve goes on mirrored beyond them.
fn spline(points: &[DVec2], steps: usize) -> Vec<(DVec2, DVec2)> {
    let mirrored = |p: &DVec2| DVec2::new(-p.x, p.y);
    let before = points[1..3].iter().rev().map(mirrored);
    let after = points.iter().rev().skip(1).take(2).map(mirrored);
    let all: Vec<[f64; 4]> =
        before.chain(points.iter().copied()).chain(after).map(|p| [p.x, p.y, 0.0, 0.0]).collect();
    let curve = Tube::through(&all);
    let count = (points.len() - 1) * steps;
    let at = |i: usize| curve.at(2.0 + i as f64 / steps as f64).truncate().truncate();
    let tangent = |i: usize| curve.slope(2.0 + i as f64 / steps as f64).truncate();
    let mut samples: Vec<(DVec2, DVec2)> = (0..=count).map(|i| (at(i), tangent(i))).collect();
    for end in [0, count] {
        samples[end].0.x = 0.0;
        samples[end].1.y = 0.0;
    }
    samples
}
