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

use glam::{DVec3, Vec3};

use super::map::{MeshMap, with_room};
use super::soup::{Corner, NONE, TriangleSoup};

/// Greatest size of a group in which opposite directions are looked for, in triangles.
const MAX_COMPARED: usize = 512;

/// Least cosine between directions and their mean at which no two of them are opposite, however
/// they are rounded.
const SAME_SIDE: f32 = 0.01;

/// Tangents of a soup's corners.
#[derive(Debug, Default)]
pub(super) struct CornerTangents {
    /// Different tangents, each once: `xyz` of unit length, `w` 1 or, where UVs are mirrored, -1.
    pub(super) tangents: Vec<[f32; 4]>,
    /// Indices into `tangents` of the corners of each triangle of the soup; [`NONE`] where UVs
    /// determine no tangent.
    pub(super) of_corner: Vec<[u32; 3]>,
}

/// Makes the tangents of all triangles that have UVs and lack tangents of their own. `vertex_of`
/// gives equal numbers to corners that are one vertex; no triangle has two corners at one position.
pub(super) fn of_corners(
    soup: &TriangleSoup,
    vertex_of: impl Fn(&Corner) -> [u32; 3],
) -> CornerTangents {
    let lacks = |t: &usize| {
        let corners = &soup.triangles[*t];
        corners.iter().all(|c| c.uv != NONE) && !corners.iter().all(|c| soup.has_tangent(c.point))
    };
    let triangles: Vec<u32> =
        (0..soup.triangles.len()).filter(lacks).map(|triangle| triangle as u32).collect();
    let mut known: MeshMap<[u32; 3], u32> = with_room(triangles.len());
    let vertices: Vec<[u32; 3]> = triangles
        .iter()
        .map(|&t| {
            soup.triangles[t as usize].each_ref().map(|corner| {
                let next = known.len() as u32;
                *known.entry(vertex_of(corner)).or_insert(next)
            })
        })
        .collect();
    drop(known);
    let faces = triangles.iter().map(|&t| FaceDirections::new(soup, t as usize).face()).collect();
    let mut space = TangentSpace { soup, triangles: &triangles, vertices: &vertices, faces };
    let mut result =
        CornerTangents { of_corner: vec![[NONE; 3]; soup.triangles.len()], ..Default::default() };
    let mut known = MeshMap::default();
    space.visit_groups(&neighbors(&vertices), &mut |corner, tangent| {
        let (triangle, k) = (triangles[corner / 3] as usize, corner % 3);
        if soup.has_tangent(soup.triangles[triangle][k].point) {
            return;
        }
        let index = *known.entry(tangent.map(f32::to_bits)).or_insert_with(|| {
            result.tangents.push(tangent);
            result.tangents.len() as u32 - 1
        });
        result.of_corner[triangle][k] = index;
    });
    result
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
#[derive(Clone, Copy)]
struct Face {
    /// True if the UVs run the same way round as the triangle does.
    is_preserving: bool,
    /// True if the UVs determine so little that the triangle takes the direction of its neighbors.
    joins_any: bool,
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
    fn face(&self) -> Face {
        Face { is_preserving: self.is_preserving, joins_any: self.joins_any }
    }

    fn new(soup: &TriangleSoup, triangle: usize) -> Self {
        let corners = &soup.triangles[triangle];
        let at = corners.map(|c| Vec3::from(soup.points[c.point as usize]));
        let uv = corners.map(|c| soup.uvs[c.uv as usize]);
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

/// The neighbor of each corner: the triangle on the other side of the edge from that corner to the
/// next, or [`NONE`]. Of several triangles at one edge, those that run along it in opposite
/// directions are paired in their order.
fn neighbors(vertices: &[[u32; 3]]) -> Vec<u32> {
    let edge = |corner: usize| {
        let (a, b) = (vertices[corner / 3][corner % 3], vertices[corner / 3][(corner + 1) % 3]);
        [a.min(b), a.max(b)]
    };
    let (starts, mut edges) = by_lower_vertex(vertices.len() * 3, edge);
    let mut neighbors = vec![NONE; edges.len()];
    // Corners that wait for a partner of the other direction: all of them run the same way.
    let mut waiting: Vec<u32> = Vec::new();
    for (lower, range) in starts.windows(2).enumerate() {
        let is_upward =
            |corner: u32| vertices[corner as usize / 3][corner as usize % 3] as usize == lower;
        let of_lower = &mut edges[range[0]..range[1]];
        of_lower.sort_unstable();
        for run in of_lower.chunk_by(|a, b| a[0] == b[0]) {
            let mut first_waiting = 0;
            waiting.clear();
            for &[_, corner] in run {
                match waiting.get(first_waiting) {
                    Some(&other) if is_upward(other) != is_upward(corner) => {
                        neighbors[corner as usize] = other / 3;
                        neighbors[other as usize] = corner / 3;
                        first_waiting += 1;
                    }
                    _ => waiting.push(corner),
                }
            }
        }
    }
    neighbors
}

/// The upper vertex and the corner of every edge, by the edges' lower vertices, with the place
/// where the edges of each vertex begin, and the end of the last one's. `edge` gives the lower and
/// the upper vertex of the edge from a corner to the next.
fn by_lower_vertex(
    corners: usize,
    edge: impl Fn(usize) -> [u32; 2],
) -> (Vec<usize>, Vec<[u32; 2]>) {
    let count = (0..corners).map(|corner| edge(corner)[0] as usize + 1).max().unwrap_or_default();
    let mut starts = vec![0; count + 1];
    (0..corners).for_each(|corner| starts[edge(corner)[0] as usize + 1] += 1);
    for vertex in 0..count {
        starts[vertex + 1] += starts[vertex];
    }
    let mut next = starts.clone();
    let mut edges = vec![[0; 2]; corners];
    for corner in 0..corners {
        let [lower, upper] = edge(corner);
        let place = &mut next[lower as usize];
        edges[*place] = [upper, corner as u32];
        *place += 1;
    }
    (starts, edges)
}

/// A triangle's share in a group.
struct Member {
    corner: usize,
    /// Direction of growing u, weighted by the corner's angle; 0 for triangles that join any group.
    weighted: Vec3,
    /// Directions of growing u and v in the vertex's plane.
    along: [Vec3; 2],
    joins_any: bool,
}

/// Receiver of tangents: takes a corner of the triangles that get tangents, and its tangent.
type TangentSink<'g> = &'g mut dyn FnMut(usize, [f32; 4]);

struct TangentSpace<'a> {
    soup: &'a TriangleSoup,
    /// Indices of the soup's triangles that get tangents.
    triangles: &'a [u32],
    vertices: &'a [[u32; 3]],
    faces: Vec<Face>,
}

impl TangentSpace<'_> {
    /// Finds the groups one after another and gives the tangent of each of their corners.
    fn visit_groups(&mut self, neighbors: &[u32], give: TangentSink<'_>) {
        let mut has_group = vec![false; neighbors.len()];
        let mut group: Vec<usize> = Vec::new();
        let mut open: Vec<u32> = Vec::new();
        for start in 0..neighbors.len() {
            let face = self.faces[start / 3];
            if face.joins_any || has_group[start] {
                continue;
            }
            group.clear();
            open.push(start as u32 / 3);
            while let Some(triangle) = open.pop() {
                let triangle = triangle as usize;
                let vertex = self.vertices[start / 3][start % 3];
                let Some(k) = self.vertices[triangle].iter().position(|&v| v == vertex) else {
                    continue;
                };
                let corner = triangle * 3 + k;
                if has_group[corner] {
                    continue;
                }
                let is_free = !has_group[triangle * 3..triangle * 3 + 3].contains(&true);
                let own = &mut self.faces[triangle];
                if own.joins_any && is_free {
                    own.is_preserving = face.is_preserving;
                }
                if own.is_preserving != face.is_preserving {
                    continue;
                }
                has_group[corner] = true;
                group.push(corner);
                open.extend(
                    [(k + 2) % 3, k]
                        .map(|edge| neighbors[triangle * 3 + edge])
                        .iter()
                        .filter(|n| **n != NONE),
                );
            }
            group.sort_unstable();
            self.give_tangents(&group, face.is_preserving, give);
        }
    }

    /// Gives the tangents of a group's corners.
    fn give_tangents(&self, group: &[usize], is_preserving: bool, give: TangentSink<'_>) {
        let normal = self.normal(group[0]);
        let members: Vec<Member> =
            group.iter().map(|&corner| self.member(corner, normal)).collect();
        let sign = if is_preserving { 1.0 } else { -1.0 };
        let mut give_sum = |corner: usize, sum: Vec3| {
            if let Some(tangent) = upright(unit(sum), normal) {
                give(corner, tangent.extend(sign).to_array());
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

    fn normal(&self, corner: usize) -> Vec3 {
        let corner = self.soup.triangles[self.triangles[corner / 3] as usize][corner % 3];
        Vec3::from(self.soup.normals[corner.normal as usize])
    }

    fn member(&self, corner: usize, normal: Vec3) -> Member {
        let face = &self.faces[corner / 3];
        let triangle = self.triangles[corner / 3] as usize;
        let directions = FaceDirections::new(self.soup, triangle);
        let along = [directions.along_u, directions.along_v].map(|v| laid_into_plane(v, normal));
        let mut weighted = Vec3::ZERO;
        if !face.joins_any {
            let corners = &self.soup.triangles[triangle];
            let [own, after, before] = [0, 1, 2].map(|next| {
                let corner = corners[(corner + next) % 3];
                Vec3::from(self.soup.points[corner.point as usize])
            });
            let [after, before] = [after, before].map(|at| laid_into_plane(at - own, normal));
            let cosine = dot(after, before).clamp(-1.0, 1.0);
            // The arc cosine is that of f64, as in the reference.
            weighted = along[0] * f64::from(cosine).acos() as f32;
        }
        Member { corner, weighted, along, joins_any: face.joins_any }
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
