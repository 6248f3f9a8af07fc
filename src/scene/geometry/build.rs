//! Turns a `TriangleSoup` as read from a file into a `Mesh` as a renderer draws it.

use std::sync::Arc;

use glam::{DVec3, Vec3};

use super::closed::is_solid;
use super::map::weld;
use super::mesh::{Mesh, MeshPart};
use super::motion::{Motion, VertexSource};
use super::normals::{make_missing, place};
use super::soup::{Material, MaterialRun, NONE, TriangleSoup};
use super::tangents::{self, MadeTangents};
use super::vertices::Vertices;
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
///
/// Lists become those of the mesh one by one, and what is needed besides is a fraction of them: a
/// mesh of half a gigabyte takes no second one to be built.
///
/// Where a file moves its surface, the mesh keeps what its vertices are made of.
pub(super) fn build(mut soup: TriangleSoup, crease_angle: f64) -> (Mesh, BuildNotes) {
    clamp_attributes(&mut soup);
    let welded = weld(&soup.points);
    let of_file = soup.normals.len() as u32;
    let degenerate = drop_degenerate(&mut soup, &welded);
    settle_sides(&mut soup, &welded);
    let normals = make_missing(&mut soup, &welded, crease_angle);
    drop(welded);
    soup.normals.iter_mut().for_each(|n| *n = normalize(*n));

    let name = std::mem::take(&mut soup.name);
    let materials = std::mem::take(&mut soup.materials);
    let motion = soup.motion.take().filter(Motion::is_used);
    let runs = std::mem::take(&mut soup.runs);
    let (vertices, mut triangles) = Vertices::join(
        soup,
        motion.as_ref().filter(|motion| motion.moves_surface()).map(|_| of_file),
    );
    let made = tangents::make(&vertices, &mut triangles);
    let (mut triangles, runs) = by_material(triangles, runs);
    let (mut mesh, sources) = number(vertices, &made, &mut triangles);
    mesh.name = name;
    mesh.indices = triangles.into_flattened();
    mesh.parts = parts(&runs, &materials);
    mesh.has_normals = normals == 0;
    mesh.motion = motion.map(|motion| Arc::new(motion.of_mesh(&mesh, &sources)));
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
    let keeps = |points: &[u32; 3]| {
        let [a, b, c] = points.map(|point| welded[point as usize]);
        let [pa, pb, pc] = [a, b, c].map(|p| place(&soup.points, p));
        let longest =
            pa.distance_squared(pb).max(pb.distance_squared(pc)).max(pc.distance_squared(pa));
        a != b && b != c && c != a && (pb - pa).cross(pc - pa).length() > 1e-12 * longest
    };
    let keep: Vec<bool> = soup.triangles.points().iter().map(keeps).collect();
    soup.retain(&keep);
    keep.len() - soup.triangles.len()
}

/// Settles the sides of materials that leave them open: of a solid only the outside is drawn,
/// because at its outlines a GPU may take a sliver for a back face and would light it from the
/// wrong side.
fn settle_sides(soup: &mut TriangleSoup, welded: &[u32]) {
    if soup.materials.iter().all(|material| material.two_sided.is_some()) {
        return;
    }
    let point = |point| place(&soup.points, point);
    let is_solid = is_solid(soup.triangles.points(), welded, point);
    soup.materials
        .iter_mut()
        .for_each(|material| material.two_sided = material.two_sided.or(Some(!is_solid)));
}

/// The triangles and their runs in the order of the materials' first use, otherwise as in the file.
fn by_material(
    triangles: Vec<[u32; 3]>,
    mut runs: Vec<MaterialRun>,
) -> (Vec<[u32; 3]>, Vec<MaterialRun>) {
    let count = runs.iter().map(|run| run.material as usize + 1).max().unwrap_or_default();
    let mut rank = vec![NONE; count];
    let mut next = 0;
    for run in &runs {
        if rank[run.material as usize] == NONE {
            rank[run.material as usize] = next;
            next += 1;
        }
    }
    let rank = |run: &MaterialRun| rank[run.material as usize];
    if runs.is_sorted_by_key(rank) {
        return (triangles, runs);
    }
    runs.sort_by_key(rank);
    let mut sorted = Vec::with_capacity(triangles.len());
    for run in &mut runs {
        let start = sorted.len() as u32;
        sorted.extend(&triangles[run.triangles.start as usize..run.triangles.end as usize]);
        run.triangles = start..sorted.len() as u32;
    }
    (sorted, runs)
}

/// The parts of a mesh whose triangles are sorted by material.
fn parts(runs: &[MaterialRun], materials: &[Material]) -> Vec<MeshPart> {
    let mut parts: Vec<MeshPart> = Vec::new();
    for run in runs {
        let material = &materials[run.material as usize];
        let part = MeshPart {
            material: material.name.clone(),
            indices: 3 * run.triangles.start..3 * run.triangles.end,
            two_sided: material.two_sided.unwrap_or(true),
            alpha_cutoff: material.alpha_cutoff,
            maps: material.maps.clone(),
        };
        match parts.last_mut() {
            Some(last) if MeshPart { indices: last.indices.clone(), ..part.clone() } == *last => {
                last.indices.end = part.indices.end;
            }
            _ => parts.push(part),
        }
    }
    parts
}

/// Numbers the vertices in the order in which triangles first use them, and drops those that none
/// uses. Gives the mesh without its name, indices and parts, and what its vertices are made of.
fn number(
    vertices: Vertices,
    made: &MadeTangents,
    triangles: &mut [[u32; 3]],
) -> (Mesh, Vec<VertexSource>) {
    let mut numbers = vec![NONE; vertices.positions.len() + made.copies.len()];
    let mut count = 0;
    for vertex in triangles.as_flattened_mut() {
        let own = &mut numbers[*vertex as usize];
        if *own == NONE {
            *own = count;
            count += 1;
        }
        *vertex = *own;
    }
    let order = VertexOrder { numbers, made, count: count as usize };
    let Vertices { positions, normals, uvs, colors, tangents, sources, .. } = vertices;
    let mut mesh = Mesh {
        has_uvs: !uvs.is_empty(),
        has_colors: !colors.is_empty(),
        positions: order.apply(positions),
        normals: order.apply(normals),
        uvs: order.apply(uvs),
        colors: order.apply(colors),
        ..Mesh::default()
    };
    mesh.uvs.resize(count as usize, [0.0; 2]);
    mesh.tangents = order.tangents(tangents, &mesh.normals);
    (mesh, order.apply(sources))
}

/// Value that stands where none was given yet.
trait Zero {
    const ZERO: Self;
}

impl<const N: usize> Zero for [f32; N] {
    const ZERO: Self = [0.0; N];
}

impl Zero for VertexSource {
    const ZERO: Self = Self { point: 0, has_made_normal: false };
}

/// New numbers of vertices and their copies.
struct VertexOrder<'a> {
    /// New number of each vertex, then of each copy; [`NONE`] where no triangle uses it.
    numbers: Vec<u32>,
    made: &'a MadeTangents,
    /// Number of vertices in use.
    count: usize,
}

impl VertexOrder<'_> {
    /// An attribute in the order of the new numbers.
    fn apply<T: Copy + Zero>(&self, list: Vec<T>) -> Vec<T> {
        let is_same = || self.numbers.iter().zip(0..).all(|(new, old)| *new == old);
        if list.is_empty() || (list.len() == self.count && is_same()) {
            return list;
        }
        let mut numbered = vec![T::ZERO; self.count];
        let old = (0..list.len()).chain(self.made.copies.iter().map(|copy| copy.of as usize));
        for (old, new) in old.zip(&self.numbers).filter(|(_, new)| **new != NONE) {
            numbered[*new as usize] = list[old];
        }
        numbered
    }

    /// The tangents of the vertices: the file's own, else those made from the UVs, else level ones.
    fn tangents(&self, of_file: Vec<[f32; 4]>, normals: &[[f32; 3]]) -> Vec<[f32; 4]> {
        let of_file = self.apply(of_file);
        let mut tangents = vec![[0.0; 4]; self.count];
        let copies = self.made.copies.iter().map(|copy| &copy.tangent);
        let made = self.made.tangents.iter().chain(copies).zip(&self.numbers);
        for (tangent, new) in made.filter(|(_, new)| **new != NONE) {
            tangents[*new as usize] = *tangent;
        }
        for (vertex, (tangent, normal)) in tangents.iter_mut().zip(normals).enumerate() {
            let normal = Vec3::from(*normal);
            if let Some([x, y, z, w]) = of_file.get(vertex).filter(|tangent| tangent[3] != 0.0) {
                let wish = Vec3::new(*x, *y, *z);
                *tangent = tangents::orthogonal(normal, wish, w.signum());
            } else if tangent[3] == 0.0 {
                *tangent = tangents::orthogonal(normal, Vec3::ZERO, 1.0);
            }
        }
        tangents
    }
}
