//! Shadow maps: the scene as lights see it, a layer for each directional light and six for a lamp.
//!
//! `shaders/lib/shadow_map.wgsl` tells what a layer holds and how looks read it. A layer belongs to
//! a light where it stands and to the objects that cast its shadows; lights that stand alike share
//! theirs. A layer's hash tells whether its light or its casters moved.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;

use chiaro_locale::tr;
use glam::{DMat4, DVec3, DVec4};
use indexmap::{IndexMap, IndexSet};

use super::setup::SetupObject;
use super::visibility::ObjectPlacement;
use crate::compile::Uniform;
use crate::diag::Diagnostic;
use crate::document::{LightKind, LightValues};
use crate::geometry::Mesh;
use crate::wgsl::{self, ValidModule};

use super::{PassId, PassWork};

/// Most layers: what every GPU takes.
const MOST_LAYERS: usize = 256;

/// Memory that the layers of both maps may take, in bytes.
const MOST_BYTES: u64 = 1 << 30;

/// Size of a texel in both maps, in bytes.
const TEXEL: u64 = 32;

/// Least and greatest side of a layer, in texels.
const SIDES: [u32; 2] = [256, 2048];

/// Factor by which a layer is wider than what it shows, so that edges have texels beside them.
const WIDENED: f64 = 1.0 + 1.0 / 32.0;

/// Least distance of a lamp's near plane, as a share of the far plane's.
const NEAREST: f64 = 1e-4;

/// Thickness of a flat object, as a share of its size.
const FLAT: f64 = 1e-5;

/// Depth to which others may be sunk into a flat object that lies behind them, as a share of their
/// size.
const SUNK: f64 = 0.1;

/// Number of faces of the cube about a lamp.
const FACES: usize = 6;

/// The scene as lights see it.
#[derive(Clone, Debug, Default)]
pub struct ShadowMaps {
    /// Side of each layer, in texels.
    pub side: u32,
    /// Layers, those of a lamp one after another: +x, -x, +y, -y, +z, -z.
    pub layers: Vec<LightLayer>,
    /// Objects of the scene, by number.
    pub casters: Vec<MapCaster>,
}

/// A layer: what a light sees.
#[derive(Clone, Debug)]
pub struct LightLayer {
    /// The `LightView` uniform of `shaders/lib/light_view.wgsl`.
    pub uniform: Uniform,
    /// Numbers of the objects that are drawn.
    pub casters: Vec<usize>,
    /// Hash of everything that is drawn: the same hash is the same layer.
    pub hash: u64,
}

/// An object that may cast shadows.
#[derive(Clone, Debug)]
pub struct MapCaster {
    /// Mesh of the object.
    pub mesh: Arc<Mesh>,
    /// The `LightCaster` uniform of `shaders/lib/light_view.wgsl`.
    pub uniform: Uniform,
}

impl ShadowMaps {
    /// Hash of everything that is drawn.
    pub fn hash(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.side.hash(&mut hasher);
        self.layers.iter().for_each(|layer| layer.hash.hash(&mut hasher));
        hasher.finish()
    }

    /// Number of layers and of triangles that are drawn into them.
    pub fn counts(&self) -> [u64; 2] {
        let triangles = |number: &usize| self.casters[*number].mesh.indices.len() as u64 / 3;
        let drawn = self.layers.iter().flat_map(|layer| layer.casters.iter().map(triangles));
        [self.layers.len() as u64, drawn.sum()]
    }
}

/// The module of a pass that draws what lights see.
#[derive(Debug)]
pub struct LightModule {
    /// Source of the module, in WGSL.
    pub text: String,
    /// The module as naga validated it.
    pub valid: ValidModule,
    /// Pass whose result the module reads as binding 2, after the uniforms of the layer and of the
    /// object.
    pub reads: Option<PassId>,
}

impl LightModule {
    /// The module of a pass; `None` for other passes.
    ///
    /// # Errors
    /// Where this build lacks the file.
    pub fn of(pass: PassId) -> Result<Option<Self>, Vec<Diagnostic>> {
        let PassWork::Lights { shader } = pass.row().work else { return Ok(None) };
        let text = wgsl::pass(shader, &[])?.text;
        let valid = wgsl::parse(&text).map_err(|error| {
            let message = format!("{shader}: {error}");
            vec![Diagnostic::error("internal-invalid-wgsl", message)]
        })?;
        let reads = pass.row().reads.first().and_then(|read| PassId::from_slug(read.pass));
        Ok(Some(Self { text, valid, reads }))
    }
}

/// Layers that a picture asks for, while lights are placed.
#[derive(Debug, Default)]
pub(super) struct MapPlaces {
    /// Places of lights' maps, by where the light stands and the set of its casters.
    places: IndexMap<([u64; 4], usize), [f64; 4]>,
    layers: Vec<LightLayer>,
}

/// Everything that may stand in the way of light.
#[derive(Clone, Copy)]
pub(super) struct MapScene<'a> {
    pub(super) objects: &'a [SetupObject],
    pub(super) placed: &'a [ObjectPlacement],
    /// Sets of objects that cast some light's shadows, by number and in order.
    pub(super) sets: &'a IndexSet<Vec<usize>>,
}

impl MapScene<'_> {
    /// True for a flat object with all others between it and a directional light, or sunk into it
    /// a little.
    fn is_ground(&self, number: usize, casters: &[usize], toward: DVec3) -> bool {
        let matrix = self.objects[number].world_from_object;
        let bounds = &self.placed[number].bounds;
        let sides = bounds.max - bounds.min;
        let axes = [DVec3::X, DVec3::Y, DVec3::Z];
        let Some(flat) = (0..3).find(|axis| sides[*axis] <= FLAT * sides.max_element()) else {
            return false;
        };
        let along = [axes[(flat + 1) % 3], axes[(flat + 2) % 3]];
        let [a, b] = along.map(|axis| matrix.transform_vector3(axis));
        let Some(normal) = a.cross(b).try_normalize() else { return false };
        let normal = if normal.dot(toward) < 0.0 { -normal } else { normal };
        let plane = normal.dot(matrix.transform_point3(bounds.center()));
        casters.iter().filter(|other| **other != number).all(|other| {
            let matrix = self.objects[*other].world_from_object;
            let height = |corner| normal.dot(matrix.transform_point3(corner)) - plane;
            let ObjectPlacement { bounds, radius, .. } = &self.placed[*other];
            bounds.corners().map(height).into_iter().fold(f64::INFINITY, f64::min) >= -SUNK * radius
        })
    }
}

impl MapPlaces {
    /// Place of the map of a light whose shadows the objects of a set cast:
    /// [`LightValues::shadow_map`].
    pub(super) fn place(
        &mut self,
        scene: &MapScene<'_>,
        light: &LightValues,
        set: usize,
    ) -> [f64; 4] {
        let casters = &scene.sets[set];
        if casters.is_empty() {
            return LightValues::NO_SHADOW_MAP;
        }
        let source = match light.kind {
            LightKind::Directional => light.direction().extend(0.0),
            LightKind::Point | LightKind::Spot => light.position().extend(1.0),
        };
        let key = (source.to_array().map(f64::to_bits), set);
        if let Some(known) = self.places.get(&key) {
            return *known;
        }
        let first = self.layers.len();
        let place = match light.kind {
            LightKind::Directional => self.push_sun(scene, source.truncate(), casters),
            LightKind::Point | LightKind::Spot => {
                self.push_lamp(scene, source.truncate(), casters);
                [0.0, 0.0, WIDENED]
            }
        };
        let place = [place[0], place[1], place[2], first as f64];
        self.places.insert(key, place);
        place
    }

    /// Adds the layer of a directional light, and returns its middle and half of its side.
    fn push_sun(&mut self, scene: &MapScene<'_>, toward: DVec3, casters: &[usize]) -> [f64; 3] {
        // What casts its shadow onto nothing need not fit: a floor may be as large as it likes.
        let cast: Vec<usize> =
            casters.iter().filter(|n| !scene.is_ground(**n, casters, toward)).copied().collect();
        let fitted = if cast.is_empty() { casters } else { &cast };
        let spheres = || fitted.iter().map(|number| &scene.placed[*number]);
        let ends = |axis: DVec3| {
            spheres().fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], sphere| {
                let at = axis.dot(sphere.center);
                [least.min(at - sphere.radius), most.max(at + sphere.radius)]
            })
        };
        // The same circle from everywhere, so that texels keep their size as the light turns.
        let [x, y, z] = [DVec3::X, DVec3::Y, DVec3::Z].map(ends);
        let center = 0.5 * DVec3::new(x[0] + x[1], y[0] + y[1], z[0] + z[1]);
        let reach = |sphere: &ObjectPlacement| center.distance(sphere.center) + sphere.radius;
        let radius = spheres().map(reach).fold(1e-20, f64::max);
        let [right, up] = axes(toward);
        let half = WIDENED * radius;
        let middle = [right.dot(center), up.dot(center)];
        let height = toward.dot(center);
        // Depths hold all that is drawn.
        let reach = |number: &usize| {
            let sphere = &scene.placed[*number];
            toward.dot(sphere.center - center).abs() + sphere.radius
        };
        let deepest = casters.iter().map(reach).fold(radius, f64::max);
        let depth = 1.001 * deepest + 1e-5 * center.length();
        let rows = [
            (right / half).extend(-middle[0] / half),
            (up / half).extend(-middle[1] / half),
            (-toward / (2.0 * depth)).extend(0.5 + height / (2.0 * depth)),
            DVec4::W,
        ];
        self.push(scene, rows, (toward.extend(0.0), false), casters.to_vec());
        [middle[0], middle[1], half]
    }

    /// Adds the six layers of a lamp.
    fn push_lamp(&mut self, scene: &MapScene<'_>, place: DVec3, casters: &[usize]) {
        let axes = [DVec3::X, DVec3::Y, DVec3::Z];
        for face in 0..FACES {
            let axis = face / 2;
            let side = if face % 2 == 0 { 1.0 } else { -1.0 };
            let [right, up] = [axes[(axis + 1) % 3], axes[(axis + 2) % 3]];
            let ahead = side * axes[axis];
            // An object may be seen where its sphere reaches into the face's pyramid.
            let is_seen = |number: &&usize| {
                let ObjectPlacement { center, radius, .. } = scene.placed[**number];
                let way = center - place;
                let depth = ahead.dot(way);
                let beyond = |axis: DVec3| axis.dot(way).abs() - WIDENED * depth;
                let reach = radius * (1.0 + WIDENED * WIDENED).sqrt() * 1.0001;
                depth > -radius && beyond(right) <= reach && beyond(up) <= reach
            };
            let seen: Vec<usize> = casters.iter().filter(is_seen).copied().collect();
            let (mut near, mut far) = (f64::INFINITY, 1e-20_f64);
            for number in &seen {
                let ObjectPlacement { center, radius, .. } = scene.placed[*number];
                let distance = center.distance(place);
                // A face shows what is nearer than its corners are, along its axis.
                near = near.min((distance - radius) / 1.8);
                far = far.max(1.001 * (distance + radius));
            }
            let near = near.min(0.5 * far).max(far * NEAREST);
            let measure = ahead.extend(-ahead.dot(place));
            let depth = far / (far - near);
            let rows = [
                (right / WIDENED).extend(-right.dot(place) / WIDENED),
                (up / WIDENED).extend(-up.dot(place) / WIDENED),
                depth * measure - DVec4::W * (depth * near),
                measure,
            ];
            self.push(scene, rows, (measure, true), seen);
        }
    }

    /// Adds a layer: the rows of its matrix, and the row that measures its nearness.
    fn push(
        &mut self,
        scene: &MapScene<'_>,
        rows: [DVec4; 4],
        (measure, is_lamp): (DVec4, bool),
        casters: Vec<usize>,
    ) {
        let clip = DMat4::from_cols(rows[0], rows[1], rows[2], rows[3]).transpose();
        let mut numbers = clip.to_cols_array().to_vec();
        numbers.extend(measure.to_array());
        numbers.extend([f64::from(u8::from(is_lamp)), self.layers.len() as f64]);
        let mut hasher = DefaultHasher::new();
        numbers.iter().for_each(|number| number.to_bits().hash(&mut hasher));
        for number in &casters {
            let object = &scene.objects[*number];
            (number, Arc::as_ptr(&object.mesh) as usize).hash(&mut hasher);
            let matrix = object.world_from_object.to_cols_array();
            matrix.map(f64::to_bits).hash(&mut hasher);
        }
        let uniform = uniform(numbers);
        self.layers.push(LightLayer { uniform, casters, hash: hasher.finish() });
    }

    /// The maps for a picture of this height, in pixels.
    ///
    /// # Errors
    /// `too-many-shadow-maps` for more layers than a GPU takes.
    pub(super) fn maps(
        self,
        objects: &[SetupObject],
        height: u32,
    ) -> Result<ShadowMaps, Diagnostic> {
        let count = self.layers.len();
        if count > MOST_LAYERS {
            let message = tr!(
                "the lights need {count} shadow maps, and {MOST_LAYERS} is the most: one for each \
                 directional light and {FACES} for each lamp, times the sets of objects that cast \
                 its shadows"
            );
            return Err(Diagnostic::error("too-many-shadow-maps", message).hint(tr!(
                "link fewer lights to the objects, ask fewer of them for shadows, or choose the \
                 exact tier, which needs no maps"
            )));
        }
        let [least, most] = SIDES;
        let mut side = (height.max(1) + height / 2).next_power_of_two().clamp(least, most);
        let bytes = |side: u32| u64::from(side).pow(2) * TEXEL * count as u64;
        while side > least && bytes(side) > MOST_BYTES {
            side /= 2;
        }
        let casters = objects.iter().enumerate().map(|(number, object)| {
            let mut numbers = object.world_from_object.to_cols_array().to_vec();
            numbers.push(number as f64 + 1.0);
            MapCaster { mesh: object.mesh.clone(), uniform: uniform(numbers) }
        });
        Ok(ShadowMaps { side, layers: self.layers, casters: casters.collect() })
    }
}

/// A uniform of numbers that follow one another.
fn uniform(numbers: Vec<f64>) -> Uniform {
    let mut bytes: Vec<u8> =
        numbers.iter().flat_map(|number| (*number as f32).to_le_bytes()).collect();
    bytes.resize(bytes.len().next_multiple_of(16), 0);
    Uniform { bytes, numbers }
}

/// The axes of a directional light's map, to the right and up: `map_axes` of
/// `shaders/lib/shadow_map.wgsl` (Duff et al. 2017).
fn axes(toward: DVec3) -> [DVec3; 2] {
    let DVec3 { x, y, z } = toward;
    let side = if z > -0.4142 { 1.0 } else { -1.0 };
    let a = -1.0 / (side + z);
    let b = x * y * a;
    [DVec3::new(1.0 + side * x * x * a, side * b, -side * x), DVec3::new(b, side + y * y * a, -y)]
}
