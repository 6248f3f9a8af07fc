//! Keyed values: what keys make of a value now, what else is said of it, and which edit sets it.
//!
//! Who changes a value need not know whether it is keyed: [`Session::set_at`] gives the edit that shows, which is one of
//! the key at the playhead, of the direction key that is selected, or of the document's own value.

use std::collections::HashMap;

use glam::{DMat3, DVec3};
use indexmap::IndexMap;

use super::catalog::Port;
use super::orbit::Orbit;
use super::session::Session;
use super::still::Stamp;
use super::values;
use crate::document::{
    DirectionKey, DirectionKeys, Edit, GraphId, Interpolation, KeyDirection, KeyScheme, Light, LightKind, Node, Target,
    TimeKey, TimeKeys, Unknown, Value, Values,
};
use crate::frame::{KeyedValues, Moment, Rig, light_field, set_light_field};
use crate::ids::{LightId, NodeId, NodePath, PortName};
use crate::library::{Fallback, Type};

/// What keys come to, kept until anything changes.
#[derive(Default)]
pub(crate) struct Keyed {
    stamp: Option<Stamp>,
    rig: Option<Rig>,
    now: KeyedValues,
}

/// What moves a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum KeyedBy {
    /// Nothing.
    Nothing,
    /// A set of direction keys, by its place.
    Direction(usize),
    /// A track, by its place.
    Time(usize),
}

impl Session {
    /// Computes what keys come to, where anything changed since.
    pub(crate) fn refresh_keys(&mut self) {
        let stamp = self.stamp();
        if self.keyed.stamp.as_ref() == Some(&stamp) {
            return;
        }
        let look = self.look();
        let rig = match &self.keyed.rig {
            Some(rig) => rig.renewed(look),
            None => Rig::new(look).0,
        };
        let base = |node: &NodePath, port: &PortName| {
            self.own_value(&Target::Input { node: node.clone(), port: port.clone() })
        };
        let moment = Moment {
            time: self.time,
            illumination: self.view.illumination,
            camera_from_world: camera_from_world(&self.view),
            view: from_center_to_eye(&self.view),
            center: DVec3::ZERO,
            exposed: &Values::new(),
            lights: &look.lights,
        };
        let now = rig.keyed_values(&base, &moment);
        self.keyed = Keyed { stamp: Some(stamp), rig: Some(rig), now };
        let sets = &self.look().direction_keys;
        let is_there = |&(set, key): &(usize, usize)| sets.get(set).is_some_and(|keys| key < keys.keys.len());
        self.key = self.key.filter(is_there);
    }

    /// What keys come to now.
    pub(crate) fn keyed_now(&self) -> &KeyedValues {
        &self.keyed.now
    }

    /// The direction that decides between the keys of a set now, and the weights.
    pub(crate) fn decided(&self, set: usize) -> Option<&(DVec3, Vec<f64>)> {
        self.keyed.now.decided.get(set)
    }

    /// An input of a node of the open graph, as keys name it.
    pub(crate) fn target(&self, node: &NodeId, port: &PortName) -> Target {
        Target::Input { node: self.path_of(node), port: port.clone() }
    }

    /// The node at a path, through the groups of the look and of the library.
    pub(crate) fn node_at(&self, path: &NodePath) -> Option<&Node> {
        let (last, groups) = path.ids().split_last()?;
        let mut graph = &self.look().graph;
        for group in groups {
            graph = &self.definition_of(&graph.nodes.get(group)?.kind)?.graph;
        }
        graph.nodes.get(last)
    }

    /// What is known of a target: its label, type, unit, range.
    pub(crate) fn port_at(&self, target: &Target) -> Option<Port> {
        match target {
            Target::Input { node, port } => {
                let kind = self.catalog.of(self.node_at(node)?)?;
                kind.inputs.get(kind.input(port.as_str())?).cloned()
            }
            Target::Light { field, .. } => Some(field_port(field)),
        }
    }

    /// What a target is called: what it belongs to, and what of it.
    pub(crate) fn names_of(&self, target: &Target) -> [String; 2] {
        let port = self.port_at(target);
        match target {
            Target::Input { node, port: name } => {
                let owner = self.node_at(node).map(|found| {
                    let kind = self.catalog.of(found).map(|kind| kind.label.to_string());
                    if found.name.is_empty() { kind.unwrap_or_default() } else { found.name.clone() }
                });
                let name = port.map_or_else(|| name.to_string(), |port| port.label.to_string());
                [owner.unwrap_or_else(|| node.to_string()), name]
            }
            Target::Light { light, field } => {
                [self.light_name(light), port.map_or_else(|| field.clone(), |port| port.label.to_string())]
            }
        }
    }

    /// What a light is called.
    pub(crate) fn light_name(&self, id: &LightId) -> String {
        let named = self.look().lights.get(id).filter(|light| !light.name.is_empty());
        named.map_or_else(|| id.to_string(), |light| light.name.clone())
    }

    /// What a target has without keys.
    pub(crate) fn own_value(&self, target: &Target) -> Option<Value> {
        match target {
            Target::Input { node, port: name } => {
                let node = self.node_at(node)?;
                if let Some(value) = node.values.get(name) {
                    return Some(value.clone());
                }
                let kind = self.catalog.of(node)?;
                let port = &kind.inputs[kind.input(name.as_str())?];
                let same = match &port.fallback {
                    Fallback::Same(other) => &kind.inputs[kind.input(other.as_str())?],
                    _ => port,
                };
                values::current(same, node.values.get(&same.name)).cloned()
            }
            Target::Light { light, field } => light_field(self.look().lights.get(light)?, field),
        }
    }

    /// What a target has now.
    pub(crate) fn value_now(&self, target: &Target) -> Option<Value> {
        self.keyed.now.values.get(target).cloned().or_else(|| self.own_value(target))
    }

    /// What moves a target. Direction keys lie over those of time.
    pub(crate) fn keyed_by(&self, target: &Target) -> KeyedBy {
        let look = self.look();
        let has_it = |keys: &DirectionKeys| keys.keys.iter().any(|key| key.values.contains_key(target));
        if let Some(set) = look.direction_keys.iter().rposition(has_it) {
            return KeyedBy::Direction(set);
        }
        match look.time_keys.iter().position(|track| track.target == *target) {
            Some(track) => KeyedBy::Time(track),
            None => KeyedBy::Nothing,
        }
    }

    /// The key of a set at which values are set: the one that is selected, or else the one that weighs most.
    pub(crate) fn key_at(&self, set: usize) -> usize {
        if let Some((_, key)) = self.key.filter(|(selected, _)| *selected == set) {
            return key;
        }
        let weights = self.decided(set).map(|(_, weights)| weights.as_slice()).unwrap_or_default();
        weights.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1)).map_or(0, |(key, _)| key)
    }

    /// What a hand on a target sets: the value of the key that is set there, or the document's own.
    pub(crate) fn value_at(&self, target: &Target) -> Option<Value> {
        match self.keyed_by(target) {
            KeyedBy::Direction(set) => {
                let key = self.look().direction_keys.get(set)?.keys.get(self.key_at(set))?;
                key.values.get(target).cloned().or_else(|| self.own_value(target))
            }
            KeyedBy::Time(_) => self.value_now(target),
            KeyedBy::Nothing => self.own_value(target),
        }
    }

    /// The edit by which a target has a value where it is looked at: at the playhead, at the direction key that is
    /// selected or weighs most, or at all.
    pub(crate) fn set_at(&self, target: &Target, value: Value) -> Edit {
        self.set_all_at([(target.clone(), value)])
    }

    /// The same of several targets.
    pub(crate) fn set_all_at(&self, values: impl IntoIterator<Item = (Target, Value)>) -> Edit {
        let mut edits = self.set_each_at(values);
        if edits.len() == 1 { edits.remove(0) } else { Edit::Group { edits } }
    }

    /// Edits replace whole sets, tracks and lights: what several values change of one of them is gathered.
    fn set_each_at(&self, values: impl IntoIterator<Item = (Target, Value)>) -> Vec<Edit> {
        let look = self.look();
        let (mut sets, mut lights, mut edits) = (IndexMap::new(), IndexMap::new(), Vec::new());
        for (target, value) in values {
            match (self.keyed_by(&target), &target) {
                (KeyedBy::Direction(set), _) => {
                    let keys = sets.entry(set).or_insert_with(|| look.direction_keys[set].clone());
                    if let Some(key) = keys.keys.get_mut(self.key_at(set)) {
                        key.values.insert(target, value);
                    }
                }
                (KeyedBy::Time(track), _) => edits.push(self.set_in_time(track, self.time, value)),
                (KeyedBy::Nothing, Target::Light { light, field }) => {
                    let of = look.lights.get(light).cloned().unwrap_or_default();
                    set_light_field(lights.entry(light.clone()).or_insert(of), field, &value);
                }
                (KeyedBy::Nothing, _) => edits.push(self.set_own(&target, value)),
            }
        }
        edits.extend(sets.into_iter().map(|(index, keys)| Edit::SetDirectionKeys { index, keys }));
        edits.extend(lights.into_iter().map(|(id, light)| Edit::SetLight { id, light }));
        edits
    }

    /// The edit that sets what a target has without keys.
    pub(crate) fn set_own(&self, target: &Target, value: Value) -> Edit {
        match target {
            Target::Input { node, port } => {
                let found = self.look().find(node);
                let graph = found.map_or(GraphId::Look, |found| found.graph);
                let id = node.last().cloned().unwrap_or_else(|| NodeId::new(""));
                Edit::SetValue { graph, id, port: port.clone(), value, index: None }
            }
            Target::Light { light, field } => {
                let mut changed = self.look().lights.get(light).cloned().unwrap_or_default();
                set_light_field(&mut changed, field, &value);
                Edit::SetLight { id: light.clone(), light: changed }
            }
        }
    }

    /// The edit that sets a target's value in one direction key.
    pub(crate) fn set_in_key(&self, set: usize, key: usize, target: &Target, value: Value) -> Edit {
        self.change_set(set, |keys| {
            if let Some(key) = keys.keys.get_mut(key) {
                key.values.insert(target.clone(), value);
            }
        })
    }

    /// The edit that changes a set of direction keys.
    pub(crate) fn change_set(&self, set: usize, change: impl FnOnce(&mut DirectionKeys)) -> Edit {
        let Some(keys) = self.look().direction_keys.get(set) else { return Edit::Group { edits: Vec::new() } };
        let mut keys = keys.clone();
        change(&mut keys);
        Edit::SetDirectionKeys { index: set, keys }
    }

    /// The edit that changes a track.
    pub(crate) fn change_track(&self, track: usize, change: impl FnOnce(&mut TimeKeys)) -> Edit {
        let Some(keys) = self.look().time_keys.get(track) else { return Edit::Group { edits: Vec::new() } };
        let mut keys = keys.clone();
        change(&mut keys);
        Edit::SetTimeKeys { index: track, keys }
    }

    /// The edit that sets a track's value at a time: of the key there, or of a new one, that goes on as the one before.
    pub(crate) fn set_in_time(&self, track: usize, time: f64, value: Value) -> Edit {
        self.change_track(track, |keys| put(keys, time, value))
    }

    /// The edit that keys a target at the playhead, with the value that it has there.
    pub(crate) fn key_in_time(&self, target: &Target) -> Option<Edit> {
        let value = self.value_now(target)?;
        if let Some(track) = self.look().time_keys.iter().position(|track| track.target == *target) {
            return Some(self.set_in_time(track, self.time, value));
        }
        let mut keys = TimeKeys { target: target.clone(), keys: Vec::new(), unknown: Unknown::new() };
        put(&mut keys, self.time, value);
        Some(Edit::AddTimeKeys { keys, index: None })
    }

    /// The edit that keys a target in a set: at all of its keys with the value that it has now, so that nothing changes
    /// yet.
    pub(crate) fn key_in_set(&self, set: usize, target: &Target) -> Option<Edit> {
        let value = self.value_now(target)?;
        Some(self.change_set(set, |keys| {
            keys.keys.iter_mut().for_each(|key| drop(key.values.insert(target.clone(), value.clone())));
        }))
    }

    /// The edit that begins a set with one key where the light or the view is now.
    pub(crate) fn new_set(&self, by: KeyDirection, target: Option<&Target>) -> Edit {
        let direction = self.direction_of(&by);
        let values = target.and_then(|target| Some((target.clone(), self.value_now(target)?))).into_iter().collect();
        let name = match &by {
            KeyDirection::View => "By the view".to_owned(),
            KeyDirection::Light(light) => format!("By {}", self.light_name(light)),
        };
        let key = DirectionKey { direction: rounded(direction), values, unknown: Unknown::new() };
        let scheme = KeyScheme::default();
        let keys = DirectionKeys { name, by, scheme, keys: vec![key], unknown: Unknown::new() };
        Edit::AddDirectionKeys { keys, index: None }
    }

    /// The edit that takes a target out of everything that moves it; it keeps the value that it has now.
    pub(crate) fn unkey(&self, target: &Target) -> Edit {
        let mut edits = Vec::new();
        for (index, keys) in self.look().direction_keys.iter().enumerate() {
            if keys.keys.iter().any(|key| key.values.contains_key(target)) {
                edits.push(self.change_set(index, |keys| {
                    keys.keys.iter_mut().for_each(|key| drop(key.values.shift_remove(target)));
                }));
            }
        }
        if let Some(index) = self.look().time_keys.iter().position(|track| track.target == *target) {
            edits.push(Edit::RemoveTimeKeys { index });
        }
        edits.extend(self.value_now(target).map(|value| self.set_own(target, value)));
        Edit::Group { edits }
    }

    /// The direction that decides now, as the keys of a set by it would be given.
    pub(crate) fn direction_of(&self, by: &KeyDirection) -> DVec3 {
        match by {
            KeyDirection::View => from_center_to_eye(&self.view),
            KeyDirection::Light(id) => {
                let keyed = self.keyed.now.lights.get(id).or_else(|| self.look().lights.get(id));
                keyed.map_or(DVec3::Z, |light| light_in_camera(light, &self.view))
            }
        }
    }
}

/// Toward a light from the object, in camera axes.
pub(crate) fn light_in_camera(light: &Light, view: &Orbit) -> DVec3 {
    let camera = camera_from_world(view);
    let resolved = crate::compile::LightValues::new(light, view.illumination, camera);
    let toward = match light.kind {
        LightKind::Directional => resolved.direction,
        LightKind::Point | LightKind::Spot => resolved.position.try_normalize().unwrap_or(DVec3::Z),
    };
    camera * toward
}

/// From world to camera axes: x right, y up, z toward the viewer.
pub(crate) fn camera_from_world(view: &Orbit) -> DMat3 {
    let (right, up) = view.right_and_up();
    DMat3::from_cols(right, up, view.direction()).transpose()
}

/// From the object's centre to the eye, in world space.
fn from_center_to_eye(view: &Orbit) -> DVec3 {
    (view.target + view.direction() * view.distance).try_normalize().unwrap_or_else(|| view.direction())
}

/// A direction as files have it: four decimals are less than a hundredth of a degree.
pub(crate) fn rounded(direction: DVec3) -> [f64; 3] {
    direction.to_array().map(|x| (x * 1e4).round() / 1e4)
}

/// Puts a key at a time, or changes the one that is there.
fn put(keys: &mut TimeKeys, time: f64, value: Value) {
    let is_there = |key: &TimeKey| (key.time - time).abs() < 1e-6;
    if let Some(key) = keys.keys.iter_mut().find(|key| is_there(key)) {
        key.value = value;
        return;
    }
    let index = keys.keys.partition_point(|key| key.time < time);
    let before = index.checked_sub(1).or((!keys.keys.is_empty()).then_some(0)).and_then(|i| keys.keys.get(i));
    let has_between = matches!(value, Value::Number(_) | Value::Vector(_)) || value.color().is_some();
    let otherwise = if has_between { Interpolation::Smooth } else { Interpolation::Stepped };
    let interpolation = before.map_or(otherwise, |key| key.interpolation);
    keys.keys.insert(index, TimeKey { time, value, interpolation, unknown: Unknown::new() });
}

/// Whether direction keys can blend values of a type.
pub(crate) fn has_between(ty: &Type) -> bool {
    use Type::{Angle, Color, Composite, Float, Int, Vec2, Vec3, Vec4};
    matches!(ty, Float | Int | Angle | Vec2 | Vec3 | Vec4 | Color | Composite)
}

/// Whether values of a type can change with time.
pub(crate) fn changes_in_time(ty: &Type) -> bool {
    has_between(ty) || matches!(ty, Type::Bool | Type::Choice | Type::Curve | Type::Ramp)
}

/// A field of a light as if it were a port.
pub(crate) fn field_port(field: &str) -> Port {
    let (label, ty, unit) = match field {
        "direction" => ("Direction", Type::Vec3, ""),
        "position" => ("Position", Type::Vec3, ""),
        "aim" => ("Aim", Type::Vec3, ""),
        "color" => ("Color", Type::Color, ""),
        "intensity" => ("Intensity", Type::Float, ""),
        "inner" => ("Full cone", Type::Float, "rad"),
        "outer" => ("Whole cone", Type::Float, "rad"),
        "half_distance" => ("Half distance", Type::Float, ""),
        _ => ("Range", Type::Float, ""),
    };
    let is_float = ty == Type::Float;
    let range = if unit == "rad" { [Some(0.0), Some(std::f64::consts::FRAC_PI_2)] } else { [Some(0.0), None] };
    let [min, max] = if is_float { range } else { [None, None] };
    Port { label: label.into(), ty, unit: unit.to_owned(), min, max, ..Port::named(field) }
}

/// The targets that the keys of a set change, each once, in the order in which they first come.
pub(crate) fn targets_of(keys: &DirectionKeys) -> Vec<Target> {
    let mut seen = HashMap::new();
    let all = keys.keys.iter().flat_map(|key| key.values.keys());
    all.filter(|target| seen.insert((*target).clone(), ()).is_none()).cloned().collect()
}
