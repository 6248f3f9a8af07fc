//! Values at a time and under a direction: what keys make of a look's values.
//!
//! An object's values come from, each over the one before: the document, the scene's overrides of exposed parameters,
//! time keys, direction keys (BADF eq. 9). Words and switches move in time only, and change what is compiled.

use std::borrow::Cow;
use std::collections::HashMap;

use glam::{DMat3, DQuat, DVec3};
use indexmap::IndexMap;

use crate::compile::{CompiledShader, HostInputs, HostProgram, LightValues, Param, ParamId};
use crate::diag::Diagnostic;
use crate::directions::{KeyWeights, blend_direction, blend_number};
use crate::document::{
    ColorSpace, DirectionKeys, Driver, Interpolation, KeyDirection, Light, LightKind, Look, Target, TimeKey, TimeKeys,
    Value, Values,
};
use crate::ids::{LightId, NodePath, ObjectId, PortName};

/// Where and when an object is shaded.
#[derive(Clone, Copy, Debug)]
pub struct Moment<'a> {
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

/// What computes the wires that drive keys: the look's module, or one that was made of an earlier state of its values.
#[derive(Clone, Copy, Debug)]
pub struct Wires<'a> {
    /// The module's host program.
    pub host: &'a HostProgram,
    /// The inputs that it reads.
    pub params: &'a [Param],
}

impl<'a> Wires<'a> {
    /// Those of a module.
    pub fn of(shader: &'a CompiledShader) -> Self {
        Self { host: &shader.host, params: &shader.params }
    }
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
    /// For each set of direction keys the direction that decides, or the drivers' values, and the weight of each of its
    /// keys.
    pub decided: Vec<(DVec3, Vec<f64>)>,
}

/// A look's keys with their weights solved, ready for any number of objects and moments.
#[derive(Clone, Debug)]
pub struct Rig {
    lights: IndexMap<LightId, Light>,
    exposed: Vec<(PortName, Target)>,
    time: Vec<TimeKeys>,
    directions: Vec<(DirectionKeys, KeyWeights)>,
    space: ColorSpace,
}

impl Rig {
    /// Solves the direction keys of `look`. Diagnostics tell of keys that are merged or lie too close.
    pub fn new(look: &Look) -> (Self, Vec<Diagnostic>) {
        let mut problems = Vec::new();
        let mut index = 0;
        let rig = Self::with(look, &mut |keys| {
            let (weights, found) = solve(keys);
            problems.extend(found.into_iter().map(|mut problem| {
                let inner = problem.place.json_path.take().unwrap_or_else(|| "keys".to_owned());
                problem.json_path(format!("direction_keys[{index}].{inner}"))
            }));
            index += 1;
            weights
        });
        (rig, problems)
    }

    fn with(look: &Look, weights_of: &mut dyn FnMut(&DirectionKeys) -> KeyWeights) -> Self {
        let mut directions: Vec<_> = look.direction_keys.iter().map(|keys| (keys.clone(), weights_of(keys))).collect();
        let exposed = look.exposed.iter().map(|exposed| (exposed.name.clone(), exposed.target.clone())).collect();
        let (lights, mut time, space) = (look.lights.clone(), look.time_keys.clone(), look.color_space);
        let in_space = |value: &mut Value| *value = std::mem::replace(value, Value::Bool(false)).in_space(space);
        time.iter_mut().flat_map(|track| &mut track.keys).for_each(|key| in_space(&mut key.value));
        let keys = directions.iter_mut().flat_map(|(keys, _)| &mut keys.keys);
        keys.flat_map(|key| key.values.values_mut()).for_each(in_space);
        Self { lights, exposed, time, directions, space }
    }

    /// The rig of another state of the look. Weights are solved anew only where keys moved.
    #[must_use]
    pub fn renewed(&self, look: &Look) -> Self {
        let places = |keys: &DirectionKeys| -> Vec<[f64; 3]> { keys.keys.iter().map(|key| key.direction).collect() };
        let known = |keys: &DirectionKeys| {
            let mut known = self.directions.iter();
            let is_same = |own: &DirectionKeys| {
                own.scheme == keys.scheme && own.by.axes() == keys.by.axes() && places(own) == places(keys)
            };
            known.find(|(own, _)| is_same(own)).map(|(_, w)| w.clone())
        };
        Self::with(look, &mut |keys| known(keys).unwrap_or_else(|| solve(keys).0))
    }

    /// The values at a moment, of a module with these parameters.
    ///
    /// # Errors
    /// A node of the project that runs without end, where it drives keys.
    pub fn evaluate(
        &self,
        params: &[Param],
        table: &ParamTable,
        wires: Wires<'_>,
        moment: &Moment<'_>,
    ) -> Result<ObjectValues, Diagnostic> {
        let base = |node: &NodePath, port: &PortName| table.find(node, port).and_then(|id| params[id].value.clone());
        let KeyedValues { values, lights, decided } = self.keyed_values(&base, Some(wires), moment)?;
        let resolve = |light: &Light| LightValues::new(light, moment.illumination, moment.camera_from_world);
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

    /// Everything that keys and exposed parameters set at a moment, and what decided. `base` gives what an input has
    /// without keys. Without `wires` what they drive counts as 0.
    ///
    /// # Errors
    /// A node of the project that runs without end, where it drives keys.
    pub fn keyed_values(
        &self,
        base: &dyn Fn(&NodePath, &PortName) -> Option<Value>,
        wires: Option<Wires<'_>>,
        moment: &Moment<'_>,
    ) -> Result<KeyedValues, Diagnostic> {
        let mut values: HashMap<Target, Value> = HashMap::new();
        for (name, target) in &self.exposed {
            if let Some(value) = moment.exposed.get(name) {
                values.insert(target.clone(), value.clone().in_space(self.space));
            }
        }
        for track in &self.time {
            if let Some(value) = at_time(&track.keys, moment.time, is_direction(&track.target)) {
                values.insert(track.target.clone(), value);
            }
        }
        let mut lights = self.lights.clone();
        for (id, light) in moment.lights {
            if let Some(slot) = lights.get_mut(id) {
                slot.clone_from(light);
            }
        }
        set_lights(&mut lights, &values);
        let mut decided = vec![(DVec3::ZERO, Vec::new()); self.directions.len()];
        for set in self.order(wires) {
            let (keys, weights) = &self.directions[set];
            let mut direction = self.direction(&keys.by, &lights, moment);
            if let (Some(wires), Some(_)) = (wires, keys.by.outputs().next()) {
                self.drive(&keys.by, wires, (&values, &lights, base), moment, &mut direction)?;
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
        set_lights(&mut lights, &values);
        Ok(KeyedValues { values, lights, decided })
    }

    /// The sets of keys in the order in which they take effect.
    fn order(&self, wires: Option<Wires<'_>>) -> Vec<usize> {
        let known = wires.map(|wires| &wires.host.key_order);
        // A module of an earlier state may know other sets.
        let known = known.filter(|order| order.len() == self.directions.len());
        known.cloned().unwrap_or_else(|| (0..self.directions.len()).collect())
    }

    /// Puts the values of wires among the drivers of a set, by what the sets before it have made.
    fn drive(
        &self,
        by: &KeyDirection,
        wires: Wires<'_>,
        (values, lights, base): Known<'_>,
        moment: &Moment<'_>,
        direction: &mut DVec3,
    ) -> Result<(), Diagnostic> {
        let KeyDirection::Drivers(drivers) = by else { return Ok(()) };
        let mut lights = lights.clone();
        set_lights(&mut lights, values);
        let resolve = |light: &Light| LightValues::new(light, moment.illumination, moment.camera_from_world);
        let lights = lights.iter().map(|(id, light)| (id.clone(), resolve(light))).collect();
        for (axis, driver) in drivers.iter().enumerate() {
            let Some(wire) = driver.output() else { continue };
            let Some(program) = wires.host.drivers.iter().find(|known| known.wire == *wire) else { continue };
            let mut params = HashMap::new();
            for id in wires.host.params_of(program) {
                let Param { path: node, port, .. } = &wires.params[id];
                let target = Target::Input { node: node.clone(), port: port.clone() };
                let value = values.get(&target).cloned().or_else(|| base(node, port));
                params.extend(value.map(|value| (id, value.in_space(self.space))));
            }
            let inputs = HostInputs {
                params: &params,
                lights: &lights,
                camera_from_world: moment.camera_from_world,
                viewport: moment.viewport,
                time: moment.time,
                frame: moment.frame,
                object_id: moment.object_id,
            };
            direction[axis] = wires.host.driver(program, &inputs)?.clamp(-FAR_AWAY, FAR_AWAY);
        }
        Ok(())
    }

    fn direction(&self, by: &KeyDirection, lights: &IndexMap<LightId, Light>, moment: &Moment<'_>) -> DVec3 {
        match by {
            KeyDirection::View => moment.view,
            KeyDirection::Drivers(drivers) => {
                let mut values = [0.0; 3];
                for (value, driver) in values.iter_mut().zip(drivers) {
                    *value = driver_value(driver, lights, moment);
                }
                values.into()
            }
            KeyDirection::Light(id) => {
                let Some(light) = lights.get(id) else { return DVec3::Z };
                moment.camera_from_world * toward_light(light, moment)
            }
        }
    }
}

/// What is known while a set is driven: values that are set, lights, and what inputs have without keys.
type Known<'a> =
    (&'a HashMap<Target, Value>, &'a IndexMap<LightId, Light>, &'a dyn Fn(&NodePath, &PortName) -> Option<Value>);

fn solve(keys: &DirectionKeys) -> (KeyWeights, Vec<Diagnostic>) {
    let places: Vec<DVec3> = keys.keys.iter().map(|key| DVec3::from(key.direction)).collect();
    match keys.by {
        KeyDirection::Drivers(_) => KeyWeights::at_places(&places),
        KeyDirection::Light(_) | KeyDirection::View => KeyWeights::new(&places, keys.scheme),
    }
}

/// Unit, from the object's centre toward a light, world space.
fn toward_light(light: &Light, moment: &Moment<'_>) -> DVec3 {
    let resolved = LightValues::new(light, moment.illumination, moment.camera_from_world);
    match light.kind {
        LightKind::Directional => resolved.direction,
        LightKind::Point | LightKind::Spot => (resolved.position - moment.center).try_normalize().unwrap_or(DVec3::Z),
    }
}

/// As far as an object that is not there counts as being, scene units; wires count within so much of 0.
const FAR_AWAY: f64 = 1e6;

/// What a driver is at a moment; a wire is computed by the module that has it, and is 0 here.
pub fn driver_value(driver: &Driver, lights: &IndexMap<LightId, Light>, moment: &Moment<'_>) -> f64 {
    match driver {
        Driver::Distance => moment.distance.clamp(0.0, FAR_AWAY),
        Driver::Facing => match (moment.front.try_normalize(), moment.view.try_normalize()) {
            (Some(front), Some(view)) => 2.0 * (0.5 * front.distance(view)).clamp(0.0, 1.0).asin(),
            _ => 0.0,
        },
        Driver::Height(id) => lights.get(id).map_or(0.0, |light| toward_light(light, moment).y.clamp(-1.0, 1.0).asin()),
        Driver::Near(id) => moment.near.get(id).map_or(FAR_AWAY, |distance| distance.clamp(0.0, FAR_AWAY)),
        Driver::Wire(_) => 0.0,
    }
}

/// Finds parameters by place.
#[derive(Clone, Debug, Default)]
pub struct ParamTable(HashMap<(NodePath, PortName), ParamId>);

impl ParamTable {
    /// A table over a compiled shader's parameters.
    pub fn new(params: &[Param]) -> Self {
        Self(params.iter().enumerate().map(|(id, param)| ((param.path.clone(), param.port.clone()), id)).collect())
    }

    /// The parameter of an input.
    pub fn find(&self, node: &NodePath, port: &PortName) -> Option<ParamId> {
        self.0.get(&(node.clone(), port.clone())).copied()
    }
}

/// The look with the words and switches that its time keys and `exposed` values set: what is compiled then.
pub fn structural_look<'l>(look: &'l Look, time: f64, exposed: &Values) -> Cow<'l, Look> {
    let timed = look.time_keys.iter().filter_map(|track| Some((&track.target, at_time(&track.keys, time, false)?)));
    let set = look.exposed.iter().filter_map(|e| Some((&e.target, exposed.get(&e.name)?.clone())));
    let mut changed = Cow::Borrowed(look);
    for (target, value) in set.chain(timed) {
        let Target::Input { node, port } = target else { continue };
        let is_word = matches!(&value, Value::Text(_)) && value.color().is_none();
        // Inside a definition a value belongs to every use of it, so only the look's own nodes can be set.
        if let (true, [id]) = (is_word, node.ids())
            && let Some(node) = changed.to_mut().graph.nodes.get_mut(id)
        {
            node.values.insert(port.clone(), value);
        }
    }
    changed
}

/// Whether a target is a direction, and so is turned where numbers are blended.
pub fn is_direction(target: &Target) -> bool {
    matches!(target, Target::Light { field, .. } if field == "direction" || field == "aim")
}

/// The value of a track at a time; `None` for an empty one. Before the first key and after the last, theirs holds.
pub fn at_time(keys: &[TimeKey], time: f64, is_direction: bool) -> Option<Value> {
    let next = keys.partition_point(|key| key.time <= time);
    let Some(before) = next.checked_sub(1).map(|index| &keys[index]) else {
        return keys.first().map(|key| key.value.clone());
    };
    let Some(after) = keys.get(next) else { return Some(before.value.clone()) };
    let span = after.time - before.time;
    let t = if span > 0.0 { (time - before.time) / span } else { 0.0 };
    let t = match before.interpolation {
        Interpolation::Stepped => return Some(before.value.clone()),
        Interpolation::Linear => t,
        Interpolation::Smooth => t * t * (3.0 - 2.0 * t),
    };
    Some(mix(&before.value, &after.value, t, is_direction))
}

/// Between two values; what has no between (words, switches, curves) holds the first until the second.
fn mix(a: &Value, b: &Value, t: f64, is_direction: bool) -> Value {
    let weights = [1.0 - t, t];
    blend(&[a, b], &weights, is_direction).unwrap_or_else(|| a.clone())
}

/// The weighted sum of numbers, vectors or colours; `None` where they are of different shapes, or words.
fn blend(values: &[&Value], weights: &[f64], is_direction: bool) -> Option<Value> {
    let rows: Option<Vec<Vec<f64>>> = values.iter().map(|value| numbers_of(value)).collect();
    let mut rows = rows?;
    let width = rows.iter().map(Vec::len).max()?;
    for row in rows.iter_mut().filter(|row| row.len() == 3 && width == 4) {
        row.push(1.0);
    }
    if rows.iter().any(|row| row.len() != width) {
        return None;
    }
    if is_direction && width == 3 {
        let directions: Vec<DVec3> = rows.iter().map(|row| DVec3::from_slice(row)).collect();
        return blend_direction(weights, &directions).map(|direction| Value::Vector(direction.to_array().to_vec()));
    }
    let column = |c: usize| rows.iter().map(|row| row[c]).collect::<Vec<f64>>();
    let blended: Vec<f64> = (0..width).map(|c| blend_number(weights, &column(c))).collect();
    Some(if matches!(values[0], Value::Number(_)) { Value::Number(blended[0]) } else { Value::Vector(blended) })
}

fn numbers_of(value: &Value) -> Option<Vec<f64>> {
    match value {
        Value::Number(x) => Some(vec![*x]),
        Value::Vector(v) => Some(v.clone()),
        Value::Text(_) => value.color().map(|rgba| rgba.to_vec()),
        Value::Bool(_) | Value::Curve(_) | Value::Ramp(_) => None,
    }
}

/// Lays the keyed values under `weights` into `values`; `base` gives what a target has without keys.
fn blend_keys(
    keys: &DirectionKeys,
    weights: &[f64],
    base: &dyn Fn(&Target) -> Option<Value>,
    values: &mut HashMap<Target, Value>,
) {
    if weights.iter().all(|w| *w == 0.0) {
        return;
    }
    let own: HashMap<Target, Value> = keys
        .keys
        .iter()
        .flat_map(|key| key.values.keys())
        .filter_map(|target| Some((target.clone(), values.get(target).cloned().or_else(|| base(target))?)))
        .collect();
    let mut targets: Vec<&Target> = keys.keys.iter().flat_map(|key| key.values.keys()).collect();
    targets.sort_by_cached_key(std::string::ToString::to_string);
    targets.dedup();
    for target in targets {
        let at_key = |index: usize| {
            let key = &keys.keys[index];
            sanitized(target, &|t: &Target| {
                key.values.get(t).cloned().or_else(|| own.get(t).cloned()).or_else(|| base(t))
            })
        };
        let at_keys: Vec<Option<Value>> = (0..keys.keys.len()).map(at_key).collect();
        let with_value: Vec<(&Value, f64)> =
            at_keys.iter().zip(weights).filter_map(|(value, weight)| Some((value.as_ref()?, *weight))).collect();
        let total: f64 = with_value.iter().map(|(_, weight)| weight).sum();
        if total <= 0.0 {
            continue;
        }
        let (at_keys, weights): (Vec<&Value>, Vec<f64>) = with_value.into_iter().map(|(v, w)| (v, w / total)).unzip();
        if let Some(value) = blend(&at_keys, &weights, is_direction(target)) {
            values.insert(target.clone(), value);
        }
    }
}

/// The value of a target at a key, made fit for blending: offset, cut-off and fall-off of one node are brought into
/// order first (math.md 5), so that every blend of them is in order too.
fn sanitized(target: &Target, value: &dyn Fn(&Target) -> Option<Value>) -> Option<Value> {
    let own = value(target)?;
    let Target::Input { node, port } = target else { return Some(own) };
    if !matches!(port.as_str(), "offset" | "falloff" | "cutoff") {
        return Some(own);
    }
    let sibling = |name: &str| {
        let target = Target::Input { node: node.clone(), port: name.into() };
        match value(&target) {
            Some(Value::Number(x)) => Some(x),
            _ => None,
        }
    };
    let pi = std::f64::consts::PI;
    let default = |name: &str, otherwise: f64| sibling(name).unwrap_or(otherwise);
    let offset = default("offset", 0.0).clamp(0.0, pi);
    let cutoff = default("cutoff", pi / 2.0).clamp(offset, pi);
    let falloff = default("falloff", pi / 2.0).clamp(offset, cutoff);
    Some(Value::Number(match port.as_str() {
        "offset" => offset,
        "falloff" => falloff,
        _ => cutoff,
    }))
}

/// A field of a light by name; `None` where there is none of that name.
pub fn light_field(light: &Light, field: &str) -> Option<Value> {
    let vector = |v: [f64; 3]| Some(Value::Vector(v.to_vec()));
    match field {
        "direction" => vector(light.direction),
        "position" => vector(light.position),
        "aim" => vector(light.aim),
        "color" => vector(light.color),
        "intensity" => Some(Value::Number(light.intensity)),
        "inner" => Some(Value::Number(light.inner)),
        "outer" => Some(Value::Number(light.outer)),
        "half_distance" => Some(Value::Number(light.half_distance)),
        "range" => Some(Value::Number(light.range)),
        _ => None,
    }
}

fn set_lights(lights: &mut IndexMap<LightId, Light>, values: &HashMap<Target, Value>) {
    for (target, value) in values {
        if let Target::Light { light, field } = target
            && let Some(light) = lights.get_mut(light)
        {
            set_light_field(light, field, value);
        }
    }
}

/// Sets a field of a light by name; a value of another shape changes nothing.
pub fn set_light_field(light: &mut Light, field: &str, value: &Value) {
    let numbers = numbers_of(value).unwrap_or_default();
    let vector = || <[f64; 3]>::try_from(numbers.get(..3)?).ok();
    let number = numbers.first().copied();
    let (slot, number) = match field {
        "direction" | "position" | "aim" | "color" => {
            let Some(v) = vector() else { return };
            match field {
                "direction" => light.direction = v,
                "position" => light.position = v,
                "aim" => light.aim = v,
                _ => light.color = v,
            }
            return;
        }
        "intensity" => (&mut light.intensity, number),
        "inner" => (&mut light.inner, number),
        "outer" => (&mut light.outer, number),
        "half_distance" => (&mut light.half_distance, number),
        "range" => (&mut light.range, number),
        _ => return,
    };
    if let Some(number) = number {
        *slot = number;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Unknown;

    fn track(interpolation: Interpolation) -> Vec<TimeKey> {
        [(1.0, 10.0), (3.0, 20.0)]
            .map(|(time, value)| TimeKey { time, value: Value::Number(value), interpolation, unknown: Unknown::new() })
            .to_vec()
    }

    #[test]
    fn tracks_hold_outside_and_go_as_asked_between() {
        let number = |keys: &[TimeKey], time| match at_time(keys, time, false) {
            Some(Value::Number(x)) => x,
            other => panic!("{other:?}"),
        };
        let linear = track(Interpolation::Linear);
        assert_eq!([0.0, 1.0, 1.5, 3.0, 9.0].map(|t| number(&linear, t)), [10.0, 10.0, 12.5, 20.0, 20.0]);
        assert_eq!(number(&track(Interpolation::Smooth), 1.5), 10.0 + 10.0 * (0.25 * 0.25 * 2.5));
        assert_eq!(number(&track(Interpolation::Stepped), 2.999), 10.0);
        assert!(at_time(&[], 0.0, false).is_none());
    }

    #[test]
    fn a_rig_that_is_renewed_is_a_new_one() {
        let target = Target::Input { node: NodePath::parse("a"), port: "x".into() };
        let look_with = |places: &[[f64; 3]], scale: f64| {
            let key = |(i, &direction): (usize, &[f64; 3])| crate::document::DirectionKey {
                direction,
                values: [(target.clone(), Value::Number(scale * i as f64))].into_iter().collect(),
                unknown: Unknown::new(),
            };
            let keys = places.iter().enumerate().map(key).collect();
            let (by, scheme) = (KeyDirection::View, Default::default());
            let set = DirectionKeys { name: String::new(), by, scheme, keys, unknown: Unknown::new() };
            Look { direction_keys: vec![set], ..Look::default() }
        };
        let moment = Moment {
            time: 0.0,
            illumination: DQuat::IDENTITY,
            camera_from_world: DMat3::IDENTITY,
            view: DVec3::new(0.6, 0.0, 0.8),
            center: DVec3::ZERO,
            distance: 1.0,
            front: DVec3::Z,
            near: &IndexMap::new(),
            exposed: &Values::new(),
            lights: &IndexMap::new(),
            viewport: [1.0; 2],
            frame: 0.0,
            object_id: 0.0,
        };
        let of = |rig: &Rig| rig.keyed_values(&|_, _| None, None, &moment).unwrap().values[&target].clone();
        let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
        let (first, _) = Rig::new(&look_with(&[x, z], 1.0));
        // Other values, other places, one more key, one less: always as if it were made anew.
        for look in [look_with(&[x, z], 3.0), look_with(&[z, x], 1.0), look_with(&[x, y, z], 1.0), look_with(&[x], 1.0)]
        {
            assert_eq!(of(&first.renewed(&look)), of(&Rig::new(&look).0));
        }
        assert_ne!(of(&first), of(&first.renewed(&look_with(&[x, z], 3.0))));
    }

    #[test]
    fn colours_of_three_and_four_numbers_blend() {
        let opaque = Value::Vector(vec![1.0, 0.0, 0.0]);
        let clear = Value::Vector(vec![0.0, 0.0, 0.0, 0.0]);
        assert_eq!(blend(&[&opaque, &clear], &[0.5, 0.5], false), Some(Value::Vector(vec![0.5, 0.0, 0.0, 0.5])));
    }
}
