//! Middle of a highlight on the visible surface: the place whose normal is the middle direction of
//! the layer, on the largest piece of surface that the highlight covers.
//!
//! A scan has such places by the dozen, so normals are averaged over a small window first, and a
//! place in a wrinkle, where a pixel or two are lit, gives way to one on a patch that people see.

use std::sync::Arc;

use eframe::egui::{Vec2, vec2};
use glam::{DVec3, Vec3};

use crate::fields::layer::HighlightShape;
use crate::viewport::field::LightPlace;
use crate::viewport::surface::Surface;

/// Half of the side of the window that normals are averaged over, in pixels of the surface.
const WINDOW: usize = 3;
/// Angle from the eye's half-vector beyond which nothing is moved: its tangent has no end.
const LEAST_COSINE: f64 = 0.05;
/// Angles, in radians, that a place as far from the last one as the picture is wide counts for, and
/// a place on a patch much smaller than the largest one: where there is no last place, and where a
/// handle that jumped would be worse than one on a small patch.
const AWAY: f64 = 0.15;
const SMALL_AT_FIRST: f64 = 0.15;
const SMALL_LATER: f64 = 0.03;
/// Angle of the normals around the middle, in radians, by which the curving of the surface is
/// measured.
const MEASURED: f32 = 0.25;
/// Ways on the screen that a turn of the normals by a radian takes, in heights of the picture: the
/// handles stay apart on a small object, and near on a flat one.
const SCALE: [f32; 2] = [0.1, 0.8];

/// Middle of a highlight on a surface.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Middle {
    pub(super) pixel: usize,
    /// Axes on the screen that the layer's own have before they are turned: right and upright.
    pub(super) axes: [Vec2; 2],
    /// True if the highlight is seen around this place; otherwise it lies behind the rim or where
    /// the surface has no such normal, and this is the nearest place to it.
    pub(super) is_seen: bool,
    /// Way on the screen that a turn of the normals by a radian takes, in heights of the picture.
    pub(super) scale: f32,
}

/// Direction of a highlight's middle, and its shape around that.
#[derive(Clone, Copy)]
pub(super) struct WantedMiddle<'a> {
    pub(super) light: &'a LightPlace,
    /// Distances that the highlight is moved, to the right and upward.
    pub(super) moved: [f64; 2],
    pub(super) shape: &'a HighlightShape,
}

/// Surface with normals that are averaged over a small window.
pub(super) struct SmoothSurface {
    pub(super) surface: Arc<Surface>,
    /// Averaged normals; 0 where there is no surface.
    normals: Vec<Vec3>,
}

impl SmoothSurface {
    pub(super) fn new(surface: Arc<Surface>) -> Self {
        let normals = averaged(&surface);
        Self { surface, normals }
    }

    /// The place of a highlight's middle, near the last one, `before`, if there was one; `None`
    /// where no surface is seen.
    pub(super) fn middle(
        &self,
        wanted: WantedMiddle<'_>,
        before: Option<[f32; 2]>,
    ) -> Option<Middle> {
        let surface = &*self.surface;
        let fits: Vec<PixelFit> =
            (0..self.normals.len()).map(|pixel| self.fit(wanted, pixel)).collect();
        let is_lit: Vec<bool> = fits.iter().map(|fit| fit.is_lit).collect();
        let is_seen = is_lit.contains(&true);
        let patches = patch_sizes(&is_lit, &surface.links, surface.size[0]);
        let largest = patches.iter().copied().max().unwrap_or_default().max(1);
        let smallness = if before.is_some() { SMALL_LATER } else { SMALL_AT_FIRST };
        let cost = |pixel: usize| {
            let away = before.map_or(0.0, |[x, y]| {
                let [px, py] = surface.place_of(pixel);
                f64::from((px - x).hypot(py - y))
            });
            let share = f64::from(patches[pixel]) / f64::from(largest);
            fits[pixel].angle + AWAY * away + smallness * (1.0 - share)
        };
        let places = (0..self.normals.len())
            .filter(|&pixel| self.normals[pixel] != Vec3::ZERO && (is_lit[pixel] || !is_seen));
        let costs = places.map(|pixel| (pixel, cost(pixel)));
        let (pixel, _) = costs.min_by(|a, b| a.1.total_cmp(&b.1))?;
        let [x, y, _] = axes_around(self.direction(wanted, pixel));
        let on_screen = |axis: DVec3| {
            let seen = surface.camera_from_world() * axis;
            vec2(seen.x as f32, -seen.y as f32)
        };
        let axes = [on_screen(x), on_screen(y)];
        Some(Middle { pixel, axes, is_seen, scale: self.scale_at(pixel) })
    }

    /// Middle direction of the highlight as a pixel has it.
    fn direction(&self, wanted: WantedMiddle<'_>, pixel: usize) -> DVec3 {
        let [x, y, z] = half_axes(&self.surface, wanted.light, pixel);
        let [across, up] = wanted.moved;
        (z + across * x + up * y).normalize_or(z)
    }

    fn fit(&self, wanted: WantedMiddle<'_>, pixel: usize) -> PixelFit {
        let normal = self.normals[pixel].as_dvec3();
        if normal == DVec3::ZERO {
            return PixelFit { angle: f64::INFINITY, is_lit: false };
        }
        let middle = self.direction(wanted, pixel);
        let angle = normal.angle_between(middle);
        let [x, y, _] = axes_around(middle);
        let aside = DVec3::new(normal.dot(x), normal.dot(y), 0.0).normalize_or_zero() * angle;
        PixelFit { angle, is_lit: wanted.shape.covers([aside.x, aside.y]) }
    }

    /// Way on the screen that a turn of the normals by a radian takes around a pixel, in heights of
    /// the picture: by the area in which the normals turn no farther than a small angle.
    fn scale_at(&self, pixel: usize) -> f32 {
        let normal = self.normals[pixel];
        let is_near = |other: &Vec3| *other != Vec3::ZERO && other.dot(normal) > MEASURED.cos();
        let is_near: Vec<bool> = self.normals.iter().map(is_near).collect();
        let area = patch_sizes(&is_near, &self.surface.links, self.surface.size[0])[pixel] as f32;
        let radius = (area / std::f32::consts::PI).sqrt() / self.surface.size[1] as f32;
        (radius / MEASURED).clamp(SCALE[0], SCALE[1])
    }

    /// Distances that move the highlight of a light to the surface nearest to a place of the
    /// picture.
    pub(super) fn moved_to(&self, light: &LightPlace, place: [f32; 2]) -> Option<[f64; 2]> {
        let pixel = self.surface.nearest(place)?;
        let normal = self.normals.get(pixel)?.as_dvec3();
        let [x, y, z] = half_axes(&self.surface, light, pixel);
        let toward = normal.dot(z);
        (toward > LEAST_COSINE).then(|| [normal.dot(x) / toward, normal.dot(y) / toward])
    }
}

/// Angle of a pixel's normal from the highlight's middle, in radians, and true if the highlight
/// covers it.
#[derive(Clone, Copy, Debug)]
struct PixelFit {
    angle: f64,
    is_lit: bool,
}

/// Number of pixels of the piece that each marked pixel belongs to, joined by the links of a
/// surface; 0 for the others.
fn patch_sizes(is_marked: &[bool], links: &[u8], width: usize) -> Vec<u32> {
    let mut sizes = vec![0; is_marked.len()];
    let mut is_seen = vec![false; is_marked.len()];
    let (mut patch, mut open) = (Vec::new(), Vec::new());
    for start in 0..is_marked.len() {
        if !is_marked[start] || is_seen[start] {
            continue;
        }
        is_seen[start] = true;
        patch.clear();
        open.push(start);
        while let Some(pixel) = open.pop() {
            patch.push(pixel);
            let to_left = pixel.checked_sub(1).filter(|&left| links[left] & 1 != 0);
            let above = pixel.checked_sub(width).filter(|&above| links[above] & 2 != 0);
            let to_right = (links[pixel] & 1 != 0).then_some(pixel + 1);
            let below = (links[pixel] & 2 != 0).then_some(pixel + width);
            for next in [to_left, above, to_right, below].into_iter().flatten() {
                if is_marked[next] && !is_seen[next] {
                    is_seen[next] = true;
                    open.push(next);
                }
            }
        }
        let size = u32::try_from(patch.len()).unwrap_or(u32::MAX);
        patch.iter().for_each(|&pixel| sizes[pixel] = size);
    }
    sizes
}

/// Axes around the half-vector of a pixel, and that itself: right, upright, toward.
fn half_axes(surface: &Surface, light: &LightPlace, pixel: usize) -> [DVec3; 3] {
    let toward = light.at(surface.positions[pixel]) + surface.toward_viewer(pixel);
    axes_around(toward.as_dvec3().normalize_or(DVec3::Z))
}

/// Unit axes to the right and upright around a direction, and that itself, as the node *Axes
/// around a direction* has them.
fn axes_around(toward: DVec3) -> [DVec3; 3] {
    let across = DVec3::Y.cross(toward);
    let x = match across.length_squared() > 1e-8 {
        true => across.normalize(),
        false => DVec3::X.cross(toward).normalize_or(DVec3::X),
    };
    [x, toward.cross(x), toward]
}

/// Normals of a surface, averaged over a small window; 0 where there is no surface.
fn averaged(surface: &Surface) -> Vec<Vec3> {
    let [width, height] = surface.size;
    let along = |of: &[Vec3], step: usize, count: usize, at: usize, index: usize| {
        let (back, ahead) = (WINDOW.min(at), WINDOW.min(count - 1 - at));
        (0..=back + ahead).map(|k| of[index - back * step + k * step]).sum::<Vec3>()
    };
    let index = |pixel: usize| (pixel % width, pixel / width);
    let rows: Vec<Vec3> = (0..surface.normals.len())
        .map(|pixel| along(&surface.normals, 1, width, index(pixel).0, pixel))
        .collect();
    let sums = (0..rows.len()).map(|pixel| along(&rows, width, height, index(pixel).1, pixel));
    let is_covered = |pixel: usize| surface.is_covered(pixel);
    sums.enumerate()
        .map(
            |(pixel, sum)| {
                if is_covered(pixel) { sum.normalize_or(Vec3::ZERO) } else { Vec3::ZERO }
            },
        )
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_are_those_of_the_node() {
        for toward in [DVec3::Z, DVec3::new(0.4, 0.3, 0.6).normalize(), DVec3::NEG_X] {
            let [x, y, z] = axes_around(toward);
            assert!(x.dot(y).abs() + y.dot(z).abs() + z.dot(x).abs() < 1e-12, "{toward}");
            assert!(x.cross(y).dot(z) > 1.0 - 1e-12 && y.y >= 0.0, "{toward}: upright");
        }
        assert_eq!(axes_around(DVec3::Z)[..2], [DVec3::X, DVec3::Y]);
        assert!(axes_around(DVec3::Y).iter().all(|axis| axis.is_finite()));
    }

    #[test]
    fn patches_are_joined_by_links_alone() {
        // Two rows of four pixels; the surface is torn between the second and the third column.
        let links = [3, 2, 3, 2, 1, 0, 1, 0];
        let is_marked = [true, true, true, false, false, true, true, true];
        assert_eq!(patch_sizes(&is_marked, &links, 4), [3, 3, 3, 0, 0, 3, 3, 3]);
        let all = [true; 8];
        assert_eq!(patch_sizes(&all, &links, 4), [4; 8]);
        assert_eq!(patch_sizes(&[false; 8], &links, 4), [0; 8]);
    }
}
