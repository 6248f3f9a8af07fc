//! Surface that a pose deforms: points as the file has them, and the vertices made of them.
//!
//! Positions, and the normals and tangents of the file, follow morphs and then the matrix of their
//! node, or the weighted sum of their joints' matrices (linear blend skinning, as glTF asks for).
//! Normals that were made are made anew, of the same triangles: those at a vertex and at all that
//! shared its place and normal at rest. Tangents that were made, of UVs or level ones, go along
//! with the triangles around their vertex, as lines drawn on them would.

use glam::{DMat3, DMat4, DVec3, Vec3};
use rayon::prelude::*;

use super::super::map::{bits, first_equal};
use super::super::mesh::Mesh;
use super::super::normals::{corner_angle, place};
use super::super::soup::NONE;
use super::super::tangents::orthogonal;
use super::{Motion, MovedPart, Pose};
use crate::geometry::import::FARTHEST;

/// Number of points, or of groups of corners, that are computed in one go.
const BATCH: usize = 1024;

/// Points of a file's primitives in all their places, in the spaces of their meshes.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::geometry) struct MovedPoints {
    pub(in crate::geometry) positions: Vec<[f32; 3]>,
    /// Normals; 0 where the file has none.
    pub(in crate::geometry) normals: Vec<[f32; 3]>,
    /// Tangents; 0 where the file has none.
    pub(in crate::geometry) tangents: Vec<[f32; 4]>,
    /// First of each point's influences, and the end of the last's.
    pub(in crate::geometry) starts: Vec<u32>,
    /// Joints with their shares, which are 1 together.
    pub(in crate::geometry) influences: Vec<(u16, f32)>,
    /// Targets of morphs, those of each part one after another.
    pub(in crate::geometry) targets: Vec<Vec<PointChange>>,
}

/// Difference that a morph target makes to a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::geometry) struct PointChange {
    pub(in crate::geometry) point: u32,
    pub(in crate::geometry) position: [f32; 3],
    pub(in crate::geometry) normal: [f32; 3],
    pub(in crate::geometry) tangent: [f32; 3],
}

/// Points in a pose, in the space of the file's scene.
#[derive(Clone, Debug, Default)]
pub(in crate::geometry) struct PosedPoints {
    pub(in crate::geometry) positions: Vec<[f32; 3]>,
    /// Normals of unit length, or 0.
    pub(in crate::geometry) normals: Vec<[f32; 3]>,
    /// Tangents of unit length and with their sides, or 0.
    pub(in crate::geometry) tangents: Vec<[f32; 4]>,
}

impl MovedPoints {
    /// The points of a part in a pose.
    pub(in crate::geometry) fn posed(&self, part: &MovedPart, pose: &Pose) -> PosedPoints {
        let range = part.points.start as usize..part.points.end as usize;
        let changes = self.changes(part, pose);
        let mut posed = PosedPoints {
            positions: vec![[0.0; 3]; range.len()],
            normals: vec![[0.0; 3]; range.len()],
            tangents: vec![[0.0; 4]; range.len()],
        };
        let rigid = pose.node(part.node) * part.instance;
        let joints = part.skin.and_then(|skin| pose.skins.get(skin as usize));
        let chunks = posed.positions.par_chunks_mut(BATCH);
        let chunks = chunks.zip(posed.normals.par_chunks_mut(BATCH));
        let chunks = chunks.zip(posed.tangents.par_chunks_mut(BATCH));
        chunks.enumerate().for_each(|(batch, ((positions, normals), tangents))| {
            // Points next to each other mostly have one matrix, whose cofactors are kept.
            let mut known = PointMatrix::new(rigid);
            for (offset, ((position, normal), tangent)) in
                positions.iter_mut().zip(normals).zip(tangents).enumerate()
            {
                let number = batch * BATCH + offset;
                let point = range.start + number;
                let matrix = joints.and_then(|joints| self.skinned(point, joints));
                let matrix = matrix.unwrap_or(rigid);
                if matrix != known.matrix {
                    known = PointMatrix::new(matrix);
                }
                let change = changes.get(number).copied().unwrap_or_default();
                let sum = |own: [f32; 3], change: DVec3| DVec3::from(own.map(f64::from)) + change;
                let place = sum(self.positions[point], change[0]);
                *position = known.matrix.transform_point3(place).as_vec3().to_array();
                let own = sum(self.normals[point], change[1]);
                *normal = (known.cofactors * own).normalize_or_zero().as_vec3().to_array();
                let [x, y, z, side] = self.tangents[point];
                if side != 0.0 {
                    let own = (known.linear * sum([x, y, z], change[2])).normalize_or_zero();
                    *tangent = own.as_vec3().extend(side * known.side).to_array();
                }
            }
        });
        posed
    }

    /// The transform of a part's first point, from its mesh's space to the scene's.
    pub(in crate::geometry) fn first_matrix(&self, part: &MovedPart, pose: &Pose) -> DMat4 {
        let joints = part.skin.and_then(|skin| pose.skins.get(skin as usize));
        let skinned = joints.and_then(|joints| self.skinned(part.points.start as usize, joints));
        skinned.unwrap_or_else(|| pose.node(part.node) * part.instance)
    }

    /// The matrix of a point with influences.
    fn skinned(&self, point: usize, joints: &[DMat4]) -> Option<DMat4> {
        let [start, end] = [self.starts.get(point)?, self.starts.get(point + 1)?];
        let influences = &self.influences[*start as usize..*end as usize];
        let of = |(joint, share): &(u16, f32)| {
            joints.get(*joint as usize).map(|joint| *joint * f64::from(*share))
        };
        influences.iter().filter_map(of).reduce(|sum, part| sum + part)
    }

    /// Changes of position, normal and tangent of a part's points by its morphs; empty where there
    /// are none.
    fn changes(&self, part: &MovedPart, pose: &Pose) -> Vec<[DVec3; 3]> {
        let weights = pose.weights.get(part.node as usize).map_or(&[][..], Vec::as_slice);
        let targets = &self.targets[part.targets.start as usize..part.targets.end as usize];
        let active = || targets.iter().zip(weights).filter(|(_, weight)| **weight != 0.0);
        if active().next().is_none() {
            return Vec::new();
        }
        let mut sums = vec![[DVec3::ZERO; 3]; part.points.len()];
        for (target, weight) in active() {
            for PointChange { point, position, normal, tangent } in target {
                let sum = &mut sums[(*point - part.points.start) as usize];
                for (sum, change) in sum.iter_mut().zip([position, normal, tangent]) {
                    *sum += *weight * DVec3::from(change.map(f64::from));
                }
            }
        }
        sums
    }
}

/// Matrix of a point with what turns normals and tangents.
struct PointMatrix {
    matrix: DMat4,
    linear: DMat3,
    /// Cofactors turn normals rightly under any scale, even where one axis is flattened.
    cofactors: DMat3,
    /// -1 where the matrix mirrors.
    side: f32,
}

impl PointMatrix {
    fn new(matrix: DMat4) -> Self {
        let linear = DMat3::from_mat4(matrix);
        let sign = linear.determinant().signum();
        let cofactors = DMat3::from_cols(
            linear.y_axis.cross(linear.z_axis),
            linear.z_axis.cross(linear.x_axis),
            linear.x_axis.cross(linear.y_axis),
        ) * sign;
        Self { matrix, linear, cofactors, side: sign as f32 }
    }
}

/// Point that a vertex is made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::geometry) struct VertexSource {
    pub(in crate::geometry) point: u32,
    /// True if the vertex's normal was made.
    pub(in crate::geometry) has_made_normal: bool,
}

/// Vertices of a mesh by what they are made of.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::geometry) struct VertexSources {
    points: Vec<u32>,
    /// Vertices that share a made normal, with the corners that it is made of.
    normals: CornerGroups,
    /// Vertices that share a made tangent, with the corners that it goes along with.
    tangents: CornerGroups,
}

impl VertexSources {
    /// The sources of a mesh's vertices at rest; `file_tangents` are the points' own.
    pub(in crate::geometry) fn new(
        mesh: &Mesh,
        sources: &[VertexSource],
        file_tangents: &[[f32; 4]],
    ) -> Self {
        let count = mesh.positions.len();
        let at = |v: usize| (bits(mesh.positions[v]), bits(mesh.normals[v]));
        let of_normals = first_equal(count, at);
        let of_tangents =
            first_equal(count, |v| (at(v), bits(mesh.uvs[v]), bits(mesh.tangents[v])));
        let is_made = |v: usize| sources.get(v).is_some_and(|source| source.has_made_normal);
        let has_own = |v: usize| {
            let point = sources.get(v).map_or(NONE, |source| source.point);
            file_tangents.get(point as usize).is_some_and(|tangent| tangent[3] != 0.0)
        };
        Self {
            points: sources.iter().map(|source| source.point).collect(),
            normals: CornerGroups::new(&mesh.indices, &of_normals, is_made),
            tangents: CornerGroups::new(&mesh.indices, &of_tangents, |v| !has_own(v)),
        }
    }
}

/// Groups of vertices with the corners of triangles at them.
#[derive(Clone, Debug, Default, PartialEq)]
struct CornerGroups {
    /// Group of each vertex; [`NONE`] where it is in none.
    of_vertices: Vec<u32>,
    /// First corner of each group, and the end of the last's.
    starts: Vec<u32>,
    /// Corners: three times the number of the triangle, and the number of the corner in it.
    corners: Vec<u32>,
}

impl CornerGroups {
    /// Groups of those vertices that are `chosen`, by the first vertex of each group.
    fn new(indices: &[u32], firsts: &[u32], chosen: impl Fn(usize) -> bool) -> Self {
        let mut of_vertices = vec![NONE; firsts.len()];
        let mut groups = 0;
        for vertex in (0..firsts.len()).filter(|vertex| chosen(*vertex)) {
            let first = firsts[vertex] as usize;
            // The first vertex of a group may itself not be chosen.
            if of_vertices[first] == NONE {
                of_vertices[first] = groups;
                groups += 1;
            }
            of_vertices[vertex] = of_vertices[first];
        }
        let mut starts = vec![0_u32; groups as usize + 1];
        let group = |index: &u32| {
            let group = of_vertices[*index as usize];
            (group != NONE).then_some(group as usize)
        };
        indices.iter().filter_map(group).for_each(|group| starts[group + 1] += 1);
        for group in 0..groups as usize {
            starts[group + 1] += starts[group];
        }
        let mut next = starts.clone();
        let mut corners = vec![0_u32; starts.last().map_or(0, |end| *end as usize)];
        for (corner, index) in (0_u32..).zip(indices) {
            if let Some(group) = group(index) {
                corners[next[group] as usize] = corner;
                next[group] += 1;
            }
        }
        Self { of_vertices, starts, corners }
    }

    /// A vector for each group, of its corners.
    fn vectors(&self, make: impl Fn(&[u32]) -> DVec3 + Sync) -> Vec<DVec3> {
        let ranges = self.starts.par_windows(2).with_min_len(BATCH);
        ranges.map(|ends| make(&self.corners[ends[0] as usize..ends[1] as usize])).collect()
    }

    fn of<'v>(&self, vectors: &'v [DVec3], vertex: usize) -> Option<&'v DVec3> {
        vectors.get(*self.of_vertices.get(vertex)? as usize)
    }
}

/// Vertices of the triangle at a corner, from the corner's own on.
fn triangle_at(indices: &[u32], corner: u32) -> [u32; 3] {
    let (start, k) = (corner as usize / 3 * 3, corner as usize % 3);
    [0, 1, 2].map(|next| indices[start + (k + next) % 3])
}

/// The direction in which a line on a triangle at rest goes when the triangle is deformed.
fn carried(line: DVec3, rest: [DVec3; 3], posed: [DVec3; 3]) -> DVec3 {
    let [a, b] = [rest[1] - rest[0], rest[2] - rest[0]];
    let (aa, ab, bb) = (a.dot(a), a.dot(b), b.dot(b));
    let area = aa * bb - ab * ab;
    if area <= 1e-24 * aa * bb {
        return DVec3::ZERO;
    }
    let (along_a, along_b) = (line.dot(a), line.dot(b));
    let [u, v] = [along_a * bb - along_b * ab, along_b * aa - along_a * ab].map(|x| x / area);
    u * (posed[1] - posed[0]) + v * (posed[2] - posed[0])
}

impl Mesh {
    /// The mesh at rest deformed by a pose of its [motion](Motion); the mesh itself where it has
    /// none.
    #[must_use]
    pub fn posed(&self, pose: &Pose) -> Self {
        let Some(motion) = self.motion.as_deref() else { return self.clone() };
        let sources = &motion.sources;
        let points = motion.posed_points(pose);
        let mut positions = self.positions.clone();
        for (position, &point) in positions.iter_mut().zip(&sources.points) {
            let new = points.positions[point as usize];
            // What a pose throws beyond all bounds stays where it was.
            if new.iter().all(|x| x.is_finite()) {
                *position = new.map(|x| x.clamp(-FARTHEST, FARTHEST));
            }
        }
        let indices = &self.indices;
        let made = sources.normals.vectors(|corners| {
            let sum = corners.iter().fold(DVec3::ZERO, |sum, &corner| {
                let [a, b, c] = triangle_at(indices, corner).map(|v| place(&positions, v));
                sum + (b - a).cross(c - a).normalize_or_zero() * corner_angle(a, b, c)
            });
            sum.normalize_or_zero()
        });
        let mut normals = self.normals.clone();
        for (vertex, normal) in normals.iter_mut().enumerate() {
            let new = match sources.normals.of(&made, vertex) {
                Some(made) => made.as_vec3().to_array(),
                None => points.normals[sources.points[vertex] as usize],
            };
            if new != [0.0; 3] && new.iter().all(|x| x.is_finite()) {
                *normal = new;
            }
        }
        let carried = sources.tangents.vectors(|corners| {
            corners.iter().fold(DVec3::ZERO, |sum, &corner| {
                let triangle = triangle_at(indices, corner);
                let [x, y, z, _] = self.tangents[triangle[0] as usize];
                let line = Vec3::new(x, y, z).as_dvec3();
                let rest = triangle.map(|v| place(&self.positions, v));
                sum + carried(line, rest, triangle.map(|v| place(&positions, v)))
            })
        });
        let mut tangents = self.tangents.clone();
        for (vertex, tangent) in tangents.iter_mut().enumerate() {
            let (wish, side) = match sources.tangents.of(&carried, vertex) {
                Some(carried) => (carried.normalize_or_zero().as_vec3(), tangent[3]),
                None => {
                    let [x, y, z, side] = points.tangents[sources.points[vertex] as usize];
                    (Vec3::new(x, y, z), if side < 0.0 { -1.0 } else { 1.0 })
                }
            };
            let wish = if wish.is_finite() { wish } else { Vec3::ZERO };
            *tangent = orthogonal(Vec3::from(normals[vertex]), wish, side);
        }
        let rest = self.positions.clone();
        Self { positions, normals, tangents, rest, ..self.clone() }
    }
}

impl Motion {
    /// All points in a pose.
    fn posed_points(&self, pose: &Pose) -> PosedPoints {
        let mut all = PosedPoints::default();
        // Parts follow one another without gaps.
        for part in &self.parts {
            let PosedPoints { mut positions, mut normals, mut tangents } =
                self.points.posed(part, pose);
            all.positions.append(&mut positions);
            all.normals.append(&mut normals);
            all.tangents.append(&mut tangents);
        }
        all
    }
}
