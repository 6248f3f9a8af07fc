//! UVs for surfaces that have none of their own.

use glam::{DVec2, DVec3};

use super::nets::Net;
use crate::geometry::mesh::DEFAULT_MATERIAL;
use crate::geometry::soup::{Corner, TriangleSoup};

/// The soup of a net: quads are cut along their shorter diagonals; corners get the points' normals,
/// and UVs from `uvs`, which takes a triangle's points.
fn soup(net: &Net, uvs: impl Fn([usize; 3]) -> [DVec2; 3]) -> TriangleSoup {
    let mut soup = TriangleSoup {
        points: net.points.iter().map(|p| p.as_vec3().to_array()).collect(),
        normals: net.normals.iter().map(|n| n.as_vec3().to_array()).collect(),
        ..TriangleSoup::default()
    };
    let material = soup.material(DEFAULT_MATERIAL);
    for quad in &net.quads {
        let at = |i: usize| net.points[quad[i] as usize];
        let first = at(0).distance_squared(at(2)) <= at(1).distance_squared(at(3));
        for triangle in if first { [[0, 1, 2], [0, 2, 3]] } else { [[0, 1, 3], [1, 2, 3]] } {
            let points = triangle.map(|i| quad[i]);
            let base = soup.uvs.len() as u32;
            soup.uvs.extend(uvs(points.map(|p| p as usize)).map(|uv| uv.as_vec2().to_array()));
            soup.triangles.push([0, 1, 2].map(|k| Corner {
                point: points[k],
                normal: points[k],
                uv: base + k as u32,
            }));
        }
    }
    soup.wear(material);
    soup
}

/// UVs of longitude and latitude seen from the origin: u grows to the right seen from the front,
/// with the seam behind.
pub(super) fn spherical(net: &Net) -> TriangleSoup {
    let turns: Vec<DVec2> = net.points.iter().map(|&p| turn(p)).collect();
    soup(net, |points| {
        let mut uvs = points.map(|p| turns[p]);
        let most = uvs.iter().map(|uv| uv.x).fold(0.0, f64::max);
        for uv in &mut uvs {
            // Triangles across the seam go on beyond 1.
            uv.x += if most - uv.x > 0.5 { 1.0 } else { 0.0 };
        }
        uvs
    })
}

fn turn(p: DVec3) -> DVec2 {
    let longitude = f64::atan2(p.x, p.z) / std::f64::consts::TAU + 0.5;
    let latitude = f64::atan2(p.y, p.x.hypot(p.z)) / std::f64::consts::PI + 0.5;
    DVec2::new(longitude, latitude)
}

/// UVs from six views along the axes: each triangle is seen along the axis that it faces most, each
/// view in a field of its own: three columns (x, y, z), two rows (from above 0, from below). Even
/// scale, nothing mirrored, seams where the views meet.
pub(super) fn boxed(net: &Net) -> TriangleSoup {
    let ends = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let (min, max) = net.points.iter().fold(ends, |(min, max), &p| (min.min(p), max.max(p)));
    let (center, scale) = ((min + max) / 2.0, 1.0 / (max - min).max_element());
    soup(net, |points| {
        let at = points.map(|p| net.points[p]);
        let facing = (at[1] - at[0]).cross(at[2] - at[0]);
        let size = facing.abs();
        let column = if size.z >= size.x.max(size.y) {
            2
        } else if size.x >= size.y {
            0
        } else {
            1
        };
        let front = facing[column] >= 0.0;
        let flip = if front { 1.0 } else { -1.0 };
        at.map(|p| {
            let q = (p - center) * scale;
            // Coordinates to the right and upwards for one who looks at that side.
            let seen = match column {
                0 => DVec2::new(-q.z * flip, q.y),
                1 => DVec2::new(q.x, -q.z * flip),
                _ => DVec2::new(q.x * flip, q.y),
            };
            let field = DVec2::new(column as f64, if front { 1.0 } else { 0.0 });
            (seen + 0.5 + field) / DVec2::new(3.0, 2.0)
        })
    })
}
