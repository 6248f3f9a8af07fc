//! A subdivided icosahedron, and the energy of BADF Appendix B on it.

use std::collections::HashMap;

use glam::DVec3;

/// A closed triangle mesh on the unit sphere.
#[derive(Clone, Debug)]
pub(super) struct Icosphere {
    /// Positions of the vertices: unit vectors.
    pub(super) positions: Vec<DVec3>,
    /// Vertices of each triangle, counterclockwise from outside. The children of triangle `t` of
    /// the level above are triangles `4t` to `4t + 3`: those at its three corners, then the middle
    /// one.
    pub(super) triangles: Vec<[u32; 3]>,
    /// Number of times that the icosahedron was subdivided.
    pub(super) level: u32,
}

impl Icosphere {
    /// The icosahedron, each triangle split in four `level` times: `10 * 4^level + 2` vertices.
    pub(super) fn new(level: u32) -> Self {
        let (mut positions, mut triangles) = icosahedron();
        for _ in 0..level {
            let mut middles = HashMap::new();
            let mut children = Vec::with_capacity(4 * triangles.len());
            for &[a, b, c] in &triangles {
                let [ab, bc, ca] = [(a, b), (b, c), (c, a)].map(|(from, to): (u32, u32)| {
                    *middles.entry((from.min(to), from.max(to))).or_insert_with(|| {
                        positions
                            .push((positions[from as usize] + positions[to as usize]).normalize());
                        positions.len() as u32 - 1
                    })
                });
                children.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
            }
            triangles = children;
        }
        Self { positions, triangles, level }
    }

    /// The mean angle of an edge, approximately: that of the icosahedron, halved per level. In
    /// radians.
    pub(super) fn edge_angle(level: u32) -> f64 {
        2f64.atan() / f64::from(1u32 << level)
    }

    /// The neighbors of each triangle, across the edges opposite to its vertices, in their order.
    pub(super) fn neighbors(&self) -> Vec<[u32; 3]> {
        let mut sides = HashMap::with_capacity(3 * self.triangles.len());
        for (triangle, &[a, b, c]) in self.triangles.iter().enumerate() {
            for edge in [(b, c), (c, a), (a, b)] {
                sides.insert(edge, triangle as u32);
            }
        }
        // The neighbor runs along the same edge in the opposite direction.
        let across = |from: u32, to: u32| sides.get(&(to, from)).copied().unwrap_or(u32::MAX);
        self.triangles.iter().map(|&[a, b, c]| [across(b, c), across(c, a), across(a, b)]).collect()
    }

    /// The jumps of the Jacobian over all edges; see [`Jump`].
    ///
    /// With `area_weighted`, each squared jump counts `3 L^2 / (A_a + A_b)` (edge length L,
    /// triangle areas A), which makes up for an icosphere's triangles being of unequal size. The
    /// paper weighs all edges alike.
    pub(super) fn jumps(&self, area_weighted: bool) -> Vec<Jump> {
        let neighbors = self.neighbors();
        let mut jumps = Vec::with_capacity(3 * self.triangles.len() / 2);
        for (triangle, corners) in self.triangles.iter().enumerate() {
            for corner in 0..3 {
                let neighbor = neighbors[triangle][corner] as usize;
                // Each edge counts once, from its lower triangle; and a closed mesh has no edge
                // without a neighbor.
                if neighbor >= self.triangles.len() || neighbor < triangle {
                    continue;
                }
                let (i, j) = (corners[(corner + 1) % 3], corners[(corner + 2) % 3]);
                let opposite = self.triangles[neighbor].into_iter().find(|&v| v != i && v != j);
                let Some(opposite) = opposite else { continue };
                jumps.push(self.jump([i, j, corners[corner], opposite], area_weighted));
            }
        }
        jumps
    }

    fn jump(&self, vertices: [u32; 4], area_weighted: bool) -> Jump {
        let [i, j, k, l] = vertices.map(|vertex| self.positions[vertex as usize]);
        let edge = j - i;
        let squared_length = edge.length_squared();
        // Foot of the height from a vertex onto the edge (0 at i, 1 at j), and the length of that
        // height.
        let foot = |vertex: DVec3| {
            let along = (vertex - i).dot(edge) / squared_length;
            (along, (vertex - i - along * edge).length())
        };
        let ((along_a, height_a), (along_b, height_b)) = (foot(k), foot(l));
        let from_i = (1.0 - along_a) / height_a + (1.0 - along_b) / height_b;
        let from_j = along_a / height_a + along_b / height_b;
        // A triangle's area is half of length times height.
        let weight = if area_weighted {
            (6.0 * squared_length.sqrt() / (height_a + height_b)).sqrt()
        } else {
            1.0
        };
        Jump {
            vertices,
            coefficients: [from_i, from_j, -1.0 / height_a, -1.0 / height_b].map(|c| weight * c),
        }
    }

    /// The least height of any triangle, relative to an edge of the regular mesh; negative when a
    /// triangle is turned over.
    pub(super) fn least_height(&self) -> f64 {
        let height = |&[a, b, c]: &[u32; 3]| {
            let [a, b, c] = [a, b, c].map(|vertex| self.positions[vertex as usize]);
            let normal = (b - a).cross(c - a);
            let longest = (b - a).length().max((c - b).length()).max((a - c).length());
            normal.length().copysign(normal.dot(a + b + c)) / longest
        };
        self.triangles.iter().map(height).fold(f64::INFINITY, f64::min)
            / Self::edge_angle(self.level)
    }
}

/// A term of the energy: the change of the Jacobian of a function on the mesh over an edge.
///
/// Once the two triangles are unfolded onto a plane, their Jacobians agree along the edge and
/// differ only across it, by `(w(foot_a) - w_k) / h_a + (w(foot_b) - w_l) / h_b`: linear in the
/// values at the four vertices.
#[derive(Clone, Copy, Debug)]
pub(super) struct Jump {
    /// Vertices: the ends of the edge, then the opposite vertices.
    pub(super) vertices: [u32; 4],
    /// Factors of the values at the four vertices.
    pub(super) coefficients: [f64; 4],
}

/// Twelve unit vectors, and twenty triangles counterclockwise from outside.
pub(super) fn icosahedron() -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let (short, long) = (1.0, 0.5 * (1.0 + 5f64.sqrt()));
    let mut positions = Vec::with_capacity(12);
    for (s, l) in [(short, long), (-short, long), (short, -long), (-short, -long)] {
        positions.extend([DVec3::new(0.0, s, l), DVec3::new(s, l, 0.0), DVec3::new(l, 0.0, s)]);
    }
    // Faces are the triples of vertices that are all 2 apart (the length of an edge), turned to
    // face outside.
    let adjacent = |a: usize, b: usize| ((positions[a] - positions[b]).length() - 2.0).abs() < 1e-9;
    let mut triangles = Vec::with_capacity(20);
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if adjacent(a, b) && adjacent(b, c) && adjacent(a, c) {
                    let outward = positions[a].dot(positions[b].cross(positions[c])) > 0.0;
                    triangles.push(
                        if outward { [a, b, c] } else { [a, c, b] }.map(|vertex| vertex as u32),
                    );
                }
            }
        }
    }
    (positions.into_iter().map(DVec3::normalize).collect(), triangles)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mesh_is_closed_and_faces_outside() {
        for level in 0..4 {
            let sphere = Icosphere::new(level);
            let triangles = 20 << (2 * level);
            assert_eq!(sphere.triangles.len(), triangles);
            assert_eq!(sphere.positions.len(), triangles / 2 + 2);
            assert_eq!(sphere.jumps(false).len(), 3 * triangles / 2);
            assert!(
                sphere
                    .neighbors()
                    .iter()
                    .flatten()
                    .all(|&neighbor| (neighbor as usize) < triangles)
            );
            assert!(sphere.least_height() > 0.7, "{}", sphere.least_height());
        }
    }

    #[test]
    fn linear_functions_on_a_plane_have_no_jump() {
        // Four vertices in a plane (not on the sphere, which the energy does not require): a
        // crooked pair of triangles.
        let positions = vec![
            DVec3::new(0.0, 0.0, 0.0),
            DVec3::new(1.0, 0.2, 0.0),
            DVec3::new(0.3, 0.9, 0.0),
            DVec3::new(0.8, -0.7, 0.0),
        ];
        let linear = |p: DVec3| 3.0 - 2.0 * p.x + 5.0 * p.y;
        let mesh = Icosphere { positions, triangles: Vec::new(), level: 0 };
        let jump = mesh.jump([0, 1, 2, 3], false);
        let value: f64 =
            jump.coefficients.iter().zip(&mesh.positions).map(|(c, p)| c * linear(*p)).sum();
        assert!(value.abs() < 1e-14, "{value:e}");
    }

    /// Energy over squared norm, averaged over all spherical harmonics of a degree.
    fn rayleigh(sphere: &Icosphere, harmonics: &[fn(DVec3) -> f64]) -> f64 {
        let jumps = sphere.jumps(false);
        let (mut energy, mut norm) = (0.0, 0.0);
        for harmonic in harmonics {
            let values: Vec<f64> = sphere.positions.iter().map(|&p| harmonic(p)).collect();
            let jump = |j: &Jump| -> f64 {
                (0..4).map(|n| j.coefficients[n] * values[j.vertices[n] as usize]).sum()
            };
            energy += jumps.iter().map(|j| jump(j).powi(2)).sum::<f64>();
            norm += values.iter().map(|v| v * v).sum::<f64>();
        }
        energy / norm
    }

    /// The ratio of the energies of degrees 2 and 1.
    fn spectrum_ratio(level: u32) -> f64 {
        let sphere = Icosphere::new(level);
        let first: [fn(DVec3) -> f64; 3] = [|p| p.x, |p| p.y, |p| p.z];
        // Harmonics of equal norm, orthogonal to one another.
        let second: [fn(DVec3) -> f64; 5] = [
            |p| p.x * p.y,
            |p| p.y * p.z,
            |p| p.z * p.x,
            |p| 0.5 * (p.x * p.x - p.y * p.y),
            |p| (3.0 * p.z * p.z - 1.0) / 12f64.sqrt(),
        ];
        rayleigh(&sphere, &second) / rayleigh(&sphere, &first)
    }

    #[test]
    fn appendix_b_is_not_the_bilaplacian() {
        // l(l+1)(3l(l+1)-4) at 2 over 1 is 84/4 = 21; the squared Laplacian would give 36/4 = 9.
        let ratio = spectrum_ratio(4);
        assert!((ratio - 21.0).abs() < 0.35, "{ratio}");
    }
}
