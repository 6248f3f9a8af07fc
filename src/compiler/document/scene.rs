//! A scene: objects with looks, shared lights, a camera and a time range.

use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

use super::look::{Light, Unknown};
use super::value::Values;
use crate::ids::{LightId, ObjectId};

/// Objects with looks, shared lights, the illumination frame, a camera, a backdrop and a time
/// range.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// What the artist calls it.
    pub name: String,
    /// What it shows and how it is built: a paragraph for who finds it.
    pub about: String,
    /// In document order.
    pub objects: IndexMap<ObjectId, Object>,
    /// Lights that replace those of the same id in every look of the scene.
    pub lights: IndexMap<LightId, Light>,
    /// The rotation of the illumination frame, as a quaternion `[x, y, z, w]`: world from
    /// illumination frame.
    pub illumination: [f64; 4],
    /// Where the picture is taken from.
    pub camera: Camera,
    /// Straight RGBA behind the objects, in display colors; `None` for transparent.
    pub backdrop: Option<[f64; 4]>,
    /// Which times there are.
    pub time: TimeRange,
    /// Fields of later versions or of other programs.
    pub unknown: Unknown,
}

impl Default for Scene {
    fn default() -> Self {
        Self {
            name: String::new(),
            about: String::new(),
            objects: IndexMap::new(),
            lights: IndexMap::new(),
            illumination: [0.0, 0.0, 0.0, 1.0],
            camera: Camera::default(),
            backdrop: Some([0.16, 0.165, 0.18, 1.0]),
            time: TimeRange::default(),
            unknown: Unknown::new(),
        }
    }
}

/// A mesh, where it stands and what it wears.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Object {
    /// A path relative to the scene's file, or `shape:` and the name of an own shape.
    pub mesh: String,
    /// Where it stands.
    pub transform: Transform,
    /// Paths of looks, relative to the scene's file, by material name; `*` is for every other
    /// material.
    pub looks: IndexMap<String, String>,
    /// Values of exposed parameters, over those of the looks.
    pub values: Values,
    /// Whether it is drawn.
    pub visible: bool,
    /// Fields of later versions or of other programs.
    #[serde(default, skip_serializing_if = "Unknown::is_empty")]
    pub unknown: Unknown,
}

impl Default for Object {
    fn default() -> Self {
        Self {
            mesh: "shape:sphere".to_owned(),
            transform: Transform::default(),
            looks: IndexMap::new(),
            values: Values::new(),
            visible: true,
            unknown: Unknown::new(),
        }
    }
}

/// Scale, then turn, then move.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Transform {
    /// In scene units.
    pub translate: [f64; 3],
    /// A quaternion `[x, y, z, w]`.
    pub rotate: [f64; 4],
    /// Along each axis; not 0.
    pub scale: [f64; 3],
    /// Whether the mesh is first centred and scaled to a bounding sphere of radius 1.
    pub fit: bool,
}

impl Default for Transform {
    fn default() -> Self {
        Self { translate: [0.0; 3], rotate: [0.0, 0.0, 0.0, 1.0], scale: [1.0; 3], fit: true }
    }
}

/// Where the picture is taken from.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Camera {
    /// The eye, in scene units.
    pub eye: [f64; 3],
    /// What it looks at, in scene units.
    pub target: [f64; 3],
    /// What is up in the picture.
    pub up: [f64; 3],
    /// How depth becomes smaller.
    pub projection: Projection,
    /// Perspective: the vertical field of view, in radians.
    pub fov: f64,
    /// Orthographic: the height of the picture, in scene units.
    pub height: f64,
    /// The width over the height of the picture that it was placed for: a narrower one shows as
    /// much in width, and more above and below. 0 for any.
    pub aspect: f64,
}

impl Camera {
    /// The least and the greatest vertical field of view, in radians: of files, of views and of
    /// command lines alike.
    pub const FOV: [f64; 2] = [0.001, std::f64::consts::PI - 0.01];

    /// Whether a vertical field of view, in radians, can be looked through.
    pub fn holds_fov(fov: f64) -> bool {
        (Self::FOV[0]..=Self::FOV[1]).contains(&fov)
    }

    /// How many times as high the view is in a picture whose width is `aspect` times its height.
    pub fn widening(&self, aspect: f64) -> f64 {
        if self.aspect > 0.0 { (self.aspect / aspect.max(1e-6)).max(1.0) } else { 1.0 }
    }
}

impl Default for Camera {
    fn default() -> Self {
        Self {
            eye: [0.0, 0.0, 4.4],
            target: [0.0; 3],
            up: [0.0, 1.0, 0.0],
            projection: Projection::Perspective,
            fov: 0.5,
            height: 2.5,
            aspect: 0.0,
        }
    }
}

/// How depth becomes smaller.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Projection {
    /// Lines meet at the eye.
    #[default]
    Perspective,
    /// Parallel lines stay parallel.
    Orthographic,
}

/// Which times there are, in seconds.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct TimeRange {
    /// The first time.
    pub start: f64,
    /// The last time.
    pub end: f64,
    /// Frames a second.
    pub fps: f64,
}

impl Default for TimeRange {
    fn default() -> Self {
        Self { start: 0.0, end: 0.0, fps: 24.0 }
    }
}
