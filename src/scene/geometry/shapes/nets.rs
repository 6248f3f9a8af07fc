//! Meshes of a field's surface, in quads: surface nets on a grid, evened out and put back onto the
//! surface.
//!
//! Each sheet of the surface in a cell of the grid gets a vertex, each edge that the surface
//! crosses a quad. Then every vertex moves, a few times, to the middle of its neighbors and by
//! Newton's method back to where the field is 0, which makes even triangles; and the normal is the
//! field's gradient, so the shading is as smooth as the field.

use glam::DVec3;
use rayon::iter::{
    IndexedParallelIterator as _, IntoParallelIterator as _, IntoParallelRefIterator as _,
    IntoParallelRefMutIterator as _, ParallelIterator as _,
};

use super::sculpture::Sculpture;

/// Edge of a block, the smallest unit that is examined or passed over as a whole, in cells.
const BLOCK: usize = 4;
/// Edge of a region, whose pieces are looked up together, in blocks.
const REGION: usize = 4;
/// Number of rounds in which vertices are evened out.
const ROUNDS: usize = 4;
/// Share of the way to the middle of its neighbors that a vertex moves in each round.
const EVENING: f64 = 0.6;

/// A closed surface: positions, unit normals, and quads counter-clockwise seen from outside.
pub(super) struct Net {
    pub points: Vec<DVec3>,
    pub normals: Vec<DVec3>,
    pub quads: Vec<[u32; 4]>,
}

/// Sizes of the grid's cells.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cells {
    /// Edge of a cell, in the shape's units.
    pub edge: f64,
    /// Coordinates, for each axis by itself, between which edges are `fine` times as long; `[0, 0]`
    /// for none.
    pub detail: [[f64; 2]; 3],
    pub fine: f64,
}

impl Cells {
    /// Cells of one size.
    pub(super) const fn even(edge: f64) -> Self {
        Self { edge, detail: [[0.0; 2]; 3], fine: 1.0 }
    }

    /// Coordinates of the grid along an axis, from below `min` to beyond `max`; their number is a
    /// multiple of `multiple`.
    fn marks(&self, axis: usize, min: f64, max: f64, multiple: usize) -> Vec<f64> {
        let [low, high] = self.detail[axis];
        // Edges grow from fine to coarse over a few cells.
        let ease = 6.0 * self.edge;
        let edge = |x: f64| {
            let away = (low - x).max(x - high).max(0.0) / ease;
            let coarse = if low < high { away.min(1.0) } else { 1.0 };
            self.edge * (self.fine + (1.0 - self.fine) * coarse)
        };
        let mut marks = vec![min - 2.0 * self.edge];
        let mut at = marks[0];
        while at < max + 2.0 * self.edge || marks.len() % multiple != 0 {
            at += edge(at);
            marks.push(at);
        }
        marks
    }
}

/// The surface of `sculpture` on a grid of `cells`.
pub(super) fn polygonize(sculpture: &Sculpture, cells: Cells) -> Net {
    let cell = cells.edge;
    let grid = Grid::sample(sculpture, cells);
    let (mut net, pieces) = grid.net(sculpture);
    let (mut evened, mut counts) =
        (vec![DVec3::ZERO; net.points.len()], vec![0.0; net.points.len()]);
    for quad in &net.quads {
        quad.iter().for_each(|&i| counts[i as usize] += 2.0);
    }
    let Net { points, normals, .. } = &mut net;
    normals.par_iter_mut().zip(&*points).zip(&pieces).for_each(|((normal, point), pieces)| {
        *normal = sculpture.gradient(*point, pieces).1;
    });
    for _ in 0..ROUNDS {
        evened.fill(DVec3::ZERO);
        for quad in &net.quads {
            for k in 0..4 {
                evened[quad[k] as usize] +=
                    net.points[quad[(k + 1) % 4] as usize] + net.points[quad[(k + 3) % 4] as usize];
            }
        }
        let Net { points, normals, .. } = &mut net;
        points.par_iter_mut().enumerate().for_each(|(i, point)| {
            *point = point.lerp(evened[i] / f64::max(counts[i], 1.0), EVENING);
            // The gradient from the round's start is exact enough here; the exact one follows at
            // the end.
            let d = sculpture.distance(*point, &pieces[i]);
            *point -= newton(d, normals[i], cell);
        });
    }
    let Net { points, normals, .. } = &mut net;
    points.par_iter_mut().zip(normals).zip(&pieces).for_each(|((point, normal), pieces)| {
        let (d, gradient) = sculpture.gradient(*point, pieces);
        *point -= newton(d, gradient, cell);
        *normal = sculpture.gradient(*point, pieces).1.normalize_or(DVec3::Y);
    });
    net
}

/// The step from a point where the field is `d` onto the surface; at most a cell long.
fn newton(d: f64, gradient: DVec3, cell: f64) -> DVec3 {
    (gradient * (d / gradient.length_squared().max(0.05))).clamp_length_max(cell)
}

/// Values of the field at the corners of cells.
struct Grid {
    /// Coordinates of corners along x, y and z.
    marks: [Vec<f64>; 3],
    /// Number of coordinates along x, y and z.
    size: [usize; 3],
    /// The longest edge of a cell.
    cell: f64,
    /// Values at the corners, x fastest. Far from the surface only the sign is right.
    values: Vec<f32>,
}

impl Grid {
    fn sample(sculpture: &Sculpture, cells: Cells) -> Self {
        let (min, max) = sculpture.bounds();
        let marks = [0, 1, 2].map(|axis| cells.marks(axis, min[axis], max[axis], BLOCK * REGION));
        let size = [0, 1, 2].map(|axis| marks[axis].len());
        let mut grid =
            Self { marks, size, cell: cells.edge, values: vec![0.0; size[0] * size[1] * size[2]] };
        let all = sculpture.all();
        let regions: Vec<_> =
            steps([0; 3], size.map(|n| n / (BLOCK * REGION)), BLOCK * REGION).collect();
        let known = regions.into_par_iter().flat_map_iter(|region| {
            let (center, radius) = grid.block(region, BLOCK * REGION);
            let (pieces, _) = sculpture.near(center, radius, &all);
            let grid = &grid;
            steps(region, [REGION; 3], BLOCK)
                .map(move |block| (block, grid.values_of(sculpture, block, &pieces)))
        });
        for (block, values) in known.collect::<Vec<_>>() {
            for (at, value) in steps(block, [BLOCK; 3], 1).zip(values) {
                let index = grid.index(at);
                grid.values[index] = value;
            }
        }
        grid
    }

    /// The values of one block, x fastest: exact near the surface, elsewhere the value in the
    /// block's middle.
    fn values_of(
        &self,
        sculpture: &Sculpture,
        first: [usize; 3],
        among: &[u16],
    ) -> [f32; BLOCK * BLOCK * BLOCK] {
        let (center, radius) = self.block(first, BLOCK);
        let (pieces, middle) = sculpture.near(center, radius, among);
        // One cell more, so that crossings between blocks have both ends right.
        let far = middle.abs() > Sculpture::slack() * (radius + 2.0 * self.cell);
        let mut values = [middle as f32; BLOCK * BLOCK * BLOCK];
        if !far {
            for (value, at) in values.iter_mut().zip(steps(first, [BLOCK; 3], 1)) {
                *value = sculpture.distance(self.place(at), &pieces) as f32;
            }
        }
        values
    }

    /// The middle of the corners of a block, and the distance of the farthest corner from it.
    fn block(&self, first: [usize; 3], edge: usize) -> (DVec3, f64) {
        let (a, b) = (self.place(first), self.place(first.map(|i| i + edge - 1)));
        ((a + b) / 2.0, a.distance(b) / 2.0)
    }

    fn index(&self, [x, y, z]: [usize; 3]) -> usize {
        (z * self.size[1] + y) * self.size[0] + x
    }

    /// All cells, x fastest: the first corner of each, and the corner's index.
    fn cells(&self) -> impl Iterator<Item = ([usize; 3], usize)> {
        let [nx, ny, nz] = self.size;
        let rows = (0..nz - 1).flat_map(move |z| (0..ny - 1).map(move |y| [y, z]));
        rows.flat_map(move |[y, z]| {
            let row = (z * ny + y) * nx;
            (0..nx - 1).map(move |x| ([x, y, z], row + x))
        })
    }

    fn place(&self, [x, y, z]: [usize; 3]) -> DVec3 {
        DVec3::new(self.marks[0][x], self.marks[1][y], self.marks[2][z])
    }

    /// The vertices (with the pieces that matter around each vertex) and the quads between them.
    fn net(&self, sculpture: &Sculpture) -> (Net, Vec<Vec<u16>>) {
        let mut net = Net { points: Vec::new(), normals: Vec::new(), quads: Vec::new() };
        let mut crossed: Vec<[u32; EDGES]> = Vec::new();
        let mut cell_of = vec![NOWHERE; self.values.len()];
        let corners: [usize; 8] = std::array::from_fn(|i| self.index(corner([0; 3], i)));
        for (at, index) in self.cells() {
            let values = corners.map(|corner| self.values[index + corner]);
            if values.iter().any(|v| *v < 0.0) && values.iter().any(|v| *v >= 0.0) {
                cell_of[index] = crossed.len() as u32;
                crossed.push(self.sheets(at, &values.map(f64::from), &mut net.points));
            }
        }
        let [nx, ny, _] = self.size;
        // Steps in the index from a corner to the next along x, y and z.
        let strides = [1, nx, nx * ny];
        for (at, index) in self.cells() {
            for axis in 0..3 {
                let (second, third) = ((axis + 1) % 3, (axis + 2) % 3);
                let inside = self.values[index] < 0.0;
                if inside == (self.values[index + strides[axis]] < 0.0)
                    || at[second] == 0
                    || at[third] == 0
                {
                    continue;
                }
                // The four cells around the edge, and the corner of each at which the edge begins.
                let quad = [(1, 1), (0, 1), (0, 0), (1, 0)].map(|(i, j)| {
                    let cell = cell_of[index - i * strides[second] - j * strides[third]];
                    crossed[cell as usize][(i << second | j << third) * 3 + axis]
                });
                let [a, b, c, d] = quad;
                net.quads.push(if inside { [a, b, c, d] } else { [a, d, c, b] });
            }
        }
        let all = sculpture.all();
        let pieces =
            net.points.par_iter().map(|p| sculpture.near(*p, 2.0 * self.cell, &all).0).collect();
        net.normals = vec![DVec3::Y; net.points.len()];
        (net, pieces)
    }

    /// Appends a point for each sheet of the surface in a cell, the mean of where the sheet crosses
    /// the cell's edges, and gives the sheet's point for each edge. Two sheets in one cell must not
    /// share a point, or the surface would touch itself there. Where a face has two opposite
    /// corners inside, those are taken to be apart, from either side.
    fn sheets(&self, at: [usize; 3], values: &[f64; 8], points: &mut Vec<DVec3>) -> [u32; EDGES] {
        let inside = values.map(|v| v < 0.0);
        let mut sheet: [usize; EDGES] = std::array::from_fn(|edge| edge);
        for (axis, side) in [(0, 0), (0, 1), (1, 0), (1, 1), (2, 0), (2, 1)] {
            let (u, v) = (1 << ((axis + 1) % 3), 1 << ((axis + 2) % 3));
            let base = side << axis;
            // The face's corners in a ring, and the edge from each to the next.
            let ring = [base, base | u, base | u | v, base | v];
            let (along_u, along_v) = ((axis + 1) % 3, (axis + 2) % 3);
            let edges = [
                base * 3 + along_u,
                (base | u) * 3 + along_v,
                (base | v) * 3 + along_u,
                base * 3 + along_v,
            ];
            let crossed = |k: usize| inside[ring[k % 4]] != inside[ring[(k + 1) % 4]];
            let found: Vec<usize> = (0..4).filter(|&k| crossed(k)).collect();
            match found[..] {
                [a, b] => merge(&mut sheet, edges[a], edges[b]),
                [_, _, _, _] => {
                    (0..4)
                        .filter(|&k| inside[ring[k]])
                        .for_each(|k| merge(&mut sheet, edges[k], edges[(k + 3) % 4]));
                }
                _ => {}
            }
        }
        let mut point_of = [NOWHERE; EDGES];
        let mut sums = [(DVec3::ZERO, 0.0); EDGES];
        for i in 0..8 {
            for axis in 0..3 {
                let j = i | 1 << axis;
                if j != i && inside[i] != inside[j] {
                    let t = values[i] / (values[i] - values[j]);
                    let sum = &mut sums[sheet[i * 3 + axis]];
                    sum.0 += self.place(corner(at, i)).lerp(self.place(corner(at, j)), t);
                    sum.1 += 1.0;
                }
            }
        }
        for edge in 0..EDGES {
            let (sum, count) = sums[edge];
            if count > 0.0 {
                point_of[edge] = points.len() as u32;
                points.push(sum / count);
            }
        }
        sheet.map(|leader| point_of[leader])
    }
}

/// Number of slots for the edges of a cell: an edge's slot is 3 times the corner where it begins,
/// plus its axis. Half of the slots are not edges.
const EDGES: usize = 24;
/// Index of no cell and of no point.
const NOWHERE: u32 = u32::MAX;

/// Corner `i` of a cell; the bits of `i` are the steps along x, y and z.
fn corner(at: [usize; 3], i: usize) -> [usize; 3] {
    [at[0] + (i & 1), at[1] + (i >> 1 & 1), at[2] + (i >> 2 & 1)]
}

/// Joins the sheets of two edges.
fn merge(sheet: &mut [usize; EDGES], a: usize, b: usize) {
    let (from, to) = (sheet[a].max(sheet[b]), sheet[a].min(sheet[b]));
    sheet.iter_mut().filter(|leader| **leader == from).for_each(|leader| *leader = to);
}

/// The grid positions `first + i * step` for every i below `counts`, x fastest.
fn steps(first: [usize; 3], counts: [usize; 3], step: usize) -> impl Iterator<Item = [usize; 3]> {
    let [nx, ny, nz] = counts;
    (0..nx * ny * nz).map(move |i| {
        [first[0] + i % nx * step, first[1] + i / nx % ny * step, first[2] + i / nx / ny * step]
    })
}
