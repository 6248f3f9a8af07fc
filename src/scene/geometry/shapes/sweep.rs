//! A tube along a closed curve: the trefoil knot.

use std::f64::consts::TAU;

use glam::DVec3;

use crate::geometry::mesh::DEFAULT_MATERIAL;
use crate::geometry::soup::{Corner, TriangleSoup};

const ALONG: usize = 480;
const AROUND: usize = 48;
/// Radius of the tube.
const RADIUS: f64 = 0.2;

/// The trefoil as the (2, 3) torus knot, seen along its axis from the front.
fn trefoil(t: f64) -> DVec3 {
    let ring = 0.68 + 0.3 * (3.0 * t).cos();
    DVec3::new(ring * (2.0 * t).cos(), ring * (2.0 * t).sin(), 0.36 * (3.0 * t).sin())
}

/// The knot: a trefoil tube. Around the curve the frame is the Frenet frame (the curve bends
/// everywhere), so normals are exact.
pub(super) fn knot() -> TriangleSoup {
    let mut soup = TriangleSoup::default();
    let material = soup.material(DEFAULT_MATERIAL);
    const STEP: f64 = 1e-4;
    for i in 0..ALONG {
        let t = i as f64 / ALONG as f64 * TAU;
        let [before, at, after] = [t - STEP, t, t + STEP].map(trefoil);
        let tangent = (after - before).normalize();
        let normal = (after + before - at * 2.0).reject_from(tangent).normalize();
        let binormal = tangent.cross(normal);
        for j in 0..AROUND {
            let (sin, cos) = (j as f64 / AROUND as f64 * TAU).sin_cos();
            let outward = normal * cos + binormal * sin;
            soup.points.push((at + outward * RADIUS).as_vec3().to_array());
            soup.normals.push(outward.as_vec3().to_array());
        }
    }
    for i in 0..ALONG {
        for j in 0..AROUND {
            let corner = |soup: &mut TriangleSoup, di: usize, dj: usize| {
                let point = ((i + di) % ALONG * AROUND + (j + dj) % AROUND) as u32;
                // Along the tube the texture repeats 12 times, which keeps it about square.
                let uv = [12.0 * (i + di) as f32 / ALONG as f32, (j + dj) as f32 / AROUND as f32];
                soup.uvs.push(uv);
                Corner { point, normal: point, uv: soup.uvs.len() as u32 - 1 }
            };
            let [a, b, c, d] =
                [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(di, dj)| corner(&mut soup, di, dj));
            // The frame (tangent, normal, binormal) is right-handed, so around comes before along.
            soup.triangles.extend([[a, c, b], [a, d, c]]);
        }
    }
    soup.wear(material);
    soup
}
