//! Tangents, in the way that normal maps are baked for (as MikkTSpace does it: each triangle's direction of growing u,
//! projected onto the corner's plane, normalised, weighted by the corner's angle; vertices whose triangles mirror the
//! UVs are split by the caller, see [`handedness`]).

use glam::{DVec2, DVec3, Vec3};

use super::mesh::Mesh;
use super::normals::corner_angle;

/// 1 where the UVs of a triangle run the same way round as the triangle does seen from its normal, -1 where they are
/// mirrored, 0 where they span no area.
pub(super) fn handedness(positions: [DVec3; 3], normal: DVec3, uvs: [DVec2; 3]) -> i8 {
    let (d1, d2) = (uvs[1] - uvs[0], uvs[2] - uvs[0]);
    let area = d1.perp_dot(d2);
    if area.abs() <= 1e-12 * d1.length_squared().max(d2.length_squared()) || area == 0.0 {
        return 0;
    }
    let face = (positions[1] - positions[0]).cross(positions[2] - positions[0]);
    if (area > 0.0) == (face.dot(normal) >= 0.0) { 1 } else { -1 }
}

/// The tangents of a mesh from its UVs. `sides` has each vertex's handedness: its triangles' [`handedness`], or 0 where
/// none of them has UVs to speak of. `given` tangents (`w` not 0) stay.
pub(super) fn from_uvs(mesh: &Mesh, sides: &[i8], given: &[[f32; 4]]) -> Vec<[f32; 4]> {
    let mut sums = vec![DVec3::ZERO; mesh.positions.len()];
    for triangle in mesh.indices.chunks_exact(3) {
        let corners = [0, 1, 2].map(|k| triangle[k] as usize);
        let at = corners.map(|v| DVec3::from(mesh.positions[v].map(f64::from)));
        let uv = corners.map(|v| DVec2::from(mesh.uvs[v].map(f64::from)));
        let (d1, d2) = (uv[1] - uv[0], uv[2] - uv[0]);
        let area = d1.perp_dot(d2);
        let along_u = ((at[1] - at[0]) * d2.y - (at[2] - at[0]) * d1.y) * area.signum();
        for k in 0..3 {
            let vertex = corners[k];
            let normal = DVec3::from(mesh.normals[vertex].map(f64::from));
            if handedness(at, normal, uv) != 0 {
                let angle = corner_angle(at[k], at[(k + 1) % 3], at[(k + 2) % 3]);
                sums[vertex] += along_u.reject_from(normal).normalize_or_zero() * angle;
            }
        }
    }
    (0..mesh.positions.len())
        .map(|v| {
            let normal = Vec3::from(mesh.normals[v]);
            match given.get(v) {
                Some(&[x, y, z, w]) if w != 0.0 => orthogonal(normal, Vec3::new(x, y, z), w.signum()),
                _ => orthogonal(normal, sums[v].as_vec3(), if sides[v] < 0 { -1.0 } else { 1.0 }),
            }
        })
        .collect()
}

/// The unit tangent nearest to `wish` that is orthogonal to `normal`; the level one where `wish` has no such part.
fn orthogonal(normal: Vec3, wish: Vec3, w: f32) -> [f32; 4] {
    let (n, wish) = (normal.as_dvec3(), wish.as_dvec3().normalize_or_zero());
    let tangent = wish.reject_from(n);
    let tangent = if tangent.length_squared() > 1e-12 { tangent.normalize() } else { level(n) };
    tangent.as_vec3().extend(w).to_array()
}

/// The level frame of a normal: the unit vector orthogonal to it and to y up, to the right of one who looks at the
/// surface; along x where the normal is y.
pub(super) fn level(normal: DVec3) -> DVec3 {
    let right = DVec3::Y.cross(normal);
    if right.length_squared() > 1e-10 { right.normalize() } else { DVec3::X.reject_from(normal).normalize() }
}
