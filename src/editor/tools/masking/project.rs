//! Strokes on the picture, carried onto the texels of a mesh's UVs: what is seen under the stroke
//! is painted, however the UVs lie.
//!
//! A small depth buffer tells what is seen. Then every triangle near the stroke is walked texel by
//! texel in UV, and each texel's place on the surface is looked up in the picture. Texels within
//! one texel of a triangle are its own too, so that seams of the UVs show no line.

use std::ops::Range;
use std::sync::Arc;

use glam::{DMat4, DQuat, DVec2, DVec3, DVec4, dvec2};

use crate::frame::{Setup, View};
use crate::geometry::Mesh;
use crate::state::masks::{MaskLaying, StraightLaying};

/// Longer side of the depth buffer, in cells.
const DEPTH_SIDE: f64 = 1024.0;
/// Depth by which a place may lie behind what is seen there, as a share of all depths.
const DEPTH_BIAS: f64 = 0.005;
/// Distance of the points of a stroke that are kept, in radii.
const POINT_STEP: f64 = 0.25;

/// Stroke on the picture.
#[derive(Clone, Debug)]
pub(super) struct MaskStroke {
    /// Points of the stroke, in pixels of the picture.
    pub(super) points: Vec<DVec2>,
    /// Radius of the brush, in pixels.
    pub(super) radius: f64,
    /// Part of the radius that is covered wholly, 0 to 1.
    pub(super) hardness: f64,
    /// True if the stroke shows the layer, false if it hides it.
    pub(super) shows: bool,
}

impl MaskStroke {
    /// The stroke with points that are as near to one another as the brush needs.
    fn thinned(&self) -> Vec<DVec2> {
        let mut kept: Vec<DVec2> = Vec::new();
        for point in &self.points {
            let is_near = |last: &DVec2| last.distance(*point) < self.radius * POINT_STEP;
            if !kept.last().is_some_and(is_near) {
                kept.push(*point);
            }
        }
        kept
    }

    /// Share of a pixel at a distance from the stroke that is covered.
    fn share(&self, distance: f64) -> f64 {
        let inner = self.radius * self.hardness.clamp(0.0, 0.999);
        let t = ((distance - inner) / (self.radius - inner).max(1e-9)).clamp(0.0, 1.0);
        1.0 - t * t * (3.0 - 2.0 * t)
    }
}

/// Object of the picture.
#[derive(Clone, Debug)]
pub(super) struct MaskObject {
    pub(super) mesh: Arc<Mesh>,
    pub(super) world_from_object: DMat4,
    /// Ranges of indices that wear the look whose mask is painted.
    pub(super) worn: Vec<Range<usize>>,
}

impl MaskObject {
    /// The objects of a setup whose first look is the one that is painted.
    pub(super) fn of(setup: &Setup) -> Vec<Self> {
        let of = |object: &crate::frame::SetupObject| {
            let parts = object.mesh.parts.iter().zip(&object.looks);
            let worn = parts.filter(|(_, look)| **look == Some(0));
            let range = |range: &Range<u32>| range.start as usize..range.end as usize;
            Self {
                mesh: object.mesh.clone(),
                world_from_object: object.world_from_object,
                worn: worn.map(|(part, _)| range(&part.indices)).collect(),
            }
        };
        setup.objects.iter().map(of).collect()
    }

    fn corner(&self, index: u32) -> DVec4 {
        self.world_from_object * self.place(index).extend(1.0)
    }

    /// A corner's place, in object space.
    fn place(&self, index: u32) -> DVec3 {
        let place = self.mesh.positions.get(index as usize).copied().unwrap_or_default();
        DVec3::from(place.map(f64::from))
    }

    fn uv(&self, index: u32, laying: &MaskLaying) -> DVec2 {
        match laying {
            MaskLaying::Uvs => {
                let uv = self.mesh.uvs.get(index as usize).copied().unwrap_or_default();
                DVec2::from(uv.map(f64::from))
            }
            MaskLaying::Straight(laying) if laying.is_of_object => laying.uv(self.place(index)),
            MaskLaying::Straight(laying) => {
                laying.uv(self.world_from_object.transform_point3(self.place(index)))
            }
        }
    }

    /// The way in which a new mask lies on the objects that wear the look, as they are seen: by
    /// UVs, or straight through the first of them where none has any.
    pub(super) fn laying(objects: &[Self], view: &View) -> MaskLaying {
        let mut worn = objects.iter().filter(|object| !object.worn.is_empty());
        let Some(first) = worn.next().filter(|first| !first.mesh.has_uvs) else {
            return MaskLaying::Uvs;
        };
        if worn.any(|object| object.mesh.has_uvs) {
            return MaskLaying::Uvs;
        }
        let (_, turn, _) = first.world_from_object.to_scale_rotation_translation();
        let turn = DQuat::from_mat3(&view.rotation()) * turn;
        let bounds = first.mesh.bounds();
        MaskLaying::Straight(StraightLaying::around(bounds.center(), bounds.radius, turn))
    }
}

/// Corner of a triangle in the picture.
#[derive(Clone, Copy, Debug)]
struct SeenCorner {
    clip: DVec4,
    pixel: DVec2,
    depth: f64,
}

/// The picture as far as strokes need it.
struct SeenPicture<'v> {
    view: &'v View,
    size: DVec2,
}

impl SeenPicture<'_> {
    /// A place in world space; `None` behind the eye.
    fn corner(&self, world: DVec4) -> Option<SeenCorner> {
        let clip = self.view.clip_from_world * world;
        let depth = -(self.view.camera_from_world * world).z;
        Some(SeenCorner { clip, pixel: self.pixel(clip)?, depth })
    }

    fn pixel(&self, clip: DVec4) -> Option<DVec2> {
        let at = dvec2(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w) * self.size;
        (clip.w > 1e-9 && at.is_finite()).then_some(at)
    }
}

/// Shares of the texels of a mask that a stroke covers, 0 to 1, rows from the top.
pub(super) fn cover(
    view: &View,
    objects: &[MaskObject],
    stroke: &MaskStroke,
    (size, laying): ([u32; 2], &MaskLaying),
) -> Vec<f32> {
    let mut shares = vec![0.0; size[0] as usize * size[1] as usize];
    let picture =
        SeenPicture { view, size: dvec2(view.viewport[0].into(), view.viewport[1].into()) };
    let points = stroke.thinned();
    let (Some(low), Some(high)) = (
        points.iter().copied().reduce(DVec2::min).map(|low| low - stroke.radius),
        points.iter().copied().reduce(DVec2::max).map(|high| high + stroke.radius),
    ) else {
        return shares;
    };
    let depths = DepthBuffer::of(&picture, objects);
    for object in objects {
        let is_mirrored = object.world_from_object.determinant() < 0.0;
        for corners in object.worn.iter().flat_map(|range| triangles(&object.mesh, range.clone())) {
            let Some(seen) = seen_triangle(&picture, object, corners) else { continue };
            let [a, b, c] = seen.map(|corner| corner.pixel);
            // Pixels run downward: what faces the eye turns the other way.
            let is_front = ((b - a).perp_dot(c - a) < 0.0) != is_mirrored;
            let (least, most) = (a.min(b).min(c), a.max(b).max(c));
            if !is_front || least.cmpgt(high).any() || most.cmplt(low).any() {
                continue;
            }
            let uv = corners.map(|index| {
                let uv = object.uv(index, laying);
                dvec2(uv.x * f64::from(size[0]), (1.0 - uv.y) * f64::from(size[1]))
            });
            each_texel(uv, size, |texel, weights| {
                let mix = |of: fn(&SeenCorner) -> DVec4| {
                    (0..3).map(|corner| of(&seen[corner]) * weights[corner]).sum::<DVec4>()
                };
                let depth: f64 = (0..3).map(|at| seen[at].depth * weights[at]).sum();
                let Some(pixel) = picture.pixel(mix(|corner| corner.clip)) else { return };
                let share = stroke.share(distance(&points, pixel));
                if share > 0.0 && depths.sees(pixel, depth) {
                    let known: &mut f32 = &mut shares[texel];
                    *known = known.max(share as f32);
                }
            });
        }
    }
    shares
}

fn triangles(mesh: &Mesh, range: Range<usize>) -> impl Iterator<Item = [u32; 3]> + '_ {
    let indices = mesh.indices.get(range).unwrap_or_default();
    indices.as_chunks::<3>().0.iter().copied()
}

fn seen_triangle(
    picture: &SeenPicture<'_>,
    object: &MaskObject,
    corners: [u32; 3],
) -> Option<[SeenCorner; 3]> {
    let [a, b, c] = corners.map(|index| picture.corner(object.corner(index)));
    Some([a?, b?, c?])
}

/// Distance of a point from a path.
fn distance(points: &[DVec2], at: DVec2) -> f64 {
    let first = points.first().map_or(f64::INFINITY, |first| first.distance(at));
    let of = |ends: &[DVec2]| {
        let way = ends[1] - ends[0];
        let t = (at - ends[0]).dot(way) / way.length_squared().max(1e-12);
        (ends[0] + way * t.clamp(0.0, 1.0)).distance(at)
    };
    points.windows(2).map(of).fold(first, f64::min)
}

/// Calls `tell` for each texel of a triangle in texels, repeated as UVs repeat: with its index and
/// the weights of the corners.
fn each_texel(uv: [DVec2; 3], size: [u32; 2], mut tell: impl FnMut(usize, [f64; 3])) {
    let [a, b, c] = uv;
    let area = (b - a).perp_dot(c - a);
    let low = (a.min(b).min(c) - 1.5).floor();
    let high = (a.max(b).max(c) + 1.5).ceil();
    let extent = high - low;
    // UVs that repeat the mask many times over have no texel of their own to paint.
    let most = 4.0 * f64::from(size[0]) * f64::from(size[1]);
    if area.abs() < 1e-12 || !extent.is_finite() || extent.x * extent.y > most {
        return;
    }
    for row in 0..extent.y as u32 {
        for column in 0..extent.x as u32 {
            let at = low + dvec2(f64::from(column) + 0.5, f64::from(row) + 0.5);
            let whole = [(b - at).perp_dot(c - at), (c - at).perp_dot(a - at)].map(|x| x / area);
            let weights = [whole[0], whole[1], 1.0 - whole[0] - whole[1]];
            let inner = weights.map(|weight| weight.max(0.0));
            let sum: f64 = inner.iter().sum();
            let inner = inner.map(|weight| weight / sum);
            let nearest = a * inner[0] + b * inner[1] + c * inner[2];
            if nearest.distance_squared(at) > 1.0 {
                continue;
            }
            let wrapped = |x: f64, side: u32| x.floor().rem_euclid(f64::from(side)) as usize;
            let [x, y] = [wrapped(at.x, size[0]), wrapped(at.y, size[1])];
            tell(y * size[0] as usize + x, inner);
        }
    }
}

/// Depths of what is seen, a few pixels a cell.
struct DepthBuffer {
    size: [usize; 2],
    /// Number of cells to a pixel.
    scale: f64,
    depths: Vec<f64>,
    bias: f64,
}

impl DepthBuffer {
    fn of(picture: &SeenPicture<'_>, objects: &[MaskObject]) -> Self {
        let scale = (DEPTH_SIDE / picture.size.max_element().max(1.0)).min(1.0);
        let size = (picture.size * scale).ceil().max(DVec2::ONE);
        let size = [size.x as usize, size.y as usize];
        let depths = vec![f64::INFINITY; size[0] * size[1]];
        let mut buffer = Self { size, scale, depths, bias: 0.0 };
        let mut range = [f64::INFINITY, f64::NEG_INFINITY];
        for object in objects {
            for corners in triangles(&object.mesh, 0..object.mesh.indices.len()) {
                let Some(seen) = seen_triangle(picture, object, corners) else { continue };
                for corner in &seen {
                    range = [range[0].min(corner.depth), range[1].max(corner.depth)];
                }
                buffer.draw(&seen, picture.view.is_perspective);
            }
        }
        buffer.bias = (DEPTH_BIAS * (range[1] - range[0])).max(1e-9);
        buffer
    }

    fn draw(&mut self, seen: &[SeenCorner; 3], is_perspective: bool) {
        let [a, b, c] = seen.map(|corner| corner.pixel * self.scale);
        let area = (b - a).perp_dot(c - a);
        let most = dvec2(self.size[0] as f64, self.size[1] as f64) - 1.0;
        let low = (a.min(b).min(c) - 0.5).ceil().clamp(DVec2::ZERO, most + 1.0);
        let high = (a.max(b).max(c) - 0.5).floor().min(most);
        if area.abs() < 1e-12 || low.cmpgt(high).any() {
            return;
        }
        // Over the picture, depth goes evenly in parallel projection, and its inverse in
        // perspective.
        let even = |depth: f64| if is_perspective { 1.0 / depth.max(1e-9) } else { depth };
        let depths = seen.map(|corner| even(corner.depth));
        for y in low.y as usize..=high.y as usize {
            for x in low.x as usize..=high.x as usize {
                let at = dvec2(x as f64 + 0.5, y as f64 + 0.5);
                let weights = [(b - at).perp_dot(c - at), (c - at).perp_dot(a - at)];
                let [first, second] = weights.map(|weight| weight / area);
                let third = 1.0 - first - second;
                if first < 0.0 || second < 0.0 || third < 0.0 {
                    continue;
                }
                let mixed = depths[0] * first + depths[1] * second + depths[2] * third;
                let known = &mut self.depths[y * self.size[0] + x];
                *known = known.min(even(mixed));
            }
        }
    }

    /// True if nothing hides a place at a pixel: it is no deeper than the deepest of the cells
    /// around, as a slope within them needs.
    fn sees(&self, pixel: DVec2, depth: f64) -> bool {
        let at = (pixel * self.scale).floor();
        let [x, y] = [at.x as isize, at.y as isize];
        let around = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| [x + dx, y + dy]));
        let depths = around.filter_map(|[x, y]| {
            let [x, y] = [usize::try_from(x).ok()?, usize::try_from(y).ok()?];
            let is_there = x < self.size[0] && y < self.size[1];
            let depth = is_there.then(|| self.depths[y * self.size[0] + x])?;
            depth.is_finite().then_some(depth)
        });
        depths.reduce(f64::max).is_none_or(|deepest| depth <= deepest + self.bias)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Camera, Projection};

    /// A square of side 2 at a depth, which faces the eye, with the whole of the UVs.
    fn square(z: f32, side: f32) -> MaskObject {
        let half = side / 2.0;
        let corners = [[-half, -half], [half, -half], [half, half], [-half, half]];
        let mesh = Mesh {
            positions: corners.map(|[x, y]| [x, y, z]).to_vec(),
            uvs: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            indices: vec![0, 1, 2, 0, 2, 3],
            has_uvs: true,
            ..Mesh::default()
        };
        let world_from_object = DMat4::IDENTITY;
        MaskObject {
            mesh: Arc::new(mesh),
            world_from_object,
            worn: std::iter::once(0..6).collect(),
        }
    }

    /// A view of 100 by 100 pixels that the square of side 2 fills.
    fn view() -> View {
        let camera =
            Camera { projection: Projection::Orthographic, height: 2.0, ..Camera::default() };
        View::new(&camera, [100, 100], DVec3::ZERO, 4.0)
    }

    fn stroke(points: &[[f64; 2]]) -> MaskStroke {
        let points = points.iter().map(|point| DVec2::from(*point)).collect();
        MaskStroke { points, radius: 10.0, hardness: 0.5, shows: true }
    }

    fn by_uvs(side: u32) -> ([u32; 2], &'static MaskLaying) {
        ([side, side], &MaskLaying::Uvs)
    }

    #[test]
    fn a_mesh_without_uvs_is_painted_straight_through_as_it_is_seen() {
        let turned = DMat4::from_rotation_z(0.5) * DMat4::from_scale(DVec3::splat(0.5));
        let with = MaskObject { world_from_object: turned, ..square(0.0, 2.0) };
        let bare = Mesh { uvs: Vec::new(), has_uvs: false, ..Mesh::clone(&with.mesh) };
        let object = MaskObject { mesh: Arc::new(bare), ..with.clone() };
        let laying = MaskObject::laying(std::slice::from_ref(&object), &view());
        let MaskLaying::Straight(straight) = &laying else { panic!("{laying:?}") };
        assert!(straight.is_of_object && straight.turn.angle_between(DQuat::IDENTITY) > 0.49);
        let at = stroke(&[[60.0, 50.0]]);
        let found = cover(&view(), std::slice::from_ref(&object), &at, ([64, 64], &laying));
        // The middle of the stroke lies a tenth of the picture to the right of the middle, where a
        // world of 2 by 2 has 0.2, and the object 0.4 of its own units.
        let reach = object.mesh.bounds().radius;
        let column = (64.0 * (0.5 + 0.5 * 0.4 / reach)) as usize;
        let middle: Vec<usize> = (0..64).filter(|x| found[31 * 64 + x] > 0.5).collect();
        assert!(middle.contains(&column) && middle.len() < 16, "{middle:?} {column}");
        assert!(found[32 * 64 + 4] == 0.0);
        let mixed = [object, with];
        assert_eq!(MaskObject::laying(&mixed, &view()), MaskLaying::Uvs, "one of them has UVs");
    }

    #[test]
    fn a_stroke_covers_the_texels_that_are_seen_under_it() {
        // From a quarter to a half of the width, a quarter from the top.
        let found =
            cover(&view(), &[square(0.0, 2.0)], &stroke(&[[25.0, 25.0], [50.0, 25.0]]), by_uvs(50));
        let at = |x: usize, y: usize| found[y * 50 + x];
        assert_eq!((at(12, 12), at(18, 12), at(24, 12)), (1.0, 1.0, 1.0));
        assert!((0.2..0.8).contains(&at(18, 16)), "{}", at(18, 16));
        assert_eq!((at(18, 19), at(35, 12), at(18, 40)), (0.0, 0.0, 0.0));
    }

    #[test]
    fn what_is_hidden_or_turned_away_is_not_painted() {
        let over = MaskObject { worn: Vec::new(), ..square(1.0, 1.0) };
        let at = stroke(&[[50.0, 50.0]]);
        let hidden = cover(&view(), &[square(0.0, 2.0), over], &at, by_uvs(20));
        assert_eq!(hidden, vec![0.0; 400]);
        let turned = DMat4::from_rotation_y(std::f64::consts::PI);
        let back = MaskObject { world_from_object: turned, ..square(0.0, 2.0) };
        assert_eq!(cover(&view(), &[back], &at, by_uvs(20)), vec![0.0; 400]);
        let none = cover(&view(), &[square(0.0, 2.0)], &stroke(&[]), by_uvs(20));
        assert_eq!(none, vec![0.0; 400], "a stroke without points");
    }

    #[test]
    fn uvs_that_repeat_are_painted_in_the_one_mask() {
        let mut repeated = square(0.0, 2.0);
        let uvs = vec![[1.0, 1.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0]];
        repeated.mesh = Arc::new(Mesh { uvs, ..Mesh::clone(&repeated.mesh) });
        let at = stroke(&[[25.0, 25.0]]);
        let found = cover(&view(), &[repeated], &at, by_uvs(50));
        assert_eq!(found, cover(&view(), &[square(0.0, 2.0)], &at, by_uvs(50)));
    }
}
