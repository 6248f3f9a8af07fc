//! Tracks: a value at a time, and the words and switches that change what is compiled.

use std::borrow::Cow;

use super::blend::blend;
use crate::document::{Interpolation, Look, Target, TimeKey, Value, Values};

/// The value of a track at a time; `None` for an empty track. Before the first key and after the
/// last, that key's value holds.
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

/// The value between two keys' values; values that cannot be blended (words, switches, curves) hold
/// the first until the second.
fn mix(a: &Value, b: &Value, t: f64, is_direction: bool) -> Value {
    let weights = [1.0 - t, t];
    blend(&[a, b], &weights, is_direction).unwrap_or_else(|| a.clone())
}

/// The look with the words and switches that its time keys and `exposed` values set at that time:
/// the state that is compiled.
pub fn structural_look<'l>(look: &'l Look, time: f64, exposed: &Values) -> Cow<'l, Look> {
    let timed = look
        .time_keys
        .iter()
        .filter_map(|track| Some((&track.target, at_time(&track.keys, time, false)?)));
    let set = look.exposed.iter().filter_map(|e| Some((&e.target, exposed.get(&e.name)?.clone())));
    let mut changed = Cow::Borrowed(look);
    for (target, value) in set.chain(timed) {
        let Target::Input { node, port } = target else { continue };
        let is_word = matches!(&value, Value::Text(_)) && value.color().is_none();
        // Inside a definition a value belongs to every use of the definition, so only the look's
        // own nodes can be set.
        if let (true, [id]) = (is_word, node.ids())
            && let Some(node) = changed.to_mut().graph.nodes.get_mut(id)
        {
            node.values.insert(port.clone(), value);
        }
    }
    changed
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::UnknownFields;

    fn track(interpolation: Interpolation) -> Vec<TimeKey> {
        [(1.0, 10.0), (3.0, 20.0)]
            .map(|(time, value)| TimeKey {
                time,
                value: Value::Number(value),
                interpolation,
                unknown: UnknownFields::new(),
            })
            .to_vec()
    }

    #[test]
    fn tracks_hold_outside_and_go_as_asked_between() {
        let number = |keys: &[TimeKey], time| match at_time(keys, time, false) {
            Some(Value::Number(x)) => x,
            other => panic!("{other:?}"),
        };
        let linear = track(Interpolation::Linear);
        assert_eq!(
            [0.0, 1.0, 1.5, 3.0, 9.0].map(|t| number(&linear, t)),
            [10.0, 10.0, 12.5, 20.0, 20.0]
        );
        assert_eq!(number(&track(Interpolation::Smooth), 1.5), 10.0 + 10.0 * (0.25 * 0.25 * 2.5));
        assert_eq!(number(&track(Interpolation::Stepped), 2.999), 10.0);
        assert!(at_time(&[], 0.0, false).is_none());
    }
}
