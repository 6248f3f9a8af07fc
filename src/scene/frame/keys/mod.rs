//! Values at a time and under a direction: the result of a look's keys.
//!
//! An object's values come from these sources, each over the one before: the document, the scene's
//! overrides of exposed parameters, time keys, direction keys (BADF eq. 9), and for lights the keys
//! of the scene. Words and switches move in time only, and change what is compiled.
//!
//! [`Rig`] joins the sources; its parts are modules of their own: tracks in [`track`], the cubics
//! between their keys in [`bezier`], the blend of values under weights in [`blend`], drivers in
//! [`driver`], and a light's fields by name in [`light`].

mod bezier;
mod blend;
mod driver;
mod light;
mod params;
mod rig;
mod scene;
mod time;
mod track;

use std::collections::HashMap;
use std::sync::Arc;

use glam::{DMat3, DQuat, DVec3};
use indexmap::IndexMap;

use crate::compile::{LightValues, ParamId};
use crate::document::{AimPlaces, Light, LightFrames, ObjectFrame, Target, Value, Values};
use crate::ids::{LightId, ObjectId};

pub use bezier::BezierSpan;
pub use blend::is_direction;
pub use driver::{Wires, driver_value};
pub(super) use light::set_lights;
pub use light::{light_field, set_light_field};
pub use params::ParamTable;
pub use rig::Rig;
pub use scene::SceneRig;
pub use time::structural_look;
pub use track::Track;

/// Inputs that decide between keys for one object: the object's surroundings and the time.
#[derive(Clone, Copy, Debug)]
pub struct RigInputs<'a> {
    /// Time, in seconds.
    pub time: f64,
    /// Rotation from the illumination frame to world space.
    pub illumination: DQuat,
    /// Rotation from world space to camera axes.
    pub camera_from_world: DMat3,
    /// Unit direction from the object toward the viewer, in world space.
    pub view: DVec3,
    /// Center of the object, in world space.
    pub center: DVec3,
    /// Distance from the eye to the object's center, in scene units.
    pub distance: f64,
    /// Front of the object, its z axis, in world space; any length.
    pub front: DVec3,
    /// Rotation from the object's axes to world space.
    pub turn: DQuat,
    /// Distances of other objects' centers from this object's, in scene units.
    pub near: &'a IndexMap<ObjectId, f64>,
    /// Values of exposed parameters by name.
    pub exposed: &'a Values,
    /// Lights that replace the look's own.
    pub lights: &'a IndexMap<LightId, Light>,
    /// Values that keys of the scene give to lights.
    pub scene_values: &'a HashMap<Target, Value>,
    /// Places of objects that lights are aimed at.
    pub aims: &'a Arc<AimPlaces>,
    /// Width and height of the picture, in pixels.
    pub viewport: [f64; 2],
    /// Number of frames since the start of the time range.
    pub frame: f64,
    /// Number of the object in the scene, counted from 0.
    pub object_id: f64,
}

impl RigInputs<'_> {
    /// Frames that the lights of the object are given in.
    pub fn light_frames(&self) -> LightFrames {
        LightFrames {
            illumination: self.illumination,
            camera_from_world: self.camera_from_world,
            object: ObjectFrame { center: self.center, turn: self.turn },
            aims: self.aims.clone(),
        }
    }
}

/// A look's values for one object at one time.
#[derive(Clone, Debug, Default)]
pub struct ObjectValues {
    /// Values by parameter of the compiled shader.
    pub params: HashMap<ParamId, Value>,
    /// Lights, in world space.
    pub lights: IndexMap<LightId, LightValues>,
    /// Directions and weights that decided, as in [`KeyedValues::decided`].
    pub decided: Vec<(DVec3, Vec<f64>)>,
}

/// Values that keys and exposed parameters give to a look at a time.
#[derive(Clone, Debug, Default)]
pub struct KeyedValues {
    /// Values of all targets that anything sets.
    pub values: HashMap<Target, Value>,
    /// Lights as they are at that time.
    pub lights: IndexMap<LightId, Light>,
    /// Direction that decides, or the drivers' values, and the weight of each key, for each set of
    /// direction keys.
    pub decided: Vec<(DVec3, Vec<f64>)>,
}
