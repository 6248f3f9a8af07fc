//! A key that is added to a track and leaves its curve as it is.
//!
//! A cubic is split in two (de Casteljau), in time as in value. Automatic handles nearby, which
//! would turn toward the new key, are written out where they lie.

use super::retime::SAME_TIME;
use crate::document::{Extrapolation, HandlePair, TimeInterpolation, TimeKey};
use crate::frame::{BezierSpan, Track};

/// Values of a straight cubic, which are its parameter.
const STRAIGHT: [f64; 4] = [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0];
/// Change of a handle's value, as a share of its size, that is rounding.
const ROUNDING: f64 = 1e-12;

/// Handles about a place where a cubic is split: of the key before toward the next, of the new key
/// toward both, and of the key after toward the one before.
type SplitHandles = [[f64; 2]; 4];

/// The keys of a track with one more, in seconds or whatever the track is in, where values at all
/// times are as before. `None` for a track without keys.
///
/// Directions and rotations on cubics, which have length 1, move a little between keys. Keys that
/// come again do so from the new one on, where it lies beyond them.
pub(crate) fn with_key(track: Track<'_>, time: f64) -> Option<Vec<TimeKey>> {
    let value = track.at(time)?;
    let mut keys = track.keys.to_vec();
    if keys.iter().any(|key| (key.time - time).abs() < SAME_TIME) {
        return Some(keys);
    }
    let next = keys.partition_point(|key| key.time < time);
    let from = next.saturating_sub(1);
    keys.insert(next, TimeKey::new(time, value, keys[from].interpolation));
    if next == 0 {
        lead(track, &mut keys, [0, 1], true);
    } else if next == track.keys.len() {
        lead(track, &mut keys, [next, from], false);
    } else {
        split(track, &mut keys, next);
    }
    keep_handles(track, &mut keys, next);
    Some(keys)
}

/// Splits the cubic on which a new key lies.
fn split(track: Track<'_>, keys: &mut [TimeKey], new: usize) {
    let is_eased = keys[new].interpolation == TimeInterpolation::Smooth;
    if !(is_eased && !track.turns || keys[new].interpolation == TimeInterpolation::Bezier) {
        return;
    }
    let (start, end) = (keys[new - 1].time, keys[new + 1].time);
    let (share, length) = ((keys[new].time - start) / (end - start), end - start);
    let Some(mut spans) = track.spans(new - 1) else { return };
    if is_eased {
        for span in &mut spans {
            let [a, .., d] = span.values;
            *span = BezierSpan { times: [1.0 / 3.0, 2.0 / 3.0], values: [a, a, d, d] };
        }
        for key in &mut keys[new - 1..=new + 1] {
            key.handles = HandlePair::Free;
        }
        keys[new - 1].interpolation = TimeInterpolation::Bezier;
        keys[new].interpolation = TimeInterpolation::Bezier;
    }
    let values: Vec<f64> = spans.iter().map(|span| span.at(share)).collect();
    let size = match track.turns {
        true => values.iter().map(|x| x * x).sum::<f64>().sqrt().max(f64::MIN_POSITIVE),
        false => 1.0,
    };
    let parts: Vec<SplitHandles> = spans.iter().map(|span| parts(span, share, length)).collect();
    let of = |side: usize, size: f64, width: usize| -> Vec<[f64; 2]> {
        let sides = parts.iter().map(|part| part[side]).take(width);
        sides.map(|[time, value]| [time, value / size]).collect()
    };
    let width = |key: usize| track.numbers(key).map_or(parts.len(), |numbers| numbers.len());
    keys[new - 1].outgoing = of(0, 1.0, width(new - 1));
    keys[new].incoming = of(1, size, parts.len());
    keys[new].outgoing = of(2, size, parts.len());
    keys[new + 1].incoming = of(3, 1.0, width(new));
}

/// The handles of a cubic that is split at a share of its length.
fn parts(span: &BezierSpan, share: f64, length: f64) -> SplitHandles {
    let s = BezierSpan { times: span.times, values: STRAIGHT }.at(share);
    let [p, q] = span.times;
    let [a, b, c, d] = span.values;
    let between = |[t, x]: [f64; 2], [u, y]: [f64; 2]| [t + s * (u - t), x + s * (y - x)];
    let points = [[0.0, a], [p, b], [q, c], [1.0, d]];
    let [first, middle, last] = [0, 1, 2].map(|at| between(points[at], points[at + 1]));
    let (before, after) = (between(first, middle), between(middle, last));
    let here = between(before, after);
    let off = |[t, x]: [f64; 2], [u, y]: [f64; 2]| [(t - u) * length, x - y];
    [off(first, points[0]), off(before, here), off(after, here), off(last, points[3])]
}

/// Leads from the end of the keys to a new one beyond it, as values went on there.
fn lead(track: Track<'_>, keys: &mut [TimeKey], [new, end]: [usize; 2], is_first: bool) {
    let side = if is_first { track.ends.before } else { track.ends.after };
    let slopes = match side {
        Extrapolation::Hold => None,
        Extrapolation::Linear => track.end_slope(is_first),
        // Another last key changes what comes again: nothing leads there as before.
        _ => return,
    };
    let start = new.min(end);
    let is_cubic = keys[start].interpolation == TimeInterpolation::Bezier && !track.turns;
    let third = (keys[new].time - keys[end].time) / 3.0;
    let toward = |third: f64| -> Vec<[f64; 2]> {
        let slopes = slopes.iter().flatten();
        slopes.map(|slope| [third, slope * third]).collect()
    };
    if slopes.is_some() && !is_cubic {
        keys[start].interpolation = TimeInterpolation::Linear;
        return;
    }
    // Automatic ones are flat where values hold.
    let (near, far) = (toward(third), toward(-third));
    let (of_end, of_new) = match is_first {
        true => (&mut keys[end].incoming, far),
        false => (&mut keys[end].outgoing, far),
    };
    *of_end = near;
    match is_first {
        true => keys[new].outgoing = of_new,
        false => keys[new].incoming = of_new,
    }
}

/// Writes automatic handles out that would have turned toward a new key.
fn keep_handles(track: Track<'_>, keys: &mut [TimeKey], new: usize) {
    let last = track.keys.len() - 1;
    let mut kept: Vec<(usize, bool, Vec<[f64; 2]>)> = Vec::new();
    let after = Track { keys, ..track };
    let mut near = vec![0, new.saturating_sub(1), new.min(last), last];
    near.dedup();
    for old in near {
        let at = if old < new { old } else { old + 1 };
        let Some(width) = track.numbers(old).map(|numbers| numbers.len()) else { continue };
        let is_cubic = |key: usize| keys[key].interpolation == TimeInterpolation::Bezier;
        // Toward the new key, the handles are those of the parts.
        let leads_in = at > 0 && at - 1 != new && is_cubic(at - 1);
        let leads_out = at + 1 < keys.len() && at + 1 != new && is_cubic(at);
        let incoming = |of: Track<'_>, key: usize| -> Vec<[f64; 2]> {
            (0..width).map(|number| of.incoming(key, number)).collect()
        };
        let outgoing = |of: Track<'_>, key: usize| -> Vec<[f64; 2]> {
            (0..width).map(|number| of.outgoing(key, number)).collect()
        };
        let (then, now) = (incoming(track, old), incoming(after, at));
        if leads_in && !are_same(&then, &now) {
            kept.push((at, false, then));
        }
        let (then, now) = (outgoing(track, old), outgoing(after, at));
        if leads_out && !are_same(&then, &now) {
            kept.push((at, true, then));
        }
    }
    for (at, is_outgoing, handles) in kept {
        match is_outgoing {
            true => keys[at].outgoing = handles,
            false => keys[at].incoming = handles,
        }
    }
}

fn are_same(one: &[[f64; 2]], two: &[[f64; 2]]) -> bool {
    let is_near = |a: f64, b: f64| (a - b).abs() <= ROUNDING * a.abs().max(b.abs());
    one.iter().zip(two).all(|(a, b)| is_near(a[0], b[0]) && is_near(a[1], b[1]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{TrackEnds, Value};

    fn keys(interpolation: TimeInterpolation, all: &[(f64, &[f64])]) -> Vec<TimeKey> {
        let key = |(time, numbers): &(f64, &[f64])| {
            TimeKey::new(*time, Value::Vector(numbers.to_vec()), interpolation)
        };
        all.iter().map(key).collect()
    }

    /// Greatest difference that a key at a time makes to the values from -4 to 8.
    fn change(track: Track<'_>, time: f64) -> f64 {
        let with = with_key(track, time).unwrap();
        assert_eq!(with.len(), track.keys.len() + 1, "at {time}");
        let after = Track { keys: &with, ..track };
        let difference = |time: f64| -> f64 {
            let (Some(Value::Vector(a)), Some(Value::Vector(b))) = (track.at(time), after.at(time))
            else {
                panic!("no numbers at {time}")
            };
            assert_eq!(a.len(), b.len());
            a.iter().zip(&b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        };
        (0..=600).map(|i| difference(f64::from(i) / 50.0 - 4.003)).fold(0.0, f64::max)
    }

    const SHAPE: [(f64, &[f64]); 4] =
        [(0.0, &[0.0, 1.0]), (1.0, &[1.0, 1.0]), (1.5, &[3.0, -2.0]), (3.0, &[4.0, 0.5])];

    #[test]
    fn no_key_between_others_bends_a_curve() {
        use Extrapolation::{Cycle, CycleOffset, Hold, Linear, Mirror};
        use TimeInterpolation::{Bezier, Smooth, Stepped};
        let mut own = keys(Bezier, &SHAPE);
        own[1].outgoing = vec![[0.4, 0.1], [0.05, 2.0]];
        own[2].incoming = vec![[-0.3, 0.9], [-0.2, 0.0]];
        own[2].handles = HandlePair::Free;
        let mixed = {
            let mut mixed = keys(Bezier, &SHAPE);
            mixed[1].interpolation = TimeInterpolation::Linear;
            mixed
        };
        let all = [keys(Bezier, &SHAPE), own, mixed, keys(Smooth, &SHAPE), keys(Stepped, &SHAPE)];
        for (number, keys) in all.iter().enumerate() {
            for side in [Hold, Linear, Cycle, CycleOffset, Mirror] {
                let ends = TrackEnds { before: side, after: side };
                let track = Track { keys, ends, turns: false };
                for time in [0.1, 0.75, 1.25, 1.499, 2.0, 2.9] {
                    let change = change(track, time);
                    assert!(change < 1e-9, "{change} by a key at {time} in {number}, {side:?}");
                }
            }
        }
    }

    /// A light that falls from frame 1 to 24 by two keys with automatic handles, keyed at 11.
    #[test]
    fn a_key_between_the_only_two_bends_nothing() {
        let fall: [(f64, &[f64]); 2] = [(1.0, &[1.0]), (24.0, &[0.5])];
        for scale in [1.0, 1.0 / 24.0] {
            let in_time = fall.map(|(frame, numbers)| (frame * scale, numbers));
            let keys = keys(TimeInterpolation::Bezier, &in_time);
            let track = Track { keys: &keys, ends: TrackEnds::default(), turns: false };
            let with = with_key(track, 11.0 * scale).unwrap();
            let after = Track { keys: &with, ..track };
            for frame in 1..=24 {
                let [a, b] = [track, after].map(|of| of.at(f64::from(frame) * scale));
                let (Some(Value::Vector(a)), Some(Value::Vector(b))) = (a, b) else {
                    panic!("no number at frame {frame}")
                };
                assert!((a[0] - b[0]).abs() < 1e-9, "{} became {} at {frame}", a[0], b[0]);
            }
        }
    }

    #[test]
    fn a_key_beyond_others_goes_on_as_they_did() {
        use Extrapolation::{Hold, Linear};
        for interpolation in [
            TimeInterpolation::Bezier,
            TimeInterpolation::Smooth,
            TimeInterpolation::Linear,
            TimeInterpolation::Stepped,
        ] {
            let mut keys = keys(interpolation, &SHAPE);
            keys[3].outgoing = vec![[0.5, 1.0]; 2];
            for side in [Hold, Linear] {
                let ends = TrackEnds { before: side, after: side };
                for time in [-1.0, 4.0] {
                    let change = change(Track { keys: &keys, ends, turns: false }, time);
                    assert!(change < 1e-9, "{change} at {time}: {interpolation:?}, {side:?}");
                }
            }
        }
    }

    #[test]
    fn directions_move_a_little_at_most() {
        let shape: [(f64, &[f64]); 3] =
            [(0.0, &[0.0, 0.0, 1.0]), (1.0, &[0.6, 0.0, 0.8]), (3.0, &[0.0, 1.0, 0.0])];
        for (interpolation, most) in
            [(TimeInterpolation::Bezier, 0.05), (TimeInterpolation::Linear, 0.08)]
        {
            let keys = keys(interpolation, &shape);
            let track = Track { keys: &keys, ends: TrackEnds::default(), turns: true };
            for time in [0.4, 1.5, 2.5] {
                let change = change(track, time);
                assert!(change < most, "{change} at {time}: {interpolation:?}");
            }
        }
    }

    #[test]
    fn a_key_that_is_there_stays() {
        let keys = keys(TimeInterpolation::Bezier, &SHAPE);
        let track = Track { keys: &keys, ends: TrackEnds::default(), turns: false };
        assert_eq!(with_key(track, 1.0).unwrap(), keys);
        assert_eq!(with_key(Track { keys: &[], ..track }, 1.0), None);
    }
}
