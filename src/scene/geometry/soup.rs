//! The content of a mesh file, before it becomes a [`super::Mesh`]: points, and triangles whose
//! corners name a point, a normal and a UV separately, as in OBJ. Every other format is a special
//! case of that, and takes no more memory than it needs.

use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;

use glam::DVec3;

use super::maps::MaterialMaps;
use super::motion::Motion;
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

/// Triangles of a soup, each of three corners. Indices that all corners share with their points
/// are not stored: most files have a normal and a UV a point, and millions of triangles.
#[derive(Clone, Debug, Default)]
pub(super) struct Triangles {
    points: Vec<[u32; 3]>,
    normals: CornerIndices,
    uvs: CornerIndices,
}

/// Indices of all corners into one of a soup's lists.
#[derive(Clone, Debug, Default)]
pub(super) struct CornerIndices {
    /// Indices of the corners of each triangle; `None` where a rule tells them.
    own: Option<Vec<[u32; 3]>>,
    /// The rule: the index of the corner's point, or else [`NONE`].
    is_of_points: bool,
}

impl CornerIndices {
    /// Indices of a triangle's corners, of which `points` are the points.
    pub(super) fn get(&self, triangle: usize, points: [u32; 3]) -> [u32; 3] {
        match &self.own {
            Some(list) => list[triangle],
            None if self.is_of_points => points,
            None => [NONE; 3],
        }
    }

    /// Indices as a list; `points` are those of all triangles.
    fn own(&mut self, points: &[[u32; 3]]) -> &mut Vec<[u32; 3]> {
        let is_of_points = self.is_of_points;
        self.own.get_or_insert_with(|| match is_of_points {
            true => points.to_vec(),
            false => vec![[NONE; 3]; points.len()],
        })
    }

    /// True if every corner has the index of its point.
    pub(super) fn are_of_points(&self) -> bool {
        self.own.is_none() && self.is_of_points
    }

    /// True if no corner has an index.
    pub(super) fn are_absent(&self) -> bool {
        self.own.is_none() && !self.is_of_points
    }

    /// Appends the indices of a triangle; `before` has the points of the triangles before it.
    fn push(&mut self, before: &[[u32; 3]], points: [u32; 3], indices: [u32; 3]) {
        if before.is_empty() {
            self.is_of_points = indices == points;
        }
        let is_told = indices == if self.is_of_points { points } else { [NONE; 3] };
        if self.own.is_some() || !is_told {
            self.own(before).push(indices);
        }
    }
}

impl Triangles {
    pub(super) fn len(&self) -> usize {
        self.points.len()
    }

    pub(super) fn push(&mut self, corners: [Corner; 3]) {
        let points = corners.map(|corner| corner.point);
        self.normals.push(&self.points, points, corners.map(|corner| corner.normal));
        self.uvs.push(&self.points, points, corners.map(|corner| corner.uv));
        self.points.push(points);
    }

    /// Makes room for as many more triangles.
    pub(super) fn reserve(&mut self, count: usize) {
        self.points.reserve_exact(count);
    }

    pub(super) fn corners(&self, triangle: usize) -> [Corner; 3] {
        let points = self.points[triangle];
        let (normals, uvs) = (self.normals.get(triangle, points), self.uvs.get(triangle, points));
        [0, 1, 2].map(|k| Corner { point: points[k], normal: normals[k], uv: uvs[k] })
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = [Corner; 3]> + '_ {
        (0..self.len()).map(|triangle| self.corners(triangle))
    }

    /// Points of each triangle.
    pub(super) fn points(&self) -> &[[u32; 3]] {
        &self.points
    }

    /// Normals of each triangle, to be changed.
    pub(super) fn normals_mut(&mut self) -> &mut [[u32; 3]] {
        self.normals.own(&self.points)
    }

    /// Indices of the points, the normals and the UVs of all corners.
    pub(super) fn into_indices(self) -> (Vec<[u32; 3]>, CornerIndices, CornerIndices) {
        (self.points, self.normals, self.uvs)
    }

    /// Drops the triangles for which `keep` is false.
    fn retain(&mut self, keep: &[bool]) {
        let retain = |list: &mut Vec<[u32; 3]>| {
            let mut flags = keep.iter();
            list.retain(|_| *flags.next().unwrap_or(&true));
        };
        let stored = [&mut self.normals, &mut self.uvs].map(|indices| indices.own.as_mut());
        stored.into_iter().flatten().chain([&mut self.points]).for_each(retain);
    }
}

impl Extend<[Corner; 3]> for Triangles {
    fn extend<I: IntoIterator<Item = [Corner; 3]>>(&mut self, triangles: I) {
        triangles.into_iter().for_each(|corners| self.push(corners));
    }
}

/// Triangles that follow one another and wear one material.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct MaterialRun {
    pub triangles: Range<u32>,
    /// Index into [`TriangleSoup::materials`].
    pub material: u32,
}

/// A material of a file, as far as it concerns geometry.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Material {
    pub name: String,
    /// True if both sides are drawn; `None` where the file does not say, which leaves both sides to
    /// all but solids, whose inside cannot be seen.
    pub two_sided: Option<bool>,
    pub alpha_cutoff: Option<f32>,
    pub maps: Option<Arc<MaterialMaps>>,
}

impl Material {
    /// A material without holes: only glTF says more.
    pub(super) fn named(name: impl Into<String>) -> Self {
        Self { name: name.into(), two_sided: None, alpha_cutoff: None, maps: None }
    }
}

/// Key of a material: name, sides, the bits of the cutoff, and the address of maps.
type MaterialKey = (String, Option<bool>, Option<u32>, Option<usize>);

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
    pub triangles: Triangles,
    /// Materials of all triangles, in the triangles' order.
    pub runs: Vec<MaterialRun>,
    pub materials: Vec<Material>,
    /// Indices into `materials`.
    pub known_materials: HashMap<MaterialKey, u32>,
    /// Motion of the points, whose numbers are those of [`Self::points`].
    pub motion: Option<Motion>,
}

impl TriangleSoup {
    /// The index of the material with that name, which is added if there is none.
    pub(super) fn material(&mut self, name: &str) -> u32 {
        self.same_material(Material::named(name))
    }

    /// The index of an equal material, which is added if there is none. The look-up is a hash map
    /// because a file may have as many materials as triangles.
    pub(super) fn same_material(&mut self, material: Material) -> u32 {
        let cutoff = material.alpha_cutoff.map(f32::to_bits);
        let maps = material.maps.as_ref().map(|maps| Arc::as_ptr(maps) as usize);
        let next = self.materials.len() as u32;
        let index = *self
            .known_materials
            .entry((material.name.clone(), material.two_sided, cutoff, maps))
            .or_insert(next);
        if index == next {
            self.materials.push(material);
        }
        index
    }

    /// Gives a material to the triangles that were appended since the last call.
    pub(super) fn wear(&mut self, material: u32) {
        let end = self.triangles.len() as u32;
        let start = self.runs.last().map_or(0, |run| run.triangles.end);
        match self.runs.last_mut() {
            Some(last) if last.material == material => last.triangles.end = end,
            _ if start == end => {}
            _ => self.runs.push(MaterialRun { triangles: start..end, material }),
        }
    }

    /// Drops the triangles for which `keep` is false.
    pub(super) fn retain(&mut self, keep: &[bool]) {
        self.triangles.retain(keep);
        let mut kept = 0;
        for run in &mut self.runs {
            let flags = &keep[run.triangles.start as usize..run.triangles.end as usize];
            let start = kept;
            kept += flags.iter().filter(|keep| **keep).count() as u32;
            run.triangles = start..kept;
        }
        self.runs.retain(|run| !run.triangles.is_empty());
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
        soup.wear(material);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corners(
        points: [u32; 3],
        normal: impl Fn(u32) -> u32,
        uv: impl Fn(u32) -> u32,
    ) -> [Corner; 3] {
        points.map(|point| Corner { point, normal: normal(point), uv: uv(point) })
    }

    #[test]
    fn indices_are_stored_only_where_they_differ() {
        let same = |point| point;
        let none = |_| NONE;
        let pushed = [
            corners([0, 1, 2], same, none),
            corners([2, 1, 3], same, none),
            corners([3, 0, 1], same, same),
            corners([1, 2, 0], none, |point| point + 7),
        ];
        let mut triangles = Triangles::default();
        for (count, expected) in pushed.iter().enumerate() {
            triangles.push(*expected);
            assert_eq!(triangles.iter().collect::<Vec<_>>(), pushed[..=count]);
            let is_stored =
                [&triangles.normals, &triangles.uvs].map(|indices| indices.own.is_some());
            assert_eq!(is_stored, [count > 2, count > 1], "{count}");
        }
        triangles.retain(&[true, false, false, true]);
        assert_eq!(triangles.iter().collect::<Vec<_>>(), [pushed[0], pushed[3]]);
        triangles.normals_mut()[1] = [4; 3];
        assert_eq!(triangles.corners(1).map(|corner| corner.normal), [4; 3]);
        assert_eq!(triangles.corners(0).map(|corner| corner.normal), [0, 1, 2]);
    }

    #[test]
    fn runs_follow_the_triangles() {
        let mut soup = TriangleSoup::default();
        for (count, material) in [(2, 0), (0, 1), (1, 0), (3, 1), (1, 2)] {
            let triangle = corners([0, 1, 2], |_| NONE, |_| NONE);
            soup.triangles.extend(vec![triangle; count]);
            soup.wear(material);
        }
        let run = |triangles, material| MaterialRun { triangles, material };
        assert_eq!(soup.runs, [run(0..3, 0), run(3..6, 1), run(6..7, 2)]);
        soup.retain(&[true, false, true, false, false, false, true]);
        assert_eq!(soup.runs, [run(0..2, 0), run(2..3, 2)]);
        assert_eq!(soup.triangles.len(), 3);
    }
}
