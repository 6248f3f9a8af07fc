//! Corners joined to vertices: those of equal point, normal and UV are one.

use super::map::{MeshMap, weld, with_room};
use super::motion::VertexSource;
use super::soup::{NONE, TriangleSoup};

/// Vertices of a mesh before their tangents are made. Lists are as long as that of the positions,
/// or empty where no vertex has the attribute.
#[derive(Clone, Debug, Default)]
pub(super) struct Vertices {
    pub(super) positions: Vec<[f32; 3]>,
    /// Normals, of unit length.
    pub(super) normals: Vec<[f32; 3]>,
    pub(super) uvs: Vec<[f32; 2]>,
    /// True for vertices with UVs; empty where all have them, or none.
    pub(super) has_uv: Vec<bool>,
    pub(super) colors: Vec<[f32; 4]>,
    /// Tangents of the file; one of w 0 is to be made.
    pub(super) tangents: Vec<[f32; 4]>,
    /// Sources of the vertices; empty unless somebody asks.
    pub(super) sources: Vec<VertexSource>,
}

impl Vertices {
    /// Joins the corners of a soup all of which have normals. Gives the vertices, and those of each
    /// triangle. Where a corner's normal and UV are those of its point, the points are the
    /// vertices, used or not.
    ///
    /// With `of_file`, the number of normals that the file has, vertices tell what they are made
    /// of.
    pub(super) fn join(soup: TriangleSoup, of_file: Option<u32>) -> (Self, Vec<[u32; 3]>) {
        let TriangleSoup { points, mut normals, mut uvs, colors, tangents, triangles, .. } = soup;
        let (mut triangles, normal_of, uv_of) = triangles.into_indices();
        let count = points.len();
        if uv_of.are_absent() {
            uvs.clear();
        }
        if normal_of.are_of_points() && (uv_of.are_of_points() || uvs.is_empty()) {
            normals.resize(count, [0.0; 3]);
            uvs.resize(if uv_of.are_of_points() { count } else { 0 }, [0.0; 2]);
            let source = |point| VertexSource { point, has_made_normal: false };
            let sources = match of_file {
                Some(_) => (0..count as u32).map(source).collect(),
                None => Vec::new(),
            };
            let has_uv = Vec::new();
            let vertices =
                Self { positions: points, normals, uvs, has_uv, colors, tangents, sources };
            return (vertices, triangles);
        }
        let (same_normal, same_uv) = (weld(&normals), weld(&uvs));
        let mut known: MeshMap<[u32; 3], u32> = with_room(count);
        let mut keys: Vec<[u32; 3]> = Vec::with_capacity(count);
        let mut sources = Vec::new();
        for (t, corners) in triangles.iter_mut().enumerate() {
            let (normals, uvs) = (normal_of.get(t, *corners), uv_of.get(t, *corners));
            for (k, corner) in corners.iter_mut().enumerate() {
                let uv = if uvs[k] == NONE { NONE } else { same_uv[uvs[k] as usize] };
                let key = [*corner, same_normal[normals[k] as usize], uv];
                *corner = *known.entry(key).or_insert_with(|| {
                    sources.extend(of_file.map(|of_file| VertexSource {
                        point: key[0],
                        has_made_normal: normals[k] >= of_file,
                    }));
                    keys.push(key);
                    keys.len() as u32 - 1
                });
            }
        }
        let of_points = |list: &[[f32; 4]]| {
            keys.iter().filter_map(|key| list.get(key[0] as usize).copied()).collect()
        };
        let has_uv: Vec<bool> = keys.iter().map(|key| key[2] != NONE).collect();
        let uv = |key: &[u32; 3]| uvs.get(key[2] as usize).copied().unwrap_or_default();
        let vertices = Self {
            positions: keys.iter().map(|key| points[key[0] as usize]).collect(),
            normals: keys.iter().map(|key| normals[key[1] as usize]).collect(),
            uvs: if has_uv.contains(&true) { keys.iter().map(uv).collect() } else { Vec::new() },
            colors: of_points(&colors),
            tangents: of_points(&tangents),
            sources,
            has_uv: if has_uv.contains(&false) { has_uv } else { Vec::new() },
        };
        (vertices, triangles)
    }

    pub(super) fn has_uv(&self, vertex: u32) -> bool {
        !self.uvs.is_empty() && self.has_uv.get(vertex as usize).copied().unwrap_or(true)
    }

    /// True if the file has a tangent for a vertex.
    pub(super) fn has_tangent(&self, vertex: u32) -> bool {
        self.tangents.get(vertex as usize).is_some_and(|tangent| tangent[3] != 0.0)
    }
}
