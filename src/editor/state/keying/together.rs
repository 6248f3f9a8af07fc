//! Edits of several values that an artist sees as one, such as the three angles of an edge: they
//! are set, keyed and freed of keys together.

use super::KeyedBy;
use super::KeyedLook;
use super::edits::put;
use crate::document::{DirectionKeys, Edit, KeyDirection, Target, TimeKeys, Value};

impl KeyedLook<'_> {
    /// The edit that sets values in view. Where keys move one of them, the others are keyed by the
    /// same keys first, so that what was set here stays as it was elsewhere.
    pub(crate) fn set_together(self, values: &[(Target, Value)]) -> Edit {
        let keyed: Vec<KeyedBy> = values.iter().map(|(target, _)| self.keyed_by(target)).collect();
        let first = keyed.iter().copied().find(|by| *by != KeyedBy::Nothing);
        let is_mixed = keyed.contains(&KeyedBy::Nothing);
        match first.filter(|_| is_mixed) {
            Some(KeyedBy::Direction(set))
                if keyed
                    .iter()
                    .all(|by| matches!(by, KeyedBy::Nothing) || *by == KeyedBy::Direction(set)) =>
            {
                let here = self.key_at(set);
                self.change_set(set, |keys| {
                    for (target, value) in values {
                        let present = self.value_now(target);
                        for (index, key) in keys.keys.iter_mut().enumerate() {
                            let own = || key.values.get(target).cloned().or(present.clone());
                            let at = if index == here { Some(value.clone()) } else { own() };
                            at.map(|value| key.values.insert(target.clone(), value));
                        }
                    }
                })
            }
            Some(KeyedBy::Time(track)) => {
                let (set, unkeyed): (Vec<_>, Vec<_>) = values
                    .iter()
                    .cloned()
                    .partition(|(target, _)| self.keyed_by(target) != KeyedBy::Nothing);
                let times: Vec<f64> = self
                    .base
                    .look
                    .time_keys
                    .get(track)
                    .map_or(Vec::new(), |of| of.keys.iter().map(|key| key.time).collect());
                let mut edits = vec![self.set_all_at(set)];
                for (target, value) in unkeyed {
                    let mut keys = TimeKeys::new(target.clone());
                    if let Some(present) = self.value_now(&target) {
                        times.iter().for_each(|time| put(&mut keys, *time, present.clone()));
                    }
                    put(&mut keys, self.view.time, value);
                    edits.push(Edit::AddTimeKeys { keys, index: None });
                }
                Edit::Group { edits }
            }
            _ => self.set_all_at(values.iter().cloned()),
        }
    }

    /// The edit that keys values at the playhead, as they are.
    pub(crate) fn key_together_in_time(self, targets: &[Target]) -> Edit {
        let edits = targets.iter().filter_map(|target| self.key_in_time(target));
        Edit::Group { edits: edits.collect() }
    }

    /// The edit that keys values in a set: at all of its keys as they are.
    pub(crate) fn key_together_in_set(self, set: usize, targets: &[Target]) -> Edit {
        self.change_set(set, |keys| self.insert_present(keys, targets))
    }

    /// The edit that adds a set with one key here that has the values as they are.
    pub(crate) fn new_set_together(self, by: KeyDirection, targets: &[Target]) -> Edit {
        let mut edit = self.new_set(by, targets.first());
        let keys = match &mut edit {
            Edit::AddDirectionKeys { keys, .. } => Some(keys),
            Edit::Group { edits } => edits.iter_mut().find_map(|edit| match edit {
                Edit::AddDirectionKeys { keys, .. } => Some(keys),
                _ => None,
            }),
            _ => None,
        };
        if let Some(keys) = keys {
            self.insert_present(keys, targets);
        }
        edit
    }

    /// The edit that takes values out of all keys that move them; they keep what they are now.
    pub(crate) fn unkey_together(self, targets: &[Target]) -> Edit {
        let has = |keys: &DirectionKeys| {
            let mut of_keys = keys.keys.iter();
            of_keys.any(|key| targets.iter().any(|target| key.values.contains_key(target)))
        };
        let sets = self.base.look.direction_keys.iter().enumerate();
        let mut edits: Vec<Edit> = sets
            .filter(|(_, keys)| has(keys))
            .map(|(index, _)| {
                self.change_set(index, |keys| {
                    for key in &mut keys.keys {
                        targets.iter().for_each(|target| drop(key.values.shift_remove(target)));
                    }
                })
            })
            .collect();
        // Tracks are removed from the last on, so that the indices of the others stay.
        let tracks = self.base.look.time_keys.iter().enumerate().rev();
        let tracks = tracks.filter(|(_, track)| targets.contains(&track.target));
        edits.extend(tracks.map(|(index, _)| Edit::RemoveTimeKeys { index }));
        let present = |target: &Target| Some(self.set_own(target, self.value_now(target)?));
        edits.extend(targets.iter().filter_map(present));
        Edit::Group { edits }
    }

    /// Puts the present values into all keys of a set.
    fn insert_present(self, keys: &mut DirectionKeys, targets: &[Target]) {
        for target in targets {
            let Some(value) = self.value_now(target) else { continue };
            for key in &mut keys.keys {
                key.values.insert(target.clone(), value.clone());
            }
        }
    }
}
