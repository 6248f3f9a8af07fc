//! Raw weights as the paper solves for them (BADF Appendix B): least squares over a subdivided
//! icosahedron.

use std::sync::LazyLock;

use chiaro_locale::tr;
use faer::linalg::solvers::Solve;
use faer::sparse::{SparseColMat, Triplet};
use faer::{Mat, Side};
use glam::DVec3;

use super::icosphere::{Icosphere, Jump, icosahedron};

/// The mesh of [`KeyScheme::Tessellated`](crate::document::KeyScheme).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tessellation {
    /// Number of times that an icosahedron is subdivided: 4 gives 2,562 vertices with edges of
    /// about 4 degrees. At most [`Tessellation::MAX_LEVEL`]; greater numbers are taken for that.
    pub level: u32,
    /// True if each edge is weighted by the areas beside it, which brings the solution nearer to
    /// the limit of regular meshes. The paper weighs all edges alike.
    pub area_weighted: bool,
}

impl Tessellation {
    /// Greatest level, of 40,962 vertices. Finer meshes come no nearer to the closed form, and take
    /// four times the memory per level.
    pub const MAX_LEVEL: u32 = 6;
}

impl Default for Tessellation {
    fn default() -> Self {
        Self { level: 4, area_weighted: false }
    }
}

/// Least height that a triangle may have once its vertices were moved onto keys, in edges.
const LEAST_HEIGHT: f64 = 0.1;

/// Raw weights at the vertices of a mesh that has a vertex at every key.
#[derive(Clone, Debug)]
pub(super) struct VertexWeights {
    mesh: Icosphere,
    neighbors: Vec<[u32; 3]>,
    /// Raw weights at the vertices, one row per vertex.
    values: Vec<f64>,
}

impl VertexWeights {
    /// Solves for the weights of unit directions. The error is the reason why the mesh cannot carry
    /// them.
    pub(super) fn solve(
        tessellation: Tessellation,
        centers: &[DVec3],
    ) -> Result<Self, &'static str> {
        let mut mesh = Icosphere::new(tessellation.level.min(Tessellation::MAX_LEVEL));
        let pins =
            pin(&mesh, centers).ok_or_else(|| tr!("two keys are nearest to the same vertex"))?;
        for (&vertex, &center) in pins.iter().zip(centers) {
            mesh.positions[vertex as usize] = center;
        }
        if mesh.least_height() < LEAST_HEIGHT {
            return Err(tr!("moving vertices onto the keys folds triangles"));
        }
        let values = minimize(&mesh.jumps(tessellation.area_weighted), mesh.positions.len(), &pins)
            .ok_or_else(|| tr!("its equations cannot be solved"))?;
        let neighbors = mesh.neighbors();
        Ok(Self { mesh, neighbors, values })
    }

    /// The raw weights at a unit direction, one per key: linear over the triangle that the
    /// direction passes through.
    pub(super) fn raw_into(&self, direction: DVec3, out: &mut [f64]) {
        let (triangle, shares) = self.locate(direction);
        out.fill(0.0);
        for (vertex, share) in self.mesh.triangles[triangle].into_iter().zip(shares) {
            let row = &self.values[vertex as usize * out.len()..][..out.len()];
            for (weight, value) in out.iter_mut().zip(row) {
                *weight += share * value;
            }
        }
    }

    /// The triangle that a direction passes through, and the barycentric coordinates of the
    /// intersection.
    fn locate(&self, direction: DVec3) -> (usize, [f64; 3]) {
        // Vertices were moved onto keys, so the triangle is a step or two away from that of the
        // regular mesh.
        let mut triangle = regular_triangle(direction, self.mesh.level);
        for _ in 0..64 {
            let areas = self.signed_areas(triangle, direction);
            let outermost = (0..3).min_by(|&a, &b| areas[a].total_cmp(&areas[b])).unwrap_or(0);
            // The bound is far more than the rounding of an area, so that no edge sends the walk
            // back and forth, and far less than the area of a triangle.
            if areas[outermost] >= -1e-14 {
                return (triangle, shares(areas));
            }
            triangle = self.neighbors[triangle][outermost] as usize;
        }
        let least =
            |t: usize| self.signed_areas(t, direction).into_iter().fold(f64::INFINITY, f64::min);
        let best = (0..self.mesh.triangles.len())
            .max_by(|&a, &b| least(a).total_cmp(&least(b)))
            .unwrap_or(0);
        (best, shares(self.signed_areas(best, direction)))
    }

    /// Six times the volume that the direction spans with the edge opposite to each vertex; all
    /// volumes are positive inside the triangle.
    fn signed_areas(&self, triangle: usize, direction: DVec3) -> [f64; 3] {
        let [a, b, c] =
            self.mesh.triangles[triangle].map(|vertex| self.mesh.positions[vertex as usize]);
        [direction.dot(b.cross(c)), direction.dot(c.cross(a)), direction.dot(a.cross(b))]
    }
}

/// Barycentric coordinates from signed areas; areas below 0 count as 0.
fn shares(areas: [f64; 3]) -> [f64; 3] {
    let areas = areas.map(|area| area.max(0.0));
    let sum: f64 = areas.iter().sum();
    if sum > 0.0 { areas.map(|area| area / sum) } else { [1.0 / 3.0; 3] }
}

/// The nearest vertex to each key; `None` if two keys have the same nearest vertex.
fn pin(mesh: &Icosphere, centers: &[DVec3]) -> Option<Vec<u32>> {
    let nearest = |center: &DVec3| {
        let cosines = mesh.positions.iter().map(|position| position.dot(*center)).enumerate();
        cosines.max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(vertex, _)| vertex as u32)
    };
    let pins: Vec<u32> = centers.iter().map(nearest).collect();
    let mut sorted = pins.clone();
    sorted.sort_unstable();
    sorted.dedup();
    (sorted.len() == pins.len()).then_some(pins)
}

/// The values at all vertices that minimize the sum of squared jumps, with pin k held at the k-th
/// unit vector: rows of `pins.len()` numbers. Solved by normal equations, pinned values eliminated,
/// and a sparse Cholesky factorization.
fn minimize(jumps: &[Jump], vertex_count: usize, pins: &[u32]) -> Option<Vec<f64>> {
    const PINNED: usize = usize::MAX;
    let mut key_of = vec![None; vertex_count];
    for (key, &vertex) in pins.iter().enumerate() {
        key_of[vertex as usize] = Some(key);
    }
    let mut unknowns = 0..;
    let unknown: Vec<usize> = key_of
        .iter()
        .map(|key| if key.is_some() { PINNED } else { unknowns.next().unwrap_or(PINNED) })
        .collect();
    let count = vertex_count - pins.len();
    let mut right = Mat::<f64>::zeros(count, pins.len());
    let mut entries = Vec::with_capacity(10 * jumps.len());
    for Jump { vertices, coefficients } in jumps {
        for (a, factor) in vertices.iter().zip(coefficients).map(|(&v, &c)| (v as usize, c)) {
            for (b, product) in
                vertices.iter().zip(coefficients).map(|(&v, &c)| (v as usize, c * factor))
            {
                match (key_of[a], key_of[b]) {
                    (None, None) if unknown[a] >= unknown[b] => {
                        entries.push(Triplet::new(unknown[a], unknown[b], product));
                    }
                    (None, Some(key)) => right[(unknown[a], key)] -= product,
                    _ => {}
                }
            }
        }
    }
    let matrix = SparseColMat::<usize, f64>::try_new_from_triplets(count, count, &entries).ok()?;
    let solution = matrix.sp_cholesky(Side::Lower).ok()?.solve(&right);
    let value = |vertex: usize, key: usize| match key_of[vertex] {
        Some(pinned) => f64::from(u8::from(pinned == key)),
        None => solution[(unknown[vertex], key)],
    };
    let values: Vec<f64> =
        (0..vertex_count * pins.len()).map(|at| value(at / pins.len(), at % pins.len())).collect();
    values.iter().all(|value| value.is_finite()).then_some(values)
}

/// The triangle of the regular icosphere that a direction passes through (either of two, on an
/// edge).
fn regular_triangle(direction: DVec3, level: u32) -> usize {
    static BASE: LazyLock<(Vec<DVec3>, Vec<[u32; 3]>)> = LazyLock::new(icosahedron);
    let (positions, triangles) = &*BASE;
    let corners = |t: usize| triangles[t].map(|vertex| positions[vertex as usize]);
    let toward = |t: usize| corners(t).into_iter().sum::<DVec3>().dot(direction);
    let mut triangle =
        (0..triangles.len()).max_by(|&s, &t| toward(s).total_cmp(&toward(t))).unwrap_or(0);
    let [mut a, mut b, mut c] = corners(triangle);
    for _ in 0..level {
        let [ab, bc, ca] = [a + b, b + c, c + a].map(DVec3::normalize);
        let beyond = |from: DVec3, to: DVec3| direction.dot(from.cross(to)) < 0.0;
        let (child, corners) = if beyond(ca, ab) {
            (0, [a, ab, ca])
        } else if beyond(ab, bc) {
            (1, [b, bc, ab])
        } else if beyond(bc, ca) {
            (2, [c, ca, bc])
        } else {
            (3, [ab, bc, ca])
        };
        triangle = 4 * triangle + child;
        [a, b, c] = corners;
    }
    triangle
}

#[cfg(test)]
mod tests {
    use super::*;

    const LEVEL_3: Tessellation = Tessellation { level: 3, area_weighted: false };

    fn centers() -> Vec<DVec3> {
        [[0.1, 0.9, 0.3], [-0.8, 0.2, 0.5], [0.3, -0.4, -0.9], [0.5, 0.8, 0.1]]
            .map(|d| DVec3::from(d).normalize())
            .to_vec()
    }

    #[test]
    fn every_direction_is_found_in_the_triangle_it_passes_through() {
        let solved = VertexWeights::solve(LEVEL_3, &centers()).unwrap();
        let mut directions: Vec<DVec3> = (0..5000u32)
            .map(|i| {
                let [a, b] = [f64::from(i) * 0.618_034, f64::from(i) * 0.754_878];
                let z = 2.0 * a.fract() - 1.0;
                let (sin, cos) = (std::f64::consts::TAU * b).sin_cos();
                DVec3::new((1.0 - z * z).sqrt() * cos, (1.0 - z * z).sqrt() * sin, z)
            })
            .collect();
        // Vertices and the middles of edges, where more than one triangle will do.
        directions.extend(&solved.mesh.positions);
        let at = |vertex: u32| solved.mesh.positions[vertex as usize];
        directions
            .extend(solved.mesh.triangles.iter().map(|&[a, b, _]| (at(a) + at(b)).normalize()));
        for direction in directions {
            let (triangle, shares) = solved.locate(direction);
            let corners = solved.mesh.triangles[triangle].map(at);
            let met: DVec3 =
                corners.into_iter().zip(shares).map(|(corner, share)| share * corner).sum();
            assert!((met.normalize() - direction).length() < 1e-12, "{direction}");
        }
    }

    #[test]
    fn the_solution_is_a_minimum() {
        // At every vertex that is no pin, the energy's derivative is 0.
        let centers = centers();
        let solved = VertexWeights::solve(LEVEL_3, &centers).unwrap();
        let key_count = centers.len();
        let mut gradient = vec![0.0; solved.values.len()];
        for Jump { vertices, coefficients } in solved.mesh.jumps(false) {
            for key in 0..key_count {
                let value = |n: usize| {
                    coefficients[n] * solved.values[vertices[n] as usize * key_count + key]
                };
                let jump: f64 = (0..4).map(value).sum();
                for n in 0..4 {
                    gradient[vertices[n] as usize * key_count + key] += jump * coefficients[n];
                }
            }
        }
        let pins: Vec<usize> = (0..key_count)
            .map(|k| {
                solved
                    .mesh
                    .positions
                    .iter()
                    .position(|p| *p == centers[k])
                    .expect("a vertex at every key")
            })
            .collect();
        let free = gradient.iter().enumerate().filter(|(at, _)| !pins.contains(&(at / key_count)));
        let largest = free.map(|(_, slope)| slope.abs()).fold(0.0, f64::max);
        let at_pins = gradient[pins[0] * key_count].abs();
        assert!(largest < 1e-10 * at_pins.max(1.0), "{largest:e} of {at_pins:e}");
        assert!(at_pins > 1e-3);
    }
}
