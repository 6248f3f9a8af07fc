//! Lights as they shine on an object: the frames that they are given in, the surroundings that
//! decide between their keys, and their values at a time.

use std::collections::{BTreeSet, HashMap};
use std::sync::Arc;

use glam::{DQuat, DVec3};
use indexmap::IndexMap;

use super::camera::View;
use super::keys::{ParamTable, Rig, RigInputs, SceneRig, Wires};
use super::plan::{Draw, FramePlan, PlanOptions, current_params};
use super::setup::{Setup, SetupObject};
use crate::diag::Diagnostic;
use crate::document::{AimPlaces, LightFrames, LightValues, ObjectFrame, Target, Value};
use crate::ids::{LightId, ObjectId};
use crate::library::Library;

/// Surroundings of an object that whoever asks for many objects finds once for all.
#[derive(Clone, Copy)]
pub(super) struct Surroundings<'a> {
    /// Distances of other objects, in scene units.
    pub(super) near: &'a IndexMap<ObjectId, f64>,
    /// Places of objects that lights are aimed at.
    pub(super) aims: &'a Arc<AimPlaces>,
    /// Values that keys of the scene give to lights; none until a look's are computed.
    pub(super) scene_values: &'a HashMap<Target, Value>,
}

impl SetupObject {
    /// Place and turn of the object.
    pub fn frame(&self) -> ObjectFrame {
        ObjectFrame::new(self.center(), self.world_from_object)
    }

    /// The look, by its number, that the part of a draw wears.
    pub fn look_of(&self, draw: &Draw) -> Option<usize> {
        let part = self.mesh.parts.iter().position(|part| part.indices == draw.indices)?;
        self.looks.get(part).copied().flatten()
    }
}

impl Setup {
    /// Rotation from the illumination frame to world space.
    pub fn illumination(&self) -> DQuat {
        DQuat::from_array(self.scene.illumination).normalize()
    }

    /// Frames that lights of an object are given in, in a view. `aims` are [`Self::aims`], which
    /// whoever asks for many objects finds once.
    pub fn light_frames(
        &self,
        view: &View,
        object: ObjectFrame,
        aims: &Arc<AimPlaces>,
    ) -> LightFrames {
        LightFrames {
            illumination: self.illumination(),
            camera_from_world: view.rotation(),
            object,
            aims: aims.clone(),
        }
    }

    /// The surroundings of an object and the time, which decide between keys. The object is given
    /// by its number and the middle of its box, in world space; the lights are the scene's.
    pub(super) fn rig_inputs<'a>(
        &'a self,
        (number, center): (usize, DVec3),
        view: &View,
        options: &PlanOptions,
        Surroundings { near, aims, scene_values }: Surroundings<'a>,
    ) -> RigInputs<'a> {
        let (object, time) = (&self.objects[number], &self.scene.time);
        let LightFrames { illumination, camera_from_world, object: frame, .. } =
            self.light_frames(view, ObjectFrame::new(center, object.world_from_object), aims);
        RigInputs {
            time: options.time,
            illumination,
            camera_from_world,
            view: view.toward_viewer(center),
            center,
            distance: view.eye.distance(center),
            front: object.world_from_object.transform_vector3(DVec3::Z),
            turn: frame.turn,
            near,
            exposed: &object.values,
            lights: &self.scene.lights,
            scene_values,
            aims,
            viewport: options.size.map(f64::from),
            frame: ((options.time - time.start) * time.fps).round(),
            object_id: number as f64,
        }
    }

    /// Lights as they shine on the object of a draw at a time, in seconds: those of its looks and
    /// of the scene, in world space, after all keys and behind the masters of their groups. `plan`
    /// is a plan of this setup at that time, in which lights that are out have the intensity 0.
    ///
    /// # Errors
    /// A node of the project that runs without end, where it drives keys.
    pub fn object_lights(
        &self,
        (plan, draw): (&FramePlan, &Draw),
        library: &Library,
        time: f64,
    ) -> Result<IndexMap<LightId, LightValues>, Diagnostic> {
        let moved = self.at(time);
        moved.lights_now((plan, draw), library, self.shading_time(time))
    }

    /// Lights as [`object_lights`](Self::object_lights) has them, of a setup that is moved to the
    /// time at which it shades, in seconds.
    fn lights_now(
        &self,
        (plan, draw): (&FramePlan, &Draw),
        library: &Library,
        time: f64,
    ) -> Result<IndexMap<LightId, LightValues>, Diagnostic> {
        let mut lights = IndexMap::new();
        let Some(number) = self.objects.iter().position(|object| object.id == draw.object) else {
            return Ok(lights);
        };
        let object = &self.objects[number];
        let center = object.center();
        let options = PlanOptions { size: plan.size, samples: plan.samples, time };
        let (aims, scene_rig) = (self.aims(), SceneRig::of(&self.scene, None));
        let center_of = |id: &ObjectId| {
            self.objects.iter().find(|other| other.id == *id).map(SetupObject::center)
        };
        let values_of = |inputs: &RigInputs<'_>| {
            scene_rig.as_ref().map(|rig| rig.values(inputs)).unwrap_or_default()
        };
        let none = HashMap::new();
        // Lights of the object's other looks come after those of the look that is asked for.
        let others = plan.draws.iter().filter(|other| other.object == object.id);
        let mut known = BTreeSet::new();
        for draw in std::iter::once(draw).chain(others) {
            let Some(index) = object.look_of(draw).filter(|look| known.insert(*look)) else {
                continue;
            };
            let look = self.worn(index, object, library, time);
            let rig = Rig::new(&look).value;
            let near = near_objects(&rig, scene_rig.as_deref(), (&object.id, center), &center_of);
            let around = Surroundings { near: &near, aims: &aims, scene_values: &none };
            let inputs = self.rig_inputs((number, center), &plan.view, &options, around);
            let scene_values = values_of(&inputs);
            let inputs = RigInputs { scene_values: &scene_values, ..inputs };
            let params = current_params(&look, &draw.look.params);
            let table = ParamTable::new(&params);
            let values = rig.evaluate(&params, &table, Wires::of(&draw.look), &inputs)?;
            for (id, light) in values.lights {
                lights.entry(id).or_insert(light);
            }
        }
        // Lights that no look has are moved by the scene's keys alone.
        let rig = Rig::default();
        let near = near_objects(&rig, scene_rig.as_deref(), (&object.id, center), &center_of);
        let around = Surroundings { near: &near, aims: &aims, scene_values: &none };
        let inputs = self.rig_inputs((number, center), &plan.view, &options, around);
        let mut of_scene = self.scene.lights.clone();
        of_scene.retain(|id, _| !lights.contains_key(id));
        super::keys::set_lights(&mut of_scene, &values_of(&inputs));
        let frames = inputs.light_frames();
        lights.extend(of_scene.into_iter().map(|(id, own)| (id, LightValues::new(&own, &frames))));
        let mix = self.light_mix();
        lights.iter_mut().for_each(|(id, light)| mix.apply(id, light));
        Ok(lights)
    }
}

/// Distances of those other objects that drive keys of a look and of the scene, in scene units.
pub(super) fn near_objects(
    rig: &Rig,
    scene_rig: Option<&SceneRig>,
    (own, center): (&ObjectId, DVec3),
    center_of: &dyn Fn(&ObjectId) -> Option<DVec3>,
) -> IndexMap<ObjectId, f64> {
    // What drives the scene's lights may be the object itself: nothing is nearer to it.
    let of_scene = scene_rig.into_iter().flat_map(|rig| rig.rig().near_objects());
    let others = rig.near_objects().filter(|id| *id != own).chain(of_scene);
    others.filter_map(|id| Some((id.clone(), center_of(id)?.distance(center)))).collect()
}
