//! The mesh that a renderer draws: indexed triangles with every attribute filled in.

use std::borrow::Cow;
use std::ops::Range;
use std::path::PathBuf;
use std::sync::{Arc, OnceLock, Weak};

use glam::{DMat4, DVec3, Vec3};

use super::maps::MaterialMaps;
use super::motion::{Motion, Pose};
use super::tree::MeshTree;
use crate::cache::{CachedValue, EntryReader, EntryWriter};

/// Name of the material of triangles without a material in the file.
pub const DEFAULT_MATERIAL: &str = "default";

/// Indexed triangles, counter-clockwise seen from outside. All attribute lists are equally long,
/// but for colors, which most files lack.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Name of the mesh in the file, or the file's own name without its ending.
    pub name: String,
    /// File that the mesh was read from; `None` for own shapes and for bytes without a path.
    pub file: Option<PathBuf>,
    /// Positions of the vertices, in object space, in the file's units.
    pub positions: Vec<[f32; 3]>,
    /// Normals of the vertices, in object space, of unit length.
    pub normals: Vec<[f32; 3]>,
    /// Tangents of the vertices, in object space: `xyz` of unit length, orthogonal to the normal,
    /// along growing u; the bitangent, along growing v, is `w * cross(normal, tangent)` with `w` of
    /// 1 or -1. Without UVs a frame that depends on the normal alone, level with the ground (y up).
    pub tangents: Vec<[f32; 4]>,
    /// UVs of the vertices: u to the right and v up, (0, 0) at the lower left corner of the image;
    /// zeros where the file has none.
    pub uvs: Vec<[f32; 2]>,
    /// Colors of the vertices: straight RGBA, display-referred (sRGB curve), 0 to 1; empty where
    /// the file has none, and all are [white](Self::WHITE).
    pub colors: Vec<[f32; 4]>,
    /// Indices of vertices, three per triangle.
    pub indices: Vec<u32>,
    /// Runs of triangles of one material each, in the order in which the file first uses them;
    /// together all of [`Mesh::indices`].
    pub parts: Vec<MeshPart>,
    /// True if the file (or the shape) brings UVs.
    pub has_uvs: bool,
    /// True if the file brings vertex colors.
    pub has_colors: bool,
    /// True if every corner's normal comes from the file; otherwise some were made.
    pub has_normals: bool,
    /// Motion that the file brings; `None` where nothing in it moves.
    pub motion: Option<Arc<Motion>>,
    /// Positions at rest of a mesh that a [pose](Self::posed) deformed; empty for any other.
    pub rest: Vec<[f32; 3]>,
    /// Tree over the triangles, made when first asked for.
    pub tree: LazyTree,
}

/// Tree over a mesh's triangles, made when first asked for. It follows from the mesh, and so is
/// equal to any other; a copy of a mesh, which may be changed, makes its own, and a deformed mesh
/// takes that of the mesh at rest for a beginning.
#[derive(Debug, Default)]
pub struct LazyTree {
    made: OnceLock<Arc<MeshTree>>,
    /// Mesh at rest of a deformed one, whose tree is [refitted](MeshTree::refitted).
    rest: Weak<Mesh>,
}

impl Clone for LazyTree {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl PartialEq for LazyTree {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

/// The triangles of one material.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeshPart {
    /// Name of the material in the file.
    pub material: String,
    /// Range of the triangles in [`Mesh::indices`]; begin and end are multiples of 3.
    pub indices: Range<u32>,
    /// True if back faces are drawn too.
    pub two_sided: bool,
    /// Least alpha of fragments that are drawn, those of lower alpha are cut out; `None` where the
    /// material is solid.
    pub alpha_cutoff: Option<f32>,
    /// Maps of the material; `None` where the file has none.
    pub maps: Option<Arc<MaterialMaps>>,
}

/// The tight axis-aligned box of a mesh, and the least sphere around the mesh with the same center.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Least coordinates of the box.
    pub min: DVec3,
    /// Greatest coordinates of the box.
    pub max: DVec3,
    /// Radius of the sphere: the distance from the box's center to the farthest vertex.
    pub radius: f64,
}

impl Bounds {
    /// The bounds of points; all zero where there are no points.
    pub fn of(positions: &[[f32; 3]]) -> Self {
        let Some(first) = positions.first() else {
            return Self { min: DVec3::ZERO, max: DVec3::ZERO, radius: 0.0 };
        };
        let first = Vec3::from(*first);
        let (min, max) = positions.iter().fold((first, first), |(min, max), p| {
            let p = Vec3::from(*p);
            (min.min(p), max.max(p))
        });
        let (min, max) = (min.as_dvec3(), max.as_dvec3());
        let center = (min + max) / 2.0;
        let farthest = positions
            .iter()
            .map(|p| Vec3::from(*p).as_dvec3().distance_squared(center))
            .fold(0.0, f64::max);
        Self { min, max, radius: farthest.sqrt() }
    }

    /// The center of the box and of the sphere.
    pub fn center(&self) -> DVec3 {
        (self.min + self.max) / 2.0
    }

    /// The corners of the box.
    pub fn corners(&self) -> [DVec3; 8] {
        let sides = [self.min, self.max];
        std::array::from_fn(|index| {
            let side = |axis: usize| sides[index >> axis & 1][axis];
            DVec3::new(side(0), side(1), side(2))
        })
    }

    /// The lengths of the box's edges along x, y and z.
    pub fn size(&self) -> DVec3 {
        self.max - self.min
    }
}

/// A transform into fitted space: moves `center` to the origin, then scales:
/// `(p - center) * scale`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FitTransform {
    /// Point that comes to the origin, in object space.
    pub center: DVec3,
    /// Scale, the same along all axes; above 0.
    pub scale: f64,
}

impl FitTransform {
    /// The matrix from object space to fitted space.
    pub fn matrix(&self) -> DMat4 {
        DMat4::from_scale(DVec3::splat(self.scale)) * DMat4::from_translation(-self.center)
    }
}

impl Mesh {
    /// Color of the vertices of a mesh without colors.
    pub const WHITE: [f32; 4] = [1.0; 4];

    /// Colors of all vertices, also where the mesh has none.
    pub fn all_colors(&self) -> Cow<'_, [[f32; 4]]> {
        match self.colors.is_empty() {
            true => Cow::Owned(vec![Self::WHITE; self.positions.len()]),
            false => Cow::Borrowed(&self.colors),
        }
    }

    /// True if a pose deformed the mesh.
    pub fn is_deformed(&self) -> bool {
        !self.rest.is_empty()
    }

    /// Positions at rest, to which marks stick.
    pub fn rest(&self) -> &[[f32; 3]] {
        if self.is_deformed() { &self.rest } else { &self.positions }
    }

    /// Size of the attributes, the indices and the tree, if that is made, in memory, in bytes.
    pub fn bytes(&self) -> usize {
        let attributes = [
            size_of_val(&*self.positions),
            size_of_val(&*self.rest),
            size_of_val(&*self.normals),
            size_of_val(&*self.tangents),
            size_of_val(&*self.uvs),
            size_of_val(&*self.colors),
        ];
        let tree = self.tree.made.get().map_or(0, |tree| tree.bytes());
        attributes.iter().sum::<usize>() + size_of_val(&*self.indices) + tree
    }

    /// The tree over all triangles, for rays; made once.
    pub fn tree(&self) -> &Arc<MeshTree> {
        self.tree.made.get_or_init(|| {
            Arc::new(match self.tree.rest.upgrade() {
                Some(rest) => rest.tree().refitted(self),
                None => MeshTree::new(self),
            })
        })
    }

    /// [`posed`](Self::posed) for a mesh that is shared, whose tree then serves all its poses.
    #[must_use]
    pub fn posed_with_tree(self: &Arc<Self>, pose: &Pose) -> Self {
        let mut posed = self.posed(pose);
        posed.tree.rest = Arc::downgrade(self);
        posed
    }

    /// Number of triangles.
    pub fn triangle_count(&self) -> usize {
        self.indices.len() / 3
    }

    /// The bounding box and sphere of the mesh.
    pub fn bounds(&self) -> Bounds {
        Bounds::of(&self.positions)
    }

    /// The transform that brings the mesh's bounding sphere to the origin and to radius 1; a single
    /// point is only moved.
    pub fn fit(&self) -> FitTransform {
        let bounds = self.bounds();
        let scale = if bounds.radius > 0.0 { 1.0 / bounds.radius } else { 1.0 };
        FitTransform { center: bounds.center(), scale }
    }
}

impl CachedValue for Mesh {
    fn write(&self, entry: &mut EntryWriter) {
        entry.bytes(self.name.as_bytes());
        entry.vectors(&self.positions);
        entry.vectors(&self.normals);
        entry.vectors(&self.tangents);
        entry.vectors(&self.uvs);
        entry.vectors(&self.colors);
        entry.words(self.indices.iter().copied());
        entry.number(self.parts.len() as u64);
        for part in &self.parts {
            entry.bytes(part.material.as_bytes());
            entry.words([part.indices.start, part.indices.end].into_iter());
            entry.number(part.two_sided.into());
            entry.vectors(part.alpha_cutoff.map(|cutoff| [cutoff]).as_slice());
        }
        for is_given in [self.has_uvs, self.has_colors, self.has_normals] {
            entry.number(is_given.into());
        }
    }

    fn read(entry: &mut EntryReader<'_>) -> Option<Self> {
        let mut mesh = Self {
            name: text(entry)?,
            positions: entry.vectors()?,
            normals: entry.vectors()?,
            tangents: entry.vectors()?,
            uvs: entry.vectors()?,
            colors: entry.vectors()?,
            indices: entry.words()?,
            ..Self::default()
        };
        for _ in 0..entry.number()? {
            let material = text(entry)?;
            let [start, end] = <[u32; 2]>::try_from(entry.words()?).ok()?;
            mesh.parts.push(MeshPart {
                material,
                indices: start..end,
                two_sided: entry.number()? != 0,
                alpha_cutoff: entry.vectors::<1>()?.first().map(|cutoff| cutoff[0]),
                maps: None,
            });
        }
        mesh.has_uvs = entry.number()? != 0;
        mesh.has_colors = entry.number()? != 0;
        mesh.has_normals = entry.number()? != 0;
        let count = mesh.positions.len();
        let lengths = [mesh.normals.len(), mesh.tangents.len(), mesh.uvs.len()];
        let is_whole = lengths == [count; 3]
            && [0, count].contains(&mesh.colors.len())
            && mesh.indices.iter().all(|&index| (index as usize) < count)
            && mesh.parts.iter().all(|part| mesh.indices.len() >= part.indices.end as usize);
        is_whole.then_some(mesh)
    }
}

fn text(entry: &mut EntryReader<'_>) -> Option<String> {
    String::from_utf8(entry.bytes()?.to_vec()).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mesh_from_the_cache_is_the_same() {
        let part = |material: &str, indices, two_sided, alpha_cutoff| MeshPart {
            material: material.to_owned(),
            indices,
            two_sided,
            alpha_cutoff,
            maps: None,
        };
        let mesh = Mesh {
            name: "m".to_owned(),
            file: None,
            positions: vec![[0.0, 1.0, 2.0], [3.0, 4.0, -0.5], [0.1, 0.2, 0.3]],
            normals: vec![[0.0, 0.0, 1.0]; 3],
            tangents: vec![[1.0, 0.0, 0.0, -1.0]; 3],
            uvs: vec![[0.25, 0.75]; 3],
            colors: vec![[1.0; 4]; 3],
            indices: vec![0, 1, 2, 2, 1, 0],
            parts: vec![part("a", 0..3, true, Some(0.5)), part("b", 3..6, false, None)],
            has_uvs: true,
            has_colors: false,
            has_normals: true,
            motion: None,
            rest: Vec::new(),
            tree: LazyTree::default(),
        };
        let again = |mesh: &Mesh| {
            let mut entry = EntryWriter::default();
            mesh.write(&mut entry);
            Mesh::read(&mut EntryReader::of(&entry))
        };
        assert_eq!(again(&mesh).as_ref(), Some(&mesh));
        assert_eq!(again(&Mesh { uvs: Vec::new(), ..mesh.clone() }), None);
        assert_eq!(again(&Mesh { indices: vec![0, 1, 3, 2, 1, 0], ..mesh.clone() }), None);
        assert_eq!(again(&Mesh { indices: vec![0, 1, 2], ..mesh }), None);
    }

    #[test]
    fn the_size_of_a_mesh_counts_its_tree() {
        let mesh = Mesh {
            positions: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
            normals: vec![[0.0, 0.0, 1.0]; 3],
            indices: vec![0, 1, 2],
            ..Mesh::default()
        };
        let before = mesh.bytes();
        assert_eq!(before, 3 * (12 + 12 + 4));
        let tree = mesh.tree();
        // A node of two texels, three corners and three normals.
        assert_eq!((tree.nodes, tree.bytes()), (1, 16 * (2 + 3 + 3)));
        assert_eq!(mesh.bytes(), before + tree.bytes());
    }

    #[test]
    fn a_fitted_mesh_touches_the_unit_sphere() {
        let mesh = Mesh {
            positions: vec![[1.0, 2.0, 3.0], [5.0, 2.0, 3.0], [1.0, 2.0, 6.0]],
            ..Mesh::default()
        };
        let matrix = mesh.fit().matrix();
        let lengths: Vec<f64> = mesh
            .positions
            .iter()
            .map(|p| matrix.transform_point3(Vec3::from(*p).as_dvec3()).length())
            .collect();
        assert!(lengths.iter().all(|l| (l - 1.0).abs() < 1e-12), "{lengths:?}");
        assert_eq!(mesh.bounds().size(), DVec3::new(4.0, 0.0, 3.0));
        assert_eq!(Mesh::default().fit().scale, 1.0);
    }
}
