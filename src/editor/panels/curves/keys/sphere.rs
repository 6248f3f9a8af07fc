//! Sphere of all directions, in perspective: its projection to the screen, and the keys' weights on
//! it as colors.

use eframe::egui::epaint::{Mesh, Vertex};
use eframe::egui::{Color32, Pos2, Shape, Vec2, lerp, vec2};
use glam::DVec3;

use crate::directions::KeyWeights;
use crate::document::{DirectionKeys, KeyScheme};

/// Distance of the eye from the sphere's center, in radii.
const EYE: f64 = 3.4;
/// Numbers of rings and spokes of the mesh that carries the colors.
const RINGS: usize = 22;
const SPOKES: usize = 80;

/// Projection of the sphere: its turn and its place on the screen.
#[derive(Clone, Copy, Debug)]
pub(super) struct Globe {
    pub(super) center: Pos2,
    /// Radius on the screen, in points.
    pub(super) radius: f32,
    right: DVec3,
    up: DVec3,
    toward: DVec3,
}

impl Globe {
    /// Sphere turned by a yaw around the upright axis and a pitch, in radians.
    pub(super) fn new(center: Pos2, radius: f32, [yaw, pitch]: [f64; 2]) -> Self {
        let (sin_yaw, cos_yaw) = yaw.sin_cos();
        let (sin_pitch, cos_pitch) = pitch.sin_cos();
        let toward = DVec3::new(cos_pitch * sin_yaw, sin_pitch, cos_pitch * cos_yaw);
        let right = DVec3::new(cos_yaw, 0.0, -sin_yaw);
        Self { center, radius, right, up: toward.cross(right), toward }
    }

    /// Factor from the plane at distance 1 from the eye, in radii, to the screen, in points.
    fn scale(self) -> f64 {
        f64::from(self.radius) * (EYE * EYE - 1.0).sqrt()
    }

    /// True if a direction lies on the visible side.
    pub(super) fn is_front(self, direction: DVec3) -> bool {
        direction.dot(self.toward) >= 1.0 / EYE
    }

    /// Position of a direction on the screen; directions on the far side are seen through the
    /// sphere.
    pub(super) fn project(self, direction: DVec3) -> Pos2 {
        let scale = self.scale() / (EYE - direction.dot(self.toward));
        let offset =
            [direction.dot(self.right), -direction.dot(self.up)].map(|x| (x * scale) as f32);
        self.center + vec2(offset[0], offset[1])
    }

    /// Direction at a point of the screen, on the near or the far side; beside the sphere the
    /// nearest direction of its rim.
    pub(super) fn direction(self, at: Pos2, is_front: bool) -> DVec3 {
        let offset = at - self.center;
        let inside = offset * (self.radius * 0.999_999 / offset.length().max(self.radius));
        let [x, y] = [inside.x, -inside.y].map(|x| f64::from(x) / self.scale());
        let ray = self.right * x + self.up * y - self.toward;
        let length = ray.length_squared();
        let root = (EYE * EYE - length * (EYE * EYE - 1.0)).max(0.0).sqrt();
        let along = if is_front { EYE - root } else { EYE + root } / length;
        (self.toward * EYE + ray * along).normalize()
    }

    /// Turns a direction to the right and up as seen on the screen, by `steps` times `radians`.
    pub(super) fn nudge(self, direction: DVec3, steps: Vec2, radians: f64) -> DVec3 {
        let moved =
            direction + (self.right * f64::from(steps.x) + self.up * f64::from(steps.y)) * radians;
        moved.try_normalize().unwrap_or(direction)
    }
}

/// Colors of the sphere, kept until the keys or the sphere's turn change.
#[derive(Default)]
pub(super) struct Ground {
    weights: Option<(Vec<[f64; 3]>, KeyScheme, KeyWeights)>,
    turned: [f64; 2],
    inks: Vec<Color32>,
    /// Place in the unit disc, and color, of each vertex.
    vertices: Vec<(Vec2, Color32)>,
}

impl Ground {
    /// Weights of a set's keys as a function of the direction.
    pub(super) fn weights(&mut self, keys: &DirectionKeys) -> &KeyWeights {
        let places: Vec<[f64; 3]> = keys.keys.iter().map(|key| key.direction).collect();
        let is_known =
            |(known, scheme, _): &(Vec<[f64; 3]>, _, _)| *known == places && *scheme == keys.scheme;
        if !self.weights.as_ref().is_some_and(is_known) {
            let directions: Vec<DVec3> = places.iter().map(|&place| place.into()).collect();
            let solved = match keys.by.axes() {
                Some(_) => KeyWeights::at_places(&directions).value,
                None => KeyWeights::new(&directions, keys.scheme).value,
            };
            self.vertices.clear();
            self.weights = Some((places, keys.scheme, solved));
        }
        &self.weights.as_ref().expect("just solved").2
    }

    /// The sphere as a mesh; `inks` holds one color per key, `ground` is the color where no key has
    /// weight.
    pub(super) fn mesh(
        &mut self,
        keys: &DirectionKeys,
        globe: Globe,
        turned: [f64; 2],
        inks: &[Color32],
        ground: Color32,
    ) -> Shape {
        self.weights(keys);
        if self.vertices.is_empty() || self.turned != turned || self.inks != inks {
            self.turned = turned;
            self.inks = inks.to_vec();
            if let Some((_, _, weights)) = &self.weights {
                self.vertices = vertices(weights, turned, inks, ground);
            }
        }
        let mut mesh = Mesh::default();
        for (place, color) in &self.vertices {
            mesh.vertices.push(Vertex::untextured(globe.center + *place * globe.radius, *color));
        }
        for ring in 0..RINGS as u32 {
            for spoke in 0..SPOKES as u32 {
                let at = |ring: u32, spoke: u32| ring * SPOKES as u32 + spoke % SPOKES as u32;
                let (a, b) = (at(ring, spoke), at(ring, spoke + 1));
                let (c, d) = (at(ring + 1, spoke), at(ring + 1, spoke + 1));
                mesh.indices.extend_from_slice(&[a, b, c, c, b, d]);
            }
        }
        Shape::mesh(mesh)
    }
}

fn vertices(
    weights: &KeyWeights,
    turned: [f64; 2],
    inks: &[Color32],
    ground: Color32,
) -> Vec<(Vec2, Color32)> {
    let globe = Globe::new(Pos2::ZERO, 1.0, turned);
    let mut row = vec![0.0; weights.len()];
    let mut found = Vec::with_capacity((RINGS + 1) * SPOKES);
    for ring in 0..=RINGS {
        // Rings are closer together at the rim, where the sphere turns away.
        let radius = (ring as f32 / RINGS as f32 * std::f32::consts::FRAC_PI_2).sin();
        for spoke in 0..SPOKES {
            let place = Vec2::angled(spoke as f32 / SPOKES as f32 * std::f32::consts::TAU) * radius;
            let direction = globe.direction(place.to_pos2(), true);
            weights.weights_into(direction, &mut row);
            let shade = 0.30 + 0.42 * direction.dot(globe.toward) as f32;
            found.push((place, mixed(&row, inks, ground, shade)));
        }
    }
    found
}

/// Mean of the keys' colors by their weights, over the ground.
pub(super) fn mixed(weights: &[f64], inks: &[Color32], ground: Color32, strength: f32) -> Color32 {
    let mut sum = [0.0_f32; 3];
    let mut total = 0.0;
    for (weight, ink) in weights.iter().zip(inks) {
        let weight = *weight as f32;
        total += weight;
        for (sum, part) in sum.iter_mut().zip([ink.r(), ink.g(), ink.b()]) {
            *sum += weight * f32::from(part);
        }
    }
    if total <= 0.0 {
        return ground;
    }
    let own = [ground.r(), ground.g(), ground.b()];
    let [r, g, b] =
        [0, 1, 2].map(|i| lerp(f32::from(own[i])..=sum[i] / total, strength).round() as u8);
    Color32::from_rgb(r, g, b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use eframe::egui::pos2;

    #[test]
    fn every_direction_is_found_where_it_is_drawn() {
        let globe = Globe::new(pos2(100.0, 80.0), 70.0, [0.7, -0.4]);
        for i in 0..200 {
            // Directions on a spiral over the whole sphere.
            let z = 1.0 - (f64::from(i) + 0.5) / 100.0;
            let (sin, cos) = (f64::from(i) * 2.399_963).sin_cos();
            let side = (1.0 - z * z).sqrt();
            let direction = DVec3::new(side * cos, side * sin, z);
            let back = globe.direction(globe.project(direction), globe.is_front(direction));
            assert!(back.distance(direction) < 5e-3, "{direction} {back}");
            assert!(globe.project(direction).distance(globe.center) <= 70.01);
        }
        assert!(
            globe.direction(pos2(400.0, 80.0), true).dot(globe.toward) < 0.31,
            "beside it is the rim"
        );
    }
}
