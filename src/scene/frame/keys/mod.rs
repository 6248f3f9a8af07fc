//! Values at a time and under a direction: what keys make of a look's values.
//!
//! An object's values come from, each over the one before: the document, the scene's overrides of
//! exposed parameters, time keys, direction keys (BADF eq. 9). Words and switches move in time
//! only, and change what is compiled.
//!
//! [`Rig`] is where they come together; what it asks lies in rooms of its own: tracks in [`time`],
//! the blend of values under weights in [`blend`], what decides in [`driver`], and a light's fields
//! by name in [`light`].

mod blend;
mod driver;
mod light;
mod params;
mod rig;
mod time;

use std::collections::HashMap;

use glam::{DMat3, DQuat, DVec3};
use indexmap::IndexMap;

use crate::compile::{LightValues, ParamId};
use crate::document::{Light, Target, Value, Values};
use crate::ids::{LightId, ObjectId};

pub use blend::is_direction;
pub use driver::{Wires, driver_value};
pub use light::{light_field, set_light_field};
pub use params::ParamTable;
pub use rig::Rig;
pub use time::{at_time, structural_look};

/// What decides between keys for one object: where and when it is shaded.
#[derive(Clone, Copy, Debug)]
pub struct RigInputs<'a> {
    /// Seconds.
    pub time: f64,
    /// World from illumination frame.
    pub illumination: DQuat,
    /// Camera from world.
    pub camera_from_world: DMat3,
    /// Unit, from the object toward the viewer, world space.
    pub view: DVec3,
    /// The object's centre, world space.
    pub center: DVec3,
    /// From the eye to the object's centre, scene units.
    pub distance: f64,
    /// The object's front, its z axis, world space; any length.
    pub front: DVec3,
    /// How far the centres of other objects are from this one's, scene units.
    pub near: &'a IndexMap<ObjectId, f64>,
    /// Values of exposed parameters by name.
    pub exposed: &'a Values,
    /// Lights in place of the look's own.
    pub lights: &'a IndexMap<LightId, Light>,
    /// Width and height in pixels.
    pub viewport: [f64; 2],
    /// Frames since the start of the time range.
    pub frame: f64,
    /// Counts objects from 0.
    pub object_id: f64,
}

/// A look's values for one object at one moment.
#[derive(Clone, Debug, Default)]
pub struct ObjectValues {
    /// By parameter of the compiled shader.
    pub params: HashMap<ParamId, Value>,
    /// In world space.
    pub lights: IndexMap<LightId, LightValues>,
    /// As [`KeyedValues::decided`].
    pub decided: Vec<(DVec3, Vec<f64>)>,
}

/// What keys and exposed parameters make of a look at a moment.
#[derive(Clone, Debug, Default)]
pub struct KeyedValues {
    /// By target: whatever anything sets.
    pub values: HashMap<Target, Value>,
    /// The lights as they are then.
    pub lights: IndexMap<LightId, Light>,
    /// For each set of direction keys the direction that decides, or the drivers' values, and the
    /// weight of each of its keys.
    pub decided: Vec<(DVec3, Vec<f64>)>,
}
