//! A cube with rounded edges, a plane, and a plane in waves.

use std::f64::consts::FRAC_PI_4;

use glam::DVec3;

use crate::geometry::mesh::DEFAULT_MATERIAL;
use crate::geometry::soup::{Corner, TriangleSoup};

/// Radius of the rounded edges; the cube reaches from -0.8 to 0.8.
const ROUNDING: f64 = 0.16;
const HALF: f64 = 0.8;

/// The cube: six faces; between them a quarter of a cylinder along each edge and an eighth of a
/// sphere at each corner.
pub(super) fn cube() -> TriangleSoup {
    let flat = HALF - ROUNDING;
    // Coordinates across a face: the rounding's half in even angles, the flat part in even steps.
    let bends = (1..=12).map(|i| flat + ROUNDING * (f64::from(i) / 12.0 * FRAC_PI_4).tan());
    let upper: Vec<f64> = (1..=8).map(|i| flat * f64::from(i) / 8.0).chain(bends).collect();
    let across: Vec<f64> =
        upper.iter().rev().map(|x| -x).chain([0.0]).chain(upper.iter().copied()).collect();
    let mut soup = TriangleSoup::default();
    // The directions to the right and up on each face; their cross product points out of the cube.
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    for (right, up) in [(x, y), (-x, y), (-z, y), (z, y), (x, -z), (x, z)] {
        let out = right.cross(up);
        face(&mut soup, &across, |u, v| {
            let on_cube = right * u + up * v + out * HALF;
            let inner = on_cube.clamp(DVec3::splat(-flat), DVec3::splat(flat));
            let normal = (on_cube - inner).normalize();
            (inner + normal * ROUNDING, normal)
        });
    }
    soup
}

/// A square in the xy plane, from -1 to 1, facing the front.
pub(super) fn plane() -> TriangleSoup {
    let across: Vec<f64> = (-16..=16).map(|i| f64::from(i) / 16.0).collect();
    let mut soup = TriangleSoup::default();
    face(&mut soup, &across, |u, v| (DVec3::new(u, v, 0.0), DVec3::Z));
    soup
}

/// The square of `plane` in waves, of 5,000 triangles, as the thesis's test scene has it.
pub(super) fn waves() -> TriangleSoup {
    const HEIGHT: f64 = 0.13;
    const PER_UNIT: f64 = 1.5 * std::f64::consts::PI;
    let across: Vec<f64> = (-25..=25).map(|i| f64::from(i) / 25.0).collect();
    let mut soup = TriangleSoup::default();
    face(&mut soup, &across, |u, v| {
        let (a, b) = (PER_UNIT * u, PER_UNIT * v + 1.0);
        let height = HEIGHT * (a.sin() + 0.5 * b.sin());
        let slope = [a.cos(), 0.5 * b.cos()].map(|cosine| HEIGHT * PER_UNIT * cosine);
        (DVec3::new(u, v, height), DVec3::new(-slope[0], -slope[1], 1.0).normalize())
    });
    soup
}

/// Appends a grid over `across` times `across`; UVs are 0 to 1 over the whole grid.
fn face(soup: &mut TriangleSoup, across: &[f64], place: impl Fn(f64, f64) -> (DVec3, DVec3)) {
    let material = soup.material(DEFAULT_MATERIAL);
    let (n, base) = (across.len(), soup.points.len());
    let span = across[n - 1] - across[0];
    for &v in across {
        for &u in across {
            let (point, normal) = place(u, v);
            soup.points.push(point.as_vec3().to_array());
            soup.normals.push(normal.as_vec3().to_array());
            soup.uvs.push([u, v].map(|x| ((x - across[0]) / span) as f32));
        }
    }
    for j in 0..n - 1 {
        for i in 0..n - 1 {
            let corner = |di: usize, dj: usize| {
                let index = (base + (j + dj) * n + i + di) as u32;
                Corner { point: index, normal: index, uv: index }
            };
            let [a, b, c, d] = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
            soup.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    soup.wear(material);
}
