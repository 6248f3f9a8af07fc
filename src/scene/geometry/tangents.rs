//! Tangents as MikkTSpace makes them (Mikkelsen 2008), because a normal map is right only in the
//! frame that it was baked for. The arithmetic is the reference's own, in f32 and in its order, so
//! that the tangents are the same to the bit.
//!
//! Corners of equal position, normal and UV are one vertex. Around it triangles are in one *group*
//! when one gets from one to the other over shared edges without the UVs being mirrored; triangles
//! whose UVs span no area join any group. A group's tangent is the sum of its triangles' directions
//! of growing u, each laid into the vertex's plane and weighted by the angle there. The reference
//! leaves out directions that are exactly opposite to the corner's own.
//!
//! Unlike the reference this takes no recursion and no quadratic time, whatever the mesh: the
//! triangles of a non-manifold edge are paired in one sweep, and around a point of more than
//! [`MAX_COMPARED`] triangles opposite directions stay in.

use std::ops::Range;

use glam::{DVec3, Vec3};

use super::map::{MeshMap, bits, first_equal, vertex_ranges};
use super::soup::NONE;
use super::vertices::Vertices;

/// Greatest size of a group in which opposite directions are looked for, in triangles.
const MAX_COMPARED: usize = 512;

/// Least cosine between directions and their mean at which no two of them are opposite, however
/// they are rounded.
const SAME_SIDE: f32 = 0.01;

/// Tangents made for the vertices of a mesh.
#[derive(Debug, Default)]
pub(super) struct MadeTangents {
    /// Tangents of the vertices: `xyz` of unit length, `w` 1 or, where UVs are mirrored, -1; `w` is
    /// 0 where none was made. Empty where none was made at all.
    pub(super) tangents: Vec<[f32; 4]>,
    /// Further vertices, numbered after the others.
    pub(super) copies: Vec<VertexCopy>,
}

/// Vertex that differs from another in its tangent alone.
#[derive(Clone, Copy, Debug)]
pub(super) struct VertexCopy {
    /// The other vertex, which is no copy.
    pub(super) of: u32,
    pub(super) tangent: [f32; 4],
}

/// Makes the tangents of all triangles that have UVs and lack tangents of their own. Corners at one
/// vertex that get different tangents are parted: `triangles` then name the copies. No triangle has
/// two corners at one position.
pub(super) fn make(vertices: &Vertices, triangles: &mut [[u32; 3]]) -> MadeTangents {
    let lacks = |corners: &[u32; 3]| {
        corners.iter().all(|&v| vertices.has_uv(v))
            && !corners.iter().all(|&v| vertices.has_tangent(v))
    };
    if !triangles.iter().any(lacks) {
        return MadeTangents::default();
    }
    let count = vertices.positions.len();
    let first = first_equal(count, |vertex| {
        let uv = vertices.has_uv(vertex as u32).then(|| bits(vertices.uvs[vertex]));
        (bits(vertices.positions[vertex]), bits(vertices.normals[vertex]), uv)
    });
    let mut space = TangentSpace {
        vertices,
        first,
        faces: Vec::new(),
        triangles,
        made: MadeTangents { tangents: vec![[0.0; 4]; count], copies: Vec::new() },
        copies: MeshMap::default(),
    };
    space.faces =
        space.triangles.iter().map(|t| if lacks(t) { space.face(t) } else { Face::NONE }).collect();
    space.visit_all();
    space.made
}

/// A vector scaled to length 1, or unchanged if it is 0 by the reference's test.
fn unit(v: Vec3) -> Vec3 {
    let is_zero = |x: f32| x.abs() <= f32::MIN_POSITIVE;
    if is_zero(v.x) && is_zero(v.y) && is_zero(v.z) { v } else { v * length(v).recip() }
}

fn length(v: Vec3) -> f32 {
    dot(v, v).sqrt()
}

/// The dot product, summed in the reference's order, which no vector instruction changes.
fn dot(a: Vec3, b: Vec3) -> f32 {
    a.x * b.x + a.y * b.y + a.z * b.z
}

/// The part of a vector in the plane of a normal, scaled to length 1.
fn laid_into_plane(v: Vec3, normal: Vec3) -> Vec3 {
    unit(v - normal * dot(normal, v))
}

/// A triangle's part in groups. Its directions are computed when they are asked for: those of all
/// triangles of a scan would take more memory than its file.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Face(u8);

impl Face {
    /// A triangle that gets no tangents.
    const NONE: Self = Self(0);
    /// Set on triangles that get tangents.
    const TAKES_PART: u8 = 1;
    /// Set where the UVs run the same way round as the triangle does.
    const IS_PRESERVING: u8 = 2;
    /// Set where the UVs determine so little that the triangle takes the direction of its
    /// neighbors.
    const JOINS_ANY: u8 = 4;
    /// Set once one of the triangle's corners has a group.
    const HAS_GROUP: u8 = 8;

    fn is(self, flag: u8) -> bool {
        self.0 & flag != 0
    }

    fn set(&mut self, flag: u8, value: bool) {
        self.0 = if value { self.0 | flag } else { self.0 & !flag };
    }
}

/// A triangle's directions of growing UVs.
struct FaceDirections {
    /// Directions of growing u and v; 0 where the UVs span no area.
    along_u: Vec3,
    along_v: Vec3,
    is_preserving: bool,
    joins_any: bool,
}

impl FaceDirections {
    /// Directions of a triangle of these vertices.
    fn new(vertices: &Vertices, corners: [u32; 3]) -> Self {
        let at = corners.map(|v| Vec3::from(vertices.positions[v as usize]));
        let uv = corners.map(|v| vertices.uvs[v as usize]);
        let (edge1, edge2) = (at[1] - at[0], at[2] - at[0]);
        let [[u1, v1], [u2, v2]] = [1, 2].map(|k| [0, 1].map(|i| uv[k][i] - uv[0][i]));
        let area = u1 * v2 - v1 * u2;
        let (along_u, along_v) = (edge1 * v2 - edge2 * v1, edge1 * -u2 + edge2 * u1);
        let mut face = Self {
            along_u: Vec3::ZERO,
            along_v: Vec3::ZERO,
            is_preserving: area > 0.0,
            joins_any: true,
        };
        if area.abs() > f32::MIN_POSITIVE {
            let sign = if face.is_preserving { 1.0 } else { -1.0 };
            face.along_u = unit(along_u) * sign;
            face.along_v = unit(along_v) * sign;
            let sizes = [along_u, along_v].map(|v| length(v) / area.abs());
            face.joins_any = !sizes.iter().all(|size| size.abs() > f32::MIN_POSITIVE);
        }
        face
    }
}

/// The corners at some vertices, with their neighbors.
#[derive(Default)]
struct Corners {
    /// Corners, each three times its triangle's index and the number of the corner in it, by their
    /// vertices, and of one vertex in ascending order.
    corners: Vec<u32>,
    /// Neighbors of each corner, as indices into `corners`, over the edges to the triangle's next
    /// corner and from the one before; [`NONE`] where there are none.
    neighbors: Vec<[u32; 2]>,
}

impl Corners {
    /// Pairs the edges at a vertex, whose corners are `range` of the list. Of several triangles at
    /// one edge, those that run along it in opposite directions are paired in their order. `ends`
    /// gives the vertices to which the two edges of a corner lead.
    fn pair(
        &mut self,
        range: Range<usize>,
        ends: impl Fn(u32) -> [u32; 2],
        edges: &mut Vec<EdgeEnd>,
    ) {
        edges.clear();
        for at in range {
            let corner = self.corners[at];
            let (triangle, k) = (corner / 3, corner % 3);
            for (side, (end, first)) in ends(corner).into_iter().zip([k, (k + 2) % 3]).enumerate() {
                edges.push(EdgeEnd { end, edge: 3 * triangle + first, at: at as u32, side });
            }
        }
        edges.sort_unstable_by_key(|edge| (edge.end, edge.edge));
        // Edges that wait for a partner of the other direction: all of them run the same way.
        let mut waiting: Vec<EdgeEnd> = Vec::new();
        for run in edges.chunk_by(|a, b| a.end == b.end) {
            let mut first_waiting = 0;
            waiting.clear();
            for edge in run {
                match waiting.get(first_waiting) {
                    Some(other) if other.side != edge.side => {
                        self.neighbors[edge.at as usize][edge.side] = other.at;
                        self.neighbors[other.at as usize][other.side] = edge.at;
                        first_waiting += 1;
                    }
                    _ => waiting.push(*edge),
                }
            }
        }
    }
}

/// One of the two edges at a corner.
#[derive(Clone, Copy)]
struct EdgeEnd {
    /// Vertex at the edge's other end.
    end: u32,
    /// The corner that the edge begins at.
    edge: u32,
    /// Index of the corner in the list of corners.
    at: u32,
    /// 0 for the edge that leaves the corner, 1 for the one that comes to it.
    side: usize,
}

/// A triangle's share in a group.
struct Member {
    corner: u32,
    /// Direction of growing u, weighted by the corner's angle; 0 for triangles that join any group.
    weighted: Vec3,
    /// Directions of growing u and v in the vertex's plane.
    along: [Vec3; 2],
    joins_any: bool,
}

struct TangentSpace<'a> {
    vertices: &'a Vertices,
    /// The first vertex of equal position, normal and UV, of each vertex.
    first: Vec<u32>,
    faces: Vec<Face>,
    triangles: &'a mut [[u32; 3]],
    made: MadeTangents,
    /// Numbers of the copies, by their vertices and tangents.
    copies: MeshMap<(u32, [u32; 4]), u32>,
}

impl TangentSpace<'_> {
    /// Vertices of a triangle, where copies are what they are copies of.
    fn corners(&self, triangle: usize) -> [u32; 3] {
        let count = self.vertices.positions.len();
        self.triangles[triangle].map(|vertex| match (vertex as usize).checked_sub(count) {
            Some(copy) => self.made.copies[copy].of,
            None => vertex,
        })
    }

    fn face(&self, corners: &[u32; 3]) -> Face {
        let directions = FaceDirections::new(self.vertices, *corners);
        let mut face = Face(Face::TAKES_PART);
        face.set(Face::IS_PRESERVING, directions.is_preserving);
        face.set(Face::JOINS_ANY, directions.joins_any);
        face
    }

    /// Makes the tangents at all vertices. What a group gives depends on others only by triangles
    /// that join any of them, so the vertices of those come first, together, and all others a few
    /// at a time.
    fn visit_all(&mut self) {
        let count = self.first.len();
        let mut is_loose = Vec::new();
        if self.faces.iter().any(|face| face.is(Face::JOINS_ANY)) {
            is_loose = vec![false; count];
            for (triangle, face) in self.faces.iter().enumerate() {
                if face.is(Face::JOINS_ANY) {
                    self.triangles[triangle]
                        .iter()
                        .for_each(|&v| is_loose[self.first[v as usize] as usize] = true);
                }
            }
            self.visit(0..count as u32, |vertex| is_loose[vertex as usize]);
        }
        for range in vertex_ranges(count, 3 * self.triangles.len()) {
            let is_bound = |vertex: u32| is_loose.get(vertex as usize) != Some(&true);
            self.visit(range, is_bound);
        }
    }

    /// Finds the groups at those of a range's vertices that are `chosen`, one after another in the
    /// order of their corners, and gives each of their corners its tangent.
    fn visit(&mut self, range: Range<u32>, chosen: impl Fn(u32) -> bool) {
        let (corners, order) = self.corners_of(range, chosen);
        let mut has_group = vec![false; corners.corners.len()];
        let mut group: Vec<u32> = Vec::new();
        let mut open: Vec<u32> = Vec::new();
        for start in order {
            let face = self.faces[corners.corners[start as usize] as usize / 3];
            if face.is(Face::JOINS_ANY) || has_group[start as usize] {
                continue;
            }
            group.clear();
            open.push(start);
            while let Some(at) = open.pop() {
                let corner = corners.corners[at as usize];
                let own = &mut self.faces[corner as usize / 3];
                if has_group[at as usize] {
                    continue;
                }
                if own.is(Face::JOINS_ANY) && !own.is(Face::HAS_GROUP) {
                    own.set(Face::IS_PRESERVING, face.is(Face::IS_PRESERVING));
                }
                if own.is(Face::IS_PRESERVING) != face.is(Face::IS_PRESERVING) {
                    continue;
                }
                own.set(Face::HAS_GROUP, true);
                has_group[at as usize] = true;
                group.push(corner);
                open.extend(corners.neighbors[at as usize].iter().filter(|next| **next != NONE));
            }
            group.sort_unstable();
            self.give_tangents(&group, face.is(Face::IS_PRESERVING));
        }
    }

    /// The corners at those of a range's vertices that are `chosen`, and their indices by the
    /// corners' order.
    fn corners_of(&self, range: Range<u32>, chosen: impl Fn(u32) -> bool) -> (Corners, Vec<u32>) {
        let place = |vertex: u32| {
            let first = self.first[vertex as usize];
            (range.contains(&first) && chosen(first)).then(|| (first - range.start) as usize)
        };
        let taking_part = || {
            let faces = self.faces.iter().enumerate();
            faces.filter(|(_, face)| face.is(Face::TAKES_PART)).map(|(triangle, _)| triangle)
        };
        let mut starts = vec![0_u32; range.len() + 1];
        for triangle in taking_part() {
            for place in self.corners(triangle).into_iter().filter_map(place) {
                starts[place + 1] += 1;
            }
        }
        for vertex in 0..range.len() {
            starts[vertex + 1] += starts[vertex];
        }
        let count = starts[range.len()] as usize;
        let mut found = Corners { corners: vec![0; count], neighbors: vec![[NONE; 2]; count] };
        let mut order = Vec::with_capacity(count);
        for triangle in taking_part() {
            for (k, vertex) in self.corners(triangle).into_iter().enumerate() {
                let Some(place) = place(vertex) else { continue };
                found.corners[starts[place] as usize] = (3 * triangle + k) as u32;
                order.push(starts[place]);
                starts[place] += 1;
            }
        }
        let ends = |corner: u32| {
            let (corners, k) = (self.corners(corner as usize / 3), corner as usize % 3);
            [1, 2].map(|next| self.first[corners[(k + next) % 3] as usize])
        };
        let mut edges = Vec::new();
        let mut start = 0;
        // Each start is now where the next vertex's corners start.
        for &end in &starts[..range.len()] {
            found.pair(start..end as usize, ends, &mut edges);
            start = end as usize;
        }
        (found, order)
    }

    /// Gives the tangents of a group's corners.
    fn give_tangents(&mut self, group: &[u32], is_preserving: bool) {
        let normal = self.normal(group[0]);
        let members: Vec<Member> =
            group.iter().map(|&corner| self.member(corner, normal)).collect();
        let sign = if is_preserving { 1.0 } else { -1.0 };
        let mut give_sum = |corner: u32, sum: Vec3| {
            if let Some(tangent) = upright(unit(sum), normal) {
                self.give(corner, tangent.extend(sign).to_array());
            }
        };
        if members.len() > MAX_COMPARED || are_on_one_side(&members) {
            let sum = members.iter().fold(Vec3::ZERO, |sum, member| sum + member.weighted);
            group.iter().for_each(|&corner| give_sum(corner, sum));
            return;
        }
        for own in &members {
            let agrees = |other: &&Member| {
                let is_not_opposite = || (0..2).all(|i| dot(own.along[i], other.along[i]) > -1.0);
                own.joins_any || other.joins_any || own.corner == other.corner || is_not_opposite()
            };
            let sum =
                members.iter().filter(agrees).fold(Vec3::ZERO, |sum, member| sum + member.weighted);
            give_sum(own.corner, sum);
        }
    }

    /// Gives a corner its tangent, and another vertex if its own has another tangent.
    fn give(&mut self, corner: u32, tangent: [f32; 4]) {
        let (triangle, k) = (corner as usize / 3, corner as usize % 3);
        let vertex = self.triangles[triangle][k];
        if self.vertices.has_tangent(vertex) {
            return;
        }
        let own = &mut self.made.tangents[vertex as usize];
        if own[3] == 0.0 {
            *own = tangent;
        }
        let bits = tangent.map(f32::to_bits);
        if own.map(f32::to_bits) == bits {
            return;
        }
        let copies = &mut self.made.copies;
        let copy = self.copies.entry((vertex, bits)).or_insert_with(|| {
            copies.push(VertexCopy { of: vertex, tangent });
            copies.len() as u32 - 1
        });
        self.triangles[triangle][k] = self.vertices.positions.len() as u32 + *copy;
    }

    fn normal(&self, corner: u32) -> Vec3 {
        let vertex = self.corners(corner as usize / 3)[corner as usize % 3];
        Vec3::from(self.vertices.normals[vertex as usize])
    }

    fn member(&self, corner: u32, normal: Vec3) -> Member {
        let triangle = corner as usize / 3;
        let corners = self.corners(triangle);
        let directions = FaceDirections::new(self.vertices, corners);
        let along = [directions.along_u, directions.along_v].map(|v| laid_into_plane(v, normal));
        let mut weighted = Vec3::ZERO;
        if !directions.joins_any {
            let [own, after, before] = [0, 1, 2].map(|next| {
                let vertex = corners[(corner as usize + next) % 3];
                Vec3::from(self.vertices.positions[vertex as usize])
            });
            let [after, before] = [after, before].map(|at| laid_into_plane(at - own, normal));
            let cosine = dot(after, before).clamp(-1.0, 1.0);
            // The arc cosine is that of f64, as in the reference.
            weighted = along[0] * f64::from(cosine).acos() as f32;
        }
        Member { corner, weighted, along, joins_any: directions.joins_any }
    }
}

/// True if no two of a group's directions are opposite to each other.
fn are_on_one_side(members: &[Member]) -> bool {
    (0..2).all(|i| {
        let counted = || members.iter().filter(|member| !member.joins_any);
        let mean = unit(counted().fold(Vec3::ZERO, |sum, member| sum + member.along[i]));
        counted().all(|member| dot(member.along[i], mean) > SAME_SIDE)
    })
}

/// The tangent made orthogonal to the normal, unchanged where it is so already; `None` where
/// rounding or the UVs leave no tangent.
fn upright(tangent: Vec3, normal: Vec3) -> Option<Vec3> {
    if !tangent.is_finite() || (dot(tangent, tangent) - 1.0).abs() > 1e-3 {
        return None;
    }
    if dot(tangent, normal).abs() <= 1e-6 {
        return Some(tangent);
    }
    let (tangent, normal) = (tangent.as_dvec3(), normal.as_dvec3());
    tangent.reject_from(normal).try_normalize().map(|tangent| tangent.as_vec3())
}

/// The unit tangent nearest to `wish` that is orthogonal to `normal`, or the level tangent where
/// `wish` is along the normal.
pub(super) fn orthogonal(normal: Vec3, wish: Vec3, w: f32) -> [f32; 4] {
    let (n, wish) = (normal.as_dvec3(), wish.as_dvec3().normalize_or_zero());
    let tangent = wish.reject_from(n);
    let tangent = if tangent.length_squared() > 1e-12 { tangent.normalize() } else { level(n) };
    tangent.as_vec3().extend(w).to_array()
}

/// The level tangent of a normal: the unit vector orthogonal to the normal and to y up, to the
/// right of one who looks at the surface; along x where the normal is y.
fn level(normal: DVec3) -> DVec3 {
    let right = DVec3::Y.cross(normal);
    if right.length_squared() > 1e-10 {
        right.normalize()
    } else {
        DVec3::X.reject_from(normal).normalize()
    }
}
