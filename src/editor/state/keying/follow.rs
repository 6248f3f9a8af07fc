//! Choice of the key of a set that takes values set by hand.

use super::KeyedLook;
use crate::document::OutputPort;

/// Weight by which another key must outweigh the followed one before it is followed instead: near a
/// tie nothing flickers.
const MARGIN: f64 = 0.2;

impl KeyedLook<'_> {
    /// By set, the key to follow: the heaviest, slowly; another one never while a value is held,
    /// which would go on at another key, nor while the shader does not have the wires yet that
    /// drive a set.
    pub(crate) fn followed(self, is_held: bool) -> Vec<usize> {
        let sets = &self.base.look.direction_keys;
        let followed = sets.iter().enumerate().map(|(set, keys)| {
            let heaviest = self.heaviest(set);
            let known =
                self.evaluation.followed.get(set).copied().filter(|&key| key < keys.keys.len());
            let Some(known) = known else { return heaviest };
            let knows = keys.by.outputs().all(|wire| self.knows_wire(wire));
            let weight =
                |key: usize| self.decided(set).and_then(|(_, weights)| weights.get(key)).copied();
            let outweighs = weight(heaviest).unwrap_or(0.0) - weight(known).unwrap_or(0.0) > MARGIN;
            if outweighs && !is_held && knows { heaviest } else { known }
        });
        followed.collect()
    }

    /// The key of a set at which values are set: the selected one, or else the followed one.
    pub(crate) fn key_at(self, set: usize) -> usize {
        let selected = self.selected_key.filter(|at| (at.owner, at.set) == (self.owner, set));
        if let Some(selected) = selected {
            return selected.key;
        }
        let count = self.base.look.direction_keys.get(set).map_or(0, |keys| keys.keys.len());
        let followed = self.evaluation.followed.get(set).copied().filter(|&key| key < count);
        followed.unwrap_or_else(|| self.heaviest(set))
    }

    /// The key of a set with the largest weight, the first of equals.
    fn heaviest(self, set: usize) -> usize {
        let weights = self.decided(set).map(|(_, weights)| weights.as_slice()).unwrap_or_default();
        let first_of_most = |best: (usize, f64), (key, &weight): (usize, &f64)| {
            if weight > best.1 { (key, weight) } else { best }
        };
        weights.iter().enumerate().fold((0, f64::MIN), first_of_most).0
    }

    fn knows_wire(self, wire: &OutputPort) -> bool {
        self.shader
            .is_some_and(|shader| shader.host.drivers.iter().any(|known| known.wire == *wire))
    }
}
