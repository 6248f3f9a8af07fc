//! Solved keys of a look, and their values at a time.

use std::collections::HashMap;

use glam::DVec3;
use indexmap::IndexMap;

use super::blend::blend_keys;
use super::driver::{FAR_AWAY, Wires, driver_value, toward_light};
use super::light::{light_field, set_lights};
use super::params::ParamTable;
use super::track::Track;
use super::{KeyedValues, ObjectValues, RigInputs};
use crate::compile::{HostInputs, LightValues, Param};
use crate::diag::{Diagnostic, WithWarnings};
use crate::directions::KeyWeights;
use crate::document::{
    ColorSpace, DirectionKeys, Driver, KeyDirection, Light, LightSpace, Look, Target, TimeKeys,
    Value,
};
use crate::ids::{LightId, NodePath, ObjectId, PortName};

/// A look's keys with their weights solved, ready for any number of objects and times.
#[derive(Clone, Debug, Default)]
pub struct Rig {
    lights: IndexMap<LightId, Light>,
    exposed: Vec<(PortName, Target)>,
    time: Vec<TimeKeys>,
    directions: Vec<(DirectionKeys, WithWarnings<KeyWeights>)>,
    space: ColorSpace,
}

impl Rig {
    /// Solves the direction keys of `look`. Diagnostics warn of keys that are merged or lie too
    /// close.
    pub fn new(look: &Look) -> WithWarnings<Self> {
        Self::with(look, &solve)
    }

    fn with(
        look: &Look,
        weights_of: &dyn Fn(&DirectionKeys) -> WithWarnings<KeyWeights>,
    ) -> WithWarnings<Self> {
        let mut directions: Vec<_> =
            look.direction_keys.iter().map(|keys| (keys.clone(), weights_of(keys))).collect();
        let warnings = directions.iter().enumerate().flat_map(|(index, (_, weights))| {
            weights.warnings.iter().cloned().map(move |mut problem| {
                let inner = problem.place.json_path.take().unwrap_or_else(|| "keys".to_owned());
                problem.json_path(format!("direction_keys[{index}].{inner}"))
            })
        });
        let warnings = warnings.collect();
        let exposed = look
            .exposed
            .iter()
            .map(|exposed| (exposed.name.clone(), exposed.target.clone()))
            .collect();
        let (lights, mut time, space) =
            (look.lights.clone(), look.time_keys.clone(), look.color_space);
        let in_space = |value: &mut Value| {
            *value = std::mem::replace(value, Value::Bool(false)).in_space(space);
        };
        time.iter_mut().flat_map(|track| &mut track.keys).for_each(|key| in_space(&mut key.value));
        let keys = directions.iter_mut().flat_map(|(keys, _)| &mut keys.keys);
        keys.flat_map(|key| key.values.values_mut()).for_each(in_space);
        WithWarnings::new(Self { lights, exposed, time, directions, space }, warnings)
    }

    /// True if values differ between objects of the same exposed values: keys go by an object's
    /// place and surroundings, or lights along with objects. `lights` replace the look's own.
    pub(in crate::frame) fn follows_objects(&self, lights: &IndexMap<LightId, Light>) -> bool {
        let mut shining = self.lights.iter().map(|(id, own)| lights.get(id).unwrap_or(own));
        !self.directions.is_empty() || shining.any(|light| light.space == LightSpace::Object)
    }

    /// Ids of objects whose distances drive keys.
    pub(in crate::frame) fn near_objects(&self) -> impl Iterator<Item = &ObjectId> {
        let drivers = self.directions.iter().filter_map(|(keys, _)| match &keys.by {
            KeyDirection::Drivers(drivers) => Some(drivers),
            KeyDirection::Light(_) | KeyDirection::View => None,
        });
        drivers.flatten().filter_map(|driver| match driver {
            Driver::Near(id) => Some(id),
            _ => None,
        })
    }

    /// The rig of another state of the look. Weights are solved anew only where keys moved.
    pub fn renewed(&self, look: &Look) -> WithWarnings<Self> {
        let places = |keys: &DirectionKeys| -> Vec<[f64; 3]> {
            keys.keys.iter().map(|key| key.direction).collect()
        };
        let known = |keys: &DirectionKeys| {
            let mut known = self.directions.iter();
            let is_same = |own: &DirectionKeys| {
                own.scheme == keys.scheme
                    && own.by.axes() == keys.by.axes()
                    && places(own) == places(keys)
            };
            known.find(|(own, _)| is_same(own)).map(|(_, weights)| weights.clone())
        };
        Self::with(look, &|keys| known(keys).unwrap_or_else(|| solve(keys)))
    }

    /// The values at a time, for a module with the parameters `params`.
    ///
    /// # Errors
    /// A node of the project that runs without end, where it drives keys.
    pub fn evaluate(
        &self,
        params: &[Param],
        table: &ParamTable,
        wires: Wires<'_>,
        inputs: &RigInputs<'_>,
    ) -> Result<ObjectValues, Diagnostic> {
        let base = |node: &NodePath, port: &PortName| {
            table.find(node, port).and_then(|id| params[id].value.clone())
        };
        let KeyedValues { values, lights, decided } =
            self.keyed_values(&base, Some(wires), inputs)?;
        let frames = inputs.light_frames();
        let resolve = |light: &Light| LightValues::new(light, &frames);
        Ok(ObjectValues {
            params: values
                .into_iter()
                .filter_map(|(target, value)| match target {
                    Target::Input { node, port } => Some((table.find(&node, &port)?, value)),
                    Target::Light { .. } => None,
                })
                .collect(),
            lights: lights.iter().map(|(id, light)| (id.clone(), resolve(light))).collect(),
            decided,
        })
    }

    /// The values that keys and exposed parameters set at a time, and the directions that decided.
    /// `base` gives the value of an input without keys. Without `wires` the wires that drive keys
    /// count as 0.
    ///
    /// # Errors
    /// A node of the project that runs without end, where it drives keys.
    pub fn keyed_values(
        &self,
        base: &dyn Fn(&NodePath, &PortName) -> Option<Value>,
        wires: Option<Wires<'_>>,
        inputs: &RigInputs<'_>,
    ) -> Result<KeyedValues, Diagnostic> {
        let mut values: HashMap<Target, Value> = HashMap::new();
        for (name, target) in &self.exposed {
            if let Some(value) = inputs.exposed.get(name) {
                values.insert(target.clone(), value.clone().in_space(self.space));
            }
        }
        for track in &self.time {
            if let Some(value) = Track::of(track).at(inputs.time) {
                values.insert(track.target.clone(), value);
            }
        }
        let of_scene = || inputs.scene_values.iter().map(|(t, value)| (t.clone(), value.clone()));
        values.extend(of_scene());
        let mut lights = self.lights.clone();
        for (id, light) in inputs.lights {
            if let Some(slot) = lights.get_mut(id) {
                slot.clone_from(light);
            }
        }
        set_lights(&mut lights, &values);
        let mut decided = vec![(DVec3::ZERO, Vec::new()); self.directions.len()];
        for set in self.order(wires) {
            let (keys, WithWarnings { value: weights, .. }) = &self.directions[set];
            let mut direction = self.direction(&keys.by, &lights, inputs);
            if let (Some(wires), Some(_)) = (wires, keys.by.outputs().next()) {
                self.drive(&keys.by, wires, (&values, &lights, base), inputs, &mut direction)?;
            }
            let of_target = |target: &Target| {
                let value = match target {
                    Target::Input { node, port } => base(node, port),
                    Target::Light { light, field } => light_field(lights.get(light)?, field),
                };
                value.map(|value| value.in_space(self.space))
            };
            let weights = weights.weights(direction);
            blend_keys(keys, &weights, &of_target, &mut values);
            decided[set] = (direction, weights);
        }
        values.extend(of_scene());
        set_lights(&mut lights, &values);
        Ok(KeyedValues { values, lights, decided })
    }

    /// The sets of keys in the order in which they take effect.
    fn order(&self, wires: Option<Wires<'_>>) -> Vec<usize> {
        let known = wires.map(|wires| &wires.host.key_order);
        // A module of an earlier state of the look may know other sets.
        let known = known.filter(|order| order.len() == self.directions.len());
        known.cloned().unwrap_or_else(|| (0..self.directions.len()).collect())
    }

    /// Writes the values of wires into the drivers of a set, computed from the values that the sets
    /// before have made.
    fn drive(
        &self,
        by: &KeyDirection,
        wires: Wires<'_>,
        (values, lights, base): DrivenValues<'_>,
        inputs: &RigInputs<'_>,
        direction: &mut DVec3,
    ) -> Result<(), Diagnostic> {
        let KeyDirection::Drivers(drivers) = by else { return Ok(()) };
        let mut lights = lights.clone();
        set_lights(&mut lights, values);
        let frames = inputs.light_frames();
        let resolve = |light: &Light| LightValues::new(light, &frames);
        let lights = lights.iter().map(|(id, light)| (id.clone(), resolve(light))).collect();
        for (axis, driver) in drivers.iter().enumerate() {
            let Some(wire) = driver.output() else { continue };
            let Some(program) = wires.host.drivers.iter().find(|known| known.wire == *wire) else {
                continue;
            };
            let mut params = HashMap::new();
            for id in wires.host.params_of(program) {
                let Param { path: node, port, .. } = &wires.params[id];
                let target = Target::Input { node: node.clone(), port: port.clone() };
                let value = values.get(&target).cloned().or_else(|| base(node, port));
                params.extend(value.map(|value| (id, value.in_space(self.space))));
            }
            let host = HostInputs {
                params: &params,
                lights: &lights,
                camera_from_world: inputs.camera_from_world,
                viewport: inputs.viewport,
                time: inputs.time,
                frame: inputs.frame,
                object_id: inputs.object_id,
            };
            direction[axis] = wires.host.driver(program, &host)?.clamp(-FAR_AWAY, FAR_AWAY);
        }
        Ok(())
    }

    fn direction(
        &self,
        by: &KeyDirection,
        lights: &IndexMap<LightId, Light>,
        inputs: &RigInputs<'_>,
    ) -> DVec3 {
        match by {
            KeyDirection::View => inputs.view,
            KeyDirection::Drivers(drivers) => {
                let mut values = [0.0; 3];
                for (value, driver) in values.iter_mut().zip(drivers) {
                    *value = driver_value(driver, lights, inputs);
                }
                values.into()
            }
            KeyDirection::Light(id) => {
                let Some(light) = lights.get(id) else { return DVec3::Z };
                inputs.camera_from_world * toward_light(light, inputs)
            }
        }
    }
}

/// State while a set is driven: values that are set, lights, and a function that gives the values
/// of inputs without keys.
type DrivenValues<'a> = (
    &'a HashMap<Target, Value>,
    &'a IndexMap<LightId, Light>,
    &'a dyn Fn(&NodePath, &PortName) -> Option<Value>,
);

fn solve(keys: &DirectionKeys) -> WithWarnings<KeyWeights> {
    let places: Vec<DVec3> = keys.keys.iter().map(|key| DVec3::from(key.direction)).collect();
    match keys.by {
        KeyDirection::Drivers(_) => KeyWeights::at_places(&places),
        KeyDirection::Light(_) | KeyDirection::View => KeyWeights::new(&places, keys.scheme),
    }
}

#[cfg(test)]
mod tests {
    use glam::{DMat3, DQuat};

    use super::*;
    use crate::document::{UnknownFields, Values};

    #[test]
    fn a_rig_that_is_renewed_is_a_new_one() {
        let target = Target::Input { node: NodePath::parse("a"), port: "x".into() };
        let look_with = |places: &[[f64; 3]], scale: f64| {
            let key = |(i, &direction): (usize, &[f64; 3])| crate::document::DirectionKey {
                direction,
                values: [(target.clone(), Value::Number(scale * i as f64))].into_iter().collect(),
                unknown: UnknownFields::new(),
            };
            let keys = places.iter().enumerate().map(key).collect();
            let (by, scheme) = (KeyDirection::View, Default::default());
            let set = DirectionKeys {
                name: String::new(),
                by,
                scheme,
                keys,
                unknown: UnknownFields::new(),
            };
            Look { direction_keys: vec![set], ..Look::default() }
        };
        let inputs = RigInputs {
            time: 0.0,
            illumination: DQuat::IDENTITY,
            camera_from_world: DMat3::IDENTITY,
            view: DVec3::new(0.6, 0.0, 0.8),
            center: DVec3::ZERO,
            distance: 1.0,
            front: DVec3::Z,
            turn: DQuat::IDENTITY,
            near: &IndexMap::new(),
            exposed: &Values::new(),
            lights: &IndexMap::new(),
            scene_values: &HashMap::new(),
            aims: &Default::default(),
            viewport: [1.0; 2],
            frame: 0.0,
            object_id: 0.0,
        };
        let of = |rig: &Rig| {
            rig.keyed_values(&|_, _| None, None, &inputs).unwrap().values[&target].clone()
        };
        let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
        let first = Rig::new(&look_with(&[x, z], 1.0)).value;
        // Other values, other places, one key more, one key less: the result always equals that of
        // a new rig.
        for look in [
            look_with(&[x, z], 3.0),
            look_with(&[z, x], 1.0),
            look_with(&[x, y, z], 1.0),
            look_with(&[x], 1.0),
        ] {
            assert_eq!(of(&first.renewed(&look).value), of(&Rig::new(&look).value));
        }
        assert_ne!(of(&first), of(&first.renewed(&look_with(&[x, z], 3.0)).value));
    }
}
