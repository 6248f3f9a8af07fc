//! Edits that key values, and that set values at the key in view.

use indexmap::IndexMap;

use super::split::with_key;
use super::{KeyedBy, KeyedLook, retime, rounded, targets_of};
use crate::document::{
    DirectionKey, DirectionKeys, Edit, GraphId, KeyDirection, KeyScheme, Target, TimeInterpolation,
    TimeKey, TimeKeys, UnknownFields, Value,
};
use crate::frame::{Track, set_light_field};
use crate::ids::NodeId;
use crate::library::Fallback;

impl KeyedLook<'_> {
    /// The edit that sets a target's value in view: at the playhead, at the direction key that is
    /// selected or followed, or the document's own value.
    pub(crate) fn set_at(self, target: &Target, value: Value) -> Edit {
        self.set_all_at([(target.clone(), value)])
    }

    /// The edit that sets several targets' values in view.
    pub(crate) fn set_all_at(self, values: impl IntoIterator<Item = (Target, Value)>) -> Edit {
        let mut edits = self.set_each_at(values);
        if edits.len() == 1 { edits.remove(0) } else { Edit::Group { edits } }
    }

    /// Edits that set several targets' values in view. An edit replaces a whole set, track or
    /// light: values of the same set or light are gathered in one edit.
    fn set_each_at(self, values: impl IntoIterator<Item = (Target, Value)>) -> Vec<Edit> {
        let look = self.base.look;
        let (mut sets, mut lights, mut edits) = (IndexMap::new(), IndexMap::new(), Vec::new());
        for (target, value) in values {
            match (self.keyed_by(&target), &target) {
                (KeyedBy::Direction(set), _) => {
                    let keys = sets.entry(set).or_insert_with(|| look.direction_keys[set].clone());
                    if let Some(key) = keys.keys.get_mut(self.key_at(set)) {
                        key.values.insert(target, value);
                    }
                }
                (KeyedBy::Time(track), _) => {
                    edits.push(self.set_in_time(track, self.view.time, value));
                }
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

    /// The edit that sets a target's value without keys.
    pub(crate) fn set_own(self, target: &Target, value: Value) -> Edit {
        match target {
            Target::Input { node, port } => {
                let found = self.base.look.find(node);
                let graph = found.map_or(GraphId::Look, |found| found.graph);
                let id = node.last().cloned().unwrap_or_else(|| NodeId::new(""));
                Edit::SetValue { graph, id, port: port.clone(), value, index: None }
            }
            Target::Light { light, field } => {
                let mut changed = self.base.look.lights.get(light).cloned().unwrap_or_default();
                set_light_field(&mut changed, field, &value);
                Edit::SetLight { id: light.clone(), light: changed }
            }
        }
    }

    /// The edit that sets an input within a group for this use of the group alone: one key holds
    /// the value, as a shot has it.
    pub(crate) fn hold(self, target: &Target, value: Value) -> Edit {
        if let KeyedBy::Time(track) = self.keyed_by(target) {
            return self.change_track(track, |keys| {
                keys.keys.clear();
                put(keys, 0.0, value);
            });
        }
        let mut keys = TimeKeys::new(target.clone());
        put(&mut keys, 0.0, value);
        // Nodes of the library's groups have no place in the document.
        let has_place = |target: &&Target| match target {
            Target::Input { node, .. } => self.base.look.find(node).is_some(),
            Target::Light { .. } => false,
        };
        self.grounded(Some(target).filter(has_place), Edit::AddTimeKeys { keys, index: None })
    }

    /// The edit that sets a target's value in one direction key.
    pub(crate) fn set_in_key(self, set: usize, key: usize, target: &Target, value: Value) -> Edit {
        self.change_set(set, |keys| {
            if let Some(key) = keys.keys.get_mut(key) {
                key.values.insert(target.clone(), value);
            }
        })
    }

    /// The edit that changes a set of direction keys.
    pub(crate) fn change_set(self, set: usize, change: impl FnOnce(&mut DirectionKeys)) -> Edit {
        let Some(keys) = self.base.look.direction_keys.get(set) else {
            return Edit::Group { edits: Vec::new() };
        };
        let mut keys = keys.clone();
        change(&mut keys);
        Edit::SetDirectionKeys { index: set, keys }
    }

    /// The edit that changes a track.
    pub(crate) fn change_track(self, track: usize, change: impl FnOnce(&mut TimeKeys)) -> Edit {
        let Some(keys) = self.base.look.time_keys.get(track) else {
            return Edit::Group { edits: Vec::new() };
        };
        let mut keys = keys.clone();
        change(&mut keys);
        Edit::SetTimeKeys { index: track, keys }
    }

    /// The edit that sets a track's value at a time: in the key there, or in a new one with the
    /// interpolation of the key before.
    pub(crate) fn set_in_time(self, track: usize, time: f64, value: Value) -> Edit {
        self.change_track(track, |keys| put(keys, time, value))
    }

    /// The edit that adds a key to a track which leaves its curve as it is.
    pub(crate) fn add_in_time(self, track: usize, time: f64) -> Edit {
        self.change_track(track, |track| {
            if let Some(keys) = with_key(Track::of(track), time) {
                track.keys = keys;
            }
        })
    }

    /// The edit that keys a target at the playhead, with its present value.
    pub(crate) fn key_in_time(self, target: &Target) -> Option<Edit> {
        if let Some(track) =
            self.base.look.time_keys.iter().position(|track| track.target == *target)
        {
            return Some(self.add_in_time(track, self.view.time));
        }
        let value = self.value_now(target)?;
        let mut keys = TimeKeys::new(target.clone());
        put(&mut keys, self.view.time, value);
        Some(self.grounded(Some(target), Edit::AddTimeKeys { keys, index: None }))
    }

    /// The edit that keys a target in a set: at all keys of the set with the target's present
    /// value, so that nothing changes yet.
    pub(crate) fn key_in_set(self, set: usize, target: &Target) -> Option<Edit> {
        let value = self.value_now(target)?;
        let edit = self.change_set(set, |keys| {
            keys.keys
                .iter_mut()
                .for_each(|key| drop(key.values.insert(target.clone(), value.clone())));
        });
        Some(self.grounded(Some(target), edit))
    }

    /// The edit that adds a key to a set where that is now, with the present values.
    pub(crate) fn key_here(self, set: usize) -> Edit {
        self.change_set(set, |keys| {
            let targets = targets_of(keys).into_iter();
            let values = targets.filter_map(|target| {
                let value = self.value_now(&target)?;
                Some((target, value))
            });
            let (direction, values) = (rounded(self.direction_of(&keys.by)), values.collect());
            keys.keys.push(DirectionKey { direction, values, unknown: UnknownFields::new() });
        })
    }

    /// An edit that names a target in a list, after one that gives the target a value of its own
    /// where it has neither that nor a default: an input that reads its surroundings, or has the
    /// value of another input, cannot be moved or exposed.
    pub(crate) fn grounded(self, target: Option<&Target>, edit: Edit) -> Edit {
        let Some(target @ Target::Input { node, port }) = target else { return edit };
        let has_own = self.base.node_at(node).is_some_and(|node| node.values.contains_key(port));
        let has_default = self
            .base
            .port_at(target)
            .is_some_and(|port| matches!(port.fallback, Fallback::Value(_)));
        match self.base.own_value(target).filter(|_| !has_own && !has_default) {
            Some(value) => Edit::Group { edits: vec![self.set_own(target, value), edit] },
            None => edit,
        }
    }

    /// The edit that adds a set with one key at the present direction of the light or the view.
    pub(crate) fn new_set(self, by: KeyDirection, target: Option<&Target>) -> Edit {
        let direction = self.direction_of(&by);
        let values = target
            .and_then(|target| Some((target.clone(), self.value_now(target)?)))
            .into_iter()
            .collect();
        let name = match &by {
            KeyDirection::View => "By the view".to_owned(),
            KeyDirection::Light(light) => format!("By \"{}\"", self.base.light_name(light)),
            KeyDirection::Drivers(drivers) => drivers
                .iter()
                .map(|driver| self.english_driver_name(driver))
                .collect::<Vec<_>>()
                .join(", "),
        };
        let key =
            DirectionKey { direction: rounded(direction), values, unknown: UnknownFields::new() };
        let scheme = KeyScheme::default();
        let keys =
            DirectionKeys { name, by, scheme, keys: vec![key], unknown: UnknownFields::new() };
        self.grounded(target, Edit::AddDirectionKeys { keys, index: None })
    }

    /// The edit that takes a key out of a track, and with its last key the track; the target keeps
    /// its present value then.
    pub(crate) fn without_key(self, track: usize, key: usize) -> Option<Edit> {
        let of_track = self.base.look.time_keys.get(track)?;
        let keys = retime::without(of_track, &[key]);
        Some(match keys.keys.is_empty() {
            true => self.unkey(&of_track.target),
            false => Edit::SetTimeKeys { index: track, keys },
        })
    }

    /// The edit that takes a target out of all keys that move it; the target keeps its present
    /// value.
    pub(crate) fn unkey(self, target: &Target) -> Edit {
        let mut edits = Vec::new();
        for (index, keys) in self.base.look.direction_keys.iter().enumerate() {
            if keys.keys.iter().any(|key| key.values.contains_key(target)) {
                edits.push(self.change_set(index, |keys| {
                    keys.keys.iter_mut().for_each(|key| drop(key.values.shift_remove(target)));
                }));
            }
        }
        if let Some(index) =
            self.base.look.time_keys.iter().position(|track| track.target == *target)
        {
            edits.push(Edit::RemoveTimeKeys { index });
        }
        edits.extend(self.value_now(target).map(|value| self.set_own(target, value)));
        Edit::Group { edits }
    }
}

/// Inserts a key at a time, or changes the one that is there.
pub(super) fn put(keys: &mut TimeKeys, time: f64, value: Value) {
    let is_there = |key: &TimeKey| (key.time - time).abs() < 1e-6;
    if let Some(key) = keys.keys.iter_mut().find(|key| is_there(key)) {
        key.value = value;
        return;
    }
    let index = keys.keys.partition_point(|key| key.time < time);
    let before = index
        .checked_sub(1)
        .or((!keys.keys.is_empty()).then_some(0))
        .and_then(|i| keys.keys.get(i));
    let has_between =
        matches!(value, Value::Number(_) | Value::Vector(_)) || value.color().is_some();
    let otherwise =
        if has_between { TimeInterpolation::Bezier } else { TimeInterpolation::Stepped };
    let interpolation = before.map_or(otherwise, |key| key.interpolation);
    keys.keys.insert(index, TimeKey::new(time, value, interpolation));
}
