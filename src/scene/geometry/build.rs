//! Turns a `TriangleSoup` as read from a file into a `Mesh` as a renderer draws it.

use glam::{DVec3, Vec3};

use super::closed::is_solid;
use super::map::{MeshMap, with_room};
use super::mesh::{Mesh, MeshPart};
use super::normals::{make_missing, place, weld};
use super::soup::{Corner, NONE, TriangleSoup};
use super::tangents::{self, CornerTangents};
use crate::library::MAX_COORDINATE;

/// Counts of what was dropped and made while a mesh was built, for the notes of its reader.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct BuildNotes {
    /// Number of triangles without area, which were dropped.
    pub degenerate: usize,
    /// Number of corners that had no normal and were given one.
    pub normals: usize,
}

/// Builds the mesh: drops triangles without area, makes normals, joins corners, makes tangents,
/// sorts by material. The mesh has no triangles where all of them are degenerate.
pub(super) fn build(mut soup: TriangleSoup, crease_angle: f64) -> (Mesh, BuildNotes) {
    clamp_attributes(&mut soup);
    let welded = weld(&soup.points);
    let degenerate = drop_degenerate(&mut soup, &welded);
    let normals = make_missing(&mut soup, &welded, crease_angle);
    soup.normals.iter_mut().for_each(|n| *n = normalize(*n));

    let mut joiner = Joiner::new(&soup);
    let made = tangents::of_corners(&soup, |corner| {
        let [normal, uv] = joiner.same_normal_and_uv(corner);
        [welded[corner.point as usize], normal, uv]
    });
    let order = by_material(&soup);
    joiner.join(&order, &made);
    let (vertices, indices) = joiner.into_lists();
    let mut mesh = gather(&soup, &vertices);
    mesh.tangents = vertex_tangents(&soup, &vertices, &made);
    mesh.has_normals = normals == 0;
    drop((vertices, made));
    settle_sides(&mut soup, &welded);
    mesh.indices.reserve_exact(3 * order.len());
    for &t in &order {
        extend_parts(&mut mesh, &soup, t as usize);
        mesh.indices.extend(indices[t as usize]);
    }
    (mesh, BuildNotes { degenerate, normals })
}

/// Clamps texture coordinates and colors to what shaders are promised, so that no fragment asks
/// again.
fn clamp_attributes(soup: &mut TriangleSoup) {
    let most = MAX_COORDINATE as f32;
    let numbers = soup.uvs.iter_mut().flatten().chain(soup.colors.iter_mut().flatten());
    numbers.for_each(|x| *x = x.clamp(-most, most));
}

/// Scales a vector to unit length in f64, so that tiny and huge normals survive; 0 stays 0.
fn normalize(v: [f32; 3]) -> [f32; 3] {
    DVec3::from(v.map(f64::from)).normalize_or_zero().as_vec3().into()
}

/// Drops triangles of two equal points, or so thin that their normal is noise; returns their
/// number.
fn drop_degenerate(soup: &mut TriangleSoup, welded: &[u32]) -> usize {
    let keep: Vec<bool> = soup
        .triangles
        .iter()
        .map(|t| {
            let [a, b, c] = t.map(|corner| welded[corner.point as usize]);
            let [pa, pb, pc] = [a, b, c].map(|p| place(&soup.points, p));
            let longest =
                pa.distance_squared(pb).max(pb.distance_squared(pc)).max(pc.distance_squared(pa));
            a != b && b != c && c != a && (pb - pa).cross(pc - pa).length() > 1e-12 * longest
        })
        .collect();
    let mut flags = keep.iter();
    soup.triangles.retain(|_| *flags.next().unwrap_or(&true));
    let mut flags = keep.iter();
    soup.material_of.retain(|_| *flags.next().unwrap_or(&true));
    keep.len() - soup.triangles.len()
}

/// Settles the sides of materials that leave them open: of a solid only the outside is drawn,
/// because at its outlines a GPU may take a sliver for a back face and would light it from the
/// wrong side.
fn settle_sides(soup: &mut TriangleSoup, welded: &[u32]) {
    if soup.materials.iter().all(|material| material.two_sided.is_some()) {
        return;
    }
    let triangles: Vec<[u32; 3]> = soup
        .triangles
        .iter()
        .map(|corners| corners.map(|corner| welded[corner.point as usize]))
        .collect();
    let is_solid = is_solid(&triangles, |point| place(&soup.points, point));
    soup.materials
        .iter_mut()
        .for_each(|material| material.two_sided = material.two_sided.or(Some(!is_solid)));
}

/// The soup's triangles in the order of their materials' first use, otherwise as in the file.
fn by_material(soup: &TriangleSoup) -> Vec<u32> {
    let mut rank = vec![NONE; soup.materials.len()];
    let mut next = 0;
    for &material in &soup.material_of {
        if rank[material as usize] == NONE {
            rank[material as usize] = next;
            next += 1;
        }
    }
    let mut order: Vec<u32> = (0..soup.triangles.len() as u32).collect();
    order.sort_by_key(|&t| rank[soup.material_of[t as usize] as usize]);
    order
}

/// Counts triangle `t`, about to be appended to the mesh's indices, into the last part or into a
/// new one.
fn extend_parts(mesh: &mut Mesh, soup: &TriangleSoup, t: usize) {
    let material = &soup.materials[soup.material_of[t] as usize];
    let end = mesh.indices.len() as u32;
    match mesh.parts.last_mut() {
        Some(part)
            if part.material == material.name
                && part.two_sided == material.two_sided.unwrap_or(true)
                && part.alpha_cutoff == material.alpha_cutoff =>
        {
            part.indices.end = end + 3;
        }
        _ => mesh.parts.push(MeshPart {
            material: material.name.clone(),
            indices: end..end + 3,
            two_sided: material.two_sided.unwrap_or(true),
            alpha_cutoff: material.alpha_cutoff,
        }),
    }
}

/// Identity of a vertex: corners that agree in all of these indices share one vertex.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
struct VertexKey {
    point: u32,
    normal: u32,
    uv: u32,
    /// Index into [`CornerTangents::tangents`]; [`NONE`] also where the file has a tangent.
    tangent: u32,
}

/// Joins the corners of triangles to vertices.
struct Joiner<'a> {
    soup: &'a TriangleSoup,
    /// Index of the first normal, or UV, of equal value, by index of normal or UV.
    same_normal: Vec<u32>,
    same_uv: Vec<u32>,
    known: MeshMap<VertexKey, u32>,
    vertices: Vec<VertexKey>,
    /// Vertex indices of each triangle of the soup.
    indices: Vec<[u32; 3]>,
}

impl<'a> Joiner<'a> {
    fn new(soup: &'a TriangleSoup) -> Self {
        Self {
            soup,
            same_normal: weld(&soup.normals),
            same_uv: weld(&soup.uvs),
            known: with_room(soup.points.len()),
            vertices: Vec::with_capacity(soup.points.len()),
            indices: vec![[0; 3]; soup.triangles.len()],
        }
    }

    fn same_normal_and_uv(&self, corner: &Corner) -> [u32; 2] {
        let uv = if corner.uv == NONE { NONE } else { self.same_uv[corner.uv as usize] };
        [self.same_normal[corner.normal as usize], uv]
    }

    /// Gives every corner a vertex. Corners whose UVs determine no tangent take a vertex that a
    /// neighbor has at the same point, so they come last.
    fn join(&mut self, order: &[u32], made: &CornerTangents) {
        let has_bare = made.of_corner.iter().flatten().any(|&tangent| tangent == NONE);
        for is_bare in [false, true] {
            for (t, k) in order.iter().flat_map(|&t| [0, 1, 2].map(|k| (t as usize, k))) {
                let tangent = made.of_corner[t][k];
                if (tangent == NONE) != is_bare {
                    continue;
                }
                let corner = self.soup.triangles[t][k];
                let [normal, uv] = self.same_normal_and_uv(&corner);
                let key = VertexKey { point: corner.point, normal, uv, tangent };
                let vertex = self.vertex(key);
                self.indices[t][k] = vertex;
                // Corners of the same point, normal and UV that have no tangent find this vertex
                // later.
                if has_bare && !is_bare {
                    self.known.entry(VertexKey { tangent: NONE, ..key }).or_insert(vertex);
                }
            }
        }
    }

    /// The vertices, and those of each triangle of the soup.
    fn into_lists(self) -> (Vec<VertexKey>, Vec<[u32; 3]>) {
        (self.vertices, self.indices)
    }

    fn vertex(&mut self, key: VertexKey) -> u32 {
        *self.known.entry(key).or_insert_with(|| {
            self.vertices.push(key);
            self.vertices.len() as u32 - 1
        })
    }
}

/// The tangents of the vertices: the file's own, else those made from the UVs, else level ones.
fn vertex_tangents(
    soup: &TriangleSoup,
    vertices: &[VertexKey],
    made: &CornerTangents,
) -> Vec<[f32; 4]> {
    let tangent = |key: &VertexKey| {
        let normal = Vec3::from(soup.normals[key.normal as usize]);
        if soup.has_tangent(key.point) {
            let [x, y, z, w] = soup.tangents[key.point as usize];
            return tangents::orthogonal(normal, Vec3::new(x, y, z), w.signum());
        }
        let made = made.tangents.get(key.tangent as usize).copied();
        made.unwrap_or_else(|| tangents::orthogonal(normal, Vec3::ZERO, 1.0))
    };
    vertices.iter().map(tangent).collect()
}

/// The attributes of the vertices, except the tangents.
fn gather(soup: &TriangleSoup, vertices: &[VertexKey]) -> Mesh {
    let uv = |key: &VertexKey| soup.uvs.get(key.uv as usize).copied().unwrap_or_default();
    let white = Mesh::WHITE;
    let color = |key: &VertexKey| soup.colors.get(key.point as usize).copied().unwrap_or(white);
    let colored: &[VertexKey] = if soup.colors.is_empty() { &[] } else { vertices };
    Mesh {
        name: soup.name.clone(),
        positions: vertices.iter().map(|key| soup.points[key.point as usize]).collect(),
        normals: vertices.iter().map(|key| soup.normals[key.normal as usize]).collect(),
        uvs: vertices.iter().map(uv).collect(),
        colors: colored.iter().map(color).collect(),
        has_uvs: vertices.iter().any(|key| key.uv != NONE),
        has_colors: !soup.colors.is_empty(),
        ..Mesh::default()
    }
}
