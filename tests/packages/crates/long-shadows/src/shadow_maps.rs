//! Shadow maps: what lights see of the objects. A directional light has one layer, a lamp has six.

use crate::host::{self, LightFrame, LightSettings};
use crate::math::{self, Matrix4};

/// Least and greatest side of a layer, in texels.
const SIDES: [u32; 2] = [256, 2048];

/// Memory that the layers of all maps may take, and that of a texel in all of them, in bytes.
const MOST_BYTES: u64 = 1 << 28;
const TEXEL_BYTES: u64 = 32;

/// Factor by which a layer is wider than what it shows, so that edges have texels beside them.
const WIDENED: f64 = 1.0 + 1.0 / 32.0;

/// Place of a light that has no map.
const NO_MAP: [f64; 4] = [0.0, 0.0, 1.0, -1.0];

/// A sphere that holds an object, in world space.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sphere {
    pub(crate) center: [f64; 3],
    pub(crate) radius: f64,
}

/// A layer of the maps.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Layer {
    pub(crate) clip_from_world: Matrix4,
    /// Plane whose distance to a point is what the layer stores.
    pub(crate) measure: [f64; 4],
    pub(crate) is_lamp: bool,
}

/// The shadow maps of a picture.
pub(crate) struct ShadowMaps<'a> {
    /// Spheres of what casts shadows.
    spheres: &'a [Sphere],
    /// Number of layers that a texture may have.
    most_layers: usize,
    pub(crate) layers: Vec<Layer>,
    /// Sources of light, each with the place of its map: lights of several objects are one light
    /// where they are the same in the world.
    places: Vec<([f64; 4], [f64; 4])>,
}

impl<'a> ShadowMaps<'a> {
    pub(crate) fn new(spheres: &'a [Sphere], most_layers: u32) -> Self {
        let most_layers = most_layers as usize;
        Self { spheres, most_layers, layers: Vec::new(), places: Vec::new() }
    }

    /// Side of a layer in texels, for a picture of that height.
    pub(crate) fn side(&self, height: u32) -> u32 {
        let [least, most] = SIDES;
        let mut side = (height.max(1) + height / 2).next_power_of_two().clamp(least, most);
        let bytes = |side: u32| u64::from(side).pow(2) * TEXEL_BYTES * self.layers.len() as u64;
        while side > least && bytes(side) > MOST_BYTES {
            side /= 2;
        }
        side
    }

    /// Finds maps for the lights whose shadows the look reads, and writes their places into the
    /// settings.
    pub(crate) fn place(&mut self, settings: &mut host::Settings, _around: &host::Surroundings) {
        let world = frame([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.0; 3]);
        settings.sun_light.shadow_map = self.sun(settings.sun_light, world);
    }

    /// Place of the map of a directional light.
    fn sun(&mut self, light: LightSettings, frame: LightFrame) -> [f64; 4] {
        let [x, y, z] = host::light_in_world(light, frame, 0).direction;
        self.known([x, y, z, 0.0], 1, |spheres, layers| {
            let (layer, place) = sun_layer([x, y, z], spheres);
            layers.push(layer);
            place
        })
    }

    /// Place of the maps of a light that comes from `source`. A light whose layers find no room
    /// has none.
    fn known(
        &mut self,
        source: [f64; 4],
        count: usize,
        add: impl FnOnce(&[Sphere], &mut Vec<Layer>) -> [f64; 3],
    ) -> [f64; 4] {
        if let Some((_, place)) = self.places.iter().find(|(known, _)| *known == source) {
            return *place;
        }
        let first = self.layers.len();
        if first + count > self.most_layers {
            return NO_MAP;
        }
        let [x, y, width] = add(self.spheres, &mut self.layers);
        let place = [x, y, width, first as f64];
        self.places.push((source, place));
        place
    }
}

fn frame(world_from_own: math::Matrix3, origin: [f64; 3]) -> LightFrame {
    LightFrame { world_from_own, origin }
}

/// The layer of a directional light, its middle, and half of its side.
fn sun_layer(toward: [f64; 3], spheres: &[Sphere]) -> (Layer, [f64; 3]) {
    let Sphere { center, radius } = sphere_around(spheres);
    let [right, up] = map_axes(toward);
    let half = WIDENED * radius;
    let middle = [math::dot(right, center), math::dot(up, center)];
    let height = math::dot(toward, center);
    let depth = 1.001 * radius + 1e-5 * math::length(center);
    let rows = [
        row(math::scale(right, 1.0 / half), -middle[0] / half),
        row(math::scale(up, 1.0 / half), -middle[1] / half),
        row(math::scale(toward, -0.5 / depth), 0.5 + 0.5 * height / depth),
        [0.0, 0.0, 0.0, 1.0],
    ];
    let clip_from_world = math::transposed(&rows);
    let layer = Layer { clip_from_world, measure: row(toward, 0.0), is_lamp: false };
    (layer, [middle[0], middle[1], half])
}

/// Axes of a directional light's map, to the right and up (Duff et al. 2017).
fn map_axes([x, y, z]: [f64; 3]) -> [[f64; 3]; 2] {
    let side = if z > -0.4142 { 1.0 } else { -1.0 };
    let a = -1.0 / (side + z);
    let b = x * y * a;
    [[1.0 + side * x * x * a, side * b, -side * x], [b, side + y * y * a, -y]]
}

/// The sphere around spheres, about the middle of their box.
fn sphere_around(spheres: &[Sphere]) -> Sphere {
    let center = std::array::from_fn(|axis| {
        let ends = spheres.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], it| {
            [low.min(it.center[axis] - it.radius), high.max(it.center[axis] + it.radius)]
        });
        0.5 * (ends[0] + ends[1])
    });
    let reach = |it: &Sphere| math::length(math::subtract(it.center, center)) + it.radius;
    Sphere { center, radius: spheres.iter().map(reach).fold(1e-20, f64::max) }
}

/// A row of a matrix.
fn row([x, y, z]: [f64; 3], w: f64) -> [f64; 4] {
    [x, y, z, w]
}
