//! A field's surface as triangles: naive surface nets on a grid, evened out and put back onto the surface.
//!
//! Each cell of the grid that the surface crosses gets a vertex, each edge that it crosses a quad. Then every vertex
//! moves, a few times, to the middle of its neighbours and by Newton's method back to where the field is 0, which makes
//! even triangles; and the normal is the field's gradient, so the shading is as smooth as the field.

use glam::DVec3;

use super::sculpture::Sculpture;

/// Edge, in cells, of a block that is examined, or passed over, as a whole.
const BLOCK: usize = 4;
/// Edge, in blocks, of a region whose pieces are looked up together.
const REGION: usize = 4;
/// How often vertices are evened out.
const ROUNDS: usize = 4;
/// How far, of the way to the middle of its neighbours, a vertex moves each time.
const EVENING: f64 = 0.6;

/// A closed surface: places, unit normals, and quads counter-clockwise seen from outside.
pub(super) struct Net {
    pub points: Vec<DVec3>,
    pub normals: Vec<DVec3>,
    pub quads: Vec<[u32; 4]>,
}

/// How big cells are.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cells {
    /// Their edge, in the shape's units.
    pub edge: f64,
    /// Within these coordinates, for each axis by itself, edges are `fine` times as long; `[0, 0]` for nowhere.
    pub detail: [[f64; 2]; 3],
    pub fine: f64,
}

impl Cells {
    /// All of one size.
    pub(super) const fn even(edge: f64) -> Self {
        Self { edge, detail: [[0.0; 2]; 3], fine: 1.0 }
    }

    /// Coordinates along an axis from below `min` to beyond `max`, as many as a multiple of `multiple`.
    fn marks(&self, axis: usize, min: f64, max: f64, multiple: usize) -> Vec<f64> {
        let [low, high] = self.detail[axis];
        // From fine to coarse over a few cells.
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
    let (mut evened, mut counts) = (vec![DVec3::ZERO; net.points.len()], vec![0.0; net.points.len()]);
    for quad in &net.quads {
        quad.iter().for_each(|&i| counts[i as usize] += 2.0);
    }
    for (i, point) in net.points.iter().enumerate() {
        net.normals[i] = sculpture.gradient(*point, &pieces[i]).1;
    }
    for _ in 0..ROUNDS {
        evened.fill(DVec3::ZERO);
        for quad in &net.quads {
            for k in 0..4 {
                evened[quad[k] as usize] +=
                    net.points[quad[(k + 1) % 4] as usize] + net.points[quad[(k + 3) % 4] as usize];
            }
        }
        for (i, point) in net.points.iter_mut().enumerate() {
            *point = point.lerp(evened[i] / f64::max(counts[i], 1.0), EVENING);
            // The gradient of the start is near enough until the end.
            let d = sculpture.distance(*point, &pieces[i]);
            *point -= newton(d, net.normals[i], cell);
        }
    }
    for (i, point) in net.points.iter_mut().enumerate() {
        let (d, gradient) = sculpture.gradient(*point, &pieces[i]);
        *point -= newton(d, gradient, cell);
        net.normals[i] = sculpture.gradient(*point, &pieces[i]).1.normalize_or(DVec3::Y);
    }
    net
}

/// The step from a place of field `d` onto the surface; never farther than a cell.
fn newton(d: f64, gradient: DVec3, cell: f64) -> DVec3 {
    (gradient * (d / gradient.length_squared().max(0.05))).clamp_length_max(cell)
}

/// The field at the corners of cells.
struct Grid {
    /// The coordinates of corners along x, y and z.
    marks: [Vec<f64>; 3],
    /// How many those are.
    size: [usize; 3],
    /// The longest edge of a cell.
    cell: f64,
    /// x fastest. Far from the surface only the sign is right.
    values: Vec<f32>,
}

impl Grid {
    fn sample(sculpture: &Sculpture, cells: Cells) -> Self {
        let (min, max) = sculpture.bounds();
        let marks = [0, 1, 2].map(|axis| cells.marks(axis, min[axis], max[axis], BLOCK * REGION));
        let size = [0, 1, 2].map(|axis| marks[axis].len());
        let mut grid = Self { marks, size, cell: cells.edge, values: vec![0.0; size[0] * size[1] * size[2]] };
        let all = sculpture.all();
        for region in steps([0; 3], size.map(|n| n / (BLOCK * REGION)), BLOCK * REGION) {
            let (center, radius) = grid.block(region, BLOCK * REGION);
            let (pieces, _) = sculpture.near(center, radius, &all);
            for block in steps(region, [REGION; 3], BLOCK) {
                grid.fill(sculpture, block, &pieces);
            }
        }
        grid
    }

    /// The values of one block: exact near the surface, elsewhere the one in the middle.
    fn fill(&mut self, sculpture: &Sculpture, first: [usize; 3], among: &[u16]) {
        let (center, radius) = self.block(first, BLOCK);
        let (pieces, middle) = sculpture.near(center, radius, among);
        // A cell more, so that crossings between blocks have both ends right.
        let far = middle.abs() > Sculpture::slack() * (radius + 2.0 * self.cell);
        for at in steps(first, [BLOCK; 3], 1) {
            let value = if far { middle } else { sculpture.distance(self.place(at), &pieces) };
            let index = self.index(at);
            self.values[index] = value as f32;
        }
    }

    /// The middle of the corners of a block, and how far the farthest is from it.
    fn block(&self, first: [usize; 3], edge: usize) -> (DVec3, f64) {
        let (a, b) = (self.place(first), self.place(first.map(|i| i + edge - 1)));
        ((a + b) / 2.0, a.distance(b) / 2.0)
    }

    fn index(&self, [x, y, z]: [usize; 3]) -> usize {
        (z * self.size[1] + y) * self.size[0] + x
    }

    fn place(&self, [x, y, z]: [usize; 3]) -> DVec3 {
        DVec3::new(self.marks[0][x], self.marks[1][y], self.marks[2][z])
    }

    /// A vertex for each cell that the surface crosses (with the pieces that matter around it), a quad for each edge.
    fn net(&self, sculpture: &Sculpture) -> (Net, Vec<Vec<u16>>) {
        let mut net = Net { points: Vec::new(), normals: Vec::new(), quads: Vec::new() };
        let all = sculpture.all();
        let mut pieces = Vec::new();
        let mut vertex_of = vec![u32::MAX; self.values.len()];
        let [nx, ny, nz] = self.size;
        for index in 0..self.values.len() {
            let at = [index % nx, index / nx % ny, index / nx / ny];
            if at[0] + 1 >= nx || at[1] + 1 >= ny || at[2] + 1 >= nz {
                continue;
            }
            if let Some(point) = self.crossing(at) {
                vertex_of[index] = net.points.len() as u32;
                pieces.push(sculpture.near(point, 2.0 * self.cell, &all).0);
                net.points.push(point);
                net.normals.push(DVec3::Y);
            }
        }
        // From a corner to the next along x, y and z.
        let strides = [1, nx, nx * ny];
        for index in 0..self.values.len() {
            let at = [index % nx, index / nx % ny, index / nx / ny];
            for axis in 0..3 {
                let (second, third) = ((axis + 1) % 3, (axis + 2) % 3);
                if at[axis] + 1 >= self.size[axis] || at[second] == 0 || at[third] == 0 {
                    continue;
                }
                let (inside, beyond) = (self.values[index] < 0.0, self.values[index + strides[axis]] < 0.0);
                if inside == beyond {
                    continue;
                }
                let (u, v) = (strides[second], strides[third]);
                let [a, b, c, d] = [index - u - v, index - v, index, index - u].map(|cell| vertex_of[cell]);
                net.quads.push(if inside { [a, b, c, d] } else { [a, d, c, b] });
            }
        }
        (net, pieces)
    }

    /// The mean of where the surface crosses the edges of a cell; `None` where it does not.
    fn crossing(&self, at: [usize; 3]) -> Option<DVec3> {
        let corner = |i: usize| [at[0] + (i & 1), at[1] + (i >> 1 & 1), at[2] + (i >> 2 & 1)];
        let values: [f64; 8] = std::array::from_fn(|i| f64::from(self.values[self.index(corner(i))]));
        let (mut sum, mut count) = (DVec3::ZERO, 0.0);
        for i in 0..8 {
            for axis in [1, 2, 4] {
                let j = i | axis;
                if j != i && (values[i] < 0.0) != (values[j] < 0.0) {
                    let t = values[i] / (values[i] - values[j]);
                    sum += self.place(corner(i)).lerp(self.place(corner(j)), t);
                    count += 1.0;
                }
            }
        }
        (count > 0.0).then(|| sum / count)
    }
}

/// The places `first + i * step` for every i below `counts`, x fastest.
fn steps(first: [usize; 3], counts: [usize; 3], step: usize) -> impl Iterator<Item = [usize; 3]> {
    let [nx, ny, nz] = counts;
    (0..nx * ny * nz)
        .map(move |i| [first[0] + i % nx * step, first[1] + i / nx % ny * step, first[2] + i / nx / ny * step])
}
