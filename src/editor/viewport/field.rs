//! Angle u of a layer at every pixel of a surface, and the lines of equal angle (BADF figure 3).

use std::collections::HashMap;

use glam::{DVec3, Vec3};

use super::surface::Surface;
use crate::compile::LightValues;
use crate::document::{Light, LightFrames, LightKind};
use crate::fields::layer::SelectedLayer;
use crate::placing::Parametrization;
use crate::state::session::Session;

/// Angle of a pixel that shows no surface.
const NOTHING: f32 = f32::NAN;

/// Angle of each pixel after the warp; NaN where no surface is.
#[derive(Debug, Default)]
pub(super) struct Field {
    size: [usize; 2],
    pub(super) angles: Vec<f32>,
}

/// Direction or position of a light.
pub(super) enum LightPlace {
    Far(Vec3),
    Near(Vec3),
}

impl LightPlace {
    /// Place of a light whose values these are.
    pub(super) fn of(light: &LightValues) -> Self {
        match light.kind {
            LightKind::Directional => Self::Far(light.direction().as_vec3()),
            LightKind::Point | LightKind::Spot => Self::Near(light.position().as_vec3()),
        }
    }

    /// Unit direction from a position toward the light.
    pub(super) fn at(&self, position: Vec3) -> Vec3 {
        match self {
            Self::Far(direction) => *direction,
            Self::Near(light) => (*light - position).normalize_or(Vec3::Z),
        }
    }
}

/// Values of a light in a view.
pub(super) fn light_values(light: &Light, session: &Session, surface: &Surface) -> LightValues {
    let camera_from_world = surface.camera_from_world();
    LightValues::new(light, &LightFrames { camera_from_world, ..session.keys().light_frames() })
}

impl Field {
    /// Angles of a layer lit by `light`, and the pixel nearest to the light with its angle before
    /// the warp.
    pub(super) fn new(
        surface: &Surface,
        layer: &SelectedLayer,
        light: &LightValues,
    ) -> (Self, Option<(usize, f32)>) {
        let toward = LightPlace::of(light);
        let rotation = surface.camera_from_world().as_mat3();
        let own = light.own_from_world.as_mat3();
        let angle = |pixel: usize| {
            let normal = surface.normals[pixel];
            if normal == Vec3::ZERO {
                return NOTHING;
            }
            let l = toward.at(surface.positions[pixel]);
            match layer.shading {
                Parametrization::Diffuse => between(normal, l),
                Parametrization::Specular => {
                    let view = surface.toward_viewer(pixel);
                    between((2.0 * normal.dot(view) * normal - view).normalize_or(normal), l)
                }
                Parametrization::HalfVector => {
                    between(normal, (l + surface.toward_viewer(pixel)).normalize_or(normal))
                }
                Parametrization::ScreenAligned => between(rotation * normal, own * l),
            }
        };
        let mut angles: Vec<f32> = (0..surface.normals.len()).map(angle).collect();
        let least = angles.iter().copied().enumerate().filter(|(_, angle)| !angle.is_nan());
        let least = least.min_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((slope, amount)) = layer.warp.filter(|warp| warp.1 != 0.0)
            && let Some(kappa) = &surface.kappa
        {
            let (slope, amount) = (slope as f32, amount as f32);
            for (angle, kappa) in angles.iter_mut().zip(kappa) {
                // The warp is that of `angle_shifted`, so that fully lit parts are the same as in
                // the picture.
                *angle =
                    (*angle - (kappa * slope).tanh() * amount).clamp(0.0, std::f32::consts::PI);
            }
        }
        (Self { size: surface.size, angles }, least)
    }

    /// Angle at a place of the picture, in parts of its size: interpolated between pixels of one
    /// piece of surface; otherwise that of the nearest pixel that has one.
    pub(super) fn at(&self, surface: &Surface, place: [f32; 2]) -> Option<f32> {
        let [width, height] = self.size;
        let (x, y) = (place[0] * width as f32 - 0.5, place[1] * height as f32 - 0.5);
        if x >= 0.0 && y >= 0.0 && x < width as f32 - 1.0 && y < height as f32 - 1.0 {
            let first = y as usize * width + x as usize;
            if is_cell(surface, first) {
                let (s, t) = (x.fract(), y.fract());
                let mix = |a: f32, b: f32, t: f32| a + (b - a) * t;
                let row = |begin: usize| mix(self.angles[begin], self.angles[begin + 1], s);
                return Some(mix(row(first), row(first + width), t));
            }
        }
        surface.nearest(place).map(|pixel| self.angles[pixel])
    }

    /// Lines along which the angle is `level`, in parts of the picture's size. Hidden parts are
    /// left out, and no line crosses from one piece of surface to another behind it.
    pub(super) fn lines(&self, surface: &Surface, level: f32) -> Vec<Line> {
        let [width, height] = self.size;
        let mut joints = EdgeJoints::default();
        for y in 0..height.saturating_sub(1) {
            for x in 0..width - 1 {
                let first = y * width + x;
                let corners = [first, first + 1, first + width + 1, first + width]
                    .map(|pixel| self.angles[pixel]);
                let above = corners.map(|angle| angle > level);
                if above[0] == above[1] && above[1] == above[2] && above[2] == above[3]
                    || !is_cell(surface, first)
                {
                    continue;
                }
                // Edges of a cell run clockwise from the upper one; an edge is named by its pixel
                // and its direction.
                let edges = [2 * first, 2 * (first + 1) + 1, 2 * (first + width), 2 * first + 1];
                let crossed = (0..4).filter(|&edge| above[edge] != above[(edge + 1) % 4]);
                let crossed: Vec<usize> = crossed.map(|edge| edges[edge]).collect();
                match crossed[..] {
                    [a, b] => joints.join(a, b),
                    [a, b, c, d] => {
                        let is_middle_above = corners.iter().sum::<f32>() > 4.0 * level;
                        if is_middle_above == above[0] {
                            joints.join(a, b);
                            joints.join(c, d);
                        } else {
                            joints.join(d, a);
                            joints.join(b, c);
                        }
                    }
                    _ => {}
                }
            }
        }
        let point = |edge: usize| {
            let (pixel, is_down) = (edge / 2, edge % 2 == 1);
            let other = if is_down { pixel + width } else { pixel + 1 };
            let (a, b) = (self.angles[pixel], self.angles[other]);
            let t = ((level - a) / (b - a)).clamp(0.0, 1.0);
            let (x, y) = ((pixel % width) as f32 + 0.5, (pixel / width) as f32 + 0.5);
            let (x, y) = if is_down { (x, y + t) } else { (x + t, y) };
            [x / width as f32, y / height as f32]
        };
        joints
            .chains()
            .into_iter()
            .map(|(edges, is_closed)| Line {
                points: edges.into_iter().map(point).collect(),
                is_closed,
            })
            .collect()
    }
}

/// Line of equal angle.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Line {
    /// Points of the line, in parts of the picture's size.
    pub(super) points: Vec<[f32; 2]>,
    pub(super) is_closed: bool,
}

/// True if a pixel, its right, its lower and its lower right neighbor belong to one piece of
/// surface.
fn is_cell(surface: &Surface, first: usize) -> bool {
    let links = &surface.links;
    links[first] == 3 && links[first + 1] & 2 != 0 && links[first + surface.size[0]] & 1 != 0
}

/// Angle between two unit vectors, without the loss of precision that an arc cosine has near 0 and
/// pi.
fn between(d: Vec3, l: Vec3) -> f32 {
    let cosine = d.dot(l);
    if cosine.abs() < 0.99 { cosine.acos() } else { f32::atan2(d.cross(l).length(), cosine) }
}

/// Crossed edges, each with the at most two that it is joined to.
#[derive(Default)]
struct EdgeJoints {
    of: HashMap<usize, [Option<usize>; 2]>,
    /// Edges in the order in which they were found, so that lines are the same each time.
    order: Vec<usize>,
}

impl EdgeJoints {
    fn join(&mut self, a: usize, b: usize) {
        for (from, to) in [(a, b), (b, a)] {
            let ends = self.of.entry(from).or_insert_with(|| {
                self.order.push(from);
                [None; 2]
            });
            let free = usize::from(ends[0].is_some());
            ends[free] = Some(to);
        }
    }

    /// Chains of joined edges; the flag is true for closed ones. Open chains come first.
    fn chains(mut self) -> Vec<(Vec<usize>, bool)> {
        let order = std::mem::take(&mut self.order);
        let mut chains = Vec::new();
        for wants_ends in [true, false] {
            for &start in &order {
                let is_end = self.of.get(&start).is_some_and(|ends| ends[1].is_none());
                if self.of.contains_key(&start) && is_end == wants_ends {
                    chains.push((self.walk(start), !wants_ends));
                }
            }
        }
        chains
    }

    fn walk(&mut self, start: usize) -> Vec<usize> {
        let mut chain = vec![start];
        let mut ends = self.of.remove(&start).unwrap_or_default();
        while let Some(next) = ends.into_iter().flatten().find(|next| self.of.contains_key(next)) {
            ends = self.of.remove(&next).unwrap_or_default();
            chain.push(next);
        }
        chain
    }
}

/// Direction of a light that puts the middle of the layer's lit part at a pixel: toward the light,
/// world space.
pub(super) fn direction_at(
    surface: &Surface,
    pixel: usize,
    shading: Parametrization,
    light: &LightValues,
) -> DVec3 {
    let normal = surface.normals[pixel].as_dvec3();
    let view = surface.toward_viewer(pixel).as_dvec3();
    match shading {
        Parametrization::Diffuse => normal,
        Parametrization::Specular | Parametrization::HalfVector => {
            2.0 * normal.dot(view) * normal - view
        }
        // The normal in camera axes is compared with the light in its own frame.
        Parametrization::ScreenAligned => {
            light.own_from_world.transpose() * (surface.camera_from_world() * normal)
        }
    }
}
