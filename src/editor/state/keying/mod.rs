//! Values under keys: their present value, their names and ports, and the edits that set them.
//!
//! Callers that change a value need not know whether it is keyed: [`KeyedLook::set_at`] gives the
//! edit that shows, which changes the key at the playhead, the selected direction key, or the
//! document's own value.

mod drivers;
mod edits;
mod follow;
pub(crate) mod retime;
mod scene;
pub(crate) mod split;
mod together;

pub(crate) use drivers::said;
pub(crate) use scene::scene_edit;

use std::collections::HashMap;
use std::iter;
use std::sync::Arc;

use glam::{DMat3, DQuat, DVec3};
use indexmap::IndexMap;

use crate::compile::{CompiledShader, TypedGraph};
use crate::document::{
    AimPlaces, DirectionKeys, KeyDirection, Light, LightFrames, LightKind, LightSpace, LightValues,
    Object, ObjectFrame, Scene, Target, Value, Values,
};
use crate::frame::{KeyedValues, Rig, RigInputs, Wires};
use crate::ids::{LightId, NodePath, ObjectId, PortName};
use crate::library::Type;
use crate::state::orbit::Orbit;
use crate::state::reading::LookWithLibrary;
use crate::state::scene::{OpenScene, unit_rotation};
use crate::state::snapshot::Stamp;
use crate::state::view::ViewState;
use scene::SceneKeys;

/// Values that keys give, kept until anything changes.
#[derive(Default)]
pub(crate) struct KeyEvaluation {
    stamp: Option<Stamp>,
    /// The object that the values hold for.
    own: Option<ObjectId>,
    rig: Option<Rig>,
    /// Keys of the scene's lights, where there is a scene.
    of_scene: Option<Box<SceneKeys>>,
    now: KeyedValues,
    /// By set of keys: the key at which values are set while none is selected.
    pub(crate) followed: Vec<usize>,
}

/// Document that a light, or a set of keys, belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) enum Owner {
    Look,
    Scene,
}

/// Place of a direction key: the document that has it, the index of its set there, and its index in
/// the set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct KeyPlace {
    pub(crate) owner: Owner,
    pub(crate) set: usize,
    pub(crate) key: usize,
}

/// The open look with the values of its keys in view, or the lights of the scene with theirs.
#[derive(Clone, Copy)]
pub struct KeyedLook<'a> {
    /// Document that has the keys.
    pub(crate) owner: Owner,
    pub(crate) base: LookWithLibrary<'a>,
    pub(crate) evaluation: &'a KeyEvaluation,
    pub(crate) view: &'a ViewState,
    /// The direction key that is selected, of either document.
    pub(crate) selected_key: Option<KeyPlace>,
    pub(crate) scene: Option<&'a OpenScene>,
    /// Typed look of the last compilation.
    pub(crate) typed: Option<&'a TypedGraph>,
    /// Shader with the present values.
    pub(crate) shader: Option<&'a CompiledShader>,
}

impl KeyEvaluation {
    /// Marks the values as out of date.
    pub(crate) fn forget(&mut self) {
        self.stamp = None;
    }

    /// Sets the keys that are followed, of the look and of the scene's lights.
    pub(crate) fn follow(&mut self, of_look: Vec<usize>, of_scene: Option<Vec<usize>>) {
        self.followed = of_look;
        if let (Some(keys), Some(followed)) = (&mut self.of_scene, of_scene) {
            keys.evaluation.followed = followed;
        }
    }
}

/// The keys that move a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum KeyedBy {
    /// No keys.
    Nothing,
    /// A set of direction keys, by index.
    Direction(usize),
    /// A track of time keys, by index.
    Time(usize),
}

impl<'a> KeyedLook<'a> {
    /// Values of keys at the moment of `stamp`; `None` if nothing changed since they were last
    /// computed. `shader` gives the shader that computes wires, for an object that sets exposed
    /// values or for one that sets none.
    pub(crate) fn evaluated(
        self,
        stamp: Stamp,
        shader: impl FnOnce(bool) -> Option<&'a CompiledShader>,
    ) -> Option<KeyEvaluation> {
        let own = self.own_object();
        let sets_values = own.is_some_and(|(_, object)| !object.values.is_empty());
        let own = own.map(|(own, _)| own.clone());
        if self.evaluation.stamp.as_ref() == Some(&stamp) && self.evaluation.own == own {
            return None;
        }
        let rig = match &self.evaluation.rig {
            Some(rig) => rig.renewed(self.base.look).value,
            None => Rig::new(self.base.look).value,
        };
        let base = |node: &NodePath, port: &PortName| {
            self.base.own_value(&Target::Input { node: node.clone(), port: port.clone() })
        };
        let wires = shader(sets_values).map(Wires::of);
        let of_scene = self.scene.map(|open_scene| {
            let known = self.evaluation.of_scene.as_deref();
            Box::new(self.at_this_moment(|moment| SceneKeys::of(open_scene.scene(), known, moment)))
        });
        let none = HashMap::new();
        let scene_values = of_scene.as_ref().map_or(&none, |keys| &keys.evaluation.now.values);
        // Code that runs without end is reported by the compiler and the picture.
        let now = self
            .at_this_moment(|moment| {
                let moment = RigInputs { scene_values, ..*moment };
                rig.keyed_values(&base, wires, &moment)
            })
            .unwrap_or_default();
        let followed = self.evaluation.followed.clone();
        Some(KeyEvaluation { stamp: Some(stamp), own, rig: Some(rig), of_scene, now, followed })
    }

    /// The keys of the scene's lights as those of a look that has nothing else; `None` without a
    /// scene.
    pub(crate) fn of_scene(self) -> Option<Self> {
        self.scene?;
        Some(self.evaluation.of_scene.as_deref()?.seen(self))
    }

    /// The light of an id in the picture of the look: a scene's light stands in place of the
    /// look's, and the look's keys move either. Lights that the scene alone has are drawn by groups
    /// that run for each light.
    pub(crate) fn light(self, id: &LightId) -> Option<&'a Light> {
        let of_scene = || {
            let own = self.light_of_scene(id)?;
            let keys = self.evaluation.of_scene.as_deref();
            Some(keys.and_then(|keys| keys.evaluation.now.lights.get(id)).unwrap_or(own))
        };
        let Some(own) = self.base.look.lights.get(id) else { return of_scene() };
        Some(self.evaluation.now.lights.get(id).or_else(of_scene).unwrap_or(own))
    }

    /// The lights of the look, then those that the scene has besides, which are neither muted nor
    /// left out by a solo, with their present values.
    pub(crate) fn shining(self) -> impl Iterator<Item = (&'a LightId, &'a Light)> {
        let solo = &self.view.solo;
        let own = &self.base.look.lights;
        let of_scene = self.scene.into_iter().flat_map(|scene| &scene.scene().lights);
        let lights = own.iter().chain(of_scene.filter(|(id, _)| !own.contains_key(*id)));
        let lights = lights.filter(move |(id, _)| !solo.is_dark(id));
        lights.map(move |(id, light)| (id, self.light(id).unwrap_or(light)))
    }

    /// True if a turn of the illumination frame turns a light of the picture, or if that has none.
    pub(crate) fn has_turning_lights(self) -> bool {
        let of_scene = self.scene.map(|open_scene| &open_scene.scene().lights);
        let others = self.scene.into_iter().flat_map(OpenScene::other_looks);
        let looks = iter::once(self.base.look).chain(others.map(|worn| &worn.look));
        let is_shown = |id: &LightId| of_scene.is_none_or(|lights| !lights.contains_key(id));
        let of_looks = looks.flat_map(|look| &look.lights).filter(|(id, _)| is_shown(id));
        let lights = of_looks.chain(of_scene.into_iter().flatten());
        let spaces: Vec<LightSpace> = lights.map(|(_, light)| light.space).collect();
        spaces.is_empty() || spaces.contains(&LightSpace::Illumination)
    }

    /// The scene's light that stands in place of the look's.
    pub(crate) fn light_of_scene(self, id: &LightId) -> Option<&'a Light> {
        self.scene?.scene().lights.get(id)
    }

    /// The object of the scene that stands for all that wear the open look: the selected one, or
    /// else the first.
    fn own_object(self) -> Option<(&'a ObjectId, &'a Object)> {
        let open_scene = self.scene?;
        let seen = || open_scene.scene().objects.iter().filter(|(_, object)| object.visible);
        let wears = |(_, object): &(&ObjectId, &Object)| open_scene.wears_open(object);
        let selected = open_scene.selected().filter(|(_, object)| object.visible).filter(wears);
        selected.or_else(|| seen().find(wears)).or_else(|| seen().next())
    }

    /// Calls `ask` with the inputs of the present moment, for the object that stands for all that
    /// wear the look.
    fn at_this_moment<R>(self, ask: impl FnOnce(&RigInputs<'_>) -> R) -> R {
        let scene = self.scene.map(OpenScene::scene);
        let place = |object: &Object| DVec3::from(object.transform.translate);
        let own = self.own_object();
        let own_place = own.map_or(DVec3::ZERO, |(_, object)| place(object));
        let front = own
            .map_or(DVec3::Z, |(_, object)| DQuat::from_array(object.transform.rotate) * DVec3::Z);
        let others = scene.into_iter().flat_map(|scene| &scene.objects);
        let others = others.filter(|(id, _)| own.is_none_or(|(own, _)| own != *id));
        let near =
            others.map(|(id, object)| (id.clone(), place(object).distance(own_place))).collect();
        let (none, no_values, no_keys) = (IndexMap::new(), Values::new(), HashMap::new());
        let of_scene = self.evaluation.of_scene.as_deref();
        let frames = self.light_frames();
        ask(&RigInputs {
            time: self.view.time,
            illumination: self.view.orbit.illumination,
            camera_from_world: camera_from_world(&self.view.orbit),
            view: from_center_to_eye(&self.view.orbit),
            center: DVec3::ZERO,
            distance: eye_of(&self.view.orbit).distance(own_place),
            front,
            turn: frames.object.turn,
            near: &near,
            exposed: own.map_or(&no_values, |(_, object)| &object.values),
            lights: scene.map_or(&none, |scene| &scene.lights),
            scene_values: of_scene.map_or(&no_keys, |keys| &keys.evaluation.now.values),
            aims: &frames.aims,
            // No wire is asked here that depends on the picture's size.
            viewport: [1.0; 2],
            frame: (self.view.time * scene.map_or(24.0, |scene| scene.time.fps)).round(),
            object_id: own.map_or(0.0, |(own, _)| place_of(scene, own)),
        })
    }

    /// Frames that lights are given in, for the object that stands for all that wear the look.
    pub(crate) fn light_frames(self) -> LightFrames {
        let own = self.own_object().map(|(_, object)| &object.transform);
        let object = own.map_or_else(ObjectFrame::default, |transform| ObjectFrame {
            center: transform.translate.into(),
            turn: unit_rotation(transform.rotate),
        });
        LightFrames {
            illumination: self.view.orbit.illumination,
            camera_from_world: camera_from_world(&self.view.orbit),
            object,
            aims: Arc::new(self.aims()),
        }
    }

    /// Places of objects that lights are aimed at.
    fn aims(self) -> AimPlaces {
        let Some(scene) = self.scene.map(OpenScene::scene) else { return AimPlaces::new() };
        let lights = scene.lights.values().chain(self.base.look.lights.values());
        let aimed = lights.filter_map(|light| light.aimed_at.as_ref());
        let place = |id: &ObjectId| Some(scene.objects.get(id)?.transform.translate.into());
        aimed.filter_map(|id| Some((id.clone(), place(id)?))).collect()
    }

    /// Direction toward a light from the object, in camera axes.
    fn toward_light(self, light: &Light) -> DVec3 {
        self.at_this_moment(|inputs| {
            let resolved = LightValues::new(light, &inputs.light_frames());
            let toward = match light.kind {
                LightKind::Directional => resolved.direction(),
                LightKind::Point | LightKind::Spot => {
                    resolved.position().try_normalize().unwrap_or(DVec3::Z)
                }
            };
            inputs.camera_from_world * toward
        })
    }

    /// Present values of keys.
    pub(crate) fn values(self) -> &'a KeyedValues {
        &self.evaluation.now
    }

    /// The direction that decides between the keys of a set now, and the weights.
    pub(crate) fn decided(self, set: usize) -> Option<&'a (DVec3, Vec<f64>)> {
        self.evaluation.now.decided.get(set)
    }

    /// Present weight of each key of a set.
    pub fn key_weights(self, set: usize) -> Vec<f64> {
        self.decided(set).map(|(_, weights)| weights.clone()).unwrap_or_default()
    }

    /// Present value of a target.
    pub(crate) fn value_now(self, target: &Target) -> Option<Value> {
        self.evaluation.now.values.get(target).cloned().or_else(|| self.base.own_value(target))
    }

    /// The keys that move a target. Direction keys lie over those of time.
    pub(crate) fn keyed_by(self, target: &Target) -> KeyedBy {
        let look = self.base.look;
        let has_it =
            |keys: &DirectionKeys| keys.keys.iter().any(|key| key.values.contains_key(target));
        if let Some(set) = look.direction_keys.iter().rposition(has_it) {
            return KeyedBy::Direction(set);
        }
        match look.time_keys.iter().position(|track| track.target == *target) {
            Some(track) => KeyedBy::Time(track),
            None => KeyedBy::Nothing,
        }
    }

    /// The value of a target that an edit by hand sets: in the key that is set there, or the
    /// document's own.
    pub(crate) fn value_at(self, target: &Target) -> Option<Value> {
        match self.keyed_by(target) {
            KeyedBy::Direction(set) => {
                let key = self.base.look.direction_keys.get(set)?.keys.get(self.key_at(set))?;
                key.values.get(target).cloned().or_else(|| self.base.own_value(target))
            }
            KeyedBy::Time(_) => self.value_now(target),
            KeyedBy::Nothing => self.base.own_value(target),
        }
    }

    /// The present direction, or the drivers' present values, in the form that keys of a set by
    /// `by` have.
    pub(crate) fn direction_of(self, by: &KeyDirection) -> DVec3 {
        match by {
            KeyDirection::View => from_center_to_eye(&self.view.orbit),
            KeyDirection::Light(id) => {
                self.light(id).map_or(DVec3::Z, |light| self.toward_light(light))
            }
            KeyDirection::Drivers(drivers) => {
                let mut values = [0.0; 3];
                values
                    .iter_mut()
                    .zip(drivers)
                    .for_each(|(value, driver)| *value = self.driver_now(driver));
                values.into()
            }
        }
    }
}

/// Index of an object in the scene, as a number; 0 without one.
fn place_of(scene: Option<&Scene>, own: &ObjectId) -> f64 {
    let index = scene.and_then(|scene| scene.objects.get_index_of(own));
    index.unwrap_or_default() as f64
}

/// Rotation from world to camera axes: x right, y up, z toward the viewer.
pub(crate) fn camera_from_world(view: &Orbit) -> DMat3 {
    let (right, up) = view.right_and_up();
    DMat3::from_cols(right, up, view.direction()).transpose()
}

/// Direction from the object's center to the eye, in world space.
fn from_center_to_eye(view: &Orbit) -> DVec3 {
    eye_of(view).try_normalize().unwrap_or_else(|| view.direction())
}

fn eye_of(view: &Orbit) -> DVec3 {
    view.target + view.direction() * view.distance
}

/// A direction in the precision of files: four decimals are less than a hundredth of a degree.
pub(crate) fn rounded(direction: DVec3) -> [f64; 3] {
    direction.to_array().map(|x| (x * 1e4).round() / 1e4)
}

/// True if direction keys can blend values of a type.
pub(crate) fn has_between(ty: &Type) -> bool {
    use Type::{Angle, Color, Composite, Float, Int, Vec2, Vec3, Vec4};
    matches!(ty, Float | Int | Angle | Vec2 | Vec3 | Vec4 | Color | Composite)
}

/// True if values of a type can change with time.
pub(crate) fn changes_in_time(ty: &Type) -> bool {
    has_between(ty) || matches!(ty, Type::Bool | Type::Choice | Type::Curve | Type::Ramp)
}

/// Targets that the keys of a set change, each once, in the order in which they first come.
pub(crate) fn targets_of(keys: &DirectionKeys) -> Vec<Target> {
    let mut seen = HashMap::new();
    let all = keys.keys.iter().flat_map(|key| key.values.keys());
    all.filter(|target| seen.insert((*target).clone(), ()).is_none()).cloned().collect()
}
