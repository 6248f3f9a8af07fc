//! The content of a mesh file, before it becomes a [`super::Mesh`]: points, and triangles whose
//! corners name a point, a normal and a UV separately, as in OBJ. Every other format is a special
//! case of that.

use std::collections::HashMap;

use glam::DVec3;

use super::normals::place;
use super::triangulate::triangulate;

/// Index in a [`Corner`] that stands for no normal or no UV.
pub(super) const NONE: u32 = u32::MAX;

/// A corner of a triangle: indices into the lists of a [`TriangleSoup`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Corner {
    /// Index into [`TriangleSoup::points`].
    pub point: u32,
    /// Index into [`TriangleSoup::normals`], or [`NONE`].
    pub normal: u32,
    /// Index into [`TriangleSoup::uvs`], or [`NONE`].
    pub uv: u32,
}

/// A material of a file, as far as it concerns geometry.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Material {
    pub name: String,
    /// True if both sides are drawn; `None` where the file does not say, which leaves both sides to
    /// all but solids, whose inside cannot be seen.
    pub two_sided: Option<bool>,
    pub alpha_cutoff: Option<f32>,
}

impl Material {
    /// A material without holes: only glTF says more.
    pub(super) fn named(name: impl Into<String>) -> Self {
        Self { name: name.into(), two_sided: None, alpha_cutoff: None }
    }
}

/// Points, corners and materials of a file. Readers have checked every index and every number.
#[derive(Clone, Debug, Default)]
pub(super) struct TriangleSoup {
    pub name: String,
    pub points: Vec<[f32; 3]>,
    /// Color of each point: display-referred straight RGBA; empty where the file has none.
    pub colors: Vec<[f32; 4]>,
    /// Tangent of each point; empty where the file has none. A tangent of length 0 is to be made.
    pub tangents: Vec<[f32; 4]>,
    /// Normals, of any length; a normal of length 0 is to be made.
    pub normals: Vec<[f32; 3]>,
    pub uvs: Vec<[f32; 2]>,
    /// Corners of each triangle.
    pub triangles: Vec<[Corner; 3]>,
    /// Index into `materials` of each triangle.
    pub material_of: Vec<u32>,
    pub materials: Vec<Material>,
    /// Indices into `materials`, by name, sides and the bits of the cutoff.
    pub known_materials: HashMap<(String, Option<bool>, Option<u32>), u32>,
}

impl TriangleSoup {
    /// True if the file has a tangent for a point.
    pub(super) fn has_tangent(&self, point: u32) -> bool {
        self.tangents.get(point as usize).is_some_and(|tangent| tangent[3] != 0.0)
    }

    /// The index of the material with that name, which is added if there is none.
    pub(super) fn material(&mut self, name: &str) -> u32 {
        self.same_material(Material::named(name))
    }

    /// The index of an equal material, which is added if there is none. The look-up is a hash map
    /// because a file may have as many materials as triangles.
    pub(super) fn same_material(&mut self, material: Material) -> u32 {
        let cutoff = material.alpha_cutoff.map(f32::to_bits);
        let next = self.materials.len() as u32;
        let index = *self
            .known_materials
            .entry((material.name.clone(), material.two_sided, cutoff))
            .or_insert(next);
        if index == next {
            self.materials.push(material);
        }
        index
    }
}

/// The polygon being read; its lists are reused from one polygon to the next, so that nothing is
/// allocated for each.
#[derive(Default)]
pub(super) struct Polygon {
    pub(super) corners: Vec<Corner>,
    points: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
}

impl Polygon {
    /// Appends the polygon's triangles to the soup.
    pub(super) fn cut(&mut self, soup: &mut TriangleSoup, material: u32) {
        self.points.clear();
        self.points.extend(self.corners.iter().map(|c| place(&soup.points, c.point)));
        self.triangles.clear();
        triangulate(&self.points, &mut self.triangles);
        soup.triangles.extend(self.triangles.iter().map(|t| t.map(|i| self.corners[i as usize])));
        soup.material_of.resize(soup.triangles.len(), material);
    }
}
