//! Keys of a track moved, scaled, shaped, copied and pasted: what an animator does to a selection.
//!
//! All functions take a track as it was before a gesture and give it anew, so that a drag can go to
//! and fro without loss.

use crate::document::{HandlePair, TimeInterpolation, TimeKey, TimeKeys, TrackEnds, Value};
use crate::frame::Track;

/// Keys nearer than this are at one time, in seconds.
pub(crate) const SAME_TIME: f64 = 1e-6;

/// A track after an edit, and the indices of the keys that were edited.
pub(crate) type EditedTrack = (TimeKeys, Vec<usize>);

/// Moves keys in time; `scale` is the factor by which their handles grow. A key that comes to where
/// another one is takes its place.
pub(crate) fn retimed(
    track: &TimeKeys,
    selected: &[usize],
    scale: f64,
    time: impl Fn(f64) -> f64,
) -> EditedTrack {
    let mut keys: Vec<(TimeKey, bool)> = Vec::with_capacity(track.keys.len());
    let is_selected = |index: usize| selected.binary_search(&index).is_ok();
    for (index, key) in track.keys.iter().enumerate() {
        let mut key = key.clone();
        if is_selected(index) {
            key.time = time(key.time);
            let handles = key.incoming.iter_mut().chain(&mut key.outgoing);
            handles.for_each(|handle| handle[0] *= scale);
        }
        keys.push((key, is_selected(index)));
    }
    placed(track, keys)
}

/// A track with keys in order, one at a time: of several the last that is marked, or else the last.
fn placed(track: &TimeKeys, mut keys: Vec<(TimeKey, bool)>) -> EditedTrack {
    keys.sort_by(|(a, _), (b, _)| a.time.total_cmp(&b.time));
    let mut kept: Vec<(TimeKey, bool)> = Vec::with_capacity(keys.len());
    for (key, is_marked) in keys {
        match kept.last_mut().filter(|(last, _)| key.time - last.time < SAME_TIME) {
            Some(last) if is_marked || !last.1 => *last = (key, is_marked),
            Some(_) => {}
            None => kept.push((key, is_marked)),
        }
    }
    let marked = kept.iter().enumerate().filter(|(_, (_, is_marked))| *is_marked);
    let marked = marked.map(|(index, _)| index).collect();
    let keys = kept.into_iter().map(|(key, _)| key).collect();
    (TimeKeys { keys, ..track.clone() }, marked)
}

/// The track without the selected keys.
pub(crate) fn without(track: &TimeKeys, selected: &[usize]) -> TimeKeys {
    let kept = track.keys.iter().enumerate();
    let kept = kept.filter(|(index, _)| selected.binary_search(index).is_err());
    TimeKeys { keys: kept.map(|(_, key)| key.clone()).collect(), ..track.clone() }
}

/// The track with copies of keys, later by so many seconds; the copies are what is edited.
pub(crate) fn with_copies(track: &TimeKeys, copies: &[TimeKey], later: f64) -> EditedTrack {
    let own = track.keys.iter().cloned().map(|key| (key, false));
    let copies = copies.iter().cloned().map(|mut key| {
        key.time = tidy(key.time + later);
        (key, true)
    });
    placed(track, own.chain(copies).collect())
}

/// The track with another interpolation from the selected keys on.
pub(crate) fn interpolated(
    track: &TimeKeys,
    selected: &[usize],
    interpolation: TimeInterpolation,
) -> TimeKeys {
    changed(track, selected, |key| key.interpolation = interpolation)
}

/// The track with automatic handles at the selected keys, or with the handles that they have,
/// moved together or each for itself.
pub(crate) fn with_handles(
    track: &TimeKeys,
    selected: &[usize],
    pair: Option<HandlePair>,
) -> TimeKeys {
    let Some(pair) = pair else {
        return changed(track, selected, |key| {
            key.incoming.clear();
            key.outgoing.clear();
            key.handles = HandlePair::Aligned;
        });
    };
    let mut edited = track.clone();
    for &index in selected {
        let Some(handles) = handles_of(Track::of(track), index) else { continue };
        let Some(key) = edited.keys.get_mut(index) else { continue };
        [key.incoming, key.outgoing] = handles;
        key.handles = pair;
        if pair == HandlePair::Aligned {
            align(key);
        }
    }
    edited
}

/// The handles of a key, toward the key before and the next, with those that are automatic; `None`
/// for words.
pub(crate) fn handles_of(track: Track<'_>, index: usize) -> Option<[Vec<[f64; 2]>; 2]> {
    let width = track.numbers(index)?.len();
    let incoming = (0..width).map(|at| track.incoming(index, at)).collect();
    let outgoing = (0..width).map(|at| track.outgoing(index, at)).collect();
    Some([incoming, outgoing])
}

/// Turns the incoming handles of a key into line with the outgoing ones; their times stay.
fn align(key: &mut TimeKey) {
    for (incoming, outgoing) in key.incoming.iter_mut().zip(&key.outgoing) {
        if outgoing[0] > 0.0 && incoming[0] < 0.0 {
            incoming[1] = incoming[0] * outgoing[1] / outgoing[0];
        }
    }
}

/// The track with a handle of a key at another place: an offset in seconds and one in value, in one
/// number of the value. The other handle turns with it, unless the key's handles are free.
pub(crate) fn with_handle(
    track: &TimeKeys,
    index: usize,
    at: usize,
    is_outgoing: bool,
    to: [f64; 2],
) -> TimeKeys {
    let mut edited = track.clone();
    let Some(handles) = handles_of(Track::of(track), index) else { return edited };
    let Some(key) = edited.keys.get_mut(index) else { return edited };
    [key.incoming, key.outgoing] = handles;
    let is_free = key.handles == HandlePair::Free;
    let (own, other, way) = match is_outgoing {
        true => (&mut key.outgoing, &mut key.incoming, 1.0),
        false => (&mut key.incoming, &mut key.outgoing, -1.0),
    };
    // Without the sign of 0.
    let time = tidy(way * (way * to[0]).max(0.0)) + 0.0;
    if let Some(own) = own.get_mut(at) {
        *own = [time, to[1]];
    }
    if let Some(other) = other.get_mut(at).filter(|_| !is_free && time != 0.0) {
        other[1] = other[0] * to[1] / time;
    }
    edited
}

/// The track with one number of the selected keys' values changed.
pub(crate) fn raised(track: &TimeKeys, selected: &[usize], at: usize, by: f64) -> TimeKeys {
    changed(track, selected, |key| match &mut key.value {
        Value::Number(x) if at == 0 => *x += by,
        Value::Vector(numbers) => {
            if let Some(x) = numbers.get_mut(at) {
                *x += by;
            }
        }
        Value::Text(_) => {
            if let Some(mut color) = key.value.color() {
                color[at.min(3)] += by;
                let is_opaque = color[3] == 1.0;
                let width = if is_opaque { 3 } else { 4 };
                key.value = Value::Vector(color[..width].to_vec());
            }
        }
        _ => {}
    })
}

/// The track with other values beyond its keys.
pub(crate) fn with_ends(track: &TimeKeys, ends: TrackEnds) -> TimeKeys {
    TimeKeys { before: ends.before, after: ends.after, ..track.clone() }
}

fn changed(track: &TimeKeys, selected: &[usize], change: impl Fn(&mut TimeKey)) -> TimeKeys {
    let mut edited = track.clone();
    for &index in selected {
        edited.keys.get_mut(index).into_iter().for_each(&change);
    }
    edited
}

/// Time rounded to microseconds, which are fine enough and read better in a file.
pub(crate) fn tidy(time: f64) -> f64 {
    (time * 1e6).round() / 1e6
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Target;

    fn track(keys: &[(f64, f64)]) -> TimeKeys {
        let key = |&(time, value): &(f64, f64)| {
            TimeKey::new(time, Value::Number(value), TimeInterpolation::Bezier)
        };
        let target = Target::parse("a.x").unwrap();
        TimeKeys { keys: keys.iter().map(key).collect(), ..TimeKeys::new(target) }
    }

    fn told(track: &TimeKeys) -> Vec<(f64, f64)> {
        let number = |value: &Value| if let Value::Number(x) = value { *x } else { f64::NAN };
        track.keys.iter().map(|key| (key.time, number(&key.value))).collect()
    }

    #[test]
    fn keys_pass_others_and_take_their_places() {
        let before = track(&[(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)]);
        let (passed, marked) = retimed(&before, &[0], 1.0, |time| time + 1.5);
        assert_eq!(told(&passed), [(1.0, 1.0), (1.5, 0.0), (2.0, 2.0)]);
        assert_eq!(marked, [1]);
        let (over, marked) = retimed(&before, &[0, 1], 1.0, |time| time + 1.0);
        assert_eq!((told(&over), marked), (vec![(1.0, 0.0), (2.0, 1.0)], vec![0, 1]));
    }

    #[test]
    fn handles_grow_with_the_time_between_keys() {
        let mut before = track(&[(0.0, 0.0), (1.0, 1.0)]);
        before.keys[0].outgoing = vec![[0.5, 0.25]];
        let (stretched, _) = retimed(&before, &[0, 1], 2.0, |time| 2.0 * time);
        assert_eq!(stretched.keys[0].outgoing, [[1.0, 0.25]]);
        // The curve is the same, twice as slow.
        for i in 0..=20 {
            let time = f64::from(i) / 20.0;
            let of = |track: &TimeKeys, time: f64| Track::of(track).at(time);
            let (Some(Value::Number(a)), Some(Value::Number(b))) =
                (of(&before, time), of(&stretched, 2.0 * time))
            else {
                panic!()
            };
            assert!((a - b).abs() < 1e-12);
        }
    }

    #[test]
    fn copies_stand_later_and_replace_what_is_there() {
        let before = track(&[(0.0, 0.0), (1.0, 1.0)]);
        let (copied, marked) = with_copies(&before, &before.keys, 1.0);
        assert_eq!((told(&copied), marked), (vec![(0.0, 0.0), (1.0, 0.0), (2.0, 1.0)], vec![1, 2]));
        assert_eq!(told(&without(&copied, &[0, 2])), [(1.0, 0.0)]);
    }

    #[test]
    fn a_handle_turns_the_other_unless_they_are_free() {
        let before = track(&[(0.0, 0.0), (1.0, 1.0), (2.0, 4.0)]);
        let turned = with_handle(&before, 1, 0, true, [0.5, 2.0]);
        let key = &turned.keys[1];
        assert_eq!(key.outgoing, [[0.5, 2.0]]);
        assert!((key.incoming[0][1] / key.incoming[0][0] - 4.0).abs() < 1e-12);
        let free = with_handles(&before, &[1], Some(HandlePair::Free));
        let moved = with_handle(&free, 1, 0, true, [-3.0, 2.0]);
        assert_eq!(moved.keys[1].outgoing, [[0.0, 2.0]], "no handle leads backwards");
        assert_eq!(moved.keys[1].incoming, free.keys[1].incoming);
        let automatic = with_handles(&moved, &[1], None);
        assert_eq!(automatic, before);
    }
}
