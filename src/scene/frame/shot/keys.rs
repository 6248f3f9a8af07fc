//! Keys of overrides: from frames to seconds, checked, and held by steps.

use chiaro_locale::tr;
use serde_json::{Value as Json, json};

use super::FrameClock;
use crate::diag::Diagnostic;
use crate::document::{
    BlendKind, Extrapolation, HandlePair, Override, ShotKey, Target, TimeInterpolation, TimeKey,
    TimeKeys, TrackEnds, UnknownFields, Value, json_of_value,
};
use crate::frame::keys::Track;

/// Most frames over which a value is held by steps.
const MOST_HELD: i64 = 100_000;

/// Keys in seconds, and the frames for which their value is held.
pub(super) struct TimedKeys {
    pub(super) keys: Vec<TimeKey>,
    pub(super) ends: TrackEnds,
    step: u32,
}

/// A key that cannot stand.
pub(super) struct WrongKey {
    /// Field of the override.
    pub(super) field: String,
    pub(super) problem: Diagnostic,
}

/// Keys of an override in seconds.
///
/// # Errors
/// The first key whose value cannot stand there.
pub(super) fn timed_keys(
    clock: FrameClock,
    changed: &Override,
    blend: BlendKind,
    check: &dyn Fn(&Value) -> Result<(), Diagnostic>,
) -> Result<TimedKeys, Box<WrongKey>> {
    let mut keys: Vec<TimeKey> = Vec::with_capacity(changed.keys.len());
    for (index, key) in changed.keys.iter().enumerate() {
        check(&key.value)
            .map_err(|problem| WrongKey { field: format!("keys[{index}].value"), problem })?;
        let mut value = key.value.clone();
        let mut sign = 1.0;
        if blend == BlendKind::Rotation
            && let Some(TimeKey { value: before, .. }) = keys.last()
            && is_the_longer_way(before, &value)
        {
            // The other sign is the same rotation.
            turn_sign(&mut value);
            sign = -1.0;
        }
        let handles = |handles: &[[f64; 2]]| {
            let in_seconds =
                |[frames, value]: &[f64; 2]| [clock.rate.time_within(*frames), sign * value];
            handles.iter().map(in_seconds).collect()
        };
        keys.push(TimeKey {
            time: clock.rate.time_within(key.frame),
            value,
            interpolation: key.interpolation,
            incoming: handles(&key.incoming),
            outgoing: handles(&key.outgoing),
            handles: key.handles,
            unknown: UnknownFields::new(),
        });
    }
    Ok(TimedKeys { keys, ends: changed.ends(), step: changed.step })
}

/// True if numbers between two quaternions are the rotations of the longer way.
fn is_the_longer_way(before: &Value, value: &Value) -> bool {
    let (Value::Vector(before), Value::Vector(value)) = (before, value) else { return false };
    before.iter().zip(value).map(|(a, b)| a * b).sum::<f64>() < 0.0
}

/// Turns the sign of a quaternion.
fn turn_sign(value: &mut Value) {
    if let Value::Vector(value) = value {
        value.iter_mut().for_each(|number| *number = -*number);
    }
}

impl TimedKeys {
    /// The track of a target, whose value is not held yet.
    ///
    /// # Errors
    /// Keys that reach over more frames than are held.
    pub(super) fn track(self, clock: FrameClock, target: Target) -> Result<TimeKeys, Diagnostic> {
        let (keys, TrackEnds { before, after }) = (self.keys, self.ends);
        let track = TimeKeys { before, after, keys, ..TimeKeys::new(target) };
        if self.step > 1 {
            held_frames(clock, Track::of(&track), self.step)?;
        }
        Ok(track)
    }
}

/// The track that holds the values of a track for so many frames. Values that go on beyond the keys
/// are held within the shot's frames; `None` for keys that reach over more frames than are held.
pub(super) fn held_track(clock: FrameClock, track: &TimeKeys, step: u32) -> Option<TimeKeys> {
    let (keys, TrackEnds { before, after }) = held(clock, Track::of(track), step).ok()?;
    Some(TimeKeys { before, after, keys, ..track.clone() })
}

/// Keys that hold the values of a track, and what holds beyond them.
///
/// # Errors
/// Keys that reach over more frames than are held.
fn held(
    clock: FrameClock,
    track: Track<'_>,
    step: u32,
) -> Result<(Vec<TimeKey>, TrackEnds), Diagnostic> {
    if step <= 1 {
        return Ok((track.keys.to_vec(), track.ends));
    }
    let (first, count) = held_frames(clock, track, step)?;
    let held = |index: i64| {
        let time = clock.rate.time(first + index as i32 * step as i32);
        Some(TimeKey::new(time, track.at(time)?, TimeInterpolation::Stepped))
    };
    Ok(((0..count).filter_map(held).collect(), TrackEnds::default()))
}

/// The first frame that is held, and the number of those.
///
/// # Errors
/// Keys that reach over more frames than are held.
fn held_frames(clock: FrameClock, track: Track<'_>, step: u32) -> Result<(i32, i64), Diagnostic> {
    let goes_on = |side: Extrapolation| side != Extrapolation::Hold;
    let frame = |key: Option<&TimeKey>| key.map_or(0.0, |key| clock.rate.frame_within(key.time));
    // Frames are bounded by the format.
    let mut first = frame(track.keys.first()).floor() as i32;
    let mut last = frame(track.keys.last()).ceil() as i32;
    if goes_on(track.ends.before) {
        first = first.min(clock.first);
    }
    if goes_on(track.ends.after) {
        last = last.max(clock.last);
    }
    let first = clock.held_frame(first, step);
    let count = (i64::from(last) - i64::from(first)) / i64::from(step) + 2;
    if count > MOST_HELD {
        let message = tr!("the keys reach over {count} steps; at most {MOST_HELD} are held");
        return Err(Diagnostic::error("too-many", message)
            .hint(tr!("write a greater step, or interpolation `stepped` for the keys")));
    }
    Ok((first, count))
}

/// Keys as files have them.
pub(super) fn json_of_keys(keys: &[ShotKey]) -> Json {
    let key = |key: &ShotKey| {
        let mut json = json!({ "frame": number(key.frame), "value": json_of_value(&key.value) });
        if key.interpolation != TimeInterpolation::default() {
            json["interpolation"] = json!(key.interpolation);
        }
        for (name, handles) in [("in", &key.incoming), ("out", &key.outgoing)] {
            if !handles.is_empty() {
                json[name] = json!(handles);
            }
        }
        if key.handles != HandlePair::default() {
            json["handles"] = json!(key.handles);
        }
        json
    };
    keys.iter().map(key).collect()
}

/// A number without a needless point.
fn number(number: f64) -> Json {
    if number.fract() == 0.0 { json!(number as i64) } else { json!(number) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::FrameRate;

    fn changed(keys: &[(f64, f64)], step: u32) -> Override {
        let key = |&(frame, value): &(f64, f64)| {
            ShotKey::new(frame, Value::Number(value), TimeInterpolation::Linear)
        };
        Override {
            look: None,
            target: "lights.key.intensity".to_owned(),
            value: None,
            before: Extrapolation::Hold,
            after: Extrapolation::Hold,
            keys: keys.iter().map(key).collect(),
            step,
            unknown: UnknownFields::new(),
        }
    }

    /// The keys with their values held.
    fn of(clock: FrameClock, of: &TimedKeys) -> Result<(Vec<TimeKey>, TrackEnds), Diagnostic> {
        held(clock, Track { keys: &of.keys, ends: of.ends, turns: false }, of.step)
    }

    #[test]
    fn a_value_is_held_from_the_shots_first_frame_on() {
        let clock = FrameClock { first: 1, last: 20, rate: FrameRate::FILM, shading_step: 1 };
        let keys = |step| {
            let changed = changed(&[(1.0, 0.0), (10.0, 9.0)], step);
            let keys = timed_keys(clock, &changed, BlendKind::Numbers, &|_| Ok(())).ok().unwrap();
            of(clock, &keys).unwrap().0
        };
        let at = |keys: &[TimeKey], frame| {
            let track = Track { keys, ends: TrackEnds::default(), turns: false };
            match track.at(clock.rate.time(frame)) {
                Some(Value::Number(number)) => (number * 1e9).round() / 1e9,
                other => panic!("{other:?}"),
            }
        };
        for frame in -3..20 {
            let on_ones = at(&keys(1), frame);
            assert_eq!(on_ones, f64::from(frame.clamp(1, 10) - 1), "{frame}");
            for step in [2, 3, 4] {
                let held = clock.held_frame(frame, step);
                assert_eq!(at(&keys(step), frame), at(&keys(1), held), "{frame} by {step}");
            }
        }
    }

    #[test]
    fn cycles_are_held_within_the_shot() {
        let clock = FrameClock { first: 1, last: 40, rate: FrameRate::FILM, shading_step: 1 };
        let mut changed = changed(&[(1.0, 0.0), (6.0, 5.0)], 2);
        changed.after = Extrapolation::Cycle;
        let keys = timed_keys(clock, &changed, BlendKind::Numbers, &|_| Ok(())).ok().unwrap();
        let (keys, ends) = of(clock, &keys).unwrap();
        let track = Track { keys: &keys, ends, turns: false };
        for frame in 7..=40 {
            let held = clock.held_frame(frame, 2);
            let wanted = if held <= 6 { held - 1 } else { (held - 1).rem_euclid(5) };
            let Some(Value::Number(found)) = track.at(clock.rate.time(frame)) else { panic!() };
            assert!((found - f64::from(wanted)).abs() < 1e-6, "{frame}: {found} for {wanted}");
        }
    }

    #[test]
    fn handles_are_in_frames_and_turn_with_their_quaternion() {
        let clock = FrameClock { first: 1, last: 20, rate: FrameRate::FILM, shading_step: 1 };
        let mut changed = changed(&[(0.0, 0.0), (24.0, 0.0)], 1);
        changed.keys[0].value = Value::Vector(vec![0.0, 0.0, 0.0, 1.0]);
        changed.keys[1].value = Value::Vector(vec![0.0, -1.0, 0.0, -0.1]);
        changed.keys[1].incoming = vec![[-12.0, 0.5]];
        let keys = timed_keys(clock, &changed, BlendKind::Rotation, &|_| Ok(())).ok().unwrap();
        assert_eq!(keys.keys[1].value, Value::Vector(vec![0.0, 1.0, 0.0, 0.1]));
        assert_eq!(keys.keys[1].incoming, vec![[-0.5, -0.5]]);
    }

    #[test]
    fn keys_far_apart_take_no_memory_without_bound() {
        let clock = FrameClock { first: 1, last: 20, rate: FrameRate::FILM, shading_step: 1 };
        let changed = changed(&[(-9e7, 0.0), (9e7, 9.0)], 2);
        let keys = timed_keys(clock, &changed, BlendKind::Numbers, &|_| Ok(())).ok().unwrap();
        assert_eq!(of(clock, &keys).unwrap_err().code, "too-many");
    }
}
